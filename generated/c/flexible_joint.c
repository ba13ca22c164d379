/*
 * Flexible joint: a link in gravity, driven through a spring.
 * Generated from `flexible_joint.rig` (model 8bd255ae); edit the rig, not this file.
 *
 * Motor and link of one joint, between them a stiff spring with a little damping: the single-link arm of
 * Spong, "Modeling and control of elastic joint robots", J. Dyn. Syst. Meas. Control 109 (1987). Numbers of
 * a small harmonic-drive joint, seen from the link's side, chosen here: the paper keeps symbols.
 *
 * 38 operations forward, 74 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "flexible_joint.h"

#include <math.h>

void flexible_joint_nominal(struct flexible_joint_parameters *p)
{
    p->m = 1.2;
    p->l = 0.35;
    p->J = 0.08;
    p->k = 45.0;
    p->k_3 = 120.0;
    p->c_k = 0.05;
    p->c_m = 0.4;
    p->g = 9.81;
}

void flexible_joint_mass_matrix(const struct flexible_joint_coordinates *q, const struct flexible_joint_parameters *p, double m[2][2])
{
    (void)q;
    const double I_l = p->m * p->l * p->l / 12.0;
    const double l_per_two = p->l / 2.0;
    /* body rod on arm */
    const double I_arm_xx = I_l + p->m * l_per_two * l_per_two;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            m[i][j] = 0.0;
        }
    }
    m[0][0] = p->J; /* motor */
    m[1][1] = I_arm_xx; /* link */
}

void flexible_joint_bias(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_rates *v,
    const struct flexible_joint_parameters *p,
    double h[2])
{
    (void)v;
    const double s_link = sin(q->link);
    const double motor_minus_link = q->motor - q->link;
    const double half_k = 0.5 * p->k;
    const double quarter_k_3 = 0.25 * p->k_3;
    const double two_motor_minus_link = 2.0 * motor_minus_link;
    const double two_motor_minus_link_sq = 2.0 * motor_minus_link * motor_minus_link;
    /* spring coil */
    const double coil_1 = quarter_k_3 * two_motor_minus_link * two_motor_minus_link_sq;
    const double two_motor_minus_link_2 = 2.0 * motor_minus_link;
    const double coil_2 = quarter_k_3 * two_motor_minus_link_sq * two_motor_minus_link_2;
    /* frame arm on ground */
    const double n_weight_arm_y = -p->m * p->l * p->g * s_link / 2.0;
    /* kinetic energy rotor */
    const double h_link = -half_k * two_motor_minus_link_2 - coil_2 - n_weight_arm_y;
    h[0] = half_k * two_motor_minus_link + coil_1; /* motor */
    h[1] = h_link; /* link */
}

void flexible_joint_velocity_products(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_rates *v,
    const struct flexible_joint_parameters *p,
    double c[2])
{
    (void)q;
    (void)v;
    (void)p;
    c[0] = 0.0; /* motor */
    c[1] = 0.0; /* link */
}

void flexible_joint_gravity(const struct flexible_joint_coordinates *q, const struct flexible_joint_parameters *p, double g[2])
{
    const double s_link = sin(q->link);
    const double g_link = p->m * p->l * p->g * s_link / 2.0;
    g[0] = 0.0; /* motor */
    g[1] = g_link; /* link */
}

void flexible_joint_dissipation(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_rates *v,
    const struct flexible_joint_parameters *p,
    double d[2])
{
    (void)q;
    /* friction of within */
    const double d_link = -p->c_k * (v->motor - v->link);
    d[0] = p->c_m * v->motor - d_link; /* motor */
    d[1] = d_link; /* link */
}

void flexible_joint_generalized_force(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    double f[2])
{
    (void)q;
    (void)p;
    f[0] = u->tau; /* motor */
    f[1] = 0.0; /* link */
}

void flexible_joint_input_map(const struct flexible_joint_coordinates *q, const struct flexible_joint_parameters *p, double s[2][1])
{
    (void)q;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 1; j++) {
            s[i][j] = 0.0;
        }
    }
    s[0][0] = 1.0; /* motor */
}

double flexible_joint_kinetic_energy(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_rates *v,
    const struct flexible_joint_parameters *p)
{
    (void)q;
    const double I_l = p->m * p->l * p->l / 12.0;
    const double l_per_two_link_dot = p->l * v->link / 2.0;
    /* body rod on arm */
    const double rod_1 = 0.5 * (p->m * l_per_two_link_dot * l_per_two_link_dot + I_l * v->link * v->link);
    return 0.5 * p->J * v->motor * v->motor + rod_1;
}

double flexible_joint_potential_energy(const struct flexible_joint_coordinates *q, const struct flexible_joint_parameters *p)
{
    const double c_link = cos(q->link);
    const double motor_minus_link = q->motor - q->link;
    const double motor_minus_link_sq = motor_minus_link * motor_minus_link;
    /* spring coil */
    const double coil_1 = 0.5 * p->k * motor_minus_link_sq + 0.25 * p->k_3 * motor_minus_link_sq * motor_minus_link_sq;
    return coil_1 - p->m * p->l * p->g * c_link / 2.0;
}

void flexible_joint_inverse_dynamics(
    const struct flexible_joint_state *x,
    const struct flexible_joint_accelerations *a,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    double r[2])
{
    const struct flexible_joint_coordinates *q = &x->q;
    const struct flexible_joint_rates *v = &x->v;
    const double s_link = sin(q->link);
    const double I_l = p->m * p->l * p->l / 12.0;
    const double motor_minus_link = q->motor - q->link;
    /* friction of within */
    const double d_link = -p->c_k * (v->motor - v->link);
    const double half_k = 0.5 * p->k;
    const double quarter_k_3 = 0.25 * p->k_3;
    const double two_motor_minus_link = 2.0 * motor_minus_link;
    const double two_motor_minus_link_sq = 2.0 * motor_minus_link * motor_minus_link;
    /* spring coil */
    const double coil_1 = quarter_k_3 * two_motor_minus_link * two_motor_minus_link_sq;
    const double two_motor_minus_link_2 = 2.0 * motor_minus_link;
    const double coil_2 = quarter_k_3 * two_motor_minus_link_sq * two_motor_minus_link_2;
    const double l_per_two = p->l / 2.0;
    /* body rod on arm */
    const double mc_arm_z = -p->m * l_per_two;
    /* frame arm on ground */
    const double n_net_arm_y = p->g * mc_arm_z * s_link - a->link * (I_l - l_per_two * mc_arm_z);
    /* balance of forces */
    const double balance_1 = half_k * two_motor_minus_link + coil_1 + p->J * a->motor - u->tau;
    r[0] = p->c_m * v->motor - d_link + balance_1; /* motor */
    r[1] = d_link - half_k * two_motor_minus_link_2 - coil_2 - n_net_arm_y; /* link */
}

void flexible_joint_outputs(
    const struct flexible_joint_state *x,
    const struct flexible_joint_parameters *p,
    struct flexible_joint_outputs *y)
{
    const struct flexible_joint_coordinates *q = &x->q;
    (void)p;
    y->motor = q->motor;
    y->link = q->link;
}

void flexible_joint_pivots(const struct flexible_joint_state *x, const struct flexible_joint_parameters *p, double d[2])
{
    (void)x;
    const double I_l = p->m * p->l * p->l / 12.0;
    const double l_per_two = p->l / 2.0;
    /* body rod on arm */
    const double I_arm_xx = I_l + p->m * l_per_two * l_per_two;
    d[0] = p->J; /* motor */
    d[1] = I_arm_xx; /* link */
}

int flexible_joint_forward_dynamics(
    const struct flexible_joint_state *x,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    struct flexible_joint_accelerations *a)
{
    const struct flexible_joint_coordinates *q = &x->q;
    const struct flexible_joint_rates *v = &x->v;
    const double s_link = sin(q->link);
    const double I_l = p->m * p->l * p->l / 12.0;
    const double motor_minus_link = q->motor - q->link;
    /* friction of within */
    const double d_link = -p->c_k * (v->motor - v->link);
    const double half_k = 0.5 * p->k;
    const double quarter_k_3 = 0.25 * p->k_3;
    const double two_motor_minus_link = 2.0 * motor_minus_link;
    const double two_motor_minus_link_sq = 2.0 * motor_minus_link * motor_minus_link;
    /* spring coil */
    const double coil_1 = quarter_k_3 * two_motor_minus_link * two_motor_minus_link_sq;
    const double two_motor_minus_link_2 = 2.0 * motor_minus_link;
    const double coil_2 = quarter_k_3 * two_motor_minus_link_sq * two_motor_minus_link_2;
    const double coil_3 = half_k * two_motor_minus_link_2 + coil_2;
    const double l_per_two = p->l / 2.0;
    /* body rod on arm */
    const double mc_arm_z = -p->m * l_per_two;
    const double I_arm_xx = I_l - l_per_two * mc_arm_z;
    /* kinetic energy rotor */
    const double h_link = -coil_3 - p->g * mc_arm_z * s_link;
    /* balance of forces */
    const double tau_motor = d_link - p->c_m * v->motor - half_k * two_motor_minus_link - coil_1 + u->tau;
    /* M = L^T D L and back-substitution */
    const double link_ddot = (-d_link - h_link) / I_arm_xx;
    if (!(I_arm_xx > 0.0)) {
        return 2;
    }
    if (!(p->J > 0.0)) {
        return 1;
    }
    a->motor = tau_motor / p->J;
    a->link = link_ddot;
    return 0;
}

int flexible_joint_linearize(
    const struct flexible_joint_state *x,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][1])
{
    const struct flexible_joint_coordinates *q = &x->q;
    const struct flexible_joint_rates *v = &x->v;
    const double s_link = sin(q->link);
    const double c_link = cos(q->link);
    const double I_l = p->m * p->l * p->l / 12.0;
    const double motor_minus_link = q->motor - q->link;
    /* friction of within */
    const double d_link = -p->c_k * (v->motor - v->link);
    const double motor_minus_link_sq = motor_minus_link * motor_minus_link;
    const double half_k = 0.5 * p->k;
    const double quarter_k_3 = 0.25 * p->k_3;
    const double two_motor_minus_link = 2.0 * motor_minus_link;
    const double two_motor_minus_link_sq = 2.0 * motor_minus_link_sq;
    /* spring coil */
    const double coil_1 = quarter_k_3 * two_motor_minus_link * two_motor_minus_link_sq;
    const double two_motor_minus_link_2 = 2.0 * motor_minus_link;
    const double coil_2 = quarter_k_3 * two_motor_minus_link_sq * two_motor_minus_link_2;
    const double coil_3 = half_k * two_motor_minus_link_2 + coil_2;
    const double l_per_two = p->l / 2.0;
    /* body rod on arm */
    const double mc_arm_z = -p->m * l_per_two;
    const double I_arm_xx = I_l - l_per_two * mc_arm_z;
    /* kinetic energy rotor */
    const double h_link = -coil_3 - p->g * mc_arm_z * s_link;
    /* balance of forces */
    const double tau_motor = d_link - p->c_m * v->motor - half_k * two_motor_minus_link - coil_1 + u->tau;
    /* M = L^T D L and back-substitution */
    const double inv_link = 1.0 / I_arm_xx;
    const double inv_motor = 1.0 / p->J;
    const double four_motor_minus_link = 4.0 * motor_minus_link;
    const double four_motor_minus_link_sq = 4.0 * motor_minus_link_sq;
    /* derivatives with respect to motor */
    const double by_motor_1 = p->k + quarter_k_3 * (four_motor_minus_link_sq + two_motor_minus_link * four_motor_minus_link);
    const double four_motor_minus_link_sq_2 = 4.0 * motor_minus_link_sq;
    const double by_motor_2 = p->k - quarter_k_3 * (-two_motor_minus_link_2 * four_motor_minus_link - four_motor_minus_link_sq_2);
    const double four_motor_minus_link_2 = 4.0 * motor_minus_link;
    /* derivatives with respect to link */
    const double by_link_1 = p->k + quarter_k_3 * (four_motor_minus_link_sq + two_motor_minus_link_2 * four_motor_minus_link_2);
    const double by_link_2 = p->k - quarter_k_3 * (-four_motor_minus_link_sq_2 - two_motor_minus_link * four_motor_minus_link_2);
    const double d_link_ddot_by_link = -inv_link * (by_link_1 - p->g * mc_arm_z * c_link);
    /* derivatives with respect to motor_dot */
    const double d_link_ddot_by_motor_dot = p->c_k * inv_link;
    if (!(I_arm_xx > 0.0)) {
        return 2;
    }
    if (!(p->J > 0.0)) {
        return 1;
    }
    dx[0] = v->motor; /* motor' */
    dx[1] = v->link; /* link' */
    dx[2] = tau_motor * inv_motor; /* motor'' */
    dx[3] = inv_link * (-d_link - h_link); /* link'' */
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][2] = 1.0; /* motor' */
    a[1][3] = 1.0; /* link' */
    a[2][0] = -inv_motor * by_motor_1; /* motor'' */
    a[2][1] = inv_motor * by_link_2;
    a[2][2] = -inv_motor * (p->c_k + p->c_m);
    a[2][3] = p->c_k * inv_motor;
    a[3][0] = inv_link * by_motor_2; /* link'' */
    a[3][1] = d_link_ddot_by_link;
    a[3][2] = d_link_ddot_by_motor_dot;
    a[3][3] = -d_link_ddot_by_motor_dot;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 1; j++) {
            b[i][j] = 0.0;
        }
    }
    b[2][0] = inv_motor; /* motor'' */
    return 0;
}

int flexible_joint_parameter_jacobian(
    const struct flexible_joint_state *x,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    double by_p[4][8])
{
    const struct flexible_joint_coordinates *q = &x->q;
    const struct flexible_joint_rates *v = &x->v;
    const double s_link = sin(q->link);
    const double l_sq = p->l * p->l;
    const double motor_minus_link = q->motor - q->link;
    const double motor_dot_minus_link_dot = v->motor - v->link;
    /* friction of within */
    const double d_link = -p->c_k * motor_dot_minus_link_dot;
    const double half_k = 0.5 * p->k;
    const double quarter_k_3 = 0.25 * p->k_3;
    const double two_motor_minus_link = 2.0 * motor_minus_link;
    const double two_motor_minus_link_sq = 2.0 * motor_minus_link * motor_minus_link;
    /* spring coil */
    const double coil_1 = two_motor_minus_link * two_motor_minus_link_sq;
    const double h_motor = half_k * two_motor_minus_link + quarter_k_3 * coil_1;
    const double two_motor_minus_link_2 = 2.0 * motor_minus_link;
    const double coil_2 = two_motor_minus_link_sq * two_motor_minus_link_2;
    const double coil_3 = half_k * two_motor_minus_link_2 + quarter_k_3 * coil_2;
    const double l_per_two = p->l / 2.0;
    /* body rod on arm */
    const double mc_arm_z = -p->m * l_per_two;
    const double I_arm_xx = p->m * l_sq / 12.0 - l_per_two * mc_arm_z;
    /* frame arm on ground */
    const double a_arm_x = p->g * s_link;
    /* balance of forces */
    const double tau_motor = d_link - p->c_m * v->motor - h_motor + u->tau;
    const double tau_link = coil_3 - d_link + mc_arm_z * a_arm_x;
    /* M = L^T D L and back-substitution */
    const double inv_link = 1.0 / I_arm_xx;
    const double inv_motor = 1.0 / p->J;
    const double link_ddot = tau_link * inv_link;
    const double half_m = 0.5 * p->m;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = link_ddot * (l_sq / 12.0 + l_per_two * l_per_two);
    const double slopes_2 = link_ddot * (2.0 * p->m * p->l / 12.0 - 0.5 * mc_arm_z + l_per_two * half_m);
    /* derivatives with respect to m */
    const double d_link_ddot_by_m = -inv_link * (l_per_two * a_arm_x + slopes_1);
    /* derivatives with respect to l */
    const double d_link_ddot_by_l = -inv_link * (a_arm_x * half_m + slopes_2);
    if (!(I_arm_xx > 0.0)) {
        return 2;
    }
    if (!(p->J > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 8; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[2][2] = -inv_motor * tau_motor * inv_motor; /* motor'' */
    by_p[2][3] = inv_motor * (q->link - q->motor);
    by_p[2][4] = -0.25 * inv_motor * coil_1;
    by_p[2][5] = inv_motor * (v->link - v->motor);
    by_p[2][6] = -inv_motor * v->motor;
    by_p[3][0] = d_link_ddot_by_m; /* link'' */
    by_p[3][1] = d_link_ddot_by_l;
    by_p[3][3] = motor_minus_link * inv_link;
    by_p[3][4] = 0.25 * inv_link * coil_2;
    by_p[3][5] = motor_dot_minus_link_dot * inv_link;
    by_p[3][7] = mc_arm_z * inv_link * s_link;
    return 0;
}

void flexible_joint_output_jacobian(
    const struct flexible_joint_state *x,
    const struct flexible_joint_parameters *p,
    double by_x[2][4],
    double by_p[2][8])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 4; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* motor */
    by_x[1][1] = 1.0; /* link */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 8; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

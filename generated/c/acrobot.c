/*
 * Acrobot.
 * Generated from `acrobot.rig` (model 993e11c5); edit the rig, not this file.
 *
 * Two links with a motor at the elbow only: the acrobot of the dm_control suite (suite/acrobot.xml,
 * Tassa et al. 2018, arXiv 1801.00690). Links are capsules of 1 kg and 1 m; both angles are 0 with the
 * arm standing upright, elbow relative to the upper arm.
 *
 * 61 operations forward, 146 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "acrobot.h"

#include <math.h>

void acrobot_nominal(struct acrobot_parameters *p)
{
    p->m_1 = 1.0;
    p->m_2 = 1.0;
    p->l_1 = 1.0;
    p->l_c1 = 0.5;
    p->l_c2 = 0.5;
    p->I_1 = 0.0955703125;
    p->J_1 = 0.001234375;
    p->I_2 = 0.09530365719649561;
    p->J_2 = 0.0011857754693366711;
    p->c_1 = 0.05;
    p->c_2 = 0.05;
    p->g = 9.81;
}

void acrobot_mass_matrix(const struct acrobot_coordinates *q, const struct acrobot_parameters *p, double m[2][2])
{
    const double c_elbow = cos(q->elbow);
    /* body upper_arm on upper */
    const double I_upper_xx = p->I_1 + p->m_1 * p->l_c1 * p->l_c1;
    /* body lower_arm on lower */
    const double mc_lower_z = p->m_2 * p->l_c2;
    const double I_lower_xx = p->I_2 + p->l_c2 * mc_lower_z;
    const double mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    /* frame lower on upper */
    const double M_shoulder_elbow = I_lower_xx + p->l_1 * mc_lower_z_c_elbow;
    /* frame upper on ground */
    const double M_shoulder_shoulder = I_upper_xx + I_lower_xx + p->l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p->m_2 * p->l_1);
    m[0][0] = M_shoulder_shoulder; /* shoulder */
    m[0][1] = M_shoulder_elbow;
    m[1][0] = M_shoulder_elbow; /* elbow */
    m[1][1] = I_lower_xx;
}

void acrobot_bias(const struct acrobot_coordinates *q, const struct acrobot_rates *v, const struct acrobot_parameters *p, double h[2])
{
    const double s_shoulder = sin(q->shoulder);
    const double c_shoulder = cos(q->shoulder);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    /* body lower_arm on lower */
    const double mc_lower_z = p->m_2 * p->l_c2;
    /* frame lower on upper */
    const double omega_lower_y = v->shoulder + v->elbow;
    /* frame upper on ground */
    const double a_upper_x = -p->g * s_shoulder;
    /* frame lower on upper */
    const double a_lower_1_z = p->g * c_shoulder - p->l_1 * v->shoulder * v->shoulder;
    const double a_lower_z = a_lower_1_z * c_elbow + a_upper_x * s_elbow;
    const double a_lower_x = a_upper_x * c_elbow - a_lower_1_z * s_elbow;
    const double f_lower_z = p->m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    const double n_lower_y = mc_lower_z * a_lower_x;
    const double f_lower_1_x = f_lower_z * s_elbow + p->m_2 * a_lower_x * c_elbow;
    /* frame upper on ground */
    const double n_upper_y = p->l_1 * f_lower_1_x + n_lower_y + p->m_1 * p->l_c1 * a_upper_x;
    h[0] = n_upper_y; /* shoulder */
    h[1] = n_lower_y; /* elbow */
}

void acrobot_velocity_products(
    const struct acrobot_coordinates *q,
    const struct acrobot_rates *v,
    const struct acrobot_parameters *p,
    double c[2])
{
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    /* body lower_arm on lower */
    const double mc_lower_z = p->m_2 * p->l_c2;
    /* frame lower on upper */
    const double omega_lower_y = v->shoulder + v->elbow;
    const double a_lower_1_z = -p->l_1 * v->shoulder * v->shoulder;
    const double a_lower_x = -a_lower_1_z * s_elbow;
    const double f_moving_lower_z = p->m_2 * a_lower_1_z * c_elbow - mc_lower_z * omega_lower_y * omega_lower_y;
    const double n_moving_lower_y = mc_lower_z * a_lower_x;
    const double f_moving_lower_1_x = p->m_2 * a_lower_x * c_elbow + f_moving_lower_z * s_elbow;
    c[0] = n_moving_lower_y + p->l_1 * f_moving_lower_1_x; /* shoulder */
    c[1] = n_moving_lower_y; /* elbow */
}

void acrobot_gravity(const struct acrobot_coordinates *q, const struct acrobot_parameters *p, double g[2])
{
    const double s_shoulder = sin(q->shoulder);
    const double c_shoulder = cos(q->shoulder);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_c2_c_elbow = p->l_c2 * c_elbow;
    const double l_c2_c_shoulder_s_elbow = p->l_c2 * c_shoulder * s_elbow;
    const double gravity_1 = p->m_2 * p->g * (s_shoulder * (p->l_1 + l_c2_c_elbow) + l_c2_c_shoulder_s_elbow);
    const double g_shoulder = -p->m_1 * p->l_c1 * p->g * s_shoulder - gravity_1;
    const double g_elbow = -p->m_2 * p->g * (l_c2_c_shoulder_s_elbow + l_c2_c_elbow * s_shoulder);
    g[0] = g_shoulder; /* shoulder */
    g[1] = g_elbow; /* elbow */
}

void acrobot_dissipation(
    const struct acrobot_coordinates *q,
    const struct acrobot_rates *v,
    const struct acrobot_parameters *p,
    double d[2])
{
    (void)q;
    d[0] = p->c_1 * v->shoulder; /* shoulder */
    d[1] = p->c_2 * v->elbow; /* elbow */
}

void acrobot_generalized_force(
    const struct acrobot_coordinates *q,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    double f[2])
{
    (void)q;
    (void)p;
    f[0] = 0.0; /* shoulder */
    f[1] = u->tau; /* elbow */
}

void acrobot_input_map(const struct acrobot_coordinates *q, const struct acrobot_parameters *p, double s[2][1])
{
    (void)q;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 1; j++) {
            s[i][j] = 0.0;
        }
    }
    s[1][0] = 1.0; /* elbow */
}

double acrobot_kinetic_energy(const struct acrobot_coordinates *q, const struct acrobot_rates *v, const struct acrobot_parameters *p)
{
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    /* frame lower on upper */
    const double omega_lower_y = v->shoulder + v->elbow;
    const double l_1_shoulder_dot = p->l_1 * v->shoulder;
    const double l_1_shoulder_dot_s_elbow = l_1_shoulder_dot * s_elbow;
    const double l_c1_shoulder_dot = p->l_c1 * v->shoulder;
    /* body upper_arm on upper */
    const double upper_arm_1 = 0.5 * (p->m_1 * l_c1_shoulder_dot * l_c1_shoulder_dot + p->I_1 * v->shoulder * v->shoulder);
    /* body lower_arm on lower */
    const double lower_arm_1 = l_1_shoulder_dot * c_elbow + p->l_c2 * omega_lower_y;
    const double lower_arm_2 = p->m_2 * (lower_arm_1 * lower_arm_1 + l_1_shoulder_dot_s_elbow * l_1_shoulder_dot_s_elbow);
    return upper_arm_1 + 0.5 * (lower_arm_2 + p->I_2 * omega_lower_y * omega_lower_y);
}

double acrobot_potential_energy(const struct acrobot_coordinates *q, const struct acrobot_parameters *p)
{
    const double s_shoulder = sin(q->shoulder);
    const double c_shoulder = cos(q->shoulder);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    /* body lower_arm on lower */
    const double lower_arm_1 = c_shoulder * (p->l_1 + p->l_c2 * c_elbow);
    const double lower_arm_2 = p->m_2 * p->g * (lower_arm_1 - p->l_c2 * s_shoulder * s_elbow);
    return p->m_1 * p->l_c1 * p->g * c_shoulder + lower_arm_2;
}

void acrobot_inverse_dynamics(
    const struct acrobot_state *x,
    const struct acrobot_accelerations *a,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    double r[2])
{
    const struct acrobot_coordinates *q = &x->q;
    const struct acrobot_rates *v = &x->v;
    const double s_shoulder = sin(q->shoulder);
    const double c_shoulder = cos(q->shoulder);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    /* body upper_arm on upper */
    const double mc_upper_z = p->m_1 * p->l_c1;
    /* body lower_arm on lower */
    const double mc_lower_z = p->m_2 * p->l_c2;
    /* frame lower on upper */
    const double omega_lower_y = v->shoulder + v->elbow;
    /* frame upper on ground */
    const double a_upper_x = -p->g * s_shoulder;
    const double upper_1 = a->shoulder * (p->I_1 + p->l_c1 * mc_upper_z) + mc_upper_z * a_upper_x;
    /* frame lower on upper */
    const double a_lower_1_z = p->g * c_shoulder - p->l_1 * v->shoulder * v->shoulder;
    const double a_lower_1_x = p->l_1 * a->shoulder + a_upper_x;
    /* gravity */
    const double alpha_lower_y = a->shoulder + a->elbow;
    /* frame lower on upper */
    const double a_lower_z = a_lower_1_z * c_elbow + a_lower_1_x * s_elbow;
    const double a_lower_x = a_lower_1_x * c_elbow - a_lower_1_z * s_elbow;
    const double f_net_lower_x = p->m_2 * a_lower_x + mc_lower_z * alpha_lower_y;
    const double f_net_lower_z = p->m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    const double n_net_lower_y = alpha_lower_y * (p->I_2 + p->l_c2 * mc_lower_z) + mc_lower_z * a_lower_x;
    const double f_net_lower_1_x = f_net_lower_z * s_elbow + f_net_lower_x * c_elbow;
    /* frame upper on ground */
    const double n_net_upper_y = upper_1 + n_net_lower_y + p->l_1 * f_net_lower_1_x;
    r[0] = p->c_1 * v->shoulder + n_net_upper_y; /* shoulder */
    r[1] = p->c_2 * v->elbow + n_net_lower_y - u->tau; /* elbow */
}

void acrobot_outputs(const struct acrobot_state *x, const struct acrobot_parameters *p, struct acrobot_outputs *y)
{
    const struct acrobot_coordinates *q = &x->q;
    (void)p;
    y->shoulder = q->shoulder;
    y->elbow = q->elbow;
}

void acrobot_pivots(const struct acrobot_state *x, const struct acrobot_parameters *p, double d[2])
{
    const struct acrobot_coordinates *q = &x->q;
    const double c_elbow = cos(q->elbow);
    /* body upper_arm on upper */
    const double I_upper_xx = p->I_1 + p->m_1 * p->l_c1 * p->l_c1;
    /* body lower_arm on lower */
    const double mc_lower_z = p->m_2 * p->l_c2;
    const double I_lower_xx = p->I_2 + p->l_c2 * mc_lower_z;
    const double mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    /* frame lower on upper */
    const double M_shoulder_elbow = I_lower_xx + p->l_1 * mc_lower_z_c_elbow;
    /* frame upper on ground */
    const double M_shoulder_shoulder = I_upper_xx + I_lower_xx + p->l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p->m_2 * p->l_1);
    /* M = L^T D L and back-substitution */
    const double pivot_shoulder = M_shoulder_shoulder - M_shoulder_elbow * M_shoulder_elbow / I_lower_xx;
    d[0] = pivot_shoulder; /* shoulder */
    d[1] = I_lower_xx; /* elbow */
}

int acrobot_forward_dynamics(
    const struct acrobot_state *x,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    struct acrobot_accelerations *a)
{
    const struct acrobot_coordinates *q = &x->q;
    const struct acrobot_rates *v = &x->v;
    const double s_shoulder = sin(q->shoulder);
    const double c_shoulder = cos(q->shoulder);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    /* body upper_arm on upper */
    const double mc_upper_z = p->m_1 * p->l_c1;
    /* body lower_arm on lower */
    const double mc_lower_z = p->m_2 * p->l_c2;
    const double I_lower_xx = p->I_2 + p->l_c2 * mc_lower_z;
    /* frame lower on upper */
    const double omega_lower_y = v->shoulder + v->elbow;
    const double mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    const double M_shoulder_elbow = I_lower_xx + p->l_1 * mc_lower_z_c_elbow;
    /* frame upper on ground */
    const double a_upper_x = -p->g * s_shoulder;
    /* frame lower on upper */
    const double a_lower_1_z = p->g * c_shoulder - p->l_1 * v->shoulder * v->shoulder;
    const double lower_1_1 = I_lower_xx + p->l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p->m_2 * p->l_1);
    const double a_lower_z = a_lower_1_z * c_elbow + a_upper_x * s_elbow;
    const double a_lower_x = a_upper_x * c_elbow - a_lower_1_z * s_elbow;
    const double f_lower_z = p->m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    const double n_lower_y = mc_lower_z * a_lower_x;
    const double f_lower_1_x = f_lower_z * s_elbow + p->m_2 * a_lower_x * c_elbow;
    /* frame upper on ground */
    const double n_upper_y = p->l_1 * f_lower_1_x + n_lower_y + mc_upper_z * a_upper_x;
    const double M_shoulder_shoulder = p->I_1 + p->l_c1 * mc_upper_z + lower_1_1;
    /* balance of forces */
    const double tau_elbow = u->tau - n_lower_y - p->c_2 * v->elbow;
    /* M = L^T D L and back-substitution */
    const double inv_elbow = 1.0 / I_lower_xx;
    const double l_elbow_shoulder = M_shoulder_elbow * inv_elbow;
    const double pivot_shoulder = M_shoulder_shoulder - M_shoulder_elbow * l_elbow_shoulder;
    const double shoulder_ddot = -(p->c_1 * v->shoulder + n_upper_y + tau_elbow * l_elbow_shoulder) / pivot_shoulder;
    const double elbow_ddot = tau_elbow * inv_elbow - l_elbow_shoulder * shoulder_ddot;
    if (!(I_lower_xx > 0.0)) {
        return 2;
    }
    if (!(pivot_shoulder > 0.0)) {
        return 1;
    }
    a->shoulder = shoulder_ddot;
    a->elbow = elbow_ddot;
    return 0;
}

int acrobot_linearize(
    const struct acrobot_state *x,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][1])
{
    const struct acrobot_coordinates *q = &x->q;
    const struct acrobot_rates *v = &x->v;
    const double s_shoulder = sin(q->shoulder);
    const double c_shoulder = cos(q->shoulder);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    /* body upper_arm on upper */
    const double mc_upper_z = p->m_1 * p->l_c1;
    /* body lower_arm on lower */
    const double mc_lower_z = p->m_2 * p->l_c2;
    const double I_lower_xx = p->I_2 + p->l_c2 * mc_lower_z;
    /* frame lower on upper */
    const double omega_lower_y = v->shoulder + v->elbow;
    const double mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y * omega_lower_y;
    const double mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    const double M_shoulder_elbow = I_lower_xx + p->l_1 * mc_lower_z_c_elbow;
    /* frame upper on ground */
    const double a_upper_z = p->g * c_shoulder;
    const double a_upper_x = -p->g * s_shoulder;
    const double a_upper_x_s_elbow = a_upper_x * s_elbow;
    const double a_upper_x_c_elbow = a_upper_x * c_elbow;
    /* frame lower on upper */
    const double f_weight_lower_x = -p->m_2 * (a_upper_z * s_elbow - a_upper_x_c_elbow);
    const double a_lower_1_z = a_upper_z - p->l_1 * v->shoulder * v->shoulder;
    const double lower_1_1 = I_lower_xx + p->l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p->m_2 * p->l_1);
    const double a_lower_1_z_c_elbow = a_lower_1_z * c_elbow;
    const double a_lower_1_z_s_elbow = a_lower_1_z * s_elbow;
    const double a_lower_x = a_upper_x_c_elbow - a_lower_1_z_s_elbow;
    const double f_lower_z = p->m_2 * (a_lower_1_z_c_elbow + a_upper_x_s_elbow) - mc_lower_z_omega_lower_y_sq;
    const double n_lower_y = mc_lower_z * a_lower_x;
    const double f_lower_1_x = f_lower_z * s_elbow + p->m_2 * a_lower_x * c_elbow;
    /* frame upper on ground */
    const double n_upper_y = p->l_1 * f_lower_1_x + n_lower_y + mc_upper_z * a_upper_x;
    const double M_shoulder_shoulder = p->I_1 + p->l_c1 * mc_upper_z + lower_1_1;
    /* balance of forces */
    const double tau_elbow = u->tau - n_lower_y - p->c_2 * v->elbow;
    /* M = L^T D L and back-substitution */
    const double inv_elbow = 1.0 / I_lower_xx;
    const double l_elbow_shoulder = M_shoulder_elbow * inv_elbow;
    const double pivot_shoulder = M_shoulder_shoulder - M_shoulder_elbow * l_elbow_shoulder;
    const double inv_shoulder = 1.0 / pivot_shoulder;
    const double shoulder_ddot = -inv_shoulder * (p->c_1 * v->shoulder + n_upper_y + tau_elbow * l_elbow_shoulder);
    const double elbow_ddot = tau_elbow * inv_elbow - l_elbow_shoulder * shoulder_ddot;
    /* derivatives with respect to shoulder */
    const double by_shoulder_1 = a_upper_x_s_elbow + a_upper_z * c_elbow;
    const double mc_lower_z_by_shoulder_1 = mc_lower_z * by_shoulder_1;
    const double by_shoulder_2 = p->l_1 * (f_weight_lower_x * s_elbow - p->m_2 * by_shoulder_1 * c_elbow);
    const double by_shoulder_3 = mc_upper_z * a_upper_z + mc_lower_z_by_shoulder_1 - by_shoulder_2;
    const double d_shoulder_ddot_by_shoulder = inv_shoulder * (by_shoulder_3 - l_elbow_shoulder * mc_lower_z_by_shoulder_1);
    const double d_elbow_ddot_by_shoulder = inv_elbow * mc_lower_z_by_shoulder_1 - l_elbow_shoulder * d_shoulder_ddot_by_shoulder;
    const double two_l_1_shoulder_dot = 2.0 * p->l_1 * v->shoulder;
    const double two_mc_lower_z_omega_lower_y = 2.0 * mc_lower_z * omega_lower_y;
    const double two_l_1_shoulder_dot_s_elbow = two_l_1_shoulder_dot * s_elbow;
    /* derivatives with respect to shoulder_dot */
    const double by_shoulder_dot_1 = mc_lower_z * two_l_1_shoulder_dot_s_elbow;
    const double by_shoulder_dot_2 = s_elbow * (two_mc_lower_z_omega_lower_y + p->m_2 * two_l_1_shoulder_dot * c_elbow);
    const double by_shoulder_dot_3 = p->l_1 * (p->m_2 * two_l_1_shoulder_dot_s_elbow * c_elbow - by_shoulder_dot_2);
    const double by_shoulder_dot_4 = l_elbow_shoulder * by_shoulder_dot_1 - p->c_1 - by_shoulder_dot_1 - by_shoulder_dot_3;
    const double d_shoulder_ddot_by_shoulder_dot = inv_shoulder * by_shoulder_dot_4;
    const double d_elbow_ddot_by_shoulder_dot = -inv_elbow * by_shoulder_dot_1 - l_elbow_shoulder * d_shoulder_ddot_by_shoulder_dot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = a_upper_x + p->l_1 * shoulder_ddot;
    const double slopes_2 = a_lower_1_z_c_elbow + slopes_1 * s_elbow;
    const double slopes_3 = p->m_2 * (a_lower_1_z_s_elbow - slopes_1 * c_elbow);
    const double m_2_slopes_2 = p->m_2 * slopes_2;
    const double slopes_4 = c_elbow * (m_2_slopes_2 - mc_lower_z_omega_lower_y_sq);
    const double slopes_5 = s_elbow * (mc_lower_z * (elbow_ddot + shoulder_ddot) - slopes_3);
    const double mc_lower_z_slopes_2 = mc_lower_z * slopes_2;
    const double slopes_6 = slopes_5 + m_2_slopes_2 * c_elbow;
    const double slopes_7 = p->l_1 * (slopes_4 - slopes_3 * s_elbow - slopes_6);
    /* derivatives with respect to elbow */
    const double d_shoulder_ddot_by_elbow = inv_shoulder * (mc_lower_z_slopes_2 - slopes_7 - l_elbow_shoulder * mc_lower_z_slopes_2);
    const double d_elbow_ddot_by_elbow = inv_elbow * mc_lower_z_slopes_2 - l_elbow_shoulder * d_shoulder_ddot_by_elbow;
    /* derivatives with respect to elbow_dot */
    const double d_shoulder_ddot_by_elbow_dot = inv_shoulder
        * (p->l_1 * two_mc_lower_z_omega_lower_y * s_elbow + p->c_2 * l_elbow_shoulder);
    const double d_elbow_ddot_by_elbow_dot = -p->c_2 * inv_elbow - l_elbow_shoulder * d_shoulder_ddot_by_elbow_dot;
    /* derivatives with respect to tau */
    const double d_shoulder_ddot_by_tau = -l_elbow_shoulder * inv_shoulder;
    if (!(I_lower_xx > 0.0)) {
        return 2;
    }
    if (!(pivot_shoulder > 0.0)) {
        return 1;
    }
    dx[0] = v->shoulder; /* shoulder' */
    dx[1] = v->elbow; /* elbow' */
    dx[2] = shoulder_ddot; /* shoulder'' */
    dx[3] = elbow_ddot; /* elbow'' */
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][2] = 1.0; /* shoulder' */
    a[1][3] = 1.0; /* elbow' */
    a[2][0] = d_shoulder_ddot_by_shoulder; /* shoulder'' */
    a[2][1] = d_shoulder_ddot_by_elbow;
    a[2][2] = d_shoulder_ddot_by_shoulder_dot;
    a[2][3] = d_shoulder_ddot_by_elbow_dot;
    a[3][0] = d_elbow_ddot_by_shoulder; /* elbow'' */
    a[3][1] = d_elbow_ddot_by_elbow;
    a[3][2] = d_elbow_ddot_by_shoulder_dot;
    a[3][3] = d_elbow_ddot_by_elbow_dot;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 1; j++) {
            b[i][j] = 0.0;
        }
    }
    b[2][0] = d_shoulder_ddot_by_tau; /* shoulder'' */
    b[3][0] = inv_elbow - l_elbow_shoulder * d_shoulder_ddot_by_tau; /* elbow'' */
    return 0;
}

int acrobot_parameter_jacobian(
    const struct acrobot_state *x,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    double by_p[4][12])
{
    const struct acrobot_coordinates *q = &x->q;
    const struct acrobot_rates *v = &x->v;
    const double s_shoulder = sin(q->shoulder);
    const double c_shoulder = cos(q->shoulder);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    /* body upper_arm on upper */
    const double mc_upper_z = p->m_1 * p->l_c1;
    /* body lower_arm on lower */
    const double mc_lower_z = p->m_2 * p->l_c2;
    const double I_lower_xx = p->I_2 + p->l_c2 * mc_lower_z;
    /* frame lower on upper */
    const double omega_lower_y = v->shoulder + v->elbow;
    const double omega_lower_y_sq = omega_lower_y * omega_lower_y;
    const double mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y_sq;
    const double mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    const double M_shoulder_elbow = I_lower_xx + p->l_1 * mc_lower_z_c_elbow;
    const double shoulder_dot_sq = v->shoulder * v->shoulder;
    /* frame upper on ground */
    const double a_upper_x = -p->g * s_shoulder;
    /* frame lower on upper */
    const double a_lower_1_z = p->g * c_shoulder - p->l_1 * shoulder_dot_sq;
    const double lower_1_1 = I_lower_xx + p->l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p->m_2 * p->l_1);
    const double a_lower_1_z_c_elbow = a_lower_1_z * c_elbow;
    const double a_lower_1_z_s_elbow = a_lower_1_z * s_elbow;
    const double a_lower_x = a_upper_x * c_elbow - a_lower_1_z_s_elbow;
    const double f_lower_z = p->m_2 * (a_lower_1_z_c_elbow + a_upper_x * s_elbow) - mc_lower_z_omega_lower_y_sq;
    const double n_lower_y = mc_lower_z * a_lower_x;
    const double f_lower_1_x = f_lower_z * s_elbow + p->m_2 * a_lower_x * c_elbow;
    /* frame upper on ground */
    const double n_upper_y = p->l_1 * f_lower_1_x + n_lower_y + mc_upper_z * a_upper_x;
    const double M_shoulder_shoulder = p->I_1 + p->l_c1 * mc_upper_z + lower_1_1;
    /* balance of forces */
    const double tau_elbow = u->tau - n_lower_y - p->c_2 * v->elbow;
    /* M = L^T D L and back-substitution */
    const double inv_elbow = 1.0 / I_lower_xx;
    const double l_elbow_shoulder = M_shoulder_elbow * inv_elbow;
    const double pivot_shoulder = M_shoulder_shoulder - M_shoulder_elbow * l_elbow_shoulder;
    const double inv_shoulder = 1.0 / pivot_shoulder;
    const double shoulder_ddot = -inv_shoulder * (p->c_1 * v->shoulder + n_upper_y + tau_elbow * l_elbow_shoulder);
    const double elbow_ddot = tau_elbow * inv_elbow - l_elbow_shoulder * shoulder_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = elbow_ddot + shoulder_ddot;
    const double slopes_2 = a_upper_x + p->l_1 * shoulder_ddot;
    const double slopes_3 = a_lower_1_z_c_elbow + slopes_2 * s_elbow;
    const double slopes_4 = a_lower_1_z_s_elbow - slopes_2 * c_elbow;
    const double m_2_slopes_4 = p->m_2 * slopes_4;
    const double slopes_5 = c_elbow * (mc_lower_z * slopes_1 - m_2_slopes_4);
    const double slopes_6 = s_elbow * (p->m_2 * slopes_3 - mc_lower_z_omega_lower_y_sq) + slopes_5;
    const double slopes_1_l_c2_sq = p->l_c2 * p->l_c2 * slopes_1;
    const double l_c2_slopes_4 = p->l_c2 * slopes_4;
    const double slopes_7 = c_elbow * (p->l_c2 * slopes_1 - slopes_4);
    const double slopes_8 = s_elbow * (slopes_3 - p->l_c2 * omega_lower_y_sq) + slopes_7;
    const double slopes_9 = slopes_1_l_c2_sq - l_c2_slopes_4 + p->l_1 * slopes_8;
    const double slopes_10 = shoulder_dot_sq * s_elbow + shoulder_ddot * c_elbow;
    const double slopes_11 = p->m_2 * (shoulder_dot_sq * c_elbow - shoulder_ddot * s_elbow);
    const double mc_lower_z_slopes_10 = mc_lower_z * slopes_10;
    const double slopes_12 = p->m_2 * slopes_10 * c_elbow - slopes_11 * s_elbow;
    const double slopes_13 = mc_lower_z_slopes_10 + slopes_6 + p->l_1 * slopes_12;
    const double two_slopes_1_mc_lower_z = 2.0 * slopes_1 * mc_lower_z;
    const double m_2_omega_lower_y_sq_s_elbow = p->m_2 * omega_lower_y_sq * s_elbow;
    /* derivatives with respect to l_c2 */
    const double by_l_c2_1 = m_2_slopes_4 - two_slopes_1_mc_lower_z;
    /* derivatives with respect to g */
    const double by_g_1 = c_shoulder * s_elbow + s_shoulder * c_elbow;
    const double by_g_2 = p->m_2 * (c_shoulder * c_elbow - s_shoulder * s_elbow);
    const double mc_lower_z_by_g_1 = mc_lower_z * by_g_1;
    const double by_g_3 = by_g_2 * s_elbow - p->m_2 * by_g_1 * c_elbow;
    const double by_g_4 = mc_upper_z * s_shoulder - p->l_1 * by_g_3 + mc_lower_z_by_g_1;
    const double d_shoulder_ddot_by_g = inv_shoulder * (by_g_4 - l_elbow_shoulder * mc_lower_z_by_g_1);
    const double d_elbow_ddot_by_g = inv_elbow * mc_lower_z_by_g_1 - l_elbow_shoulder * d_shoulder_ddot_by_g;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_14 = p->l_1 * (p->m_2 * slopes_1 * c_elbow - m_2_omega_lower_y_sq_s_elbow);
    const double slopes_15 = two_slopes_1_mc_lower_z - m_2_slopes_4 + slopes_14;
    /* derivatives with respect to m_1 */
    const double d_shoulder_ddot_by_m_1 = inv_shoulder * (-p->l_c1 * a_upper_x - p->l_c1 * p->l_c1 * shoulder_ddot);
    /* derivatives with respect to m_2 */
    const double by_m_2_1 = l_c2_slopes_4 - slopes_1_l_c2_sq;
    const double d_shoulder_ddot_by_m_2 = -inv_shoulder * (slopes_9 + l_elbow_shoulder * by_m_2_1);
    const double d_elbow_ddot_by_m_2 = inv_elbow * by_m_2_1 - l_elbow_shoulder * d_shoulder_ddot_by_m_2;
    /* derivatives with respect to l_1 */
    const double d_shoulder_ddot_by_l_1 = inv_shoulder * (l_elbow_shoulder * mc_lower_z_slopes_10 - slopes_13);
    const double d_elbow_ddot_by_l_1 = -inv_elbow * mc_lower_z_slopes_10 - l_elbow_shoulder * d_shoulder_ddot_by_l_1;
    /* derivatives with respect to l_c1 */
    const double d_shoulder_ddot_by_l_c1 = inv_shoulder * (-p->m_1 * a_upper_x - 2.0 * shoulder_ddot * mc_upper_z);
    /* derivatives with respect to l_c2 */
    const double d_shoulder_ddot_by_l_c2 = -inv_shoulder * (slopes_15 + l_elbow_shoulder * by_l_c2_1);
    const double d_elbow_ddot_by_l_c2 = inv_elbow * by_l_c2_1 - l_elbow_shoulder * d_shoulder_ddot_by_l_c2;
    /* derivatives with respect to I_1 */
    const double d_shoulder_ddot_by_I_1 = -inv_shoulder * shoulder_ddot;
    /* derivatives with respect to I_2 */
    const double by_I_2_1 = shoulder_ddot + elbow_ddot;
    const double d_shoulder_ddot_by_I_2 = inv_shoulder * (l_elbow_shoulder * by_I_2_1 - by_I_2_1);
    const double d_elbow_ddot_by_I_2 = -inv_elbow * by_I_2_1 - l_elbow_shoulder * d_shoulder_ddot_by_I_2;
    /* derivatives with respect to c_1 */
    const double d_shoulder_ddot_by_c_1 = -inv_shoulder * v->shoulder;
    /* derivatives with respect to c_2 */
    const double d_shoulder_ddot_by_c_2 = inv_shoulder * l_elbow_shoulder * v->elbow;
    const double d_elbow_ddot_by_c_2 = -inv_elbow * v->elbow - l_elbow_shoulder * d_shoulder_ddot_by_c_2;
    if (!(I_lower_xx > 0.0)) {
        return 2;
    }
    if (!(pivot_shoulder > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 12; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[2][0] = d_shoulder_ddot_by_m_1; /* shoulder'' */
    by_p[2][1] = d_shoulder_ddot_by_m_2;
    by_p[2][2] = d_shoulder_ddot_by_l_1;
    by_p[2][3] = d_shoulder_ddot_by_l_c1;
    by_p[2][4] = d_shoulder_ddot_by_l_c2;
    by_p[2][5] = d_shoulder_ddot_by_I_1;
    by_p[2][7] = d_shoulder_ddot_by_I_2;
    by_p[2][9] = d_shoulder_ddot_by_c_1;
    by_p[2][10] = d_shoulder_ddot_by_c_2;
    by_p[2][11] = d_shoulder_ddot_by_g;
    by_p[3][0] = -l_elbow_shoulder * d_shoulder_ddot_by_m_1; /* elbow'' */
    by_p[3][1] = d_elbow_ddot_by_m_2;
    by_p[3][2] = d_elbow_ddot_by_l_1;
    by_p[3][3] = -l_elbow_shoulder * d_shoulder_ddot_by_l_c1;
    by_p[3][4] = d_elbow_ddot_by_l_c2;
    by_p[3][5] = -l_elbow_shoulder * d_shoulder_ddot_by_I_1;
    by_p[3][7] = d_elbow_ddot_by_I_2;
    by_p[3][9] = -l_elbow_shoulder * d_shoulder_ddot_by_c_1;
    by_p[3][10] = d_elbow_ddot_by_c_2;
    by_p[3][11] = d_elbow_ddot_by_g;
    return 0;
}

void acrobot_output_jacobian(const struct acrobot_state *x, const struct acrobot_parameters *p, double by_x[2][4], double by_p[2][12])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 4; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* shoulder */
    by_x[1][1] = 1.0; /* elbow */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 12; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

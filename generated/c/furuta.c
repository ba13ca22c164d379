/*
 * Furuta pendulum (QUBE-Servo 2).
 * Generated from `furuta.rig` (model 060d2e34); edit the rig, not this file.
 *
 * Uniform thin rods as in Quanser's QUBE-Servo 2 data sheet, motor rotor and hub on the arm's axis.
 * alpha = 0 hangs down; theta about the upright axis, alpha about the arm.
 *
 * 69 operations forward, 160 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "furuta.h"

#include <math.h>

void furuta_nominal(struct furuta_parameters *p)
{
    p->m_r = 0.095;
    p->r = 0.085;
    p->m_p = 0.024;
    p->L_p = 0.129;
    p->J_m = 4e-6;
    p->J_h = 6e-7;
    p->g = 9.81;
}

void furuta_mass_matrix(const struct furuta_coordinates *q, const struct furuta_parameters *p, double m[2][2])
{
    const double c_alpha = cos(q->alpha);
    const double J_r = p->m_r * p->r * p->r / 12.0;
    const double J_p = p->m_p * p->L_p * p->L_p / 12.0;
    const double r_per_two = p->r / 2.0;
    /* body arm_rod on arm */
    const double I_arm_yy = J_r + p->m_r * r_per_two * r_per_two;
    const double L_p_per_two = p->L_p / 2.0;
    /* body rod on pendulum */
    const double mc_pendulum_z = -p->m_p * L_p_per_two;
    const double I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    /* frame pendulum on arm */
    const double M_theta_alpha = -p->r * mc_pendulum_z * c_alpha;
    const double pendulum_1_1 = I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p->r * p->r * p->m_p;
    /* kinetic energy rotor */
    const double M_theta_theta = I_arm_yy + pendulum_1_1 + p->J_m + p->J_h;
    m[0][0] = M_theta_theta; /* theta */
    m[0][1] = M_theta_alpha;
    m[1][0] = M_theta_alpha; /* alpha */
    m[1][1] = I_pendulum_xx;
}

void furuta_bias(const struct furuta_coordinates *q, const struct furuta_rates *v, const struct furuta_parameters *p, double h[2])
{
    const double s_alpha = sin(q->alpha);
    const double c_alpha = cos(q->alpha);
    const double J_p = p->m_p * p->L_p * p->L_p / 12.0;
    const double L_p_per_two = p->L_p / 2.0;
    /* body rod on pendulum */
    const double mc_pendulum_z = -p->m_p * L_p_per_two;
    const double I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    /* frame pendulum on arm */
    const double omega_pendulum_y = s_alpha * v->theta;
    const double omega_pendulum_z = c_alpha * v->theta;
    const double pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    const double f_moving_pendulum_z = -mc_pendulum_z * (v->alpha * v->alpha + omega_pendulum_y * omega_pendulum_y);
    const double n_moving_pendulum_y = 2.0 * I_pendulum_xx * omega_pendulum_z * v->alpha - p->r * mc_pendulum_z * v->theta * v->theta;
    const double a_pendulum_y = p->g * s_alpha;
    const double f_pendulum_y = p->m_p * a_pendulum_y + mc_pendulum_z * pendulum_1;
    const double f_pendulum_z = f_moving_pendulum_z + p->m_p * p->g * c_alpha;
    const double n_pendulum_x = -mc_pendulum_z * a_pendulum_y - I_pendulum_xx * pendulum_1;
    const double f_pendulum_1_y = f_pendulum_y * c_alpha - f_pendulum_z * s_alpha;
    const double n_arm_z = n_moving_pendulum_y * s_alpha + p->r * f_pendulum_1_y;
    h[0] = n_arm_z; /* theta */
    h[1] = n_pendulum_x; /* alpha */
}

void furuta_velocity_products(
    const struct furuta_coordinates *q,
    const struct furuta_rates *v,
    const struct furuta_parameters *p,
    double c[2])
{
    const double s_alpha = sin(q->alpha);
    const double c_alpha = cos(q->alpha);
    const double J_p = p->m_p * p->L_p * p->L_p / 12.0;
    const double L_p_per_two = p->L_p / 2.0;
    /* body rod on pendulum */
    const double mc_pendulum_z = -p->m_p * L_p_per_two;
    const double I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    /* frame pendulum on arm */
    const double omega_pendulum_y = s_alpha * v->theta;
    const double omega_pendulum_z = c_alpha * v->theta;
    const double pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    const double f_moving_pendulum_z = -mc_pendulum_z * (v->alpha * v->alpha + omega_pendulum_y * omega_pendulum_y);
    const double n_moving_pendulum_y = 2.0 * I_pendulum_xx * omega_pendulum_z * v->alpha - p->r * mc_pendulum_z * v->theta * v->theta;
    const double f_moving_pendulum_1_y = mc_pendulum_z * pendulum_1 * c_alpha - f_moving_pendulum_z * s_alpha;
    const double n_moving_arm_z = n_moving_pendulum_y * s_alpha + p->r * f_moving_pendulum_1_y;
    c[0] = n_moving_arm_z; /* theta */
    c[1] = -I_pendulum_xx * pendulum_1; /* alpha */
}

void furuta_gravity(const struct furuta_coordinates *q, const struct furuta_parameters *p, double g[2])
{
    const double s_alpha = sin(q->alpha);
    const double g_alpha = p->m_p * p->L_p * p->g * s_alpha / 2.0;
    g[0] = 0.0; /* theta */
    g[1] = g_alpha; /* alpha */
}

void furuta_dissipation(const struct furuta_coordinates *q, const struct furuta_rates *v, const struct furuta_parameters *p, double d[2])
{
    (void)q;
    (void)v;
    (void)p;
    d[0] = 0.0; /* theta */
    d[1] = 0.0; /* alpha */
}

void furuta_generalized_force(
    const struct furuta_coordinates *q,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    double f[2])
{
    (void)q;
    (void)p;
    f[0] = u->tau; /* theta */
    f[1] = 0.0; /* alpha */
}

void furuta_input_map(const struct furuta_coordinates *q, const struct furuta_parameters *p, double s[2][1])
{
    (void)q;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 1; j++) {
            s[i][j] = 0.0;
        }
    }
    s[0][0] = 1.0; /* theta */
}

double furuta_kinetic_energy(const struct furuta_coordinates *q, const struct furuta_rates *v, const struct furuta_parameters *p)
{
    const double s_alpha = sin(q->alpha);
    const double c_alpha = cos(q->alpha);
    const double J_r = p->m_r * p->r * p->r / 12.0;
    const double J_p = p->m_p * p->L_p * p->L_p / 12.0;
    const double L_p_per_two = p->L_p / 2.0;
    /* frame pendulum on arm */
    const double omega_pendulum_y = s_alpha * v->theta;
    const double r_theta_dot = p->r * v->theta;
    const double r_theta_dot_s_alpha = r_theta_dot * s_alpha;
    const double r_per_two_theta_dot = p->r * v->theta / 2.0;
    /* body arm_rod on arm */
    const double arm_rod_1 = 0.5 * (p->m_r * r_per_two_theta_dot * r_per_two_theta_dot + J_r * v->theta * v->theta);
    const double L_p_per_two_omega_pendulum_y = L_p_per_two * omega_pendulum_y;
    /* body rod on pendulum */
    const double rod_1 = r_theta_dot * c_alpha + L_p_per_two * v->alpha;
    const double rod_2 = L_p_per_two_omega_pendulum_y * L_p_per_two_omega_pendulum_y + rod_1 * rod_1;
    const double rod_3 = p->m_p * (r_theta_dot_s_alpha * r_theta_dot_s_alpha + rod_2);
    const double rod_4 = 0.5 * (rod_3 + J_p * v->alpha * v->alpha + omega_pendulum_y * J_p * omega_pendulum_y);
    return 0.5 * v->theta * v->theta * (p->J_m + p->J_h) + arm_rod_1 + rod_4;
}

double furuta_potential_energy(const struct furuta_coordinates *q, const struct furuta_parameters *p)
{
    const double c_alpha = cos(q->alpha);
    return -p->m_p * p->L_p * p->g * c_alpha / 2.0;
}

void furuta_inverse_dynamics(
    const struct furuta_state *x,
    const struct furuta_accelerations *a,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    double r[2])
{
    const struct furuta_coordinates *q = &x->q;
    const struct furuta_rates *v = &x->v;
    const double s_alpha = sin(q->alpha);
    const double c_alpha = cos(q->alpha);
    const double J_r = p->m_r * p->r * p->r / 12.0;
    const double J_p = p->m_p * p->L_p * p->L_p / 12.0;
    const double r_per_two = p->r / 2.0;
    /* body arm_rod on arm */
    const double I_arm_yy = J_r + p->m_r * r_per_two * r_per_two;
    const double L_p_per_two = p->L_p / 2.0;
    /* body rod on pendulum */
    const double mc_pendulum_z = -p->m_p * L_p_per_two;
    const double I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    /* frame pendulum on arm */
    const double omega_pendulum_y = s_alpha * v->theta;
    const double omega_pendulum_z = c_alpha * v->theta;
    const double alpha_pendulum_y = omega_pendulum_z * v->alpha;
    const double pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    const double f_moving_pendulum_z = -mc_pendulum_z * (v->alpha * v->alpha + omega_pendulum_y * omega_pendulum_y);
    const double pendulum_2 = I_pendulum_xx * alpha_pendulum_y + I_pendulum_xx * (alpha_pendulum_y + s_alpha * a->theta);
    const double n_net_pendulum_y = pendulum_2 - p->r * mc_pendulum_z * v->theta * v->theta;
    /* gravity */
    const double a_pendulum_1_y = p->r * a->theta;
    /* frame pendulum on arm */
    const double a_pendulum_y = p->g * s_alpha + a_pendulum_1_y * c_alpha;
    const double a_pendulum_z = p->g * c_alpha - a_pendulum_1_y * s_alpha;
    const double f_net_pendulum_y = p->m_p * a_pendulum_y + mc_pendulum_z * (pendulum_1 - a->alpha);
    const double n_net_pendulum_x = I_pendulum_xx * a->alpha - mc_pendulum_z * a_pendulum_y - I_pendulum_xx * pendulum_1;
    const double pendulum_3 = s_alpha * (f_moving_pendulum_z + p->m_p * a_pendulum_z);
    const double pendulum_1_1 = p->r * (f_net_pendulum_y * c_alpha - pendulum_3);
    /* frame arm on ground */
    const double n_net_arm_z = I_arm_yy * a->theta + n_net_pendulum_y * s_alpha + pendulum_1_1;
    r[0] = n_net_arm_z - u->tau + a->theta * (p->J_m + p->J_h); /* theta */
    r[1] = n_net_pendulum_x; /* alpha */
}

void furuta_outputs(const struct furuta_state *x, const struct furuta_parameters *p, struct furuta_outputs *y)
{
    const struct furuta_coordinates *q = &x->q;
    (void)p;
    y->theta = q->theta;
    y->alpha = q->alpha;
}

void furuta_pivots(const struct furuta_state *x, const struct furuta_parameters *p, double d[2])
{
    const struct furuta_coordinates *q = &x->q;
    const double c_alpha = cos(q->alpha);
    const double J_r = p->m_r * p->r * p->r / 12.0;
    const double J_p = p->m_p * p->L_p * p->L_p / 12.0;
    const double r_per_two = p->r / 2.0;
    /* body arm_rod on arm */
    const double I_arm_yy = J_r + p->m_r * r_per_two * r_per_two;
    const double L_p_per_two = p->L_p / 2.0;
    /* body rod on pendulum */
    const double mc_pendulum_z = -p->m_p * L_p_per_two;
    const double I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    /* frame pendulum on arm */
    const double M_theta_alpha = -p->r * mc_pendulum_z * c_alpha;
    const double pendulum_1_1 = I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p->r * p->r * p->m_p;
    /* kinetic energy rotor */
    const double M_theta_theta = I_arm_yy + pendulum_1_1 + p->J_m + p->J_h;
    /* M = L^T D L and back-substitution */
    const double pivot_theta = M_theta_theta - M_theta_alpha * M_theta_alpha / I_pendulum_xx;
    d[0] = pivot_theta; /* theta */
    d[1] = I_pendulum_xx; /* alpha */
}

int furuta_forward_dynamics(
    const struct furuta_state *x,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    struct furuta_accelerations *a)
{
    const struct furuta_coordinates *q = &x->q;
    const struct furuta_rates *v = &x->v;
    const double s_alpha = sin(q->alpha);
    const double c_alpha = cos(q->alpha);
    const double J_r = p->m_r * p->r * p->r / 12.0;
    const double J_p = p->m_p * p->L_p * p->L_p / 12.0;
    const double r_per_two = p->r / 2.0;
    /* body arm_rod on arm */
    const double I_arm_yy = J_r + p->m_r * r_per_two * r_per_two;
    const double L_p_per_two = p->L_p / 2.0;
    /* body rod on pendulum */
    const double mc_pendulum_z = -p->m_p * L_p_per_two;
    const double I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    /* frame pendulum on arm */
    const double omega_pendulum_y = s_alpha * v->theta;
    const double omega_pendulum_z = c_alpha * v->theta;
    const double pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    const double f_moving_pendulum_z = -mc_pendulum_z * (v->alpha * v->alpha + omega_pendulum_y * omega_pendulum_y);
    const double n_moving_pendulum_y = 2.0 * I_pendulum_xx * omega_pendulum_z * v->alpha - p->r * mc_pendulum_z * v->theta * v->theta;
    const double a_pendulum_y = p->g * s_alpha;
    const double f_pendulum_y = p->m_p * a_pendulum_y + mc_pendulum_z * pendulum_1;
    const double f_pendulum_z = f_moving_pendulum_z + p->m_p * p->g * c_alpha;
    const double f_pendulum_1_y = f_pendulum_y * c_alpha - f_pendulum_z * s_alpha;
    const double M_theta_alpha = -p->r * mc_pendulum_z * c_alpha;
    const double n_arm_z = n_moving_pendulum_y * s_alpha + p->r * f_pendulum_1_y;
    const double pendulum_1_1 = I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p->r * p->r * p->m_p;
    /* kinetic energy rotor */
    const double M_theta_theta = I_arm_yy + pendulum_1_1 + p->J_m + p->J_h;
    /* balance of forces */
    const double tau_alpha = I_pendulum_xx * pendulum_1 + mc_pendulum_z * a_pendulum_y;
    /* M = L^T D L and back-substitution */
    const double inv_alpha = 1.0 / I_pendulum_xx;
    const double l_alpha_theta = M_theta_alpha * inv_alpha;
    const double pivot_theta = M_theta_theta - M_theta_alpha * l_alpha_theta;
    const double theta_ddot = (u->tau - n_arm_z - tau_alpha * l_alpha_theta) / pivot_theta;
    const double alpha_ddot = tau_alpha * inv_alpha - l_alpha_theta * theta_ddot;
    if (!(I_pendulum_xx > 0.0)) {
        return 2;
    }
    if (!(pivot_theta > 0.0)) {
        return 1;
    }
    a->theta = theta_ddot;
    a->alpha = alpha_ddot;
    return 0;
}

int furuta_linearize(
    const struct furuta_state *x,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][1])
{
    const struct furuta_coordinates *q = &x->q;
    const struct furuta_rates *v = &x->v;
    const double s_alpha = sin(q->alpha);
    const double c_alpha = cos(q->alpha);
    const double J_r = p->m_r * p->r * p->r / 12.0;
    const double J_p = p->m_p * p->L_p * p->L_p / 12.0;
    const double r_per_two = p->r / 2.0;
    /* body arm_rod on arm */
    const double I_arm_yy = J_r + p->m_r * r_per_two * r_per_two;
    const double L_p_per_two = p->L_p / 2.0;
    /* body rod on pendulum */
    const double mc_pendulum_z = -p->m_p * L_p_per_two;
    const double I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    /* frame pendulum on arm */
    const double omega_pendulum_y = s_alpha * v->theta;
    const double omega_pendulum_z = c_alpha * v->theta;
    const double alpha_pendulum_y = omega_pendulum_z * v->alpha;
    const double alpha_pendulum_z = -omega_pendulum_y * v->alpha;
    const double pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    const double omega_pendulum_y_sq = omega_pendulum_y * omega_pendulum_y;
    const double f_moving_pendulum_z = -mc_pendulum_z * (v->alpha * v->alpha + omega_pendulum_y_sq);
    const double pendulum_2 = I_pendulum_xx * alpha_pendulum_y;
    const double r_mc_pendulum_z_theta_dot_sq = p->r * mc_pendulum_z * v->theta * v->theta;
    const double n_moving_pendulum_1_z = s_alpha * (2.0 * pendulum_2 - r_mc_pendulum_z_theta_dot_sq);
    const double a_pendulum_y = p->g * s_alpha;
    const double a_pendulum_z = p->g * c_alpha;
    const double f_pendulum_y = p->m_p * a_pendulum_y + mc_pendulum_z * pendulum_1;
    const double f_pendulum_1_y = f_pendulum_y * c_alpha - s_alpha * (f_moving_pendulum_z + p->m_p * a_pendulum_z);
    const double M_theta_alpha = -p->r * mc_pendulum_z * c_alpha;
    const double pendulum_1_1 = I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p->r * p->r * p->m_p;
    /* kinetic energy rotor */
    const double M_theta_theta = I_arm_yy + pendulum_1_1 + p->J_m + p->J_h;
    /* balance of forces */
    const double tau_theta = u->tau - n_moving_pendulum_1_z - p->r * f_pendulum_1_y;
    const double tau_alpha = I_pendulum_xx * pendulum_1 + mc_pendulum_z * a_pendulum_y;
    /* M = L^T D L and back-substitution */
    const double inv_alpha = 1.0 / I_pendulum_xx;
    const double l_alpha_theta = M_theta_alpha * inv_alpha;
    const double pivot_theta = M_theta_theta - M_theta_alpha * l_alpha_theta;
    const double inv_theta = 1.0 / pivot_theta;
    const double theta_ddot = inv_theta * (tau_theta - tau_alpha * l_alpha_theta);
    const double alpha_ddot = tau_alpha * inv_alpha - l_alpha_theta * theta_ddot;
    /* derivatives with respect to alpha */
    const double by_alpha_1 = omega_pendulum_z * omega_pendulum_z - omega_pendulum_y_sq;
    const double two_omega_pendulum_y = 2.0 * omega_pendulum_y;
    /* derivatives with respect to theta_dot */
    const double by_theta_dot_1 = omega_pendulum_z * s_alpha + omega_pendulum_y * c_alpha;
    const double I_pendulum_xx_by_theta_dot_1 = I_pendulum_xx * by_theta_dot_1;
    const double by_theta_dot_2 = 2.0 * I_pendulum_xx * c_alpha * v->alpha - 2.0 * p->r * mc_pendulum_z * v->theta;
    const double by_theta_dot_3 = mc_pendulum_z * two_omega_pendulum_y * s_alpha * s_alpha;
    const double by_theta_dot_4 = p->r * (-mc_pendulum_z * by_theta_dot_1 * c_alpha - by_theta_dot_3);
    const double by_theta_dot_5 = by_theta_dot_4 - by_theta_dot_2 * s_alpha - l_alpha_theta * I_pendulum_xx_by_theta_dot_1;
    const double d_theta_ddot_by_theta_dot = inv_theta * by_theta_dot_5;
    const double d_alpha_ddot_by_theta_dot = inv_alpha * I_pendulum_xx_by_theta_dot_1 - l_alpha_theta * d_theta_ddot_by_theta_dot;
    /* derivatives with respect to alpha_dot */
    const double by_alpha_dot_1 = 2.0 * I_pendulum_xx * omega_pendulum_z * s_alpha;
    const double d_theta_ddot_by_alpha_dot = inv_theta * (-2.0 * p->r * mc_pendulum_z * s_alpha * v->alpha - by_alpha_dot_1);
    const double r_theta_ddot = p->r * theta_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = a_pendulum_z - r_theta_ddot * s_alpha;
    const double slopes_2 = p->m_p * (a_pendulum_y + r_theta_ddot * c_alpha);
    const double m_p_slopes_1 = p->m_p * slopes_1;
    const double slopes_3 = pendulum_2 + I_pendulum_xx * (alpha_pendulum_y + theta_ddot * s_alpha);
    const double slopes_4 = s_alpha * (slopes_2 + mc_pendulum_z * (pendulum_1 - alpha_ddot));
    const double slopes_5 = c_alpha * (slopes_3 - r_mc_pendulum_z_theta_dot_sq);
    const double slopes_6 = I_pendulum_xx * (theta_ddot * c_alpha + alpha_pendulum_z) + I_pendulum_xx * alpha_pendulum_z;
    const double slopes_7 = c_alpha * (m_p_slopes_1 + mc_pendulum_z * by_alpha_1);
    const double slopes_8 = s_alpha * (-mc_pendulum_z * omega_pendulum_z * two_omega_pendulum_y - slopes_2);
    const double slopes_9 = c_alpha * (f_moving_pendulum_z + m_p_slopes_1) + slopes_8;
    const double slopes_10 = p->r * (slopes_7 - slopes_4 - slopes_9);
    const double slopes_11 = slopes_5 + slopes_6 * s_alpha + slopes_10;
    /* derivatives with respect to alpha */
    const double by_alpha_2 = I_pendulum_xx * by_alpha_1 + mc_pendulum_z * slopes_1;
    const double d_theta_ddot_by_alpha = -inv_theta * (slopes_11 + l_alpha_theta * by_alpha_2);
    const double d_alpha_ddot_by_alpha = inv_alpha * by_alpha_2 - l_alpha_theta * d_theta_ddot_by_alpha;
    if (!(I_pendulum_xx > 0.0)) {
        return 2;
    }
    if (!(pivot_theta > 0.0)) {
        return 1;
    }
    dx[0] = v->theta; /* theta' */
    dx[1] = v->alpha; /* alpha' */
    dx[2] = theta_ddot; /* theta'' */
    dx[3] = alpha_ddot; /* alpha'' */
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][2] = 1.0; /* theta' */
    a[1][3] = 1.0; /* alpha' */
    a[2][1] = d_theta_ddot_by_alpha; /* theta'' */
    a[2][2] = d_theta_ddot_by_theta_dot;
    a[2][3] = d_theta_ddot_by_alpha_dot;
    a[3][1] = d_alpha_ddot_by_alpha; /* alpha'' */
    a[3][2] = d_alpha_ddot_by_theta_dot;
    a[3][3] = -l_alpha_theta * d_theta_ddot_by_alpha_dot;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 1; j++) {
            b[i][j] = 0.0;
        }
    }
    b[2][0] = inv_theta; /* theta'' */
    b[3][0] = -l_alpha_theta * inv_theta; /* alpha'' */
    return 0;
}

int furuta_parameter_jacobian(
    const struct furuta_state *x,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    double by_p[4][7])
{
    const struct furuta_coordinates *q = &x->q;
    const struct furuta_rates *v = &x->v;
    const double s_alpha = sin(q->alpha);
    const double c_alpha = cos(q->alpha);
    const double r_sq = p->r * p->r;
    const double L_p_sq = p->L_p * p->L_p;
    const double r_per_two = p->r / 2.0;
    /* body arm_rod on arm */
    const double mc_arm_x = p->m_r * r_per_two;
    const double I_arm_yy = p->m_r * r_sq / 12.0 + r_per_two * mc_arm_x;
    const double L_p_per_two = p->L_p / 2.0;
    /* body rod on pendulum */
    const double mc_pendulum_z = -p->m_p * L_p_per_two;
    const double I_pendulum_xx = p->m_p * L_p_sq / 12.0 - L_p_per_two * mc_pendulum_z;
    /* frame pendulum on arm */
    const double omega_pendulum_y = s_alpha * v->theta;
    const double omega_pendulum_z = c_alpha * v->theta;
    const double alpha_pendulum_y = omega_pendulum_z * v->alpha;
    const double pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    const double pendulum_2 = v->alpha * v->alpha + omega_pendulum_y * omega_pendulum_y;
    const double f_moving_pendulum_z = -mc_pendulum_z * pendulum_2;
    const double a_pendulum_y = p->g * s_alpha;
    const double a_pendulum_z = p->g * c_alpha;
    const double f_pendulum_y = p->m_p * a_pendulum_y + mc_pendulum_z * pendulum_1;
    const double f_pendulum_1_y = f_pendulum_y * c_alpha - s_alpha * (f_moving_pendulum_z + p->m_p * a_pendulum_z);
    const double mc_pendulum_z_s_alpha = mc_pendulum_z * s_alpha;
    const double M_theta_alpha = -p->r * mc_pendulum_z * c_alpha;
    const double theta_dot_sq = v->theta * v->theta;
    const double a_pendulum_1_x = -p->r * theta_dot_sq;
    const double pendulum_1_1 = I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p->r * p->r * p->m_p;
    const double n_moving_pendulum_y = mc_pendulum_z * a_pendulum_1_x + 2.0 * I_pendulum_xx * alpha_pendulum_y;
    const double n_arm_z = n_moving_pendulum_y * s_alpha + p->r * f_pendulum_1_y;
    /* kinetic energy rotor */
    const double M_theta_theta = I_arm_yy + pendulum_1_1 + p->J_m + p->J_h;
    /* balance of forces */
    const double tau_alpha = I_pendulum_xx * pendulum_1 + mc_pendulum_z * a_pendulum_y;
    /* M = L^T D L and back-substitution */
    const double inv_alpha = 1.0 / I_pendulum_xx;
    const double l_alpha_theta = M_theta_alpha * inv_alpha;
    const double pivot_theta = M_theta_theta - M_theta_alpha * l_alpha_theta;
    const double inv_theta = 1.0 / pivot_theta;
    const double theta_ddot = inv_theta * (u->tau - n_arm_z - tau_alpha * l_alpha_theta);
    const double alpha_ddot = tau_alpha * inv_alpha - l_alpha_theta * theta_ddot;
    const double theta_ddot_s_alpha = theta_ddot * s_alpha;
    const double r_theta_ddot = p->r * theta_ddot;
    const double theta_ddot_c_alpha = theta_ddot * c_alpha;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = alpha_pendulum_y + theta_ddot_s_alpha;
    const double slopes_2 = a_pendulum_y + r_theta_ddot * c_alpha;
    const double slopes_3 = a_pendulum_z - r_theta_ddot * s_alpha;
    const double pendulum_1_minus_alpha_ddot = pendulum_1 - alpha_ddot;
    const double slopes_4 = c_alpha * (p->m_p * slopes_2 + mc_pendulum_z * pendulum_1_minus_alpha_ddot);
    const double slopes_5 = slopes_4 - s_alpha * (f_moving_pendulum_z + p->m_p * slopes_3);
    const double slopes_6 = theta_ddot * (2.0 * p->m_r * p->r / 12.0 + 0.5 * mc_arm_x + 0.5 * p->m_r * r_per_two);
    const double slopes_7 = mc_pendulum_z * theta_ddot_c_alpha;
    const double slopes_8 = p->m_p * theta_ddot_s_alpha * s_alpha;
    const double slopes_9 = p->r * (p->m_p * theta_ddot_c_alpha * c_alpha + slopes_8);
    const double slopes_10 = slopes_5 - mc_pendulum_z * theta_dot_sq * s_alpha + slopes_9;
    const double slopes_11 = c_alpha * (slopes_2 - L_p_per_two * pendulum_1_minus_alpha_ddot);
    const double slopes_12 = s_alpha * (slopes_3 + L_p_per_two * pendulum_2);
    /* derivatives with respect to m_p */
    const double by_m_p_1 = L_p_sq / 12.0 + L_p_per_two * L_p_per_two;
    const double half_m_p = 0.5 * p->m_p;
    /* derivatives with respect to L_p */
    const double by_L_p_1 = 2.0 * p->m_p * p->L_p / 12.0 - 0.5 * mc_pendulum_z + L_p_per_two * half_m_p;
    const double m_p_s_alpha_c_alpha = p->m_p * s_alpha * c_alpha;
    /* derivatives with respect to g */
    const double by_g_1 = p->r * (p->m_p * c_alpha * s_alpha - m_p_s_alpha_c_alpha);
    const double d_theta_ddot_by_g = inv_theta * (-mc_pendulum_z_s_alpha * l_alpha_theta - by_g_1);
    const double d_alpha_ddot_by_g = mc_pendulum_z_s_alpha * inv_alpha - l_alpha_theta * d_theta_ddot_by_g;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_13 = alpha_ddot * by_m_p_1 - pendulum_1 * by_m_p_1;
    const double slopes_14 = alpha_pendulum_y * by_m_p_1 + slopes_1 * by_m_p_1;
    const double slopes_15 = L_p_per_two * slopes_2 + slopes_13;
    const double slopes_16 = s_alpha * (slopes_14 - L_p_per_two * a_pendulum_1_x);
    const double slopes_17 = slopes_16 + p->r * (slopes_11 - slopes_12);
    const double slopes_18 = alpha_ddot * by_L_p_1 - pendulum_1 * by_L_p_1;
    const double slopes_19 = alpha_pendulum_y * by_L_p_1 + slopes_1 * by_L_p_1;
    const double slopes_20 = slopes_2 * half_m_p + slopes_18;
    const double slopes_21 = pendulum_1_minus_alpha_ddot * half_m_p * c_alpha;
    const double slopes_22 = s_alpha * (slopes_19 - a_pendulum_1_x * half_m_p);
    const double slopes_23 = p->r * (pendulum_2 * half_m_p * s_alpha + slopes_21);
    /* derivatives with respect to m_r */
    const double d_theta_ddot_by_m_r = -inv_theta * theta_ddot * (r_sq / 12.0 + r_per_two * r_per_two);
    /* derivatives with respect to r */
    const double d_theta_ddot_by_r = inv_theta * (-l_alpha_theta * slopes_7 - slopes_6 - slopes_10);
    const double d_alpha_ddot_by_r = inv_alpha * slopes_7 - l_alpha_theta * d_theta_ddot_by_r;
    /* derivatives with respect to m_p */
    const double d_theta_ddot_by_m_p = inv_theta * (l_alpha_theta * slopes_15 - slopes_17);
    const double d_alpha_ddot_by_m_p = -inv_alpha * slopes_15 - l_alpha_theta * d_theta_ddot_by_m_p;
    /* derivatives with respect to L_p */
    const double d_theta_ddot_by_L_p = inv_theta * (slopes_23 - slopes_22 + l_alpha_theta * slopes_20);
    const double d_alpha_ddot_by_L_p = -inv_alpha * slopes_20 - l_alpha_theta * d_theta_ddot_by_L_p;
    /* derivatives with respect to J_m */
    const double d_theta_ddot_by_J_m = -inv_theta * theta_ddot;
    const double d_alpha_ddot_by_J_m = -l_alpha_theta * d_theta_ddot_by_J_m;
    if (!(I_pendulum_xx > 0.0)) {
        return 2;
    }
    if (!(pivot_theta > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 7; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[2][0] = d_theta_ddot_by_m_r; /* theta'' */
    by_p[2][1] = d_theta_ddot_by_r;
    by_p[2][2] = d_theta_ddot_by_m_p;
    by_p[2][3] = d_theta_ddot_by_L_p;
    by_p[2][4] = d_theta_ddot_by_J_m;
    by_p[2][5] = d_theta_ddot_by_J_m;
    by_p[2][6] = d_theta_ddot_by_g;
    by_p[3][0] = -l_alpha_theta * d_theta_ddot_by_m_r; /* alpha'' */
    by_p[3][1] = d_alpha_ddot_by_r;
    by_p[3][2] = d_alpha_ddot_by_m_p;
    by_p[3][3] = d_alpha_ddot_by_L_p;
    by_p[3][4] = d_alpha_ddot_by_J_m;
    by_p[3][5] = d_alpha_ddot_by_J_m;
    by_p[3][6] = d_alpha_ddot_by_g;
    return 0;
}

void furuta_output_jacobian(const struct furuta_state *x, const struct furuta_parameters *p, double by_x[2][4], double by_p[2][7])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 4; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* theta */
    by_x[1][1] = 1.0; /* alpha */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 7; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

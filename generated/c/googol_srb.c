/*
 * Googol GHP2002, single-rigid-body model.
 * Generated from `googol_srb.rig` (model 7ec63ed6); edit the rig, not this file.
 *
 * Eq. 1 to 5 of the seed paper: arm, counterweight and fuselage are one body on a ball joint, l_cd = 0,
 * friction and velocity products neglected. The mass matrix is T^T I T with T of eq. 2 and
 * I = diag(I_theta, I_eps, I_psi) in the body's axes (the first one is the pitch axis; the paper prints
 * the opposite order). Gravity has the sign that physics gives it; eq. 5 prints the other one.
 * Without l_cd there is no pitch stiffness, and at eps = +-90 deg the mass matrix is singular.
 *
 * Assumed: l_cd = 0; no velocity products; no friction.
 * 60 operations forward, 141 with A and B.
 * Derived twice before the assumptions, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "googol_srb.h"

#include <math.h>

void googol_srb_nominal(struct googol_srb_parameters *p)
{
    p->m_h = 1.8;
    p->m_b = 0.67948;
    p->m_c = 3.433;
    p->g = 9.81;
    p->l_oc = 0.78;
    p->l_ob = 0.33;
    p->l_oa = 0.2296;
    p->l_cd = 0.1;
    p->l_df = 0.17;
    p->c0_psi = 0.4025;
    p->c0_eps = 0.0779;
    p->c0_theta = 0.00153;
    p->I_psi = 1.469;
    p->I_eps = 1.469;
    p->I_theta = 0.0319;
}

void googol_srb_mass_matrix(const struct googol_srb_coordinates *q, const struct googol_srb_parameters *p, double m[3][3])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    /* frame heli on arm */
    const double M_psi_theta = -p->I_theta * s_eps;
    const double I_eps_minus_I_psi_c_theta = c_theta * (p->I_eps - p->I_psi);
    const double heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    /* frame arm on column */
    const double M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    const double M_psi_psi = p->I_theta + c_eps * c_eps * (p->I_eps - heli_1 - p->I_theta);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m[i][j] = 0.0;
        }
    }
    m[0][0] = M_psi_psi; /* psi */
    m[0][1] = M_psi_eps;
    m[0][2] = M_psi_theta;
    m[1][0] = M_psi_eps; /* eps */
    m[1][1] = p->I_psi + heli_1;
    m[2][0] = M_psi_theta; /* theta */
    m[2][2] = p->I_theta;
}

void googol_srb_bias(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_rates *v,
    const struct googol_srb_parameters *p,
    double h[3])
{
    (void)v;
    const double c_eps = cos(q->eps);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double m_2 = p->m_c + p->m_h + p->m_b;
    /* gravity */
    const double g_eps = p->g * m_2 * m_prime * c_eps / m_2;
    h[0] = 0.0; /* psi */
    h[1] = g_eps; /* eps */
    h[2] = 0.0; /* theta */
}

void googol_srb_velocity_products(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_rates *v,
    const struct googol_srb_parameters *p,
    double c[3])
{
    (void)q;
    (void)v;
    (void)p;
    c[0] = 0.0; /* psi */
    c[1] = 0.0; /* eps */
    c[2] = 0.0; /* theta */
}

void googol_srb_gravity(const struct googol_srb_coordinates *q, const struct googol_srb_parameters *p, double g[3])
{
    const double c_eps = cos(q->eps);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double m_2 = p->m_c + p->m_h + p->m_b;
    const double g_eps = p->g * m_2 * m_prime * c_eps / m_2;
    g[0] = 0.0; /* psi */
    g[1] = g_eps; /* eps */
    g[2] = 0.0; /* theta */
}

void googol_srb_dissipation(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_rates *v,
    const struct googol_srb_parameters *p,
    double d[3])
{
    (void)q;
    (void)v;
    (void)p;
    d[0] = 0.0; /* psi */
    d[1] = 0.0; /* eps */
    d[2] = 0.0; /* theta */
}

void googol_srb_generalized_force(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    double f[3])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double l_df_f_1 = p->l_df * u->f_1;
    const double l_df_f_2 = p->l_df * u->f_2;
    /* force rotor_2 on heli */
    const double n_applied_heli_y = -p->l_oc * u->f_1 - p->l_oc * u->f_2;
    /* frame arm on column */
    const double arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    const double n_applied_column_z = arm_1 - n_applied_heli_y * c_eps * s_theta;
    f[0] = n_applied_column_z; /* psi */
    f[1] = -n_applied_heli_y * c_theta; /* eps */
    f[2] = l_df_f_1 - l_df_f_2; /* theta */
}

void googol_srb_input_map(const struct googol_srb_coordinates *q, const struct googol_srb_parameters *p, double s[3][2])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double l_oc_c_theta = p->l_oc * c_theta;
    const double l_oc_c_eps_s_theta = p->l_oc * c_eps * s_theta;
    const double l_df_s_eps = p->l_df * s_eps;
    s[0][0] = l_oc_c_eps_s_theta - l_df_s_eps; /* psi */
    s[0][1] = l_oc_c_eps_s_theta + l_df_s_eps;
    s[1][0] = l_oc_c_theta; /* eps */
    s[1][1] = l_oc_c_theta;
    s[2][0] = p->l_df; /* theta */
    s[2][1] = -p->l_df;
}

double googol_srb_kinetic_energy(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_rates *v,
    const struct googol_srb_parameters *p)
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double m_2 = p->m_c + p->m_h + p->m_b;
    const double m_prime_per_m_2 = m_prime / m_2;
    const double m_prime_m_prime_per_m_2 = m_prime * m_prime_per_m_2;
    /* frame arm on column */
    const double omega_arm_z = c_eps * v->psi;
    /* frame heli on arm */
    const double omega_heli_y = -c_theta * v->eps - omega_arm_z * s_theta;
    const double omega_heli_z = omega_arm_z * c_theta - s_theta * v->eps;
    const double omega_heli_x = s_eps * v->psi - v->theta;
    const double m_prime_per_m_2_omega_heli_z = m_prime_per_m_2 * omega_heli_z;
    const double m_prime_per_m_2_omega_heli_y = m_prime_per_m_2 * omega_heli_y;
    /* body aircraft on heli */
    const double aircraft_1 = m_2
        * (m_prime_per_m_2_omega_heli_z * m_prime_per_m_2_omega_heli_z + m_prime_per_m_2_omega_heli_y * m_prime_per_m_2_omega_heli_y);
    const double aircraft_2 = p->I_theta * omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y * (p->I_eps - m_prime_m_prime_per_m_2);
    const double aircraft_3 = omega_heli_z * omega_heli_z * (p->I_psi - m_prime_m_prime_per_m_2) + aircraft_2;
    return 0.5 * (aircraft_1 + aircraft_3);
}

double googol_srb_potential_energy(const struct googol_srb_coordinates *q, const struct googol_srb_parameters *p)
{
    const double s_eps = sin(q->eps);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double m_2 = p->m_c + p->m_h + p->m_b;
    return p->g * m_2 * m_prime * s_eps / m_2;
}

void googol_srb_inverse_dynamics(
    const struct googol_srb_state *x,
    const struct googol_srb_accelerations *a,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    double r[3])
{
    const struct googol_srb_coordinates *q = &x->q;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double m_2 = p->m_c + p->m_h + p->m_b;
    /* frame heli on arm */
    const double M_psi_theta = -p->I_theta * s_eps;
    const double I_eps_minus_I_psi_c_theta = c_theta * (p->I_eps - p->I_psi);
    const double heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    /* frame arm on column */
    const double M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    const double M_psi_psi = p->I_theta + c_eps * c_eps * (p->I_eps - heli_1 - p->I_theta);
    const double l_df_f_1 = p->l_df * u->f_1;
    const double l_df_f_2 = p->l_df * u->f_2;
    /* force rotor_2 on heli */
    const double n_applied_heli_y = -p->l_oc * u->f_1 - p->l_oc * u->f_2;
    /* frame arm on column */
    const double arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    const double n_applied_column_z = arm_1 - n_applied_heli_y * c_eps * s_theta;
    /* gravity */
    const double g_eps = p->g * m_2 * m_prime * c_eps / m_2;
    /* balance of forces */
    const double balance_1 = g_eps + M_psi_eps * a->psi + a->eps * (p->I_psi + heli_1);
    r[0] = M_psi_psi * a->psi + M_psi_eps * a->eps + M_psi_theta * a->theta - n_applied_column_z; /* psi */
    r[1] = balance_1 + n_applied_heli_y * c_theta; /* eps */
    r[2] = p->I_theta * a->theta + M_psi_theta * a->psi - l_df_f_1 + l_df_f_2; /* theta */
}

void googol_srb_outputs(const struct googol_srb_state *x, const struct googol_srb_parameters *p, struct googol_srb_outputs *y)
{
    const struct googol_srb_coordinates *q = &x->q;
    (void)p;
    y->psi = q->psi;
    y->eps = q->eps;
    y->theta = q->theta;
}

void googol_srb_pivots(const struct googol_srb_state *x, const struct googol_srb_parameters *p, double d[3])
{
    const struct googol_srb_coordinates *q = &x->q;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    /* frame heli on arm */
    const double M_psi_theta = -p->I_theta * s_eps;
    const double I_eps_minus_I_psi_c_theta = c_theta * (p->I_eps - p->I_psi);
    const double heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    const double M_eps_eps = p->I_psi + heli_1;
    /* frame arm on column */
    const double M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    const double M_psi_psi = p->I_theta + c_eps * c_eps * (p->I_eps - heli_1 - p->I_theta);
    /* M = L^T D L and back-substitution */
    const double pivot_psi = M_psi_psi - M_psi_eps * M_psi_eps / M_eps_eps - M_psi_theta * M_psi_theta / p->I_theta;
    d[0] = pivot_psi; /* psi */
    d[1] = M_eps_eps; /* eps */
    d[2] = p->I_theta; /* theta */
}

int googol_srb_forward_dynamics(
    const struct googol_srb_state *x,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    struct googol_srb_accelerations *a)
{
    const struct googol_srb_coordinates *q = &x->q;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double m_2 = p->m_c + p->m_h + p->m_b;
    /* frame heli on arm */
    const double M_psi_theta = -p->I_theta * s_eps;
    const double I_eps_minus_I_psi_c_theta = c_theta * (p->I_eps - p->I_psi);
    const double heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    const double M_eps_eps = p->I_psi + heli_1;
    /* frame arm on column */
    const double M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    const double M_psi_psi = p->I_theta + c_eps * c_eps * (p->I_eps - heli_1 - p->I_theta);
    const double l_df_f_1 = p->l_df * u->f_1;
    const double l_df_f_2 = p->l_df * u->f_2;
    /* force rotor_2 on heli */
    const double n_applied_heli_y = -p->l_oc * u->f_1 - p->l_oc * u->f_2;
    /* frame heli on arm */
    const double Q_theta = l_df_f_1 - l_df_f_2;
    /* frame arm on column */
    const double arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    const double n_applied_column_z = arm_1 - n_applied_heli_y * c_eps * s_theta;
    /* gravity */
    const double g_eps = p->g * m_2 * m_prime * c_eps / m_2;
    /* balance of forces */
    const double tau_eps = -n_applied_heli_y * c_theta - g_eps;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / p->I_theta;
    const double l_theta_psi = M_psi_theta * inv_theta;
    const double inv_eps = 1.0 / M_eps_eps;
    const double l_eps_psi = M_psi_eps * inv_eps;
    const double pivot_psi = M_psi_psi - M_psi_eps * l_eps_psi - M_psi_theta * l_theta_psi;
    const double psi_ddot = (n_applied_column_z - tau_eps * l_eps_psi - Q_theta * l_theta_psi) / pivot_psi;
    const double eps_ddot = tau_eps * inv_eps - l_eps_psi * psi_ddot;
    const double theta_ddot = Q_theta * inv_theta - l_theta_psi * psi_ddot;
    if (!(p->I_theta > 0.0)) {
        return 3;
    }
    if (!(M_eps_eps > 0.0)) {
        return 2;
    }
    if (!(pivot_psi > 0.0)) {
        return 1;
    }
    a->psi = psi_ddot;
    a->eps = eps_ddot;
    a->theta = theta_ddot;
    return 0;
}

int googol_srb_linearize(
    const struct googol_srb_state *x,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2])
{
    const struct googol_srb_coordinates *q = &x->q;
    const struct googol_srb_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double m_2 = p->m_c + p->m_h + p->m_b;
    const double m_prime_per_m_2 = m_prime / m_2;
    /* frame heli on arm */
    const double M_psi_theta = -p->I_theta * s_eps;
    const double I_theta_c_eps = p->I_theta * c_eps;
    const double I_eps_minus_I_psi = p->I_eps - p->I_psi;
    const double I_eps_minus_I_psi_c_theta = I_eps_minus_I_psi * c_theta;
    const double heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    const double heli_2 = I_eps_minus_I_psi_c_theta * s_theta;
    const double M_eps_eps = p->I_psi + heli_1;
    /* frame arm on column */
    const double M_psi_eps = heli_2 * c_eps;
    const double heli_2_s_eps = heli_2 * s_eps;
    const double arm_1 = p->I_eps - heli_1 - p->I_theta;
    const double arm_1_c_eps = arm_1 * c_eps;
    const double l_df_f_1 = p->l_df * u->f_1;
    const double l_df_f_2 = p->l_df * u->f_2;
    /* force rotor_2 on heli */
    const double n_applied_heli_x = l_df_f_2 - l_df_f_1;
    const double n_applied_heli_y = -p->l_oc * u->f_1 - p->l_oc * u->f_2;
    /* frame heli on arm */
    const double Q_theta = l_df_f_1 - l_df_f_2;
    const double n_applied_arm_y = n_applied_heli_y * c_theta;
    const double n_applied_arm_z = -n_applied_heli_y * s_theta;
    /* frame arm on column */
    const double n_applied_column_z = n_applied_arm_z * c_eps + n_applied_heli_x * s_eps;
    const double n_applied_column_x = n_applied_heli_x * c_eps - n_applied_arm_z * s_eps;
    /* gravity */
    const double g_eps = p->g * m_2 * m_prime_per_m_2 * c_eps;
    /* balance of forces */
    const double tau_eps = -n_applied_arm_y - g_eps;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / p->I_theta;
    const double l_theta_psi = M_psi_theta * inv_theta;
    const double inv_eps = 1.0 / M_eps_eps;
    const double l_eps_psi = M_psi_eps * inv_eps;
    const double pivot_psi = p->I_theta + arm_1_c_eps * c_eps - M_psi_eps * l_eps_psi - M_psi_theta * l_theta_psi;
    const double inv_psi = 1.0 / pivot_psi;
    const double psi_ddot = inv_psi * (n_applied_column_z - tau_eps * l_eps_psi - Q_theta * l_theta_psi);
    const double eps_ddot = tau_eps * inv_eps - l_eps_psi * psi_ddot;
    const double theta_ddot = Q_theta * inv_theta - l_theta_psi * psi_ddot;
    const double l_oc_c_theta = p->l_oc * c_theta;
    const double l_oc_c_eps_s_theta = p->l_oc * c_eps * s_theta;
    const double l_df_s_eps = p->l_df * s_eps;
    const double arm_1_c_eps_s_eps = arm_1 * c_eps * s_eps;
    const double I_eps_minus_I_psi_s_theta = I_eps_minus_I_psi * s_theta;
    /* derivatives with respect to theta */
    const double by_theta_1 = heli_2 + I_eps_minus_I_psi_s_theta * c_theta;
    const double by_theta_2 = c_eps * (heli_1 - I_eps_minus_I_psi_s_theta * s_theta);
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = psi_ddot * (arm_1_c_eps * s_eps + arm_1_c_eps_s_eps);
    const double slopes_2 = slopes_1 + heli_2_s_eps * eps_ddot + I_theta_c_eps * theta_ddot;
    const double slopes_3 = p->g * m_2 * m_prime_per_m_2 * s_eps + heli_2_s_eps * psi_ddot;
    const double I_theta_c_eps_psi_ddot = I_theta_c_eps * psi_ddot;
    const double slopes_4 = psi_ddot * by_theta_1 * c_eps * c_eps;
    const double slopes_5 = n_applied_arm_z + psi_ddot * by_theta_2 - eps_ddot * by_theta_1;
    /* derivatives with respect to eps */
    const double by_eps_1 = n_applied_column_x + slopes_2 - l_eps_psi * slopes_3;
    const double d_psi_ddot_by_eps = inv_psi * (by_eps_1 - l_theta_psi * I_theta_c_eps_psi_ddot);
    const double d_eps_ddot_by_eps = inv_eps * slopes_3 - l_eps_psi * d_psi_ddot_by_eps;
    const double d_theta_ddot_by_eps = inv_theta * I_theta_c_eps_psi_ddot - l_theta_psi * d_psi_ddot_by_eps;
    /* derivatives with respect to theta */
    const double by_theta_3 = n_applied_arm_y * c_eps + slopes_4 + eps_ddot * by_theta_2;
    const double d_psi_ddot_by_theta = inv_psi * (l_eps_psi * slopes_5 - by_theta_3);
    const double d_eps_ddot_by_theta = -inv_eps * slopes_5 - l_eps_psi * d_psi_ddot_by_theta;
    const double l_eps_psi_l_oc_c_theta = l_eps_psi * l_oc_c_theta;
    const double l_df_l_theta_psi = p->l_df * l_theta_psi;
    /* derivatives with respect to f_1 */
    const double d_psi_ddot_by_f_1 = inv_psi * (l_oc_c_eps_s_theta - l_df_s_eps - l_eps_psi_l_oc_c_theta - l_df_l_theta_psi);
    const double inv_eps_l_oc_c_theta = inv_eps * l_oc_c_theta;
    const double l_df_inv_theta = p->l_df * inv_theta;
    /* derivatives with respect to f_2 */
    const double d_psi_ddot_by_f_2 = inv_psi * (l_oc_c_eps_s_theta + l_df_s_eps - l_eps_psi_l_oc_c_theta + l_df_l_theta_psi);
    if (!(p->I_theta > 0.0)) {
        return 3;
    }
    if (!(M_eps_eps > 0.0)) {
        return 2;
    }
    if (!(pivot_psi > 0.0)) {
        return 1;
    }
    dx[0] = v->psi; /* psi' */
    dx[1] = v->eps; /* eps' */
    dx[2] = v->theta; /* theta' */
    dx[3] = psi_ddot; /* psi'' */
    dx[4] = eps_ddot; /* eps'' */
    dx[5] = theta_ddot; /* theta'' */
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][3] = 1.0; /* psi' */
    a[1][4] = 1.0; /* eps' */
    a[2][5] = 1.0; /* theta' */
    a[3][1] = d_psi_ddot_by_eps; /* psi'' */
    a[3][2] = d_psi_ddot_by_theta;
    a[4][1] = d_eps_ddot_by_eps; /* eps'' */
    a[4][2] = d_eps_ddot_by_theta;
    a[5][1] = d_theta_ddot_by_eps; /* theta'' */
    a[5][2] = -l_theta_psi * d_psi_ddot_by_theta;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 2; j++) {
            b[i][j] = 0.0;
        }
    }
    b[3][0] = d_psi_ddot_by_f_1; /* psi'' */
    b[3][1] = d_psi_ddot_by_f_2;
    b[4][0] = inv_eps_l_oc_c_theta - l_eps_psi * d_psi_ddot_by_f_1; /* eps'' */
    b[4][1] = inv_eps_l_oc_c_theta - l_eps_psi * d_psi_ddot_by_f_2;
    b[5][0] = l_df_inv_theta - l_theta_psi * d_psi_ddot_by_f_1; /* theta'' */
    b[5][1] = -l_theta_psi * d_psi_ddot_by_f_2 - l_df_inv_theta;
    return 0;
}

int googol_srb_parameter_jacobian(
    const struct googol_srb_state *x,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    double by_p[6][15])
{
    const struct googol_srb_coordinates *q = &x->q;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double m_2 = p->m_c + p->m_h + p->m_b;
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double m_prime_per_m_2 = m_prime / m_2;
    const double m_prime_per_m_2_c_eps = m_prime_per_m_2 * c_eps;
    /* frame heli on arm */
    const double M_psi_theta = -p->I_theta * s_eps;
    const double I_eps_minus_I_psi_c_theta = c_theta * (p->I_eps - p->I_psi);
    const double heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    const double M_eps_eps = p->I_psi + heli_1;
    /* frame arm on column */
    const double M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    const double M_psi_psi = p->I_theta + c_eps * c_eps * (p->I_eps - heli_1 - p->I_theta);
    const double l_df_f_1 = p->l_df * u->f_1;
    const double l_df_f_2 = p->l_df * u->f_2;
    /* force rotor_2 on heli */
    const double n_applied_heli_y = -p->l_oc * u->f_1 - p->l_oc * u->f_2;
    /* frame heli on arm */
    const double Q_theta = l_df_f_1 - l_df_f_2;
    /* frame arm on column */
    const double arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    const double n_applied_column_z = arm_1 - n_applied_heli_y * c_eps * s_theta;
    const double g_m_prime_per_m_2_c_eps = p->g * m_prime_per_m_2_c_eps;
    /* balance of forces */
    const double tau_eps = -n_applied_heli_y * c_theta - m_2 * g_m_prime_per_m_2_c_eps;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / p->I_theta;
    const double l_theta_psi = M_psi_theta * inv_theta;
    const double inv_eps = 1.0 / M_eps_eps;
    const double l_eps_psi = M_psi_eps * inv_eps;
    const double pivot_psi = M_psi_psi - M_psi_eps * l_eps_psi - M_psi_theta * l_theta_psi;
    const double inv_psi = 1.0 / pivot_psi;
    const double psi_ddot = inv_psi * (n_applied_column_z - tau_eps * l_eps_psi - Q_theta * l_theta_psi);
    const double eps_ddot = tau_eps * inv_eps - l_eps_psi * psi_ddot;
    const double theta_ddot = Q_theta * inv_theta - l_theta_psi * psi_ddot;
    /* derivatives with respect to m_h */
    const double by_m_h_1 = g_m_prime_per_m_2_c_eps + p->g * m_2 * c_eps * (p->l_oc - m_prime_per_m_2) / m_2;
    const double d_psi_ddot_by_m_h = inv_psi * l_eps_psi * by_m_h_1;
    const double d_eps_ddot_by_m_h = -inv_eps * by_m_h_1 - l_eps_psi * d_psi_ddot_by_m_h;
    /* derivatives with respect to m_b */
    const double by_m_b_1 = g_m_prime_per_m_2_c_eps + p->g * m_2 * c_eps * (p->l_oa - m_prime_per_m_2) / m_2;
    const double d_psi_ddot_by_m_b = inv_psi * l_eps_psi * by_m_b_1;
    const double d_eps_ddot_by_m_b = -inv_eps * by_m_b_1 - l_eps_psi * d_psi_ddot_by_m_b;
    const double m_2_m_prime_per_m_2_c_eps = m_2 * m_prime_per_m_2_c_eps;
    /* derivatives with respect to g */
    const double d_psi_ddot_by_g = inv_psi * l_eps_psi * m_2_m_prime_per_m_2_c_eps;
    const double d_eps_ddot_by_g = -inv_eps * m_2_m_prime_per_m_2_c_eps - l_eps_psi * d_psi_ddot_by_g;
    const double g_m_2_m_c_per_m_2_c_eps = p->m_c * p->g * m_2 * c_eps / m_2;
    /* derivatives with respect to l_ob */
    const double d_psi_ddot_by_l_ob = -inv_psi * l_eps_psi * g_m_2_m_c_per_m_2_c_eps;
    const double d_eps_ddot_by_l_ob = inv_eps * g_m_2_m_c_per_m_2_c_eps - l_eps_psi * d_psi_ddot_by_l_ob;
    const double g_m_2_m_b_per_m_2_c_eps = p->m_b * p->g * m_2 * c_eps / m_2;
    /* derivatives with respect to l_oa */
    const double d_psi_ddot_by_l_oa = inv_psi * l_eps_psi * g_m_2_m_b_per_m_2_c_eps;
    const double d_eps_ddot_by_l_oa = -inv_eps * g_m_2_m_b_per_m_2_c_eps - l_eps_psi * d_psi_ddot_by_l_oa;
    const double c_theta_sq = c_theta * c_theta;
    const double one_minus_c_theta_sq = 1.0 - c_theta_sq;
    const double c_eps_s_theta_c_theta = c_eps * s_theta * c_theta;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = eps_ddot * c_eps_s_theta_c_theta;
    const double slopes_2 = psi_ddot * c_eps_s_theta_c_theta;
    const double slopes_3 = slopes_1 + psi_ddot * one_minus_c_theta_sq * c_eps * c_eps;
    const double slopes_4 = slopes_2 + eps_ddot * c_theta_sq;
    /* derivatives with respect to m_c */
    const double by_m_c_1 = p->g * m_2 * c_eps * (p->l_ob + m_prime_per_m_2) / m_2 - g_m_prime_per_m_2_c_eps;
    const double d_psi_ddot_by_m_c = -inv_psi * l_eps_psi * by_m_c_1;
    const double d_eps_ddot_by_m_c = inv_eps * by_m_c_1 - l_eps_psi * d_psi_ddot_by_m_c;
    /* derivatives with respect to l_oc */
    const double by_l_oc_1 = f_s * c_theta - p->m_h * p->g * m_2 * c_eps / m_2;
    const double d_psi_ddot_by_l_oc = inv_psi * (f_s * c_eps * s_theta - l_eps_psi * by_l_oc_1);
    const double d_eps_ddot_by_l_oc = inv_eps * by_l_oc_1 - l_eps_psi * d_psi_ddot_by_l_oc;
    /* derivatives with respect to l_df */
    const double d_psi_ddot_by_l_df = inv_psi * (s_eps * (u->f_2 - u->f_1) - f_d * l_theta_psi);
    const double d_theta_ddot_by_l_df = f_d * inv_theta - l_theta_psi * d_psi_ddot_by_l_df;
    /* derivatives with respect to I_psi */
    const double by_I_psi_1 = slopes_1 - psi_ddot * c_theta_sq * c_eps * c_eps;
    const double by_I_psi_2 = slopes_2 - eps_ddot * one_minus_c_theta_sq;
    const double d_psi_ddot_by_I_psi = inv_psi * (by_I_psi_1 - l_eps_psi * by_I_psi_2);
    const double d_eps_ddot_by_I_psi = inv_eps * by_I_psi_2 - l_eps_psi * d_psi_ddot_by_I_psi;
    /* derivatives with respect to I_eps */
    const double d_psi_ddot_by_I_eps = inv_psi * (l_eps_psi * slopes_4 - slopes_3);
    const double d_eps_ddot_by_I_eps = -inv_eps * slopes_4 - l_eps_psi * d_psi_ddot_by_I_eps;
    /* derivatives with respect to I_theta */
    const double by_I_theta_1 = theta_ddot * s_eps - psi_ddot * (1.0 - c_eps * c_eps);
    const double by_I_theta_2 = psi_ddot * s_eps - theta_ddot;
    const double d_psi_ddot_by_I_theta = inv_psi * (by_I_theta_1 - l_theta_psi * by_I_theta_2);
    const double d_theta_ddot_by_I_theta = inv_theta * by_I_theta_2 - l_theta_psi * d_psi_ddot_by_I_theta;
    if (!(p->I_theta > 0.0)) {
        return 3;
    }
    if (!(M_eps_eps > 0.0)) {
        return 2;
    }
    if (!(pivot_psi > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 15; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[3][0] = d_psi_ddot_by_m_h; /* psi'' */
    by_p[3][1] = d_psi_ddot_by_m_b;
    by_p[3][2] = d_psi_ddot_by_m_c;
    by_p[3][3] = d_psi_ddot_by_g;
    by_p[3][4] = d_psi_ddot_by_l_oc;
    by_p[3][5] = d_psi_ddot_by_l_ob;
    by_p[3][6] = d_psi_ddot_by_l_oa;
    by_p[3][8] = d_psi_ddot_by_l_df;
    by_p[3][12] = d_psi_ddot_by_I_psi;
    by_p[3][13] = d_psi_ddot_by_I_eps;
    by_p[3][14] = d_psi_ddot_by_I_theta;
    by_p[4][0] = d_eps_ddot_by_m_h; /* eps'' */
    by_p[4][1] = d_eps_ddot_by_m_b;
    by_p[4][2] = d_eps_ddot_by_m_c;
    by_p[4][3] = d_eps_ddot_by_g;
    by_p[4][4] = d_eps_ddot_by_l_oc;
    by_p[4][5] = d_eps_ddot_by_l_ob;
    by_p[4][6] = d_eps_ddot_by_l_oa;
    by_p[4][8] = -l_eps_psi * d_psi_ddot_by_l_df;
    by_p[4][12] = d_eps_ddot_by_I_psi;
    by_p[4][13] = d_eps_ddot_by_I_eps;
    by_p[4][14] = -l_eps_psi * d_psi_ddot_by_I_theta;
    by_p[5][0] = -l_theta_psi * d_psi_ddot_by_m_h; /* theta'' */
    by_p[5][1] = -l_theta_psi * d_psi_ddot_by_m_b;
    by_p[5][2] = -l_theta_psi * d_psi_ddot_by_m_c;
    by_p[5][3] = -l_theta_psi * d_psi_ddot_by_g;
    by_p[5][4] = -l_theta_psi * d_psi_ddot_by_l_oc;
    by_p[5][5] = -l_theta_psi * d_psi_ddot_by_l_ob;
    by_p[5][6] = -l_theta_psi * d_psi_ddot_by_l_oa;
    by_p[5][8] = d_theta_ddot_by_l_df;
    by_p[5][12] = -l_theta_psi * d_psi_ddot_by_I_psi;
    by_p[5][13] = -l_theta_psi * d_psi_ddot_by_I_eps;
    by_p[5][14] = d_theta_ddot_by_I_theta;
    return 0;
}

void googol_srb_output_jacobian(
    const struct googol_srb_state *x,
    const struct googol_srb_parameters *p,
    double by_x[3][6],
    double by_p[3][15])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 6; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* psi */
    by_x[1][1] = 1.0; /* eps */
    by_x[2][2] = 1.0; /* theta */
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 15; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

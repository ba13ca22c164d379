/*
 * Googol GHP2002 3-DOF helicopter, full physics.
 * Generated from `googol.rig` (model 55b1ef6d); edit the rig, not this file.
 *
 * Three bodies: arm and counterweight (point masses on the arm), and the fuselage with both rotors,
 * hanging l_cd below the pitch axis. Numbers: Table 1 of Li et al., Journal of Jilin University
 * (Engineering), 54(11), 2024, doi 10.13229/j.cnki.jdxbgxb.20220745; viscous friction as the authors
 * used it before identification, times the inertias.
 *
 * 175 operations forward, 637 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "googol.h"

#include <math.h>

void googol_nominal(struct googol_parameters *p)
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
    p->I_x = 0.0319;
    p->I_z = 0.0319;
    p->c0_psi = 0.4025;
    p->c0_eps = 0.0779;
    p->c0_theta = 0.00153;
}

void googol_mass_matrix(const struct googol_coordinates *q, const struct googol_parameters *p, double m[3][3])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    /* frame arm on column */
    const double I_arm_yy = p->m_b * p->l_oa * p->l_oa + p->m_c * p->l_ob * p->l_ob;
    /* body fuselage on heli */
    const double mc_heli_z = -p->m_h * p->l_cd;
    const double I_heli_yy = -p->l_cd * mc_heli_z;
    const double I_heli_xx = p->I_x + I_heli_yy;
    /* frame heli on arm */
    const double M_eps_theta = -p->l_oc * mc_heli_z * s_theta;
    const double l_oc_mc_heli_z_c_theta = p->l_oc * mc_heli_z * c_theta;
    const double M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    const double I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p->I_z);
    const double heli_1 = I_heli_yy_minus_I_z_c_theta * c_theta;
    const double l_oc_m_h_l_oc = p->m_h * p->l_oc * p->l_oc;
    /* frame arm on column */
    const double M_eps_eps = I_arm_yy + p->I_z + heli_1 + l_oc_m_h_l_oc;
    const double M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    const double arm_1 = c_eps * (I_arm_yy + I_heli_yy - heli_1 + l_oc_m_h_l_oc - I_heli_xx);
    const double arm_2 = c_eps * (arm_1 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    m[0][0] = I_heli_xx + arm_2; /* psi */
    m[0][1] = M_psi_eps;
    m[0][2] = M_psi_theta;
    m[1][0] = M_psi_eps; /* eps */
    m[1][1] = M_eps_eps;
    m[1][2] = M_eps_theta;
    m[2][0] = M_psi_theta; /* theta */
    m[2][1] = M_eps_theta;
    m[2][2] = I_heli_xx;
}

void googol_bias(const struct googol_coordinates *q, const struct googol_rates *v, const struct googol_parameters *p, double h[3])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_b_l_oa = p->m_b * p->l_oa;
    const double m_c_l_ob = p->m_c * p->l_ob;
    /* frame arm on column */
    const double I_arm_yy = p->l_oa * m_b_l_oa + p->l_ob * m_c_l_ob;
    const double omega_arm_z = c_eps * v->psi;
    const double omega_arm_x = s_eps * v->psi;
    const double alpha_arm_x = omega_arm_z * v->eps;
    const double alpha_arm_z = -omega_arm_x * v->eps;
    const double omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    const double a_arm_z = p->g * c_eps;
    const double arm_1 = I_arm_yy * omega_arm_z_omega_arm_x + a_arm_z * (m_b_l_oa - m_c_l_ob);
    /* body fuselage on heli */
    const double mc_heli_z = -p->m_h * p->l_cd;
    const double I_heli_yy = -p->l_cd * mc_heli_z;
    const double I_heli_xx = p->I_x + I_heli_yy;
    /* frame heli on arm */
    const double omega_heli_y = -c_theta * v->eps - omega_arm_z * s_theta;
    const double omega_heli_z = omega_arm_z * c_theta - s_theta * v->eps;
    const double omega_heli_x = omega_arm_x - v->theta;
    const double alpha_heli_y = -alpha_arm_z * s_theta - omega_heli_z * v->theta;
    const double alpha_heli_z = omega_heli_y * v->theta + alpha_arm_z * c_theta;
    const double omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    const double heli_1 = I_heli_yy * alpha_heli_y + omega_heli_z * omega_heli_x * (I_heli_xx - p->I_z);
    const double n_moving_heli_z = p->I_z * alpha_heli_z - p->I_x * omega_heli_y * omega_heli_x;
    const double a_heli_1_x = -p->l_oc * (v->eps * v->eps + omega_arm_z * omega_arm_z);
    const double a_heli_1_y = 2.0 * p->l_oc * alpha_arm_z;
    const double a_heli_1_z = p->l_oc * omega_arm_z_omega_arm_x + a_arm_z;
    const double a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    const double a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    const double f_heli_y = p->m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    const double f_heli_z = p->m_h * a_heli_z - mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y);
    const double n_heli_x = I_heli_xx * alpha_arm_x + omega_heli_y_omega_heli_z * (p->I_z - I_heli_yy) - mc_heli_z * a_heli_y;
    const double n_heli_y = heli_1 + mc_heli_z * (p->g * s_eps + a_heli_1_x);
    const double f_heli_1_y = f_heli_y * c_theta + f_heli_z * s_theta;
    const double f_heli_1_z = f_heli_z * c_theta - f_heli_y * s_theta;
    const double n_heli_1_y = n_moving_heli_z * s_theta + n_heli_y * c_theta;
    const double n_heli_1_z = n_moving_heli_z * c_theta - n_heli_y * s_theta;
    /* frame arm on column */
    const double n_arm_z = 2.0 * I_arm_yy * alpha_arm_z + n_heli_1_z + p->l_oc * f_heli_1_y;
    const double h_eps = arm_1 - n_heli_1_y + p->l_oc * f_heli_1_z;
    const double n_column_z = n_arm_z * c_eps + n_heli_x * s_eps;
    h[0] = n_column_z; /* psi */
    h[1] = h_eps; /* eps */
    h[2] = -n_heli_x; /* theta */
}

void googol_velocity_products(
    const struct googol_coordinates *q,
    const struct googol_rates *v,
    const struct googol_parameters *p,
    double c[3])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    /* frame arm on column */
    const double I_arm_yy = p->m_b * p->l_oa * p->l_oa + p->m_c * p->l_ob * p->l_ob;
    const double omega_arm_z = c_eps * v->psi;
    const double omega_arm_x = s_eps * v->psi;
    const double alpha_arm_x = omega_arm_z * v->eps;
    const double alpha_arm_z = -omega_arm_x * v->eps;
    const double omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    /* body fuselage on heli */
    const double mc_heli_z = -p->m_h * p->l_cd;
    const double I_heli_yy = -p->l_cd * mc_heli_z;
    const double I_heli_xx = p->I_x + I_heli_yy;
    /* frame heli on arm */
    const double omega_heli_y = -c_theta * v->eps - omega_arm_z * s_theta;
    const double omega_heli_z = omega_arm_z * c_theta - s_theta * v->eps;
    const double omega_heli_x = omega_arm_x - v->theta;
    const double alpha_heli_y = -alpha_arm_z * s_theta - omega_heli_z * v->theta;
    const double alpha_heli_z = omega_heli_y * v->theta + alpha_arm_z * c_theta;
    const double omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    const double n_moving_heli_z = p->I_z * alpha_heli_z - p->I_x * omega_heli_y * omega_heli_x;
    const double a_heli_1_x = -p->l_oc * (v->eps * v->eps + omega_arm_z * omega_arm_z);
    const double a_heli_1_y = 2.0 * p->l_oc * alpha_arm_z;
    const double a_heli_1_z = p->l_oc * omega_arm_z_omega_arm_x;
    const double a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    const double a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    const double f_moving_heli_y = p->m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    const double f_moving_heli_z = p->m_h * a_heli_z - mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y);
    const double n_moving_heli_x = I_heli_xx * alpha_arm_x - mc_heli_z * a_heli_y + omega_heli_y_omega_heli_z * (p->I_z - I_heli_yy);
    const double n_moving_heli_y = mc_heli_z * a_heli_1_x + I_heli_yy * alpha_heli_y + omega_heli_z * omega_heli_x * (I_heli_xx - p->I_z);
    const double f_moving_heli_1_y = f_moving_heli_y * c_theta + f_moving_heli_z * s_theta;
    const double f_moving_heli_1_z = f_moving_heli_z * c_theta - f_moving_heli_y * s_theta;
    const double n_moving_heli_1_y = n_moving_heli_y * c_theta + n_moving_heli_z * s_theta;
    const double n_moving_heli_1_z = n_moving_heli_z * c_theta - n_moving_heli_y * s_theta;
    /* frame arm on column */
    const double n_moving_arm_z = 2.0 * I_arm_yy * alpha_arm_z + n_moving_heli_1_z + p->l_oc * f_moving_heli_1_y;
    const double n_moving_column_z = n_moving_arm_z * c_eps + n_moving_heli_x * s_eps;
    c[0] = n_moving_column_z; /* psi */
    c[1] = I_arm_yy * omega_arm_z_omega_arm_x - n_moving_heli_1_y + p->l_oc * f_moving_heli_1_z; /* eps */
    c[2] = -n_moving_heli_x; /* theta */
}

void googol_gravity(const struct googol_coordinates *q, const struct googol_parameters *p, double g[3])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double gravity_1 = p->m_b * p->g * p->l_oa * c_eps - p->m_c * p->g * p->l_ob * c_eps;
    const double gravity_2 = p->m_h * p->g * (p->l_cd * s_eps * c_theta + p->l_oc * c_eps);
    const double g_theta = p->m_h * p->g * p->l_cd * c_eps * s_theta;
    g[0] = 0.0; /* psi */
    g[1] = gravity_1 + gravity_2; /* eps */
    g[2] = g_theta; /* theta */
}

void googol_dissipation(const struct googol_coordinates *q, const struct googol_rates *v, const struct googol_parameters *p, double d[3])
{
    (void)q;
    d[0] = p->c0_psi * v->psi; /* psi */
    d[1] = p->c0_eps * v->eps; /* eps */
    d[2] = p->c0_theta * v->theta; /* theta */
}

void googol_generalized_force(
    const struct googol_coordinates *q,
    const struct googol_inputs *u,
    const struct googol_parameters *p,
    double f[3])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double f_s = u->f_1 + u->f_2;
    const double l_df_f_1 = p->l_df * u->f_1;
    const double l_df_f_2 = p->l_df * u->f_2;
    /* frame arm on column */
    const double arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    const double n_applied_column_z = p->l_oc * f_s * c_eps * s_theta + arm_1;
    f[0] = n_applied_column_z; /* psi */
    f[1] = p->l_oc * f_s * c_theta; /* eps */
    f[2] = l_df_f_1 - l_df_f_2; /* theta */
}

void googol_input_map(const struct googol_coordinates *q, const struct googol_parameters *p, double s[3][2])
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

double googol_kinetic_energy(const struct googol_coordinates *q, const struct googol_rates *v, const struct googol_parameters *p)
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    /* frame arm on column */
    const double omega_arm_z = c_eps * v->psi;
    /* frame heli on arm */
    const double omega_heli_y = -c_theta * v->eps - omega_arm_z * s_theta;
    const double omega_heli_z = omega_arm_z * c_theta - s_theta * v->eps;
    const double omega_heli_x = s_eps * v->psi - v->theta;
    const double l_oc_omega_arm_z = p->l_oc * omega_arm_z;
    const double l_oc_eps_dot = p->l_oc * v->eps;
    const double heli_1 = l_oc_omega_arm_z * c_theta - l_oc_eps_dot * s_theta;
    const double heli_2 = l_oc_omega_arm_z * s_theta + l_oc_eps_dot * c_theta;
    const double l_oa_omega_arm_z = p->l_oa * omega_arm_z;
    const double l_oa_eps_dot = p->l_oa * v->eps;
    /* body beam on arm */
    const double beam_1 = 0.5 * p->m_b * (l_oa_omega_arm_z * l_oa_omega_arm_z + l_oa_eps_dot * l_oa_eps_dot);
    const double l_ob_omega_arm_z = p->l_ob * omega_arm_z;
    const double l_ob_eps_dot = p->l_ob * v->eps;
    /* body counterweight on arm */
    const double counterweight_1 = 0.5 * p->m_c * (l_ob_omega_arm_z * l_ob_omega_arm_z + l_ob_eps_dot * l_ob_eps_dot);
    const double l_cd_omega_heli_y = p->l_cd * omega_heli_y;
    /* body fuselage on heli */
    const double fuselage_1 = heli_1 + p->l_cd * omega_heli_x;
    const double fuselage_2 = l_cd_omega_heli_y * l_cd_omega_heli_y + fuselage_1 * fuselage_1;
    const double fuselage_3 = p->m_h * (heli_2 * heli_2 + fuselage_2);
    const double fuselage_4 = 0.5 * (fuselage_3 + p->I_x * omega_heli_x * omega_heli_x + p->I_z * omega_heli_z * omega_heli_z);
    return beam_1 + counterweight_1 + fuselage_4;
}

double googol_potential_energy(const struct googol_coordinates *q, const struct googol_parameters *p)
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double c_theta = cos(q->theta);
    /* body counterweight on arm */
    const double counterweight_1 = p->m_b * p->g * p->l_oa * s_eps - p->m_c * p->g * p->l_ob * s_eps;
    /* body fuselage on heli */
    const double fuselage_1 = p->m_h * p->g * (p->l_oc * s_eps - p->l_cd * c_eps * c_theta);
    return counterweight_1 + fuselage_1;
}

void googol_inverse_dynamics(
    const struct googol_state *x,
    const struct googol_accelerations *a,
    const struct googol_inputs *u,
    const struct googol_parameters *p,
    double r[3])
{
    const struct googol_coordinates *q = &x->q;
    const struct googol_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_b_l_oa = p->m_b * p->l_oa;
    const double m_c_l_ob = p->m_c * p->l_ob;
    /* frame arm on column */
    const double I_arm_yy = p->l_oa * m_b_l_oa + p->l_ob * m_c_l_ob;
    const double omega_arm_z = c_eps * v->psi;
    const double omega_arm_x = s_eps * v->psi;
    const double alpha_arm_z = -omega_arm_x * v->eps;
    const double omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    const double a_arm_z = p->g * c_eps;
    const double arm_1 = a_arm_z * (m_b_l_oa - m_c_l_ob);
    const double alpha_arm_x = omega_arm_z * v->eps + s_eps * a->psi;
    const double alpha_arm_z_2 = c_eps * a->psi + alpha_arm_z;
    const double arm_2 = arm_1 + I_arm_yy * omega_arm_z_omega_arm_x + I_arm_yy * a->eps;
    /* body fuselage on heli */
    const double mc_heli_z = -p->m_h * p->l_cd;
    const double I_heli_yy = -p->l_cd * mc_heli_z;
    const double I_heli_xx = p->I_x + I_heli_yy;
    /* frame heli on arm */
    const double omega_heli_y = -c_theta * v->eps - omega_arm_z * s_theta;
    const double omega_heli_z = omega_arm_z * c_theta - s_theta * v->eps;
    const double omega_heli_x = omega_arm_x - v->theta;
    const double omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    const double alpha_heli_y = -omega_heli_z * v->theta - c_theta * a->eps - alpha_arm_z_2 * s_theta;
    const double alpha_heli_z = alpha_arm_z_2 * c_theta - s_theta * a->eps + omega_heli_y * v->theta;
    const double heli_1 = omega_heli_z * omega_heli_x * (I_heli_xx - p->I_z) + I_heli_yy * alpha_heli_y;
    const double n_net_heli_z = p->I_z * alpha_heli_z - p->I_x * omega_heli_y * omega_heli_x;
    const double a_heli_1_x = -p->l_oc * (v->eps * v->eps + omega_arm_z * omega_arm_z);
    const double a_heli_1_y = p->l_oc * (alpha_arm_z_2 + alpha_arm_z);
    const double a_heli_1_z = a_arm_z + p->l_oc * (a->eps + omega_arm_z_omega_arm_x);
    /* force rotor_2 on heli */
    const double n_applied_heli_x = p->l_df * u->f_2 - p->l_df * u->f_1;
    /* frame heli on arm */
    const double a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    const double a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    const double f_net_heli_y = p->m_h * a_heli_y + mc_heli_z * (a->theta - alpha_arm_x + omega_heli_y_omega_heli_z);
    const double heli_2 = I_heli_xx * (alpha_arm_x - a->theta) - mc_heli_z * a_heli_y + omega_heli_y_omega_heli_z * (p->I_z - I_heli_yy);
    const double n_net_heli_y = heli_1 + mc_heli_z * (p->g * s_eps + a_heli_1_x);
    const double f_net_heli_z = p->m_h * a_heli_z
        - mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y)
        - u->f_1
        - u->f_2;
    const double f_net_heli_1_y = f_net_heli_y * c_theta + f_net_heli_z * s_theta;
    const double f_net_heli_1_z = f_net_heli_z * c_theta - f_net_heli_y * s_theta;
    const double n_net_heli_1_y = n_net_heli_y * c_theta + n_net_heli_z * s_theta;
    const double n_net_heli_1_z = n_net_heli_z * c_theta - n_net_heli_y * s_theta;
    /* frame arm on column */
    const double n_net_arm_z = I_arm_yy * alpha_arm_z_2 + I_arm_yy * alpha_arm_z + n_net_heli_1_z + p->l_oc * f_net_heli_1_y;
    const double n_net_column_z = n_net_arm_z * c_eps + s_eps * (heli_2 - n_applied_heli_x);
    r[0] = p->c0_psi * v->psi + n_net_column_z; /* psi */
    r[1] = p->c0_eps * v->eps + arm_2 - n_net_heli_1_y + p->l_oc * f_net_heli_1_z; /* eps */
    r[2] = p->c0_theta * v->theta + n_applied_heli_x - heli_2; /* theta */
}

void googol_outputs(const struct googol_state *x, const struct googol_parameters *p, struct googol_outputs *y)
{
    const struct googol_coordinates *q = &x->q;
    (void)p;
    y->psi = q->psi;
    y->eps = q->eps;
    y->theta = q->theta;
}

void googol_pivots(const struct googol_state *x, const struct googol_parameters *p, double d[3])
{
    const struct googol_coordinates *q = &x->q;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    /* frame arm on column */
    const double I_arm_yy = p->m_b * p->l_oa * p->l_oa + p->m_c * p->l_ob * p->l_ob;
    /* body fuselage on heli */
    const double mc_heli_z = -p->m_h * p->l_cd;
    const double I_heli_yy = -p->l_cd * mc_heli_z;
    const double I_heli_xx = p->I_x + I_heli_yy;
    /* frame heli on arm */
    const double M_eps_theta = -p->l_oc * mc_heli_z * s_theta;
    const double l_oc_mc_heli_z_c_theta = p->l_oc * mc_heli_z * c_theta;
    const double M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    const double I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p->I_z);
    const double heli_1 = I_heli_yy_minus_I_z_c_theta * c_theta;
    const double l_oc_m_h_l_oc = p->m_h * p->l_oc * p->l_oc;
    /* frame arm on column */
    const double M_eps_eps = I_arm_yy + p->I_z + heli_1 + l_oc_m_h_l_oc;
    const double M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    const double arm_1 = c_eps * (I_arm_yy + I_heli_yy - heli_1 + l_oc_m_h_l_oc - I_heli_xx);
    const double arm_2 = c_eps * (arm_1 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / I_heli_xx;
    const double l_theta_eps = M_eps_theta * inv_theta;
    const double pivot_eps = M_eps_eps - M_eps_theta * l_theta_eps;
    const double solve_1 = M_psi_eps - M_psi_theta * l_theta_eps;
    const double solve_2 = I_heli_xx + arm_2 - solve_1 * solve_1 / pivot_eps;
    const double pivot_psi = solve_2 - M_psi_theta * M_psi_theta * inv_theta;
    d[0] = pivot_psi; /* psi */
    d[1] = pivot_eps; /* eps */
    d[2] = I_heli_xx; /* theta */
}

int googol_forward_dynamics(
    const struct googol_state *x,
    const struct googol_inputs *u,
    const struct googol_parameters *p,
    struct googol_accelerations *a)
{
    const struct googol_coordinates *q = &x->q;
    const struct googol_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_b_l_oa = p->m_b * p->l_oa;
    const double m_c_l_ob = p->m_c * p->l_ob;
    /* frame arm on column */
    const double I_arm_yy = p->l_oa * m_b_l_oa + p->l_ob * m_c_l_ob;
    const double omega_arm_z = c_eps * v->psi;
    const double omega_arm_x = s_eps * v->psi;
    const double alpha_arm_x = omega_arm_z * v->eps;
    const double alpha_arm_z = -omega_arm_x * v->eps;
    const double omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    const double a_arm_z = p->g * c_eps;
    const double arm_1 = I_arm_yy * omega_arm_z_omega_arm_x + a_arm_z * (m_b_l_oa - m_c_l_ob);
    /* body fuselage on heli */
    const double mc_heli_z = -p->m_h * p->l_cd;
    const double I_heli_yy = -p->l_cd * mc_heli_z;
    const double I_heli_xx = p->I_x + I_heli_yy;
    /* frame heli on arm */
    const double omega_heli_y = -c_theta * v->eps - omega_arm_z * s_theta;
    const double omega_heli_z = omega_arm_z * c_theta - s_theta * v->eps;
    const double omega_heli_x = omega_arm_x - v->theta;
    const double alpha_heli_y = -alpha_arm_z * s_theta - omega_heli_z * v->theta;
    const double alpha_heli_z = omega_heli_y * v->theta + alpha_arm_z * c_theta;
    const double omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    const double heli_1 = I_heli_yy * alpha_heli_y + omega_heli_z * omega_heli_x * (I_heli_xx - p->I_z);
    const double n_moving_heli_z = p->I_z * alpha_heli_z - p->I_x * omega_heli_y * omega_heli_x;
    const double M_eps_theta = -p->l_oc * mc_heli_z * s_theta;
    const double l_oc_mc_heli_z_c_theta = p->l_oc * mc_heli_z * c_theta;
    const double M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    const double I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p->I_z);
    const double heli_2 = I_heli_yy_minus_I_z_c_theta * c_theta;
    const double a_heli_1_x = -p->l_oc * (v->eps * v->eps + omega_arm_z * omega_arm_z);
    const double a_heli_1_y = 2.0 * p->l_oc * alpha_arm_z;
    const double a_heli_1_z = p->l_oc * omega_arm_z_omega_arm_x + a_arm_z;
    const double l_oc_m_h_l_oc = p->m_h * p->l_oc * p->l_oc;
    const double a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    const double a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    const double f_heli_y = p->m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    const double f_heli_z = p->m_h * a_heli_z - mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y);
    const double n_heli_x = I_heli_xx * alpha_arm_x + omega_heli_y_omega_heli_z * (p->I_z - I_heli_yy) - mc_heli_z * a_heli_y;
    const double n_heli_y = heli_1 + mc_heli_z * (p->g * s_eps + a_heli_1_x);
    const double n_heli_1_y = n_moving_heli_z * s_theta + n_heli_y * c_theta;
    const double n_heli_1_z = n_moving_heli_z * c_theta - n_heli_y * s_theta;
    const double f_net_heli_z = f_heli_z - u->f_1 - u->f_2;
    const double f_net_heli_1_y = f_heli_y * c_theta + f_net_heli_z * s_theta;
    const double f_net_heli_1_z = f_net_heli_z * c_theta - f_heli_y * s_theta;
    /* frame arm on column */
    const double M_eps_eps = I_arm_yy + p->I_z + heli_2 + l_oc_m_h_l_oc;
    const double M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    const double arm_2 = c_eps * (I_arm_yy + I_heli_yy - heli_2 + l_oc_m_h_l_oc - I_heli_xx);
    const double arm_3 = c_eps * (arm_2 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    const double n_net_arm_z = 2.0 * I_arm_yy * alpha_arm_z + n_heli_1_z + p->l_oc * f_net_heli_1_y;
    /* force rotor_2 on heli */
    const double n_applied_heli_x = p->l_df * u->f_2 - p->l_df * u->f_1;
    /* frame arm on column */
    const double n_net_column_z = n_net_arm_z * c_eps + s_eps * (n_heli_x - n_applied_heli_x);
    /* balance of forces */
    const double tau_eps = n_heli_1_y - p->c0_eps * v->eps - arm_1 - p->l_oc * f_net_heli_1_z;
    const double tau_theta = n_heli_x - p->c0_theta * v->theta - n_applied_heli_x;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / I_heli_xx;
    const double l_theta_psi = M_psi_theta * inv_theta;
    const double l_theta_eps = M_eps_theta * inv_theta;
    const double pivot_eps = M_eps_eps - M_eps_theta * l_theta_eps;
    const double inv_eps = 1.0 / pivot_eps;
    const double solve_1 = M_psi_eps - M_psi_theta * l_theta_eps;
    const double l_eps_psi = inv_eps * solve_1;
    const double pivot_psi = I_heli_xx + arm_3 - solve_1 * l_eps_psi - M_psi_theta * l_theta_psi;
    const double solve_2 = tau_eps - tau_theta * l_theta_eps;
    const double solve_3 = p->c0_psi * v->psi + n_net_column_z + l_eps_psi * solve_2 + tau_theta * l_theta_psi;
    const double psi_ddot = -solve_3 / pivot_psi;
    const double eps_ddot = inv_eps * solve_2 - l_eps_psi * psi_ddot;
    const double theta_ddot = tau_theta * inv_theta - l_theta_psi * psi_ddot - l_theta_eps * eps_ddot;
    if (!(I_heli_xx > 0.0)) {
        return 3;
    }
    if (!(pivot_eps > 0.0)) {
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

int googol_linearize(
    const struct googol_state *x,
    const struct googol_inputs *u,
    const struct googol_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2])
{
    const struct googol_coordinates *q = &x->q;
    const struct googol_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_b_l_oa = p->m_b * p->l_oa;
    const double m_c_l_ob = p->m_c * p->l_ob;
    const double f_s = u->f_1 + u->f_2;
    /* frame arm on column */
    const double mc_arm_x = m_b_l_oa - m_c_l_ob;
    const double I_arm_yy = p->l_oa * m_b_l_oa + p->l_ob * m_c_l_ob;
    const double omega_arm_z = c_eps * v->psi;
    const double omega_arm_x = s_eps * v->psi;
    const double alpha_arm_x = omega_arm_z * v->eps;
    const double alpha_arm_z = -omega_arm_x * v->eps;
    const double omega_arm_z_sq = omega_arm_z * omega_arm_z;
    const double omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    const double I_arm_yy_alpha_arm_z = I_arm_yy * alpha_arm_z;
    const double arm_1 = omega_arm_z_sq - omega_arm_x * omega_arm_x;
    const double a_arm_z = p->g * c_eps;
    const double a_arm_x = p->g * s_eps;
    /* body fuselage on heli */
    const double mc_heli_z = -p->m_h * p->l_cd;
    const double I_heli_yy = -p->l_cd * mc_heli_z;
    const double I_heli_xx = p->I_x + I_heli_yy;
    const double s_theta_eps_dot = s_theta * v->eps;
    const double omega_arm_z_c_theta = omega_arm_z * c_theta;
    /* frame heli on arm */
    const double omega_heli_y = -c_theta * v->eps - omega_arm_z * s_theta;
    const double omega_heli_z = omega_arm_z_c_theta - s_theta_eps_dot;
    const double omega_heli_x = omega_arm_x - v->theta;
    const double omega_heli_z_theta_dot = omega_heli_z * v->theta;
    const double omega_heli_y_theta_dot = omega_heli_y * v->theta;
    const double omega_heli_z_omega_heli_x = omega_heli_z * omega_heli_x;
    const double omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    const double omega_heli_y_sq = omega_heli_y * omega_heli_y;
    const double heli_1 = mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y_sq);
    const double I_z_minus_I_heli_yy = p->I_z - I_heli_yy;
    const double heli_2 = omega_heli_y_omega_heli_z * I_z_minus_I_heli_yy;
    const double omega_heli_z_sq = omega_heli_z * omega_heli_z;
    const double omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    const double I_heli_xx_minus_I_z = I_heli_xx - p->I_z;
    const double heli_3 = omega_heli_z_omega_heli_x * I_heli_xx_minus_I_z;
    const double heli_4 = p->I_x * omega_heli_y_omega_heli_x;
    const double heli_5 = I_heli_yy * (-alpha_arm_z * s_theta - omega_heli_z_theta_dot) + heli_3;
    const double n_moving_heli_z = -heli_4 - p->I_z * (-omega_heli_y_theta_dot - alpha_arm_z * c_theta);
    const double M_eps_theta = -p->l_oc * mc_heli_z * s_theta;
    const double l_oc_mc_heli_z_c_theta = p->l_oc * mc_heli_z * c_theta;
    const double M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    const double I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p->I_z);
    const double heli_6 = I_heli_yy_minus_I_z_c_theta * c_theta;
    const double a_heli_1_x = -p->l_oc * (v->eps * v->eps + omega_arm_z_sq);
    const double a_heli_1_y = 2.0 * p->l_oc * alpha_arm_z;
    const double a_heli_1_z = p->l_oc * omega_arm_z_omega_arm_x + a_arm_z;
    const double l_oc_m_h_l_oc = p->m_h * p->l_oc * p->l_oc;
    const double a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    const double a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    const double f_heli_y = p->m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    const double heli_7 = mc_heli_z * (a_arm_x + a_heli_1_x);
    const double n_heli_x = I_heli_xx * alpha_arm_x + heli_2 - mc_heli_z * a_heli_y;
    const double n_heli_y = heli_5 + heli_7;
    const double n_heli_1_y = n_moving_heli_z * s_theta + n_heli_y * c_theta;
    const double n_heli_1_z = n_moving_heli_z * c_theta - n_heli_y * s_theta;
    const double f_net_heli_z = p->m_h * a_heli_z - heli_1 - f_s;
    const double f_net_heli_1_y = f_heli_y * c_theta + f_net_heli_z * s_theta;
    const double f_net_heli_1_z = f_net_heli_z * c_theta - f_heli_y * s_theta;
    /* frame arm on column */
    const double M_eps_eps = I_arm_yy + p->I_z + heli_6 + l_oc_m_h_l_oc;
    const double M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    const double arm_2 = c_eps * (I_arm_yy + I_heli_yy - heli_6 + l_oc_m_h_l_oc - I_heli_xx);
    const double arm_3 = c_eps * (arm_2 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    const double n_net_arm_z = 2.0 * I_arm_yy_alpha_arm_z + n_heli_1_z + p->l_oc * f_net_heli_1_y;
    const double arm_4 = I_arm_yy * omega_arm_z_omega_arm_x + mc_arm_x * a_arm_z - n_heli_1_y + p->l_oc * f_net_heli_1_z;
    /* force rotor_2 on heli */
    const double n_applied_heli_x = p->l_df * u->f_2 - p->l_df * u->f_1;
    const double c_eps_s_theta = c_eps * s_theta;
    const double c_eps_c_theta = c_eps * c_theta;
    const double l_oc_c_theta = p->l_oc * c_theta;
    const double c_eps_eps_dot = c_eps * v->eps;
    const double s_eps_eps_dot = s_eps * v->eps;
    const double omega_arm_x_s_theta = omega_arm_x * s_theta;
    const double omega_arm_x_c_theta = omega_arm_x * c_theta;
    /* frame arm on column */
    const double n_net_column_z = n_net_arm_z * c_eps + s_eps * (n_heli_x - n_applied_heli_x);
    /* balance of forces */
    const double tau_theta = n_heli_x - p->c0_theta * v->theta - n_applied_heli_x;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / I_heli_xx;
    const double l_theta_psi = M_psi_theta * inv_theta;
    const double l_theta_eps = M_eps_theta * inv_theta;
    const double pivot_eps = M_eps_eps - M_eps_theta * l_theta_eps;
    const double inv_eps = 1.0 / pivot_eps;
    const double solve_1 = M_psi_eps - M_psi_theta * l_theta_eps;
    const double l_eps_psi = inv_eps * solve_1;
    const double pivot_psi = I_heli_xx + arm_3 - solve_1 * l_eps_psi - M_psi_theta * l_theta_psi;
    const double inv_psi = 1.0 / pivot_psi;
    const double solve_2 = tau_theta * l_theta_eps + p->c0_eps * v->eps + arm_4;
    const double psi_ddot = -inv_psi * (p->c0_psi * v->psi + n_net_column_z - l_eps_psi * solve_2 + tau_theta * l_theta_psi);
    const double eps_ddot = -inv_eps * solve_2 - l_eps_psi * psi_ddot;
    const double theta_ddot = tau_theta * inv_theta - l_theta_psi * psi_ddot - l_theta_eps * eps_ddot;
    const double l_oc_c_eps_s_theta = p->l_oc * c_eps * s_theta;
    const double l_df_s_eps = p->l_df * s_eps;
    const double two_omega_arm_z = 2.0 * omega_arm_z;
    /* derivatives with respect to eps */
    const double by_eps_1 = omega_heli_z * omega_arm_x_s_theta - omega_heli_y * omega_arm_x_c_theta;
    const double two_omega_heli_x = 2.0 * omega_heli_x;
    const double two_omega_heli_y = 2.0 * omega_heli_y;
    const double by_eps_2 = mc_heli_z * (omega_arm_z * two_omega_heli_x + omega_arm_x_s_theta * two_omega_heli_y);
    const double by_eps_3 = I_heli_xx_minus_I_z * (omega_arm_z * omega_heli_z - omega_heli_x * omega_arm_x_c_theta);
    const double by_eps_4 = mc_heli_z * (a_arm_z + p->l_oc * omega_arm_x * two_omega_arm_z);
    const double l_oc_arm_1_minus_a_arm_x = p->l_oc * arm_1 - a_arm_x;
    /* derivatives with respect to psi_dot */
    const double by_psi_dot_1 = omega_arm_x * c_eps + omega_arm_z * s_eps;
    const double by_psi_dot_2 = omega_heli_z * c_eps_s_theta - omega_heli_y * c_eps_c_theta;
    const double by_psi_dot_3 = mc_heli_z * (two_omega_heli_x * s_eps - c_eps_s_theta * two_omega_heli_y);
    const double by_psi_dot_4 = I_heli_xx_minus_I_z * (omega_heli_x * c_eps_c_theta + omega_heli_z * s_eps);
    const double by_psi_dot_5 = p->l_oc * mc_heli_z * two_omega_arm_z * c_eps;
    const double two_l_oc_s_eps_eps_dot = 2.0 * p->l_oc * s_eps_eps_dot;
    const double l_oc_by_psi_dot_1 = p->l_oc * by_psi_dot_1;
    const double by_psi_dot_6 = two_l_oc_s_eps_eps_dot * c_theta + l_oc_by_psi_dot_1 * s_theta;
    const double by_psi_dot_7 = p->m_h * (l_oc_by_psi_dot_1 * c_theta - two_l_oc_s_eps_eps_dot * s_theta);
    const double by_psi_dot_8 = p->m_h * by_psi_dot_6 + mc_heli_z * (c_eps_eps_dot + by_psi_dot_2);
    const double by_psi_dot_9 = by_psi_dot_7 - by_psi_dot_3;
    const double by_psi_dot_10 = I_heli_yy * (c_eps_c_theta * v->theta - s_eps_eps_dot * s_theta);
    const double by_psi_dot_11 = p->I_z * (s_eps_eps_dot * c_theta + c_eps_s_theta * v->theta);
    const double by_psi_dot_12 = I_heli_xx * c_eps_eps_dot - I_z_minus_I_heli_yy * by_psi_dot_2;
    const double by_psi_dot_13 = p->I_x * (omega_heli_x * c_eps_s_theta - omega_heli_y * s_eps) - by_psi_dot_11;
    const double by_psi_dot_14 = mc_heli_z * by_psi_dot_6 + by_psi_dot_12;
    const double by_psi_dot_15 = by_psi_dot_4 - by_psi_dot_5 - by_psi_dot_10;
    const double by_psi_dot_16 = by_psi_dot_15 * c_theta + by_psi_dot_13 * s_theta;
    const double by_psi_dot_17 = by_psi_dot_13 * c_theta - by_psi_dot_15 * s_theta;
    const double by_psi_dot_18 = p->l_oc * (by_psi_dot_9 * c_theta + by_psi_dot_8 * s_theta);
    const double by_psi_dot_19 = p->l_oc * (by_psi_dot_9 * s_theta - by_psi_dot_8 * c_theta);
    const double by_psi_dot_20 = by_psi_dot_17 - 2.0 * I_arm_yy * s_eps_eps_dot + by_psi_dot_19;
    const double by_psi_dot_21 = p->c0_psi + by_psi_dot_20 * c_eps + by_psi_dot_14 * s_eps;
    const double by_psi_dot_22 = by_psi_dot_16 - by_psi_dot_18 - I_arm_yy * by_psi_dot_1;
    const double by_psi_dot_23 = by_psi_dot_22 - l_theta_eps * by_psi_dot_14;
    const double d_psi_ddot_by_psi_dot = inv_psi * (-l_theta_psi * by_psi_dot_14 - by_psi_dot_21 - l_eps_psi * by_psi_dot_23);
    const double d_eps_ddot_by_psi_dot = inv_eps * by_psi_dot_23 - l_eps_psi * d_psi_ddot_by_psi_dot;
    const double d_theta_ddot_by_psi_dot = inv_theta * by_psi_dot_14
        - l_theta_psi * d_psi_ddot_by_psi_dot
        - l_theta_eps * d_eps_ddot_by_psi_dot;
    /* derivatives with respect to eps_dot */
    const double by_eps_dot_1 = omega_heli_z * c_theta + omega_heli_y * s_theta;
    const double by_eps_dot_2 = mc_heli_z * two_omega_heli_y * c_theta;
    const double two_l_oc_omega_arm_x = 2.0 * p->l_oc * omega_arm_x;
    const double two_l_oc_omega_arm_x_c_theta = two_l_oc_omega_arm_x * c_theta;
    const double by_eps_dot_3 = p->m_h * two_l_oc_omega_arm_x_c_theta + mc_heli_z * (omega_arm_z + by_eps_dot_1);
    const double by_eps_dot_4 = by_eps_dot_2 - p->m_h * two_l_oc_omega_arm_x * s_theta;
    const double by_eps_dot_5 = I_heli_yy * (s_theta * v->theta + omega_arm_x_s_theta);
    const double by_eps_dot_6 = p->I_z * (c_theta * v->theta + omega_arm_x_c_theta);
    const double by_eps_dot_7 = by_eps_dot_5 - I_heli_xx_minus_I_z * omega_heli_x * s_theta;
    const double by_eps_dot_8 = p->I_x * omega_heli_x * c_theta - by_eps_dot_6;
    const double by_eps_dot_9 = mc_heli_z * two_l_oc_omega_arm_x_c_theta + I_heli_xx * omega_arm_z - I_z_minus_I_heli_yy * by_eps_dot_1;
    const double by_eps_dot_10 = by_eps_dot_7 - 2.0 * p->l_oc * mc_heli_z * v->eps;
    const double by_eps_dot_11 = by_eps_dot_10 * c_theta + by_eps_dot_8 * s_theta;
    const double by_eps_dot_12 = by_eps_dot_8 * c_theta - by_eps_dot_10 * s_theta;
    const double by_eps_dot_13 = p->l_oc * (by_eps_dot_4 * c_theta + by_eps_dot_3 * s_theta);
    const double by_eps_dot_14 = p->l_oc * (by_eps_dot_4 * s_theta - by_eps_dot_3 * c_theta);
    const double by_eps_dot_15 = c_eps * (by_eps_dot_12 - 2.0 * I_arm_yy * omega_arm_x + by_eps_dot_14);
    const double by_eps_dot_16 = p->c0_eps + by_eps_dot_13 - by_eps_dot_11 + l_theta_eps * by_eps_dot_9;
    const double by_eps_dot_17 = l_eps_psi * by_eps_dot_16 - by_eps_dot_15 - by_eps_dot_9 * s_eps;
    const double d_psi_ddot_by_eps_dot = inv_psi * (by_eps_dot_17 - l_theta_psi * by_eps_dot_9);
    const double d_eps_ddot_by_eps_dot = -inv_eps * by_eps_dot_16 - l_eps_psi * d_psi_ddot_by_eps_dot;
    const double d_theta_ddot_by_eps_dot = inv_theta * by_eps_dot_9
        - l_theta_psi * d_psi_ddot_by_eps_dot
        - l_theta_eps * d_eps_ddot_by_eps_dot;
    const double two_mc_heli_z_omega_heli_x = 2.0 * mc_heli_z * omega_heli_x;
    /* derivatives with respect to theta_dot */
    const double by_theta_dot_1 = I_heli_xx_minus_I_z * (s_theta_eps_dot - omega_arm_z_c_theta) - I_heli_yy * omega_heli_z;
    const double by_theta_dot_2 = p->I_z * omega_heli_y + p->I_x * omega_heli_y;
    const double by_theta_dot_3 = by_theta_dot_1 * c_theta + by_theta_dot_2 * s_theta;
    const double by_theta_dot_4 = by_theta_dot_1 * s_theta - by_theta_dot_2 * c_theta;
    const double by_theta_dot_5 = c_eps * (p->l_oc * two_mc_heli_z_omega_heli_x * s_theta - by_theta_dot_4);
    const double by_theta_dot_6 = by_theta_dot_3 - p->l_oc * two_mc_heli_z_omega_heli_x * c_theta + p->c0_theta * l_theta_eps;
    const double d_psi_ddot_by_theta_dot = -inv_psi * (by_theta_dot_5 + l_eps_psi * by_theta_dot_6 - p->c0_theta * l_theta_psi);
    const double d_eps_ddot_by_theta_dot = inv_eps * by_theta_dot_6 - l_eps_psi * d_psi_ddot_by_theta_dot;
    const double d_theta_ddot_by_theta_dot = -p->c0_theta * inv_theta
        - l_theta_psi * d_psi_ddot_by_theta_dot
        - l_theta_eps * d_eps_ddot_by_theta_dot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = alpha_arm_x + psi_ddot * s_eps;
    const double slopes_2 = alpha_arm_z + psi_ddot * c_eps;
    const double slopes_3 = p->l_oc * (-alpha_arm_z - slopes_2);
    const double slopes_4 = a_arm_z + p->l_oc * (omega_arm_z_omega_arm_x + eps_ddot);
    const double slopes_5 = omega_heli_z_theta_dot + eps_ddot * c_theta + slopes_2 * s_theta;
    const double slopes_6 = eps_ddot * s_theta - omega_heli_y_theta_dot - slopes_2 * c_theta;
    const double slopes_1_minus_theta_ddot = slopes_1 - theta_ddot;
    const double slopes_7 = slopes_3 * c_theta + slopes_4 * s_theta;
    const double slopes_8 = slopes_4 * c_theta - slopes_3 * s_theta;
    const double m_h_slopes_7 = p->m_h * slopes_7;
    const double m_h_slopes_8 = p->m_h * slopes_8;
    const double slopes_9 = mc_heli_z * (slopes_1_minus_theta_ddot - omega_heli_y_omega_heli_z) + m_h_slopes_7;
    const double heli_4_plus_I_z_slopes_6 = heli_4 + p->I_z * slopes_6;
    const double slopes_10 = I_heli_xx * slopes_1_minus_theta_ddot + heli_2 + mc_heli_z * slopes_7;
    const double slopes_11 = heli_3 - I_heli_yy * slopes_5 + heli_7;
    const double slopes_12 = m_h_slopes_8 - heli_1 - f_s;
    const double slopes_9_c_theta = slopes_9 * c_theta;
    const double slopes_12_s_theta = slopes_12 * s_theta;
    const double slopes_11_s_theta = slopes_11 * s_theta;
    const double slopes_13 = heli_4_plus_I_z_slopes_6 * c_theta;
    const double slopes_14 = p->l_oc * (slopes_12_s_theta - slopes_9_c_theta) - slopes_13 - slopes_11_s_theta;
    const double slopes_15 = s_eps * (slopes_14 + I_arm_yy_alpha_arm_z + I_arm_yy * slopes_2);
    const double slopes_16 = c_eps * (slopes_10 - n_applied_heli_x);
    const double slopes_17 = p->l_oc * (alpha_arm_x + slopes_1);
    const double slopes_18 = l_oc_arm_1_minus_a_arm_x * s_theta + slopes_17 * c_theta;
    const double slopes_19 = p->m_h * (l_oc_arm_1_minus_a_arm_x * c_theta - slopes_17 * s_theta);
    const double slopes_20 = p->m_h * slopes_18 - mc_heli_z * (by_eps_1 - slopes_2);
    const double slopes_19_minus_by_eps_2 = slopes_19 - by_eps_2;
    const double slopes_21 = I_heli_yy * (omega_arm_x_c_theta * v->theta + slopes_1 * s_theta);
    const double slopes_22 = p->I_z * (omega_arm_x_s_theta * v->theta - slopes_1 * c_theta);
    const double slopes_23 = I_z_minus_I_heli_yy * by_eps_1 + I_heli_xx * slopes_2;
    const double slopes_24 = p->I_x * (-omega_arm_z * omega_heli_y - omega_heli_x * omega_arm_x_s_theta) + slopes_22;
    const double slopes_25 = slopes_23 + mc_heli_z * slopes_18;
    const double slopes_26 = by_eps_3 + slopes_21 + by_eps_4;
    const double slopes_27 = slopes_26 * c_theta + slopes_24 * s_theta;
    const double slopes_28 = slopes_24 * c_theta - slopes_26 * s_theta;
    const double slopes_29 = p->l_oc * (slopes_20 * s_theta + slopes_19_minus_by_eps_2 * c_theta);
    const double slopes_30 = p->l_oc * (slopes_19_minus_by_eps_2 * s_theta - slopes_20 * c_theta);
    const double slopes_31 = slopes_28 + slopes_30 - I_arm_yy * alpha_arm_x - I_arm_yy * slopes_1;
    const double slopes_32 = slopes_16 + slopes_25 * s_eps;
    const double slopes_33 = slopes_31 * c_eps - slopes_15 + slopes_32;
    const double slopes_34 = m_h_slopes_8 - mc_heli_z * (omega_heli_y_sq - omega_heli_z_sq);
    const double slopes_35 = mc_heli_z * omega_heli_z * two_omega_heli_y - m_h_slopes_7;
    const double slopes_36 = omega_heli_y_omega_heli_x * I_heli_xx_minus_I_z + I_heli_yy * slopes_6;
    const double slopes_37 = p->I_x * omega_heli_z_omega_heli_x - p->I_z * slopes_5;
    const double slopes_38 = I_z_minus_I_heli_yy * (omega_heli_z_sq - omega_heli_y_sq) - mc_heli_z * slopes_8;
    const double slopes_39 = slopes_34 * c_theta - slopes_9 * s_theta;
    const double slopes_40 = slopes_12 * c_theta + slopes_35 * s_theta;
    const double slopes_41 = slopes_9_c_theta + slopes_34 * s_theta;
    const double slopes_42 = slopes_11_s_theta - slopes_36 * c_theta;
    const double slopes_43 = slopes_11 * c_theta + slopes_36 * s_theta;
    const double slopes_44 = slopes_37 * c_theta + heli_4_plus_I_z_slopes_6 * s_theta;
    const double slopes_45 = slopes_37 * s_theta - slopes_13 - slopes_42;
    const double slopes_46 = p->l_oc * (slopes_35 * c_theta - slopes_12_s_theta + slopes_41);
    const double slopes_47 = slopes_44 - slopes_43 + p->l_oc * (slopes_40 - slopes_39);
    /* derivatives with respect to eps */
    const double by_eps_5 = slopes_27 - slopes_29 - I_arm_yy * arm_1 + mc_arm_x * a_arm_x;
    const double by_eps_6 = by_eps_5 - l_theta_eps * slopes_25;
    const double d_psi_ddot_by_eps = inv_psi * (-l_theta_psi * slopes_25 - slopes_33 - l_eps_psi * by_eps_6);
    const double d_eps_ddot_by_eps = inv_eps * by_eps_6 - l_eps_psi * d_psi_ddot_by_eps;
    const double d_theta_ddot_by_eps = inv_theta * slopes_25 - l_theta_psi * d_psi_ddot_by_eps - l_theta_eps * d_eps_ddot_by_eps;
    /* derivatives with respect to theta */
    const double by_theta_1 = slopes_38 * s_eps - slopes_47 * c_eps;
    const double by_theta_2 = slopes_45 - slopes_46 + l_theta_eps * slopes_38;
    const double d_psi_ddot_by_theta = inv_psi * (by_theta_1 - l_eps_psi * by_theta_2 + l_theta_psi * slopes_38);
    const double d_eps_ddot_by_theta = inv_eps * by_theta_2 - l_eps_psi * d_psi_ddot_by_theta;
    const double d_theta_ddot_by_theta = -l_theta_psi * d_psi_ddot_by_theta - inv_theta * slopes_38 - l_theta_eps * d_eps_ddot_by_theta;
    const double l_df_l_theta_eps = p->l_df * l_theta_eps;
    /* derivatives with respect to f_1 */
    const double by_f_1_1 = l_oc_c_theta - l_df_l_theta_eps;
    const double l_df_l_theta_psi = p->l_df * l_theta_psi;
    const double by_f_1_2 = l_oc_c_eps_s_theta - l_df_s_eps - l_eps_psi * by_f_1_1 - l_df_l_theta_psi;
    const double d_psi_ddot_by_f_1 = inv_psi * by_f_1_2;
    const double l_df_inv_theta = p->l_df * inv_theta;
    const double d_eps_ddot_by_f_1 = inv_eps * by_f_1_1 - l_eps_psi * d_psi_ddot_by_f_1;
    const double d_theta_ddot_by_f_1 = l_df_inv_theta - l_theta_psi * d_psi_ddot_by_f_1 - l_theta_eps * d_eps_ddot_by_f_1;
    /* derivatives with respect to f_2 */
    const double by_f_2_1 = l_oc_c_theta + l_df_l_theta_eps;
    const double by_f_2_2 = l_oc_c_eps_s_theta + l_df_s_eps - l_eps_psi * by_f_2_1 + l_df_l_theta_psi;
    const double d_psi_ddot_by_f_2 = inv_psi * by_f_2_2;
    const double d_eps_ddot_by_f_2 = inv_eps * by_f_2_1 - l_eps_psi * d_psi_ddot_by_f_2;
    const double d_theta_ddot_by_f_2 = -l_theta_psi * d_psi_ddot_by_f_2 - l_df_inv_theta - l_theta_eps * d_eps_ddot_by_f_2;
    if (!(I_heli_xx > 0.0)) {
        return 3;
    }
    if (!(pivot_eps > 0.0)) {
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
    a[3][3] = d_psi_ddot_by_psi_dot;
    a[3][4] = d_psi_ddot_by_eps_dot;
    a[3][5] = d_psi_ddot_by_theta_dot;
    a[4][1] = d_eps_ddot_by_eps; /* eps'' */
    a[4][2] = d_eps_ddot_by_theta;
    a[4][3] = d_eps_ddot_by_psi_dot;
    a[4][4] = d_eps_ddot_by_eps_dot;
    a[4][5] = d_eps_ddot_by_theta_dot;
    a[5][1] = d_theta_ddot_by_eps; /* theta'' */
    a[5][2] = d_theta_ddot_by_theta;
    a[5][3] = d_theta_ddot_by_psi_dot;
    a[5][4] = d_theta_ddot_by_eps_dot;
    a[5][5] = d_theta_ddot_by_theta_dot;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 2; j++) {
            b[i][j] = 0.0;
        }
    }
    b[3][0] = d_psi_ddot_by_f_1; /* psi'' */
    b[3][1] = d_psi_ddot_by_f_2;
    b[4][0] = d_eps_ddot_by_f_1; /* eps'' */
    b[4][1] = d_eps_ddot_by_f_2;
    b[5][0] = d_theta_ddot_by_f_1; /* theta'' */
    b[5][1] = d_theta_ddot_by_f_2;
    return 0;
}

int googol_parameter_jacobian(
    const struct googol_state *x,
    const struct googol_inputs *u,
    const struct googol_parameters *p,
    double by_p[6][14])
{
    const struct googol_coordinates *q = &x->q;
    const struct googol_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_b_l_oa = p->m_b * p->l_oa;
    const double m_c_l_ob = p->m_c * p->l_ob;
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    /* frame arm on column */
    const double mc_arm_x = m_b_l_oa - m_c_l_ob;
    const double I_arm_yy = p->l_oa * m_b_l_oa + p->l_ob * m_c_l_ob;
    const double omega_arm_z = c_eps * v->psi;
    const double omega_arm_x = s_eps * v->psi;
    const double alpha_arm_x = omega_arm_z * v->eps;
    const double alpha_arm_z = -omega_arm_x * v->eps;
    const double arm_1 = v->eps * v->eps + omega_arm_z * omega_arm_z;
    const double omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    const double a_arm_z = p->g * c_eps;
    /* body fuselage on heli */
    const double mc_heli_z = -p->m_h * p->l_cd;
    const double I_heli_yy = -p->l_cd * mc_heli_z;
    const double I_heli_xx = p->I_x + I_heli_yy;
    /* frame heli on arm */
    const double omega_heli_y = -c_theta * v->eps - omega_arm_z * s_theta;
    const double omega_heli_z = omega_arm_z * c_theta - s_theta * v->eps;
    const double omega_heli_x = omega_arm_x - v->theta;
    const double omega_heli_z_theta_dot = omega_heli_z * v->theta;
    const double omega_heli_y_theta_dot = omega_heli_y * v->theta;
    const double omega_heli_z_omega_heli_x = omega_heli_z * omega_heli_x;
    const double omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    const double heli_1 = omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y;
    const double mc_heli_z_heli_1 = mc_heli_z * heli_1;
    const double heli_2 = I_heli_yy * (-alpha_arm_z * s_theta - omega_heli_z_theta_dot);
    const double omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    const double n_moving_heli_z = -p->I_x * omega_heli_y_omega_heli_x - p->I_z * (-omega_heli_y_theta_dot - alpha_arm_z * c_theta);
    const double M_eps_theta = -p->l_oc * mc_heli_z * s_theta;
    const double l_oc_mc_heli_z_c_theta = p->l_oc * mc_heli_z * c_theta;
    const double M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    const double I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p->I_z);
    const double heli_3 = I_heli_yy_minus_I_z_c_theta * c_theta;
    const double a_heli_1_y = 2.0 * p->l_oc * alpha_arm_z;
    const double a_heli_1_x = p->g * s_eps - p->l_oc * arm_1;
    const double a_heli_1_z = p->l_oc * omega_arm_z_omega_arm_x + a_arm_z;
    const double l_oc_m_h_l_oc = p->m_h * p->l_oc * p->l_oc;
    const double a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    const double a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    const double f_heli_y = p->m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    const double n_heli_x = I_heli_xx * alpha_arm_x + omega_heli_y_omega_heli_z * (p->I_z - I_heli_yy) - mc_heli_z * a_heli_y;
    const double n_heli_y = heli_2 + omega_heli_z_omega_heli_x * (I_heli_xx - p->I_z) + mc_heli_z * a_heli_1_x;
    const double n_heli_1_y = n_moving_heli_z * s_theta + n_heli_y * c_theta;
    const double n_heli_1_z = n_moving_heli_z * c_theta - n_heli_y * s_theta;
    const double f_net_heli_z = p->m_h * a_heli_z - mc_heli_z_heli_1 - f_s;
    const double f_net_heli_1_y = f_heli_y * c_theta + f_net_heli_z * s_theta;
    const double f_net_heli_1_z = f_net_heli_z * c_theta - f_heli_y * s_theta;
    /* frame arm on column */
    const double M_eps_eps = I_arm_yy + p->I_z + heli_3 + l_oc_m_h_l_oc;
    const double M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    const double arm_2 = c_eps * (I_arm_yy + I_heli_yy - heli_3 + l_oc_m_h_l_oc - I_heli_xx);
    const double arm_3 = c_eps * (arm_2 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    const double n_net_arm_z = 2.0 * I_arm_yy * alpha_arm_z + n_heli_1_z + p->l_oc * f_net_heli_1_y;
    const double arm_4 = I_arm_yy * omega_arm_z_omega_arm_x + mc_arm_x * a_arm_z - n_heli_1_y + p->l_oc * f_net_heli_1_z;
    /* force rotor_2 on heli */
    const double n_applied_heli_x = p->l_df * u->f_2 - p->l_df * u->f_1;
    const double c_eps_s_theta = c_eps * s_theta;
    /* frame arm on column */
    const double n_net_column_z = n_net_arm_z * c_eps + s_eps * (n_heli_x - n_applied_heli_x);
    /* balance of forces */
    const double tau_theta = n_heli_x - p->c0_theta * v->theta - n_applied_heli_x;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / I_heli_xx;
    const double l_theta_psi = M_psi_theta * inv_theta;
    const double l_theta_eps = M_eps_theta * inv_theta;
    const double pivot_eps = M_eps_eps - M_eps_theta * l_theta_eps;
    const double inv_eps = 1.0 / pivot_eps;
    const double solve_1 = M_psi_eps - M_psi_theta * l_theta_eps;
    const double l_eps_psi = inv_eps * solve_1;
    const double pivot_psi = I_heli_xx + arm_3 - solve_1 * l_eps_psi - M_psi_theta * l_theta_psi;
    const double inv_psi = 1.0 / pivot_psi;
    const double solve_2 = tau_theta * l_theta_eps + p->c0_eps * v->eps + arm_4;
    const double psi_ddot = -inv_psi * (p->c0_psi * v->psi + n_net_column_z - l_eps_psi * solve_2 + tau_theta * l_theta_psi);
    const double eps_ddot = -inv_eps * solve_2 - l_eps_psi * psi_ddot;
    const double theta_ddot = tau_theta * inv_theta - l_theta_psi * psi_ddot - l_theta_eps * eps_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = alpha_arm_z + psi_ddot * c_eps;
    const double alpha_arm_z_plus_slopes_1 = alpha_arm_z + slopes_1;
    const double slopes_2 = omega_arm_z_omega_arm_x + eps_ddot;
    const double slopes_3 = p->l_oc * alpha_arm_z_plus_slopes_1;
    const double a_arm_z_plus_l_oc_slopes_2 = a_arm_z + p->l_oc * slopes_2;
    const double slopes_4 = omega_heli_z_theta_dot + eps_ddot * c_theta + slopes_1 * s_theta;
    const double slopes_5 = eps_ddot * s_theta - omega_heli_y_theta_dot - slopes_1 * c_theta;
    const double slopes_6 = alpha_arm_x - theta_ddot + psi_ddot * s_eps;
    const double slopes_7 = a_arm_z_plus_l_oc_slopes_2 * s_theta - slopes_3 * c_theta;
    const double slopes_8 = a_arm_z_plus_l_oc_slopes_2 * c_theta + slopes_3 * s_theta;
    const double m_h_slopes_7 = p->m_h * slopes_7;
    const double slopes_9 = slopes_6 - omega_heli_y_omega_heli_z;
    const double slopes_10 = mc_heli_z * slopes_9 + m_h_slopes_7;
    const double slopes_11 = p->m_h * slopes_8 - mc_heli_z_heli_1 - f_s;
    const double slopes_12 = slopes_11 * s_theta - slopes_10 * c_theta;
    const double slopes_13 = slopes_11 * c_theta + slopes_10 * s_theta;
    const double l_cd_slopes_9_minus_slopes_7 = p->l_cd * slopes_9 - slopes_7;
    const double slopes_8_plus_l_cd_heli_1 = slopes_8 + p->l_cd * heli_1;
    const double slopes_14 = p->l_oc * (slopes_8_plus_l_cd_heli_1 * c_theta - l_cd_slopes_9_minus_slopes_7 * s_theta);
    const double slopes_15 = p->l_oc * (l_cd_slopes_9_minus_slopes_7 * c_theta + slopes_8_plus_l_cd_heli_1 * s_theta);
    const double slopes_16 = slopes_2 * s_theta - alpha_arm_z_plus_slopes_1 * c_theta;
    const double m_h_slopes_16 = p->m_h * slopes_16;
    const double slopes_17 = p->m_h * (slopes_2 * c_theta + alpha_arm_z_plus_slopes_1 * s_theta);
    const double mc_heli_z_slopes_16 = mc_heli_z * slopes_16;
    const double slopes_18 = p->l_oc * (m_h_slopes_16 * s_theta + slopes_17 * c_theta);
    const double slopes_19 = p->l_oc * (slopes_17 * s_theta - m_h_slopes_16 * c_theta);
    const double m_h_slopes_9 = p->m_h * slopes_9;
    const double l_cd_sq = p->l_cd * p->l_cd;
    const double l_oa_sq = p->l_oa * p->l_oa;
    const double l_ob_sq = p->l_ob * p->l_ob;
    /* derivatives with respect to m_c */
    const double by_m_c_1 = p->l_ob * a_arm_z - omega_arm_z_omega_arm_x * l_ob_sq - eps_ddot * l_ob_sq;
    const double mc_heli_z_s_eps = mc_heli_z * s_eps;
    const double m_h_c_eps_s_theta = p->m_h * c_eps_s_theta;
    const double m_h_c_eps_c_theta = p->m_h * c_eps * c_theta;
    const double mc_heli_z_c_eps_s_theta = mc_heli_z * c_eps_s_theta;
    /* derivatives with respect to g */
    const double by_g_1 = p->l_oc * (m_h_c_eps_s_theta * s_theta + m_h_c_eps_c_theta * c_theta);
    const double by_g_2 = p->l_oc * (m_h_c_eps_c_theta * s_theta - m_h_c_eps_s_theta * c_theta);
    const double by_g_3 = mc_arm_x * c_eps - mc_heli_z_s_eps * c_theta + by_g_1;
    const double by_g_4 = c_eps * (by_g_2 - mc_heli_z_s_eps * s_theta);
    const double by_g_5 = l_theta_eps * mc_heli_z_c_eps_s_theta + by_g_3;
    const double by_g_6 = l_eps_psi * by_g_5 - mc_heli_z_c_eps_s_theta * s_eps - by_g_4;
    const double d_psi_ddot_by_g = inv_psi * (by_g_6 - l_theta_psi * mc_heli_z_c_eps_s_theta);
    const double d_eps_ddot_by_g = -inv_eps * by_g_5 - l_eps_psi * d_psi_ddot_by_g;
    const double d_theta_ddot_by_g = inv_theta * mc_heli_z_c_eps_s_theta - l_theta_psi * d_psi_ddot_by_g - l_theta_eps * d_eps_ddot_by_g;
    const double mc_heli_z_arm_1 = mc_heli_z * arm_1;
    /* derivatives with respect to l_oc */
    const double by_l_oc_1 = mc_heli_z_arm_1 * c_theta + slopes_13 + slopes_18;
    const double by_l_oc_2 = by_l_oc_1 + l_theta_eps * mc_heli_z_slopes_16;
    const double two_m_c_l_ob = 2.0 * m_c_l_ob;
    /* derivatives with respect to l_ob */
    const double by_l_ob_1 = p->m_c * a_arm_z - omega_arm_z_omega_arm_x * two_m_c_l_ob - eps_ddot * two_m_c_l_ob;
    const double two_m_b_l_oa = 2.0 * m_b_l_oa;
    const double two_mc_heli_z = 2.0 * mc_heli_z;
    const double m_h_heli_1 = p->m_h * heli_1;
    /* derivatives with respect to I_x */
    const double by_I_x_1 = omega_heli_z_omega_heli_x * c_theta;
    const double by_I_x_2 = omega_heli_z_omega_heli_x * s_theta;
    const double by_I_x_3 = c_eps * (-omega_heli_y_omega_heli_x * c_theta - by_I_x_2);
    const double by_I_x_4 = by_I_x_1 - omega_heli_y_omega_heli_x * s_theta - l_theta_eps * slopes_6;
    const double by_I_x_5 = by_I_x_3 + slopes_6 * s_eps + l_eps_psi * by_I_x_4;
    const double d_psi_ddot_by_I_x = inv_psi * (-l_theta_psi * slopes_6 - by_I_x_5);
    const double d_eps_ddot_by_I_x = inv_eps * by_I_x_4 - l_eps_psi * d_psi_ddot_by_I_x;
    const double d_theta_ddot_by_I_x = inv_theta * slopes_6 - l_theta_psi * d_psi_ddot_by_I_x - l_theta_eps * d_eps_ddot_by_I_x;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_20 = slopes_6 * l_cd_sq - omega_heli_y_omega_heli_z * l_cd_sq;
    const double slopes_21 = omega_heli_z_omega_heli_x * l_cd_sq - slopes_4 * l_cd_sq;
    const double slopes_22 = slopes_20 - p->l_cd * slopes_7;
    const double slopes_23 = slopes_21 - p->l_cd * a_heli_1_x;
    const double slopes_24 = c_eps * (slopes_15 - slopes_23 * s_theta);
    const double slopes_25 = p->l_oa * a_arm_z + omega_arm_z_omega_arm_x * l_oa_sq + eps_ddot * l_oa_sq;
    const double slopes_26 = c_eps * (-alpha_arm_z * l_oa_sq - slopes_1 * l_oa_sq);
    const double slopes_27 = c_eps * (-alpha_arm_z * l_ob_sq - slopes_1 * l_ob_sq);
    const double slopes_28 = slopes_12 + slopes_19 + mc_heli_z_arm_1 * s_theta;
    const double slopes_29 = c_eps * (-alpha_arm_z * two_m_c_l_ob - slopes_1 * two_m_c_l_ob);
    const double slopes_30 = p->m_b * a_arm_z + omega_arm_z_omega_arm_x * two_m_b_l_oa + eps_ddot * two_m_b_l_oa;
    const double slopes_31 = c_eps * (-alpha_arm_z * two_m_b_l_oa - slopes_1 * two_m_b_l_oa);
    const double slopes_32 = 2.0 * omega_heli_y_omega_heli_z * mc_heli_z - slopes_6 * two_mc_heli_z;
    const double slopes_33 = slopes_4 * two_mc_heli_z - omega_heli_z_omega_heli_x * two_mc_heli_z;
    const double slopes_32_minus_m_h_slopes_7 = slopes_32 - m_h_slopes_7;
    const double slopes_34 = slopes_33 - p->m_h * a_heli_1_x;
    const double slopes_35 = p->l_oc * (m_h_heli_1 * c_theta - m_h_slopes_9 * s_theta);
    const double slopes_36 = p->l_oc * (m_h_heli_1 * s_theta + m_h_slopes_9 * c_theta);
    const double slopes_37 = c_eps * (slopes_36 - slopes_34 * s_theta);
    const double slopes_38 = c_eps * (by_I_x_2 - slopes_5 * c_theta);
    /* derivatives with respect to m_h */
    const double by_m_h_1 = slopes_23 * c_theta - slopes_14 - l_theta_eps * slopes_22;
    const double by_m_h_2 = slopes_24 + slopes_22 * s_eps + l_eps_psi * by_m_h_1;
    const double d_psi_ddot_by_m_h = inv_psi * (-l_theta_psi * slopes_22 - by_m_h_2);
    const double d_eps_ddot_by_m_h = inv_eps * by_m_h_1 - l_eps_psi * d_psi_ddot_by_m_h;
    const double d_theta_ddot_by_m_h = inv_theta * slopes_22 - l_theta_psi * d_psi_ddot_by_m_h - l_theta_eps * d_eps_ddot_by_m_h;
    /* derivatives with respect to m_b */
    const double d_psi_ddot_by_m_b = inv_psi * (slopes_26 + l_eps_psi * slopes_25);
    const double d_eps_ddot_by_m_b = -inv_eps * slopes_25 - l_eps_psi * d_psi_ddot_by_m_b;
    const double d_theta_ddot_by_m_b = -l_theta_psi * d_psi_ddot_by_m_b - l_theta_eps * d_eps_ddot_by_m_b;
    /* derivatives with respect to m_c */
    const double d_psi_ddot_by_m_c = inv_psi * (slopes_27 - l_eps_psi * by_m_c_1);
    const double d_eps_ddot_by_m_c = inv_eps * by_m_c_1 - l_eps_psi * d_psi_ddot_by_m_c;
    const double d_theta_ddot_by_m_c = -l_theta_psi * d_psi_ddot_by_m_c - l_theta_eps * d_eps_ddot_by_m_c;
    /* derivatives with respect to l_oc */
    const double by_l_oc_3 = mc_heli_z_slopes_16 * s_eps + slopes_28 * c_eps;
    const double d_psi_ddot_by_l_oc = inv_psi * (l_eps_psi * by_l_oc_2 - by_l_oc_3 - l_theta_psi * mc_heli_z_slopes_16);
    const double d_eps_ddot_by_l_oc = -inv_eps * by_l_oc_2 - l_eps_psi * d_psi_ddot_by_l_oc;
    const double d_theta_ddot_by_l_oc = inv_theta * mc_heli_z_slopes_16
        - l_theta_psi * d_psi_ddot_by_l_oc
        - l_theta_eps * d_eps_ddot_by_l_oc;
    /* derivatives with respect to l_ob */
    const double d_psi_ddot_by_l_ob = inv_psi * (slopes_29 - l_eps_psi * by_l_ob_1);
    const double d_eps_ddot_by_l_ob = inv_eps * by_l_ob_1 - l_eps_psi * d_psi_ddot_by_l_ob;
    const double d_theta_ddot_by_l_ob = -l_theta_psi * d_psi_ddot_by_l_ob - l_theta_eps * d_eps_ddot_by_l_ob;
    /* derivatives with respect to l_oa */
    const double d_psi_ddot_by_l_oa = inv_psi * (slopes_31 + l_eps_psi * slopes_30);
    const double d_eps_ddot_by_l_oa = -inv_eps * slopes_30 - l_eps_psi * d_psi_ddot_by_l_oa;
    const double d_theta_ddot_by_l_oa = -l_theta_psi * d_psi_ddot_by_l_oa - l_theta_eps * d_eps_ddot_by_l_oa;
    /* derivatives with respect to l_cd */
    const double by_l_cd_1 = slopes_34 * c_theta - slopes_35 - l_theta_eps * slopes_32_minus_m_h_slopes_7;
    const double by_l_cd_2 = slopes_37 + slopes_32_minus_m_h_slopes_7 * s_eps + l_eps_psi * by_l_cd_1;
    const double d_psi_ddot_by_l_cd = inv_psi * (-l_theta_psi * slopes_32_minus_m_h_slopes_7 - by_l_cd_2);
    const double d_eps_ddot_by_l_cd = inv_eps * by_l_cd_1 - l_eps_psi * d_psi_ddot_by_l_cd;
    const double d_theta_ddot_by_l_cd = inv_theta * slopes_32_minus_m_h_slopes_7
        - l_theta_psi * d_psi_ddot_by_l_cd
        - l_theta_eps * d_eps_ddot_by_l_cd;
    const double f_d_l_theta_eps = f_d * l_theta_eps;
    /* derivatives with respect to l_df */
    const double d_psi_ddot_by_l_df = inv_psi * (l_eps_psi * f_d_l_theta_eps - f_d * s_eps - f_d * l_theta_psi);
    const double d_eps_ddot_by_l_df = -inv_eps * f_d_l_theta_eps - l_eps_psi * d_psi_ddot_by_l_df;
    const double d_theta_ddot_by_l_df = f_d * inv_theta - l_theta_psi * d_psi_ddot_by_l_df - l_theta_eps * d_eps_ddot_by_l_df;
    /* derivatives with respect to I_z */
    const double by_I_z_1 = omega_heli_y_omega_heli_z * l_theta_eps + by_I_x_1 + slopes_5 * s_theta;
    const double by_I_z_2 = l_eps_psi * by_I_z_1 - omega_heli_y_omega_heli_z * s_eps - slopes_38;
    const double d_psi_ddot_by_I_z = inv_psi * (by_I_z_2 - omega_heli_y_omega_heli_z * l_theta_psi);
    const double d_eps_ddot_by_I_z = -inv_eps * by_I_z_1 - l_eps_psi * d_psi_ddot_by_I_z;
    const double d_theta_ddot_by_I_z = omega_heli_y_omega_heli_z * inv_theta
        - l_theta_psi * d_psi_ddot_by_I_z
        - l_theta_eps * d_eps_ddot_by_I_z;
    /* derivatives with respect to c0_psi */
    const double d_psi_ddot_by_c0_psi = -inv_psi * v->psi;
    const double d_eps_ddot_by_c0_psi = -l_eps_psi * d_psi_ddot_by_c0_psi;
    const double d_theta_ddot_by_c0_psi = -l_theta_psi * d_psi_ddot_by_c0_psi - l_theta_eps * d_eps_ddot_by_c0_psi;
    /* derivatives with respect to c0_eps */
    const double d_psi_ddot_by_c0_eps = inv_psi * l_eps_psi * v->eps;
    const double d_eps_ddot_by_c0_eps = -inv_eps * v->eps - l_eps_psi * d_psi_ddot_by_c0_eps;
    const double d_theta_ddot_by_c0_eps = -l_theta_psi * d_psi_ddot_by_c0_eps - l_theta_eps * d_eps_ddot_by_c0_eps;
    const double l_theta_eps_theta_dot = l_theta_eps * v->theta;
    /* derivatives with respect to c0_theta */
    const double d_psi_ddot_by_c0_theta = -inv_psi * (l_eps_psi * l_theta_eps_theta_dot - l_theta_psi * v->theta);
    const double d_eps_ddot_by_c0_theta = inv_eps * l_theta_eps_theta_dot - l_eps_psi * d_psi_ddot_by_c0_theta;
    const double d_theta_ddot_by_c0_theta = -inv_theta * v->theta
        - l_theta_psi * d_psi_ddot_by_c0_theta
        - l_theta_eps * d_eps_ddot_by_c0_theta;
    if (!(I_heli_xx > 0.0)) {
        return 3;
    }
    if (!(pivot_eps > 0.0)) {
        return 2;
    }
    if (!(pivot_psi > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 14; j++) {
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
    by_p[3][7] = d_psi_ddot_by_l_cd;
    by_p[3][8] = d_psi_ddot_by_l_df;
    by_p[3][9] = d_psi_ddot_by_I_x;
    by_p[3][10] = d_psi_ddot_by_I_z;
    by_p[3][11] = d_psi_ddot_by_c0_psi;
    by_p[3][12] = d_psi_ddot_by_c0_eps;
    by_p[3][13] = d_psi_ddot_by_c0_theta;
    by_p[4][0] = d_eps_ddot_by_m_h; /* eps'' */
    by_p[4][1] = d_eps_ddot_by_m_b;
    by_p[4][2] = d_eps_ddot_by_m_c;
    by_p[4][3] = d_eps_ddot_by_g;
    by_p[4][4] = d_eps_ddot_by_l_oc;
    by_p[4][5] = d_eps_ddot_by_l_ob;
    by_p[4][6] = d_eps_ddot_by_l_oa;
    by_p[4][7] = d_eps_ddot_by_l_cd;
    by_p[4][8] = d_eps_ddot_by_l_df;
    by_p[4][9] = d_eps_ddot_by_I_x;
    by_p[4][10] = d_eps_ddot_by_I_z;
    by_p[4][11] = d_eps_ddot_by_c0_psi;
    by_p[4][12] = d_eps_ddot_by_c0_eps;
    by_p[4][13] = d_eps_ddot_by_c0_theta;
    by_p[5][0] = d_theta_ddot_by_m_h; /* theta'' */
    by_p[5][1] = d_theta_ddot_by_m_b;
    by_p[5][2] = d_theta_ddot_by_m_c;
    by_p[5][3] = d_theta_ddot_by_g;
    by_p[5][4] = d_theta_ddot_by_l_oc;
    by_p[5][5] = d_theta_ddot_by_l_ob;
    by_p[5][6] = d_theta_ddot_by_l_oa;
    by_p[5][7] = d_theta_ddot_by_l_cd;
    by_p[5][8] = d_theta_ddot_by_l_df;
    by_p[5][9] = d_theta_ddot_by_I_x;
    by_p[5][10] = d_theta_ddot_by_I_z;
    by_p[5][11] = d_theta_ddot_by_c0_psi;
    by_p[5][12] = d_theta_ddot_by_c0_eps;
    by_p[5][13] = d_theta_ddot_by_c0_theta;
    return 0;
}

void googol_output_jacobian(const struct googol_state *x, const struct googol_parameters *p, double by_x[3][6], double by_p[3][14])
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
        for (int j = 0; j < 14; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

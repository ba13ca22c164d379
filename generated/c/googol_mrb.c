/*
 * Googol GHP2002, multi-rigid-body model.
 * Generated from `googol_mrb.rig` (model 236cb442); edit the rig, not this file.
 *
 * Eq. 13 of the seed paper, derived: the full physics under the paper's assumptions (no velocity
 * products, a constant diagonal mass matrix). The yaw-by-f_d term comes out without the misprinted
 * factor sin(theta); see `googol_eq13.rig`.
 *
 * Assumed: no velocity products; M = diag(I_psi, I_eps, I_theta).
 * 50 operations forward, 98 with A and B.
 * Derived twice before the assumptions, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "googol_mrb.h"

#include <math.h>

void googol_mrb_nominal(struct googol_mrb_parameters *p)
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
    p->I_psi = 1.469;
    p->I_eps = 1.469;
    p->I_theta = 0.0319;
}

void googol_mrb_mass_matrix(const struct googol_mrb_coordinates *q, const struct googol_mrb_parameters *p, double m[3][3])
{
    (void)q;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m[i][j] = 0.0;
        }
    }
    m[0][0] = p->I_psi; /* psi */
    m[1][1] = p->I_eps; /* eps */
    m[2][2] = p->I_theta; /* theta */
}

void googol_mrb_bias(
    const struct googol_mrb_coordinates *q,
    const struct googol_mrb_rates *v,
    const struct googol_mrb_parameters *p,
    double h[3])
{
    (void)v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    /* gravity */
    const double gravity_1 = p->m_b * p->g * p->l_oa * c_eps - p->m_c * p->g * p->l_ob * c_eps;
    const double gravity_2 = p->m_h * p->g * (p->l_cd * s_eps * c_theta + p->l_oc * c_eps);
    const double g_theta = p->m_h * p->g * p->l_cd * c_eps * s_theta;
    h[0] = 0.0; /* psi */
    h[1] = gravity_1 + gravity_2; /* eps */
    h[2] = g_theta; /* theta */
}

void googol_mrb_velocity_products(
    const struct googol_mrb_coordinates *q,
    const struct googol_mrb_rates *v,
    const struct googol_mrb_parameters *p,
    double c[3])
{
    (void)q;
    (void)v;
    (void)p;
    c[0] = 0.0; /* psi */
    c[1] = 0.0; /* eps */
    c[2] = 0.0; /* theta */
}

void googol_mrb_gravity(const struct googol_mrb_coordinates *q, const struct googol_mrb_parameters *p, double g[3])
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

void googol_mrb_dissipation(
    const struct googol_mrb_coordinates *q,
    const struct googol_mrb_rates *v,
    const struct googol_mrb_parameters *p,
    double d[3])
{
    (void)q;
    d[0] = p->c0_psi * v->psi; /* psi */
    d[1] = p->c0_eps * v->eps; /* eps */
    d[2] = p->c0_theta * v->theta; /* theta */
}

void googol_mrb_generalized_force(
    const struct googol_mrb_coordinates *q,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
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

void googol_mrb_input_map(const struct googol_mrb_coordinates *q, const struct googol_mrb_parameters *p, double s[3][2])
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

double googol_mrb_potential_energy(const struct googol_mrb_coordinates *q, const struct googol_mrb_parameters *p)
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

void googol_mrb_inverse_dynamics(
    const struct googol_mrb_state *x,
    const struct googol_mrb_accelerations *a,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
    double r[3])
{
    const struct googol_mrb_coordinates *q = &x->q;
    const struct googol_mrb_rates *v = &x->v;
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
    /* gravity */
    const double gravity_1 = p->m_b * p->g * p->l_oa * c_eps - p->m_c * p->g * p->l_ob * c_eps;
    const double gravity_2 = p->m_h * p->g * (p->l_cd * s_eps * c_theta + p->l_oc * c_eps);
    const double g_theta = p->m_h * p->g * p->l_cd * c_eps * s_theta;
    /* balance of forces */
    const double balance_1 = gravity_1 + gravity_2 + p->I_eps * a->eps - p->l_oc * f_s * c_theta;
    r[0] = p->c0_psi * v->psi + p->I_psi * a->psi - n_applied_column_z; /* psi */
    r[1] = p->c0_eps * v->eps + balance_1; /* eps */
    r[2] = p->c0_theta * v->theta + g_theta + p->I_theta * a->theta - l_df_f_1 + l_df_f_2; /* theta */
}

void googol_mrb_outputs(const struct googol_mrb_state *x, const struct googol_mrb_parameters *p, struct googol_mrb_outputs *y)
{
    const struct googol_mrb_coordinates *q = &x->q;
    (void)p;
    y->psi = q->psi;
    y->eps = q->eps;
    y->theta = q->theta;
}

void googol_mrb_pivots(const struct googol_mrb_state *x, const struct googol_mrb_parameters *p, double d[3])
{
    (void)x;
    d[0] = p->I_psi; /* psi */
    d[1] = p->I_eps; /* eps */
    d[2] = p->I_theta; /* theta */
}

int googol_mrb_forward_dynamics(
    const struct googol_mrb_state *x,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
    struct googol_mrb_accelerations *a)
{
    const struct googol_mrb_coordinates *q = &x->q;
    const struct googol_mrb_rates *v = &x->v;
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
    /* gravity */
    const double gravity_1 = p->m_b * p->g * p->l_oa * c_eps - p->m_c * p->g * p->l_ob * c_eps;
    const double gravity_2 = p->m_h * p->g * (p->l_cd * s_eps * c_theta + p->l_oc * c_eps);
    const double g_theta = p->m_h * p->g * p->l_cd * c_eps * s_theta;
    /* balance of forces */
    const double tau_eps = p->l_oc * f_s * c_theta - p->c0_eps * v->eps - gravity_1 - gravity_2;
    const double tau_theta = l_df_f_1 - p->c0_theta * v->theta - g_theta - l_df_f_2;
    /* M = L^T D L and back-substitution */
    const double psi_ddot = (n_applied_column_z - p->c0_psi * v->psi) / p->I_psi;
    if (!(p->I_theta > 0.0)) {
        return 3;
    }
    if (!(p->I_eps > 0.0)) {
        return 2;
    }
    if (!(p->I_psi > 0.0)) {
        return 1;
    }
    a->psi = psi_ddot;
    a->eps = tau_eps / p->I_eps;
    a->theta = tau_theta / p->I_theta;
    return 0;
}

int googol_mrb_linearize(
    const struct googol_mrb_state *x,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2])
{
    const struct googol_mrb_coordinates *q = &x->q;
    const struct googol_mrb_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double f_s = u->f_1 + u->f_2;
    const double l_df_f_1 = p->l_df * u->f_1;
    const double l_df_f_2 = p->l_df * u->f_2;
    /* force rotor_2 on heli */
    const double n_applied_heli_x = l_df_f_2 - l_df_f_1;
    /* frame heli on arm */
    const double n_applied_arm_y = -p->l_oc * f_s * c_theta;
    const double n_applied_arm_z = p->l_oc * f_s * s_theta;
    /* frame arm on column */
    const double n_applied_column_z = n_applied_arm_z * c_eps + n_applied_heli_x * s_eps;
    const double n_applied_column_x = n_applied_heli_x * c_eps - n_applied_arm_z * s_eps;
    const double l_cd_s_theta = p->l_cd * s_theta;
    const double l_cd_c_theta = p->l_cd * c_theta;
    const double l_cd_c_theta_c_eps = l_cd_c_theta * c_eps;
    /* gravity */
    const double gravity_1 = p->m_b * p->g * p->l_oa * c_eps - p->m_c * p->g * p->l_ob * c_eps;
    const double gravity_2 = p->m_h * p->g * (l_cd_c_theta * s_eps + p->l_oc * c_eps);
    const double g_theta = p->m_h * p->g * l_cd_s_theta * c_eps;
    /* balance of forces */
    const double tau_eps = -p->c0_eps * v->eps - gravity_1 - gravity_2 - n_applied_arm_y;
    const double tau_theta = l_df_f_1 - p->c0_theta * v->theta - g_theta - l_df_f_2;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / p->I_theta;
    const double inv_eps = 1.0 / p->I_eps;
    const double inv_psi = 1.0 / p->I_psi;
    const double psi_ddot = inv_psi * (n_applied_column_z - p->c0_psi * v->psi);
    const double l_oc_c_eps_s_theta = p->l_oc * c_eps * s_theta;
    const double l_df_s_eps = p->l_df * s_eps;
    /* derivatives with respect to eps */
    const double by_eps_1 = p->m_c * p->g * p->l_ob * s_eps - p->m_b * p->g * p->l_oa * s_eps;
    const double by_eps_2 = p->m_h * p->g * (l_cd_c_theta_c_eps - p->l_oc * s_eps);
    const double m_h_g_l_cd_s_theta_s_eps = p->m_h * p->g * l_cd_s_theta * s_eps;
    /* derivatives with respect to theta */
    const double d_theta_ddot_by_theta = -p->m_h * p->g * inv_theta * l_cd_c_theta_c_eps;
    /* derivatives with respect to f_1 */
    const double d_eps_ddot_by_f_1 = p->l_oc * inv_eps * c_theta;
    const double d_theta_ddot_by_f_1 = p->l_df * inv_theta;
    if (!(p->I_theta > 0.0)) {
        return 3;
    }
    if (!(p->I_eps > 0.0)) {
        return 2;
    }
    if (!(p->I_psi > 0.0)) {
        return 1;
    }
    dx[0] = v->psi; /* psi' */
    dx[1] = v->eps; /* eps' */
    dx[2] = v->theta; /* theta' */
    dx[3] = psi_ddot; /* psi'' */
    dx[4] = tau_eps * inv_eps; /* eps'' */
    dx[5] = tau_theta * inv_theta; /* theta'' */
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][3] = 1.0; /* psi' */
    a[1][4] = 1.0; /* eps' */
    a[2][5] = 1.0; /* theta' */
    a[3][1] = n_applied_column_x * inv_psi; /* psi'' */
    a[3][2] = -inv_psi * n_applied_arm_y * c_eps;
    a[3][3] = -p->c0_psi * inv_psi;
    a[4][1] = -inv_eps * (by_eps_1 + by_eps_2); /* eps'' */
    a[4][2] = inv_eps * (m_h_g_l_cd_s_theta_s_eps - n_applied_arm_z);
    a[4][4] = -p->c0_eps * inv_eps;
    a[5][1] = inv_theta * m_h_g_l_cd_s_theta_s_eps; /* theta'' */
    a[5][2] = d_theta_ddot_by_theta;
    a[5][5] = -p->c0_theta * inv_theta;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 2; j++) {
            b[i][j] = 0.0;
        }
    }
    b[3][0] = inv_psi * (l_oc_c_eps_s_theta - l_df_s_eps); /* psi'' */
    b[3][1] = inv_psi * (l_oc_c_eps_s_theta + l_df_s_eps);
    b[4][0] = d_eps_ddot_by_f_1; /* eps'' */
    b[4][1] = d_eps_ddot_by_f_1;
    b[5][0] = d_theta_ddot_by_f_1; /* theta'' */
    b[5][1] = -d_theta_ddot_by_f_1;
    return 0;
}

int googol_mrb_parameter_jacobian(
    const struct googol_mrb_state *x,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
    double by_p[6][17])
{
    const struct googol_mrb_coordinates *q = &x->q;
    const struct googol_mrb_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double f_s = u->f_1 + u->f_2;
    /* frame arm on column */
    const double a_arm_z = p->g * c_eps;
    const double l_df_f_1 = p->l_df * u->f_1;
    const double l_df_f_2 = p->l_df * u->f_2;
    /* frame heli on arm */
    const double f_applied_heli_1_y = f_s * s_theta;
    const double f_applied_heli_1_z = f_s * c_theta;
    /* frame arm on column */
    const double arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    const double n_applied_column_z = p->l_oc * f_applied_heli_1_y * c_eps + arm_1;
    const double l_oa_c_eps = p->l_oa * c_eps;
    const double l_ob_c_eps = p->l_ob * c_eps;
    /* body fuselage on heli */
    const double fuselage_1 = p->l_cd * s_eps * c_theta + p->l_oc * c_eps;
    const double g_l_oa_c_eps = p->g * l_oa_c_eps;
    const double g_l_ob_c_eps = p->g * l_ob_c_eps;
    const double g_fuselage_1 = p->g * fuselage_1;
    /* gravity */
    const double g_eps = p->m_b * g_l_oa_c_eps - p->m_c * g_l_ob_c_eps + p->m_h * g_fuselage_1;
    const double l_cd_c_eps_s_theta = p->l_cd * c_eps * s_theta;
    const double g_l_cd_c_eps_s_theta = p->g * l_cd_c_eps_s_theta;
    /* balance of forces */
    const double tau_eps = p->l_oc * f_applied_heli_1_z - p->c0_eps * v->eps - g_eps;
    const double tau_theta = l_df_f_1 - p->c0_theta * v->theta - p->m_h * g_l_cd_c_eps_s_theta - l_df_f_2;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / p->I_theta;
    const double inv_eps = 1.0 / p->I_eps;
    const double inv_psi = 1.0 / p->I_psi;
    const double psi_ddot = inv_psi * (n_applied_column_z - p->c0_psi * v->psi);
    /* derivatives with respect to g */
    const double d_eps_ddot_by_g = -inv_eps * (p->m_b * l_oa_c_eps - p->m_c * l_ob_c_eps + p->m_h * fuselage_1);
    /* derivatives with respect to l_oc */
    const double d_eps_ddot_by_l_oc = inv_eps * (f_applied_heli_1_z - p->m_h * a_arm_z);
    /* derivatives with respect to l_cd */
    const double d_eps_ddot_by_l_cd = -p->m_h * p->g * inv_eps * s_eps * c_theta;
    const double d_theta_ddot_by_l_cd = -p->m_h * p->g * inv_theta * c_eps * s_theta;
    /* derivatives with respect to l_df */
    const double d_psi_ddot_by_l_df = inv_psi * s_eps * (u->f_2 - u->f_1);
    if (!(p->I_theta > 0.0)) {
        return 3;
    }
    if (!(p->I_eps > 0.0)) {
        return 2;
    }
    if (!(p->I_psi > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 17; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[3][4] = inv_psi * f_applied_heli_1_y * c_eps; /* psi'' */
    by_p[3][8] = d_psi_ddot_by_l_df;
    by_p[3][11] = -inv_psi * v->psi;
    by_p[3][14] = -inv_psi * psi_ddot;
    by_p[4][0] = -g_fuselage_1 * inv_eps; /* eps'' */
    by_p[4][1] = -g_l_oa_c_eps * inv_eps;
    by_p[4][2] = g_l_ob_c_eps * inv_eps;
    by_p[4][3] = d_eps_ddot_by_g;
    by_p[4][4] = d_eps_ddot_by_l_oc;
    by_p[4][5] = p->m_c * inv_eps * a_arm_z;
    by_p[4][6] = -p->m_b * inv_eps * a_arm_z;
    by_p[4][7] = d_eps_ddot_by_l_cd;
    by_p[4][12] = -inv_eps * v->eps;
    by_p[4][15] = -inv_eps * tau_eps * inv_eps;
    by_p[5][0] = -g_l_cd_c_eps_s_theta * inv_theta; /* theta'' */
    by_p[5][3] = -p->m_h * inv_theta * l_cd_c_eps_s_theta;
    by_p[5][7] = d_theta_ddot_by_l_cd;
    by_p[5][8] = inv_theta * (u->f_1 - u->f_2);
    by_p[5][13] = -inv_theta * v->theta;
    by_p[5][16] = -inv_theta * tau_theta * inv_theta;
    return 0;
}

void googol_mrb_output_jacobian(
    const struct googol_mrb_state *x,
    const struct googol_mrb_parameters *p,
    double by_x[3][6],
    double by_p[3][17])
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
        for (int j = 0; j < 17; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

/*
 * Googol GHP2002, eq. 13 as printed.
 * Generated from `googol_eq13.rig` (model 563aaada); edit the rig, not this file.
 *
 * The seed paper's equations, written directly, with the printed factor sin(theta) in the
 * yaw-by-f_d term. `rig diff googol_mrb.rig googol_eq13.rig` shows that one term.
 *
 * 47 operations forward, 91 with A and B.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "googol_eq13.h"

#include <math.h>

void googol_eq13_nominal(struct googol_eq13_parameters *p)
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

void googol_eq13_mass_matrix(const struct googol_eq13_coordinates *q, const struct googol_eq13_parameters *p, double m[3][3])
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

void googol_eq13_bias(
    const struct googol_eq13_coordinates *q,
    const struct googol_eq13_rates *v,
    const struct googol_eq13_parameters *p,
    double h[3])
{
    (void)v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double l_cd_m_h_g = p->m_h * p->g * p->l_cd;
    /* equation of eps */
    const double g_eps = l_cd_m_h_g * s_eps * c_theta + p->g * m_prime * c_eps;
    h[0] = 0.0; /* psi */
    h[1] = g_eps; /* eps */
    h[2] = l_cd_m_h_g * s_theta * c_eps; /* theta */
}

void googol_eq13_gravity(const struct googol_eq13_coordinates *q, const struct googol_eq13_parameters *p, double g[3])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double l_cd_m_h_g = p->m_h * p->g * p->l_cd;
    /* equation of eps */
    const double g_eps = l_cd_m_h_g * s_eps * c_theta + p->g * m_prime * c_eps;
    g[0] = 0.0; /* psi */
    g[1] = g_eps; /* eps */
    g[2] = l_cd_m_h_g * s_theta * c_eps; /* theta */
}

void googol_eq13_dissipation(
    const struct googol_eq13_coordinates *q,
    const struct googol_eq13_rates *v,
    const struct googol_eq13_parameters *p,
    double d[3])
{
    (void)q;
    d[0] = p->c0_psi * v->psi; /* psi */
    d[1] = p->c0_eps * v->eps; /* eps */
    d[2] = p->c0_theta * v->theta; /* theta */
}

void googol_eq13_generalized_force(
    const struct googol_eq13_coordinates *q,
    const struct googol_eq13_inputs *u,
    const struct googol_eq13_parameters *p,
    double f[3])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double l_df_f_d_s_theta_s_eps = p->l_df * f_d * s_theta * s_eps;
    /* equation of psi */
    const double Q_psi = p->l_oc * f_s * c_eps * s_theta - l_df_f_d_s_theta_s_eps;
    f[0] = Q_psi; /* psi */
    f[1] = p->l_oc * f_s * c_theta; /* eps */
    f[2] = p->l_df * f_d; /* theta */
}

void googol_eq13_input_map(const struct googol_eq13_coordinates *q, const struct googol_eq13_parameters *p, double s[3][2])
{
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double l_oc_c_eps_s_theta = p->l_oc * c_eps * s_theta;
    const double l_df_s_theta_s_eps = p->l_df * s_theta * s_eps;
    const double l_oc_c_theta = p->l_oc * c_theta;
    s[0][0] = l_oc_c_eps_s_theta - l_df_s_theta_s_eps; /* psi */
    s[0][1] = l_oc_c_eps_s_theta + l_df_s_theta_s_eps;
    s[1][0] = l_oc_c_theta; /* eps */
    s[1][1] = l_oc_c_theta;
    s[2][0] = p->l_df; /* theta */
    s[2][1] = -p->l_df;
}

void googol_eq13_inverse_dynamics(
    const struct googol_eq13_state *x,
    const struct googol_eq13_accelerations *a,
    const struct googol_eq13_inputs *u,
    const struct googol_eq13_parameters *p,
    double r[3])
{
    const struct googol_eq13_coordinates *q = &x->q;
    const struct googol_eq13_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double l_df_f_d_s_theta_s_eps = p->l_df * f_d * s_theta * s_eps;
    /* equation of psi */
    const double Q_psi = p->l_oc * f_s * c_eps * s_theta - l_df_f_d_s_theta_s_eps;
    const double l_cd_m_h_g = p->m_h * p->g * p->l_cd;
    /* equation of eps */
    const double g_eps = l_cd_m_h_g * s_eps * c_theta + p->g * m_prime * c_eps;
    /* balance of forces */
    const double balance_1 = l_cd_m_h_g * s_theta * c_eps + p->I_theta * a->theta - p->l_df * f_d;
    r[0] = p->c0_psi * v->psi + p->I_psi * a->psi - Q_psi; /* psi */
    r[1] = p->c0_eps * v->eps + g_eps + p->I_eps * a->eps - p->l_oc * f_s * c_theta; /* eps */
    r[2] = p->c0_theta * v->theta + balance_1; /* theta */
}

void googol_eq13_outputs(const struct googol_eq13_state *x, const struct googol_eq13_parameters *p, struct googol_eq13_outputs *y)
{
    const struct googol_eq13_coordinates *q = &x->q;
    (void)p;
    y->psi = q->psi;
    y->eps = q->eps;
    y->theta = q->theta;
}

void googol_eq13_pivots(const struct googol_eq13_state *x, const struct googol_eq13_parameters *p, double d[3])
{
    (void)x;
    d[0] = p->I_psi; /* psi */
    d[1] = p->I_eps; /* eps */
    d[2] = p->I_theta; /* theta */
}

int googol_eq13_forward_dynamics(
    const struct googol_eq13_state *x,
    const struct googol_eq13_inputs *u,
    const struct googol_eq13_parameters *p,
    struct googol_eq13_accelerations *a)
{
    const struct googol_eq13_coordinates *q = &x->q;
    const struct googol_eq13_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double l_oc_f_s_c_eps_s_theta = p->l_oc * f_s * c_eps * s_theta;
    const double l_cd_m_h_g = p->m_h * p->g * p->l_cd;
    /* equation of eps */
    const double g_eps = l_cd_m_h_g * s_eps * c_theta + p->g * m_prime * c_eps;
    /* balance of forces */
    const double tau_psi = l_oc_f_s_c_eps_s_theta - p->c0_psi * v->psi - p->l_df * f_d * s_theta * s_eps;
    const double tau_eps = p->l_oc * f_s * c_theta - p->c0_eps * v->eps - g_eps;
    const double tau_theta = p->l_df * f_d - p->c0_theta * v->theta - l_cd_m_h_g * s_theta * c_eps;
    if (!(p->I_theta > 0.0)) {
        return 3;
    }
    if (!(p->I_eps > 0.0)) {
        return 2;
    }
    if (!(p->I_psi > 0.0)) {
        return 1;
    }
    a->psi = tau_psi / p->I_psi;
    a->eps = tau_eps / p->I_eps;
    a->theta = tau_theta / p->I_theta;
    return 0;
}

int googol_eq13_linearize(
    const struct googol_eq13_state *x,
    const struct googol_eq13_inputs *u,
    const struct googol_eq13_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2])
{
    const struct googol_eq13_coordinates *q = &x->q;
    const struct googol_eq13_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double l_oc_c_eps = p->l_oc * c_eps;
    const double l_oc_c_eps_s_theta = l_oc_c_eps * s_theta;
    const double l_df_s_theta = p->l_df * s_theta;
    const double l_df_s_theta_s_eps = l_df_s_theta * s_eps;
    const double l_cd_m_h_g = p->m_h * p->g * p->l_cd;
    const double l_cd_m_h_g_c_theta = l_cd_m_h_g * c_theta;
    const double g_m_prime = p->g * m_prime;
    /* equation of eps */
    const double g_eps = l_cd_m_h_g_c_theta * s_eps + g_m_prime * c_eps;
    const double l_oc_c_theta = p->l_oc * c_theta;
    const double l_cd_m_h_g_c_eps = l_cd_m_h_g * c_eps;
    /* balance of forces */
    const double tau_psi = f_s * l_oc_c_eps_s_theta - p->c0_psi * v->psi - f_d * l_df_s_theta_s_eps;
    const double tau_eps = f_s * l_oc_c_theta - p->c0_eps * v->eps - g_eps;
    const double tau_theta = p->l_df * f_d - p->c0_theta * v->theta - l_cd_m_h_g_c_eps * s_theta;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / p->I_theta;
    const double inv_eps = 1.0 / p->I_eps;
    const double inv_psi = 1.0 / p->I_psi;
    const double l_oc_f_s_s_theta_s_eps = p->l_oc * f_s * s_theta * s_eps;
    /* derivatives with respect to eps */
    const double d_psi_ddot_by_eps = -inv_psi * (l_oc_f_s_s_theta_s_eps + f_d * l_df_s_theta * c_eps);
    const double d_eps_ddot_by_eps = inv_eps * (g_m_prime * s_eps - l_cd_m_h_g_c_theta * c_eps);
    const double d_theta_ddot_by_eps = inv_theta * l_cd_m_h_g * s_theta * s_eps;
    const double l_df_f_d_s_eps_c_theta = p->l_df * f_d * s_eps * c_theta;
    /* derivatives with respect to theta */
    const double by_theta_1 = l_cd_m_h_g * s_eps * s_theta - p->l_oc * f_s * s_theta;
    const double d_psi_ddot_by_theta = inv_psi * (f_s * l_oc_c_eps * c_theta - l_df_f_d_s_eps_c_theta);
    /* derivatives with respect to f_1 */
    const double d_eps_ddot_by_f_1 = l_oc_c_theta * inv_eps;
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
    dx[3] = tau_psi * inv_psi; /* psi'' */
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
    a[3][1] = d_psi_ddot_by_eps; /* psi'' */
    a[3][2] = d_psi_ddot_by_theta;
    a[3][3] = -p->c0_psi * inv_psi;
    a[4][1] = d_eps_ddot_by_eps; /* eps'' */
    a[4][2] = inv_eps * by_theta_1;
    a[4][4] = -p->c0_eps * inv_eps;
    a[5][1] = d_theta_ddot_by_eps; /* theta'' */
    a[5][2] = -inv_theta * l_cd_m_h_g_c_eps * c_theta;
    a[5][5] = -p->c0_theta * inv_theta;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 2; j++) {
            b[i][j] = 0.0;
        }
    }
    b[3][0] = inv_psi * (l_oc_c_eps_s_theta - l_df_s_theta_s_eps); /* psi'' */
    b[3][1] = inv_psi * (l_oc_c_eps_s_theta + l_df_s_theta_s_eps);
    b[4][0] = d_eps_ddot_by_f_1; /* eps'' */
    b[4][1] = d_eps_ddot_by_f_1;
    b[5][0] = d_theta_ddot_by_f_1; /* theta'' */
    b[5][1] = -d_theta_ddot_by_f_1;
    return 0;
}

int googol_eq13_parameter_jacobian(
    const struct googol_eq13_state *x,
    const struct googol_eq13_inputs *u,
    const struct googol_eq13_parameters *p,
    double by_p[6][15])
{
    const struct googol_eq13_coordinates *q = &x->q;
    const struct googol_eq13_rates *v = &x->v;
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double m_prime = p->m_h * p->l_oc + p->m_b * p->l_oa - p->m_c * p->l_ob;
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double l_oc_f_s_c_eps_s_theta = p->l_oc * f_s * c_eps * s_theta;
    const double m_h_g = p->m_h * p->g;
    const double l_cd_m_h_g = p->l_cd * m_h_g;
    /* equation of eps */
    const double g_eps = l_cd_m_h_g * s_eps * c_theta + p->g * m_prime * c_eps;
    /* balance of forces */
    const double tau_psi = l_oc_f_s_c_eps_s_theta - p->c0_psi * v->psi - p->l_df * f_d * s_theta * s_eps;
    const double tau_eps = p->l_oc * f_s * c_theta - p->c0_eps * v->eps - g_eps;
    const double tau_theta = p->l_df * f_d - p->c0_theta * v->theta - l_cd_m_h_g * s_theta * c_eps;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / p->I_theta;
    const double inv_eps = 1.0 / p->I_eps;
    const double inv_psi = 1.0 / p->I_psi;
    const double g_l_cd = p->g * p->l_cd;
    /* derivatives with respect to m_h */
    const double by_m_h_1 = g_l_cd * s_eps * c_theta + p->g * p->l_oc * c_eps;
    const double d_theta_ddot_by_m_h = -inv_theta * g_l_cd * s_theta * c_eps;
    const double m_h_l_cd = p->m_h * p->l_cd;
    /* derivatives with respect to g */
    const double by_g_1 = m_h_l_cd * s_eps * c_theta + m_prime * c_eps;
    const double d_theta_ddot_by_g = -inv_theta * m_h_l_cd * s_theta * c_eps;
    const double m_h_g_c_eps = m_h_g * c_eps;
    /* derivatives with respect to l_oc */
    const double d_psi_ddot_by_l_oc = inv_psi * f_s * c_eps * s_theta;
    const double d_eps_ddot_by_l_oc = inv_eps * (f_s * c_theta - m_h_g_c_eps);
    /* derivatives with respect to m_b */
    const double d_eps_ddot_by_m_b = -p->g * p->l_oa * inv_eps * c_eps;
    /* derivatives with respect to m_c */
    const double d_eps_ddot_by_m_c = p->g * p->l_ob * inv_eps * c_eps;
    /* derivatives with respect to l_ob */
    const double d_eps_ddot_by_l_ob = p->m_c * p->g * inv_eps * c_eps;
    /* derivatives with respect to l_oa */
    const double d_eps_ddot_by_l_oa = -p->m_b * p->g * inv_eps * c_eps;
    /* derivatives with respect to l_cd */
    const double d_eps_ddot_by_l_cd = -inv_eps * m_h_g * s_eps * c_theta;
    /* derivatives with respect to l_df */
    const double d_psi_ddot_by_l_df = -inv_psi * f_d * s_theta * s_eps;
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
        for (int j = 0; j < 15; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[3][4] = d_psi_ddot_by_l_oc; /* psi'' */
    by_p[3][8] = d_psi_ddot_by_l_df;
    by_p[3][9] = -inv_psi * v->psi;
    by_p[3][12] = -inv_psi * tau_psi * inv_psi;
    by_p[4][0] = -inv_eps * by_m_h_1; /* eps'' */
    by_p[4][1] = d_eps_ddot_by_m_b;
    by_p[4][2] = d_eps_ddot_by_m_c;
    by_p[4][3] = -inv_eps * by_g_1;
    by_p[4][4] = d_eps_ddot_by_l_oc;
    by_p[4][5] = d_eps_ddot_by_l_ob;
    by_p[4][6] = d_eps_ddot_by_l_oa;
    by_p[4][7] = d_eps_ddot_by_l_cd;
    by_p[4][10] = -inv_eps * v->eps;
    by_p[4][13] = -inv_eps * tau_eps * inv_eps;
    by_p[5][0] = d_theta_ddot_by_m_h; /* theta'' */
    by_p[5][3] = d_theta_ddot_by_g;
    by_p[5][7] = -inv_theta * m_h_g_c_eps * s_theta;
    by_p[5][8] = f_d * inv_theta;
    by_p[5][11] = -inv_theta * v->theta;
    by_p[5][14] = -inv_theta * tau_theta * inv_theta;
    return 0;
}

void googol_eq13_output_jacobian(
    const struct googol_eq13_state *x,
    const struct googol_eq13_parameters *p,
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

/*
 * Googol GHP2002, identified model.
 * Generated from `googol_identified.rig` (model 020c6d91); edit the rig, not this file.
 *
 * Eq. 16 of the seed paper as printed, accelerations written directly. Each lump keeps its
 * definition over Table 1 behind its identified value; `--expand-lumps` uses the definitions.
 * The paper used two values of c_eps: 0.10 in the open-loop comparison and in eq. 17, 0.3010 in the
 * control design (eq. 26). The rig carries the latter; `--set c_eps=0.10` gives eq. 17.
 *
 * 33 operations forward, 64 with A and B.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "googol_identified.h"

#include <math.h>

void googol_identified_nominal(struct googol_identified_parameters *p)
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
    p->I_psi = 1.469;
    p->I_eps = 1.469;
    p->I_theta = 0.0319;
    p->a1 = 0.2634;
    p->a2 = 1.6279;
    p->a3 = 25.6488;
    p->b1 = 0.531;
    p->b2 = 5.3292;
    p->b3 = 0.531;
    p->b4 = 0.1157;
    p->c_psi = 0.4804;
    p->c_eps = 0.301;
    p->c_theta = 0.341;
}

void googol_identified_mass_matrix(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_parameters *p,
    double m[3][3])
{
    (void)q;
    (void)p;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m[i][j] = 0.0;
        }
    }
    m[0][0] = 1.0; /* psi */
    m[1][1] = 1.0; /* eps */
    m[2][2] = 1.0; /* theta */
}

void googol_identified_bias(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_rates *v,
    const struct googol_identified_parameters *p,
    double h[3])
{
    (void)v;
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    /* equation of eps */
    const double g_eps = p->a1 * s_eps * c_theta + p->a2 * c_eps;
    h[0] = 0.0; /* psi */
    h[1] = g_eps; /* eps */
    h[2] = p->a3 * s_theta * c_eps; /* theta */
}

void googol_identified_gravity(const struct googol_identified_coordinates *q, const struct googol_identified_parameters *p, double g[3])
{
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    /* equation of eps */
    const double g_eps = p->a1 * s_eps * c_theta + p->a2 * c_eps;
    g[0] = 0.0; /* psi */
    g[1] = g_eps; /* eps */
    g[2] = p->a3 * s_theta * c_eps; /* theta */
}

void googol_identified_dissipation(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_rates *v,
    const struct googol_identified_parameters *p,
    double d[3])
{
    (void)q;
    d[0] = p->c_psi * v->psi; /* psi */
    d[1] = p->c_eps * v->eps; /* eps */
    d[2] = p->c_theta * v->theta; /* theta */
}

void googol_identified_generalized_force(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    double f[3])
{
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double b4_f_d_s_theta_s_eps = p->b4 * f_d * s_theta * s_eps;
    /* equation of psi */
    const double Q_psi = p->b3 * f_s * s_theta * c_eps - b4_f_d_s_theta_s_eps;
    f[0] = Q_psi; /* psi */
    f[1] = p->b1 * f_s * c_theta; /* eps */
    f[2] = p->b2 * f_d; /* theta */
}

void googol_identified_input_map(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_parameters *p,
    double s[3][2])
{
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double b3_s_theta_c_eps = p->b3 * s_theta * c_eps;
    const double b4_s_theta_s_eps = p->b4 * s_theta * s_eps;
    /* equation of eps */
    const double d_eps_ddot_by_f_1 = p->b1 * c_theta;
    s[0][0] = b3_s_theta_c_eps - b4_s_theta_s_eps; /* psi */
    s[0][1] = b3_s_theta_c_eps + b4_s_theta_s_eps;
    s[1][0] = d_eps_ddot_by_f_1; /* eps */
    s[1][1] = d_eps_ddot_by_f_1;
    s[2][0] = p->b2; /* theta */
    s[2][1] = -p->b2;
}

void googol_identified_inverse_dynamics(
    const struct googol_identified_state *x,
    const struct googol_identified_accelerations *a,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    double r[3])
{
    const struct googol_identified_coordinates *q = &x->q;
    const struct googol_identified_rates *v = &x->v;
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double b4_f_d_s_theta_s_eps = p->b4 * f_d * s_theta * s_eps;
    /* equation of psi */
    const double Q_psi = p->b3 * f_s * s_theta * c_eps - b4_f_d_s_theta_s_eps;
    /* equation of eps */
    const double g_eps = p->a1 * s_eps * c_theta + p->a2 * c_eps;
    r[0] = p->c_psi * v->psi + a->psi - Q_psi; /* psi */
    r[1] = p->c_eps * v->eps + a->eps + g_eps - p->b1 * f_s * c_theta; /* eps */
    r[2] = p->c_theta * v->theta + a->theta + p->a3 * s_theta * c_eps - p->b2 * f_d; /* theta */
}

void googol_identified_outputs(
    const struct googol_identified_state *x,
    const struct googol_identified_parameters *p,
    struct googol_identified_outputs *y)
{
    const struct googol_identified_coordinates *q = &x->q;
    (void)p;
    y->psi = q->psi;
    y->eps = q->eps;
    y->theta = q->theta;
}

void googol_identified_pivots(const struct googol_identified_state *x, const struct googol_identified_parameters *p, double d[3])
{
    (void)x;
    (void)p;
    d[0] = 1.0; /* psi */
    d[1] = 1.0; /* eps */
    d[2] = 1.0; /* theta */
}

int googol_identified_forward_dynamics(
    const struct googol_identified_state *x,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    struct googol_identified_accelerations *a)
{
    const struct googol_identified_coordinates *q = &x->q;
    const struct googol_identified_rates *v = &x->v;
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double b4_f_d_s_theta_s_eps = p->b4 * f_d * s_theta * s_eps;
    /* equation of eps */
    const double g_eps = p->a1 * s_eps * c_theta + p->a2 * c_eps;
    /* balance of forces */
    const double tau_psi = p->b3 * f_s * s_theta * c_eps - p->c_psi * v->psi - b4_f_d_s_theta_s_eps;
    const double tau_eps = p->b1 * f_s * c_theta - p->c_eps * v->eps - g_eps;
    const double tau_theta = p->b2 * f_d - p->c_theta * v->theta - p->a3 * s_theta * c_eps;
    a->psi = tau_psi;
    a->eps = tau_eps;
    a->theta = tau_theta;
    return 0;
}

int googol_identified_linearize(
    const struct googol_identified_state *x,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2])
{
    const struct googol_identified_coordinates *q = &x->q;
    const struct googol_identified_rates *v = &x->v;
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    const double b3_s_theta = p->b3 * s_theta;
    const double b3_s_theta_c_eps = b3_s_theta * c_eps;
    const double b4_s_theta = p->b4 * s_theta;
    const double b4_s_theta_s_eps = b4_s_theta * s_eps;
    const double a1_c_theta = p->a1 * c_theta;
    /* equation of eps */
    const double g_eps = a1_c_theta * s_eps + p->a2 * c_eps;
    const double d_eps_ddot_by_f_1 = p->b1 * c_theta;
    const double a3_c_eps = p->a3 * c_eps;
    /* balance of forces */
    const double tau_psi = f_s * b3_s_theta_c_eps - p->c_psi * v->psi - f_d * b4_s_theta_s_eps;
    const double tau_eps = f_s * d_eps_ddot_by_f_1 - p->c_eps * v->eps - g_eps;
    const double tau_theta = p->b2 * f_d - p->c_theta * v->theta - a3_c_eps * s_theta;
    /* derivatives with respect to eps */
    const double d_psi_ddot_by_eps = -f_s * b3_s_theta * s_eps - f_d * b4_s_theta * c_eps;
    const double d_eps_ddot_by_eps = p->a2 * s_eps - a1_c_theta * c_eps;
    const double b4_f_d_s_eps_c_theta = p->b4 * f_d * s_eps * c_theta;
    /* derivatives with respect to theta */
    const double d_psi_ddot_by_theta = p->b3 * f_s * c_eps * c_theta - b4_f_d_s_eps_c_theta;
    const double d_eps_ddot_by_theta = p->a1 * s_eps * s_theta - p->b1 * f_s * s_theta;
    dx[0] = v->psi; /* psi' */
    dx[1] = v->eps; /* eps' */
    dx[2] = v->theta; /* theta' */
    dx[3] = tau_psi; /* psi'' */
    dx[4] = tau_eps; /* eps'' */
    dx[5] = tau_theta; /* theta'' */
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
    a[3][3] = -p->c_psi;
    a[4][1] = d_eps_ddot_by_eps; /* eps'' */
    a[4][2] = d_eps_ddot_by_theta;
    a[4][4] = -p->c_eps;
    a[5][1] = p->a3 * s_theta * s_eps; /* theta'' */
    a[5][2] = -a3_c_eps * c_theta;
    a[5][5] = -p->c_theta;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 2; j++) {
            b[i][j] = 0.0;
        }
    }
    b[3][0] = b3_s_theta_c_eps - b4_s_theta_s_eps; /* psi'' */
    b[3][1] = b3_s_theta_c_eps + b4_s_theta_s_eps;
    b[4][0] = d_eps_ddot_by_f_1; /* eps'' */
    b[4][1] = d_eps_ddot_by_f_1;
    b[5][0] = p->b2; /* theta'' */
    b[5][1] = -p->b2;
    return 0;
}

int googol_identified_parameter_jacobian(
    const struct googol_identified_state *x,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    double by_p[6][22])
{
    const struct googol_identified_coordinates *q = &x->q;
    const struct googol_identified_rates *v = &x->v;
    (void)p;
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double s_eps = sin(q->eps);
    const double c_eps = cos(q->eps);
    const double f_s = u->f_1 + u->f_2;
    const double f_d = u->f_1 - u->f_2;
    /* derivatives with respect to a3 */
    const double d_theta_ddot_by_a3 = -s_theta * c_eps;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 22; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[3][17] = -f_s * d_theta_ddot_by_a3; /* psi'' */
    by_p[3][18] = -f_d * s_theta * s_eps;
    by_p[3][19] = -v->psi;
    by_p[4][12] = -s_eps * c_theta; /* eps'' */
    by_p[4][13] = -c_eps;
    by_p[4][15] = f_s * c_theta;
    by_p[4][20] = -v->eps;
    by_p[5][14] = d_theta_ddot_by_a3; /* theta'' */
    by_p[5][16] = f_d;
    by_p[5][21] = -v->theta;
    return 0;
}

void googol_identified_output_jacobian(
    const struct googol_identified_state *x,
    const struct googol_identified_parameters *p,
    double by_x[3][6],
    double by_p[3][22])
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
        for (int j = 0; j < 22; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

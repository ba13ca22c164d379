/*
 * EMPS, electro-mechanical positioning system.
 * Generated from `emps.rig` (model d1922771); edit the rig, not this file.
 *
 * A carriage on a ball screw with a direct-current motor, seen from the carriage: the benchmark of Janot,
 * Gautier and Brunot, "Data set and reference models of EMPS", Workshop on Nonlinear System Identification
 * Benchmarks, 2019, with its published inverse-dynamics estimates. The offset is part of the friction,
 * since the benchmark counts it there.
 *
 * 10 operations forward, 19 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "emps.h"

#include <math.h>

void emps_nominal(struct emps_parameters *p)
{
    p->M = 95.1089;
    p->F_v = 203.5034;
    p->F_c = 20.3935;
    p->F_0 = -3.1648;
    p->v_c = 0.001;
    p->G = 35.15065188;
}

void emps_mass_matrix(const struct emps_coordinates *q, const struct emps_parameters *p, double m[1][1])
{
    (void)q;
    m[0][0] = p->M; /* q */
}

void emps_bias(const struct emps_coordinates *q, const struct emps_rates *v, const struct emps_parameters *p, double h[1])
{
    (void)q;
    (void)v;
    (void)p;
    h[0] = 0.0; /* q */
}

void emps_velocity_products(const struct emps_coordinates *q, const struct emps_rates *v, const struct emps_parameters *p, double c[1])
{
    (void)q;
    (void)v;
    (void)p;
    c[0] = 0.0; /* q */
}

void emps_gravity(const struct emps_coordinates *q, const struct emps_parameters *p, double g[1])
{
    (void)q;
    (void)p;
    g[0] = 0.0; /* q */
}

void emps_dissipation(const struct emps_coordinates *q, const struct emps_rates *v, const struct emps_parameters *p, double d[1])
{
    (void)q;
    /* friction of q */
    const double d_q = p->F_0 + p->F_v * v->q + p->F_c * tanh(v->q / p->v_c);
    d[0] = d_q; /* q */
}

void emps_generalized_force(const struct emps_coordinates *q, const struct emps_inputs *u, const struct emps_parameters *p, double f[1])
{
    (void)q;
    f[0] = p->G * u->V; /* q */
}

void emps_input_map(const struct emps_coordinates *q, const struct emps_parameters *p, double s[1][1])
{
    (void)q;
    s[0][0] = p->G; /* q */
}

double emps_kinetic_energy(const struct emps_coordinates *q, const struct emps_rates *v, const struct emps_parameters *p)
{
    (void)q;
    return 0.5 * p->M * v->q * v->q;
}

double emps_potential_energy(const struct emps_coordinates *q, const struct emps_parameters *p)
{
    (void)q;
    (void)p;
    return 0.0;
}

void emps_inverse_dynamics(
    const struct emps_state *x,
    const struct emps_accelerations *a,
    const struct emps_inputs *u,
    const struct emps_parameters *p,
    double r[1])
{
    const struct emps_rates *v = &x->v;
    /* friction of q */
    const double d_q = p->F_0 + p->F_v * v->q + p->F_c * tanh(v->q / p->v_c);
    r[0] = d_q + p->M * a->q - p->G * u->V; /* q */
}

void emps_outputs(const struct emps_state *x, const struct emps_parameters *p, struct emps_outputs *y)
{
    const struct emps_coordinates *q = &x->q;
    (void)p;
    y->q = q->q;
}

void emps_pivots(const struct emps_state *x, const struct emps_parameters *p, double d[1])
{
    (void)x;
    d[0] = p->M; /* q */
}

int emps_forward_dynamics(
    const struct emps_state *x,
    const struct emps_inputs *u,
    const struct emps_parameters *p,
    struct emps_accelerations *a)
{
    const struct emps_rates *v = &x->v;
    /* friction of q */
    const double d_q = p->F_0 + p->F_v * v->q + p->F_c * tanh(v->q / p->v_c);
    /* M = L^T D L and back-substitution */
    const double q_ddot = (p->G * u->V - d_q) / p->M;
    if (!(p->M > 0.0)) {
        return 1;
    }
    a->q = q_ddot;
    return 0;
}

int emps_linearize(
    const struct emps_state *x,
    const struct emps_inputs *u,
    const struct emps_parameters *p,
    double dx[2],
    double a[2][2],
    double b[2][1])
{
    const struct emps_rates *v = &x->v;
    const double tanh_q_dot_per_v_c = tanh(v->q / p->v_c);
    /* friction of q */
    const double d_q = p->F_0 + p->F_v * v->q + p->F_c * tanh_q_dot_per_v_c;
    /* M = L^T D L and back-substitution */
    const double inv_q = 1.0 / p->M;
    const double q_ddot = inv_q * (p->G * u->V - d_q);
    /* derivatives with respect to q_dot */
    const double d_q_ddot_by_q_dot = -inv_q * (p->F_v + p->F_c * (1.0 - tanh_q_dot_per_v_c * tanh_q_dot_per_v_c) / p->v_c);
    if (!(p->M > 0.0)) {
        return 1;
    }
    dx[0] = v->q; /* q' */
    dx[1] = q_ddot; /* q'' */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][1] = 1.0; /* q' */
    a[1][1] = d_q_ddot_by_q_dot; /* q'' */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 1; j++) {
            b[i][j] = 0.0;
        }
    }
    b[1][0] = p->G * inv_q; /* q'' */
    return 0;
}

int emps_linearize_without_friction_slope(
    const struct emps_state *x,
    const struct emps_inputs *u,
    const struct emps_parameters *p,
    double dx[2],
    double a[2][2],
    double b[2][1])
{
    const struct emps_rates *v = &x->v;
    /* friction of q */
    const double d_q = p->F_0 + p->F_v * v->q + p->F_c * tanh(v->q / p->v_c);
    /* M = L^T D L and back-substitution */
    const double inv_q = 1.0 / p->M;
    const double q_ddot = inv_q * (p->G * u->V - d_q);
    if (!(p->M > 0.0)) {
        return 1;
    }
    dx[0] = v->q; /* q' */
    dx[1] = q_ddot; /* q'' */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][1] = 1.0; /* q' */
    a[1][1] = -p->F_v * inv_q; /* q'' */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 1; j++) {
            b[i][j] = 0.0;
        }
    }
    b[1][0] = p->G * inv_q; /* q'' */
    return 0;
}

int emps_parameter_jacobian(const struct emps_state *x, const struct emps_inputs *u, const struct emps_parameters *p, double by_p[2][6])
{
    const struct emps_rates *v = &x->v;
    const double q_dot_per_v_c = v->q / p->v_c;
    const double tanh_q_dot_per_v_c = tanh(q_dot_per_v_c);
    /* friction of q */
    const double d_q = p->F_0 + p->F_v * v->q + p->F_c * tanh_q_dot_per_v_c;
    /* M = L^T D L and back-substitution */
    const double inv_q = 1.0 / p->M;
    const double q_ddot = inv_q * (p->G * u->V - d_q);
    /* derivatives with respect to v_c */
    const double d_q_ddot_by_v_c = p->F_c * inv_q * q_dot_per_v_c * (1.0 - tanh_q_dot_per_v_c * tanh_q_dot_per_v_c) / p->v_c;
    if (!(p->M > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 6; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[1][0] = -inv_q * q_ddot; /* q'' */
    by_p[1][1] = -inv_q * v->q;
    by_p[1][2] = -tanh_q_dot_per_v_c * inv_q;
    by_p[1][3] = -inv_q;
    by_p[1][4] = d_q_ddot_by_v_c;
    by_p[1][5] = inv_q * u->V;
    return 0;
}

void emps_output_jacobian(const struct emps_state *x, const struct emps_parameters *p, double by_x[1][2], double by_p[1][6])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 1; i++) {
        for (int j = 0; j < 2; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* q */
    for (int i = 0; i < 1; i++) {
        for (int j = 0; j < 6; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

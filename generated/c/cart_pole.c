/*
 * Cart and pole.
 * Generated from `cart_pole.rig` (model eaaaff00); edit the rig, not this file.
 *
 * The numbers of gymnasium's CartPole (cart 1 kg, pole 0.1 kg, half length 0.5 m), with the pole a
 * uniform rod. theta = 0 is upright, positive towards +x.
 *
 * 33 operations forward, 64 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "cart_pole.h"

#include <math.h>

void cart_pole_nominal(struct cart_pole_parameters *p)
{
    p->m_c = 1.0;
    p->m_p = 0.1;
    p->l = 0.5;
    p->g = 9.8;
}

void cart_pole_mass_matrix(const struct cart_pole_coordinates *q, const struct cart_pole_parameters *p, double m[2][2])
{
    const double c_theta = cos(q->theta);
    const double J = p->m_p * p->l * p->l / 3.0;
    /* body rod on pole */
    const double mc_pole_z = p->m_p * p->l;
    /* frame pole on rail */
    const double M_x_theta = mc_pole_z * c_theta;
    m[0][0] = p->m_c + p->m_p; /* x */
    m[0][1] = M_x_theta;
    m[1][0] = M_x_theta; /* theta */
    m[1][1] = J + p->l * mc_pole_z;
}

void cart_pole_bias(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_rates *v,
    const struct cart_pole_parameters *p,
    double h[2])
{
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    /* body rod on pole */
    const double mc_pole_z = p->m_p * p->l;
    /* frame pole on rail */
    const double a_pole_x = -p->g * s_theta;
    const double f_pole_z = p->m_p * p->g * c_theta - mc_pole_z * v->theta * v->theta;
    const double f_rail_x = f_pole_z * s_theta + p->m_p * a_pole_x * c_theta;
    h[0] = f_rail_x; /* x */
    h[1] = mc_pole_z * a_pole_x; /* theta */
}

void cart_pole_velocity_products(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_rates *v,
    const struct cart_pole_parameters *p,
    double c[2])
{
    const double s_theta = sin(q->theta);
    /* frame pole on rail */
    const double f_moving_pole_z = -p->m_p * p->l * v->theta * v->theta;
    c[0] = f_moving_pole_z * s_theta; /* x */
    c[1] = 0.0; /* theta */
}

void cart_pole_gravity(const struct cart_pole_coordinates *q, const struct cart_pole_parameters *p, double g[2])
{
    const double s_theta = sin(q->theta);
    const double g_theta = -p->m_p * p->l * p->g * s_theta;
    g[0] = 0.0; /* x */
    g[1] = g_theta; /* theta */
}

void cart_pole_dissipation(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_rates *v,
    const struct cart_pole_parameters *p,
    double d[2])
{
    (void)q;
    (void)v;
    (void)p;
    d[0] = 0.0; /* x */
    d[1] = 0.0; /* theta */
}

void cart_pole_generalized_force(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    double f[2])
{
    (void)q;
    (void)p;
    f[0] = u->F; /* x */
    f[1] = 0.0; /* theta */
}

void cart_pole_input_map(const struct cart_pole_coordinates *q, const struct cart_pole_parameters *p, double s[2][1])
{
    (void)q;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 1; j++) {
            s[i][j] = 0.0;
        }
    }
    s[0][0] = 1.0; /* x */
}

double cart_pole_kinetic_energy(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_rates *v,
    const struct cart_pole_parameters *p)
{
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double J = p->m_p * p->l * p->l / 3.0;
    const double s_theta_x_dot = s_theta * v->x;
    /* body rod on pole */
    const double rod_1 = c_theta * v->x + p->l * v->theta;
    const double rod_2 = p->m_p * (rod_1 * rod_1 + s_theta_x_dot * s_theta_x_dot);
    return 0.5 * p->m_c * v->x * v->x + 0.5 * (rod_2 + J * v->theta * v->theta);
}

double cart_pole_potential_energy(const struct cart_pole_coordinates *q, const struct cart_pole_parameters *p)
{
    const double c_theta = cos(q->theta);
    return p->m_p * p->l * p->g * c_theta;
}

void cart_pole_inverse_dynamics(
    const struct cart_pole_state *x,
    const struct cart_pole_accelerations *a,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    double r[2])
{
    const struct cart_pole_coordinates *q = &x->q;
    const struct cart_pole_rates *v = &x->v;
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double J = p->m_p * p->l * p->l / 3.0;
    /* body rod on pole */
    const double mc_pole_z = p->m_p * p->l;
    /* frame pole on rail */
    const double a_pole_z = p->g * c_theta + s_theta * a->x;
    const double a_pole_x = c_theta * a->x - p->g * s_theta;
    const double f_net_pole_x = p->m_p * a_pole_x + mc_pole_z * a->theta;
    const double f_net_pole_z = p->m_p * a_pole_z - mc_pole_z * v->theta * v->theta;
    const double n_net_pole_y = a->theta * (J + p->l * mc_pole_z) + mc_pole_z * a_pole_x;
    /* frame rail on ground */
    const double f_net_rail_x = p->m_c * a->x + f_net_pole_z * s_theta + f_net_pole_x * c_theta;
    r[0] = f_net_rail_x - u->F; /* x */
    r[1] = n_net_pole_y; /* theta */
}

void cart_pole_outputs(const struct cart_pole_state *x, const struct cart_pole_parameters *p, struct cart_pole_outputs *y)
{
    const struct cart_pole_coordinates *q = &x->q;
    (void)p;
    y->x = q->x;
    y->theta = q->theta;
}

void cart_pole_pivots(const struct cart_pole_state *x, const struct cart_pole_parameters *p, double d[2])
{
    const struct cart_pole_coordinates *q = &x->q;
    const double c_theta = cos(q->theta);
    const double J = p->m_p * p->l * p->l / 3.0;
    /* body rod on pole */
    const double mc_pole_z = p->m_p * p->l;
    const double I_pole_xx = J + p->l * mc_pole_z;
    /* frame pole on rail */
    const double M_x_theta = mc_pole_z * c_theta;
    /* M = L^T D L and back-substitution */
    const double pivot_x = p->m_c + p->m_p - M_x_theta * M_x_theta / I_pole_xx;
    d[0] = pivot_x; /* x */
    d[1] = I_pole_xx; /* theta */
}

int cart_pole_forward_dynamics(
    const struct cart_pole_state *x,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    struct cart_pole_accelerations *a)
{
    const struct cart_pole_coordinates *q = &x->q;
    const struct cart_pole_rates *v = &x->v;
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double J = p->m_p * p->l * p->l / 3.0;
    /* body rod on pole */
    const double mc_pole_z = p->m_p * p->l;
    const double I_pole_xx = J + p->l * mc_pole_z;
    /* frame pole on rail */
    const double a_pole_x = -p->g * s_theta;
    const double n_weight_pole_y = mc_pole_z * a_pole_x;
    const double f_pole_z = p->m_p * p->g * c_theta - mc_pole_z * v->theta * v->theta;
    const double f_rail_x = f_pole_z * s_theta + p->m_p * a_pole_x * c_theta;
    const double M_x_theta = mc_pole_z * c_theta;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / I_pole_xx;
    const double l_theta_x = M_x_theta * inv_theta;
    const double pivot_x = p->m_c + p->m_p - M_x_theta * l_theta_x;
    const double x_ddot = (u->F - f_rail_x + n_weight_pole_y * l_theta_x) / pivot_x;
    const double theta_ddot = -n_weight_pole_y * inv_theta - l_theta_x * x_ddot;
    if (!(I_pole_xx > 0.0)) {
        return 2;
    }
    if (!(pivot_x > 0.0)) {
        return 1;
    }
    a->x = x_ddot;
    a->theta = theta_ddot;
    return 0;
}

int cart_pole_linearize(
    const struct cart_pole_state *x,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][1])
{
    const struct cart_pole_coordinates *q = &x->q;
    const struct cart_pole_rates *v = &x->v;
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double J = p->m_p * p->l * p->l / 3.0;
    /* body rod on pole */
    const double mc_pole_z = p->m_p * p->l;
    const double I_pole_xx = J + p->l * mc_pole_z;
    /* frame pole on rail */
    const double f_moving_pole_z = -mc_pole_z * v->theta * v->theta;
    const double a_pole_z = p->g * c_theta;
    const double a_pole_x = -p->g * s_theta;
    const double n_weight_pole_y = mc_pole_z * a_pole_x;
    const double f_rail_x = s_theta * (p->m_p * a_pole_z + f_moving_pole_z) + p->m_p * a_pole_x * c_theta;
    const double M_x_theta = mc_pole_z * c_theta;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / I_pole_xx;
    const double l_theta_x = M_x_theta * inv_theta;
    const double pivot_x = p->m_c + p->m_p - M_x_theta * l_theta_x;
    const double inv_x = 1.0 / pivot_x;
    const double x_ddot = inv_x * (u->F - f_rail_x + n_weight_pole_y * l_theta_x);
    const double theta_ddot = -n_weight_pole_y * inv_theta - l_theta_x * x_ddot;
    const double a_pole_z_plus_x_ddot_s_theta = a_pole_z + x_ddot * s_theta;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = p->m_p * (x_ddot * c_theta + a_pole_x);
    const double slopes_2 = p->m_p * a_pole_z_plus_x_ddot_s_theta;
    const double slopes_3 = c_theta * (slopes_2 + f_moving_pole_z);
    const double slopes_4 = s_theta * (slopes_1 + mc_pole_z * theta_ddot);
    const double slopes_5 = mc_pole_z * a_pole_z_plus_x_ddot_s_theta;
    const double slopes_6 = slopes_3 + slopes_1 * s_theta;
    /* derivatives with respect to theta */
    const double by_theta_1 = slopes_4 + slopes_2 * c_theta - slopes_6;
    const double d_x_ddot_by_theta = inv_x * (by_theta_1 - l_theta_x * slopes_5);
    const double d_theta_ddot_by_theta = inv_theta * slopes_5 - l_theta_x * d_x_ddot_by_theta;
    /* derivatives with respect to theta_dot */
    const double d_x_ddot_by_theta_dot = 2.0 * inv_x * mc_pole_z * s_theta * v->theta;
    if (!(I_pole_xx > 0.0)) {
        return 2;
    }
    if (!(pivot_x > 0.0)) {
        return 1;
    }
    dx[0] = v->x; /* x' */
    dx[1] = v->theta; /* theta' */
    dx[2] = x_ddot; /* x'' */
    dx[3] = theta_ddot; /* theta'' */
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][2] = 1.0; /* x' */
    a[1][3] = 1.0; /* theta' */
    a[2][1] = d_x_ddot_by_theta; /* x'' */
    a[2][3] = d_x_ddot_by_theta_dot;
    a[3][1] = d_theta_ddot_by_theta; /* theta'' */
    a[3][3] = -l_theta_x * d_x_ddot_by_theta_dot;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 1; j++) {
            b[i][j] = 0.0;
        }
    }
    b[2][0] = inv_x; /* x'' */
    b[3][0] = -l_theta_x * inv_x; /* theta'' */
    return 0;
}

int cart_pole_parameter_jacobian(
    const struct cart_pole_state *x,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    double by_p[4][4])
{
    const struct cart_pole_coordinates *q = &x->q;
    const struct cart_pole_rates *v = &x->v;
    const double s_theta = sin(q->theta);
    const double c_theta = cos(q->theta);
    const double l_sq = p->l * p->l;
    /* body rod on pole */
    const double mc_pole_z = p->m_p * p->l;
    const double I_pole_xx = p->m_p * l_sq / 3.0 + p->l * mc_pole_z;
    const double theta_dot_sq = v->theta * v->theta;
    /* frame pole on rail */
    const double a_pole_z = p->g * c_theta;
    const double a_pole_x = -p->g * s_theta;
    const double n_weight_pole_y = mc_pole_z * a_pole_x;
    const double f_pole_z = p->m_p * a_pole_z - mc_pole_z * theta_dot_sq;
    const double f_rail_x = f_pole_z * s_theta + p->m_p * a_pole_x * c_theta;
    const double mc_pole_z_s_theta = mc_pole_z * s_theta;
    const double M_x_theta = mc_pole_z * c_theta;
    /* M = L^T D L and back-substitution */
    const double inv_theta = 1.0 / I_pole_xx;
    const double l_theta_x = M_x_theta * inv_theta;
    const double pivot_x = p->m_c + p->m_p - M_x_theta * l_theta_x;
    const double inv_x = 1.0 / pivot_x;
    const double x_ddot = inv_x * (u->F - f_rail_x + n_weight_pole_y * l_theta_x);
    const double theta_ddot = -n_weight_pole_y * inv_theta - l_theta_x * x_ddot;
    const double x_ddot_c_theta_plus_a_pole_x = x_ddot * c_theta + a_pole_x;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = theta_ddot * (l_sq + l_sq / 3.0) + p->l * x_ddot_c_theta_plus_a_pole_x;
    const double slopes_2 = s_theta * (a_pole_z + x_ddot * s_theta - p->l * theta_dot_sq);
    const double slopes_3 = slopes_2 + c_theta * (x_ddot_c_theta_plus_a_pole_x + p->l * theta_ddot);
    const double slopes_4 = p->m_p * x_ddot_c_theta_plus_a_pole_x + theta_ddot * (2.0 * p->m_p * p->l / 3.0 + 2.0 * mc_pole_z);
    const double m_p_s_theta_c_theta = p->m_p * s_theta * c_theta;
    /* derivatives with respect to g */
    const double by_g_1 = p->m_p * c_theta * s_theta - m_p_s_theta_c_theta;
    const double d_x_ddot_by_g = inv_x * (by_g_1 - mc_pole_z_s_theta * l_theta_x);
    const double d_theta_ddot_by_g = mc_pole_z_s_theta * inv_theta - l_theta_x * d_x_ddot_by_g;
    /* derivatives with respect to m_c */
    const double d_x_ddot_by_m_c = -inv_x * x_ddot;
    /* derivatives with respect to m_p */
    const double d_x_ddot_by_m_p = inv_x * (l_theta_x * slopes_1 - slopes_3);
    const double d_theta_ddot_by_m_p = -inv_theta * slopes_1 - l_theta_x * d_x_ddot_by_m_p;
    /* derivatives with respect to l */
    const double by_l_1 = p->m_p * theta_dot_sq * s_theta - p->m_p * theta_ddot * c_theta;
    const double d_x_ddot_by_l = inv_x * (by_l_1 + l_theta_x * slopes_4);
    const double d_theta_ddot_by_l = -inv_theta * slopes_4 - l_theta_x * d_x_ddot_by_l;
    if (!(I_pole_xx > 0.0)) {
        return 2;
    }
    if (!(pivot_x > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[2][0] = d_x_ddot_by_m_c; /* x'' */
    by_p[2][1] = d_x_ddot_by_m_p;
    by_p[2][2] = d_x_ddot_by_l;
    by_p[2][3] = d_x_ddot_by_g;
    by_p[3][0] = -l_theta_x * d_x_ddot_by_m_c; /* theta'' */
    by_p[3][1] = d_theta_ddot_by_m_p;
    by_p[3][2] = d_theta_ddot_by_l;
    by_p[3][3] = d_theta_ddot_by_g;
    return 0;
}

void cart_pole_output_jacobian(const struct cart_pole_state *x, const struct cart_pole_parameters *p, double by_x[2][4], double by_p[2][4])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 4; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* x */
    by_x[1][1] = 1.0; /* theta */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 4; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

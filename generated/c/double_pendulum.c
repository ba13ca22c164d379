/*
 * Double pendulum with quasi-direct drives and a belt to the elbow.
 * Generated from `double_pendulum.rig` (model b0557872); edit the rig, not this file.
 *
 * Both motors sit at the shoulder end; the second one drives the elbow through a belt, so that its rotor
 * turns by q1 - n q2. Both rotors turn n times as fast as their joints. Identified numbers of design A.0,
 * model 2.0, of the DFKI underactuated lab (github.com/dfki-ric-underactuated-lab/double_pendulum,
 * BSD-3-Clause): inertias about the joints, rotor inertia, friction. The published friction law is
 * b v + c_f atan(100 v); here the same level, c_f pi/2, and the same slope at rest in one regularized
 * Coulomb law. q1 = 0 hangs; q2 relative to the upper link.
 *
 * 83 operations forward, 182 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "double_pendulum.h"

#include <math.h>

void double_pendulum_nominal(struct double_pendulum_parameters *p)
{
    p->m_1 = 0.5593806151425046;
    p->m_2 = 0.6043459469186889;
    p->r_1 = 0.3;
    p->r_2 = 0.18377686083653508;
    p->l_1 = 0.3;
    p->I_1 = 0.053470810264216295;
    p->I_2 = 0.02392374528789766;
    p->I_r = 7.659297952841183e-5;
    p->n = 6.0;
    p->b_1 = 0.001;
    p->b_2 = 0.001;
    p->c_f1 = 0.093;
    p->c_f2 = 0.078;
    p->v_c = 0.015707963267948967;
    p->g = 9.81;
}

void double_pendulum_mass_matrix(const struct double_pendulum_coordinates *q, const struct double_pendulum_parameters *p, double m[2][2])
{
    const double c_q2 = cos(q->q2);
    const double m_2_r_2_c_q2 = p->m_2 * p->r_2 * c_q2;
    const double I_2_plus_l_1_m_2_r_2_c_q2 = p->I_2 + p->l_1 * m_2_r_2_c_q2;
    /* frame upper on ground */
    const double upper_1 = p->I_1 + p->I_2 + p->l_1 * (m_2_r_2_c_q2 + m_2_r_2_c_q2 + p->m_2 * p->l_1);
    const double half_I_r = 0.5 * p->I_r;
    const double two_n = 2.0 * p->n;
    const double two_n_2 = 2.0 * p->n;
    /* kinetic energy rotor_2 */
    const double M_q1_q1 = upper_1 + p->I_r + p->n * half_I_r * two_n;
    const double M_q2_q2 = p->I_2 + p->n * half_I_r * two_n_2;
    m[0][0] = M_q1_q1; /* q1 */
    m[0][1] = I_2_plus_l_1_m_2_r_2_c_q2 - half_I_r * two_n_2;
    m[1][0] = I_2_plus_l_1_m_2_r_2_c_q2 - half_I_r * two_n; /* q2 */
    m[1][1] = M_q2_q2;
}

void double_pendulum_bias(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_rates *v,
    const struct double_pendulum_parameters *p,
    double h[2])
{
    const double s_q1 = sin(q->q1);
    const double c_q1 = cos(q->q1);
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    /* body lower_link on lower */
    const double mc_lower_z = -p->m_2 * p->r_2;
    /* frame lower on upper */
    const double omega_lower_y = -v->q1 - v->q2;
    /* frame upper on ground */
    const double a_upper_x = p->g * s_q1;
    /* frame lower on upper */
    const double a_lower_1_z = p->l_1 * v->q1 * v->q1 + p->g * c_q1;
    const double a_lower_z = a_lower_1_z * c_q2 - a_upper_x * s_q2;
    const double a_lower_x = a_upper_x * c_q2 + a_lower_1_z * s_q2;
    const double f_lower_z = p->m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    const double n_lower_y = mc_lower_z * a_lower_x;
    const double f_lower_1_x = p->m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    /* frame upper on ground */
    const double n_upper_y = n_lower_y - p->m_1 * p->r_1 * a_upper_x - p->l_1 * f_lower_1_x;
    h[0] = -n_upper_y; /* q1 */
    h[1] = -n_lower_y; /* q2 */
}

void double_pendulum_velocity_products(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_rates *v,
    const struct double_pendulum_parameters *p,
    double c[2])
{
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    /* body lower_link on lower */
    const double mc_lower_z = -p->m_2 * p->r_2;
    /* frame lower on upper */
    const double omega_lower_y = -v->q1 - v->q2;
    const double a_lower_1_z = p->l_1 * v->q1 * v->q1;
    const double a_lower_x = a_lower_1_z * s_q2;
    const double f_moving_lower_z = p->m_2 * a_lower_1_z * c_q2 - mc_lower_z * omega_lower_y * omega_lower_y;
    const double n_moving_lower_y = mc_lower_z * a_lower_x;
    const double f_moving_lower_1_x = p->m_2 * a_lower_x * c_q2 - f_moving_lower_z * s_q2;
    c[0] = p->l_1 * f_moving_lower_1_x - n_moving_lower_y; /* q1 */
    c[1] = -n_moving_lower_y; /* q2 */
}

void double_pendulum_gravity(const struct double_pendulum_coordinates *q, const struct double_pendulum_parameters *p, double g[2])
{
    const double s_q1 = sin(q->q1);
    const double c_q1 = cos(q->q1);
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double r_2_c_q2 = p->r_2 * c_q2;
    const double r_2_c_q1_s_q2 = p->r_2 * c_q1 * s_q2;
    const double gravity_1 = p->m_2 * p->g * (s_q1 * (p->l_1 + r_2_c_q2) + r_2_c_q1_s_q2);
    const double g_q1 = p->m_1 * p->r_1 * p->g * s_q1 + gravity_1;
    const double g_q2 = p->m_2 * p->g * (r_2_c_q1_s_q2 + r_2_c_q2 * s_q1);
    g[0] = g_q1; /* q1 */
    g[1] = g_q2; /* q2 */
}

void double_pendulum_dissipation(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_rates *v,
    const struct double_pendulum_parameters *p,
    double d[2])
{
    (void)q;
    /* friction of q1 */
    const double d_q1 = p->b_1 * v->q1 + 1.5707963267948966 * p->c_f1 * tanh(v->q1 / p->v_c);
    /* friction of q2 */
    const double d_q2 = p->b_2 * v->q2 + 1.5707963267948966 * p->c_f2 * tanh(v->q2 / p->v_c);
    d[0] = d_q1; /* q1 */
    d[1] = d_q2; /* q2 */
}

void double_pendulum_generalized_force(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double f[2])
{
    (void)q;
    (void)p;
    f[0] = u->tau_1; /* q1 */
    f[1] = u->tau_2; /* q2 */
}

void double_pendulum_input_map(const struct double_pendulum_coordinates *q, const struct double_pendulum_parameters *p, double s[2][2])
{
    (void)q;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            s[i][j] = 0.0;
        }
    }
    s[0][0] = 1.0; /* q1 */
    s[1][1] = 1.0; /* q2 */
}

double double_pendulum_kinetic_energy(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_rates *v,
    const struct double_pendulum_parameters *p)
{
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    /* frame lower on upper */
    const double omega_lower_y = -v->q1 - v->q2;
    const double half_I_r = 0.5 * p->I_r;
    const double n_q1_dot = p->n * v->q1;
    const double q1_dot_minus_n_q2_dot = v->q1 - p->n * v->q2;
    /* kinetic energy rotor_2 */
    const double rotor_2_1 = half_I_r * q1_dot_minus_n_q2_dot * q1_dot_minus_n_q2_dot;
    const double rotor_2_2 = half_I_r * n_q1_dot * n_q1_dot + rotor_2_1;
    const double l_1_q1_dot = p->l_1 * v->q1;
    const double l_1_q1_dot_s_q2 = l_1_q1_dot * s_q2;
    const double r_1_q1_dot = p->r_1 * v->q1;
    /* body upper_link on upper */
    const double upper_link_1 = p->m_1 * r_1_q1_dot * r_1_q1_dot + v->q1 * v->q1 * (p->I_1 - p->m_1 * p->r_1 * p->r_1);
    /* body lower_link on lower */
    const double lower_link_1 = l_1_q1_dot * c_q2 - p->r_2 * omega_lower_y;
    const double lower_link_2 = p->m_2 * (lower_link_1 * lower_link_1 + l_1_q1_dot_s_q2 * l_1_q1_dot_s_q2);
    const double lower_link_3 = 0.5 * (lower_link_2 + omega_lower_y * omega_lower_y * (p->I_2 - p->m_2 * p->r_2 * p->r_2));
    return rotor_2_2 + 0.5 * upper_link_1 + lower_link_3;
}

double double_pendulum_potential_energy(const struct double_pendulum_coordinates *q, const struct double_pendulum_parameters *p)
{
    const double s_q1 = sin(q->q1);
    const double c_q1 = cos(q->q1);
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double l_1_plus_r_2_c_q2_c_q1 = c_q1 * (p->l_1 + p->r_2 * c_q2);
    /* body lower_link on lower */
    const double lower_link_1 = p->m_2 * p->g * (p->r_2 * s_q1 * s_q2 - l_1_plus_r_2_c_q2_c_q1);
    return lower_link_1 - p->m_1 * p->r_1 * p->g * c_q1;
}

void double_pendulum_inverse_dynamics(
    const struct double_pendulum_state *x,
    const struct double_pendulum_accelerations *a,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double r[2])
{
    const struct double_pendulum_coordinates *q = &x->q;
    const struct double_pendulum_rates *v = &x->v;
    const double s_q1 = sin(q->q1);
    const double c_q1 = cos(q->q1);
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    /* friction of q1 */
    const double d_q1 = p->b_1 * v->q1 + 1.5707963267948966 * p->c_f1 * tanh(v->q1 / p->v_c);
    /* friction of q2 */
    const double d_q2 = p->b_2 * v->q2 + 1.5707963267948966 * p->c_f2 * tanh(v->q2 / p->v_c);
    /* body lower_link on lower */
    const double mc_lower_z = -p->m_2 * p->r_2;
    /* frame lower on upper */
    const double omega_lower_y = -v->q1 - v->q2;
    /* frame upper on ground */
    const double a_upper_x = p->g * s_q1;
    /* frame lower on upper */
    const double a_lower_1_z = p->l_1 * v->q1 * v->q1 + p->g * c_q1;
    const double a_lower_1_x = a_upper_x + p->l_1 * a->q1;
    const double half_I_r = 0.5 * p->I_r;
    const double two_n = 2.0 * p->n;
    const double two_n_2 = 2.0 * p->n;
    /* gravity */
    const double alpha_lower_y = -a->q1 - a->q2;
    /* frame lower on upper */
    const double a_lower_z = a_lower_1_z * c_q2 - a_lower_1_x * s_q2;
    const double a_lower_x = a_lower_1_z * s_q2 + a_lower_1_x * c_q2;
    const double f_net_lower_x = p->m_2 * a_lower_x + mc_lower_z * alpha_lower_y;
    const double f_net_lower_z = p->m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    const double n_net_lower_y = p->I_2 * alpha_lower_y + mc_lower_z * a_lower_x;
    const double f_net_lower_1_x = f_net_lower_x * c_q2 - f_net_lower_z * s_q2;
    /* frame upper on ground */
    const double n_net_upper_y = n_net_lower_y - p->m_1 * p->r_1 * a_upper_x - p->I_1 * a->q1 - p->l_1 * f_net_lower_1_x;
    const double upper_1 = a->q1 * (p->I_r + p->n * half_I_r * two_n) - n_net_upper_y - u->tau_1;
    const double upper_2 = n_net_lower_y + u->tau_2 + half_I_r * two_n * a->q1;
    r[0] = d_q1 + upper_1 - half_I_r * two_n_2 * a->q2; /* q1 */
    r[1] = d_q2 - upper_2 + p->n * half_I_r * two_n_2 * a->q2; /* q2 */
}

void double_pendulum_outputs(
    const struct double_pendulum_state *x,
    const struct double_pendulum_parameters *p,
    struct double_pendulum_outputs *y)
{
    const struct double_pendulum_coordinates *q = &x->q;
    (void)p;
    y->q1 = q->q1;
    y->q2 = q->q2;
}

void double_pendulum_pivots(const struct double_pendulum_state *x, const struct double_pendulum_parameters *p, double d[2])
{
    const struct double_pendulum_coordinates *q = &x->q;
    const double c_q2 = cos(q->q2);
    const double m_2_r_2_c_q2 = p->m_2 * p->r_2 * c_q2;
    const double I_2_plus_l_1_m_2_r_2_c_q2 = p->I_2 + p->l_1 * m_2_r_2_c_q2;
    /* frame upper on ground */
    const double upper_1 = p->I_1 + p->I_2 + p->l_1 * (m_2_r_2_c_q2 + m_2_r_2_c_q2 + p->m_2 * p->l_1);
    const double half_I_r = 0.5 * p->I_r;
    const double two_n = 2.0 * p->n;
    const double two_n_2 = 2.0 * p->n;
    /* kinetic energy rotor_2 */
    const double M_q1_q1 = upper_1 + p->I_r + p->n * half_I_r * two_n;
    const double M_q2_q2 = p->I_2 + p->n * half_I_r * two_n_2;
    /* M = L^T D L and back-substitution */
    const double u_q1_q2 = (I_2_plus_l_1_m_2_r_2_c_q2 - half_I_r * two_n_2) / M_q2_q2;
    const double pivot_q1 = M_q1_q1 - u_q1_q2 * (I_2_plus_l_1_m_2_r_2_c_q2 - half_I_r * two_n);
    d[0] = pivot_q1; /* q1 */
    d[1] = M_q2_q2; /* q2 */
}

int double_pendulum_forward_dynamics(
    const struct double_pendulum_state *x,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    struct double_pendulum_accelerations *a)
{
    const struct double_pendulum_coordinates *q = &x->q;
    const struct double_pendulum_rates *v = &x->v;
    const double s_q1 = sin(q->q1);
    const double c_q1 = cos(q->q1);
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    /* friction of q1 */
    const double d_q1 = p->b_1 * v->q1 + 1.5707963267948966 * p->c_f1 * tanh(v->q1 / p->v_c);
    /* friction of q2 */
    const double d_q2 = p->b_2 * v->q2 + 1.5707963267948966 * p->c_f2 * tanh(v->q2 / p->v_c);
    /* body lower_link on lower */
    const double mc_lower_z = -p->m_2 * p->r_2;
    /* frame lower on upper */
    const double omega_lower_y = -v->q1 - v->q2;
    const double mc_lower_z_c_q2 = mc_lower_z * c_q2;
    const double lower_1 = p->I_2 - p->l_1 * mc_lower_z_c_q2;
    /* frame upper on ground */
    const double a_upper_x = p->g * s_q1;
    const double upper_1 = p->I_1 + p->I_2 + p->l_1 * (p->m_2 * p->l_1 - mc_lower_z_c_q2 - mc_lower_z_c_q2);
    /* frame lower on upper */
    const double a_lower_1_z = p->l_1 * v->q1 * v->q1 + p->g * c_q1;
    const double a_lower_z = a_lower_1_z * c_q2 - a_upper_x * s_q2;
    const double a_lower_x = a_upper_x * c_q2 + a_lower_1_z * s_q2;
    const double f_lower_z = p->m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    const double n_lower_y = mc_lower_z * a_lower_x;
    const double f_lower_1_x = p->m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    /* frame upper on ground */
    const double n_upper_y = n_lower_y - p->m_1 * p->r_1 * a_upper_x - p->l_1 * f_lower_1_x;
    const double half_I_r = 0.5 * p->I_r;
    const double two_n = 2.0 * p->n;
    const double two_n_2 = 2.0 * p->n;
    /* kinetic energy rotor_2 */
    const double M_q1_q1 = upper_1 + p->I_r + p->n * half_I_r * two_n;
    const double lower_1_minus_half_I_r_two_n = lower_1 - half_I_r * two_n;
    const double M_q2_q2 = p->I_2 + p->n * half_I_r * two_n_2;
    /* balance of forces */
    const double tau_q2 = n_lower_y - d_q2 + u->tau_2;
    /* M = L^T D L and back-substitution */
    const double inv_q2 = 1.0 / M_q2_q2;
    const double u_q1_q2 = inv_q2 * (lower_1 - half_I_r * two_n_2);
    const double pivot_q1 = M_q1_q1 - lower_1_minus_half_I_r_two_n * u_q1_q2;
    const double q1_ddot = (n_upper_y - tau_q2 * u_q1_q2 - d_q1 + u->tau_1) / pivot_q1;
    const double q2_ddot = tau_q2 * inv_q2 - lower_1_minus_half_I_r_two_n * inv_q2 * q1_ddot;
    if (!(M_q2_q2 > 0.0)) {
        return 2;
    }
    if (!(pivot_q1 > 0.0)) {
        return 1;
    }
    a->q1 = q1_ddot;
    a->q2 = q2_ddot;
    return 0;
}

int double_pendulum_linearize(
    const struct double_pendulum_state *x,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][2])
{
    const struct double_pendulum_coordinates *q = &x->q;
    const struct double_pendulum_rates *v = &x->v;
    const double s_q1 = sin(q->q1);
    const double c_q1 = cos(q->q1);
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    /* friction of q1 */
    const double friction_q1_1 = 1.5707963267948966 * p->c_f1;
    const double tanh_q1_dot_per_v_c = tanh(v->q1 / p->v_c);
    const double d_q1 = p->b_1 * v->q1 + friction_q1_1 * tanh_q1_dot_per_v_c;
    /* friction of q2 */
    const double friction_q2_1 = 1.5707963267948966 * p->c_f2;
    const double tanh_q2_dot_per_v_c = tanh(v->q2 / p->v_c);
    const double d_q2 = p->b_2 * v->q2 + friction_q2_1 * tanh_q2_dot_per_v_c;
    /* body upper_link on upper */
    const double mc_upper_z = -p->m_1 * p->r_1;
    /* body lower_link on lower */
    const double mc_lower_z = -p->m_2 * p->r_2;
    /* frame lower on upper */
    const double omega_lower_y = -v->q1 - v->q2;
    const double mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y * omega_lower_y;
    const double mc_lower_z_c_q2 = mc_lower_z * c_q2;
    const double lower_1 = p->I_2 - p->l_1 * mc_lower_z_c_q2;
    /* frame upper on ground */
    const double a_upper_z = p->g * c_q1;
    const double a_upper_x = p->g * s_q1;
    const double upper_1 = p->I_1 + p->I_2 + p->l_1 * (p->m_2 * p->l_1 - mc_lower_z_c_q2 - mc_lower_z_c_q2);
    const double a_upper_x_s_q2 = a_upper_x * s_q2;
    const double a_upper_x_c_q2 = a_upper_x * c_q2;
    /* frame lower on upper */
    const double a_lower_z = a_upper_z * c_q2 - a_upper_x_s_q2;
    const double f_weight_lower_x = p->m_2 * (a_upper_z * s_q2 + a_upper_x_c_q2);
    const double f_weight_lower_1_z = p->m_2 * a_lower_z * c_q2 + f_weight_lower_x * s_q2;
    const double a_lower_1_z = p->l_1 * v->q1 * v->q1 + a_upper_z;
    const double a_lower_1_z_c_q2 = a_lower_1_z * c_q2;
    const double a_lower_1_z_s_q2 = a_lower_1_z * s_q2;
    const double a_lower_x = a_upper_x_c_q2 + a_lower_1_z_s_q2;
    const double f_lower_z = p->m_2 * (a_lower_1_z_c_q2 - a_upper_x_s_q2) - mc_lower_z_omega_lower_y_sq;
    const double n_lower_y = mc_lower_z * a_lower_x;
    const double f_lower_1_x = p->m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    /* frame upper on ground */
    const double n_upper_y = mc_upper_z * a_upper_x + n_lower_y - p->l_1 * f_lower_1_x;
    const double half_I_r = 0.5 * p->I_r;
    const double two_n = 2.0 * p->n;
    const double two_n_2 = 2.0 * p->n;
    /* kinetic energy rotor_2 */
    const double M_q1_q1 = upper_1 + p->I_r + p->n * half_I_r * two_n;
    const double lower_1_minus_half_I_r_two_n = lower_1 - half_I_r * two_n;
    const double M_q2_q2 = p->I_2 + p->n * half_I_r * two_n_2;
    /* balance of forces */
    const double tau_q2 = n_lower_y - d_q2 + u->tau_2;
    /* M = L^T D L and back-substitution */
    const double inv_q2 = 1.0 / M_q2_q2;
    const double l_q2_q1 = lower_1_minus_half_I_r_two_n * inv_q2;
    const double u_q1_q2 = inv_q2 * (lower_1 - half_I_r * two_n_2);
    const double pivot_q1 = M_q1_q1 - lower_1_minus_half_I_r_two_n * u_q1_q2;
    const double inv_q1 = 1.0 / pivot_q1;
    const double q1_ddot = inv_q1 * (n_upper_y - tau_q2 * u_q1_q2 - d_q1 + u->tau_1);
    const double q2_ddot = tau_q2 * inv_q2 - l_q2_q1 * q1_ddot;
    const double mc_lower_z_a_lower_z = mc_lower_z * a_lower_z;
    /* derivatives with respect to q1 */
    const double by_q1_1 = mc_upper_z * a_upper_z - u_q1_q2 * mc_lower_z_a_lower_z + mc_lower_z_a_lower_z - p->l_1 * f_weight_lower_1_z;
    const double d_q1_ddot_by_q1 = inv_q1 * by_q1_1;
    const double d_q2_ddot_by_q1 = inv_q2 * mc_lower_z_a_lower_z - l_q2_q1 * d_q1_ddot_by_q1;
    const double inv_v_c = 1.0 / p->v_c;
    /* derivatives with respect to q1_dot */
    const double by_q1_dot_1 = p->b_1 + friction_q1_1 * inv_v_c * (1.0 - tanh_q1_dot_per_v_c * tanh_q1_dot_per_v_c);
    const double two_l_1_q1_dot = 2.0 * p->l_1 * v->q1;
    const double two_mc_lower_z_omega_lower_y = 2.0 * mc_lower_z * omega_lower_y;
    const double two_l_1_q1_dot_s_q2 = two_l_1_q1_dot * s_q2;
    const double by_q1_dot_2 = mc_lower_z * two_l_1_q1_dot_s_q2;
    const double by_q1_dot_3 = s_q2 * (two_mc_lower_z_omega_lower_y + p->m_2 * two_l_1_q1_dot * c_q2);
    const double by_q1_dot_4 = p->l_1 * (p->m_2 * two_l_1_q1_dot_s_q2 * c_q2 - by_q1_dot_3);
    const double by_q1_dot_5 = by_q1_dot_2 - u_q1_q2 * by_q1_dot_2 - by_q1_dot_1 - by_q1_dot_4;
    const double d_q1_ddot_by_q1_dot = inv_q1 * by_q1_dot_5;
    const double d_q2_ddot_by_q1_dot = inv_q2 * by_q1_dot_2 - l_q2_q1 * d_q1_ddot_by_q1_dot;
    /* derivatives with respect to q2_dot */
    const double by_q2_dot_1 = p->b_2 + friction_q2_1 * inv_v_c * (1.0 - tanh_q2_dot_per_v_c * tanh_q2_dot_per_v_c);
    const double d_q1_ddot_by_q2_dot = inv_q1 * (p->l_1 * two_mc_lower_z_omega_lower_y * s_q2 + u_q1_q2 * by_q2_dot_1);
    const double d_q2_ddot_by_q2_dot = -inv_q2 * by_q2_dot_1 - l_q2_q1 * d_q1_ddot_by_q2_dot;
    const double a_upper_x_plus_l_1_q1_ddot = a_upper_x + p->l_1 * q1_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = a_lower_1_z_c_q2 - a_upper_x_plus_l_1_q1_ddot * s_q2;
    const double slopes_2 = p->m_2 * (a_lower_1_z_s_q2 + a_upper_x_plus_l_1_q1_ddot * c_q2);
    const double m_2_slopes_1 = p->m_2 * slopes_1;
    const double slopes_3 = c_q2 * (m_2_slopes_1 - mc_lower_z_omega_lower_y_sq);
    const double slopes_4 = s_q2 * (slopes_2 - mc_lower_z * (q1_ddot + q2_ddot));
    const double mc_lower_z_slopes_1 = mc_lower_z * slopes_1;
    const double slopes_3_minus_slopes_2_s_q2 = slopes_3 - slopes_2 * s_q2;
    const double slopes_5 = p->l_1 * (m_2_slopes_1 * c_q2 - slopes_4 - slopes_3_minus_slopes_2_s_q2);
    /* derivatives with respect to q2 */
    const double d_q1_ddot_by_q2 = inv_q1 * (mc_lower_z_slopes_1 - u_q1_q2 * mc_lower_z_slopes_1 - slopes_5);
    const double d_q2_ddot_by_q2 = inv_q2 * mc_lower_z_slopes_1 - l_q2_q1 * d_q1_ddot_by_q2;
    /* derivatives with respect to tau_2 */
    const double d_q1_ddot_by_tau_2 = -u_q1_q2 * inv_q1;
    if (!(M_q2_q2 > 0.0)) {
        return 2;
    }
    if (!(pivot_q1 > 0.0)) {
        return 1;
    }
    dx[0] = v->q1; /* q1' */
    dx[1] = v->q2; /* q2' */
    dx[2] = q1_ddot; /* q1'' */
    dx[3] = q2_ddot; /* q2'' */
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][2] = 1.0; /* q1' */
    a[1][3] = 1.0; /* q2' */
    a[2][0] = d_q1_ddot_by_q1; /* q1'' */
    a[2][1] = d_q1_ddot_by_q2;
    a[2][2] = d_q1_ddot_by_q1_dot;
    a[2][3] = d_q1_ddot_by_q2_dot;
    a[3][0] = d_q2_ddot_by_q1; /* q2'' */
    a[3][1] = d_q2_ddot_by_q2;
    a[3][2] = d_q2_ddot_by_q1_dot;
    a[3][3] = d_q2_ddot_by_q2_dot;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 2; j++) {
            b[i][j] = 0.0;
        }
    }
    b[2][0] = inv_q1; /* q1'' */
    b[2][1] = d_q1_ddot_by_tau_2;
    b[3][0] = -l_q2_q1 * inv_q1; /* q2'' */
    b[3][1] = inv_q2 - l_q2_q1 * d_q1_ddot_by_tau_2;
    return 0;
}

int double_pendulum_linearize_without_friction_slope(
    const struct double_pendulum_state *x,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][2])
{
    const struct double_pendulum_coordinates *q = &x->q;
    const struct double_pendulum_rates *v = &x->v;
    const double s_q1 = sin(q->q1);
    const double c_q1 = cos(q->q1);
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    /* friction of q1 */
    const double d_q1 = p->b_1 * v->q1 + 1.5707963267948966 * p->c_f1 * tanh(v->q1 / p->v_c);
    /* friction of q2 */
    const double d_q2 = p->b_2 * v->q2 + 1.5707963267948966 * p->c_f2 * tanh(v->q2 / p->v_c);
    /* body upper_link on upper */
    const double mc_upper_z = -p->m_1 * p->r_1;
    /* body lower_link on lower */
    const double mc_lower_z = -p->m_2 * p->r_2;
    /* frame lower on upper */
    const double omega_lower_y = -v->q1 - v->q2;
    const double mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y * omega_lower_y;
    const double mc_lower_z_c_q2 = mc_lower_z * c_q2;
    const double lower_1 = p->I_2 - p->l_1 * mc_lower_z_c_q2;
    /* frame upper on ground */
    const double a_upper_z = p->g * c_q1;
    const double a_upper_x = p->g * s_q1;
    const double upper_1 = p->I_1 + p->I_2 + p->l_1 * (p->m_2 * p->l_1 - mc_lower_z_c_q2 - mc_lower_z_c_q2);
    const double a_upper_x_s_q2 = a_upper_x * s_q2;
    const double a_upper_x_c_q2 = a_upper_x * c_q2;
    /* frame lower on upper */
    const double a_lower_z = a_upper_z * c_q2 - a_upper_x_s_q2;
    const double f_weight_lower_x = p->m_2 * (a_upper_z * s_q2 + a_upper_x_c_q2);
    const double f_weight_lower_1_z = p->m_2 * a_lower_z * c_q2 + f_weight_lower_x * s_q2;
    const double a_lower_1_z = p->l_1 * v->q1 * v->q1 + a_upper_z;
    const double a_lower_1_z_c_q2 = a_lower_1_z * c_q2;
    const double a_lower_1_z_s_q2 = a_lower_1_z * s_q2;
    const double a_lower_x = a_upper_x_c_q2 + a_lower_1_z_s_q2;
    const double f_lower_z = p->m_2 * (a_lower_1_z_c_q2 - a_upper_x_s_q2) - mc_lower_z_omega_lower_y_sq;
    const double n_lower_y = mc_lower_z * a_lower_x;
    const double f_lower_1_x = p->m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    /* frame upper on ground */
    const double n_upper_y = mc_upper_z * a_upper_x + n_lower_y - p->l_1 * f_lower_1_x;
    const double half_I_r = 0.5 * p->I_r;
    const double two_n = 2.0 * p->n;
    const double two_n_2 = 2.0 * p->n;
    /* kinetic energy rotor_2 */
    const double M_q1_q1 = upper_1 + p->I_r + p->n * half_I_r * two_n;
    const double lower_1_minus_half_I_r_two_n = lower_1 - half_I_r * two_n;
    const double M_q2_q2 = p->I_2 + p->n * half_I_r * two_n_2;
    /* balance of forces */
    const double tau_q2 = n_lower_y - d_q2 + u->tau_2;
    /* M = L^T D L and back-substitution */
    const double inv_q2 = 1.0 / M_q2_q2;
    const double l_q2_q1 = lower_1_minus_half_I_r_two_n * inv_q2;
    const double u_q1_q2 = inv_q2 * (lower_1 - half_I_r * two_n_2);
    const double pivot_q1 = M_q1_q1 - lower_1_minus_half_I_r_two_n * u_q1_q2;
    const double inv_q1 = 1.0 / pivot_q1;
    const double q1_ddot = inv_q1 * (n_upper_y - tau_q2 * u_q1_q2 - d_q1 + u->tau_1);
    const double q2_ddot = tau_q2 * inv_q2 - l_q2_q1 * q1_ddot;
    const double mc_lower_z_a_lower_z = mc_lower_z * a_lower_z;
    /* derivatives with respect to q1 */
    const double by_q1_1 = mc_upper_z * a_upper_z - u_q1_q2 * mc_lower_z_a_lower_z + mc_lower_z_a_lower_z - p->l_1 * f_weight_lower_1_z;
    const double d_q1_ddot_by_q1 = inv_q1 * by_q1_1;
    const double d_q2_ddot_by_q1 = inv_q2 * mc_lower_z_a_lower_z - l_q2_q1 * d_q1_ddot_by_q1;
    const double two_l_1_q1_dot = 2.0 * p->l_1 * v->q1;
    const double two_mc_lower_z_omega_lower_y = 2.0 * mc_lower_z * omega_lower_y;
    const double two_l_1_q1_dot_s_q2 = two_l_1_q1_dot * s_q2;
    /* derivatives with respect to q1_dot */
    const double by_q1_dot_1 = mc_lower_z * two_l_1_q1_dot_s_q2;
    const double by_q1_dot_2 = s_q2 * (two_mc_lower_z_omega_lower_y + p->m_2 * two_l_1_q1_dot * c_q2);
    const double by_q1_dot_3 = p->l_1 * (p->m_2 * two_l_1_q1_dot_s_q2 * c_q2 - by_q1_dot_2);
    const double d_q1_ddot_by_q1_dot = inv_q1 * (by_q1_dot_1 - u_q1_q2 * by_q1_dot_1 - p->b_1 - by_q1_dot_3);
    const double d_q2_ddot_by_q1_dot = inv_q2 * by_q1_dot_1 - l_q2_q1 * d_q1_ddot_by_q1_dot;
    const double a_upper_x_plus_l_1_q1_ddot = a_upper_x + p->l_1 * q1_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = a_lower_1_z_c_q2 - a_upper_x_plus_l_1_q1_ddot * s_q2;
    const double slopes_2 = p->m_2 * (a_lower_1_z_s_q2 + a_upper_x_plus_l_1_q1_ddot * c_q2);
    const double m_2_slopes_1 = p->m_2 * slopes_1;
    const double slopes_3 = c_q2 * (m_2_slopes_1 - mc_lower_z_omega_lower_y_sq);
    const double slopes_4 = s_q2 * (slopes_2 - mc_lower_z * (q1_ddot + q2_ddot));
    const double mc_lower_z_slopes_1 = mc_lower_z * slopes_1;
    const double slopes_3_minus_slopes_2_s_q2 = slopes_3 - slopes_2 * s_q2;
    const double slopes_5 = p->l_1 * (m_2_slopes_1 * c_q2 - slopes_4 - slopes_3_minus_slopes_2_s_q2);
    /* derivatives with respect to q2 */
    const double d_q1_ddot_by_q2 = inv_q1 * (mc_lower_z_slopes_1 - u_q1_q2 * mc_lower_z_slopes_1 - slopes_5);
    const double d_q2_ddot_by_q2 = inv_q2 * mc_lower_z_slopes_1 - l_q2_q1 * d_q1_ddot_by_q2;
    /* derivatives with respect to tau_2 */
    const double d_q1_ddot_by_tau_2 = -u_q1_q2 * inv_q1;
    /* derivatives with respect to q2_dot */
    const double d_q1_ddot_by_q2_dot = inv_q1 * (p->l_1 * two_mc_lower_z_omega_lower_y * s_q2 + p->b_2 * u_q1_q2);
    const double d_q2_ddot_by_q2_dot = -p->b_2 * inv_q2 - l_q2_q1 * d_q1_ddot_by_q2_dot;
    if (!(M_q2_q2 > 0.0)) {
        return 2;
    }
    if (!(pivot_q1 > 0.0)) {
        return 1;
    }
    dx[0] = v->q1; /* q1' */
    dx[1] = v->q2; /* q2' */
    dx[2] = q1_ddot; /* q1'' */
    dx[3] = q2_ddot; /* q2'' */
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][2] = 1.0; /* q1' */
    a[1][3] = 1.0; /* q2' */
    a[2][0] = d_q1_ddot_by_q1; /* q1'' */
    a[2][1] = d_q1_ddot_by_q2;
    a[2][2] = d_q1_ddot_by_q1_dot;
    a[2][3] = d_q1_ddot_by_q2_dot;
    a[3][0] = d_q2_ddot_by_q1; /* q2'' */
    a[3][1] = d_q2_ddot_by_q2;
    a[3][2] = d_q2_ddot_by_q1_dot;
    a[3][3] = d_q2_ddot_by_q2_dot;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 2; j++) {
            b[i][j] = 0.0;
        }
    }
    b[2][0] = inv_q1; /* q1'' */
    b[2][1] = d_q1_ddot_by_tau_2;
    b[3][0] = -l_q2_q1 * inv_q1; /* q2'' */
    b[3][1] = inv_q2 - l_q2_q1 * d_q1_ddot_by_tau_2;
    return 0;
}

int double_pendulum_parameter_jacobian(
    const struct double_pendulum_state *x,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double by_p[4][15])
{
    const struct double_pendulum_coordinates *q = &x->q;
    const struct double_pendulum_rates *v = &x->v;
    const double s_q1 = sin(q->q1);
    const double c_q1 = cos(q->q1);
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    /* friction of q1 */
    const double friction_q1_1 = 1.5707963267948966 * p->c_f1;
    const double q1_dot_per_v_c = v->q1 / p->v_c;
    const double tanh_q1_dot_per_v_c = tanh(q1_dot_per_v_c);
    const double d_q1 = p->b_1 * v->q1 + friction_q1_1 * tanh_q1_dot_per_v_c;
    /* friction of q2 */
    const double friction_q2_1 = 1.5707963267948966 * p->c_f2;
    const double q2_dot_per_v_c = v->q2 / p->v_c;
    const double tanh_q2_dot_per_v_c = tanh(q2_dot_per_v_c);
    const double d_q2 = p->b_2 * v->q2 + friction_q2_1 * tanh_q2_dot_per_v_c;
    /* body upper_link on upper */
    const double mc_upper_z = -p->m_1 * p->r_1;
    /* body lower_link on lower */
    const double mc_lower_z = -p->m_2 * p->r_2;
    /* frame lower on upper */
    const double omega_lower_y = -v->q1 - v->q2;
    const double omega_lower_y_sq = omega_lower_y * omega_lower_y;
    const double mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y_sq;
    const double mc_lower_z_c_q2 = mc_lower_z * c_q2;
    const double lower_1 = p->I_2 - p->l_1 * mc_lower_z_c_q2;
    const double q1_dot_sq = v->q1 * v->q1;
    /* frame upper on ground */
    const double a_upper_x = p->g * s_q1;
    const double upper_1 = p->I_1 + p->I_2 + p->l_1 * (p->m_2 * p->l_1 - mc_lower_z_c_q2 - mc_lower_z_c_q2);
    /* frame lower on upper */
    const double a_lower_1_z = p->l_1 * q1_dot_sq + p->g * c_q1;
    const double a_lower_1_z_c_q2 = a_lower_1_z * c_q2;
    const double a_lower_1_z_s_q2 = a_lower_1_z * s_q2;
    const double a_lower_x = a_upper_x * c_q2 + a_lower_1_z_s_q2;
    const double f_lower_z = p->m_2 * (a_lower_1_z_c_q2 - a_upper_x * s_q2) - mc_lower_z_omega_lower_y_sq;
    const double n_lower_y = mc_lower_z * a_lower_x;
    const double f_lower_1_x = p->m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    /* frame upper on ground */
    const double n_upper_y = mc_upper_z * a_upper_x + n_lower_y - p->l_1 * f_lower_1_x;
    const double half_I_r = 0.5 * p->I_r;
    const double two_n = 2.0 * p->n;
    const double n_two_n = p->n * two_n;
    const double two_n_2 = 2.0 * p->n;
    const double n_two_n_2 = p->n * two_n_2;
    /* kinetic energy rotor_2 */
    const double M_q1_q1 = upper_1 + p->I_r + half_I_r * n_two_n;
    const double lower_1_minus_half_I_r_two_n = lower_1 - half_I_r * two_n;
    const double M_q2_q2 = p->I_2 + half_I_r * n_two_n_2;
    /* balance of forces */
    const double tau_q2 = n_lower_y - d_q2 + u->tau_2;
    /* M = L^T D L and back-substitution */
    const double inv_q2 = 1.0 / M_q2_q2;
    const double l_q2_q1 = lower_1_minus_half_I_r_two_n * inv_q2;
    const double u_q1_q2 = inv_q2 * (lower_1 - half_I_r * two_n_2);
    const double pivot_q1 = M_q1_q1 - lower_1_minus_half_I_r_two_n * u_q1_q2;
    const double inv_q1 = 1.0 / pivot_q1;
    const double q1_ddot = inv_q1 * (n_upper_y - tau_q2 * u_q1_q2 - d_q1 + u->tau_1);
    const double q2_ddot = tau_q2 * inv_q2 - l_q2_q1 * q1_ddot;
    const double q1_ddot_plus_q2_ddot = q1_ddot + q2_ddot;
    const double a_upper_x_plus_l_1_q1_ddot = a_upper_x + p->l_1 * q1_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = a_lower_1_z_c_q2 - a_upper_x_plus_l_1_q1_ddot * s_q2;
    const double slopes_2 = a_lower_1_z_s_q2 + a_upper_x_plus_l_1_q1_ddot * c_q2;
    const double m_2_slopes_2 = p->m_2 * slopes_2;
    const double slopes_3 = c_q2 * (m_2_slopes_2 - mc_lower_z * q1_ddot_plus_q2_ddot);
    const double slopes_4 = slopes_3 - s_q2 * (p->m_2 * slopes_1 - mc_lower_z_omega_lower_y_sq);
    const double r_2_slopes_2 = p->r_2 * slopes_2;
    const double slopes_5 = s_q2 * (slopes_1 + p->r_2 * omega_lower_y_sq);
    const double slopes_6 = c_q2 * (slopes_2 + p->r_2 * q1_ddot_plus_q2_ddot) - slopes_5;
    const double slopes_7 = q1_dot_sq * s_q2 + q1_ddot * c_q2;
    const double slopes_8 = p->m_2 * (q1_dot_sq * c_q2 - q1_ddot * s_q2);
    const double mc_lower_z_slopes_7 = mc_lower_z * slopes_7;
    const double slopes_9 = p->m_2 * slopes_7 * c_q2 - slopes_8 * s_q2;
    const double slopes_10 = slopes_4 - mc_lower_z_slopes_7 + p->l_1 * slopes_9;
    const double slopes_11 = p->n * q1_ddot - 0.5 * q2_ddot * n_two_n_2;
    const double slopes_12 = p->I_r * q1_ddot - 4.0 * p->n * q2_ddot * half_I_r;
    const double m_2_omega_lower_y_sq_s_q2 = p->m_2 * omega_lower_y_sq * s_q2;
    /* derivatives with respect to v_c */
    const double by_v_c_1 = friction_q1_1 * q1_dot_per_v_c * (1.0 - tanh_q1_dot_per_v_c * tanh_q1_dot_per_v_c) / p->v_c;
    const double by_v_c_2 = friction_q2_1 * q2_dot_per_v_c * (1.0 - tanh_q2_dot_per_v_c * tanh_q2_dot_per_v_c) / p->v_c;
    const double d_q1_ddot_by_v_c = inv_q1 * (by_v_c_1 - u_q1_q2 * by_v_c_2);
    const double d_q2_ddot_by_v_c = inv_q2 * by_v_c_2 - l_q2_q1 * d_q1_ddot_by_v_c;
    const double c_q1_s_q2_plus_s_q1_c_q2 = c_q1 * s_q2 + s_q1 * c_q2;
    /* derivatives with respect to g */
    const double by_g_1 = p->m_2 * (c_q1 * c_q2 - s_q1 * s_q2);
    const double by_g_2 = mc_lower_z * c_q1_s_q2_plus_s_q1_c_q2;
    const double by_g_3 = p->m_2 * c_q1_s_q2_plus_s_q1_c_q2 * c_q2 - by_g_1 * s_q2;
    const double by_g_4 = p->l_1 * by_g_3 - mc_upper_z * s_q1 - by_g_2;
    const double d_q1_ddot_by_g = inv_q1 * (-u_q1_q2 * by_g_2 - by_g_4);
    const double d_q2_ddot_by_g = inv_q2 * by_g_2 - l_q2_q1 * d_q1_ddot_by_g;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_13 = p->l_1 * (p->m_2 * q1_ddot_plus_q2_ddot * c_q2 - m_2_omega_lower_y_sq_s_q2);
    /* derivatives with respect to m_1 */
    const double d_q1_ddot_by_m_1 = -p->r_1 * inv_q1 * a_upper_x;
    /* derivatives with respect to m_2 */
    const double d_q1_ddot_by_m_2 = inv_q1 * (u_q1_q2 * r_2_slopes_2 - r_2_slopes_2 - p->l_1 * slopes_6);
    const double d_q2_ddot_by_m_2 = -inv_q2 * r_2_slopes_2 - l_q2_q1 * d_q1_ddot_by_m_2;
    /* derivatives with respect to r_1 */
    const double d_q1_ddot_by_r_1 = -p->m_1 * a_upper_x * inv_q1;
    /* derivatives with respect to r_2 */
    const double d_q1_ddot_by_r_2 = inv_q1 * (u_q1_q2 * m_2_slopes_2 - m_2_slopes_2 - slopes_13);
    const double d_q2_ddot_by_r_2 = -inv_q2 * m_2_slopes_2 - l_q2_q1 * d_q1_ddot_by_r_2;
    /* derivatives with respect to l_1 */
    const double d_q1_ddot_by_l_1 = inv_q1 * (-u_q1_q2 * mc_lower_z_slopes_7 - slopes_10);
    const double d_q2_ddot_by_l_1 = inv_q2 * mc_lower_z_slopes_7 - l_q2_q1 * d_q1_ddot_by_l_1;
    /* derivatives with respect to I_1 */
    const double d_q1_ddot_by_I_1 = -inv_q1 * q1_ddot;
    const double q2_ddot_plus_q1_ddot = q2_ddot + q1_ddot;
    /* derivatives with respect to I_2 */
    const double d_q1_ddot_by_I_2 = inv_q1 * (u_q1_q2 * q2_ddot_plus_q1_ddot - q2_ddot_plus_q1_ddot);
    const double d_q2_ddot_by_I_2 = -inv_q2 * q2_ddot_plus_q1_ddot - l_q2_q1 * d_q1_ddot_by_I_2;
    /* derivatives with respect to I_r */
    const double d_q1_ddot_by_I_r = -inv_q1 * (q1_ddot * (1.0 + 0.5 * n_two_n) - p->n * q2_ddot + u_q1_q2 * slopes_11);
    const double d_q2_ddot_by_I_r = inv_q2 * slopes_11 - l_q2_q1 * d_q1_ddot_by_I_r;
    /* derivatives with respect to n */
    const double d_q1_ddot_by_n = -inv_q1 * (4.0 * p->n * q1_ddot * half_I_r - p->I_r * q2_ddot + u_q1_q2 * slopes_12);
    const double d_q2_ddot_by_n = inv_q2 * slopes_12 - l_q2_q1 * d_q1_ddot_by_n;
    /* derivatives with respect to b_1 */
    const double d_q1_ddot_by_b_1 = -inv_q1 * v->q1;
    /* derivatives with respect to b_2 */
    const double d_q1_ddot_by_b_2 = inv_q1 * u_q1_q2 * v->q2;
    const double d_q2_ddot_by_b_2 = -inv_q2 * v->q2 - l_q2_q1 * d_q1_ddot_by_b_2;
    /* derivatives with respect to c_f1 */
    const double d_q1_ddot_by_c_f1 = -1.5707963267948966 * inv_q1 * tanh_q1_dot_per_v_c;
    /* derivatives with respect to c_f2 */
    const double by_c_f2_1 = 1.5707963267948966 * tanh_q2_dot_per_v_c;
    const double d_q1_ddot_by_c_f2 = inv_q1 * u_q1_q2 * by_c_f2_1;
    const double d_q2_ddot_by_c_f2 = -inv_q2 * by_c_f2_1 - l_q2_q1 * d_q1_ddot_by_c_f2;
    if (!(M_q2_q2 > 0.0)) {
        return 2;
    }
    if (!(pivot_q1 > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 15; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[2][0] = d_q1_ddot_by_m_1; /* q1'' */
    by_p[2][1] = d_q1_ddot_by_m_2;
    by_p[2][2] = d_q1_ddot_by_r_1;
    by_p[2][3] = d_q1_ddot_by_r_2;
    by_p[2][4] = d_q1_ddot_by_l_1;
    by_p[2][5] = d_q1_ddot_by_I_1;
    by_p[2][6] = d_q1_ddot_by_I_2;
    by_p[2][7] = d_q1_ddot_by_I_r;
    by_p[2][8] = d_q1_ddot_by_n;
    by_p[2][9] = d_q1_ddot_by_b_1;
    by_p[2][10] = d_q1_ddot_by_b_2;
    by_p[2][11] = d_q1_ddot_by_c_f1;
    by_p[2][12] = d_q1_ddot_by_c_f2;
    by_p[2][13] = d_q1_ddot_by_v_c;
    by_p[2][14] = d_q1_ddot_by_g;
    by_p[3][0] = -l_q2_q1 * d_q1_ddot_by_m_1; /* q2'' */
    by_p[3][1] = d_q2_ddot_by_m_2;
    by_p[3][2] = -l_q2_q1 * d_q1_ddot_by_r_1;
    by_p[3][3] = d_q2_ddot_by_r_2;
    by_p[3][4] = d_q2_ddot_by_l_1;
    by_p[3][5] = -l_q2_q1 * d_q1_ddot_by_I_1;
    by_p[3][6] = d_q2_ddot_by_I_2;
    by_p[3][7] = d_q2_ddot_by_I_r;
    by_p[3][8] = d_q2_ddot_by_n;
    by_p[3][9] = -l_q2_q1 * d_q1_ddot_by_b_1;
    by_p[3][10] = d_q2_ddot_by_b_2;
    by_p[3][11] = -l_q2_q1 * d_q1_ddot_by_c_f1;
    by_p[3][12] = d_q2_ddot_by_c_f2;
    by_p[3][13] = d_q2_ddot_by_v_c;
    by_p[3][14] = d_q2_ddot_by_g;
    return 0;
}

void double_pendulum_output_jacobian(
    const struct double_pendulum_state *x,
    const struct double_pendulum_parameters *p,
    double by_x[2][4],
    double by_p[2][15])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 4; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* q1 */
    by_x[1][1] = 1.0; /* q2 */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 15; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

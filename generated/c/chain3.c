/*
 * Spatial chain of three joints.
 * Generated from `chain3.rig` (model 644e8a88); edit the rig, not this file.
 *
 * Three slender links of 0.4, 0.3 and 0.2 m turn about z, y and x in turn, each with its own motor: the
 * shape of the chains on which derivation and speed are measured (joint axes alternate z, y, x, links along
 * x). Numbers: square aluminium bars of 30 mm, 2700 kg/m^3.
 *
 * 215 operations forward, 683 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "chain3.h"

#include <math.h>

void chain3_nominal(struct chain3_parameters *p)
{
    p->m_1 = 0.972;
    p->m_2 = 0.729;
    p->m_3 = 0.486;
    p->l_1 = 0.4;
    p->l_2 = 0.3;
    p->l_3 = 0.2;
    p->b = 0.03;
    p->c_1 = 0.05;
    p->c_2 = 0.04;
    p->c_3 = 0.01;
    p->g = 9.81;
}

void chain3_mass_matrix(const struct chain3_coordinates *q, const struct chain3_parameters *p, double m[3][3])
{
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double l_1_per_two = p->l_1 / 2.0;
    const double b_sq = p->b * p->b;
    const double m_1_b_sq_plus_l_1_sq_per_12 = p->m_1 * (b_sq + p->l_1 * p->l_1) / 12.0;
    /* body bar_1 on link_1 */
    const double I_link_1_yy = m_1_b_sq_plus_l_1_sq_per_12 + p->m_1 * l_1_per_two * l_1_per_two;
    const double l_2_per_two = p->l_2 / 2.0;
    /* body bar_2 on link_2 */
    const double mc_link_2_x = p->m_2 * l_2_per_two;
    const double I_link_2_yy = p->m_2 * (b_sq + p->l_2 * p->l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    const double l_3_per_two = p->l_3 / 2.0;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double I_link_3_yy = p->m_3 * b_sq / 6.0;
    const double mc_link_3_y = p->m_3 * l_3_per_two;
    const double I_link_3_xx = p->m_3 * (b_sq + p->l_3 * p->l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    const double mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    /* frame link_3 on link_2 */
    const double M_q2_q3 = -p->l_2 * mc_link_3_y * c_q3;
    const double l_2_mc_link_3_y_s_q3 = p->l_2 * mc_link_3_y_s_q3;
    const double link_3_1 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    const double M_q1_q3 = -link_3_1 - p->l_1 * mc_link_3_y_s_q3;
    const double link_3_2 = c_q3 * (I_link_3_yy - I_link_3_xx);
    const double link_3_2_c_q3 = link_3_2 * c_q3;
    const double m_3_l_2 = p->m_3 * p->l_2;
    const double l_2_m_3_l_2 = p->l_2 * m_3_l_2;
    /* frame link_2 on link_1 */
    const double link_2_1 = p->m_2 * b_sq / 6.0 + I_link_3_xx;
    const double M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_2_c_q3 + l_2_m_3_l_2;
    const double link_2_2 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    const double M_q1_q2 = link_3_2 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    const double link_2_3 = I_link_2_yy + I_link_3_yy - link_3_2_c_q3 + l_2_m_3_l_2 - link_2_1;
    const double link_2_4 = link_2_3 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    const double link_2_1_1 = p->l_1 * (link_2_2 + link_2_2 + p->l_1 * (p->m_2 + p->m_3));
    /* frame link_1 on ground */
    const double M_q1_q1 = I_link_1_yy + link_2_1 + link_2_4 * c_q2 + link_2_1_1;
    m[0][0] = M_q1_q1; /* q1 */
    m[0][1] = M_q1_q2;
    m[0][2] = M_q1_q3;
    m[1][0] = M_q1_q2; /* q2 */
    m[1][1] = M_q2_q2;
    m[1][2] = M_q2_q3;
    m[2][0] = M_q1_q3; /* q3 */
    m[2][1] = M_q2_q3;
    m[2][2] = I_link_3_xx;
}

void chain3_bias(const struct chain3_coordinates *q, const struct chain3_rates *v, const struct chain3_parameters *p, double h[3])
{
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double b_sq = p->b * p->b;
    const double l_2_per_two = p->l_2 / 2.0;
    /* body bar_2 on link_2 */
    const double I_link_2_xx = p->m_2 * b_sq / 6.0;
    const double mc_link_2_x = p->m_2 * l_2_per_two;
    const double I_link_2_yy = p->m_2 * (b_sq + p->l_2 * p->l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    const double l_3_per_two = p->l_3 / 2.0;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double I_link_3_yy = p->m_3 * b_sq / 6.0;
    const double mc_link_3_y = p->m_3 * l_3_per_two;
    const double I_link_3_xx = p->m_3 * (b_sq + p->l_3 * p->l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    /* frame link_2 on link_1 */
    const double omega_link_2_z = c_q2 * v->q1;
    const double omega_link_2_x = -s_q2 * v->q1;
    const double alpha_link_2_x = -omega_link_2_z * v->q2;
    const double alpha_link_2_z = omega_link_2_x * v->q2;
    const double two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    const double link_2_1 = omega_link_2_z * omega_link_2_x;
    const double link_2_2 = I_link_2_yy * alpha_link_2_z + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    /* frame link_3 on link_2 */
    const double omega_link_3_y = c_q3 * v->q2 + omega_link_2_z * s_q3;
    const double omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v->q2;
    const double omega_link_3_x = v->q3 + omega_link_2_x;
    const double alpha_link_3_y = omega_link_3_z * v->q3 + alpha_link_2_z * s_q3;
    const double alpha_link_3_z = alpha_link_2_z * c_q3 - omega_link_3_y * v->q3;
    const double link_3_1 = omega_link_3_y * omega_link_3_z;
    const double n_moving_link_3_y = I_link_3_yy * alpha_link_3_y;
    const double link_3_2 = omega_link_3_y * omega_link_3_x * (I_link_3_yy - I_link_3_xx) + I_link_3_xx * alpha_link_3_z;
    /* frame link_2 on link_1 */
    const double a_link_2_1_x = -p->l_1 * v->q1 * v->q1;
    /* frame link_3 on link_2 */
    const double a_link_3_1_y = p->l_2 * two_alpha_link_2_z;
    /* frame link_2 on link_1 */
    const double a_link_2_z = p->g * c_q2 + a_link_2_1_x * s_q2;
    const double a_link_2_x = a_link_2_1_x * c_q2 - p->g * s_q2;
    const double link_2_3 = mc_link_2_x * a_link_2_z - link_2_1 * (I_link_2_xx - I_link_2_yy);
    /* frame link_3 on link_2 */
    const double a_link_3_1_x = a_link_2_x - p->l_2 * (v->q2 * v->q2 + omega_link_2_z * omega_link_2_z);
    const double a_link_3_1_z = a_link_2_z + p->l_2 * link_2_1;
    const double a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    const double a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    const double f_link_3_y = p->m_3 * a_link_3_y - mc_link_3_y * (omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x);
    const double f_link_3_z = mc_link_3_y * (link_3_1 + alpha_link_2_x) + p->m_3 * a_link_3_z;
    const double n_link_3_x = link_3_1 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    const double n_link_3_z = link_3_2 - mc_link_3_y * a_link_3_1_x;
    const double f_link_3_1_y = f_link_3_y * c_q3 - f_link_3_z * s_q3;
    const double f_link_3_1_z = f_link_3_y * s_q3 + f_link_3_z * c_q3;
    const double n_link_3_1_y = n_moving_link_3_y * c_q3 - n_link_3_z * s_q3;
    const double n_link_3_1_z = n_moving_link_3_y * s_q3 + n_link_3_z * c_q3;
    /* frame link_2 on link_1 */
    const double n_link_2_y = n_link_3_1_y - p->l_2 * f_link_3_1_z - link_2_3;
    const double n_link_2_z = n_link_3_1_z + p->l_2 * f_link_3_1_y + link_2_2;
    const double n_link_2_1_z = n_link_2_z * c_q2 - s_q2 * (n_link_3_x + I_link_2_xx * alpha_link_2_x);
    const double n_link_1_z = n_link_2_1_z + p->l_1 * (mc_link_2_x * two_alpha_link_2_z + f_link_3_1_y);
    h[0] = n_link_1_z; /* q1 */
    h[1] = n_link_2_y; /* q2 */
    h[2] = n_link_3_x; /* q3 */
}

void chain3_velocity_products(
    const struct chain3_coordinates *q,
    const struct chain3_rates *v,
    const struct chain3_parameters *p,
    double c[3])
{
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double b_sq = p->b * p->b;
    const double l_2_per_two = p->l_2 / 2.0;
    /* body bar_2 on link_2 */
    const double I_link_2_xx = p->m_2 * b_sq / 6.0;
    const double mc_link_2_x = p->m_2 * l_2_per_two;
    const double I_link_2_yy = p->m_2 * (b_sq + p->l_2 * p->l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    const double l_3_per_two = p->l_3 / 2.0;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double I_link_3_yy = p->m_3 * b_sq / 6.0;
    const double mc_link_3_y = p->m_3 * l_3_per_two;
    const double I_link_3_xx = p->m_3 * (b_sq + p->l_3 * p->l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    /* frame link_2 on link_1 */
    const double omega_link_2_z = c_q2 * v->q1;
    const double omega_link_2_x = -s_q2 * v->q1;
    const double alpha_link_2_x = -omega_link_2_z * v->q2;
    const double alpha_link_2_z = omega_link_2_x * v->q2;
    const double two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    const double link_2_1 = omega_link_2_z * omega_link_2_x;
    const double link_2_2 = I_link_2_yy * alpha_link_2_z + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    /* frame link_3 on link_2 */
    const double omega_link_3_y = c_q3 * v->q2 + omega_link_2_z * s_q3;
    const double omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v->q2;
    const double omega_link_3_x = v->q3 + omega_link_2_x;
    const double alpha_link_3_y = omega_link_3_z * v->q3 + alpha_link_2_z * s_q3;
    const double alpha_link_3_z = alpha_link_2_z * c_q3 - omega_link_3_y * v->q3;
    const double link_3_1 = omega_link_3_y * omega_link_3_z;
    const double n_moving_link_3_y = I_link_3_yy * alpha_link_3_y;
    const double link_3_2 = omega_link_3_y * omega_link_3_x * (I_link_3_yy - I_link_3_xx) + I_link_3_xx * alpha_link_3_z;
    /* frame link_2 on link_1 */
    const double a_link_2_1_x = -p->l_1 * v->q1 * v->q1;
    const double a_link_2_z = a_link_2_1_x * s_q2;
    const double link_2_3 = link_2_1 * (I_link_2_xx - I_link_2_yy) - mc_link_2_x * a_link_2_z;
    /* frame link_3 on link_2 */
    const double a_link_3_1_y = p->l_2 * two_alpha_link_2_z;
    const double a_link_3_1_x = a_link_2_1_x * c_q2 - p->l_2 * (v->q2 * v->q2 + omega_link_2_z * omega_link_2_z);
    const double a_link_3_1_z = a_link_2_z + p->l_2 * link_2_1;
    const double a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    const double a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    const double f_moving_link_3_y = p->m_3 * a_link_3_y
        - mc_link_3_y * (omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x);
    const double f_moving_link_3_z = mc_link_3_y * (link_3_1 + alpha_link_2_x) + p->m_3 * a_link_3_z;
    const double n_moving_link_3_x = link_3_1 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    const double n_moving_link_3_z = link_3_2 - mc_link_3_y * a_link_3_1_x;
    const double f_moving_link_3_1_y = f_moving_link_3_y * c_q3 - f_moving_link_3_z * s_q3;
    const double f_moving_link_3_1_z = f_moving_link_3_y * s_q3 + f_moving_link_3_z * c_q3;
    const double n_moving_link_3_1_y = n_moving_link_3_y * c_q3 - n_moving_link_3_z * s_q3;
    const double n_moving_link_3_1_z = n_moving_link_3_y * s_q3 + n_moving_link_3_z * c_q3;
    /* frame link_2 on link_1 */
    const double n_moving_link_2_y = link_2_3 + n_moving_link_3_1_y - p->l_2 * f_moving_link_3_1_z;
    const double n_moving_link_2_z = n_moving_link_3_1_z + p->l_2 * f_moving_link_3_1_y + link_2_2;
    const double link_2_4 = s_q2 * (n_moving_link_3_x + I_link_2_xx * alpha_link_2_x);
    const double link_2_1_1 = p->l_1 * (mc_link_2_x * two_alpha_link_2_z + f_moving_link_3_1_y);
    const double n_moving_link_1_z = n_moving_link_2_z * c_q2 - link_2_4 + link_2_1_1;
    c[0] = n_moving_link_1_z; /* q1 */
    c[1] = n_moving_link_2_y; /* q2 */
    c[2] = n_moving_link_3_x; /* q3 */
}

void chain3_gravity(const struct chain3_coordinates *q, const struct chain3_parameters *p, double g[3])
{
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double l_3_per_two = p->l_3 / 2.0;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double bar_3_1 = l_3_per_two * s_q2 * s_q3 + p->l_2 * c_q2;
    const double g_q2 = -p->m_2 * p->l_2 * p->g * c_q2 / 2.0 - p->m_3 * p->g * bar_3_1;
    const double g_q3 = p->m_3 * p->g * l_3_per_two * c_q2 * c_q3;
    g[0] = 0.0; /* q1 */
    g[1] = g_q2; /* q2 */
    g[2] = g_q3; /* q3 */
}

void chain3_dissipation(const struct chain3_coordinates *q, const struct chain3_rates *v, const struct chain3_parameters *p, double d[3])
{
    (void)q;
    d[0] = p->c_1 * v->q1; /* q1 */
    d[1] = p->c_2 * v->q2; /* q2 */
    d[2] = p->c_3 * v->q3; /* q3 */
}

void chain3_generalized_force(
    const struct chain3_coordinates *q,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    double f[3])
{
    (void)q;
    (void)p;
    f[0] = u->tau_1; /* q1 */
    f[1] = u->tau_2; /* q2 */
    f[2] = u->tau_3; /* q3 */
}

void chain3_input_map(const struct chain3_coordinates *q, const struct chain3_parameters *p, double s[3][3])
{
    (void)q;
    (void)p;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            s[i][j] = 0.0;
        }
    }
    s[0][0] = 1.0; /* q1 */
    s[1][1] = 1.0; /* q2 */
    s[2][2] = 1.0; /* q3 */
}

double chain3_kinetic_energy(const struct chain3_coordinates *q, const struct chain3_rates *v, const struct chain3_parameters *p)
{
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double b_sq = p->b * p->b;
    const double l_1_per_two_q1_dot = p->l_1 * v->q1 / 2.0;
    /* body bar_1 on link_1 */
    const double bar_1_1 = p->m_1 * v->q1 * v->q1 * (b_sq + p->l_1 * p->l_1) / 12.0;
    const double bar_1_2 = 0.5 * (p->m_1 * l_1_per_two_q1_dot * l_1_per_two_q1_dot + bar_1_1);
    const double l_2_per_two = p->l_2 / 2.0;
    const double m_2_b_sq_plus_l_2_sq_per_12 = p->m_2 * (b_sq + p->l_2 * p->l_2) / 12.0;
    const double l_2_per_two_q2_dot = l_2_per_two * v->q2;
    const double l_3_per_two = p->l_3 / 2.0;
    const double m_3_b_sq_plus_l_3_sq_per_12 = p->m_3 * (b_sq + p->l_3 * p->l_3) / 12.0;
    /* frame link_2 on link_1 */
    const double omega_link_2_z = c_q2 * v->q1;
    const double omega_link_2_x = -s_q2 * v->q1;
    /* frame link_3 on link_2 */
    const double omega_link_3_y = c_q3 * v->q2 + omega_link_2_z * s_q3;
    const double omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v->q2;
    const double omega_link_3_x = v->q3 + omega_link_2_x;
    const double l_1_q1_dot = p->l_1 * v->q1;
    const double l_2_q2_dot = p->l_2 * v->q2;
    const double link_3_1_1 = l_1_q1_dot + p->l_2 * omega_link_2_z;
    const double link_3_1 = link_3_1_1 * c_q3 - l_2_q2_dot * s_q3;
    const double link_3_2 = link_3_1_1 * s_q3 + l_2_q2_dot * c_q3;
    /* body bar_2 on link_2 */
    const double bar_2_1 = l_1_q1_dot + l_2_per_two * omega_link_2_z;
    const double bar_2_2 = p->m_2 * (bar_2_1 * bar_2_1 + l_2_per_two_q2_dot * l_2_per_two_q2_dot);
    const double bar_2_3 = p->m_2 * omega_link_2_x * b_sq * omega_link_2_x / 6.0 + m_2_b_sq_plus_l_2_sq_per_12 * v->q2 * v->q2;
    const double bar_2_4 = bar_2_2 + omega_link_2_z * m_2_b_sq_plus_l_2_sq_per_12 * omega_link_2_z + bar_2_3;
    const double l_3_per_two_omega_link_3_z = l_3_per_two * omega_link_3_z;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double bar_3_1 = l_3_per_two * omega_link_3_x - link_3_2;
    const double bar_3_2 = l_3_per_two_omega_link_3_z * l_3_per_two_omega_link_3_z + link_3_1 * link_3_1;
    const double m_3_bar_3_1_sq_plus_bar_3_2 = p->m_3 * (bar_3_1 * bar_3_1 + bar_3_2);
    const double bar_3_3 = p->m_3 * omega_link_3_y * b_sq * omega_link_3_y / 6.0;
    const double bar_3_4 = omega_link_3_x * m_3_b_sq_plus_l_3_sq_per_12 * omega_link_3_x + bar_3_3;
    const double bar_3_5 = m_3_bar_3_1_sq_plus_bar_3_2 + omega_link_3_z * m_3_b_sq_plus_l_3_sq_per_12 * omega_link_3_z + bar_3_4;
    return bar_1_2 + 0.5 * bar_2_4 + 0.5 * bar_3_5;
}

double chain3_potential_energy(const struct chain3_coordinates *q, const struct chain3_parameters *p)
{
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double bar_3_1 = p->g * (p->l_3 * c_q2 * s_q3 / 2.0 - p->l_2 * s_q2);
    return p->m_3 * bar_3_1 - p->m_2 * p->l_2 * p->g * s_q2 / 2.0;
}

void chain3_inverse_dynamics(
    const struct chain3_state *x,
    const struct chain3_accelerations *a,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    double r[3])
{
    const struct chain3_coordinates *q = &x->q;
    const struct chain3_rates *v = &x->v;
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double l_1_per_two = p->l_1 / 2.0;
    const double b_sq = p->b * p->b;
    const double m_1_b_sq_plus_l_1_sq_per_12 = p->m_1 * (b_sq + p->l_1 * p->l_1) / 12.0;
    /* body bar_1 on link_1 */
    const double I_link_1_yy = m_1_b_sq_plus_l_1_sq_per_12 + p->m_1 * l_1_per_two * l_1_per_two;
    const double l_2_per_two = p->l_2 / 2.0;
    /* body bar_2 on link_2 */
    const double I_link_2_xx = p->m_2 * b_sq / 6.0;
    const double mc_link_2_x = p->m_2 * l_2_per_two;
    const double I_link_2_yy = p->m_2 * (b_sq + p->l_2 * p->l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    const double l_3_per_two = p->l_3 / 2.0;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double I_link_3_yy = p->m_3 * b_sq / 6.0;
    const double mc_link_3_y = p->m_3 * l_3_per_two;
    const double I_link_3_xx = p->m_3 * (b_sq + p->l_3 * p->l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    /* frame link_2 on link_1 */
    const double omega_link_2_z = c_q2 * v->q1;
    const double omega_link_2_x = -s_q2 * v->q1;
    const double alpha_link_2_z = omega_link_2_x * v->q2;
    const double link_2_1 = omega_link_2_z * omega_link_2_x;
    const double alpha_link_2_x = -omega_link_2_z * v->q2 - s_q2 * a->q1;
    const double alpha_link_2_z_2 = c_q2 * a->q1 + alpha_link_2_z;
    const double link_2_2 = alpha_link_2_z_2 + alpha_link_2_z;
    /* frame link_3 on link_2 */
    const double omega_link_3_y = c_q3 * v->q2 + omega_link_2_z * s_q3;
    const double omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v->q2;
    const double omega_link_3_x = v->q3 + omega_link_2_x;
    const double link_3_1 = omega_link_3_y * omega_link_3_z;
    const double alpha_link_3_y = omega_link_3_z * v->q3 + c_q3 * a->q2 + alpha_link_2_z_2 * s_q3;
    const double alpha_link_3_z = alpha_link_2_z_2 * c_q3 - s_q3 * a->q2 - omega_link_3_y * v->q3;
    const double alpha_link_3_x = a->q3 + alpha_link_2_x;
    const double n_net_link_3_y = I_link_3_yy * alpha_link_3_y;
    const double link_3_2 = omega_link_3_y * omega_link_3_x * (I_link_3_yy - I_link_3_xx) + I_link_3_xx * alpha_link_3_z;
    /* frame link_2 on link_1 */
    const double a_link_2_1_x = -p->l_1 * v->q1 * v->q1;
    const double a_link_2_z = p->g * c_q2 + a_link_2_1_x * s_q2;
    const double a_link_2_x = a_link_2_1_x * c_q2 - p->g * s_q2;
    const double link_2_3 = I_link_2_yy * a->q2 + link_2_1 * (I_link_2_xx - I_link_2_yy) - mc_link_2_x * a_link_2_z;
    /* frame link_3 on link_2 */
    const double a_link_3_1_x = a_link_2_x - p->l_2 * (v->q2 * v->q2 + omega_link_2_z * omega_link_2_z);
    const double a_link_3_1_z = a_link_2_z - p->l_2 * (a->q2 - link_2_1);
    /* gravity */
    const double a_link_2_1_y = p->l_1 * a->q1;
    /* frame link_2 on link_1 */
    const double link_2_4 = mc_link_2_x * a_link_2_1_y + I_link_2_yy * alpha_link_2_z_2 + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    /* frame link_3 on link_2 */
    const double a_link_3_1_y = a_link_2_1_y + p->l_2 * link_2_2;
    const double a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    const double a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    const double f_net_link_3_y = p->m_3 * a_link_3_y - mc_link_3_y * (omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x);
    const double f_net_link_3_z = p->m_3 * a_link_3_z + mc_link_3_y * (link_3_1 + alpha_link_3_x);
    const double n_net_link_3_x = mc_link_3_y * a_link_3_z + link_3_1 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_3_x;
    const double n_net_link_3_z = link_3_2 - mc_link_3_y * a_link_3_1_x;
    const double f_net_link_3_1_y = f_net_link_3_y * c_q3 - f_net_link_3_z * s_q3;
    const double f_net_link_3_1_z = f_net_link_3_y * s_q3 + f_net_link_3_z * c_q3;
    const double n_net_link_3_1_y = n_net_link_3_y * c_q3 - n_net_link_3_z * s_q3;
    const double n_net_link_3_1_z = n_net_link_3_y * s_q3 + n_net_link_3_z * c_q3;
    /* frame link_2 on link_1 */
    const double f_net_link_2_y = p->m_2 * a_link_2_1_y + mc_link_2_x * link_2_2 + f_net_link_3_1_y;
    const double n_net_link_2_y = link_2_3 + n_net_link_3_1_y - p->l_2 * f_net_link_3_1_z;
    const double n_net_link_2_z = link_2_4 + n_net_link_3_1_z + p->l_2 * f_net_link_3_1_y;
    const double link_2_5 = s_q2 * (n_net_link_3_x + I_link_2_xx * alpha_link_2_x);
    /* frame link_1 on ground */
    const double n_net_link_1_z = I_link_1_yy * a->q1 + n_net_link_2_z * c_q2 - link_2_5 + p->l_1 * f_net_link_2_y;
    r[0] = p->c_1 * v->q1 + n_net_link_1_z - u->tau_1; /* q1 */
    r[1] = p->c_2 * v->q2 + n_net_link_2_y - u->tau_2; /* q2 */
    r[2] = p->c_3 * v->q3 + n_net_link_3_x - u->tau_3; /* q3 */
}

void chain3_outputs(const struct chain3_state *x, const struct chain3_parameters *p, struct chain3_outputs *y)
{
    const struct chain3_coordinates *q = &x->q;
    (void)p;
    y->q1 = q->q1;
    y->q2 = q->q2;
    y->q3 = q->q3;
}

void chain3_pivots(const struct chain3_state *x, const struct chain3_parameters *p, double d[3])
{
    const struct chain3_coordinates *q = &x->q;
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double l_1_per_two = p->l_1 / 2.0;
    const double b_sq = p->b * p->b;
    const double m_1_b_sq_plus_l_1_sq_per_12 = p->m_1 * (b_sq + p->l_1 * p->l_1) / 12.0;
    /* body bar_1 on link_1 */
    const double I_link_1_yy = m_1_b_sq_plus_l_1_sq_per_12 + p->m_1 * l_1_per_two * l_1_per_two;
    const double l_2_per_two = p->l_2 / 2.0;
    /* body bar_2 on link_2 */
    const double mc_link_2_x = p->m_2 * l_2_per_two;
    const double I_link_2_yy = p->m_2 * (b_sq + p->l_2 * p->l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    const double l_3_per_two = p->l_3 / 2.0;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double I_link_3_yy = p->m_3 * b_sq / 6.0;
    const double mc_link_3_y = p->m_3 * l_3_per_two;
    const double I_link_3_xx = p->m_3 * (b_sq + p->l_3 * p->l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    const double mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    /* frame link_3 on link_2 */
    const double M_q2_q3 = -p->l_2 * mc_link_3_y * c_q3;
    const double l_2_mc_link_3_y_s_q3 = p->l_2 * mc_link_3_y_s_q3;
    const double link_3_1 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    const double M_q1_q3 = -link_3_1 - p->l_1 * mc_link_3_y_s_q3;
    const double link_3_2 = c_q3 * (I_link_3_yy - I_link_3_xx);
    const double link_3_2_c_q3 = link_3_2 * c_q3;
    const double m_3_l_2 = p->m_3 * p->l_2;
    const double l_2_m_3_l_2 = p->l_2 * m_3_l_2;
    /* frame link_2 on link_1 */
    const double link_2_1 = p->m_2 * b_sq / 6.0 + I_link_3_xx;
    const double M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_2_c_q3 + l_2_m_3_l_2;
    const double link_2_2 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    const double M_q1_q2 = link_3_2 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    const double link_2_3 = I_link_2_yy + I_link_3_yy - link_3_2_c_q3 + l_2_m_3_l_2 - link_2_1;
    const double link_2_4 = link_2_3 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    const double link_2_1_1 = p->l_1 * (link_2_2 + link_2_2 + p->l_1 * (p->m_2 + p->m_3));
    /* frame link_1 on ground */
    const double M_q1_q1 = I_link_1_yy + link_2_1 + link_2_4 * c_q2 + link_2_1_1;
    /* M = L^T D L and back-substitution */
    const double inv_q3 = 1.0 / I_link_3_xx;
    const double l_q3_q2 = M_q2_q3 * inv_q3;
    const double pivot_q2 = M_q2_q2 - M_q2_q3 * l_q3_q2;
    const double solve_1 = M_q1_q2 - M_q1_q3 * l_q3_q2;
    const double pivot_q1 = M_q1_q1 - solve_1 * solve_1 / pivot_q2 - M_q1_q3 * M_q1_q3 * inv_q3;
    d[0] = pivot_q1; /* q1 */
    d[1] = pivot_q2; /* q2 */
    d[2] = I_link_3_xx; /* q3 */
}

int chain3_forward_dynamics(
    const struct chain3_state *x,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    struct chain3_accelerations *a)
{
    const struct chain3_coordinates *q = &x->q;
    const struct chain3_rates *v = &x->v;
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double l_1_per_two = p->l_1 / 2.0;
    const double b_sq = p->b * p->b;
    const double m_1_b_sq_plus_l_1_sq_per_12 = p->m_1 * (b_sq + p->l_1 * p->l_1) / 12.0;
    /* body bar_1 on link_1 */
    const double I_link_1_yy = m_1_b_sq_plus_l_1_sq_per_12 + p->m_1 * l_1_per_two * l_1_per_two;
    const double l_2_per_two = p->l_2 / 2.0;
    /* body bar_2 on link_2 */
    const double I_link_2_xx = p->m_2 * b_sq / 6.0;
    const double mc_link_2_x = p->m_2 * l_2_per_two;
    const double I_link_2_yy = p->m_2 * (b_sq + p->l_2 * p->l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    const double l_3_per_two = p->l_3 / 2.0;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double I_link_3_yy = p->m_3 * b_sq / 6.0;
    const double mc_link_3_y = p->m_3 * l_3_per_two;
    const double I_link_3_xx = p->m_3 * (b_sq + p->l_3 * p->l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    /* frame link_2 on link_1 */
    const double omega_link_2_z = c_q2 * v->q1;
    const double omega_link_2_x = -s_q2 * v->q1;
    const double alpha_link_2_x = -omega_link_2_z * v->q2;
    const double alpha_link_2_z = omega_link_2_x * v->q2;
    const double two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    const double link_2_1 = omega_link_2_z * omega_link_2_x;
    const double link_2_2 = I_link_2_yy * alpha_link_2_z + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    const double I_link_2_xx_plus_I_link_3_xx = I_link_2_xx + I_link_3_xx;
    /* frame link_3 on link_2 */
    const double omega_link_3_y = c_q3 * v->q2 + omega_link_2_z * s_q3;
    const double omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v->q2;
    const double omega_link_3_x = v->q3 + omega_link_2_x;
    const double alpha_link_3_y = omega_link_3_z * v->q3 + alpha_link_2_z * s_q3;
    const double alpha_link_3_z = alpha_link_2_z * c_q3 - omega_link_3_y * v->q3;
    const double link_3_1 = omega_link_3_y * omega_link_3_z;
    const double n_moving_link_3_y = I_link_3_yy * alpha_link_3_y;
    const double link_3_2 = I_link_3_yy - I_link_3_xx;
    const double link_3_3 = omega_link_3_y * omega_link_3_x * link_3_2 + I_link_3_xx * alpha_link_3_z;
    const double mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    const double M_q2_q3 = -p->l_2 * mc_link_3_y * c_q3;
    const double l_2_mc_link_3_y_s_q3 = p->l_2 * mc_link_3_y_s_q3;
    const double link_3_4 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    const double M_q1_q3 = -link_3_4 - p->l_1 * mc_link_3_y_s_q3;
    const double link_3_2_c_q3 = link_3_2 * c_q3;
    const double link_3_2_c_q3_c_q3 = link_3_2_c_q3 * c_q3;
    /* frame link_2 on link_1 */
    const double a_link_2_1_x = -p->l_1 * v->q1 * v->q1;
    /* frame link_3 on link_2 */
    const double a_link_3_1_y = p->l_2 * two_alpha_link_2_z;
    const double m_3_l_2 = p->m_3 * p->l_2;
    const double l_2_m_3_l_2 = p->l_2 * m_3_l_2;
    /* frame link_2 on link_1 */
    const double a_link_2_z = p->g * c_q2 + a_link_2_1_x * s_q2;
    const double a_link_2_x = a_link_2_1_x * c_q2 - p->g * s_q2;
    const double link_2_3 = mc_link_2_x * a_link_2_z - link_2_1 * (I_link_2_xx - I_link_2_yy);
    const double M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_2_c_q3_c_q3 + l_2_m_3_l_2;
    const double link_2_4 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    const double M_q1_q2 = link_3_2_c_q3 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    const double link_2_5 = I_link_2_yy + I_link_3_yy - link_3_2_c_q3_c_q3 + l_2_m_3_l_2 - I_link_2_xx_plus_I_link_3_xx;
    const double link_2_6 = link_2_5 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    /* frame link_3 on link_2 */
    const double a_link_3_1_x = a_link_2_x - p->l_2 * (v->q2 * v->q2 + omega_link_2_z * omega_link_2_z);
    const double a_link_3_1_z = a_link_2_z + p->l_2 * link_2_1;
    const double a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    const double a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    const double f_link_3_y = p->m_3 * a_link_3_y - mc_link_3_y * (omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x);
    const double f_link_3_z = mc_link_3_y * (link_3_1 + alpha_link_2_x) + p->m_3 * a_link_3_z;
    const double n_link_3_x = link_3_1 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    const double n_link_3_z = link_3_3 - mc_link_3_y * a_link_3_1_x;
    const double f_link_3_1_y = f_link_3_y * c_q3 - f_link_3_z * s_q3;
    const double f_link_3_1_z = f_link_3_y * s_q3 + f_link_3_z * c_q3;
    const double n_link_3_1_y = n_moving_link_3_y * c_q3 - n_link_3_z * s_q3;
    const double n_link_3_1_z = n_moving_link_3_y * s_q3 + n_link_3_z * c_q3;
    /* frame link_2 on link_1 */
    const double n_link_2_y = n_link_3_1_y - p->l_2 * f_link_3_1_z - link_2_3;
    const double n_link_2_z = n_link_3_1_z + p->l_2 * f_link_3_1_y + link_2_2;
    const double n_link_2_1_z = n_link_2_z * c_q2 - s_q2 * (n_link_3_x + I_link_2_xx * alpha_link_2_x);
    const double n_link_1_z = n_link_2_1_z + p->l_1 * (mc_link_2_x * two_alpha_link_2_z + f_link_3_1_y);
    const double link_2_1_1 = p->l_1 * (link_2_4 + link_2_4 + p->l_1 * (p->m_2 + p->m_3));
    /* frame link_1 on ground */
    const double M_q1_q1 = I_link_1_yy + I_link_2_xx_plus_I_link_3_xx + link_2_6 * c_q2 + link_2_1_1;
    /* balance of forces */
    const double tau_q1 = u->tau_1 - p->c_1 * v->q1 - n_link_1_z;
    const double tau_q2 = u->tau_2 - p->c_2 * v->q2 - n_link_2_y;
    const double tau_q3 = u->tau_3 - p->c_3 * v->q3 - n_link_3_x;
    /* M = L^T D L and back-substitution */
    const double inv_q3 = 1.0 / I_link_3_xx;
    const double l_q3_q1 = M_q1_q3 * inv_q3;
    const double l_q3_q2 = M_q2_q3 * inv_q3;
    const double pivot_q2 = M_q2_q2 - M_q2_q3 * l_q3_q2;
    const double inv_q2 = 1.0 / pivot_q2;
    const double solve_1 = M_q1_q2 - M_q1_q3 * l_q3_q2;
    const double l_q2_q1 = inv_q2 * solve_1;
    const double pivot_q1 = M_q1_q1 - solve_1 * l_q2_q1 - M_q1_q3 * l_q3_q1;
    const double tau_q3_l_q3_q2_minus_tau_q2 = tau_q3 * l_q3_q2 - tau_q2;
    const double q1_ddot = (l_q2_q1 * tau_q3_l_q3_q2_minus_tau_q2 + tau_q1 - tau_q3 * l_q3_q1) / pivot_q1;
    const double q2_ddot = -inv_q2 * tau_q3_l_q3_q2_minus_tau_q2 - l_q2_q1 * q1_ddot;
    const double q3_ddot = tau_q3 * inv_q3 - l_q3_q1 * q1_ddot - l_q3_q2 * q2_ddot;
    if (!(I_link_3_xx > 0.0)) {
        return 3;
    }
    if (!(pivot_q2 > 0.0)) {
        return 2;
    }
    if (!(pivot_q1 > 0.0)) {
        return 1;
    }
    a->q1 = q1_ddot;
    a->q2 = q2_ddot;
    a->q3 = q3_ddot;
    return 0;
}

int chain3_linearize(
    const struct chain3_state *x,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][3])
{
    const struct chain3_coordinates *q = &x->q;
    const struct chain3_rates *v = &x->v;
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double l_1_per_two = p->l_1 / 2.0;
    const double b_sq = p->b * p->b;
    const double m_1_b_sq_plus_l_1_sq_per_12 = p->m_1 * (b_sq + p->l_1 * p->l_1) / 12.0;
    /* body bar_1 on link_1 */
    const double I_link_1_yy = m_1_b_sq_plus_l_1_sq_per_12 + p->m_1 * l_1_per_two * l_1_per_two;
    const double l_2_per_two = p->l_2 / 2.0;
    /* body bar_2 on link_2 */
    const double I_link_2_xx = p->m_2 * b_sq / 6.0;
    const double mc_link_2_x = p->m_2 * l_2_per_two;
    const double I_link_2_yy = p->m_2 * (b_sq + p->l_2 * p->l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    const double l_3_per_two = p->l_3 / 2.0;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double I_link_3_yy = p->m_3 * b_sq / 6.0;
    const double mc_link_3_y = p->m_3 * l_3_per_two;
    const double I_link_3_xx = p->m_3 * (b_sq + p->l_3 * p->l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    /* frame link_2 on link_1 */
    const double omega_link_2_z = c_q2 * v->q1;
    const double omega_link_2_x = -s_q2 * v->q1;
    const double alpha_link_2_x = -omega_link_2_z * v->q2;
    const double alpha_link_2_z = omega_link_2_x * v->q2;
    const double omega_link_2_z_sq = omega_link_2_z * omega_link_2_z;
    const double two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    const double link_2_1 = omega_link_2_z * omega_link_2_x;
    const double link_2_2 = I_link_2_xx - I_link_2_yy;
    const double link_2_3 = omega_link_2_z_sq - omega_link_2_x * omega_link_2_x;
    const double link_2_4 = I_link_2_yy - I_link_2_xx;
    const double alpha_link_2_z_link_2_4 = alpha_link_2_z * link_2_4;
    const double I_link_2_xx_plus_I_link_3_xx = I_link_2_xx + I_link_3_xx;
    /* frame link_3 on link_2 */
    const double omega_link_3_y = c_q3 * v->q2 + omega_link_2_z * s_q3;
    const double omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v->q2;
    const double omega_link_3_x = v->q3 + omega_link_2_x;
    const double omega_link_3_z_q3_dot = omega_link_3_z * v->q3;
    const double omega_link_3_y_q3_dot = omega_link_3_y * v->q3;
    const double omega_link_3_z_sq = omega_link_3_z * omega_link_3_z;
    const double link_3_1 = mc_link_3_y * (omega_link_3_z_sq + omega_link_3_x * omega_link_3_x);
    const double link_3_2 = omega_link_3_y * omega_link_3_z;
    const double n_moving_link_3_y = I_link_3_yy * (omega_link_3_z_q3_dot + alpha_link_2_z * s_q3);
    const double link_3_3 = I_link_3_xx - I_link_3_yy;
    const double link_3_2_link_3_3 = link_3_2 * link_3_3;
    const double link_3_4 = I_link_3_yy - I_link_3_xx;
    const double link_3_5 = omega_link_3_y * omega_link_3_x * link_3_4;
    const double link_3_6 = link_3_5 - I_link_3_xx * (omega_link_3_y_q3_dot - alpha_link_2_z * c_q3);
    const double mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    const double M_q2_q3 = -p->l_2 * mc_link_3_y * c_q3;
    const double l_2_mc_link_3_y_s_q3 = p->l_2 * mc_link_3_y_s_q3;
    const double link_3_7 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    const double M_q1_q3 = -link_3_7 - p->l_1 * mc_link_3_y_s_q3;
    const double link_3_4_c_q3 = link_3_4 * c_q3;
    const double link_3_4_c_q3_c_q3 = link_3_4_c_q3 * c_q3;
    /* frame link_2 on link_1 */
    const double a_link_2_1_x = -p->l_1 * v->q1 * v->q1;
    /* frame link_3 on link_2 */
    const double a_link_3_1_y = p->l_2 * two_alpha_link_2_z;
    const double m_3_l_2 = p->m_3 * p->l_2;
    const double l_2_m_3_l_2 = p->l_2 * m_3_l_2;
    /* frame link_2 on link_1 */
    const double a_link_2_z = p->g * c_q2 + a_link_2_1_x * s_q2;
    const double a_link_2_x = a_link_2_1_x * c_q2 - p->g * s_q2;
    const double link_2_5 = mc_link_2_x * a_link_2_z - link_2_1 * link_2_2;
    const double M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_4_c_q3_c_q3 + l_2_m_3_l_2;
    const double link_2_6 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    const double M_q1_q2 = link_3_4_c_q3 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    const double link_2_7 = I_link_2_yy + I_link_3_yy - link_3_4_c_q3_c_q3 + l_2_m_3_l_2 - I_link_2_xx_plus_I_link_3_xx;
    const double link_2_8 = link_2_7 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    /* frame link_3 on link_2 */
    const double a_link_3_1_x = a_link_2_x - p->l_2 * (v->q2 * v->q2 + omega_link_2_z_sq);
    const double a_link_3_1_z = a_link_2_z + p->l_2 * link_2_1;
    const double a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    const double a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    const double f_link_3_y = p->m_3 * a_link_3_y - link_3_1;
    const double f_link_3_z = mc_link_3_y * (link_3_2 + alpha_link_2_x) + p->m_3 * a_link_3_z;
    const double mc_link_3_y_a_link_3_1_x = mc_link_3_y * a_link_3_1_x;
    const double n_link_3_x = link_3_2_link_3_3 + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    const double n_link_3_z = link_3_6 - mc_link_3_y_a_link_3_1_x;
    const double f_link_3_1_y = f_link_3_y * c_q3 - f_link_3_z * s_q3;
    const double f_link_3_1_z = f_link_3_y * s_q3 + f_link_3_z * c_q3;
    const double n_link_3_1_y = n_moving_link_3_y * c_q3 - n_link_3_z * s_q3;
    const double n_link_3_1_z = n_moving_link_3_y * s_q3 + n_link_3_z * c_q3;
    /* frame link_2 on link_1 */
    const double n_link_2_y = n_link_3_1_y - p->l_2 * f_link_3_1_z - link_2_5;
    const double n_link_2_z = n_link_3_1_z + p->l_2 * f_link_3_1_y + I_link_2_yy * alpha_link_2_z + alpha_link_2_z_link_2_4;
    const double n_link_2_1_z = n_link_2_z * c_q2 - s_q2 * (n_link_3_x + I_link_2_xx * alpha_link_2_x);
    const double n_link_1_z = n_link_2_1_z + p->l_1 * (mc_link_2_x * two_alpha_link_2_z + f_link_3_1_y);
    const double link_2_1_1 = p->l_1 * (link_2_6 + link_2_6 + p->l_1 * (p->m_2 + p->m_3));
    /* frame link_1 on ground */
    const double M_q1_q1 = I_link_1_yy + I_link_2_xx_plus_I_link_3_xx + link_2_8 * c_q2 + link_2_1_1;
    const double c_q2_s_q3 = c_q2 * s_q3;
    const double c_q2_c_q3 = c_q2 * c_q3;
    const double c_q2_q2_dot = c_q2 * v->q2;
    const double s_q2_q2_dot = s_q2 * v->q2;
    const double omega_link_2_x_s_q3 = omega_link_2_x * s_q3;
    const double omega_link_2_x_c_q3 = omega_link_2_x * c_q3;
    const double I_link_3_yy_omega_link_3_z = I_link_3_yy * omega_link_3_z;
    /* balance of forces */
    const double tau_q1 = u->tau_1 - p->c_1 * v->q1 - n_link_1_z;
    const double tau_q2 = u->tau_2 - p->c_2 * v->q2 - n_link_2_y;
    const double tau_q3 = u->tau_3 - p->c_3 * v->q3 - n_link_3_x;
    /* M = L^T D L and back-substitution */
    const double inv_q3 = 1.0 / I_link_3_xx;
    const double l_q3_q1 = M_q1_q3 * inv_q3;
    const double l_q3_q2 = M_q2_q3 * inv_q3;
    const double pivot_q2 = M_q2_q2 - M_q2_q3 * l_q3_q2;
    const double inv_q2 = 1.0 / pivot_q2;
    const double solve_1 = M_q1_q2 - M_q1_q3 * l_q3_q2;
    const double l_q2_q1 = inv_q2 * solve_1;
    const double pivot_q1 = M_q1_q1 - solve_1 * l_q2_q1 - M_q1_q3 * l_q3_q1;
    const double inv_q1 = 1.0 / pivot_q1;
    const double tau_q3_l_q3_q2_minus_tau_q2 = tau_q3 * l_q3_q2 - tau_q2;
    const double q1_ddot = inv_q1 * (l_q2_q1 * tau_q3_l_q3_q2_minus_tau_q2 + tau_q1 - tau_q3 * l_q3_q1);
    const double q2_ddot = -inv_q2 * tau_q3_l_q3_q2_minus_tau_q2 - l_q2_q1 * q1_ddot;
    const double q3_ddot = tau_q3 * inv_q3 - l_q3_q1 * q1_ddot - l_q3_q2 * q2_ddot;
    const double two_omega_link_2_z = 2.0 * omega_link_2_z;
    const double two_omega_link_3_z = 2.0 * omega_link_3_z;
    const double two_omega_link_3_x = 2.0 * omega_link_3_x;
    /* derivatives with respect to q2 */
    const double by_q2_1 = mc_link_3_y * (omega_link_2_z * two_omega_link_3_x - omega_link_2_x_c_q3 * two_omega_link_3_z);
    const double by_q2_2 = omega_link_3_z * omega_link_2_x_s_q3 + omega_link_3_y * omega_link_2_x_c_q3;
    const double by_q2_3 = link_3_4 * (omega_link_2_z * omega_link_3_y - omega_link_3_x * omega_link_2_x_s_q3);
    const double by_q2_4 = mc_link_3_y * (a_link_2_z + p->l_2 * omega_link_2_x * two_omega_link_2_z);
    const double by_q2_5 = mc_link_2_x * a_link_2_x + link_2_2 * link_2_3;
    const double by_q2_6 = p->l_2 * link_2_3 - a_link_2_x;
    /* derivatives with respect to q3 */
    const double by_q3_1 = omega_link_3_z_sq - omega_link_3_y * omega_link_3_y;
    const double link_3_3_by_q3_1 = link_3_3 * by_q3_1;
    const double two_l_1_q1_dot = 2.0 * p->l_1 * v->q1;
    const double two_l_1_q1_dot_s_q2 = two_l_1_q1_dot * s_q2;
    /* derivatives with respect to q1_dot */
    const double by_q1_dot_1 = omega_link_2_z * s_q2 - omega_link_2_x * c_q2;
    const double by_q1_dot_2 = mc_link_3_y * (c_q2_c_q3 * two_omega_link_3_z - two_omega_link_3_x * s_q2);
    const double by_q1_dot_3 = omega_link_3_z * c_q2_s_q3 + omega_link_3_y * c_q2_c_q3;
    const double by_q1_dot_4 = link_3_4 * (omega_link_3_x * c_q2_s_q3 - omega_link_3_y * s_q2);
    const double by_q1_dot_5 = two_l_1_q1_dot * c_q2 + p->l_2 * two_omega_link_2_z * c_q2;
    const double two_s_q2_q2_dot = 2.0 * s_q2_q2_dot;
    const double by_q1_dot_6 = link_2_4 * s_q2_q2_dot + I_link_2_yy * s_q2_q2_dot;
    const double by_q1_dot_7 = mc_link_2_x * two_l_1_q1_dot_s_q2 - link_2_2 * by_q1_dot_1;
    const double l_2_two_s_q2_q2_dot = p->l_2 * two_s_q2_q2_dot;
    const double by_q1_dot_8 = two_l_1_q1_dot_s_q2 + p->l_2 * by_q1_dot_1;
    const double by_q1_dot_9 = by_q1_dot_8 * c_q3 - l_2_two_s_q2_q2_dot * s_q3;
    const double by_q1_dot_10 = p->m_3 * (-l_2_two_s_q2_q2_dot * c_q3 - by_q1_dot_8 * s_q3);
    const double by_q1_dot_11 = by_q1_dot_10 - by_q1_dot_2;
    const double by_q1_dot_12 = mc_link_3_y * (by_q1_dot_3 - c_q2_q2_dot) - p->m_3 * by_q1_dot_9;
    const double by_q1_dot_13 = I_link_3_yy * (c_q2_c_q3 * v->q3 - s_q2_q2_dot * s_q3);
    const double by_q1_dot_14 = I_link_3_xx * (s_q2_q2_dot * c_q3 + c_q2_s_q3 * v->q3);
    const double mc_link_3_y_by_q1_dot_9 = mc_link_3_y * by_q1_dot_9;
    const double by_q1_dot_15 = link_3_3 * by_q1_dot_3 - I_link_3_xx * c_q2_q2_dot;
    const double by_q1_dot_16 = mc_link_3_y * by_q1_dot_5 + by_q1_dot_4 - by_q1_dot_14;
    const double by_q1_dot_17 = by_q1_dot_11 * c_q3 - by_q1_dot_12 * s_q3;
    const double by_q1_dot_18 = by_q1_dot_13 * c_q3 - by_q1_dot_16 * s_q3;
    const double by_q1_dot_19 = by_q1_dot_13 * s_q3 + by_q1_dot_16 * c_q3;
    const double by_q1_dot_20 = p->l_2 * (by_q1_dot_11 * s_q3 + by_q1_dot_12 * c_q3);
    const double by_q1_dot_21 = c_q2 * (by_q1_dot_19 + p->l_2 * by_q1_dot_17 - by_q1_dot_6);
    const double by_q1_dot_22 = s_q2 * (by_q1_dot_15 - mc_link_3_y_by_q1_dot_9 - I_link_2_xx * c_q2_q2_dot);
    const double by_q1_dot_23 = p->l_1 * (by_q1_dot_17 - mc_link_2_x * two_s_q2_q2_dot);
    const double by_q1_dot_24 = p->c_1 + by_q1_dot_21 - by_q1_dot_22 + by_q1_dot_23;
    const double by_q1_dot_25 = mc_link_3_y_by_q1_dot_9 - by_q1_dot_15;
    const double by_q1_dot_26 = by_q1_dot_20 - l_q3_q2 * by_q1_dot_25 - by_q1_dot_7 - by_q1_dot_18;
    const double d_q1_ddot_by_q1_dot = inv_q1 * (-l_q3_q1 * by_q1_dot_25 - by_q1_dot_24 - l_q2_q1 * by_q1_dot_26);
    const double d_q2_ddot_by_q1_dot = inv_q2 * by_q1_dot_26 - l_q2_q1 * d_q1_ddot_by_q1_dot;
    const double d_q3_ddot_by_q1_dot = inv_q3 * by_q1_dot_25 - l_q3_q1 * d_q1_ddot_by_q1_dot - l_q3_q2 * d_q2_ddot_by_q1_dot;
    /* derivatives with respect to q2_dot */
    const double by_q2_dot_1 = mc_link_3_y * two_omega_link_3_z * s_q3;
    const double by_q2_dot_2 = omega_link_3_z * c_q3 - omega_link_3_y * s_q3;
    const double two_omega_link_2_x = 2.0 * omega_link_2_x;
    const double by_q2_dot_3 = omega_link_2_x * link_2_4 + I_link_2_yy * omega_link_2_x;
    const double l_2_two_omega_link_2_x = p->l_2 * two_omega_link_2_x;
    const double l_2_two_omega_link_2_x_s_q3 = l_2_two_omega_link_2_x * s_q3;
    const double by_q2_dot_4 = by_q2_dot_1 + p->m_3 * l_2_two_omega_link_2_x * c_q3;
    const double by_q2_dot_5 = mc_link_3_y * (by_q2_dot_2 - omega_link_2_z) - p->m_3 * l_2_two_omega_link_2_x_s_q3;
    const double by_q2_dot_6 = I_link_3_yy * (s_q3 * v->q3 - omega_link_2_x_s_q3);
    const double by_q2_dot_7 = I_link_3_xx * (c_q3 * v->q3 - omega_link_2_x_c_q3);
    const double by_q2_dot_8 = mc_link_3_y * l_2_two_omega_link_2_x_s_q3;
    const double by_q2_dot_9 = link_3_3 * by_q2_dot_2 - I_link_3_xx * omega_link_2_z;
    const double by_q2_dot_10 = link_3_4 * omega_link_3_x * c_q3 - by_q2_dot_7;
    const double by_q2_dot_11 = 2.0 * p->l_2 * mc_link_3_y * v->q2 + by_q2_dot_10;
    const double by_q2_dot_12 = by_q2_dot_4 * c_q3 - by_q2_dot_5 * s_q3;
    const double by_q2_dot_13 = by_q2_dot_6 * c_q3 + by_q2_dot_11 * s_q3;
    const double by_q2_dot_14 = by_q2_dot_11 * c_q3 - by_q2_dot_6 * s_q3;
    const double by_q2_dot_15 = p->l_2 * (by_q2_dot_4 * s_q3 + by_q2_dot_5 * c_q3);
    const double by_q2_dot_16 = c_q2 * (by_q2_dot_14 + p->l_2 * by_q2_dot_12 + by_q2_dot_3);
    const double by_q2_dot_17 = s_q2 * (by_q2_dot_9 - by_q2_dot_8 - I_link_2_xx * omega_link_2_z);
    const double by_q2_dot_18 = p->l_1 * (mc_link_2_x * two_omega_link_2_x + by_q2_dot_12);
    const double by_q2_dot_19 = by_q2_dot_8 - by_q2_dot_9;
    const double by_q2_dot_20 = by_q2_dot_13 + by_q2_dot_15 - p->c_2 - l_q3_q2 * by_q2_dot_19;
    const double by_q2_dot_21 = by_q2_dot_16 - by_q2_dot_17 + by_q2_dot_18 + l_q2_q1 * by_q2_dot_20;
    const double d_q1_ddot_by_q2_dot = inv_q1 * (-l_q3_q1 * by_q2_dot_19 - by_q2_dot_21);
    const double d_q2_ddot_by_q2_dot = inv_q2 * by_q2_dot_20 - l_q2_q1 * d_q1_ddot_by_q2_dot;
    const double d_q3_ddot_by_q2_dot = inv_q3 * by_q2_dot_19 - l_q3_q1 * d_q1_ddot_by_q2_dot - l_q3_q2 * d_q2_ddot_by_q2_dot;
    /* derivatives with respect to q3_dot */
    const double by_q3_dot_1 = mc_link_3_y * two_omega_link_3_x;
    const double by_q3_dot_2 = omega_link_3_y * link_3_4 - I_link_3_xx * omega_link_3_y;
    const double by_q3_dot_1_c_q3 = by_q3_dot_1 * c_q3;
    const double by_q3_dot_3 = I_link_3_yy_omega_link_3_z * c_q3 - by_q3_dot_2 * s_q3;
    const double by_q3_dot_4 = I_link_3_yy_omega_link_3_z * s_q3 + by_q3_dot_2 * c_q3;
    const double by_q3_dot_5 = c_q2 * (by_q3_dot_4 - p->l_2 * by_q3_dot_1_c_q3);
    const double by_q3_dot_6 = by_q3_dot_3 + p->l_2 * by_q3_dot_1 * s_q3 - p->c_3 * l_q3_q2;
    const double by_q3_dot_7 = p->l_1 * by_q3_dot_1_c_q3 - by_q3_dot_5 + l_q2_q1 * by_q3_dot_6 + p->c_3 * l_q3_q1;
    const double d_q1_ddot_by_q3_dot = inv_q1 * by_q3_dot_7;
    const double d_q2_ddot_by_q3_dot = -inv_q2 * by_q3_dot_6 - l_q2_q1 * d_q1_ddot_by_q3_dot;
    const double d_q3_ddot_by_q3_dot = -l_q3_q1 * d_q1_ddot_by_q3_dot - p->c_3 * inv_q3 - l_q3_q2 * d_q2_ddot_by_q3_dot;
    const double q1_ddot_c_q2 = q1_ddot * c_q2;
    const double l_1_q1_ddot = p->l_1 * q1_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = q1_ddot * s_q2 - alpha_link_2_x;
    const double slopes_2 = q1_ddot_c_q2 + alpha_link_2_z;
    const double slopes_3 = mc_link_2_x * l_1_q1_ddot + I_link_2_yy * slopes_2 + alpha_link_2_z_link_2_4;
    const double slopes_4 = l_1_q1_ddot + p->l_2 * (slopes_2 + alpha_link_2_z);
    const double slopes_5 = a_link_2_z - p->l_2 * (q2_ddot - link_2_1);
    const double slopes_6 = omega_link_3_z_q3_dot + slopes_2 * s_q3 + q2_ddot * c_q3;
    const double slopes_7 = slopes_2 * c_q3 - q2_ddot * s_q3 - omega_link_3_y_q3_dot;
    const double q3_ddot_minus_slopes_1 = q3_ddot - slopes_1;
    const double slopes_8 = slopes_4 * c_q3 + slopes_5 * s_q3;
    const double slopes_9 = slopes_5 * c_q3 - slopes_4 * s_q3;
    const double m_3_slopes_8 = p->m_3 * slopes_8;
    const double m_3_slopes_9 = p->m_3 * slopes_9;
    const double m_3_slopes_8_minus_link_3_1 = m_3_slopes_8 - link_3_1;
    const double slopes_10 = m_3_slopes_9 + mc_link_3_y * (link_3_2 + q3_ddot_minus_slopes_1);
    const double I_link_3_yy_slopes_6 = I_link_3_yy * slopes_6;
    const double slopes_11 = mc_link_3_y * slopes_9 + link_3_2_link_3_3 + I_link_3_xx * q3_ddot_minus_slopes_1;
    const double slopes_12 = link_3_5 - mc_link_3_y_a_link_3_1_x + I_link_3_xx * slopes_7;
    const double slopes_13 = m_3_slopes_8_minus_link_3_1 * c_q3;
    const double slopes_10_s_q3 = slopes_10 * s_q3;
    const double I_link_3_yy_slopes_6_s_q3 = I_link_3_yy_slopes_6 * s_q3;
    const double slopes_12_c_q3 = slopes_12 * c_q3;
    const double slopes_14 = I_link_3_yy_slopes_6_s_q3 + slopes_12_c_q3 + p->l_2 * (slopes_13 - slopes_10_s_q3);
    const double slopes_15 = slopes_1 - alpha_link_2_x;
    const double slopes_16 = I_link_2_yy * slopes_1 - alpha_link_2_x * link_2_4;
    const double l_2_slopes_15 = p->l_2 * slopes_15;
    const double slopes_17 = alpha_link_2_z + q1_ddot_c_q2;
    const double slopes_18 = l_2_slopes_15 * s_q3 - by_q2_6 * c_q3;
    const double slopes_19 = p->m_3 * (by_q2_6 * s_q3 + l_2_slopes_15 * c_q3);
    const double by_q2_1_minus_slopes_19 = by_q2_1 - slopes_19;
    const double slopes_20 = p->m_3 * slopes_18 + mc_link_3_y * (by_q2_2 - slopes_17);
    const double slopes_21 = I_link_3_yy * (slopes_1 * s_q3 - omega_link_2_x_c_q3 * v->q3);
    const double slopes_22 = I_link_3_xx * (-omega_link_2_x_s_q3 * v->q3 - slopes_1 * c_q3);
    const double slopes_23 = link_3_3 * by_q2_2 - I_link_3_xx * slopes_17;
    const double slopes_24 = mc_link_3_y * slopes_18 + slopes_23;
    const double slopes_25 = by_q2_4 + slopes_22 - by_q2_3;
    const double slopes_26 = by_q2_1_minus_slopes_19 * c_q3 - slopes_20 * s_q3;
    const double slopes_27 = slopes_21 * c_q3 + slopes_25 * s_q3;
    const double slopes_28 = slopes_25 * c_q3 - slopes_21 * s_q3;
    const double slopes_29 = p->l_2 * (by_q2_1_minus_slopes_19 * s_q3 + slopes_20 * c_q3);
    const double slopes_30 = c_q2 * (slopes_28 + p->l_2 * slopes_26 - slopes_16);
    const double slopes_31 = slopes_30 - s_q2 * (slopes_3 + slopes_14);
    const double slopes_32 = s_q2 * (slopes_24 - I_link_2_xx * slopes_2);
    const double slopes_33 = c_q2 * (slopes_11 - I_link_2_xx * slopes_1) + slopes_32;
    const double slopes_34 = p->l_1 * (slopes_26 - mc_link_2_x * slopes_15);
    const double slopes_35 = mc_link_3_y * omega_link_3_y * two_omega_link_3_z + m_3_slopes_9;
    const double slopes_36 = mc_link_3_y * by_q3_1 - m_3_slopes_8;
    const double I_link_3_yy_slopes_7 = I_link_3_yy * slopes_7;
    const double mc_link_3_y_slopes_8 = mc_link_3_y * slopes_8;
    const double slopes_37 = omega_link_3_z * omega_link_3_x * link_3_4 - I_link_3_xx * slopes_6;
    const double slopes_38 = slopes_35 * c_q3 - m_3_slopes_8_minus_link_3_1 * s_q3;
    const double slopes_39 = slopes_10 * c_q3 + slopes_36 * s_q3;
    const double slopes_40 = slopes_36 * c_q3 - slopes_10_s_q3;
    const double slopes_38_minus_slopes_39 = slopes_38 - slopes_39;
    const double slopes_41 = slopes_12_c_q3 + slopes_37 * s_q3;
    const double slopes_42 = I_link_3_yy_slopes_6 * c_q3 + I_link_3_yy_slopes_7 * s_q3;
    const double slopes_43 = slopes_37 * c_q3 - slopes_12 * s_q3;
    const double slopes_44 = I_link_3_yy_slopes_7 * c_q3 - I_link_3_yy_slopes_6_s_q3 - slopes_41;
    const double slopes_45 = p->l_2 * (slopes_13 + slopes_35 * s_q3 + slopes_40);
    const double slopes_46 = c_q2 * (slopes_42 + slopes_43 + p->l_2 * slopes_38_minus_slopes_39);
    const double slopes_47 = slopes_46 - s_q2 * (link_3_3_by_q3_1 - mc_link_3_y_slopes_8);
    /* derivatives with respect to q2 */
    const double by_q2_7 = slopes_27 + slopes_29 + by_q2_5 + l_q3_q2 * slopes_24;
    const double by_q2_8 = slopes_31 - slopes_33 + slopes_34 + l_q2_q1 * by_q2_7;
    const double d_q1_ddot_by_q2 = -inv_q1 * (by_q2_8 - l_q3_q1 * slopes_24);
    const double d_q2_ddot_by_q2 = inv_q2 * by_q2_7 - l_q2_q1 * d_q1_ddot_by_q2;
    const double d_q3_ddot_by_q2 = -l_q3_q2 * d_q2_ddot_by_q2 - inv_q3 * slopes_24 - l_q3_q1 * d_q1_ddot_by_q2;
    /* derivatives with respect to q3 */
    const double by_q3_2 = mc_link_3_y_slopes_8 - link_3_3_by_q3_1;
    const double by_q3_3 = slopes_45 - slopes_44 - l_q3_q2 * by_q3_2;
    const double by_q3_4 = slopes_47 + p->l_1 * slopes_38_minus_slopes_39 + l_q2_q1 * by_q3_3;
    const double d_q1_ddot_by_q3 = inv_q1 * (-l_q3_q1 * by_q3_2 - by_q3_4);
    const double d_q2_ddot_by_q3 = inv_q2 * by_q3_3 - l_q2_q1 * d_q1_ddot_by_q3;
    const double d_q3_ddot_by_q3 = inv_q3 * by_q3_2 - l_q3_q1 * d_q1_ddot_by_q3 - l_q3_q2 * d_q2_ddot_by_q3;
    /* derivatives with respect to tau_1 */
    const double d_q2_ddot_by_tau_1 = -l_q2_q1 * inv_q1;
    const double d_q3_ddot_by_tau_1 = -l_q3_q1 * inv_q1 - l_q3_q2 * d_q2_ddot_by_tau_1;
    /* derivatives with respect to tau_2 */
    const double d_q2_ddot_by_tau_2 = inv_q2 - l_q2_q1 * d_q2_ddot_by_tau_1;
    const double d_q3_ddot_by_tau_2 = -l_q3_q2 * d_q2_ddot_by_tau_2 - l_q3_q1 * d_q2_ddot_by_tau_1;
    /* derivatives with respect to tau_3 */
    const double d_q1_ddot_by_tau_3 = inv_q1 * (l_q3_q2 * l_q2_q1 - l_q3_q1);
    const double d_q2_ddot_by_tau_3 = -l_q3_q2 * inv_q2 - l_q2_q1 * d_q1_ddot_by_tau_3;
    const double d_q3_ddot_by_tau_3 = inv_q3 - l_q3_q1 * d_q1_ddot_by_tau_3 - l_q3_q2 * d_q2_ddot_by_tau_3;
    if (!(I_link_3_xx > 0.0)) {
        return 3;
    }
    if (!(pivot_q2 > 0.0)) {
        return 2;
    }
    if (!(pivot_q1 > 0.0)) {
        return 1;
    }
    dx[0] = v->q1; /* q1' */
    dx[1] = v->q2; /* q2' */
    dx[2] = v->q3; /* q3' */
    dx[3] = q1_ddot; /* q1'' */
    dx[4] = q2_ddot; /* q2'' */
    dx[5] = q3_ddot; /* q3'' */
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][3] = 1.0; /* q1' */
    a[1][4] = 1.0; /* q2' */
    a[2][5] = 1.0; /* q3' */
    a[3][1] = d_q1_ddot_by_q2; /* q1'' */
    a[3][2] = d_q1_ddot_by_q3;
    a[3][3] = d_q1_ddot_by_q1_dot;
    a[3][4] = d_q1_ddot_by_q2_dot;
    a[3][5] = d_q1_ddot_by_q3_dot;
    a[4][1] = d_q2_ddot_by_q2; /* q2'' */
    a[4][2] = d_q2_ddot_by_q3;
    a[4][3] = d_q2_ddot_by_q1_dot;
    a[4][4] = d_q2_ddot_by_q2_dot;
    a[4][5] = d_q2_ddot_by_q3_dot;
    a[5][1] = d_q3_ddot_by_q2; /* q3'' */
    a[5][2] = d_q3_ddot_by_q3;
    a[5][3] = d_q3_ddot_by_q1_dot;
    a[5][4] = d_q3_ddot_by_q2_dot;
    a[5][5] = d_q3_ddot_by_q3_dot;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 3; j++) {
            b[i][j] = 0.0;
        }
    }
    b[3][0] = inv_q1; /* q1'' */
    b[3][1] = d_q2_ddot_by_tau_1;
    b[3][2] = d_q1_ddot_by_tau_3;
    b[4][0] = d_q2_ddot_by_tau_1; /* q2'' */
    b[4][1] = d_q2_ddot_by_tau_2;
    b[4][2] = d_q2_ddot_by_tau_3;
    b[5][0] = d_q3_ddot_by_tau_1; /* q3'' */
    b[5][1] = d_q3_ddot_by_tau_2;
    b[5][2] = d_q3_ddot_by_tau_3;
    return 0;
}

int chain3_parameter_jacobian(
    const struct chain3_state *x,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    double by_p[6][11])
{
    const struct chain3_coordinates *q = &x->q;
    const struct chain3_rates *v = &x->v;
    const double s_q2 = sin(q->q2);
    const double c_q2 = cos(q->q2);
    const double s_q3 = sin(q->q3);
    const double c_q3 = cos(q->q3);
    const double l_1_per_two = p->l_1 / 2.0;
    const double b_sq = p->b * p->b;
    const double b_sq_plus_l_1_sq = b_sq + p->l_1 * p->l_1;
    /* body bar_1 on link_1 */
    const double mc_link_1_x = p->m_1 * l_1_per_two;
    const double I_link_1_yy = p->m_1 * b_sq_plus_l_1_sq / 12.0 + l_1_per_two * mc_link_1_x;
    const double l_2_per_two = p->l_2 / 2.0;
    /* body bar_2 on link_2 */
    const double I_link_2_xx = p->m_2 * b_sq / 6.0;
    const double b_sq_plus_l_2_sq = b_sq + p->l_2 * p->l_2;
    const double mc_link_2_x = p->m_2 * l_2_per_two;
    const double I_link_2_yy = p->m_2 * b_sq_plus_l_2_sq / 12.0 + l_2_per_two * mc_link_2_x;
    const double l_3_per_two = p->l_3 / 2.0;
    const double b_sq_plus_l_3_sq = b_sq + p->l_3 * p->l_3;
    /* body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis */
    const double I_link_3_yy = p->m_3 * b_sq / 6.0;
    const double mc_link_3_y = p->m_3 * l_3_per_two;
    const double I_link_3_xx = p->m_3 * b_sq_plus_l_3_sq / 12.0 + l_3_per_two * mc_link_3_y;
    /* frame link_2 on link_1 */
    const double omega_link_2_z = c_q2 * v->q1;
    const double omega_link_2_x = -s_q2 * v->q1;
    const double alpha_link_2_x = -omega_link_2_z * v->q2;
    const double alpha_link_2_z = omega_link_2_x * v->q2;
    const double link_2_1 = v->q2 * v->q2 + omega_link_2_z * omega_link_2_z;
    const double two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    const double link_2_2 = omega_link_2_z * omega_link_2_x;
    const double link_2_3 = I_link_2_yy * alpha_link_2_z + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    const double I_link_2_xx_plus_I_link_3_xx = I_link_2_xx + I_link_3_xx;
    /* frame link_3 on link_2 */
    const double omega_link_3_y = c_q3 * v->q2 + omega_link_2_z * s_q3;
    const double omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v->q2;
    const double omega_link_3_x = v->q3 + omega_link_2_x;
    const double omega_link_3_z_q3_dot = omega_link_3_z * v->q3;
    const double omega_link_3_y_q3_dot = omega_link_3_y * v->q3;
    const double link_3_1 = omega_link_3_y * omega_link_3_x;
    const double link_3_2 = omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x;
    const double mc_link_3_y_link_3_2 = mc_link_3_y * link_3_2;
    const double link_3_3 = omega_link_3_y * omega_link_3_z;
    const double n_moving_link_3_y = I_link_3_yy * (omega_link_3_z_q3_dot + alpha_link_2_z * s_q3);
    const double link_3_4 = I_link_3_xx * (omega_link_3_y_q3_dot - alpha_link_2_z * c_q3);
    const double link_3_5 = I_link_3_yy - I_link_3_xx;
    const double mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    const double M_q2_q3 = -p->l_2 * mc_link_3_y * c_q3;
    const double l_2_mc_link_3_y_s_q3 = p->l_2 * mc_link_3_y_s_q3;
    const double link_3_6 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    const double M_q1_q3 = -link_3_6 - p->l_1 * mc_link_3_y_s_q3;
    const double link_3_5_c_q3 = link_3_5 * c_q3;
    const double link_3_5_c_q3_c_q3 = link_3_5_c_q3 * c_q3;
    const double q1_dot_sq = v->q1 * v->q1;
    /* frame link_2 on link_1 */
    const double a_link_2_1_x = -p->l_1 * q1_dot_sq;
    /* frame link_3 on link_2 */
    const double a_link_3_1_y = p->l_2 * two_alpha_link_2_z;
    const double m_3_l_2 = p->m_3 * p->l_2;
    const double l_2_m_3_l_2 = p->l_2 * m_3_l_2;
    /* frame link_2 on link_1 */
    const double a_link_2_z = p->g * c_q2 + a_link_2_1_x * s_q2;
    const double a_link_2_x = a_link_2_1_x * c_q2 - p->g * s_q2;
    const double link_2_4 = mc_link_2_x * a_link_2_z - link_2_2 * (I_link_2_xx - I_link_2_yy);
    const double M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_5_c_q3_c_q3 + l_2_m_3_l_2;
    const double link_2_5 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    const double M_q1_q2 = link_3_5_c_q3 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    const double link_2_6 = I_link_2_yy + I_link_3_yy - link_3_5_c_q3_c_q3 + l_2_m_3_l_2 - I_link_2_xx_plus_I_link_3_xx;
    const double link_2_7 = link_2_6 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    /* frame link_3 on link_2 */
    const double a_link_3_1_x = a_link_2_x - p->l_2 * link_2_1;
    const double a_link_3_1_z = a_link_2_z + p->l_2 * link_2_2;
    const double a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    const double a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    const double f_link_3_y = p->m_3 * a_link_3_y - mc_link_3_y_link_3_2;
    const double f_link_3_z = mc_link_3_y * (link_3_3 + alpha_link_2_x) + p->m_3 * a_link_3_z;
    const double n_link_3_x = link_3_3 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    const double n_link_3_z = link_3_1 * link_3_5 - link_3_4 - mc_link_3_y * a_link_3_1_x;
    const double f_link_3_1_y = f_link_3_y * c_q3 - f_link_3_z * s_q3;
    const double f_link_3_1_z = f_link_3_y * s_q3 + f_link_3_z * c_q3;
    const double n_link_3_1_y = n_moving_link_3_y * c_q3 - n_link_3_z * s_q3;
    const double n_link_3_1_z = n_moving_link_3_y * s_q3 + n_link_3_z * c_q3;
    /* frame link_2 on link_1 */
    const double n_link_2_y = n_link_3_1_y - p->l_2 * f_link_3_1_z - link_2_4;
    const double n_link_2_z = n_link_3_1_z + p->l_2 * f_link_3_1_y + link_2_3;
    const double n_link_2_1_z = n_link_2_z * c_q2 - s_q2 * (n_link_3_x + I_link_2_xx * alpha_link_2_x);
    const double n_link_1_z = n_link_2_1_z + p->l_1 * (mc_link_2_x * two_alpha_link_2_z + f_link_3_1_y);
    const double link_2_1_1 = p->l_1 * (link_2_5 + link_2_5 + p->l_1 * (p->m_2 + p->m_3));
    /* frame link_1 on ground */
    const double M_q1_q1 = I_link_1_yy + I_link_2_xx_plus_I_link_3_xx + link_2_7 * c_q2 + link_2_1_1;
    const double c_q2_c_q3 = c_q2 * c_q3;
    /* balance of forces */
    const double tau_q1 = u->tau_1 - p->c_1 * v->q1 - n_link_1_z;
    const double tau_q2 = u->tau_2 - p->c_2 * v->q2 - n_link_2_y;
    const double tau_q3 = u->tau_3 - p->c_3 * v->q3 - n_link_3_x;
    /* M = L^T D L and back-substitution */
    const double inv_q3 = 1.0 / I_link_3_xx;
    const double l_q3_q1 = M_q1_q3 * inv_q3;
    const double l_q3_q2 = M_q2_q3 * inv_q3;
    const double pivot_q2 = M_q2_q2 - M_q2_q3 * l_q3_q2;
    const double inv_q2 = 1.0 / pivot_q2;
    const double solve_1 = M_q1_q2 - M_q1_q3 * l_q3_q2;
    const double l_q2_q1 = inv_q2 * solve_1;
    const double pivot_q1 = M_q1_q1 - solve_1 * l_q2_q1 - M_q1_q3 * l_q3_q1;
    const double inv_q1 = 1.0 / pivot_q1;
    const double tau_q3_l_q3_q2_minus_tau_q2 = tau_q3 * l_q3_q2 - tau_q2;
    const double q1_ddot = inv_q1 * (l_q2_q1 * tau_q3_l_q3_q2_minus_tau_q2 + tau_q1 - tau_q3 * l_q3_q1);
    const double q2_ddot = -inv_q2 * tau_q3_l_q3_q2_minus_tau_q2 - l_q2_q1 * q1_ddot;
    const double q3_ddot = tau_q3 * inv_q3 - l_q3_q1 * q1_ddot - l_q3_q2 * q2_ddot;
    const double l_1_q1_ddot = p->l_1 * q1_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = q1_ddot * s_q2 - alpha_link_2_x;
    const double slopes_2 = q1_ddot * c_q2 + alpha_link_2_z;
    const double slopes_2_plus_alpha_link_2_z = slopes_2 + alpha_link_2_z;
    const double q2_ddot_minus_link_2_2 = q2_ddot - link_2_2;
    const double slopes_3 = l_1_q1_ddot + p->l_2 * slopes_2_plus_alpha_link_2_z;
    const double slopes_4 = a_link_2_z - p->l_2 * q2_ddot_minus_link_2_2;
    const double slopes_5 = omega_link_3_z_q3_dot + slopes_2 * s_q3 + q2_ddot * c_q3;
    const double slopes_6 = slopes_2 * c_q3 - q2_ddot * s_q3 - omega_link_3_y_q3_dot;
    const double q3_ddot_minus_slopes_1 = q3_ddot - slopes_1;
    const double slopes_7 = slopes_3 * c_q3 + slopes_4 * s_q3;
    const double slopes_8 = slopes_4 * c_q3 - slopes_3 * s_q3;
    const double slopes_9 = link_3_3 + q3_ddot_minus_slopes_1;
    const double slopes_10 = p->m_3 * slopes_7 - mc_link_3_y_link_3_2;
    const double slopes_11 = p->m_3 * slopes_8 + mc_link_3_y * slopes_9;
    const double slopes_12 = slopes_10 * c_q3 - slopes_11 * s_q3;
    const double slopes_13 = slopes_10 * s_q3 + slopes_11 * c_q3;
    const double slopes_14 = slopes_12 + p->m_2 * l_1_q1_ddot + mc_link_2_x * slopes_2_plus_alpha_link_2_z;
    const double slopes_15 = p->l_1 * (l_1_q1_ddot + l_2_per_two * slopes_2_plus_alpha_link_2_z);
    const double slopes_16 = slopes_7 - l_3_per_two * link_3_2;
    const double slopes_17 = slopes_8 + l_3_per_two * slopes_9;
    const double slopes_18 = slopes_16 * c_q3 - slopes_17 * s_q3;
    const double slopes_19 = p->l_2 * (slopes_16 * s_q3 + slopes_17 * c_q3);
    const double slopes_20 = q1_ddot * (2.0 * p->m_1 * p->l_1 / 12.0 + 0.5 * mc_link_1_x + 0.5 * p->m_1 * l_1_per_two);
    const double slopes_21 = slopes_2_plus_alpha_link_2_z * s_q3 + q2_ddot_minus_link_2_2 * c_q3;
    const double slopes_22 = p->m_3 * (slopes_2_plus_alpha_link_2_z * c_q3 - q2_ddot_minus_link_2_2 * s_q3);
    const double m_3_slopes_21 = p->m_3 * slopes_21;
    const double mc_link_3_y_slopes_21 = mc_link_3_y * slopes_21;
    const double slopes_23 = slopes_22 * c_q3 + m_3_slopes_21 * s_q3;
    const double slopes_24 = p->l_2 * (slopes_22 * s_q3 - m_3_slopes_21 * c_q3);
    const double b_sq_per_6 = b_sq / 6.0;
    /* derivatives with respect to m_2 */
    const double by_m_2_1 = b_sq_plus_l_2_sq / 12.0 + l_2_per_two * l_2_per_two;
    const double by_m_2_2 = alpha_link_2_z * (by_m_2_1 - b_sq_per_6);
    /* derivatives with respect to m_3 */
    const double by_m_3_1 = b_sq_plus_l_3_sq / 12.0 + l_3_per_two * l_3_per_two;
    const double by_m_3_2 = link_3_3 * (by_m_3_1 - b_sq_per_6);
    const double by_m_3_3 = link_3_1 * (b_sq_per_6 - by_m_3_1);
    const double q1_dot_sq_s_q2 = q1_dot_sq * s_q2;
    const double mc_link_3_y_q1_dot_sq_c_q2 = mc_link_3_y * q1_dot_sq * c_q2;
    const double half_m_2 = 0.5 * p->m_2;
    /* derivatives with respect to l_2 */
    const double by_l_2_1 = 2.0 * p->m_2 * p->l_2 / 12.0 + 0.5 * mc_link_2_x + l_2_per_two * half_m_2;
    const double mc_link_3_y_link_2_1 = mc_link_3_y * link_2_1;
    const double half_m_3 = 0.5 * p->m_3;
    /* derivatives with respect to l_3 */
    const double by_l_3_1 = 2.0 * p->m_3 * p->l_3 / 12.0 + 0.5 * mc_link_3_y + l_3_per_two * half_m_3;
    const double link_3_2_half_m_3 = link_3_2 * half_m_3;
    const double two_b = 2.0 * p->b;
    const double m_2_two_b = p->m_2 * two_b;
    const double m_2_two_b_per_6 = m_2_two_b / 6.0;
    const double m_2_two_b_per_12 = m_2_two_b / 12.0;
    const double m_3_two_b = p->m_3 * two_b;
    const double m_3_two_b_per_12 = m_3_two_b / 12.0;
    const double m_3_two_b_per_6 = m_3_two_b / 6.0;
    /* derivatives with respect to b */
    const double by_b_1 = alpha_link_2_z * (m_2_two_b_per_12 - m_2_two_b_per_6);
    const double by_b_2 = link_3_3 * (m_3_two_b_per_12 - m_3_two_b_per_6);
    const double by_b_3 = link_3_1 * (m_3_two_b_per_6 - m_3_two_b_per_12);
    const double mc_link_3_y_s_q2 = mc_link_3_y * s_q2;
    const double m_3_c_q2_s_q3 = p->m_3 * c_q2 * s_q3;
    const double m_3_c_q2_c_q3 = p->m_3 * c_q2_c_q3;
    const double mc_link_3_y_c_q2_c_q3 = mc_link_3_y * c_q2_c_q3;
    /* derivatives with respect to g */
    const double by_g_1 = m_3_c_q2_s_q3 * c_q3 - m_3_c_q2_c_q3 * s_q3;
    const double by_g_2 = p->l_2 * (m_3_c_q2_s_q3 * s_q3 + m_3_c_q2_c_q3 * c_q3);
    const double by_g_3 = mc_link_2_x * c_q2 + mc_link_3_y_s_q2 * s_q3 + by_g_2;
    const double by_g_4 = c_q2 * (mc_link_3_y_s_q2 * c_q3 + p->l_2 * by_g_1);
    const double by_g_5 = by_g_4 - mc_link_3_y_c_q2_c_q3 * s_q2 + p->l_1 * by_g_1;
    const double by_g_6 = by_g_3 + l_q3_q2 * mc_link_3_y_c_q2_c_q3;
    const double d_q1_ddot_by_g = -inv_q1 * (by_g_5 + l_q2_q1 * by_g_6 - l_q3_q1 * mc_link_3_y_c_q2_c_q3);
    const double d_q2_ddot_by_g = inv_q2 * by_g_6 - l_q2_q1 * d_q1_ddot_by_g;
    const double d_q3_ddot_by_g = -l_q3_q2 * d_q2_ddot_by_g - inv_q3 * mc_link_3_y_c_q2_c_q3 - l_q3_q1 * d_q1_ddot_by_g;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_25 = link_2_2 * (b_sq_per_6 - by_m_2_1) + q2_ddot * by_m_2_1;
    const double slopes_26 = slopes_2 * by_m_2_1 + by_m_2_2;
    const double slopes_27 = l_2_per_two * a_link_2_z - slopes_25;
    const double slopes_28 = c_q2 * (l_2_per_two * l_1_q1_ddot + slopes_26);
    const double slopes_29 = slopes_28 + slopes_1 * b_sq_per_6 * s_q2;
    const double slopes_5_b_sq_per_6 = slopes_5 * b_sq_per_6;
    const double slopes_30 = by_m_3_2 + q3_ddot_minus_slopes_1 * by_m_3_1;
    const double slopes_31 = l_3_per_two * slopes_8 + slopes_30;
    const double slopes_32 = by_m_3_3 - l_3_per_two * a_link_3_1_x + slopes_6 * by_m_3_1;
    const double slopes_33 = slopes_5_b_sq_per_6 * c_q3 - slopes_32 * s_q3;
    const double slopes_34 = slopes_5_b_sq_per_6 * s_q3 + slopes_32 * c_q3;
    const double slopes_35 = c_q2 * (slopes_34 + p->l_2 * slopes_18);
    const double slopes_36 = slopes_35 - slopes_31 * s_q2 + p->l_1 * slopes_18;
    const double slopes_37 = q1_dot_sq_s_q2 * c_q3 + q1_ddot * s_q3;
    const double slopes_38 = p->m_3 * (q1_ddot * c_q3 - q1_dot_sq_s_q2 * s_q3);
    const double m_3_slopes_37 = p->m_3 * slopes_37;
    const double mc_link_3_y_slopes_37 = mc_link_3_y * slopes_37;
    const double slopes_39 = slopes_38 * c_q3 + m_3_slopes_37 * s_q3;
    const double slopes_40 = p->l_2 * (slopes_38 * s_q3 - m_3_slopes_37 * c_q3);
    const double slopes_41 = mc_link_2_x * q1_ddot + mc_link_3_y_q1_dot_sq_c_q2 * c_q3 + p->l_2 * slopes_39;
    const double slopes_42 = slopes_41 * c_q2 + mc_link_3_y_slopes_37 * s_q2;
    const double slopes_43 = p->l_1 * (p->m_2 * q1_ddot + slopes_39);
    const double slopes_44 = slopes_20 + slopes_42 + slopes_14 + slopes_43;
    const double slopes_45 = q2_ddot * by_l_2_1 - link_2_2 * by_l_2_1;
    const double slopes_46 = slopes_2 * by_l_2_1 + alpha_link_2_z * by_l_2_1;
    const double slopes_47 = mc_link_3_y_link_2_1 * s_q3 + slopes_13 + slopes_24;
    const double slopes_48 = mc_link_3_y_link_2_1 * c_q3 + slopes_12 + p->l_2 * slopes_23;
    const double slopes_49 = l_1_q1_ddot * half_m_2 + slopes_46 + slopes_48;
    const double slopes_50 = slopes_49 * c_q2 + mc_link_3_y_slopes_21 * s_q2;
    const double slopes_51 = p->l_1 * (slopes_2_plus_alpha_link_2_z * half_m_2 + slopes_23);
    const double slopes_9_half_m_3 = slopes_9 * half_m_3;
    const double slopes_52 = link_3_3 * by_l_3_1 + q3_ddot_minus_slopes_1 * by_l_3_1;
    const double slopes_53 = slopes_6 * by_l_3_1 - link_3_1 * by_l_3_1;
    const double slopes_54 = slopes_8 * half_m_3 + slopes_52;
    const double slopes_55 = slopes_53 - a_link_3_1_x * half_m_3;
    const double slopes_56 = link_3_2_half_m_3 * c_q3 + slopes_9_half_m_3 * s_q3;
    const double slopes_57 = p->l_2 * (slopes_9_half_m_3 * c_q3 - link_3_2_half_m_3 * s_q3);
    const double slopes_58 = c_q2 * (slopes_55 * c_q3 - p->l_2 * slopes_56);
    const double slopes_59 = link_2_2 * (m_2_two_b_per_6 - m_2_two_b_per_12) + q2_ddot * m_2_two_b_per_12;
    const double slopes_5_m_3_two_b_per_6 = slopes_5 * m_3_two_b_per_6;
    const double slopes_60 = by_b_2 + q3_ddot_minus_slopes_1 * m_3_two_b_per_12;
    const double slopes_61 = by_b_3 + slopes_6 * m_3_two_b_per_12;
    const double slopes_62 = slopes_5_m_3_two_b_per_6 * c_q3 - slopes_61 * s_q3;
    const double slopes_63 = slopes_5_m_3_two_b_per_6 * s_q3 + slopes_61 * c_q3;
    const double slopes_64 = slopes_2 * m_2_two_b_per_12 + by_b_1 + slopes_63;
    const double slopes_65 = s_q2 * (slopes_60 - slopes_1 * m_2_two_b_per_6);
    const double slopes_66 = slopes_64 * c_q2 - slopes_65;
    /* derivatives with respect to m_1 */
    const double d_q1_ddot_by_m_1 = -inv_q1 * q1_ddot * (b_sq_plus_l_1_sq / 12.0 + l_1_per_two * l_1_per_two);
    const double d_q2_ddot_by_m_1 = -l_q2_q1 * d_q1_ddot_by_m_1;
    const double d_q3_ddot_by_m_1 = -l_q3_q2 * d_q2_ddot_by_m_1 - l_q3_q1 * d_q1_ddot_by_m_1;
    /* derivatives with respect to m_2 */
    const double d_q1_ddot_by_m_2 = -inv_q1 * (slopes_29 + slopes_15 + l_q2_q1 * slopes_27);
    const double d_q2_ddot_by_m_2 = inv_q2 * slopes_27 - l_q2_q1 * d_q1_ddot_by_m_2;
    const double d_q3_ddot_by_m_2 = -l_q3_q2 * d_q2_ddot_by_m_2 - l_q3_q1 * d_q1_ddot_by_m_2;
    /* derivatives with respect to m_3 */
    const double by_m_3_4 = slopes_19 - slopes_33 + l_q3_q2 * slopes_31;
    const double d_q1_ddot_by_m_3 = -inv_q1 * (slopes_36 + l_q2_q1 * by_m_3_4 - l_q3_q1 * slopes_31);
    const double d_q2_ddot_by_m_3 = inv_q2 * by_m_3_4 - l_q2_q1 * d_q1_ddot_by_m_3;
    const double d_q3_ddot_by_m_3 = -l_q3_q2 * d_q2_ddot_by_m_3 - inv_q3 * slopes_31 - l_q3_q1 * d_q1_ddot_by_m_3;
    /* derivatives with respect to l_1 */
    const double by_l_1_1 = mc_link_3_y_q1_dot_sq_c_q2 * s_q3 + slopes_40 - mc_link_2_x * q1_dot_sq_s_q2;
    const double by_l_1_2 = by_l_1_1 - l_q3_q2 * mc_link_3_y_slopes_37;
    const double d_q1_ddot_by_l_1 = inv_q1 * (-l_q3_q1 * mc_link_3_y_slopes_37 - slopes_44 - l_q2_q1 * by_l_1_2);
    const double d_q2_ddot_by_l_1 = inv_q2 * by_l_1_2 - l_q2_q1 * d_q1_ddot_by_l_1;
    const double d_q3_ddot_by_l_1 = inv_q3 * mc_link_3_y_slopes_37 - l_q3_q1 * d_q1_ddot_by_l_1 - l_q3_q2 * d_q2_ddot_by_l_1;
    /* derivatives with respect to l_2 */
    const double by_l_2_2 = slopes_47 - slopes_45 + a_link_2_z * half_m_2;
    const double by_l_2_3 = by_l_2_2 - l_q3_q2 * mc_link_3_y_slopes_21;
    const double by_l_2_4 = slopes_50 + slopes_51 + l_q2_q1 * by_l_2_3;
    const double d_q1_ddot_by_l_2 = inv_q1 * (-l_q3_q1 * mc_link_3_y_slopes_21 - by_l_2_4);
    const double d_q2_ddot_by_l_2 = inv_q2 * by_l_2_3 - l_q2_q1 * d_q1_ddot_by_l_2;
    const double d_q3_ddot_by_l_2 = inv_q3 * mc_link_3_y_slopes_21 - l_q3_q1 * d_q1_ddot_by_l_2 - l_q3_q2 * d_q2_ddot_by_l_2;
    /* derivatives with respect to l_3 */
    const double by_l_3_2 = p->l_1 * slopes_56 - slopes_58 + slopes_54 * s_q2;
    const double by_l_3_3 = slopes_55 * s_q3 + slopes_57 + l_q3_q2 * slopes_54;
    const double d_q1_ddot_by_l_3 = inv_q1 * (by_l_3_2 - l_q2_q1 * by_l_3_3 + l_q3_q1 * slopes_54);
    const double d_q2_ddot_by_l_3 = inv_q2 * by_l_3_3 - l_q2_q1 * d_q1_ddot_by_l_3;
    const double d_q3_ddot_by_l_3 = -l_q3_q1 * d_q1_ddot_by_l_3 - inv_q3 * slopes_54 - l_q3_q2 * d_q2_ddot_by_l_3;
    /* derivatives with respect to b */
    const double by_b_4 = l_q3_q2 * slopes_60 - slopes_59 - slopes_62;
    const double by_b_5 = p->m_1 * q1_ddot * two_b / 12.0 + slopes_66 + l_q2_q1 * by_b_4;
    const double d_q1_ddot_by_b = -inv_q1 * (by_b_5 - l_q3_q1 * slopes_60);
    const double d_q2_ddot_by_b = inv_q2 * by_b_4 - l_q2_q1 * d_q1_ddot_by_b;
    const double d_q3_ddot_by_b = -l_q3_q2 * d_q2_ddot_by_b - inv_q3 * slopes_60 - l_q3_q1 * d_q1_ddot_by_b;
    /* derivatives with respect to c_1 */
    const double d_q1_ddot_by_c_1 = -inv_q1 * v->q1;
    const double d_q2_ddot_by_c_1 = -l_q2_q1 * d_q1_ddot_by_c_1;
    const double d_q3_ddot_by_c_1 = -l_q3_q2 * d_q2_ddot_by_c_1 - l_q3_q1 * d_q1_ddot_by_c_1;
    /* derivatives with respect to c_2 */
    const double d_q1_ddot_by_c_2 = inv_q1 * l_q2_q1 * v->q2;
    const double d_q2_ddot_by_c_2 = -inv_q2 * v->q2 - l_q2_q1 * d_q1_ddot_by_c_2;
    const double d_q3_ddot_by_c_2 = -l_q3_q1 * d_q1_ddot_by_c_2 - l_q3_q2 * d_q2_ddot_by_c_2;
    const double l_q3_q2_q3_dot = l_q3_q2 * v->q3;
    /* derivatives with respect to c_3 */
    const double d_q1_ddot_by_c_3 = inv_q1 * (l_q3_q1 * v->q3 - l_q2_q1 * l_q3_q2_q3_dot);
    const double d_q2_ddot_by_c_3 = inv_q2 * l_q3_q2_q3_dot - l_q2_q1 * d_q1_ddot_by_c_3;
    const double d_q3_ddot_by_c_3 = -l_q3_q1 * d_q1_ddot_by_c_3 - inv_q3 * v->q3 - l_q3_q2 * d_q2_ddot_by_c_3;
    if (!(I_link_3_xx > 0.0)) {
        return 3;
    }
    if (!(pivot_q2 > 0.0)) {
        return 2;
    }
    if (!(pivot_q1 > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 11; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[3][0] = d_q1_ddot_by_m_1; /* q1'' */
    by_p[3][1] = d_q1_ddot_by_m_2;
    by_p[3][2] = d_q1_ddot_by_m_3;
    by_p[3][3] = d_q1_ddot_by_l_1;
    by_p[3][4] = d_q1_ddot_by_l_2;
    by_p[3][5] = d_q1_ddot_by_l_3;
    by_p[3][6] = d_q1_ddot_by_b;
    by_p[3][7] = d_q1_ddot_by_c_1;
    by_p[3][8] = d_q1_ddot_by_c_2;
    by_p[3][9] = d_q1_ddot_by_c_3;
    by_p[3][10] = d_q1_ddot_by_g;
    by_p[4][0] = d_q2_ddot_by_m_1; /* q2'' */
    by_p[4][1] = d_q2_ddot_by_m_2;
    by_p[4][2] = d_q2_ddot_by_m_3;
    by_p[4][3] = d_q2_ddot_by_l_1;
    by_p[4][4] = d_q2_ddot_by_l_2;
    by_p[4][5] = d_q2_ddot_by_l_3;
    by_p[4][6] = d_q2_ddot_by_b;
    by_p[4][7] = d_q2_ddot_by_c_1;
    by_p[4][8] = d_q2_ddot_by_c_2;
    by_p[4][9] = d_q2_ddot_by_c_3;
    by_p[4][10] = d_q2_ddot_by_g;
    by_p[5][0] = d_q3_ddot_by_m_1; /* q3'' */
    by_p[5][1] = d_q3_ddot_by_m_2;
    by_p[5][2] = d_q3_ddot_by_m_3;
    by_p[5][3] = d_q3_ddot_by_l_1;
    by_p[5][4] = d_q3_ddot_by_l_2;
    by_p[5][5] = d_q3_ddot_by_l_3;
    by_p[5][6] = d_q3_ddot_by_b;
    by_p[5][7] = d_q3_ddot_by_c_1;
    by_p[5][8] = d_q3_ddot_by_c_2;
    by_p[5][9] = d_q3_ddot_by_c_3;
    by_p[5][10] = d_q3_ddot_by_g;
    return 0;
}

void chain3_output_jacobian(const struct chain3_state *x, const struct chain3_parameters *p, double by_x[3][6], double by_p[3][11])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 6; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* q1 */
    by_x[1][1] = 1.0; /* q2 */
    by_x[2][2] = 1.0; /* q3 */
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 11; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

/*
 * Two arms on one column.
 * Generated from `tree.rig` (model 42640007); edit the rig, not this file.
 *
 * A branching rig: a driven column carries a left and a right arm, each with a shoulder that lifts it; the
 * right one has an elbow too. The arms push on one another through the column. A test bed of our own
 * (no published rig of this kind comes with numbers): tubes of 0.5 kg/m, hubs of 0.2 kg.
 *
 * 219 operations forward, 598 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "tree.h"

#include <math.h>

/* a^n by repeated squaring */
static double powi(double a, int n)
{
    unsigned left = n < 0 ? 0u - (unsigned)n : (unsigned)n;
    double square = a;
    double result = 1.0;
    while (left > 0u) {
        if (left % 2u == 1u) {
            result *= square;
        }
        square *= square;
        left /= 2u;
    }
    return n < 0 ? 1.0 / result : result;
}

void tree_nominal(struct tree_parameters *p)
{
    p->I_c = 0.02;
    p->a = 0.1;
    p->l = 0.4;
    p->l_u = 0.25;
    p->l_f = 0.2;
    p->rho = 0.5;
    p->m_e = 0.2;
    p->m_t = 0.15;
    p->c_psi = 0.05;
    p->c_s = 0.02;
    p->g = 9.81;
}

void tree_mass_matrix(const struct tree_coordinates *q, const struct tree_parameters *p, double m[4][4])
{
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_rho = p->l * p->rho;
    const double l_per_two = p->l / 2.0;
    const double l_rho_l_per_two = l_rho * l_per_two;
    const double l_m_t = p->l * p->m_t;
    /* frame left_arm on column */
    const double I_left_arm_yy = p->rho * powi(p->l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p->l * l_m_t;
    const double left_arm_1 = c_left * (l_rho_l_per_two + l_m_t);
    const double l_u_rho = p->l_u * p->rho;
    const double l_u_per_two = p->l_u / 2.0;
    const double l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    /* body right_tube on right_arm */
    const double right_tube_1 = p->rho * powi(p->l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two;
    const double l_u_m_e = p->l_u * p->m_e;
    /* frame right_arm on column */
    const double I_right_arm_yy = right_tube_1 + p->l_u * l_u_m_e;
    /* body fore_tube on forearm */
    const double m_forearm = p->l_f * p->rho;
    const double l_f_per_two = p->l_f / 2.0;
    const double mc_forearm_x = m_forearm * l_f_per_two;
    const double I_forearm_yy = p->rho * powi(p->l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    const double mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    const double mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    /* frame forearm on right_arm */
    const double M_right_elbow = I_forearm_yy + p->l_u * mc_forearm_x_c_elbow;
    const double I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    const double I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    const double forearm_1 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    const double forearm_1_1 = mc_forearm_x_c_elbow + p->l_u * m_forearm;
    const double forearm_1_2 = p->l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    /* frame right_arm on column */
    const double right_arm_1 = c_right * (l_u_rho_l_u_per_two + l_u_m_e + forearm_1_1);
    const double right_arm_2 = right_arm_1 - mc_forearm_x_s_elbow * s_right;
    const double right_arm_3 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_1;
    const double right_arm_4 = 2.0 * (I_forearm_yy_c_elbow * s_elbow + p->l_u * mc_forearm_x_s_elbow);
    const double right_arm_5 = right_arm_3 * c_right - right_arm_4 * s_right;
    const double right_arm_1_1 = p->a * (right_arm_2 + right_arm_2 + p->a * (p->m_e + l_u_rho + m_forearm));
    /* frame column on ground */
    const double column_1 = p->I_c + forearm_1 + right_arm_5 * c_right + right_arm_1_1;
    /* frame left_arm on column */
    const double left_arm_1_1 = p->a * (left_arm_1 + left_arm_1 + p->a * (p->m_t + l_rho));
    /* frame column on ground */
    const double M_psi_psi = column_1 + I_left_arm_yy * c_left * c_left + left_arm_1_1;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            m[i][j] = 0.0;
        }
    }
    m[0][0] = M_psi_psi; /* psi */
    m[1][1] = I_left_arm_yy; /* left */
    m[2][2] = I_right_arm_yy + I_forearm_yy + forearm_1_2; /* right */
    m[2][3] = M_right_elbow;
    m[3][2] = M_right_elbow; /* elbow */
    m[3][3] = I_forearm_yy;
}

void tree_bias(const struct tree_coordinates *q, const struct tree_rates *v, const struct tree_parameters *p, double h[4])
{
    const double s_left = sin(q->left);
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_per_two = p->l / 2.0;
    const double l_rho_l_per_two = p->l * p->rho * l_per_two;
    const double l_m_t = p->l * p->m_t;
    /* frame left_arm on column */
    const double mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    const double I_left_arm_yy = p->rho * powi(p->l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p->l * l_m_t;
    const double omega_left_arm_x = -s_left * v->psi;
    const double alpha_left_arm_z = omega_left_arm_x * v->left;
    const double n_moving_left_arm_1_z = 2.0 * I_left_arm_yy * alpha_left_arm_z * c_left;
    const double l_u_per_two = p->l_u / 2.0;
    const double l_u_rho_l_u_per_two = p->l_u * p->rho * l_u_per_two;
    /* body right_tube on right_arm */
    const double right_tube_1 = p->rho * powi(p->l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two;
    const double l_u_m_e = p->l_u * p->m_e;
    /* frame right_arm on column */
    const double mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    const double I_right_arm_yy = right_tube_1 + p->l_u * l_u_m_e;
    const double omega_right_arm_z = c_right * v->psi;
    const double omega_right_arm_x = s_right * v->psi;
    const double alpha_right_arm_z = -omega_right_arm_x * v->right;
    const double two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    const double right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    /* body fore_tube on forearm */
    const double m_forearm = p->l_f * p->rho;
    const double l_f_per_two = p->l_f / 2.0;
    const double mc_forearm_x = m_forearm * l_f_per_two;
    const double I_forearm_yy = p->rho * powi(p->l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    /* frame forearm on right_arm */
    const double omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    const double omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    const double omega_forearm_y = -v->right - v->elbow;
    const double forearm_1 = omega_right_arm_z * s_elbow * v->right - alpha_right_arm_z * c_elbow;
    const double alpha_forearm_z = -omega_forearm_x * v->elbow - forearm_1;
    const double forearm_2 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z);
    const double forearm_3 = omega_forearm_x * omega_forearm_y;
    const double forearm_4 = omega_forearm_z * omega_forearm_x;
    /* frame left_arm on column */
    const double a_left_arm_1_x = p->a * v->psi * v->psi;
    /* frame forearm on right_arm */
    const double a_forearm_1_y = p->l_u * two_alpha_right_arm_z;
    const double f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_3);
    const double n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_3;
    const double forearm_1_1 = n_moving_forearm_z * c_elbow + p->l_u * f_moving_forearm_y;
    /* frame right_arm on column */
    const double n_moving_right_arm_z = 2.0 * I_right_arm_yy * alpha_right_arm_z + forearm_1_1;
    const double right_arm_2 = n_moving_forearm_z * s_right * s_elbow;
    const double a_right_arm_z = a_left_arm_1_x * s_right + p->g * c_right;
    const double a_right_arm_x = p->g * s_right - a_left_arm_1_x * c_right;
    const double right_arm_1_1 = p->a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    const double right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_2 + right_arm_1_1;
    /* frame column on ground */
    const double n_moving_column_z = right_arm_1_2 + n_moving_left_arm_1_z - 2.0 * p->a * mc_left_arm_x * alpha_left_arm_z;
    /* frame left_arm on column */
    const double a_left_arm_z = a_left_arm_1_x * s_left + p->g * c_left;
    const double n_left_arm_y = -I_left_arm_yy * omega_left_arm_x * c_left * v->psi - mc_left_arm_x * a_left_arm_z;
    /* frame forearm on right_arm */
    const double a_forearm_1_x = a_right_arm_x - p->l_u * (v->right * v->right + omega_right_arm_z * omega_right_arm_z);
    const double a_forearm_1_z = p->l_u * right_arm_1 + a_right_arm_z;
    const double a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x * s_elbow;
    const double a_forearm_x = a_forearm_1_z * s_elbow + a_forearm_1_x * c_elbow;
    const double f_forearm_z = mc_forearm_x * forearm_4 + m_forearm * a_forearm_z;
    const double n_forearm_y = -I_forearm_yy * forearm_4 - mc_forearm_x * a_forearm_z;
    const double forearm_5 = s_elbow * (m_forearm * a_forearm_x - forearm_2);
    const double forearm_1_2 = p->l_u * (f_forearm_z * c_elbow + forearm_5) - n_forearm_y;
    /* frame right_arm on column */
    const double n_right_arm_y = -I_right_arm_yy * right_arm_1 - mc_right_arm_x * a_right_arm_z - forearm_1_2;
    h[0] = n_moving_column_z; /* psi */
    h[1] = n_left_arm_y; /* left */
    h[2] = -n_right_arm_y; /* right */
    h[3] = -n_forearm_y; /* elbow */
}

void tree_velocity_products(const struct tree_coordinates *q, const struct tree_rates *v, const struct tree_parameters *p, double c[4])
{
    const double s_left = sin(q->left);
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_per_two = p->l / 2.0;
    const double l_rho_l_per_two = p->l * p->rho * l_per_two;
    const double l_m_t = p->l * p->m_t;
    /* frame left_arm on column */
    const double mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    const double I_left_arm_yy = p->rho * powi(p->l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p->l * l_m_t;
    const double omega_left_arm_x = -s_left * v->psi;
    const double alpha_left_arm_z = omega_left_arm_x * v->left;
    const double left_arm_1 = I_left_arm_yy * omega_left_arm_x * c_left * v->psi;
    const double n_moving_left_arm_1_z = 2.0 * I_left_arm_yy * alpha_left_arm_z * c_left;
    const double l_u_per_two = p->l_u / 2.0;
    const double l_u_rho_l_u_per_two = p->l_u * p->rho * l_u_per_two;
    /* body right_tube on right_arm */
    const double right_tube_1 = p->rho * powi(p->l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two;
    const double l_u_m_e = p->l_u * p->m_e;
    /* frame right_arm on column */
    const double mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    const double I_right_arm_yy = right_tube_1 + p->l_u * l_u_m_e;
    const double omega_right_arm_z = c_right * v->psi;
    const double omega_right_arm_x = s_right * v->psi;
    const double alpha_right_arm_z = -omega_right_arm_x * v->right;
    const double two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    const double right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    /* body fore_tube on forearm */
    const double m_forearm = p->l_f * p->rho;
    const double l_f_per_two = p->l_f / 2.0;
    const double mc_forearm_x = m_forearm * l_f_per_two;
    const double I_forearm_yy = p->rho * powi(p->l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    /* frame forearm on right_arm */
    const double omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    const double omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    const double omega_forearm_y = -v->right - v->elbow;
    const double forearm_1 = omega_right_arm_z * s_elbow * v->right - alpha_right_arm_z * c_elbow;
    const double alpha_forearm_z = -omega_forearm_x * v->elbow - forearm_1;
    const double forearm_2 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z);
    const double forearm_3 = omega_forearm_x * omega_forearm_y;
    const double forearm_4 = omega_forearm_z * omega_forearm_x;
    /* frame left_arm on column */
    const double a_left_arm_1_x = p->a * v->psi * v->psi;
    const double n_moving_left_arm_y = -left_arm_1 - mc_left_arm_x * a_left_arm_1_x * s_left;
    /* frame right_arm on column */
    const double a_right_arm_z = a_left_arm_1_x * s_right;
    /* frame forearm on right_arm */
    const double forearm_1_1 = p->l_u * (v->right * v->right + omega_right_arm_z * omega_right_arm_z);
    const double a_forearm_1_y = p->l_u * two_alpha_right_arm_z;
    const double a_forearm_1_x = -a_left_arm_1_x * c_right - forearm_1_1;
    const double a_forearm_1_z = a_right_arm_z + p->l_u * right_arm_1;
    const double a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x * s_elbow;
    const double a_forearm_x = a_forearm_1_z * s_elbow + a_forearm_1_x * c_elbow;
    const double f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_3);
    const double f_moving_forearm_z = m_forearm * a_forearm_z + mc_forearm_x * forearm_4;
    const double n_moving_forearm_y = -I_forearm_yy * forearm_4 - mc_forearm_x * a_forearm_z;
    const double n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_3;
    const double forearm_5 = s_elbow * (m_forearm * a_forearm_x - forearm_2);
    const double forearm_1_2 = p->l_u * (f_moving_forearm_z * c_elbow + forearm_5) - n_moving_forearm_y;
    const double forearm_1_3 = n_moving_forearm_z * c_elbow + p->l_u * f_moving_forearm_y;
    /* frame right_arm on column */
    const double n_moving_right_arm_y = -I_right_arm_yy * right_arm_1 - mc_right_arm_x * a_right_arm_z - forearm_1_2;
    const double n_moving_right_arm_z = 2.0 * I_right_arm_yy * alpha_right_arm_z + forearm_1_3;
    const double right_arm_2 = n_moving_forearm_z * s_right * s_elbow;
    const double right_arm_1_1 = p->a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    const double right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_2 + right_arm_1_1;
    /* frame column on ground */
    const double n_moving_column_z = right_arm_1_2 + n_moving_left_arm_1_z - 2.0 * p->a * mc_left_arm_x * alpha_left_arm_z;
    c[0] = n_moving_column_z; /* psi */
    c[1] = n_moving_left_arm_y; /* left */
    c[2] = -n_moving_right_arm_y; /* right */
    c[3] = -n_moving_forearm_y; /* elbow */
}

void tree_gravity(const struct tree_coordinates *q, const struct tree_parameters *p, double g[4])
{
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    /* body fore_tube on forearm */
    const double m_forearm = p->l_f * p->rho;
    const double l_f_per_two = p->l_f / 2.0;
    const double l_f_per_two_c_elbow = l_f_per_two * c_elbow;
    const double l_f_per_two_s_right_s_elbow = l_f_per_two * s_right * s_elbow;
    const double g_left = p->l * p->l * p->rho * p->g * c_left / 2.0 + p->l * p->m_t * p->g * c_left;
    const double gravity_1 = p->l_u * p->l_u * p->rho * p->g * c_right / 2.0 + p->l_u * p->m_e * p->g * c_right;
    const double gravity_2 = p->g * m_forearm * (c_right * (p->l_u + l_f_per_two_c_elbow) - l_f_per_two_s_right_s_elbow);
    const double g_elbow = p->g * m_forearm * (l_f_per_two_c_elbow * c_right - l_f_per_two_s_right_s_elbow);
    g[0] = 0.0; /* psi */
    g[1] = g_left; /* left */
    g[2] = gravity_1 + gravity_2; /* right */
    g[3] = g_elbow; /* elbow */
}

void tree_dissipation(const struct tree_coordinates *q, const struct tree_rates *v, const struct tree_parameters *p, double d[4])
{
    (void)q;
    d[0] = p->c_psi * v->psi; /* psi */
    d[1] = p->c_s * v->left; /* left */
    d[2] = p->c_s * v->right; /* right */
    d[3] = p->c_s * v->elbow; /* elbow */
}

void tree_generalized_force(const struct tree_coordinates *q, const struct tree_inputs *u, const struct tree_parameters *p, double f[4])
{
    (void)q;
    (void)p;
    f[0] = u->tau_psi; /* psi */
    f[1] = u->tau_l; /* left */
    f[2] = u->tau_r; /* right */
    f[3] = u->tau_e; /* elbow */
}

void tree_input_map(const struct tree_coordinates *q, const struct tree_parameters *p, double s[4][4])
{
    (void)q;
    (void)p;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            s[i][j] = 0.0;
        }
    }
    s[0][0] = 1.0; /* psi */
    s[1][1] = 1.0; /* left */
    s[2][2] = 1.0; /* right */
    s[3][3] = 1.0; /* elbow */
}

double tree_kinetic_energy(const struct tree_coordinates *q, const struct tree_rates *v, const struct tree_parameters *p)
{
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_per_two = p->l / 2.0;
    const double rho_l_pow3_per_12 = p->rho * powi(p->l, 3) / 12.0;
    const double l_per_two_left_dot = l_per_two * v->left;
    const double l_u_per_two = p->l_u / 2.0;
    const double rho_l_u_pow3_per_12 = p->rho * powi(p->l_u, 3) / 12.0;
    const double l_u_per_two_right_dot = l_u_per_two * v->right;
    const double l_f_per_two = p->l_f / 2.0;
    const double rho_l_f_pow3_per_12 = p->rho * powi(p->l_f, 3) / 12.0;
    /* frame left_arm on column */
    const double omega_left_arm_z = c_left * v->psi;
    /* frame right_arm on column */
    const double omega_right_arm_z = c_right * v->psi;
    /* frame forearm on right_arm */
    const double omega_forearm_z = omega_right_arm_z * c_elbow - s_elbow * s_right * v->psi;
    const double omega_forearm_y = -v->right - v->elbow;
    const double a_psi_dot = p->a * v->psi;
    const double l_u_right_dot = p->l_u * v->right;
    const double forearm_1_1 = a_psi_dot + p->l_u * omega_right_arm_z;
    const double l_u_right_dot_s_elbow = l_u_right_dot * s_elbow;
    /* body left_tube on left_arm */
    const double left_tube_1 = a_psi_dot + l_per_two * omega_left_arm_z;
    const double left_tube_2 = left_tube_1 * left_tube_1 + l_per_two_left_dot * l_per_two_left_dot;
    const double left_tube_3 = rho_l_pow3_per_12 * v->left * v->left + omega_left_arm_z * rho_l_pow3_per_12 * omega_left_arm_z;
    const double left_tube_4 = 0.5 * p->I_c * v->psi * v->psi + 0.5 * (p->l * p->rho * left_tube_2 + left_tube_3);
    const double l_left_dot = p->l * v->left;
    /* body left_tip on left_arm */
    const double left_tip_1 = a_psi_dot + p->l * omega_left_arm_z;
    const double left_tip_2 = 0.5 * p->m_t * (left_tip_1 * left_tip_1 + l_left_dot * l_left_dot);
    /* body right_tube on right_arm */
    const double right_tube_1 = a_psi_dot + l_u_per_two * omega_right_arm_z;
    const double right_tube_2 = right_tube_1 * right_tube_1 + l_u_per_two_right_dot * l_u_per_two_right_dot;
    const double right_tube_3 = rho_l_u_pow3_per_12 * v->right * v->right + omega_right_arm_z * rho_l_u_pow3_per_12 * omega_right_arm_z;
    const double right_tube_4 = 0.5 * (p->l_u * p->rho * right_tube_2 + right_tube_3);
    /* body hub on right_arm */
    const double hub_1 = 0.5 * p->m_e * (forearm_1_1 * forearm_1_1 + l_u_right_dot * l_u_right_dot);
    const double hub_2 = left_tube_4 + left_tip_2 + right_tube_4 + hub_1;
    /* body fore_tube on forearm */
    const double fore_tube_1 = forearm_1_1 + l_f_per_two * omega_forearm_z;
    const double fore_tube_2 = l_u_right_dot * c_elbow - l_f_per_two * omega_forearm_y;
    const double fore_tube_3 = l_u_right_dot_s_elbow * l_u_right_dot_s_elbow + fore_tube_1 * fore_tube_1;
    const double fore_tube_4 = p->l_f * p->rho * (fore_tube_2 * fore_tube_2 + fore_tube_3);
    const double fore_tube_5 = omega_forearm_z * rho_l_f_pow3_per_12 * omega_forearm_z;
    const double fore_tube_6 = fore_tube_4 + omega_forearm_y * rho_l_f_pow3_per_12 * omega_forearm_y + fore_tube_5;
    return hub_2 + 0.5 * fore_tube_6;
}

double tree_potential_energy(const struct tree_coordinates *q, const struct tree_parameters *p)
{
    const double s_left = sin(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_f_per_two = p->l_f / 2.0;
    /* body fore_tube on forearm */
    const double fore_tube_1 = s_right * (p->l_u + l_f_per_two * c_elbow);
    const double fore_tube_2 = p->g * (l_f_per_two * c_right * s_elbow + fore_tube_1);
    /* body left_tip on left_arm */
    const double left_tip_1 = p->l * p->l * p->rho * p->g * s_left / 2.0 + p->l * p->m_t * p->g * s_left;
    /* body right_tube on right_arm */
    const double right_tube_1 = left_tip_1 + p->l_u * p->l_u * p->rho * p->g * s_right / 2.0;
    /* body hub on right_arm */
    const double hub_1 = right_tube_1 + p->l_u * p->m_e * p->g * s_right;
    return hub_1 + p->l_f * p->rho * fore_tube_2;
}

void tree_inverse_dynamics(
    const struct tree_state *x,
    const struct tree_accelerations *a,
    const struct tree_inputs *u,
    const struct tree_parameters *p,
    double r[4])
{
    const struct tree_coordinates *q = &x->q;
    const struct tree_rates *v = &x->v;
    const double s_left = sin(q->left);
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_rho = p->l * p->rho;
    const double l_per_two = p->l / 2.0;
    const double l_rho_l_per_two = l_rho * l_per_two;
    const double l_m_t = p->l * p->m_t;
    /* frame left_arm on column */
    const double mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    const double I_left_arm_yy = p->rho * powi(p->l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p->l * l_m_t;
    const double omega_left_arm_x = -s_left * v->psi;
    const double alpha_left_arm_z = omega_left_arm_x * v->left;
    const double alpha_left_arm_z_2 = c_left * a->psi + alpha_left_arm_z;
    const double left_arm_1 = I_left_arm_yy * a->left - I_left_arm_yy * omega_left_arm_x * c_left * v->psi;
    const double l_u_rho = p->l_u * p->rho;
    const double l_u_per_two = p->l_u / 2.0;
    const double l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    /* body right_tube on right_arm */
    const double right_tube_1 = p->rho * powi(p->l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two;
    const double l_u_m_e = p->l_u * p->m_e;
    /* frame right_arm on column */
    const double mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    const double I_right_arm_yy = right_tube_1 + p->l_u * l_u_m_e;
    const double omega_right_arm_z = c_right * v->psi;
    const double omega_right_arm_x = s_right * v->psi;
    const double alpha_right_arm_z = -omega_right_arm_x * v->right;
    const double right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    const double alpha_right_arm_x = omega_right_arm_z * v->right + s_right * a->psi;
    const double alpha_right_arm_z_2 = c_right * a->psi + alpha_right_arm_z;
    const double right_arm_2 = alpha_right_arm_z_2 + alpha_right_arm_z;
    /* body fore_tube on forearm */
    const double m_forearm = p->l_f * p->rho;
    const double l_f_per_two = p->l_f / 2.0;
    const double mc_forearm_x = m_forearm * l_f_per_two;
    const double I_forearm_yy = p->rho * powi(p->l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    /* frame forearm on right_arm */
    const double omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    const double omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    const double omega_forearm_y = -v->right - v->elbow;
    const double forearm_1 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z);
    const double forearm_2 = omega_forearm_x * omega_forearm_y;
    const double forearm_3 = omega_forearm_z * omega_forearm_x;
    const double forearm_4 = alpha_right_arm_z_2 * c_elbow - alpha_right_arm_x * s_elbow;
    const double alpha_forearm_z = forearm_4 - omega_forearm_x * v->elbow;
    /* frame left_arm on column */
    const double a_left_arm_1_x = p->a * v->psi * v->psi;
    const double a_left_arm_z = a_left_arm_1_x * s_left + p->g * c_left;
    /* frame right_arm on column */
    const double a_right_arm_z = a_left_arm_1_x * s_right + p->g * c_right;
    const double a_right_arm_x = p->g * s_right - a_left_arm_1_x * c_right;
    /* frame forearm on right_arm */
    const double a_forearm_1_x = a_right_arm_x - p->l_u * (v->right * v->right + omega_right_arm_z * omega_right_arm_z);
    const double a_forearm_1_z = a_right_arm_z + p->l_u * (a->right + right_arm_1);
    /* gravity */
    const double alpha_forearm_y = -a->right - a->elbow;
    const double a_left_arm_1_y = -p->a * a->psi;
    /* frame left_arm on column */
    const double f_net_left_arm_y = a_left_arm_1_y * (p->m_t + l_rho) + mc_left_arm_x * (alpha_left_arm_z_2 + alpha_left_arm_z);
    const double n_net_left_arm_z = mc_left_arm_x * a_left_arm_1_y + I_left_arm_yy * alpha_left_arm_z_2 + I_left_arm_yy * alpha_left_arm_z;
    /* frame right_arm on column */
    const double right_arm_3 = I_right_arm_yy * alpha_right_arm_z_2 - mc_right_arm_x * a_left_arm_1_y + I_right_arm_yy * alpha_right_arm_z;
    /* frame forearm on right_arm */
    const double a_forearm_1_y = p->l_u * right_arm_2 - a_left_arm_1_y;
    const double a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x * s_elbow;
    const double a_forearm_x = a_forearm_1_x * c_elbow + a_forearm_1_z * s_elbow;
    const double f_net_forearm_y = m_forearm * a_forearm_1_y + mc_forearm_x * (alpha_forearm_z + forearm_2);
    const double f_net_forearm_z = m_forearm * a_forearm_z + mc_forearm_x * (forearm_3 - alpha_forearm_y);
    const double n_net_forearm_y = I_forearm_yy * alpha_forearm_y - mc_forearm_x * a_forearm_z - I_forearm_yy * forearm_3;
    const double n_net_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_2;
    const double n_net_left_arm_y = left_arm_1 - mc_left_arm_x * a_left_arm_z - u->tau_l;
    const double forearm_5 = u->tau_r - mc_right_arm_x * a_right_arm_z - I_right_arm_yy * right_arm_1 - I_right_arm_yy * a->right;
    const double forearm_6 = s_elbow * (m_forearm * a_forearm_x - forearm_1);
    const double forearm_1_1 = p->l_u * (f_net_forearm_z * c_elbow + forearm_6) - n_net_forearm_y;
    /* frame right_arm on column */
    const double f_net_right_arm_y = mc_right_arm_x * right_arm_2 - a_left_arm_1_y * (p->m_e + l_u_rho) + f_net_forearm_y;
    const double n_net_right_arm_z = right_arm_3 + n_net_forearm_z * c_elbow + p->l_u * f_net_forearm_y;
    const double n_net_right_arm_1_z = n_net_right_arm_z * c_right - n_net_forearm_z * s_right * s_elbow;
    /* frame left_arm on column */
    const double left_arm_1_1 = n_net_left_arm_z * c_left - p->a * f_net_left_arm_y;
    /* frame column on ground */
    const double n_net_column_z = p->I_c * a->psi + n_net_right_arm_1_z + p->a * f_net_right_arm_y + left_arm_1_1;
    r[0] = p->c_psi * v->psi + n_net_column_z - u->tau_psi; /* psi */
    r[1] = p->c_s * v->left + n_net_left_arm_y; /* left */
    r[2] = p->c_s * v->right + forearm_1_1 - forearm_5; /* right */
    r[3] = p->c_s * v->elbow - n_net_forearm_y - u->tau_e; /* elbow */
}

void tree_outputs(const struct tree_state *x, const struct tree_parameters *p, struct tree_outputs *y)
{
    const struct tree_coordinates *q = &x->q;
    (void)p;
    y->psi = q->psi;
    y->left = q->left;
    y->right = q->right;
    y->elbow = q->elbow;
}

void tree_pivots(const struct tree_state *x, const struct tree_parameters *p, double d[4])
{
    const struct tree_coordinates *q = &x->q;
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_rho = p->l * p->rho;
    const double l_per_two = p->l / 2.0;
    const double l_rho_l_per_two = l_rho * l_per_two;
    const double l_m_t = p->l * p->m_t;
    /* frame left_arm on column */
    const double I_left_arm_yy = p->rho * powi(p->l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p->l * l_m_t;
    const double left_arm_1 = c_left * (l_rho_l_per_two + l_m_t);
    const double l_u_rho = p->l_u * p->rho;
    const double l_u_per_two = p->l_u / 2.0;
    const double l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    /* body right_tube on right_arm */
    const double right_tube_1 = p->rho * powi(p->l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two;
    const double l_u_m_e = p->l_u * p->m_e;
    /* frame right_arm on column */
    const double I_right_arm_yy = right_tube_1 + p->l_u * l_u_m_e;
    /* body fore_tube on forearm */
    const double m_forearm = p->l_f * p->rho;
    const double l_f_per_two = p->l_f / 2.0;
    const double mc_forearm_x = m_forearm * l_f_per_two;
    const double I_forearm_yy = p->rho * powi(p->l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    const double mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    const double mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    /* frame forearm on right_arm */
    const double M_right_elbow = I_forearm_yy + p->l_u * mc_forearm_x_c_elbow;
    const double I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    const double I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    const double forearm_1 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    const double forearm_1_1 = mc_forearm_x_c_elbow + p->l_u * m_forearm;
    const double forearm_1_2 = p->l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    /* frame right_arm on column */
    const double right_arm_1 = c_right * (l_u_rho_l_u_per_two + l_u_m_e + forearm_1_1);
    const double right_arm_2 = right_arm_1 - mc_forearm_x_s_elbow * s_right;
    const double right_arm_3 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_1;
    const double right_arm_4 = 2.0 * (I_forearm_yy_c_elbow * s_elbow + p->l_u * mc_forearm_x_s_elbow);
    const double right_arm_5 = right_arm_3 * c_right - right_arm_4 * s_right;
    const double right_arm_1_1 = p->a * (right_arm_2 + right_arm_2 + p->a * (p->m_e + l_u_rho + m_forearm));
    /* frame column on ground */
    const double column_1 = p->I_c + forearm_1 + right_arm_5 * c_right + right_arm_1_1;
    /* frame left_arm on column */
    const double left_arm_1_1 = p->a * (left_arm_1 + left_arm_1 + p->a * (p->m_t + l_rho));
    /* frame column on ground */
    const double M_psi_psi = column_1 + I_left_arm_yy * c_left * c_left + left_arm_1_1;
    /* M = L^T D L and back-substitution */
    const double pivot_right = I_right_arm_yy + I_forearm_yy + forearm_1_2 - M_right_elbow * M_right_elbow / I_forearm_yy;
    d[0] = M_psi_psi; /* psi */
    d[1] = I_left_arm_yy; /* left */
    d[2] = pivot_right; /* right */
    d[3] = I_forearm_yy; /* elbow */
}

int tree_forward_dynamics(
    const struct tree_state *x,
    const struct tree_inputs *u,
    const struct tree_parameters *p,
    struct tree_accelerations *a)
{
    const struct tree_coordinates *q = &x->q;
    const struct tree_rates *v = &x->v;
    const double s_left = sin(q->left);
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_rho = p->l * p->rho;
    const double l_per_two = p->l / 2.0;
    const double l_rho_l_per_two = l_rho * l_per_two;
    const double l_m_t = p->l * p->m_t;
    /* frame left_arm on column */
    const double mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    const double I_left_arm_yy = p->rho * powi(p->l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p->l * l_m_t;
    const double omega_left_arm_x = -s_left * v->psi;
    const double alpha_left_arm_z = omega_left_arm_x * v->left;
    const double n_moving_left_arm_1_z = 2.0 * I_left_arm_yy * alpha_left_arm_z * c_left;
    const double mc_left_arm_x_c_left = mc_left_arm_x * c_left;
    const double l_u_rho = p->l_u * p->rho;
    const double l_u_per_two = p->l_u / 2.0;
    const double l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    /* body right_tube on right_arm */
    const double right_tube_1 = p->rho * powi(p->l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two;
    const double l_u_m_e = p->l_u * p->m_e;
    /* frame right_arm on column */
    const double mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    const double I_right_arm_yy = right_tube_1 + p->l_u * l_u_m_e;
    const double omega_right_arm_z = c_right * v->psi;
    const double omega_right_arm_x = s_right * v->psi;
    const double alpha_right_arm_z = -omega_right_arm_x * v->right;
    const double two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    const double right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    /* body fore_tube on forearm */
    const double m_forearm = p->l_f * p->rho;
    const double l_f_per_two = p->l_f / 2.0;
    const double mc_forearm_x = m_forearm * l_f_per_two;
    const double I_forearm_yy = p->rho * powi(p->l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    /* frame forearm on right_arm */
    const double omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    const double omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    const double omega_forearm_y = -v->right - v->elbow;
    const double forearm_1 = omega_right_arm_z * s_elbow * v->right - alpha_right_arm_z * c_elbow;
    const double alpha_forearm_z = -omega_forearm_x * v->elbow - forearm_1;
    const double forearm_2 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z);
    const double forearm_3 = omega_forearm_x * omega_forearm_y;
    const double forearm_4 = omega_forearm_z * omega_forearm_x;
    const double mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    const double mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    const double M_right_elbow = I_forearm_yy + p->l_u * mc_forearm_x_c_elbow;
    const double I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    const double I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    const double forearm_5 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    /* frame left_arm on column */
    const double a_left_arm_1_x = p->a * v->psi * v->psi;
    const double left_arm_1_1 = p->a * (p->a * (p->m_t + l_rho) - mc_left_arm_x_c_left - mc_left_arm_x_c_left);
    /* frame forearm on right_arm */
    const double a_forearm_1_y = p->l_u * two_alpha_right_arm_z;
    const double forearm_1_1 = mc_forearm_x_c_elbow + p->l_u * m_forearm;
    const double forearm_1_2 = p->l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    const double f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_3);
    const double n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_3;
    const double forearm_1_3 = n_moving_forearm_z * c_elbow + p->l_u * f_moving_forearm_y;
    /* frame right_arm on column */
    const double n_moving_right_arm_z = 2.0 * I_right_arm_yy * alpha_right_arm_z + forearm_1_3;
    const double right_arm_2 = n_moving_forearm_z * s_right * s_elbow;
    const double a_right_arm_z = a_left_arm_1_x * s_right + p->g * c_right;
    const double a_right_arm_x = p->g * s_right - a_left_arm_1_x * c_right;
    const double right_arm_3 = c_right * (mc_right_arm_x + forearm_1_1);
    const double right_arm_4 = right_arm_3 - mc_forearm_x_s_elbow * s_right;
    const double right_arm_5 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_5;
    const double right_arm_6 = 2.0 * (I_forearm_yy_c_elbow * s_elbow + p->l_u * mc_forearm_x_s_elbow);
    const double right_arm_7 = right_arm_5 * c_right - right_arm_6 * s_right;
    const double right_arm_1_1 = p->a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    const double right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_2 + right_arm_1_1;
    const double right_arm_1_3 = p->a * (right_arm_4 + right_arm_4 + p->a * (p->m_e + l_u_rho + m_forearm));
    /* frame column on ground */
    const double n_moving_column_z = right_arm_1_2 + n_moving_left_arm_1_z - 2.0 * p->a * mc_left_arm_x * alpha_left_arm_z;
    const double column_1 = p->I_c + forearm_5 + right_arm_7 * c_right + right_arm_1_3;
    const double M_psi_psi = column_1 + I_left_arm_yy * c_left * c_left + left_arm_1_1;
    /* frame left_arm on column */
    const double a_left_arm_z = a_left_arm_1_x * s_left + p->g * c_left;
    const double n_left_arm_y = -I_left_arm_yy * omega_left_arm_x * c_left * v->psi - mc_left_arm_x * a_left_arm_z;
    /* frame forearm on right_arm */
    const double a_forearm_1_x = a_right_arm_x - p->l_u * (v->right * v->right + omega_right_arm_z * omega_right_arm_z);
    const double a_forearm_1_z = p->l_u * right_arm_1 + a_right_arm_z;
    const double a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x * s_elbow;
    const double a_forearm_x = a_forearm_1_z * s_elbow + a_forearm_1_x * c_elbow;
    const double f_forearm_z = mc_forearm_x * forearm_4 + m_forearm * a_forearm_z;
    const double n_forearm_y = -I_forearm_yy * forearm_4 - mc_forearm_x * a_forearm_z;
    const double forearm_6 = s_elbow * (m_forearm * a_forearm_x - forearm_2);
    const double forearm_1_4 = p->l_u * (f_forearm_z * c_elbow + forearm_6) - n_forearm_y;
    /* frame right_arm on column */
    const double right_arm_8 = forearm_1_4 - u->tau_r + I_right_arm_yy * right_arm_1 + mc_right_arm_x * a_right_arm_z;
    /* balance of forces */
    const double tau_psi = u->tau_psi - p->c_psi * v->psi - n_moving_column_z;
    const double tau_left = u->tau_l - p->c_s * v->left - n_left_arm_y;
    const double tau_elbow = n_forearm_y - p->c_s * v->elbow + u->tau_e;
    /* M = L^T D L and back-substitution */
    const double inv_elbow = 1.0 / I_forearm_yy;
    const double l_elbow_right = M_right_elbow * inv_elbow;
    const double pivot_right = I_right_arm_yy + I_forearm_yy + forearm_1_2 - M_right_elbow * l_elbow_right;
    const double right_ddot = (-tau_elbow * l_elbow_right - p->c_s * v->right - right_arm_8) / pivot_right;
    const double elbow_ddot = tau_elbow * inv_elbow - l_elbow_right * right_ddot;
    if (!(I_forearm_yy > 0.0)) {
        return 4;
    }
    if (!(pivot_right > 0.0)) {
        return 3;
    }
    if (!(I_left_arm_yy > 0.0)) {
        return 2;
    }
    if (!(M_psi_psi > 0.0)) {
        return 1;
    }
    a->psi = tau_psi / M_psi_psi;
    a->left = tau_left / I_left_arm_yy;
    a->right = right_ddot;
    a->elbow = elbow_ddot;
    return 0;
}

int tree_linearize(
    const struct tree_state *x,
    const struct tree_inputs *u,
    const struct tree_parameters *p,
    double dx[8],
    double a[8][8],
    double b[8][4])
{
    const struct tree_coordinates *q = &x->q;
    const struct tree_rates *v = &x->v;
    const double s_left = sin(q->left);
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_rho = p->l * p->rho;
    const double l_per_two = p->l / 2.0;
    const double l_rho_l_per_two = l_rho * l_per_two;
    const double l_m_t = p->l * p->m_t;
    /* frame left_arm on column */
    const double mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    const double I_left_arm_yy = p->rho * powi(p->l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p->l * l_m_t;
    const double omega_left_arm_z = c_left * v->psi;
    const double omega_left_arm_x = -s_left * v->psi;
    const double alpha_left_arm_x = -omega_left_arm_z * v->left;
    const double alpha_left_arm_z = omega_left_arm_x * v->left;
    const double left_arm_1 = I_left_arm_yy * alpha_left_arm_z;
    const double mc_left_arm_x_c_left = mc_left_arm_x * c_left;
    const double l_u_rho = p->l_u * p->rho;
    const double l_u_per_two = p->l_u / 2.0;
    const double l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    /* body right_tube on right_arm */
    const double right_tube_1 = p->rho * powi(p->l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two;
    const double l_u_m_e = p->l_u * p->m_e;
    /* frame right_arm on column */
    const double mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    const double I_right_arm_yy = right_tube_1 + p->l_u * l_u_m_e;
    const double omega_right_arm_z = c_right * v->psi;
    const double omega_right_arm_x = s_right * v->psi;
    const double alpha_right_arm_x = omega_right_arm_z * v->right;
    const double alpha_right_arm_z = -omega_right_arm_x * v->right;
    const double omega_right_arm_z_sq = omega_right_arm_z * omega_right_arm_z;
    const double two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    const double right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    const double right_arm_2 = I_right_arm_yy * alpha_right_arm_z;
    const double right_arm_3 = omega_right_arm_z_sq - omega_right_arm_x * omega_right_arm_x;
    const double a_right_arm_x = p->g * s_right;
    /* body fore_tube on forearm */
    const double m_forearm = p->l_f * p->rho;
    const double l_f_per_two = p->l_f / 2.0;
    const double mc_forearm_x = m_forearm * l_f_per_two;
    const double I_forearm_yy = p->rho * powi(p->l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    /* frame forearm on right_arm */
    const double omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    const double omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    const double omega_forearm_y = -v->right - v->elbow;
    const double omega_forearm_x_elbow_dot = omega_forearm_x * v->elbow;
    const double alpha_forearm_z = alpha_right_arm_z * c_elbow - omega_forearm_x_elbow_dot - alpha_right_arm_x * s_elbow;
    const double omega_forearm_z_sq = omega_forearm_z * omega_forearm_z;
    const double forearm_1 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z_sq);
    const double forearm_2 = omega_forearm_x * omega_forearm_y;
    const double forearm_3 = omega_forearm_z * omega_forearm_x;
    const double forearm_4 = omega_forearm_z * omega_forearm_y;
    const double forearm_5 = omega_forearm_z_sq - omega_forearm_x * omega_forearm_x;
    const double I_forearm_yy_forearm_2 = I_forearm_yy * forearm_2;
    const double mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    const double mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    const double M_right_elbow = I_forearm_yy + p->l_u * mc_forearm_x_c_elbow;
    const double I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    const double I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    const double forearm_6 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    /* frame left_arm on column */
    const double a_left_arm_1_x = p->a * v->psi * v->psi;
    const double left_arm_1_1 = 2.0 * left_arm_1 * c_left - 2.0 * p->a * mc_left_arm_x * alpha_left_arm_z;
    const double left_arm_1_2 = p->a * (p->a * (p->m_t + l_rho) - mc_left_arm_x_c_left - mc_left_arm_x_c_left);
    /* frame right_arm on column */
    const double a_right_arm_x_2 = -a_left_arm_1_x * c_right;
    const double a_right_arm_z = a_left_arm_1_x * s_right + p->g * c_right;
    const double right_arm_4 = 2.0 * (I_forearm_yy_c_elbow * s_elbow + p->l_u * mc_forearm_x_s_elbow);
    /* frame forearm on right_arm */
    const double a_forearm_1_y = p->l_u * two_alpha_right_arm_z;
    const double a_forearm_1_x = a_right_arm_x + a_right_arm_x_2 - p->l_u * (v->right * v->right + omega_right_arm_z_sq);
    const double a_forearm_1_z = p->l_u * right_arm_1 + a_right_arm_z;
    const double forearm_1_1 = mc_forearm_x_c_elbow + p->l_u * m_forearm;
    const double forearm_1_2 = p->l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    const double f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_2);
    const double n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy_forearm_2;
    const double a_forearm_1_x_s_elbow = a_forearm_1_x * s_elbow;
    const double a_forearm_1_x_c_elbow = a_forearm_1_x * c_elbow;
    const double a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x_s_elbow;
    const double f_forearm_x = m_forearm * (a_forearm_1_z * s_elbow + a_forearm_1_x_c_elbow) - forearm_1;
    const double f_forearm_z = mc_forearm_x * forearm_3 + m_forearm * a_forearm_z;
    const double n_forearm_y = -I_forearm_yy * forearm_3 - mc_forearm_x * a_forearm_z;
    const double f_forearm_1_z = f_forearm_z * c_elbow + f_forearm_x * s_elbow;
    const double forearm_7 = u->tau_r - I_right_arm_yy * right_arm_1 - mc_right_arm_x * a_right_arm_z;
    /* frame right_arm on column */
    const double n_moving_right_arm_z = 2.0 * right_arm_2 + n_moving_forearm_z * c_elbow + p->l_u * f_moving_forearm_y;
    const double right_arm_5 = n_moving_forearm_z * s_right * s_elbow;
    const double right_arm_6 = c_right * (mc_right_arm_x + forearm_1_1);
    const double right_arm_7 = right_arm_6 - mc_forearm_x_s_elbow * s_right;
    const double right_arm_8 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_6;
    const double right_arm_9 = right_arm_8 * c_right - right_arm_4 * s_right;
    const double right_arm_1_1 = p->a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    const double right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_5 + right_arm_1_1;
    const double right_arm_1_3 = p->a * (right_arm_7 + right_arm_7 + p->a * (p->m_e + l_u_rho + m_forearm));
    /* frame left_arm on column */
    const double a_left_arm_z = a_left_arm_1_x * s_left + p->g * c_left;
    const double a_left_arm_x = a_left_arm_1_x * c_left - p->g * s_left;
    const double n_left_arm_y = -I_left_arm_yy * omega_left_arm_z * omega_left_arm_x - mc_left_arm_x * a_left_arm_z;
    /* frame column on ground */
    const double column_1 = p->I_c + forearm_6 + right_arm_9 * c_right + right_arm_1_3;
    const double M_psi_psi = column_1 + I_left_arm_yy * c_left * c_left + left_arm_1_2;
    /* gravity */
    const double gravity_1 = c_right * c_elbow - s_right * s_elbow;
    const double s_left_left_dot = s_left * v->left;
    const double s_right_right_dot = s_right * v->right;
    /* balance of forces */
    const double tau_psi = u->tau_psi - p->c_psi * v->psi - right_arm_1_2 - left_arm_1_1;
    const double tau_left = u->tau_l - p->c_s * v->left - n_left_arm_y;
    const double tau_right = n_forearm_y - p->c_s * v->right - p->l_u * f_forearm_1_z + forearm_7;
    const double tau_elbow = n_forearm_y - p->c_s * v->elbow + u->tau_e;
    /* M = L^T D L and back-substitution */
    const double inv_elbow = 1.0 / I_forearm_yy;
    const double l_elbow_right = M_right_elbow * inv_elbow;
    const double pivot_right = I_right_arm_yy + I_forearm_yy + forearm_1_2 - M_right_elbow * l_elbow_right;
    const double inv_right = 1.0 / pivot_right;
    const double inv_left = 1.0 / I_left_arm_yy;
    const double inv_psi = 1.0 / M_psi_psi;
    const double psi_ddot = tau_psi * inv_psi;
    const double right_ddot = inv_right * (tau_right - tau_elbow * l_elbow_right);
    const double elbow_ddot = tau_elbow * inv_elbow - l_elbow_right * right_ddot;
    /* derivatives with respect to left */
    const double by_left_1 = I_left_arm_yy * (omega_left_arm_z * omega_left_arm_z - omega_left_arm_x * omega_left_arm_x);
    const double d_left_ddot_by_left = -inv_left * (by_left_1 - mc_left_arm_x * a_left_arm_x);
    const double two_omega_right_arm_z = 2.0 * omega_right_arm_z;
    const double two_omega_forearm_z = 2.0 * omega_forearm_z;
    /* derivatives with respect to right */
    const double by_right_1 = mc_forearm_x * omega_forearm_x * two_omega_forearm_z;
    const double I_forearm_yy_forearm_5 = I_forearm_yy * forearm_5;
    const double by_right_2 = a_right_arm_x_2 + a_right_arm_x;
    const double by_right_3 = a_right_arm_z + p->l_u * omega_right_arm_x * two_omega_right_arm_z;
    const double by_right_4 = I_right_arm_yy * right_arm_3 - mc_right_arm_x * by_right_2;
    const double by_right_5 = p->l_u * right_arm_3 - by_right_2;
    const double by_right_6 = by_right_5 * c_elbow - by_right_3 * s_elbow;
    const double by_right_7 = m_forearm * (by_right_3 * c_elbow + by_right_5 * s_elbow);
    const double mc_forearm_x_forearm_5 = mc_forearm_x * forearm_5;
    const double by_right_8 = I_forearm_yy_forearm_5 + mc_forearm_x * by_right_6;
    const double by_right_9 = c_elbow * (m_forearm * by_right_6 + mc_forearm_x_forearm_5);
    const double by_right_10 = p->l_u * (by_right_9 + s_elbow * (by_right_1 + by_right_7));
    const double by_right_11 = l_elbow_right * by_right_8 - by_right_4 - by_right_8 - by_right_10;
    const double d_right_ddot_by_right = inv_right * by_right_11;
    const double d_elbow_ddot_by_right = -inv_elbow * by_right_8 - l_elbow_right * d_right_ddot_by_right;
    /* derivatives with respect to psi_dot */
    const double by_psi_dot_1 = c_right * s_elbow + s_right * c_elbow;
    const double two_a_psi_dot = 2.0 * p->a * v->psi;
    const double by_psi_dot_2 = I_left_arm_yy * (omega_left_arm_z * s_left - omega_left_arm_x * c_left);
    const double two_a_psi_dot_s_right = two_a_psi_dot * s_right;
    const double by_psi_dot_3 = omega_right_arm_x * c_right + omega_right_arm_z * s_right;
    const double omega_forearm_y_by_psi_dot_1 = omega_forearm_y * by_psi_dot_1;
    const double by_psi_dot_4 = omega_forearm_x * gravity_1 + omega_forearm_z * by_psi_dot_1;
    const double by_psi_dot_5 = two_a_psi_dot * c_right + p->l_u * two_omega_right_arm_z * c_right;
    const double two_s_right_right_dot = 2.0 * s_right_right_dot;
    const double l_u_two_s_right_right_dot = p->l_u * two_s_right_right_dot;
    const double by_psi_dot_6 = two_a_psi_dot_s_right + p->l_u * by_psi_dot_3;
    const double by_psi_dot_7 = s_right_right_dot * c_elbow + s_elbow * c_right * v->right;
    const double by_psi_dot_8 = by_psi_dot_1 * v->elbow + by_psi_dot_7;
    const double by_psi_dot_9 = by_psi_dot_5 * s_elbow + by_psi_dot_6 * c_elbow;
    const double by_psi_dot_10 = m_forearm * (by_psi_dot_6 * s_elbow - by_psi_dot_5 * c_elbow);
    const double by_psi_dot_11 = m_forearm * l_u_two_s_right_right_dot + mc_forearm_x * (by_psi_dot_8 - omega_forearm_y_by_psi_dot_1);
    const double by_psi_dot_12 = I_forearm_yy * by_psi_dot_8 - I_forearm_yy * omega_forearm_y_by_psi_dot_1;
    const double by_psi_dot_13 = I_forearm_yy * by_psi_dot_4 + mc_forearm_x * by_psi_dot_9;
    const double by_psi_dot_14 = mc_forearm_x * l_u_two_s_right_right_dot + by_psi_dot_12;
    const double by_psi_dot_15 = c_elbow * (m_forearm * by_psi_dot_9 + mc_forearm_x * by_psi_dot_4);
    const double by_psi_dot_16 = s_elbow * (by_psi_dot_10 - mc_forearm_x * gravity_1 * two_omega_forearm_z);
    const double by_psi_dot_17 = by_psi_dot_13 + p->l_u * (by_psi_dot_15 + by_psi_dot_16);
    const double by_psi_dot_18 = by_psi_dot_14 * c_elbow + p->l_u * by_psi_dot_11;
    const double by_psi_dot_19 = I_right_arm_yy * by_psi_dot_3 + mc_right_arm_x * two_a_psi_dot_s_right + by_psi_dot_17;
    const double by_psi_dot_20 = c_right * (-2.0 * I_right_arm_yy * s_right_right_dot - by_psi_dot_18);
    const double by_psi_dot_21 = by_psi_dot_20 + by_psi_dot_14 * s_right * s_elbow;
    const double by_psi_dot_22 = p->a * (-mc_right_arm_x * two_s_right_right_dot - by_psi_dot_11);
    const double by_psi_dot_23 = 2.0 * I_left_arm_yy * s_left_left_dot * c_left;
    const double by_psi_dot_24 = 2.0 * p->a * mc_left_arm_x * s_left_left_dot - by_psi_dot_23;
    const double d_psi_ddot_by_psi_dot = -inv_psi * (p->c_psi + by_psi_dot_21 + by_psi_dot_22 + by_psi_dot_24);
    const double d_left_ddot_by_psi_dot = -inv_left * (by_psi_dot_2 - mc_left_arm_x * two_a_psi_dot * s_left);
    const double d_right_ddot_by_psi_dot = inv_right * (l_elbow_right * by_psi_dot_13 - by_psi_dot_19);
    const double d_elbow_ddot_by_psi_dot = -inv_elbow * by_psi_dot_13 - l_elbow_right * d_right_ddot_by_psi_dot;
    /* derivatives with respect to left_dot */
    const double by_left_dot_1 = 2.0 * I_left_arm_yy * omega_left_arm_x * c_left;
    const double d_psi_ddot_by_left_dot = -inv_psi * (by_left_dot_1 - 2.0 * p->a * mc_left_arm_x * omega_left_arm_x);
    const double two_l_u_right_dot = 2.0 * p->l_u * v->right;
    /* derivatives with respect to right_dot */
    const double by_right_dot_1 = 2.0 * mc_forearm_x * omega_forearm_y;
    const double two_l_u_right_dot_s_elbow = two_l_u_right_dot * s_elbow;
    const double two_omega_right_arm_x = 2.0 * omega_right_arm_x;
    const double l_u_two_omega_right_arm_x = p->l_u * two_omega_right_arm_x;
    const double by_right_dot_2 = 2.0 * mc_forearm_x * omega_forearm_x;
    const double by_right_dot_3 = m_forearm * l_u_two_omega_right_arm_x + by_right_dot_2;
    const double by_right_dot_4 = mc_forearm_x * two_l_u_right_dot_s_elbow;
    const double by_right_dot_5 = 2.0 * I_forearm_yy * omega_forearm_x;
    const double by_right_dot_6 = mc_forearm_x * l_u_two_omega_right_arm_x + by_right_dot_5;
    const double by_right_dot_7 = s_elbow * (m_forearm * two_l_u_right_dot * c_elbow - by_right_dot_1);
    const double by_right_dot_8 = p->l_u * (m_forearm * two_l_u_right_dot_s_elbow * c_elbow - by_right_dot_7);
    const double by_right_dot_9 = by_right_dot_6 * c_elbow + p->l_u * by_right_dot_3;
    const double by_right_dot_10 = c_right * (-2.0 * I_right_arm_yy * omega_right_arm_x - by_right_dot_9);
    const double by_right_dot_11 = by_right_dot_10 + by_right_dot_6 * s_right * s_elbow;
    const double by_right_dot_12 = p->a * (-mc_right_arm_x * two_omega_right_arm_x - by_right_dot_3);
    const double d_right_ddot_by_right_dot = inv_right * (l_elbow_right * by_right_dot_4 - p->c_s - by_right_dot_4 - by_right_dot_8);
    const double d_elbow_ddot_by_right_dot = -inv_elbow * by_right_dot_4 - l_elbow_right * d_right_ddot_by_right_dot;
    /* derivatives with respect to elbow_dot */
    const double by_elbow_dot_1 = c_right * (-by_right_dot_5 * c_elbow - p->l_u * by_right_dot_2);
    const double by_elbow_dot_2 = by_elbow_dot_1 + by_right_dot_5 * s_right * s_elbow;
    const double d_psi_ddot_by_elbow_dot = -inv_psi * (by_elbow_dot_2 - p->a * by_right_dot_2);
    const double d_right_ddot_by_elbow_dot = inv_right * (p->c_s * l_elbow_right - p->l_u * by_right_dot_1 * s_elbow);
    const double d_elbow_ddot_by_elbow_dot = -p->c_s * inv_elbow - l_elbow_right * d_right_ddot_by_elbow_dot;
    const double a_psi_ddot = p->a * psi_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = psi_ddot * s_left - alpha_left_arm_x;
    const double slopes_2 = I_left_arm_yy * (-alpha_left_arm_z - psi_ddot * c_left) - left_arm_1;
    const double slopes_3 = alpha_right_arm_x + psi_ddot * s_right;
    const double slopes_4 = alpha_right_arm_z + psi_ddot * c_right;
    const double slopes_5 = mc_right_arm_x * a_psi_ddot + right_arm_2 + I_right_arm_yy * slopes_4;
    const double slopes_6 = p->l_u * (-alpha_right_arm_z - slopes_4) - a_psi_ddot;
    const double slopes_7 = a_right_arm_z + p->l_u * (right_arm_1 + right_ddot);
    const double slopes_8 = slopes_3 * s_elbow - slopes_4 * c_elbow;
    const double slopes_9 = slopes_3 * c_elbow + slopes_4 * s_elbow;
    const double slopes_10 = omega_forearm_z * v->elbow + slopes_9;
    const double slopes_11 = omega_forearm_x_elbow_dot + slopes_8;
    const double slopes_12 = a_forearm_1_x_c_elbow + slopes_7 * s_elbow;
    const double m_forearm_slopes_12 = m_forearm * slopes_12;
    const double slopes_13 = m_forearm * (slopes_7 * c_elbow - a_forearm_1_x_s_elbow);
    const double slopes_14 = slopes_13 + mc_forearm_x * (forearm_3 + right_ddot + elbow_ddot);
    const double slopes_15 = mc_forearm_x * slopes_6 - I_forearm_yy_forearm_2 + I_forearm_yy * slopes_11;
    const double slopes_15_c_elbow = slopes_15 * c_elbow;
    const double slopes_15_s_elbow = slopes_15 * s_elbow;
    const double slopes_16 = p->l_u * (m_forearm * slopes_6 + mc_forearm_x * (slopes_11 - forearm_2));
    const double slopes_17 = s_right * (slopes_15_c_elbow - slopes_5 + slopes_16);
    const double slopes_18 = s_left * (mc_left_arm_x * a_psi_ddot + slopes_2);
    const double slopes_19 = c_left * (I_left_arm_yy * slopes_1 - I_left_arm_yy * alpha_left_arm_x);
    const double slopes_20 = p->a * mc_left_arm_x * (slopes_1 - alpha_left_arm_x);
    const double slopes_21 = alpha_right_arm_x + slopes_3;
    const double l_u_slopes_21 = p->l_u * slopes_21;
    const double slopes_22 = mc_forearm_x * (slopes_10 - forearm_4);
    const double slopes_23 = m_forearm * l_u_slopes_21 + slopes_22;
    const double slopes_24 = I_forearm_yy * slopes_10 - I_forearm_yy * forearm_4;
    const double slopes_25 = mc_forearm_x * l_u_slopes_21 + slopes_24;
    const double slopes_26 = slopes_25 * c_elbow + p->l_u * slopes_23;
    const double slopes_27 = I_right_arm_yy * alpha_right_arm_x + I_right_arm_yy * slopes_3 + slopes_26;
    const double slopes_25_s_right_s_elbow = slopes_25 * s_right * s_elbow;
    const double slopes_28 = slopes_15_s_elbow * c_right + slopes_25_s_right_s_elbow;
    const double slopes_29 = slopes_27 * c_right - slopes_17 - slopes_28;
    const double slopes_30 = p->a * (mc_right_arm_x * slopes_21 + slopes_23);
    const double mc_forearm_x_slopes_12 = mc_forearm_x * slopes_12;
    const double slopes_31 = c_elbow * (mc_forearm_x_forearm_5 - m_forearm_slopes_12);
    const double slopes_32 = s_elbow * (by_right_1 + slopes_13);
    const double slopes_33 = c_elbow * (m_forearm_slopes_12 - forearm_1) + slopes_32;
    const double slopes_34 = p->l_u * (slopes_31 - slopes_14 * s_elbow + slopes_33);
    const double slopes_35 = slopes_24 * c_elbow - slopes_15_s_elbow + p->l_u * slopes_22;
    const double slopes_36 = s_right * (slopes_15_c_elbow + slopes_24 * s_elbow);
    const double slopes_37 = slopes_35 * c_right - slopes_36 + p->a * slopes_22;
    /* derivatives with respect to left */
    const double d_psi_ddot_by_left = inv_psi * (slopes_19 - slopes_18 - slopes_20);
    /* derivatives with respect to elbow */
    const double by_elbow_1 = mc_forearm_x_slopes_12 - I_forearm_yy_forearm_5;
    const double by_elbow_2 = I_forearm_yy_forearm_5 - mc_forearm_x_slopes_12 + slopes_34 + l_elbow_right * by_elbow_1;
    const double d_right_ddot_by_elbow = -inv_right * by_elbow_2;
    const double d_elbow_ddot_by_elbow = inv_elbow * by_elbow_1 - l_elbow_right * d_right_ddot_by_elbow;
    /* derivatives with respect to tau_r */
    const double d_elbow_ddot_by_tau_r = -l_elbow_right * inv_right;
    if (!(I_forearm_yy > 0.0)) {
        return 4;
    }
    if (!(pivot_right > 0.0)) {
        return 3;
    }
    if (!(I_left_arm_yy > 0.0)) {
        return 2;
    }
    if (!(M_psi_psi > 0.0)) {
        return 1;
    }
    dx[0] = v->psi; /* psi' */
    dx[1] = v->left; /* left' */
    dx[2] = v->right; /* right' */
    dx[3] = v->elbow; /* elbow' */
    dx[4] = psi_ddot; /* psi'' */
    dx[5] = tau_left * inv_left; /* left'' */
    dx[6] = right_ddot; /* right'' */
    dx[7] = elbow_ddot; /* elbow'' */
    for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 8; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][4] = 1.0; /* psi' */
    a[1][5] = 1.0; /* left' */
    a[2][6] = 1.0; /* right' */
    a[3][7] = 1.0; /* elbow' */
    a[4][1] = d_psi_ddot_by_left; /* psi'' */
    a[4][2] = inv_psi * (slopes_29 + slopes_30);
    a[4][3] = inv_psi * slopes_37;
    a[4][4] = d_psi_ddot_by_psi_dot;
    a[4][5] = d_psi_ddot_by_left_dot;
    a[4][6] = -inv_psi * (by_right_dot_11 + by_right_dot_12);
    a[4][7] = d_psi_ddot_by_elbow_dot;
    a[5][1] = d_left_ddot_by_left; /* left'' */
    a[5][4] = d_left_ddot_by_psi_dot;
    a[5][5] = -p->c_s * inv_left;
    a[6][2] = d_right_ddot_by_right; /* right'' */
    a[6][3] = d_right_ddot_by_elbow;
    a[6][4] = d_right_ddot_by_psi_dot;
    a[6][6] = d_right_ddot_by_right_dot;
    a[6][7] = d_right_ddot_by_elbow_dot;
    a[7][2] = d_elbow_ddot_by_right; /* elbow'' */
    a[7][3] = d_elbow_ddot_by_elbow;
    a[7][4] = d_elbow_ddot_by_psi_dot;
    a[7][6] = d_elbow_ddot_by_right_dot;
    a[7][7] = d_elbow_ddot_by_elbow_dot;
    for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 4; j++) {
            b[i][j] = 0.0;
        }
    }
    b[4][0] = inv_psi; /* psi'' */
    b[5][1] = inv_left; /* left'' */
    b[6][2] = inv_right; /* right'' */
    b[6][3] = d_elbow_ddot_by_tau_r;
    b[7][2] = d_elbow_ddot_by_tau_r; /* elbow'' */
    b[7][3] = inv_elbow - l_elbow_right * d_elbow_ddot_by_tau_r;
    return 0;
}

int tree_parameter_jacobian(const struct tree_state *x, const struct tree_inputs *u, const struct tree_parameters *p, double by_p[8][11])
{
    const struct tree_coordinates *q = &x->q;
    const struct tree_rates *v = &x->v;
    const double s_left = sin(q->left);
    const double c_left = cos(q->left);
    const double s_right = sin(q->right);
    const double c_right = cos(q->right);
    const double s_elbow = sin(q->elbow);
    const double c_elbow = cos(q->elbow);
    const double l_rho = p->l * p->rho;
    const double l_per_two = p->l / 2.0;
    const double l_pow3 = powi(p->l, 3);
    const double l_rho_l_per_two = l_rho * l_per_two;
    /* body left_tube on left_arm */
    const double left_tube_1 = p->rho * l_pow3 / 12.0 + l_per_two * l_rho_l_per_two;
    const double l_m_t = p->l * p->m_t;
    /* frame left_arm on column */
    const double m_left_arm = p->m_t + l_rho;
    const double mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    const double I_left_arm_yy = left_tube_1 + p->l * l_m_t;
    const double omega_left_arm_x = -s_left * v->psi;
    const double alpha_left_arm_z = omega_left_arm_x * v->left;
    const double left_arm_1 = omega_left_arm_x * c_left * v->psi;
    const double n_moving_left_arm_1_z = 2.0 * I_left_arm_yy * alpha_left_arm_z * c_left;
    const double mc_left_arm_x_c_left = mc_left_arm_x * c_left;
    const double l_u_rho = p->l_u * p->rho;
    const double l_u_per_two = p->l_u / 2.0;
    const double l_u_pow3 = powi(p->l_u, 3);
    const double l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    /* body right_tube on right_arm */
    const double right_tube_1 = p->rho * l_u_pow3 / 12.0 + l_u_per_two * l_u_rho_l_u_per_two;
    const double l_u_m_e = p->l_u * p->m_e;
    /* frame right_arm on column */
    const double m_right_arm = p->m_e + l_u_rho;
    const double mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    const double I_right_arm_yy = right_tube_1 + p->l_u * l_u_m_e;
    const double omega_right_arm_z = c_right * v->psi;
    const double omega_right_arm_x = s_right * v->psi;
    const double alpha_right_arm_x = omega_right_arm_z * v->right;
    const double alpha_right_arm_z = -omega_right_arm_x * v->right;
    const double right_arm_1 = v->right * v->right + omega_right_arm_z * omega_right_arm_z;
    const double two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    const double right_arm_2 = omega_right_arm_z * omega_right_arm_x;
    /* body fore_tube on forearm */
    const double m_forearm = p->l_f * p->rho;
    const double l_f_per_two = p->l_f / 2.0;
    const double l_f_pow3 = powi(p->l_f, 3);
    const double mc_forearm_x = m_forearm * l_f_per_two;
    const double I_forearm_yy = p->rho * l_f_pow3 / 12.0 + l_f_per_two * mc_forearm_x;
    /* frame forearm on right_arm */
    const double omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    const double omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    const double omega_forearm_y = -v->right - v->elbow;
    const double omega_forearm_x_elbow_dot = omega_forearm_x * v->elbow;
    const double alpha_forearm_z = alpha_right_arm_z * c_elbow - omega_forearm_x_elbow_dot - alpha_right_arm_x * s_elbow;
    const double forearm_1 = omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z;
    const double mc_forearm_x_forearm_1 = mc_forearm_x * forearm_1;
    const double forearm_2 = omega_forearm_x * omega_forearm_y;
    const double forearm_3 = omega_forearm_z * omega_forearm_x;
    const double mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    const double mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    const double M_right_elbow = I_forearm_yy + p->l_u * mc_forearm_x_c_elbow;
    const double I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    const double I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    const double forearm_4 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    const double psi_dot_sq = v->psi * v->psi;
    /* frame left_arm on column */
    const double a_left_arm_1_x = p->a * psi_dot_sq;
    const double left_arm_1_1 = p->a * (p->a * m_left_arm - mc_left_arm_x_c_left - mc_left_arm_x_c_left);
    /* frame forearm on right_arm */
    const double a_forearm_1_y = p->l_u * two_alpha_right_arm_z;
    const double forearm_1_1 = mc_forearm_x_c_elbow + p->l_u * m_forearm;
    const double forearm_1_2 = p->l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    const double f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_2);
    const double n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_2;
    const double forearm_1_3 = n_moving_forearm_z * c_elbow + p->l_u * f_moving_forearm_y;
    /* frame right_arm on column */
    const double n_moving_right_arm_z = 2.0 * I_right_arm_yy * alpha_right_arm_z + forearm_1_3;
    const double right_arm_3 = n_moving_forearm_z * s_right * s_elbow;
    const double a_right_arm_z = a_left_arm_1_x * s_right + p->g * c_right;
    const double a_right_arm_x = p->g * s_right - a_left_arm_1_x * c_right;
    const double right_arm_4 = c_right * (mc_right_arm_x + forearm_1_1);
    const double right_arm_5 = right_arm_4 - mc_forearm_x_s_elbow * s_right;
    const double right_arm_6 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_4;
    const double right_arm_7 = 2.0 * (I_forearm_yy_c_elbow * s_elbow + p->l_u * mc_forearm_x_s_elbow);
    const double right_arm_8 = right_arm_6 * c_right - right_arm_7 * s_right;
    const double right_arm_1_1 = p->a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    const double right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_3 + right_arm_1_1;
    const double right_arm_1_3 = p->a * (right_arm_5 + right_arm_5 + p->a * (m_right_arm + m_forearm));
    /* frame column on ground */
    const double n_moving_column_z = right_arm_1_2 + n_moving_left_arm_1_z - 2.0 * p->a * mc_left_arm_x * alpha_left_arm_z;
    const double column_1 = p->I_c + forearm_4 + right_arm_8 * c_right + right_arm_1_3;
    const double M_psi_psi = column_1 + I_left_arm_yy * c_left * c_left + left_arm_1_1;
    /* frame left_arm on column */
    const double a_left_arm_z = a_left_arm_1_x * s_left + p->g * c_left;
    const double n_left_arm_y = -I_left_arm_yy * left_arm_1 - mc_left_arm_x * a_left_arm_z;
    /* frame forearm on right_arm */
    const double a_forearm_1_x = a_right_arm_x - p->l_u * right_arm_1;
    const double a_forearm_1_z = p->l_u * right_arm_2 + a_right_arm_z;
    const double a_forearm_1_x_s_elbow = a_forearm_1_x * s_elbow;
    const double a_forearm_1_x_c_elbow = a_forearm_1_x * c_elbow;
    const double a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x_s_elbow;
    const double f_forearm_x = m_forearm * (a_forearm_1_z * s_elbow + a_forearm_1_x_c_elbow) - mc_forearm_x_forearm_1;
    const double f_forearm_z = mc_forearm_x * forearm_3 + m_forearm * a_forearm_z;
    const double n_forearm_y = -I_forearm_yy * forearm_3 - mc_forearm_x * a_forearm_z;
    const double f_forearm_1_z = f_forearm_z * c_elbow + f_forearm_x * s_elbow;
    const double forearm_5 = u->tau_r - I_right_arm_yy * right_arm_2 - mc_right_arm_x * a_right_arm_z;
    /* gravity */
    const double gravity_1 = c_right * c_elbow - s_right * s_elbow;
    /* balance of forces */
    const double tau_psi = u->tau_psi - p->c_psi * v->psi - n_moving_column_z;
    const double tau_left = u->tau_l - p->c_s * v->left - n_left_arm_y;
    const double tau_right = n_forearm_y - p->c_s * v->right - p->l_u * f_forearm_1_z + forearm_5;
    const double tau_elbow = n_forearm_y - p->c_s * v->elbow + u->tau_e;
    /* M = L^T D L and back-substitution */
    const double inv_elbow = 1.0 / I_forearm_yy;
    const double l_elbow_right = M_right_elbow * inv_elbow;
    const double pivot_right = I_right_arm_yy + I_forearm_yy + forearm_1_2 - M_right_elbow * l_elbow_right;
    const double inv_right = 1.0 / pivot_right;
    const double inv_left = 1.0 / I_left_arm_yy;
    const double inv_psi = 1.0 / M_psi_psi;
    const double psi_ddot = tau_psi * inv_psi;
    const double left_ddot = tau_left * inv_left;
    const double right_ddot = inv_right * (tau_right - tau_elbow * l_elbow_right);
    const double elbow_ddot = tau_elbow * inv_elbow - l_elbow_right * right_ddot;
    const double right_ddot_plus_elbow_ddot = right_ddot + elbow_ddot;
    const double a_psi_ddot = p->a * psi_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = alpha_left_arm_z + psi_ddot * c_left;
    const double slopes_2 = alpha_right_arm_z + psi_ddot * c_right;
    const double slopes_3 = alpha_right_arm_z + slopes_2;
    const double right_arm_2_plus_right_ddot = right_arm_2 + right_ddot;
    const double a_psi_ddot_plus_l_u_slopes_3 = a_psi_ddot + p->l_u * slopes_3;
    const double slopes_4 = a_right_arm_z + p->l_u * right_arm_2_plus_right_ddot;
    const double slopes_5 = s_elbow * (alpha_right_arm_x + psi_ddot * s_right);
    const double slopes_6 = omega_forearm_x_elbow_dot - slopes_2 * c_elbow + slopes_5;
    const double slopes_7 = slopes_4 * c_elbow - a_forearm_1_x_s_elbow;
    const double slopes_8 = a_forearm_1_x_c_elbow + slopes_4 * s_elbow;
    const double slopes_6_minus_forearm_2 = slopes_6 - forearm_2;
    const double slopes_9 = forearm_3 + right_ddot_plus_elbow_ddot;
    const double slopes_10 = mc_forearm_x * slopes_6_minus_forearm_2 - m_forearm * a_psi_ddot_plus_l_u_slopes_3;
    const double slopes_11 = alpha_left_arm_z + slopes_1;
    const double slopes_12 = c_elbow * (m_forearm * slopes_7 + mc_forearm_x * slopes_9);
    const double slopes_13 = slopes_12 + s_elbow * (m_forearm * slopes_8 - mc_forearm_x_forearm_1);
    const double slopes_14 = slopes_10 - m_right_arm * a_psi_ddot - mc_right_arm_x * slopes_3;
    const double m_forearm_psi_ddot = m_forearm * psi_ddot;
    const double mc_forearm_x_psi_ddot = mc_forearm_x * psi_ddot;
    const double slopes_15 = mc_right_arm_x * psi_ddot + mc_forearm_x_psi_ddot * c_elbow + p->l_u * m_forearm_psi_ddot;
    const double slopes_16 = mc_forearm_x_psi_ddot * s_right * s_elbow;
    const double slopes_17 = slopes_15 * c_right - slopes_16;
    const double slopes_18 = p->a * (-m_right_arm * psi_ddot - m_forearm_psi_ddot);
    const double slopes_19 = mc_left_arm_x * slopes_11 - m_left_arm * a_psi_ddot - p->a * m_left_arm * psi_ddot;
    const double slopes_20 = mc_left_arm_x * psi_ddot * c_left + slopes_19;
    const double rho_a_psi_ddot = p->rho * a_psi_ddot;
    const double slopes_21 = right_arm_1 * s_elbow + right_arm_2_plus_right_ddot * c_elbow;
    const double slopes_22 = m_forearm * (right_arm_2_plus_right_ddot * s_elbow - right_arm_1 * c_elbow);
    const double m_forearm_slopes_3 = m_forearm * slopes_3;
    const double mc_forearm_x_slopes_21 = mc_forearm_x * slopes_21;
    const double mc_forearm_x_slopes_3 = mc_forearm_x * slopes_3;
    const double slopes_23 = m_forearm * slopes_21 * c_elbow + slopes_22 * s_elbow;
    const double slopes_24 = mc_forearm_x_slopes_21 + slopes_13 + p->l_u * slopes_23;
    const double slopes_25 = slopes_10 - mc_forearm_x_slopes_3 * c_elbow - p->l_u * m_forearm_slopes_3;
    const double slopes_26 = mc_forearm_x_slopes_3 * s_right * s_elbow;
    const double l_a_psi_ddot = p->l * a_psi_ddot;
    const double l_u_a_psi_ddot = p->l_u * a_psi_ddot;
    const double psi_dot_sq_s_right = psi_dot_sq * s_right;
    const double psi_dot_sq_c_right = psi_dot_sq * c_right;
    /* derivatives with respect to a */
    const double by_a_1 = psi_dot_sq_c_right * s_elbow + psi_dot_sq_s_right * c_elbow;
    const double by_a_2 = m_forearm * (psi_dot_sq_s_right * s_elbow - psi_dot_sq_c_right * c_elbow);
    const double mc_forearm_x_by_a_1 = mc_forearm_x * by_a_1;
    const double by_a_3 = m_forearm * by_a_1 * c_elbow + by_a_2 * s_elbow;
    const double by_a_4 = mc_right_arm_x * psi_dot_sq_s_right + mc_forearm_x_by_a_1 + p->l_u * by_a_3;
    const double d_psi_ddot_by_a = inv_psi * (slopes_20 - slopes_17 + slopes_14 + slopes_18);
    const double d_left_ddot_by_a = inv_left * mc_left_arm_x * psi_dot_sq * s_left;
    const double d_right_ddot_by_a = inv_right * (l_elbow_right * mc_forearm_x_by_a_1 - by_a_4);
    const double d_elbow_ddot_by_a = -inv_elbow * mc_forearm_x_by_a_1 - l_elbow_right * d_right_ddot_by_a;
    const double l_sq = p->l * p->l;
    /* derivatives with respect to l */
    const double by_l_1 = p->rho * l_per_two + 0.5 * l_rho;
    const double by_l_2 = 0.5 * l_rho_l_per_two + l_per_two * by_l_1;
    const double m_t_plus_by_l_1 = p->m_t + by_l_1;
    const double by_l_3 = 3.0 * p->rho * l_sq / 12.0 + by_l_2 + 2.0 * l_m_t;
    const double l_u_sq = p->l_u * p->l_u;
    /* derivatives with respect to l_u */
    const double by_l_u_1 = p->rho * l_u_per_two + 0.5 * l_u_rho;
    const double by_l_u_2 = 0.5 * l_u_rho_l_u_per_two + l_u_per_two * by_l_u_1;
    const double m_e_plus_by_l_u_1 = p->m_e + by_l_u_1;
    const double by_l_u_3 = 3.0 * p->rho * l_u_sq / 12.0 + by_l_u_2 + 2.0 * l_u_m_e;
    /* derivatives with respect to l_f */
    const double by_l_f_1 = p->rho * l_f_per_two + 0.5 * m_forearm;
    const double by_l_f_2 = 3.0 * p->l_f * p->l_f * p->rho / 12.0 + 0.5 * mc_forearm_x + l_f_per_two * by_l_f_1;
    const double l_l_per_two = p->l * l_per_two;
    /* derivatives with respect to rho */
    const double by_rho_1 = l_pow3 / 12.0 + l_per_two * l_l_per_two;
    const double l_u_l_u_per_two = p->l_u * l_u_per_two;
    const double by_rho_2 = l_u_pow3 / 12.0 + l_u_per_two * l_u_l_u_per_two;
    const double l_f_l_f_per_two = p->l_f * l_f_per_two;
    const double by_rho_3 = l_f_pow3 / 12.0 + l_f_per_two * l_f_l_f_per_two;
    /* derivatives with respect to g */
    const double by_g_1 = m_forearm * (c_right * s_elbow + s_right * c_elbow);
    const double mc_forearm_x_gravity_1 = mc_forearm_x * gravity_1;
    const double by_g_2 = m_forearm * gravity_1 * c_elbow + by_g_1 * s_elbow;
    const double by_g_3 = mc_right_arm_x * c_right + mc_forearm_x_gravity_1 + p->l_u * by_g_2;
    const double d_right_ddot_by_g = inv_right * (l_elbow_right * mc_forearm_x_gravity_1 - by_g_3);
    const double d_elbow_ddot_by_g = -inv_elbow * mc_forearm_x_gravity_1 - l_elbow_right * d_right_ddot_by_g;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_27 = left_ddot * by_l_3 - left_arm_1 * by_l_3;
    const double slopes_28 = alpha_left_arm_z * by_l_3 + slopes_1 * by_l_3;
    const double slopes_29 = c_left * (-a_psi_ddot * m_t_plus_by_l_1 - slopes_28);
    const double slopes_30 = slopes_29 + p->a * (-rho_a_psi_ddot - m_t_plus_by_l_1 * slopes_11);
    const double slopes_31 = right_arm_2 * by_l_u_3 + right_ddot * by_l_u_3;
    const double slopes_32 = alpha_right_arm_z * by_l_u_3 + slopes_2 * by_l_u_3;
    const double slopes_33 = slopes_25 - a_psi_ddot * m_e_plus_by_l_u_1 - slopes_32;
    const double slopes_34 = a_right_arm_z * m_e_plus_by_l_u_1 + slopes_31 + slopes_24;
    const double slopes_35 = p->a * (-rho_a_psi_ddot - slopes_3 * m_e_plus_by_l_u_1 - m_forearm_slopes_3);
    const double slopes_36 = slopes_6_minus_forearm_2 * by_l_f_1 - p->rho * a_psi_ddot_plus_l_u_slopes_3;
    const double slopes_37 = forearm_3 * by_l_f_2 + right_ddot_plus_elbow_ddot * by_l_f_2;
    const double slopes_38 = slopes_6 * by_l_f_2 - forearm_2 * by_l_f_2;
    const double slopes_39 = slopes_7 * by_l_f_1 + slopes_37;
    const double slopes_40 = slopes_38 - a_psi_ddot_plus_l_u_slopes_3 * by_l_f_1;
    const double slopes_41 = c_elbow * (p->rho * slopes_7 + slopes_9 * by_l_f_1);
    const double slopes_42 = s_elbow * (p->rho * slopes_8 - forearm_1 * by_l_f_1);
    const double slopes_43 = slopes_39 + p->l_u * (slopes_41 + slopes_42);
    const double slopes_44 = c_right * (slopes_40 * c_elbow + p->l_u * slopes_36);
    const double slopes_45 = slopes_40 * s_right * s_elbow - slopes_44;
    const double slopes_46 = left_ddot * by_rho_1 - left_arm_1 * by_rho_1;
    const double slopes_47 = alpha_left_arm_z * by_rho_1 + slopes_1 * by_rho_1;
    const double slopes_48 = right_arm_2 * by_rho_2 + right_ddot * by_rho_2;
    const double slopes_49 = alpha_right_arm_z * by_rho_2 + slopes_2 * by_rho_2;
    const double slopes_50 = slopes_6_minus_forearm_2 * l_f_l_f_per_two - p->l_f * a_psi_ddot_plus_l_u_slopes_3;
    const double slopes_51 = forearm_3 * by_rho_3 + right_ddot_plus_elbow_ddot * by_rho_3;
    const double slopes_52 = slopes_6 * by_rho_3 - forearm_2 * by_rho_3;
    const double slopes_53 = slopes_7 * l_f_l_f_per_two + slopes_51;
    const double slopes_54 = slopes_52 - a_psi_ddot_plus_l_u_slopes_3 * l_f_l_f_per_two;
    const double slopes_55 = c_elbow * (p->l_f * slopes_7 + slopes_9 * l_f_l_f_per_two);
    const double slopes_56 = s_elbow * (p->l_f * slopes_8 - forearm_1 * l_f_l_f_per_two);
    const double slopes_57 = slopes_53 + p->l_u * (slopes_55 + slopes_56);
    const double slopes_58 = slopes_54 * c_elbow + p->l_u * slopes_50;
    const double slopes_59 = slopes_58 - a_psi_ddot * l_u_l_u_per_two - slopes_49;
    const double slopes_60 = a_right_arm_z * l_u_l_u_per_two + slopes_48 + slopes_57;
    const double slopes_54_s_right_s_elbow = slopes_54 * s_right * s_elbow;
    const double slopes_61 = p->a * (slopes_50 - l_u_a_psi_ddot - slopes_3 * l_u_l_u_per_two);
    const double slopes_62 = slopes_54_s_right_s_elbow - slopes_59 * c_right - slopes_61;
    const double slopes_63 = c_left * (-a_psi_ddot * l_l_per_two - slopes_47);
    const double slopes_64 = slopes_63 + p->a * (-l_a_psi_ddot - l_l_per_two * slopes_11);
    const double slopes_65 = alpha_right_arm_z * l_u_sq + slopes_2 * l_u_sq;
    const double slopes_66 = p->l_u * a_right_arm_z + right_arm_2 * l_u_sq + right_ddot * l_u_sq;
    const double slopes_67 = c_right * (-l_u_a_psi_ddot - slopes_65) - p->a * a_psi_ddot_plus_l_u_slopes_3;
    const double slopes_68 = alpha_left_arm_z * l_sq + slopes_1 * l_sq;
    const double slopes_69 = p->l * a_left_arm_z - left_arm_1 * l_sq + left_ddot * l_sq;
    const double slopes_70 = c_left * (-l_a_psi_ddot - slopes_68);
    /* derivatives with respect to l */
    const double d_left_ddot_by_l = -inv_left * (a_left_arm_z * m_t_plus_by_l_1 + slopes_27);
    /* derivatives with respect to l_u */
    const double d_psi_ddot_by_l_u = inv_psi * (slopes_35 + slopes_26 + slopes_33 * c_right);
    const double d_right_ddot_by_l_u = inv_right * (l_elbow_right * mc_forearm_x_slopes_21 - slopes_34);
    const double d_elbow_ddot_by_l_u = -inv_elbow * mc_forearm_x_slopes_21 - l_elbow_right * d_right_ddot_by_l_u;
    /* derivatives with respect to l_f */
    const double d_psi_ddot_by_l_f = inv_psi * (p->a * slopes_36 - slopes_45);
    const double d_right_ddot_by_l_f = inv_right * (l_elbow_right * slopes_39 - slopes_43);
    const double d_elbow_ddot_by_l_f = -inv_elbow * slopes_39 - l_elbow_right * d_right_ddot_by_l_f;
    /* derivatives with respect to rho */
    const double d_left_ddot_by_rho = -inv_left * (a_left_arm_z * l_l_per_two + slopes_46);
    const double d_right_ddot_by_rho = inv_right * (l_elbow_right * slopes_53 - slopes_60);
    const double d_elbow_ddot_by_rho = -inv_elbow * slopes_53 - l_elbow_right * d_right_ddot_by_rho;
    /* derivatives with respect to m_e */
    const double d_right_ddot_by_m_e = -inv_right * slopes_66;
    /* derivatives with respect to m_t */
    const double d_psi_ddot_by_m_t = inv_psi * (slopes_70 + p->a * (-a_psi_ddot - p->l * slopes_11));
    /* derivatives with respect to c_s */
    const double d_right_ddot_by_c_s = inv_right * (l_elbow_right * v->elbow - v->right);
    const double d_elbow_ddot_by_c_s = -inv_elbow * v->elbow - l_elbow_right * d_right_ddot_by_c_s;
    if (!(I_forearm_yy > 0.0)) {
        return 4;
    }
    if (!(pivot_right > 0.0)) {
        return 3;
    }
    if (!(I_left_arm_yy > 0.0)) {
        return 2;
    }
    if (!(M_psi_psi > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 11; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[4][0] = -inv_psi * psi_ddot; /* psi'' */
    by_p[4][1] = d_psi_ddot_by_a;
    by_p[4][2] = inv_psi * slopes_30;
    by_p[4][3] = d_psi_ddot_by_l_u;
    by_p[4][4] = d_psi_ddot_by_l_f;
    by_p[4][5] = inv_psi * (slopes_64 - slopes_62);
    by_p[4][6] = inv_psi * slopes_67;
    by_p[4][7] = d_psi_ddot_by_m_t;
    by_p[4][8] = -inv_psi * v->psi;
    by_p[5][1] = d_left_ddot_by_a; /* left'' */
    by_p[5][2] = d_left_ddot_by_l;
    by_p[5][5] = d_left_ddot_by_rho;
    by_p[5][7] = -inv_left * slopes_69;
    by_p[5][9] = -inv_left * v->left;
    by_p[5][10] = mc_left_arm_x_c_left * inv_left;
    by_p[6][1] = d_right_ddot_by_a; /* right'' */
    by_p[6][3] = d_right_ddot_by_l_u;
    by_p[6][4] = d_right_ddot_by_l_f;
    by_p[6][5] = d_right_ddot_by_rho;
    by_p[6][6] = d_right_ddot_by_m_e;
    by_p[6][9] = d_right_ddot_by_c_s;
    by_p[6][10] = d_right_ddot_by_g;
    by_p[7][1] = d_elbow_ddot_by_a; /* elbow'' */
    by_p[7][3] = d_elbow_ddot_by_l_u;
    by_p[7][4] = d_elbow_ddot_by_l_f;
    by_p[7][5] = d_elbow_ddot_by_rho;
    by_p[7][6] = -l_elbow_right * d_right_ddot_by_m_e;
    by_p[7][9] = d_elbow_ddot_by_c_s;
    by_p[7][10] = d_elbow_ddot_by_g;
    return 0;
}

void tree_output_jacobian(const struct tree_state *x, const struct tree_parameters *p, double by_x[4][8], double by_p[4][11])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 8; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* psi */
    by_x[1][1] = 1.0; /* left */
    by_x[2][2] = 1.0; /* right */
    by_x[3][3] = 1.0; /* elbow */
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 11; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

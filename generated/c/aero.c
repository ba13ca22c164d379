/*
 * Quanser Aero, two degrees of freedom.
 * Generated from `aero.rig` (model dcde74f4); edit the rig, not this file.
 *
 * A beam with two rotors at its ends on a yoke that turns: the main rotor lifts, the tail rotor pushes
 * sideways, and each turns the beam by its drag too. Speeds follow the voltages. Geometry, masses and
 * coefficients: extended Kalman filter of an NTNU master thesis, 2025
 * (github.com/finnferdinand/orbital-stabilization-quanser-aero); its yaw inertia leaves out
 * m_e d_x^2 (at most 0.3 %), which comes out here.
 *
 * 67 operations forward, 155 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "aero.h"

#include <math.h>

/* -1, 0 or 1 */
static double sign(double x)
{
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}

void aero_nominal(struct aero_parameters *p)
{
    p->m_pa = 0.146;
    p->m_e = 0.2;
    p->m_rod = 0.458;
    p->m_y = 0.526;
    p->d_t = 0.158;
    p->d_x = 0.016;
    p->l_t = 0.165;
    p->r_y = 0.02;
    p->g = 9.81;
    p->K_omega = 17.38;
    p->K_main = 1.26e-6;
    p->K_tail = 1.26e-6;
    p->D_main = 1.08e-6;
    p->D_tail = 1.08e-6;
    p->c_pitch = 0.0031;
    p->c_yaw = 0.0075;
}

void aero_mass_matrix(const struct aero_coordinates *q, const struct aero_parameters *p, double m[2][2])
{
    const double c_pitch = cos(q->pitch);
    const double I_rod = p->m_rod * p->l_t * p->l_t / 12.0;
    const double I_y = p->m_y * p->r_y * p->r_y / 2.0;
    const double d_t_d_t_m_pa_plus_m_e = p->d_t * p->d_t * (p->m_pa + p->m_e);
    /* frame beam on yoke */
    const double I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    /* body hanging on beam */
    const double I_beam_xx = p->m_e * p->d_x * p->d_x;
    /* frame yoke on ground */
    const double M_yaw_yaw = I_y + I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            m[i][j] = 0.0;
        }
    }
    m[0][0] = M_yaw_yaw; /* yaw */
    m[1][1] = I_beam_zz + I_beam_xx; /* pitch */
}

void aero_bias(const struct aero_coordinates *q, const struct aero_rates *v, const struct aero_parameters *p, double h[2])
{
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double I_rod = p->m_rod * p->l_t * p->l_t / 12.0;
    const double d_t_d_t_m_pa_plus_m_e = p->d_t * p->d_t * (p->m_pa + p->m_e);
    /* frame beam on yoke */
    const double I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    const double omega_beam_z = c_pitch * v->yaw;
    const double omega_beam_x = s_pitch * v->yaw;
    const double n_moving_beam_z = -2.0 * I_beam_zz * omega_beam_x * v->pitch;
    /* body hanging on beam */
    const double mc_beam_z = -p->m_e * p->d_x;
    const double I_beam_xx = -p->d_x * mc_beam_z;
    /* frame beam on yoke */
    const double n_moving_beam_y = omega_beam_z * omega_beam_x * (I_beam_xx - I_beam_zz);
    const double n_moving_beam_x = 2.0 * I_beam_xx * omega_beam_z * v->pitch;
    const double n_moving_yoke_z = n_moving_beam_z * c_pitch + n_moving_beam_x * s_pitch;
    const double h_pitch = -p->g * mc_beam_z * s_pitch - n_moving_beam_y;
    h[0] = n_moving_yoke_z; /* yaw */
    h[1] = h_pitch; /* pitch */
}

void aero_velocity_products(const struct aero_coordinates *q, const struct aero_rates *v, const struct aero_parameters *p, double c[2])
{
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double I_rod = p->m_rod * p->l_t * p->l_t / 12.0;
    const double d_t_d_t_m_pa_plus_m_e = p->d_t * p->d_t * (p->m_pa + p->m_e);
    /* frame beam on yoke */
    const double I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    const double omega_beam_z = c_pitch * v->yaw;
    const double omega_beam_x = s_pitch * v->yaw;
    const double n_moving_beam_z = -2.0 * I_beam_zz * omega_beam_x * v->pitch;
    /* body hanging on beam */
    const double I_beam_xx = p->m_e * p->d_x * p->d_x;
    /* frame beam on yoke */
    const double n_moving_beam_y = omega_beam_z * omega_beam_x * (I_beam_xx - I_beam_zz);
    const double n_moving_beam_x = 2.0 * I_beam_xx * omega_beam_z * v->pitch;
    const double n_moving_yoke_z = n_moving_beam_z * c_pitch + n_moving_beam_x * s_pitch;
    c[0] = n_moving_yoke_z; /* yaw */
    c[1] = -n_moving_beam_y; /* pitch */
}

void aero_gravity(const struct aero_coordinates *q, const struct aero_parameters *p, double g[2])
{
    const double s_pitch = sin(q->pitch);
    const double g_pitch = p->m_e * p->d_x * p->g * s_pitch;
    g[0] = 0.0; /* yaw */
    g[1] = g_pitch; /* pitch */
}

void aero_dissipation(const struct aero_coordinates *q, const struct aero_rates *v, const struct aero_parameters *p, double d[2])
{
    (void)q;
    d[0] = p->c_yaw * v->yaw; /* yaw */
    d[1] = p->c_pitch * v->pitch; /* pitch */
}

void aero_generalized_force(const struct aero_coordinates *q, const struct aero_inputs *u, const struct aero_parameters *p, double f[2])
{
    const double c_pitch = cos(q->pitch);
    const double w_m = p->K_omega * u->V_m;
    const double w_t = p->K_omega * u->V_t;
    const double fabs_w_m = fabs(w_m);
    const double fabs_w_t = fabs(w_t);
    /* force push on beam */
    const double n_applied_beam_z = p->d_t * p->K_tail * w_t * fabs_w_t - p->d_t * p->D_main * fabs_w_m * w_m;
    /* torque drag_tail on beam */
    const double n_applied_beam_y = -p->d_t * p->K_main * w_m * fabs_w_m - p->d_t * p->D_tail * fabs_w_t * w_t;
    f[0] = n_applied_beam_z * c_pitch; /* yaw */
    f[1] = -n_applied_beam_y; /* pitch */
}

void aero_input_map(const struct aero_coordinates *q, const struct aero_inputs *u, const struct aero_parameters *p, double s[2][2])
{
    const double c_pitch = cos(q->pitch);
    const double w_m = p->K_omega * u->V_m;
    const double w_t = p->K_omega * u->V_t;
    const double fabs_w_m = fabs(w_m);
    const double d_t_D_main = p->d_t * p->D_main;
    const double fabs_w_t = fabs(w_t);
    const double d_t_D_tail = p->d_t * p->D_tail;
    const double K_omega_sign_w_m = p->K_omega * sign(w_m);
    const double K_omega_fabs_w_m_d_t_D_main = p->K_omega * fabs_w_m * d_t_D_main;
    const double K_omega_sign_w_t = p->K_omega * sign(w_t);
    /* input map */
    const double input_map_1 = p->d_t * (p->K_omega * p->K_tail * fabs_w_t + p->K_tail * w_t * K_omega_sign_w_t);
    const double K_omega_fabs_w_t_d_t_D_tail = p->K_omega * fabs_w_t * d_t_D_tail;
    s[0][0] = -c_pitch * (w_m * d_t_D_main * K_omega_sign_w_m + K_omega_fabs_w_m_d_t_D_main); /* yaw */
    s[0][1] = input_map_1 * c_pitch;
    s[1][0] = p->d_t * (p->K_omega * p->K_main * fabs_w_m + p->K_main * w_m * K_omega_sign_w_m); /* pitch */
    s[1][1] = w_t * d_t_D_tail * K_omega_sign_w_t + K_omega_fabs_w_t_d_t_D_tail;
}

double aero_kinetic_energy(const struct aero_coordinates *q, const struct aero_rates *v, const struct aero_parameters *p)
{
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double I_rod = p->m_rod * p->l_t * p->l_t / 12.0;
    const double I_y = p->m_y * p->r_y * p->r_y / 2.0;
    /* frame beam on yoke */
    const double omega_beam_z = c_pitch * v->yaw;
    /* body rod on beam */
    const double rod_1 = 0.5 * I_y * v->yaw * v->yaw + 0.5 * (I_rod * v->pitch * v->pitch + omega_beam_z * I_rod * omega_beam_z);
    const double d_t_omega_beam_z = p->d_t * omega_beam_z;
    const double d_t_pitch_dot = p->d_t * v->pitch;
    /* body main_rotor on beam */
    const double main_rotor_1 = d_t_omega_beam_z * d_t_omega_beam_z + d_t_pitch_dot * d_t_pitch_dot;
    const double main_rotor_2 = 0.5 * main_rotor_1 * (p->m_pa + p->m_e);
    const double d_x_pitch_dot = p->d_x * v->pitch;
    const double d_x_s_pitch_yaw_dot = p->d_x * s_pitch * v->yaw;
    /* body hanging on beam */
    const double hanging_1 = 0.5 * p->m_e * (d_x_pitch_dot * d_x_pitch_dot + d_x_s_pitch_yaw_dot * d_x_s_pitch_yaw_dot);
    return main_rotor_2 + rod_1 + main_rotor_2 + hanging_1;
}

double aero_potential_energy(const struct aero_coordinates *q, const struct aero_parameters *p)
{
    const double c_pitch = cos(q->pitch);
    return -p->m_e * p->d_x * p->g * c_pitch;
}

void aero_inverse_dynamics(
    const struct aero_state *x,
    const struct aero_accelerations *a,
    const struct aero_inputs *u,
    const struct aero_parameters *p,
    double r[2])
{
    const struct aero_coordinates *q = &x->q;
    const struct aero_rates *v = &x->v;
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double I_rod = p->m_rod * p->l_t * p->l_t / 12.0;
    const double I_y = p->m_y * p->r_y * p->r_y / 2.0;
    const double w_m = p->K_omega * u->V_m;
    const double w_t = p->K_omega * u->V_t;
    const double d_t_d_t_m_pa_plus_m_e = p->d_t * p->d_t * (p->m_pa + p->m_e);
    /* frame beam on yoke */
    const double I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    const double omega_beam_z = c_pitch * v->yaw;
    const double omega_beam_x = s_pitch * v->yaw;
    const double alpha_beam_x = omega_beam_z * v->pitch;
    const double alpha_beam_z = -omega_beam_x * v->pitch;
    /* body hanging on beam */
    const double mc_beam_z = -p->m_e * p->d_x;
    const double I_beam_xx = -p->d_x * mc_beam_z;
    /* frame beam on yoke */
    const double n_moving_beam_y = omega_beam_z * omega_beam_x * (I_beam_xx - I_beam_zz);
    const double n_net_beam_x = I_beam_xx * alpha_beam_x + I_beam_xx * (alpha_beam_x + s_pitch * a->yaw);
    const double beam_1 = n_moving_beam_y - a->pitch * (I_beam_zz + I_beam_xx) + p->g * mc_beam_z * s_pitch;
    const double fabs_w_m = fabs(w_m);
    const double fabs_w_t = fabs(w_t);
    /* force push on beam */
    const double n_applied_beam_z = p->d_t * p->K_tail * w_t * fabs_w_t - p->d_t * p->D_main * fabs_w_m * w_m;
    /* torque drag_tail on beam */
    const double n_applied_beam_y = -p->d_t * p->K_main * w_m * fabs_w_m - p->d_t * p->D_tail * fabs_w_t * w_t;
    /* frame beam on yoke */
    const double n_net_beam_z = I_beam_zz * (c_pitch * a->yaw + alpha_beam_z) + I_beam_zz * alpha_beam_z - n_applied_beam_z;
    /* frame yoke on ground */
    const double n_net_yoke_z = I_y * a->yaw + n_net_beam_z * c_pitch + n_net_beam_x * s_pitch;
    r[0] = p->c_yaw * v->yaw + n_net_yoke_z; /* yaw */
    r[1] = p->c_pitch * v->pitch + n_applied_beam_y - beam_1; /* pitch */
}

void aero_outputs(const struct aero_state *x, const struct aero_parameters *p, struct aero_outputs *y)
{
    const struct aero_coordinates *q = &x->q;
    (void)p;
    y->yaw = q->yaw;
    y->pitch = q->pitch;
}

void aero_pivots(const struct aero_state *x, const struct aero_parameters *p, double d[2])
{
    const struct aero_coordinates *q = &x->q;
    const double c_pitch = cos(q->pitch);
    const double I_rod = p->m_rod * p->l_t * p->l_t / 12.0;
    const double I_y = p->m_y * p->r_y * p->r_y / 2.0;
    const double d_t_d_t_m_pa_plus_m_e = p->d_t * p->d_t * (p->m_pa + p->m_e);
    /* frame beam on yoke */
    const double I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    /* body hanging on beam */
    const double I_beam_xx = p->m_e * p->d_x * p->d_x;
    /* frame yoke on ground */
    const double M_yaw_yaw = I_y + I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    d[0] = M_yaw_yaw; /* yaw */
    d[1] = I_beam_zz + I_beam_xx; /* pitch */
}

int aero_forward_dynamics(
    const struct aero_state *x,
    const struct aero_inputs *u,
    const struct aero_parameters *p,
    struct aero_accelerations *a)
{
    const struct aero_coordinates *q = &x->q;
    const struct aero_rates *v = &x->v;
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double I_rod = p->m_rod * p->l_t * p->l_t / 12.0;
    const double I_y = p->m_y * p->r_y * p->r_y / 2.0;
    const double w_m = p->K_omega * u->V_m;
    const double w_t = p->K_omega * u->V_t;
    const double d_t_d_t_m_pa_plus_m_e = p->d_t * p->d_t * (p->m_pa + p->m_e);
    /* frame beam on yoke */
    const double I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    const double omega_beam_z = c_pitch * v->yaw;
    const double omega_beam_x = s_pitch * v->yaw;
    const double n_moving_beam_z = -2.0 * I_beam_zz * omega_beam_x * v->pitch;
    /* body hanging on beam */
    const double mc_beam_z = -p->m_e * p->d_x;
    const double I_beam_xx = -p->d_x * mc_beam_z;
    /* frame beam on yoke */
    const double I_beam_yy = I_beam_zz + I_beam_xx;
    const double n_moving_beam_y = omega_beam_z * omega_beam_x * (I_beam_xx - I_beam_zz);
    const double n_moving_beam_x = 2.0 * I_beam_xx * omega_beam_z * v->pitch;
    const double n_beam_y = n_moving_beam_y + p->g * mc_beam_z * s_pitch;
    /* frame yoke on ground */
    const double M_yaw_yaw = I_y + I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    const double fabs_w_m = fabs(w_m);
    const double fabs_w_t = fabs(w_t);
    /* force push on beam */
    const double n_applied_beam_z = p->d_t * p->K_tail * w_t * fabs_w_t - p->d_t * p->D_main * fabs_w_m * w_m;
    /* torque drag_tail on beam */
    const double n_applied_beam_y = -p->d_t * p->K_main * w_m * fabs_w_m - p->d_t * p->D_tail * fabs_w_t * w_t;
    /* frame beam on yoke */
    const double n_net_yoke_z = n_moving_beam_x * s_pitch + c_pitch * (n_moving_beam_z - n_applied_beam_z);
    /* balance of forces */
    const double tau_pitch = n_beam_y - n_applied_beam_y - p->c_pitch * v->pitch;
    /* M = L^T D L and back-substitution */
    const double yaw_ddot = -(p->c_yaw * v->yaw + n_net_yoke_z) / M_yaw_yaw;
    if (!(I_beam_yy > 0.0)) {
        return 2;
    }
    if (!(M_yaw_yaw > 0.0)) {
        return 1;
    }
    a->yaw = yaw_ddot;
    a->pitch = tau_pitch / I_beam_yy;
    return 0;
}

int aero_linearize(
    const struct aero_state *x,
    const struct aero_inputs *u,
    const struct aero_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][2])
{
    const struct aero_coordinates *q = &x->q;
    const struct aero_rates *v = &x->v;
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double I_rod = p->m_rod * p->l_t * p->l_t / 12.0;
    const double I_y = p->m_y * p->r_y * p->r_y / 2.0;
    const double w_m = p->K_omega * u->V_m;
    const double w_t = p->K_omega * u->V_t;
    const double d_t_d_t_m_pa_plus_m_e = p->d_t * p->d_t * (p->m_pa + p->m_e);
    /* frame beam on yoke */
    const double I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    const double omega_beam_z = c_pitch * v->yaw;
    const double omega_beam_x = s_pitch * v->yaw;
    const double alpha_beam_x = omega_beam_z * v->pitch;
    const double alpha_beam_z = -omega_beam_x * v->pitch;
    const double I_beam_zz_alpha_beam_z = I_beam_zz * alpha_beam_z;
    /* body hanging on beam */
    const double mc_beam_z = -p->m_e * p->d_x;
    const double I_beam_xx = -p->d_x * mc_beam_z;
    /* frame beam on yoke */
    const double I_beam_yy = I_beam_zz + I_beam_xx;
    const double I_beam_xx_alpha_beam_x = I_beam_xx * alpha_beam_x;
    const double I_beam_xx_minus_I_beam_zz = I_beam_xx - I_beam_zz;
    const double n_beam_y = omega_beam_z * omega_beam_x * I_beam_xx_minus_I_beam_zz + p->g * mc_beam_z * s_pitch;
    /* frame yoke on ground */
    const double M_yaw_yaw = I_y + I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    const double K_main_w_m = p->K_main * w_m;
    const double fabs_w_m = fabs(w_m);
    const double d_t_D_main = p->d_t * p->D_main;
    const double w_m_d_t_D_main = w_m * d_t_D_main;
    const double K_tail_w_t = p->K_tail * w_t;
    const double fabs_w_t = fabs(w_t);
    /* force push on beam */
    const double n_applied_beam_z = p->d_t * K_tail_w_t * fabs_w_t - fabs_w_m * w_m_d_t_D_main;
    const double d_t_D_tail = p->d_t * p->D_tail;
    const double w_t_d_t_D_tail = w_t * d_t_D_tail;
    /* torque drag_tail on beam */
    const double n_applied_beam_y = -p->d_t * K_main_w_m * fabs_w_m - fabs_w_t * w_t_d_t_D_tail;
    /* frame beam on yoke */
    const double beam_1 = c_pitch * (2.0 * I_beam_zz_alpha_beam_z - n_applied_beam_z);
    const double n_net_yoke_z = 2.0 * I_beam_xx_alpha_beam_x * s_pitch + beam_1;
    /* balance of forces */
    const double tau_pitch = n_beam_y - n_applied_beam_y - p->c_pitch * v->pitch;
    /* M = L^T D L and back-substitution */
    const double inv_pitch = 1.0 / I_beam_yy;
    const double inv_yaw = 1.0 / M_yaw_yaw;
    const double yaw_ddot = -inv_yaw * (p->c_yaw * v->yaw + n_net_yoke_z);
    const double K_omega_sign_w_m = p->K_omega * sign(w_m);
    /* input map */
    const double input_map_1 = p->d_t * (p->K_omega * p->K_main * fabs_w_m + K_main_w_m * K_omega_sign_w_m);
    const double input_map_2 = w_m_d_t_D_main * K_omega_sign_w_m + p->K_omega * fabs_w_m * d_t_D_main;
    const double K_omega_sign_w_t = p->K_omega * sign(w_t);
    const double input_map_3 = p->d_t * (p->K_omega * p->K_tail * fabs_w_t + K_tail_w_t * K_omega_sign_w_t);
    const double input_map_4 = w_t_d_t_D_tail * K_omega_sign_w_t + p->K_omega * fabs_w_t * d_t_D_tail;
    /* derivatives with respect to pitch */
    const double by_pitch_1 = I_beam_xx_minus_I_beam_zz * (omega_beam_z * omega_beam_z - omega_beam_x * omega_beam_x);
    const double d_pitch_ddot_by_pitch = inv_pitch * (by_pitch_1 + p->g * mc_beam_z * c_pitch);
    /* derivatives with respect to yaw_dot */
    const double by_yaw_dot_1 = I_beam_xx_minus_I_beam_zz * (omega_beam_x * c_pitch + omega_beam_z * s_pitch);
    const double by_yaw_dot_2 = 2.0 * I_beam_zz * c_pitch * s_pitch * v->pitch;
    const double by_yaw_dot_3 = p->c_yaw - by_yaw_dot_2 + 2.0 * I_beam_xx * s_pitch * c_pitch * v->pitch;
    /* derivatives with respect to pitch_dot */
    const double by_pitch_dot_1 = 2.0 * I_beam_zz * omega_beam_x * c_pitch;
    const double d_yaw_ddot_by_pitch_dot = -inv_yaw * (2.0 * I_beam_xx * omega_beam_z * s_pitch - by_pitch_dot_1);
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = alpha_beam_x + yaw_ddot * s_pitch;
    const double slopes_2 = alpha_beam_z + yaw_ddot * c_pitch;
    const double slopes_3 = s_pitch * (n_applied_beam_z - I_beam_zz_alpha_beam_z - I_beam_zz * slopes_2);
    const double slopes_4 = c_pitch * (I_beam_zz * alpha_beam_x + I_beam_zz * slopes_1) - slopes_3;
    const double slopes_5 = s_pitch * (-I_beam_xx * alpha_beam_z - I_beam_xx * slopes_2);
    const double slopes_6 = c_pitch * (I_beam_xx_alpha_beam_x + I_beam_xx * slopes_1) - slopes_5;
    if (!(I_beam_yy > 0.0)) {
        return 2;
    }
    if (!(M_yaw_yaw > 0.0)) {
        return 1;
    }
    dx[0] = v->yaw; /* yaw' */
    dx[1] = v->pitch; /* pitch' */
    dx[2] = yaw_ddot; /* yaw'' */
    dx[3] = tau_pitch * inv_pitch; /* pitch'' */
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][2] = 1.0; /* yaw' */
    a[1][3] = 1.0; /* pitch' */
    a[2][1] = inv_yaw * (slopes_4 - slopes_6); /* yaw'' */
    a[2][2] = -inv_yaw * by_yaw_dot_3;
    a[2][3] = d_yaw_ddot_by_pitch_dot;
    a[3][1] = d_pitch_ddot_by_pitch; /* pitch'' */
    a[3][2] = inv_pitch * by_yaw_dot_1;
    a[3][3] = -p->c_pitch * inv_pitch;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 2; j++) {
            b[i][j] = 0.0;
        }
    }
    b[2][0] = -inv_yaw * input_map_2 * c_pitch; /* yaw'' */
    b[2][1] = inv_yaw * input_map_3 * c_pitch;
    b[3][0] = inv_pitch * input_map_1; /* pitch'' */
    b[3][1] = inv_pitch * input_map_4;
    return 0;
}

int aero_parameter_jacobian(const struct aero_state *x, const struct aero_inputs *u, const struct aero_parameters *p, double by_p[4][16])
{
    const struct aero_coordinates *q = &x->q;
    const struct aero_rates *v = &x->v;
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double l_t_sq = p->l_t * p->l_t;
    const double r_y_sq = p->r_y * p->r_y;
    const double w_m = p->K_omega * u->V_m;
    const double w_t = p->K_omega * u->V_t;
    const double d_t_m_pa_plus_m_e = p->d_t * (p->m_pa + p->m_e);
    const double d_t_d_t_m_pa_plus_m_e = p->d_t * d_t_m_pa_plus_m_e;
    /* frame beam on yoke */
    const double I_beam_zz = d_t_d_t_m_pa_plus_m_e + p->m_rod * l_t_sq / 12.0 + d_t_d_t_m_pa_plus_m_e;
    const double omega_beam_z = c_pitch * v->yaw;
    const double omega_beam_x = s_pitch * v->yaw;
    const double alpha_beam_x = omega_beam_z * v->pitch;
    const double alpha_beam_z = -omega_beam_x * v->pitch;
    const double omega_beam_z_omega_beam_x = omega_beam_z * omega_beam_x;
    const double a_beam_x = p->g * s_pitch;
    /* body hanging on beam */
    const double mc_beam_z = -p->m_e * p->d_x;
    const double I_beam_xx = -p->d_x * mc_beam_z;
    /* frame beam on yoke */
    const double I_beam_yy = I_beam_zz + I_beam_xx;
    const double n_beam_y = omega_beam_z_omega_beam_x * (I_beam_xx - I_beam_zz) + mc_beam_z * a_beam_x;
    const double beam_1 = I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    /* frame yoke on ground */
    const double M_yaw_yaw = p->m_y * r_y_sq / 2.0 + beam_1;
    const double K_main_w_m = p->K_main * w_m;
    const double fabs_w_m = fabs(w_m);
    /* force lift on beam */
    const double f_applied_beam_z = K_main_w_m * fabs_w_m;
    const double d_t_D_main = p->d_t * p->D_main;
    const double w_m_d_t_D_main = w_m * d_t_D_main;
    const double K_tail_w_t = p->K_tail * w_t;
    const double fabs_w_t = fabs(w_t);
    /* force push on beam */
    const double f_applied_beam_y = -K_tail_w_t * fabs_w_t;
    const double n_applied_beam_z = -p->d_t * f_applied_beam_y - fabs_w_m * w_m_d_t_D_main;
    const double d_t_D_tail = p->d_t * p->D_tail;
    const double w_t_d_t_D_tail = w_t * d_t_D_tail;
    /* torque drag_tail on beam */
    const double n_applied_beam_y = -p->d_t * f_applied_beam_z - fabs_w_t * w_t_d_t_D_tail;
    /* frame beam on yoke */
    const double n_net_beam_z = 2.0 * I_beam_zz * alpha_beam_z - n_applied_beam_z;
    const double n_net_yoke_z = 2.0 * I_beam_xx * alpha_beam_x * s_pitch + n_net_beam_z * c_pitch;
    /* balance of forces */
    const double tau_pitch = n_beam_y - n_applied_beam_y - p->c_pitch * v->pitch;
    /* M = L^T D L and back-substitution */
    const double inv_pitch = 1.0 / I_beam_yy;
    const double inv_yaw = 1.0 / M_yaw_yaw;
    const double yaw_ddot = -inv_yaw * (p->c_yaw * v->yaw + n_net_yoke_z);
    const double pitch_ddot = tau_pitch * inv_pitch;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = alpha_beam_x + yaw_ddot * s_pitch;
    const double slopes_2 = alpha_beam_z + yaw_ddot * c_pitch;
    const double d_t_sq = p->d_t * p->d_t;
    const double two_d_t_sq = 2.0 * d_t_sq;
    /* derivatives with respect to m_pa */
    const double d_pitch_ddot_by_m_pa = inv_pitch * (-2.0 * omega_beam_z_omega_beam_x * d_t_sq - pitch_ddot * two_d_t_sq);
    const double d_x_sq = p->d_x * p->d_x;
    /* derivatives with respect to m_e */
    const double by_m_e_1 = omega_beam_z_omega_beam_x * (d_x_sq - two_d_t_sq);
    const double by_m_e_2 = by_m_e_1 - pitch_ddot * (two_d_t_sq + d_x_sq) - p->d_x * a_beam_x;
    const double l_t_sq_per_12 = l_t_sq / 12.0;
    /* derivatives with respect to m_rod */
    const double d_pitch_ddot_by_m_rod = -inv_pitch * (omega_beam_z_omega_beam_x * l_t_sq_per_12 + pitch_ddot * l_t_sq_per_12);
    const double four_d_t_m_pa_plus_m_e = 4.0 * d_t_m_pa_plus_m_e;
    const double two_mc_beam_z = 2.0 * mc_beam_z;
    /* derivatives with respect to d_x */
    const double by_d_x_1 = pitch_ddot * two_mc_beam_z - omega_beam_z_omega_beam_x * two_mc_beam_z - p->m_e * a_beam_x;
    const double two_m_rod_l_t_per_12 = 2.0 * p->m_rod * p->l_t / 12.0;
    /* derivatives with respect to l_t */
    const double d_pitch_ddot_by_l_t = -inv_pitch * (omega_beam_z_omega_beam_x * two_m_rod_l_t_per_12 + pitch_ddot * two_m_rod_l_t_per_12);
    const double sign_w_m_V_m = sign(w_m) * u->V_m;
    /* derivatives with respect to K_omega */
    const double by_K_omega_1 = p->d_t * (p->K_main * fabs_w_m * u->V_m + K_main_w_m * sign_w_m_V_m);
    const double by_K_omega_2 = w_m_d_t_D_main * sign_w_m_V_m + fabs_w_m * d_t_D_main * u->V_m;
    const double sign_w_t_V_t = sign(w_t) * u->V_t;
    const double by_K_omega_3 = p->d_t * (p->K_tail * fabs_w_t * u->V_t + K_tail_w_t * sign_w_t_V_t);
    const double by_K_omega_4 = w_t_d_t_D_tail * sign_w_t_V_t + fabs_w_t * d_t_D_tail * u->V_t;
    const double d_yaw_ddot_by_K_omega = -inv_yaw * c_pitch * (by_K_omega_2 - by_K_omega_3);
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_3 = c_pitch * (-alpha_beam_z * two_d_t_sq - slopes_2 * two_d_t_sq);
    const double slopes_4 = s_pitch * (alpha_beam_x * d_x_sq + slopes_1 * d_x_sq);
    const double slopes_5 = c_pitch * (-alpha_beam_z * l_t_sq_per_12 - slopes_2 * l_t_sq_per_12);
    const double slopes_6 = 4.0 * omega_beam_z_omega_beam_x * d_t_m_pa_plus_m_e + pitch_ddot * four_d_t_m_pa_plus_m_e;
    const double slopes_7 = alpha_beam_z * four_d_t_m_pa_plus_m_e + slopes_2 * four_d_t_m_pa_plus_m_e;
    const double slopes_8 = c_pitch * (-f_applied_beam_y - p->D_main * fabs_w_m * w_m - slopes_7);
    const double slopes_9 = s_pitch * (-alpha_beam_x * two_mc_beam_z - slopes_1 * two_mc_beam_z);
    const double slopes_10 = c_pitch * (-alpha_beam_z * two_m_rod_l_t_per_12 - slopes_2 * two_m_rod_l_t_per_12);
    /* derivatives with respect to m_y */
    const double d_yaw_ddot_by_m_y = -inv_yaw * yaw_ddot * r_y_sq / 2.0;
    /* derivatives with respect to d_t */
    const double d_pitch_ddot_by_d_t = inv_pitch * (f_applied_beam_z + p->D_tail * fabs_w_t * w_t - slopes_6);
    /* derivatives with respect to r_y */
    const double d_yaw_ddot_by_r_y = -2.0 * p->m_y * p->r_y * inv_yaw * yaw_ddot / 2.0;
    /* derivatives with respect to K_main */
    const double d_pitch_ddot_by_K_main = p->d_t * inv_pitch * w_m * fabs_w_m;
    /* derivatives with respect to K_tail */
    const double d_yaw_ddot_by_K_tail = p->d_t * inv_yaw * w_t * fabs_w_t * c_pitch;
    /* derivatives with respect to D_main */
    const double d_yaw_ddot_by_D_main = -p->d_t * inv_yaw * fabs_w_m * w_m * c_pitch;
    /* derivatives with respect to D_tail */
    const double d_pitch_ddot_by_D_tail = p->d_t * inv_pitch * fabs_w_t * w_t;
    if (!(I_beam_yy > 0.0)) {
        return 2;
    }
    if (!(M_yaw_yaw > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 16; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[2][0] = inv_yaw * slopes_3; /* yaw'' */
    by_p[2][1] = inv_yaw * (slopes_3 - slopes_4);
    by_p[2][2] = inv_yaw * slopes_5;
    by_p[2][3] = d_yaw_ddot_by_m_y;
    by_p[2][4] = inv_yaw * slopes_8;
    by_p[2][5] = -inv_yaw * slopes_9;
    by_p[2][6] = inv_yaw * slopes_10;
    by_p[2][7] = d_yaw_ddot_by_r_y;
    by_p[2][9] = d_yaw_ddot_by_K_omega;
    by_p[2][11] = d_yaw_ddot_by_K_tail;
    by_p[2][12] = d_yaw_ddot_by_D_main;
    by_p[2][15] = -inv_yaw * v->yaw;
    by_p[3][0] = d_pitch_ddot_by_m_pa; /* pitch'' */
    by_p[3][1] = inv_pitch * by_m_e_2;
    by_p[3][2] = d_pitch_ddot_by_m_rod;
    by_p[3][4] = d_pitch_ddot_by_d_t;
    by_p[3][5] = inv_pitch * by_d_x_1;
    by_p[3][6] = d_pitch_ddot_by_l_t;
    by_p[3][8] = mc_beam_z * inv_pitch * s_pitch;
    by_p[3][9] = inv_pitch * (by_K_omega_1 + by_K_omega_4);
    by_p[3][10] = d_pitch_ddot_by_K_main;
    by_p[3][13] = d_pitch_ddot_by_D_tail;
    by_p[3][14] = -inv_pitch * v->pitch;
    return 0;
}

void aero_output_jacobian(const struct aero_state *x, const struct aero_parameters *p, double by_x[2][4], double by_p[2][16])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 4; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* yaw */
    by_x[1][1] = 1.0; /* pitch */
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 16; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

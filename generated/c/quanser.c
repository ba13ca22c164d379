/*
 * Quanser 3-DOF helicopter, the arm hanging below its elevation axis.
 * Generated from `quanser.rig` (model 53fe3397); edit the rig, not this file.
 *
 * The arm with helicopter and counterweight is carried d below the elevation axis, so that it swings
 * like a pendulum. Numbers: Quanser's manual of 2007 and the set-up script that comes with it, which treat
 * both ends as point masses and leave out the arm's own mass; with them the counterweight outweighs the
 * helicopter by 0.04 kg m. d and the friction are not in the manual: to be identified.
 *
 * 161 operations forward, 570 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "quanser.h"

#include <math.h>

void quanser_nominal(struct quanser_parameters *p)
{
    p->m_h = 1.308;
    p->m_w = 1.924;
    p->L_a = 0.6604;
    p->L_w = 0.4699;
    p->L_h = 0.1778;
    p->d = 0.02;
    p->K_f = 0.1188;
    p->c_travel = 0.1;
    p->c_elevation = 0.1;
    p->c_pitch = 0.01;
    p->g = 9.81;
}

void quanser_mass_matrix(const struct quanser_coordinates *q, const struct quanser_parameters *p, double m[3][3])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double I_arm_yy = -p->L_w * mc_arm_x;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_L_h_m_h_per_two = p->L_h * p->L_h * m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    const double M_travel_pitch = I_heli_xx * s_elevation;
    const double heli_1 = 2.0 * L_h_L_h_m_h_per_two * c_pitch;
    const double heli_1_c_pitch = heli_1 * c_pitch;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    const double d_d_m_w_plus_m_heli = p->d * p->d * (p->m_w + m_heli);
    /* frame arm on column */
    const double arm_1 = I_heli_xx + d_d_m_w_plus_m_heli;
    const double M_elevation_elevation = I_arm_yy + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_w_plus_m_heli;
    const double M_travel_elevation = heli_1 * c_elevation * s_pitch;
    const double arm_1_1 = c_elevation * (I_arm_yy + L_a_L_a_m_heli + heli_1_c_pitch - arm_1);
    const double arm_1_2 = arm_1_1 + 2.0 * p->d * s_elevation * (L_a_m_heli + mc_arm_x);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m[i][j] = 0.0;
        }
    }
    m[0][0] = arm_1 + arm_1_2 * c_elevation; /* travel */
    m[0][1] = M_travel_elevation;
    m[0][2] = M_travel_pitch;
    m[1][0] = M_travel_elevation; /* elevation */
    m[1][1] = M_elevation_elevation;
    m[2][0] = M_travel_pitch; /* pitch */
    m[2][2] = I_heli_xx;
}

void quanser_bias(const struct quanser_coordinates *q, const struct quanser_rates *v, const struct quanser_parameters *p, double h[3])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double I_arm_yy = -p->L_w * mc_arm_x;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_L_h_m_h_per_two = p->L_h * p->L_h * m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    /* frame arm on column */
    const double omega_arm_1_z = c_elevation * v->travel;
    const double omega_arm_1_x = s_elevation * v->travel;
    const double alpha_arm_1_x = omega_arm_1_z * v->elevation;
    const double alpha_arm_1_z = -omega_arm_1_x * v->elevation;
    /* frame heli on arm */
    const double omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v->elevation;
    const double omega_heli_z = s_pitch * v->elevation + omega_arm_1_z * c_pitch;
    const double alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y * v->pitch;
    const double n_moving_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y * omega_heli_z;
    const double n_moving_heli_z = I_heli_xx * alpha_heli_z - 2.0 * omega_heli_y * L_h_L_h_m_h_per_two * (v->pitch + omega_arm_1_x);
    const double omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    /* frame arm on column */
    const double a_arm_y = 2.0 * p->d * alpha_arm_1_x;
    const double elevation_dot_sq = v->elevation * v->elevation;
    const double a_arm_z = p->d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    const double arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    const double two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    const double a_arm_x = p->g * s_elevation - p->d * omega_arm_1_z_omega_arm_1_x;
    const double a_arm_z_2 = a_arm_z + p->g * c_elevation;
    /* frame heli on arm */
    const double a_heli_1_y = p->L_a * two_alpha_arm_1_z + a_arm_y;
    const double a_heli_1_z = p->L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_heli_x = m_heli * (a_arm_x - p->L_a * arm_1);
    const double f_heli_y = m_heli * a_heli_y;
    const double f_heli_z = m_heli * a_heli_z;
    const double f_heli_1_y = f_heli_y * c_pitch - f_heli_z * s_pitch;
    const double f_heli_1_z = f_heli_y * s_pitch + f_heli_z * c_pitch;
    const double heli_1_1 = n_moving_heli_z * s_pitch + p->L_a * f_heli_1_z;
    const double heli_1_2 = n_moving_heli_z * c_pitch + p->L_a * f_heli_1_y;
    /* frame arm on column */
    const double f_arm_x = p->m_w * a_arm_x - mc_arm_x * arm_1 + f_heli_x;
    const double f_arm_y = f_heli_1_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z;
    const double n_arm_y = -mc_arm_x * a_arm_z_2 - I_arm_yy * omega_arm_1_z_omega_arm_1_x - heli_1_1;
    const double n_arm_z = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + heli_1_2;
    const double n_column_z = n_arm_z * c_elevation + s_elevation * (n_moving_heli_x + p->d * f_arm_y);
    h[0] = n_column_z; /* travel */
    h[1] = p->d * f_arm_x - n_arm_y; /* elevation */
    h[2] = n_moving_heli_x; /* pitch */
}

void quanser_velocity_products(
    const struct quanser_coordinates *q,
    const struct quanser_rates *v,
    const struct quanser_parameters *p,
    double c[3])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double I_arm_yy = -p->L_w * mc_arm_x;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_L_h_m_h_per_two = p->L_h * p->L_h * m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    /* frame arm on column */
    const double omega_arm_1_z = c_elevation * v->travel;
    const double omega_arm_1_x = s_elevation * v->travel;
    const double alpha_arm_1_x = omega_arm_1_z * v->elevation;
    const double alpha_arm_1_z = -omega_arm_1_x * v->elevation;
    /* frame heli on arm */
    const double omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v->elevation;
    const double omega_heli_z = s_pitch * v->elevation + omega_arm_1_z * c_pitch;
    const double alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y * v->pitch;
    const double n_moving_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y * omega_heli_z;
    const double n_moving_heli_z = I_heli_xx * alpha_heli_z - 2.0 * omega_heli_y * L_h_L_h_m_h_per_two * (v->pitch + omega_arm_1_x);
    const double omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    /* frame arm on column */
    const double a_arm_x = -p->d * omega_arm_1_z_omega_arm_1_x;
    const double a_arm_y = 2.0 * p->d * alpha_arm_1_x;
    const double elevation_dot_sq = v->elevation * v->elevation;
    const double a_arm_z = p->d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    const double arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    const double two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    /* frame heli on arm */
    const double a_heli_1_y = p->L_a * two_alpha_arm_1_z + a_arm_y;
    const double a_heli_1_z = a_arm_z + p->L_a * omega_arm_1_z_omega_arm_1_x;
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_moving_heli_x = -m_heli * (p->L_a * arm_1 - a_arm_x);
    const double f_moving_heli_y = m_heli * a_heli_y;
    const double f_moving_heli_z = m_heli * a_heli_z;
    const double f_moving_heli_1_y = f_moving_heli_y * c_pitch - f_moving_heli_z * s_pitch;
    const double f_moving_heli_1_z = f_moving_heli_y * s_pitch + f_moving_heli_z * c_pitch;
    const double heli_1_1 = n_moving_heli_z * s_pitch + p->L_a * f_moving_heli_1_z;
    const double heli_1_2 = n_moving_heli_z * c_pitch + p->L_a * f_moving_heli_1_y;
    /* frame arm on column */
    const double f_moving_arm_x = p->m_w * a_arm_x - mc_arm_x * arm_1 + f_moving_heli_x;
    const double f_moving_arm_y = f_moving_heli_1_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z;
    const double n_moving_arm_y = -mc_arm_x * a_arm_z - I_arm_yy * omega_arm_1_z_omega_arm_1_x - heli_1_1;
    const double n_moving_arm_z = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + heli_1_2;
    const double n_moving_column_z = n_moving_arm_z * c_elevation + s_elevation * (n_moving_heli_x + p->d * f_moving_arm_y);
    c[0] = n_moving_column_z; /* travel */
    c[1] = p->d * f_moving_arm_x - n_moving_arm_y; /* elevation */
    c[2] = n_moving_heli_x; /* pitch */
}

void quanser_gravity(const struct quanser_coordinates *q, const struct quanser_parameters *p, double g[3])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_s_pitch = p->L_h * s_pitch;
    const double L_a_c_elevation = p->L_a * c_elevation;
    const double gravity_1 = p->m_w * p->g * (p->L_w * c_elevation - p->d * s_elevation);
    const double gravity_2 = p->g * (L_a_c_elevation - s_elevation * (L_h_s_pitch - p->d));
    const double gravity_3 = m_h_per_two * gravity_2 - gravity_1;
    const double gravity_4 = p->g * (L_a_c_elevation + s_elevation * (p->d + L_h_s_pitch));
    g[0] = 0.0; /* travel */
    g[1] = gravity_3 + m_h_per_two * gravity_4; /* elevation */
    g[2] = 0.0; /* pitch */
}

void quanser_dissipation(
    const struct quanser_coordinates *q,
    const struct quanser_rates *v,
    const struct quanser_parameters *p,
    double d[3])
{
    (void)q;
    d[0] = p->c_travel * v->travel; /* travel */
    d[1] = p->c_elevation * v->elevation; /* elevation */
    d[2] = p->c_pitch * v->pitch; /* pitch */
}

void quanser_generalized_force(
    const struct quanser_coordinates *q,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    double f[3])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    /* force back on heli */
    const double f_applied_heli_z = F_f + F_b;
    const double n_applied_heli_x = p->L_h * F_f - p->L_h * F_b;
    /* frame heli on arm */
    const double f_applied_heli_1_y = -f_applied_heli_z * s_pitch;
    /* frame arm on column */
    const double arm_1_1 = s_elevation * (n_applied_heli_x + p->d * f_applied_heli_1_y);
    const double n_applied_column_z = arm_1_1 + p->L_a * f_applied_heli_1_y * c_elevation;
    f[0] = n_applied_column_z; /* travel */
    f[1] = p->L_a * f_applied_heli_z * c_pitch; /* elevation */
    f[2] = n_applied_heli_x; /* pitch */
}

void quanser_input_map(const struct quanser_coordinates *q, const struct quanser_parameters *p, double s[3][2])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double L_h_K_f = p->L_h * p->K_f;
    const double K_f_s_pitch = p->K_f * s_pitch;
    const double L_a_K_f_c_pitch = p->L_a * p->K_f * c_pitch;
    const double d_K_f_s_pitch = p->d * K_f_s_pitch;
    const double L_a_K_f_s_pitch_c_elevation = p->L_a * K_f_s_pitch * c_elevation;
    s[0][0] = s_elevation * (L_h_K_f - d_K_f_s_pitch) - L_a_K_f_s_pitch_c_elevation; /* travel */
    s[0][1] = -L_a_K_f_s_pitch_c_elevation - s_elevation * (L_h_K_f + d_K_f_s_pitch);
    s[1][0] = L_a_K_f_c_pitch; /* elevation */
    s[1][1] = L_a_K_f_c_pitch;
    s[2][0] = L_h_K_f; /* pitch */
    s[2][1] = -L_h_K_f;
}

double quanser_kinetic_energy(const struct quanser_coordinates *q, const struct quanser_rates *v, const struct quanser_parameters *p)
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double m_h_per_two = p->m_h / 2.0;
    /* frame arm on column */
    const double omega_arm_1_z = c_elevation * v->travel;
    const double omega_arm_1_x = s_elevation * v->travel;
    /* frame heli on arm */
    const double omega_heli_z = s_pitch * v->elevation + omega_arm_1_z * c_pitch;
    const double d_elevation_dot = p->d * v->elevation;
    const double d_omega_arm_1_x = p->d * omega_arm_1_x;
    const double L_a_elevation_dot = p->L_a * v->elevation;
    const double heli_1_1 = d_omega_arm_1_x + p->L_a * omega_arm_1_z;
    const double heli_1 = heli_1_1 * c_pitch + L_a_elevation_dot * s_pitch;
    const double heli_2 = L_a_elevation_dot * c_pitch - heli_1_1 * s_pitch;
    const double L_w_elevation_dot = p->L_w * v->elevation;
    /* body counterweight on arm */
    const double counterweight_1 = d_omega_arm_1_x - p->L_w * omega_arm_1_z;
    const double counterweight_2 = d_elevation_dot * d_elevation_dot + counterweight_1 * counterweight_1;
    const double L_h_omega_heli_z = p->L_h * omega_heli_z;
    /* body front_rotor on heli */
    const double front_rotor_1 = p->L_h * (v->pitch + omega_arm_1_x);
    const double front_rotor_2 = d_elevation_dot - L_h_omega_heli_z;
    const double heli_2_plus_front_rotor_1 = heli_2 + front_rotor_1;
    const double heli_1_sq = heli_1 * heli_1;
    const double front_rotor_3 = front_rotor_2 * front_rotor_2 + heli_1_sq;
    const double front_rotor_4 = 0.5 * m_h_per_two * (heli_2_plus_front_rotor_1 * heli_2_plus_front_rotor_1 + front_rotor_3);
    const double front_rotor_5 = 0.5 * p->m_w * (L_w_elevation_dot * L_w_elevation_dot + counterweight_2) + front_rotor_4;
    /* body back_rotor on heli */
    const double back_rotor_1 = d_elevation_dot + L_h_omega_heli_z;
    const double heli_2_minus_front_rotor_1 = heli_2 - front_rotor_1;
    const double back_rotor_2 = heli_1_sq + back_rotor_1 * back_rotor_1;
    const double back_rotor_3 = 0.5 * m_h_per_two * (heli_2_minus_front_rotor_1 * heli_2_minus_front_rotor_1 + back_rotor_2);
    return front_rotor_5 + back_rotor_3;
}

double quanser_potential_energy(const struct quanser_coordinates *q, const struct quanser_parameters *p)
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_s_pitch = p->L_h * s_pitch;
    const double L_a_s_elevation = p->L_a * s_elevation;
    /* body front_rotor on heli */
    const double front_rotor_1 = p->g * (c_elevation * (L_h_s_pitch - p->d) + L_a_s_elevation);
    /* body counterweight on arm */
    const double counterweight_1 = p->m_w * p->g * (p->d * c_elevation + p->L_w * s_elevation);
    /* body front_rotor on heli */
    const double front_rotor_2 = m_h_per_two * front_rotor_1 - counterweight_1;
    /* body back_rotor on heli */
    const double back_rotor_1 = p->g * (L_a_s_elevation - c_elevation * (p->d + L_h_s_pitch));
    return front_rotor_2 + m_h_per_two * back_rotor_1;
}

void quanser_inverse_dynamics(
    const struct quanser_state *x,
    const struct quanser_accelerations *a,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    double r[3])
{
    const struct quanser_coordinates *q = &x->q;
    const struct quanser_rates *v = &x->v;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double I_arm_yy = -p->L_w * mc_arm_x;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_L_h_m_h_per_two = p->L_h * p->L_h * m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    /* frame arm on column */
    const double omega_arm_1_z = c_elevation * v->travel;
    const double omega_arm_1_x = s_elevation * v->travel;
    const double alpha_arm_1_x = omega_arm_1_z * v->elevation;
    const double alpha_arm_1_z = -omega_arm_1_x * v->elevation;
    const double alpha_arm_1_x_2 = alpha_arm_1_x + s_elevation * a->travel;
    const double alpha_arm_1_z_2 = c_elevation * a->travel + alpha_arm_1_z;
    /* frame heli on arm */
    const double omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v->elevation;
    const double omega_heli_z = s_pitch * v->elevation + omega_arm_1_z * c_pitch;
    const double alpha_heli_z = s_pitch * a->elevation + alpha_arm_1_z_2 * c_pitch - omega_heli_y * v->pitch;
    const double n_net_heli_z = I_heli_xx * alpha_heli_z - 2.0 * omega_heli_y * L_h_L_h_m_h_per_two * (v->pitch + omega_arm_1_x);
    const double omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    const double elevation_dot_sq = v->elevation * v->elevation;
    /* frame arm on column */
    const double a_arm_z = p->d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    const double arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    const double a_arm_z_2 = a_arm_z + p->g * c_elevation;
    const double a_arm_y = p->d * (alpha_arm_1_x + alpha_arm_1_x_2);
    const double a_arm_x = p->g * s_elevation - p->d * (omega_arm_1_z_omega_arm_1_x - a->elevation);
    const double arm_2 = alpha_arm_1_z_2 + alpha_arm_1_z;
    const double arm_3 = mc_arm_x * a_arm_z_2 + I_arm_yy * omega_arm_1_z_omega_arm_1_x + I_arm_yy * a->elevation;
    const double arm_4 = I_arm_yy * alpha_arm_1_z_2 + I_arm_yy * alpha_arm_1_z + mc_arm_x * a_arm_y;
    /* force back on heli */
    const double n_applied_heli_x = p->L_h * F_f - p->L_h * F_b;
    /* frame heli on arm */
    const double a_heli_1_y = a_arm_y + p->L_a * arm_2;
    const double a_heli_1_z = a_arm_z_2 + p->L_a * (a->elevation + omega_arm_1_z_omega_arm_1_x);
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_net_heli_x = m_heli * (a_arm_x - p->L_a * arm_1);
    const double f_net_heli_y = m_heli * a_heli_y;
    const double f_net_heli_z = m_heli * a_heli_z - F_f - F_b;
    const double n_net_heli_x = I_heli_xx * omega_heli_y * omega_heli_z + I_heli_xx * (a->pitch + alpha_arm_1_x_2) - n_applied_heli_x;
    const double f_net_heli_1_y = f_net_heli_y * c_pitch - f_net_heli_z * s_pitch;
    const double f_net_heli_1_z = f_net_heli_y * s_pitch + f_net_heli_z * c_pitch;
    /* frame arm on column */
    const double f_net_arm_x = p->m_w * a_arm_x - mc_arm_x * arm_1 + f_net_heli_x;
    const double f_net_arm_y = p->m_w * a_arm_y + mc_arm_x * arm_2 + f_net_heli_1_y;
    const double n_net_arm_y = -arm_3 - n_net_heli_z * s_pitch - p->L_a * f_net_heli_1_z;
    const double n_net_arm_z = arm_4 + n_net_heli_z * c_pitch + p->L_a * f_net_heli_1_y;
    const double n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p->d * f_net_arm_y);
    r[0] = p->c_travel * v->travel + n_net_column_z; /* travel */
    r[1] = p->c_elevation * v->elevation + p->d * f_net_arm_x - n_net_arm_y; /* elevation */
    r[2] = p->c_pitch * v->pitch + n_net_heli_x; /* pitch */
}

void quanser_outputs(const struct quanser_state *x, const struct quanser_parameters *p, struct quanser_outputs *y)
{
    const struct quanser_coordinates *q = &x->q;
    (void)p;
    y->travel = q->travel;
    y->elevation = q->elevation + 0.4799655442984406;
    y->pitch = q->pitch;
}

void quanser_pivots(const struct quanser_state *x, const struct quanser_parameters *p, double d[3])
{
    const struct quanser_coordinates *q = &x->q;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double I_arm_yy = -p->L_w * mc_arm_x;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_L_h_m_h_per_two = p->L_h * p->L_h * m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    const double M_travel_pitch = I_heli_xx * s_elevation;
    const double heli_1 = 2.0 * L_h_L_h_m_h_per_two * c_pitch;
    const double heli_1_c_pitch = heli_1 * c_pitch;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    const double d_d_m_w_plus_m_heli = p->d * p->d * (p->m_w + m_heli);
    /* frame arm on column */
    const double arm_1 = I_heli_xx + d_d_m_w_plus_m_heli;
    const double M_elevation_elevation = I_arm_yy + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_w_plus_m_heli;
    const double M_travel_elevation = heli_1 * c_elevation * s_pitch;
    const double arm_1_1 = c_elevation * (I_arm_yy + L_a_L_a_m_heli + heli_1_c_pitch - arm_1);
    const double arm_1_2 = arm_1_1 + 2.0 * p->d * s_elevation * (L_a_m_heli + mc_arm_x);
    const double M_travel_travel = arm_1 + arm_1_2 * c_elevation;
    /* M = L^T D L and back-substitution */
    const double solve_1 = M_travel_travel - M_travel_elevation * M_travel_elevation / M_elevation_elevation;
    const double pivot_travel = solve_1 - M_travel_pitch * M_travel_pitch / I_heli_xx;
    d[0] = pivot_travel; /* travel */
    d[1] = M_elevation_elevation; /* elevation */
    d[2] = I_heli_xx; /* pitch */
}

int quanser_forward_dynamics(
    const struct quanser_state *x,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    struct quanser_accelerations *a)
{
    const struct quanser_coordinates *q = &x->q;
    const struct quanser_rates *v = &x->v;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double I_arm_yy = -p->L_w * mc_arm_x;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_L_h_m_h_per_two = p->L_h * p->L_h * m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    const double two_L_h_L_h_m_h_per_two = 2.0 * L_h_L_h_m_h_per_two;
    const double M_travel_pitch = I_heli_xx * s_elevation;
    const double heli_1 = two_L_h_L_h_m_h_per_two * c_pitch;
    const double heli_1_c_pitch = heli_1 * c_pitch;
    /* frame arm on column */
    const double omega_arm_1_z = c_elevation * v->travel;
    const double omega_arm_1_x = s_elevation * v->travel;
    const double alpha_arm_1_x = omega_arm_1_z * v->elevation;
    const double alpha_arm_1_z = -omega_arm_1_x * v->elevation;
    const double M_travel_elevation = heli_1 * c_elevation * s_pitch;
    /* frame heli on arm */
    const double omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v->elevation;
    const double omega_heli_z = s_pitch * v->elevation + omega_arm_1_z * c_pitch;
    const double alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y * v->pitch;
    const double n_moving_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y * omega_heli_z;
    const double n_moving_heli_z = I_heli_xx * alpha_heli_z - omega_heli_y * two_L_h_L_h_m_h_per_two * (v->pitch + omega_arm_1_x);
    const double omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    /* frame arm on column */
    const double a_arm_y = 2.0 * p->d * alpha_arm_1_x;
    const double elevation_dot_sq = v->elevation * v->elevation;
    const double a_arm_z = p->d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    const double arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    const double two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    const double a_arm_x = p->g * s_elevation - p->d * omega_arm_1_z_omega_arm_1_x;
    const double a_arm_z_2 = a_arm_z + p->g * c_elevation;
    const double d_d_m_w_plus_m_heli = p->d * p->d * (p->m_w + m_heli);
    const double arm_2 = I_heli_xx + d_d_m_w_plus_m_heli;
    /* frame heli on arm */
    const double a_heli_1_y = p->L_a * two_alpha_arm_1_z + a_arm_y;
    const double a_heli_1_z = p->L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_heli_x = m_heli * (a_arm_x - p->L_a * arm_1);
    const double f_heli_y = m_heli * a_heli_y;
    const double f_net_heli_z = m_heli * a_heli_z - F_f - F_b;
    const double f_net_heli_1_y = f_heli_y * c_pitch - f_net_heli_z * s_pitch;
    const double f_net_heli_1_z = f_heli_y * s_pitch + f_net_heli_z * c_pitch;
    /* frame arm on column */
    const double f_arm_x = p->m_w * a_arm_x - mc_arm_x * arm_1 + f_heli_x;
    const double M_elevation_elevation = I_arm_yy + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_w_plus_m_heli;
    const double f_net_arm_y = f_net_heli_1_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z;
    const double arm_1_1 = c_elevation * (I_arm_yy + L_a_L_a_m_heli + heli_1_c_pitch - arm_2);
    const double arm_1_2 = arm_1_1 + 2.0 * p->d * s_elevation * (L_a_m_heli + mc_arm_x);
    const double M_travel_travel = arm_2 + arm_1_2 * c_elevation;
    /* force back on heli */
    const double n_applied_heli_x = p->L_h * F_f - p->L_h * F_b;
    /* frame heli on arm */
    const double n_net_heli_x = n_moving_heli_x - n_applied_heli_x;
    const double heli_1_1 = n_moving_heli_z * s_pitch + p->L_a * f_net_heli_1_z;
    const double heli_1_2 = n_moving_heli_z * c_pitch + p->L_a * f_net_heli_1_y;
    /* frame arm on column */
    const double n_net_arm_y = -mc_arm_x * a_arm_z_2 - I_arm_yy * omega_arm_1_z_omega_arm_1_x - heli_1_1;
    const double n_net_arm_z = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + heli_1_2;
    const double n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p->d * f_net_arm_y);
    /* balance of forces */
    const double tau_elevation = n_net_arm_y - p->c_elevation * v->elevation - p->d * f_arm_x;
    const double tau_pitch = -p->c_pitch * v->pitch - n_net_heli_x;
    /* M = L^T D L and back-substitution */
    const double inv_pitch = 1.0 / I_heli_xx;
    const double l_pitch_travel = M_travel_pitch * inv_pitch;
    const double inv_elevation = 1.0 / M_elevation_elevation;
    const double l_elevation_travel = M_travel_elevation * inv_elevation;
    const double pivot_travel = M_travel_travel - M_travel_elevation * l_elevation_travel - M_travel_pitch * l_pitch_travel;
    const double solve_1 = tau_pitch * l_pitch_travel + p->c_travel * v->travel + n_net_column_z + tau_elevation * l_elevation_travel;
    const double travel_ddot = -solve_1 / pivot_travel;
    const double elevation_ddot = tau_elevation * inv_elevation - l_elevation_travel * travel_ddot;
    const double pitch_ddot = tau_pitch * inv_pitch - l_pitch_travel * travel_ddot;
    if (!(I_heli_xx > 0.0)) {
        return 3;
    }
    if (!(M_elevation_elevation > 0.0)) {
        return 2;
    }
    if (!(pivot_travel > 0.0)) {
        return 1;
    }
    a->travel = travel_ddot;
    a->elevation = elevation_ddot;
    a->pitch = pitch_ddot;
    return 0;
}

int quanser_linearize(
    const struct quanser_state *x,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2])
{
    const struct quanser_coordinates *q = &x->q;
    const struct quanser_rates *v = &x->v;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double I_arm_yy = -p->L_w * mc_arm_x;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_L_h_m_h_per_two = p->L_h * p->L_h * m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    const double c_pitch_elevation_dot = c_pitch * v->elevation;
    const double two_L_h_L_h_m_h_per_two = 2.0 * L_h_L_h_m_h_per_two;
    const double M_travel_pitch = I_heli_xx * s_elevation;
    const double heli_1 = two_L_h_L_h_m_h_per_two * c_pitch;
    const double heli_1_c_pitch = heli_1 * c_pitch;
    /* frame arm on column */
    const double omega_arm_1_z = c_elevation * v->travel;
    const double omega_arm_1_x = s_elevation * v->travel;
    const double alpha_arm_1_x = omega_arm_1_z * v->elevation;
    const double alpha_arm_1_z = -omega_arm_1_x * v->elevation;
    const double a_arm_1_z = p->g * c_elevation;
    const double a_arm_1_x = p->g * s_elevation;
    const double M_travel_elevation = heli_1 * c_elevation * s_pitch;
    const double omega_arm_1_z_s_pitch = omega_arm_1_z * s_pitch;
    /* frame heli on arm */
    const double omega_heli_y = omega_arm_1_z_s_pitch - c_pitch_elevation_dot;
    const double omega_heli_z = s_pitch * v->elevation + omega_arm_1_z * c_pitch;
    const double omega_heli_x = v->pitch + omega_arm_1_x;
    const double omega_heli_y_pitch_dot = omega_heli_y * v->pitch;
    const double heli_2 = I_heli_xx * omega_heli_y * omega_heli_z;
    const double heli_3 = omega_heli_y * omega_heli_x * two_L_h_L_h_m_h_per_two;
    const double n_moving_heli_z = -heli_3 - I_heli_xx * (omega_heli_y_pitch_dot - alpha_arm_1_z * c_pitch);
    const double omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    /* frame arm on column */
    const double a_arm_y = 2.0 * p->d * alpha_arm_1_x;
    const double omega_arm_1_x_sq = omega_arm_1_x * omega_arm_1_x;
    const double elevation_dot_sq = v->elevation * v->elevation;
    const double omega_arm_1_z_sq = omega_arm_1_z * omega_arm_1_z;
    const double arm_1 = elevation_dot_sq + omega_arm_1_z_sq;
    const double two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    const double I_arm_yy_alpha_arm_1_z = I_arm_yy * alpha_arm_1_z;
    const double arm_2 = omega_arm_1_z_sq - omega_arm_1_x_sq;
    const double a_arm_x = a_arm_1_x - p->d * omega_arm_1_z_omega_arm_1_x;
    const double a_arm_z = p->d * (omega_arm_1_x_sq + elevation_dot_sq) + a_arm_1_z;
    const double d_d_m_w_plus_m_heli = p->d * p->d * (p->m_w + m_heli);
    const double arm_3 = I_heli_xx + d_d_m_w_plus_m_heli;
    /* frame heli on arm */
    const double a_heli_1_y = p->L_a * two_alpha_arm_1_z + a_arm_y;
    const double a_heli_1_z = p->L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_heli_x = m_heli * (a_arm_x - p->L_a * arm_1);
    const double f_heli_y = m_heli * a_heli_y;
    /* frame arm on column */
    const double f_arm_x = p->m_w * a_arm_x - mc_arm_x * arm_1 + f_heli_x;
    const double M_elevation_elevation = I_arm_yy + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_w_plus_m_heli;
    const double arm_1_1 = c_elevation * (I_arm_yy + L_a_L_a_m_heli + heli_1_c_pitch - arm_3);
    const double arm_1_2 = arm_1_1 + 2.0 * p->d * s_elevation * (L_a_m_heli + mc_arm_x);
    const double M_travel_travel = arm_3 + arm_1_2 * c_elevation;
    /* force back on heli */
    const double f_applied_heli_z = F_f + F_b;
    const double n_applied_heli_x = p->L_h * F_f - p->L_h * F_b;
    const double c_elevation_elevation_dot = c_elevation * v->elevation;
    const double s_elevation_elevation_dot = s_elevation * v->elevation;
    const double omega_arm_1_x_c_pitch = omega_arm_1_x * c_pitch;
    /* gravity */
    const double gravity_1 = c_pitch_elevation_dot - omega_arm_1_z_s_pitch;
    /* frame heli on arm */
    const double f_net_heli_z = m_heli * a_heli_z - f_applied_heli_z;
    const double n_net_heli_x = I_heli_xx * alpha_arm_1_x + heli_2 - n_applied_heli_x;
    const double f_net_heli_1_y = f_heli_y * c_pitch - f_net_heli_z * s_pitch;
    const double f_net_heli_1_z = f_heli_y * s_pitch + f_net_heli_z * c_pitch;
    const double heli_1_1 = n_moving_heli_z * s_pitch + p->L_a * f_net_heli_1_z;
    const double heli_1_2 = n_moving_heli_z * c_pitch + p->L_a * f_net_heli_1_y;
    /* frame arm on column */
    const double f_net_arm_y = f_net_heli_1_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z;
    const double n_net_arm_y = -mc_arm_x * a_arm_z - I_arm_yy * omega_arm_1_z_omega_arm_1_x - heli_1_1;
    const double n_net_arm_z = mc_arm_x * a_arm_y + 2.0 * I_arm_yy_alpha_arm_1_z + heli_1_2;
    const double n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p->d * f_net_arm_y);
    /* balance of forces */
    const double tau_elevation = n_net_arm_y - p->c_elevation * v->elevation - p->d * f_arm_x;
    const double tau_pitch = -p->c_pitch * v->pitch - n_net_heli_x;
    /* M = L^T D L and back-substitution */
    const double inv_pitch = 1.0 / I_heli_xx;
    const double l_pitch_travel = M_travel_pitch * inv_pitch;
    const double inv_elevation = 1.0 / M_elevation_elevation;
    const double l_elevation_travel = M_travel_elevation * inv_elevation;
    const double pivot_travel = M_travel_travel - M_travel_elevation * l_elevation_travel - M_travel_pitch * l_pitch_travel;
    const double inv_travel = 1.0 / pivot_travel;
    const double solve_1 = tau_pitch * l_pitch_travel + p->c_travel * v->travel + n_net_column_z + tau_elevation * l_elevation_travel;
    const double travel_ddot = -inv_travel * solve_1;
    const double elevation_ddot = tau_elevation * inv_elevation - l_elevation_travel * travel_ddot;
    const double pitch_ddot = tau_pitch * inv_pitch - l_pitch_travel * travel_ddot;
    const double L_h_K_f = p->L_h * p->K_f;
    const double K_f_s_pitch = p->K_f * s_pitch;
    const double L_a_K_f_c_pitch = p->L_a * p->K_f * c_pitch;
    const double d_K_f_s_pitch = p->d * K_f_s_pitch;
    const double L_a_K_f_s_pitch_c_elevation = p->L_a * K_f_s_pitch * c_elevation;
    /* input map */
    const double input_map_1 = L_a_K_f_s_pitch_c_elevation + s_elevation * (L_h_K_f + d_K_f_s_pitch);
    const double omega_arm_1_x_s_pitch = omega_arm_1_x * s_pitch;
    const double two_omega_arm_1_x = 2.0 * omega_arm_1_x;
    const double two_omega_arm_1_z = 2.0 * omega_arm_1_z;
    /* derivatives with respect to elevation */
    const double by_elevation_1 = omega_arm_1_x * two_omega_arm_1_z;
    const double by_elevation_2 = I_heli_xx * (omega_heli_z * omega_arm_1_x_s_pitch + omega_heli_y * omega_arm_1_x_c_pitch);
    const double by_elevation_3 = two_L_h_L_h_m_h_per_two * (omega_arm_1_z * omega_heli_y - omega_heli_x * omega_arm_1_x_s_pitch);
    const double by_elevation_4 = p->d * omega_arm_1_z * two_omega_arm_1_x - a_arm_1_x;
    const double a_arm_1_z_minus_d_arm_2 = a_arm_1_z - p->d * arm_2;
    const double by_elevation_5 = by_elevation_4 + p->L_a * arm_2;
    const double by_elevation_6 = m_heli * (p->L_a * by_elevation_1 + a_arm_1_z_minus_d_arm_2);
    const double by_elevation_7 = p->d * (p->m_w * a_arm_1_z_minus_d_arm_2 + mc_arm_x * by_elevation_1 + by_elevation_6);
    /* derivatives with respect to pitch */
    const double by_pitch_1 = I_heli_xx * (omega_heli_z * omega_heli_z + omega_heli_y * gravity_1);
    const double c_elevation_s_pitch = c_elevation * s_pitch;
    /* derivatives with respect to travel_dot */
    const double by_travel_dot_1 = omega_arm_1_x * c_elevation + omega_arm_1_z * s_elevation;
    const double by_travel_dot_2 = p->d * two_omega_arm_1_x * s_elevation;
    const double by_travel_dot_3 = two_omega_arm_1_z * c_elevation;
    const double by_travel_dot_4 = omega_heli_z * c_elevation_s_pitch + omega_heli_y * c_elevation * c_pitch;
    const double by_travel_dot_5 = two_L_h_L_h_m_h_per_two * (omega_heli_x * c_elevation_s_pitch + omega_heli_y * s_elevation);
    const double d_by_travel_dot_1 = p->d * by_travel_dot_1;
    const double by_travel_dot_6 = 2.0 * p->d * c_elevation_elevation_dot;
    const double by_travel_dot_7 = 2.0 * s_elevation_elevation_dot;
    const double by_travel_dot_8 = by_travel_dot_6 - p->L_a * by_travel_dot_7;
    const double by_travel_dot_9 = by_travel_dot_2 + p->L_a * by_travel_dot_1;
    const double by_travel_dot_10 = m_heli * (p->L_a * by_travel_dot_3 + d_by_travel_dot_1);
    const double by_travel_dot_11 = m_heli * (by_travel_dot_8 * c_pitch + by_travel_dot_9 * s_pitch);
    const double by_travel_dot_12 = m_heli * (by_travel_dot_9 * c_pitch - by_travel_dot_8 * s_pitch);
    const double by_travel_dot_13 = I_heli_xx * (s_elevation_elevation_dot * c_pitch + c_elevation_s_pitch * v->pitch);
    const double by_travel_dot_14 = I_heli_xx * by_travel_dot_4 + I_heli_xx * c_elevation_elevation_dot;
    const double by_travel_dot_15 = by_travel_dot_5 + by_travel_dot_13;
    const double by_travel_dot_16 = by_travel_dot_11 * c_pitch - by_travel_dot_12 * s_pitch;
    const double by_travel_dot_17 = p->L_a * (by_travel_dot_11 * s_pitch + by_travel_dot_12 * c_pitch);
    const double by_travel_dot_18 = by_travel_dot_17 - by_travel_dot_15 * s_pitch;
    const double by_travel_dot_19 = p->L_a * by_travel_dot_16 - by_travel_dot_15 * c_pitch;
    const double by_travel_dot_20 = mc_arm_x * by_travel_dot_2 + I_arm_yy * by_travel_dot_1 + by_travel_dot_18;
    const double by_travel_dot_21 = mc_arm_x * by_travel_dot_6 - 2.0 * I_arm_yy * s_elevation_elevation_dot + by_travel_dot_19;
    const double by_travel_dot_22 = p->d * (p->m_w * by_travel_dot_6 - mc_arm_x * by_travel_dot_7 + by_travel_dot_16);
    const double by_travel_dot_23 = p->d * (-mc_arm_x * by_travel_dot_3 - p->m_w * d_by_travel_dot_1 - by_travel_dot_10);
    const double by_travel_dot_24 = s_elevation * (by_travel_dot_14 + by_travel_dot_22);
    const double by_travel_dot_25 = p->c_travel + by_travel_dot_21 * c_elevation + by_travel_dot_24;
    const double by_travel_dot_26 = by_travel_dot_20 + by_travel_dot_23;
    const double by_travel_dot_27 = l_elevation_travel * by_travel_dot_26 - by_travel_dot_25 + l_pitch_travel * by_travel_dot_14;
    const double d_travel_ddot_by_travel_dot = inv_travel * by_travel_dot_27;
    const double d_elevation_ddot_by_travel_dot = -inv_elevation * by_travel_dot_26 - l_elevation_travel * d_travel_ddot_by_travel_dot;
    const double d_pitch_ddot_by_travel_dot = -inv_pitch * by_travel_dot_14 - l_pitch_travel * d_travel_ddot_by_travel_dot;
    const double two_elevation_dot = 2.0 * v->elevation;
    const double d_two_elevation_dot = p->d * two_elevation_dot;
    /* derivatives with respect to elevation_dot */
    const double by_elevation_dot_1 = I_heli_xx * (omega_heli_y * s_pitch - omega_heli_z * c_pitch);
    const double d_two_omega_arm_1_z = p->d * two_omega_arm_1_z;
    const double two_omega_arm_1_x_2 = 2.0 * omega_arm_1_x;
    const double by_elevation_dot_2 = d_two_omega_arm_1_z - p->L_a * two_omega_arm_1_x_2;
    const double by_elevation_dot_3 = m_heli * (by_elevation_dot_2 * c_pitch + d_two_elevation_dot * s_pitch);
    const double by_elevation_dot_4 = m_heli * (d_two_elevation_dot * c_pitch - by_elevation_dot_2 * s_pitch);
    const double by_elevation_dot_5 = I_heli_xx * (c_pitch * v->pitch - omega_arm_1_x_c_pitch);
    const double by_elevation_dot_6 = by_elevation_dot_1 + I_heli_xx * omega_arm_1_z;
    const double by_elevation_dot_7 = by_elevation_dot_5 + two_L_h_L_h_m_h_per_two * omega_heli_x * c_pitch;
    const double by_elevation_dot_8 = by_elevation_dot_3 * c_pitch - by_elevation_dot_4 * s_pitch;
    const double by_elevation_dot_9 = p->L_a * (by_elevation_dot_3 * s_pitch + by_elevation_dot_4 * c_pitch);
    const double by_elevation_dot_10 = by_elevation_dot_7 * c_pitch + p->L_a * by_elevation_dot_8;
    const double by_elevation_dot_11 = mc_arm_x * d_two_elevation_dot + by_elevation_dot_7 * s_pitch + by_elevation_dot_9;
    const double by_elevation_dot_12 = mc_arm_x * d_two_omega_arm_1_z - 2.0 * I_arm_yy * omega_arm_1_x + by_elevation_dot_10;
    const double by_elevation_dot_13 = p->d * (p->m_w * d_two_omega_arm_1_z - mc_arm_x * two_omega_arm_1_x_2 + by_elevation_dot_8);
    const double by_elevation_dot_14 = p->d * (-mc_arm_x * two_elevation_dot - p->L_a * m_heli * two_elevation_dot);
    const double by_elevation_dot_15 = s_elevation * (by_elevation_dot_6 + by_elevation_dot_13);
    const double by_elevation_dot_16 = by_elevation_dot_12 * c_elevation + by_elevation_dot_15;
    const double by_elevation_dot_17 = p->c_elevation + by_elevation_dot_14 + by_elevation_dot_11;
    const double by_elevation_dot_18 = l_pitch_travel * by_elevation_dot_6 - by_elevation_dot_16 + l_elevation_travel * by_elevation_dot_17;
    const double d_travel_ddot_by_elevation_dot = inv_travel * by_elevation_dot_18;
    const double d_elevation_ddot_by_elevation_dot = -l_elevation_travel * d_travel_ddot_by_elevation_dot
        - inv_elevation * by_elevation_dot_17;
    const double d_pitch_ddot_by_elevation_dot = -inv_pitch * by_elevation_dot_6 - l_pitch_travel * d_travel_ddot_by_elevation_dot;
    /* derivatives with respect to pitch_dot */
    const double by_pitch_dot_1 = I_heli_xx * gravity_1 - omega_heli_y * two_L_h_L_h_m_h_per_two;
    const double by_pitch_dot_1_s_pitch = by_pitch_dot_1 * s_pitch;
    const double by_pitch_dot_2 = by_pitch_dot_1 * c_elevation * c_pitch;
    const double by_pitch_dot_3 = p->c_pitch * l_pitch_travel - by_pitch_dot_2 + l_elevation_travel * by_pitch_dot_1_s_pitch;
    const double d_travel_ddot_by_pitch_dot = inv_travel * by_pitch_dot_3;
    const double d_elevation_ddot_by_pitch_dot = -l_elevation_travel * d_travel_ddot_by_pitch_dot - inv_elevation * by_pitch_dot_1_s_pitch;
    const double d_pitch_ddot_by_pitch_dot = -p->c_pitch * inv_pitch - l_pitch_travel * d_travel_ddot_by_pitch_dot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = alpha_arm_1_x + travel_ddot * s_elevation;
    const double slopes_2 = travel_ddot * c_elevation + alpha_arm_1_z;
    const double alpha_arm_1_x_plus_slopes_1 = alpha_arm_1_x + slopes_1;
    const double slopes_3 = p->d * alpha_arm_1_x_plus_slopes_1;
    const double slopes_2_plus_alpha_arm_1_z = slopes_2 + alpha_arm_1_z;
    const double slopes_4 = I_arm_yy * slopes_2 + I_arm_yy_alpha_arm_1_z + mc_arm_x * slopes_3;
    const double slopes_5 = slopes_3 + p->L_a * slopes_2_plus_alpha_arm_1_z;
    const double slopes_6 = a_arm_z + p->L_a * (omega_arm_1_z_omega_arm_1_x + elevation_ddot);
    const double slopes_7 = elevation_ddot * s_pitch + slopes_2 * c_pitch - omega_heli_y_pitch_dot;
    const double slopes_8 = m_heli * (slopes_5 * c_pitch + slopes_6 * s_pitch);
    const double slopes_9 = m_heli * (slopes_6 * c_pitch - slopes_5 * s_pitch);
    const double slopes_10 = I_heli_xx * slopes_7 - heli_3;
    const double slopes_11 = slopes_9 - f_applied_heli_z;
    const double slopes_12 = heli_2 + I_heli_xx * (slopes_1 + pitch_ddot) - n_applied_heli_x;
    const double slopes_8_c_pitch = slopes_8 * c_pitch;
    const double slopes_11_s_pitch = slopes_11 * s_pitch;
    const double slopes_8_s_pitch = slopes_8 * s_pitch;
    const double slopes_13 = slopes_8_c_pitch - slopes_11_s_pitch;
    const double slopes_10_c_pitch = slopes_10 * c_pitch;
    const double slopes_14 = p->d * (p->m_w * slopes_3 + mc_arm_x * slopes_2_plus_alpha_arm_1_z + slopes_13);
    const double slopes_15 = s_elevation * (slopes_4 + slopes_10_c_pitch + p->L_a * slopes_13);
    const double slopes_16 = p->d * slopes_2_plus_alpha_arm_1_z;
    const double slopes_17 = I_arm_yy * alpha_arm_1_x - mc_arm_x * slopes_16 + I_arm_yy * slopes_1;
    const double slopes_18 = slopes_16 - p->L_a * alpha_arm_1_x_plus_slopes_1;
    const double slopes_19 = m_heli * (by_elevation_5 * s_pitch + slopes_18 * c_pitch);
    const double slopes_20 = m_heli * (by_elevation_5 * c_pitch - slopes_18 * s_pitch);
    const double I_heli_xx_slopes_2 = I_heli_xx * slopes_2;
    const double slopes_21 = I_heli_xx * (omega_arm_1_x_s_pitch * v->pitch - slopes_1 * c_pitch);
    const double slopes_22 = slopes_21 - by_elevation_3;
    const double slopes_23 = slopes_19 * c_pitch - slopes_20 * s_pitch;
    const double slopes_24 = p->L_a * (slopes_19 * s_pitch + slopes_20 * c_pitch);
    const double slopes_25 = slopes_22 * s_pitch + slopes_24;
    const double slopes_26 = mc_arm_x * by_elevation_4 + I_arm_yy * arm_2 + slopes_25;
    const double slopes_27 = slopes_22 * c_pitch + p->L_a * slopes_23 - slopes_17;
    const double slopes_28 = p->d * (p->m_w * slopes_16 - mc_arm_x * alpha_arm_1_x_plus_slopes_1 + slopes_23);
    const double slopes_29 = s_elevation * (I_heli_xx_slopes_2 - by_elevation_2 + slopes_28);
    const double slopes_30 = c_elevation * (slopes_12 + slopes_14) + slopes_29;
    const double slopes_31 = slopes_27 * c_elevation - slopes_15 + slopes_30;
    const double slopes_32 = elevation_ddot * c_pitch - slopes_2 * s_pitch;
    const double slopes_33 = I_heli_xx * (slopes_32 - omega_heli_z * v->pitch);
    const double slopes_34 = slopes_33 - omega_heli_z * omega_heli_x * two_L_h_L_h_m_h_per_two;
    const double slopes_35 = slopes_11 * c_pitch - slopes_8_s_pitch;
    const double slopes_36 = slopes_8_c_pitch + slopes_9 * s_pitch;
    const double slopes_37 = slopes_9 * c_pitch - slopes_8_s_pitch - slopes_35;
    const double slopes_38 = slopes_34 * c_pitch - slopes_10 * s_pitch;
    const double slopes_39 = p->L_a * (slopes_36 - slopes_8_c_pitch - slopes_11_s_pitch);
    const double slopes_40 = slopes_10_c_pitch + slopes_34 * s_pitch + slopes_39;
    const double slopes_41 = c_elevation * (slopes_38 + p->L_a * slopes_37);
    const double slopes_42 = slopes_41 + s_elevation * (by_pitch_1 + p->d * slopes_37);
    /* derivatives with respect to elevation */
    const double by_elevation_8 = slopes_26 + by_elevation_7;
    const double by_elevation_9 = by_elevation_2 - I_heli_xx_slopes_2;
    const double by_elevation_10 = l_elevation_travel * by_elevation_8 - slopes_31 - l_pitch_travel * by_elevation_9;
    const double d_travel_ddot_by_elevation = inv_travel * by_elevation_10;
    const double d_elevation_ddot_by_elevation = -inv_elevation * by_elevation_8 - l_elevation_travel * d_travel_ddot_by_elevation;
    const double d_pitch_ddot_by_elevation = inv_pitch * by_elevation_9 - l_pitch_travel * d_travel_ddot_by_elevation;
    /* derivatives with respect to pitch */
    const double by_pitch_2 = l_pitch_travel * by_pitch_1 - slopes_42 + l_elevation_travel * slopes_40;
    const double d_travel_ddot_by_pitch = inv_travel * by_pitch_2;
    const double d_elevation_ddot_by_pitch = -l_elevation_travel * d_travel_ddot_by_pitch - inv_elevation * slopes_40;
    const double d_pitch_ddot_by_pitch = -inv_pitch * by_pitch_1 - l_pitch_travel * d_travel_ddot_by_pitch;
    /* derivatives with respect to V_f */
    const double by_V_f_1 = L_a_K_f_s_pitch_c_elevation + s_elevation * (d_K_f_s_pitch - L_h_K_f);
    const double by_V_f_2 = l_elevation_travel * L_a_K_f_c_pitch;
    const double l_pitch_travel_L_h_K_f = l_pitch_travel * L_h_K_f;
    const double d_travel_ddot_by_V_f = inv_travel * (-by_V_f_2 - by_V_f_1 - l_pitch_travel_L_h_K_f);
    const double by_V_f_3 = inv_elevation * L_a_K_f_c_pitch;
    const double inv_pitch_L_h_K_f = inv_pitch * L_h_K_f;
    /* derivatives with respect to V_b */
    const double d_travel_ddot_by_V_b = inv_travel * (l_pitch_travel_L_h_K_f - by_V_f_2 - input_map_1);
    if (!(I_heli_xx > 0.0)) {
        return 3;
    }
    if (!(M_elevation_elevation > 0.0)) {
        return 2;
    }
    if (!(pivot_travel > 0.0)) {
        return 1;
    }
    dx[0] = v->travel; /* travel' */
    dx[1] = v->elevation; /* elevation' */
    dx[2] = v->pitch; /* pitch' */
    dx[3] = travel_ddot; /* travel'' */
    dx[4] = elevation_ddot; /* elevation'' */
    dx[5] = pitch_ddot; /* pitch'' */
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][3] = 1.0; /* travel' */
    a[1][4] = 1.0; /* elevation' */
    a[2][5] = 1.0; /* pitch' */
    a[3][1] = d_travel_ddot_by_elevation; /* travel'' */
    a[3][2] = d_travel_ddot_by_pitch;
    a[3][3] = d_travel_ddot_by_travel_dot;
    a[3][4] = d_travel_ddot_by_elevation_dot;
    a[3][5] = d_travel_ddot_by_pitch_dot;
    a[4][1] = d_elevation_ddot_by_elevation; /* elevation'' */
    a[4][2] = d_elevation_ddot_by_pitch;
    a[4][3] = d_elevation_ddot_by_travel_dot;
    a[4][4] = d_elevation_ddot_by_elevation_dot;
    a[4][5] = d_elevation_ddot_by_pitch_dot;
    a[5][1] = d_pitch_ddot_by_elevation; /* pitch'' */
    a[5][2] = d_pitch_ddot_by_pitch;
    a[5][3] = d_pitch_ddot_by_travel_dot;
    a[5][4] = d_pitch_ddot_by_elevation_dot;
    a[5][5] = d_pitch_ddot_by_pitch_dot;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 2; j++) {
            b[i][j] = 0.0;
        }
    }
    b[3][0] = d_travel_ddot_by_V_f; /* travel'' */
    b[3][1] = d_travel_ddot_by_V_b;
    b[4][0] = by_V_f_3 - l_elevation_travel * d_travel_ddot_by_V_f; /* elevation'' */
    b[4][1] = by_V_f_3 - l_elevation_travel * d_travel_ddot_by_V_b;
    b[5][0] = inv_pitch_L_h_K_f - l_pitch_travel * d_travel_ddot_by_V_f; /* pitch'' */
    b[5][1] = -inv_pitch_L_h_K_f - l_pitch_travel * d_travel_ddot_by_V_b;
    return 0;
}

int quanser_parameter_jacobian(
    const struct quanser_state *x,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    double by_p[6][11])
{
    const struct quanser_coordinates *q = &x->q;
    const struct quanser_rates *v = &x->v;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double V_s = u->V_f + u->V_b;
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double I_arm_yy = -p->L_w * mc_arm_x;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_m_h_per_two = p->L_h * m_h_per_two;
    const double L_h_L_h_m_h_per_two = p->L_h * L_h_m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    const double two_L_h_L_h_m_h_per_two = 2.0 * L_h_L_h_m_h_per_two;
    const double M_travel_pitch = I_heli_xx * s_elevation;
    const double heli_1 = two_L_h_L_h_m_h_per_two * c_pitch;
    const double heli_1_c_pitch = heli_1 * c_pitch;
    /* frame arm on column */
    const double omega_arm_1_z = c_elevation * v->travel;
    const double omega_arm_1_x = s_elevation * v->travel;
    const double alpha_arm_1_x = omega_arm_1_z * v->elevation;
    const double alpha_arm_1_z = -omega_arm_1_x * v->elevation;
    const double a_arm_1_x = p->g * s_elevation;
    const double M_travel_elevation = heli_1 * c_elevation * s_pitch;
    /* frame heli on arm */
    const double omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v->elevation;
    const double omega_heli_z = s_pitch * v->elevation + omega_arm_1_z * c_pitch;
    const double omega_heli_y_pitch_dot = omega_heli_y * v->pitch;
    const double heli_2 = I_heli_xx * (omega_heli_y_pitch_dot - alpha_arm_1_z * c_pitch);
    const double omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    const double heli_3 = omega_heli_y * (v->pitch + omega_arm_1_x);
    const double n_moving_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y_omega_heli_z;
    const double n_moving_heli_z = -heli_3 * two_L_h_L_h_m_h_per_two - heli_2;
    const double omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    /* frame arm on column */
    const double a_arm_y = 2.0 * p->d * alpha_arm_1_x;
    const double elevation_dot_sq = v->elevation * v->elevation;
    const double arm_1 = omega_arm_1_x * omega_arm_1_x + elevation_dot_sq;
    const double arm_2 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    const double mc_arm_x_arm_2 = mc_arm_x * arm_2;
    const double two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    const double a_arm_x = a_arm_1_x - p->d * omega_arm_1_z_omega_arm_1_x;
    const double a_arm_z = p->d * arm_1 + p->g * c_elevation;
    const double d_d_m_w_plus_m_heli = p->d * p->d * (p->m_w + m_heli);
    const double arm_3 = I_heli_xx + d_d_m_w_plus_m_heli;
    const double L_a_arm_2 = p->L_a * arm_2;
    /* frame heli on arm */
    const double a_heli_1_y = p->L_a * two_alpha_arm_1_z + a_arm_y;
    const double a_heli_1_z = p->L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_heli_y = m_heli * a_heli_y;
    /* frame arm on column */
    const double f_arm_x = p->m_w * a_arm_x - mc_arm_x_arm_2 + m_heli * (a_arm_x - L_a_arm_2);
    const double M_elevation_elevation = I_arm_yy + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_w_plus_m_heli;
    const double arm_1_1 = c_elevation * (I_arm_yy + L_a_L_a_m_heli + heli_1_c_pitch - arm_3);
    const double arm_1_2 = arm_1_1 + 2.0 * p->d * s_elevation * (L_a_m_heli + mc_arm_x);
    const double M_travel_travel = arm_3 + arm_1_2 * c_elevation;
    /* force back on heli */
    const double f_applied_heli_z = F_f + F_b;
    const double n_applied_heli_x = p->L_h * F_f - p->L_h * F_b;
    /* frame heli on arm */
    const double f_net_heli_z = m_heli * a_heli_z - f_applied_heli_z;
    const double n_net_heli_x = n_moving_heli_x - n_applied_heli_x;
    const double f_net_heli_1_y = f_heli_y * c_pitch - f_net_heli_z * s_pitch;
    const double f_net_heli_1_z = f_heli_y * s_pitch + f_net_heli_z * c_pitch;
    const double heli_1_1 = n_moving_heli_z * s_pitch + p->L_a * f_net_heli_1_z;
    const double heli_1_2 = n_moving_heli_z * c_pitch + p->L_a * f_net_heli_1_y;
    /* frame arm on column */
    const double f_net_arm_y = f_net_heli_1_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z;
    const double n_net_arm_y = -mc_arm_x * a_arm_z - I_arm_yy * omega_arm_1_z_omega_arm_1_x - heli_1_1;
    const double n_net_arm_z = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + heli_1_2;
    const double n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p->d * f_net_arm_y);
    /* balance of forces */
    const double tau_elevation = n_net_arm_y - p->c_elevation * v->elevation - p->d * f_arm_x;
    const double tau_pitch = -p->c_pitch * v->pitch - n_net_heli_x;
    /* M = L^T D L and back-substitution */
    const double inv_pitch = 1.0 / I_heli_xx;
    const double l_pitch_travel = M_travel_pitch * inv_pitch;
    const double inv_elevation = 1.0 / M_elevation_elevation;
    const double l_elevation_travel = M_travel_elevation * inv_elevation;
    const double pivot_travel = M_travel_travel - M_travel_elevation * l_elevation_travel - M_travel_pitch * l_pitch_travel;
    const double inv_travel = 1.0 / pivot_travel;
    const double solve_1 = tau_pitch * l_pitch_travel + p->c_travel * v->travel + n_net_column_z + tau_elevation * l_elevation_travel;
    const double travel_ddot = -inv_travel * solve_1;
    const double elevation_ddot = tau_elevation * inv_elevation - l_elevation_travel * travel_ddot;
    const double pitch_ddot = tau_pitch * inv_pitch - l_pitch_travel * travel_ddot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = alpha_arm_1_x + travel_ddot * s_elevation;
    const double slopes_2 = travel_ddot * c_elevation + alpha_arm_1_z;
    const double alpha_arm_1_x_plus_slopes_1 = alpha_arm_1_x + slopes_1;
    const double slopes_3 = p->d * alpha_arm_1_x_plus_slopes_1;
    const double m_w_slopes_3 = p->m_w * slopes_3;
    const double slopes_2_plus_alpha_arm_1_z = slopes_2 + alpha_arm_1_z;
    const double slopes_4 = omega_arm_1_z_omega_arm_1_x + elevation_ddot;
    const double slopes_5 = slopes_3 + p->L_a * slopes_2_plus_alpha_arm_1_z;
    const double a_arm_z_plus_L_a_slopes_4 = a_arm_z + p->L_a * slopes_4;
    const double slopes_6 = elevation_ddot * s_pitch + slopes_2 * c_pitch - omega_heli_y_pitch_dot;
    const double slopes_1_plus_pitch_ddot = slopes_1 + pitch_ddot;
    const double slopes_7 = slopes_5 * c_pitch + a_arm_z_plus_L_a_slopes_4 * s_pitch;
    const double slopes_8 = a_arm_z_plus_L_a_slopes_4 * c_pitch - slopes_5 * s_pitch;
    const double m_heli_slopes_7 = m_heli * slopes_7;
    const double slopes_9 = m_heli * slopes_8 - f_applied_heli_z;
    const double slopes_10 = m_heli_slopes_7 * c_pitch - slopes_9 * s_pitch;
    const double slopes_11 = a_arm_1_x - p->d * (omega_arm_1_z_omega_arm_1_x - elevation_ddot);
    const double slopes_11_minus_L_a_arm_2 = slopes_11 - L_a_arm_2;
    const double slopes_12 = m_heli_slopes_7 * s_pitch + slopes_9 * c_pitch;
    const double slopes_13 = p->m_w * slopes_11 - mc_arm_x_arm_2 + m_heli * slopes_11_minus_L_a_arm_2;
    const double slopes_14 = slopes_7 * c_pitch - slopes_8 * s_pitch;
    const double slopes_15 = p->L_a * (slopes_7 * s_pitch + slopes_8 * c_pitch);
    const double d_L_w_arm_2_plus_slopes_11 = p->d * (p->L_w * arm_2 + slopes_11);
    const double slopes_16 = p->d * s_elevation * (slopes_3 - p->L_w * slopes_2_plus_alpha_arm_1_z);
    const double slopes_17 = m_heli * (slopes_2_plus_alpha_arm_1_z * c_pitch + slopes_4 * s_pitch);
    const double slopes_18 = m_heli * (slopes_4 * c_pitch - slopes_2_plus_alpha_arm_1_z * s_pitch);
    const double slopes_19 = slopes_17 * c_pitch - slopes_18 * s_pitch;
    const double slopes_20 = p->L_a * (slopes_17 * s_pitch + slopes_18 * c_pitch);
    const double slopes_21 = c_elevation * (slopes_10 + p->L_a * slopes_19);
    const double slopes_22 = slopes_21 + p->d * slopes_19 * s_elevation;
    const double slopes_23 = elevation_ddot - omega_arm_1_z_omega_arm_1_x;
    const double slopes_24 = m_heli * (arm_1 * s_pitch + alpha_arm_1_x_plus_slopes_1 * c_pitch);
    const double slopes_25 = m_heli * (arm_1 * c_pitch - alpha_arm_1_x_plus_slopes_1 * s_pitch);
    const double slopes_26 = slopes_24 * c_pitch - slopes_25 * s_pitch;
    const double slopes_27 = p->L_a * (slopes_24 * s_pitch + slopes_25 * c_pitch);
    const double slopes_28 = p->d * (p->m_w * alpha_arm_1_x_plus_slopes_1 + slopes_26);
    const double slopes_29 = m_w_slopes_3 + mc_arm_x * slopes_2_plus_alpha_arm_1_z + slopes_10 + slopes_28;
    const double slopes_30 = p->d * (p->m_w * slopes_23 + m_heli * slopes_23);
    const double slopes_31 = c_elevation * (p->L_a * slopes_26 + mc_arm_x * alpha_arm_1_x_plus_slopes_1);
    const double slopes_32 = slopes_31 + slopes_29 * s_elevation;
    const double half_L_h_L_h = 0.5 * p->L_h * p->L_h;
    const double two_half_L_h_L_h = 2.0 * half_L_h_L_h;
    const double L_w_sq = p->L_w * p->L_w;
    const double two_mc_arm_x = 2.0 * mc_arm_x;
    const double four_L_h_m_h_per_two = 4.0 * L_h_m_h_per_two;
    const double F_f_minus_F_b = F_f - F_b;
    const double L_h_V_f = p->L_h * u->V_f;
    const double L_h_V_b = p->L_h * u->V_b;
    const double L_h_V_f_minus_L_h_V_b = L_h_V_f - L_h_V_b;
    const double V_s_s_pitch = V_s * s_pitch;
    const double L_a_V_s_c_pitch = p->L_a * V_s * c_pitch;
    /* derivatives with respect to K_f */
    const double by_K_f_1 = s_elevation * (L_h_V_b - L_h_V_f + p->d * V_s_s_pitch);
    const double by_K_f_2 = p->L_a * V_s_s_pitch * c_elevation + by_K_f_1;
    const double by_K_f_3 = l_elevation_travel * L_a_V_s_c_pitch + by_K_f_2 + l_pitch_travel * L_h_V_f_minus_L_h_V_b;
    const double d_travel_ddot_by_K_f = -inv_travel * by_K_f_3;
    const double d_elevation_ddot_by_K_f = inv_elevation * L_a_V_s_c_pitch - l_elevation_travel * d_travel_ddot_by_K_f;
    const double d_pitch_ddot_by_K_f = inv_pitch * L_h_V_f_minus_L_h_V_b - l_pitch_travel * d_travel_ddot_by_K_f;
    const double m_heli_c_elevation_s_pitch = m_heli * c_elevation * s_pitch;
    const double m_heli_c_elevation_c_pitch = m_heli * c_elevation * c_pitch;
    /* derivatives with respect to g */
    const double by_g_1 = m_heli_c_elevation_s_pitch * c_pitch - m_heli_c_elevation_c_pitch * s_pitch;
    const double by_g_2 = p->L_a * (m_heli_c_elevation_s_pitch * s_pitch + m_heli_c_elevation_c_pitch * c_pitch);
    const double by_g_3 = p->d * (p->m_w * s_elevation + m_heli * s_elevation);
    const double by_g_4 = p->L_a * by_g_1 * c_elevation + p->d * by_g_1 * s_elevation;
    const double by_g_5 = mc_arm_x * c_elevation + by_g_2 + by_g_3;
    const double d_travel_ddot_by_g = inv_travel * (l_elevation_travel * by_g_5 - by_g_4);
    const double d_elevation_ddot_by_g = -inv_elevation * by_g_5 - l_elevation_travel * d_travel_ddot_by_g;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_33 = omega_heli_y_omega_heli_z * two_half_L_h_L_h + slopes_1_plus_pitch_ddot * two_half_L_h_L_h;
    const double slopes_34 = slopes_6 * two_half_L_h_L_h - 2.0 * heli_3 * half_L_h_L_h;
    const double slopes_35 = slopes_34 * s_pitch + slopes_15 + p->d * slopes_11_minus_L_a_arm_2;
    const double slopes_36 = c_elevation * (slopes_34 * c_pitch + p->L_a * slopes_14);
    const double slopes_37 = slopes_36 + s_elevation * (slopes_33 + p->d * slopes_14);
    const double slopes_38 = slopes_2 * L_w_sq + alpha_arm_1_z * L_w_sq;
    const double slopes_39 = p->L_w * a_arm_z - omega_arm_1_z_omega_arm_1_x * L_w_sq - elevation_ddot * L_w_sq;
    const double slopes_40 = c_elevation * (slopes_38 - p->L_w * slopes_3) + slopes_16;
    const double slopes_41 = p->m_w * a_arm_z + omega_arm_1_z_omega_arm_1_x * two_mc_arm_x + elevation_ddot * two_mc_arm_x;
    const double slopes_42 = slopes_2 * two_mc_arm_x + alpha_arm_1_z * two_mc_arm_x + m_w_slopes_3;
    const double slopes_43 = omega_heli_y_omega_heli_z * four_L_h_m_h_per_two + slopes_1_plus_pitch_ddot * four_L_h_m_h_per_two;
    const double slopes_44 = slopes_6 * four_L_h_m_h_per_two - 4.0 * heli_3 * L_h_m_h_per_two;
    const double slopes_44_s_pitch = slopes_44 * s_pitch;
    const double slopes_45 = s_elevation * (slopes_43 - F_f_minus_F_b);
    const double slopes_46 = slopes_44 * c_elevation * c_pitch + slopes_45;
    /* derivatives with respect to m_h */
    const double by_m_h_1 = l_pitch_travel * slopes_33 - slopes_37 + l_elevation_travel * slopes_35;
    const double d_travel_ddot_by_m_h = inv_travel * by_m_h_1;
    const double d_elevation_ddot_by_m_h = -l_elevation_travel * d_travel_ddot_by_m_h - inv_elevation * slopes_35;
    const double d_pitch_ddot_by_m_h = -inv_pitch * slopes_33 - l_pitch_travel * d_travel_ddot_by_m_h;
    /* derivatives with respect to m_w */
    const double by_m_w_1 = slopes_39 - d_L_w_arm_2_plus_slopes_11;
    const double d_travel_ddot_by_m_w = inv_travel * (-l_elevation_travel * by_m_w_1 - slopes_40);
    const double d_elevation_ddot_by_m_w = inv_elevation * by_m_w_1 - l_elevation_travel * d_travel_ddot_by_m_w;
    /* derivatives with respect to L_a */
    const double by_L_a_1 = p->d * m_heli * arm_2 - slopes_12 - slopes_20;
    const double d_travel_ddot_by_L_a = inv_travel * (-l_elevation_travel * by_L_a_1 - slopes_22);
    const double d_elevation_ddot_by_L_a = inv_elevation * by_L_a_1 - l_elevation_travel * d_travel_ddot_by_L_a;
    /* derivatives with respect to L_w */
    const double by_L_w_1 = p->m_w * p->d * slopes_2_plus_alpha_arm_1_z * s_elevation + slopes_42 * c_elevation;
    const double slopes_41_minus_d_m_w_arm_2 = slopes_41 - p->m_w * p->d * arm_2;
    const double d_travel_ddot_by_L_w = inv_travel * (by_L_w_1 - l_elevation_travel * slopes_41_minus_d_m_w_arm_2);
    const double d_elevation_ddot_by_L_w = inv_elevation * slopes_41_minus_d_m_w_arm_2 - l_elevation_travel * d_travel_ddot_by_L_w;
    /* derivatives with respect to L_h */
    const double by_L_h_1 = F_f_minus_F_b - slopes_43;
    const double by_L_h_2 = slopes_46 - l_elevation_travel * slopes_44_s_pitch + l_pitch_travel * by_L_h_1;
    const double d_travel_ddot_by_L_h = -inv_travel * by_L_h_2;
    const double d_elevation_ddot_by_L_h = -inv_elevation * slopes_44_s_pitch - l_elevation_travel * d_travel_ddot_by_L_h;
    const double d_pitch_ddot_by_L_h = inv_pitch * by_L_h_1 - l_pitch_travel * d_travel_ddot_by_L_h;
    /* derivatives with respect to d */
    const double by_d_1 = mc_arm_x * arm_1 + slopes_27 + slopes_13 + slopes_30;
    const double d_travel_ddot_by_d = inv_travel * (l_elevation_travel * by_d_1 - slopes_32);
    const double d_elevation_ddot_by_d = -inv_elevation * by_d_1 - l_elevation_travel * d_travel_ddot_by_d;
    /* derivatives with respect to c_travel */
    const double d_travel_ddot_by_c_travel = -inv_travel * v->travel;
    /* derivatives with respect to c_elevation */
    const double d_travel_ddot_by_c_elevation = inv_travel * l_elevation_travel * v->elevation;
    const double d_elevation_ddot_by_c_elevation = -inv_elevation * v->elevation - l_elevation_travel * d_travel_ddot_by_c_elevation;
    /* derivatives with respect to c_pitch */
    const double d_travel_ddot_by_c_pitch = inv_travel * l_pitch_travel * v->pitch;
    const double d_pitch_ddot_by_c_pitch = -inv_pitch * v->pitch - l_pitch_travel * d_travel_ddot_by_c_pitch;
    if (!(I_heli_xx > 0.0)) {
        return 3;
    }
    if (!(M_elevation_elevation > 0.0)) {
        return 2;
    }
    if (!(pivot_travel > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 11; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[3][0] = d_travel_ddot_by_m_h; /* travel'' */
    by_p[3][1] = d_travel_ddot_by_m_w;
    by_p[3][2] = d_travel_ddot_by_L_a;
    by_p[3][3] = d_travel_ddot_by_L_w;
    by_p[3][4] = d_travel_ddot_by_L_h;
    by_p[3][5] = d_travel_ddot_by_d;
    by_p[3][6] = d_travel_ddot_by_K_f;
    by_p[3][7] = d_travel_ddot_by_c_travel;
    by_p[3][8] = d_travel_ddot_by_c_elevation;
    by_p[3][9] = d_travel_ddot_by_c_pitch;
    by_p[3][10] = d_travel_ddot_by_g;
    by_p[4][0] = d_elevation_ddot_by_m_h; /* elevation'' */
    by_p[4][1] = d_elevation_ddot_by_m_w;
    by_p[4][2] = d_elevation_ddot_by_L_a;
    by_p[4][3] = d_elevation_ddot_by_L_w;
    by_p[4][4] = d_elevation_ddot_by_L_h;
    by_p[4][5] = d_elevation_ddot_by_d;
    by_p[4][6] = d_elevation_ddot_by_K_f;
    by_p[4][7] = -l_elevation_travel * d_travel_ddot_by_c_travel;
    by_p[4][8] = d_elevation_ddot_by_c_elevation;
    by_p[4][9] = -l_elevation_travel * d_travel_ddot_by_c_pitch;
    by_p[4][10] = d_elevation_ddot_by_g;
    by_p[5][0] = d_pitch_ddot_by_m_h; /* pitch'' */
    by_p[5][1] = -l_pitch_travel * d_travel_ddot_by_m_w;
    by_p[5][2] = -l_pitch_travel * d_travel_ddot_by_L_a;
    by_p[5][3] = -l_pitch_travel * d_travel_ddot_by_L_w;
    by_p[5][4] = d_pitch_ddot_by_L_h;
    by_p[5][5] = -l_pitch_travel * d_travel_ddot_by_d;
    by_p[5][6] = d_pitch_ddot_by_K_f;
    by_p[5][7] = -l_pitch_travel * d_travel_ddot_by_c_travel;
    by_p[5][8] = -l_pitch_travel * d_travel_ddot_by_c_elevation;
    by_p[5][9] = d_pitch_ddot_by_c_pitch;
    by_p[5][10] = -l_pitch_travel * d_travel_ddot_by_g;
    return 0;
}

void quanser_output_jacobian(const struct quanser_state *x, const struct quanser_parameters *p, double by_x[3][6], double by_p[3][11])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 6; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* travel */
    by_x[1][1] = 1.0; /* elevation */
    by_x[2][2] = 1.0; /* pitch */
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 11; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

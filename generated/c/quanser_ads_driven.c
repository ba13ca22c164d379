/*
 * Quanser 3-DOF helicopter with the active disturbance system, its carriage driven by its motor.
 * Generated from `quanser_ads_driven.rig` (model df2d3e4a); edit the rig, not this file.
 *
 * The carriage has an equation of its own: motor torque through gear and ball screw, back-EMF, rotor
 * inertia, and the pull of gravity along the tilted arm. Motor and screw: Quanser's manual of the active
 * disturbance system; the rotor's inertia and the rail's friction are not published.
 *
 * 214 operations forward, 773 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#include "quanser_ads_driven.h"

#include <math.h>

void quanser_ads_driven_nominal(struct quanser_ads_driven_parameters *p)
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
    p->m_s = 0.3;
    p->s_0 = 0.0;
    p->R_m = 2.6;
    p->K_t = 0.00768;
    p->n_g = 3.71;
    p->lead = 0.008467;
    p->J_m = 4.6e-7;
    p->c_s = 40.0;
}

void quanser_ads_driven_mass_matrix(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_parameters *p,
    double m[4][4])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double r_s = 6.283185307179586 * p->n_g / p->lead;
    const double s_plus_s_0 = q->s + p->s_0;
    /* frame rail on arm */
    const double M_elevation_s = p->d * p->m_s;
    const double m_s_s_plus_s_0 = p->m_s * s_plus_s_0;
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_L_h_m_h_per_two = p->L_h * p->L_h * m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    const double M_travel_pitch = I_heli_xx * s_elevation;
    const double heli_1 = 2.0 * L_h_L_h_m_h_per_two * c_pitch;
    const double heli_1_c_pitch = heli_1 * c_pitch;
    /* frame arm on column */
    const double arm_1 = s_plus_s_0 * m_s_s_plus_s_0 - p->L_w * mc_arm_x;
    const double d_d_m_heli_plus_m_w_plus_m_s = p->d * p->d * (m_heli + p->m_w + p->m_s);
    const double arm_2 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    const double M_elevation_elevation = arm_1 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    const double M_travel_elevation = heli_1 * c_elevation * s_pitch;
    const double arm_1_1 = arm_1 + L_a_L_a_m_heli + heli_1_c_pitch - arm_2;
    const double arm_1_2 = 2.0 * p->d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    const double arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    /* kinetic energy rotor */
    const double M_s_s = p->m_s + p->J_m * r_s * r_s;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            m[i][j] = 0.0;
        }
    }
    m[0][0] = arm_2 + arm_1_3; /* travel */
    m[0][1] = M_travel_elevation;
    m[0][2] = M_travel_pitch;
    m[1][0] = M_travel_elevation; /* elevation */
    m[1][1] = M_elevation_elevation;
    m[1][3] = M_elevation_s;
    m[2][0] = M_travel_pitch; /* pitch */
    m[2][2] = I_heli_xx;
    m[3][1] = M_elevation_s; /* s */
    m[3][3] = M_s_s;
}

void quanser_ads_driven_bias(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_parameters *p,
    double h[4])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double s_plus_s_0 = q->s + p->s_0;
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
    /* frame rail on arm */
    const double a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + 2.0 * omega_arm_1_z * v->s;
    const double f_moving_rail_y = p->m_s * a_rail_y;
    const double a_rail_z = 2.0 * v->elevation * v->s + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    const double f_rail_x = p->m_s * (a_arm_x - s_plus_s_0 * arm_1);
    /* frame arm on column */
    const double arm_2 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    const double arm_3 = mc_arm_x * a_arm_z_2 + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p->m_s * s_plus_s_0 * a_rail_z;
    /* frame heli on arm */
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_heli_x = m_heli * (a_arm_x - p->L_a * arm_1);
    const double f_heli_y = m_heli * a_heli_y;
    const double f_heli_z = m_heli * a_heli_z;
    const double f_heli_1_y = f_heli_y * c_pitch - f_heli_z * s_pitch;
    const double f_heli_1_z = f_heli_y * s_pitch + f_heli_z * c_pitch;
    /* frame arm on column */
    const double f_arm_x = f_heli_x - mc_arm_x * arm_1 + p->m_w * a_arm_x + f_rail_x;
    const double f_arm_y = f_moving_rail_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_heli_1_y;
    const double n_arm_y = -arm_3 - n_moving_heli_z * s_pitch - p->L_a * f_heli_1_z;
    const double n_arm_z = arm_2 + n_moving_heli_z * c_pitch + p->L_a * f_heli_1_y;
    const double n_column_z = n_arm_z * c_elevation + s_elevation * (n_moving_heli_x + p->d * f_arm_y);
    h[0] = n_column_z; /* travel */
    h[1] = p->d * f_arm_x - n_arm_y; /* elevation */
    h[2] = n_moving_heli_x; /* pitch */
    h[3] = f_rail_x; /* s */
}

void quanser_ads_driven_velocity_products(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_parameters *p,
    double c[4])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double s_plus_s_0 = q->s + p->s_0;
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
    /* frame rail on arm */
    const double a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + 2.0 * omega_arm_1_z * v->s;
    const double a_rail_z = a_arm_z + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + 2.0 * v->elevation * v->s;
    const double f_moving_rail_x = -p->m_s * (s_plus_s_0 * arm_1 - a_arm_x);
    const double f_moving_rail_y = p->m_s * a_rail_y;
    /* frame arm on column */
    const double arm_2 = mc_arm_x * a_arm_z + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p->m_s * s_plus_s_0 * a_rail_z;
    const double arm_3 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    const double f_moving_arm_x = p->m_w * a_arm_x - mc_arm_x * arm_1 + f_moving_rail_x + f_moving_heli_x;
    const double f_moving_arm_y = f_moving_rail_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_moving_heli_1_y;
    const double n_moving_arm_y = -arm_2 - n_moving_heli_z * s_pitch - p->L_a * f_moving_heli_1_z;
    const double n_moving_arm_z = arm_3 + n_moving_heli_z * c_pitch + p->L_a * f_moving_heli_1_y;
    const double n_moving_column_z = n_moving_arm_z * c_elevation + s_elevation * (n_moving_heli_x + p->d * f_moving_arm_y);
    c[0] = n_moving_column_z; /* travel */
    c[1] = p->d * f_moving_arm_x - n_moving_arm_y; /* elevation */
    c[2] = n_moving_heli_x; /* pitch */
    c[3] = f_moving_rail_x; /* s */
}

void quanser_ads_driven_gravity(const struct quanser_ads_driven_coordinates *q, const struct quanser_ads_driven_parameters *p, double g[4])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_s_pitch = p->L_h * s_pitch;
    const double L_a_c_elevation = p->L_a * c_elevation;
    const double d_s_elevation = p->d * s_elevation;
    const double gravity_1 = p->m_w * p->g * (p->L_w * c_elevation - d_s_elevation);
    const double gravity_2 = p->g * (L_a_c_elevation - s_elevation * (L_h_s_pitch - p->d));
    const double gravity_3 = m_h_per_two * gravity_2 - gravity_1;
    const double gravity_4 = p->g * (L_a_c_elevation + s_elevation * (p->d + L_h_s_pitch));
    const double gravity_5 = p->g * p->m_s * (d_s_elevation + c_elevation * (q->s + p->s_0));
    const double g_elevation = gravity_3 + m_h_per_two * gravity_4 + gravity_5;
    g[0] = 0.0; /* travel */
    g[1] = g_elevation; /* elevation */
    g[2] = 0.0; /* pitch */
    g[3] = p->g * p->m_s * s_elevation; /* s */
}

void quanser_ads_driven_dissipation(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_parameters *p,
    double d[4])
{
    (void)q;
    d[0] = p->c_travel * v->travel; /* travel */
    d[1] = p->c_elevation * v->elevation; /* elevation */
    d[2] = p->c_pitch * v->pitch; /* pitch */
    d[3] = p->c_s * v->s; /* s */
}

void quanser_ads_driven_generalized_force(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    double f[4])
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    const double part_1 = 6.283185307179586 * p->K_t * p->n_g / p->lead;
    const double i_m = (u->V_s_motor - part_1 * v->s) / p->R_m;
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
    f[3] = part_1 * i_m; /* s */
}

void quanser_ads_driven_input_map(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_parameters *p,
    double s[4][3])
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
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 3; j++) {
            s[i][j] = 0.0;
        }
    }
    s[0][0] = s_elevation * (L_h_K_f - d_K_f_s_pitch) - L_a_K_f_s_pitch_c_elevation; /* travel */
    s[0][1] = -L_a_K_f_s_pitch_c_elevation - s_elevation * (L_h_K_f + d_K_f_s_pitch);
    s[1][0] = L_a_K_f_c_pitch; /* elevation */
    s[1][1] = L_a_K_f_c_pitch;
    s[2][0] = L_h_K_f; /* pitch */
    s[2][1] = -L_h_K_f;
    s[3][2] = 6.283185307179586 * p->K_t * p->n_g / (p->lead * p->R_m); /* s */
}

double quanser_ads_driven_kinetic_energy(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_parameters *p)
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double s_plus_s_0 = q->s + p->s_0;
    const double s_plus_s_0_elevation_dot = s_plus_s_0 * v->elevation;
    const double m_h_per_two = p->m_h / 2.0;
    /* frame arm on column */
    const double omega_arm_1_z = c_elevation * v->travel;
    const double omega_arm_1_x = s_elevation * v->travel;
    /* frame heli on arm */
    const double omega_heli_z = s_pitch * v->elevation + omega_arm_1_z * c_pitch;
    /* kinetic energy rotor */
    const double rotor_1 = 6.283185307179586 * p->n_g * v->s / p->lead;
    const double d_elevation_dot = p->d * v->elevation;
    const double d_omega_arm_1_x = p->d * omega_arm_1_x;
    const double L_a_elevation_dot = p->L_a * v->elevation;
    /* frame heli on arm */
    const double heli_1_1 = d_omega_arm_1_x + p->L_a * omega_arm_1_z;
    const double heli_1 = heli_1_1 * c_pitch + L_a_elevation_dot * s_pitch;
    const double heli_2 = L_a_elevation_dot * c_pitch - heli_1_1 * s_pitch;
    /* frame rail on arm */
    const double rail_1 = d_omega_arm_1_x + s_plus_s_0 * omega_arm_1_z;
    const double s_dot_plus_d_elevation_dot = v->s + d_elevation_dot;
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
    /* body carriage on rail */
    const double carriage_1 = s_dot_plus_d_elevation_dot * s_dot_plus_d_elevation_dot + rail_1 * rail_1;
    const double carriage_2 = 0.5 * p->m_s * (s_plus_s_0_elevation_dot * s_plus_s_0_elevation_dot + carriage_1);
    const double carriage_3 = front_rotor_5 + back_rotor_3 + carriage_2;
    return 0.5 * p->J_m * rotor_1 * rotor_1 + carriage_3;
}

double quanser_ads_driven_potential_energy(const struct quanser_ads_driven_coordinates *q, const struct quanser_ads_driven_parameters *p)
{
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_s_pitch = p->L_h * s_pitch;
    const double L_a_s_elevation = p->L_a * s_elevation;
    /* body front_rotor on heli */
    const double front_rotor_1 = p->g * (c_elevation * (L_h_s_pitch - p->d) + L_a_s_elevation);
    const double d_c_elevation = p->d * c_elevation;
    /* body counterweight on arm */
    const double counterweight_1 = p->m_w * p->g * (d_c_elevation + p->L_w * s_elevation);
    /* body front_rotor on heli */
    const double front_rotor_2 = m_h_per_two * front_rotor_1 - counterweight_1;
    /* body back_rotor on heli */
    const double back_rotor_1 = p->g * (L_a_s_elevation - c_elevation * (p->d + L_h_s_pitch));
    /* body carriage on rail */
    const double carriage_1 = p->g * p->m_s * (s_elevation * (q->s + p->s_0) - d_c_elevation);
    return front_rotor_2 + m_h_per_two * back_rotor_1 + carriage_1;
}

void quanser_ads_driven_inverse_dynamics(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_accelerations *a,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    double r[4])
{
    const struct quanser_ads_driven_coordinates *q = &x->q;
    const struct quanser_ads_driven_rates *v = &x->v;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double r_s = 6.283185307179586 * p->n_g / p->lead;
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    const double K_t_r_s = p->K_t * r_s;
    const double i_m = (u->V_s_motor - K_t_r_s * v->s) / p->R_m;
    const double s_plus_s_0 = q->s + p->s_0;
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
    const double arm_3 = a->elevation + omega_arm_1_z_omega_arm_1_x;
    const double arm_4 = mc_arm_x * a_arm_z_2 + I_arm_yy * omega_arm_1_z_omega_arm_1_x + I_arm_yy * a->elevation;
    const double arm_5 = I_arm_yy * alpha_arm_1_z_2 + I_arm_yy * alpha_arm_1_z + mc_arm_x * a_arm_y;
    /* force back on heli */
    const double n_applied_heli_x = p->L_h * F_f - p->L_h * F_b;
    /* frame heli on arm */
    const double a_heli_1_y = a_arm_y + p->L_a * arm_2;
    const double a_heli_1_z = a_arm_z_2 + p->L_a * arm_3;
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_net_heli_x = m_heli * (a_arm_x - p->L_a * arm_1);
    const double f_net_heli_y = m_heli * a_heli_y;
    /* frame rail on arm */
    const double a_rail_y = 2.0 * omega_arm_1_z * v->s + a_arm_y + s_plus_s_0 * arm_2;
    const double a_rail_z = 2.0 * v->elevation * v->s + a_arm_z_2 + s_plus_s_0 * arm_3;
    const double a_rail_x = a->s + a_arm_x - s_plus_s_0 * arm_1;
    const double f_net_rail_x = p->m_s * a_rail_x;
    const double f_net_rail_y = p->m_s * a_rail_y;
    const double f_net_heli_z = m_heli * a_heli_z - F_f - F_b;
    const double n_net_heli_x = I_heli_xx * omega_heli_y * omega_heli_z + I_heli_xx * (a->pitch + alpha_arm_1_x_2) - n_applied_heli_x;
    /* frame arm on column */
    const double arm_6 = arm_4 + p->m_s * s_plus_s_0 * a_rail_z;
    const double f_net_arm_x = f_net_heli_x - mc_arm_x * arm_1 + p->m_w * a_arm_x + f_net_rail_x;
    /* frame heli on arm */
    const double f_net_heli_1_y = f_net_heli_y * c_pitch - f_net_heli_z * s_pitch;
    const double f_net_heli_1_z = f_net_heli_y * s_pitch + f_net_heli_z * c_pitch;
    const double heli_1_1 = n_net_heli_z * c_pitch + p->L_a * f_net_heli_1_y;
    /* frame arm on column */
    const double f_net_arm_y = p->m_w * a_arm_y + mc_arm_x * arm_2 + f_net_rail_y + f_net_heli_1_y;
    const double n_net_arm_y = -arm_6 - n_net_heli_z * s_pitch - p->L_a * f_net_heli_1_z;
    const double n_net_arm_z = arm_5 + s_plus_s_0 * f_net_rail_y + heli_1_1;
    const double n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p->d * f_net_arm_y);
    r[0] = p->c_travel * v->travel + n_net_column_z; /* travel */
    r[1] = p->c_elevation * v->elevation + p->d * f_net_arm_x - n_net_arm_y; /* elevation */
    r[2] = p->c_pitch * v->pitch + n_net_heli_x; /* pitch */
    r[3] = p->c_s * v->s + f_net_rail_x - K_t_r_s * i_m + p->J_m * r_s * r_s * a->s; /* s */
}

void quanser_ads_driven_outputs(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_parameters *p,
    struct quanser_ads_driven_outputs *y)
{
    const struct quanser_ads_driven_coordinates *q = &x->q;
    (void)p;
    y->travel = q->travel;
    y->elevation = q->elevation + 0.4799655442984406;
    y->pitch = q->pitch;
    y->s = q->s;
}

void quanser_ads_driven_pivots(const struct quanser_ads_driven_state *x, const struct quanser_ads_driven_parameters *p, double d[4])
{
    const struct quanser_ads_driven_coordinates *q = &x->q;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double r_s = 6.283185307179586 * p->n_g / p->lead;
    const double s_plus_s_0 = q->s + p->s_0;
    /* frame rail on arm */
    const double M_elevation_s = p->d * p->m_s;
    const double m_s_s_plus_s_0 = p->m_s * s_plus_s_0;
    /* body counterweight on arm */
    const double mc_arm_x = -p->m_w * p->L_w;
    const double m_h_per_two = p->m_h / 2.0;
    const double L_h_L_h_m_h_per_two = p->L_h * p->L_h * m_h_per_two;
    /* frame heli on arm */
    const double m_heli = 2.0 * m_h_per_two;
    const double I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    const double M_travel_pitch = I_heli_xx * s_elevation;
    const double heli_1 = 2.0 * L_h_L_h_m_h_per_two * c_pitch;
    const double heli_1_c_pitch = heli_1 * c_pitch;
    /* frame arm on column */
    const double arm_1 = s_plus_s_0 * m_s_s_plus_s_0 - p->L_w * mc_arm_x;
    const double d_d_m_heli_plus_m_w_plus_m_s = p->d * p->d * (m_heli + p->m_w + p->m_s);
    const double arm_2 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    const double M_elevation_elevation = arm_1 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    const double M_travel_elevation = heli_1 * c_elevation * s_pitch;
    const double arm_1_1 = arm_1 + L_a_L_a_m_heli + heli_1_c_pitch - arm_2;
    const double arm_1_2 = 2.0 * p->d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    const double arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    /* kinetic energy rotor */
    const double M_s_s = p->m_s + p->J_m * r_s * r_s;
    /* M = L^T D L and back-substitution */
    const double pivot_elevation = M_elevation_elevation - M_elevation_s * M_elevation_s / M_s_s;
    const double solve_1 = arm_2 + arm_1_3 - M_travel_elevation * M_travel_elevation / pivot_elevation;
    const double pivot_travel = solve_1 - M_travel_pitch * M_travel_pitch / I_heli_xx;
    d[0] = pivot_travel; /* travel */
    d[1] = pivot_elevation; /* elevation */
    d[2] = I_heli_xx; /* pitch */
    d[3] = M_s_s; /* s */
}

int quanser_ads_driven_forward_dynamics(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    struct quanser_ads_driven_accelerations *a)
{
    const struct quanser_ads_driven_coordinates *q = &x->q;
    const struct quanser_ads_driven_rates *v = &x->v;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double r_s = 6.283185307179586 * p->n_g / p->lead;
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    const double K_t_r_s = p->K_t * r_s;
    const double i_m = (u->V_s_motor - K_t_r_s * v->s) / p->R_m;
    const double s_plus_s_0 = q->s + p->s_0;
    /* frame rail on arm */
    const double M_elevation_s = p->d * p->m_s;
    const double m_s_s_plus_s_0 = p->m_s * s_plus_s_0;
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
    const double arm_2 = I_arm_yy + s_plus_s_0 * m_s_s_plus_s_0;
    const double d_d_m_heli_plus_m_w_plus_m_s = p->d * p->d * (m_heli + p->m_w + p->m_s);
    const double arm_3 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    /* frame heli on arm */
    const double a_heli_1_y = p->L_a * two_alpha_arm_1_z + a_arm_y;
    const double a_heli_1_z = p->L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    /* frame rail on arm */
    const double a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + 2.0 * omega_arm_1_z * v->s;
    const double f_moving_rail_y = p->m_s * a_rail_y;
    const double a_rail_z = 2.0 * v->elevation * v->s + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    const double f_rail_x = p->m_s * (a_arm_x - s_plus_s_0 * arm_1);
    /* frame arm on column */
    const double arm_4 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    const double arm_5 = mc_arm_x * a_arm_z_2 + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p->m_s * s_plus_s_0 * a_rail_z;
    const double M_elevation_elevation = arm_2 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    /* frame heli on arm */
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_heli_x = m_heli * (a_arm_x - p->L_a * arm_1);
    const double f_heli_y = m_heli * a_heli_y;
    /* frame arm on column */
    const double f_arm_x = f_heli_x - mc_arm_x * arm_1 + p->m_w * a_arm_x + f_rail_x;
    const double arm_1_1 = arm_2 + L_a_L_a_m_heli + heli_1_c_pitch - arm_3;
    const double arm_1_2 = 2.0 * p->d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    const double arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    /* kinetic energy rotor */
    const double M_s_s = p->m_s + p->J_m * r_s * r_s;
    /* force back on heli */
    const double n_applied_heli_x = p->L_h * F_f - p->L_h * F_b;
    /* frame rail on arm */
    const double f_net_heli_z = m_heli * a_heli_z - F_f - F_b;
    const double n_net_heli_x = n_moving_heli_x - n_applied_heli_x;
    /* frame heli on arm */
    const double f_net_heli_1_y = f_heli_y * c_pitch - f_net_heli_z * s_pitch;
    const double f_net_heli_1_z = f_heli_y * s_pitch + f_net_heli_z * c_pitch;
    /* frame arm on column */
    const double f_net_arm_y = f_moving_rail_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_net_heli_1_y;
    const double n_net_arm_y = -arm_5 - n_moving_heli_z * s_pitch - p->L_a * f_net_heli_1_z;
    const double n_net_arm_z = arm_4 + n_moving_heli_z * c_pitch + p->L_a * f_net_heli_1_y;
    const double n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p->d * f_net_arm_y);
    /* balance of forces */
    const double tau_elevation = n_net_arm_y - p->c_elevation * v->elevation - p->d * f_arm_x;
    const double tau_pitch = -p->c_pitch * v->pitch - n_net_heli_x;
    const double tau_s = K_t_r_s * i_m - p->c_s * v->s - f_rail_x;
    /* M = L^T D L and back-substitution */
    const double inv_s = 1.0 / M_s_s;
    const double l_s_elevation = M_elevation_s * inv_s;
    const double inv_pitch = 1.0 / I_heli_xx;
    const double l_pitch_travel = M_travel_pitch * inv_pitch;
    const double pivot_elevation = M_elevation_elevation - M_elevation_s * l_s_elevation;
    const double inv_elevation = 1.0 / pivot_elevation;
    const double l_elevation_travel = M_travel_elevation * inv_elevation;
    const double solve_1 = arm_3 + arm_1_3 - M_travel_elevation * l_elevation_travel;
    const double pivot_travel = solve_1 - M_travel_pitch * l_pitch_travel;
    const double solve_2 = tau_elevation - tau_s * l_s_elevation;
    const double solve_3 = l_elevation_travel * solve_2 + p->c_travel * v->travel + n_net_column_z;
    const double travel_ddot = (-solve_3 - tau_pitch * l_pitch_travel) / pivot_travel;
    const double elevation_ddot = inv_elevation * solve_2 - l_elevation_travel * travel_ddot;
    const double pitch_ddot = tau_pitch * inv_pitch - l_pitch_travel * travel_ddot;
    const double s_ddot = tau_s * inv_s - l_s_elevation * elevation_ddot;
    if (!(M_s_s > 0.0)) {
        return 4;
    }
    if (!(I_heli_xx > 0.0)) {
        return 3;
    }
    if (!(pivot_elevation > 0.0)) {
        return 2;
    }
    if (!(pivot_travel > 0.0)) {
        return 1;
    }
    a->travel = travel_ddot;
    a->elevation = elevation_ddot;
    a->pitch = pitch_ddot;
    a->s = s_ddot;
    return 0;
}

int quanser_ads_driven_linearize(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    double dx[8],
    double a[8][8],
    double b[8][3])
{
    const struct quanser_ads_driven_coordinates *q = &x->q;
    const struct quanser_ads_driven_rates *v = &x->v;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double r_s = 6.283185307179586 * p->n_g / p->lead;
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    const double K_t_r_s = p->K_t * r_s;
    const double i_m = (u->V_s_motor - K_t_r_s * v->s) / p->R_m;
    const double s_plus_s_0 = q->s + p->s_0;
    const double two_elevation_dot_s_dot = 2.0 * v->elevation * v->s;
    /* frame rail on arm */
    const double M_elevation_s = p->d * p->m_s;
    const double m_s_s_plus_s_0 = p->m_s * s_plus_s_0;
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
    const double arm_3 = I_arm_yy + s_plus_s_0 * m_s_s_plus_s_0;
    const double d_d_m_heli_plus_m_w_plus_m_s = p->d * p->d * (m_heli + p->m_w + p->m_s);
    const double arm_4 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    /* frame heli on arm */
    const double a_heli_1_y = p->L_a * two_alpha_arm_1_z + a_arm_y;
    const double a_heli_1_z = p->L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    const double two_omega_arm_1_z_s_dot = 2.0 * omega_arm_1_z * v->s;
    /* frame rail on arm */
    const double a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + two_omega_arm_1_z_s_dot;
    const double f_moving_rail_y = p->m_s * a_rail_y;
    const double a_rail_z = two_elevation_dot_s_dot + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    const double f_rail_x = p->m_s * (a_arm_x - s_plus_s_0 * arm_1);
    /* frame arm on column */
    const double arm_5 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy_alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    const double arm_6 = mc_arm_x * a_arm_z + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p->m_s * s_plus_s_0 * a_rail_z;
    const double M_elevation_elevation = arm_3 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    /* frame heli on arm */
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_heli_x = m_heli * (a_arm_x - p->L_a * arm_1);
    const double f_heli_y = m_heli * a_heli_y;
    /* frame arm on column */
    const double f_arm_x = f_heli_x - mc_arm_x * arm_1 + p->m_w * a_arm_x + f_rail_x;
    const double arm_1_1 = arm_3 + L_a_L_a_m_heli + heli_1_c_pitch - arm_4;
    const double arm_1_2 = 2.0 * p->d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    const double arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    /* kinetic energy rotor */
    const double M_s_s = p->m_s + p->J_m * r_s * r_s;
    /* force back on heli */
    const double f_applied_heli_z = F_f + F_b;
    const double n_applied_heli_x = p->L_h * F_f - p->L_h * F_b;
    const double c_elevation_elevation_dot = c_elevation * v->elevation;
    const double s_elevation_elevation_dot = s_elevation * v->elevation;
    const double omega_arm_1_x_c_pitch = omega_arm_1_x * c_pitch;
    /* gravity */
    const double gravity_1 = c_pitch_elevation_dot - omega_arm_1_z_s_pitch;
    /* frame rail on arm */
    const double f_net_heli_z = m_heli * a_heli_z - f_applied_heli_z;
    const double n_net_heli_x = I_heli_xx * alpha_arm_1_x + heli_2 - n_applied_heli_x;
    /* frame heli on arm */
    const double f_net_heli_1_y = f_heli_y * c_pitch - f_net_heli_z * s_pitch;
    const double f_net_heli_1_z = f_heli_y * s_pitch + f_net_heli_z * c_pitch;
    /* frame arm on column */
    const double f_net_arm_y = f_moving_rail_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_net_heli_1_y;
    const double n_net_arm_y = -arm_6 - n_moving_heli_z * s_pitch - p->L_a * f_net_heli_1_z;
    const double n_net_arm_z = arm_5 + n_moving_heli_z * c_pitch + p->L_a * f_net_heli_1_y;
    const double n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p->d * f_net_arm_y);
    /* balance of forces */
    const double tau_elevation = n_net_arm_y - p->c_elevation * v->elevation - p->d * f_arm_x;
    const double tau_pitch = -p->c_pitch * v->pitch - n_net_heli_x;
    const double tau_s = K_t_r_s * i_m - p->c_s * v->s - f_rail_x;
    /* M = L^T D L and back-substitution */
    const double inv_s = 1.0 / M_s_s;
    const double l_s_elevation = M_elevation_s * inv_s;
    const double inv_pitch = 1.0 / I_heli_xx;
    const double l_pitch_travel = M_travel_pitch * inv_pitch;
    const double pivot_elevation = M_elevation_elevation - M_elevation_s * l_s_elevation;
    const double inv_elevation = 1.0 / pivot_elevation;
    const double l_elevation_travel = M_travel_elevation * inv_elevation;
    const double solve_1 = arm_4 + arm_1_3 - M_travel_elevation * l_elevation_travel;
    const double pivot_travel = solve_1 - M_travel_pitch * l_pitch_travel;
    const double inv_travel = 1.0 / pivot_travel;
    const double solve_2 = tau_elevation - tau_s * l_s_elevation;
    const double solve_3 = l_elevation_travel * solve_2 + p->c_travel * v->travel + n_net_column_z;
    const double travel_ddot = inv_travel * (-solve_3 - tau_pitch * l_pitch_travel);
    const double elevation_ddot = inv_elevation * solve_2 - l_elevation_travel * travel_ddot;
    const double pitch_ddot = tau_pitch * inv_pitch - l_pitch_travel * travel_ddot;
    const double s_ddot = tau_s * inv_s - l_s_elevation * elevation_ddot;
    const double L_h_K_f = p->L_h * p->K_f;
    const double K_f_s_pitch = p->K_f * s_pitch;
    const double L_a_K_f_c_pitch = p->L_a * p->K_f * c_pitch;
    const double d_K_f_s_pitch = p->d * K_f_s_pitch;
    const double L_a_K_f_s_pitch_c_elevation = p->L_a * K_f_s_pitch * c_elevation;
    /* input map */
    const double input_map_1 = L_a_K_f_s_pitch_c_elevation + s_elevation * (L_h_K_f + d_K_f_s_pitch);
    const double K_t_r_s_inv_R_m = K_t_r_s / p->R_m;
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
    const double by_elevation_7 = p->m_s * (s_plus_s_0 * by_elevation_1 + a_arm_1_z_minus_d_arm_2);
    const double by_elevation_8 = p->m_s * s_plus_s_0 * (by_elevation_4 + s_plus_s_0 * arm_2);
    const double by_elevation_9 = p->m_w * a_arm_1_z_minus_d_arm_2 + mc_arm_x * by_elevation_1 + by_elevation_7;
    const double by_elevation_10 = mc_arm_x * by_elevation_4 + I_arm_yy * arm_2 + by_elevation_8;
    const double by_elevation_11 = p->d * (by_elevation_6 + by_elevation_9);
    /* derivatives with respect to pitch */
    const double by_pitch_1 = I_heli_xx * (omega_heli_z * omega_heli_z + omega_heli_y * gravity_1);
    const double m_s_arm_1 = p->m_s * arm_1;
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
    const double by_travel_dot_8 = mc_arm_x * by_travel_dot_6 - 2.0 * I_arm_yy * s_elevation_elevation_dot;
    const double by_travel_dot_9 = by_travel_dot_6 - p->L_a * by_travel_dot_7;
    const double by_travel_dot_10 = by_travel_dot_2 + p->L_a * by_travel_dot_1;
    const double by_travel_dot_11 = m_heli * (p->L_a * by_travel_dot_3 + d_by_travel_dot_1);
    const double by_travel_dot_12 = m_heli * (by_travel_dot_9 * c_pitch + by_travel_dot_10 * s_pitch);
    const double by_travel_dot_13 = m_heli * (by_travel_dot_10 * c_pitch - by_travel_dot_9 * s_pitch);
    const double by_travel_dot_14 = I_heli_xx * (s_elevation_elevation_dot * c_pitch + c_elevation_s_pitch * v->pitch);
    const double by_travel_dot_15 = I_heli_xx * by_travel_dot_4 + I_heli_xx * c_elevation_elevation_dot;
    const double by_travel_dot_16 = by_travel_dot_5 + by_travel_dot_14;
    const double by_travel_dot_17 = 2.0 * c_elevation * v->s + by_travel_dot_6 - s_plus_s_0 * by_travel_dot_7;
    const double by_travel_dot_18 = p->m_s * (s_plus_s_0 * by_travel_dot_3 + d_by_travel_dot_1);
    const double m_s_by_travel_dot_17 = p->m_s * by_travel_dot_17;
    const double by_travel_dot_19 = p->m_s * s_plus_s_0 * (by_travel_dot_2 + s_plus_s_0 * by_travel_dot_1);
    const double by_travel_dot_20 = mc_arm_x * by_travel_dot_3 + p->m_w * d_by_travel_dot_1 + by_travel_dot_18;
    const double by_travel_dot_21 = p->m_w * by_travel_dot_6 - mc_arm_x * by_travel_dot_7 + m_s_by_travel_dot_17;
    const double by_travel_dot_22 = mc_arm_x * by_travel_dot_2 + I_arm_yy * by_travel_dot_1 + by_travel_dot_19;
    const double by_travel_dot_23 = by_travel_dot_12 * c_pitch - by_travel_dot_13 * s_pitch;
    const double by_travel_dot_24 = p->L_a * (by_travel_dot_12 * s_pitch + by_travel_dot_13 * c_pitch);
    const double by_travel_dot_25 = p->L_a * by_travel_dot_23 - by_travel_dot_16 * c_pitch;
    const double by_travel_dot_26 = by_travel_dot_16 * s_pitch - by_travel_dot_22 - by_travel_dot_24;
    const double by_travel_dot_27 = by_travel_dot_8 + s_plus_s_0 * m_s_by_travel_dot_17 + by_travel_dot_25;
    const double by_travel_dot_28 = p->d * (-by_travel_dot_20 - by_travel_dot_11);
    const double by_travel_dot_29 = s_elevation * (by_travel_dot_15 + p->d * (by_travel_dot_21 + by_travel_dot_23));
    const double by_travel_dot_30 = p->c_travel + by_travel_dot_27 * c_elevation + by_travel_dot_29;
    const double by_travel_dot_31 = by_travel_dot_26 - by_travel_dot_28 - l_s_elevation * by_travel_dot_18;
    const double by_travel_dot_32 = l_pitch_travel * by_travel_dot_15 - l_elevation_travel * by_travel_dot_31 - by_travel_dot_30;
    const double d_travel_ddot_by_travel_dot = inv_travel * by_travel_dot_32;
    const double d_elevation_ddot_by_travel_dot = inv_elevation * by_travel_dot_31 - l_elevation_travel * d_travel_ddot_by_travel_dot;
    const double d_pitch_ddot_by_travel_dot = -inv_pitch * by_travel_dot_15 - l_pitch_travel * d_travel_ddot_by_travel_dot;
    const double d_s_ddot_by_travel_dot = inv_s * by_travel_dot_18 - l_s_elevation * d_elevation_ddot_by_travel_dot;
    const double two_elevation_dot = 2.0 * v->elevation;
    const double d_two_elevation_dot = p->d * two_elevation_dot;
    /* derivatives with respect to elevation_dot */
    const double by_elevation_dot_1 = I_heli_xx * (omega_heli_y * s_pitch - omega_heli_z * c_pitch);
    const double d_two_omega_arm_1_z = p->d * two_omega_arm_1_z;
    const double two_omega_arm_1_x_2 = 2.0 * omega_arm_1_x;
    const double by_elevation_dot_2 = mc_arm_x * d_two_omega_arm_1_z - 2.0 * I_arm_yy * omega_arm_1_x;
    const double by_elevation_dot_3 = d_two_omega_arm_1_z - p->L_a * two_omega_arm_1_x_2;
    const double by_elevation_dot_4 = m_heli * (by_elevation_dot_3 * c_pitch + d_two_elevation_dot * s_pitch);
    const double by_elevation_dot_5 = m_heli * (d_two_elevation_dot * c_pitch - by_elevation_dot_3 * s_pitch);
    const double by_elevation_dot_6 = I_heli_xx * (c_pitch * v->pitch - omega_arm_1_x_c_pitch);
    const double by_elevation_dot_7 = by_elevation_dot_1 + I_heli_xx * omega_arm_1_z;
    const double by_elevation_dot_8 = by_elevation_dot_6 + two_L_h_L_h_m_h_per_two * omega_heli_x * c_pitch;
    const double by_elevation_dot_9 = p->m_s * s_plus_s_0 * two_elevation_dot;
    const double by_elevation_dot_10 = p->m_s * (d_two_omega_arm_1_z - s_plus_s_0 * two_omega_arm_1_x_2);
    const double by_elevation_dot_11 = p->m_w * d_two_omega_arm_1_z - mc_arm_x * two_omega_arm_1_x_2 + by_elevation_dot_10;
    const double by_elevation_dot_12 = mc_arm_x * d_two_elevation_dot + p->m_s * s_plus_s_0 * (d_two_elevation_dot + 2.0 * v->s);
    const double by_elevation_dot_13 = by_elevation_dot_4 * c_pitch - by_elevation_dot_5 * s_pitch;
    const double by_elevation_dot_14 = p->L_a * (by_elevation_dot_4 * s_pitch + by_elevation_dot_5 * c_pitch);
    const double by_elevation_dot_15 = by_elevation_dot_8 * c_pitch + p->L_a * by_elevation_dot_13;
    const double by_elevation_dot_16 = by_elevation_dot_12 + by_elevation_dot_8 * s_pitch + by_elevation_dot_14;
    const double by_elevation_dot_17 = by_elevation_dot_2 + s_plus_s_0 * by_elevation_dot_10 + by_elevation_dot_15;
    const double by_elevation_dot_18 = p->d * (-mc_arm_x * two_elevation_dot - by_elevation_dot_9 - p->L_a * m_heli * two_elevation_dot);
    const double by_elevation_dot_19 = s_elevation * (by_elevation_dot_7 + p->d * (by_elevation_dot_11 + by_elevation_dot_13));
    const double by_elevation_dot_20 = by_elevation_dot_17 * c_elevation + by_elevation_dot_19;
    const double by_elevation_dot_21 = p->c_elevation + by_elevation_dot_18 + by_elevation_dot_16 + l_s_elevation * by_elevation_dot_9;
    const double by_elevation_dot_22 = l_pitch_travel * by_elevation_dot_7 - by_elevation_dot_20 + l_elevation_travel * by_elevation_dot_21;
    const double d_travel_ddot_by_elevation_dot = inv_travel * by_elevation_dot_22;
    const double d_elevation_ddot_by_elevation_dot = -l_elevation_travel * d_travel_ddot_by_elevation_dot
        - inv_elevation * by_elevation_dot_21;
    const double d_pitch_ddot_by_elevation_dot = -inv_pitch * by_elevation_dot_7 - l_pitch_travel * d_travel_ddot_by_elevation_dot;
    const double d_s_ddot_by_elevation_dot = inv_s * by_elevation_dot_9 - l_s_elevation * d_elevation_ddot_by_elevation_dot;
    /* derivatives with respect to pitch_dot */
    const double by_pitch_dot_1 = I_heli_xx * gravity_1 - omega_heli_y * two_L_h_L_h_m_h_per_two;
    const double by_pitch_dot_1_s_pitch = by_pitch_dot_1 * s_pitch;
    const double by_pitch_dot_2 = by_pitch_dot_1 * c_elevation * c_pitch;
    const double by_pitch_dot_3 = p->c_pitch * l_pitch_travel - by_pitch_dot_2 + l_elevation_travel * by_pitch_dot_1_s_pitch;
    const double d_travel_ddot_by_pitch_dot = inv_travel * by_pitch_dot_3;
    const double d_elevation_ddot_by_pitch_dot = -l_elevation_travel * d_travel_ddot_by_pitch_dot - inv_elevation * by_pitch_dot_1_s_pitch;
    const double d_pitch_ddot_by_pitch_dot = -p->c_pitch * inv_pitch - l_pitch_travel * d_travel_ddot_by_pitch_dot;
    const double m_s_two_omega_arm_1_z = p->m_s * two_omega_arm_1_z;
    /* derivatives with respect to s_dot */
    const double by_s_dot_1 = s_plus_s_0 * m_s_two_omega_arm_1_z * c_elevation;
    const double by_s_dot_2 = by_s_dot_1 + p->d * m_s_two_omega_arm_1_z * s_elevation;
    const double by_s_dot_3 = p->c_s + K_t_r_s * K_t_r_s / p->R_m;
    const double by_s_dot_4 = l_s_elevation * by_s_dot_3 - p->m_s * s_plus_s_0 * two_elevation_dot;
    const double d_travel_ddot_by_s_dot = inv_travel * (-l_elevation_travel * by_s_dot_4 - by_s_dot_2);
    const double d_elevation_ddot_by_s_dot = inv_elevation * by_s_dot_4 - l_elevation_travel * d_travel_ddot_by_s_dot;
    const double d_s_ddot_by_s_dot = -inv_s * by_s_dot_3 - l_s_elevation * d_elevation_ddot_by_s_dot;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_1 = alpha_arm_1_x + travel_ddot * s_elevation;
    const double slopes_2 = travel_ddot * c_elevation + alpha_arm_1_z;
    const double alpha_arm_1_x_plus_slopes_1 = alpha_arm_1_x + slopes_1;
    const double slopes_3 = p->d * alpha_arm_1_x_plus_slopes_1;
    const double slopes_2_plus_alpha_arm_1_z = slopes_2 + alpha_arm_1_z;
    const double slopes_4 = omega_arm_1_z_omega_arm_1_x + elevation_ddot;
    const double slopes_5 = I_arm_yy * slopes_2 + I_arm_yy_alpha_arm_1_z + mc_arm_x * slopes_3;
    const double slopes_6 = slopes_3 + p->L_a * slopes_2_plus_alpha_arm_1_z;
    const double a_arm_z_plus_L_a_slopes_4 = a_arm_z + p->L_a * slopes_4;
    const double slopes_7 = elevation_ddot * s_pitch + slopes_2 * c_pitch - omega_heli_y_pitch_dot;
    const double slopes_8 = m_heli * (slopes_6 * c_pitch + a_arm_z_plus_L_a_slopes_4 * s_pitch);
    const double slopes_9 = m_heli * (a_arm_z_plus_L_a_slopes_4 * c_pitch - slopes_6 * s_pitch);
    const double slopes_10 = I_heli_xx * slopes_7 - heli_3;
    const double slopes_11 = p->m_s * (two_omega_arm_1_z_s_dot + slopes_3 + s_plus_s_0 * slopes_2_plus_alpha_arm_1_z);
    const double slopes_12 = p->m_s * (two_elevation_dot_s_dot + a_arm_z + s_plus_s_0 * slopes_4);
    const double slopes_13 = slopes_9 - f_applied_heli_z;
    const double slopes_14 = heli_2 + I_heli_xx * (slopes_1 + pitch_ddot) - n_applied_heli_x;
    const double slopes_15 = p->m_w * slopes_3 + mc_arm_x * slopes_2_plus_alpha_arm_1_z + slopes_11;
    const double slopes_16 = slopes_5 + s_plus_s_0 * slopes_11;
    const double slopes_8_c_pitch = slopes_8 * c_pitch;
    const double slopes_13_s_pitch = slopes_13 * s_pitch;
    const double slopes_8_s_pitch = slopes_8 * s_pitch;
    const double slopes_17 = slopes_8_c_pitch - slopes_13_s_pitch;
    const double slopes_10_c_pitch = slopes_10 * c_pitch;
    const double slopes_18 = s_elevation * (slopes_16 + slopes_10_c_pitch + p->L_a * slopes_17);
    const double slopes_19 = c_elevation * (slopes_14 + p->d * (slopes_15 + slopes_17));
    const double slopes_20 = p->d * slopes_2_plus_alpha_arm_1_z;
    const double slopes_21 = I_arm_yy * alpha_arm_1_x - mc_arm_x * slopes_20 + I_arm_yy * slopes_1;
    const double slopes_22 = slopes_20 - p->L_a * alpha_arm_1_x_plus_slopes_1;
    const double slopes_23 = m_heli * (by_elevation_5 * s_pitch + slopes_22 * c_pitch);
    const double slopes_24 = m_heli * (by_elevation_5 * c_pitch - slopes_22 * s_pitch);
    const double I_heli_xx_slopes_2 = I_heli_xx * slopes_2;
    const double slopes_25 = I_heli_xx * (omega_arm_1_x_s_pitch * v->pitch - slopes_1 * c_pitch);
    const double slopes_26 = slopes_25 - by_elevation_3;
    const double slopes_27 = p->m_s * (slopes_20 - 2.0 * omega_arm_1_x * v->s - s_plus_s_0 * alpha_arm_1_x_plus_slopes_1);
    const double slopes_28 = p->m_w * slopes_20 - mc_arm_x * alpha_arm_1_x_plus_slopes_1 + slopes_27;
    const double slopes_29 = slopes_23 * c_pitch - slopes_24 * s_pitch;
    const double slopes_30 = p->L_a * (slopes_23 * s_pitch + slopes_24 * c_pitch);
    const double slopes_31 = slopes_26 * c_pitch + p->L_a * slopes_29;
    const double slopes_32 = by_elevation_10 + slopes_26 * s_pitch + slopes_30;
    const double slopes_33 = s_plus_s_0 * slopes_27 - slopes_21 + slopes_31;
    const double slopes_34 = I_heli_xx_slopes_2 - by_elevation_2 + p->d * (slopes_28 + slopes_29);
    const double slopes_35 = slopes_19 + slopes_34 * s_elevation;
    const double slopes_36 = slopes_33 * c_elevation - slopes_18 + slopes_35;
    const double slopes_37 = elevation_ddot * c_pitch - slopes_2 * s_pitch;
    const double slopes_38 = I_heli_xx * (slopes_37 - omega_heli_z * v->pitch);
    const double slopes_39 = slopes_38 - omega_heli_z * omega_heli_x * two_L_h_L_h_m_h_per_two;
    const double slopes_40 = slopes_13 * c_pitch - slopes_8_s_pitch;
    const double slopes_41 = slopes_8_c_pitch + slopes_9 * s_pitch;
    const double slopes_42 = slopes_9 * c_pitch - slopes_8_s_pitch - slopes_40;
    const double slopes_43 = slopes_39 * c_pitch - slopes_10 * s_pitch;
    const double slopes_44 = p->L_a * (slopes_41 - slopes_8_c_pitch - slopes_13_s_pitch);
    const double slopes_45 = slopes_10_c_pitch + slopes_39 * s_pitch + slopes_44;
    const double slopes_46 = c_elevation * (slopes_43 + p->L_a * slopes_42);
    const double slopes_47 = slopes_46 + s_elevation * (by_pitch_1 + p->d * slopes_42);
    const double slopes_48 = p->m_s * slopes_2_plus_alpha_arm_1_z;
    const double slopes_49 = c_elevation * (slopes_11 + s_plus_s_0 * slopes_48);
    const double slopes_50 = slopes_49 + p->d * slopes_48 * s_elevation;
    /* derivatives with respect to elevation */
    const double by_elevation_12 = by_elevation_2 - I_heli_xx_slopes_2;
    const double by_elevation_13 = l_s_elevation * by_elevation_7 - slopes_32 - by_elevation_11;
    const double by_elevation_14 = l_elevation_travel * by_elevation_13 + slopes_36 + l_pitch_travel * by_elevation_12;
    const double d_travel_ddot_by_elevation = -inv_travel * by_elevation_14;
    const double d_elevation_ddot_by_elevation = inv_elevation * by_elevation_13 - l_elevation_travel * d_travel_ddot_by_elevation;
    const double d_pitch_ddot_by_elevation = inv_pitch * by_elevation_12 - l_pitch_travel * d_travel_ddot_by_elevation;
    const double d_s_ddot_by_elevation = -inv_s * by_elevation_7 - l_s_elevation * d_elevation_ddot_by_elevation;
    /* derivatives with respect to pitch */
    const double by_pitch_2 = l_pitch_travel * by_pitch_1 - slopes_47 + l_elevation_travel * slopes_45;
    const double d_travel_ddot_by_pitch = inv_travel * by_pitch_2;
    const double d_elevation_ddot_by_pitch = -l_elevation_travel * d_travel_ddot_by_pitch - inv_elevation * slopes_45;
    const double d_pitch_ddot_by_pitch = -inv_pitch * by_pitch_1 - l_pitch_travel * d_travel_ddot_by_pitch;
    /* derivatives with respect to s */
    const double by_s_1 = p->d * m_s_arm_1 - slopes_12 - p->m_s * s_plus_s_0 * slopes_4;
    const double by_s_2 = by_s_1 - l_s_elevation * m_s_arm_1;
    const double d_travel_ddot_by_s = inv_travel * (-l_elevation_travel * by_s_2 - slopes_50);
    const double d_elevation_ddot_by_s = inv_elevation * by_s_2 - l_elevation_travel * d_travel_ddot_by_s;
    const double d_s_ddot_by_s = inv_s * m_s_arm_1 - l_s_elevation * d_elevation_ddot_by_s;
    /* derivatives with respect to V_f */
    const double by_V_f_1 = L_a_K_f_s_pitch_c_elevation + s_elevation * (d_K_f_s_pitch - L_h_K_f);
    const double by_V_f_2 = l_elevation_travel * L_a_K_f_c_pitch;
    const double l_pitch_travel_L_h_K_f = l_pitch_travel * L_h_K_f;
    const double d_travel_ddot_by_V_f = inv_travel * (-by_V_f_2 - by_V_f_1 - l_pitch_travel_L_h_K_f);
    const double by_V_f_3 = inv_elevation * L_a_K_f_c_pitch;
    const double inv_pitch_L_h_K_f = inv_pitch * L_h_K_f;
    const double d_elevation_ddot_by_V_f = by_V_f_3 - l_elevation_travel * d_travel_ddot_by_V_f;
    /* derivatives with respect to V_b */
    const double d_travel_ddot_by_V_b = inv_travel * (l_pitch_travel_L_h_K_f - by_V_f_2 - input_map_1);
    const double d_elevation_ddot_by_V_b = by_V_f_3 - l_elevation_travel * d_travel_ddot_by_V_b;
    /* derivatives with respect to V_s_motor */
    const double by_V_s_motor_1 = l_s_elevation * K_t_r_s_inv_R_m;
    const double d_travel_ddot_by_V_s_motor = inv_travel * l_elevation_travel * by_V_s_motor_1;
    const double d_elevation_ddot_by_V_s_motor = -inv_elevation * by_V_s_motor_1 - l_elevation_travel * d_travel_ddot_by_V_s_motor;
    const double d_s_ddot_by_V_s_motor = inv_s * K_t_r_s_inv_R_m - l_s_elevation * d_elevation_ddot_by_V_s_motor;
    if (!(M_s_s > 0.0)) {
        return 4;
    }
    if (!(I_heli_xx > 0.0)) {
        return 3;
    }
    if (!(pivot_elevation > 0.0)) {
        return 2;
    }
    if (!(pivot_travel > 0.0)) {
        return 1;
    }
    dx[0] = v->travel; /* travel' */
    dx[1] = v->elevation; /* elevation' */
    dx[2] = v->pitch; /* pitch' */
    dx[3] = v->s; /* s' */
    dx[4] = travel_ddot; /* travel'' */
    dx[5] = elevation_ddot; /* elevation'' */
    dx[6] = pitch_ddot; /* pitch'' */
    dx[7] = s_ddot; /* s'' */
    for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 8; j++) {
            a[i][j] = 0.0;
        }
    }
    a[0][4] = 1.0; /* travel' */
    a[1][5] = 1.0; /* elevation' */
    a[2][6] = 1.0; /* pitch' */
    a[3][7] = 1.0; /* s' */
    a[4][1] = d_travel_ddot_by_elevation; /* travel'' */
    a[4][2] = d_travel_ddot_by_pitch;
    a[4][3] = d_travel_ddot_by_s;
    a[4][4] = d_travel_ddot_by_travel_dot;
    a[4][5] = d_travel_ddot_by_elevation_dot;
    a[4][6] = d_travel_ddot_by_pitch_dot;
    a[4][7] = d_travel_ddot_by_s_dot;
    a[5][1] = d_elevation_ddot_by_elevation; /* elevation'' */
    a[5][2] = d_elevation_ddot_by_pitch;
    a[5][3] = d_elevation_ddot_by_s;
    a[5][4] = d_elevation_ddot_by_travel_dot;
    a[5][5] = d_elevation_ddot_by_elevation_dot;
    a[5][6] = d_elevation_ddot_by_pitch_dot;
    a[5][7] = d_elevation_ddot_by_s_dot;
    a[6][1] = d_pitch_ddot_by_elevation; /* pitch'' */
    a[6][2] = d_pitch_ddot_by_pitch;
    a[6][3] = -l_pitch_travel * d_travel_ddot_by_s;
    a[6][4] = d_pitch_ddot_by_travel_dot;
    a[6][5] = d_pitch_ddot_by_elevation_dot;
    a[6][6] = d_pitch_ddot_by_pitch_dot;
    a[6][7] = -l_pitch_travel * d_travel_ddot_by_s_dot;
    a[7][1] = d_s_ddot_by_elevation; /* s'' */
    a[7][2] = -l_s_elevation * d_elevation_ddot_by_pitch;
    a[7][3] = d_s_ddot_by_s;
    a[7][4] = d_s_ddot_by_travel_dot;
    a[7][5] = d_s_ddot_by_elevation_dot;
    a[7][6] = -l_s_elevation * d_elevation_ddot_by_pitch_dot;
    a[7][7] = d_s_ddot_by_s_dot;
    for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 3; j++) {
            b[i][j] = 0.0;
        }
    }
    b[4][0] = d_travel_ddot_by_V_f; /* travel'' */
    b[4][1] = d_travel_ddot_by_V_b;
    b[4][2] = d_travel_ddot_by_V_s_motor;
    b[5][0] = d_elevation_ddot_by_V_f; /* elevation'' */
    b[5][1] = d_elevation_ddot_by_V_b;
    b[5][2] = d_elevation_ddot_by_V_s_motor;
    b[6][0] = inv_pitch_L_h_K_f - l_pitch_travel * d_travel_ddot_by_V_f; /* pitch'' */
    b[6][1] = -inv_pitch_L_h_K_f - l_pitch_travel * d_travel_ddot_by_V_b;
    b[6][2] = -l_pitch_travel * d_travel_ddot_by_V_s_motor;
    b[7][0] = -l_s_elevation * d_elevation_ddot_by_V_f; /* s'' */
    b[7][1] = -l_s_elevation * d_elevation_ddot_by_V_b;
    b[7][2] = d_s_ddot_by_V_s_motor;
    return 0;
}

int quanser_ads_driven_parameter_jacobian(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    double by_p[8][19])
{
    const struct quanser_ads_driven_coordinates *q = &x->q;
    const struct quanser_ads_driven_rates *v = &x->v;
    const double s_elevation = sin(q->elevation);
    const double c_elevation = cos(q->elevation);
    const double s_pitch = sin(q->pitch);
    const double c_pitch = cos(q->pitch);
    const double r_s = 6.283185307179586 * p->n_g / p->lead;
    const double V_s = u->V_f + u->V_b;
    const double F_f = p->K_f * u->V_f;
    const double F_b = p->K_f * u->V_b;
    const double K_t_r_s = p->K_t * r_s;
    const double i_m = (u->V_s_motor - K_t_r_s * v->s) / p->R_m;
    const double s_plus_s_0 = q->s + p->s_0;
    const double two_elevation_dot_s_dot = 2.0 * v->elevation * v->s;
    /* frame rail on arm */
    const double M_elevation_s = p->d * p->m_s;
    const double m_s_s_elevation = p->m_s * s_elevation;
    const double m_s_s_plus_s_0 = p->m_s * s_plus_s_0;
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
    const double arm_3 = I_arm_yy + s_plus_s_0 * m_s_s_plus_s_0;
    const double d_d_m_heli_plus_m_w_plus_m_s = p->d * p->d * (m_heli + p->m_w + p->m_s);
    const double arm_4 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    const double L_a_arm_2 = p->L_a * arm_2;
    /* frame heli on arm */
    const double a_heli_1_y = p->L_a * two_alpha_arm_1_z + a_arm_y;
    const double a_heli_1_z = p->L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    const double L_a_m_heli = p->L_a * m_heli;
    const double L_a_L_a_m_heli = p->L_a * L_a_m_heli;
    const double s_plus_s_0_arm_2 = s_plus_s_0 * arm_2;
    const double two_omega_arm_1_z_s_dot = 2.0 * omega_arm_1_z * v->s;
    /* frame rail on arm */
    const double a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + two_omega_arm_1_z_s_dot;
    const double f_moving_rail_y = p->m_s * a_rail_y;
    const double a_rail_z = two_elevation_dot_s_dot + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    const double f_rail_x = p->m_s * (a_arm_x - s_plus_s_0_arm_2);
    /* frame arm on column */
    const double arm_5 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    const double arm_6 = mc_arm_x * a_arm_z + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p->m_s * s_plus_s_0 * a_rail_z;
    const double f_arm_x = m_heli * (a_arm_x - L_a_arm_2) - mc_arm_x_arm_2 + p->m_w * a_arm_x + f_rail_x;
    const double M_elevation_elevation = arm_3 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    /* frame heli on arm */
    const double a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    const double a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    const double f_heli_y = m_heli * a_heli_y;
    /* frame arm on column */
    const double arm_1_1 = arm_3 + L_a_L_a_m_heli + heli_1_c_pitch - arm_4;
    const double arm_1_2 = 2.0 * p->d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    const double arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    const double half_J_m = 0.5 * p->J_m;
    const double two_r_s = 2.0 * r_s;
    const double r_s_two_r_s = r_s * two_r_s;
    /* kinetic energy rotor */
    const double M_s_s = p->m_s + half_J_m * r_s_two_r_s;
    /* force back on heli */
    const double f_applied_heli_z = F_f + F_b;
    const double n_applied_heli_x = p->L_h * F_f - p->L_h * F_b;
    /* frame rail on arm */
    const double f_net_heli_z = m_heli * a_heli_z - f_applied_heli_z;
    const double n_net_heli_x = n_moving_heli_x - n_applied_heli_x;
    /* frame heli on arm */
    const double f_net_heli_1_y = f_heli_y * c_pitch - f_net_heli_z * s_pitch;
    const double f_net_heli_1_z = f_heli_y * s_pitch + f_net_heli_z * c_pitch;
    /* frame arm on column */
    const double f_net_arm_y = f_moving_rail_y + p->m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_net_heli_1_y;
    const double n_net_arm_y = -arm_6 - n_moving_heli_z * s_pitch - p->L_a * f_net_heli_1_z;
    const double n_net_arm_z = arm_5 + n_moving_heli_z * c_pitch + p->L_a * f_net_heli_1_y;
    const double n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p->d * f_net_arm_y);
    /* balance of forces */
    const double tau_elevation = n_net_arm_y - p->c_elevation * v->elevation - p->d * f_arm_x;
    const double tau_pitch = -p->c_pitch * v->pitch - n_net_heli_x;
    const double tau_s = K_t_r_s * i_m - p->c_s * v->s - f_rail_x;
    /* M = L^T D L and back-substitution */
    const double inv_s = 1.0 / M_s_s;
    const double l_s_elevation = M_elevation_s * inv_s;
    const double inv_pitch = 1.0 / I_heli_xx;
    const double l_pitch_travel = M_travel_pitch * inv_pitch;
    const double pivot_elevation = M_elevation_elevation - M_elevation_s * l_s_elevation;
    const double inv_elevation = 1.0 / pivot_elevation;
    const double l_elevation_travel = M_travel_elevation * inv_elevation;
    const double solve_1 = arm_4 + arm_1_3 - M_travel_elevation * l_elevation_travel;
    const double pivot_travel = solve_1 - M_travel_pitch * l_pitch_travel;
    const double inv_travel = 1.0 / pivot_travel;
    const double solve_2 = tau_elevation - tau_s * l_s_elevation;
    const double solve_3 = l_elevation_travel * solve_2 + p->c_travel * v->travel + n_net_column_z;
    const double travel_ddot = inv_travel * (-solve_3 - tau_pitch * l_pitch_travel);
    const double elevation_ddot = inv_elevation * solve_2 - l_elevation_travel * travel_ddot;
    const double pitch_ddot = tau_pitch * inv_pitch - l_pitch_travel * travel_ddot;
    const double s_ddot = tau_s * inv_s - l_s_elevation * elevation_ddot;
    const double m_s_arm_2 = p->m_s * arm_2;
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
    const double slopes_9 = two_omega_arm_1_z_s_dot + slopes_3 + s_plus_s_0 * slopes_2_plus_alpha_arm_1_z;
    const double slopes_10 = two_elevation_dot_s_dot + a_arm_z + s_plus_s_0 * slopes_4;
    const double m_s_slopes_9 = p->m_s * slopes_9;
    const double slopes_11 = m_heli * slopes_8 - f_applied_heli_z;
    const double slopes_12 = m_heli_slopes_7 * c_pitch - slopes_11 * s_pitch;
    const double slopes_13 = m_w_slopes_3 + mc_arm_x * slopes_2_plus_alpha_arm_1_z + m_s_slopes_9 + slopes_12;
    const double slopes_14 = p->m_s * slopes_2_plus_alpha_arm_1_z;
    const double slopes_15 = p->m_s * slopes_10 + p->m_s * s_plus_s_0 * slopes_4;
    const double slopes_16 = c_elevation * (m_s_slopes_9 + s_plus_s_0 * slopes_14);
    const double slopes_17 = slopes_16 + p->d * slopes_14 * s_elevation;
    const double slopes_18 = a_arm_1_x - p->d * (omega_arm_1_z_omega_arm_1_x - elevation_ddot);
    const double slopes_18_minus_L_a_arm_2 = slopes_18 - L_a_arm_2;
    const double slopes_19 = slopes_18 - s_plus_s_0_arm_2;
    const double slopes_19_plus_s_ddot = slopes_19 + s_ddot;
    const double slopes_20 = p->m_w * slopes_18 - mc_arm_x_arm_2 + p->m_s * slopes_19_plus_s_ddot;
    const double slopes_21 = m_heli_slopes_7 * s_pitch + slopes_11 * c_pitch;
    const double slopes_22 = slopes_7 * c_pitch - slopes_8 * s_pitch;
    const double slopes_23 = p->L_a * (slopes_7 * s_pitch + slopes_8 * c_pitch);
    const double d_L_w_arm_2_plus_slopes_18 = p->d * (p->L_w * arm_2 + slopes_18);
    const double slopes_24 = p->d * s_elevation * (slopes_3 - p->L_w * slopes_2_plus_alpha_arm_1_z);
    const double slopes_25 = m_heli * (slopes_2_plus_alpha_arm_1_z * c_pitch + slopes_4 * s_pitch);
    const double slopes_26 = m_heli * (slopes_4 * c_pitch - slopes_2_plus_alpha_arm_1_z * s_pitch);
    const double slopes_27 = slopes_25 * c_pitch - slopes_26 * s_pitch;
    const double slopes_28 = p->L_a * (slopes_25 * s_pitch + slopes_26 * c_pitch);
    const double slopes_29 = c_elevation * (slopes_12 + p->L_a * slopes_27);
    const double slopes_30 = slopes_29 + p->d * slopes_27 * s_elevation;
    const double slopes_31 = elevation_ddot - omega_arm_1_z_omega_arm_1_x;
    const double slopes_32 = m_heli * (arm_1 * s_pitch + alpha_arm_1_x_plus_slopes_1 * c_pitch);
    const double slopes_33 = m_heli * (arm_1 * c_pitch - alpha_arm_1_x_plus_slopes_1 * s_pitch);
    const double m_s_slopes_31 = p->m_s * slopes_31;
    const double slopes_34 = p->m_s * alpha_arm_1_x_plus_slopes_1;
    const double slopes_35 = s_plus_s_0 * slopes_34 + mc_arm_x * alpha_arm_1_x_plus_slopes_1;
    const double slopes_36 = slopes_32 * c_pitch - slopes_33 * s_pitch;
    const double slopes_37 = p->L_a * (slopes_32 * s_pitch + slopes_33 * c_pitch);
    const double slopes_38 = p->d * (p->m_w * alpha_arm_1_x_plus_slopes_1 + slopes_34 + slopes_36);
    const double slopes_39 = p->d * (m_heli * slopes_31 + p->m_w * slopes_31 + m_s_slopes_31);
    const double slopes_40 = m_heli * slopes_18_minus_L_a_arm_2 + slopes_20 + slopes_39;
    const double slopes_41 = c_elevation * (slopes_35 + p->L_a * slopes_36);
    const double slopes_42 = slopes_41 + s_elevation * (slopes_13 + slopes_38);
    const double slopes_43 = s_plus_s_0 * slopes_10 + p->d * slopes_19_plus_s_ddot;
    const double slopes_44 = s_plus_s_0 * slopes_9 * c_elevation;
    const double slopes_45 = slopes_44 + p->d * slopes_9 * s_elevation;
    const double half_s_ddot_r_s_two_r_s = 0.5 * s_ddot * r_s_two_r_s;
    /* derivatives with respect to s */
    const double by_s_1 = p->d * m_s_arm_2 - slopes_15 - l_s_elevation * m_s_arm_2;
    const double d_travel_ddot_by_s = inv_travel * (-l_elevation_travel * by_s_1 - slopes_17);
    const double d_elevation_ddot_by_s = inv_elevation * by_s_1 - l_elevation_travel * d_travel_ddot_by_s;
    const double d_s_ddot_by_s = inv_s * m_s_arm_2 - l_s_elevation * d_elevation_ddot_by_s;
    const double half_L_h_L_h = 0.5 * p->L_h * p->L_h;
    const double two_half_L_h_L_h = 2.0 * half_L_h_L_h;
    const double L_w_sq = p->L_w * p->L_w;
    const double two_mc_arm_x = 2.0 * mc_arm_x;
    const double four_L_h_m_h_per_two = 4.0 * L_h_m_h_per_two;
    const double F_f_minus_F_b = F_f - F_b;
    /* derivatives with respect to d */
    const double by_d_1 = mc_arm_x * arm_1 + p->m_s * s_plus_s_0 * arm_1;
    const double by_d_2 = l_s_elevation * m_s_slopes_31 - by_d_1 - slopes_37 - slopes_40;
    const double d_travel_ddot_by_d = inv_travel * (-l_elevation_travel * by_d_2 - slopes_42);
    const double d_elevation_ddot_by_d = inv_elevation * by_d_2 - l_elevation_travel * d_travel_ddot_by_d;
    const double d_s_ddot_by_d = -inv_s * m_s_slopes_31 - l_s_elevation * d_elevation_ddot_by_d;
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
    const double by_g_1 = mc_arm_x * c_elevation + p->m_s * s_plus_s_0 * c_elevation;
    const double by_g_2 = m_heli_c_elevation_s_pitch * c_pitch - m_heli_c_elevation_c_pitch * s_pitch;
    const double by_g_3 = p->L_a * (m_heli_c_elevation_s_pitch * s_pitch + m_heli_c_elevation_c_pitch * c_pitch);
    const double by_g_4 = p->d * (m_heli * s_elevation + m_s_s_elevation + p->m_w * s_elevation);
    const double by_g_5 = p->L_a * by_g_2 * c_elevation + p->d * by_g_2 * s_elevation;
    const double by_g_6 = m_s_s_elevation * l_s_elevation - by_g_1 - by_g_3 - by_g_4;
    const double d_travel_ddot_by_g = inv_travel * (-l_elevation_travel * by_g_6 - by_g_5);
    const double d_elevation_ddot_by_g = inv_elevation * by_g_6 - l_elevation_travel * d_travel_ddot_by_g;
    const double d_s_ddot_by_g = -m_s_s_elevation * inv_s - l_s_elevation * d_elevation_ddot_by_g;
    const double K_t_r_s_i_m_per_R_m = K_t_r_s * i_m / p->R_m;
    /* derivatives with respect to R_m */
    const double by_R_m_1 = l_s_elevation * K_t_r_s_i_m_per_R_m;
    const double d_travel_ddot_by_R_m = -inv_travel * l_elevation_travel * by_R_m_1;
    const double d_elevation_ddot_by_R_m = inv_elevation * by_R_m_1 - l_elevation_travel * d_travel_ddot_by_R_m;
    const double d_s_ddot_by_R_m = -inv_s * K_t_r_s_i_m_per_R_m - l_s_elevation * d_elevation_ddot_by_R_m;
    /* derivatives with respect to K_t */
    const double by_K_t_1 = r_s * i_m - K_t_r_s * r_s * v->s / p->R_m;
    const double l_s_elevation_by_K_t_1 = l_s_elevation * by_K_t_1;
    const double d_travel_ddot_by_K_t = inv_travel * l_elevation_travel * l_s_elevation_by_K_t_1;
    const double d_elevation_ddot_by_K_t = -inv_elevation * l_s_elevation_by_K_t_1 - l_elevation_travel * d_travel_ddot_by_K_t;
    const double d_s_ddot_by_K_t = inv_s * by_K_t_1 - l_s_elevation * d_elevation_ddot_by_K_t;
    /* derivatives with respect to n_g */
    const double by_n_g_1 = 6.283185307179586 / p->lead;
    const double K_t_by_n_g_1 = p->K_t * by_n_g_1;
    const double by_n_g_2 = half_J_m * (two_r_s * by_n_g_1 + 2.0 * r_s * by_n_g_1);
    const double by_n_g_3 = K_t_r_s * K_t_by_n_g_1 * v->s / p->R_m - i_m * K_t_by_n_g_1;
    const double by_n_g_4 = s_ddot * by_n_g_2 + by_n_g_3;
    const double l_s_elevation_by_n_g_4 = l_s_elevation * by_n_g_4;
    const double d_travel_ddot_by_n_g = -inv_travel * l_elevation_travel * l_s_elevation_by_n_g_4;
    const double d_elevation_ddot_by_n_g = inv_elevation * l_s_elevation_by_n_g_4 - l_elevation_travel * d_travel_ddot_by_n_g;
    const double d_s_ddot_by_n_g = -inv_s * by_n_g_4 - l_s_elevation * d_elevation_ddot_by_n_g;
    const double r_s_per_lead = r_s / p->lead;
    const double K_t_r_s_per_lead = p->K_t * r_s_per_lead;
    /* derivatives with respect to lead */
    const double by_lead_1 = half_J_m * (-2.0 * r_s * r_s_per_lead - two_r_s * r_s_per_lead);
    const double by_lead_2 = i_m * K_t_r_s_per_lead - K_t_r_s * K_t_r_s_per_lead * v->s / p->R_m;
    const double by_lead_3 = s_ddot * by_lead_1 + by_lead_2;
    const double l_s_elevation_by_lead_3 = l_s_elevation * by_lead_3;
    const double d_travel_ddot_by_lead = -inv_travel * l_elevation_travel * l_s_elevation_by_lead_3;
    const double d_elevation_ddot_by_lead = inv_elevation * l_s_elevation_by_lead_3 - l_elevation_travel * d_travel_ddot_by_lead;
    const double d_s_ddot_by_lead = -inv_s * by_lead_3 - l_s_elevation * d_elevation_ddot_by_lead;
    /* slopes of the balance of forces, at the accelerations found */
    const double slopes_46 = omega_heli_y_omega_heli_z * two_half_L_h_L_h + slopes_1_plus_pitch_ddot * two_half_L_h_L_h;
    const double slopes_47 = slopes_6 * two_half_L_h_L_h - 2.0 * heli_3 * half_L_h_L_h;
    const double slopes_48 = slopes_47 * s_pitch + slopes_23 + p->d * slopes_18_minus_L_a_arm_2;
    const double slopes_49 = c_elevation * (slopes_47 * c_pitch + p->L_a * slopes_22);
    const double slopes_50 = slopes_49 + s_elevation * (slopes_46 + p->d * slopes_22);
    const double slopes_51 = slopes_2 * L_w_sq + alpha_arm_1_z * L_w_sq;
    const double slopes_52 = p->L_w * a_arm_z - omega_arm_1_z_omega_arm_1_x * L_w_sq - elevation_ddot * L_w_sq;
    const double slopes_53 = c_elevation * (slopes_51 - p->L_w * slopes_3) + slopes_24;
    const double slopes_54 = p->m_w * a_arm_z + omega_arm_1_z_omega_arm_1_x * two_mc_arm_x + elevation_ddot * two_mc_arm_x;
    const double slopes_55 = slopes_2 * two_mc_arm_x + alpha_arm_1_z * two_mc_arm_x + m_w_slopes_3;
    const double slopes_56 = omega_heli_y_omega_heli_z * four_L_h_m_h_per_two + slopes_1_plus_pitch_ddot * four_L_h_m_h_per_two;
    const double slopes_57 = slopes_6 * four_L_h_m_h_per_two - 4.0 * heli_3 * L_h_m_h_per_two;
    const double slopes_57_s_pitch = slopes_57 * s_pitch;
    const double slopes_58 = s_elevation * (slopes_56 - F_f_minus_F_b);
    const double slopes_59 = slopes_57 * c_elevation * c_pitch + slopes_58;
    /* derivatives with respect to m_h */
    const double by_m_h_1 = l_pitch_travel * slopes_46 - slopes_50 + l_elevation_travel * slopes_48;
    const double d_travel_ddot_by_m_h = inv_travel * by_m_h_1;
    const double d_elevation_ddot_by_m_h = -l_elevation_travel * d_travel_ddot_by_m_h - inv_elevation * slopes_48;
    const double d_pitch_ddot_by_m_h = -inv_pitch * slopes_46 - l_pitch_travel * d_travel_ddot_by_m_h;
    /* derivatives with respect to m_w */
    const double by_m_w_1 = slopes_52 - d_L_w_arm_2_plus_slopes_18;
    const double d_travel_ddot_by_m_w = inv_travel * (-l_elevation_travel * by_m_w_1 - slopes_53);
    const double d_elevation_ddot_by_m_w = inv_elevation * by_m_w_1 - l_elevation_travel * d_travel_ddot_by_m_w;
    /* derivatives with respect to L_a */
    const double by_L_a_1 = p->d * m_heli * arm_2 - slopes_21 - slopes_28;
    const double d_travel_ddot_by_L_a = inv_travel * (-l_elevation_travel * by_L_a_1 - slopes_30);
    const double d_elevation_ddot_by_L_a = inv_elevation * by_L_a_1 - l_elevation_travel * d_travel_ddot_by_L_a;
    /* derivatives with respect to L_w */
    const double by_L_w_1 = p->m_w * p->d * slopes_2_plus_alpha_arm_1_z * s_elevation + slopes_55 * c_elevation;
    const double slopes_54_minus_d_m_w_arm_2 = slopes_54 - p->m_w * p->d * arm_2;
    const double d_travel_ddot_by_L_w = inv_travel * (by_L_w_1 - l_elevation_travel * slopes_54_minus_d_m_w_arm_2);
    const double d_elevation_ddot_by_L_w = inv_elevation * slopes_54_minus_d_m_w_arm_2 - l_elevation_travel * d_travel_ddot_by_L_w;
    /* derivatives with respect to L_h */
    const double by_L_h_1 = F_f_minus_F_b - slopes_56;
    const double by_L_h_2 = slopes_59 - l_elevation_travel * slopes_57_s_pitch + l_pitch_travel * by_L_h_1;
    const double d_travel_ddot_by_L_h = -inv_travel * by_L_h_2;
    const double d_elevation_ddot_by_L_h = -inv_elevation * slopes_57_s_pitch - l_elevation_travel * d_travel_ddot_by_L_h;
    const double d_pitch_ddot_by_L_h = inv_pitch * by_L_h_1 - l_pitch_travel * d_travel_ddot_by_L_h;
    /* derivatives with respect to c_travel */
    const double d_travel_ddot_by_c_travel = -inv_travel * v->travel;
    const double d_elevation_ddot_by_c_travel = -l_elevation_travel * d_travel_ddot_by_c_travel;
    /* derivatives with respect to c_elevation */
    const double d_travel_ddot_by_c_elevation = inv_travel * l_elevation_travel * v->elevation;
    const double d_elevation_ddot_by_c_elevation = -inv_elevation * v->elevation - l_elevation_travel * d_travel_ddot_by_c_elevation;
    /* derivatives with respect to c_pitch */
    const double d_travel_ddot_by_c_pitch = inv_travel * l_pitch_travel * v->pitch;
    const double d_elevation_ddot_by_c_pitch = -l_elevation_travel * d_travel_ddot_by_c_pitch;
    const double d_pitch_ddot_by_c_pitch = -inv_pitch * v->pitch - l_pitch_travel * d_travel_ddot_by_c_pitch;
    const double s_ddot_plus_slopes_19 = s_ddot + slopes_19;
    /* derivatives with respect to m_s */
    const double by_m_s_1 = slopes_43 - l_s_elevation * s_ddot_plus_slopes_19;
    const double d_travel_ddot_by_m_s = -inv_travel * (slopes_45 - l_elevation_travel * by_m_s_1);
    const double d_elevation_ddot_by_m_s = -inv_elevation * by_m_s_1 - l_elevation_travel * d_travel_ddot_by_m_s;
    const double d_s_ddot_by_m_s = -inv_s * s_ddot_plus_slopes_19 - l_s_elevation * d_elevation_ddot_by_m_s;
    /* derivatives with respect to J_m */
    const double by_J_m_1 = l_s_elevation * half_s_ddot_r_s_two_r_s;
    const double d_travel_ddot_by_J_m = -inv_travel * l_elevation_travel * by_J_m_1;
    const double d_elevation_ddot_by_J_m = inv_elevation * by_J_m_1 - l_elevation_travel * d_travel_ddot_by_J_m;
    const double d_s_ddot_by_J_m = -inv_s * half_s_ddot_r_s_two_r_s - l_s_elevation * d_elevation_ddot_by_J_m;
    const double l_s_elevation_s_dot = l_s_elevation * v->s;
    /* derivatives with respect to c_s */
    const double d_travel_ddot_by_c_s = -inv_travel * l_elevation_travel * l_s_elevation_s_dot;
    const double d_elevation_ddot_by_c_s = inv_elevation * l_s_elevation_s_dot - l_elevation_travel * d_travel_ddot_by_c_s;
    const double d_s_ddot_by_c_s = -inv_s * v->s - l_s_elevation * d_elevation_ddot_by_c_s;
    if (!(M_s_s > 0.0)) {
        return 4;
    }
    if (!(I_heli_xx > 0.0)) {
        return 3;
    }
    if (!(pivot_elevation > 0.0)) {
        return 2;
    }
    if (!(pivot_travel > 0.0)) {
        return 1;
    }
    for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 19; j++) {
            by_p[i][j] = 0.0;
        }
    }
    by_p[4][0] = d_travel_ddot_by_m_h; /* travel'' */
    by_p[4][1] = d_travel_ddot_by_m_w;
    by_p[4][2] = d_travel_ddot_by_L_a;
    by_p[4][3] = d_travel_ddot_by_L_w;
    by_p[4][4] = d_travel_ddot_by_L_h;
    by_p[4][5] = d_travel_ddot_by_d;
    by_p[4][6] = d_travel_ddot_by_K_f;
    by_p[4][7] = d_travel_ddot_by_c_travel;
    by_p[4][8] = d_travel_ddot_by_c_elevation;
    by_p[4][9] = d_travel_ddot_by_c_pitch;
    by_p[4][10] = d_travel_ddot_by_g;
    by_p[4][11] = d_travel_ddot_by_m_s;
    by_p[4][12] = d_travel_ddot_by_s;
    by_p[4][13] = d_travel_ddot_by_R_m;
    by_p[4][14] = d_travel_ddot_by_K_t;
    by_p[4][15] = d_travel_ddot_by_n_g;
    by_p[4][16] = d_travel_ddot_by_lead;
    by_p[4][17] = d_travel_ddot_by_J_m;
    by_p[4][18] = d_travel_ddot_by_c_s;
    by_p[5][0] = d_elevation_ddot_by_m_h; /* elevation'' */
    by_p[5][1] = d_elevation_ddot_by_m_w;
    by_p[5][2] = d_elevation_ddot_by_L_a;
    by_p[5][3] = d_elevation_ddot_by_L_w;
    by_p[5][4] = d_elevation_ddot_by_L_h;
    by_p[5][5] = d_elevation_ddot_by_d;
    by_p[5][6] = d_elevation_ddot_by_K_f;
    by_p[5][7] = d_elevation_ddot_by_c_travel;
    by_p[5][8] = d_elevation_ddot_by_c_elevation;
    by_p[5][9] = d_elevation_ddot_by_c_pitch;
    by_p[5][10] = d_elevation_ddot_by_g;
    by_p[5][11] = d_elevation_ddot_by_m_s;
    by_p[5][12] = d_elevation_ddot_by_s;
    by_p[5][13] = d_elevation_ddot_by_R_m;
    by_p[5][14] = d_elevation_ddot_by_K_t;
    by_p[5][15] = d_elevation_ddot_by_n_g;
    by_p[5][16] = d_elevation_ddot_by_lead;
    by_p[5][17] = d_elevation_ddot_by_J_m;
    by_p[5][18] = d_elevation_ddot_by_c_s;
    by_p[6][0] = d_pitch_ddot_by_m_h; /* pitch'' */
    by_p[6][1] = -l_pitch_travel * d_travel_ddot_by_m_w;
    by_p[6][2] = -l_pitch_travel * d_travel_ddot_by_L_a;
    by_p[6][3] = -l_pitch_travel * d_travel_ddot_by_L_w;
    by_p[6][4] = d_pitch_ddot_by_L_h;
    by_p[6][5] = -l_pitch_travel * d_travel_ddot_by_d;
    by_p[6][6] = d_pitch_ddot_by_K_f;
    by_p[6][7] = -l_pitch_travel * d_travel_ddot_by_c_travel;
    by_p[6][8] = -l_pitch_travel * d_travel_ddot_by_c_elevation;
    by_p[6][9] = d_pitch_ddot_by_c_pitch;
    by_p[6][10] = -l_pitch_travel * d_travel_ddot_by_g;
    by_p[6][11] = -l_pitch_travel * d_travel_ddot_by_m_s;
    by_p[6][12] = -l_pitch_travel * d_travel_ddot_by_s;
    by_p[6][13] = -l_pitch_travel * d_travel_ddot_by_R_m;
    by_p[6][14] = -l_pitch_travel * d_travel_ddot_by_K_t;
    by_p[6][15] = -l_pitch_travel * d_travel_ddot_by_n_g;
    by_p[6][16] = -l_pitch_travel * d_travel_ddot_by_lead;
    by_p[6][17] = -l_pitch_travel * d_travel_ddot_by_J_m;
    by_p[6][18] = -l_pitch_travel * d_travel_ddot_by_c_s;
    by_p[7][0] = -l_s_elevation * d_elevation_ddot_by_m_h; /* s'' */
    by_p[7][1] = -l_s_elevation * d_elevation_ddot_by_m_w;
    by_p[7][2] = -l_s_elevation * d_elevation_ddot_by_L_a;
    by_p[7][3] = -l_s_elevation * d_elevation_ddot_by_L_w;
    by_p[7][4] = -l_s_elevation * d_elevation_ddot_by_L_h;
    by_p[7][5] = d_s_ddot_by_d;
    by_p[7][6] = -l_s_elevation * d_elevation_ddot_by_K_f;
    by_p[7][7] = -l_s_elevation * d_elevation_ddot_by_c_travel;
    by_p[7][8] = -l_s_elevation * d_elevation_ddot_by_c_elevation;
    by_p[7][9] = -l_s_elevation * d_elevation_ddot_by_c_pitch;
    by_p[7][10] = d_s_ddot_by_g;
    by_p[7][11] = d_s_ddot_by_m_s;
    by_p[7][12] = d_s_ddot_by_s;
    by_p[7][13] = d_s_ddot_by_R_m;
    by_p[7][14] = d_s_ddot_by_K_t;
    by_p[7][15] = d_s_ddot_by_n_g;
    by_p[7][16] = d_s_ddot_by_lead;
    by_p[7][17] = d_s_ddot_by_J_m;
    by_p[7][18] = d_s_ddot_by_c_s;
    return 0;
}

void quanser_ads_driven_output_jacobian(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_parameters *p,
    double by_x[4][8],
    double by_p[4][19])
{
    (void)x;
    (void)p;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 8; j++) {
            by_x[i][j] = 0.0;
        }
    }
    by_x[0][0] = 1.0; /* travel */
    by_x[1][1] = 1.0; /* elevation */
    by_x[2][2] = 1.0; /* pitch */
    by_x[3][3] = 1.0; /* s */
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 19; j++) {
            by_p[i][j] = 0.0;
        }
    }
}

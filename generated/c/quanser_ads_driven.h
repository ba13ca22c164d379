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
#ifndef QUANSER_ADS_DRIVEN_H
#define QUANSER_ADS_DRIVEN_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct quanser_ads_driven_parameters {
    double m_h;         /* helicopter: both rotors [kg] */
    double m_w;         /* counterweight [kg] */
    double L_a;         /* elevation axis to pitch axis [m] */
    double L_w;         /* elevation axis to counterweight [m] */
    double L_h;         /* pitch axis to each rotor [m] */
    double d;           /* elevation axis down to the arm; not published [m] */
    double K_f;         /* thrust of a rotor by its voltage [N/V] */
    double c_travel;    /* not published [N*m*s] */
    double c_elevation; /* not published [N*m*s] */
    double c_pitch;     /* not published [N*m*s] */
    double g;           /* [m/s^2] */
    double m_s;         /* carriage; not published [kg] */
    double s_0;         /* elevation axis to home, along the arm; not published [m] */
    double R_m;         /* motor [ohm] */
    double K_t;         /* torque constant, and back-EMF in V s/rad [N*m/A] */
    double n_g;         /* gear [1] */
    double lead;        /* screw, per turn [m] */
    double J_m;         /* rotor; not published [kg*m^2] */
    double c_s;         /* rail and nut; not published [N*s/m] */
};

/* Coordinates q. */
struct quanser_ads_driven_coordinates {
    double travel;    /* [rad] */
    double elevation; /* helicopter up positive [rad] */
    double pitch;     /* front up positive [rad] */
    double s;         /* carriage, towards the helicopter [m] */
};

/* Rates v = q'. */
struct quanser_ads_driven_rates {
    double travel;    /* [rad/s] */
    double elevation; /* helicopter up positive [rad/s] */
    double pitch;     /* front up positive [rad/s] */
    double s;         /* carriage, towards the helicopter [m/s] */
};

/* Accelerations a = q''. */
struct quanser_ads_driven_accelerations {
    double travel;    /* [rad/s^2] */
    double elevation; /* helicopter up positive [rad/s^2] */
    double pitch;     /* front up positive [rad/s^2] */
    double s;         /* carriage, towards the helicopter [m/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct quanser_ads_driven_inputs {
    double V_f;       /* front motor [V] */
    double V_b;       /* back motor [V] */
    double V_s_motor; /* carriage motor [V] */
};

/* Measured outputs y. */
struct quanser_ads_driven_outputs {
    double travel;    /* [rad] */
    double elevation; /* [rad] */
    double pitch;     /* [rad] */
    double s;         /* [m] */
};

/* State x = [q | v]. */
struct quanser_ads_driven_state {
    struct quanser_ads_driven_coordinates q;
    struct quanser_ads_driven_rates v;
};

/* The values that the rig's file gives. */
void quanser_ads_driven_nominal(struct quanser_ads_driven_parameters *p);

/* Mass matrix M(q), 4 x 4, symmetric; rows (travel, elevation, pitch, s). */
void quanser_ads_driven_mass_matrix(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_parameters *p,
    double m[4][4]);

/* Bias h(q, v) [N m, N m, N m, N]: velocity products + gravity + springs; rows (travel, elevation, pitch, s). */
void quanser_ads_driven_bias(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_parameters *p,
    double h[4]);

/* Velocity products C(q, v) v [N m, N m, N m, N]: Coriolis and centrifugal terms; rows (travel, elevation, pitch, s). */
void quanser_ads_driven_velocity_products(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_parameters *p,
    double c[4]);

/* Generalized gravity g(q) [N m, N m, N m, N]: what holds the rig still; rows (travel, elevation, pitch, s). */
void quanser_ads_driven_gravity(const struct quanser_ads_driven_coordinates *q, const struct quanser_ads_driven_parameters *p, double g[4]);

/* Friction and dampers d(q, v) [N m, N m, N m, N], on the left-hand side; rows (travel, elevation, pitch, s). */
void quanser_ads_driven_dissipation(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_parameters *p,
    double d[4]);

/* Generalized force Q [N m, N m, N m, N] of the inputs; rows (travel, elevation, pitch, s). */
void quanser_ads_driven_generalized_force(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    double f[4]);

/* Input map dQ/du, 4 x 3; rows (travel, elevation, pitch, s), columns (V_f, V_b, V_s_motor). */
void quanser_ads_driven_input_map(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_parameters *p,
    double s[4][3]);

/* Kinetic energy T(q, v) [J]. */
double quanser_ads_driven_kinetic_energy(
    const struct quanser_ads_driven_coordinates *q,
    const struct quanser_ads_driven_rates *v,
    const struct quanser_ads_driven_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double quanser_ads_driven_potential_energy(const struct quanser_ads_driven_coordinates *q, const struct quanser_ads_driven_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m, N m, N m, N]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void quanser_ads_driven_inverse_dynamics(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_accelerations *a,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    double r[4]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void quanser_ads_driven_outputs(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_parameters *p,
    struct quanser_ads_driven_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void quanser_ads_driven_pivots(const struct quanser_ads_driven_state *x, const struct quanser_ads_driven_parameters *p, double d[4]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 214 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int quanser_ads_driven_forward_dynamics(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    struct quanser_ads_driven_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 773 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *              travel elevation pitch s travel.dot elevation.dot pitch.dot s.dot | V_f V_b V_s_motor
 * travel'      .      .         .     . 1          .             .         .     | .   .   .
 * elevation'   .      .         .     . .          1             .         .     | .   .   .
 * pitch'       .      .         .     . .          .             1         .     | .   .   .
 * s'           .      .         .     . .          .             .         1     | .   .   .
 * travel''     .      *         *     * *          *             *         *     | *   *   *
 * elevation''  .      *         *     * *          *             *         *     | *   *   *
 * pitch''      .      *         *     * *          *             *         *     | *   *   *
 * s''          .      *         *     * *          *             *         *     | *   *   *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int quanser_ads_driven_linearize(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    double dx[8],
    double a[8][8],
    double b[8][3]);

/*
 * Parameter Jacobian dx'/dp, 8 x 19; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int quanser_ads_driven_parameter_jacobian(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_inputs *u,
    const struct quanser_ads_driven_parameters *p,
    double by_p[8][19]);

/* Jacobians of the measured outputs. */
void quanser_ads_driven_output_jacobian(
    const struct quanser_ads_driven_state *x,
    const struct quanser_ads_driven_parameters *p,
    double by_x[4][8],
    double by_p[4][19]);

#ifdef __cplusplus
}
#endif

#endif /* QUANSER_ADS_DRIVEN_H */

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
#ifndef QUANSER_H
#define QUANSER_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct quanser_parameters {
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
};

/* Coordinates q. */
struct quanser_coordinates {
    double travel;    /* [rad] */
    double elevation; /* helicopter up positive [rad] */
    double pitch;     /* front up positive [rad] */
};

/* Rates v = q'. */
struct quanser_rates {
    double travel;    /* [rad/s] */
    double elevation; /* helicopter up positive [rad/s] */
    double pitch;     /* front up positive [rad/s] */
};

/* Accelerations a = q''. */
struct quanser_accelerations {
    double travel;    /* [rad/s^2] */
    double elevation; /* helicopter up positive [rad/s^2] */
    double pitch;     /* front up positive [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct quanser_inputs {
    double V_f; /* front motor [V] */
    double V_b; /* back motor [V] */
};

/* Measured outputs y. */
struct quanser_outputs {
    double travel;    /* [rad] */
    double elevation; /* [rad] */
    double pitch;     /* [rad] */
};

/* State x = [q | v]. */
struct quanser_state {
    struct quanser_coordinates q;
    struct quanser_rates v;
};

/* The values that the rig's file gives. */
void quanser_nominal(struct quanser_parameters *p);

/* Mass matrix M(q), 3 x 3, symmetric; rows (travel, elevation, pitch). */
void quanser_mass_matrix(const struct quanser_coordinates *q, const struct quanser_parameters *p, double m[3][3]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (travel, elevation, pitch). */
void quanser_bias(const struct quanser_coordinates *q, const struct quanser_rates *v, const struct quanser_parameters *p, double h[3]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (travel, elevation, pitch). */
void quanser_velocity_products(
    const struct quanser_coordinates *q,
    const struct quanser_rates *v,
    const struct quanser_parameters *p,
    double c[3]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (travel, elevation, pitch). */
void quanser_gravity(const struct quanser_coordinates *q, const struct quanser_parameters *p, double g[3]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (travel, elevation, pitch). */
void quanser_dissipation(
    const struct quanser_coordinates *q,
    const struct quanser_rates *v,
    const struct quanser_parameters *p,
    double d[3]);

/* Generalized force Q [N m] of the inputs; rows (travel, elevation, pitch). */
void quanser_generalized_force(
    const struct quanser_coordinates *q,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    double f[3]);

/* Input map dQ/du, 3 x 2; rows (travel, elevation, pitch), columns (V_f, V_b). */
void quanser_input_map(const struct quanser_coordinates *q, const struct quanser_parameters *p, double s[3][2]);

/* Kinetic energy T(q, v) [J]. */
double quanser_kinetic_energy(const struct quanser_coordinates *q, const struct quanser_rates *v, const struct quanser_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double quanser_potential_energy(const struct quanser_coordinates *q, const struct quanser_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void quanser_inverse_dynamics(
    const struct quanser_state *x,
    const struct quanser_accelerations *a,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    double r[3]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void quanser_outputs(const struct quanser_state *x, const struct quanser_parameters *p, struct quanser_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void quanser_pivots(const struct quanser_state *x, const struct quanser_parameters *p, double d[3]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 161 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int quanser_forward_dynamics(
    const struct quanser_state *x,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    struct quanser_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 570 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *              travel elevation pitch travel.dot elevation.dot pitch.dot | V_f V_b
 * travel'      .      .         .     1          .             .         | .   .
 * elevation'   .      .         .     .          1             .         | .   .
 * pitch'       .      .         .     .          .             1         | .   .
 * travel''     .      *         *     *          *             *         | *   *
 * elevation''  .      *         *     *          *             *         | *   *
 * pitch''      .      *         *     *          *             *         | *   *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int quanser_linearize(
    const struct quanser_state *x,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2]);

/*
 * Parameter Jacobian dx'/dp, 6 x 11; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int quanser_parameter_jacobian(
    const struct quanser_state *x,
    const struct quanser_inputs *u,
    const struct quanser_parameters *p,
    double by_p[6][11]);

/* Jacobians of the measured outputs. */
void quanser_output_jacobian(const struct quanser_state *x, const struct quanser_parameters *p, double by_x[3][6], double by_p[3][11]);

#ifdef __cplusplus
}
#endif

#endif /* QUANSER_H */

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
#ifndef CHAIN3_H
#define CHAIN3_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct chain3_parameters {
    double m_1; /* [kg] */
    double m_2; /* [kg] */
    double m_3; /* [kg] */
    double l_1; /* [m] */
    double l_2; /* [m] */
    double l_3; /* [m] */
    double b;   /* width of the bars [m] */
    double c_1; /* [N*m*s] */
    double c_2; /* [N*m*s] */
    double c_3; /* [N*m*s] */
    double g;   /* [m/s^2] */
};

/* Coordinates q. */
struct chain3_coordinates {
    double q1; /* [rad] */
    double q2; /* [rad] */
    double q3; /* [rad] */
};

/* Rates v = q'. */
struct chain3_rates {
    double q1; /* [rad/s] */
    double q2; /* [rad/s] */
    double q3; /* [rad/s] */
};

/* Accelerations a = q''. */
struct chain3_accelerations {
    double q1; /* [rad/s^2] */
    double q2; /* [rad/s^2] */
    double q3; /* [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct chain3_inputs {
    double tau_1; /* [N*m] */
    double tau_2; /* [N*m] */
    double tau_3; /* [N*m] */
};

/* Measured outputs y. */
struct chain3_outputs {
    double q1; /* [rad] */
    double q2; /* [rad] */
    double q3; /* [rad] */
};

/* State x = [q | v]. */
struct chain3_state {
    struct chain3_coordinates q;
    struct chain3_rates v;
};

/* The values that the rig's file gives. */
void chain3_nominal(struct chain3_parameters *p);

/* Mass matrix M(q), 3 x 3, symmetric; rows (q1, q2, q3). */
void chain3_mass_matrix(const struct chain3_coordinates *q, const struct chain3_parameters *p, double m[3][3]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (q1, q2, q3). */
void chain3_bias(const struct chain3_coordinates *q, const struct chain3_rates *v, const struct chain3_parameters *p, double h[3]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (q1, q2, q3). */
void chain3_velocity_products(
    const struct chain3_coordinates *q,
    const struct chain3_rates *v,
    const struct chain3_parameters *p,
    double c[3]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (q1, q2, q3). */
void chain3_gravity(const struct chain3_coordinates *q, const struct chain3_parameters *p, double g[3]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (q1, q2, q3). */
void chain3_dissipation(const struct chain3_coordinates *q, const struct chain3_rates *v, const struct chain3_parameters *p, double d[3]);

/* Generalized force Q [N m] of the inputs; rows (q1, q2, q3). */
void chain3_generalized_force(
    const struct chain3_coordinates *q,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    double f[3]);

/* Input map dQ/du, 3 x 3; rows (q1, q2, q3), columns (tau_1, tau_2, tau_3). */
void chain3_input_map(const struct chain3_coordinates *q, const struct chain3_parameters *p, double s[3][3]);

/* Kinetic energy T(q, v) [J]. */
double chain3_kinetic_energy(const struct chain3_coordinates *q, const struct chain3_rates *v, const struct chain3_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double chain3_potential_energy(const struct chain3_coordinates *q, const struct chain3_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void chain3_inverse_dynamics(
    const struct chain3_state *x,
    const struct chain3_accelerations *a,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    double r[3]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void chain3_outputs(const struct chain3_state *x, const struct chain3_parameters *p, struct chain3_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void chain3_pivots(const struct chain3_state *x, const struct chain3_parameters *p, double d[3]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 215 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int chain3_forward_dynamics(
    const struct chain3_state *x,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    struct chain3_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 683 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *       q1 q2 q3 q1.dot q2.dot q3.dot | tau_1 tau_2 tau_3
 * q1'   .  .  .  1      .      .      | .     .     .
 * q2'   .  .  .  .      1      .      | .     .     .
 * q3'   .  .  .  .      .      1      | .     .     .
 * q1''  .  *  *  *      *      *      | *     *     *
 * q2''  .  *  *  *      *      *      | *     *     *
 * q3''  .  *  *  *      *      *      | *     *     *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int chain3_linearize(
    const struct chain3_state *x,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][3]);

/*
 * Parameter Jacobian dx'/dp, 6 x 11; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int chain3_parameter_jacobian(
    const struct chain3_state *x,
    const struct chain3_inputs *u,
    const struct chain3_parameters *p,
    double by_p[6][11]);

/* Jacobians of the measured outputs. */
void chain3_output_jacobian(const struct chain3_state *x, const struct chain3_parameters *p, double by_x[3][6], double by_p[3][11]);

#ifdef __cplusplus
}
#endif

#endif /* CHAIN3_H */

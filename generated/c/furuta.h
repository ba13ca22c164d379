/*
 * Furuta pendulum (QUBE-Servo 2).
 * Generated from `furuta.rig` (model 060d2e34); edit the rig, not this file.
 *
 * Uniform thin rods as in Quanser's QUBE-Servo 2 data sheet, motor rotor and hub on the arm's axis.
 * alpha = 0 hangs down; theta about the upright axis, alpha about the arm.
 *
 * 69 operations forward, 160 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef FURUTA_H
#define FURUTA_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct furuta_parameters {
    double m_r; /* arm [kg] */
    double r;   /* arm's length [m] */
    double m_p; /* pendulum [kg] */
    double L_p; /* pendulum's length [m] */
    double J_m; /* motor rotor [kg*m^2] */
    double J_h; /* hub [kg*m^2] */
    double g;   /* [m/s^2] */
};

/* Coordinates q. */
struct furuta_coordinates {
    double theta; /* arm [rad] */
    double alpha; /* pendulum, 0 hanging [rad] */
};

/* Rates v = q'. */
struct furuta_rates {
    double theta; /* arm [rad/s] */
    double alpha; /* pendulum, 0 hanging [rad/s] */
};

/* Accelerations a = q''. */
struct furuta_accelerations {
    double theta; /* arm [rad/s^2] */
    double alpha; /* pendulum, 0 hanging [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct furuta_inputs {
    double tau; /* [N*m] */
};

/* Measured outputs y. */
struct furuta_outputs {
    double theta; /* [rad] */
    double alpha; /* [rad] */
};

/* State x = [q | v]. */
struct furuta_state {
    struct furuta_coordinates q;
    struct furuta_rates v;
};

/* The values that the rig's file gives. */
void furuta_nominal(struct furuta_parameters *p);

/* Mass matrix M(q), 2 x 2, symmetric; rows (theta, alpha). */
void furuta_mass_matrix(const struct furuta_coordinates *q, const struct furuta_parameters *p, double m[2][2]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (theta, alpha). */
void furuta_bias(const struct furuta_coordinates *q, const struct furuta_rates *v, const struct furuta_parameters *p, double h[2]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (theta, alpha). */
void furuta_velocity_products(
    const struct furuta_coordinates *q,
    const struct furuta_rates *v,
    const struct furuta_parameters *p,
    double c[2]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (theta, alpha). */
void furuta_gravity(const struct furuta_coordinates *q, const struct furuta_parameters *p, double g[2]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (theta, alpha). */
void furuta_dissipation(const struct furuta_coordinates *q, const struct furuta_rates *v, const struct furuta_parameters *p, double d[2]);

/* Generalized force Q [N m] of the inputs; rows (theta, alpha). */
void furuta_generalized_force(
    const struct furuta_coordinates *q,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    double f[2]);

/* Input map dQ/du, 2 x 1; rows (theta, alpha), columns (tau). */
void furuta_input_map(const struct furuta_coordinates *q, const struct furuta_parameters *p, double s[2][1]);

/* Kinetic energy T(q, v) [J]. */
double furuta_kinetic_energy(const struct furuta_coordinates *q, const struct furuta_rates *v, const struct furuta_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double furuta_potential_energy(const struct furuta_coordinates *q, const struct furuta_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void furuta_inverse_dynamics(
    const struct furuta_state *x,
    const struct furuta_accelerations *a,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    double r[2]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void furuta_outputs(const struct furuta_state *x, const struct furuta_parameters *p, struct furuta_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void furuta_pivots(const struct furuta_state *x, const struct furuta_parameters *p, double d[2]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 69 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int furuta_forward_dynamics(
    const struct furuta_state *x,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    struct furuta_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 160 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *          theta alpha theta.dot alpha.dot | tau
 * theta'   .     .     1         .         | .
 * alpha'   .     .     .         1         | .
 * theta''  .     *     *         *         | *
 * alpha''  .     *     *         *         | *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int furuta_linearize(
    const struct furuta_state *x,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][1]);

/*
 * Parameter Jacobian dx'/dp, 4 x 7; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int furuta_parameter_jacobian(
    const struct furuta_state *x,
    const struct furuta_inputs *u,
    const struct furuta_parameters *p,
    double by_p[4][7]);

/* Jacobians of the measured outputs. */
void furuta_output_jacobian(const struct furuta_state *x, const struct furuta_parameters *p, double by_x[2][4], double by_p[2][7]);

#ifdef __cplusplus
}
#endif

#endif /* FURUTA_H */

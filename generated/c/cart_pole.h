/*
 * Cart and pole.
 * Generated from `cart_pole.rig` (model eaaaff00); edit the rig, not this file.
 *
 * The numbers of gymnasium's CartPole (cart 1 kg, pole 0.1 kg, half length 0.5 m), with the pole a
 * uniform rod. theta = 0 is upright, positive towards +x.
 *
 * 33 operations forward, 64 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef CART_POLE_H
#define CART_POLE_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct cart_pole_parameters {
    double m_c; /* cart [kg] */
    double m_p; /* pole [kg] */
    double l;   /* half the pole's length [m] */
    double g;   /* [m/s^2] */
};

/* Coordinates q. */
struct cart_pole_coordinates {
    double x;     /* cart [m] */
    double theta; /* pole [rad] */
};

/* Rates v = q'. */
struct cart_pole_rates {
    double x;     /* cart [m/s] */
    double theta; /* pole [rad/s] */
};

/* Accelerations a = q''. */
struct cart_pole_accelerations {
    double x;     /* cart [m/s^2] */
    double theta; /* pole [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct cart_pole_inputs {
    double F; /* [N] */
};

/* Measured outputs y. */
struct cart_pole_outputs {
    double x;     /* [m] */
    double theta; /* [rad] */
};

/* State x = [q | v]. */
struct cart_pole_state {
    struct cart_pole_coordinates q;
    struct cart_pole_rates v;
};

/* The values that the rig's file gives. */
void cart_pole_nominal(struct cart_pole_parameters *p);

/* Mass matrix M(q), 2 x 2, symmetric; rows (x, theta). */
void cart_pole_mass_matrix(const struct cart_pole_coordinates *q, const struct cart_pole_parameters *p, double m[2][2]);

/* Bias h(q, v) [N, N m]: velocity products + gravity + springs; rows (x, theta). */
void cart_pole_bias(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_rates *v,
    const struct cart_pole_parameters *p,
    double h[2]);

/* Velocity products C(q, v) v [N, N m]: Coriolis and centrifugal terms; rows (x, theta). */
void cart_pole_velocity_products(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_rates *v,
    const struct cart_pole_parameters *p,
    double c[2]);

/* Generalized gravity g(q) [N, N m]: what holds the rig still; rows (x, theta). */
void cart_pole_gravity(const struct cart_pole_coordinates *q, const struct cart_pole_parameters *p, double g[2]);

/* Friction and dampers d(q, v) [N, N m], on the left-hand side; rows (x, theta). */
void cart_pole_dissipation(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_rates *v,
    const struct cart_pole_parameters *p,
    double d[2]);

/* Generalized force Q [N, N m] of the inputs; rows (x, theta). */
void cart_pole_generalized_force(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    double f[2]);

/* Input map dQ/du, 2 x 1; rows (x, theta), columns (F). */
void cart_pole_input_map(const struct cart_pole_coordinates *q, const struct cart_pole_parameters *p, double s[2][1]);

/* Kinetic energy T(q, v) [J]. */
double cart_pole_kinetic_energy(
    const struct cart_pole_coordinates *q,
    const struct cart_pole_rates *v,
    const struct cart_pole_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double cart_pole_potential_energy(const struct cart_pole_coordinates *q, const struct cart_pole_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N, N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void cart_pole_inverse_dynamics(
    const struct cart_pole_state *x,
    const struct cart_pole_accelerations *a,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    double r[2]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void cart_pole_outputs(const struct cart_pole_state *x, const struct cart_pole_parameters *p, struct cart_pole_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void cart_pole_pivots(const struct cart_pole_state *x, const struct cart_pole_parameters *p, double d[2]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 33 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int cart_pole_forward_dynamics(
    const struct cart_pole_state *x,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    struct cart_pole_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 64 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *          x theta x.dot theta.dot | F
 * x'       . .     1     .         | .
 * theta'   . .     .     1         | .
 * x''      . *     .     *         | *
 * theta''  . *     .     *         | *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int cart_pole_linearize(
    const struct cart_pole_state *x,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][1]);

/*
 * Parameter Jacobian dx'/dp, 4 x 4; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int cart_pole_parameter_jacobian(
    const struct cart_pole_state *x,
    const struct cart_pole_inputs *u,
    const struct cart_pole_parameters *p,
    double by_p[4][4]);

/* Jacobians of the measured outputs. */
void cart_pole_output_jacobian(const struct cart_pole_state *x, const struct cart_pole_parameters *p, double by_x[2][4], double by_p[2][4]);

#ifdef __cplusplus
}
#endif

#endif /* CART_POLE_H */

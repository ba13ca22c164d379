/*
 * EMPS, electro-mechanical positioning system.
 * Generated from `emps.rig` (model d1922771); edit the rig, not this file.
 *
 * A carriage on a ball screw with a direct-current motor, seen from the carriage: the benchmark of Janot,
 * Gautier and Brunot, "Data set and reference models of EMPS", Workshop on Nonlinear System Identification
 * Benchmarks, 2019, with its published inverse-dynamics estimates. The offset is part of the friction,
 * since the benchmark counts it there.
 *
 * 10 operations forward, 19 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef EMPS_H
#define EMPS_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct emps_parameters {
    double M;   /* carriage with screw and rotor [kg] */
    double F_v; /* viscous friction [N*s/m] */
    double F_c; /* Coulomb friction [N] */
    double F_0; /* offset [N] */
    double v_c; /* width of the Coulomb law's turn [m/s] */
    double G;   /* force by command [N/V] */
};

/* Coordinates q. */
struct emps_coordinates {
    double q; /* [m] */
};

/* Rates v = q'. */
struct emps_rates {
    double q; /* [m/s] */
};

/* Accelerations a = q''. */
struct emps_accelerations {
    double q; /* [m/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct emps_inputs {
    double V; /* motor command [V] */
};

/* Measured outputs y. */
struct emps_outputs {
    double q; /* [m] */
};

/* State x = [q | v]. */
struct emps_state {
    struct emps_coordinates q;
    struct emps_rates v;
};

/* The values that the rig's file gives. */
void emps_nominal(struct emps_parameters *p);

/* Mass matrix M(q), 1 x 1, symmetric; rows (q). */
void emps_mass_matrix(const struct emps_coordinates *q, const struct emps_parameters *p, double m[1][1]);

/* Bias h(q, v) [N]: velocity products + gravity + springs; rows (q). */
void emps_bias(const struct emps_coordinates *q, const struct emps_rates *v, const struct emps_parameters *p, double h[1]);

/* Velocity products C(q, v) v [N]: Coriolis and centrifugal terms; rows (q). */
void emps_velocity_products(const struct emps_coordinates *q, const struct emps_rates *v, const struct emps_parameters *p, double c[1]);

/* Generalized gravity g(q) [N]: what holds the rig still; rows (q). */
void emps_gravity(const struct emps_coordinates *q, const struct emps_parameters *p, double g[1]);

/* Friction and dampers d(q, v) [N], on the left-hand side; rows (q). */
void emps_dissipation(const struct emps_coordinates *q, const struct emps_rates *v, const struct emps_parameters *p, double d[1]);

/* Generalized force Q [N] of the inputs; rows (q). */
void emps_generalized_force(const struct emps_coordinates *q, const struct emps_inputs *u, const struct emps_parameters *p, double f[1]);

/* Input map dQ/du, 1 x 1; rows (q), columns (V). */
void emps_input_map(const struct emps_coordinates *q, const struct emps_parameters *p, double s[1][1]);

/* Kinetic energy T(q, v) [J]. */
double emps_kinetic_energy(const struct emps_coordinates *q, const struct emps_rates *v, const struct emps_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double emps_potential_energy(const struct emps_coordinates *q, const struct emps_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void emps_inverse_dynamics(
    const struct emps_state *x,
    const struct emps_accelerations *a,
    const struct emps_inputs *u,
    const struct emps_parameters *p,
    double r[1]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void emps_outputs(const struct emps_state *x, const struct emps_parameters *p, struct emps_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void emps_pivots(const struct emps_state *x, const struct emps_parameters *p, double d[1]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 10 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int emps_forward_dynamics(
    const struct emps_state *x,
    const struct emps_inputs *u,
    const struct emps_parameters *p,
    struct emps_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 19 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *      q q.dot | V
 * q'   . 1     | .
 * q''  . *     | *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int emps_linearize(
    const struct emps_state *x,
    const struct emps_inputs *u,
    const struct emps_parameters *p,
    double dx[2],
    double a[2][2],
    double b[2][1]);

/*
 * As linearize, without the slope of regularized Coulomb friction (at rest an artefact of its width).
 * 19 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *      q q.dot | V
 * q'   . 1     | .
 * q''  . *     | *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int emps_linearize_without_friction_slope(
    const struct emps_state *x,
    const struct emps_inputs *u,
    const struct emps_parameters *p,
    double dx[2],
    double a[2][2],
    double b[2][1]);

/*
 * Parameter Jacobian dx'/dp, 2 x 6; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int emps_parameter_jacobian(const struct emps_state *x, const struct emps_inputs *u, const struct emps_parameters *p, double by_p[2][6]);

/* Jacobians of the measured outputs. */
void emps_output_jacobian(const struct emps_state *x, const struct emps_parameters *p, double by_x[1][2], double by_p[1][6]);

#ifdef __cplusplus
}
#endif

#endif /* EMPS_H */

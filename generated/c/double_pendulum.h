/*
 * Double pendulum with quasi-direct drives and a belt to the elbow.
 * Generated from `double_pendulum.rig` (model b0557872); edit the rig, not this file.
 *
 * Both motors sit at the shoulder end; the second one drives the elbow through a belt, so that its rotor
 * turns by q1 - n q2. Both rotors turn n times as fast as their joints. Identified numbers of design A.0,
 * model 2.0, of the DFKI underactuated lab (github.com/dfki-ric-underactuated-lab/double_pendulum,
 * BSD-3-Clause): inertias about the joints, rotor inertia, friction. The published friction law is
 * b v + c_f atan(100 v); here the same level, c_f pi/2, and the same slope at rest in one regularized
 * Coulomb law. q1 = 0 hangs; q2 relative to the upper link.
 *
 * 83 operations forward, 182 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef DOUBLE_PENDULUM_H
#define DOUBLE_PENDULUM_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct double_pendulum_parameters {
    double m_1;  /* upper link [kg] */
    double m_2;  /* lower link [kg] */
    double r_1;  /* shoulder to the upper link's centre [m] */
    double r_2;  /* elbow to the lower link's centre [m] */
    double l_1;  /* shoulder to elbow [m] */
    double I_1;  /* upper link about the shoulder [kg*m^2] */
    double I_2;  /* lower link about the elbow [kg*m^2] */
    double I_r;  /* rotor of either motor [kg*m^2] */
    double n;    /* gear ratio [1] */
    double b_1;  /* viscous friction, shoulder [N*m*s] */
    double b_2;  /* viscous friction, elbow [N*m*s] */
    double c_f1; /* dry friction, shoulder (level / (pi/2)) [N*m] */
    double c_f2; /* dry friction, elbow (level / (pi/2)) [N*m] */
    double v_c;  /* width of the dry friction's turn: pi/2 / 100 [rad/s] */
    double g;    /* [m/s^2] */
};

/* Coordinates q. */
struct double_pendulum_coordinates {
    double q1; /* shoulder, 0 hanging [rad] */
    double q2; /* elbow, relative [rad] */
};

/* Rates v = q'. */
struct double_pendulum_rates {
    double q1; /* shoulder, 0 hanging [rad/s] */
    double q2; /* elbow, relative [rad/s] */
};

/* Accelerations a = q''. */
struct double_pendulum_accelerations {
    double q1; /* shoulder, 0 hanging [rad/s^2] */
    double q2; /* elbow, relative [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct double_pendulum_inputs {
    double tau_1; /* at the shoulder [N*m] */
    double tau_2; /* at the elbow, through the belt [N*m] */
};

/* Measured outputs y. */
struct double_pendulum_outputs {
    double q1; /* [rad] */
    double q2; /* [rad] */
};

/* State x = [q | v]. */
struct double_pendulum_state {
    struct double_pendulum_coordinates q;
    struct double_pendulum_rates v;
};

/* The values that the rig's file gives. */
void double_pendulum_nominal(struct double_pendulum_parameters *p);

/* Mass matrix M(q), 2 x 2, symmetric; rows (q1, q2). */
void double_pendulum_mass_matrix(const struct double_pendulum_coordinates *q, const struct double_pendulum_parameters *p, double m[2][2]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (q1, q2). */
void double_pendulum_bias(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_rates *v,
    const struct double_pendulum_parameters *p,
    double h[2]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (q1, q2). */
void double_pendulum_velocity_products(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_rates *v,
    const struct double_pendulum_parameters *p,
    double c[2]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (q1, q2). */
void double_pendulum_gravity(const struct double_pendulum_coordinates *q, const struct double_pendulum_parameters *p, double g[2]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (q1, q2). */
void double_pendulum_dissipation(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_rates *v,
    const struct double_pendulum_parameters *p,
    double d[2]);

/* Generalized force Q [N m] of the inputs; rows (q1, q2). */
void double_pendulum_generalized_force(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double f[2]);

/* Input map dQ/du, 2 x 2; rows (q1, q2), columns (tau_1, tau_2). */
void double_pendulum_input_map(const struct double_pendulum_coordinates *q, const struct double_pendulum_parameters *p, double s[2][2]);

/* Kinetic energy T(q, v) [J]. */
double double_pendulum_kinetic_energy(
    const struct double_pendulum_coordinates *q,
    const struct double_pendulum_rates *v,
    const struct double_pendulum_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double double_pendulum_potential_energy(const struct double_pendulum_coordinates *q, const struct double_pendulum_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void double_pendulum_inverse_dynamics(
    const struct double_pendulum_state *x,
    const struct double_pendulum_accelerations *a,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double r[2]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void double_pendulum_outputs(
    const struct double_pendulum_state *x,
    const struct double_pendulum_parameters *p,
    struct double_pendulum_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void double_pendulum_pivots(const struct double_pendulum_state *x, const struct double_pendulum_parameters *p, double d[2]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 83 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int double_pendulum_forward_dynamics(
    const struct double_pendulum_state *x,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    struct double_pendulum_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 182 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *       q1 q2 q1.dot q2.dot | tau_1 tau_2
 * q1'   .  .  1      .      | .     .
 * q2'   .  .  .      1      | .     .
 * q1''  *  *  *      *      | *     *
 * q2''  *  *  *      *      | *     *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int double_pendulum_linearize(
    const struct double_pendulum_state *x,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][2]);

/*
 * As linearize, without the slope of regularized Coulomb friction (at rest an artefact of its width).
 * 182 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *       q1 q2 q1.dot q2.dot | tau_1 tau_2
 * q1'   .  .  1      .      | .     .
 * q2'   .  .  .      1      | .     .
 * q1''  *  *  *      *      | *     *
 * q2''  *  *  *      *      | *     *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int double_pendulum_linearize_without_friction_slope(
    const struct double_pendulum_state *x,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][2]);

/*
 * Parameter Jacobian dx'/dp, 4 x 15; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int double_pendulum_parameter_jacobian(
    const struct double_pendulum_state *x,
    const struct double_pendulum_inputs *u,
    const struct double_pendulum_parameters *p,
    double by_p[4][15]);

/* Jacobians of the measured outputs. */
void double_pendulum_output_jacobian(
    const struct double_pendulum_state *x,
    const struct double_pendulum_parameters *p,
    double by_x[2][4],
    double by_p[2][15]);

#ifdef __cplusplus
}
#endif

#endif /* DOUBLE_PENDULUM_H */

/*
 * Flexible joint: a link in gravity, driven through a spring.
 * Generated from `flexible_joint.rig` (model 8bd255ae); edit the rig, not this file.
 *
 * Motor and link of one joint, between them a stiff spring with a little damping: the single-link arm of
 * Spong, "Modeling and control of elastic joint robots", J. Dyn. Syst. Meas. Control 109 (1987). Numbers of
 * a small harmonic-drive joint, seen from the link's side, chosen here: the paper keeps symbols.
 *
 * 38 operations forward, 74 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef FLEXIBLE_JOINT_H
#define FLEXIBLE_JOINT_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct flexible_joint_parameters {
    double m;   /* link [kg] */
    double l;   /* length of the link [m] */
    double J;   /* rotor times gear ratio squared [kg*m^2] */
    double k;   /* stiffness of the joint, per radian [N*m] */
    double k_3; /* its hardening, per radian cubed [N*m] */
    double c_k; /* damping within the joint [N*m*s] */
    double c_m; /* motor's friction [N*m*s] */
    double g;   /* [m/s^2] */
};

/* Coordinates q. */
struct flexible_joint_coordinates {
    double motor; /* motor, behind the gear [rad] */
    double link;  /* link, 0 hanging [rad] */
};

/* Rates v = q'. */
struct flexible_joint_rates {
    double motor; /* motor, behind the gear [rad/s] */
    double link;  /* link, 0 hanging [rad/s] */
};

/* Accelerations a = q''. */
struct flexible_joint_accelerations {
    double motor; /* motor, behind the gear [rad/s^2] */
    double link;  /* link, 0 hanging [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct flexible_joint_inputs {
    double tau; /* motor torque times gear ratio [N*m] */
};

/* Measured outputs y. */
struct flexible_joint_outputs {
    double motor; /* [rad] */
    double link;  /* [rad] */
};

/* State x = [q | v]. */
struct flexible_joint_state {
    struct flexible_joint_coordinates q;
    struct flexible_joint_rates v;
};

/* The values that the rig's file gives. */
void flexible_joint_nominal(struct flexible_joint_parameters *p);

/* Mass matrix M(q), 2 x 2, symmetric; rows (motor, link). */
void flexible_joint_mass_matrix(const struct flexible_joint_coordinates *q, const struct flexible_joint_parameters *p, double m[2][2]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (motor, link). */
void flexible_joint_bias(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_rates *v,
    const struct flexible_joint_parameters *p,
    double h[2]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (motor, link). */
void flexible_joint_velocity_products(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_rates *v,
    const struct flexible_joint_parameters *p,
    double c[2]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (motor, link). */
void flexible_joint_gravity(const struct flexible_joint_coordinates *q, const struct flexible_joint_parameters *p, double g[2]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (motor, link). */
void flexible_joint_dissipation(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_rates *v,
    const struct flexible_joint_parameters *p,
    double d[2]);

/* Generalized force Q [N m] of the inputs; rows (motor, link). */
void flexible_joint_generalized_force(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    double f[2]);

/* Input map dQ/du, 2 x 1; rows (motor, link), columns (tau). */
void flexible_joint_input_map(const struct flexible_joint_coordinates *q, const struct flexible_joint_parameters *p, double s[2][1]);

/* Kinetic energy T(q, v) [J]. */
double flexible_joint_kinetic_energy(
    const struct flexible_joint_coordinates *q,
    const struct flexible_joint_rates *v,
    const struct flexible_joint_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double flexible_joint_potential_energy(const struct flexible_joint_coordinates *q, const struct flexible_joint_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void flexible_joint_inverse_dynamics(
    const struct flexible_joint_state *x,
    const struct flexible_joint_accelerations *a,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    double r[2]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void flexible_joint_outputs(
    const struct flexible_joint_state *x,
    const struct flexible_joint_parameters *p,
    struct flexible_joint_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void flexible_joint_pivots(const struct flexible_joint_state *x, const struct flexible_joint_parameters *p, double d[2]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 38 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int flexible_joint_forward_dynamics(
    const struct flexible_joint_state *x,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    struct flexible_joint_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 74 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *          motor link motor.dot link.dot | tau
 * motor'   .     .    1         .        | .
 * link'    .     .    .         1        | .
 * motor''  *     *    *         *        | *
 * link''   *     *    *         *        | .
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int flexible_joint_linearize(
    const struct flexible_joint_state *x,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][1]);

/*
 * Parameter Jacobian dx'/dp, 4 x 8; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int flexible_joint_parameter_jacobian(
    const struct flexible_joint_state *x,
    const struct flexible_joint_inputs *u,
    const struct flexible_joint_parameters *p,
    double by_p[4][8]);

/* Jacobians of the measured outputs. */
void flexible_joint_output_jacobian(
    const struct flexible_joint_state *x,
    const struct flexible_joint_parameters *p,
    double by_x[2][4],
    double by_p[2][8]);

#ifdef __cplusplus
}
#endif

#endif /* FLEXIBLE_JOINT_H */

/*
 * Quanser Aero, two degrees of freedom.
 * Generated from `aero.rig` (model dcde74f4); edit the rig, not this file.
 *
 * A beam with two rotors at its ends on a yoke that turns: the main rotor lifts, the tail rotor pushes
 * sideways, and each turns the beam by its drag too. Speeds follow the voltages. Geometry, masses and
 * coefficients: extended Kalman filter of an NTNU master thesis, 2025
 * (github.com/finnferdinand/orbital-stabilization-quanser-aero); its yaw inertia leaves out
 * m_e d_x^2 (at most 0.3 %), which comes out here.
 *
 * 67 operations forward, 155 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef AERO_H
#define AERO_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct aero_parameters {
    double m_pa;    /* propeller assembly, each [kg] */
    double m_e;     /* motor, each; and the mass that hangs below the axis [kg] */
    double m_rod;   /* beam: 0.089 + 0.089 + 0.280 [kg] */
    double m_y;     /* yoke [kg] */
    double d_t;     /* pitch axis to each rotor [m] */
    double d_x;     /* pitch axis down to the hanging mass [m] */
    double l_t;     /* length of the beam [m] */
    double r_y;     /* radius of the yoke [m] */
    double g;       /* [m/s^2] */
    double K_omega; /* speed of a rotor by its voltage [rad/(V*s)] */
    double K_main;  /* thrust of the main rotor by speed squared [N*s^2] */
    double K_tail;  /* thrust of the tail rotor by speed squared [N*s^2] */
    double D_main;  /* drag torque of the main rotor by speed squared, over d_t [N*s^2] */
    double D_tail;  /* drag torque of the tail rotor by speed squared, over d_t [N*s^2] */
    double c_pitch; /* [N*m*s] */
    double c_yaw;   /* [N*m*s] */
};

/* Coordinates q. */
struct aero_coordinates {
    double yaw;   /* [rad] */
    double pitch; /* nose up positive [rad] */
};

/* Rates v = q'. */
struct aero_rates {
    double yaw;   /* [rad/s] */
    double pitch; /* nose up positive [rad/s] */
};

/* Accelerations a = q''. */
struct aero_accelerations {
    double yaw;   /* [rad/s^2] */
    double pitch; /* nose up positive [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct aero_inputs {
    double V_m; /* main motor [V] */
    double V_t; /* tail motor [V] */
};

/* Measured outputs y. */
struct aero_outputs {
    double yaw;   /* [rad] */
    double pitch; /* [rad] */
};

/* State x = [q | v]. */
struct aero_state {
    struct aero_coordinates q;
    struct aero_rates v;
};

/* The values that the rig's file gives. */
void aero_nominal(struct aero_parameters *p);

/* Mass matrix M(q), 2 x 2, symmetric; rows (yaw, pitch). */
void aero_mass_matrix(const struct aero_coordinates *q, const struct aero_parameters *p, double m[2][2]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (yaw, pitch). */
void aero_bias(const struct aero_coordinates *q, const struct aero_rates *v, const struct aero_parameters *p, double h[2]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (yaw, pitch). */
void aero_velocity_products(const struct aero_coordinates *q, const struct aero_rates *v, const struct aero_parameters *p, double c[2]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (yaw, pitch). */
void aero_gravity(const struct aero_coordinates *q, const struct aero_parameters *p, double g[2]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (yaw, pitch). */
void aero_dissipation(const struct aero_coordinates *q, const struct aero_rates *v, const struct aero_parameters *p, double d[2]);

/* Generalized force Q [N m] of the inputs; rows (yaw, pitch). */
void aero_generalized_force(const struct aero_coordinates *q, const struct aero_inputs *u, const struct aero_parameters *p, double f[2]);

/* Input map dQ/du, 2 x 2; rows (yaw, pitch), columns (V_m, V_t). */
void aero_input_map(const struct aero_coordinates *q, const struct aero_inputs *u, const struct aero_parameters *p, double s[2][2]);

/* Kinetic energy T(q, v) [J]. */
double aero_kinetic_energy(const struct aero_coordinates *q, const struct aero_rates *v, const struct aero_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double aero_potential_energy(const struct aero_coordinates *q, const struct aero_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void aero_inverse_dynamics(
    const struct aero_state *x,
    const struct aero_accelerations *a,
    const struct aero_inputs *u,
    const struct aero_parameters *p,
    double r[2]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void aero_outputs(const struct aero_state *x, const struct aero_parameters *p, struct aero_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void aero_pivots(const struct aero_state *x, const struct aero_parameters *p, double d[2]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 67 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int aero_forward_dynamics(
    const struct aero_state *x,
    const struct aero_inputs *u,
    const struct aero_parameters *p,
    struct aero_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 155 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *          yaw pitch yaw.dot pitch.dot | V_m V_t
 * yaw'     .   .     1       .         | .   .
 * pitch'   .   .     .       1         | .   .
 * yaw''    .   *     *       *         | *   *
 * pitch''  .   *     *       *         | *   *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int aero_linearize(
    const struct aero_state *x,
    const struct aero_inputs *u,
    const struct aero_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][2]);

/*
 * Parameter Jacobian dx'/dp, 4 x 16; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int aero_parameter_jacobian(const struct aero_state *x, const struct aero_inputs *u, const struct aero_parameters *p, double by_p[4][16]);

/* Jacobians of the measured outputs. */
void aero_output_jacobian(const struct aero_state *x, const struct aero_parameters *p, double by_x[2][4], double by_p[2][16]);

#ifdef __cplusplus
}
#endif

#endif /* AERO_H */

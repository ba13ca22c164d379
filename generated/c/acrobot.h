/*
 * Acrobot.
 * Generated from `acrobot.rig` (model 993e11c5); edit the rig, not this file.
 *
 * Two links with a motor at the elbow only: the acrobot of the dm_control suite (suite/acrobot.xml,
 * Tassa et al. 2018, arXiv 1801.00690). Links are capsules of 1 kg and 1 m; both angles are 0 with the
 * arm standing upright, elbow relative to the upper arm.
 *
 * 61 operations forward, 146 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef ACROBOT_H
#define ACROBOT_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct acrobot_parameters {
    double m_1;  /* upper arm [kg] */
    double m_2;  /* lower arm [kg] */
    double l_1;  /* shoulder to elbow [m] */
    double l_c1; /* shoulder to the upper arm's centre [m] */
    double l_c2; /* elbow to the lower arm's centre [m] */
    double I_1;  /* upper arm across, about its centre [kg*m^2] */
    double J_1;  /* upper arm along [kg*m^2] */
    double I_2;  /* lower arm across, about its centre [kg*m^2] */
    double J_2;  /* lower arm along [kg*m^2] */
    double c_1;  /* damping of the shoulder [N*m*s] */
    double c_2;  /* damping of the elbow [N*m*s] */
    double g;    /* [m/s^2] */
};

/* Coordinates q. */
struct acrobot_coordinates {
    double shoulder; /* [rad] */
    double elbow;    /* [rad] */
};

/* Rates v = q'. */
struct acrobot_rates {
    double shoulder; /* [rad/s] */
    double elbow;    /* [rad/s] */
};

/* Accelerations a = q''. */
struct acrobot_accelerations {
    double shoulder; /* [rad/s^2] */
    double elbow;    /* [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct acrobot_inputs {
    double tau; /* elbow motor [N*m] */
};

/* Measured outputs y. */
struct acrobot_outputs {
    double shoulder; /* [rad] */
    double elbow;    /* [rad] */
};

/* State x = [q | v]. */
struct acrobot_state {
    struct acrobot_coordinates q;
    struct acrobot_rates v;
};

/* The values that the rig's file gives. */
void acrobot_nominal(struct acrobot_parameters *p);

/* Mass matrix M(q), 2 x 2, symmetric; rows (shoulder, elbow). */
void acrobot_mass_matrix(const struct acrobot_coordinates *q, const struct acrobot_parameters *p, double m[2][2]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (shoulder, elbow). */
void acrobot_bias(const struct acrobot_coordinates *q, const struct acrobot_rates *v, const struct acrobot_parameters *p, double h[2]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (shoulder, elbow). */
void acrobot_velocity_products(
    const struct acrobot_coordinates *q,
    const struct acrobot_rates *v,
    const struct acrobot_parameters *p,
    double c[2]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (shoulder, elbow). */
void acrobot_gravity(const struct acrobot_coordinates *q, const struct acrobot_parameters *p, double g[2]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (shoulder, elbow). */
void acrobot_dissipation(
    const struct acrobot_coordinates *q,
    const struct acrobot_rates *v,
    const struct acrobot_parameters *p,
    double d[2]);

/* Generalized force Q [N m] of the inputs; rows (shoulder, elbow). */
void acrobot_generalized_force(
    const struct acrobot_coordinates *q,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    double f[2]);

/* Input map dQ/du, 2 x 1; rows (shoulder, elbow), columns (tau). */
void acrobot_input_map(const struct acrobot_coordinates *q, const struct acrobot_parameters *p, double s[2][1]);

/* Kinetic energy T(q, v) [J]. */
double acrobot_kinetic_energy(const struct acrobot_coordinates *q, const struct acrobot_rates *v, const struct acrobot_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double acrobot_potential_energy(const struct acrobot_coordinates *q, const struct acrobot_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void acrobot_inverse_dynamics(
    const struct acrobot_state *x,
    const struct acrobot_accelerations *a,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    double r[2]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void acrobot_outputs(const struct acrobot_state *x, const struct acrobot_parameters *p, struct acrobot_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void acrobot_pivots(const struct acrobot_state *x, const struct acrobot_parameters *p, double d[2]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 61 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int acrobot_forward_dynamics(
    const struct acrobot_state *x,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    struct acrobot_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 146 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *             shoulder elbow shoulder.dot elbow.dot | tau
 * shoulder'   .        .     1            .         | .
 * elbow'      .        .     .            1         | .
 * shoulder''  *        *     *            *         | *
 * elbow''     *        *     *            *         | *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int acrobot_linearize(
    const struct acrobot_state *x,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    double dx[4],
    double a[4][4],
    double b[4][1]);

/*
 * Parameter Jacobian dx'/dp, 4 x 12; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int acrobot_parameter_jacobian(
    const struct acrobot_state *x,
    const struct acrobot_inputs *u,
    const struct acrobot_parameters *p,
    double by_p[4][12]);

/* Jacobians of the measured outputs. */
void acrobot_output_jacobian(const struct acrobot_state *x, const struct acrobot_parameters *p, double by_x[2][4], double by_p[2][12]);

#ifdef __cplusplus
}
#endif

#endif /* ACROBOT_H */

/*
 * Googol GHP2002, single-rigid-body model.
 * Generated from `googol_srb.rig` (model 7ec63ed6); edit the rig, not this file.
 *
 * Eq. 1 to 5 of the seed paper: arm, counterweight and fuselage are one body on a ball joint, l_cd = 0,
 * friction and velocity products neglected. The mass matrix is T^T I T with T of eq. 2 and
 * I = diag(I_theta, I_eps, I_psi) in the body's axes (the first one is the pitch axis; the paper prints
 * the opposite order). Gravity has the sign that physics gives it; eq. 5 prints the other one.
 * Without l_cd there is no pitch stiffness, and at eps = +-90 deg the mass matrix is singular.
 *
 * Assumed: l_cd = 0; no velocity products; no friction.
 * 60 operations forward, 141 with A and B.
 * Derived twice before the assumptions, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef GOOGOL_SRB_H
#define GOOGOL_SRB_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct googol_srb_parameters {
    double m_h;      /* fuselage with both rotors [kg] */
    double m_b;      /* arm [kg] */
    double m_c;      /* counterweight [kg] */
    double g;        /* gravity [m/s^2] */
    double l_oc;     /* elevation axis to pitch axis [m] */
    double l_ob;     /* elevation axis to counterweight [m] */
    double l_oa;     /* elevation axis to the arm's centre [m] */
    double l_cd;     /* pitch axis down to the fuselage [m] */
    double l_df;     /* pitch axis to each rotor, sideways [m] */
    double c0_psi;   /* viscous friction of the column [N*m*s] */
    double c0_eps;   /* viscous friction of the elevation axis [N*m*s] */
    double c0_theta; /* viscous friction of the pitch axis [N*m*s] */
    double I_psi;    /* without friction and velocity products no rate of turn balances the thrust [kg*m^2] */
    double I_eps;    /* about the sideways axis [kg*m^2] */
    double I_theta;  /* about the arm [kg*m^2] */
};

/* Coordinates q. */
struct googol_srb_coordinates {
    double psi;   /* yaw (travel) [rad] */
    double eps;   /* elevation, up positive [rad] */
    double theta; /* pitch [rad] */
};

/* Rates v = q'. */
struct googol_srb_rates {
    double psi;   /* yaw (travel) [rad/s] */
    double eps;   /* elevation, up positive [rad/s] */
    double theta; /* pitch [rad/s] */
};

/* Accelerations a = q''. */
struct googol_srb_accelerations {
    double psi;   /* yaw (travel) [rad/s^2] */
    double eps;   /* elevation, up positive [rad/s^2] */
    double theta; /* pitch [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct googol_srb_inputs {
    double f_1; /* thrust of the rotor at -y [N] */
    double f_2; /* thrust of the rotor at +y [N] */
};

/* Measured outputs y. */
struct googol_srb_outputs {
    double psi;   /* [rad] */
    double eps;   /* [rad] */
    double theta; /* [rad] */
};

/* State x = [q | v]. */
struct googol_srb_state {
    struct googol_srb_coordinates q;
    struct googol_srb_rates v;
};

/* The values that the rig's file gives. */
void googol_srb_nominal(struct googol_srb_parameters *p);

/* Mass matrix M(q), 3 x 3, symmetric; rows (psi, eps, theta). */
void googol_srb_mass_matrix(const struct googol_srb_coordinates *q, const struct googol_srb_parameters *p, double m[3][3]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (psi, eps, theta). */
void googol_srb_bias(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_rates *v,
    const struct googol_srb_parameters *p,
    double h[3]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (psi, eps, theta). */
void googol_srb_velocity_products(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_rates *v,
    const struct googol_srb_parameters *p,
    double c[3]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (psi, eps, theta). */
void googol_srb_gravity(const struct googol_srb_coordinates *q, const struct googol_srb_parameters *p, double g[3]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (psi, eps, theta). */
void googol_srb_dissipation(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_rates *v,
    const struct googol_srb_parameters *p,
    double d[3]);

/* Generalized force Q [N m] of the inputs; rows (psi, eps, theta). */
void googol_srb_generalized_force(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    double f[3]);

/* Input map dQ/du, 3 x 2; rows (psi, eps, theta), columns (f_1, f_2). */
void googol_srb_input_map(const struct googol_srb_coordinates *q, const struct googol_srb_parameters *p, double s[3][2]);

/* Kinetic energy T(q, v) [J]. */
double googol_srb_kinetic_energy(
    const struct googol_srb_coordinates *q,
    const struct googol_srb_rates *v,
    const struct googol_srb_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double googol_srb_potential_energy(const struct googol_srb_coordinates *q, const struct googol_srb_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void googol_srb_inverse_dynamics(
    const struct googol_srb_state *x,
    const struct googol_srb_accelerations *a,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    double r[3]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void googol_srb_outputs(const struct googol_srb_state *x, const struct googol_srb_parameters *p, struct googol_srb_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void googol_srb_pivots(const struct googol_srb_state *x, const struct googol_srb_parameters *p, double d[3]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 60 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int googol_srb_forward_dynamics(
    const struct googol_srb_state *x,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    struct googol_srb_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 141 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *          psi eps theta psi.dot eps.dot theta.dot | f_1 f_2
 * psi'     .   .   .     1       .       .         | .   .
 * eps'     .   .   .     .       1       .         | .   .
 * theta'   .   .   .     .       .       1         | .   .
 * psi''    .   *   *     .       .       .         | *   *
 * eps''    .   *   *     .       .       .         | *   *
 * theta''  .   *   *     .       .       .         | *   *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int googol_srb_linearize(
    const struct googol_srb_state *x,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2]);

/*
 * Parameter Jacobian dx'/dp, 6 x 15; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int googol_srb_parameter_jacobian(
    const struct googol_srb_state *x,
    const struct googol_srb_inputs *u,
    const struct googol_srb_parameters *p,
    double by_p[6][15]);

/* Jacobians of the measured outputs. */
void googol_srb_output_jacobian(
    const struct googol_srb_state *x,
    const struct googol_srb_parameters *p,
    double by_x[3][6],
    double by_p[3][15]);

#ifdef __cplusplus
}
#endif

#endif /* GOOGOL_SRB_H */

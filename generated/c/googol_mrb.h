/*
 * Googol GHP2002, multi-rigid-body model.
 * Generated from `googol_mrb.rig` (model 236cb442); edit the rig, not this file.
 *
 * Eq. 13 of the seed paper, derived: the full physics under the paper's assumptions (no velocity
 * products, a constant diagonal mass matrix). The yaw-by-f_d term comes out without the misprinted
 * factor sin(theta); see `googol_eq13.rig`.
 *
 * Assumed: no velocity products; M = diag(I_psi, I_eps, I_theta).
 * 50 operations forward, 98 with A and B.
 * Derived twice before the assumptions, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef GOOGOL_MRB_H
#define GOOGOL_MRB_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct googol_mrb_parameters {
    double m_h;      /* fuselage with both rotors [kg] */
    double m_b;      /* arm [kg] */
    double m_c;      /* counterweight [kg] */
    double g;        /* gravity [m/s^2] */
    double l_oc;     /* elevation axis to pitch axis [m] */
    double l_ob;     /* elevation axis to counterweight [m] */
    double l_oa;     /* elevation axis to the arm's centre [m] */
    double l_cd;     /* pitch axis down to the fuselage [m] */
    double l_df;     /* pitch axis to each rotor, sideways [m] */
    double I_x;      /* fuselage about its centre, along the arm [kg*m^2] */
    double I_z;      /* fuselage about its centre, upright [kg*m^2] */
    double c0_psi;   /* viscous friction of the column [N*m*s] */
    double c0_eps;   /* viscous friction of the elevation axis [N*m*s] */
    double c0_theta; /* viscous friction of the pitch axis [N*m*s] */
    double I_psi;    /* yaw inertia [kg*m^2] */
    double I_eps;    /* elevation inertia [kg*m^2] */
    double I_theta;  /* pitch inertia [kg*m^2] */
};

/* Coordinates q. */
struct googol_mrb_coordinates {
    double psi;   /* yaw (travel) [rad] */
    double eps;   /* elevation, up positive [rad] */
    double theta; /* pitch [rad] */
};

/* Rates v = q'. */
struct googol_mrb_rates {
    double psi;   /* yaw (travel) [rad/s] */
    double eps;   /* elevation, up positive [rad/s] */
    double theta; /* pitch [rad/s] */
};

/* Accelerations a = q''. */
struct googol_mrb_accelerations {
    double psi;   /* yaw (travel) [rad/s^2] */
    double eps;   /* elevation, up positive [rad/s^2] */
    double theta; /* pitch [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct googol_mrb_inputs {
    double f_1; /* thrust of the rotor at -y [N] */
    double f_2; /* thrust of the rotor at +y [N] */
};

/* Measured outputs y. */
struct googol_mrb_outputs {
    double psi;   /* [rad] */
    double eps;   /* [rad] */
    double theta; /* [rad] */
};

/* State x = [q | v]. */
struct googol_mrb_state {
    struct googol_mrb_coordinates q;
    struct googol_mrb_rates v;
};

/* The values that the rig's file gives. */
void googol_mrb_nominal(struct googol_mrb_parameters *p);

/* Mass matrix M(q), 3 x 3, symmetric; rows (psi, eps, theta). */
void googol_mrb_mass_matrix(const struct googol_mrb_coordinates *q, const struct googol_mrb_parameters *p, double m[3][3]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (psi, eps, theta). */
void googol_mrb_bias(
    const struct googol_mrb_coordinates *q,
    const struct googol_mrb_rates *v,
    const struct googol_mrb_parameters *p,
    double h[3]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (psi, eps, theta). */
void googol_mrb_velocity_products(
    const struct googol_mrb_coordinates *q,
    const struct googol_mrb_rates *v,
    const struct googol_mrb_parameters *p,
    double c[3]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (psi, eps, theta). */
void googol_mrb_gravity(const struct googol_mrb_coordinates *q, const struct googol_mrb_parameters *p, double g[3]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (psi, eps, theta). */
void googol_mrb_dissipation(
    const struct googol_mrb_coordinates *q,
    const struct googol_mrb_rates *v,
    const struct googol_mrb_parameters *p,
    double d[3]);

/* Generalized force Q [N m] of the inputs; rows (psi, eps, theta). */
void googol_mrb_generalized_force(
    const struct googol_mrb_coordinates *q,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
    double f[3]);

/* Input map dQ/du, 3 x 2; rows (psi, eps, theta), columns (f_1, f_2). */
void googol_mrb_input_map(const struct googol_mrb_coordinates *q, const struct googol_mrb_parameters *p, double s[3][2]);

/* Potential energy V(q) [J]: gravity and springs. */
double googol_mrb_potential_energy(const struct googol_mrb_coordinates *q, const struct googol_mrb_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void googol_mrb_inverse_dynamics(
    const struct googol_mrb_state *x,
    const struct googol_mrb_accelerations *a,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
    double r[3]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void googol_mrb_outputs(const struct googol_mrb_state *x, const struct googol_mrb_parameters *p, struct googol_mrb_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void googol_mrb_pivots(const struct googol_mrb_state *x, const struct googol_mrb_parameters *p, double d[3]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 50 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int googol_mrb_forward_dynamics(
    const struct googol_mrb_state *x,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
    struct googol_mrb_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 98 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *          psi eps theta psi.dot eps.dot theta.dot | f_1 f_2
 * psi'     .   .   .     1       .       .         | .   .
 * eps'     .   .   .     .       1       .         | .   .
 * theta'   .   .   .     .       .       1         | .   .
 * psi''    .   *   *     *       .       .         | *   *
 * eps''    .   *   *     .       *       .         | *   *
 * theta''  .   *   *     .       .       *         | *   *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int googol_mrb_linearize(
    const struct googol_mrb_state *x,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2]);

/*
 * Parameter Jacobian dx'/dp, 6 x 17; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int googol_mrb_parameter_jacobian(
    const struct googol_mrb_state *x,
    const struct googol_mrb_inputs *u,
    const struct googol_mrb_parameters *p,
    double by_p[6][17]);

/* Jacobians of the measured outputs. */
void googol_mrb_output_jacobian(
    const struct googol_mrb_state *x,
    const struct googol_mrb_parameters *p,
    double by_x[3][6],
    double by_p[3][17]);

#ifdef __cplusplus
}
#endif

#endif /* GOOGOL_MRB_H */

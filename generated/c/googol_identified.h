/*
 * Googol GHP2002, identified model.
 * Generated from `googol_identified.rig` (model 020c6d91); edit the rig, not this file.
 *
 * Eq. 16 of the seed paper as printed, accelerations written directly. Each lump keeps its
 * definition over Table 1 behind its identified value; `--expand-lumps` uses the definitions.
 * The paper used two values of c_eps: 0.10 in the open-loop comparison and in eq. 17, 0.3010 in the
 * control design (eq. 26). The rig carries the latter; `--set c_eps=0.10` gives eq. 17.
 *
 * 33 operations forward, 64 with A and B.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef GOOGOL_IDENTIFIED_H
#define GOOGOL_IDENTIFIED_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct googol_identified_parameters {
    double m_h;     /* fuselage with both rotors [kg] */
    double m_b;     /* arm [kg] */
    double m_c;     /* counterweight [kg] */
    double g;       /* gravity [m/s^2] */
    double l_oc;    /* elevation axis to pitch axis [m] */
    double l_ob;    /* elevation axis to counterweight [m] */
    double l_oa;    /* elevation axis to the arm's centre [m] */
    double l_cd;    /* pitch axis down to the fuselage [m] */
    double l_df;    /* pitch axis to each rotor, sideways [m] */
    double I_psi;   /* yaw inertia [kg*m^2] */
    double I_eps;   /* elevation inertia [kg*m^2] */
    double I_theta; /* pitch inertia [kg*m^2] */
    double a1;      /* [1/s^2] */
    double a2;      /* [1/s^2] */
    double a3;      /* [1/s^2] */
    double b1;      /* [1/(kg*m)] */
    double b2;      /* [1/(kg*m)] */
    double b3;      /* [1/(kg*m)] */
    double b4;      /* [1/(kg*m)] */
    double c_psi;   /* yaw damping over inertia [1/s] */
    double c_eps;   /* elevation damping over inertia [1/s] */
    double c_theta; /* pitch damping over inertia [1/s] */
};

/* Coordinates q. */
struct googol_identified_coordinates {
    double psi;   /* yaw (travel) [rad] */
    double eps;   /* elevation [rad] */
    double theta; /* pitch [rad] */
};

/* Rates v = q'. */
struct googol_identified_rates {
    double psi;   /* yaw (travel) [rad/s] */
    double eps;   /* elevation [rad/s] */
    double theta; /* pitch [rad/s] */
};

/* Accelerations a = q''. */
struct googol_identified_accelerations {
    double psi;   /* yaw (travel) [rad/s^2] */
    double eps;   /* elevation [rad/s^2] */
    double theta; /* pitch [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct googol_identified_inputs {
    double f_1; /* thrust of the rotor at -y [N] */
    double f_2; /* thrust of the rotor at +y [N] */
};

/* Measured outputs y. */
struct googol_identified_outputs {
    double psi;   /* [rad] */
    double eps;   /* [rad] */
    double theta; /* [rad] */
};

/* State x = [q | v]. */
struct googol_identified_state {
    struct googol_identified_coordinates q;
    struct googol_identified_rates v;
};

/* The values that the rig's file gives. */
void googol_identified_nominal(struct googol_identified_parameters *p);

/* Mass matrix M(q), 3 x 3, symmetric; rows (psi, eps, theta). */
void googol_identified_mass_matrix(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_parameters *p,
    double m[3][3]);

/* Bias h(q, v) [unit of the row]: terms without rates and inputs, on the left-hand side; rows (psi, eps, theta). */
void googol_identified_bias(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_rates *v,
    const struct googol_identified_parameters *p,
    double h[3]);

/* Bias of the equations as written [unit of the row]; rows (psi, eps, theta). */
void googol_identified_gravity(const struct googol_identified_coordinates *q, const struct googol_identified_parameters *p, double g[3]);

/* Friction and dampers d(q, v) [unit of the row], on the left-hand side; rows (psi, eps, theta). */
void googol_identified_dissipation(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_rates *v,
    const struct googol_identified_parameters *p,
    double d[3]);

/* Generalized force Q [unit of the row] of the inputs; rows (psi, eps, theta). */
void googol_identified_generalized_force(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    double f[3]);

/* Input map dQ/du, 3 x 2; rows (psi, eps, theta), columns (f_1, f_2). */
void googol_identified_input_map(
    const struct googol_identified_coordinates *q,
    const struct googol_identified_parameters *p,
    double s[3][2]);

/*
 * Inverse dynamics M a + h + d - Q [unit of the row]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void googol_identified_inverse_dynamics(
    const struct googol_identified_state *x,
    const struct googol_identified_accelerations *a,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    double r[3]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void googol_identified_outputs(
    const struct googol_identified_state *x,
    const struct googol_identified_parameters *p,
    struct googol_identified_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void googol_identified_pivots(const struct googol_identified_state *x, const struct googol_identified_parameters *p, double d[3]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 33 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int googol_identified_forward_dynamics(
    const struct googol_identified_state *x,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    struct googol_identified_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 64 operations.
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
int googol_identified_linearize(
    const struct googol_identified_state *x,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    double dx[6],
    double a[6][6],
    double b[6][2]);

/*
 * Parameter Jacobian dx'/dp, 6 x 22; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int googol_identified_parameter_jacobian(
    const struct googol_identified_state *x,
    const struct googol_identified_inputs *u,
    const struct googol_identified_parameters *p,
    double by_p[6][22]);

/* Jacobians of the measured outputs. */
void googol_identified_output_jacobian(
    const struct googol_identified_state *x,
    const struct googol_identified_parameters *p,
    double by_x[3][6],
    double by_p[3][22]);

#ifdef __cplusplus
}
#endif

#endif /* GOOGOL_IDENTIFIED_H */

/*
 * Two arms on one column.
 * Generated from `tree.rig` (model 42640007); edit the rig, not this file.
 *
 * A branching rig: a driven column carries a left and a right arm, each with a shoulder that lifts it; the
 * right one has an elbow too. The arms push on one another through the column. A test bed of our own
 * (no published rig of this kind comes with numbers): tubes of 0.5 kg/m, hubs of 0.2 kg.
 *
 * 219 operations forward, 598 with A and B.
 * Derived twice, body by body and by Lagrange: they agree; the power balance holds.
 *
 * M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
 */
#ifndef TREE_H
#define TREE_H

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters p. */
struct tree_parameters {
    double I_c;   /* column with its motor [kg*m^2] */
    double a;     /* column's axis to either shoulder [m] */
    double l;     /* left arm [m] */
    double l_u;   /* right upper arm [m] */
    double l_f;   /* right forearm [m] */
    double rho;   /* tubes [kg/m] */
    double m_e;   /* hub at the right elbow [kg] */
    double m_t;   /* weight at the left tip [kg] */
    double c_psi; /* column [N*m*s] */
    double c_s;   /* shoulders and elbow [N*m*s] */
    double g;     /* [m/s^2] */
};

/* Coordinates q. */
struct tree_coordinates {
    double psi;   /* column [rad] */
    double left;  /* left shoulder, up positive [rad] */
    double right; /* right shoulder, up positive [rad] */
    double elbow; /* right elbow, relative [rad] */
};

/* Rates v = q'. */
struct tree_rates {
    double psi;   /* column [rad/s] */
    double left;  /* left shoulder, up positive [rad/s] */
    double right; /* right shoulder, up positive [rad/s] */
    double elbow; /* right elbow, relative [rad/s] */
};

/* Accelerations a = q''. */
struct tree_accelerations {
    double psi;   /* column [rad/s^2] */
    double left;  /* left shoulder, up positive [rad/s^2] */
    double right; /* right shoulder, up positive [rad/s^2] */
    double elbow; /* right elbow, relative [rad/s^2] */
};

/* Signals u: inputs, then accelerations of prescribed coordinates. */
struct tree_inputs {
    double tau_psi; /* [N*m] */
    double tau_l;   /* [N*m] */
    double tau_r;   /* [N*m] */
    double tau_e;   /* [N*m] */
};

/* Measured outputs y. */
struct tree_outputs {
    double psi;   /* [rad] */
    double left;  /* [rad] */
    double right; /* [rad] */
    double elbow; /* [rad] */
};

/* State x = [q | v]. */
struct tree_state {
    struct tree_coordinates q;
    struct tree_rates v;
};

/* The values that the rig's file gives. */
void tree_nominal(struct tree_parameters *p);

/* Mass matrix M(q), 4 x 4, symmetric; rows (psi, left, right, elbow). */
void tree_mass_matrix(const struct tree_coordinates *q, const struct tree_parameters *p, double m[4][4]);

/* Bias h(q, v) [N m]: velocity products + gravity + springs; rows (psi, left, right, elbow). */
void tree_bias(const struct tree_coordinates *q, const struct tree_rates *v, const struct tree_parameters *p, double h[4]);

/* Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (psi, left, right, elbow). */
void tree_velocity_products(const struct tree_coordinates *q, const struct tree_rates *v, const struct tree_parameters *p, double c[4]);

/* Generalized gravity g(q) [N m]: what holds the rig still; rows (psi, left, right, elbow). */
void tree_gravity(const struct tree_coordinates *q, const struct tree_parameters *p, double g[4]);

/* Friction and dampers d(q, v) [N m], on the left-hand side; rows (psi, left, right, elbow). */
void tree_dissipation(const struct tree_coordinates *q, const struct tree_rates *v, const struct tree_parameters *p, double d[4]);

/* Generalized force Q [N m] of the inputs; rows (psi, left, right, elbow). */
void tree_generalized_force(const struct tree_coordinates *q, const struct tree_inputs *u, const struct tree_parameters *p, double f[4]);

/* Input map dQ/du, 4 x 4; rows (psi, left, right, elbow), columns (tau_psi, tau_l, tau_r, tau_e). */
void tree_input_map(const struct tree_coordinates *q, const struct tree_parameters *p, double s[4][4]);

/* Kinetic energy T(q, v) [J]. */
double tree_kinetic_energy(const struct tree_coordinates *q, const struct tree_rates *v, const struct tree_parameters *p);

/* Potential energy V(q) [J]: gravity and springs. */
double tree_potential_energy(const struct tree_coordinates *q, const struct tree_parameters *p);

/*
 * Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
 * zero where a, v, q and u fit together.
 */
void tree_inverse_dynamics(
    const struct tree_state *x,
    const struct tree_accelerations *a,
    const struct tree_inputs *u,
    const struct tree_parameters *p,
    double r[4]);

/* Measured outputs y(x), with scale and bias, without delay and quantization. */
void tree_outputs(const struct tree_state *x, const struct tree_parameters *p, struct tree_outputs *y);

/*
 * Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
 * positive definite; a vanishing one says which coordinate moves no inertia.
 */
void tree_pivots(const struct tree_state *x, const struct tree_parameters *p, double d[4]);

/*
 * Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
 * 219 operations.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int tree_forward_dynamics(
    const struct tree_state *x,
    const struct tree_inputs *u,
    const struct tree_parameters *p,
    struct tree_accelerations *a);

/*
 * State derivative and its Jacobians A, B, exact, at any state.
 * 598 operations.
 *
 * Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
 *          psi left right elbow psi.dot left.dot right.dot elbow.dot | tau_psi tau_l tau_r tau_e
 * psi'     .   .    .     .     1       .        .         .         | .       .     .     .
 * left'    .   .    .     .     .       1        .         .         | .       .     .     .
 * right'   .   .    .     .     .       .        1         .         | .       .     .     .
 * elbow'   .   .    .     .     .       .        .         1         | .       .     .     .
 * psi''    .   *    *     *     *       *        *         *         | *       .     .     .
 * left''   .   *    .     .     *       *        .         .         | .       *     .     .
 * right''  .   .    *     *     *       .        *         *         | .       .     *     *
 * elbow''  .   .    *     *     *       .        *         *         | .       .     *     *
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int tree_linearize(
    const struct tree_state *x,
    const struct tree_inputs *u,
    const struct tree_parameters *p,
    double dx[8],
    double a[8][8],
    double b[8][4]);

/*
 * Parameter Jacobian dx'/dp, 8 x 11; columns in the order of Parameters.
 *
 * Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;
 * then the results are not written.
 */
int tree_parameter_jacobian(const struct tree_state *x, const struct tree_inputs *u, const struct tree_parameters *p, double by_p[8][11]);

/* Jacobians of the measured outputs. */
void tree_output_jacobian(const struct tree_state *x, const struct tree_parameters *p, double by_x[4][8], double by_p[4][11]);

#ifdef __cplusplus
}
#endif

#endif /* TREE_H */

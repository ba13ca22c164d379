//! Forward dynamics of `rigs/heli3.rig` written by hand: what this machine can do.
//!
//! With (wx, wy, wz) the fuselage's angular velocity in its own axes, twice the kinetic energy is
//! `K_y eps'^2 + K_z (cos(eps) psi')^2 + A wx^2 + B wy^2 + D wz^2 - 2 E wx wz`; (Lx, Ly, Lz) are its slopes.

/// x' of x = [psi, eps, theta, and their rates], u = [f_1, f_2], p in the order of the rig.
#[inline(never)]
#[allow(non_snake_case, clippy::similar_names)]
#[must_use]
pub fn heli3(x: &[f64; 6], u: &[f64; 2], p: &[f64; 16]) -> [f64; 6] {
    let [_, eps, theta, psi_dot, eps_dot, theta_dot] = *x;
    let [m_h, m_b, m_c, g, l_oc, l_ob, l_cd, l_oa, l_df, J_p, J_ay, J_az, J_hy, c_psi, c_eps, c_theta] = *p;
    let (s, c) = eps.sin_cos();
    let (S, C) = theta.sin_cos();

    let on_arm = m_b * l_oa * l_oa + m_c * l_ob * l_ob;
    let (K_y, K_z) = (on_arm + J_ay, on_arm + J_az);
    let (hang, carried, E) = (m_h * l_cd * l_cd, m_h * l_oc * l_oc, m_h * l_cd * l_oc);
    let (A, B, D) = (hang + J_p, hang + carried + J_hy, carried + J_hy);

    let (Sc, Cc) = (S * c, C * c);
    let m11 = K_z * c * c + A * s * s + B * Sc * Sc + D * Cc * Cc - 2.0 * E * s * Cc;
    let m12 = (D - B) * S * Cc - E * s * S;
    let m13 = A * s - E * Cc;
    let m22 = K_y + B * C * C + D * S * S;
    let m23 = -E * S;
    let m33 = A;

    let wx = s * psi_dot + theta_dot;
    let wy = Sc * psi_dot - C * eps_dot;
    let wz = Cc * psi_dot + S * eps_dot;
    let (Lx, Ly, Lz) = (A * wx - E * wz, B * wy, D * wz - E * wx);
    let product = eps_dot * psi_dot;
    let wx_dot = c * product;
    let wy_dot = theta_dot * wz - S * s * product;
    let wz_dot = -theta_dot * wy - C * s * product;
    let (Lx_dot, Ly_dot, Lz_dot) = (A * wx_dot - E * wz_dot, B * wy_dot, D * wz_dot - E * wx_dot);
    let up = S * Ly + C * Lz;
    let out = theta_dot * (C * Ly - S * Lz) + S * Ly_dot + C * Lz_dot;
    let h1 = c * (eps_dot * Lx + out) - s * (2.0 * K_z * c * product + eps_dot * up - Lx_dot);
    let h2 = theta_dot * up - C * Ly_dot + S * Lz_dot - psi_dot * (c * Lx - s * up) + K_z * s * c * psi_dot * psi_dot;
    let h3 = Lx_dot - Ly * wz + Lz * wy;
    let weight = g * m_h * l_cd;
    let g2 = g * (m_c * l_ob - m_b * l_oa - m_h * l_oc) * c + weight * C * s;
    let g3 = weight * Sc;

    let (f_s, turn) = ((u[0] + u[1]) * l_oc, (u[0] - u[1]) * l_df);
    let r1 = f_s * Sc + turn * s - c_psi * psi_dot - h1;
    let r2 = -f_s * C - c_eps * eps_dot - h2 - g2;
    let r3 = turn - c_theta * theta_dot - h3 - g3;

    // pitch is eliminated first: its pivot is a constant
    let i3 = 1.0 / m33;
    let (l1, l2) = (m13 * i3, m23 * i3);
    let (a11, a12, a22) = (m11 - l1 * m13, m12 - l1 * m23, m22 - l2 * m23);
    let (b1, b2) = (r1 - l1 * r3, r2 - l2 * r3);
    let determinant = 1.0 / (a11 * a22 - a12 * a12);
    let psi_ddot = (a22 * b1 - a12 * b2) * determinant;
    let eps_ddot = (a11 * b2 - a12 * b1) * determinant;
    let theta_ddot = (r3 - m13 * psi_ddot - m23 * eps_ddot) * i3;
    [psi_dot, eps_dot, theta_dot, psi_ddot, eps_ddot, theta_ddot]
}

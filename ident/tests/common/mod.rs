//! Folders for the tests' files, repeatable random bytes, a model of names only.
#![allow(dead_code, clippy::too_many_arguments)]

use std::path::{Path, PathBuf};

/// The small MAT files that SciPy made (`tests/records/make.py`).
pub fn made(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/records").join(name)
}

/// A folder of the test's own.
pub fn folder(test: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n.max(1) as u64) as usize
    }
    /// Flips, overwrites, cuts, doubles; one to four times.
    pub fn mutate(&mut self, bytes: &mut Vec<u8>) {
        for _ in 0..=self.below(3) {
            if bytes.is_empty() {
                return;
            }
            let at = self.below(bytes.len());
            match self.below(6) {
                0 => bytes[at] ^= 1 << self.below(8),
                1 => bytes[at] = self.bits() as u8,
                2 => bytes.truncate(at),
                3 => {
                    let word = [0_u32, 1, 7, 0x7fff_ffff, 0x8000_0000, u32::MAX, 0x0004_0001, 14, 15][self.below(9)];
                    let at = at & !3;
                    bytes.iter_mut().skip(at).zip(word.to_le_bytes()).for_each(|(b, w)| *b = w);
                }
                4 => {
                    let part = bytes[at..(at + self.below(64)).min(bytes.len())].to_vec();
                    bytes.splice(at..at, part);
                }
                _ => {
                    let end = (at + self.below(16)).min(bytes.len());
                    bytes.drain(at..end);
                }
            }
        }
    }
}

/// theta'' = p0 sin theta - p1 theta' + z, z' = (p2 u - z) / p3: hangs for p0 < 0, stands for p0 > 0, driven through a lag.
pub struct Pendulum;

impl runtime::Names for Pendulum {
    fn rig(&self) -> &str {
        "pendulum"
    }
    fn state(&self, i: usize) -> &str {
        ["theta", "theta.dot", "u.lag"][i]
    }
    fn signal(&self, _: usize) -> &str {
        "u"
    }
    fn parameter(&self, i: usize) -> &str {
        ["k", "c", "b", "tau"][i]
    }
    fn output(&self, _: usize) -> &str {
        "theta"
    }
    fn parameter_unit(&self, _: usize) -> &str {
        "1"
    }
    fn signal_unit(&self, _: usize) -> &str {
        "V"
    }
    fn output_unit(&self, _: usize) -> &str {
        "rad"
    }
}

impl runtime::Model for Pendulum {
    fn dimensions(&self) -> runtime::Dimensions {
        runtime::Dimensions { coordinates: 1, lags: 1, inputs: 1, exogenous: 0, parameters: 4, outputs: 1 }
    }
    fn names(&self) -> &dyn runtime::Names {
        self
    }
    fn nominal(&self, p: &mut [f64]) {
        p.copy_from_slice(&[-9.81, 0.2, 2.0, 0.05]);
    }
    fn rhs(&self, _: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), runtime::Singular> {
        dx.copy_from_slice(&[x[1], p[0] * x[0].sin() - p[1] * x[1] + x[2], (p[2] * u[0] - x[2]) / p[3]]);
        Ok(())
    }
    fn linearize(
        &self,
        t: f64,
        x: &[f64],
        u: &[f64],
        p: &[f64],
        dx: &mut [f64],
        a: &mut [f64],
        b: &mut [f64],
    ) -> Result<(), runtime::Singular> {
        a.copy_from_slice(&[0.0, 1.0, 0.0, p[0] * x[0].cos(), -p[1], 1.0, 0.0, 0.0, -1.0 / p[3]]);
        b.copy_from_slice(&[0.0, 0.0, p[2] / p[3]]);
        self.rhs(t, x, u, p, dx)
    }
    fn parameter_jacobian(&self, _: f64, x: &[f64], u: &[f64], p: &[f64], dfdp: &mut [f64]) -> Result<(), runtime::Singular> {
        dfdp.copy_from_slice(&[
            0.0,
            0.0,
            0.0,
            0.0,
            x[0].sin(),
            -x[1],
            0.0,
            0.0,
            0.0,
            0.0,
            u[0] / p[3],
            -(p[2] * u[0] - x[2]) / (p[3] * p[3]),
        ]);
        Ok(())
    }
    fn outputs(&self, _: f64, x: &[f64], _: &[f64], y: &mut [f64]) {
        y[0] = x[0];
    }
    fn output_jacobian(&self, _: f64, _: &[f64], _: &[f64], c: &mut [f64], dhdp: &mut [f64]) {
        c.copy_from_slice(&[1.0, 0.0, 0.0]);
        dhdp.fill(0.0);
    }
    fn input_path(&self, _: usize, _: &[f64]) -> runtime::InputPath {
        runtime::InputPath { limits: (-10.0, 10.0), delay: 0.0 }
    }
    fn output_path(&self, _: usize, _: &[f64]) -> runtime::OutputPath {
        runtime::OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false }
    }
}

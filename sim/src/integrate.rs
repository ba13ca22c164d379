//! One smooth piece of a run: adaptive steps of the library `differential-equations` over a segment of the signals.
//!
//! Dormand and Prince's 5(4) (Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I", II.5) until its steps
//! are limited by stability, then Radau5 (Hairer, Wanner, "Solving Ordinary Differential Equations II", IV.8) with the
//! model's exact Jacobian. What the library does not do is done here: a step ends at every switch and at every time whose
//! state is wanted (its dense output is far less accurate than its steps: 2e-7 where they err by 5e-10), a step that met a
//! singular mass matrix or a number that is not finite counts as rejected, and a step size that the time cannot resolve
//! ends the run.

use crate::signals::Segment;
use differential_equations::error::Error;
use differential_equations::linalg::Matrix;
use differential_equations::methods::{ExplicitRungeKutta, ImplicitRungeKutta};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::status::Status as Step;
use differential_equations::traits::State;
use nalgebra::DMatrix;
use runtime::Model;
use std::cell::{Cell, RefCell};

/// Which method integrates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Explicit, and implicit from where the explicit one is limited by stability.
    #[default]
    Auto,
    /// Dormand-Prince 5(4).
    Explicit,
    /// Radau5; up to 64 states, beyond that the explicit one.
    Implicit,
}

/// What went wrong in the right-hand side during a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Fault {
    /// Index of the coordinate.
    Singular(usize),
    /// Index of the state whose derivative is not finite.
    NotFinite(usize),
}

/// Why a segment was not finished.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Stop {
    Fault(Fault),
    Collapsed,
    TooManySteps,
    /// Not an end: go on with the implicit method.
    Stiff,
}

/// Tolerances and budget.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Control {
    pub relative: f64,
    pub absolute: f64,
    pub max_steps: usize,
}

/// A run in progress.
pub(crate) struct Integrator<'a> {
    pub model: &'a dyn Model,
    pub p: &'a [f64],
    pub control: Control,
    pub method: Method,
    /// Size of the next step [s]; zero before the first one.
    pub h: f64,
    /// Steps so far, rejected ones included.
    pub steps: usize,
    /// Consecutive findings that stability limits the step.
    pub stiff: usize,
}

/// A state of the library: the model's states, and where its size is fixed at compile time, zeros behind them.
trait Vector: State<f64> {
    fn of(x: &[f64]) -> Self;
    fn slice(&self) -> &[f64];
    fn slice_mut(&mut self) -> &mut [f64];
}

impl Vector for Vec<f64> {
    fn of(x: &[f64]) -> Self {
        x.to_vec()
    }
    fn slice(&self) -> &[f64] {
        self
    }
    fn slice_mut(&mut self) -> &mut [f64] {
        self
    }
}

impl<const N: usize> Vector for [f64; N] {
    fn of(x: &[f64]) -> Self {
        let mut out = [0.0; N];
        out[..x.len()].copy_from_slice(x);
        out
    }
    fn slice(&self) -> &[f64] {
        self
    }
    fn slice_mut(&mut self) -> &mut [f64] {
        self
    }
}

struct RightHandSide<'a> {
    model: &'a dyn Model,
    p: &'a [f64],
    segment: &'a Segment,
    u: RefCell<Vec<f64>>,
    fault: Cell<Option<Fault>>,
    states: usize,
}

impl RightHandSide<'_> {
    fn derivative(&self, t: f64, x: &[f64], dx: &mut [f64]) {
        let mut u = self.u.borrow_mut();
        self.segment.at(t, &mut u);
        let fault = match self.model.rhs(t, x, &u, self.p, dx) {
            Err(singular) => Some(Fault::Singular(singular.coordinate)),
            Ok(()) => dx.iter().position(|d| !d.is_finite()).map(Fault::NotFinite),
        };
        if fault.is_some() {
            // makes the error estimate of this step NaN
            dx.fill(f64::NAN);
            self.fault.set(fault);
        }
    }

    /// A = df/dx, row-major; NaN where the mass matrix is singular.
    fn slope(&self, t: f64, x: &[f64]) -> Vec<f64> {
        let n = self.states;
        let mut u = self.u.borrow_mut();
        self.segment.at(t, &mut u);
        let (mut dx, mut a, mut b) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * u.len()]);
        if let Err(singular) = self.model.linearize(t, x, &u, self.p, &mut dx, &mut a, &mut b) {
            self.fault.set(Some(Fault::Singular(singular.coordinate)));
            a.fill(f64::NAN);
        }
        a
    }
}

impl<Y: Vector> ODE<f64, Y> for RightHandSide<'_> {
    fn diff(&self, t: f64, x: &Y, dx: &mut Y) {
        let n = self.states;
        let dx = dx.slice_mut();
        dx[n..].fill(0.0);
        self.derivative(t, &x.slice()[..n], &mut dx[..n]);
    }

    fn jacobian(&self, t: f64, x: &Y, j: &mut Matrix<f64>) {
        let n = self.states;
        let a = self.slope(t, &x.slice()[..n]);
        for row in 0..n {
            for column in 0..n {
                j[(row, column)] = a[row * n + column];
            }
        }
    }
}

/// Steps between two looks at the eigenvalues, and how many bad looks in a row call for the implicit method.
const LOOK: usize = 50;
const LOOKS: usize = 4;
/// h |lambda| at which the explicit method is near the border of its stability region (3.3 on the negative axis).
const BORDER: f64 = 2.5;

type Out<'a> = dyn FnMut(usize, &[f64]) + 'a;

impl Integrator<'_> {
    /// From `segment.from` with the state `x` to `segment.to`, where `x` is left. `times` increase and lie in
    /// (from, to]; `out(k, x)` is called for each that is reached. Returns where and why the run stopped early.
    pub fn run(&mut self, segment: &Segment, x: &mut [f64], times: &[f64], out: &mut Out) -> Result<(), (f64, Stop)> {
        let mut done = 0;
        let mut from = segment.from;
        loop {
            let shifted = Segment { from, to: segment.to, values: vec![0.0; segment.values.len()], slopes: segment.slopes.clone() };
            let mut rest = Segment { values: segment.values.clone(), ..shifted };
            segment.at(from, &mut rest.values);
            let mut reached = done;
            let result = {
                let mut count = |k: usize, x: &[f64]| {
                    reached = done + k + 1;
                    out(done + k, x);
                };
                self.piece(&rest, x, &times[done..], &mut count)
            };
            done = reached;
            match result {
                Err((t, Stop::Stiff)) => {
                    self.method = Method::Implicit;
                    from = t;
                }
                other => return other,
            }
        }
    }

    fn piece(&mut self, segment: &Segment, x: &mut [f64], times: &[f64], out: &mut Out) -> Result<(), (f64, Stop)> {
        let n = x.len();
        let rhs = RightHandSide {
            model: self.model,
            p: self.p,
            segment,
            u: RefCell::new(segment.values.clone()),
            fault: Cell::new(None),
            states: n,
        };
        if self.h == 0.0 {
            self.h = first_step(&rhs, segment.from, x, self.control).min(segment.to - segment.from);
        }
        let Control { relative, absolute, .. } = self.control;
        let explicit = move |h: f64| ExplicitRungeKutta::dopri5().rtol(relative).atol(absolute).h0(h).max_steps(usize::MAX);
        // Radau5 works with 0.1 tolerance^(2/3): take that back. One tolerance for each state, since the library does this
        // to a common one once for each state.
        let squeezed = (10.0 * relative).powf(1.5).max(1e-14);
        macro_rules! implicit {
            ($n:literal) => {{
                let make = move |h: f64| {
                    ImplicitRungeKutta::radau5()
                        .rtol(vec![squeezed; $n])
                        .atol(vec![squeezed * absolute / relative; $n])
                        .h0(h)
                        .max_steps(usize::MAX)
                };
                self.steps::<[f64; $n], _>(&rhs, make, x, times, out)
            }};
        }
        match (self.method, n) {
            (Method::Implicit, ..=8) => implicit!(8),
            (Method::Implicit, ..=16) => implicit!(16),
            (Method::Implicit, ..=32) => implicit!(32),
            (Method::Implicit, ..=64) => implicit!(64),
            _ => self.steps::<Vec<f64>, _>(&rhs, explicit, x, times, out),
        }
    }

    fn steps<Y: Vector, S: OrdinaryNumericalMethod<f64, Y>>(
        &mut self,
        rhs: &RightHandSide,
        make: impl Fn(f64) -> S,
        x: &mut [f64],
        times: &[f64],
        out: &mut Out,
    ) -> Result<(), (f64, Stop)> {
        let n = x.len();
        let (mut t, to) = (rhs.segment.from, rhs.segment.to);
        // a step that cannot be told apart from nothing
        let smallest = 16.0 * f64::EPSILON * t.abs().max(to.abs());
        let implicit = self.method == Method::Implicit && n <= 64;
        let watch = self.method == Method::Auto && n <= 64;
        let mut next = 0;
        let mut last_fault = None;
        while t < to {
            let too_small = |h: f64| h.is_nan() || h <= smallest;
            let mut fresh = true;
            let mut solver = make(self.h.min(times.get(next).copied().unwrap_or(to) - t));
            rhs.fault.set(None);
            if solver.init(rhs, t, to, &Y::of(x)).is_err() {
                return Err((t, rhs.fault.get().map_or(Stop::Collapsed, Stop::Fault)));
            }
            if let Some(fault) = rhs.fault.get() {
                return Err((t, Stop::Fault(fault)));
            }
            solver.set_status(Step::Solving);
            // until the segment is done, or the solver has to be started anew
            while t < to {
                let target = times.get(next).copied().unwrap_or(to);
                let planned = self.h;
                // never a remainder that is but rounding
                let arrives = planned >= (target - t) * (1.0 - 1e-9);
                let h = if arrives { target - t } else { planned };
                // Radau5 keeps the factors of its matrices, which hold for one step size
                if implicit && !fresh && h != solver.h() {
                    break;
                }
                fresh = false;
                solver.set_h(h);
                if self.steps >= self.control.max_steps {
                    return Err((t, Stop::TooManySteps));
                }
                self.steps += 1;
                rhs.fault.set(None);
                let result = solver.step(rhs);
                let fault = rhs.fault.get();
                last_fault = fault.or(last_fault);
                let failed = || (t, last_fault.map_or(Stop::Collapsed, Stop::Fault));
                let finite = solver.y().slice().iter().all(|x| x.is_finite());
                match result {
                    Ok(_) if matches!(solver.status(), Step::RejectedStep) && solver.t() <= t && finite => {
                        self.h = solver.h();
                        if too_small(self.h) {
                            return Err(failed());
                        }
                        continue;
                    }
                    Ok(_) if fault.is_none() && finite && solver.t() > t => {}
                    // the library's own limits on small steps and stiffness, or a step that was accepted although the
                    // derivative at its end does not exist: begin anew, and shorter
                    Ok(_) | Err(Error::Stiffness { .. } | Error::StepSize { .. } | Error::LinearAlgebra { .. }) => {
                        self.h = 0.5 * planned.min(target - t);
                        if too_small(self.h) {
                            return Err(failed());
                        }
                        break;
                    }
                    Err(_) => return Err(failed()),
                }
                last_fault = None;
                let reached = if arrives { target } else { solver.t() };
                let taken = reached - t;
                t = reached;
                x.copy_from_slice(&solver.y().slice()[..n]);
                if times.get(next) == Some(&t) {
                    out(next, x);
                    next += 1;
                }
                // a step that was cut short says little about the next one
                self.h = if arrives { planned.max(solver.h()) } else { solver.h() };
                if watch && self.steps.is_multiple_of(LOOK) {
                    self.stiff = if taken * fastest_decay(rhs, t, x) > BORDER { self.stiff + 1 } else { 0 };
                    if self.stiff >= LOOKS {
                        return Err((t, Stop::Stiff));
                    }
                }
            }
        }
        Ok(())
    }
}

/// Largest |lambda| among the eigenvalues of A that decay [1/s]; zero where there are none.
fn fastest_decay(rhs: &RightHandSide, t: f64, x: &[f64]) -> f64 {
    let a = rhs.slope(t, x);
    if !a.iter().all(|a| a.is_finite()) {
        return 0.0;
    }
    let eigenvalues = DMatrix::from_row_slice(x.len(), x.len(), &a).complex_eigenvalues();
    eigenvalues.iter().filter(|l| l.re < 0.0 && -l.re > l.im.abs()).map(|l| l.norm()).fold(0.0, f64::max)
}

/// A first guess: the time in which the state moves by 1 % of its size; the error control corrects it.
fn first_step(rhs: &RightHandSide, t: f64, x: &[f64], control: Control) -> f64 {
    let mut dx = vec![0.0; x.len()];
    rhs.derivative(t, x, &mut dx);
    let scaled =
        |v: &[f64]| v.iter().zip(x).map(|(v, x)| (v / (control.absolute + control.relative * x.abs())).powi(2)).sum::<f64>().sqrt();
    let (size, speed) = (scaled(x), scaled(&dx));
    if size > 1e-5 && speed > 1e-5 && speed.is_finite() { 0.01 * size / speed } else { 1e-6 }
}

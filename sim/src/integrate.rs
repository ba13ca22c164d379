//! One smooth piece of a run: adaptive steps of the library `differential-equations` over a segment of the signals.
//!
//! The library's DOP853 (Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I", II.5 and II.10: order 8
//! with dense output of order 7) takes states whose size is known at run time. What it does not do is done here: it never
//! steps over a switch, a step that met a singular mass matrix or a number that is not finite counts as rejected, and a
//! step size that the time cannot resolve ends the run.

use crate::signals::Segment;
use differential_equations::error::Error;
use differential_equations::interpolate::Interpolation;
use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::status::Status as Step;
use runtime::Model;
use std::cell::{Cell, RefCell};

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
    /// Size of the next step [s]; zero before the first one.
    pub h: f64,
    /// Steps so far, rejected ones included.
    pub steps: usize,
}

struct RightHandSide<'a> {
    model: &'a dyn Model,
    p: &'a [f64],
    segment: &'a Segment,
    u: RefCell<Vec<f64>>,
    fault: Cell<Option<Fault>>,
}

impl ODE<f64, Vec<f64>> for RightHandSide<'_> {
    fn diff(&self, t: f64, x: &Vec<f64>, dx: &mut Vec<f64>) {
        let mut u = self.u.borrow_mut();
        self.segment.at(t, &mut u);
        let fault = match self.model.rhs(t, x, &u, self.p, dx) {
            Err(singular) => Some(Fault::Singular(singular.coordinate)),
            Ok(()) => dx.iter().position(|d| !d.is_finite()).map(Fault::NotFinite),
        };
        if fault.is_some() {
            // makes the error estimate of this step NaN, which the library rejects
            dx.fill(f64::NAN);
            self.fault.set(fault);
        }
    }
}

impl Integrator<'_> {
    /// From `segment.from` with the state `x` to `segment.to`, where `x` is left. `times` increase and lie in
    /// (from, to]; `out(k, x)` is called for each that is reached. Returns where and why the run stopped early.
    pub fn run(
        &mut self,
        segment: &Segment,
        x: &mut Vec<f64>,
        times: &[f64],
        out: &mut dyn FnMut(usize, &[f64]),
    ) -> Result<(), (f64, Stop)> {
        let rhs = RightHandSide { model: self.model, p: self.p, segment, u: RefCell::new(segment.values.clone()), fault: Cell::new(None) };
        let (mut t, to) = (segment.from, segment.to);
        // a step that cannot be told apart from nothing
        let smallest = 16.0 * f64::EPSILON * t.abs().max(to.abs());
        if self.h == 0.0 {
            self.h = first_step(&rhs, t, x, self.control).min(to - t);
        }
        let mut next = 0;
        let mut last_fault = None;
        while t < to {
            let mut solver = ExplicitRungeKutta::dop853()
                .rtol(self.control.relative)
                .atol(self.control.absolute)
                .h0(self.h.min(to - t))
                .max_steps(usize::MAX);
            rhs.fault.set(None);
            if solver.init(&rhs, t, to, x).is_err() {
                return Err((t, rhs.fault.get().map_or(Stop::Collapsed, Stop::Fault)));
            }
            if let Some(fault) = rhs.fault.get() {
                return Err((t, Stop::Fault(fault)));
            }
            // until the segment is done, or the solver has to be started anew
            loop {
                let planned = solver.h();
                let last = planned >= (to - t) * (1.0 - 1e-9);
                if last {
                    solver.set_h(to - t);
                }
                if self.steps >= self.control.max_steps {
                    return Err((t, Stop::TooManySteps));
                }
                self.steps += 1;
                rhs.fault.set(None);
                let result = solver.step(&rhs);
                let fault = rhs.fault.get();
                last_fault = fault.or(last_fault);
                match result {
                    // the library's own guesses at stiffness and at small steps: start anew, the limits here decide
                    Err(Error::Stiffness { .. } | Error::StepSize { .. }) => break,
                    Err(_) => return Err((t, Stop::Collapsed)),
                    Ok(_) => {}
                }
                if matches!(solver.status(), Step::RejectedStep) {
                    self.h = solver.h();
                    if !(self.h > smallest) {
                        return Err((t, last_fault.map_or(Stop::Collapsed, Stop::Fault)));
                    }
                    continue;
                }
                if fault.is_some() {
                    // accepted, but the derivative at its end or for dense output does not exist: halve it
                    self.h = 0.5 * (solver.t() - t);
                    if !(self.h > smallest) {
                        return Err((t, last_fault.map_or(Stop::Collapsed, Stop::Fault)));
                    }
                    break;
                }
                last_fault = None;
                let reached = if last { to } else { solver.t() };
                while let Some(&wanted) = times.get(next).filter(|&&w| w <= reached) {
                    if wanted < solver.t() {
                        match solver.interpolate(wanted) {
                            Ok(inside) => out(next, &inside),
                            Err(_) => return Err((t, Stop::Collapsed)),
                        }
                    } else {
                        out(next, solver.y());
                    }
                    next += 1;
                }
                t = reached;
                x.clone_from(solver.y());
                self.h = if last { planned.max(solver.h()) } else { solver.h() };
                if last {
                    break;
                }
            }
        }
        Ok(())
    }
}

/// A first guess: the time in which the state moves by 1 % of its size; the error control corrects it.
fn first_step(rhs: &RightHandSide<'_>, t: f64, x: &Vec<f64>, control: Control) -> f64 {
    let mut dx = vec![0.0; x.len()];
    rhs.diff(t, x, &mut dx);
    let scaled =
        |v: &[f64]| v.iter().zip(x).map(|(v, x)| (v / (control.absolute + control.relative * x.abs())).powi(2)).sum::<f64>().sqrt();
    let (size, speed) = (scaled(x), scaled(&dx));
    if size > 1e-5 && speed > 1e-5 && speed.is_finite() { 0.01 * size / speed } else { 1e-6 }
}

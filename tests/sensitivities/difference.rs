//! Derivatives by differences of high order, of any result of a model.

use crate::checked::checked;
use beamtune::model::edit::{self, Value};
use beamtune::model::path;
use beamtune::model::{At, Checked, Model, Place};
use beamtune::solve::sensitivity::Differentiator;
use num_complex::Complex64;

/// Weights of the central difference of eighth order at 1 to 4 steps.
///
/// Source: Fornberg, Math. Comp. 51 (1988) 699-706, Table 1.
const CENTRAL: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];

/// Weights of the one-sided difference of sixth order at 0 to 6 steps.
///
/// Source: Fornberg, Table 3.
const FORWARD: [f64; 7] = [
    -49.0 / 20.0,
    6.0,
    -15.0 / 2.0,
    20.0 / 3.0,
    -15.0 / 4.0,
    6.0 / 5.0,
    -1.0 / 6.0,
];

/// How derivatives are compared with differences.
#[derive(Clone, Copy)]
pub struct Trial {
    /// An error is relative to the parameter's own effect, or to this share of the value if that is greater.
    pub least: f64,
    /// Steps, as shares of the allowed change of a parameter.
    pub steps: &'static [f64],
    /// The largest change of the numbers of supports and subsystems, as a multiple of their value.
    pub far: Option<f64>,
    /// The parameters: those whose path ends in this.
    pub only: &'static [&'static str],
}

/// For results that are smooth over any change and cheap.
pub const WIDE: Trial = Trial {
    least: 1e-6,
    steps: &[0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 2e-4, 3e-5],
    far: Some(30.0),
    only: &[""],
};

/// For results that a new search finds after every change, which must stay close.
pub const NEAR: Trial = Trial {
    least: 1e-4,
    steps: &[1e-3, 1e-4],
    far: None,
    only: &[""],
};

/// A change of a response that is exactly 0, below which a derivative is rounding: the responses to unit loads are 1e-8 and
/// less here.
const ROUNDING: f64 = 1e-22;

/// A value with its derivatives by every parameter.
pub type Exact = (Complex64, Vec<Complex64>);

/// The model with one number changed, checked or not.
pub fn with(model: &Model, path: &str, value: f64) -> Model {
    let mut changed = model.clone();
    edit::set_unchecked(&mut changed, path, Value::Number(value)).unwrap();
    changed
}

/// The side of a difference: a position at an end can only move inwards, and beyond a position at the right end there
/// is only more beam.
fn side(model: &Model, path: &str, value: f64) -> f64 {
    let length = model.length();
    let is_at_end = |at: At<'_>| matches!(at, At::Beam(Place::Position(x)) if x == length);
    let forces = model.forces.iter().map(|force| force.target.at());
    let responses = model.responses.iter().filter_map(|of| of.quantity.at());
    let held =
        forces.chain(responses).any(is_at_end) || model.attached().any(|of| of.position == length);
    match path {
        _ if path.starts_with("beam.") && path.ends_with(".length") && held => 1.0,
        "beam.section.warping_constant" if value == 0.0 => 1.0,
        _ if path.ends_with(".position") && value == 0.0 => 1.0,
        _ if path.ends_with(".position") && value == length => -1.0,
        _ => 0.0,
    }
}

/// The derivative of some values by a parameter, by differences of a step.
fn difference(
    value: f64,
    step: f64,
    side: f64,
    at: impl Fn(f64) -> Vec<Complex64>,
) -> Vec<Complex64> {
    let mut sum: Vec<Complex64> = Vec::new();
    let mut add = |weight: f64, steps: f64| {
        let values = at(value + steps * step);
        sum.resize(values.len(), Complex64::ZERO);
        for (sum, value) in sum.iter_mut().zip(values) {
            *sum += weight * value / step;
        }
    };
    if side == 0.0 {
        for (index, weight) in CENTRAL.into_iter().enumerate() {
            add(weight, (index + 1) as f64);
            add(-weight, -((index + 1) as f64));
        }
    } else {
        for (index, weight) in FORWARD.into_iter().enumerate() {
            add(side * weight, side * index as f64);
        }
    }
    sum
}

/// The farthest points of a difference, in steps.
fn reach(side: f64) -> [f64; 2] {
    if side == 0.0 {
        [-1.0, 1.0].map(|sign| sign * CENTRAL.len() as f64)
    } else {
        [0.0, side * (FORWARD.len() - 1) as f64]
    }
}

/// Whether solvers take a model.
fn is_possible(model: &Model) -> bool {
    Checked::of_state(model.clone()).is_ok()
}

/// The largest error of `exact` over all parameters against differences of `of`, with its location.
///
/// A parameter's own effect is that of a change by its value, or, if it is 0, by the amount that changes `of` by a
/// hundredth. Values without a finite derivative are skipped. Of some steps within the valid models the one with the
/// closest result counts: a short one suffers from rounding, a long one from curvature.
pub fn worst(
    model: &Model,
    exact: &[Exact],
    trial: Trial,
    of: impl Fn(&Model) -> Vec<Complex64>,
) -> (f64, String) {
    let differentiator = Differentiator::new(&checked(model));
    let mut worst = (0.0, String::new());
    let paths = path::texts(model, differentiator.ids());
    let parameters = paths.iter().zip(differentiator.values());
    for (index, (path, &parameter)) in parameters.enumerate() {
        let finite = exact.iter().all(|(_, by)| by[index].is_finite());
        if !finite || !trial.only.iter().any(|end| path.ends_with(end)) {
            continue;
        }
        let side = side(model, path, parameter);
        let mut best: Vec<f64> = vec![f64::INFINITY; exact.len()];
        let scales = scales(path, parameter, index, exact, trial.far);
        let unit = scales[0];
        for step in scales
            .iter()
            .flat_map(|scale| trial.steps.iter().map(move |step| step * scale))
        {
            // Where the central points leave the valid models, one-sided ones stay inside.
            let is_within = |side: &f64| {
                let mut points = reach(*side).into_iter();
                points.all(|steps| is_possible(&with(model, path, parameter + steps * step)))
            };
            let Some(side) = [side, 1.0, -1.0].into_iter().find(is_within) else {
                continue;
            };
            let at = |value: f64| of(&with(model, path, value));
            let found = difference(parameter, step, side, at);
            for (best, ((value, by), found)) in best.iter_mut().zip(exact.iter().zip(found)) {
                // A part without any effect: what remains is the rounding of another order of sums.
                if by[index] == Complex64::ZERO && unit * found.norm() < 1e-11 * value.norm() {
                    *best = 0.0;
                    continue;
                }
                if *value == Complex64::ZERO
                    && found == Complex64::ZERO
                    && (unit * by[index]).norm() < ROUNDING
                {
                    *best = 0.0;
                    continue;
                }
                let size = (unit * by[index]).norm().max(trial.least * value.norm());
                let error = unit * (by[index] - found).norm() / size;
                *best = best.min(if size > 0.0 { error } else { found.norm() });
            }
        }
        for (which, error) in best.into_iter().enumerate() {
            if error.is_nan() || error > worst.0 {
                worst = (error, format!("{path} of {which}"));
            }
        }
    }
    worst
}

/// The allowed change of a parameter: its value, for numbers of supports and subsystems far more; for one that is 0 the
/// amount that changes some of the values by a hundredth, or a usual value if that is less.
fn scales(path: &str, parameter: f64, index: usize, exact: &[Exact], far: Option<f64>) -> Vec<f64> {
    let can_be_any = path.starts_with("supports") || path.starts_with("subsystems");
    if path.ends_with(".position") {
        vec![1.0]
    } else if parameter != 0.0 && can_be_any {
        let times = [1.0].into_iter().chain(far);
        times.map(|times| times * parameter.abs()).collect()
    } else if parameter != 0.0 {
        vec![parameter.abs()]
    } else {
        let effects = exact.iter().map(|(value, by)| (by[index] / value).norm());
        let most = effects
            .filter(|effect| effect.is_finite())
            .fold(0.0, f64::max);
        // Of these only one-sided differences are possible, which are less accurate for long steps.
        let unit = (0.01 / most).min(usual(path));
        [1.0, 0.1, 0.01, 10.0].map(|times| times * unit).to_vec()
    }
}

/// A usual value of a number that is 0.
fn usual(path: &str) -> f64 {
    match path.rsplit('.').next().unwrap() {
        "stiffness" => 1e6,
        "damping" | "axial_force" => 1e3,
        "mass" | "inertia" | "phase" => 10.0,
        "product_moment" => 1e-8,
        "centroid_offset_y" | "offset_y" | "offset_z" | "y" | "z" => 1e-2,
        _ => 0.1,
    }
}

//! The compression at which a beam buckles: where the count at frequency 0 grows.

use super::wittrick_williams::Counter;
use crate::model::{Checked, Model};
use crate::solve::beam_matrices::BeamMatrices;

/// Steps of doubling and of halving.
const MOST_STEPS: usize = 60;

/// The least axial compression, N, at which a beam without loads along it buckles, with its supports and the springs of
/// its subsystems; `None` if it buckles under none.
///
/// It is the same in all of the beam, in place of the axial forces of the model. Source: the count of Wittrick & Williams, Q. J. Mech. Appl. Math. 24 (1971)
/// 263-284, at frequency 0 as a function of the force.
pub fn buckling_load(model: &Checked) -> Option<f64> {
    least(model, 1.0, |compression, _| -compression)
}

/// The least factor on all axial forces of a model at which it buckles, negative for a model under tension alone; `None` if
/// it buckles at none.
///
/// Source: as for [`buckling_load`].
pub fn buckling_factor(model: &Checked) -> Option<f64> {
    let parts = model.uniform_parts();
    let forces = parts.iter().map(|part| part.beam.axial_force);
    let (lowest, highest) = forces.fold((0.0_f64, 0.0_f64), |(low, high), force| {
        (low.min(force), high.max(force))
    });
    let (sign, largest) = if lowest < 0.0 {
        (1.0, -lowest)
    } else {
        (-1.0, highest)
    };
    if largest == 0.0 {
        return None;
    }
    let least = least(model, largest, |factor, force| sign * factor * force);
    least.map(|factor| sign * factor)
}

/// The least number at which a model buckles under the axial forces that follow from it and those of the model;
/// `largest` is the largest compression, N, for the number 1.
fn least(model: &Model, largest: f64, of: impl Fn(f64, f64) -> f64) -> Option<f64> {
    let buckles = |number: f64| ways(model, |force| of(number, force)) > 0;
    let parts = model.uniform_parts();
    let bending = parts
        .iter()
        .flat_map(|part| BeamMatrices::new(&part.beam).principal_bending());
    let length = model.length() / std::f64::consts::PI;
    let mut high = 1e-3 * bending.fold(f64::INFINITY, f64::min) / (length * length) / largest;
    let mut steps = 0;
    while !buckles(high) {
        high *= 2.0;
        steps += 1;
        if steps > MOST_STEPS {
            return None;
        }
    }
    let low = if steps == 0 { 0.0 } else { 0.5 * high };
    Some(halved([low, high], buckles))
}

/// The factors on all axial forces of a model, ascending and up to `to`, at each of which it buckles in one more way; the
/// least `most` of them. None without compression.
///
/// Source: as for [`buckling_load`].
pub fn buckling_factors(model: &Checked, to: f64, most: usize) -> Vec<f64> {
    let buckled = |factor: f64| ways(model, |force| factor * force);
    let count = buckled(to).min(most);
    let factor = |way: usize| halved([0.0, to], |factor| buckled(factor) > way);
    (0..count).map(factor).collect()
}

/// The number of modes that grow under other axial forces, N, as functions of the model's.
fn ways(model: &Model, of: impl Fn(f64) -> f64) -> usize {
    let mut loaded = model.clone();
    let own = loaded
        .spans
        .iter_mut()
        .filter_map(|span| span.axial_force.as_mut());
    for force in own.chain([&mut loaded.beam.axial_force]) {
        *force = of(*force);
    }
    Counter::new(&loaded).unstable()
}

/// Where a beam begins to buckle between two numbers, by halving.
fn halved([mut low, mut high]: [f64; 2], buckles: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..MOST_STEPS {
        let middle = 0.5 * (low + high);
        if buckles(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

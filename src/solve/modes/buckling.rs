//! The compression at which a beam buckles: where the count at frequency 0 grows.

use super::wittrick_williams::Counter;
use crate::model::{Checked, Model};
use crate::solve::beam_matrices::BeamMatrices;

/// Steps of doubling and of halving.
const MOST_STEPS: usize = 60;

/// The least axial compression, N, at which a beam without loads along it buckles, with its supports and the springs of
/// its subsystems; `None` if it buckles under none.
///
/// The axial force of the model is replaced. Source: the count of Wittrick & Williams, Q. J. Mech. Appl. Math. 24 (1971)
/// 263-284, at frequency 0 as a function of the force.
pub fn buckling_load(model: &Checked) -> Option<f64> {
    let buckles = |compression: f64| ways(model, -compression) > 0;
    let [first, second] = BeamMatrices::new(&model.beam).principal_bending();
    let length = model.beam.length / std::f64::consts::PI;
    let mut high = 1e-3 * first.min(second) / (length * length);
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

/// The factors on the axial force of a model, ascending and up to `to`, at each of which it buckles in one more way; the
/// least `most` of them. None in tension.
///
/// Source: as for [`buckling_load`].
pub fn buckling_factors(model: &Checked, to: f64, most: usize) -> Vec<f64> {
    let buckled = |factor: f64| ways(model, factor * model.beam.axial_force);
    let count = buckled(to).min(most);
    let factor = |way: usize| halved([0.0, to], |factor| buckled(factor) > way);
    (0..count).map(factor).collect()
}

/// The number of modes that grow under this axial force, N, in place of the model's.
fn ways(model: &Model, axial_force: f64) -> usize {
    let mut loaded = model.clone();
    loaded.beam.axial_force = axial_force;
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

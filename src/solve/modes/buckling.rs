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
    let buckles = |compression: f64| {
        let pressed = Model {
            beam: crate::model::Beam {
                axial_force: -compression,
                ..model.beam
            },
            ..Model::clone(model)
        };
        Counter::new(&pressed).unstable() > 0
    };
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
    let mut low = if steps == 0 { 0.0 } else { 0.5 * high };
    for _ in 0..MOST_STEPS {
        let middle = 0.5 * (low + high);
        if buckles(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(0.5 * (low + high))
}

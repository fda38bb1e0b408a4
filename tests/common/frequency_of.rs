//! A range with a given number of modes, for tests and benches.

use beamtune::model::{Checked, Model};
use beamtune::solve::modes::count;

/// A frequency (Hz) with at least `wanted` modes below it and few more.
pub fn frequency_of(model: &Model, wanted: usize) -> f64 {
    let model = Checked::new(model.clone()).unwrap();
    let (mut low, mut high) = (0.0, 1.0);
    while count(&model, high) < wanted {
        (low, high) = (high, 2.0 * high);
    }
    for _ in 0..12 {
        let middle = 0.5 * (low + high);
        if count(&model, middle) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

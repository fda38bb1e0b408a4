//! Models of tests, as the solvers take them.

#![allow(clippy::unwrap_used)]

use beamtune::model::{Checked, Model};

/// A valid model.
pub fn checked(model: &Model) -> Checked {
    Checked::of_state(model.clone()).unwrap()
}

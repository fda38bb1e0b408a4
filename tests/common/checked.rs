//! Models of tests as the solvers take them.

#![allow(clippy::unwrap_used)]

use beamtune::model::{Checked, Model};

/// A model that is possible.
pub fn checked(model: &Model) -> Checked {
    Checked::new(model.clone()).unwrap()
}

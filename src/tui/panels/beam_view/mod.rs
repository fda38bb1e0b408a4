//! The view of the beam below the chart: its motion and internal forces at the cursor, and drawings.

mod animated;
mod commands;
pub(crate) mod deflection;
pub(crate) mod forces;
pub(crate) mod mode_shape;
pub(crate) mod power;
pub(crate) mod section;
pub(crate) mod structure;

pub use commands::{BeamView, BeamViewState};

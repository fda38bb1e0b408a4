//! Sensitivities: bars in the tree and a table, for the level at the cursor, a peak, a mode or the band.

mod commands;
mod effects;
pub(crate) mod view;

pub use commands::{Sensed, Sensitivities};
pub use effects::Effects;

//! The search for better parameters: variables, objectives, and progress.

mod commands;
mod objective;
mod tolerance;
mod variable;
pub(crate) mod view;

pub use commands::{Progress, Run, Tuning};
pub use tolerance::Tolerances;
pub use variable::MovableRows;

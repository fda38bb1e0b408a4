//! What the engineer edits: the model as plain data, its text form, its rules and its parameter paths.
//!
//! Everything is in SI units. Nothing here computes a response or knows a terminal. [`read()`] turns a TOML text into
//! a [`Model`] or into all of its faults at once; [`write()`] merges a model back into that text; [`check()`] says
//! whether a model is physically possible; [`schema`] says which keys there are, a [`ParameterId`] stands for one of
//! them, [`path`] finds it by name and [`edit`] changes it.

mod check;
mod delta;
mod describe;
pub mod edit;
mod fault;
mod id;
mod moves;
pub(crate) mod names;
pub mod path;
pub(crate) mod read;
pub mod schema;
mod serial;
mod tuning;
mod types;
mod write;

pub use crate::unit::{Measure, Unit, counted, entry, grouped};
pub use check::{check, check_state};
pub use delta::{apply_delta, delta};
pub use describe::Parameter;
pub use fault::Fault;
pub(crate) use fault::MOST_SHOWN;
pub use id::{End, Group, ParameterId};
pub use moves::Moves;
pub use read::read;
pub(crate) use serial::basic_string;
pub use serial::format_number;
pub use tuning::*;
pub use types::*;
pub use write::write;

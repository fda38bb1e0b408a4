//! What the engineer edits: the model as plain data, its text form, its rules and its parameter paths.
//!
//! Everything is in SI units. Nothing here computes a response or knows a terminal. [`read()`] turns a TOML text into
//! a [`Model`] or into all of its faults at once; [`write()`] merges a model back into that text; [`check()`] says
//! whether a model is physically possible; [`schema`] says which keys there are, a [`ParameterId`] stands for one of
//! them, [`path`] finds it by name and [`edit`] changes it.
//!
//! # Example
//!
//! ```
//! use beamtune::model::{self, edit};
//! use beamtune::presets;
//!
//! let text = presets::find("cantilever").expect("an embedded preset").text;
//! let mut beam = model::read(text).expect("a possible model");
//! edit::set(&mut beam, "subsystems.*.mass", edit::Value::Number(6.0)).expect("a heavier damper");
//! let changed = model::write(&beam, text);
//! // Only the changed value differs: comments and order stay.
//! assert!(changed.contains("mass = 6.0                             # kg"));
//! assert_eq!(changed.lines().count(), text.lines().count());
//! ```

mod check;
mod delta;
mod describe;
pub mod edit;
mod fault;
mod id;
mod moves;
pub mod path;
pub(crate) mod read;
pub mod schema;
pub(crate) mod spelling;
mod toml_literal;
mod tuning;
mod types;
mod write;

pub use crate::unit::{Measure, Unit, counted, grouped, value_input};
pub use check::{check, check_state};
pub use delta::{apply_delta, delta};
pub use describe::Parameter;
pub use fault::Fault;
pub(crate) use fault::MOST_SHOWN;
pub use id::{End, Group, ParameterId};
pub use moves::Moves;
pub use read::read;
pub(crate) use toml_literal::basic_string;
pub use toml_literal::format_number;
pub use tuning::*;
pub use types::*;
pub use write::write;

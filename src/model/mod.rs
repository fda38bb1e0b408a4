//! The model that the engineer edits: plain data, TOML text, rules and parameter paths.
//!
//! All numbers are in SI units. This module computes no response and uses no terminal. [`read()`] converts TOML text to
//! a [`Model`] or returns all of its faults; [`write()`] merges a model into its text; [`check()`] finds out whether a
//! model is physically possible; [`schema`] describes the keys, a [`ParameterId`] identifies one of them, [`path`]
//! finds it by name and [`edit`] changes it. The plain data are in `types`, those of the beam, its section and its spans in
//! `beam`, those of all springs in `spring`, those of the responses in `quantity`; `part` says which numbers belong to the
//! beam and which to one of its spans, and `place` where forces and responses can be.
//!
//! # Example
//!
//! ```
//! use beamtune::model::{self, edit};
//! use beamtune::presets;
//!
//! let text = presets::find("cantilever").expect("an embedded preset").text;
//! let mut beam = model::read(text).expect("a possible model").into_inner();
//! edit::set(&mut beam, "subsystems.*.mass", edit::Value::Number(6.0)).expect("a heavier damper");
//! let changed = model::write(&beam, text);
//! // Only the changed value differs: comments and order stay.
//! assert!(changed.contains("mass = 6.0                             # kg"));
//! assert_eq!(changed.lines().count(), text.lines().count());
//! ```

mod beam;
mod check;
mod delta;
mod describe;
pub mod edit;
mod fault;
mod id;
mod moves;
mod part;
pub mod path;
mod place;
mod quantity;
pub(crate) mod read;
pub mod schema;
pub(crate) mod spelling;
mod spring;
mod toml_literal;
mod tuning;
mod types;
mod write;

pub use crate::unit::{Measure, Unit, counted, grouped, value_input};
pub use beam::*;
#[cfg(test)]
pub use check::checked;
pub use check::{Checked, check, check_state};
pub use delta::{apply_delta, delta};
pub use describe::Parameter;
pub use fault::Fault;
pub(crate) use fault::MOST_SHOWN;
pub use id::{Group, ParameterId, SupportId};
pub use moves::Moves;
pub(crate) use part::BeamNumber;
pub use part::Part;
pub use quantity::*;
pub use read::read;
pub use spring::*;
pub(crate) use toml_literal::basic_string;
pub use toml_literal::format_number;
pub use tuning::*;
pub use types::*;
pub use write::write;

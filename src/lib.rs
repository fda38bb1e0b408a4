//! Frequency responses of a thin-walled beam (bending, torsion and warping coupled) that carries any number of
//! three-degree-of-freedom spring-damper-mass subsystems, and a terminal program to tune them.
//!
//! # The map
//!
//! | module | what is in it | may use |
//! | --- | --- | --- |
//! | [`unit`](mod@unit) | units: of parameters and their typed numbers, of responses (what moves, its measure, per which load), of frequencies and phases; symbols, prefixes, factors to SI | `words` |
//! | [`model`] | what the engineer edits: plain types in SI, TOML in and out, rules, parameter paths | `unit`, `words` |
//! | [`presets`] | the figures of the paper and more, embedded | `model` |
//! | `files` | files of models and of the user: opened, saved atomically, where they are, what a model was opened from | `model`, `presets`, `escape` |
//! | [`solve`] | the exact solver: waves, subsystems, a recursion of reflections; [modes](solve::modes) and [peaks](solve::peaks) from it; [exact derivatives](solve::sensitivity); two reference methods, [finite elements](solve::fem) and [the transfer matrices of the paper](solve::transfer_matrix) | `model`, `unit` |
//! | [`measured`] | measured curves from CSV and universal files (UFF 58), how well a model fits them; universal files out | `model`, `unit`, `files` |
//! | [`tune`] | optimisation: variables, objectives, limits, tolerances, and [the search](tune::search) | `model`, `unit`, `solve`, `measured` |
//! | `worker` | the background threads: newest request wins | `model`, `solve`, `tune` |
//! | `tui` | the designer: its state as a whole (`tui::app`), a folder per feature (`tui::panels`), keys, the screen, the chart, the terminal and its bytes (`tui::backend`), what is kept for the user (`tui::user`) | all above |
//! | `words` | enums whose values have words in files | nothing |
//! | `wrap` | texts in a number of columns: cut off, or wrapped into lines | `escape` |
//! | `escape` | text from outside, escaped for terminals and files | nothing |
//! | `table` | numbers and texts as CSV cells | `escape` |
//! | `signals` | signals that the parent process set to be ignored | nothing |
//! | `fault_injection` | panics for tests, in debug builds | nothing |
//! | [`guide`] | the guide, one module per chapter | `wrap` |
//! | `cli` | the commands; [`run()`] is the whole program | all above |
//!
//! # Invariants
//!
//! - `model` and `solve` use no terminal, file system, thread of their own or clock; the only input of `solve` is a
//!   checked model.
//! - Internal numbers are in SI units. Prefixes exist only in text that a person reads or types.
//! - Every key of a model is one row of [`model::schema`] (key, symbol, unit, meaning, kind, range), which reading,
//!   writing, checking, paths and the designer's tree use. A [`model::ParameterId`] identifies a parameter; text paths
//!   are for files, the command line and prompts.
//! - The user-interface thread never solves. Drawn curves have the generation of their model; older curves are dim.
//! - No value that is not finite is drawn or written silently.
//!
//! # Example
//!
//! ```
//! use std::sync::atomic::AtomicBool;
//! use beamtune::{model, presets, solve};
//!
//! let preset = presets::find("fig06").expect("an embedded preset");
//! let mut beam = model::read(preset.text).expect("presets are possible models").into_inner();
//! model::edit::set(&mut beam, "supports.left.w.stiffness", model::edit::Value::Number(8e7)).expect("a stiffer end");
//! let beam = model::Checked::new(beam).expect("a possible model");
//! let frf = solve::sweep(&beam, &[50.0, 100.0], &AtomicBool::new(false)).expect("nothing cancels it");
//! assert_eq!(frf.columns[0].values.len(), 2);
//! ```

mod cli;
mod escape;
mod fault_injection;
mod files;
pub mod guide;
pub mod measured;
pub mod model;
pub mod presets;
mod signals;
pub mod solve;
mod table;
#[cfg(fuzzing)]
pub mod tui;
#[cfg(not(fuzzing))]
mod tui;
pub mod tune;
pub mod unit;
mod words;
mod worker;
mod wrap;

pub use cli::main as run;

// The designer's tests use the crate name, as other tests do.
#[cfg(test)]
extern crate self as beamtune;
#[cfg(test)]
#[path = "../tests/designer/mod.rs"]
mod designer;

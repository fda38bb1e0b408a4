//! Optimisation of parameters: what `[tune]` of a model file asks for, and the search for it.
//!
//! [`Problem`] turns a model and its `[tune]` into points of a unit box (`coordinates`), figures of its responses
//! (`objectives`, each with exact derivatives) and `limits`; `merit` combines these into the one number that [`search`]
//! minimises, over the worst case of the tolerances if there are any (`worst_case`). A `candidate` is one model of the
//! search. [`run()`] is the entry point, `report` its result. [`spread()`] computes the effect of tolerances on the
//! curves.
//!
//! Nothing here depends on a clock or a terminal. The same seed gives the same result on any number of threads.
//!
//! # Example
//!
//! ```
//! use std::path::Path;
//! use std::sync::atomic::AtomicBool;
//! use beamtune::tune::{Options, Problem, run};
//! use beamtune::{model, presets};
//!
//! let text = presets::find("cantilever").expect("an embedded preset").text;
//! let beam = model::read(text).expect("a possible model");
//! // Measured files that [tune] names are read from this folder.
//! let problem = Problem::new(&beam, Path::new(".")).expect("a possible [tune]");
//! let options = Options { seed: 1, budget: Some(60) };
//! let tuned = run(&problem, &options, &AtomicBool::new(false), &mut |_| {}).expect("a finite objective");
//! assert!(tuned.after[0].figure < tuned.before[0].figure);
//! let better = model::write(&tuned.model, text);
//! assert!(model::read(&better).is_ok());
//! ```

mod candidate;
mod coordinates;
mod limits;
mod merit;
mod objectives;
mod problem;
mod report;
mod run;
pub mod search;
mod spread;
pub mod words;
mod worst_case;

pub use problem::{Problem, check_match};
pub use report::{Achieved, LimitOutcome, Moved, WorstCase};
pub use run::{Options, Status, Tuned, default_budget, run};
pub use search::{Phase, Place, Stop};
pub use spread::{Spread, spread};

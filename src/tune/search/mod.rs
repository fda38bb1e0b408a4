//! The search itself, which knows nothing of beams: points of a unit box, values and derivatives there.
//!
//! [`minimise`] looks all over the box first and goes downhill from the best points then, [`descend`] only goes downhill;
//! [`fit`] is least squares with the uncertainty of what it finds.

mod certainty;
mod descent;
mod global;
mod hessian;
mod ledger;
mod local;
mod minimise;
mod pairing;
mod quadratic;
mod squares;
mod types;

pub use minimise::{descend, minimise};
pub use squares::fit;
pub use types::{
    Certainty, Control, Estimate, Evaluation, Fit, Function, Landscape, Merit, Options, Outcome,
    Phase, Place, Progress, Residuals, Stop,
};

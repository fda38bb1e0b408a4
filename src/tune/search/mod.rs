//! The search itself, which knows nothing of beams: points of a unit box, values and derivatives there.
//!
//! [`minimise`] looks all over the box first and goes downhill from the best points then, [`descend`] only goes downhill;
//! [`fit`] is least squares with the uncertainty of what it finds.

mod budget;
mod covariance;
mod differential_evolution;
mod hessian;
mod least_squares;
mod minimise;
mod pairing;
mod qp;
mod sqp;
mod types;

pub use least_squares::fit;
pub use minimise::{descend, minimise};
pub use types::{
    Certainty, Control, Estimate, Evaluation, Fit, Function, Landscape, Merit, Options, Outcome,
    Phase, Place, Progress, Residuals, Stop,
};

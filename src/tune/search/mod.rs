//! The search itself, independent of beams: points of a unit box, values and derivatives there.
//!
//! [`minimise`] searches globally (`differential_evolution`) and then locally from the best points (`sqp`, with the
//! step of `qp`), [`descend`] only locally; [`fit`] is least squares with the uncertainty of its result (`covariance`).

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

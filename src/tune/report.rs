//! The results of tuning: the figure of each objective, the change of each variable, the value of each limit.

use std::sync::atomic::AtomicBool;

use fastrand::Rng;

use super::candidate::Candidate;
use super::merit::figures_at;
use super::problem::{Aimed, Problem};
use super::run::place;
use super::search::{Certainty, Merit, Place};
use super::worst_case::{corners, uncertain};
use crate::model::path::Pattern;
use crate::model::{Limit, Objective};
use crate::solve::Cancelled;

/// The result of an objective.
#[derive(Debug, Clone, PartialEq)]
pub struct Achieved {
    /// The objective.
    pub objective: Objective,
    /// Its figure: of a peak |H|; of a mean square, in the unit squared, the mean; of a width the rest of the band; of
    /// an anti-resonance its distance; of a measured curve the root mean square of the difference.
    pub figure: f64,
    /// The figure's unit; empty if it has none.
    pub unit: String,
    /// Its frequencies, Hz: the highest peak, both ends of the widest band, the anti-resonance. Empty for the others,
    /// and if there is none.
    pub places: Vec<f64>,
    /// The highest level in the band if that is above the figure: a peak that the search missed.
    pub overlooked: Option<f64>,
}

/// The change of a variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Moved {
    /// Its paths, as written in `[tune]`.
    pub paths: Vec<String>,
    /// The first parameter in the original model, in its unit.
    pub before: f64,
    /// The first parameter in the tuned model, in its unit.
    pub after: f64,
    /// Its standard uncertainty, in its unit, if a measured curve was matched and determines it.
    pub uncertainty: Option<f64>,
    /// Its position between its bounds.
    pub place: Place,
}

/// The result of a limit for the tuned model.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitOutcome {
    /// The limit.
    pub limit: Limit,
    /// The mass, kg; the natural frequency deepest in the band or nearest to it, Hz (NaN if there is none near); the
    /// deflection, in the response's unit; the least factor on the axial compression at which the beam buckles (infinite
    /// without compression).
    pub value: f64,
    /// Whether it is met.
    pub holds: bool,
}

/// The worst over the tolerances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorstCase {
    /// The worst combined figure over the tolerances about the original model, moved into the bounds.
    pub before: f64,
    /// The worst combined figure over the tolerances about the tuned model.
    pub after: f64,
    /// Number of evaluated corners of the box of tolerances; 0 if there are too many.
    pub corners: usize,
    /// Number of evaluated random points of the box.
    pub samples: usize,
    /// Whether all limits hold at all of them.
    pub is_possible: bool,
}

/// The result of each objective for a candidate.
pub(super) fn achieved(
    problem: &Problem,
    candidate: &Candidate,
) -> Result<Vec<Achieved>, Cancelled> {
    /// Tolerance between two ways to compute a peak.
    const NEAR: f64 = 1e-6;
    let of = |aimed: &Aimed| {
        let read = aimed.figure.read(candidate)?;
        let highest = aimed.figure.highest(candidate)?;
        Ok(Achieved {
            objective: aimed.objective.clone(),
            unit: aimed.figure.unit(&candidate.model),
            // A pole is infinite even if the response moves in its mode only by rounding.
            overlooked: Some(highest)
                .filter(|level| level.is_finite() && *level > read.figure * (1.0 + NEAR)),
            figure: read.figure,
            places: read.places,
        })
    };
    problem.aims.iter().map(of).collect()
}

/// The change of each variable.
pub(super) fn moved(problem: &Problem, x: &[f64], certainty: &Certainty) -> Vec<Moved> {
    let after = problem.values(x);
    let all = problem.coordinates.iter().enumerate();
    all.map(|(index, one)| {
        let place = place(x[index]);
        let known = match certainty {
            Certainty::Covariance(matrix) if place == Place::Inside => {
                Some(matrix[(index, index)].sqrt() * one.slope(x[index]))
            }
            _ => None,
        };
        Moved {
            paths: one.variable.paths.iter().map(Pattern::to_string).collect(),
            before: one.start(),
            after: after[index],
            uncertainty: known,
            place,
        }
    })
    .collect()
}

/// The result of each limit for a candidate.
pub(super) fn kept(
    problem: &Problem,
    candidate: &Candidate,
) -> Result<Vec<LimitOutcome>, Cancelled> {
    /// Rounding error of a search that ends on a limit.
    const ROUNDING: f64 = 1e-9;
    let limits = problem.tune().limits.iter().zip(&problem.bounds);
    limits
        .map(|(limit, bound)| {
            let values = bound.values(candidate)?;
            Ok(LimitOutcome {
                limit: limit.clone(),
                value: bound.reading(candidate)?,
                holds: values.iter().all(|value| *value <= ROUNDING),
            })
        })
        .collect()
}

/// The worst over the corners of the tolerances and 200 random points, before and after.
pub(super) fn worst_case(
    problem: &Problem,
    start: &[f64],
    x: &[f64],
    cancel: &AtomicBool,
) -> Result<WorstCase, Cancelled> {
    const MOST_CORNERS: usize = 1024;
    const SAMPLES: usize = 200;
    let uncertain = uncertain(problem);
    let mut all = Vec::new();
    if uncertain.len() <= MOST_CORNERS.ilog2() as usize {
        all = corners(problem, &uncertain);
    }
    let corners = all.len();
    // Not the seed of the search: its result must not depend on the points that judge it.
    let mut random = Rng::with_seed(1);
    for _ in 0..SAMPLES {
        let one = (0..problem.variables()).map(|_| 2.0 * random.f64() - 1.0);
        all.push(one.collect());
    }
    let [before, after] = [start, x].map(|point| worst(problem, point, &all, cancel));
    let (after, violation) = after?;
    Ok(WorstCase {
        before: before?.0,
        after,
        corners,
        samples: SAMPLES,
        is_possible: violation == 0.0,
    })
}

/// The worst combined figure and the largest violation over deviations.
fn worst(
    problem: &Problem,
    x: &[f64],
    deviations: &[Vec<f64>],
    cancel: &AtomicBool,
) -> Result<(f64, f64), Cancelled> {
    let mut worst = (f64::NEG_INFINITY, 0.0_f64);
    for deviation in deviations {
        let found = figures_at(problem, x, deviation, cancel)?;
        worst.0 = worst.0.max(problem.combined(&found.figures));
        worst.1 = worst.1.max(Merit::violation(found.limits));
    }
    Ok(worst)
}

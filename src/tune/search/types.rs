//! Input and output of the searches. Points are in the unit box: every coordinate between 0 and 1.

use std::cmp::Ordering;
use std::fmt;
use std::sync::atomic::AtomicBool;

use nalgebra::{DMatrix, DVector};

use crate::solve::Cancelled;

/// A smooth function at one point.
#[derive(Debug, Clone, PartialEq)]
pub struct Function {
    /// Its value.
    pub value: f64,
    /// Its derivatives by the coordinates of the unit box.
    pub gradient: Vec<f64>,
}

impl Function {
    /// Worse than any other, with this number of coordinates.
    pub(in crate::tune) fn worst(variables: usize) -> Self {
        Self {
            value: f64::INFINITY,
            gradient: vec![f64::NAN; variables],
        }
    }

    /// True where the value and all derivatives are finite.
    pub(super) fn is_finite(&self) -> bool {
        self.value.is_finite() && self.gradient.iter().all(|slope| slope.is_finite())
    }
}

/// The objective at one point, with derivatives: the search minimises the sum over the terms of the largest function of
/// each term, with every limit at most 0.
///
/// The number and the order of the functions of a term may change from point to point. One below the largest of its
/// term should be included if it may become the largest nearby. A term without functions counts 0.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Evaluation {
    /// Functions of which the largest counts.
    pub terms: Vec<Vec<Function>>,
    /// Must be at most 0.
    pub limits: Vec<Function>,
}

impl Evaluation {
    /// Its goal and violation.
    pub fn merit(&self) -> Merit {
        let largest = |term: &Vec<Function>| {
            let values = term.iter().map(|function| function.value);
            values.reduce(larger).unwrap_or(0.0)
        };
        Merit {
            goal: self.terms.iter().map(largest).sum(),
            violation: Merit::violation(self.limits.iter().map(|limit| limit.value)),
        }
    }
}

impl Evaluation {
    /// True if every function can be used.
    pub(super) fn is_finite(&self) -> bool {
        let mut functions = self.terms.iter().flatten().chain(&self.limits);
        functions.all(Function::is_finite)
    }
}

/// The larger of two numbers, NaN if one of them is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// The merit of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Merit {
    /// The sum over the terms of the largest function of each.
    pub goal: f64,
    /// The sum of the limits that are above 0; 0 if all are met.
    pub violation: f64,
}

impl Merit {
    /// Worse than any other.
    pub const WORST: Self = Self {
        goal: f64::INFINITY,
        violation: f64::INFINITY,
    };

    /// The sum of the limits above 0.
    pub fn violation(limits: impl IntoIterator<Item = f64>) -> f64 {
        limits
            .into_iter()
            .filter(|limit| limit.is_nan() || *limit > 0.0)
            .fold(0.0, |sum, limit| sum + limit)
    }

    /// Which of two points is better (`Less`), by the rules of Deb (2000): one that meets all limits before one that
    /// does not; of two that do, the lower goal; of two that do not, the lower violation. NaN counts as infinite.
    ///
    /// Deb, An efficient constraint handling method for genetic algorithms, Comput. Methods Appl. Mech. Engrg. 2000, 186,
    /// 311-338.
    pub fn compare(&self, other: &Self) -> Ordering {
        let known = |number: f64| {
            if number.is_nan() {
                f64::INFINITY
            } else {
                number
            }
        };
        let violations = known(self.violation).total_cmp(&known(other.violation));
        violations.then(known(self.goal).total_cmp(&known(other.goal)))
    }

    /// True where it is better than another one.
    pub fn is_better_than(&self, other: &Self) -> bool {
        self.compare(other) == Ordering::Less
    }

    /// True where all limits are met.
    pub fn is_possible(&self) -> bool {
        self.violation == 0.0
    }
}

/// Residuals at one point, for least squares.
#[derive(Debug, Clone, PartialEq)]
pub struct Residuals {
    /// The numbers that should be 0.
    pub values: DVector<f64>,
    /// Their derivatives by the coordinates of the unit box: a row per residual, a column per variable.
    pub jacobian: DMatrix<f64>,
}

/// The function to minimise. Points have [`variables`](Self::variables) coordinates, each from 0 to 1. Every method may
/// be called from many threads at once, is deterministic, and ends early if the search is cancelled.
pub trait Landscape: Sync {
    /// The number of coordinates.
    fn variables(&self) -> usize;

    /// The merit of a point; cheap, without derivatives. A point without a value has a goal that is infinite or NaN.
    ///
    /// # Errors
    /// The search is cancelled.
    fn merit(&self, x: &[f64]) -> Result<Merit, Cancelled>;

    /// The same with derivatives.
    ///
    /// # Errors
    /// The search is cancelled.
    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, Cancelled>;
}

/// Residuals for a least-squares search. As for [`Landscape`]: any thread, deterministic, an early end if cancelled.
pub trait Fit: Sync {
    /// The residuals and their derivatives at a point of the unit box.
    ///
    /// # Errors
    /// The search is cancelled.
    fn residuals(&self, x: &[f64]) -> Result<Residuals, Cancelled>;
}

/// The running phase of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// The point it starts from.
    Start,
    /// Global search.
    Global,
    /// Downhill from the best points, with derivatives.
    Local,
}

impl fmt::Display for Phase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Start => "start",
            Self::Global => "global search",
            Self::Local => "local search",
        })
    }
}

/// The progress of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Progress {
    /// Number of evaluated points, with and without derivatives.
    pub evaluations: usize,
    /// The best point so far.
    pub best: Vec<f64>,
    /// Its merit.
    pub merit: Merit,
    /// The running phase.
    pub phase: Phase,
}

/// The controls of a running search.
pub struct Control<'a> {
    /// True ends the search; the best so far is the result.
    pub cancel: &'a AtomicBool,
    /// The largest number of evaluations, with and without derivatives together.
    pub budget: usize,
    /// Called between evaluations; the search waits for it.
    pub tell: &'a mut dyn FnMut(&Progress),
}

/// Why a search stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// No step larger than rounding leads further down.
    Converged,
    /// No trial point is better, though the derivatives predict one: a kink, or noise in the values.
    NoProgress,
    /// The limits are violated, and no step nearby reduces the violation.
    LimitsUnmet,
    /// The points of the global search have converged, or find nothing better.
    Stagnated,
    /// The budget is used up.
    Budget,
    /// It was cancelled.
    Cancelled,
    /// The start has no finite value.
    NotFinite,
}

impl From<Cancelled> for Stop {
    fn from(Cancelled: Cancelled) -> Self {
        Self::Cancelled
    }
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Converged => "converged",
            Self::NoProgress => "no step improved it",
            Self::LimitsUnmet => "the limits cannot be met",
            Self::Stagnated => "the global search found no better model",
            Self::Budget => "all evaluations were used",
            Self::Cancelled => "cancelled",
            Self::NotFinite => "no finite value to start from",
        })
    }
}

/// The result of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The best point.
    pub x: Vec<f64>,
    /// Its merit; never worse than the start.
    pub merit: Merit,
    /// The merit of the start; [`Merit::WORST`] if not even that was evaluated.
    pub start: Merit,
    /// Number of evaluated points, with and without derivatives.
    pub evaluations: usize,
    /// Why it stopped.
    pub stop: Stop,
}

/// The result of a least-squares search.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// The best point.
    pub x: Vec<f64>,
    /// The sum of the squared residuals there; infinite if the start has no value.
    pub sum_of_squares: f64,
    /// The number of residuals.
    pub residuals: usize,
    /// The position of each variable between its bounds.
    pub places: Vec<Place>,
    /// How well the residuals determine the variables.
    pub certainty: Certainty,
    /// Number of evaluated points.
    pub evaluations: usize,
    /// Why it stopped.
    pub stop: Stop,
}

/// The position of a variable between its bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Between its bounds.
    Inside,
    /// At its lower bound: the optimum may be below.
    AtMin,
    /// At its upper bound: the optimum may be above.
    AtMax,
}

/// How well a fit determines its variables.
#[derive(Debug, Clone, PartialEq)]
pub enum Certainty {
    /// The covariance sigma^2 (J^T J)^-1 in coordinates of the unit box, with sigma^2 = S/(m - n) of the sum of squares
    /// S, m residuals and n variables between their bounds. The row and column of a variable at a bound are 0.
    Covariance(DMatrix<f64>),
    /// There are no more residuals than variables, so that the scatter is unknown.
    TooFewResiduals,
    /// The residuals cannot distinguish the variables: along this direction (unit length) they do not change.
    Singular {
        /// A unit vector in coordinates of the unit box.
        direction: Vec<f64>,
    },
    /// No evaluation had finite values.
    Unknown,
}

/// Options of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// Seed of the random numbers; the same gives the same result on any number of threads.
    pub seed: u64,
}

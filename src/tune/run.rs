//! The whole tuning, from a model to the tuned one with its report.

use std::sync::atomic::AtomicBool;

use super::merit::{Matched, MeritFunction};
use super::objectives::{Figure, Matching};
use super::problem::Problem;
use super::report::{Achieved, LimitOutcome, Moved, WorstCase, achieved, kept, moved, worst_case};
use super::search::{self, Certainty, Control, Phase, Place, Progress, Stop, fit, minimise};
use super::worst_case::uncertain;
use crate::model::Checked;
use crate::solve::Cancelled;

/// Options of the search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// Seed of the random numbers; the same gives the same result on any number of threads.
    pub seed: u64,
    /// The largest number of evaluations; `None`: by the number of variables, see [`default_budget`].
    pub budget: Option<usize>,
}

/// The progress of a search. Figures are for display, in the unit of the objective; several objectives are combined.
#[derive(Debug, Clone, PartialEq)]
pub struct Status {
    /// Number of evaluated models.
    pub evaluations: usize,
    /// The largest number of evaluations.
    pub budget: usize,
    /// The running phase.
    pub phase: Phase,
    /// The figure of the start.
    pub start: f64,
    /// The best figure so far.
    pub best: f64,
    /// Whether the best so far meets all limits.
    pub is_possible: bool,
    /// The best model so far.
    pub model: Checked,
}

/// The result of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Tuned {
    /// The original model with the best values of the variables.
    pub model: Checked,
    /// The figure of each objective of the original model.
    pub before: Vec<Achieved>,
    /// The figure of each objective of the tuned model.
    pub after: Vec<Achieved>,
    /// Each variable.
    pub variables: Vec<Moved>,
    /// Each limit, of the tuned model.
    pub limits: Vec<LimitOutcome>,
    /// If variables have tolerances, the worst case over them.
    pub worst_case: Option<WorstCase>,
    /// Number of evaluated models.
    pub evaluations: usize,
    /// The seed of the search.
    pub seed: u64,
    /// Why the search stopped.
    pub stop: Stop,
}

/// The default number of evaluations of a search.
pub const fn default_budget(variables: usize) -> usize {
    const FIRST: usize = 500;
    const EACH: usize = 500;
    FIRST + EACH * variables
}

/// Searches for the best model. Calls `tell` for each improvement and regularly in between; the search waits for it. If
/// `cancel` becomes true, the best so far is the result. It is never worse than the original model, moved into the
/// variables' bounds.
///
/// # Errors
/// A message if the objective has no finite value at any point of the search.
pub fn run(
    problem: &Problem,
    options: &Options,
    cancel: &AtomicBool,
    tell: &mut dyn FnMut(&Status),
) -> Result<Tuned, String> {
    let start = problem.point_of(problem.model());
    let never = AtomicBool::new(false);
    let budget = options
        .budget
        .unwrap_or_else(|| default_budget(problem.variables()));
    let in_words = |cancelled: Cancelled| cancelled.to_string();
    let scaled = MeritFunction::new(problem, &start, &never).map_err(in_words)?;
    let merit_function = scaled.until(cancel);
    let mut search = Search {
        merit_function: &merit_function,
        options: *options,
        budget,
        evaluations: 0,
        tell,
        start: merit_function.start,
    };
    let found = match only_curve(problem) {
        Some(curve) => search.fit(curve, &start),
        None => search.minimise(&start, budget),
    };
    if found.figure.is_nan() || found.figure.is_infinite() {
        return Err(
            "the objective is not finite for any evaluated model: an undamped resonance \
            in its band, or a band without a value"
                .to_owned(),
        );
    }
    let evaluations = search.evaluations;
    let reported = report(problem, &start, &found, &never).map_err(in_words)?;
    let tuned = reported.ok_or("the model cannot be solved")?;
    Ok(Tuned {
        evaluations,
        seed: options.seed,
        ..tuned
    })
}

/// The measured curve, if it is the only objective: least squares.
fn only_curve(problem: &Problem) -> Option<&Matching> {
    let [only] = &problem.aims[..] else {
        return None;
    };
    let Figure::Matching(curve) = &only.figure else {
        return None;
    };
    let mut variables = problem.coordinates.iter().map(|one| &one.variable);
    let is_exact = variables.all(|variable| variable.tolerance == 0.0);
    (problem.bounds.is_empty() && is_exact).then_some(curve)
}

/// The best point with its results.
struct Found {
    x: Vec<f64>,
    figure: f64,
    stop: Stop,
    certainty: Certainty,
}

/// A running search.
struct Search<'a> {
    merit_function: &'a MeritFunction<'a>,
    options: Options,
    budget: usize,
    evaluations: usize,
    tell: &'a mut dyn FnMut(&Status),
    /// The combined figure of the start.
    start: f64,
}

impl Search<'_> {
    fn minimise(&mut self, start: &[f64], budget: usize) -> Found {
        let merit_function = self.merit_function;
        let figure = |goal: f64| merit_function.figure(goal);
        let options = search::Options {
            seed: self.options.seed,
        };
        let mut tell = self.teller(&figure, f64::INFINITY);
        let control = Control {
            cancel: merit_function.cancel,
            budget,
            tell: &mut tell,
        };
        let outcome = minimise(merit_function, start, options, control);
        drop(tell);
        self.evaluations += outcome.evaluations;
        Found {
            figure: figure(outcome.merit.goal),
            x: outcome.x,
            stop: outcome.stop,
            certainty: Certainty::Unknown,
        }
    }

    /// Least squares from the start; then the global search; then least squares from its best point.
    fn fit(&mut self, curve: &Matching, start: &[f64]) -> Found {
        let first = self.descend(curve, start, f64::INFINITY);
        let left = self.budget.saturating_sub(self.evaluations);
        if first.stop == Stop::Cancelled || left < 2 {
            return first;
        }
        let looked = self.minimise(&first.x, left / 2);
        if looked.stop == Stop::Cancelled || looked.x == first.x {
            return first;
        }
        let last = self.descend(curve, &looked.x, looked.figure);
        if last.figure <= first.figure {
            last
        } else {
            first
        }
    }

    fn descend(&mut self, curve: &Matching, start: &[f64], best: f64) -> Found {
        let merit_function = self.merit_function;
        let figure = |sum: f64| curve.of_squares(sum);
        let budget = self.budget.saturating_sub(self.evaluations);
        let mut tell = self.teller(&figure, best);
        let control = Control {
            cancel: merit_function.cancel,
            budget,
            tell: &mut tell,
        };
        let estimate = fit(
            &Matched {
                merit_function,
                curve,
            },
            start,
            control,
        );
        drop(tell);
        self.evaluations += estimate.evaluations;
        Found {
            figure: figure(estimate.sum_of_squares),
            x: estimate.x,
            stop: estimate.stop,
            certainty: estimate.certainty,
        }
    }

    /// Reports the progress of the search for display; `figure` converts a goal to a figure.
    fn teller<'b>(
        &'b mut self,
        figure: &'b impl Fn(f64) -> f64,
        best: f64,
    ) -> impl FnMut(&Progress) + 'b {
        move |progress| {
            let status = Status {
                evaluations: self.evaluations + progress.evaluations,
                budget: self.budget,
                phase: progress.phase,
                start: self.start,
                best: figure(progress.merit.goal).min(best),
                is_possible: progress.merit.is_possible(),
                model: self.merit_function.problem.tuned(&progress.best),
            };
            (self.tell)(&status);
        }
    }
}

/// The report on the best point; `None` if the model has too many modes to list.
fn report(
    problem: &Problem,
    start: &[f64],
    found: &Found,
    never: &AtomicBool,
) -> Result<Option<Tuned>, Cancelled> {
    let given = problem.trial_as_given(never)?;
    let candidate = problem.trial_of(&problem.tuned(&found.x), never)?;
    let Some((given, candidate)) = given.zip(candidate) else {
        return Ok(None);
    };
    Ok(Some(Tuned {
        model: problem.tuned(&found.x),
        before: achieved(problem, &given)?,
        after: achieved(problem, &candidate)?,
        variables: moved(problem, &found.x, &found.certainty),
        limits: kept(problem, &candidate)?,
        worst_case: if uncertain(problem).is_empty() {
            None
        } else {
            Some(worst_case(problem, start, &found.x, never)?)
        },
        evaluations: 0,
        seed: 0,
        stop: found.stop,
    }))
}

/// The position of a coordinate between its bounds.
pub(super) fn place(x: f64) -> Place {
    /// Tolerance of a bound for rounding.
    const NEAR: f64 = 1e-9;
    if x <= NEAR {
        Place::AtMin
    } else if x >= 1.0 - NEAR {
        Place::AtMax
    } else {
        Place::Inside
    }
}

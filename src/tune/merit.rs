//! The merit function of a problem: one number to minimise, with derivatives, over the worst case of the tolerances.

use std::sync::atomic::AtomicBool;

use super::candidate::{Candidate, Slopes};
use super::objectives::Matching;
use super::problem::Problem;
use super::search::{Evaluation, Fit, Function, Landscape, Merit, Residuals};
use super::worst_case::deviations;
use crate::model::Combine;
use crate::solve::Cancelled;

/// The merit function of a problem: a [`Landscape`] over its unit box.
#[derive(Debug)]
pub(super) struct MeritFunction<'a> {
    pub(super) problem: &'a Problem,
    pub(super) cancel: &'a AtomicBool,
    scale: Scale,
    /// The combined figure of the start.
    pub(super) start: f64,
}

/// The scale from a combined figure to the minimised number.
#[derive(Debug, Clone, Copy)]
enum Scale {
    /// Its natural logarithm: changes count relative to the current value.
    Logarithm,
    /// Divided by a constant, about its value at the start.
    Over(f64),
}

/// The values of one candidate: the figure of each objective and the values of the limits.
pub(super) struct Figures {
    pub(super) figures: Vec<f64>,
    pub(super) limits: Vec<f64>,
}

/// The same as functions.
pub(super) struct Sloped {
    /// For each objective; the largest is its figure.
    pub(super) figures: Vec<Vec<Function>>,
    pub(super) limits: Vec<Function>,
}

impl Figures {
    /// The values of an invalid model: worse than any other.
    fn worst(problem: &Problem) -> Self {
        Self {
            figures: vec![f64::INFINITY; problem.aims.len()],
            limits: vec![f64::INFINITY],
        }
    }
}

impl Sloped {
    /// The values of an invalid model: worse than any other.
    fn worst(problem: &Problem) -> Self {
        let worst = Function::worst(problem.variables());
        Self {
            figures: vec![vec![worst.clone()]; problem.aims.len()],
            limits: vec![worst],
        }
    }
}

impl<'a> MeritFunction<'a> {
    /// Scaled by the figure at `start`.
    ///
    /// # Errors
    /// `cancel` became true before the end.
    pub(super) fn new(
        problem: &'a Problem,
        start: &[f64],
        cancel: &'a AtomicBool,
    ) -> Result<Self, Cancelled> {
        let mut merit_function = Self {
            problem,
            cancel,
            scale: Scale::Over(1.0),
            start: f64::NAN,
        };
        merit_function.start = merit_function.merit(start)?.goal;
        let positive = problem.aims.iter().all(|aimed| aimed.figure.is_positive());
        merit_function.scale = if positive && merit_function.is_one_term() {
            Scale::Logarithm
        } else {
            let size = merit_function.start.abs();
            Scale::Over(if size.is_normal() { size } else { 1.0 })
        };
        Ok(merit_function)
    }

    /// The same with another `cancel` flag.
    pub(super) fn until<'b>(&'b self, cancel: &'b AtomicBool) -> MeritFunction<'b> {
        MeritFunction { cancel, ..*self }
    }

    /// The combined figure of a goal, for display.
    pub(super) fn figure(&self, goal: f64) -> f64 {
        match self.scale {
            Scale::Logarithm => goal.exp(),
            Scale::Over(scale) => goal * scale,
        }
    }

    /// Whether the merit is the largest of all functions, not a sum.
    fn is_one_term(&self) -> bool {
        let problem = self.problem;
        problem.aims.len() == 1 || problem.tune().combine == Combine::Worst
    }

    fn weight(&self, aim: usize) -> f64 {
        if self.problem.aims.len() == 1 {
            1.0
        } else {
            self.problem.aims[aim].objective.weight
        }
    }

    /// The scaled figure; a weighted sum is that of its parts.
    fn scaled(&self, aim: usize, figure: f64) -> f64 {
        let weighted = figure * self.weight(aim);
        match self.scale {
            Scale::Logarithm => weighted.ln(),
            Scale::Over(scale) => weighted / scale,
        }
    }

    /// The same with derivatives.
    fn scaled_function(&self, aim: usize, function: &Function) -> Function {
        let factor = match self.scale {
            Scale::Logarithm => function.value.recip(),
            Scale::Over(scale) => self.weight(aim) / scale,
        };
        Function {
            value: self.scaled(aim, function.value),
            gradient: function
                .gradient
                .iter()
                .map(|slope| slope * factor)
                .collect(),
        }
    }

    /// The figures of one model.
    pub(super) fn figures(&self, x: &[f64], deviation: &[f64]) -> Result<Figures, Cancelled> {
        figures_at(self.problem, x, deviation, self.cancel)
    }

    /// The functions of one model.
    pub(super) fn sloped(&self, x: &[f64], deviation: &[f64]) -> Result<Sloped, Cancelled> {
        let problem = self.problem;
        let Some(candidate) = problem.candidate(x, deviation, self.cancel)? else {
            return Ok(Sloped::worst(problem));
        };
        let moved = problem.moved(x, deviation);
        let slopes = Slopes::new(&candidate.model, &moved);
        let of = |aim: usize| -> Result<Vec<Function>, Cancelled> {
            let functions = problem.aims[aim].figure.functions(&candidate, &slopes)?;
            let scaled = functions.into_iter();
            Ok(scaled.map(|one| self.scaled_function(aim, &one)).collect())
        };
        let figures: Result<Vec<_>, Cancelled> = (0..problem.aims.len()).map(of).collect();
        let limits: Result<Vec<Vec<Function>>, Cancelled> = problem
            .bounds
            .iter()
            .map(|bound| bound.functions(&candidate, &slopes, &moved))
            .collect();
        Ok(Sloped {
            figures: figures?,
            limits: limits?.concat(),
        })
    }
}

/// The figures of the model at a point with deviations, and the values of the limits.
pub(super) fn figures_at(
    problem: &Problem,
    x: &[f64],
    deviation: &[f64],
    cancel: &AtomicBool,
) -> Result<Figures, Cancelled> {
    match &problem.candidate(x, deviation, cancel)? {
        Some(candidate) => figures(problem, candidate),
        None => Ok(Figures::worst(problem)),
    }
}

/// The figures of a candidate and the values of the limits.
fn figures(problem: &Problem, candidate: &Candidate) -> Result<Figures, Cancelled> {
    let aims = problem.aims.iter();
    let figures: Result<Vec<f64>, Cancelled> = aims
        .map(|aimed| Ok(aimed.figure.read(candidate)?.figure))
        .collect();
    let limits: Result<Vec<Vec<f64>>, Cancelled> = problem
        .bounds
        .iter()
        .map(|bound| bound.values(candidate))
        .collect();
    Ok(Figures {
        figures: figures?,
        limits: limits?.concat(),
    })
}

impl Landscape for MeritFunction<'_> {
    fn variables(&self) -> usize {
        self.problem.variables()
    }

    fn merit(&self, x: &[f64]) -> Result<Merit, Cancelled> {
        let mut worst = vec![f64::NEG_INFINITY; self.problem.aims.len()];
        let mut violation = 0.0;
        for deviation in deviations(self, x)? {
            let found = self.figures(x, &deviation)?;
            for (aim, (worst, figure)) in worst.iter_mut().zip(found.figures).enumerate() {
                let scaled = self.scaled(aim, figure);
                *worst = if scaled.is_nan() {
                    scaled
                } else {
                    worst.max(scaled)
                };
            }
            violation += Merit::violation(found.limits);
        }
        let goal = if self.is_one_term() {
            worst.into_iter().fold(
                f64::NEG_INFINITY,
                |a, b| if b.is_nan() { b } else { a.max(b) },
            )
        } else {
            worst.into_iter().sum()
        };
        Ok(Merit { goal, violation })
    }

    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, Cancelled> {
        let mut terms = vec![Vec::new(); self.problem.aims.len()];
        let mut limits = Vec::new();
        for deviation in deviations(self, x)? {
            let found = self.sloped(x, &deviation)?;
            for (term, functions) in terms.iter_mut().zip(found.figures) {
                term.extend(functions);
            }
            limits.extend(found.limits);
        }
        if self.is_one_term() {
            terms = vec![terms.concat()];
        }
        Ok(Evaluation { terms, limits })
    }
}

/// A problem whose only objective is a measured curve: least squares.
pub(super) struct Matched<'a> {
    pub(super) merit_function: &'a MeritFunction<'a>,
    pub(super) curve: &'a Matching,
}

impl Fit for Matched<'_> {
    fn residuals(&self, x: &[f64]) -> Result<Residuals, Cancelled> {
        let MeritFunction {
            problem, cancel, ..
        } = self.merit_function;
        Cancelled::check(cancel)?;
        let moved = problem.moved(x, &[]);
        Ok(match problem.candidate(x, &[], cancel)? {
            Some(candidate) => self.curve.residuals(&Slopes::new(&candidate.model, &moved)),
            None => self.curve.worst_residuals(moved.len()),
        })
    }
}

#[cfg(test)]
mod tests;

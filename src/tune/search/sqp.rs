//! One local search with derivatives: sequential quadratic programming for a sum of largest functions.
//!
//! Every step minimises a quadratic model with the linear pieces of all functions, within a trust region (Han, Math.
//! Programming 1981, 20, 1-13; Fletcher, Practical Methods of Optimization, 2nd ed., 1987, section 14.4). Limits enter
//! by an exact penalty, a limit c as the term max(0, rho c); rho increases until the linear pieces can meet the limits
//! (Byrd, Nocedal & Waltz, Optim. Methods Softw. 2008, 23, 197-213). If a trial point is worse though the model is
//! better, the curvature of the pieces is corrected once (Fletcher, second-order correction) before the region shrinks.
//!
//! The search asks for points and receives their evaluations: the caller evaluates, so that several searches share all
//! cores.

use nalgebra::DVector;

use super::hessian::Hessian;
use super::pairing::pairs;
use super::qp::{QuadraticProgram, Step, slope_along};
use super::types::{Evaluation, Function, Merit, Stop};

/// Half the width of the first trust region.
const FIRST_RADIUS: f64 = 0.1;
/// A trust region this small cannot improve any more.
const LEAST_RADIUS: f64 = 1e-9;
/// A step this short counts as none.
const LEAST_STEP: f64 = 1e-9;
/// Differences of values below this fraction of them are rounding.
const ROUNDING: f64 = 1e-13;
/// A trial point is far above if its increase is more than this multiple of the predicted decrease.
const FAR: f64 = 10.0;
/// Limits are met with this margin, in lengths of the box, so that rounding does not break them.
const MARGIN: f64 = 1e-10;

/// One local search.
#[derive(Debug)]
pub(super) struct Sqp {
    /// The current point.
    x: Vec<f64>,
    /// Its evaluation, with cuts from trial points; `None` before the first evaluation.
    here: Option<Evaluation>,
    /// The number of functions of each term that belong to it; cuts follow them.
    own: Vec<usize>,
    hessian: Hessian,
    radius: f64,
    /// rho.
    penalty: f64,
    /// The length of the last step taken.
    last_length: f64,
    next: Next,
}

/// The next action.
#[derive(Debug)]
enum Next {
    /// Evaluate the start.
    Start,
    /// Evaluate a trial point.
    Trial(Trial),
    /// None.
    Stopped(Stop),
}

#[derive(Debug)]
struct Trial {
    x: Vec<f64>,
    /// The model's step; a corrected step is also compared with its decrease.
    step: Step,
    corrected: bool,
}

impl Sqp {
    /// From a point of the unit box.
    pub(super) fn new(start: Vec<f64>) -> Self {
        Self {
            hessian: Hessian::new(start.len(), 1.0),
            x: start,
            here: None,
            own: Vec::new(),
            radius: FIRST_RADIUS,
            penalty: 1.0,
            last_length: f64::INFINITY,
            next: Next::Start,
        }
    }

    /// The point to evaluate next; `None` if the search has stopped.
    pub(super) fn ask(&self) -> Option<&[f64]> {
        match &self.next {
            Next::Start => Some(&self.x),
            Next::Trial(trial) => Some(&trial.x),
            Next::Stopped(_) => None,
        }
    }

    /// The current point.
    pub(super) fn x(&self) -> &[f64] {
        &self.x
    }

    /// Its merit; `None` before the first evaluation.
    pub(super) fn merit(&self) -> Option<Merit> {
        self.here.as_ref().map(Evaluation::merit)
    }

    /// Why it stopped; `None` while it runs.
    pub(super) fn stopped(&self) -> Option<Stop> {
        match self.next {
            Next::Stopped(stop) => Some(stop),
            _ => None,
        }
    }

    /// Takes the evaluation of the requested point.
    pub(super) fn tell(&mut self, evaluation: Evaluation) {
        let there = with_margin(evaluation);
        match std::mem::replace(&mut self.next, Next::Stopped(Stop::NotFinite)) {
            Next::Stopped(stop) => self.next = Next::Stopped(stop),
            Next::Start if there.is_finite() => self.begin(there),
            Next::Start => {}
            Next::Trial(trial) => self.judge(trial, there),
        }
    }

    fn begin(&mut self, here: Evaluation) {
        let slope = steepest(here.terms.iter().flatten());
        let limit = steepest(&here.limits);
        if slope > 0.0 && limit > 0.0 {
            self.penalty = slope / limit;
        }
        self.hessian = Hessian::new(self.x.len(), slope);
        self.stand(here);
        self.propose();
    }

    /// Takes a trial point, corrects it or shrinks the trust region.
    fn judge(&mut self, trial: Trial, there: Evaluation) {
        let Some(here) = &self.here else { return };
        if !there.is_finite() {
            self.shrink(0.25 * trial.step.d.amax());
            return;
        }
        let (before, after) = (self.height(here), self.height(&there));
        let rounding = ROUNDING * self.size(here);
        let gained = before - after;
        let d = difference(&trial.x, &self.x);
        // A point far above, as next to a pole, says nothing about the curvature here.
        let is_near = -gained <= FAR * trial.step.decrease;
        if is_near && let Some(change) = change(&trial.step, here, &there, (&d, self.penalty)) {
            self.hessian.learn(&d, &change);
        }
        let is_rounding = trial.step.decrease <= rounding && gained >= -rounding;
        let ratio = if is_rounding {
            1.0
        } else {
            gained / trial.step.decrease
        };
        if ratio >= 1e-4 {
            self.accept(trial, there, ratio, is_rounding);
        } else {
            self.refuse(&trial, &there, &d);
        }
    }

    fn accept(&mut self, trial: Trial, there: Evaluation, ratio: f64, is_rounding: bool) {
        let length = trial.step.d.amax();
        if ratio >= 0.75 && length > 0.8 * self.radius {
            self.radius = (2.5 * self.radius).min(1.0);
        } else if ratio < 0.25 {
            self.radius = 0.5 * length;
        }
        self.x = trial.x;
        self.stand(there);
        let slower = length > 0.5 * self.last_length;
        self.last_length = length;
        if is_rounding && slower {
            self.finish(Stop::Converged);
        } else {
            self.propose();
        }
    }

    fn refuse(&mut self, trial: &Trial, there: &Evaluation, d: &DVector<f64>) {
        if !trial.corrected
            && let Some(corrected) = self.corrected(trial, there, d)
        {
            self.next = Next::Trial(corrected);
            return;
        }
        if let Some(here) = &mut self.here {
            add_cuts(here, there, d);
        }
        self.shrink(0.3 * trial.step.d.amax());
    }

    fn shrink(&mut self, radius: f64) {
        self.radius = radius.min(0.5 * self.radius);
        if self.radius < LEAST_RADIUS {
            self.finish(Stop::NoProgress);
        } else {
            self.propose();
        }
    }

    /// Ends the search if nothing better is near.
    fn finish(&mut self, stop: Stop) {
        let mut limits = self.here.iter().flat_map(|here| &here.limits);
        let possible = limits.all(|limit| limit.value <= margin(limit));
        self.next = Next::Stopped(if possible { stop } else { Stop::LimitsUnmet });
    }

    /// Computes the next step.
    fn propose(&mut self) {
        let Some(step) = self.steered() else {
            self.finish(Stop::NoProgress);
            return;
        };
        let length = step.d.amax();
        if length <= LEAST_STEP && length < self.radius {
            // Cuts come from farther away and may be wrong here: they cannot prove a minimum.
            if self.drop_cuts() {
                self.shrink(0.3 * self.radius);
            } else {
                self.finish(Stop::Converged);
            }
            return;
        }
        self.next = Next::Trial(Trial {
            x: self.moved(&step.d),
            step,
            corrected: false,
        });
    }

    /// Removes all functions that do not belong to this point; false if there are no others.
    fn drop_cuts(&mut self) -> bool {
        let Some(here) = &mut self.here else {
            return false;
        };
        let mut dropped = false;
        for (term, own) in here.terms.iter_mut().zip(&self.own) {
            dropped |= term.len() > *own;
            term.truncate(*own);
        }
        dropped
    }

    /// Moves to an evaluated point.
    fn stand(&mut self, here: Evaluation) {
        self.own = here.terms.iter().map(Vec::len).collect();
        self.here = Some(here);
    }

    /// The model's step, with a penalty that makes it meet the limits as far as linear pieces within the region can.
    fn steered(&mut self) -> Option<Step> {
        const FIRMER: f64 = 10.0;
        const NOTABLY: f64 = 0.9;
        const MET: f64 = 1e-9;
        const TIMES: usize = 12;
        let here = self.here.as_ref()?;
        let met = MET * steepest(&here.limits);
        let mut step = self.step_of(&pieces(here, self.penalty))?;
        let mut left = violation_along(&here.limits, &step.d);
        let mut penalty = self.penalty;
        for _ in 0..TIMES {
            if left <= met {
                break;
            }
            let Some(firmer) = self.step_of(&pieces(here, FIRMER * penalty)) else {
                break;
            };
            let less = violation_along(&here.limits, &firmer.d);
            if less > NOTABLY * left {
                break;
            }
            (step, left, penalty) = (firmer, less, FIRMER * penalty);
        }
        self.penalty = penalty;
        Some(step)
    }

    fn step_of(&self, terms: &[Vec<Function>]) -> Option<Step> {
        let bounds: Vec<[f64; 2]> = self
            .x
            .iter()
            .map(|x| [(-x).max(-self.radius), (1.0 - x).min(self.radius)])
            .collect();
        let quadratic = QuadraticProgram {
            hessian: self.hessian.matrix(),
            terms,
            bounds: &bounds,
        };
        quadratic.solve()
    }

    /// The trial point for pieces shifted to the values at the refused point; `None` if it is the same point or there
    /// is no step.
    fn corrected(&self, trial: &Trial, there: &Evaluation, d: &DVector<f64>) -> Option<Trial> {
        const SAME: f64 = 1e-3;
        let here = self.here.as_ref()?;
        let moved = Evaluation {
            terms: here
                .terms
                .iter()
                .zip(&there.terms)
                .map(|(here, there)| moved_pieces(here, there, d))
                .collect(),
            limits: moved_pieces(&here.limits, &there.limits, d),
        };
        let step = self.step_of(&pieces(&moved, self.penalty))?;
        let x = self.moved(&step.d);
        let apart = (&step.d - d).amax();
        (step.decrease > 0.0 && apart > SAME * d.amax()).then(|| Trial {
            x,
            step: trial.step.clone(),
            corrected: true,
        })
    }

    fn moved(&self, d: &DVector<f64>) -> Vec<f64> {
        let coordinates = self.x.iter().zip(d.iter());
        coordinates.map(|(x, d)| (x + d).clamp(0.0, 1.0)).collect()
    }

    /// Goal and penalty together: the value to decrease.
    fn height(&self, evaluation: &Evaluation) -> f64 {
        let merit = evaluation.merit();
        merit.goal + self.penalty * merit.violation
    }

    /// The magnitude of the summands of the height.
    fn size(&self, evaluation: &Evaluation) -> f64 {
        let largest = |term: &Vec<Function>| term.iter().map(|f| f.value.abs()).fold(0.0, f64::max);
        let terms: f64 = evaluation.terms.iter().map(largest).sum();
        terms + self.penalty * evaluation.merit().violation
    }
}

/// An evaluation with limits tightened by the margin, without functions that are minus infinity.
fn with_margin(mut evaluation: Evaluation) -> Evaluation {
    for limit in &mut evaluation.limits {
        limit.value += margin(limit);
    }
    let functions = evaluation.terms.iter_mut();
    for term in functions.chain([&mut evaluation.limits]) {
        term.retain(|function| function.value != f64::NEG_INFINITY);
    }
    evaluation
}

/// The amount by which a limit is tightened.
fn margin(limit: &Function) -> f64 {
    MARGIN * DVector::from_column_slice(&limit.gradient).norm()
}

/// The terms, and every limit as a term of its own.
fn pieces(evaluation: &Evaluation, penalty: f64) -> Vec<Vec<Function>> {
    let limits = evaluation.limits.iter().map(|limit| {
        let nothing = Function {
            value: 0.0,
            gradient: vec![0.0; limit.gradient.len()],
        };
        let weighed = Function {
            value: penalty * limit.value,
            gradient: limit.gradient.iter().map(|g| penalty * g).collect(),
        };
        vec![nothing, weighed]
    });
    evaluation.terms.iter().cloned().chain(limits).collect()
}

/// The largest derivative.
fn steepest<'a>(functions: impl IntoIterator<Item = &'a Function>) -> f64 {
    let slopes = functions.into_iter().flat_map(|f| &f.gradient);
    slopes.fold(0.0, |most, slope| most.max(slope.abs()))
}

/// The sum of the linear limits above 0 at the end of a step.
fn violation_along(limits: &[Function], d: &DVector<f64>) -> f64 {
    Merit::violation(
        limits
            .iter()
            .map(|f| f.value + slope_along(f, d.as_slice())),
    )
}

fn difference(to: &[f64], from: &[f64]) -> DVector<f64> {
    DVector::from_iterator(to.len(), to.iter().zip(from).map(|(to, from)| to - from))
}

/// The change of the Lagrangian's gradient along a step d, by the weights of the step's pieces; `None` if the pieces
/// with weight are not found at its end.
fn change(
    step: &Step,
    here: &Evaluation,
    there: &Evaluation,
    (d, penalty): (&DVector<f64>, f64),
) -> Option<DVector<f64>> {
    if here.terms.len() != there.terms.len() {
        return None;
    }
    let (of_terms, of_limits) = step.weights.split_at(here.terms.len());
    let mut change = DVector::zeros(d.len());
    for ((weights, before), after) in of_terms.iter().zip(&here.terms).zip(&there.terms) {
        add_change(&mut change, weights, (before, after), d)?;
    }
    let weights: Vec<f64> = of_limits.iter().map(|both| penalty * both[1]).collect();
    add_change(&mut change, &weights, (&here.limits, &there.limits), d)?;
    Some(change)
}

fn add_change(
    change: &mut DVector<f64>,
    weights: &[f64],
    (before, after): (&[Function], &[Function]),
    d: &DVector<f64>,
) -> Option<()> {
    /// The fraction of the weight that may be lost.
    const LOST: f64 = 0.02;
    let mut lost: f64 = weights.iter().sum();
    let all = lost;
    for (after, pair) in after.iter().zip(pairs(before, after, d)) {
        let Some(index) = pair else { continue };
        // Cuts that were added later have no weight.
        let weight = weights.get(index).copied().unwrap_or(0.0);
        lost -= weight;
        let gradients = after.gradient.iter().zip(&before[index].gradient);
        for (sum, (after, before)) in change.iter_mut().zip(gradients) {
            *sum += weight * (after - before);
        }
    }
    (lost <= LOST * all).then_some(())
}

/// The functions of one term relative to the start of a step, shifted so that their linear pieces equal the values at
/// its end.
fn moved_pieces(here: &[Function], there: &[Function], d: &DVector<f64>) -> Vec<Function> {
    let pairs = pairs(here, there, d);
    let unpaired = |i: &usize| !pairs.contains(&Some(*i));
    let kept = (0..here.len()).filter(unpaired).map(|i| here[i].clone());
    let moved = there.iter().zip(&pairs).map(|(found, pair)| {
        let gradient = pair.map_or(&found.gradient, |i| &here[i].gradient).clone();
        let mut piece = Function {
            value: found.value,
            gradient,
        };
        piece.value -= slope_along(&piece, d.as_slice());
        piece
    });
    kept.chain(moved).collect()
}

/// Adds the functions of a refused point that are unknown here, as linear pieces not above the values here.
fn add_cuts(here: &mut Evaluation, there: &Evaluation, d: &DVector<f64>) {
    for (here, there) in here.terms.iter_mut().zip(&there.terms) {
        let top = here.iter().map(|f| f.value).reduce(f64::max);
        let Some(top) = top else { continue };
        for (found, pair) in there.iter().zip(pairs(here, there, d)) {
            if pair.is_none() {
                here.push(Function {
                    value: (found.value - slope_along(found, d.as_slice())).min(top),
                    gradient: found.gradient.clone(),
                });
            }
        }
    }
}

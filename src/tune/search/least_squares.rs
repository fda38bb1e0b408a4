//! Least squares in the unit box, and the uncertainty of its variables.
//!
//! The Levenberg-Marquardt method with the scaling of More, The Levenberg-Marquardt algorithm: implementation and
//! theory, Lecture Notes in Mathematics 630, 1978, 105-116; its damping depends on the gain as in Nielsen, Damping
//! parameter in Marquardt's method, IMM-REP-1999-05, Technical University of Denmark, 1999. Steps are cut at the bounds
//! of the box (Kanzow, Yamashita & Fukushima, J. Comput. Appl. Math. 2004, 172, 375-397); a variable stays at a bound
//! beyond which the sum of squares would decrease.

use std::sync::atomic::Ordering::Relaxed;

use nalgebra::{DMatrix, DVector};

use super::covariance::certainty;
use super::types::{
    Certainty, Control, Estimate, Fit, Merit, Phase, Place, Progress, Residuals, Stop,
};

/// Minimises the sum of squared residuals in the unit box, from a point with a coordinate from 0 to 1 for every
/// variable, and computes how well the residuals determine it.
///
/// In [`Progress`] the goal is the sum of squares. If cancelled, or at the end of the budget, the best point so far is
/// the result.
pub fn fit<'a>(problem: &'a dyn Fit, start: &[f64], control: Control<'a>) -> Estimate {
    let mut search = Search {
        problem,
        control,
        evaluations: 0,
    };
    let x: Vec<f64> = start.iter().map(|x| x.clamp(0.0, 1.0)).collect();
    let here = match search.at(&x) {
        Ok(residuals) if is_finite(&residuals) => Here::new(x, residuals),
        other => {
            return nothing(
                x,
                search.evaluations,
                other.err().unwrap_or(Stop::NotFinite),
            );
        }
    };
    let (here, stop) = search.descend(here);
    Estimate {
        sum_of_squares: here.sum,
        residuals: here.residuals.values.len(),
        places: here.places(),
        certainty: certainty(&here.residuals, &here.places()),
        evaluations: search.evaluations,
        x: here.x,
        stop,
    }
}

fn nothing(x: Vec<f64>, evaluations: usize, stop: Stop) -> Estimate {
    Estimate {
        places: vec![Place::Inside; x.len()],
        x,
        sum_of_squares: f64::INFINITY,
        residuals: 0,
        certainty: Certainty::Unknown,
        evaluations,
        stop,
    }
}

fn is_finite(residuals: &Residuals) -> bool {
    let mut numbers = residuals.values.iter().chain(residuals.jacobian.iter());
    numbers.all(|number| number.is_finite()) && residuals.values.norm_squared().is_finite()
}

/// The current point of the search.
struct Here {
    x: Vec<f64>,
    residuals: Residuals,
    /// The sum of squares.
    sum: f64,
}

impl Here {
    fn new(x: Vec<f64>, residuals: Residuals) -> Self {
        let sum = residuals.values.norm_squared();
        Self { x, residuals, sum }
    }

    fn places(&self) -> Vec<Place> {
        let place = |&x: &f64| {
            if x <= 0.0 {
                Place::AtMin
            } else if x >= 1.0 {
                Place::AtMax
            } else {
                Place::Inside
            }
        };
        self.x.iter().map(place).collect()
    }

    /// The free variables: not at a bound beyond which the sum would decrease.
    fn free(&self) -> Vec<usize> {
        // Half of the gradient of the sum of squares.
        let gradient = self.residuals.jacobian.tr_mul(&self.residuals.values);
        let held = |i: usize| {
            self.x[i] <= 0.0 && gradient[i] >= 0.0 || self.x[i] >= 1.0 && gradient[i] <= 0.0
        };
        (0..self.x.len()).filter(|&i| !held(i)).collect()
    }
}

struct Search<'a> {
    problem: &'a dyn Fit,
    control: Control<'a>,
    evaluations: usize,
}

impl Search<'_> {
    fn at(&mut self, x: &[f64]) -> Result<Residuals, Stop> {
        if self.evaluations >= self.control.budget {
            return Err(Stop::Budget);
        }
        if self.control.cancel.load(Relaxed) {
            return Err(Stop::Cancelled);
        }
        let residuals = self.problem.residuals(x)?;
        self.evaluations += 1;
        Ok(residuals)
    }

    fn tell(&mut self, here: &Here) {
        let progress = Progress {
            evaluations: self.evaluations,
            best: here.x.clone(),
            merit: Merit {
                goal: here.sum,
                violation: 0.0,
            },
            phase: Phase::Local,
        };
        (self.control.tell)(&progress);
    }

    fn descend(&mut self, mut here: Here) -> (Here, Stop) {
        let mut damping = Damping::FIRST;
        // The largest length so far of every column (More, section 5).
        let mut scale = DVector::zeros(here.x.len());
        self.tell(&here);
        while damping.value < Damping::MOST {
            widen(&mut scale, &here.residuals.jacobian);
            let Some(step) = here.step(&scale, damping.value) else {
                return (here, Stop::Converged);
            };
            let expected = here.expected(&step);
            if step.amax() <= LEAST_STEP || (0.0..=ROUNDING * here.sum).contains(&expected) {
                return (here, Stop::Converged);
            }
            // If bounds cut the step, it may lead upwards.
            if expected < 0.0 {
                damping.raise();
                continue;
            }
            let x = here.moved(&step);
            match self.at(&x) {
                Ok(residuals) if is_finite(&residuals) => {
                    let there = Here::new(x, residuals);
                    let gain = (here.sum - there.sum) / expected;
                    if gain > 0.0 {
                        damping.ease(gain);
                        here = there;
                    } else {
                        damping.raise();
                    }
                }
                Ok(_) => damping.raise(),
                Err(stop) => return (here, stop),
            }
            self.tell(&here);
        }
        (here, Stop::NoProgress)
    }
}

/// A step this short counts as none.
const LEAST_STEP: f64 = 1e-14;
/// A change of the sum of squares below this fraction of it is rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The damping of steps (Nielsen, equation 2.4).
struct Damping {
    value: f64,
    factor: f64,
}

impl Damping {
    const FIRST: Self = Self {
        value: 1e-3,
        factor: 2.0,
    };
    /// With more damping a step is negligible.
    const MOST: f64 = 1e20;

    /// After a step that gained this fraction of the expected decrease.
    fn ease(&mut self, gain: f64) {
        self.value *= (1.0 - (2.0 * gain - 1.0).powi(3)).max(1.0 / 3.0);
        self.factor = 2.0;
    }

    /// After a step without gain.
    fn raise(&mut self) {
        self.value *= self.factor;
        self.factor *= 2.0;
    }
}

impl Here {
    /// The damped step within the box; `None` if no variable is free or none has an effect.
    fn step(&self, scale: &DVector<f64>, damping: f64) -> Option<DVector<f64>> {
        let free = self.free();
        let free: Vec<usize> = free.into_iter().filter(|&i| scale[i] > 0.0).collect();
        if free.is_empty() {
            return None;
        }
        let rows = self.residuals.values.len();
        let mut matrix = DMatrix::zeros(rows + free.len(), free.len());
        let mut right = DVector::zeros(rows + free.len());
        right
            .rows_mut(0, rows)
            .copy_from(&(-&self.residuals.values));
        for (column, &i) in free.iter().enumerate() {
            let jacobian = self.residuals.jacobian.column(i) / scale[i];
            matrix.view_mut((0, column), (rows, 1)).copy_from(&jacobian);
            matrix[(rows + column, column)] = damping.sqrt();
        }
        // By QR, because J^T J would square the condition number (More, section 3).
        let qr = matrix.qr();
        let scaled = qr.r().solve_upper_triangular(&qr.q().tr_mul(&right))?;
        let mut step = DVector::zeros(self.x.len());
        for (column, &i) in free.iter().enumerate() {
            let x = self.x[i];
            step[i] = (scaled[column] / scale[i]).clamp(-x, 1.0 - x);
        }
        Some(step)
    }

    /// The point at the end of a step; exactly on a bound if rounding would put it next to it.
    fn moved(&self, step: &DVector<f64>) -> Vec<f64> {
        const BESIDE: f64 = 1e-12;
        let ends = self.x.iter().zip(step.iter()).map(|(x, d)| x + d);
        ends.map(|x| match x {
            x if x < BESIDE => 0.0,
            x if x > 1.0 - BESIDE => 1.0,
            x => x,
        })
        .collect()
    }

    /// The decrease of the sum of squares along a step if the residuals are linear.
    fn expected(&self, step: &DVector<f64>) -> f64 {
        let change = &self.residuals.jacobian * step;
        -(2.0 * change.dot(&self.residuals.values) + change.norm_squared())
    }
}

fn widen(scale: &mut DVector<f64>, jacobian: &DMatrix<f64>) {
    for (scale, column) in scale.iter_mut().zip(jacobian.column_iter()) {
        *scale = scale.max(column.norm());
    }
}

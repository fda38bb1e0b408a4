//! Quasi-Newton approximation of the Hessian of a Lagrangian.

use nalgebra::{DMatrix, DVector};

/// A positive definite approximation: the damped BFGS formula of Powell, A fast algorithm for nonlinearly constrained
/// optimization calculations, Lecture Notes in Mathematics 630, 1978, 144-157.
#[derive(Debug, Clone)]
pub(super) struct Hessian {
    matrix: DMatrix<f64>,
    learnt: bool,
}

impl Hessian {
    /// A small multiple of the identity, in units of a typical slope.
    pub(super) fn new(variables: usize, slope: f64) -> Self {
        const SMALL: f64 = 1e-3;
        let slope = if slope > 0.0 { slope } else { 1.0 };
        Self {
            matrix: DMatrix::identity(variables, variables) * (SMALL * slope),
            learnt: false,
        }
    }

    pub(super) fn matrix(&self) -> &DMatrix<f64> {
        &self.matrix
    }

    /// Updates with the change of the Lagrangian's gradient along a step.
    pub(super) fn learn(&mut self, step: &DVector<f64>, change: &DVector<f64>) {
        /// Powell's: the smallest curvature along the step, as a fraction of the known one.
        const LEAST: f64 = 0.2;
        let along = step.dot(change);
        let squared = change.norm_squared();
        if !self.learnt && along > 0.0 && squared / along > 0.0 && (squared / along).is_finite() {
            // Nocedal & Wright, Numerical Optimization, 2nd ed., equation 6.20.
            let size = step.len();
            self.matrix = DMatrix::identity(size, size) * (squared / along);
            self.learnt = true;
        }
        let known = &self.matrix * step;
        let curvature = step.dot(&known);
        if curvature <= 0.0 || !curvature.is_finite() {
            return;
        }
        let part = if along >= LEAST * curvature {
            1.0
        } else {
            (1.0 - LEAST) * curvature / (curvature - along)
        };
        let damped = change * part + &known * (1.0 - part);
        let next = &self.matrix - &known * known.transpose() / curvature
            + &damped * damped.transpose() / step.dot(&damped);
        if next.iter().all(|entry| entry.is_finite()) {
            self.matrix = next;
        }
    }
}

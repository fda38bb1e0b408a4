//! The roots of each mass on its springs with the beam blocked.
//!
//! They are zeros of polynomials and known beforehand: each zero of the characteristic function lies beside one of theirs,
//! or belongs to the beam.

use nalgebra::DMatrix;
use num_complex::Complex64;

use crate::model::{Model, Spring, Subsystem};
use crate::solve::linear::Magnified;

/// All roots of the blocked masses of a model, rad/s.
#[derive(Debug, Clone)]
pub(super) struct Blocked {
    pub(super) roots: Vec<Complex64>,
}

impl Blocked {
    /// Of a checked model.
    pub(super) fn new(model: &Model) -> Self {
        Self {
            roots: model.attached().flat_map(of_mass).collect(),
        }
    }
}

/// The product of `omega` - root over all roots.
pub(super) fn distances(roots: &[Complex64], omega: Complex64) -> Magnified {
    // As many factors as stay within the range of a number.
    const AT_ONCE: usize = 16;
    let mut product = Magnified::ONE;
    for roots in roots.chunks(AT_ONCE) {
        product.times(roots.iter().map(|root| omega - root).product());
    }
    product
}

/// m s^2 + c s + k for y and, with arms and products, for z and theta together; omega = -i s.
fn of_mass(subsystem: &Subsystem) -> Vec<Complex64> {
    let Subsystem {
        y_left,
        y_right,
        z_left,
        z_right,
        mass,
        inertia,
        arm_left,
        arm_right,
        ..
    } = subsystem;
    let sum = |left: &Spring, right: &Spring, weights: [f64; 2]| {
        [
            weights[0] * left.stiffness + weights[1] * right.stiffness,
            weights[0] * left.damping + weights[1] * right.damping,
        ]
    };
    let [k, c] = sum(y_left, y_right, [1.0, 1.0]);
    let y = [k, c, *mass];
    let [k, c] = sum(z_left, z_right, [1.0, 1.0]);
    let z = [k, c, *mass];
    let [k, c] = sum(
        z_left,
        z_right,
        [arm_left * arm_left, arm_right * arm_right],
    );
    let theta = [k, c, *inertia];
    let [k, c] = sum(z_left, z_right, [-arm_left, *arm_right]);
    let across = [k, c, 0.0];
    let mut together = [0.0; 5];
    for i in 0..3 {
        for j in 0..3 {
            together[i + j] += z[i] * theta[j] - across[i] * across[j];
        }
    }
    let roots = roots(&y).into_iter().chain(roots(&together));
    roots.map(|s| -Complex64::I * s).collect()
}

/// The roots of a polynomial, its coefficients by rising power.
fn roots(coefficients: &[f64]) -> Vec<Complex64> {
    let Some(last) = coefficients.iter().rposition(|&c| c != 0.0) else {
        return Vec::new();
    };
    let first = coefficients.iter().position(|&c| c != 0.0).unwrap_or(0);
    let mut roots = vec![Complex64::ZERO; first];
    let (inner, degree) = (&coefficients[first..=last], last - first);
    // The roots' geometric mean as the unit.
    let unit = (inner[0] / inner[degree])
        .abs()
        .powf(1.0 / degree.max(1) as f64);
    let companion = DMatrix::from_fn(degree, degree, |row, column| {
        if column + 1 == degree {
            -inner[row] * unit.powi(row as i32) / (inner[degree] * unit.powi(degree as i32))
        } else if row == column + 1 {
            1.0
        } else {
            0.0
        }
    });
    if degree > 0 {
        roots.extend(
            companion
                .complex_eigenvalues()
                .iter()
                .map(|&root| root * unit),
        );
    }
    roots
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: closed form, (s + 1)(s + 2)(s^2 + 2 s + 5) s^0 and a factor s.
    #[test]
    fn roots_of_a_product_of_known_factors() {
        let known = [
            Complex64::ZERO,
            Complex64::from(-1.0),
            Complex64::from(-2.0),
            Complex64::new(-1.0, 2.0),
            Complex64::new(-1.0, -2.0),
        ];
        let found = roots(&[0.0, 10.0, 19.0, 13.0, 5.0, 1.0]);
        assert_eq!(found.len(), 5);
        for root in known {
            assert!(
                found.iter().any(|other| (other - root).norm() < 1e-10),
                "{root}: {found:?}"
            );
        }
    }
}

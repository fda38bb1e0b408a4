//! The roots of each mass on its springs while the beam is fixed.
//!
//! They are zeros of polynomials and known in advance: each zero of the characteristic function is near one of them, or
//! belongs to the beam.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::characteristic::inverse;
use crate::model::{Model, Subsystem};
use crate::solve::linear::Magnified;
use crate::solve::springs::rows;

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
    // Multiplies as many factors as fit in the range of a number.
    const AT_ONCE: usize = 16;
    let mut product = Magnified::ONE;
    for roots in roots.chunks(AT_ONCE) {
        product.times(roots.iter().map(|root| omega - root).product());
    }
    product
}

/// m s^2 + c s + k for y and, with arms and products, for z and theta together; omega = -i s.
fn of_mass(subsystem: &Subsystem) -> Vec<Complex64> {
    let [across, left, right] = rows(subsystem);
    // The sums for the z springs over two motions of the mass.
    let sum = |i: usize, j: usize, inertia: f64| {
        let weights = [left, right].map(|row| row.mass[i] * row.mass[j]);
        [
            weights[0] * left.spring.complex_stiffness()
                + weights[1] * right.spring.complex_stiffness(),
            (weights[0] * left.spring.damping + weights[1] * right.spring.damping).into(),
            inertia.into(),
        ]
    };
    let Subsystem { mass, inertia, .. } = *subsystem;
    let y = [
        across.spring.complex_stiffness(),
        across.spring.damping.into(),
        mass.into(),
    ];
    let (z, theta) = (sum(1, 1, mass), sum(2, 2, inertia));
    let across = sum(1, 2, 0.0);
    let mut together = [Complex64::ZERO; 5];
    for i in 0..3 {
        for j in 0..3 {
            together[i + j] += z[i] * theta[j] - across[i] * across[j];
        }
    }
    let roots = roots(&y).into_iter().chain(roots(&together));
    roots.map(|s| -Complex64::I * s).collect()
}

/// The roots of a polynomial with coefficients by ascending power, by the iteration of Aberth (Math. Comp. 27 (1973)
/// 339-344); with half the digits if two coincide.
fn roots(coefficients: &[Complex64]) -> Vec<Complex64> {
    const MOST_STEPS: usize = 100;
    let Some(last) = coefficients.iter().rposition(|&c| c != Complex64::ZERO) else {
        return Vec::new();
    };
    let first = coefficients
        .iter()
        .position(|&c| c != Complex64::ZERO)
        .unwrap_or(0);
    let zeros = vec![Complex64::ZERO; first];
    let (inner, degree) = (&coefficients[first..=last], last - first);
    // The unit is the geometric mean of the roots.
    let unit = (inner[0] / inner[degree])
        .norm()
        .powf(1.0 / degree.max(1) as f64);
    let scaled: Vec<Complex64> = (0..=degree)
        .map(|power| inner[power] * unit.powi(power as i32) / inner[0])
        .collect();
    // No starting value is the mirror image of another: symmetric ones would stay symmetric.
    let start = |index: usize| Complex64::cis(0.4 + TAU * index as f64 / degree as f64);
    let mut roots: Vec<Complex64> = (0..degree).map(start).collect();
    for _ in 0..MOST_STEPS {
        let mut largest = 0.0_f64;
        for index in 0..degree {
            let z = roots[index];
            let (mut value, mut slope) = (Complex64::ZERO, Complex64::ZERO);
            for coefficient in scaled.iter().rev() {
                slope = slope * z + value;
                value = value * z + coefficient;
            }
            let others = (0..degree).filter(|&other| other != index);
            let push: Complex64 = others.map(|other| inverse(z - roots[other])).sum();
            let step = value * inverse(slope - value * push);
            roots[index] -= step;
            largest = largest.max(step.norm() / z.norm());
        }
        if largest < 2.0 * f64::EPSILON {
            break;
        }
    }
    zeros
        .into_iter()
        .chain(roots.into_iter().map(|root| root * unit))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: closed form, pairs on the imaginary axis as of a mass without damping, and all roots equal.
    #[test]
    fn symmetric_and_equal_roots_are_found() {
        for (coefficients, known, tolerance) in [
            (vec![4.0, 0.0, 1.0], vec![2.0, -2.0], 1e-14),
            (
                vec![36.0, 0.0, 13.0, 0.0, 1.0],
                vec![2.0, -2.0, 3.0, -3.0],
                1e-14,
            ),
            (
                vec![16.0, 0.0, 8.0, 0.0, 1.0],
                vec![2.0, -2.0, 2.0, -2.0],
                1e-6,
            ),
        ] {
            let coefficients: Vec<Complex64> =
                coefficients.iter().map(|&c: &f64| c.into()).collect();
            let mut found = roots(&coefficients);
            assert_eq!(found.len(), known.len());
            for im in known {
                let root = Complex64::new(0.0, im);
                let near = found
                    .iter()
                    .position(|other| (other - root).norm() < tolerance);
                found.swap_remove(near.expect("a root of the known factors"));
            }
        }
    }

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
        let found = roots(&[0.0, 10.0, 19.0, 13.0, 5.0, 1.0].map(Complex64::from));
        assert_eq!(found.len(), 5);
        for root in known {
            assert!(
                found.iter().any(|other| (other - root).norm() < 1e-10),
                "{root}: {found:?}"
            );
        }
    }
}

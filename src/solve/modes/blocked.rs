//! The roots of each mass on its springs, and of each Maxwell branch of the other springs, while the beam is fixed.
//!
//! They are zeros of polynomials and known in advance: each zero of the characteristic function is near one of them, or
//! belongs to the beam.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::characteristic::inverse;
use crate::model::{BeamMotion, MaxwellBranch, Model, Spring, SpringId, Subsystem};
use crate::solve::linear::Magnified;
use crate::solve::plan::{Event, Held, Plan};
use crate::solve::springs::rows;

/// At a pole itself the characteristic function has no value.
const BESIDE: f64 = 1.001;

/// All roots of the blocked masses and Maxwell branches of a model, rad/s.
#[derive(Debug, Clone)]
pub(super) struct Blocked {
    pub(super) roots: Vec<Complex64>,
}

impl Blocked {
    /// Of a checked model.
    pub(super) fn new(model: &Model) -> Self {
        let masses = model.attached().flat_map(of_mass);
        let others = SpringId::all(model).filter(|id| !matches!(id, SpringId::Subsystem(..)));
        let others = others.filter_map(|id| id.spring(model));
        let others = others.flat_map(|spring| spring.relaxations().into_iter().map(pole));
        Self {
            roots: masses.chain(others.map(|pole| BESIDE * pole)).collect(),
        }
    }
}

/// The angular frequency, rad/s, at which the dynamic stiffness of a Maxwell branch is infinite: `i k_b / c_b`.
fn pole(branch: MaxwellBranch) -> Complex64 {
    Complex64::new(0.0, branch.stiffness / branch.damping)
}

/// The poles of the characteristic function, rad/s: those of the springs that the plan of a model has.
pub(super) fn poles(plan: &Plan) -> Vec<Complex64> {
    let mut springs = Vec::new();
    let of_support = |held: &Held| {
        let moving =
            |motion: &BeamMotion| !(held.without_warping && *motion == BeamMotion::PsiSlope);
        let springs = BeamMotion::ALL.into_iter().filter(moving);
        let springs = springs.map(|motion| held.support[motion].elastic().spring.clone());
        springs.collect::<Vec<Spring>>()
    };
    springs.extend([&plan.left, &plan.right].into_iter().flat_map(of_support));
    for station in &plan.stations {
        match &station.event {
            Event::Attachment(attachment) => springs.extend(attachment.distinct_springs()),
            Event::Support(held) => springs.extend(of_support(held)),
            Event::Joint(joined) => {
                let motions = BeamMotion::ALL.into_iter();
                springs.extend(motions.filter_map(|motion| joined.spring(motion).cloned()));
            }
            Event::Junction(_) | Event::Load(_) | Event::Gap(_) | Event::Probe => {}
        }
    }
    springs
        .iter()
        .flat_map(Spring::relaxations)
        .map(pole)
        .collect()
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

/// A polynomial of s, its coefficients by ascending power; omega = -i s.
type Polynomial = Vec<Complex64>;

/// Numerator and denominator of the dynamic stiffness of a spring.
struct Rational([Polynomial; 2]);

impl Rational {
    /// k (1 + i eta) + c s, and `k_b c_b s / (k_b + c_b s)` of each Maxwell branch.
    fn new(spring: &Spring) -> Self {
        let mut above = vec![spring.complex_stiffness(), spring.damping.into()];
        let mut below = vec![Complex64::ONE];
        for branch in spring.relaxations() {
            let own = [branch.stiffness.into(), branch.damping.into()];
            let series = [Complex64::ZERO, (branch.stiffness * branch.damping).into()];
            above = sum([&product(&above, &own), &product(&below, &series)]);
            below = product(&below, &own);
        }
        Self([above, below])
    }
}

/// m s^2 + k(s) for y, and the determinant for z and theta together, with the dynamic stiffness k of each spring; times its
/// denominators.
fn of_mass(subsystem: &Subsystem) -> Vec<Complex64> {
    let rows = rows(subsystem);
    let [
        Rational([y, below_y]),
        Rational([left, below_left]),
        Rational([right, below_right]),
    ] = rows.each_ref().map(|row| Rational::new(&row.spring));
    let Subsystem { mass, inertia, .. } = *subsystem;
    let squared = |factor: f64| [Complex64::ZERO, Complex64::ZERO, factor.into()];
    let across = sum([&y, &product(&below_y, &squared(mass))]);
    let [_, arm_left, arm_right] = rows.map(|row| row.mass[2]);
    let of_arm = |arm: f64| squared(mass * arm * arm + inertia);
    let inertias = product(&squared(mass), &squared(inertia));
    let apart = (arm_right - arm_left).powi(2);
    let together = [
        product(&inertias, &product(&below_left, &below_right)),
        product(&of_arm(arm_left), &product(&left, &below_right)),
        product(&of_arm(arm_right), &product(&right, &below_left)),
        product(&[apart.into()], &product(&left, &right)),
    ];
    let roots = roots(&across)
        .into_iter()
        .chain(roots(&sum(together.each_ref())));
    roots.map(|s| -Complex64::I * s).collect()
}

fn product(one: &[Complex64], other: &[Complex64]) -> Polynomial {
    let mut product = vec![Complex64::ZERO; one.len() + other.len() - 1];
    for (i, a) in one.iter().enumerate() {
        for (j, b) in other.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

fn sum<const N: usize>(terms: [&Polynomial; N]) -> Polynomial {
    let length = terms.iter().map(|term| term.len()).max().unwrap_or(0);
    let coefficient = |power: usize| terms.iter().filter_map(|term| term.get(power)).sum();
    (0..length).map(coefficient).collect()
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

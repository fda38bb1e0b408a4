//! The two ends of the beam: their supports and loads as equations of the wave amplitudes.

use num_complex::Complex64;

use super::linear::{ZERO, size, solve, solve_with_margin, zeros};
use super::plan::{End, Plan};
use super::reflection::{Amplitudes, Reflection, dot};
use super::springs::restraint_stiffness;
use super::waves::Waves;
use crate::model::BeamMotion;

/// A margin of the last system below which its answer is rounding alone: the model has no damping and is at a
/// resonance to the last digits of the frequency.
pub(super) const RESONANT: f64 = 1e-14;

/// The equation of one motion of an end: `of_a a + of_b b = load`.
struct EndRow {
    of_a: Amplitudes,
    of_b: Amplitudes,
    load: Complex64,
}

/// The equation of one motion of an end.
///
/// `outward` is the sign with which internal forces enter: -1 at the left end (-p + K q = F), +1 at the right.
fn end_row(waves: &Waves, omega: Complex64, end: &End, motion: BeamMotion, outward: f64) -> EndRow {
    let row = motion as usize;
    // Displacements go with a + b and forces with a - b; slopes with b - a and moments with a + b.
    let (moved, moved_a, acted, acted_b) = if row < 3 {
        (&waves.displacement[row], 1.0, &waves.force[row], -1.0)
    } else {
        (&waves.slope[row - 3], -1.0, &waves.moment[row - 3], 1.0)
    };
    let (k, outward, load) = match restraint_stiffness(omega, end.support[motion]) {
        // A fixed motion is zero whatever acts along it.
        None => (Complex64::ONE, 0.0, ZERO),
        Some(k) => (k, outward, end.load[row]),
    };
    let combine = |moved_sign: f64, acted_sign: f64| {
        std::array::from_fn(|wave| {
            k * moved_sign * moved[wave] + outward * acted_sign * acted[wave]
        })
    };
    EndRow {
        of_a: combine(moved_a, 1.0),
        of_b: combine(1.0, acted_b),
        load,
    }
}

/// a = R b + s at the left end.
pub(super) fn left_end(plan: &Plan, waves: &Waves, omega: Complex64) -> Reflection {
    let mut of_a = zeros::<6, 6>();
    let mut right = zeros::<6, 7>();
    for (row, motion) in BeamMotion::ALL.into_iter().enumerate() {
        let equation = end_row(waves, omega, &plan.left, motion, -1.0);
        of_a[row] = equation.of_a;
        for column in 0..6 {
            right[row][column] = -equation.of_b[column];
        }
        right[row][6] = equation.load;
    }
    let solved = solve(of_a, right);
    let mut reflection = Reflection {
        r: zeros(),
        s: [ZERO; 6],
    };
    for row in 0..6 {
        reflection.r[row].copy_from_slice(&solved[row][..6]);
        reflection.s[row] = solved[row][6];
    }
    reflection
}

/// b at the right end, from its six equations with a = R b + s; not finite at an undamped resonance.
pub(super) fn right_end(
    plan: &Plan,
    waves: &Waves,
    omega: Complex64,
    at: &Reflection,
) -> Amplitudes {
    let mut of_b = zeros::<6, 6>();
    // The sizes of what is summed to each entry.
    let mut terms = [[0.0; 6]; 6];
    let mut right = zeros::<6, 1>();
    for (row, motion) in BeamMotion::ALL.into_iter().enumerate() {
        let equation = end_row(waves, omega, &plan.right, motion, 1.0);
        for column in 0..6 {
            let mut sum = equation.of_b[column];
            let mut sizes = size(sum);
            for wave in 0..6 {
                let term = equation.of_a[wave] * at.r[wave][column];
                sum += term;
                sizes += size(term);
            }
            of_b[row][column] = sum;
            terms[row][column] = sizes;
        }
        right[row][0] = equation.load - dot(&equation.of_a, &at.s);
    }
    let (b, margin) = solve_with_margin(of_b, right, terms);
    if margin < RESONANT {
        return [Complex64::new(f64::INFINITY, 0.0); 6];
    }
    b.map(|row| row[0])
}

//! The two ends of the beam: their supports and loads as equations of the wave amplitudes.

use num_complex::Complex64;

use super::linear::{ZERO, size, solve, solve_with_margin, zeros};
use super::plan::{End, Plan};
use super::reflection::{Amplitudes, Reflection, dot};
use super::waves::Waves;
use crate::model::{BeamMotion, Elastic, Restraint};

/// A margin of the last system below which its answer is rounding alone: the model has no damping and is at a
/// resonance to the last digits of the frequency.
const RESONANT: f64 = 1e-14;

/// The equation of one motion of an end as coefficients of (a, b), with what stands on its right.
///
/// `outward` is the sign with which internal forces enter: -1 at the left end (-p + K q = F), +1 at the right.
fn end_row(
    plan: &Plan,
    waves: &Waves,
    omega: f64,
    end: &End,
    motion: BeamMotion,
    outward: f64,
) -> [Amplitudes; 3] {
    let row = motion as usize;
    let slope = row >= 3;
    let (moved, acted) = if slope {
        (&waves.slope[row - 3], &waves.moment[row - 3])
    } else {
        (&waves.displacement[row], &waves.force[row])
    };
    let right = [end.load[row]; 6];
    // Displacements go with a + b and forces with a - b; slopes with b - a and moments with a + b.
    let (of_a, of_b) = if slope { (-1.0, 1.0) } else { (1.0, 1.0) };
    let (force_a, force_b) = if slope { (1.0, 1.0) } else { (1.0, -1.0) };
    match end.support[motion] {
        Restraint::Fixed => [moved.map(|x| of_a * x), moved.map(|x| of_b * x), [ZERO; 6]],
        // Without warping stiffness the least restraint holds the rate of twist.
        Restraint::Elastic(elastic)
            if motion == BeamMotion::PsiSlope
                && plan.beam.without_warping()
                && elastic != Elastic::default() =>
        {
            [moved.map(|x| of_a * x), moved.map(|x| of_b * x), [ZERO; 6]]
        }
        restraint => {
            let k = stiffness(restraint, omega);
            let combine = |sign: f64, force: f64| {
                std::array::from_fn(|wave| k * sign * moved[wave] + outward * force * acted[wave])
            };
            [combine(of_a, force_a), combine(of_b, force_b), right]
        }
    }
}

fn stiffness(restraint: Restraint, omega: f64) -> Complex64 {
    match restraint {
        Restraint::Elastic(Elastic {
            stiffness,
            damping,
            inertia,
        }) => Complex64::new(stiffness - omega * omega * inertia, omega * damping),
        Restraint::Free | Restraint::Fixed => ZERO,
    }
}

/// a = R b + s at the left end.
pub(super) fn left_end(plan: &Plan, waves: &Waves, omega: f64) -> Reflection {
    let mut of_a = zeros::<6, 6>();
    let mut right = zeros::<6, 7>();
    for (row, motion) in BeamMotion::ALL.into_iter().enumerate() {
        let [a, b, load] = end_row(plan, waves, omega, &plan.left, motion, -1.0);
        of_a[row] = a;
        for column in 0..6 {
            right[row][column] = -b[column];
        }
        right[row][6] = load[0];
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
pub(super) fn right_end(plan: &Plan, waves: &Waves, omega: f64, at: &Reflection) -> Amplitudes {
    let mut of_b = zeros::<6, 6>();
    let mut terms = [[0.0; 6]; 6];
    let mut right = zeros::<6, 1>();
    for (row, motion) in BeamMotion::ALL.into_iter().enumerate() {
        let [a, b, load] = end_row(plan, waves, omega, &plan.right, motion, 1.0);
        for column in 0..6 {
            let mut sum = b[column];
            let mut sizes = size(sum);
            for wave in 0..6 {
                let term = a[wave] * at.r[wave][column];
                sum += term;
                sizes += size(term);
            }
            of_b[row][column] = sum;
            terms[row][column] = sizes;
        }
        right[row][0] = load[0] - dot(&a, &at.s);
    }
    let (b, margin) = solve_with_margin(of_b, right, terms);
    if margin < RESONANT {
        return [Complex64::new(f64::INFINITY, 0.0); 6];
    }
    b.map(|row| row[0])
}

//! Loads that excite all modes, and combinations of them.

use nalgebra::DVector;
use num_complex::Complex64;

use crate::model::{BeamMotion, Force, MassMotion, Model, Place, Point, Target, UniformPart};

/// Loads at some positions of the beam and on every mass; those with different numbers `load` are independent.
pub(super) fn loads(model: &Model, load: usize) -> Vec<Force> {
    const PLACES: [f64; 5] = [0.0, 0.217, 0.471, 0.738, 1.0];
    let parts = model.uniform_parts();
    let mut targets: Vec<(Target, f64)> = Vec::new();
    for share in PLACES {
        let x = share * model.length();
        let section = &UniformPart::at(&parts, x).beam.section;
        let radius = (section.polar_moment / section.area).sqrt();
        let place = Place::Position(x);
        for (motion, arm) in [
            (BeamMotion::W, 1.0),
            (BeamMotion::Psi, radius),
            (BeamMotion::V, 1.0),
        ] {
            targets.push((Target::Beam(place, motion), arm));
        }
    }
    for subsystem in model.attached() {
        let turn = (subsystem.inertia / subsystem.mass).sqrt();
        let arm = if turn > 0.0 {
            turn
        } else {
            // Without inertia it may still creep.
            subsystem.arm_left.abs() + subsystem.arm_right.abs()
        };
        for (motion, arm) in [
            (MassMotion::Y, 1.0),
            (MassMotion::Z, 1.0),
            (MassMotion::Theta, arm),
        ] {
            targets.push((Target::Mass(subsystem.name.clone(), motion), arm));
        }
    }
    targets
        .into_iter()
        .enumerate()
        .map(|(index, (target, arm))| Force {
            enabled: true,
            target,
            point: Point::AXIS,
            amplitude: arm * uneven(index, load),
            phase: 0.0,
        })
        .collect()
}

/// A pseudorandom number between -1 and 1 for each pair of numbers.
///
/// Sines or other smooth functions do not work: sin(a index + b load) has rank 2.
/// Source of the mixing: Steele, Lea & Flood, OOPSLA 2014, 453-472 (`SplitMix64`).
fn uneven(index: usize, load: usize) -> f64 {
    let mut bits = (index as u64 + 1)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add((load as u64 + 1).wrapping_mul(0xd1b5_4a32_d192_ed03));
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^= bits >> 31;
    (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// The sum of loads at the same positions, each times its factor.
pub(super) fn combined(loads: &[Vec<Force>], shares: &DVector<Complex64>) -> Vec<Force> {
    let mut sum = loads[0].clone();
    for (place, force) in sum.iter_mut().enumerate() {
        let amplitudes = loads.iter().map(|load| load[place].amplitude);
        let total: Complex64 = amplitudes.zip(shares).map(|(a, share)| a * share).sum();
        (force.amplitude, force.phase) = if total.im == 0.0 {
            (total.re, 0.0)
        } else {
            (total.norm(), total.arg().to_degrees())
        };
    }
    sum
}

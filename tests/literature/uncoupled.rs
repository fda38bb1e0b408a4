//! Bending and torsion of a uniform beam, each by itself (`z_c` = 0), from their frequency equations.
//!
//! Bending: Blevins, Formulas for Natural Frequency and Mode Shape, 1979, Table 8-1. Torsion with warping: Gere,
//! Torsional Vibrations of Beams of Thin-Walled Open Section, Journal of Applied Mechanics 21, 1954, and the same
//! derivation for the ends that he does not treat. All are divided by the hyperbolic cosines in them, which would
//! overflow.

use std::f64::consts::TAU;

use beamtune::model::{BeamMotion, Elastic, Model, Restraint, Support};

use super::roots::roots;

/// The condition of an end on a displacement and its slope.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum End {
    Clamped,
    Pinned,
    Guided,
    Free,
}

fn end(support: &Support, displacement: BeamMotion, slope: BeamMotion) -> End {
    match (support[displacement].clone(), support[slope].clone()) {
        (Restraint::Fixed, Restraint::Fixed) => End::Clamped,
        (Restraint::Fixed, Restraint::Free) => End::Pinned,
        (Restraint::Free, Restraint::Fixed) => End::Guided,
        (Restraint::Free, Restraint::Free) => End::Free,
        other => panic!("no closed form for {other:?}"),
    }
}

/// Both ends, in the order of [`End`].
fn ends(model: &Model, displacement: BeamMotion, slope: BeamMotion) -> (End, End) {
    let left = end(&model.supports.left, displacement, slope);
    let right = end(&model.supports.right, displacement, slope);
    (left.min(right), left.max(right))
}

/// All natural frequencies above zero, Hz, up to `to`, not sorted.
pub fn frequencies(model: &Model, to: f64) -> Vec<f64> {
    let section = &model.beam.section;
    assert_eq!(section.centroid_offset, 0.0, "the motions are coupled");
    let mut all = if let Restraint::Elastic(tip) = &model.supports.right[BeamMotion::W] {
        bending_with_tip(model, tip, to)
    } else {
        let pair = ends(model, BeamMotion::W, BeamMotion::WSlope);
        bending(model, section.second_moment_y, pair, to)
    };
    all.extend(bending_v(model, to));
    all.extend(torsion(model, to));
    all
}

/// Bending along z, which is not coupled to the others.
pub fn bending_v(model: &Model, to: f64) -> Vec<f64> {
    let pair = ends(model, BeamMotion::V, BeamMotion::VSlope);
    bending(model, model.beam.section.second_moment_z, pair, to)
}

/// beta L of bending at a frequency in Hz.
fn beta_length(model: &Model, second_moment: f64, hertz: f64) -> f64 {
    let (material, section) = (&model.beam.material, &model.beam.section);
    let ratio = material.density * section.area / (material.young_modulus * second_moment);
    ((TAU * hertz).powi(2) * ratio).powf(0.25) * model.beam.length
}

fn bending(model: &Model, second_moment: f64, ends: (End, End), to: f64) -> Vec<f64> {
    roots(to, |hertz| {
        let x = beta_length(model, second_moment, hertz);
        let (sin, cos) = x.sin_cos();
        match ends {
            (End::Clamped, End::Clamped) | (End::Free, End::Free) => cos - 1.0 / x.cosh(),
            (End::Clamped, End::Free) => cos + 1.0 / x.cosh(),
            (End::Clamped, End::Pinned) | (End::Pinned, End::Free) => sin - cos * x.tanh(),
            (End::Clamped, End::Guided) | (End::Guided, End::Free) => sin + cos * x.tanh(),
            (End::Pinned, End::Guided) => cos,
            _ => sin,
        }
    })
}

/// A cantilever with a spring and a mass at its right end: the tip's receptance (Bishop & Johnson, The Mechanics of
/// Vibration, 1960) against the dynamic stiffness k - omega^2 m; for a mass alone Laura, Pombo & Susemihl, 1974.
fn bending_with_tip(model: &Model, tip: &Elastic, to: f64) -> Vec<f64> {
    assert_eq!(model.supports.left, Support::CLAMPED);
    let stiffness = model.beam.material.young_modulus * model.beam.section.second_moment_y;
    roots(to, |hertz| {
        let x = beta_length(model, model.beam.section.second_moment_y, hertz);
        let dynamic = tip.spring.stiffness - (TAU * hertz).powi(2) * tip.inertia;
        let beam = stiffness * (x / model.beam.length).powi(3);
        x.cos() + 1.0 / x.cosh() + dynamic / beam * (x.sin() - x.cos() * x.tanh())
    })
}

/// Twist of a beam with or without warping.
pub fn torsion(model: &Model, to: f64) -> Vec<f64> {
    let (material, section) = (&model.beam.material, &model.beam.section);
    let torsional = material.shear_modulus * section.torsion_constant;
    let warping = material.young_modulus * section.warping_constant;
    let inertia = material.density * section.polar_moment;
    if warping == 0.0 {
        return saint_venant(model, torsional, inertia, to);
    }
    let pair = ends(model, BeamMotion::Psi, BeamMotion::PsiSlope);
    roots(to, |hertz| {
        // E Gamma_0 h^2 - G J h - omega^2 rho I_0 = 0, as a sum of positive terms and by the product of the roots.
        let mass = (TAU * hertz).powi(2) * inertia;
        let alpha_squared =
            (torsional + (torsional.powi(2) + 4.0 * warping * mass).sqrt()) / (2.0 * warping);
        let beta_squared = mass / (warping * alpha_squared);
        let length = model.beam.length;
        warped(
            alpha_squared.sqrt() * length,
            beta_squared.sqrt() * length,
            pair,
        )
    })
}

/// The frequency equations of Gere 1954, a = alpha L evanescent and b = beta L travelling.
fn warped(a: f64, b: f64, ends: (End, End)) -> f64 {
    let (sin, cos) = b.sin_cos();
    let (tanh, sech) = (a.tanh(), 1.0 / a.cosh());
    match ends {
        (End::Pinned, End::Pinned) => sin,
        (End::Clamped, End::Pinned) => a * sin - b * cos * tanh,
        (End::Clamped, End::Clamped) => 2.0 * a * b * (sech - cos) + (a * a - b * b) * sin * tanh,
        (End::Clamped, End::Free) => {
            2.0 * (a * b).powi(2) * sech
                + (a.powi(4) + b.powi(4)) * cos
                + a * b * (a * a - b * b) * sin * tanh
        }
        (End::Free, End::Free) => {
            2.0 * (a * b).powi(3) * (sech - cos) + (b.powi(6) - a.powi(6)) * sin * tanh
        }
        (End::Pinned, End::Free) => b.powi(3) * sin - a.powi(3) * cos * tanh,
        other => panic!("no closed form for {other:?}"),
    }
}

/// Twist of a beam without warping, its left end fixed or free, its right end anything.
fn saint_venant(model: &Model, torsional: f64, inertia: f64, to: f64) -> Vec<f64> {
    let left_fixed = model.supports.left[BeamMotion::Psi] == Restraint::Fixed;
    roots(to, |hertz| {
        let omega = TAU * hertz;
        let wave = omega * (inertia / torsional).sqrt();
        let (sin, cos) = (wave * model.beam.length).sin_cos();
        // A free left end has the cosine for its twist, a fixed one the sine.
        let (twist, slope) = if left_fixed { (sin, cos) } else { (cos, -sin) };
        match &model.supports.right[BeamMotion::Psi] {
            Restraint::Fixed => twist,
            Restraint::Free => slope,
            Restraint::Elastic(tip) => {
                let dynamic = tip.spring.stiffness - omega.powi(2) * tip.inertia;
                torsional * wave * slope + dynamic * twist
            }
        }
    })
}

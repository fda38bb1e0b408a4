//! A bound on the work in advance: the approximate number of modes below a frequency.
//!
//! The count halves the beam until its pieces are short compared with every wave; if a number overflows, it would not
//! end.

use std::f64::consts::PI;

use super::MOST_MODES;
use crate::model::{Beam, Model};
use crate::solve::beam_matrices::BeamMatrices;

/// Whether a beam has too many modes below an angular frequency (rad/s) to count them, or numbers outside the range of
/// the arithmetic.
pub(super) fn is_beyond(model: &Model, omega: f64) -> bool {
    /// The coupling of w and psi changes a count by less.
    const FAR: f64 = 4.0;
    // NaN also counts as beyond.
    !matches!(
        half_waves(model, omega).partial_cmp(&(FAR * MOST_MODES as f64)),
        Some(std::cmp::Ordering::Less)
    )
}

/// The number of half waves of uncoupled bending and twist on the beam: equal to the number of modes, except for a few
/// at its ends.
fn half_waves(model: &Model, omega: f64) -> f64 {
    let parts = model.uniform_parts();
    parts.iter().map(|part| of_part(&part.beam, omega)).sum()
}

/// The same on a uniform part.
fn of_part(beam: &Beam, omega: f64) -> f64 {
    let matrices = BeamMatrices::new(beam);
    let BeamMatrices {
        bending,
        tension,
        shear,
        mass,
        rotary,
        ..
    } = &matrices;
    // The wave number k of d k^4 + c k^2 = omega^2 m, in a form without cancellation and overflow; rotary inertia and
    // shear lower c.
    let wave_number = |[d, c, r, f, m]: [f64; 5]| {
        let c = c - omega * (omega * (r + d * f * m));
        let root = c.hypot(2.0 * omega * (d * m).sqrt());
        let square = if c > 0.0 {
            2.0 * omega * (omega * m / (c + root))
        } else {
            (root - c) / (2.0 * d)
        };
        square.sqrt()
    };
    let [first, second] = matrices.principal_bending();
    let waves = wave_number([first, tension.w.re, rotary.w, shear.w.re, mass.w])
        + wave_number([second, tension.v.re, rotary.v, shear.v.re, mass.v])
        + wave_number([bending.psi.re, tension.psi.re, rotary.psi, 0.0, mass.psi]);
    waves * beam.length / PI
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beam() -> Model {
        crate::model::read(crate::presets::find("fig05a").unwrap().text)
            .unwrap()
            .into_inner()
    }

    #[test]
    fn half_waves_are_those_of_each_motion() {
        // Closed form of a clamped beam: bending n = k l / pi with k^4 = omega^2 rho A / E I, twist without warping
        // k = omega sqrt(rho I0 / G J).
        let mut model = beam();
        model.beam.section.warping_constant = 0.0;
        let (material, section) = (model.beam.material, model.beam.section);
        let omega: f64 = 6e3;
        let bending = |i: f64| {
            (omega * omega * material.density * section.area / (material.young_modulus * i))
                .powf(0.25)
        };
        let inertia = material.density * section.polar_moment;
        let stiffness = material.shear_modulus * section.torsion_constant;
        let sum = bending(section.second_moment_y)
            + bending(section.second_moment_z)
            + omega * (inertia / stiffness).sqrt();
        let expected = sum * model.beam.length / PI;
        assert!((half_waves(&model, omega) / expected - 1.0).abs() < 1e-12);
    }

    #[test]
    fn what_cannot_be_counted_is_beyond() {
        let mut model = beam();
        assert!(!is_beyond(&model, 3e3));
        for omega in [1e12, 1e300, f64::INFINITY, f64::NAN] {
            assert!(is_beyond(&model, omega), "{omega}");
        }
        (
            model.beam.section.torsion_constant,
            model.beam.section.warping_constant,
        ) = (0.0, 1e-300);
        assert!(is_beyond(&model, 3e3));
    }
}

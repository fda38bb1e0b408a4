//! How far the theory of Euler and Bernoulli reaches.

use std::f64::consts::TAU;

use super::beam_matrices::BeamMatrices;
use crate::model::{Beam, Model, Theory};

/// By which fraction shear and rotary inertia change the bending wave number at [`euler_bernoulli_up_to`].
pub const CHANGE: f64 = 0.02;

/// The frequency, Hz, above which shear deformation and rotary inertia change the wave number of bending, along y or z, by
/// more than 2 %: with the shear areas, or by rotary inertia alone where they are not given; the least of all uniform
/// parts of the beam. `None` if the beam has another theory.
///
/// Source: the travelling wave of Timoshenko's beam, `D k^4 - omega^2 (R + D F m) k^2 = omega^2 m (1 - omega^2 R F)`
/// (Timoshenko, Philosophical Magazine 41 (1921) 744-746), against `D k^4 = omega^2 m`.
pub fn euler_bernoulli_up_to(model: &Model) -> Option<f64> {
    if model.beam.theory != Theory::EulerBernoulli {
        return None;
    }
    let parts = model.uniform_parts();
    let limits = parts.iter().map(|part| least_limit(&part.beam));
    Some(limits.fold(f64::INFINITY, f64::min) / TAU)
}

/// That of a uniform beam, rad/s.
fn least_limit(beam: &Beam) -> f64 {
    let matrices = BeamMatrices::new(beam);
    let areas = [beam.section.shear_area_y, beam.section.shear_area_z];
    let modulus = beam.material.shear_modulus;
    let inertia = beam.material.density / beam.material.young_modulus;
    let limits = matrices.principal_bending().into_iter().zip(areas);
    let limits = limits.map(|(bending, area)| {
        let shear = if area > 0.0 {
            1.0 / (modulus * area)
        } else {
            0.0
        };
        limit(bending, inertia * bending, shear, matrices.mass.w)
    });
    limits.fold(f64::INFINITY, f64::min)
}

/// The angular frequency, rad/s, at which k^2 is r times its value without shear compliance f and rotary inertia:
/// `r^2 - 2 r a omega = 1 - f rotary omega^2` with `a = (rotary + d f m) / (2 sqrt(d m))`.
fn limit(d: f64, rotary: f64, f: f64, m: f64) -> f64 {
    let r = (1.0 + CHANGE) * (1.0 + CHANGE);
    let linear = r * (rotary + d * f * m) / (2.0 * (d * m).sqrt());
    let constant = r * r - 1.0;
    // The smaller root, without cancellation.
    constant / (linear + (linear * linear - f * rotary * constant).max(0.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Section, Span};

    /// Closed form: at the limit the wave number of Timoshenko's quadratic is 1.02 times that of Euler and Bernoulli.
    #[test]
    fn the_wave_number_differs_by_two_percent_there() {
        for (d, rotary, f, m) in [
            (3e7, 1.2, 0.0, 90.0),
            (3e7, 1.2, 2e-9, 90.0),
            (5e3, 1e-4, 1e-6, 2.0),
        ] {
            let omega = limit(d, rotary, f, m);
            let square = omega * omega;
            let half = 0.5 * square * (rotary + d * f * m);
            let right = square * m * (1.0 - square * rotary * f);
            let k2 = (half + (half * half + d * right).sqrt()) / d;
            let ratio = (k2 / (omega * (m / d).sqrt())).sqrt();
            assert!((ratio - 1.02).abs() < 1e-12, "{ratio}");
        }
    }

    #[test]
    fn another_theory_has_no_such_limit() {
        let mut model = fig05a();
        let limit = euler_bernoulli_up_to(&model).unwrap();
        // Rotary inertia alone, with sqrt(E / rho) 5172 m/s and radii of 0.12 m: a little above 500 Hz.
        assert!((400.0..800.0).contains(&limit), "{limit}");
        model.beam.theory = Theory::Rayleigh;
        assert_eq!(euler_bernoulli_up_to(&model), None);
    }

    fn fig05a() -> Model {
        let read = crate::model::read(crate::presets::find("fig05a").unwrap().text);
        read.unwrap().into_inner()
    }

    /// Closed form: by rotary inertia alone the limit goes with 1 / sqrt(I / A).
    #[test]
    fn the_thickest_span_has_the_least_limit() {
        let mut model = fig05a();
        let of_beam = euler_bernoulli_up_to(&model).unwrap();
        let section = model.beam.section;
        let spans = [1.0, 4.0, 0.25].map(|times| Span {
            length: 1.0,
            section: Some(Section {
                second_moment_y: times * section.second_moment_y,
                second_moment_z: times * section.second_moment_z,
                ..section
            }),
            ..Span::default()
        });
        model.spans.extend(spans);
        let found = euler_bernoulli_up_to(&model).unwrap();
        assert!((found / of_beam - 0.5).abs() < 1e-12, "{found} {of_beam}");
    }
}

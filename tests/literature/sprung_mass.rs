//! A mass on a spring on a beam.

use std::f64::consts::TAU;

use beamtune::model::{Model, Support};

use super::roots::roots;
use super::uncoupled;

/// The mass reacts with k m omega^2 / (k - m omega^2) to the motion of its foot, and the beam with its receptance
/// (Bishop & Johnson, The Mechanics of Vibration, 1960, Table 7.1: pinned ends at any point, a cantilever at its tip);
/// their product is one. The other motions of the beam are as if the mass were not there. All natural frequencies above
/// zero, Hz, up to `to`, not sorted.
pub fn frequencies(model: &Model, to: f64) -> Vec<f64> {
    let [subsystem] = &model.subsystems[..] else {
        panic!("one mass is wanted");
    };
    assert_eq!(subsystem.mount_z, 0.0, "the springs would twist the beam");
    let stiffness = subsystem.y_left.stiffness + subsystem.y_right.stiffness;
    let mut all = roots(to, |hertz| {
        let inertial = (TAU * hertz).powi(2) * subsystem.mass;
        let (numerator, denominator) = receptance(model, subsystem.position, TAU * hertz);
        (stiffness - inertial) * denominator - stiffness * inertial * numerator
    });
    all.extend(uncoupled::bending_v(model, to));
    all.extend(uncoupled::torsion(model, to));
    all
}

/// The receptance of w at a point, m/N, as numerator and denominator, both divided by hyperbolic cosines.
fn receptance(model: &Model, position: f64, omega: f64) -> (f64, f64) {
    let (beam, section) = (&model.beam, &model.beam.section);
    let bending = beam.material.young_modulus * section.second_moment_y;
    let beta = (omega.powi(2) * beam.material.density * section.area / bending).powf(0.25);
    let (x, a, b) = (
        beta * beam.length,
        beta * position,
        beta * (beam.length - position),
    );
    let scale = bending * beta.powi(3);
    if model.supports.left == Support::CLAMPED && model.supports.right == Support::FREE {
        assert_eq!(position, beam.length);
        return (
            x.sin() - x.cos() * x.tanh(),
            scale * (x.cos() + 1.0 / x.cosh()),
        );
    }
    assert_eq!(
        (model.supports.left.clone(), model.supports.right.clone()),
        (Support::PINNED, Support::PINNED)
    );
    let evanescent = a.sinh() * b.sinh() / x.sinh();
    (
        a.sin() * b.sin() - evanescent * x.sin(),
        2.0 * scale * x.sin(),
    )
}

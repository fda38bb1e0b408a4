//! Derivatives that have closed forms.

use crate::checked::checked;
use std::f64::consts::{PI, TAU};

use beamtune::model::{
    Force, MassMotion, Measure, Model, Quantity, Response, Support, Target, path,
};
use beamtune::solve::modes;
use beamtune::solve::sensitivity::Differentiator;
use num_complex::Complex64;

use super::{never, preset, rich};

/// A mass on springs to the ground: on the end of a clamped beam. Its two motions z and theta are coupled.
fn grounded() -> Model {
    let mut model = rich(true);
    model.supports.left = Support::CLAMPED;
    model.subsystems.retain(|of| of.name == "start");
    let start = &mut model.subsystems[0];
    start.y_left.stiffness = 3e5;
    start.z_left.damping = 310.0;
    let target = |motion| Target::Mass("start".to_owned(), motion);
    let force = |motion, amplitude| Force {
        enabled: true,
        target: target(motion),
        amplitude,
        phase: 0.0,
        point: beamtune::model::Point::AXIS,
    };
    model.forces = vec![force(MassMotion::Y, 2.0), force(MassMotion::Z, 3.0)];
    let response = |motion: MassMotion| Response {
        name: motion.key().to_owned(),
        enabled: true,
        quantity: Quantity::Motion(target(motion), Measure::Displacement),
        point: beamtune::model::Point::AXIS,
        over: None,
    };
    model.responses = MassMotion::ALL.map(response).into();
    model
}

/// Expected: the derivatives of the 1x1 and the 2x2 system of the mass alone, written out.
#[test]
fn a_mass_on_springs_to_the_ground() {
    let model = grounded();
    let of = &model.subsystems[0];
    let omega = TAU * 41.0;
    let i_omega = Complex64::new(0.0, omega);
    let stiffness = |k: f64, c: f64| k + i_omega * c;
    let k_y = stiffness(
        of.y_left.stiffness + of.y_right.stiffness,
        of.y_left.damping + of.y_right.damping,
    );
    let [left, right] =
        [of.z_left.clone(), of.z_right.clone()].map(|s| stiffness(s.stiffness, s.damping));
    let (l, r) = (of.arm_left, of.arm_right);
    let y = 2.0 / (k_y - omega * omega * of.mass);
    let zz = left + right - omega * omega * of.mass;
    let zt = right * r - left * l;
    let tt = left * l * l + right * r * r - omega * omega * of.inertia;
    let determinant = zz * tt - zt * zt;
    let (z, theta) = (3.0 * tt / determinant, -3.0 * zt / determinant);
    let answer_z = [tt / determinant, -zt / determinant];
    let answer_t = [-zt / determinant, zz / determinant];
    let by = |answer: [Complex64; 2], dzz: Complex64, dzt: Complex64, dtt: Complex64| {
        -(answer[0] * (dzz * z + dzt * theta) + answer[1] * (dzt * z + dtt * theta))
    };
    let (one, none, square) = (
        Complex64::ONE,
        Complex64::ZERO,
        Complex64::from(-omega * omega),
    );
    let dynamic = |answer| {
        [
            by(answer, one, (-l).into(), (l * l).into()),
            by(answer, i_omega, -l * i_omega, l * l * i_omega),
            by(answer, one, r.into(), (r * r).into()),
            by(answer, i_omega, r * i_omega, r * r * i_omega),
            by(answer, square, none, none),
            by(answer, none, none, square),
            by(answer, none, -left, 2.0 * left * l),
            by(answer, none, right, 2.0 * right * r),
        ]
    };
    let names = [
        "z_left.stiffness",
        "z_left.damping",
        "z_right.stiffness",
        "z_right.damping",
        "mass",
        "inertia",
        "arm_left",
        "arm_right",
    ];
    let differentiator = Differentiator::new(&checked(&model));
    let gradients = differentiator.at(41.0.into());
    let at = |name: &str| {
        let path = format!("subsystems.start.{name}");
        let id = path::one(&model, &path).unwrap();
        let mut ids = differentiator.ids().iter();
        ids.position(|other| *other == id).unwrap()
    };
    let near = |found: Complex64, expected: Complex64, what: &str| {
        assert!(
            (found - expected).norm() <= 1e-13 * expected.norm(),
            "{what}: {found} {expected}"
        );
    };
    near(gradients[0].value, y, "y");
    for side in ["left", "right"] {
        near(
            gradients[0].by_parameter[at(&format!("y_{side}.stiffness"))],
            -0.5 * y * y,
            "k_y",
        );
        near(
            gradients[0].by_parameter[at(&format!("y_{side}.damping"))],
            -0.5 * i_omega * y * y,
            "c_y",
        );
    }
    near(
        gradients[0].by_parameter[at("mass")],
        0.5 * omega * omega * y * y,
        "m of y",
    );
    for (gradient, answer) in [(&gradients[1], answer_z), (&gradients[2], answer_t)] {
        for (name, expected) in names.iter().zip(dynamic(answer)) {
            near(gradient.by_parameter[at(name)], expected, name);
        }
    }
}

/// Expected: f = n^2 pi / (2 L^2) sqrt(E I / rho A) of a pinned Euler-Bernoulli beam.
#[test]
fn the_natural_frequencies_of_a_pinned_beam() {
    let mut model = preset("symmetric_section");
    model.supports.left = Support::PINNED;
    model.supports.right = Support::PINNED;
    model.subsystems.clear();
    model.forces.clear();
    model.responses.clear();
    model.beam.material.loss_factor = 0.0;
    let beam = &model.beam;
    let differentiator = Differentiator::new(&checked(&model));
    let rate = (beam.material.young_modulus * beam.section.second_moment_z
        / (beam.material.density * beam.section.area))
        .sqrt();
    let found = modes::modes(&checked(&model), 3000.0, &never()).unwrap();
    for n in 1..=4 {
        let f = f64::from(n * n) * PI / (2.0 * beam.length.powi(2)) * rate;
        let index = found
            .modes
            .iter()
            .position(|mode| (mode.frequency() / f - 1.0).abs() < 1e-9)
            .unwrap();
        let gradient = differentiator.mode(&found, index);
        for (path, power) in [
            ("beam.material.young_modulus", 0.5),
            ("beam.material.shear_modulus", 0.0),
            ("beam.material.density", -0.5),
            ("beam.section.area", -0.5),
            ("beam.section.second_moment_z", 0.5),
            ("beam.section.second_moment_y", 0.0),
            ("beam.length", -2.0),
        ] {
            let id = path::one(&model, path).unwrap();
            let mut ids = differentiator.ids().iter();
            let index = ids.position(|other| *other == id).unwrap();
            let value = path::number(&model, path).unwrap();
            let found = value * gradient.frequency[index] / f;
            assert!((found - power).abs() < 1e-9, "{n} {path}: {found}");
            let damping = path.ends_with("modulus");
            assert!(!damping || (value * gradient.damping_ratio[index]).abs() < 1e-9);
        }
    }
}

//! Responses exactly at a resonance that is not excited: finite, and continuous.

#![allow(clippy::unwrap_used)]

#[path = "common/checked.rs"]
mod checked;
use checked::checked;
use std::f64::consts::{PI, TAU};
use std::sync::atomic::AtomicBool;

use beamtune::model::{self, Model};
use beamtune::solve::{self, Frf};
use num_complex::Complex64;

fn solved(model: &Model, frequencies: &[f64]) -> Frf {
    solve::sweep(&checked(model), frequencies, &AtomicBool::new(false)).unwrap()
}

fn value(frf: &Frf, name: &str, row: usize) -> Complex64 {
    let column = frf.columns.iter().find(|column| column.name == name);
    column.unwrap().values[row]
}

/// The frequencies that differ from a resonance by rounding only, Hz.
fn last_bits(resonance: f64) -> Vec<f64> {
    let bits = resonance.to_bits();
    (bits - 20..=bits + 20).map(f64::from_bits).collect()
}

#[test]
fn an_undamped_mass_on_a_fixed_end_at_its_own_resonance_changes_nothing() {
    // High-precision solution of the state equation: tests/data/README.md.
    let model = model::read(&std::fs::read_to_string("tests/data/own_resonance.toml").unwrap());
    let frf = solved(&model.unwrap(), &[454.105_192_924_406_37]);
    for (name, re, im) in [
        (
            "p0 psi_slope",
            211_515.390_536_157_76,
            -165_396.735_546_027_3,
        ),
        (
            "p0 v_slope",
            7.944_003_153_473_64e-5,
            1.173_547_531_071_607_8e-4,
        ),
        (
            "p1 psi_slope",
            -0.025_981_803_876_784_13,
            0.020_316_751_106_972_536,
        ),
        (
            "p1 v_slope",
            -0.334_839_759_073_980_56,
            0.226_660_448_900_876_17,
        ),
        ("p2 psi_slope", 57.968_304_356_729_24, 74.131_986_307_071_61),
        ("p2 v_slope", 646.713_729_884_185_6, 955.373_866_743_537_4),
        (
            "S0 z",
            -5.007_701_007_522_934_6e-8,
            -7.990_131_258_065_701e-7,
        ),
        (
            "S0 theta",
            -1.224_126_718_958_583e-4,
            -1.257_956_650_414_467_5e-5,
        ),
        ("EV", 1.517_397_372_181_963_5e-9, 0.0),
    ] {
        let (got, expected) = (value(&frf, name, 0), Complex64::new(re, im));
        let error = (got - expected).norm() / expected.norm();
        assert!(error < 1e-8, "{name}: {got} for {expected}");
    }
    // Closed form: a subsystem on a fixed position without a force does not move.
    assert_eq!(value(&frf, "S3 y", 0), Complex64::ZERO);
}

/// A beam with the given ends, a force along w and v in the span, and a mass on an end.
fn beam(support: &str, position: f64, mass: &str) -> Model {
    let mass = if mass.is_empty() {
        String::new()
    } else {
        format!("[[subsystems]]\nname = \"M\"\nposition = {position}\n{mass}")
    };
    let text = format!(
        "format = \"beamtune/1\"
title = \"A beam with or without a mass\"
[beam]
length = 3.2
[beam.material]
young_modulus = 2.1e11
shear_modulus = 8e10
density = 7850.0
[beam.section]
area = 0.0116
second_moment_y = 1.6625e-4
second_moment_z = 1.3745e-4
torsion_constant = 4.7657e-7
warping_constant = 1e-8
polar_moment = 5.9992e-4
centroid_offset = 0.02
[supports]
left = {{ {support} }}
right = {{ {support} }}
{mass}
[[forces]]
at = 1.0
direction = \"w\"
[[forces]]
at = 1.0
direction = \"v\"
amplitude = 3.0
[[responses]]
name = \"w\"
at = 2.0
direction = \"w\"
[[responses]]
name = \"v\"
at = 2.0
direction = \"v\"
[[responses]]
name = \"EV\"
measure = \"energy\"
[sweep]
from = 1.0
to = 100.0
points = 100
"
    );
    model::read(&text)
        .unwrap_or_else(|faults| panic!("{faults:?}"))
        .into_inner()
}

const FIXED: &str = "w = \"fixed\", psi = \"fixed\", v = \"fixed\"";

#[test]
fn every_resonance_of_a_mass_on_a_fixed_end_leaves_the_beam_as_without_it() {
    // Closed form: f = sqrt(k/m) / 2 pi of each motion alone; with unequal arms those of
    // [K, K h; K h, K_theta] - omega^2 [m, 0; 0, J], in MN/m K = 6 + 2, K h = 2 (0.4) - 6 (0.1) and
    // K_theta = 6 (0.01) + 2 (0.16).
    let springs = "y_left = { stiffness = 2e6 }\ny_right = { stiffness = 7e6 }\n\
                   z_left = { stiffness = 6e6 }\nz_right = { stiffness = 2e6 }\nmount_y = 0.2\nmount_z = 0.1\n";
    let mass = format!("mass = 3.7\ninertia = 0.11\n{springs}arm_left = 0.1\narm_right = 0.4\n");
    let [k, coupling, turn]: [f64; 3] = [8e6 / 3.7, 0.2e6, 0.38e6 / 0.11];
    let root = ((k - turn).powi(2) / 4.0 + coupling * coupling / (3.7 * 0.11)).sqrt();
    let middle = f64::midpoint(k, turn);
    let squares = [9e6 / 3.7, middle + root, middle - root];
    let bare = beam(FIXED, 0.0, "");
    for position in [0.0, 3.2] {
        let read = |direction| {
            format!(
                "[[responses]]\nname = \"{direction}\"\nat = \"M\"\ndirection = \"{direction}\"\n"
            )
        };
        let motions = ["y", "z", "theta"].map(read).concat();
        let loaded = beam(FIXED, position, &format!("{mass}{motions}"));
        for square in squares {
            let frequencies = last_bits(square.sqrt() / TAU);
            let [with, without] = [&loaded, &bare].map(|model| solved(model, &frequencies));
            for row in 0..frequencies.len() {
                for name in ["w", "v", "EV"] {
                    let [got, expected] = [&with, &without].map(|frf| value(frf, name, row));
                    let error = (got - expected).norm() / expected.norm();
                    assert!(error < 1e-10, "{position} m, {name}: {got} for {expected}");
                }
                for name in ["y", "z", "theta"] {
                    assert_eq!(
                        value(&with, name, row),
                        Complex64::ZERO,
                        "{position} m, {name}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_mass_that_the_beam_cannot_turn_is_not_turned_at_its_own_resonance() {
    // Closed form: mounted on one line, with equal springs and arms, theta is uncoupled: J omega^2 = 2 k l^2. Another
    // inertia leaves every other motion unchanged.
    let mass = |inertia: f64| {
        format!(
            "mass = 3.7\ninertia = {inertia:?}\nz_left = {{ stiffness = 4e6 }}\nz_right = {{ stiffness = 4e6 }}\n\
             arm_left = 0.25\narm_right = 0.25\nmount_y = 0.0\nmount_z = 0.1\n"
        )
    };
    let frequencies = last_bits((2.0 * 4e6 * 0.0625 / 0.25_f64).sqrt() / TAU);
    let [own, other] = [0.25, 9.0].map(|j| solved(&beam("", 0.8, &mass(j)), &frequencies));
    for row in 0..frequencies.len() {
        for name in ["w", "v", "EV"] {
            let [got, expected] = [&own, &other].map(|frf| value(frf, name, row));
            assert!(
                (got - expected).norm() < 1e-10 * expected.norm(),
                "{name}: {got}"
            );
        }
    }
}

#[test]
fn a_mass_that_is_driven_at_its_own_resonance_has_no_finite_response() {
    // Closed form: F / (k - omega^2 m) with k = omega^2 m; the beam next to it does not move with the mass.
    let model = beam(
        FIXED,
        0.0,
        "mass = 1.0\ny_left = { stiffness = 16.0 }\nmount_y = 0.1\nmount_z = 0.0\narm_left = 0.1\n\
         arm_right = 0.1\ninertia = 1.0\n[[forces]]\nat = \"M\"\ndirection = \"y\"\n\
         [[responses]]\nname = \"y\"\nat = \"M\"\ndirection = \"y\"\n",
    );
    // Rounding decides at which of these omega^2 is 16 to the last bit: there it is infinite, elsewhere huge.
    let frequencies = last_bits(4.0 / TAU);
    let frf = solved(&model, &frequencies);
    for row in 0..frequencies.len() {
        let y = value(&frf, "y", row);
        assert!(!y.is_finite() || y.norm() > 1e12, "{y}");
    }
    assert!(!frf.singular().is_empty());
}

#[test]
fn a_mode_of_the_other_plane_leaves_the_response_finite() {
    // Closed form: without an offset, w and v are uncoupled, so w does not depend on the bending stiffness of v.
    let mut model = beam(FIXED, 0.0, "");
    model.beam.section.centroid_offset = 0.0;
    model.forces.truncate(1);
    let rigidity = 2.1e11 * 1.3745e-4 / (7850.0 * 0.0116);
    let resonance = (PI / 3.2_f64).powi(2) * f64::sqrt(rigidity) / TAU;
    let mut other = model.clone();
    other.beam.section.second_moment_z = 1e-4;
    let frequencies = last_bits(resonance);
    let [own, other] = [&model, &other].map(|model| solved(model, &frequencies));
    for row in 0..frequencies.len() {
        let [got, expected] = [&own, &other].map(|frf| value(frf, "w", row));
        assert!(
            (got - expected).norm() < 1e-9 * expected.norm(),
            "{got} {expected}"
        );
    }
}

#[test]
fn a_force_at_the_node_of_a_mode_leaves_the_response_finite() {
    // Closed form: a simply supported beam under a force F in its middle moves there by
    // F (tan(k l / 2) - tanh(k l / 2)) / (4 E I k^3), and in its second mode k l = 2 pi.
    let mut model = beam(FIXED, 0.0, "");
    model.beam.section.centroid_offset = 0.0;
    model.forces.truncate(1);
    model.forces[0].target = model::Target::Beam(model::Place::Position(1.6), model::BeamMotion::W);
    model.responses.truncate(1);
    model.responses[0].quantity =
        model::Quantity::Motion(model.forces[0].target.clone(), model::Measure::Displacement);
    let bending: f64 = 2.1e11 * 1.6625e-4;
    let k = TAU / 3.2;
    let resonance = k * k * (bending / (7850.0 * 0.0116)).sqrt() / TAU;
    let expected = -PI.tanh() / (4.0 * bending * k.powi(3));
    let frf = solved(&model, &[resonance]);
    let got = value(&frf, "w", 0);
    assert!(
        (got - expected).norm() < 1e-8 * expected.abs(),
        "{got} {expected}"
    );
}

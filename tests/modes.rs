//! Natural frequencies, damped modes and mode shapes.
//!
//! Expected values: a closed form or a high-precision solution, as each test states; counts and shapes are compared
//! with the frequency responses, which are computed in another way.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[allow(dead_code, reason = "the property tests use the rest")]
mod common;

#[path = "common/checked.rs"]
mod checked;
#[path = "modes/maxwell.rs"]
mod maxwell;
#[path = "modes/spans.rs"]
mod spans;

use checked::checked;
use std::f64::consts::{PI, TAU};
use std::sync::atomic::AtomicBool;

use beamtune::model::{
    self, Beam, BeamMotion, Elastic, InnerSupport, Material, Model, Place, Restraint, Section,
    Spring, Subsystem, Support, Target, Theory,
};
use beamtune::presets;
use beamtune::solve::Cancelled;
use beamtune::solve::modes::{
    Completeness, MOST_MODES, Mode, ModeKind, Modes, buckling_factors, buckling_load, certify,
    count, follow, modes, shape, uncertified, undamped,
};
use common::{models, models_with_branches, respond, unit_force};
use num_complex::Complex64;
use proptest::prelude::*;

static NEVER: AtomicBool = AtomicBool::new(false);

fn preset(name: &str) -> Model {
    model::read(presets::find(name).unwrap().text)
        .unwrap()
        .into_inner()
}

fn damped(model: &Model, to: f64) -> Modes {
    let found = modes(&checked(model), to, &NEVER).unwrap();
    assert_eq!(found.completeness, Completeness::Certain, "{found:?}");
    found
}

fn assert_close(got: f64, want: f64, tolerance: f64) {
    assert!(
        (got - want).abs() <= tolerance * want.abs(),
        "{got} and {want}"
    );
}

/// The section without symmetry of Tanaka & Bercin 1997, with the shear areas of the references below.
fn unsymmetric(length: f64, left: Support, right: Support) -> Model {
    let mut model = preset("purlin");
    (model.subsystems, model.forces, model.responses) = (Vec::new(), Vec::new(), Vec::new());
    model.beam = Beam {
        length,
        material: Material {
            young_modulus: 2e11,
            shear_modulus: 8e10,
            density: 7800.0,
            loss_factor: 0.0,
        },
        section: Section {
            area: 1.947 / 7800.0,
            second_moment_y: 8.34e-8,
            second_moment_z: 3.674e-7,
            torsion_constant: 1.35125e-10,
            warping_constant: 1.317e-10,
            polar_moment: 5.9e-3 / 7800.0,
            centroid_offset: 0.02316,
            centroid_offset_y: 0.02625,
            shear_area_y: 2e-4,
            shear_area_z: 2e-4,
            ..Section::default()
        },
        ..Beam::default()
    };
    (model.supports.left, model.supports.right) = (left, right);
    model
}

fn assert_modes(model: &Model, expected: &[f64]) {
    let to = expected[expected.len() - 1] * 1.0001;
    let found = undamped(&checked(model), to, &NEVER).unwrap().unwrap();
    let rigid = found.iter().filter(|hertz| **hertz == 0.0).count();
    assert_eq!(found.len() - rigid, expected.len(), "{found:?}");
    for (found, expected) in found[rigid..].iter().zip(expected) {
        assert_close(*found, *expected, 2e-7);
    }
}

/// Expected: a Ritz method with polynomials of order 14 and 18, whose results agree in all digits given.
#[test]
fn theories_of_bending_without_symmetry() {
    let ends = |of: &str| match of {
        "CF" => (Support::CLAMPED, Support::FREE),
        "CC" => (Support::CLAMPED, Support::CLAMPED),
        "SS" => (Support::PINNED, Support::PINNED),
        _ => (Support::FREE, Support::FREE),
    };
    for (name, expected) in [
        (
            "CF",
            vec![
                17.160_10, 27.272_36, 58.724_05, 98.441_77, 165.630_41, 270.355_55,
            ],
        ),
        (
            "CC",
            vec![98.402_52, 167.290_02, 268.981_89, 355.108_37, 453.270_78],
        ),
        (
            "SS",
            vec![44.677_23, 74.907_64, 162.651_31, 173.759_05, 295.254_02],
        ),
        (
            "FF",
            vec![20.306_44, 101.141_06, 169.127_06, 271.518_41, 361.733_64],
        ),
    ] {
        let (left, right) = ends(name);
        let mut model = unsymmetric(1.5, left, right);
        model.beam.theory = Theory::Timoshenko;
        assert_modes(&model, &expected);
    }
    let mut model = unsymmetric(1.5, Support::PINNED, Support::PINNED);
    model.beam.theory = Theory::Rayleigh;
    model.beam.warping_inertia = true;
    assert_modes(
        &model,
        &[44.696_03, 75.071_71, 164.093_11, 174.010_32, 297.822_17],
    );
}

/// Expected: the same Ritz method; a foundation along y of 2e5 N/m2.
#[test]
fn a_foundation_without_symmetry() {
    let mut model = unsymmetric(1.5, Support::PINNED, Support::PINNED);
    model.beam.foundation.w.stiffness = 2e5;
    let expected = [46.26534, 91.73971, 166.27289, 174.83074, 303.57655];
    assert_modes(&model, &expected);
}

/// A support between the ends with some restraints.
fn between(position: f64, restraints: &[(BeamMotion, Restraint)]) -> InnerSupport {
    let mut support = Support::FREE;
    for (motion, restraint) in restraints {
        support[*motion] = restraint.clone();
    }
    InnerSupport {
        name: "B1".to_owned(),
        position,
        support,
    }
}

/// Expected: the same Ritz method; a rigid support at 0.6 m, a spring to the ground of 1e5 N/m along y at a point of the
/// section 0.05 m from the axis, and a body of 1 kg and 2e-3 kg m2 at the tip.
///
/// That reference calls the direction z of the motion along y, `w + z psi`, its y.
#[test]
fn supports_and_masses_anywhere_without_symmetry() {
    let pinned = || unsymmetric(1.5, Support::PINNED, Support::PINNED);
    let fixed = Restraint::Fixed;
    let mut held = pinned();
    held.supports.inner = vec![between(
        0.6,
        &[
            (BeamMotion::W, fixed.clone()),
            (BeamMotion::V, fixed.clone()),
            (BeamMotion::Psi, fixed.clone()),
        ],
    )];
    assert_modes(&held, &[147.661_35, 253.268_16, 337.593_41, 557.628_03]);
    let mut in_bearing = pinned();
    in_bearing.supports.inner = vec![between(
        0.6,
        &[(BeamMotion::W, fixed.clone()), (BeamMotion::V, fixed)],
    )];
    assert_modes(
        &in_bearing,
        &[48.672_65, 172.198_84, 255.902_96, 387.006_23],
    );

    let spring = Restraint::Elastic(Elastic {
        spring: Spring {
            stiffness: 1e5,
            ..Spring::default()
        },
        ..Elastic::default()
    });
    let mut sprung = pinned();
    sprung.supports.inner = vec![between(0.9, &[(BeamMotion::W, spring)])];
    sprung.supports.inner[0].support.point.z = 0.05;
    assert_modes(&sprung, &[58.707_21, 78.378_68, 165.310_24, 176.282_46]);

    let mut tip = unsymmetric(1.5, Support::CLAMPED, Support::FREE);
    let mass = |inertia| {
        Restraint::Elastic(Elastic {
            inertia,
            ..Elastic::default()
        })
    };
    tip.supports.right[BeamMotion::W] = mass(1.0);
    tip.supports.right[BeamMotion::V] = mass(1.0);
    tip.supports.right[BeamMotion::Psi] = mass(2e-3);
    assert_modes(
        &tip,
        &[13.080_51, 16.088_50, 32.234_37, 82.366_96, 130.047_56],
    );
}

/// Expected: closed form for pinned ends, otherwise the same Ritz method.
#[test]
fn an_axial_force_without_symmetry_and_its_buckling_load() {
    let pinned = || unsymmetric(1.5, Support::PINNED, Support::PINNED);
    let cantilever = || unsymmetric(1.5, Support::CLAMPED, Support::FREE);
    for (mut model, force, expected) in [
        (
            pinned(),
            -17_514.622_886,
            vec![31.615_217, 68.170_726, 161.810_775],
        ),
        (
            pinned(),
            17_514.622_886,
            vec![54.759_162, 81.524_792, 167.874_270],
        ),
        (
            cantilever(),
            -4_378.655_721,
            vec![13.297_848, 25.062_068, 58.093_678, 94.429_480],
        ),
        (
            cantilever(),
            4_378.655_721,
            vec![20.132_680, 29.345_497, 60.081_870, 102.723_378],
        ),
    ] {
        model.beam.axial_force = force;
        assert_modes(&model, &expected);
    }
    for (model, expected) in [
        (pinned(), 35_029.245_771),
        (cantilever(), 10_358.136_456),
        (
            unsymmetric(1.5, Support::CLAMPED, Support::CLAMPED),
            132_994.254_4,
        ),
    ] {
        let found = buckling_load(&checked(&model)).unwrap();
        assert_close(found, expected, 1e-9);
    }
}

/// Closed form: a pinned beam has one unstable mode between its first and its second Euler load in the weaker plane, and
/// the others oscillate.
#[test]
fn a_buckled_beam_says_so() {
    let mut model = pinned_beam(1e-6);
    let beam = &mut model.beam;
    let euler = PI * PI * beam.material.young_modulus * 1e-6 / beam.length.powi(2);
    beam.material.loss_factor = 0.0;
    beam.axial_force = -2.0 * euler;
    let found = modes(&checked(&model), 50.0, &NEVER).unwrap();
    assert_eq!(found.unstable, 1);
    // omega^2 = omega_n^2 (1 - 2 / n^2).
    let (section, density) = (&model.beam.section, model.beam.material.density);
    let mass = density * section.area;
    let second = (2.0 * PI / model.beam.length).powi(4) * 2.1e11 * 1e-6 / mass * 0.5;
    assert!(found.modes.iter().all(|mode| mode.frequency() > 0.0));
    let nearest = found
        .modes
        .iter()
        .map(|mode| (mode.frequency() - second.sqrt() / TAU).abs());
    assert!(nearest.fold(f64::INFINITY, f64::min) < 1e-8);
    assert_close(buckling_load(&checked(&model)).unwrap(), euler, 1e-9);
}

/// Closed form: a pinned beam buckles at n^2 times the Euler load of each plane, here 1, 3, 4, 9 and 12 times that of
/// the weaker one; twist takes more than all of them.
#[test]
fn factors_on_an_axial_force_are_those_of_euler() {
    let mut model = pinned_beam(3e-6);
    let section = &mut model.beam.section;
    (section.second_moment_y, section.torsion_constant) = (1e-6, 1.0);
    let beam = &mut model.beam;
    let euler = PI * PI * beam.material.young_modulus * 1e-6 / beam.length.powi(2);
    beam.axial_force = -0.25 * euler;
    let found = buckling_factors(&checked(&model), 50.0, 9);
    assert_eq!(found.len(), 5, "{found:?}");
    for (found, expected) in found.iter().zip([4.0, 12.0, 16.0, 36.0, 48.0]) {
        assert_close(*found, expected, 1e-9);
    }
    assert_eq!(buckling_factors(&checked(&model), 13.0, 9).len(), 2);
    assert_eq!(buckling_factors(&checked(&model), 50.0, 1).len(), 1);
    model.beam.axial_force = 0.25 * euler;
    assert!(buckling_factors(&checked(&model), 50.0, 9).is_empty());
    model.beam.axial_force = 0.0;
    assert!(buckling_factors(&checked(&model), 50.0, 9).is_empty());
}

/// The paper's beam with both ends pinned and no offset: bending and torsion are uncoupled.
fn pinned_beam(second_moment_z: f64) -> Model {
    let mut model = preset("fig06");
    model.supports.left = Support::PINNED;
    model.supports.right = Support::PINNED;
    model.beam.section.centroid_offset = 0.0;
    model.beam.section.second_moment_z = second_moment_z;
    model
}

/// Closed form of a pinned beam: bending (n pi / L)^2 sqrt(E I / rho A), torsion with warping likewise.
fn pinned_frequencies(model: &Model, to: f64) -> Vec<f64> {
    let (material, section) = (&model.beam.material, &model.beam.section);
    let mass = material.density * section.area;
    let polar = material.density * section.polar_moment;
    let mut all = Vec::new();
    for n in 1..200 {
        let k = f64::from(n) * PI / model.beam.length;
        for second in [section.second_moment_y, section.second_moment_z] {
            all.push(k * k * (material.young_modulus * second / mass).sqrt() / TAU);
        }
        let twisting = material.young_modulus * section.warping_constant * k * k
            + material.shear_modulus * section.torsion_constant;
        all.push(k * (twisting / polar).sqrt() / TAU);
    }
    all.retain(|&hertz| hertz <= to);
    all.sort_by(f64::total_cmp);
    all
}

/// Expected: `|omega| / 2 pi` and damping ratios of a high-precision solution of the state equation (20 modes).
#[test]
fn the_damped_modes_of_the_papers_beam() {
    let text = include_str!("data/paper_beam_modes.json");
    let expected: Vec<(f64, f64)> = serde_json::from_str(text).unwrap();
    let found = damped(&preset("fig05a"), 250.0);
    assert_eq!(found.modes[0].kind, ModeKind::RigidBody);
    assert_eq!(found.modes.len(), 1 + expected.len());
    for (mode, (hertz, damping)) in found.modes[1..].iter().zip(expected) {
        assert_close(mode.frequency(), hertz, 1e-12);
        assert_close(mode.damping_ratio(), damping, 1e-10);
    }
}

/// Expected: closed form; with equal second moments every bending mode occurs twice, with nearly equal ones the
/// relative difference is 5e-10.
#[test]
fn double_and_nearly_double_roots() {
    let second_moment_y = preset("fig06").beam.section.second_moment_y;
    for share in [1.0, 1.0 + 1e-9, 1.0 + 1e-6] {
        let model = pinned_beam(second_moment_y * share);
        let expected = pinned_frequencies(&model, 2000.0);
        let got = undamped(&checked(&model), 2000.0, &NEVER).unwrap().unwrap();
        assert_eq!(got.len(), expected.len());
        for (got, want) in got.iter().zip(expected) {
            assert_close(*got, want, 1e-10);
        }
    }
}

/// Expected: closed form. With a loss factor on E and G alone, every omega^2 is multiplied by 1 + i eta.
#[test]
fn a_loss_factor_turns_every_root() {
    let second_moment_y = preset("fig06").beam.section.second_moment_y;
    for share in [1.1, 1.0 + 1e-8] {
        let mut model = pinned_beam(second_moment_y * share);
        model.beam.material.loss_factor = 0.03;
        let root = Complex64::new(1.0, 0.03).sqrt();
        // |omega| grows with the loss factor: one undamped mode less may lie below.
        let expected: Vec<f64> = pinned_frequencies(&model, 1500.0)
            .into_iter()
            .map(|hertz| hertz * root.norm())
            .filter(|&hertz| hertz <= 1500.0)
            .collect();
        let found = damped(&model, 1500.0);
        assert_eq!(found.modes.len(), expected.len());
        for (mode, want) in found.modes.iter().zip(expected) {
            assert_close(mode.frequency(), want, 1e-10);
            assert_close(mode.damping_ratio(), root.im / root.norm(), 1e-8);
        }
    }
}

fn mass_on_springs(position: f64, spring: Spring) -> Subsystem {
    Subsystem {
        name: "M".into(),
        enabled: true,
        position,
        mass: 10.0,
        inertia: 1.0,
        y_left: spring.clone(),
        y_right: spring.clone(),
        z_left: spring.clone(),
        z_right: spring,
        arm_left: 0.2,
        arm_right: 0.2,
        mount_y: 0.2,
        mount_z: 0.0,
    }
}

/// A mass on springs and dampers on a beam that is far stiffer.
fn mass_on_stiff_beam(stiffness: f64, damping: f64) -> Model {
    let mut model = preset("fig06");
    model.beam.section.torsion_constant *= 100.0;
    model.supports.left = Support::CLAMPED;
    model.supports.right = Support::CLAMPED;
    model.subsystems = vec![mass_on_springs(
        1.0,
        Spring {
            stiffness,
            damping,
            ..Spring::default()
        },
    )];
    model
}

/// Expected: closed form, `m omega^2 - i c omega - k = 0` for y, z and theta; the compliance of the beam adds less than
/// 5e-3.
#[test]
fn a_mass_on_a_stiff_beam_oscillates_or_creeps() {
    // Damping ratios of 0.3 (oscillating), 3 (two overdamped roots), and one between.
    for share in [0.3_f64, 0.9, 3.0] {
        let (k, m) = (1e4_f64, 10.0_f64);
        let c = share * (2.0 * k * m).sqrt();
        let model = mass_on_stiff_beam(k, c);
        let mut expected = Vec::new();
        // (stiffness, damping, inertia) of y, z, theta.
        for (k, c, m) in [
            (2.0 * k, 2.0 * c, m),
            (2.0 * k, 2.0 * c, m),
            (0.08 * k, 0.08 * c, 1.0),
        ] {
            let discriminant = Complex64::from(4.0 * k * m - c * c).sqrt();
            for sign in [1.0, -1.0] {
                let omega = (Complex64::new(0.0, c) + sign * discriminant) / (2.0 * m);
                if omega.re > -1e-9 {
                    expected.push(omega);
                }
            }
        }
        expected.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        let found = damped(&model, 100.0);
        assert_eq!(
            found.modes.len(),
            expected.len(),
            "{share}: {:?}",
            found.modes
        );
        for (mode, want) in found.modes.iter().zip(expected) {
            assert!(
                (mode.omega - want).norm() < 5e-3 * want.norm(),
                "{share}: {mode:?} {want}"
            );
            let creeps = want.re.abs() < 1e-9;
            assert_eq!(mode.kind == ModeKind::Overdamped, creeps);
        }
    }
}

/// Expected: counted by hand.
#[test]
fn rigid_body_modes_are_at_zero() {
    let zeros = |model: &Model| {
        let found = damped(model, 100.0);
        let rigid = found
            .modes
            .iter()
            .filter(|mode| mode.kind == ModeKind::RigidBody);
        assert!(rigid.clone().all(|mode| mode.frequency() == 0.0));
        assert_eq!(
            rigid.clone().count(),
            undamped(&checked(model), 100.0, &NEVER)
                .unwrap()
                .unwrap()
                .iter()
                .filter(|&&hertz| hertz == 0.0)
                .count()
        );
        rigid.count()
    };
    let mut model = preset("fig06");
    model.supports.left = Support::FREE;
    model.supports.right = Support::FREE;
    // Two translations, two rotations, one about the axis.
    assert_eq!(zeros(&model), 5);
    model.supports.left[BeamMotion::W] = Restraint::Fixed;
    assert_eq!(zeros(&model), 4);
    model.supports.right[BeamMotion::W] = Restraint::Elastic(Elastic {
        spring: Spring {
            stiffness: 1e-3,
            ..Spring::default()
        },
        ..Elastic::default()
    });
    assert_eq!(zeros(&model), 3);
    // A mass without springs has three free motions; with y springs alone two.
    model.subsystems = vec![mass_on_springs(0.7, Spring::default())];
    assert_eq!(zeros(&model), 6);
    model.subsystems[0].y_left.stiffness = 1e5;
    assert_eq!(zeros(&model), 5);
    // Its y spring and the beam's soft support are in series: still restrained.
    model.subsystems[0].inertia = 0.0;
    assert_eq!(zeros(&model), 4);
}

/// Fifty random absorbers on a free beam.
fn fifty_absorbers(seed: u64) -> Model {
    let mut model = preset("fig08");
    let mut state = seed;
    let mut next = |from: f64, to: f64| {
        // A linear congruential generator (Knuth's MMIX).
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    model.subsystems = (0..50)
        .map(|index| {
            let spring = Spring {
                stiffness: next(1e4, 4e6),
                damping: next(0.0, 200.0),
                ..Spring::default()
            };
            Subsystem {
                name: format!("A{index}"),
                position: next(0.0, 3.2),
                mass: next(2.0, 10.0),
                inertia: next(0.1, 1.0),
                arm_left: next(0.05, 0.4),
                arm_right: next(0.05, 0.4),
                mount_y: next(0.05, 0.2),
                mount_z: next(-0.2, 0.2),
                ..mass_on_springs(0.0, spring)
            }
        })
        .collect();
    model.forces.clear();
    model.responses.clear();
    model
}

/// Expected: the count of Wittrick & Williams on both sides of each root, which is independent of the method that
/// refined it.
#[test]
fn every_root_of_fifty_random_absorbers_is_where_the_count_steps() {
    let model = fifty_absorbers(1);
    let roots = undamped(&checked(&model), 200.0, &NEVER).unwrap().unwrap();
    assert_eq!(roots.len(), count(&checked(&model), 200.0));
    assert!(roots.len() > 140, "{}", roots.len());
    for (index, &root) in roots
        .iter()
        .enumerate()
        .skip_while(|(_, root)| **root == 0.0)
    {
        assert!(
            count(&checked(&model), root * (1.0 - 1e-9)) <= index,
            "{root}"
        );
        assert!(
            count(&checked(&model), root * (1.0 + 1e-9)) > index,
            "{root}"
        );
    }
    damped(&model, 200.0);
}

/// Expected: the same list, from a new search.
#[test]
fn modes_that_are_followed_and_counted_are_those_found_afresh() {
    let mut model = preset("fig05a");
    let mut followed = damped(&model, 400.0);
    for step in 0..8 {
        for subsystem in &mut model.subsystems {
            subsystem.mass *= 1.03;
            subsystem.z_left.damping *= 1.1;
        }
        model.supports.left[BeamMotion::W] = Restraint::Elastic(Elastic {
            spring: Spring {
                stiffness: 4e7 * (1.0 - 0.05 * f64::from(step)),
                damping: 800.0,
                ..Spring::default()
            },
            inertia: 0.0,
        });
        followed = follow(&checked(&model), &followed, &NEVER).unwrap();
        assert_eq!(followed.completeness, Completeness::Uncounted);
        let counted = certify(&checked(&model), &followed, &NEVER).unwrap();
        assert_eq!(counted.completeness, Completeness::Certain);
        // The count of a complete list changes no digit.
        assert!(counted.has_modes_of(&followed));
        let afresh = damped(&model, 400.0);
        assert_eq!(followed.undamped, afresh.undamped);
        assert_eq!(followed.modes.len(), afresh.modes.len());
        for (a, b) in followed.modes.iter().zip(&afresh.modes) {
            assert!(
                (a.omega - b.omega).norm() <= 1e-11 * b.omega.norm(),
                "{a:?} {b:?}"
            );
        }
    }
}

/// A list for which no count was made.
fn uncounted(list: &Modes, modes: Vec<Mode>) -> Modes {
    Modes {
        modes,
        completeness: Completeness::Uncounted,
        ..list.clone()
    }
}

/// Whether two lists have the same modes, except for rounding.
fn assert_same(got: &Modes, want: &Modes) {
    assert_eq!(got.modes.len(), want.modes.len());
    for (a, b) in got.modes.iter().zip(&want.modes) {
        assert!(
            (a.omega - b.omega).norm() <= 1e-9 * b.omega.norm(),
            "{a:?} {b:?}"
        );
    }
}

/// Expected: the whole list, even if the follower loses some of it.
#[test]
fn the_count_finds_what_a_list_lacks_or_has_twice() {
    let model = preset("fig05a");
    let whole = damped(&model, 400.0);
    let without = |index: usize| {
        let mut modes = whole.modes.clone();
        modes.remove(index);
        modes
    };
    let mut doubled = whole.modes.clone();
    doubled[10] = doubled[9];
    for modes in [
        without(2),
        without(12),
        without(whole.modes.len() - 1),
        doubled,
    ] {
        let lacking = uncounted(&whole, modes);
        let counted = certify(&checked(&model), &lacking, &NEVER).unwrap();
        assert_eq!(counted.completeness, Completeness::Certain);
        assert_same(&counted, &whole);
    }
    // Ranges that are counted already do not change, and a cancelled count is none.
    assert_eq!(
        certify(&checked(&model), &whole, &NEVER).as_ref(),
        Ok(&whole)
    );
    let cancelled = AtomicBool::new(true);
    let lacking = uncounted(&whole, without(2));
    assert_eq!(
        certify(&checked(&model), &lacking, &cancelled),
        Err(Cancelled)
    );
}

/// fig05a with a damper far beyond the critical damping of its mass.
fn overdamped() -> Model {
    let mut model = preset("fig05a");
    model.subsystems[1].y_left.damping = 1e6;
    model.subsystems[1].y_right.damping = 1e6;
    model
}

/// Expected: the list of a search with its count, which finds overdamped modes first.
#[test]
fn overdamped_modes_come_with_the_count() {
    let model = overdamped();
    let whole = damped(&model, 400.0);
    let overdamped = |list: &Modes| {
        let is_one = |mode: &&Mode| mode.kind == ModeKind::Overdamped;
        list.modes.iter().filter(is_one).count()
    };
    assert!(overdamped(&whole) > 0);
    let before = uncertified(&checked(&model), 400.0, &NEVER).unwrap();
    assert_eq!(before.completeness, Completeness::Uncounted);
    assert!(before.modes.len() < whole.modes.len());
    assert_same(&certify(&checked(&model), &before, &NEVER).unwrap(), &whole);
    // Once known, they are followed.
    let mut longer = model;
    longer.beam.length *= 1.01;
    let followed = follow(&checked(&longer), &whole, &NEVER).unwrap();
    assert_eq!(overdamped(&followed), overdamped(&damped(&longer, 400.0)));
}

/// Expected: as many as a new search finds, also if no list before had them: the beam grows until most of its modes
/// have entered the range from far beyond it.
#[test]
fn modes_that_enter_the_range_are_not_missing_while_no_count_is_made() {
    let mut model = preset("fig05a");
    let mut followed = damped(&model, 200.0);
    let first = followed.modes.len();
    for _ in 0..10 {
        model.beam.length *= 1.05;
        followed = follow(&checked(&model), &followed, &NEVER).unwrap();
        assert_eq!(followed.completeness, Completeness::Uncounted);
        assert_same(&followed, &damped(&model, 200.0));
    }
    assert!(followed.modes.len() > first + 3, "{}", followed.modes.len());
}

/// Expected: as many as a new search finds. Two starts lead to one root, and so one root is lost.
#[test]
fn a_root_that_is_lost_on_the_way_starts_a_search_afresh() {
    let mut model = preset("fig05a");
    let whole = damped(&model, 400.0);
    let mut modes = whole.modes.clone();
    modes[10] = modes[9];
    let doubled = uncounted(&whole, modes);
    model.beam.length *= 1.001;
    let followed = follow(&checked(&model), &doubled, &NEVER).unwrap();
    assert_same(&followed, &damped(&model, 400.0));
}

/// Expected: the argument principle counts the same number as was found, and Wittrick and Williams without damping.
#[test]
fn every_preset_has_all_its_modes() {
    for preset in presets::ALL {
        let model = model::read(preset.text).unwrap().into_inner();
        let to = model.sweep.to.min(400.0);
        let found = damped(&model, to);
        let undamped = undamped(&checked(&model), to, &NEVER).unwrap().unwrap();
        assert_eq!(found.undamped, undamped.len(), "{}", preset.name);
        assert!(!found.modes.is_empty(), "{}", preset.name);
    }
}

/// Expected: the residue of a receptance at a pole. Between two positions it is the product of the mode's motions
/// there: `H = phi_a phi_b / (2 omega_k (omega_k - omega))` close to `omega_k`, from the normalisation.
#[test]
fn shapes_are_normalised_to_modal_mass_one() {
    let model = preset("fig05a");
    let found = damped(&model, 120.0);
    let (a, b) = (
        Target::Beam(Place::Left, BeamMotion::W),
        Target::Beam(Place::Right, BeamMotion::Psi),
    );
    for index in [1, 2, 3, 7, 13] {
        let mode = found.modes[index];
        let shape = shape(&checked(&model), &found, index, 3);
        let product = shape.w[0] * shape.psi[2];
        let residue = |target: &Target| {
            let hertz = mode.omega.re / TAU;
            let from = respond(
                &model,
                vec![unit_force(target.clone())],
                std::slice::from_ref(&b),
                hertz,
            )[0];
            from * 2.0 * mode.omega * (mode.omega - mode.omega.re)
        };
        let got = residue(&a);
        // The share of the other modes: the damping over their distance.
        assert!(
            (got - product).norm() < 0.02 * product.norm(),
            "mode {index}: {got} {product}"
        );
        let shares = shape.shares;
        let sum = shares.bending_y
            + shares.bending_z
            + shares.twist
            + shares.subsystems
            + shares.supports;
        assert_close(sum, 1.0, 1e-12);
    }
}

/// Expected: closed form. A pinned beam of modal mass 1 moves by sqrt(2 / (rho A L)) sin(n pi x / L).
#[test]
fn the_shape_of_a_pinned_beam_is_a_sine() {
    let model = pinned_beam(1e-4);
    let found = damped(&model, 1000.0);
    let mass = model.beam.material.density * model.beam.section.area * model.beam.length;
    let mut bending = 0;
    for index in 0..found.modes.len() {
        let shape = shape(&checked(&model), &found, index, 41);
        if shape.shares.bending_y < 0.5 {
            continue;
        }
        bending += 1;
        let sign = shape.w[1].re.signum();
        for (x, w) in shape.positions.iter().zip(&shape.w) {
            let want =
                (2.0 / mass).sqrt() * (f64::from(bending) * PI * x / model.beam.length).sin();
            assert!(
                (w - sign * want).norm() < 1e-7 * (2.0 / mass).sqrt(),
                "{bending} {x} {w} {want}"
            );
        }
        assert_close(shape.shares.bending_y, 1.0, 1e-9);
    }
    assert!(bending >= 3);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, rng_seed: prop::test_runner::RngSeed::Fixed(5), failure_persistence: None, ..ProptestConfig::default() })]

    /// A mass without springs has no effect: it splits a span, and has its three modes at 0.
    #[test]
    fn the_count_does_not_depend_on_how_stations_are_split(model in models(), places in prop::collection::vec(0.0..=1.0, 1..4), hertz in 1.0..500.0) {
        let mut split = model.clone();
        for (index, share) in places.iter().enumerate() {
            let mut idle = mass_on_springs(share * model.beam.length, Spring::default());
            idle.name = format!("idle {index}");
            split.subsystems.push(idle);
        }
        prop_assert_eq!(count(&checked(&split), hertz), count(&checked(&model), hertz) + 3 * places.len());
    }

    /// Interlacing: one more spring raises every mode, and none past the next.
    #[test]
    fn a_spring_moves_the_count_by_one_at_most(model in models(), power in 2.0..10.0, at in 0_usize..6, hertz in 1.0..500.0) {
        let motion = BeamMotion::ALL[at];
        let mut stiffer = model.clone();
        let restraint = &mut stiffer.supports.left[motion];
        *restraint = match restraint.clone() {
            Restraint::Fixed => Restraint::Fixed,
            Restraint::Free => Restraint::Elastic(Elastic { spring: Spring { stiffness: 10.0_f64.powf(power), ..Spring::default() }, ..Elastic::default() }),
            Restraint::Elastic(elastic) => Restraint::Elastic(Elastic { spring: Spring { stiffness: elastic.spring.stiffness + 10.0_f64.powf(power), ..elastic.spring }, ..elastic }),
        };
        let (before, after) = (count(&checked(&model), hertz), count(&checked(&stiffer), hertz));
        prop_assert!(after == before || after + 1 == before, "{} {}", before, after);
    }

    /// The argument principle counts the modes found, for any model.
    #[test]
    fn every_damped_list_is_certain(model in models_with_branches()) {
        let found = modes(&checked(&model), 150.0, &NEVER).unwrap();
        prop_assert_eq!(found.completeness, Completeness::Certain);
        for pair in found.modes.windows(2) {
            prop_assert!(pair[0].frequency() <= pair[1].frequency());
        }
        prop_assert!(found.modes.iter().all(|mode| mode.omega.im >= -1e-12 * mode.omega.norm()));
    }
}

#[test]
fn more_modes_than_the_limit_are_not_searched() {
    // A beam many times round the earth: by its wave numbers it has far more modes than a list may have.
    let mut model = preset("fig06");
    let never = AtomicBool::new(false);
    for length in [1e13, 1e25] {
        model.beam.length = length;
        assert!(count(&checked(&model), model.sweep.to) > MOST_MODES);
        let found = modes(&checked(&model), model.sweep.to, &never).unwrap();
        assert_eq!(found, Modes::too_many(model.sweep.to));
        assert_eq!(undamped(&checked(&model), model.sweep.to, &never), Ok(None));
    }
}

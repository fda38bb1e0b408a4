//! Shapes of equal and nearly equal modes.
//!
//! Expected: closed forms; orthogonality by construction of the modes.

use crate::checked::checked;
use beamtune::model::{self, Model};
use beamtune::presets;
use beamtune::solve::modes::{Mode, ModeKind, Shape, shape};
use num_complex::Complex64;

use super::{certain, load};

/// Expected: w and psi of a rigid-body mode of a free beam span {1, x | 1, x | 1}; the remainder is rounding error.
#[test]
fn rigid_body_modes_are_straight() {
    let fig08 = model::read(presets::find("fig08").unwrap().text)
        .unwrap()
        .into_inner();
    for model in [
        fig08,
        load("free_equal_moments"),
        load("free_with_subsystems"),
    ] {
        let found = certain(&model, model.sweep.to);
        let rigid = found
            .modes
            .iter()
            .filter(|mode| mode.kind == ModeKind::RigidBody)
            .count();
        assert!(rigid >= 5, "{}", model.title);
        for index in 0..rigid {
            let shape = shape(&checked(&model), &found, index, 11);
            let largest =
                |values: &[Complex64]| values.iter().map(|z| z.norm()).fold(0.0, f64::max);
            let scale = largest(&shape.w)
                .max(largest(&shape.v))
                .max(largest(&shape.psi));
            for k in 1..10 {
                let bent = |values: &[Complex64]| values[k + 1] - 2.0 * values[k] + values[k - 1];
                let twisted = (shape.psi[k] - shape.psi[0]).norm();
                assert!(
                    bent(&shape.w)
                        .norm()
                        .max(bent(&shape.v).norm())
                        .max(twisted)
                        <= 1e-9 * scale,
                    "{index}"
                );
            }
        }
    }
}

/// Expected: closed form. Three masses rotate on springs that exert no net force on the beam (`mount_y` = 0, equal
/// arms), at sqrt(k l^2 / J), with steps of 1e-7 and 3e-6 between their inertias: in each mode one of them rotates.
#[test]
fn nearly_equal_modes_are_separate() {
    for name in ["nearly_alike_undamped", "nearly_alike_damped"] {
        let model = load(name);
        let found = certain(&model, 100.0);
        let mut turning = 0;
        for index in 0..found.modes.len() {
            let shape = shape(&checked(&model), &found, index, 3);
            let mut turns: Vec<f64> = shape.masses.iter().map(|mass| mass[2].norm()).collect();
            turns.sort_by(f64::total_cmp);
            if shape.shares.subsystems > 0.999_999
                && turns[2] * model.subsystems[0].inertia.sqrt() > 0.99
            {
                assert!(turns[1] < 1e-10 * turns[2], "{name} {index}: {turns:?}");
                turning += 1;
            }
        }
        assert_eq!(turning, 3, "{name}");
    }
}

/// A list that has a mode by mistake, once alone and once twice: nothing moves in it, and the others are unchanged.
#[test]
fn a_mode_that_is_none_does_not_move() {
    let model = load("overdamped_once");
    let found = certain(&model, 100.0);
    for (omega, kind, times) in [
        (Complex64::new(300.0, 5.0), ModeKind::Oscillating, 1),
        (Complex64::new(300.0, 5.0), ModeKind::Oscillating, 2),
        (Complex64::new(0.0, 35.0), ModeKind::Overdamped, 1),
    ] {
        let mut wrong = found.clone();
        let rigid = found
            .modes
            .iter()
            .take_while(|mode| mode.kind == ModeKind::RigidBody);
        let first = rigid.count();
        for _ in 0..times {
            wrong.modes.insert(first, Mode { omega, kind });
        }
        for index in first..wrong.modes.len() {
            let shape = shape(&checked(&model), &wrong, index, 3);
            let moves = |z: &Complex64| z.norm() > 0.0;
            let masses = shape.masses.iter().flatten();
            let mut all = shape
                .w
                .iter()
                .chain(&shape.psi)
                .chain(&shape.v)
                .chain(masses);
            assert!(all.clone().all(|z| z.is_finite()));
            assert_eq!(all.any(moves), index >= first + times, "{omega} {index}");
        }
    }
}

/// Expected: closed form, `omega^2 J - i omega c - k = 0` with `c = 2 c_z l^2` and `k = 2 k_z l^2`, twelve times.
#[test]
fn twelve_equal_absorbers_turn_alike() {
    let model = load("twelve_alike");
    let found = certain(&model, 400.0);
    let (k, c, inertia) = turning(&model);
    let hertz = (k / inertia).sqrt() / std::f64::consts::TAU;
    let damping = 0.5 * c / (k * inertia).sqrt();
    let near = |mode: &&Mode| {
        (mode.frequency() / hertz - 1.0).abs() < 1e-10
            && (mode.damping_ratio() / damping - 1.0).abs() < 1e-8
    };
    assert_eq!(found.modes.iter().filter(near).count(), 12);
}

/// Modal mass along a shape pair, by the masses alone.
fn product(model: &Model, a: &Shape, b: &Shape) -> Complex64 {
    let pairs = model.attached().zip(a.masses.iter().zip(&b.masses));
    pairs
        .map(|(one, (p, q))| one.mass * (p[0] * q[0] + p[1] * q[1]) + one.inertia * p[2] * q[2])
        .sum()
}

/// Expected: equal modes in which only masses rotate are orthogonal in these.
#[test]
fn equal_modes_are_orthogonal() {
    let model = load("three_alike_undamped");
    let found = certain(&model, 100.0);
    let shapes: Vec<Shape> = (0..found.modes.len())
        .map(|index| shape(&checked(&model), &found, index, 3))
        .collect();
    let turning: Vec<&Shape> = shapes
        .iter()
        .filter(|shape| {
            let turned: f64 = shape
                .masses
                .iter()
                .map(|mass| 0.1 * mass[2].norm_sqr())
                .sum();
            turned > 0.999
        })
        .collect();
    assert_eq!(turning.len(), 3);
    for (i, a) in turning.iter().enumerate() {
        for (j, b) in turning.iter().enumerate() {
            let want = if i == j { 1.0 } else { 0.0 };
            assert!((product(&model, a, b) - want).norm() < 1e-9, "{i} {j}");
        }
    }
}

/// Expected: closed form. The residues of equal modes add up to that of one mass alone,
/// `theta^2 = 2 omega / (2 omega J - i c)`, and between two masses there is none.
#[test]
fn residues_of_equal_damped_modes_add_up() {
    let model = load("twelve_alike");
    let found = certain(&model, 100.0);
    let (k, c, inertia) = turning(&model);
    let omega = (Complex64::new(0.0, c) + Complex64::from(4.0 * k * inertia - c * c).sqrt())
        / (2.0 * inertia);
    let equal = (0..found.modes.len())
        .filter(|&index| (found.modes[index].omega - omega).norm() < 1e-9 * omega.norm());
    let shapes: Vec<Shape> = equal
        .map(|index| shape(&checked(&model), &found, index, 3))
        .collect();
    assert_eq!(shapes.len(), 12);
    let one = 2.0 * omega / (2.0 * omega * inertia - Complex64::I * c);
    for a in 0..12 {
        for b in 0..12 {
            let sum: Complex64 = shapes
                .iter()
                .map(|shape| shape.masses[a][2] * shape.masses[b][2])
                .sum();
            let want = if a == b { one } else { Complex64::ZERO };
            assert!(
                (sum - want).norm() < 1e-8 * one.norm(),
                "{a} {b}: {sum} {want}"
            );
        }
    }
}

/// Expected: exact determinant in ball arithmetic, 31.83098861837907 Hz with damping ratio 0.02, four times.
#[test]
fn four_equal_damped_modes() {
    let found = certain(&load("alike_damped"), 400.0);
    let near = |mode: &&Mode| {
        (mode.frequency() / 31.830_988_618_379_07 - 1.0).abs() < 1e-10
            && (mode.damping_ratio() / 0.02 - 1.0).abs() < 1e-8
    };
    assert_eq!(found.modes.iter().filter(near).count(), 4);
}

/// Stiffness, damping and inertia of a mass that rotates on its z springs alone.
fn turning(model: &Model) -> (f64, f64, f64) {
    let one = &model.subsystems[0];
    let square = 2.0 * one.arm_left.powi(2);
    (
        square * one.z_left.stiffness,
        square * one.z_left.damping,
        one.inertia,
    )
}

//! Modes of models with Maxwell branches.

use super::{NEVER, assert_close, checked, damped, mass_on_springs, preset};
use beamtune::model::{BeamMotion, MaxwellBranch, Model, Restraint, Spring, Support};
use beamtune::solve::modes::{Completeness, ModeKind, count, follow, modes};
use num_complex::Complex64;

/// A mass on springs with a branch each, at a clamped end: the beam does not move with it.
fn mass_at_a_clamped_end(stiffness: f64, branch: MaxwellBranch) -> Model {
    let mut model = preset("fig06");
    model.beam.section.torsion_constant *= 100.0;
    (model.supports.left, model.supports.right) = (Support::CLAMPED, Support::CLAMPED);
    model.subsystems = vec![mass_on_springs(
        0.0,
        Spring {
            stiffness,
            maxwell: vec![branch],
            ..Spring::default()
        },
    )];
    model
}

/// Expected: closed form, `(s + nu)(s^2 + K/m) + s K_b/m` with the roots -a +- i b and -r, nu = `k_b / c_b`: along y and
/// along z, and about x with the arms of the springs.
#[test]
fn a_mass_on_maxwell_springs_oscillates_and_creeps() {
    let (a, b, r, mass) = (20.0, 300.0, 500.0, 10.0);
    let rate = 2.0 * a + r;
    let static_stiffness = mass * r * (a * a + b * b) / rate;
    let of_branch = mass * (a * a + b * b + 2.0 * a * r) - static_stiffness;
    // Two springs along each axis.
    let branch = MaxwellBranch {
        stiffness: 0.5 * of_branch,
        damping: 0.5 * of_branch / rate,
    };
    let model = mass_at_a_clamped_end(0.5 * static_stiffness, branch);
    let found = damped(&model, 100.0);
    for root in [Complex64::new(b, a), Complex64::new(0.0, r)] {
        let near = |omega: Complex64| (omega - root).norm() < 1e-9 * root.norm();
        let there = found.modes.iter().filter(|mode| near(mode.omega)).count();
        assert_eq!(there, 2, "{root}: {:?}", found.modes);
    }
    let turning = found.modes.iter().filter(|mode| {
        let on_axis = mode.kind == ModeKind::Overdamped;
        on_axis && (mode.omega.im - r).abs() > 1.0
    });
    assert_eq!(turning.count(), 1, "{:?}", found.modes);
}

/// Expected: closed form. The count takes the static stiffness, whatever the branches.
#[test]
fn branches_are_not_counted_as_springs() {
    let branch = MaxwellBranch {
        stiffness: 1e9,
        damping: 1e6,
    };
    let model = mass_at_a_clamped_end(1e5, branch);
    let mut without = model.clone();
    for spring in without.subsystems[0].springs_mut() {
        spring.maxwell.clear();
    }
    for hertz in [5.0, 22.0, 23.0, 40.0, 100.0] {
        let [with, without] = [&model, &without].map(|model| count(&checked(model), hertz));
        assert_eq!(with, without, "{hertz} Hz");
    }
}

/// Expected: the same model. A branch with a damper that hardly moves is a spring.
#[test]
fn a_stiff_damper_makes_a_branch_a_spring() {
    let (own, of_branch) = (2e7, 3e7);
    let on = |restraint: Restraint| {
        let mut model = preset("fig05a");
        model.supports.left[BeamMotion::W] = restraint;
        damped(&model, 60.0).modes
    };
    let elastic = |stiffness: f64, maxwell: Vec<MaxwellBranch>| {
        let mut elastic = preset("fig05a").supports.left[BeamMotion::W]
            .elastic()
            .clone();
        (elastic.spring.stiffness, elastic.spring.maxwell) = (stiffness, maxwell);
        Restraint::Elastic(elastic)
    };
    let branch = MaxwellBranch {
        stiffness: of_branch,
        damping: 1e15,
    };
    let expected = on(elastic(own + of_branch, Vec::new()));
    let mut found = on(elastic(own, vec![branch]));
    // What is left of the branch creeps, hours long.
    found.retain(|mode| mode.kind != ModeKind::Overdamped);
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        assert_close(found.omega.re, expected.omega.re, 1e-9);
        assert_close(found.omega.im, expected.omega.im, 1e-6);
    }
}

/// Expected: the list of the changed model itself.
#[test]
fn a_list_follows_a_branch() {
    let model = |damping: f64| {
        let mut model = preset("fig05a");
        for spring in model.subsystems[0].springs_mut() {
            let stiffness = 0.5 * spring.stiffness;
            spring.maxwell.push(MaxwellBranch { stiffness, damping });
        }
        checked(&model)
    };
    let before = modes(&model(2e4), 60.0, &NEVER).unwrap();
    assert_eq!(before.completeness, Completeness::Certain);
    let after = model(2.1e4);
    let followed = follow(&after, &before, &NEVER).unwrap();
    let expected = modes(&after, 60.0, &NEVER).unwrap();
    assert_eq!(followed.modes.len(), expected.modes.len());
    for (followed, expected) in followed.modes.iter().zip(&expected.modes) {
        let apart = (followed.omega - expected.omega).norm();
        assert!(
            apart <= 1e-9 * expected.omega.norm(),
            "{followed:?} {expected:?}"
        );
    }
}

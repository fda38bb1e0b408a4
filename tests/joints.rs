//! Joints against closed forms of beams with hinges, and against their limits.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use beamtune::model::{
    BeamMotion, Checked, Force, Joint, Link, Measure, Model, Place, Point, Quantity, Response,
    Spring, Support, Target, read,
};
use beamtune::{presets, solve};
use num_complex::Complex64;

/// The paper's section without offset, so that w, psi and v are on their own, without subsystems and damping.
fn beam(left: Support, right: Support) -> Model {
    let mut model = read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    model.beam.material.loss_factor = 0.0;
    model.beam.section.centroid_offset = 0.0;
    (model.supports.left, model.supports.right) = (left, right);
    model.subsystems.clear();
    model.forces.clear();
    model.responses.clear();
    model.studies.clear();
    model.tune = None;
    model
}

fn joint(position: f64, links: &[(BeamMotion, Link)]) -> Joint {
    let mut joint = Joint {
        position,
        ..Joint::default()
    };
    for (motion, link) in links {
        joint[*motion] = link.clone();
    }
    joint
}

fn spring(stiffness: f64) -> Link {
    Link::Elastic(Spring {
        stiffness,
        ..Spring::default()
    })
}

/// sqrt(E I / rho A) / 2 pi for w, m2 Hz: times k^2 it is a frequency.
fn speed(model: &Model) -> f64 {
    let (material, section) = (&model.beam.material, &model.beam.section);
    let stiffness = material.young_modulus * section.second_moment_y;
    (stiffness / (material.density * section.area)).sqrt() / TAU
}

fn natural_frequencies(model: &Model, to: f64) -> Vec<f64> {
    let model = Checked::new(model.clone()).unwrap();
    solve::modes::undamped(&model, to, &AtomicBool::new(false))
        .unwrap()
        .unwrap()
}

/// Whether a list has a frequency, Hz.
fn has(list: &[f64], wanted: f64) -> bool {
    list.iter().any(|found| (found / wanted - 1.0).abs() < 1e-9)
}

/// The root of a function that changes its sign between two numbers, by halving.
fn root(of: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    let sign = of(low).signum();
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if of(middle).signum() == sign {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Expected: closed form. Two pinned halves with a hinge between them turn against each other without any force: one
/// mode at 0 Hz. Moving against each other in antisymmetry, each is a pinned beam of half the length.
#[test]
fn a_hinge_in_the_middle_of_a_pinned_beam_is_a_mechanism() {
    let mut model = beam(Support::PINNED, Support::PINNED);
    let half = 0.5 * model.beam.length;
    model.joints = vec![joint(half, &[(BeamMotion::WSlope, Link::Free)])];
    let found = natural_frequencies(&model, 600.0);
    assert_eq!(found.iter().filter(|f| **f == 0.0).count(), 1);
    let pinned = speed(&model) * (std::f64::consts::PI / half).powi(2);
    assert!(has(&found, pinned), "{pinned} Hz in {found:?}");
    // Symmetric: tan k l = tanh k l of a half that is pinned outside and slides, free to turn, in the middle.
    let x = root(|x| x.tan() - x.tanh(), [3.2, 4.7]);
    let symmetric = speed(&model) * (x / half).powi(2);
    assert!(has(&found, symmetric), "{symmetric} Hz in {found:?}");
}

/// Expected: closed form. In antisymmetry w is 0 at the hinge and each half is clamped and pinned: tan x = tanh x; in
/// symmetry moment and shear force are 0 there and each half is a cantilever: cos x cosh x = -1.
#[test]
fn a_hinge_in_the_middle_of_a_clamped_beam_makes_two_cantilevers() {
    let mut model = beam(Support::CLAMPED, Support::CLAMPED);
    let half = 0.5 * model.beam.length;
    model.joints = vec![joint(half, &[(BeamMotion::WSlope, Link::Free)])];
    let found = natural_frequencies(&model, 900.0);
    let propped = root(|x| x.tan() - x.tanh(), [3.2, 4.7]);
    let cantilever = |range| root(|x: f64| x.cos() * x.cosh() + 1.0, range);
    for x in [cantilever([1.0, 3.0]), propped, cantilever([4.0, 6.0])] {
        let wanted = speed(&model) * (x / half).powi(2);
        assert!(has(&found, wanted), "{wanted} Hz in {found:?}");
    }
}

/// Expected: closed form. A cut of all six motions leaves two cantilevers: the modes of each, at one frequency.
#[test]
fn a_beam_that_is_cut_through_is_two_beams() {
    let mut model = beam(Support::CLAMPED, Support::FREE);
    let x = 0.4 * model.beam.length;
    model.joints = vec![joint(
        x,
        &BeamMotion::ALL.map(|motion| (motion, Link::Free)),
    )];
    let found = natural_frequencies(&model, 600.0);
    // Six motions of the free part.
    assert_eq!(found.iter().filter(|f| **f == 0.0).count(), 5);
    let cantilever = root(|x: f64| x.cos() * x.cosh() + 1.0, [1.0, 3.0]);
    assert!(has(&found, speed(&model) * (cantilever / x).powi(2)));
    let free = root(|x: f64| x.cos() * x.cosh() - 1.0, [4.0, 5.0]);
    let rest = model.beam.length - x;
    assert!(has(&found, speed(&model) * (free / rest).powi(2)));
}

/// Expected: closed form. Two cantilevers joined by a rotational spring k at their ends: in antisymmetry the spring
/// does not turn; in symmetry each half has a spring 2 k at its free end, `cos x cosh x + 1 + c (cos x sinh x + sin x
/// cosh x) / x = 0` with c = 2 k l / E I.
#[test]
fn a_coupling_of_two_cantilevers_is_a_spring_at_each() {
    let mut model = beam(Support::CLAMPED, Support::CLAMPED);
    let half = 0.5 * model.beam.length;
    let bending = model.beam.material.young_modulus * model.beam.section.second_moment_y;
    for share in [1e-3, 0.7, 40.0] {
        let stiffness = share * bending / half;
        model.joints = vec![joint(half, &[(BeamMotion::WSlope, spring(stiffness))])];
        let found = natural_frequencies(&model, 600.0);
        let c = 2.0 * share;
        let sprung =
            |x: f64| x.cos() * x.cosh() + 1.0 + c * (x.cos() * x.sinh() + x.sin() * x.cosh()) / x;
        let wanted = speed(&model) * (root(sprung, [1.0, 3.0]) / half).powi(2);
        assert!(has(&found, wanted), "{wanted} Hz in {found:?}");
    }
}

/// The response of a damped beam with the paper's section, w at 0.6 m under a force at 2.3 m, at some frequencies.
fn answers(joints: Vec<Joint>) -> Vec<Complex64> {
    let mut model = beam(Support::PINNED, Support::CLAMPED);
    model.beam.section.centroid_offset = 0.0619;
    model.beam.material.loss_factor = 0.02;
    model.joints = joints;
    let target = |x, motion| Target::Beam(Place::Position(x), motion);
    model.forces.push(Force {
        enabled: true,
        target: target(2.3, BeamMotion::W),
        point: Point::AXIS,
        amplitude: 1.0,
        phase: 0.0,
    });
    for (index, motion) in BeamMotion::ALL.into_iter().enumerate() {
        model.responses.push(Response {
            name: format!("R{index}"),
            enabled: true,
            quantity: Quantity::Motion(target(0.6, motion), Measure::Displacement),
            point: Point::AXIS,
            over: None,
        });
    }
    let model = Checked::new(model).unwrap();
    let frequencies = [3.0, 31.0, 222.0, 700.0];
    let frf = solve::sweep(&model, &frequencies, &AtomicBool::new(false)).unwrap();
    frf.columns
        .iter()
        .flat_map(|column| column.values.clone())
        .collect()
}

/// Relative to all answers together.
fn difference(one: &[Complex64], other: &[Complex64]) -> f64 {
    let size: f64 = other.iter().map(|answer| answer.norm()).sum();
    let each = one.iter().zip(other);
    each.map(|(a, b)| (a - b).norm()).sum::<f64>() / size
}

/// Expected: the limits. A stiffness far above (below) that of the beam is a rigid (a free) motion, to the ratio of both.
#[test]
fn a_coupling_lies_between_a_rigid_and_a_free_joint() {
    let motions = [
        BeamMotion::W,
        BeamMotion::Psi,
        BeamMotion::WSlope,
        BeamMotion::PsiSlope,
    ];
    let plain = answers(Vec::new());
    for motion in motions {
        let with = |link| answers(vec![joint(1.3, &[(motion, link)])]);
        let stiff = difference(&with(spring(1e17)), &plain);
        assert!(stiff < 1e-8, "{motion:?}: {stiff:e} from rigid");
        let free = with(Link::Free);
        let soft = difference(&with(spring(1e-6)), &free);
        assert!(soft < 1e-8, "{motion:?}: {soft:e} from free");
        assert!(difference(&plain, &free) > 1e-3, "{motion:?}");
    }
    // A stiff hinge: 1e12 N m/rad, far above E I / L of 1e7 N m.
    let hinge = answers(vec![joint(1.3, &[(BeamMotion::WSlope, spring(1e12))])]);
    assert!(difference(&hinge, &plain) < 1e-4);
}

/// Expected: the paper's chain of transfer matrices joins all motions rigidly (Chen & Liu 2022, Eqs. 36 to 47), so it
/// refuses a beam with a joint.
#[test]
fn the_chain_of_the_paper_has_no_joints() {
    let mut model = read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    model.joints = vec![joint(1.3, &[(BeamMotion::WSlope, Link::Free)])];
    let model = Checked::new(model).unwrap();
    let refused = solve::transfer_matrix::sweep(&model, &[30.0], &AtomicBool::new(false));
    assert_eq!(
        refused.map(drop),
        Err(solve::transfer_matrix::NotApplicable::Joints)
    );
}

/// Expected: without warping stiffness a section transmits no bimoment, so a joint of the rate of twist alone has no
/// effect: the same answers as without it.
#[test]
fn without_warping_stiffness_a_joint_of_the_rate_of_twist_has_no_effect() {
    let answers = |joints: Vec<Joint>| {
        let mut model = beam(Support::PINNED, Support::CLAMPED);
        model.beam.section.warping_constant = 0.0;
        model.joints = joints;
        natural_frequencies(&model, 300.0)
    };
    let plain = answers(Vec::new());
    let jointed = answers(vec![joint(1.3, &[(BeamMotion::PsiSlope, Link::Free)])]);
    assert_eq!(plain.len(), jointed.len());
    for frequency in plain {
        assert!(has(&jointed, frequency), "{frequency} Hz in {jointed:?}");
    }
}

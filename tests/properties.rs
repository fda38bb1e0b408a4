//! Properties of every solution, for any model.
//!
//! Expected values: none are stored; each test compares one solution with another, or with a law (reciprocity,
//! superposition, symmetry, passivity) or a closed form.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

#[path = "common/checked.rs"]
mod checked;

use beamtune::model::{
    BeamMotion, Elastic, Force, InnerSupport, MassMotion, MaxwellBranch, Measure, Model, Place,
    Point, Quantity, Response, Restraint, Spring, Subsystem, Support, Supports, Target,
};
use checked::checked;
use common::{
    LENGTH, exists, frequencies, models, models_with_branches, respond, respond_at_points,
    subsystems, targets, unit_force,
};
use num_complex::Complex64;
use proptest::prelude::*;
use std::sync::atomic::AtomicBool;

/// Allowed rounding, relative to the value and to the motions at the force and at the probe.
const TOLERANCE: f64 = 1e-9;

fn beam(x: f64, motion: BeamMotion) -> Target {
    Target::Beam(Place::Position(x), motion)
}

/// Three probes at which any change of a model has an effect.
fn probes() -> [Target; 3] {
    [
        beam(0.3, BeamMotion::W),
        beam(1.7, BeamMotion::Psi),
        beam(2.9, BeamMotion::V),
    ]
}

/// A displacement of a point of the section between the ends.
fn points() -> impl Strategy<Value = (Target, Point)> {
    let motion = prop_oneof![Just(BeamMotion::W), Just(BeamMotion::V)];
    (0.01..LENGTH - 0.01, motion, -0.2..0.2, -0.2..0.2)
        .prop_map(|(x, motion, y, z)| (beam(x, motion), Point { y, z }))
}

/// A load that excites every motion.
fn load() -> Vec<Force> {
    [BeamMotion::W, BeamMotion::Psi, BeamMotion::V]
        .map(|motion| unit_force(beam(0.9, motion)))
        .into()
}

fn assert_same(got: &[Complex64], want: &[Complex64]) {
    let scale = want.iter().map(|z| z.norm()).fold(0.0, f64::max);
    for (got, want) in got.iter().zip(want) {
        let allowed = TOLERANCE * (want.norm() + 0.01 * scale);
        assert!(
            (got - want).norm() <= allowed,
            "{got} and {want}, scale {scale:e}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, rng_seed: prop::test_runner::RngSeed::Fixed(7), failure_persistence: None, ..ProptestConfig::default() })]

    /// Maxwell-Betti: the motion at B under a force at A is that at A under a force at B.
    #[test]
    fn reciprocity(model in models_with_branches(), a in targets(), b in targets(), hertz in frequencies()) {
        prop_assume!(exists(&model, &a) && exists(&model, &b));
        let both = [a.clone(), b.clone()];
        let from_a = respond(&model, vec![unit_force(a)], &both, hertz);
        let from_b = respond(&model, vec![unit_force(b)], &both, hertz);
        let scale = from_a[1].norm() + (from_a[0].norm() * from_b[1].norm()).sqrt();
        prop_assert!((from_a[1] - from_b[0]).norm() <= TOLERANCE * scale, "{} {} {scale:e}", from_a[1], from_b[0]);
    }

    /// Maxwell-Betti at points of the section: the motion of the point B under a force on A is that of A under a force on B.
    #[test]
    fn reciprocity_of_points(model in models(), a in points(), b in points(), hertz in frequencies()) {
        let both = [a.clone(), b.clone()];
        let on = |(target, point): &(Target, Point)| Force { point: *point, ..unit_force(target.clone()) };
        let from_a = respond_at_points(&model, vec![on(&a)], &both, hertz);
        let from_b = respond_at_points(&model, vec![on(&b)], &both, hertz);
        let scale = from_a[1].norm() + (from_a[0].norm() * from_b[1].norm()).sqrt();
        prop_assert!((from_a[1] - from_b[0]).norm() <= TOLERANCE * scale, "{} {} {scale:e}", from_a[1], from_b[0]);
    }

    /// A force on a point of the section is that force on the axis and its torque about it; the point moves by the motion
    /// of the axis and by the twist.
    #[test]
    fn a_point_is_an_arm_about_the_axis(model in models(), at in points(), hertz in frequencies()) {
        let (Target::Beam(place, motion), point) = at.clone() else { unreachable!("points are on the beam") };
        let arm = if motion == BeamMotion::W { point.z } else { -point.y };
        let twist = Target::Beam(place, BeamMotion::Psi);
        let torque = Force { amplitude: arm, ..unit_force(twist.clone()) };
        let on_axis = respond(&model, vec![unit_force(at.0.clone()), torque], &probes(), hertz);
        let on_point = Force { point, ..unit_force(at.0.clone()) };
        assert_same(&respond(&model, vec![on_point], &probes(), hertz), &on_axis);
        let parts = respond(&model, load(), &[at.0.clone(), twist], hertz);
        let whole = respond_at_points(&model, load(), &[at], hertz)[0];
        let sum = parts[0] + arm * parts[1];
        prop_assert!((whole - sum).norm() <= TOLERANCE * (parts[0].norm() + (arm * parts[1]).norm()));
    }

    /// A spring to the ground that is much stiffer than the beam holds like a fixed motion, and one that is much softer
    /// like none.
    #[test]
    fn a_spring_is_between_fixed_and_free(model in models(), x in 0.5..1.2, motion in prop::sample::select(BeamMotion::ALL.to_vec()), hertz in frequencies()) {
        prop_assume!(motion != BeamMotion::PsiSlope || model.beam.section.warping_constant > 0.0);
        prop_assume!(model.supports.inner.is_empty());
        let held = |restraint: Restraint| {
            let mut model = model.clone();
            let mut support = Support { point: Point { y: 0.03, z: -0.05 }, ..Support::FREE };
            support[motion] = restraint;
            model.supports.inner = vec![InnerSupport { name: "held".into(), position: x, support }];
            respond(&model, load(), &probes(), hertz)
        };
        let spring = |stiffness| Restraint::Elastic(Elastic { spring: Spring { stiffness, ..Spring::default() }, ..Elastic::default() });
        let near = |got: Vec<Complex64>, want: Vec<Complex64>| {
            let scale = want.iter().map(|z| z.norm()).fold(0.0, f64::max);
            got.iter().zip(&want).all(|(got, want)| (got - want).norm() <= 1e-6 * scale)
        };
        prop_assert!(near(held(spring(1e18)), held(Restraint::Fixed)));
        prop_assert!(near(held(spring(1e-6)), respond(&model, load(), &probes(), hertz)));
    }

    /// Superposition: two forces with phases give the weighted sum of their responses.
    #[test]
    fn linearity(model in models(), a in targets(), b in targets(), phase in -180.0..180.0, hertz in frequencies()) {
        prop_assume!(exists(&model, &a) && exists(&model, &b));
        let both = [Force { amplitude: 2.5, ..unit_force(a.clone()) }, Force { phase, ..unit_force(b.clone()) }];
        let together = respond(&model, both.into(), &probes(), hertz);
        let first = respond(&model, vec![unit_force(a)], &probes(), hertz);
        let second = respond(&model, vec![unit_force(b)], &probes(), hertz);
        let turn = Complex64::from_polar(1.0, phase.to_radians());
        let sum: Vec<_> = first.iter().zip(&second).map(|(first, second)| 2.5 * first + turn * second).collect();
        let scale = first.iter().chain(&second).map(|z| z.norm()).fold(0.0, f64::max);
        for (together, sum) in together.iter().zip(&sum) {
            prop_assert!((together - sum).norm() <= TOLERANCE * (sum.norm() + scale));
        }
    }

    /// Seen from the other end, the model is the same.
    #[test]
    fn mirror_image(model in models(), hertz in frequencies()) {
        let mut mirrored = model.clone();
        std::mem::swap(&mut mirrored.supports.left, &mut mirrored.supports.right);
        for subsystem in &mut mirrored.subsystems {
            subsystem.position = LENGTH - subsystem.position;
        }
        for inner in &mut mirrored.supports.inner {
            inner.position = LENGTH - inner.position;
        }
        for joint in &mut mirrored.joints {
            joint.position = LENGTH - joint.position;
        }
        let turn = |target: &Target| match target {
            Target::Beam(Place::Position(x), motion) => beam(LENGTH - x, *motion),
            other => other.clone(),
        };
        let forces = load().iter().map(|force| Force { target: turn(&force.target), ..force.clone() }).collect();
        let got = respond(&mirrored, forces, &probes().each_ref().map(turn), hertz);
        assert_same(&got, &respond(&model, load(), &probes(), hertz));
    }

    /// A subsystem is equivalent to two halves of it at its position.
    #[test]
    fn a_station_split_in_two(model in models(), whole in subsystems(), hertz in frequencies()) {
        let half = |spring: Spring| Spring {
            stiffness: 0.5 * spring.stiffness,
            damping: 0.5 * spring.damping,
            maxwell: spring.maxwell.iter().map(|of| MaxwellBranch { stiffness: 0.5 * of.stiffness, damping: 0.5 * of.damping }).collect(),
            ..spring
        };
        let part = |name: &str| Subsystem {
            name: name.into(),
            mass: 0.5 * whole.mass,
            inertia: 0.5 * whole.inertia,
            y_left: half(whole.y_left.clone()),
            y_right: half(whole.y_right.clone()),
            z_left: half(whole.z_left.clone()),
            z_right: half(whole.z_right.clone()),
            ..whole.clone()
        };
        let mut one = model.clone();
        one.subsystems.push(Subsystem { name: "whole".into(), ..whole.clone() });
        let mut two = model;
        two.subsystems.extend([part("half"), part("other half")]);
        assert_same(&respond(&two, load(), &probes(), hertz), &respond(&one, load(), &probes(), hertz));
    }

    /// Additional responses do not change the others, and neither does the order of the subsystems in the file.
    #[test]
    fn a_probe_added_and_subsystems_in_another_order(model in models_with_branches(), x in 0.0..LENGTH, hertz in frequencies()) {
        let plain = respond(&model, load(), &probes(), hertz);
        let more = [&probes()[..], &[beam(x, BeamMotion::WSlope)]].concat();
        assert_same(&respond(&model, load(), &more, hertz)[..3], &plain);
        let mut reversed = model.clone();
        reversed.subsystems.reverse();
        assert_same(&respond(&reversed, load(), &probes(), hertz), &plain);
    }

    /// With equal arms and equal z springs a force along w leaves v exactly at zero.
    #[test]
    fn symmetric_arms_leave_v_exactly_zero(model in models(), hertz in frequencies()) {
        let mut model = model;
        model.beam.section.product_moment = 0.0;
        model.beam.section.centroid_offset_y = 0.0;
        for inner in &mut model.supports.inner {
            inner.support.point.y = 0.0;
        }
        model.supports.left.point.y = 0.0;
        model.supports.right.point.y = 0.0;
        for subsystem in &mut model.subsystems {
            subsystem.arm_right = subsystem.arm_left;
            subsystem.z_right = subsystem.z_left.clone();
        }
        let targets = [0.0, 0.9, 1.7, LENGTH].map(|x| beam(x, BeamMotion::V));
        for v in respond(&model, vec![unit_force(beam(0.9, BeamMotion::W))], &targets, hertz) {
            prop_assert_eq!(v, Complex64::ZERO);
        }
    }

    /// A damped model takes power from a force; it never gives any: Re(i omega q) >= 0 at the force.
    #[test]
    fn passivity(model in models_with_branches(), at in targets(), hertz in frequencies()) {
        prop_assume!(exists(&model, &at));
        let moved = respond(&model, vec![unit_force(at.clone())], std::slice::from_ref(&at), hertz)[0];
        prop_assert!(-moved.im >= -1e-12 * moved.norm(), "{moved}");
    }

    /// The bare beam's receptances with the subsystems coupled to them by one dense 3N x 3N system.
    #[test]
    fn dense_receptance_coupling(model in models_with_branches(), hertz in frequencies()) {
        prop_assume!(!model.subsystems.is_empty());
        let coupled = dense_coupling(&model, hertz);
        let solved = respond(&model, load(), &probes(), hertz);
        let scale = solved.iter().map(|z| z.norm()).fold(0.0, f64::max);
        for (coupled, solved) in coupled.iter().zip(&solved) {
            prop_assert!((coupled - solved).norm() <= 1e-7 * (solved.norm() + 0.01 * scale), "{coupled} {solved}");
        }
    }
}

/// K + i omega C - omega^2 M of a subsystem over (y, z, theta | w, psi, v), its mass eliminated: the 3x3 stiffness that
/// acts on the beam (METHOD: dynamic condensation, Chen & Liu 2022, Section 2.1, from the elongations of the springs).
fn condensed(subsystem: &Subsystem, omega: f64) -> nalgebra::Matrix3<Complex64> {
    let s = subsystem;
    // Elongation of each spring over (y, z, theta, w, psi, v).
    let springs = [
        (s.y_left.clone(), [-1.0, 0.0, 0.0, 1.0, s.mount_z, 0.0]),
        (s.y_right.clone(), [-1.0, 0.0, 0.0, 1.0, s.mount_z, 0.0]),
        (
            s.z_left.clone(),
            [0.0, -1.0, s.arm_left, 0.0, -s.mount_y, 1.0],
        ),
        (
            s.z_right.clone(),
            [0.0, -1.0, -s.arm_right, 0.0, s.mount_y, 1.0],
        ),
    ];
    let mut k = nalgebra::Matrix6::<Complex64>::zeros();
    for (spring, stretch) in springs {
        let stretch = nalgebra::Vector6::from(stretch).map(Complex64::from);
        let of_branch = |of: &MaxwellBranch| {
            let damper = Complex64::new(0.0, omega * of.damping);
            (damper.inv() + 1.0 / of.stiffness).inv()
        };
        let own = Complex64::new(
            spring.stiffness,
            spring.stiffness * spring.loss_factor + omega * spring.damping,
        );
        let dynamic = own + spring.maxwell.iter().map(of_branch).sum::<Complex64>();
        k += stretch * stretch.transpose() * dynamic;
    }
    for (row, inertia) in [s.mass, s.mass, s.inertia].into_iter().enumerate() {
        k[(row, row)] -= omega * omega * inertia;
    }
    let (mm, mb) = (k.fixed_view::<3, 3>(0, 0), k.fixed_view::<3, 3>(0, 3));
    let eliminated = mm
        .into_owned()
        .lu()
        .solve(&mb.into_owned())
        .expect("a damped mass");
    k.fixed_view::<3, 3>(3, 3) - mb.transpose() * eliminated
}

/// The response at the probes: `alpha_pF - alpha_ps K (I + alpha_ss K)^-1 alpha_sF`.
fn dense_coupling(model: &Model, hertz: f64) -> Vec<Complex64> {
    const MOTIONS: [BeamMotion; 3] = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V];
    let omega = std::f64::consts::TAU * hertz;
    let bare = Model {
        subsystems: Vec::new(),
        ..model.clone()
    };
    let stations: Vec<Target> = model
        .subsystems
        .iter()
        .flat_map(|s| MOTIONS.map(|motion| beam(s.position, motion)))
        .collect();
    let all = [&probes()[..], &stations].concat();
    let size = stations.len();
    let free = nalgebra::DVector::from_vec(respond(&bare, load(), &all, hertz));
    let mut alpha = nalgebra::DMatrix::<Complex64>::zeros(3 + size, size);
    for (column, station) in stations.iter().enumerate() {
        alpha.set_column(
            column,
            &nalgebra::DVector::from_vec(respond(
                &bare,
                vec![unit_force(station.clone())],
                &all,
                hertz,
            )),
        );
    }
    let mut k = nalgebra::DMatrix::<Complex64>::zeros(size, size);
    for (index, subsystem) in model.subsystems.iter().enumerate() {
        k.view_mut((3 * index, 3 * index), (3, 3))
            .copy_from(&condensed(subsystem, omega));
    }
    let at_stations = nalgebra::DMatrix::identity(size, size) + alpha.rows(3, size) * &k;
    let moved = at_stations
        .lu()
        .solve(&free.rows(3, size).into_owned())
        .expect("a damped model");
    let probed = free.rows(0, 3) - alpha.rows(0, 3) * (k * moved);
    probed.iter().copied().collect()
}

/// A cantilever without offset, of the paper's section and without damping.
fn cantilever() -> Model {
    let text = beamtune::presets::find("symmetric_section").unwrap().text;
    let mut model = beamtune::model::read(text).unwrap().into_inner();
    model.beam.material.loss_factor = 0.0;
    model.supports = Supports {
        left: Support::CLAMPED,
        right: Support::FREE,
        inner: Vec::new(),
    };
    model.subsystems.clear();
    model.studies.clear();
    model.tune = None;
    model
}

/// Expected: closed forms of statics, `F L^3 / 3 E I` at the tip and its slope `F L^2 / 2 E I`; the dynamic part is of
/// the order `(f / f1)^2`, 1e-8 at 0.001 Hz.
#[test]
fn static_limit_of_a_cantilever() {
    let model = cantilever();
    let (length, e) = (model.beam.length, model.beam.material.young_modulus);
    let inertia = model.beam.section.second_moment_y;
    let tip = |motion| Target::Beam(Place::Right, motion);
    let moved = respond(
        &model,
        vec![unit_force(tip(BeamMotion::W))],
        &[tip(BeamMotion::W), tip(BeamMotion::WSlope)],
        1e-3,
    );
    let (deflection, slope) = (
        length.powi(3) / (3.0 * e * inertia),
        length.powi(2) / (2.0 * e * inertia),
    );
    assert!(
        (moved[0].re / deflection - 1.0).abs() < 1e-7,
        "{} {deflection}",
        moved[0]
    );
    assert!(
        (moved[1].re / slope - 1.0).abs() < 1e-7,
        "{} {slope}",
        moved[1]
    );
}

/// Expected: closed form of Saint-Venant torsion without warping, T L / G J at the tip.
#[test]
fn static_limit_of_torsion_without_warping() {
    let mut model = cantilever();
    model.beam.section.warping_constant = 0.0;
    let (material, section) = (model.beam.material, model.beam.section);
    let tip = Target::Beam(Place::Right, BeamMotion::Psi);
    let twist = respond(&model, vec![unit_force(tip.clone())], &[tip], 1e-3)[0];
    let expected = model.beam.length / (material.shear_modulus * section.torsion_constant);
    assert!(
        (twist.re / expected - 1.0).abs() < 1e-6,
        "{twist} {expected}"
    );
}

/// Expected: Saint-Venant is the limit of a vanishing warping constant. The boundary layer at the clamped end has the
/// length `sqrt(E Gamma_0 / G J)` (closed form), so a warping constant 1e-4 times as large differs 1e-2 times as much.
#[test]
fn no_warping_is_the_limit_of_little_warping() {
    let with = |warping_constant| {
        let mut model = cantilever();
        model.beam.section.centroid_offset = 0.05;
        model.beam.section.warping_constant = warping_constant;
        model
    };
    for hertz in [0.5, 20.0, 300.0, 5000.0] {
        let force = || {
            vec![
                unit_force(beam(1.0, BeamMotion::Psi)),
                unit_force(beam(2.2, BeamMotion::W)),
            ]
        };
        let twist = |warping| respond(&with(warping), force(), &probes()[1..2], hertz)[0];
        let limit = twist(0.0);
        let [little, less] =
            [1e-18, 1e-22].map(|warping| (twist(warping) - limit).norm() / limit.norm());
        assert!(little < 1e-2, "{hertz} Hz: {little:e}");
        assert!(
            less < 0.0101 * little + 1e-11,
            "{hertz} Hz: {little:e} {less:e}"
        );
    }
}

/// A mass without damping, driven at its own resonance on the blocked beam: the beam is at rest there.
#[test]
fn an_undamped_absorber_holds_its_station_still() {
    let mut model = cantilever();
    let hertz: f64 = 37.0;
    let omega = std::f64::consts::TAU * hertz;
    let spring = Spring {
        stiffness: 0.5 * 20.0 * omega * omega,
        ..Spring::default()
    };
    model.subsystems = vec![Subsystem {
        name: "S1".into(),
        enabled: true,
        position: 2.0,
        mass: 20.0,
        inertia: 1.0,
        y_left: spring.clone(),
        y_right: spring,
        z_left: Spring::default(),
        z_right: Spring::default(),
        arm_left: 0.1,
        arm_right: 0.1,
        mount_y: 0.1,
        mount_z: 0.0,
    }];
    let at = |x| beam(x, BeamMotion::W);
    let moved = respond(
        &model,
        vec![unit_force(at(3.0))],
        &[at(2.0), at(3.0)],
        hertz,
    );
    assert!(moved[0].norm() < 1e-12 * moved[1].norm(), "{moved:?}");
    assert!(moved[1].is_finite() && moved[1].norm() > 0.0);
}

/// Expected: closed form. A mass without inertia on the clamped end, which Maxwell branches alone hold: a moment M on it
/// turns it by `M (1 / k_b + 1 / (i omega c_b)) / (a_l^2 + a_r^2)`, with equal arms without moving it.
#[test]
fn a_branch_alone_resists_theta() {
    let branch = MaxwellBranch {
        stiffness: 3e5,
        damping: 200.0,
    };
    let spring = Spring {
        maxwell: vec![branch],
        ..Spring::default()
    };
    let mut model = cantilever();
    model.subsystems = vec![Subsystem {
        name: "M".into(),
        enabled: true,
        position: 0.0,
        mass: 10.0,
        inertia: 0.0,
        y_left: spring.clone(),
        y_right: spring.clone(),
        z_left: spring.clone(),
        z_right: spring,
        arm_left: 0.2,
        arm_right: 0.2,
        mount_y: 0.1,
        mount_z: 0.0,
    }];
    let theta = Target::Mass("M".into(), MassMotion::Theta);
    let hertz = 40.0;
    let turned = respond(&model, vec![unit_force(theta.clone())], &[theta], hertz)[0];
    let omega = std::f64::consts::TAU * hertz;
    let flexibility = 1.0 / branch.stiffness + 1.0 / Complex64::new(0.0, omega * branch.damping);
    let expected = flexibility / (2.0 * 0.2 * 0.2);
    assert!(
        (turned - expected).norm() < 1e-12 * expected.norm(),
        "{turned} {expected}"
    );
}

/// Expected: closed form of the pinned beam's natural frequencies, (n pi / L)^2 sqrt(E I / rho A) / 2 pi. Without
/// damping there is no finite response at them, and one at a relative distance of 10^-9.
#[test]
fn an_undamped_beam_at_its_resonance_has_no_finite_answer() {
    let mut model = cantilever();
    model.supports = Supports {
        left: Support::PINNED,
        right: Support::PINNED,
        inner: Vec::new(),
    };
    model.forces = vec![unit_force(beam(0.7, BeamMotion::W))];
    model.responses = vec![Response {
        name: "w".into(),
        enabled: true,
        quantity: Quantity::Motion(beam(1.1, BeamMotion::W), Measure::Displacement),
        point: beamtune::model::Point::AXIS,
        over: None,
    }];
    let (material, section) = (model.beam.material, model.beam.section);
    let wave_speed = (material.young_modulus * section.second_moment_y
        / (material.density * section.area))
        .sqrt();
    for n in 1..=5 {
        let wave_number = f64::from(n) * std::f64::consts::PI / model.beam.length;
        let hertz = wave_number.powi(2) * wave_speed / std::f64::consts::TAU;
        let frequencies = [hertz * (1.0 - 1e-9), hertz, hertz * (1.0 + 1e-9)];
        let frf = beamtune::solve::sweep(&checked(&model), &frequencies, &AtomicBool::new(false))
            .unwrap();
        assert_eq!(
            frf.singular(),
            [hertz],
            "mode {n}: {:?}",
            frf.columns[0].values
        );
    }
}

/// A fixed motion is exactly zero, and a force on it moves nothing.
#[test]
fn what_is_fixed_does_not_move() {
    let model = cantilever();
    let root = |motion| Target::Beam(Place::Left, motion);
    let held = respond(&model, load(), &BeamMotion::ALL.map(root), 30.0);
    assert!(held.iter().all(|q| *q == Complex64::ZERO), "{held:?}");
    let moved = respond(
        &model,
        vec![unit_force(root(BeamMotion::W))],
        &probes(),
        30.0,
    );
    assert!(moved.iter().all(|q| *q == Complex64::ZERO), "{moved:?}");
}

/// Expected: the energy of a rigid-like motion in closed form. A beam on soft end springs far below its first bending
/// resonance moves as one: `E_V = rho A L |w|^2`.
#[test]
fn energy_of_a_beam_that_moves_as_one() {
    let mut model = cantilever();
    let soft = Restraint::Elastic(beamtune::model::Elastic {
        spring: beamtune::model::Spring {
            stiffness: 10.0,
            ..beamtune::model::Spring::default()
        },
        ..Default::default()
    });
    let mut end = Support::FREE;
    end[BeamMotion::W] = soft;
    model.supports = Supports {
        left: end.clone(),
        right: end,
        inner: Vec::new(),
    };
    model.forces = vec![unit_force(beam(0.5 * model.beam.length, BeamMotion::W))];
    model.responses = vec![
        Response {
            name: "E_V".into(),
            enabled: true,
            quantity: Quantity::Energy,
            point: beamtune::model::Point::AXIS,
            over: None,
        },
        Response {
            name: "w".into(),
            enabled: true,
            quantity: Quantity::Motion(
                beam(0.5 * model.beam.length, BeamMotion::W),
                Measure::Displacement,
            ),
            point: beamtune::model::Point::AXIS,
            over: None,
        },
    ];
    let frf = beamtune::solve::sweep(&checked(&model), &[0.05], &AtomicBool::new(false)).unwrap();
    let moved = frf.columns[1].values[0].norm_sqr();
    let mass = model.beam.material.density * model.beam.section.area * model.beam.length;
    let ratio = frf.columns[0].values[0].re / (mass * moved);
    assert!((ratio - 1.0).abs() < 1e-5, "{ratio}");
}

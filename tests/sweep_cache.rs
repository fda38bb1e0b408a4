//! The sweep cache between edits: the same results as a fresh solution.
//!
//! Expected: the fresh solution of the same model, which other tests check (literature, high precision). Differences
//! are shares of the response's largest value: near an anti-resonance, both have fewer correct digits.

#![allow(clippy::unwrap_used)]

#[path = "common/checked.rs"]
mod checked;
#[allow(dead_code)]
#[path = "common/quantities.rs"]
mod quantities;

use checked::checked;
use std::sync::atomic::AtomicBool;

use beamtune::model::{
    BeamMotion, Elastic, Force, InnerSupport, Joint, Link, MassMotion, Measure, Model, Place,
    Point, Quantity, Response, Restraint, Span, Spring, SpringMeasure, SpringName, Support, Target,
    read,
};
use beamtune::presets;
use beamtune::solve::{Cancelled, Column, ColumnKind, Frf, SweepCache, sweep};

#[path = "sweep_cache/energy.rs"]
mod energy;

static NEVER: AtomicBool = AtomicBool::new(false);

/// A beam with many light subsystems, loads and responses of all kinds, and a support on both sides of its middle.
fn crowded(count: usize) -> Model {
    let mut model = read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    let pattern = model.subsystems[0].clone();
    let share = 3.0 / count as f64;
    model.subsystems = (1..=count)
        .map(|index| {
            let mut subsystem = pattern.clone();
            subsystem.name = format!("S{index}");
            subsystem.position = model.beam.length * index as f64 / (count + 1) as f64;
            subsystem.mass *= share;
            subsystem.inertia *= share;
            subsystem
        })
        .collect();
    for (index, motion) in [
        (3, MassMotion::Y),
        (count - 2, MassMotion::Theta),
        (count - 3, MassMotion::Z),
    ] {
        let target = Target::Mass(format!("S{index}"), motion);
        model.responses.push(response(&model, target.clone()));
        model.forces.push(force(target));
    }
    for (at, motion) in [
        (0.7, BeamMotion::WSlope),
        (2.9, BeamMotion::PsiSlope),
        (1.6, BeamMotion::VSlope),
    ] {
        let target = Target::Beam(Place::Position(at), motion);
        model.responses.push(response(&model, target.clone()));
        model.forces.push(force(target));
    }
    for (name, position) in [("B1", 0.55), ("B2", 2.65)] {
        let mut support = Support::FREE;
        support[BeamMotion::W] = Restraint::Fixed;
        support[BeamMotion::V] = Restraint::Elastic(Elastic {
            spring: Spring {
                stiffness: 1e7,
                loss_factor: 0.1,
                ..Spring::default()
            },
            ..Elastic::default()
        });
        support[BeamMotion::VSlope] = support[BeamMotion::V].clone();
        support.point = Point { y: 0.05, z: -0.1 };
        model.supports.inner.push(InnerSupport {
            name: name.to_owned(),
            position,
            support,
        });
    }
    let mut all = quantities::reactions(&model);
    let places = [0.1, 0.55, 1.6, 2.9].map(Place::Position);
    all.extend(quantities::internal_forces(&places));
    for index in [2, 5, count - 1] {
        for measure in SpringMeasure::ALL {
            let name = format!("S{index}");
            all.push(Quantity::Spring(name, SpringName::ZRight, measure));
        }
    }
    model
        .responses
        .extend(all.into_iter().map(quantities::response));
    model
}

fn response(model: &Model, target: Target) -> Response {
    Response {
        name: format!("R{}", model.responses.len()),
        enabled: true,
        quantity: Quantity::Motion(target, Measure::Velocity),
        point: beamtune::model::Point::AXIS,
        over: None,
    }
}

fn force(target: Target) -> Force {
    Force {
        enabled: true,
        target,
        amplitude: 0.5,
        phase: 40.0,
        point: beamtune::model::Point::AXIS,
    }
}

fn grid() -> Vec<f64> {
    (0..61).map(|k| 20.0 + 6.1 * f64::from(k)).collect()
}

fn assert_same(found: &Frf, fresh: &Frf) {
    assert_eq!(found.frequencies, fresh.frequencies);
    let top_of = |column: &Column| {
        let sizes = column.values.iter().map(|value| value.norm());
        sizes.fold(0.0, f64::max)
    };
    // A force is a sum of the terms of the others, so it has their rounding.
    let is_force =
        |column: &Column| column.name.starts_with(['R', 'I']) && column.name.contains('(');
    let forces = fresh.columns.iter().filter(|column| is_force(column));
    let force = forces.map(top_of).fold(0.0, f64::max);
    for (a, b) in found.columns.iter().zip(&fresh.columns) {
        let top = if is_force(b) { force } else { top_of(b) };
        assert!(top.is_finite(), "{}", b.name);
        for (a_value, b_value) in a.values.iter().zip(&b.values) {
            let distance = (a_value - b_value).norm();
            // An energy is never close to 0.
            let of = if a.kind == ColumnKind::Energy {
                b_value.norm()
            } else {
                top
            };
            assert!(distance <= 3e-12 * of, "{}: {a_value} {b_value}", b.name);
        }
    }
}

type Edit = Box<dyn Fn(&mut Model)>;

/// An edit of each kind, in the middle of the beam or at one of its ends.
fn edits() -> Vec<(&'static str, Edit)> {
    let move_probe = |model: &mut Model| {
        for response in &mut model.responses {
            if let Quantity::Motion(Target::Beam(Place::Position(x), _), _) = &mut response.quantity
                && (*x - 1.2).abs() < 0.05
            {
                *x += 1e-3;
            }
        }
    };
    let turn_probe = |model: &mut Model| {
        for response in &mut model.responses {
            if let Quantity::Motion(Target::Beam(Place::Position(x), motion), _) =
                &mut response.quantity
                && *x == 2.0
                && *motion == BeamMotion::W
            {
                *motion = BeamMotion::WSlope;
            }
        }
    };
    vec![
        ("a mass", Box::new(|m| m.subsystems[19].mass *= 1.1)),
        ("an arm", Box::new(|m| m.subsystems[19].arm_left *= 1.1)),
        (
            "a position",
            Box::new(|m| m.subsystems[19].position += 1e-3),
        ),
        (
            "past another",
            Box::new(|m| m.subsystems[19].position += 0.2),
        ),
        ("off", Box::new(|m| m.subsystems[19].enabled ^= true)),
        ("removed", Box::new(|m| drop(m.subsystems.remove(24)))),
        ("the first", Box::new(|m| m.subsystems[0].mount_y *= 0.9)),
        (
            "the last",
            Box::new(|m| m.subsystems.last_mut().unwrap().z_left.damping *= 2.0),
        ),
        ("an amplitude", Box::new(|m| m.forces[0].amplitude *= 1.1)),
        ("a phase on a mass", Box::new(|m| m.forces[4].phase += 10.0)),
        ("a load off", Box::new(|m| m.forces[7].enabled ^= true)),
        ("a probe", Box::new(move_probe)),
        ("another motion", Box::new(turn_probe)),
        (
            "a response off",
            Box::new(|m| m.responses[3].enabled ^= true),
        ),
        (
            "left support",
            Box::new(|m| m.supports.left[BeamMotion::Psi] = Restraint::Fixed),
        ),
        (
            "right support",
            Box::new(|m| m.supports.right = Support::CLAMPED),
        ),
        (
            "inner support",
            Box::new(|m| m.supports.inner[0].support[BeamMotion::Psi] = Restraint::Fixed),
        ),
        (
            "an inner support's place",
            Box::new(|m| m.supports.inner[1].position += 0.01),
        ),
        ("length", Box::new(|m| m.beam.length *= 1.01)),
        (
            "modulus",
            Box::new(|m| m.beam.material.young_modulus *= 1.01),
        ),
    ]
}

/// The cache after a model and two more edits of it; each result is that of a fresh solution.
fn edited(mut model: Model, frequencies: &[f64], edit: impl Fn(&mut Model)) -> SweepCache {
    let mut kept = SweepCache::default();
    for _ in 0..3 {
        let fresh = sweep(&checked(&model), frequencies, &NEVER).unwrap();
        let found = kept.sweep(&checked(&model), frequencies, &NEVER).unwrap();
        assert_same(&found, &fresh);
        edit(&mut model);
    }
    kept
}

#[test]
fn edits_of_every_kind_are_solved_as_afresh() {
    for (name, edit) in edits() {
        let kept = edited(crowded(40), &grid(), edit);
        // Another material changes the whole beam.
        assert_eq!(kept.bytes() > 0, name != "modulus", "{name}");
    }
}

#[test]
fn edits_one_after_the_other_are_solved_as_afresh() {
    let mut random = fastrand::Rng::with_seed(5);
    let mut model = crowded(40);
    let mut kept = SweepCache::default();
    let edits = edits();
    for _ in 0..60 {
        if random.u8(0..3) > 0 {
            edits[random.usize(0..edits.len() - 2)].1(&mut model);
        } else {
            let index = random.usize(0..model.subsystems.len());
            model.subsystems[index].mass *= 0.99;
        }
        if model.subsystems.len() < 30 {
            model = crowded(40);
        }
        let fresh = sweep(&checked(&model), &grid(), &NEVER).unwrap();
        assert_same(
            &kept.sweep(&checked(&model), &grid(), &NEVER).unwrap(),
            &fresh,
        );
    }
}

/// The same beam in spans of different sections, materials and offsets.
fn in_spans(mut model: Model) -> Model {
    let whole = model.beam;
    for (length, factor, z) in [(1.13, 1.0, 0.0), (0.92, 0.6, 0.05), (1.15, 1.4, -0.03)] {
        let mut section = whole.section;
        section.area *= factor;
        section.second_moment_y *= factor;
        section.warping_constant *= factor;
        let mut material = whole.material;
        material.density /= factor;
        model.spans.push(Span {
            length,
            offset: Point { y: 0.0, z },
            section: Some(section),
            material: Some(material),
            ..Span::default()
        });
    }
    model.beam.length = 0.0;
    model
}

/// The ends of the spans are on both sides of the middle; edits may change a span, too.
#[test]
fn edits_among_spans_are_solved_as_afresh() {
    let section: Edit = Box::new(|m| {
        let section = m.spans[1].section.as_mut().unwrap();
        section.torsion_constant *= 1.1;
    });
    let length: Edit = Box::new(|m| m.spans[2].length += 0.01);
    let of_spans = [("a section", section), ("a span's length", length)];
    for (name, edit) in edits().into_iter().chain(of_spans) {
        if name == "length" {
            continue;
        }
        let kept = edited(energy::with_energy(in_spans(crowded(40))), &grid(), edit);
        // The spans have materials of their own, so that one edit changes nothing.
        assert_eq!(kept.bytes() > 0, name != "modulus", "{name}");
    }
}

/// Joints on both sides of the middle, whose waves a cached side carries over them, and between two edits that change one.
#[test]
fn edits_next_to_joints_are_solved_as_afresh() {
    let with_joints = || {
        let mut model = crowded(40);
        for position in [0.37, 1.91, 2.83] {
            let mut joint = Joint {
                position,
                ..Joint::default()
            };
            joint[BeamMotion::WSlope] = Link::Free;
            joint[BeamMotion::V] = Link::Elastic(Spring {
                stiffness: 3e7,
                damping: 400.0,
                loss_factor: 0.05,
                ..Spring::default()
            });
            model.joints.push(joint);
        }
        model
    };
    let coupling: Edit = Box::new(|m| m.joints[1][BeamMotion::Psi] = Link::Free);
    let place: Edit = Box::new(|m| m.joints[2].position += 1e-3);
    let of_joints = [("coupling", coupling), ("a joint's place", place)];
    for (_, edit) in edits().into_iter().chain(of_joints) {
        edited(with_joints(), &grid(), edit);
    }
}

/// A section without warping stiffness, which carries no bimoment.
fn without_warping_stiffness(model: &mut Model) {
    model.beam.section.warping_constant = 0.0;
    let bimoment = |force: &Force| matches!(force.target, Target::Beam(_, BeamMotion::PsiSlope));
    model.forces.retain(|force| !bimoment(force));
}

/// The same; its rate of twist is evaluated where it does not jump.
fn without_warping(model: &mut Model) {
    without_warping_stiffness(model);
    for response in &mut model.responses {
        if let Quantity::Motion(Target::Beam(place, BeamMotion::PsiSlope), _) =
            &mut response.quantity
        {
            *place = Place::Position(2.83);
        }
    }
}

#[test]
fn without_warping_stiffness_edits_are_solved_as_afresh() {
    let mut model = crowded(40);
    without_warping(&mut model);
    let kept = edited(model, &grid(), |m| m.subsystems[19].mass *= 1.1);
    assert!(kept.bytes() > 0);
}

#[test]
fn edits_under_a_ratio_are_solved_as_afresh() {
    let mut model = crowded(40);
    let names: Vec<String> = model.responses.iter().map(|of| of.name.clone()).collect();
    for (index, of) in model.responses.iter_mut().enumerate().skip(20) {
        of.over = Some(names[index % 3].clone());
    }
    let kept = edited(model, &grid(), |m| m.subsystems[19].mass *= 1.1);
    assert!(kept.bytes() > 0);
}

/// It is the mean of both sides of a torque, which are read at two stations.
#[test]
fn a_rate_of_twist_at_a_torque_is_solved_as_afresh() {
    let mut model = crowded(40);
    without_warping_stiffness(&mut model);
    model.subsystems[19].position = 2.9;
    let kept = edited(model, &grid(), |m| m.subsystems[19].mass *= 1.1);
    assert!(kept.bytes() > 0);
}

#[test]
fn an_expected_edit_finds_everything_there() {
    let model = crowded(40);
    let mut edited = model.clone();
    edited.subsystems[30].mass *= 1.1;
    let mut kept = SweepCache::default();
    kept.expect(&checked(&model), &checked(&edited), &grid(), &NEVER)
        .unwrap();
    let bytes = kept.bytes();
    assert!(bytes > 0);
    let fresh = sweep(&checked(&edited), &grid(), &NEVER).unwrap();
    assert_same(
        &kept.sweep(&checked(&edited), &grid(), &NEVER).unwrap(),
        &fresh,
    );
    assert_eq!(kept.bytes(), bytes);
}

#[test]
fn a_cancelled_sweep_gives_nothing_and_spoils_nothing() {
    let cancelled = AtomicBool::new(true);
    let mut model = crowded(40);
    let mut kept = SweepCache::default();
    assert!(kept.sweep(&checked(&model), &grid(), &NEVER).is_ok());
    model.subsystems[10].mass *= 1.1;
    assert_eq!(
        kept.sweep(&checked(&model), &grid(), &cancelled),
        Err(Cancelled)
    );
    let fresh = sweep(&checked(&model), &grid(), &NEVER).unwrap();
    assert_same(
        &kept.sweep(&checked(&model), &grid(), &NEVER).unwrap(),
        &fresh,
    );
}

#[test]
fn nothing_is_kept_of_a_small_model() {
    let mut model = read(presets::find("fig06").unwrap().text)
        .unwrap()
        .into_inner();
    let mut kept = SweepCache::default();
    for _ in 0..2 {
        model.forces[0].amplitude *= 2.0;
        let fresh = sweep(&checked(&model), &grid(), &NEVER).unwrap();
        assert_same(
            &kept.sweep(&checked(&model), &grid(), &NEVER).unwrap(),
            &fresh,
        );
    }
    assert_eq!(kept.bytes(), 0);
}

#[test]
fn the_cache_next_to_an_edit_serves_edits_of_the_same_position_only() {
    let model = crowded(60);
    let edited = |number: usize, factor: f64| {
        let mut model = model.clone();
        model.subsystems[number].mass *= factor;
        model
    };
    let mut kept = SweepCache::default();
    kept.expect(
        &checked(&model),
        &checked(&edited(30, 1.1)),
        &grid(),
        &NEVER,
    )
    .unwrap();
    for (other, there) in [
        (edited(30, 1.3), true),
        (model.clone(), true),
        (edited(31, 1.1), false),
        (edited(2, 1.1), false),
    ] {
        assert_eq!(
            SweepCache::would_serve(
                &checked(&model),
                &checked(&edited(30, 1.1)),
                &checked(&other)
            ),
            there
        );
        let recalled = kept.recalled(&checked(&other), &grid(), &NEVER).unwrap();
        assert_eq!(recalled.is_some(), there);
        if let Some(found) = recalled {
            assert_same(&found, &sweep(&checked(&other), &grid(), &NEVER).unwrap());
        }
    }
    // The cache has no entries for other frequencies.
    assert_eq!(
        kept.recalled(&checked(&model), &grid()[1..], &NEVER),
        Ok(None)
    );
}

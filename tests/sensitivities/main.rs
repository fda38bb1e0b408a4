//! Derivatives of responses, compared with differences of the solver, closed forms and scaling laws.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "../common/checked.rs"]
mod checked;
mod closed;
#[allow(dead_code)]
#[path = "../common/mod.rs"]
mod common;
mod difference;
mod extrema;
#[path = "../common/quantities.rs"]
mod quantities;
mod scaling;

use checked::checked;
use std::sync::atomic::AtomicBool;

use beamtune::model::{
    BeamMotion, Measure, Model, Place, Point, Quantity, Response, Span, Target, Theory, path, read,
};
use beamtune::solve::sensitivity::Differentiator;
use beamtune::{presets, solve};
use difference::{Exact, WIDE, worst};
use num_complex::Complex64;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngSeed, TestRunner};

fn never() -> AtomicBool {
    AtomicBool::new(false)
}

fn preset(name: &str) -> Model {
    read(presets::find(name).unwrap().text)
        .unwrap()
        .into_inner()
}

/// All responses of a model at a frequency, Hz.
fn responses(model: &Model, frequency: f64) -> Vec<Complex64> {
    let frf = solve::sweep(&checked(model), &[frequency], &never()).unwrap();
    frf.columns.iter().map(|column| column.values[0]).collect()
}

/// The largest error of all responses at a frequency, Hz.
fn worst_at(model: &Model, frequency: f64) -> (f64, String) {
    let gradients = Differentiator::new(&checked(model)).at(frequency.into());
    let exact: Vec<Exact> = gradients
        .into_iter()
        .map(|of| (of.value, of.by_parameter))
        .collect();
    worst(model, &exact, WIDE, |model| responses(model, frequency))
}

/// A model with every feature: a loss factor, moments, torques, forces on a mass, velocities and accelerations, slopes,
/// the energy, positions at the ends and shared positions.
fn rich(warping: bool) -> Model {
    let text = include_str!("rich.toml");
    let mut model = read(text).unwrap().into_inner();
    if !warping {
        model.beam.section.warping_constant = 0.0;
        let is_warping = |target: &Target| matches!(target, Target::Beam(_, BeamMotion::PsiSlope));
        model.forces.retain(|force| !is_warping(&force.target));
        model.responses.retain(
            |of| !matches!(&of.quantity, Quantity::Motion(target, _) if is_warping(target)),
        );
    }
    assert_eq!(beamtune::model::check(&model), []);
    model
}

fn thousand() -> Model {
    read(include_str!("../data/thousand.toml"))
        .unwrap()
        .into_inner()
}

/// Frequencies, Hz, with the largest allowed error. An effect counts from a millionth of the response on, and
/// differences are accurate to about ten digits, at 1 Hz to seven; at 5 kHz even the least step suffers from curvature.
const ALLOWED: [(f64, f64); 5] = [
    (1.0, 1e-3),
    (37.0, 1e-6),
    (100.0, 1e-6),
    (333.3, 1e-6),
    (5000.0, 2e-4),
];

/// Expected: differences of eighth order of the solver, whose own errors are those of [`ALLOWED`].
#[test]
fn every_parameter_of_the_presets() {
    for name in [
        "fig05a",
        "fig08",
        "cantilever",
        "symmetric_section",
        "semicircular_cantilever",
        "fig06",
        "fig16",
    ] {
        let model = preset(name);
        for (frequency, allowed) in ALLOWED {
            let (error, at) = worst_at(&model, frequency);
            assert!(
                error < allowed,
                "{name} {frequency} Hz: {error:.1e} at {at}"
            );
        }
    }
}

/// A model with supports between the ends and off the axis, forces and responses on points of the section, and springs with
/// loss factors.
fn supported(warping: bool) -> Model {
    let mut model = read(include_str!("supported.toml")).unwrap().into_inner();
    if !warping {
        model.beam.section.warping_constant = 0.0;
    }
    model
}

/// Expected: as for the presets.
#[test]
fn every_parameter_of_supports_and_points() {
    for (warping, is_general) in [(true, false), (false, false), (true, true), (false, true)] {
        let mut model = supported(warping);
        if is_general {
            let beam = &mut model.beam;
            beam.section.product_moment = 6e-5;
            beam.section.centroid_offset_y = 0.043;
            beam.axial_force = 4e5;
            (beam.section.shear_area_y, beam.section.shear_area_z) = (6e-3, 4e-3);
            beam.theory = Theory::Timoshenko;
        }
        for (frequency, allowed) in ALLOWED {
            let (error, at) = worst_at(&model, frequency);
            assert!(
                error < allowed,
                "{warping} {is_general} {frequency} Hz: {error:.1e} at {at}"
            );
        }
    }
}

/// Expected: as for the presets.
#[test]
fn every_parameter_of_a_rich_model() {
    for (warping, is_general) in [(true, false), (false, false), (true, true), (false, true)] {
        let mut model = rich(warping);
        if is_general {
            let beam = &mut model.beam;
            beam.section.product_moment = 6e-5;
            beam.section.centroid_offset_y = 0.043;
            beam.axial_force = 4e5;
            let foundation = &mut beam.foundation;
            (foundation.w.stiffness, foundation.w.loss_factor) = (2e6, 0.1);
            (foundation.psi.damping, foundation.v.stiffness) = (30.0, 4e5);
            (beam.section.shear_area_y, beam.section.shear_area_z) = (6e-3, 4e-3);
            beam.theory = Theory::Timoshenko;
            // With shear a response where a subsystem stands has two derivatives by its position.
            let joint = &mut model.responses[1].quantity;
            *joint = Quantity::Motion(
                Target::Beam(Place::Position(0.75), BeamMotion::V),
                Measure::Displacement,
            );
            beam.warping_inertia = true;
        }
        for (frequency, allowed) in ALLOWED {
            let (error, at) = worst_at(&model, frequency);
            assert!(
                error < allowed,
                "{warping} {is_general} {frequency} Hz: {error:.1e} at {at}"
            );
        }
    }
}

/// Expected: as for the presets. Spans with their own tables and with those of the beam; one may have no warping stiffness.
#[test]
fn every_parameter_of_spans() {
    for (is_rich, is_thin, is_general) in [(true, false, true), (false, true, false)] {
        let mut model = if is_rich { rich(true) } else { supported(true) };
        let whole = model.beam;
        let mut thin = whole.section;
        thin.torsion_constant *= 1.4;
        thin.second_moment_z *= 0.7;
        if is_thin {
            thin.warping_constant = 0.0;
        }
        let mut other = whole.section;
        other.area *= 1.3;
        other.second_moment_y *= 0.8;
        other.polar_moment *= 1.5;
        if is_general {
            other.product_moment = 6e-5;
            other.centroid_offset_y = 0.043;
        }
        let mut material = whole.material;
        material.young_modulus *= 0.6;
        material.loss_factor *= 2.0;
        let mut foundation = whole.foundation;
        (foundation.w.stiffness, foundation.w.loss_factor) = (2e6, 0.1);
        let (y, z) = if is_general {
            (0.05, -0.04)
        } else {
            (0.0, 0.06)
        };
        let first = Span {
            length: 0.41 * whole.length,
            section: Some(thin),
            ..Span::default()
        };
        let second = Span {
            length: 0.22 * whole.length,
            offset: Point { y, z },
            section: Some(other),
            axial_force: Some(3e5),
            ..Span::default()
        };
        let third = Span {
            length: 0.37 * whole.length,
            material: Some(material),
            foundation: is_general.then_some(foundation),
            ..Span::default()
        };
        model.spans = vec![first, second, third];
        model.beam.length = 0.0;
        for (frequency, allowed) in [ALLOWED[1], ALLOWED[3]] {
            let (error, at) = worst_at(&model, frequency);
            assert!(
                error < allowed,
                "{is_rich} {is_thin} {is_general} {frequency} Hz: {error:.1e} at {at}"
            );
        }
    }
}

/// Expected: as for the presets. Reactions, internal forces, springs and ratios, also at the ends and where something stands.
#[test]
fn every_parameter_of_forces_and_ratios() {
    for (warping, is_supported) in [(true, false), (true, true), (false, true)] {
        let model = if is_supported {
            supported(warping)
        } else {
            rich(warping)
        };
        let model = with_forces(model);
        for (frequency, allowed) in [ALLOWED[1], ALLOWED[3]] {
            let (error, at) = worst_at(&model, frequency);
            assert!(
                error < allowed,
                "{warping} {is_supported} {frequency} Hz: {error:.1e} at {at}"
            );
        }
    }
}

/// The same model with other responses: reactions, internal forces, springs and ratios.
fn with_forces(mut model: Model) -> Model {
    let motion = model.responses[0].clone();
    let mut places = vec![Place::Position(0.61), Place::Position(2.03)];
    // An internal force jumps where a subsystem stands, and has no derivative by its position.
    let ends = [(Place::Left, 0.0), (Place::Right, model.length())];
    let is_bare = |x: f64| model.attached().all(|of| of.position != x);
    let bare = ends.into_iter().filter(|(_, x)| is_bare(*x));
    places.extend(bare.map(|(end, _)| end));
    let mut all = quantities::reactions(&model);
    all.extend(quantities::internal_forces(&places));
    all.extend(quantities::springs(&model));
    model.responses = all.into_iter().map(quantities::response).collect();
    // What a free end leaves 0 is only rounding.
    let sizes = [37.0, 333.3].map(|frequency| responses(&model, frequency));
    let mut index = 0;
    model.responses.retain(|_| {
        index += 1;
        sizes.iter().all(|values| values[index - 1].norm() > 1e-12)
    });
    // A force over a force and over a stretch, a motion over a force.
    let last = model.responses.len() - 1;
    let of = [
        model.responses[last / 2].clone(),
        model.responses[0].clone(),
        motion,
    ];
    for (index, (of, over)) in of.into_iter().zip([1, last, 2]).enumerate() {
        model.responses.push(Response {
            name: format!("ratio {index}"),
            over: Some(model.responses[over].name.clone()),
            ..of
        });
    }
    assert_eq!(beamtune::model::check(&model), []);
    model
}

/// Whether something stands so near a joint that the steps of the differences move one across the other.
fn is_near_a_joint(model: &Model, targets: &[&Target]) -> bool {
    const NEAR: f64 = 0.01;
    let supports = model.supports.inner.iter().map(|of| of.position);
    let subsystems = model.subsystems.iter().map(|of| of.position);
    let targets = targets.iter().filter_map(|target| match target {
        Target::Beam(Place::Position(x), _) => Some(*x),
        Target::Beam(Place::Left | Place::Right, _) | Target::Mass(..) => None,
    });
    let mut all = supports.chain(subsystems).chain(targets);
    all.any(|x| {
        let mut joints = model.joints.iter();
        joints.any(|joint| (joint.position - x).abs() < NEAR)
    })
}

/// Expected: differences of eighth order of the solver.
#[test]
fn every_parameter_of_random_models() {
    let config = Config {
        rng_seed: RngSeed::Fixed(11),
        failure_persistence: None,
        ..Config::default()
    };
    let mut runner = TestRunner::new(config);
    let anything = (
        common::models(),
        common::targets(),
        common::targets(),
        common::frequencies(),
    );
    let mut tried = 0;
    while tried < 40 {
        let (mut model, force, response, frequency) =
            anything.new_tree(&mut runner).unwrap().current();
        if !common::exists(&model, &force)
            || !common::exists(&model, &response)
            || is_near_a_joint(&model, &[&force, &response])
        {
            continue;
        }
        model.forces = vec![common::unit_force(force)];
        let named = |name: &str, quantity| Response {
            name: name.to_owned(),
            enabled: true,
            quantity,
            point: beamtune::model::Point::AXIS,
            over: None,
        };
        model.responses = vec![
            named("motion", Quantity::Motion(response, Measure::Velocity)),
            named("energy", Quantity::Energy),
        ];
        let frequency = frequency.max(10.0);
        // A motion that nothing couples with the force is only rounding.
        if responses(&model, frequency)[0].norm() < 1e-18 {
            continue;
        }
        let (error, at) = worst_at(&model, frequency);
        // The effect of the solver's rounding on its differences.
        assert!(error < 3e-4, "{tried}, {frequency} Hz: {error:.1e} at {at}");
        tried += 1;
    }
}

/// The rows are those of the model file, each with its number.
#[test]
fn paths_are_those_of_the_model_in_their_order() {
    for model in [rich(true), preset("fig05a"), thousand()] {
        let differentiator = Differentiator::new(&checked(&model));
        let depends = |path: &String| {
            !path.starts_with("sweep")
                && !path.starts_with("subsystems.off")
                && path::number(&model, path).is_ok()
        };
        let expected: Vec<String> = path::all(&model).into_iter().filter(depends).collect();
        assert_eq!(path::texts(&model, differentiator.ids()), expected);
        for (path, value) in expected.iter().zip(differentiator.values()) {
            assert_eq!(path::number(&model, path), Ok(*value));
        }
    }
}

/// Expected: the thickness of boundary layers is the root of the warping constant, so a response changes with that root
/// (its slope is infinite), and without torque between the ends with the constant itself, as a difference shows.
#[test]
fn warping_that_rises_from_nothing() {
    const PATH: &str = "beam.section.warping_constant";
    let twisted = rich(false);
    let mut plain = preset("symmetric_section");
    plain.beam.section.warping_constant = 0.0;
    for (model, infinite) in [(&twisted, true), (&plain, false)] {
        let differentiator = Differentiator::new(&checked(model));
        let id = path::one(model, PATH).unwrap();
        let mut ids = differentiator.ids().iter();
        let index = ids.position(|other| *other == id).unwrap();
        let by = differentiator.at(61.0.into())[0].by_parameter[index];
        assert_eq!(by.is_finite(), !infinite, "{by}");
        let change = |constant| {
            responses(&difference::with(model, PATH, constant), 61.0)[0] - responses(model, 61.0)[0]
        };
        if infinite {
            let ratio = change(1e-14) / change(1e-16);
            assert!((ratio - 10.0).norm() < 0.05, "{ratio}");
        } else {
            // Nothing twists, except for the rounding of the sums.
            let whole = responses(model, 61.0)[0].norm();
            assert!(by.norm() == 0.0, "{by}");
            assert!(change(1e-10).norm() < 1e-14 * whole);
        }
    }
}

//! The cache for a response `E_V`, to which every position along the beam contributes.
//!
//! Differences are shares of the energy at each frequency.

use crate::checked::checked;
use beamtune::model::{
    BeamMotion, Elastic, Model, Quantity, Response, Restraint, Spring, Support, read,
};
use beamtune::presets;
use beamtune::solve::{SweepCache, sweep};

use super::{NEVER, assert_same, crowded, edited, edits, grid, without_warping};

pub fn with_energy(mut model: Model) -> Model {
    model.responses.push(Response {
        name: "E_V".to_owned(),
        enabled: true,
        quantity: Quantity::Energy,
        point: beamtune::model::Point::AXIS,
        over: None,
    });
    model
}

/// After each of a series of edits of a model, the result is that of a fresh solution; the cache is used.
fn assert_edits_are_kept(model: Model, frequencies: &[f64], edit: impl Fn(&mut Model)) {
    assert!(edited(model, frequencies, edit).bytes() > 0);
}

/// The usual range of a beam, in rising steps.
fn wide_grid(from: f64) -> Vec<f64> {
    let points = 48;
    let step = (2000.0 / from).powf(1.0 / f64::from(points - 1));
    (0..points).map(|k| from * step.powi(k)).collect()
}

#[test]
fn edits_of_every_kind_are_solved_as_afresh() {
    for (name, edit) in edits() {
        if name != "modulus" {
            assert_edits_are_kept(with_energy(crowded(40)), &grid(), edit);
        }
    }
}

#[test]
fn edits_from_low_to_high_frequencies_are_solved_as_afresh() {
    let mass = |m: &mut Model| m.subsystems[19].mass *= 1.1;
    assert_edits_are_kept(with_energy(crowded(40)), &wide_grid(1.0), mass);
    // Without a spring to the ground the waves cancel to fewer digits: also in a fresh solution.
    let mut held = with_energy(crowded(40));
    held.supports.left = Support::CLAMPED;
    assert_edits_are_kept(held.clone(), &wide_grid(5.0), mass);
    held.supports.right = Support::CLAMPED;
    assert_edits_are_kept(held, &wide_grid(10.0), mass);
}

#[test]
fn presets_with_many_subsystems_are_solved_as_afresh() {
    for name in ["fig13", "fig15", "cantilever", "symmetric_section"] {
        let mut model = read(presets::find(name).unwrap().text)
            .unwrap()
            .into_inner();
        let pattern = model.subsystems[0].clone();
        for index in 1..=24 {
            let mut subsystem = pattern.clone();
            subsystem.name = format!("S{index}");
            subsystem.position = model.beam.length * f64::from(index) / 25.0;
            subsystem.mass /= 24.0;
            subsystem.inertia /= 24.0;
            model.subsystems.push(subsystem);
        }
        model.responses.retain(|r| r.quantity != Quantity::Energy);
        let model = with_energy(model);
        for index in [2, 13, 22] {
            let edit = |m: &mut Model| m.subsystems[index].z_left.stiffness *= 1.1;
            assert_edits_are_kept(model.clone(), &wide_grid(5.0), edit);
        }
    }
}

#[test]
fn a_thousand_subsystems_are_solved_as_afresh() {
    let model = read(include_str!("../data/thousand.toml"))
        .unwrap()
        .into_inner();
    let frequencies = [3.0, 20.0, 61.0, 150.0, 333.0, 500.0, 1000.0, 2000.0];
    for index in [3, 500, 990] {
        let edit = |m: &mut Model| m.subsystems[index].mass *= 1.1;
        assert_edits_are_kept(model.clone(), &frequencies, edit);
    }
}

#[test]
fn random_models_are_solved_as_afresh() {
    let mut random = fastrand::Rng::with_seed(11);
    for _ in 0..24 {
        let model = random_model(&mut random);
        let index = random.usize(0..model.subsystems.len());
        let edit = |m: &mut Model| m.subsystems[index].y_left.stiffness *= 1.1;
        assert_edits_are_kept(model, &wide_grid(20.0), edit);
    }
}

/// Any supports, positions, masses, sections and losses.
fn random_model(random: &mut fastrand::Rng) -> Model {
    let mut model = with_energy(crowded(20));
    model.beam.material.loss_factor = [0.001, 0.01, 0.2][random.usize(0..3)];
    model.beam.section.warping_constant *= [0.0, 0.1, 1.0, 10.0][random.usize(0..4)];
    model.beam.section.centroid_offset *= [0.0, 1.0, -2.0][random.usize(0..3)];
    for support in [&mut model.supports.left, &mut model.supports.right] {
        let elastic = Elastic {
            spring: Spring {
                stiffness: 1e6,
                damping: 100.0,
                loss_factor: [0.0, 0.1][random.usize(0..2)],
                ..Spring::default()
            },
            inertia: [0.0, 10.0][random.usize(0..2)],
        };
        *support = [
            Support::CLAMPED,
            Support::PINNED,
            Support::FREE,
            Support::on_axis(BeamMotion::ALL.map(|_| Restraint::Elastic(elastic.clone()))),
        ][random.usize(0..4)]
        .clone();
    }
    for subsystem in &mut model.subsystems {
        subsystem.position = model.beam.length * random.f64();
        subsystem.mass *= 3.0 * random.f64();
        subsystem.z_right.stiffness *= 2.0 * random.f64();
    }
    if model.beam.section.warping_constant == 0.0 {
        without_warping(&mut model);
    }
    model
}

#[test]
fn the_energy_may_come_and_go() {
    let mut model = with_energy(crowded(40));
    let last = model.responses.len() - 1;
    let mut kept = SweepCache::default();
    for is_wanted in [true, true, true, false, false, true, true, true] {
        model.responses[last].enabled = is_wanted;
        model.subsystems[19].mass *= 1.1;
        let fresh = sweep(&checked(&model), &grid(), &NEVER).unwrap();
        assert_same(
            &kept.sweep(&checked(&model), &grid(), &NEVER).unwrap(),
            &fresh,
        );
    }
}

#[test]
fn what_is_kept_of_the_energy_is_counted() {
    let bytes = [crowded(40), with_energy(crowded(40))].map(|mut model| {
        let mut kept = SweepCache::default();
        for _ in 0..2 {
            model.subsystems[19].mass *= 1.1;
            kept.sweep(&checked(&model), &grid(), &NEVER).unwrap();
        }
        kept.bytes()
    });
    assert!(bytes[1] > bytes[0], "{bytes:?}");
}

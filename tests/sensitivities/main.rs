//! Derivatives of responses, held against differences of the solver, closed forms and scaling laws.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod closed;
mod difference;
mod extrema;
mod scaling;

use std::sync::atomic::AtomicBool;

use beamtune::model::{BeamMotion, Model, Quantity, Target, read};
use beamtune::solve::sensitivity::Differentiator;
use beamtune::{presets, solve};
use difference::{Exact, WIDE, worst};
use num_complex::Complex64;

fn never() -> AtomicBool {
    AtomicBool::new(false)
}

fn preset(name: &str) -> Model {
    read(presets::find(name).unwrap().text).unwrap()
}

/// All responses of a model at a frequency, Hz.
fn responses(model: &Model, frequency: f64) -> Vec<Complex64> {
    let frf = solve::sweep(model, &[frequency], &never()).unwrap();
    frf.columns.iter().map(|column| column.values[0]).collect()
}

/// The worst of all responses at a frequency, Hz.
fn worst_at(model: &Model, frequency: f64) -> (f64, String) {
    let gradients = Differentiator::new(model).at(frequency.into());
    let exact: Vec<Exact> = gradients
        .into_iter()
        .map(|of| (of.value, of.by_parameter))
        .collect();
    worst(model, &exact, WIDE, |model| responses(model, frequency))
}

/// A model with everything at once: a loss factor, moments, torques, forces on a mass, velocities and accelerations,
/// slopes, the energy, places at the ends and places shared.
fn rich(warping: bool) -> Model {
    let text = include_str!("rich.toml");
    let mut model = read(text).unwrap();
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

/// Frequencies, Hz, with the largest error there. An effect counts from a millionth of the response on, and differences
/// know that to about ten digits, at 1 Hz to seven; at 5 kHz the least step bends.
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

/// Expected: as of the presets.
#[test]
fn every_parameter_of_a_rich_model() {
    for warping in [true, false] {
        let model = rich(warping);
        for (frequency, allowed) in ALLOWED {
            let (error, at) = worst_at(&model, frequency);
            assert!(
                error < allowed,
                "{warping} {frequency} Hz: {error:.1e} at {at}"
            );
        }
    }
}

//! Derivatives of modes, peaks and mean squares against differences of themselves.

use crate::checked::checked;
use beamtune::model::Model;
use beamtune::solve::sensitivity::{Differentiator, PeakGradient};
use beamtune::solve::{band, modes, peaks};
use num_complex::Complex64;

use super::difference::{Exact, NEAR, Trial, worst};
use super::{never, preset, rich, supported};

/// A new search for every change takes time: only some parameters of every part.
const SOME: Trial = Trial {
    only: &[
        "beam.length",
        "density",
        "warping_constant",
        "right.v.damping",
        "S2.mass",
        "a.b\".position",
    ],
    ..NEAR
};

fn real(values: &[f64]) -> Vec<Complex64> {
    values.iter().map(|&value| value.into()).collect()
}

/// The rich model with every mass held in every direction.
fn held(warping: bool) -> Model {
    let mut model = rich(warping);
    model.subsystems[2].z_left.stiffness = 5e5;
    model
}

/// Expected: differences of [`modes::follow`].
#[test]
fn frequencies_and_damping_of_modes() {
    for (model, to) in [
        (held(true), 120.0),
        (held(false), 120.0),
        (supported(true), 120.0),
        (preset("cantilever"), 100.0),
    ] {
        let before = modes::modes(&checked(&model), to, &never()).unwrap();
        let differentiator = Differentiator::new(&checked(&model));
        let mut exact: Vec<Exact> = Vec::new();
        for (index, mode) in before.modes.iter().enumerate() {
            let gradient = differentiator.mode(&before, index);
            exact.push((mode.frequency().into(), real(&gradient.frequency)));
            exact.push((mode.damping_ratio().into(), real(&gradient.damping_ratio)));
        }
        let (error, at) = worst(&model, &exact, NEAR, |model| {
            let changed = modes::follow(&checked(model), &before, &never())
                .unwrap()
                .modes;
            let values = changed
                .iter()
                .flat_map(|mode| [mode.frequency(), mode.damping_ratio()]);
            let mut values = real(&values.collect::<Vec<_>>());
            values.resize(exact.len(), Complex64::ZERO);
            values
        });
        assert!(error < 1e-4, "{}: {error:.1e} at {at}", model.title);
    }
}

/// The peaks of a response up to the end of its sweep.
fn peaks_of(model: &Model, response: usize) -> Vec<peaks::Peak> {
    let found = modes::modes(&checked(model), model.sweep.to, &never()).unwrap();
    let base = beamtune::solve::frequencies(&model.sweep);
    let solved = beamtune::solve::sweep(&checked(model), &base, &never()).unwrap();
    let frf = peaks::resolved(&checked(model), &found, solved, &never()).unwrap();
    peaks::peaks(&frf.frequencies, &frf.columns[response], &found)
}

/// Expected: differences of the position of the changed model's extremum, from values alone; the extremum itself is
/// that of the table of peaks, within the error of its fit.
#[test]
fn heights_and_frequencies_of_peaks() {
    for (model, response) in [(rich(true), 2), (rich(true), 13)] {
        let differentiator = Differentiator::new(&checked(&model));
        let peak = peaks_of(&model, response)[1];
        let here = differentiator.peak(response, peak.frequency).unwrap();
        assert!((here.frequency / peak.frequency - 1.0).abs() < 1e-6);
        assert!((here.height / peak.height - 1.0).abs() < 1e-5);
        let exact: Vec<Exact> = vec![
            (here.frequency.into(), real(&here.frequency_by)),
            (here.height.into(), real(&here.height_by)),
        ];
        let (error, at) = worst(&model, &exact, SOME, |model| {
            let other = Differentiator::new(&checked(model));
            let moved = predicted(&here, differentiator.values(), other.values());
            let there = other.peak(response, moved).unwrap();
            real(&[there.frequency, there.height])
        });
        assert!(error < 1e-5, "{} Hz: {error:.1e} at {at}", here.frequency);
    }
}

/// The approximate position of an extremum after a change of the parameters, Hz: the start of the search.
fn predicted(here: &PeakGradient, before: &[f64], after: &[f64]) -> f64 {
    let changes = before
        .iter()
        .zip(after)
        .map(|(before, after)| after - before);
    let moves = changes
        .zip(&here.frequency_by)
        .filter(|(change, _)| *change != 0.0);
    here.frequency + moves.map(|(change, by)| change * by).sum::<f64>()
}

/// Expected: differences of the mean squares of [`band::levels`], which are accurate to 1e-8.
#[test]
fn mean_squares_in_a_band() {
    const BAND: [f64; 2] = [30.0, 180.0];
    const WIDER: Trial = Trial {
        steps: &[1e-2, 1e-3],
        ..SOME
    };
    let of = |model: &Model| {
        let found = modes::modes(&checked(model), 200.0, &never()).unwrap();
        band::levels(&checked(model), &found, BAND, &never()).unwrap()
    };
    for (model, response) in [(rich(true), 2), (rich(true), 13)] {
        let found = modes::modes(&checked(&model), 200.0, &never()).unwrap();
        let differentiator = Differentiator::new(&checked(&model));
        let mean = differentiator
            .mean_square(response, &found, BAND, &never())
            .unwrap();
        let level = of(&model)[response].mean_square;
        assert!(
            (mean.value / level - 1.0).abs() < 1e-8,
            "{} {level}",
            mean.value
        );
        let exact: Vec<Exact> = vec![(mean.value.into(), real(&mean.by_parameter))];
        let (error, at) = worst(&model, &exact, WIDER, |model| {
            vec![of(model)[response].mean_square.into()]
        });
        assert!(error < 1e-5, "{response}: {error:.1e} at {at}");
    }
}

/// An undamped resonance has no finite height and no finite mean square; its shift is that of the mode.
#[test]
fn an_undamped_resonance_has_no_peak() {
    let mut model = preset("cantilever");
    model.subsystems.clear();
    model.responses.truncate(1);
    model.beam.material.loss_factor = 0.0;
    model.forces.truncate(1);
    model.forces[0].target = beamtune::model::Target::Beam(
        beamtune::model::Place::Right,
        beamtune::model::BeamMotion::W,
    );
    model.responses[0].quantity = beamtune::model::Quantity::Motion(
        model.forces[0].target.clone(),
        beamtune::model::Measure::Displacement,
    );
    let found = modes::modes(&checked(&model), 100.0, &never()).unwrap();
    let differentiator = Differentiator::new(&checked(&model));
    let shows = |mode: &&modes::Mode| {
        differentiator.at((mode.frequency() * (1.0 + 1e-9)).into())[0]
            .value
            .norm()
            > 1e-3
    };
    let mode = found.modes.iter().find(shows).unwrap();
    let f = mode.frequency();
    assert_eq!(differentiator.peak(0, f), None);
    let mean = differentiator
        .mean_square(0, &found, [0.5 * f, 1.5 * f], &never())
        .unwrap();
    assert_eq!(mean.value, f64::INFINITY);
}

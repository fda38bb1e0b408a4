//! Adds points to a solved grid until every peak and dip of every response is on it.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;

use super::fit::{Sample, samples};
use super::grid::{Feature, Mark, by_centre, in_order, is_on_pole, missing};
use super::missing_points::{MissingPoints, hidden};
use super::{centre, half_width};
use crate::model::Checked;
use crate::solve::modes::{ModeKind, Modes};
use crate::solve::{Cancelled, ColumnKind, Frf, sweep};

/// Most passes over the grid; a dip without damping takes about ten.
const MOST_PASSES: usize = 24;

/// The frequencies of [`resolved`] for the base `base` (Hz, ascending, > 0): all of `base` and the points between.
///
/// If the base is already solved, [`resolved`] avoids solving it twice.
///
/// # Errors
/// `cancel` became true before the end.
pub fn refined(
    model: &Checked,
    modes: &Modes,
    base: &[f64],
    cancel: &AtomicBool,
) -> Result<Vec<f64>, Cancelled> {
    let solved = sweep(model, base, cancel)?;
    Ok(resolved(model, modes, solved, cancel)?.frequencies)
}

/// The curves `solved` of a model, with added points at peaks and anti-resonances.
///
/// The base stays the same, bit for bit; added points are between its first and its last frequency. `modes` are the
/// model's up to that last frequency or higher. Around each of them steps are at most half a half-width and half the
/// distance from it, so that no resonance is between two points. Then fits through three samples refine each maximum
/// and minimum of each response until a point is within a twentieth of its half-width: 0.01 dB, and 0.05 dB with the
/// error of the fit. Without damping there is no top and no bottom: points are as close as 1e-9 of the frequency on
/// both sides, none on it. A response that is only rounding, because a symmetry cancels it, is not refined.
///
/// A mode or an anti-resonance costs some tens of points, more if it is narrow: the steps double away from it.
///
/// # Errors
/// `cancel` became true before the end.
pub fn resolved(
    model: &Checked,
    modes: &Modes,
    solved: Frf,
    cancel: &AtomicBool,
) -> Result<Frf, Cancelled> {
    let features = features(modes);
    let mut wanted = missing(&solved.frequencies, &features);
    let mut frf = solved;
    for pass in 0..MOST_PASSES {
        // A frequency of the base without a finite response is on the grid, but is not a sample.
        wanted.retain(|f| !is_among(*f, &frf.frequencies));
        if !wanted.is_empty() {
            frf = frf.merged(&sweep(model, &wanted, cancel)?);
        }
        wanted = next_points(&frf, &features, most_extrema(features.len(), pass));
        if wanted.is_empty() {
            break;
        }
    }
    Ok(frf)
}

/// The frequencies of a base grid (Hz, ascending) and those between them for the half-power bands of the modes: steps
/// are at most half a half-width and half the distance from each mode, so that no resonance is between two points.
pub fn points(modes: &Modes, base: &[f64]) -> Vec<f64> {
    let mut all = [base, &missing(base, &features(modes))].concat();
    all.sort_by(f64::total_cmp);
    all
}

/// True if an ascending grid contains a frequency.
fn is_among(frequency: f64, grid: &[f64]) -> bool {
    grid.binary_search_by(|f| f.total_cmp(&frequency)).is_ok()
}

/// The half-power bands of all modes that have one, by ascending centre.
fn features(modes: &Modes) -> Vec<Feature> {
    let all = modes.modes.iter().chain(&modes.beyond);
    let moving = all.filter(|mode| mode.kind != ModeKind::RigidBody);
    by_centre(moving.map(|mode| Feature {
        centre: centre(mode),
        half_width: half_width(mode),
    }))
}

/// The most extrema of one response to refine at once; a response with more is rounding noise, because a symmetry
/// cancels it, and never converges. Extrema of modes are found at first and converge in a few passes.
fn most_extrema(modes: usize, pass: usize) -> usize {
    const WITHOUT_MODES: usize = 20;
    const A_MODE: usize = 4;
    const PASSES_TO_HALF: usize = 4;
    (WITHOUT_MODES + A_MODE * modes) >> (pass / PASSES_TO_HALF)
}

/// The points (Hz, ascending) that refine extrema; once all are resolved, those around dips and those that may reveal
/// more.
///
/// `modes` are by ascending centre; `most` as [`most_extrema`] says.
fn next_points(frf: &Frf, modes: &[Feature], most: usize) -> Vec<f64> {
    let curves: Vec<(ColumnKind, Vec<Sample>)> = frf
        .columns
        .par_iter()
        .map(|column| (column.kind, samples(&frf.frequencies, column)))
        .collect();
    let lacks: Vec<MissingPoints> = curves
        .par_iter()
        .map(|(kind, samples)| MissingPoints::new(*kind, samples, modes, most))
        .collect();
    let unsettled: Vec<Mark> = lacks.iter().flat_map(|l| l.extrema.concat()).collect();
    if !unsettled.is_empty() {
        return in_order(unsettled);
    }
    let dips = by_centre(lacks.into_iter().flat_map(|lacks| lacks.dips));
    let mut bare = missing(&frf.frequencies, &dips);
    bare.extend(
        curves
            .iter()
            .flat_map(|(kind, samples)| hidden(*kind, samples, most)),
    );
    bare.retain(|&frequency| !is_on_pole(frequency, modes));
    in_order(bare.into_iter().map(Mark::bare).collect())
}

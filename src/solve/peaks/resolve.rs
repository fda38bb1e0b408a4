//! Adds points to a solved grid until every peak and dip of every response is on it.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;

use super::fit::{Sample, samples};
use super::grid::{Feature, Mark, by_centre, in_order, is_on_pole, missing};
use super::missing_points::{MissingPoints, hidden};
use super::{centre, half_width};
use crate::model::Model;
use crate::solve::modes::{ModeKind, Modes};
use crate::solve::{Cancelled, ColumnKind, Frf, sweep};

/// Most passes over the grid; a dip without damping takes about ten.
const MOST_PASSES: usize = 24;

/// The frequencies of [`resolved`] on the base `base` (Hz, rising, > 0): all of `base` and what lies between.
///
/// Who has solved the base takes [`resolved`], which solves nothing twice.
///
/// # Errors
/// `cancel` became true before the end.
pub fn refined(
    model: &Model,
    modes: &Modes,
    base: &[f64],
    cancel: &AtomicBool,
) -> Result<Vec<f64>, Cancelled> {
    let solved = sweep(model, base, cancel)?;
    Ok(resolved(model, modes, solved, cancel)?.frequencies)
}

/// The curves `solved` of a model with the points added that peaks and anti-resonances need.
///
/// The base is kept bit for bit; what is added lies between its first and its last frequency. `modes` are the model's
/// up to that last frequency or higher. Around each of them steps are at most half a half-width and half the distance
/// from it, so that no resonance falls between two points. Then each maximum and minimum of each response is drawn in
/// by fits through three samples until a point is within a twentieth of its half-width of it: 0.01 dB, and 0.05 dB with
/// all that a fit may err. Without damping there is no top and no bottom: points go as near as 1e-9 of the frequency on
/// both sides, none on it. A response that is nothing but rounding, as where a symmetry cancels it, is left as it is.
///
/// A mode or an anti-resonance costs some tens of points, more where it is narrow: their steps double away from it.
///
/// # Errors
/// `cancel` became true before the end.
pub fn resolved(
    model: &Model,
    modes: &Modes,
    solved: Frf,
    cancel: &AtomicBool,
) -> Result<Frf, Cancelled> {
    let features = features(modes);
    let mut wanted = missing(&solved.frequencies, &features);
    let mut frf = solved;
    for pass in 0..MOST_PASSES {
        // A frequency of the base without a finite answer is on the grid, though no sample.
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

/// The frequencies of a base grid (Hz, rising) and those between them that the half-power bands of the modes need: steps
/// are at most half a half-width and half the distance from each mode, so that no resonance falls between two points.
pub fn points(modes: &Modes, base: &[f64]) -> Vec<f64> {
    let mut all = [base, &missing(base, &features(modes))].concat();
    all.sort_by(f64::total_cmp);
    all
}

/// True where a rising grid has a frequency.
fn is_among(frequency: f64, grid: &[f64]) -> bool {
    grid.binary_search_by(|f| f.total_cmp(&frequency)).is_ok()
}

/// The half-power bands of all modes that have one, by rising centre.
fn features(modes: &Modes) -> Vec<Feature> {
    let all = modes.modes.iter().chain(&modes.beyond);
    let moving = all.filter(|mode| mode.kind != ModeKind::RigidBody);
    by_centre(moving.map(|mode| Feature {
        centre: centre(mode),
        half_width: half_width(mode),
    }))
}

/// The most extrema of one response that are drawn in at once; a response with more is rounding, as where a symmetry
/// cancels it, and has no end of them. Those that modes can cause are found at first and settle in a few passes.
fn most_extrema(modes: usize, pass: usize) -> usize {
    const WITHOUT_MODES: usize = 20;
    const A_MODE: usize = 4;
    const PASSES_TO_HALF: usize = 4;
    (WITHOUT_MODES + A_MODE * modes) >> (pass / PASSES_TO_HALF)
}

/// The points (Hz, rising) that draw extrema in; once all are, those that dips need around them and those that may show
/// more.
///
/// `modes` are by rising centre; `most` as [`most_extrema`] says.
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

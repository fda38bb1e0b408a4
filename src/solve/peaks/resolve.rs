//! Adds points to a solved grid until every peak and dip of every response is on it.

use std::sync::atomic::AtomicBool;

use super::fit::{Fit, Sample, Turn, samples, turns};
use super::grid::{Feature, Mark, by_centre, fits_between, missing};
use super::{NEAREST, centre, half_width};
use crate::model::Model;
use crate::solve::modes::{ModeKind, Modes};
use crate::solve::{Column, Frf, sweep};

/// Most passes over the grid; a dip without damping takes about ten.
const MOST_PASSES: usize = 24;

/// The frequencies of [`resolved`] on the base `base` (Hz, rising, > 0): all of `base` and what lies between.
///
/// `None` where `cancel` became true before the end. Who has solved the base takes [`resolved`], which solves nothing
/// twice.
pub fn refined(
    model: &Model,
    modes: &Modes,
    base: &[f64],
    cancel: &AtomicBool,
) -> Option<Vec<f64>> {
    let solved = sweep(model, base, cancel)?;
    Some(resolved(model, modes, solved, cancel)?.frequencies)
}

/// The curves `solved` of a model with the points added that peaks and anti-resonances need.
///
/// The base is kept bit for bit; what is added lies between its first and its last frequency. `modes` are the model's
/// up to that last frequency or higher. Around each of them steps are at most half a half-width, and away from them at
/// most the distance, so that no peak falls between two points. Then each local maximum and minimum of each response
/// is drawn in by fits through three samples until a point is within a tenth of its half-width, 0.05 dB, of it.
/// Without damping there is no top and no bottom: points go as near as 1e-9 of the frequency on both sides, none on it.
///
/// A mode costs about `10 + 2 log2(distance to the next point / half-width)` points, an anti-resonance as many.
/// `None` where `cancel` became true before the end.
pub fn resolved(model: &Model, modes: &Modes, solved: Frf, cancel: &AtomicBool) -> Option<Frf> {
    let features = features(modes);
    let mut wanted = missing(&solved.frequencies, &features);
    let mut frf = solved;
    for pass in 0..MOST_PASSES {
        if !wanted.is_empty() {
            frf = merged(&frf, &sweep(model, &wanted, cancel)?);
        }
        wanted = next_points(&frf, &features, most_extrema(features.len(), pass));
        if wanted.is_empty() {
            break;
        }
    }
    Some(frf)
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

/// The points (Hz, rising) that draw extrema in; once all are, those that dips need around them.
///
/// `modes` are by rising centre; `most` as [`most_extrema`] says.
fn next_points(frf: &Frf, modes: &[Feature], most: usize) -> Vec<f64> {
    let mut wanted = Vec::new();
    let mut dips = Vec::new();
    for column in &frf.columns {
        let samples = samples(&frf.frequencies, column);
        let mut unsettled = Vec::new();
        for (middle, turn) in turns(&samples) {
            let three = &samples[middle - 1..=middle + 1];
            let fit = Fit::new(column.kind, turn, three).filter(|_| !is_flat(three));
            let Some(extremum) = fit.map(|fit| fit.extremum()) else {
                continue;
            };
            let mut points = points_at(three, extremum);
            points.retain(|mark| !is_on_pole(mark.frequency, modes));
            if points.is_empty() && turn == Turn::Dip {
                dips.push(extremum);
            }
            unsettled.extend((!points.is_empty()).then_some(points));
        }
        if unsettled.len() <= most {
            wanted.extend(unsettled.into_iter().flatten());
        }
    }
    if wanted.is_empty() {
        return missing(&frf.frequencies, &by_centre(dips));
    }
    in_order(wanted)
}

/// True where `frequency` (Hz) is nearer to an undamped mode than points may be.
fn is_on_pole(frequency: f64, modes: &[Feature]) -> bool {
    /// Leaves the points that were put beside it.
    const NEARER: f64 = 0.9 * NEAREST;
    let margin = NEARER * frequency;
    let first = modes.partition_point(|mode| mode.centre < frequency - margin);
    modes[first..]
        .iter()
        .take_while(|mode| mode.centre <= frequency + margin)
        .any(|mode| mode.is_sharp())
}

/// True where a turn is no more than rounding, or its top as good as flat: all three within 0.002 dB and in phase.
fn is_flat(three: &[Sample]) -> bool {
    const FLAT: f64 = 2e-4;
    let middle = three[1];
    let differs = |other: &Sample| (other.value - middle.value).norm() > FLAT * middle.size;
    !differs(&three[0]) && !differs(&three[2])
}

/// What is missing about an extremum between three samples: a point at it, and one near it on each side, which make
/// the next fit hold.
fn points_at(three: &[Sample], extremum: Feature) -> Vec<Mark> {
    /// How near those at its sides are, in half-widths. A zero next to a peak distorts a wider fit.
    const SIDE: f64 = 0.125;
    /// How much farther a point may be that serves as such.
    const FARTHEST: f64 = 1.5;
    let [left, middle, right] = [0, 1, 2].map(|i| three[i].frequency);
    let centre = extremum.centre;
    let clearance = extremum.clearance();
    let needs_centre = !extremum.is_sharp() && (centre - middle).abs() > clearance;
    let side = if extremum.is_sharp() {
        NEAREST * centre
    } else {
        SIDE * extremum.half_width
    };
    let beside = needs_centre || extremum.is_sharp();
    let below = if beside && middle < centre {
        middle
    } else {
        left
    };
    let above = if beside && middle > centre {
        middle
    } else {
        right
    };
    let candidates = [
        (needs_centre, centre),
        (centre - below > FARTHEST * side, centre - side),
        (above - centre > FARTHEST * side, centre + side),
    ];
    let is_new =
        |point| fits_between(left, point, middle, 0.0) || fits_between(middle, point, right, 0.0);
    candidates
        .into_iter()
        .filter(|&(needed, point)| needed && is_new(point))
        .map(|(_, frequency)| Mark {
            frequency,
            clearance,
        })
        .collect()
}

/// The frequencies of marks, rising, without those that another one serves.
fn in_order(mut marks: Vec<Mark>) -> Vec<f64> {
    marks.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
    let mut frequencies: Vec<f64> = Vec::new();
    for mark in marks {
        let last = frequencies.last().copied().unwrap_or(f64::NEG_INFINITY);
        if fits_between(last, mark.frequency, f64::INFINITY, mark.clearance) {
            frequencies.push(mark.frequency);
        }
    }
    frequencies
}

/// The rows of two responses of the same model, by rising frequency.
fn merged(one: &Frf, other: &Frf) -> Frf {
    let split = one.frequencies.len();
    let both = [&one.frequencies[..], &other.frequencies].concat();
    let mut order: Vec<usize> = (0..both.len()).collect();
    // Stable, and fast on two rising runs.
    order.sort_by(|&a, &b| both[a].total_cmp(&both[b]));
    let columns = one.columns.iter().zip(&other.columns);
    let columns = columns.map(|(one, other)| Column {
        values: order
            .iter()
            .map(|&row| match row.checked_sub(split) {
                None => one.values[row],
                Some(row) => other.values[row],
            })
            .collect(),
        ..one.clone()
    });
    Frf {
        columns: columns.collect(),
        frequencies: order.iter().map(|&row| both[row]).collect(),
    }
}

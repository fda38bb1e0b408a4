//! The points that the grid of one response still needs at its extrema.

use super::NEAREST;
use super::fit::{Fit, Sample, turns};
use super::grid::{Feature, Mark, fits_between, is_on_pole};
use crate::solve::ColumnKind;
use crate::solve::extrema::Turn;

/// The missing points of one response.
#[derive(Debug, Default)]
pub(super) struct MissingPoints {
    /// The points that each extremum without close samples needs.
    pub(super) extrema: Vec<Vec<Mark>>,
    /// The minima with close samples.
    pub(super) dips: Vec<Feature>,
}

impl MissingPoints {
    /// Checks all extrema; no point is on an undamped mode. `modes` are by ascending centre. With more than `most`
    /// incomplete extrema, no points are added.
    pub(super) fn new(
        kind: ColumnKind,
        samples: &[Sample],
        modes: &[Feature],
        most: usize,
    ) -> Self {
        let mut lacks = Self::default();
        for (middle, turn) in turns(samples) {
            let three = &samples[middle - 1..=middle + 1];
            let fit = Fit::new(kind, turn, three).filter(|_| !is_flat(three));
            let Some(extremum) = fit.map(|fit| fit.extremum()) else {
                continue;
            };
            let mut points = points_at(three, extremum);
            points.retain(|mark| !is_on_pole(mark.frequency, modes));
            if !points.is_empty() {
                lacks.extrema.push(points);
            } else if turn == Turn::Minimum {
                lacks.dips.push(extremum);
            }
        }
        if lacks.extrema.len() > most {
            lacks.extrema.clear();
        }
        lacks
    }
}

/// The middles of steps between samples within which |H| may have two extrema, or one within the first or the last
/// step: a fit has the opposite slope at a sample than the samples have. None if there are more than `most`, which is
/// rounding noise.
pub(super) fn hidden(kind: ColumnKind, samples: &[Sample], most: usize) -> Vec<f64> {
    let mut steps = Vec::new();
    let last = samples.len().saturating_sub(3);
    for (index, three) in samples.windows(3).enumerate() {
        let Some(fit) = Fit::new(kind, Turn::Minimum, three) else {
            continue;
        };
        let [before, after] = [&three[..2], &three[1..]];
        let [left, right] = [before, after].map(|step| step[1].size - step[0].size);
        let turns = |at: Sample, way: f64| is_against(fit.slope(at.frequency), way);
        if (left > 0.0) == (right > 0.0) && turns(three[1], left) {
            steps.extend([before, after]);
        }
        if index == 0 && turns(three[0], left) {
            steps.push(before);
        }
        if index == last && turns(three[2], right) {
            steps.push(after);
        }
    }
    let middle = |step: &[Sample]| {
        let [left, right] = [step[0].frequency, step[1].frequency];
        let point = 0.5 * (left + right);
        fits_between(left, point, right, 0.0).then_some(point)
    };
    if steps.len() > most {
        return Vec::new();
    }
    steps.into_iter().filter_map(middle).collect()
}

/// True if a slope, as a change over a bracket, is opposite to the trend of the samples by more than 0.01 dB.
fn is_against(slope: f64, way: f64) -> bool {
    const LEAST: f64 = 2e-3;
    slope.abs() > LEAST && (slope > 0.0) != (way > 0.0) && way != 0.0
}

/// True if an extremum is only rounding, or its top is flat: all three samples within 0.002 dB and in phase.
fn is_flat(three: &[Sample]) -> bool {
    const FLAT: f64 = 2e-4;
    let middle = three[1];
    let differs = |other: &Sample| (other.value - middle.value).norm() > FLAT * middle.size;
    !differs(&three[0]) && !differs(&three[2])
}

/// The missing points of an extremum between three samples: a point at it, and one near it on each side, to make the
/// next fit accurate.
fn points_at(three: &[Sample], extremum: Feature) -> Vec<Mark> {
    /// The distance of the points at its sides, in half-widths. A zero next to a peak distorts a wider fit.
    const SIDE: f64 = 0.125;
    /// The factor by which an existing point may be farther and still be used.
    const FARTHEST: f64 = 1.5;
    let [left, middle, right] = [0, 1, 2].map(|i| three[i].frequency);
    let (centre, clearance) = (extremum.centre, extremum.clearance());
    let (side, is_on_it) = if extremum.is_sharp() {
        (NEAREST * centre, false)
    } else {
        let is_near = (middle - centre).abs() <= clearance;
        (SIDE * extremum.half_width, is_near)
    };
    let (below, above) = if is_on_it {
        (left, right)
    } else if middle < centre {
        (middle, right)
    } else {
        (left, middle)
    };
    let candidates = [
        (!is_on_it && !extremum.is_sharp(), centre),
        (centre - below > FARTHEST * side, centre - side),
        (above - centre > FARTHEST * side, centre + side),
    ];
    let is_new =
        |point| fits_between(left, point, middle, 0.0) || fits_between(middle, point, right, 0.0);
    let mut points: Vec<f64> = candidates
        .into_iter()
        .filter(|&(needed, point)| needed && is_new(point))
        .map(|(_, point)| point)
        .collect();
    if !points.is_empty() {
        points.extend(halving([left, middle, right]));
    }
    let mark = |frequency| Mark {
        frequency,
        clearance,
    };
    points.into_iter().map(mark).collect()
}

/// The middle of the longer side of an asymmetric bracket, on which a fit alone may converge very slowly.
fn halving([left, middle, right]: [f64; 3]) -> Option<f64> {
    const LOPSIDED: f64 = 4.0;
    let sides = [middle - left, right - middle];
    if sides[0] > LOPSIDED * sides[1] {
        Some(0.5 * (left + middle))
    } else if sides[1] > LOPSIDED * sides[0] {
        Some(0.5 * (middle + right))
    } else {
        None
    }
}

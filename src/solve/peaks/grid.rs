//! Grid points for half-power bands: dense at a mode or an anti-resonance, sparser away from it.

use super::{NEAREST, UNDAMPED};

/// A mode, or a zero of a response, on the frequency axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Feature {
    /// Hz.
    pub(super) centre: f64,
    /// Hz; 0 without damping.
    pub(super) half_width: f64,
}

impl Feature {
    /// True if it is undamped, so that no point may be exactly on it.
    pub(super) fn is_sharp(self) -> bool {
        self.half_width <= UNDAMPED * self.centre
    }

    /// The required points: on the centre, or on both sides of an undamped one.
    fn marks(self) -> Vec<Mark> {
        let mark = |frequency| Mark {
            frequency,
            clearance: self.clearance(),
        };
        if self.is_sharp() {
            let distance = NEAREST * self.centre;
            vec![mark(self.centre - distance), mark(self.centre + distance)]
        } else {
            vec![mark(self.centre)]
        }
    }

    /// The distance (Hz) within which another point replaces a required one: 0.01 dB at the top of a band.
    pub(super) fn clearance(self) -> f64 {
        const NEAR_ENOUGH: f64 = 0.05;
        if self.is_sharp() {
            NEAR_ENOUGH * NEAREST * self.centre
        } else {
            NEAR_ENOUGH * self.half_width
        }
    }

    /// The longest allowed step (Hz) at a distance (Hz) from its centre.
    fn longest_step(self, distance: f64) -> f64 {
        /// In half-widths: five points per half-power band.
        const IN_BAND: f64 = 0.5;
        /// In distances: points farther away have ratios of 2.
        const AWAY: f64 = 0.5;
        let nearest = if self.is_sharp() {
            // Between required points, with some tolerance for rounding.
            2.5 * NEAREST * self.centre
        } else {
            IN_BAND * self.half_width
        };
        nearest + AWAY * distance
    }
}

/// A required point of a feature.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    /// Hz.
    pub(super) frequency: f64,
    /// Another point within this distance replaces it, Hz.
    pub(super) clearance: f64,
}

impl Mark {
    /// A point that no other can replace.
    pub(super) fn bare(frequency: f64) -> Self {
        Self {
            frequency,
            clearance: 0.0,
        }
    }
}

/// True if `frequency` (Hz) is closer to an undamped mode than points may be. `modes` are by ascending centre.
pub(super) fn is_on_pole(frequency: f64, modes: &[Feature]) -> bool {
    /// Keeps the points on its two sides.
    const NEARER: f64 = 0.9 * NEAREST;
    let margin = NEARER * frequency;
    let first = modes.partition_point(|mode| mode.centre < frequency - margin);
    modes[first..]
        .iter()
        .take_while(|mode| mode.centre <= frequency + margin)
        .any(|mode| mode.is_sharp())
}

/// The frequencies of required points, ascending, without those that another one replaces.
pub(super) fn in_order(mut marks: Vec<Mark>) -> Vec<f64> {
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

/// The smallest distance of two points, relative to their frequency: a few units in the last place.
const LEAST_GAP: f64 = 16.0 * f64::EPSILON;

/// True if `frequency` is strictly between two others, farther than `clearance` from both.
pub(super) fn fits_between(left: f64, frequency: f64, right: f64, clearance: f64) -> bool {
    let gap = clearance.max(LEAST_GAP * frequency);
    frequency - left > gap && right - frequency > gap
}

/// Features by ascending centre.
pub(super) fn by_centre(features: impl IntoIterator<Item = Feature>) -> Vec<Feature> {
    let mut features: Vec<Feature> = features.into_iter().collect();
    features.sort_by(|a, b| a.centre.total_cmp(&b.centre));
    features
}

/// The points (Hz, ascending) to add to an ascending grid so that no step is longer than the features allow, which are
/// by ascending centre.
pub(super) fn missing(grid: &[f64], features: &[Feature]) -> Vec<f64> {
    let mut marks: Vec<Mark> = features.iter().flat_map(|f| f.marks()).collect();
    marks.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
    let mut marks = marks.into_iter().peekable();
    let mut added = Vec::new();
    for pair in grid.windows(2) {
        let mut left = pair[0];
        while let Some(mark) = marks.next_if(|mark| mark.frequency < pair[1]) {
            if fits_between(left, mark.frequency, pair[1], mark.clearance) {
                divide(left, mark.frequency, features, &mut added);
                added.push(mark.frequency);
                left = mark.frequency;
            }
        }
        divide(left, pair[1], features, &mut added);
    }
    added
}

/// Halves a step until every feature allows its parts.
fn divide(left: f64, right: f64, features: &[Feature], added: &mut Vec<f64>) {
    let middle = 0.5 * (left + right);
    if fits_between(left, middle, right, 0.0) && is_too_long(left, right, features) {
        divide(left, middle, features, added);
        added.push(middle);
        divide(middle, right, features, added);
    }
}

/// True if any feature forbids a step from `left` to `right`. Features are by ascending centre.
fn is_too_long(left: f64, right: f64, features: &[Feature]) -> bool {
    let length = right - left;
    // A feature farther away than the length of the step allows it.
    let first = features.partition_point(|f| f.centre < left - length);
    let near = features[first..]
        .iter()
        .take_while(|f| f.centre <= right + length);
    near.into_iter().any(|f| {
        let distance = (left - f.centre).max(f.centre - right).max(0.0);
        length > f.longest_step(distance)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_grow_away_from_features_and_nothing_is_missing_afterwards() {
        let feature = |centre, half_width| Feature { centre, half_width };
        let features = by_centre([
            feature(30.0, 0.0),
            feature(50.0, 5e-6),
            feature(49.0, 2.0),
            feature(200.0, 1.0),
        ]);
        let base = [10.0, 20.0, 30.0 + 1e-10, 45.0, 100.0];
        let added = missing(&base, &features);
        let mut grid = [&base[..], &added].concat();
        grid.sort_by(f64::total_cmp);
        for step in grid.windows(2) {
            assert!(step[0] < step[1]);
            assert!(!is_too_long(step[0], step[1], &features), "{step:?}");
        }
        assert!(missing(&grid, &features).is_empty());
        assert!(added.contains(&50.0) && !added.contains(&30.0));
        // Ten octaves from the required points at 1e-9 and 20 from the narrow band, at most four points each.
        assert!(added.len() < 250, "{}", added.len());
    }
}

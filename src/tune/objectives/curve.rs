//! The magnitude of a response in a band, with its maxima, minima and level crossings.
//!
//! The grid is as dense as the half-power bands of the modes need, so that no extremum is missed. Each extremum is then
//! refined by parabolas through 1/|H|^2 (a minimum: |H|^2), which is a parabola next to an isolated mode (a zero), with
//! golden-section steps if they do not help, following Brent, Algorithms for Minimization without Derivatives, 1973,
//! chapter 5.

use super::super::candidate::Candidate;
use crate::solve::{Cancelled, peaks};

/// A point of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    /// Hz.
    pub(super) frequency: f64,
    /// |H|, or the energy.
    pub(super) size: f64,
}

/// The kind of extremum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Turn {
    Maximum,
    Minimum,
}

/// A response of a model in a band.
pub(super) struct Curve<'a> {
    candidate: &'a Candidate<'a>,
    response: usize,
    /// By ascending frequency, the ends of the band included.
    pub(super) points: Vec<Point>,
}

/// Steps of the base grid, to which the modes' points are added.
const STEPS: usize = 24;

/// The points next to the ends of a band, in steps: they reveal an extremum there.
const BESIDE: f64 = 1e-3;

impl<'a> Curve<'a> {
    /// Solves a response in a band (Hz, ascending).
    pub(super) fn new(
        candidate: &'a Candidate<'a>,
        response: usize,
        band: [f64; 2],
    ) -> Result<Self, Cancelled> {
        let step = (band[1] - band[0]) / STEPS as f64;
        let place = |index: usize| band[0] + step * index as f64;
        let mut base = vec![band[0], band[0] + BESIDE * step];
        base.extend((1..STEPS).map(place));
        base.extend([band[1] - BESIDE * step, band[1]]);
        let frequencies = peaks::points(candidate.modes(), &base);
        let sizes = candidate.sizes(response, &frequencies)?;
        let both = frequencies.into_iter().zip(sizes);
        let points = both.map(|(frequency, size)| Point { frequency, size });
        Ok(Self {
            candidate,
            response,
            // Not finite only exactly at an undamped mode: its neighbours represent it.
            points: points.filter(|point| point.size.is_finite()).collect(),
        })
    }

    /// The largest of the points.
    pub(super) fn highest(&self) -> f64 {
        self.points
            .iter()
            .map(|point| point.size)
            .fold(0.0, f64::max)
    }

    /// The extrema next to the points that `wanted` selects by size, by ascending frequency; without the ends of the
    /// band.
    pub(super) fn extrema(
        &self,
        turn: Turn,
        wanted: impl Fn(f64) -> bool,
    ) -> Result<Vec<Point>, Cancelled> {
        let three = self.points.windows(3);
        let turns = three.filter(|three| {
            let [left, middle, right] = [0, 1, 2].map(|index| three[index].size);
            let is_one = match turn {
                Turn::Maximum => left < middle && middle >= right,
                Turn::Minimum => left > middle && middle <= right,
            };
            is_one && wanted(middle)
        });
        let brackets = turns.map(|three| Bracket::new([three[0], three[1], three[2]]));
        self.drawn_in(turn, brackets.collect())
    }

    /// Narrows brackets until each is reduced to its extremum.
    fn drawn_in(&self, turn: Turn, mut brackets: Vec<Bracket>) -> Result<Vec<Point>, Cancelled> {
        const MOST_ROUNDS: usize = 60;
        let power = if self.candidate.is_energy(self.response) {
            1
        } else {
            2
        };
        let depth = |size: f64| match turn {
            Turn::Maximum => size.powi(-power),
            Turn::Minimum => size.powi(power),
        };
        for round in 0..MOST_ROUNDS {
            let wanted: Vec<(usize, f64)> = brackets
                .iter_mut()
                .enumerate()
                .filter_map(|(index, bracket)| Some((index, bracket.next(round, depth)?)))
                .collect();
            if wanted.is_empty() {
                break;
            }
            let frequencies: Vec<f64> = wanted.iter().map(|(_, frequency)| *frequency).collect();
            let sizes = self.candidate.sizes(self.response, &frequencies)?;
            for ((index, frequency), size) in wanted.into_iter().zip(sizes) {
                brackets[index].take(Point { frequency, size }, depth);
            }
        }
        Ok(brackets.into_iter().map(|bracket| bracket.middle).collect())
    }

    /// The points merged with others.
    pub(super) fn with(mut self, others: &[Point]) -> Self {
        self.points.extend_from_slice(others);
        self.points
            .sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
        self.points.dedup_by(|a, b| a.frequency == b.frequency);
        self
    }

    /// The frequencies (Hz) at which the curve passes a level between points on both sides of it, ascending.
    pub(super) fn crossings(&self, level: f64) -> Result<Vec<f64>, Cancelled> {
        const MOST_ROUNDS: usize = 80;
        let pairs = self.points.windows(2);
        let passes = pairs.filter(|pair| (pair[0].size < level) != (pair[1].size < level));
        let mut all: Vec<Crossing> = passes
            .map(|pair| Crossing::new([pair[0], pair[1]], level))
            .collect();
        for _ in 0..MOST_ROUNDS {
            let open: Vec<usize> = (0..all.len()).filter(|&one| all[one].is_open()).collect();
            if open.is_empty() {
                break;
            }
            let frequencies: Vec<f64> = open.iter().map(|&one| all[one].next()).collect();
            let sizes = self.candidate.sizes(self.response, &frequencies)?;
            for ((one, frequency), size) in open.into_iter().zip(frequencies).zip(sizes) {
                all[one].take(frequency, (size / level).ln());
            }
        }
        Ok(all.iter().map(Crossing::place).collect())
    }
}

/// Three points; the middle one is the best.
#[derive(Debug, Clone, Copy)]
struct Bracket {
    left: Point,
    middle: Point,
    right: Point,
    settled: bool,
}

impl Bracket {
    fn new([left, middle, right]: [Point; 3]) -> Self {
        Self {
            left,
            middle,
            right,
            settled: false,
        }
    }

    /// The next frequency; `None` once the extremum is known. `depth` makes every extremum a minimum.
    fn next(&mut self, round: usize, depth: impl Fn(f64) -> f64) -> Option<f64> {
        /// In half-widths: 1e-14 of the height.
        const NEAR: f64 = 1e-7;
        const FINEST: f64 = 4.0 * f64::EPSILON;
        /// After this number of steps, one step divides the longer side, independently of the parabola.
        const CUT: usize = 4;
        if self.settled {
            return None;
        }
        let sides = [self.left, self.right].map(|side| side.frequency - self.middle.frequency);
        let bottom = depth(self.middle.size);
        let slopes = [self.left, self.right]
            .map(|side| (depth(side.size) - bottom) / (side.frequency - self.middle.frequency));
        let curvature = (slopes[1] - slopes[0]) / (sides[1] - sides[0]);
        let slope = slopes[0] - curvature * sides[0];
        let shift = -0.5 * slope / curvature;
        let half_width = (bottom / curvature).sqrt();
        let nearest = (NEAR * half_width).max(FINEST * self.middle.frequency);
        let is_inside = shift > sides[0] && shift < sides[1];
        self.settled = sides[1] - sides[0] <= 4.0 * FINEST * self.middle.frequency
            || (is_inside && shift.abs() <= nearest);
        if self.settled {
            return None;
        }
        let longer = if -sides[0] > sides[1] {
            sides[0]
        } else {
            sides[1]
        };
        let step = if is_inside && round % CUT != CUT - 1 {
            shift
        } else {
            0.381_966 * longer
        };
        Some(self.middle.frequency + step)
    }

    fn take(&mut self, point: Point, depth: impl Fn(f64) -> f64) {
        let (new, old) = (depth(point.size), depth(self.middle.size));
        let is_left = point.frequency < self.middle.frequency;
        if point.frequency == self.middle.frequency || !new.is_finite() {
            self.settled = true;
        } else if new <= old {
            if is_left {
                self.right = self.middle;
            } else {
                self.left = self.middle;
            }
            self.middle = point;
        } else if is_left {
            self.left = point;
        } else {
            self.right = point;
        }
    }
}

/// Two points on both sides of a level, narrowed by the Illinois method (Dowell & Jarratt, BIT 1971, 11, 168).
#[derive(Debug, Clone, Copy)]
struct Crossing {
    /// Hz.
    ends: [f64; 2],
    /// ln(|H| / level), of either sign; halved while an end stays.
    heights: [f64; 2],
    /// The end replaced last.
    last: Option<usize>,
}

impl Crossing {
    fn new(ends: [Point; 2], level: f64) -> Self {
        /// ln of zero is not a number.
        const DEEPEST: f64 = -700.0;
        Self {
            ends: ends.map(|end| end.frequency),
            heights: ends.map(|end| (end.size / level).ln().max(DEEPEST)),
            last: None,
        }
    }

    fn is_open(&self) -> bool {
        const FINEST: f64 = 4.0 * f64::EPSILON;
        self.ends[1] - self.ends[0] > FINEST * self.ends[1]
            && self.heights.iter().all(|height| *height != 0.0)
    }

    fn next(&self) -> f64 {
        let [a, b] = self.ends;
        let [p, q] = self.heights;
        let secant = a + (b - a) * p / (p - q);
        if secant > a && secant < b {
            secant
        } else {
            0.5 * (a + b)
        }
    }

    fn take(&mut self, frequency: f64, height: f64) {
        let end = usize::from((height < 0.0) == (self.heights[1] < 0.0));
        if self.last == Some(end) {
            self.heights[1 - end] *= 0.5;
        }
        self.ends[end] = frequency;
        self.heights[end] = height;
        self.last = Some(end);
    }

    /// The end nearer to the level.
    fn place(&self) -> f64 {
        let [left, right] = self.heights.map(f64::abs);
        self.ends[usize::from(right < left)]
    }
}

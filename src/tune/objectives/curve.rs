//! The magnitude of a response in a band, with its maxima, minima and level crossings.
//!
//! The grid is as dense as the half-power bands of the modes need, so that no extremum is missed.

use super::super::candidate::Candidate;
use crate::solve::extrema::{self, Bracket, Point, Turn};
use crate::solve::{Cancelled, peaks};

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
        let exponent = if self.candidate.is_energy(self.response) {
            1
        } else {
            2
        };
        let three = self
            .points
            .windows(3)
            .map(|three| [0, 1, 2].map(|index| three[index]));
        let turns = three.filter(|three| {
            Turn::of(three.map(|point| point.size)) == Some(turn) && wanted(three[1].size)
        });
        let brackets = turns.map(|three| Bracket::new(three, turn, exponent));
        extrema::refined(brackets.collect(), |wanted| {
            let frequencies: Vec<f64> = wanted.iter().map(|(_, frequency)| *frequency).collect();
            self.candidate.sizes(self.response, &frequencies)
        })
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

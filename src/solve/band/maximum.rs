//! The highest point of each response in a band, refined from the samples of the integral.

use std::sync::atomic::AtomicBool;

use super::{Sample, samples};
use crate::model::{Checked, Response};
use crate::solve::Cancelled;
use crate::solve::extrema::{self, Bracket, Point, Turn};

/// A local maximum below this fraction of the highest sample cannot be the highest point: samples are dense enough that
/// none is farther below its peak.
const LIKELY: f64 = 0.5;

/// The most maxima to refine; a response with more of them is rounding noise.
const MOST_TOPS: usize = 8;

/// The distance of points from the ends of the band, relative to the next sample: they reveal a maximum at an end.
const NEAR_END: f64 = 1e-3;

/// A highest point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Top {
    /// Hz.
    pub(super) frequency: f64,
    /// |H|^2, or an energy.
    power: f64,
    /// Whether the power is an energy.
    energy: bool,
}

impl Top {
    /// |H|, or the energy.
    pub(super) fn size(self) -> f64 {
        if self.energy {
            self.power
        } else {
            self.power.sqrt()
        }
    }
}

/// The highest point of each response; `solved` are by ascending frequency and inside the band.
pub(super) fn tops(
    model: &Checked,
    solved: &[Sample],
    band: [f64; 2],
    cancel: &AtomicBool,
) -> Result<Vec<Top>, Cancelled> {
    let all = with_ends(model, solved, band, cancel)?;
    let responses = model.responses.iter().filter(|response| response.enabled);
    let (mut owners, mut brackets) = (Vec::new(), Vec::new());
    for response in 0..responses.clone().count() {
        brackets.extend(likely(&all, response));
        owners.resize(brackets.len(), response);
    }
    let refined = extrema::refined(brackets, |wanted| {
        let frequencies: Vec<f64> = wanted.iter().map(|(_, frequency)| *frequency).collect();
        let solved = samples(model, &frequencies, cancel)?.into_iter();
        let owners = wanted.iter().map(|(bracket, _)| owners[*bracket]);
        Ok(solved
            .zip(owners)
            .map(|(one, owner)| one.powers[owner])
            .collect())
    })?;
    let top = |(response, one): (usize, &Response)| {
        let own = refined
            .iter()
            .zip(&owners)
            .filter(|(_, owner)| **owner == response);
        let ends = [all.last(), all.first()].into_iter().flatten();
        let points = own
            .map(|(point, _)| *point)
            .chain(ends.map(|end| end.point(response)));
        let highest = points.max_by(|a, b| a.size.total_cmp(&b.size));
        Top {
            frequency: highest.map_or(band[0], |point| point.frequency),
            power: highest.map_or(0.0, |point| point.size),
            energy: one.quantity.is_quadratic(),
        }
    };
    Ok(responses.enumerate().map(top).collect())
}

/// The samples with the ends of the band and a point next to each.
fn with_ends(
    model: &Checked,
    solved: &[Sample],
    [low, high]: [f64; 2],
    cancel: &AtomicBool,
) -> Result<Vec<Sample>, Cancelled> {
    let first = solved.first().map_or(high, |sample| sample.frequency);
    let last = solved.last().map_or(low, |sample| sample.frequency);
    let near = [
        low + NEAR_END * (first - low),
        high - NEAR_END * (high - last),
    ];
    let mut all = samples(model, &[low, near[0], near[1], high], cancel)?;
    all.splice(2..2, solved.iter().cloned());
    Ok(all)
}

/// The local maxima of a response that may be its highest point, by descending size.
fn likely(all: &[Sample], response: usize) -> Vec<Bracket> {
    let highest = all
        .iter()
        .map(|sample| sample.powers[response])
        .fold(0.0, f64::max);
    let three = all
        .windows(3)
        .map(|three| [0, 1, 2].map(|index| three[index].point(response)));
    let mut tops: Vec<[Point; 3]> = three
        .filter(|three| {
            let sizes = three.map(|point| point.size);
            Turn::of(sizes) == Some(Turn::Maximum) && sizes[1] >= LIKELY * highest
        })
        .collect();
    tops.sort_by(|a, b| b[1].size.total_cmp(&a[1].size));
    tops.truncate(MOST_TOPS);
    // Sizes are squares already.
    tops.into_iter()
        .map(|three| Bracket::new(three, Turn::Maximum, 1))
        .collect()
}

impl Sample {
    fn point(&self, response: usize) -> Point {
        Point {
            frequency: self.frequency,
            size: self.powers[response],
        }
    }
}

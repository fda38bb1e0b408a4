//! The highest point of each response in a band, refined from the samples of the integral.

use std::sync::atomic::AtomicBool;

use super::{Sample, samples};
use crate::model::{Checked, Quantity};
use crate::solve::Cancelled;

/// A local maximum below this fraction of the highest sample cannot be the highest point: samples are dense enough that
/// none is farther below its peak.
const LIKELY: f64 = 0.5;

/// The most maxima to refine; a response with more of them is rounding noise.
const MOST_TOPS: usize = 8;

/// Each round reduces the bracket to a quarter: enough to reach 1e-12 of the height.
const ROUNDS: usize = 10;

/// Frequencies per round inside a bracket.
const INSIDE: usize = 7;

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

/// A local maximum of a response between two frequencies.
#[derive(Debug, Clone, Copy)]
struct Bracket {
    response: usize,
    /// Hz.
    ends: [f64; 2],
    best: [f64; 2],
}

/// The highest point of each response; `solved` are by ascending frequency and inside the band.
pub(super) fn tops(
    model: &Checked,
    solved: &[Sample],
    band: [f64; 2],
    cancel: &AtomicBool,
) -> Result<Vec<Top>, Cancelled> {
    let mut all = samples(model, &band, cancel)?;
    all.splice(1..1, solved.iter().cloned());
    let responses = model.responses.iter().filter(|response| response.enabled);
    let mut brackets: Vec<Bracket> = Vec::new();
    for response in 0..responses.clone().count() {
        brackets.extend(likely(&all, response));
    }
    for _ in 0..ROUNDS {
        narrow(model, &mut brackets, cancel)?;
    }
    let top = |(response, one): (usize, &crate::model::Response)| {
        let of = brackets
            .iter()
            .filter(|bracket| bracket.response == response);
        let best = of
            .map(|bracket| bracket.best)
            .max_by(|a, b| a[1].total_cmp(&b[1]));
        let [frequency, power] = best.unwrap_or([band[0], 0.0]);
        Top {
            frequency,
            power,
            energy: one.quantity == Quantity::Energy,
        }
    };
    Ok(responses.enumerate().map(top).collect())
}

/// The samples that may be next to the highest point of a response, each with its neighbours.
fn likely(all: &[Sample], response: usize) -> Vec<Bracket> {
    let power = |index: usize| all[index].powers[response];
    let highest = (0..all.len()).map(power).fold(0.0, f64::max);
    let tops = (0..all.len()).filter(|&index| {
        if highest == 0.0 {
            return index == 0;
        }
        let (left, right) = (index.saturating_sub(1), (index + 1).min(all.len() - 1));
        let here = power(index);
        here >= LIKELY * highest && here >= power(left) && here >= power(right)
    });
    let mut tops: Vec<usize> = tops.collect();
    tops.sort_by(|&a, &b| power(b).total_cmp(&power(a)));
    tops.truncate(MOST_TOPS);
    let bracket = |index: usize| Bracket {
        response,
        ends: [index.saturating_sub(1), (index + 1).min(all.len() - 1)]
            .map(|index| all[index].frequency),
        best: [all[index].frequency, power(index)],
    };
    tops.into_iter().map(bracket).collect()
}

/// Samples each bracket more finely and shrinks it to the neighbours of its highest point.
fn narrow(model: &Checked, brackets: &mut [Bracket], cancel: &AtomicBool) -> Result<(), Cancelled> {
    let inside = |bracket: &Bracket| -> [f64; INSIDE] {
        let [from, to] = bracket.ends;
        std::array::from_fn(|index| from + (to - from) * (index + 1) as f64 / (INSIDE + 1) as f64)
    };
    let frequencies: Vec<f64> = brackets.iter().flat_map(inside).collect();
    let solved = samples(model, &frequencies, cancel)?;
    for (bracket, solved) in brackets.iter_mut().zip(solved.chunks(INSIDE)) {
        for sample in solved {
            let power = sample.powers[bracket.response];
            if power > bracket.best[1] {
                bracket.best = [sample.frequency, power];
            }
        }
        let [from, to] = bracket.ends;
        let step = (to - from) / (INSIDE + 1) as f64;
        let at = bracket.best[0];
        bracket.ends = [(at - step).max(from), (at + step).min(to)];
    }
    Ok(())
}

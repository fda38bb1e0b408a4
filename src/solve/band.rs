//! Levels of the responses in a band of frequencies: the maximum and the mean square.
//!
//! `places` divides the band near the modes, `quadrature` integrates |H|^2 over the pieces for all responses together,
//! and `maximum` refines the highest points of its samples.

mod maximum;
mod places;
mod quadrature;

use std::sync::atomic::AtomicBool;

use super::modes::Modes;
use super::{Cancelled, Column, ColumnKind, sweep};
use crate::model::Checked;

/// The level of one response in a band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Level {
    /// The largest |H|, or the largest `E_V`, in the unit of the response; infinite at an undamped resonance.
    pub maximum: f64,
    /// Frequency of the maximum, Hz.
    pub at: f64,
    /// `1/(f2 - f1) int |H|^2 df`, in the unit of the response squared; for an energy the mean of `E_V` itself.
    /// Infinite if an undamped resonance lies in the band.
    pub mean_square: f64,
}

/// The levels of each enabled response in `band` (Hz, ascending, > 0), in the order of the model.
///
/// `modes` are the modes of the model up to the end of the band or higher. The integral is adaptive Gauss-Kronrod
/// quadrature (7 and 15 points; Kronrod 1965, with the error estimate of QUADPACK, Piessens et al. 1983) with a
/// relative tolerance of 1e-8 and a limit of 30,000 frequencies.
///
/// # Errors
/// `cancel` became true before the end.
pub fn levels(
    model: &Checked,
    modes: &Modes,
    band: [f64; 2],
    cancel: &AtomicBool,
) -> Result<Vec<Level>, Cancelled> {
    let poles = poles(model, modes, band, cancel)?;
    let integral = quadrature::integrate(model, &places::cuts(modes, band), &poles, cancel)?;
    let tops = maximum::tops(model, &integral.samples, band, cancel)?;
    let levels = poles.iter().zip(tops).zip(&integral.means);
    let level = |((pole, top), mean): ((&Option<f64>, maximum::Top), &f64)| match *pole {
        Some(at) => Level {
            maximum: f64::INFINITY,
            at,
            mean_square: f64::INFINITY,
        },
        None => Level {
            maximum: top.size(),
            at: top.frequency,
            mean_square: *mean,
        },
    };
    Ok(levels.map(level).collect())
}

/// The frequencies (Hz) and weights of the quadrature for the mean square of a model's responses; empty if an undamped
/// resonance lies in the band.
pub(super) fn rule(
    model: &Checked,
    modes: &Modes,
    band: [f64; 2],
    cancel: &AtomicBool,
) -> Result<Vec<[f64; 2]>, Cancelled> {
    let poles = poles(model, modes, band, cancel)?;
    if poles.iter().any(Option::is_some) {
        return Ok(Vec::new());
    }
    let integral = quadrature::integrate(model, &places::cuts(modes, band), &poles, cancel)?;
    Ok(integral.rule)
}

/// The first undamped resonance in the band that each response shows, Hz.
///
/// Near it a response grows like 1 / distance; a response that does not move in that mode stays constant.
fn poles(
    model: &Checked,
    modes: &Modes,
    band: [f64; 2],
    cancel: &AtomicBool,
) -> Result<Vec<Option<f64>>, Cancelled> {
    const FAR: f64 = 1e-7;
    const NEAR: f64 = 1e-9;
    const GROWS: f64 = 10.0;
    let responses = model.responses.iter().filter(|response| response.enabled);
    let mut poles = vec![None; responses.count()];
    for pole in places::poles(modes, band) {
        // Step into the band.
        let side = if pole > 0.5 * (band[0] + band[1]) {
            -1.0
        } else {
            1.0
        };
        let at = [FAR, NEAR].map(|distance| pole * (1.0 + side * distance));
        let frf = sweep(model, &at, cancel)?;
        for (column, found) in frf.columns.iter().zip(&mut poles) {
            let [far, near] = [0, 1].map(|row| column.values[row].norm());
            let grows = !near.is_finite() || near > GROWS * far;
            if found.is_none() && grows {
                *found = Some(pole);
            }
        }
    }
    Ok(poles)
}

/// The averaged quantity: |H|^2, or an energy itself.
fn power(column: &Column, row: usize) -> f64 {
    match column.kind {
        ColumnKind::Complex => column.values[row].norm_sqr(),
        ColumnKind::Energy => column.values[row].re,
    }
}

/// The responses at one frequency.
#[derive(Debug, Clone)]
struct Sample {
    /// Hz.
    frequency: f64,
    /// The averaged quantity of each response.
    powers: Vec<f64>,
}

/// The responses at some frequencies, Hz.
fn samples(
    model: &Checked,
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Result<Vec<Sample>, Cancelled> {
    let frf = sweep(model, frequencies, cancel)?;
    let sample = |(row, &frequency): (usize, &f64)| Sample {
        frequency,
        powers: frf
            .columns
            .iter()
            .map(|column| power(column, row))
            .collect(),
    };
    Ok(frequencies.iter().enumerate().map(sample).collect())
}

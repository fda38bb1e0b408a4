//! The effect of tolerances on the responses: quantiles over random models.

use std::sync::atomic::AtomicBool;

use fastrand::Rng;
use rayon::prelude::*;

use super::coordinates::Coordinate;
use crate::model::{Checked, Fault, Model, Tune};
use crate::solve::{Cancelled, sweep};

/// The distribution of the magnitude of one response, in its unit, one value per frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Spread {
    /// The response's name.
    pub name: String,
    /// The 5 % quantile.
    pub low: Vec<f64>,
    /// The median.
    pub median: Vec<f64>,
    /// The 95 % quantile.
    pub high: Vec<f64>,
}

/// The probabilities of the quantiles.
const QUANTILES: [f64; 3] = [0.05, 0.5, 0.95];

/// The 5, 50 and 95 % quantiles of |H| of every enabled response at some frequencies (Hz), over `samples` models with
/// independent and uniform deviations of the variables within their tolerances about the model's own values; the same
/// for the same seed. Quantiles are interpolated linearly between the sorted values (Hyndman & Fan, The American
/// Statistician 1996, 50, 361, definition 7).
///
/// # Errors
/// A variable changes nothing, or tolerances together make an invalid model; inside, `cancel` became true before the
/// end.
pub fn spread(
    model: &Checked,
    tune: &Tune,
    (samples, seed): (usize, u64),
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Result<Result<Vec<Spread>, Cancelled>, Fault> {
    /// Values in memory at a time.
    const MOST_VALUES: usize = 4_000_000;
    let models = models(model, tune, samples, seed)?;
    let names = model.responses.iter().filter(|response| response.enabled);
    let mut all: Vec<Spread> = names
        .map(|response| Spread {
            name: response.name.clone(),
            low: Vec::new(),
            median: Vec::new(),
            high: Vec::new(),
        })
        .collect();
    let piece = (MOST_VALUES / (samples * all.len()).max(1)).max(1);
    for frequencies in frequencies.chunks(piece) {
        let values = match quantiles(&models, frequencies, cancel) {
            Ok(values) => values,
            Err(cancelled) => return Ok(Err(cancelled)),
        };
        for (spread, rows) in all.iter_mut().zip(values) {
            for [low, median, high] in rows {
                spread.low.push(low);
                spread.median.push(median);
                spread.high.push(high);
            }
        }
    }
    Ok(Ok(all))
}

/// Random models within the tolerances.
fn models(model: &Checked, tune: &Tune, samples: usize, seed: u64) -> Result<Vec<Checked>, Fault> {
    let coordinates: Result<Vec<Coordinate>, Fault> = tune
        .variables
        .iter()
        .map(|variable| Coordinate::new(model, variable))
        .collect();
    let coordinates = coordinates?;
    let bare = Model {
        title: String::new(),
        notes: String::new(),
        studies: Vec::new(),
        tune: None,
        ..model.clone().into_inner()
    };
    let mut random = Rng::with_seed(seed);
    let mut one = || {
        let mut changed = bare.clone();
        for coordinate in &coordinates {
            let share = 0.01 * coordinate.variable.tolerance * (2.0 * random.f64() - 1.0);
            coordinate.set(&mut changed, coordinate.start() * (1.0 + share));
        }
        Checked::of_state(changed).map_err(|faults| {
            let Fault { path, message, .. } = &faults[0];
            Fault::new(
                "tune",
                format!(
                    "has tolerances that together make the model impossible: {path}: {message}; must have smaller ones"
                ),
            )
        })
    };
    (0..samples).map(|_| one()).collect()
}

/// For each response the quantiles at each frequency.
fn quantiles(
    models: &[Checked],
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Result<Vec<Vec<[f64; 3]>>, Cancelled> {
    let solved: Result<Vec<Vec<Vec<f64>>>, Cancelled> = models
        .par_iter()
        .map(|model| {
            let frf = sweep(model, frequencies, cancel)?;
            let columns = frf.columns.iter();
            Ok(columns
                .map(|column| column.values.iter().map(|value| value.norm()).collect())
                .collect())
        })
        .collect();
    let solved = solved?;
    let responses = solved.first().map_or(0, Vec::len);
    let of = |response: usize, row: usize| {
        let mut values: Vec<f64> = solved.iter().map(|one| one[response][row]).collect();
        values.sort_by(f64::total_cmp);
        QUANTILES.map(|share| quantile(&values, share))
    };
    let rows = |response| {
        let all = (0..frequencies.len()).into_par_iter();
        all.map(|row| of(response, row)).collect()
    };
    Ok((0..responses).map(rows).collect())
}

/// A quantile of sorted values.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else {
        return f64::NAN;
    };
    let place = share * last as f64;
    let below = (place.floor() as usize).min(last);
    let above = (below + 1).min(last);
    let part = place - below as f64;
    if part == 0.0 {
        sorted[below]
    } else {
        sorted[below] + part * (sorted[above] - sorted[below])
    }
}

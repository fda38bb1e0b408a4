//! The effect of parameters: the change of a level, a frequency or a damping ratio with the logarithm of each.

use std::f64::consts::LN_10;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use num_complex::Complex64;

use super::Differentiator;
use crate::model::{Checked, Group, ParameterId, Response};
use crate::solve::modes::Modes;
use crate::solve::{Cancelled, Reference};

/// The quantity to differentiate.
#[derive(Debug, Clone)]
pub enum Figure {
    /// The level of a response at a frequency, Hz.
    Level {
        /// Index among the enabled responses.
        response: usize,
        /// Hz.
        frequency: f64,
    },
    /// Level and frequency of a resolved peak of a response.
    Peak {
        /// Index among the enabled responses.
        response: usize,
        /// Its frequency, Hz.
        frequency: f64,
    },
    /// Frequency and damping ratio of a mode.
    Mode {
        /// The model's modes.
        modes: Arc<Modes>,
        /// The index of the mode.
        index: usize,
    },
    /// The mean-square level of a response in a band.
    Band {
        /// Index among the enabled responses.
        response: usize,
        /// The model's modes.
        modes: Arc<Modes>,
        /// From the lower to the upper end, Hz.
        band: [f64; 2],
    },
}

/// The change of a figure with the logarithm of a parameter's magnitude: a hundredth of it for 1 % more.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    /// The parameter.
    pub id: ParameterId,
    /// d(level)/d(ln p), dB; `None` if there is no level or the derivative is not finite.
    pub level: Option<f64>,
    /// d(frequency)/d(ln p), Hz; for a peak or a mode.
    pub frequency: Option<f64>,
    /// d(damping ratio)/d(ln p); for a mode.
    pub damping_ratio: Option<f64>,
}

/// The change of a figure of a model with each parameter that is not 0, in the order of the model.
///
/// The level of a response is 20 log10 |H| in dB, of an energy or a mean square 10 log10. With exactly one force its
/// amplitude and phase are left out: the response is taken per force. For a mode that the list does not have the result
/// is unknown.
///
/// # Errors
/// `cancel` became true before the end.
pub fn effects(
    model: &Checked,
    figure: &Figure,
    cancel: &AtomicBool,
) -> Result<Vec<Sensitivity>, Cancelled> {
    let differentiator = Differentiator::new(model);
    let slopes = slopes(model, &differentiator, figure, cancel)?;
    Ok(by_logarithms(model, &differentiator, &slopes))
}

/// The derivatives of a level, of a frequency and of a damping ratio by each parameter.
#[derive(Default)]
struct Slopes {
    level: Option<Vec<f64>>,
    frequency: Option<Vec<f64>>,
    damping_ratio: Option<Vec<f64>>,
}

fn slopes(
    model: &Checked,
    differentiator: &Differentiator,
    figure: &Figure,
    cancel: &AtomicBool,
) -> Result<Slopes, Cancelled> {
    // An energy has ten decibels per decade, like a mean square.
    let decibels = |response: usize| match enabled(model, response) {
        Some(one) if one.quantity.is_quadratic() => 10.0 / LN_10,
        _ => 20.0 / LN_10,
    };
    Ok(match figure {
        Figure::Level {
            response,
            frequency,
        } => {
            let gradient = differentiator.response_at(*response, Complex64::from(*frequency));
            let factor = decibels(*response);
            let relative = |slope: &Complex64| factor * (slope / gradient.value).re;
            Slopes {
                level: Some(gradient.by_parameter.iter().map(relative).collect()),
                ..Slopes::default()
            }
        }
        Figure::Peak {
            response,
            frequency,
        } => peak_slopes(differentiator, *response, *frequency, decibels(*response)),
        Figure::Mode { modes, index } if *index >= modes.modes.len() => Slopes::default(),
        Figure::Mode { modes, index } => {
            let gradient = differentiator.mode(modes, *index);
            Slopes {
                level: None,
                frequency: Some(gradient.frequency),
                damping_ratio: Some(gradient.damping_ratio),
            }
        }
        Figure::Band {
            response,
            modes,
            band,
        } => {
            let gradient = differentiator.mean_square(*response, modes, *band, cancel)?;
            let relative = |slope: &f64| 10.0 / LN_10 * slope / gradient.value;
            Slopes {
                level: Some(gradient.by_parameter.iter().map(relative).collect()),
                ..Slopes::default()
            }
        }
    })
}

/// The derivatives of an extremum with a finite height; unknown for any other.
fn peak_slopes(
    differentiator: &Differentiator,
    response: usize,
    frequency: f64,
    factor: f64,
) -> Slopes {
    let Some(gradient) = differentiator.peak(response, frequency) else {
        return Slopes::default();
    };
    let relative = |slope: &f64| factor * slope / gradient.height;
    Slopes {
        level: Some(gradient.height_by.iter().map(relative).collect()),
        frequency: Some(gradient.frequency_by),
        damping_ratio: None,
    }
}

/// The derivatives by the logarithms of the parameters; `None` for a parameter of 0.
fn by_logarithms(
    model: &Checked,
    differentiator: &Differentiator,
    slopes: &Slopes,
) -> Vec<Sensitivity> {
    // With exactly one force the response is shown divided by it, so the force has no effect.
    let one_force = Reference::of(model).is_some();
    let numbers = differentiator.ids().iter().zip(differentiator.values());
    let scaled = |slopes: &Option<Vec<f64>>, index: usize, value: f64| {
        let slope = slopes.as_ref()?.get(index)? * value;
        slope.is_finite().then_some(slope)
    };
    numbers
        .enumerate()
        .filter(|(_, (id, value))| **value != 0.0 && !(one_force && is_size_of_force(**id)))
        .map(|(index, (id, value))| Sensitivity {
            id: *id,
            level: scaled(&slopes.level, index, *value),
            frequency: scaled(&slopes.frequency, index, *value),
            damping_ratio: scaled(&slopes.damping_ratio, index, *value),
        })
        .collect()
}

/// Amplitude or phase: the numbers of a force.
const fn is_size_of_force(id: ParameterId) -> bool {
    matches!(id.group, Group::Force(_))
}

/// An enabled response by its index among them.
fn enabled(model: &Checked, index: usize) -> Option<&Response> {
    model.responses.iter().filter(|one| one.enabled).nth(index)
}

//! Measured curves, and how well the model fits them.

pub(crate) mod choose;
mod commands;

use std::path::PathBuf;

use num_complex::Complex64;

use crate::measured::{Curve, Fit, Inspection};
use crate::model::Fault;
use crate::tui::panels::chart::{Display, Trace};
use crate::unit::{Dimension, Form, Kind};

/// The most measured curves that can be distinguished on the chart.
pub(crate) const MOST_CURVES: usize = 12;

/// A curve from a file.
#[derive(Debug)]
pub struct Measured {
    /// A unique number.
    pub id: u64,
    /// Its name in the legend.
    pub name: String,
    /// The curve.
    pub curve: Curve,
    /// Whether it is visible.
    pub shown: bool,
}

/// How well a response fits a measured curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    /// The id of the measured curve.
    pub measured: u64,
    /// The response.
    pub response: String,
    /// The quality of the fit, in the displayed form.
    pub fit: Fit,
}

/// The model at the frequencies of the measured curves.
#[derive(Debug)]
pub(crate) struct Sample {
    /// The model's generation.
    pub(crate) generation: u64,
    pub(crate) frequencies: Vec<f64>,
    pub(crate) traces: Vec<Trace>,
}

/// The inputs of a fit.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FitKey {
    serial: Option<u64>,
    solved: Option<u64>,
    form: Option<Form>,
    motion: bool,
    band: Option<[f64; 2]>,
    visible: Vec<String>,
}

/// The key of a request: the model's generation, and the ids of the measured curves.
pub(crate) type SampleKey = (u64, Vec<u64>);

/// The result of opening a measured file.
#[derive(Debug)]
pub enum OpenedMeasured {
    /// Its curves.
    Curves(Vec<Curve>),
    /// The file does not describe all its columns.
    Asks(PathBuf, Box<Inspection>),
    /// The file is not readable, and why.
    Faulty(PathBuf, Fault),
}

impl Measured {
    /// The dimension of its values, if they are known and complex.
    pub fn dimension(&self) -> Option<Dimension> {
        self.curve.kind.and_then(Kind::dimension)
    }

    /// Whether it can share the axis of a response: its quantity is the same except for the measure of the motion, or
    /// is unknown.
    pub fn fits(&self, response: Option<&Dimension>) -> bool {
        match (self.curve.kind, response) {
            (None, _) | (Some(Kind::Energy), None) => true,
            (Some(Kind::Amplitude(own)), Some(response)) => own.is_alike(*response),
            _ => false,
        }
    }

    /// Its value at a frequency (Hz) in the form of a response, by linear interpolation; none beyond its ends.
    pub fn value_at(
        &self,
        display: &Display,
        response: Option<&Dimension>,
        frequency: f64,
    ) -> Option<Complex64> {
        let all = &self.curve.frequencies;
        let after = all.partition_point(|f| *f < frequency);
        let value = |i: usize| self.value(display, response, i);
        if all.get(after) == Some(&frequency) {
            return Some(value(after));
        }
        let before = after.checked_sub(1)?;
        let share = (frequency - all[before]) / (all.get(after)? - all[before]);
        Some(value(before) * (1.0 - share) + value(after) * share)
    }

    /// Whether its values are energies, when compared with a response.
    pub fn is_energy(&self, response: Option<&Dimension>) -> bool {
        self.curve.kind == Some(Kind::Energy) || (self.curve.kind.is_none() && response.is_none())
    }

    /// A value by its index, converted to the displayed form of the response it is compared with. An unknown quantity
    /// counts as that of the response.
    pub fn value(
        &self,
        display: &Display,
        response: Option<&Dimension>,
        index: usize,
    ) -> Complex64 {
        let (value, frequency) = (self.curve.values[index], self.curve.frequencies[index]);
        let shown = match (self.dimension().or(response.copied()), response) {
            (Some(own), Some(response)) => {
                own.converted(value, frequency, display.form_of(*response))
            }
            _ => value,
        };
        // Without a phase, a conversion gives none either.
        if self.curve.phase_known {
            shown
        } else {
            shown.norm().into()
        }
    }
}

//! How values are shown: form, view, units, decibels and the level scale.

use std::collections::BTreeMap;

use num_complex::Complex64;

use super::{Curves, Trace};
use crate::model::Unit;
use crate::tui::plot::Level;
use crate::tui::scene::{ChartView, Scale};
use crate::unit::{Dimension, Form, FrequencyUnit, Kind};

/// The name of the form that is not divided by the force.
pub const MOTION: &str = "motion under the force";

/// How values are shown.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Display {
    /// Which part of the complex values is drawn.
    pub view: ChartView,
    /// The form of all responses; none: the model's choice for each.
    pub form: Option<Form>,
    /// Shows the motion under the actual forces, even if a single force could divide it; `form` is none then.
    pub motion: bool,
    /// Whether the phase is unwrapped.
    pub unwrapped: bool,
    /// The unit of frequencies.
    pub unit: FrequencyUnit,
    /// The 0 dB reference by unit; default 1 of the unit.
    pub decibel_references: BTreeMap<String, f64>,
    /// The range of the first value axis, in axis values; none: automatic.
    pub levels: Option<[f64; 2]>,
    /// The axis to which the fixed range applies.
    levels_of: Option<(ChartView, Scale)>,
}

impl Display {
    /// The displayed form of a response.
    pub fn form_of(&self, dimension: Dimension) -> Form {
        self.form
            .filter(|form| dimension.has(*form))
            .unwrap_or(dimension.own_form())
    }

    /// The dimension of a response as displayed, except its form; none for an energy.
    pub fn dimension_of(&self, trace: &Trace) -> Option<Dimension> {
        let dimension = trace.dimension?;
        Some(Dimension {
            per: dimension
                .per
                .filter(|_| trace.force.is_none() || !self.motion),
            ..dimension
        })
    }

    /// A value of a response as displayed: divided by the force or not.
    pub fn per_force(&self, trace: &Trace, value: Complex64) -> Complex64 {
        match trace.force.filter(|_| self.motion) {
            Some(force) => value * force,
            None => value,
        }
    }

    /// A value of a response at a frequency (Hz) as displayed; an energy is unchanged.
    pub fn value(&self, trace: &Trace, value: Complex64, frequency: f64) -> Complex64 {
        let value = self.per_force(trace, value);
        match self.dimension_of(trace) {
            Some(dimension) => dimension.converted(value, frequency, self.form_of(dimension)),
            None => value,
        }
    }

    /// The displayed unit.
    pub fn unit_of(&self, dimension: Option<&Dimension>) -> String {
        match dimension {
            Some(dimension) => dimension.unit(self.form_of(*dimension)),
            None => Kind::Energy.unit(),
        }
    }

    /// A frequency (Hz) as text with its unit.
    pub fn frequency_text(&self, hertz: f64) -> String {
        match self.unit {
            FrequencyUnit::Hertz => Unit::HERTZ.format(hertz),
            unit => format!("{} {}", self.frequency_digits(hertz), unit.symbol()),
        }
    }

    /// A frequency (Hz) in the displayed unit, without the symbol: six significant digits.
    pub fn frequency_digits(&self, hertz: f64) -> String {
        let value = hertz * self.unit.per_hertz();
        let digits = format!("{value:.5e}");
        let exponent = digits
            .split_once('e')
            .and_then(|(_, e)| e.parse::<i32>().ok());
        match exponent {
            Some(exponent @ -3..=5) => format!("{value:.*}", (5 - exponent) as usize),
            _ => digits,
        }
    }

    /// The typed 0 dB reference of a unit.
    pub fn decibel_reference(&self, unit: &str) -> f64 {
        self.decibel_references.get(unit).copied().unwrap_or(1.0)
    }

    /// The 0 dB reference of a unit: 1 if the visible responses have several units.
    pub fn decibel_zero(&self, curves: &Curves, unit: &str) -> f64 {
        if self.shown_units(curves).len() > 1 {
            1.0
        } else {
            self.decibel_reference(unit)
        }
    }

    /// The units of the visible responses, each once.
    pub fn shown_units(&self, curves: &Curves) -> Vec<String> {
        let mut units: Vec<String> = Vec::new();
        for trace in curves.shown_traces() {
            let dimension = self.dimension_of(trace);
            let unit = self.unit_of(dimension.as_ref());
            if !units.contains(&unit) {
                units.push(unit);
            }
        }
        units
    }

    /// Fixes the range of levels, in axis values, as long as the axis is the same.
    pub(super) fn fix_levels(&mut self, levels: [f64; 2], curves: &Curves) {
        self.levels = Some(levels);
        self.levels_of = Some((self.view, self.scale(curves)));
    }

    /// Removes settings that no longer apply: fixed levels of another axis, and a difference without a reference.
    pub(crate) fn refresh(&mut self, curves: &Curves, has_reference: bool) {
        if self.view == ChartView::Difference && !has_reference {
            self.view = ChartView::Magnitude;
        }
        if self.levels.is_some() && curves.picture().is_some() {
            let axis = (self.view, self.scale(curves));
            if self.levels_of.as_ref() != Some(&axis) {
                self.levels = None;
            }
        }
    }

    /// How to show the magnitudes of the visible responses.
    pub fn scale(&self, curves: &Curves) -> Scale {
        let units = self.shown_units(curves);
        let dimensions = curves.shown_traces().map(|trace| trace.dimension);
        let (energy, motion) = dimensions.fold((false, false), |(energy, motion), dimension| {
            (energy || dimension.is_none(), motion || dimension.is_some())
        });
        let unit = units.join(", ");
        // Ten and twenty decibels per decade cannot share an axis.
        if !curves.decibels || (energy && motion) {
            return Scale {
                level: Level::Magnitude,
                unit,
            };
        }
        let reference = self.decibel_zero(curves, &unit);
        Scale {
            level: Level::Decibel {
                factor: if energy { 10.0 } else { 20.0 },
                reference,
            },
            unit: format!("dB re {} {unit}", plain(reference)),
        }
    }
}

/// The shortest text of a number: 1, 1e-12.
fn plain(value: f64) -> String {
    if (1e-3..1e4).contains(&value) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

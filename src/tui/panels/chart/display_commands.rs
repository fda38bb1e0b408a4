//! How values are shown: form, view, units, decibels and the level scale.

use std::collections::BTreeMap;

use num_complex::Complex64;

use crate::model::Unit;
use crate::tui::app::{App, Trace};
use crate::tui::keys::CurvesCommand;
use crate::tui::scene::{self, ChartView, Scale};
use crate::unit::{Dimension, Form, FrequencyUnit, Kind};

/// The name of the form that is not divided by the force.
pub const MOTION: &str = "motion under the force";

/// The forms that the key cycles through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Choice {
    AsAsked,
    Form(Form),
    Motion,
}

impl Choice {
    fn of(display: &Display) -> Self {
        match (display.motion, display.form) {
            (true, _) => Self::Motion,
            (false, Some(form)) => Self::Form(form),
            (false, None) => Self::AsAsked,
        }
    }
}

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
    pub fn form_of(&self, dimension: &Dimension) -> Form {
        self.form
            .filter(|form| dimension.has(*form))
            .unwrap_or(dimension.form_of_measure())
    }

    /// The dimension of a response as displayed, except its form; none for an energy.
    pub fn dimension_of(&self, trace: &Trace) -> Option<Dimension> {
        let dimension = trace.dimension?;
        Some(Dimension {
            per: dimension.per.filter(|_| !self.motion),
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
            Some(dimension) => dimension.converted(value, frequency, self.form_of(&dimension)),
            None => value,
        }
    }

    /// The displayed unit.
    pub fn unit_of(&self, dimension: Option<&Dimension>) -> String {
        match dimension {
            Some(dimension) => dimension.unit(self.form_of(dimension)),
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
}

impl App {
    pub(crate) fn toggle_unwrapping(&mut self) {
        self.display.unwrapped = !self.display.unwrapped;
        self.done(if self.display.unwrapped {
            "phase runs on"
        } else {
            "phase within half a turn"
        });
    }

    pub(crate) fn toggle_decibels(&mut self) {
        self.curves.decibels = !self.curves.decibels;
        self.turned.decibels = Some(self.curves.decibels);
    }

    /// Selects the next form that the visible responses have, or the model's choice.
    pub(crate) fn turn_form(&mut self, forward: bool) {
        let shown = self.shown_traces();
        let dimensions: Vec<Dimension> = shown.filter_map(|trace| trace.dimension).collect();
        if dimensions.is_empty() {
            return self.refuse("no response of a motion shows: an energy has one form");
        }
        let has = |form: &Form| dimensions.iter().any(|dimension| dimension.has(*form));
        let ratio = dimensions.iter().any(|dimension| dimension.per.is_some());
        let mut choices = vec![Choice::AsAsked];
        choices.extend(Form::ALL.into_iter().filter(has).map(Choice::Form));
        if ratio {
            choices.push(Choice::Motion);
        }
        let now = Choice::of(&self.display);
        let place = choices.iter().position(|choice| *choice == now);
        let step = if forward { 1 } else { choices.len() - 1 };
        let next = choices[(place.unwrap_or(0) + step) % choices.len()];
        self.display.motion = next == Choice::Motion;
        self.display.form = match next {
            Choice::Form(form) => Some(form),
            Choice::AsAsked | Choice::Motion => None,
        };
        self.display.levels = None;
        self.done(match (next, ratio) {
            (Choice::AsAsked, _) => "each response as the model asks for it".to_owned(),
            (Choice::Motion, _) => format!("{MOTION} as it is"),
            (Choice::Form(form), true) => form.name().to_owned(),
            // The first three without a single force to divide by.
            (Choice::Form(form), false) => {
                let motion = form.measure().key();
                format!("{motion}; several forces act, so that there is no ratio and no inverse")
            }
        });
    }

    /// The visible responses of the model or of the first member of its study.
    pub fn shown_traces(&self) -> impl Iterator<Item = &Trace> {
        let members = self.curves.picture().map(|picture| &picture.members);
        let first = members.and_then(|members| members.first());
        let traces = first.map_or(&[][..], |member| &member.traces);
        traces
            .iter()
            .filter(|trace| self.curves.shows(&trace.response))
    }

    /// The 0 dB reference of a unit: 1 if the visible responses have several units.
    pub fn decibel_zero(&self, unit: &str) -> f64 {
        if self.shown_units().len() > 1 {
            1.0
        } else {
            self.display.decibel_reference(unit)
        }
    }

    /// The units of the visible responses, each once.
    pub fn shown_units(&self) -> Vec<String> {
        let mut units: Vec<String> = Vec::new();
        for trace in self.shown_traces() {
            let dimension = self.display.dimension_of(trace);
            let unit = self.display.unit_of(dimension.as_ref());
            if !units.contains(&unit) {
                units.push(unit);
            }
        }
        units
    }

    pub(crate) fn next_view(&mut self) {
        let all: Vec<ChartView> = ChartView::ALL
            .into_iter()
            .filter(|view| {
                *view != ChartView::Difference || self.comparison.first_shown().is_some()
            })
            .collect();
        let place = all.iter().position(|view| *view == self.display.view);
        self.display.view = all[place.map_or(0, |place| (place + 1) % all.len())];
        self.display.levels = None;
        self.done(self.display.view.name());
    }

    pub(crate) fn next_frequency_unit(&mut self) {
        let all = FrequencyUnit::SHOWN;
        let place = all.iter().position(|unit| *unit == self.display.unit);
        self.display.unit = all[(place.unwrap_or(0) + 1) % all.len()];
        self.turned.frequency_unit = Some(self.display.unit.symbol().to_owned());
        self.done(format!("frequencies in {}", self.display.unit.symbol()));
    }

    /// Scales the range of levels about its middle, and fixes it.
    pub(crate) fn zoom_levels(&mut self, factor: f64) {
        self.change_levels(|[low, high]| {
            let middle = f64::midpoint(low, high);
            [
                middle + (low - middle) * factor,
                middle + (high - middle) * factor,
            ]
        });
    }

    pub(crate) fn pan_levels(&mut self, quarters: f64) {
        self.change_levels(|[low, high]| {
            let by = quarters * (high - low) / 4.0;
            [low + by, high + by]
        });
    }

    /// Fixes the visible levels, or lets them follow the curves again.
    pub(crate) fn fix_levels(&mut self) {
        if self.display.levels.take().is_some() {
            return self.done("levels follow the curves");
        }
        match self.screen.levels {
            Some(levels) => {
                self.set_levels(levels.bounds);
                let key = self.keys.key_of(CurvesCommand::LevelFix);
                self.done(format!("levels fixed; {key} lets them follow the curves"));
            }
            None => self.refuse("no value axis shows"),
        }
    }

    fn set_levels(&mut self, levels: [f64; 2]) {
        self.display.levels = Some(levels);
        self.display.levels_of = Some((self.display.view, scene::scale(self)));
    }

    /// Removes settings that no longer apply: fixed levels of another axis, and a difference without a reference.
    pub(crate) fn refresh_display(&mut self) {
        if self.display.view == ChartView::Difference && self.comparison.shown().next().is_none() {
            self.display.view = ChartView::Magnitude;
        }
        if self.display.levels.is_some() && self.curves.picture().is_some() {
            let axis = (self.display.view, scene::scale(self));
            if self.display.levels_of.as_ref() != Some(&axis) {
                self.display.levels = None;
            }
        }
    }

    /// Changes the range of levels in axis coordinates (logarithmic for magnitudes).
    fn change_levels(&mut self, change: impl Fn([f64; 2]) -> [f64; 2]) {
        let Some(levels) = self.screen.levels else {
            return self.refuse("no value axis shows");
        };
        let bounds = self.display.levels.unwrap_or(levels.bounds);
        let changed = if levels.log {
            change(bounds.map(f64::log10)).map(|place| 10_f64.powf(place))
        } else {
            change(bounds)
        };
        let drawable = changed.iter().all(|bound| bound.is_finite())
            && changed[1] - changed[0] > 1e-12 * changed[0].abs().max(changed[1].abs())
            && (!levels.log || (changed[0].is_normal() && changed[1].is_normal()));
        if drawable {
            self.set_levels(changed);
        } else {
            self.refuse("no such levels can be drawn");
        }
    }
}

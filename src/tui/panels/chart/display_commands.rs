//! Changes how values are shown: form, view, units, decibels and the level scale.

use super::{Display, MOTION};
use crate::tui::app::App;
use crate::tui::keys::CurvesCommand;
use crate::tui::scene::ChartView;
use crate::unit::{Dimension, Form, FrequencyUnit};

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

impl App {
    /// The 0 dB reference of a unit: 1 if the visible responses have several units.
    pub fn decibel_zero(&self, unit: &str) -> f64 {
        self.display.decibel_zero(&self.curves, unit)
    }

    pub(crate) fn toggle_unwrapping(&mut self) {
        self.display.unwrapped = !self.display.unwrapped;
        self.done(if self.display.unwrapped {
            "phase unwrapped"
        } else {
            "phase wrapped to half a turn"
        });
    }

    pub(crate) fn toggle_decibels(&mut self) {
        self.curves.decibels = !self.curves.decibels;
        self.stored.changed.decibels = Some(self.curves.decibels);
    }

    /// Selects the next form that the visible responses have, or the model's choice.
    pub(crate) fn turn_form(&mut self, forward: bool) {
        let shown = self.curves.shown_traces();
        let dimensions: Vec<Dimension> = shown.filter_map(|trace| trace.dimension).collect();
        if dimensions.is_empty() {
            return self.refuse("only energies are visible, which have one form");
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
            (Choice::AsAsked, _) => "each response in the model's form".to_owned(),
            (Choice::Motion, _) => format!("{MOTION} as it is"),
            (Choice::Form(form), true) => form.name().to_owned(),
            // The first three without a single force to divide by.
            (Choice::Form(form), false) => {
                let motion = form.measure().key();
                format!("{motion}; several forces act, so there is no ratio and no inverse")
            }
        });
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
        self.stored.changed.frequency_unit = Some(self.display.unit.symbol().to_owned());
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
                self.display.fix_levels(levels.bounds, &self.curves);
                let key = self.keys.key_of(CurvesCommand::LevelFix);
                self.done(format!("levels fixed; {key} lets them follow the curves"));
            }
            None => self.refuse("no value axis is visible"),
        }
    }

    /// Changes the range of levels in axis coordinates (logarithmic for magnitudes).
    fn change_levels(&mut self, change: impl Fn([f64; 2]) -> [f64; 2]) {
        let Some(levels) = self.screen.levels else {
            return self.refuse("no value axis is visible");
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
            self.display.fix_levels(changed, &self.curves);
        } else {
            self.refuse("these levels cannot be drawn");
        }
    }
}

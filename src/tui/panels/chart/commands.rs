//! Commands of the chart.

use std::sync::Arc;

use super::Turn;
use crate::model::{Group, Model};
use crate::tui::app::{Anchor, App, BeamView, Table};
use crate::tui::keys::ModelCommand;
use crate::tui::scene::{self, ChartState, Scene};

/// Steps of the cursor over the whole axis, before the first drawing.
const USUAL_COLUMNS: f64 = 100.0;

impl App {
    /// The content of the chart.
    pub fn scene(&self) -> Scene {
        let modes = self.modes.list.as_ref();
        let marks_mode = self.tables.anchor == Anchor::Mode
            || self.tables.open == Some(Table::Modes)
            || self.beam_view.shown == Some(BeamView::Mode);
        scene::of(ChartState {
            model: self.model(),
            curves: &self.curves,
            detail: &self.detail,
            display: &self.display,
            reading: &self.reading,
            comparison: &self.comparison,
            fem: self.fem_overlay.picture(),
            tolerances: &self.tuning.tolerances,
            modes,
            mode: (marks_mode && modes.is_some()).then_some(self.tables.modes.row),
        })
    }

    /// Closes the table, ends the search of the tree, or takes the cursor off the chart.
    pub(crate) fn take_away(&mut self) {
        if self.tables.open.take().is_some() {
            return;
        }
        if self.search.take().is_none() && self.curves.cursor.take().is_none() {
            self.refuse("there is no count, search or cursor to remove");
        }
        self.free_cursor();
    }

    /// The response of the selected row, if it can be drawn.
    fn response(&mut self) -> Option<String> {
        let Some(Group::Response(i)) = self.selection.node().item() else {
            self.refuse("select a response to show or hide its curve");
            return None;
        };
        let response = &self.model().responses[i];
        let name = response.name.clone();
        if !response.enabled {
            let key = self.keys.key_of(ModelCommand::Enable);
            self.refuse(format!("{name} is disabled: {key} enables it"));
            return None;
        }
        Some(name)
    }

    pub(crate) fn show_response(&mut self) {
        if let Some(name) = self.response() {
            let shows = self.curves.toggle(&name);
            self.done(format!(
                "{name} {}",
                if shows { "shows" } else { "is hidden" }
            ));
        }
    }

    pub(crate) fn solo_response(&mut self) {
        if let Some(name) = self.response() {
            let model = Arc::clone(self.document.model());
            let alone = self.curves.solo(&model, &name);
            self.done(if alone {
                format!("{name} alone")
            } else {
                format!("all in the unit of {name}")
            });
        }
    }

    pub(crate) fn next_study(&mut self) {
        let model = Arc::clone(self.document.model());
        if model.studies.is_empty() {
            self.refuse("the model has no studies");
            return;
        }
        let next = self.curves.study.map_or(0, |study| study + 1);
        self.show_study((next < model.studies.len()).then_some(next), &model);
    }

    pub(crate) fn show_study(&mut self, study: Option<usize>, model: &Model) {
        self.curves.study = study;
        self.done(match study {
            Some(i) => format!("study: {}", model.studies[i].name),
            None => "the model alone, no study".to_owned(),
        });
    }

    /// Moves the cursor by columns of the chart.
    pub(crate) fn step_cursor(&mut self, steps: f64) {
        self.move_cursor(steps);
        self.free_cursor();
    }

    /// Moves the cursor along the frequency axis by columns of the chart; a new cursor starts in the middle.
    pub(crate) fn move_cursor(&mut self, steps: f64) {
        let sweep = self.model().sweep;
        let before = self.curves.cursor;
        let shown = self.shown_frequencies();
        let log = self.curves.log_frequency;
        let place = |frequency: f64| if log { frequency.ln() } else { frequency };
        let (low, high) = (place(shown[0]), place(shown[1]));
        let columns = self.screen.plot.as_ref().map(|plot| plot.frequencies.len());
        let columns = columns.map_or(USUAL_COLUMNS, |columns| columns.max(2) as f64 - 1.0);
        let new = match self.curves.cursor {
            Some(old) => place(old) + steps * (high - low) / columns,
            None => f64::midpoint(low, high),
        };
        let new = if log { new.exp() } else { new };
        self.curves.cursor = Some(new.clamp(sweep.from, sweep.to));
        if self.curves.cursor == before {
            self.refuse("the sweep ends here");
        }
    }

    /// Puts the cursor at a frequency, Hz.
    pub(crate) fn put_cursor(&mut self, frequency: f64) {
        self.curves.cursor = Some(frequency);
        self.free_cursor();
    }

    /// Fixes the cursor at its frequency, and makes it visible.
    fn free_cursor(&mut self) {
        self.tables.anchor = Anchor::Frequency;
        let sweep = self.model().sweep;
        self.curves.reveal_cursor(&sweep);
    }

    /// Moves the cursor to the next peak or anti-resonance of the first curve, as displayed.
    pub(crate) fn seek(&mut self, turn: Turn, forward: bool) {
        match self.next_turn(turn, forward) {
            Ok(frequency) => self.curves.cursor = Some(frequency),
            Err(refusal) => self.refuse(refusal),
        }
        self.free_cursor();
    }

    /// The frequency of the next peak or anti-resonance, Hz.
    ///
    /// # Errors
    /// Why there is none, in one line.
    fn next_turn(&self, turn: Turn, forward: bool) -> Result<f64, &'static str> {
        let Some((member, trace)) = self.curves.first_trace() else {
            return Err("no curve is visible");
        };
        let shown = |i: usize| {
            let frequency = member.frequencies[i];
            let value = self.display.value(trace, trace.values[i], frequency);
            if trace.dimension.is_none() {
                value.re
            } else {
                value.norm()
            }
        };
        let turns = |i: &usize| {
            let (before, here, after) = (shown(i - 1), shown(*i), shown(i + 1));
            match turn {
                Turn::Peak => here > before && here >= after,
                Turn::Dip => here < before && here <= after,
            }
        };
        let frequency = |i: usize| member.frequencies[i];
        let mut inner = 1..member.frequencies.len().saturating_sub(1);
        let found = match (forward, self.curves.cursor) {
            (true, from) => {
                inner.find(|i| turns(i) && from.is_none_or(|from| frequency(*i) > from))
            }
            (false, from) => {
                inner.rfind(|i| turns(i) && from.is_none_or(|from| frequency(*i) < from))
            }
        };
        found.map(frequency).ok_or(match turn {
            Turn::Peak => "the first curve has no other peak there",
            Turn::Dip => "the first curve has no other anti-resonance there",
        })
    }
}

//! Commands of the chart.

use std::sync::Arc;

use super::{Anchor, App};
use crate::model::{Group, Model};
use crate::tui::keys::Command;

/// Steps of the cursor from one end of the axis to the other, where nothing has been drawn yet.
const USUAL_COLUMNS: f64 = 100.0;

impl App {
    /// Changes what the chart shows; false where the command is another one.
    pub(super) fn change_chart(&mut self, command: Command) -> bool {
        match command {
            Command::Show => self.show_response(),
            Command::Solo => self.solo_response(),
            Command::Study => self.next_study(),
            Command::Decibels => {
                self.curves.decibels = !self.curves.decibels;
                self.turned.decibels = Some(self.curves.decibels);
            }
            Command::LogFrequency => self.curves.log_frequency = !self.curves.log_frequency,
            Command::Freeze => self.freeze(),
            Command::Unfreeze => self.unfreeze(),
            Command::Cursor(steps) => self.move_cursor(steps),
            Command::NextPeak => self.seek(Turn::Peak, true),
            Command::PreviousPeak => self.seek(Turn::Peak, false),
            Command::NextDip => self.seek(Turn::Dip, true),
            Command::PreviousDip => self.seek(Turn::Dip, false),
            Command::Cancel => self.take_away(),
            _ => return false,
        }
        if matches!(
            command,
            Command::Cursor(_)
                | Command::NextPeak
                | Command::PreviousPeak
                | Command::NextDip
                | Command::PreviousDip
                | Command::Cancel
        ) {
            self.anchor = Anchor::Frequency;
            self.reveal_cursor();
        }
        true
    }

    /// Ends the search of the tree, or takes the cursor off the chart.
    fn take_away(&mut self) {
        if self.search.take().is_none() && self.curves.cursor.take().is_none() {
            self.refuse("there is no count, search or cursor to take away");
        }
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
            let key = self.keys.key_of(Command::Enable);
            self.refuse(format!("{name} is disabled: {key} enables it"));
            return None;
        }
        Some(name)
    }

    fn show_response(&mut self) {
        if let Some(name) = self.response() {
            let shows = self.curves.toggle(&name);
            self.done(format!(
                "{name} {}",
                if shows { "shows" } else { "is hidden" }
            ));
        }
    }

    fn solo_response(&mut self) {
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

    fn next_study(&mut self) {
        let model = Arc::clone(self.document.model());
        if model.studies.is_empty() {
            self.refuse("the model has no studies");
            return;
        }
        let next = self.curves.study.map_or(0, |study| study + 1);
        self.show_study((next < model.studies.len()).then_some(next), &model);
    }

    pub(super) fn show_study(&mut self, study: Option<usize>, model: &Model) {
        self.curves.study = study;
        self.done(match study {
            Some(i) => format!("study: {}", model.studies[i].name),
            None => "the model alone, no study".to_owned(),
        });
    }

    /// Moves the cursor along the frequency axis by columns of the chart; it first appears in the middle.
    pub(super) fn move_cursor(&mut self, steps: i32) {
        let sweep = self.model().sweep;
        let before = self.curves.cursor;
        let shown = self.shown_frequencies();
        let log = self.curves.log_frequency;
        let place = |frequency: f64| if log { frequency.ln() } else { frequency };
        let (low, high) = (place(shown[0]), place(shown[1]));
        let columns = self.screen.plot.as_ref().map(|plot| plot.frequencies.len());
        let columns = columns.map_or(USUAL_COLUMNS, |columns| columns.max(2) as f64 - 1.0);
        let new = match self.curves.cursor {
            Some(old) => place(old) + f64::from(steps) * (high - low) / columns,
            None => f64::midpoint(low, high),
        };
        let new = if log { new.exp() } else { new };
        self.curves.cursor = Some(new.clamp(sweep.from, sweep.to));
        if self.curves.cursor == before {
            self.refuse("the sweep ends here");
        }
    }

    /// Puts the cursor at a frequency, Hz.
    pub(super) fn put_cursor(&mut self, frequency: f64) {
        self.curves.cursor = Some(frequency);
        self.anchor = Anchor::Frequency;
        self.reveal_cursor();
    }

    /// Moves the cursor to the next peak or anti-resonance of the first curve, as it is shown.
    fn seek(&mut self, turn: Turn, forward: bool) {
        let Some((member, trace)) = self.curves.first_trace() else {
            return self.refuse("no curve shows");
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
        match found.map(frequency) {
            Some(frequency) => self.curves.cursor = Some(frequency),
            None => self.refuse(match turn {
                Turn::Peak => "the first curve has no further peak there",
                Turn::Dip => "the first curve has no further anti-resonance there",
            }),
        }
    }
}

/// Where a curve turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Turn {
    Peak,
    Dip,
}

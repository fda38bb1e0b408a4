//! Commands of the chart.

use std::sync::Arc;

use super::{Anchor, App, Shown};
use crate::model::Model;
use crate::tui::keys::Command;
use crate::tui::tree::{self, Node};

/// Steps of the cursor from one end of the axis to the other.
const CURSOR_STEPS: f64 = 200.0;

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
            Command::NextExtremum => self.seek_extremum(true),
            Command::PreviousExtremum => self.seek_extremum(false),
            Command::Cancel => self.take_away(),
            _ => return false,
        }
        if matches!(
            command,
            Command::Cursor(_)
                | Command::NextExtremum
                | Command::PreviousExtremum
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
        let Some(Node::Response(i)) = tree::item(self.selection.node()) else {
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

    /// Moves the cursor along the frequency axis; it first appears in the middle.
    fn move_cursor(&mut self, steps: i32) {
        let sweep = self.model().sweep;
        let before = self.curves.cursor;
        let shown = self.shown_frequencies();
        let place = |frequency: f64| {
            if self.curves.log_frequency {
                frequency.ln()
            } else {
                frequency
            }
        };
        let (low, high) = (place(shown[0]), place(shown[1]));
        let new = match self.curves.cursor {
            Some(old) => place(old) + f64::from(steps) * (high - low) / CURSOR_STEPS,
            None => f64::midpoint(low, high),
        };
        let new = if self.curves.log_frequency {
            new.exp()
        } else {
            new
        };
        self.curves.cursor = Some(new.clamp(sweep.from, sweep.to));
        if self.curves.cursor == before {
            self.refuse("the sweep ends here");
        }
    }

    /// Moves the cursor to the next peak or dip of the first curve.
    fn seek_extremum(&mut self, forward: bool) {
        let Some((member, trace)) = self.curves.first_trace() else {
            return self.refuse("no curve shows");
        };
        let levels = &trace.magnitudes;
        let turns = |i: &usize| (levels[*i] - levels[i - 1]) * (levels[i + 1] - levels[*i]) < 0.0;
        let frequency = |i: usize| member.frequencies[i];
        let mut inner = 1..levels.len().saturating_sub(1);
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
            None => self.refuse("the first curve has no further peak or dip there"),
        }
    }

    fn freeze(&mut self) {
        match (&self.curves.shown, self.curves.picture()) {
            (Shown::Picture(_), Some(picture)) => {
                self.curves.reference = Some(Arc::clone(picture));
                self.document.seal();
                let key = self.keys.key_of(Command::Unfreeze);
                self.done(format!(
                    "curves frozen as a dotted reference; {key} drops it"
                ));
            }
            _ => self.refuse("there are no curves to freeze yet"),
        }
    }

    fn unfreeze(&mut self) {
        if self.curves.reference.take().is_some() {
            self.done("reference dropped");
        } else {
            let key = self.keys.key_of(Command::Freeze);
            self.refuse(format!("no reference is frozen; {key} freezes one"));
        }
    }
}

//! Moves in the tables, and lets the cursor follow their selected rows.

use super::selected::{Chosen, Place, Selected, follow};
use super::{Anchor, Table};
use crate::solve::peaks::Peak;
use crate::tui::app::{App, Curves, List};
use crate::tui::keys::{ModesCommand, Movement};

impl App {
    /// The peaks of the first visible curve, as resolved last.
    pub fn peaks(&self) -> &[Peak] {
        self.curves.peaks()
    }

    /// Moves in the open table.
    pub(crate) fn move_in_table(&mut self, table: Table, movement: Movement) {
        let list = self.tables.list_mut(table);
        let before = list.row;
        list.go(movement);
        if list.row == before {
            self.refuse(movement.at_end());
        }
        if let Some(anchor) = Anchor::of(table) {
            self.tables.anchor = anchor;
            self.follow_anchor();
        }
        if table == Table::Sensitivities {
            self.follow_sensitivity();
        }
    }

    /// Selects the next mode on the axis, from the cursor.
    pub(crate) fn seek_mode(&mut self, forward: bool) {
        let sweep = self.model().sweep;
        let Some(list) = &self.modes.list else {
            return self.refuse("the modes are not solved yet");
        };
        let frequency = |i: usize| list.rows[i].frequency;
        let shown = |i: &usize| (sweep.from..=sweep.to).contains(&frequency(*i));
        let (row, cursor) = (self.tables.modes.row, self.curves.cursor);
        // Modes may share a frequency: from a mode at the cursor, go by index.
        let at_mode = row < list.rows.len() && cursor == Some(frequency(row));
        let beyond = |i: &usize| match (cursor, forward) {
            (Some(_), true) if at_mode => *i > row,
            (Some(_), false) if at_mode => *i < row,
            (Some(cursor), true) => frequency(*i) > cursor,
            (Some(cursor), false) => frequency(*i) < cursor,
            (None, _) => true,
        };
        let mut candidates = (0..list.rows.len()).filter(|i| shown(i) && beyond(i));
        let found = if forward {
            candidates.next()
        } else {
            candidates.next_back()
        };
        match found {
            Some(found) => {
                self.tables.modes.row = found;
                self.tables.anchor = Anchor::Mode;
                self.follow_anchor();
                self.say_mode(found);
            }
            None if list.rows.is_empty() => {
                let to = self.display.frequency_text(list.to);
                self.refuse(format!("there is no mode below {to}"));
            }
            None => self.refuse("there is no next mode in the sweep"),
        }
    }

    fn say_mode(&mut self, index: usize) {
        let Some(list) = &self.modes.list else {
            return;
        };
        let (mode, all) = (&list.rows[index], list.rows.len());
        let frequency = self.display.frequency_text(mode.frequency);
        let number = index + 1;
        self.done(format!("mode {number} of {all}: {frequency}"));
    }

    pub(crate) fn toggle_fem_overlay(&mut self) {
        if self.fem_overlay.toggle() {
            self.requests.fem = None;
            let key = self.keys.key_of(ModesCommand::FiniteElements);
            self.done(format!("finite elements as points; {key} hides them"));
        } else {
            self.done("finite elements hidden");
        }
    }

    /// Moves the cursor to its anchor; removes it if the anchor is not on the axis.
    pub(crate) fn follow_anchor(&mut self) {
        let frequency = match self.tables.anchor {
            Anchor::Frequency => return,
            Anchor::Mode => self
                .modes
                .list
                .as_ref()
                .and_then(|list| list.rows.get(self.tables.modes.row))
                .map(|row| row.frequency),
            Anchor::Peak => self
                .curves
                .peaks()
                .get(self.tables.peaks.row)
                .map(|peak| peak.frequency),
        };
        let sweep = self.model().sweep;
        self.curves.cursor = frequency.filter(|f| (sweep.from..=sweep.to).contains(f));
        self.curves.reveal_cursor(&sweep);
    }

    /// Lets the selected rows and the cursor follow new modes and peaks: each goes to the nearest one.
    pub(crate) fn follow_solution(&mut self, before: &Selected) {
        let is_same_model = before.generation == self.modes.generation();
        let (modes, peaks) = (self.modes.places(), peak_places(&self.curves));
        follow(&mut self.tables.modes, &modes, before.mode, is_same_model);
        follow(&mut self.tables.peaks, &peaks, before.peak, is_same_model);
        self.follow_anchor();
    }

    /// The selection of the tables.
    pub(crate) fn selected(&self) -> Selected {
        let at = |places: &[Place], list: List| Chosen::new(places, list.row);
        Selected {
            generation: self.modes.generation(),
            mode: at(&self.modes.places(), self.tables.modes),
            peak: at(&peak_places(&self.curves), self.tables.peaks),
        }
    }
}

fn peak_places(curves: &Curves) -> Vec<Place> {
    let peaks = curves.peaks().iter();
    peaks.map(|peak| [peak.frequency, 0.0]).collect()
}

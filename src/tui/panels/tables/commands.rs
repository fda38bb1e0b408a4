//! The tables below the chart: which one is open, its selected row, and the cursor that follows it.

use super::selected::{Chosen, Place, Selected, follow};

use crate::solve::peaks::Peak;
use crate::tui::app::{App, List};
use crate::tui::keys::{ModesCommand, Movement};

/// A table below the chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Table {
    /// The modes of the model.
    Modes,
    /// The peaks of the first visible curve.
    Peaks,
    /// The values of the curves at the cursors.
    Readings,
    /// The levels in the marked band.
    Band,
    /// The sensitivities.
    Sensitivities,
    /// The search for better parameters.
    Tuning,
}

impl Table {
    /// Every table.
    pub const ALL: [Self; 6] = [
        Self::Modes,
        Self::Peaks,
        Self::Readings,
        Self::Band,
        Self::Sensitivities,
        Self::Tuning,
    ];

    /// Its word in the stored view state.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Modes => "modes",
            Self::Peaks => "peaks",
            Self::Readings => "readings",
            Self::Band => "band",
            Self::Sensitivities => "sensitivities",
            Self::Tuning => "tuning",
        }
    }
}

/// The tables' state.
#[derive(Debug, Clone, Copy, Default)]
pub struct Tables {
    /// The open table.
    pub open: Option<Table>,
    /// The modes; one is selected even if the table is closed.
    pub modes: List,
    /// The peaks.
    pub peaks: List,
    /// The readings.
    pub readings: List,
    /// The levels.
    pub band: List,
    /// The sensitivities.
    pub sensitivities: List,
    /// The variables of a search.
    pub tuning: List,
}

/// What the chart's cursor follows when the model changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Anchor {
    /// Its frequency.
    #[default]
    Frequency,
    /// The selected mode.
    Mode,
    /// The selected peak.
    Peak,
}

impl Tables {
    /// The list of a table.
    pub fn list_mut(&mut self, table: Table) -> &mut List {
        match table {
            Table::Modes => &mut self.modes,
            Table::Peaks => &mut self.peaks,
            Table::Readings => &mut self.readings,
            Table::Band => &mut self.band,
            Table::Sensitivities => &mut self.sensitivities,
            Table::Tuning => &mut self.tuning,
        }
    }
}

impl Anchor {
    /// The frequency of the selected row of a table, if it has one.
    pub(crate) const fn of(table: Table) -> Option<Self> {
        match table {
            Table::Modes => Some(Self::Mode),
            Table::Peaks => Some(Self::Peak),
            Table::Readings | Table::Band | Table::Sensitivities | Table::Tuning => None,
        }
    }
}

impl App {
    /// Moves in the open table.
    pub(crate) fn move_in_table(&mut self, table: Table, movement: Movement) {
        let list = self.tables.list_mut(table);
        let before = list.row;
        list.go(movement);
        if list.row == before {
            self.refuse(movement.at_end());
        }
        if let Some(anchor) = Anchor::of(table) {
            self.anchor = anchor;
            self.follow_anchor();
        }
        if table == Table::Sensitivities {
            self.follow_sensitivity();
        }
    }

    pub(crate) fn toggle_table(&mut self, table: Table) {
        self.tables.open = (self.tables.open != Some(table)).then_some(table);
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
                self.anchor = Anchor::Mode;
                self.follow_anchor();
                self.say_mode(found);
            }
            None if list.rows.is_empty() => {
                let to = self.display.frequency_text(list.to);
                self.refuse(format!("there is no mode below {to}"));
            }
            None => self.refuse("there is no further mode in the sweep"),
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
            self.fem_requested = None;
            let key = self.keys.key_of(ModesCommand::FiniteElements);
            self.done(format!(
                "finite elements as points; {key} leaves them out again"
            ));
        } else {
            self.done("without finite elements");
        }
    }

    /// The peaks of the first visible curve, as resolved last.
    pub fn peaks(&self) -> &[Peak] {
        self.curves
            .first_resolved()
            .map_or(&[], |(_, trace)| &trace.peaks)
    }

    /// Moves the cursor to its anchor; removes it if the anchor is not on the axis.
    pub(crate) fn follow_anchor(&mut self) {
        let frequency = match self.anchor {
            Anchor::Frequency => return,
            Anchor::Mode => self
                .modes
                .list
                .as_ref()
                .and_then(|list| list.rows.get(self.tables.modes.row))
                .map(|row| row.frequency),
            Anchor::Peak => self
                .peaks()
                .get(self.tables.peaks.row)
                .map(|peak| peak.frequency),
        };
        let sweep = self.model().sweep;
        self.curves.cursor = frequency.filter(|f| (sweep.from..=sweep.to).contains(f));
        self.reveal_cursor();
    }

    /// Lets the selected rows and the cursor follow new modes and peaks: each goes to the nearest one.
    pub(crate) fn follow_solution(&mut self, before: &Selected) {
        let is_same_model = before.generation == self.modes.generation();
        let (modes, peaks) = (self.mode_places(), self.peak_places());
        follow(&mut self.tables.modes, &modes, before.mode, is_same_model);
        follow(&mut self.tables.peaks, &peaks, before.peak, is_same_model);
        self.follow_anchor();
    }

    /// The selection of the tables.
    pub(crate) fn selected(&self) -> Selected {
        let at = |places: &[Place], list: List| Chosen::new(places, list.row);
        Selected {
            generation: self.modes.generation(),
            mode: at(&self.mode_places(), self.tables.modes),
            peak: at(&self.peak_places(), self.tables.peaks),
        }
    }

    fn mode_places(&self) -> Vec<Place> {
        let rows = self.modes.list.as_ref().map_or(&[][..], |list| &list.rows);
        rows.iter()
            .map(|row| [row.frequency, row.frequency * row.damping_ratio])
            .collect()
    }

    fn peak_places(&self) -> Vec<Place> {
        let peaks = self.peaks().iter();
        peaks.map(|peak| [peak.frequency, 0.0]).collect()
    }
}

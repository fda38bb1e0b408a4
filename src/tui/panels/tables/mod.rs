//! The tables below the chart: which one is open, its selected row, and the cursor that follows it.

mod commands;
mod selected;

use crate::tui::app::list::List;
use crate::words::words;

words! {
    /// A table below the chart; its words are in the stored view state.
    pub enum Table {
        /// The modes of the model.
        Modes = "modes",
        /// The peaks of the first visible curve.
        Peaks = "peaks",
        /// The values of the curves at the cursors.
        Readings = "readings",
        /// The levels in the marked band.
        Band = "band",
        /// The sensitivities.
        Sensitivities = "sensitivities",
        /// The search for better parameters.
        Tuning = "tuning",
    }
}

/// The tables' state.
#[derive(Debug, Clone, Copy, Default)]
pub struct Tables {
    /// The open table.
    pub open: Option<Table>,
    /// What the chart's cursor follows.
    pub anchor: Anchor,
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

    /// Opens a table, or closes it if it is open.
    pub(crate) fn toggle(&mut self, table: Table) {
        self.open = (self.open != Some(table)).then_some(table);
    }

    /// Closes a table, if it is open.
    pub(crate) fn close(&mut self, table: Table) {
        if self.open == Some(table) {
            self.open = None;
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

//! The tables below the chart: which one is open, its selected row, and the cursor that follows it.

mod commands;
mod selected;

use crate::tui::app::list::List;

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

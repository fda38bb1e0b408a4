//! A list with one selected row.

use crate::tui::keys::Movement;

/// A list with one selected row.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct List {
    /// The selected row, or the first visible one where none is selected.
    pub row: usize,
    /// How many rows there are.
    pub rows: usize,
    /// The number of visible rows; known after the first drawing.
    pub height: usize,
}

impl List {
    /// A list with this many rows.
    pub fn new(rows: usize, row: usize) -> Self {
        Self {
            row,
            rows,
            height: 1,
        }
    }

    /// The first visible row; keeps the selected one near the middle.
    pub fn first(&self) -> usize {
        let last = self.rows.saturating_sub(self.height);
        self.row.saturating_sub(self.height / 2).min(last)
    }

    /// Sets the number of rows.
    pub fn set_rows(&mut self, rows: usize) {
        self.rows = rows;
        self.row = self.row.min(rows.saturating_sub(1));
    }

    /// Moves by a screen.
    pub fn page(&mut self, forward: bool) {
        let rows = self.height.saturating_sub(1).max(1).cast_signed();
        self.step(if forward { rows } else { -rows });
    }

    /// Moves the selection.
    pub fn go(&mut self, movement: Movement) {
        match movement {
            Movement::Up => self.step(-1),
            Movement::Down => self.step(1),
            Movement::PageUp => self.page(false),
            Movement::PageDown => self.page(true),
            Movement::First => self.step(isize::MIN),
            Movement::Last => self.step(isize::MAX),
        }
    }

    /// Moves by rows; stops at the ends.
    pub fn step(&mut self, rows: isize) {
        self.row = self
            .row
            .saturating_add_signed(rows)
            .min(self.rows.saturating_sub(1));
    }
}

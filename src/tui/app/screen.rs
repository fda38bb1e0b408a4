//! Where things are on the screen: for the mouse, and for all that depends on how much of a list shows.

use ratatui::layout::{Position, Rect};

use super::{App, List, Overlay, Tables};

/// Rows of a list on the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rows {
    /// Where they are.
    pub area: Rect,
    /// The list's row in the topmost of them.
    pub first: usize,
}

impl Rows {
    /// The list's row at a place.
    pub fn at(&self, place: Position) -> Option<usize> {
        let below = usize::from(place.y.checked_sub(self.area.y)?);
        self.area.contains(place).then_some(self.first + below)
    }
}

/// The curves on the screen.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Where they are.
    pub area: Rect,
    /// The frequency in the middle of each column, Hz.
    pub frequencies: Vec<f64>,
}

impl Plot {
    /// The frequency (Hz) at a place.
    pub fn frequency(&self, place: Position) -> Option<f64> {
        let column = usize::from(place.x.checked_sub(self.area.x)?);
        let frequency = self.frequencies.get(column).copied();
        frequency.filter(|_| self.area.contains(place))
    }
}

/// The value axis of the chart, or of the upper of two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Levels {
    /// What it spans, values on the axis.
    pub bounds: [f64; 2],
    /// Whether it is logarithmic.
    pub log: bool,
}

/// Where things are on the screen, as it was drawn last. Drawing returns it.
#[derive(Debug, Clone, Default)]
pub struct Screen {
    /// All of it.
    pub area: Rect,
    /// The tree.
    pub tree: Rows,
    /// What is said of the selected row.
    pub details: Rect,
    /// The chart's curves.
    pub plot: Option<Plot>,
    /// The chart's value axis.
    pub levels: Option<Levels>,
    /// The table below the chart.
    pub table: Option<Rows>,
    /// The tables' lists: how many rows they have and there is room for.
    pub tables: Tables,
    /// The rows of the open dialog that can be clicked.
    pub list: Option<Rows>,
    /// The list of the open dialog: how many rows it has and there is room for.
    pub dialog: Option<List>,
}

impl App {
    /// Stores where things are on a screen that was drawn; none where it is too small to show anything.
    pub fn drawn(&mut self, screen: Option<Screen>) {
        self.unseen = screen.is_none();
        let Some(screen) = screen else {
            return;
        };
        if screen.tree.area.height > 0 {
            self.selection.set_height(screen.tree.area.height.into());
        }
        self.tables = screen.tables;
        if let (Some(list), Some(drawn)) =
            (self.overlay.as_mut().and_then(Overlay::list), screen.dialog)
        {
            *list = drawn;
        }
        self.screen = screen;
    }
}

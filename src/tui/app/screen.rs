//! Positions on the screen, for the mouse and for everything that depends on the visible part of a list.

use ratatui::layout::{Position, Rect};

use super::list::List;
use crate::tui::panels::tables::Tables;

/// The visible rows of a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rows {
    /// Their area.
    pub area: Rect,
    /// The first visible row.
    pub first: usize,
}

impl Rows {
    /// The row at a place.
    pub fn at(&self, place: Position) -> Option<usize> {
        let below = usize::from(place.y.checked_sub(self.area.y)?);
        self.area.contains(place).then_some(self.first + below)
    }
}

/// The area of the curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// The area.
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

/// The value axis of the chart, or of its upper half.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Levels {
    /// Its range, in axis values.
    pub bounds: [f64; 2],
    /// Whether it is logarithmic.
    pub log: bool,
}

/// The positions of the last drawing. Drawing returns it.
#[derive(Debug, Clone, Default)]
pub struct Screen {
    /// The screen is too small to show anything; the positions are those of an earlier drawing then.
    pub unseen: bool,
    /// The whole screen.
    pub area: Rect,
    /// The tree.
    pub tree: Rows,
    /// The details of the selected row.
    pub details: Rect,
    /// The chart's curves.
    pub plot: Option<Plot>,
    /// The chart's value axis.
    pub levels: Option<Levels>,
    /// The table below the chart.
    pub table: Option<Rows>,
    /// The lists of the tables: their rows and visible heights.
    pub tables: Tables,
    /// The clickable rows of the open dialog.
    pub list: Option<Rows>,
    /// The list of the open dialog: its rows and visible height.
    pub dialog: Option<List>,
}

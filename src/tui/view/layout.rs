//! The areas of the panels on a screen.

use ratatui::layout::{Constraint, Layout, Rect};

/// The smallest supported screen, columns and rows.
pub const SMALLEST: (u16, u16) = (60, 18);
/// From this width on, the chart is to the right of the tree.
const BESIDE: u16 = 76;
/// From this height on, the details are below the tree.
const DETAILED: u16 = 20;
/// Rows of the details below the tree, including their rule.
const DETAILS: u16 = 6;

/// From this height of the right side on, the beam view is below the chart; else it replaces the chart.
const SHAPED: u16 = 20;
/// A table takes at most this share of the right side's height, in percent.
const TABLED: u16 = 45;

/// The areas of the panels. A hidden panel has no height.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Panels {
    pub(crate) status: Rect,
    pub(crate) tree: Rect,
    pub(crate) details: Rect,
    pub(crate) chart: Rect,
    pub(crate) shape: Rect,
    pub(crate) table: Rect,
    pub(crate) hints: Rect,
}

/// The optional panels next to tree and chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct OptionalPanels {
    /// The rows of the open table, if any.
    pub(crate) table: Option<u16>,
    pub(crate) shape: bool,
}

/// The panels of a screen; none if it is too small.
pub(crate) fn panels(area: Rect, wanted: OptionalPanels) -> Option<Panels> {
    if area.width < SMALLEST.0 || area.height < SMALLEST.1 {
        return None;
    }
    let [status, middle, hints] = Layout::vertical([
        Constraint::Length(1),
        Constraint::Fill(1),
        Constraint::Length(1),
    ])
    .areas(area);
    let mut panels = if area.width >= BESIDE {
        side_by_side(middle, wanted)
    } else {
        stacked(middle, wanted)
    };
    (panels.status, panels.hints) = (status, hints);
    if wanted.shape {
        let rows = if panels.chart.height >= SHAPED {
            panels.chart.height / 2
        } else {
            panels.chart.height
        };
        [panels.chart, panels.shape] =
            Layout::vertical([Constraint::Fill(1), Constraint::Length(rows)]).areas(panels.chart);
    }
    Some(panels)
}

/// Tree and details on the left, the chart with a table below it on the right.
fn side_by_side(area: Rect, wanted: OptionalPanels) -> Panels {
    let width = (area.width / 3).clamp(36, 42);
    let [left, right] =
        Layout::horizontal([Constraint::Length(width), Constraint::Fill(1)]).areas(area);
    let details = if area.height + 2 >= DETAILED {
        DETAILS
    } else {
        0
    };
    let [tree, details] =
        Layout::vertical([Constraint::Fill(1), Constraint::Length(details)]).areas(left);
    let rows = wanted
        .table
        .map_or(0, |rows| rows.min(right.height * TABLED / 100));
    let [chart, table] =
        Layout::vertical([Constraint::Fill(1), Constraint::Length(rows)]).areas(right);
    Panels {
        tree,
        details,
        chart,
        table,
        ..Panels::default()
    }
}

/// The chart at the top; below it tree and details, or instead a table.
fn stacked(area: Rect, wanted: OptionalPanels) -> Panels {
    let below = (area.height / 2).saturating_sub(1);
    let [chart, below] =
        Layout::vertical([Constraint::Fill(1), Constraint::Length(below)]).areas(area);
    let panels = Panels {
        chart,
        ..Panels::default()
    };
    if wanted.table.is_some() {
        return Panels {
            table: below,
            ..panels
        };
    }
    let [tree, details] =
        Layout::horizontal([Constraint::Length(36), Constraint::Fill(1)]).areas(below);
    Panels {
        tree,
        details,
        ..panels
    }
}

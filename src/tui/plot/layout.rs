//! Divides an area into heading, legend, axes and plot.

use ratatui::layout::Rect;

use super::chart::{Below, Chart};
use super::glyphs::rulers;
use super::legend::{self, LegendPosition};
use super::ticks::{Tick, ticks};

/// Fewest columns of a plot with value labels.
const LABELLED_COLUMNS: u16 = 10;
/// Fewest columns of an area with a value axis.
const AXIS_COLUMNS: u16 = 4;
/// Fewest rows of plot, axis and labels together with which marks get a row.
const MARKED_ROWS: u16 = 6;

/// The areas of the parts of a chart.
#[derive(Debug)]
pub(super) struct ChartLayout {
    pub(super) area: Rect,
    /// The row of the value axis's unit and the title.
    pub(super) heading: Option<Rect>,
    pub(super) legend: LegendPosition,
    pub(super) plot: Rect,
    /// The column of the value axis.
    pub(super) value_axis: Option<u16>,
    /// Columns for the value labels, left of the axis.
    pub(super) label_columns: u16,
    /// Rows below the plot: 0, 1 (axis), 2 (axis and labels) or 3 (also marks).
    pub(super) rows_below: u16,
    /// Ticks across and down the plot.
    pub(super) ticks: [Vec<Tick>; 2],
}

impl ChartLayout {
    pub(super) fn new(chart: &Chart<'_>, area: Rect) -> Self {
        let mut rest = area;
        let heading = (chart.has_heading() && rest.height >= 6).then(|| take_top(&mut rest));
        let rows_below = match rest.height {
            0..=2 => 0,
            3..=4 => 1,
            _ if chart.below == Below::Axis => 1,
            MARKED_ROWS.. if !chart.marks.values.is_empty() => 3,
            _ => 2,
        };
        rest.height -= rows_below;
        let mut label_columns = label_columns(chart, rest);
        let legend = legend::position(chart, right_of_axis(rest, label_columns).1, rest);
        if matches!(legend, LegendPosition::Line(_)) {
            take_top(&mut rest);
            label_columns = self::label_columns(chart, rest);
        }
        let (value_axis, plot) = right_of_axis(rest, label_columns);
        let [across, down] = rulers(plot.width, plot.height, chart.glyphs);
        let ticks = [ticks(&chart.x, across), ticks(&chart.y, down)];
        Self {
            area,
            heading,
            legend,
            plot,
            value_axis,
            label_columns,
            rows_below,
            ticks,
        }
    }
}

/// Removes the top row from an area and returns it.
fn take_top(rest: &mut Rect) -> Rect {
    let row = Rect { height: 1, ..*rest };
    rest.y += 1;
    rest.height -= 1;
    row
}

/// The columns of the value labels; 0 if they would leave too few for the plot.
fn label_columns(chart: &Chart<'_>, rest: Rect) -> u16 {
    let [_, down] = rulers(rest.width, rest.height, chart.glyphs);
    let labels = ticks(&chart.y, down)
        .into_iter()
        .filter_map(|tick| tick.label);
    let widest = labels.map(|label| label.len() as u16).max().unwrap_or(0);
    let widest = widest.max(chart.label_columns);
    if rest.width > widest + LABELLED_COLUMNS {
        widest
    } else {
        0
    }
}

/// The column of the value axis, if there is room for it, and the plot on its right.
fn right_of_axis(rest: Rect, label_columns: u16) -> (Option<u16>, Rect) {
    if rest.width < AXIS_COLUMNS {
        return (None, rest);
    }
    let used = label_columns + 1;
    let plot = Rect {
        x: rest.x + used,
        width: rest.width - used,
        ..rest
    };
    (Some(rest.x + label_columns), plot)
}

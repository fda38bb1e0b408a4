//! What stands in each cell of the plot: a sign, a curve, a line at a value, or the grid.

use ratatui::buffer::Buffer;
use ratatui::layout::Position;
use ratatui::style::Style;
use ratatui::widgets::{Clear, Widget};

use super::chart::Chart;
use super::dots::Dots;
use super::glyphs::{Glyphs, rulers};
use super::layout::Layout;
use super::legend::Place;
use super::level::Level;
use super::trace::pole_cells;

/// A character and how it looks.
type Ink = (char, Style);

/// The lines behind the curves.
struct Behind {
    /// Columns with a line of their own; of several in one the first counts.
    columns: Vec<(u16, Ink)>,
    /// The column and the row of 0.
    zero: [Option<u16>; 2],
    /// The columns and the rows of the grid.
    grid: [Vec<u16>; 2],
}

/// Draws the curves with ratatui's canvas. What it covers in the legend's place is cleared.
pub(super) fn curves(chart: &Chart<'_>, layout: &Layout, dots: &Dots, buffer: &mut Buffer) {
    let colour = |index: usize| chart.curves[index].ink().fg.unwrap_or_default();
    dots.render(layout.plot, buffer, |index| chart.grid_of(index), colour);
    if let Place::Inside(legend) = layout.legend {
        Clear.render(legend, buffer);
    }
}

/// Completes the plot cell by cell: styles and markers of the curves, the lines behind them, the signs over them.
pub(super) fn paint(chart: &Chart<'_>, layout: &Layout, dots: &Dots, buffer: &mut Buffer) {
    let behind = Behind::new(chart, layout);
    let poles = pole_cells(chart, dots.across);
    for position in layout.plot.positions() {
        if in_legend(layout, position) {
            continue;
        }
        let (column, row) = (position.x - layout.plot.x, position.y - layout.plot.y);
        let Some(cell) = buffer.cell_mut(position) else {
            continue;
        };
        let drawn = dots.cell(column, row);
        let pole = poles.iter().find(|pole| row == 0 && pole.0 == column);
        if let Some((_, index)) = pole {
            let (glyph, style) = pole_ink(chart, *index);
            cell.set_char(glyph).set_style(style);
        } else if let Some(index) = drawn.curve {
            cell.set_style(chart.curves[index].ink());
            if let Some(marker) = chart.marker(index).filter(|_| drawn.marked) {
                cell.set_char(marker);
            }
        } else if let Some((glyph, style)) = behind.ink(chart, column, row) {
            cell.set_char(glyph).set_style(style);
        }
    }
    number_harmonics(chart, layout, dots, buffer);
    for spot in &chart.spots {
        let column = dots.across.cell(chart.x.fraction(spot.x));
        let row = dots.down.cell(chart.y.fraction(spot.y));
        let place = column
            .zip(row)
            .map(|(column, row)| Position::new(layout.plot.x + column, layout.plot.y + row));
        let free = place.filter(|place| !in_legend(layout, *place));
        if let Some(cell) = free.and_then(|place| buffer.cell_mut(place)) {
            cell.set_char(spot.sign).set_style(spot.style);
        }
    }
}

fn in_legend(layout: &Layout, position: Position) -> bool {
    matches!(layout.legend, Place::Inside(legend) if legend.contains(position))
}

/// The number of each harmonic at the top of its line, where nothing else is.
fn number_harmonics(chart: &Chart<'_>, layout: &Layout, dots: &Dots, buffer: &mut Buffer) {
    let plot = layout.plot;
    let mut free = 0;
    for (number, value) in (2..).zip(&chart.harmonics) {
        let text = format!("{number}");
        let Some(start) = chart.cell(plot, *value) else {
            continue;
        };
        let cells = start..start.saturating_add(text.len() as u16);
        let blank = |column: u16| {
            let position = Position::new(plot.x + column, plot.y);
            column < plot.width
                && dots.cell(column, 0).curve.is_none()
                && !in_legend(layout, position)
        };
        if plot.height > 1 && start >= free && cells.clone().all(blank) {
            buffer.set_string(plot.x + start, plot.y, &text, chart.styles.harmonic);
            free = cells.end + 1;
        }
    }
}

fn pole_ink(chart: &Chart<'_>, index: usize) -> Ink {
    let glyph = if chart.glyphs == Glyphs::Ascii {
        '^'
    } else {
        '↑'
    };
    (glyph, chart.curves[index].ink())
}

impl Behind {
    fn new(chart: &Chart<'_>, layout: &Layout) -> Self {
        let ascii = chart.glyphs == Glyphs::Ascii;
        let [cursor, second, harmonic, low, high] = if ascii {
            ['|', ':', '\'', '[', ']']
        } else {
            ['│', '┆', '┊', '╎', '╎']
        };
        let styles = &chart.styles;
        let band = chart
            .band
            .into_iter()
            .flat_map(|[from, to]| [(from, (low, styles.band)), (to, (high, styles.band))]);
        let harmonics = chart.harmonics.iter();
        let lines = chart
            .cursor
            .map(|value| (value, (cursor, styles.cursor)))
            .into_iter()
            .chain(chart.second.map(|value| (value, (second, styles.cursor))))
            .chain(band)
            .chain(harmonics.map(|value| (*value, (harmonic, styles.harmonic))));
        let columns = lines
            .filter_map(|(value, ink)| Some((chart.cell(layout.plot, value)?, ink)))
            .collect();
        Self {
            columns,
            zero: zero(chart, layout),
            grid: grid(chart, layout),
        }
    }

    fn ink(&self, chart: &Chart<'_>, column: u16, row: u16) -> Option<Ink> {
        let line = self.columns.iter().find(|line| line.0 == column);
        line.map(|line| line.1)
            .or_else(|| self.zero_ink(chart, column, row))
            .or_else(|| self.grid_ink(chart, column, row))
    }

    fn zero_ink(&self, chart: &Chart<'_>, column: u16, row: u16) -> Option<Ink> {
        let on_line = [self.zero[0] == Some(column), self.zero[1] == Some(row)];
        let glyph = match (chart.glyphs, on_line) {
            (_, [false, false]) => None,
            (Glyphs::Ascii, [true, true]) => Some('+'),
            (Glyphs::Ascii, [true, false]) => Some(':'),
            // With gaps, not to pass for a curve.
            (Glyphs::Ascii, [false, true]) => column.is_multiple_of(2).then_some('-'),
            (_, [true, false]) => Some('┊'),
            (_, [false, true]) => Some('┈'),
            (_, [true, true]) => Some('┼'),
        };
        glyph.map(|glyph| (glyph, chart.styles.grid))
    }

    fn grid_ink(&self, chart: &Chart<'_>, column: u16, row: u16) -> Option<Ink> {
        // In the first column the axis is line enough.
        let on_grid = [
            column > 0 && self.grid[0].contains(&column),
            self.grid[1].contains(&row),
        ];
        let glyph = match (chart.glyphs, on_grid) {
            (_, [false, false]) => None,
            // Lines of ASCII characters would pass for curves.
            (Glyphs::Ascii, _) => (on_grid == [true, true]).then_some('+'),
            (_, [true, false]) => Some('┊'),
            (_, [false, true]) => Some('┈'),
            (_, [true, true]) => Some('┼'),
        };
        glyph.map(|glyph| (glyph, chart.styles.grid))
    }
}

/// The column and the row of 0, where it is inside an axis of signed values.
fn zero(chart: &Chart<'_>, layout: &Layout) -> [Option<u16>; 2] {
    let [across, down] = rulers(layout.plot.width, layout.plot.height, chart.glyphs);
    let inside = |[low, high]: [f64; 2]| low < 0.0 && high > 0.0;
    let column = chart.free && inside(chart.x.bounds());
    let row = chart.level == Level::Signed && inside(chart.y.bounds());
    [
        column.then(|| across.cell(chart.x.fraction(0.0))).flatten(),
        row.then(|| down.cell(chart.y.fraction(0.0))).flatten(),
    ]
}

/// The columns and the rows of the grid, if there is one.
fn grid(chart: &Chart<'_>, layout: &Layout) -> [Vec<u16>; 2] {
    [0, 1].map(|axis| {
        let major = layout.ticks[axis]
            .iter()
            .filter(|tick| chart.grid && tick.label.is_some());
        major.map(|tick| tick.cell).collect()
    })
}

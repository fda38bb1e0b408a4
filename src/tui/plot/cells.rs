//! The content of each cell of the plot: a symbol, a curve, a line at a value, or the grid.

use ratatui::buffer::Buffer;
use ratatui::layout::Position;
use ratatui::style::Style;
use ratatui::widgets::{Clear, Widget};

use super::chart::Chart;
use super::dots::Dots;
use super::glyphs::{Glyphs, rulers};
use super::layout::ChartLayout;
use super::legend::LegendPosition;
use super::level::Level;
use super::trace::pole_cells;

/// A character and its style.
type StyledChar = (char, Style);

/// The lines behind the curves.
struct Background {
    /// Columns with a vertical line; in a column with several, the first wins.
    columns: Vec<(u16, StyledChar)>,
    /// The column and the row of 0.
    zero: [Option<u16>; 2],
    /// The columns and the rows of the grid.
    grid: [Vec<u16>; 2],
}

/// Draws the curves with ratatui's canvas, then clears the area of the legend.
pub(super) fn curves(chart: &Chart<'_>, layout: &ChartLayout, dots: &Dots, buffer: &mut Buffer) {
    let colour = |index: usize| chart.curves[index].dimmed_style().fg.unwrap_or_default();
    dots.render(layout.plot, buffer, |index| chart.grid_of(index), colour);
    if let LegendPosition::Inside(legend) = layout.legend {
        Clear.render(legend, buffer);
    }
}

/// Completes the plot cell by cell: styles and markers of the curves, lines behind them, symbols over them.
pub(super) fn paint(chart: &Chart<'_>, layout: &ChartLayout, dots: &Dots, buffer: &mut Buffer) {
    let background = Background::new(chart, layout);
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
            let (glyph, style) = pole_mark(chart, *index);
            cell.set_char(glyph).set_style(style);
        } else if let Some(index) = drawn.curve {
            cell.set_style(chart.curves[index].dimmed_style());
            if let Some(marker) = chart.marker(index).filter(|_| drawn.marked) {
                cell.set_char(marker);
            }
        } else if let Some((glyph, style)) = background.at(chart, column, row) {
            cell.set_char(glyph).set_style(style);
        }
    }
    number_harmonics(chart, layout, dots, buffer);
    for spot in &chart.spots {
        let column = dots.across.cell(chart.x.fraction(spot.x));
        let row = dots.down.cell(chart.y.fraction(spot.y));
        let position = column
            .zip(row)
            .map(|(column, row)| Position::new(layout.plot.x + column, layout.plot.y + row));
        let free = position.filter(|position| !in_legend(layout, *position));
        if let Some(cell) = free.and_then(|position| buffer.cell_mut(position)) {
            cell.set_char(spot.sign).set_style(spot.style);
        }
    }
}

fn in_legend(layout: &ChartLayout, position: Position) -> bool {
    matches!(layout.legend, LegendPosition::Inside(legend) if legend.contains(position))
}

/// Writes the number of each harmonic at the top of its line, where the cells are free.
fn number_harmonics(chart: &Chart<'_>, layout: &ChartLayout, dots: &Dots, buffer: &mut Buffer) {
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

fn pole_mark(chart: &Chart<'_>, index: usize) -> StyledChar {
    let glyph = if chart.glyphs == Glyphs::Ascii {
        '^'
    } else {
        '↑'
    };
    (glyph, chart.curves[index].dimmed_style())
}

impl Background {
    fn new(chart: &Chart<'_>, layout: &ChartLayout) -> Self {
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
            .filter_map(|(value, mark)| Some((chart.cell(layout.plot, value)?, mark)))
            .collect();
        Self {
            columns,
            zero: zero(chart, layout),
            grid: grid(chart, layout),
        }
    }

    fn at(&self, chart: &Chart<'_>, column: u16, row: u16) -> Option<StyledChar> {
        let line = self.columns.iter().find(|line| line.0 == column);
        line.map(|line| line.1)
            .or_else(|| self.zero_line(chart, column, row))
            .or_else(|| self.grid_line(chart, column, row))
    }

    fn zero_line(&self, chart: &Chart<'_>, column: u16, row: u16) -> Option<StyledChar> {
        let on_line = [self.zero[0] == Some(column), self.zero[1] == Some(row)];
        let glyph = match (chart.glyphs, on_line) {
            (_, [false, false]) => None,
            (Glyphs::Ascii, [true, true]) => Some('+'),
            (Glyphs::Ascii, [true, false]) => Some(':'),
            // With gaps, so that it does not look like a curve.
            (Glyphs::Ascii, [false, true]) => column.is_multiple_of(2).then_some('-'),
            (_, [true, false]) => Some('┊'),
            (_, [false, true]) => Some('┈'),
            (_, [true, true]) => Some('┼'),
        };
        glyph.map(|glyph| (glyph, chart.styles.grid))
    }

    fn grid_line(&self, chart: &Chart<'_>, column: u16, row: u16) -> Option<StyledChar> {
        // The first column is next to the axis line.
        let on_grid = [
            column > 0 && self.grid[0].contains(&column),
            self.grid[1].contains(&row),
        ];
        let glyph = match (chart.glyphs, on_grid) {
            (_, [false, false]) => None,
            // Lines of ASCII characters would look like curves.
            (Glyphs::Ascii, _) => (on_grid == [true, true]).then_some('+'),
            (_, [true, false]) => Some('┊'),
            (_, [false, true]) => Some('┈'),
            (_, [true, true]) => Some('┼'),
        };
        glyph.map(|glyph| (glyph, chart.styles.grid))
    }
}

/// The column and the row of 0, where 0 is inside an axis of signed values.
fn zero(chart: &Chart<'_>, layout: &ChartLayout) -> [Option<u16>; 2] {
    let [across, down] = rulers(layout.plot.width, layout.plot.height, chart.glyphs);
    let inside = |[low, high]: [f64; 2]| low < 0.0 && high > 0.0;
    let column = chart.nyquist && inside(chart.x.bounds());
    let row = chart.level == Level::Signed && inside(chart.y.bounds());
    [
        column.then(|| across.cell(chart.x.fraction(0.0))).flatten(),
        row.then(|| down.cell(chart.y.fraction(0.0))).flatten(),
    ]
}

/// The columns and the rows of the grid; none if it is off.
fn grid(chart: &Chart<'_>, layout: &ChartLayout) -> [Vec<u16>; 2] {
    [0, 1].map(|axis| {
        let major = layout.ticks[axis]
            .iter()
            .filter(|tick| chart.grid && tick.label.is_some());
        major.map(|tick| tick.cell).collect()
    })
}

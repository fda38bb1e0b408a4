//! The chart widget.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::widgets::Widget;

use super::axis::{Axis, Ruler};
use super::curve::{Curve, Level, LineStyle};
use super::dots::{Dots, rulers};
use super::frame;
use super::layout::Layout;
use super::legend::{self, Legend, Place};
use super::markers::mark;
use super::pen::Pen;

/// The characters a chart is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Glyphs {
    /// Curves in braille dots, 2 x 4 a cell; axes in box-drawing characters.
    #[default]
    Braille,
    /// Curves in quarters of cells; axes as with braille.
    Block,
    /// Curves of a bullet a cell; axes as with braille.
    Dot,
    /// ASCII only; curves are drawn with their markers.
    Ascii,
}

/// The styles of everything but the curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ChartStyles {
    /// The axis lines and their ticks.
    pub axis: Style,
    /// Tick labels and units.
    pub label: Style,
    /// The title.
    pub title: Style,
    /// The lines at major ticks.
    pub grid: Style,
    /// Labels in the legend.
    pub legend: Style,
    /// The cursor's line.
    pub cursor: Style,
    /// The ticks of [`Marks`].
    pub mark: Style,
    /// The selected one of them.
    pub selected_mark: Style,
    /// The words in an empty plot.
    pub message: Style,
}

/// Values of the horizontal axis that are ticked in a row of their own beneath its labels.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Marks {
    /// What they are, in a word left of the row.
    pub name: &'static str,
    /// The values; those off the axis are left out.
    pub values: Vec<f64>,
    /// The index of the one that stands out.
    pub selected: Option<usize>,
}

/// Curves over a horizontal axis, in general frequency responses.
///
/// Later curves are drawn over earlier ones, dim ones beneath all others.
#[derive(Debug, Clone)]
pub struct Chart<'a> {
    /// Words above the plot; the unit of the value axis stands before them.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis, of values as made by `level`.
    pub y: Axis,
    /// What is drawn of the curves' magnitudes.
    pub level: Level,
    /// The curves.
    pub curves: &'a [Curve<'a>],
    /// Where the curves are named.
    pub legend: Legend,
    /// A value of the horizontal axis at which a vertical line stands.
    pub cursor: Option<f64>,
    /// Ticks of their own, if there are any.
    pub marks: Marks,
    /// Whether faint lines run through the major ticks.
    pub grid: bool,
    /// The characters to draw with.
    pub glyphs: Glyphs,
    /// Colours and modifiers.
    pub styles: ChartStyles,
}

impl<'a> Chart<'a> {
    /// A chart of `curves` without title, cursor, grid and styles.
    pub fn new(x: Axis, y: Axis, level: Level, curves: &'a [Curve<'a>]) -> Self {
        Self {
            title: String::new(),
            x,
            y,
            level,
            curves,
            legend: Legend::default(),
            cursor: None,
            marks: Marks::default(),
            grid: false,
            glyphs: Glyphs::default(),
            styles: ChartStyles::default(),
        }
    }

    /// The cells of the curves when the chart is drawn into `area`.
    pub fn plot_area(&self, area: Rect) -> Rect {
        Layout::new(self, area).plot
    }

    /// The screen column of a value of the horizontal axis when the chart is drawn into `area`.
    pub fn column(&self, area: Rect, value: f64) -> Option<u16> {
        let plot = self.plot_area(area);
        self.cell(plot, value).map(|cell| plot.x + cell)
    }

    /// The value of the horizontal axis in the middle of a column of the plot.
    pub fn value_in(&self, plot: Rect, cell: u16) -> f64 {
        let [across, _] = rulers(plot.width, plot.height, self.glyphs);
        self.x.value(across.middle(cell))
    }

    /// The column of the cursor within the plot.
    pub(super) fn cursor_cell(&self, plot: Rect) -> Option<u16> {
        self.cell(plot, self.cursor?)
    }

    /// The column of a value within the plot.
    pub(super) fn cell(&self, plot: Rect, value: f64) -> Option<u16> {
        let [across, _] = rulers(plot.width, plot.height, self.glyphs);
        across.cell(self.x.fraction(value))
    }

    /// The marker of a curve as it can be shown.
    pub(super) fn marker(&self, index: usize) -> Option<char> {
        let marker = self.curves[index].marker?;
        if self.glyphs == Glyphs::Ascii && !marker.is_ascii_graphic() {
            return Some(char::from(b'a' + (index % 26) as u8));
        }
        Some(marker)
    }

    /// The character of which a curve's line is made in ASCII.
    pub(super) fn body(&self, index: usize) -> char {
        match self.curves[index].line {
            LineStyle::Dotted => '.',
            LineStyle::Dashed => self.marker(index).unwrap_or('-'),
            LineStyle::Solid | LineStyle::Points { .. } => self.marker(index).unwrap_or('*'),
        }
    }

    /// Draws all curves into dots.
    fn trace(&self, plot: Rect) -> Dots {
        let mut dots = Dots::new(rulers(plot.width, plot.height, self.glyphs));
        let (dim, bright): (Vec<usize>, Vec<usize>) =
            (0..self.curves.len()).partition(|index| self.curves[*index].dim);
        let traced: Vec<_> = dim
            .into_iter()
            .chain(bright)
            .map(|index| (index, self.trace_curve(index, &mut dots)))
            .collect();
        for (index, covered) in &traced {
            match self.curves[*index] {
                Curve {
                    line: LineStyle::Points { apart },
                    ..
                } => self.mark_samples(*index, apart, &mut dots),
                Curve {
                    marker: Some(_), ..
                } => mark(&mut dots, covered, *index, [*index, self.curves.len()]),
                _ => {}
            }
        }
        dots
    }

    /// Puts the marker of a curve at its samples, some cells apart.
    fn mark_samples(&self, index: usize, apart: u16, dots: &mut Dots) {
        let mut free = 0;
        for (abscissa, magnitude) in self.curves[index].samples() {
            let column = dots.across.cell(self.x.fraction(abscissa));
            let value = self.level.value(magnitude);
            let row = dots.down.cell(self.y.fraction(value));
            if let (Some(column), Some(row)) = (column, row)
                && (column >= free || apart == 0)
            {
                dots.mark(column, row, index);
                free = column + apart;
            }
        }
    }

    fn trace_curve(&self, index: usize, dots: &mut Dots) -> Vec<Option<(u16, u16)>> {
        let curve = &self.curves[index];
        let (across, down) = (dots.across, dots.down);
        let mut pen = Pen::new(dots, index, curve.line);
        if matches!(curve.line, LineStyle::Points { .. }) {
            return pen.finish();
        }
        for (abscissa, magnitude) in curve.samples() {
            let value = self.level.value(magnitude);
            pen.draw_to(
                across.dot(self.x.fraction(abscissa)),
                down.dot(self.y.fraction(value)),
            );
        }
        let mut covered = pen.finish();
        for column in self.pole_dots(index, across) {
            let below = usize::from(column).saturating_sub(1)..=usize::from(column) + 1;
            let bottom = covered.get(below).into_iter().flatten().flatten();
            let bottom = bottom.map(|rows| rows.1).max().unwrap_or(0);
            for row in 0..=bottom {
                dots.draw(column, row, index);
            }
            covered[usize::from(column)] = Some((0, bottom));
        }
        covered
    }

    /// The dot columns of a curve's poles.
    fn pole_dots(&self, index: usize, across: Ruler) -> impl Iterator<Item = u16> {
        let poles = self.curves[index].poles.iter();
        poles
            .filter(|pole| self.x.contains(**pole))
            .map(move |pole| across.dot(self.x.fraction(*pole)).round() as u16)
    }

    /// The cells at the plot's top to which a curve goes up at a pole, and the curve.
    fn pole_cells(&self, across: Ruler) -> Vec<(u16, usize)> {
        let cells = |index| {
            let dots = self.pole_dots(index, across);
            dots.map(move |dot| (dot / across.dots_per_cell, index))
        };
        (0..self.curves.len()).flat_map(cells).collect()
    }

    /// Paints the plot cell by cell: a curve, or the cursor, or the grid.
    fn paint(&self, layout: &Layout, dots: &Dots, buffer: &mut Buffer) {
        let cursor = self.cursor_cell(layout.plot);
        let poles = self.pole_cells(dots.across);
        let [grid_columns, grid_rows] = if self.grid {
            [0, 1].map(|axis| {
                let major = layout.ticks[axis]
                    .iter()
                    .filter(|tick| tick.label.is_some());
                major.map(|tick| tick.cell).collect::<Vec<u16>>()
            })
        } else {
            [Vec::new(), Vec::new()]
        };
        for position in layout.plot.positions() {
            if matches!(layout.legend, Place::Inside(legend) if legend.contains(position)) {
                continue;
            }
            let (column, row) = (position.x - layout.plot.x, position.y - layout.plot.y);
            // In the first column the axis is line enough.
            let on_grid = [
                column > 0 && grid_columns.contains(&column),
                grid_rows.contains(&row),
            ];
            let pole = poles.iter().find(|pole| row == 0 && pole.0 == column);
            let ink = pole
                .map(|(_, index)| self.pole_ink(*index))
                .or_else(|| self.curve_ink(dots, column, row))
                .or_else(|| (cursor == Some(column)).then(|| self.cursor_ink()))
                .or_else(|| self.grid_ink(on_grid));
            if let (Some((glyph, style)), Some(cell)) = (ink, buffer.cell_mut(position)) {
                cell.set_char(glyph).set_style(style);
            }
        }
    }

    fn curve_ink(&self, dots: &Dots, column: u16, row: u16) -> Option<(char, Style)> {
        let cell = dots.cell(column, row);
        let index = cell.curve?;
        let glyph = match (self.glyphs, self.marker(index)) {
            (_, Some(marker)) if cell.marked => marker,
            (Glyphs::Braille, _) => cell.braille(),
            (Glyphs::Block, _) => cell.quarters(),
            (Glyphs::Dot, _) => '•',
            (Glyphs::Ascii, _) => self.body(index),
        };
        Some((glyph, self.curves[index].ink()))
    }

    fn pole_ink(&self, index: usize) -> (char, Style) {
        let glyph = if self.glyphs == Glyphs::Ascii {
            '^'
        } else {
            '↑'
        };
        (glyph, self.curves[index].ink())
    }

    fn cursor_ink(&self) -> (char, Style) {
        let glyph = if self.glyphs == Glyphs::Ascii {
            '|'
        } else {
            '│'
        };
        (glyph, self.styles.cursor)
    }

    fn grid_ink(&self, on_grid: [bool; 2]) -> Option<(char, Style)> {
        let glyph = match (self.glyphs, on_grid) {
            (_, [false, false]) => None,
            // Lines of ASCII characters would pass for curves.
            (Glyphs::Ascii, _) => (on_grid == [true, true]).then_some('+'),
            (_, [true, false]) => Some('┊'),
            (_, [false, true]) => Some('┈'),
            (_, [true, true]) => Some('┼'),
        };
        glyph.map(|glyph| (glyph, self.styles.grid))
    }

    /// Says in the middle of an empty plot why it is empty.
    fn explain(&self, plot: Rect, buffer: &mut Buffer) {
        let finite = |(abscissa, magnitude): (f64, f64)| {
            self.x.fraction(abscissa).is_finite()
                && self.y.fraction(self.level.value(magnitude)).is_finite()
        };
        let mut samples = self.curves.iter().flat_map(Curve::samples).peekable();
        let zero = samples.peek().is_some() && samples.all(|(_, magnitude)| magnitude == 0.0);
        let message = if zero {
            "zero at every frequency"
        } else if self.curves.iter().flat_map(Curve::samples).any(finite) {
            "no value within the axes"
        } else {
            "no finite value to draw"
        };
        let margin = plot.width.saturating_sub(frame::width(message)) / 2;
        let row = Rect {
            x: plot.x + margin,
            y: plot.y + plot.height / 2,
            width: plot.width - margin,
            height: plot.height.min(1),
        };
        frame::put(buffer, row, message, (self.glyphs, self.styles.message));
    }
}

impl Widget for &Chart<'_> {
    fn render(self, area: Rect, buffer: &mut Buffer) {
        let area = area.intersection(buffer.area);
        if area.is_empty() {
            return;
        }
        let layout = Layout::new(self, area);
        let dots = self.trace(layout.plot);
        frame::draw(self, &layout, buffer);
        legend::draw(self, layout.legend, buffer);
        if dots.is_blank() {
            self.explain(layout.plot, buffer);
        } else {
            self.paint(&layout, &dots, buffer);
        }
    }
}

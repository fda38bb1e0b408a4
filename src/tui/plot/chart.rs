//! The data of a chart.

use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::symbols::Marker;

use super::axis::Axis;
use super::curve::{Curve, LineStyle};
use super::glyphs::{Glyphs, rulers};
use super::level::Level;

/// The position of the legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Legend {
    /// No legend.
    Hidden,
    /// At the top right of the plot; in a line above the plot if it would cover too much.
    #[default]
    Inside,
    /// In a line above the plot.
    Line,
}

/// The styles of all parts except the curves.
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
    /// The lines of both cursors.
    pub cursor: Style,
    /// The lines at the harmonics of the cursor and their order numbers.
    pub harmonic: Style,
    /// The band: its edges and the axis between them.
    pub band: Style,
    /// The ticks of [`Marks`].
    pub mark: Style,
    /// The selected mark.
    pub selected_mark: Style,
    /// The message in an empty plot.
    pub message: Style,
}

/// Values of the horizontal axis with ticks in a separate row below its labels.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Marks {
    /// The label left of the row.
    pub name: &'static str,
    /// The values; those outside the axis are skipped.
    pub values: Vec<f64>,
    /// The index of the highlighted value.
    pub selected: Option<usize>,
}

/// A mark on the horizontal axis itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisMark {
    /// Its value; one outside the axis is skipped.
    pub value: f64,
    /// Its labels, the longest first: the first one that fits between the labels of the ticks is drawn.
    pub labels: &'static [&'static str],
}

/// A symbol at a point of the plot, over the curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Its value on the horizontal axis.
    pub x: f64,
    /// Its value on the vertical axis.
    pub y: f64,
    /// The symbol, one column wide.
    pub sign: char,
    /// Its style.
    pub style: Style,
}

/// The content below the plot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Below {
    /// The horizontal axis with labels and marks.
    #[default]
    All,
    /// The axis only: its labels are below another plot.
    Axis,
}

/// Curves over a horizontal axis, in general frequency responses.
///
/// Later curves are drawn over earlier ones, dim curves first.
#[derive(Debug, Clone)]
pub struct Chart<'a> {
    /// The title above the plot, after the unit of the value axis.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis, in the quantity of `level`.
    pub y: Axis,
    /// The quantity that is drawn of the curves' values.
    pub level: Level,
    /// The curves, in drawing order.
    pub curves: &'a [Curve<'a>],
    /// The position of the legend.
    pub legend: Legend,
    /// The cursor: a value of the horizontal axis with a vertical line.
    pub cursor: Option<f64>,
    /// The second cursor, with a dashed line.
    pub second: Option<f64>,
    /// Harmonics of the cursor with faint lines: twice its value, three times, and so on.
    pub harmonics: Vec<f64>,
    /// A band of the horizontal axis, `[lower, upper]`: lines at its ends and a heavy axis between them.
    pub band: Option<[f64; 2]>,
    /// A mark on the axis.
    pub axis_mark: Option<AxisMark>,
    /// Symbols over the curves.
    pub spots: Vec<Spot>,
    /// Marked values in a separate row; none hides the row.
    pub marks: Marks,
    /// Whether grid lines are drawn at the major ticks.
    pub grid: bool,
    /// The characters to draw with.
    pub glyphs: Glyphs,
    /// Colours and modifiers.
    pub styles: ChartStyles,
    /// Whether this is a Nyquist plot: the points of a curve are joined in their order, in any direction.
    pub(super) nyquist: bool,
    /// The content below the plot.
    pub(super) below: Below,
    /// Fewest columns of the value labels.
    pub(super) label_columns: u16,
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
            second: None,
            harmonics: Vec::new(),
            band: None,
            axis_mark: None,
            spots: Vec::new(),
            marks: Marks::default(),
            grid: false,
            glyphs: Glyphs::default(),
            styles: ChartStyles::default(),
            nyquist: false,
            below: Below::default(),
            label_columns: 0,
        }
    }

    /// A Nyquist plot of imaginary over real parts: points are joined in their order, in any direction, and lines mark
    /// 0 on both axes.
    ///
    /// [`Chart::equalised`] gives both axes the same scale.
    pub fn nyquist([x, y]: [Axis; 2], curves: &'a [Curve<'a>]) -> Self {
        Self {
            nyquist: true,
            ..Self::new(x, y, Level::Signed, curves)
        }
    }

    /// The value of the horizontal axis in the middle of a column of the plot.
    pub fn value_in(&self, plot: Rect, cell: u16) -> f64 {
        let [across, _] = rulers(plot.width, plot.height, self.glyphs);
        self.x.value(across.middle(cell))
    }

    /// Whether the chart has a row above the plot.
    pub(super) fn has_heading(&self) -> bool {
        !self.title.is_empty() || !self.y.unit.is_empty()
    }

    /// The column of a value within the plot.
    pub(super) fn cell(&self, plot: Rect, value: f64) -> Option<u16> {
        let [across, _] = rulers(plot.width, plot.height, self.glyphs);
        across.cell(self.x.fraction(value))
    }

    /// The marker of a curve, in ASCII if the glyphs are.
    pub(super) fn marker(&self, index: usize) -> Option<char> {
        let marker = self.curves[index].marker?;
        if self.glyphs == Glyphs::Ascii && !marker.is_ascii_graphic() {
            return Some(char::from(b'a' + (index % 26) as u8));
        }
        Some(marker)
    }

    /// The marker grid of a curve's line: dots within a cell, or one character per cell.
    pub(super) fn grid_of(&self, index: usize) -> Marker {
        let line = self.curves[index].line;
        match (self.glyphs, line) {
            (Glyphs::Braille, _) => Marker::Braille,
            (Glyphs::Octant, _) => Marker::Octant,
            (Glyphs::Block, _) => Marker::Quadrant,
            (Glyphs::Dot, LineStyle::Dotted) => Marker::Custom('·'),
            (Glyphs::Dot, LineStyle::Dashed) => Marker::Custom('◦'),
            (Glyphs::Dot, LineStyle::Solid | LineStyle::Points { .. }) => Marker::Custom('•'),
            (Glyphs::Ascii, LineStyle::Dotted) => Marker::Custom('.'),
            (Glyphs::Ascii, LineStyle::Dashed) => Marker::Custom(self.marker(index).unwrap_or('-')),
            (Glyphs::Ascii, LineStyle::Solid | LineStyle::Points { .. }) => {
                Marker::Custom(self.marker(index).unwrap_or('*'))
            }
        }
    }
}

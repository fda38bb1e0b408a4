//! What a chart shows, as plain data.

use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::symbols::Marker;

use super::axis::Axis;
use super::curve::{Curve, LineStyle};
use super::glyphs::{Glyphs, rulers};
use super::level::Level;

/// Where the curves are named.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Legend {
    /// Nowhere.
    Hidden,
    /// At the plot's top right; in a line above the plot where that would hide too much.
    #[default]
    Inside,
    /// In a line above the plot.
    Line,
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
    /// The lines of both cursors.
    pub cursor: Style,
    /// The lines at the harmonics of the cursor and their order numbers.
    pub harmonic: Style,
    /// The band: its edges and the axis between them.
    pub band: Style,
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

/// A sign at a point of the plot, over the curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Its value on the horizontal axis.
    pub x: f64,
    /// Its value on the vertical axis.
    pub y: f64,
    /// The sign, one column wide.
    pub sign: char,
    /// How it looks.
    pub style: Style,
}

/// What stands beneath the plot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Below {
    /// The horizontal axis with labels and marks.
    #[default]
    All,
    /// The axis alone: its labels stand beneath another plot.
    Axis,
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
    /// Another one, at which a dashed line stands.
    pub second: Option<f64>,
    /// Values of the horizontal axis at which faint lines stand: twice the cursor's, three times, and so on.
    pub harmonics: Vec<f64>,
    /// A band of the horizontal axis, its lower end first: lines at its ends, and a heavy axis between them.
    pub band: Option<[f64; 2]>,
    /// Signs over the curves.
    pub spots: Vec<Spot>,
    /// Ticks of their own, if there are any.
    pub marks: Marks,
    /// Whether faint lines run through the major ticks.
    pub grid: bool,
    /// The characters to draw with.
    pub glyphs: Glyphs,
    /// Colours and modifiers.
    pub styles: ChartStyles,
    /// Whether the curves run in any direction, their points joined in their order.
    pub(super) free: bool,
    /// What stands beneath the plot.
    pub(super) below: Below,
    /// The columns that the value labels have at least.
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
            spots: Vec::new(),
            marks: Marks::default(),
            grid: false,
            glyphs: Glyphs::default(),
            styles: ChartStyles::default(),
            free: false,
            below: Below::default(),
            label_columns: 0,
        }
    }

    /// A chart of `curves` as loci over the two `axes`: their points are joined in their order, whichever way that
    /// goes, as in a Nyquist plot of imaginary parts over real parts. Lines run through 0 on both axes.
    ///
    /// [`Chart::equalised`] makes the axes equal.
    pub fn locus([x, y]: [Axis; 2], curves: &'a [Curve<'a>]) -> Self {
        Self {
            free: true,
            ..Self::new(x, y, Level::Signed, curves)
        }
    }

    /// The value of the horizontal axis in the middle of a column of the plot.
    pub fn value_in(&self, plot: Rect, cell: u16) -> f64 {
        let [across, _] = rulers(plot.width, plot.height, self.glyphs);
        self.x.value(across.middle(cell))
    }

    /// Whether there is something to write above the plot.
    pub(super) fn has_heading(&self) -> bool {
        !self.title.is_empty() || !self.y.unit.is_empty()
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

    /// The grid in which a curve's line is drawn: dots within a cell, or a character a cell.
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

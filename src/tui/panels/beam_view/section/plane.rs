//! The plane of the section on cells: equal scales along y and z, axes with ticks at the left and at the bottom.

use ratatui::style::Style;

use crate::tui::plot::{Axis, CellRuler, Glyphs, Scale, dotted};
use crate::tui::sketch::{Board, Cell, Signs, width};

/// The height of a cell relative to its width.
const ROW_IN_COLUMNS: f64 = 2.0;
/// Columns for the labels of the vertical axis, its line included.
const LABELS: i32 = 5;
/// Fewest columns and rows of a picture with axes.
const WITH_AXES: [i32; 2] = [30, 7];
/// A picture smaller than this is measured in mm, m.
const IN_MILLIMETRES: f64 = 2.0;

/// The range that must be in the picture, m; it contains the axis of the beam.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Extent {
    y: [f64; 2],
    z: [f64; 2],
}

impl Extent {
    /// Extends the range by a point, if there is one.
    pub(super) fn take(&mut self, y: f64, z: f64) {
        for (range, value) in [(&mut self.y, y), (&mut self.z, z)] {
            if value.is_finite() {
                *range = [range[0].min(value), range[1].max(value)];
            }
        }
    }
}

/// Cells around the part drawn to scale.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reserve {
    /// At the left and at the right, each.
    pub(super) sides: i32,
    /// At the bottom.
    pub(super) below: i32,
    /// At the top, for text.
    pub(super) head: i32,
}

/// The plane.
#[derive(Debug)]
pub(super) struct Plane {
    /// The first column of the plane and the first row.
    origin: Cell,
    columns: i32,
    rows: i32,
    /// y grows to the left: this column is counted from the right.
    y: CellRuler,
    z: CellRuler,
    /// The unit of the labels, and the number of them in a metre.
    unit: &'static str,
    factor: f64,
    /// Metres per column.
    scale: f64,
    /// The row of the lowest point.
    lowest: i32,
    axes: bool,
}

impl Plane {
    pub(super) fn new(extent: &Extent, reserve: Reserve, size: [u16; 2]) -> Self {
        let [all_columns, all_rows] = size.map(i32::from);
        let axes = all_columns >= WITH_AXES[0] && all_rows >= WITH_AXES[1];
        let origin = [if axes { LABELS } else { 0 }, reserve.head];
        let columns = all_columns - origin[0];
        let rows = all_rows - origin[1] - if axes { 2 } else { 0 };
        let across = (columns - 1 - 2 * reserve.sides).max(1);
        let down = (rows - 1 - reserve.below).max(1);
        let [wide, high] = [extent.y, extent.z].map(|[low, high]| high - low);
        let fitting = (wide / f64::from(across)).max(high / f64::from(down) / ROW_IN_COLUMNS);
        let scale = if fitting.is_normal() { fitting } else { 1e-3 };
        let row = ROW_IN_COLUMNS * scale;
        // The remainder is shared evenly between both sides.
        let left = f64::from(columns - 1) - wide / scale;
        let top = (f64::from(down) - high / row) / 2.0;
        let y_high = extent.y[1] + left / 2.0 * scale;
        let z_high = extent.z[1] + top * row;
        let y = [y_high - f64::from((columns - 1).max(1)) * scale, y_high];
        let z = [z_high - f64::from((rows - 1).max(1)) * row, z_high];
        let (unit, factor) = if wide.max(high) < IN_MILLIMETRES {
            ("mm", 1e3)
        } else {
            ("m", 1.0)
        };
        let axis =
            |bounds: [f64; 2]| Axis::new(Scale::Linear, bounds.map(|bound| bound * factor), "");
        let mut plane = Self {
            origin,
            columns,
            rows,
            y: CellRuler::across(axis(y), columns.max(0) as u16),
            z: CellRuler::up(axis(z), rows.max(0) as u16),
            unit,
            factor,
            scale,
            lowest: 0,
            axes,
        };
        plane.lowest = plane.cell(0.0, extent.z[0])[1];
        plane
    }

    pub(super) const fn metres_per_column(&self) -> f64 {
        self.scale
    }

    /// The first column of the plane.
    pub(super) const fn first_column(&self) -> i32 {
        self.origin[0]
    }

    /// The cell of a point (y, z), m.
    pub(super) fn cell(&self, y: f64, z: f64) -> Cell {
        let column = self.y.cell(y * self.factor).map_or(0, i32::from);
        let row = self.z.cell(z * self.factor).map_or(0, i32::from);
        [
            self.origin[0] + self.columns - 1 - column,
            self.origin[1] + row,
        ]
    }

    /// A row at a distance below everything that is to scale, but within the plane.
    pub(super) fn below(&self, rows: i32) -> i32 {
        (self.lowest + rows).min(self.origin[1] + self.rows - 1)
    }

    /// Draws points (y, z), m, as dots in free cells.
    pub(super) fn draw_dots(
        &self,
        board: &mut Board<'_>,
        points: impl Iterator<Item = (f64, f64)>,
        glyphs: Glyphs,
        style: Style,
    ) {
        let columns = f64::from(self.columns);
        let places = points.map(|(y, z)| {
            [
                columns - self.y.place(y * self.factor),
                self.z.place(z * self.factor),
            ]
        });
        let size = [self.columns, self.rows].map(|cells| cells.max(0) as u16);
        for (column, row, glyph) in dotted(places, size, glyphs) {
            let at = [
                self.origin[0] + i32::from(column),
                self.origin[1] + i32::from(row),
            ];
            board.sign_if_free(at, glyph, style);
        }
    }

    /// Draws the axes, if there is room for them.
    pub(super) fn draw(&self, board: &mut Board<'_>, signs: &Signs, style: Style) {
        if !self.axes {
            return;
        }
        let (line, bottom) = (self.origin[0] - 1, self.origin[1] + self.rows);
        for row in self.origin[1]..bottom {
            board.sign([line, row], signs.upright[0], style);
        }
        board.sign([line, bottom], signs.corner, style);
        for column in self.origin[0]..self.origin[0] + self.columns {
            board.sign([column, bottom], signs.ruler[0], style);
        }
        self.draw_heights(board, signs, style);
        self.draw_widths(board, signs, style);
    }

    fn draw_heights(&self, board: &mut Board<'_>, signs: &Signs, style: Style) {
        let line = self.origin[0] - 1;
        let unit = format!("{}z {}", signs.up, self.unit);
        // In the row for text, otherwise next to the axis.
        let place = if self.origin[1] > 0 {
            0
        } else {
            self.origin[0]
        };
        board.word([place, 0], &unit, Style::new());
        for tick in self.z.ticks() {
            let row = self.origin[1] + i32::from(tick.cell);
            let sign = signs.upright[if tick.label.is_some() { 1 } else { 2 }];
            board.sign([line, row], sign, style);
            if let Some(label) = tick.label {
                board.word([line - width(&label), row], &label, Style::new());
            }
        }
    }

    fn draw_widths(&self, board: &mut Board<'_>, signs: &Signs, style: Style) {
        let bottom = self.origin[1] + self.rows;
        let unit = format!("{}y {}", signs.left_arrow, self.unit);
        board.word(
            [board.columns() - width(&unit), bottom + 1],
            &unit,
            Style::new(),
        );
        for tick in self.y.ticks() {
            let column = self.origin[0] + self.columns - 1 - i32::from(tick.cell);
            let sign = signs.ruler[if tick.label.is_some() { 1 } else { 2 }];
            board.sign([column, bottom], sign, style);
            if let Some(label) = tick.label {
                let columns = width(&label);
                let left = column - (columns - 1) / 2;
                if board.is_free([left - 1, bottom + 1], columns + 2) {
                    board.word([left, bottom + 1], &label, Style::new());
                }
            }
        }
    }
}

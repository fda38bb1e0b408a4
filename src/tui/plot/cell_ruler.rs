//! Rulers and dots for pictures other than charts: values and labels are in the same cells as in a chart.

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Color;
use ratatui::symbols::Marker;

use super::axis::{Axis, Direction, Ruler};
use super::dots::Dots;
use super::glyphs::{Glyphs, rulers};
use super::ticks::ticks;

/// A round value on a ruler.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RoundTick {
    /// Its cell, from the left or from the top.
    pub cell: u16,
    /// Its value as text; none for minor ticks.
    pub label: Option<String>,
}

/// An axis along cells: its bounds are in the middles of the first and the last cell.
#[derive(Debug, Clone)]
pub struct CellRuler {
    axis: Axis,
    ruler: Ruler,
}

impl CellRuler {
    /// An axis to the right over `columns`.
    pub const fn across(axis: Axis, columns: u16) -> Self {
        Self::new(axis, columns, Direction::Right)
    }

    /// An axis upward over `rows`.
    pub const fn up(axis: Axis, rows: u16) -> Self {
        Self::new(axis, rows, Direction::Up)
    }

    const fn new(axis: Axis, cells: u16, direction: Direction) -> Self {
        let ruler = Ruler {
            direction,
            cells,
            dots_per_cell: 1,
        };
        Self { axis, ruler }
    }

    /// The cell of a value, from the left or from the top; none outside the axis.
    pub fn cell(&self, value: f64) -> Option<u16> {
        self.ruler.cell(self.axis.fraction(value))
    }

    /// The position of a value, in cells from the left or from the top; the middle of the first cell is at 0.5.
    pub fn place(&self, value: f64) -> f64 {
        self.ruler.dot(self.axis.fraction(value)) + 0.5
    }

    /// Round values as dense as their labels allow: labelled ones in ascending order, then minor ones.
    pub fn ticks(&self) -> Vec<RoundTick> {
        let ticks = ticks(&self.axis, self.ruler).into_iter();
        ticks
            .map(|tick| RoundTick {
                cell: tick.cell,
                label: tick.label,
            })
            .collect()
    }
}

/// Draws points as dots; returns column, row and character of each cell that has a dot.
///
/// Points are (column, row) in cells from the top left corner of `size` cells, the middle of the first cell at
/// (0.5, 0.5); points outside are skipped. In ASCII a dot is a full stop.
pub fn dotted(
    points: impl IntoIterator<Item = [f64; 2]>,
    [columns, rows]: [u16; 2],
    glyphs: Glyphs,
) -> Vec<(u16, u16, char)> {
    let mut dots = Dots::new(rulers(columns, rows, glyphs));
    for [x, y] in points {
        let column = x * f64::from(dots.across.dots_per_cell);
        let row = y * f64::from(dots.down.dots_per_cell);
        let inside = [(column, dots.across), (row, dots.down)];
        if inside
            .iter()
            .all(|(dot, ruler)| (0.0..f64::from(ruler.dots())).contains(dot))
        {
            dots.draw(column as u16, row as u16, 0);
        }
    }
    let marker = match glyphs {
        Glyphs::Braille => Marker::Braille,
        Glyphs::Octant => Marker::Octant,
        Glyphs::Block => Marker::Quadrant,
        Glyphs::Dot => Marker::Custom('·'),
        Glyphs::Ascii => Marker::Custom('.'),
    };
    let mut buffer = Buffer::empty(Rect::new(0, 0, columns, rows));
    dots.render(buffer.area, &mut buffer, |_| marker, |_| Color::Reset);
    let shown = buffer.area.positions().filter_map(|Position { x, y }| {
        dots.cell(x, y).curve?;
        Some((x, y, buffer.cell((x, y))?.symbol().chars().next()?))
    });
    shown.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::plot::Scale;

    #[test]
    fn bounds_are_in_the_middles_of_the_outer_cells() {
        let ruler = CellRuler::across(Axis::new(Scale::Linear, [0.0, 3.0], "m"), 31);
        // 30 steps of 0.1 m.
        assert_eq!(ruler.cell(0.0), Some(0));
        assert_eq!(ruler.cell(3.0), Some(30));
        assert_eq!(ruler.cell(1.2), Some(12));
        assert_eq!(ruler.cell(3.2), None);
        assert!((ruler.place(1.2) - 12.5).abs() < 1e-12);
        let labelled: Vec<_> = ruler.ticks().into_iter().filter_map(|t| t.label).collect();
        assert_eq!(labelled, ["0", "0.5", "1", "1.5", "2", "2.5", "3"]);
        let upward = CellRuler::up(Axis::new(Scale::Linear, [0.0, 3.0], "m"), 4);
        assert_eq!(upward.cell(1.0), Some(2));
    }

    #[test]
    fn dots_are_where_their_points_are() {
        // The upper left dot of the second cell: bit 0 of braille, the upper left quarter.
        let points = [[1.1, 0.1], [-0.1, 0.0], [2.0, 0.0], [f64::NAN, 0.0]];
        for (glyphs, glyph) in [
            (Glyphs::Braille, '⠁'),
            (Glyphs::Octant, '𜺨'),
            (Glyphs::Block, '▘'),
            (Glyphs::Dot, '·'),
            (Glyphs::Ascii, '.'),
        ] {
            assert_eq!(dotted(points, [2, 1], glyphs), [(1, 0, glyph)]);
        }
    }
}

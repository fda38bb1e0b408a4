//! The characters of a chart, and the number of dots in each.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::axis::{Direction, Ruler};
use crate::escape::escape;
use crate::tui::ascii;

/// The character set of a chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Glyphs {
    /// Curves in braille dots, 2 x 4 per cell; axes in box-drawing characters.
    #[default]
    Braille,
    /// Curves in eighths of cells, 2 x 4 per cell; axes as with braille.
    Octant,
    /// Curves in quarters of cells; axes as with braille.
    Block,
    /// Curves of one bullet per cell; axes as with braille.
    Dot,
    /// ASCII only; curves are drawn with their markers.
    Ascii,
}

/// The rulers across and down an area of `columns` by `rows` cells.
pub(super) fn rulers(columns: u16, rows: u16, glyphs: Glyphs) -> [Ruler; 2] {
    let (wide, high) = match glyphs {
        Glyphs::Braille | Glyphs::Octant => (2, 4),
        Glyphs::Block => (2, 2),
        Glyphs::Dot | Glyphs::Ascii => (1, 1),
    };
    [
        Ruler {
            direction: Direction::Right,
            cells: columns,
            dots_per_cell: wide,
        },
        Ruler {
            direction: Direction::Up,
            cells: rows,
            dots_per_cell: high,
        },
    ]
}

/// The width in columns of a text as [`put`] writes it.
pub(super) fn width(text: &str) -> u16 {
    crate::wrap::width(text) as u16
}

/// Writes a text into one row, hidden characters escaped, truncated at the end of the row.
pub(super) fn put(buffer: &mut Buffer, row: Rect, text: &str, (glyphs, style): (Glyphs, Style)) {
    if row.is_empty() {
        return;
    }
    let columns = usize::from(row.width);
    let text = escape(text);
    if glyphs == Glyphs::Ascii {
        buffer.set_stringn(row.x, row.y, ascii::text(&text), columns, style);
    } else {
        buffer.set_stringn(row.x, row.y, text, columns, style);
    }
}

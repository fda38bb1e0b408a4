//! Drawings of symbols and words: a board of cells on which words cover nothing, and the symbols of mechanics in Unicode
//! and ASCII.

mod signs;

pub(super) use signs::{BIMOMENT, Frame, POINTER, POINTER_BACK, Signs, TORQUE};

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use crate::escape::escape;

/// Column and row on a board, from its top left corner; cells outside are not drawn.
pub(super) type Cell = [i32; 2];

/// An area of the screen that tracks its occupied cells.
#[derive(Debug)]
pub(super) struct Board<'b> {
    buffer: &'b mut Buffer,
    area: Rect,
    taken: Vec<bool>,
}

impl<'b> Board<'b> {
    /// An empty board.
    pub(super) fn new(buffer: &'b mut Buffer, area: Rect) -> Self {
        let area = area.intersection(buffer.area);
        Self {
            buffer,
            area,
            taken: vec![false; area.area() as usize],
        }
    }

    pub(super) fn columns(&self) -> i32 {
        i32::from(self.area.width)
    }

    pub(super) fn rows(&self) -> i32 {
        i32::from(self.area.height)
    }

    fn index(&self, [column, row]: Cell) -> Option<usize> {
        let inside = (0..self.columns()).contains(&column) && (0..self.rows()).contains(&row);
        inside.then(|| (row * self.columns() + column) as usize)
    }

    /// Whether `columns` cells from a cell to the right are free; cells outside the board are.
    pub(super) fn is_free(&self, [column, row]: Cell, columns: i32) -> bool {
        (column..column + columns)
            .filter_map(|column| self.index([column, row]))
            .all(|index| !self.taken[index])
    }

    /// Draws a symbol over existing content.
    pub(super) fn sign(&mut self, at: Cell, sign: char, style: Style) {
        let Some(index) = self.index(at) else {
            return;
        };
        self.taken[index] = true;
        // A position inside the area fits.
        let position = (self.area.x + at[0] as u16, self.area.y + at[1] as u16);
        if let Some(cell) = self.buffer.cell_mut(position) {
            cell.set_char(sign).set_style(style);
        }
    }

    /// Draws a symbol into a free cell of the board; returns whether it was free.
    pub(super) fn sign_if_free(&mut self, at: Cell, sign: char, style: Style) -> bool {
        let free = self.index(at).is_some_and(|index| !self.taken[index]);
        if free {
            self.sign(at, sign, style);
        }
        free
    }

    /// Writes a word over existing content, truncated at the edge.
    pub(super) fn over(&mut self, [column, row]: Cell, word: &str, style: Style) {
        let column = column.max(0);
        let Some(first) = self.index([column, row]) else {
            return;
        };
        let room = (self.columns() - column).min(width(word));
        self.taken[first..first + room as usize].fill(true);
        let (x, y) = (self.area.x + column as u16, self.area.y + row as u16);
        self.buffer
            .set_stringn(x, y, escape(word), room as usize, style);
    }

    /// Writes a word if all its cells are free; returns whether they were.
    pub(super) fn word(&mut self, at: Cell, word: &str, style: Style) -> bool {
        let columns = width(word);
        let inside = at[0] >= 0 && at[0] + columns <= self.columns();
        let fits = inside && self.index(at).is_some() && self.is_free(at, columns);
        if fits {
            self.over(at, word, style);
        }
        fits
    }

    /// Writes a word above or below the cell it names: centred, else starting there, else ending there, else next to it,
    /// with blanks around. Returns whether there was room.
    pub(super) fn word_by(&mut self, [column, row]: Cell, word: &str, style: Style) -> bool {
        let columns = width(word);
        let starts = [
            column - (columns - 1) / 2,
            column,
            column - columns + 1,
            column + 1,
            column - columns,
            column + 2,
            column - columns - 1,
            column + 3,
            column - columns - 2,
        ];
        let inside = |start: &i32| *start >= 0 && *start + columns <= self.columns();
        let is_separate = |start: &i32| self.is_free([*start - 1, row], columns + 2);
        let start = starts.into_iter().filter(inside).find(|start| {
            is_separate(start)
                || (is_adjacent(*start, columns, column) && self.is_free([*start, row], columns))
        });
        start.is_some_and(|start| self.word([start, row], word, style))
    }

    /// Writes the first of these words that fits at `at`; returns whether one did.
    pub(super) fn first_by<W: AsRef<str>>(&mut self, at: Cell, words: &[W], style: Style) -> bool {
        words
            .iter()
            .any(|word| self.word_by(at, word.as_ref(), style))
    }
}

/// Whether a word is adjacent to the column it names, so that no blank is needed there.
fn is_adjacent(start: i32, columns: i32, column: i32) -> bool {
    start == column + 1 || start + columns == column
}

/// The width of a word in columns, hidden characters escaped.
pub(super) fn width(word: &str) -> i32 {
    crate::wrap::width(word) as i32
}

/// The cells of a straight line, both ends included.
pub(super) fn way(from: Cell, to: Cell) -> Vec<Cell> {
    let steps = (0..2)
        .map(|axis| (to[axis] - from[axis]).abs())
        .max()
        .unwrap_or(0);
    let at = |axis: usize, step: i32| {
        let share = f64::from(step) / f64::from(steps.max(1));
        from[axis] + (f64::from(to[axis] - from[axis]) * share).round() as i32
    };
    (0..=steps).map(|step| [at(0, step), at(1, step)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(columns: u16, rows: u16, draw: impl FnOnce(&mut Board<'_>)) -> Buffer {
        let mut buffer = Buffer::empty(Rect::new(0, 0, columns, rows));
        let area = buffer.area;
        draw(&mut Board::new(&mut buffer, area));
        buffer
    }

    #[test]
    fn words_cover_nothing() {
        let plain = Style::new();
        let buffer = drawn(9, 2, |board| {
            board.sign([3, 0], '|', plain);
            assert!(!board.word([1, 0], "abc", plain));
            assert!(board.word([4, 0], "abc", plain));
            assert!(!board.word([7, 0], "abc", plain));
            assert!(!board.word([-1, 1], "abc", plain));
            assert!(!board.word([0, 2], "abc", plain));
            assert!(!board.sign_if_free([5, 0], '|', plain));
            assert!(!board.sign_if_free([9, 0], '|', plain));
            // Content outside the board is not drawn and does not fail.
            board.sign([-1, 0], '?', plain);
            board.over([0, -1], "?", plain);
            board.over([7, 1], "abc", plain);
        });
        assert_eq!(buffer, Buffer::with_lines(["   |abc  ", "       ab"]));
    }

    #[test]
    fn a_word_is_at_its_column_with_blanks_around() {
        let by = |taken: &[i32], column| {
            drawn(11, 1, |board| {
                for column in taken {
                    board.sign([*column, 0], '|', Style::new());
                }
                board.word_by([column, 0], "abc", Style::new());
            })
        };
        assert_eq!(by(&[], 5), Buffer::with_lines(["    abc    "]));
        assert_eq!(by(&[], 0), Buffer::with_lines(["abc        "]));
        assert_eq!(by(&[], 10), Buffer::with_lines(["        abc"]));
        // Right or left of a symbol in its own column, but never touching another one.
        assert_eq!(by(&[5], 5), Buffer::with_lines(["     |abc  "]));
        assert_eq!(by(&[5, 8], 5), Buffer::with_lines(["  abc|  |  "]));
        assert_eq!(by(&[2, 5, 8], 5), Buffer::with_lines(["  |  |  |  "]));
    }

    #[test]
    fn a_wide_letter_takes_two_columns() {
        let buffer = drawn(5, 1, |board| {
            board.over([0, 0], "梁", Style::new());
            assert!(!board.sign_if_free([1, 0], '|', Style::new()));
            assert!(board.word([2, 0], "x", Style::new()));
        });
        assert_eq!(buffer, Buffer::with_lines(["梁x  "]));
    }

    #[test]
    fn a_line_is_straight_and_has_both_ends() {
        assert_eq!(way([0, 0], [3, 0]), [[0, 0], [1, 0], [2, 0], [3, 0]]);
        assert_eq!(way([3, 1], [0, 0]), [[3, 1], [2, 1], [1, 0], [0, 0]]);
        assert_eq!(way([1, 1], [1, 1]), [[1, 1]]);
    }
}

//! The dots of a plot area, gathered in cells.

use ratatui::symbols::braille::BRAILLE;
use ratatui::symbols::pixel::QUADRANTS as QUARTERS;

use super::axis::{Direction, Ruler};
use super::chart::Glyphs;

/// What stands in one cell.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Cell {
    /// A bit a dot, row by row.
    bits: u8,
    /// The curve that drew here last; its style is the cell's.
    pub(super) curve: Option<usize>,
    /// Whether the curve's marker stands here instead of dots.
    pub(super) marked: bool,
}

impl Cell {
    /// Two columns of four dots as a braille character.
    pub(super) fn braille(self) -> char {
        BRAILLE[usize::from(self.bits)]
    }

    /// Two columns of two dots as quarters of a block.
    pub(super) fn quarters(self) -> char {
        QUARTERS[usize::from(self.bits % 16)]
    }
}

/// A grid of cells, each of as many dots as its character can show.
#[derive(Debug)]
pub(super) struct Dots {
    pub(super) across: Ruler,
    pub(super) down: Ruler,
    cells: Vec<Cell>,
}

impl Dots {
    pub(super) fn new([across, down]: [Ruler; 2]) -> Self {
        let cells = usize::from(across.cells) * usize::from(down.cells);
        Self {
            across,
            down,
            cells: vec![Cell::default(); cells],
        }
    }

    /// Draws a dot of `curve`; the dot must lie on the grid.
    pub(super) fn draw(&mut self, column: u16, row: u16, curve: usize) {
        let (wide, high) = (self.across.dots_per_cell, self.down.dots_per_cell);
        let bit = (row % high) * wide + column % wide;
        let cell = self.cell_mut(column / wide, row / high);
        cell.bits |= 1 << bit;
        cell.curve = Some(curve);
    }

    /// Puts the marker of `curve` into a cell.
    pub(super) fn mark(&mut self, column: u16, row: u16, curve: usize) {
        let cell = self.cell_mut(column, row);
        cell.curve = Some(curve);
        cell.marked = true;
    }

    pub(super) fn cell(&self, column: u16, row: u16) -> Cell {
        self.cells[self.index(column, row)]
    }

    /// Whether no curve drew anything.
    pub(super) fn is_blank(&self) -> bool {
        self.cells.iter().all(|cell| cell.curve.is_none())
    }

    fn cell_mut(&mut self, column: u16, row: u16) -> &mut Cell {
        let index = self.index(column, row);
        &mut self.cells[index]
    }

    fn index(&self, column: u16, row: u16) -> usize {
        usize::from(row) * usize::from(self.across.cells) + usize::from(column)
    }
}

/// The rulers across and down an area of `columns` by `rows` cells.
pub(super) fn rulers(columns: u16, rows: u16, glyphs: Glyphs) -> [Ruler; 2] {
    let (wide, high) = match glyphs {
        Glyphs::Braille => (2, 4),
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

//! The dots of a plot area and their cells; ratatui's canvas draws them.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Color;
use ratatui::symbols::Marker;
use ratatui::widgets::Widget;
use ratatui::widgets::canvas::{Canvas, Painter, Shape};

use super::axis::Ruler;

/// The curve in one cell.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct DotCell {
    /// The curve that drew here last; it gives the cell its style.
    pub(super) curve: Option<usize>,
    /// Whether the cell shows the curve's marker instead of dots.
    pub(super) marked: bool,
}

/// A dot of a curve; column and row count dots from the top left.
#[derive(Debug, Clone, Copy)]
struct Dot {
    column: u16,
    row: u16,
    curve: usize,
}

/// A grid of cells; a cell has as many dots as its character can show.
#[derive(Debug)]
pub(super) struct Dots {
    pub(super) across: Ruler,
    pub(super) down: Ruler,
    /// In the order in which they are drawn.
    drawn: Vec<Dot>,
    cells: Vec<DotCell>,
}

/// Dots of one curve and their colour, as a shape for the canvas.
struct CurveDots<'d>(&'d [Dot], Color);

impl Shape for CurveDots<'_> {
    fn draw(&self, painter: &mut Painter<'_, '_>) {
        for dot in self.0 {
            painter.paint(usize::from(dot.column), usize::from(dot.row), self.1);
        }
    }
}

impl Dots {
    pub(super) fn new([across, down]: [Ruler; 2]) -> Self {
        let cells = usize::from(across.cells) * usize::from(down.cells);
        Self {
            across,
            down,
            drawn: Vec::new(),
            cells: vec![DotCell::default(); cells],
        }
    }

    /// Draws a dot of `curve`; the dot must lie on the grid.
    pub(super) fn draw(&mut self, column: u16, row: u16, curve: usize) {
        self.drawn.push(Dot { column, row, curve });
        let cell = [
            column / self.across.dots_per_cell,
            row / self.down.dots_per_cell,
        ];
        self.cell_mut(cell[0], cell[1]).curve = Some(curve);
    }

    /// Puts the marker of `curve` into a cell.
    pub(super) fn mark(&mut self, column: u16, row: u16, curve: usize) {
        let cell = self.cell_mut(column, row);
        cell.curve = Some(curve);
        cell.marked = true;
    }

    pub(super) fn cell(&self, column: u16, row: u16) -> DotCell {
        self.cells[self.index(column, row)]
    }

    /// Whether no curve drew anything.
    pub(super) fn is_blank(&self) -> bool {
        self.cells.iter().all(|cell| cell.curve.is_none())
    }

    /// Draws the dots into an area; `marker` returns a curve's marker grid, `colour` its colour.
    ///
    /// Curves with the same marker grid share the dots of a cell; otherwise the later curve covers the earlier one.
    pub(super) fn render(
        &self,
        area: Rect,
        buffer: &mut Buffer,
        marker: impl Fn(usize) -> Marker,
        colour: impl Fn(usize) -> Color,
    ) {
        let paint = |context: &mut ratatui::widgets::canvas::Context<'_>| {
            let mut last = None;
            for run in self.drawn.chunk_by(|dot, next| dot.curve == next.curve) {
                let curve = run[0].curve;
                let marker = marker(curve);
                if last.replace(marker) != Some(marker) {
                    context.marker(marker);
                }
                context.draw(&CurveDots(run, colour(curve)));
            }
        };
        Canvas::default().paint(paint).render(area, buffer);
    }

    fn cell_mut(&mut self, column: u16, row: u16) -> &mut DotCell {
        let index = self.index(column, row);
        &mut self.cells[index]
    }

    fn index(&self, column: u16, row: u16) -> usize {
        usize::from(row) * usize::from(self.across.cells) + usize::from(column)
    }
}

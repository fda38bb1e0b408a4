//! Places for the characters that tell curves apart without colour.

use super::dots::Dots;
use super::pen::Rows;

/// Cells from one marker of a curve to its next, about.
const SPACING: u16 = 20;
/// What it costs to hide another curve, in cells off the intended place.
const HIDING: u16 = 6;
/// What it costs for each row the curve covers beyond one, likewise: a marker must not hide a peak.
const STEEPNESS: u16 = 4;

/// Marks `curve` a few times where it runs flat and alone.
///
/// `turn` of `turns` staggers the curves, so that curves that coincide can all be read.
pub(super) fn mark(
    dots: &mut Dots,
    covered: &[Option<Rows>],
    curve: usize,
    [turn, turns]: [usize; 2],
) {
    let cells = dots.across.cells;
    let count = (cells / SPACING).clamp(1, 4);
    let length = f64::from(cells) / f64::from(count);
    for section in 0..count {
        let start = (f64::from(section) * length).round() as u16;
        let end = (f64::from(section + 1) * length).round() as u16;
        let aim = f64::from(start) + (turn as f64 + 0.5) / turns as f64 * length;
        let candidates = (start..end.min(cells)).filter_map(|column| {
            let (top, bottom) = rows(dots, covered, column)?;
            let row = top.midpoint(bottom);
            let cell = dots.cell(column, row);
            let hides = u16::from(cell.curve.is_some_and(|top| top != curve)) * HIDING;
            let cost = column.abs_diff(aim as u16) + (bottom - top) * STEEPNESS + hides;
            (!cell.marked).then_some((cost, column, row))
        });
        if let Some((_, column, row)) = candidates.min() {
            dots.mark(column, row, curve);
        }
    }
}

/// The rows of cells the curve covers in a column of cells.
fn rows(dots: &Dots, covered: &[Option<Rows>], column: u16) -> Option<Rows> {
    let wide = usize::from(dots.across.dots_per_cell);
    let strokes = covered
        .iter()
        .skip(usize::from(column) * wide)
        .take(wide)
        .flatten();
    let (top, bottom) = strokes.fold((u16::MAX, 0), |(top, bottom), stroke| {
        (top.min(stroke.0), bottom.max(stroke.1))
    });
    let high = dots.down.dots_per_cell;
    (top <= bottom).then_some((top / high, bottom / high))
}

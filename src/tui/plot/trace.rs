//! Draws curves over an ascending abscissa into dots.

use super::axis::Ruler;
use super::chart::Chart;
use super::curve::{Curve, LineStyle};
use super::dots::Dots;
use super::level::{HALF_TURN, Level};
use super::stroke::{RowSpan, StrokePainter};

/// Approximate cells between two markers of a curve.
const SPACING: u16 = 20;
/// Cost of hiding another curve, in cells away from the target position.
const HIDING: u16 = 6;
/// Cost of each row beyond one that the curve covers: a marker must not hide a peak.
const STEEPNESS: u16 = 4;

/// Draws all curves, dim ones first, and their markers over them.
pub(super) fn trace(chart: &Chart<'_>, dots: &mut Dots) {
    let traced: Vec<_> = order(chart)
        .map(|index| (index, trace_curve(chart, index, dots)))
        .collect();
    for (index, covered) in &traced {
        match chart.curves[*index] {
            Curve {
                line: LineStyle::Points { apart },
                ..
            } => mark_samples(chart, *index, apart, dots),
            Curve {
                marker: Some(_), ..
            } => mark(dots, covered, *index, [*index, chart.curves.len()]),
            _ => {}
        }
    }
}

/// The drawing order of the curves: dim ones first.
pub(super) fn order(chart: &Chart<'_>) -> impl Iterator<Item = usize> {
    let (dim, bright): (Vec<usize>, Vec<usize>) =
        (0..chart.curves.len()).partition(|index| chart.curves[*index].dim);
    dim.into_iter().chain(bright)
}

/// Marks the samples of a curve, at least `apart` columns from each other.
fn mark_samples(chart: &Chart<'_>, index: usize, apart: u16, dots: &mut Dots) {
    let mut free = 0;
    for (abscissa, value) in chart.curves[index].samples() {
        let column = dots.across.cell(chart.x.fraction(abscissa));
        let row = dots.down.cell(chart.y.fraction(chart.level.value(value)));
        if let (Some(column), Some(row)) = (column, row)
            && (column >= free || apart == 0)
        {
            dots.mark(column, row, index);
            free = column + apart;
        }
    }
}

/// Draws a curve; returns the rows it covers in each dot column.
fn trace_curve(chart: &Chart<'_>, index: usize, dots: &mut Dots) -> Vec<Option<RowSpan>> {
    let curve = &chart.curves[index];
    let (across, down) = (dots.across, dots.down);
    let mut painter = StrokePainter::new(dots, index, curve.line);
    if matches!(curve.line, LineStyle::Points { .. }) {
        return painter.finish();
    }
    let mut before = f64::NAN;
    for (abscissa, value) in curve.samples() {
        let value = chart.level.value(value);
        if chart.level == Level::Degrees && (value - before).abs() > HALF_TURN {
            painter.end_line();
        }
        before = value;
        painter.line_to(
            across.dot(chart.x.fraction(abscissa)),
            down.dot(chart.y.fraction(value)),
        );
    }
    let mut covered = painter.finish();
    for column in pole_dots(chart, index, across) {
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

/// The dot columns of a curve's poles, if the level rises at poles.
fn pole_dots(chart: &Chart<'_>, index: usize, across: Ruler) -> impl Iterator<Item = u16> {
    let poles = chart.curves[index].poles.iter();
    poles
        .filter(|pole| chart.level.rises_at_poles() && chart.x.contains(**pole))
        .map(move |pole| across.dot(chart.x.fraction(*pole)).round() as u16)
}

/// The cells in the top row of the plot at which a curve has a pole, and the curve.
pub(super) fn pole_cells(chart: &Chart<'_>, across: Ruler) -> Vec<(u16, usize)> {
    if chart.nyquist {
        return Vec::new();
    }
    let cells = |index| {
        let dots = pole_dots(chart, index, across);
        dots.map(move |dot| (dot / across.dots_per_cell, index))
    };
    (0..chart.curves.len()).flat_map(cells).collect()
}

/// Marks `curve` a few times where it is flat and alone.
///
/// `turn` of `turns` staggers the markers, so that coincident curves can all be read.
fn mark(dots: &mut Dots, covered: &[Option<RowSpan>], curve: usize, [turn, turns]: [usize; 2]) {
    let cells = dots.across.cells;
    let count = (cells / SPACING).clamp(1, 4);
    let length = f64::from(cells) / f64::from(count);
    for section in 0..count {
        let start = (f64::from(section) * length).round() as u16;
        let end = (f64::from(section + 1) * length).round() as u16;
        let target = f64::from(start) + (turn as f64 + 0.5) / turns as f64 * length;
        let candidates = (start..end.min(cells)).filter_map(|column| {
            let (top, bottom) = rows(dots, covered, column)?;
            let row = top.midpoint(bottom);
            let cell = dots.cell(column, row);
            let hides = u16::from(cell.curve.is_some_and(|top| top != curve)) * HIDING;
            let cost = column.abs_diff(target as u16) + (bottom - top) * STEEPNESS + hides;
            (!cell.marked).then_some((cost, column, row))
        });
        if let Some((_, column, row)) = candidates.min() {
            dots.mark(column, row, curve);
        }
    }
}

/// The rows of cells the curve covers in a column of cells.
fn rows(dots: &Dots, covered: &[Option<RowSpan>], column: u16) -> Option<RowSpan> {
    let wide = usize::from(dots.across.dots_per_cell);
    let spans = covered
        .iter()
        .skip(usize::from(column) * wide)
        .take(wide)
        .flatten();
    let (top, bottom) = spans.fold((u16::MAX, 0), |(top, bottom), span| {
        (top.min(span.0), bottom.max(span.1))
    });
    let high = dots.down.dots_per_cell;
    (top <= bottom).then_some((top / high, bottom / high))
}

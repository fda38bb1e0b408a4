//! Curves over a rising abscissa, drawn into dots.

use super::axis::Ruler;
use super::chart::Chart;
use super::curve::{Curve, LineStyle};
use super::dots::Dots;
use super::level::{HALF_TURN, Level};
use super::markers::mark;
use super::pen::{Pen, Rows};

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

/// The curves in the order in which they are drawn: dim ones beneath all others.
pub(super) fn order(chart: &Chart<'_>) -> impl Iterator<Item = usize> {
    let (dim, bright): (Vec<usize>, Vec<usize>) =
        (0..chart.curves.len()).partition(|index| chart.curves[*index].dim);
    dim.into_iter().chain(bright)
}

/// Puts the marker of a curve at its samples, some cells apart.
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

/// Draws a curve; the rows it covers in each dot column.
fn trace_curve(chart: &Chart<'_>, index: usize, dots: &mut Dots) -> Vec<Option<Rows>> {
    let curve = &chart.curves[index];
    let (across, down) = (dots.across, dots.down);
    let mut pen = Pen::new(dots, index, curve.line);
    if matches!(curve.line, LineStyle::Points { .. }) {
        return pen.finish();
    }
    let mut before = f64::NAN;
    for (abscissa, value) in curve.samples() {
        let value = chart.level.value(value);
        if chart.level == Level::Degrees && (value - before).abs() > HALF_TURN {
            pen.lift();
        }
        before = value;
        pen.draw_to(
            across.dot(chart.x.fraction(abscissa)),
            down.dot(chart.y.fraction(value)),
        );
    }
    let mut covered = pen.finish();
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

/// The dot columns of a curve's poles, where it goes up at them.
fn pole_dots(chart: &Chart<'_>, index: usize, across: Ruler) -> impl Iterator<Item = u16> {
    let poles = chart.curves[index].poles.iter();
    poles
        .filter(|pole| chart.level.rises_at_poles() && chart.x.contains(**pole))
        .map(move |pole| across.dot(chart.x.fraction(*pole)).round() as u16)
}

/// The cells at the plot's top to which a curve goes up at a pole, and the curve.
pub(super) fn pole_cells(chart: &Chart<'_>, across: Ruler) -> Vec<(u16, usize)> {
    if chart.free {
        return Vec::new();
    }
    let cells = |index| {
        let dots = pole_dots(chart, index, across);
        dots.map(move |dot| (dot / across.dots_per_cell, index))
    };
    (0..chart.curves.len()).flat_map(cells).collect()
}

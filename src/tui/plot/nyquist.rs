//! Nyquist plots: curves in any direction over axes of equal scale.

use ratatui::layout::Rect;

use super::axis::{Axis, Ruler};
use super::chart::Chart;
use super::curve::{Curve, LineStyle};
use super::dots::Dots;
use super::glyphs::{Glyphs, rulers};
use super::layout::ChartLayout;
use super::level::{FINE_STEPS, Level, signed_axis};
use super::trace::order;

/// Markers along a curve.
const MARKERS: usize = 3;
/// Most iterations of the layout: labels depend on the bounds, and the plot size on the labels.
const TRIES: usize = 6;
/// Margin on each side of a curve, as a fraction of its extent.
const MARGIN: f64 = 0.03;
/// Height of a cell in widths of a cell.
const CELL_HEIGHT: f64 = 2.0;

/// A range with a margin at both ends.
fn with_margin([low, high]: [f64; 2]) -> [f64; 2] {
    let margin = MARGIN * (high - low);
    [low - margin, high + margin]
}

/// Axes for Nyquist curves, with `units` for x and y: between `bounds`, or around the finite points of the curves and 0.
pub fn nyquist_axes(
    curves: &[Curve<'_>],
    bounds: [Option<[f64; 2]>; 2],
    units: [String; 2],
) -> [Axis; 2] {
    let points = curves.iter().flat_map(Curve::samples);
    let finite = points.filter(|(x, y)| x.is_finite() && y.is_finite());
    let [across, up] = finite.fold([[0.0_f64; 2]; 2], |[x, y], point| {
        [
            [x[0].min(point.0), x[1].max(point.0)],
            [y[0].min(point.1), y[1].max(point.1)],
        ]
    });
    let axis = |bounds: Option<[f64; 2]>, extent, unit: String| match bounds {
        Some(bounds) => Level::Signed.axis_between(bounds, unit),
        None => signed_axis(with_margin(extent), FINE_STEPS, unit),
    };
    let [x_unit, y_unit] = units;
    [axis(bounds[0], across, x_unit), axis(bounds[1], up, y_unit)]
}

impl Chart<'_> {
    /// The same chart with axes of equal scale when it is drawn into `area`: the span of one axis grows about its
    /// middle.
    #[must_use]
    pub fn equalised(mut self, area: Rect) -> Self {
        let bounds = [self.x.bounds(), self.y.bounds()];
        for _ in 0..TRIES {
            let layout = ChartLayout::new(&self, area);
            let [x, y] = equal(bounds, layout.plot, self.glyphs);
            let settled = self.x.bounds() == x && self.y.bounds() == y;
            self.label_columns = self.label_columns.max(layout.label_columns);
            self.x = with_bounds(&self.x, x);
            self.y = with_bounds(&self.y, y);
            if settled {
                break;
            }
        }
        self
    }
}

/// The axis with other bounds.
fn with_bounds(axis: &Axis, bounds: [f64; 2]) -> Axis {
    Level::Signed.axis_between(bounds, axis.unit.clone())
}

/// The bounds, one pair widened about its middle so that both axes have the same scale on `plot`.
fn equal(bounds: [[f64; 2]; 2], plot: Rect, glyphs: Glyphs) -> [[f64; 2]; 2] {
    let [across, down] = rulers(plot.width, plot.height, glyphs);
    // Between the centres of the outermost dots, in widths of a cell.
    let length = |ruler: Ruler, cell: f64| {
        f64::from(ruler.dots().saturating_sub(1).max(1)) / f64::from(ruler.dots_per_cell) * cell
    };
    equal_spans(bounds, [length(across, 1.0), length(down, CELL_HEIGHT)])
}

/// The bounds of two axes with these lengths, one pair widened about its middle so that both have the same scale.
pub fn equal_spans(bounds: [[f64; 2]; 2], lengths: [f64; 2]) -> [[f64; 2]; 2] {
    let spans = bounds.map(|[low, high]| high - low);
    let scale = (spans[0] / lengths[0]).max(spans[1] / lengths[1]);
    [0, 1].map(|i| {
        let middle = f64::midpoint(bounds[i][0], bounds[i][1]);
        let half = scale * lengths[i] / 2.0;
        [middle - half, middle + half]
    })
}

/// Draws all curves, dim ones first, and their markers over them.
pub(super) fn trace(chart: &Chart<'_>, dots: &mut Dots) {
    for index in order(chart) {
        let curve = &chart.curves[index];
        if let LineStyle::Points { apart } = curve.line {
            mark_samples(chart, index, apart, dots);
            continue;
        }
        let cells = draw(chart, index, dots);
        if curve.marker.is_some() {
            mark(&cells, index, dots);
        }
    }
}

/// The position of each sample, in dots from the top left.
fn positions(chart: &Chart<'_>, index: usize, dots: &Dots) -> impl Iterator<Item = [f64; 2]> {
    let (across, down) = (dots.across, dots.down);
    let samples = chart.curves[index].samples();
    samples.map(move |(x, y)| {
        [
            across.dot(chart.x.fraction(x)),
            down.dot(chart.y.fraction(y)),
        ]
    })
}

/// Joins the samples of a curve; returns the cells it passes through, in their order.
fn draw(chart: &Chart<'_>, index: usize, dots: &mut Dots) -> Vec<(u16, u16)> {
    let line = chart.curves[index].line;
    let (size, per_cell) = (
        [dots.across.dots(), dots.down.dots()],
        [dots.across.dots_per_cell, dots.down.dots_per_cell],
    );
    let within = size.map(|dots| [-0.5, f64::from(dots) - 0.5]);
    let mut cells: Vec<(u16, u16)> = Vec::new();
    let (mut last, mut before, mut distance) = (None, None, 0);
    for position in positions(chart, index, dots).collect::<Vec<_>>() {
        if !position.iter().all(|coordinate| coordinate.is_finite()) {
            (last, before) = (None, None);
            continue;
        }
        let segment = clipped(last.unwrap_or(position), position, within);
        last = Some(position);
        for dot in segment.into_iter().flat_map(|ends| between(ends, size)) {
            if before.replace(dot) == Some(dot) {
                continue;
            }
            let cell = (dot[0] / per_cell[0], dot[1] / per_cell[1]);
            if cells.last() != Some(&cell) {
                cells.push(cell);
            }
            if line.draws(distance) {
                dots.draw(dot[0], dot[1], index);
            }
            distance += 1;
        }
    }
    cells
}

/// The part of a segment inside a rectangle; upper bounds are exclusive (Liang and Barsky, A new concept and method for
/// line clipping, 1984).
pub fn clipped(from: [f64; 2], to: [f64; 2], within: [[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for i in 0..2 {
        let [low, high] = within[i];
        let run = to[i] - from[i];
        if run == 0.0 {
            if from[i] < low || from[i] >= high {
                return None;
            }
            continue;
        }
        let (a, b) = ((low - from[i]) / run, (high - from[i]) / run);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    let at = |t: f64| [0, 1].map(|i| from[i] + t * (to[i] - from[i]));
    (enter <= leave).then(|| [at(enter), at(leave)])
}

/// The dots of a segment inside the grid of `size`, both ends included.
fn between([from, to]: [[f64; 2]; 2], size: [u16; 2]) -> impl Iterator<Item = [u16; 2]> {
    let run = [to[0] - from[0], to[1] - from[1]];
    let steps = run[0].abs().max(run[1].abs()).ceil() as u32;
    (0..=steps).map(move |step| {
        let part = f64::from(step) / f64::from(steps.max(1));
        [0, 1].map(|i| {
            let dot = (from[i] + part * run[i]).round();
            dot.clamp(0.0, f64::from(size[i].saturating_sub(1))) as u16
        })
    })
}

/// Marks the samples of a curve, at least `apart` cells from each other in one direction.
fn mark_samples(chart: &Chart<'_>, index: usize, apart: u16, dots: &mut Dots) {
    let (across, down) = (dots.across, dots.down);
    let mut last: Option<(u16, u16)> = None;
    for (x, y) in chart.curves[index].samples() {
        let column = across.cell(chart.x.fraction(x));
        let Some(cell) = column.zip(down.cell(chart.y.fraction(y))) else {
            continue;
        };
        let distance = last.map(|last| last.0.abs_diff(cell.0).max(last.1.abs_diff(cell.1)));
        if distance.is_none_or(|distance| distance >= apart) {
            dots.mark(cell.0, cell.1, index);
            last = Some(cell);
        }
    }
}

/// Marks a curve at a few even distances.
fn mark(cells: &[(u16, u16)], index: usize, dots: &mut Dots) {
    for part in 0..MARKERS {
        let target = (2 * part + 1) * cells.len() / (2 * MARKERS);
        let free = cells[target..]
            .iter()
            .find(|cell| !dots.cell(cell.0, cell.1).marked);
        if let Some((column, row)) = free {
            dots.mark(*column, *row, index);
        }
    }
}

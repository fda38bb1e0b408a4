//! Curves that run in any direction, and axes on which equal differences have equal lengths both ways.

use ratatui::layout::Rect;

use super::axis::{Axis, Ruler};
use super::chart::Chart;
use super::curve::{Curve, LineStyle};
use super::dots::Dots;
use super::glyphs::{Glyphs, rulers};
use super::layout::Layout;
use super::level::{FINE_STEPS, Level, signed_axis};
use super::trace::order;

/// Markers along a locus.
const MARKERS: usize = 3;
/// How many times the layout is sought anew: labels change with the bounds, and the plot with the labels.
const TRIES: usize = 6;
/// Room beyond a locus on each side, as a part of what it spans.
const MARGIN: f64 = 0.03;
/// A cell is so many times as high as it is wide.
const CELL_HEIGHT: f64 = 2.0;

/// A range with room at its ends.
fn with_margin([low, high]: [f64; 2]) -> [f64; 2] {
    let margin = MARGIN * (high - low);
    [low - margin, high + margin]
}

/// Axes for loci, in `units` across and up: between `bounds`, or around the finite points of the curves and 0.
pub fn locus_axes(
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
    /// The same chart with axes on which equal differences have equal lengths both ways when it is drawn into `area`:
    /// one of the axes spans more than before, with the same middle.
    #[must_use]
    pub fn equalised(mut self, area: Rect) -> Self {
        let bounds = [self.x.bounds(), self.y.bounds()];
        for _ in 0..TRIES {
            let layout = Layout::new(&self, area);
            let [x, y] = equal(bounds, layout.plot, self.glyphs);
            let settled = self.x.bounds() == x && self.y.bounds() == y;
            self.label_columns = self.label_columns.max(layout.label_columns);
            self.x = respanned(&self.x, x);
            self.y = respanned(&self.y, y);
            if settled {
                break;
            }
        }
        self
    }
}

/// The axis with other bounds.
fn respanned(axis: &Axis, bounds: [f64; 2]) -> Axis {
    Level::Signed.axis_between(bounds, axis.unit.clone())
}

/// The bounds, one pair of them widened about its middle so that both axes have the same scale on `plot`.
fn equal(bounds: [[f64; 2]; 2], plot: Rect, glyphs: Glyphs) -> [[f64; 2]; 2] {
    let [across, down] = rulers(plot.width, plot.height, glyphs);
    // Between the centres of the outermost dots, in widths of a cell.
    let length = |ruler: Ruler, cell: f64| {
        f64::from(ruler.dots().saturating_sub(1).max(1)) / f64::from(ruler.dots_per_cell) * cell
    };
    equal_spans(bounds, [length(across, 1.0), length(down, CELL_HEIGHT)])
}

/// The bounds of two axes with these lengths, one pair of them widened about its middle so that equal differences have
/// equal lengths on both.
pub fn equal_spans(bounds: [[f64; 2]; 2], lengths: [f64; 2]) -> [[f64; 2]; 2] {
    let spans = bounds.map(|[low, high]| high - low);
    let scale = (spans[0] / lengths[0]).max(spans[1] / lengths[1]);
    [0, 1].map(|i| {
        let middle = f64::midpoint(bounds[i][0], bounds[i][1]);
        let reach = scale * lengths[i] / 2.0;
        [middle - reach, middle + reach]
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

/// The place of each sample in dots from the top left.
fn places(chart: &Chart<'_>, index: usize, dots: &Dots) -> impl Iterator<Item = [f64; 2]> {
    let (across, down) = (dots.across, dots.down);
    let samples = chart.curves[index].samples();
    samples.map(move |(x, y)| {
        [
            across.dot(chart.x.fraction(x)),
            down.dot(chart.y.fraction(y)),
        ]
    })
}

/// Joins the samples of a curve; the cells it goes through, in their order.
fn draw(chart: &Chart<'_>, index: usize, dots: &mut Dots) -> Vec<(u16, u16)> {
    let line = chart.curves[index].line;
    let (size, per_cell) = (
        [dots.across.dots(), dots.down.dots()],
        [dots.across.dots_per_cell, dots.down.dots_per_cell],
    );
    let within = size.map(|dots| [-0.5, f64::from(dots) - 0.5]);
    let mut cells: Vec<(u16, u16)> = Vec::new();
    let (mut last, mut before, mut passed) = (None, None, 0);
    for place in places(chart, index, dots).collect::<Vec<_>>() {
        if !place.iter().all(|coordinate| coordinate.is_finite()) {
            (last, before) = (None, None);
            continue;
        }
        let segment = clipped(last.unwrap_or(place), place, within);
        last = Some(place);
        for dot in segment.into_iter().flat_map(|ends| between(ends, size)) {
            if before.replace(dot) == Some(dot) {
                continue;
            }
            let cell = (dot[0] / per_cell[0], dot[1] / per_cell[1]);
            if cells.last() != Some(&cell) {
                cells.push(cell);
            }
            if line.draws(passed) {
                dots.draw(dot[0], dot[1], index);
            }
            passed += 1;
        }
    }
    cells
}

/// The part of a segment that is within a rectangle, from the lower to below the upper bound of each coordinate (Liang
/// and Barsky, A new concept and method for line clipping, 1984).
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

/// The dots of a segment that is within them, both ends with it.
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

/// Puts the marker of a curve at its samples, as many cells apart in either direction.
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

/// Puts a few markers evenly along a curve.
fn mark(cells: &[(u16, u16)], index: usize, dots: &mut Dots) {
    for part in 0..MARKERS {
        let aim = (2 * part + 1) * cells.len() / (2 * MARKERS);
        let free = cells[aim..]
            .iter()
            .find(|cell| !dots.cell(cell.0, cell.1).marked);
        if let Some((column, row)) = free {
            dots.mark(*column, *row, index);
        }
    }
}

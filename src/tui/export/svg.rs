//! The chart as an SVG drawing on white that is readable without colour.

mod curve_style;
mod frame;
mod page;
mod path;

use super::{Provenance, marks, names};
use crate::tui::plot::{Level, equal_spans};
use crate::tui::scene::axes::{Loci, Ruled, frequency_axis, nearest};
use crate::tui::scene::{ChartView, CurveKind, Scene};
use curve_style::{CurveStyle, legend, styles};
use frame::{Labels, PlotFrame};
use page::Page;
use path::CurvePath;

/// Sizes on the page, px.
const WIDTH: f64 = 800.0;
const LEFT: f64 = 100.0;
const RIGHT: f64 = 22.0;
/// Plot heights: one panel, two equal panels, and two panels with the phase below.
const SINGLE: f64 = 400.0;
const HALVES: [f64; 2] = [220.0, 220.0];
const OVER_PHASE: [f64; 2] = [270.0, 180.0];
/// Between two panels.
const GAP: f64 = 18.0;
/// Room for mark labels above the plot, and for axis labels below it.
const ABOVE: f64 = 20.0;
const BELOW: f64 = 44.0;
/// The minimum and maximum height of a Nyquist plot.
const NYQUIST_HEIGHTS: [f64; 2] = [240.0, 700.0];
/// Line height of the footer.
const FOOTER_LINE: f64 = 12.0;
/// Letters in a line of the footer.
const FOOTER_LETTERS: usize = 125;
/// Most numbered modes on a Nyquist plot.
const NUMBERED_MODES: usize = 9;

/// The chart as deterministic SVG 1.1: title, legend, axes with ticks, labels and units, curves, cursors, band and
/// modes, and the provenance in a footer and in the metadata.
///
/// Curves differ by colours with enough contrast on white, by dashes and by markers. A path has at most some thousand
/// points; peaks narrower than a pixel keep their height.
pub fn svg(scene: &Scene, provenance: &Provenance) -> String {
    let mut page = Page::new(WIDTH);
    let title = if scene.title.is_empty() {
        &provenance.model
    } else {
        &scene.title
    };
    page.heading(title, 26.0);
    page.text([WIDTH / 2.0, 44.0], &provenance.model, "class=\"sub\"");
    let names = names(scene);
    let styles = styles(scene);
    let top = legend(&mut page, &styles, &names, [LEFT, 62.0, WIDTH - RIGHT]) + ABOVE;
    let bottom = if scene.view == ChartView::Nyquist {
        draw_nyquist(&mut page, scene, &styles, top)
    } else {
        draw_panels(&mut page, scene, &styles, top)
    };
    let footer = footer(scene, provenance);
    let mut y = bottom + BELOW + FOOTER_LINE;
    for line in &footer {
        page.text([LEFT, y], line, "class=\"print\"");
        y += FOOTER_LINE;
    }
    page.finish(y, title, &footer.join("\n"))
}

/// The provenance and the marks, in lines.
fn footer(scene: &Scene, provenance: &Provenance) -> Vec<String> {
    let mut words = vec![
        format!("{}, {}", provenance.program, provenance.source),
        format!("model sha256 {}", provenance.hash),
        provenance.method.clone(),
        "amplitudes zero to peak".to_owned(),
    ];
    words.extend(provenance.notes.iter().cloned());
    words.extend(marks(scene));
    let mut lines: Vec<String> = Vec::new();
    for word in words {
        match lines.last_mut() {
            Some(line) if line.chars().count() + word.chars().count() < FOOTER_LETTERS => {
                line.push_str("; ");
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

/// Draws the panels over frequency from `top` down; returns the bottom of the lowest one.
fn draw_panels(page: &mut Page, scene: &Scene, styles: &[CurveStyle], top: f64) -> f64 {
    let ruled = Ruled::new(scene);
    let heading = scene.frequency.unit.heading();
    let heights: &[f64] = match scene.panels.as_slice() {
        [] => &[],
        [_] => &[SINGLE],
        [_, lower, ..] if lower.level == Level::Degrees => &OVER_PHASE,
        _ => &HALVES,
    };
    let mut y = top;
    for (panel, height) in heights.iter().enumerate() {
        let frame = PlotFrame {
            x: frequency_axis(scene),
            y: ruled.value_axis(panel),
            left: LEFT,
            top: y,
            width: WIDTH - LEFT - RIGHT,
            height: *height,
        };
        let lowest = panel + 1 == heights.len();
        let labels = Labels {
            across: lowest.then_some(&*heading),
            up: frame.y.unit(),
        };
        frame.draw_band(page, scene);
        frame.draw_grid(page);
        frame.draw_marks(page, scene, panel == 0);
        let level = scene.panels[panel].level;
        let paths: Vec<_> = ruled
            .curves(panel)
            .map(|(index, curve)| (&styles[index], path::over_frequency(&frame, &curve, level)))
            .collect();
        draw_curves(page, &frame, &paths);
        frame.draw_axes(page, &labels);
        y += height + if lowest { 0.0 } else { GAP };
    }
    y
}

/// Draws the lines, clipped to the frame, and their markers.
fn draw_curves(page: &mut Page, frame: &PlotFrame, paths: &[(&CurveStyle, CurvePath)]) {
    page.begin_clip([frame.left, frame.top], [frame.width, frame.height]);
    for (style, path) in paths {
        style.draw_line(page, frame, path);
    }
    page.end_clip();
    for (style, path) in paths {
        style.draw_markers(page, frame, path);
    }
}

/// Draws the Nyquist plot with equal axes from `top` down; returns its bottom.
fn draw_nyquist(page: &mut Page, scene: &Scene, styles: &[CurveStyle], top: f64) -> f64 {
    let Some(loci) = Loci::new(scene) else {
        return top;
    };
    let [across, up] = &loci.axes;
    let spans = [across, up].map(|axis| axis.bounds()[1] - axis.bounds()[0]);
    let width = WIDTH - LEFT - RIGHT;
    let height = (width * spans[1] / spans[0]).clamp(NYQUIST_HEIGHTS[0], NYQUIST_HEIGHTS[1]);
    let equal = equal_spans([across.bounds(), up.bounds()], [width, height]);
    let axis = |i: usize| Level::Signed.axis_between(equal[i], loci.axes[i].unit());
    let frame = PlotFrame {
        x: axis(0),
        y: axis(1),
        left: LEFT,
        top,
        width,
        height,
    };
    frame.draw_grid(page);
    let each = styles.iter().zip(&loci.points);
    let paths: Vec<_> = each
        .map(|(style, points)| (style, path::nyquist(&frame, points)))
        .collect();
    draw_curves(page, &frame, &paths);
    draw_spots(page, scene, &frame);
    let labels = Labels {
        across: Some(loci.axes[0].unit()),
        up: loci.axes[1].unit(),
    };
    frame.draw_axes(page, &labels);
    top + height
}

/// Draws the modes on the first curve of the model, and the values at the cursor.
fn draw_spots(page: &mut Page, scene: &Scene, frame: &PlotFrame) {
    let first = scene
        .curves
        .iter()
        .find(|curve| curve.kind == CurveKind::Model);
    for (mode, number) in scene.marks.modes.iter().zip(1..=NUMBERED_MODES) {
        if let Some((x, y)) = first.and_then(|curve| nearest(curve, *mode, scene))
            && let Some([x, y]) = frame.inside(x, y)
        {
            page.circle([x, y], 2.2, "class=\"mode\"");
            page.text([x + 6.0, y - 4.0], &format!("{number}"), "class=\"mark\"");
        }
    }
    for curve in &scene.curves {
        if let Some([x, y]) = curve.at_cursor.as_deref()
            && let Some(position) = frame.inside(*x, *y)
        {
            page.circle(position, 5.0, "class=\"spot\"");
        }
    }
}

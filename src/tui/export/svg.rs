//! The chart as a drawing: vector, on white, to be read without colour.

mod frame;
mod line;
mod look;
mod page;

use super::{Provenance, marks, names};
use crate::tui::plot::{Level, equal_spans};
use crate::tui::scene::axes::{Loci, Ruled, frequency_axis, nearest};
use crate::tui::scene::{ChartView, CurveKind, Scene};
use frame::{Field, Labels};
use line::Run;
use look::{Look, legend, looks};
use page::Page;

/// Sizes on the page, px.
const WIDTH: f64 = 800.0;
const LEFT: f64 = 100.0;
const RIGHT: f64 = 22.0;
/// The plot of one panel, and the upper and lower one of two: equal ones, or a phase below.
const SINGLE: f64 = 400.0;
const HALVES: [f64; 2] = [220.0, 220.0];
const OVER_PHASE: [f64; 2] = [270.0, 180.0];
/// Between two panels.
const GAP: f64 = 18.0;
/// Room for what is said at the marks above the plot, and for labels beneath it.
const ABOVE: f64 = 20.0;
const BELOW: f64 = 44.0;
/// The least and the greatest height of a locus's plot.
const LOCUS_HEIGHTS: [f64; 2] = [240.0, 700.0];
/// From a line of small print to the next.
const PRINT: f64 = 12.0;
/// Letters of small print in a line.
const PRINT_LETTERS: usize = 125;
/// Modes that are numbered on a locus.
const NUMBERED_MODES: usize = 9;

/// The chart as SVG 1.1, the same text for the same scene: title, legend, axes with ticks, labels and units, the
/// curves, cursors, band and modes, and where all comes from in small print and in the metadata.
///
/// Curves are told apart by colours that can be read on white and by dashes and markers. A path has at most some
/// thousand points; peaks narrower than a pixel keep their height.
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
    let looks = looks(scene);
    let top = legend(&mut page, &looks, &names, [LEFT, 62.0, WIDTH - RIGHT]) + ABOVE;
    let bottom = if scene.view == ChartView::Nyquist {
        draw_locus(&mut page, scene, &looks, top)
    } else {
        draw_panels(&mut page, scene, &looks, top)
    };
    let print = small_print(scene, provenance);
    let mut y = bottom + BELOW + PRINT;
    for line in &print {
        page.text([LEFT, y], line, "class=\"print\"");
        y += PRINT;
    }
    page.finish(y, title, &print.join("\n"))
}

/// Where the drawing comes from, in lines.
fn small_print(scene: &Scene, provenance: &Provenance) -> Vec<String> {
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
            Some(line) if line.chars().count() + word.chars().count() < PRINT_LETTERS => {
                line.push_str("; ");
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

/// Draws the panels over the frequencies from `top` down; where the lowest one ends.
fn draw_panels(page: &mut Page, scene: &Scene, looks: &[Look], top: f64) -> f64 {
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
        let field = Field {
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
            up: field.y.unit(),
        };
        field.draw_band(page, scene);
        field.draw_grid(page);
        field.draw_marks(page, scene, panel == 0);
        let level = scene.panels[panel].level;
        let runs: Vec<_> = ruled
            .curves(panel)
            .map(|(index, curve)| (&looks[index], line::over_frequency(&field, &curve, level)))
            .collect();
        draw_curves(page, &field, &runs);
        field.draw_axes(page, &labels);
        y += height + if lowest { 0.0 } else { GAP };
    }
    y
}

/// Draws lines that end at the frame, and markers over them.
fn draw_curves(page: &mut Page, field: &Field, runs: &[(&Look, Run)]) {
    page.begin_clip([field.left, field.top], [field.width, field.height]);
    for (look, run) in runs {
        look.draw_line(page, field, run);
    }
    page.end_clip();
    for (look, run) in runs {
        look.draw_markers(page, field, run);
    }
}

/// Draws the imaginary over the real parts, with equal axes, from `top` down; where the plot ends.
fn draw_locus(page: &mut Page, scene: &Scene, looks: &[Look], top: f64) -> f64 {
    let Some(loci) = Loci::new(scene) else {
        return top;
    };
    let [across, up] = &loci.axes;
    let spans = [across, up].map(|axis| axis.bounds()[1] - axis.bounds()[0]);
    let width = WIDTH - LEFT - RIGHT;
    let height = (width * spans[1] / spans[0]).clamp(LOCUS_HEIGHTS[0], LOCUS_HEIGHTS[1]);
    let equal = equal_spans([across.bounds(), up.bounds()], [width, height]);
    let axis = |i: usize| Level::Signed.axis_between(equal[i], loci.axes[i].unit());
    let field = Field {
        x: axis(0),
        y: axis(1),
        left: LEFT,
        top,
        width,
        height,
    };
    field.draw_grid(page);
    let each = looks.iter().zip(&loci.points);
    let runs: Vec<_> = each
        .map(|(look, points)| (look, line::locus(&field, points)))
        .collect();
    draw_curves(page, &field, &runs);
    draw_spots(page, scene, &field);
    let labels = Labels {
        across: Some(loci.axes[0].unit()),
        up: loci.axes[1].unit(),
    };
    field.draw_axes(page, &labels);
    top + height
}

/// The modes on the first curve of the model and the values at the cursor.
fn draw_spots(page: &mut Page, scene: &Scene, field: &Field) {
    let first = scene
        .curves
        .iter()
        .find(|curve| curve.kind == CurveKind::Model);
    for (mode, number) in scene.marks.modes.iter().zip(1..=NUMBERED_MODES) {
        if let Some((x, y)) = first.and_then(|curve| nearest(curve, *mode, scene))
            && let Some([x, y]) = field.inside(x, y)
        {
            page.circle([x, y], 2.2, "class=\"mode\"");
            page.text([x + 6.0, y - 4.0], &format!("{number}"), "class=\"mark\"");
        }
    }
    for curve in &scene.curves {
        if let Some([x, y]) = curve.at_cursor.as_deref()
            && let Some(place) = field.inside(*x, *y)
        {
            page.circle(place, 5.0, "class=\"spot\"");
        }
    }
}

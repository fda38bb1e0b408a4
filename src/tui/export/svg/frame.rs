//! The frame around the curves: grid, axes, ticks and labels, cursors and band.

use super::page::Page;
use crate::tui::export::frequency;
use crate::tui::plot::{Axis, AxisTick};
use crate::tui::scene::Scene;

/// Width of a label's letter and height of a line of labels, px.
const LETTER: f64 = 8.0;
const LINE: f64 = 20.0;
/// The lengths of major and minor ticks, px.
const TICKS: [f64; 2] = [6.0, 3.0];
/// Position of the vertical axis label, px from the left.
const LABEL: f64 = 18.0;
/// Width of a harmonic's number, px.
const HARMONIC: f64 = 22.0;
/// Length of a mode's mark above the plot, px.
const MODE: f64 = 5.0;

/// A plot on the page: axes, position and size, px.
#[derive(Debug, Clone)]
pub(super) struct PlotFrame {
    /// The horizontal axis.
    pub(super) x: Axis,
    /// The vertical axis.
    pub(super) y: Axis,
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
}

/// The axis labels.
#[derive(Debug)]
pub(super) struct Labels<'a> {
    /// Below the plot; none if the numbers are below another plot.
    pub(super) across: Option<&'a str>,
    /// Left of the plot.
    pub(super) up: &'a str,
}

impl PlotFrame {
    /// The position of a point on the page, px; not finite where an axis cannot show it.
    pub(super) fn position(&self, x: f64, y: f64) -> [f64; 2] {
        [
            self.left + self.x.fraction(x) * self.width,
            self.top + (1.0 - self.y.fraction(y)) * self.height,
        ]
    }

    /// The position of a point inside the plot; none outside.
    pub(super) fn inside(&self, x: f64, y: f64) -> Option<[f64; 2]> {
        let is_inside = |axis: &Axis, value| (0.0..=1.0).contains(&axis.fraction(value));
        (is_inside(&self.x, x) && is_inside(&self.y, y)).then(|| self.position(x, y))
    }

    /// The bottom of the plot, px.
    fn bottom(&self) -> f64 {
        self.top + self.height
    }

    fn across(&self, fraction: f64) -> f64 {
        self.left + fraction * self.width
    }

    fn up(&self, fraction: f64) -> f64 {
        self.top + (1.0 - fraction) * self.height
    }

    fn ticks(&self) -> [Vec<AxisTick>; 2] {
        [
            self.x.ticks_across((self.width / LETTER) as u16),
            self.y.ticks_up((self.height / LINE) as u16),
        ]
    }

    /// Draws grid lines at the labelled values, darker ones at 0.
    pub(super) fn draw_grid(&self, page: &mut Page) {
        let [across, up] = self.ticks();
        let bottom = self.bottom();
        let right = self.left + self.width;
        for tick in across.iter().filter(|tick| tick.label.is_some()) {
            let x = self.across(tick.fraction);
            page.line([x, self.top], [x, bottom], class(tick));
        }
        for tick in up.iter().filter(|tick| tick.label.is_some()) {
            let y = self.up(tick.fraction);
            page.line([self.left, y], [right, y], class(tick));
        }
    }

    /// Draws the frame with ticks, numbers and labels.
    pub(super) fn draw_axes(&self, page: &mut Page, labels: &Labels<'_>) {
        let size = [self.width, self.height];
        page.rectangle([self.left, self.top], size, "class=\"frame\"");
        let [across, up] = self.ticks();
        let bottom = self.bottom();
        for tick in &across {
            let x = self.across(tick.fraction);
            let length = TICKS[usize::from(tick.label.is_none())];
            page.line([x, bottom], [x, bottom + length], "class=\"tick\"");
            if let (Some((digits, power)), Some(_)) = (raised(tick), labels.across) {
                let text = (digits.as_str(), power.as_deref());
                page.power([x, bottom + 19.0], text, "middle");
            }
        }
        for tick in &up {
            let y = self.up(tick.fraction);
            let length = TICKS[usize::from(tick.label.is_none())];
            page.line([self.left - length, y], [self.left, y], "class=\"tick\"");
            if let Some((digits, power)) = raised(tick) {
                let text = (digits.as_str(), power.as_deref());
                page.power([self.left - 9.0, y + 4.0], text, "end");
            }
        }
        if let Some(label) = labels.across {
            let middle = [self.left + self.width / 2.0, bottom + 38.0];
            page.text(middle, label, "text-anchor=\"middle\"");
        }
        page.upward([LABEL, self.top + self.height / 2.0], labels.up);
    }

    /// Draws the band as a shaded area.
    pub(super) fn draw_band(&self, page: &mut Page, scene: &Scene) {
        let Some(band) = scene.marks.band else {
            return;
        };
        let [low, high] = band.map(|hertz| self.fraction(scene, hertz).clamp(0.0, 1.0));
        if low < high {
            let corner = [self.across(low), self.top];
            let size = [(high - low) * self.width, self.height];
            page.rectangle(corner, size, "class=\"band\"");
        }
    }

    /// Draws the cursors and harmonics; above the topmost plot also their values and the modes.
    pub(super) fn draw_marks(&self, page: &mut Page, scene: &Scene, topmost: bool) {
        let marked = &scene.marks;
        let mut free = self.left;
        for (number, hertz) in (2..).zip(&marked.harmonics) {
            if let Some(x) = self.draw_line(page, scene, *hertz, "class=\"harmonic\"")
                && topmost
                && x >= free
            {
                free = x + HARMONIC;
                let text = format!("{number}\u{d7}");
                let (shift, anchor) = if x + HARMONIC > self.left + self.width {
                    (-2.0, "class=\"mark\" text-anchor=\"end\"")
                } else {
                    (2.0, "class=\"mark\"")
                };
                page.text([x + shift, self.top + 11.0], &text, anchor);
            }
        }
        let cursors = [
            (marked.cursor, "class=\"cursor\""),
            (marked.second, "class=\"second\""),
        ];
        for (cursor, class) in cursors {
            let Some(hertz) = cursor else { continue };
            if let Some(x) = self.draw_line(page, scene, hertz, class)
                && topmost
            {
                let text = frequency(scene, hertz);
                page.text(
                    [x, self.top - 8.0],
                    &text,
                    anchored(marked.cursor, marked.second, hertz),
                );
            }
        }
        for hertz in marked.modes.iter().filter(|_| topmost) {
            let fraction = self.fraction(scene, *hertz);
            if (0.0..=1.0).contains(&fraction) {
                let x = self.across(fraction);
                page.line([x, self.top - MODE], [x, self.top], "class=\"tick\"");
            }
        }
        if topmost && !marked.modes.is_empty() {
            let position = [self.left - 9.0, self.top - 9.0];
            page.text(position, "modes", "class=\"mark\" text-anchor=\"end\"");
        }
    }

    /// Draws a line at a frequency; returns its position, none outside the axis.
    fn draw_line(&self, page: &mut Page, scene: &Scene, hertz: f64, class: &str) -> Option<f64> {
        let fraction = self.fraction(scene, hertz);
        if !(0.0..=1.0).contains(&fraction) {
            return None;
        }
        let x = self.across(fraction);
        page.line([x, self.top], [x, self.bottom()], class);
        Some(x)
    }

    fn fraction(&self, scene: &Scene, hertz: f64) -> f64 {
        self.x.fraction(hertz * scene.frequency.unit.per_hertz())
    }
}

/// The class of a grid line: 0 is darker.
fn class(tick: &AxisTick) -> &'static str {
    if tick.label.as_deref() == Some("0") {
        "class=\"zero\""
    } else {
        "class=\"grid\""
    }
}

/// The text anchor of a cursor's value: with two cursors, outward from the pair.
fn anchored(cursor: Option<f64>, second: Option<f64>, hertz: f64) -> &'static str {
    match (cursor, second) {
        (Some(a), Some(b)) if a != b && hertz == a.min(b) => "class=\"mark\" text-anchor=\"end\"",
        (Some(a), Some(b)) if a != b => "class=\"mark\"",
        _ => "class=\"mark\" text-anchor=\"middle\"",
    }
}

/// Splits a label into digits and power of ten: "5e-7" becomes "5·10" and "−7".
fn raised(tick: &AxisTick) -> Option<(String, Option<String>)> {
    let label = tick.label.as_deref()?;
    let minus = |text: &str| text.replace('-', "\u{2212}");
    Some(match label.split_once('e') {
        Some(("1", power)) => ("10".to_owned(), Some(minus(power))),
        Some(("-1", power)) => (minus("-10"), Some(minus(power))),
        Some((digits, power)) => (format!("{}\u{b7}10", minus(digits)), Some(minus(power))),
        None => (minus(label), None),
    })
}

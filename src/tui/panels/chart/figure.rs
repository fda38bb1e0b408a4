//! Draws a scene into an area of the screen.

mod nyquist;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::Widget;

use crate::tui::app::{Levels, Plot};
use crate::tui::plot::{AxisMark, Chart, Curve, Level, LineStyle, Marks, StackedCharts};
use crate::tui::scene::axes::{Loci, Ruled, frequency_axis};
use crate::tui::scene::{ChartView, CurveKind, Scene, SceneCurve};
use crate::tui::theme::Theme;

/// What the program needs to know about a drawn figure.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Drawn {
    /// The area of the frequency axis; none without such an axis.
    pub(crate) plot: Option<Plot>,
    /// The value axis, the upper one of two; none if it cannot be set.
    pub(crate) levels: Option<Levels>,
}

/// Draws a scene that has curves.
pub(crate) fn draw(scene: &Scene, theme: Theme, area: Rect, buffer: &mut Buffer) -> Drawn {
    if scene.view == ChartView::Nyquist {
        if let Some(loci) = Loci::new(scene) {
            nyquist::draw(scene, &loci, theme, (area, buffer));
        }
        return Drawn::default();
    }
    match scene.panels.as_slice() {
        [] => Drawn::default(),
        [_, rest @ ..] => draw_panels(scene, !rest.is_empty(), theme, (area, buffer)),
    }
}

/// Draws one panel, or two that share the frequencies.
fn draw_panels(
    scene: &Scene,
    two: bool,
    theme: Theme,
    (area, buffer): (Rect, &mut Buffer),
) -> Drawn {
    let ruled = Ruled::new(scene);
    let upper_curves = curves(&ruled, 0, theme, area.width);
    let upper = chart(&ruled, 0, theme, &upper_curves);
    let bounds = upper.y.bounds();
    let log = scene.panels[0].level == Level::Magnitude;
    let (plots, frequencies): ([Rect; 2], Vec<f64>) = if two {
        let lower_curves = curves(&ruled, 1, theme, area.width);
        let pair = StackedCharts::new(upper, chart(&ruled, 1, theme, &lower_curves));
        pair.render(area, buffer);
        let plots = pair.plot_areas(area);
        let columns = 0..plots[0].width;
        (
            plots,
            columns.map(|cell| pair.value_in(plots[0], cell)).collect(),
        )
    } else {
        upper.render(area, buffer);
        let plot = upper.plot_area(area);
        let columns = 0..plot.width;
        (
            [plot, Rect::default()],
            columns.map(|cell| upper.value_in(plot, cell)).collect(),
        )
    };
    let hertz = 1.0 / scene.frequency.unit.per_hertz();
    let [low, high] = scene.frequency.bounds;
    // A division may miss the bounds by a rounding error.
    let frequencies = frequencies
        .into_iter()
        .map(|value| (value * hertz).clamp(low.min(high), high.max(low)));
    Drawn {
        plot: Some(Plot {
            area: if plots[1].is_empty() {
                plots[0]
            } else {
                plots[0].union(plots[1])
            },
            frequencies: frequencies.collect(),
        }),
        levels: Some(Levels { bounds, log }),
    }
}

/// A panel's chart.
fn chart<'a>(ruled: &Ruled<'_>, panel: usize, theme: Theme, curves: &'a [Curve<'a>]) -> Chart<'a> {
    let scene = ruled.scene;
    let per_hertz = scene.frequency.unit.per_hertz();
    let marked = &scene.marks;
    let mut chart = Chart::new(
        frequency_axis(scene),
        ruled.value_axis(panel),
        scene.panels[panel].level,
        curves,
    );
    chart.cursor = marked.cursor.map(|f| f * per_hertz);
    chart.second = marked.second.map(|f| f * per_hertz);
    chart.harmonics = marked.harmonics.iter().map(|f| f * per_hertz).collect();
    chart.band = marked.band.map(|band| band.map(|f| f * per_hertz));
    chart.axis_mark = marked.validity.map(|f| AxisMark {
        value: f * per_hertz,
        labels: &["E-B limit", "E-B"],
    });
    chart.marks = Marks {
        name: "modes",
        values: marked.modes.iter().map(|f| f * per_hertz).collect(),
        selected: marked.mode,
    };
    style(&mut chart, scene, theme);
    chart
}

fn style(chart: &mut Chart<'_>, scene: &Scene, theme: Theme) {
    chart.glyphs = theme.glyphs();
    chart.styles = theme.chart();
    chart.styles.harmonic = theme.dim();
    chart.styles.band = theme.accent();
    if scene.marks.modes_dim {
        chart.styles.mark = theme.dim();
    }
}

/// The curves of a panel as drawn in this number of columns.
fn curves<'a>(ruled: &'a Ruled<'_>, panel: usize, theme: Theme, columns: u16) -> Vec<Curve<'a>> {
    let plain = ruled.curves(panel);
    plain
        .map(|(index, plain)| Curve {
            x: plain.x,
            y: plain.y,
            poles: plain.poles,
            ..look(index, ruled.scene, theme, columns)
        })
        .collect()
}

/// The style that distinguishes the curve with this index from others, without its points.
fn look(index: usize, scene: &Scene, theme: Theme, columns: u16) -> Curve<'static> {
    let curve = &scene.curves[index];
    let style = theme.curve(curve.colour);
    let (style, marker, line) = match curve.kind {
        CurveKind::Reference | CurveKind::Model => {
            let marker = curve.marker.map(|number| theme.marker(number));
            (style, marker, curve.line)
        }
        CurveKind::Fem => {
            let style = theme.witness(curve.colour);
            (style, Some(theme.point()), curve.line)
        }
        CurveKind::Measured => {
            let before = scene.curves[..index].iter();
            let number = before.filter(|one| one.kind == CurveKind::Measured).count();
            let line = if is_sparse(curve, scene, columns) {
                LineStyle::Points { apart: 0 }
            } else {
                LineStyle::Solid
            };
            (style, Some(theme.sample(number)), line)
        }
    };
    Curve {
        label: curve.label.clone(),
        style,
        marker,
        line,
        dim: curve.dim,
        ..Curve::new(&[], &[])
    }
}

/// Whether a curve has fewer points within the bounds than there are columns.
fn is_sparse(curve: &SceneCurve, scene: &Scene, columns: u16) -> bool {
    let [low, high] = scene.frequency.bounds;
    let inside = |f: &&f64| (low..=high).contains(*f);
    curve.frequencies.iter().filter(inside).count() < usize::from(columns)
}

#[cfg(test)]
mod tests;

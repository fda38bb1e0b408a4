//! The shape of the selected mode along the beam.

use num_complex::Complex64;
use ratatui::Frame;
use ratatui::layout::{Constraint, Rect};
use ratatui::text::Line;
use ratatui::widgets::Paragraph;

use super::animated;
use crate::tui::app::{App, ModeKind, Shape};
use crate::tui::plot::{Axis, Chart, Curve, Legend, Level, LineStyle, Scale};
use crate::tui::theme::Theme;
use crate::tui::view::{frame, text::significant};
use crate::unit::Unit;

/// Names of the beam's motions, and the markers of the masses' motions (y, z, theta) on the same scales.
const MOTIONS: [(&str, char); 3] = [("w", 'y'), ("v", 'z'), ("psi", 't')];

/// Smaller motions than this are not drawn.
const UNSEEN: f64 = 1e-4;

/// The value axis: a little more than from -1 to 1.
const REACH: f64 = 1.1;

pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    let shape = app.modes.shape.as_ref();
    let title = frame::rule(&heading(app), theme);
    let note = Line::styled(scale(shape), theme.dim());
    let block = frame::panel(title, note, area.width).border_style(theme.dim());
    let inside = block.inner(area);
    frame.render_widget(block, area);
    let Some(shape) = shape else {
        let text = Paragraph::new(why_empty(app)).style(theme.dim());
        return frame.render_widget(text, inside.centered_vertically(Constraint::Length(1)));
    };
    let angle = app.beam_view.moment.angle();
    let at = |motions: &[Vec<Complex64>; 3]| motions.each_ref().map(|u| Shape::at(u, angle));
    let (beam, masses) = (at(&shape.beam), at(&shape.masses));
    // The beam at rest.
    let length = shape.positions.last().copied().unwrap_or(1.0);
    let (ends, rest) = ([0.0, length], [0.0; 2]);
    let mut curves = vec![Curve {
        line: LineStyle::Dotted,
        dim: true,
        ..Curve::new(&ends, &rest)
    }];
    curves.extend(lines(shape, &beam, theme));
    // Points are drawn over lines, and listed after them in the legend.
    curves.extend(points(shape, &masses, theme));
    let stale = shape.generation != app.curves.generation || shape.mode != app.tables.modes.row;
    for curve in &mut curves {
        curve.dim |= stale;
    }
    let x = Axis::new(Scale::Linear, ends, Unit::METRE.symbol);
    let y = Axis::new(Scale::Linear, [-REACH, REACH], "");
    let mut chart = Chart::new(x, y, Level::Magnitude, &curves);
    chart.legend = Legend::Line;
    chart.styles = theme.chart();
    chart.glyphs = theme.glyphs();
    frame.render_widget(&chart, inside);
}

/// w, v and psi along the beam.
fn lines<'a>(shape: &'a Shape, beam: &'a [Vec<f64>; 3], theme: Theme) -> Vec<Curve<'a>> {
    let styles = [LineStyle::Solid, LineStyle::Dashed, LineStyle::Dotted];
    let seen = (0..3).filter(|motion| reaches(&shape.beam[*motion]));
    seen.map(|motion| Curve {
        label: MOTIONS[motion].0.to_owned(),
        line: styles[motion],
        style: theme.curve(motion),
        ..Curve::new(&shape.positions, &beam[motion])
    })
    .collect()
}

/// y, z and theta of the masses; the first one has the legend entry for all.
fn points<'a>(shape: &'a Shape, masses: &'a [Vec<f64>; 3], theme: Theme) -> Vec<Curve<'a>> {
    let seen = (0..3).filter(|motion| reaches(&shape.masses[*motion]));
    let mut curves: Vec<Curve<'_>> = seen
        .map(|motion| Curve {
            marker: Some(MOTIONS[motion].1),
            line: LineStyle::Points { apart: 0 },
            style: theme.curve(motion),
            ..Curve::new(&shape.places, &masses[motion])
        })
        .collect();
    animated::name_masses(&mut curves);
    curves
}

fn reaches(curve: &[Complex64]) -> bool {
    curve.iter().any(|u| u.norm() > UNSEEN)
}

fn heading(app: &App) -> String {
    let row = app.tables.modes.row;
    let mode = app.modes.list.as_ref().and_then(|list| list.rows.get(row));
    let Some(mode) = mode else {
        return "Shape".to_owned();
    };
    let frequency = app.display.frequency_text(mode.frequency);
    let how = match mode.kind {
        ModeKind::RigidBody => "rigid body".to_owned(),
        ModeKind::Oscillating => {
            format!("damping {} %", significant(100.0 * mode.damping_ratio, 4))
        }
        ModeKind::Overdamped => "overdamped".to_owned(),
    };
    format!("Mode {}: {frequency}, {how}", row + 1)
}

/// The scale of a full rotation relative to a full translation.
fn scale(shape: Option<&Shape>) -> String {
    match shape.map(|shape| shape.rotation) {
        None => String::new(),
        Some(None) => " rotation only ".to_owned(),
        Some(Some(0.0)) => " translation only ".to_owned(),
        Some(Some(rotation)) => format!(" 1 is 1 m, of psi {} rad ", significant(rotation, 3)),
    }
}

fn why_empty(app: &App) -> String {
    match &app.modes.list {
        None => " computing the modes".to_owned(),
        Some(list) if list.rows.is_empty() => " there is no mode in the sweep".to_owned(),
        Some(_) => " computing the shape".to_owned(),
    }
}

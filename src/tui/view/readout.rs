//! What is read at the cursor, in a line: the frequency, and the first curve there.

use crate::tui::app::{App, Value};
use crate::tui::plot::Level;
use crate::tui::scene::{self, ChartView};
use crate::tui::view::text::width;

/// The line that fits into so many columns; empty without a cursor.
pub(super) fn line(app: &App, columns: usize) -> String {
    let Some(cursor) = app.curves.cursor else {
        return String::new();
    };
    let frequency = app.display.frequency_text(cursor);
    let Some((member, trace)) = app.curves.first_trace() else {
        return format!(" {frequency} ");
    };
    let Some(value) = app.value_at(0, trace, cursor) else {
        return format!(" {frequency} ");
    };
    let energy = trace.dimension.is_none();
    let told = magnitude(app, value, energy);
    let has_phase = !energy && value.shown.norm() > 0.0;
    let degrees = value.shown.arg().to_degrees().round() + 0.0;
    let phase = has_phase.then(|| format!("  {degrees:.0} deg"));
    let phase = phase.unwrap_or_default();
    let of = match &member.label {
        None if app.curves.visible.len() == 1 => String::new(),
        _ => format!("{}: ", scene::label(&app.curves, trace, member)),
    };
    let delta = app.reading.second.and_then(|second| {
        let other = app.value_at(0, trace, second)?;
        let decibels = scene::difference(energy, value.shown, other.shown);
        let frequency = app.display.frequency_text(cursor - second);
        Some(format!("  delta {frequency}, {decibels:+.2} dB"))
    });
    let delta = delta.unwrap_or_default();
    let whole = format!(" {of}{frequency}  {told}{phase}{delta} ");
    let lines = if delta.is_empty() {
        vec![
            whole,
            format!(" {frequency}  {told}{phase} "),
            format!(" {frequency}  {told} "),
        ]
    } else {
        vec![
            whole,
            format!(" {frequency}  {told}{delta} "),
            format!(" {frequency}{delta} "),
            format!("{delta} "),
        ]
    };
    let fits = lines.iter().find(|line| width(line) <= columns);
    fits.or(lines.last()).cloned().unwrap_or_default()
}

/// A magnitude as the axis has it, with its unit; with a tilde where it is only near.
fn magnitude(app: &App, value: Value, energy: bool) -> String {
    let scale = scene::scale(app);
    let near = if value.exact { "" } else { "~" };
    let size = if energy {
        value.shown.re
    } else {
        value.shown.norm()
    };
    let unit = match app.curves.first_trace() {
        Some((_, trace)) => app.display.unit_of(trace.dimension.as_ref()),
        None => String::new(),
    };
    match scale.level {
        _ if size == 0.0 => "zero".to_owned(),
        Level::Decibel { .. }
            if matches!(
                app.display.view,
                ChartView::Magnitude | ChartView::MagnitudePhase
            ) =>
        {
            format!("{near}{:.1} {}", scale.level.value(size), scale.unit)
        }
        _ => format!("{near}{size:.3e} {unit}"),
    }
}

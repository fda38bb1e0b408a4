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
    let has_phase = !energy && value.shown.is_finite() && value.shown.norm() > 0.0;
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
        Some(format!("  delta {frequency}{}", change(decibels)))
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

/// A difference of levels behind what else differs; nothing where one of them has none, as that of zero.
fn change(decibels: f64) -> String {
    if decibels.is_finite() {
        format!(", {decibels:+.2} dB")
    } else {
        String::new()
    }
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
        _ if !size.is_finite() => "no finite value".to_owned(),
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: 20 log10 of a ratio; of zero over zero there is none.
    #[test]
    fn a_difference_that_is_none_is_not_written() {
        let of = |value: f64, against: f64| {
            change(scene::difference(false, value.into(), against.into()))
        };
        assert_eq!(of(10.0, 1.0), ", +20.00 dB");
        for (value, against) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (f64::NAN, 1.0)] {
            assert_eq!(of(value, against), "");
        }
    }
}

//! The readout of the cursor, one line: the frequency, and the value of the first curve.

use crate::tui::app::{App, Trace, Value};
use crate::tui::plot::Level;
use crate::tui::scene::{self, ChartView};
use crate::tui::view::text::width;

/// The line that fits into a width in columns; empty without a cursor. The frequency and the value are dropped last.
pub(crate) fn line(app: &App, columns: usize) -> String {
    let Some(cursor) = app.curves.cursor else {
        return String::new();
    };
    let frequency = app.display.frequency_text(cursor);
    let readout = app.curves.first_trace().and_then(|(member, trace)| {
        let of = match &member.label {
            None if app.curves.visible.len() == 1 => String::new(),
            _ => format!("{}: ", scene::label(&app.curves, trace, member)),
        };
        Some((of, readout(app, trace, cursor)?))
    });
    let Some((
        of,
        Readout {
            value,
            phase,
            delta,
        },
    )) = readout
    else {
        return format!(" {frequency} ");
    };
    let between = app.reading.second.map(|second| cursor - second);
    let lines = match between.zip(delta) {
        None => vec![
            format!(" {of}{frequency}  {value}{phase} "),
            format!(" {frequency}  {value}{phase} "),
            format!(" {frequency}  {value} "),
        ],
        Some((between, decibels)) => {
            let delta = format!(
                "  delta {}, {decibels:+.2} dB",
                app.display.frequency_text(between)
            );
            vec![
                format!(" {of}{frequency}  {value}{phase}{delta} "),
                format!(" {frequency}  {value}{delta} "),
                format!(" {frequency}  {value}  delta {decibels:+.2} dB "),
                format!(" {frequency}  {value}  {decibels:+.2} dB "),
                format!(" {frequency}  {value} "),
            ]
        }
    };
    let fits = lines.iter().find(|line| width(line) <= columns);
    fits.or(lines.last()).cloned().unwrap_or_default()
}

/// A difference of levels; none if one of them has none, such as that of zero.
fn finite(decibels: f64) -> Option<f64> {
    Some(decibels).filter(|decibels| decibels.is_finite())
}

/// The readout of a curve.
struct Readout {
    value: String,
    /// With two leading spaces; empty if there is none.
    phase: String,
    /// The difference in level to the second cursor, dB.
    delta: Option<f64>,
}

fn readout(app: &App, trace: &Trace, cursor: f64) -> Option<Readout> {
    let second = app.reading.second;
    if app.display.view == ChartView::Difference {
        let at = |f| app.difference_at(0, trace, f);
        let here = at(cursor)?;
        let near = if here.exact { "" } else { "~" };
        return Some(Readout {
            value: format!("{near}{:+.2} dB", here.decibels),
            phase: String::new(),
            delta: second
                .and_then(at)
                .and_then(|there| finite(here.decibels - there.decibels)),
        });
    }
    let at = |f| app.value_at(0, trace, f);
    let here = at(cursor)?;
    let energy = trace.dimension.is_none();
    let has_phase = !energy && here.shown.is_finite() && here.shown.norm() > 0.0;
    let degrees = here.shown.arg().to_degrees().round() + 0.0;
    let phase = has_phase.then(|| format!("  {degrees:.0} deg"));
    let there = second.and_then(at);
    Some(Readout {
        value: magnitude(app, here, energy),
        phase: phase.unwrap_or_default(),
        delta: there.and_then(|there| finite(scene::difference(energy, here.shown, there.shown))),
    })
}

/// A magnitude in the axis's unit; with a tilde if it is approximate.
fn magnitude(app: &App, value: Value, energy: bool) -> String {
    let scale = app.display.scale(&app.curves);
    let near = if value.exact { "" } else { "~" };
    let size = if energy {
        value.shown.re
    } else {
        value.shown.norm()
    };
    let unit = match app.curves.first_trace() {
        Some((_, trace)) => {
            let dimension = app.display.dimension_of(trace);
            app.display.unit_of(dimension.as_ref())
        }
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
            finite(scene::difference(false, value.into(), against.into()))
        };
        assert_eq!(of(10.0, 1.0), Some(20.0));
        for (value, against) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (f64::NAN, 1.0)] {
            assert_eq!(of(value, against), None);
        }
    }
}

//! The table of the first curve's peaks.

use num_complex::Complex64;
use ratatui::Frame;
use ratatui::layout::Rect;

use crate::solve::peaks::Peak;
use crate::tui::app::{App, List, ModeList, Rows};
use crate::tui::plot::Level;
use crate::tui::theme::Theme;
use crate::tui::view::table::{self, Column, Content, FREQUENCY};
use crate::tui::view::text::significant;

/// The columns, in what there is room for.
const LAYOUTS: [&[Column]; 2] = [
    &[
        (FREQUENCY, 11),
        ("height", 12),
        ("phase deg", 11),
        ("half-power damping %", 22),
        ("modal damping %", 17),
        ("mode", 6),
    ],
    &[
        (FREQUENCY, 9),
        ("height", 10),
        ("deg", 5),
        ("band %", 8),
        ("modal %", 8),
        ("no", 4),
    ],
];

pub(crate) fn draw(
    frame: &mut Frame<'_>,
    app: &App,
    list: &mut List,
    theme: Theme,
    area: Rect,
) -> Rows {
    let scale = app.display.scale(&app.curves);
    let resolved = app.curves.first_resolved();
    let title = match resolved {
        None => "Peaks".to_owned(),
        Some((member, trace)) => {
            let of = match &member.label {
                None => trace.response.clone(),
                Some(label) => format!("{} {label}", trace.response),
            };
            format!("Peaks of {of}, {}", scale.unit)
        }
    };
    let peaks = app.peaks();
    let overlap = peaks.iter().any(|peak| peak.overlaps);
    let doubt = app.modes.list.as_ref().and_then(ModeList::doubt);
    let notes = [
        overlap.then_some("~ modes overlap"),
        doubt.map(|_| "some may be missing"),
    ];
    let content = Content {
        title,
        warns: false,
        frequency_unit: app.display.unit,
        note: notes.into_iter().flatten().collect::<Vec<_>>().join(", "),
        columns: table::fitting(&LAYOUTS, area.width),
        row: &|row| cells(app, row, scale.level),
        empty: match resolved {
            None if app.curves.visible.is_empty() => "no response shows",
            None => "solving the peaks",
            Some(_) => "no peak in the sweep",
        },
        stale: !app.curves.is_resolved(),
    };
    table::draw(frame, &content, list, theme, area)
}

fn cells(app: &App, row: usize, level: Level) -> Vec<String> {
    let Some(peak) = app.peaks().get(row) else {
        return Vec::new();
    };
    let none = || "-".to_owned();
    let percent = |ratio: f64| significant(100.0 * ratio, 3);
    let shown = shown_height(app, peak);
    let height = match level {
        _ if peak.pole => "pole".to_owned(),
        Level::Decibel { .. } => format!("{:.2}", level.value(shown.norm())),
        _ => format!("{:.3e}", shown.norm()),
    };
    let damping = peak.mode.and_then(|mode| {
        let (member, _) = app.curves.first_resolved()?;
        member.damping_ratios.get(mode).copied()
    });
    let warning = if peak.overlaps { "~" } else { "" };
    vec![
        app.display.frequency_digits(peak.frequency),
        height,
        peak.phase.filter(|_| !peak.pole).map_or_else(none, |_| {
            format!("{:.0}", shown.arg().to_degrees().round() + 0.0)
        }),
        peak.half_power_damping.map_or_else(none, percent),
        damping.map_or_else(none, percent),
        peak.mode
            .map_or_else(none, |mode| format!("{warning}{}", mode + 1)),
    ]
}

/// The complex height of a peak in the form that is shown; of an energy the energy.
fn shown_height(app: &App, peak: &Peak) -> Complex64 {
    let value = Complex64::from_polar(peak.height, peak.phase.unwrap_or(0.0).to_radians());
    match app.curves.first_resolved() {
        Some((_, trace)) => app.display.value(trace, value, peak.frequency),
        None => value,
    }
}

//! The table of the first curve's peaks.

use ratatui::Frame;
use ratatui::layout::Rect;

use super::chart;
use super::table::{self, Column, Content};
use super::text::significant;
use crate::tui::app::{App, Rows};
use crate::tui::plot::Level;
use crate::tui::theme::Theme;

/// The columns, in what there is room for.
const LAYOUTS: [&[Column]; 2] = [
    &[
        ("Hz", 11),
        ("height", 12),
        ("phase deg", 11),
        ("half-power damping %", 22),
        ("modal damping %", 17),
        ("mode", 6),
    ],
    &[
        ("Hz", 9),
        ("height", 10),
        ("deg", 5),
        ("band %", 8),
        ("modal %", 8),
        ("no", 4),
    ],
];

pub(super) fn draw(frame: &mut Frame<'_>, app: &mut App, theme: Theme, area: Rect) -> Rows {
    let mut list = app.tables.peaks;
    let level = chart::level(app);
    let resolved = app.curves.first_resolved();
    let title = match resolved {
        None => "Peaks".to_owned(),
        Some((member, trace)) => {
            let of = match &member.label {
                None => trace.response.clone(),
                Some(label) => format!("{} {label}", trace.response),
            };
            let unit = match level.0 {
                Level::Magnitude => trace.unit,
                Level::Decibel { .. } => &level.1,
            };
            format!("Peaks of {of}, {unit}")
        }
    };
    let peaks = app.peaks();
    let overlap = peaks.iter().any(|peak| peak.overlaps);
    let content = Content {
        title,
        warns: false,
        note: if overlap { "~ modes overlap" } else { "" }.to_owned(),
        columns: table::fitting(&LAYOUTS, area.width),
        row: &|row| cells(app, row, level.0),
        empty: match resolved {
            None if app.curves.visible.is_empty() => "no response shows",
            None => "solving the peaks",
            Some(_) => "no peak in the sweep",
        },
        stale: !app.curves.is_resolved(),
    };
    let rows = table::draw(frame, &content, &mut list, theme, area);
    app.tables.peaks = list;
    rows
}

fn cells(app: &App, row: usize, level: Level) -> Vec<String> {
    let Some(peak) = app.peaks().get(row) else {
        return Vec::new();
    };
    let none = || "-".to_owned();
    let percent = |ratio: f64| significant(100.0 * ratio, 3);
    let height = match level {
        _ if peak.pole => "pole".to_owned(),
        Level::Magnitude => format!("{:.3e}", peak.height),
        Level::Decibel { .. } => format!("{:.2}", level.value(peak.height)),
    };
    let damping = peak.mode.and_then(|mode| {
        let (member, _) = app.curves.first_resolved()?;
        member.damping_ratios.get(mode).copied()
    });
    let warning = if peak.overlaps { "~" } else { "" };
    vec![
        significant(peak.frequency, 6),
        height,
        peak.phase
            .filter(|_| !peak.pole)
            .map_or_else(none, |phase| format!("{:.0}", phase.round() + 0.0)),
        peak.half_power_damping.map_or_else(none, percent),
        damping.map_or_else(none, percent),
        peak.mode
            .map_or_else(none, |mode| format!("{warning}{}", mode + 1)),
    ]
}

//! The table of the first curve's peaks.

use num_complex::Complex64;

use crate::solve::peaks::Peak;
use crate::tui::app::{App, ModeList};
use crate::tui::plot::Level;
use crate::tui::view::table::Kind::{Frequency, Plain};
use crate::tui::view::table::{Column, Content, column};
use crate::tui::view::text::significant;

#[rustfmt::skip]
const COLUMNS: [Column<Peak>; 6] = [
    column(Frequency, &[("", 11), ("", 9)], |app, peak| app.display.frequency_digits(peak.frequency)),
    column(Plain, &[("height", 12), ("height", 10)], height),
    column(Plain, &[("phase deg", 11), ("deg", 5)], phase),
    column(Plain, &[("half-power damping %", 22), ("band %", 8)], |_, peak| percent(peak.half_power_damping)),
    column(Plain, &[("modal damping %", 17), ("modal %", 8)], modal_damping),
    column(Plain, &[("mode", 6), ("no", 4)], mode),
];

pub(crate) fn content(app: &App) -> Content<'_, Peak> {
    let resolved = app.curves.first_resolved();
    let title = match resolved {
        None => "Peaks".to_owned(),
        Some((member, trace)) => {
            let of = match &member.label {
                None => trace.response.clone(),
                Some(label) => format!("{} {label}", trace.response),
            };
            format!("Peaks of {of}, {}", app.display.scale(&app.curves).unit)
        }
    };
    let rows = app.peaks();
    let overlap = rows.iter().any(|peak| peak.overlaps);
    let doubt = app.modes.list.as_ref().and_then(ModeList::doubt);
    let notes = [
        overlap.then_some("~ modes overlap"),
        doubt.map(|_| "some may be missing"),
    ];
    Content {
        title,
        warns: false,
        note: notes.into_iter().flatten().collect::<Vec<_>>().join(", "),
        columns: &COLUMNS,
        rows,
        sentences: Vec::new(),
        empty: match resolved {
            None if app.curves.visible.is_empty() => "no response is visible",
            None => "computing the peaks",
            Some(_) => "no peak in the sweep",
        }
        .into(),
        stale: !app.curves.is_resolved(),
    }
}

fn height(app: &App, peak: &Peak) -> String {
    if peak.pole {
        return "pole".to_owned();
    }
    let shown = shown_height(app, peak).norm();
    match app.display.scale(&app.curves).level {
        level @ Level::Decibel { .. } => format!("{:.2}", level.value(shown)),
        _ => format!("{shown:.3e}"),
    }
}

fn phase(app: &App, peak: &Peak) -> String {
    match peak.phase {
        Some(_) if !peak.pole => {
            let degrees = shown_height(app, peak).arg().to_degrees();
            format!("{:.0}", degrees.round() + 0.0)
        }
        _ => "-".to_owned(),
    }
}

fn modal_damping(app: &App, peak: &Peak) -> String {
    percent(peak.mode.and_then(|mode| {
        let (member, _) = app.curves.first_resolved()?;
        member.damping_ratios.get(mode).copied()
    }))
}

fn percent(ratio: Option<f64>) -> String {
    ratio.map_or_else(|| "-".to_owned(), |ratio| significant(100.0 * ratio, 3))
}

fn mode(_: &App, peak: &Peak) -> String {
    let warning = if peak.overlaps { "~" } else { "" };
    let number = |mode| format!("{warning}{}", mode + 1);
    peak.mode.map_or_else(|| "-".to_owned(), number)
}

/// The complex height of a peak in the shown form; for an energy, the energy.
fn shown_height(app: &App, peak: &Peak) -> Complex64 {
    let value = Complex64::from_polar(peak.height, peak.phase.unwrap_or(0.0).to_radians());
    match app.curves.first_resolved() {
        Some((_, trace)) => app.display.value(trace, value, peak.frequency),
        None => value,
    }
}

//! The table of what every curve is at the cursors.

use num_complex::Complex64;
use ratatui::Frame;
use ratatui::layout::Rect;

use crate::tui::app::{App, List, Rows, Trace, Value};
use crate::tui::scene::{self, ChartView};
use crate::tui::theme::Theme;
use crate::tui::view::table::{self, Column, Content};

/// The columns, in what there is room for.
const LAYOUTS: [&[Column]; 3] = [
    &[
        ("curve", 22),
        ("magnitude", 13),
        ("unit", 11),
        ("dB", 9),
        ("phase deg", 11),
        ("delta dB", 10),
        ("ratio", 11),
    ],
    &[
        ("curve", 16),
        ("magnitude", 11),
        ("unit", 8),
        ("dB", 8),
        ("deg", 7),
        ("delta dB", 9),
    ],
    &[
        ("curve", 10),
        ("magnitude", 10),
        ("dB", 8),
        ("deg", 7),
        ("delta dB", 9),
    ],
];

/// The columns of levels against a reference.
const DIFFERENCES: [&[Column]; 2] = [
    &[("curve", 30), ("dB", 12), ("delta dB", 12)],
    &[("curve", 20), ("dB", 10), ("delta dB", 10)],
];

/// A curve at the cursors.
pub(crate) struct Row {
    /// Its name.
    label: String,
    unit: String,
    energy: bool,
    /// The value of 0 dB.
    reference: f64,
    /// At the cursor, and at the second one.
    values: [Option<Value>; 2],
    /// Whether there is a phase.
    phase: bool,
}

/// How many rows the table has.
pub(crate) fn count(app: &App) -> usize {
    if app.display.view == ChartView::Difference {
        differences(app).len()
    } else {
        rows(app).len()
    }
}

/// The cells of every curve in the difference view.
fn differences(app: &App) -> Vec<Vec<String>> {
    let (Some(cursor), Some(picture)) = (app.curves.cursor, app.curves.picture()) else {
        return Vec::new();
    };
    let mut rows = Vec::new();
    for name in &app.curves.visible {
        for (number, member) in picture.members.iter().enumerate() {
            let Some(trace) = member.trace(name) else {
                continue;
            };
            let at = |f| app.difference_at(number, trace, f);
            let here = at(cursor);
            let there = app.reading.second.and_then(at);
            let decibels = |value: f64, near: &str| {
                if value.is_finite() {
                    format!("{near}{value:+.2}")
                } else {
                    "-".to_owned()
                }
            };
            let none = || "-".to_owned();
            rows.push(vec![
                scene::label(&app.curves, trace, member),
                here.map_or_else(none, |here| {
                    decibels(here.decibels, if here.exact { "" } else { "~" })
                }),
                here.zip(there).map_or_else(none, |(here, there)| {
                    decibels(here.decibels - there.decibels, "")
                }),
            ]);
        }
    }
    rows
}

/// A row for each curve that shows, and for the harmonics of the first.
pub(crate) fn rows(app: &App) -> Vec<Row> {
    let Some(cursor) = app.curves.cursor else {
        return Vec::new();
    };
    let mut rows = model(app, cursor);
    rows.extend(references(app, cursor));
    rows.extend(measured(app, cursor));
    rows.extend(harmonics(app));
    rows
}

fn row(app: &App, label: String, trace: &Trace, values: [Option<Value>; 2]) -> Row {
    let dimension = app.display.dimension_of(trace);
    let unit = app.display.unit_of(dimension.as_ref());
    Row {
        label,
        energy: trace.dimension.is_none(),
        reference: app.decibel_zero(&unit),
        unit,
        values,
        phase: trace.dimension.is_some(),
    }
}

fn model(app: &App, cursor: f64) -> Vec<Row> {
    let Some(picture) = app.curves.picture() else {
        return Vec::new();
    };
    let mut rows = Vec::new();
    for name in &app.curves.visible {
        for (number, member) in picture.members.iter().enumerate() {
            for trace in member.traces.iter().filter(|one| one.response == *name) {
                let label = scene::label(&app.curves, trace, member);
                let at = |f| app.value_at(number, trace, f);
                let values = [at(cursor), app.reading.second.and_then(at)];
                rows.push(row(app, label, trace, values));
            }
        }
    }
    rows
}

fn references(app: &App, cursor: f64) -> Vec<Row> {
    let mut rows = Vec::new();
    for reference in app.comparison.shown() {
        let Some(picture) = &reference.picture else {
            continue;
        };
        for name in &app.curves.visible {
            for (number, member) in picture.members.iter().enumerate() {
                for trace in member.traces.iter().filter(|one| one.response == *name) {
                    let label = match &member.label {
                        Some(label) => format!("{} {label}", reference.name),
                        None if app.curves.visible.len() > 1 => {
                            format!("{} {name}", reference.name)
                        }
                        None => reference.name.clone(),
                    };
                    let at = |f| app.reference_at((reference.id, number), member, trace, f);
                    let values = [at(cursor), app.reading.second.and_then(at)];
                    rows.push(row(app, label, trace, values));
                }
            }
        }
    }
    rows
}

/// Measured curves, between their points.
fn measured(app: &App, cursor: f64) -> Vec<Row> {
    app.measured_shown()
        .map(|(one, response)| {
            let response = response.as_ref();
            let at = |f: f64| {
                let shown = one.value_at(&app.display, response, f)?;
                Some(Value {
                    shown,
                    exact: false,
                })
            };
            let (unit, energy) = (app.display.unit_of(response), one.is_energy(response));
            Row {
                label: one.name.clone(),
                energy,
                reference: app.decibel_zero(&unit),
                unit,
                values: [at(cursor), app.reading.second.and_then(at)],
                phase: one.curve.phase_known && !energy,
            }
        })
        .collect()
}

/// The first curve at the harmonics of the cursor; differences are to the second cursor, or to the cursor itself.
fn harmonics(app: &App) -> Vec<Row> {
    let (Some((_, trace)), Some(cursor)) = (app.curves.first_trace(), app.curves.cursor) else {
        return Vec::new();
    };
    let harmonics = app.harmonics().into_iter().enumerate();
    harmonics
        .map(|(index, frequency)| {
            let order = index + 2;
            let label = format!("{order} x f");
            let values = [
                app.value_at(0, trace, frequency),
                app.value_at(0, trace, app.reading.second.unwrap_or(cursor)),
            ];
            row(app, label, trace, values)
        })
        .collect()
}

pub(crate) fn draw(
    frame: &mut Frame<'_>,
    app: &App,
    list: &mut List,
    theme: Theme,
    area: Rect,
) -> Rows {
    let difference = app.display.view == ChartView::Difference;
    let (title, note) = words(app);
    let columns = if difference {
        table::fitting(&DIFFERENCES, area.width)
    } else {
        table::fitting(&LAYOUTS, area.width)
    };
    let cells: Vec<Vec<String>> = if difference {
        differences(app)
    } else {
        let rows = rows(app);
        rows.iter().map(|row| cells(row, columns)).collect()
    };
    let content = Content {
        title,
        warns: false,
        frequency_unit: app.display.unit,
        note,
        columns,
        row: &|index| cells.get(index).cloned().unwrap_or_default(),
        empty: if app.curves.cursor.is_none() {
            "no cursor is on the chart"
        } else {
            "no response shows"
        },
        stale: app.curves.is_stale(),
    };
    table::draw(frame, &content, list, theme, area)
}

/// The title and the note of the table.
fn words(app: &App) -> (String, String) {
    let Some(cursor) = app.curves.cursor else {
        return ("Readings".to_owned(), String::new());
    };
    let at = app.display.frequency_text(cursor);
    let between = app.measured_shown().next().is_some();
    let reference = app.comparison.first_shown();
    let reference = reference.filter(|_| app.display.view == ChartView::Difference);
    let note = match (
        between,
        app.reading.harmonics && app.reading.second.is_none(),
    ) {
        _ if reference.is_some() => "",
        (true, _) => "zero to peak; ~ between points",
        (false, true) => "zero to peak; delta from f",
        (false, false) => "zero to peak",
    };
    let note = reference.map_or_else(|| note.to_owned(), |one| format!("against {}", one.name));
    match app.reading.second {
        None => (format!("At {at}"), note),
        Some(second) => {
            let delta = app.display.frequency_text(cursor - second);
            (format!("At {at}, {delta} from the second cursor"), note)
        }
    }
}

fn cells(row: &Row, columns: &[Column]) -> Vec<String> {
    let none = || "-".to_owned();
    let [here, there] = row.values;
    let size = |value: Complex64| {
        if row.energy { value.re } else { value.norm() }
    };
    let factor = if row.energy { 10.0 } else { 20.0 };
    let finite = |text: String, value: f64| if value.is_finite() { text } else { none() };
    let value = |here: Value| here.shown;
    let near = if here.is_some_and(|here| !here.exact) {
        "~"
    } else {
        ""
    };
    let decibels = here.map(|here| factor * (size(value(here)) / row.reference).log10());
    let phase = here
        .filter(|here| row.phase && value(*here) != Complex64::ZERO)
        .map(|here| value(here).arg().to_degrees());
    let pair = here.zip(there);
    let delta = pair.map(|(a, b)| scene::difference(row.energy, value(a), value(b)));
    let ratio = pair.map(|(a, b)| size(value(a)) / size(value(b)));
    let cell = |name: &str| match name {
        "curve" => row.label.clone(),
        "unit" => row.unit.clone(),
        "magnitude" => here.map_or_else(none, |here| {
            let size = size(value(here));
            finite(format!("{near}{size:.3e}"), size)
        }),
        "dB" => decibels.map_or_else(none, |one| finite(format!("{one:.2}"), one)),
        "delta dB" => delta.map_or_else(none, |one| finite(format!("{one:+.2}"), one)),
        "ratio" => ratio.map_or_else(none, |one| finite(format!("{one:.4e}"), one)),
        _ => phase.map_or_else(none, |one| finite(format!("{:.1}", one + 0.0), one)),
    };
    columns.iter().map(|(name, _)| cell(name)).collect()
}

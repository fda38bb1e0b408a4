//! The table of the curves' values at the cursors.

use num_complex::Complex64;

use crate::tui::app::{App, Member, Picture, Trace, Value};
use crate::tui::scene::{self, ChartView};
use crate::tui::view::table::Kind::Plain;
use crate::tui::view::table::{Column, Content, column};

#[rustfmt::skip]
const COLUMNS: [Column<Row>; 7] = [
    column(Plain, &[("curve", 22), ("curve", 16), ("curve", 10)], label),
    column(Plain, &[("magnitude", 13), ("magnitude", 11), ("magnitude", 10)], magnitude),
    column(Plain, &[("unit", 11), ("unit", 8)], |_, row| row.unit.clone()),
    column(Plain, &[("dB", 9), ("dB", 8), ("dB", 8)], |_, row| finite(row.decibels, |one| format!("{one:.2}"))),
    column(Plain, &[("phase deg", 11), ("deg", 7), ("deg", 7)], phase),
    column(Plain, &[("delta dB", 10), ("delta dB", 9), ("delta dB", 9)], delta),
    column(Plain, &[("ratio", 11)], |_, row| finite(row.ratio, |ratio| format!("{ratio:.4e}"))),
];

/// The columns of levels relative to a reference.
#[rustfmt::skip]
const DIFFERENCES: [Column<Row>; 3] = [
    column(Plain, &[("curve", 30), ("curve", 20)], label),
    column(Plain, &[("dB", 12), ("dB", 10)], difference),
    column(Plain, &[("delta dB", 12), ("delta dB", 10)], delta),
];

/// A curve at the cursor, and its change from the second cursor.
#[derive(Default)]
pub(crate) struct Row {
    label: String,
    unit: String,
    /// "~" between solved or measured points.
    near: &'static str,
    size: Option<f64>,
    decibels: Option<f64>,
    /// Degrees.
    phase: Option<f64>,
    /// Decibels.
    delta: Option<f64>,
    ratio: Option<f64>,
}

fn label(_: &App, row: &Row) -> String {
    row.label.clone()
}

fn magnitude(_: &App, row: &Row) -> String {
    finite(row.size, |size| format!("{}{size:.3e}", row.near))
}

fn phase(_: &App, row: &Row) -> String {
    finite(row.phase, |degrees| format!("{:.1}", degrees + 0.0))
}

fn difference(_: &App, row: &Row) -> String {
    finite(row.decibels, |one| format!("{}{one:+.2}", row.near))
}

fn delta(_: &App, row: &Row) -> String {
    finite(row.delta, |delta| format!("{delta:+.2}"))
}

const fn near(is_exact: bool) -> &'static str {
    if is_exact { "" } else { "~" }
}

fn finite(value: Option<f64>, text: impl Fn(f64) -> String) -> String {
    let value = value.filter(|value| value.is_finite());
    value.map_or_else(|| "-".to_owned(), text)
}

/// A row for each visible curve, and for the harmonics of the first.
pub(crate) fn rows(app: &App) -> Vec<Row> {
    let Some(cursor) = app.curves.cursor else {
        return Vec::new();
    };
    if app.display.view == ChartView::Difference {
        return differences(app, cursor);
    }
    let mut rows = model(app, cursor);
    rows.extend(references(app, cursor));
    rows.extend(measured(app, cursor));
    rows.extend(harmonics(app, cursor));
    rows
}

/// The visible curves of a picture, with the number of their member.
fn traces<'a>(
    app: &'a App,
    picture: &'a Picture,
) -> impl Iterator<Item = (usize, &'a Member, &'a Trace)> {
    app.curves.visible.iter().flat_map(move |name| {
        let members = picture.members.iter().enumerate();
        members.filter_map(move |(number, member)| Some((number, member, member.trace(name)?)))
    })
}

/// The model relative to the reference.
fn differences(app: &App, cursor: f64) -> Vec<Row> {
    let pictures = app.curves.picture().into_iter();
    let traces = pictures.flat_map(|picture| traces(app, picture));
    traces
        .map(|(number, member, trace)| {
            let at = |f| app.difference_at(number, trace, f);
            let here = at(cursor);
            let there = app.reading.second.and_then(at);
            Row {
                label: scene::label(&app.curves, trace, member),
                near: near(here.is_none_or(|here| here.exact)),
                decibels: here.map(|here| here.decibels),
                delta: here
                    .zip(there)
                    .map(|(here, there)| here.decibels - there.decibels),
                ..Row::default()
            }
        })
        .collect()
}

fn model(app: &App, cursor: f64) -> Vec<Row> {
    let pictures = app.curves.picture().into_iter();
    let traces = pictures.flat_map(|picture| traces(app, picture));
    traces
        .map(|(number, member, trace)| {
            let at = |f| app.value_at(number, trace, f);
            let values = [at(cursor), app.reading.second.and_then(at)];
            row(app, scene::label(&app.curves, trace, member), trace, values)
        })
        .collect()
}

fn references(app: &App, cursor: f64) -> Vec<Row> {
    let mut rows = Vec::new();
    for reference in app.comparison.shown() {
        let Some(picture) = &reference.picture else {
            continue;
        };
        rows.extend(traces(app, picture).map(|(number, member, trace)| {
            let name = &reference.name;
            let label = match &member.label {
                Some(label) => format!("{name} {label}"),
                None if app.curves.visible.len() > 1 => format!("{name} {}", trace.response),
                None => name.clone(),
            };
            let at = |f| app.reference_at((reference.id, number), member, trace, f);
            let values = [at(cursor), app.reading.second.and_then(at)];
            row(app, label, trace, values)
        }));
    }
    rows
}

/// Measured curves, interpolated.
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
            let unit = app.display.unit_of(response);
            let values = [at(cursor), app.reading.second.and_then(at)];
            let mut row = reading(app, unit, one.is_energy(response), values);
            row.label.clone_from(&one.name);
            row.phase = row.phase.filter(|_| one.curve.phase_known);
            row
        })
        .collect()
}

/// The first curve at the harmonics of the cursor; differences are relative to the second cursor,
/// or to the cursor itself.
fn harmonics(app: &App, cursor: f64) -> Vec<Row> {
    let Some((_, trace)) = app.curves.first_trace() else {
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

fn row(app: &App, label: String, trace: &Trace, values: [Option<Value>; 2]) -> Row {
    let dimension = app.display.dimension_of(trace);
    let unit = app.display.unit_of(dimension.as_ref());
    Row {
        label,
        ..reading(app, unit, trace.dimension.is_none(), values)
    }
}

/// A row without its label, from the values at the two cursors.
fn reading(app: &App, unit: String, energy: bool, [here, there]: [Option<Value>; 2]) -> Row {
    let reference = app.decibel_zero(&unit);
    let factor = if energy { 10.0 } else { 20.0 };
    let size = |value: Complex64| if energy { value.re } else { value.norm() };
    let near = near(here.is_none_or(|here| here.exact));
    let [here, there] = [here, there].map(|one| one.map(|value| value.shown));
    let pair = here.zip(there);
    Row {
        label: String::new(),
        unit,
        near,
        size: here.map(size),
        decibels: here.map(|here| factor * (size(here) / reference).log10()),
        phase: here
            .filter(|here| !energy && *here != Complex64::ZERO)
            .map(|here| here.arg().to_degrees()),
        delta: pair.map(|(here, there)| scene::difference(energy, here, there)),
        ratio: pair.map(|(here, there)| size(here) / size(there)),
    }
}

pub(crate) fn content<'a>(app: &App, rows: &'a [Row]) -> Content<'a, Row> {
    let (title, note) = words(app);
    Content {
        title,
        warns: false,
        note,
        columns: if app.display.view == ChartView::Difference {
            &DIFFERENCES
        } else {
            &COLUMNS
        },
        rows,
        sentences: Vec::new(),
        empty: if app.curves.cursor.is_none() {
            "there is no cursor on the chart"
        } else {
            "no response is visible"
        }
        .into(),
        stale: app.curves.is_stale(),
    }
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

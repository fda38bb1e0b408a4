//! The search for better parameters: how far it is, and what it has found so far.

use std::time::Duration;

use ratatui::Frame;
use ratatui::layout::Rect;

use crate::model::path::{self, Pattern};
use crate::model::{Group, Model, Parameter, Unit, counted, grouped};
use crate::tui::app::{App, List, Progress, Rows, Run};
use crate::tui::keys::TuneCommand;
use crate::tui::theme::Theme;
use crate::tui::tree::{self, Node};
use crate::tui::view::table::{self, Column, Content};
use crate::tui::view::text::{cut, significant, width};
use crate::tune::Achieved;

/// The columns, in what there is room for.
const LAYOUTS: [&[Column]; 3] = [
    &[("", 36), ("before", 15), ("now", 15), ("change", 12)],
    &[("", 22), ("before", 15), ("now", 15), ("change", 10)],
    &[("", 16), ("before", 14), ("now", 14)],
];

/// The heading of standard uncertainties.
const UNCERTAINTY: &str = "uncertainty";

/// What a row says.
pub(crate) struct Row {
    name: String,
    before: String,
    now: String,
    change: String,
    /// The standard uncertainty of what a match has found.
    uncertainty: Option<String>,
}

/// The figures that are sought, then the parameters that move.
pub(crate) fn rows(app: &App) -> Vec<Row> {
    let Some(run) = &app.tuning.run else {
        return Vec::new();
    };
    let mut rows = figures(run);
    rows.extend(variables(run));
    rows
}

fn figures(run: &Run) -> Vec<Row> {
    match (&run.progress, &run.status) {
        (Progress::Found(tuned), _) => {
            let pairs = tuned.before.iter().zip(&tuned.after).enumerate();
            pairs
                .map(|(index, (before, after))| achieved(run, index, before, after))
                .collect()
        }
        (_, Some(status)) => vec![Row {
            name: "objective".to_owned(),
            before: significant(status.start, 4),
            now: significant(status.best, 4),
            change: change(status.start, status.best),
            uncertainty: None,
        }],
        (_, None) => Vec::new(),
    }
}

fn achieved(run: &Run, index: usize, before: &Achieved, after: &Achieved) -> Row {
    let figure = |one: &Achieved| format!("{} {}", significant(one.figure, 4), one.unit);
    Row {
        name: tree::value(&run.from, Node::Group(Group::Objective(index))),
        before: figure(before),
        now: figure(after),
        change: change(before.figure, after.figure),
        uncertainty: None,
    }
}

/// How much less or more it is, percent.
fn change(before: f64, after: f64) -> String {
    let percent = 100.0 * (after / before - 1.0);
    if percent.is_finite() {
        format!("{percent:+.1} %")
    } else {
        "-".to_owned()
    }
}

fn variables(run: &Run) -> Vec<Row> {
    let variables = run.from.tune.iter().flat_map(|tune| &tune.variables);
    let rows = variables.enumerate().filter_map(|(index, variable)| {
        let (before, unit) = first(&run.from, &variable.paths[0])?;
        let after = run.best().and_then(|best| first(best, &variable.paths[0]));
        let now = after.map_or_else(|| "-".to_owned(), |(after, _)| unit.format(after));
        let uncertainty = match &run.progress {
            Progress::Found(tuned) => tuned
                .variables
                .get(index)
                .and_then(|moved| moved.uncertainty)
                .map(|one| format!("+-{}", unit.format(one))),
            _ => None,
        };
        let moved = after.map_or_else(|| "-".to_owned(), |(after, _)| change(before, after));
        Some(Row {
            name: words(&variable.paths),
            before: unit.format(before),
            now,
            change: moved,
            uncertainty,
        })
    });
    rows.collect()
}

/// Paths in words: `* y left stiffness`.
fn words(paths: &[Pattern]) -> String {
    let words = |path: &Pattern| {
        let path = path.strip_prefix("subsystems.").unwrap_or(path);
        path.replace(['.', '_'], " ")
    };
    paths.iter().map(words).collect::<Vec<_>>().join(", ")
}

/// The value of the first parameter of a pattern, and its unit.
fn first(model: &Model, pattern: &Pattern) -> Option<(f64, Unit)> {
    let (id, value) = path::numbers_of(model, pattern).ok()?.into_iter().next()?;
    Some((value, Parameter::of(model, id).ok()?.unit))
}

pub(crate) fn draw(
    frame: &mut Frame<'_>,
    app: &App,
    list: &mut List,
    theme: Theme,
    area: Rect,
) -> Rows {
    let rows = rows(app);
    let columns = &*columns(&rows, area.width);
    let [go, accept, discard] = [
        TuneCommand::Tune,
        TuneCommand::TuneAccept,
        TuneCommand::TuneDiscard,
    ]
    .map(|command| app.keys.key_of(command));
    let run = app.tuning.run.as_ref();
    let failed = run.is_some_and(|run| matches!(run.progress, Progress::Failed(_)));
    let content = Content {
        title: run.map_or_else(|| "Tuning".to_owned(), title),
        warns: failed,
        frequency_unit: app.display.unit,
        note: format!("{go} pause  {accept} take  {discard} drop"),
        columns,
        row: &|row| {
            rows.get(row)
                .map_or_else(Vec::new, |row| cells(row, columns))
        },
        empty: match run {
            None => "nothing is sought",
            Some(_) => "searching",
        },
        stale: false,
    };
    table::draw(frame, &content, list, theme, area)
}

/// The columns for some rows in a width of the screen: where a match has uncertainties these are whole.
fn columns(rows: &[Row], room: u16) -> Vec<Column> {
    let longest = |text: &dyn Fn(&Row) -> usize| rows.iter().map(text).max().unwrap_or(0);
    let uncertainty = longest(&|row| row.uncertainty.as_deref().map_or(0, width));
    let known = if uncertainty == 0 {
        table::fitting(&LAYOUTS, room).to_vec()
    } else {
        let last = (UNCERTAINTY, uncertainty.max(UNCERTAINTY.len()) + 1);
        let layouts = [
            vec![("", 24), ("before", 15), ("now", 15), ("change", 10), last],
            vec![("", 18), ("before", 15), ("now", 15), last],
            vec![("", 12), ("now", 15), last],
            vec![("", 8), ("now", 13), last],
        ];
        let fits = |layout: &&Vec<Column>| {
            layout.iter().map(|column| column.1).sum::<usize>() <= usize::from(room)
        };
        let found = layouts.iter().find(fits).or(layouts.last());
        found.cloned().unwrap_or_default()
    };
    table::widened(&known, longest(&|row| width(&row.name)), room)
}

fn cells(row: &Row, columns: &[Column]) -> Vec<String> {
    let room = columns.first().map_or(0, |column| column.1 - 1);
    let name = cut(&row.name, room);
    let name = format!("{name}{}", " ".repeat(room - width(&name)));
    let cell = |heading: &str| match heading {
        "before" => row.before.clone(),
        "now" => row.now.clone(),
        UNCERTAINTY => row.uncertainty.clone().unwrap_or_default(),
        _ => row.change.clone(),
    };
    let others = columns.iter().skip(1).map(|(heading, _)| cell(heading));
    std::iter::once(name).chain(others).collect()
}

/// How far the search is.
fn title(run: &Run) -> String {
    let so_far = |word: &str| match &run.status {
        None => format!("Tuning: {word}"),
        Some(status) => format!(
            "Tuning: {} of {}, {word}",
            grouped(status.evaluations),
            grouped(status.budget),
        ),
    };
    match &run.progress {
        Progress::Searching => {
            let left = run.left().map(seconds);
            let left = left.map_or_else(String::new, |left| format!("{left} left, "));
            let phase = run.status.as_ref().map(|status| status.phase.to_string());
            so_far(&format!("{left}{}", phase.as_deref().unwrap_or("starting")))
        }
        Progress::Paused => so_far("paused"),
        Progress::Found(tuned) => format!(
            "Tuned: {}, {}, {}",
            tuned.stop,
            counted(tuned.evaluations, "evaluation", "evaluations"),
            seconds(run.elapsed)
        ),
        Progress::Failed(reason) => format!("Not tuned: {reason}"),
    }
}

/// A time without needless digits.
fn seconds(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    match seconds {
        0.0..9.95 => format!("{seconds:.1} s"),
        9.95..119.5 => format!("{seconds:.0} s"),
        _ => format!("{:.0} min", seconds / 60.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_uncertainty_has_a_heading_of_its_own_and_is_whole() {
        let row = |name: &str, uncertainty: Option<&str>| Row {
            name: name.to_owned(),
            before: "3.333 MN/m".to_owned(),
            now: "12.5 MN/m".to_owned(),
            change: "+275.0 %".to_owned(),
            uncertainty: uncertainty.map(str::to_owned),
        };
        let rows = [
            row("S1 y left stiffness", Some("+-0.01234 MN s/m")),
            row("S1 mass", None),
        ];
        for room in [42, 43, 60, 82, 120] {
            let columns = columns(&rows, room);
            assert!(columns.iter().map(|column| column.1).sum::<usize>() <= usize::from(room));
            let place = columns.iter().position(|column| column.0 == UNCERTAINTY);
            let place = place.expect("a column of uncertainties");
            assert!(columns[place].1 > "+-0.01234 MN s/m".len());
            assert_eq!(cells(&rows[0], &columns)[place], "+-0.01234 MN s/m");
            assert_eq!(cells(&rows[1], &columns)[place], "");
            // The change stays under its own heading.
            let change = columns.iter().position(|column| column.0 == "change");
            assert!(change.is_none_or(|place| cells(&rows[0], &columns)[place] == "+275.0 %"));
        }
        assert!(cells(&rows[0], &columns(&rows, 120))[0].starts_with("S1 y left stiffness "));
        assert!(
            columns(&rows[1..], 82)
                .iter()
                .all(|column| column.0 != UNCERTAINTY)
        );
    }

    #[test]
    fn times_and_changes_are_short() {
        assert_eq!(seconds(Duration::from_millis(1_240)), "1.2 s");
        assert_eq!(seconds(Duration::from_secs(75)), "75 s");
        assert_eq!(seconds(Duration::from_secs(600)), "10 min");
        assert_eq!(change(2.0, 1.0), "-50.0 %");
        assert_eq!(change(0.0, 1.0), "-");
    }
}

//! The progress of the tuning, and its best result so far.

use std::time::Duration;

use crate::model::path::{self, Pattern};
use crate::model::{Group, Model, Parameter, Unit, counted, grouped};
use crate::tui::app::{App, Progress, Run};
use crate::tui::keys::TuneCommand;
use crate::tui::tree::{self, Node};
use crate::tui::view::table::Kind::{Name, Plain, Whole};
use crate::tui::view::table::{Column, Content, column};
use crate::tui::view::text::significant;
use crate::tune::Achieved;

#[rustfmt::skip]
const COLUMNS: [Column<Row>; 4] = [
    column(Name, &[("", 36), ("", 22), ("", 16)], |_, row| row.name.clone()),
    column(Plain, &[("before", 15), ("before", 15), ("before", 14)], |_, row| row.before.clone()),
    column(Plain, &[("now", 15), ("now", 15), ("now", 14)], |_, row| row.now.clone()),
    column(Plain, &[("change", 12), ("change", 10)], |_, row| row.change.clone()),
];

/// The columns of a match with uncertainties.
#[rustfmt::skip]
const UNCERTAIN: [Column<Row>; 5] = [
    column(Name, &[("", 24), ("", 18), ("", 12), ("", 8)], |_, row| row.name.clone()),
    column(Plain, &[("before", 15), ("before", 15)], |_, row| row.before.clone()),
    column(Plain, &[("now", 15), ("now", 15), ("now", 15), ("now", 13)], |_, row| row.now.clone()),
    column(Plain, &[("change", 10)], |_, row| row.change.clone()),
    column(Whole, &[("uncertainty", 12); 4], |_, row| row.uncertainty.clone().unwrap_or_default()),
];

/// The content of a row.
pub(crate) struct Row {
    name: String,
    before: String,
    now: String,
    change: String,
    /// The standard uncertainty of a matched parameter.
    uncertainty: Option<String>,
}

/// The objectives, then the variables.
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

/// The change in percent.
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

/// Paths as text: `* y left stiffness`.
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

pub(crate) fn content<'a>(app: &'a App, rows: &'a [Row]) -> Content<'a, Row> {
    let [go, accept, discard] = [
        TuneCommand::Tune,
        TuneCommand::TuneAccept,
        TuneCommand::TuneDiscard,
    ]
    .map(|command| app.keys.key_of(command));
    let run = app.tuning.run.as_ref();
    Content {
        title: run.map_or_else(|| "Tuning".to_owned(), title),
        warns: run.is_some_and(|run| matches!(run.progress, Progress::Failed(_))),
        note: format!("{go} pause  {accept} apply  {discard} discard"),
        columns: if rows.iter().any(|row| row.uncertainty.is_some()) {
            &UNCERTAIN
        } else {
            &COLUMNS
        },
        rows,
        sentences: Vec::new(),
        empty: match run {
            None => "there is no objective",
            Some(_) => "searching",
        }
        .into(),
        stale: false,
    }
}

/// The progress of the search.
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
    use ratatui::backend::TestBackend;
    use ratatui::buffer::Cell;
    use ratatui::{Frame, Terminal};

    use super::*;
    use crate::tui::app::List;
    use crate::tui::view::table;
    use crate::tui::view::text::width;

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
        let preset = crate::presets::find("fig06").unwrap();
        let app = App::new(crate::files::Opened::preset(preset).unwrap());
        let drawn = |rows: &[Row], room: u16| -> Vec<String> {
            let mut terminal = Terminal::new(TestBackend::new(room, 4)).unwrap();
            let draw = |frame: &mut Frame<'_>| {
                let (content, mut list) = (content(&app, rows), List::new(rows.len(), 0));
                let _ = table::draw(frame, &app, &content, &mut list, frame.area());
            };
            let buffer = terminal.draw(draw).unwrap().buffer;
            let lines = buffer.content.chunks(room.into());
            lines
                .map(|line| line.iter().map(Cell::symbol).collect())
                .collect()
        };
        for room in [42, 43, 60, 82, 120] {
            let lines = drawn(&rows, room);
            let [heading, found, plain] = [1, 2, 3].map(|line| lines[line].trim_end());
            assert!(heading.ends_with(" uncertainty"), "{lines:?}");
            assert!(found.ends_with(" +-0.01234 MN s/m"), "{lines:?}");
            assert_eq!(width(found), width(heading), "{lines:?}");
            assert!(width(plain) <= width(heading) - " +-0.01234 MN s/m".len());
            // The change stays under its own heading.
            if let Some(start) = lines[1].find("change") {
                let end = start + "change".len();
                assert!(lines[2][..end].ends_with(" +275.0 %"), "{lines:?}");
            }
        }
        assert!(drawn(&rows, 120)[2].starts_with(" S1 y left stiffness "));
        assert!(!drawn(&rows[1..], 82)[1].contains("uncertainty"));
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

//! Counts before commands, the repeat of the last change, and commands that cannot run.

use super::*;
use crate::tui::keys::{Command, FileCommand, ReadingCommand, SECTIONS, Section, TuneCommand};

fn message(app: &App) -> &str {
    match &app.message {
        Some(Message::Done(text) | Message::Refused(text)) => text,
        None => "",
    }
}

#[test]
fn a_count_does_a_nudge_so_many_times_in_one_step() {
    let mut counted = app("fig05a");
    select(&mut counted, STIFFNESS);
    let before = number(&counted, STIFFNESS);
    keys(&mut counted, "10+");
    let mut pressed = app("fig05a");
    select(&mut pressed, STIFFNESS);
    keys(&mut pressed, "++++++++++");
    assert_eq!(number(&counted, STIFFNESS), number(&pressed, STIFFNESS));
    keys(&mut counted, "u");
    assert_eq!(number(&counted, STIFFNESS), before);
}

#[test]
fn a_count_moves_and_undoes_so_many_times_and_stops_where_there_is_no_more() {
    let mut app = app("fig05a");
    let start = app.selection.cursor();
    keys(&mut app, "3j");
    assert_eq!(app.selection.cursor(), start + 3);
    select(&mut app, STIFFNESS);
    let text = app.document.text();
    // A movement in between separates the steps.
    keys(&mut app, "+f+f+");
    keys(&mut app, "9999u");
    assert_eq!(app.document.text(), text);
    assert!(message(&app).starts_with("nothing to undo (undo: S1 z_left stiffness"));
    keys(&mut app, "u");
    assert_eq!(message(&app), "nothing to undo");
}

#[test]
fn a_count_is_dropped_by_escape_and_does_not_reach_a_later_command() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    let before = number(&app, STIFFNESS);
    keys(&mut app, "20");
    assert_eq!(app.repeat.count, Some(20));
    press(&mut app, KeyCode::Esc);
    keys(&mut app, "+");
    assert!((number(&app, STIFFNESS) / before - 1.01).abs() < 1e-5);
    keys(&mut app, "0");
    assert_eq!(app.repeat.count, None, "a count does not start with 0");
    keys(&mut app, "123456");
    assert_eq!(app.repeat.count, Some(9_999));
}

#[test]
fn the_last_change_is_done_again_on_another_row() {
    let mut app = app("fig05a");
    select(&mut app, "subsystems.S1.mass");
    press(&mut app, KeyCode::Enter);
    enter(&mut app, "*1.5");
    let before = number(&app, "subsystems.S2.mass");
    select(&mut app, "subsystems.S2.mass");
    keys(&mut app, ";");
    assert_eq!(number(&app, "subsystems.S2.mass"), before * 1.5);
    keys(&mut app, "3>");
    select(&mut app, "subsystems.S3.mass");
    keys(&mut app, ";");
    let expected = [0; 3].iter().fold(before, |mass, _| {
        format!("{:.5e}", mass * 1.1).parse().unwrap()
    });
    assert_eq!(number(&app, "subsystems.S3.mass"), expected);
}

#[test]
fn a_typed_value_that_does_not_fit_is_refused_when_done_again() {
    let mut app = app("fig05a");
    keys(&mut app, ";");
    assert_eq!(message(&app), "there is no change to repeat yet");
    select(&mut app, "subsystems.S1.mass");
    press(&mut app, KeyCode::Enter);
    enter(&mut app, "120 kg");
    select(&mut app, STIFFNESS);
    let before = app.document.text();
    keys(&mut app, ";");
    assert!(matches!(app.message, Some(Message::Refused(_))));
    assert_eq!(app.document.text(), before);
}

#[test]
fn a_key_without_meaning_says_where_the_keys_are() {
    let mut app = app("fig05a");
    keys(&mut app, "0");
    assert_eq!(message(&app), "0 is not bound here: ? shows every key");
}

/// Everything a command can change, as text.
fn state(app: &App) -> String {
    let rows = app.selection.rows();
    format!(
        "{:?} {} {:?} {:?} {:?} {:?} {:?} {:?} {:?} {:?} {:?} {:?}",
        app.selection.node(),
        rows.len(),
        app.document.model(),
        app.curves.visible,
        (
            app.curves.study,
            app.curves.decibels,
            app.curves.log_frequency
        ),
        (
            app.curves.cursor,
            app.curves.window,
            app.comparison.shown().count()
        ),
        app.tables.open,
        (app.beam_view.shown, app.beam_view.moment, &app.display),
        (app.reading.second, app.reading.harmonics, app.curves.band),
        (
            app.overlay.is_some(),
            app.search.is_some(),
            app.theme,
            app.mouse.captured
        ),
        (app.tables.modes.row, app.tables.peaks.row),
        app.fem_overlay.picture().is_some(),
    )
}

#[test]
fn a_command_that_does_nothing_says_why() {
    let commands: Vec<Command> = SECTIONS
        .iter()
        .filter(|section| section.scope == Scope::Main)
        .flat_map(Section::rows)
        .map(|binding| binding.command)
        .collect();
    for preset in ["fig05a", "fig06", "fig08"] {
        let rows = app(preset).selection.rows().len();
        for row in 0..rows {
            for solved in [false, true] {
                for command in &commands {
                    let mut app = app(preset);
                    if solved {
                        let first = answer(1, &app);
                        app.update(Event::Answer(first));
                    }
                    app.selection.first();
                    app.selection.step(row.cast_signed());
                    app.message = None;
                    let before = state(&app);
                    let effects = app.command(*command);
                    let said = app.message.is_some();
                    assert!(
                        said || !effects.is_empty() || state(&app) != before,
                        "{command:?} does nothing on {:?} of {preset} and does not say why",
                        app.selection.node()
                    );
                }
            }
        }
    }
}

#[test]
fn a_count_moves_in_a_table_and_among_parameters() {
    let mut app = app("fig05a");
    let first = answer(1, &app);
    app.update(Event::Answer(first));
    keys(&mut app, "P");
    let rows = app.tables.peaks.rows;
    keys(&mut app, "5j");
    assert_eq!(app.tables.peaks.row, 5.min(rows.saturating_sub(1)));
    press(&mut app, KeyCode::Esc);
    let mut pressed = super::app("fig05a");
    keys(&mut app, "7");
    press(&mut app, KeyCode::Tab);
    for _ in 0..7 {
        press(&mut pressed, KeyCode::Tab);
    }
    assert_eq!(app.selection.node(), pressed.selection.node());
    keys(&mut app, "9999");
    press(&mut app, KeyCode::Tab);
    assert_eq!(app.message, None);
    press(&mut app, KeyCode::Tab);
    assert_eq!(message(&app), "there is no next parameter");
}

#[test]
fn a_count_deletes_and_duplicates_so_many_as_there_are() {
    let mut app = app("fig05a");
    select(&mut app, "subsystems.S1.mass");
    keys(&mut app, "3D");
    assert_eq!(app.model().subsystems.len(), 6);
    assert!(
        message(&app).ends_with(", the last of 3 times"),
        "{}",
        message(&app)
    );
    keys(&mut app, "3u");
    assert_eq!(app.model().subsystems.len(), 3);
    let before = app.document.text();
    keys(&mut app, "11x");
    assert!(app.model().subsystems.len() < 2, "{}", message(&app));
    assert!(
        message(&app).contains(", the last of "),
        "{}",
        message(&app)
    );
    keys(&mut app, "99u");
    assert_eq!(app.document.text(), before);
}

#[test]
fn what_takes_no_count_says_so_and_does_nothing() {
    for row in KeyMap::default().of(Scope::Main) {
        let command = row.binding.command;
        let mut app = app("fig05a");
        select(&mut app, STIFFNESS);
        app.repeat.count = Some(3);
        let state = (app.model().clone(), app.overlay.is_some(), app.tables.open);
        let effects = app.command(command);
        let excepted = [
            FileCommand::Quit.into(),
            ReadingCommand::CursorOff.into(),
            TuneCommand::Tune.into(),
        ]
        .contains(&command);
        if command.counts() || excepted {
            continue;
        }
        let words = format!("{} takes no count", row.binding.name.replace('-', " "));
        assert!(
            message(&app).starts_with(&words),
            "{command:?}: {}",
            message(&app)
        );
        assert!(effects.is_empty(), "{command:?}");
        let after = (app.model().clone(), app.overlay.is_some(), app.tables.open);
        assert_eq!(after, state, "{command:?}");
    }
}

#[test]
fn one_row_is_found_and_two_rows_are() {
    let mut app = app("fig05a");
    keys(&mut app, "/title");
    press(&mut app, KeyCode::Enter);
    assert!(
        message(&app).starts_with("`title`: 1 row; "),
        "{}",
        message(&app)
    );
    press(&mut app, KeyCode::Esc);
    keys(&mut app, "/S1 mass");
    press(&mut app, KeyCode::Enter);
    keys(&mut app, "n");
    assert!(message(&app).ends_with(" of 1 row"), "{}", message(&app));
}

#[test]
fn joints_are_added_copied_and_deleted() {
    let mut app = app("fig05a");
    let positions = |app: &App| -> Vec<f64> {
        let joints = app.model().joints.iter();
        joints.map(|joint| joint.position).collect()
    };
    go(&mut app, Node::Group(Group::Joints));
    app.add();
    // The middle of the beam, then that of the left half.
    assert_eq!(positions(&app), [1.6]);
    app.duplicate();
    assert_eq!(positions(&app).len(), 2, "{}", message(&app));
    assert_ne!(positions(&app)[0], positions(&app)[1]);
    app.delete();
    assert_eq!(positions(&app), [1.6]);
    assert!(
        message(&app).contains("delete joint 2"),
        "{}",
        message(&app)
    );
}

#[test]
fn maxwell_branches_are_added_copied_and_deleted() {
    let mut app = app("fig05a");
    select(&mut app, "subsystems.S1.y_left.stiffness");
    press(&mut app, KeyCode::Insert);
    assert_eq!(message(&app), "add S1 y_left branch 1");
    let branches = |app: &App| app.model().subsystems[0].y_left.maxwell.clone();
    let [added] = branches(&app)[..] else {
        panic!("{:?}", branches(&app));
    };
    assert_eq!(added.stiffness, app.model().subsystems[0].y_left.stiffness);
    keys(&mut app, "D");
    assert_eq!(branches(&app), [added; 2]);
    assert_eq!(
        tree::label(app.model(), app.selection.node()),
        "y left branch 2"
    );
    keys(&mut app, "x");
    assert_eq!(branches(&app), [added]);
    select(&mut app, "subsystems.S1.y_left.maxwell.1.damping");
    keys(&mut app, "x");
    assert_eq!(branches(&app), []);
    assert_eq!(app.selection.node(), Node::Group(Group::Subsystem(0)));
    select(&mut app, "supports.left.w");
    press(&mut app, KeyCode::Insert);
    assert_eq!(message(&app), "add left w branch 1");
    keys(&mut app, "u");
    select(&mut app, "beam.length");
    press(&mut app, KeyCode::Insert);
    assert!(
        message(&app).contains("select a spring"),
        "{}",
        message(&app)
    );
}

/// fig05a is 3.2 m long.
#[test]
fn spans_are_added_divided_and_deleted() {
    let mut app = app("fig05a");
    let lengths = |app: &App| -> Vec<f64> {
        let spans = app.model().spans.iter();
        spans.map(|span| span.length).collect()
    };
    select(&mut app, "beam.length");
    keys(&mut app, "a");
    assert_eq!(lengths(&app), [1.6, 1.6]);
    assert_eq!(app.selection.node(), Node::Group(Group::Span(1)));
    assert_eq!(message(&app), "add span 2");
    keys(&mut app, "a");
    assert_eq!(lengths(&app), [1.6, 0.8, 0.8]);
    go(&mut app, Node::Group(Group::Span(0)));
    keys(&mut app, "D");
    assert_eq!(lengths(&app), [0.8; 4]);
    let beam = tree::value(app.model(), Node::Group(Group::Beam));
    assert_eq!(beam, "3.2 m, 4 spans");
    keys(&mut app, "x");
    assert_eq!(lengths(&app), [1.6, 0.8, 0.8]);
    keys(&mut app, "3x");
    assert_eq!((lengths(&app), app.model().beam.length), (vec![], 3.2));
    assert_eq!(app.selection.node(), Node::Group(Group::Beam));
}

#[test]
fn a_span_gets_a_section_of_its_own_and_loses_it() {
    let mut app = app("fig05a");
    select(&mut app, "beam.length");
    keys(&mut app, "a");
    let section = Node::Group(Group::Section(Part::Span(1)));
    let shown = |app: &App| tree::value(app.model(), section);
    go(&mut app, section);
    assert_eq!(shown(&app), "the beam's");
    keys(&mut app, " ");
    assert_eq!(app.model().spans[1].section, Some(app.model().beam.section));
    assert_eq!(shown(&app), "A 116 cm2");
    select(&mut app, "beam.spans.2.section.area");
    keys(&mut app, ">");
    assert_ne!(app.model().spans[1].section, Some(app.model().beam.section));
    assert!(
        message(&app).starts_with("span 2 section area"),
        "{}",
        message(&app)
    );
    go(&mut app, section);
    keys(&mut app, " ");
    assert_eq!(
        (app.model().spans[1].section, shown(&app)),
        (None, "the beam's".to_owned())
    );
}

/// The points of what holds and loads the beam are measured from the axis of the beam, which would move.
#[test]
fn the_last_span_is_deleted_only_on_the_axis() {
    let mut app = app("fig05a");
    select(&mut app, "beam.length");
    keys(&mut app, "ax");
    select(&mut app, "beam.spans.1.offset_y");
    press(&mut app, KeyCode::Enter);
    enter(&mut app, "0.1");
    keys(&mut app, "x");
    assert_eq!(app.model().spans.len(), 1);
    assert!(
        message(&app).contains("its offset must be 0"),
        "{}",
        message(&app)
    );
}

#[test]
fn what_adds_is_said_for_where_one_is() {
    for (path, word) in [
        (
            "title",
            "spans of the beam, supports, joints, subsystems, forces and responses can be added",
        ),
        (
            "sweep.from",
            "spans of the beam, supports, joints, subsystems, forces and responses can be added",
        ),
    ] {
        let mut app = app("fig08");
        select(&mut app, path);
        keys(&mut app, "a");
        assert!(message(&app).starts_with(word), "{}", message(&app));
    }
    let mut app = app("fig08");
    go(&mut app, Node::Group(Group::Study(0)));
    keys(&mut app, "a");
    assert!(
        message(&app).starts_with("Ctrl-t on a number"),
        "{}",
        message(&app)
    );
}

#[test]
fn the_value_of_0_db_takes_units_and_is_that_of_the_model() {
    let preset = |app: &mut App, text: &str| {
        keys(app, "%");
        enter(app, text)
    };
    let mut app = app("cantilever");
    let answer = answer(app.curves.generation, &app);
    app.update(Event::Answer(answer));
    preset(&mut app, "1 kg");
    assert!(app.overlay.is_some(), "a mass is no receptance");
    press(&mut app, KeyCode::Esc);
    preset(&mut app, "1 um/N");
    assert_eq!(app.display.decibel_reference("m/N"), 1e-6);
    preset(&mut app, "2e-9");
    assert_eq!(app.display.decibel_reference("m/N"), 2e-9);
    // A mobility has its own.
    assert_eq!(app.display.decibel_reference("m/(N s)"), 1.0);
    keys(&mut app, "p");
    press(&mut app, KeyCode::Home);
    press(&mut app, KeyCode::Enter);
    assert_eq!(app.display.decibel_reference("m/N"), 1.0);
}

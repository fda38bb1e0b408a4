use crate::model::checked;
use std::path::PathBuf;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::*;
use crate::files::Source;
use crate::model::{Group, Part, SupportId, path};
use crate::presets;
use crate::tui::tree::{self, Node};
use crate::worker::{self, Answer, CurvesAnswer, Request, Stage};

mod counts;
mod external_changes;
mod mouse;
mod recall;

pub(crate) fn app(preset: &str) -> App {
    let preset = presets::find(preset).unwrap();
    let mut app = App::new(Opened {
        model: checked(&crate::model::read(preset.text).unwrap().into_inner()),
        text: preset.text.to_owned(),
        source: Source::Preset(preset.name),
    });
    app.start();
    app
}

pub(crate) fn select(app: &mut App, path: &str) {
    let model = Arc::clone(app.model());
    let id = path::one(&model, path).unwrap();
    let rows = tree::all_rows(&model);
    let row = rows
        .iter()
        .find(|row| row.node.parameter() == Some(id))
        .unwrap();
    app.selection.select(&model, row.node);
}

fn go(app: &mut App, node: Node) {
    let model = Arc::clone(app.model());
    app.selection.select(&model, node);
}

pub(crate) fn press(app: &mut App, code: KeyCode) -> Vec<Effect> {
    app.update(Event::Key(KeyEvent::from(code)))
}

pub(crate) fn keys(app: &mut App, keys: &str) -> Vec<Effect> {
    keys.chars()
        .flat_map(|c| press(app, KeyCode::Char(c)))
        .collect()
}

/// Replaces the text of the prompt and accepts it.
pub(crate) fn enter(app: &mut App, text: &str) -> Vec<Effect> {
    if let Some(Overlay::Prompt(prompt)) = &mut app.overlay {
        prompt.input.reset();
    }
    app.update(Event::Paste(text.to_owned()));
    press(app, KeyCode::Enter)
}

pub(crate) fn number(app: &App, path: &str) -> f64 {
    path::number(app.model(), path).unwrap()
}

pub(crate) fn said(app: &App) -> &str {
    match &app.message {
        Some(Message::Done(text) | Message::Refused(text)) => text,
        None => "",
    }
}

pub(crate) const STIFFNESS: &str = "subsystems.S1.z_left.stiffness";

#[test]
fn a_typed_value_is_taken_and_undone_by_name() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    press(&mut app, KeyCode::Enter);
    let effects = enter(&mut app, "40 MN/m");
    assert!(
        matches!(&effects[..], [Effect::Solve(Request::Curves(subject)), Effect::Keep(_)] if subject.generation == 2)
    );
    assert_eq!(number(&app, STIFFNESS), 4e7);
    assert!(app.overlay.is_none() && app.document.is_changed());
    keys(&mut app, "u");
    assert_eq!(said(&app), "undo: S1 z_left stiffness 16.667 -> 40 MN/m");
    assert!(!app.document.is_changed());
    keys(&mut app, "U");
    assert_eq!(said(&app), "redo: S1 z_left stiffness 16.667 -> 40 MN/m");
    assert_eq!(number(&app, STIFFNESS), 4e7);
}

#[test]
fn a_refused_value_says_why_and_stays_open() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    press(&mut app, KeyCode::Enter);
    for wrong in ["-1", "nonsense", "4 kg", "/0"] {
        enter(&mut app, wrong);
        let Some(Overlay::Prompt(Prompt {
            refusal: Some(refusal),
            input,
            ..
        })) = &app.overlay
        else {
            panic!("{wrong} was taken: {:?}", app.overlay);
        };
        assert!(!refusal.is_empty());
        assert_eq!(input.value(), wrong);
    }
    press(&mut app, KeyCode::Esc);
    assert_eq!(number(&app, STIFFNESS), 1.666_667e7);
    assert!(!app.document.is_changed());
}

#[test]
fn nudges_of_one_parameter_are_one_step() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    keys(&mut app, "+++");
    assert_eq!(said(&app), "S1 z_left stiffness 16.667 -> 17.172 MN/m");
    keys(&mut app, "u");
    assert_eq!(number(&app, STIFFNESS), 1.666_667e7);
    // After an undo, and on another row, a nudge starts a new step.
    keys(&mut app, "+");
    select(&mut app, "beam.length");
    keys(&mut app, ">.");
    keys(&mut app, "u");
    assert_eq!(number(&app, "beam.length"), 3.2);
    assert!(app.document.is_changed());
    keys(&mut app, "uu");
    assert_eq!(said(&app), "nothing to undo");
}

/// Expected: no more than the path of this test itself, also with studies and variables whose rows the tree marks.
#[test]
fn a_nudge_parses_no_path() {
    let preset = presets::find("fig05a").unwrap();
    let tune = r#"
        [[studies]]
        name = "mass"
        vary = ["subsystems.*.mass"]
        multiply = [0.5, 2.0]
        [tune]
        variables = [
            { path = "subsystems.S2.mass", min = 1.0, max = 1e3 },
            { paths = ["subsystems.*.y_left.stiffness", "subsystems.*.y_right.stiffness"], min = 1e3, max = 1e9 },
        ]
        objective = { minimise = "energy", from = 1.0, to = 100.0 }
    "#;
    let text = format!("{}{tune}", preset.text);
    let mut app = App::new(Opened {
        model: checked(&crate::model::read(&text).unwrap().into_inner()),
        text,
        source: Source::Preset(preset.name),
    });
    app.start();
    select(&mut app, "subsystems.S1.mass");
    let mass = number(&app, "subsystems.S1.mass");
    let before = path::PARSED.get();
    keys(&mut app, "++");
    assert_eq!(path::PARSED.get(), before);
    assert!(number(&app, "subsystems.S1.mass") > mass);
}

#[test]
fn a_zero_is_not_nudged() {
    let mut app = app("fig05a");
    select(&mut app, "beam.material.loss_factor");
    keys(&mut app, "+");
    assert!(said(&app).contains("is 0"), "{}", said(&app));
    assert!(matches!(app.message, Some(Message::Refused(_))));
}

#[test]
fn a_nudge_beyond_the_range_is_refused() {
    let mut app = app("fig05a");
    select(&mut app, "subsystems.S3.position");
    keys(&mut app, ">>>>>>>>");
    assert!(matches!(app.message, Some(Message::Refused(_))));
    assert!(said(&app).starts_with("S3 position is "), "{}", said(&app));
    assert!(crate::model::check(app.model()).is_empty());
}

#[test]
fn choices_cycle_past_what_is_not_possible() {
    let mut app = app("fig08");
    select(&mut app, "sweep.spacing");
    keys(&mut app, " ");
    assert_eq!(said(&app), "sweep spacing linear -> log");
    select(&mut app, "supports.left.kind");
    keys(&mut app, " ");
    assert_eq!(app.model().supports.left, crate::model::Support::PINNED);
    press(&mut app, KeyCode::Enter);
    keys(&mut app, " ");
    assert_eq!(app.model().supports.left, crate::model::Support::FREE);
    keys(&mut app, "uuuu");
    assert!(!app.document.is_changed());
}

#[test]
fn what_is_referred_to_is_not_deleted() {
    let mut app = app("fig05c");
    go(&mut app, Node::Group(Group::Subsystem(1)));
    keys(&mut app, "x");
    assert_eq!(said(&app), "S2 is needed by force 1, which acts on it");
    keys(&mut app, "e");
    assert!(matches!(app.message, Some(Message::Refused(_))));
    assert_eq!(app.model().subsystems.len(), 3);
}

#[test]
fn subsystems_are_added_copied_renamed_switched_and_deleted() {
    let mut app = app("fig05a");
    go(&mut app, Node::Group(Group::Subsystem(0)));
    keys(&mut app, "a");
    assert_eq!(
        (said(&app), app.selection.node()),
        ("add subsystem S4", Node::Group(Group::Subsystem(3)))
    );
    keys(&mut app, "D");
    assert_eq!(app.model().subsystems[4].name, "S5");
    keys(&mut app, "r");
    enter(&mut app, "absorber.1");
    assert_eq!(app.model().subsystems[4].name, "absorber.1");
    keys(&mut app, "e");
    assert!(!app.model().subsystems[4].enabled);
    keys(&mut app, "x");
    assert_eq!(app.selection.node(), Node::Group(Group::Subsystem(3)));
    keys(&mut app, "uuuuu");
    assert!(!app.document.is_changed());
    assert_eq!(app.document.text(), app.document.saved_text());
}

#[test]
fn inner_supports_are_added_copied_renamed_and_deleted() {
    let mut app = app("fig05a");
    go(&mut app, Node::Group(Group::Supports));
    keys(&mut app, "a");
    let bearing = |index| Node::Group(Group::Support(SupportId::Inner(index)));
    assert_eq!(
        (said(&app), app.selection.node()),
        ("add support bearing", bearing(0))
    );
    assert_eq!(app.model().supports.inner[0].position, 1.6);
    keys(&mut app, "D");
    assert_eq!(app.model().supports.inner[1].name, "bearing 2");
    keys(&mut app, "r");
    enter(&mut app, "foot");
    assert_eq!(app.model().supports.inner[1].name, "foot");
    // Every edit keeps the model possible and the file readable.
    let text = app.document.text();
    assert_eq!(
        crate::model::read(&text).map(crate::model::Checked::into_inner),
        Ok(crate::model::Model::clone(app.model()))
    );
    select(&mut app, "supports.inner.foot.position");
    keys(&mut app, "x");
    assert_eq!(app.selection.node(), bearing(0));
    keys(&mut app, "uuuu");
    assert_eq!(app.document.text(), app.document.saved_text());
}

/// A support between the ends has rows that the ends do not have.
#[test]
fn the_same_row_of_the_next_support_is_found() {
    let mut app = app("fig05a");
    go(&mut app, Node::Group(Group::Supports));
    keys(&mut app, "a");
    select(&mut app, "supports.right.z");
    keys(&mut app, "n");
    let model = Arc::clone(app.model());
    let at = |path: &str| Some(path::one(&model, path).unwrap());
    assert_eq!(
        app.selection.node().parameter(),
        at("supports.inner.bearing.z")
    );
    select(&mut app, "supports.inner.bearing.position");
    keys(&mut app, "N");
    let position = at("supports.inner.bearing.position");
    assert_eq!(app.selection.node().parameter(), position);
}

/// The row of a subsystem's place.
fn position(subsystem: usize) -> Node {
    let row = crate::model::schema::SubsystemKey::Position as usize;
    Node::Parameter(Group::Subsystem(subsystem).parameter(row))
}

#[test]
fn open_rows_follow_their_subsystem() {
    let mut app = app("fig05a");
    go(&mut app, position(2));
    go(&mut app, Node::Group(Group::Subsystem(0)));
    keys(&mut app, "x");
    let rows = app.selection.rows();
    assert!(rows.iter().any(|row| row.node == position(1)));
    assert!(!rows.iter().any(|row| row.node == position(0)));
    assert_eq!(app.selection.node(), Node::Group(Group::Subsystem(0)));
}

#[test]
fn forces_and_responses_are_added_valid() {
    let mut app = app("fig06");
    go(&mut app, Node::Group(Group::Forces));
    keys(&mut app, "aD");
    go(&mut app, Node::Group(Group::Responses));
    keys(&mut app, "aaD");
    assert!(crate::model::check(app.model()).is_empty());
    let names: Vec<_> = app
        .model()
        .responses
        .iter()
        .rev()
        .take(3)
        .map(|one| one.name.as_str())
        .collect();
    assert_eq!(names, ["right w 3", "right w 2", "right w"]);
    assert!(app.curves.shows("right w 3"));
}

#[test]
fn tab_visits_every_parameter_and_comes_back() {
    let mut app = app("fig08");
    let all = tree::all_rows(app.model());
    let parameters = all
        .iter()
        .filter(|row| row.open.is_none() && row.node.parameter().is_some())
        .count();
    keys(&mut app, "g");
    for _ in 1..parameters {
        let before = app.selection.node();
        press(&mut app, KeyCode::Tab);
        assert_ne!(app.selection.node(), before);
    }
    for _ in 1..parameters {
        press(&mut app, KeyCode::BackTab);
    }
    assert_eq!(app.selection.node(), Node::TITLE);
}

#[test]
fn n_goes_to_the_same_parameter_of_the_next_subsystem() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    keys(&mut app, "nn");
    assert_eq!(
        app.selection.node().parameter(),
        path::one(app.model(), "subsystems.S3.z_left.stiffness").ok()
    );
    keys(&mut app, "n");
    assert!(matches!(app.message, Some(Message::Refused(_))));
}

#[test]
fn quitting_asks_when_something_is_not_saved() {
    let mut app = app("fig05a");
    assert!(matches!(&keys(&mut app, "q")[..], [Effect::Quit(None)]));
    select(&mut app, STIFFNESS);
    keys(&mut app, "+");
    assert!(keys(&mut app, "q").is_empty());
    assert_eq!(
        app.overlay.as_ref().map(Overlay::scope),
        Some(Scope::Unsaved)
    );
    press(&mut app, KeyCode::Esc);
    assert!(app.overlay.is_none());
    assert!(matches!(&keys(&mut app, "qd")[..], [Effect::Quit(None)]));
}

#[test]
fn saving_before_quitting_goes_through_the_path_and_the_question() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    keys(&mut app, "+qs");
    let effects = enter(&mut app, "mine.toml");
    let [
        Effect::Save {
            path,
            text,
            guard: Guard::Absent,
        },
    ] = &effects[..]
    else {
        panic!("{effects:?}");
    };
    assert!(
        app.reply(Reply::Exists(path.clone(), Saving::Model))
            .is_empty()
    );
    let effects = keys(&mut app, "y");
    assert!(matches!(
        &effects[..],
        [Effect::Save {
            guard: Guard::Anything,
            ..
        }]
    ));
    let effects = app.reply(Reply::Saved(path.clone(), text.clone()));
    assert!(matches!(&effects[..], [Effect::Quit(None), Effect::Forget]));
    assert_eq!(
        app.document.source(),
        &Source::File(PathBuf::from("mine.toml"))
    );
    assert!(!app.document.is_changed());
}

#[test]
fn a_kept_file_cancels_quitting_too() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    keys(&mut app, "+qs");
    enter(&mut app, "mine.toml");
    app.reply(Reply::Exists("mine.toml".into(), Saving::Model));
    keys(&mut app, "n");
    assert!(app.document.is_changed());
    // A later save does not quit any more.
    keys(&mut app, "s");
    let effects = enter(&mut app, "other.toml");
    let [Effect::Save { path, text, .. }] = &effects[..] else {
        panic!("{effects:?}");
    };
    let effects = app.reply(Reply::Saved(path.clone(), text.clone()));
    assert!(matches!(&effects[..], [Effect::Forget]), "{effects:?}");
}

#[test]
fn a_file_changed_outside_is_not_replaced_without_a_question() {
    let mut app = app("fig05a");
    app.reply(Reply::Saved("mine.toml".into(), "text".to_owned()));
    select(&mut app, STIFFNESS);
    keys(&mut app, "+");
    let effects = keys(&mut app, "s");
    assert!(
        matches!(&effects[..], [Effect::Save { guard: Guard::Holds(text), .. }] if text == "text")
    );
    app.reply(Reply::ChangedOutside("mine.toml".into()));
    assert_eq!(app.scope(), Scope::Replace);
}

#[test]
fn a_preset_is_opened_from_the_list() {
    let mut app = app("fig05a");
    keys(&mut app, "pj");
    press(&mut app, KeyCode::Enter);
    assert_eq!(app.document.source(), &Source::Preset("fig05b"));
    assert!(app.overlay.is_none());
}

#[test]
fn every_edit_is_kept_until_nothing_is_unsaved() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    let mut effects = keys(&mut app, "+");
    let Some(Effect::Keep(kept)) = effects.pop() else {
        panic!("{effects:?}")
    };
    assert_eq!(kept.model, *app.model());
    assert_eq!(&*kept.base, app.document.saved_text());
    // A movement does not write the recovery file again.
    assert!(press(&mut app, KeyCode::Down).is_empty());
    let effects = keys(&mut app, "u");
    assert!(
        matches!(effects.last(), Some(Effect::Forget)),
        "{effects:?}"
    );
    assert!(matches!(
        app.update(Event::Quit(15))[..],
        [Effect::Quit(Some(15))]
    ));
}

#[test]
fn every_edit_asks_for_curves_and_an_older_answer_stays_stale() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    let first = answer(1, &app);
    let effects = keys(&mut app, "+");
    assert!(
        matches!(&effects[..], [Effect::Solve(Request::Curves(subject)), Effect::Keep(_)] if subject.generation == 2)
    );
    app.update(Event::Answer(first));
    assert!(app.curves.is_stale());
    let second = answer(2, &app);
    app.update(Event::Answer(second));
    assert!(!app.curves.is_stale());
    // An answer to an older request is ignored.
    let late = answer(1, &app);
    app.update(Event::Answer(late));
    assert_eq!(app.curves.picture().unwrap().generation, 2);
    keys(&mut app, "f+");
    let frozen = &app.comparison.references[0];
    assert_eq!(frozen.picture.as_ref().unwrap().generation, 2);
    keys(&mut app, "F");
    assert!(app.comparison.references.is_empty());
}

fn answer(generation: u64, app: &App) -> Answer {
    let frequencies = [10.0, 20.0, 30.0, 40.0];
    let frf = crate::solve::sweep(
        app.model(),
        &frequencies,
        &std::sync::atomic::AtomicBool::new(false),
    )
    .unwrap();
    Answer::Curves(CurvesAnswer {
        generation,
        stage: Stage::Full,
        result: Ok(worker::Curves {
            members: vec![worker::Member {
                label: None,
                model: Arc::clone(app.model()),
                frf,
                peaks: Vec::new(),
                damping_ratios: Vec::new(),
            }],
            modes: None,
        }),
        elapsed: std::time::Duration::ZERO,
    })
}

#[test]
fn responses_show_and_hide() {
    let mut app = app("fig05a");
    assert_eq!(app.curves.visible, ["P1 w"]);
    go(&mut app, Node::Group(Group::Response(3)));
    keys(&mut app, "v");
    assert_eq!(app.curves.visible, ["P1 w", "P2 w"]);
    keys(&mut app, "V");
    assert_eq!(app.curves.visible, ["P2 w"]);
    keys(&mut app, "v");
    assert!(app.curves.visible.is_empty());
    go(&mut app, Node::Group(Group::Beam));
    keys(&mut app, "v");
    assert!(matches!(app.message, Some(Message::Refused(_))));
}

#[test]
fn a_renamed_response_still_shows() {
    let mut app = app("fig05a");
    go(&mut app, Node::Group(Group::Response(0)));
    keys(&mut app, "r");
    enter(&mut app, "left w");
    assert_eq!(app.curves.visible, ["left w"]);
    keys(&mut app, "u");
    assert_eq!(app.curves.visible, ["P1 w"]);
}

#[test]
fn the_study_goes_on_and_off() {
    let mut app = app("fig08");
    assert_eq!(app.curves.study, None);
    let effects = keys(&mut app, "t");
    assert!(
        matches!(&effects[..], [Effect::Solve(Request::Curves(subject))] if subject.study == Some(0))
    );
    keys(&mut app, "t");
    assert_eq!(app.curves.study, None);
}

#[test]
fn values_from_the_command_line_are_a_step() {
    let preset = presets::find("fig05a").unwrap();
    let mut model = crate::model::read(preset.text).unwrap().into_inner();
    model.beam.length = 4.0;
    let mut app = App::new(Opened {
        model: checked(&model),
        text: preset.text.to_owned(),
        source: Source::Preset(preset.name),
    });
    assert!(app.document.is_changed());
    keys(&mut app, "u");
    assert_eq!(app.model().beam.length, 3.2);
    assert!(!app.document.is_changed());
}

/// How many edits are prepared for.
fn prepared(effects: &[Effect]) -> usize {
    let expects = |effect: &&Effect| matches!(effect, Effect::Solve(Request::Expect(_)));
    effects.iter().filter(expects).count()
}

#[test]
fn a_parameter_among_many_subsystems_is_prepared_for_again_when_it_has_moved() {
    let mut app = app("hundred_absorbers");
    select(&mut app, "subsystems.A50.mass");
    let effects = press(&mut app, KeyCode::Char('d'));
    assert_eq!(prepared(&effects), 1);
    let Some(Effect::Solve(Request::Expect(edit))) = effects.last() else {
        panic!("{effects:?}");
    };
    let mass = |model: &Model| model.subsystems[49].mass;
    assert_eq!([mass(&edit.model), mass(&edit.edited)], [0.95, 1.05]);
    let mut asked = Vec::new();
    for generation in 2..=6 {
        assert_eq!(prepared(&keys(&mut app, "+")), 0);
        let answer = answer(generation, &app);
        asked.push(prepared(&app.update(Event::Answer(answer))));
    }
    // 1.01, 1.0201, 1.0303, then 1 % and 2 % from there.
    assert_eq!(asked, [0, 0, 1, 0, 0]);
}

#[test]
fn a_small_model_is_not_prepared_for() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    assert_eq!(prepared(&press(&mut app, KeyCode::Char('d'))), 0);
}

/// Types into the open dialog, as a keyboard does.
fn typed(app: &App) -> &str {
    match &app.overlay {
        Some(Overlay::Prompt(prompt)) => prompt.input.value(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_is_typed_replaces_the_text_of_a_box_and_other_keys_keep_it() {
    // A value, a name, factors, bounds, a path to save to and one to export to.
    for open in ["\r", "r", "^t", "$", "S", "^e"] {
        let opened = || {
            let mut app = app("fig05a");
            select(&mut app, STIFFNESS);
            match open.as_bytes() {
                [b'^', letter] => {
                    let code = KeyCode::Char(char::from(*letter));
                    app.update(Event::Key(KeyEvent::new(code, KeyModifiers::CONTROL)));
                }
                [b'\r'] => drop(press(&mut app, KeyCode::Enter)),
                _ => drop(keys(&mut app, open)),
            }
            app
        };
        let before = typed(&opened()).to_owned();
        assert!(!before.is_empty(), "{open:?}");
        let mut replaced = opened();
        keys(&mut replaced, "40 x");
        assert_eq!(typed(&replaced), "40 x", "{open:?}");
        let mut pasted = opened();
        pasted.update(Event::Paste("7".to_owned()));
        assert_eq!(typed(&pasted), "7", "{open:?}");
        for (code, expected) in [
            (KeyCode::End, format!("{before}!")),
            (KeyCode::Right, format!("{before}!")),
            (KeyCode::Home, format!("!{before}")),
            (
                KeyCode::Backspace,
                format!("{}!", &before[..before.len() - 1]),
            ),
        ] {
            let mut kept = opened();
            press(&mut kept, code);
            keys(&mut kept, "!");
            assert_eq!(typed(&kept), expected, "{open:?} {code:?}");
        }
        let mut too_much = opened();
        too_much.update(Event::Paste("7".repeat(10_000)));
        assert_eq!(typed(&too_much), before, "{open:?}");
    }
}

#[test]
fn a_box_that_opens_is_typed_into_as_the_readme_says() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    press(&mut app, KeyCode::Enter);
    keys(&mut app, "40 MN/m");
    press(&mut app, KeyCode::Enter);
    assert_eq!(number(&app, STIFFNESS), 4e7);
}

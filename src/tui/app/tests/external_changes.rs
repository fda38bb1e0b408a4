//! Other programs: the clipboard, a changed file, recovered changes.

use crate::model::checked;
use std::time::Duration;

use super::*;
use crate::tui::app::Lost;

fn of_file() -> App {
    let text = presets::find("fig05a").unwrap().text;
    let mut app = App::new(Opened {
        model: checked(&crate::model::read(text).unwrap().into_inner()),
        text: text.to_owned(),
        source: Source::File("mine.toml".into()),
    });
    app.start();
    app
}

fn text_with_length(length: f64) -> (Model, String) {
    let text = presets::find("fig05a").unwrap().text;
    let mut model = crate::model::read(text).unwrap().into_inner();
    model.beam.length = length;
    let text = crate::model::write(&model, text);
    (model, text)
}

#[test]
fn a_value_is_copied_with_all_its_digits_and_reads_back() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    let effects = keys(&mut app, "y");
    let [Effect::Copy(text)] = &effects[..] else {
        panic!("{effects:?}");
    };
    let text = text.clone();
    let before = number(&app, STIFFNESS);
    keys(&mut app, "+");
    press(&mut app, KeyCode::Enter);
    enter(&mut app, &text);
    assert_eq!(number(&app, STIFFNESS), before);
    let effects = keys(&mut app, "Y");
    assert!(matches!(&effects[..], [Effect::Copy(text)] if *text == app.document.text()));
    press(&mut app, KeyCode::Home);
    go(&mut app, Node::Group(Group::Supports));
    assert!(keys(&mut app, "y").is_empty());
    assert!(matches!(app.message, Some(Message::Refused(_))));
}

#[test]
fn a_change_of_the_file_is_noticed_once_and_read_as_a_step() {
    let mut app = of_file();
    let effects = app.update(Event::Touched);
    assert!(
        matches!(&effects[..], [Effect::Compare { text, .. }] if text == app.document.saved_text())
    );
    app.reply(Reply::Compared(ExternalChange::Changed));
    assert_eq!(app.files.external_change, ExternalChange::Changed);
    assert!(
        matches!(&app.message, Some(Message::Refused(text)) if text.contains("changed on disk"))
    );
    app.message = None;
    app.reply(Reply::Compared(ExternalChange::Changed));
    assert_eq!(app.message, None);
    select(&mut app, "subsystems.S1.mass");
    keys(&mut app, "+");
    let own = app.document.text();
    assert!(keys(&mut app, "R").is_empty());
    assert_eq!(app.scope(), Scope::Unsaved);
    assert!(matches!(&keys(&mut app, "d")[..], [Effect::Reload(_)]));
    let (model, text) = text_with_length(4.0);
    app.reply(Reply::Reloaded(Box::new(Opened {
        model: checked(&model),
        text: text.clone(),
        source: Source::File("mine.toml".into()),
    })));
    assert_eq!(app.files.external_change, ExternalChange::Same);
    assert!(!app.document.is_changed());
    assert_eq!(number(&app, "beam.length"), 4.0);
    assert_eq!(app.document.text(), text);
    keys(&mut app, "u");
    assert_eq!(app.document.text(), own);
    assert!(app.document.is_changed());
}

#[test]
fn a_preset_is_neither_looked_at_nor_read_again() {
    let mut app = app("fig05a");
    assert!(app.update(Event::Touched).is_empty());
    assert!(keys(&mut app, "R").is_empty());
    assert!(matches!(app.message, Some(Message::Refused(_))));
}

fn lost(count: usize) -> Vec<Lost> {
    let one = |i| Lost {
        name: format!("/tmp/{i}.toml"),
        age: Duration::from_secs(90),
    };
    (0..count).map(one).collect()
}

#[test]
fn changes_that_were_found_are_taken_discarded_or_left() {
    let mut app = app("fig06");
    app.offer(lost(3));
    assert_eq!(app.scope(), Scope::Recovery);
    assert!(matches!(keys(&mut app, "jx")[..], [Effect::Discard(1)]));
    assert!(matches!(
        press(&mut app, KeyCode::Enter)[..],
        [Effect::Recover(1)]
    ));
    app.offer(lost(1));
    assert!(matches!(keys(&mut app, "x")[..], [Effect::Discard(0)]));
    assert!(app.overlay.is_none());
    app.offer(lost(1));
    assert!(press(&mut app, KeyCode::Esc).is_empty());
    assert!(app.overlay.is_none());
    app.offer(Vec::new());
    assert!(app.overlay.is_none());
}

#[test]
fn recovered_changes_are_a_step_away_from_the_file() {
    let mut app = app("fig06");
    let (model, _) = text_with_length(4.0);
    let opened = Opened {
        model: checked(&model),
        text: presets::find("fig05a").unwrap().text.to_owned(),
        source: Source::File("mine.toml".into()),
    };
    let effects = app.reply(Reply::Recovered {
        opened: Box::new(opened),
        base: Base::Own,
        others: 0,
    });
    assert!(effects.iter().any(|one| matches!(one, Effect::Keep(_))));
    assert_eq!(number(&app, "beam.length"), 4.0);
    assert!(app.document.is_changed());
    keys(&mut app, "u");
    assert!(!app.document.is_changed());
}

#[test]
fn recovered_changes_without_a_file_stay_unsaved_until_they_are_saved() {
    let mut app = app("fig06");
    let (model, text) = text_with_length(4.0);
    let opened = Opened {
        model: checked(&model),
        text: text.clone(),
        source: Source::Stdin,
    };
    app.reply(Reply::Recovered {
        opened: Box::new(opened),
        base: Base::Missing,
        others: 0,
    });
    assert!(app.document.is_changed());
    keys(&mut app, "q");
    assert_eq!(app.scope(), Scope::Unsaved);
    press(&mut app, KeyCode::Esc);
    app.reply(Reply::Saved("here.toml".into(), text));
    assert!(!app.document.is_changed());
}

#[test]
fn a_question_that_is_not_answered_gives_back_the_box_beneath() {
    let mut app = app("fig06");
    select(&mut app, "beam.length");
    keys(&mut app, "+");
    app.offer(lost(2));
    press(&mut app, KeyCode::Enter);
    assert_eq!(app.scope(), Scope::Unsaved);
    press(&mut app, KeyCode::Esc);
    assert_eq!(app.scope(), Scope::Recovery);
    press(&mut app, KeyCode::Esc);
    press(&mut app, KeyCode::Enter);
    let control_c = KeyEvent::new(KeyCode::Char('c'), crossterm::event::KeyModifiers::CONTROL);
    app.update(Event::Key(control_c));
    assert_eq!(app.scope(), Scope::Unsaved);
    press(&mut app, KeyCode::Esc);
    assert_eq!(app.scope(), Scope::Prompt);
}

#[test]
fn a_save_that_was_given_up_quits_nothing_later() {
    let mut app = app("fig06");
    select(&mut app, "beam.length");
    keys(&mut app, "+qs");
    let control_c = KeyEvent::new(KeyCode::Char('c'), crossterm::event::KeyModifiers::CONTROL);
    app.update(Event::Key(control_c));
    press(&mut app, KeyCode::Esc);
    press(&mut app, KeyCode::Esc);
    assert_eq!(app.scope(), Scope::Main);
    keys(&mut app, "s");
    let effects = enter(&mut app, "mine.toml");
    let [Effect::Save { path, text, .. }] = &effects[..] else {
        panic!("{effects:?}");
    };
    let effects = app.reply(Reply::Saved(path.clone(), text.clone()));
    assert!(matches!(&effects[..], [Effect::Forget]), "{effects:?}");
}

#[test]
fn a_missing_file_is_saved_even_without_changes() {
    let mut app = of_file();
    assert!(keys(&mut app, "s").is_empty());
    app.reply(Reply::Compared(ExternalChange::Gone));
    assert!(matches!(keys(&mut app, "s")[..], [Effect::Save { .. }]));
}

#[test]
fn a_screen_too_small_can_be_left_and_loses_nothing() {
    let mut app = of_file();
    select(&mut app, "beam.length");
    keys(&mut app, "+");
    app.screen.unseen = true;
    assert!(keys(&mut app, "q+").is_empty());
    let control_c = KeyEvent::new(KeyCode::Char('c'), crossterm::event::KeyModifiers::CONTROL);
    let effects = app.update(Event::Key(control_c));
    assert!(matches!(effects[..], [Effect::Quit(None)]));
    assert!(app.recovery.stays && app.document.unsaved().is_some());
}

#[test]
fn the_same_question_asked_again_is_one_question() {
    let mut app = of_file();
    select(&mut app, "beam.length");
    keys(&mut app, "+");
    let control_c = KeyEvent::new(KeyCode::Char('c'), crossterm::event::KeyModifiers::CONTROL);
    for _ in 0..3 {
        app.update(Event::Key(control_c));
    }
    press(&mut app, KeyCode::Esc);
    assert_eq!(app.scope(), Scope::Main);
}

#[test]
fn a_file_changed_after_what_was_recovered_is_not_replaced_without_a_question() {
    for base in [Base::Own, Base::Newer] {
        let mut app = of_file();
        let (model, _) = text_with_length(4.0);
        let opened = Opened {
            model: checked(&model),
            text: presets::find("fig05a").unwrap().text.to_owned(),
            source: Source::File("mine.toml".into()),
        };
        app.reply(Reply::Recovered {
            opened: Box::new(opened),
            base,
            others: 0,
        });
        let effects = keys(&mut app, "s");
        let [Effect::Save { guard, path, text }] = &effects[..] else {
            panic!("{effects:?}");
        };
        assert_eq!(*guard == Guard::Absent, base == Base::Newer);
        app.reply(Reply::Saved(path.clone(), text.clone()));
        select(&mut app, "beam.length");
        keys(&mut app, "+");
        let effects = keys(&mut app, "s");
        assert!(matches!(
            &effects[..],
            [Effect::Save {
                guard: Guard::Holds(_),
                ..
            }]
        ));
    }
}

//! The search of the tree, and the palette.

use crossterm::event::KeyCode;

use crate::tui::app::tests::{STIFFNESS, app, enter, keys, number, press, select};
use crate::tui::app::{App, Found, Message, Overlay};
use crate::tui::event::Event;
use crate::tui::keys::Scope;
use crate::tui::tree;

fn typed(app: &mut App, text: &str) {
    app.update(Event::Paste(text.to_owned()));
}

fn name(app: &App) -> String {
    tree::subject(app.model(), app.selection.node())
}

#[test]
fn a_search_goes_to_the_first_row_below_and_on_and_round() {
    let mut app = app("fig05a");
    select(&mut app, "subsystems.S2.position");
    keys(&mut app, "/inertia");
    assert_eq!(name(&app), "S2 inertia");
    press(&mut app, KeyCode::Enter);
    keys(&mut app, "n");
    assert_eq!(name(&app), "S3 inertia");
    keys(&mut app, "NN");
    assert_eq!(name(&app), "S1 inertia");
    let count = app.search.as_ref().unwrap().found.len();
    keys(&mut app, &"n".repeat(count));
    assert_eq!(name(&app), "S1 inertia");
    press(&mut app, KeyCode::Esc);
    assert!(app.search.is_none());
}

#[test]
fn a_search_given_up_goes_back_and_one_without_success_says_so() {
    let mut app = app("fig05a");
    select(&mut app, STIFFNESS);
    let before = app.selection.node();
    keys(&mut app, "/mass");
    assert_ne!(app.selection.node(), before);
    press(&mut app, KeyCode::Esc);
    assert_eq!(app.selection.node(), before);
    keys(&mut app, "/nonsense");
    press(&mut app, KeyCode::Enter);
    assert_eq!(app.selection.node(), before);
    assert!(app.search.is_none());
    assert!(matches!(&app.message, Some(Message::Refused(text)) if text.contains("nonsense")));
}

#[test]
fn what_was_found_follows_a_changed_model() {
    let mut app = app("fig05a");
    keys(&mut app, "/S2 mass");
    press(&mut app, KeyCode::Enter);
    assert_eq!(app.search.as_ref().unwrap().found.len(), 1);
    keys(&mut app, "x");
    assert!(app.search.as_ref().unwrap().found.is_empty());
    keys(&mut app, "n");
    assert!(matches!(app.message, Some(Message::Refused(_))));
    keys(&mut app, "u");
    assert_eq!(app.search.as_ref().unwrap().found.len(), 1);
}

#[test]
fn the_palette_finds_a_parameter_and_edits_it() {
    let mut app = app("fig05a");
    keys(&mut app, ":s2 mass");
    press(&mut app, KeyCode::Enter);
    assert_eq!(name(&app), "S2 mass");
    enter(&mut app, "120");
    assert_eq!(number(&app, "subsystems.S2.mass"), 120.0);
}

#[test]
fn the_palette_does_every_command() {
    let mut app = app("fig05a");
    keys(&mut app, ":decibels");
    press(&mut app, KeyCode::Enter);
    assert!(app.curves.decibels);
    assert!(app.overlay.is_none());
    keys(&mut app, ":");
    let Some(Overlay::Palette(palette)) = &app.overlay else {
        panic!("no palette");
    };
    for section in crate::tui::keys::SECTIONS {
        let there = matches!(section.scope, Scope::Main | Scope::Any);
        for binding in section.rows().filter(|_| there) {
            let found = Found::Command(binding.command);
            let listed = palette.found().any(|entry| entry.found == found);
            assert_eq!(listed, binding.name != "palette", "{}", binding.name);
        }
    }
}

#[test]
fn the_palette_knows_the_habits_of_other_programs() {
    for (typed, meant) in [
        ("w", Scope::Prompt),
        ("e", Scope::Unsaved),
        ("q", Scope::Unsaved),
    ] {
        let mut app = app("fig05a");
        select(&mut app, STIFFNESS);
        keys(&mut app, &format!("+:{typed}"));
        press(&mut app, KeyCode::Enter);
        assert_eq!(app.scope(), meant, ":{typed}");
    }
}

#[test]
fn a_palette_without_a_find_stays_open() {
    let mut app = app("fig05a");
    keys(&mut app, ":qqqqqq");
    press(&mut app, KeyCode::Enter);
    assert_eq!(app.scope(), Scope::Palette);
    press(&mut app, KeyCode::Esc);
    assert_eq!(app.scope(), Scope::Main);
}

#[test]
fn a_paste_that_is_too_long_is_refused_whole() {
    let mut app = app("fig05a");
    typed(&mut app, "out of any box");
    assert!(matches!(app.message, Some(Message::Refused(_))));
    select(&mut app, STIFFNESS);
    press(&mut app, KeyCode::Enter);
    typed(&mut app, &"7".repeat(1_000_000));
    let Some(Overlay::Prompt(prompt)) = &app.overlay else {
        panic!("the box is closed");
    };
    assert!(prompt.refusal.is_some());
    assert!(prompt.input.value().len() < 40);
    keys(&mut app, &"7".repeat(10_000));
    let Some(Overlay::Prompt(prompt)) = &app.overlay else {
        panic!("the box is closed");
    };
    assert_eq!(prompt.input.value().len(), 4_096);
}

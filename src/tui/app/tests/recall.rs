//! Stored views and options.

use super::*;

#[test]
fn a_model_is_looked_at_as_it_was_left() {
    let mut first = app("fig08");
    select(&mut first, "subsystems.S2.y_left.damping");
    go(&mut first, Node::Group(Group::Response(1)));
    keys(&mut first, "vt4zdLm]");
    select(&mut first, "subsystems.S3.mass");
    let memory = first.remembered();
    let mut second = app("fig08");
    second.recall(memory);
    assert_eq!(second.selection.node(), first.selection.node());
    assert_eq!(second.selection.rows(), first.selection.rows());
    assert_eq!(second.curves.visible, first.curves.visible);
    assert_eq!(second.curves.study, Some(0));
    assert_eq!(second.curves.window, first.curves.window);
    assert_eq!(second.curves.cursor, first.curves.cursor);
    assert!(second.curves.decibels);
    assert_eq!(second.curves.log_frequency, first.curves.log_frequency);
    assert_eq!(second.tables.open, Some(Table::Modes));
}

/// Opens a preset from the list.
fn open(app: &mut App, name: &str) {
    let row = presets::ALL.iter().position(|one| one.name == name);
    keys(app, "p");
    press(app, KeyCode::Home);
    keys(app, &"j".repeat(row.unwrap()));
    press(app, KeyCode::Enter);
    assert_eq!(app.document.source().name(), name);
}

#[test]
fn each_model_has_a_view_of_its_own() {
    let mut app = app("fig08");
    keys(&mut app, "t");
    open(&mut app, "fig05a");
    assert_eq!(app.curves.study, None);
    open(&mut app, "fig08");
    assert_eq!(app.curves.study, Some(0));
}

#[test]
fn what_a_changed_model_no_longer_has_is_not_recalled() {
    let mut first = app("fig08");
    go(&mut first, Node::Group(Group::Response(1)));
    keys(&mut first, "vtj");
    let mut memory = first.remembered();
    let view = &mut memory.views[0];
    view.visible = vec!["gone".to_owned()];
    view.study = Some("gone".to_owned());
    view.cursor = Some(1e9);
    view.window = Some([-3.0, 1e9]);
    view.table = Some("gone".to_owned());
    view.selected = vec!["gone".to_owned()];
    let mut second = app("fig08");
    let fresh = app("fig08");
    second.recall(memory);
    assert_eq!(second.curves.visible, fresh.curves.visible);
    assert_eq!(second.curves.study, None);
    assert_eq!((second.curves.cursor, second.curves.window), (None, None));
    assert_eq!(second.tables.open, None);
}

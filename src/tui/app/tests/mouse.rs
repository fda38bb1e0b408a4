//! Effects of the mouse.

use crossterm::event::{KeyModifiers, MouseButton, MouseEvent, MouseEventKind};
use ratatui::Terminal;
use ratatui::backend::TestBackend;

use super::*;
use crate::tui::view;

fn draw(app: &mut App) -> Vec<String> {
    let mut terminal = Terminal::new(TestBackend::new(120, 40)).unwrap();
    let mut drawn = None;
    terminal
        .draw(|frame| drawn = view::draw(frame, app))
        .unwrap();
    app.drawn(drawn);
    let buffer = terminal.backend().buffer();
    let row = |y| (0..120).map(|x| buffer[(x, y)].symbol()).collect();
    (0..40).map(row).collect()
}

fn mouse(app: &mut App, kind: MouseEventKind, (column, row): (u16, u16)) -> Vec<Effect> {
    let event = MouseEvent {
        kind,
        column,
        row,
        modifiers: KeyModifiers::NONE,
    };
    let effects = app.update(Event::Mouse(event));
    draw(app);
    effects
}

const CLICK: MouseEventKind = MouseEventKind::Down(MouseButton::Left);
const UP: MouseEventKind = MouseEventKind::ScrollUp;
const DOWN: MouseEventKind = MouseEventKind::ScrollDown;

/// The first place of a text on the screen.
fn place(app: &mut App, text: &str) -> (u16, u16) {
    let lines = draw(app);
    let row = lines.iter().position(|line| line.contains(text)).unwrap();
    let before = lines[row].split(text).next().unwrap();
    (before.chars().count() as u16, row as u16)
}

fn solved(preset: &str) -> App {
    let mut app = app(preset);
    let first = answer(1, &app);
    app.update(Event::Answer(first));
    app
}

#[test]
fn a_click_selects_a_row_and_a_second_one_is_as_enter() {
    let mut app = solved("fig05a");
    let length = place(&mut app, "length");
    mouse(&mut app, CLICK, length);
    assert_eq!(
        tree::subject(app.model(), app.selection.node()),
        "beam length"
    );
    assert!(app.overlay.is_none());
    mouse(&mut app, CLICK, length);
    assert_eq!(app.scope(), Scope::Prompt);
}

#[test]
fn the_wheel_turns_what_was_clicked_and_moves_what_was_not() {
    let mut app = solved("fig05a");
    let length = place(&mut app, "length");
    mouse(&mut app, CLICK, length);
    mouse(&mut app, UP, length);
    assert!((number(&app, "beam.length") - 3.232).abs() < 1e-12);
    mouse(&mut app, DOWN, length);
    assert!((number(&app, "beam.length") - 3.199_68).abs() < 1e-12);
    let model = Arc::clone(app.model());
    let material = place(&mut app, "Material");
    let row = app.selection.cursor();
    mouse(&mut app, DOWN, material);
    assert_eq!(app.selection.cursor(), row + 3);
    for _ in 0..10 {
        mouse(&mut app, DOWN, material);
        mouse(&mut app, UP, material);
    }
    assert_eq!(
        **app.model(),
        *model,
        "what comes under the mouse is not turned"
    );
    let details = app.screen.details;
    select(&mut app, "beam.length");
    mouse(&mut app, UP, (details.x + 2, details.y + 1));
    assert_ne!(**app.model(), *model);
}

#[test]
fn a_click_on_the_chart_puts_the_cursor_into_that_column() {
    let mut app = solved("fig05a");
    draw(&mut app);
    let plot = app.screen.plot.clone().unwrap();
    for column in [plot.area.x, plot.area.x + 17, plot.area.right() - 1] {
        mouse(&mut app, CLICK, (column, plot.area.y + 2));
        let lines = draw(&mut app);
        let axis = &lines[usize::from(plot.area.bottom())];
        assert_eq!(axis.chars().nth(usize::from(column)), Some('▲'), "{axis}");
    }
}

#[test]
fn the_wheel_zooms_about_the_mouse() {
    let mut app = solved("fig05a");
    draw(&mut app);
    let plot = app.screen.plot.clone().unwrap();
    let place = (plot.area.x + 20, plot.area.y + 2);
    let frequency = plot.frequencies[20];
    for _ in 0..5 {
        mouse(&mut app, UP, place);
    }
    let [low, high] = app.shown_frequencies();
    // Five notches of 20 % each.
    let whole = app.model().sweep.to - app.model().sweep.from;
    assert!(((high - low) / whole - 0.8_f64.powi(5)).abs() < 1e-9);
    let zoomed = app.screen.plot.clone().unwrap().frequencies[20];
    assert!(
        (zoomed - frequency).abs() < 0.02 * (high - low),
        "{zoomed} {frequency}"
    );
    for _ in 0..6 {
        mouse(&mut app, DOWN, place);
    }
    assert_eq!(app.curves.window, None);
}

#[test]
fn lists_and_tables_are_chosen_from_by_clicks() {
    let mut app = solved("fig05a");
    keys(&mut app, "p");
    let fig06 = place(&mut app, "fig06");
    mouse(&mut app, CLICK, fig06);
    assert_eq!(app.scope(), Scope::Picker);
    mouse(&mut app, CLICK, fig06);
    assert_eq!(app.document.source(), &Source::Preset("fig06"));
    let mut app = solved("fig05a");
    keys(&mut app, "P");
    draw(&mut app);
    if let Some(rows) = app.screen.table.filter(|rows| rows.area.height > 2) {
        mouse(&mut app, CLICK, (rows.area.x + 3, rows.area.y + 2));
        assert_eq!(app.tables.peaks.row, rows.first + 2);
    }
}

#[test]
fn the_mouse_is_left_to_the_terminal_and_taken_again() {
    let mut app = app("fig05a");
    assert!(matches!(keys(&mut app, "X")[..], [Effect::Mouse(true)]));
    assert!(matches!(keys(&mut app, "X")[..], [Effect::Mouse(false)]));
}

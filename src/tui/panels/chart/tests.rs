//! The visible frequencies.

use crossterm::event::KeyCode;

use crate::model::{Model, checked};
use crate::tui::app::tests::{app, enter, keys, press, select};
use crate::tui::app::{App, Message};

fn band(app: &App) -> [f64; 2] {
    app.shown_frequencies()
}

#[test]
fn zooming_halves_about_the_cursor_and_goes_back_to_the_whole() {
    let mut app = app("fig05a");
    let sweep = app.model().sweep;
    app.curves.cursor = Some(100.0);
    keys(&mut app, "z");
    let [low, high] = band(&app);
    assert!((high - low - (sweep.to - sweep.from) / 2.0).abs() < 1e-9);
    // The cursor keeps its place on the axis.
    let share = |[low, high]: [f64; 2]| (100.0 - low) / (high - low);
    assert!((share([low, high]) - share([sweep.from, sweep.to])).abs() < 1e-12);
    keys(&mut app, "Z");
    assert_eq!(app.curves.window, None);
    keys(&mut app, "3zW");
    assert_eq!(band(&app), [sweep.from, sweep.to]);
}

#[test]
fn a_logarithmic_axis_is_halved_in_its_own_measure() {
    let mut app = app("fig05a");
    let sweep = app.model().sweep;
    keys(&mut app, "Lz");
    let [low, high] = band(&app);
    let half = (sweep.to / sweep.from).sqrt();
    assert!((high / low / half - 1.0).abs() < 1e-12);
}

#[test]
fn any_sweep_is_zoomed_into_and_out_of() {
    // For some of these bounds, adding and subtracting the width does not restore the bound.
    let sweeps = [
        [20.0, 20_000.0],
        [3.0, 30.0],
        [5.0, 50.0],
        [0.5, 500.0],
        [0.1, 100.0],
        [20.0, 2_000.0],
    ];
    for [from, to] in sweeps {
        for spacing in ["", "L"] {
            let mut app = app("fig05a");
            let mut model = Model::clone(app.model());
            (model.sweep.from, model.sweep.to) = (from, to);
            app.document
                .replace("another sweep".to_owned(), checked(&model));
            keys(&mut app, spacing);
            keys(&mut app, "z2zZKJZ3zZZZ5z9Z");
            assert_eq!(band(&app), [from, to]);
            for cursor in [from, to] {
                app.curves.cursor = Some(cursor);
                keys(&mut app, "99z");
                let [low, high] = band(&app);
                assert!(low <= cursor && cursor <= high, "{cursor} {low} {high}");
                assert!((high - low) < 1e-4 * (to - from), "{low} {high}");
                keys(&mut app, "99Z");
                assert_eq!(app.curves.window, None);
            }
        }
    }
}

#[test]
fn the_band_moves_by_quarters_and_stops_at_the_ends() {
    let mut app = app("fig05a");
    let sweep = app.model().sweep;
    keys(&mut app, "zK");
    let width = (sweep.to - sweep.from) / 2.0;
    let low = sweep.from + width / 2.0 + width / 4.0;
    assert!((band(&app)[0] - low).abs() < 1e-9);
    keys(&mut app, "99K");
    assert!((band(&app)[1] - sweep.to).abs() < 1e-9);
    assert!(matches!(app.message, Some(Message::Refused(_))));
    keys(&mut app, "99J");
    assert!((band(&app)[0] - sweep.from).abs() < 1e-9);
}

#[test]
fn the_band_follows_the_cursor() {
    let mut app = app("fig05a");
    keys(&mut app, "2z999]");
    let [low, high] = band(&app);
    let cursor = app.curves.cursor.unwrap();
    assert!((low..=high).contains(&cursor));
    assert_eq!(cursor, app.model().sweep.to);
}

#[test]
fn a_sweep_that_leaves_the_band_shows_whole() {
    let mut app = app("fig05a");
    keys(&mut app, "5z");
    let high = band(&app)[1];
    select(&mut app, "sweep.to");
    press(&mut app, KeyCode::Enter);
    let low = band(&app)[0] / 2.0;
    enter(&mut app, &format!("{low}"));
    assert!(high > low);
    assert_eq!(band(&app), [app.model().sweep.from, low]);
    // Undo restores the band.
    keys(&mut app, "u");
    assert_eq!(band(&app)[1], high);
}

//! Shared parts of the tests of these panels: an app with the cursor at a frequency, and its screen.

use crate::model::Checked;
use std::sync::Arc;

use ratatui::Terminal;
use ratatui::backend::TestBackend;

use super::*;
use crate::files::{Opened, Source};
use crate::presets;
use crate::solve::operating::operating;
use crate::tui::app::BeamView;
use crate::tui::ascii;
use crate::tui::options::{Environment, Marker, Options};

/// The function that draws a panel.
pub(crate) type Draw = fn(&mut Frame<'_>, &App, Theme, Rect);

pub(crate) fn preset(name: &str) -> Model {
    crate::model::read(presets::find(name).unwrap().text)
        .unwrap()
        .into_inner()
}

/// An app that shows a model's motion at a frequency, Hz.
pub(crate) fn looking(model: Model, frequency: f64, look: BeamView) -> App {
    let model = Checked::new(model).unwrap();
    let found = operating(&model, frequency, 101);
    let mut app = App::new(Opened {
        model,
        text: String::new(),
        source: Source::Stdin,
    });
    app.curves.cursor = Some(frequency);
    app.beam_view.shown = Some(look);
    app.beam_view.operating = Some((Arc::clone(app.model()), Arc::new(found)));
    app.beam_view.generation = app.curves.generation;
    app
}

/// The panel as text, one line per row.
pub(crate) fn screen(
    app: &App,
    theme: Theme,
    draw: Draw,
    [width, height]: [u16; 2],
) -> Vec<String> {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
    terminal
        .draw(|frame| draw(frame, app, theme, frame.area()))
        .unwrap();
    let buffer = terminal.backend().buffer().clone();
    let rows = buffer.content.chunks(usize::from(width.max(1)));
    rows.map(|row| {
        let row: String = row.iter().map(ratatui::buffer::Cell::symbol).collect();
        row.trim_end().to_owned()
    })
    .collect()
}

/// Draws a panel at sizes from one cell to a large screen, with every character set.
pub(crate) fn draws_at_any_size(draw: Draw, look: BeamView) {
    let environment = Environment {
        locale: Some("C.UTF-8".to_owned()),
        ..Environment::default()
    };
    let plain = Options {
        ascii: Some(true),
        ..Options::default()
    };
    let with = |marker| Options {
        marker: Some(marker),
        ..Options::default()
    };
    let all = [
        plain,
        with(Marker::Braille),
        with(Marker::Block),
        with(Marker::Dot),
    ];
    for preset_name in ["fig05a", "fig06", "hundred_absorbers"] {
        let app = looking(preset(preset_name), 35.0, look);
        for options in &all {
            let theme = Theme::resolve(*options, &environment);
            for size in [
                [1, 1],
                [3, 2],
                [12, 3],
                [20, 4],
                [44, 8],
                [44, 20],
                [78, 24],
                [160, 50],
            ] {
                let lines = screen(&app, theme, draw, size);
                if theme.is_ascii() {
                    let plain = ascii::text(&lines.join("\n"));
                    assert!(!plain.contains('?'), "{plain}");
                }
            }
        }
    }
}

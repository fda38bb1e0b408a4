//! Shared parts of the tests of these panels: an app with the cursor at a frequency, and its screen.

use crate::model::{BeamMotion, Checked, Force, Place, Support, Target};
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
use crate::tui::tree::Node;

/// The function that draws a panel.
pub(crate) type Draw = fn(&mut Frame<'_>, &App, Theme, Rect);

pub(crate) fn preset(name: &str) -> Model {
    crate::model::read(presets::find(name).unwrap().text)
        .unwrap()
        .into_inner()
}

/// The designer with a model.
pub(crate) fn app(model: Model) -> App {
    App::new(Opened {
        model: Checked::new(model).unwrap(),
        text: String::new(),
        source: Source::Stdin,
    })
}

/// The designer with a row selected.
pub(crate) fn at(model: Model, node: Node) -> App {
    let mut app = app(model);
    let model = app.model().clone();
    app.selection.select(&model, node);
    assert_eq!(app.selection.node(), node);
    app
}

/// A theme in a locale of UTF-8.
pub(crate) fn theme(options: Options) -> Theme {
    let environment = Environment {
        locale: Some("C.UTF-8".to_owned()),
        ..Environment::default()
    };
    Theme::resolve(options, &environment)
}

/// A pinned beam without offset and damping, and a force along y in its middle, with a phase in degrees.
pub(crate) fn pinned(phase: f64) -> Model {
    let mut model = preset("fig06");
    (model.supports.left, model.supports.right) = (Support::PINNED, Support::PINNED);
    model.beam.section.centroid_offset = 0.0;
    model.forces = vec![Force {
        enabled: true,
        target: Target::Beam(Place::Position(1.6), BeamMotion::W),
        amplitude: 1.0,
        phase,
        point: crate::model::Point::AXIS,
    }];
    model
}

/// An app that shows a model's motion at a frequency, Hz.
pub(crate) fn looking(model: Model, frequency: f64, look: BeamView) -> App {
    let mut app = app(model);
    let found = operating(app.model(), frequency, 101);
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
            let theme = theme(*options);
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

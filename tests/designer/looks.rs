//! The appearance of the designer: ASCII, other markers, and the number of bytes per change.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::io;

use super::driver::Driver;
use beamtune::tui::backend::CompactBackend;
use beamtune::tui::options::{Environment, Marker, Options};
use beamtune::tui::theme::Theme;
use beamtune::tui::{tree, view};
use ratatui::Terminal;
use ratatui::layout::{Rect, Size};

const SIZES: [(u16, u16); 2] = [(80, 24), (120, 40)];

/// A theme in a locale of UTF-8.
fn theme(options: Options) -> Theme {
    let environment = Environment {
        locale: Some("C.UTF-8".to_owned()),
        term: Some("xterm".to_owned()),
        ..Environment::default()
    };
    Theme::resolve(options, &environment)
}

fn ascii() -> Theme {
    theme(Options {
        ascii: Some(true),
        ..Options::default()
    })
}

fn with_marker(marker: Marker) -> Theme {
    theme(Options {
        marker: Some(marker),
        ..Options::default()
    })
}

/// Designers that together show every kind of element, and texts that their screens must contain.
fn scenes() -> Vec<(Driver, &'static str)> {
    let mut scenes = Vec::new();
    let mut scene = |preset: &str, path: &str, keys: &str, holds| {
        let mut driver = Driver::preset(preset);
        driver.select(path).keys(keys);
        scenes.push((driver, holds));
    };
    let length = "beam.length";
    scene("fig05a", length, "", "Hz");
    scene("fig05a", length, "+", "->");
    scene("fig05a", length, "?", "Keys");
    scene("fig05a", length, "p", "Presets");
    scene("fig05a", length, "Enter", "number");
    scene("fig05a", length, "m", "modes");
    scene("fig05a", length, "P", "Peaks");
    scene("fig05a", length, ") ) M", "psi");
    scene("fig05a", length, ":", "Commands");
    scene("fig05a", length, "/", "/");
    scene("fig05a", length, "+ q", "Save");
    scene("fig05a", length, "d L", "dB");
    scene("fig06", length, "w", "FEM");
    scene("fig08", "responses.1.measure", "t", "study");
    let mut failed = Driver::preset("fig05a");
    failed.answered(|answer| answer.result = Err("Knickl\u{e4}nge \u{2260} 0".to_owned()));
    scenes.push((failed, "not solved"));
    scenes
}

#[test]
fn every_screen_is_ascii_where_that_is_asked_for() {
    for (mut driver, holds) in scenes() {
        driver.app.theme = ascii();
        for (width, height) in SIZES {
            let screen = driver.screen(width, height);
            let strange: Vec<char> = screen.chars().filter(|c| !c.is_ascii()).collect();
            assert!(strange.is_empty(), "{strange:?} in\n{screen}");
            assert!(screen.contains(holds), "no {holds} in\n{screen}");
        }
    }
}

#[test]
fn in_ascii() {
    let mut driver = Driver::preset("fig05a");
    driver.select("beam.length").keys("f + m");
    driver.app.theme = ascii();
    insta::assert_snapshot!("ascii_80x24", driver.screen(80, 24));
    let mut driver = Driver::preset("fig05a");
    driver.keys(") ) ) M");
    driver.app.theme = ascii();
    insta::assert_snapshot!("ascii_shape_80x24", driver.screen(80, 24));
}

#[test]
fn in_other_markers() {
    let mut driver = Driver::preset("fig06");
    driver.keys("w");
    driver.app.theme = with_marker(Marker::Block);
    insta::assert_snapshot!("blocks_80x24", driver.screen(80, 24));
    driver.app.theme = with_marker(Marker::Dot);
    insta::assert_snapshot!("dots_80x24", driver.screen(80, 24));
}

#[allow(clippy::unnecessary_wraps)] // Like a terminal size that may be unknown.
fn size() -> io::Result<Size> {
    Ok(Size::new(120, 40))
}

/// A designer with a terminal that counts bytes.
struct Counter {
    driver: Driver,
    terminal: Terminal<CompactBackend<Vec<u8>>>,
}

impl Counter {
    fn new(preset: &str) -> Self {
        let mut counter = Self {
            driver: Driver::preset(preset),
            terminal: Terminal::new(CompactBackend::new(Vec::new(), size)).unwrap(),
        };
        counter.draw();
        counter
    }

    /// Draws the changes; returns the number of bytes.
    fn draw(&mut self) -> usize {
        let app = &mut self.driver.app;
        let mut drawn = None;
        self.terminal
            .draw(|frame| drawn = view::draw(frame, app))
            .unwrap();
        app.drawn(drawn);
        std::mem::take(self.terminal.backend_mut().writer_mut()).len()
    }

    fn repaint(&mut self) -> usize {
        let area = Rect::from((ratatui::layout::Position::ORIGIN, size().unwrap()));
        self.terminal.resize(area).unwrap();
        self.draw()
    }
}

/// The goal is a third of a full repaint, for the parameter in the middle. One picture per key is assumed; the frame
/// scheduler is tested elsewhere.
#[test]
fn a_nudge_is_written_in_under_a_third_of_a_repaint() {
    let mut counter = Counter::new("fig05a");
    let model = counter.driver.app.model().clone();
    let mut shares = Vec::new();
    for row in tree::all_rows(&model) {
        if row.node.parameter().is_none() {
            continue;
        }
        counter.driver.app.selection.select(&model, row.node);
        counter.draw();
        counter.driver.keys("+");
        let nudge = counter.draw();
        counter.driver.keys("u");
        counter.draw();
        if nudge > 0 {
            shares.push(nudge as f64 / counter.repaint() as f64);
        }
    }
    shares.sort_by(f64::total_cmp);
    assert!(shares.len() > 20, "{shares:?}");
    let median = shares[shares.len() / 2];
    assert!(median < 1.0 / 3.0, "{median}");
}

#[test]
fn nothing_is_written_where_nothing_happens() {
    let mut counter = Counter::new("fig05a");
    assert_eq!(counter.draw(), 0);
}

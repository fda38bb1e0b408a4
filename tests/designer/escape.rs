//! Names from files are shown escaped on every screen.

use std::ffi::OsString;
use std::os::unix::ffi::OsStringExt as _;

use beamtune::files::Source;
use beamtune::model;
use beamtune::tui::theme::Theme;

use super::dice::Dice;
use super::driver::Driver;
use super::hidden::{assert_safe, controls};
use super::hostile::{hostile, hostile_model};

#[test]
fn every_view_shows_names_escaped() {
    const KEYS: &str = "E PgDn PgDn PgDn PgDn g B B B O O O O O O O O O M m P \" _ ~ ~ ~ ~ ~ t t t f b b b b b Q r Esc Esc : d \
                        Esc / d Esc r Esc S Esc o Esc ? Esc Ctrl-e Esc Ctrl-o Esc ^ Esc w Ctrl-k G $ Esc x u D u";
    let mut dice = Dice(5);
    for ascii in [false, true] {
        let (name, title) = (hostile(&mut dice, &[]), hostile(&mut dice, &controls()));
        let text = hostile_model(&name, &title);
        let file = OsString::from_vec([b"m\x1b\xff", name.as_bytes(), b".toml"].concat());
        let source = Source::File(file.into());
        let mut driver = Driver::opened(model::read(&text).unwrap().into_inner(), text, source);
        if ascii {
            driver.app.theme = Theme::new(false);
        }
        let start = driver.screen(120, 40);
        assert!(start.contains("m\\u{1b}\\xffx\\u{"), "{start}");
        assert!(start.contains("=tipx\\u{"), "{start}");
        for key in KEYS.split_whitespace() {
            driver.keys(key);
            for (columns, rows) in [(80, 24), (120, 40)] {
                let screen = driver.screen(columns, rows);
                assert_safe(key, screen.as_bytes());
                let let_through = screen.contains(char::REPLACEMENT_CHARACTER);
                assert!(!let_through, "{key}: {screen}");
            }
        }
    }
}

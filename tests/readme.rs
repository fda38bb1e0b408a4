//! The README says what the program does.
#![allow(clippy::unwrap_used)]

use beamtune::tui::keys::KeyMap;
use beamtune::tui::user::config;

/// The text between two markers of the README.
fn between<'a>(readme: &'a str, start: &str, end: &str) -> &'a str {
    let (_, rest) = readme.split_once(start).unwrap();
    rest.split_once(end).unwrap().0
}

#[test]
fn the_keys_are_those_of_the_key_table() {
    let readme = std::fs::read_to_string("README.md").unwrap();
    let table = between(&readme, "holds them equal -->\n", "<!-- end of keys -->");
    assert_eq!(
        table.trim(),
        KeyMap::default().markdown_table().trim(),
        "copy the table on the right into the README"
    );
}

#[test]
fn the_configuration_is_a_sound_one() {
    let readme = std::fs::read_to_string("README.md").unwrap();
    let section = between(&readme, "## Your configuration\n", "\n## ");
    let text = between(section, "```toml\n", "```");
    let faults = config::read(text).map(drop);
    assert_eq!(faults, Ok(()), "{text}");
}

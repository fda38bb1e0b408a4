//! The README says what the program does.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use beamtune::measured::{Hint, read};
use beamtune::tui::app::{OpenedMeasured, Reply};
use beamtune::tui::keys::KeyMap;
use beamtune::tui::user::config;

#[path = "screens/driver.rs"]
#[allow(dead_code, clippy::expect_used)]
mod driver;

use driver::Driver;

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

/// Where the tree ends and the chart begins, columns.
const TREE: usize = 37;

/// A terminal of 80x24 after some keys, without its first line, which tells times.
fn whole_screen(driver: &mut Driver, keys: &str) -> String {
    driver.keys(keys);
    let screen = driver.screen(80, 24);
    let rows = screen.lines().filter(|line| line.starts_with('|'));
    let rows = rows.skip(1).take(23).map(|row| {
        let row = row.strip_prefix('|').unwrap_or(row);
        row.strip_suffix('|').unwrap_or(row).trim_end().to_owned()
    });
    rows.collect::<Vec<_>>().join("\n")
}

/// The right side of a terminal of 80x24, as the README shows it, after some keys.
fn right_side(driver: &mut Driver, keys: &str) -> String {
    driver.keys(keys);
    let screen = driver.screen(80, 24);
    let rows = screen.lines().filter(|line| line.starts_with('|'));
    let rows = rows.skip(1).take(22).map(|row| {
        let right: String = row.chars().skip(TREE).collect();
        right.trim_end_matches('|').trim_end().to_owned()
    });
    rows.collect::<Vec<_>>().join("\n")
}

/// Puts the cursor at a frequency.
fn at(preset: &str, frequency: &str) -> Driver {
    let mut driver = Driver::preset(preset);
    driver.keys("@").typed(frequency).keys("Enter");
    driver
}

/// The worked example of a measured curve.
fn measured() -> Driver {
    let mut driver = Driver::preset("fig05a");
    let name = "tests/data/measured/example.csv";
    let hint = Hint {
        name: name.to_owned(),
        layout: None,
    };
    let curves = read(&std::fs::read(name).unwrap(), &hint).unwrap();
    let opened = Reply::Measured(OpenedMeasured::Curves(curves));
    let effects = driver.app.reply(opened);
    driver.perform(effects);
    driver.keys("@").typed("1").keys("Enter c");
    driver.keys("@").typed("30").keys("Enter");
    driver
}

/// Every picture by its name.
fn pictures() -> Vec<(&'static str, String)> {
    let mut compared = at("fig08", "24.9516");
    compared.select("subsystems.S1.y_left.stiffness").keys("f");
    compared.keys("Enter").typed("6.5 MN/m").keys("Enter c");
    compared.keys("@").typed("44.5 Hz").keys("Enter");
    let mut compared_again = at("fig08", "24.9516");
    compared_again
        .select("subsystems.S1.y_left.stiffness")
        .keys("f");
    compared_again.keys("Enter").typed("6.5 MN/m").keys("Enter");
    vec![
        ("phase", right_side(&mut at("fig08", "26.75"), "b \"")),
        (
            "nyquist",
            right_side(&mut at("cantilever", "24.9"), "i i b b b"),
        ),
        ("compare", right_side(&mut compared, "_")),
        ("difference", right_side(&mut compared_again, "b b b b")),
        ("deflection", right_side(&mut at("fig05a", "31.5"), "O")),
        ("moments", right_side(&mut at("fig05a", "31.5"), "O O")),
        (
            "power",
            right_side(&mut at("fig05a", "31.5"), "O O O O O O"),
        ),
        ("structure", right_side(&mut at("cantilever", "31.5"), "B")),
        ("section", right_side(&mut at("fig05a", "31.5"), "B B")),
        ("measured", right_side(&mut measured(), "_")),
        (
            "sensitivities",
            whole_screen(&mut Driver::preset("cantilever"), "} } ~"),
        ),
        (
            "tuning",
            whole_screen(&mut Driver::preset("cantilever"), "2 0 0 Ctrl-g"),
        ),
    ]
}

#[test]
fn the_pictures_are_what_the_screen_shows() {
    let readme = std::fs::read_to_string("README.md").unwrap();
    for (name, picture) in pictures() {
        let section = between(&readme, &format!("<!-- picture {name} -->"), "<!-- end -->");
        let shown = between(section, "```text\n", "\n```");
        assert_eq!(shown, picture, "copy the right one into the README: {name}");
    }
}

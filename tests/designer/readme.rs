//! The README and the guide match the program.
//!
//! With `UPDATE_GUIDE=1` in the environment, the tests write their pictures and tables into the files instead.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::fmt::Write as _;
use std::sync::{Mutex, PoisonError};

use beamtune::guide;
use beamtune::measured::{Hint, read};
use beamtune::model::{self, BeamMotion, MassMotion, Quantity, Spacing, Support, schema};
use beamtune::tui::app::{OpenedMeasured, Reply};
use beamtune::tui::keys::{KeyMap, Scope};
use beamtune::tui::user::config;

use super::driver::Driver;

/// The text between two markers, with the text before and after it.
fn split<'a>(text: &'a str, start: &str, end: &str) -> [&'a str; 3] {
    let (before, rest) = text.split_once(start).expect(start);
    let (between, after) = rest.split_once(end).expect(end);
    [before, between, after]
}

/// Several tests write to the same file.
static FILES: Mutex<()> = Mutex::new(());

/// Compares the text between two markers of a file with the program's, or writes it.
fn hold(file: &str, start: &str, end: &str, shown: &str) {
    let _turn = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    let text = std::fs::read_to_string(file).unwrap();
    let [before, between, after] = split(&text, start, end);
    if std::env::var_os("UPDATE_GUIDE").is_some() {
        std::fs::write(file, [before, start, shown, end, after].concat()).unwrap();
        return;
    }
    assert_eq!(
        between, shown,
        "{file} has other text after {start}: UPDATE_GUIDE=1 writes the right one"
    );
}

/// The first block of TOML of a chapter.
fn toml(chapter: &str) -> &'static str {
    let chapter = guide::find(chapter).unwrap();
    split(chapter.markdown, "```toml\n", "```")[1]
}

#[test]
fn the_keys_are_those_of_the_key_table() {
    let start = "holds them equal -->\n";
    let table = KeyMap::default().markdown_table();
    hold("src/guide/keys.md", start, "<!-- end of keys -->", &table);
}

/// Each key of the README's short table runs one of the commands in its row.
#[test]
fn the_twenty_keys_run_the_commands_in_their_rows() {
    let readme = std::fs::read_to_string("README.md").unwrap();
    let section = split(&readme, "## Twenty keys\n", "\n## ")[1];
    let map = KeyMap::default();
    let mut count = 0;
    for row in section.lines().filter(|line| line.starts_with("| `")) {
        let cells: Vec<&str> = row.split(" | ").collect();
        let words = |cell: &str| -> Vec<String> {
            let words = cell.split([' ', '|']).filter(|word| !word.is_empty());
            words
                .map(|word| word.trim_matches('`').to_owned())
                .collect()
        };
        let names = words(cells[2]);
        for key in words(cells[0]) {
            let mut rows = map.of(Scope::Main);
            let has = |key: &String, names: &str| names.split(' ').any(|one| one == key);
            let bound = rows.find(|row| has(&key, &row.names())).expect(&key);
            assert!(names.iter().any(|name| name == bound.binding.name), "{row}");
            count += 1;
        }
    }
    assert_eq!(count, 20);
}

#[test]
fn the_chapters_are_those_of_the_program() {
    let mut table = String::from("| chapter | what it explains |\n| --- | --- |\n");
    for chapter in guide::CHAPTERS {
        let name = chapter.name;
        let _ = writeln!(
            table,
            "| [`{name}`](src/guide/{name}.md) | {} |",
            chapter.summary()
        );
    }
    let start = "<!-- chapters: the list of the program; a test holds them equal -->\n";
    hold("README.md", start, "<!-- end of chapters -->", &table);
}

#[test]
fn the_configuration_is_a_sound_one() {
    let text = toml("configuration");
    let faults = config::read(text).map(drop);
    assert_eq!(faults, Ok(()), "{text}");
}

#[test]
fn the_examples_of_a_model_file_are_possible_models() {
    assert_eq!(model::read(toml("model")).map(drop), Ok(()));
    let preset = beamtune::presets::find("fig05a").unwrap().text;
    let tuned = format!("{preset}\n{}", toml("tuning"));
    assert_eq!(model::read(&tuned).map(drop), Ok(()));
}

/// The values that a key of the model file accepts, as text.
fn accepted(table: &str, key: &schema::Key) -> String {
    let number = |kind: &str| match key.unit.symbol {
        "" => kind.to_owned(),
        unit => format!("{kind}, {unit}"),
    };
    match key.kind {
        schema::Kind::Number => number(key.range.words()),
        schema::Kind::Count => "a whole number".to_owned(),
        schema::Kind::Flag => "true, false".to_owned(),
        schema::Kind::Word => key.words.join(", "),
        schema::Kind::Place | schema::Kind::Direction if table == "responses" => {
            "as its measure permits, see above".to_owned()
        }
        schema::Kind::Place => "left, right, a number of m, the name of a subsystem".to_owned(),
        schema::Kind::Direction => [BeamMotion::WORDS, MassMotion::WORDS].concat().join(", "),
        schema::Kind::Measure => Quantity::words().join(", "),
        schema::Kind::Over => "the name of another response that is not itself over one".to_owned(),
        schema::Kind::Support => Support::WORDS.join(", "),
        schema::Kind::Restraint => "free, fixed, a table as below".to_owned(),
        schema::Kind::Link => "rigid, free, a table as below".to_owned(),
        schema::Kind::Table => format!("a table with the keys of `beam.{}`", key.key),
        schema::Kind::Paths => "a path; or `paths`: an array of paths".to_owned(),
        schema::Kind::Scale => Spacing::WORDS.join(", "),
        schema::Kind::Response => "the name of a response".to_owned(),
        schema::Kind::Name => "a name that is unique in its list".to_owned(),
        schema::Kind::Line => "one line of text".to_owned(),
        schema::Kind::Text | schema::Kind::Filled | schema::Kind::Optional => "text".to_owned(),
    }
}

/// A row for every key of a table.
fn key_rows(table: &mut String, name: &str, keys: &[schema::Key]) {
    let dot = if name.is_empty() { "" } else { "." };
    for key in keys {
        let default = key.default.map(|value| format!("; {value} by default"));
        let symbol = match key.symbol {
            "" => String::new(),
            symbol => format!(" ({symbol})"),
        };
        let (own, meaning) = (key.key, key.meaning);
        let accepted = accepted(name, key) + &default.unwrap_or_default();
        let _ = writeln!(
            table,
            "| `{name}{dot}{own}` | {meaning}{symbol} | {accepted} |"
        );
    }
}

#[test]
fn the_keys_of_the_model_file_are_those_of_the_schema() {
    let mut table = String::from("| key | meaning (symbol) | accepted |\n| --- | --- | --- |\n");
    for (name, keys) in [
        ("", schema::MODEL.keys),
        ("beam", schema::BEAM.keys),
        ("beam.material", schema::MATERIAL.keys),
        ("beam.section", schema::SECTION.keys),
        ("beam.foundation", schema::FOUNDATION.keys),
        ("beam.spans", schema::SPAN.keys),
        ("supports.inner", schema::INNER_SUPPORT.keys),
        ("supports.left", schema::SUPPORT.keys),
        ("supports.left.w", schema::ELASTIC_TRANSLATION.keys),
        ("supports.left.psi", schema::ELASTIC_ROTATION.keys),
        ("supports.left.psi_slope", schema::ELASTIC_WARPING.keys),
        ("supports.left.w.maxwell", schema::BRANCH_TRANSLATION.keys),
        ("supports.left.psi.maxwell", schema::BRANCH_ROTATION.keys),
        (
            "supports.left.psi_slope.maxwell",
            schema::BRANCH_WARPING.keys,
        ),
        ("joints", schema::JOINT.keys),
        ("joints.w", schema::LINK_TRANSLATION.keys),
        ("joints.psi", schema::LINK_ROTATION.keys),
        ("joints.psi_slope", schema::LINK_WARPING.keys),
        ("subsystems", schema::SUBSYSTEM.keys),
        ("forces", schema::FORCE.keys),
        ("responses", schema::RESPONSE.keys),
        ("sweep", schema::SWEEP.keys),
        ("studies", schema::STUDY.keys),
        ("tune.variables", schema::VARIABLE.keys),
        ("tune.objectives", schema::OBJECTIVE.keys),
    ] {
        key_rows(&mut table, name, keys);
    }
    let start = "<!-- model keys: generated from the schema; a test holds them equal -->\n";
    hold(
        "src/guide/model.md",
        start,
        "<!-- end of model keys -->",
        &table,
    );
}

/// The border between tree and chart, columns.
const TREE: usize = 37;

/// A terminal of 80x24 after some keys, without its first line, which contains times.
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

/// The right side of a terminal of 80x24, as the guide shows it, after some keys.
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

/// Moves the cursor to a frequency.
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

/// Every picture: README or a chapter, its name, its lines.
fn pictures() -> Vec<(&'static str, &'static str, String)> {
    let mut compared = at("fig08", "24.9516");
    compared.select("subsystems.S1.y_left.stiffness").keys("f");
    compared.keys("Enter").typed("6.5 MN/m").keys("Enter c");
    compared.keys("@").typed("44.5 Hz").keys("Enter");
    let mut compared_again = at("fig08", "24.9516");
    compared_again
        .select("subsystems.S1.y_left.stiffness")
        .keys("f");
    compared_again.keys("Enter").typed("6.5 MN/m").keys("Enter");
    let mut turned = at("fig08", "22.98");
    turned.select("subsystems.S1.y_left.stiffness").keys("f");
    turned.keys("Enter").typed("5 MN/m").keys("Enter");
    let tuned = whole_screen(&mut Driver::preset("cantilever"), "2 0 0 Ctrl-g");
    let sensed = whole_screen(&mut Driver::preset("cantilever"), "} } ~");
    let looks = [
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
    ];
    let looks = looks.map(|(name, picture)| ("analyser", name, picture));
    let others = [
        ("README", "fig08", whole_screen(&mut turned, "z z z P")),
        ("measured", "measured", right_side(&mut measured(), "_")),
        ("tuning", "sensitivities", sensed),
        ("tuning", "tuning", tuned),
    ];
    looks.into_iter().chain(others).collect()
}

#[test]
fn the_pictures_are_what_the_screen_shows() {
    for (file, name, picture) in pictures() {
        let file = match file {
            "README" => "README.md".to_owned(),
            chapter => format!("src/guide/{chapter}.md"),
        };
        let start = format!("<!-- picture {name} -->\n```text\n");
        hold(&file, &start, "```\n<!-- end -->", &format!("{picture}\n"));
    }
}

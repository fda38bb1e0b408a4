//! Ten thousand random keys, twenty times, through the real terminal: no panic, a valid model at any time, and undo
//! leads back to the opened file, to the last byte.

use std::fs;

use beamtune::{guide, model};

use super::dice::Dice;
use super::harness::{ESCAPE, Home, Program};

/// As many at once as may wait for a reader of the terminal; then the state is checked.
const BURST: usize = 1_000;

/// Bursts per seed.
const BURSTS: usize = 10;

/// Quitting, other files, and suspending are excluded; so is saving over the file. F9 to F11 are not among the random
/// keys.
const CONFIGURATION: &str = "
[keys.model]
quit = []
save = []
save-as = [\"F9\"]
open = []
presets = []
palette = []
[keys.everywhere]
suspend = []
end = [\"F10\"]
[keys.unsaved]
save = [\"F11\"]
";

/// Texts typed into dialogs; without a dialog, their letters act as commands.
const TYPED: [&str; 12] = [
    "4e7",
    "*1.1",
    "/2",
    "+5%",
    "-1",
    "0",
    "1.6",
    "left",
    "S1",
    "new name",
    "S.1 \"x\"",
    "\u{b5}\u{df}\u{4e2d}",
];

/// Sequences that are not keys, broken ones, and reports of terminals.
const STRANGE: [&str; 8] = [
    "\u{1b}[I",
    "\u{1b}[O",
    "\u{1b}[99~",
    "\u{1b}[12;40R",
    "\u{1b}[?62;4c",
    "\u{1b}[200~pasted\u{1b}[201~",
    "\u{1b}x",
    "\u{1b}[1;5C",
];

/// The bytes that a terminal sends for a key of this name.
fn bytes(key: &str) -> String {
    let number = match key {
        "Enter" => return "\r".to_owned(),
        "Tab" => return "\t".to_owned(),
        "Space" => return " ".to_owned(),
        "Backspace" => return "\u{7f}".to_owned(),
        "Esc" => return ESCAPE.to_owned(),
        "Shift-Tab" => return "\u{1b}[Z".to_owned(),
        "F1" => return "\u{1b}OP".to_owned(),
        "Up" => "A",
        "Down" => "B",
        "Right" => "C",
        "Left" => "D",
        "Shift-Up" => "1;2A",
        "Shift-Down" => "1;2B",
        "Shift-Right" => "1;2C",
        "Shift-Left" => "1;2D",
        "Home" => "H",
        "End" => "F",
        "Ins" => "2~",
        "Del" => "3~",
        "PgUp" => "5~",
        "PgDn" => "6~",
        other => match other.strip_prefix("Ctrl-") {
            Some(letter) => return char::from(letter.as_bytes()[0] & 0x1f).to_string(),
            None if other.chars().count() == 1 => return other.to_owned(),
            None => panic!("a key that is not sent here: {other}"),
        },
    };
    format!("\u{1b}[{number}")
}

/// Every key of the guide's key table except those of some commands, as a terminal sends it.
fn keys_without(left_out: &[&str]) -> Vec<String> {
    let chapter = guide::find("keys").unwrap();
    let rows = chapter.markdown.lines().filter_map(|line| {
        let mut cells = line.strip_prefix("| `")?.split(" | ");
        Some((cells.next()?, cells.last()?))
    });
    let rows = rows.filter(|(_, name)| {
        !left_out
            .iter()
            .any(|out| name.contains(&format!("`{out}`")))
    });
    let names = rows.flat_map(|(keys, _)| keys.split(['`', ' ']).filter(|name| !name.is_empty()));
    // A bar is written as \| in a table, and a backtick is indistinguishable from the marks of code.
    let keys = names.map(|name| bytes(if name == "\\|" { "|" } else { name }));
    keys.chain(["`".to_owned()]).collect()
}

/// A key, or another input from a keyboard and a mouse.
fn roll(dice: &mut Dice, keys: &[String]) -> String {
    match dice.roll(40) {
        0..3 => format!("\u{15}{}\r", dice.pick(&TYPED)),
        3..6 => dice.roll(30).to_string(),
        6..10 => {
            // Press, drag, release, the wheel; also outside of the screen.
            let button = [0, 0, 1, 2, 32, 64, 65][dice.roll(7)];
            let end = ["M", "M", "m"][dice.roll(3)];
            format!(
                "\u{1b}[<{button};{};{}{end}",
                1 + dice.roll(90),
                1 + dice.roll(30)
            )
        }
        10 => dice.pick(&STRANGE).to_owned(),
        11 => char::from(dice.roll(128) as u8)
            .to_string()
            .replace(['\u{1b}', '\u{1a}', '\u{3}'], ""),
        _ => keys[dice.roll(keys.len())].clone(),
    }
}

fn play(seed: u64, keys: &[String]) {
    let home = Home::new();
    home.configure(CONFIGURATION);
    let text = home.preset(
        ["fig08", "fig13", "fig16", "fig05a"][seed as usize % 4],
        "beam.toml",
    );
    let mut dice = Dice(seed);
    let mut program = Program::start(&home, &["beam.toml"]);
    program.wait_for("solved");
    for _ in 0..BURSTS {
        let burst: String = (0..BURST).map(|_| roll(&mut dice, keys)).collect();
        program.press(&burst);
        program.settle();
        // The recovery file contains the model of a moment ago.
        for kept in home.recovery() {
            let kept = fs::read_to_string(kept).unwrap_or_else(|_| text.to_owned());
            assert_eq!(model::read(&kept).err(), None, "seed {seed}");
        }
    }
    program.press(&ESCAPE.repeat(4));
    program.press("9999u");
    program.wait("nothing to undo", |screen| {
        screen.contains("nothing to undo") && !screen.contains("· changed")
    });
    // F9.
    program.press("\u{1b}[20~\u{15}back.toml\r");
    program.wait_for("saved back.toml");
    assert_eq!(
        fs::read_to_string(home.file("back.toml")).unwrap(),
        text,
        "seed {seed}"
    );
    assert_eq!(
        fs::read_to_string(home.file("beam.toml")).unwrap(),
        text,
        "seed {seed}"
    );
    program.signal("TERM");
    assert_eq!(program.end(), 143, "seed {seed}");
    assert!(home.recovery().is_empty(), "seed {seed}");
    let report = fs::read_to_string(home.state("beamtune.log"));
    assert!(report.is_err(), "seed {seed} left a report: {report:?}");
}

/// Four batches of five seeds, side by side.
fn play_lot(lot: u64) {
    let keys = keys_without(&[
        "suspend", "end", "quit", "save", "save-as", "open", "presets", "palette",
    ]);
    for seed in lot * 5..lot * 5 + 5 {
        play(seed, &keys);
    }
}

#[test]
fn random_keys_break_nothing_1() {
    play_lot(0);
}

#[test]
fn random_keys_break_nothing_2() {
    play_lot(1);
}

#[test]
fn random_keys_break_nothing_3() {
    play_lot(2);
}

#[test]
fn random_keys_break_nothing_4() {
    play_lot(3);
}

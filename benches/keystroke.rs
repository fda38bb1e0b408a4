//! From a key to the picture: run with `cargo bench --bench keystroke`.
//!
//! The real program in a pseudo-terminal of 120 x 40, each preset and 1,000 subsystems at 2,000 frequencies: the time
//! from the key that nudges a parameter to the end of its first picture, compared with the time to draw the same screen
//! without solving (a repaint), and to the last picture. Then a held key: whether every press counts, and the time from
//! the last one to its picture. Names of presets, and `thousand`, select those to measure.

#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

#[allow(dead_code, reason = "shared with another bench")]
mod terminal;

use std::path::Path;
use std::time::{Duration, Instant};

use beamtune::presets;
use terminal::{Terminal, median, ms};

/// After this time without a byte, a key is handled.
const QUIET: Duration = Duration::from_millis(250);

/// The same for slow results: modes of many subsystems.
const SLOW: Duration = Duration::from_secs(3);

/// Number of timed nudges.
const NUDGES: usize = 15;

/// Presses of a held key.
const HELD: usize = 60;

/// The repeat rate of keyboards.
const REPEAT: Duration = Duration::from_millis(33);

fn main() {
    println!(
        "{:24} {:>9} {:>9} {:>7} {:>9} {:>6} {:>9}",
        "", "first ms", "drawn ms", "ratio", "last ms", "lost", "lag ms"
    );
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let is_wanted = |name: &str| {
        let mut names = asked
            .iter()
            .filter(|name| !name.starts_with('-'))
            .peekable();
        names.peek().is_none() || names.any(|wanted| wanted == name)
    };
    for preset in presets::ALL.iter().filter(|preset| is_wanted(preset.name)) {
        measure(preset.name, preset.name, "", QUIET);
    }
    if !is_wanted("thousand") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("thousand.toml");
    let text = std::fs::read_to_string("tests/data/thousand.toml").unwrap();
    std::fs::write(&path, text.replace("points = 1000", "points = 2000")).unwrap();
    let path = path.to_str().unwrap().to_owned();
    // The first parameter of a subsystem is its position, the second its mass.
    measure("1,000 subsystems, place", &path, "/n499\rl", SLOW);
    measure("1,000 subsystems, mass", &path, "/n499\rl\t", SLOW);
}

/// Measures a model, at the parameter that some keys select.
fn measure(name: &str, model: &str, keys: &str, quiet: Duration) {
    // A separate home folder each: nothing is remembered or recovered.
    let [home, other] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let mut terminal = opened(model, keys, home.path(), quiet);
    let (mut first, mut last, mut drawn) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..NUDGES {
        let start = Instant::now();
        terminal.send("+");
        let pictures = terminal.pictures(quiet);
        if let (Some(a), Some(b)) = (pictures.first(), pictures.last()) {
            first.push(ms(start, *a));
            last.push(ms(start, *b));
        }
        let start = Instant::now();
        terminal.send("\u{c}");
        if let Some(at) = terminal.picture(quiet) {
            drawn.push(ms(start, at));
        }
        terminal.pictures(QUIET);
    }
    let (lost, lag) = held(
        &mut terminal,
        opened(model, keys, other.path(), quiet),
        quiet,
    );
    terminal.end();
    let (first, last, drawn) = (median(&mut first), median(&mut last), median(&mut drawn));
    println!(
        "{name:24} {first:9.1} {drawn:9.1} {:7.2} {last:9.1} {lost:>6} {lag:9.1}",
        first / drawn
    );
}

/// The program with a model, at the parameter that some keys select.
fn opened(model: &str, keys: &str, home: &Path, quiet: Duration) -> Terminal {
    let program = env!("CARGO_BIN_EXE_beamtune");
    let mut terminal = Terminal::start(program, &[model.to_owned()], home);
    terminal.pictures(quiet);
    for keys in [keys, "\t"].into_iter().filter(|keys| !keys.is_empty()) {
        terminal.send(keys);
        terminal.pictures(quiet);
    }
    terminal
}

/// Whether presses of a held key were lost, and the time from the last press to the first picture after it, ms.
fn held(terminal: &mut Terminal, twin: Terminal, quiet: Duration) -> (&'static str, f64) {
    let mut at = Instant::now();
    for _ in 0..HELD {
        at = Instant::now();
        terminal.send("+");
        std::thread::sleep(REPEAT);
    }
    let mut seen = Vec::new();
    while let Some(picture) = terminal.picture(quiet) {
        seen.push((picture, tree(terminal)));
    }
    let up = tree(terminal);
    let lag = seen
        .iter()
        .find(|(_, shown)| *shown == up)
        .map_or(f64::NAN, |(picture, _)| ms(at, *picture));
    // Single presses from the same file give the same value.
    if up == one_by_one(twin, quiet) {
        ("none", lag)
    } else {
        ("some", lag)
    }
}

/// The tree of another run, in which each press is shown before the next.
fn one_by_one(mut twin: Terminal, quiet: Duration) -> Vec<String> {
    for _ in 0..NUDGES + HELD {
        twin.send("+");
        twin.picture(quiet);
    }
    twin.pictures(quiet);
    let shown = tree(&twin);
    twin.end();
    shown
}

/// The model's text in the tree.
fn tree(terminal: &Terminal) -> Vec<String> {
    let screen = terminal.screen.screen().contents();
    let left = |line: &str| line.chars().take(40).collect();
    screen.lines().map(left).collect()
}

//! From a key to the picture: run with `cargo bench --bench keystroke`.
//!
//! The real program in a pseudo-terminal of 120 x 40, each preset and 1,000 subsystems at 2,000 frequencies: how long
//! from the key that nudges a parameter to the end of the first picture of it, beside the time of drawing the same screen
//! with nothing to solve (a repaint), and to the last picture. Then a key that is held: whether every press counts, and
//! how long after the last one the picture is there.

#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

#[allow(dead_code, reason = "shared with another bench")]
mod terminal;

use std::time::{Duration, Instant};

use beamtune::presets;
use terminal::{Terminal, median, ms};

/// After this long without a byte a key has had its effect.
const QUIET: Duration = Duration::from_millis(400);

/// What may follow slowly: modes of many subsystems.
const SLOW: Duration = Duration::from_secs(3);

/// Nudges that are timed.
const NUDGES: usize = 15;

/// Presses of a key that is held.
const HELD: usize = 60;

/// As fast as keyboards repeat.
const REPEAT: Duration = Duration::from_millis(33);

fn main() {
    println!(
        "{:24} {:>9} {:>9} {:>7} {:>9} {:>6} {:>9}",
        "", "first ms", "drawn ms", "ratio", "last ms", "lost", "lag ms"
    );
    for preset in presets::ALL {
        measure(preset.name, preset.name, "", QUIET);
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("thousand.toml");
    let text = std::fs::read_to_string("tests/data/thousand.toml").unwrap();
    std::fs::write(&path, text.replace("points = 1000", "points = 2000")).unwrap();
    // The mass of the fifth subsystem.
    let path = path.to_str().unwrap().to_owned();
    measure("1,000 subsystems", &path, "/n500\rl", SLOW);
}

/// Measures a model, at the parameter that some keys lead to.
fn measure(name: &str, model: &str, keys: &str, quiet: Duration) {
    let home = tempfile::tempdir().unwrap();
    let arguments = [model.to_owned()];
    let program = env!("CARGO_BIN_EXE_beamtune");
    let mut terminal = Terminal::start(program, &arguments, home.path());
    terminal.pictures(quiet);
    terminal.send(keys);
    terminal.pictures(quiet);
    terminal.send("\t");
    terminal.pictures(quiet);
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
    let (lost, lag) = held(&mut terminal, quiet);
    terminal.end();
    let (first, last, drawn) = (median(&mut first), median(&mut last), median(&mut drawn));
    println!(
        "{name:24} {first:9.1} {drawn:9.1} {:7.2} {last:9.1} {lost:>6} {lag:9.1}",
        first / drawn
    );
}

/// Whether presses of a held key were lost, and the time from the last press to the first picture after it, ms.
fn held(terminal: &mut Terminal, quiet: Duration) -> (&'static str, f64) {
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
    // As many down, one by one, lead back, and as many up at once lead here again.
    for _ in 0..HELD {
        terminal.send("-");
        terminal.picture(quiet);
    }
    terminal.pictures(quiet);
    terminal.send(&"+".repeat(HELD));
    terminal.pictures(quiet);
    if tree(terminal) == up {
        ("none", lag)
    } else {
        ("some", lag)
    }
}

/// What the tree of the model shows.
fn tree(terminal: &Terminal) -> Vec<String> {
    let screen = terminal.screen.screen().contents();
    let left = |line: &str| line.chars().take(40).collect();
    screen.lines().map(left).collect()
}

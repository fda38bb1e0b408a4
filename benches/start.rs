//! From the start of the process to the first curve: run with `cargo bench --bench start`.
//!
//! The real program in a pseudo-terminal of 120 x 40 with fig05a, compared with `true` started in the same way, and
//! with the time to draw the same screen. Also its size and its dependencies.

#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

#[allow(dead_code, reason = "shared with another bench")]
mod terminal;

use std::time::{Duration, Instant};

use terminal::{Terminal, median, ms};

/// After this time without a byte, everything is drawn.
const QUIET: Duration = Duration::from_millis(300);

/// Number of starts each.
const STARTS: usize = 25;

fn main() {
    let home = tempfile::tempdir().unwrap();
    let program = env!("CARGO_BIN_EXE_beamtune");
    let (mut nothing, mut first, mut curve, mut drawn) = (vec![], vec![], vec![], vec![]);
    for _ in 0..STARTS {
        let start = Instant::now();
        let ended = Terminal::start("true", &[], home.path()).ended();
        nothing.push(ms(start, ended));
        let start = Instant::now();
        let mut terminal = Terminal::start(program, &["fig05a".to_owned()], home.path());
        let mut shown = false;
        while let Some(at) = terminal.picture(QUIET) {
            if first.len() == curve.len() && !shown {
                first.push(ms(start, at));
            }
            // Curves are drawn with braille dots.
            let screen = terminal.screen.screen().contents();
            let dots = screen
                .chars()
                .filter(|c| ('\u{2801}'..='\u{28ff}').contains(c));
            if !shown && dots.count() > 50 {
                curve.push(ms(start, at));
                shown = true;
            }
        }
        let start = Instant::now();
        terminal.send("\u{c}");
        drawn.extend(terminal.picture(QUIET).map(|at| ms(start, at)));
        terminal.end();
    }
    let [nothing, first, curve, drawn] =
        [&mut nothing, &mut first, &mut curve, &mut drawn].map(|times| median(times));
    println!("true: {nothing:.1} ms; drawing: {drawn:.1} ms");
    println!("first picture: {first:.1} ms; first curve: {curve:.1} ms");
    println!(
        "first curve less the drawing: {:.1} times `true`",
        (curve - drawn) / nothing
    );
    let bytes = std::fs::metadata(program).unwrap().len();
    let lock = std::fs::read_to_string("Cargo.lock").unwrap();
    let manifest = std::fs::read_to_string("Cargo.toml").unwrap();
    let direct = manifest
        .split("[dev-dependencies]")
        .next()
        .and_then(|text| text.split("[dependencies]").nth(1))
        .map_or(0, |text| {
            text.lines().filter(|line| line.contains('=')).count()
        });
    println!(
        "binary: {:.1} MB; {direct} dependencies, {} packages in the lock file with those of the tests",
        bytes as f64 * 1e-6,
        lock.matches("[[package]]").count()
    );
}

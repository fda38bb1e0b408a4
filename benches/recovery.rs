//! From a key that edits to its edit in the recovery file: run with `cargo bench --bench recovery`.
//!
//! The real program in a pseudo-terminal of 120 x 40 with 1, 1,000 and 10,000 subsystems, while the key that nudges the
//! mass of one of them is held.

#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

#[allow(dead_code, reason = "shared with another bench")]
mod terminal;

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

use beamtune::{model, presets};
use terminal::{Terminal, median, ms};

/// After this long without a byte the model is shown and solved.
const QUIET: Duration = Duration::from_secs(2);

/// As fast as keyboards repeat.
const REPEAT: Duration = Duration::from_millis(33);

/// Presses of the key.
const EDITS: usize = 60;

/// An edit that is not in the file by then is lost.
const LOST: Duration = Duration::from_secs(30);

fn main() {
    println!(
        "{:>10} {:>9} {:>9} {:>9}",
        "subsystems", "first ms", "median ms", "worst ms"
    );
    for count in [1, 1000, 10_000] {
        let home = tempfile::tempdir().unwrap();
        let model = written(home.path(), count);
        let mut times = held(&model, home.path());
        let first = times[0];
        let median = median(&mut times);
        let worst = times[EDITS - 1];
        println!("{count:10} {first:9.1} {median:9.1} {worst:9.1}");
    }
}

/// A file of fig05a with this many of its first subsystem, evenly along the beam.
fn written(folder: &Path, count: usize) -> PathBuf {
    let preset = presets::find("fig05a").unwrap();
    let mut model = model::read(preset.text).unwrap().into_inner();
    let first = model.subsystems[0].clone();
    let step = model.beam.length / (count + 1) as f64;
    model.subsystems = (1..=count)
        .map(|number| {
            let mut one = first.clone();
            one.name = format!("n{number}");
            one.position = step * number as f64;
            one
        })
        .collect();
    model.studies.clear();
    model.sweep.points = 100;
    let path = folder.join("model.toml");
    std::fs::write(&path, model::write(&model, "")).unwrap();
    path
}

/// From each press of the key to a changed recovery file, ms.
fn held(model: &Path, home: &Path) -> Vec<f64> {
    let program = env!("CARGO_BIN_EXE_beamtune");
    let mut terminal = Terminal::start(program, &[model.to_str().unwrap().to_owned()], home);
    terminal.pictures(QUIET);
    // The first parameter of a subsystem is its place, the second its mass.
    for keys in ["/n1\rl", "\t\t"] {
        terminal.send(keys);
        terminal.pictures(QUIET);
    }
    let folder = home.join(".local/state/beamtune/recovery");
    let mut times = Vec::new();
    let mut due = Instant::now();
    for _ in 0..EDITS {
        std::thread::sleep(due.saturating_duration_since(Instant::now()));
        due += REPEAT;
        let before = stamp(&folder);
        let start = Instant::now();
        terminal.send("+");
        while stamp(&folder) == before {
            assert!(start.elapsed() < LOST, "no edit in the recovery file");
            std::thread::sleep(Duration::from_micros(100));
        }
        times.push(ms(start, Instant::now()));
    }
    terminal.end();
    times
}

/// The recovery file's length and time of change.
fn stamp(folder: &Path) -> Option<(u64, SystemTime)> {
    let entries = std::fs::read_dir(folder).ok()?.flatten();
    let mut files = entries.filter(|one| one.path().extension().is_some_and(|end| end == "toml"));
    let found = files.next()?.metadata().ok()?;
    Some((found.len(), found.modified().ok()?))
}

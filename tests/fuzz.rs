//! A short run, the same every time, of what the fuzz targets in `fuzz/` look for without end: files of this
//! repository and typed values, spoilt by chance.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "fuzz/dice.rs"]
mod dice;
#[path = "fuzz/mutate.rs"]
mod mutate;
#[path = "../fuzz/properties.rs"]
mod properties;

use std::fs;
use std::path::Path;

use dice::Dice;

/// Every TOML file in a folder of the repository, in the order of their names.
fn texts(folder: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = fs::read_dir(&folder).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    assert!(!paths.is_empty(), "no models in {}", folder.display());
    let read = |path| fs::read_to_string(path).unwrap();
    paths.into_iter().map(read).collect()
}

/// What fuzzing has found once, and what is like it.
#[test]
fn what_was_found_before_stays_mended() {
    for text in texts("tests/fuzz") {
        properties::model_file(&text);
    }
    for (old, text) in FOUND {
        for unit in 0..=u8::MAX {
            properties::value(usize::from(unit), *old, text);
        }
    }
}

/// Typed values that fuzzing has stumbled over, or might have.
const FOUND: &[(f64, &str)] = &[
    (0.0, ""),
    (-0.0, "-0"),
    (5e-324, "5e-324"),
    (f64::MIN_POSITIVE, "/3"),
    (f64::MAX, "*1.0000000000000002"),
    (-f64::MAX, "-100%"),
    (1.0, "1e-9223372036854775808"),
    (1.0, "1e9223372036854775807G"),
    (1.0, "9007199254740993"),
    (1.0, "subsystems.*.*.stiffness"),
    (1.0, "subsystems.\"S1.mass"),
    (1.0, "subsystems.'S1'.mass"),
    (1.0, "forces.0.amplitude"),
    (1.0, "forces.18446744073709551616.amplitude"),
    (1.0, "beam..length"),
    (1.0, "\u{b5}\u{b2}\u{2212}\u{feff}\0"),
];

#[test]
fn spoilt_model_files_are_refused_or_go_out_and_in_again() {
    let seeds: Vec<String> = ["presets", "tests/invalid", "tests/literature"]
        .into_iter()
        .flat_map(texts)
        .collect();
    let mut dice = Dice(1);
    let mut models = 0;
    for turn in 0..FILES {
        let text = mutate::file(&seeds, turn, &mut dice);
        models += usize::from(properties::model_file(&text));
    }
    // Were every text refused, writing would not have been tried; were none, reading would not.
    assert!(
        (FILES / 20..FILES * 19 / 20).contains(&models),
        "{models} of {FILES} are models"
    );
}

/// How many spoilt files are read.
const FILES: usize = 20_000;

#[test]
fn whatever_is_typed_gives_a_finite_number_or_is_refused() {
    let mut dice = Dice(2);
    for unit in 0..VALUES {
        let old = mutate::number(&mut dice);
        let text = mutate::typed(&mut dice);
        properties::value(unit, old, &text);
    }
}

/// How many values are typed.
const VALUES: usize = 100_000;

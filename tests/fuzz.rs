//! A short run, the same every time, of what the fuzz targets in `fuzz/` run without end: files of this repository and
//! typed values, randomly damaged.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "../fuzz/curves.rs"]
mod curves;
#[path = "fuzz/dice.rs"]
mod dice;
#[path = "fuzz/mutate.rs"]
mod mutate;
#[path = "../fuzz/properties.rs"]
mod properties;
#[path = "fuzz/spoil.rs"]
mod spoil;

use std::fs;
use std::path::Path;

use dice::Dice;

/// Every TOML file in a folder of the repository, sorted by name.
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

/// Cases that fuzzing has found, and similar ones.
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

/// Typed values that fuzzing has found, or similar ones.
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
    let mut seeds: Vec<String> = ["presets", "tests/invalid", "tests/literature"]
        .into_iter()
        .flat_map(texts)
        .collect();
    // Most of them have no tuning, or a small one.
    seeds.extend(std::iter::repeat_n(
        include_str!("data/tuned.toml").to_owned(),
        10,
    ));
    let mut dice = Dice(1);
    let mut models = 0;
    for turn in 0..FILES {
        let text = mutate::file(&seeds, turn, &mut dice);
        models += usize::from(properties::model_file(&text));
    }
    // If every text were refused, writing would not be tested; if none were, reading would not.
    assert!(
        (FILES / 20..FILES * 19 / 20).contains(&models),
        "{models} of {FILES} are models"
    );
}

/// Number of damaged files to read.
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

/// Number of typed values.
const VALUES: usize = 100_000;

/// Files with an extension in the folder of measured curves, sorted by name, and more.
fn measured(ending: &str, more: &[&str]) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/measured");
    let entries = fs::read_dir(&folder).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|found| found == ending));
    paths.sort();
    assert!(!paths.is_empty(), "no {ending} in {}", folder.display());
    // The first kilobytes contain every feature.
    let read = |path| {
        let mut bytes = fs::read(path).unwrap();
        bytes.truncate(4096);
        bytes
    };
    let more = more.iter().map(|text| text.as_bytes().to_vec());
    paths.into_iter().map(read).chain(more).collect()
}

/// Small tables of all kinds.
const TABLES: &[&str] = &[
    "frequency_hz,P1 w.re,P1 w.im,E_V\n1.0,1e-9,-2e-9,3.0\n2.0,1e-8,-2e-8,4.0\n3.5,1e-7,-2e-7,5.0\n",
    "curve,frequency_hz,w.re,w.im\n0.5,1.0,1.0,2.0\n0.5,2.0,3.0,4.0\nsoft,1.0,5.0,6.0\nsoft,2.0,7.0,8.0\n",
    "f [kHz];Magnitude [g/N];Phase [deg]\r\n0,01;1,5;-90\r\n0,02;2,5;-95\r\n0,03;2,25;-170\r\n",
    "# made by hand\n# omega[rad/s] H[dB] phase[rad]\n 10  -20  0.1\n 20  -21.5  -0.2\n 30 -25 -3.1\n",
    "Frequency\tReal\tImag\tCoherence\nHz\tm/s2/N\tm/s2/N\t-\n0\t0\t0\t0\n1\t2\t3\t1\n2\t3\t4\t1\n",
    "10 1.5 -0.25\n20 -2D-3 4.\n40.5 0 -7.125\n",
    ",freq_hz,H\n0,10,(1.5-0.25j)\n1,20,(-2e-3+4j)\n2,40.5,-7.125j\n",
    "* Excitation frequency (Hz) Real Imag\n10 1.5 - 0.25i 3\n20 -2e-3 + 4i 3\nsaved today\n",
    "Frequency [Hz],Mag [m/N],-Phase [deg],Status\n10,1.5,20,OK\n20,2.5,30,OK\n30,2.25,40,OVL\n",
];

#[test]
fn spoilt_tables_are_refused_or_go_out_and_in_again() {
    spoilt(&measured("csv", TABLES), 3, "run 7.csv");
}

#[test]
fn spoilt_universal_files_are_refused_or_go_out_and_in_again() {
    spoilt(&measured("uff", &[]), 4, "run 7.uff");
}

fn spoilt(seeds: &[Vec<u8>], dice: u64, name: &str) {
    let mut dice = Dice(dice);
    let mut read = 0;
    for turn in 0..FILES {
        let bytes = spoil::file(seeds, turn, &mut dice);
        read += usize::from(curves::file(&bytes, dice.roll(12), name));
    }
    // If every file were refused, writing would not be tested; if none were, reading would not.
    assert!(
        (FILES / 20..FILES * 19 / 20).contains(&read),
        "{read} of {FILES} are curves"
    );
}

#[test]
fn whatever_is_said_of_a_table_is_a_layout_or_is_refused() {
    const PARTS: &[&str] = &[
        "hz", "khz", "rad/s", "rpm", "; ", ";", "re im", "mag", "dB", "deg", "rad", "m", "mm", "g",
        "N", "/", "(", ")", " ", "s2", "s", "-1", "2", "kg", "1e-6 ", "?", "\u{b5}m", "\u{b2}",
        "\u{b7}", "nonsense", "Nm", "kN", "1", "-im", "im", "re", " 2", " 3", "0",
    ];
    let mut dice = Dice(5);
    for _ in 0..VALUES {
        let text: String = (0..=dice.roll(9)).map(|_| dice.pick(PARTS)).collect();
        curves::layout(&text);
    }
}

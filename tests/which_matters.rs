//! `beamtune sensitivities` and `beamtune spread`.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::collections::HashMap;

use assert_cmd::Command;
use beamtune::model;
use beamtune::presets;

fn beamtune(arguments: &[&str]) -> (String, String, i32) {
    let output = Command::cargo_bin("beamtune")
        .unwrap()
        .args(arguments)
        .output()
        .unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (
        text(output.stdout),
        text(output.stderr),
        output.status.code().unwrap(),
    )
}

/// The rows of a table by their first cells, and the heading.
fn table(text: &str) -> (Vec<&str>, Vec<Vec<&str>>) {
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    (lines.next().unwrap(), lines.collect())
}

#[test]
fn sensitivities_are_sorted_and_those_of_a_mode_obey_scaling() {
    let (out, _, code) = beamtune(&["sensitivities", "cantilever", "--mode", "2"]);
    assert_eq!(code, 0);
    let (heading, rows) = table(&out);
    assert_eq!(
        heading,
        [
            "parameter",
            "value",
            "level_db",
            "frequency_hz",
            "damping_ratio"
        ]
    );
    let effect: HashMap<&str, f64> = rows
        .iter()
        .map(|row| (row[0], row[3].parse().unwrap()))
        .collect();
    let sizes: Vec<f64> = rows
        .iter()
        .map(|row| row[3].parse::<f64>().unwrap().abs())
        .collect();
    assert!(sizes.is_sorted_by(|a, b| a >= b));
    // Closed form: if all stiffnesses, dampers and masses are multiplied by the same factor, a frequency does not
    // change (Euler's theorem on homogeneous functions).
    let scaled = |path: &&str| {
        let last = path.rsplit('.').next().unwrap();
        [
            "stiffness",
            "damping",
            "mass",
            "inertia",
            "young_modulus",
            "shear_modulus",
            "density",
        ]
        .contains(&last)
    };
    let sum: f64 = effect
        .iter()
        .filter(|(path, _)| scaled(path))
        .map(|(_, effect)| effect)
        .sum();
    assert!(sum.abs() < 1e-9 * sizes[0], "{sum}");
    let out = beamtune(&["modes", "cantilever"]).0;
    let (_, modes) = table(&out);
    // Closed form: if stiffness-like parameters double, the frequency is sqrt(2) times higher; here without the
    // dampers, which have little effect: half the frequency in all.
    let stiff = |path: &&str| {
        ["stiffness", "young_modulus", "shear_modulus"].contains(&path.rsplit('.').next().unwrap())
    };
    let sum: f64 = effect
        .iter()
        .filter(|(path, _)| stiff(path))
        .map(|(_, effect)| effect)
        .sum();
    let frequency: f64 = modes[1][1].parse().unwrap();
    assert!(
        (sum / (0.5 * frequency) - 1.0).abs() < 0.02,
        "{sum} of {frequency}"
    );
}

#[test]
fn each_figure_fills_its_columns() {
    for (of, filled) in [
        (["--at", "20"], [true, false, false]),
        (["--peak", "30"], [true, true, false]),
        (["--mode", "1"], [false, true, true]),
        (["--band", "10,50"], [true, false, false]),
    ] {
        let arguments = [&["sensitivities", "cantilever"], &of[..]].concat();
        let (out, _, code) = beamtune(&arguments);
        assert_eq!(code, 0);
        let (_, rows) = table(&out);
        assert!(rows.len() > 20);
        for row in rows {
            let cells = [2, 3, 4].map(|column: usize| !row[column].is_empty());
            assert_eq!(cells, filled, "{of:?} {row:?}");
        }
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let two = |arguments: &[&str], word: &str| {
        let (_, error, code) = beamtune(&[&["sensitivities", "cantilever"], arguments].concat());
        assert_eq!(code, 2, "{error}");
        assert!(error.contains("error: ") && error.contains(word), "{error}");
    };
    two(&[], "--at");
    two(&["--at", "20", "--mode", "1"], "cannot be used with");
    two(&["--at=-1"], "above 0");
    two(&["--band", "50,10"], "from a lower to a higher");
    two(&["--mode", "999"], "from 1 to");
    two(&["--at", "20", "--response", "tip"], "must be one of tip w");
}

#[test]
fn a_spread_is_in_order_and_the_same_for_a_seed() {
    let folder = tempfile::tempdir().unwrap();
    let text = presets::find("cantilever").unwrap().text;
    let mut model = model::read(text).unwrap().into_inner();
    model.tune.as_mut().unwrap().variables[0].tolerance = 10.0;
    let file = folder.path().join("with_tolerance.toml");
    std::fs::write(&file, model::write(&model, text)).unwrap();
    let file = file.to_str().unwrap();
    let arguments = ["spread", file, "--at", "5,25,35", "--samples", "200"];
    let (out, error, code) = beamtune(&arguments);
    assert_eq!((error.as_str(), code), ("", 0));
    let (heading, rows) = table(&out);
    assert_eq!(
        heading[..4],
        ["frequency_hz", "tip w.p5", "tip w.p50", "tip w.p95"]
    );
    assert_eq!(rows.len(), 3);
    for row in &rows {
        let numbers: Vec<f64> = row.iter().map(|cell| cell.parse().unwrap()).collect();
        for quantiles in numbers[1..].chunks(3) {
            assert!(quantiles.is_sorted(), "{row:?}");
        }
    }
    assert_eq!(beamtune(&arguments).0, out);
    assert_ne!(
        beamtune(&[&arguments[..], &["--seed", "2"]].concat()).0,
        out
    );
    let (_, error, code) = beamtune(&["spread", "cantilever"]);
    assert_eq!(code, 2);
    assert!(
        error.contains("no variable of [tune] has a tolerance"),
        "{error}"
    );
}

#[test]
fn empty_cells_say_why() {
    // The numbers there exceed the range of the arithmetic.
    let (out, errors, code) = beamtune(&["sensitivities", "cantilever", "--at", "1e308"]);
    assert_eq!(code, 0);
    assert!(table(&out).1.iter().all(|row| row[2].is_empty()));
    assert!(
        errors.starts_with("warning: ")
            && errors.contains("the response is not finite at 1e308 Hz"),
        "{errors}"
    );
    let (_, errors, _) = beamtune(&["sensitivities", "cantilever", "--at", "20"]);
    assert_eq!(errors, "");
}

#[test]
fn a_band_with_too_many_modes_is_refused_before_any_is_looked_for() {
    let (_, errors, code) = beamtune(&["sensitivities", "fig05a", "--band", "1,1e300"]);
    assert_eq!(code, 2);
    assert!(errors.contains("more than 10000 modes below"), "{errors}");
}

//! Every response against a high-precision solution of the state equation.
//!
//! Expected values: `tests/data/*.json`, computed by ball arithmetic of 600 bits and more as `tests/data/README.md`
//! describes; every digit is correct. The tolerance is what the program promises: 1e-8 from 0.5 Hz to 20 kHz,
//! 1e-10 below, plus the effect of rounding the frequency.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "common/checked.rs"]
mod checked;

use checked::checked;
use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use beamtune::{model, solve};
use num_complex::Complex64;
use serde::Deserialize;

/// Answers by frequency in Hz and name of the response.
type Table<T> = BTreeMap<String, BTreeMap<String, T>>;

#[derive(Deserialize)]
struct Case {
    name: String,
    model: Option<String>,
    model_file: Option<String>,
    answers: Table<[f64; 2]>,
    /// |d ln H / d ln f|.
    sensitivity: Table<f64>,
}

impl Case {
    fn text(&self) -> String {
        match (&self.model, &self.model_file) {
            (Some(text), _) => text.clone(),
            (None, Some(file)) => std::fs::read_to_string(format!("tests/data/{file}")).unwrap(),
            (None, None) => panic!("{}: no model", self.name),
        }
    }

    /// The largest relative error, with its location; fails if one exceeds its tolerance.
    fn worst_error(&self) -> (f64, String) {
        let model = model::read(&self.text()).unwrap().into_inner();
        let mut worst = (0.0, String::new());
        for (hertz, answers) in &self.answers {
            let frequencies = [hertz.parse::<f64>().unwrap()];
            let frf =
                solve::sweep(&checked(&model), &frequencies, &AtomicBool::new(false)).unwrap();
            for (name, &[re, im]) in answers {
                let column = frf
                    .columns
                    .iter()
                    .find(|column| &column.name == name)
                    .unwrap();
                let expected = Complex64::new(re, im);
                let error = (column.values[0] - expected).norm() / expected.norm();
                let floor = if frequencies[0] < 0.5 { 1e-10 } else { 1e-8 };
                let tolerance = floor + 64.0 * f64::EPSILON * self.sensitivity[hertz][name];
                let place = format!("{} at {hertz} Hz, {name}", self.name);
                assert!(
                    error <= tolerance,
                    "{place}: {error:.1e}, got {} for {expected}",
                    column.values[0]
                );
                if error > worst.0 {
                    worst = (error, place);
                }
            }
        }
        worst
    }
}

/// Checks every case of a file; `cargo test -- --nocapture` prints the table of the largest errors.
fn hold(file: &str) {
    let text = std::fs::read_to_string(format!("tests/data/{file}")).unwrap();
    let cases: Vec<Case> = serde_json::from_str(&text).unwrap();
    assert!(!cases.is_empty());
    for case in cases {
        let (error, place) = case.worst_error();
        println!("{error:.1e}  {place}");
    }
}

#[test]
fn the_papers_beam_from_half_a_hertz_to_15_khz() {
    hold("paper_beam.json");
}

#[test]
fn other_supports_loads_and_subsystems_up_to_a_thousand() {
    hold("high_precision.json");
}

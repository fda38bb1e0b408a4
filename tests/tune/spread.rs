//! Quantiles over tolerances against the closed form of a uniform variable.

use crate::checked::checked;
use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use beamtune::model::{Hold, Model, Tune, Variable};
use beamtune::solve::Cancelled;
use beamtune::tune::{Spread, spread};

use crate::absorber::{self, MASS};

const SAMPLES: usize = 2000;
/// Hz; the beam resonates at 18 Hz.
const FREQUENCIES: [f64; 3] = [1.0, 3.0, 6.0];
/// Relative.
const TOLERANCE: f64 = 0.1;
/// One of both springs, N/m.
const SPRING: f64 = 5e5;

/// The beam on its springs alone, both with a tolerance.
fn on_springs() -> (Model, Tune) {
    let mut model =
        absorber::model(r#"objective = { minimise = "energy", from = 5.0, to = 60.0 }"#);
    model.subsystems.clear();
    let sides = ["left", "right"];
    let tune = Tune {
        variables: vec![Variable {
            paths: sides
                .map(|side| format!("supports.{side}.w.stiffness").into())
                .to_vec(),
            hold: Hold::Equal,
            min: 1e5,
            max: 1e7,
            scale: None,
            tolerance: 100.0 * TOLERANCE,
        }],
        ..model.tune.take().unwrap()
    };
    (model, tune)
}

fn quantiles(seed: u64) -> Spread {
    let (model, tune) = on_springs();
    let never = AtomicBool::new(false);
    let found = spread(
        &checked(&model),
        &tune,
        (SAMPLES, seed),
        &FREQUENCIES,
        &never,
    );
    found.unwrap().unwrap().remove(0)
}

/// Closed form: |H| = 1 / (2 k - M w^2) falls with k, so that its quantile p is |H| at the quantile 1 - p of k, which
/// is uniform. The share of models below a sample quantile has the standard error sqrt(p (1 - p) / n) (David &
/// Nagaraja, Order Statistics, 2003, 2.5); the tolerance is four of them.
#[test]
fn quantiles_are_those_of_a_uniform_spring() {
    for seed in 1..=3 {
        let found = quantiles(seed);
        assert_eq!(found.name, "w");
        let all = [
            (0.05, &found.low),
            (0.5, &found.median),
            (0.95, &found.high),
        ];
        for (share, sizes) in all {
            let error: f64 = 4.0 * (share * (1.0 - share) / SAMPLES as f64).sqrt();
            for (frequency, size) in FREQUENCIES.iter().zip(sizes) {
                let spring = 0.5 * (size.recip() + MASS * (TAU * frequency).powi(2));
                let above = 0.5 * (1.0 + (spring / SPRING - 1.0) / TOLERANCE);
                let off = 1.0 - above - share;
                assert!(off.abs() < error, "{seed} {share} {frequency}: {off}");
            }
        }
    }
}

/// Expected: the same to the last bit for the same seed on any number of threads, and different for another seed.
#[test]
fn a_seed_gives_one_result() {
    let found = quantiles(7);
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    assert_eq!(found, alone.unwrap().install(|| quantiles(7)));
    assert_ne!(found, quantiles(8));
}

/// Expected: without tolerances every model is the given one, whose |H| is the closed form at its own springs.
#[test]
fn without_tolerances_nothing_is_spread() {
    let (model, mut tune) = on_springs();
    tune.variables[0].tolerance = 0.0;
    let never = AtomicBool::new(false);
    let found = spread(&checked(&model), &tune, (5, 1), &FREQUENCIES, &never);
    let found = found.unwrap().unwrap().remove(0);
    assert_eq!(found.low, found.high);
    for (frequency, size) in FREQUENCIES.iter().zip(&found.median) {
        let closed = (2.0 * SPRING - MASS * (TAU * frequency).powi(2)).recip();
        assert!((size / closed - 1.0).abs() < 1e-6, "{size:e} {closed:e}");
    }
}

/// Expected: no result if cancelled.
#[test]
fn a_cancelled_spread_is_none() {
    let (model, tune) = on_springs();
    let found = spread(
        &checked(&model),
        &tune,
        (5, 1),
        &FREQUENCIES,
        &AtomicBool::new(true),
    );
    assert_eq!(found, Ok(Err(Cancelled)));
}

/// Closed form: `I_0` = 2e-4 m4 less 45 % and `A z_c^2` = 1e-4 m4 more 60 % are valid alone but not together.
#[test]
fn tolerances_that_are_impossible_together_are_refused() {
    let (mut model, mut tune) = on_springs();
    model.beam.section.polar_moment = 2e-4;
    model.beam.section.centroid_offset = 0.1;
    let one = |path: &str, tolerance| Variable {
        paths: vec![format!("beam.section.{path}").into()],
        tolerance,
        ..tune.variables[0].clone()
    };
    tune.variables = vec![one("area", 60.0), one("polar_moment", 45.0)];
    let fault = spread(
        &checked(&model),
        &tune,
        (200, 1),
        &FREQUENCIES,
        &AtomicBool::new(false),
    )
    .unwrap_err();
    assert_eq!(fault.path, "tune");
    assert!(
        fault.message.contains("beam.section.polar_moment"),
        "{fault}"
    );
    tune.variables.pop();
    let found = spread(
        &checked(&model),
        &tune,
        (200, 1),
        &FREQUENCIES,
        &AtomicBool::new(false),
    );
    assert!(found.unwrap().is_ok());
}

//! Three absorbers on fig05a, tuned by the search and by a basic global method with ten times the evaluations: run with
//! `cargo bench --bench absorbers`. It takes minutes, and fails if the basic method finds a better result.

#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

#[path = "../tests/common/checked.rs"]
mod checked;

use checked::checked;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use beamtune::model::{self, Aim, Combine, Hold, Model, Objective, Tune, Variable, edit};
use beamtune::presets;
use beamtune::solve::band::levels;
use beamtune::solve::modes::modes;
use beamtune::tune::{Options, Problem, default_budget, run};
use fastrand::Rng;
use rayon::prelude::*;

static NEVER: AtomicBool = AtomicBool::new(false);

/// The response and its band, Hz.
const RESPONSE: &str = "P5 w";
const BAND: [f64; 2] = [1.0, 400.0];

/// Restarts of the basic method.
const RESTARTS: usize = 20;

/// The springs of each absorber are equal, and so are its dampers; the objective is the highest peak of the right end
/// below 400 Hz.
fn model() -> Model {
    let mut model = model::read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    for response in &mut model.responses {
        response.enabled = response.name == RESPONSE;
    }
    let springs = ["y_left", "y_right", "z_left", "z_right"];
    let mut variables = Vec::new();
    for name in ["S1", "S2", "S3"] {
        for (key, min, max) in [("stiffness", 1e5, 1e9), ("damping", 1.0, 1e5)] {
            variables.push(Variable {
                paths: springs
                    .map(|spring| format!("subsystems.{name}.{spring}.{key}").into())
                    .to_vec(),
                hold: Hold::Equal,
                min,
                max,
                scale: None,
                tolerance: 0.0,
            });
        }
    }
    model.tune = Some(Tune {
        variables,
        objectives: vec![Objective {
            aim: Aim::Peak,
            response: Some(RESPONSE.to_owned()),
            from: BAND[0],
            to: BAND[1],
            weight: 1.0,
        }],
        combine: Combine::Sum,
        limits: Vec::new(),
    });
    model
}

/// The highest magnitude in the band, m, of the model at a point of the unit box; each variable by its logarithm.
fn highest_peak(problem: &Problem, x: &[f64]) -> f64 {
    let mut model = Model::clone(problem.model());
    for (variable, x) in problem.tune().variables.iter().zip(x) {
        let value = variable.min * (variable.max / variable.min).powf(*x);
        for path in &variable.paths {
            edit::set(&mut model, path, edit::Value::Number(value)).unwrap();
        }
    }
    let model = checked(&model);
    let modes = modes(&model, BAND[1], &NEVER).unwrap();
    levels(&model, &modes, BAND, &NEVER).unwrap()[0].maximum
}

/// Differential evolution, rand/1/bin with F = 0.7 and CR = 0.9 (Storn & Price, J. Global Optim. 1997, 11, 341), from random
/// points; the least highest peak, m.
fn plain(problem: &Problem, evaluations: usize, seed: u64) -> f64 {
    let n = problem.variables();
    let size = 10 * n;
    let mut random = Rng::with_seed(seed);
    let mut points: Vec<Vec<f64>> = (0..size)
        .map(|_| (0..n).map(|_| random.f64()).collect())
        .collect();
    let goals = |points: &[Vec<f64>]| -> Vec<f64> {
        let all = points.par_iter();
        all.map(|x| highest_peak(problem, x)).collect()
    };
    let mut known = goals(&points);
    for _ in 1..evaluations / size {
        let mut pick = || random.usize(..size);
        let trials: Vec<Vec<f64>> = (0..size)
            .map(|i| {
                let (a, b, c) = (pick(), pick(), pick());
                let always = pick() % n;
                (0..n)
                    .map(|j| {
                        let moved = points[a][j] + 0.7 * (points[b][j] - points[c][j]);
                        let crosses = j == always || pick() * 10 < 9 * size;
                        if crosses {
                            moved.clamp(0.0, 1.0)
                        } else {
                            points[i][j]
                        }
                    })
                    .collect()
            })
            .collect();
        for (i, (candidate, goal)) in trials.iter().zip(goals(&trials)).enumerate() {
            if goal <= known[i] {
                (points[i], known[i]) = (candidate.clone(), goal);
            }
        }
    }
    known.into_iter().fold(f64::INFINITY, f64::min)
}

fn main() {
    let model = model();
    let problem = Problem::new(&checked(&model), Path::new("")).unwrap();
    let budget = default_budget(problem.variables());
    let start = Instant::now();
    let options = Options {
        seed: 1,
        budget: Some(budget),
    };
    let tuned = run(&problem, &options, &NEVER, &mut |_| {}).unwrap();
    let ours = tuned.after[0].figure;
    println!(
        "as given {:.4e} m; search: {ours:.6e} m, {} evaluations, {} in {:.0} s",
        tuned.before[0].figure,
        tuned.evaluations,
        tuned.stop,
        start.elapsed().as_secs_f64()
    );
    let start = Instant::now();
    let mut best = f64::INFINITY;
    for seed in 1..=RESTARTS {
        let peak = plain(&problem, 10 * budget / RESTARTS, seed as u64);
        best = best.min(peak);
        println!("plain, restart {seed}: best so far {best:.6e} m");
    }
    println!(
        "plain: {best:.6e} m, {} evaluations in {:.0} s; the search lies {:+.3} % from it",
        10 * budget,
        start.elapsed().as_secs_f64(),
        100.0 * (ours / best - 1.0)
    );
    assert!(ours <= best * (1.0 + 1e-9), "the plain method finds more");
}

//! Evaluations of the search: run with `cargo bench --bench tune`.

#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

#[path = "../tests/common/checked.rs"]
mod checked;

use checked::checked;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use beamtune::model::{self, Aim, Combine, Model, Objective, Tune, Variable};
use beamtune::presets;
use beamtune::tune::{Options, Problem, run};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

static NEVER: AtomicBool = AtomicBool::new(false);

/// The absorbers of fig05a: a stiffness and a damping each along y and along z, twelve variables.
fn absorbers(aim: Aim) -> Model {
    let mut model = model::read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    let mut variables = Vec::new();
    for name in ["S1", "S2", "S3"] {
        for axis in ["y", "z"] {
            for (key, min, max) in [("stiffness", 1e5, 1e9), ("damping", 1.0, 1e5)] {
                let side = |side: &str| format!("subsystems.{name}.{axis}_{side}.{key}").into();
                variables.push(Variable {
                    paths: vec![side("left"), side("right")],
                    hold: model::Hold::Equal,
                    min,
                    max,
                    scale: None,
                    tolerance: 0.0,
                });
            }
        }
    }
    model.tune = Some(Tune {
        variables,
        objectives: vec![Objective {
            aim,
            response: Some("P5 w".to_owned()),
            from: 1.0,
            to: 400.0,
            weight: 1.0,
        }],
        combine: Combine::Sum,
        limits: Vec::new(),
    });
    model
}

/// Evaluations of a search.
const BUDGET: usize = 300;

fn benches(criterion: &mut Criterion) {
    let aims = [
        ("highest peak", Aim::Peak),
        ("mean square", Aim::MeanSquare),
    ];
    let mut group = criterion.benchmark_group("tune fig05a");
    group.sample_size(10);
    for (name, aim) in aims {
        let problem = Problem::new(&checked(&absorbers(aim)), Path::new(".")).unwrap();
        let options = Options {
            seed: 1,
            budget: Some(BUDGET),
        };
        group.throughput(Throughput::Elements(BUDGET as u64));
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                run(&problem, &options, &NEVER, &mut |_| {})
                    .unwrap()
                    .evaluations
            });
        });
    }
    group.finish();
}

criterion_group!(all, benches);
criterion_main!(all);

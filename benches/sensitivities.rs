//! Time of the derivatives of all responses by all parameters, compared with that of the responses alone; one thread.
//!
//! `cargo bench --bench sensitivities`

#![allow(clippy::expect_used)]

#[path = "../tests/common/checked.rs"]
mod checked;

use checked::checked;
use std::hint::black_box;
use std::sync::atomic::AtomicBool;

use beamtune::model::{Model, read};
use beamtune::solve::sensitivity::Differentiator;
use beamtune::{presets, solve};
use criterion::{Criterion, criterion_group, criterion_main};

fn preset(name: &str) -> Model {
    let preset = presets::find(name).expect("an embedded preset");
    read(preset.text)
        .expect("presets are possible models")
        .into_inner()
}

/// All responses at one frequency, and their derivatives.
fn gradients(criterion: &mut Criterion) {
    let single = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("a pool of one thread");
    let thousand = read(include_str!("../tests/data/thousand.toml"))
        .expect("a possible model")
        .into_inner();
    let cases = [
        ("fig05a", preset("fig05a")),
        ("fig16 (energy)", preset("fig16")),
        ("1000 subsystems", thousand),
    ];
    for (name, model) in cases {
        let never = AtomicBool::new(false);
        let frequencies: Vec<f64> = (1..=50).map(|index| 7.3 * f64::from(index)).collect();
        let differentiator = Differentiator::new(&checked(&model));
        let mut group = criterion.benchmark_group(name);
        group.sample_size(10);
        group.bench_function("50 frequencies", |bencher| {
            bencher
                .iter(|| single.install(|| solve::sweep(&checked(&model), &frequencies, &never)));
        });
        group.bench_function("their derivatives", |bencher| {
            bencher.iter(|| {
                for &frequency in &frequencies {
                    black_box(differentiator.at(frequency.into()));
                }
            });
        });
        group.bench_function("laying out", |bencher| {
            bencher.iter(|| black_box(Differentiator::new(&checked(&model))));
        });
        group.finish();
    }
}

/// Derived results: a mode, a peak and a mean square with their derivatives.
fn features(criterion: &mut Criterion) {
    let never = AtomicBool::new(false);
    let model = preset("fig05a");
    let found = solve::modes::modes(&checked(&model), 400.0, &never).expect("nothing cancels");
    let differentiator = Differentiator::new(&checked(&model));
    let middle = found.modes.len() / 2;
    let mut group = criterion.benchmark_group("fig05a");
    group.sample_size(10);
    group.bench_function("a mode", |bencher| {
        bencher.iter(|| black_box(differentiator.mode(&found, middle)));
    });
    group.bench_function("a peak", |bencher| {
        bencher.iter(|| black_box(differentiator.peak(9, 15.44)));
    });
    group.bench_function("a mean square", |bencher| {
        bencher.iter(|| black_box(differentiator.mean_square(9, &found, [20.0, 120.0], &never)));
    });
    group.finish();
}

criterion_group!(benches, gradients, features);
criterion_main!(benches);

//! Time of a frequency response: microseconds per frequency, on one core and on all cores.
//!
//! `cargo bench --bench frf`; divide a time by its number of elements, or read the throughput's inverse.

#![allow(clippy::expect_used)]

#[path = "../tests/common/checked.rs"]
mod checked;

use checked::checked;
use std::hint::black_box;
use std::sync::atomic::AtomicBool;

use beamtune::model::{Model, Spacing, Sweep, read};
use beamtune::{presets, solve};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

/// The model of a preset.
fn preset(name: &str) -> Model {
    let preset = presets::find(name).expect("an embedded preset");
    read(preset.text)
        .expect("presets are possible models")
        .into_inner()
}

/// `fig05a` with `count` of its subsystems evenly along the beam, their total mass constant.
fn with_subsystems(count: usize) -> Model {
    let mut model = preset("fig05a");
    let pattern = model.subsystems[0].clone();
    model.subsystems = (1..=count)
        .map(|index| {
            let mut subsystem = pattern.clone();
            subsystem.name = format!("S{index}");
            subsystem.position = model.beam.length * index as f64 / (count + 1) as f64;
            subsystem.mass *= 3.0 / count as f64;
            subsystem.inertia *= 3.0 / count as f64;
            subsystem
        })
        .collect();
    model
}

/// Solves the whole sweep, on one core and on all.
fn sweeps(criterion: &mut Criterion) {
    let cases = [
        ("fig05a", preset("fig05a"), 2000),
        ("10 subsystems", with_subsystems(10), 2000),
        ("100 subsystems", with_subsystems(100), 500),
        ("1000 subsystems", with_subsystems(1000), 100),
    ];
    let single = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("a pool of one thread");
    for (name, model, points) in cases {
        let frequencies = solve::frequencies(&Sweep {
            from: 1.0,
            to: 400.0,
            points,
            spacing: Spacing::Linear,
        });
        let never = AtomicBool::new(false);
        let mut group = criterion.benchmark_group(name);
        group.throughput(Throughput::Elements(points as u64));
        group.sample_size(10);
        group.bench_function(BenchmarkId::from_parameter("one core"), |bencher| {
            bencher.iter(|| {
                single.install(|| black_box(solve::sweep(&checked(&model), &frequencies, &never)))
            });
        });
        group.bench_function(BenchmarkId::from_parameter("all cores"), |bencher| {
            bencher.iter(|| black_box(solve::sweep(&checked(&model), &frequencies, &never)));
        });
        group.finish();
    }
}

/// Adds the points for peaks and anti-resonances to a solved sweep with known modes, on all cores.
fn resolving(criterion: &mut Criterion) {
    let never = AtomicBool::new(false);
    let mut group = criterion.benchmark_group("resolved");
    group.sample_size(10);
    for name in ["fig05a", "fig08", "hundred_absorbers"] {
        let model = preset(name);
        let modes =
            solve::modes::modes(&checked(&model), model.sweep.to, &never).expect("nothing cancels");
        let base = solve::frequencies(&model.sweep);
        let solved = solve::sweep(&checked(&model), &base, &never).expect("nothing cancels");
        group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
            bencher.iter(|| {
                black_box(solve::peaks::resolved(
                    &checked(&model),
                    &modes,
                    solved.clone(),
                    &never,
                ))
            });
        });
    }
    group.finish();
}

criterion_group!(benches, sweeps, resolving);
criterion_main!(benches);

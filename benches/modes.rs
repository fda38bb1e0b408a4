//! Time to find modes: run with `cargo bench --bench modes`.

#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

#[path = "../tests/common/checked.rs"]
mod checked;

use checked::checked;
use std::hint::black_box;
use std::sync::atomic::AtomicBool;

use beamtune::model::{self, Model};
use beamtune::presets;
use beamtune::solve::modes::{count, follow, modes, undamped};
use criterion::{Criterion, criterion_group, criterion_main};

#[path = "../tests/common/frequency_of.rs"]
mod frequency_of;

use frequency_of::frequency_of;

static NEVER: AtomicBool = AtomicBool::new(false);

fn thousand() -> Model {
    model::read(include_str!("../tests/data/thousand.toml"))
        .unwrap()
        .into_inner()
}

/// The first fifty subsystems of the thousand.
fn fifty() -> Model {
    let mut model = thousand();
    let every = model.subsystems.len() / 50;
    model.subsystems = model.subsystems.into_iter().step_by(every).collect();
    model
}

fn benches(criterion: &mut Criterion) {
    let paper = model::read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    let hundred = model::read(presets::find("hundred_absorbers").unwrap().text)
        .unwrap()
        .into_inner();
    let (fifty, thousand) = (fifty(), thousand());
    let hundredth = frequency_of(&thousand, 100);
    let mut group = criterion.benchmark_group("modes");
    group.sample_size(10);
    for (name, model, to) in [
        ("fig05a to 600 Hz", &paper, 600.0),
        ("50 absorbers to 200 Hz", &fifty, 200.0),
        ("hundred_absorbers to 400 Hz", &hundred, 400.0),
        ("1,000 absorbers, first 100 modes", &thousand, hundredth),
    ] {
        let found = modes(&checked(model), to, &NEVER).unwrap();
        println!(
            "{name}: {} modes, {} without damping",
            found.modes.len(),
            found.undamped
        );
        group.bench_function(format!("{name}, undamped"), |bencher| {
            bencher.iter(|| undamped(black_box(&checked(model)), to, &NEVER));
        });
        group.bench_function(format!("{name}, damped"), |bencher| {
            bencher.iter(|| modes(black_box(&checked(model)), to, &NEVER));
        });
        group.bench_function(format!("{name}, followed"), |bencher| {
            let mut changed = model.clone();
            changed.subsystems[0].mass *= 1.01;
            bencher.iter(|| follow(black_box(&checked(&changed)), &found, &NEVER));
        });
        group.bench_function(format!("{name}, one count"), |bencher| {
            bencher.iter(|| count(black_box(&checked(model)), 0.7 * to));
        });
    }
    group.finish();
}

criterion_group!(all, benches);
criterion_main!(all);

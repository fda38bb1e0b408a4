//! The cost of the sweep kernel: run with `cargo bench --bench kernel`.
//!
//! Side by side in one run, each the shortest of several times: the exact solver and the independent methods; the
//! processor's peak of independent fused multiply-adds, with the vectors that the kernel uses, and the kernel's share
//! of it; the time with each instruction set, that is, the benefit of the `unsafe` in `src/solve/kernel/vectors.rs`; the time
//! at low frequencies;
//! the growth of the time with the number of subsystems; the cost of an edit of each kind compared with a model with
//! one subsystem, and the size of the cache for it.

#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

#[path = "../tests/common/checked.rs"]
mod checked;

use checked::checked;
use std::hint::black_box;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use beamtune::model::{
    BeamMotion, InnerSupport, Model, Place, Quantity, Restraint, Spacing, Span, Support, Sweep,
    Target, read,
};
use beamtune::presets;
use beamtune::solve::instruction_sets::{Instructions, sweep_with, work};
use beamtune::solve::{SweepCache, fem, frequencies, sweep, transfer_matrix};

static NEVER: AtomicBool = AtomicBool::new(false);

/// Independent chains of multiplications.
const CHAINS: usize = 12;

fn main() {
    let alone = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    fem_curves();
    alone.install(|| {
        against_the_peak();
        by_instructions();
        low_frequencies();
        growth();
        edits();
    });
}

/// The shortest of some times, s.
fn shortest<T>(times: usize, mut run: impl FnMut() -> T) -> f64 {
    let once = |_| {
        let start = Instant::now();
        black_box(run());
        start.elapsed().as_secs_f64()
    };
    (0..times).map(once).fold(f64::INFINITY, f64::min)
}

/// The model of a preset.
fn preset(name: &str) -> Model {
    read(presets::find(name).unwrap().text)
        .unwrap()
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

/// From 1 to 400 Hz.
fn grid(points: usize) -> Vec<f64> {
    frequencies(&Sweep {
        from: 1.0,
        to: 400.0,
        points,
        spacing: Spacing::Linear,
    })
}

/// The exact solver compared with finite elements and the paper's chain, on all cores: fig05a, 2,000 frequencies, 12
/// responses.
fn fem_curves() {
    /// A frequency of 80 elements by `scipy.sparse.linalg.spsolve`, us, measured separately.
    const SCIPY: f64 = 700.0;
    let model = preset("fig05a");
    let (all, some) = (grid(2000), grid(100));
    let elements = fem::FiniteElements::new(&model, 80);
    let (mut exact, mut finite, mut product) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
    for _ in 0..10 {
        exact = exact.min(shortest(3, || sweep(&checked(&model), &all, &NEVER)) / 2000.0);
        finite = finite.min(shortest(1, || elements.sweep(&some, &NEVER)) / 100.0);
        product = product.min(
            shortest(1, || {
                transfer_matrix::sweep(&checked(&model), &some, &NEVER)
            }) / 100.0,
        );
    }
    let [exact, finite, product] = [exact, finite, product].map(|time| time * 1e6);
    println!("All cores, us a frequency, and times the exact solver:");
    println!("{:34} {exact:9.3}", "exact");
    for (name, time) in [
        ("finite elements, 80, built in", finite),
        ("finite elements, 80, SciPy (measured apart)", SCIPY),
        ("the paper's chain", product),
    ] {
        println!("{name:34} {time:9.1} {:9.0}", time / exact);
    }
    for frequency in [100.0, 400.0, 1000.0] {
        let [one, other] = [
            sweep(&checked(&model), &[frequency], &NEVER).unwrap(),
            transfer_matrix::sweep(&checked(&model), &[frequency], &NEVER)
                .unwrap()
                .unwrap(),
        ];
        let pairs = one.columns.iter().zip(&other.columns);
        let worst = pairs
            .map(|(a, b)| (a.values[0] - b.values[0]).norm() / a.values[0].norm())
            .fold(0.0, f64::max);
        println!("the chain differs at {frequency} Hz by {worst:.1e}");
    }
    println!();
}

/// A model whose section has no symmetry: w, psi and v are coupled.
fn unsymmetric(mut model: Model) -> Model {
    model.beam.section.centroid_offset_y = 0.043;
    model.beam.section.product_moment = 6e-5;
    model
}

/// A model with supports between the ends: bearings that fix w and v.
fn held(mut model: Model, count: usize) -> Model {
    let mut support = Support::FREE;
    support[BeamMotion::W] = Restraint::Fixed;
    support[BeamMotion::V] = Restraint::Fixed;
    let length = model.beam.length;
    model.supports.inner = (1..=count)
        .map(|index| InnerSupport {
            name: format!("B{index}"),
            position: length * (index as f64 - 0.3) / count as f64,
            support: support.clone(),
        })
        .collect();
    model
}

/// A model in spans of equal length, each with another section.
fn in_spans(mut model: Model, count: usize) -> Model {
    let length = model.beam.length / count as f64;
    let spans = (0..count).map(|index| {
        let mut section = model.beam.section;
        section.second_moment_y *= 1.0 + 0.01 * index as f64;
        Span {
            length,
            section: Some(section),
            ..Span::default()
        }
    });
    model.spans = spans.collect();
    model.beam.length = 0.0;
    model
}

/// The models to compare the kernel with the peak, and the number of frequencies.
fn models() -> [(&'static str, Model, usize); 10] {
    let unsymmetric_hundred = unsymmetric(with_subsystems(100));
    [
        ("fig05a", preset("fig05a"), 2000),
        ("fig05a, no symmetry", unsymmetric(preset("fig05a")), 2000),
        ("100 subsystems, no symmetry", unsymmetric_hundred, 800),
        ("fig05a on 2 bearings", held(preset("fig05a"), 2), 2000),
        ("fig13, with E_V", preset("fig13"), 2000),
        ("1 subsystem", with_subsystems(1), 2000),
        ("90 subsystems", with_subsystems(90), 800),
        (
            "60 spans, 30 subsystems",
            in_spans(with_subsystems(30), 60),
            800,
        ),
        ("100 subsystems", with_subsystems(100), 800),
        ("1,000 subsystems", with_subsystems(1000), 200),
    ]
}

/// The kernel's multiplications and additions per second, and the processor's.
fn against_the_peak() {
    let instructions = Instructions::available()[0];
    println!(
        "One core, {instructions:?}. Operations are multiplications that add, multiplications or additions; times: the"
    );
    println!(
        "time over the least that the peak of these instructions allows for them, and for them and the divisions."
    );
    println!(
        "{:28} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8} {:>8}",
        "", "us", "operat.", "divisions", "1e9/s", "peak", "times", "with div."
    );
    for (name, model, points) in models() {
        let all = grid(points);
        let cost = work(&checked(&model), &all, instructions);
        // Side by side, because clock rates drift.
        let (mut peak, mut time) = ([0.0_f64; 2], f64::INFINITY);
        for _ in 0..5 {
            for (peak, now) in peak.iter_mut().zip(peaks(instructions)) {
                *peak = peak.max(now);
            }
            time = time.min(shortest(4, || sweep(&checked(&model), &all, &NEVER)) / points as f64);
        }
        let least = cost.multiply_adds / peak[0];
        let with_divisions = least + cost.divisions / peak[1];
        println!(
            "{name:28} {:9.3} {:9.0} {:9.0} {:9.2} {:8.2} {:8.2} {:8.2}",
            time * 1e6,
            cost.multiply_adds,
            cost.divisions,
            cost.multiply_adds / time * 1e-9,
            peak[0] * 1e-9,
            time / least,
            time / with_divisions
        );
    }
}

/// The same sweeps with each instruction set of the processor.
fn by_instructions() {
    println!("\nOne core, us a frequency by instructions:");
    let available = Instructions::available();
    print!("{:28}", "");
    for instructions in &available {
        print!(" {:>9}", format!("{instructions:?}"));
    }
    println!();
    for (name, model, points) in models() {
        let all = grid(points);
        let mut times = vec![f64::INFINITY; available.len()];
        for _ in 0..5 {
            for (time, &instructions) in times.iter_mut().zip(&available) {
                let now = shortest(3, || sweep_with(instructions, &checked(&model), &all));
                *time = time.min(now / points as f64);
            }
        }
        print!("{name:28}");
        for time in times {
            print!(" {:9.3}", time * 1e6);
        }
        println!();
    }
}

/// Far below the first resonance, in numbers of twice the digits.
fn low_frequencies() {
    println!("\nOne core, us a frequency from 0.1 to 0.5 Hz:");
    for (name, model, points) in [
        ("fig05a", preset("fig05a"), 200),
        ("1,000 subsystems", with_subsystems(1000), 8),
    ] {
        let all = frequencies(&Sweep {
            from: 0.1,
            to: 0.5,
            points,
            spacing: Spacing::Linear,
        });
        let time = shortest(5, || sweep(&checked(&model), &all, &NEVER)) / points as f64;
        println!("{name:28} {:9.1}", time * 1e6);
    }
}

/// Operations per second of many independent chains: fused multiply-adds, and divisions.
fn peaks(instructions: Instructions) -> [f64; 2] {
    const ROUNDS: usize = 300_000;
    let by_time = |lanes: usize, time: f64| (ROUNDS * CHAINS * lanes) as f64 / time;
    match instructions {
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx512 => [
            by_time(8, shortest(3, || chains::avx512::multiply_adds(ROUNDS))),
            by_time(8, shortest(2, || chains::avx512::divisions(ROUNDS))),
        ],
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx2 => [
            by_time(4, shortest(3, || chains::avx2::multiply_adds(ROUNDS))),
            by_time(4, shortest(2, || chains::avx2::divisions(ROUNDS))),
        ],
        Instructions::Portable => [
            by_time(4, shortest(3, || chains::portable::multiply_adds(ROUNDS))),
            by_time(4, shortest(2, || chains::portable::divisions(ROUNDS))),
        ],
    }
}

mod chains {
    /// Chains of fused multiply-adds, and of divisions, with the processor's vectors.
    #[cfg(target_arch = "x86_64")]
    macro_rules! chains {
        ($name:ident, $features:literal, $vector:ident, $splat:ident, $multiply_add:ident, $divide:ident) => {
            #[allow(
                unsafe_code,
                reason = "the processor's own instructions are what is measured"
            )]
            pub(super) mod $name {
                use std::arch::x86_64::{$divide, $multiply_add, $splat, $vector};
                use std::hint::black_box;

                use crate::CHAINS;

                pub(crate) fn multiply_adds(rounds: usize) -> [$vector; CHAINS] {
                    #[target_feature(enable = $features)]
                    fn run(rounds: usize) -> [$vector; CHAINS] {
                        let (by, plus) = black_box(($splat(0.999_999), $splat(1e-6)));
                        let mut chains = [$splat(1.5); CHAINS];
                        for _ in 0..rounds {
                            chains = chains.map(|chain| $multiply_add(chain, by, plus));
                        }
                        chains
                    }
                    // SAFETY: the processor has them, for they are available.
                    unsafe { run(rounds) }
                }

                pub(crate) fn divisions(rounds: usize) -> [$vector; CHAINS] {
                    #[target_feature(enable = $features)]
                    fn run(rounds: usize) -> [$vector; CHAINS] {
                        let by = black_box($splat(2.1));
                        let mut chains = [$splat(1.5); CHAINS];
                        for _ in 0..rounds {
                            chains = chains.map(|chain| $divide(by, chain));
                        }
                        chains
                    }
                    // SAFETY: the processor has them, for they are available.
                    unsafe { run(rounds) }
                }
            }
        };
    }

    #[cfg(target_arch = "x86_64")]
    chains!(
        avx512,
        "avx512f",
        __m512d,
        _mm512_set1_pd,
        _mm512_fmadd_pd,
        _mm512_div_pd
    );
    #[cfg(target_arch = "x86_64")]
    chains!(
        avx2,
        "avx2,fma",
        __m256d,
        _mm256_set1_pd,
        _mm256_fmadd_pd,
        _mm256_div_pd
    );

    /// With the vectors of every processor.
    pub(super) mod portable {
        use std::hint::black_box;

        use crate::CHAINS;

        const LANES: usize = 4;

        pub(crate) fn multiply_adds(rounds: usize) -> [[f64; LANES]; CHAINS] {
            let (by, plus) = black_box((0.999_999, 1e-6));
            run(rounds, |chain| {
                if cfg!(target_arch = "aarch64") {
                    chain.mul_add(by, plus)
                } else {
                    chain * by + plus
                }
            })
        }

        pub(crate) fn divisions(rounds: usize) -> [[f64; LANES]; CHAINS] {
            let by = black_box(2.1);
            run(rounds, |chain| by / chain)
        }

        fn run(rounds: usize, operation: impl Fn(f64) -> f64) -> [[f64; LANES]; CHAINS] {
            let mut chains = [[1.5; LANES]; CHAINS];
            for _ in 0..rounds {
                chains = chains.map(|chain| chain.map(&operation));
            }
            chains
        }
    }
}

/// Time by the number of subsystems.
fn growth() {
    let all = grid(200);
    let [hundred, thousand] = [100, 1000].map(with_subsystems);
    let (mut one, mut ten) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..8 {
        one = one.min(shortest(4, || sweep(&checked(&hundred), &all, &NEVER)));
        ten = ten.min(shortest(1, || sweep(&checked(&thousand), &all, &NEVER)));
    }
    println!(
        "\n1,000 subsystems take {:.2} times as long as 100",
        ten / one
    );
}

type Edit = fn(&mut Model);

/// An edit of each kind, in the middle of the beam or at one of its ends.
const EDITS: [(&str, Edit); 8] = [
    ("mass of a subsystem", |m| m.subsystems[499].mass *= 1.01),
    ("its spring", |m| m.subsystems[499].z_left.stiffness *= 1.01),
    ("its place", |m| m.subsystems[499].position += 1e-4),
    ("force", |m| m.forces[0].amplitude *= 1.01),
    ("place of a probe", move_probe),
    ("left support", |m| stiffen(m, true)),
    ("right support", |m| stiffen(m, false)),
    ("length", |m| m.beam.length += 1e-4),
];

fn move_probe(model: &mut Model) {
    for response in &mut model.responses {
        if let Quantity::Motion(Target::Beam(Place::Position(x), _), _) = &mut response.quantity
            && (*x - 1.2).abs() < 0.1
        {
            *x += 1e-4;
        }
    }
}

fn stiffen(model: &mut Model, left: bool) {
    let supports = &mut model.supports;
    let end = if left {
        &mut supports.left
    } else {
        &mut supports.right
    };
    if let Restraint::Elastic(elastic) = &mut end[BeamMotion::W] {
        elastic.spring.stiffness *= 1.01;
    }
}

/// Edits of one thing among 1,000 subsystems compared with a model with one.
fn edits() {
    let all = grid(2000);
    let (one, thousand) = (with_subsystems(1), with_subsystems(1000));
    let afresh = shortest(2, || sweep(&checked(&thousand), &all, &NEVER));
    println!(
        "\n1,000 subsystems, 2,000 frequencies, 12 responses: {:.0} ms afresh",
        afresh * 1e3
    );
    println!(
        "{:20} {:>9} {:>9} {:>12} {:>8} {:>12}",
        "edited", "first ms", "next ms", "one subs. ms", "ratio", "kept bytes"
    );
    for (name, edit) in EDITS {
        let (mut model, mut kept) = (thousand.clone(), SweepCache::default());
        kept.sweep(&checked(&model), &all, &NEVER).unwrap();
        let mut next = || {
            edit(&mut model);
            shortest(1, || kept.sweep(&checked(&model), &all, &NEVER))
        };
        let first = next();
        let (mut later, mut single) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..10 {
            later = later.min(next());
            single = single.min(shortest(1, || sweep(&checked(&one), &all, &NEVER)));
        }
        println!(
            "{name:20} {:9.1} {:9.3} {:12.3} {:8.2} {:12}",
            first * 1e3,
            later * 1e3,
            single * 1e3,
            later / single,
            kept.bytes()
        );
    }
}

//! Lists of modes are complete and right: models whose lists were wrong or open once, and random models with an
//! independent check.
//!
//! Expected values: `tests/data/modes/exact.json`, roots of the exact determinant in ball arithmetic as
//! `tests/data/README.md` describes; closed forms; the argument principle, and finite elements refined on the
//! determinant.
//!
//! `MODES_CASES=2000 MODES_STUDIES=1 cargo test --release --test certain` checks 2,000 random models instead of 200,
//! and all members of all studies instead of a sample: about an hour on two cores.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "../common/checked.rs"]
mod checked;
mod determinant;
mod double_double;
mod elements;
#[path = "../common/frequency_of.rs"]
mod frequency_of;
mod groups;
mod judge;
mod random;
mod shapes;
mod studies;

use checked::checked;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fmt::Debug;
use std::sync::atomic::AtomicBool;

use beamtune::model::{self, Model};
use beamtune::solve::modes::{Completeness, Mode, ModeKind, Modes, modes};
use num_complex::Complex64;
use rayon::prelude::*;
use serde::Deserialize;

static NEVER: AtomicBool = AtomicBool::new(false);

fn load(name: &str) -> Model {
    let file = format!("tests/data/modes/{name}.toml");
    model::read(&std::fs::read_to_string(file).unwrap())
        .unwrap()
        .into_inner()
}

fn certain(model: &Model, to: f64) -> Modes {
    let found = modes(&checked(model), to, &NEVER).unwrap();
    assert_eq!(found.completeness, Completeness::Certain, "{}", model.title);
    found
}

#[derive(Deserialize)]
struct Exact {
    file: String,
    to: f64,
    /// Frequency in Hz, damping ratio and multiplicity of all modes above 0.
    #[serde(default)]
    all: Vec<(f64, f64, usize)>,
    /// The modes of a range, in the same form.
    #[serde(default)]
    some: Vec<(f64, f64, usize)>,
    #[serde(default)]
    from_to: [f64; 2],
}

fn exact() -> Vec<Exact> {
    let cases: Vec<Exact> = serde_json::from_str(include_str!("../data/modes/exact.json")).unwrap();
    assert_eq!(cases.len(), 10);
    cases
}

/// Expected: ball arithmetic. Identical absorbers, overdamped roots, nearly equal modes, a mode just below the end.
#[test]
fn lists_that_lacked_modes_or_had_some_twice_are_exact() {
    for case in exact() {
        let found = certain(&load(&case.file), case.to);
        let range = if case.all.is_empty() {
            case.from_to
        } else {
            [1e-9, case.to]
        };
        let inside = |mode: &&Mode| (range[0]..range[1]).contains(&mode.frequency());
        let mut listed: Vec<&Mode> = found.modes.iter().filter(inside).collect();
        for (hertz, damping, count) in case.all.iter().chain(&case.some) {
            let near = |mode: &&Mode| {
                (mode.frequency() / hertz - 1.0).abs() < 1e-6
                    && (mode.damping_ratio() - damping).abs() < 1e-6
            };
            let hits: Vec<&Mode> = listed.iter().copied().filter(near).collect();
            assert_eq!(
                hits.len(),
                *count,
                "{}: {hertz} Hz, {damping}: {hits:?}",
                case.file
            );
            for mode in hits {
                // The accuracy of two roots this close together is the square root of the rounding error.
                assert!(
                    (mode.frequency() / hertz - 1.0).abs() < 1e-9,
                    "{}: {mode:?} {hertz}",
                    case.file
                );
                assert!(
                    (mode.damping_ratio() - damping).abs() < 1e-8,
                    "{}: {mode:?} {damping}",
                    case.file
                );
            }
            listed.retain(|mode| !near(mode));
        }
        assert!(listed.is_empty(), "{}: {listed:?}", case.file);
    }
}

/// Expected: ball arithmetic. The judge counts each root within the rounding of its frequency and damping ratio.
#[test]
fn a_judge_counts_the_roots_of_ball_arithmetic() {
    const CLOSE: f64 = 1e-14;
    for case in exact() {
        let model = load(&case.file);
        if model.beam.section.warping_constant == 0.0 {
            continue;
        }
        for &(hertz, damping, count) in case.all.iter().chain(&case.some) {
            let omega = TAU * hertz * Complex64::new((1.0 - damping * damping).sqrt(), damping);
            let counted = judge::counted(&model, omega, CLOSE * omega.norm());
            assert_eq!(counted, Some(count as i64), "{}: {hertz} Hz", case.file);
        }
    }
}

/// Expected: closed form, `omega^2 J - i omega c - k = 0`. Three masses rotate on springs that exert no net force on
/// the beam, with equal moments of inertia and with steps between them.
#[test]
fn masses_that_turn_nearly_alike_are_listed_one_by_one() {
    for name in ["nearly_alike_undamped", "nearly_alike_damped"] {
        for step in [0.0, 1e-7, 3e-6, 3e-5, 1e-4] {
            let mut model = load(name);
            for (index, mass) in model.subsystems.iter_mut().enumerate() {
                mass.inertia = 0.1 * (1.0 + index as f64 * step);
            }
            let mut listed = certain(&model, 100.0).modes;
            for mass in &model.subsystems {
                let square = 2.0 * mass.arm_left.powi(2);
                let (k, c) = (square * mass.z_left.stiffness, square * mass.z_left.damping);
                let hertz = (k / mass.inertia).sqrt() / TAU;
                let damping = 0.5 * c / (k * mass.inertia).sqrt();
                let near = |mode: &Mode| {
                    (mode.frequency() / hertz - 1.0).abs() < 1e-10
                        && (mode.damping_ratio() - damping).abs() < 1e-10
                };
                let place = listed.iter().position(near);
                let place = place.unwrap_or_else(|| panic!("{name}, {step}: {hertz}: {listed:?}"));
                listed.remove(place);
            }
        }
    }
}

/// Expected: a sign change of the exact determinant on the imaginary axis (ball arithmetic; 8 digits given), or closed
/// form, `m s^2 + c s + k = 0`, where the beam is practically rigid or fixed (123.1 Hz); 6.957 Hz is a sign change of
/// the state equation in double precision.
#[test]
fn overdamped_modes_are_those_of_the_exact_determinant() {
    for (name, to, tolerance, expected) in [
        ("overdamped_once", 150.0, 1e-9, vec![]),
        ("overdamped_once", 240.0, 1e-9, vec![224.632_396_583_709]),
        ("overdamped_once", 400.0, 1e-9, vec![224.632_396_583_709]),
        ("overdamped_slow", 150.0, 1e-9, vec![6.686_963_995_893]),
        (
            "overdamped_twice",
            400.0,
            1e-7,
            vec![53.507_193, 251.953_131],
        ),
        (
            "overdamped_pair",
            400.0,
            1e-7,
            vec![6.957_672_6, 102.806_276, 123.106_862_1, 164.149_349],
        ),
        ("overdamped_mass", 200.0, 1e-4, vec![3.321_757, 76.255_7]),
    ] {
        let found = certain(&load(name), to);
        let creeping = found
            .modes
            .iter()
            .filter(|mode| mode.kind == ModeKind::Overdamped);
        let creeping: Vec<f64> = creeping.map(Mode::frequency).collect();
        assert_eq!(
            creeping.len(),
            expected.len(),
            "{name} to {to}: {creeping:?}"
        );
        for (got, want) in creeping.iter().zip(expected) {
            assert!((got / want - 1.0).abs() < tolerance, "{name}: {got} {want}");
        }
    }
}

/// Expected: closed form, `m s^2 + c s + k = 0`. A mass at a pinned end moves along y alone, and creeps at 123.1 Hz.
#[test]
fn a_damped_mass_at_a_held_end_is_a_mode() {
    let model = load("overdamped_pair");
    let mass = &model.subsystems[1];
    assert_eq!((mass.position, model.supports.left.kind()), (0.0, "pinned"));
    let k = mass.y_left.stiffness + mass.y_right.stiffness;
    let c = mass.y_left.damping + mass.y_right.damping;
    let rate = 2.0 * k / (c + (c * c - 4.0 * mass.mass * k).sqrt());
    let exact = Complex64::new(0.0, rate);
    assert_eq!(judge::counted(&model, exact, 1e-13 * rate), Some(1));
    let found = certain(&model, 150.0);
    let listed = found.modes.iter().map(|mode| (mode.omega - exact).norm());
    assert!(listed.fold(f64::INFINITY, f64::min) < 1e-10 * rate);
}

/// Expected: as many modes as without damping, in a complete list.
#[test]
fn a_small_loss_factor_leaves_a_list_certain() {
    for (name, to, count) in [
        ("two_absorbers_small_loss", 120.0, 14),
        ("alike_small_loss", 200.0, 25),
    ] {
        let found = certain(&load(name), to);
        assert_eq!(
            [found.modes.len(), found.undamped],
            [count, count],
            "{name}"
        );
    }
}

/// How many ranges of a list of modes are open, or what is wrong with it.
fn certain_and_right(model: &Model, to: f64) -> Result<usize, String> {
    let found = modes(&checked(model), to, &NEVER).unwrap();
    match judge::fault(model, &found) {
        Some(fault) => Err(fault),
        None => match found.completeness {
            Completeness::Certain => Ok(0),
            Completeness::Open(gaps) => Ok(gaps.len()),
            Completeness::Uncounted => Err("no count was made".to_owned()),
            Completeness::TooMany => Err("too many modes".to_owned()),
        },
    }
}

/// The models whose lists are wrong, with the error, and those whose lists are open.
fn report<T: Ord + Clone + Debug>(
    verdicts: Vec<(T, Result<usize, String>)>,
) -> (BTreeMap<T, String>, Vec<T>) {
    let count = verdicts.len();
    let (mut wrong, mut open) = (BTreeMap::new(), Vec::new());
    for (name, verdict) in verdicts {
        match verdict {
            Ok(0) => {}
            Ok(_) => open.push(name),
            Err(fault) => {
                wrong.insert(name, fault);
            }
        }
    }
    let [bad, unsettled] = [wrong.len(), open.len()];
    println!("{count} models: {bad} wrong {wrong:#?}, {unsettled} open {open:?}");
    (wrong, open)
}

/// Expected: the judge counts what is listed, group by group and as a whole.
///
/// `MODES_CASES` sets another number of models: 2,000 take some minutes.
#[test]
fn random_models_have_the_modes_that_a_judge_counts() {
    let cases: u64 = std::env::var("MODES_CASES").map_or(200, |cases| cases.parse().unwrap());
    let verdicts = (0..cases)
        .into_par_iter()
        .map(|seed| {
            let (model, to) = random::model(seed);
            (seed, certain_and_right(&model, to))
        })
        .collect();
    let (wrong, open) = report(verdicts);
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(open.len() as u64 * 200 <= cases, "{open:?}");
}

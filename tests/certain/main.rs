//! Lists of modes are complete and right: models whose lists were wrong or open once, and random models before a judge.
//!
//! Expected values: `tests/data/modes/exact.json`, roots of the exact determinant in ball arithmetic as
//! `tests/data/README.md` says; closed forms; the judge.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod judge;
mod random;
mod shapes;

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::atomic::AtomicBool;

use beamtune::model::{self, Model};
use beamtune::solve::modes::{Completeness, Mode, ModeKind, Modes, modes};
use judge::Judge;
use num_complex::Complex64;
use rayon::prelude::*;
use serde::Deserialize;

static NEVER: AtomicBool = AtomicBool::new(false);

fn load(name: &str) -> Model {
    let file = format!("tests/data/modes/{name}.toml");
    model::read(&std::fs::read_to_string(file).unwrap()).unwrap()
}

fn certain(model: &Model, to: f64) -> Modes {
    let found = modes(model, to, &NEVER).unwrap();
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
    /// The same of the modes of some range.
    #[serde(default)]
    some: Vec<(f64, f64, usize)>,
    #[serde(default)]
    from_to: [f64; 2],
}

/// Expected: ball arithmetic. Identical absorbers, overdamped roots, nearly equal modes, a mode just below the end.
#[test]
fn lists_that_lacked_modes_or_had_some_twice_are_exact() {
    let text = include_str!("../data/modes/exact.json");
    let cases: Vec<Exact> = serde_json::from_str(text).unwrap();
    assert_eq!(cases.len(), 10);
    for case in cases {
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
                // Two roots this close together are known to the root of the rounding of what separates them.
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

/// Expected: a sign change of the exact determinant on the imaginary axis (ball arithmetic; 8 digits given), or closed
/// form, `m s^2 + c s + k = 0`, where the beam is all but rigid or held (123.1 Hz); 6.957 Hz is a sign change of the
/// state equation in double precision.
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

/// Expected: as many modes as without damping, in a list that is certain.
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

/// What the judge says against a list that claims to be certain; none where it agrees.
fn fault(model: &Model, found: &Modes) -> Option<String> {
    let judge = Judge::new(model);
    let hysteretic = model.beam.material.loss_factor != 0.0;
    let moving: Vec<Complex64> = found
        .modes
        .iter()
        .map(|mode| mode.omega)
        .filter(|omega| omega.norm() > 0.0)
        .collect();
    let beyond = found.beyond.iter().map(|mode| mode.omega);
    let listed: Vec<Complex64> = moving.iter().copied().chain(beyond).collect();
    // Mirror images are roots too.
    let mut all = listed.clone();
    if !hysteretic {
        all.extend(
            listed
                .iter()
                .filter(|root| root.re != 0.0)
                .map(|root| -root.conj()),
        );
    }
    for group in groups(&all) {
        let own = |index: &usize| group.contains(index);
        let centre = group.iter().map(|&index| all[index]).sum::<Complex64>() / group.len() as f64;
        let distance = |index: usize| (all[index] - centre).norm();
        let size = group
            .iter()
            .map(|&index| distance(index))
            .fold(0.0, f64::max);
        let others = (0..all.len()).filter(|index| !own(index)).map(distance);
        let gap = others.fold(0.3 * centre.norm(), f64::min);
        // Of mirror images one is enough, and what lies beyond the range is not promised.
        if group[0] >= moving.len() {
            continue;
        }
        let counted = judge.in_circle(centre, size + 0.3 * (gap - size));
        if counted != Some(group.len() as i64) {
            let listed = group.len();
            return Some(format!(
                "{} Hz: {listed} listed, {counted:?} counted",
                centre / TAU
            ));
        }
    }
    let sizes = |to: f64| {
        let mut sizes: Vec<f64> = listed
            .iter()
            .map(|root| root.norm())
            .filter(|&size| size <= to)
            .collect();
        sizes.sort_by(f64::total_cmp);
        sizes
    };
    // Just below the end of the list, where nothing is near.
    let to = TAU * found.to;
    let inside = sizes(to);
    let last = inside.last().copied().unwrap_or(0.5 * to);
    let outer = if last > 0.999 * to {
        to
    } else {
        0.5 * (last.max(0.9 * to) + to)
    };
    let inner = 0.2 * inside.first().copied().unwrap_or(0.1 * to);
    let density = 40 + 5 * moving.len();
    let counted = if hysteretic {
        // Away from the axis, beyond which there are others.
        let angles: Vec<f64> = all.iter().map(|root| root.arg()).collect();
        let clear = |angle: f64| {
            angles
                .iter()
                .map(|a| (a - angle).abs())
                .fold(f64::INFINITY, f64::min)
        };
        let places = (1..30).map(|k| FRAC_PI_2 - 0.01 * f64::from(k));
        let angle = places
            .max_by(|a, b| clear(*a).total_cmp(&clear(*b)))
            .unwrap();
        let expected = moving
            .iter()
            .filter(|root| root.norm() < outer && root.arg() < angle)
            .count();
        (expected, judge.in_sector(inner, outer, angle, density))
    } else {
        let expected = all.iter().filter(|root| root.norm() < outer).count();
        (expected, judge.in_ring(inner, outer, density))
    };
    match counted {
        (expected, Some(counted)) if counted == expected as i64 => None,
        (expected, counted) => Some(format!("whole: {expected} listed, {counted:?} counted")),
    }
}

/// Roots that lie close together, one to the next, by their places; the first of each is the lowest place.
fn groups(all: &[Complex64]) -> Vec<Vec<usize>> {
    const CLOSE: f64 = 1e-4;
    let mut left: Vec<usize> = (0..all.len()).rev().collect();
    let mut groups = Vec::new();
    while let Some(first) = left.pop() {
        let mut group = vec![first];
        let mut next = 0;
        while next < group.len() {
            let here = all[group[next]];
            let near = |index: &usize| (all[*index] - here).norm() < CLOSE * here.norm();
            group.extend(left.iter().copied().filter(near));
            left.retain(|index| !near(index));
            next += 1;
        }
        groups.push(group);
    }
    groups
}

/// Expected: the judge counts what is listed, group by group and as a whole.
///
/// `MODES_CASES` sets another number of models.
#[test]
fn random_models_have_the_modes_that_a_judge_counts() {
    let cases: u64 = std::env::var("MODES_CASES").map_or(60, |cases| cases.parse().unwrap());
    let verdicts: Vec<(u64, Result<usize, String>)> = (0..cases)
        .into_par_iter()
        .map(|seed| {
            let (model, to) = random::model(seed);
            let found = modes(&model, to, &NEVER).unwrap();
            let verdict = match &found.completeness {
                Completeness::Open(gaps) => Ok(gaps.len()),
                Completeness::Certain => fault(&model, &found).map_or(Ok(0), Err),
                Completeness::TooMany => Err("too many modes".to_owned()),
                Completeness::Uncounted => Err("no count was made".to_owned()),
            };
            (seed, verdict)
        })
        .collect();
    let wrong: BTreeMap<u64, &String> = verdicts
        .iter()
        .filter_map(|(seed, verdict)| Some((*seed, verdict.as_ref().err()?)))
        .collect();
    let open: Vec<u64> = verdicts
        .iter()
        .filter(|(_, verdict)| matches!(verdict, Ok(1..)))
        .map(|(seed, _)| *seed)
        .collect();
    println!(
        "{cases} models: {} wrong {wrong:?}, {} open {open:?}",
        wrong.len(),
        open.len()
    );
    assert!(wrong.is_empty(), "{wrong:?}");
    assert!(open.len() as u64 * 30 <= cases, "{open:?}");
}

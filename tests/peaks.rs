//! Resolved grids and peak tables against closed forms and against dense scans of the same responses.

#![allow(clippy::unwrap_used, clippy::expect_used)]

// Other tests use the rest of it.
#[allow(dead_code)]
mod common;

#[path = "common/checked.rs"]
mod checked;

use checked::checked;
use std::f64::consts::{PI, TAU};
use std::sync::atomic::AtomicBool;

use beamtune::model::{
    self, BeamMotion, Measure, Model, Place, Quantity, Response, Restraint, Spacing, Sweep, Target,
};
use beamtune::solve::modes::{Completeness, Mode, ModeKind, Modes};
use beamtune::solve::peaks::{Peak, peaks, refined, resolved};
use beamtune::solve::{Cancelled, Column, ColumnKind, Frf, frequencies, sweep};
use beamtune::{presets, solve};
use num_complex::Complex64;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// The largest error of a drawn peak or dip, as a factor: 0.05 dB.
const FACTOR: f64 = 1.005_773;

static NEVER: AtomicBool = AtomicBool::new(false);

fn solved(model: &Model, frequencies: &[f64]) -> Frf {
    sweep(&checked(model), frequencies, &NEVER).unwrap()
}

fn resolve(model: &Model, modes: &Modes, base: &[f64]) -> Frf {
    resolved(&checked(model), modes, solved(model, base), &NEVER).unwrap()
}

fn linear(from: f64, to: f64, points: usize) -> Vec<f64> {
    let step = (to - from) / (points - 1) as f64;
    (0..points)
        .map(|i| {
            if i == points - 1 {
                to
            } else {
                from + step * i as f64
            }
        })
        .collect()
}

/// Modes of known complex angular frequencies, rad/s.
fn modes_of(mut omegas: Vec<Complex64>, to: f64) -> Modes {
    omegas.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
    let modes = omegas.into_iter().map(|omega| Mode {
        omega,
        kind: ModeKind::Oscillating,
    });
    Modes {
        unstable: 0,
        to,
        undamped: 0,
        beyond: Vec::new(),
        modes: modes.collect(),
        completeness: Completeness::Certain,
    }
}

/// A beam clamped at the left, with a mass on it there: the mass is connected to the ground.
fn grounded_mass(damping_y: f64, beta: f64) -> Model {
    let text = format!(
        r#"
format = "beamtune/1"
title = "A mass on the ground"
[beam]
length = 1.0
material = {{ young_modulus = 2.1e11, shear_modulus = 8e10, density = 7850.0 }}
[beam.section]
area = 0.01
second_moment_y = 1e-4
second_moment_z = 1e-4
torsion_constant = 1e-6
warping_constant = 1e-8
polar_moment = 2e-4
centroid_offset = 0.0
[supports.left]
kind = "clamped"
[supports.right]
kind = "clamped"
[[subsystems]]
name = "S"
position = 0.0
mass = {MASS:?}
inertia = {INERTIA:?}
y_left = {{ stiffness = {SPRING:?}, damping = {damping_y:?} }}
z_left = {{ stiffness = {Z_LEFT:?}, damping = {:?} }}
z_right = {{ stiffness = {Z_RIGHT:?}, damping = {:?} }}
arm_left = {ARM_LEFT:?}
arm_right = {ARM_RIGHT:?}
mount_y = 0.1
mount_z = 0.0
[[forces]]
at = "S"
direction = "y"
[[forces]]
at = "S"
direction = "z"
[[responses]]
name = "y"
at = "S"
direction = "y"
[[responses]]
name = "z"
at = "S"
direction = "z"
[sweep]
from = 10.0
to = 100.0
points = 11
spacing = "linear"
"#,
        beta * Z_LEFT,
        beta * Z_RIGHT
    );
    model::read(&text).unwrap().into_inner()
}

const MASS: f64 = 2.0;
const INERTIA: f64 = 0.02;
const SPRING: f64 = 1e5;
const Z_LEFT: f64 = 1e5;
const Z_RIGHT: f64 = 3e5;
const ARM_LEFT: f64 = 0.1;
const ARM_RIGHT: f64 = 0.15;

/// Expected, closed form of one degree of freedom: with r = f / `f_n`, |H| k = 1 / |1 - r^2 + 2 i zeta r| is largest at
/// r^2 = 1 - 2 zeta^2, where it is 1 / (2 zeta sqrt(1 - zeta^2)); it is that over sqrt 2 at
/// r^2 = 1 - 2 zeta^2 +- 2 zeta sqrt(1 - zeta^2).
#[test]
fn the_peak_of_one_degree_of_freedom_is_drawn_and_listed_at_any_damping() {
    let natural = (SPRING / MASS).sqrt();
    for exponent in 1..=11 {
        let zeta = 10f64.powi(-exponent);
        let root = (1.0 - zeta * zeta).sqrt();
        let model = grounded_mass(2.0 * zeta * natural * MASS, 1e-3);
        let modes = modes_of(vec![natural * Complex64::new(root, zeta)], 100.0);
        let frf = resolve(&model, &modes, &linear(10.0, 100.0, 11));
        let height = 1.0 / (2.0 * SPRING * zeta * root);
        let drawn = frf.columns[0]
            .values
            .iter()
            .map(|v| v.norm())
            .fold(0.0, f64::max);
        assert!(
            drawn * FACTOR > height && drawn < height * FACTOR,
            "{zeta:e}: {drawn:e} for {height:e}"
        );

        let found = peaks(&frf.frequencies, &frf.columns[0], &modes);
        let [peak] = found[..] else {
            panic!("{zeta:e}: {found:?}")
        };
        let r = (1.0 - 2.0 * zeta * zeta).sqrt();
        let phase = Complex64::new(1.0 - r * r, 2.0 * zeta * r)
            .inv()
            .arg()
            .to_degrees();
        let [lower, upper] = [-1.0, 1.0].map(|side| (r * r + side * 2.0 * zeta * root).sqrt());
        let damping = 0.5 * (upper - lower) / r;
        assert!((peak.frequency / (natural * r / TAU) - 1.0).abs() < 1e-3 * zeta);
        // The rounding of the frequency alone moves the height by 1e-16 / zeta.
        let tolerance = 1e-4 + 1e-14 / zeta;
        assert!(
            (peak.height / height - 1.0).abs() < tolerance,
            "{zeta:e}: {peak:?}, {height:e}"
        );
        assert!(
            (peak.phase.unwrap() - phase).abs() < 0.1,
            "{zeta:e}: {peak:?}, {phase}"
        );
        let measured = peak.half_power_damping.unwrap();
        assert!(
            (measured / damping - 1.0).abs() < 2e-3 + 1e-14 / zeta,
            "{zeta:e}: {measured:e}, {damping:e}"
        );
        assert_eq!(
            (peak.mode, peak.overlaps, peak.pole),
            (Some(0), false, false)
        );
    }
}

/// Expected, closed form: K and i omega beta K of two degrees of freedom (z, theta). With a force along z the response
/// z vanishes at the resonance of the rotation alone, with z fixed: `omega^2 J = K_theta (1 + i omega beta)`.
#[test]
fn an_anti_resonance_is_drawn_to_its_depth_at_any_damping() {
    let stiffness = [
        Z_LEFT + Z_RIGHT,
        Z_RIGHT * ARM_RIGHT - Z_LEFT * ARM_LEFT,
        Z_LEFT * ARM_LEFT * ARM_LEFT + Z_RIGHT * ARM_RIGHT * ARM_RIGHT,
    ];
    let held = (stiffness[2] / INERTIA).sqrt();
    for exponent in 1..=11 {
        let zeta = 10f64.powi(-exponent);
        let beta = 2.0 * zeta / held;
        let response = |hertz: f64| {
            let omega = TAU * hertz;
            let spring = Complex64::new(1.0, omega * beta);
            let [z, mixed, theta] = stiffness.map(|k| spring * k);
            let (z, theta) = (z - omega * omega * MASS, theta - omega * omega * INERTIA);
            theta / (z * theta - mixed * mixed)
        };
        let model = grounded_mass(1.0, beta);
        // det(K - lambda M) = 0, and omega^2 = lambda (1 + i omega beta) for each lambda.
        let [a, b, c] = [
            MASS * INERTIA,
            -(stiffness[0] * INERTIA + stiffness[2] * MASS),
            stiffness[0] * stiffness[2] - stiffness[1] * stiffness[1],
        ];
        let discriminant = (b * b - 4.0 * a * c).sqrt();
        let omegas = [-1.0, 1.0].map(|side| {
            let lambda: f64 = 0.5 * (-b + side * discriminant) / a;
            let ratio = 0.5 * beta * lambda.sqrt();
            lambda.sqrt() * Complex64::new((1.0 - ratio * ratio).sqrt(), ratio)
        });
        let modes = modes_of(omegas.into(), 150.0);
        let frf = resolve(&model, &modes, &linear(20.0, 150.0, 14));
        // The dip, by a scan of the closed form over two half-widths on both sides of the zero.
        let centre = held * (1.0 - zeta * zeta).sqrt() / TAU;
        let depth = linear(-2.0, 2.0, 4001)
            .into_iter()
            .map(|step| response(centre * (1.0 + step * zeta)).norm())
            .fold(f64::INFINITY, f64::min);
        let near = |f: f64| (f - centre).abs() <= 2.0 * zeta * centre;
        let rows = frf.frequencies.iter().zip(&frf.columns[1].values);
        let drawn = rows
            .filter(|(f, _)| near(**f))
            .map(|(_, v)| v.norm())
            .fold(f64::INFINITY, f64::min);
        let rounding = 1.0 + 1e-13 / zeta;
        assert!(
            drawn < depth * FACTOR * rounding && depth < drawn * FACTOR * rounding,
            "{zeta:e}: {drawn:e} for {depth:e}"
        );
    }
}

const PINNED_BEAM: &str = r#"
format = "beamtune/1"
title = "Pinned at both ends"
[beam]
length = 3.2
material = { young_modulus = 2.1e11, shear_modulus = 8e10, density = 7850.0, loss_factor = 0.0 }
[beam.section]
area = 0.0116
second_moment_y = 1.6625e-4
second_moment_z = 1.3745e-4
torsion_constant = 4.7657e-7
warping_constant = 2.2783e-8
polar_moment = 5.9992e-4
centroid_offset = 0.0619
[supports.left]
kind = "pinned"
[supports.right]
kind = "pinned"
[[forces]]
at = 0.7
direction = "w"
[[forces]]
at = 1.1
direction = "v"
[[responses]]
name = "w"
at = 1.3
direction = "w"
[[responses]]
name = "psi"
at = 2.0
direction = "psi"
[[responses]]
name = "v"
at = 1.1
direction = "v"
measure = "acceleration"
[[responses]]
name = "w far"
at = 2.9
direction = "w"
measure = "velocity"
[[responses]]
name = "E_V"
measure = "energy"
[sweep]
from = 5.0
to = 900.0
points = 400
spacing = "linear"
"#;

/// A pinned beam of the paper's section with a loss factor, and its modes up to 1 kHz.
///
/// Closed form (Gere & Lin, J. Appl. Mech. 25 (1958) 373): every motion is proportional to sin(n pi x / L); the loss
/// factor multiplies all squares by 1 + i eta.
fn pinned(eta: f64) -> (Model, Modes) {
    let mut model = model::read(PINNED_BEAM).unwrap().into_inner();
    model.beam.material.loss_factor = eta;
    let (material, s) = (model.beam.material, model.beam.section);
    let (mass, polar) = (material.density * s.area, material.density * s.polar_moment);
    let coupling = mass * s.centroid_offset;
    let mut omegas = Vec::new();
    for n in 1..=20 {
        let k2 = (f64::from(n) * PI / model.beam.length).powi(2);
        let w = material.young_modulus * s.second_moment_y * k2 * k2;
        let v = material.young_modulus * s.second_moment_z * k2 * k2;
        let psi = material.young_modulus * s.warping_constant * k2 * k2
            + material.shear_modulus * s.torsion_constant * k2;
        // (w - lambda mass)(psi - lambda polar) = (lambda coupling)^2
        let [a, b, c] = [
            mass * polar - coupling * coupling,
            -(w * polar + psi * mass),
            w * psi,
        ];
        let root = (b * b - 4.0 * a * c).sqrt();
        let larger = 0.5 * (-b + root) / a;
        omegas.extend([larger, c / (a * larger), v / mass]);
    }
    let to = 1000.0;
    let omegas = omegas
        .into_iter()
        .map(|square| (square * Complex64::new(1.0, eta)).sqrt())
        .filter(|omega| omega.norm() <= TAU * to)
        .collect();
    (model, modes_of(omegas, to))
}

/// The rows of `frequencies` at which |H| of a column has an extremum, and its kind: 1 for a maximum, -1 for a minimum.
fn turns(values: &[f64]) -> Vec<(usize, f64)> {
    (1..values.len() - 1)
        .filter_map(|i| {
            let [left, middle, right] = [values[i - 1], values[i], values[i + 1]];
            if left < middle && middle >= right {
                Some((i, 1.0))
            } else if left > middle && middle <= right {
                Some((i, -1.0))
            } else {
                None
            }
        })
        .collect()
}

fn sizes(column: &Column) -> Vec<f64> {
    column.values.iter().map(|v| v.norm()).collect()
}

/// Values below this share of a column may be rounding.
fn rounding(column: &Column) -> f64 {
    let largest = sizes(column).into_iter().fold(0.0, f64::max);
    match column.kind {
        ColumnKind::Energy => 1e-20 * largest,
        // A motion that is only rounding.
        ColumnKind::Complex if largest < 1e-13 => f64::INFINITY,
        ColumnKind::Complex => 1e-10 * largest,
    }
}

/// Scans between the neighbours of each extremum of each column: nothing there exceeds it by 0.05 dB. Poles and sharp
/// zeros, recognised by a width below `least` of the frequency, are skipped. Returns the number of scanned extrema.
fn assert_turns_are_drawn(model: &Model, frf: &Frf, least: f64) -> usize {
    const SCAN: usize = 60;
    let mut places = Vec::new();
    let mut frequencies = Vec::new();
    for (column, values) in frf.columns.iter().map(sizes).enumerate() {
        // Values that are exactly zero or only rounding have no extrema.
        let least_size = rounding(&frf.columns[column]);
        for (row, way) in turns(&values) {
            let (from, to) = (frf.frequencies[row - 1], frf.frequencies[row + 1]);
            if to - from > least * from && values[row] > least_size {
                places.push((column, row, way, values[row]));
                frequencies.extend(linear(from, to, SCAN));
            }
        }
    }
    let scanned = solved(model, &frequencies);
    for (index, &(column, row, way, drawn)) in places.iter().enumerate() {
        let values = &scanned.columns[column].values[index * SCAN..(index + 1) * SCAN];
        for (value, hertz) in values.iter().zip(&frequencies[index * SCAN..]) {
            let beyond = way * (value.norm() / drawn).ln();
            let (name, at) = (&frf.columns[column].name, frf.frequencies[row]);
            assert!(
                beyond < FACTOR.ln(),
                "{name}: turn drawn at {at:?} Hz, but {beyond:e} beyond at {hertz:?} Hz"
            );
        }
    }
    places.len()
}

/// Every maximum of a scan of every column, by more than 0.02 dB on both sides, is in the table of peaks, with its
/// height to 0.05 dB. Returns their number.
fn assert_no_peak_is_missing(frf: &Frf, scan: &Frf, modes: &Modes) -> usize {
    let mut count = 0;
    for (resolved, scanned) in frf.columns.iter().zip(&scan.columns) {
        let table = peaks(&frf.frequencies, resolved, modes);
        let values = sizes(scanned);
        let least_size = rounding(scanned);
        for (row, way) in turns(&values) {
            if way < 0.0 || values[row] < least_size || !stands_out(&values, row) {
                continue;
            }
            count += 1;
            let at = scan.frequencies[row];
            let step = scan.frequencies[row + 1] - scan.frequencies[row - 1] + 0.01 * at;
            let fits = |peak: &Peak| {
                (peak.frequency - at).abs() <= step
                    && (peak.pole || peak.height * FACTOR > values[row])
            };
            assert!(
                table.iter().any(fits),
                "{}: peak at {at:?} Hz: {table:?}",
                resolved.name
            );
        }
    }
    count
}

/// Whether the values fall from a maximum by 0.02 dB on both sides before they rise above it.
fn stands_out(values: &[f64], top: usize) -> bool {
    let level = values[top] * 10f64.powf(-0.02 / 20.0);
    let left: Vec<f64> = values[..top].iter().rev().copied().collect();
    [&left[..], &values[top + 1..]].into_iter().all(|side| {
        let end = side.iter().find(|&&v| v < level || v > values[top]);
        end.is_some_and(|&v| v < level)
    })
}

/// Frequencies within four half-widths of each mode, and some everywhere.
fn scan_frequencies(modes: &Modes, from: f64, to: f64) -> Vec<f64> {
    let mut all = linear(from, to, 1501);
    for mode in &modes.modes {
        let centre = mode.omega.re / TAU;
        let width = (mode.omega.im / TAU).max(1e-6 * centre);
        all.extend(
            linear(-4.0, 4.0, 64)
                .into_iter()
                .map(|t| centre + t * width),
        );
    }
    all.retain(|f| (from..=to).contains(f));
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

#[test]
fn every_peak_and_dip_of_a_damped_beam_is_drawn() {
    for exponent in 1..=7 {
        let (model, modes) = pinned(10f64.powi(-exponent));
        let base = linear(5.0, 900.0, 400);
        let frf = resolve(&model, &modes, &base);
        let turns = assert_turns_are_drawn(&model, &frf, 1e-12);
        let scan = solved(&model, &scan_frequencies(&modes, 5.0, 900.0));
        let found = assert_no_peak_is_missing(&frf, &scan, &modes);
        assert!(found >= 20 && turns >= 30, "{turns}, {found}");
    }
}

/// Expected: without damping (closed form as above) each peak is a pole at its mode's frequency, with points on both
/// sides and none on it; likewise dips go to zero.
#[test]
fn undamped_modes_are_poles() {
    let (model, modes) = pinned(0.0);
    let base = linear(5.0, 900.0, 400);
    let frf = resolve(&model, &modes, &base);
    assert!(frf.singular().is_empty());
    for column in &frf.columns {
        let table = peaks(&frf.frequencies, column, &modes);
        assert!(
            table.iter().filter(|peak| peak.pole).count() >= 3,
            "{}: {table:?}",
            column.name
        );
        for peak in &table {
            // Between two zeros a curve has a maximum without a mode.
            if peak.pole {
                let mode = &modes.modes[peak.mode.unwrap()];
                assert_eq!(peak.frequency, mode.omega.re / TAU);
                assert_eq!(
                    (peak.height, peak.phase, peak.overlaps),
                    (f64::INFINITY, None, false)
                );
                assert_eq!(peak.half_power_damping, None);
            } else {
                assert!(peak.height.is_finite() && peak.mode.is_none(), "{peak:?}");
            }
        }
    }
    for mode in &modes.modes {
        let pole = mode.omega.re / TAU;
        if (5.0..900.0).contains(&pole) {
            let above = frf.frequencies.partition_point(|&f| f < pole);
            for nearest in [
                pole - frf.frequencies[above - 1],
                frf.frequencies[above] - pole,
            ] {
                assert!(
                    nearest > 1e-10 * pole && nearest < 2e-9 * pole,
                    "{pole}: {nearest:e}"
                );
            }
        }
    }
    assert!(frf.frequencies.len() < base.len() + 80 * 5 * modes.modes.len());
    let turns = assert_turns_are_drawn(&model, &frf, 1e-7);
    assert!(turns > 20, "{turns}");
    let dips: Vec<f64> = frf.columns[..4]
        .iter()
        .map(|column| {
            let sizes = sizes(column);
            let (least, largest) = sizes
                .iter()
                .fold((f64::INFINITY, 0.0_f64), |(a, b), &v| (a.min(v), b.max(v)));
            least / largest
        })
        .collect();
    assert!(dips.iter().all(|&depth| depth < 1e-12), "{dips:?}");
}

/// Expected, closed form: all modes have the damping ratio eta / 2. In `E_V` each peak is so high above the share of
/// the other modes that its half-power band is its mode's.
#[test]
fn the_half_power_band_of_an_energy_is_that_of_its_mode() {
    let eta = 1e-7;
    let (model, modes) = pinned(eta);
    let frf = resolve(&model, &modes, &linear(5.0, 900.0, 400));
    let table = peaks(&frf.frequencies, &frf.columns[4], &modes);
    assert!(table.len() >= 12, "{table:?}");
    for peak in table {
        let mode = &modes.modes[peak.mode.unwrap()];
        assert!((mode.damping_ratio() / (0.5 * eta) - 1.0).abs() < 1e-3);
        let measured = peak.half_power_damping.unwrap();
        assert!((measured / (0.5 * eta) - 1.0).abs() < 0.005, "{peak:?}");
        assert_eq!((peak.phase, peak.overlaps, peak.pole), (None, false, false));
    }
}

#[test]
fn the_base_is_kept_and_points_are_added_between() {
    for (eta, points) in [(0.0, 2), (1e-7, 400), (0.03, 7)] {
        let (model, modes) = pinned(eta);
        let base = linear(7.3, 881.0, points);
        let frequencies = refined(&checked(&model), &modes, &base, &NEVER).unwrap();
        assert!(frequencies.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!((frequencies[0], frequencies.last()), (base[0], base.last()));
        let kept: Vec<u64> = base.iter().map(|f| f.to_bits()).collect();
        let all: Vec<u64> = frequencies.iter().map(|f| f.to_bits()).collect();
        assert!(kept.iter().all(|f| all.contains(f)));
        assert!(frequencies.len() > base.len() + modes.modes.len());
        let frf = resolve(&model, &modes, &base);
        assert_eq!(frf, solved(&model, &frequencies));
    }
}

/// A base grid of two points gives the same result as a fine one.
#[test]
fn a_coarse_base_loses_nothing() {
    let (model, modes) = pinned(1e-3);
    let frf = resolve(&model, &modes, &[5.0, 900.0]);
    assert_turns_are_drawn(&model, &frf, 1e-12);
    let scan = solved(&model, &scan_frequencies(&modes, 5.0, 900.0));
    assert!(assert_no_peak_is_missing(&frf, &scan, &modes) >= 20);
}

#[test]
fn nothing_is_returned_once_cancelled() {
    let (model, modes) = pinned(1e-3);
    let cancelled = AtomicBool::new(true);
    assert_eq!(
        refined(&checked(&model), &modes, &[5.0, 900.0], &cancelled),
        Err(Cancelled)
    );
    let base = solved(&model, &[5.0, 900.0]);
    assert_eq!(
        resolved(&checked(&model), &modes, base, &cancelled),
        Err(Cancelled)
    );
}

/// Expected: with equal inertia and stiffness along z and y and a loss factor, w and v of a section without offset have
/// the same modes (closed form); in the table they overlap. Alone they do not.
#[test]
fn modes_that_overlap_are_reported() {
    let (mut model, _) = pinned(1e-3);
    model.beam.section.centroid_offset = 0.0;
    let (material, s) = (model.beam.material, model.beam.section);
    let bending = |second_moment: f64, n: i32| {
        let k2 = (f64::from(n) * PI / model.beam.length).powi(2);
        let square = material.young_modulus * second_moment * k2 * k2 / (material.density * s.area);
        (square * Complex64::new(1.0, 1e-3)).sqrt()
    };
    for (ratio, overlaps) in [(1.0, true), (1.0 + 1e-3, true), (1.0 + 1e-2, false)] {
        let mut beam = model.clone();
        beam.beam.section.second_moment_z = s.second_moment_y * ratio;
        let modes = modes_of(
            (1..4)
                .flat_map(|n| {
                    [
                        bending(s.second_moment_y, n),
                        bending(s.second_moment_y * ratio, n),
                    ]
                })
                .collect(),
            500.0,
        );
        let frf = resolve(&beam, &modes, &linear(5.0, 450.0, 100));
        let w = peaks(&frf.frequencies, &frf.columns[0], &modes);
        assert_eq!(w.len(), 2, "{w:?}");
        for peak in w {
            assert_eq!(peak.overlaps, overlaps, "{ratio}: {peak:?}");
            // Alone in its column, the peak also has the loss factor's damping: eta / 2.
            assert!(
                (peak.half_power_damping.unwrap() / 5e-4 - 1.0).abs() < 0.02,
                "{peak:?}"
            );
        }
    }
}

/// A response that a symmetry cancels is only rounding: it turns at every other point, and the number of added points
/// is limited.
#[test]
fn rounding_is_not_resolved() {
    let (mut model, modes) = pinned(1e-3);
    let mut mirrored = model.forces[0].clone();
    let Target::Beam(place, _) = &mut mirrored.target else {
        panic!()
    };
    *place = Place::Position(model.beam.length - 0.7);
    mirrored.phase = 180.0;
    model.forces.push(mirrored);
    let Quantity::Motion(Target::Beam(place, _), _) = &mut model.responses[0].quantity else {
        panic!()
    };
    *place = Place::Position(0.5 * model.beam.length);
    let base = linear(5.0, 900.0, 400);
    let frf = resolve(&model, &modes, &base);
    let sizes = sizes(&frf.columns[0]);
    assert!(sizes.iter().fold(0.0, |a: f64, &b| a.max(b)) < 1e-15);
    assert!(turns(&sizes).len() > 200);
    model.responses.remove(0);
    let without = resolve(&model, &modes, &base);
    assert!(frf.frequencies.len() < 3 * without.frequencies.len());
}

/// Resolves the sweep of a model and compares it with dense scans. Extrema within `least` of their frequency are sharp.
fn assert_is_resolved(model: &Model, least: f64) {
    let (from, to) = (model.sweep.from, model.sweep.to);
    let base = frequencies(&model.sweep);
    let modes = solve::modes::modes(&checked(model), to, &NEVER).unwrap();
    let frf = resolve(model, &modes, &base);
    assert!(frf.singular().is_empty());
    let turns = assert_turns_are_drawn(model, &frf, least);
    let scan = solved(model, &scan_frequencies(&modes, from, to));
    let found = assert_no_peak_is_missing(&frf, &scan, &modes);
    println!(
        "{}: {} modes, {} rows more, {turns} turns, {found} peaks",
        model.title,
        modes.modes.len(),
        frf.frequencies.len() - base.len(),
    );
    assert!(found > 0);
}

#[test]
fn every_peak_and_dip_of_every_preset_is_drawn() {
    for preset in presets::ALL {
        assert_is_resolved(&model::read(preset.text).unwrap().into_inner(), 1e-7);
    }
}

/// Damping ratios down to 1e-8, and none.
#[test]
fn every_peak_and_dip_is_drawn_with_hardly_any_damping() {
    for (factor, least) in [(0.01, 1e-10), (0.0, 1e-7)] {
        for name in ["fig05a", "fig06", "fig13", "cantilever"] {
            let preset = presets::find(name).unwrap();
            let model = with_damping(model::read(preset.text).unwrap().into_inner(), factor);
            assert_is_resolved(&model, least);
        }
    }
}

/// The same with all damping times `factor`.
fn with_damping(mut model: Model, factor: f64) -> Model {
    model.beam.material.loss_factor *= factor;
    for subsystem in &mut model.subsystems {
        let [left, right] = [&mut subsystem.z_left, &mut subsystem.z_right];
        for spring in [&mut subsystem.y_left, &mut subsystem.y_right, left, right] {
            spring.damping *= factor;
        }
    }
    for support in [&mut model.supports.left, &mut model.supports.right] {
        for restraint in &mut support.restraints {
            if let Restraint::Elastic(elastic) = restraint {
                elastic.spring.damping *= factor;
            }
        }
    }
    model
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, rng_seed: RngSeed::Fixed(3), ..ProptestConfig::default() })]

    /// Random beams, supports and subsystems under a force, with two responses, on a coarse base grid.
    #[test]
    fn every_peak_and_dip_of_random_models_is_drawn(
        model in common::models_of_one_offset(),
        force in common::targets(),
        seen in [common::targets(), common::targets()],
        lighter in prop_oneof![Just(1.0), Just(1e-3)],
    ) {
        let mut model = with_damping(model, lighter);
        let [force, first, second] = [force, seen[0].clone(), seen[1].clone()].map(|target| {
            if common::exists(&model, &target) { target } else { Target::Beam(Place::Position(1.0), BeamMotion::W) }
        });
        model.forces = vec![common::unit_force(force)];
        let quantities = [Quantity::Motion(first, Measure::Displacement), Quantity::Motion(second, Measure::Velocity), Quantity::Energy];
        model.responses = quantities.into_iter().enumerate().map(|(index, quantity)| Response {
            name: format!("R{index}"),
            enabled: true,
            quantity, point: beamtune::model::Point::AXIS, over: None, }).collect();
        model.sweep = Sweep { from: 3.0, to: 300.0, points: 60, spacing: Spacing::Linear };
        assert_is_resolved(&model, 1e-10);
    }
}

//! Levels in a band against closed forms and dense sums.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "common/checked.rs"]
mod checked;

use checked::checked;
use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use beamtune::model::{
    self, BeamMotion, Elastic, Force, Measure, Model, Place, Quantity, Response, Restraint, Spring,
    Support, Target,
};
use beamtune::presets;
use beamtune::solve::band::{Level, levels};
use beamtune::solve::modes::{Modes, modes};
use beamtune::solve::peaks::{peaks, resolved};
use beamtune::solve::{Cancelled, ColumnKind, sweep};
use num_complex::Complex64;

static NEVER: AtomicBool = AtomicBool::new(false);

fn preset(name: &str) -> Model {
    model::read(presets::find(name).unwrap().text)
        .unwrap()
        .into_inner()
}

fn solved_modes(model: &Model, to: f64) -> Modes {
    modes(&checked(model), to, &NEVER).unwrap()
}

fn levels_of(model: &Model, band: [f64; 2]) -> Vec<Level> {
    levels(&checked(model), &solved_modes(model, band[1]), band, &NEVER).unwrap()
}

fn motion(x: f64, motion: BeamMotion, measure: Measure) -> Response {
    Response {
        name: format!("{x} {motion:?} {measure:?}"),
        enabled: true,
        quantity: Quantity::Motion(Target::Beam(Place::Position(x), motion), measure),
        point: beamtune::model::Point::AXIS,
        over: None,
    }
}

fn near(got: f64, want: f64, tolerance: f64, what: &str) {
    let error = (got / want - 1.0).abs();
    assert!(
        error <= tolerance,
        "{what}: {got:e} for {want:e}, off by {error:e}"
    );
}

/// A single degree of freedom: m, c, k.
#[derive(Clone, Copy)]
struct Single {
    mass: f64,
    damping: f64,
    stiffness: f64,
}

impl Single {
    /// int |1 / (k - m w^2 + i c w)|^2 dw: with the root p of k - m w^2 + i c w it is
    /// Im(1/(2p) ln((w - p)/(w + p))) / (m^2 Im p^2), by partial fractions.
    fn integral(self, from: f64, to: f64) -> f64 {
        let p = self.root();
        let antiderivative = |omega: f64| ((omega - p).ln() - (omega + p).ln()) / (2.0 * p);
        let difference = antiderivative(to) - antiderivative(from);
        difference.im / (self.mass * self.mass * (p * p).im)
    }

    /// The root of the characteristic polynomial with Re > 0 and Im > 0.
    fn root(self) -> Complex64 {
        let decay = self.damping / (2.0 * self.mass);
        let square = self.stiffness / self.mass - decay * decay;
        Complex64::new(square.sqrt(), decay)
    }

    fn damping_ratio(self) -> f64 {
        self.damping / (2.0 * (self.stiffness * self.mass).sqrt())
    }

    fn receptance(self, omega: f64) -> f64 {
        let stiffness = self.stiffness - self.mass * omega * omega;
        Complex64::new(stiffness, self.damping * omega)
            .norm()
            .recip()
    }
}

/// A beam so stiff that it is a rigid mass on two springs, 500 N/m each, with a force in the middle.
fn rigid(damping: f64) -> (Model, Single) {
    let mut model = preset("fig06");
    let half = Elastic {
        spring: Spring {
            stiffness: 500.0,
            damping: damping / 2.0,
            ..Spring::default()
        },
        inertia: 0.0,
    };
    let mut support = Support::FREE;
    support[BeamMotion::W] = Restraint::Elastic(half);
    support[BeamMotion::Psi] = Restraint::Fixed;
    support[BeamMotion::V] = Restraint::Fixed;
    (model.supports.left, model.supports.right) = (support.clone(), support);
    model.beam.material.young_modulus *= 1e4;
    model.beam.section.centroid_offset = 0.0;
    let middle = model.beam.length / 2.0;
    model.forces = vec![Force {
        enabled: true,
        target: Target::Beam(Place::Position(middle), BeamMotion::W),
        amplitude: 1.0,
        phase: 0.0,
        point: beamtune::model::Point::AXIS,
    }];
    model.responses = vec![
        motion(middle, BeamMotion::W, Measure::Displacement),
        motion(middle, BeamMotion::W, Measure::Velocity),
        Response {
            name: "E_V".to_owned(),
            enabled: true,
            quantity: Quantity::Energy,
            point: beamtune::model::Point::AXIS,
            over: None,
        },
        motion(middle, BeamMotion::V, Measure::Displacement),
    ];
    let mass = model.beam.material.density * model.beam.section.area * model.beam.length;
    let single = Single {
        mass,
        damping,
        stiffness: 1000.0,
    };
    (model, single)
}

#[test]
fn the_closed_form_itself_is_that_of_a_whole_band() {
    // Closed form: over all frequencies int |H|^2 dw = pi / (2 c k) (Crandall & Mark 1963).
    let single = rigid(20.0).1;
    let whole = single.integral(0.0, 1e9);
    near(whole, TAU / 4.0 / (20.0 * 1000.0), 1e-9, "whole band");
}

#[test]
fn a_rigid_mass_on_springs_has_the_levels_of_one_degree_of_freedom() {
    // Closed form: partial fractions as above; the maximum 1 / (2 zeta k sqrt(1 - zeta^2)) is at w0 sqrt(1 - 2 zeta^2).
    // The beam's own bending adds some 1e-9.
    for damping in [200.0, 20.0, 0.1] {
        let (model, single) = rigid(damping);
        let natural = single.root().norm() / TAU;
        for band in [
            [0.1, 1.0],
            [0.1, 0.9 * natural],
            [natural, 1.0],
            [0.99 * natural, 1.01 * natural],
        ] {
            let [from, to] = band.map(|f| TAU * f);
            let found = levels_of(&model, band);
            let mean = single.integral(from, to) / (to - from);
            let what = format!("c = {damping}, {band:?}");
            let zeta = single.damping_ratio();
            // If the band ends at a resonance, the resonance's shift relative to its width matters.
            let cut = if band.contains(&natural) {
                1e-9 / zeta
            } else {
                0.0
            };
            near(found[0].mean_square, mean, 3e-8 + cut, &what);
            near(found[2].mean_square, mean * single.mass, 3e-8 + cut, &what);
            let at = (natural * (1.0 - 2.0 * zeta * zeta).sqrt()).clamp(band[0], band[1]);
            near(found[0].maximum, single.receptance(TAU * at), 1e-8, &what);
            near(
                found[2].maximum,
                single.mass * single.receptance(TAU * at).powi(2),
                2e-8,
                &what,
            );
            near(found[0].at, at, 1e-5, &what);
            // Velocity: the maximum 1/c is at w0 exactly.
            let at = natural.clamp(band[0], band[1]);
            near(
                found[1].maximum,
                TAU * at * single.receptance(TAU * at),
                1e-8,
                &what,
            );
            // Nothing moves along v.
            assert_eq!((found[3].maximum, found[3].mean_square), (0.0, 0.0));
        }
    }
}

#[test]
fn levels_are_those_of_dense_sums_and_of_the_peak_table() {
    // Independent sources: the trapezoidal rule at 0.005 Hz, a sixtieth of the narrowest half-width; the peak table.
    for (name, band) in [
        ("fig05a", [20.0, 160.0]),
        ("fig08", [3.0, 120.0]),
        ("hundred_absorbers", [40.0, 60.0]),
    ] {
        let mut model = preset(name);
        model.beam.material.loss_factor = 0.02;
        let all = solved_modes(&model, band[1]);
        let steps = ((band[1] - band[0]) / 0.005) as usize;
        let step = (band[1] - band[0]) / steps as f64;
        let grid: Vec<f64> = (0..=steps).map(|i| band[0] + step * i as f64).collect();
        let dense = sweep(&checked(&model), &grid, &NEVER).unwrap();
        let base = sweep(
            &checked(&model),
            &[band[0], 0.5 * (band[0] + band[1]), band[1]],
            &NEVER,
        )
        .unwrap();
        let fine = resolved(&checked(&model), &all, base, &NEVER).unwrap();
        let found = levels(&checked(&model), &all, band, &NEVER).unwrap();
        assert_eq!(found.len(), dense.columns.len());
        for ((level, dense), fine_column) in found.iter().zip(&dense.columns).zip(&fine.columns) {
            let power = |value: &Complex64| match dense.kind {
                ColumnKind::Complex => value.norm_sqr(),
                ColumnKind::Energy => value.re,
            };
            let squares = dense.values.iter().map(power);
            let ends = 0.5 * (power(&dense.values[0]) + power(&dense.values[steps]));
            let mean = (squares.sum::<f64>() - ends) / steps as f64;
            near(
                level.mean_square,
                mean,
                1e-6,
                &format!("{name} {}", dense.name),
            );
            let sampled = dense.values.iter().map(|h| h.norm()).fold(0.0, f64::max);
            assert!(
                level.maximum >= sampled * (1.0 - 1e-12),
                "{name} {}",
                dense.name
            );
            near(
                level.maximum,
                sampled,
                1e-3,
                &format!("{name} {}", dense.name),
            );
            let table = peaks(&fine.frequencies, fine_column, &all);
            let ends = [0, fine.frequencies.len() - 1].map(|i| fine_column.values[i].norm());
            let highest = table
                .iter()
                .map(|peak| peak.height)
                .chain(ends)
                .fold(0.0, f64::max);
            near(
                level.maximum,
                highest,
                2e-3,
                &format!("{name} {} table", dense.name),
            );
        }
    }
}

#[test]
fn an_undamped_resonance_in_the_band_is_infinite_where_it_shows() {
    // Closed form: a pinned beam without offset and damping; v resonates at n^2 pi / (2 L^2) sqrt(E Iz / rho A), even n
    // have a node in the middle, and a force along v moves neither w nor psi.
    let mut model = preset("fig06");
    (model.supports.left, model.supports.right) = (Support::PINNED, Support::PINNED);
    model.beam.section.centroid_offset = 0.0;
    let length = model.beam.length;
    model.forces = vec![Force {
        enabled: true,
        target: Target::Beam(Place::Position(length / 3.0), BeamMotion::V),
        amplitude: 1.0,
        phase: 0.0,
        point: beamtune::model::Point::AXIS,
    }];
    model.responses = vec![
        motion(length / 4.0, BeamMotion::V, Measure::Displacement),
        motion(length / 2.0, BeamMotion::V, Measure::Displacement),
        motion(length / 4.0, BeamMotion::W, Measure::Displacement),
    ];
    let (material, section) = (model.beam.material, model.beam.section);
    let bending = material.young_modulus * section.second_moment_z;
    let first =
        TAU / (4.0 * length * length) * (bending / (material.density * section.area)).sqrt();
    let found = levels_of(&model, [1.1 * first, 5.0 * first]);
    assert_eq!(
        (found[0].maximum, found[0].mean_square),
        (f64::INFINITY, f64::INFINITY)
    );
    near(found[0].at, 4.0 * first, 1e-9, "second mode");
    assert!(found[1].maximum.is_finite() && found[1].mean_square.is_finite());
    assert_eq!((found[2].maximum, found[2].mean_square), (0.0, 0.0));
    // Between the resonances, the mean is that of Simpson's rule.
    let band = [1.5 * first, 3.5 * first];
    let found = levels_of(&model, band);
    let steps = 4000;
    let grid: Vec<f64> = (0..=steps)
        .map(|i| band[0] + (band[1] - band[0]) * f64::from(i) / f64::from(steps))
        .collect();
    let dense = sweep(&checked(&model), &grid, &NEVER).unwrap();
    for (level, column) in found.iter().zip(&dense.columns).take(2) {
        let weight = |i: usize| {
            if i == 0 || i == 4000 {
                1.0
            } else {
                2.0 + 2.0 * (i % 2) as f64
            }
        };
        let sum: f64 = column
            .values
            .iter()
            .enumerate()
            .map(|(i, h)| weight(i) * h.norm_sqr())
            .sum();
        near(
            level.mean_square,
            sum / (3.0 * f64::from(steps)),
            1e-7,
            "between the resonances",
        );
    }
    // At its end, too.
    let at_end = levels_of(&model, [first, 2.0 * first]);
    assert_eq!(at_end[0].mean_square, f64::INFINITY);
}

#[test]
fn nothing_comes_of_a_cancelled_one_and_of_no_response() {
    let mut model = preset("fig05a");
    let all = solved_modes(&model, 100.0);
    assert_eq!(
        levels(
            &checked(&model),
            &all,
            [10.0, 100.0],
            &AtomicBool::new(true)
        ),
        Err(Cancelled)
    );
    model.responses.clear();
    assert_eq!(
        levels(&checked(&model), &all, [10.0, 100.0], &NEVER),
        Ok(Vec::new())
    );
}

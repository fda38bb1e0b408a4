//! Reactions, internal forces, spring forces, stretches and ratios: the laws that they obey, and a second way to them.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "common/checked.rs"]
mod checked;
#[allow(dead_code)]
#[path = "common/mod.rs"]
mod common;
#[path = "common/quantities.rs"]
mod quantities;

use checked::checked;
use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use beamtune::model::{
    Across, BeamMotion, Elastic, Force, Holder, InnerSupport, Measure, Model, Place, Point,
    Quantity, Reaction, Restraint, Spring, SpringMeasure, SpringName, Support, SupportId, Target,
    read,
};
use beamtune::solve::operating::operating;
use beamtune::{presets, solve};
use common::unit_force;
use num_complex::Complex64;
use proptest::prelude::*;
use quantities::{internal_forces, reactions, response, springs};

fn preset(name: &str) -> Model {
    read(presets::find(name).unwrap().text)
        .unwrap()
        .into_inner()
}

/// The values of some quantities at a frequency, Hz.
fn values(model: &Model, all: &[Quantity], hertz: f64) -> Vec<Complex64> {
    let mut model = model.clone();
    model.responses = all.iter().cloned().map(response).collect();
    let frf = solve::sweep(&checked(&model), &[hertz], &AtomicBool::new(false)).unwrap();
    frf.columns.iter().map(|column| column.values[0]).collect()
}

fn beam(x: f64, motion: BeamMotion) -> Target {
    Target::Beam(Place::Position(x), motion)
}

/// The size of a force or moment as a force on an arm of a metre.
fn largest(all: &[Complex64]) -> f64 {
    all.iter().map(|value| value.norm()).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, rng_seed: prop::test_runner::RngSeed::Fixed(9), failure_persistence: None, ..ProptestConfig::default() })]

    /// Expected: the state of the whole beam at one frequency, which evaluates the waves of each span and finds springs and
    /// reactions from them in its own way.
    #[test]
    fn they_are_those_of_the_operating_state(
        (model, force, hertz) in (common::models(), common::targets(), common::frequencies()),
    ) {
        prop_assume!(common::exists(&model, &force));
        let model = Model { forces: vec![unit_force(force)], ..model };
        let state = operating(&checked(&model), hertz, 2);
        let found = values(&model, &springs(&model), hertz);
        let all = state.masses.iter().flat_map(|mass| [mass.forces, mass.stretches].concat());
        let expected: Vec<Complex64> = all.map(|of| -of).collect();
        for (measure, (found, expected)) in found.chunks(4).zip(expected.chunks(4)).enumerate() {
            // What nothing couples with the load is only rounding: newtons, or metres.
            let least = [1e-6, 1e-11][measure % 2];
            let size = largest(expected).max(least);
            for (found, expected) in found.iter().zip(expected) {
                prop_assert!((found - expected).norm() < 1e-9 * size, "{found} {expected} {measure}");
            }
        }
        let found = values(&model, &reactions(&model), hertz);
        let supports = SupportId::all(&model).zip(&state.reactions);
        for ((id, of_support), found) in supports.zip(found.chunks(6)) {
            let size = largest(of_support).max(1e-3);
            for (motion, (total, found)) in BeamMotion::ALL.into_iter().zip(of_support.iter().zip(found)) {
                // The state has springs and inertias together.
                let restraint = id.support(&model)[motion].clone();
                let elastic = restraint.elastic();
                let omega = TAU * hertz;
                let spring = Complex64::new(
                    elastic.spring.stiffness,
                    elastic.spring.stiffness * elastic.spring.loss_factor + omega * elastic.spring.damping,
                );
                let share = match restraint {
                    Restraint::Elastic(_) if spring == Complex64::ZERO => Complex64::ZERO,
                    Restraint::Elastic(_) => spring / (spring - omega * omega * elastic.inertia),
                    Restraint::Free | Restraint::Fixed => Complex64::ONE,
                };
                let expected = -total * share;
                prop_assert!((found - expected).norm() < 1e-8 * size, "{found} {expected} {motion:?} {id:?}");
            }
        }
    }

    /// Expected: a load F makes the internal force jump by -F.
    #[test]
    fn internal_forces_jump_over_a_load(
        (model, x, hertz) in (common::models(), 0.05..common::LENGTH - 0.05, common::frequencies()),
        motion in prop::sample::select(vec![BeamMotion::W, BeamMotion::Psi, BeamMotion::V, BeamMotion::WSlope]),
    ) {
        let acts = |at: f64| (at - x).abs() < 1e-3;
        prop_assume!(!model.subsystems.iter().any(|of| acts(of.position)));
        prop_assume!(!model.supports.inner.iter().any(|of| acts(of.position)));
        prop_assume!(!model.joints.iter().any(|of| acts(of.position)));
        let force = Force { amplitude: 7.0, ..unit_force(beam(x, motion)) };
        let model = Model { forces: vec![force], ..model };
        let places = [Place::Position(x - 1e-9), Place::Position(x)];
        let found = values(&model, &internal_forces(&places), hertz);
        let row = motion as usize;
        let jump = found[6 + row] - found[row];
        let size = found.iter().map(|of| of.norm()).fold(7.0, f64::max);
        // Over a nanometre the forces change by about a billionth.
        prop_assert!((jump + 7.0).norm() < 1e-6 * size, "{jump}");
    }
}

/// Expected: equilibrium at rest. The inertia of the beam at a millihertz is 1e-9 of the load and less.
#[test]
fn reactions_carry_the_loads_at_rest() {
    for name in ["cantilever", "fig06"] {
        let mut model = preset(name);
        model.supports.left[BeamMotion::W] = Restraint::Fixed;
        model.supports.left[BeamMotion::V] = Restraint::Fixed;
        model.supports.left[BeamMotion::Psi] = Restraint::Fixed;
        model.supports.left[BeamMotion::WSlope] = Restraint::Fixed;
        model.supports.left[BeamMotion::VSlope] = Restraint::Fixed;
        model.supports.right[BeamMotion::V] = Restraint::Elastic(Elastic {
            spring: Spring {
                stiffness: 3e6,
                damping: 10.0,
                loss_factor: 0.1,
                ..Spring::default()
            },
            inertia: 4.0,
        });
        let load = |motion, amplitude| Force {
            amplitude,
            ..unit_force(beam(0.37 * model.length(), motion))
        };
        model.forces = vec![load(BeamMotion::W, 3.0), load(BeamMotion::V, -2.0)];
        let ground = Across::ALL.map(|across| Quantity::Reaction(Reaction::Ground(across)));
        let found = values(&model, &ground, 1e-3);
        assert!((found[0] - 3.0).norm() < 3e-9, "{name}: {found:?}");
        assert!((found[1] + 2.0).norm() < 3e-9, "{name}: {found:?}");
    }
}

/// Expected: a spring of 1e12 N/m holds as a fixed motion does, to its deflection, and one of 1e16 N/m to the last digits.
#[test]
fn a_stiff_spring_holds_like_a_fixed_motion() {
    for holder in [Holder::Left, Holder::Right, Holder::Inner("B".to_owned())] {
        let mut model = preset("fig06");
        if let Holder::Inner(name) = &holder {
            model.supports.inner = vec![InnerSupport {
                name: name.clone(),
                position: 0.43 * model.length(),
                support: Support::FREE,
            }];
        }
        model.forces = vec![unit_force(beam(0.3 * model.length(), BeamMotion::W))];
        let id = SupportId::all(&model)
            .find(|id| id.name(&model) == holder.name())
            .unwrap();
        id.support_mut(&mut model).point = Point { y: 0.0, z: 0.03 };
        let all = [BeamMotion::W, BeamMotion::Psi]
            .map(|motion| Quantity::Reaction(Reaction::Support(holder.clone(), motion)));
        let mut at = |restraint: Restraint, hertz| {
            let support = id.support_mut(&mut model);
            (support[BeamMotion::W], support[BeamMotion::Psi]) = (restraint.clone(), restraint);
            values(&model, &all, hertz)
        };
        for hertz in [3.0, 61.0, 470.0] {
            let fixed = at(Restraint::Fixed, hertz);
            for (stiffness, allowed) in [(1e12, 1e-2), (1e16, 1e-6), (1e22, 1e-9)] {
                let spring = Elastic {
                    spring: Spring {
                        stiffness,
                        ..Spring::default()
                    },
                    ..Elastic::default()
                };
                let stiff = at(Restraint::Elastic(spring), hertz);
                for (stiff, fixed) in stiff.iter().zip(&fixed) {
                    let error = (stiff - fixed).norm() / largest(&[*fixed]);
                    assert!(
                        error < allowed,
                        "{holder:?} {hertz} Hz {stiffness:e}: {error:e}"
                    );
                }
            }
        }
    }
}

/// Expected: the definition.
#[test]
fn a_ratio_is_a_quotient_and_its_divisor_need_not_be_enabled() {
    let mut model = preset("fig05a");
    let name = model.subsystems[0].name.clone();
    let stretch = Quantity::Spring(name, SpringName::YLeft, SpringMeasure::Stretch);
    let tip = Quantity::Motion(Target::Beam(Place::Right, BeamMotion::W), Measure::Velocity);
    model.responses = vec![response(stretch), response(tip)];
    let frequencies: Vec<f64> = (1..60).map(|step| 3.0 * f64::from(step)).collect();
    let solve = |model: &Model| {
        solve::sweep(&checked(model), &frequencies, &AtomicBool::new(false)).unwrap()
    };
    let alone = solve(&model);
    model.responses[0].over = Some(model.responses[1].name.clone());
    for enabled in [true, false] {
        model.responses[1].enabled = enabled;
        let ratio = solve(&model);
        assert_eq!(ratio.columns.len(), 1 + usize::from(enabled));
        for (row, value) in ratio.columns[0].values.iter().enumerate() {
            let quotient = alone.columns[0].values[row] / alone.columns[1].values[row];
            assert!((value - quotient).norm() < 1e-13 * quotient.norm());
        }
    }
}

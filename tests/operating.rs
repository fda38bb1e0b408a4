//! The operating state at one frequency, against balances of force and power, closed forms and the responses.

#![allow(clippy::unwrap_used, clippy::expect_used)]

// Other tests use the rest of it.
#[allow(dead_code)]
mod common;

#[path = "common/checked.rs"]
mod checked;

use checked::checked;
use std::f64::consts::{PI, TAU};

use beamtune::model::{
    self, BeamMotion, Bedding, Elastic, Force, Joint, MassMotion, Model, Place, Restraint, Spring,
    Support, SupportId, Target,
};
use beamtune::presets;
use beamtune::solve::operating::{Damper, Operating, operating};
use common::{LENGTH, exists, frequencies, models_with_branches, respond, targets, unit_force};
use num_complex::Complex64;
use proptest::prelude::*;

fn preset(name: &str) -> Model {
    model::read(presets::find(name).unwrap().text)
        .unwrap()
        .into_inner()
}

/// A bare beam of the paper's section.
fn bare(left: Support, right: Support, forces: Vec<Force>) -> Model {
    let mut model = preset("fig06");
    model.subsystems.clear();
    model.responses.clear();
    model.supports.left = left;
    model.supports.right = right;
    model.forces = forces;
    model
}

fn force(place: Place, motion: BeamMotion, amplitude: f64) -> Force {
    Force {
        amplitude,
        ..unit_force(Target::Beam(place, motion))
    }
}

fn value(force: &Force) -> Complex64 {
    Complex64::from_polar(force.amplitude, force.phase.to_radians())
}

/// Loads on the beam with their positions, m.
fn beam_loads(model: &Model) -> Vec<(f64, BeamMotion, Complex64)> {
    let loads = model.forces.iter().filter(|force| force.enabled);
    loads
        .filter_map(|force| match force.target {
            Target::Beam(place, motion) => {
                let x = match place {
                    Place::Left => 0.0,
                    Place::Right => model.beam.length,
                    Place::Position(x) => x,
                };
                Some((x, motion, value(force)))
            }
            Target::Mass(..) => None,
        })
        .collect()
}

fn mass_load(model: &Model, name: &str, motion: MassMotion) -> Complex64 {
    let target = Target::Mass(name.to_owned(), motion);
    let loads = model
        .forces
        .iter()
        .filter(|f| f.enabled && f.target == target);
    loads.map(value).sum()
}

/// Loads with phases on a random model.
fn loaded() -> impl Strategy<Value = Model> {
    let loads = prop::collection::vec((targets(), 0.1..10.0, -180.0..180.0), 1..4);
    (models_with_branches(), loads).prop_map(|(mut model, loads)| {
        let kept = loads
            .into_iter()
            .filter(|(target, ..)| exists(&model, target));
        model.forces = kept
            .map(|(target, amplitude, phase)| Force {
                enabled: true,
                target,
                amplitude,
                phase,
                point: beamtune::model::Point::AXIS,
            })
            .collect();
        if model.forces.is_empty() {
            model.forces = vec![force(Place::Left, BeamMotion::W, 1.0)];
        }
        model
    })
}

fn assert_near(got: Complex64, want: Complex64, tolerance: f64, what: &str) {
    assert!(
        (got - want).norm() <= tolerance,
        "{what}: {got} for {want}, off by {:e} of {tolerance:e}",
        (got - want).norm()
    );
}

/// Both sides of every position that occurs twice, as indices.
fn joints(found: &Operating) -> Vec<[usize; 2]> {
    let pairs = found.positions.windows(2).enumerate();
    pairs
        .filter(|(_, pair)| pair[0] == pair[1])
        .map(|(left, _)| [left, left + 1])
        .collect()
}

#[test]
fn places_are_the_grid_and_both_sides_of_every_joint() {
    // fig05b: subsystems at 0.8, 1.6, 2.4 m, the force at 1.2 m; a fourth of 3.2 m is the first joint.
    let found = operating(&checked(&preset("fig05b")), 50.0, 5);
    assert_eq!(
        found.positions,
        [0.0, 0.8, 0.8, 1.2, 1.2, 1.6, 1.6, 2.4, 2.4, 3.2]
    );
    let mut at_ends = preset("fig05b");
    at_ends.subsystems[0].position = 0.0;
    at_ends.subsystems[2].position = 3.2;
    assert_eq!(
        operating(&checked(&at_ends), 50.0, 2).positions,
        [0.0, 0.0, 1.2, 1.2, 1.6, 1.6, 3.2, 3.2]
    );
}

#[test]
fn motions_are_those_of_the_responses() {
    // Independent source: the same model with responses at positions where it has none.
    for name in ["fig05b", "fig08", "hundred_absorbers"] {
        let model = preset(name);
        for hertz in [3.0, 77.0, 390.0] {
            let found = operating(&checked(&model), hertz, 12);
            for motion in BeamMotion::ALL {
                let at: Vec<Target> = found
                    .positions
                    .iter()
                    .map(|&x| Target::Beam(Place::Position(x), motion))
                    .collect();
                let want = respond(&model, model.forces.clone(), &at, hertz);
                let column = &found.motion[motion as usize];
                let largest = want.iter().map(|u| u.norm()).fold(0.0, f64::max);
                for (got, want) in column.iter().zip(want) {
                    assert_near(*got, want, 1e-10 * largest, &format!("{name} {motion:?}"));
                }
            }
            for state in &found.masses {
                let at = MassMotion::ALL.map(|motion| Target::Mass(state.name.clone(), motion));
                let want = respond(&model, model.forces.clone(), &at, hertz);
                for (got, want) in state.motion.iter().zip(want) {
                    assert_near(*got, want, 1e-10 * want.norm(), &state.name);
                }
            }
        }
    }
}

/// Gauss-Legendre with eight points on [-1, 1], its positive half (Abramowitz & Stegun 1964, Table 25.4).
const RULE: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_26),
];

/// Integrals along the beam of w, psi, v, of the rotations along w and v, and of x w, x psi, x v, from responses at the
/// points of a quadrature.
fn integrals(model: &Model, found: &Operating) -> [Complex64; 8] {
    // Enough points for torsion waves of 3 cm, the shortest of the random models.
    const PANEL: f64 = 0.02;
    let mut places = found.positions.clone();
    places.dedup();
    let mut samples = Vec::new();
    for pair in places.windows(2) {
        let panels = ((pair[1] - pair[0]) / PANEL).ceil() as usize;
        let half = 0.5 * (pair[1] - pair[0]) / panels as f64;
        for panel in 0..panels {
            let middle = pair[0] + half * (2 * panel + 1) as f64;
            for (node, weight) in RULE {
                samples.push((middle - half * node, weight * half));
                samples.push((middle + half * node, weight * half));
            }
        }
    }
    let motions = [
        BeamMotion::W,
        BeamMotion::Psi,
        BeamMotion::V,
        BeamMotion::WSlope,
        BeamMotion::VSlope,
    ];
    let at: Vec<Target> = samples
        .iter()
        .flat_map(|&(x, _)| motions.map(|motion| Target::Beam(Place::Position(x), motion)))
        .collect();
    let values = respond(model, model.forces.clone(), &at, found.frequency);
    let mut sums = [Complex64::ZERO; 8];
    for ((x, weight), q) in samples.iter().zip(values.chunks(5)) {
        for row in 0..5 {
            sums[row] += *weight * q[row];
        }
        for row in 0..3 {
            sums[row + 5] += *weight * x * q[row];
        }
    }
    sums
}

/// The jumps of the centroid along y and z over each joint. The axial force has no arm there: a jump of a displacement
/// stretches nothing.
fn jumps_over_joints(model: &Model, found: &Operating) -> Vec<[Complex64; 2]> {
    let section = &model.beam.section;
    let of_joint = |joint: &Joint| {
        let mut places = found.positions.iter();
        let left = places.position(|x| *x == joint.position).unwrap();
        let [w, psi, v] = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V].map(|motion| {
            let column = &found.motion[motion as usize];
            column[left + 1] - column[left]
        });
        [
            w + section.centroid_offset * psi,
            v - section.centroid_offset_y * psi,
        ]
    };
    model.joints.iter().map(of_joint).collect()
}

/// All forces on the beam along w, psi and v, and about its left end; the inertia of the beam included.
fn assert_in_balance(model: &Model, found: &Operating) {
    let (beam, section) = (&model.beam, &model.beam.section);
    let (omega, density) = (TAU * found.frequency, model.beam.material.density);
    let square = omega * omega;
    let mass = square * density * section.area;
    let (along_z, along_y) = (
        mass * section.centroid_offset,
        mass * section.centroid_offset_y,
    );
    let polar = square * density * section.polar_moment;
    let [w, psi, v, w_turned, v_turned, xw, xpsi, xv] = integrals(model, found);
    let bedded = |bedding: Bedding| {
        bedding.stiffness * Complex64::new(1.0, bedding.loss_factor)
            + Complex64::I * omega * bedding.damping
    };
    let foundation = &beam.foundation;
    let [on_w, on_psi, on_v] = [foundation.w, foundation.psi, foundation.v].map(bedded);
    // A section that turns has rotary inertia, and an axial force has an arm where the centroids move apart.
    let turning = if beam.theory.has_rotary_inertia() {
        square * density
    } else {
        0.0
    };
    let displacements = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V];
    let ends = [Place::Left, Place::Right].map(|place| {
        let at = displacements.map(|motion| Target::Beam(place, motion));
        let moved = respond(model, model.forces.clone(), &at, found.frequency);
        let [w, psi, v] = [moved[0], moved[1], moved[2]];
        [
            w + section.centroid_offset * psi,
            v - section.centroid_offset_y * psi,
        ]
    });
    let jumps = jumps_over_joints(model, found);
    let pulled = [0, 1].map(|row: usize| {
        let over_joints: Complex64 = jumps.iter().map(|jump| jump[row]).sum();
        -beam.axial_force * (ends[1][row] - ends[0][row] - over_joints)
    });
    let [of_w, of_v, of_both] = [
        section.second_moment_y,
        section.second_moment_z,
        section.product_moment,
    ]
    .map(|moment| turning * moment);
    let mut terms: [Vec<Complex64>; 5] = [
        vec![mass * w, along_z * psi, -on_w * w],
        vec![along_z * w, polar * psi, -along_y * v, -on_psi * psi],
        vec![mass * v, -along_y * psi, -on_v * v],
        vec![
            mass * xw,
            along_z * xpsi,
            -on_w * xw,
            of_w * w_turned,
            of_both * v_turned,
            pulled[0],
        ],
        vec![
            mass * xv,
            -along_y * xpsi,
            -on_v * xv,
            of_v * v_turned,
            of_both * w_turned,
            pulled[1],
        ],
    ];
    let mut act = |x: f64, motion: BeamMotion, force: Complex64| match motion {
        BeamMotion::W | BeamMotion::V => {
            let row = motion as usize;
            terms[row].push(force);
            terms[3 + row / 2].push(x * force);
        }
        BeamMotion::Psi => terms[1].push(force),
        BeamMotion::WSlope => terms[3].push(force),
        BeamMotion::VSlope => terms[4].push(force),
        // A bimoment is in equilibrium with itself.
        BeamMotion::PsiSlope => {}
    };
    for (x, motion, load) in beam_loads(model) {
        act(x, motion, load);
    }
    for (id, reaction) in SupportId::all(model).zip(&found.reactions) {
        for (motion, force) in BeamMotion::ALL
            .into_iter()
            .zip(on_axis(model, id, reaction))
        {
            act(id.position(model), motion, force);
        }
    }
    for (subsystem, state) in model.attached().zip(&found.masses) {
        let [y_left, y_right, left, right] = state.forces;
        act(state.position, BeamMotion::W, y_left + y_right);
        act(state.position, BeamMotion::V, left + right);
        let torque = subsystem.mount_z * (y_left + y_right) + subsystem.mount_y * (right - left);
        act(state.position, BeamMotion::Psi, torque);
    }
    let loads: f64 = model.forces.iter().map(|force| force.amplitude).sum();
    for (row, terms) in terms.iter().enumerate() {
        let size: f64 = terms.iter().map(|term| term.norm()).sum();
        let tolerance = 1e-9 * size + 1e-12 * loads;
        let what = format!("balance {row} at {} Hz", found.frequency);
        assert_near(terms.iter().sum(), Complex64::ZERO, tolerance, &what);
    }
}

/// The forces of a support on the axis: those at its point turn about it.
fn on_axis(model: &Model, id: SupportId, reaction: &[Complex64; 6]) -> [Complex64; 6] {
    let point = id.support(model).point;
    let [w, psi, v, slopes @ ..] = *reaction;
    let [w_slope, psi_slope, v_slope] = slopes;
    [
        w,
        psi + point.z * w - point.y * v,
        v,
        w_slope,
        psi_slope,
        v_slope,
    ]
}

/// The balance of every mass: loads and springs against its inertia.
fn assert_masses_in_balance(model: &Model, found: &Operating) {
    let square = (TAU * found.frequency).powi(2);
    for (subsystem, state) in model.attached().zip(&found.masses) {
        let load = |motion| mass_load(model, &state.name, motion);
        let [y_left, y_right, left, right] = state.forces;
        let [y, z, theta] = state.motion;
        let turning = subsystem.arm_left * left - subsystem.arm_right * right;
        let balances = [
            [
                load(MassMotion::Y),
                -y_left - y_right,
                square * subsystem.mass * y,
            ],
            [
                load(MassMotion::Z),
                -left - right,
                square * subsystem.mass * z,
            ],
            [
                load(MassMotion::Theta),
                turning,
                square * subsystem.inertia * theta,
            ],
        ];
        let size = state.forces.iter().map(|f| f.norm()).sum::<f64>();
        for terms in balances {
            let size = size + terms.iter().map(|term| term.norm()).sum::<f64>();
            assert_near(
                terms.iter().sum(),
                Complex64::ZERO,
                1e-9 * size,
                &state.name,
            );
        }
    }
}

/// Internal forces jump at attachments and loads, and balance the supports at the ends.
fn assert_forces_meet(model: &Model, found: &Operating) {
    let last = found.positions.len() - 1;
    let loads_at = |x: f64| {
        let mut load = [Complex64::ZERO; 6];
        for (at, motion, value) in beam_loads(model) {
            if at == x {
                load[motion as usize] += value;
            }
        }
        load
    };
    // A row that only rounding reaches is no more accurate than that of the loads.
    let loads: f64 = model.forces.iter().map(|force| force.amplitude).sum();
    let scale = |row: usize| {
        let largest = found.forces[row]
            .iter()
            .map(|p| p.norm())
            .fold(0.0, f64::max);
        1e-9 * largest + 1e-12 * loads
    };
    for [left, right] in joints(found) {
        let x = found.positions[left];
        let mut acting = if x > 0.0 && x < LENGTH {
            loads_at(x)
        } else {
            [Complex64::ZERO; 6]
        };
        for (subsystem, state) in model.attached().zip(&found.masses) {
            if state.position == x {
                let [y_left, y_right, z_left, z_right] = state.forces;
                acting[0] += y_left + y_right;
                acting[1] += subsystem.mount_z * (y_left + y_right);
                acting[1] += subsystem.mount_y * (z_right - z_left);
                acting[2] += z_left + z_right;
            }
        }
        for (index, inner) in model.supports.inner.iter().enumerate() {
            let id = SupportId::Inner(index);
            if inner.position == x {
                let forces = on_axis(model, id, &found.reactions[2 + index]);
                for (acting, force) in acting.iter_mut().zip(forces) {
                    *acting += force;
                }
            }
        }
        for row in 0..6 {
            let jump = found.forces[row][right] - found.forces[row][left];
            assert_near(
                jump,
                -acting[row],
                scale(row),
                &format!("jump {row} at {x} m"),
            );
        }
    }
    for (end, index, outward) in [(0, 0, -1.0), (1, last, 1.0)] {
        let load = loads_at(found.positions[index]);
        let reaction = on_axis(model, SupportId::ENDS[end], &found.reactions[end]);
        for row in 0..6 {
            let outer = outward * found.forces[row][index];
            let want = load[row] + reaction[row];
            assert_near(outer, want, scale(row), &format!("end {end}, {row}"));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 96,
        rng_seed: proptest::test_runner::RngSeed::Fixed(7),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn everything_is_in_balance(model in loaded(), hertz in frequencies()) {
        let found = operating(&checked(&model), hertz, 9);
        assert_forces_meet(&model, &found);
        assert_in_balance(&model, &found);
        assert_masses_in_balance(&model, &found);
    }

    #[test]
    fn power_comes_in_and_goes_out(model in loaded(), lossless in any::<bool>(), hertz in frequencies()) {
        let mut model = model;
        if lossless {
            model.beam.material.loss_factor = 0.0;
        }
        let found = operating(&checked(&model), hertz, 9);
        assert_powers_balance(&model, &found);
    }
}

/// Input against losses, and the flow along the beam against both.
fn assert_powers_balance(model: &Model, found: &Operating) {
    let power = &found.power;
    // The input if the whole motion were in phase with the forces: the scale of the rounding of the inputs.
    let apparent = apparent(model, found);
    // Slow waves add up to much less than each of them.
    let rounding = if found.frequency < 10.0 { 1e-11 } else { 1e-13 };
    let tolerance = 1e-9 * power.input() + rounding * apparent;
    let left = (power.input() - power.loss()).abs();
    assert!(
        left <= tolerance,
        "{} Hz: input {:e}, loss {:e}, off by {left:e}, apparent {apparent:e}",
        found.frequency,
        power.input(),
        power.loss()
    );
    assert_flow_meets(model, found, tolerance);
}

/// The flow jumps by the input of forces and the loss of dampers, and falls between joints by the loss of the material.
fn assert_flow_meets(model: &Model, found: &Operating, tolerance: f64) {
    let (power, last) = (&found.power, found.positions.len() - 1);
    let joints = joints(found);
    let jumps: f64 = joints
        .iter()
        .map(|[l, r]| power.flow[*r] - power.flow[*l])
        .sum();
    let at_supports = |damper: &&Damper| {
        ["left ", "right "]
            .iter()
            .any(|end| damper.label.starts_with(end))
    };
    let supports: f64 = power
        .dampers
        .iter()
        .filter(at_supports)
        .map(|damper| damper.power)
        .sum();
    let at_end =
        |force: &Force| matches!(force.target, Target::Beam(Place::Left | Place::Right, _));
    let ends: f64 = power
        .inputs
        .iter()
        .filter(|input| at_end(&model.forces[input.force]))
        .map(|input| input.power)
        .sum();
    let inside = power.input() - ends;
    // A foundation takes power all along the beam, as the material does.
    let along: f64 = power
        .dampers
        .iter()
        .filter(|damper| damper.label.starts_with("foundation"))
        .map(|damper| damper.power)
        .sum::<f64>()
        + power.material;
    let subsystems = power.loss() - along - supports;
    let size: f64 = power
        .flow
        .iter()
        .fold(0.0, |most, flow| flow.abs().max(most));
    let tolerance = tolerance + 1e-11 * size;
    for (name, got, want) in [
        ("jumps", jumps, inside - subsystems),
        ("ends", power.flow[0] - power.flow[last], ends - supports),
        ("span", power.flow[0] + jumps - power.flow[last], along),
    ] {
        assert!(
            (got - want).abs() <= tolerance,
            "{name} at {} Hz: {got:e} for {want:e}, {tolerance:e}",
            found.frequency
        );
    }
}

fn apparent(model: &Model, found: &Operating) -> f64 {
    let forces = model.forces.iter().filter(|force| force.enabled);
    let each = forces.map(|force| {
        let moved = respond(
            model,
            model.forces.clone(),
            std::slice::from_ref(&force.target),
            found.frequency,
        );
        0.5 * TAU * found.frequency * force.amplitude * moved[0].norm()
    });
    each.sum()
}

#[test]
fn power_of_the_presets_balances() {
    for name in ["fig05a", "fig08"] {
        for loss_factor in [0.0, 0.01] {
            let mut model = preset(name);
            model.beam.material.loss_factor = loss_factor;
            for hertz in [1.0, 7.0, 23.0, 58.0, 101.0, 240.0, 399.0] {
                let found = operating(&checked(&model), hertz, 21);
                assert_powers_balance(&model, &found);
            }
        }
    }
}

#[test]
fn a_slow_force_bends_a_pinned_beam_as_a_still_one() {
    // Closed form (simply supported beam, central force F): M = F L / 4 in the middle, S = F / 2, each support F / 2;
    // M_w = E Iy w'' is negative where the beam bulges to +y. Inertia adds (f / f1)^2, some 1e-10 here.
    let middle = force(Place::Position(LENGTH / 2.0), BeamMotion::W, 3.0);
    let mut model = bare(Support::PINNED, Support::PINNED, vec![middle]);
    model.beam.section.centroid_offset = 0.0;
    let found = operating(&checked(&model), 1e-3, 5);
    let near = |got: Complex64, want: f64| assert_near(got, want.into(), 1e-7, "static");
    assert_eq!(found.positions[2..4], [LENGTH / 2.0; 2]);
    for side in [2, 3] {
        near(found.forces[3][side], -3.0 * LENGTH / 4.0);
    }
    near(found.forces[3][1], -3.0 * LENGTH / 8.0);
    near(found.forces[0][1], 1.5);
    near(found.forces[0][4], -1.5);
    for reactions in &found.reactions {
        near(reactions[0], -1.5);
    }
}

#[test]
fn a_slow_torque_twists_a_cantilever_as_a_still_one() {
    // Closed form (Vlasov): T is the torque everywhere; psi' = T/GJ (1 - cosh k(L - x) / cosh kL) with k^2 = GJ / E G0
    // gives B = T/k sinh k(L - x) / cosh kL, and at the clamped end T/k tanh kL.
    let tip = force(Place::Right, BeamMotion::Psi, 2.0);
    let mut model = bare(Support::CLAMPED, Support::FREE, vec![tip]);
    model.beam.section.centroid_offset = 0.0;
    let (material, section) = (model.beam.material, model.beam.section);
    let torsion = material.shear_modulus * section.torsion_constant;
    let k = (torsion / (material.young_modulus * section.warping_constant)).sqrt();
    let found = operating(&checked(&model), 1e-3, 5);
    for (index, x) in found.positions.iter().enumerate() {
        assert_near(found.forces[1][index], 2.0.into(), 1e-7, "torque");
        let bimoment = 2.0 / k * (k * (LENGTH - x)).sinh() / (k * LENGTH).cosh();
        assert_near(found.forces[4][index], bimoment.into(), 1e-7, "bimoment");
        let rate = 2.0 / torsion * (1.0 - (k * (LENGTH - x)).cosh() / (k * LENGTH).cosh());
        assert_near(
            found.motion[4][index],
            rate.into(),
            1e-7 * 2.0 / torsion,
            "rate of twist",
        );
    }
    assert_near(found.reactions[0][1], (-2.0).into(), 1e-7, "reaction");
    assert_near(
        found.reactions[0][4],
        (-2.0 / k * (k * LENGTH).tanh()).into(),
        1e-7,
        "reaction",
    );
}

#[test]
fn a_section_without_warping_carries_no_bimoment() {
    // Closed form: with E G0 = 0 the torque is G J psi' and B = 0, also where a warping support is.
    let tip = force(Place::Right, BeamMotion::Psi, 2.0);
    let mut model = bare(Support::CLAMPED, Support::FREE, vec![tip]);
    model.beam.section.warping_constant = 0.0;
    model.supports.right[BeamMotion::PsiSlope] = Restraint::Elastic(Elastic {
        spring: Spring {
            stiffness: 10.0,
            damping: 1.0,
            ..Spring::default()
        },
        inertia: 0.0,
    });
    let found = operating(&checked(&model), 20.0, 9);
    let torsion = model.beam.material.shear_modulus * model.beam.section.torsion_constant;
    assert!(
        found.forces[4]
            .iter()
            .all(|bimoment| *bimoment == Complex64::ZERO)
    );
    assert_eq!(
        [found.reactions[0][4], found.reactions[1][4]],
        [Complex64::ZERO; 2]
    );
    assert_eq!(found.power.dampers[0].label, "right psi_slope");
    assert_eq!(found.power.dampers[0].power, 0.0);
    for index in 1..8 {
        let torque = torsion * found.motion[4][index];
        assert_near(
            found.forces[1][index],
            torque,
            1e-9 * torque.norm(),
            "torque",
        );
    }
}

#[test]
fn dampers_are_named_and_take_what_a_single_mass_gives_them() {
    // Closed form: a mass on a spring and a damper to a practically rigid ground moves by F / (k - m w^2 + i w c); the
    // damper takes 1/2 c w^2 |u|^2. The ground is a clamped beam a million times stiffer than the spring.
    let mut model = preset("fig05a");
    model.supports.left = Support::CLAMPED;
    model.supports.right = Support::CLAMPED;
    model.subsystems.truncate(1);
    let subsystem = &mut model.subsystems[0];
    (subsystem.mass, subsystem.arm_left, subsystem.arm_right) = (2.0, 0.1, 0.1);
    subsystem.y_left = model::Spring {
        stiffness: 30.0,
        damping: 1.5,
        ..model::Spring::default()
    };
    subsystem.y_right = model::Spring {
        stiffness: 10.0,
        damping: 0.5,
        ..model::Spring::default()
    };
    subsystem.z_left = model::Spring {
        stiffness: 10.0,
        ..model::Spring::default()
    };
    subsystem.z_right = model::Spring {
        stiffness: 10.0,
        ..model::Spring::default()
    };
    model.forces = vec![Force {
        amplitude: 3.0,
        phase: 40.0,
        ..unit_force(Target::Mass("S1".into(), MassMotion::Y))
    }];
    let omega = 5.0;
    let found = operating(&checked(&model), omega / TAU, 3);
    let moved = 3.0 / Complex64::new(40.0 - 2.0 * omega * omega, 2.0 * omega);
    let state = &found.masses[0];
    assert!((state.motion[0].norm() / moved.norm() - 1.0).abs() < 1e-5);
    let labels: Vec<&str> = found
        .power
        .dampers
        .iter()
        .map(|d| d.label.as_str())
        .collect();
    assert_eq!(labels, ["S1 y_left", "S1 y_right"]);
    for (damper, c) in found.power.dampers.iter().zip([1.5, 0.5]) {
        let want = 0.5 * c * omega * omega * moved.norm_sqr();
        assert!(
            (damper.power / want - 1.0).abs() < 1e-5,
            "{damper:?} {want}"
        );
    }
    let want = 0.5 * 2.0 * omega * omega * moved.norm_sqr();
    assert!((found.power.inputs[0].power / want - 1.0).abs() < 1e-5);
}

#[test]
fn an_undamped_resonance_is_not_finite_and_harmless() {
    // Closed form: a pinned beam without offset resonates at f = pi / (2 L^2) sqrt(E Iz / rho A) in v.
    let middle = force(Place::Position(LENGTH / 2.0), BeamMotion::V, 1.0);
    let mut model = bare(Support::PINNED, Support::PINNED, vec![middle]);
    model.beam.section.centroid_offset = 0.0;
    let (material, section) = (model.beam.material, model.beam.section);
    let stiffness = material.young_modulus * section.second_moment_z;
    let mass = material.density * section.area;
    let resonance = PI / (2.0 * LENGTH * LENGTH) * (stiffness / mass).sqrt();
    let nearby = operating(&checked(&model), 0.9 * resonance, 5).motion[2][2].norm();
    let found = operating(&checked(&model), resonance, 5);
    let moved = found.motion[2][2].norm();
    assert!(
        !moved.is_finite() || moved > 1e9 * nearby,
        "{moved} nearby {nearby}"
    );
    assert_eq!(found.positions.len(), 6);
    assert_eq!(found.power.inputs.len(), 1);
}

#[test]
fn disabled_forces_and_subsystems_do_nothing() {
    let mut model = preset("fig05b");
    model.subsystems[1].enabled = false;
    let amount = model.forces.len();
    model.forces[0].enabled = false;
    let found = operating(&checked(&model), 30.0, 3);
    let names: Vec<&str> = found
        .masses
        .iter()
        .map(|state| state.name.as_str())
        .collect();
    assert_eq!(names, ["S1", "S3"]);
    let forces: Vec<usize> = found.power.inputs.iter().map(|input| input.force).collect();
    assert_eq!(forces, (1..amount).collect::<Vec<usize>>());
}

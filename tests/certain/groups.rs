//! Equal and nearly equal modes over families of models: frequencies, shapes and derivatives.
//!
//! Expected: closed forms of masses that move alone; the definition of (bi-)orthogonality with integrals of this file;
//! residues of responses on circles of this file.

use crate::checked::checked;
use std::f64::consts::TAU;

use beamtune::model::{
    BeamMotion, Force, MassMotion, Measure, Model, Place, Quantity, Response, Spring, Subsystem,
    Support, Target, edit, path,
};
use beamtune::solve::modes::{ModeKind, Modes, Shape, modes, shapes};
use beamtune::solve::sensitivity::Differentiator;
use num_complex::Complex64;
use rayon::prelude::*;

use super::{NEVER, certain, load};

/// Points of a shape, so that Simpson's rule errs by less than 1e-10; the positions in hundredths of the length are
/// among them.
const POINTS: usize = 1201;

/// A model with its known results.
struct Case {
    name: String,
    model: Model,
    to: f64,
    /// Exact roots, rad/s, repeated by multiplicity.
    roots: Vec<Complex64>,
}

/// A pinned beam with `count` masses of one kind, at `places` (shares of the length), whose inertias differ by `step`.
fn with_masses(count: usize, places: fn(usize) -> f64, damping: f64, step: f64) -> Model {
    let mut model = load("three_alike_undamped");
    let spring = Spring {
        stiffness: 1e5,
        damping,
        ..Spring::default()
    };
    let one = Subsystem {
        y_left: spring.clone(),
        y_right: spring.clone(),
        z_left: spring.clone(),
        z_right: spring,
        ..model.subsystems[0].clone()
    };
    let masses = (0..count).map(|index| Subsystem {
        name: format!("S{index}"),
        position: model.beam.length * places(index),
        inertia: one.inertia * (1.0 + step * index as f64),
        ..one.clone()
    });
    model.subsystems = masses.collect();
    model
}

/// `omega^2 m - i omega c - k = 0`.
fn root(mass: f64, damping: f64, stiffness: f64) -> Complex64 {
    let square = Complex64::from(4.0 * stiffness * mass - damping * damping);
    (Complex64::I * damping + square.sqrt()) / (2.0 * mass)
}

/// The roots of masses that rotate on their z springs alone (`mount_y` = 0, equal arms), which exert no net force on
/// the beam.
fn turning(model: &Model) -> Vec<Complex64> {
    let of = |one: &Subsystem| {
        let square = 2.0 * one.arm_left.powi(2);
        let spring = one.z_left.clone();
        root(
            one.inertia,
            square * spring.damping,
            square * spring.stiffness,
        )
    };
    model.subsystems.iter().map(of).collect()
}

fn families() -> Vec<Case> {
    let apart = |index: usize| 0.07 * (index + 1) as f64;
    let together = |_: usize| 0.34;
    let mut cases = Vec::new();
    for count in [3, 12] {
        for (damping, loss_factor) in [(0.0, 0.0), (3.0, 0.0), (0.0, 0.02), (3.0, 0.02)] {
            let steps = [0.0, 1e-4, 1e-6, 1e-8, 1e-10];
            for step in &steps[..if damping > 0.0 && loss_factor == 0.0 {
                1
            } else {
                5
            }] {
                let step = *step;
                let mut model = with_masses(count, apart, damping, step);
                model.beam.material.loss_factor = loss_factor;
                cases.push(Case {
                    name: format!("{count} apart, c {damping}, eta {loss_factor}, step {step}"),
                    to: 100.0,
                    roots: turning(&model),
                    model,
                });
            }
            // At one position, all but one mode of each kind leave the beam at rest.
            let mut model = with_masses(count, together, damping, 0.0);
            model.beam.material.loss_factor = loss_factor;
            let one = &model.subsystems[0];
            let translation = root(one.mass, 2.0 * damping, 2e5);
            cases.push(Case {
                name: format!("{count} together, c {damping}, eta {loss_factor}"),
                to: 100.0,
                roots: [turning(&model), vec![translation; 2 * (count - 1)]].concat(),
                model,
            });
        }
    }
    for step in [0.0, 1e-4, 1e-6, 1e-8, 1e-10] {
        for loss_factor in [0.0, 0.02] {
            cases.push(free_beam(step, loss_factor));
        }
    }
    cases
}

/// A free beam with equal bending along y and z, except for a step of the stiffness.
///
/// Expected: cos(k L) cosh(k L) = 1, its first three roots (Abramowitz & Stegun, 4.3.147 and by Newton's method).
fn free_beam(step: f64, loss_factor: f64) -> Case {
    const ROOTS: [f64; 3] = [
        4.730_040_744_862_704,
        7.853_204_624_095_838,
        10.995_607_838_001_671,
    ];
    let mut model = load("three_alike_undamped");
    model.subsystems.clear();
    let free = Support::FREE;
    model.supports.left = free.clone();
    model.supports.right = free;
    model.beam.material.loss_factor = loss_factor;
    let section = &mut model.beam.section;
    section.centroid_offset = 0.0;
    section.second_moment_y = 1e-5;
    section.second_moment_z = 1e-5 * (1.0 + step);
    let (beam, section) = (&model.beam, &model.beam.section);
    let of = |k_l: f64, second: f64| {
        let modulus = beam.material.young_modulus * Complex64::new(1.0, loss_factor);
        let mass = beam.material.density * section.area;
        (k_l / beam.length).powi(2) * (modulus * second / mass).sqrt()
    };
    let pairs = ROOTS.map(|root| {
        [section.second_moment_y, section.second_moment_z].map(|second| of(root, second))
    });
    Case {
        name: format!("free beam, step {step}, eta {loss_factor}"),
        to: 1500.0,
        roots: pairs.concat(),
        model,
    }
}

/// The indices of modes that are close together (relative 1e-3), rigid-body modes among them.
fn groups(found: &Modes) -> Vec<Vec<usize>> {
    const CLOSE: f64 = 1e-3;
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (index, mode) in found.modes.iter().enumerate() {
        let near = |group: &&mut Vec<usize>| {
            group.iter().any(|&other| {
                (found.modes[other].omega - mode.omega).norm() <= CLOSE * mode.omega.norm()
            })
        };
        match groups.iter_mut().find(near) {
            Some(group) => group.push(index),
            None => groups.push(vec![index]),
        }
    }
    groups
}

/// `a^T M b` and `a^T C b` by Simpson's rule.
fn products(model: &Model, a: &Shape, b: &Shape) -> [Complex64; 2] {
    let (material, section) = (&model.beam.material, &model.beam.section);
    let mut along = Complex64::ZERO;
    let last = POINTS - 1;
    for k in 0..POINTS {
        let weight = match k {
            0 => 1.0,
            k if k == last => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let offset = section.centroid_offset * (a.w[k] * b.psi[k] + a.psi[k] * b.w[k]);
        let density = section.area * (a.w[k] * b.w[k] + a.v[k] * b.v[k] + offset)
            + section.polar_moment * a.psi[k] * b.psi[k];
        along += weight * material.density * density;
    }
    let mut mass = along * model.beam.length / (3.0 * last as f64);
    let mut damping = Complex64::ZERO;
    for (index, one) in model.attached().enumerate() {
        let place = (one.position / model.beam.length * last as f64).round() as usize;
        let stretched = |shape: &Shape| {
            let [y, z, theta] = shape.masses[index];
            let (w, psi, v) = (shape.w[place], shape.psi[place], shape.v[place]);
            let y = y - w - one.mount_z * psi;
            let left = z - one.arm_left * theta - v + one.mount_y * psi;
            let right = z + one.arm_right * theta - v - one.mount_y * psi;
            [y, y, left, right]
        };
        let springs = [
            one.y_left.clone(),
            one.y_right.clone(),
            one.z_left.clone(),
            one.z_right.clone(),
        ];
        for ((spring, p), q) in springs.iter().zip(stretched(a)).zip(stretched(b)) {
            damping += spring.damping * p * q;
        }
        let (p, q) = (a.masses[index], b.masses[index]);
        mass += one.mass * (p[0] * q[0] + p[1] * q[1]) + one.inertia * p[2] * q[2];
    }
    [mass, damping]
}

/// The largest error of the (bi-)orthogonality of a group.
fn unorthogonal(case: &Case, found: &Modes, shapes: &[Shape], group: &[usize]) -> f64 {
    let mut worst: f64 = 0.0;
    for &i in group {
        for &j in group {
            let [mass, damping] = products(&case.model, &shapes[i], &shapes[j]);
            let want = if i == j { 1.0 } else { 0.0 };
            let (p, q) = (found.modes[i].omega, found.modes[j].omega);
            let form = if p.norm() == 0.0 {
                mass
            } else {
                ((p + q) * mass - Complex64::I * damping) / (2.0 * p.sqrt() * q.sqrt())
            };
            worst = worst.max((form - want).norm());
        }
    }
    worst
}

/// Where responses are compared: masses, and positions on the beam.
fn targets(model: &Model) -> Vec<Target> {
    let place = Place::Position(0.61 * model.beam.length);
    let mut targets = [BeamMotion::W, BeamMotion::V]
        .map(|motion| Target::Beam(place, motion))
        .to_vec();
    for one in model.subsystems.iter().take(2) {
        let motions = [MassMotion::Y, MassMotion::Theta];
        targets.extend(motions.map(|motion| Target::Mass(one.name.clone(), motion)));
    }
    targets
}

fn moved(model: &Model, shape: &Shape, target: &Target) -> Complex64 {
    match target {
        Target::Beam(_, motion) => {
            let column = [&shape.w, &shape.psi, &shape.v][*motion as usize];
            column[(0.61 * (POINTS - 1) as f64).round() as usize]
        }
        Target::Mass(name, motion) => {
            let index = model.subsystems.iter().position(|one| one.name == *name);
            shape.masses[index.unwrap()][*motion as usize]
        }
    }
}

/// The largest error of the sum of the residues of a group, against the integral of responses along a circle.
fn residues(case: &Case, found: &Modes, shapes: &[Shape], group: &[usize]) -> f64 {
    let omega = |index: usize| found.modes[index].omega;
    let centre = group.iter().map(|&i| omega(i)).sum::<Complex64>() / group.len() as f64;
    let all = found.modes.iter().chain(&found.beyond).enumerate();
    let gap = all
        .filter(|(index, _)| !group.contains(index))
        .map(|(_, mode)| (mode.omega - centre).norm())
        .fold(0.1 * centre.norm(), f64::min);
    let size = group
        .iter()
        .map(|&i| (omega(i) - centre).norm())
        .fold(0.0, f64::max);
    let radius = (size * gap).sqrt().max(0.2 * gap);
    // The error of the trapezoidal rule for a pole inside and one outside: 1e-12.
    let share = (size / radius).max(radius / gap);
    assert!(share < 0.9, "{}: a group that others are among", case.name);
    let points = (1e-12_f64.ln() / share.ln()).ceil() as usize;
    let targets = targets(&case.model);
    let (mut worst, mut scale) = (0.0_f64, 0.0_f64);
    for from in &targets {
        let mut model = case.model.clone();
        model.forces = vec![Force {
            enabled: true,
            target: from.clone(),
            amplitude: 1.0,
            phase: 0.0,
            point: beamtune::model::Point::AXIS,
        }];
        let response = |(index, target): (usize, &Target)| Response {
            name: format!("R{index}"),
            enabled: true,
            quantity: Quantity::Motion(target.clone(), Measure::Displacement),
            point: beamtune::model::Point::AXIS,
            over: None,
        };
        model.responses = targets.iter().enumerate().map(response).collect();
        let differentiator = Differentiator::new(&checked(&model));
        let mut sums = vec![Complex64::ZERO; targets.len()];
        for k in 0..points {
            let angle = TAU * (k as f64 + 0.5) / points as f64;
            let aside = Complex64::from_polar(radius, angle);
            let values = differentiator.at((centre + aside) / TAU);
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += aside * value.value / points as f64;
            }
        }
        for (to, integral) in targets.iter().zip(sums) {
            let product = |&index: &usize| {
                let [a, b] = [from, to].map(|target| moved(&case.model, &shapes[index], target));
                a * b / (2.0 * omega(index))
            };
            let sum: Complex64 = group.iter().map(product).sum();
            worst = worst.max((sum + integral).norm());
            scale = scale.max(integral.norm());
        }
    }
    worst / scale
}

/// The largest errors of the frequencies, of the orthogonality and of the residues of a case.
fn errors(case: &Case) -> [f64; 3] {
    let mut worst = [0.0_f64; 3];
    let mut note = |kind: usize, error: f64| {
        worst[kind] = if error.is_nan() {
            f64::INFINITY
        } else {
            worst[kind].max(error)
        };
    };
    let found = certain(&case.model, case.to);
    let mut left: Vec<Complex64> = found.modes.iter().map(|mode| mode.omega).collect();
    for root in &case.roots {
        let distance = |index: &usize| (left[*index] - root).norm();
        let nearest = (0..left.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let nearest = left.swap_remove(nearest.unwrap());
        note(0, (nearest - root).norm() / root.norm());
    }
    let all = shapes(&checked(&case.model), &found, POINTS, &NEVER).unwrap();
    for group in groups(&found) {
        note(1, unorthogonal(case, &found, &all, &group));
        let is_moving = found.modes[group[0]].kind != ModeKind::RigidBody;
        if is_moving && group.len() > 1 {
            note(2, residues(case, &found, &all, &group));
        }
    }
    worst
}

/// Expected: closed forms to 1e-10; the definitions of modal mass and bi-orthogonality to 1e-9, residues to 1e-8.
#[test]
fn equal_and_nearly_equal_modes_of_families_of_models() {
    let cases = families();
    let errors: Vec<[f64; 3]> = cases.par_iter().map(errors).collect();
    let limits = [
        ("frequency", 1e-10),
        ("orthogonality", 1e-9),
        ("residues", 1e-8),
    ];
    for (kind, (name, limit)) in limits.into_iter().enumerate() {
        let worst = (0..cases.len()).max_by(|&a, &b| errors[a][kind].total_cmp(&errors[b][kind]));
        let worst = worst.unwrap();
        println!("{name}: {:e} at {}", errors[worst][kind], cases[worst].name);
        assert!(
            errors[worst][kind] < limit,
            "{name}: {:?} at {}",
            errors[worst],
            cases[worst].name
        );
    }
}

/// d omega/d ln p of the modes `indices`, rad/s.
fn by_logarithm(model: &Model, found: &Modes, indices: &[usize], path: &str) -> Vec<Complex64> {
    let differentiator = Differentiator::new(&checked(model));
    let id = path::one(model, path).unwrap();
    let ids = differentiator.ids();
    let parameter = ids.iter().position(|of| *of == id).unwrap();
    let value = differentiator.values()[parameter];
    let slope = |&index: &usize| {
        let gradient = differentiator.mode(found, index);
        let mode = &found.modes[index];
        let (size, damping) = (mode.omega.norm(), mode.damping_ratio());
        // omega = size (sqrt(1 - zeta^2) + i zeta).
        let rate = TAU * gradient.frequency[parameter];
        let turned = gradient.damping_ratio[parameter] * size;
        let along = mode.omega / size * rate;
        value * (along + turned * Complex64::new(-damping / (1.0 - damping * damping).sqrt(), 1.0))
    };
    indices.iter().map(slope).collect()
}

/// The indices of the modes at a root.
fn at(found: &Modes, root: Complex64) -> Vec<usize> {
    let near = |index: &usize| (found.modes[*index].omega - root).norm() < 1e-9 * root.norm();
    (0..found.modes.len()).filter(near).collect()
}

/// Expected: closed form, `omega^2 J - i omega c - k = 0`: one of the equal modes takes all of the change of one mass.
#[test]
fn derivatives_of_equal_modes_are_those_of_their_splitting() {
    for damping in [0.0, 3.0] {
        for count in [2, 3, 12] {
            let model = with_masses(count, |index| 0.07 * (index + 1) as f64, damping, 0.0);
            let found = certain(&model, 100.0);
            let omega = turning(&model)[0];
            let equal = at(&found, omega);
            assert_eq!(equal.len(), count);
            let equal = &equal[..count.min(3)];
            let one = &model.subsystems[0];
            let c = 2.0 * one.arm_left.powi(2) * damping;
            let slope =
                -omega * omega * one.inertia / (2.0 * omega * one.inertia - Complex64::I * c);
            for name in &["S0", "S1"][..if count < 12 { 2 } else { 1 }] {
                let slopes =
                    by_logarithm(&model, &found, equal, &format!("subsystems.{name}.inertia"));
                // The frequency falls as the inertia rises: the first of the list.
                for (place, found) in slopes.iter().enumerate() {
                    let want = if place == 0 { slope } else { Complex64::ZERO };
                    assert!(
                        (found - want).norm() < 1e-8 * slope.norm(),
                        "{count} {place}: {found} {want}"
                    );
                }
            }
        }
    }
}

/// Expected: closed form, f is proportional to the roots of E, 1 / rho and of its own second moment, and to 1 / L^2.
#[test]
fn derivatives_of_equal_bending_modes() {
    let case = free_beam(0.0, 0.0);
    let found = certain(&case.model, case.to);
    for pair in case.roots.chunks(2) {
        let equal = at(&found, pair[0]);
        assert_eq!(equal.len(), 2);
        for (path, powers) in [
            ("beam.material.young_modulus", [0.5, 0.5]),
            ("beam.material.density", [-0.5, -0.5]),
            ("beam.length", [-2.0, -2.0]),
            ("beam.section.second_moment_y", [0.0, 0.5]),
            ("beam.section.second_moment_z", [0.0, 0.5]),
            ("beam.section.torsion_constant", [0.0, 0.0]),
        ] {
            let slopes = by_logarithm(&case.model, &found, &equal, path);
            for (slope, power) in slopes.iter().zip(powers) {
                let relative = slope / pair[0];
                assert!(
                    (relative - power).norm() < 1e-8,
                    "{path}: {relative} {power}"
                );
            }
        }
    }
}

/// Expected: closed form. Modes that are close to each other belong to one mass each.
#[test]
fn derivatives_of_nearly_equal_modes_are_their_own() {
    for (step, tolerance) in [(1e-4, 1e-8), (1e-6, 1e-8), (1e-8, 1e-7)] {
        for damping in [0.0, 3.0] {
            let model = with_masses(3, |index| 0.07 * (index + 1) as f64, damping, step);
            let found = certain(&model, 100.0);
            let roots = turning(&model);
            for (own, root) in roots.iter().enumerate() {
                let distance = |index: &usize| (found.modes[*index].omega - root).norm();
                let nearest =
                    (0..found.modes.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
                for mass in 0..3 {
                    let path = format!("subsystems.S{mass}.inertia");
                    let slope = by_logarithm(&model, &found, &[nearest.unwrap()], &path)[0];
                    let one = &model.subsystems[mass];
                    let c = 2.0 * one.arm_left.powi(2) * damping;
                    let alone =
                        -root * root * one.inertia / (2.0 * root * one.inertia - Complex64::I * c);
                    let want = if mass == own { alone } else { Complex64::ZERO };
                    assert!(
                        (slope - want).norm() < tolerance * alone.norm(),
                        "{step} {own} {mass}: {slope} {want}"
                    );
                }
            }
        }
    }
}

/// Expected: one-sided differences of the list. Four masses at one position: in three modes of each kind the beam
/// rests, and a change of one of the masses, or of its position, moves several of them.
#[test]
fn derivatives_of_equal_modes_follow_the_list() {
    const STEP: f64 = 2e-4;
    for damping in [0.0, 3.0] {
        let model = with_masses(4, |_| 0.34, damping, 0.0);
        let found = certain(&model, 100.0);
        let one = &model.subsystems[0];
        let equal = at(&found, root(one.mass, 2.0 * damping, 2e5));
        assert_eq!(equal.len(), 6);
        for field in ["mass", "y_left.stiffness", "z_right.stiffness", "arm_left"] {
            let path = format!("subsystems.S1.{field}");
            let value = path::number(&model, &path).unwrap();
            let lists = [1.0, 2.0, 3.0].map(|steps: f64| {
                let mut changed = model.clone();
                let value = edit::Value::Number(value * (steps * STEP).exp());
                edit::set_unchecked(&mut changed, &path, value).unwrap();
                modes(&checked(&changed), 100.0, &NEVER).unwrap()
            });
            let slopes = by_logarithm(&model, &found, &equal, &path);
            for (&index, slope) in equal.iter().zip(slopes) {
                let [f1, f2, f3] = [0, 1, 2].map(|k| lists[k].modes[index].frequency());
                let f0 = found.modes[index].frequency();
                let want = (-11.0 * f0 + 18.0 * f1 - 9.0 * f2 + 2.0 * f3) / (6.0 * STEP);
                let omega = found.modes[index].omega;
                let rate = (omega.conj() * slope).re / omega.norm() / TAU;
                assert!(
                    (rate - want).abs() < 1e-5 * f0,
                    "{path} {index}: {rate} {want}"
                );
            }
        }
    }
}

//! How a mode moves, for people to see.

use num_complex::Complex64;

use super::eigenspace::{Circle, Probe};
use super::is_hysteretic;
use super::motion::Motion;
use super::neighbours::{neighbours, with_images};
use super::quadrature::Sample;
use super::rigid;
use super::types::{ModeKind, Modes, Shape, Shares};
use crate::model::{BeamMotion, Model};

/// Modes closer than this (relative) are found together.
const CLOSE: f64 = 1e-5;

/// The motion of the mode `index` of `modes` at `points` (2 or more) equal steps along the beam.
///
/// Without damping it is real and normalised to modal mass 1: `phi^T M phi = 1`; with damping to bi-orthogonality,
/// `phi^T (2 omega M - i C) phi = 2 omega` (Foss, J. Appl. Mech. 25 (1958) 361-364), which is the same where C = 0.
/// Modes that share one frequency are some orthogonal ones of their space, the same whichever of them is asked for.
/// Where an open list holds a mode that the model does not have, nothing moves.
pub fn shape(model: &Model, modes: &Modes, index: usize, points: usize) -> Shape {
    let last = (points.max(2) - 1) as f64;
    let positions: Vec<f64> = (0..points.max(2))
        .map(|point| model.beam.length * point as f64 / last)
        .collect();
    let mode = &modes.modes[index];
    let probe = Probe::new(model, mode.omega, positions.clone());
    let motion = match mode.kind {
        ModeKind::RigidBody => still(model, &probe, index),
        ModeKind::Oscillating | ModeKind::Overdamped => moving(model, modes, index, &probe),
    };
    let column = |row: usize| {
        motion.beam[..positions.len()]
            .iter()
            .map(|q| q[row])
            .collect()
    };
    Shape {
        w: column(0),
        psi: column(1),
        v: column(2),
        shares: shares(&probe.samples, model, &motion, positions.len()),
        masses: motion.masses,
        positions,
    }
}

/// The rigid-body mode `index`: they are the first of the list.
fn still(model: &Model, probe: &Probe, index: usize) -> Motion {
    let Some(rigid) = rigid::motions(model).into_iter().nth(index) else {
        return probe.at_rest();
    };
    Motion {
        beam: probe
            .places()
            .map(|x| rigid.at(x).map(Complex64::from))
            .collect(),
        ends: [0.0, model.beam.length].map(|x| rigid.all_at(x).map(Complex64::from)),
        masses: rigid
            .masses
            .iter()
            .map(|mass| mass.map(Complex64::from))
            .collect(),
    }
}

/// A mode that is not at 0, with those beside it.
fn moving(model: &Model, modes: &Modes, index: usize, probe: &Probe) -> Motion {
    let rigid = modes
        .modes
        .iter()
        .take_while(|mode| mode.kind == ModeKind::RigidBody)
        .count();
    let listed = modes.modes[rigid..].iter().chain(&modes.beyond);
    let listed: Vec<Complex64> = listed.map(|mode| mode.omega).collect();
    let all = with_images(&listed, is_hysteretic(model));
    let close = neighbours(&all, index - rigid, CLOSE);
    let roots: Vec<Complex64> = close.members.iter().map(|&member| all[member]).collect();
    let circle = Circle::around(&roots, close.gap);
    let Some(space) = probe.eigenspace(circle, roots.len()) else {
        return probe.at_rest();
    };
    // Each of the list takes the nearest that is left.
    let mut left: Vec<(Complex64, Motion)> = space.roots.into_iter().zip(space.motions).collect();
    for member in close.members {
        let distance = |(root, _): &(Complex64, Motion)| (root - all[member]).norm();
        let nearest =
            (0..left.len()).min_by(|&a, &b| distance(&left[a]).total_cmp(&distance(&left[b])));
        let Some(nearest) = nearest else { break };
        let (_, motion) = left.swap_remove(nearest);
        if member == index - rigid {
            return motion;
        }
    }
    probe.at_rest()
}

/// Shares of the kinetic energy.
fn shares(samples: &[Sample], model: &Model, motion: &Motion, skip: usize) -> Shares {
    let (material, section) = (&model.beam.material, &model.beam.section);
    let offset = section.centroid_offset;
    // Square of the radius of gyration about the centroid.
    let about_centroid = section.polar_moment / section.area - offset * offset;
    let mut shares = Shares::default();
    for (sample, [w, psi, v]) in samples.iter().zip(&motion.beam[skip..]) {
        let mass = sample.weight * material.density * section.area;
        shares.bending_y += mass * (w + offset * psi).norm_sqr();
        shares.bending_z += mass * v.norm_sqr();
        shares.twist += mass * about_centroid * psi.norm_sqr();
    }
    for (subsystem, [y, z, theta]) in model.attached().zip(&motion.masses) {
        shares.subsystems +=
            subsystem.mass * (y.norm_sqr() + z.norm_sqr()) + subsystem.inertia * theta.norm_sqr();
    }
    for (support, moved) in [&model.supports.left, &model.supports.right]
        .iter()
        .zip(&motion.ends)
    {
        for beam_motion in BeamMotion::ALL {
            shares.supports +=
                support[beam_motion].elastic().inertia * moved[beam_motion as usize].norm_sqr();
        }
    }
    normalised(shares)
}

fn normalised(shares: Shares) -> Shares {
    let Shares {
        bending_y,
        bending_z,
        twist,
        subsystems,
        supports,
    } = shares;
    let sum = bending_y + bending_z + twist + subsystems + supports;
    if sum == 0.0 {
        return Shares::default();
    }
    Shares {
        bending_y: bending_y / sum,
        bending_z: bending_z / sum,
        twist: twist / sum,
        subsystems: subsystems / sum,
        supports: supports / sum,
    }
}

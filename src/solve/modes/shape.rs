//! How a mode moves, for people to see.

use num_complex::Complex64;

use super::eigenspace::Probe;
use super::motion::Motion;
use super::types::{Mode, ModeKind, Modes, Shape, Shares};
use crate::model::{BeamMotion, Model};

/// Modes closer than this (relative) are found together.
const CLOSE: f64 = 1e-4;

/// The motion of the mode `index` of `modes` at `points` (2 or more) equal steps along the beam.
///
/// Without damping it is real and normalised to modal mass 1: `phi^T M phi = 1`; with damping to bi-orthogonality,
/// `phi^T (2 omega M - i C) phi = 2 omega` (Foss, J. Appl. Mech. 25 (1958) 361-364), which is the same where C = 0.
/// Modes that share one frequency are some orthogonal ones of their space.
pub fn shape(model: &Model, modes: &Modes, index: usize, points: usize) -> Shape {
    let mode = &modes.modes[index];
    let close: Vec<usize> = (0..modes.modes.len())
        .filter(|&other| is_close(mode, &modes.modes[other]))
        .collect();
    let rank = close.iter().position(|&other| other == index).unwrap_or(0);
    let omega = beside(modes, mode);
    let last = (points.max(2) - 1) as f64;
    let positions: Vec<f64> = (0..points.max(2))
        .map(|point| model.beam.length * point as f64 / last)
        .collect();
    let probe = Probe::new(model, omega, positions.clone());
    let mut space = probe.eigenspace(omega, close.len());
    let motion = space.motions.swap_remove(rank);
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
        shares: shares(&probe, model, &motion, positions.len()),
        masses: motion.masses,
        positions,
    }
}

fn is_close(a: &Mode, b: &Mode) -> bool {
    match (a.kind, b.kind) {
        (ModeKind::RigidBody, ModeKind::RigidBody) => true,
        (ModeKind::RigidBody, _) | (_, ModeKind::RigidBody) => false,
        _ => (a.omega - b.omega).norm() < CLOSE * a.omega.norm(),
    }
}

/// A frequency beside the mode's, nearer to it than to any other.
fn beside(modes: &Modes, mode: &Mode) -> Complex64 {
    const NEAR: f64 = 1e-10;
    // Of rigid-body modes anything slow against the first mode will do; slower loses digits.
    const SLOW: f64 = 1e-3;
    if mode.kind != ModeKind::RigidBody {
        return mode.omega * (1.0 + NEAR);
    }
    let first = modes
        .modes
        .iter()
        .find(|mode| mode.kind != ModeKind::RigidBody);
    let first = first.map_or(std::f64::consts::TAU * modes.to, |mode| mode.omega.norm());
    Complex64::from(SLOW * first)
}

/// Shares of the kinetic energy.
fn shares(probe: &Probe, model: &Model, motion: &Motion, skip: usize) -> Shares {
    let (material, section) = (&model.beam.material, &model.beam.section);
    let offset = section.centroid_offset;
    // Square of the radius of gyration about the centroid.
    let about_centroid = section.polar_moment / section.area - offset * offset;
    let mut shares = Shares::default();
    for (sample, [w, psi, v]) in probe.samples.iter().zip(&motion.beam[skip..]) {
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
    Shares {
        bending_y: bending_y / sum,
        bending_z: bending_z / sum,
        twist: twist / sum,
        subsystems: subsystems / sum,
        supports: supports / sum,
    }
}

//! Mode shapes for display.

use std::sync::atomic::AtomicBool;

use num_complex::Complex64;
use rayon::prelude::*;

use super::eigenspace::Probe;
use super::group::{Group, rigid_modes};
use super::motion::Motion;
use super::rigid::{self, RigidMotion};
use super::types::{Modes, Shape, Shares};
use crate::model::{Checked, Model, SupportId, UniformPart};
use crate::solve::Cancelled;
use crate::solve::beam_matrices::BeamMatrices;
use crate::solve::quadrature::Node;

/// The motion of the mode `index` of `modes` at `points` (2 or more) equally spaced positions along the beam.
///
/// Without damping it is real and normalised to modal mass 1: `phi^T M phi = 1`; with damping to bi-orthogonality,
/// `phi^T (2 omega M - i C) phi = 2 omega` (Foss, J. Appl. Mech. 25 (1958) 361-364), which is the same for C = 0. Modes
/// that share one frequency are an orthogonal basis of their space, the same for every requested `index`. For a mode of
/// an open list that the model does not have the shape is zero.
pub fn shape(model: &Checked, modes: &Modes, index: usize, points: usize) -> Shape {
    let rigid = rigid_modes(modes);
    let mut shapes = if index < rigid {
        still(model, rigid, points)
    } else {
        moving(model, &Group::of(model, modes, index), points)
    };
    let own = shapes.iter().position(|(of, _)| *of == index);
    shapes.swap_remove(own.unwrap_or_default()).1
}

/// [`shape`] of every mode, in the order of `modes`; those that share a frequency are computed together.
///
/// # Errors
/// `cancel` became true before the end.
pub fn shapes(
    model: &Checked,
    modes: &Modes,
    points: usize,
    cancel: &AtomicBool,
) -> Result<Vec<Shape>, Cancelled> {
    all(model, modes, points, cancel, &|shape| shape)
}

/// The energy shares of each mode, in the order of `modes`.
///
/// # Errors
/// `cancel` became true before the end.
pub fn shares(
    model: &Checked,
    modes: &Modes,
    cancel: &AtomicBool,
) -> Result<Vec<Shares>, Cancelled> {
    const FEWEST_POINTS: usize = 2;
    all(model, modes, FEWEST_POINTS, cancel, &|shape| shape.shares)
}

/// The results of `of` for the shape of every mode, in the order of `modes`.
fn all<T: Send>(
    model: &Model,
    modes: &Modes,
    points: usize,
    cancel: &AtomicBool,
    of: &(impl Fn(Shape) -> T + Sync),
) -> Result<Vec<T>, Cancelled> {
    let rigid = rigid_modes(modes);
    let mut is_known = vec![false; modes.modes.len()];
    let mut groups = Vec::new();
    for index in rigid..modes.modes.len() {
        if !is_known[index] {
            let group = Group::of(model, modes, index);
            group
                .members
                .iter()
                .for_each(|(member, _)| is_known[*member] = true);
            groups.push(group);
        }
    }
    let kept = |shapes: Vec<(usize, Shape)>| -> Vec<(usize, T)> {
        let shapes = shapes.into_iter();
        shapes.map(|(index, shape)| (index, of(shape))).collect()
    };
    let of_group = |group: &Group| {
        Cancelled::check(cancel)?;
        Ok(kept(moving(model, group, points)))
    };
    let found: Result<Vec<_>, Cancelled> = groups.par_iter().map(of_group).collect();
    let mut all = kept(still(model, rigid, points));
    all.extend(found?.into_iter().flatten());
    all.sort_by_key(|(index, _)| *index);
    Ok(all.into_iter().map(|(_, made)| made).collect())
}

/// `points` (2 or more) equally spaced positions along the beam, m.
fn places(model: &Model, points: usize) -> Vec<f64> {
    let last = points.max(2) - 1;
    (0..=last)
        .map(|point| model.length() * point as f64 / last as f64)
        .collect()
}

/// The rigid-body modes of a list with `count` of them, with their indices.
fn still(model: &Model, count: usize, points: usize) -> Vec<(usize, Shape)> {
    if count == 0 {
        return Vec::new();
    }
    let probe = Probe::new(model, Complex64::ZERO, places(model, points));
    let mut motions = rigid::motions(model).into_iter();
    let mut next = || match motions.next() {
        Some(motion) => rigid_motion(model, &probe, &motion),
        None => probe.at_rest(),
    };
    (0..count)
        .map(|index| (index, shaped(model, &probe, next())))
        .collect()
}

fn rigid_motion(model: &Model, probe: &Probe, rigid: &RigidMotion) -> Motion {
    let at = |x: f64| rigid.at(x).map(Complex64::from);
    let all_at = |x: f64| rigid.all_at(x).map(Complex64::from);
    Motion {
        beam: probe.places().map(all_at).collect(),
        stations: model.attached().map(|of| at(of.position)).collect(),
        supports: SupportId::all(model)
            .map(|id| id.support(model).point.motions(&all_at(id.position(model))))
            .collect(),
        joints: model
            .joints
            .iter()
            .map(|joint| rigid.jumps_at(joint.position).map(Complex64::from))
            .collect(),
        masses: rigid
            .masses
            .iter()
            .map(|mass| mass.map(Complex64::from))
            .collect(),
    }
}

/// The members of a group, with their indices in the list.
fn moving(model: &Model, group: &Group, points: usize) -> Vec<(usize, Shape)> {
    let mean = group.roots.iter().sum::<Complex64>() / group.roots.len() as f64;
    let probe = Probe::new(model, mean, places(model, points));
    let found = probe.motions(group.circle(), &group.roots);
    let members = group.members.iter().map(|&(index, root)| {
        let motion = match &found {
            Some(motions) => motions[root].clone(),
            None => probe.at_rest(),
        };
        (index, shaped(model, &probe, motion))
    });
    members.collect()
}

/// A motion for display.
fn shaped(model: &Model, probe: &Probe, motion: Motion) -> Shape {
    let positions = probe.looked_at.clone();
    let column = |row: usize| {
        let beam = motion.beam[..positions.len()].iter();
        beam.map(|q| q[row]).collect()
    };
    Shape {
        w: column(0),
        psi: column(1),
        v: column(2),
        shares: energy_shares(&probe.nodes, model, &motion, positions.len()),
        masses: motion.masses,
        positions,
    }
}

/// Shares of the kinetic energy.
fn energy_shares(nodes: &[Node], model: &Model, motion: &Motion, skip: usize) -> Shares {
    let parts = model.uniform_parts();
    let own: Vec<BeamMatrices> = parts
        .iter()
        .map(|part| BeamMatrices::new(&part.beam))
        .collect();
    let mut shares = Shares::default();
    for (node, axis) in nodes.iter().zip(&motion.beam[skip..]) {
        let part = UniformPart::index_at(&parts, node.x);
        let BeamMatrices { mass, rotary, .. } = &own[part];
        let [w, psi, v, w_slope, rate, v_slope] = parts[part].own_motions(axis);
        let section = &parts[part].beam.section;
        let (offset_y, offset_z) = (section.centroid_offset_y, section.centroid_offset);
        let about_centroid = mass.psi - mass.w * (offset_y * offset_y + offset_z * offset_z);
        let weight = node.weight;
        // Half of what both bendings share.
        let shared = rotary.w_v * (w_slope.conj() * v_slope).re;
        let along_y = mass.w * (w + offset_z * psi).norm_sqr();
        let along_z = mass.v * (v - offset_y * psi).norm_sqr();
        shares.bending_y += weight * (along_y + rotary.w * w_slope.norm_sqr() + shared);
        shares.bending_z += weight * (along_z + rotary.v * v_slope.norm_sqr() + shared);
        shares.twist += weight * (about_centroid * psi.norm_sqr() + rotary.psi * rate.norm_sqr());
    }
    for (subsystem, [y, z, theta]) in model.attached().zip(&motion.masses) {
        shares.subsystems +=
            subsystem.mass * (y.norm_sqr() + z.norm_sqr()) + subsystem.inertia * theta.norm_sqr();
    }
    for (id, moved) in SupportId::all(model).zip(&motion.supports) {
        for (restraint, moved) in id.support(model).restraints.iter().zip(moved) {
            shares.supports += restraint.elastic().inertia * moved.norm_sqr();
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

//! Bi-orthogonality of the modes of a group, from their motions.
//!
//! The modes of a damped system have `phi_i^T ((omega_i + omega_j) M - i C) phi_j = 0` (Foss, J. Appl. Mech. 25 (1958)
//! 361-364), without damping `phi_i^T M phi_j = 0`. Contour integrals achieve this up to rounding over the radius of
//! their circle, which may be small; the integrals of M and C along the beam and over the masses correct the rest.

use nalgebra::DMatrix;
use num_complex::Complex64;

use super::motion::Motion;
use crate::model::{BeamMotion, Model, SupportId, UniformPart};
use crate::solve::beam_matrices::BeamMatrices;
use crate::solve::quadrature::Node;
use crate::solve::springs::geometric_stretches;

/// Corrects motions that are nearly bi-orthogonal, with their roots, rad/s: the form above is then `2 omega_i` for i =
/// j and otherwise 0. Returns false if they are far from that: then they are not modes.
pub(super) fn bi_orthogonalise(
    model: &Model,
    nodes: &[Node],
    roots: &[Complex64],
    motions: &mut [Motion],
) -> bool {
    const NEARLY: f64 = 0.1;
    const STEPS: usize = 5;
    let count = motions.len();
    let mut form = DMatrix::from_fn(count, count, |i, j| {
        let both = [roots[i], roots[j]];
        let [mass, damping] = products(model, nodes, both, [&motions[i], &motions[j]]);
        let both = (roots[i] + roots[j]) * mass - Complex64::I * damping;
        both / (2.0 * roots[i].sqrt() * roots[j].sqrt())
    });
    let one = DMatrix::<Complex64>::identity(count, count);
    let error = (&form - &one).norm();
    if error.is_nan() || error > NEARLY {
        return false;
    }
    // The inverse square root of the form, by the iteration of Newton and Schulz.
    let mut weights = one.clone();
    for _ in 0..STEPS {
        let step = (&one * Complex64::from(3.0) - &form) * Complex64::from(0.5);
        form = step.transpose() * form * &step;
        weights *= step;
    }
    // The form is dimensionless: each motion is divided by the root of its omega.
    let scaled: Vec<Motion> = motions.to_vec();
    for (j, motion) in motions.iter_mut().enumerate() {
        let weight = |i: usize| weights[(i, j)] * (roots[j].sqrt() / roots[i].sqrt());
        *motion = scaled[0].times(weight(0));
        for (i, other) in scaled.iter().enumerate().skip(1) {
            motion.add(&other.times(weight(i)));
        }
    }
    true
}

/// `a^T M b` and `a^T C b` (without the beam's loss factor, which is a stiffness); Maxwell branches have a damping
/// between two roots, rad/s.
fn products(
    model: &Model,
    nodes: &[Node],
    roots: [Complex64; 2],
    [a, b]: [&Motion; 2],
) -> [Complex64; 2] {
    let parts = model.uniform_parts();
    let matrices: Vec<BeamMatrices> = parts.iter().map(BeamMatrices::of_part).collect();
    let (mut mass, mut damping) = (Complex64::ZERO, Complex64::ZERO);
    let looked_at = a.beam.len() - nodes.len();
    let places = a.beam[looked_at..].iter().zip(&b.beam[looked_at..]);
    for (node, (a, b)) in nodes.iter().zip(places) {
        let matrices = &matrices[UniformPart::index_at(&parts, node.x)];
        mass += node.weight * matrices.inertia(a, b);
        for (row, c) in matrices.foundation_damping.into_iter().enumerate() {
            damping += node.weight * c * a[row] * b[row];
        }
    }
    for (id, (a, b)) in SupportId::all(model).zip(a.supports.iter().zip(&b.supports)) {
        for motion in BeamMotion::ALL {
            let elastic = id.support(model)[motion].elastic();
            let product = a[motion as usize] * b[motion as usize];
            mass += elastic.inertia * product;
            damping += elastic.spring.damping_between(roots) * product;
        }
    }
    for (joint, (a, b)) in model.joints.iter().zip(a.joints.iter().zip(&b.joints)) {
        for (link, (a, b)) in joint.links.iter().zip(a.iter().zip(b)) {
            damping += link.spring().damping_between(roots) * a * b;
        }
    }
    for (index, subsystem) in model.attached().enumerate() {
        let moved = |motion: &Motion| [motion.masses[index], motion.stations[index]];
        let [[y, z, theta], _] = moved(a);
        let [[y_b, z_b, theta_b], _] = moved(b);
        mass += subsystem.mass * (y * y_b + z * z_b) + subsystem.inertia * theta * theta_b;
        let [of_a, of_b] = [a, b].map(|one| geometric_stretches(subsystem, moved(one)));
        for (spring, (one, other)) in subsystem.springs().into_iter().zip(of_a.iter().zip(of_b)) {
            damping += spring.damping_between(roots) * one * other;
        }
    }
    [mass, damping]
}

//! Undamped natural frequencies of a meshed model.

use nalgebra::{Cholesky, DMatrix};

use super::assembly::System;
use crate::model::Model;

/// The lowest `count` undamped natural frequencies, Hz, rising; rigid-body ones are near 0. As many as there are
/// unknowns at most, and none where the arithmetic fails.
///
/// K x = lambda M x is solved as the largest mu of `M x = mu (K + sigma M) x`, lambda = 1/mu - sigma: K may be singular
/// (rigid-body motions) and M too (a mass without moment of inertia), their sum is not.
pub(super) fn frequencies(model: &Model, system: &System, count: usize) -> Vec<f64> {
    let shift = shift(model);
    let mut mass = DMatrix::<f64>::zeros(system.unknowns, system.unknowns);
    system.mass(|row, column, value| mass[(row, column)] += value);
    let mut sum = &mass * shift;
    system.stiffness(|row, column, value| sum[(row, column)] += value);
    let Some(lower) = Cholesky::new(sum).map(Cholesky::unpack) else {
        return Vec::new();
    };
    // L^-1 M L^-T has the same mu.
    let reduced = lower
        .solve_lower_triangular(&mass)
        .and_then(|half| lower.solve_lower_triangular(&half.transpose()));
    let Some(reduced) = reduced else {
        return Vec::new();
    };
    let symmetric = (&reduced + reduced.transpose()) * 0.5;
    let mut largest: Vec<f64> = symmetric.symmetric_eigenvalues().iter().copied().collect();
    largest.sort_by(|a, b| b.total_cmp(a));
    largest
        .iter()
        .take(count)
        .map(|mu| (1.0 / mu - shift).max(0.0).sqrt() / std::f64::consts::TAU)
        .collect()
}

/// sigma, 1/s2: about lambda of the free beam's first bending mode, (4.73 / L)^4 E I / rho A.
fn shift(model: &Model) -> f64 {
    let (section, material) = (&model.beam.section, &model.beam.material);
    let stiffness = material.young_modulus * section.second_moment_y.min(section.second_moment_z);
    (4.73 / model.beam.length).powi(4) * stiffness / (material.density * section.area)
}

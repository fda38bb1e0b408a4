//! Identification of the functions at one point with those at another: their number and order may differ.

use nalgebra::DVector;

use super::qp::slope_along;
use super::types::Function;

/// For each function at the end of a step the index of the same one at its start, if there is one.
///
/// The change of a smooth function along a step d is (g0 + g1)^T d / 2 up to |d|^3; the pairs with the smallest error,
/// and the smallest difference of gradients, are taken first.
pub(super) fn pairs(start: &[Function], end: &[Function], d: &DVector<f64>) -> Vec<Option<usize>> {
    let mut costs: Vec<(f64, usize, usize)> = Vec::new();
    for (i, before) in start.iter().enumerate() {
        for (j, after) in end.iter().enumerate() {
            if let Some(cost) = cost(before, after, d) {
                costs.push((cost, i, j));
            }
        }
    }
    costs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut taken = vec![false; start.len()];
    let mut pairs = vec![None; end.len()];
    for (_, i, j) in costs {
        if !taken[i] && pairs[j].is_none() {
            taken[i] = true;
            pairs[j] = Some(i);
        }
    }
    pairs
}

/// The cost of identifying two functions; `None` if it is impossible.
fn cost(before: &Function, after: &Function, d: &DVector<f64>) -> Option<f64> {
    let [first, last] = [before, after].map(|f| slope_along(f, d.as_slice()));
    let missed = (after.value - before.value - 0.5 * (first + last)).abs();
    let slopes = before.gradient.iter().zip(&after.gradient);
    let (mut turned, mut steepest) = (0.0, 0.0);
    for (a, b) in slopes {
        turned += (a - b).powi(2);
        steepest += a.powi(2) + b.powi(2);
    }
    let length = d.norm();
    let rounding = 1e-12 * (before.value.abs() + after.value.abs());
    let possible = missed <= steepest.sqrt() * length + rounding;
    possible.then_some(missed + turned.sqrt() * length)
}

//! The worst case over tolerances: each variable with a tolerance may deviate by it in both directions.
//!
//! The worst case is searched among the corners of the box of tolerances: far from a kink a response is monotonic in
//! each parameter over a few percent. Up to 16 corners are all evaluated; of more, those to which the derivatives
//! point.

use super::merit::{MeritFunction, Sloped};
use super::problem::Problem;
use super::search::Function;
use crate::solve::Cancelled;

/// The search evaluates all corners of up to this number of variables with tolerances.
const MOST_FULL: usize = 4;

/// The deviations of all variables, in tolerances, from -1 to 1, whose worst case counts at a point; only zeros if no
/// variable has a tolerance. The same at the same point.
pub(super) fn deviations(
    merit_function: &MeritFunction,
    x: &[f64],
) -> Result<Vec<Vec<f64>>, Cancelled> {
    let uncertain = uncertain(merit_function.problem);
    if uncertain.len() <= MOST_FULL {
        return Ok(corners(merit_function.problem, &uncertain));
    }
    pointed_to(merit_function, x, &uncertain)
}

/// The variables that have a tolerance.
pub(super) fn uncertain(problem: &Problem) -> Vec<usize> {
    let all = problem.coordinates.iter().enumerate();
    all.filter(|(_, one)| one.variable.tolerance > 0.0)
        .map(|(index, _)| index)
        .collect()
}

/// All corners of the box over some variables.
pub(super) fn corners(problem: &Problem, uncertain: &[usize]) -> Vec<Vec<f64>> {
    let corner = |bits: usize| {
        let mut deviation = vec![0.0; problem.variables()];
        for (place, variable) in uncertain.iter().enumerate() {
            deviation[*variable] = if bits >> place & 1 == 1 { 1.0 } else { -1.0 };
        }
        deviation
    };
    (0..1_usize << uncertain.len()).map(corner).collect()
}

/// From the middle to the corner to which the derivatives of each objective's largest function, and of each limit,
/// point, and on from there until no new corner appears.
fn pointed_to(
    merit_function: &MeritFunction,
    x: &[f64],
    uncertain: &[usize],
) -> Result<Vec<Vec<f64>>, Cancelled> {
    const MOST: usize = 12;
    let middle = vec![0.0; x.len()];
    let mut known: Vec<Vec<f64>> = Vec::new();
    let mut open = vec![middle];
    while let Some(from) = open.pop() {
        let Sloped { figures, limits } = merit_function.sloped(x, &from)?;
        let highest = |functions: &Vec<Function>| {
            let highest = functions.iter().max_by(|a, b| a.value.total_cmp(&b.value));
            highest.cloned()
        };
        for function in figures.iter().filter_map(highest).chain(limits) {
            let corner = corner_of(merit_function.problem, &function, x, uncertain);
            if !known.contains(&corner) && known.len() < MOST {
                known.push(corner.clone());
                open.push(corner);
            }
        }
    }
    Ok(known)
}

/// The corner at which a function is largest, to first order.
fn corner_of(problem: &Problem, function: &Function, x: &[f64], uncertain: &[usize]) -> Vec<f64> {
    let mut corner = vec![0.0; x.len()];
    for &variable in uncertain {
        // A tolerance is a fraction of the value, for either sign.
        let value = problem.coordinates[variable].value(x[variable]);
        let grows = function.gradient[variable] * value >= 0.0;
        corner[variable] = if grows { 1.0 } else { -1.0 };
    }
    corner
}

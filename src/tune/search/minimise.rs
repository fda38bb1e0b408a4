//! The whole search: globally, then locally from the best points, while that finds improvements.

use fastrand::Rng;

use super::budget::Budget;
use super::differential_evolution::{Known, Share, evolve};
use super::sqp::Sqp;
use super::types::{Control, Landscape, Merit, Options, Outcome, Phase, Stop};

/// Minimises the sum of the largest functions in the unit box, subject to all limits.
///
/// Differential evolution searches globally, then sequential quadratic programming goes downhill from the start and
/// from the best distinct points, with derivatives. Both are repeated with new points until they find nothing better. A
/// small budget is used mostly for the local searches.
///
/// `start` has a coordinate from 0 to 1 for every variable. The same seed gives the same result on any number of
/// threads. The result is never worse than the start, also if the search is cancelled.
pub fn minimise<'a>(
    landscape: &'a dyn Landscape,
    start: &[f64],
    options: Options,
    control: Control<'a>,
) -> Outcome {
    let start: Vec<f64> = start.iter().map(|x| x.clamp(0.0, 1.0)).collect();
    let mut budget = Budget::new(landscape, &start, control);
    let first = budget.merits(std::slice::from_ref(&start), Phase::Start);
    let merit = first.first().copied().unwrap_or(Merit::WORST);
    let stop = if start.is_empty() {
        Stop::Converged
    } else {
        let seed = Known { x: start, merit };
        rounds(&mut budget, &mut Rng::with_seed(options.seed), seed)
    };
    outcome(&budget, merit, stop)
}

/// Only a local search from a start, with derivatives: finds a local minimum.
///
/// As for [`minimise`], the result is never worse than the start.
pub fn descend<'a>(landscape: &'a dyn Landscape, start: &[f64], control: Control<'a>) -> Outcome {
    let start: Vec<f64> = start.iter().map(|x| x.clamp(0.0, 1.0)).collect();
    let mut budget = Budget::new(landscape, &start, control);
    let first = budget.merits(std::slice::from_ref(&start), Phase::Start);
    let merit = first.first().copied().unwrap_or(Merit::WORST);
    let reason = descend_all(&mut budget, vec![start]);
    let stop = budget.ended().or(reason).unwrap_or(Stop::Converged);
    outcome(&budget, merit, stop)
}

fn outcome(budget: &Budget<'_>, start: Merit, stop: Stop) -> Outcome {
    let best = budget.best();
    Outcome {
        x: best.best.clone(),
        merit: best.merit,
        start,
        evaluations: best.evaluations,
        stop,
    }
}

/// Alternates global and local search, the first from the start, until they find nothing better.
fn rounds(budget: &mut Budget<'_>, random: &mut Rng, start: Known) -> Stop {
    /// Consecutive rounds without improvement.
    const PATIENCE: usize = 2;
    let mut seeds = vec![start];
    let mut stop = Stop::NotFinite;
    let mut fruitless = 0;
    while fruitless < PATIENCE {
        let before = budget.best().merit;
        let population = evolve(budget, random, &seeds, share(budget));
        let starts = distinct(&seeds, &population, walks(budget));
        let reason = descend_all(budget, starts);
        if let Some(reason) = budget.ended() {
            return reason;
        }
        if is_better(budget.best().merit, before) {
            fruitless = 0;
            stop = reason.unwrap_or(stop);
        } else {
            fruitless += 1;
            if stop == Stop::NotFinite {
                stop = reason.unwrap_or(stop);
            }
        }
        // Later rounds search elsewhere: known points would only attract them.
        seeds.clear();
    }
    stop
}

/// The share of the global search in a round.
fn share(budget: &Budget<'_>) -> Share {
    let (variables, left) = (budget.variables(), budget.left());
    // A local search takes some tens of evaluations per variable; the rest of a small budget is for the global search.
    let part = if left < 50 * variables { 4 } else { 2 };
    let evaluations = left / part;
    Share {
        size: (8 * variables).clamp(16, 96).min(evaluations.max(1)),
        evaluations,
    }
}

/// The number of local searches that the rest of the budget allows.
fn walks(budget: &Budget<'_>) -> usize {
    const MOST: usize = 6;
    (budget.left() / (20 * budget.variables())).clamp(1, MOST)
}

/// The starts of local searches: the best points that are apart, and the seeds.
fn distinct(seeds: &[Known], population: &[Known], most: usize) -> Vec<Vec<f64>> {
    const APART: f64 = 0.05;
    let mut starts: Vec<Vec<f64>> = Vec::new();
    for known in population {
        let near = |other: &Vec<f64>| {
            let apart = other.iter().zip(&known.x).map(|(a, b)| (a - b).abs());
            apart.fold(0.0, f64::max) < APART
        };
        if starts.len() < most && known.merit.goal.is_finite() && !starts.iter().any(near) {
            starts.push(known.x.clone());
        }
    }
    for seed in seeds {
        if !starts.contains(&seed.x) {
            starts.push(seed.x.clone());
        }
    }
    starts
}

/// Better by more than the last digits.
fn is_better(now: Merit, before: Merit) -> bool {
    const DIGITS: f64 = 1e-6;
    let violation = before.violation - now.violation;
    let goal = before.goal - now.goal;
    now.is_better_than(&before)
        && (violation > 0.0 || goal.is_nan() || goal > DIGITS * before.goal.abs())
}

/// Runs a local search from every start until all have stopped, and returns why the best of them did; `None` if none
/// began.
///
/// A search that comes close to a better one ends.
fn descend_all(budget: &mut Budget<'_>, starts: Vec<Vec<f64>>) -> Option<Stop> {
    let mut walks: Vec<Sqp> = starts.into_iter().map(Sqp::new).collect();
    while budget.ended().is_none() {
        let points: Vec<Vec<f64>> = walks
            .iter()
            .filter_map(Sqp::ask)
            .map(<[f64]>::to_vec)
            .collect();
        if points.is_empty() {
            break;
        }
        let evaluations = budget.evaluations(&points, Phase::Local);
        let walking = walks.iter_mut().filter(|walk| walk.ask().is_some());
        for (walk, evaluation) in walking.zip(evaluations) {
            walk.tell(evaluation);
        }
        drop_followers(&mut walks);
    }
    let merit = |walk: &Sqp| walk.merit().unwrap_or(Merit::WORST);
    let best = walks.iter().min_by(|a, b| merit(a).compare(&merit(b)))?;
    best.stopped()
}

/// Ends every search that is close to another, better one.
fn drop_followers(walks: &mut Vec<Sqp>) {
    const TOGETHER: f64 = 1e-3;
    let mut index = 0;
    while index < walks.len() {
        let walk = &walks[index];
        let follows = walk.ask().is_some()
            && walks.iter().enumerate().any(|(i, other)| {
                let (Some(own), Some(others)) = (walk.merit(), other.merit()) else {
                    return false;
                };
                let apart = walk.x().iter().zip(other.x()).map(|(a, b)| (a - b).abs());
                // Of two equal ones the first continues.
                let order = others.compare(&own).then(i.cmp(&index));
                order.is_lt() && apart.fold(0.0, f64::max) < TOGETHER
            });
        if follows {
            walks.remove(index);
        } else {
            index += 1;
        }
    }
}

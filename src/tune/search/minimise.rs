//! The whole search: all over the box, then downhill from the best points, as long as that finds more.

use fastrand::Rng;

use super::budget::Budget;
use super::differential_evolution::{Known, Share, evolve};
use super::sqp::Sqp;
use super::types::{Control, Landscape, Merit, Options, Outcome, Phase, Stop};

/// Seeks the point of the unit box where the sum of the largest functions is least and all limits are met.
///
/// Differential evolution looks all over the box, then sequential quadratic programming goes downhill from the start and
/// from the best points that differ; with derivatives where it matters. Both are repeated with fresh points until that
/// finds nothing better. Where the budget is small, most of it is for the walks downhill.
///
/// `start` has a coordinate from 0 to 1 for every variable. The same seed gives the same result on any number of threads.
/// The result is never worse than the start, also where it is cancelled.
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

/// Walks downhill from a start only, with derivatives: what it finds is the least nearby.
///
/// As of [`minimise`], the result is never worse than the start.
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

/// Global and local search in turn, the first from the start, until turns find nothing better.
fn rounds(budget: &mut Budget<'_>, random: &mut Rng, start: Known) -> Stop {
    /// Turns in a row that may find nothing.
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
        // Later turns look elsewhere: what is known already would only draw them to it.
        seeds.clear();
    }
    stop
}

/// What the global search of a turn may use.
fn share(budget: &Budget<'_>) -> Share {
    let (variables, left) = (budget.variables(), budget.left());
    // Downhill takes some tens of evaluations a variable; what a small budget leaves beside that is for looking around.
    let part = if left < 50 * variables { 4 } else { 2 };
    let evaluations = left / part;
    Share {
        size: (8 * variables).clamp(16, 96).min(evaluations.max(1)),
        evaluations,
    }
}

/// How many walks downhill the rest of the budget is good for.
fn walks(budget: &Budget<'_>) -> usize {
    const MOST: usize = 6;
    (budget.left() / (20 * budget.variables())).clamp(1, MOST)
}

/// The points to go downhill from: the best ones that lie apart, and the seeds.
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

/// Walks downhill from every start until all have stopped, and tells why the best of them did; none where none began.
///
/// A walk that comes to where a better one is ends there.
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

/// Ends every walk that is where another, better one is.
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
                // Of two that are equal the first goes on.
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

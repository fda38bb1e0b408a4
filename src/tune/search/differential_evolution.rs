//! The global search in the unit box: differential evolution.
//!
//! Storn & Price, Differential evolution, J. Global Optim. 1997, 11, 341-359, in the form current-to-pbest/1/bin of
//! Zhang & Sanderson, JADE, IEEE Trans. Evol. Comput. 2009, 13, 945-958, with the self-adaptive rates of Brest et al.,
//! IEEE Trans. Evol. Comput. 2006, 10, 646-657. Limits follow the rules of Deb ([`Merit::compare`]).

use std::cmp::Ordering;

use fastrand::Rng;

use super::budget::Budget;
use super::types::{Merit, Phase};

/// An evaluated point.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Known {
    pub(super) x: Vec<f64>,
    pub(super) merit: Merit,
}

/// The share of a global search.
#[derive(Debug, Clone, Copy)]
pub(super) struct Share {
    /// Size of the population.
    pub(super) size: usize,
    /// Largest number of evaluations.
    pub(super) evaluations: usize,
}

/// The points of the last generation, best first. It starts from a Latin hypercube with the seeds, and ends when its
/// share or the budget is used up, the points have converged or nothing better is found.
pub(super) fn evolve(
    budget: &mut Budget<'_>,
    random: &mut Rng,
    seeds: &[Known],
    share: Share,
) -> Vec<Known> {
    let fresh = share
        .size
        .saturating_sub(seeds.len())
        .min(share.evaluations);
    let points = latin_hypercube(random, fresh, budget.variables());
    let merits = budget.merits(&points, Phase::Global);
    let mut population: Vec<Member> = seeds
        .iter()
        .cloned()
        .chain(known(points, &merits))
        .map(Member::new)
        .collect();
    let mut used = fresh;
    let mut watch = Watch::default();
    // Two differences and a better one need four points.
    while population.len() >= 4 && budget.ended().is_none() && used < share.evaluations {
        let count = population.len().min(share.evaluations - used);
        used += count;
        generation(budget, random, &mut population, count);
        if watch.is_over(&population) {
            break;
        }
    }
    population.sort_by(|a, b| a.known.merit.compare(&b.known.merit));
    population.into_iter().map(|member| member.known).collect()
}

/// Points with their merits; without those that were not evaluated.
fn known(points: Vec<Vec<f64>>, merits: &[Merit]) -> impl Iterator<Item = Known> {
    points
        .into_iter()
        .zip(merits)
        .map(|(x, &merit)| Known { x, merit })
}

/// Latin hypercube: points of which every coordinate has one in each of equally wide intervals (`McKay` et al.,
/// Technometrics 1979, 21, 239-245).
fn latin_hypercube(random: &mut Rng, points: usize, variables: usize) -> Vec<Vec<f64>> {
    let mut all = vec![vec![0.0; variables]; points];
    for variable in 0..variables {
        let mut order: Vec<usize> = (0..points).collect();
        random.shuffle(&mut order);
        for (point, interval) in all.iter_mut().zip(order) {
            point[variable] = (interval as f64 + random.f64()) / points as f64;
        }
    }
    all
}

/// A member of the population with its own rates.
#[derive(Debug, Clone)]
struct Member {
    known: Known,
    rates: Rates,
}

impl Member {
    fn new(known: Known) -> Self {
        // Brest et al. start from F = 0.5 and CR = 0.9.
        let rates = Rates {
            scale: 0.5,
            crossing: 0.9,
        };
        Self { known, rates }
    }
}

/// The rates of differential evolution.
#[derive(Debug, Clone, Copy)]
struct Rates {
    /// F, the factor of a difference.
    scale: f64,
    /// CR, the probability that a coordinate changes.
    crossing: f64,
}

impl Rates {
    /// New ones at random: each with probability 0.1, F from 0.1 to 1 and CR from 0 to 1 (Brest et al., equations 5 and
    /// 6).
    fn varied(self, random: &mut Rng) -> Self {
        const OFTEN: f64 = 0.1;
        let drawn = [(); 4].map(|()| random.f64());
        Self {
            scale: if drawn[0] < OFTEN {
                0.1 + 0.9 * drawn[1]
            } else {
                self.scale
            },
            crossing: if drawn[2] < OFTEN {
                drawn[3]
            } else {
                self.crossing
            },
        }
    }
}

/// One trial point for each of the first `count` members; a trial that is not worse replaces its member. All random
/// numbers are drawn before the evaluations, so that threads do not affect the result.
fn generation(budget: &mut Budget<'_>, random: &mut Rng, population: &mut [Member], count: usize) {
    let mut order: Vec<usize> = (0..population.len()).collect();
    order.sort_by(|&a, &b| {
        population[a]
            .known
            .merit
            .compare(&population[b].known.merit)
    });
    let trials: Vec<(Vec<f64>, Rates)> = (0..count)
        .map(|index| trial(random, population, &order, index))
        .collect();
    let (points, rates): (Vec<_>, Vec<_>) = trials.into_iter().unzip();
    let merits = budget.merits(&points, Phase::Global);
    let members = population.iter_mut().zip(known(points, &merits)).zip(rates);
    for ((member, trial), rates) in members {
        if trial.merit.compare(&member.known.merit) != Ordering::Greater {
            *member = Member {
                known: trial,
                rates,
            };
        }
    }
}

/// A trial point: the member moved towards one of the best and along a difference of two others, and crossed with
/// itself. `order` is by descending merit.
fn trial(
    random: &mut Rng,
    population: &[Member],
    order: &[usize],
    index: usize,
) -> (Vec<f64>, Rates) {
    /// The part of the population that counts as best (Zhang & Sanderson: 5 to 20 %).
    const BEST: f64 = 0.15;
    let best = ((BEST * order.len() as f64).ceil() as usize).max(2);
    let rates = population[index].rates.varied(random);
    let towards = order[random.usize(..best)];
    let first = other(random, order.len(), &[index]);
    let second = other(random, order.len(), &[index, first]);
    let [own, towards, first, second] =
        [index, towards, first, second].map(|i| &population[i].known.x);
    let sure = random.usize(..own.len());
    let x = (0..own.len())
        .map(|i| {
            if random.f64() >= rates.crossing && i != sure {
                return own[i];
            }
            let moved = own[i] + rates.scale * (towards[i] - own[i] + first[i] - second[i]);
            // Halfway to a bound that it would cross (Zhang & Sanderson).
            if moved < 0.0 {
                0.5 * own[i]
            } else if moved > 1.0 {
                0.5 * (own[i] + 1.0)
            } else {
                moved
            }
        })
        .collect();
    (x, rates)
}

/// An index that is none of the given ones.
fn other(random: &mut Rng, count: usize, but: &[usize]) -> usize {
    loop {
        let index = random.usize(..count);
        if !but.contains(&index) {
            return index;
        }
    }
}

/// Whether to continue.
#[derive(Default)]
struct Watch {
    best: Option<Merit>,
    generations: usize,
}

impl Watch {
    fn is_over(&mut self, population: &[Member]) -> bool {
        /// Generations without notable improvement.
        const PATIENCE: usize = 40;
        let merits = population.iter().map(|member| member.known.merit);
        let Some(now) = merits.min_by(Merit::compare) else {
            return true;
        };
        if self.best.is_some_and(|best| !is_notably_better(now, best)) {
            self.generations += 1;
        } else {
            self.best = Some(now);
            self.generations = 0;
        }
        self.generations >= PATIENCE || is_together(population)
    }
}

fn is_notably_better(now: Merit, before: Merit) -> bool {
    const PART: f64 = 1e-4;
    let falls = |now: f64, before: f64| now < before - PART * before.abs();
    now.is_possible() && !before.is_possible()
        || falls(now.violation, before.violation)
        || now.violation == before.violation && falls(now.goal, before.goal)
}

/// True if every coordinate of all points is within a small range: the rest is for a local search.
fn is_together(population: &[Member]) -> bool {
    const RANGE: f64 = 1e-3;
    let variables = population.first().map_or(0, |member| member.known.x.len());
    (0..variables).all(|i| {
        let coordinates = population.iter().map(|member| member.known.x[i]);
        let (least, most) = coordinates.fold((1.0_f64, 0.0_f64), |(least, most), x| {
            (least.min(x), most.max(x))
        });
        most - least < RANGE
    })
}

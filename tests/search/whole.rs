//! The whole search: multimodal problems, threads, budget and cancellation.

use std::f64::consts::PI;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};

use beamtune::solve::Cancelled;
use beamtune::tune::search::{
    Control, Evaluation, Function, Landscape, Merit, Options, Outcome, Stop, descend, minimise,
};

use super::problems::{cb2, chained, hs76};
use super::{NEVER, everywhere};

/// A smooth function of x over the cube of half-width `reach`, off its middle so that no symmetric point is the optimum.
struct Smooth {
    reach: f64,
    value: fn(&[f64]) -> (f64, Vec<f64>),
    variables: usize,
}

impl Landscape for Smooth {
    fn variables(&self) -> usize {
        self.variables
    }

    fn merit(&self, x: &[f64]) -> Result<Merit, Cancelled> {
        self.evaluate(x).map(|evaluation| evaluation.merit())
    }

    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, Cancelled> {
        let width = 2.0 * self.reach;
        let x: Vec<f64> = x.iter().map(|x| width * (x - 0.57)).collect();
        let (value, gradient) = (self.value)(&x);
        let gradient = gradient.iter().map(|g| width * g).collect();
        Ok(Evaluation {
            terms: vec![vec![Function { value, gradient }]],
            limits: Vec::new(),
        })
    }
}

/// Rastrigin's: some thousand minima, 0 at 0.
fn rastrigin(x: &[f64]) -> (f64, Vec<f64>) {
    let value = x
        .iter()
        .map(|x| 10.0 + x * x - 10.0 * (2.0 * PI * x).cos())
        .sum();
    let slope = |x: &f64| 2.0 * x + 20.0 * PI * (2.0 * PI * x).sin();
    (value, x.iter().map(slope).collect())
}

/// Griewank's, J. Optim. Theory Appl. 1981, 34, 11-39: very many minima, 0 at 0.
fn griewank(x: &[f64]) -> (f64, Vec<f64>) {
    let angle = |i: usize| x[i] / ((i + 1) as f64).sqrt();
    let product = |but: Option<usize>| -> f64 {
        let others = (0..x.len()).filter(|&i| Some(i) != but);
        others.map(|i| angle(i).cos()).product()
    };
    let squares: f64 = x.iter().map(|x| x * x).sum();
    let slope =
        |i: usize| x[i] / 2000.0 + angle(i).sin() / ((i + 1) as f64).sqrt() * product(Some(i));
    let gradient = (0..x.len()).map(slope).collect();
    (1.0 + squares / 4000.0 - product(None), gradient)
}

#[test]
fn the_lowest_of_many_minima_is_found_with_nearly_every_seed() {
    let problems = [
        (
            "Rastrigin",
            Smooth {
                reach: 5.12,
                value: rastrigin,
                variables: 4,
            },
            8000,
        ),
        (
            "Griewank",
            Smooth {
                reach: 60.0,
                value: griewank,
                variables: 3,
            },
            8000,
        ),
    ];
    for (name, problem, budget) in problems {
        let mut missed = 0;
        for seed in 1..=20 {
            let found = everywhere(&problem, &vec![0.1; problem.variables], budget, seed);
            // The next lowest minima are at 0.995 (Rastrigin) and 0.0074 (Griewank).
            assert!(found.merit.goal < 1.0, "{name}, seed {seed}: {found:?}");
            assert!(found.evaluations <= budget);
            missed += usize::from(found.merit.goal > 1e-9);
        }
        assert!(
            missed <= 1,
            "{name}: {missed} of 20 seeds end in another minimum"
        );
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let problem = chained();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| everywhere(&problem, &problem.start(), 1200, 3))
    };
    let alone = on(1);
    assert_eq!(alone, on(2));
    assert_eq!(alone, on(3));
    // Another seed samples other points.
    let smooth = Smooth {
        reach: 5.12,
        value: rastrigin,
        variables: 4,
    };
    let seeds = [1, 2].map(|seed| everywhere(&smooth, &[0.1; 4], 300, seed));
    assert_ne!(seeds[0].x, seeds[1].x);
}

/// Counts the evaluations.
struct Counted<L> {
    inner: L,
    asked: AtomicUsize,
    /// From this evaluation on, it fails.
    until: usize,
}

impl<L> Counted<L> {
    fn new(inner: L, until: usize) -> Self {
        Self {
            inner,
            asked: AtomicUsize::new(0),
            until,
        }
    }
}

impl<L: Landscape> Landscape for Counted<L> {
    fn variables(&self) -> usize {
        self.inner.variables()
    }

    fn merit(&self, x: &[f64]) -> Result<Merit, Cancelled> {
        let asked = self.asked.fetch_add(1, Relaxed);
        if asked < self.until {
            self.inner.merit(x)
        } else {
            Err(Cancelled)
        }
    }

    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, Cancelled> {
        let asked = self.asked.fetch_add(1, Relaxed);
        if asked < self.until {
            self.inner.evaluate(x)
        } else {
            Err(Cancelled)
        }
    }
}

#[test]
fn no_evaluation_beyond_the_budget() {
    for budget in [0, 1, 2, 3, 10, 47, 100, 333, 1000] {
        let counted = Counted::new(
            Smooth {
                reach: 5.12,
                value: rastrigin,
                variables: 4,
            },
            usize::MAX,
        );
        let found = everywhere(&counted, &[0.1; 4], budget, 1);
        assert_eq!(found.evaluations, counted.asked.load(Relaxed), "{budget}");
        // It may have found its whole result before.
        let all = found.evaluations == budget && found.stop == Stop::Budget;
        let fewer = found.evaluations < budget && found.stop == Stop::Converged;
        assert!(all || fewer, "{budget}: {found:?}");
        assert!(!found.start.is_better_than(&found.merit));
    }
}

#[test]
fn a_small_budget_goes_downhill() {
    // Published optimum 1.952224; 40 evaluations with the start.
    let problem = cb2();
    let found = everywhere(&problem, &problem.start(), 40, 1);
    assert!(
        (found.merit.goal - problem.optimum).abs() < 1e-4,
        "{found:?}"
    );
}

/// Cancelled from `tell` after this number of evaluations.
fn cancelled_after(
    landscape: &dyn Landscape,
    start: &[f64],
    evaluations: usize,
) -> (Outcome, Merit) {
    let cancel = AtomicBool::new(false);
    let mut last = Merit::WORST;
    let found = minimise(
        landscape,
        start,
        Options { seed: 1 },
        Control {
            cancel: &cancel,
            budget: 2000,
            tell: &mut |progress| {
                last = progress.merit;
                cancel.store(progress.evaluations >= evaluations, Relaxed);
            },
        },
    );
    (found, last)
}

#[test]
fn cancelled_it_gives_the_best_so_far() {
    let problem = hs76();
    for evaluations in [1, 20, 200, 700, 1100] {
        let (found, reported) = cancelled_after(&problem, &problem.start(), evaluations);
        assert_eq!(found.stop, Stop::Cancelled, "{evaluations}");
        assert_eq!(found.merit, reported);
        assert_eq!(problem.merit(&found.x), Ok(found.merit));
        assert!(!found.start.is_better_than(&found.merit));
        assert!(found.evaluations < evaluations + 60);
    }
}

#[test]
fn a_landscape_that_gives_nothing_ends_it() {
    for until in [0, 1, 50, 900] {
        let problem = hs76();
        let start = problem.start();
        let counted = Counted::new(problem, until);
        let found = everywhere(&counted, &start, 2000, 1);
        assert_eq!(found.stop, Stop::Cancelled, "{until}");
        assert!(found.evaluations <= until);
    }
}

#[test]
fn progress_never_falls_back() {
    let problem = chained();
    let mut merits = Vec::new();
    let mut evaluations = vec![0];
    let control = Control {
        cancel: &NEVER,
        budget: 900,
        tell: &mut |progress| {
            merits.push(progress.merit);
            evaluations.push(progress.evaluations);
        },
    };
    let found = minimise(&problem, &problem.start(), Options { seed: 2 }, control);
    assert!(merits.windows(2).all(|two| !two[0].is_better_than(&two[1])));
    assert!(evaluations.windows(2).all(|two| two[0] < two[1]));
    assert_eq!(merits.last(), Some(&found.merit));
}

#[test]
fn a_start_at_the_optimum_stays() {
    let problem = chained();
    let start = vec![0.55; 10];
    let control = Control {
        cancel: &NEVER,
        budget: 100,
        tell: &mut |_| (),
    };
    let found = descend(&problem, &start, control);
    assert!(found.merit.goal <= found.start.goal);
    assert_eq!(found.stop, Stop::Converged);
    assert!(found.evaluations < 10, "{}", found.evaluations);
}

#[test]
fn points_that_meet_the_limits_come_first() {
    // Deb's rules.
    let merit = |goal, violation| Merit { goal, violation };
    assert!(merit(5.0, 0.0).is_better_than(&merit(1.0, 1e-9)));
    assert!(merit(1.0, 0.0).is_better_than(&merit(2.0, 0.0)));
    assert!(merit(9.0, 0.1).is_better_than(&merit(1.0, 0.2)));
    assert!(merit(9.0, 0.0).is_better_than(&merit(f64::NAN, 0.0)));
    assert!(!merit(f64::NAN, 0.0).is_better_than(&merit(f64::INFINITY, 0.0)));
    assert!(merit(1.0, 1.0).is_better_than(&merit(1.0, f64::NAN)));
}

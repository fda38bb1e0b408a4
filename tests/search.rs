//! The searches against published optima of test problems, closed forms and certified fits.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "search/absorber.rs"]
mod absorber;
#[path = "search/least_squares.rs"]
mod least_squares;
#[path = "search/odd.rs"]
mod odd;
#[path = "search/problems.rs"]
mod problems;
#[path = "search/whole.rs"]
mod whole;

use std::sync::atomic::AtomicBool;

use beamtune::tune::search::{Control, Landscape, Options, Outcome, Stop, descend, minimise};
use problems::{Problem, all};

static NEVER: AtomicBool = AtomicBool::new(false);

fn downhill(landscape: &dyn Landscape, start: &[f64], budget: usize) -> Outcome {
    let control = Control {
        cancel: &NEVER,
        budget,
        tell: &mut |_| (),
    };
    descend(landscape, start, control)
}

fn everywhere(landscape: &dyn Landscape, start: &[f64], budget: usize, seed: u64) -> Outcome {
    let control = Control {
        cancel: &NEVER,
        budget,
        tell: &mut |_| (),
    };
    minimise(landscape, start, Options { seed }, control)
}

/// The largest distance of a coordinate, in widths of the box.
fn apart(problem: &Problem, x: &[f64], at: &[f64]) -> f64 {
    let real = problem.real(x);
    let coordinates = real.iter().zip(at).zip(&problem.bounds);
    coordinates.fold(0.0, |most, ((x, at), [min, max])| {
        most.max((x - at).abs() / (max - min))
    })
}

#[test]
fn downhill_reaches_published_optima_in_few_evaluations() {
    for problem in all() {
        let found = downhill(&problem, &problem.start(), 60);
        let name = problem.name;
        assert_eq!(found.stop, Stop::Converged, "{name}");
        assert_eq!(found.merit.violation, 0.0, "{name}");
        // The sources give eight digits or more.
        let error = (found.merit.goal - problem.optimum).abs();
        assert!(
            error < 2e-8 * problem.optimum.abs().max(1.0),
            "{name}: {error:e}"
        );
        if let Some(at) = &problem.at {
            let apart = apart(&problem, &found.x, at);
            // If the objective is flat to the last digit at its minimum, its position is known only to the square root
            // of that.
            assert!(apart < 2e-7, "{name}: {apart:e}");
        }
    }
}

#[test]
fn the_whole_search_reaches_them_too() {
    for problem in all() {
        let found = everywhere(&problem, &problem.start(), 1500, 5);
        let name = problem.name;
        assert_eq!(found.merit.violation, 0.0, "{name}");
        let above = found.merit.goal - problem.optimum;
        assert!(
            above < 1e-6 * problem.optimum.abs().max(1.0),
            "{name}: {above:e}"
        );
    }
}

#[test]
fn limits_hold_to_the_last_digit() {
    for problem in [problems::hs71(), problems::hs76()] {
        let found = downhill(&problem, &problem.start(), 60);
        let limits = problem.evaluate(&found.x).unwrap().limits;
        assert!(limits.iter().all(|limit| limit.value <= 0.0), "{limits:?}");
        // At least one of them is active at the optimum.
        assert!(limits.iter().any(|limit| limit.value > -1e-6), "{limits:?}");
    }
}

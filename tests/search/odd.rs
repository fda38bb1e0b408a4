//! Functions that are not smooth, not finite, constant or infeasible.

use beamtune::solve::Cancelled;
use beamtune::tune::search::{Evaluation, Function, Landscape, Merit, Stop};

use super::problems::{Problem, cb2, chained};
use super::{apart, downhill, everywhere};

/// A problem from a closure.
struct Odd<F> {
    variables: usize,
    evaluate: F,
}

impl<F: Fn(&[f64]) -> Evaluation + Sync> Landscape for Odd<F> {
    fn variables(&self) -> usize {
        self.variables
    }

    fn merit(&self, x: &[f64]) -> Result<Merit, Cancelled> {
        Ok((self.evaluate)(x).merit())
    }

    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, Cancelled> {
        Ok((self.evaluate)(x))
    }
}

/// Only the functions near the largest, in an order that changes from point to point.
fn shuffled(problem: &Problem, near: f64) -> impl Landscape {
    let problem = problem.clone();
    Odd {
        variables: problem.bounds.len(),
        evaluate: move |x: &[f64]| {
            let mut evaluation = problem.evaluate(x).unwrap();
            for (index, term) in evaluation.terms.iter_mut().enumerate() {
                let top = term
                    .iter()
                    .map(|f| f.value)
                    .fold(f64::NEG_INFINITY, f64::max);
                term.retain(|f| f.value > top - near);
                let turn = (x[index] * 1e6) as usize + index;
                let length = term.len();
                term.rotate_left(turn % length);
            }
            evaluation
        },
    }
}

#[test]
fn functions_may_come_and_go_and_change_places() {
    for (problem, near) in [(cb2(), 0.2), (cb2(), 5.0), (chained(), 0.5)] {
        let landscape = shuffled(&problem, near);
        let found = downhill(&landscape, &problem.start(), 200);
        let error = found.merit.goal - problem.optimum;
        assert!(
            error.abs() < 1e-8 * problem.optimum,
            "{error:e} after {}",
            found.evaluations
        );
        if let Some(at) = &problem.at {
            assert!(apart(&problem, &found.x, at) < 1e-7);
        }
    }
}

/// |x - 0.3| + 2 |y - 0.6| given by the side that it is on only, as if the other were not there; 0 at (0.3, 0.6).
#[test]
fn a_kink_that_is_not_announced_is_found() {
    let kink = Odd {
        variables: 2,
        evaluate: |x: &[f64]| {
            let side = |x: f64, at: f64, slope: f64| slope * if x < at { -1.0 } else { 1.0 };
            let slopes = vec![side(x[0], 0.3, 1.0), side(x[1], 0.6, 2.0)];
            Evaluation {
                terms: vec![vec![Function {
                    value: (x[0] - 0.3).abs() + 2.0 * (x[1] - 0.6).abs(),
                    gradient: slopes,
                }]],
                limits: Vec::new(),
            }
        },
    };
    let found = downhill(&kink, &[0.9, 0.1], 200);
    assert!(found.merit.goal < 1e-6, "{found:?}");
}

/// Infinite for y < x, not a number near the upper corner, (x - 0.5)^2 + (y - 0.7)^2 elsewhere: least at (0.5, 0.7).
fn holes() -> impl Landscape {
    Odd {
        variables: 2,
        evaluate: |x: &[f64]| {
            let value = if x[1] < x[0] {
                f64::INFINITY
            } else if x[1] > 0.9 {
                f64::NAN
            } else {
                (x[0] - 0.5).powi(2) + (x[1] - 0.7).powi(2)
            };
            Evaluation {
                terms: vec![vec![Function {
                    value,
                    gradient: vec![2.0 * (x[0] - 0.5), 2.0 * (x[1] - 0.7)],
                }]],
                limits: Vec::new(),
            }
        },
    }
}

#[test]
fn values_that_are_not_finite_are_avoided() {
    for start in [[0.9, 0.1], [0.5, 0.95], [0.0, 0.0]] {
        let found = everywhere(&holes(), &start, 300, 1);
        assert!(found.merit.goal < 1e-12, "{found:?}");
    }
    assert_eq!(downhill(&holes(), &[0.9, 0.1], 50).stop, Stop::NotFinite);
    // The minimum is in a hole out of reach of the first steps.
    let found = downhill(&holes(), &[0.0, 0.89], 100);
    assert!(found.merit.goal < 1e-12, "{found:?}");
}

#[test]
fn a_plateau_ends_the_walk_at_once() {
    let flat = Odd {
        variables: 3,
        evaluate: |x: &[f64]| Evaluation {
            terms: vec![vec![Function {
                value: 7.0,
                gradient: vec![0.0; x.len()],
            }]],
            limits: Vec::new(),
        },
    };
    let found = downhill(&flat, &[0.2, 0.4, 0.6], 100);
    assert_eq!((found.stop, found.evaluations), (Stop::Converged, 2));
    assert_eq!(found.x, [0.2, 0.4, 0.6]);
    assert_eq!(everywhere(&flat, &[0.2; 3], 5000, 1).x, [0.2; 3]);
}

/// x >= 0.8 and x <= 0.2 contradict each other; the sum of the violations is 0.6 for every x between.
#[test]
fn limits_that_cannot_be_met_are_reported() {
    let impossible = Odd {
        variables: 1,
        evaluate: |x: &[f64]| {
            let line = |value: f64, slope: f64| Function {
                value,
                gradient: vec![slope],
            };
            Evaluation {
                terms: vec![vec![line(x[0], 1.0)]],
                limits: vec![line(0.8 - x[0], -1.0), line(x[0] - 0.2, 1.0)],
            }
        },
    };
    let found = downhill(&impossible, &[0.95], 100);
    assert_eq!(found.stop, Stop::LimitsUnmet);
    assert!((found.merit.violation - 0.6).abs() < 1e-9, "{found:?}");
}

/// Goals and limits in units of 1e-9 and 1e12: least x1 + x2 with x1 x2 >= 0.16, at (0.4, 0.4).
#[test]
fn units_do_not_matter() {
    for (goal, limit) in [(1e-9, 1.0), (1.0, 1e12), (1e12, 1e-9)] {
        let scaled = Odd {
            variables: 2,
            evaluate: move |x: &[f64]| Evaluation {
                terms: vec![vec![Function {
                    value: goal * (x[0] + x[1]),
                    gradient: vec![goal; 2],
                }]],
                limits: vec![Function {
                    value: limit * (0.16 - x[0] * x[1]),
                    gradient: vec![-limit * x[1], -limit * x[0]],
                }],
            },
        };
        let found = downhill(&scaled, &[0.1, 0.7], 60);
        assert_eq!((found.stop, found.merit.violation), (Stop::Converged, 0.0));
        assert!(found.x.iter().all(|x| (x - 0.4).abs() < 1e-8), "{found:?}");
    }
}

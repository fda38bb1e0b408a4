//! Candidates that cannot be solved are worse than any other, and do not stop the search.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::*;
use crate::model::{self, Hold, Model, Variable, checked};

static NEVER: AtomicBool = AtomicBool::new(false);

fn variable(path: &str, min: f64, max: f64) -> Variable {
    Variable {
        paths: vec![path.into()],
        hold: Hold::Equal,
        min,
        max,
        scale: None,
        tolerance: 0.0,
    }
}

/// A model with a peak to minimise and these variables alone.
fn problem(mut model: Model, variables: Vec<Variable>) -> Problem {
    model.tune.as_mut().unwrap().variables = variables;
    Problem::new(&checked(&model), Path::new(".")).unwrap()
}

fn cantilever() -> Model {
    let preset = crate::presets::find("cantilever").unwrap();
    model::read(preset.text).unwrap().into_inner()
}

fn assert_is_worst(merit_function: &MeritFunction<'_>, x: &[f64]) {
    assert_eq!(merit_function.merit(x), Ok(Merit::WORST));
    let evaluation = merit_function.evaluate(x).unwrap();
    assert_eq!(evaluation.merit(), Merit::WORST);
}

/// Expected: by its wave numbers a beam as soft as that has more modes in the band than are listed.
#[test]
fn a_candidate_with_too_many_modes_is_the_worst() {
    let soft = variable("beam.material.young_modulus", 1e-17, 2.1e13);
    let problem = problem(cantilever(), vec![soft]);
    let start = problem.point_of(problem.model());
    let merit_function = MeritFunction::new(&problem, &start, &NEVER).unwrap();
    assert_is_worst(&merit_function, &[0.0]);
}

/// Closed form: each variable is possible at its bounds, the largest area and the least polar moment together are not:
/// `I_0` = 2e-4 m4 is less than `A z_c^2` = 0.03 * 0.1^2 m4, which is the share of the centroid alone.
#[test]
fn a_candidate_that_variables_make_impossible_together_is_the_worst() {
    let mut model = cantilever();
    model.beam.section.polar_moment = 4e-4;
    model.beam.section.centroid_offset = 0.1;
    assert_eq!(model::check(&model), []);
    let area = variable("beam.section.area", 0.01, 0.03);
    let polar = variable("beam.section.polar_moment", 2e-4, 4e-4);
    let problem = problem(model, vec![area, polar]);
    let start = problem.point_of(problem.model());
    let merit_function = MeritFunction::new(&problem, &start, &NEVER).unwrap();
    assert_is_worst(&merit_function, &[1.0, 0.0]);
    let possible = merit_function.merit(&[1.0, 1.0]).unwrap();
    assert!(possible.is_better_than(&Merit::WORST));
}

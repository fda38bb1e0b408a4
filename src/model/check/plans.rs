//! The rules of the studies and the tuning: their paths, values and members.

use super::super::fault::Fault;
use super::super::names;
use super::super::path;
use super::super::serial::format_number;
use super::super::tuning::{Tune, Variable};
use super::super::types::{Case, Family, Model, Supports};
use super::{band, element_keys, element_names, not_finite, state};
use std::collections::HashSet;

/// The most curves of a study.
const MOST_CURVES: usize = 10_000;

/// Adds the faults of studies and tuning to those of the structure.
///
/// Whether every curve of a study is possible is not asked: a study that is not shown must not stand in the way of an
/// edit. [`path::apply`] says so where the curve is wanted.
pub(super) fn check(model: &Model, faults: &mut Vec<Fault>) {
    if model.studies.is_empty() && model.tune.is_none() {
        return;
    }
    // Without the plans: a plan within a plan would never end. With free ends: there every spring has a number, and a
    // study of one need not go when its end is clamped for a while.
    let bare = Model {
        supports: Supports::default(),
        studies: Vec::new(),
        tune: None,
        ..model.clone()
    };
    let mut known = Vec::new();
    state(&bare, &mut known);
    let plans = Plans {
        bare,
        known: known.into_iter().map(|fault| fault.path).collect(),
    };

    let names = model.studies.iter().map(|study| study.name.as_str());
    element_names("studies", names.clone(), faults);
    for (study, key) in model.studies.iter().zip(element_keys(names)) {
        plans.family(&format!("studies.{key}"), &study.family, faults);
    }
    if let Some(tune) = &model.tune {
        plans.tune(tune, faults);
    }
}

/// What studies and tuning are judged by.
struct Plans {
    /// The model without studies and tuning, its ends free.
    bare: Model,
    /// Paths at which that model is faulty by itself.
    known: HashSet<String>,
}

impl Plans {
    fn family(&self, at: &str, family: &Family, faults: &mut Vec<Fault>) {
        match family {
            Family::Vary {
                paths,
                operation,
                values,
            } => {
                not_empty(&format!("{at}.vary"), paths.len(), "path", faults);
                for (index, pattern) in paths.iter().enumerate() {
                    self.pattern(&format!("{at}.vary.{}", index + 1), pattern, faults);
                }
                let list = format!("{at}.{}", operation.key());
                count(&list, values.len(), "value", faults);
                for (index, value) in values.iter().enumerate().take(MOST_CURVES) {
                    let place = format!("{list}.{}", index + 1);
                    if !value.is_finite() {
                        faults.push(Fault::new(place, not_finite(*value)));
                    }
                }
            }
            Family::Cases(cases) => {
                let list = format!("{at}.cases");
                count(&list, cases.len(), "case", faults);
                let names = cases.iter().map(|case| case.name.as_str());
                element_names(&list, names.clone(), faults);
                for (case, key) in cases.iter().zip(element_keys(names)).take(MOST_CURVES) {
                    self.case(&format!("{list}.{key}"), case, faults);
                }
            }
        }
    }

    /// The paths and values of a case.
    fn case(&self, place: &str, case: &Case, faults: &mut Vec<Fault>) {
        let mut seen = HashSet::new();
        for (pattern, value) in &case.set {
            let path = format!("{place}.set.{}", names::segment(pattern));
            self.pattern(&path, pattern, faults);
            if !value.is_finite() {
                faults.push(Fault::new(&path, not_finite(*value)));
            }
            if !seen.insert(pattern) {
                faults.push(Fault::new(
                    &path,
                    "is set twice; must be set once in a case",
                ));
            }
        }
    }

    /// A pattern must stand for numbers.
    fn pattern(&self, at: &str, pattern: &str, faults: &mut Vec<Fault>) {
        if let Err(fault) = path::numbers(&self.bare, pattern) {
            faults.push(Fault::new(at, format!("{}: {}", fault.path, fault.message)));
        }
    }

    fn tune(&self, tune: &Tune, faults: &mut Vec<Fault>) {
        not_empty("tune.variables", tune.variables.len(), "variable", faults);
        for (index, variable) in tune.variables.iter().enumerate() {
            self.variable(&format!("tune.variables.{}", index + 1), variable, faults);
        }
        let objective = &tune.objectives[0];
        let name = objective.aim.response().unwrap_or_default();
        let responses = || self.bare.responses.iter();
        let message = match responses().find(|response| response.name == name) {
            Some(response) if response.enabled => None,
            Some(_) => Some(format!(
                "{:?} is disabled; must be an enabled response",
                name
            )),
            None => {
                let near = names::nearest(name, responses().map(|response| response.name.as_str()));
                let near =
                    near.map_or_else(String::new, |near| format!(" (did you mean {near:?}?)"));
                Some(format!(
                    "{:?} is no response{near}; must be the name of one",
                    name
                ))
            }
        };
        faults.extend(message.map(|message| Fault::new("tune.objective.response", message)));
        for (key, value) in [("from", objective.from), ("to", objective.to)] {
            if !value.is_finite() {
                faults.push(Fault::new(
                    format!("tune.objective.{key}"),
                    not_finite(value),
                ));
            } else if value <= 0.0 {
                faults.push(Fault::new(
                    format!("tune.objective.{key}"),
                    format!("is {}; must be > 0", format_number(value)),
                ));
            }
        }
        band("tune.objective", objective.from, objective.to, faults);
    }

    fn variable(&self, at: &str, variable: &Variable, faults: &mut Vec<Fault>) {
        let before = faults.len();
        self.pattern(&format!("{at}.path"), &variable.paths[0], faults);
        for (key, value) in [("min", variable.min), ("max", variable.max)] {
            if !value.is_finite() {
                faults.push(Fault::new(format!("{at}.{key}"), not_finite(value)));
            }
        }
        if variable.min >= variable.max {
            faults.push(Fault::new(
                format!("{at}.min"),
                format!(
                    "is {}; must be below max = {}",
                    format_number(variable.min),
                    format_number(variable.max)
                ),
            ));
        }
        if faults.len() > before {
            return;
        }
        for (key, value) in [("min", variable.min), ("max", variable.max)] {
            let mut bare = self.bare.clone();
            if path::set_unchecked(&mut bare, &variable.paths[0], path::Value::Number(value))
                .is_err()
            {
                continue;
            }
            let mut found = Vec::new();
            state(&bare, &mut found);
            if let Some(fault) = found
                .into_iter()
                .find(|fault| !self.known.contains(&fault.path))
            {
                let message = format!(
                    "makes the model impossible: {}: {}",
                    fault.path, fault.message
                );
                faults.push(Fault::new(format!("{at}.{key}"), message));
            }
        }
    }
}

/// A list that needs an element.
fn not_empty(path: &str, length: usize, what: &str, faults: &mut Vec<Fault>) {
    if length == 0 {
        faults.push(Fault::new(
            path,
            format!("is empty; must have at least one {what}"),
        ));
    }
}

/// A list of curves.
fn count(path: &str, length: usize, what: &str, faults: &mut Vec<Fault>) {
    not_empty(path, length, what, faults);
    if length > MOST_CURVES {
        faults.push(Fault::new(
            path,
            format!("has {length}; must have at most {MOST_CURVES} {what}s"),
        ));
    }
}

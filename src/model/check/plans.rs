//! The rules of the studies and the tuning: their paths, values and members.

use super::super::fault::Fault;
use super::super::names;
use super::super::path;
use super::super::serial::format_number;
use super::super::types::{Case, Family, Model, Tune, Variable};
use super::{band, element_keys, element_names, not_finite, state};
use std::collections::HashSet;

/// The most curves of a study.
const MOST_CURVES: usize = 10_000;

/// Adds the faults of studies and tuning to those of the structure.
pub(super) fn check(model: &Model, faults: &mut Vec<Fault>) {
    // Members are judged without the plans: a plan within a plan would never end.
    let bare = Model {
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
    /// The model without studies and tuning.
    bare: Model,
    /// Paths at which that model is faulty by itself.
    known: HashSet<String>,
}

impl Plans {
    fn family(&self, at: &str, family: &Family, faults: &mut Vec<Fault>) {
        let before = faults.len();
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
                let paths_hold = faults.len() == before;
                let list = format!("{at}.{}", operation.key());
                count(&list, values.len(), "value", faults);
                for (index, value) in values.iter().enumerate().take(MOST_CURVES) {
                    let place = format!("{list}.{}", index + 1);
                    if !value.is_finite() {
                        faults.push(Fault::new(place, not_finite(*value)));
                    } else if paths_hold {
                        self.member(&place, family, index, faults);
                    }
                }
            }
            Family::Cases(cases) => {
                let list = format!("{at}.cases");
                count(&list, cases.len(), "case", faults);
                let names = cases.iter().map(|case| case.name.as_str());
                element_names(&list, names.clone(), faults);
                for (index, key) in element_keys(names)
                    .into_iter()
                    .enumerate()
                    .take(MOST_CURVES)
                {
                    let place = format!("{list}.{key}");
                    if self.case(&place, &cases[index], faults) {
                        self.member(&place, family, index, faults);
                    }
                }
            }
        }
    }

    /// The paths and values of a case; true where they hold.
    fn case(&self, place: &str, case: &Case, faults: &mut Vec<Fault>) -> bool {
        let before = faults.len();
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
        faults.len() == before
    }

    /// A pattern must stand for numbers.
    fn pattern(&self, at: &str, pattern: &str, faults: &mut Vec<Fault>) {
        let numbers = |concrete: Vec<String>| {
            concrete
                .iter()
                .try_for_each(|path| path::number(&self.bare, path).map(|_| ()))
        };
        if let Err(fault) = path::expand(&self.bare, pattern).and_then(numbers) {
            faults.push(Fault::new(at, format!("{}: {}", fault.path, fault.message)));
        }
    }

    /// A curve of a study must be a possible model, as far as the model is one without it.
    fn member(&self, place: &str, family: &Family, index: usize, faults: &mut Vec<Fault>) {
        let Err(found) = path::apply(&self.bare, family, index) else {
            return;
        };
        let mut new = found
            .into_iter()
            .filter(|fault| !self.known.contains(&fault.path));
        let Some(first) = new.next() else { return };
        let more = match new.count() {
            0 => String::new(),
            more => format!(" (and {more} more)"),
        };
        let label = label(family, index);
        let message = format!(
            "makes the curve {label:?} impossible: {}: {}{more}",
            first.path, first.message
        );
        faults.push(Fault::new(place, message));
    }

    fn tune(&self, tune: &Tune, faults: &mut Vec<Fault>) {
        not_empty("tune.variables", tune.variables.len(), "variable", faults);
        for (index, variable) in tune.variables.iter().enumerate() {
            self.variable(&format!("tune.variables.{}", index + 1), variable, faults);
        }
        let objective = &tune.objective;
        let responses = || self.bare.responses.iter();
        let message = match responses().find(|response| response.name == objective.response) {
            Some(response) if response.enabled => None,
            Some(_) => Some(format!(
                "{:?} is disabled; must be an enabled response",
                objective.response
            )),
            None => {
                let near = names::nearest(
                    &objective.response,
                    responses().map(|response| response.name.as_str()),
                );
                let near =
                    near.map_or_else(String::new, |near| format!(" (did you mean {near:?}?)"));
                Some(format!(
                    "{:?} is no response{near}; must be the name of one",
                    objective.response
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
        self.pattern(&format!("{at}.path"), &variable.path, faults);
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
            if path::set_unchecked(&mut bare, &variable.path, path::Value::Number(value)).is_err() {
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

/// What the curve of one member is called.
fn label(family: &Family, index: usize) -> String {
    match family {
        Family::Vary {
            operation, values, ..
        } => {
            let alone = Family::Vary {
                paths: Vec::new(),
                operation: *operation,
                values: vec![values[index]],
            };
            path::family_labels(&alone).pop().unwrap_or_default()
        }
        Family::Cases(cases) => cases[index].name.clone(),
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

//! The rules of the studies: their paths, values and members.

use super::super::fault::Fault;
use super::super::path::{self, Pattern};
use super::super::spelling::{self, element_keys};
use super::super::types::{Case, Family, Model, Supports};
use super::{element_names, not_finite, state, tuning};
use std::collections::HashSet;

/// The most curves of a study.
const MOST_CURVES: usize = 10_000;

/// Adds the faults of studies and tuning to those of the structure.
///
/// Does not check the members of a study: a hidden study must not block an edit.
/// [`edit::apply`](super::super::edit::apply) checks a member when its curve is needed.
pub(super) fn check(model: &Model, faults: &mut Vec<Fault>) {
    if model.studies.is_empty() && model.tune.is_none() {
        return;
    }
    // Without studies and tuning, to avoid recursion. With free ends, where every spring has a number, so that a study
    // of a spring remains valid while its end is clamped.
    let bare = Model {
        supports: Supports::default(),
        studies: Vec::new(),
        tune: None,
        ..model.clone()
    };
    let mut known = Vec::new();
    state(&bare, &mut known);
    let bare = BareModel {
        model: bare,
        known: known.into_iter().map(|fault| fault.path).collect(),
    };

    let names = model.studies.iter().map(|study| study.name.as_str());
    element_names("studies", &names, faults);
    for (study, key) in model.studies.iter().zip(element_keys(names)) {
        bare.family(&format!("studies.{key}"), &study.family, faults);
    }
    if let Some(tune) = &model.tune {
        tuning::check(model, &bare, tune, faults);
    }
}

/// The model against which studies and tuning are checked.
pub(super) struct BareModel {
    /// The model without studies and tuning, with free ends.
    pub(super) model: Model,
    /// Paths of the faults of that model itself.
    pub(super) known: HashSet<String>,
}

impl BareModel {
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
                element_names(&list, &names, faults);
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
            let path = format!("{place}.set.{}", spelling::segment(pattern));
            self.pattern(&path, pattern, faults);
            if !value.is_finite() {
                faults.push(Fault::new(&path, not_finite(*value)));
            }
            if !seen.insert(&**pattern) {
                faults.push(Fault::new(
                    &path,
                    "is set twice; must be set once in a case",
                ));
            }
        }
    }

    /// A pattern must match numbers.
    fn pattern(&self, at: &str, pattern: &Pattern, faults: &mut Vec<Fault>) {
        if let Err(fault) = path::numbers_of(&self.model, pattern) {
            faults.push(Fault::new(at, format!("{}: {}", fault.path, fault.message)));
        }
    }
}

/// A list that must not be empty.
pub(super) fn not_empty(path: &str, length: usize, what: &str, faults: &mut Vec<Fault>) {
    if length == 0 {
        faults.push(Fault::new(
            path,
            format!("is empty; must have at least one {what}"),
        ));
    }
}

/// The number of curves of a study.
fn count(path: &str, length: usize, what: &str, faults: &mut Vec<Fault>) {
    not_empty(path, length, what, faults);
    if length > MOST_CURVES {
        faults.push(Fault::new(
            path,
            format!("has {length}; must have at most {MOST_CURVES} {what}s"),
        ));
    }
}

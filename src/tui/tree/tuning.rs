//! The rows of a model's tuning, and the words of its variables.

use crate::model::{Combine, Limit, Model, Objective, Tune, Variable};

/// A variable of a model's tuning.
pub fn variable_at(model: &Model, i: usize) -> Option<&Variable> {
    model.tune.as_ref()?.variables.get(i)
}

/// An objective of a model's tuning.
pub fn objective_at(model: &Model, i: usize) -> Option<&Objective> {
    model.tune.as_ref()?.objectives.get(i)
}

/// A limit of a model's tuning.
pub fn limit_at(model: &Model, i: usize) -> Option<&Limit> {
    model.tune.as_ref()?.limits.get(i)
}

/// How several objectives are combined; empty for one.
pub(super) fn combination(tune: &Tune) -> String {
    match (tune.objectives.len(), tune.combine) {
        (0 | 1, _) => String::new(),
        (count, Combine::Sum) => format!("sum of {count}"),
        (count, Combine::Worst) => format!("worst of {count}"),
    }
}

/// The first path in short form, and the number of others: `S1 y left stiffness`, `* mass +1`.
pub(super) fn variable_label(variable: &Variable) -> String {
    let Some(first) = variable.paths.first() else {
        return String::new();
    };
    let own = ["subsystems.", "supports."]
        .iter()
        .find_map(|list| first.strip_prefix(list))
        .unwrap_or(first);
    let own = own.replace(['.', '_'], " ");
    match variable.paths.len() {
        1 => own,
        count => format!("{own} +{}", count - 1),
    }
}

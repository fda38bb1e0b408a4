//! The words of a tuning's rows: what moves, what is sought, what must be kept.

use crate::model::{Aim, Combine, Limit, Model, Objective, Tune, Unit, Variable};
use crate::tune::words::{band, level, range};

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

/// How several objectives are one; empty for one.
pub(super) fn combination(tune: &Tune) -> String {
    match (tune.objectives.len(), tune.combine) {
        (0 | 1, _) => String::new(),
        (count, Combine::Sum) => format!("sum of {count}"),
        (count, Combine::Worst) => format!("worst of {count}"),
    }
}

/// The first path in short, and how many more there are: `S1 y left stiffness`, `* mass +1`.
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

/// What is sought.
pub(super) const fn objective_label(aim: &Aim) -> &'static str {
    match aim {
        Aim::Peak { .. } => "least peak",
        Aim::MeanSquare { .. } => "least mean square",
        Aim::Energy => "least energy",
        Aim::Width { .. } => "widest band",
        Aim::AntiResonance { .. } => "anti-resonance",
        Aim::Match { .. } => "match",
    }
}

/// Of what it is sought, and where.
pub(super) fn objective_value(model: &Model, objective: &Objective) -> String {
    let band = band(objective);
    match &objective.aim {
        Aim::Peak { response } | Aim::MeanSquare { response } => format!("{response} {band}"),
        Aim::Energy => band,
        Aim::Width { response, below } => {
            format!("{response} < {}", level(model, response, *below))
        }
        Aim::AntiResonance { response, at } => format!("{response} at {}", Unit::HERTZ.format(*at)),
        Aim::Match { response, file, .. } => format!("{response} {file}"),
    }
}

/// What is limited.
pub(super) const fn limit_label(limit: &Limit) -> &'static str {
    match limit {
        Limit::AddedMass { .. } => "added mass",
        Limit::NoMode { .. } => "no mode",
        Limit::StaticDeflection { .. } => "static deflection",
    }
}

/// How far.
pub(super) fn limit_value(model: &Model, limit: &Limit) -> String {
    match limit {
        Limit::AddedMass { at_most } => format!("<= {}", Unit::KILOGRAM.format(*at_most)),
        Limit::NoMode { from, to } => range(*from, *to, Unit::HERTZ),
        Limit::StaticDeflection { response, at_most } => {
            format!("{response} <= {}", level(model, response, *at_most))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Node, all_rows, label, value};
    use super::*;
    use crate::model::Group;

    fn model() -> Model {
        crate::model::read(include_str!("../../../tests/data/tuned.toml")).unwrap()
    }

    #[test]
    fn rows_say_what_moves_what_for_and_within_what() {
        let model = model();
        let tuning = |node: &Node| {
            matches!(
                node,
                Node::Group(Group::Variable(_) | Group::Objective(_) | Group::Limit(_))
            )
        };
        let rows = all_rows(&model).into_iter().map(|row| row.node);
        let texts: Vec<_> = rows
            .filter(tuning)
            .map(|node| format!("{}: {}", label(&model, node), value(&model, node)))
            .collect();
        assert_eq!(
            texts,
            [
                "* z left stiffness: 0.1..100 MN/m",
                "left w damping +1: 0.001..10 kN s/m",
                "* mass +1: 10..300 kg",
                "least peak: P5 w 20..120 Hz",
                "least mean square: P5 v 20..120 Hz",
                "least energy: 20..120 Hz",
                "widest band: P5 w < 1e-7 m",
                "anti-resonance: P5 w at 85 Hz",
                "match: P5 w measured.csv",
                "match: P5 v measured.unv",
                "added mass: <= 300 kg",
                "no mode: 45..55 Hz",
                "static deflection: P5 w <= 0.001 m",
            ]
        );
        assert_eq!(value(&model, Node::Group(Group::Tune)), "worst of 7");
    }
}

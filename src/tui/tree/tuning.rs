//! The words of a tuning's rows: what moves, what is sought, what must be kept.

use crate::model::path::{self, Parameter};
use crate::model::{
    Aim, Combine, Compare, Hold, Limit, Model, Objective, Spacing, Tune, Unit, Variable,
};
use crate::solve::form::Dimension;

/// How many of something a tuning has; 0 where there is no tuning.
pub(super) fn count(model: &Model, of: impl Fn(&Tune) -> usize) -> usize {
    model.tune.as_ref().map_or(0, of)
}

/// A variable of a model's tuning.
pub(super) fn variable_at(model: &Model, i: usize) -> Option<&Variable> {
    model.tune.as_ref()?.variables.get(i)
}

/// An objective of a model's tuning.
pub(super) fn objective_at(model: &Model, i: usize) -> Option<&Objective> {
    model.tune.as_ref()?.objectives.get(i)
}

/// A limit of a model's tuning.
pub(super) fn limit_at(model: &Model, i: usize) -> Option<&Limit> {
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

/// The bounds: `0.1..100 MN/m`.
pub(super) fn bounds(model: &Model, variable: &Variable) -> String {
    let unit = first_parameter(model, variable).map_or(Unit::ONE, |first| first.unit);
    range(variable.min, variable.max, unit)
}

fn first_parameter(model: &Model, variable: &Variable) -> Option<Parameter> {
    let (first, _) = variable.parameters(model).ok()?.into_iter().next()?;
    path::parameter(model, &first).ok()
}

/// Two numbers with one unit, that of the larger.
fn range(from: f64, to: f64, unit: Unit) -> String {
    let large = if from.abs() > to.abs() { from } else { to };
    let shown = unit.format(large);
    let number = shown.split(' ').next().unwrap_or_default();
    // The unit that is shown is a power of ten of the own one.
    let power = number
        .parse::<f64>()
        .map_or(0.0, |number| (large / number).log10().round());
    let power = if power.is_finite() { power as i32 } else { 0 };
    let in_unit = |value: f64| Unit::ONE.format(value / 10.0_f64.powi(power));
    let rest = shown.strip_prefix(number).unwrap_or_default();
    format!("{}..{}{rest}", in_unit(from), in_unit(to))
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
    let band = range(objective.from, objective.to, Unit::HERTZ);
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

/// A level of a response in its unit.
fn level(model: &Model, response: &str, value: f64) -> String {
    let found = model.responses.iter().find(|one| one.name == response);
    let dimension = found.and_then(|one| Dimension::of(&one.quantity, None));
    let unit = dimension.map_or_else(String::new, |one| one.unit(one.form_of_measure()));
    let number = Unit::ONE.format(value);
    format!("{number} {unit}").trim_end().to_owned()
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

/// Everything about a variable, a line for each thing.
pub fn variable_in_words(model: &Model, i: usize) -> String {
    let Some(variable) = variable_at(model, i) else {
        return String::new();
    };
    let together = match (variable.paths.len(), variable.hold) {
        (0 | 1, Hold::Equal) => "",
        (_, Hold::Equal) => " (all equal)",
        (_, Hold::Ratio) => " (in their ratios)",
    };
    let mut lines = vec![format!("{}{together}", variable.paths.join(", "))];
    if let Ok(parameters) = variable.parameters(model)
        && let Some((first, now)) = parameters.first()
        && let Ok(parameter) = path::parameter(model, first)
    {
        let count = match parameters.len() {
            1 => String::new(),
            count => format!(", first of {count}"),
        };
        lines.push(format!("now {}{count}", parameter.unit.format(*now)));
    }
    let scale = match variable.spacing() {
        Spacing::Linear => "",
        Spacing::Log => ", by its logarithm",
    };
    let tolerance = if variable.tolerance > 0.0 {
        format!(", +-{} %", Unit::ONE.format(variable.tolerance))
    } else {
        String::new()
    };
    lines.push(format!("{}{scale}{tolerance}", bounds(model, variable)));
    lines.join("\n")
}

/// Everything about an objective.
pub fn objective_in_words(model: &Model, i: usize) -> String {
    let Some(objective) = objective_at(model, i) else {
        return String::new();
    };
    let band = range(objective.from, objective.to, Unit::HERTZ);
    let of = |response: &str| format!("of {response}, {band}");
    let text = match &objective.aim {
        Aim::Peak { response } => format!("the least highest peak {}", of(response)),
        Aim::MeanSquare { response } => format!("the least mean square {}", of(response)),
        Aim::Energy => format!("the least mean vibration energy of the beam, {band}"),
        Aim::Width { response, below } => format!(
            "the widest band {}, below {}",
            of(response),
            level(model, response, *below)
        ),
        Aim::AntiResonance { response, at } => format!(
            "an anti-resonance {}, at {}",
            of(response),
            Unit::HERTZ.format(*at)
        ),
        Aim::Match {
            response,
            file,
            curve,
            compare,
        } => {
            let curve = curve
                .as_ref()
                .map_or_else(String::new, |curve| format!(", curve {curve}"));
            let what = match compare {
                Compare::LogMagnitude => "the magnitude in decibels",
                Compare::Complex => "real and imaginary part",
            };
            format!("{what} {} as in {file}{curve}", of(response))
        }
    };
    if objective.weight == 1.0 {
        text
    } else {
        format!("{text}\ntimes {}", Unit::ONE.format(objective.weight))
    }
}

/// Everything about a limit.
pub fn limit_in_words(model: &Model, i: usize) -> String {
    match limit_at(model, i) {
        Some(Limit::AddedMass { at_most }) => format!(
            "the masses of all enabled subsystems together: at most {}",
            Unit::KILOGRAM.format(*at_most)
        ),
        Some(Limit::NoMode { from, to }) => format!(
            "no natural frequency, without damping, in {}",
            range(*from, *to, Unit::HERTZ)
        ),
        Some(Limit::StaticDeflection { response, at_most }) => format!(
            "{response} under its forces at rest: at most {}",
            level(model, response, *at_most)
        ),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Node, all_rows, label, value};
    use super::*;

    fn model() -> Model {
        crate::model::read(include_str!("../../../tests/data/tuned.toml")).unwrap()
    }

    #[test]
    fn rows_say_what_moves_what_for_and_within_what() {
        let model = model();
        let tuning = |node: &Node| {
            matches!(
                node,
                Node::TuneVariable(_) | Node::TuneObjective(_) | Node::TuneLimit(_)
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
        assert_eq!(value(&model, Node::Tune), "worst of 7");
    }

    #[test]
    fn details_say_all_of_it() {
        let model = model();
        assert_eq!(
            variable_in_words(&model, 2),
            "subsystems.*.mass, subsystems.*.inertia (in their ratios)\nnow 100 kg, first of 2\n10..300 kg, by its \
             logarithm, +-5 %"
        );
        assert_eq!(
            objective_in_words(&model, 1),
            "the least mean square of P5 v, 20..120 Hz\ntimes 0.5"
        );
        assert_eq!(
            objective_in_words(&model, 5),
            "real and imaginary part of P5 w, 20..120 Hz as in measured.csv, curve tip"
        );
        assert_eq!(
            limit_in_words(&model, 2),
            "P5 w under its forces at rest: at most 0.001 m"
        );
        assert_eq!(limit_in_words(&model, 3), "");
    }

    #[test]
    fn a_range_has_one_unit() {
        assert_eq!(range(-0.2, 0.1, Unit::METRE), "-0.2..0.1 m");
        assert_eq!(range(0.0, 0.005, Unit::METRE), "0..5 mm");
        assert_eq!(range(0.0, 0.0, Unit::METRE), "0..0 m");
        assert_eq!(range(1.0, 3.0, Unit::ONE), "1..3");
        assert_eq!(
            range(12_345.678, 123_456.0, Unit::STIFFNESS),
            "12.346..123.46 kN/m"
        );
    }
}

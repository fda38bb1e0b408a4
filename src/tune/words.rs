//! What a tuning asks for in words, with units.

use crate::model::edit::Value;
use crate::model::{
    Aim, Compare, Hold, Limit, Model, Objective, Parameter, Spacing, Unit, Variable,
};
use crate::unit::Kind;

/// Two numbers with one unit, that in which the larger is shown: `0.1..100 MN/m`.
pub fn range(from: f64, to: f64, unit: Unit) -> String {
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

/// The band of an objective: `20..120 Hz`.
pub fn band(objective: &Objective) -> String {
    range(objective.from, objective.to, Unit::HERTZ)
}

/// A level of a response in its unit: `1e-7 m`. Without a unit where there is no such motion.
pub fn level(model: &Model, response: &str, value: f64) -> String {
    let found = model.responses.iter().find(|one| one.name == response);
    let dimension = found.and_then(|one| one.quantity.kind(None).motion());
    let unit = dimension.map_or_else(String::new, |one| Kind::Motion(one).unit());
    let number = Unit::ONE.format(value);
    format!("{number} {unit}").trim_end().to_owned()
}

/// The parameter whose bounds a variable has; none where it has no value now.
pub fn first_parameter(model: &Model, variable: &Variable) -> Option<Parameter> {
    let (first, _) = variable.parameters(model).ok()?.into_iter().next()?;
    Parameter::of(model, first).ok()
}

/// The bounds of a variable: `0.1..100 MN/m`.
pub fn bounds(model: &Model, variable: &Variable) -> String {
    let unit = first_parameter(model, variable).map_or(Unit::ONE, |first| first.unit);
    range(variable.min, variable.max, unit)
}

/// Everything about a variable, a line for each thing.
pub fn variable(model: &Model, variable: &Variable) -> String {
    let parameters = variable.parameters(model).unwrap_or_default();
    let together = match (parameters.len(), variable.hold) {
        (0 | 1, _) => "",
        (_, Hold::Equal) => " (all equal)",
        (_, Hold::Ratio) => " (in their ratios)",
    };
    let mut lines = vec![format!("{}{together}", variable.paths.join(", "))];
    if let Some(first) = first_parameter(model, variable)
        && let Value::Number(now) = first.value
    {
        let count = match parameters.len() {
            1 => String::new(),
            count => format!(", first of {count}"),
        };
        lines.push(format!("now {}{count}", first.unit.format(now)));
    }
    let scale = match variable.spacing(model) {
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

/// Everything about an objective, its weight on a line of its own.
pub fn objective(model: &Model, objective: &Objective) -> String {
    let band = band(objective);
    let text = match &objective.aim {
        Aim::Peak { response } => format!("the least highest peak of {response}, {band}"),
        Aim::MeanSquare { response } => format!("the least mean square of {response}, {band}"),
        Aim::Energy => format!("the least mean vibration energy of the beam, {band}"),
        Aim::Width { response, below } => {
            let below = level(model, response, *below);
            format!("the widest band of {response} below {below}, in {band}")
        }
        Aim::AntiResonance { response, at } => {
            let at = Unit::HERTZ.format(*at);
            format!("an anti-resonance of {response} at {at}, in {band}")
        }
        Aim::Match {
            response,
            file,
            curve,
            columns,
            compare,
        } => {
            let curve = curve
                .as_ref()
                .map_or_else(String::new, |curve| format!(", curve {curve}"));
            let columns = columns
                .as_ref()
                .map_or_else(String::new, |columns| format!(" (columns {columns})"));
            let what = match compare {
                Compare::LogMagnitude => "the magnitude in decibels",
                Compare::Complex => "real and imaginary part",
            };
            format!("{what} of {response} as in {file}{columns}{curve}, {band}")
        }
    };
    if objective.weight == 1.0 {
        text
    } else {
        format!("{text}\ntimes {}", Unit::ONE.format(objective.weight))
    }
}

/// Everything about a limit.
pub fn limit(model: &Model, limit: &Limit) -> String {
    match limit {
        Limit::AddedMass { at_most } => {
            let mass = Unit::KILOGRAM.format(*at_most);
            format!("the masses of all enabled subsystems together: at most {mass}")
        }
        Limit::NoMode { from, to } => {
            let band = range(*from, *to, Unit::HERTZ);
            format!("no natural frequency, without damping, in {band}")
        }
        Limit::StaticDeflection { response, at_most } => {
            let most = level(model, response, *at_most);
            format!("{response} under the forces at rest: at most {most}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_of_it_is_said() {
        let text = include_str!("../../tests/data/tuned.toml");
        let model = crate::model::read(text).unwrap();
        let tune = model.tune.as_ref().unwrap();
        assert_eq!(
            variable(&model, &tune.variables[2]),
            "subsystems.*.mass, subsystems.*.inertia (in their ratios)\nnow 100 kg, first of 2\n10..300 kg, by its \
             logarithm, +-5 %"
        );
        let objectives: Vec<_> = tune
            .objectives
            .iter()
            .map(|one| objective(&model, one))
            .collect();
        assert_eq!(
            objectives,
            [
                "the least highest peak of P5 w, 20..120 Hz",
                "the least mean square of P5 v, 20..120 Hz\ntimes 0.5",
                "the least mean vibration energy of the beam, 20..120 Hz",
                "the widest band of P5 w below 1e-7 m, in 20..120 Hz",
                "an anti-resonance of P5 w at 85 Hz, in 20..120 Hz",
                "real and imaginary part of P5 w as in measured.csv (columns hz; re im; m/N), curve tip, 20..120 Hz",
                "the magnitude in decibels of P5 v as in measured.unv, 20..120 Hz",
            ]
        );
        let limits: Vec<_> = tune.limits.iter().map(|one| limit(&model, one)).collect();
        assert_eq!(
            limits,
            [
                "the masses of all enabled subsystems together: at most 300 kg",
                "no natural frequency, without damping, in 45..55 Hz",
                "P5 w under the forces at rest: at most 0.001 m",
            ]
        );
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

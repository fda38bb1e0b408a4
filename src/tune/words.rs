//! Descriptions of `[tune]` in words, with units.

use crate::model::edit::Value;
use crate::model::schema::{AIMS, Access, Choice, LIMITS, Wording};
use crate::model::{Hold, Limit, Model, Objective, Parameter, Spacing, Unit, Variable};
use crate::unit::Kind;

/// Two numbers with one unit, in which the larger is shown: `0.1..100 MN/m`.
pub fn range(from: f64, to: f64, unit: Unit) -> String {
    let large = if from.abs() > to.abs() { from } else { to };
    let shown = unit.format(large);
    let number = shown.split(' ').next().unwrap_or_default();
    // The unit for display is a power of ten of the parameter's.
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

/// A level of a response in its unit: `1e-7 m`. Without a unit if there is no such motion.
pub fn level(model: &Model, response: &str, value: f64) -> String {
    let found = model.responses.iter().find(|one| one.name == response);
    let dimension = found.and_then(|one| one.kind(model, None).dimension());
    let unit = dimension.map_or_else(String::new, |one| Kind::Amplitude(one).unit());
    let number = Unit::ONE.format(value);
    format!("{number} {unit}").trim_end().to_owned()
}

/// The parameter to which the bounds of a variable apply; `None` if it has no value now.
pub fn first_parameter(model: &Model, variable: &Variable) -> Option<Parameter> {
    let (first, _) = variable.parameters(model).ok()?.into_iter().next()?;
    Parameter::of(model, first).ok()
}

/// The bounds of a variable: `0.1..100 MN/m`.
pub fn bounds(model: &Model, variable: &Variable) -> String {
    let unit = first_parameter(model, variable).map_or(Unit::ONE, |first| first.unit);
    range(variable.min, variable.max, unit)
}

/// The description of a variable, one line per property.
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

/// The description of an objective, with its weight on a separate line.
pub fn objective(model: &Model, objective: &Objective) -> String {
    let text = of_objective(model, objective, |wording| wording.whole);
    if objective.weight == 1.0 {
        text
    } else {
        format!("{text}\ntimes {}", Unit::ONE.format(objective.weight))
    }
}

/// One of the wordings of an objective, with its values.
pub fn of_objective(
    model: &Model,
    objective: &Objective,
    wording: fn(&Wording) -> &'static str,
) -> String {
    let response = objective.response.as_ref();
    in_words(model, AIMS, &objective.aim, response, wording, || {
        band(objective)
    })
}

/// One of the wordings of a limit, with its values.
pub fn of_limit(model: &Model, limit: &Limit, wording: fn(&Wording) -> &'static str) -> String {
    let response = limit.response();
    in_words(model, LIMITS, limit, response, wording, || match limit {
        Limit::NoMode { from, to } => range(*from, *to, Unit::HERTZ),
        Limit::AddedMass { .. }
        | Limit::Peak { .. }
        | Limit::StaticDeflection { .. }
        | Limit::Buckling { .. } => String::new(),
    })
}

fn in_words<T>(
    model: &Model,
    choices: &'static [Choice<T>],
    of: &T,
    response: Option<&String>,
    wording: fn(&Wording) -> &'static str,
    band: impl Fn() -> String,
) -> String {
    let Some(choice) = Choice::of(choices, of) else {
        return String::new();
    };
    let response = response.map_or("", String::as_str);
    filled(wording(&choice.wording), |wanted| match wanted {
        "response" => response.to_owned(),
        "band" => band(),
        _ => choice
            .rows
            .iter()
            .find(|(key, _)| key.key == wanted)
            .map_or_else(String::new, |(key, access)| match access {
                // A value without its own unit has that of the response.
                Access::Number(get, _) if key.unit == Unit::ONE => level(model, response, get(of)),
                Access::Number(get, _) => key.unit.format(get(of)),
                Access::Word(get, _) => key.spoken[get(of)].to_owned(),
                Access::Optional(get, _) => get(of).cloned().unwrap_or_default(),
                _ => String::new(),
            }),
    })
}

/// A wording with values in place of the keys in braces. A part in brackets is left out if a value in it is empty.
fn filled(wording: &str, value: impl Fn(&str) -> String) -> String {
    let mut text = String::new();
    for (index, piece) in wording.split(['[', ']']).enumerate() {
        let (mut own, mut lacks) = (String::new(), false);
        for part in piece.split_inclusive('}') {
            let (words, key) = part.split_once('{').unwrap_or((part, ""));
            own.push_str(words);
            if let Some(key) = key.strip_suffix('}') {
                let value = value(key);
                lacks |= value.is_empty();
                own.push_str(&value);
            }
        }
        let in_brackets = index % 2 == 1;
        if !(in_brackets && lacks) {
            text.push_str(&own);
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_of_it_is_said() {
        let text = include_str!("../../tests/data/tuned.toml");
        let model = crate::model::read(text).unwrap().into_inner();
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
        let limits: Vec<_> = tune
            .limits
            .iter()
            .map(|one| of_limit(&model, one, |of| of.whole))
            .collect();
        assert_eq!(
            limits,
            [
                "the masses of all enabled subsystems together: at most 300 kg",
                "no natural frequency, without damping, in 45..55 Hz",
                "P5 w under the forces at rest: at most 0.001 m",
                "buckling not below 2 times the axial compression",
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

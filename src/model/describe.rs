//! The description of a parameter for people.

use super::beam::{Section, Span};
use super::edit::{Placed, Value, get};
use super::id::{Group, ParameterId, SupportId};
use super::quantity::Quantity;
use super::schema::{
    FEWEST_POINTS, ForceKey, InnerSupportKey, Kind, MOST_POINTS, SectionKey, SubsystemKey,
};
use super::spelling::nearest;
use super::types::{Link, Model, Restraint, Support};
use crate::unit::{Unit, value_input};

/// A parameter with everything needed to set it.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Its id.
    pub id: ParameterId,
    /// Its symbol in the literature; empty if it has none.
    pub symbol: &'static str,
    /// The unit of a number; [`Unit::ONE`] otherwise.
    pub unit: Unit,
    /// Its meaning.
    pub meaning: &'static str,
    /// The accepted values, in words: `> 0`, `0 to 3.2 m`, `free, pinned or clamped`.
    pub range: String,
    /// The words of a [`Value::Choice`]; empty for the others.
    pub choices: Vec<&'static str>,
    /// Its current value.
    pub value: Value,
}

impl Parameter {
    /// The parameter of an id.
    ///
    /// # Errors
    /// It has no value now: a fixed motion has no spring, an energy no position, a span with the beam's section none of its own.
    pub fn of(model: &Model, id: ParameterId) -> Result<Self, String> {
        let value = get(model, id)?;
        let key = id.key();
        let choices = choices(model, id, &value);
        Ok(Self {
            id,
            symbol: key.symbol,
            unit: unit(model, id),
            meaning: key.meaning,
            range: if choices.is_empty() {
                range(model, id)
            } else {
                choices.join(", ")
            },
            choices,
            value,
        })
    }

    /// Parses typed text: a number by [`value_input::number`], a count by [`value_input::count`], `true` or `false` (or
    /// on, off, yes, no), one of the choices, or text unchanged.
    ///
    /// # Errors
    /// Why the text is not a value of this parameter, and what is accepted.
    pub fn read(&self, text: &str) -> Result<Value, String> {
        match &self.value {
            Value::Number(old) => value_input::number(text, *old, &self.unit).map(Value::Number),
            Value::Count(old) => value_input::count(text, *old).map(Value::Count),
            Value::Flag(_) => flag(text).map(Value::Flag),
            Value::Choice(_) => choice(text.trim(), &self.choices, &self.range).map(Value::Choice),
            Value::Text(_) => Ok(Value::Text(text.to_owned())),
        }
    }
}

/// The words of a choice.
fn choices(model: &Model, id: ParameterId, value: &Value) -> Vec<&'static str> {
    let key = id.key();
    match key.kind {
        Kind::Word => key.words.to_vec(),
        Kind::Restraint => Restraint::WORDS.to_vec(),
        Kind::Link => Link::WORDS.to_vec(),
        Kind::Table => Span::OWNERS.to_vec(),
        Kind::Support => {
            // "elastic" results from the single motions and cannot be chosen here.
            let mixed = (*value == Value::Choice("elastic")).then_some("elastic");
            Support::WORDS.into_iter().chain(mixed).collect()
        }
        Kind::Measure => Quantity::words(),
        Kind::Direction => {
            Placed::of(model, id.group).map_or_else(Vec::new, |of| of.directions().to_vec())
        }
        _ => Vec::new(),
    }
}

/// The unit of a number; that of a load depends on its direction.
fn unit(model: &Model, id: ParameterId) -> Unit {
    match Placed::of(model, id.group).and_then(Placed::target) {
        Some(target) if is_amplitude(id) => target.load().unit(),
        _ => id.key().unit,
    }
}

fn is_amplitude(id: ParameterId) -> bool {
    matches!(id.group, Group::Force(_)) && id.row == ForceKey::Amplitude as usize
}

/// The accepted values of a parameter without choices, in this model.
fn range(model: &Model, id: ParameterId) -> String {
    let key = id.key();
    match (key.kind, id.group) {
        (Kind::Count, _) => format!("{FEWEST_POINTS} to {MOST_POINTS}"),
        (Kind::Line, _) => "one line of text".to_owned(),
        (Kind::Text, _) => "any text".to_owned(),
        (Kind::Name, _) => "a unique name".to_owned(),
        (Kind::Flag, _) => "true or false".to_owned(),
        (Kind::Over, _) => "none, or the name of another response".to_owned(),
        (Kind::Place, group) => {
            Placed::of(model, group).map_or_else(String::new, |of| of.places(model).listed())
        }
        (_, Group::Section(part)) => part
            .section(model)
            .map_or_else(String::new, |section| section_range(section, id)),
        (_, Group::Subsystem(_)) if id.row == SubsystemKey::Position as usize => {
            format!("0 to {} m", short(model.length()))
        }
        (_, Group::Support(SupportId::Inner(_)))
            if id.row == InnerSupportKey::Position as usize =>
        {
            format!("> 0, < {} m", short(model.length()))
        }
        (_, Group::Sweep) if key.key == "from" => {
            format!("> 0, below {} Hz", short(model.sweep.to))
        }
        (_, Group::Sweep) => format!("above {} Hz", short(model.sweep.from)),
        _ => key.range.words().to_owned(),
    }
}

/// The range of a number of the section, including the rules between two numbers.
fn section_range(section: &Section, id: ParameterId) -> String {
    match SectionKey::ALL[id.row] {
        SectionKey::PolarMoment => {
            let (least, formula) = section.least_polar_moment();
            format!("> {formula} = {}", Unit::METRE_4.format(least))
        }
        SectionKey::ProductMoment => {
            let most = section.most_product_moment();
            format!("within +-sqrt(I_y I_z) = {}", Unit::METRE_4.format(most))
        }
        SectionKey::TorsionConstant if section.warping_constant == 0.0 => {
            "> 0 without a warping constant".to_owned()
        }
        SectionKey::WarpingConstant if section.torsion_constant == 0.0 => {
            "> 0 without a torsion constant".to_owned()
        }
        _ => id.key().range.words().to_owned(),
    }
}

fn short(value: f64) -> String {
    Unit::ONE.format(value)
}

/// Parses a typed flag.
fn flag(text: &str) -> Result<bool, String> {
    match text.trim().to_ascii_lowercase().as_str() {
        "true" | "on" | "yes" => Ok(true),
        "false" | "off" | "no" => Ok(false),
        _ => Err(format!(
            "\"{}\" does not fit here: accepted is true or false",
            text.trim()
        )),
    }
}

/// Parses one of some words; ignores case.
fn choice(text: &str, choices: &[&'static str], range: &str) -> Result<&'static str, String> {
    choices
        .iter()
        .copied()
        .find(|word| word.eq_ignore_ascii_case(text))
        .ok_or_else(|| {
            let near = nearest(text, choices.iter().copied())
                .map_or_else(String::new, |near| format!(" (did you mean {near}?)"));
            format!("\"{text}\" does not fit here{near}: accepted is {range}")
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::path::{all, parameter, sample};

    #[test]
    fn everything_is_described() {
        let [model, spanned] = sample::models(&["S1"]);
        let of = |model: Model| {
            all(&model)
                .into_iter()
                .map(move |path| (model.clone(), path))
        };
        for (model, path) in of(model).chain(of(spanned)) {
            let parameter = parameter(&model, &path).unwrap();
            assert_eq!(crate::model::path::text(&model, parameter.id), path);
            assert!(
                !parameter.meaning.is_empty() && !parameter.range.is_empty(),
                "{path}"
            );
            match parameter.value {
                Value::Number(_) => assert!(!parameter.symbol.is_empty(), "{path}"),
                Value::Choice(word) => assert!(parameter.choices.contains(&word), "{path}"),
                _ => assert!(
                    parameter.choices.is_empty() && parameter.unit == Unit::ONE,
                    "{path}"
                ),
            }
        }
    }

    #[test]
    fn a_load_has_the_unit_of_its_direction() {
        let model = sample::model(&["S1"]);
        let unit = |path: &str| parameter(&model, path).unwrap().unit;
        assert_eq!(unit("forces.1.amplitude"), Unit::FORCE);
        assert_eq!(unit("forces.2.amplitude"), Unit::TORQUE);
        assert_eq!(unit("forces.3.amplitude"), Unit::BIMOMENT);
        assert_eq!(unit("forces.4.amplitude"), Unit::TORQUE);
        assert_eq!(unit("forces.3.phase"), Unit::DEGREE);
        assert_eq!(
            unit("supports.left.psi.stiffness"),
            Unit::ROTATIONAL_STIFFNESS
        );
        assert_eq!(
            unit("supports.right.psi_slope.inertia"),
            Unit::WARPING_INERTIA
        );
    }

    #[test]
    fn a_range_says_what_this_model_allows() {
        let mut model = sample::model(&["S1", "S2"]);
        model.beam.section.warping_constant = 0.0;
        let range = |path: &str| parameter(&model, path).unwrap().range;
        assert_eq!(range("beam.length"), "> 0");
        assert_eq!(
            range("beam.section.polar_moment"),
            "> A z_c^2 = 4.4447e-5 m4"
        );
        assert_eq!(
            range("beam.section.torsion_constant"),
            "> 0 without a warping constant"
        );
        assert_eq!(range("subsystems.S1.position"), "0 to 3.2 m");
        assert_eq!(range("supports.inner.B1.position"), "> 0, < 3.2 m");
        assert_eq!(range("sweep.to"), "above 1 Hz");
        assert_eq!(
            range("forces.1.at"),
            "left, right, a position in m or S1, S2"
        );
        assert_eq!(range("supports.left.w"), "free, fixed, elastic");
        let many: Vec<String> = (1..10).map(|number| format!("S{number}")).collect();
        let many = sample::model(&many.iter().map(String::as_str).collect::<Vec<_>>());
        assert!(
            parameter(&many, "forces.1.at")
                .unwrap()
                .range
                .ends_with("a subsystem's name")
        );
    }

    #[test]
    fn words_are_read_for_what_the_parameter_is() {
        let of = |value, choices: &[&'static str]| Parameter {
            id: ParameterId::TITLE,
            symbol: "",
            unit: Unit::METRE,
            meaning: "",
            range: "free or fixed".to_owned(),
            choices: choices.to_vec(),
            value,
        };
        let choices = ["free", "fixed"];
        assert_eq!(
            of(Value::Number(0.3), &[]).read("*2"),
            Ok(Value::Number(0.6))
        );
        assert_eq!(of(Value::Count(3), &[]).read("2k"), Ok(Value::Count(2000)));
        assert_eq!(
            of(Value::Flag(true), &[]).read(" Off "),
            Ok(Value::Flag(false))
        );
        assert_eq!(
            of(Value::Flag(true), &[]).read("yes"),
            Ok(Value::Flag(true))
        );
        assert!(of(Value::Flag(true), &[]).read("1").is_err());
        assert_eq!(
            of(Value::Choice("free"), &choices).read("Fixed"),
            Ok(Value::Choice("fixed"))
        );
        let wrong = of(Value::Choice("free"), &choices)
            .read("fixd")
            .unwrap_err();
        assert!(
            wrong.contains("did you mean fixed?") && wrong.contains("free or fixed"),
            "{wrong}"
        );
        assert_eq!(
            of(Value::Text(String::new()), &[]).read("a b"),
            Ok(Value::Text("a b".to_owned()))
        );
    }
}

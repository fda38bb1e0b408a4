//! Reading and writing the value of a parameter.

use super::rename;
use super::target;
use crate::model::id::{Group, ParameterId, SupportId};
use crate::model::path;
use crate::model::schema::{self, Access, Key, Kind, Rows};
use crate::model::toml_literal::format_number;
use crate::model::types::{
    BeamMotion, Elastic, Link, Model, Point, Quantity, Restraint, Spring, Support,
};

/// The value of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number in the parameter's unit.
    Number(f64),
    /// A whole number.
    Count(usize),
    /// True or false.
    Flag(bool),
    /// One of the parameter's choices.
    Choice(&'static str),
    /// Free text, a name, or a position: `left`, `right`, `1.6 m`, a subsystem's name.
    Text(String),
}

impl Value {
    /// Its number.
    fn number(&self) -> Result<f64, String> {
        match self {
            Self::Number(number) => Ok(*number),
            other => Err(other.misfit("a number")),
        }
    }

    fn count(&self) -> Result<usize, String> {
        match self {
            Self::Count(count) => Ok(*count),
            other => Err(other.misfit("a whole number")),
        }
    }

    fn flag(&self) -> Result<bool, String> {
        match self {
            Self::Flag(flag) => Ok(*flag),
            other => Err(other.misfit("true or false")),
        }
    }

    pub(super) fn text(self) -> Result<String, String> {
        match self {
            Self::Text(text) => Ok(text),
            Self::Choice(word) => Ok(word.to_owned()),
            other => Err(other.misfit("text")),
        }
    }

    pub(super) fn word(&self) -> Result<&str, String> {
        match self {
            Self::Text(text) => Ok(text),
            Self::Choice(word) => Ok(word),
            other => Err(other.misfit("a word")),
        }
    }

    fn misfit(&self, wanted: &str) -> String {
        let given = match self {
            Self::Number(number) => format_number(*number),
            Self::Count(count) => count.to_string(),
            Self::Flag(flag) => flag.to_string(),
            Self::Choice(word) => format!("{word:?}"),
            Self::Text(text) => format!("{text:?}"),
        };
        format!("is {given}; must be {wanted}")
    }
}

impl<T> Rows<T> {
    /// The value of a row; none if the row has its own rules.
    fn get(&self, row: usize, of: &T) -> Option<Value> {
        Some(match &self.access[row] {
            Access::Number(get, _) => Value::Number(get(of)),
            Access::Count(get, _) => Value::Count(get(of)),
            Access::Flag(get, _) => Value::Flag(get(of)),
            Access::Word(get, _) => Value::Choice(self.keys[row].words[get(of)]),
            Access::Text(get, _) => Value::Text(get(of).clone()),
            Access::Optional(..) | Access::Own => return None,
        })
    }

    /// Writes the value of a row; fails if the row has its own rules.
    fn set(&self, row: usize, of: &mut T, value: Value) -> Result<(), String> {
        match &self.access[row] {
            Access::Number(_, set) => set(of, value.number()?),
            Access::Count(_, set) => set(of, value.count()?),
            Access::Flag(_, set) => set(of, value.flag()?),
            Access::Word(_, set) => set(of, chosen(&value, self.keys[row].words)?),
            Access::Text(_, text) => *text(of) = value.text()?,
            Access::Optional(..) | Access::Own => return Err("cannot be set".to_owned()),
        }
        Ok(())
    }
}

/// The value of a parameter.
///
/// # Errors
/// Why it has none: a fixed motion has no spring, an energy has no position.
pub fn get(model: &Model, id: ParameterId) -> Result<Value, String> {
    let row = id.row;
    let plain = match id.group {
        Group::Model => schema::MODEL.get(row, model),
        Group::Beam => schema::BEAM.get(row, &model.beam),
        Group::Material => schema::MATERIAL.get(row, &model.beam.material),
        Group::Section => schema::SECTION.get(row, &model.beam.section),
        Group::Foundation => schema::FOUNDATION.get(row, &model.beam.foundation),
        Group::Support(support @ SupportId::Inner(index)) if row < support.own_keys() => {
            schema::INNER_SUPPORT.get(row, &model.supports.inner[index])
        }
        Group::Support(support) => {
            schema::SUPPORT.get(row - support.own_keys(), support.support(model))
        }
        Group::Motion(support, motion) => match support.support(model)[motion] {
            Restraint::Fixed => return Err(fixed(model, support, motion, id.key())),
            held => schema::elastic(motion).get(row, &held.elastic()),
        },
        Group::Joint(index) => schema::JOINT.get(row, &model.joints[index]),
        Group::Link(joint, motion) => match model.joints[joint][motion] {
            Link::Rigid => return Err(rigid(model, joint, motion, id.key())),
            joined => schema::link(motion).get(row, &joined.spring()),
        },
        Group::Subsystem(index) => schema::SUBSYSTEM.get(row, &model.subsystems[index]),
        Group::Force(index) => schema::FORCE.get(row, &model.forces[index]),
        Group::Response(index) => schema::RESPONSE.get(row, &model.responses[index]),
        Group::Sweep => schema::SWEEP.get(row, &model.sweep),
        Group::Study(index) => schema::STUDY.get(row, &model.studies[index]),
        _ => None,
    };
    plain.map_or_else(|| own(model, id), Ok)
}

/// The number of a parameter.
///
/// # Errors
/// As [`get`], or the value is not a number.
pub fn number(model: &Model, id: ParameterId) -> Result<f64, String> {
    get(model, id)?
        .number()
        .map_err(|message| format!("is not a number: {message}"))
}

/// The value of a parameter with its own rules.
fn own(model: &Model, id: ParameterId) -> Result<Value, String> {
    let target = || target::known(model, id.group);
    Ok(match (id.group, id.key().kind) {
        (Group::Support(support), _) => {
            let support = support.support(model);
            Value::Choice(
                id.motion()
                    .map_or_else(|| support.kind(), |motion| support[motion].kind()),
            )
        }
        (Group::Joint(joint), _) => {
            let link = id.motion().map(|motion| model.joints[joint][motion]);
            Value::Choice(link.unwrap_or_default().kind())
        }
        (Group::Response(index), Kind::Measure) => {
            Value::Choice(target::measure(&model.responses[index].quantity))
        }
        (_, Kind::Place) => Value::Text(target::place(target()?)),
        _ => Value::Choice(target::direction(target()?)),
    })
}

fn fixed(model: &Model, support: SupportId, motion: BeamMotion, key: &Key) -> String {
    let restraint = path::text(model, ParameterId::restraint(support, motion));
    let (motion, key) = (motion.key(), key.key);
    format!(
        "{motion} is fixed there, so it has no {key}; {restraint} must be free or elastic first"
    )
}

fn rigid(model: &Model, joint: usize, motion: BeamMotion, key: &Key) -> String {
    let link = path::text(model, ParameterId::link(joint, motion));
    let (motion, key) = (motion.key(), key.key);
    format!("{motion} is rigid there, so it has no {key}; {link} must be free or elastic first")
}

/// Writes a value, without a check of the result.
///
/// # Errors
/// The value is of another type, or not a choice of the parameter; the model is then unchanged.
pub fn put(model: &mut Model, id: ParameterId, value: Value) -> Result<(), String> {
    let row = id.row;
    match (id.group, id.key().kind) {
        (group, Kind::Name) => rename::element(model, group, &value.text()?),
        (group, Kind::Place) => target::place_at(model, group, value)?,
        (group, Kind::Direction) => target::turn(model, group, &value)?,
        (Group::Response(index), Kind::Measure) => {
            let response = &mut model.responses[index];
            response.quantity = target::measured(&response.quantity, value.word()?)?;
            if response.quantity == Quantity::Energy {
                response.point = Point::AXIS;
            }
        }
        (Group::Support(support), Kind::Support) => {
            put_support(support.support_mut(model), value.word()?)?;
        }
        (Group::Support(support @ SupportId::Inner(index)), _) if row < support.own_keys() => {
            schema::INNER_SUPPORT.set(row, &mut model.supports.inner[index], value)?;
        }
        (Group::Support(at), _) => {
            let support = at.support_mut(model);
            match id.motion() {
                Some(motion) => put_restraint(&mut support[motion], value.word()?)?,
                None => schema::SUPPORT.set(row - at.own_keys(), support, value)?,
            }
        }
        (Group::Motion(support, motion), _) => put_spring(model, support, motion, id, &value)?,
        (Group::Joint(joint), _) => {
            let joint = &mut model.joints[joint];
            match id.motion() {
                Some(motion) => put_link(&mut joint[motion], value.word()?)?,
                None => schema::JOINT.set(row, joint, value)?,
            }
        }
        (Group::Link(joint, motion), _) => put_coupling(model, joint, motion, id, &value)?,
        (Group::Model, _) => schema::MODEL.set(row, model, value)?,
        (Group::Beam, _) => schema::BEAM.set(row, &mut model.beam, value)?,
        (Group::Material, _) => schema::MATERIAL.set(row, &mut model.beam.material, value)?,
        (Group::Section, _) => schema::SECTION.set(row, &mut model.beam.section, value)?,
        (Group::Foundation, _) => {
            schema::FOUNDATION.set(row, &mut model.beam.foundation, value)?;
        }
        (Group::Subsystem(index), _) => {
            schema::SUBSYSTEM.set(row, &mut model.subsystems[index], value)?;
        }
        (Group::Force(index), _) => schema::FORCE.set(row, &mut model.forces[index], value)?,
        (Group::Response(index), _) => {
            schema::RESPONSE.set(row, &mut model.responses[index], value)?;
        }
        (Group::Sweep, _) => schema::SWEEP.set(row, &mut model.sweep, value)?,
        _ => return Err("cannot be set".to_owned()),
    }
    Ok(())
}

fn put_spring(
    model: &mut Model,
    support: SupportId,
    motion: BeamMotion,
    id: ParameterId,
    value: &Value,
) -> Result<(), String> {
    let new = value.number()?;
    let mut elastic = match support.support(model)[motion] {
        Restraint::Elastic(elastic) => elastic,
        // A free motion already has a stiffness, damping and inertia of 0.
        Restraint::Free if new == 0.0 => return Ok(()),
        Restraint::Free => Elastic::default(),
        Restraint::Fixed => return Err(fixed(model, support, motion, id.key())),
    };
    schema::elastic(motion).set(id.row, &mut elastic, Value::Number(new))?;
    support.support_mut(model)[motion] = Restraint::Elastic(elastic);
    Ok(())
}

fn put_restraint(restraint: &mut Restraint, word: &str) -> Result<(), String> {
    let new = Restraint::of_word(word)
        .ok_or_else(|| format!("is {word:?}; must be free, fixed or elastic"))?;
    // An elastic motion keeps its springs.
    if new.kind() != restraint.kind() {
        *restraint = new;
    }
    Ok(())
}

fn put_coupling(
    model: &mut Model,
    joint: usize,
    motion: BeamMotion,
    id: ParameterId,
    value: &Value,
) -> Result<(), String> {
    let new = value.number()?;
    let mut spring = match model.joints[joint][motion] {
        Link::Elastic(spring) => spring,
        // A free motion already has a stiffness and damping of 0.
        Link::Free if new == 0.0 => return Ok(()),
        Link::Free => Spring::default(),
        Link::Rigid => return Err(rigid(model, joint, motion, id.key())),
    };
    schema::link(motion).set(id.row, &mut spring, Value::Number(new))?;
    model.joints[joint][motion] = Link::Elastic(spring);
    Ok(())
}

fn put_link(link: &mut Link, word: &str) -> Result<(), String> {
    let new = Link::of_word(word)
        .ok_or_else(|| format!("is {word:?}; must be rigid, free or elastic"))?;
    // An elastic motion keeps its springs.
    if new.kind() != link.kind() {
        *link = new;
    }
    Ok(())
}

fn put_support(support: &mut Support, word: &str) -> Result<(), String> {
    if word == "elastic" {
        return if support.kind() == "elastic" {
            Ok(())
        } else {
            Err("cannot be elastic as a whole; set a spring of one motion instead".to_owned())
        };
    }
    support.restraints = Support::of_word(word)
        .ok_or_else(|| format!("is {word:?}; must be free, pinned or clamped"))?
        .restraints;
    Ok(())
}

/// The index of a value among some words.
fn chosen(value: &Value, words: &[&str]) -> Result<usize, String> {
    let word = value.word()?;
    words
        .iter()
        .position(|known| *known == word)
        .ok_or_else(|| format!("is {word:?}; must be {}", words.join(", ")))
}

#[cfg(test)]
mod tests {
    use crate::model::edit::{Value, set, set_unchecked};
    use crate::model::path::{all, parameter, sample};
    use crate::model::types::{BeamMotion, Elastic, Place, Quantity, Restraint, Support, Target};
    use crate::unit::Measure;

    fn choice(word: &'static str) -> Value {
        Value::Choice(word)
    }

    #[test]
    fn every_parameter_reads_and_sets_back_to_the_same_model() {
        let names = [
            "S1",
            "a.b",
            "12",
            "5\" 'arm'",
            "*",
            "left end",
            "x2",
            "1.6 m",
            "'q'",
        ];
        for first in 0..names.len() {
            let mut rotated = names.to_vec();
            rotated.rotate_left(first);
            let model = sample::model(&rotated);
            for path in all(&model) {
                let value = parameter(&model, &path).unwrap().value;
                let mut same = model.clone();
                set_unchecked(&mut same, &path, value)
                    .unwrap_or_else(|fault| panic!("{path}: {fault}"));
                assert_eq!(same, model, "{path}");
            }
        }
    }

    #[test]
    fn a_value_of_another_type_is_refused_and_changes_nothing() {
        let model = sample::model(&["S1"]);
        let values = [
            Value::Number(1.0),
            Value::Count(2),
            Value::Flag(true),
            choice("no such word"),
            Value::Text("no such word".to_owned()),
        ];
        for path in all(&model) {
            let old = parameter(&model, &path).unwrap().value;
            let free_text = matches!(old, Value::Text(_)) && path.rsplit('.').next() != Some("at");
            for value in &values {
                let fits = std::mem::discriminant(value) == std::mem::discriminant(&old);
                let word = matches!(value, Value::Text(_) | Value::Choice(_));
                if (fits && !word) || (free_text && word) {
                    continue;
                }
                let mut same = model.clone();
                let fault = set_unchecked(&mut same, &path, value.clone()).unwrap_err();
                assert!(fault.message.contains("must be"), "{fault}");
                assert_eq!(same, model, "{path}");
            }
        }
    }

    #[test]
    fn a_spring_makes_a_free_motion_elastic_and_zero_leaves_it() {
        let mut model = sample::model(&["S1"]);
        set(&mut model, "supports.right.v.stiffness", Value::Number(0.0)).unwrap();
        assert_eq!(model.supports.right[BeamMotion::V], Restraint::Free);
        set(&mut model, "supports.right.v.mass", Value::Number(2.0)).unwrap();
        let expected = Elastic {
            inertia: 2.0,
            ..Elastic::default()
        };
        assert_eq!(
            model.supports.right[BeamMotion::V],
            Restraint::Elastic(expected)
        );
        set(&mut model, "supports.right.v", choice("elastic")).unwrap();
        assert_eq!(
            model.supports.right[BeamMotion::V],
            Restraint::Elastic(expected)
        );
        set(&mut model, "supports.right.v_slope", choice("elastic")).unwrap();
        assert_eq!(
            model.supports.right[BeamMotion::VSlope],
            Restraint::Elastic(Elastic::default())
        );
    }

    #[test]
    fn a_fixed_motion_has_no_spring() {
        let mut model = sample::model(&["S1"]);
        let fault = parameter(&model, "supports.left.v.damping").unwrap_err();
        assert!(
            fault.message.contains("fixed") && fault.message.contains("supports.left.v"),
            "{fault}"
        );
        assert!(set(&mut model, "supports.left.v.damping", Value::Number(1.0)).is_err());
        assert!(set(&mut model, "supports.*.v.damping", Value::Number(1.0)).is_err());
        assert_eq!(model, sample::model(&["S1"]));
    }

    #[test]
    fn the_kind_sets_all_six_motions() {
        let mut model = sample::model(&["S1"]);
        let kind = |model: &_| parameter(model, "supports.left.kind").unwrap();
        assert_eq!(kind(&model).value, choice("elastic"));
        assert_eq!(
            kind(&model).choices,
            ["free", "pinned", "clamped", "elastic"]
        );
        // A study of the spring of w must not block this, although a fixed motion has no spring.
        for (word, support) in [
            ("pinned", Support::PINNED),
            ("clamped", Support::CLAMPED),
            ("free", Support::FREE),
        ] {
            set(&mut model, "supports.left.kind", choice(word)).unwrap();
            assert_eq!(model.supports.left, support);
            assert_eq!(kind(&model).value, choice(word));
        }
        assert_eq!(kind(&model).choices, ["free", "pinned", "clamped"]);
        let faults = set(&mut model, "supports.left.kind", choice("elastic")).unwrap_err();
        assert!(faults[0].message.contains("set a spring"), "{faults:?}");
    }

    #[test]
    fn a_response_can_become_an_energy_and_a_motion_again() {
        let mut model = sample::model(&["S1"]);
        set(&mut model, "responses.mass.measure", choice("acceleration")).unwrap();
        set(&mut model, "responses.mass.measure", choice("energy")).unwrap();
        assert_eq!(model.responses[2].quantity, Quantity::Energy);
        let fault = parameter(&model, "responses.mass.at").unwrap_err();
        assert!(fault.message.contains("energy"), "{fault}");
        assert!(set(&mut model, "responses.mass.direction", choice("w")).is_err());
        set(&mut model, "responses.mass.measure", choice("velocity")).unwrap();
        let w = Target::Beam(Place::Right, BeamMotion::W);
        assert_eq!(
            model.responses[2].quantity,
            Quantity::Motion(w, Measure::Velocity)
        );
    }
}

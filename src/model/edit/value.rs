//! Reading and writing the value of a parameter.

use super::rename;
use super::target;
use crate::model::beam::{Beam, BeamMotion, Span};
use crate::model::id::{Group, ParameterId, SupportId};
use crate::model::path;
use crate::model::place;
use crate::model::schema::{self, Access, Key, Kind, Rows};
use crate::model::spring::{Elastic, Spring};
use crate::model::toml_literal::format_number;
use crate::model::types::{Link, Model, Restraint, Support};

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

/// The text of a response that no other one divides.
const NO_DIVISOR: &str = "none";

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
    /// The value of a row; none if the row has its own rules, or an optional number is missing.
    fn get(&self, row: usize, of: &T) -> Option<Value> {
        Some(match &self.access[row] {
            Access::Number(get, _) => Value::Number(get(of)),
            Access::Count(get, _) => Value::Count(get(of)),
            Access::Flag(get, _) => Value::Flag(get(of)),
            Access::Word(get, _) => Value::Choice(self.keys[row].words[get(of)]),
            Access::Text(get, _) => Value::Text(get(of).clone()),
            Access::OptionalNumber(get, _) => Value::Number(get(of)?),
            Access::Optional(..) | Access::Own => return None,
        })
    }

    /// Writes the value of a row; fails if the row has its own rules.
    fn set(&self, row: usize, of: &mut T, value: Value) -> Result<(), String> {
        match &self.access[row] {
            Access::Number(_, set) => set(of, value.number()?),
            Access::OptionalNumber(_, set) => set(of, Some(value.number()?)),
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
    has_number(model, id)?;
    let row = id.row;
    let plain = match id.group {
        Group::Model => schema::MODEL.get(row, model),
        Group::Beam => schema::BEAM.get(row, &model.beam),
        Group::Material(part) => part
            .material(model)
            .and_then(|of| schema::MATERIAL.get(row, of)),
        Group::Section(part) => part
            .section(model)
            .and_then(|of| schema::SECTION.get(row, of)),
        Group::Foundation(part) => part
            .foundation(model)
            .and_then(|of| schema::FOUNDATION.get(row, of)),
        Group::Span(index) => schema::SPAN.get(row, &model.spans[index]),
        Group::Support(support @ SupportId::Inner(index)) if row < support.own_keys() => {
            schema::INNER_SUPPORT.get(row, &model.supports.inner[index])
        }
        Group::Support(support) => {
            schema::SUPPORT.get(row - support.own_keys(), support.support(model))
        }
        Group::Motion(support, motion) => match &support.support(model)[motion] {
            Restraint::Fixed => return Err(fixed(model, support, motion, id.key())),
            held => schema::elastic(motion).get(row, held.elastic()),
        },
        Group::Joint(index) => schema::JOINT.get(row, &model.joints[index]),
        Group::Link(joint, motion) => match &model.joints[joint][motion] {
            Link::Rigid => return Err(rigid(model, joint, motion, id.key())),
            joined => schema::link(motion).get(row, joined.spring()),
        },
        Group::Branch(spring, index) => match spring.branches(model).get(index) {
            None => return Err("is no Maxwell branch of this spring".to_owned()),
            Some(branch) => schema::branch(spring.like()).get(row, branch),
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
            let link = id.motion().map(|motion| &model.joints[joint][motion]);
            Value::Choice(link.map_or(Link::WORDS[0], Link::kind))
        }
        (Group::Span(_), Kind::Table) => {
            let is_own = id.table().is_some_and(|table| table.is_there(model));
            Value::Choice(Span::OWNERS[usize::from(is_own)])
        }
        (Group::Span(_), _) => Value::Number(model.beam.axial_force),
        (Group::Response(index), Kind::Measure) => {
            Value::Choice(model.responses[index].quantity.word())
        }
        (Group::Response(index), Kind::Over) => {
            let over = model.responses[index].over.as_deref();
            Value::Text(over.unwrap_or(NO_DIVISOR).to_owned())
        }
        (_, Kind::Place) => Value::Text(place::text(target()?.at())),
        _ => Value::Choice(target()?.direction()),
    })
}

/// Fails for a number of the beam or of a span that is another one's: says which.
fn has_number(model: &Model, id: ParameterId) -> Result<(), String> {
    if !matches!(id.group.owner(), Group::Beam | Group::Span(_)) || id.exists(model) {
        return Ok(());
    }
    let (key, place) = (id.key().key, id.group.place());
    Err(match (id.group.table_key(), place) {
        (Some(table), Some(index)) => format!(
            "span {} has the {table} of the beam: must be beam.{table}.{key}, or it must have a {table} of its own first",
            index + 1
        ),
        (Some(table), None) => {
            format!("every span has a {table} of its own: must be beam.spans.*.{table}.{key}")
        }
        (None, _) => format!("is that of the spans together: must be beam.spans.*.{key}"),
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

/// The values of a position, or of the response that divides another one, that are words or names, in their order: the ends
/// and what has a name, of the subsystems those enabled; none and the responses that can divide.
pub fn names(model: &Model, id: ParameterId) -> Vec<Value> {
    let texts = match (id.group, id.key().kind) {
        (group, Kind::Place) => {
            let placed = target::Placed::of(model, group);
            placed.map_or_else(Vec::new, |placed| placed.places(model).texts(model))
        }
        (Group::Response(index), Kind::Over) => {
            let own = &model.responses[index].name;
            let all = model.responses.iter();
            let can_divide = all.filter(|of| of.is_linear() && of.name != *own);
            let names = can_divide.map(|of| of.name.clone());
            std::iter::once(NO_DIVISOR.to_owned())
                .chain(names)
                .collect()
        }
        _ => Vec::new(),
    };
    texts.into_iter().map(Value::Text).collect()
}

/// Writes a value, without a check of the result.
///
/// # Errors
/// The value is of another type, or not a choice of the parameter; the model is then unchanged.
pub fn put(model: &mut Model, id: ParameterId, value: Value) -> Result<(), String> {
    has_number(model, id)?;
    let row = id.row;
    match (id.group, id.key().kind) {
        (group, Kind::Name) => rename::element(model, group, &value.text()?),
        (group, Kind::Place) => target::place_at(model, group, value)?,
        (group, Kind::Direction) => target::turn(model, group, &value)?,
        (Group::Response(index), Kind::Over) => {
            let name = value.text()?;
            let is_none = name.trim().is_empty() || name == NO_DIVISOR;
            model.responses[index].over = (!is_none).then_some(name);
        }
        (Group::Response(index), Kind::Measure) => {
            let old = &model.responses[index].quantity;
            let new = old.of_word(value.word()?, model)?;
            model.responses[index].set_quantity(new);
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
        (Group::Branch(spring, index), _) => {
            let list = spring.spring_mut(model).map(|spring| &mut spring.maxwell);
            let branch = list.and_then(|list| list.get_mut(index));
            let branch = branch.ok_or("is no Maxwell branch of this spring")?;
            schema::branch(spring.like()).set(row, branch, value)?;
        }
        (Group::Model, _) => schema::MODEL.set(row, model, value)?,
        (Group::Beam, _) => schema::BEAM.set(row, &mut model.beam, value)?,
        (Group::Material(part), _) => schema::MATERIAL.set(row, part.material_mut(model), value)?,
        (Group::Section(part), _) => schema::SECTION.set(row, part.section_mut(model), value)?,
        (Group::Foundation(part), _) => {
            schema::FOUNDATION.set(row, part.foundation_mut(model), value)?;
        }
        (Group::Span(index), Kind::Table) => {
            let Model { beam, spans, .. } = model;
            put_tables(&mut spans[index], beam, id, value.word()?)?;
        }
        (Group::Span(index), _) => {
            let old = get(model, id)?;
            // A span without an axial force already has that of the beam.
            if value != old {
                schema::SPAN.set(row, &mut model.spans[index], value)?;
            }
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

/// Gives a span a table of its own, a copy of the beam's, or takes it away.
fn put_tables(span: &mut Span, beam: &Beam, id: ParameterId, word: &str) -> Result<(), String> {
    fn put<T>(table: &mut Option<T>, of_beam: T, is_own: bool) {
        *table = is_own.then(|| table.take().unwrap_or(of_beam));
    }
    let [of_beam, own] = Span::OWNERS;
    if word != of_beam && word != own {
        return Err(format!("is {word:?}; must be {of_beam} or {own}"));
    }
    match id.table() {
        Some(Group::Material(_)) => put(&mut span.material, beam.material, word == own),
        Some(Group::Section(_)) => put(&mut span.section, beam.section, word == own),
        _ => put(&mut span.foundation, beam.foundation, word == own),
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
    let mut elastic = match &support.support(model)[motion] {
        Restraint::Elastic(elastic) => elastic.clone(),
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
    let mut spring = match &model.joints[joint][motion] {
        Link::Elastic(spring) => spring.clone(),
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
    use crate::model::beam::{BeamMotion, Section};
    use crate::model::edit::{Value, set, set_unchecked};
    use crate::model::path::{all, number, parameter, sample};
    use crate::model::quantity::Quantity;
    use crate::model::spring::Elastic;
    use crate::model::types::{Model, Place, Restraint, Support, Target};
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
            for model in sample::models(&rotated) {
                for path in all(&model) {
                    let value = parameter(&model, &path).unwrap().value;
                    let mut same = model.clone();
                    set_unchecked(&mut same, &path, value)
                        .unwrap_or_else(|fault| panic!("{path}: {fault}"));
                    assert_eq!(same, model, "{path}");
                }
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
            Restraint::Elastic(expected.clone())
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

    /// Of the three spans, only the second has a material and only the first no section.
    #[test]
    fn a_span_has_tables_of_its_own_or_those_of_the_beam() {
        let mut model = sample::models(&["S1"])[1].clone();
        let refused = |model: &mut Model, path: &str, word: &str| {
            let before = model.clone();
            let fault = set_unchecked(model, path, Value::Number(1.0)).unwrap_err();
            assert!(fault.message.contains(word), "{path}: {fault}");
            assert_eq!(parameter(model, path).unwrap_err().message, fault.message);
            assert_eq!(*model, before);
        };
        for (path, word) in [
            (
                "beam.spans.1.section.area",
                "must be beam.section.area, or it must have a section of its own first",
            ),
            (
                "beam.spans.3.material.density",
                "span 3 has the material of the beam",
            ),
            ("beam.length", "must be beam.spans.*.length"),
        ] {
            refused(&mut model, path, word);
        }
        set(&mut model, "beam.spans.1.section", choice("own")).unwrap();
        assert_eq!(model.spans[0].section, Some(model.beam.section));
        set(&mut model, "beam.spans.1.section.area", Value::Number(0.02)).unwrap();
        assert_eq!(
            model.spans[0].section.map(|section| section.area),
            Some(0.02)
        );
        // Chosen again, it keeps its numbers.
        set(&mut model, "beam.spans.*.section", choice("own")).unwrap();
        assert_eq!(
            model.spans[0].section.map(|section| section.area),
            Some(0.02)
        );
        model.beam.section = Section::default();
        refused(
            &mut model,
            "beam.section.area",
            "must be beam.spans.*.section.area",
        );
        assert!(set(&mut model, "beam.spans.1.section", choice("beam")).is_err());
        set(&mut model, "beam.spans.2.material", choice("beam")).unwrap();
        assert_eq!(model.spans[1].material, None);
        let fault = set(&mut model, "beam.spans.2.material", choice("mine")).unwrap_err();
        assert!(
            fault[0].message.ends_with("must be beam or own"),
            "{fault:?}"
        );
    }

    #[test]
    fn a_span_without_an_axial_force_has_that_of_the_beam() {
        let mut model = sample::models(&["S1"])[1].clone();
        model.beam.axial_force = -7.0;
        let path = "beam.spans.1.axial_force";
        assert_eq!(number(&model, path), Ok(-7.0));
        set(&mut model, path, Value::Number(-7.0)).unwrap();
        assert_eq!(model.spans[0].axial_force, None);
        set(&mut model, path, Value::Number(0.0)).unwrap();
        assert_eq!(model.spans[0].axial_force, Some(0.0));
    }
}

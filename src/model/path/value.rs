//! Reading and writing the value behind an address.

use super::address::{Address, End, Key, Owner};
use super::target;
use super::{Value, rename};
use crate::model::field::Field;
use crate::model::types::{
    BeamMotion, Elastic, Measure, Model, Quantity, Restraint, Spacing, Support,
};

/// The word for an energy among the measures.
pub(super) const ENERGY: &str = "energy";

/// The value of a parameter.
///
/// # Errors
/// Says why a parameter has none: a fixed motion has no spring, an energy no place.
pub(super) fn read(model: &Model, address: &Address) -> Result<Value, String> {
    if let Some(value) = number(model, address)? {
        return Ok(Value::Number(value));
    }
    Ok(match (address.owner, address.leaf.key) {
        (Owner::Model, Key::Title) => Value::Text(model.title.clone()),
        (Owner::Model, _) => Value::Text(model.notes.clone()),
        (Owner::Support(end), Key::Restraint(motion)) => {
            Value::Choice(end.of(model)[motion].kind())
        }
        (Owner::Support(end), _) => Value::Choice(end.of(model).kind()),
        (Owner::Subsystem(index), Key::Name) => Value::Text(model.subsystems[index].name.clone()),
        (Owner::Subsystem(index), _) => Value::Flag(model.subsystems[index].enabled),
        (Owner::Force(index), Key::At) => Value::Text(target::place(&model.forces[index].target)),
        (Owner::Force(index), Key::Direction) => {
            Value::Choice(target::direction(&model.forces[index].target))
        }
        (Owner::Force(index), _) => Value::Flag(model.forces[index].enabled),
        (Owner::Response(index), key) => response(model, index, key)?,
        (Owner::Study(index), _) => Value::Text(model.studies[index].name.clone()),
        (_, Key::Points) => Value::Count(model.sweep.points),
        _ => Value::Choice(model.sweep.spacing.key()),
    })
}

/// The value of a number; none where the parameter is something else.
fn number(model: &Model, address: &Address) -> Result<Option<f64>, String> {
    Ok(Some(match (address.owner, address.leaf.key) {
        (_, Key::Beam(field)) => (field.get)(&model.beam),
        (_, Key::Material(field)) => (field.get)(&model.beam.material),
        (_, Key::Section(field)) => (field.get)(&model.beam.section),
        (_, Key::Sweep(field)) => (field.get)(&model.sweep),
        (Owner::Subsystem(index), Key::Subsystem(field)) => (field.get)(&model.subsystems[index]),
        (Owner::Force(index), Key::Force(field)) => (field.get)(&model.forces[index]),
        (Owner::Support(end), Key::Elastic(motion, field)) => match end.of(model)[motion] {
            Restraint::Free => 0.0,
            Restraint::Fixed => return Err(fixed(end, motion, field)),
            Restraint::Elastic(elastic) => (field.get)(&elastic),
        },
        _ => return Ok(None),
    }))
}

fn fixed(end: End, motion: BeamMotion, field: &Field<Elastic>) -> String {
    let end = if end == End::Left { "left" } else { "right" };
    let (motion, key) = (motion.key(), field.key);
    format!(
        "{motion} is fixed there, so it has no {key}; supports.{end}.{motion} must be free or elastic first"
    )
}

fn response(model: &Model, index: usize, key: Key) -> Result<Value, String> {
    let response = &model.responses[index];
    Ok(match (key, &response.quantity) {
        (Key::Name, _) => Value::Text(response.name.clone()),
        (Key::Enabled, _) => Value::Flag(response.enabled),
        (Key::Measure, Quantity::Motion(_, measure)) => Value::Choice(measure.key()),
        (Key::Measure, Quantity::Energy) => Value::Choice(ENERGY),
        (Key::At, Quantity::Motion(target, _)) => Value::Text(target::place(target)),
        (_, Quantity::Motion(target, _)) => Value::Choice(target::direction(target)),
        (_, Quantity::Energy) => return Err(energy()),
    })
}

fn energy() -> String {
    "is an energy, which is the whole beam's; the measure must be displacement, velocity or acceleration first".to_owned()
}

/// Writes a value, without the model's own checks.
///
/// # Errors
/// The value is of another type or no choice of the parameter; the model is then unchanged.
pub(super) fn write(model: &mut Model, address: &Address, value: Value) -> Result<(), String> {
    match (address.owner, address.leaf.key) {
        (Owner::Model, Key::Title) => model.title = value.text()?,
        (Owner::Model, _) => model.notes = value.text()?,
        (_, Key::Beam(field)) => (field.set)(&mut model.beam, value.number()?),
        (_, Key::Material(field)) => (field.set)(&mut model.beam.material, value.number()?),
        (_, Key::Section(field)) => (field.set)(&mut model.beam.section, value.number()?),
        (_, Key::Sweep(field)) => (field.set)(&mut model.sweep, value.number()?),
        (_, Key::Points) => model.sweep.points = value.count()?,
        (_, Key::Spacing) => {
            let spacings = Spacing::ALL;
            model.sweep.spacing = chosen(&spacings, Spacing::key, &value)?;
        }
        (Owner::Support(end), key) => write_support(model, end, key, &value)?,
        (Owner::Subsystem(index), Key::Subsystem(field)) => {
            (field.set)(&mut model.subsystems[index], value.number()?);
        }
        (Owner::Subsystem(index), Key::Name) => rename::subsystem(model, index, &value.text()?),
        (Owner::Subsystem(index), _) => model.subsystems[index].enabled = value.flag()?,
        (Owner::Force(index), key) => write_force(model, index, key, value)?,
        (Owner::Response(index), key) => write_response(model, index, key, value)?,
        (Owner::Study(index), _) => model.studies[index].name = value.text()?,
        (Owner::Beam | Owner::Sweep, _) => return Err("cannot be set".to_owned()),
    }
    Ok(())
}

fn write_support(model: &mut Model, end: End, key: Key, value: &Value) -> Result<(), String> {
    let support = end.of_mut(model);
    match key {
        Key::Elastic(motion, field) => {
            let new = value.number()?;
            let mut elastic = match support[motion] {
                Restraint::Elastic(elastic) => elastic,
                // What is free has 0 of everything already.
                Restraint::Free if new == 0.0 => return Ok(()),
                Restraint::Free => Elastic::default(),
                Restraint::Fixed => return Err(fixed(end, motion, field)),
            };
            (field.set)(&mut elastic, new);
            support[motion] = Restraint::Elastic(elastic);
        }
        Key::Restraint(motion) => {
            support[motion] = match (value.word()?, support[motion]) {
                ("free", _) => Restraint::Free,
                ("fixed", _) => Restraint::Fixed,
                ("elastic", kept @ Restraint::Elastic(_)) => kept,
                ("elastic", _) => Restraint::Elastic(Elastic::default()),
                (other, _) => return Err(format!("is {other:?}; must be free, fixed or elastic")),
            };
        }
        _ => {
            *support = match value.word()? {
                "free" => Support::FREE,
                "pinned" => Support::PINNED,
                "clamped" => Support::CLAMPED,
                "elastic" if support.kind() == "elastic" => *support,
                "elastic" => {
                    return Err(
                        "does not become elastic as a whole; set a spring of one motion instead"
                            .to_owned(),
                    );
                }
                other => return Err(format!("is {other:?}; must be free, pinned or clamped")),
            };
        }
    }
    Ok(())
}

fn write_force(model: &mut Model, index: usize, key: Key, value: Value) -> Result<(), String> {
    match key {
        Key::At => {
            let target = target::moved(model, &model.forces[index].target, &value.text()?)?;
            model.forces[index].target = target;
        }
        Key::Direction => {
            let force = &mut model.forces[index];
            force.target = target::turned(&force.target, value.word()?)?;
        }
        Key::Force(field) => (field.set)(&mut model.forces[index], value.number()?),
        _ => model.forces[index].enabled = value.flag()?,
    }
    Ok(())
}

fn write_response(model: &mut Model, index: usize, key: Key, value: Value) -> Result<(), String> {
    let response = &model.responses[index];
    let quantity = match (key, &response.quantity) {
        (Key::Name, _) => {
            rename::response(model, index, &value.text()?);
            return Ok(());
        }
        (Key::Enabled, _) => {
            model.responses[index].enabled = value.flag()?;
            return Ok(());
        }
        (Key::Measure, quantity) => measured(quantity, &value)?,
        (_, Quantity::Energy) => return Err(energy()),
        (Key::At, Quantity::Motion(target, measure)) => {
            Quantity::Motion(target::moved(model, target, &value.text()?)?, *measure)
        }
        (_, Quantity::Motion(target, measure)) => {
            Quantity::Motion(target::turned(target, value.word()?)?, *measure)
        }
    };
    model.responses[index].quantity = quantity;
    Ok(())
}

/// A quantity with another measure. An energy that becomes a motion is w at the right end.
fn measured(quantity: &Quantity, value: &Value) -> Result<Quantity, String> {
    let word = value.word()?;
    if word == ENERGY {
        return Ok(Quantity::Energy);
    }
    let measure = chosen(&Measure::ALL, Measure::key, value)
        .map_err(|message| format!("{message} or {ENERGY}"))?;
    Ok(match quantity {
        Quantity::Motion(target, _) => Quantity::Motion(target.clone(), measure),
        Quantity::Energy => Quantity::Motion(target::DEFAULT, measure),
    })
}

/// The one of some choices whose word a value is.
pub(super) fn chosen<T: Copy>(
    all: &[T],
    key: fn(T) -> &'static str,
    value: &Value,
) -> Result<T, String> {
    let word = value.word()?;
    all.iter()
        .copied()
        .find(|choice| key(*choice) == word)
        .ok_or_else(|| {
            let words: Vec<&str> = all.iter().map(|choice| key(*choice)).collect();
            format!("is {word:?}; must be {}", words.join(", "))
        })
}

#[cfg(test)]
mod tests {
    use crate::model::path::{Value, all, parameter, sample, set, set_unchecked};
    use crate::model::types::{
        BeamMotion, Elastic, Measure, Place, Quantity, Restraint, Support, Target,
    };

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
        // That a study moves the spring of w, which a fixed motion has not, is no reason to refuse.
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

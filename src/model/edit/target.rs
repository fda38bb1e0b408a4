//! The position and direction of a force or response, as text.

use super::value::Value;
use crate::model::beam::{BeamMotion, Point};
use crate::model::id::Group;
use crate::model::spelling::{nearest, segment};
use crate::model::types::{At, MassMotion, Model, Place, Target};
use crate::unit::{Unit, value_input};

/// The most subsystems that a message lists.
const MOST_LISTED: usize = 6;

/// The position as text that [`moved`] reads back: `left`, `right`, `1.6 m`, or a subsystem's name, in quotes if it
/// could be read as one of the others.
pub(super) fn place(target: &Target) -> String {
    match target.at() {
        At::Beam(Place::Left) => "left".to_owned(),
        At::Beam(Place::Right) => "right".to_owned(),
        At::Beam(Place::Position(position)) => Unit::METRE.format_exact(position),
        At::Subsystem(name) if is_plain(name) => name.to_owned(),
        At::Subsystem(name) => format!("'{name}'"),
    }
}

/// Whether [`moved`] reads a name without quotes as a name.
fn is_plain(name: &str) -> bool {
    let place = matches!(name, "" | "left" | "right")
        || value_input::number(name, 0.0, &Unit::METRE).is_ok();
    !place && name.trim() == name && unquoted(name).is_none()
}

/// The text inside quotes; none without quotes.
fn unquoted(text: &str) -> Option<&str> {
    let quoted = |quote| {
        text.strip_prefix(quote)
            .and_then(|rest: &str| rest.strip_suffix(quote))
    };
    quoted('\'').or_else(|| quoted('"'))
}

/// The target of a force or response; none for an energy.
pub fn target_of(model: &Model, group: Group) -> Option<&Target> {
    match group {
        Group::Force(index) => Some(&model.forces[index].target),
        Group::Response(index) => model.responses[index].quantity.target(),
        _ => None,
    }
}

/// As [`target_of`], or a message if there is none.
pub(super) fn known(model: &Model, group: Group) -> Result<&Target, String> {
    target_of(model, group).ok_or_else(|| "is an energy, that of the whole beam; the measure must be displacement, velocity or acceleration first".to_owned())
}

/// Sets the target; a direction that is the same at every point of the section has none.
fn put(model: &mut Model, group: Group, new: Target) {
    let (target, point) = match group {
        Group::Force(index) => {
            let force = &mut model.forces[index];
            (Some(&mut force.target), &mut force.point)
        }
        Group::Response(index) => {
            let response = &mut model.responses[index];
            (response.quantity.target_mut(), &mut response.point)
        }
        _ => return,
    };
    if !new.has_point() {
        *point = Point::AXIS;
    }
    if let Some(target) = target {
        *target = new;
    }
}

/// Moves a force or response to another position, with the motion that corresponds to the old one.
///
/// # Errors
/// It is an energy, or the text is not a position; the message says what is accepted.
pub(super) fn place_at(model: &mut Model, group: Group, value: Value) -> Result<(), String> {
    let old = known(model, group)?;
    let new = moved(model, old, &value.text()?)?;
    put(model, group, new);
    Ok(())
}

/// Gives a force or response another direction.
///
/// # Errors
/// It is an energy, or the position does not permit the direction; the message lists the accepted ones.
pub(super) fn turn(model: &mut Model, group: Group, value: &Value) -> Result<(), String> {
    let old = known(model, group)?;
    let new = turned(old, value.word()?)?;
    put(model, group, new);
    Ok(())
}

fn moved(model: &Model, old: &Target, text: &str) -> Result<Target, String> {
    let text = text.trim();
    let known = |name: &str| {
        model
            .subsystems
            .iter()
            .any(|subsystem| subsystem.name == name)
    };
    let at = |place| Target::Beam(place, beam_motion(old));
    // A change such as *1.1 starts from the current position.
    let position = match old {
        Target::Beam(Place::Position(position), _) => *position,
        _ => f64::NAN,
    };
    let name = match (text, unquoted(text)) {
        ("left", _) => return Ok(at(Place::Left)),
        ("right", _) => return Ok(at(Place::Right)),
        (_, Some(name)) if known(name) => name,
        _ => match value_input::number(text, position, &Unit::METRE) {
            Ok(position) => return Ok(at(Place::Position(position))),
            Err(_) if known(text) => text,
            Err(_) => return Err(no_place(model, text)),
        },
    };
    Ok(Target::Mass(name.to_owned(), mass_motion(old)))
}

fn turned(old: &Target, word: &str) -> Result<Target, String> {
    let (beam, mass) = (BeamMotion::of_word(word), MassMotion::of_word(word));
    let place = match (old, beam, mass) {
        (Target::Beam(place, _), Some(motion), _) => return Ok(Target::Beam(*place, motion)),
        (Target::Mass(name, _), _, Some(motion)) => return Ok(Target::Mass(name.clone(), motion)),
        (Target::Beam(..), ..) => "on the beam",
        (Target::Mass(..), ..) => "at a subsystem",
    };
    let fitting = old.directions().join(", ");
    Err(format!("is {word:?}; must be {fitting} {place}"))
}

/// The beam motion of a target, or the one that corresponds to its mass motion.
fn beam_motion(target: &Target) -> BeamMotion {
    match target {
        Target::Beam(_, motion) => *motion,
        Target::Mass(_, MassMotion::Y) => BeamMotion::W,
        Target::Mass(_, MassMotion::Z) => BeamMotion::V,
        Target::Mass(_, MassMotion::Theta) => BeamMotion::Psi,
    }
}

/// The mass motion of a target, or the one that corresponds to its beam motion.
fn mass_motion(target: &Target) -> MassMotion {
    match target {
        Target::Mass(_, motion) => *motion,
        Target::Beam(_, BeamMotion::W | BeamMotion::WSlope) => MassMotion::Y,
        Target::Beam(_, BeamMotion::V | BeamMotion::VSlope) => MassMotion::Z,
        Target::Beam(_, BeamMotion::Psi | BeamMotion::PsiSlope) => MassMotion::Theta,
    }
}

/// The accepted positions, in words.
pub(in crate::model) fn places(model: &Model) -> String {
    let names: Vec<String> = model
        .subsystems
        .iter()
        .take(MOST_LISTED + 1)
        .map(|of| segment(&of.name))
        .collect();
    match names.len() {
        0 => "left, right or a position in m".to_owned(),
        1..=MOST_LISTED => format!("left, right, a position in m or {}", names.join(", ")),
        _ => "left, right, a position in m or a subsystem's name".to_owned(),
    }
}

fn no_place(model: &Model, text: &str) -> String {
    let names = model.subsystems.iter().map(|subsystem| &*subsystem.name);
    let near = nearest(text, ["left", "right"].into_iter().chain(names));
    let near = near.map_or_else(String::new, |near| format!(" (did you mean {near:?}?)"));
    format!("is {text:?}{near}; must be {}", places(model))
}

#[cfg(test)]
mod tests {
    use crate::model::edit::{Value, set};
    use crate::model::path::{parameter, sample};

    fn at(text: &str) -> Value {
        Value::Text(text.to_owned())
    }

    #[test]
    fn moving_a_force_keeps_the_motion_that_corresponds() {
        for (beam, mass) in [("w", "y"), ("v", "z"), ("psi", "theta")] {
            let mut model = sample::model(&["S1"]);
            let direction = |model: &_| parameter(model, "forces.1.direction").unwrap();
            set(&mut model, "forces.1.direction", Value::Choice(beam)).unwrap();
            set(&mut model, "forces.1.at", at("S1")).unwrap();
            assert_eq!(direction(&model).value, Value::Choice(mass));
            assert_eq!(direction(&model).choices, ["y", "z", "theta"]);
            set(&mut model, "forces.1.at", at("0.4 m")).unwrap();
            assert_eq!(direction(&model).value, Value::Choice(beam));
            assert_eq!(direction(&model).choices.len(), 6);
        }
    }

    #[test]
    fn places_are_read_in_every_form() {
        let mut model = sample::model(&["S1", "1", "a b"]);
        let cases = [
            ("right", "right"),
            ("1.6", "1.6 m"),
            ("80 cm", "0.8 m"),
            ("*1.5", "1.2000000000000002 m"),
            ("a b", "a b"),
            ("'S1'", "S1"),
            ("\"1\"", "'1'"),
            ("1", "1 m"),
            (" left ", "left"),
            ("0", "0 m"),
        ];
        for (typed, shown) in cases {
            set(&mut model, "responses.1.at", at(typed))
                .unwrap_or_else(|faults| panic!("{typed}: {faults:?}"));
            assert_eq!(
                parameter(&model, "responses.1.at").unwrap().value,
                at(shown)
            );
        }
    }

    #[test]
    fn what_is_no_place_is_refused() {
        let mut model = sample::model(&["S1", "S2"]);
        for text in ["", "S9", "lft", "3.3", "-1", "nan", "80 kg", "''", "*2"] {
            let same = model.clone();
            let faults = set(&mut model, "forces.1.at", at(text)).unwrap_err();
            assert!(faults[0].message.contains("must be"), "{faults:?}");
            assert_eq!(model, same);
        }
        let faults = set(&mut model, "forces.1.at", at("lft")).unwrap_err();
        assert!(
            faults[0]
                .message
                .contains("left, right, a position in m or S1, S2"),
            "{faults:?}"
        );
        assert!(
            faults[0].message.contains("did you mean \"left\"?"),
            "{faults:?}"
        );
    }

    #[test]
    fn a_direction_must_fit_its_place() {
        let mut model = sample::model(&["S1"]);
        let faults = set(&mut model, "forces.1.direction", Value::Choice("theta")).unwrap_err();
        assert!(faults[0].message.contains("on the beam"), "{faults:?}");
        let faults = set(&mut model, "responses.mass.direction", Value::Choice("w")).unwrap_err();
        assert!(faults[0].message.contains("y, z, theta"), "{faults:?}");
    }
}

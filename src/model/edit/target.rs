//! The position and direction of a force or response, as text.

use super::value::Value;
use crate::model::beam::Point;
use crate::model::id::Group;
use crate::model::place::Places;
use crate::model::quantity::Quantity;
use crate::model::types::{At, Model, Target};

/// What has a position and a direction.
#[derive(Clone, Copy)]
pub(in crate::model) enum Placed<'a> {
    Force(&'a Target),
    Response(&'a Quantity),
}

impl<'a> Placed<'a> {
    /// The force or response of a group; none for an energy, which is that of the whole beam.
    pub(in crate::model) fn of(model: &'a Model, group: Group) -> Option<Self> {
        match group {
            Group::Force(index) => Some(Self::Force(&model.forces[index].target)),
            Group::Response(index) => {
                let quantity = &model.responses[index].quantity;
                quantity.at().is_some().then_some(Self::Response(quantity))
            }
            _ => None,
        }
    }

    /// Its position.
    pub(in crate::model) fn at(self) -> At<'a> {
        match self {
            Self::Force(target) => target.at(),
            Self::Response(quantity) => quantity.at().unwrap_or(At::Ground),
        }
    }

    /// The word of its direction.
    pub(super) fn direction(self) -> &'static str {
        match self {
            Self::Force(target) => target.direction(),
            Self::Response(quantity) => quantity.direction().unwrap_or_default(),
        }
    }

    /// The words of the directions that its position permits.
    pub(in crate::model) fn directions(self) -> &'static [&'static str] {
        match self {
            Self::Force(target) => target.directions(),
            Self::Response(quantity) => quantity.directions(),
        }
    }

    /// The accepted positions.
    pub(in crate::model) fn places(self, model: &Model) -> Places<'_> {
        match self {
            Self::Force(_) => Places::of_motion(model),
            Self::Response(quantity) => Places::of(quantity, model),
        }
    }

    /// The motion at which it acts or is read; none for what is no motion.
    pub(in crate::model) fn target(self) -> Option<&'a Target> {
        match self {
            Self::Force(target) => Some(target),
            Self::Response(quantity) => quantity.target(),
        }
    }
}

/// As [`Placed::of`], or a message if there is none.
pub(super) fn known(model: &Model, group: Group) -> Result<Placed<'_>, String> {
    Placed::of(model, group).ok_or_else(|| {
        "is an energy, that of the whole beam; must have another measure first".to_owned()
    })
}

/// Where a force acts or a response is read; none for an energy, which is that of the whole beam.
pub fn at_of(model: &Model, group: Group) -> Option<At<'_>> {
    Placed::of(model, group).map(Placed::at)
}

/// Moves a force or response to another position, with the direction that corresponds to the old one.
///
/// # Errors
/// It is an energy, or the text is not an accepted position; the message says what is accepted.
pub(super) fn place_at(model: &mut Model, group: Group, value: Value) -> Result<(), String> {
    let old = known(model, group)?;
    let text = value.text()?;
    let places = old.places(model);
    let at = places.read(&text, old.at())?;
    let new = match old {
        Placed::Force(target) => target.moved(at).map(Changed::Force),
        Placed::Response(quantity) => quantity.moved(at).map(Changed::Response),
    };
    put(model, group, new);
    Ok(())
}

/// Gives a force or response another direction.
///
/// # Errors
/// It is an energy, or the position does not permit the direction; the message lists the accepted ones.
pub(super) fn turn(model: &mut Model, group: Group, value: &Value) -> Result<(), String> {
    let (old, word) = (known(model, group)?, value.word()?);
    let new = match old {
        Placed::Force(target) => target.turned(word).map(Changed::Force),
        Placed::Response(quantity) => quantity.turned(word).map(Changed::Response),
    };
    if new.is_none() {
        let place = match old.at() {
            At::Beam(_) => "on the beam",
            At::Subsystem(_) => "at a subsystem",
            At::Support(_) => "at a support",
            At::Ground => "on the ground",
        };
        let fitting = old.directions().join(", ");
        return Err(format!("is {word:?}; must be {fitting} {place}"));
    }
    put(model, group, new);
    Ok(())
}

/// A force's new position and direction, or a response's new quantity.
enum Changed {
    Force(Target),
    Response(Quantity),
}

/// Changes a force or response; a direction that is the same at every point of the section has none.
fn put(model: &mut Model, group: Group, new: Option<Changed>) {
    match (group, new) {
        (Group::Force(index), Some(Changed::Force(target))) => {
            let force = &mut model.forces[index];
            if !target.has_point() {
                force.point = Point::AXIS;
            }
            force.target = target;
        }
        (Group::Response(index), Some(Changed::Response(quantity))) => {
            model.responses[index].set_quantity(quantity);
        }
        _ => {}
    }
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

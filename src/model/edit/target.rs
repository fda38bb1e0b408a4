//! Where a force acts or a response is taken, as text.

use crate::model::names::{nearest, segment};
use crate::model::types::{BeamMotion, MassMotion, Model, Place, Target};
use crate::unit::{Unit, entry};

/// Where an energy's response goes when it becomes a motion.
pub(super) const DEFAULT: Target = Target::Beam(Place::Right, BeamMotion::W);

/// More subsystems than this are not listed.
const MOST_LISTED: usize = 6;

/// The place as text that [`moved`] reads back: `left`, `right`, `1.6 m`, or a subsystem's name, in quotes where it
/// looks like one of the others.
pub(super) fn place(target: &Target) -> String {
    match target {
        Target::Beam(Place::Left, _) => "left".to_owned(),
        Target::Beam(Place::Right, _) => "right".to_owned(),
        Target::Beam(Place::Position(position), _) => Unit::METRE.format_exact(*position),
        Target::Mass(name, _) if is_plain(name) => name.clone(),
        Target::Mass(name, _) => format!("'{name}'"),
    }
}

/// Whether a name is read as a name without quotes.
fn is_plain(name: &str) -> bool {
    let place =
        matches!(name, "" | "left" | "right") || entry::number(name, 0.0, &Unit::METRE).is_ok();
    !place && name.trim() == name && unquoted(name).is_none()
}

/// What stands in quotes; none without them.
fn unquoted(text: &str) -> Option<&str> {
    let quoted = |quote| {
        text.strip_prefix(quote)
            .and_then(|rest: &str| rest.strip_suffix(quote))
    };
    quoted('\'').or_else(|| quoted('"'))
}

/// The direction's word.
pub(super) fn direction(target: &Target) -> &'static str {
    match target {
        Target::Beam(_, motion) => motion.key(),
        Target::Mass(_, motion) => motion.key(),
    }
}

/// The words of the directions that fit the place.
pub(in crate::model) fn directions(target: &Target) -> Vec<&'static str> {
    match target {
        Target::Beam(..) => BeamMotion::ALL.map(BeamMotion::key).to_vec(),
        Target::Mass(..) => MassMotion::ALL.map(MassMotion::key).to_vec(),
    }
}

/// The target at another place, with the motion that is nearest to the old one there.
///
/// # Errors
/// The text is no place; says what would be.
pub(super) fn moved(model: &Model, old: &Target, text: &str) -> Result<Target, String> {
    let text = text.trim();
    let known = |name: &str| {
        model
            .subsystems
            .iter()
            .any(|subsystem| subsystem.name == name)
    };
    let at = |place| Target::Beam(place, beam_motion(old));
    // A change such as *1.1 needs a position to start from.
    let position = match old {
        Target::Beam(Place::Position(position), _) => *position,
        _ => f64::NAN,
    };
    let name = match (text, unquoted(text)) {
        ("left", _) => return Ok(at(Place::Left)),
        ("right", _) => return Ok(at(Place::Right)),
        (_, Some(name)) if known(name) => name,
        _ => match entry::number(text, position, &Unit::METRE) {
            Ok(position) => return Ok(at(Place::Position(position))),
            Err(_) if known(text) => text,
            Err(_) => return Err(no_place(model, text)),
        },
    };
    Ok(Target::Mass(name.to_owned(), mass_motion(old)))
}

/// The target along another direction.
///
/// # Errors
/// The direction does not fit the place; says which do.
pub(super) fn turned(old: &Target, word: &str) -> Result<Target, String> {
    let beam = BeamMotion::ALL
        .into_iter()
        .find(|motion| motion.key() == word);
    let mass = MassMotion::ALL
        .into_iter()
        .find(|motion| motion.key() == word);
    match (old, beam, mass) {
        (Target::Beam(place, _), Some(motion), _) => Ok(Target::Beam(*place, motion)),
        (Target::Mass(name, _), _, Some(motion)) => Ok(Target::Mass(name.clone(), motion)),
        _ => {
            let place = if matches!(old, Target::Beam(..)) {
                "on the beam"
            } else {
                "at a subsystem"
            };
            Err(format!(
                "is {word:?}; must be {} {place}",
                directions(old).join(", ")
            ))
        }
    }
}

/// The motion of the beam along which a target is, or that of the beam nearest to it.
fn beam_motion(target: &Target) -> BeamMotion {
    match target {
        Target::Beam(_, motion) => *motion,
        Target::Mass(_, MassMotion::Y) => BeamMotion::W,
        Target::Mass(_, MassMotion::Z) => BeamMotion::V,
        Target::Mass(_, MassMotion::Theta) => BeamMotion::Psi,
    }
}

/// The motion of a mass along which a target is, or that of a mass nearest to it.
fn mass_motion(target: &Target) -> MassMotion {
    match target {
        Target::Mass(_, motion) => *motion,
        Target::Beam(_, BeamMotion::W | BeamMotion::WSlope) => MassMotion::Y,
        Target::Beam(_, BeamMotion::V | BeamMotion::VSlope) => MassMotion::Z,
        Target::Beam(_, BeamMotion::Psi | BeamMotion::PsiSlope) => MassMotion::Theta,
    }
}

/// The places there are, in words.
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

//! Forces and responses of a model file.

use super::super::beam::{BeamMotion, Point};
use super::super::quantity::{Across, Holder, Quantity, Reaction, Response, SpringMeasure};
use super::super::schema::{FORCE, Kind, RESPONSE};
use super::super::spring::SpringName;
use super::super::toml_literal::format_number;
use super::super::types::{Force, MassMotion, Place, Target};
use super::list::{named, names as element_names};
use super::reader::Reader;
use super::table::Table;
use super::value::number;
use crate::unit::Measure;
use toml::de::DeValue;

/// The list of forces.
pub(super) fn forces(root: &mut Table<'_>, names: &[&str], reader: &mut Reader) -> Vec<Force> {
    let mut forces = Vec::new();
    for (index, node) in root
        .list("forces", "tables", reader)
        .into_iter()
        .enumerate()
    {
        let placeholder = Target::Beam(Place::Left, BeamMotion::W);
        let mut force = Force {
            enabled: true,
            target: placeholder,
            point: Point::AXIS,
            amplitude: 1.0,
            phase: 0.0,
        };
        if let Some(mut table) = Table::open(format!("forces.{}", index + 1), node, reader) {
            table.rows(&mut force, &FORCE, reader, |table, force, kind, reader| {
                // The position determines the accepted directions.
                if kind == Kind::Place {
                    force.target = target(table, names, reader);
                }
            });
            table.finish(reader);
        }
        forces.push(force);
    }
    forces
}

/// The list of responses.
pub(super) fn responses(
    root: &mut Table<'_>,
    names: &[&str],
    reader: &mut Reader,
) -> Vec<Response> {
    let list = root.list("responses", "tables", reader);
    reader.response_lost =
        element_names(&list).contains(&"") || (list.is_empty() && root.has("responses"));
    let mut responses = Vec::new();
    for table in named(&list, "responses", reader) {
        let mut response = Response {
            name: String::new(),
            enabled: true,
            quantity: Quantity::Energy,
            point: Point::AXIS,
            over: None,
        };
        if let Some(mut table) = table {
            table.rows(
                &mut response,
                &RESPONSE,
                reader,
                |table, response, kind, reader| {
                    // The measure determines whether there is a position.
                    if kind == Kind::Measure {
                        response.quantity = quantity(table, names, reader);
                    }
                },
            );
            table.finish(reader);
        }
        responses.push(response);
    }
    responses
}

fn quantity(table: &mut Table<'_>, names: &[&str], reader: &mut Reader) -> Quantity {
    let words = Quantity::words();
    let word = table.word("measure", &words, Some(0), reader);
    let word = word.map(|index| words[index]);
    let spring = word.and_then(SpringMeasure::of_word);
    match (word, word.and_then(Measure::of_word), spring) {
        (_, Some(measure), _) => Quantity::Motion(target(table, names, reader), measure),
        (_, _, Some(measure)) => {
            let name = match place(table, "a subsystem's name", reader) {
                Some(Err(name)) => name,
                Some(Ok(place)) => text_of(place),
                None => String::new(),
            };
            let spring = table.word("direction", SpringName::WORDS, None, reader);
            let spring = spring.map_or(SpringName::YLeft, |index| SpringName::ALL[index]);
            Quantity::Spring(name, spring, measure)
        }
        (Some(Quantity::REACTION), ..) => Quantity::Reaction(reaction(table, reader)),
        (Some(Quantity::INTERNAL_FORCE), ..) => {
            let expected = "\"left\", \"right\" or a position in m";
            let place = match place(table, expected, reader) {
                Some(Ok(place)) => place,
                Some(Err(name)) => {
                    if let Some((path, node)) = table.take("at", reader) {
                        let message = format!("is {name:?}; must be {expected}");
                        reader.fault(node.span().start, &path, message);
                    }
                    Place::Left
                }
                None => Place::Left,
            };
            Quantity::InternalForce(place, beam_motion(table, reader))
        }
        (Some(_), ..) => {
            for key in ["at", "direction", "y", "z", "over"] {
                if let Some((path, node)) = table.take(key, reader) {
                    let message = "cannot be combined with measure = \"energy\", that of the whole beam; must be omitted";
                    reader.fault(node.span().start, &path, message);
                }
            }
            Quantity::Energy
        }
        // Whether a position is missing depends on the unreadable measure.
        (None, ..) if table.has("at") && table.has("direction") => {
            Quantity::Motion(target(table, names, reader), Measure::Displacement)
        }
        (None, ..) => {
            table.take("at", reader);
            table.take("direction", reader);
            Quantity::Energy
        }
    }
}

/// The support or the ground, and its direction; the checks report an unknown support.
fn reaction(table: &mut Table<'_>, reader: &mut Reader) -> Reaction {
    let expected = "\"left\", \"right\", an inner support's name or \"ground\"";
    let holder = match place(table, expected, reader) {
        Some(Ok(Place::Left)) | None => Holder::Left,
        Some(Ok(Place::Right)) => Holder::Right,
        Some(Err(name)) if name == "ground" => {
            let across = table.word("direction", Across::WORDS, None, reader);
            let across = across.map_or(Across::W, |index| Across::ALL[index]);
            return Reaction::Ground(across);
        }
        Some(Err(name)) => Holder::Inner(name),
        Some(Ok(place @ Place::Position(_))) => Holder::Inner(text_of(place)),
    };
    Reaction::Support(holder, beam_motion(table, reader))
}

/// A position as the text of a name, which the checks report as unknown.
fn text_of(place: Place) -> String {
    match place {
        Place::Left => "left".to_owned(),
        Place::Right => "right".to_owned(),
        Place::Position(position) => format_number(position),
    }
}

fn beam_motion(table: &mut Table<'_>, reader: &mut Reader) -> BeamMotion {
    let motion = table.word("direction", BeamMotion::WORDS, None, reader);
    motion.map_or(BeamMotion::W, |index| BeamMotion::ALL[index])
}

/// Position and direction; the checks report an unknown subsystem.
fn target(table: &mut Table<'_>, names: &[&str], reader: &mut Reader) -> Target {
    let place = place(
        table,
        "\"left\", \"right\", a position in m or a subsystem's name",
        reader,
    );
    let (beam, mass) = (BeamMotion::WORDS, MassMotion::WORDS);
    match place {
        Some(Ok(place)) => Target::Beam(place, beam_motion(table, reader)),
        Some(Err(name)) if names.contains(&name.as_str()) => {
            let motion = table.word("direction", mass, None, reader);
            Target::Mass(
                name,
                motion.map_or(MassMotion::Y, |index| MassMotion::ALL[index]),
            )
        }
        unknown => {
            table.word("direction", &[beam, mass].concat(), None, reader);
            match unknown {
                Some(Err(name)) => Target::Mass(name, MassMotion::Y),
                _ => Target::Beam(Place::Left, BeamMotion::W),
            }
        }
    }
}

/// A position on the beam, or another word; none if unreadable.
fn place(
    table: &mut Table<'_>,
    expected: &str,
    reader: &mut Reader,
) -> Option<Result<Place, String>> {
    let (path, node) = table.need("at", expected, reader)?;
    match node.get_ref() {
        DeValue::String(word) => Some(match word.as_ref() {
            "left" => Ok(Place::Left),
            "right" => Ok(Place::Right),
            name => Err(name.to_owned()),
        }),
        _ => Some(Ok(Place::Position(number(&path, node, expected, reader)))),
    }
}

//! Forces and responses of a model file.

use super::super::beam::{BeamMotion, Point};
use super::super::quantity::{Quantity, Response};
use super::super::schema::{FORCE, Kind, RESPONSE};
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
    match table.word("measure", &words, Some(0), reader) {
        Some(index) if index < Measure::ALL.len() => {
            Quantity::Motion(target(table, names, reader), Measure::ALL[index])
        }
        Some(_) => {
            for key in ["at", "direction", "y", "z"] {
                if let Some((path, node)) = table.take(key, reader) {
                    let message = "cannot be combined with measure = \"energy\", that of the whole beam; must be omitted";
                    reader.fault(node.span().start, &path, message);
                }
            }
            Quantity::Energy
        }
        // Whether a position is missing depends on the unreadable measure.
        None if table.has("at") && table.has("direction") => {
            Quantity::Motion(target(table, names, reader), Measure::Displacement)
        }
        None => {
            table.take("at", reader);
            table.take("direction", reader);
            Quantity::Energy
        }
    }
}

/// Position and direction; the checks report an unknown subsystem.
fn target(table: &mut Table<'_>, names: &[&str], reader: &mut Reader) -> Target {
    let place = place(table, reader);
    let (beam, mass) = (BeamMotion::WORDS, MassMotion::WORDS);
    match place {
        Some(Ok(place)) => {
            let motion = table.word("direction", beam, None, reader);
            Target::Beam(
                place,
                motion.map_or(BeamMotion::W, |index| BeamMotion::ALL[index]),
            )
        }
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

/// A position on the beam, or the name of a subsystem; none if unreadable.
fn place(table: &mut Table<'_>, reader: &mut Reader) -> Option<Result<Place, String>> {
    const EXPECTED: &str = "\"left\", \"right\", a position in m or a subsystem's name";
    let (path, node) = table.need("at", EXPECTED, reader)?;
    match node.get_ref() {
        DeValue::String(word) => Some(match word.as_ref() {
            "left" => Ok(Place::Left),
            "right" => Ok(Place::Right),
            name => Err(name.to_owned()),
        }),
        _ => Some(Ok(Place::Position(number(&path, node, EXPECTED, reader)))),
    }
}

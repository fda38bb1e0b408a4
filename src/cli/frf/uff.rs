//! Frequency responses as a universal file.

use std::cell::Cell;
use std::cmp::Ordering;
use std::fmt::Write;
use std::path::Path;

use num_complex::Complex64;

use super::{Curve, Member, Points, warn_of};
use crate::cli::{Failure, csv, say};
use crate::measured::{Node, Record, Written, write_uff};
use crate::model::{BeamMotion, Checked, MassMotion, Place, Point, Response, Target, counted};
use crate::solve::{Frf, Reference};

/// A model's curve, solved.
struct Solved<'a> {
    key: Option<&'a str>,
    model: &'a Checked,
    frf: Frf,
    /// The names of the curves in the file.
    names: Vec<String>,
}

/// Writes data set 58 for each response of each member; all of a sweep is in memory.
pub(super) fn write(
    output: Option<&Path>,
    members: &[Member],
    points: Points,
) -> Result<(), Failure> {
    let mut singular = Vec::new();
    let mut solved = Vec::new();
    for (key, model) in members {
        let curve = Curve::new(model, points)?;
        let mut frf = curve.block(0..curve.base.len())?;
        singular.extend(frf.singular());
        divide(&mut frf, model);
        let names = frf.columns.iter().map(|column| match key {
            Some(key) => format!("{}, {key}", column.name),
            None => column.name.clone(),
        });
        solved.push(Solved {
            key: key.as_deref(),
            model,
            names: names.collect(),
            frf,
        });
    }
    let records: Vec<Record> = solved.iter().flat_map(Solved::records).collect();
    let written = Cell::new(Written::default());
    csv::write(output, |out| {
        written.set(write_uff(out, &records)?);
        Ok(())
    })?;
    warn_of(&singular, "left out");
    warn_of_losses(written.get());
    Ok(())
}

/// Divides motions by the single force; energies and responses to several forces do not change.
fn divide(frf: &mut Frf, model: &Checked) {
    let Some(reference) = Reference::of(model) else {
        return;
    };
    let quantities = enabled(model).map(|response| &response.quantity);
    for (column, quantity) in frf.columns.iter_mut().zip(quantities) {
        if !quantity.is_quadratic() {
            column
                .values
                .iter_mut()
                .for_each(|value| *value /= reference.amplitude);
        }
    }
}

fn enabled(model: &Checked) -> impl Iterator<Item = &Response> {
    model.responses.iter().filter(|response| response.enabled)
}

impl Solved<'_> {
    fn records(&self) -> Vec<Record<'_>> {
        let places = Places::of(self.model);
        let reference = Reference::of(self.model);
        let force = self
            .model
            .forces
            .iter()
            .find(|force| force.enabled && reference.is_some());
        let columns = self
            .frf
            .columns
            .iter()
            .zip(&self.names)
            .zip(enabled(self.model));
        columns
            .map(|((column, name), response)| {
                let kind = response.quantity.kind(reference.map(|one| one.load));
                let force = force.filter(|_| !response.quantity.is_quadratic());
                Record {
                    name,
                    title: self.title(),
                    kind,
                    response: moved(response).map(|at| places.node(at)),
                    reference: force.map(|force| places.node((&force.target, force.point))),
                    frequencies: &self.frf.frequencies,
                    values: &column.values as &[Complex64],
                }
            })
            .collect()
    }

    fn title(&self) -> &str {
        match self.model.title.trim() {
            "" => self.key.unwrap_or_default(),
            title => title,
        }
    }
}

/// What a motion is of, and its point of the section; none for an energy.
fn moved(response: &Response) -> Option<(&Target, Point)> {
    Some((response.quantity.target()?, response.point))
}

/// The numbered nodes of a model: those on the beam from left to right, then the masses in the order of the model.
struct Places<'a> {
    model: &'a Checked,
    /// Distance from the left end and point of the section, m.
    beam: Vec<[f64; 3]>,
}

impl<'a> Places<'a> {
    fn of(model: &'a Checked) -> Self {
        let of_responses = enabled(model).filter_map(moved);
        let of_forces = model
            .forces
            .iter()
            .map(|force| (&force.target, force.point));
        let on_beam = |(target, point): (&Target, Point)| match target {
            Target::Beam(place, _) => Some(Self::place(model, *place, point)),
            Target::Mass(..) => None,
        };
        let mut beam: Vec<[f64; 3]> = of_responses.chain(of_forces).filter_map(on_beam).collect();
        // The numbers of a checked model are finite.
        beam.sort_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        beam.dedup();
        Self { model, beam }
    }

    fn place(model: &Checked, place: Place, point: Point) -> [f64; 3] {
        [place.position(model.length()), point.y, point.z]
    }

    /// Number, name and direction. Directions: x along the beam, w and y along y, v and z along z; psi and theta about
    /// x, v' 5 and w' 6, all with the sign of the model; a rate of twist is a scalar.
    fn node(&self, (target, point): (&Target, Point)) -> Node {
        let (number, name, direction) = match target {
            Target::Beam(place, motion) => {
                let mut name = match place {
                    Place::Left => "left".to_owned(),
                    Place::Right => "right".to_owned(),
                    Place::Position(x) => format!("x={x}"),
                };
                if point != Point::AXIS {
                    let _ = write!(name, " y={} z={}", point.y, point.z);
                }
                let own = Self::place(self.model, *place, point);
                let number = self.beam.iter().position(|place| *place == own);
                let direction = match motion {
                    BeamMotion::W => 2,
                    BeamMotion::V => 3,
                    BeamMotion::Psi => 4,
                    BeamMotion::VSlope => 5,
                    BeamMotion::WSlope => 6,
                    BeamMotion::PsiSlope => 0,
                };
                (number.unwrap_or_default(), name, direction)
            }
            Target::Mass(name, motion) => {
                let mut subsystems = self.model.subsystems.iter();
                let index = subsystems.position(|subsystem| subsystem.name == *name);
                let direction = match motion {
                    MassMotion::Y => 2,
                    MassMotion::Z => 3,
                    MassMotion::Theta => 4,
                };
                (
                    self.beam.len() + index.unwrap_or(0),
                    name.clone(),
                    direction,
                )
            }
        };
        Node {
            name,
            number: u32::try_from(number + 1).unwrap_or(u32::MAX),
            direction,
        }
    }
}

/// Warns of what the file lacks. The written values are still correct.
fn warn_of_losses(written: Written) {
    if written.frequency_error > 0.0 {
        say(&format!(
            "warning: data set 58 stores six digits of each frequency, or of the first one and the step if they are even: \
             they are up to {:.1e} Hz off; CSV has all digits",
            written.frequency_error
        ));
    }
    if written.repeated > 0 {
        say(&format!(
            "warning: {} left out: in six digits their frequencies equal those of their neighbours; CSV has them all",
            values(written.repeated)
        ));
    }
    if written.not_finite > 0 {
        say(&format!(
            "warning: {} left out: they are not finite",
            values(written.not_finite)
        ));
    }
}

fn values(count: usize) -> String {
    counted(count, "value is", "values are")
}

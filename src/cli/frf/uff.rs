//! Frequency responses as a universal file.

use std::cell::Cell;
use std::cmp::Ordering;
use std::fmt::Write;
use std::path::Path;

use num_complex::Complex64;

use super::{Curve, Member, Points, warn_of};
use crate::cli::{Failure, csv, say};
use crate::measured::{Node, Record, Written, write_uff};
use crate::model::{
    BeamMotion, Checked, MassMotion, Place, Point, Quantity, Reaction, Response, SpringName,
    SupportId, Target, counted,
};
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

/// Divides what is in proportion to the single force by it.
fn divide(frf: &mut Frf, model: &Checked) {
    let Some(reference) = Reference::of(model) else {
        return;
    };
    for (column, response) in frf.columns.iter_mut().zip(enabled(model)) {
        if response.is_linear() {
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
                let force = force.filter(|_| response.is_linear());
                let force = force.map(|force| places.node((&force.target, force.point)));
                let node = |of: &Response| {
                    let (target, point) = read_at(self.model, of)?;
                    Some(places.node((&target, point)))
                };
                Record {
                    name,
                    title: self.title(),
                    kind: response.kind(self.model, reference.map(|one| one.load)),
                    response: node(response),
                    reference: response.divisor(self.model).and_then(node).or(force),
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

/// The motion along which a response is read, and its point of the section; none for what is of the whole beam.
fn read_at(model: &Checked, response: &Response) -> Option<(Target, Point)> {
    let on_axis = |target| Some((target, Point::AXIS));
    match &response.quantity {
        Quantity::Motion(target, _) => Some((target.clone(), response.point)),
        Quantity::Reaction(Reaction::Support(holder, motion)) => {
            let id = SupportId::all(model).find(|id| id.name(model) == holder.name())?;
            let place = match id {
                SupportId::Left => Place::Left,
                SupportId::Right => Place::Right,
                SupportId::Inner(_) => Place::Position(id.position(model)),
            };
            Some((Target::Beam(place, *motion), id.support(model).point))
        }
        Quantity::InternalForce(place, motion) => on_axis(Target::Beam(*place, *motion)),
        Quantity::Spring(name, spring, _) => {
            let motion = match spring {
                SpringName::YLeft | SpringName::YRight => MassMotion::Y,
                SpringName::ZLeft | SpringName::ZRight => MassMotion::Z,
            };
            on_axis(Target::Mass(name.clone(), motion))
        }
        Quantity::Reaction(Reaction::Ground(_)) | Quantity::Energy => None,
    }
}

/// The numbered nodes of a model: those on the beam from left to right, then the masses in the order of the model.
struct Places<'a> {
    model: &'a Checked,
    /// Distance from the left end and point of the section, m.
    beam: Vec<[f64; 3]>,
}

impl<'a> Places<'a> {
    fn of(model: &'a Checked) -> Self {
        let of_responses = model.computed().filter_map(|of| read_at(model, of));
        let of_forces = model.forces.iter();
        let of_forces = of_forces.map(|force| (force.target.clone(), force.point));
        let on_beam = |(target, point): (Target, Point)| match target {
            Target::Beam(place, _) => Some(Self::place(model, place, point)),
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

//! The rules of forces and responses: their positions and directions.

use super::super::beam::{BeamMotion, Point};
use super::super::fault::Fault;
use super::super::place::Places;
use super::super::quantity::{Holder, Quantity, Reaction, Response};
use super::super::schema::{FORCE, RESPONSE};
use super::super::spelling::{self, element_keys};
use super::super::toml_literal::format_number;
use super::super::types::{MassMotion, Model, Place, Subsystem, Target};
use super::{beyond_the_end, element_names, not_finite, numbers};
use std::collections::HashSet;

/// The most faults that suggest the nearest name, because the search is slow among many names.
const MOST_HINTS: usize = 50;

/// The rules of the forces.
pub(super) fn forces(model: &Model, faults: &mut Vec<Fault>) {
    for (index, force) in model.forces.iter().enumerate() {
        let path = format!("forces.{}", index + 1);
        let before = faults.len();
        target(&path, &force.target, force.enabled, model, faults);
        point(&path, force.point, Some(&force.target), faults);
        if let Target::Beam(place, BeamMotion::PsiSlope) = force.target
            && faults.len() == before
            && !warps_at(model, place)
        {
            faults.push(Fault::new(
                format!("{path}.direction"),
                "\"psi_slope\" is a bimoment, which a section with a warping_constant of 0 cannot carry; must be another \
                 direction",
            ));
        }
        numbers(&path, force, &FORCE, faults);
    }
}

/// Whether the beam has warping stiffness at a place, on either side.
fn warps_at(model: &Model, place: Place) -> bool {
    let x = place.position(model.length());
    let parts = model.uniform_parts().into_iter();
    let mut here = parts.filter(|part| (part.start..=part.end).contains(&x));
    here.any(|part| part.beam.section.warping_constant != 0.0)
}

/// The rules of the responses.
pub(super) fn responses(model: &Model, faults: &mut Vec<Fault>) {
    let names = model
        .responses
        .iter()
        .map(|response| response.name.as_str());
    element_names("responses", &names, faults);
    let divisors: HashSet<&str> = model
        .responses
        .iter()
        .filter(|response| response.enabled)
        .filter_map(|response| response.over.as_deref())
        .collect();
    for (response, key) in model.responses.iter().zip(element_keys(names)) {
        let path = format!("responses.{key}");
        // What divides an enabled response is computed, too.
        let in_use = response.enabled || divisors.contains(response.name.as_str());
        match &response.quantity {
            Quantity::Motion(at, _) => target(&path, at, in_use, model, faults),
            Quantity::Reaction(Reaction::Support(Holder::Inner(name), _)) => {
                let mut inner = model.supports.inner.iter();
                if !inner.any(|support| support.name == *name) {
                    let places = Places::of(&response.quantity, model);
                    no_such_place(&path, name, &places, faults);
                }
            }
            Quantity::InternalForce(at, _) => place(&path, *at, model, faults),
            Quantity::Spring(name, ..) => match subsystem(model, name) {
                None => {
                    let places = Places::of(&response.quantity, model);
                    no_such_place(&path, name, &places, faults);
                }
                Some(subsystem) if in_use => attached(&path, subsystem, faults),
                Some(_) => {}
            },
            Quantity::Reaction(
                Reaction::Support(Holder::Left | Holder::Right, _) | Reaction::Ground(_),
            )
            | Quantity::Energy => {}
        }
        over(&path, response, model, faults);
        point(&path, response.point, response.quantity.target(), faults);
        numbers(&path, response, &RESPONSE, faults);
    }
}

/// The response that divides another one: it exists, has a phase and is not itself divided.
fn over(path: &str, response: &Response, model: &Model, faults: &mut Vec<Fault>) {
    let Some(name) = &response.over else { return };
    let accepted =
        "must be the name of a response that is neither an energy nor itself over another one";
    let message = match response.divisor(model) {
        _ if response.quantity.is_quadratic() => {
            "cannot divide an energy, which has no phase; must be omitted".to_owned()
        }
        None => {
            let known = model.responses.iter().map(|one| one.name.as_str());
            let known = known.filter(|known| *known != response.name);
            let near = spelling::nearest(name, known);
            let near = near.map_or_else(String::new, |near| format!(" (did you mean {near:?}?)"));
            format!("{name:?} is not a response{near}; {accepted}")
        }
        Some(_) if *name == response.name => {
            format!("{name:?} is this response itself; {accepted}")
        }
        Some(divisor) if divisor.quantity.is_quadratic() => {
            format!("{name:?} is an energy, which has no phase; {accepted}")
        }
        Some(divisor) => match &divisor.over {
            Some(next) => format!("{name:?} is itself over {next:?}; {accepted}"),
            None => return,
        },
    };
    faults.push(Fault::new(format!("{path}.over"), message));
}

/// A point of the section, which only a displacement of the beam has.
fn point(path: &str, point: Point, target: Option<&Target>, faults: &mut Vec<Fault>) {
    if target.is_some_and(Target::has_point) {
        return;
    }
    for (key, value) in [("y", point.y), ("z", point.z)] {
        if value != 0.0 {
            let message = format!(
                "is {} m; must be left out: only w and v of the beam differ from point to point of the section",
                format_number(value)
            );
            faults.push(Fault::new(format!("{path}.{key}"), message));
        }
    }
}

/// The position of a force or a motion: on the beam, or at a subsystem that exists and, if in use, is attached.
fn target(path: &str, target: &Target, in_use: bool, model: &Model, faults: &mut Vec<Fault>) {
    match target {
        Target::Beam(at, _) => place(path, *at, model, faults),
        Target::Mass(name, motion) => match subsystem(model, name) {
            None => no_such_place(path, name, &Places::of_motion(model), faults),
            Some(subsystem) if in_use => mass(path, subsystem, *motion, faults),
            Some(_) => {}
        },
    }
}

/// A position on the beam.
fn place(path: &str, at: Place, model: &Model, faults: &mut Vec<Fault>) {
    let Place::Position(position) = at else {
        return;
    };
    let path = format!("{path}.at");
    if !position.is_finite() {
        faults.push(Fault::new(path, not_finite(position)));
    } else if position < 0.0 {
        let message = format!("is {}; must be >= 0", format_number(position));
        faults.push(Fault::new(path, message));
    } else {
        beyond_the_end(format_args!("{path}"), position, model, faults);
    }
}

fn subsystem<'a>(model: &'a Model, name: &str) -> Option<&'a Subsystem> {
    model.subsystems.iter().find(|one| one.name == name)
}

/// A name that is none of the accepted places; with a similar one if few faults were found before.
fn no_such_place(path: &str, name: &str, places: &Places<'_>, faults: &mut Vec<Fault>) {
    let message = places.refusal(name, faults.len() < MOST_HINTS);
    faults.push(Fault::new(format!("{path}.at"), message));
}

/// A subsystem that is in use.
fn attached(path: &str, subsystem: &Subsystem, faults: &mut Vec<Fault>) {
    let name = &subsystem.name;
    if !subsystem.enabled {
        faults.push(Fault::new(
            format!("{path}.at"),
            format!(
                "subsystem {name:?} is disabled; set subsystems.{}.enabled = true or {path}.enabled = false",
                spelling::segment(name)
            ),
        ));
    }
}

/// A motion of a mass that is in use.
fn mass(path: &str, subsystem: &Subsystem, motion: MassMotion, faults: &mut Vec<Fault>) {
    attached(path, subsystem, faults);
    if motion == MassMotion::Theta && !subsystem.can_turn() {
        faults.push(Fault::new(
            format!("{path}.direction"),
            format!(
                "nothing resists theta of subsystem {:?}; its inertia must be > 0, or a z spring or damper must act \
                 on an arm",
                subsystem.name
            ),
        ));
    }
}

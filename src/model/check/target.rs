//! The rules of forces and responses: their positions and directions.

use super::super::beam::{BeamMotion, Point};
use super::super::fault::Fault;
use super::super::schema::{FORCE, RESPONSE};
use super::super::spelling::{self, element_keys};
use super::super::toml_literal::format_number;
use super::super::types::{MassMotion, Model, Place, Subsystem, Target};
use super::{beyond_the_end, element_names, not_finite, numbers};

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
    for (response, key) in model.responses.iter().zip(element_keys(names)) {
        let path = format!("responses.{key}");
        let at = response.quantity.target();
        if let Some(at) = at {
            target(&path, at, response.enabled, model, faults);
        }
        point(&path, response.point, at, faults);
        numbers(&path, response, &RESPONSE, faults);
    }
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

/// The position of a force or response: on the beam, or at a subsystem that exists and, if in use, is attached.
fn target(path: &str, target: &Target, in_use: bool, model: &Model, faults: &mut Vec<Fault>) {
    match target {
        Target::Beam(Place::Left | Place::Right, _) => {}
        Target::Beam(Place::Position(position), _) => {
            let path = format!("{path}.at");
            if !position.is_finite() {
                faults.push(Fault::new(path, not_finite(*position)));
            } else if *position < 0.0 {
                faults.push(Fault::new(
                    path,
                    format!("is {}; must be >= 0", format_number(*position)),
                ));
            } else {
                beyond_the_end(format_args!("{path}"), *position, model, faults);
            }
        }
        Target::Mass(name, motion) => match model
            .subsystems
            .iter()
            .find(|subsystem| subsystem.name == *name)
        {
            None => {
                let message = no_such_place(name, model, faults.len() < MOST_HINTS);
                faults.push(Fault::new(format!("{path}.at"), message));
            }
            Some(subsystem) if in_use => mass(path, subsystem, *motion, faults),
            Some(_) => {}
        },
    }
}

fn no_such_place(name: &str, model: &Model, hint: bool) -> String {
    let known = ["left", "right"].into_iter().chain(
        model
            .subsystems
            .iter()
            .map(|subsystem| subsystem.name.as_str()),
    );
    let near = if hint {
        spelling::nearest(name, known)
    } else {
        None
    };
    let near = near.map_or_else(String::new, |near| format!(" (did you mean {near:?}?)"));
    format!(
        "{name:?} is not a subsystem{near}; must be \"left\", \"right\", a position in m or {}",
        if model.subsystems.is_empty() {
            "a subsystem's name (there is none)"
        } else {
            "a subsystem's name"
        }
    )
}

/// A motion of a mass that is in use.
fn mass(path: &str, subsystem: &Subsystem, motion: MassMotion, faults: &mut Vec<Fault>) {
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
    let moment = |left: f64, right: f64| {
        left * subsystem.arm_left.powi(2) + right * subsystem.arm_right.powi(2) == 0.0
    };
    if motion == MassMotion::Theta
        && subsystem.inertia == 0.0
        && moment(subsystem.z_left.stiffness, subsystem.z_right.stiffness)
        && moment(subsystem.z_left.damping, subsystem.z_right.damping)
    {
        faults.push(Fault::new(
            format!("{path}.direction"),
            format!(
                "nothing resists theta of subsystem {name:?}; its inertia must be > 0, or a z spring or damper must act \
                 on an arm"
            ),
        ));
    }
}

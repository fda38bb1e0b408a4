//! The rules of the supports between the ends.

use super::super::beam::BeamMotion;
use super::super::fault::Fault;
use super::super::schema::INNER_SUPPORT;
use super::super::spelling::element_keys;
use super::super::toml_literal::format_number;
use super::super::types::{InnerSupport, Model, Restraint};
use super::{element_names, numbers, support};

/// The rules of the inner supports.
pub(super) fn inner(model: &Model, faults: &mut Vec<Fault>) {
    let list = &model.supports.inner;
    let names = list.iter().map(|inner| inner.name.as_str());
    element_names("supports.inner", &names, faults);
    for (index, (inner, key)) in list.iter().zip(element_keys(names)).enumerate() {
        let path = format!("supports.inner.{key}");
        let mut fault = |key: &str, message: String| {
            faults.push(Fault::new(format!("{path}.{key}"), message));
        };
        if matches!(inner.name.as_str(), "left" | "right") {
            fault(
                "name",
                format!(
                    "{:?} is an end of the beam; must be another name",
                    inner.name
                ),
            );
        }
        if model.subsystems.iter().any(|one| one.name == inner.name) {
            fault(
                "name",
                format!(
                    "{:?} is also a subsystem; must be unique among both",
                    inner.name
                ),
            );
        }
        let length = model.length();
        if inner.position == 0.0 || (length > 0.0 && inner.position >= length) {
            let message = format!(
                "is {}; must be between the ends, > 0 and < {} m (supports.left and supports.right hold those)",
                format_number(inner.position),
                format_number(length)
            );
            fault("position", message);
        }
        if BeamMotion::ALL
            .into_iter()
            .all(|motion| !inner.support[motion].acts())
        {
            let message = "holds nothing and weighs nothing; must fix a motion or have a spring, a damper or a mass";
            faults.push(Fault::new(path.clone(), message));
        }
        let is_here = |of: &&InnerSupport| of.position == inner.position;
        let here: Vec<&InnerSupport> = list[..=index].iter().filter(is_here).collect();
        if here.len() > 1 && fix_twice(&here) {
            let message = format!(
                "is {} m, where {:?} already fixes what it fixes; must be another position",
                format_number(inner.position),
                here[0].name
            );
            faults.push(Fault::new(format!("{path}.position"), message));
        }
        numbers(&path, inner, &INNER_SUPPORT, faults);
        support(&path, &inner.support, faults);
    }
}

/// Whether supports at one position together fix a motion of the section twice: the motions that they fix are not
/// independent.
fn fix_twice(supports: &[&InnerSupport]) -> bool {
    let fixes = |of: &&&InnerSupport, motion| of.support[motion] == Restraint::Fixed;
    let count = |motion| supports.iter().filter(|of| fixes(of, motion)).count();
    let slopes = [BeamMotion::WSlope, BeamMotion::PsiSlope, BeamMotion::VSlope];
    if slopes.into_iter().any(|slope| count(slope) > 1) {
        return true;
    }
    // Each of w and v needs a point of its own; the second point of one of them holds the twist, which is one motion.
    let mut twists = count(BeamMotion::Psi);
    for motion in [BeamMotion::W, BeamMotion::V] {
        let held = supports.iter().filter(|of| fixes(of, motion));
        let mut arms: Vec<_> = held.map(|of| of.support.point.arm(motion)).collect();
        let all = arms.len();
        arms.dedup();
        if arms.len() < all {
            return true;
        }
        twists += all.saturating_sub(1);
    }
    twists > 1
}

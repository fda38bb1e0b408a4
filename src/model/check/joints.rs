//! The rules of the joints.

use super::super::beam::BeamMotion;
use super::super::fault::Fault;
use super::super::schema::{JOINT, link};
use super::super::toml_literal::format_number;
use super::super::types::{Link, Model};
use super::{branches, numbers};

/// The rules of the joints: each inside the beam, alone at its position and not rigid in every motion.
///
/// A link of the rate of twist on a section without warping stiffness is no fault: the section transmits no bimoment, so
/// the link has no effect, and a warping constant can become 0 without an edit of the joints.
pub(super) fn check(model: &Model, faults: &mut Vec<Fault>) {
    let length = model.length();
    for (index, joint) in model.joints.iter().enumerate() {
        let path = format!("joints.{}", index + 1);
        let mut fault = |path: String, message: String| faults.push(Fault::new(path, message));
        if joint.position == 0.0 || (length > 0.0 && joint.position >= length) {
            let message = format!(
                "is {}; must be inside the beam, > 0 and < {} m",
                format_number(joint.position),
                format_number(length)
            );
            fault(format!("{path}.position"), message);
        }
        let before = model.joints[..index].iter();
        if let Some(first) = before
            .clone()
            .position(|one| one.position == joint.position)
        {
            let message = format!(
                "is {} m, where joint {} already is; must be another position",
                format_number(joint.position),
                first + 1
            );
            fault(format!("{path}.position"), message);
        }
        if joint.links.iter().all(|link| *link == Link::Rigid) {
            let message = "is rigid in every motion, so it joins as if there were no cut; a motion must be free or have a table of stiffness, damping, loss_factor and maxwell";
            fault(path.clone(), message.to_owned());
        }
        numbers(&path, joint, &JOINT, faults);
        for motion in BeamMotion::ALL {
            if let Link::Elastic(spring) = &joint[motion] {
                let path = format!("{path}.{}", motion.key());
                numbers(&path, spring, link(motion), faults);
                branches(&path, spring, motion, faults);
            }
        }
    }
}

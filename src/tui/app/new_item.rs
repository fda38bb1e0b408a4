//! New supports, joints and subsystems, and unused names.

use std::f64::consts::PI;

use crate::model::{
    BeamMotion, InnerSupport, Joint, Link, MaxwellBranch, Model, Restraint, Spring, SpringId,
    Subsystem, Support, SupportId,
};

/// A new subsystem's mass as a share of the beam's.
const MASS_SHARE: f64 = 0.05;
/// A new subsystem's damping ratio along y and z.
const DAMPING_RATIO: f64 = 0.01;
/// A new subsystem's arms, m.
const ARM: f64 = 0.2;
/// A new subsystem's half-spacing of the z springs at the beam, m.
const MOUNT: f64 = 0.1;

/// The names of all that has a position of its own: inner supports and subsystems.
pub(crate) fn position_names(model: &Model) -> Vec<&str> {
    let supports = model.supports.inner.iter().map(|one| one.name.as_str());
    let subsystems = model.subsystems.iter().map(|one| one.name.as_str());
    supports.chain(subsystems).collect()
}

/// The names of all responses.
pub(crate) fn response_names(model: &Model) -> Vec<&str> {
    model
        .responses
        .iter()
        .map(|one| one.name.as_str())
        .collect()
}

/// An unused name: the wanted one, or with the next free number at its end.
pub(crate) fn free_name(wanted: &str, taken: &[&str]) -> String {
    if !taken.contains(&wanted) {
        return wanted.to_owned();
    }
    let stem = wanted.trim_end_matches(|c: char| c.is_ascii_digit());
    // `S1` becomes `S2`; a name without a number gets one after a space.
    let stem = if stem.len() < wanted.len() {
        stem.to_owned()
    } else {
        format!("{wanted} ")
    };
    // Of n + 1 numbers, at least one is unused by n names.
    let numbered = |number: usize| format!("{stem}{number}");
    let free = (2..taken.len() + 2)
        .map(numbered)
        .find(|name| !taken.contains(&name.as_str()));
    free.unwrap_or_else(|| numbered(taken.len() + 2))
}

/// A subsystem at mid-span with 5 % of the beam's mass, in resonance at the middle of the sweep.
pub(crate) fn new_subsystem(model: &Model) -> Subsystem {
    let mass = two_digits(MASS_SHARE * model.beam_mass());
    let omega = 2.0 * PI * (model.sweep.from * model.sweep.to).sqrt();
    let stiffness = mass * omega * omega;
    // Two springs share the mass along each axis.
    let spring = Spring {
        stiffness: two_digits(stiffness / 2.0),
        damping: two_digits(DAMPING_RATIO * (stiffness * mass).sqrt()),
        ..Spring::default()
    };
    Subsystem {
        name: free_name("S1", &position_names(model)),
        enabled: true,
        position: model.length() / 2.0,
        mass,
        inertia: two_digits(mass * ARM * ARM),
        y_left: spring.clone(),
        y_right: spring.clone(),
        z_left: spring.clone(),
        z_right: spring,
        arm_left: ARM,
        arm_right: ARM,
        mount_y: MOUNT,
        mount_z: 0.0,
    }
}

/// A Maxwell branch as stiff as the spring parallel to it, with its loss at the middle of the sweep.
pub(crate) fn new_branch(model: &Model, id: SpringId) -> MaxwellBranch {
    const WITHOUT_SPRING: f64 = 1e6;
    let parallel = id.spring(model).map_or(0.0, |spring| spring.stiffness);
    let stiffness = if parallel > 0.0 {
        parallel
    } else {
        WITHOUT_SPRING
    };
    let omega = 2.0 * PI * (model.sweep.from * model.sweep.to).sqrt();
    MaxwellBranch {
        stiffness,
        damping: two_digits(stiffness / omega),
    }
}

/// A bearing in the middle of the longest part of the beam between supports and joints.
pub(crate) fn new_support(model: &Model) -> InnerSupport {
    let mut support = Support::FREE;
    support[BeamMotion::W] = Restraint::Fixed;
    support[BeamMotion::V] = Restraint::Fixed;
    InnerSupport {
        name: free_name("bearing", &position_names(model)),
        position: widest_gap(model),
        support,
    }
}

/// A hinge for bending along y in the middle of the longest part of the beam between supports and joints.
pub(crate) fn new_joint(model: &Model) -> Joint {
    let mut joint = Joint {
        position: widest_gap(model),
        ..Joint::default()
    };
    joint[BeamMotion::WSlope] = Link::Free;
    joint
}

/// The middle of the longest part of the beam between supports and joints, m from the left end.
pub(crate) fn widest_gap(model: &Model) -> f64 {
    let ids = SupportId::all(model);
    let joints = model.joints.iter().map(|joint| joint.position);
    let mut positions: Vec<f64> = ids.map(|id| id.position(model)).chain(joints).collect();
    positions.sort_by(f64::total_cmp);
    let gaps = positions.windows(2);
    let widest = gaps.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
    widest.map_or(model.length() / 2.0, |gap| 0.5 * (gap[0] + gap[1]))
}

fn two_digits(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn free_names_count_on() {
        assert_eq!(free_name("S1", &[]), "S1");
        assert_eq!(free_name("S1", &["S1", "S2"]), "S3");
        assert_eq!(free_name("E_V", &["E_V"]), "E_V 2");
    }
}

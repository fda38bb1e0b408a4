//! What the subsystems do.

use num_complex::Complex64;

use super::MassState;
use super::along::Along;
use crate::model::{Spring, Subsystem};
use crate::solve::attachment::UNKNOWNS;
use crate::solve::plan::Event;

/// The enabled subsystems, in the order of the model.
pub(super) fn masses(along: &Along<'_>) -> Vec<MassState> {
    let attached: Vec<&Subsystem> = along.model.attached().collect();
    // Stations lie by rising place, those at one place in the order of the model.
    let mut order: Vec<usize> = (0..attached.len()).collect();
    order.sort_by(|&a, &b| attached[a].position.total_cmp(&attached[b].position));
    let stations = along.plan.stations.iter().zip(&along.solution.unknowns);
    let attachments = stations.filter_map(|(station, unknowns)| match &station.event {
        Event::Attachment(attachment) => Some((attachment, unknowns)),
        Event::Load(_) | Event::Probe => None,
    });
    let mut states: Vec<(usize, MassState)> = order
        .into_iter()
        .zip(attachments)
        .map(|(index, (attachment, unknowns))| {
            let subsystem = attached[index];
            let [w, psi, v, ..] = along.at(along.spot(subsystem.position)).motion;
            let motion = attachment.motion(along.omega.into(), unknowns, &[w, psi, v]);
            let stretches = stretches(along.omega, subsystem, [motion, [w, psi, v]], unknowns);
            let springs = springs(subsystem);
            let state = MassState {
                name: subsystem.name.clone(),
                position: subsystem.position,
                motion,
                mount: [w, psi, v],
                forces: std::array::from_fn(|spring| {
                    stiffness(along.omega, springs[spring]) * stretches[spring]
                }),
                stretches,
            };
            (index, state)
        })
        .collect();
    states.sort_by_key(|(index, _)| *index);
    states.into_iter().map(|(_, state)| state).collect()
}

/// The four springs: y left, y right, z left, z right.
pub(super) fn springs(subsystem: &Subsystem) -> [Spring; 4] {
    [
        subsystem.y_left,
        subsystem.y_right,
        subsystem.z_left,
        subsystem.z_right,
    ]
}

/// k + i omega c, N/m.
fn stiffness(omega: f64, spring: Spring) -> Complex64 {
    Complex64::new(spring.stiffness, omega * spring.damping)
}

/// The stretches of the four springs, m.
///
/// Either from what moves (`moved`: the mass's y, z, theta and the beam's w, psi, v) or from what the springs carry: of
/// a stiff spring the first, of a soft one the second is a small difference of large numbers.
fn stretches(
    omega: f64,
    subsystem: &Subsystem,
    moved: [[Complex64; 3]; 2],
    unknowns: &[Complex64; UNKNOWNS],
) -> [Complex64; 4] {
    let [[y, z, theta], [w, psi, v]] = moved;
    let across = [y, -w, -subsystem.mount_z * psi];
    let along_z = |arm: f64, mount: f64| [z, arm * theta, -v, -mount * psi];
    let left = along_z(-subsystem.arm_left, -subsystem.mount_y);
    let right = along_z(subsystem.arm_right, subsystem.mount_y);
    let [of_left, of_right, of_z_left, of_z_right] =
        springs(subsystem).map(|spring| stiffness(omega, spring));
    // The unknowns are what the beam does to the mass: the y springs, and the sum and difference of the z springs.
    let [force, sum, difference, _] = *unknowns;
    let y = better(&across, &[-force], of_left + of_right);
    [
        y,
        y,
        better(&left, &[-0.5 * sum, 0.5 * difference], of_z_left),
        better(&right, &[-0.5 * sum, -0.5 * difference], of_z_right),
    ]
}

/// The sum of `lengths`, or that of `forces` over a stiffness: whichever sums smaller terms.
fn better(lengths: &[Complex64], forces: &[Complex64], stiffness: Complex64) -> Complex64 {
    let size = |terms: &[Complex64]| -> f64 { terms.iter().map(|term| term.norm()).sum() };
    if size(forces) < size(lengths) * stiffness.norm() {
        forces.iter().sum::<Complex64>() / stiffness
    } else {
        lengths.iter().sum()
    }
}

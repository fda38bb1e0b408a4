//! What the subsystems do.

use super::MassState;
use super::along::Along;
use crate::model::Subsystem;
use crate::solve::plan::Event;
use crate::solve::solution::MassSolution;
use crate::solve::springs::{springs, stiffness, stretches};

/// The enabled subsystems, in the order of the model.
pub(super) fn masses(along: &Along<'_>) -> Vec<MassState> {
    let attached: Vec<&Subsystem> = along.model.attached().collect();
    // Stations lie by rising place, those at one place in the order of the model.
    let mut order: Vec<usize> = (0..attached.len()).collect();
    order.sort_by(|&a, &b| attached[a].position.total_cmp(&attached[b].position));
    let stations = along.plan.stations.iter().zip(&along.solution.masses);
    let solved = stations.filter(|(station, _)| matches!(station.event, Event::Attachment(_)));
    let mut states: Vec<(usize, MassState)> = order
        .into_iter()
        .zip(solved)
        .map(|(index, (_, solved))| {
            let subsystem = attached[index];
            let [w, psi, v, ..] = along.at(along.spot(subsystem.position)).motion;
            let omega = along.omega.into();
            let MassSolution { forces, motion } = *solved;
            let stretches = stretches(omega, subsystem, [motion, [w, psi, v]], forces);
            let springs = springs(subsystem);
            let state = MassState {
                name: subsystem.name.clone(),
                position: subsystem.position,
                motion,
                mount: [w, psi, v],
                forces: std::array::from_fn(|spring| {
                    stiffness(omega, springs[spring]) * stretches[spring]
                }),
                stretches,
            };
            (index, state)
        })
        .collect();
    states.sort_by_key(|(index, _)| *index);
    states.into_iter().map(|(_, state)| state).collect()
}

//! The power balance: input of the forces, dissipation of dampers and material, flow along the beam.
//!
//! The time average of the power of a force F on a velocity u, both zero to peak, is `1/2 Re(F conj(u))`. A damper c
//! dissipates `1/2 c omega^2 |stretch|^2`, a material with loss factor eta `eta omega` times its mean strain energy
//! (Cremer, Heckl & Petersson, Structure-Borne Sound, 3rd ed. 2005).

use num_complex::Complex64;

use super::along::Along;
use super::{Damper, Input, MassState, Power};
use crate::model::{BeamMotion, Force, Spring, SpringName, SupportId, Target};
use crate::solve::beam_state::BeamState;
use crate::solve::linear::ZERO;

/// All powers; `locals` are the states at the positions of the flow.
pub(super) fn power(along: &Along<'_>, masses: &[MassState], locals: &[BeamState]) -> Power {
    let forces = along.model.forces.iter().enumerate();
    Power {
        inputs: forces
            .filter(|(_, force)| force.enabled)
            .map(|(index, force)| Input {
                force: index,
                power: input(along, masses, force),
            })
            .collect(),
        dampers: [
            of_subsystems(along, masses),
            of_supports(along),
            of_joints(along),
            of_foundation(along),
        ]
        .concat(),
        material: 0.5 * along.omega * along.states.dissipation,
        flow: locals
            .iter()
            .map(|local| flow(along.omega, local))
            .collect(),
    }
}

/// 1/2 Re(F conj(i omega q)), W.
fn mean(omega: f64, force: Complex64, moved: Complex64) -> f64 {
    0.5 * omega * (force * moved.conj()).im
}

fn input(along: &Along<'_>, masses: &[MassState], force: &Force) -> f64 {
    let moved = match &force.target {
        Target::Mass(name, motion) => {
            let state = masses.iter().find(|state| state.name == *name);
            // A checked model has no enabled force on a disabled subsystem.
            state.map_or(ZERO, |state| state.motion[*motion as usize])
        }
        Target::Beam(place, motion) => {
            let position = place.position(along.model.length());
            let axis = along.at(along.spot(position)).motion;
            force.point.motions(&axis)[*motion as usize]
        }
    };
    let value = Complex64::from_polar(force.amplitude, force.phase.to_radians());
    mean(along.omega, value, moved)
}

/// Half the angular frequency times the imaginary part of the dynamic stiffness times |stretch|^2, W; `None` for a spring
/// without a damper and a loss factor.
fn heat(omega: f64, spring: &Spring, stretch: Complex64) -> Option<f64> {
    let loss = spring.dynamic_stiffness(omega.into()).im;
    (loss > 0.0).then(|| 0.5 * omega * loss * stretch.norm_sqr())
}

fn of_subsystems(along: &Along<'_>, masses: &[MassState]) -> Vec<Damper> {
    let mut dampers = Vec::new();
    for (subsystem, state) in along.model.attached().zip(masses) {
        for (name, stretch) in SpringName::ALL.into_iter().zip(state.stretches) {
            let power = heat(along.omega, name.of(subsystem), stretch);
            dampers.extend(power.map(|power| Damper {
                label: format!("{} {}", state.name, name.key()),
                power,
            }));
        }
    }
    dampers
}

/// What the dampers and the loss factors of the foundation dissipate along the beam.
fn of_foundation(along: &Along<'_>) -> Vec<Damper> {
    let is_lossy = |row: usize| {
        let mut beams = along.plan.beams.iter();
        beams.any(|beam| beam.matrices.foundation_at(along.omega.into())[row].im > 0.0)
    };
    let motions = ["w", "psi", "v"].into_iter().enumerate();
    let lossy = motions.filter(|(row, _)| is_lossy(*row));
    let damper = |(row, name): (usize, &str)| Damper {
        label: format!("foundation {name}"),
        power: 0.5 * along.omega * along.states.on_foundation[row],
    };
    lossy.map(damper).collect()
}

fn of_supports(along: &Along<'_>) -> Vec<Damper> {
    let mut dampers = Vec::new();
    for (id, held) in SupportId::all(along.model).zip(along.plan.held(along.model)) {
        let support = id.support(along.model);
        let axis = along.at(along.spot(id.position(along.model))).motion;
        for (motion, moved) in BeamMotion::ALL
            .into_iter()
            .zip(support.point.motions(&axis))
        {
            // Without warping stiffness any spring or damper fixes the rate of twist, without energy.
            let idle = motion == BeamMotion::PsiSlope && held.without_warping;
            let moved = if idle { ZERO } else { moved };
            let power = heat(along.omega, &support[motion].elastic().spring, moved);
            dampers.extend(power.map(|power| Damper {
                label: format!("{} {}", id.name(along.model), motion.key()),
                power,
            }));
        }
    }
    dampers
}

fn of_joints(along: &Along<'_>) -> Vec<Damper> {
    let mut dampers = Vec::new();
    for (index, (station, joined)) in along.plan.joined(along.model).enumerate() {
        let [before, after] = along.sides(station);
        let jumps = joined.jumps(along.omega.into(), [&before, &after]);
        for (motion, jump) in BeamMotion::ALL.into_iter().zip(jumps) {
            let power = joined.spring(motion);
            let power = power.and_then(|spring| heat(along.omega, spring, jump));
            dampers.extend(power.map(|power| Damper {
                label: format!("joint {} {}", index + 1, motion.key()),
                power,
            }));
        }
    }
    dampers
}

fn flow(omega: f64, local: &BeamState) -> f64 {
    let pairs = local.force.iter().zip(&local.motion);
    -pairs
        .map(|(force, moved)| mean(omega, *force, *moved))
        .sum::<f64>()
}

//! The state of the whole beam at one frequency: motions, internal forces and power.
//!
//! `along` reads motions and internal forces at the ends of spans, `power` evaluates the power balance. Everything is
//! a complex amplitude, zero to peak, at `e^{i omega t}`, under all enabled forces with their amplitudes.
//!
//! Sign convention: with the motions q = (w, psi, v, w', psi', v') the internal forces are
//! `p = (S_w, T, S_v, M_w, B, M_v)` with `S_w = -E Iy w'''`, `T = G J psi' - E G0 psi'''`, `S_v = -E Iz v'''`,
//! `M_w = E Iy w''`, `B = E G0 psi''`, `M_v = E Iz v''` (those of Chen & Liu, Mathematics 2022, 10(16), 2849, before
//! Eq. 30, with the signs that follow from the strain energy).
//! The part of the beam left of a position acts on the part right of it with -p, so a force F there makes p jump by -F,
//! and the power that flows in +x is `-1/2 Re sum p_i conj(i omega q_i)`.

mod along;
mod power;

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::beam_state::BeamState;
use super::kernel::Prepared;
use super::plan::Held;
use super::solution::MassSolution;
use super::springs::stretches;
use crate::model::{Checked, Subsystem};
use along::{Along, probed};

/// The state of a model at one frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Operating {
    /// Hz.
    pub frequency: f64,
    /// Distances from the left end, m, ascending. A position between two spans occurs twice: its left and its right
    /// side.
    pub positions: Vec<f64>,
    /// The six motions at each position, in the order of [`BeamMotion::ALL`](crate::model::BeamMotion::ALL): m, rad,
    /// and rad/m for the rate of twist.
    pub motion: [Vec<Complex64>; 6],
    /// The internal forces at each position, conjugate to the motions: `S_w` (N), T (N m), `S_v` (N), `M_w` (N m), B (N
    /// m2), `M_v` (N m).
    pub forces: [Vec<Complex64>; 6],
    /// The enabled subsystems, in the order of the model.
    pub masses: Vec<MassState>,
    /// The forces of each support on the beam along the six motions of its point, the ends first, then the inner supports
    /// in the order of the model: of springs, dampers and inertias together, or the reaction of a fixed motion; N, N m, and
    /// N m2 along the rate of twist.
    pub reactions: Vec<[Complex64; 6]>,
    /// The power balance.
    pub power: Power,
}

/// The state of a subsystem.
#[derive(Debug, Clone, PartialEq)]
pub struct MassState {
    /// The subsystem's name.
    pub name: String,
    /// m from the left end.
    pub position: f64,
    /// Motion (y, z, theta) of the mass, m and rad.
    pub motion: [Complex64; 3],
    /// Motion (w, psi, v) of the beam there, m and rad.
    pub mount: [Complex64; 3],
    /// The displacement of the mass's end of each spring (y left, y right, z left, z right) relative to the beam's, m.
    pub stretches: [Complex64; 4],
    /// `(k + i omega c)` times the stretch, N: each spring and damper exert it on the beam along +y or +z, and the
    /// opposite on the mass.
    pub forces: [Complex64; 4],
}

/// Time averages of power, W.
#[derive(Debug, Clone, PartialEq)]
pub struct Power {
    /// The input power of each enabled force, in the order of the model.
    pub inputs: Vec<Input>,
    /// The dissipation of each damper and each spring with a loss factor: those of the subsystems in the order of the model,
    /// then the supports', the ends first, and the joints'.
    pub dampers: Vec<Damper>,
    /// The dissipation of the beam's material by its loss factor.
    pub material: f64,
    /// The power flow along the beam in +x at each of [`Operating::positions`].
    pub flow: Vec<f64>,
}

/// The power of a force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Input {
    /// Index into the forces of the model.
    pub force: usize,
    /// W; negative if the force extracts power.
    pub power: f64,
}

/// The power that a damper, or a spring with a loss factor, dissipates.
#[derive(Debug, Clone, PartialEq)]
pub struct Damper {
    /// Name of the damper: `S1 y_left`, `left w`.
    pub label: String,
    /// W.
    pub power: f64,
}

impl Power {
    /// The input power of all forces together, W.
    pub fn input(&self) -> f64 {
        self.inputs.iter().map(|input| input.power).sum()
    }

    /// The dissipation of dampers and material together, W.
    pub fn loss(&self) -> f64 {
        self.dampers.iter().map(|damper| damper.power).sum::<f64>() + self.material
    }
}

/// The state of a model at a frequency (Hz, > 0), at `points` (2 or more) equally spaced positions and on both
/// sides of every subsystem and force.
///
/// The waves are those of [`sweep`](super::sweep()). A model without damping exactly at a resonance has no finite
/// solution: its values are not finite.
pub fn operating(model: &Checked, frequency: f64, points: usize) -> Operating {
    let omega = TAU * frequency;
    let bare = model.derived(|model| model.responses.clear());
    let prepared = Prepared::whole(probed(&bare, points));
    let along = Along::new(&bare, &prepared, omega);
    let places = along.places();
    let locals: Vec<BeamState> = places.iter().map(|place| along.at(*place)).collect();
    let masses = masses(&along);
    Operating {
        frequency,
        positions: places.iter().map(|place| place.position).collect(),
        motion: columns(&locals, |local| &local.motion),
        forces: columns(&locals, |local| &local.force),
        reactions: reactions(&along),
        power: power::power(&along, &masses, &locals),
        masses,
    }
}

fn columns(
    locals: &[BeamState],
    of: impl Fn(&BeamState) -> &[Complex64; 6],
) -> [Vec<Complex64>; 6] {
    std::array::from_fn(|row| locals.iter().map(|local| of(local)[row]).collect())
}

/// The enabled subsystems, in the order of the model.
fn masses(along: &Along<'_>) -> Vec<MassState> {
    let stations = along.plan.mass_stations(along.model);
    let attached = along.model.attached().zip(stations);
    let state = |(subsystem, station): (&Subsystem, usize)| {
        let [w, psi, v, ..] = along.at(along.spot(subsystem.position)).motion;
        let omega = along.omega.into();
        let MassSolution { forces, motion } = along.states.masses[station];
        let stretches = stretches(omega, subsystem, [motion, [w, psi, v]], forces);
        let springs = subsystem.springs();
        MassState {
            name: subsystem.name.clone(),
            position: subsystem.position,
            motion,
            mount: [w, psi, v],
            forces: std::array::from_fn(|spring| {
                springs[spring].dynamic_stiffness(omega) * stretches[spring]
            }),
            stretches,
        }
    };
    attached.map(state).collect()
}

/// The forces of each support along the six motions of its point, the ends first.
fn reactions(along: &Along<'_>) -> Vec<[Complex64; 6]> {
    let plan = along.plan;
    let [left, right] = along.ends().map(|spot| along.at(spot));
    let of = |held: &Held, [before, after]: [&BeamState; 2], axis: &[Complex64; 6]| {
        let sides = [&before.force, &after.force];
        held.forces(along.omega.into(), sides, axis)
    };
    let ends = [
        of(&plan.left, [&BeamState::ZERO, &left], &left.motion),
        of(&plan.right, [&right, &BeamState::ZERO], &right.motion),
    ];
    let inner = plan.held_between(along.model).map(|(station, held)| {
        let [before, after] = along.sides(station);
        of(held, [&before, &after], &before.motion)
    });
    ends.into_iter().chain(inner).collect()
}

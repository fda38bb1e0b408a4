//! The values of one solution of a plan where parameters act.

use num_complex::Complex64;

use super::adjoint::Pulled;
use crate::model::{BeamMotion, Model, Restraint, SpringMeasure, Subsystem};
use crate::solve::beam_state::BeamState;
use crate::solve::linear::ZERO;
use crate::solve::plan::{Event, Held, Plan, Station};
use crate::solve::solution::{MassSolution, Solution, SpanWaves};
use crate::solve::springs::stretches;
use crate::solve::waves::{Amplitudes, BeamConstants, Waves};

/// A model laid out, and one frequency.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub(super) model: &'a Model,
    pub(super) plan: &'a Plan,
    /// Station of each enabled subsystem, in the order of the model.
    pub(super) masses: &'a [usize],
    /// rad/s.
    pub(super) omega: Complex64,
}

/// One solution.
#[derive(Debug)]
pub(super) struct Field {
    /// Each support, the ends first.
    pub(super) supports: Vec<SupportField>,
    /// Each joint, in the order of the model.
    pub(super) joints: Vec<JointField>,
    /// The six motions of the left and of the right end of the axis.
    pub(super) ends: [[Complex64; 6]; 2],
    /// The states on both sides of each junction of two uniform parts.
    pub(super) junctions: Vec<[BeamState; 2]>,
    /// The state just inside the right end.
    pub(super) edge: BeamState,
    /// Where `Gamma_0` = 0, the torques around which any warping stiffness makes a boundary layer.
    pub(super) kinks: Kinks,
    /// The enabled subsystems, in the order of the model.
    pub(super) masses: Vec<MassField>,
}

/// The values of one solution at a support.
#[derive(Debug)]
pub(super) struct SupportField {
    /// The six motions of its point.
    pub(super) motion: [Complex64; 6],
    /// The same relative to the ground.
    pub(super) stretch: [Complex64; 6],
    /// The change of these motions with the position of the support, per m.
    pub(super) along: [Complex64; 6],
    /// The twist psi of the beam there.
    pub(super) twist: Complex64,
    /// The forces of the support on the beam along the motions.
    pub(super) forces: [Complex64; 6],
    /// Whether the beam there has no warping stiffness.
    pub(super) without_warping: bool,
}

/// The values of one solution at a joint.
#[derive(Debug)]
pub(super) struct JointField {
    /// The six motions of its left and of its right side.
    pub(super) sides: [[Complex64; 6]; 2],
    /// The jumps of the six motions, right minus left: 0 where it is rigid.
    pub(super) jumps: [Complex64; 6],
    /// The changes of the internal forces along the beam, per m: the mean of both sides.
    pub(super) changes: [Complex64; 6],
}

/// The torques, N m, around which any warping stiffness makes a boundary layer, with the uniform part in which.
#[derive(Debug, Default)]
pub(super) struct Kinks {
    /// The jump of the torque at each position between the ends, or at a joint that of the torque that its twist carries; where
    /// the part ends, the jump of the rate of twist, 1/m.
    pub(super) jumps: Vec<(usize, Complex64)>,
    /// The torque at each end, and on both sides of each support between them, with a fixed rate of twist.
    pub(super) held: Vec<(usize, Complex64)>,
}

/// The values of one solution at a subsystem.
#[derive(Debug)]
pub(super) struct MassField {
    /// y, z, theta of the mass.
    pub(super) motion: [Complex64; 3],
    /// The twist psi of the beam there.
    pub(super) twist: Complex64,
    /// w', psi', v' of the beam there; at a kink the mean of both sides.
    pub(super) slope: [Complex64; 3],
    /// The displacement of the mass's end of each spring (y left, y right, z left, z right) relative to the beam's, m.
    pub(super) stretches: [Complex64; 4],
    /// `(k + i omega c)` times the stretch, N.
    pub(super) forces: [Complex64; 4],
}

/// A solution with the decays of its plan's spans, read at the ends of spans.
#[derive(Clone, Copy)]
pub(super) struct Reader<'a> {
    plan: &'a Plan,
    solution: &'a Solution,
}

impl<'a> Reader<'a> {
    pub(super) fn new(plan: &'a Plan, solution: &'a Solution) -> Self {
        Self { plan, solution }
    }

    /// Just right of the left end of a span.
    pub(super) fn start(&self, span: usize) -> BeamState {
        let SpanWaves { a, b } = &self.solution.spans[span];
        BeamState::new(self.waves(span), a, &self.decayed(span, b))
    }

    /// Just left of the right end of a span, which is the left of its station.
    pub(super) fn end(&self, span: usize) -> BeamState {
        let SpanWaves { a, b } = &self.solution.spans[span];
        BeamState::new(self.waves(span), &self.decayed(span, a), b)
    }

    fn waves(&self, span: usize) -> &'a Waves {
        self.solution.waves_of(self.plan, span)
    }

    fn decayed(&self, span: usize, amplitudes: &Amplitudes) -> Amplitudes {
        let decay = &self.solution.decays[self.plan.spans[span]];
        std::array::from_fn(|wave| amplitudes[wave] * decay[wave])
    }
}

impl Field {
    /// Reads a solution of the setting's plan.
    pub(super) fn new(setting: &Setting<'_>, solution: &Solution) -> Self {
        let reader = Reader::new(setting.plan, solution);
        let edge = reader.end(setting.plan.stations.len());
        let attached = setting.model.attached().zip(setting.masses);
        let masses = attached.map(|(subsystem, &station)| {
            mass(
                setting,
                &reader,
                subsystem,
                (station, solution.masses[station]),
            )
        });
        Self {
            supports: supports(setting, &reader),
            joints: joints(setting, &reader),
            ends: [reader.start(0).motion, edge.motion],
            masses: masses.collect(),
            kinks: Kinks::new(setting, &reader),
            junctions: junctions(setting.plan, &reader),
            edge,
        }
    }

    /// Multiplies the field by a factor.
    pub(super) fn scale(&mut self, by: Complex64) {
        let times = |values: &mut [Complex64]| values.iter_mut().for_each(|value| *value *= by);
        for of in &mut self.supports {
            times(&mut of.motion);
            times(&mut of.stretch);
            times(&mut of.along);
            times(&mut of.forces);
            of.twist *= by;
        }
        for of in &mut self.joints {
            times(of.sides.as_flattened_mut());
            times(&mut of.jumps);
            times(&mut of.changes);
        }
        times(self.ends.as_flattened_mut());
        for state in self.junctions.as_flattened_mut() {
            state.scale(by);
        }
        self.edge.scale(by);
        for (_, torque) in self.kinks.jumps.iter_mut().chain(&mut self.kinks.held) {
            *torque *= by;
        }
        for of in &mut self.masses {
            times(&mut of.motion);
            times(&mut of.slope);
            times(&mut of.stretches);
            times(&mut of.forces);
            of.twist *= by;
        }
    }

    /// Adds to the field of a force between the ends of a spring that force itself and, if the field is that of a stretch of the
    /// spring alone, the stretch, of the mass's end relative to the beam's.
    pub(super) fn strain(&mut self, setting: &Setting<'_>, of: &Pulled, force: Complex64) {
        let beam = setting.plan.beam(setting.masses[of.mass]);
        let mass = &mut self.masses[of.mass];
        if has_kinks(beam) {
            let beside = of.beside.map(|share| share * force);
            let slopes = beam.matrices.slopes([ZERO; 3], beside);
            for (slope, change) in mass.slope.iter_mut().zip(slopes) {
                *slope += change;
            }
        }
        mass.forces[of.spring as usize] += force;
        if of.measure == SpringMeasure::Force {
            mass.stretches[of.spring as usize] += 1.0;
        }
    }
}

impl Kinks {
    fn new(setting: &Setting<'_>, reader: &Reader<'_>) -> Self {
        let (plan, length) = (setting.plan, setting.model.length());
        if !plan.beams.iter().any(BeamConstants::without_warping) {
            return Self::default();
        }
        let stations = &plan.stations;
        let parts = plan.parts();
        let is_thin = |span: usize| plan.beam(span).without_warping();
        let inside = |x: f64| 0.0 < x && x < length;
        let groups = stations.chunk_by(|one, other| one.position == other.position);
        let mut first = 0;
        let fixes = |held: &Held| held.support[BeamMotion::PsiSlope] == Restraint::Fixed;
        let is_held = |group: &[Station]| {
            let mut stations = group.iter();
            stations.any(|of| matches!(&of.event, Event::Support(held) if fixes(held)))
        };
        let (mut jumps, mut held) = (Vec::new(), Vec::new());
        for group in groups {
            let last = first + group.len();
            let is_junction = |of: &Station| matches!(of.event, Event::Junction(_));
            if inside(group[0].position) && group.iter().any(is_junction) {
                let rate = |of: BeamState| of.motion[BeamMotion::PsiSlope as usize];
                let jump = rate(reader.start(last)) - rate(reader.end(first));
                let thin = [first, last].into_iter().filter(|span| is_thin(*span));
                jumps.extend(thin.map(|span| (parts[span], jump)));
            } else if inside(group[0].position) && is_thin(first) {
                if is_held(group) {
                    let [before, after] = [torque(&reader.end(first)), torque(&reader.start(last))];
                    held.extend([before, after].map(|torque| (parts[first], torque)));
                } else {
                    let of_joint =
                        |station: usize| matches!(stations[station].event, Event::Joint(_));
                    let jump = |station: usize| {
                        let (before, after) = (reader.end(station), reader.start(station + 1));
                        if of_joint(station) {
                            // The torque is continuous, but an axial force off the axis takes another share of it.
                            let beam = plan.beam(station);
                            carried(beam, &before) - carried(beam, &after)
                        } else {
                            torque(&after) - torque(&before)
                        }
                    };
                    jumps.push((parts[first], (first..last).map(jump).sum()));
                }
            }
            first = last;
        }
        // Inside of stations at the ends.
        let left = stations.partition_point(|of| of.position <= 0.0);
        let right = stations.partition_point(|of| of.position < length);
        let ends = [
            (&plan.left, left, torque(&reader.start(left))),
            (&plan.right, right, torque(&reader.end(right))),
        ];
        let ends = ends.into_iter();
        let ends = ends.filter(|(end, span, _)| fixes(end) && is_thin(*span));
        held.extend(ends.map(|(_, span, torque)| (parts[span], torque)));
        Self { jumps, held }
    }
}

/// The values of a solution at every support, the ends first.
fn supports(setting: &Setting<'_>, reader: &Reader<'_>) -> Vec<SupportField> {
    let plan = setting.plan;
    let last = plan.stations.len();
    let zero = BeamState::ZERO;
    let left = {
        let inside = reader.start(0);
        support(
            setting,
            &plan.left,
            [&zero, &inside],
            &inside.motion,
            ZERO_SLOPES,
        )
    };
    let edge = reader.end(last);
    let right = support(
        setting,
        &plan.right,
        [&edge, &zero],
        &edge.motion,
        ZERO_SLOPES,
    );
    let inner = plan.held_between(setting.model).map(|(station, held)| {
        let (before, after) = (reader.end(station), reader.start(station + 1));
        let matrices = &plan.beam(station).matrices;
        let [_, _, _, rotations @ ..] = before.motion;
        let slopes = matrices.slopes(rotations, mean_forces(setting, reader, station));
        let moments = |of: &BeamState| [of.force[3], of.force[4], of.force[5]];
        let (one, other) = (moments(&before), moments(&after));
        let curvatures =
            matrices.curvatures(std::array::from_fn(|row| 0.5 * (one[row] + other[row])));
        let [w, psi, v] = slopes;
        let [bend_w, warp, bend_v] = curvatures;
        support(
            setting,
            held,
            [&before, &after],
            &before.motion,
            [w, psi, v, bend_w, warp, bend_v],
        )
    });
    [left, right].into_iter().chain(inner).collect()
}

/// An end does not move along the beam by itself.
const ZERO_SLOPES: [Complex64; 6] = [ZERO; 6];

/// A support, from the states on both sides (zero outside of the beam) and the motions of the axis with their derivatives.
fn support(
    setting: &Setting<'_>,
    held: &Held,
    [before, after]: [&BeamState; 2],
    axis: &[Complex64; 6],
    slopes: [Complex64; 6],
) -> SupportField {
    let point = held.support.point;
    let axis = held.held(axis);
    let sides = [&before.force, &after.force];
    let motion = point.motions(&axis);
    SupportField {
        forces: held.forces(setting.omega, sides, &axis),
        stretch: std::array::from_fn(|row| motion[row] - held.ground[row]),
        motion,
        along: point.motions(&slopes),
        twist: axis[BeamMotion::Psi as usize],
        without_warping: held.without_warping,
    }
}

/// The values of a solution at every joint, in the order of the model.
fn joints(setting: &Setting<'_>, reader: &Reader<'_>) -> Vec<JointField> {
    let (plan, omega) = (setting.plan, setting.omega);
    let joints = plan.joined(setting.model);
    joints
        .map(|(station, joined)| {
            let sides = [reader.end(station), reader.start(station + 1)];
            let [before, after] = sides
                .each_ref()
                .map(|of| (plan.beam(station).matrices).changes(omega, &of.motion, &of.force));
            JointField {
                sides: sides.each_ref().map(|of| of.motion),
                jumps: joined.jumps(omega, sides.each_ref()),
                changes: std::array::from_fn(|row| 0.5 * (before[row] + after[row])),
            }
        })
        .collect()
}

/// The states on both sides of each junction.
fn junctions(plan: &Plan, reader: &Reader<'_>) -> Vec<[BeamState; 2]> {
    let stations = plan.stations.iter().enumerate();
    let junctions = stations.filter(|(_, of)| matches!(of.event, Event::Junction(_)));
    junctions
        .map(|(station, _)| [reader.end(station), reader.start(station + 1)])
        .collect()
}

/// The torque that an axial force off the axis takes by the slopes of w and v, N m.
fn carried(beam: &BeamConstants, local: &BeamState) -> Complex64 {
    let [.., w_slope, _, v_slope] = local.motion;
    let tension = &beam.matrices.tension;
    tension.w_psi * w_slope + tension.psi_v * v_slope
}

fn torque(local: &BeamState) -> Complex64 {
    local.force[BeamMotion::Psi as usize]
}

/// The values of a solution at the subsystem of a station.
fn mass(
    setting: &Setting<'_>,
    reader: &Reader<'_>,
    subsystem: &Subsystem,
    (station, MassSolution { forces, motion }): (usize, MassSolution),
) -> MassField {
    let local = reader.end(station);
    let [w, psi, v, ..] = local.motion;
    let stretches = stretches(setting.omega, subsystem, [motion, [w, psi, v]], forces);
    let springs = subsystem.springs();
    let beam = setting.plan.beam(station);
    let mut slope = [local.motion[3], local.motion[4], local.motion[5]];
    if has_kinks(beam) {
        slope = beam
            .matrices
            .slopes(slope, mean_forces(setting, reader, station));
    }
    MassField {
        motion,
        twist: psi,
        slope,
        forces: std::array::from_fn(|spring| {
            springs[spring].dynamic_stiffness(setting.omega) * stretches[spring]
        }),
        stretches,
    }
}

/// Whether a force or a torque makes a slope jump.
fn has_kinks(beam: &BeamConstants) -> bool {
    beam.without_warping() || beam.matrices.has_shear()
}

/// The mean of the internal forces `S_w`, T, `S_v` on both sides of all stations at the position of a station.
///
/// Without warping stiffness psi has a kink at a torque, and with shear deformation w and v have one at a force: the slope
/// for a force that moves across it is the mean of both sides. At an end a station can only move inwards, past all
/// others there.
fn mean_forces(setting: &Setting<'_>, reader: &Reader<'_>, station: usize) -> [Complex64; 3] {
    let stations = &setting.plan.stations;
    let x = stations[station].position;
    let first = stations.partition_point(|other| other.position < x);
    let last = stations.partition_point(|other| other.position <= x) - 1;
    let forces = [
        reader.end(station),
        reader.start(station + 1),
        reader.end(first),
        reader.start(last + 1),
    ]
    .map(|local| local.force);
    std::array::from_fn(|row| {
        let [own_before, own_after, before, after] = forces.map(|force| force[row]);
        let own = own_after - own_before;
        if x == 0.0 {
            after - 0.5 * own
        } else if x == setting.model.length() {
            before + 0.5 * own
        } else {
            0.5 * (before + after)
        }
    })
}

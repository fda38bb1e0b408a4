//! The loads of the adjoint field of a response.

use num_complex::Complex64;

use crate::model::{
    At, BeamMotion, Measure, Model, Place, Response, SpringMeasure, SpringName, Subsystem,
};
use crate::solve::beam_state::BeamState;
use crate::solve::kernel::Prepared;
use crate::solve::linear::ZERO;
use crate::solve::output::{Holds, Output, Read, Row, Sum};
use crate::solve::plan::{Event, Plan};
use crate::solve::springs::{of_each, rows};

use super::field::Setting;

/// A response, with the frequency-independent data of its derivatives.
#[derive(Debug)]
pub(super) enum Adjoint {
    /// A complex amplitude, and what divides it.
    Sum(Part, Option<Part>),
    /// `E_V`: its adjoint loads follow from the motion.
    Energy,
}

/// A numerator or denominator.
#[derive(Debug)]
pub(super) enum Part {
    /// A sum of rows.
    Sum(Box<Influence>),
    /// A motion that a support fixes, by the index of its response in the model.
    Held(usize),
}

/// The influence of loads on a sum of rows: by reciprocity the state under a unit load along a motion, a unit gap against an
/// internal force, or ground that moves by a unit against a reaction (Mueller-Breslau 1887).
#[derive(Debug)]
pub(super) struct Influence {
    /// The plan in that state, prepared as a whole.
    pub(super) prepared: Prepared,
    pub(super) sum: Sum,
    /// The index of its response in the model.
    pub(super) response: usize,
    /// The jump of this state between the right end, from which the beam grows, and the place just inside, if the load or the gap
    /// stays there while the end moves, or moves with it.
    pub(super) edge: BeamState,
    /// The spring that it is of, if it is of one: the state is that of a unit force at both ends of it.
    pub(super) spring: Option<Pulled>,
}

/// A spring between whose ends a unit force acts.
#[derive(Debug)]
pub(super) struct Pulled {
    /// The index of its subsystem among those attached.
    pub(super) mass: usize,
    pub(super) spring: SpringName,
    pub(super) measure: SpringMeasure,
    /// At an end the mean of the force on both sides of its load on the beam, less that inside: the support takes that load, but
    /// a subsystem that moves takes it along.
    pub(super) beside: [Complex64; 3],
}

impl Pulled {
    /// The force, N, that makes the state that of the response: of the force in the spring it is that of a unit stretch of
    /// the spring alone.
    pub(super) fn pull(&self, setting: Setting<'_>) -> Complex64 {
        match (self.measure, setting.model.attached().nth(self.mass)) {
            (SpringMeasure::Force, Some(subsystem)) => {
                self.spring.of(subsystem).dynamic_stiffness(setting.omega)
            }
            (SpringMeasure::Stretch | SpringMeasure::Force, _) => Complex64::ONE,
        }
    }
}

impl Adjoint {
    /// The adjoints of each enabled response of a model; `masses` are the stations of its attached subsystems.
    pub(super) fn all(model: &Model, plan: &Plan, masses: &[usize]) -> Vec<Self> {
        let bare = without_loads(plan);
        let all = model.responses.iter().enumerate();
        let enabled = all.filter(|(_, of)| of.enabled);
        let part = |index: usize, sum: &Sum| {
            if sum.terms.is_empty() {
                return Part::Held(index);
            }
            Part::Sum(Box::new(Influence::new(model, (&bare, masses), sum, index)))
        };
        let adjoint = |(output, (index, response)): (&Output, (usize, &Response))| match output {
            Output::Energy => Self::Energy,
            Output::Sum(sum, over) => {
                let divisor = |of: &Response| response.over.as_ref() == Some(&of.name);
                let divisor = model.responses.iter().position(divisor);
                let over = over.as_ref().zip(divisor);
                Self::Sum(part(index, sum), over.map(|(sum, index)| part(index, sum)))
            }
        };
        plan.outputs.iter().zip(enabled).map(adjoint).collect()
    }
}

impl Influence {
    fn new(model: &Model, (bare, masses): (&Plan, &[usize]), sum: &Sum, response: usize) -> Self {
        let mut out = Self {
            prepared: Prepared::whole(bare.clone()),
            sum: sum.clone(),
            response,
            edge: BeamState::ZERO,
            spring: None,
        };
        let plan = &mut out.prepared.plan;
        let length = model.length();
        let at = model.responses[response].quantity.at();
        // A place in metres stays where it is while the end moves.
        let stays = matches!(at, Some(At::Beam(Place::Position(x))) if x == length);
        for (factor, read) in &sum.terms {
            let Read { station, row } = bare.reads[*read];
            let factor = Complex64::from(*factor);
            let position = bare.stations[station].position;
            match row {
                Row::Motion(motion, arm) => {
                    let mut load = [ZERO; 6];
                    load[BeamMotion::Psi as usize] = arm * factor;
                    load[motion as usize] = factor;
                    put(plan, station, &load, length);
                    if stays {
                        out.edge.force = load;
                    }
                }
                Row::Force(motion) => {
                    let mut gap = [ZERO; 6];
                    gap[motion as usize] = factor;
                    plan.stations[station].event = Event::Gap(gap);
                    if position == length && !stays {
                        out.edge.motion = gap;
                    }
                }
                Row::Reaction(holds, motion) => {
                    let held = match (holds, &mut plan.stations[station].event) {
                        (Holds::Left, _) => &mut plan.left,
                        (Holds::Right, _) => &mut plan.right,
                        (Holds::Station, Event::Support(held)) => &mut **held,
                        (Holds::Station, _) => continue,
                    };
                    held.ground[motion as usize] = factor;
                    unhold(plan, position);
                }
                // The ground already moves it.
                Row::OnFixed(_) => {}
                Row::Mass(motion) => {
                    if let Event::Attachment(attachment) = &mut plan.stations[station].event {
                        attachment.load[motion as usize] = factor;
                    }
                }
                Row::Spring(spring, measure) => {
                    let index = masses.iter().position(|&mass| mass == station);
                    let Some((index, subsystem)) =
                        index.and_then(|index| Some((index, model.attached().nth(index)?)))
                    else {
                        continue;
                    };
                    let load = pull(plan, (station, subsystem), spring, length);
                    if position == length {
                        out.edge.force = load;
                    }
                    let side = if position == 0.0 {
                        0.5
                    } else if position == length {
                        -0.5
                    } else {
                        0.0
                    };
                    let [w, psi, v, ..] = load;
                    out.spring = Some(Pulled {
                        mass: index,
                        spring,
                        measure,
                        beside: [w, psi, v].map(|force| side * force),
                    });
                }
            }
        }
        out
    }
}

/// Puts a load at a probe; at an end it is part of the equations of the support.
fn put(plan: &mut Plan, station: usize, load: &[Complex64; 6], length: f64) {
    let at = &mut plan.stations[station];
    if at.position == 0.0 {
        plan.left.load = *load;
    } else if at.position == length {
        plan.right.load = *load;
    } else {
        at.event = Event::Load(*load);
    }
}

/// Pulls both ends of a spring by a unit force each, along its stretch; returns the load on the beam.
fn pull(
    plan: &mut Plan,
    (station, subsystem): (usize, &Subsystem),
    spring: SpringName,
    length: f64,
) -> [Complex64; 6] {
    let stretch = &of_each(rows(subsystem))[spring as usize];
    // The rows are those of the mass's end less the beam's.
    if let Event::Attachment(attachment) = &mut plan.stations[station].event {
        attachment.load = stretch.mass.map(|share| (-share).into());
    }
    let mut load = [ZERO; 6];
    for (load, share) in load.iter_mut().zip(stretch.beam) {
        *load = (-share).into();
    }
    let position = plan.stations[station].position;
    let here = plan.stations.iter().enumerate().skip(station);
    let probe = here
        .take_while(|(_, of)| of.position == position)
        .find(|(_, of)| matches!(of.event, Event::Probe));
    if let Some((probe, _)) = probe {
        put(plan, probe, &load, length);
    }
    load
}

/// Lets the subsystems at a place move with the ground there.
fn unhold(plan: &mut Plan, position: f64) {
    for station in &mut plan.stations {
        if let Event::Attachment(attachment) = &mut station.event
            && station.position == position
        {
            attachment.held = [false; 3];
        }
    }
}

/// The plan with all loads at zero and the same stations and spans.
pub(super) fn without_loads(plan: &Plan) -> Plan {
    let mut bare = plan.clone();
    bare.left.load = [ZERO; 6];
    bare.right.load = [ZERO; 6];
    bare.wants_energy = false;
    for station in &mut bare.stations {
        match &mut station.event {
            Event::Attachment(attachment) => attachment.load = [ZERO; 3],
            Event::Support(held) => held.load = [ZERO; 6],
            Event::Joint(_) | Event::Junction(_) => {}
            event @ (Event::Load(_) | Event::Gap(_) | Event::Probe) => *event = Event::Probe,
        }
    }
    bare
}

/// The factor of a measure and its derivative by the angular frequency.
pub(super) fn factor(measure: Measure, omega: Complex64) -> [Complex64; 2] {
    match measure {
        Measure::Displacement => [Complex64::ONE, ZERO],
        Measure::Velocity => [Complex64::I * omega, Complex64::I],
        Measure::Acceleration => [-omega * omega, -2.0 * omega],
    }
}

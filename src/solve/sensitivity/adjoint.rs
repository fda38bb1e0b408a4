//! The loads of the adjoint field of a response.

use num_complex::Complex64;

use crate::model::{BeamMotion, Measure, Model, Place, Quantity, Response, Target};
use crate::solve::kernel::Prepared;
use crate::solve::linear::ZERO;
use crate::solve::output::{Output, Read, Row, Sum};
use crate::solve::plan::{Event, Plan};

/// A response, with the frequency-independent data of its derivatives.
#[derive(Debug)]
pub(super) enum Adjoint {
    /// A sum of rows.
    Sum(Box<Influence>),
    /// A motion that a support fixes, by its index among the enabled responses.
    Held(usize),
    /// `E_V`: its adjoint loads follow from the motion.
    Energy,
}

/// The influence of loads on a response, by reciprocity the state under a unit load along it.
#[derive(Debug)]
pub(super) struct Influence {
    /// The plan under the unit load, prepared as a whole.
    pub(super) prepared: Prepared,
    pub(super) sum: Sum,
    /// The index of the response among the enabled ones.
    pub(super) response: usize,
    /// The unit load, if its position is constant while the right end moves.
    pub(super) held: [Complex64; 6],
}

impl Adjoint {
    /// The adjoints of each enabled response of a model.
    pub(super) fn all(model: &Model, plan: &Plan) -> Vec<Self> {
        let bare = without_loads(plan);
        let responses = model.responses.iter().filter(|response| response.enabled);
        let outputs = plan.outputs.iter().zip(responses).enumerate();
        let adjoint = |(index, (output, response)): (usize, (&Output, &Response))| match output {
            Output::Energy => Self::Energy,
            Output::Sum(sum) if sum.terms.is_empty() => Self::Held(index),
            Output::Sum(sum) => {
                let influence = Influence::new(model, &bare, sum, (index, response));
                Self::Sum(Box::new(influence))
            }
        };
        outputs.map(adjoint).collect()
    }
}

impl Influence {
    fn new(model: &Model, bare: &Plan, sum: &Sum, (index, of): (usize, &Response)) -> Self {
        let mut plan = bare.clone();
        let mut held = [ZERO; 6];
        let stays = matches!(
            of.quantity,
            Quantity::Motion(Target::Beam(Place::Position(x), _), _) if x == model.length()
        );
        for (factor, read) in &sum.terms {
            let Read { station, row } = bare.reads[*read];
            match row {
                Row::Motion(motion, arm) => {
                    let mut load = [ZERO; 6];
                    load[BeamMotion::Psi as usize] = (factor * arm).into();
                    load[motion as usize] = (*factor).into();
                    put(&mut plan, station, &load, model.length());
                    if stays {
                        held = load;
                    }
                }
                Row::Mass(motion) => {
                    if let Event::Attachment(attachment) = &mut plan.stations[station].event {
                        attachment.load[motion as usize] = (*factor).into();
                    }
                }
            }
        }
        Self {
            prepared: Prepared::whole(plan),
            sum: sum.clone(),
            response: index,
            held,
        }
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
            event @ (Event::Load(_) | Event::Probe) => *event = Event::Probe,
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

//! The loads of the adjoint field of a response.

use num_complex::Complex64;

use crate::model::{BeamMotion, Measure, Model, Place, Quantity, Target};
use crate::solve::kernel::Prepared;
use crate::solve::linear::ZERO;
use crate::solve::plan::{Event, Output, Plan};

/// A response, with the frequency-independent data of its derivatives.
#[derive(Debug)]
pub(super) enum Adjoint {
    /// A motion.
    Motion(Box<Motion>),
    /// A motion that a support fixes, by its index among the enabled responses.
    Held(usize),
    /// `E_V`: its adjoint loads follow from the motion.
    Energy,
}

/// A motion of the beam or of a mass.
#[derive(Debug)]
pub(super) struct Motion {
    /// The plan under a unit load along the motion, prepared as a whole.
    pub(super) prepared: Prepared,
    pub(super) measure: Measure,
    /// Its index among the enabled responses.
    pub(super) response: usize,
    /// The position of the motion.
    pub(super) reading: Reading,
    /// The unit load, if its position is constant while the right end moves.
    pub(super) held: [Complex64; 6],
}

/// The position of a motion.
#[derive(Debug, Clone, Copy)]
pub(super) enum Reading {
    /// Of the beam, at a station, plus its twist times an arm, m.
    Beam(usize, BeamMotion, f64),
    /// The mean rate of twist at two stations: see [`Output::MeanTwistRate`].
    MeanTwistRate([usize; 2]),
    /// Of the enabled subsystem with this index, along y, z or theta.
    Mass(usize, usize),
}

impl Adjoint {
    /// The adjoints of each enabled response of a model; `masses` are the stations of its enabled subsystems.
    pub(super) fn all(model: &Model, plan: &Plan, masses: &[usize]) -> Vec<Self> {
        let bare = without_loads(plan);
        let responses = model.responses.iter().filter(|response| response.enabled);
        let outputs = plan.outputs.iter().zip(responses);
        let adjoint = |(index, (output, response)): (usize, (&Output, &crate::model::Response))| {
            let stays = matches!(
                response.quantity,
                Quantity::Motion(Target::Beam(Place::Position(x), _), _) if x == model.length()
            );
            Self::of(model, &bare, masses, (index, *output), stays)
        };
        outputs.enumerate().map(adjoint).collect()
    }

    fn of(
        model: &Model,
        bare: &Plan,
        masses: &[usize],
        (response, output): (usize, Output),
        stays: bool,
    ) -> Self {
        let mut plan = bare.clone();
        let mut held = [ZERO; 6];
        let (reading, measure) = match output {
            Output::Held => return Self::Held(response),
            Output::Energy => return Self::Energy,
            Output::Beam {
                station,
                motion,
                arm,
                measure,
            } => {
                let mut unit = [ZERO; 6];
                unit[BeamMotion::Psi as usize] = arm.into();
                unit[motion as usize] = Complex64::ONE;
                let at = &mut plan.stations[station];
                if at.position == 0.0 {
                    plan.left.load = unit;
                } else if at.position == model.length() {
                    plan.right.load = unit;
                    if stays {
                        held = unit;
                    }
                } else {
                    at.event = Event::Load(unit);
                }
                (Reading::Beam(station, motion, arm), measure)
            }
            // No load gives its derivatives.
            Output::MeanTwistRate { stations, measure } => {
                (Reading::MeanTwistRate(stations), measure)
            }
            Output::Mass {
                station,
                motion,
                measure,
            } => {
                if let Event::Attachment(attachment) = &mut plan.stations[station].event {
                    attachment.load[motion as usize] = Complex64::ONE;
                }
                let index = masses.iter().position(|&mass| mass == station);
                (
                    Reading::Mass(index.unwrap_or_default(), motion as usize),
                    measure,
                )
            }
        };
        Self::Motion(Box::new(Motion {
            prepared: Prepared::whole(plan),
            measure,
            response,
            reading,
            held,
        }))
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

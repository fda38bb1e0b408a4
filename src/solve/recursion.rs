//! The response of a plan at one frequency: a sweep of reflections from left to right, and of amplitudes back.
//!
//! At every point the right-going amplitudes are carried as `a = R b + s`, seen looking left; only decaying
//! exponentials occur, so nothing is lost however long the beam or high the frequency, where a product of transfer
//! matrices loses digits like `exp(2 kappa L)` (Chen & Liu 2022, Eq. 48). Cost and memory are linear in the stations.

use num_complex::Complex64;

use super::attachment::{Channels, UNKNOWNS};
use super::ends::{left_end, right_end};
use super::energy::{SpanEnergy, Sum};
use super::linear::ZERO;
use super::plan::{Event, Output, Plan};
use super::reflection::{
    Amplitudes, Reflection, add_to, decay, decay_in_place, jumps_of_load, radiated, reach,
};
use super::waves::Waves;
use crate::model::{BeamMotion, Measure};

/// What the sweep to the right leaves at a station for the way back.
#[derive(Debug, Clone)]
struct Record {
    /// The reflection just left of the station.
    left: Reflection,
    /// The unknowns of an attachment.
    channels: Option<Channels>,
}

/// What a station adds to the waves, for the b that comes from its right.
struct Crossing {
    /// The unknowns of an attachment.
    unknowns: [Complex64; UNKNOWNS],
    to_right: Amplitudes,
    to_left: Amplitudes,
}

impl Record {
    fn cross(&self, event: &Event, waves: &Waves, b: &Amplitudes) -> Crossing {
        let mut unknowns = [ZERO; UNKNOWNS];
        let (to_right, to_left) = match (event, &self.channels) {
            (Event::Attachment(attachment), Some(channels)) => {
                unknowns = channels.at(b);
                radiated(waves, &attachment.jump(&unknowns), &[ZERO; 3])
            }
            (Event::Load(load), _) => {
                let (force, moment) = jumps_of_load(load);
                radiated(waves, &force, &moment)
            }
            _ => ([ZERO; 6], [ZERO; 6]),
        };
        Crossing {
            unknowns,
            to_right,
            to_left,
        }
    }
}

/// The solution at a station.
#[derive(Debug, Clone)]
struct State {
    /// Amplitudes just left of it.
    a: Amplitudes,
    b: Amplitudes,
    /// The unknowns of an attachment.
    unknowns: [Complex64; UNKNOWNS],
}

/// What is known after the sweep to the right.
struct Known {
    waves: Waves,
    /// The reflection of the left end.
    start: Reflection,
    /// The waves that leave the right end.
    b: Amplitudes,
}

/// The waves in a span: what leaves its left end to the right, and its right end to the left.
#[derive(Debug, Clone)]
pub(super) struct SpanWaves {
    pub(super) a: Amplitudes,
    pub(super) b: Amplitudes,
}

/// The whole solution of a plan at one frequency.
#[derive(Debug, Clone)]
pub(super) struct Solution {
    pub(super) waves: Waves,
    /// exp(-kappa l) of each distinct span.
    pub(super) decays: Vec<Amplitudes>,
    /// Of the span left of each station, and last of the span up to the right end.
    pub(super) spans: Vec<SpanWaves>,
    /// The unknowns of each station that is an attachment; zero of the others.
    pub(super) unknowns: Vec<[Complex64; UNKNOWNS]>,
}

/// Room for one frequency at a time; reused, so that a sweep does not allocate.
#[derive(Debug, Default)]
pub(super) struct Workspace {
    /// exp(-kappa l) of each distinct span.
    decays: Vec<Amplitudes>,
    records: Vec<Record>,
    states: Vec<State>,
}

impl Workspace {
    /// Everything that moves at the angular frequency `omega`, rad/s; not finite where [`Self::solve`] is not.
    pub(super) fn solution(mut self, plan: &Plan, omega: Complex64) -> Solution {
        let Known { waves, start, b } = self.sweep_to_end(plan, omega);
        self.sweep_left(plan, &waves, b, &start);
        let spans = (0..plan.spans.len())
            .map(|span| self.waves_in(plan, &waves, span, &b, &start))
            .collect();
        Solution {
            waves,
            decays: self.decays,
            spans,
            unknowns: self.states.iter().map(|state| state.unknowns).collect(),
        }
    }

    /// The waves of the span left of the station `span`, or of the last one; `last` is b at the right end.
    fn waves_in(
        &self,
        plan: &Plan,
        waves: &Waves,
        span: usize,
        last: &Amplitudes,
        start: &Reflection,
    ) -> SpanWaves {
        let b = self.states.get(span).map_or(*last, |state| state.b);
        let mut arriving = b;
        decay_in_place(&mut arriving, &self.decays[plan.spans[span]]);
        let a = match span.checked_sub(1) {
            None => start.at(&arriving),
            Some(station) => {
                let event = &plan.stations[station].event;
                let crossing = self.records[station].cross(event, waves, &arriving);
                let mut a = self.states[station].a;
                add_to(&mut a, &crossing.to_right);
                a
            }
        };
        SpanWaves { a, b }
    }

    /// Writes the response of every output at the angular frequency `omega` (rad/s; positive, or complex where a zero
    /// or a mode is sought) to `out`. Where the model has no finite answer (no damping, exactly at a resonance) the
    /// values are not finite.
    pub(super) fn solve(&mut self, plan: &Plan, omega: Complex64, out: &mut [Complex64]) {
        let Known { waves, start, b } = self.sweep_to_end(plan, omega);
        let energy = self.sweep_left(plan, &waves, b, &start);
        for (value, output) in out.iter_mut().zip(&plan.outputs) {
            *value = self.read(plan, &waves, omega, *output, energy);
        }
    }

    /// From the left end to the right end, where b comes out.
    fn sweep_to_end(&mut self, plan: &Plan, omega: Complex64) -> Known {
        let waves = Waves::new(&plan.beam, omega);
        self.decays.clear();
        self.decays
            .extend(plan.lengths.iter().map(|&length| decay(&waves, length)));
        let start = left_end(plan, &waves, omega);
        let at_end = self.sweep_right(plan, &waves, omega, start.clone());
        let b = right_end(plan, &waves, omega, &at_end);
        Known { waves, start, b }
    }

    /// Carries the reflection over all stations; what returns is that of the right end.
    fn sweep_right(
        &mut self,
        plan: &Plan,
        waves: &Waves,
        omega: Complex64,
        mut at: Reflection,
    ) -> Reflection {
        self.records.clear();
        for (station, &span) in plan.stations.iter().zip(&plan.spans) {
            at.propagate(&self.decays[span]);
            let left = at.clone();
            let channels = match &station.event {
                Event::Attachment(attachment) => {
                    let contact = at.contact(waves);
                    Some(at.attach(&contact, omega, attachment))
                }
                Event::Load(load) => {
                    at.load(waves, load);
                    None
                }
                Event::Probe => None,
            };
            self.records.push(Record { left, channels });
        }
        at.propagate(&self.decays[plan.last_span()]);
        at
    }

    /// Carries b back to the left end, keeping the state of every station; returns `E_V` where it is wanted.
    fn sweep_left(
        &mut self,
        plan: &Plan,
        waves: &Waves,
        mut b: Amplitudes,
        start: &Reflection,
    ) -> f64 {
        let energy = plan
            .wants_energy
            .then(|| SpanEnergy::vibration(plan, waves, &self.decays));
        let mut sum = Sum::default();
        self.states.clear();
        for (index, station) in plan.stations.iter().enumerate().rev() {
            let span = plan.spans[index + 1];
            let at_span_end = b;
            decay_in_place(&mut b, &self.decays[span]);
            let record = &self.records[index];
            let Crossing {
                unknowns,
                to_right,
                to_left,
            } = record.cross(&station.event, waves, &b);
            add_to(&mut b, &to_left);
            let a = record.left.at(&b);
            if let Some(energy) = &energy {
                let mut at_span_start = a;
                add_to(&mut at_span_start, &to_right);
                sum.add(energy.of(span, &at_span_start, &at_span_end));
            }
            self.states.push(State { a, b, unknowns });
        }
        self.states.reverse();
        if let Some(energy) = &energy {
            let at_span_end = b;
            decay_in_place(&mut b, &self.decays[plan.spans[0]]);
            sum.add(energy.of(plan.spans[0], &start.at(&b), &at_span_end));
        }
        sum.resolved()
    }

    fn read(
        &self,
        plan: &Plan,
        waves: &Waves,
        omega: Complex64,
        output: Output,
        energy: f64,
    ) -> Complex64 {
        match output {
            Output::Held => ZERO,
            Output::Energy => energy.into(),
            Output::Beam {
                station,
                motion,
                measure,
            } => derivative(omega, measure) * beam_motion(waves, motion, &self.states[station]),
            Output::MeanTwistRate { stations, measure } => {
                let rate = |station: usize| {
                    beam_motion(waves, BeamMotion::PsiSlope, &self.states[station])
                };
                let [before, after] = stations.map(rate);
                derivative(omega, measure) * (before + after) * 0.5
            }
            Output::Mass {
                station,
                motion,
                measure,
            } => {
                let state = &self.states[station];
                let q = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V]
                    .map(|m| beam_motion(waves, m, state));
                match &plan.stations[station].event {
                    Event::Attachment(attachment) => {
                        let moved = attachment.motion(omega, &state.unknowns, &q);
                        derivative(omega, measure) * moved[motion as usize]
                    }
                    Event::Load(_) | Event::Probe => ZERO,
                }
            }
        }
    }
}

fn derivative(omega: Complex64, measure: Measure) -> Complex64 {
    match measure {
        Measure::Displacement => Complex64::ONE,
        Measure::Velocity => Complex64::I * omega,
        Measure::Acceleration => -omega * omega,
    }
}

/// A motion of the beam: Q (a + b), or -S (a - b) for a slope.
fn beam_motion(waves: &Waves, motion: BeamMotion, state: &State) -> Complex64 {
    let row = motion as usize;
    let mut sum = ZERO;
    for wave in reach(row % 3) {
        sum += if row < 3 {
            waves.displacement[row][wave] * (state.a[wave] + state.b[wave])
        } else {
            waves.slope[row - 3][wave] * (state.b[wave] - state.a[wave])
        };
    }
    sum
}

//! The whole solution of a plan at one frequency: the kernel with one lane, or at a low frequency its first lane.

use num_complex::Complex64;

use super::complex::Complex;
use super::double_double::DoubleDouble;
use super::ends::{reflection, right_end};
use super::energy::{Form, Sum, Weights, dissipation, weights};
use super::number::Arithmetic;
use super::portable::One;
use super::read::{Part, State};
use super::recursion::{Prepared, Room, times};
use super::reflection::{Amplitudes, Side};
use super::station::{sent, stretches_without};
use super::waves::{Constants, Waves};
use crate::model::MassMotion;
use crate::solve::beam_matrices::Symmetric;
use crate::solve::plan::Event;
use crate::solve::solution::{MassSolution, Solution, SpanWaves, States};
use crate::solve::waves::{self, BeamConstants, WARPING_WAVE};

impl Prepared {
    /// The solution at the angular frequency `omega`, rad/s (positive, or complex in the search for a mode or a zero),
    /// of a plan that is prepared as a [whole](Self::whole). If the model has no finite response (no damping, exactly
    /// at a resonance), the values are not finite.
    pub(in crate::solve) fn solution(&self, omega: Complex64) -> Solution {
        if self.is_low(omega) {
            Whole::<DoubleDouble>::new(self, omega).solution(self)
        } else {
            Whole::<One>::new(self, omega).solution(self)
        }
    }

    /// `E_V` at an angular frequency, rad/s, of a plan that is prepared as a [whole](Self::whole), kg m2 (times the square of
    /// the loads' unit).
    pub(in crate::solve) fn vibration(&self, omega: Complex64) -> f64 {
        if self.is_low(omega) {
            Whole::<DoubleDouble>::new(self, omega).vibration(self)
        } else {
            Whole::<One>::new(self, omega).vibration(self)
        }
    }

    /// The same as motions and internal forces at both ends of each span, and as the states of the subsystems: at low
    /// frequencies these have more digits than sums of rounded waves.
    pub(in crate::solve) fn states(&self, omega: Complex64) -> States {
        if self.is_low(omega) {
            Whole::<DoubleDouble>::new(self, omega).states(self)
        } else {
            Whole::<One>::new(self, omega).states(self)
        }
    }
}

/// The waves of a beam at an angular frequency, rad/s.
pub(in crate::solve) fn waves(beam: &BeamConstants, omega: Complex64) -> waves::Waves {
    let mut waves = Waves::<One>::NONE;
    waves.set(&Constants::new(beam), Complex::splat(omega));
    waves.plain()
}

/// A solved plan, in the kernel's numbers.
struct Whole<A> {
    room: Room<A>,
    /// The waves of each beam.
    all: Vec<Waves<A>>,
    /// The waves of each span: the right-going ones at its left end, and the left-going ones at its right end.
    spans: Vec<[Amplitudes<A>; 2]>,
}

impl<A: Arithmetic> Whole<A> {
    fn new(prepared: &Prepared, omega: Complex64) -> Self {
        let plan = &prepared.plan;
        let last = plan.stations.len();
        let (mut room, mut all) = (Room::default(), Vec::new());
        prepared.set_waves(&mut all, Complex::splat(omega), 0..=last);
        room.make_room(prepared);
        room.prepare_spans(prepared, &all, 0..=last);
        let [first_waves, last_waves] = [0, last].map(|span| prepared.waves_of(&all, span));
        let start = reflection(first_waves, &plan.left, Side::Left);
        let mut at = start.clone();
        room.sweep_right(prepared, &all, 0..last, &mut at);
        at.propagate(&room.decays[plan.last_span()]);
        let mut b = right_end(last_waves, &plan.right, &at);
        let mut spans = Vec::new();
        for index in (0..last).rev() {
            let mut at_span_end = b;
            times(&mut b, &room.decays[plan.spans[index + 1]]);
            let waves = prepared.waves_of(&all, index + 1);
            let a = room.step_left(prepared, &all, (index, true), &mut b);
            times(&mut at_span_end, &waves.radiation);
            spans.extend(a.map(|a| [a, at_span_end]));
        }
        let mut at_span_end = b;
        times(&mut b, &room.decays[plan.spans[0]]);
        times(&mut at_span_end, &first_waves.radiation);
        spans.push([start.at(&b), at_span_end]);
        spans.reverse();
        let mut whole = Self { room, all, spans };
        whole.add_held_forces(prepared);
        whole
    }

    fn solution(&self, prepared: &Prepared) -> Solution {
        let spans = self.spans.iter().map(|[a, b]| SpanWaves {
            a: plain(a),
            b: plain(b),
        });
        let reads = prepared.plan.reads.iter();
        let reads = reads.map(|read| {
            self.room
                .read(prepared, &self.all, *read, Part::Whole)
                .lane(0)
        });
        Solution {
            reads: reads.collect(),
            waves: self.all.iter().map(Waves::plain).collect(),
            decays: self.room.decays.iter().map(plain).collect(),
            spans: spans.collect(),
            masses: self.masses(prepared),
        }
    }

    fn states(&self, prepared: &Prepared) -> States {
        let ends = self.spans.iter().enumerate().map(|(span, [a, b])| {
            let waves = prepared.waves_of(&self.all, span);
            let decay = &self.room.decays[prepared.plan.spans[span]];
            let at_start = [*a, decayed(b, decay)];
            let at_end = [decayed(a, decay), *b];
            [at_start, at_end].map(|[a, b]| {
                State {
                    a,
                    b,
                    ..State::NONE
                }
                .beam(waves)
            })
        });
        States {
            ends: ends.collect(),
            masses: self.masses(prepared),
            dissipation: self.integral(prepared, dissipation),
            on_foundation: [0, 1, 2].map(|row| self.on_foundation(prepared, row)),
        }
    }

    fn vibration(&self, prepared: &Prepared) -> f64 {
        self.integral(prepared, |waves, beam| {
            [weights(waves, &beam.vibration()); 2]
        })
    }

    /// What the foundation dissipates in a radian along w, psi or v, twice: `int Im(K) |q|^2 dx`.
    fn on_foundation(&self, prepared: &Prepared, row: usize) -> f64 {
        let omega = self.all[0].omega.lane(0);
        self.integral(prepared, |waves, beam| {
            let losses = beam.matrices.foundation_at(omega).map(|of| of.im);
            let only = |of: usize| if of == row { losses[of] } else { 0.0 };
            let form = Symmetric {
                w: only(0),
                psi: only(1),
                v: only(2),
                ..Symmetric::<f64>::ZERO
            };
            [weights(waves, &form); 2]
        })
    }

    /// The integral along the beam of the form with some weights of each beam.
    fn integral(
        &self,
        prepared: &Prepared,
        weights: impl Fn(&Waves<A>, &BeamConstants) -> [Weights<A>; 2],
    ) -> f64 {
        let plan = &prepared.plan;
        let beams = self.all.iter().zip(&plan.beams);
        let weights: Vec<_> = beams.map(|(waves, beam)| weights(waves, beam)).collect();
        let kinds = plan.kinds.iter().zip(&self.room.decays);
        let forms = kinds.map(|(kind, decay)| {
            let weights = weights[kind.beam].each_ref();
            Form::new(&self.all[kind.beam], weights, kind.length, decay)
        });
        let forms: Vec<Form<A>> = forms.collect();
        let mut sum = Sum::ZERO;
        for ([a, b], &kind) in self.spans.iter().zip(&plan.spans) {
            forms[kind].of(a, b, &mut sum);
        }
        sum.resolved().lanes()[0]
    }

    fn masses(&self, prepared: &Prepared) -> Vec<MassSolution> {
        let stations = prepared.plan.stations.iter().zip(&self.room.states);
        let masses = stations
            .enumerate()
            .map(|(index, (station, state))| match &station.event {
                Event::Attachment(attachment) => {
                    let waves = prepared.waves_of(&self.all, index);
                    MassSolution {
                        forces: state.forces.map(|force| force.lane(0)),
                        motion: MassMotion::ALL.map(|motion| {
                            state.mass(waves, attachment, motion, Part::Whole).lane(0)
                        }),
                    }
                }
                Event::Support(_)
                | Event::Joint(_)
                | Event::Junction(_)
                | Event::Load(_)
                | Event::Gap(_)
                | Event::Probe => MassSolution::default(),
            });
        masses.collect()
    }

    /// Adds the effect of subsystems at a support on motions that it fixes: it exists only between them and the
    /// support, in spans of the length 0, and the sweep leaves it out.
    fn add_held_forces(&mut self, prepared: &Prepared) {
        let plan = &prepared.plan;
        for (index, station) in plan.stations.iter().enumerate() {
            let Event::Attachment(attachment) = &station.event else {
                continue;
            };
            if attachment.held == [false; 3] {
                continue;
            }
            let waves = prepared.waves_of(&self.all, index);
            let held = stretches_without(waves, attachment, attachment.held.map(|held| !held));
            let mut jump = sent(&held, &self.room.states[index].forces);
            times(&mut jump, &waves.radiation);
            let x = station.position;
            let inner = plan.stations[..index]
                .iter()
                .rposition(|other| other.position == x && matches!(other.event, Event::Support(_)));
            let (outside, is_left) = if let Some(support) = inner {
                (support + 1..index + 1, true)
            } else if x == 0.0 {
                (0..index + 1, true)
            } else {
                (index + 1..self.spans.len(), false)
            };
            for [a, b] in &mut self.spans[outside] {
                let [less, more] = if is_left { [a, b] } else { [b, a] };
                for wave in 0..6 {
                    less[wave] = less[wave] - jump[wave];
                    more[wave] += jump[wave];
                }
            }
        }
    }
}

fn decayed<A: Arithmetic>(amplitudes: &Amplitudes<A>, decay: &Amplitudes<A>) -> Amplitudes<A> {
    let mut out = *amplitudes;
    times(&mut out, decay);
    out
}

impl<A: Arithmetic> Waves<A> {
    /// The values of the first lane.
    fn plain(&self) -> waves::Waves {
        let mut kappa = plain(&self.kappa);
        if self.without_warping {
            kappa[WARPING_WAVE] = f64::INFINITY.into();
        }
        waves::Waves {
            kappa,
            displacement: self.displacement.each_ref().map(plain),
            slope: self.slope.each_ref().map(plain),
            force: self.force.each_ref().map(plain),
            moment: self.moment.each_ref().map(plain),
            all_coupled: self.all_coupled,
        }
    }
}

/// The numbers of the first lane.
fn plain<A: Arithmetic>(amplitudes: &Amplitudes<A>) -> [Complex64; 6] {
    amplitudes.map(|amplitude| amplitude.lane(0))
}

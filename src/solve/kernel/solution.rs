//! The whole solution of a plan at one frequency: the kernel with one lane.

use num_complex::Complex64;

use super::complex::Complex;
use super::ends::{reflection, right_end};
use super::number::Arithmetic;
use super::portable::One;
use super::read::Part;
use super::recursion::{Prepared, Room, times};
use super::reflection::{Amplitudes, Side};
use super::station::{sent, stretches_without};
use super::waves::{Constants, Waves};
use crate::model::MassMotion;
use crate::solve::plan::Event;
use crate::solve::solution::{MassSolution, Solution, SpanWaves};
use crate::solve::waves::{self, BeamConstants, WARPING_WAVE};

impl Prepared {
    /// The solution at the angular frequency `omega`, rad/s (positive, or complex in the search for a mode or a zero),
    /// of a plan that is prepared as a [whole](Self::whole). If the model has no finite response (no damping, exactly
    /// at a resonance), the values are not finite.
    pub(in crate::solve) fn solution(&self, omega: Complex64) -> Solution {
        Room::default().solution(self, Complex::splat(omega))
    }
}

/// The waves of a beam at an angular frequency, rad/s.
pub(in crate::solve) fn waves(beam: &BeamConstants, omega: Complex64) -> waves::Waves {
    let mut waves = Waves::<One>::NONE;
    waves.set(&Constants::new(beam), Complex::splat(omega));
    waves.plain()
}

impl Room<One> {
    fn solution(&mut self, prepared: &Prepared, omega: Complex<One>) -> Solution {
        let plan = &prepared.plan;
        let last = plan.stations.len();
        let mut all = Vec::new();
        prepared.set_waves(&mut all, omega, 0..=last);
        self.make_room(prepared);
        self.prepare_spans(prepared, &all, 0..=last);
        let [first_waves, last_waves] = [0, last].map(|span| prepared.waves_of(&all, span));
        let start = reflection(first_waves, &plan.left, Side::Left);
        let mut at = start.clone();
        self.sweep_right(prepared, &all, 0..last, &mut at);
        at.propagate(&self.decays[plan.last_span()]);
        let mut b = right_end(last_waves, &plan.right, &at);
        let mut spans = Vec::new();
        for index in (0..last).rev() {
            let at_span_end = b;
            times(&mut b, &self.decays[plan.spans[index + 1]]);
            let waves = prepared.waves_of(&all, index + 1);
            let a = self.step_left(prepared, &all, (index, true), &mut b);
            spans.extend(a.map(|a| span_waves(waves, &a, at_span_end)));
        }
        let at_span_end = b;
        times(&mut b, &self.decays[plan.spans[0]]);
        spans.push(span_waves(first_waves, &start.at(&b), at_span_end));
        spans.reverse();
        self.add_held_forces(prepared, &all, &mut spans);
        let stations = plan.stations.iter().zip(&self.states).enumerate();
        let masses = stations.map(|(index, (station, state))| match &station.event {
            Event::Attachment(attachment) => {
                let waves = prepared.waves_of(&all, index);
                MassSolution {
                    forces: state.forces.map(|force| force.lane(0)),
                    motion: MassMotion::ALL
                        .map(|motion| state.mass(waves, attachment, motion, Part::Whole).lane(0)),
                }
            }
            Event::Support(_)
            | Event::Joint(_)
            | Event::Junction(_)
            | Event::Load(_)
            | Event::Gap(_)
            | Event::Probe => MassSolution::default(),
        });
        let reads = plan.reads.iter();
        let reads = reads.map(|read| self.read(prepared, &all, *read, Part::Whole).lane(0));
        Solution {
            reads: reads.collect(),
            waves: all.iter().map(Waves::plain).collect(),
            decays: self.decays.iter().map(plain).collect(),
            spans,
            masses: masses.collect(),
        }
    }

    /// Adds the effect of subsystems at a support on motions that it fixes: it exists only between them and the
    /// support, in spans of the length 0, and the sweep leaves it out.
    fn add_held_forces(&self, prepared: &Prepared, all: &[Waves<One>], spans: &mut [SpanWaves]) {
        let plan = &prepared.plan;
        for (index, station) in plan.stations.iter().enumerate() {
            let Event::Attachment(attachment) = &station.event else {
                continue;
            };
            if attachment.held == [false; 3] {
                continue;
            }
            let waves = prepared.waves_of(all, index);
            let held = stretches_without(waves, attachment, attachment.held.map(|held| !held));
            let mut jump = sent(&held, &self.states[index].forces);
            times(&mut jump, &waves.radiation);
            let x = station.position;
            let inner = plan.stations[..index]
                .iter()
                .rposition(|other| other.position == x && matches!(other.event, Event::Support(_)));
            let (outside, sign) = if let Some(support) = inner {
                (support + 1..index + 1, -1.0)
            } else if x == 0.0 {
                (0..index + 1, -1.0)
            } else {
                (index + 1..spans.len(), 1.0)
            };
            for span in &mut spans[outside] {
                for wave in 0..6 {
                    let jump = sign * jump[wave].lane(0);
                    span.a[wave] += jump;
                    span.b[wave] -= jump;
                }
            }
        }
    }
}

/// The waves of a span from a at its left and b' at its right end.
fn span_waves(waves: &Waves<One>, a: &Amplitudes<One>, mut b: Amplitudes<One>) -> SpanWaves {
    times(&mut b, &waves.radiation);
    SpanWaves {
        a: plain(a),
        b: plain(&b),
    }
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

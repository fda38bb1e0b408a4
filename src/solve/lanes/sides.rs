//! What lies left and right of a part of the beam, at several frequencies at once, kept so that an edit in between need
//! not solve it again.
//!
//! Either side acts on what is between through its reflection alone, and each response on it is an affine function of
//! the six waves that come from there. So a solution with both sides known costs as much as a short beam.

use std::ops::Range;

use super::complex::Complex;
use super::ends::{join, reflection, right_end};
use super::energy::Sum;
use super::number::{Arithmetic, Real};
use super::read::{Part, State};
use super::recursion::{Prepared, Room, add, times};
use super::reflection::{Amplitudes, Jumps, Reflection, Side};
use super::station::{sent, stretches};
use super::waves::Waves;
use crate::solve::plan::Event;

/// A response as a function of six waves.
#[derive(Debug, Clone)]
pub(super) struct Affine<A> {
    from_waves: Amplitudes<A>,
    forced: Complex<A>,
}

/// One side of a part of the beam.
#[derive(Debug, Clone)]
struct Beside<A> {
    /// Seen from the part.
    reflection: Reflection<A>,
    /// What is read on the side, in the order of the plan's outputs.
    outputs: Vec<Affine<A>>,
}

/// Both sides; none where the part reaches to the end of the beam.
#[derive(Debug, Clone)]
pub(in crate::solve) struct Sides<A> {
    left: Option<Beside<A>>,
    right: Option<Beside<A>>,
}

/// Where a response comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::solve) enum Source {
    /// The part between the sides.
    Between,
    /// The left side, and its number among the outputs there.
    Left(usize),
    /// The right side.
    Right(usize),
}

/// A plan whose stations outside of a part are known from before.
#[derive(Debug)]
pub(in crate::solve) struct Between {
    pub(in crate::solve) prepared: Prepared,
    /// The stations of the part.
    pub(in crate::solve) part: Range<usize>,
    /// Where each output comes from.
    pub(in crate::solve) sources: Vec<Source>,
}

impl<A: Arithmetic> Affine<A> {
    const NONE: Self = Self {
        from_waves: [Complex::ZERO; 6],
        forced: Complex::ZERO,
    };

    #[inline(always)]
    fn at(&self, waves: &Amplitudes<A>) -> Complex<A> {
        let mut sum = self.forced;
        for wave in 0..6 {
            sum = sum.plus_product(self.from_waves[wave], waves[wave]);
        }
        sum
    }
}

impl<A> Sides<A> {
    /// Bytes that it takes.
    pub(super) fn bytes(&self) -> usize {
        let outputs = |side: &Option<Beside<A>>| side.as_ref().map_or(0, |side| side.outputs.len());
        size_of::<Self>() + (outputs(&self.left) + outputs(&self.right)) * size_of::<Affine<A>>()
    }
}

impl<A: Arithmetic> Room<A> {
    /// What lies beside the stations of `part`, at the angular frequencies `omega`, rad/s.
    #[inline(always)]
    pub(super) fn sides(&mut self, between: &Between, omega: Real<A>) -> Sides<A> {
        let Between { prepared, part, .. } = between;
        let plan = &prepared.plan;
        let mut waves = Waves::NONE;
        waves.set(&prepared.constants, omega);
        self.make_room(prepared);
        self.prepare_spans(plan, &waves);
        let (mut left, mut right) = (None, None);
        if part.start > 0 {
            let mut at = reflection(&waves, &plan.left, Side::Left);
            self.sweep_right(prepared, &waves, 0..part.start, &mut at);
            let mut beside = Beside::new(at, between, |source| matches!(source, Source::Left(_)));
            for wave in 0..=6 {
                self.carry_left(between, &waves, wave);
                self.collect(between, &waves, wave, &mut beside, |s| {
                    matches!(s, Source::Left(_))
                });
            }
            left = Some(beside);
        }
        if part.end < plan.stations.len() {
            let mut at = reflection(&waves, &plan.right, Side::Right);
            self.sweep_from_right(between, &waves, &mut at);
            let mut beside = Beside::new(at, between, |source| matches!(source, Source::Right(_)));
            for wave in 0..=6 {
                self.carry_right(between, &waves, wave);
                self.collect(between, &waves, wave, &mut beside, |s| {
                    matches!(s, Source::Right(_))
                });
            }
            right = Some(beside);
        }
        Sides { left, right }
    }

    /// Writes the response of every output at the angular frequencies `omega`, rad/s, of a plan whose sides are known.
    #[inline(always)]
    pub(super) fn solve_between(
        &mut self,
        between: &Between,
        sides: &Sides<A>,
        omega: Real<A>,
        out: &mut [Complex<A>],
    ) {
        let Between {
            prepared,
            part,
            sources,
        } = between;
        let plan = &prepared.plan;
        let mut waves = Waves::NONE;
        waves.set(&prepared.constants, omega);
        self.make_room(prepared);
        self.prepare_part(prepared, &waves, part);
        let mut at = match &sides.left {
            Some(left) => left.reflection.clone(),
            None => reflection(&waves, &plan.left, Side::Left),
        };
        self.sweep_right(prepared, &waves, part.clone(), &mut at);
        at.propagate(&self.decays[plan.spans[part.end]]);
        let mut b = match &sides.right {
            Some(right) => join(&waves, &at, &right.reflection),
            None => right_end(&waves, &plan.right, &at),
        };
        let mut a = at.at(&b);
        times(&mut a, &waves.weight);
        let mut none = Sum::ZERO;
        self.sweep_left(prepared, &waves, part.clone(), &mut b, &mut none);
        times(&mut b, &self.decays[plan.spans[part.start]]);
        for ((value, output), source) in out.iter_mut().zip(&plan.outputs).zip(sources) {
            *value = match (source, &sides.left, &sides.right) {
                (Source::Left(index), Some(left), _) => left.outputs[*index].at(&b),
                (Source::Right(index), _, Some(right)) => right.outputs[*index].at(&a),
                _ => self.read(prepared, &waves, *output, Part::Whole),
            };
        }
    }

    /// Carries the reflection that looks right from the right end to the part.
    #[inline(always)]
    fn sweep_from_right(&mut self, between: &Between, waves: &Waves<A>, at: &mut Reflection<A>) {
        let plan = &between.prepared.plan;
        for index in (between.part.end..plan.stations.len()).rev() {
            at.propagate(&self.decays[plan.spans[index + 1]]);
            let read = between.prepared.reads[index];
            match &plan.stations[index].event {
                Event::Attachment(attachment) => {
                    let turn = read.map(|read| &mut self.turns[read]);
                    at.attach(waves, attachment, &mut self.forces[index], turn);
                }
                Event::Load(load) => at.load(waves, &Jumps::of_load(waves, load), Side::Right),
                Event::Probe => {}
            }
            // Seen from just left of the station, where everything is read.
            if let Some(read) = read {
                self.lefts[read].clone_from(at);
            }
        }
    }

    /// The states on the left side for a wave of size 1 that comes from the part; after the last of them for none.
    #[inline(always)]
    fn carry_left(&mut self, between: &Between, waves: &Waves<A>, wave: usize) {
        let mut b = arriving(wave);
        for index in (0..between.part.start).rev() {
            self.carry_over(between, waves, (index, Side::Left), wave, &mut b);
            times(&mut b, &self.decays[between.prepared.plan.spans[index]]);
        }
    }

    /// The same on the right side.
    #[inline(always)]
    fn carry_right(&mut self, between: &Between, waves: &Waves<A>, wave: usize) {
        let plan = &between.prepared.plan;
        let mut a = arriving(wave);
        for index in between.part.end..plan.stations.len() {
            self.carry_over(between, waves, (index, Side::Right), wave, &mut a);
            times(&mut a, &self.decays[plan.spans[index + 1]]);
        }
    }

    /// Carries waves over a station on a side, keeping the state where something is read.
    #[inline(always)]
    fn carry_over(
        &mut self,
        between: &Between,
        waves: &Waves<A>,
        (index, side): (usize, Side),
        wave: usize,
        waves_in: &mut Amplitudes<A>,
    ) {
        let is_forced = wave == 6;
        let mut state = State::NONE;
        let read = between.prepared.reads[index];
        let before = *waves_in;
        match &between.prepared.plan.stations[index].event {
            Event::Attachment(attachment) => {
                state.forces = self.forces[index].part(&before, is_forced);
                if let Some(read) = read {
                    state.theta = self.turns[read].part(&before, is_forced);
                }
                add(
                    waves_in,
                    &sent(&stretches(waves, attachment), &state.forces),
                );
            }
            Event::Load(load) if is_forced => {
                let jumps = Jumps::of_load(waves, load);
                add(waves_in, &jumps.sent(side.other()));
            }
            Event::Load(_) | Event::Probe => {}
        }
        if let Some(read) = read {
            // What is read is what is just left of the station.
            let inwards = if side == Side::Left {
                &*waves_in
            } else {
                &before
            };
            let outwards = self.lefts[read].part(inwards, is_forced);
            let mut inwards = *inwards;
            times(&mut inwards, &waves.radiation);
            (state.a, state.b) = match side {
                Side::Left => (outwards, inwards),
                Side::Right => (inwards, outwards),
            };
            self.states[read] = state;
        }
    }

    /// Takes down what the outputs on a side are for the waves just carried.
    #[inline(always)]
    fn collect(
        &self,
        between: &Between,
        waves: &Waves<A>,
        wave: usize,
        beside: &mut Beside<A>,
        is_there: fn(&Source) -> bool,
    ) {
        let part = if wave == 6 {
            Part::Whole
        } else {
            Part::FromWaves
        };
        let outputs = between.prepared.plan.outputs.iter().zip(&between.sources);
        let mut number = 0;
        for (output, source) in outputs {
            if !is_there(source) {
                continue;
            }
            let value = self.read(&between.prepared, waves, *output, part);
            let affine = &mut beside.outputs[number];
            match wave {
                6 => affine.forced = value,
                wave => affine.from_waves[wave] = value,
            }
            number += 1;
        }
    }
}

impl<A: Arithmetic> Beside<A> {
    fn new(reflection: Reflection<A>, between: &Between, is_there: fn(&Source) -> bool) -> Self {
        let count = between.sources.iter().filter(|s| is_there(s)).count();
        Self {
            reflection,
            outputs: vec![Affine::NONE; count],
        }
    }
}

/// A wave of size 1 alone; none after the last.
#[inline(always)]
fn arriving<A: Arithmetic>(wave: usize) -> Amplitudes<A> {
    let mut out = [Complex::ZERO; 6];
    if wave < 6 {
        out[wave] = Complex::ONE;
    }
    out
}

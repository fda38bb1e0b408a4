//! The responses of a plan at several frequencies at once: reflections to the right end, amplitudes back.

use std::ops::{Range, RangeInclusive};

use num_complex::Complex64;

use super::action::{Acting, Actions};
use super::complex::Complex;
use super::elementary::decay;
use super::ends::{reflection, right_end};
use super::energy::{Form, Sum, Weights, weights};
use super::low::low_limit;
use super::number::{Arithmetic, Real, part};
use super::read::{Part, State, write_outputs};
use super::reflection::{Amplitudes, Jumps, Reflection, Side};
use super::station::{Forces, Turn, Unknowns, sent, stretches};
use super::waves::{Constants, Waves};
use crate::solve::output::Read;
use crate::solve::plan::{Event, Plan, SpanKind};

/// A plan, with the frequency-independent constants of its waves.
#[derive(Debug)]
pub(in crate::solve) struct Prepared {
    pub(in crate::solve) plan: Plan,
    /// Of each of its beams.
    pub(super) constants: Vec<Constants>,
    /// For each station its index among the stations with outputs, if it has any.
    pub(super) reads: Vec<Option<usize>>,
    /// Stations where a response is read.
    read: usize,
    /// Whether a support, a joint or a junction is between the ends.
    has_actions: bool,
    /// The angular frequency, rad/s, below which doubles lose too many digits.
    pub(super) low_limit: f64,
}

impl Prepared {
    /// With outputs where the plan has them.
    pub(in crate::solve) fn new(plan: Plan) -> Self {
        let mut is_read = vec![false; plan.stations.len()];
        for read in &plan.reads {
            is_read[read.station] = true;
        }
        Self::reading(plan, is_read)
    }

    /// With outputs at every station.
    pub(in crate::solve) fn whole(plan: Plan) -> Self {
        let is_read = vec![true; plan.stations.len()];
        Self::reading(plan, is_read)
    }

    fn reading(plan: Plan, is_read: Vec<bool>) -> Self {
        let mut read = 0;
        let number = |is_read: bool| {
            read += usize::from(is_read);
            is_read.then_some(read.wrapping_sub(1))
        };
        let reads = is_read.into_iter().map(number).collect();
        Self {
            constants: plan.beams.iter().map(Constants::new).collect(),
            has_actions: plan.stations.iter().any(|of| match of.event {
                Event::Support(_) | Event::Joint(_) | Event::Junction(_) => true,
                Event::Attachment(_) | Event::Load(_) | Event::Gap(_) | Event::Probe => false,
            }),
            low_limit: low_limit(&plan),
            plan,
            reads,
            read,
        }
    }

    /// With twice the digits at the same frequencies as another plan, whose solved sides have them.
    pub(in crate::solve) fn with_limit_of(self, other: &Plan) -> Self {
        Self {
            low_limit: low_limit(other),
            ..self
        }
    }

    /// Whether an angular frequency, rad/s, needs numbers of twice the digits.
    pub(super) fn is_low(&self, omega: Complex64) -> bool {
        omega.norm_sqr() < self.low_limit * self.low_limit
    }

    /// The waves of a span, among those of each beam: that left of the station with its index.
    #[inline(always)]
    pub(super) fn waves_of<'a, A>(&self, all: &'a [Waves<A>], span: usize) -> &'a Waves<A> {
        &all[self.plan.kinds[self.plan.spans[span]].beam]
    }

    /// Makes the waves of the beams of some spans, at angular frequencies, rad/s.
    #[inline(always)]
    pub(super) fn set_waves<A: Arithmetic>(
        &self,
        all: &mut Vec<Waves<A>>,
        omega: Complex<A>,
        spans: RangeInclusive<usize>,
    ) {
        all.resize(self.constants.len(), Waves::NONE);
        let beam = |span: usize| self.plan.kinds[self.plan.spans[span]].beam;
        for span in spans.clone() {
            let mut earlier = (*spans.start()..span).rev();
            if !earlier.any(|earlier| beam(earlier) == beam(span)) {
                all[beam(span)].set(&self.constants[beam(span)], omega);
            }
        }
    }

    /// Index of the reflection that is stored for a station, if any: see [`Room::lefts`].
    #[inline(always)]
    pub(super) fn kept(&self, station: usize) -> Option<usize> {
        if self.plan.wants_energy {
            Some(station)
        } else {
            self.reads[station]
        }
    }
}

/// Workspace for a few frequencies; reused, so that a sweep does not allocate.
#[derive(Debug)]
pub(super) struct Room<A> {
    /// The waves of each beam.
    pub(super) waves: Vec<Waves<A>>,
    /// exp(-kappa l) of each kind of span.
    pub(super) decays: Vec<Amplitudes<A>>,
    /// The energy of each kind of span, if requested.
    pub(super) forms: Vec<Form<A>>,
    /// The weights of the energy of each beam, where they are known.
    weights: Vec<Option<Weights<A>>>,
    /// Whether a kind of span is prepared.
    is_prepared: Vec<bool>,
    /// The reflection of the left end, if the energy is requested.
    start: Box<Reflection<A>>,
    /// The forces at each station with an attachment.
    pub(super) forces: Vec<Forces<A>>,
    /// The actions of each support between the ends, joint and junction, by its station; empty without any.
    pub(super) actions: Vec<Actions<A>>,
    /// The reflection left of each station with outputs, of every station if the energy is requested; right of a junction.
    pub(super) lefts: Vec<Reflection<A>>,
    /// Theta at each station with outputs and an attachment.
    pub(super) turns: Vec<Turn<A>>,
    /// The solution at each station with outputs.
    pub(super) states: Vec<State<A>>,
    /// The value of each read.
    pub(super) values: Vec<Complex<A>>,
}

impl<A: Arithmetic> Default for Room<A> {
    fn default() -> Self {
        Self {
            waves: Vec::new(),
            decays: Vec::new(),
            forms: Vec::new(),
            weights: Vec::new(),
            is_prepared: Vec::new(),
            start: Box::new(Reflection::NONE),
            forces: Vec::new(),
            actions: Vec::new(),
            lefts: Vec::new(),
            turns: Vec::new(),
            states: Vec::new(),
            values: Vec::new(),
        }
    }
}

impl<A: Arithmetic> Room<A> {
    /// Writes the response of every output at the angular frequencies `omega`, rad/s.
    #[inline(always)]
    pub(super) fn solve(&mut self, prepared: &Prepared, omega: Complex<A>, out: &mut [Complex<A>]) {
        let last = prepared.plan.stations.len();
        let mut all = std::mem::take(&mut self.waves);
        prepared.set_waves(&mut all, omega, 0..=last);
        self.solve_with(prepared, &all, out);
        self.waves = all;
    }

    #[inline(always)]
    fn solve_with(&mut self, prepared: &Prepared, all: &[Waves<A>], out: &mut [Complex<A>]) {
        let plan = &prepared.plan;
        let last = plan.stations.len();
        self.make_room(prepared);
        self.prepare_spans(prepared, all, 0..=last);
        let mut at = reflection(prepared.waves_of(all, 0), &plan.left, Side::Left);
        if plan.wants_energy {
            (*self.start).clone_from(&at);
        }
        self.sweep_right(prepared, all, 0..last, &mut at);
        at.propagate(&self.decays[plan.last_span()]);
        let mut b = right_end(prepared.waves_of(all, last), &plan.right, &at);
        let mut energy = Sum::ZERO;
        self.sweep_left(prepared, all, 0..last, &mut b, &mut energy);
        if plan.wants_energy {
            let start = (*self.start).clone();
            self.cross_span(prepared, all, (0, &start), &mut b, &mut energy);
        }
        self.values.clear();
        for read in &plan.reads {
            let value = self.read(prepared, all, *read, Part::Whole);
            self.values.push(value);
        }
        let omega = prepared.waves_of(all, 0).omega;
        write_outputs(plan, omega, &self.values, energy.resolved(), out);
    }

    /// A row at a station that the sweep has passed.
    #[inline(always)]
    pub(super) fn read(
        &self,
        prepared: &Prepared,
        all: &[Waves<A>],
        Read { station, row }: Read,
        part: Part,
    ) -> Complex<A> {
        let Some(read) = prepared.reads[station] else {
            return Complex::ZERO;
        };
        let waves = prepared.waves_of(all, station);
        self.states[read].row(&prepared.plan, station, waves, row, part)
    }

    #[inline(always)]
    pub(super) fn make_room(&mut self, prepared: &Prepared) {
        let (plan, read) = (&prepared.plan, prepared.read);
        let lefts = if plan.wants_energy {
            plan.stations.len()
        } else {
            read
        };
        self.forces.resize(plan.stations.len(), Forces::NONE);
        if prepared.has_actions {
            self.actions.resize(plan.stations.len(), Actions::NONE);
        }
        self.lefts.resize(lefts, Reflection::NONE);
        self.turns.resize(read, Turn::NONE);
        self.states.resize(read, State::NONE);
    }

    /// Prepares some spans.
    #[inline(always)]
    pub(super) fn prepare_spans(
        &mut self,
        prepared: &Prepared,
        all: &[Waves<A>],
        spans: RangeInclusive<usize>,
    ) {
        let plan = &prepared.plan;
        self.decays.resize(plan.kinds.len(), [Complex::ONE; 6]);
        self.is_prepared.clear();
        self.is_prepared.resize(plan.kinds.len(), false);
        if plan.wants_energy {
            self.forms.resize(plan.kinds.len(), Form::NONE);
        }
        self.weights.resize(plan.beams.len(), None);
        self.weights.fill(None);
        for &kind in &plan.spans[spans] {
            if self.is_prepared[kind] {
                continue;
            }
            self.is_prepared[kind] = true;
            let SpanKind { length, beam } = plan.kinds[kind];
            set_decays(&all[beam], length, &mut self.decays[kind]);
            if plan.wants_energy {
                if self.weights[beam].is_none() {
                    self.weights[beam] = Some(weights(&all[beam], &plan.beams[beam].vibration()));
                }
                if let Some(weights) = &self.weights[beam] {
                    self.forms[kind] =
                        Form::new(&all[beam], [weights; 2], length, &self.decays[kind]);
                }
            }
        }
    }

    /// Moves the left-looking reflection over some stations, each with the span before it.
    #[inline(always)]
    pub(super) fn sweep_right(
        &mut self,
        prepared: &Prepared,
        all: &[Waves<A>],
        stations: Range<usize>,
        at: &mut Reflection<A>,
    ) {
        let plan = &prepared.plan;
        for index in stations {
            at.propagate(&self.decays[plan.spans[index]]);
            if let Some(kept) = prepared.kept(index) {
                self.lefts[kept].clone_from(at);
            }
            self.pass(prepared, all, (index, Side::Left), at);
        }
    }

    /// Moves a reflection that looks to a side over a station.
    #[inline(always)]
    pub(super) fn pass(
        &mut self,
        prepared: &Prepared,
        all: &[Waves<A>],
        (index, side): (usize, Side),
        at: &mut Reflection<A>,
    ) {
        let (here, beyond) = match side {
            Side::Left => (index, index + 1),
            Side::Right => (index + 1, index),
        };
        let waves = prepared.waves_of(all, here);
        let read = prepared.reads[index];
        match &prepared.plan.stations[index].event {
            Event::Attachment(attachment) => {
                let turn = read.map(|read| &mut self.turns[read]);
                let unknowns = Unknowns {
                    forces: &mut self.forces[index],
                    turn,
                    determinant: None,
                };
                at.attach(waves, attachment, unknowns);
            }
            Event::Support(held) => {
                let acting = Acting::Support(held);
                at.act(waves, (acting, side), &mut self.actions[index], None);
            }
            Event::Joint(joined) => {
                let acting = Acting::Joint(joined);
                at.act(waves, (acting, side), &mut self.actions[index], None);
            }
            Event::Junction(_) => {
                let beyond = prepared.waves_of(all, beyond);
                at.cross([waves, beyond], &mut self.actions[index], None);
                if let Some(kept) = prepared.kept(index) {
                    self.lefts[kept].clone_from(at);
                }
            }
            Event::Load(load) => at.load(waves, &Jumps::of_load(waves, load), side),
            Event::Gap(gap) => at.load(waves, &Jumps::of_gap(waves, gap), side),
            Event::Probe => {}
        }
    }

    /// Moves b' back over some stations, each with the span after it, and stores the solution at stations with outputs;
    /// adds the energy of those spans if requested.
    #[inline(always)]
    pub(super) fn sweep_left(
        &mut self,
        prepared: &Prepared,
        all: &[Waves<A>],
        stations: Range<usize>,
        b: &mut Amplitudes<A>,
        energy: &mut Sum<A>,
    ) {
        let plan = &prepared.plan;
        for index in stations.rev() {
            let span = plan.spans[index + 1];
            let at_span_end = *b;
            times(b, &self.decays[span]);
            let at_span_start = self.step_left(prepared, all, (index, plan.wants_energy), b);
            if let Some(a) = at_span_start {
                let waves = prepared.waves_of(all, index + 1);
                self.add_energy(span, waves, &a, &at_span_end, energy);
            }
        }
    }

    /// Moves b' to the left over a station and stores the solution there, if it is read; returns the waves that enter the span
    /// right of it, if they are wanted: then all reflections are stored.
    #[inline(always)]
    pub(super) fn step_left(
        &mut self,
        prepared: &Prepared,
        all: &[Waves<A>],
        (index, is_wanted): (usize, bool),
        b: &mut Amplitudes<A>,
    ) -> Option<Amplitudes<A>> {
        let event = &prepared.plan.stations[index].event;
        let waves = prepared.waves_of(all, index + 1);
        let (kept, read) = (prepared.kept(index), prepared.reads[index]);
        if let Event::Junction(_) = event {
            // Its reflection is that right of it.
            let a = kept
                .filter(|_| is_wanted)
                .map(|kept| self.lefts[kept].at(b));
            self.cross(index, event, waves, b, read);
            return a;
        }
        let sent = self.cross(index, event, waves, b, read);
        let mut a = self.lefts[kept?].at(b);
        if let Some(read) = read {
            let state = &mut self.states[read];
            state.a = a;
            state.b = *b;
            times(&mut state.b, &waves.radiation);
        }
        if !is_wanted {
            return None;
        }
        add_product(&mut a, &sent, &waves.radiation);
        Some(a)
    }

    /// Moves b' to the left over a station; returns what the station sends to the right, before N: a junction nothing.
    #[inline(always)]
    fn cross(
        &mut self,
        index: usize,
        event: &Event,
        waves: &Waves<A>,
        b: &mut Amplitudes<A>,
        read: Option<usize>,
    ) -> Amplitudes<A> {
        match event {
            Event::Attachment(attachment) => {
                let forces = self.forces[index].part(b, true);
                if let Some(read) = read {
                    self.states[read].forces = forces;
                    self.states[read].theta = self.turns[read].part(b, true);
                }
                let sent = sent(&stretches(waves, attachment), &forces);
                add(b, &sent);
                sent
            }
            Event::Support(held) => self.send(index, waves, Acting::Support(held), b, read),
            Event::Joint(joined) => self.send(index, waves, Acting::Joint(joined), b, read),
            Event::Junction(_) => {
                *b = self.actions[index].part(b, true);
                [Complex::ZERO; 6]
            }
            Event::Load(load) => pass_jumps(&Jumps::of_load(waves, load), b),
            Event::Gap(gap) => pass_jumps(&Jumps::of_gap(waves, gap), b),
            Event::Probe => [Complex::ZERO; 6],
        }
    }

    /// The same over a support or joint.
    #[inline(always)]
    fn send(
        &mut self,
        index: usize,
        waves: &Waves<A>,
        acting: Acting<'_>,
        b: &mut Amplitudes<A>,
        read: Option<usize>,
    ) -> Amplitudes<A> {
        let actions = self.actions[index].part(b, true);
        if let Some(read) = read {
            self.states[read].actions = actions;
        }
        pass_jumps(&acting.sent(waves, actions), b)
    }

    /// Moves b' to the left over the span before a station; `start` is the reflection at the other end of the span.
    /// Adds the energy of the span if requested.
    #[inline(always)]
    pub(super) fn cross_span(
        &mut self,
        prepared: &Prepared,
        all: &[Waves<A>],
        (station, start): (usize, &Reflection<A>),
        b: &mut Amplitudes<A>,
        energy: &mut Sum<A>,
    ) {
        let waves = prepared.waves_of(all, station);
        let span = prepared.plan.spans[station];
        let at_span_end = *b;
        times(b, &self.decays[span]);
        if prepared.plan.wants_energy {
            self.add_energy(span, waves, &start.at(b), &at_span_end, energy);
        }
    }

    /// The energy of a span, from a at its left and b' at its right end.
    #[inline(always)]
    fn add_energy(
        &self,
        span: usize,
        waves: &Waves<A>,
        a: &Amplitudes<A>,
        b: &Amplitudes<A>,
        energy: &mut Sum<A>,
    ) {
        let mut amplitudes = *b;
        times(&mut amplitudes, &waves.radiation);
        self.forms[span].of(a, &amplitudes, energy);
    }
}

/// Adds to b' what jumps send to the left; returns what they send to the right.
#[inline(always)]
fn pass_jumps<A: Arithmetic>(jumps: &Jumps<A>, b: &mut Amplitudes<A>) -> Amplitudes<A> {
    add(b, &jumps.sent(Side::Right));
    jumps.sent(Side::Left)
}

/// exp(-kappa l); 1 over the length 0, also for the wave that decays at once.
fn set_decays<A: Arithmetic>(waves: &Waves<A>, length: f64, out: &mut Amplitudes<A>) {
    A::outlined(SetDecays((waves, length, out)));
}

#[inline(always)]
fn set_decays_inlined<A: Arithmetic>((waves, length, out): (&Waves<A>, f64, &mut Amplitudes<A>)) {
    if length == 0.0 {
        *out = [Complex::ONE; 6];
        return;
    }
    let length = Real::splat(length);
    for wave in 0..6 {
        let kappa = waves.kappa[wave].scaled(length);
        out[wave] = decay(kappa.re, kappa.im);
    }
    if waves.without_warping {
        out[crate::solve::waves::WARPING_WAVE] = Complex::ZERO;
    }
}

#[inline(always)]
pub(super) fn times<A: Arithmetic>(to: &mut Amplitudes<A>, by: &Amplitudes<A>) {
    for wave in 0..6 {
        to[wave] = to[wave] * by[wave];
    }
}

#[inline(always)]
pub(super) fn add<A: Arithmetic>(to: &mut Amplitudes<A>, what: &Amplitudes<A>) {
    for wave in 0..6 {
        to[wave] += what[wave];
    }
}

#[inline(always)]
pub(super) fn add_product<A: Arithmetic>(
    to: &mut Amplitudes<A>,
    a: &Amplitudes<A>,
    b: &Amplitudes<A>,
) {
    for wave in 0..6 {
        to[wave] = to[wave].plus_product(a[wave], b[wave]);
    }
}

part!(
    SetDecays ['a, A: Arithmetic] ['a, A]
    (&'a Waves<A>, f64, &'a mut Amplitudes<A>) -> (),
    set_decays_inlined
);

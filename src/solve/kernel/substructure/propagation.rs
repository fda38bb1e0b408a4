//! Propagation over a side of seven cases: each of six waves that come from the part, of size 1 and alone, and the
//! loads of the side; from the part to the end of the beam, with the amplitudes of [`crate::solve::kernel::recursion`].

use super::quadratic_form::{ARRIVALS, Carried, FORCED, QuadraticForm, arriving};
use super::side_energy::SideEnergy;
use super::{Affine, SideResponse, Source, Substructure};
use crate::solve::attachment::Attachment;
use crate::solve::kernel::action::Acting;
use crate::solve::kernel::complex::Complex;
use crate::solve::kernel::number::{Arithmetic, part};
use crate::solve::kernel::read::Part;
use crate::solve::kernel::recursion::{Room, add, add_product, times};
use crate::solve::kernel::reflection::{Jumps, Reflection, Side, entry};
use crate::solve::kernel::station::{CHANNELS, Forces, sent, stretches};
use crate::solve::kernel::waves::Waves;
use crate::solve::plan::Event;

/// A side, the reflection of its end of the beam, and the cases to propagate.
struct Task<'a, A> {
    substructure: &'a Substructure,
    /// The waves of each beam.
    all: &'a [Waves<A>],
    side: Side,
    end: &'a Reflection<A>,
    inwards: Carried<A>,
    /// The rows, if requested.
    reads: Option<&'a mut [Affine<A>]>,
}

/// The response of a station to the arrivals.
struct Crossing<A> {
    /// The forces of the channels, for a subsystem.
    forces: [[Complex<A>; CHANNELS]; ARRIVALS],
    /// The actions of a support or joint.
    actions: [[Complex<A>; 6]; ARRIVALS],
    /// The waves it sends back, before N.
    back: Carried<A>,
}

impl<A: Arithmetic> Room<A> {
    /// Computes the rows and the energy of a side that ends in `end`; its reflection is already known.
    #[inline(always)]
    pub(super) fn carry(
        &mut self,
        substructure: &Substructure,
        all: &[Waves<A>],
        (side, end): (Side, &Reflection<A>),
        beside: &mut SideResponse<A>,
    ) {
        let task = |inwards, reads| Task {
            substructure,
            all,
            side,
            end,
            inwards,
            reads,
        };
        let by_waves = self.carried(task(arriving(), Some(&mut beside.reads)));
        if substructure.prepared.plan.wants_energy {
            let carried = |inwards| self.carried(task(inwards, None));
            beside.energy = Some(Box::new(SideEnergy::new(&by_waves, carried)));
        }
    }

    /// Moves arrivals to the end of a side; returns their energy, if requested.
    fn carried(&mut self, task: Task<'_, A>) -> QuadraticForm<A> {
        A::outlined(Carry((self, task)))
    }

    #[inline(always)]
    fn carried_inlined((this, mut task): (&mut Self, Task<'_, A>)) -> QuadraticForm<A> {
        let (substructure, side) = (task.substructure, task.side);
        let plan = &substructure.prepared.plan;
        let mut energy = QuadraticForm::ZERO;
        let mut crossing = Crossing::NONE;
        let mut outwards = [[Complex::ZERO; 6]; ARRIVALS];
        // The waves that enter the span in the direction of the part.
        let mut entered = outwards;
        let first = substructure.part.end;
        let count = match side {
            Side::Left => substructure.part.start,
            Side::Right => plan.stations.len() - first,
        };
        // For each station its index and those of the spans towards the part and away from it.
        for step in 0..count {
            let (index, before, after) = match side {
                Side::Left => (count - 1 - step, count - step, count - 1 - step),
                Side::Right => (first + step, first + step, first + step + 1),
            };
            this.carry_over(&mut task, index, &mut crossing, &mut outwards);
            if step > 0 && plan.wants_energy {
                energy.add(&this.forms[plan.spans[before]], &outwards, &entered);
            }
            let decay = &this.decays[plan.spans[after]];
            let waves = substructure.prepared.waves_of(task.all, after);
            for arrival in 0..ARRIVALS {
                for wave in 0..6 {
                    let inwards = task.inwards[arrival][wave];
                    entered[arrival][wave] = inwards * waves.radiation[wave];
                    task.inwards[arrival][wave] = inwards * decay[wave];
                }
            }
        }
        if plan.wants_energy {
            let last = if side == Side::Left {
                plan.spans[0]
            } else {
                plan.last_span()
            };
            returned(task.end, &task.inwards, &mut outwards);
            energy.add(&this.forms[last], &outwards, &entered);
        }
        energy
    }

    /// Moves the arrivals over a station and stores the rows there; writes the waves that return to the span
    /// towards the part, if the energy is requested.
    #[inline(always)]
    fn carry_over(
        &mut self,
        task: &mut Task<'_, A>,
        index: usize,
        crossing: &mut Crossing<A>,
        outwards: &mut Carried<A>,
    ) {
        let prepared = &task.substructure.prepared;
        let waves = prepared.waves_of(task.all, index);
        let before = task.inwards;
        self.cross_all(task, index, crossing);
        let Some(kept) = prepared.kept(index) else {
            return;
        };
        if matches!(prepared.plan.stations[index].event, Event::Junction(_)) {
            returned(&self.lefts[kept], &before, outwards);
            return;
        }
        // The reflection is stored, and the state read, just left of the station.
        let there = match task.side {
            Side::Left => &task.inwards,
            Side::Right => &before,
        };
        returned(&self.lefts[kept], there, outwards);
        if let (Some(read), Some(reads)) = (prepared.reads[index], &mut task.reads) {
            for arrival in 0..ARRIVALS {
                let state = &mut self.states[read];
                let mut inwards = there[arrival];
                times(&mut inwards, &waves.radiation);
                (state.a, state.b) = match task.side {
                    Side::Left => (outwards[arrival], inwards),
                    Side::Right => (inwards, outwards[arrival]),
                };
                state.forces = crossing.forces[arrival];
                state.actions = crossing.actions[arrival];
                state.theta = self.turns[read].part(&before[arrival], arrival == FORCED);
                self.collect(task.substructure, task.all, (index, arrival), reads);
            }
        }
        if task.side == Side::Left {
            for arrival in 0..ARRIVALS {
                let back = &crossing.back[arrival];
                add_product(&mut outwards[arrival], back, &waves.radiation);
            }
        }
    }

    /// Moves the arrivals over a station.
    #[inline(always)]
    fn cross_all(&self, task: &mut Task<'_, A>, index: usize, crossing: &mut Crossing<A>) {
        let waves = task.substructure.prepared.waves_of(task.all, index);
        match &task.substructure.prepared.plan.stations[index].event {
            Event::Attachment(attachment) => {
                let forces = &self.forces[index];
                crossing.attachment(waves, attachment, forces, &mut task.inwards);
            }
            Event::Support(held) => self.send_all(task, index, Acting::Support(held), crossing),
            Event::Joint(joined) => self.send_all(task, index, Acting::Joint(joined), crossing),
            Event::Junction(_) => {
                *crossing = Crossing::NONE;
                for arrival in 0..ARRIVALS {
                    let inwards = &mut task.inwards[arrival];
                    *inwards = self.actions[index].part(inwards, arrival == FORCED);
                }
            }
            Event::Load(load) => crossing.jumps(&Jumps::of_load(waves, load), task),
            Event::Gap(gap) => crossing.jumps(&Jumps::of_gap(waves, gap), task),
            Event::Probe => *crossing = Crossing::NONE,
        }
    }

    /// Moves the arrivals over a support or joint.
    #[inline(always)]
    fn send_all(
        &self,
        task: &mut Task<'_, A>,
        index: usize,
        acting: Acting<'_>,
        crossing: &mut Crossing<A>,
    ) {
        *crossing = Crossing::NONE;
        let waves = task.substructure.prepared.waves_of(task.all, index);
        for arrival in 0..ARRIVALS {
            let inwards = &mut task.inwards[arrival];
            let actions = self.actions[index].part(inwards, arrival == FORCED);
            crossing.actions[arrival] = actions;
            let jumps = acting.sent(waves, actions);
            crossing.back[arrival] = jumps.sent(task.side);
            add(inwards, &jumps.sent(task.side.other()));
        }
    }

    /// Stores the rows at a station for the arrivals that just passed it.
    #[inline(always)]
    fn collect(
        &self,
        substructure: &Substructure,
        all: &[Waves<A>],
        (index, arrival): (usize, usize),
        reads: &mut [Affine<A>],
    ) {
        let part = if arrival == FORCED {
            Part::Whole
        } else {
            Part::FromWaves
        };
        for read in substructure.read_at(index) {
            let (Source::Left(number) | Source::Right(number)) = substructure.sources[read] else {
                continue;
            };
            let wanted = substructure.prepared.plan.reads[read];
            let value = self.read(&substructure.prepared, all, wanted, part);
            let affine = &mut reads[number];
            match arrival {
                FORCED => affine.forced = value,
                wave => affine.from_waves[wave] = value,
            }
        }
    }
}

impl<A: Arithmetic> Crossing<A> {
    const NONE: Self = Self {
        forces: [[Complex::ZERO; CHANNELS]; ARRIVALS],
        actions: [[Complex::ZERO; 6]; ARRIVALS],
        back: [[Complex::ZERO; 6]; ARRIVALS],
    };

    /// For jumps, which only the loads of the side make.
    #[inline(always)]
    fn jumps(&mut self, jumps: &Jumps<A>, task: &mut Task<'_, A>) {
        *self = Self::NONE;
        self.back[FORCED] = jumps.sent(task.side);
        add(&mut task.inwards[FORCED], &jumps.sent(task.side.other()));
    }

    /// For a subsystem; moves its arrivals over it.
    fn attachment(
        &mut self,
        waves: &Waves<A>,
        attachment: &Attachment,
        forces: &Forces<A>,
        inwards: &mut Carried<A>,
    ) {
        A::outlined(Attached((self, waves, attachment, forces, inwards)));
    }

    #[inline(always)]
    fn attachment_inlined(
        (this, waves, attachment, forces, inwards): (
            &mut Self,
            &Waves<A>,
            &Attachment,
            &Forces<A>,
            &mut Carried<A>,
        ),
    ) {
        let stretches = stretches(waves, attachment);
        for arrival in 0..ARRIVALS {
            this.forces[arrival] = forces.part(&inwards[arrival], arrival == FORCED);
            this.back[arrival] = sent(&stretches, &this.forces[arrival]);
            add(&mut inwards[arrival], &this.back[arrival]);
        }
    }
}

/// The reflection of each arrival.
fn returned<A: Arithmetic>(at: &Reflection<A>, inwards: &Carried<A>, outwards: &mut Carried<A>) {
    A::outlined(Returned((at, inwards, outwards)));
}

#[inline(always)]
fn returned_inlined<A: Arithmetic>(
    (at, inwards, outwards): (&Reflection<A>, &Carried<A>, &mut Carried<A>),
) {
    for arrival in 0..ARRIVALS {
        let b = &inwards[arrival];
        for row in 0..6 {
            let mut sum = if arrival == FORCED {
                at.s[row]
            } else {
                Complex::ZERO
            };
            for column in 0..6 {
                sum = sum.plus_product(at.r[entry(row, column)], b[column]);
            }
            outwards[arrival][row] = sum;
        }
    }
}

part!(
    Carry ['a, A: Arithmetic] ['a, A]
    (&'a mut Room<A>, Task<'a, A>) -> QuadraticForm<A>,
    Room::carried_inlined
);

part!(
    Attached ['a, A: Arithmetic] ['a, A]
    (&'a mut Crossing<A>, &'a Waves<A>, &'a Attachment, &'a Forces<A>, &'a mut Carried<A>) -> (),
    Crossing::attachment_inlined
);

part!(
    Returned ['a, A: Arithmetic] ['a, A]
    (&'a Reflection<A>, &'a Carried<A>, &'a mut Carried<A>) -> (),
    returned_inlined
);

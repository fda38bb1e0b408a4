//! A part of the beam between two solved sides, at several frequencies at once: the sides are cached, so that an edit
//! of the part does not need to solve them again.
//!
//! Each side acts on the part only through its reflection. Each response on a side is an affine function of the six
//! waves that enter it, and its energy a quadratic one. So a solution with both sides known costs as much as a short
//! beam. A side includes the spans between its stations and up to its end of the beam; the span between its last
//! station and the part belongs to the part, whose edits change its length.
//!
//! `propagation` moves waves over a side; `side_energy` and `quadratic_form` compute its energy.

mod propagation;
mod quadratic_form;
mod side_energy;

use std::ops::Range;

use crate::solve::kernel::complex::Complex;
use crate::solve::kernel::ends::{join, reflection, right_end};
use crate::solve::kernel::energy::Sum;
use crate::solve::kernel::number::Arithmetic;
use crate::solve::kernel::read::{Part, write_outputs};
use crate::solve::kernel::recursion::{Prepared, Room, times};
use crate::solve::kernel::reflection::{Amplitudes, Reflection, Side};
use crate::solve::kernel::waves::Waves;
use side_energy::SideEnergy;

/// A row as a function of six waves.
#[derive(Debug, Clone)]
struct Affine<A> {
    from_waves: Amplitudes<A>,
    forced: Complex<A>,
}

/// One side of a part of the beam.
#[derive(Debug, Clone)]
struct SideResponse<A> {
    /// Looking from the part.
    reflection: Reflection<A>,
    /// The rows on the side, in the order of the plan's reads.
    reads: Vec<Affine<A>>,
    /// The energy of the side, if requested.
    energy: Option<Box<SideEnergy<A>>>,
}

/// Both sides; `None` if the part extends to the end of the beam.
#[derive(Debug, Clone)]
pub(in crate::solve) struct Sides<A> {
    left: Option<SideResponse<A>>,
    right: Option<SideResponse<A>>,
}

/// The source of a read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::solve) enum Source {
    /// The part between the sides.
    Substructure,
    /// The left side, and the index among its reads.
    Left(usize),
    /// The right side, and the index among its reads.
    Right(usize),
}

/// A plan with a part between two solved sides.
#[derive(Debug)]
pub(in crate::solve) struct Substructure {
    pub(in crate::solve) prepared: Prepared,
    /// The stations of the part.
    pub(in crate::solve) part: Range<usize>,
    /// The source of each read.
    pub(in crate::solve) sources: Vec<Source>,
    /// The station and the index of each read, by ascending station.
    pub(in crate::solve) by_station: Vec<(usize, usize)>,
}

impl Substructure {
    /// The indices of the reads at a station.
    pub(in crate::solve::kernel) fn read_at(&self, station: usize) -> impl Iterator<Item = usize> {
        let first = self.by_station.partition_point(|(at, _)| *at < station);
        let from_there = self.by_station[first..].iter();
        from_there
            .take_while(move |(at, _)| *at == station)
            .map(|(_, read)| *read)
    }
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
    /// Size in bytes.
    pub(in crate::solve::kernel) fn bytes(&self) -> usize {
        let sides = [&self.left, &self.right].into_iter().flatten();
        size_of::<Self>() + sides.map(SideResponse::bytes).sum::<usize>()
    }
}

impl<A> SideResponse<A> {
    /// Size of its heap memory, bytes.
    fn bytes(&self) -> usize {
        let energy = self.energy.iter().map(|energy| size_of_val(&**energy));
        size_of_val(&*self.reads) + energy.sum::<usize>()
    }
}

impl<A: Arithmetic> Room<A> {
    /// Solves the sides of `part`, at the angular frequencies `omega`, rad/s.
    #[inline(always)]
    pub(in crate::solve::kernel) fn sides(
        &mut self,
        substructure: &Substructure,
        omega: Complex<A>,
    ) -> Sides<A> {
        let Substructure { prepared, part, .. } = substructure;
        let plan = &prepared.plan;
        let last = plan.stations.len();
        let mut all = std::mem::take(&mut self.waves);
        prepared.set_waves(&mut all, omega, 0..=last);
        self.make_room(prepared);
        self.prepare_spans(prepared, &all, 0..=last);
        let (mut left, mut right) = (None, None);
        if part.start > 0 {
            let end = reflection(prepared.waves_of(&all, 0), &plan.left, Side::Left);
            let mut at = end.clone();
            self.sweep_right(prepared, &all, 0..part.start, &mut at);
            let mut beside =
                SideResponse::new(at, substructure, |source| matches!(source, Source::Left(_)));
            self.carry(substructure, &all, (Side::Left, &end), &mut beside);
            left = Some(beside);
        }
        if part.end < plan.stations.len() {
            let end = reflection(prepared.waves_of(&all, last), &plan.right, Side::Right);
            let mut at = end.clone();
            self.sweep_from_right(substructure, &all, &mut at);
            let mut beside = SideResponse::new(at, substructure, |source| {
                matches!(source, Source::Right(_))
            });
            self.carry(substructure, &all, (Side::Right, &end), &mut beside);
            right = Some(beside);
        }
        self.waves = all;
        Sides { left, right }
    }

    /// Moves the right-looking reflection from the right end to the part.
    #[inline(always)]
    fn sweep_from_right(
        &mut self,
        substructure: &Substructure,
        all: &[Waves<A>],
        at: &mut Reflection<A>,
    ) {
        let prepared = &substructure.prepared;
        let plan = &prepared.plan;
        for index in (substructure.part.end..plan.stations.len()).rev() {
            at.propagate(&self.decays[plan.spans[index + 1]]);
            self.pass(prepared, all, (index, Side::Right), at);
            // Looking from just left of the station, where everything is read.
            if let Some(kept) = prepared.kept(index) {
                self.lefts[kept].clone_from(at);
            }
        }
    }

    /// Writes the response of every output at the angular frequencies `omega`, rad/s, of a plan with solved sides.
    #[inline(always)]
    pub(in crate::solve::kernel) fn solve_substructure(
        &mut self,
        substructure: &Substructure,
        sides: &Sides<A>,
        omega: Complex<A>,
        out: &mut [Complex<A>],
    ) {
        let Substructure { prepared, part, .. } = substructure;
        let plan = &prepared.plan;
        let mut all = std::mem::take(&mut self.waves);
        prepared.set_waves(&mut all, omega, part.start..=part.end);
        self.make_room(prepared);
        self.prepare_spans(prepared, &all, part.start..=part.end);
        let [first, last] = [part.start, part.end].map(|span| prepared.waves_of(&all, span));
        let start = match &sides.left {
            Some(left) => left.reflection.clone(),
            None => reflection(first, &plan.left, Side::Left),
        };
        let mut at = start.clone();
        self.sweep_right(prepared, &all, part.clone(), &mut at);
        at.propagate(&self.decays[plan.spans[part.end]]);
        let mut b = match &sides.right {
            Some(right) => join(last, &at, &right.reflection),
            None => right_end(last, &plan.right, &at),
        };
        let mut a = at.at(&b);
        times(&mut a, &last.weight);
        let mut energy = Sum::ZERO;
        self.sweep_left(prepared, &all, part.clone(), &mut b, &mut energy);
        self.cross_span(prepared, &all, (part.start, &start), &mut b, &mut energy);
        for (side, arriving) in [(&sides.left, &b), (&sides.right, &a)] {
            if let Some(known) = side.as_ref().and_then(|side| side.energy.as_deref()) {
                known.at(arriving, &mut energy);
            }
        }
        self.values.clear();
        for (read, source) in plan.reads.iter().zip(&substructure.sources) {
            let value = match (source, &sides.left, &sides.right) {
                (Source::Left(index), Some(left), _) => left.reads[*index].at(&b),
                (Source::Right(index), _, Some(right)) => right.reads[*index].at(&a),
                _ => self.read(prepared, &all, *read, Part::Whole),
            };
            self.values.push(value);
        }
        write_outputs(plan, first.omega, &self.values, energy.resolved(), out);
        self.waves = all;
    }
}

impl<A: Arithmetic> SideResponse<A> {
    fn new(
        reflection: Reflection<A>,
        substructure: &Substructure,
        is_there: fn(&Source) -> bool,
    ) -> Self {
        let count = substructure.sources.iter().filter(|s| is_there(s)).count();
        Self {
            reflection,
            reads: vec![Affine::NONE; count],
            energy: None,
        }
    }
}

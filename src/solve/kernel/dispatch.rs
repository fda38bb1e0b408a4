//! Selection of the instruction set of the kernel at run time, and of its numbers for each frequency.

use std::ops::Range;
use std::slice::Iter;

use num_complex::Complex64;

use super::complex::Complex;
use super::double_double::DoubleDouble;
use super::number::{Arithmetic, MOST_LANES, part};
use super::portable::Portable;
use super::recursion::{Prepared, Room};
use super::substructure::{Sides, Substructure};
#[cfg(target_arch = "x86_64")]
use super::vectors::{Avx2, Avx512};
use crate::solve::linear::Magnified;

/// Instruction sets for which the kernel is compiled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Instructions {
    /// Vectors of 512 bits: eight frequencies at once.
    #[cfg(target_arch = "x86_64")]
    Avx512,
    /// Vectors of 256 bits and fused multiply-add: four.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// The instructions of every processor: four, with the vectors of the compilation target.
    Portable,
}

impl Instructions {
    /// Those of this processor, the fastest first.
    pub fn available() -> Vec<Self> {
        let mut all = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            if Avx512::is_there() {
                all.push(Self::Avx512);
            }
            if Avx2::is_there() {
                all.push(Self::Avx2);
            }
        }
        all.push(Self::Portable);
        all
    }
}

/// A workspace for one thread, with its instruction set.
#[derive(Debug)]
pub(in crate::solve) struct Solver {
    vectors: Vectors,
    low: Bench<DoubleDouble>,
}

/// The workspace for all frequencies but low ones.
#[derive(Debug)]
enum Vectors {
    #[cfg(target_arch = "x86_64")]
    Avx512(Bench<Avx512>),
    #[cfg(target_arch = "x86_64")]
    Avx2(Bench<Avx2>),
    Portable(Bench<Portable>),
}

/// The sides of a part of the beam at up to [`MOST_LANES`] consecutive frequencies, for each group that is solved at once.
#[derive(Debug, Clone)]
pub(in crate::solve) struct SideBatch(Vec<GroupSides>);

/// The sides of a group, in the arithmetic that solved them.
#[derive(Debug, Clone)]
pub(in crate::solve) enum GroupSides {
    #[cfg(target_arch = "x86_64")]
    Avx512(Box<Sides<Avx512>>),
    #[cfg(target_arch = "x86_64")]
    Avx2(Box<Sides<Avx2>>),
    Portable(Box<Sides<Portable>>),
    DoubleDouble(Box<Sides<DoubleDouble>>),
}

/// The same expression for each variant of [`Vectors`].
macro_rules! for_each {
    ($value:expr, $name:ident => $do:expr) => {
        match $value {
            #[cfg(target_arch = "x86_64")]
            Vectors::Avx512($name) => $do,
            #[cfg(target_arch = "x86_64")]
            Vectors::Avx2($name) => $do,
            Vectors::Portable($name) => $do,
        }
    };
}

/// Workspace and outputs.
#[derive(Debug)]
pub(in crate::solve) struct Bench<A> {
    room: Room<A>,
    out: Vec<Complex<A>>,
}

impl<A: Arithmetic> Default for Bench<A> {
    fn default() -> Self {
        Self {
            room: Room::default(),
            out: Vec::new(),
        }
    }
}

impl Default for Solver {
    /// With the fastest instruction set of the processor.
    fn default() -> Self {
        Self::new(Instructions::available()[0])
    }
}

impl Solver {
    /// With an instruction set, which the processor must have.
    pub(in crate::solve) fn new(instructions: Instructions) -> Self {
        assert!(
            Instructions::available().contains(&instructions),
            "the processor has not these instructions"
        );
        let vectors = match instructions {
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => Vectors::Avx512(Bench::default()),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => Vectors::Avx2(Bench::default()),
            Instructions::Portable => Vectors::Portable(Bench::default()),
        };
        Self {
            vectors,
            low: Bench::default(),
        }
    }

    /// Writes the responses of every output at some angular frequencies, rad/s: positive, or complex.
    pub(in crate::solve) fn solve(
        &mut self,
        prepared: &Prepared,
        omegas: &[Complex64],
        out: &mut [&mut [Complex64]],
    ) {
        for (run, is_low) in runs(prepared, omegas, 0..omegas.len()) {
            if is_low {
                self.low.solve(prepared, (omegas, run), out);
            } else {
                for_each!(&mut self.vectors, bench => bench.solve(prepared, (omegas, run), out));
            }
        }
    }

    /// Writes the characteristic function of a plan without loads at some angular frequencies, rad/s.
    pub(in crate::solve) fn characteristic(
        &mut self,
        prepared: &Prepared,
        omegas: &[Complex64],
        out: &mut [Magnified],
    ) {
        for_each!(&mut self.vectors, bench => bench.characteristic(prepared, omegas, out));
    }

    /// The sides of a part of the beam at some angular frequencies, rad/s.
    pub(in crate::solve) fn keep(
        &mut self,
        substructure: &Substructure,
        omegas: &[Complex64],
    ) -> Vec<SideBatch> {
        let batches = batches(omegas.len());
        let keep = |batch| SideBatch(self.keep_batch(substructure, omegas, batch));
        batches.map(keep).collect()
    }

    fn keep_batch(
        &mut self,
        substructure: &Substructure,
        omegas: &[Complex64],
        batch: Range<usize>,
    ) -> Vec<GroupSides> {
        let mut kept = Vec::new();
        for (run, is_low) in runs(&substructure.prepared, omegas, batch) {
            let omegas = &omegas[run];
            if is_low {
                self.low.keep(substructure, omegas, &mut kept);
            } else {
                for_each!(&mut self.vectors, bench => bench.keep(substructure, omegas, &mut kept));
            }
        }
        kept
    }

    /// [`Self::solve`] with cached sides, from the frequency with the index `first`, which begins a batch.
    pub(in crate::solve) fn solve_substructure(
        &mut self,
        substructure: &Substructure,
        (kept, first): (&[SideBatch], usize),
        omegas: &[Complex64],
        out: &mut [&mut [Complex64]],
    ) {
        let kept = &kept[first / MOST_LANES..];
        for (batch, SideBatch(sides)) in batches(omegas.len()).zip(kept) {
            let mut sides = sides.iter();
            for (run, is_low) in runs(&substructure.prepared, omegas, batch) {
                let at = (omegas, run);
                if is_low {
                    self.low
                        .solve_substructure(substructure, &mut sides, at, out);
                } else {
                    for_each!(&mut self.vectors, bench => {
                        bench.solve_substructure(substructure, &mut sides, at, out);
                    });
                }
            }
        }
    }
}

/// The indices of frequencies whose sides are cached together.
fn batches(count: usize) -> impl Iterator<Item = Range<usize>> {
    let starts = (0..count).step_by(MOST_LANES);
    starts.map(move |start| start..count.min(start + MOST_LANES))
}

/// The indices of consecutive frequencies among some that are all low or all not, and which.
fn runs(
    prepared: &Prepared,
    omegas: &[Complex64],
    among: Range<usize>,
) -> impl Iterator<Item = (Range<usize>, bool)> {
    let mut end = among.start;
    let is_low = |omega: &Complex64| prepared.is_low(*omega);
    let runs = omegas[among].chunk_by(move |a, b| is_low(a) == is_low(b));
    runs.map(move |run| {
        let start = end;
        end += run.len();
        (start..end, is_low(&run[0]))
    })
}

impl SideBatch {
    /// Bytes that it takes.
    pub(in crate::solve) fn bytes(&self) -> usize {
        let bytes = |sides: &GroupSides| match sides {
            #[cfg(target_arch = "x86_64")]
            GroupSides::Avx512(sides) => sides.bytes(),
            #[cfg(target_arch = "x86_64")]
            GroupSides::Avx2(sides) => sides.bytes(),
            GroupSides::Portable(sides) => sides.bytes(),
            GroupSides::DoubleDouble(sides) => sides.bytes(),
        };
        self.0.iter().map(bytes).sum()
    }
}

/// An arithmetic whose sides can be cached.
pub(in crate::solve) trait Kind: Arithmetic {
    /// To cache the sides of a group.
    fn kept(sides: Box<Sides<Self>>) -> GroupSides;

    /// The sides, if this arithmetic solved them.
    fn sides(kept: &GroupSides) -> Option<&Sides<Self>>;
}

macro_rules! kind {
    ($name:ident) => {
        impl Kind for $name {
            fn kept(sides: Box<Sides<Self>>) -> GroupSides {
                GroupSides::$name(sides)
            }

            fn sides(kept: &GroupSides) -> Option<&Sides<Self>> {
                match kept {
                    GroupSides::$name(sides) => Some(sides),
                    _ => None,
                }
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
kind!(Avx512);
#[cfg(target_arch = "x86_64")]
kind!(Avx2);
kind!(Portable);
kind!(DoubleDouble);

/// Angular frequencies, rad/s, and the indices of those to solve.
type Among<'a> = (&'a [Complex64], Range<usize>);

impl<A: Kind> Bench<A> {
    fn solve(&mut self, prepared: &Prepared, at: Among<'_>, out: &mut [&mut [Complex64]]) {
        A::outlined(Solve((self, prepared, at, out)));
    }

    #[inline(always)]
    fn solve_inlined(
        (this, prepared, (omegas, run), out): (
            &mut Self,
            &Prepared,
            Among<'_>,
            &mut [&mut [Complex64]],
        ),
    ) {
        this.out.resize(prepared.plan.outputs.len(), Complex::ZERO);
        for start in run.clone().step_by(A::LANES) {
            let group = start..run.end.min(start + A::LANES);
            let omega = filled_up(&omegas[group.clone()]);
            this.room.solve(prepared, omega, &mut this.out);
            this.write(group, out);
        }
    }

    fn characteristic(&mut self, prepared: &Prepared, omegas: &[Complex64], out: &mut [Magnified]) {
        A::outlined(Characteristic((self, prepared, omegas, out)));
    }

    #[inline(always)]
    fn characteristic_inlined(
        (this, prepared, omegas, out): (&mut Self, &Prepared, &[Complex64], &mut [Magnified]),
    ) {
        for (group, out) in omegas.chunks(A::LANES).zip(out.chunks_mut(A::LANES)) {
            this.room.characteristic(prepared, filled_up(group), out);
        }
    }

    fn keep(
        &mut self,
        substructure: &Substructure,
        omegas: &[Complex64],
        kept: &mut Vec<GroupSides>,
    ) {
        for group in omegas.chunks(A::LANES) {
            let sides = A::outlined(Keep((&mut self.room, substructure, group)));
            kept.push(A::kept(Box::new(sides)));
        }
    }

    #[inline(always)]
    fn keep_inlined(
        (room, substructure, group): (&mut Room<A>, &Substructure, &[Complex64]),
    ) -> Sides<A> {
        room.sides(substructure, filled_up(group))
    }

    fn solve_substructure(
        &mut self,
        substructure: &Substructure,
        kept: &mut Iter<'_, GroupSides>,
        at: Among<'_>,
        out: &mut [&mut [Complex64]],
    ) {
        A::outlined(SolveSubstructure((self, substructure, kept, at, out)));
    }

    #[inline(always)]
    fn solve_substructure_inlined(
        (this, substructure, kept, (omegas, run), out): (
            &mut Self,
            &Substructure,
            &mut Iter<'_, GroupSides>,
            Among<'_>,
            &mut [&mut [Complex64]],
        ),
    ) {
        let plan = &substructure.prepared.plan;
        this.out.resize(plan.outputs.len(), Complex::ZERO);
        for start in run.clone().step_by(A::LANES) {
            let group = start..run.end.min(start + A::LANES);
            // Cannot happen: the processor does not change while the program runs.
            let Some(sides) = kept.next().and_then(A::sides) else {
                return this.solve(&substructure.prepared, (omegas, start..run.end), out);
            };
            let omega = filled_up(&omegas[group.clone()]);
            this.room
                .solve_substructure(substructure, sides, omega, &mut this.out);
            this.write(group, out);
        }
    }

    /// Writes the outputs of a group.
    #[inline(always)]
    fn write(&self, group: Range<usize>, out: &mut [&mut [Complex64]]) {
        for (value, column) in self.out.iter().zip(out) {
            value.write(&mut column[group.clone()]);
        }
    }
}

/// A group of angular frequencies, rad/s, padded with the last of them.
#[inline(always)]
fn filled_up<A: Arithmetic>(omegas: &[Complex64]) -> Complex<A> {
    let last = omegas.len() - 1;
    Complex::new(&std::array::from_fn(|lane| omegas[lane.min(last)]))
}

part!(
    Solve ['a, 'b, A: Kind] ['a, 'b, A]
    (&'a mut Bench<A>, &'a Prepared, Among<'a>, &'a mut [&'b mut [Complex64]]) -> (),
    Bench::solve_inlined
);

part!(
    Keep ['a, A: Kind] ['a, A]
    (&'a mut Room<A>, &'a Substructure, &'a [Complex64]) -> Sides<A>,
    Bench::keep_inlined
);

part!(
    SolveSubstructure ['a, 'b, 'c, A: Kind] ['a, 'b, 'c, A]
    (&'a mut Bench<A>, &'a Substructure, &'a mut Iter<'c, GroupSides>, Among<'a>, &'a mut [&'b mut [Complex64]]) -> (),
    Bench::solve_substructure_inlined
);

part!(
    Characteristic ['a, A: Kind] ['a, A]
    (&'a mut Bench<A>, &'a Prepared, &'a [Complex64], &'a mut [Magnified]) -> (),
    Bench::characteristic_inlined
);

//! Selection of the instruction set of the kernel at run time.

use num_complex::Complex64;

use super::complex::Complex;
use super::number::{Arithmetic, part};
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
pub(in crate::solve) enum Solver {
    #[cfg(target_arch = "x86_64")]
    Avx512(Bench<Avx512>),
    #[cfg(target_arch = "x86_64")]
    Avx2(Bench<Avx2>),
    Portable(Bench<Portable>),
}

/// The sides of a part of the beam, in the arithmetic that solved them.
#[derive(Debug, Clone)]
pub(in crate::solve) enum SideBatch {
    #[cfg(target_arch = "x86_64")]
    Avx512(Box<Sides<Avx512>>),
    #[cfg(target_arch = "x86_64")]
    Avx2(Box<Sides<Avx2>>),
    Portable(Box<Sides<Portable>>),
}

/// The same expression for each variant of an enum.
macro_rules! for_each {
    ($value:expr, $name:ident => $do:expr) => {
        match $value {
            #[cfg(target_arch = "x86_64")]
            Self::Avx512($name) => $do,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2($name) => $do,
            Self::Portable($name) => $do,
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
        match instructions {
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => Self::Avx512(Bench::default()),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => Self::Avx2(Bench::default()),
            Instructions::Portable => Self::Portable(Bench::default()),
        }
    }

    /// Writes the responses of every output at some angular frequencies, rad/s: positive, or complex.
    pub(in crate::solve) fn solve(
        &mut self,
        prepared: &Prepared,
        omegas: &[Complex64],
        out: &mut [&mut [Complex64]],
    ) {
        for_each!(self, bench => bench.solve(prepared, omegas, out));
    }

    /// Writes the characteristic function of a plan without loads at some angular frequencies, rad/s.
    pub(in crate::solve) fn characteristic(
        &mut self,
        prepared: &Prepared,
        omegas: &[Complex64],
        out: &mut [Magnified],
    ) {
        for_each!(self, bench => bench.characteristic(prepared, omegas, out));
    }

    /// The sides of a part of the beam at some angular frequencies, rad/s, for each group that is solved at once.
    pub(in crate::solve) fn keep(
        &mut self,
        substructure: &Substructure,
        omegas: &[Complex64],
    ) -> Vec<SideBatch> {
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(bench) => bench.keep(substructure, omegas, SideBatch::Avx512),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(bench) => bench.keep(substructure, omegas, SideBatch::Avx2),
            Self::Portable(bench) => bench.keep(substructure, omegas, SideBatch::Portable),
        }
    }

    /// [`Self::solve`] with cached sides, from the frequency with the index `first`, which begins a group.
    pub(in crate::solve) fn solve_substructure(
        &mut self,
        substructure: &Substructure,
        (kept, first): (&[SideBatch], usize),
        omegas: &[Complex64],
        out: &mut [&mut [Complex64]],
    ) {
        for_each!(self, bench => bench.solve_substructure(substructure, (kept, first), omegas, out));
    }
}

impl SideBatch {
    /// Bytes that it takes.
    pub(in crate::solve) fn bytes(&self) -> usize {
        for_each!(self, sides => sides.bytes())
    }
}

/// An arithmetic whose sides can be cached.
pub(in crate::solve) trait Kind: Arithmetic {
    /// The sides, if this arithmetic solved them.
    fn sides(kept: &SideBatch) -> Option<&Sides<Self>>;
}

macro_rules! kind {
    ($name:ident) => {
        impl Kind for $name {
            fn sides(kept: &SideBatch) -> Option<&Sides<Self>> {
                match kept {
                    SideBatch::$name(sides) => Some(sides),
                    #[cfg(target_arch = "x86_64")]
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

impl<A: Kind> Bench<A> {
    fn solve(&mut self, prepared: &Prepared, omegas: &[Complex64], out: &mut [&mut [Complex64]]) {
        A::outlined(Solve((self, prepared, omegas, out)));
    }

    #[inline(always)]
    fn solve_inlined(
        (this, prepared, omegas, out): (
            &mut Self,
            &Prepared,
            &[Complex64],
            &mut [&mut [Complex64]],
        ),
    ) {
        this.out.resize(prepared.plan.outputs.len(), Complex::ZERO);
        for (index, group) in omegas.chunks(A::LANES).enumerate() {
            this.room.solve(prepared, filled_up(group), &mut this.out);
            this.write(index, out);
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
        kind: fn(Box<Sides<A>>) -> SideBatch,
    ) -> Vec<SideBatch> {
        let groups = omegas.chunks(A::LANES);
        let sides = |group| Box::new(A::outlined(Keep((&mut self.room, substructure, group))));
        groups.map(sides).map(kind).collect()
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
        (kept, first): (&[SideBatch], usize),
        omegas: &[Complex64],
        out: &mut [&mut [Complex64]],
    ) {
        let kept = &kept[first / A::LANES..];
        A::outlined(SolveSubstructure((self, substructure, kept, omegas, out)));
    }

    #[inline(always)]
    fn solve_substructure_inlined(
        (this, substructure, kept, omegas, out): (
            &mut Self,
            &Substructure,
            &[SideBatch],
            &[Complex64],
            &mut [&mut [Complex64]],
        ),
    ) {
        let plan = &substructure.prepared.plan;
        this.out.resize(plan.outputs.len(), Complex::ZERO);
        let groups = omegas.chunks(A::LANES).zip(kept);
        for (index, (group, kept)) in groups.enumerate() {
            // Cannot happen: the processor does not change while the program runs.
            let Some(sides) = A::sides(kept) else {
                return this.solve(&substructure.prepared, omegas, out);
            };
            let omega = filled_up(group);
            this.room
                .solve_substructure(substructure, sides, omega, &mut this.out);
            this.write(index, out);
        }
    }

    /// Writes the outputs of a group.
    #[inline(always)]
    fn write(&self, group: usize, out: &mut [&mut [Complex64]]) {
        let first = group * A::LANES;
        for (value, column) in self.out.iter().zip(out) {
            let end = column.len().min(first + A::LANES);
            value.write(&mut column[first..end]);
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
    (&'a mut Bench<A>, &'a Prepared, &'a [Complex64], &'a mut [&'b mut [Complex64]]) -> (),
    Bench::solve_inlined
);

part!(
    Keep ['a, A: Kind] ['a, A]
    (&'a mut Room<A>, &'a Substructure, &'a [Complex64]) -> Sides<A>,
    Bench::keep_inlined
);

part!(
    SolveSubstructure ['a, 'b, A: Kind] ['a, 'b, A]
    (&'a mut Bench<A>, &'a Substructure, &'a [SideBatch], &'a [Complex64], &'a mut [&'b mut [Complex64]]) -> (),
    Bench::solve_substructure_inlined
);

part!(
    Characteristic ['a, A: Kind] ['a, A]
    (&'a mut Bench<A>, &'a Prepared, &'a [Complex64], &'a mut [Magnified]) -> (),
    Bench::characteristic_inlined
);

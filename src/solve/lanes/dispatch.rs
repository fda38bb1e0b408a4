//! Which instructions the kernel may use, found when the program runs.

use num_complex::Complex64;

use super::complex::Complex;
use super::number::{Arithmetic, MOST_LANES, Real, part};
use super::portable::Portable;
use super::recursion::{Prepared, Room};
use super::sides::{Between, Sides};
#[cfg(target_arch = "x86_64")]
use super::vectors::{Avx2, Avx512};
use super::waves::Waves;

/// Sets of instructions that the kernel is made for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Instructions {
    /// Vectors of 512 bits: eight frequencies at once.
    #[cfg(target_arch = "x86_64")]
    Avx512,
    /// Vectors of 256 bits and multiplications that add: four.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// What every processor has: four, by whatever vectors the program was compiled for.
    Portable,
}

impl Instructions {
    /// Those of this processor, the best ones first.
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

/// A workspace for one thread, with the instructions it uses.
#[derive(Debug)]
pub(in crate::solve) enum Solver {
    #[cfg(target_arch = "x86_64")]
    Avx512(Bench<Avx512>),
    #[cfg(target_arch = "x86_64")]
    Avx2(Bench<Avx2>),
    Portable(Bench<Portable>),
}

/// The sides of a part of the beam, by the instructions they were found with.
#[derive(Debug, Clone)]
pub(in crate::solve) enum KeptSides {
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

/// Room, and what comes out of it.
#[derive(Debug)]
pub(in crate::solve) struct Bench<A> {
    waves: Box<Waves<A>>,
    room: Room<A>,
    out: Vec<Complex<A>>,
}

impl<A: Arithmetic> Default for Bench<A> {
    fn default() -> Self {
        Self {
            waves: Box::new(Waves::NONE),
            room: Room::default(),
            out: Vec::new(),
        }
    }
}

impl Default for Solver {
    /// With the best instructions that the processor has.
    fn default() -> Self {
        Self::new(Instructions::available()[0])
    }
}

impl Solver {
    /// With some instructions, which the processor must have.
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

    /// Writes the responses of every output at some frequencies (Hz, > 0).
    pub(in crate::solve) fn solve(
        &mut self,
        prepared: &Prepared,
        frequencies: &[f64],
        out: &mut [&mut [Complex64]],
    ) {
        for_each!(self, bench => bench.solve(prepared, frequencies, out));
    }

    /// The sides of a part of the beam at some frequencies (Hz, > 0), for each group of them that is solved at once.
    pub(in crate::solve) fn keep(
        &mut self,
        between: &Between,
        frequencies: &[f64],
    ) -> Vec<KeptSides> {
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(bench) => bench.keep(between, frequencies, KeptSides::Avx512),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(bench) => bench.keep(between, frequencies, KeptSides::Avx2),
            Self::Portable(bench) => bench.keep(between, frequencies, KeptSides::Portable),
        }
    }

    /// [`Self::solve`] from what was kept, beginning with the frequency of a number, which begins a group.
    pub(in crate::solve) fn solve_between(
        &mut self,
        between: &Between,
        (kept, first): (&[KeptSides], usize),
        frequencies: &[f64],
        out: &mut [&mut [Complex64]],
    ) {
        for_each!(self, bench => bench.solve_between(between, (kept, first), frequencies, out));
    }
}

impl KeptSides {
    /// Bytes that it takes.
    pub(in crate::solve) fn bytes(&self) -> usize {
        for_each!(self, sides => sides.bytes())
    }
}

/// An arithmetic whose sides can be kept beside those of others.
pub(in crate::solve) trait Kind: Arithmetic {
    /// The sides, where they were found with this arithmetic.
    fn sides(kept: &KeptSides) -> Option<&Sides<Self>>;
}

macro_rules! kind {
    ($name:ident) => {
        impl Kind for $name {
            fn sides(kept: &KeptSides) -> Option<&Sides<Self>> {
                match kept {
                    KeptSides::$name(sides) => Some(sides),
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
    fn solve(&mut self, prepared: &Prepared, frequencies: &[f64], out: &mut [&mut [Complex64]]) {
        A::outlined(Solve((self, prepared, frequencies, out)));
    }

    #[inline(always)]
    fn solve_inlined(
        (this, prepared, frequencies, out): (&mut Self, &Prepared, &[f64], &mut [&mut [Complex64]]),
    ) {
        this.out.resize(prepared.plan.outputs.len(), Complex::ZERO);
        for (index, group) in frequencies.chunks(A::LANES).enumerate() {
            this.waves.set(&prepared.constants, angular(group));
            this.room.solve(prepared, &this.waves, &mut this.out);
            this.write(index, out);
        }
    }

    fn keep(
        &mut self,
        between: &Between,
        frequencies: &[f64],
        kind: fn(Box<Sides<A>>) -> KeptSides,
    ) -> Vec<KeptSides> {
        let groups = frequencies.chunks(A::LANES);
        let sides = |group| Box::new(A::outlined(Keep((&mut self.room, between, group))));
        groups.map(sides).map(kind).collect()
    }

    #[inline(always)]
    fn keep_inlined((room, between, group): (&mut Room<A>, &Between, &[f64])) -> Sides<A> {
        room.sides(between, angular(group))
    }

    fn solve_between(
        &mut self,
        between: &Between,
        (kept, first): (&[KeptSides], usize),
        frequencies: &[f64],
        out: &mut [&mut [Complex64]],
    ) {
        let kept = &kept[first / A::LANES..];
        A::outlined(SolveBetween((self, between, kept, frequencies, out)));
    }

    #[inline(always)]
    fn solve_between_inlined(
        (this, between, kept, frequencies, out): (
            &mut Self,
            &Between,
            &[KeptSides],
            &[f64],
            &mut [&mut [Complex64]],
        ),
    ) {
        let plan = &between.prepared.plan;
        this.out.resize(plan.outputs.len(), Complex::ZERO);
        let groups = frequencies.chunks(A::LANES).zip(kept);
        for (index, (group, kept)) in groups.enumerate() {
            // The processor does not change while the program runs.
            let Some(sides) = A::sides(kept) else {
                return this.solve(&between.prepared, frequencies, out);
            };
            let omega = angular(group);
            this.room
                .solve_between(between, sides, omega, &mut this.out);
            this.write(index, out);
        }
    }

    /// Writes what came out of a group of a number.
    #[inline(always)]
    fn write(&self, group: usize, out: &mut [&mut [Complex64]]) {
        let first = group * A::LANES;
        for (value, column) in self.out.iter().zip(out) {
            let end = column.len().min(first + A::LANES);
            value.write(&mut column[first..end]);
        }
    }
}

/// Angular frequencies, rad/s; the last few are filled up with the last.
#[inline(always)]
fn angular<A: Arithmetic>(frequencies: &[f64]) -> Real<A> {
    let last = frequencies.len() - 1;
    let mut omega = [0.0; MOST_LANES];
    for lane in 0..A::LANES {
        omega[lane] = std::f64::consts::TAU * frequencies[lane.min(last)];
    }
    Real::new(&omega)
}

part!(
    Solve ['a, 'b, A: Kind] ['a, 'b, A]
    (&'a mut Bench<A>, &'a Prepared, &'a [f64], &'a mut [&'b mut [Complex64]]) -> (),
    Bench::solve_inlined
);

part!(
    Keep ['a, A: Kind] ['a, A]
    (&'a mut Room<A>, &'a Between, &'a [f64]) -> Sides<A>,
    Bench::keep_inlined
);

part!(
    SolveBetween ['a, 'b, A: Kind] ['a, 'b, A]
    (&'a mut Bench<A>, &'a Between, &'a [KeptSides], &'a [f64], &'a mut [&'b mut [Complex64]]) -> (),
    Bench::solve_between_inlined
);

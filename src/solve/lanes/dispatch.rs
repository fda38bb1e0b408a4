//! Which instructions the kernel may use, found when the program runs.

use num_complex::Complex64;

use super::complex::Complex;
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
use super::number::Fused;
use super::number::{Arithmetic, Plain, Real, WIDTH, part};
use super::recursion::{Prepared, Room};
use super::sides::{Between, Sides};
use crate::solve::plan::Plan;

/// A workspace for one thread, with the instructions it uses.
#[derive(Debug)]
pub(in crate::solve) enum Solver {
    /// Vectors of 256 bits and multiplications that add.
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    Fused(Bench<Fused>),
    /// What every processor has.
    Plain(Bench<Plain>),
}

/// The sides of a part of the beam, by the instructions they were found with.
#[derive(Debug, Clone)]
pub(in crate::solve) enum KeptSides {
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    Fused(Sides<Fused>),
    Plain(Sides<Plain>),
}

/// Room, and what comes out of it.
#[derive(Debug)]
pub(in crate::solve) struct Bench<A> {
    room: Room<A>,
    out: Vec<Complex<A>>,
}

/// What the kernel is to do.
enum Task<'a, A> {
    /// All responses of a plan.
    Solve(&'a Prepared, &'a mut [Complex<A>]),
    /// The sides of a part.
    Keep(&'a Between, &'a mut Option<Sides<A>>),
    /// All responses of a plan whose sides are known.
    SolveBetween(&'a Between, &'a Sides<A>, &'a mut [Complex<A>]),
}

impl<A> Default for Bench<A> {
    fn default() -> Self {
        Self {
            room: Room::default(),
            out: Vec::new(),
        }
    }
}

impl Default for Solver {
    /// With the best instructions that the processor has.
    fn default() -> Self {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
            return Self::Fused(Bench::default());
        }
        #[cfg(target_arch = "aarch64")]
        return Self::Fused(Bench::default());
        #[cfg(not(target_arch = "aarch64"))]
        Self::Plain(Bench::default())
    }
}

impl Solver {
    /// All responses at some frequencies (Hz, > 0), a row a frequency.
    pub(in crate::solve) fn solve(
        &mut self,
        prepared: &Prepared,
        frequencies: &[f64],
    ) -> Vec<Complex64> {
        let mut rows = Rows::new(&prepared.plan, frequencies);
        for omega in frequencies.chunks(WIDTH).map(angular) {
            match self {
                #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
                Self::Fused(bench) => rows.add(&mut bench.out, |out| {
                    run(&mut bench.room, omega, Task::Solve(prepared, out));
                }),
                Self::Plain(bench) => rows.add(&mut bench.out, |out| {
                    run(&mut bench.room, omega, Task::Solve(prepared, out));
                }),
            }
        }
        rows.values
    }

    /// The sides of a part of the beam at some frequencies (Hz, > 0), for [`WIDTH`] of them each.
    pub(in crate::solve) fn keep(
        &mut self,
        between: &Between,
        frequencies: &[f64],
    ) -> Vec<KeptSides> {
        let keep = |omega| match self {
            #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
            Self::Fused(bench) => {
                let mut sides = None;
                run(&mut bench.room, omega, Task::Keep(between, &mut sides));
                sides.map(KeptSides::Fused)
            }
            Self::Plain(bench) => {
                let mut sides = None;
                run(&mut bench.room, omega, Task::Keep(between, &mut sides));
                sides.map(KeptSides::Plain)
            }
        };
        let groups = frequencies.chunks(WIDTH);
        groups.map(angular).filter_map(keep).collect()
    }

    /// All responses at some frequencies (Hz, > 0), a row a frequency, from what was kept for them.
    pub(in crate::solve) fn solve_between(
        &mut self,
        between: &Between,
        kept: &[KeptSides],
        frequencies: &[f64],
    ) -> Vec<Complex64> {
        let mut rows = Rows::new(&between.prepared.plan, frequencies);
        for (omega, kept) in frequencies.chunks(WIDTH).map(angular).zip(kept) {
            match (&mut *self, kept) {
                #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
                (Self::Fused(bench), KeptSides::Fused(sides)) => {
                    rows.add(&mut bench.out, |out| {
                        let task = Task::SolveBetween(between, sides, out);
                        run(&mut bench.room, omega, task);
                    });
                }
                (Self::Plain(bench), KeptSides::Plain(sides)) => {
                    rows.add(&mut bench.out, |out| {
                        let task = Task::SolveBetween(between, sides, out);
                        run(&mut bench.room, omega, task);
                    });
                }
                // The processor does not change while the program runs.
                #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
                _ => return self.solve(&between.prepared, frequencies),
            }
        }
        rows.values
    }
}

impl KeptSides {
    /// Bytes that it takes.
    pub(in crate::solve) fn bytes(&self) -> usize {
        match self {
            #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
            Self::Fused(sides) => sides.bytes(),
            Self::Plain(sides) => sides.bytes(),
        }
    }
}

/// Angular frequencies, rad/s; the last few are filled up with the last.
fn angular(frequencies: &[f64]) -> [f64; WIDTH] {
    let last = frequencies.len() - 1;
    std::array::from_fn(|lane| std::f64::consts::TAU * frequencies[lane.min(last)])
}

/// Responses in the making, a row a frequency.
struct Rows {
    /// Values a row.
    width: usize,
    /// How many there will be.
    most: usize,
    values: Vec<Complex64>,
}

impl Rows {
    fn new(plan: &Plan, frequencies: &[f64]) -> Self {
        let width = plan.outputs.len();
        let most = width * frequencies.len();
        Self {
            width,
            most,
            values: Vec::with_capacity(most),
        }
    }

    /// Adds the rows that a kernel makes.
    fn add<A: Arithmetic>(
        &mut self,
        out: &mut Vec<Complex<A>>,
        kernel: impl FnOnce(&mut [Complex<A>]),
    ) {
        out.resize(self.width, Complex::ZERO);
        kernel(out);
        for lane in 0..WIDTH {
            if self.values.len() < self.most {
                self.values.extend(out.iter().map(|value| value.lane(lane)));
            }
        }
    }
}

/// The kernel.
fn run<A: Arithmetic>(room: &mut Room<A>, omega: [f64; WIDTH], task: Task<'_, A>) {
    A::outlined(Run((room, omega, task)));
}

#[inline(always)]
fn run_inlined<A: Arithmetic>((room, omega, task): (&mut Room<A>, [f64; WIDTH], Task<'_, A>)) {
    let omega = Real::new(omega);
    match task {
        Task::Solve(prepared, out) => room.solve(prepared, omega, out),
        Task::Keep(between, sides) => *sides = Some(room.sides(between, omega)),
        Task::SolveBetween(between, sides, out) => {
            room.solve_between(between, sides, omega, out);
        }
    }
}

part!(
    Run ['a, A: Arithmetic] ['a, A]
    (&'a mut Room<A>, [f64; WIDTH], Task<'a, A>) -> (),
    run_inlined
);

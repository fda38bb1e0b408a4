//! Numbers of [`WIDTH`] frequencies at once.
//!
//! Every operation is a loop over an array that the compiler turns into one instruction where the processor has
//! vectors, once it is inlined into a function that may use them: hence `#[inline(always)]`, here and up to the next
//! [`Part`], and neither closures nor iterators in between.

use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Frequencies that are solved at once: as many as a vector of 256 bits holds.
pub(in crate::solve) const WIDTH: usize = 4;

/// A part of the kernel, with what it works on: all in one piece the kernel would take minutes to compile.
pub(in crate::solve) trait Part {
    type Output;

    /// To be `#[inline(always)]`: see [`part!`].
    fn run(self) -> Self::Output;
}

/// Makes an `#[inline(always)]` function of one tuple a [`Part`].
macro_rules! part {
    ($name:ident [$($generic:tt)*] [$($argument:tt)*] ($($with:ty),* $(,)?) -> $output:ty, $run:path) => {
        struct $name<$($generic)*>(($($with,)*));

        impl<$($generic)*> super::number::Part for $name<$($argument)*> {
            type Output = $output;

            #[inline(always)]
            fn run(self) -> $output {
                $run(self.0)
            }
        }
    };
}
pub(super) use part;

/// How two numbers are combined.
pub(in crate::solve) trait Arithmetic: Copy + 'static {
    /// a b + c.
    fn multiply_add(a: f64, b: f64, c: f64) -> f64;

    /// Runs a part of the kernel as a function of its own, with the instructions of this arithmetic.
    fn outlined<P: Part>(part: P) -> P::Output;

    /// Takes note of an operation that costs as much as a multiplication that adds.
    #[inline(always)]
    fn note() {}

    /// Takes note of a division or a square root.
    #[inline(always)]
    fn note_division() {}
}

/// With one rounding, where the processor has an instruction for it.
#[derive(Debug, Clone, Copy)]
pub(in crate::solve) struct Fused;

/// With two roundings, on any processor.
#[derive(Debug, Clone, Copy)]
pub(in crate::solve) struct Plain;

impl Arithmetic for Fused {
    #[inline(always)]
    fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }

    #[inline(always)]
    fn outlined<P: Part>(part: P) -> P::Output {
        with_vectors(part)
    }
}

impl Arithmetic for Plain {
    #[inline(always)]
    fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
        a * b + c
    }

    #[inline(never)]
    fn outlined<P: Part>(part: P) -> P::Output {
        part.run()
    }
}

#[cfg(target_arch = "x86_64")]
#[inline(always)]
#[allow(
    unsafe_code,
    reason = "the only way to instructions that are looked for at run time"
)]
fn with_vectors<P: Part>(part: P) -> P::Output {
    #[target_feature(enable = "avx2,fma")]
    #[inline(never)]
    fn vectors<P: Part>(part: P) -> P::Output {
        part.run()
    }
    // SAFETY: `Fused` numbers are made by a `Solver::Fused` alone, and that where the processor has both.
    unsafe { vectors(part) }
}

/// The processor has them all.
#[cfg(not(target_arch = "x86_64"))]
#[inline(never)]
fn with_vectors<P: Part>(part: P) -> P::Output {
    part.run()
}

/// A real number at each frequency.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
pub(super) struct Real<A>(pub(super) [f64; WIDTH], PhantomData<A>);

impl<A: Arithmetic> Real<A> {
    pub(super) const ZERO: Self = Self([0.0; WIDTH], PhantomData);
    pub(super) const ONE: Self = Self([1.0; WIDTH], PhantomData);

    /// One number at each frequency.
    #[inline(always)]
    pub(super) fn new(values: [f64; WIDTH]) -> Self {
        Self(values, PhantomData)
    }

    /// The same number at all frequencies.
    #[inline(always)]
    pub(super) fn splat(value: f64) -> Self {
        Self::new([value; WIDTH])
    }

    /// self b + c.
    #[inline(always)]
    pub(super) fn multiply_add(self, b: Self, c: Self) -> Self {
        A::note();
        let mut out = [0.0; WIDTH];
        for lane in 0..WIDTH {
            out[lane] = A::multiply_add(self.0[lane], b.0[lane], c.0[lane]);
        }
        Self::new(out)
    }

    /// c - self b.
    #[inline(always)]
    pub(super) fn subtract_product(self, b: Self, c: Self) -> Self {
        A::note();
        let mut out = [0.0; WIDTH];
        for lane in 0..WIDTH {
            out[lane] = A::multiply_add(-self.0[lane], b.0[lane], c.0[lane]);
        }
        Self::new(out)
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        A::note_division();
        let mut out = [0.0; WIDTH];
        for lane in 0..WIDTH {
            out[lane] = self.0[lane].sqrt();
        }
        Self::new(out)
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        let mut out = [0.0; WIDTH];
        for lane in 0..WIDTH {
            out[lane] = self.0[lane].abs();
        }
        Self::new(out)
    }

    /// The larger one.
    #[inline(always)]
    pub(super) fn max(self, other: Self) -> Self {
        self.where_less(other, other, self)
    }

    /// `yes` where this is less than `than`, else `no`.
    #[inline(always)]
    pub(super) fn where_less(self, than: Self, yes: Self, no: Self) -> Self {
        let mut out = [0.0; WIDTH];
        for lane in 0..WIDTH {
            out[lane] = if self.0[lane] < than.0[lane] {
                yes.0[lane]
            } else {
                no.0[lane]
            };
        }
        Self::new(out)
    }

    /// With the sign of another number.
    #[inline(always)]
    pub(super) fn with_sign_of(self, sign: Self) -> Self {
        let mut out = [0.0; WIDTH];
        for lane in 0..WIDTH {
            out[lane] = self.0[lane].copysign(sign.0[lane]);
        }
        Self::new(out)
    }

    /// Whether this is less than `than` at some frequency.
    #[inline(always)]
    pub(super) fn is_less_somewhere(self, than: Self) -> bool {
        let mut found = false;
        for lane in 0..WIDTH {
            found |= self.0[lane] < than.0[lane];
        }
        found
    }

    /// A power of two within a factor of two below 1 / self, for positive finite numbers.
    #[inline(always)]
    pub(super) fn inverse_power_of_two(self) -> Self {
        /// Twice the exponent of 1, in its place.
        const TWICE_ONE: u64 = 2046 << 52;
        const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
        let mut out = [0.0; WIDTH];
        for lane in 0..WIDTH {
            let exponent = self.0[lane].to_bits() & EXPONENT;
            out[lane] = f64::from_bits(TWICE_ONE.wrapping_sub(exponent));
        }
        Self::new(out)
    }
}

/// An operation of two numbers.
macro_rules! operation {
    ($trait:ident, $method:ident, $operator:tt, $note:expr) => {
        impl<A: Arithmetic> $trait for Real<A> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                $note;
                let mut out = [0.0; WIDTH];
                for lane in 0..WIDTH {
                    out[lane] = self.0[lane] $operator other.0[lane];
                }
                Self::new(out)
            }
        }
    };
}

operation!(Add, add, +, A::note());
operation!(Sub, sub, -, A::note());
operation!(Mul, mul, *, A::note());
operation!(Div, div, /, A::note_division());

impl<A: Arithmetic> Neg for Real<A> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        let mut out = [0.0; WIDTH];
        for lane in 0..WIDTH {
            out[lane] = -self.0[lane];
        }
        Self::new(out)
    }
}

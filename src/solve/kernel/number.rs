//! Numbers of several frequencies at once.
//!
//! Every operation is one vector instruction, if it is inlined into a function with that target feature: hence
//! `#[inline(always)]`, here and up to the next [`Part`], and neither closures nor iterators in between.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The most frequencies in a group on any processor; a multiple of every group size.
pub(in crate::solve) const MOST_LANES: usize = 8;

/// A part of the kernel and its arguments, compiled as a separate function: in one piece the kernel would take minutes
/// to compile.
pub(in crate::solve) trait Part {
    type Output;

    /// Must be `#[inline(always)]`: see [`part!`].
    fn run(self) -> Self::Output;
}

/// Makes an `#[inline(always)]` function of one tuple a [`Part`].
macro_rules! part {
    ($name:ident [$($generic:tt)*] [$($argument:tt)*] ($($with:ty),* $(,)?) -> $output:ty, $run:path) => {
        struct $name<$($generic)*>(($($with,)*));

        impl<$($generic)*> $crate::solve::kernel::number::Part for $name<$($argument)*> {
            type Output = $output;

            #[inline(always)]
            fn run(self) -> $output {
                $run(self.0)
            }
        }
    };
}
pub(super) use part;

/// The numbers of a few frequencies as a vector of one kind of processor.
///
/// Some methods work on their bits as unsigned integers.
pub(in crate::solve) trait Arithmetic:
    Copy + Debug + Send + Sync + 'static
{
    /// Number of lanes; a divisor of [`MOST_LANES`].
    const LANES: usize;
    const ZERO: Self;
    const ONE: Self;

    /// The same number in all lanes.
    fn splat(value: f64) -> Self;

    /// The first [`Self::LANES`] of some numbers.
    fn load(values: &[f64; MOST_LANES]) -> Self;

    /// The lanes, then zeros.
    fn store(self) -> [f64; MOST_LANES];

    fn plus(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    fn times(self, other: Self) -> Self;
    fn over(self, other: Self) -> Self;
    fn square_root(self) -> Self;

    /// self b + c.
    fn multiply_add(self, b: Self, c: Self) -> Self;

    /// c - self b.
    fn subtract_product(self, b: Self, c: Self) -> Self;

    /// `yes` where this is less than `than`, otherwise `no`.
    fn where_less(self, than: Self, yes: Self, no: Self) -> Self;

    /// `yes` where the sign bit is set, otherwise `no`.
    fn where_signed(self, yes: Self, no: Self) -> Self;

    /// Whether this is less than `than` in any lane.
    fn is_less_somewhere(self, than: Self) -> bool;

    /// Bitwise and.
    fn and(self, other: Self) -> Self;

    /// Bitwise or.
    fn or(self, other: Self) -> Self;

    /// Bitwise exclusive or.
    fn xor(self, other: Self) -> Self;

    /// The sum of the bits as integers.
    fn plus_bits(self, other: Self) -> Self;

    /// The difference of the bits as integers.
    fn minus_bits(self, other: Self) -> Self;

    /// The bits shifted left by `by`.
    fn shifted(self, by: u32) -> Self;

    /// Runs a part of the kernel as a separate function, with the instructions of this arithmetic.
    fn outlined<P: Part>(part: P) -> P::Output;
}

/// A real number at each frequency.
#[derive(Debug, Clone, Copy)]
pub(super) struct Real<A>(A);

impl<A: Arithmetic> Real<A> {
    pub(super) const ZERO: Self = Self(A::ZERO);
    pub(super) const ONE: Self = Self(A::ONE);

    /// One number at each frequency.
    #[inline(always)]
    pub(super) fn new(values: &[f64; MOST_LANES]) -> Self {
        Self(A::load(values))
    }

    /// The numbers at all frequencies.
    #[inline(always)]
    pub(super) fn lanes(self) -> [f64; MOST_LANES] {
        self.0.store()
    }

    /// The same number at all frequencies.
    #[inline(always)]
    pub(super) fn splat(value: f64) -> Self {
        Self(A::splat(value))
    }

    /// The number with these bits at all frequencies.
    #[inline(always)]
    fn of_bits(bits: u64) -> Self {
        Self::splat(f64::from_bits(bits))
    }

    /// self b + c.
    #[inline(always)]
    pub(super) fn multiply_add(self, b: Self, c: Self) -> Self {
        Self(self.0.multiply_add(b.0, c.0))
    }

    /// c - self b.
    #[inline(always)]
    pub(super) fn subtract_product(self, b: Self, c: Self) -> Self {
        Self(self.0.subtract_product(b.0, c.0))
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        Self(self.0.square_root())
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        Self(self.0.and(Self::of_bits(!SIGN).0))
    }

    /// The larger one.
    #[inline(always)]
    pub(super) fn max(self, other: Self) -> Self {
        self.where_less(other, other, self)
    }

    /// `yes` where this is less than `than`, otherwise `no`.
    #[inline(always)]
    pub(super) fn where_less(self, than: Self, yes: Self, no: Self) -> Self {
        Self(self.0.where_less(than.0, yes.0, no.0))
    }

    /// With the sign of another number.
    #[inline(always)]
    pub(super) fn with_sign_of(self, sign: Self) -> Self {
        Self(self.abs().0.or(sign.0.and(Self::of_bits(SIGN).0)))
    }

    /// Whether this is less than `than` at any frequency.
    #[inline(always)]
    pub(super) fn is_less_somewhere(self, than: Self) -> bool {
        self.0.is_less_somewhere(than.0)
    }

    /// A power of two within a factor of two below 1 / self, for positive finite numbers.
    #[inline(always)]
    pub(super) fn inverse_power_of_two(self) -> Self {
        /// Twice the exponent bits of 1.
        const TWICE_ONE: u64 = 2046 << 52;
        const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
        let exponent = self.0.and(Self::of_bits(EXPONENT).0);
        Self(Self::of_bits(TWICE_ONE).0.minus_bits(exponent))
    }

    /// Two to the power of an integer in the low bits.
    #[inline(always)]
    pub(super) fn power_of_two(self) -> Self {
        /// The exponent bits of 1.
        const ONE: u64 = 1023;
        Self(self.0.plus_bits(Self::of_bits(ONE).0).shifted(52))
    }

    /// `yes` where the bit with the index `place` is set, otherwise `no`.
    #[inline(always)]
    pub(super) fn where_bit(self, place: u32, yes: Self, no: Self) -> Self {
        Self(self.0.shifted(63 - place).where_signed(yes.0, no.0))
    }

    /// With the other sign where the bit of `bits` with the index `place` is set.
    #[inline(always)]
    pub(super) fn turned_by_bit(self, bits: Self, place: u32) -> Self {
        let sign = bits.0.shifted(63 - place).and(Self::of_bits(SIGN).0);
        Self(self.0.xor(sign))
    }

    /// With the low bits incremented by one.
    #[inline(always)]
    pub(super) fn next_bits(self) -> Self {
        Self(self.0.plus_bits(Self::of_bits(1).0))
    }
}

/// The sign bit.
const SIGN: u64 = 1 << 63;

/// An operation of two numbers.
macro_rules! operation {
    ($trait:ident, $method:ident, $named:ident) => {
        impl<A: Arithmetic> $trait for Real<A> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$named(other.0))
            }
        }
    };
}

operation!(Add, add, plus);
operation!(Sub, sub, minus);
operation!(Mul, mul, times);
operation!(Div, div, over);

impl<A: Arithmetic> Neg for Real<A> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.xor(Self::of_bits(SIGN).0))
    }
}

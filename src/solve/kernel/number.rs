//! Numbers of several frequencies at once.
//!
//! Every operation on doubles is one vector instruction, if it is inlined into a function with that target feature: hence
//! `#[inline(always)]`, here and up to the next [`Part`], and neither closures nor iterators in between.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::double_double::DoubleDouble;

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

/// The numbers of a few frequencies: a vector of one kind of processor, or numbers of twice the digits.
pub(in crate::solve) trait Arithmetic:
    Copy + Debug + Send + Sync + 'static
{
    /// Number of lanes; a divisor of [`MOST_LANES`].
    const LANES: usize;
    const ZERO: Self;
    const ONE: Self;
    /// The largest relative error of an operation, about.
    const ROUNDING: f64;
    /// Terms of the series of the exponential of a number below 1/2, to its last digit.
    const TERMS: u32;

    /// The same number in all lanes.
    fn splat(value: f64) -> Self;

    /// A number that is the same in all lanes, rounded to this arithmetic.
    fn of(value: DoubleDouble) -> Self;

    /// 1 / `number` in all lanes.
    fn inverse_of(number: u32) -> Self;

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

    /// Whether this is less than `than` in any lane.
    fn is_less_somewhere(self, than: Self) -> bool;

    fn negative(self) -> Self;
    fn absolute(self) -> Self;

    /// With the sign of another number.
    fn with_sign_of(self, sign: Self) -> Self;

    /// A power of two within a factor of two below 1 / self, for positive finite numbers.
    fn inverse_power_of_two(self) -> Self;

    /// The exponential of a number at or below 700; 0 below -700.
    fn exponential(self) -> Self;

    fn sine_and_cosine(self) -> (Self, Self);

    /// Runs a part of the kernel as a separate function, with the instructions of this arithmetic.
    fn outlined<P: Part>(part: P) -> P::Output;
}

/// Vectors of doubles, whose bits are known: unsigned integers in the methods below.
pub(in crate::solve) trait Bits: Arithmetic {
    /// `yes` where the sign bit is set, otherwise `no`.
    fn where_signed(self, yes: Self, no: Self) -> Self;

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

    /// The same bits in all lanes.
    #[inline(always)]
    fn of_bits(bits: u64) -> Self {
        Self::splat(f64::from_bits(bits))
    }
}

/// The sign bit.
pub(super) const SIGN: u64 = 1 << 63;

/// The exponent.
pub(super) const EXPONENT: u64 = 0x7ff0_0000_0000_0000;

/// Twice the exponent bits of 1.
pub(super) const TWICE_ONE: u64 = 2046 << 52;

/// The methods of [`Arithmetic`] that are the same for all vectors of doubles.
macro_rules! of_doubles {
    () => {
        const ROUNDING: f64 = 0.5 * f64::EPSILON;
        const TERMS: u32 = 17;

        #[inline(always)]
        fn of(value: DoubleDouble) -> Self {
            Self::splat(value.rounded())
        }

        #[inline(always)]
        fn inverse_of(number: u32) -> Self {
            Self::splat(1.0 / f64::from(number))
        }

        #[inline(always)]
        fn negative(self) -> Self {
            self.xor(Self::of_bits(SIGN))
        }

        #[inline(always)]
        fn absolute(self) -> Self {
            self.and(Self::of_bits(!SIGN))
        }

        #[inline(always)]
        fn with_sign_of(self, sign: Self) -> Self {
            self.absolute().or(sign.and(Self::of_bits(SIGN)))
        }

        #[inline(always)]
        fn inverse_power_of_two(self) -> Self {
            let exponent = self.and(Self::of_bits(EXPONENT));
            Self::of_bits(TWICE_ONE).minus_bits(exponent)
        }

        #[inline(always)]
        fn exponential(self) -> Self {
            exp(Real(self)).0
        }

        #[inline(always)]
        fn sine_and_cosine(self) -> (Self, Self) {
            let (sine, cosine) = sin_cos(Real(self));
            (sine.0, cosine.0)
        }
    };
}
pub(super) use of_doubles;

/// A real number at each frequency.
#[derive(Debug, Clone, Copy)]
pub(super) struct Real<A>(pub(super) A);

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

    /// A number that is the same at all frequencies, rounded to this arithmetic.
    #[inline(always)]
    pub(super) fn of(value: Real<DoubleDouble>) -> Self {
        Self(A::of(value.0))
    }

    /// 1 / `number` at all frequencies.
    #[inline(always)]
    pub(super) fn inverse_of(number: u32) -> Self {
        Self(A::inverse_of(number))
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
        Self(self.0.absolute())
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
        Self(self.0.with_sign_of(sign.0))
    }

    /// Whether this is less than `than` at any frequency.
    #[inline(always)]
    pub(super) fn is_less_somewhere(self, than: Self) -> bool {
        self.0.is_less_somewhere(than.0)
    }

    /// A power of two within a factor of two below 1 / self, for positive finite numbers.
    #[inline(always)]
    pub(super) fn inverse_power_of_two(self) -> Self {
        Self(self.0.inverse_power_of_two())
    }

    /// The exponential of a number at or below 700; 0 below -700.
    #[inline(always)]
    pub(super) fn exp(self) -> Self {
        Self(self.0.exponential())
    }

    /// Sine and cosine.
    #[inline(always)]
    pub(super) fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sine_and_cosine();
        (Self(sine), Self(cosine))
    }
}

impl<A: Bits> Real<A> {
    /// Two to the power of an integer in the low bits.
    #[inline(always)]
    pub(super) fn power_of_two(self) -> Self {
        /// The exponent bits of 1.
        const ONE: u64 = 1023;
        Self(self.0.plus_bits(A::of_bits(ONE)).shifted(52))
    }

    /// `yes` where the bit with the index `place` is set, otherwise `no`.
    #[inline(always)]
    pub(super) fn where_bit(self, place: u32, yes: Self, no: Self) -> Self {
        Self(self.0.shifted(63 - place).where_signed(yes.0, no.0))
    }

    /// With the other sign where the bit of `bits` with the index `place` is set.
    #[inline(always)]
    pub(super) fn turned_by_bit(self, bits: Self, place: u32) -> Self {
        let sign = bits.0.shifted(63 - place).and(A::of_bits(SIGN));
        Self(self.0.xor(sign))
    }

    /// With the low bits incremented by one.
    #[inline(always)]
    pub(super) fn next_bits(self) -> Self {
        Self(self.0.plus_bits(A::of_bits(1)))
    }
}

impl<A: Arithmetic> From<f64> for Real<A> {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Self::splat(value)
    }
}

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
        Self(self.0.negative())
    }
}

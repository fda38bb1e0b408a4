//! The arithmetic of low frequencies: numbers of twice the digits, each the unevaluated sum of two.
//!
//! Far below the first bending resonance the six waves of a beam are nearly the same polynomials, so that digits are
//! lost like `(kappa L)^-4` and more; the same equations in these numbers lose as many of 32. Sum, product, quotient and
//! root are those of Joldes, Muller & Popescu (ACM Transactions on Mathematical Software 44 (2017) 15), within a few
//! units of 2^-106. Each is a function of its own, not inlined as the instructions of a vector are: it is long.

use super::elementary::rounded_product;
use super::number::{Arithmetic, MOST_LANES, Part, Real};
use super::portable::Portable;
use crate::solve::error_free::{Rounded, quick_two_sum, two_product, two_sum};

/// The leading parts or the remainders.
type Lanes = Real<Portable>;

/// The arithmetic of low frequencies: high + low, with low below the last digit of high.
#[derive(Debug, Clone, Copy)]
pub(in crate::solve) struct DoubleDouble {
    high: Lanes,
    low: Lanes,
}

impl Rounded for Lanes {}

impl DoubleDouble {
    /// A sum with a smaller number.
    #[inline(always)]
    fn sum(high: Lanes, low: Lanes) -> Self {
        let (high, low) = quick_two_sum(high, low);
        Self { high, low }
    }

    /// The nearest double of a number that is the same in all lanes.
    #[inline(always)]
    pub(super) fn rounded(self) -> f64 {
        self.high.lanes()[0]
    }

    /// Times powers of two.
    #[inline(always)]
    fn times_exactly(self, powers: Lanes) -> Self {
        Self {
            high: self.high * powers,
            low: self.low * powers,
        }
    }

    /// `of(self, b)` for leading parts and remainders.
    #[inline(always)]
    fn both(self, b: Self, of: impl Fn(Lanes, Lanes) -> Lanes) -> Self {
        Self {
            high: of(self.high, b.high),
            low: of(self.low, b.low),
        }
    }

    /// 1 + self / 1 (1 + self / 2 (1 + ...)).
    #[inline(always)]
    fn exponential_series(self) -> Self {
        /// The remainder for a number within ln 2 / 2 of 0 is below 1e-34.
        const TERMS: u32 = 24;
        let mut sum = Self::ONE;
        for k in (1..=TERMS).rev() {
            let part = self.over(Self::splat(k.into()));
            sum = sum.multiply_add(part, Self::ONE);
        }
        sum
    }

    /// 1 - square / (first (first + 1)) (1 - square / ((first + 2) (first + 3)) (1 - ...)).
    #[inline(always)]
    fn trigonometric_series(square: Self, first: u32) -> Self {
        /// The remainder for a number within pi/4 of 0 is below 1e-34.
        const TERMS: u32 = 15;
        let mut sum = Self::ONE;
        for k in (0..TERMS).rev() {
            let k = first + 2 * k;
            let part = square.over(Self::splat((k * (k + 1)).into()));
            sum = sum.subtract_product(part, Self::ONE);
        }
        sum
    }
}

impl Arithmetic for DoubleDouble {
    const LANES: usize = Portable::LANES;
    const ZERO: Self = Self {
        high: Lanes::ZERO,
        low: Lanes::ZERO,
    };
    const ONE: Self = Self {
        high: Lanes::ONE,
        low: Lanes::ZERO,
    };
    const ROUNDING: f64 = 2.0 * f64::EPSILON * f64::EPSILON;
    const TERMS: u32 = 27;

    fn splat(value: f64) -> Self {
        Self {
            high: Lanes::splat(value),
            low: Lanes::ZERO,
        }
    }

    fn of(value: Self) -> Self {
        value
    }

    fn inverse_of(number: u32) -> Self {
        Self::ONE.over(Self::splat(number.into()))
    }

    fn load(values: &[f64; MOST_LANES]) -> Self {
        Self {
            high: Lanes::new(values),
            low: Lanes::ZERO,
        }
    }

    fn store(self) -> [f64; MOST_LANES] {
        self.high.lanes()
    }

    #[inline(never)]
    fn plus(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        let (low, rest) = two_sum(self.low, other.low);
        let sum = Self::sum(high, error + low);
        Self::sum(sum.high, rest + sum.low)
    }

    fn minus(self, other: Self) -> Self {
        self.plus(other.negative())
    }

    #[inline(never)]
    fn times(self, other: Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        let across = self.high * other.low + self.low * other.high;
        Self::sum(high, error + across)
    }

    #[inline(never)]
    fn over(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let (high, error) = two_product(quotient, other.high);
        let product = Self::sum(high, error + quotient * other.low);
        let rest = (self.high - product.high) + (self.low - product.low);
        Self::sum(quotient, rest / other.high)
    }

    #[inline(never)]
    fn square_root(self) -> Self {
        let root = self.high.sqrt();
        let (square, error) = two_product(root, root);
        let rest = ((self.high - square) - error) + self.low;
        // Zero has no remainder.
        let divisor = Lanes::ZERO.where_less(root, root + root, Lanes::ONE);
        Self::sum(root, rest / divisor)
    }

    fn multiply_add(self, b: Self, c: Self) -> Self {
        self.times(b).plus(c)
    }

    fn subtract_product(self, b: Self, c: Self) -> Self {
        c.minus(self.times(b))
    }

    fn negative(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }

    fn absolute(self) -> Self {
        self.with_sign_of(Self::ONE)
    }

    fn with_sign_of(self, sign: Self) -> Self {
        let sign = Lanes::ONE.with_sign_of(sign.high);
        self.times_exactly(sign * Lanes::ONE.with_sign_of(self.high))
    }

    #[inline(never)]
    fn where_less(self, than: Self, yes: Self, no: Self) -> Self {
        let (high, than_high) = (self.high, than.high);
        let (low, than_low) = (self.low, than.low);
        yes.both(no, |yes, no| {
            let where_equal = low.where_less(than_low, yes, no);
            let not_less = than_high.where_less(high, no, where_equal);
            high.where_less(than_high, yes, not_less)
        })
    }

    fn is_less_somewhere(self, than: Self) -> bool {
        let is_less = self.where_less(than, Self::ONE, Self::ZERO);
        Lanes::ZERO.is_less_somewhere(is_less.high)
    }

    fn inverse_power_of_two(self) -> Self {
        Self {
            high: self.high.inverse_power_of_two(),
            low: Lanes::ZERO,
        }
    }

    /// By its series after halvings: of a number at or below 700; 0 below -700.
    #[inline(never)]
    fn exponential(self) -> Self {
        const SMALLEST: f64 = -700.0;
        const LN_2: [f64; 3] = [
            std::f64::consts::LN_2,
            2.319_046_813_846_299_6e-17,
            5.707_708_438_416_212e-34,
        ];
        let smallest = Self::splat(SMALLEST);
        let clamped = self.where_less(smallest, smallest, self);
        let (bits, times) = rounded_product(clamped.high, std::f64::consts::LOG2_E);
        let series = clamped.reduced(times, LN_2).exponential_series();
        let value = series.times_exactly(bits.power_of_two());
        self.where_less(smallest, Self::ZERO, value)
    }

    /// By their series after quarters of a turn: of a number far below 1e15.
    #[inline(never)]
    fn sine_and_cosine(self) -> (Self, Self) {
        const QUARTER: [f64; 3] = [
            std::f64::consts::FRAC_PI_2,
            6.123_233_995_736_766e-17,
            -1.497_384_904_859_169_8e-33,
        ];
        let (bits, times) = rounded_product(self.high, std::f64::consts::FRAC_2_PI);
        let angle = self.reduced(times, QUARTER);
        let square = angle.times(angle);
        let cosine = Self::trigonometric_series(square, 1);
        let sine = angle.times(Self::trigonometric_series(square, 2));
        let turned = |even: Self, odd: Self, sign: Lanes| {
            let value = odd.both(even, |odd, even| bits.where_bit(0, odd, even));
            Self {
                high: value.high.turned_by_bit(sign, 1),
                low: value.low.turned_by_bit(sign, 1),
            }
        };
        (
            turned(sine, cosine, bits),
            turned(cosine, sine, bits.next_bits()),
        )
    }

    fn outlined<P: Part>(part: P) -> P::Output {
        Portable::outlined(part)
    }
}

impl DoubleDouble {
    /// Less an integer times a constant, which is given in parts.
    #[inline(always)]
    fn reduced<const N: usize>(self, times: Lanes, constant: [f64; N]) -> Self {
        let mut rest = self;
        for part in constant {
            let (high, low) = two_product(times, Lanes::splat(part));
            rest = rest.minus(Self { high, low });
        }
        rest
    }
}

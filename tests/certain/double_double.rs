//! Complex numbers of 32 digits: each part is the unevaluated sum of two doubles.
//!
//! Error-free sum of Knuth, error-free product of Dekker and Veltkamp (Dekker, Numerische Mathematik 18 (1971) 224-242);
//! the operations are those of Hida, Li & Bailey (ARITH-15, 2001).

// Tests are built with little optimisation, which would call a function for each of these.
#![allow(clippy::inline_always)]

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use num_complex::Complex64;

/// A real number.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Double2 {
    high: f64,
    low: f64,
}

/// A complex number.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Complex2 {
    re: Double2,
    im: Double2,
}

/// a + b and its rounding error.
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// The same for |a| >= |b|.
#[inline(always)]
fn renormalised(a: f64, b: f64) -> Double2 {
    let high = a + b;
    Double2 {
        high,
        low: b - (high - a),
    }
}

/// A number as a sum of two numbers of at most 26 bits.
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    // 2^27 + 1.
    let scaled = 134_217_729.0 * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// a b and its rounding error.
#[inline(always)]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

impl From<f64> for Double2 {
    #[inline(always)]
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Double2 {
    /// The nearest double.
    pub fn rounded(self) -> f64 {
        self.high
    }

    /// Times a power of two.
    #[inline(always)]
    fn times_exactly(self, power: f64) -> Self {
        Self {
            high: self.high * power,
            low: self.low * power,
        }
    }
}

impl Add for Double2 {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        let (low, rest) = two_sum(self.low, other.low);
        let sum = renormalised(high, error + low);
        renormalised(sum.high, sum.low + rest)
    }
}

impl Neg for Double2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for Double2 {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double2 {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (product, error) = two_product(self.high, other.high);
        renormalised(
            product,
            error + (self.high * other.low + self.low * other.high),
        )
    }
}

impl Mul<f64> for Double2 {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        let (product, error) = two_product(self.high, other);
        renormalised(product, error + self.low * other)
    }
}

impl Div for Double2 {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let mut rest = self;
        let mut quotient = Self::default();
        for _ in 0..3 {
            let digits = Self::from(rest.high / other.high);
            rest = rest - digits * other;
            quotient = quotient + digits;
        }
        quotient
    }
}

impl Complex2 {
    pub const ZERO: Self = Self {
        re: Double2 {
            high: 0.0,
            low: 0.0,
        },
        im: Double2 {
            high: 0.0,
            low: 0.0,
        },
    };
    pub const ONE: Self = Self {
        re: Double2 {
            high: 1.0,
            low: 0.0,
        },
        im: Double2 {
            high: 0.0,
            low: 0.0,
        },
    };

    pub fn new(re: Double2, im: Double2) -> Self {
        Self { re, im }
    }

    /// The nearest pair of doubles.
    #[inline(always)]
    pub fn rounded(self) -> Complex64 {
        Complex64::new(self.re.high, self.im.high)
    }

    /// Times a power of two.
    #[inline(always)]
    pub fn times_exactly(self, power: f64) -> Self {
        Self::new(self.re.times_exactly(power), self.im.times_exactly(power))
    }

    /// Times a number of 16 digits.
    #[inline(always)]
    pub fn times_short(self, factor: Complex64) -> Self {
        Self::new(
            self.re * factor.re - self.im * factor.im,
            self.re * factor.im + self.im * factor.re,
        )
    }

    /// Times i.
    pub fn turned(self) -> Self {
        Self::new(-self.im, self.re)
    }

    pub fn inverse(self) -> Self {
        let square = self.re * self.re + self.im * self.im;
        Self::new(self.re / square, -self.im / square)
    }
}

impl From<Double2> for Complex2 {
    fn from(re: Double2) -> Self {
        Self::new(re, 0.0.into())
    }
}

impl From<Complex64> for Complex2 {
    fn from(z: Complex64) -> Self {
        Self::new(z.re.into(), z.im.into())
    }
}

impl Add for Complex2 {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl AddAssign for Complex2 {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Neg for Complex2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

impl Sub for Complex2 {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl SubAssign for Complex2 {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Mul for Complex2 {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}

impl Mul<Double2> for Complex2 {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Double2) -> Self {
        Self::new(self.re * other, self.im * other)
    }
}

/// Expected: exact arithmetic.
#[test]
fn numbers_have_32_digits() {
    let large = Double2::from(134_217_729.0);
    // (2^27 + 1)^2 = 2^54 + 2^28 + 1 does not fit 53 bits.
    let rest = large * large - Double2::from(18_014_398_509_481_984.0);
    assert_eq!(rest, Double2::from(268_435_457.0));
    let tiny = Double2::from(1.0) + Double2::from(1e-25);
    assert_eq!((tiny - Double2::from(1.0)).rounded(), 1e-25);
    let third = Double2::from(1.0) / Double2::from(3.0);
    let error = third * Double2::from(3.0) - Double2::from(1.0);
    assert!(error.rounded().abs() < 1e-31, "{error:?}");
    let z = Complex2::from(Complex64::new(0.7, -1e-9));
    let error = (z * z.inverse() - Complex2::ONE).rounded();
    assert!(error.norm() < 1e-31, "{error}");
}

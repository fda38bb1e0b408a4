//! Sums and products with their rounding errors: the error-free sum of Knuth and the error-free product of Dekker and
//! Veltkamp (Dekker 1971, *Numerische Mathematik* 18, 224-242). They need no fused multiply-add.

use std::ops::{Add, Mul, Sub};

/// A number that rounds each operation once, to the nearest; or several of them side by side.
pub(super) trait Rounded:
    Copy + From<f64> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
}

impl Rounded for f64 {}

/// a + b and its rounding error.
#[inline]
pub(super) fn two_sum<T: Rounded>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// The same where b is not larger than a, or a is 0.
#[inline]
pub(super) fn quick_two_sum<T: Rounded>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// Splits a number into two of at most 26 bits.
#[inline]
fn split<T: Rounded>(a: T) -> (T, T) {
    // 2^27 + 1.
    let scaled = T::from(134_217_729.0) * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// a b and its rounding error.
#[inline]
pub(super) fn two_product<T: Rounded>(a: T, b: T) -> (T, T) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: exact arithmetic.
    #[test]
    fn nothing_of_a_sum_or_a_product_is_lost() {
        assert_eq!(two_sum(1e-20, 1.0), (1.0, 1e-20));
        assert_eq!(quick_two_sum(1.0, 1e-20), (1.0, 1e-20));
        // (2^27 + 1)^2 = 2^54 + 2^28 + 1 does not fit 53 bits.
        let large = 134_217_729.0;
        assert_eq!(two_product(large, large), (18_014_398_777_917_440.0, 1.0));
    }
}

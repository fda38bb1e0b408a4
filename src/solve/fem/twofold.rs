//! Sums of products whose terms cancel, in twofold precision.
//!
//! The error-free sum of Knuth and the error-free product of Dekker and Veltkamp (Dekker 1971, *Numerische Mathematik*
//! 18, 224-242).

use num_complex::Complex64;

/// A vector with twice the digits: the second part is below the last digit of the first.
#[derive(Debug, Default)]
pub(super) struct Twofold {
    pub(super) high: Vec<Complex64>,
    low: Vec<Complex64>,
}

impl Twofold {
    /// Sets the length and makes it zero.
    pub(super) fn clear(&mut self, length: usize) {
        for part in [&mut self.high, &mut self.low] {
            part.clear();
            part.resize(length, Complex64::ZERO);
        }
    }

    /// Adds to one entry.
    pub(super) fn add(&mut self, index: usize, value: Complex64) {
        let (high, low) = (&mut self.high[index], &mut self.low[index]);
        (high.re, low.re) = add(high.re, low.re, value.re);
        (high.im, low.im) = add(high.im, low.im, value.im);
    }

    /// The sum of `factors[i] * self[at[i]]`, rounded once at its end.
    pub(super) fn dot(&self, factors: &[f64], at: &[usize]) -> Complex64 {
        let (mut re, mut im) = ((0.0, 0.0), (0.0, 0.0));
        for (&factor, &at) in factors.iter().zip(at) {
            let (high, low) = (self.high[at], self.low[at]);
            re = accumulate(re, factor, high.re, low.re);
            im = accumulate(im, factor, high.im, low.im);
        }
        Complex64::new(re.0 + re.1, im.0 + im.1)
    }
}

/// a + b and its rounding error.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// Splits a number into two of at most 26 bits.
fn split(a: f64) -> (f64, f64) {
    // 2^27 + 1.
    const SPLITTER: f64 = 134_217_729.0;
    let scaled = SPLITTER * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// a b and its rounding error.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

/// (high + low) + value as two parts.
fn add(high: f64, low: f64, value: f64) -> (f64, f64) {
    let (sum, error) = two_sum(high, value);
    two_sum(sum, low + error)
}

/// sum + factor (high + low).
fn accumulate(sum: (f64, f64), factor: f64, high: f64, low: f64) -> (f64, f64) {
    let (product, error) = two_product(factor, high);
    let (total, lost) = two_sum(sum.0, product);
    (total, sum.1 + (lost + error + factor * low))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: exact arithmetic.
    #[test]
    fn what_cancels_keeps_its_digits() {
        let mut x = Twofold::default();
        x.clear(2);
        x.add(0, Complex64::new(1.0, 3.0));
        x.add(0, Complex64::new(1e-20, 0.0));
        x.add(1, Complex64::new(1.0, 9.0));
        let difference = x.dot(&[1.0, -1.0], &[0, 1]);
        assert_eq!(difference, Complex64::new(1e-20, -6.0));
        // (2^27 + 1)^2 = 2^54 + 2^28 + 1 does not fit 53 bits.
        let large = 134_217_729.0;
        x.clear(2);
        x.add(0, large.into());
        x.add(1, (large * large).into());
        assert_eq!(x.dot(&[large, -1.0], &[0, 1]).re, 1.0);
    }
}

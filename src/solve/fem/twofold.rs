//! Sums of products whose terms cancel, in twofold precision.

use num_complex::Complex64;

use crate::solve::error_free::{two_product, two_sum};

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
    }
}

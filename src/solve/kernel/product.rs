//! Products of many factors at several frequencies at once, without overflow.

use super::complex::Complex;
use super::number::{Arithmetic, MOST_LANES, Real};
use crate::solve::linear::Magnified;

/// A product at each frequency, of any size.
#[derive(Debug, Clone, Copy)]
pub(super) struct ScaledProduct<A> {
    mantissa: Complex<A>,
    /// Exponents of two that scale the mantissa.
    exponents: [i64; MOST_LANES],
}

impl<A: Arithmetic> ScaledProduct<A> {
    pub(super) const ONE: Self = Self {
        mantissa: Complex::ONE,
        exponents: [0; MOST_LANES],
    };

    /// Times a number.
    #[inline(always)]
    pub(super) fn times(&mut self, factor: Complex<A>) {
        let product = self.mantissa * factor;
        let scale = product.size().inverse_power_of_two();
        self.mantissa = product.scaled(scale);
        let scales = scale.lanes();
        for lane in 0..A::LANES {
            self.exponents[lane] += 1023 - (scales[lane].to_bits() >> 52) as i64;
        }
    }

    /// The logarithms and directions; `growth` is added to each logarithm.
    #[inline(always)]
    pub(super) fn write(&self, growth: Real<A>, out: &mut [Magnified]) {
        let growth = growth.lanes();
        for (lane, out) in out.iter_mut().enumerate() {
            let mantissa = self.mantissa.lane(lane);
            let norm = mantissa.norm();
            let power = self.exponents[lane] as f64 * std::f64::consts::LN_2;
            *out = Magnified {
                log: norm.ln() + power + growth[lane],
                direction: mantissa / norm,
            };
        }
    }
}

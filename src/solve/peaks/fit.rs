//! The extremum of a response near three neighbouring samples.
//!
//! Near a resonance 1/H is almost linear in the frequency, near an anti-resonance H is. So the complex quadratic
//! through three samples of 1/H (or H) is far more accurate than a parabola through magnitudes, and the extremum of |H|
//! is at the minimum of its modulus. It is Muller's interpolation (Muller, Math. Tables Aids Comput. 1956, 10, 208),
//! evaluated on the real axis. An energy is a sum of squares: it uses the parabola through E (or 1/E) itself.

use num_complex::Complex64;

use super::grid::Feature;
use crate::solve::extrema::Turn;
use crate::solve::{Column, ColumnKind};

/// One sample of a response.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// Hz.
    pub(super) frequency: f64,
    /// In the column's unit.
    pub(super) value: Complex64,
    /// |value|.
    pub(super) size: f64,
}

/// The samples of a column with finite values, by ascending frequency.
pub(super) fn samples(frequencies: &[f64], column: &Column) -> Vec<Sample> {
    let all = frequencies.iter().zip(&column.values);
    all.filter(|(_, value)| value.is_finite())
        .map(|(&frequency, &value)| Sample {
            frequency,
            size: value.norm(),
            value,
        })
        .collect()
}

/// The indices of samples at which |H| has an extremum, and its kind.
pub(super) fn turns(samples: &[Sample]) -> impl Iterator<Item = (usize, Turn)> {
    samples.windows(3).enumerate().filter_map(|(index, three)| {
        let turn = Turn::of([0, 1, 2].map(|i| three[i].size))?;
        Some((index + 1, turn))
    })
}

/// The quadratic through g at three samples: g = 1/H at a peak, H at a dip, divided by |g| at the middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fit {
    kind: ColumnKind,
    turn: Turn,
    /// Frequency of the middle sample, Hz; differences from it are exact even for very close samples.
    middle: f64,
    /// Hz per unit of t.
    scale: f64,
    /// |g| of the middle sample.
    unit: f64,
    /// The coefficients of 1, t and t^2.
    coefficients: [Complex64; 3],
    /// t of the outer samples.
    outer: [f64; 2],
}

impl Fit {
    /// The fit through three samples of ascending frequency; `None` if it is not finite.
    pub(super) fn new(kind: ColumnKind, turn: Turn, samples: &[Sample]) -> Option<Self> {
        let &[a, b, c] = samples else { return None };
        let samples = [a, b, c];
        let g = samples.map(|sample| match turn {
            Turn::Maximum => sample.value.inv(),
            Turn::Minimum => sample.value,
        });
        let unit = g[1].norm();
        let [left, middle, right] = g.map(|g| g / unit);
        let scale = samples[2].frequency - samples[0].frequency;
        let outer = [0, 2].map(|i| (samples[i].frequency - samples[1].frequency) / scale);
        let slopes = [(left - middle) / outer[0], (right - middle) / outer[1]];
        let curvature = (slopes[1] - slopes[0]) / (outer[1] - outer[0]);
        let fit = Self {
            kind,
            turn,
            middle: samples[1].frequency,
            scale,
            unit,
            coefficients: [middle, slopes[0] - curvature * outer[0], curvature],
            outer,
        };
        (unit > 0.0 && fit.coefficients.iter().all(|c| c.is_finite())).then_some(fit)
    }

    /// The position of the minimum of |g|, and the distance at which |g|^2 (of an energy: g) doubles. It is between the
    /// outer samples, because the middle one is smaller; found by golden section.
    pub(super) fn extremum(&self) -> Feature {
        /// Reduces the bracket to 1e-13.
        const STEPS: usize = 62;
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        let [mut left, mut right] = self.outer;
        for _ in 0..STEPS {
            let step = golden * (right - left);
            if self.size(right - step) <= self.size(left + step) {
                right = left + step;
            } else {
                left = right - step;
            }
        }
        let t = 0.5 * (left + right);
        Feature {
            centre: self.frequency(t),
            half_width: self.scale * self.half_width(t),
        }
    }

    /// Slope of |g|^2 (of an energy: of g) at one of the samples over its value at the middle, as a change over the
    /// bracket.
    pub(super) fn slope(&self, frequency: f64) -> f64 {
        let [_, first, second] = self.coefficients;
        let t = self.t(frequency);
        let slope = first + 2.0 * t * second;
        match self.kind {
            ColumnKind::Complex => 2.0 * (self.g(t.into()).conj() * slope).re,
            ColumnKind::Energy => slope.re,
        }
    }

    /// The response at a frequency (Hz) near the samples.
    pub(super) fn value(&self, frequency: f64) -> Complex64 {
        let g = self.unit * self.g(self.t(frequency).into());
        match self.turn {
            Turn::Maximum => g.inv(),
            Turn::Minimum => g,
        }
    }

    /// The complex frequency (Hz) next to an extremum at which g vanishes: for a peak, that of the mode.
    pub(super) fn root(&self, extremum: Feature) -> Complex64 {
        const STEPS: usize = 4;
        if self.kind == ColumnKind::Energy {
            // The squares of H vanish at the root and at its conjugate.
            return Complex64::new(extremum.centre, extremum.half_width);
        }
        let [_, first, second] = self.coefficients;
        let start = Complex64::from(self.t(extremum.centre));
        let t = (0..STEPS).fold(start, |t, _| t - self.g(t) / (first + 2.0 * second * t));
        self.middle + self.scale * t
    }

    /// The position between two frequencies (Hz) where |g| passes `level`, by bisection: |g| is smaller at `inside`.
    pub(super) fn crossing(&self, inside: f64, outside: f64, level: f64) -> f64 {
        const STEPS: usize = 50;
        let (mut inside, mut outside) = (self.t(inside), self.t(outside));
        for _ in 0..STEPS {
            let t = 0.5 * (inside + outside);
            if self.size(t) * self.unit < level {
                inside = t;
            } else {
                outside = t;
            }
        }
        self.frequency(0.5 * (inside + outside))
    }

    fn t(&self, frequency: f64) -> f64 {
        (frequency - self.middle) / self.scale
    }

    fn frequency(&self, t: f64) -> f64 {
        self.middle + self.scale * t
    }

    /// g over `unit`.
    fn g(&self, t: Complex64) -> Complex64 {
        let [constant, first, second] = self.coefficients;
        constant + t * (first + t * second)
    }

    /// |g| over `unit`; a parabola through energies may be negative if the samples are far apart.
    fn size(&self, t: f64) -> f64 {
        let g = self.g(t.into());
        match self.kind {
            ColumnKind::Complex => g.norm_sqr().sqrt(),
            ColumnKind::Energy => g.re,
        }
    }

    /// The distance from the extremum at `t` at which |g|^2 (of an energy: g) doubles, by its curvature there.
    fn half_width(&self, t: f64) -> f64 {
        /// The default if samples are too far apart to give a width.
        const UNKNOWN: f64 = 0.1;
        let [_, first, second] = self.coefficients;
        let g = self.g(t.into());
        let (square, curvature) = match self.kind {
            ColumnKind::Complex => {
                let slope = first + 2.0 * t * second;
                let bent = 2.0 * (g.conj() * second).re;
                (g.norm_sqr(), slope.norm_sqr() + bent)
            }
            ColumnKind::Energy => (g.re, second.re),
        };
        if square < 0.0 || curvature <= 0.0 {
            return UNKNOWN;
        }
        (square / curvature).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fit_of(turn: Turn, response: impl Fn(f64) -> Complex64) -> Fit {
        let column = Column {
            name: String::new(),
            kind: ColumnKind::Complex,
            values: [99.98, 100.003, 100.05].map(response).into(),
        };
        Fit::new(
            column.kind,
            turn,
            &samples(&[99.98, 100.003, 100.05], &column),
        )
        .unwrap()
    }

    /// Closed form: 1/H = c (f - p) of a single mode is a polynomial, so the fit has no error.
    #[test]
    fn a_lone_mode_is_fitted_exactly() {
        let mode = Complex64::new(100.0, 0.01);
        let factor = Complex64::new(3e5, -4e5);
        let fit = fit_of(Turn::Maximum, |f| (factor * (f - mode)).inv());
        let top = fit.extremum();
        assert!((top.centre - 100.0).abs() < 1e-9 && (top.half_width - 0.01).abs() < 1e-9);
        assert!((fit.root(top) - mode).norm() < 1e-9);
        assert!((fit.value(top.centre).norm() / (1.0 / (5e5 * 0.01)) - 1.0).abs() < 1e-9);
        let level = 5e5 * 0.01 * 2.0_f64.sqrt();
        assert!((fit.crossing(100.003, 100.05, level) - 100.01).abs() < 1e-9);
    }

    /// Closed form: H = c (f - z) next to a zero; without damping |H| has a corner there.
    #[test]
    fn a_lone_zero_is_fitted_exactly() {
        for width in [0.01, 0.0] {
            let fit = fit_of(Turn::Minimum, |f| 1e-7 * (f - Complex64::new(100.0, width)));
            let bottom = fit.extremum();
            assert!((bottom.centre - 100.0).abs() < 1e-9, "{bottom:?}");
            assert!((bottom.half_width - width).abs() < 1e-9, "{bottom:?}");
        }
    }
}

//! The derivatives of a peak or an anti-resonance of a response by the parameters.
//!
//! At an extremum f* of P(f) = |H|^2 the derivative of the height is dP/dp alone (the envelope theorem), and that of f*
//! is `-(d2P/df dp) / (d2P/df2)`. P and dP/dp are analytic in f on the real axis: they are interpolated in Chebyshev
//! points around f*, close enough for the series to converge, and the series are differentiated (Trefethen,
//! Approximation Theory and Approximation Practice (2013), Chapters 3 and 8).

use std::f64::consts::{PI, TAU};

use num_complex::Complex64;

use super::Differentiator;
use super::adjoint::Adjoint;
use crate::solve::kernel::Solver;
use crate::solve::linear::ZERO;

/// Chebyshev points of an interval.
const POINTS: usize = 16;

/// A resolved extremum of a response with its derivatives by each parameter, per SI unit (of a phase: per degree), in the
/// order of [`Differentiator::ids`].
#[derive(Debug, Clone, PartialEq)]
pub struct PeakGradient {
    /// Its frequency, Hz.
    pub frequency: f64,
    /// |H|, or `E_V`, there.
    pub height: f64,
    /// The derivatives of the frequency.
    pub frequency_by: Vec<f64>,
    /// The derivatives of the height; 0 if the height itself is 0.
    pub height_by: Vec<f64>,
}

/// An interval around a frequency, Hz.
#[derive(Debug, Clone, Copy)]
struct Interval {
    middle: f64,
    half: f64,
}

impl Differentiator {
    /// The derivatives of the extremum (peak, dip or anti-resonance) of |H| or of `E_V` next to a frequency (Hz); the
    /// response by its index among the enabled ones.
    ///
    /// `None` if no extremum is close enough for a series about the frequency, and at an undamped resonance, whose
    /// height is infinite: see [`Self::mode`].
    pub fn peak(&self, response: usize, frequency: f64) -> Option<PeakGradient> {
        /// The search for a more distant extremum restarts at its estimate.
        const NEAR: f64 = 0.25;
        const MOST_MOVES: usize = 8;
        let mut middle = frequency;
        for _ in 0..MOST_MOVES {
            let (interval, series) = self.interval(response, middle)?;
            let t = extremum(&series)?;
            middle += t * interval.half;
            if t.abs() <= NEAR {
                return self.peak_in(response, interval, &series, t);
            }
        }
        None
    }

    /// The derivatives of the extremum at t of an interval on which the power has a series.
    fn peak_in(
        &self,
        response: usize,
        interval: Interval,
        series: &[f64; POINTS],
        t: f64,
    ) -> Option<PeakGradient> {
        let powers: Vec<Vec<f64>> = interval
            .points()
            .iter()
            .map(|&f| self.power(response, &self.response_at(response, f.into())))
            .collect();
        let curvature = value(&derivative(&derivative(series)), t);
        let frequency_by = (0..self.ids().len()).map(|parameter| {
            let mixed = coefficients(&std::array::from_fn(|point| powers[point][parameter]));
            -value(&derivative(&mixed), t) / curvature * interval.half
        });
        let frequency_by: Vec<f64> = frequency_by.collect();
        let frequency = interval.middle + t * interval.half;
        let gradient = self.response_at(response, frequency.into());
        let height = gradient.value.norm();
        let energy = matches!(self.adjoints[response], Adjoint::Energy);
        let rate = |by: &Complex64| match (energy, height > 0.0) {
            (true, _) => by.re,
            (false, true) => (gradient.value.conj() * by).re / height,
            (false, false) => 0.0,
        };
        let finite = height.is_finite() && frequency_by.iter().all(|by| by.is_finite());
        finite.then(|| PeakGradient {
            frequency,
            height,
            frequency_by,
            height_by: gradient.by_parameter.iter().map(rate).collect(),
        })
    }

    /// The longest interval about a frequency (Hz) on which the series of the power converges, with the series.
    fn interval(&self, response: usize, middle: f64) -> Option<(Interval, [f64; POINTS])> {
        const LONGEST: f64 = 0.02;
        const SHORTEST: f64 = 1e-11;
        const SHORTER: f64 = 0.5;
        /// The largest accepted last terms, relative to the largest term.
        const CONVERGED: f64 = 1e-10;
        let mut interval = Interval {
            middle,
            half: LONGEST * middle,
        };
        while interval.half > SHORTEST * middle {
            let series = coefficients(&self.powers(response, interval.points()));
            let largest = series.iter().map(|term| term.abs()).fold(0.0, f64::max);
            let last = series[POINTS - 3..].iter().map(|term| term.abs());
            if last.fold(0.0, f64::max) <= CONVERGED * largest && largest.is_finite() {
                return Some((interval, series));
            }
            interval.half *= SHORTER;
        }
        None
    }

    /// |H|^2, or an energy, at some frequencies, Hz.
    fn powers(&self, response: usize, frequencies: [f64; POINTS]) -> [f64; POINTS] {
        let omegas = frequencies.map(|frequency| (TAU * frequency).into());
        let mut columns = vec![[ZERO; POINTS]; self.prepared.plan.outputs.len()];
        let mut out: Vec<&mut [Complex64]> =
            columns.iter_mut().map(|column| &mut column[..]).collect();
        Solver::default().solve(&self.prepared, &omegas, &mut out);
        columns[response].map(|value| match self.adjoints[response] {
            Adjoint::Energy => value.re,
            Adjoint::Sum(..) => value.norm_sqr(),
        })
    }
}

impl Interval {
    /// Its Chebyshev points, Hz.
    fn points(self) -> [f64; POINTS] {
        std::array::from_fn(|point| self.middle + self.half * angle(point).cos())
    }
}

/// The angle of a Chebyshev point of the first kind.
fn angle(point: usize) -> f64 {
    PI * (point as f64 + 0.5) / POINTS as f64
}

/// The Chebyshev coefficients of the polynomial through values at the points.
fn coefficients(values: &[f64; POINTS]) -> [f64; POINTS] {
    std::array::from_fn(|degree| {
        let terms = values.iter().enumerate();
        let sum: f64 = terms
            .map(|(point, value)| value * (degree as f64 * angle(point)).cos())
            .sum();
        sum * if degree == 0 { 1.0 } else { 2.0 } / POINTS as f64
    })
}

/// The coefficients of the derivative of a Chebyshev series.
fn derivative(series: &[f64; POINTS]) -> [f64; POINTS] {
    let mut out = [0.0; POINTS];
    for degree in (0..POINTS - 1).rev() {
        let beyond = out.get(degree + 2).copied().unwrap_or_default();
        out[degree] = beyond + 2.0 * (degree + 1) as f64 * series[degree + 1];
    }
    out[0] *= 0.5;
    out
}

/// A Chebyshev series at t in [-1, 1], by Clenshaw's recurrence.
fn value(series: &[f64; POINTS], t: f64) -> f64 {
    let (mut one, mut two) = (0.0, 0.0);
    for &term in series[1..].iter().rev() {
        (one, two) = (term + 2.0 * t * one - two, one);
    }
    series[0] + t * one - two
}

/// The position of an extremum of a series in [-1, 1], or the end at which Newton's steps from 0 leave the interval.
fn extremum(series: &[f64; POINTS]) -> Option<f64> {
    const STEPS: usize = 30;
    const SETTLED: f64 = 1e-13;
    let slope = derivative(series);
    let curvature = derivative(&slope);
    let mut t = 0.0_f64;
    for _ in 0..STEPS {
        let step = value(&slope, t) / value(&curvature, t);
        t -= step;
        if !t.is_finite() {
            return None;
        }
        if t.abs() > 1.0 {
            return Some(t.signum());
        }
        if step.abs() <= SETTLED {
            break;
        }
    }
    Some(t)
}

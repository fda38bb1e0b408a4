//! The distance of the nearest anti-resonance from its target.

use num_complex::Complex64;

use super::super::candidate::{Candidate, Slopes};
use super::super::search::Function;
use super::curve::Curve;
use super::value::{Band, ObjectiveValue};
use crate::solve::Cancelled;
use crate::solve::extrema::Turn;
use crate::solve::sensitivity::Differentiator;

/// The distance from `at` to the nearest complex zero z of the response with Re z in the band, |Re z - at|, Hz.
///
/// If the band has none, it is the larger distance from `at` to an end, times 1 + |H(at)| / the highest |H| in the
/// band: a response that is small at `at` is close to having a zero there.
#[derive(Debug, Clone, Copy)]
pub(in crate::tune) struct AntiResonance {
    pub(super) response: usize,
    pub(super) band: Band,
    /// Hz.
    pub(super) at: f64,
}

/// The result of the search in a band.
enum Found {
    /// A zero, Hz.
    Zero(Complex64),
    /// No zero, and the frequency of the highest point, Hz.
    None(f64),
}

impl AntiResonance {
    /// The distance, and the frequency of the zero.
    pub(super) fn read(&self, candidate: &Candidate) -> Result<ObjectiveValue, Cancelled> {
        // No derivatives by parameters, only by the frequency.
        let slopes = Differentiator::new(&candidate.model);
        Ok(match self.find(candidate, &slopes)? {
            Found::Zero(zero) => ObjectiveValue {
                figure: (zero.re - self.at).abs(),
                places: vec![zero.re],
            },
            Found::None(highest) => {
                let sizes = candidate.sizes(self.response, &[self.at, highest])?;
                ObjectiveValue {
                    figure: self.far() * (1.0 + sizes[0] / sizes[1]),
                    places: Vec::new(),
                }
            }
        })
    }

    /// The distance to both sides, one of which is positive, with dz/dp = -(dH/dp) / (dH/df) at the zero.
    pub(super) fn functions(
        &self,
        candidate: &Candidate,
        slopes: &Slopes,
    ) -> Result<Vec<Function>, Cancelled> {
        let all = slopes.differentiator();
        Ok(match self.find(candidate, all)? {
            Found::Zero(zero) => {
                let gradient = all.response_at(self.response, zero);
                let shift = slopes.by_coordinate(|index| {
                    -(gradient.by_parameter[index] / gradient.by_frequency).re
                });
                let side = |sign: f64| Function {
                    value: sign * (zero.re - self.at),
                    gradient: shift.iter().map(|slope| sign * slope).collect(),
                };
                vec![side(1.0), side(-1.0)]
            }
            Found::None(highest) => {
                let [here, top] = [self.at, highest]
                    .map(|frequency| slopes.size(&slopes.response(self.response, frequency)));
                let ratio = here.value / top.value;
                let change = |(here, top): (&f64, &f64)| self.far() * (here - ratio * top);
                let both = here.gradient.iter().zip(&top.gradient);
                vec![Function {
                    value: self.far() * (1.0 + ratio),
                    gradient: both.map(|both| change(both) / top.value).collect(),
                }]
            }
        })
    }

    /// The larger distance to an end of the band, Hz.
    fn far(&self) -> f64 {
        (self.at - self.band[0]).max(self.band[1] - self.at)
    }

    /// Zeros by Newton's method from each minimum of |H|, from its value and slope at complex frequencies.
    fn find(&self, candidate: &Candidate, slopes: &Differentiator) -> Result<Found, Cancelled> {
        let curve = Curve::new(candidate, self.response, self.band)?;
        let minima = curve.extrema(Turn::Minimum, |_| true)?;
        let zeros = minima
            .iter()
            .filter_map(|point| self.zero(slopes, point.frequency));
        let distance = |zero: &Complex64| (zero.re - self.at).abs();
        let nearest = zeros.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        Ok(nearest.map_or_else(
            || {
                let highest = curve.points.iter().max_by(|a, b| a.size.total_cmp(&b.size));
                Found::None(highest.map_or(self.at, |point| point.frequency))
            },
            Found::Zero,
        ))
    }

    /// The zero that Newton's method finds from a frequency (Hz), if it is in the band.
    fn zero(&self, slopes: &Differentiator, start: f64) -> Option<Complex64> {
        const MOST_STEPS: usize = 30;
        const ROUNDING: f64 = 1e-13;
        let width = self.band[1] - self.band[0];
        let mut zero = Complex64::from(start);
        for _ in 0..MOST_STEPS {
            let here = slopes.response_at(self.response, zero);
            let step = here.value / here.by_frequency;
            if !step.is_finite() {
                return None;
            }
            zero -= step * (0.25 * width / step.norm()).min(1.0);
            if (zero - start).norm() > width {
                return None;
            }
            if step.norm() <= ROUNDING * zero.norm() {
                let inside = self.band[0] <= zero.re && zero.re <= self.band[1];
                return inside.then_some(zero);
            }
        }
        None
    }
}

//! The derivatives of a mean square in a band by the parameters.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;

use super::adjoint::Adjoint;
use super::{Differentiator, Gradient};
use crate::model::Checked;
use crate::solve::modes::Modes;
use crate::solve::{Cancelled, band};

/// The mean square of a response in a band with its derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct MeanSquareGradient {
    /// The value of [`band::levels`]: `1/(f2 - f1) int |H|^2 df`, for an energy the mean of `E_V` itself. Infinite if
    /// an undamped resonance lies in the band.
    pub value: f64,
    /// Per SI unit of each parameter (of a phase: per degree), in the order of [`Differentiator::ids`]; NaN if the
    /// value is infinite.
    pub by_parameter: Vec<f64>,
}

impl Differentiator {
    /// The mean square of a response, by its index among the enabled ones, in a band (Hz, ascending, > 0), with its
    /// derivatives.
    ///
    /// `modes` are the modes of the model up to the end of the band or higher. The frequencies are those of
    /// [`band::levels`] for this response alone.
    ///
    /// # Errors
    /// `cancel` became true before the end.
    pub fn mean_square(
        &self,
        response: usize,
        modes: &Modes,
        band: [f64; 2],
        cancel: &AtomicBool,
    ) -> Result<MeanSquareGradient, Cancelled> {
        let rule = band::rule(&self.alone(response), modes, band, cancel)?;
        if rule.is_empty() {
            return Ok(MeanSquareGradient {
                value: f64::INFINITY,
                by_parameter: vec![f64::NAN; self.ids().len()],
            });
        }
        let at = |&[frequency, weight]: &[f64; 2]| {
            Cancelled::check(cancel)?;
            let gradient = self.response_at(response, frequency.into());
            let power = self.power(response, &gradient);
            Ok(power.into_iter().map(|share| weight * share).collect())
        };
        let shares: Result<Vec<Vec<f64>>, Cancelled> = rule.par_iter().map(at).collect();
        // Sums in order, so that the result does not depend on the number of threads.
        let mut sum = vec![0.0; self.ids().len() + 1];
        for share in shares? {
            sum.iter_mut()
                .zip(share)
                .for_each(|(sum, share)| *sum += share);
        }
        Ok(MeanSquareGradient {
            value: sum.pop().unwrap_or_default(),
            by_parameter: sum,
        })
    }

    /// The model with only one of its enabled responses, by its index.
    fn alone(&self, response: usize) -> Checked {
        self.model.derived(|model| {
            // One that divides it may stay.
            let enabled = model.responses.iter_mut().filter(|of| of.enabled);
            for (index, of) in enabled.enumerate() {
                of.enabled = index == response;
            }
        })
    }

    /// The derivatives of |H|^2 (of an energy: of itself) by each parameter, and its value last.
    pub(super) fn power(&self, response: usize, gradient: &Gradient) -> Vec<f64> {
        let all = gradient.by_parameter.iter();
        if matches!(self.adjoints[response], Adjoint::Energy) {
            return all.chain([&gradient.value]).map(|by| by.re).collect();
        }
        let value = gradient.value;
        let by = all.map(|by| 2.0 * (value.conj() * by).re);
        by.chain([value.norm_sqr()]).collect()
    }
}

//! One candidate model: its responses, and their derivatives by the coordinates.

use std::sync::atomic::AtomicBool;

use num_complex::Complex64;
use rayon::prelude::*;

use super::search::Function;
use crate::model::{Checked, ParameterId};
use crate::solve::modes::{Modes, uncertified};
use crate::solve::sensitivity::{Differentiator, Gradient};
use crate::solve::{Cancelled, sweep};

/// A candidate model.
pub(super) struct Candidate<'a> {
    pub(super) model: Checked,
    /// Up to the highest frequency that an objective needs.
    modes: Modes,
    pub(super) cancel: &'a AtomicBool,
}

impl<'a> Candidate<'a> {
    /// A valid model, with its modes up to `to` (Hz): they only determine grid points, so the proof of their
    /// completeness is skipped. `None` if there are too many modes to list.
    pub(super) fn new(
        model: Checked,
        to: Option<f64>,
        cancel: &'a AtomicBool,
    ) -> Result<Option<Self>, Cancelled> {
        let modes = match to {
            Some(to) => uncertified(&model, to, cancel)?,
            None => Modes::none(),
        };
        Ok((!modes.are_too_many()).then_some(Self {
            model,
            modes,
            cancel,
        }))
    }

    /// Its modes, up to the highest frequency that an objective needs.
    pub(super) fn modes(&self) -> &Modes {
        &self.modes
    }

    /// One response at some frequencies (Hz).
    pub(super) fn values(
        &self,
        response: usize,
        frequencies: &[f64],
    ) -> Result<Vec<Complex64>, Cancelled> {
        let mut frf = sweep(&self.model, frequencies, self.cancel)?;
        Ok(std::mem::take(&mut frf.columns[response].values))
    }

    /// The magnitude of one response, or the energy, at some frequencies (Hz).
    pub(super) fn sizes(
        &self,
        response: usize,
        frequencies: &[f64],
    ) -> Result<Vec<f64>, Cancelled> {
        let values = self.values(response, frequencies)?;
        Ok(values.into_iter().map(Complex64::norm).collect())
    }

    /// Whether a response is an energy.
    pub(super) fn is_energy(&self, response: usize) -> bool {
        let of = self.model.responses.get(response);
        of.is_some_and(|one| one.quantity.is_quadratic())
    }
}

/// The parameters that a coordinate changes, and their rates.
pub(super) type Moved = Vec<(ParameterId, f64)>;

/// The derivatives of the responses of a candidate by the coordinates.
pub(super) struct Slopes {
    differentiator: Differentiator,
    /// For each coordinate the parameters that it changes, by their index in the differentiator, and their rates.
    rates: Vec<Vec<(usize, f64)>>,
}

impl Slopes {
    /// For a model; `moved` are for each coordinate the parameters that it changes, and their rates.
    pub(super) fn new(model: &Checked, moved: &[Moved]) -> Self {
        let differentiator = Differentiator::new(model);
        let known: std::collections::HashMap<ParameterId, usize> = differentiator
            .ids()
            .iter()
            .enumerate()
            .map(|(index, id)| (*id, index))
            .collect();
        // A disabled subsystem has no effect.
        let place = |(id, rate): &(ParameterId, f64)| Some((*known.get(id)?, *rate));
        let rates = moved
            .iter()
            .map(|moved| moved.iter().filter_map(place).collect())
            .collect();
        Self {
            differentiator,
            rates,
        }
    }

    pub(super) fn differentiator(&self) -> &Differentiator {
        &self.differentiator
    }

    /// Converts a derivative by the parameters to one by the coordinates.
    pub(super) fn by_coordinate(&self, by_parameter: impl Fn(usize) -> f64) -> Vec<f64> {
        let of = |rates: &Vec<(usize, f64)>| {
            let terms = rates
                .iter()
                .map(|&(index, rate)| rate * by_parameter(index));
            terms.sum()
        };
        self.rates.iter().map(of).collect()
    }

    /// The derivatives of a response at a frequency (Hz).
    pub(super) fn response(&self, response: usize, frequency: f64) -> Gradient {
        self.differentiator
            .response_at(response, Complex64::from(frequency))
    }

    /// The same at several frequencies (Hz), on all cores.
    pub(super) fn responses(&self, response: usize, frequencies: &[f64]) -> Vec<Gradient> {
        let at = frequencies.par_iter();
        at.map(|frequency| self.response(response, *frequency))
            .collect()
    }

    /// The magnitude of a response at a fixed frequency, or at an extremum, whose shift has no first-order effect.
    pub(super) fn size(&self, gradient: &Gradient) -> Function {
        Function {
            value: gradient.value.norm(),
            gradient: self.by_coordinate(|index| growth(gradient, gradient.by_parameter[index])),
        }
    }
}

/// The derivative of |H| for the derivative `rate` of H.
pub(super) fn growth(gradient: &Gradient, rate: Complex64) -> f64 {
    let size = gradient.value.norm();
    if size == 0.0 {
        0.0
    } else {
        (gradient.value.conj() * rate).re / size
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::checked;
    use crate::solve::modes::{Completeness, Mode, ModeKind, modes};

    #[test]
    fn a_trial_has_the_oscillating_modes_without_their_proof() {
        // Golden: the certified list of the same model.
        let never = AtomicBool::new(false);
        for preset in ["cantilever", "fig06", "fig08"] {
            let model = crate::model::read(crate::presets::find(preset).unwrap().text)
                .unwrap()
                .into_inner();
            let to = model.sweep.to;
            let certified = modes(&checked(&model), to, &never).unwrap();
            assert_eq!(certified.completeness, Completeness::Certain);
            let candidate = Candidate::new(checked(&model), Some(to), &never)
                .unwrap()
                .unwrap();
            let found = candidate.modes();
            assert_ne!(found.completeness, Completeness::Certain);
            let oscillating = |mode: &&Mode| mode.kind == ModeKind::Oscillating;
            let [found, certified] = [found, &certified].map(|list| {
                let modes = list.modes.iter().filter(oscillating);
                modes.map(|mode| mode.omega).collect::<Vec<_>>()
            });
            assert_eq!(found.len(), certified.len(), "{preset}");
            for (found, certified) in found.iter().zip(&certified) {
                assert!(
                    (found - certified).norm() < 1e-9 * certified.norm(),
                    "{preset}"
                );
            }
        }
    }
}

//! The mean of a response's squared magnitude over a band; for an energy the mean of the energy itself.

use super::super::candidate::{Candidate, Slopes};
use super::super::search::Function;
use super::value::{Band, ObjectiveValue};
use crate::solve::Cancelled;
use crate::solve::band::levels;

/// The mean square of a response, in its unit squared, or the mean of an energy.
#[derive(Debug, Clone, Copy)]
pub(in crate::tune) struct MeanSquare {
    pub(super) response: usize,
    pub(super) band: Band,
}

impl MeanSquare {
    /// The mean; infinite if an undamped resonance lies in the band.
    pub(super) fn read(&self, candidate: &Candidate) -> Result<ObjectiveValue, Cancelled> {
        let levels = levels(
            &candidate.model,
            candidate.modes(),
            self.band,
            candidate.cancel,
        )?;
        Ok(ObjectiveValue {
            figure: levels[self.response].mean_square,
            places: Vec::new(),
        })
    }

    /// The mean with its derivatives, integrated together.
    pub(super) fn functions(
        &self,
        candidate: &Candidate,
        slopes: &Slopes,
    ) -> Result<Vec<Function>, Cancelled> {
        let all = slopes.differentiator();
        let mean = all.mean_square(
            self.response,
            candidate.modes(),
            self.band,
            candidate.cancel,
        )?;
        Ok(vec![Function {
            value: mean.value,
            gradient: slopes.by_coordinate(|index| mean.by_parameter[index]),
        }])
    }
}

//! The highest magnitude of a response in a band, over all of its local maxima and the ends of the band.

use super::super::candidate::{Candidate, Slopes};
use super::super::search::Function;
use super::curve::Curve;
use super::value::{Band, ObjectiveValue};
use crate::solve::Cancelled;
use crate::solve::extrema::{Point, Turn};

/// A maximum below this fraction of the highest point cannot be the highest: points are dense enough that none is
/// farther below its peak.
const LIKELY: f64 = 0.8;

/// A maximum below this fraction of the highest does not become the highest within a step of the search.
const RELEVANT: f64 = 0.2;

/// Most maxima whose derivatives are taken.
const MOST: usize = 40;

/// The highest magnitude of a response, in its unit.
#[derive(Debug, Clone, Copy)]
pub(in crate::tune) struct Peak {
    pub(super) response: usize,
    pub(in crate::tune) band: Band,
}

impl Peak {
    /// Of a response in a band.
    pub(in crate::tune) const fn new(response: usize, band: Band) -> Self {
        Self { response, band }
    }

    /// The highest point, with its frequency.
    pub(in crate::tune) fn read(&self, candidate: &Candidate) -> Result<ObjectiveValue, Cancelled> {
        let tops = self.tops(candidate, LIKELY)?;
        let highest = tops.first();
        Ok(ObjectiveValue {
            figure: highest.map_or(f64::NAN, |top| top.size),
            places: highest.map(|top| top.frequency).into_iter().collect(),
        })
    }

    /// The magnitude at each top: to first order the shift of a maximum has no effect (envelope theorem).
    pub(in crate::tune) fn functions(
        &self,
        candidate: &Candidate,
        slopes: &Slopes,
    ) -> Result<Vec<Function>, Cancelled> {
        let tops = self.tops(candidate, RELEVANT)?;
        let places: Vec<f64> = tops.iter().map(|top| top.frequency).take(MOST).collect();
        let gradients = slopes.responses(self.response, &places);
        Ok(gradients.iter().map(|one| slopes.size(one)).collect())
    }

    /// The local maxima and the ends of the band above a fraction of the highest, in descending order.
    fn tops(&self, candidate: &Candidate, share: f64) -> Result<Vec<Point>, Cancelled> {
        let curve = Curve::new(candidate, self.response, self.band)?;
        let least = share * curve.highest();
        let mut tops = curve.extrema(Turn::Maximum, |size| size >= LIKELY * least)?;
        tops.extend(curve.points.first());
        tops.extend(curve.points.last());
        tops.sort_by(|a, b| b.size.total_cmp(&a.size));
        let highest = tops.first().map_or(0.0, |top| top.size);
        tops.retain(|top| top.size >= share * highest);
        Ok(tops)
    }
}

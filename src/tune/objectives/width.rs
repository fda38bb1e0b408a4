//! The widest band below a level.

use super::super::candidate::{Candidate, Slopes, growth};
use super::super::search::Function;
use super::curve::Curve;
use super::value::{Band, ObjectiveValue};
use crate::solve::Cancelled;
use crate::solve::extrema::Turn;

/// The part of the band outside its widest part below a level, Hz.
///
/// If nothing is below the level, it is the whole band times 1 + ln(min |H| / level): continuous where the curve
/// touches the level, and with a gradient above it.
#[derive(Debug, Clone, Copy)]
pub(in crate::tune) struct Width {
    pub(super) response: usize,
    pub(super) band: Band,
    /// The level, in the response's unit.
    pub(super) below: f64,
}

/// The part of a curve below the level.
enum Found {
    /// The widest band below it, Hz.
    Widest([f64; 2]),
    /// None: the frequency of the lowest point, Hz, and its magnitude.
    Nothing(f64, f64),
}

impl Width {
    /// The figure, and the ends of the widest band or the frequency of the lowest point.
    pub(super) fn read(&self, candidate: &Candidate) -> Result<ObjectiveValue, Cancelled> {
        let whole = self.band[1] - self.band[0];
        Ok(match self.find(candidate)? {
            Found::Widest([from, to]) => ObjectiveValue {
                figure: whole - (to - from),
                places: vec![from, to],
            },
            Found::Nothing(at, least) => ObjectiveValue {
                figure: whole * (1.0 + (least / self.below).ln()),
                places: vec![at],
            },
        })
    }

    /// The figure with its derivatives: that of an edge f of |H(f, p)| = level is -(d|H|/dp) / (d|H|/df), an end of the
    /// band is constant.
    pub(super) fn functions(
        &self,
        candidate: &Candidate,
        slopes: &Slopes,
    ) -> Result<Vec<Function>, Cancelled> {
        let whole = self.band[1] - self.band[0];
        Ok(vec![match self.find(candidate)? {
            Found::Widest(edges) => {
                let [from, to] = edges.map(|edge| self.shift(slopes, edge));
                Function {
                    value: whole - (edges[1] - edges[0]),
                    gradient: from.iter().zip(&to).map(|(from, to)| from - to).collect(),
                }
            }
            Found::Nothing(at, least) => {
                let size = slopes.size(&slopes.response(self.response, at));
                Function {
                    value: whole * (1.0 + (least / self.below).ln()),
                    gradient: size
                        .gradient
                        .iter()
                        .map(|slope| whole * slope / least)
                        .collect(),
                }
            }
        }])
    }

    /// The derivative of an edge (Hz) by the coordinates.
    fn shift(&self, slopes: &Slopes, edge: f64) -> Vec<f64> {
        if self.band.contains(&edge) {
            return slopes.by_coordinate(|_| 0.0);
        }
        let gradient = slopes.response(self.response, edge);
        let steepness = growth(&gradient, gradient.by_frequency);
        slopes.by_coordinate(|index| -growth(&gradient, gradient.by_parameter[index]) / steepness)
    }

    fn find(&self, candidate: &Candidate) -> Result<Found, Cancelled> {
        let curve = Curve::new(candidate, self.response, self.band)?;
        // A crossing and return between two points appears at an extremum.
        let maxima = curve.extrema(Turn::Maximum, |size| size < self.below)?;
        let minima = curve.extrema(Turn::Minimum, |size| size >= self.below)?;
        let curve = curve.with(&[maxima, minima].concat());
        let mut ends = vec![self.band[0]];
        ends.extend(curve.crossings(self.below)?);
        ends.push(self.band[1]);
        let is_below = curve
            .points
            .first()
            .is_some_and(|first| first.size < self.below);
        let bands = ends.windows(2).skip(usize::from(!is_below)).step_by(2);
        let widest = bands.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
        if let Some([from, to]) = widest {
            return Ok(Found::Widest([*from, *to]));
        }
        let lowest = curve.points.iter().min_by(|a, b| a.size.total_cmp(&b.size));
        Ok(
            lowest.map_or(Found::Nothing(self.band[0], f64::NAN), |point| {
                Found::Nothing(point.frequency, point.size)
            }),
        )
    }
}

//! The difference of a response from a measured curve.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

use super::super::candidate::{Candidate, Slopes, growth};
use super::super::search::{Function, Residuals};
use super::value::ObjectiveValue;
use crate::model::Compare;
use crate::solve::Cancelled;

/// The root mean square of the difference to a measured curve: dB, or relative to its own root mean square.
#[derive(Debug, Clone)]
pub(in crate::tune) struct Matching {
    pub(super) response: usize,
    pub(super) compare: Compare,
    /// The measured frequencies in the band, Hz.
    pub(super) frequencies: Vec<f64>,
    /// The target values of the response there, in its unit.
    pub(super) values: Vec<Complex64>,
}

impl Matching {
    /// The root mean square.
    pub(super) fn read(&self, candidate: &Candidate) -> Result<ObjectiveValue, Cancelled> {
        let values = candidate.values(self.response, &self.frequencies)?;
        let squares: f64 = self.differences(&values).iter().map(|one| one * one).sum();
        Ok(ObjectiveValue {
            figure: self.of_squares(squares),
            places: Vec::new(),
        })
    }

    /// The root mean square of a sum of squares.
    pub(in crate::tune) fn of_squares(&self, sum: f64) -> f64 {
        (sum / self.frequencies.len() as f64).sqrt()
    }

    /// The root mean square with its derivatives; at 0 it has none, and they are set to 0.
    pub(super) fn functions(&self, slopes: &Slopes) -> Vec<Function> {
        let Residuals { values, jacobian } = self.residuals(slopes);
        let count = self.frequencies.len() as f64;
        let value = self.of_squares(values.norm_squared());
        let slope = if value == 0.0 {
            DVector::zeros(jacobian.ncols())
        } else {
            jacobian.tr_mul(&values) / (count * value)
        };
        vec![Function {
            value,
            gradient: slope.iter().copied().collect(),
        }]
    }

    /// The differences with their derivatives: of levels in dB one per frequency; of complex values real and imaginary
    /// part, over the root mean square of the measured values.
    pub(in crate::tune) fn residuals(&self, slopes: &Slopes) -> Residuals {
        let gradients = slopes.responses(self.response, &self.frequencies);
        let values: Vec<Complex64> = gradients.iter().map(|one| one.value).collect();
        let decibels = 20.0 / std::f64::consts::LN_10;
        let scale = self.scale();
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for one in &gradients {
            let size = one.value.norm();
            match self.compare {
                Compare::LogMagnitude => {
                    rows.push(slopes.by_coordinate(|index| {
                        decibels * growth(one, one.by_parameter[index]) / size
                    }));
                }
                Compare::Complex => rows.extend([
                    slopes.by_coordinate(|index| one.by_parameter[index].re / scale),
                    slopes.by_coordinate(|index| one.by_parameter[index].im / scale),
                ]),
            }
        }
        let columns = rows.first().map_or(0, Vec::len);
        Residuals {
            values: DVector::from_vec(self.differences(&values)),
            jacobian: DMatrix::from_row_iterator(
                rows.len(),
                columns,
                rows.iter().flatten().copied(),
            ),
        }
    }

    /// The residuals of an invalid model.
    pub(in crate::tune) fn worst_residuals(&self, variables: usize) -> Residuals {
        let count = self.frequencies.len();
        Residuals {
            values: DVector::repeat(count, f64::INFINITY),
            jacobian: DMatrix::repeat(count, variables, f64::NAN),
        }
    }

    fn differences(&self, values: &[Complex64]) -> Vec<f64> {
        let both = values.iter().zip(&self.values);
        match self.compare {
            Compare::LogMagnitude => both
                .map(|(own, measured)| 20.0 * (own.norm() / measured.norm()).log10())
                .collect(),
            Compare::Complex => {
                let scale = self.scale();
                both.flat_map(|(own, measured)| {
                    let difference = (own - measured) / scale;
                    [difference.re, difference.im]
                })
                .collect()
            }
        }
    }

    /// The root mean square of the measured values.
    fn scale(&self) -> f64 {
        let squares: f64 = self.values.iter().map(Complex64::norm_sqr).sum();
        (squares / self.values.len() as f64).sqrt()
    }
}

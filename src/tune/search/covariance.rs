//! How well residuals determine the variables of a fit.

use nalgebra::{DMatrix, DVector};

use super::types::{Certainty, Place, Residuals};

/// The covariance of the variables between their bounds: sigma^2 (J^T J)^-1 with sigma^2 = S/(m - n) (for instance Bates &
/// Watts, Nonlinear Regression Analysis and Its Applications, 1988, section 2.3), by the singular values of J.
pub(super) fn certainty(residuals: &Residuals, places: &[Place]) -> Certainty {
    let inside: Vec<usize> = (0..places.len())
        .filter(|&i| places[i] == Place::Inside)
        .collect();
    let (rows, variables) = (residuals.values.len(), inside.len());
    if rows <= variables {
        return Certainty::TooFewResiduals;
    }
    let mut covariance = DMatrix::zeros(places.len(), places.len());
    if inside.is_empty() {
        return Certainty::Covariance(covariance);
    }
    // Columns of equal length: so the singularity does not depend on the units.
    let lengths: Vec<f64> = inside
        .iter()
        .map(|&i| residuals.jacobian.column(i).norm())
        .collect();
    let direction = |of: &DVector<f64>| {
        let mut direction = vec![0.0; places.len()];
        for (&i, part) in inside.iter().zip(of.iter()) {
            direction[i] = *part;
        }
        Certainty::Singular { direction }
    };
    if let Some(blind) = lengths.iter().position(|&length| length == 0.0) {
        return direction(&DVector::from_fn(variables, |i, _| f64::from(i == blind)));
    }
    let scaled = DMatrix::from_fn(rows, variables, |row, column| {
        residuals.jacobian[(row, inside[column])] / lengths[column]
    });
    // R of QR has the singular values of J, and is small.
    let svd = scaled.qr().r().svd(false, true);
    let Some(v_t) = svd.v_t else {
        return Certainty::Unknown;
    };
    let values = svd.singular_values;
    let least = values.imin();
    let rounding = f64::EPSILON * rows as f64;
    if values[least] <= rounding * values.max() {
        let along = DVector::from_fn(variables, |i, _| v_t[(least, i)] / lengths[i]);
        return direction(&along.normalize());
    }
    let variance = residuals.values.norm_squared() / (rows - variables) as f64;
    for (a, &i) in inside.iter().enumerate() {
        for (b, &j) in inside.iter().enumerate() {
            let sum: f64 = (0..variables)
                .map(|k| v_t[(k, a)] * v_t[(k, b)] / values[k].powi(2))
                .sum();
            covariance[(i, j)] = variance * sum / (lengths[a] * lengths[b]);
        }
    }
    Certainty::Covariance(covariance)
}

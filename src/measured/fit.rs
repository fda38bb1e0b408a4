//! The fit of a model to a measured curve.

use num_complex::Complex64;

use super::curve::Curve;
use crate::unit::Kind;

/// The agreement of two curves in a band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Frequency response assurance criterion, 0 to 1 (Heylen & Lammens, 1996): 1 if one curve is a constant times the
    /// other. From magnitudes only if the measured curve has no phase.
    pub frac: f64,
    /// Whether `frac` uses magnitudes only.
    pub of_magnitudes: bool,
    /// Mean level difference, model minus measured, dB.
    pub mean_decibels: f64,
    /// Root mean square of that difference, dB.
    pub rms_decibels: f64,
    /// Points in the band.
    pub points: usize,
}

/// Compares a model's values with a measured curve. The values are at the curve's frequencies and in its unit; `band` is
/// in Hz, with both ends included.
///
/// FRAC = |sum Hm conj(Ha)|^2 / (sum |Hm|^2 sum |Ha|^2), Hm measured and Ha of the model (Heylen & Lammens, FRAC: a
/// consistent way of comparing frequency response functions, Identification in Engineering Systems, Swansea 1996). Levels
/// are 20 log10, for an energy 10 log10. A point at which a curve is 0 has no level and is not in the differences; a point
/// with a non-finite value is ignored.
///
/// None if the numbers of values differ, or if no point in the band has a level on both curves.
pub fn fit(measured: &Curve, model: &[Complex64], band: Option<[f64; 2]>) -> Option<Fit> {
    if measured.frequencies.len() != model.len() {
        return None;
    }
    let [from, to] = band.unwrap_or([0.0, f64::INFINITY]);
    let inside = |frequency: &f64| (from..=to).contains(frequency);
    let pairs: Vec<(Complex64, Complex64)> = measured
        .frequencies
        .iter()
        .zip(measured.values.iter().zip(model))
        .filter(|(frequency, (of_file, of_model))| {
            inside(frequency) && of_file.is_finite() && of_model.is_finite()
        })
        .map(|(_, (measured, of_model))| (*measured, *of_model))
        .collect();
    let factor = if measured.kind == Some(Kind::Energy) {
        10.0
    } else {
        20.0
    };
    let (mean_decibels, rms_decibels) = differences(&pairs, factor)?;
    Some(Fit {
        frac: frac(&pairs, measured.phase_known)?,
        of_magnitudes: !measured.phase_known,
        mean_decibels,
        rms_decibels,
        points: pairs.len(),
    })
}

fn frac(pairs: &[(Complex64, Complex64)], phase_known: bool) -> Option<f64> {
    // Scaled by the largest value, so that squares do not overflow.
    let largest = |of: fn(&(Complex64, Complex64)) -> f64| pairs.iter().map(of).fold(0.0, f64::max);
    let (first, second) = (largest(|pair| pair.0.norm()), largest(|pair| pair.1.norm()));
    if first == 0.0 || second == 0.0 {
        return None;
    }
    let (mut cross, mut measured, mut model) = (Complex64::ZERO, 0.0, 0.0);
    for &(m, a) in pairs {
        let (m, a) = (m / first, a / second);
        cross += if phase_known {
            m * a.conj()
        } else {
            (m.norm() * a.norm()).into()
        };
        measured += m.norm_sqr();
        model += a.norm_sqr();
    }
    let frac = cross.norm_sqr() / (measured * model);
    // Rounding may exceed 1 by a few units in the last place.
    frac.is_finite().then(|| frac.min(1.0))
}

/// Mean and root mean square of the level differences, dB; none without levels.
fn differences(pairs: &[(Complex64, Complex64)], factor: f64) -> Option<(f64, f64)> {
    let levels = pairs.iter().filter_map(|(measured, model)| {
        let difference = factor * (model.norm().log10() - measured.norm().log10());
        difference.is_finite().then_some(difference)
    });
    let (mut count, mut sum, mut squares) = (0.0, 0.0, 0.0);
    for level in levels {
        count += 1.0;
        sum += level;
        squares += level * level;
    }
    (count > 0.0).then(|| (sum / count, f64::sqrt(squares / count)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(values: &[Complex64]) -> Curve {
        Curve {
            name: "H".to_owned(),
            frequencies: (1..=values.len()).map(|f| f as f64).collect(),
            values: values.to_vec(),
            phase_known: true,
            kind: None,
            unknown: Vec::new(),
            notes: Vec::new(),
        }
    }

    const CURVE: [Complex64; 3] = [
        Complex64::new(1.0, 2.0),
        Complex64::new(-3e-3, 0.5),
        Complex64::new(0.1, -7.0),
    ];

    #[track_caller]
    fn near(found: f64, expected: f64) {
        assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    }

    /// Expected: closed form.
    #[test]
    fn a_constant_factor_changes_only_the_level() {
        let same = fit(&measured(&CURVE), &CURVE, None).unwrap();
        near(same.frac, 1.0);
        assert_eq!(
            (same.mean_decibels, same.rms_decibels, same.points),
            (0.0, 0.0, 3)
        );
        let turned = CURVE.map(|value| value * Complex64::new(0.0, 2.0));
        let double = fit(&measured(&CURVE), &turned, None).unwrap();
        near(double.frac, 1.0);
        near(double.mean_decibels, 6.020_599_913_279_624);
        near(double.rms_decibels, 6.020_599_913_279_624);
        let mut energy = measured(&CURVE);
        (energy.kind, energy.phase_known) = (Some(Kind::Energy), false);
        let double = fit(&energy, &turned, None).unwrap();
        near(double.mean_decibels, 3.010_299_956_639_812);
        assert!(double.of_magnitudes);
    }

    /// Expected: closed form. (1, 1) and (1, -1) are orthogonal; (1, 0) and (1, 1) have |1|^2 / (1 x 2).
    #[test]
    fn different_shapes_have_a_lower_frac() {
        let one = Complex64::ONE;
        near(
            fit(&measured(&[one, one]), &[one, -one], None)
                .unwrap()
                .frac,
            0.0,
        );
        near(
            fit(&measured(&[one, Complex64::ZERO]), &[one, one], None)
                .unwrap()
                .frac,
            0.5,
        );
        let mut magnitudes = measured(&[one, one]);
        magnitudes.phase_known = false;
        let found = fit(&magnitudes, &[one, -one], None).unwrap();
        near(found.frac, 1.0);
        assert!(found.of_magnitudes);
        // +6.02 dB and -6.02 dB.
        let found = fit(&measured(&[one, one * 2.0]), &[one * 2.0, one], None).unwrap();
        near(found.mean_decibels, 0.0);
        near(found.rms_decibels, 6.020_599_913_279_624);
        near(found.frac, 0.64);
    }

    #[test]
    fn only_points_in_the_closed_band_count() {
        let mut other = CURVE;
        other[0] *= -5.0;
        let found = fit(&measured(&CURVE), &other, Some([2.0, 3.0])).unwrap();
        near(found.frac, 1.0);
        assert_eq!(found.points, 2);
        assert_eq!(fit(&measured(&CURVE), &other, Some([5.0, 9.0])), None);
        assert_eq!(fit(&measured(&CURVE), &other[..2], None), None);
        assert_eq!(fit(&measured(&CURVE), &[Complex64::ZERO; 3], None), None);
        let (one, zero) = (Complex64::ONE, Complex64::ZERO);
        assert_eq!(fit(&measured(&[one, zero]), &[zero, one], None), None);
    }

    #[test]
    fn points_without_a_level_are_ignored() {
        let mut model = CURVE;
        model[1] = Complex64::ZERO;
        model[2] = Complex64::new(f64::NAN, 0.0);
        let found = fit(&measured(&CURVE), &model, None).unwrap();
        assert_eq!((found.points, found.mean_decibels), (2, 0.0));
        let huge = CURVE.map(|value| value * 1e300);
        let tiny = CURVE.map(|value| value * 1e-300);
        let found = fit(&measured(&huge), &tiny, None).unwrap();
        near(found.frac, 1.0);
        assert!((found.mean_decibels + 12_000.0).abs() < 1e-9);
    }
}

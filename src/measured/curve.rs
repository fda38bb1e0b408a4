//! Measured curves, built from the points of a file.

use num_complex::Complex64;

use super::Question;
use crate::unit::{Kind, ValueUnit};

/// A curve from a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The name in the file, or the file's name.
    pub name: String,
    /// Hz, positive, strictly ascending.
    pub frequencies: Vec<f64>,
    /// One finite value per frequency, in the SI unit of `kind`, or in the unit of the file if the kind is unknown.
    /// Without a phase the real parts are magnitudes and the imaginary parts are 0.
    pub values: Vec<Complex64>,
    /// Whether phases are known; false for magnitudes only.
    pub phase_known: bool,
    /// The quantity of the values; none if neither the file nor a layout gives it.
    pub kind: Option<Kind>,
    /// Unknown unit words, each with the open question. The frequencies or values are then in the unit of the file, not
    /// in SI.
    pub unknown: Vec<(Question, String)>,
    /// Skipped points, changed signs and assumptions made during reading, one sentence each.
    pub notes: Vec<String>,
}

impl Curve {
    /// The unknown word of an open question.
    pub fn unknown_word(&self, question: Question) -> Option<&str> {
        let mut unknown = self.unknown.iter();
        let found = unknown.find(|(asked, _)| *asked == question)?;
        Some(&found.1)
    }
}

/// Builds a curve from the points of a file.
#[derive(Debug, Default)]
pub(super) struct CurveBuilder {
    usable: Vec<(f64, Complex64)>,
    not_positive: usize,
    not_finite: usize,
}

impl CurveBuilder {
    /// Adds a point, frequency in Hz; a non-finite point or a frequency of 0 or below is only counted.
    pub(super) fn push(&mut self, frequency: f64, value: Complex64) {
        if !(frequency.is_finite() && value.is_finite()) {
            self.not_finite += 1;
        } else if frequency > 0.0 {
            self.usable.push((frequency, value));
        } else {
            self.not_positive += 1;
        }
    }

    /// Converts the value to SI, then adds the point.
    pub(super) fn push_in(&mut self, unit: Option<&ValueUnit>, frequency: f64, value: Complex64) {
        self.push(frequency, unit.map_or(value, |unit| unit.to_si(value)));
    }

    /// The curve of the points; none without usable points.
    pub(super) fn curve(
        mut self,
        name: String,
        phase_known: bool,
        kind: Option<Kind>,
    ) -> Option<Curve> {
        let mut notes = Vec::new();
        note(&mut notes, self.not_positive, "at 0 Hz or below skipped");
        note(
            &mut notes,
            self.not_finite,
            "without a finite number skipped",
        );
        if self.usable.windows(2).any(|pair| pair[0].0 > pair[1].0) {
            self.usable.sort_by(|a, b| a.0.total_cmp(&b.0));
            notes.push("frequencies sorted in ascending order".to_owned());
        }
        let before = self.usable.len();
        self.usable.dedup_by(|later, first| later.0 == first.0);
        note(
            &mut notes,
            before - self.usable.len(),
            "with a repeated frequency skipped",
        );
        if !phase_known {
            let negative = self.usable.iter().filter(|point| point.1.re < 0.0).count();
            note(
                &mut notes,
                negative,
                "with the sign removed: only magnitudes are known",
            );
            for point in &mut self.usable {
                point.1 = point.1.norm().into();
            }
        }
        let (frequencies, values): (Vec<f64>, Vec<Complex64>) = self.usable.into_iter().unzip();
        (!frequencies.is_empty()).then_some(Curve {
            name,
            frequencies,
            values,
            phase_known,
            kind,
            unknown: Vec::new(),
            notes,
        })
    }
}

fn note(notes: &mut Vec<String>, count: usize, what: &str) {
    if count > 0 {
        let points = if count == 1 { "point" } else { "points" };
        notes.push(format!("{count} {points} {what}"));
    }
}

/// Numbers curves of the same name: `H`, `H (2)`.
pub(super) fn distinguish(curves: &mut [Curve]) {
    let mut seen = std::collections::HashMap::<String, usize>::new();
    let mut taken: std::collections::HashSet<String> =
        curves.iter().map(|curve| curve.name.clone()).collect();
    for curve in curves {
        let count = seen.entry(curve.name.clone()).or_default();
        *count += 1;
        if *count == 1 {
            continue;
        }
        let mut name = format!("{} ({count})", curve.name);
        while !taken.insert(name.clone()) {
            *count += 1;
            name = format!("{} ({count})", curve.name);
        }
        curve.name = name;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(points: &[(f64, f64)], phase_known: bool) -> Option<Curve> {
        let mut of = CurveBuilder::default();
        for &(frequency, value) in points {
            of.push(frequency, value.into());
        }
        of.curve("H".to_owned(), phase_known, None)
    }

    #[test]
    fn points_become_an_ascending_curve_with_notes() {
        let points = [
            (3.0, 1.0),
            (0.0, 5.0),
            (1.0, f64::NAN),
            (2.0, -4.0),
            (3.0, 6.0),
            (-1.0, 1.0),
        ];
        let made = curve(&points, false).unwrap();
        assert_eq!(made.frequencies, [2.0, 3.0]);
        assert_eq!(made.values, [4.0.into(), 1.0.into()]);
        assert_eq!(
            made.notes,
            [
                "2 points at 0 Hz or below skipped",
                "1 point without a finite number skipped",
                "frequencies sorted in ascending order",
                "1 point with a repeated frequency skipped",
                "1 point with the sign removed: only magnitudes are known"
            ]
        );
        let made = curve(&[(2.0, -4.0), (3.0, 6.0)], true).unwrap();
        assert_eq!(made.values, [(-4.0).into(), 6.0.into()]);
        assert!(made.notes.is_empty());
        assert_eq!(curve(&[(0.0, 1.0)], true), None);
    }

    #[test]
    fn equal_names_get_numbers() {
        let mut curves = vec![curve(&[(1.0, 1.0)], true).unwrap(); 4];
        curves[1].name = "H (2)".to_owned();
        distinguish(&mut curves);
        let names: Vec<&str> = curves.iter().map(|curve| curve.name.as_str()).collect();
        assert_eq!(names, ["H", "H (2)", "H (3)", "H (4)"]);
    }
}

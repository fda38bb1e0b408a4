//! The difference between the responses of a reference method and the exact ones.

use num_complex::Complex64;

use super::sweep::{ColumnKind, Frf};
use crate::model::Checked;
use crate::unit::{Amount, Dimension, Kind, Load, Moves};

/// A motion or force below this fraction of the largest one at the same frequency is rounding error, in both methods.
const RESOLVED: f64 = 1e-12;

/// The difference of one response at one frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Difference {
    /// |other - exact| / |exact|; infinite if only the other is not finite, or only the exact one is 0.
    pub relative: f64,
    /// The difference of the levels, dB, never negative.
    pub decibels: f64,
    /// |other - exact| in the response's unit.
    pub absolute: f64,
}

/// Differences of every response (outer) at every frequency (inner) between two solutions of the same model at the same
/// frequencies; `None` where the exact response is not finite.
///
/// If both solutions of a response are below 1e-12 of the largest motion at a frequency (rotations times the beam's
/// length, velocities and accelerations as displacements), or of the largest force (moments over the length), they differ only by
/// rounding: symmetry may make them 0. They count as equal.
pub fn differences(model: &Checked, exact: &Frf, other: &Frf) -> Vec<Vec<Option<Difference>>> {
    let scales: Vec<Option<Scale>> = model
        .responses
        .iter()
        .filter(|response| response.enabled)
        .map(|response| Scale::of(response.kind(model, None), model.length()))
        .collect();
    let mut out = vec![Vec::new(); exact.columns.len()];
    for (row, &frequency) in exact.frequencies.iter().enumerate() {
        let omega = std::f64::consts::TAU * frequency;
        let size = |frf: &Frf, index: usize, scale: &Scale| {
            frf.columns[index].values[row].norm() * scale.times / omega.powi(scale.order)
        };
        // Motions are compared with motions, forces with forces.
        let floor = |is_force: bool| {
            let all = scales.iter().enumerate();
            let all = all.filter_map(|(index, scale)| Some((index, scale.as_ref()?)));
            let alike = all.filter(|(_, scale)| scale.is_force == is_force);
            let sizes = alike.map(|(index, scale)| size(exact, index, scale));
            RESOLVED * sizes.fold(0.0, f64::max)
        };
        let floors = [floor(false), floor(true)];
        for (index, out) in out.iter_mut().enumerate() {
            let column = &exact.columns[index];
            let (a, b) = (column.values[row], other.columns[index].values[row]);
            let is_rounding = scales[index].as_ref().is_some_and(|scale| {
                let sizes = [exact, other].map(|frf| size(frf, index, scale));
                sizes
                    .iter()
                    .all(|size| *size < floors[usize::from(scale.is_force)])
            });
            let b = if is_rounding { a } else { b };
            out.push(a.is_finite().then(|| Difference::of(a, b, column.kind)));
        }
    }
    out
}

impl Difference {
    fn of(exact: Complex64, other: Complex64, kind: ColumnKind) -> Self {
        if exact == other {
            return Self {
                relative: 0.0,
                decibels: 0.0,
                absolute: 0.0,
            };
        }
        let absolute = (other - exact).norm();
        let relative = absolute / exact.norm();
        let decibels = match kind {
            ColumnKind::Complex => 20.0,
            ColumnKind::Energy => 10.0,
        } * (other.norm() / exact.norm()).log10();
        let or_infinite = |value: f64| if value.is_nan() { f64::INFINITY } else { value };
        Self {
            relative: or_infinite(relative),
            decibels: or_infinite(decibels.abs()),
            absolute: or_infinite(absolute),
        }
    }
}

/// What makes motions comparable, to metres of displacement, and forces, to newtons.
struct Scale {
    is_force: bool,
    /// For a rotation or moment that of a distance of one beam length.
    times: f64,
    /// Of the time derivative.
    order: i32,
}

impl Scale {
    /// None for an energy and a ratio.
    fn of(kind: Kind, length: f64) -> Option<Self> {
        let Kind::Amplitude(Dimension { of, per: None }) = kind else {
            return None;
        };
        let (is_force, times, order) = match of {
            Amount::Motion(moves, measure) => {
                let times = match moves {
                    Moves::Length => 1.0,
                    Moves::Angle => length,
                    Moves::TwistRate => length * length,
                };
                (false, times, measure.order())
            }
            Amount::Load(Load::Force) => (true, 1.0, 0),
            Amount::Load(Load::Moment) => (true, length.recip(), 0),
            Amount::Load(Load::Bimoment) => (true, length.powi(-2), 0),
        };
        Some(Self {
            is_force,
            times,
            order,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::model::checked;
    use crate::solve::Column;

    fn frf(model: &Model, values: &[f64]) -> Frf {
        let responses = model.responses.iter().zip(values);
        Frf {
            frequencies: vec![10.0],
            columns: responses
                .map(|(response, value)| Column {
                    name: response.name.clone(),
                    kind: ColumnKind::Complex,
                    values: vec![Complex64::from(*value)],
                })
                .collect(),
        }
    }

    /// Expected: by hand; 1.01 to 1 is 1 % and 20 lg 1.01 dB.
    #[test]
    fn differences_are_relative_to_the_exact_response() {
        let model = crate::model::read(crate::presets::find("fig08").unwrap().text)
            .unwrap()
            .into_inner();
        let exact = frf(&model, &[1.0, 1e-20, f64::NAN]);
        let other = frf(&model, &[1.01, 2e-20, 1.0]);
        let found = differences(&checked(&model), &exact, &other);
        let first = found[0][0].unwrap();
        assert!((first.relative - 0.01).abs() < 1e-15);
        assert!((first.decibels - 0.086_427_475_652_851_57).abs() < 1e-13);
        assert_eq!(found[1][0].unwrap().relative, 0.0);
        assert_eq!(found[2][0], None);
    }

    #[test]
    fn a_witness_without_a_finite_answer_is_infinitely_wrong() {
        let model = crate::model::read(crate::presets::find("fig08").unwrap().text)
            .unwrap()
            .into_inner();
        let exact = frf(&model, &[1.0, 0.0, 1.0]);
        let other = frf(&model, &[f64::NAN, 1.0, f64::INFINITY]);
        for found in differences(&checked(&model), &exact, &other) {
            let found = found[0].unwrap();
            assert_eq!([found.relative, found.decibels], [f64::INFINITY; 2]);
        }
    }
}

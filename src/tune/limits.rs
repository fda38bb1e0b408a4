//! The limits of the tuned model, as numbers that must not be above 0, with their derivatives.

use num_complex::Complex64;

use super::candidate::{Candidate, Moved, Slopes};
use super::objectives::Peak;
use super::search::Function;
use crate::model::schema::SubsystemKey;
use crate::model::{Checked, Group, Limit, Model, ParameterId, check_state, edit};
use crate::solve::Cancelled;
use crate::solve::modes::{
    buckling_factor, buckling_factors, count, modes, undamped, without_damping,
};

/// A limit of a model, with its responses by index.
#[derive(Debug, Clone)]
pub(super) enum Bound {
    /// (mass - most) / most of all enabled subsystems together.
    AddedMass { at_most: f64 },
    /// For each undamped mode its depth inside the band, over the width of the band; negative outside.
    NoMode { band: [f64; 2] },
    /// (|H| - most) / most for each of the highest peaks in the band.
    Peak { peak: Peak, at_most: f64 },
    /// (|H| at rest - most) / most.
    StaticDeflection { response: usize, at_most: f64 },
    /// least / factor - 1 for each of the least factors on the axial force at which the beam buckles; none in tension.
    Buckling { at_least: f64 },
}

impl Bound {
    /// The bound of a limit; `sweep` is the band of the model, Hz, and `place` gives the index of a response by its name.
    pub(super) fn new(limit: &Limit, sweep: [f64; 2], place: impl Fn(&str) -> usize) -> Self {
        match limit {
            Limit::Peak { response, at_most } => Self::Peak {
                peak: Peak::new(place(response), sweep),
                at_most: *at_most,
            },
            Limit::AddedMass { at_most } => Self::AddedMass { at_most: *at_most },
            Limit::NoMode { from, to } => Self::NoMode { band: [*from, *to] },
            Limit::StaticDeflection { response, at_most } => Self::StaticDeflection {
                response: place(response),
                at_most: *at_most,
            },
            Limit::Buckling { at_least } => Self::Buckling {
                at_least: *at_least,
            },
        }
    }

    /// The highest frequency up to which it needs the modes of the candidate, Hz; none if it needs none.
    pub(super) const fn modes_to(&self) -> Option<f64> {
        match self {
            Self::Peak { peak, .. } => Some(peak.band[1]),
            Self::AddedMass { .. }
            | Self::NoMode { .. }
            | Self::StaticDeflection { .. }
            | Self::Buckling { .. } => None,
        }
    }

    /// The numbers that must not be above 0; those far below may be omitted.
    pub(super) fn values(&self, candidate: &Candidate) -> Result<Vec<f64>, Cancelled> {
        Ok(match self {
            Self::AddedMass { at_most } => vec![added_mass(&candidate.model) / at_most - 1.0],
            Self::NoMode { band } => {
                let inside = |frequency: &f64| depth(*frequency, *band);
                match intruders(candidate, *band)? {
                    Some(all) => all.iter().map(inside).collect(),
                    None => vec![f64::INFINITY],
                }
            }
            Self::Peak { peak, at_most } => vec![peak.read(candidate)?.figure / at_most - 1.0],
            Self::StaticDeflection { response, at_most } => {
                let deflection = at_rest(candidate, *response)?.norm();
                vec![deflection / at_most - 1.0]
            }
            Self::Buckling { at_least } => {
                let factors = buckling_factors(&candidate.model, *at_least, WAYS);
                let excess = |factor: f64| excess(Some(factor), *at_least);
                factors.into_iter().map(excess).collect()
            }
        })
    }

    /// The same with derivatives by the coordinates, which change `moved`.
    pub(super) fn functions(
        &self,
        candidate: &Candidate,
        slopes: &Slopes,
        moved: &[Moved],
    ) -> Result<Vec<Function>, Cancelled> {
        Ok(match self {
            Self::AddedMass { at_most } => vec![added_mass_function(candidate, moved, *at_most)],
            Self::NoMode { band } => modes_in(candidate, moved, *band)?,
            Self::Peak { peak, at_most } => {
                let relative = |of: Function| Function {
                    value: of.value / at_most - 1.0,
                    gradient: of.gradient.iter().map(|slope| slope / at_most).collect(),
                };
                let peaks = peak.functions(candidate, slopes)?.into_iter();
                peaks.map(relative).collect()
            }
            Self::StaticDeflection { response, at_most } => {
                vec![deflection(candidate, slopes, *response, *at_most)]
            }
            Self::Buckling { at_least } => buckling(candidate, moved, *at_least),
        })
    }

    /// The value for display: the mass, kg; the frequency of the mode deepest in the band or nearest to it, Hz; the peak or the
    /// deflection, in the response's unit; the least factor at which the beam buckles.
    pub(super) fn reading(&self, candidate: &Candidate) -> Result<f64, Cancelled> {
        Ok(match self {
            Self::AddedMass { .. } => added_mass(&candidate.model),
            Self::NoMode { band } => {
                let all = undamped(&candidate.model, SEEN * band[1], candidate.cancel)?;
                let deeper = |a: &f64, b: &f64| depth(*a, *band).total_cmp(&depth(*b, *band));
                all.into_iter().flatten().max_by(deeper).unwrap_or(f64::NAN)
            }
            Self::Peak { peak, .. } => peak.read(candidate)?.figure,
            Self::StaticDeflection { response, .. } => at_rest(candidate, *response)?.norm(),
            Self::Buckling { .. } => {
                let factor = buckling_factor(&candidate.model).filter(|factor| *factor > 0.0);
                factor.unwrap_or(f64::INFINITY)
            }
        })
    }
}

/// The search for modes extends to this multiple of the end of a band, and that for buckling to this multiple of the
/// least factor.
const SEEN: f64 = 2.0;

/// The highest frequency up to which a limit needs the modes, Hz; `None` if it needs none.
pub(super) fn looks_to(limit: &Limit) -> Option<f64> {
    match limit {
        Limit::NoMode { to, .. } => Some(SEEN * to),
        Limit::AddedMass { .. }
        | Limit::Peak { .. }
        | Limit::StaticDeflection { .. }
        | Limit::Buckling { .. } => None,
    }
}

/// The masses of all enabled subsystems, kg.
fn added_mass(model: &Checked) -> f64 {
    model.attached().map(|subsystem| subsystem.mass).sum()
}

fn added_mass_function(candidate: &Candidate, moved: &[Moved], at_most: f64) -> Function {
    let is_added = |id: ParameterId| match id.group {
        Group::Subsystem(i) => {
            id.row == SubsystemKey::Mass as usize && candidate.model.subsystems[i].enabled
        }
        _ => false,
    };
    let of = |moved: &Moved| -> f64 {
        let masses = moved.iter().filter(|(id, _)| is_added(*id));
        masses.map(|(_, rate)| rate / at_most).sum()
    };
    Function {
        value: added_mass(&candidate.model) / at_most - 1.0,
        gradient: moved.iter().map(of).collect(),
    }
}

/// The depth of a frequency inside a band, over its width: 0.5 in the middle, 0 at the ends, negative outside.
fn depth(frequency: f64, [from, to]: [f64; 2]) -> f64 {
    (frequency - from).min(to - frequency) / (to - from)
}

/// The undamped modes in a band (Hz); `None` if there are too many below its end. If the count of Wittrick & Williams
/// is the same at both ends, there is no search.
fn intruders(candidate: &Candidate, [from, to]: [f64; 2]) -> Result<Option<Vec<f64>>, Cancelled> {
    if count(&candidate.model, from) == count(&candidate.model, to) {
        return Ok(Some(Vec::new()));
    }
    let all = undamped(&candidate.model, to, candidate.cancel)?;
    let inside = |all: Vec<f64>| {
        let inside = all.into_iter().filter(|one| *one > from && *one < to);
        inside.collect()
    };
    Ok(all.map(inside))
}

/// The depth of each mode in a band, or within its width on both sides.
fn modes_in(
    candidate: &Candidate,
    moved: &[Moved],
    band: [f64; 2],
) -> Result<Vec<Function>, Cancelled> {
    let [from, to] = band;
    let width = to - from;
    let model = without_damping(&candidate.model);
    let near = modes(&model, to + width, candidate.cancel)?;
    if near.are_too_many() {
        return Ok(vec![Function::worst(moved.len())]);
    }
    let slopes = Slopes::new(&model, moved);
    let function = |index: usize| {
        let frequency = near.modes[index].frequency();
        let shift = slopes.differentiator().mode(&near, index).frequency;
        let sign = if 2.0 * frequency < from + to {
            1.0
        } else {
            -1.0
        };
        Function {
            value: depth(frequency, band),
            gradient: slopes.by_coordinate(|index| sign * shift[index] / width),
        }
    };
    let lowest = (from - width).max(0.0);
    let indices = 0..near.modes.len();
    let inside = indices.filter(|&index| near.modes[index].frequency() > lowest);
    Ok(inside.map(function).collect())
}

/// The weights of a cubic through f, 2 f, 3 f and 4 f for its value at 0 Hz.
const TO_REST: [f64; 4] = [4.0, -6.0, 4.0, -1.0];

/// The lowest frequency of the extrapolation to the response at rest: a hundredth of the first mode's or less, so that
/// the error of the cubic is below 1e-5. `None` if a mode is at 0 Hz: such a beam has no rest position.
fn lowest(model: &Checked) -> Option<f64> {
    const SHARE: f64 = 50.0;
    const HIGHEST: f64 = 1.0;
    const HALVINGS: usize = 20;
    let mut frequency = HIGHEST;
    for _ in 0..HALVINGS {
        if count(model, SHARE * frequency) == 0 {
            return Some(frequency);
        }
        frequency *= 0.5;
    }
    None
}

/// A response at rest; infinite if the beam can move freely.
pub(super) fn at_rest(candidate: &Candidate, response: usize) -> Result<Complex64, Cancelled> {
    let Some(lowest) = lowest(&candidate.model) else {
        return Ok(Complex64::from(f64::INFINITY));
    };
    let places = [1.0, 2.0, 3.0, 4.0].map(|times| times * lowest);
    let values = candidate.values(response, &places)?;
    let terms = values.iter().zip(TO_REST);
    Ok(terms.map(|(value, weight)| weight * value).sum())
}

fn deflection(candidate: &Candidate, slopes: &Slopes, response: usize, at_most: f64) -> Function {
    let Some(lowest) = lowest(&candidate.model) else {
        return Function {
            value: f64::INFINITY,
            gradient: slopes.by_coordinate(|_| 0.0),
        };
    };
    let places = [1.0, 2.0, 3.0, 4.0].map(|times| times * lowest);
    let gradients = slopes.responses(response, &places);
    let value: Complex64 = gradients
        .iter()
        .zip(TO_REST)
        .map(|(one, weight)| weight * one.value)
        .sum();
    let change = |index: usize| -> Complex64 {
        let terms = gradients.iter().zip(TO_REST);
        terms
            .map(|(one, weight)| weight * one.by_parameter[index])
            .sum()
    };
    let size = value.norm();
    Function {
        value: size / at_most - 1.0,
        gradient: slopes.by_coordinate(|index| {
            (value.conj() * change(index)).re / (size.max(f64::MIN_POSITIVE) * at_most)
        }),
    }
}

/// How many factors at which a beam buckles count: at the best of a column two are often equal (Olhoff & Rasmussen, Int.
/// J. Solids Structures 13 (1977) 605-614), and one alone would have a kink there.
const WAYS: usize = 2;

/// How far a factor is below the least one: 0 at it, -1 infinitely far above.
fn excess(factor: Option<f64>, at_least: f64) -> f64 {
    factor.map_or(-1.0, |factor| at_least / factor - 1.0)
}

/// The factors near the least one. Their derivatives are central differences over a small step of each coordinate,
/// one-sided where a step makes the model impossible: a factor comes from a count of modes, which has no derivative.
fn buckling(candidate: &Candidate, moved: &[Moved], at_least: f64) -> Vec<Function> {
    /// Of the unit box. The error of a difference is about the step squared; rounding adds 1e-12 over it.
    const STEP: f64 = 1e-5;
    let factors = |model: &Checked, times: f64| buckling_factors(model, times * at_least, WAYS);
    let here = factors(&candidate.model, SEEN);
    if here.is_empty() {
        return Vec::new();
    }
    // Each side of each coordinate: the step, and the factors there.
    let side = |moved: &Moved, step: f64| {
        let mut model = Model::clone(&candidate.model);
        for (id, rate) in moved {
            let value = edit::number(&model, *id).ok()? + rate * step;
            edit::put(&mut model, *id, edit::Value::Number(value)).ok()?;
        }
        if !check_state(&model).is_empty() {
            return None;
        }
        let model = candidate.model.derived(|of| *of = model);
        Some((step, factors(&model, 2.0 * SEEN)))
    };
    let sides: Vec<_> = moved
        .iter()
        .map(|moved| [-STEP, STEP].map(|step| side(moved, step).unwrap_or((0.0, here.clone()))))
        .collect();
    let function = |way: usize| {
        let at = |factors: &Vec<f64>| excess(factors.get(way).copied(), at_least);
        let slope = |[low, high]: &[(f64, Vec<f64>); 2]| {
            (at(&high.1) - at(&low.1)) / (high.0 - low.0).max(f64::MIN_POSITIVE)
        };
        Function {
            value: at(&here),
            gradient: sides.iter().map(slope).collect(),
        }
    };
    (0..here.len()).map(function).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;
    use std::sync::atomic::AtomicBool;

    use super::*;
    use crate::model::schema::{BeamKey, SectionKey};
    use crate::model::{Part, Support, checked};

    /// Closed form: a pinned column buckles at pi^2 E I / (L^2 N), in both planes; the excess over a least factor and its
    /// derivatives follow.
    #[test]
    fn the_derivatives_of_a_buckling_factor_are_those_of_euler() {
        const AT_LEAST: f64 = 2.0;
        let mut model = crate::model::read(crate::presets::find("tie_rod").unwrap().text)
            .unwrap()
            .into_inner();
        (model.supports.left, model.supports.right) = (Support::PINNED, Support::PINNED);
        let (length, modulus) = (model.beam.length, model.beam.material.young_modulus);
        let weak = model.beam.section.second_moment_y;
        let strong = 1.5 * weak;
        model.beam.section.second_moment_z = strong;
        model.beam.section.polar_moment = weak + strong;
        let euler = |second: f64| PI * PI * modulus * second / (length * length);
        // The weaker plane has a factor of 2.5, the other one 3.75: both within twice the least one.
        let force = -euler(weak) / 2.5;
        model.beam.axial_force = force;
        let never = AtomicBool::new(false);
        let candidate = Candidate::new(checked(&model), None, &never)
            .unwrap()
            .unwrap();
        let section = |key: SectionKey| Group::Section(Part::Whole).parameter(key as usize);
        let beam = |key: BeamKey| Group::Beam.parameter(key as usize);
        let moved = [
            vec![(section(SectionKey::SecondMomentY), weak)],
            vec![(section(SectionKey::SecondMomentZ), strong)],
            vec![(beam(BeamKey::Length), length)],
            vec![(beam(BeamKey::AxialForce), force)],
        ];
        let found = buckling(&candidate, &moved, AT_LEAST);
        assert_eq!(found.len(), 2);
        // 1 / factor goes like L^2 N / I.
        for (function, (factor, powers)) in found
            .iter()
            .zip([(2.5, [-1.0, 0.0, 2.0, 1.0]), (3.75, [0.0, -1.0, 2.0, 1.0])])
        {
            let part = AT_LEAST / factor;
            assert!((function.value - (part - 1.0)).abs() < 1e-9);
            for (slope, power) in function.gradient.iter().zip(powers) {
                assert!((slope - power * part).abs() < 1e-6, "{function:?}");
            }
        }
        let bound = Bound::Buckling { at_least: AT_LEAST };
        assert_eq!(bound.values(&candidate), Ok(Vec::new()));
        assert!((bound.reading(&candidate).unwrap() - 2.5).abs() < 1e-9);
    }
}

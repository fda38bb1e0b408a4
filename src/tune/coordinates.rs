//! The variables of `[tune]` as coordinates from 0 to 1, and back.

use crate::model::edit::{self, Value};
use crate::model::{Checked, Fault, Hold, Model, ParameterId, Spacing, Variable};

/// One variable: a coordinate of the unit box, and its parameters.
#[derive(Debug, Clone)]
pub(super) struct Coordinate {
    pub(super) variable: Variable,
    spacing: Spacing,
    /// Its parameters with their values in the model, the leading one first.
    pub(super) parameters: Vec<(ParameterId, f64)>,
}

impl Coordinate {
    /// Resolves the paths of a variable.
    ///
    /// # Errors
    /// A path matches no number, or a ratio refers to a first parameter that is 0.
    pub(super) fn new(model: &Checked, variable: &Variable) -> Result<Self, Fault> {
        // Rejects a ratio to 0.
        variable.applied(model, variable.min)?;
        Ok(Self {
            spacing: variable.spacing(model),
            parameters: variable.parameters(model)?,
            variable: variable.clone(),
        })
    }

    /// The value of the first parameter in the model, in its unit.
    pub(super) fn start(&self) -> f64 {
        self.parameters.first().map_or(f64::NAN, |first| first.1)
    }

    /// The first parameter at a coordinate; exactly a bound at 0 and 1.
    pub(super) fn value(&self, x: f64) -> f64 {
        let (min, max) = (self.variable.min, self.variable.max);
        if x <= 0.0 {
            return min;
        }
        if x >= 1.0 {
            return max;
        }
        match self.spacing {
            Spacing::Linear => min + x * (max - min),
            Spacing::Log => min * (x * (max / min).ln()).exp(),
        }
    }

    /// The coordinate of a value of the first parameter, at a bound if it is outside.
    pub(super) fn coordinate(&self, value: f64) -> f64 {
        let (min, max) = (self.variable.min, self.variable.max);
        let value = value.clamp(min, max);
        match self.spacing {
            Spacing::Linear => (value - min) / (max - min),
            Spacing::Log => (value / min).ln() / (max / min).ln(),
        }
    }

    /// The derivative of the first parameter by the coordinate.
    pub(super) fn slope(&self, x: f64) -> f64 {
        let (min, max) = (self.variable.min, self.variable.max);
        match self.spacing {
            Spacing::Linear => max - min,
            Spacing::Log => self.value(x) * (max / min).ln(),
        }
    }

    /// The value of each parameter for a value of the first one.
    pub(super) fn values(&self, first: f64) -> impl Iterator<Item = (ParameterId, f64)> {
        let start = self.start();
        let of = move |value: f64| match self.variable.hold {
            Hold::Equal => first,
            Hold::Ratio => value * (first / start),
        };
        let all = self.parameters.iter().enumerate();
        all.map(move |(index, (id, value))| {
            let value = if index == 0 { first } else { of(*value) };
            (*id, value)
        })
    }

    /// The derivative of each parameter by the first one.
    pub(super) fn rates(&self) -> impl Iterator<Item = (ParameterId, f64)> {
        let start = self.start();
        let all = self.parameters.iter().enumerate();
        all.map(move |(index, (id, value))| {
            let rate = match self.variable.hold {
                Hold::Ratio if index > 0 => value / start,
                _ => 1.0,
            };
            (*id, rate)
        })
    }

    /// Sets its parameters in a model of the same structure.
    pub(super) fn set(&self, model: &mut Model, first: f64) {
        for (id, value) in self.values(first) {
            let set = edit::put(model, id, Value::Number(value));
            debug_assert!(set.is_ok(), "{id:?} was a number before");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::checked;

    fn coordinate(scale: Spacing, hold: Hold) -> Coordinate {
        let model = crate::model::read(crate::presets::find("fig05a").unwrap().text)
            .unwrap()
            .into_inner();
        let variable = Variable {
            paths: vec!["subsystems.S1.mass".into(), "subsystems.*.inertia".into()],
            hold,
            min: 10.0,
            max: 1000.0,
            scale: Some(scale),
            tolerance: 0.0,
        };
        Coordinate::new(&checked(&model), &variable).unwrap()
    }

    #[test]
    fn coordinates_and_values_are_each_other_s_inverse() {
        for spacing in [Spacing::Linear, Spacing::Log] {
            let one = coordinate(spacing, Hold::Equal);
            for x in [0.0, 0.1, 0.5, 0.9, 1.0] {
                assert!((one.coordinate(one.value(x)) - x).abs() < 1e-14);
                // Closed form, by a central difference that is exact to its square.
                let difference =
                    (one.value(x.min(0.9) + 1e-5) - one.value(x.min(0.9) - 1e-5)) / 2e-5;
                let slope = one.slope(x.min(0.9));
                assert!(x == 0.0 || (difference / slope - 1.0).abs() < 1e-8, "{x}");
            }
            assert_eq!([one.value(0.0), one.value(1.0)], [10.0, 1000.0]);
            assert_eq!([one.coordinate(1.0), one.coordinate(2000.0)], [0.0, 1.0]);
        }
        assert!((coordinate(Spacing::Log, Hold::Equal).value(0.5) - 100.0).abs() < 1e-12);
    }

    #[test]
    fn followers_are_equal_or_keep_their_ratio() {
        let equal: Vec<f64> = coordinate(Spacing::Log, Hold::Equal)
            .values(50.0)
            .map(|(_, v)| v)
            .collect();
        assert_eq!(equal, [50.0; 4]);
        let ratio = coordinate(Spacing::Log, Hold::Ratio);
        // The mass is 100 kg and the inertias 53.33 kg m2 in the file.
        let values: Vec<f64> = ratio.values(50.0).map(|(_, v)| v).collect();
        assert_eq!(values, [50.0, 53.33 * 0.5, 53.33 * 0.5, 53.33 * 0.5]);
        let rates: Vec<f64> = ratio.rates().map(|(_, v)| v).collect();
        assert_eq!(rates[0], 1.0);
        assert!((rates[1] - 0.5333).abs() < 1e-15);
    }
}

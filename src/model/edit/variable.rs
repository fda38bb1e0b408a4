//! The parameters that a variable of a tuning changes, and their new values.

use std::collections::HashSet;

use crate::model::fault::Fault;
use crate::model::id::ParameterId;
use crate::model::path;
use crate::model::tuning::{Hold, Variable};
use crate::model::types::{Model, Spacing};

impl Variable {
    /// The parameters it changes with their current values, each once; the bounds apply to the first.
    ///
    /// # Errors
    /// A path matches nothing, or a parameter without a number now: a fixed motion has no spring.
    pub fn parameters(&self, model: &Model) -> Result<Vec<(ParameterId, f64)>, Fault> {
        let (mut all, mut seen) = (Vec::new(), HashSet::new());
        for pattern in &self.paths {
            let found = path::numbers_of(model, pattern)?.into_iter();
            all.extend(found.filter(|(id, _)| seen.insert(*id)));
        }
        Ok(all)
    }

    /// The new values of its parameters if the first one is `value`, in the order of [`parameters`](Self::parameters).
    /// If
    /// `value` is the current one, all ratios stay exact to the last bit.
    ///
    /// # Errors
    /// As [`parameters`](Self::parameters), or the first parameter is 0 and others keep a ratio to it.
    pub fn applied(&self, model: &Model, value: f64) -> Result<Vec<(ParameterId, f64)>, Fault> {
        let mut all = self.parameters(model)?;
        let Some((first, others)) = all.split_first_mut() else {
            return Ok(all);
        };
        if self.hold == Hold::Ratio && first.1 == 0.0 && !others.is_empty() {
            let message =
                "is 0; must be another number, so that others can keep their ratios to it";
            return Err(Fault::new(path::text(model, first.0), message));
        }
        for (_, other) in others {
            *other = match self.hold {
                Hold::Equal => value,
                Hold::Ratio => *other * (value / first.1),
            };
        }
        first.1 = value;
        Ok(all)
    }

    /// The scale of the search: [`scale`](Self::scale) if given; else logarithmic for a stiffness or damping with a
    /// lower bound above 0, linear otherwise.
    pub fn spacing(&self, model: &Model) -> Spacing {
        let first = || {
            let ids = self.paths.first()?.parameters(model).ok()?;
            ids.first().copied()
        };
        self.scale.unwrap_or_else(|| match first() {
            Some(first) if first.key().is_spring && self.min > 0.0 => Spacing::Log,
            _ => Spacing::Linear,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::path::sample;

    fn variable(paths: &[&str], hold: Hold) -> Variable {
        Variable {
            paths: paths.iter().map(|path| (*path).into()).collect(),
            hold,
            min: 1.0,
            max: 1000.0,
            scale: None,
            tolerance: 0.0,
        }
    }

    fn values(variable: &Variable, model: &Model, value: f64) -> Vec<f64> {
        let applied = variable.applied(model, value).unwrap().into_iter();
        applied.map(|(_, value)| value).collect()
    }

    #[test]
    fn parameters_are_each_there_once_and_the_first_first() {
        let mut model = sample::model(&["S1", "S2"]);
        model.subsystems[1].mass = 50.0;
        let twice = [
            "subsystems.2.mass",
            "subsystems.*.mass",
            "subsystems.S1.inertia",
        ];
        let parameters = variable(&twice, Hold::Equal).parameters(&model).unwrap();
        let parameters: Vec<_> = parameters
            .into_iter()
            .map(|(id, value)| (path::text(&model, id), value))
            .collect();
        let expected = [
            ("subsystems.S2.mass", 50.0),
            ("subsystems.S1.mass", 100.0),
            ("subsystems.S1.inertia", 53.33),
        ];
        assert_eq!(
            parameters,
            expected.map(|(path, value)| (path.to_owned(), value))
        );
    }

    #[test]
    fn the_others_are_equal_or_keep_their_ratios() {
        let mut model = sample::model(&["S1", "S2"]);
        model.subsystems[1].mass = 25.0;
        let paths = ["subsystems.*.mass", "subsystems.S1.inertia"];
        let equal = variable(&paths, Hold::Equal);
        assert_eq!(values(&equal, &model, 7.0), [7.0, 7.0, 7.0]);
        let ratio = variable(&paths, Hold::Ratio);
        assert_eq!(values(&ratio, &model, 50.0), [50.0, 12.5, 53.33 / 2.0]);
        assert_eq!(values(&ratio, &model, 100.0), [100.0, 25.0, 53.33]);
    }

    #[test]
    fn no_ratio_is_held_to_zero() {
        let mut model = sample::model(&["S1", "S2"]);
        model.subsystems[0].arm_left = 0.0;
        let both = variable(&["subsystems.*.arm_left"], Hold::Ratio);
        let fault = both.applied(&model, 1.0).unwrap_err();
        assert_eq!(fault.path, "subsystems.S1.arm_left");
        let alone = variable(&["subsystems.S1.arm_left"], Hold::Ratio);
        assert_eq!(values(&alone, &model, 1.0), [1.0]);
        let fixed = variable(&["supports.left.v.stiffness"], Hold::Equal);
        assert!(fixed.applied(&model, 1.0).is_err());
    }

    #[test]
    fn stiffness_and_damping_above_zero_are_searched_by_their_logarithm() {
        let model = sample::model(&["S1"]);
        let spacing = |path, min, scale| {
            let paths = [path];
            Variable {
                min,
                scale,
                ..variable(&paths, Hold::Equal)
            }
            .spacing(&model)
        };
        assert_eq!(
            spacing("subsystems.*.y_left.stiffness", 1.0, None),
            Spacing::Log
        );
        assert_eq!(spacing("supports.left.w.damping", 1.0, None), Spacing::Log);
        assert_eq!(
            spacing("supports.left.w.damping", 0.0, None),
            Spacing::Linear
        );
        assert_eq!(spacing("subsystems.*.mass", 1.0, None), Spacing::Linear);
        assert_eq!(
            spacing("subsystems.*.mass", 1.0, Some(Spacing::Log)),
            Spacing::Log
        );
        assert_eq!(
            spacing("supports.left.w.damping", 1.0, Some(Spacing::Linear)),
            Spacing::Linear
        );
    }
}

//! What an optimiser may move, what for, and within which limits: `[tune]` of a model file as plain data.

use std::collections::HashSet;

use super::fault::Fault;
use super::id::ParameterId;
use super::path;
use super::types::{Model, Spacing, words};

/// What an optimiser may move, and what for.
#[derive(Debug, Clone, PartialEq)]
pub struct Tune {
    /// What may move.
    pub variables: Vec<Variable>,
    /// What is sought; at least one.
    pub objectives: Vec<Objective>,
    /// How several objectives are one.
    pub combine: Combine,
    /// What must hold.
    pub limits: Vec<Limit>,
}

/// One number that an optimiser may move, and the parameters that follow it.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Parameter paths; `*` is every subsystem. The first parameter is the one that `min` and `max` are of.
    pub paths: Vec<String>,
    /// How the other parameters follow the first.
    pub hold: Hold,
    /// Lower bound, in the parameter's unit.
    pub min: f64,
    /// Upper bound.
    pub max: f64,
    /// How it is searched; none: logarithmic for a stiffness or damping with a lower bound above 0, linear otherwise.
    pub scale: Option<Spacing>,
    /// The parameter may come out this much higher or lower, percent; where some variable has a tolerance, the worst
    /// case over all of them is what is tuned.
    pub tolerance: f64,
}

impl Variable {
    /// The parameters it moves with their present values, each once; the first is the one that the bounds are of.
    ///
    /// # Errors
    /// A path matches nothing, or something that has no number now: a fixed motion has no spring.
    pub fn parameters(&self, model: &Model) -> Result<Vec<(ParameterId, f64)>, Fault> {
        let (mut all, mut seen) = (Vec::new(), HashSet::new());
        for pattern in &self.paths {
            let found = path::numbers(model, pattern)?.into_iter();
            all.extend(found.filter(|(id, _)| seen.insert(*id)));
        }
        Ok(all)
    }

    /// What each of its parameters becomes when the first one is `value`, in the order of
    /// [`parameters`](Self::parameters). A value that the first one has already leaves all ratios to the last bit.
    ///
    /// # Errors
    /// As those of [`parameters`](Self::parameters), or ratios are held to a first parameter that is 0.
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

    /// How it is searched: by [`scale`](Self::scale), else logarithmic for a stiffness or damping with a lower bound
    /// above 0, linear otherwise.
    pub fn spacing(&self, model: &Model) -> Spacing {
        let first = || {
            path::find(model, self.paths.first()?)
                .ok()?
                .first()
                .copied()
        };
        self.scale.unwrap_or_else(|| match first() {
            Some(first) if first.key().is_spring && self.min > 0.0 => Spacing::Log,
            _ => Spacing::Linear,
        })
    }
}

words! {
    /// How several parameters of one variable move together.
    #[derive(Default)]
    pub enum Hold {
        /// All are equal.
        #[default]
        Equal = "equal",
        /// Each keeps the ratio to the first that it has in the model.
        Ratio = "ratio",
    }
}

words! {
    /// How several objectives are one.
    #[derive(Default)]
    pub enum Combine {
        /// Their sum, each times its weight.
        #[default]
        Sum = "sum",
        /// The largest, each times its weight.
        Worst = "worst",
    }
}

/// A figure of the curves that is to be small.
#[derive(Debug, Clone, PartialEq)]
pub struct Objective {
    /// Which figure.
    pub aim: Aim,
    /// Band start, Hz.
    pub from: f64,
    /// Band end, Hz.
    pub to: f64,
    /// What the figure is multiplied by where there are several; > 0.
    pub weight: f64,
}

/// What an objective asks for in its band.
#[derive(Debug, Clone, PartialEq)]
pub enum Aim {
    /// The least highest magnitude: `minimise = "peak"`.
    Peak {
        /// The response's name.
        response: String,
    },
    /// The least mean of the squared magnitude (of an energy, of itself): `minimise = "mean_square"`.
    MeanSquare {
        /// The response's name.
        response: String,
    },
    /// The least mean vibration energy `E_V` of the beam: `minimise = "energy"`.
    Energy,
    /// The widest band below a level: `maximise = "width"`. Its figure is what the widest one leaves of the band, Hz.
    Width {
        /// The response's name.
        response: String,
        /// The level, in the response's unit.
        below: f64,
    },
    /// An anti-resonance at a frequency: `place = "anti_resonance"`. Its figure is how far the nearest one is, Hz.
    AntiResonance {
        /// The response's name.
        response: String,
        /// Where it is wanted, Hz.
        at: f64,
    },
    /// A response as it was measured: `match = FILE`. Its figure is the root mean square of the difference, in decibels
    /// or relative to the root mean square of what was measured.
    Match {
        /// The response's name.
        response: String,
        /// A measured curve, CSV or UFF 58; relative to the folder of the model file.
        file: String,
        /// Which curve of the file; none: the one with the response's name, or the only one.
        curve: Option<String>,
        /// How its columns are to be read, as a person answers it (`hz; re im; m/N`); none: as the file says.
        columns: Option<String>,
        /// What of it is compared.
        compare: Compare,
    },
}

words! {
    /// What of a measured curve is compared.
    #[derive(Default)]
    pub enum Compare {
        /// 20 log10 of the magnitude.
        #[default]
        LogMagnitude = "log_magnitude",
        /// Real and imaginary part.
        Complex = "complex",
    }
}

impl Aim {
    /// The response it is about; none for the energy.
    pub fn response(&self) -> Option<&str> {
        match self {
            Self::Energy => None,
            Self::Peak { response }
            | Self::MeanSquare { response }
            | Self::Width { response, .. }
            | Self::AntiResonance { response, .. }
            | Self::Match { response, .. } => Some(response),
        }
    }

    /// The response it is about, to be renamed.
    pub fn response_mut(&mut self) -> Option<&mut String> {
        match self {
            Self::Energy => None,
            Self::Peak { response }
            | Self::MeanSquare { response }
            | Self::Width { response, .. }
            | Self::AntiResonance { response, .. }
            | Self::Match { response, .. } => Some(response),
        }
    }
}

/// What the tuned model must keep.
#[derive(Debug, Clone, PartialEq)]
pub enum Limit {
    /// The masses of all enabled subsystems together, kg: `limit = "added_mass"`.
    AddedMass {
        /// At most this, kg.
        at_most: f64,
    },
    /// No natural frequency of the undamped model in a band: `limit = "no_mode"`.
    NoMode {
        /// Band start, Hz.
        from: f64,
        /// Band end, Hz.
        to: f64,
    },
    /// The magnitude of a response to its forces at rest (0 Hz): `limit = "static_deflection"`.
    StaticDeflection {
        /// The response's name; a displacement.
        response: String,
        /// At most this, in the response's unit.
        at_most: f64,
    },
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::path::sample;

    fn variable(paths: &[&str], hold: Hold) -> Variable {
        Variable {
            paths: paths.iter().map(|path| (*path).to_owned()).collect(),
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

//! Variables, objectives and limits of an optimisation: `[tune]` of a model file as plain data.

use super::path::Pattern;
use super::types::Spacing;
use crate::words::words;

/// Variables, objectives and limits of an optimisation.
#[derive(Debug, Clone, PartialEq)]
pub struct Tune {
    /// The variables.
    pub variables: Vec<Variable>,
    /// The objectives; at least one.
    pub objectives: Vec<Objective>,
    /// How several objectives are combined.
    pub combine: Combine,
    /// The limits.
    pub limits: Vec<Limit>,
}

/// A number that the optimiser changes, and the parameters that follow it.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Parameter paths; `*` is every subsystem. `min` and `max` apply to the first parameter.
    pub paths: Vec<Pattern>,
    /// How the other parameters follow the first.
    pub hold: Hold,
    /// Lower bound, in the parameter's unit.
    pub min: f64,
    /// Upper bound.
    pub max: f64,
    /// The scale of its search; none: logarithmic for a stiffness or damping with a lower bound above 0, linear
    /// otherwise.
    pub scale: Option<Spacing>,
    /// The real parameter may be this much higher or lower, percent; if any variable has a tolerance, the worst case
    /// over all tolerances is tuned.
    pub tolerance: f64,
}

words! {
    /// How several parameters of one variable change together.
    #[derive(Default)]
    pub enum Hold {
        /// All are equal.
        #[default]
        Equal = "equal",
        /// Each keeps its ratio to the first.
        Ratio = "ratio",
    }
}

words! {
    /// How several objectives are combined.
    #[derive(Default)]
    pub enum Combine {
        /// Weighted sum.
        #[default]
        Sum = "sum",
        /// Weighted maximum.
        Worst = "worst",
    }
}

/// A figure of the curves to minimise.
#[derive(Debug, Clone, PartialEq)]
pub struct Objective {
    /// The figure.
    pub aim: Aim,
    /// The name of its response; none for the energy of the beam.
    pub response: Option<String>,
    /// Band start, Hz.
    pub from: f64,
    /// Band end, Hz.
    pub to: f64,
    /// The weight of the figure among several; > 0.
    pub weight: f64,
}

/// The aim of an objective in its band.
#[derive(Debug, Clone, PartialEq)]
pub enum Aim {
    /// The lowest maximum magnitude: `minimise = "peak"`.
    Peak,
    /// The least mean of the squared magnitude (of an energy, of itself): `minimise = "mean_square"`.
    MeanSquare,
    /// The least mean vibration energy `E_V` of the beam: `minimise = "energy"`.
    Energy,
    /// The widest band below a level: `maximise = "width"`. Its figure is the rest of the objective's band, Hz.
    Width {
        /// The level, in the response's unit.
        below: f64,
    },
    /// An anti-resonance at a frequency: `place = "anti_resonance"`. Its figure is the distance of the nearest one, Hz.
    AntiResonance {
        /// Its target frequency, Hz.
        at: f64,
    },
    /// A match with a measured response: `match = FILE`. Its figure is the root mean square of the difference, in
    /// decibels or relative to the root mean square of the measurement.
    Match {
        /// A measured curve, CSV or UFF 58; relative to the folder of the model file.
        file: String,
        /// The name of the curve in the file; none: the one with the response's name, or the only one.
        curve: Option<String>,
        /// The layout of its columns as a person types it (`hz; re im; m/N`); none: from the file.
        columns: Option<String>,
        /// The quantity that is compared.
        compare: Compare,
    },
}

impl Compare {
    /// The compared quantities, for people; in the order of [`WORDS`](Self::WORDS).
    pub const SPOKEN: &[&str] = &["the magnitude in decibels", "real and imaginary part"];
}

impl Aim {
    /// The decibels of a factor of ten in its figure; none if the figure is not a level.
    pub const fn decibels(&self) -> Option<f64> {
        match self {
            Self::Peak => Some(20.0),
            Self::MeanSquare | Self::Energy => Some(10.0),
            Self::Width { .. } | Self::AntiResonance { .. } | Self::Match { .. } => None,
        }
    }
}

words! {
    /// The quantity of a measured curve that is compared.
    #[derive(Default)]
    pub enum Compare {
        /// 20 log10 of the magnitude.
        #[default]
        LogMagnitude = "log_magnitude",
        /// Real and imaginary part.
        Complex = "complex",
    }
}

/// A constraint on the tuned model.
#[derive(Debug, Clone, PartialEq)]
pub enum Limit {
    /// The masses of all enabled subsystems together, kg: `limit = "added_mass"`.
    AddedMass {
        /// Upper limit, kg.
        at_most: f64,
    },
    /// No natural frequency of the undamped model in a band: `limit = "no_mode"`.
    NoMode {
        /// Band start, Hz.
        from: f64,
        /// Band end, Hz.
        to: f64,
    },
    /// The highest magnitude of a response in the sweep: `limit = "peak"`.
    Peak {
        /// The name of the response.
        response: String,
        /// Upper limit, in the response's unit.
        at_most: f64,
    },
    /// The magnitude of a response to static forces (0 Hz): `limit = "static_deflection"`.
    StaticDeflection {
        /// The name of a displacement response.
        response: String,
        /// Upper limit, in the response's unit.
        at_most: f64,
    },
    /// The least factor on the axial compression at which the beam buckles: `limit = "buckling"`. A beam without
    /// compression has none and keeps the limit.
    Buckling {
        /// Lower limit, 1.
        at_least: f64,
    },
}

impl Limit {
    /// The name of its response, if it has one.
    pub fn response(&self) -> Option<&String> {
        match self {
            Self::Peak { response, .. } | Self::StaticDeflection { response, .. } => Some(response),
            Self::AddedMass { .. } | Self::NoMode { .. } | Self::Buckling { .. } => None,
        }
    }
}

//! What an optimiser may move, what for, and within which limits: `[tune]` of a model file as plain data.

use super::path::Pattern;
use super::types::Spacing;
use crate::words::words;

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
    pub paths: Vec<Pattern>,
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
    /// The name of the response that it is of; none for the energy of the beam.
    pub response: Option<String>,
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
    Peak,
    /// The least mean of the squared magnitude (of an energy, of itself): `minimise = "mean_square"`.
    MeanSquare,
    /// The least mean vibration energy `E_V` of the beam: `minimise = "energy"`.
    Energy,
    /// The widest band below a level: `maximise = "width"`. Its figure is what the widest one leaves of the band, Hz.
    Width {
        /// The level, in the response's unit.
        below: f64,
    },
    /// An anti-resonance at a frequency: `place = "anti_resonance"`. Its figure is how far the nearest one is, Hz.
    AntiResonance {
        /// Where it is wanted, Hz.
        at: f64,
    },
    /// A response as it was measured: `match = FILE`. Its figure is the root mean square of the difference, in decibels
    /// or relative to the root mean square of what was measured.
    Match {
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

impl Compare {
    /// What is compared, for people; in the order of [`WORDS`](Self::WORDS).
    pub const SPOKEN: &[&str] = &["the magnitude in decibels", "real and imaginary part"];
}

impl Aim {
    /// The decibels of a factor of ten in its figure; none where the figure is no level.
    pub const fn decibels(&self) -> Option<f64> {
        match self {
            Self::Peak => Some(20.0),
            Self::MeanSquare | Self::Energy => Some(10.0),
            Self::Width { .. } | Self::AntiResonance { .. } | Self::Match { .. } => None,
        }
    }
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

impl Limit {
    /// The name of the response that it is of, if it is of one.
    pub fn response(&self) -> Option<&String> {
        match self {
            Self::StaticDeflection { response, .. } => Some(response),
            Self::AddedMass { .. } | Self::NoMode { .. } => None,
        }
    }
}

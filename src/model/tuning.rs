//! What an optimiser may move, what for, and within which limits: `[tune]` of a model file as plain data.

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

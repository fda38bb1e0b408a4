//! The figures of objectives: each with a value, and with functions of the coordinates whose largest it is.

mod anti_resonance;
mod curve;
mod matching;
mod mean_square;
mod peak;
mod target;
mod value;
mod width;

use std::path::Path;

use anti_resonance::AntiResonance;
pub(super) use matching::Matching;
use mean_square::MeanSquare;
pub(super) use peak::Peak;
pub(super) use value::ObjectiveValue;
use width::Width;

use super::candidate::{Candidate, Slopes};
use super::search::Function;
use crate::model::{Aim, Checked, Compare, Fault, Objective, Unit};
use crate::solve::Cancelled;
use crate::solve::band::levels;
use crate::unit::Kind;

/// The figure of an objective, with its response by index.
#[derive(Debug, Clone)]
pub(super) enum Figure {
    Peak(Peak),
    MeanSquare(MeanSquare),
    Width(Width),
    AntiResonance(AntiResonance),
    Matching(Matching),
}

impl Figure {
    /// The figure of an objective; `response` is the index of its response in `model`, `folder` that of the model file.
    ///
    /// # Errors
    /// The measured curve cannot be read, or has another quantity than the response.
    pub(super) fn new(
        model: &Checked,
        objective: &Objective,
        response: usize,
        folder: &Path,
    ) -> Result<Self, Fault> {
        let band = [objective.from, objective.to];
        Ok(match &objective.aim {
            Aim::Peak => Self::Peak(Peak { response, band }),
            Aim::MeanSquare | Aim::Energy => Self::MeanSquare(MeanSquare { response, band }),
            Aim::Width { below } => Self::Width(Width {
                response,
                band,
                below: *below,
            }),
            Aim::AntiResonance { at } => Self::AntiResonance(AntiResonance {
                response,
                band,
                at: *at,
            }),
            Aim::Match { .. } => {
                Self::Matching(target::matching(model, objective, response, folder)?)
            }
        })
    }

    /// The highest frequency up to which it needs the modes, Hz; `None` if it needs none.
    pub(super) fn modes_to(&self) -> Option<f64> {
        match self {
            Self::Peak(Peak { band, .. })
            | Self::MeanSquare(MeanSquare { band, .. })
            | Self::Width(Width { band, .. })
            | Self::AntiResonance(AntiResonance { band, .. }) => Some(band[1]),
            Self::Matching(_) => None,
        }
    }

    /// Whether it is always above 0, so that the search works best with its logarithm.
    pub(super) fn is_positive(&self) -> bool {
        matches!(self, Self::Peak(_) | Self::MeanSquare(_))
    }

    /// Its unit, for a model.
    pub(super) fn unit(&self, model: &Checked) -> String {
        let kind = |index: &usize| {
            let response = model.responses.get(*index);
            response.map_or(Kind::Energy, |one| one.kind(model, None))
        };
        match self {
            Self::Peak(Peak {
                response: index, ..
            }) => kind(index).unit(),
            Self::MeanSquare(MeanSquare {
                response: index, ..
            }) => match kind(index) {
                Kind::Energy => Kind::Energy.unit(),
                kind @ Kind::Amplitude(_) => squared(&kind.unit()),
            },
            Self::Width(_) | Self::AntiResonance(_) => Unit::HERTZ.symbol.to_owned(),
            Self::Matching(Matching { compare, .. }) => match compare {
                Compare::LogMagnitude => "dB".to_owned(),
                Compare::Complex => String::new(),
            },
        }
    }

    /// The figure of a model.
    pub(super) fn read(&self, candidate: &Candidate) -> Result<ObjectiveValue, Cancelled> {
        match self {
            Self::Peak(figure) => figure.read(candidate),
            Self::MeanSquare(figure) => figure.read(candidate),
            Self::Width(figure) => figure.read(candidate),
            Self::AntiResonance(figure) => figure.read(candidate),
            Self::Matching(figure) => figure.read(candidate),
        }
    }

    /// Functions of the coordinates; the largest is the figure, and others may become the largest nearby.
    pub(super) fn functions(
        &self,
        candidate: &Candidate,
        slopes: &Slopes,
    ) -> Result<Vec<Function>, Cancelled> {
        match self {
            Self::Peak(figure) => figure.functions(candidate, slopes),
            Self::MeanSquare(figure) => figure.functions(candidate, slopes),
            Self::Width(figure) => figure.functions(candidate, slopes),
            Self::AntiResonance(figure) => figure.functions(candidate, slopes),
            Self::Matching(figure) => Ok(figure.functions(slopes)),
        }
    }

    /// The highest level in the band of a peak, from the independent samples of the quadrature; minus infinity for
    /// other figures.
    pub(super) fn highest(&self, candidate: &Candidate) -> Result<f64, Cancelled> {
        let Self::Peak(Peak { response, band }) = self else {
            return Ok(f64::NEG_INFINITY);
        };
        let levels = levels(&candidate.model, candidate.modes(), *band, candidate.cancel)?;
        Ok(levels[*response].maximum)
    }
}

/// A unit's square: m -> m2, m/s -> (m/s)2.
fn squared(unit: &str) -> String {
    if unit.chars().all(char::is_alphabetic) {
        format!("{unit}2")
    } else {
        format!("({unit})2")
    }
}

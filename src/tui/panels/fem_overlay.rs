//! Finite-element curves, drawn over the exact ones.

use crate::model::Checked;
use crate::tui::app::Trace;
use crate::tui::panels::chart::picture::traces;
use crate::worker::{Difference, WitnessAnswer, WitnessMember};

/// Finite-element curves of one state of the model.
#[derive(Debug)]
pub struct FemPicture {
    /// The model's generation.
    pub generation: u64,
    /// In the order of the members of the picture.
    pub members: Vec<FemCurves>,
}

/// Finite-element curves of the model, or of one member of a study.
#[derive(Debug)]
pub struct FemCurves {
    /// How many elements the beam has.
    pub elements: usize,
    /// Hz.
    pub frequencies: Vec<f64>,
    /// In the order of the model's responses.
    pub traces: Vec<Trace>,
    /// The largest difference of each response to the exact solution, if they can be compared.
    pub differences: Vec<Option<Difference>>,
}

/// The state of the finite-element overlay.
#[derive(Debug, Default)]
pub enum FemOverlay {
    /// Off.
    #[default]
    Off,
    /// In work, or waiting for the exact curves; with the previous ones.
    Waiting(Option<FemPicture>),
    /// Solved.
    Shown(FemPicture),
    /// Failed, and why.
    Failed(String),
}

impl FemOverlay {
    /// Turns the overlay on or off; returns whether it is on now.
    pub(crate) fn toggle(&mut self) -> bool {
        let wanted = matches!(self, Self::Off);
        *self = if wanted {
            Self::Waiting(None)
        } else {
            Self::Off
        };
        wanted
    }

    /// The model has changed: the curves belong to an older one.
    pub(crate) fn outdate(&mut self) {
        *self = match std::mem::take(self) {
            Self::Off => Self::Off,
            Self::Shown(picture) => Self::Waiting(Some(picture)),
            Self::Waiting(picture) => Self::Waiting(picture),
            Self::Failed(_) => Self::Waiting(None),
        };
    }

    /// Another model was opened: the curves do not apply to it.
    pub(crate) fn forget(&mut self) {
        if !matches!(self, Self::Off) {
            *self = Self::Waiting(None);
        }
    }

    /// Stores an answer for the model with this generation.
    pub(crate) fn take(&mut self, answer: WitnessAnswer, generation: u64, model: &Checked) {
        if matches!(self, Self::Off) || answer.generation != generation {
            return;
        }
        *self = match answer.result {
            Ok(members) => Self::Shown(FemPicture {
                generation,
                members: members.into_iter().map(|one| curves(one, model)).collect(),
            }),
            Err(reason) => Self::Failed(reason),
        };
    }

    /// The curves to draw, if there are any.
    pub fn picture(&self) -> Option<&FemPicture> {
        match self {
            Self::Off | Self::Failed(_) | Self::Waiting(None) => None,
            Self::Shown(picture) | Self::Waiting(Some(picture)) => Some(picture),
        }
    }
}

fn curves(member: WitnessMember, model: &Checked) -> FemCurves {
    FemCurves {
        elements: member.elements,
        traces: traces(model, &member.frf, Vec::new()),
        frequencies: member.frf.frequencies,
        differences: member.differences,
    }
}

//! The modes of the model, which one is selected, and its shape.

use std::sync::Arc;

pub use crate::solve::modes::{Completeness, ModeKind, Shares};

use super::shape::Shape;
use crate::solve::modes::Modes;
use crate::worker::{ModalModel, ShapeAnswer};

/// A mode as it is listed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeRow {
    /// |omega| / 2 pi, Hz.
    pub frequency: f64,
    /// Im omega / |omega|.
    pub damping_ratio: f64,
    /// What kind of motion it is.
    pub kind: ModeKind,
    /// Who moves.
    pub shares: Shares,
}

/// The modes of one state of the model.
#[derive(Debug)]
pub struct ModeList {
    /// The model's generation.
    pub generation: u64,
    /// The upper end of the search, Hz.
    pub to: f64,
    /// By rising frequency.
    pub rows: Vec<ModeRow>,
    /// Whether these are known to be all.
    pub completeness: Completeness,
    /// How many more they are than in the state of the model before; none where that cannot be compared.
    pub change: Option<isize>,
    modes: Arc<Modes>,
}

/// The modes and what is done with them.
#[derive(Debug, Default)]
pub struct Modal {
    /// The modes solved last; they may be older than the model.
    pub list: Option<ModeList>,
    /// The shape solved last.
    pub shape: Option<Shape>,
    /// Generation and mode whose shape was asked for last.
    asked: Option<(u64, usize)>,
}

impl Modal {
    /// Takes the modes of a newer state of the model.
    pub(super) fn take(&mut self, generation: u64, found: ModalModel) {
        let ModalModel { modes, shares } = found;
        let rows: Vec<ModeRow> = modes
            .modes
            .iter()
            .zip(shares)
            .map(|(mode, shares)| ModeRow {
                frequency: mode.frequency(),
                damping_ratio: mode.damping_ratio(),
                kind: mode.kind,
                shares,
            })
            .collect();
        let before = self.list.as_ref().filter(|list| list.to == modes.to);
        let change = match before {
            // A study of the same model says nothing new.
            Some(before) if Arc::ptr_eq(&before.modes, &modes) => before.change,
            Some(before) => Some(rows.len().cast_signed() - before.rows.len().cast_signed()),
            None => None,
        };
        self.list = Some(ModeList {
            generation,
            to: modes.to,
            rows,
            completeness: modes.completeness.clone(),
            change,
            modes,
        });
    }

    /// The mode whose shape is to be asked for, of the model with this generation: once each.
    pub(super) fn want_shape(
        &mut self,
        generation: u64,
        mode: usize,
    ) -> Option<(Arc<Modes>, usize)> {
        let list = self.list.as_ref()?;
        let wanted = (generation, mode);
        if list.generation != generation || mode >= list.rows.len() || self.asked == Some(wanted) {
            return None;
        }
        self.asked = Some(wanted);
        Some((Arc::clone(&list.modes), mode))
    }

    /// The modes of the model with this generation, where they are solved.
    pub(super) fn modes_of(&self, generation: u64) -> Option<Arc<Modes>> {
        let list = self.list.as_ref()?;
        (list.generation == generation).then(|| Arc::clone(&list.modes))
    }

    /// Takes a shape, unless another one was asked for since.
    pub(super) fn take_shape(&mut self, answer: ShapeAnswer, places: &[f64]) -> Result<(), String> {
        if self.asked != Some((answer.generation, answer.index)) {
            return Ok(());
        }
        self.shape = Some(Shape::new(
            answer.generation,
            answer.index,
            answer.result?,
            places,
        ));
        Ok(())
    }
}

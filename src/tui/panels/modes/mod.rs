//! The modes of the model, which one is selected, and its shape.

mod shape;
pub(crate) mod view;

use std::f64::consts::PI;
use std::sync::Arc;

pub use crate::solve::modes::{Completeness, ModeKind, Shares};

use crate::model::Checked;
use crate::solve::modes::{MOST_MODES, Modes};
use crate::worker::{ModalModel, ShapeAnswer, ShapeRequest};
pub use shape::Shape;

/// Points of a modal circle in the complex plane.
const LOOP_POINTS: u32 = 72;

/// A mode as it is listed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeRow {
    /// Its number, from 1.
    pub number: usize,
    /// |omega| / 2 pi, Hz.
    pub frequency: f64,
    /// Im omega / |omega|.
    pub damping_ratio: f64,
    /// What kind of motion it is.
    pub kind: ModeKind,
    /// The shares of beam and masses in the motion.
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
    /// Whether the list is known to be complete.
    pub completeness: Completeness,
    /// The change of their number since the previous state of the model; none if it cannot be compared.
    pub change: Option<isize>,
    modes: Arc<Modes>,
}

/// The state of the modes.
#[derive(Debug, Default)]
pub struct ModesState {
    /// The modes solved last, possibly of an older model.
    pub list: Option<ModeList>,
    /// The shape solved last.
    pub shape: Option<Shape>,
    /// The last request for a shape.
    asked: Option<AskedShape>,
}

/// A request for a shape, with its model.
#[derive(Debug)]
struct AskedShape {
    generation: u64,
    mode: usize,
    model: Arc<Checked>,
    modes: Arc<Modes>,
}

impl AskedShape {
    fn is(&self, generation: u64, mode: usize) -> bool {
        (self.generation, self.mode) == (generation, mode)
    }
}

impl ModeList {
    /// Why a peak may be missing; none if the list is certain.
    pub fn doubt(&self) -> Option<String> {
        match &self.completeness {
            Completeness::Certain => None,
            Completeness::Uncounted => Some("the modes are not counted yet".to_owned()),
            Completeness::Open(gaps) => {
                let gaps: Vec<String> = gaps.iter().map(ToString::to_string).collect();
                Some(format!("the modes are not certain {}", gaps.join("; ")))
            }
            Completeness::TooMany => Some(format!("there are more than {MOST_MODES} modes")),
        }
    }

    /// Whether a mode is in a range that is not certain.
    pub fn is_open_at(&self, row: &ModeRow) -> bool {
        match &self.completeness {
            Completeness::Open(gaps) => gaps
                .iter()
                .any(|gap| (gap.from..=gap.to).contains(&row.frequency)),
            Completeness::Certain | Completeness::Uncounted | Completeness::TooMany => false,
        }
    }
}

impl ModesState {
    /// Stores the modes of a newer state of the model, or the same modes with their count.
    pub(crate) fn take(&mut self, generation: u64, found: ModalModel) {
        let ModalModel { modes, shares } = found;
        let rows: Vec<ModeRow> = modes
            .modes
            .iter()
            .zip(shares)
            .enumerate()
            .map(|(index, (mode, shares))| ModeRow {
                number: index + 1,
                frequency: mode.frequency(),
                damping_ratio: mode.damping_ratio(),
                kind: mode.kind,
                shares,
            })
            .collect();
        let before = self.list.as_ref().filter(|list| list.to == modes.to);
        let more = |before: &ModeList| rows.len().cast_signed() - before.rows.len().cast_signed();
        let change = match before {
            // A study of the same model changes nothing.
            Some(before) if Arc::ptr_eq(&before.modes, &modes) => before.change,
            // The count adds to the change since the previous model.
            Some(before) if before.generation == generation => {
                before.change.map(|change| change + more(before))
            }
            Some(before) => Some(more(before)),
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

    /// The request for the shape of a mode of the model with this generation: once, and again if the count found other
    /// modes.
    pub(crate) fn want_shape(
        &mut self,
        generation: u64,
        model: &Arc<Checked>,
        mode: usize,
    ) -> Option<ShapeRequest> {
        let list = self.list.as_ref()?;
        let asked = self.asked.as_ref();
        let known = asked.is_some_and(|asked| {
            asked.is(generation, mode) && asked.modes.has_modes_of(&list.modes)
        });
        if list.generation != generation || mode >= list.rows.len() || known {
            return None;
        }
        self.asked = Some(AskedShape {
            generation,
            mode,
            model: Arc::clone(model),
            modes: Arc::clone(&list.modes),
        });
        Some(ShapeRequest {
            generation,
            model: Arc::clone(model),
            modes: Arc::clone(&list.modes),
            index: mode,
        })
    }

    /// The generation of the listed modes.
    pub(crate) fn generation(&self) -> Option<u64> {
        self.list.as_ref().map(|list| list.generation)
    }

    /// The modes of the model with this generation, once solved and counted.
    pub(crate) fn counted_modes(&self, generation: u64) -> Option<Arc<Modes>> {
        let list = self.list.as_ref()?;
        let is_counted = list.completeness != Completeness::Uncounted;
        (list.generation == generation && is_counted).then(|| Arc::clone(&list.modes))
    }

    /// Stores a shape, unless another one was requested since.
    ///
    /// # Errors
    /// Why there is no shape, in one line.
    pub(crate) fn take_shape(&mut self, answer: ShapeAnswer) -> Result<(), String> {
        let asked = self.asked.as_ref();
        let Some(asked) = asked.filter(|asked| asked.is(answer.generation, answer.index)) else {
            return Ok(());
        };
        let places: Vec<f64> = asked.model.attached().map(|one| one.position).collect();
        self.shape = Some(Shape::new(
            answer.generation,
            answer.index,
            answer.result?,
            &places,
        ));
        Ok(())
    }

    /// Whether the shape solved last is of an oscillating mode.
    pub(crate) fn shape_oscillates(&self) -> bool {
        let oscillates = || {
            let shape = self.shape.as_ref()?;
            let row = self.list.as_ref()?.rows.get(shape.mode)?;
            Some(row.kind == ModeKind::Oscillating)
        };
        oscillates() == Some(true)
    }

    /// The place of each mode among others: its frequency and its decay rate, both Hz.
    pub(crate) fn places(&self) -> Vec<[f64; 2]> {
        let rows = self.list.as_ref().map_or(&[][..], |list| &list.rows);
        rows.iter()
            .map(|row| [row.frequency, row.frequency * row.damping_ratio])
            .collect()
    }

    /// Frequencies (Hz) in even steps around the circle of each mode in the complex plane: at f (1 + zeta tan a) the
    /// response of one mode has turned by 2 a.
    pub(crate) fn loops(&self) -> impl Iterator<Item = f64> {
        let list = self.list.as_ref();
        let modes = list.map_or(&[][..], |list| &list.rows);
        modes.iter().flat_map(|mode| {
            (1..LOOP_POINTS).map(|step| {
                let angle = PI * (f64::from(step) / f64::from(LOOP_POINTS) - 0.5);
                mode.frequency * (1.0 + mode.damping_ratio * angle.tan())
            })
        })
    }
}

#[cfg(test)]
mod tests;

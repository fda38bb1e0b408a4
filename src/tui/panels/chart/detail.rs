//! The visible band, solved at the screen's resolution: zooming in keeps the detail.

use super::Compared;
use crate::tui::app::last_request::LastRequest;
use crate::worker::{SampleAnswer, Stage};

/// The key of a request.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Key {
    pub(super) generation: u64,
    pub(super) stage: Stage,
    /// The number of frequencies.
    pub(super) solved: usize,
    pub(super) window: [f64; 2],
    pub(super) log: bool,
    pub(super) references: Vec<u64>,
    pub(super) points: usize,
    /// Whether every modal circle needs to be round (Nyquist).
    pub(super) loops: bool,
}

/// Curves of a band.
#[derive(Debug)]
pub struct DetailPicture {
    /// The model's generation.
    pub generation: u64,
    /// Lower and upper end, Hz.
    pub window: [f64; 2],
    /// The curves of the model and of the references.
    pub curves: Compared,
}

/// The visible band.
#[derive(Debug, Default)]
pub struct Detail {
    pub(super) asked: LastRequest<Key>,
    shown: Option<DetailPicture>,
}

impl Detail {
    /// The band, if it belongs to the model with this generation.
    pub fn of(&self, generation: u64, window: [f64; 2]) -> Option<&DetailPicture> {
        self.shown
            .as_ref()
            .filter(|shown| shown.generation == generation && shown.window == window)
    }

    /// Stores the answer to the last request.
    ///
    /// # Errors
    /// Why the band was not solved, in one line.
    pub(crate) fn take(&mut self, answer: SampleAnswer) -> Result<(), String> {
        let Some(key) = self.asked.answered(answer.serial) else {
            return Ok(());
        };
        self.shown = Some(DetailPicture {
            generation: key.generation,
            window: key.window,
            curves: Compared::new(answer.result?, &key.references),
        });
        Ok(())
    }
}

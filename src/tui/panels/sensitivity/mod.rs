//! Sensitivities: bars in the tree and a table, for the level at the cursor, a peak, a mode or the band.

mod commands;
mod effects;
pub(crate) mod view;

use std::sync::Arc;

pub use effects::{Effects, Weighed};

use crate::model::Checked;
use crate::tui::app::last_request::LastRequest;

/// The figure whose sensitivities are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sensed {
    /// The level of the first curve at the cursor.
    Cursor,
    /// The selected peak of the first curve.
    Peak,
    /// The selected mode.
    Mode,
    /// The mean-square level of the first curve in the marked band.
    Band,
}

/// The key of a request.
#[derive(Debug, Clone, PartialEq)]
struct Key {
    generation: u64,
    sensed: Sensed,
    response: String,
    /// Hz: the frequency, or the ends of the band.
    at: [f64; 2],
}

/// The state of the sensitivities.
#[derive(Debug, Default)]
pub struct Sensitivities {
    /// The figure; none if off.
    pub sensed: Option<Sensed>,
    /// The sensitivities solved last.
    pub effects: Option<Effects>,
    /// Why the last request failed.
    pub failure: Option<String>,
    /// The last request, with its model.
    asked: LastRequest<(Key, Arc<Checked>)>,
}

impl Sensitivities {
    /// Another model was opened: the results do not apply to it.
    pub(crate) fn forget(&mut self) {
        (self.effects, self.failure) = (None, None);
        self.asked.forget();
    }
}

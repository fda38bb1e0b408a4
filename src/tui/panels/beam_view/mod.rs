//! The view of the beam below the chart: its motion and internal forces at the cursor, and drawings.

mod animated;
mod commands;
pub(crate) mod deflection;
pub(crate) mod forces;
pub(crate) mod mode_shape;
pub(crate) mod power;
pub(crate) mod section;
pub(crate) mod structure;

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::model::Checked;
use crate::solve::operating::Operating;
use crate::tui::app::last_request::LastRequest;
use crate::worker::OperatingAnswer;

/// Frames per period.
const FRAMES: u32 = 24;

/// The kind of view below the chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeamView {
    /// The shape of the selected mode.
    Mode,
    /// The operating deflection at the cursor.
    Deflection,
    /// Bending moments along the beam.
    Moments,
    /// Shear forces.
    Shear,
    /// The torque.
    Torque,
    /// The bimoment.
    Bimoment,
    /// Power input and dissipation.
    Power,
    /// The beam with supports, loads and subsystems.
    Structure,
    /// The cross-section.
    Section,
}

/// The phase of the period at which an oscillation is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Moment {
    /// The frame of the period.
    frame: u32,
    /// Whether the animation runs.
    pub runs: bool,
}

/// The state of the view below the chart.
#[derive(Debug, Default)]
pub struct BeamViewState {
    /// The visible view.
    pub shown: Option<BeamView>,
    /// The phase of the animation.
    pub moment: Moment,
    /// The operating state at the cursor that was solved last, with its model.
    pub operating: Option<(Arc<Checked>, Arc<Operating>)>,
    /// The generation of that model.
    pub generation: u64,
    /// Why the last request failed.
    pub failure: Option<String>,
    /// The last request, with its model.
    asked: LastRequest<(OperatingKey, Arc<Checked>)>,
}

/// The key of a request: the model's generation, and the frequency, Hz.
type OperatingKey = (u64, f64);

impl BeamViewState {
    /// Another model was opened: the results do not apply to it.
    pub(crate) fn forget(&mut self) {
        self.operating = None;
        self.failure = None;
        self.asked.forget();
    }

    /// Shows or hides the shape of the selected mode.
    pub(crate) fn toggle_shape(&mut self) {
        let shows = self.shown == Some(BeamView::Mode);
        self.show((!shows).then_some(BeamView::Mode));
    }

    /// Shows the next drawing, or none.
    pub(crate) fn next_drawing(&mut self) {
        self.show(match self.shown {
            Some(BeamView::Structure) => Some(BeamView::Section),
            Some(BeamView::Section) => None,
            _ => Some(BeamView::Structure),
        });
    }

    /// Shows a view, or none. An animation continues only from one view that moves to another.
    fn show(&mut self, look: Option<BeamView>) {
        let goes_on = look.is_some_and(BeamView::moves) && self.shown.is_some_and(BeamView::moves);
        if !goes_on {
            self.moment = Moment::default();
        }
        self.shown = look;
    }

    /// Advances the animation by a frame, if it runs.
    pub(crate) fn next_frame(&mut self) {
        if self.moment.runs {
            self.moment.step();
        }
    }

    /// The operating state that was solved last.
    pub fn operating(&self) -> Option<&Operating> {
        let (_, operating) = self.operating.as_ref()?;
        Some(operating)
    }

    /// Stores the answer to the last request.
    pub(crate) fn take(&mut self, answer: OperatingAnswer) {
        let Some(((generation, _), model)) = self.asked.answered(answer.serial) else {
            return;
        };
        self.generation = *generation;
        (self.operating, self.failure) = match answer.result {
            Ok(operating) => (Some((Arc::clone(model), operating)), None),
            Err(reason) => (None, Some(reason)),
        };
    }
}

impl Moment {
    /// Advances by one frame.
    fn step(&mut self) {
        self.frame = (self.frame + 1) % FRAMES;
    }

    /// The phase angle shown, rad.
    pub fn angle(self) -> f64 {
        f64::from(self.frame) / f64::from(FRAMES) * TAU
    }
}

impl BeamView {
    /// The views that the `operating` key cycles through.
    const OPERATING: [Self; 6] = [
        Self::Deflection,
        Self::Moments,
        Self::Shear,
        Self::Torque,
        Self::Bimoment,
        Self::Power,
    ];

    /// Whether the view shows the state at one frequency.
    pub fn is_operating(self) -> bool {
        Self::OPERATING.contains(&self)
    }

    /// Whether the view changes within a period.
    pub fn moves(self) -> bool {
        self == Self::Mode || (self.is_operating() && self != Self::Power)
    }
}

//! The view of the beam below the chart: its motion and internal forces at the cursor, and drawings.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::model::Checked;
use crate::solve::operating::Operating;
use crate::tui::app::request::LastRequest;
use crate::tui::app::{App, ModeKind};
use crate::tui::keys::BeamViewCommand;
use crate::worker::{OperatingAnswer, OperatingRequest, Request};

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

impl App {
    /// Shows or hides the shape of the selected mode.
    pub(crate) fn toggle_shape(&mut self) {
        let shows = self.beam_view.shown == Some(BeamView::Mode);
        self.show_beam_view((!shows).then_some(BeamView::Mode));
    }

    pub(crate) fn next_operating(&mut self) {
        let place = BeamView::OPERATING
            .iter()
            .position(|look| Some(*look) == self.beam_view.shown);
        let next = place.map_or(0, |place| place + 1);
        if place.is_none() && self.curves.cursor.is_none() {
            self.move_cursor(1.0);
        }
        self.show_beam_view(BeamView::OPERATING.get(next).copied());
    }

    pub(crate) fn next_drawing(&mut self) {
        self.show_beam_view(match self.beam_view.shown {
            Some(BeamView::Structure) => Some(BeamView::Section),
            Some(BeamView::Section) => None,
            _ => Some(BeamView::Structure),
        });
    }

    fn show_beam_view(&mut self, look: Option<BeamView>) {
        let goes_on =
            look.is_some_and(BeamView::moves) && self.beam_view.shown.is_some_and(BeamView::moves);
        if !goes_on {
            self.beam_view.moment = Moment::default();
        }
        self.beam_view.shown = look;
    }

    /// Starts or stops the animation; shows the selected mode if the visible view cannot move.
    pub(crate) fn animate(&mut self) {
        if std::mem::take(&mut self.beam_view.moment.runs) {
            return;
        }
        let look = self.beam_view.shown.filter(|look| look.moves());
        if look.is_none_or(|look| look == BeamView::Mode) {
            let row = self.tables.modes.row;
            let kind = self.modes.list.as_ref().map(|list| list.rows.get(row));
            match kind.map(|row| row.map(|row| row.kind)) {
                None => return self.refuse("the modes are not solved yet"),
                Some(None) => return self.refuse("there is no mode to move"),
                Some(Some(ModeKind::Oscillating)) => self.show_beam_view(Some(BeamView::Mode)),
                Some(Some(_)) => return self.refuse("the selected mode does not oscillate"),
            }
        }
        self.beam_view.moment.runs = true;
    }

    pub(crate) fn step_phase(&mut self) {
        if !self.beam_view.shown.is_some_and(BeamView::moves) {
            return self.refuse("nothing that moves shows");
        }
        self.beam_view.moment.runs = false;
        self.beam_view.moment.step();
        self.done(format!("{} deg further in the period", 360 / FRAMES));
    }

    /// Advances the animation by a frame, if it runs.
    pub(crate) fn next_frame(&mut self) {
        if self.beam_view.moment.runs {
            self.beam_view.moment.step();
        }
    }

    /// Stops the animation, because the connection is too slow for it.
    pub fn stop_moving(&mut self) {
        if std::mem::take(&mut self.beam_view.moment.runs) {
            let key = self.keys.key_of(BeamViewCommand::PhaseStep);
            self.refuse(format!(
                "the line is too slow for what moves: {key} goes a step further"
            ));
        }
    }

    /// Whether something on the screen is animated.
    pub fn moves(&self) -> bool {
        let shows = match self.beam_view.shown {
            Some(BeamView::Mode) => self.mode_oscillates(),
            Some(look) if look.moves() => self.operating().is_some(),
            _ => false,
        };
        self.beam_view.moment.runs && self.overlay.is_none() && !self.unseen && shows
    }

    /// Whether the visible shape is of an oscillating mode.
    fn mode_oscillates(&self) -> bool {
        let oscillates = || {
            let shape = self.modes.shape.as_ref()?;
            let row = self.modes.list.as_ref()?.rows.get(shape.mode)?;
            Some(row.kind == ModeKind::Oscillating)
        };
        oscillates() == Some(true)
    }

    /// The operating state, if it is solved for this model and cursor.
    pub fn operating(&self) -> Option<&Operating> {
        let (_, operating) = self.beam_view.operating.as_ref()?;
        Some(operating)
    }

    /// Whether the operating state is of an older model or another frequency.
    pub fn operating_is_stale(&self) -> bool {
        self.beam_view.generation != self.curves.generation
            || self.operating().map(|one| one.frequency) != self.curves.cursor
    }

    /// Requests the operating state at the cursor, if it is visible.
    pub(crate) fn want_operating(&mut self) -> Option<Request> {
        self.beam_view.shown.filter(|look| look.is_operating())?;
        let frequency = self.curves.cursor?;
        let key = (self.curves.generation, frequency);
        if self.beam_view.asked.is(|(asked, _)| *asked == key) {
            return None;
        }
        let (serial, model) = (self.next_serial(), Arc::clone(self.document.model()));
        let asked = (key, Arc::clone(&model));
        self.beam_view.asked.sent(serial, asked);
        Some(Request::Operating(OperatingRequest {
            serial,
            model,
            frequency,
        }))
    }

    /// Stores the answer to the last request.
    pub(crate) fn take_operating(&mut self, answer: OperatingAnswer) {
        let Some(((generation, _), model)) = self.beam_view.asked.answered(answer.serial) else {
            return;
        };
        self.beam_view.generation = *generation;
        (self.beam_view.operating, self.beam_view.failure) = match answer.result {
            Ok(operating) => (Some((Arc::clone(model), operating)), None),
            Err(reason) => (None, Some(reason)),
        };
    }
}

//! What is looked at below the chart: how the beam moves and what acts in it at the cursor, and drawings of it.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::request::LastRequest;
use super::{App, ModeKind};
use crate::model::Model;
use crate::solve::operating::Operating;
use crate::tui::keys::BeamViewCommand;
use crate::worker::{OperatingAnswer, OperatingRequest, Request};

/// Frames of a period.
const FRAMES: u32 = 24;

/// What shows below the chart.
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
    /// Where power comes from and goes to.
    Power,
    /// The beam with what it carries.
    Structure,
    /// The cross-section.
    Section,
}

/// The moment of its period at which something that oscillates is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Moment {
    /// The frame of the period.
    frame: u32,
    /// Whether it goes on by itself.
    pub runs: bool,
}

/// What is looked at below the chart.
#[derive(Debug, Default)]
pub struct BeamViewState {
    /// What shows.
    pub shown: Option<BeamView>,
    /// When in its period.
    pub moment: Moment,
    /// What the beam of a model does at the cursor, as it was solved last.
    pub operating: Option<(Arc<Model>, Arc<Operating>)>,
    /// The generation of the model it was solved for.
    pub generation: u64,
    /// Why nothing is known, where the last question failed.
    pub failure: Option<String>,
    /// With the model that it is about.
    asked: LastRequest<(OperatingKey, Arc<Model>)>,
}

/// What was requested: the model's generation, and the frequency, Hz.
type OperatingKey = (u64, f64);

impl BeamViewState {
    /// Another model was opened: what is known says nothing of it.
    pub(super) fn forget(&mut self) {
        self.operating = None;
        self.failure = None;
        self.asked.forget();
    }
}

impl Moment {
    /// One frame further.
    fn step(&mut self) {
        self.frame = (self.frame + 1) % FRAMES;
    }

    /// The angle of its period that is shown, rad.
    pub fn angle(self) -> f64 {
        f64::from(self.frame) / f64::from(FRAMES) * TAU
    }
}

impl BeamView {
    /// What a key goes through at the cursor.
    const OPERATING: [Self; 6] = [
        Self::Deflection,
        Self::Moments,
        Self::Shear,
        Self::Torque,
        Self::Bimoment,
        Self::Power,
    ];

    /// Whether it is of one frequency.
    pub fn is_operating(self) -> bool {
        Self::OPERATING.contains(&self)
    }

    /// Whether it changes within a period.
    pub fn moves(self) -> bool {
        self == Self::Mode || (self.is_operating() && self != Self::Power)
    }
}

impl App {
    /// Shows or hides the shape of the selected mode.
    pub(super) fn toggle_shape(&mut self) {
        let shows = self.beam_view.shown == Some(BeamView::Mode);
        self.show_beam_view((!shows).then_some(BeamView::Mode));
    }

    pub(super) fn next_operating(&mut self) {
        let place = BeamView::OPERATING
            .iter()
            .position(|look| Some(*look) == self.beam_view.shown);
        let next = place.map_or(0, |place| place + 1);
        if place.is_none() && self.curves.cursor.is_none() {
            self.move_cursor(1.0);
        }
        self.show_beam_view(BeamView::OPERATING.get(next).copied());
    }

    pub(super) fn next_drawing(&mut self) {
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

    /// Lets what shows move, or stand still; the selected mode where nothing that moves shows.
    pub(super) fn animate(&mut self) {
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

    pub(super) fn step_phase(&mut self) {
        if !self.beam_view.shown.is_some_and(BeamView::moves) {
            return self.refuse("nothing that moves shows");
        }
        self.beam_view.moment.runs = false;
        self.beam_view.moment.step();
        self.done(format!("{} deg further in the period", 360 / FRAMES));
    }

    /// A frame further, of what moves by itself.
    pub(super) fn next_frame(&mut self) {
        if self.beam_view.moment.runs {
            self.beam_view.moment.step();
        }
    }

    /// What moves by itself stands still, because the line carries too few frames.
    pub fn stop_moving(&mut self) {
        if std::mem::take(&mut self.beam_view.moment.runs) {
            let key = self.keys.key_of(BeamViewCommand::PhaseStep);
            self.refuse(format!(
                "the line is too slow for what moves: {key} goes a step further"
            ));
        }
    }

    /// Whether something on the screen moves by itself.
    pub fn moves(&self) -> bool {
        let shows = match self.beam_view.shown {
            Some(BeamView::Mode) => self.mode_oscillates(),
            Some(look) if look.moves() => self.operating().is_some(),
            _ => false,
        };
        self.beam_view.moment.runs && self.overlay.is_none() && !self.unseen && shows
    }

    /// Whether the shape that shows is of a mode that oscillates.
    fn mode_oscillates(&self) -> bool {
        let oscillates = || {
            let shape = self.modes.shape.as_ref()?;
            let row = self.modes.list.as_ref()?.rows.get(shape.mode)?;
            Some(row.kind == ModeKind::Oscillating)
        };
        oscillates() == Some(true)
    }

    /// What the beam does at the cursor, where that is known and belongs to it.
    pub fn operating(&self) -> Option<&Operating> {
        let (_, operating) = self.beam_view.operating.as_ref()?;
        Some(operating)
    }

    /// Whether what is known of the beam at the cursor belongs to an older model or another frequency.
    pub fn operating_is_stale(&self) -> bool {
        self.beam_view.generation != self.curves.generation
            || self.operating().map(|one| one.frequency) != self.curves.cursor
    }

    /// Asks what the beam does at the cursor, if that shows.
    pub(super) fn want_operating(&mut self) -> Option<Request> {
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

    /// Takes what was asked last.
    pub(super) fn take_operating(&mut self, answer: OperatingAnswer) {
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

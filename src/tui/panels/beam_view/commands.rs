//! Chooses the view of the beam, moves it, and requests the operating state.

use std::sync::Arc;

use super::{BeamView, FRAMES};
use crate::tui::app::{App, ModeKind};
use crate::tui::keys::BeamViewCommand;
use crate::worker::{OperatingRequest, Request};

impl App {
    pub(crate) fn next_operating(&mut self) {
        let place = BeamView::OPERATING
            .iter()
            .position(|look| Some(*look) == self.beam_view.shown);
        let next = place.map_or(0, |place| place + 1);
        if place.is_none() && self.curves.cursor.is_none() {
            self.move_cursor(1.0);
        }
        self.beam_view.show(BeamView::OPERATING.get(next).copied());
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
                Some(None) => return self.refuse("there is no mode to animate"),
                Some(Some(ModeKind::Oscillating)) => self.beam_view.show(Some(BeamView::Mode)),
                Some(Some(_)) => return self.refuse("the selected mode does not oscillate"),
            }
        }
        self.beam_view.moment.runs = true;
    }

    pub(crate) fn step_phase(&mut self) {
        if !self.beam_view.shown.is_some_and(BeamView::moves) {
            return self.refuse("nothing is animated here");
        }
        self.beam_view.moment.runs = false;
        self.beam_view.moment.step();
        self.done(format!("animation stepped by {} deg", 360 / FRAMES));
    }

    /// Stops the animation, because the connection is too slow for it.
    pub fn stop_moving(&mut self) {
        if std::mem::take(&mut self.beam_view.moment.runs) {
            let key = self.keys.key_of(BeamViewCommand::PhaseStep);
            self.refuse(format!(
                "the connection is too slow for the animation: {key} steps it"
            ));
        }
    }

    /// Whether something on the screen is animated.
    pub fn moves(&self) -> bool {
        let shows = match self.beam_view.shown {
            Some(BeamView::Mode) => self.modes.shape_oscillates(),
            Some(look) if look.moves() => self.beam_view.operating().is_some(),
            _ => false,
        };
        self.beam_view.moment.runs && self.overlay.is_none() && !self.screen.unseen && shows
    }

    /// Whether the operating state is of an older model or another frequency.
    pub fn operating_is_stale(&self) -> bool {
        self.beam_view.generation != self.curves.generation
            || self.beam_view.operating().map(|one| one.frequency) != self.curves.cursor
    }

    /// Requests the operating state at the cursor, if it is visible.
    pub(crate) fn want_operating(&mut self) -> Option<Request> {
        self.beam_view.shown.filter(|look| look.is_operating())?;
        let frequency = self.curves.cursor?;
        let key = (self.curves.generation, frequency);
        if self.beam_view.asked.is(|(asked, _)| *asked == key) {
            return None;
        }
        let (serial, model) = (
            self.requests.next_serial(),
            Arc::clone(self.document.model()),
        );
        let asked = (key, Arc::clone(&model));
        self.beam_view.asked.sent(serial, asked);
        Some(Request::Operating(OperatingRequest {
            serial,
            model,
            frequency,
        }))
    }
}

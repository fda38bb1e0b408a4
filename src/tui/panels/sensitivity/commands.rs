//! Chooses the figure of the sensitivities, and requests and stores them.

use std::sync::Arc;

use super::{Effects, Key, Sensed};
use crate::model::Moves;
use crate::solve::sensitivity::{Figure, Sensitivity};
use crate::tui::app::{Anchor, App, Curves, Table};
use crate::tui::keys::ReadingCommand;
use crate::worker::{Request, SensitivityAnswer, SensitivityRequest};

impl App {
    /// Shows the sensitivities of the next available figure, or none.
    pub(crate) fn next_sensitivities(&mut self) {
        let order = order(&self.curves);
        let shown = self.sensitivities.sensed;
        let shown = order.iter().position(|one| Some(*one) == shown);
        let mut rest = order.into_iter().skip(shown.map_or(0, |shown| shown + 1));
        // Before the first peaks are known, the key selects the expected peak.
        let comes = |sensed| sensed == Sensed::Peak && self.curves.awaits_peaks();
        let next = rest.find(|one| self.sensitivity_key(*one).is_some() || comes(*one));
        if next.is_none() && self.sensitivities.sensed.is_none() {
            let (cursor, peak) = (ReadingCommand::CursorRight, ReadingCommand::NextPeak);
            let [cursor, peak, band] =
                [cursor, peak, ReadingCommand::Band].map(|command| self.keys.key_of(command));
            return self.refuse(format!(
                "sensitivities are of the cursor ({cursor}), a peak ({peak}), a mode or a band ({band})"
            ));
        }
        self.sensitivities.sensed = next;
        if let (Some(Sensed::Peak), Some(row)) = (next, self.curves.peak_at_cursor()) {
            // The cursor follows the peak while a parameter changes.
            self.tables.peaks.row = row;
            self.tables.anchor = Anchor::Peak;
            self.follow_anchor();
        }
        if let Some(sensed) = next {
            self.sensitivities.effects = None;
            self.tables.open = Some(Table::Sensitivities);
            self.done(match sensed {
                Sensed::Cursor => "sensitivities of the level at the cursor",
                Sensed::Peak => "sensitivities of the selected peak",
                Sensed::Mode => "sensitivities of the selected mode",
                Sensed::Band => "sensitivities of the mean-square level in the band",
            });
        } else {
            self.tables.close(Table::Sensitivities);
            self.done("sensitivities hidden");
        }
    }

    /// Whether the figure does not exist, or no longer.
    pub fn lacks_figure(&self) -> bool {
        let key = |sensed| self.sensitivity_key(sensed);
        self.curves.is_resolved() && self.sensitivities.sensed.and_then(key).is_none()
    }

    /// The key of the next request; none if the figure does not exist.
    fn sensitivity_key(&self, sensed: Sensed) -> Option<Key> {
        let first = self.curves.first_trace();
        let of = |at: [f64; 2]| Key {
            generation: self.curves.generation,
            sensed,
            response: first.map_or_else(String::new, |(_, trace)| trace.response.clone()),
            at,
        };
        if sensed != Sensed::Mode {
            first?;
        }
        match sensed {
            Sensed::Cursor => self.curves.cursor.map(|f| of([f, f])),
            Sensed::Peak => {
                let peak = self.curves.peaks().get(self.tables.peaks.row)?;
                Some(of([peak.frequency; 2]))
            }
            Sensed::Mode => {
                let list = self.modes.list.as_ref()?;
                let row = list.rows.get(self.tables.modes.row)?;
                Some(of([row.frequency; 2]))
            }
            Sensed::Band => self.curves.band.map(of),
        }
    }

    /// Requests the visible sensitivities.
    pub(crate) fn want_sensitivities(&mut self) -> Option<Request> {
        let sensed = self.sensitivities.sensed?;
        // All figures except the cursor need resolved curves, and a repeated key must not wait for them.
        if !self.curves.is_resolved() {
            return None;
        }
        let key = self.sensitivity_key(sensed)?;
        if self.sensitivities.asked.is(|(asked, _)| *asked == key) {
            return None;
        }
        let model = Arc::clone(self.document.model());
        let enabled = model.responses.iter().filter(|one| one.enabled);
        let response = enabled
            .map(|one| &one.name)
            .position(|name| *name == key.response)
            .unwrap_or_default();
        // A mode found by the count may be near the selected one, or in the band.
        let modes = self.modes.counted_modes(key.generation);
        let frequency = key.at[0];
        let figure = match sensed {
            Sensed::Cursor => Figure::Level {
                response,
                frequency,
            },
            Sensed::Peak => Figure::Peak {
                response,
                frequency,
            },
            Sensed::Mode => Figure::Mode {
                modes: modes?,
                index: self.tables.modes.row,
            },
            Sensed::Band => Figure::Band {
                response,
                modes: modes?,
                band: key.at,
            },
        };
        let serial = self.requests.next_serial();
        let asked = (key, Arc::clone(&model));
        self.sensitivities.asked.sent(serial, asked);
        Some(Request::Sensitivity(SensitivityRequest {
            serial,
            model,
            figure,
        }))
    }

    /// Stores the sensitivities of the last request.
    pub(crate) fn take_sensitivities(&mut self, answer: SensitivityAnswer) {
        let Some((key, model)) = self.sensitivities.asked.answered(answer.serial) else {
            return;
        };
        let found = match answer.result {
            Ok(found) => found,
            Err(reason) => {
                (self.sensitivities.effects, self.sensitivities.failure) = (None, Some(reason));
                return;
            }
        };
        let is_empty =
            |one: &Sensitivity| [one.level, one.frequency, one.damping_ratio] == [None; 3];
        if found.iter().all(is_empty) && answer.lack.is_some() {
            (self.sensitivities.effects, self.sensitivities.failure) = (None, answer.lack);
            return;
        }
        let mut effects = Effects::new(key, model, found);
        effects.lack = answer.lack;
        effects.follow(&Moves::new(model, self.document.model()));
        self.tables.sensitivities.set_rows(effects.rows.len());
        // The row follows the parameter that is edited.
        if let Some(place) = effects.places.get(&self.selection.node()) {
            self.tables.sensitivities.row = *place;
        }
        self.sensitivities.effects = Some(effects);
        self.sensitivities.failure = None;
    }

    /// Selects the parameter of the table's row in the tree, so that keys change it.
    pub(crate) fn follow_sensitivity(&mut self) {
        let row = self.tables.sensitivities.row;
        let effects = self.sensitivities.effects.as_ref();
        let Some(weighed) = effects.and_then(|effects| effects.rows.get(row)) else {
            return;
        };
        if let Some(node) = weighed.node {
            let model = Arc::clone(self.document.model());
            self.selection.select(&model, node);
        } else {
            let name = weighed.name.clone();
            self.refuse(format!("the model no longer has {name}"));
        }
    }
}

/// The order of the figures for the key: a cursor on a peak selects the peak first.
fn order(curves: &Curves) -> [Sensed; 4] {
    if curves.peak_at_cursor().is_some() {
        [Sensed::Peak, Sensed::Cursor, Sensed::Mode, Sensed::Band]
    } else {
        [Sensed::Cursor, Sensed::Peak, Sensed::Mode, Sensed::Band]
    }
}

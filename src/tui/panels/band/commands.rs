//! Marks the band, and requests the levels in it.

use std::sync::Arc;

use super::Key;
use crate::model::{Checked, Quantity};
use crate::tui::app::{App, Table};
use crate::unit::Form;
use crate::worker::{LevelsRequest, Request, Subject};

impl App {
    /// Marks the band between the cursors, or the visible one; if a band is marked, removes the mark.
    pub(crate) fn turn_band(&mut self) {
        if self.curves.band.take().is_some() {
            self.band.levels = None;
            self.tables.close(Table::Band);
            return self.done("band removed");
        }
        let span = match (self.curves.cursor, self.reading.second) {
            (Some(one), Some(other)) if one != other => [one.min(other), one.max(other)],
            _ => self.shown_frequencies(),
        };
        self.curves.band = Some(span);
        self.tables.open = Some(Table::Band);
        let [low, high] = span.map(|f| self.display.frequency_text(f));
        self.done(format!("band from {low} to {high}"));
    }

    /// Requests the levels in the band.
    pub(crate) fn want_levels(&mut self) -> Option<Request> {
        // A repeated key must not wait for them.
        if !self.curves.is_resolved() {
            return None;
        }
        let key = Key {
            generation: self.curves.generation,
            references: self.comparison.shown_ids(),
            span: self.curves.band?,
            // Inverse forms have no levels.
            form: self.display.form.filter(|form| !form.is_inverse()),
            motion: self.display.motion,
        };
        if self.band.asked.is(|asked| *asked == key) {
            return None;
        }
        let serial = self.requests.next_serial();
        let brought = |subject: Subject| match key.form {
            Some(form) => Subject {
                model: Arc::new(brought_to(&subject.model, form)),
                ..subject
            },
            None => subject,
        };
        let request = LevelsRequest {
            serial,
            subjects: self.compared_subjects().into_iter().map(brought).collect(),
            band: key.span,
        };
        self.band.asked.sent(serial, key);
        Some(Request::Levels(request))
    }
}

/// The model with its responses measured in a form.
fn brought_to(model: &Checked, form: Form) -> Checked {
    model.derived(|model| {
        for response in &mut model.responses {
            if let Quantity::Motion(_, measure) = &mut response.quantity {
                *measure = form.measure();
            }
        }
    })
}

//! The levels in a band of the frequency axis: maximum, mean square, and the reduction relative to a reference.

use std::sync::Arc;

use crate::model::{Checked, Quantity};
use crate::solve::Reference;
use crate::solve::band::Level;
use crate::tui::app::request::LastRequest;
use crate::tui::app::{App, Table};
use crate::unit::{Form, Kind};
use crate::worker::{LevelsAnswer, LevelsRequest, Request, Subject};

/// The key of a request for levels.
#[derive(Debug, Clone, PartialEq)]
struct Key {
    generation: u64,
    references: Vec<u64>,
    span: [f64; 2],
    form: Option<Form>,
    motion: bool,
}

/// The levels of one model in the band.
#[derive(Debug, Clone)]
pub struct MemberLevels {
    /// The label of the member of a study; none for the model itself.
    pub label: Option<String>,
    /// One for each enabled response.
    pub levels: Vec<ResponseLevel>,
}

/// The level of a response in the band, divided by the force where the display does so.
#[derive(Debug, Clone)]
pub struct ResponseLevel {
    /// The response's name.
    pub response: String,
    /// The unit of the maximum; none for an energy.
    pub kind: Kind,
    /// Maximum and mean square.
    pub level: Level,
}

/// The levels in the band.
#[derive(Debug)]
pub struct BandLevels {
    /// The model's generation.
    pub generation: u64,
    /// The model's members.
    pub members: Vec<MemberLevels>,
    /// The numbers of the references, and their members.
    pub references: Vec<(u64, Vec<MemberLevels>)>,
}

/// The marked band.
#[derive(Debug, Default)]
pub struct Band {
    /// Lower and upper end, Hz; none if no band is marked.
    pub span: Option<[f64; 2]>,
    /// The levels solved last.
    pub levels: Option<BandLevels>,
    /// Why the last request failed.
    pub failure: Option<String>,
    asked: LastRequest<Key>,
}

impl App {
    /// Marks the band between the cursors, or the visible one; if a band is marked, removes the mark.
    pub(crate) fn turn_band(&mut self) {
        if self.band.span.take().is_some() {
            self.band.levels = None;
            if self.tables.open == Some(Table::Band) {
                self.tables.open = None;
            }
            return self.done("band taken away");
        }
        let span = match (self.curves.cursor, self.reading.second) {
            (Some(one), Some(other)) if one != other => [one.min(other), one.max(other)],
            _ => self.shown_frequencies(),
        };
        self.band.span = Some(span);
        self.tables.open = Some(Table::Band);
        let [low, high] = span.map(|f| self.display.frequency_text(f));
        self.done(format!("band from {low} to {high}"));
    }

    /// The form of the levels: inverse forms have no levels.
    pub fn band_form(&self) -> Option<Form> {
        self.display.form.filter(|form| !form.is_inverse())
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
            span: self.band.span?,
            form: self.band_form(),
            motion: self.display.motion,
        };
        if self.band.asked.is(|asked| *asked == key) {
            return None;
        }
        let serial = self.next_serial();
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

    /// Stores the levels of the last request.
    pub(crate) fn take_levels(&mut self, answer: LevelsAnswer) {
        let Some(key) = self.band.asked.answered(answer.serial) else {
            return;
        };
        let solved = match answer.result {
            Ok(solved) => solved,
            Err(reason) => {
                (self.band.levels, self.band.failure) = (None, Some(reason));
                return;
            }
        };
        self.band.failure = None;
        let motion = key.motion;
        let mut solved = solved.into_iter().map(|members| {
            let members = members.into_iter().map(|member| MemberLevels {
                levels: response_levels(&member.model, &member.levels, motion),
                label: member.label,
            });
            members.collect()
        });
        self.band.levels = Some(BandLevels {
            generation: key.generation,
            members: solved.next().unwrap_or_default(),
            references: key.references.iter().copied().zip(solved).collect(),
        });
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

/// The levels of the enabled responses: of the `motion` itself, or divided by the force if there is exactly one.
fn response_levels(model: &Checked, levels: &[Level], motion: bool) -> Vec<ResponseLevel> {
    let reference = Reference::of(model).filter(|_| !motion);
    let enabled = model.responses.iter().filter(|one| one.enabled);
    enabled
        .zip(levels)
        .map(|(response, level)| {
            let kind = response.quantity.kind(reference.map(|one| one.load));
            let divisor = match (&reference, kind) {
                (Some(reference), Kind::Motion(_)) => reference.amplitude.norm(),
                _ => 1.0,
            };
            ResponseLevel {
                response: response.name.clone(),
                kind,
                level: Level {
                    maximum: level.maximum / divisor,
                    mean_square: level.mean_square / (divisor * divisor),
                    ..*level
                },
            }
        })
        .collect()
}

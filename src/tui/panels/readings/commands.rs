//! Reads the values at the cursors, and moves them.

use num_complex::Complex64;

use super::{Key, Read, Value, nearest};
use crate::tui::app::{App, Trace};
use crate::tui::keys::ReadingCommand;
use crate::tui::panels::chart::Member;
use crate::tui::scene;
use crate::worker::{Request, SampleRequest, Sampling};

/// The value solved at a frequency (Hz), else the value at the nearest solved one.
fn solved(
    read: Option<Read<'_>>,
    member: &Member,
    trace: &Trace,
    frequency: f64,
) -> Option<Solved> {
    if let Some(read) = read {
        return Some(Solved {
            value: read.value(),
            frequency,
            exact: true,
        });
    }
    let index = nearest(&member.frequencies, frequency)?;
    Some(Solved {
        value: trace.values[index],
        frequency: member.frequencies[index],
        exact: false,
    })
}

/// A level relative to the first reference at a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AgainstReference {
    /// dB, as drawn in the difference view.
    pub decibels: f64,
    /// Whether both curves were solved at this frequency.
    pub exact: bool,
}

/// A solved value.
#[derive(Debug, Clone, Copy)]
struct Solved {
    value: Complex64,
    /// Hz: the requested frequency, or the nearest solved one.
    frequency: f64,
    exact: bool,
}

impl App {
    /// The harmonics of the cursor in the sweep, Hz.
    pub fn harmonics(&self) -> Vec<f64> {
        let sweep = &self.model().sweep;
        self.reading.harmonics(self.curves.cursor, sweep.to)
    }

    /// A response of a member of the model at a frequency (Hz): exact, or at the nearest solved one.
    pub fn value_at(&self, number: usize, trace: &Trace, frequency: f64) -> Option<Value> {
        let solved = self.solved_at(number, trace, frequency)?;
        Some(self.shown_value(trace, solved))
    }

    /// The same for a reference, by id.
    pub fn reference_at(
        &self,
        (id, number): (u64, usize),
        member: &Member,
        trace: &Trace,
        frequency: f64,
    ) -> Option<Value> {
        let response = &trace.response;
        let read = self.reading.reference(id, number, response, frequency);
        let solved = solved(read, member, trace, frequency)?;
        Some(self.shown_value(trace, solved))
    }

    /// A response of a member of the model relative to the first reference, at a frequency (Hz).
    pub fn difference_at(
        &self,
        number: usize,
        trace: &Trace,
        frequency: f64,
    ) -> Option<AgainstReference> {
        let own = self.solved_at(number, trace, frequency)?;
        let reference = self.comparison.first_shown()?;
        let members = &reference.picture.as_ref()?.members;
        // The corresponding member, or the only one.
        let number = if number < members.len() { number } else { 0 };
        let member = members.get(number)?;
        let against = member.trace(&trace.response)?;
        let response = &trace.response;
        let read = self
            .reading
            .reference(reference.id, number, response, frequency);
        let other = solved(read, member, against, frequency)?;
        let value = self.display.per_force(trace, own.value);
        let against = self.display.per_force(against, other.value);
        Some(AgainstReference {
            decibels: scene::difference(trace.dimension.is_none(), value, against),
            exact: own.exact && other.exact,
        })
    }

    fn solved_at(&self, number: usize, trace: &Trace, frequency: f64) -> Option<Solved> {
        let picture = self.curves.picture()?;
        let generation = self.curves.generation;
        let response = &trace.response;
        let read = self.reading.model(generation, number, response, frequency);
        solved(read, picture.members.get(number)?, trace, frequency)
    }

    fn shown_value(&self, trace: &Trace, solved: Solved) -> Value {
        Value {
            shown: self.display.value(trace, solved.value, solved.frequency),
            exact: solved.exact,
        }
    }

    /// Puts the second cursor at the cursor, or removes it.
    pub(crate) fn turn_second(&mut self) {
        match (self.reading.second.take(), self.curves.cursor) {
            (Some(second), Some(cursor)) if second != cursor => {
                self.reading.second = Some(cursor);
                self.done("second cursor moved here; press again to remove it");
            }
            (Some(_), _) => self.done("second cursor removed"),
            (None, Some(cursor)) => {
                self.reading.second = Some(cursor);
                self.done("second cursor here: differences are relative to it");
            }
            (None, None) => {
                let key = self.keys.key_of(ReadingCommand::CursorRight);
                self.refuse(format!("there is no cursor: {key} shows it"));
            }
        }
    }

    pub(crate) fn turn_harmonics(&mut self) {
        if self.curves.cursor.is_none() {
            let key = self.keys.key_of(ReadingCommand::CursorRight);
            return self.refuse(format!("there is no cursor: {key} shows it"));
        }
        self.reading.harmonics = !self.reading.harmonics;
        let count = self.harmonics().len();
        self.done(match (self.reading.harmonics, count) {
            (false, _) => "harmonics hidden".to_owned(),
            (true, 0) => "harmonics of the cursor: none within the sweep".to_owned(),
            (true, count) => format!("harmonics of the cursor: {count} within the sweep"),
        });
    }

    /// Requests the values at the cursors.
    pub(crate) fn want_reading(&mut self) -> Option<Request> {
        let cursor = self.curves.cursor?;
        let mut frequencies: Vec<f64> = std::iter::once(cursor)
            .chain(self.reading.second)
            .chain(self.harmonics())
            .collect();
        frequencies.sort_by(f64::total_cmp);
        frequencies.dedup();
        let key = Key {
            generation: self.curves.generation,
            references: self.comparison.shown_ids(),
            frequencies,
        };
        if self.reading.asked.is(|asked| *asked == key) {
            return None;
        }
        let serial = self.requests.next_serial();
        let request = SampleRequest {
            serial,
            sampling: Sampling::Reading,
            subjects: self.compared_subjects(),
            frequencies: key.frequencies.clone(),
        };
        self.reading.asked.sent(serial, key);
        Some(Request::Sample(request))
    }
}

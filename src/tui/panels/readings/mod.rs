//! The values at the cursors: solved there, not interpolated.

pub(crate) mod view;

use num_complex::Complex64;

use crate::tui::app::request::LastRequest;
use crate::tui::app::{App, Compared, Trace};
use crate::tui::keys::ReadingCommand;
use crate::tui::panels::chart::curves::Member;
use crate::tui::scene;
use crate::worker::{Request, SampleAnswer, SampleRequest, Sampling};

/// Harmonics of the cursor, the cursor itself included.
const HARMONICS: u32 = 10;

/// The key of a request.
#[derive(Debug, Clone, PartialEq)]
struct Key {
    generation: u64,
    references: Vec<u64>,
    frequencies: Vec<f64>,
}

/// The values at some frequencies.
#[derive(Debug)]
struct Values {
    key: Key,
    curves: Compared,
}

/// The state of the readings.
#[derive(Debug, Default)]
pub struct Reading {
    /// The second cursor, Hz.
    pub second: Option<f64>,
    /// Whether the harmonics of the cursor are marked.
    pub harmonics: bool,
    asked: LastRequest<Key>,
    values: Option<Values>,
}

/// A response at a frequency, solved there.
#[derive(Debug, Clone, Copy)]
pub struct Read<'a> {
    /// The response at the requested frequencies.
    trace: &'a Trace,
    index: usize,
}

impl Read<'_> {
    /// The value, divided by the force if there is exactly one.
    pub fn value(&self) -> Complex64 {
        self.trace.values[self.index]
    }
}

impl Reading {
    /// A response of a member of the model at a frequency (Hz), if solved for the model with this generation.
    pub fn model(
        &self,
        generation: u64,
        member: usize,
        response: &str,
        frequency: f64,
    ) -> Option<Read<'_>> {
        let values = self.values.as_ref()?;
        let member = values.curves.members.get(member)?;
        (values.key.generation == generation)
            .then(|| read(member, response, frequency))
            .flatten()
    }

    /// The same for a reference, by id.
    pub fn reference(
        &self,
        id: u64,
        member: usize,
        response: &str,
        frequency: f64,
    ) -> Option<Read<'_>> {
        let values = self.values.as_ref()?;
        let members = values.curves.reference(id)?;
        read(members.get(member)?, response, frequency)
    }

    /// Stores the answer to the last request.
    ///
    /// # Errors
    /// Why the solution failed, in one line.
    pub(crate) fn take(&mut self, answer: SampleAnswer) -> Result<(), String> {
        let Some(key) = self.asked.answered(answer.serial) else {
            return Ok(());
        };
        self.values = Some(Values {
            key: key.clone(),
            curves: Compared::new(answer.result?, &key.references),
        });
        Ok(())
    }
}

/// The index of the nearest frequency; none if there are none.
pub fn nearest(frequencies: &[f64], to: f64) -> Option<usize> {
    let after = frequencies.partition_point(|frequency| *frequency < to);
    let around = [after.saturating_sub(1), after].into_iter();
    let inside = around.filter(|i| *i < frequencies.len());
    let distance = |i: &usize| (frequencies[*i] - to).abs();
    inside.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

fn read<'a>(member: &'a Member, response: &str, frequency: f64) -> Option<Read<'a>> {
    let index = member.frequencies.iter().position(|f| *f == frequency)?;
    Some(Read {
        trace: member.trace(response)?,
        index,
    })
}

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

/// A value at a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Value {
    /// As displayed: in the form, divided by the force if there is exactly one.
    pub shown: Complex64,
    /// Whether it was solved at this frequency; else it is that of the nearest solved one.
    pub exact: bool,
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

    /// The harmonics of the cursor in the sweep, Hz: 2, 3, .. times its frequency.
    pub fn harmonics(&self) -> Vec<f64> {
        let Some(cursor) = self.curves.cursor.filter(|_| self.reading.harmonics) else {
            return Vec::new();
        };
        let to = self.model().sweep.to;
        (2..=HARMONICS)
            .map(|order| f64::from(order) * cursor)
            .filter(|f| *f <= to)
            .collect()
    }

    /// Puts the second cursor at the cursor, or removes it.
    pub(crate) fn turn_second(&mut self) {
        match (self.reading.second.take(), self.curves.cursor) {
            (Some(second), Some(cursor)) if second != cursor => {
                self.reading.second = Some(cursor);
                self.done("second cursor moved here; again at its place takes it away");
            }
            (Some(_), _) => self.done("second cursor taken away"),
            (None, Some(cursor)) => {
                self.reading.second = Some(cursor);
                self.done("second cursor here: differences are counted from it");
            }
            (None, None) => {
                let key = self.keys.key_of(ReadingCommand::CursorRight);
                self.refuse(format!("there is no cursor: {key} puts one on the chart"));
            }
        }
    }

    pub(crate) fn turn_harmonics(&mut self) {
        if self.curves.cursor.is_none() {
            let key = self.keys.key_of(ReadingCommand::CursorRight);
            return self.refuse(format!("there is no cursor: {key} puts one on the chart"));
        }
        self.reading.harmonics = !self.reading.harmonics;
        let count = self.harmonics().len();
        self.done(match (self.reading.harmonics, count) {
            (false, _) => "without harmonics".to_owned(),
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
        let serial = self.next_serial();
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

//! The values at the cursors: solved there, not interpolated.

mod commands;
pub(crate) mod view;

use num_complex::Complex64;

use crate::tui::app::last_request::LastRequest;
use crate::tui::panels::chart::{Compared, Member, Trace};
use crate::worker::SampleAnswer;

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

    /// The harmonics of a cursor up to a frequency, Hz: 2, 3, .. times its frequency; none if they are not marked.
    pub fn harmonics(&self, cursor: Option<f64>, to: f64) -> Vec<f64> {
        let Some(cursor) = cursor.filter(|_| self.harmonics) else {
            return Vec::new();
        };
        (2..=HARMONICS)
            .map(|order| f64::from(order) * cursor)
            .filter(|f| *f <= to)
            .collect()
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

/// A value at a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Value {
    /// As displayed: in the form, divided by the force if there is exactly one.
    pub shown: Complex64,
    /// Whether it was solved at this frequency; else it is that of the nearest solved one.
    pub exact: bool,
}

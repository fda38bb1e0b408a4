//! Solved curves: the responses of a model, of the members of its study, and of references.

use std::time::Duration;

use num_complex::Complex64;

use crate::model::Checked;
use crate::solve::Reference;
use crate::solve::peaks::Peak;
use crate::solve::{Column, Frf};
use crate::unit::Dimension;
use crate::worker::{self, Stage};

/// One response over frequency.
#[derive(Debug, Clone)]
pub struct Trace {
    /// The response's name.
    pub response: String,
    /// The dimension of the values; none for an energy, which is real and has ten decibels per decade.
    pub dimension: Option<Dimension>,
    /// The load that divides the values; none for the motion under the forces, or an energy.
    pub force: Option<Complex64>,
    /// One value per frequency, divided by the force if there is exactly one.
    pub values: Vec<Complex64>,
    /// The peaks by rising frequency, divided as the values; none until the curves are resolved.
    pub peaks: Vec<Peak>,
}

/// The responses of the model, or of one member of a study.
#[derive(Debug, Clone)]
pub struct Member {
    /// The member's label; none for the model itself.
    pub label: Option<String>,
    /// Hz.
    pub frequencies: Vec<f64>,
    /// In the order of the model's responses.
    pub traces: Vec<Trace>,
    /// The damping ratios of the modes; the peaks refer to them.
    pub damping_ratios: Vec<f64>,
}

impl Member {
    /// The curve of a response, by name.
    pub fn trace(&self, response: &str) -> Option<&Trace> {
        self.traces.iter().find(|trace| trace.response == response)
    }
}

/// Curves of one model.
#[derive(Debug)]
pub struct Picture {
    /// The model's generation.
    pub generation: u64,
    /// How complete the curves are: coarse, all sweep frequencies, or with the extra frequencies at peaks.
    pub stage: Stage,
    /// The time of the solution.
    pub elapsed: Duration,
    /// The model, or the members of a study.
    pub members: Vec<Member>,
    /// Frequencies (Hz) at which a response is not finite.
    pub singular: Vec<f64>,
}

impl Picture {
    /// The resolved curves of a model to compare with.
    pub(crate) fn of_reference(curves: worker::Curves) -> Self {
        Self::new(0, Stage::Counted, Duration::ZERO, curves)
    }

    pub(super) fn new(
        generation: u64,
        stage: Stage,
        elapsed: Duration,
        curves: worker::Curves,
    ) -> Self {
        let mut singular: Vec<f64> = curves
            .members
            .iter()
            .flat_map(|member| member.frf.singular())
            .collect();
        singular.sort_by(f64::total_cmp);
        singular.dedup();
        Self {
            generation,
            stage,
            elapsed,
            members: curves.members.into_iter().map(member).collect(),
            singular,
        }
    }

    /// Number of points of a curve, of responses and of members.
    pub fn extent(&self) -> (usize, usize, usize) {
        let first = self.members.first();
        (
            first.map_or(0, |member| member.frequencies.len()),
            first.map_or(0, |member| member.traces.len()),
            self.members.len(),
        )
    }
}

/// The curves of a model as displayed.
pub(crate) fn member(member: worker::Member) -> Member {
    Member {
        label: member.label,
        traces: traces(&member.model, &member.frf, member.peaks),
        frequencies: member.frf.frequencies,
        damping_ratios: member.damping_ratios,
    }
}

/// The responses of a model, divided by the force if there is exactly one; `peaks` per response, or none.
pub(crate) fn traces(model: &Checked, frf: &Frf, peaks: Vec<Vec<Peak>>) -> Vec<Trace> {
    let reference = Reference::of(model);
    let responses = model.responses.iter().filter(|one| one.enabled);
    let per = reference.map(|reference| reference.load);
    let mut peaks = peaks.into_iter();
    let columns = frf.columns.iter().zip(responses);
    columns
        .map(|(column, response)| {
            let peaks = peaks.next().unwrap_or_default();
            let dimension = response.kind(model, per).dimension();
            let reference = reference.as_ref().filter(|_| response.is_linear());
            trace(column, dimension, reference, peaks)
        })
        .collect()
}

fn trace(
    column: &Column,
    dimension: Option<Dimension>,
    reference: Option<&Reference>,
    mut peaks: Vec<Peak>,
) -> Trace {
    let mut values = column.values.clone();
    let force = reference.map(|reference| reference.amplitude);
    if let Some(amplitude) = force {
        for value in &mut values {
            *value /= amplitude;
        }
        for peak in &mut peaks {
            peak.height /= amplitude.norm();
            let turned = |phase: f64| wrapped(phase - amplitude.arg().to_degrees());
            peak.phase = peak.phase.map(turned);
        }
    }
    Trace {
        response: column.name.clone(),
        dimension,
        force,
        values,
        peaks,
    }
}

/// An angle (degrees) from -180 to 180.
fn wrapped(angle: f64) -> f64 {
    180.0 - (180.0 - angle).rem_euclid(360.0)
}

/// Curves of the model and the references at the same frequencies.
#[derive(Debug)]
pub struct Compared {
    /// The model's members.
    pub members: Vec<Member>,
    /// The members of the references, by id.
    references: Vec<(u64, Vec<Member>)>,
}

impl Compared {
    /// Splits the solution into the model's and that of the references with these ids.
    pub(crate) fn new(solved: Vec<Vec<worker::Member>>, references: &[u64]) -> Self {
        let mut solved = solved
            .into_iter()
            .map(|members| members.into_iter().map(member).collect());
        Self {
            members: solved.next().unwrap_or_default(),
            references: references.iter().copied().zip(solved).collect(),
        }
    }

    /// The members of the reference with an id.
    pub fn reference(&self, id: u64) -> Option<&[Member]> {
        let mut references = self.references.iter();
        let (_, members) = references.find(|(known, _)| *known == id)?;
        Some(members)
    }
}

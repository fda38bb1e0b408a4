//! The curves on the chart: their data, their age, and which are visible.

use std::sync::Arc;
use std::time::Duration;

use num_complex::Complex64;

use crate::model::{Checked, Model, Spacing};
use crate::solve::Reference;
use crate::solve::peaks::Peak;
use crate::solve::{Column, Frf};
use crate::unit::Dimension;
use crate::worker::{self, CurvesAnswer, Stage};

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

    fn new(generation: u64, stage: Stage, elapsed: Duration, curves: worker::Curves) -> Self {
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
    let quantities = model.responses.iter().filter(|one| one.enabled);
    let per = reference.map(|reference| reference.load);
    let dimensions = quantities.map(|one| one.quantity.kind(per).motion());
    let mut peaks = peaks.into_iter();
    let columns = frf.columns.iter().zip(dimensions);
    columns
        .map(|(column, dimension)| {
            let peaks = peaks.next().unwrap_or_default();
            trace(column, dimension, reference.as_ref(), peaks)
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
    let force = reference.filter(|_| dimension.is_some());
    let force = force.map(|reference| reference.amplitude);
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

/// The content of the chart.
#[derive(Debug, Default)]
pub enum Shown {
    /// Nothing is solved yet.
    #[default]
    Nothing,
    /// Curves, possibly of an older model.
    Picture(Arc<Picture>),
    /// The last solution failed, and why; with the previous curves.
    Failed(String, Option<Arc<Picture>>),
}

/// The chart's state.
#[derive(Debug)]
pub struct Curves {
    /// The generation of the last request.
    pub generation: u64,
    /// The first generation of this document: earlier answers belong to another one.
    oldest: u64,
    /// The content of the chart.
    pub shown: Shown,
    /// The newest resolved curves, possibly older than the visible ones; the value axis follows them.
    pub resolved: Option<Arc<Picture>>,
    /// The names of the visible responses.
    pub visible: Vec<String>,
    /// The study that is solved instead of the model alone.
    pub study: Option<usize>,
    /// Magnitudes in decibels.
    pub decibels: bool,
    /// A logarithmic frequency axis.
    pub log_frequency: bool,
    /// The cursor's frequency, Hz.
    pub cursor: Option<f64>,
    /// The visible band of the sweep, Hz; none for the whole sweep.
    pub window: Option<[f64; 2]>,
}

impl Curves {
    /// The chart of a newly opened model: its first response, no study.
    pub fn new(model: &Model, generation: u64) -> Self {
        let first_enabled = model
            .responses
            .iter()
            .filter(|response| response.enabled)
            .take(1);
        Self {
            generation,
            oldest: generation,
            shown: Shown::Nothing,
            resolved: None,
            visible: first_enabled
                .map(|response| response.name.clone())
                .collect(),
            study: None,
            decibels: false,
            log_frequency: model.sweep.spacing == Spacing::Log,
            cursor: None,
            window: None,
        }
    }

    /// The curves to draw, if there are any.
    pub fn picture(&self) -> Option<&Arc<Picture>> {
        match &self.shown {
            Shown::Nothing => None,
            Shown::Picture(picture) => Some(picture),
            Shown::Failed(_, picture) => picture.as_ref(),
        }
    }

    /// Whether the curves belong to an older model than the last request.
    pub fn is_stale(&self) -> bool {
        self.picture()
            .is_some_and(|picture| picture.generation != self.generation)
    }

    /// The first visible curve.
    pub fn first_trace(&self) -> Option<(&Member, &Trace)> {
        self.first_of(self.picture()?)
    }

    /// The first visible curve, as resolved last.
    pub fn first_resolved(&self) -> Option<(&Member, &Trace)> {
        self.first_of(self.resolved.as_ref()?)
    }

    fn first_of<'a>(&self, picture: &'a Picture) -> Option<(&'a Member, &'a Trace)> {
        let member = picture.members.first()?;
        let mut names = self.visible.iter();
        names.find_map(|name| Some((member, member.trace(name)?)))
    }

    /// Whether the curves are resolved and belong to the current model.
    pub fn is_resolved(&self) -> bool {
        matches!(&self.shown, Shown::Picture(picture)
            if picture.generation == self.generation && picture.stage >= Stage::Resolved)
    }

    /// Whether curves with all peaks are visible, of this model or an older one.
    pub fn shows_peaks(&self) -> bool {
        self.picture()
            .is_some_and(|picture| picture.stage >= Stage::Resolved)
    }

    /// Stores an answer unless a newer one is present; returns whether it was stored with curves.
    pub fn take(&mut self, answer: CurvesAnswer) -> bool {
        let newest = self
            .picture()
            .map_or(self.oldest, |picture| picture.generation);
        if answer.generation < newest || answer.generation > self.generation {
            return false;
        }
        match answer.result {
            Ok(curves) => {
                let picture = Arc::new(Picture::new(
                    answer.generation,
                    answer.stage,
                    answer.elapsed,
                    curves,
                ));
                if answer.stage >= Stage::Resolved {
                    self.resolved = Some(Arc::clone(&picture));
                }
                self.shown = Shown::Picture(picture);
                true
            }
            // The failure of an older model does not apply to this one.
            Err(_) if answer.generation != self.generation => false,
            Err(reason) => {
                self.shown = Shown::Failed(reason, self.picture().cloned());
                false
            }
        }
    }

    /// Shows one response alone; if it is alone already, all responses of its axis. Returns whether it is alone now.
    pub fn solo(&mut self, model: &Model, response: &str) -> bool {
        let quantity = |name: &str| {
            model
                .responses
                .iter()
                .find(|one| one.name == name)
                .map(|one| &one.quantity)
        };
        if self.visible == [response] {
            let kind = quantity(response).map(|one| one.kind(None));
            let alike = model
                .responses
                .iter()
                .filter(|one| Some(one.quantity.kind(None)) == kind);
            self.visible = alike.map(|one| one.name.clone()).collect();
            return false;
        }
        self.visible = vec![response.to_owned()];
        true
    }

    /// Shows or hides a response; returns whether it is visible now.
    pub fn toggle(&mut self, response: &str) -> bool {
        if let Some(at) = self.visible.iter().position(|name| name == response) {
            self.visible.remove(at);
            return false;
        }
        self.visible.push(response.to_owned());
        true
    }

    /// Whether a response is visible.
    pub fn shows(&self, response: &str) -> bool {
        self.visible.iter().any(|name| name == response)
    }

    /// Follows the responses of a changed model: renamed ones stay visible, new ones are shown, deleted ones are
    /// removed.
    pub fn follow(&mut self, before: &Model, after: &Model) {
        let had = |name: &str| {
            before
                .responses
                .iter()
                .any(|response| response.name == name)
        };
        let has = |name: &str| after.responses.iter().any(|response| response.name == name);
        if before.responses.len() == after.responses.len() {
            for (old, new) in before.responses.iter().zip(&after.responses) {
                if old.name != new.name && !has(&old.name) {
                    self.visible
                        .iter_mut()
                        .filter(|name| **name == old.name)
                        .for_each(|name| name.clone_from(&new.name));
                }
            }
        }
        self.visible.retain(|name| has(name));
        if after.responses.len() > before.responses.len() {
            let new = after
                .responses
                .iter()
                .filter(|response| !had(&response.name));
            self.visible
                .extend(new.map(|response| response.name.clone()));
        }
        self.study = self.study.and_then(|study| followed(study, before, after));
    }

    /// The visible responses of the model or of the first member of its study.
    pub fn shown_traces(&self) -> impl Iterator<Item = &Trace> {
        let members = self.picture().map(|picture| &picture.members);
        let first = members.and_then(|members| members.first());
        let traces = first.map_or(&[][..], |member| &member.traces);
        traces.iter().filter(|trace| self.shows(&trace.response))
    }

    /// The peaks of the first visible curve, as resolved last.
    pub fn peaks(&self) -> &[Peak] {
        self.first_resolved().map_or(&[], |(_, trace)| &trace.peaks)
    }

    /// The row of the peak at the cursor.
    pub(crate) fn peak_at_cursor(&self) -> Option<usize> {
        /// Relative frequency tolerance: how close the points of a curve come to a peak.
        const NEAR: f64 = 1e-4;
        let cursor = self.cursor?;
        let mut peaks = self.peaks().iter().map(|peak| peak.frequency);
        peaks.position(|f| (f - cursor).abs() < NEAR * f)
    }

    /// Whether peaks are not known yet, but will be.
    pub(crate) fn awaits_peaks(&self) -> bool {
        self.resolved.is_none() && !matches!(self.shown, Shown::Failed(..))
    }
}

/// The index of a study in a changed model: by name, or the same index after a rename.
fn followed(study: usize, before: &Model, after: &Model) -> Option<usize> {
    let name = &before.studies.get(study)?.name;
    let renamed = before.studies.len() == after.studies.len();
    let mut studies = after.studies.iter();
    studies
        .position(|one| one.name == *name)
        .or(renamed.then_some(study))
}

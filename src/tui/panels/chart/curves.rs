//! The curves on the chart: their age, and which are visible.

use std::sync::Arc;

use super::picture::{Member, Picture, Trace};
use crate::model::{Model, Spacing};
use crate::solve::peaks::Peak;
use crate::worker::{CurvesAnswer, Stage};

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

/// A kind of extremum of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    /// A maximum of the magnitude.
    Peak,
    /// A minimum.
    Dip,
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
    /// The marked band, Hz: lower and upper end.
    pub band: Option<[f64; 2]>,
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
            band: None,
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
        if self.visible == [response] {
            let mut all = model.responses.iter();
            let own = all.find(|one| one.name == response);
            let kind = own.map(|one| one.kind(model, None));
            let all = model.responses.iter();
            let alike = all.filter(|one| Some(one.kind(model, None)) == kind);
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

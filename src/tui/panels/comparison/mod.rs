//! Curves to compare with the model: frozen and loaded references, and measured curves.

mod commands;
pub(crate) mod view;

use std::sync::Arc;

use crate::model::Checked;
use crate::tui::app::last_request::LastRequest;
use crate::tui::panels::chart::picture::traces;
use crate::tui::panels::chart::{Curves, Display, Picture};
use crate::tui::panels::measured::{FitKey, Fitted, Measured, Sample, SampleKey};
use crate::unit::Dimension;
use crate::worker::{ReferenceAnswer, Request, SampleAnswer, Stage, Subject};

/// The curves of another state of the model, or of another model.
#[derive(Debug)]
pub struct Reference {
    /// A unique number.
    pub id: u64,
    /// Its name in the legend.
    pub name: String,
    /// The model.
    pub model: Arc<Checked>,
    /// The study that is shown, if any.
    pub study: Option<usize>,
    /// The curves; none until they are solved.
    pub picture: Option<Arc<Picture>>,
    /// Whether they are visible.
    pub shown: bool,
    /// Why solving failed.
    pub failure: Option<String>,
    /// Whether the curves belong to the previous model of this reference.
    outdated: bool,
}

impl Reference {
    /// Replaces the model, with a new id: the old curves stay visible until the new ones are solved.
    pub(crate) fn renew(&mut self, id: u64, model: Arc<Checked>) {
        (self.id, self.model, self.failure, self.outdated) = (id, model, None, true);
    }
}

/// References and measured curves.
#[derive(Debug, Default)]
pub struct Comparison {
    /// Older ones first.
    pub references: Vec<Reference>,
    /// Curves from files.
    pub measured: Vec<Measured>,
    /// The reference in work.
    asked: Option<u64>,
    pub(crate) measured_asked: LastRequest<SampleKey>,
    pub(crate) sample: Option<Sample>,
    /// How well the model fits the measured curves.
    pub fits: Vec<Fitted>,
    pub(crate) fit_key: Option<FitKey>,
}

impl Comparison {
    /// The visible references.
    pub fn shown(&self) -> impl Iterator<Item = &Reference> {
        self.references.iter().filter(|one| one.shown)
    }

    /// The first visible reference with curves: the differences are relative to it.
    pub fn first_shown(&self) -> Option<&Reference> {
        self.shown().find(|one| one.picture.is_some())
    }

    /// The ids of the visible references.
    pub(crate) fn shown_ids(&self) -> Vec<u64> {
        self.shown().map(|one| one.id).collect()
    }

    /// Stores the curves of a reference.
    pub(crate) fn take(&mut self, answer: ReferenceAnswer) {
        self.asked = None;
        let mut references = self.references.iter_mut();
        if let Some(one) = references.find(|one| one.id == answer.serial) {
            match answer.result {
                Ok(curves) => {
                    one.picture = Some(Arc::new(Picture::of_reference(curves)));
                    one.outdated = false;
                }
                Err(reason) => one.failure = Some(reason),
            }
        }
    }

    /// The first unused name of `name`, `name 2`, ...
    pub(crate) fn free_name(&self, name: &str) -> String {
        let taken = |name: &str| {
            self.references.iter().any(|one| one.name == name)
                || self.measured.iter().any(|one| one.name == name)
        };
        let numbered = (2..).map(|number| format!("{name} {number}"));
        let mut names = std::iter::once(name.to_owned()).chain(numbered);
        // The number of used names is finite.
        names
            .find(|name| !taken(name))
            .unwrap_or_else(|| name.to_owned())
    }

    /// The row of an entry by its unique name.
    pub(crate) fn row_of(&self, name: &str) -> Option<usize> {
        let references = self.references.iter().map(|one| &one.name);
        let measured = self.measured.iter().map(|one| &one.name);
        references.chain(measured).position(|known| known == name)
    }

    /// The name and the visibility of an entry.
    fn entry(&mut self, row: usize) -> Option<(&mut String, &mut bool)> {
        match row.checked_sub(self.references.len()) {
            None => self
                .references
                .get_mut(row)
                .map(|one| (&mut one.name, &mut one.shown)),
            Some(row) => self
                .measured
                .get_mut(row)
                .map(|one| (&mut one.name, &mut one.shown)),
        }
    }

    /// The number of entries: references, then measured curves.
    pub(crate) fn len(&self) -> usize {
        self.references.len() + self.measured.len()
    }

    /// Renames an entry.
    ///
    /// # Errors
    /// Why the name is refused, in one line.
    pub(crate) fn rename(&mut self, old: &str, name: &str) -> Result<(), String> {
        if name.is_empty() {
            return Err("type a name".to_owned());
        }
        if name != old && self.free_name(name) != name {
            return Err(format!("the name {name} is already used"));
        }
        let Some(row) = self.row_of(old) else {
            return Err(format!("{old} is no longer listed"));
        };
        if let Some((known, _)) = self.entry(row) {
            name.clone_into(known);
        }
        Ok(())
    }

    /// Requests the curves of a reference that needs them, one at a time.
    pub(crate) fn want(&mut self) -> Option<Request> {
        if self.asked.is_some() {
            return None;
        }
        let mut references = self.references.iter();
        // A reference that was frozen before its modes were counted needs the count, too.
        let lacks = |one: &&Reference| {
            let picture = one.picture.as_ref();
            let lacks = picture.is_none_or(|picture| picture.stage < Stage::Counted);
            (lacks || one.outdated) && one.failure.is_none()
        };
        let one = references.find(lacks)?;
        self.asked = Some(one.id);
        Some(Request::Reference(Subject {
            generation: one.id,
            model: Arc::clone(&one.model),
            study: one.study,
        }))
    }

    /// Stores the model at the frequencies of the measured curves.
    ///
    /// # Errors
    /// Why the model was not solved there, in one line.
    pub(crate) fn take_sample(&mut self, answer: SampleAnswer) -> Result<(), String> {
        let Some(&(generation, _)) = self.measured_asked.answered(answer.serial) else {
            return Ok(());
        };
        let solved = answer.result?.into_iter().flatten().next();
        self.sample = solved.map(|member| Sample {
            generation,
            traces: traces(&member.model, &member.frf, Vec::new()),
            frequencies: answer.frequencies,
        });
        Ok(())
    }

    /// Discards the model at the frequencies of the measured curves.
    pub(crate) fn forget_sample(&mut self) {
        self.measured_asked.forget();
        self.sample = None;
        self.fits.clear();
    }

    /// The visible measured curves that match a visible response, with the dimension of that response.
    pub fn measured_shown(
        &self,
        curves: &Curves,
        display: &Display,
    ) -> impl Iterator<Item = (&Measured, Option<Dimension>)> {
        let shown: Vec<Option<Dimension>> = curves
            .shown_traces()
            .map(|one| display.dimension_of(one))
            .collect();
        let measured = self.measured.iter().filter(|one| one.shown);
        measured.filter_map(move |one| {
            let mut matching = shown.iter().filter(|response| one.fits(response.as_ref()));
            matching.next().map(|response| (one, *response))
        })
    }
}

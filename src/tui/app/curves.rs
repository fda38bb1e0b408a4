//! The curves on the chart: which there are, how old they are, and which of them show.

use std::sync::Arc;
use std::time::Duration;

use crate::model::{BeamMotion, MassMotion, Measure, Model, Quantity, Spacing, Target};
use crate::solve::ColumnKind;
use crate::worker::{self, Answer, Stage};

/// Magnitudes of one response.
#[derive(Debug)]
pub struct Trace {
    /// The response's name.
    pub response: String,
    /// Unit of the magnitudes.
    pub unit: &'static str,
    /// Whether it is an energy, which has ten decibels a decade.
    pub energy: bool,
    /// One for each frequency.
    pub magnitudes: Vec<f64>,
}

/// The responses of the model, or of one member of a study.
#[derive(Debug)]
pub struct Member {
    /// The member's label; none for the model itself.
    pub label: Option<String>,
    /// Hz.
    pub frequencies: Vec<f64>,
    /// In the order of the model's responses.
    pub traces: Vec<Trace>,
}

/// Curves of one model.
#[derive(Debug)]
pub struct Picture {
    /// The model's generation.
    pub generation: u64,
    /// Whether these are all frequencies, or a coarse first answer.
    pub stage: Stage,
    /// How long they took.
    pub elapsed: Duration,
    /// The model, or the members of a study.
    pub members: Vec<Member>,
    /// Frequencies (Hz) at which some response is not finite.
    pub singular: Vec<f64>,
}

impl Picture {
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

    /// Points of a curve, responses and members.
    pub fn extent(&self) -> (usize, usize, usize) {
        let first = self.members.first();
        (
            first.map_or(0, |member| member.frequencies.len()),
            first.map_or(0, |member| member.traces.len()),
            self.members.len(),
        )
    }
}

fn member(member: worker::Member) -> Member {
    let trace = |column: crate::solve::Column| {
        let energy = column.kind == ColumnKind::Energy;
        let magnitude =
            |value: &num_complex::Complex64| if energy { value.re } else { value.norm() };
        Trace {
            magnitudes: column.values.iter().map(magnitude).collect(),
            response: column.name,
            unit: column.unit,
            energy,
        }
    };
    Member {
        label: member.label,
        frequencies: member.frf.frequencies,
        traces: member.frf.columns.into_iter().map(trace).collect(),
    }
}

/// What stands on the chart.
#[derive(Debug, Default)]
pub enum Shown {
    /// Nothing has been solved yet.
    #[default]
    Nothing,
    /// Curves; they may be older than the model.
    Picture(Arc<Picture>),
    /// There is no answer, and why; with the curves of before.
    Failed(String, Option<Arc<Picture>>),
}

/// The chart's state.
#[derive(Debug)]
pub struct Curves {
    /// The generation asked for last.
    pub generation: u64,
    /// The first generation of this document: an answer before it belongs to another one.
    oldest: u64,
    /// What stands on the chart.
    pub shown: Shown,
    /// The curves frozen for comparison.
    pub reference: Option<Arc<Picture>>,
    /// Names of the responses that show.
    pub visible: Vec<String>,
    /// The study that is solved in place of the model alone.
    pub study: Option<usize>,
    /// Magnitudes in decibels.
    pub decibels: bool,
    /// A logarithmic frequency axis.
    pub log_frequency: bool,
    /// The frequency (Hz) at which the chart is read.
    pub cursor: Option<f64>,
}

impl Curves {
    /// The chart of a model just opened: its first response, no study.
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
            reference: None,
            visible: first_enabled
                .map(|response| response.name.clone())
                .collect(),
            study: None,
            decibels: false,
            log_frequency: model.sweep.spacing == Spacing::Log,
            cursor: None,
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

    /// Whether the curves belong to an older model than the one asked for last.
    pub fn is_stale(&self) -> bool {
        self.picture()
            .is_some_and(|picture| picture.generation != self.generation)
    }

    /// The first curve that shows.
    pub fn first_trace(&self) -> Option<(&Member, &Trace)> {
        let picture = self.picture()?;
        let mut names = self.visible.iter();
        names.find_map(|name| {
            let member = picture.members.first()?;
            let trace = member.traces.iter().find(|trace| trace.response == *name)?;
            Some((member, trace))
        })
    }

    /// Takes an answer, unless a newer one stands there already.
    pub fn take(&mut self, answer: Answer) {
        let newest = self
            .picture()
            .map_or(self.oldest, |picture| picture.generation);
        if answer.generation < newest || answer.generation > self.generation {
            return;
        }
        self.shown = match answer.result {
            Ok(curves) => Shown::Picture(Arc::new(Picture::new(
                answer.generation,
                answer.stage,
                answer.elapsed,
                curves,
            ))),
            // An older model's failure says nothing of this one.
            Err(_) if answer.generation != self.generation => return,
            Err(reason) => Shown::Failed(reason, self.picture().cloned()),
        };
    }

    /// Shows one response alone; if it does already, all that can stand on its axis. Whether it is alone now.
    pub fn solo(&mut self, model: &Model, response: &str) -> bool {
        let quantity = |name: &str| {
            model
                .responses
                .iter()
                .find(|one| one.name == name)
                .map(|one| &one.quantity)
        };
        if self.visible == [response] {
            let dimension = quantity(response).map(Dimension::of);
            let alike = model
                .responses
                .iter()
                .filter(|one| Some(Dimension::of(&one.quantity)) == dimension);
            self.visible = alike.map(|one| one.name.clone()).collect();
            return false;
        }
        self.visible = vec![response.to_owned()];
        true
    }

    /// Shows or hides a response; whether it shows now.
    pub fn toggle(&mut self, response: &str) -> bool {
        if let Some(at) = self.visible.iter().position(|name| name == response) {
            self.visible.remove(at);
            return false;
        }
        self.visible.push(response.to_owned());
        true
    }

    /// Whether a response shows.
    pub fn shows(&self, response: &str) -> bool {
        self.visible.iter().any(|name| name == response)
    }

    /// Follows the responses of a changed model: a renamed one still shows, a new one shows, a deleted one is gone.
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
        self.study = self.study.filter(|study| *study < after.studies.len());
    }
}

/// What two responses share if they can stand on one axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Dimension {
    Energy,
    Length(Measure),
    Angle(Measure),
    AngleRate(Measure),
}

impl Dimension {
    fn of(quantity: &Quantity) -> Self {
        let Quantity::Motion(target, measure) = quantity else {
            return Self::Energy;
        };
        match target {
            Target::Beam(_, BeamMotion::W | BeamMotion::V)
            | Target::Mass(_, MassMotion::Y | MassMotion::Z) => Self::Length(*measure),
            Target::Beam(_, BeamMotion::PsiSlope) => Self::AngleRate(*measure),
            Target::Beam(..) | Target::Mass(_, MassMotion::Theta) => Self::Angle(*measure),
        }
    }
}

//! The one place that knows background threads: each works on the newest request and drops what is overtaken.
//!
//! Curves are answered in stages: where the whole sweep would take longer than [`PROMPT`], a coarse one over every few
//! frequencies and the last peaks comes first; then the whole sweep; then the modes, and the sweep with the points that
//! they need; then the count of the modes, with what it found missing. New curves cancel everything of older ones but the
//! preparation for an edit, and wait for none of it: modes, shapes and the finite-element witness have threads of their
//! own. A held key thus cancels every count but the last. A panic inside a solve becomes the answer's error; the thread
//! lives on.

mod background;
mod curves;
mod lane;
mod levels;
mod members;
mod memory;
mod resolve;
mod sample;
mod sensitivity;
mod tuning;
mod witness;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

pub(crate) use background::give_way;
use lane::{Lane, guarded};
use memory::Memory;
use resolve::{Resolver, Unresolved};
pub use sensitivity::{SensitivityAnswer, SensitivityRequest};
pub use tuning::{Pause, SpreadAnswer, SpreadRequest, TuneAnswer, TuneRequest, TuneStage};

use crate::model::Checked;
use crate::solve::band::Level;
use crate::solve::modes::{Modes, Shape, Shares, shape};
use crate::solve::operating::{Operating, operating};
use crate::solve::peaks::Peak;
use crate::solve::{Cancelled, Frf};

/// A sweep that would take longer than this, about the time of drawing, is preceded by a coarse one.
pub const PROMPT: Duration = Duration::from_micros(500);

/// Points along the beam at which a shape is given.
pub const SHAPE_POINTS: usize = 201;

/// What is asked of the worker.
#[derive(Debug, Clone)]
pub enum Request {
    /// Curves, modes and peaks. It cancels what is solved of older ones: modes, finite elements, the band that shows.
    Curves(Subject),
    /// Nothing: but an edit may follow, and what lies beside it can be found before.
    Expect(ExpectRequest),
    /// The shape of a mode.
    Shape(ShapeRequest),
    /// The curves of a finite-element model, at the frequencies of the sweep.
    Witness(Subject),
    /// Several models at a few frequencies.
    Sample(SampleRequest),
    /// The resolved curves of a model to compare with; its generation is a serial number.
    Reference(Subject),
    /// The levels of several models in a band.
    Levels(LevelsRequest),
    /// What the beam does at one frequency.
    Operating(OperatingRequest),
    /// Which parameter matters.
    Sensitivity(SensitivityRequest),
    /// Better parameters.
    Tune(TuneRequest),
    /// The end of the search for them.
    EndTuning,
    /// What tolerances make of the curves.
    Spread(SpreadRequest),
}

/// Which edits may follow: those of what differs between two models.
#[derive(Debug, Clone)]
pub struct ExpectRequest {
    /// A checked model.
    pub model: Arc<Checked>,
    /// The same after such an edit, checked.
    pub edited: Arc<Checked>,
}

/// Which models' levels are told in which band.
#[derive(Debug, Clone)]
pub struct LevelsRequest {
    /// Comes back with the answer.
    pub serial: u64,
    /// The models, each with its study.
    pub subjects: Vec<Subject>,
    /// From the lower to the upper end, Hz.
    pub band: [f64; 2],
}

/// What model's motion is told at which frequency.
#[derive(Debug, Clone)]
pub struct OperatingRequest {
    /// Comes back with the answer.
    pub serial: u64,
    /// A checked model.
    pub model: Arc<Checked>,
    /// Hz.
    pub frequency: f64,
}

/// What some frequencies are solved for; each has a thread of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// The band that shows, finely.
    Detail,
    /// The cursors.
    Reading,
    /// The frequencies of a measured curve.
    Measured,
}

/// Which models are solved at which frequencies.
#[derive(Debug, Clone)]
pub struct SampleRequest {
    /// Comes back with the answer.
    pub serial: u64,
    /// What it is for.
    pub sampling: Sampling,
    /// The models, each with its study.
    pub subjects: Vec<Subject>,
    /// Hz, rising.
    pub frequencies: Vec<f64>,
}

/// What curves are asked for.
#[derive(Debug, Clone)]
pub struct Subject {
    /// The model's generation; comes back with the answer.
    pub generation: u64,
    /// A checked model.
    pub model: Arc<Checked>,
    /// Index of the study whose members are wanted; none: the model alone.
    pub study: Option<usize>,
}

/// Which shape is asked for.
#[derive(Debug, Clone)]
pub struct ShapeRequest {
    /// The model's generation; comes back with the answer.
    pub generation: u64,
    /// A checked model.
    pub model: Arc<Checked>,
    /// Its modes.
    pub modes: Arc<Modes>,
    /// The index of one of them.
    pub index: usize,
}

/// What the worker has found.
#[derive(Debug, Clone)]
pub enum Answer {
    /// Curves, in stages.
    Curves(CurvesAnswer),
    /// The shape of a mode.
    Shape(ShapeAnswer),
    /// Finite-element curves.
    Witness(WitnessAnswer),
    /// Several models at a few frequencies.
    Sample(SampleAnswer),
    /// A model to compare with.
    Reference(ReferenceAnswer),
    /// The levels of several models in a band.
    Levels(LevelsAnswer),
    /// What the beam does at one frequency.
    Operating(OperatingAnswer),
    /// Which parameter matters.
    Sensitivity(SensitivityAnswer),
    /// How far the search for better parameters is.
    Tune(TuneAnswer),
    /// What tolerances make of the curves.
    Spread(SpreadAnswer),
}

/// The levels of several models in a band, or why there are none.
#[derive(Debug, Clone)]
pub struct LevelsAnswer {
    /// Of the request.
    pub serial: u64,
    /// For each subject its members, or one line that says what went wrong.
    pub result: Result<Vec<Vec<LevelsMember>>, String>,
}

/// The levels of one model in a band.
#[derive(Debug, Clone)]
pub struct LevelsMember {
    /// What tells it from the other members of its study.
    pub label: Option<String>,
    /// The model.
    pub model: Arc<Checked>,
    /// One for each enabled response.
    pub levels: Vec<Level>,
}

/// What the beam does at one frequency, or why that is not known.
#[derive(Debug, Clone)]
pub struct OperatingAnswer {
    /// Of the request.
    pub serial: u64,
    /// At [`SHAPE_POINTS`] places and more, or one line that says what went wrong.
    pub result: Result<Arc<Operating>, String>,
}

/// Several models at a few frequencies, or why not.
#[derive(Debug, Clone)]
pub struct SampleAnswer {
    /// Of the request.
    pub serial: u64,
    /// Of the request.
    pub sampling: Sampling,
    /// Hz, as they were asked for.
    pub frequencies: Vec<f64>,
    /// For each subject its members' responses, without peaks, or one line that says what went wrong.
    pub result: Result<Vec<Vec<Member>>, String>,
}

/// The resolved curves of a model to compare with, or why there are none.
#[derive(Debug, Clone)]
pub struct ReferenceAnswer {
    /// Of the request.
    pub serial: u64,
    /// The curves, or one line that says what went wrong.
    pub result: Result<Curves, String>,
}

/// Curves, or why there are none.
#[derive(Debug, Clone)]
pub struct CurvesAnswer {
    /// Of the request.
    pub generation: u64,
    /// How complete it is.
    pub stage: Stage,
    /// The curves, or one line that says what went wrong.
    pub result: Result<Curves, String>,
    /// From the start of the work to this answer.
    pub elapsed: Duration,
}

/// How complete an answer is, rising.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Few frequencies; the rest follows.
    Coarse,
    /// All frequencies of the sweep; peaks may lie between them.
    Full,
    /// Those, and the ones that peaks and anti-resonances need, with the modes; some may not be counted yet.
    Resolved,
    /// The same, with the count of all modes and what it found missing.
    Counted,
}

/// The curves of a model or of a study's members.
#[derive(Debug, Clone, PartialEq)]
pub struct Curves {
    /// One without a study; otherwise one for each member.
    pub members: Vec<Member>,
    /// The modes of the model itself, also under a study; none before the curves are resolved.
    pub modes: Option<ModalModel>,
}

/// The curves of one model.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// What tells it from the other members of its study.
    pub label: Option<String>,
    /// The model whose curves they are.
    pub model: Arc<Checked>,
    /// Its responses.
    pub frf: Frf,
    /// The peaks of each response; none before the curves are resolved.
    pub peaks: Vec<Vec<Peak>>,
    /// The damping ratios of its modes, which peaks refer to; none before the curves are resolved.
    pub damping_ratios: Vec<f64>,
}

/// The modes of a model up to the end of its sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct ModalModel {
    /// The modes.
    pub modes: Arc<Modes>,
    /// Who moves in each.
    pub shares: Vec<Shares>,
}

/// The shape of a mode, or why there is none.
#[derive(Debug, Clone)]
pub struct ShapeAnswer {
    /// Of the request.
    pub generation: u64,
    /// The mode's index.
    pub index: usize,
    /// The shape at [`SHAPE_POINTS`] places, or one line that says what went wrong.
    pub result: Result<Shape, String>,
}

/// Finite-element curves, or why there are none.
#[derive(Debug, Clone)]
pub struct WitnessAnswer {
    /// Of the request.
    pub generation: u64,
    /// In the order of the curves' members, or one line that says what went wrong.
    pub result: Result<Vec<WitnessMember>, String>,
}

/// The finite-element curves of one model.
#[derive(Debug, Clone, PartialEq)]
pub struct WitnessMember {
    /// How many elements the beam has.
    pub elements: usize,
    /// Its responses at the frequencies of the sweep.
    pub frf: Frf,
    /// The largest difference of each response to the exact one; none where they have no finite ratio.
    pub differences: Vec<Option<Difference>>,
}

/// How far two curves are apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Difference {
    /// Of the magnitudes, dB.
    pub decibels: f64,
    /// Where, Hz.
    pub frequency: f64,
}

/// Background threads that solve. Dropping it cancels the work and joins them.
#[derive(Debug)]
pub struct Worker {
    curves: Lane<Subject>,
    /// Prepares for the next edit.
    expected: Arc<Lane<ExpectRequest>>,
    /// Whoever solves curves hands them on to it.
    resolving: Arc<Lane<Unresolved>>,
    shapes: Lane<ShapeRequest>,
    witness: Lane<Subject>,
    details: Lane<SampleRequest>,
    readings: Lane<SampleRequest>,
    measured: Lane<SampleRequest>,
    references: Lane<Subject>,
    levels: Lane<LevelsRequest>,
    operating: Lane<OperatingRequest>,
    sensitivities: Lane<SensitivityRequest>,
    tuning: Lane<TuneRequest>,
    spreads: Lane<SpreadRequest>,
}

impl Worker {
    /// Starts the threads; they hand their answers to `notify`.
    pub fn start(notify: impl Fn(Answer) + Clone + Send + 'static) -> Self {
        let memory = Memory::default();
        let mut resolver = Resolver::new(memory.clone());
        let tell = notify.clone();
        let resolving = Arc::new(Lane::start(move |unresolved, cancel: &_| {
            resolver.answer(&unresolved, cancel, &|answer| tell(Answer::Curves(answer)));
        }));
        let tell = notify.clone();
        let next = Arc::clone(&resolving);
        let expected = Arc::new(preparation(memory.clone()));
        let preparing = Arc::clone(&expected);
        let curves = Lane::start(move |subject: Subject, cancel: &_| {
            let tell = |answer| tell(Answer::Curves(answer));
            let before = memory.last(0);
            if let Ok(Ok(unresolved)) = curves::answer(subject, &memory, cancel, &tell) {
                if let Some(edit) = memory.missing(before, &unresolved.members) {
                    preparing.give(edit);
                }
                next.give(unresolved);
            }
        });
        let tell = notify.clone();
        let tuning = Lane::start(move |request, cancel: &_| {
            tuning::search(&request, cancel, &|answer| tell(Answer::Tune(answer)));
        });
        Self {
            curves,
            expected,
            resolving,
            shapes: answering(&notify, Answer::Shape, shape_of),
            witness: answering(&notify, Answer::Witness, witness::answer),
            details: answering(&notify, Answer::Sample, sample::answer),
            readings: answering(&notify, Answer::Sample, sample::answer),
            measured: answering(&notify, Answer::Sample, sample::answer),
            references: answering(&notify, Answer::Reference, sample::reference),
            levels: answering(&notify, Answer::Levels, levels::answer),
            operating: answering(&notify, Answer::Operating, operating_of),
            sensitivities: answering(&notify, Answer::Sensitivity, sensitivity::answer),
            tuning,
            spreads: answering(&notify, Answer::Spread, tuning::spread),
        }
    }

    /// Asks for something; what was asked of its kind before is cancelled and may stay without its full answer.
    pub fn request(&self, request: Request) {
        match request {
            Request::Curves(subject) => {
                self.resolving.cancel();
                self.witness.cancel();
                self.details.cancel();
                self.curves.give(subject);
            }
            Request::Expect(request) => self.expected.give(request),
            Request::Shape(request) => self.shapes.give(request),
            Request::Witness(subject) => self.witness.give(subject),
            Request::Levels(request) => self.levels.give(request),
            Request::Operating(request) => self.operating.give(request),
            Request::Sensitivity(request) => self.sensitivities.give(request),
            Request::Tune(request) => self.tuning.give(request),
            Request::EndTuning => self.tuning.cancel(),
            Request::Spread(request) => self.spreads.give(request),
            Request::Reference(subject) => self.references.give(subject),
            Request::Sample(request) => match request.sampling {
                Sampling::Detail => self.details.give(request),
                Sampling::Reading => self.readings.give(request),
                Sampling::Measured => self.measured.give(request),
            },
        }
    }
}

/// A thread whose requests have one answer each, or none where they were cancelled.
fn answering<R: Send + 'static, A: 'static>(
    notify: &(impl Fn(Answer) + Clone + Send + 'static),
    wrap: fn(A) -> Answer,
    answer: fn(&R, &AtomicBool) -> Result<A, Cancelled>,
) -> Lane<R> {
    let notify = notify.clone();
    Lane::start(move |request, cancel: &_| {
        if let Ok(found) = answer(&request, cancel) {
            notify(wrap(found));
        }
    })
}

/// Finds what lies beside an edit, in threads that give way.
fn preparation(memory: Memory) -> Lane<ExpectRequest> {
    let pool = background::pool();
    Lane::start(move |request: ExpectRequest, cancel: &_| {
        let expect = || memory.expect(&request, cancel);
        // A fault of the solver is told where it is asked for curves.
        drop(guarded(|| {
            Ok(match &pool {
                Some(pool) => pool.install(expect),
                None => expect(),
            }?)
        }));
    })
}

fn shape_of(request: &ShapeRequest, _: &AtomicBool) -> Result<ShapeAnswer, Cancelled> {
    let ShapeRequest {
        generation,
        model,
        modes,
        index,
    } = request;
    let result = guarded(|| Ok(shape(model, modes, *index, SHAPE_POINTS)))?;
    Ok(ShapeAnswer {
        generation: *generation,
        index: *index,
        result,
    })
}

fn operating_of(request: &OperatingRequest, _: &AtomicBool) -> Result<OperatingAnswer, Cancelled> {
    let solve = || operating(&request.model, request.frequency, SHAPE_POINTS);
    Ok(OperatingAnswer {
        serial: request.serial,
        result: guarded(|| Ok(Arc::new(solve())))?,
    })
}

#[cfg(test)]
mod tests;

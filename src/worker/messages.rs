//! Requests to the worker and its answers.

use std::sync::Arc;
use std::time::Duration;

use super::tuning::{SpreadAnswer, SpreadRequest, TuneAnswer, TuneRequest};
use crate::model::Checked;
use crate::solve::Frf;
use crate::solve::band::Level;
use crate::solve::modes::{Modes, Shape, Shares};
use crate::solve::operating::Operating;
use crate::solve::peaks::Peak;
use crate::solve::sensitivity::{Figure, Sensitivity};

/// The number of points along the beam of a shape.
pub const SHAPE_POINTS: usize = 201;

/// A request to the worker.
#[derive(Debug, Clone)]
pub enum Request {
    /// Curves, modes and peaks. Cancels the older curves, modes, finite elements and zoomed band.
    Curves(Subject),
    /// Prepares the cache for an edit that may follow; has no answer.
    Expect(ExpectRequest),
    /// The shape of a mode.
    Shape(ShapeRequest),
    /// The curves of a finite-element model at the frequencies of the sweep.
    Witness(Subject),
    /// Several models at given frequencies.
    Sample(SampleRequest),
    /// The resolved curves of a reference model; its generation is a serial number.
    Reference(Subject),
    /// The levels of several models in a band.
    Levels(LevelsRequest),
    /// The operating deflection shape at one frequency.
    Operating(OperatingRequest),
    /// How a figure changes with each parameter.
    Sensitivity(SensitivityRequest),
    /// Tunes the parameters.
    Tune(TuneRequest),
    /// Stops tuning.
    EndTuning,
    /// The band of the curves under tolerances.
    Spread(SpreadRequest),
}

/// The edits to prepare for: those of the parameters in which two models differ.
#[derive(Debug, Clone)]
pub struct ExpectRequest {
    /// The model.
    pub model: Arc<Checked>,
    /// The model after such an edit, checked.
    pub edited: Arc<Checked>,
}

/// The models and the band of a request for levels.
#[derive(Debug, Clone)]
pub struct LevelsRequest {
    /// Returned with the answer.
    pub serial: u64,
    /// The models, each with its study.
    pub subjects: Vec<Subject>,
    /// Lower and upper end, Hz.
    pub band: [f64; 2],
}

/// The model and the frequency of a request for an operating deflection shape.
#[derive(Debug, Clone)]
pub struct OperatingRequest {
    /// Returned with the answer.
    pub serial: u64,
    /// The model.
    pub model: Arc<Checked>,
    /// Hz.
    pub frequency: f64,
}

/// The purpose of a sample; each has its own thread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// The zoomed band, with a fine step.
    Detail,
    /// The cursors.
    Reading,
    /// The frequencies of a measured curve.
    Measured,
}

/// Models and the frequencies at which to solve them.
#[derive(Debug, Clone)]
pub struct SampleRequest {
    /// Returned with the answer.
    pub serial: u64,
    /// Its purpose.
    pub sampling: Sampling,
    /// The models, each with its study.
    pub subjects: Vec<Subject>,
    /// Hz, ascending.
    pub frequencies: Vec<f64>,
}

/// A model, or the members of one of its studies, to solve.
#[derive(Debug, Clone)]
pub struct Subject {
    /// The model's generation; returned with the answer.
    pub generation: u64,
    /// The model.
    pub model: Arc<Checked>,
    /// Index of the study whose members to solve; none: the model alone.
    pub study: Option<usize>,
}

/// The mode whose shape is requested.
#[derive(Debug, Clone)]
pub struct ShapeRequest {
    /// The model's generation; returned with the answer.
    pub generation: u64,
    /// The model.
    pub model: Arc<Checked>,
    /// Its modes.
    pub modes: Arc<Modes>,
    /// Index of the mode.
    pub index: usize,
}

/// An answer of the worker.
#[derive(Debug, Clone)]
pub enum Answer {
    /// Curves, in stages.
    Curves(CurvesAnswer),
    /// The shape of a mode.
    Shape(ShapeAnswer),
    /// Finite-element curves.
    Witness(WitnessAnswer),
    /// Several models at given frequencies.
    Sample(SampleAnswer),
    /// The curves of a reference model.
    Reference(ReferenceAnswer),
    /// The levels of several models in a band.
    Levels(LevelsAnswer),
    /// The operating deflection shape at one frequency.
    Operating(OperatingAnswer),
    /// How a figure changes with each parameter.
    Sensitivity(SensitivityAnswer),
    /// The progress or the result of tuning.
    Tune(TuneAnswer),
    /// The band of the curves under tolerances.
    Spread(SpreadAnswer),
}

/// The levels of several models in a band, or an error.
#[derive(Debug, Clone)]
pub struct LevelsAnswer {
    /// From the request.
    pub serial: u64,
    /// The members of each subject, or an error in one line.
    pub result: Result<Vec<Vec<LevelsMember>>, String>,
}

/// The levels of one model in a band.
#[derive(Debug, Clone)]
pub struct LevelsMember {
    /// Its label among the members of its study.
    pub label: Option<String>,
    /// The model.
    pub model: Arc<Checked>,
    /// One for each enabled response.
    pub levels: Vec<Level>,
}

/// The operating deflection shape at one frequency, or an error.
#[derive(Debug, Clone)]
pub struct OperatingAnswer {
    /// From the request.
    pub serial: u64,
    /// At [`SHAPE_POINTS`] points and more, or an error in one line.
    pub result: Result<Arc<Operating>, String>,
}

/// Several models at given frequencies, or an error.
#[derive(Debug, Clone)]
pub struct SampleAnswer {
    /// From the request.
    pub serial: u64,
    /// From the request.
    pub sampling: Sampling,
    /// Those of the request, Hz.
    pub frequencies: Vec<f64>,
    /// The responses of each subject's members, without peaks, or an error in one line.
    pub result: Result<Vec<Vec<Member>>, String>,
}

/// The resolved curves of a reference model, or an error.
#[derive(Debug, Clone)]
pub struct ReferenceAnswer {
    /// From the request.
    pub serial: u64,
    /// The curves, or an error in one line.
    pub result: Result<Curves, String>,
}

/// Curves, or an error.
#[derive(Debug, Clone)]
pub struct CurvesAnswer {
    /// From the request.
    pub generation: u64,
    /// Its completeness.
    pub stage: Stage,
    /// The curves, or an error in one line.
    pub result: Result<Curves, String>,
    /// Time from the start of the job to this answer.
    pub elapsed: Duration,
}

/// How complete an answer is, in ascending order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// A few frequencies; the rest follows.
    Coarse,
    /// All frequencies of the sweep; peaks may lie between them.
    Full,
    /// The same with the frequencies that peaks and anti-resonances need, and the modes, whose count may not be verified yet.
    Resolved,
    /// The same with a verified count of the modes, and the modes that the count found missing.
    Counted,
}

/// The curves of a model, or of the members of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Curves {
    /// One for each member of the study; one alone without a study.
    pub members: Vec<Member>,
    /// The modes of the model itself, also under a study; none before the curves are resolved.
    pub modes: Option<ModalModel>,
}

/// The curves of one model.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// Its label among the members of its study.
    pub label: Option<String>,
    /// The model.
    pub model: Arc<Checked>,
    /// Its responses.
    pub frf: Frf,
    /// The peaks of each response; none before the curves are resolved.
    pub peaks: Vec<Vec<Peak>>,
    /// The damping ratios of the modes that the peaks refer to; none before the curves are resolved.
    pub damping_ratios: Vec<f64>,
}

/// The modes of a model up to the end of its sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct ModalModel {
    /// The modes.
    pub modes: Arc<Modes>,
    /// The energy shares of each mode.
    pub shares: Vec<Shares>,
}

/// The shape of a mode, or an error.
#[derive(Debug, Clone)]
pub struct ShapeAnswer {
    /// From the request.
    pub generation: u64,
    /// The mode's index.
    pub index: usize,
    /// The shape at [`SHAPE_POINTS`] points, or an error in one line.
    pub result: Result<Shape, String>,
}

/// Finite-element curves, or an error.
#[derive(Debug, Clone)]
pub struct WitnessAnswer {
    /// From the request.
    pub generation: u64,
    /// In the order of the curves' members, or an error in one line.
    pub result: Result<Vec<WitnessMember>, String>,
}

/// The finite-element curves of one model.
#[derive(Debug, Clone, PartialEq)]
pub struct WitnessMember {
    /// The number of beam elements.
    pub elements: usize,
    /// Its responses at the frequencies of the sweep.
    pub frf: Frf,
    /// The largest difference of each response from the exact one; none where they have no finite ratio.
    pub differences: Vec<Option<Difference>>,
}

/// The difference of two curves at a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Difference {
    /// Of the magnitudes, dB.
    pub decibels: f64,
    /// Hz.
    pub frequency: f64,
}

/// The figure to differentiate, and its model.
#[derive(Debug, Clone)]
pub struct SensitivityRequest {
    /// Returned with the answer.
    pub serial: u64,
    /// The model.
    pub model: Arc<Checked>,
    /// The figure.
    pub figure: Figure,
}

/// How a figure changes with each parameter, or an error.
#[derive(Debug, Clone)]
pub struct SensitivityAnswer {
    /// From the request.
    pub serial: u64,
    /// For each parameter that is not 0, in the order of the model; or an error in one line.
    pub result: Result<Vec<Sensitivity>, String>,
    /// Why some of them are empty, if some are.
    pub lack: Option<String>,
}

//! Measured curves, and how well the model fits them.

use std::path::PathBuf;

use num_complex::Complex64;

use crate::escape::shown_path;
use crate::measured::{self, Curve, Fit, Inspection, fit};
use crate::model::{Fault, counted};
use crate::solve::Reference;
use crate::tui::app::{App, Display, Effect, Question, Trace};
use crate::tui::keys::CompareCommand;
use crate::tui::panels::chart::curves::traces;
use crate::tui::scene::ChartView;
use crate::unit::{Dimension, Form, Kind, ValueUnit};
use crate::worker::{Request, SampleAnswer, SampleRequest, Sampling};

/// The most measured curves that can be distinguished on the chart.
pub(crate) const MOST_CURVES: usize = 12;

/// The most frequencies at which a model is compared with measured curves; beyond, every second, third...
const MOST_FREQUENCIES: usize = 20_000;

/// A curve from a file.
#[derive(Debug)]
pub struct Measured {
    /// A unique number.
    pub id: u64,
    /// Its name in the legend.
    pub name: String,
    /// The curve.
    pub curve: Curve,
    /// Whether it is visible.
    pub shown: bool,
}

/// How well a response fits a measured curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    /// The id of the measured curve.
    pub measured: u64,
    /// The response.
    pub response: String,
    /// The quality of the fit, in the displayed form.
    pub fit: Fit,
}

/// The model at the frequencies of the measured curves.
#[derive(Debug)]
pub(crate) struct Sample {
    /// The model's generation.
    generation: u64,
    frequencies: Vec<f64>,
    traces: Vec<Trace>,
}

/// The inputs of a fit.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FitKey {
    serial: Option<u64>,
    solved: Option<u64>,
    form: Option<Form>,
    motion: bool,
    band: Option<[f64; 2]>,
    visible: Vec<String>,
}

/// The key of a request: the model's generation, and the ids of the measured curves.
pub(crate) type SampleKey = (u64, Vec<u64>);

/// The result of opening a measured file.
#[derive(Debug)]
pub enum OpenedMeasured {
    /// Its curves.
    Curves(Vec<Curve>),
    /// The file does not describe all its columns.
    Asks(PathBuf, Box<Inspection>),
    /// The file is not readable, and why.
    Faulty(PathBuf, Fault),
}

impl Measured {
    /// The dimension of its values, if it is a known motion.
    pub fn dimension(&self) -> Option<Dimension> {
        self.curve.kind.and_then(Kind::motion)
    }

    /// Whether it can share the axis of a response: its quantity is the same except for the measure of the motion, or
    /// is unknown.
    pub fn fits(&self, response: Option<&Dimension>) -> bool {
        match (self.curve.kind, response) {
            (None, _) | (Some(Kind::Energy), None) => true,
            (Some(Kind::Motion(own)), Some(response)) => {
                own.moves == response.moves && own.per == response.per
            }
            _ => false,
        }
    }

    /// The number of its values in a view.
    pub fn panels(&self, view: ChartView) -> usize {
        1 + usize::from(view.has_two_panels())
    }

    /// Its value at a frequency (Hz) in the form of a response, by linear interpolation; none beyond its ends.
    pub fn value_at(
        &self,
        display: &Display,
        response: Option<&Dimension>,
        frequency: f64,
    ) -> Option<Complex64> {
        let all = &self.curve.frequencies;
        let after = all.partition_point(|f| *f < frequency);
        let value = |i: usize| self.value(display, response, i);
        if all.get(after) == Some(&frequency) {
            return Some(value(after));
        }
        let before = after.checked_sub(1)?;
        let share = (frequency - all[before]) / (all.get(after)? - all[before]);
        Some(value(before) * (1.0 - share) + value(after) * share)
    }

    /// Whether its values are energies, when compared with a response.
    pub fn is_energy(&self, response: Option<&Dimension>) -> bool {
        self.curve.kind == Some(Kind::Energy) || (self.curve.kind.is_none() && response.is_none())
    }

    /// A value by its index, converted to the displayed form of the response it is compared with. An unknown quantity
    /// counts as that of the response.
    pub fn value(
        &self,
        display: &Display,
        response: Option<&Dimension>,
        index: usize,
    ) -> Complex64 {
        let (value, frequency) = (self.curve.values[index], self.curve.frequencies[index]);
        let shown = match (self.dimension().or(response.copied()), response) {
            (Some(own), Some(response)) => {
                own.converted(value, frequency, display.form_of(response))
            }
            _ => value,
        };
        // Without a phase, a conversion gives none either.
        if self.curve.phase_known {
            shown
        } else {
            shown.norm().into()
        }
    }
}

impl App {
    /// Handles an opened file; returns the effects.
    pub(crate) fn measured_opened(&mut self, opened: OpenedMeasured) -> Vec<Effect> {
        match opened {
            OpenedMeasured::Curves(curves) => self.take_measured(curves),
            OpenedMeasured::Asks(path, inspection) if self.is_of_responses(&inspection) => {
                return vec![Effect::OpenMeasured(
                    path,
                    Some(inspection.proposal.to_string()),
                )];
            }
            OpenedMeasured::Asks(path, inspection) => self.ask_columns(path, &inspection),
            OpenedMeasured::Faulty(path, fault) => {
                self.refuse_prompt(format!("{}: {fault}", shown_path(&path)));
            }
        }
        Vec::new()
    }

    /// Whether a table lacks only units, and its curves have the names of responses, as `beamtune frf` writes them:
    /// they are in the units of the responses then.
    fn is_of_responses(&self, inspection: &Inspection) -> bool {
        let named = |name: &String| self.model().responses.iter().any(|one| one.name == *name);
        inspection.format == measured::Format::Csv
            && inspection.missing == [measured::Question::Unit]
            && inspection.curves.iter().all(named)
    }

    /// A curve of unknown quantity with the name of a response: the quantity of that response under the given loads.
    fn named_alike(&self, mut curve: Curve) -> Curve {
        let mut responses = self.model().responses.iter();
        let alike = responses.find(|one| one.enabled && one.name == curve.name);
        if let (None, true, Some(alike)) = (curve.kind, curve.unknown.is_empty(), alike) {
            let reference = Reference::of(self.model());
            let kind = alike.quantity.kind(reference.map(|one| one.load));
            if let (Kind::Motion(_), Some(reference)) = (kind, reference) {
                for value in &mut curve.values {
                    *value /= reference.amplitude;
                }
            }
            curve.kind = Some(kind);
        }
        curve
    }

    /// Adds the curves of a file, or asks which, if there are more than the limit.
    pub(crate) fn take_measured(&mut self, curves: Vec<Curve>) {
        self.overlay = None;
        let room = MOST_CURVES.saturating_sub(self.comparison.measured.len());
        if room == 0 {
            let list = self.keys.key_of(CompareCommand::List);
            return self.refuse(format!(
                "{MOST_CURVES} measured curves are the most: {list} lists them, to drop some"
            ));
        }
        if curves.len() > room {
            return self.ask_curves(curves);
        }
        let taken = curves.len();
        let notes = notes(&curves);
        for curve in curves {
            let curve = self.named_alike(curve);
            // A curve needs another name than the response it is compared with.
            let responses = &self.model().responses;
            let name = if responses.iter().any(|one| one.name == curve.name) {
                self.comparison
                    .free_name(&format!("{} measured", curve.name))
            } else {
                self.comparison.free_name(&curve.name)
            };
            let id = self.next_serial();
            self.comparison.measured.push(Measured {
                id,
                name,
                curve,
                shown: true,
            });
        }
        self.done(format!(
            "{}{notes}",
            counted(taken, "measured curve", "measured curves")
        ));
    }

    /// Asks for the description that a file lacks.
    fn ask_columns(&mut self, path: PathBuf, inspection: &Inspection) {
        let seen: Vec<String> = std::iter::once(inspection.question())
            .chain(inspection.recognised.iter().cloned())
            .collect();
        let question = Question::Columns {
            path,
            seen: seen.join("; "),
            preview: inspection.preview(),
        };
        let mut proposal = inspection.proposal.clone();
        // A single curve most likely measures the visible response.
        if let ([_], [unit], None) = (
            inspection.curves.as_slice(),
            self.shown_units().as_slice(),
            &proposal.unit,
        ) {
            proposal.unit = ValueUnit::parse(unit).ok();
        }
        self.ask_question(question, proposal.to_string());
    }

    /// Requests the model at the frequencies of the visible measured curves.
    pub(crate) fn want_measured(&mut self) -> Option<Request> {
        let shown = || self.comparison.measured.iter().filter(|one| one.shown);
        let ids: Vec<u64> = shown().map(|one| one.id).collect();
        let generation = self.curves.generation;
        if ids.is_empty() {
            self.forget_sample();
            return None;
        }
        let key = (generation, ids);
        if self.comparison.measured_asked.is(|asked| *asked == key) {
            return None;
        }
        let mut frequencies: Vec<f64> = shown()
            .flat_map(|one| {
                let all = &one.curve.frequencies;
                all.iter().copied().step_by(stride(all.len()))
            })
            .collect();
        frequencies.sort_by(f64::total_cmp);
        frequencies.dedup();
        let serial = self.next_serial();
        self.comparison.measured_asked.sent(serial, key);
        let mut subject = self.subject();
        subject.study = None;
        Some(Request::Sample(SampleRequest {
            serial,
            sampling: Sampling::Measured,
            subjects: vec![subject],
            frequencies,
        }))
    }

    /// Stores the model at the frequencies of the measured curves.
    pub(crate) fn take_measured_sample(&mut self, answer: SampleAnswer) -> Result<(), String> {
        let Some(&(generation, _)) = self.comparison.measured_asked.answered(answer.serial) else {
            return Ok(());
        };
        let solved = answer.result?.into_iter().flatten().next();
        self.comparison.sample = solved.map(|member| Sample {
            generation,
            traces: traces(&member.model, &member.frf, Vec::new()),
            frequencies: answer.frequencies,
        });
        Ok(())
    }

    /// The visible measured curves that match a visible response, with the dimension of that response.
    pub fn measured_shown(&self) -> impl Iterator<Item = (&Measured, Option<Dimension>)> {
        let shown: Vec<Option<Dimension>> = self
            .shown_traces()
            .map(|one| self.display.dimension_of(one))
            .collect();
        let measured = self.comparison.measured.iter().filter(|one| one.shown);
        measured.filter_map(move |one| {
            let mut beside = shown.iter().filter(|response| one.fits(response.as_ref()));
            beside.next().map(|response| (one, *response))
        })
    }

    /// Discards the model at the frequencies of the measured curves.
    pub(crate) fn forget_sample(&mut self) {
        self.comparison.measured_asked.forget();
        self.comparison.sample = None;
        self.comparison.fits.clear();
    }

    /// Computes the fits again, if their inputs changed.
    pub(crate) fn refresh_fits(&mut self) {
        let key = FitKey {
            serial: self.comparison.measured_asked.serial(),
            solved: self.comparison.sample.as_ref().map(|one| one.generation),
            form: self.display.form,
            motion: self.display.motion,
            band: self.band.span,
            visible: self.curves.visible.clone(),
        };
        if self.comparison.fit_key.as_ref() != Some(&key) {
            self.comparison.fits = self.fits();
            self.comparison.fit_key = Some(key);
        }
    }

    /// The fits of the visible responses to the visible measured curves, in the marked band if there is one; empty
    /// until the model is solved at their frequencies.
    fn fits(&self) -> Vec<Fitted> {
        let current = |sample: &&Sample| sample.generation == self.curves.generation;
        let Some(sample) = self.comparison.sample.as_ref().filter(current) else {
            return Vec::new();
        };
        let shown = self.comparison.measured.iter().filter(|one| one.shown);
        shown
            .flat_map(|one| {
                let traces = sample.traces.iter().filter(|trace| {
                    let dimension = self.display.dimension_of(trace);
                    self.curves.shows(&trace.response) && one.fits(dimension.as_ref())
                });
                traces.filter_map(move |trace| {
                    Some(Fitted {
                        measured: one.id,
                        response: trace.response.clone(),
                        fit: self.fit_of(one, sample, trace)?,
                    })
                })
            })
            .collect()
    }

    fn fit_of(&self, measured: &Measured, sample: &Sample, trace: &Trace) -> Option<Fit> {
        let curve = &measured.curve;
        let dimension = self.display.dimension_of(trace);
        let stride = stride(curve.frequencies.len());
        let places = (0..curve.frequencies.len()).step_by(stride);
        let places: Vec<(usize, usize)> = places
            .filter_map(|i| {
                let f = curve.frequencies[i];
                let at = sample.frequencies.partition_point(|one| *one < f);
                (sample.frequencies.get(at) == Some(&f)).then_some((i, at))
            })
            .collect();
        let seen = Curve {
            frequencies: places.iter().map(|(i, _)| curve.frequencies[*i]).collect(),
            values: places
                .iter()
                .map(|(i, _)| measured.value(&self.display, dimension.as_ref(), *i))
                .collect(),
            ..curve.clone()
        };
        let model: Vec<Complex64> = places
            .iter()
            .map(|(_, at)| {
                let (value, f) = (trace.values[*at], sample.frequencies[*at]);
                self.display.value(trace, value, f)
            })
            .collect();
        fit(&seen, &model, self.band.span)
    }
}

/// Notes on omitted data and assumptions, each once, after semicolons.
fn notes(curves: &[Curve]) -> String {
    let mut seen: Vec<&String> = Vec::new();
    for note in curves.iter().flat_map(|curve| &curve.notes) {
        if !seen.contains(&note) {
            seen.push(note);
        }
    }
    let notes = seen.into_iter().flat_map(|note| ["; ", note.as_str()]);
    notes.collect()
}

/// The stride over the frequencies of a curve.
fn stride(points: usize) -> usize {
    points.div_ceil(MOST_FREQUENCIES).max(1)
}

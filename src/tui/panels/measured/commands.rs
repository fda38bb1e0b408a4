//! Takes measured curves, requests the model at their frequencies, and fits them.

use std::path::PathBuf;
use std::sync::Arc;

use num_complex::Complex64;

use super::choose::chosen;
use super::{FitKey, Fitted, MOST_CURVES, Measured, OpenedMeasured, Sample};
use crate::escape::shown_path;
use crate::measured::{self, Curve, Fit, Inspection, fit};
use crate::model::{Checked, Model, counted};
use crate::solve::Reference;
use crate::tui::app::{App, Effect, Question, Trace};
use crate::tui::keys::CompareCommand;
use crate::unit::{Dimension, ValueUnit};
use crate::worker::{Request, SampleRequest, Sampling};

/// The most frequencies at which a model is compared with measured curves; beyond, every second, third...
const MOST_FREQUENCIES: usize = 20_000;

impl App {
    /// Handles an opened file; returns the effects.
    pub(crate) fn measured_opened(&mut self, opened: OpenedMeasured) -> Vec<Effect> {
        match opened {
            OpenedMeasured::Curves(curves) => self.take_measured(curves),
            OpenedMeasured::Asks(path, inspection)
                if is_of_responses(self.model(), &inspection) =>
            {
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

    /// Adds the curves of a file, or asks which, if there are more than the limit.
    pub(crate) fn take_measured(&mut self, curves: Vec<Curve>) {
        self.overlay = None;
        let room = MOST_CURVES.saturating_sub(self.comparison.measured.len());
        if room == 0 {
            let list = self.keys.key_of(CompareCommand::List);
            return self.refuse(format!(
                "{MOST_CURVES} measured curves are the most: {list} lists them, to remove some"
            ));
        }
        if curves.len() > room {
            return self.ask_curves(curves);
        }
        let taken = curves.len();
        let notes = notes(&curves);
        for curve in curves {
            let curve = named_alike(self.model(), curve);
            // A curve needs another name than the response it is compared with.
            let responses = &self.model().responses;
            let name = if responses.iter().any(|one| one.name == curve.name) {
                self.comparison
                    .free_name(&format!("{} measured", curve.name))
            } else {
                self.comparison.free_name(&curve.name)
            };
            let id = self.requests.next_serial();
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

    /// Asks which curves of a file to show, if it holds more than the limit.
    pub(crate) fn ask_curves(&mut self, curves: Vec<Curve>) {
        let room = MOST_CURVES - self.comparison.measured.len();
        let first = if room == 1 {
            "1".to_owned()
        } else {
            format!("1-{room}")
        };
        self.ask_question(Question::Curves(Arc::new(curves)), first);
    }

    /// Adds the chosen curves.
    ///
    /// # Errors
    /// Why they are not added, in one line.
    pub(crate) fn take_chosen(&mut self, curves: &[Curve], text: &str) -> Result<(), String> {
        let names: Vec<&str> = curves.iter().map(|curve| curve.name.as_str()).collect();
        let chosen = chosen(text, &names)?;
        let room = MOST_CURVES.saturating_sub(self.comparison.measured.len());
        if chosen.len() > room {
            let list = self.keys.key_of(CompareCommand::List);
            let some: Vec<&str> = chosen.iter().take(3).map(|i| names[*i]).collect();
            return Err(format!(
                "{} curves ({}, ..) are chosen, and there is room for {room}: {MOST_CURVES} are the most, {list} lists \
                 the present ones",
                chosen.len(),
                some.join(", ")
            ));
        }
        let curves = chosen.into_iter().map(|i| curves[i].clone()).collect();
        self.take_measured(curves);
        Ok(())
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
            self.display.shown_units(&self.curves).as_slice(),
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
            self.comparison.forget_sample();
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
        let serial = self.requests.next_serial();
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

    /// The visible measured curves that match a visible response, with the dimension of that response.
    pub fn measured_shown(&self) -> impl Iterator<Item = (&Measured, Option<Dimension>)> {
        self.comparison.measured_shown(&self.curves, &self.display)
    }

    /// Computes the fits again, if their inputs changed.
    pub(crate) fn refresh_fits(&mut self) {
        let key = FitKey {
            serial: self.comparison.measured_asked.serial(),
            solved: self.comparison.sample.as_ref().map(|one| one.generation),
            form: self.display.form,
            motion: self.display.motion,
            band: self.curves.band,
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
        fit(&seen, &model, self.curves.band)
    }
}

/// Whether a table lacks only units, and its curves have the names of responses, as `beamtune frf` writes them:
/// they are in the units of the responses then.
fn is_of_responses(model: &Model, inspection: &Inspection) -> bool {
    let named = |name: &String| model.responses.iter().any(|one| one.name == *name);
    inspection.format == measured::Format::Csv
        && inspection.missing == [measured::Question::Unit]
        && inspection.curves.iter().all(named)
}

/// A curve of unknown quantity with the name of a response: the quantity of that response under the given loads.
fn named_alike(model: &Checked, mut curve: Curve) -> Curve {
    let mut responses = model.responses.iter();
    let alike = responses.find(|one| one.enabled && one.name == curve.name);
    if let (None, true, Some(alike)) = (curve.kind, curve.unknown.is_empty(), alike) {
        let reference = Reference::of(model);
        curve.kind = Some(alike.kind(model, reference.map(|one| one.load)));
        if let Some(reference) = reference.filter(|_| alike.is_linear()) {
            for value in &mut curve.values {
                *value /= reference.amplitude;
            }
        }
    }
    curve
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

//! Requests to the worker, and its answers.

use std::sync::Arc;

use super::{App, BeamView, Effect, FemOverlay};
use crate::model::edit::{self, Value};
use crate::worker::{Answer, CurvesAnswer, ExpectRequest, Request, Sampling, Subject};

impl App {
    /// Stores an answer of the worker.
    pub(crate) fn take(&mut self, answer: Answer) {
        match answer {
            Answer::Curves(answer) => self.take_curves(answer),
            Answer::Shape(answer) => {
                if let Err(reason) = self.modes.take_shape(answer) {
                    self.refuse(format!("no shape: {reason}"));
                }
            }
            Answer::Witness(answer) => {
                let (generation, model) = (self.curves.generation, self.document.model());
                self.fem_overlay.take(answer, generation, model);
            }
            Answer::Reference(answer) => self.comparison.take(answer),
            Answer::Levels(answer) => self.band.take(answer),
            Answer::Sensitivity(answer) => self.take_sensitivities(answer),
            Answer::Tune(answer) => self.take_tuning(answer),
            Answer::Spread(answer) => self.take_tolerances(answer),
            Answer::Operating(answer) => self.beam_view.take(answer),
            Answer::Sample(answer) => {
                let taken = match answer.sampling {
                    Sampling::Detail => self.detail.take(answer),
                    Sampling::Reading => self.reading.take(answer),
                    Sampling::Measured => self.comparison.take_sample(answer),
                };
                if let Err(reason) = taken {
                    self.refuse(reason);
                }
            }
        }
    }

    fn take_curves(&mut self, mut answer: CurvesAnswer) {
        let before = self.selected();
        let generation = answer.generation;
        let found = answer.result.as_mut().ok();
        let modes = found.and_then(|curves| curves.modes.take());
        if self.curves.take(answer)
            && let Some(modes) = modes
        {
            self.modes.take(generation, modes);
            self.follow_solution(&before);
        }
    }

    /// Requests everything that is visible and was not requested yet.
    pub(crate) fn request(&mut self) -> Vec<Effect> {
        let mut requests: Vec<Request> = self.want_curves().into_iter().collect();
        requests.extend(self.want_expected());
        requests.extend(self.want_shape());
        requests.extend(self.want_fem());
        requests.extend(self.comparison.want());
        requests.extend(self.want_reading());
        requests.extend(self.want_detail());
        requests.extend(self.want_measured());
        requests.extend(self.want_levels());
        requests.extend(self.want_operating());
        requests.extend(self.want_sensitivities());
        requests.extend(self.want_tuning());
        requests.into_iter().map(Effect::Solve).collect()
    }

    /// The subject of the solution: the model with its study.
    pub(crate) fn subject(&self) -> Subject {
        Subject {
            generation: self.curves.generation,
            model: Arc::clone(self.document.model()),
            study: self.curves.study,
        }
    }

    /// Curves, if the last request was not for this model.
    fn want_curves(&mut self) -> Option<Request> {
        let (model, study) = (Arc::clone(self.document.model()), self.curves.study);
        if let Some((last, last_study)) = &self.requests.curves
            && Arc::ptr_eq(last, &model)
            && *last_study == study
        {
            return None;
        }
        self.curves.generation += 1;
        self.fem_overlay.outdate();
        self.requests.curves = Some((model, study));
        Some(Request::Curves(self.subject()))
    }

    /// Preparation for nudges of the selected parameter, if the model is large enough for a benefit.
    fn want_expected(&mut self) -> Option<Request> {
        const MANY: usize = 8;
        /// How far the value may change before it is prepared again, and how far the preparation reaches, as shares:
        /// the place of a subsystem passes others on its way.
        const NEAR: f64 = 0.03;
        const FAR: f64 = 0.05;
        let model = Arc::clone(self.document.model());
        if model.subsystems.len() < MANY || self.curves.is_stale() {
            return None;
        }
        let id = self.selection.node().parameter()?;
        let value = edit::number(&model, id).ok()?;
        if let Some((known, at)) = self.requests.expected
            && known == id
            && (value - at).abs() <= NEAR * at.abs()
        {
            return None;
        }
        self.requests.expected = Some((id, value));
        // The model limits how far the value can change.
        let turned = |by: f64| {
            let value = Value::Number(value * (1.0 + by));
            edit::changed(&model, id, value).map_or_else(|_| Arc::clone(&model), Arc::new)
        };
        Some(Request::Expect(ExpectRequest {
            model: turned(-FAR),
            edited: turned(FAR),
        }))
    }

    /// The shape of the selected mode, if it is visible.
    fn want_shape(&mut self) -> Option<Request> {
        self.beam_view
            .shown
            .filter(|look| *look == BeamView::Mode)?;
        let generation = self.curves.generation;
        let row = self.tables.modes.row;
        let model = self.document.model();
        let request = self.modes.want_shape(generation, model, row)?;
        Some(Request::Shape(request))
    }

    /// The finite-element curves, if they are on and the exact ones are solved.
    fn want_fem(&mut self) -> Option<Request> {
        let generation = self.curves.generation;
        let waits = matches!(self.fem_overlay, FemOverlay::Waiting(_));
        if !waits || self.requests.fem == Some(generation) || !self.curves.is_resolved() {
            return None;
        }
        self.requests.fem = Some(generation);
        Some(Request::Witness(self.subject()))
    }
}

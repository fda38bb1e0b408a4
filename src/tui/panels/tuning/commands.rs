//! Starts, pauses, ends and accepts a search.

use std::sync::Arc;
use std::time::Duration;

use super::{Progress, Run};
use crate::model::edit::{self, Value};
use crate::model::{Checked, Group, Model, path};
use crate::tui::app::{App, Table};
use crate::tui::keys::{ModelCommand, TuneCommand};
use crate::tui::tree::{self, Node};
use crate::worker::{Request, TuneAnswer, TuneRequest, TuneStage};

impl App {
    /// Starts, pauses or continues a search.
    pub(crate) fn go_on_tuning(&mut self) {
        let [go, accept, discard] = [
            TuneCommand::Tune,
            TuneCommand::TuneAccept,
            TuneCommand::TuneDiscard,
        ]
        .map(|command| self.keys.key_of(command));
        let Some(run) = &mut self.tuning.run else {
            return self.start_tuning();
        };
        self.tables.open = Some(Table::Tuning);
        let text = match run.progress {
            Progress::Searching => {
                run.pause.set(true);
                run.progress = Progress::Paused;
                format!(
                    "paused: {go} continues, {accept} applies the best so far, {discard} discards it"
                )
            }
            Progress::Paused => {
                run.pause.set(false);
                run.progress = Progress::Searching;
                "the search continues".to_owned()
            }
            Progress::Found(_) => {
                return self.refuse(format!(
                    "{accept} applies the result, {discard} discards it; then a new search can start"
                ));
            }
            Progress::Failed(_) => {
                self.tuning.run = None;
                return self.start_tuning();
            }
        };
        self.done(text);
    }

    fn start_tuning(&mut self) {
        let [variable, objective] = [TuneCommand::TuneVariable, TuneCommand::TuneObjective]
            .map(|one| self.keys.key_of(one));
        if self.model().tune.is_none() {
            return self.refuse(format!(
                "no variables yet: {variable} adds the selected parameter, {objective} an objective"
            ));
        }
        let model = Arc::clone(self.document.model());
        if let Some(response) = tuned_response(&model)
            && !self.curves.shows(response)
        {
            self.curves.visible = vec![response.to_owned()];
        }
        let name = "best so far";
        let Some(reference) = self.add_best(name, &model) else {
            return;
        };
        self.tuning.run = Some(Run {
            serial: 0,
            from: model,
            progress: Progress::Searching,
            status: None,
            elapsed: Duration::ZERO,
            pause: Arc::default(),
            reference,
        });
        self.tuning.starts = true;
        self.tables.open = Some(Table::Tuning);
        let [go, accept, discard] = [
            TuneCommand::Tune,
            TuneCommand::TuneAccept,
            TuneCommand::TuneDiscard,
        ]
        .map(|command| self.keys.key_of(command));
        self.done(format!(
            "searching: {go} pauses, {accept} applies the best so far, {discard} discards it"
        ));
    }

    /// The id of a reference that will show the best so far.
    fn add_best(&mut self, name: &str, model: &Arc<Checked>) -> Option<u64> {
        let picture = self.curves.picture().cloned();
        self.add_reference(name, Arc::clone(model), None, picture)?;
        self.comparison.references.last().map(|one| one.id)
    }

    /// Requests a search, or its cancellation.
    pub(crate) fn want_tuning(&mut self) -> Vec<Request> {
        let mut requests = Vec::new();
        if std::mem::take(&mut self.tuning.ends) {
            requests.push(Request::EndTuning);
        }
        if std::mem::take(&mut self.tuning.starts) {
            let (serial, folder) = (
                self.requests.next_serial(),
                self.document.source().folder().to_owned(),
            );
            requests.extend(self.tuning.run.as_mut().map(|run| {
                run.serial = serial;
                Request::Tune(TuneRequest {
                    serial,
                    model: Arc::clone(&run.from),
                    folder,
                    budget: self.tuning.budget,
                    pause: Arc::clone(&run.pause),
                })
            }));
        }
        requests.extend(self.want_tolerances());
        requests
    }

    /// Stores the progress of a search.
    pub(crate) fn take_tuning(&mut self, answer: TuneAnswer) {
        let Some(run) = &mut self.tuning.run else {
            return;
        };
        if run.serial != answer.serial {
            return;
        }
        run.elapsed = answer.elapsed;
        let best = match answer.stage {
            TuneStage::Searching(status) => {
                let better = run.best() != Some(&status.model);
                let best = better.then(|| Arc::new(status.model.clone()));
                run.status = Some(status);
                best
            }
            TuneStage::Over(Ok(tuned)) => {
                let best = Arc::new(tuned.model.clone());
                let stop = tuned.stop;
                run.progress = Progress::Found(tuned);
                let [accept, discard] = [TuneCommand::TuneAccept, TuneCommand::TuneDiscard]
                    .map(|command| self.keys.key_of(command));
                self.done(format!(
                    "{stop}: {accept} applies the result, {discard} discards it"
                ));
                Some(best)
            }
            TuneStage::Over(Err(reason)) => {
                run.progress = Progress::Failed(reason.clone());
                let reference = run.reference;
                self.drop_reference(reference);
                return self.refuse(format!("not tuned: {reason}"));
            }
        };
        if let Some(best) = best {
            self.show_best(best);
        }
    }

    /// Shows a better model in the reference, once its curves are solved.
    fn show_best(&mut self, model: Arc<Checked>) {
        let serial = self.requests.next_serial();
        let Some(run) = &mut self.tuning.run else {
            return;
        };
        let mut references = self.comparison.references.iter_mut();
        if let Some(one) = references.find(|one| one.id == run.reference) {
            one.renew(serial, model);
            run.reference = serial;
        }
    }

    /// Applies the best so far to the model, as one step.
    pub(crate) fn accept_tuning(&mut self) {
        let Some(run) = &self.tuning.run else {
            let go = self.keys.key_of(TuneCommand::Tune);
            return self.refuse(format!("there is no search: {go} starts one"));
        };
        let Some(best) = run.best() else {
            return self.refuse("the search has no result yet");
        };
        let changed = match taken_over(self.model(), &run.from, best) {
            Ok(changed) => changed,
            Err(reason) => return self.refuse(format!("not applied: {reason}")),
        };
        let words = format!(
            "tune {}",
            tree::value(&run.from, Node::Group(Group::Objective(0)))
        );
        let before = Arc::clone(self.model());
        self.end_run();
        self.document.replace(words, changed);
        self.follow(&before);
        let undo = self.keys.key_of(ModelCommand::Undo);
        self.done(format!(
            "the tuned parameters are in the model; {undo} undoes it"
        ));
    }

    /// Discards a search and its result.
    pub(crate) fn discard_tuning(&mut self) {
        if self.tuning.run.is_none() {
            return self.refuse("there is no search");
        }
        self.end_run();
        self.done("search discarded; the model is unchanged");
    }

    /// Ends a search and removes its curve from the chart.
    pub(crate) fn end_run(&mut self) {
        if let Some(run) = self.tuning.run.take() {
            run.pause.set(false);
            self.tuning.ends = run.goes_on();
            self.drop_reference(run.reference);
            self.tables.close(Table::Tuning);
        }
    }
}

/// The response of the first objective that has one.
fn tuned_response(model: &Model) -> Option<&str> {
    let mut objectives = model.tune.iter().flat_map(|tune| &tune.objectives);
    objectives.find_map(|objective| objective.response.as_deref())
}

/// The model with the variables that a search found; everything else is unchanged.
///
/// # Errors
/// Why the model is invalid, in one line.
fn taken_over(model: &Model, from: &Model, best: &Model) -> Result<Checked, String> {
    let mut changed = model.clone();
    let variables = from.tune.iter().flat_map(|tune| &tune.variables);
    for pattern in variables.flat_map(|variable| &variable.paths) {
        let found = path::numbers_of(best, pattern).map_err(|fault| fault.message)?;
        for (id, value) in found {
            // Names map one model to the other, which may have changed since the search began.
            edit::set_unchecked(&mut changed, &path::text(best, id), Value::Number(value))
                .map_err(|fault| format!("{} {}", fault.path, fault.message))?;
        }
    }
    Checked::new(changed).map_err(|faults| format!("{} {}", faults[0].path, faults[0].message))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: names map the searched model to one that was edited meanwhile.
    #[test]
    fn what_was_found_goes_to_the_subsystem_with_its_name() {
        let preset = crate::presets::find("fig05a").unwrap().text;
        let tune = r#"
            [tune]
            variables = [{ path = "subsystems.S2.mass", min = 1.0, max = 1e3 }]
            objective = { minimise = "energy", from = 1.0, to = 100.0 }
        "#;
        let from = crate::model::read(&format!("{preset}{tune}"))
            .unwrap()
            .into_inner();
        let mut best = from.clone();
        best.subsystems[1].mass = 77.0;
        let mut edited = from.clone();
        edited.subsystems.swap(0, 1);
        let taken = taken_over(&edited, &from, &best).unwrap();
        assert_eq!(taken.subsystems[0].name, "S2");
        assert_eq!(taken.subsystems[0].mass, 77.0);
        assert_eq!(taken.subsystems[1].mass, from.subsystems[0].mass);
    }
}

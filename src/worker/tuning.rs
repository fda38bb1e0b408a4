//! Tuning, which can be paused, and the band of the curves under tolerances.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::job_thread::guarded;
use crate::model::{Checked, Fault};
use crate::solve::Cancelled;
use crate::tune::{self, Options, Problem, Spread, Status, Tuned};

/// Time between two progress reports.
const REPORT: Duration = Duration::from_millis(100);

/// The number of models of a tolerance band.
const SAMPLES: usize = 200;

/// The seed of the random numbers; constant, so that a search is reproducible.
const SEED: u64 = 1;

/// A request to tune a model.
#[derive(Debug, Clone)]
pub struct TuneRequest {
    /// Returned with the answers.
    pub serial: u64,
    /// A model with `[tune]`.
    pub model: Arc<Checked>,
    /// The folder that files of measured curves are relative to.
    pub folder: PathBuf,
    /// The most evaluations; none: set by the number of variables.
    pub budget: Option<usize>,
    /// Pauses the search.
    pub pause: Arc<Pause>,
}

/// The progress of a search, or its result.
#[derive(Debug, Clone)]
pub struct TuneAnswer {
    /// From the request.
    pub serial: u64,
    /// Working time, without pauses.
    pub elapsed: Duration,
    /// The progress, or the result.
    pub stage: TuneStage,
}

/// The progress of a search.
#[derive(Debug, Clone)]
pub enum TuneStage {
    /// It is running.
    Searching(Box<Status>),
    /// It has ended, with a result or an error in one line.
    Over(Result<Box<Tuned>, String>),
}

/// Pauses a search from another thread.
#[derive(Debug, Default)]
pub struct Pause {
    paused: Mutex<bool>,
    changed: Condvar,
}

impl Pause {
    /// Pauses the search, or resumes it.
    pub fn set(&self, paused: bool) {
        *self.paused.lock().unwrap_or_else(PoisonError::into_inner) = paused;
        self.changed.notify_all();
    }

    /// Waits while the search is paused.
    fn wait(&self) {
        let mut paused = self.paused.lock().unwrap_or_else(PoisonError::into_inner);
        while *paused {
            paused = self
                .changed
                .wait(paused)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }
}

/// Runs a search; sends its progress periodically, and its result at the end, also if it was cancelled.
pub(super) fn search(request: &TuneRequest, cancel: &AtomicBool, send: &impl Fn(TuneAnswer)) {
    let mut watch = Watch::start();
    let answer = |watch: &Watch, stage| TuneAnswer {
        serial: request.serial,
        elapsed: watch.worked(),
        stage,
    };
    let found = guarded(|| {
        let problem = Problem::new(&request.model, &request.folder).map_err(summary)?;
        let options = Options {
            seed: SEED,
            budget: request.budget,
        };
        let mut reported: Option<Instant> = None;
        let found = tune::run(&problem, &options, cancel, &mut |status| {
            let due = reported.is_none_or(|last| last.elapsed() >= REPORT);
            if due && !cancel.load(Ordering::Relaxed) {
                send(answer(
                    &watch,
                    TuneStage::Searching(Box::new(status.clone())),
                ));
                reported = Some(Instant::now());
            }
            let before = Instant::now();
            request.pause.wait();
            watch.paused += before.elapsed();
        });
        Ok(Box::new(found?))
    });
    if let Ok(result) = found {
        send(answer(&watch, TuneStage::Over(result)));
    }
}

/// The first fault, and the number of the others.
fn summary(faults: Vec<Fault>) -> String {
    let more = faults.len().saturating_sub(1);
    let first = faults.into_iter().next();
    let first = first.map_or_else(String::new, |one| format!("{} {}", one.path, one.message));
    match more {
        0 => first,
        more => format!("{first}; and {more} more"),
    }
}

/// Measures the working time.
struct Watch {
    start: Instant,
    paused: Duration,
}

impl Watch {
    fn start() -> Self {
        Self {
            start: Instant::now(),
            paused: Duration::ZERO,
        }
    }

    fn worked(&self) -> Duration {
        self.start.elapsed().saturating_sub(self.paused)
    }
}

/// The model and the frequencies of a tolerance band.
#[derive(Debug, Clone)]
pub struct SpreadRequest {
    /// Returned with the answer.
    pub serial: u64,
    /// A model with `[tune]`.
    pub model: Arc<Checked>,
    /// Hz, ascending.
    pub frequencies: Vec<f64>,
}

/// The band of the curves under tolerances, or an error.
#[derive(Debug, Clone)]
pub struct SpreadAnswer {
    /// From the request.
    pub serial: u64,
    /// Those of the request, Hz.
    pub frequencies: Vec<f64>,
    /// One for each enabled response, or an error in one line.
    pub result: Result<Vec<Spread>, String>,
}

/// The quantiles of the curves.
pub(super) fn spread(
    request: &SpreadRequest,
    cancel: &AtomicBool,
) -> Result<SpreadAnswer, Cancelled> {
    let SpreadRequest {
        serial,
        model,
        frequencies,
    } = request;
    let result = guarded(|| {
        let Some(tune) = &model.tune else {
            return Err("the model has no [tune] with tolerances".to_owned().into());
        };
        let found = tune::spread(model, tune, (SAMPLES, SEED), frequencies, cancel);
        Ok(found.map_err(|fault| summary(vec![fault]))??)
    })?;
    Ok(SpreadAnswer {
        serial: *serial,
        frequencies: frequencies.clone(),
        result,
    })
}

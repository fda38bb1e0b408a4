//! The search for better parameters, which can be paused; and what tolerances make of the curves.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::lane::guarded;
use crate::model::{Checked, Fault};
use crate::solve::Cancelled;
use crate::tune::{self, Options, Problem, Spread, Status, Tuned};

/// Between two reports of a search that goes on.
const REPORT: Duration = Duration::from_millis(100);

/// Models of a tolerance band.
const SAMPLES: usize = 200;

/// The seed of what is random; always the same, so that a search can be done again.
const SEED: u64 = 1;

/// What is sought.
#[derive(Debug, Clone)]
pub struct TuneRequest {
    /// Comes back with the answers.
    pub serial: u64,
    /// A checked model with `[tune]`.
    pub model: Arc<Checked>,
    /// The folder that files of measured curves are relative to.
    pub folder: PathBuf,
    /// At most so many evaluations; none: by the number of variables.
    pub budget: Option<usize>,
    /// Holds the search up.
    pub pause: Arc<Pause>,
}

/// How far a search is, or what came of it.
#[derive(Debug, Clone)]
pub struct TuneAnswer {
    /// Of the request.
    pub serial: u64,
    /// The time that was worked, pauses left out.
    pub elapsed: Duration,
    /// How far it is, or what came of it.
    pub stage: TuneStage,
}

/// How far a search is.
#[derive(Debug, Clone)]
pub enum TuneStage {
    /// It goes on.
    Searching(Box<Status>),
    /// It is over: what was found, or one line that says what went wrong.
    Over(Result<Box<Tuned>, String>),
}

/// Holds a search up, from another thread.
#[derive(Debug, Default)]
pub struct Pause {
    held: Mutex<bool>,
    changed: Condvar,
}

impl Pause {
    /// Holds the search up, or lets it go on.
    pub fn set(&self, held: bool) {
        *self.held.lock().unwrap_or_else(PoisonError::into_inner) = held;
        self.changed.notify_all();
    }

    /// Waits as long as the search is held up.
    fn wait(&self) {
        let mut held = self.held.lock().unwrap_or_else(PoisonError::into_inner);
        while *held {
            held = self
                .changed
                .wait(held)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }
}

/// Searches; tells from time to time how far it is, and in the end what was found, also where it was cancelled.
pub(super) fn search(request: &TuneRequest, cancel: &AtomicBool, tell: &impl Fn(TuneAnswer)) {
    let mut watch = Watch::start();
    let answer = |watch: &Watch, stage| TuneAnswer {
        serial: request.serial,
        elapsed: watch.worked(),
        stage,
    };
    let found = guarded(|| {
        let problem = Problem::new(&request.model, &request.folder).map_err(in_words)?;
        let options = Options {
            seed: SEED,
            budget: request.budget,
        };
        let mut told: Option<Instant> = None;
        let found = tune::run(&problem, &options, cancel, &mut |status| {
            let due = told.is_none_or(|told| told.elapsed() >= REPORT);
            if due && !cancel.load(Ordering::Relaxed) {
                tell(answer(
                    &watch,
                    TuneStage::Searching(Box::new(status.clone())),
                ));
                told = Some(Instant::now());
            }
            let before = Instant::now();
            request.pause.wait();
            watch.rested += before.elapsed();
        });
        Ok(Box::new(found?))
    });
    if let Ok(result) = found {
        tell(answer(&watch, TuneStage::Over(result)));
    }
}

/// The first of some faults, and how many more there are.
fn in_words(faults: Vec<Fault>) -> String {
    let more = faults.len().saturating_sub(1);
    let first = faults.into_iter().next();
    let first = first.map_or_else(String::new, |one| format!("{} {}", one.path, one.message));
    match more {
        0 => first,
        more => format!("{first}; and {more} more"),
    }
}

/// Counts the time of work.
struct Watch {
    start: Instant,
    rested: Duration,
}

impl Watch {
    fn start() -> Self {
        Self {
            start: Instant::now(),
            rested: Duration::ZERO,
        }
    }

    fn worked(&self) -> Duration {
        self.start.elapsed().saturating_sub(self.rested)
    }
}

/// Which model's tolerances are to be seen at which frequencies.
#[derive(Debug, Clone)]
pub struct SpreadRequest {
    /// Comes back with the answer.
    pub serial: u64,
    /// A checked model with `[tune]`.
    pub model: Arc<Checked>,
    /// Hz, rising.
    pub frequencies: Vec<f64>,
}

/// What tolerances make of the curves, or why that is not known.
#[derive(Debug, Clone)]
pub struct SpreadAnswer {
    /// Of the request.
    pub serial: u64,
    /// Hz, as they were asked for.
    pub frequencies: Vec<f64>,
    /// One for each enabled response, or one line that says what went wrong.
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
        Ok(found.map_err(|fault| in_words(vec![fault]))??)
    })?;
    Ok(SpreadAnswer {
        serial: *serial,
        frequencies: frequencies.clone(),
        result,
    })
}

//! The one place that knows a background thread: it solves the newest request and drops what is overtaken.
//!
//! A request replaces the one in work, which is cancelled between chunks of frequencies. Where the whole sweep would
//! take longer than [`PROMPT`], a coarse one over every few frequencies comes first. A panic inside a solve becomes
//! the answer's error; the thread lives on.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use crate::model::{Model, path};
use crate::solve::{Frf, frequencies, sweep};

/// A sweep that would take longer than this is preceded by a coarse one.
pub const PROMPT: Duration = Duration::from_millis(30);

/// Frequencies of the timing sample, spread over the whole range.
const SAMPLE: usize = 8;

/// A coarse curve that would take longer than this is left out: it cannot be cancelled.
const LONGEST_COARSE: Duration = Duration::from_secs(1);

/// The fewest frequencies of a coarse curve.
const COARSEST: usize = 50;

/// Curves that are asked for.
#[derive(Debug, Clone)]
pub struct Request {
    /// The model's generation; comes back with the answer.
    pub generation: u64,
    /// A checked model.
    pub model: Arc<Model>,
    /// Index of the study whose members are wanted; none: the model alone.
    pub study: Option<usize>,
}

/// Curves, or why there are none.
#[derive(Debug, Clone)]
pub struct Answer {
    /// Of the request.
    pub generation: u64,
    /// How complete it is.
    pub stage: Stage,
    /// The curves, or one line that says what went wrong.
    pub result: Result<Curves, String>,
    /// From the start of the work to this answer.
    pub elapsed: Duration,
}

/// How complete an answer is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Few frequencies; the rest follows.
    Coarse,
    /// All frequencies.
    Full,
}

/// The curves of a model or of a study's members.
#[derive(Debug, Clone, PartialEq)]
pub struct Curves {
    /// One without a study; otherwise one for each member.
    pub members: Vec<Member>,
}

/// The curves of one model.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// What tells it from the other members of its study.
    pub label: Option<String>,
    /// Its responses.
    pub frf: Frf,
}

/// A background thread that solves. Dropping it cancels the work and joins the thread.
#[derive(Debug)]
pub struct Worker {
    jobs: Option<Sender<Job>>,
    /// Cancels the newest job.
    cancel: Mutex<Arc<AtomicBool>>,
    thread: Option<JoinHandle<()>>,
}

/// A request, and what ends it early.
#[derive(Debug)]
struct Job {
    request: Request,
    cancel: Arc<AtomicBool>,
}

impl Worker {
    /// Starts the thread; it hands its answers to `notify`.
    pub fn start(notify: impl Fn(Answer) + Send + 'static) -> Self {
        let (jobs, inbox) = channel();
        let thread = std::thread::spawn(move || work(&inbox, &notify));
        Self {
            jobs: Some(jobs),
            cancel: Mutex::default(),
            thread: Some(thread),
        }
    }

    /// Asks for curves; what was asked before is cancelled and may stay without its full answer.
    pub fn request(&self, request: Request) {
        let cancel = Arc::new(AtomicBool::new(false));
        let overtaken = std::mem::replace(
            &mut *self.cancel.lock().unwrap_or_else(PoisonError::into_inner),
            Arc::clone(&cancel),
        );
        overtaken.store(true, Ordering::Relaxed);
        if let Some(jobs) = &self.jobs {
            // The thread ends only after this sender, so the job arrives.
            let _ = jobs.send(Job { request, cancel });
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.cancel
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .store(true, Ordering::Relaxed);
        self.jobs = None;
        if let Some(thread) = self.thread.take() {
            // A panic of the thread has been reported by its hook.
            let _ = thread.join();
        }
    }
}

/// Works on the newest job until the last sender is gone.
fn work(inbox: &Receiver<Job>, notify: &impl Fn(Answer)) {
    while let Ok(mut job) = inbox.recv() {
        while let Ok(newer) = inbox.try_recv() {
            job = newer;
        }
        let generation = job.request.generation;
        let start = Instant::now();
        let answer = |stage, result| Answer {
            generation,
            stage,
            result,
            elapsed: start.elapsed(),
        };
        let full = catch_unwind(AssertUnwindSafe(|| {
            let Some(members) = members(&job)? else {
                return Ok(None);
            };
            if let Some(coarse) = coarse(&members) {
                notify(answer(Stage::Coarse, Ok(coarse)));
            }
            Ok(solve_all(&members, 1, &job.cancel))
        }));
        match full {
            Ok(Ok(Some(curves))) => notify(answer(Stage::Full, Ok(curves))),
            Ok(Ok(None)) => {}
            Ok(Err(message)) => notify(answer(Stage::Full, Err(message))),
            Err(_) => notify(answer(
                Stage::Full,
                Err("the solver stopped at a fault of its own".into()),
            )),
        }
    }
}

/// A model to solve, and what tells it from the others of its study.
type Labelled = (Option<String>, Arc<Model>);

/// The models to solve, with their labels; none where cancelled.
fn members(Job { request, cancel }: &Job) -> Result<Option<Vec<Labelled>>, String> {
    let Some(study) = request
        .study
        .and_then(|index| request.model.studies.get(index))
    else {
        return Ok(Some(vec![(None, Arc::clone(&request.model))]));
    };
    let mut members = Vec::new();
    for (index, label) in path::family_labels(&study.family).into_iter().enumerate() {
        if cancel.load(Ordering::Relaxed) {
            return Ok(None);
        }
        let model = path::apply(&request.model, &study.family, index).map_err(|faults| {
            let first = faults.first().map(ToString::to_string).unwrap_or_default();
            format!("{}, {label}: {first}", study.name)
        })?;
        members.push((Some(label), Arc::new(model)));
    }
    Ok(Some(members))
}

/// Few frequencies, where all would take longer than [`PROMPT`]. Never cancelled: it is what keeps a held key alive.
fn coarse(members: &[Labelled]) -> Option<Curves> {
    let (_, model) = members.first()?;
    let all = frequencies(&model.sweep);
    let every = (all.len() / SAMPLE).max(1);
    let sample: Vec<f64> = all.iter().step_by(every).copied().collect();
    let never = AtomicBool::new(false);
    let start = Instant::now();
    sweep(model, &sample, &never)?;
    let each = start.elapsed().as_secs_f64() / sample.len() as f64 * members.len() as f64;
    let affordable = 0.5 * PROMPT.as_secs_f64() / each;
    let too_long = each * COARSEST as f64 > LONGEST_COARSE.as_secs_f64();
    if 2.0 * affordable >= all.len() as f64 || too_long {
        return None;
    }
    let points = (affordable as usize).max(COARSEST);
    let stride = all.len().div_ceil(points);
    (stride > 1)
        .then(|| solve_all(members, stride, &never))
        .flatten()
}

/// Every member at every `stride`-th frequency of its sweep and the last; none where cancelled.
fn solve_all(members: &[Labelled], stride: usize, cancel: &AtomicBool) -> Option<Curves> {
    let solved = members.iter().map(|(label, model)| {
        let all = frequencies(&model.sweep);
        let last = all.len() - 1;
        let some: Vec<f64> = all
            .iter()
            .enumerate()
            .filter(|(index, _)| index % stride == 0 || *index == last)
            .map(|(_, &f)| f)
            .collect();
        Some(Member {
            label: label.clone(),
            frf: sweep(model, &some, cancel)?,
        })
    });
    Some(Curves {
        members: solved.collect::<Option<_>>()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presets;

    fn model(preset: &str) -> Arc<Model> {
        Arc::new(crate::model::read(presets::find(preset).unwrap().text).unwrap())
    }

    fn full(receiver: &Receiver<Answer>, generation: u64) -> Answer {
        receiver
            .iter()
            .find(|a| a.generation == generation && a.stage == Stage::Full)
            .unwrap()
    }

    #[test]
    fn the_newest_request_is_answered_in_full() {
        let (sender, receiver) = channel();
        let worker = Worker::start(move |answer| sender.send(answer).unwrap());
        let model = model("fig08");
        for generation in 1..=20 {
            worker.request(Request {
                generation,
                model: Arc::clone(&model),
                study: None,
            });
        }
        let answer = full(&receiver, 20);
        let expected = sweep(&model, &frequencies(&model.sweep), &AtomicBool::new(false)).unwrap();
        assert_eq!(answer.result.unwrap().members[0].frf, expected);
    }

    #[test]
    fn a_study_gives_one_labelled_member_for_each_value() {
        let (sender, receiver) = channel();
        let worker = Worker::start(move |answer| sender.send(answer).unwrap());
        worker.request(Request {
            generation: 7,
            model: model("fig08"),
            study: Some(0),
        });
        let curves = full(&receiver, 7).result.unwrap();
        assert_eq!(curves.members.len(), 4);
        assert!(curves.members.iter().all(|member| member.label.is_some()));
        assert_ne!(curves.members[0].frf, curves.members[3].frf);
    }

    #[test]
    fn dropping_the_worker_ends_its_thread() {
        let (sender, receiver) = channel();
        let worker = Worker::start(move |answer| sender.send(answer).unwrap());
        worker.request(Request {
            generation: 1,
            model: model("hundred_absorbers"),
            study: None,
        });
        drop(worker);
        // The thread held the only sender: the channel ends once the thread has.
        assert!(receiver.iter().all(|answer| answer.generation == 1));
    }
}

//! The background threads. Each works on the newest request and cancels the one before it.
//!
//! The worker answers curves in stages. If the whole sweep takes longer than [`PROMPT`], a coarse curve over a few
//! frequencies and the last peaks comes first; then the whole sweep; then the modes, with the sweep and the points that
//! they need; then the verified count of the modes, with the modes that it found missing. New curves cancel all work on
//! older ones except the preparation for an edit, and do not wait for it: modes, shapes and the finite-element curves
//! have their own threads. While a key repeats, only the last count of the modes is therefore completed. A panic inside a
//! solve becomes the error of its answer; the thread continues.

mod background;
mod curve_cache;
mod curves;
mod handlers;
mod job_thread;
mod members;
mod messages;
mod resolve;
mod sample;
mod tuning;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

pub(crate) use background::lower_priority;
use curve_cache::CurveCache;
use job_thread::{JobThread, guarded};
pub use messages::*;
use resolve::{Resolver, Unresolved};
pub use tuning::{Pause, SpreadAnswer, SpreadRequest, TuneAnswer, TuneRequest, TuneStage};

use crate::solve::Cancelled;

/// Background threads that solve. Dropping it cancels their jobs and does not wait for them.
#[derive(Debug)]
pub struct Worker {
    curves: JobThread<Subject>,
    /// Prepares for the next edit.
    expected: Arc<JobThread<ExpectRequest>>,
    /// Receives the curves once they are solved.
    resolving: Arc<JobThread<Unresolved>>,
    shapes: JobThread<ShapeRequest>,
    witness: JobThread<Subject>,
    details: JobThread<SampleRequest>,
    readings: JobThread<SampleRequest>,
    measured: JobThread<SampleRequest>,
    references: JobThread<Subject>,
    levels: JobThread<LevelsRequest>,
    operating: JobThread<OperatingRequest>,
    sensitivities: JobThread<SensitivityRequest>,
    tuning: JobThread<TuneRequest>,
    spreads: JobThread<SpreadRequest>,
}

impl Worker {
    /// Starts the threads; they pass their answers to `notify`.
    pub fn start(notify: impl Fn(Answer) + Clone + Send + 'static) -> Self {
        let cache = CurveCache::default();
        let mut resolver = Resolver::new(cache.clone());
        let send = notify.clone();
        let resolving = Arc::new(JobThread::start(move |unresolved, cancel: &_| {
            resolver.answer(&unresolved, cancel, &|answer| send(Answer::Curves(answer)));
        }));
        let send = notify.clone();
        let next = Arc::clone(&resolving);
        let expected = Arc::new(preparation(cache.clone()));
        let preparing = Arc::clone(&expected);
        let curves = JobThread::start(move |subject: Subject, cancel: &_| {
            let send = |answer| send(Answer::Curves(answer));
            let before = cache.last(0);
            if let Ok(Ok(unresolved)) = curves::answer(subject, &cache, cancel, &send) {
                if let Some(edit) = cache.edit_to_prepare(before, &unresolved.members) {
                    preparing.submit(edit);
                }
                next.submit(unresolved);
            }
        });
        let send = notify.clone();
        let tuning = JobThread::start(move |request, cancel: &_| {
            tuning::search(&request, cancel, &|answer| send(Answer::Tune(answer)));
        });
        Self {
            curves,
            expected,
            resolving,
            shapes: answering(&notify, Answer::Shape, handlers::shape_answer),
            witness: answering(&notify, Answer::Witness, handlers::witness_answer),
            details: answering(&notify, Answer::Sample, sample::answer),
            readings: answering(&notify, Answer::Sample, sample::answer),
            measured: answering(&notify, Answer::Sample, sample::answer),
            references: answering(&notify, Answer::Reference, sample::reference),
            levels: answering(&notify, Answer::Levels, handlers::levels_answer),
            operating: answering(&notify, Answer::Operating, handlers::operating_answer),
            sensitivities: answering(&notify, Answer::Sensitivity, handlers::sensitivity_answer),
            tuning,
            spreads: answering(&notify, Answer::Spread, tuning::spread),
        }
    }

    /// Submits a request. It cancels the request of its kind before it, which may then have no complete answer.
    pub fn request(&self, request: Request) {
        match request {
            Request::Curves(subject) => {
                self.resolving.cancel();
                self.witness.cancel();
                self.details.cancel();
                self.curves.submit(subject);
            }
            Request::Expect(request) => self.expected.submit(request),
            Request::Shape(request) => self.shapes.submit(request),
            Request::Witness(subject) => self.witness.submit(subject),
            Request::Levels(request) => self.levels.submit(request),
            Request::Operating(request) => self.operating.submit(request),
            Request::Sensitivity(request) => self.sensitivities.submit(request),
            Request::Tune(request) => self.tuning.submit(request),
            Request::EndTuning => self.tuning.cancel(),
            Request::Spread(request) => self.spreads.submit(request),
            Request::Reference(subject) => self.references.submit(subject),
            Request::Sample(request) => match request.sampling {
                Sampling::Detail => self.details.submit(request),
                Sampling::Reading => self.readings.submit(request),
                Sampling::Measured => self.measured.submit(request),
            },
        }
    }
}

/// A thread that gives each request one answer, or none if it is cancelled.
fn answering<R: Send + 'static, A: 'static>(
    notify: &(impl Fn(Answer) + Clone + Send + 'static),
    wrap: fn(A) -> Answer,
    answer: fn(&R, &AtomicBool) -> Result<A, Cancelled>,
) -> JobThread<R> {
    let notify = notify.clone();
    JobThread::start(move |request, cancel: &_| {
        if let Ok(found) = answer(&request, cancel) {
            notify(wrap(found));
        }
    })
}

/// Prepares the cache for the next edit, in threads of low priority.
fn preparation(cache: CurveCache) -> JobThread<ExpectRequest> {
    let pool = background::pool();
    JobThread::start(move |request: ExpectRequest, cancel: &_| {
        let expect = || cache.expect(&request, cancel);
        // The request for curves reports an error of the solver.
        drop(guarded(|| {
            Ok(match &pool {
                Some(pool) => pool.install(expect),
                None => expect(),
            }?)
        }));
    })
}

#[cfg(test)]
mod tests;

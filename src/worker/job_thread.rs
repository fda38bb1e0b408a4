//! A thread that works on the newest submitted job.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};

use crate::solve::Cancelled;

/// A new job cancels the running one; so does dropping this, which does not wait for the thread.
#[derive(Debug)]
pub(super) struct JobThread<J> {
    jobs: Sender<(J, Arc<AtomicBool>)>,
    /// Cancels the newest job.
    cancel: Mutex<Arc<AtomicBool>>,
}

impl<J: Send + 'static> JobThread<J> {
    /// Starts the thread; `run` executes a job and returns early once the flag is true.
    pub(super) fn start(run: impl FnMut(J, &AtomicBool) + Send + 'static) -> Self {
        let (jobs, inbox) = channel();
        // Not joined, so that the program can exit while a solve runs; the thread ends when its channel closes.
        std::thread::spawn(move || work(&inbox, run));
        Self {
            jobs,
            cancel: Mutex::default(),
        }
    }

    /// Submits a job and cancels the one before.
    pub(super) fn submit(&self, job: J) {
        let cancel = Arc::new(AtomicBool::new(false));
        self.replace_flag(Arc::clone(&cancel));
        // The thread lives longer than this sender, so sending succeeds.
        let _ = self.jobs.send((job, cancel));
    }
}

impl<J> JobThread<J> {
    /// Cancels the running job.
    pub(super) fn cancel(&self) {
        self.replace_flag(Arc::default());
    }

    fn replace_flag(&self, flag: Arc<AtomicBool>) {
        let mut newest = self.cancel.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::replace(&mut *newest, flag).store(true, Ordering::Relaxed);
    }
}

impl<J> Drop for JobThread<J> {
    fn drop(&mut self) {
        self.cancel();
    }
}

/// Runs the newest job, until the channel closes.
fn work<J>(inbox: &Receiver<(J, Arc<AtomicBool>)>, mut run: impl FnMut(J, &AtomicBool)) {
    while let Ok(mut newest) = inbox.recv() {
        while let Ok(newer) = inbox.try_recv() {
            newest = newer;
        }
        let (job, cancel) = newest;
        run(job, &cancel);
    }
}

/// Why a job has no result.
#[derive(Debug)]
pub(super) enum Unfinished {
    /// It was cancelled.
    Cancelled(Cancelled),
    /// The error, in one line.
    Failed(String),
}

impl From<Cancelled> for Unfinished {
    fn from(cancelled: Cancelled) -> Self {
        Self::Cancelled(cancelled)
    }
}

impl From<String> for Unfinished {
    fn from(reason: String) -> Self {
        Self::Failed(reason)
    }
}

/// The result of a solve, or an error in one line; a panic becomes such an error.
pub(super) fn guarded<T>(
    solve: impl FnOnce() -> Result<T, Unfinished>,
) -> Result<Result<T, String>, Cancelled> {
    match catch_unwind(AssertUnwindSafe(solve)) {
        Ok(Ok(found)) => Ok(Ok(found)),
        Ok(Err(Unfinished::Failed(reason))) => Ok(Err(reason)),
        Ok(Err(Unfinished::Cancelled(cancelled))) => Err(cancelled),
        Err(_) => Ok(Err(
            "the solver stopped because of an internal error".to_owned()
        )),
    }
}

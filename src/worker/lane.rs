//! A thread that works on the newest of the jobs it is given.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};

use crate::solve::Cancelled;

/// A thread with its jobs. A new job cancels the one in work; dropping the lane cancels it too, and does not wait.
#[derive(Debug)]
pub(super) struct Lane<J> {
    jobs: Sender<(J, Arc<AtomicBool>)>,
    /// Cancels the newest job.
    cancel: Mutex<Arc<AtomicBool>>,
}

impl<J: Send + 'static> Lane<J> {
    /// Starts the thread; `run` does a job, and ends early once its flag is true.
    pub(super) fn start(run: impl FnMut(J, &AtomicBool) + Send + 'static) -> Self {
        let (jobs, inbox) = channel();
        // Whoever ends the program shall not wait for a solver; the thread ends with its inbox.
        std::thread::spawn(move || work(&inbox, run));
        Self {
            jobs,
            cancel: Mutex::default(),
        }
    }

    /// Gives a job; what was given before is cancelled.
    pub(super) fn give(&self, job: J) {
        let cancel = Arc::new(AtomicBool::new(false));
        self.replace_flag(Arc::clone(&cancel));
        // The thread ends only after this sender, so the job arrives.
        let _ = self.jobs.send((job, cancel));
    }
}

impl<J> Lane<J> {
    /// Cancels what is in work.
    pub(super) fn cancel(&self) {
        self.replace_flag(Arc::default());
    }

    fn replace_flag(&self, flag: Arc<AtomicBool>) {
        let mut newest = self.cancel.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::replace(&mut *newest, flag).store(true, Ordering::Relaxed);
    }
}

impl<J> Drop for Lane<J> {
    fn drop(&mut self) {
        self.cancel();
    }
}

/// Works on the newest job until the last sender is gone.
fn work<J>(inbox: &Receiver<(J, Arc<AtomicBool>)>, mut run: impl FnMut(J, &AtomicBool)) {
    while let Ok(mut newest) = inbox.recv() {
        while let Ok(newer) = inbox.try_recv() {
            newest = newer;
        }
        let (job, cancel) = newest;
        run(job, &cancel);
    }
}

/// Why some work has no result.
#[derive(Debug)]
pub(super) enum Unfinished {
    /// It was cancelled.
    Cancelled(Cancelled),
    /// What went wrong, in one line.
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

/// What a solve gives, or one line that says what went wrong; a panic is such a line, too.
pub(super) fn guarded<T>(
    solve: impl FnOnce() -> Result<T, Unfinished>,
) -> Result<Result<T, String>, Cancelled> {
    match catch_unwind(AssertUnwindSafe(solve)) {
        Ok(Ok(found)) => Ok(Ok(found)),
        Ok(Err(Unfinished::Failed(reason))) => Ok(Err(reason)),
        Ok(Err(Unfinished::Cancelled(cancelled))) => Err(cancelled),
        Err(_) => Ok(Err("the solver stopped at a fault of its own".to_owned())),
    }
}

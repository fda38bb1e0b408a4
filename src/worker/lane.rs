//! A thread that works on the newest of the jobs it is given.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};

use crate::solve::modes::MOST_MODES;

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

/// What is said where no modes were found: nothing after a cancellation, else that there are too many.
pub(super) fn unless_cancelled<T>(cancel: &AtomicBool) -> Result<Option<T>, String> {
    if cancel.load(Ordering::Relaxed) {
        return Ok(None);
    }
    Err(format!("there are more than {MOST_MODES} modes"))
}

/// What a solve gives, with its panic as an error in words. `None` where it was cancelled.
pub(super) fn guarded<T>(
    solve: impl FnOnce() -> Result<Option<T>, String>,
) -> Option<Result<T, String>> {
    let fault = |_: Box<dyn Any + Send>| Err("the solver stopped at a fault of its own".to_owned());
    catch_unwind(AssertUnwindSafe(solve))
        .unwrap_or_else(fault)
        .transpose()
}

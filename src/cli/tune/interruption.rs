//! Signals during a search. The first one ends the search; the result is evaluated and written as usual. The second one
//! writes the best model so far immediately, without the evaluation. A later one ends the program at once, after a
//! grace period for the second.

use std::path::PathBuf;
use std::process;
use std::sync::atomic::{AtomicBool, AtomicI32, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use signal_hook::iterator::Signals;

use super::{Failure, notes_added, save, say, warn};
use crate::cli::signals;
use crate::escape::shown_path;
use crate::files::{self, Opened};
use crate::model::{self, Checked, path};
use crate::signals::not_ignored;
use crate::tune::Status;

/// The grace period of the second signal, before another one ends the program.
const PATIENCE: Duration = Duration::from_secs(2);

/// The data that the second signal writes.
pub(super) struct Target {
    /// The original.
    pub opened: Opened,
    /// The file for the tuned model.
    pub output: Option<PathBuf>,
    /// Seed of the random numbers.
    pub seed: u64,
}

/// A search that signals can end.
pub(super) struct Interruption {
    /// True after the first signal.
    pub cancel: AtomicBool,
    /// That signal; 0 before.
    signal: AtomicI32,
    best: Mutex<Option<Status>>,
    /// Locked by the thread that writes the result.
    writing: Mutex<()>,
    target: Target,
}

impl Interruption {
    /// Starts to handle signals.
    ///
    /// # Errors
    /// Signals cannot be caught.
    pub(super) fn listen(target: Target) -> Result<Arc<Self>, Failure> {
        signals::clean_up_after_others()?;
        let signals = Signals::new(not_ignored(signals::ASKING))?;
        let interruption = Arc::new(Self {
            cancel: AtomicBool::new(false),
            signal: AtomicI32::new(0),
            best: Mutex::new(None),
            writing: Mutex::new(()),
            target,
        });
        let listener = Arc::clone(&interruption);
        thread::spawn(move || listener.attend(signals));
        Ok(interruption)
    }

    /// Stores the progress of the search.
    pub(super) fn note(&self, status: &Status) {
        *lock(&self.best) = Some(status.clone());
    }

    /// Writes the result, unless the second signal writes it, in which case this does not return.
    pub(super) fn write<T>(&self, write: impl FnOnce() -> T) -> T {
        let _turn = lock(&self.writing);
        write()
    }

    /// The signal that ended the search.
    pub(super) fn signal(&self) -> Option<u8> {
        match self.signal.load(Ordering::SeqCst) {
            0 => None,
            signal => Some(signal as u8),
        }
    }

    fn attend(self: Arc<Self>, mut signals: Signals) {
        let mut second: Option<Instant> = None;
        for signal in signals.forever() {
            match second {
                _ if !self.cancel.load(Ordering::SeqCst) => {
                    self.signal.store(signal, Ordering::SeqCst);
                    self.cancel.store(true, Ordering::SeqCst);
                    say("stopping: the best so far is evaluated; another signal writes it at once");
                }
                None => {
                    second = Some(Instant::now());
                    let own = Arc::clone(&self);
                    thread::spawn(move || own.give_up(signal));
                }
                Some(began) if began.elapsed() > PATIENCE => end(signal),
                Some(_) => {}
            }
        }
    }

    /// Writes the best model so far without evaluation, and ends the program.
    fn give_up(&self, signal: i32) -> ! {
        // Never unlocked, so that nothing else is written.
        let _turn = lock(&self.writing);
        match lock(&self.best).take() {
            Some(best) => self.rescue(&best),
            None => say("stopped: no model was evaluated, and nothing is written"),
        }
        end(signal)
    }

    fn rescue(&self, best: &Status) {
        let Target {
            opened,
            output,
            seed,
        } = &self.target;
        let Some(file) = output else {
            say("stopped: the best so far is, as arguments of --set");
            // Ignore a closed pipe.
            let _ = super::print(&values(&best.model));
            return;
        };
        let note = format!(
            "Tuned: {} models, seed {seed}, cancelled before the best result was evaluated.\n",
            best.evaluations
        );
        let text = model::write(&notes_added(&best.model, &note), &opened.text);
        match save(file, &text) {
            Ok(()) => say(&format!(
                "stopped: the best so far, which was not evaluated again, is in {}",
                shown_path(file)
            )),
            Err(Failure::Other(why)) => say(&format!("error: {why}")),
            Err(Failure::Input(why)) => why.iter().for_each(|why| say(&format!("error: {why}"))),
        }
        if !best.is_possible {
            warn("no model within all limits was found");
        }
    }
}

/// The tuned parameters, one line `PATH=VALUE` each.
fn values(model: &Checked) -> String {
    let variables = model.tune.iter().flat_map(|tune| &tune.variables);
    let parameters = variables.filter_map(|variable| variable.parameters(model).ok());
    let (ids, values): (Vec<_>, Vec<_>) = parameters.flatten().unzip();
    let lines = path::texts(model, &ids).into_iter().zip(values);
    let lines: Vec<String> = lines
        .map(|(path, value)| format!("{path}={}\n", model::format_number(value)))
        .collect();
    lines.concat()
}

fn end(signal: i32) -> ! {
    files::remove_temporaries();
    process::exit(128 + signal)
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::checked;
    use crate::presets;

    #[test]
    fn values_are_as_set_takes_them() {
        let model = model::read(presets::find("cantilever").unwrap().text)
            .unwrap()
            .into_inner();
        assert_eq!(
            values(&checked(&model)),
            "subsystems.Damper.y_left.stiffness=1.4e5\nsubsystems.Damper.y_left.damping=150.0\n"
        );
    }
}

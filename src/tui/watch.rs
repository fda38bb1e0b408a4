//! Detects when another program changes the file of the model.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, SystemTime};

use super::event::Event;

/// The polling interval.
const LOOK_EVERY: Duration = Duration::from_secs(1);

/// The watched file.
#[derive(Debug, Default)]
pub struct Watch {
    path: Arc<Mutex<Option<PathBuf>>>,
}

/// A stamp that identifies the state of a file without reading it; none if there is no file.
type Stamp = Option<(Option<SystemTime>, u64)>;

impl Watch {
    /// Starts polling; reports when the stamp of the file changes, also after a save of this program.
    pub fn start(to: Sender<Event>) -> Self {
        let watch = Self::default();
        let path = Arc::clone(&watch.path);
        thread::spawn(move || look(&path, &to));
        watch
    }

    /// Watches this file from now on.
    pub fn set(&self, path: Option<&Path>) {
        let mut watched = self.path.lock().unwrap_or_else(PoisonError::into_inner);
        if watched.as_deref() != path {
            *watched = path.map(Path::to_owned);
        }
    }
}

fn look(path: &Mutex<Option<PathBuf>>, to: &Sender<Event>) {
    let mut seen: Option<(PathBuf, Stamp)> = None;
    loop {
        let watched = path.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let now = watched.map(|path| {
            let stamp = stamp(&path);
            (path, stamp)
        });
        // A newly opened file is reported, too: it may have changed since it was read.
        let touched = now.is_some() && now != seen;
        seen = now;
        if touched && to.send(Event::Touched).is_err() {
            return;
        }
        thread::sleep(LOOK_EVERY);
    }
}

fn stamp(path: &Path) -> Stamp {
    let found = fs::metadata(path).ok()?;
    Some((found.modified().ok(), found.len()))
}

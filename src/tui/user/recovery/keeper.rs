//! Writes the recovery file of the running program, in the background.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use super::found::Found;
use super::slot::{self, Slot};
use super::text;
use crate::files::{Source, error_text};
use crate::model::{self, Checked};
use crate::worker::lower_priority;

/// After a write the thread pauses this many times as long as the write took: under a repeated key it uses at most a
/// fifth of a processor.
const REST: u32 = 4;
/// The longest pause, for a disk that stalls.
const LONGEST_REST: Duration = Duration::from_millis(500);

/// A text up to this length, bytes, is rewritten at every edit, in a few milliseconds: the recovery file of such a
/// model is itself a model file.
const SHORT: usize = 1 << 15;

/// The longest list of edits, bytes, unless the base text is longer; beyond, they are merged into one.
const MOST_EDITS: usize = 1 << 18;

/// A model with unsaved changes.
#[derive(Debug, Clone)]
pub struct Kept {
    /// Its source.
    pub source: Source,
    /// The current model.
    pub model: Arc<Checked>,
    /// The model when read or saved.
    pub saved: Arc<Checked>,
    /// The text of that model; its comments and order are kept.
    pub base: Arc<str>,
}

/// A job of the thread.
enum Job {
    Keep(Kept),
    /// There are no unsaved changes.
    Clear,
    /// Recovered changes are adopted: their old file is removed after the next job.
    Adopt(Found),
}

/// What remains at the end of the program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Left {
    /// Nothing: everything is saved.
    Nothing,
    /// A recovery file, offered to the next program.
    Offered(PathBuf),
    /// A file in the temporary folder, unknown to the next program.
    Elsewhere(PathBuf),
}

/// Writes the newest state of a model to the recovery folder, in a background thread.
///
/// For a large model only the difference to the last state is appended, so that it is as fast as for a small one;
/// [`finish`] writes the whole model. If states arrive faster than they are written, intermediate ones are skipped; the
/// last one is always written. Writes are not forced to disk: a killed program or a broken connection loses nothing,
/// and a nudge stays cheap; only [`finish`] forces them. Dropping the keeper waits for the thread and leaves the file,
/// as the end of the process does.
///
/// [`finish`]: Self::finish
#[derive(Debug)]
pub struct Keeper {
    folder: PathBuf,
    jobs: Option<Sender<Job>>,
    thread: Option<JoinHandle<Files>>,
}

impl Keeper {
    /// A keeper for this folder, which is created when needed. `report` receives a message when changes cannot be
    /// stored, once for each distinct error.
    pub fn start(folder: PathBuf, report: impl Fn(String) + Send + 'static) -> Self {
        let (jobs, inbox) = channel();
        let files = Files::new(folder.clone());
        Self {
            folder,
            jobs: Some(jobs),
            thread: Some(thread::spawn(move || {
                lower_priority();
                work(&inbox, files, report)
            })),
        }
    }

    /// Stores a state in place of the last one.
    pub fn keep(&self, state: Kept) {
        self.give(Job::Keep(state));
    }

    /// Removes the recovery file: there are no unsaved changes.
    pub fn clear(&self) {
        self.give(Job::Clear);
    }

    /// Adopts recovered changes: their old file is removed once the next state is stored, or nothing is unsaved.
    pub fn adopt(&self, found: Found) {
        self.give(Job::Adopt(found));
    }

    fn give(&self, job: Job) {
        if let Some(jobs) = &self.jobs {
            // The thread outlives this sender unless it panicked, which the hook has reported.
            let _ = jobs.send(job);
        }
    }

    /// Ends the thread; forces the last state, if any, to disk for the next program, or else removes the recovery file.
    /// If the folder cannot be written, uses the temporary folder.
    ///
    /// # Errors
    /// Neither folder can be written: the state is lost. Or there are no unsaved changes and the file cannot be
    /// removed.
    pub fn finish(mut self, last: Option<Kept>) -> io::Result<Left> {
        let folder = self.folder.clone();
        let mut files = self.stop().unwrap_or_else(|| Files::new(folder));
        let left = match last {
            None => files.clear().map(|()| Left::Nothing),
            Some(last) => match files.leave(&last) {
                Ok(path) => Ok(Left::Offered(path)),
                Err(error) => leave_elsewhere(&last).map_err(|_| error),
            },
        }?;
        files.drop_adopted();
        Ok(left)
    }

    /// Waits until everything is written. `None` if the thread panicked or has already stopped.
    fn stop(&mut self) -> Option<Files> {
        self.jobs = None;
        self.thread.take()?.join().ok()
    }
}

impl Drop for Keeper {
    fn drop(&mut self) {
        self.stop();
    }
}

/// Runs the newest job until the keeper is dropped; returns the stored state.
fn work(inbox: &Receiver<Job>, mut files: Files, report: impl Fn(String)) -> Files {
    let mut reported = Vec::new();
    let mut given = Vec::new();
    loop {
        if given.is_empty() {
            match inbox.recv() {
                Ok(job) => given.push(job),
                Err(_) => return files,
            }
        }
        given.extend(inbox.try_iter());
        let began = Instant::now();
        let done = match files.newest(given) {
            Some(Job::Keep(state)) => files.keep(&state, false).map(|_| files.drop_adopted()),
            Some(Job::Clear) => files.clear().map(|()| files.drop_adopted()),
            Some(Job::Adopt(_)) | None => Ok(()),
        };
        if let Err(error) = done {
            let folder = crate::escape::shown_path(&files.folder);
            let sentence = format!(
                "unsaved changes cannot be stored in {folder}: {}",
                error_text(&error)
            );
            if !reported.contains(&sentence) {
                reported.push(sentence.clone());
                report(sentence);
            }
        }
        given = rest(inbox, LONGEST_REST.min(REST * began.elapsed()));
    }
}

/// Pauses to leave the processor to the solver, unless the keeper is dropped; returns the jobs received meanwhile.
fn rest(inbox: &Receiver<Job>, time: Duration) -> Vec<Job> {
    let until = Instant::now() + time;
    let mut given = Vec::new();
    while let Ok(job) = inbox.recv_timeout(until.saturating_duration_since(Instant::now())) {
        given.push(job);
    }
    given
}

/// The files of the program in the recovery folder.
#[derive(Debug)]
struct Files {
    folder: PathBuf,
    held: Option<Held>,
    /// The files to remove after the next job.
    adopted: Vec<Found>,
}

/// A recovery file and its content.
#[derive(Debug)]
struct Held {
    slot: Slot,
    /// The state it restores.
    state: Kept,
    /// The length of its edits, bytes.
    edits: usize,
}

impl Held {
    /// Whether a state can be appended as an edit: it has the same base text, and there is room.
    fn takes(&self, state: &Kept) -> bool {
        state.base.len() > SHORT
            && Arc::ptr_eq(&self.state.base, &state.base)
            && self.edits < MOST_EDITS.max(state.base.len())
    }

    /// Appends a state as an edit.
    fn add(&mut self, state: &Kept, durable: bool) -> io::Result<()> {
        let edit = text::edit(&model::delta(&self.state.model, &state.model));
        self.slot.append(&edit, durable)?;
        self.edits += edit.len();
        self.state = state.clone();
        Ok(())
    }

    /// Rewrites the file: the whole model, or for a large one its base text and the state as the only edit.
    fn rewrite(&mut self, state: &Kept, durable: bool) -> io::Result<()> {
        self.edits = 0;
        let file = if state.base.len() > SHORT {
            let edit = text::edit(&model::delta(&state.saved, &state.model));
            self.edits = edit.len();
            text::write(&state.source, &state.base) + &edit
        } else {
            recovery_text(state)
        };
        self.slot.write(&file, durable)?;
        self.state = state.clone();
        Ok(())
    }
}

impl Files {
    fn new(folder: PathBuf) -> Self {
        Self {
            folder,
            held: None,
            adopted: Vec::new(),
        }
    }

    /// The last of several jobs. Jobs before an adoption belong to another model.
    fn newest(&mut self, jobs: Vec<Job>) -> Option<Job> {
        let mut newest = None;
        for job in jobs {
            newest = match job {
                Job::Adopt(found) => {
                    self.adopted.push(found);
                    None
                }
                job => Some(job),
            };
        }
        newest
    }

    /// Removes adopted files. One that cannot be removed is offered again, which loses nothing.
    fn drop_adopted(&mut self) {
        for found in self.adopted.drain(..) {
            let _ = found.discard();
        }
    }

    /// Stores a state; returns its file.
    fn keep(&mut self, state: &Kept, durable: bool) -> io::Result<PathBuf> {
        if let Some(held) = &mut self.held
            && held.slot.is_there()
            && held.state.source == state.source
        {
            // If an edit cannot be appended (for example, the file was removed), write the whole file.
            if !held.takes(state) || held.add(state, durable).is_err() {
                held.rewrite(state, durable)?;
            }
            return Ok(held.slot.path().to_owned());
        }
        let mut held = Held {
            slot: Slot::claim(&self.folder, &state.source)?,
            state: state.clone(),
            edits: 0,
        };
        if let Err(error) = held.rewrite(state, durable) {
            // The write error is the better message.
            let _ = held.slot.clear();
            return Err(error);
        }
        let path = held.slot.path().to_owned();
        // Only after the new file exists.
        if let Some(old) = self.held.replace(held) {
            old.slot.clear()?;
        }
        Ok(path)
    }

    /// Stores the last state durably, as a whole model file.
    fn leave(&mut self, state: &Kept) -> io::Result<PathBuf> {
        // First the fast way: the program may be killed during the full write.
        let path = self.keep(state, true)?;
        if let Some(held) = &self.held {
            // If it fails, the edits remain.
            let _ = held.slot.write(&recovery_text(state), true);
        }
        Ok(path)
    }

    /// Removes the files.
    fn clear(&mut self) -> io::Result<()> {
        self.held.take().map_or(Ok(()), |held| held.slot.clear())
    }
}

fn recovery_text(state: &Kept) -> String {
    text::write(&state.source, &model::write(&state.model, &state.base))
}

/// Writes a state to the temporary folder, for a user without a recovery folder.
///
/// # Errors
/// That folder cannot be written either.
pub fn leave_elsewhere(state: &Kept) -> io::Result<Left> {
    in_folder(&std::env::temp_dir(), state).map(Left::Elsewhere)
}

fn in_folder(folder: &Path, state: &Kept) -> io::Result<PathBuf> {
    let prefix = format!("beamtune-{}-", slot::stem(&state.source));
    let mut file = tempfile::Builder::new()
        .prefix(&prefix)
        .suffix(".toml")
        .tempfile_in(folder)?;
    file.write_all(recovery_text(state).as_bytes())?;
    file.as_file().sync_all()?;
    Ok(file.keep()?.1)
}

#[cfg(test)]
mod tests {
    use super::super::found;
    use super::*;
    use crate::model::Model;
    use crate::model::checked;
    use crate::presets;
    use std::fs;
    use std::sync::Mutex;

    /// The preset of a name with another length, m.
    fn state(name: &str, length: f64) -> Kept {
        let preset = presets::find(name).unwrap();
        let saved = model::read(preset.text).unwrap().into_inner();
        let mut model = saved.clone();
        model.beam.length = length;
        Kept {
            source: Source::Preset(preset.name),
            model: Arc::new(checked(&model)),
            saved: Arc::new(checked(&saved)),
            base: preset.text.into(),
        }
    }

    /// The same with another length, m.
    fn edited(state: &Kept, length: f64) -> Kept {
        let mut state = state.clone();
        state.model = Arc::new(state.model.derived(|model| model.beam.length = length));
        state
    }

    /// The same with a long base text.
    fn long(mut state: Kept) -> Kept {
        let padding = "# padding\n".repeat(SHORT / 10 + 1);
        state.base = format!("{}{padding}", state.base).into();
        state
    }

    fn keeper(folder: &Path) -> Keeper {
        Keeper::start(folder.to_owned(), |sentence| panic!("{sentence}"))
    }

    /// The lengths of the offered models, m.
    fn lengths(folder: &Path) -> Vec<f64> {
        let mut lengths: Vec<f64> = found(folder)
            .iter()
            .map(|found| found.model().unwrap().beam.length)
            .collect();
        lengths.sort_by(f64::total_cmp);
        lengths
    }

    #[test]
    fn a_recovered_file_is_removed_once_it_is_stored_again_or_saved() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        for saved in [false, true] {
            std::mem::forget(keeper(path).finish(Some(state("fig06", 4.0))));
            let mut offered = found(path);
            assert_eq!(offered.len(), 1);
            let keeper = keeper(path);
            keeper.adopt(offered.remove(0));
            if saved {
                keeper.clear();
            } else {
                keeper.keep(state("fig06", 5.0));
            }
            // Like a killed program: the file remains.
            drop(keeper);
            assert_eq!(lengths(path), if saved { vec![] } else { vec![5.0] });
            for left in found(path) {
                left.discard().unwrap();
            }
        }
    }

    #[test]
    fn a_program_that_dies_leaves_its_last_edit() {
        let folder = tempfile::tempdir().unwrap();
        for first in [state("fig06", 3.5), long(state("fig06", 3.5))] {
            let dying = keeper(folder.path());
            for step in 0..50 {
                dying.keep(edited(&first, 3.5 + f64::from(step)));
            }
            // As the kernel does for a killed process: the lock is released without cleanup.
            drop(dying);
            assert_eq!(lengths(folder.path()), [52.5]);
            let mut found = found(folder.path());
            assert_eq!(found[0].source, Source::Preset("fig06"));
            assert_eq!(found[0].model().unwrap(), *edited(&first, 52.5).model);
            found.remove(0).discard().unwrap();
        }
    }

    #[test]
    fn nothing_unsaved_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let recovery = folder.path().join("recovery");
        assert_eq!(keeper(&recovery).finish(None).unwrap(), Left::Nothing);
        assert!(!recovery.exists());
        let saving = keeper(&recovery);
        saving.keep(state("fig06", 4.0));
        saving.clear();
        drop(saving);
        let quitting = keeper(&recovery);
        quitting.keep(state("fig06", 4.0));
        assert_eq!(quitting.finish(None).unwrap(), Left::Nothing);
        assert_eq!(fs::read_dir(&recovery).map_or(0, Iterator::count), 0);
    }

    #[test]
    fn the_last_state_is_left_where_it_is_said_to_be() {
        let folder = tempfile::tempdir().unwrap();
        let ending = keeper(folder.path());
        ending.keep(state("fig06", 4.0));
        let left = ending.finish(Some(state("fig06", 5.0))).unwrap();
        let found = found(folder.path());
        assert_eq!(found.len(), 1);
        assert_eq!(left, Left::Offered(found[0].path.clone()));
        assert_eq!(
            model::read(&found[0].text)
                .unwrap()
                .into_inner()
                .beam
                .length,
            5.0
        );
    }

    #[test]
    fn two_programs_on_one_model_keep_their_own() {
        let folder = tempfile::tempdir().unwrap();
        let (one, two) = (keeper(folder.path()), keeper(folder.path()));
        one.keep(state("fig06", 4.0));
        two.keep(state("fig06", 5.0));
        drop((one, two));
        assert_eq!(lengths(folder.path()), [4.0, 5.0]);
    }

    #[test]
    fn another_model_takes_the_place_of_the_one_before() {
        let folder = tempfile::tempdir().unwrap();
        let mut files = Files::new(folder.path().to_owned());
        let first = files.keep(&state("fig06", 4.0), false).unwrap();
        assert_eq!(files.keep(&state("fig06", 5.0), false).unwrap(), first);
        assert_eq!(files.held.as_ref().unwrap().state.model.beam.length, 5.0);
        let second = files.keep(&state("fig08", 6.0), false).unwrap();
        assert!(!first.exists() && second.exists());
        drop(files);
        assert_eq!(lengths(folder.path()), [6.0]);
    }

    /// Leaves a state as a killed program does, and recovers it.
    fn left(files: Files) -> Model {
        let folder = files.folder.clone();
        drop(files);
        let mut found = found(&folder);
        assert_eq!(found.len(), 1);
        let found = found.remove(0);
        let model = found.model().unwrap();
        found.discard().unwrap();
        model.into_inner()
    }

    #[test]
    fn an_edit_is_appended_and_the_file_is_not_rewritten() {
        let folder = tempfile::tempdir().unwrap();
        let mut files = Files::new(folder.path().to_owned());
        let first = long(state("fig06", 4.0));
        let path = files.keep(&first, false).unwrap();
        let before = fs::read(&path).unwrap();
        assert!(files.held.as_ref().unwrap().takes(&first));
        let second = edited(&first, 5.0);
        files.keep(&second, false).unwrap();
        let after = fs::read(&path).unwrap();
        assert!(after.len() > before.len() && after.starts_with(&before));
        assert_eq!(left(files), **second.model);
    }

    #[test]
    fn edits_that_take_too_much_room_become_one() {
        let folder = tempfile::tempdir().unwrap();
        let mut files = Files::new(folder.path().to_owned());
        let first = long(state("fig06", 4.0));
        let path = files.keep(&first, false).unwrap();
        let one = fs::metadata(&path).unwrap().len();
        let (mut largest, mut last) = (0, first.clone());
        for step in 0..400 {
            last = edited(&first, 4.0 + f64::from(step));
            files.keep(&last, false).unwrap();
            largest = largest.max(fs::metadata(&path).unwrap().len());
        }
        let room = MOST_EDITS as u64;
        assert!((room..room + 2 * one).contains(&largest), "{largest} bytes");
        assert!(fs::metadata(&path).unwrap().len() < largest);
        assert_eq!(left(files), **last.model);
    }

    #[test]
    fn a_torn_edit_leaves_those_before_it() {
        let folder = tempfile::tempdir().unwrap();
        let mut files = Files::new(folder.path().to_owned());
        let first = long(state("fig06", 4.0));
        let path = files.keep(&first, false).unwrap();
        files.keep(&edited(&first, 5.0), false).unwrap();
        let length = fs::metadata(&path).unwrap().len();
        files.keep(&edited(&first, 6.0), false).unwrap();
        let file = fs::OpenOptions::new().write(true).open(&path).unwrap();
        file.set_len(length + 40).unwrap();
        assert_eq!(left(files).beam.length, 5.0);
    }

    #[test]
    fn a_file_that_another_program_removed_or_saved_text_is_rewritten() {
        let folder = tempfile::tempdir().unwrap();
        let mut files = Files::new(folder.path().to_owned());
        let first = long(state("fig06", 4.0));
        let path = files.keep(&first, false).unwrap();
        fs::remove_file(&path).unwrap();
        assert_eq!(files.keep(&edited(&first, 5.0), false).unwrap(), path);
        assert!(path.exists());
        // The file was reloaded: the base text is another one.
        let mut other = edited(&first, 6.0);
        other.saved = Arc::clone(&first.model);
        other.base = model::write(&first.model, &first.base).into();
        files.keep(&other, false).unwrap();
        let kept = fs::read_to_string(&path).unwrap();
        assert!(kept.contains(&*other.base), "{kept}");
        assert_eq!(left(files), **other.model);
    }

    #[test]
    fn what_is_left_on_purpose_is_a_whole_model_file() {
        let folder = tempfile::tempdir().unwrap();
        let mut files = Files::new(folder.path().to_owned());
        let state = long(state("fig08", 4.0));
        let path = files.leave(&state).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        assert_eq!(model::read(&text).unwrap(), *state.model);
        assert_eq!(left(files), **state.model);
    }

    #[test]
    fn a_folder_that_was_cleared_meanwhile_is_made_again() {
        let folder = tempfile::tempdir().unwrap();
        let recovery = folder.path().join("recovery");
        let mut files = Files::new(recovery.clone());
        files.keep(&state("fig06", 4.0), false).unwrap();
        fs::remove_dir_all(&recovery).unwrap();
        files.keep(&state("fig06", 5.0), false).unwrap();
        drop(files);
        assert_eq!(lengths(&recovery), [5.0]);
    }

    #[test]
    fn an_error_is_reported_once_and_the_temporary_folder_takes_the_last_state() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "").unwrap();
        let reported = Arc::new(Mutex::new(Vec::new()));
        let report = Arc::clone(&reported);
        let keeper = Keeper::start(file.join("recovery"), move |sentence| {
            report.lock().unwrap().push(sentence);
        });
        keeper.keep(state("fig06", 4.0));
        keeper.keep(state("fig06", 5.0));
        let left = keeper.finish(Some(state("fig06", 6.0))).unwrap();
        let Left::Elsewhere(path) = left else {
            panic!("{left:?}");
        };
        let written = fs::read_to_string(&path).unwrap();
        fs::remove_file(&path).unwrap();
        assert!(path.starts_with(std::env::temp_dir()), "{}", path.display());
        assert_eq!(model::read(&written).unwrap().into_inner().beam.length, 6.0);
        let reported = reported.lock().unwrap();
        assert_eq!(reported.len(), 1, "{reported:?}");
        assert!(
            reported[0].starts_with("unsaved changes cannot be stored in "),
            "{reported:?}"
        );
    }

    #[test]
    fn no_folder_at_all_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let missing = folder.path().join("missing");
        assert!(in_folder(&missing, &state("fig06", 4.0)).is_err());
    }
}

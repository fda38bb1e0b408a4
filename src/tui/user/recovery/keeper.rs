//! Keeping the edits of the running program.

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
use crate::model::{self, Model};
use crate::worker::lower_priority;

/// After a state the thread rests this many times as long as it worked: under a key that repeats it takes a fifth of a
/// processor and no more.
const REST: u32 = 4;
/// A disk that stalls is no reason to rest.
const LONGEST_REST: Duration = Duration::from_millis(500);

/// A text up to this length, bytes, is written again at every edit, in a few milliseconds: the recovery file of such a model
/// is itself a model file.
const SHORT: usize = 1 << 15;

/// Edits may take this many bytes, or as many as the text below them where that is longer; then they are rewritten
/// as one.
const MOST_EDITS: usize = 1 << 18;

/// A model that is not saved.
#[derive(Debug, Clone)]
pub struct Kept {
    /// Where it came from.
    pub source: Source,
    /// The model as it stands.
    pub model: Arc<Model>,
    /// The model as it was read or saved.
    pub saved: Arc<Model>,
    /// The text of that, whose comments and order the model keeps.
    pub base: Arc<str>,
}

/// What the thread is to do.
enum Job {
    Keep(Kept),
    /// Nothing is unsaved.
    Clear,
    /// Changes that were found live on here: what was found goes once the next job is done.
    Adopt(Found),
}

/// What a program leaves at its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Left {
    /// Nothing: all was saved.
    Nothing,
    /// A recovery file, which the next program is offered.
    Offered(PathBuf),
    /// A file in the folder for temporary files, of which the next program does not know.
    Elsewhere(PathBuf),
}

/// Keeps the newest state of a model in the recovery folder, in a thread of its own.
///
/// Of a state of a large model only what differs from the one before is added to the file, so that it is kept as soon as
/// one of a small model; [`finish`] writes the whole model. States that come faster than they are written are
/// passed over; the last one is always written. They are not forced to disk: a killed program or a lost line loses
/// nothing by that, and a nudge stays cheap; only [`finish`] does it. Dropping the keeper waits for the thread and leaves the file, as the end of the process does.
///
/// [`finish`]: Self::finish
#[derive(Debug)]
pub struct Keeper {
    folder: PathBuf,
    jobs: Option<Sender<Job>>,
    thread: Option<JoinHandle<Files>>,
}

impl Keeper {
    /// A keeper that writes to this folder, which is made when there is something to keep. `report` is given a
    /// sentence when edits cannot be kept, once for each distinct trouble.
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

    /// Keeps a state in the place of the one before.
    pub fn keep(&self, state: Kept) {
        self.give(Job::Keep(state));
    }

    /// Removes what is kept: nothing is unsaved.
    pub fn clear(&self) {
        self.give(Job::Clear);
    }

    /// Takes over changes that were found: their own file goes once the next state is kept, or nothing is unsaved.
    pub fn adopt(&self, found: Found) {
        self.give(Job::Adopt(found));
    }

    fn give(&self, job: Job) {
        if let Some(jobs) = &self.jobs {
            // The thread ends only after this sender, unless it panicked, which its hook has reported.
            let _ = jobs.send(job);
        }
    }

    /// Ends the thread; writes the last state to disk, where there is one, and leaves it for the next program, or
    /// else removes what is kept. Where the folder cannot be written, the folder for temporary files is.
    ///
    /// # Errors
    /// Neither folder can be written: the state is lost. Or nothing is unsaved and the file cannot be removed.
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

    /// Waits until all is written. `None` where the thread panicked or was stopped before.
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

/// Does the newest job until the keeper is gone; what is held then.
fn work(inbox: &Receiver<Job>, mut files: Files, report: impl Fn(String)) -> Files {
    let mut told = Vec::new();
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
                "unsaved changes are not kept in {folder}: {}",
                error_text(&error)
            );
            if !told.contains(&sentence) {
                told.push(sentence.clone());
                report(sentence);
            }
        }
        given = rest(inbox, LONGEST_REST.min(REST * began.elapsed()));
    }
}

/// Leaves the processor to the solver for a while, but not once the keeper is gone; the jobs given meanwhile.
fn rest(inbox: &Receiver<Job>, time: Duration) -> Vec<Job> {
    let until = Instant::now() + time;
    let mut given = Vec::new();
    while let Ok(job) = inbox.recv_timeout(until.saturating_duration_since(Instant::now())) {
        given.push(job);
    }
    given
}

/// What the program holds in the recovery folder.
#[derive(Debug)]
struct Files {
    folder: PathBuf,
    held: Option<Held>,
    /// What goes once something is kept or cleared.
    adopted: Vec<Found>,
}

/// A recovery file, and what is in it.
#[derive(Debug)]
struct Held {
    slot: Slot,
    /// The state that it leads to.
    state: Kept,
    /// The length of its edits, bytes.
    edits: usize,
}

impl Held {
    /// Whether a state can be added as an edit: it has the same text below it, and there is room.
    fn takes(&self, state: &Kept) -> bool {
        state.base.len() > SHORT
            && Arc::ptr_eq(&self.state.base, &state.base)
            && self.edits < MOST_EDITS.max(state.base.len())
    }

    /// Adds a state as an edit.
    fn add(&mut self, state: &Kept, durable: bool) -> io::Result<()> {
        let edit = text::edit(&model::delta(&self.state.model, &state.model));
        self.slot.append(&edit, durable)?;
        self.edits += edit.len();
        self.state = state.clone();
        Ok(())
    }

    /// Rewrites the file: the whole model, or the text that is the base of a large one and a state as the only edit.
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

    /// The last of some jobs. What was given before something was adopted belongs to another model.
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

    /// Removes what was adopted. What cannot be removed is offered once more, which loses nothing.
    fn drop_adopted(&mut self) {
        for found in self.adopted.drain(..) {
            let _ = found.discard();
        }
    }

    /// Keeps a state; the file it is in.
    fn keep(&mut self, state: &Kept, durable: bool) -> io::Result<PathBuf> {
        if let Some(held) = &mut self.held
            && held.slot.is_there()
            && held.state.source == state.source
        {
            // Where an edit cannot be added, as to a file that was removed, the whole is written.
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
            // What stopped the writing is the better reason.
            let _ = held.slot.clear();
            return Err(error);
        }
        let path = held.slot.path().to_owned();
        // Not before the new one is there.
        if let Some(old) = self.held.replace(held) {
            old.slot.clear()?;
        }
        Ok(path)
    }

    /// Keeps the last state for good, as a whole model file.
    fn leave(&mut self, state: &Kept) -> io::Result<PathBuf> {
        // First in the quick way: the program may be ended while it writes the whole.
        let path = self.keep(state, true)?;
        if let Some(held) = &self.held {
            // Where that fails, the edits are there.
            let _ = held.slot.write(&recovery_text(state), true);
        }
        Ok(path)
    }

    /// Removes what is held.
    fn clear(&mut self) -> io::Result<()> {
        self.held.take().map_or(Ok(()), |held| held.slot.clear())
    }
}

fn recovery_text(state: &Kept) -> String {
    text::write(&state.source, &model::write(&state.model, &state.base))
}

/// Writes a state to the folder for temporary files, for a user without a folder of their own.
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
    use crate::presets;
    use std::fs;
    use std::sync::Mutex;

    /// The preset of a name with another length, m.
    fn state(name: &str, length: f64) -> Kept {
        let preset = presets::find(name).unwrap();
        let saved = model::read(preset.text).unwrap();
        let mut model = saved.clone();
        model.beam.length = length;
        Kept {
            source: Source::Preset(preset.name),
            model: Arc::new(model),
            saved: Arc::new(saved),
            base: preset.text.into(),
        }
    }

    /// The same with another length, m.
    fn edited(state: &Kept, length: f64) -> Kept {
        let mut state = state.clone();
        Arc::make_mut(&mut state.model).beam.length = length;
        state
    }

    /// The same below a text that is long.
    fn long(mut state: Kept) -> Kept {
        let padding = "# padding\n".repeat(SHORT / 10 + 1);
        state.base = format!("{}{padding}", state.base).into();
        state
    }

    fn keeper(folder: &Path) -> Keeper {
        Keeper::start(folder.to_owned(), |sentence| panic!("{sentence}"))
    }

    /// The lengths of the models that are offered, m.
    fn lengths(folder: &Path) -> Vec<f64> {
        let mut lengths: Vec<f64> = found(folder)
            .iter()
            .map(|found| found.model().unwrap().beam.length)
            .collect();
        lengths.sort_by(f64::total_cmp);
        lengths
    }

    #[test]
    fn what_was_found_goes_once_it_is_kept_anew_or_saved() {
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
            // As a killed program ends: the file is left.
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
            // The kernel does the same to a killed process: no farewell, the lock released.
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
        assert_eq!(model::read(&found[0].text).unwrap().beam.length, 5.0);
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

    /// Leaves a state as a killed program does, and takes it.
    fn left(files: Files) -> Model {
        let folder = files.folder.clone();
        drop(files);
        let mut found = found(&folder);
        assert_eq!(found.len(), 1);
        let found = found.remove(0);
        let model = found.model().unwrap();
        found.discard().unwrap();
        model
    }

    #[test]
    fn an_edit_is_added_and_the_file_is_not_written_anew() {
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
        assert_eq!(left(files), *second.model);
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
        assert_eq!(left(files), *last.model);
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
    fn a_file_that_another_program_removed_or_saved_text_is_written_anew() {
        let folder = tempfile::tempdir().unwrap();
        let mut files = Files::new(folder.path().to_owned());
        let first = long(state("fig06", 4.0));
        let path = files.keep(&first, false).unwrap();
        fs::remove_file(&path).unwrap();
        assert_eq!(files.keep(&edited(&first, 5.0), false).unwrap(), path);
        assert!(path.exists());
        // The file was read again: another text is the base.
        let mut other = edited(&first, 6.0);
        other.saved = Arc::clone(&first.model);
        other.base = model::write(&first.model, &first.base).into();
        files.keep(&other, false).unwrap();
        let kept = fs::read_to_string(&path).unwrap();
        assert!(kept.contains(&*other.base), "{kept}");
        assert_eq!(left(files), *other.model);
    }

    #[test]
    fn what_is_left_on_purpose_is_a_whole_model_file() {
        let folder = tempfile::tempdir().unwrap();
        let mut files = Files::new(folder.path().to_owned());
        let state = long(state("fig08", 4.0));
        let path = files.leave(&state).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        assert_eq!(model::read(&text).unwrap(), *state.model);
        assert_eq!(left(files), *state.model);
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
    fn a_trouble_is_told_once_and_the_temporary_folder_takes_the_last_state() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "").unwrap();
        let told = Arc::new(Mutex::new(Vec::new()));
        let tell = Arc::clone(&told);
        let keeper = Keeper::start(file.join("recovery"), move |sentence| {
            tell.lock().unwrap().push(sentence);
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
        assert_eq!(model::read(&written).unwrap().beam.length, 6.0);
        let told = told.lock().unwrap();
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(
            told[0].starts_with("unsaved changes are not kept in "),
            "{told:?}"
        );
    }

    #[test]
    fn no_folder_at_all_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let missing = folder.path().join("missing");
        assert!(in_folder(&missing, &state("fig06", 4.0)).is_err());
    }
}

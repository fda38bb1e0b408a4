//! Recovery files of programs that ended without saving.

use std::fs::{self, DirEntry, File, OpenOptions};
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use super::slot::{LOCK, MODEL, UNNAMED, remove};
use super::text::{self, Contents};
use crate::files::{self, Source};
use crate::model::{self, Checked, Fault};

/// Unsaved edits of a program that has ended. While this value lives, no other program is offered them; afterwards the
/// next one is, unless they were discarded.
#[derive(Debug)]
pub struct Found {
    /// The source of the model.
    pub source: Source,
    /// The base text of the edits.
    pub text: String,
    /// The edits, see [`model::delta`].
    edits: Vec<String>,
    /// The recovery file.
    pub path: PathBuf,
    /// The time of its last change.
    pub age: Duration,
    /// Locked; closing it releases the lock.
    lock: File,
}

impl Found {
    /// The recovered model.
    ///
    /// # Errors
    /// The faults of the text, or of the edited model; the latter means that the file was changed later.
    pub fn model(&self) -> Result<Checked, Vec<Fault>> {
        let mut model = model::read(&self.text)?.into_inner();
        for edit in &self.edits {
            // Edits after a truncated one belong to another state.
            if !model::apply_delta(&mut model, edit) {
                break;
            }
        }
        Checked::new(model)
    }

    /// Deletes the recovery file.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn discard(self) -> io::Result<()> {
        remove(&self.path)?;
        // The lock goes last: another program would take the file for an abandoned one.
        drop(self.lock);
        Ok(())
    }
}

/// Takes the recovery files of programs that have ended, newest first.
///
/// Files that are not recovery files, are truncated or cannot be read are left alone. Other files of killed programs
/// are removed: locks without a recovery file, and partial writes. A missing folder is empty.
pub fn found(folder: &Path) -> Vec<Found> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let entries: Vec<DirEntry> = entries.flatten().collect();
    let files = |ending: &'static str| {
        let with_ending = move |entry: &&DirEntry| {
            // A link or a pipe is not read: a pipe may block forever.
            entry.file_type().is_ok_and(|kind| kind.is_file())
                && entry
                    .path()
                    .extension()
                    .is_some_and(|found| found == ending)
        };
        entries.iter().filter(with_ending).map(DirEntry::path)
    };
    files(LOCK).for_each(|lock| remove_if_lone(&lock));
    let unnamed = entries.iter().filter(|entry| is_unnamed(entry));
    unnamed.for_each(|lock| remove_if_unlocked(&lock.path()));
    let mut found: Vec<Found> = files(MODEL).filter_map(take).collect();
    found.sort_by(|a, b| a.age.cmp(&b.age).then_with(|| a.path.cmp(&b.path)));
    found
}

/// Takes a recovery file, if it is one and no program owns it.
fn take(path: PathBuf) -> Option<Found> {
    // Check first, so that no lock is created for a foreign file.
    read(&path)?;
    let mut options = OpenOptions::new();
    options.write(true).create(true).truncate(false);
    let lock = files::open_with(&path.with_extension(LOCK), &mut options).ok()?;
    lock.try_lock().ok()?;
    // The owner may have changed or removed it before it released the lock.
    let Some(contents) = read(&path) else {
        if !path.exists() {
            // The lock is not needed.
            let _ = remove(&path);
        }
        return None;
    };
    let changed = fs::metadata(&path).and_then(|found| found.modified());
    let age = changed.map_or(Duration::ZERO, |changed| {
        SystemTime::now()
            .duration_since(changed)
            .unwrap_or_default()
    });
    Some(Found {
        source: contents.source,
        text: contents.text,
        edits: contents.edits,
        path,
        age,
        lock,
    })
}

fn read(path: &Path) -> Option<Contents> {
    let mut bytes = Vec::new();
    files::open(path).ok()?.read_to_end(&mut bytes).ok()?;
    text::read(&bytes)
}

/// Removes an abandoned lock without a recovery file. A failure loses nothing.
fn remove_if_lone(lock_path: &Path) {
    let path = lock_path.with_extension(MODEL);
    let Ok(lock) = files::open(lock_path) else {
        return;
    };
    let empty = lock.metadata().is_ok_and(|found| found.len() == 0);
    if empty && lock.try_lock().is_ok() && !path.exists() {
        let _ = remove(&path);
    }
}

/// Whether it is a lock without its final name.
fn is_unnamed(entry: &DirEntry) -> bool {
    let name = entry.file_name();
    let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
    is_file && name.as_encoded_bytes().starts_with(UNNAMED.as_bytes())
}

/// Removes a lock whose program was killed before it named it.
fn remove_if_unlocked(lock_path: &Path) {
    if files::open(lock_path).is_ok_and(|lock| lock.try_lock().is_ok()) {
        let _ = fs::remove_file(lock_path);
    }
}

#[cfg(test)]
mod tests {
    use super::super::slot::{PART, Slot};
    use super::*;

    /// The recovery file of a killed program with this source and text.
    fn leave(folder: &Path, source: &Source, model: &str) -> PathBuf {
        let slot = Slot::claim(folder, source).unwrap();
        slot.write(&text::write(source, model), false).unwrap();
        slot.path().to_owned()
    }

    fn texts(found: &[Found]) -> Vec<&str> {
        found.iter().map(|found| found.text.as_str()).collect()
    }

    #[test]
    fn a_killed_program_s_edits_are_found_and_a_living_one_s_are_not() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let source = Source::File("/b/beam.toml".into());
        let path = leave(folder, &source, "killed");
        let living = Slot::claim(folder, &source).unwrap();
        living
            .write(&text::write(&source, "living"), false)
            .unwrap();
        let all = found(folder);
        assert_eq!(texts(&all), ["killed"]);
        assert_eq!((&all[0].source, &all[0].path), (&source, &path));
        drop(all);
        drop(living);
        assert_eq!(found(folder).len(), 2);
    }

    #[test]
    fn two_programs_are_not_offered_the_same() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        leave(folder, &Source::Stdin, "once");
        let first = found(folder);
        assert_eq!(texts(&first), ["once"]);
        assert_eq!(texts(&found(folder)), [""; 0]);
        drop(first);
        assert_eq!(texts(&found(folder)), ["once"]);
    }

    #[test]
    fn what_is_discarded_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let path = leave(folder, &Source::Stdin, "text");
        fs::write(path.with_extension(PART), "half").unwrap();
        for found in found(folder) {
            found.discard().unwrap();
        }
        assert_eq!(fs::read_dir(folder).unwrap().count(), 0);
    }

    #[test]
    fn the_newest_comes_first_with_its_age() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let hour = Duration::from_secs(3600);
        for (hours, model) in [(2, "middle"), (1, "new"), (3, "old")] {
            let path = leave(folder, &Source::Stdin, model);
            let file = File::options().write(true).open(path).unwrap();
            file.set_modified(SystemTime::now() - hours * hour).unwrap();
        }
        let all = found(folder);
        assert_eq!(texts(&all), ["new", "middle", "old"]);
        assert!(
            all[2].age >= 3 * hour && all[2].age < 4 * hour,
            "{:?}",
            all[2].age
        );
    }

    #[test]
    fn a_file_without_its_lock_is_found() {
        let folder = tempfile::tempdir().unwrap();
        let path = leave(folder.path(), &Source::Stdin, "text");
        fs::remove_file(path.with_extension(LOCK)).unwrap();
        let first = found(folder.path());
        assert_eq!(texts(&first), ["text"]);
        assert_eq!(texts(&found(folder.path())), [""; 0]);
    }

    #[test]
    fn what_is_torn_or_foreign_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let torn = leave(folder, &Source::Stdin, "a long text");
        let whole = fs::read(&torn).unwrap();
        fs::write(&torn, &whole[..whole.len() - 3]).unwrap();
        fs::write(folder.join("notes.toml"), "a = 1\n").unwrap();
        fs::write(folder.join("bytes.toml"), b"\xff").unwrap();
        fs::write(folder.join("note.lock"), "mine").unwrap();
        fs::create_dir(folder.join("folder.toml")).unwrap();
        fs::create_dir(folder.join("folder.lock")).unwrap();
        let before = fs::read_dir(folder).unwrap().count();
        assert_eq!(texts(&found(folder)), [""; 0]);
        assert_eq!(fs::read_dir(folder).unwrap().count(), before);
        assert_eq!(fs::read(&torn).unwrap(), &whole[..whole.len() - 3]);
    }

    #[test]
    fn programs_that_start_and_end_at_once_leave_each_other_alone() {
        const ROUNDS: usize = 30;
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let offered = |model: &str| text::write(&Source::Stdin, model);
        let live = || {
            for round in 0..ROUNDS {
                let slot = Slot::claim(folder, &Source::Stdin).unwrap();
                slot.write(&offered("living"), false).unwrap();
                slot.write(&offered("living still"), false).unwrap();
                assert!(slot.is_there());
                if round % 2 == 0 {
                    slot.clear().unwrap();
                } else {
                    slot.write(&offered("dead"), false).unwrap();
                }
            }
        };
        let start = || {
            let mut count = 0;
            for found in found(folder) {
                assert_eq!(found.text, "dead");
                found.discard().unwrap();
                count += 1;
            }
            count
        };
        let mut count = 0;
        std::thread::scope(|scope| {
            let programs = [scope.spawn(live), scope.spawn(live)];
            while programs.iter().any(|program| !program.is_finished()) {
                count += start();
            }
        });
        assert_eq!(count + start(), ROUNDS);
        assert_eq!(fs::read_dir(folder).unwrap().count(), 0);
    }

    #[test]
    fn links_are_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let elsewhere = leave(&folder.path().join("elsewhere"), &Source::Stdin, "text");
        let inside = folder.path().join("inside");
        fs::create_dir(&inside).unwrap();
        std::os::unix::fs::symlink(elsewhere, inside.join("link.toml")).unwrap();
        assert_eq!(texts(&found(&inside)), [""; 0]);
    }

    #[test]
    fn a_lone_lock_goes_when_its_program_has_ended() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let slot = Slot::claim(folder, &Source::Stdin).unwrap();
        fs::write(slot.path().with_extension(PART), "half").unwrap();
        found(folder);
        assert_eq!(fs::read_dir(folder).unwrap().count(), 2);
        drop(slot);
        found(folder);
        assert_eq!(fs::read_dir(folder).unwrap().count(), 0);
    }

    #[test]
    fn a_lock_without_a_name_goes_when_its_program_has_ended() {
        let folder = tempfile::tempdir().unwrap();
        let (left, held) = (
            folder.path().join(".lock-left"),
            folder.path().join(".lock-held"),
        );
        fs::write(&left, "").unwrap();
        fs::write(&held, "").unwrap();
        let lock = File::open(&held).unwrap();
        lock.try_lock().unwrap();
        found(folder.path());
        assert!(!left.exists() && held.exists());
    }

    #[test]
    fn pipes_are_left_alone_and_not_waited_for() {
        let folder = tempfile::tempdir().unwrap();
        let path = leave(folder.path(), &Source::Stdin, "text");
        for name in ["pipe.toml", "pipe.lock", ".lock-pipe", "text.lock"] {
            let pipe = folder.path().join(name);
            let made = std::process::Command::new("mkfifo").arg(&pipe).status();
            assert!(made.unwrap().success());
        }
        fs::copy(&path, folder.path().join("text.toml")).unwrap();
        assert_eq!(texts(&found(folder.path())), ["text"]);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 7);
    }

    #[test]
    fn a_folder_that_is_not_there_holds_none_and_is_not_made() {
        let folder = tempfile::tempdir().unwrap();
        let missing = folder.path().join("missing");
        assert_eq!(found(&missing).len(), 0);
        assert!(!missing.exists());
    }
}

//! Temporary files that replace other files. A signal removes them; those of a killed program are removed when the next
//! one writes to the folder.

use std::fs::{self, DirEntry, File, Permissions, TryLockError};
use std::io::{self, Write};
use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

use super::error_text;

/// Start of their names.
const PREFIX: &str = ".beamtune-";

/// The number of random letters and digits after it.
const RANDOM: usize = 6;

/// The most attempts to create a file that another program removes as a stale one.
const TRIES: usize = 8;

/// The existing temporary files of this program.
static LIVE: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes the temporary files of this program before a signal ends it.
pub fn remove_temporaries() {
    for path in live().drain(..) {
        let _ = fs::remove_file(path);
    }
}

fn live() -> MutexGuard<'static, Vec<PathBuf>> {
    LIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A temporary file, locked while this value lives. Dropping it removes the file.
#[derive(Debug)]
pub(super) struct Temporary {
    file: NamedTempFile,
    /// Dropped after the file.
    _listed: Listed,
}

/// A path that a signal removes until this is dropped.
#[derive(Debug)]
struct Listed(PathBuf);

impl Drop for Listed {
    fn drop(&mut self) {
        live().retain(|path| *path != self.0);
    }
}

impl Temporary {
    /// Creates a file in a folder, with the mode of new files or for the user alone; removes those of ended programs
    /// from the folder.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub(super) fn in_folder(folder: &Path, private: bool) -> io::Result<Self> {
        remove_left(folder);
        let mut builder = tempfile::Builder::new();
        builder.prefix(PREFIX).rand_bytes(RANDOM);
        if !private {
            // The umask applies; by default temporary files are private.
            builder.permissions(Permissions::from_mode(0o666));
        }
        let own = |error: io::Error| io::Error::new(error.kind(), error_text(&error));
        for _ in 0..TRIES {
            // Locked meanwhile, so that no signal arrives between creating the file and listing it.
            let mut live = live();
            let file = builder.tempfile_in(folder).map_err(own)?;
            let listed = Listed(file.path().to_owned());
            live.push(listed.0.clone());
            drop(live);
            if is_locked(file.as_file()) {
                return Ok(Self {
                    file,
                    _listed: listed,
                });
            }
        }
        Err(io::ErrorKind::ResourceBusy.into())
    }

    pub(super) fn path(&self) -> &Path {
        self.file.path()
    }

    pub(super) fn writer(&mut self) -> &mut dyn Write {
        &mut self.file
    }

    /// Syncs the file to disk.
    pub(super) fn sync(&self) -> io::Result<()> {
        self.file.as_file().sync_all()
    }

    /// Renames it to a path, where it may replace a file.
    ///
    /// # Errors
    /// The system error; this file is then removed.
    pub(super) fn replace(self, target: &Path) -> io::Result<()> {
        self.file
            .persist(target)
            .map(drop)
            .map_err(|error| error.error)
    }

    /// Renames it to a new path that no signal and no other program removes.
    ///
    /// # Errors
    /// The system error; this file is then removed.
    pub(super) fn keep_as(self, path: &Path) -> io::Result<File> {
        self.file
            .persist_noclobber(path)
            .map_err(|error| error.error)
    }
}

/// Locks a new file. Returns false if another program locked it first and removes it.
fn is_locked(file: &File) -> bool {
    match file.try_lock() {
        Ok(()) => !is_removed(file),
        Err(TryLockError::WouldBlock) => false,
        // If files cannot be locked, no program removes those of another.
        Err(TryLockError::Error(_)) => true,
    }
}

fn is_removed(file: &File) -> bool {
    file.metadata().is_ok_and(|found| found.nlink() == 0)
}

/// Removes the files of killed programs. Ignores errors.
fn remove_left(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    for entry in entries.flatten().filter(is_temporary) {
        let path = entry.path();
        // A running program locks its own files.
        if crate::files::open(&path).is_ok_and(|file| file.try_lock().is_ok()) {
            let _ = fs::remove_file(path);
        }
    }
}

/// Whether it has a name of temporary files of this program.
fn is_temporary(entry: &DirEntry) -> bool {
    let name = entry.file_name();
    let random = name.to_str().and_then(|name| name.strip_prefix(PREFIX));
    let is_random =
        |text: &str| text.len() == RANDOM && text.bytes().all(|c| c.is_ascii_alphanumeric());
    random.is_some_and(is_random) && entry.file_type().is_ok_and(|kind| kind.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(folder: &Path) -> usize {
        fs::read_dir(folder).unwrap().count()
    }

    #[test]
    fn a_live_file_stays_and_what_was_left_goes() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let live = Temporary::in_folder(folder, true).unwrap();
        fs::write(folder.join(".beamtune-aB3dE6"), "left").unwrap();
        for foreign in [
            ".beamtune-aB3dE",
            ".beamtune-aB3d-6",
            ".beamtune-notes.txt",
            "beam.toml",
        ] {
            fs::write(folder.join(foreign), "foreign").unwrap();
        }
        fs::create_dir(folder.join(".beamtune-folder")).unwrap();
        let other = Temporary::in_folder(folder, true).unwrap();
        assert!(live.path().exists() && other.path().exists());
        assert!(!folder.join(".beamtune-aB3dE6").exists());
        drop((live, other));
        assert_eq!(count(folder), 5);
    }

    #[test]
    fn what_has_its_place_is_no_more_removed() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let (placed, kept) = (folder.join("placed"), folder.join("kept"));
        let made = || Temporary::in_folder(folder, false).unwrap();
        made().replace(&placed).unwrap();
        made().keep_as(&kept).unwrap();
        assert!(made().keep_as(&kept).is_err());
        assert!(live().iter().all(|path| !path.starts_with(folder)));
        assert_eq!(count(folder), 2);
    }
}

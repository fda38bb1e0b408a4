//! The files of one program in the recovery folder.

use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::os::unix::fs::OpenOptionsExt as _;
use std::path::{Path, PathBuf};

use crate::files::{self, Source};

/// Ending of a recovery file.
pub(super) const MODEL: &str = "toml";
/// Extension of the file that is locked as long as its program runs.
pub(super) const LOCK: &str = "lock";
/// Extension of a recovery file while it is written.
pub(super) const PART: &str = "part";

/// Prefix of a lock before it gets its final name.
pub(super) const UNNAMED: &str = ".lock-";

/// A name in the recovery folder that no other program uses while this value lives. Dropping it leaves the files for
/// the next program, as the end of the program does.
#[derive(Debug)]
pub(super) struct Slot {
    /// The recovery file; it may not exist.
    path: PathBuf,
    /// Locked; closing it releases the lock.
    _lock: File,
}

impl Slot {
    /// Reserves a new name for a source.
    ///
    /// # Errors
    /// The folder cannot be created or written, or files in it cannot be locked.
    pub(super) fn claim(folder: &Path, source: &Source) -> io::Result<Self> {
        const ATTEMPTS: usize = 10;
        files::make_private(folder)?;
        // Before it is locked, another program may take the new file for an abandoned one.
        (1..ATTEMPTS)
            .find_map(|_| Self::try_claim(folder, source).ok())
            .map_or_else(|| Self::try_claim(folder, source), Ok)
    }

    fn try_claim(folder: &Path, source: &Source) -> io::Result<Self> {
        // Locked before it gets its final name, so that no program finds it unlocked.
        let unnamed = tempfile::Builder::new()
            .prefix(UNNAMED)
            .tempfile_in(folder)?;
        unnamed.as_file().try_lock()?;
        let random = unnamed.path().file_name().map(OsStr::to_string_lossy);
        let random = random
            .as_deref()
            .map_or("", |name| name.trim_start_matches(UNNAMED));
        let path = folder.join(format!("{}-{random}.{MODEL}", stem(source)));
        let lock = unnamed
            .persist_noclobber(path.with_extension(LOCK))
            .map_err(|error| error.error)?;
        Ok(Self { path, _lock: lock })
    }

    /// The recovery file.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Whether the lock file still exists under its name: the folder may have been cleared.
    pub(super) fn is_there(&self) -> bool {
        self.path.with_extension(LOCK).exists()
    }

    /// Replaces the recovery file atomically; `durable` forces it to disk. After a failure the file is unchanged.
    pub(super) fn write(&self, text: &str, durable: bool) -> io::Result<()> {
        let part = self.path.with_extension(PART);
        let written = write_new(&part, text, durable).and_then(|()| fs::rename(&part, &self.path));
        if written.is_err() {
            // A partial text is useless, and the disk may be full.
            let _ = fs::remove_file(&part);
        }
        written
    }

    /// Appends an edit to the recovery file; `durable` forces it to disk. After a failure the file is unchanged, or
    /// ends in a truncated edit.
    pub(super) fn append(&self, edit: &str, durable: bool) -> io::Result<()> {
        let mut file = files::open_with(&self.path, OpenOptions::new().append(true))?;
        let length = file.metadata()?.len();
        let mut written = file.write_all(edit.as_bytes());
        if durable {
            written = written.and_then(|()| file.sync_data());
        }
        if written.is_err() {
            // A truncated edit is ignored if it cannot be removed.
            let _ = file.set_len(length);
        }
        written
    }

    /// Removes the files.
    pub(super) fn clear(self) -> io::Result<()> {
        remove(&self.path)
    }
}

/// Writes a file that only the user can read.
fn write_new(path: &Path, text: &str, durable: bool) -> io::Result<()> {
    let mut options = OpenOptions::new();
    options.write(true).create(true).truncate(true);
    options.mode(0o600);
    let mut file = files::open_with(path, &mut options)?;
    file.write_all(text.as_bytes())?;
    if durable {
        file.sync_all()?;
    }
    Ok(())
}

/// Removes a recovery file and its companions, the lock last, so that no program finds the others unlocked.
pub(super) fn remove(path: &Path) -> io::Result<()> {
    for ending in [MODEL, PART, LOCK] {
        match fs::remove_file(path.with_extension(ending)) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    Ok(())
}

/// A readable prefix of a file name: letters, digits, dashes and underscores.
pub(super) fn stem(source: &Source) -> String {
    const LONGEST: usize = 40;
    let name = match source {
        Source::File(path) => path
            .file_stem()
            .map(OsStr::to_string_lossy)
            .unwrap_or_default(),
        Source::Preset(name) => (*name).into(),
        Source::Stdin => "standard-input".into(),
    };
    let plain = |c: char| {
        if c.is_ascii_alphanumeric() || "-_".contains(c) {
            c
        } else {
            '_'
        }
    };
    let stem: String = name.chars().take(LONGEST).map(plain).collect();
    if stem.is_empty() {
        "model".to_owned()
    } else {
        stem
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::names;

    #[test]
    fn a_slot_is_a_locked_name_and_clearing_it_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().join("recovery");
        let slot = Slot::claim(&folder, &Source::File("/b/my beam.toml".into())).unwrap();
        slot.write("one", false).unwrap();
        slot.write("two", true).unwrap();
        assert_eq!(fs::read_to_string(slot.path()).unwrap(), "two");
        let names_then = names(&folder);
        assert_eq!(names_then.len(), 2, "{names_then:?}");
        assert!(names_then.iter().all(|name| name.starts_with("my_beam-")));
        let lock = File::open(slot.path().with_extension(LOCK)).unwrap();
        assert!(lock.try_lock().is_err());
        slot.clear().unwrap();
        assert_eq!(names(&folder), [""; 0]);
    }

    #[test]
    fn edits_are_added_to_a_file_that_is_there() {
        let folder = tempfile::tempdir().unwrap();
        let slot = Slot::claim(folder.path(), &Source::Stdin).unwrap();
        assert!(slot.append("lost", false).is_err());
        slot.write("one", false).unwrap();
        slot.append(" two", false).unwrap();
        slot.append(" three", true).unwrap();
        assert_eq!(fs::read_to_string(slot.path()).unwrap(), "one two three");
        slot.write("four", false).unwrap();
        slot.append(" five", false).unwrap();
        assert_eq!(fs::read_to_string(slot.path()).unwrap(), "four five");
    }

    #[test]
    fn names_are_readable_and_harmless() {
        let of = |path: &str| stem(&Source::File(path.into()));
        assert_eq!(of("/a/beam.v2.toml"), "beam_v2");
        assert_eq!(of("/a/../\n\"é\".toml"), "____");
        assert_eq!(of("/"), "model");
        assert_eq!(of(&"x".repeat(300)), "x".repeat(40));
        assert_eq!(stem(&Source::Preset("fig06")), "fig06");
        assert_eq!(stem(&Source::Stdin), "standard-input");
    }

    #[test]
    fn folder_and_file_are_the_user_s_alone() {
        use std::os::unix::fs::PermissionsExt as _;
        let folder = tempfile::tempdir().unwrap();
        let state = folder.path().join("state");
        let slot = Slot::claim(&state.join("recovery"), &Source::Stdin).unwrap();
        slot.write("", false).unwrap();
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
        assert_eq!(mode(&state), 0o700);
        assert_eq!(mode(&state.join("recovery")), 0o700);
        assert_eq!(mode(slot.path()), 0o600);
    }
}

//! Saves a text atomically and preserves all other properties of the file.
//!
//! The text is written to a temporary file in the same folder, synced to disk and renamed: a reader sees the old text
//! or the new one. The temporary file gets the owner, group, mode and extended attributes before. If the user may not
//! set them, or the file has other names (hard links), the file is written in place instead; until that is complete,
//! the new text is also in a file `NAME.beamtune-RANDOM` in the same folder, which remains if the program is killed
//! meanwhile. If the file cannot be written in place either, it is replaced by a rename, and [`may_save`] tells before
//! what is lost.

mod attributes;
mod temporary;

use std::fs::{self, File, FileType, OpenOptions};
use std::io::{self, Seek as _, SeekFrom};
use std::os::unix::fs::FileTypeExt as _;
use std::path::{Path, PathBuf};

use super::open::{open_with, without_waiting};
use crate::escape::shown_path;
use temporary::Temporary;
pub use temporary::remove_temporaries;

/// Replaces the file's content without blocking: writes to a device directly, rejects a pipe.
///
/// A symbolic link stays a link and its target is replaced.
///
/// # Errors
/// The folder cannot be written, the disk is full, the existing file is read-only, or it is a pipe.
pub fn save(path: &Path, text: &str) -> io::Result<()> {
    let target = target(path)?;
    let Some(kind) = special(&target) else {
        return replace(&target, |file| file.write_all(text.as_bytes()));
    };
    if kind.is_fifo() {
        let words = "it is a pipe; a file would be accepted";
        return Err(io::Error::new(io::ErrorKind::InvalidInput, words));
    }
    let mut options = OpenOptions::new();
    without_waiting(&mut options);
    io::Write::write_all(&mut options.write(true).open(&target)?, text.as_bytes())
}

/// [`save`] for a content that is written piece by piece. Writes to a pipe or a device directly, and waits for it.
///
/// # Errors
/// As [`save`], and those of `write`; the existing file is then untouched.
pub fn save_with(
    path: &Path,
    write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>,
) -> io::Result<()> {
    let target = target(path)?;
    if special(&target).is_some() {
        return write(&mut OpenOptions::new().write(true).open(&target)?);
    }
    replace(&target, write)
}

/// Checks whether [`save`] could begin now, without side effects; returns what the existing file would lose, in words.
///
/// # Errors
/// The folder cannot be written, or there is a folder or a read-only file at the path.
pub fn may_save(path: &Path) -> io::Result<Option<String>> {
    let target = target(path)?;
    if special(&target).is_some() {
        return Ok(None);
    }
    Ok(match Plan::of(&target)?.way {
        Way::Renamed | Way::InPlace => None,
        Way::Losing(lost) => Some(format!("its {}", lost.join(" and "))),
    })
}

/// The method to replace a file.
enum Way {
    /// By a rename, which preserves everything.
    Renamed,
    /// In place, because a rename would lose something.
    InPlace,
    /// By a rename that loses this, because it cannot be written in place.
    Losing(Vec<&'static str>),
}

/// The new file and the method to replace the old one.
struct Plan {
    temporary: Temporary,
    way: Way,
}

impl Plan {
    fn of(target: &Path) -> io::Result<Self> {
        let is_there = is_there(target)?;
        let temporary = Temporary::in_folder(folder_of(target), is_there)?;
        let lost = if is_there {
            attributes::carry(target, temporary.path())?
        } else {
            Vec::new()
        };
        let way = if lost.is_empty() {
            Way::Renamed
        } else if open_with(target, OpenOptions::new().write(true)).is_ok() {
            Way::InPlace
        } else {
            Way::Losing(lost)
        };
        Ok(Self { temporary, way })
    }
}

fn replace(
    target: &Path,
    write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>,
) -> io::Result<()> {
    let Plan { mut temporary, way } = Plan::of(target)?;
    write(temporary.writer())?;
    temporary.sync()?;
    match way {
        Way::Renamed | Way::Losing(_) => temporary.replace(target)?,
        Way::InPlace => overwrite(target, temporary)?,
    }
    sync_folder(folder_of(target));
    Ok(())
}

/// Writes a file in place. Until all is on disk, a backup file that is not removed contains the new text.
fn overwrite(target: &Path, temporary: Temporary) -> io::Result<()> {
    // `.beamtune-RANDOM` after the name of the file.
    let mut name = target.as_os_str().to_owned();
    name.push(temporary.path().file_name().unwrap_or_default());
    let backup = PathBuf::from(name);
    let mut new = temporary.keep_as(&backup)?;
    sync_folder(folder_of(target));
    let mut file = open_with(target, OpenOptions::new().write(true))?;
    if let Err(error) = extend(&mut file, &mut new) {
        fs::remove_file(&backup)?;
        return Err(error);
    }
    let written = copy(&mut new, 0, &mut file).and_then(|length| {
        file.set_len(length)?;
        file.sync_all()
    });
    match written {
        Ok(()) => fs::remove_file(&backup),
        Err(error) => {
            let words = format!("{error}; the new text is in {}", shown_path(&backup));
            Err(io::Error::new(error.kind(), words))
        }
    }
}

/// Extends the file first, so that a full disk is detected before anything is lost.
fn extend(file: &mut File, new: &mut File) -> io::Result<()> {
    let end = file.metadata()?.len();
    let extended = copy(new, end, file).and_then(|_| file.sync_all());
    if extended.is_err() {
        file.set_len(end)?;
    }
    extended
}

/// Copies a file into another from an offset on; returns the end.
fn copy(from: &mut File, place: u64, to: &mut File) -> io::Result<u64> {
    if from.metadata()?.len() < place {
        return Ok(place);
    }
    from.seek(SeekFrom::Start(place))?;
    to.seek(SeekFrom::Start(place))?;
    Ok(place + io::copy(from, to)?)
}

/// Whether it is neither a file nor a folder: a pipe or a device.
fn special(target: &Path) -> Option<FileType> {
    let kind = fs::metadata(target).ok()?.file_type();
    (!kind.is_file() && !kind.is_dir()).then_some(kind)
}

fn folder_of(target: &Path) -> &Path {
    let folder = target.parent().filter(|one| !one.as_os_str().is_empty());
    folder.unwrap_or(Path::new("."))
}

/// Checks that a file at the path may be replaced; false if there is none.
fn is_there(target: &Path) -> io::Result<bool> {
    match fs::metadata(target) {
        Ok(metadata) if metadata.is_dir() => Err(io::Error::new(
            io::ErrorKind::IsADirectory,
            "there is a folder of this name",
        )),
        Ok(metadata) if metadata.permissions().readonly() => Err(io::Error::new(
            io::ErrorKind::PermissionDenied,
            "the file is read-only",
        )),
        Ok(_) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

/// A system error in words, without the name of a temporary file, which the user does not know.
pub(crate) fn error_text(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" at path ").next().unwrap_or(&text).to_owned()
}

/// The target of a chain of symbolic links; the target of a dangling link is the path it names.
fn target(path: &Path) -> io::Result<PathBuf> {
    const MOST_LINKS: usize = 40;
    let mut path = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&path) {
            Ok(next) => {
                path = path
                    .parent()
                    .map_or(next.clone(), |folder| folder.join(&next));
            }
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

/// Makes the rename itself durable if the system allows it; the content is safe in any case.
fn sync_folder(folder: &Path) {
    if let Ok(folder) = fs::File::open(folder) {
        let _ = folder.sync_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::names;
    use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _, symlink};

    #[test]
    fn the_link_and_the_mode_stay() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("model.toml");
        let link = folder.path().join("link.toml");
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        symlink("model.toml", &link).unwrap();
        save(&link, "new").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        assert_eq!(
            fs::metadata(&file).unwrap().permissions().mode() & 0o777,
            0o640
        );
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
    }

    #[test]
    fn a_new_file_and_a_dangling_link_are_made() {
        let folder = tempfile::tempdir().unwrap();
        symlink("later.toml", folder.path().join("link.toml")).unwrap();
        save(&folder.path().join("link.toml"), "text").unwrap();
        assert_eq!(
            fs::read_to_string(folder.path().join("later.toml")).unwrap(),
            "text"
        );
        assert!(save(&folder.path().join("missing/model.toml"), "text").is_err());
    }

    /// A longer and a shorter text, and one of the same length.
    #[test]
    fn hard_links_stay_links() {
        let folder = tempfile::tempdir().unwrap();
        let (file, other) = (
            folder.path().join("model.toml"),
            folder.path().join("other"),
        );
        fs::write(&file, "old text").unwrap();
        fs::hard_link(&file, &other).unwrap();
        assert_eq!(may_save(&file).unwrap(), None);
        for text in ["a text that is longer", "short", "later", ""] {
            save(&file, text).unwrap();
            assert_eq!(fs::read_to_string(&other).unwrap(), text);
            assert_eq!(fs::metadata(&file).unwrap().nlink(), 2);
            assert_eq!(names(folder.path()), ["model.toml", "other"]);
        }
    }

    /// A failure before the rename, and before anything is written in place.
    #[test]
    fn a_failure_leaves_the_old_file_alone() {
        let folder = tempfile::tempdir().unwrap();
        let (file, other) = (
            folder.path().join("model.toml"),
            folder.path().join("other"),
        );
        fs::write(&file, "old").unwrap();
        let fail = || {
            save_with(&file, |out| {
                out.write_all(b"half")?;
                Err(io::Error::other("stopped"))
            })
        };
        assert_eq!(fail().unwrap_err().to_string(), "stopped");
        fs::hard_link(&file, &other).unwrap();
        assert_eq!(fail().unwrap_err().to_string(), "stopped");
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        assert_eq!(names(folder.path()), ["model.toml", "other"]);
    }

    /// `user.comment` is any attribute; the list (Linux, `posix_acl_xattr.h`) gives the user 12345 the right to read.
    #[cfg(target_os = "linux")]
    #[test]
    fn extended_attributes_and_access_control_lists_stay() {
        use rustix::fs::{XattrFlags, getxattr, setxattr};
        const LIST: &str = "system.posix_acl_access";
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("model.toml");
        fs::write(&file, "old").unwrap();
        let any = u32::MAX;
        let rows: [(u16, u16, u32); 5] = [
            (1, 6, any),
            (2, 4, 12_345),
            (4, 0, any),
            (16, 4, any),
            (32, 0, any),
        ];
        let mut list = 2_u32.to_le_bytes().to_vec();
        for (tag, rights, id) in rows {
            list.extend([tag.to_le_bytes(), rights.to_le_bytes()].concat());
            list.extend(id.to_le_bytes());
        }
        let mut given = vec![("user.comment", b"mine".to_vec()), (LIST, list)];
        // A file system without attributes cannot lose them.
        given.retain(|(name, value)| setxattr(&file, *name, value, XattrFlags::empty()).is_ok());
        let inode = fs::metadata(&file).unwrap().ino();
        save(&file, "new").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        assert_ne!(
            fs::metadata(&file).unwrap().ino(),
            inode,
            "it is renamed over"
        );
        for (name, value) in &given {
            let mut found = [0; 256];
            let length = getxattr(&file, *name, &mut found[..]).unwrap();
            assert_eq!(&found[..length], value, "{name}");
        }
        let mode = fs::metadata(&file).unwrap().permissions().mode() & 0o777;
        assert!(given.len() < 2 || mode == 0o640, "{mode:o}");
    }

    /// Only root can create a file of another owner; other users test with their own files.
    #[test]
    fn owner_and_group_stay() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("model.toml");
        fs::write(&file, "old").unwrap();
        let _ = std::os::unix::fs::chown(&file, Some(12_345), Some(23_456));
        let before = fs::metadata(&file).unwrap();
        save(&file, "new").unwrap();
        let after = fs::metadata(&file).unwrap();
        assert_eq!((after.uid(), after.gid()), (before.uid(), before.gid()));
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
    }

    #[test]
    fn a_pipe_is_not_waited_for() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.unwrap().success());
        let error = save(&pipe, "text").unwrap_err().to_string();
        assert_eq!(error, "it is a pipe; a file would be accepted");
        assert!(
            super::super::load(&pipe)
                .unwrap_err()
                .to_string()
                .contains("a pipe")
        );
    }

    #[test]
    fn an_error_does_not_name_the_temporary_file() {
        let folder = tempfile::tempdir().unwrap();
        let error = save(&folder.path().join("missing/model.toml"), "text").unwrap_err();
        assert_eq!(error.to_string(), "No such file or directory (os error 2)");
        assert_eq!(error.kind(), io::ErrorKind::NotFound);
    }

    #[test]
    fn what_cannot_be_saved_is_known_before() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("model.toml");
        may_save(&file).unwrap();
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        assert!(may_save(folder.path()).is_err());
        assert!(may_save(&folder.path().join("missing/model.toml")).is_err());
        fs::write(&file, "old").unwrap();
        may_save(&file).unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o440)).unwrap();
        assert!(may_save(&file).is_err());
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        may_save(Path::new("/dev/null")).unwrap();
    }

    #[test]
    fn a_read_only_file_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("model.toml");
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o440)).unwrap();
        assert!(save(&file, "new").is_err());
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    }
}

//! Putting a text on disk so that no reader ever meets half of it.

use std::io::{self, Read as _};
use std::path::{Path, PathBuf};
use std::{env, fs};

use tempfile::NamedTempFile;

/// Replaces the file's content atomically: a temporary file in the same folder, flushed to disk, then renamed.
///
/// A symbolic link stays a link and its target is replaced. An existing file keeps its permissions.
///
/// # Errors
/// The folder cannot be written, the disk is full, or the existing file is read-only.
pub fn save(path: &Path, text: &str) -> io::Result<()> {
    save_with(path, |file| file.write_all(text.as_bytes()))
}

/// [`save`] for a content that is written piece by piece. What is no regular file (a pipe, a device) is written to
/// as it is.
///
/// # Errors
/// As [`save`], and those of `write`; the existing file is then untouched.
pub fn save_with(
    path: &Path,
    write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>,
) -> io::Result<()> {
    let target = target(path)?;
    if is_special(&target) {
        return write(&mut fs::OpenOptions::new().write(true).open(&target)?);
    }
    let folder = folder_of(&target)?;
    let (mut file, permissions) = temporary(&target, &folder)?;
    write(file.as_file_mut())?;
    if let Some(permissions) = permissions {
        file.as_file().set_permissions(permissions)?;
    }
    file.as_file().sync_all()?;
    file.persist(&target).map_err(|error| error.error)?;
    sync_folder(&folder);
    Ok(())
}

/// Whether [`save`] could begin now; nothing is left behind.
///
/// # Errors
/// The folder cannot be written, or there is a folder or a read-only file at the path.
pub fn may_save(path: &Path) -> io::Result<()> {
    let target = target(path)?;
    if is_special(&target) {
        return Ok(());
    }
    temporary(&target, &folder_of(&target)?).map(drop)
}

/// What is neither a file nor a folder: a pipe, a device.
fn is_special(target: &Path) -> bool {
    fs::metadata(target).is_ok_and(|found| !found.is_file() && !found.is_dir())
}

fn folder_of(target: &Path) -> io::Result<PathBuf> {
    match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => Ok(folder.to_path_buf()),
        _ => env::current_dir(),
    }
}

/// A file beside the one that it will replace, and the permissions of that if it is there.
fn temporary(target: &Path, folder: &Path) -> io::Result<(NamedTempFile, Option<fs::Permissions>)> {
    let permissions = match fs::metadata(target) {
        Ok(metadata) if metadata.is_dir() => {
            return Err(io::Error::new(
                io::ErrorKind::IsADirectory,
                "there is a folder of this name",
            ));
        }
        Ok(metadata) if metadata.permissions().readonly() => {
            return Err(io::Error::new(
                io::ErrorKind::PermissionDenied,
                "the file is read-only",
            ));
        }
        Ok(metadata) => Some(metadata.permissions()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".beamtune-");
    if permissions.is_none() {
        default_mode(&mut builder);
    }
    let own = |error: io::Error| io::Error::new(error.kind(), own_words(&error));
    Ok((builder.tempfile_in(folder).map_err(own)?, permissions))
}

/// An error of the system in words, without the name of a temporary file, which the user does not know.
pub(crate) fn own_words(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" at path ").next().unwrap_or(&text).to_owned()
}

/// The longest model file that is read, bytes: what has no end, as some devices have none, is not waited for.
const LONGEST: u64 = 1 << 28;

/// The text of a model file.
///
/// # Errors
/// It cannot be read, is no regular file, is not UTF-8, or is longer than 256 MiB.
pub fn load(path: &Path) -> io::Result<String> {
    text_of(super::open(path)?)
}

/// As [`load`], of what is open already.
///
/// # Errors
/// As those of [`load`].
pub fn text_of(source: impl io::Read) -> io::Result<String> {
    let mut bytes = Vec::new();
    source.take(LONGEST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LONGEST {
        return Err(io::Error::other(
            "it is longer than 256 MiB, which no model file is",
        ));
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let words = format!("byte {at} is not UTF-8; a model file is UTF-8 text");
        io::Error::new(io::ErrorKind::InvalidData, words)
    })
}

/// The file behind a chain of symbolic links; a dangling link leads to the file it names.
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

/// Lets the umask decide the mode of a new file; temporary files are otherwise private.
#[cfg(unix)]
fn default_mode(builder: &mut tempfile::Builder<'_, '_>) {
    use std::os::unix::fs::PermissionsExt as _;
    builder.permissions(fs::Permissions::from_mode(0o666));
}

#[cfg(not(unix))]
fn default_mode(_builder: &mut tempfile::Builder<'_, '_>) {}

/// Makes the rename itself durable where the system allows it; the content is safe in any case.
fn sync_folder(folder: &Path) {
    if let Ok(folder) = fs::File::open(folder) {
        let _ = folder.sync_all();
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::fs::{PermissionsExt as _, symlink};

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

    #[test]
    fn what_has_no_end_is_not_waited_for() {
        assert!(text_of(io::repeat(b'a')).is_err());
        assert_eq!(text_of(&b"text"[..]).unwrap(), "text");
        let error = text_of(&b"te\xff"[..]).unwrap_err().to_string();
        assert_eq!(error, "byte 2 is not UTF-8; a model file is UTF-8 text");
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

//! Opening files that other programs may have put there: what could be waited for without end is refused.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::Path;

/// Opens a file for reading. A pipe or a device, which may have no end or no other side, is refused and not waited
/// for.
///
/// # Errors
/// It is not there, cannot be read, or is no regular file.
pub fn open(path: &Path) -> io::Result<File> {
    open_with(path, OpenOptions::new().read(true))
}

/// As [`open`], in another way.
///
/// # Errors
/// As those of [`open`].
pub fn open_with(path: &Path, options: &mut OpenOptions) -> io::Result<File> {
    // Before, for opening alone has effects on some devices.
    if let Ok(found) = fs::metadata(path) {
        must_be_file(found.file_type())?;
    }
    without_waiting(options);
    let file = options.open(path)?;
    // After, for it may have been another one before.
    must_be_file(file.metadata()?.file_type())?;
    Ok(file)
}

fn must_be_file(kind: fs::FileType) -> io::Result<()> {
    if kind.is_file() {
        return Ok(());
    }
    let words = format!("it is {}; a regular file would be accepted", name(kind));
    Err(io::Error::new(io::ErrorKind::InvalidInput, words))
}

/// Lets nothing that is opened wait for another program, nor become the terminal of this one.
#[cfg(unix)]
pub(super) fn without_waiting(options: &mut OpenOptions) {
    use rustix::fs::OFlags;
    use std::os::unix::fs::OpenOptionsExt as _;
    options.custom_flags((OFlags::NONBLOCK | OFlags::NOCTTY).bits() as i32);
}

#[cfg(not(unix))]
pub(super) fn without_waiting(_options: &mut OpenOptions) {}

/// What it is, in words.
#[cfg(unix)]
fn name(kind: fs::FileType) -> &'static str {
    use std::os::unix::fs::FileTypeExt as _;
    if kind.is_dir() {
        "a folder"
    } else if kind.is_fifo() {
        "a pipe"
    } else if kind.is_socket() {
        "a socket"
    } else {
        "a device"
    }
}

#[cfg(not(unix))]
fn name(kind: fs::FileType) -> &'static str {
    if kind.is_dir() {
        "a folder"
    } else {
        "a device"
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Read as _, Write as _};

    /// Makes a pipe in the file system.
    fn pipe(path: &Path) {
        let made = std::process::Command::new("mkfifo").arg(path).status();
        assert!(made.unwrap().success());
    }

    #[test]
    fn a_pipe_is_refused_and_not_waited_for() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("pipe");
        pipe(&path);
        let mut write = OpenOptions::new();
        let mut append = OpenOptions::new();
        for refused in [
            open(&path),
            open_with(&path, write.write(true).create(true).truncate(true)),
            open_with(&path, append.append(true)),
        ] {
            let error = refused.unwrap_err().to_string();
            assert_eq!(error, "it is a pipe; a regular file would be accepted");
        }
    }

    #[test]
    fn folders_devices_and_what_is_not_there_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let error = |path: &Path| open(path).unwrap_err();
        assert!(error(folder.path()).to_string().contains("a folder"));
        assert!(
            error(Path::new("/dev/zero"))
                .to_string()
                .contains("a device")
        );
        let missing = error(&folder.path().join("missing"));
        assert_eq!(missing.kind(), io::ErrorKind::NotFound);
    }

    #[test]
    fn a_file_is_read_and_written_also_through_a_link() {
        let folder = tempfile::tempdir().unwrap();
        let (path, link) = (folder.path().join("file"), folder.path().join("link"));
        std::os::unix::fs::symlink("file", &link).unwrap();
        let mut options = OpenOptions::new();
        let mut file = open_with(&link, options.append(true).create(true)).unwrap();
        file.write_all(b"text").unwrap();
        let mut text = String::new();
        open(&path).unwrap().read_to_string(&mut text).unwrap();
        assert_eq!(text, "text");
    }
}

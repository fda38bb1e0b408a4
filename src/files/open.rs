//! Opens untrusted files: rejects all that could block forever.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read as _};
use std::os::unix::fs::{FileTypeExt as _, OpenOptionsExt as _};
use std::path::Path;

use rustix::fs::OFlags;

/// The longest model file that is read, bytes, because some devices have no end.
const LONGEST: u64 = 1 << 28;

/// Opens a file for reading. Rejects a pipe or a device without blocking, because it may have no end or no writer.
///
/// # Errors
/// It does not exist, is unreadable, or is not a regular file.
pub fn open(path: &Path) -> io::Result<File> {
    open_with(path, OpenOptions::new().read(true))
}

/// As [`open`], with other options.
///
/// # Errors
/// As those of [`open`].
pub fn open_with(path: &Path, options: &mut OpenOptions) -> io::Result<File> {
    // Check before, because opening alone has effects on some devices.
    if let Ok(found) = fs::metadata(path) {
        must_be_file(found.file_type())?;
    }
    without_waiting(options);
    let file = options.open(path)?;
    // Check after, because the file may have been replaced meanwhile.
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

/// Prevents opening from blocking, and the opened file from becoming the controlling terminal.
pub(super) fn without_waiting(options: &mut OpenOptions) {
    options.custom_flags((OFlags::NONBLOCK | OFlags::NOCTTY).bits() as i32);
}

/// The kind of a file, in words.
fn name(kind: fs::FileType) -> &'static str {
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

/// The text of a model file.
///
/// # Errors
/// It is unreadable, not a regular file, not UTF-8, or longer than 256 MiB.
pub fn load(path: &Path) -> io::Result<String> {
    text_of(open(path)?)
}

/// As [`load`], of an open file.
///
/// # Errors
/// As those of [`load`].
pub fn text_of(source: impl io::Read) -> io::Result<String> {
    let mut bytes = Vec::new();
    source.take(LONGEST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LONGEST {
        return Err(io::Error::other(
            "it is longer than 256 MiB, the limit of a model file",
        ));
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let words = format!("byte {at} is not UTF-8; a model file is UTF-8 text");
        io::Error::new(io::ErrorKind::InvalidData, words)
    })
}

/// The text of a file of the user; none if it does not exist or cannot (a home that is not a folder).
///
/// # Errors
/// The file is unreadable, not a regular file, or not UTF-8.
pub(crate) fn read_if_there(path: &Path) -> io::Result<Option<String>> {
    match open(path).and_then(io::read_to_string) {
        Ok(text) => Ok(Some(text)),
        Err(error) if is_absent(&error) => Ok(None),
        Err(error) => Err(error),
    }
}

/// Whether an error means that the file does not exist.
fn is_absent(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;

    /// Creates a named pipe.
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

    #[test]
    fn what_has_no_end_is_not_waited_for() {
        assert!(text_of(io::repeat(b'a')).is_err());
        assert_eq!(text_of(&b"text"[..]).unwrap(), "text");
        let error = text_of(&b"te\xff"[..]).unwrap_err().to_string();
        assert_eq!(error, "byte 2 is not UTF-8; a model file is UTF-8 text");
    }
}

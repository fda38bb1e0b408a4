//! What the program keeps for its user, outside of any model file: options and keys ([`config`]), what was last looked
//! at ([`memory`]), edits that are not saved ([`recovery`]) and what went wrong ([`log`]), each in its place
//! ([`Folders`](crate::files::Folders)).
//!
//! Nothing here knows the designer's state. A folder is made when something is written to it, not before.

pub mod config;
pub mod log;
pub mod memory;
pub mod recovery;

use std::fs::DirBuilder;
use std::io;
use std::path::Path;

use crate::files;

pub(super) use crate::files::own_words as why;

/// Makes a folder and those above it where they are missing, for the user alone (mode 0700, as the XDG base directory
/// specification 0.8 asks).
fn make_private(folder: &Path) -> io::Result<()> {
    let mut builder = DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::DirBuilderExt as _;
        builder.mode(0o700);
    }
    builder.create(folder)
}

/// The text of a file of the user; none where it is not there, nor can be (a home that is no folder).
///
/// # Errors
/// The file cannot be read, is no regular file, or is not UTF-8.
pub(crate) fn read_if_there(path: &Path) -> io::Result<Option<String>> {
    match files::open(path).and_then(io::read_to_string) {
        Ok(text) => Ok(Some(text)),
        Err(error) if is_absent(&error) => Ok(None),
        Err(error) => Err(error),
    }
}

/// Whether a file could not be read because it is not there.
fn is_absent(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory
    )
}

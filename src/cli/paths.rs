//! `beamtune paths`: the paths of the user's files.

use super::{Failure, padded};
use crate::escape::shown_path;
use crate::files::Folders;

/// One line per file: its kind and its path. The files need not exist.
pub(super) fn run() -> Result<(), Failure> {
    let folders = Folders::of_user().map_err(Failure::Other)?;
    let lines = [
        ("configuration", folders.config_file()),
        ("memory", folders.memory_file()),
        ("recovery", folders.recovery_folder()),
        ("log", folders.log_file()),
    ];
    let line = |(name, path): &(&str, std::path::PathBuf)| {
        format!("{}  {}\n", padded(name, 13), shown_path(path))
    };
    super::print(&lines.iter().map(line).collect::<String>())
}

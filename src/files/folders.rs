//! The folders of the user's files: the XDG base directories, on every system.

use std::fs::DirBuilder;
use std::io;
use std::os::unix::fs::DirBuilderExt as _;
use std::path::{Path, PathBuf};

use etcetera::BaseStrategy as _;
use etcetera::base_strategy::Xdg;

/// The name of the program's folder in each base directory.
const FOLDER: &str = "beamtune";

/// The folders of one user. They need not exist.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Folders {
    config: PathBuf,
    state: PathBuf,
}

impl Folders {
    /// The folders of the user who runs the program: `beamtune` in `XDG_CONFIG_HOME` and `XDG_STATE_HOME` if these are
    /// absolute paths, else in `~/.config` and `~/.local/state` (XDG base directory specification 0.8).
    ///
    /// # Errors
    /// The user has no home folder; the message says which variables to set.
    pub fn of_user() -> Result<Self, String> {
        let homeless = || {
            "the user's home folder is unknown; set HOME, or XDG_CONFIG_HOME and XDG_STATE_HOME, to absolute paths"
                .to_owned()
        };
        let base = Xdg::new().map_err(|_| homeless())?;
        let config = base.config_dir().join(FOLDER);
        let state = base.state_dir().ok_or_else(homeless)?.join(FOLDER);
        // An empty HOME would resolve to the working folder.
        if config.is_absolute() && state.is_absolute() {
            Ok(Self { config, state })
        } else {
            Err(homeless())
        }
    }

    /// Any two folders, for tests.
    #[cfg(test)]
    pub fn at(config: impl Into<PathBuf>, state: impl Into<PathBuf>) -> Self {
        Self {
            config: config.into(),
            state: state.into(),
        }
    }

    /// The configuration file, which only the user writes.
    pub fn config_file(&self) -> PathBuf {
        self.config.join("config.toml")
    }

    /// The file of options and views that persist from one run to the next.
    pub fn memory_file(&self) -> PathBuf {
        self.state.join("memory.toml")
    }

    /// The folder of unsaved edits.
    pub fn recovery_folder(&self) -> PathBuf {
        self.state.join("recovery")
    }

    /// The log of errors.
    pub fn log_file(&self) -> PathBuf {
        self.state.join("beamtune.log")
    }
}

/// Creates a folder and its missing parents for the user alone (mode 0700, as the XDG base directory specification 0.8
/// requires).
pub(crate) fn make_private(folder: &Path) -> io::Result<()> {
    DirBuilder::new().recursive(true).mode(0o700).create(folder)
}

/// The sorted names of what a folder holds.
#[cfg(test)]
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_in_the_program_s_folders() {
        let folders = Folders::at("/c", "/s");
        assert_eq!(folders.config_file(), Path::new("/c/config.toml"));
        assert_eq!(folders.memory_file(), Path::new("/s/memory.toml"));
        assert_eq!(folders.recovery_folder(), Path::new("/s/recovery"));
        assert_eq!(folders.log_file(), Path::new("/s/beamtune.log"));
    }
}

//! A separate home folder for every program.

use std::fs;
use std::path::{Path, PathBuf};

use portable_pty::CommandBuilder;
use tempfile::TempDir;

/// The program.
pub const BEAMTUNE: &str = env!("CARGO_BIN_EXE_beamtune");

/// A user's folders: for configuration, for state, and to work in.
pub struct Home(TempDir);

impl Home {
    pub fn new() -> Self {
        let home = Self(tempfile::tempdir().unwrap());
        fs::create_dir(home.work()).unwrap();
        home
    }

    /// The folder in which programs are started.
    pub fn work(&self) -> PathBuf {
        self.0.path().join("work")
    }

    /// A file of that folder.
    pub fn file(&self, name: &str) -> PathBuf {
        self.work().join(name)
    }

    /// Writes the user's configuration file.
    pub fn configure(&self, text: &str) {
        let folder = self.0.path().join("config/beamtune");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("config.toml"), text).unwrap();
    }

    /// A file or folder of the program in the user's state folder.
    pub fn state(&self, name: &str) -> PathBuf {
        self.0.path().join("state/beamtune").join(name)
    }

    /// The recovery files.
    pub fn recovery(&self) -> Vec<PathBuf> {
        let folder = self.state("recovery");
        let files = names(&folder).into_iter().filter(|name| {
            Path::new(name)
                .extension()
                .is_some_and(|ending| ending == "toml")
        });
        files.map(|name| folder.join(name)).collect()
    }

    /// Writes a preset into that folder; returns its text.
    pub fn preset(&self, preset: &str, name: &str) -> &'static str {
        let text = beamtune::presets::find(preset).unwrap().text;
        fs::write(self.file(name), text).unwrap();
        text
    }

    /// The names of all entries of that folder.
    pub fn names(&self) -> Vec<String> {
        names(&self.work())
    }

    /// Runs `beamtune` with these arguments, without the environment of the tests.
    pub fn beamtune(&self, arguments: &[&str]) -> CommandBuilder {
        let mut command = self.program(Path::new(BEAMTUNE));
        command.args(arguments);
        command
    }

    /// A program with this home.
    pub fn program(&self, program: &Path) -> CommandBuilder {
        let mut command = CommandBuilder::new(program);
        command.env_clear();
        command.cwd(self.work());
        for (name, value) in self.environment() {
            command.env(name, value);
        }
        command
    }

    /// Every environment variable of a program.
    pub fn environment(&self) -> Vec<(&'static str, String)> {
        let folder = |name: &str| self.0.path().join(name).display().to_string();
        let own = |name| std::env::var(name).unwrap_or_default();
        vec![
            ("HOME", folder("")),
            ("XDG_STATE_HOME", folder("state")),
            ("XDG_CONFIG_HOME", folder("config")),
            ("PATH", own("PATH")),
            ("LANG", "C.UTF-8".to_owned()),
            ("TERM", "xterm-256color".to_owned()),
            ("BEAMTUNE", BEAMTUNE.to_owned()),
        ]
    }
}

/// The names in a folder, in order; none if the folder does not exist.
pub fn names(folder: &Path) -> Vec<String> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

//! The origin of a model.

use std::path::{Path, PathBuf};

use crate::escape::path_text;
use crate::model::{self, Checked, Fault};
use crate::presets::{self, Preset};

/// The origin of a model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Source {
    /// A file, to which it is saved.
    File(PathBuf),
    /// An embedded preset.
    Preset(&'static str),
    /// Standard input.
    Stdin,
}

impl Source {
    /// The name on the status line: a file's name without its folder, or a preset's.
    pub fn name(&self) -> String {
        match self {
            Self::File(path) => path_text(path.file_name().map_or(path.as_path(), Path::new)),
            Self::Preset(name) => (*name).to_owned(),
            Self::Stdin => "standard input".to_owned(),
        }
    }

    /// The file.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::File(path) => Some(path),
            Self::Preset(_) | Self::Stdin => None,
        }
    }

    /// The base folder of relative paths in the model: that of the file, else the working folder, as an empty path.
    pub fn folder(&self) -> &Path {
        let folder = self.path().and_then(Path::parent);
        folder.unwrap_or(Path::new(""))
    }

    /// Its current text; none if it cannot be read (again).
    pub fn text(&self) -> Option<String> {
        match self {
            Self::File(path) => super::load(path).ok(),
            Self::Preset(name) => presets::find(name).map(|preset| preset.text.to_owned()),
            Self::Stdin => None,
        }
    }

    /// The same with an absolute path.
    #[must_use]
    pub fn absolute(&self) -> Self {
        match self {
            Self::File(path) => {
                Self::File(std::path::absolute(path).unwrap_or_else(|_| path.clone()))
            }
            other => other.clone(),
        }
    }
}

/// An opened model.
#[derive(Debug, Clone)]
pub struct Opened {
    /// The model; values set on the command line may differ from the text.
    pub model: Checked,
    /// Its original text.
    pub text: String,
    /// Its origin.
    pub source: Source,
}

impl Opened {
    /// Reads a model from a text.
    ///
    /// # Errors
    /// All faults of the text.
    pub fn read(text: String, source: Source) -> Result<Self, Vec<Fault>> {
        Ok(Self {
            model: model::read(&text)?,
            text,
            source,
        })
    }

    /// An embedded preset.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn preset(preset: &Preset) -> Result<Self, Vec<Fault>> {
        Self::read(preset.text.to_owned(), Source::Preset(preset.name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_file_has_a_path_and_a_folder() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("beam.toml");
        std::fs::write(&path, "text").unwrap();
        let file = Source::File(path.clone());
        assert_eq!(file.path(), Some(&*path));
        assert_eq!(file.folder(), folder.path());
        assert_eq!(file.text().as_deref(), Some("text"));
        assert_eq!(Source::File("beam.toml".into()).folder(), Path::new(""));
        assert_eq!(Source::File("gone.toml".into()).text(), None);
        for source in [Source::Preset("fig06"), Source::Stdin] {
            assert_eq!((source.path(), source.folder()), (None, Path::new("")));
        }
    }

    #[test]
    fn a_preset_is_opened_with_its_text() {
        let preset = presets::find("fig06").unwrap();
        let opened = Opened::preset(preset).unwrap();
        assert_eq!(opened.text, preset.text);
        assert_eq!(opened.source.text().as_deref(), Some(preset.text));
        assert!(Opened::read("length = ".to_owned(), Source::Stdin).is_err());
    }
}

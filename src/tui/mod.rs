//! The designer: a terminal program in which a parameter is turned and its curves follow.
//!
//! A key becomes a command by the one table of [`keys`], a command changes the state of [`app`], the state is drawn
//! by `view`. What is to be done outside of the state (solving, files) are effects, performed by `effects` here; the
//! program waits on one channel of [`event::Event`]s and draws when one has arrived and [`pace`] sees fit. What it
//! keeps for its user is in [`user`].

pub mod app;
mod ascii;
pub mod backend;
mod effects;
pub mod event;
mod export;
mod fuzzy;
pub mod keys;
pub mod options;
pub mod pace;
pub mod plot;
mod run;
pub mod scene;
mod sketch;
pub mod terminal;
pub mod theme;
pub mod tree;
pub mod user;
pub mod view;
mod watch;

use std::path::PathBuf;

pub use run::{Ended, Setup, run};

use crate::escape::path_text;
use crate::model::Model;

/// Where a model came from.
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
            Self::File(path) => path_text(
                path.file_name()
                    .map_or(path.as_path(), std::path::Path::new),
            ),
            Self::Preset(name) => (*name).to_owned(),
            Self::Stdin => "standard input".to_owned(),
        }
    }

    /// The same, found from any folder.
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

/// A model that was opened.
#[derive(Debug, Clone)]
pub struct Opened {
    /// The model; it may differ from the text by values set on the command line.
    pub model: Model,
    /// The text it was read from.
    pub text: String,
    /// Where that came from.
    pub source: Source,
}

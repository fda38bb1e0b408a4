//! The stored view state: options that the user changed, and the last view of each model.
//!
//! It is never part of a model file. The file is read and written as a whole; unknown options are preserved, so that an
//! older program does not remove those of a newer one.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use serde::{Deserialize, Serialize};

use crate::escape::shown_path;
use crate::files::{self, error_text, make_private, read_if_there};

/// The most stored views; older ones are removed.
const MOST_VIEWS: usize = 100;

/// The stored state.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Memory {
    /// Options that the user changed in the designer.
    #[serde(default)]
    pub options: RememberedOptions,
    /// The last view of each model, newest first.
    #[serde(default)]
    pub views: Vec<ViewState>,
    /// The models whose views were stored since the file was read.
    #[serde(skip)]
    seen: Vec<String>,
    /// Unknown keys of a newer version.
    #[serde(flatten)]
    unknown: toml::Table,
}

/// Options that the user changed in the designer; none if unchanged.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RememberedOptions {
    /// Magnitude in decibels, not in powers of ten.
    pub decibels: Option<bool>,
    /// Whether the mouse is captured.
    pub mouse: Option<bool>,
    /// The unit of frequencies.
    pub frequency_unit: Option<String>,
    /// The word of the theme, as in `Theme::word`.
    pub theme: Option<String>,
    /// Unknown keys of a newer version.
    #[serde(flatten)]
    unknown: toml::Table,
}

/// The last view of one model.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ViewState {
    /// The model: a file's absolute path, or `preset:NAME`.
    pub source: String,
    /// The selected row: labels of the tree from the root.
    #[serde(default)]
    pub selected: Vec<String>,
    /// The open groups, each as the labels from the root.
    #[serde(default)]
    pub open: Vec<Vec<String>>,
    /// The names of the visible responses.
    #[serde(default)]
    pub visible: Vec<String>,
    /// Name of the study.
    pub study: Option<String>,
    /// Whether the frequency axis is logarithmic.
    #[serde(default)]
    pub log_frequency: bool,
    /// The cursor on the chart, Hz.
    pub cursor: Option<f64>,
    /// The visible part of the frequency axis, Hz.
    pub window: Option<[f64; 2]>,
    /// The table below the chart.
    pub table: Option<String>,
    /// The name of the chart view.
    pub view: Option<String>,
    /// The name of the form of all responses.
    pub form: Option<String>,
    /// The second cursor, Hz.
    pub second_cursor: Option<f64>,
    /// The marked band, Hz.
    pub band: Option<[f64; 2]>,
    /// The 0 dB reference of each quantity, by its unit.
    #[serde(default)]
    pub decibel_references: BTreeMap<String, f64>,
}

impl Memory {
    /// Reads the file; a missing file is an empty state.
    ///
    /// # Errors
    /// A message if the file cannot be read or has another structure. The program continues with the default.
    pub fn load(path: &Path) -> Result<Self, String> {
        let reported = |reason| format!("{} cannot be read: {reason}", shown_path(path));
        match read_if_there(path) {
            Ok(Some(text)) => parse(&text).map_err(reported),
            Ok(None) => Ok(Self::default()),
            Err(error) => Err(reported(error_text(&error))),
        }
    }

    /// The last view of a model.
    pub fn view(&self, source: &str) -> Option<&ViewState> {
        self.views.iter().find(|view| view.source == source)
    }

    /// Stores a view as the newest and replaces an older one of the same model. Views beyond 100 are removed, as are
    /// numbers that are not finite.
    pub fn remember(&mut self, mut view: ViewState) {
        view.cursor = view.cursor.filter(|cursor| cursor.is_finite());
        let finite = |band: &[f64; 2]| band.iter().all(|end| end.is_finite());
        view.window = view.window.filter(finite);
        view.band = view.band.filter(finite);
        view.second_cursor = view.second_cursor.filter(|cursor| cursor.is_finite());
        if !self.seen.contains(&view.source) {
            self.seen.push(view.source.clone());
        }
        self.views.retain(|known| known.source != view.source);
        self.views.insert(0, view);
        self.views.truncate(MOST_VIEWS);
    }

    /// Merges the changes of another state.
    fn take(&mut self, newer: &Self) {
        let options = &newer.options;
        self.options.decibels = options.decibels.or(self.options.decibels);
        self.options.mouse = options.mouse.or(self.options.mouse);
        if options.frequency_unit.is_some() {
            self.options
                .frequency_unit
                .clone_from(&options.frequency_unit);
        }
        if options.theme.is_some() {
            self.options.theme.clone_from(&options.theme);
        }
        let own = newer
            .views
            .iter()
            .filter(|view| newer.seen.contains(&view.source));
        // The newest last, so that it ends up first.
        own.rev().for_each(|view| self.remember(view.clone()));
    }
}

fn parse(text: &str) -> Result<Memory, String> {
    toml::from_str(text).map_err(|error: toml::de::Error| error.message().to_owned())
}

/// Writes the changes since the last read: reads the file again, merges the changed options and views, and replaces the
/// file atomically, so that two running programs keep each other's changes. A file that cannot be parsed is renamed to
/// `memory.toml.old`.
///
/// # Errors
/// A message if the file cannot be read or written.
pub fn store(path: &Path, memory: &Memory) -> Result<(), String> {
    try_store(path, memory).map_err(|error| {
        format!(
            "{} cannot be written: {}",
            shown_path(path),
            error_text(&error)
        )
    })
}

fn try_store(path: &Path, memory: &Memory) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        make_private(folder)?;
    }
    let _turn = turn(&sibling(path, "lock"));
    let read = match read_if_there(path) {
        Ok(Some(text)) => parse(&text).ok(),
        Ok(None) => Some(Memory::default()),
        Err(error) if error.kind() == io::ErrorKind::InvalidData => None,
        Err(error) => return Err(error),
    };
    let mut stored = if let Some(stored) = read {
        stored
    } else {
        fs::rename(path, sibling(path, "old"))?;
        Memory::default()
    };
    stored.take(memory);
    let text = toml::to_string(&stored).map_err(io::Error::other)?;
    files::save(path, &text)
}

/// `memory.toml` with another extension appended.
fn sibling(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    PathBuf::from(name)
}

/// Waits briefly for the lock, so that no other program writes between our read and write. Without a lock (no support,
/// or the other program hangs), it continues: at worst, a view is lost.
fn turn(path: &Path) -> Option<File> {
    const TRIES: usize = 100;
    const PAUSE: Duration = Duration::from_millis(10);
    let mut options = OpenOptions::new();
    let file = files::open_with(path, options.write(true).create(true)).ok()?;
    for _ in 0..TRIES {
        match file.try_lock() {
            Ok(()) => return Some(file),
            Err(TryLockError::WouldBlock) => thread::sleep(PAUSE),
            Err(TryLockError::Error(_)) => return None,
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(source: &str) -> ViewState {
        ViewState {
            source: source.to_owned(),
            selected: vec!["Subsystems".to_owned(), "S1".to_owned()],
            open: vec![
                vec!["Subsystems".to_owned()],
                vec!["a \"b\"".to_owned(), "\n".to_owned()],
            ],
            visible: vec!["P5 w".to_owned()],
            study: Some("Arms".to_owned()),
            log_frequency: true,
            cursor: Some(0.1),
            window: Some([1.0, 1e3]),
            table: Some("modes".to_owned()),
            view: Some("Nyquist".to_owned()),
            form: Some("mobility".to_owned()),
            second_cursor: Some(0.2),
            decibel_references: BTreeMap::from([("m/N".to_owned(), 1e-6)]),
            band: Some([2.0, 3.0]),
        }
    }

    fn remembered(path: &Path) -> Memory {
        Memory::load(path).unwrap()
    }

    /// Starts with the stored state and ends with a view of a model.
    fn look_at(path: &Path, source: &str) {
        let mut memory = Memory::load(path).unwrap_or_default();
        memory.remember(view(source));
        store(path, &memory).unwrap();
    }

    #[test]
    fn what_is_stored_is_loaded() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state/memory.toml");
        let mut memory = remembered(&path);
        assert_eq!(memory, Memory::default());
        memory.options.decibels = Some(true);
        memory.options.theme = Some("light".to_owned());
        memory.remember(view("/a.toml"));
        memory.remember(ViewState {
            source: "preset:fig06".to_owned(),
            ..ViewState::default()
        });
        store(&path, &memory).unwrap();
        let loaded = remembered(&path);
        assert_eq!(loaded.options, memory.options);
        assert_eq!(loaded.views, memory.views);
        assert_eq!(loaded.view("/a.toml"), Some(&view("/a.toml")));
        assert_eq!(loaded.views[0].source, "preset:fig06");
        assert_eq!(loaded.view("/b.toml"), None);
    }

    #[test]
    fn of_two_programs_each_stores_what_it_saw() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("memory.toml");
        look_at(&path, "both");
        let mut one = remembered(&path);
        let mut two = remembered(&path);
        two.options.mouse = Some(false);
        two.remember(ViewState {
            cursor: Some(7.0),
            ..view("both")
        });
        store(&path, &two).unwrap();
        one.options.decibels = Some(true);
        one.remember(view("one"));
        store(&path, &one).unwrap();
        let memory = remembered(&path);
        assert_eq!(memory.view("both").unwrap().cursor, Some(7.0));
        assert_eq!(memory.views[0].source, "one");
        assert_eq!(memory.options.mouse, Some(false));
        assert_eq!(memory.options.decibels, Some(true));
    }

    #[test]
    fn programs_that_store_at_once_drop_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("memory.toml");
        thread::scope(|scope| {
            for program in 0..2 {
                let path = &path;
                scope.spawn(move || {
                    for model in 0..5 {
                        look_at(path, &format!("/{program}/{model}"));
                    }
                });
            }
        });
        assert_eq!(remembered(&path).views.len(), 10);
    }

    #[test]
    fn the_newest_hundred_views_stay_one_a_model() {
        let mut memory = Memory::default();
        for n in 0..105 {
            memory.remember(view(&n.to_string()));
        }
        memory.remember(view("50"));
        assert_eq!(memory.views.len(), 100);
        assert_eq!(memory.views[0].source, "50");
        assert_eq!(memory.views[1].source, "104");
        assert_eq!(memory.views[99].source, "5");
        assert_eq!(
            memory
                .views
                .iter()
                .filter(|view| view.source == "50")
                .count(),
            1
        );
    }

    #[test]
    fn numbers_that_are_not_finite_are_forgotten() {
        let mut memory = Memory::default();
        memory.remember(ViewState {
            cursor: Some(f64::NAN),
            window: Some([1.0, f64::INFINITY]),
            ..view("a")
        });
        assert_eq!(
            (memory.views[0].cursor, memory.views[0].window),
            (None, None)
        );
    }

    #[test]
    fn what_a_newer_version_wrote_is_carried_along() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("memory.toml");
        let newer =
            "sounds = 3\n[options]\nmouse = true\nsmell = \"rose\"\n[[views]]\nsource = \"/a\"\n";
        fs::write(&path, newer).unwrap();
        look_at(&path, "/b");
        let table: toml::Table = fs::read_to_string(&path).unwrap().parse().unwrap();
        assert_eq!(table["sounds"].as_integer(), Some(3));
        assert_eq!(table["options"]["smell"].as_str(), Some("rose"));
        assert_eq!(table["views"][1]["source"].as_str(), Some("/a"));
        assert_eq!(remembered(&path).options.mouse, Some(true));
    }

    #[test]
    fn a_broken_file_is_reported_and_renamed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("memory.toml");
        for broken in [&b"views = 3\n"[..], b"[opt", b"a = \"\xff\"\n"] {
            fs::write(&path, broken).unwrap();
            let reason = Memory::load(&path).unwrap_err();
            assert!(reason.contains("memory.toml cannot be read: "), "{reason}");
            look_at(&path, "/a");
            assert_eq!(remembered(&path).views.len(), 1);
            assert_eq!(
                fs::read(folder.path().join("memory.toml.old")).unwrap(),
                broken
            );
        }
    }

    #[test]
    fn a_folder_that_cannot_be_created_is_reported() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "").unwrap();
        assert_eq!(
            Memory::load(&file.join("memory.toml")),
            Ok(Memory::default())
        );
        let reason = store(&file.join("memory.toml"), &Memory::default()).unwrap_err();
        assert!(
            reason.contains("memory.toml cannot be written: "),
            "{reason}"
        );
    }
}

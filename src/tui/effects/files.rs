//! Model files: open, compare, save; and completion of typed paths.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::escape::{path_of_text, path_text};
use crate::files::{self, Opened, Source, error_text};
use crate::measured::{self, Hint, Layout};
use crate::model::{Checked, Fault, Objective};
use crate::tui::app::{Export, ExternalChange, Guard, OpenedMeasured, Reply, Saving};
use crate::tune;

/// Compares a file with its last known text.
pub(super) fn compare(path: &Path, text: &str) -> ExternalChange {
    match files::load(path) {
        Ok(found) if found == text => ExternalChange::Same,
        Err(error) if error.kind() == io::ErrorKind::NotFound => ExternalChange::Gone,
        _ => ExternalChange::Changed,
    }
}

/// Expands a typed path: `~/` is the user's home.
fn from_home(path: PathBuf) -> PathBuf {
    match (path.strip_prefix("~"), std::env::home_dir()) {
        (Ok(rest), Some(home)) => home.join(rest),
        _ => path,
    }
}

pub(super) fn save(path: PathBuf, text: String, guard: &Guard) -> Reply {
    let path = from_home(path);
    match write(&path, &text, guard, Saving::Model) {
        Ok(()) => Reply::Saved(path, text),
        Err(reply) => reply,
    }
}

/// Writes an export.
pub(super) fn export(path: PathBuf, text: &str, kind: Export, guard: &Guard) -> Reply {
    let path = from_home(path);
    match write(&path, text, guard, Saving::Screen(kind)) {
        Ok(()) => Reply::Exported(path),
        Err(reply) => reply,
    }
}

/// Writes a text if the guard allows it; else returns the reason.
fn write(path: &Path, text: &str, guard: &Guard, what: Saving) -> Result<(), Reply> {
    let path = path.to_owned();
    if path.is_dir() {
        let reason = "it is a folder; enter a file name".to_owned();
        return Err(Reply::NotSaved(path, reason));
    }
    let question = match guard {
        Guard::Absent if is_there(&path) => Some(Reply::Exists(path.clone(), what)),
        Guard::Holds(expected) if compare(&path, expected) == ExternalChange::Changed => {
            Some(Reply::ChangedOutside(path.clone()))
        }
        Guard::Losing => {
            return files::save(&path, text)
                .map_err(|error| Reply::NotSaved(path, error_text(&error)));
        }
        _ => None,
    };
    // No question about a file that cannot be replaced.
    match (files::may_save(&path), question) {
        (Err(error), _) => Err(Reply::NotSaved(path, error_text(&error))),
        (Ok(_), Some(question)) => Err(question),
        (Ok(Some(lost)), None) => Err(Reply::Loses(path, what, lost)),
        (Ok(None), None) => {
            files::save(&path, text).map_err(|error| Reply::NotSaved(path, error_text(&error)))
        }
    }
}

/// Opens a file of measured curves; `layout`, if given, describes its columns.
pub(super) fn open_measured(path: PathBuf, layout: Option<&str>) -> Reply {
    let path = from_home(path);
    Reply::Measured(match read_measured(&path, layout) {
        Ok(measured::Opened::Curves(curves)) => OpenedMeasured::Curves(curves),
        Ok(measured::Opened::Asks(inspection)) => OpenedMeasured::Asks(path, inspection),
        Err(fault) => OpenedMeasured::Faulty(path, fault),
    })
}

/// The curves of a file, or the questions to ask first.
fn read_measured(path: &Path, layout: Option<&str>) -> Result<measured::Opened, Fault> {
    let layout = layout.map(Layout::parse).transpose();
    let hint = Hint {
        name: path_text(path),
        layout: layout.map_err(|reason| Fault::new("", reason))?,
    };
    measured::open(&measured::load(path)?, &hint)
}

/// Reads the measured curve of an objective, so that wrong input is refused in its prompt.
pub(super) fn check_match(model: &Checked, objective: &Objective, folder: &Path) -> Reply {
    Reply::MatchChecked(tune::check_match(model, objective, folder))
}

/// Whether there is a file, or something that cannot be inspected.
fn is_there(path: &Path) -> bool {
    !matches!(fs::metadata(path), Err(error) if error.kind() == io::ErrorKind::NotFound)
}

/// Opens a file.
pub(super) fn open(path: PathBuf, reply: impl FnOnce(Box<Opened>) -> Reply) -> Reply {
    let path = from_home(path);
    let text = match files::load(&path) {
        Ok(text) => text,
        Err(error) => return Reply::NotRead(path, error.to_string()),
    };
    match Opened::read(text, Source::File(path.clone())) {
        Ok(opened) => reply(Box::new(opened)),
        Err(faults) => Reply::Faulty(path, faults),
    }
}

/// Completes a path as far as the names in its folder are unambiguous.
pub(super) fn complete(text: &str) -> String {
    let (folder, start) = match text.rfind('/') {
        Some(slash) => text.split_at(slash + 1),
        None => ("", text),
    };
    let listed = if folder.is_empty() { "." } else { folder };
    let Ok(entries) = fs::read_dir(path_of_text(listed)) else {
        return text.to_owned();
    };
    let names = entries.flatten().filter_map(|entry| {
        let name = path_text(Path::new(&entry.file_name()));
        let slash = if entry.path().is_dir() { "/" } else { "" };
        name.starts_with(start).then(|| format!("{name}{slash}"))
    });
    match names.reduce(|common, name| common_start(&common, &name)) {
        Some(common) => format!("{folder}{common}"),
        None => text.to_owned(),
    }
}

fn common_start(a: &str, b: &str) -> String {
    a.chars()
        .zip(b.chars())
        .take_while(|(a, b)| a == b)
        .map(|(a, _)| a)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_completes_to_the_common_start() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["beam one.toml", "beam two.toml", "other.toml"] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        let path = |name: &str| format!("{}/{name}", folder.path().display());
        assert_eq!(complete(&path("b")), path("beam "));
        assert_eq!(complete(&path("o")), path("other.toml"));
        assert_eq!(complete(&path("x")), path("x"));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_name_that_is_not_utf_8_is_completed_and_found() {
        use std::os::unix::ffi::OsStrExt as _;
        let folder = tempfile::tempdir().unwrap();
        let name = std::ffi::OsStr::from_bytes(b"m\xff.toml");
        fs::write(folder.path().join(name), "text").unwrap();
        let typed = complete(&format!("{}/m", path_text(folder.path())));
        assert_eq!(path_of_text(&typed), folder.path().join(name));
        assert_eq!(compare(&path_of_text(&typed), "text"), ExternalChange::Same);
    }

    #[test]
    fn a_file_without_permission_is_refused_without_a_question() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("model.toml");
        fs::write(&file, "old").unwrap();
        let save = |path: PathBuf| match save(path, "new".to_owned(), &Guard::Absent) {
            Reply::NotSaved(_, reason) => reason,
            other => panic!("{other:?}"),
        };
        // Even for the superuser, a file is not a folder.
        let beneath = save(file.join("other.toml"));
        assert!(beneath.contains("directory"), "{beneath}");
        let mut permissions = fs::metadata(&file).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&file, permissions).unwrap();
        assert_eq!(save(file.clone()), "the file is read-only");
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    }

    #[test]
    fn a_file_is_replaced_only_as_the_guard_allows() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("model.toml");
        let save = |guard: Guard| save(path.clone(), "new".to_owned(), &guard);
        fs::write(&path, "old").unwrap();
        assert!(matches!(save(Guard::Absent), Reply::Exists(..)));
        assert!(matches!(
            save(Guard::Holds("other".to_owned())),
            Reply::ChangedOutside(_)
        ));
        assert!(matches!(
            save(Guard::Holds("old".to_owned())),
            Reply::Saved(..)
        ));
        assert_eq!(fs::read_to_string(&path).unwrap(), "new");
        fs::write(&path, "old").unwrap();
        assert!(matches!(save(Guard::Anything), Reply::Saved(..)));
        fs::remove_file(&path).unwrap();
        assert!(matches!(save(Guard::Absent), Reply::Saved(..)));
    }
}

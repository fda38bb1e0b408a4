//! Does what the state asks for: solving, files.

use std::fs;
use std::io;
use std::iter;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Sender;

use super::app::{App, Effect, Guard, Reply};
use super::event::Event;
use super::{Opened, Source};
use crate::model;
use crate::worker::Worker;

/// Does what the state asks for.
#[derive(Debug)]
pub struct Performer {
    worker: Worker,
}

/// What is left to the caller.
#[derive(Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Nothing.
    Done,
    /// What is not saved was written to a file, or why not, in a sentence.
    Rescued(String),
    /// The whole screen is to be drawn anew.
    Redraw,
    /// The program ends, by this signal if there is one.
    Quit(Option<u8>),
}

impl Performer {
    /// A performer whose worker answers on this channel.
    pub fn new(answers: Sender<Event>) -> Self {
        // An answer that comes when the designer is gone is of no use.
        let notify = move |answer| drop(answers.send(Event::Answer(answer)));
        Self {
            worker: Worker::start(notify),
        }
    }

    /// Performs an effect, and those that follow from what came of it.
    pub fn perform(&self, effect: Effect, app: &mut App) -> Outcome {
        let reply = match effect {
            Effect::Solve(request) => {
                self.worker.request(request);
                return Outcome::Done;
            }
            Effect::Rescue { path, text } => return Outcome::Rescued(rescue(&path, &text)),
            Effect::Redraw => return Outcome::Redraw,
            Effect::Quit(signal) => return Outcome::Quit(signal),
            Effect::Save { path, text, guard } => save(path, text, &guard),
            Effect::Open(path) => open(path),
            Effect::Complete(text) => Reply::Completed(complete(&text)),
        };
        let mut outcome = Outcome::Done;
        for effect in app.reply(reply) {
            let next = self.perform(effect, app);
            if next != Outcome::Done {
                outcome = next;
            }
        }
        outcome
    }
}

/// Writes unsaved changes beside the model, or else to the folder for temporary files, never over another file.
fn rescue(path: &Path, text: &str) -> String {
    let elsewhere = path.file_name().map(|name| std::env::temp_dir().join(name));
    let mut reason = String::new();
    for wanted in iter::once(path.to_owned()).chain(elsewhere) {
        let place = unused(&wanted);
        match model::save(&place, text) {
            Ok(()) => return format!("unsaved changes are in {}", place.display()),
            Err(error) => reason = why(&error),
        }
    }
    format!(
        "unsaved changes are lost: {} cannot be written: {reason}",
        path.display()
    )
}

/// The path, or the first of `NAME.2.toml`, `NAME.3.toml`, .. that is not there yet.
fn unused(path: &Path) -> PathBuf {
    let numbered = (2..).map(|number| path.with_extension(format!("{number}.toml")));
    iter::once(path.to_owned())
        .chain(numbered)
        .find(|path| fs::symlink_metadata(path).is_err())
        .unwrap_or_else(|| path.to_owned())
}

/// An error of the system without the name of the temporary file.
fn why(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" at path ").next().unwrap_or(&text).to_owned()
}

fn save(path: PathBuf, text: String, guard: &Guard) -> Reply {
    if path.is_dir() {
        return Reply::NotSaved(path, "it is a folder; a file's name is wanted".to_owned());
    }
    let there = fs::read_to_string(&path);
    match (guard, there) {
        (Guard::Absent, Err(error)) if error.kind() == io::ErrorKind::NotFound => {}
        (Guard::Absent, _) => return Reply::Exists(path),
        (Guard::Holds(expected), Ok(found)) if found != *expected => {
            return Reply::ChangedOutside(path);
        }
        _ => {}
    }
    match model::save(&path, &text) {
        Ok(()) => Reply::Saved(path, text),
        Err(error) => Reply::NotSaved(path, why(&error)),
    }
}

fn open(path: PathBuf) -> Reply {
    let text = match fs::read_to_string(&path) {
        Ok(text) => text,
        Err(error) => return Reply::NotRead(path, error.to_string()),
    };
    match model::read(&text) {
        Ok(model) => Reply::Opened(Box::new(Opened {
            model,
            text,
            source: Source::File(path),
        })),
        Err(faults) => Reply::Faulty(path, faults),
    }
}

/// The path as far as the names in its folder leave no choice.
fn complete(text: &str) -> String {
    let (folder, start) = match text.rfind('/') {
        Some(slash) => text.split_at(slash + 1),
        None => ("", text),
    };
    let listed = if folder.is_empty() { "." } else { folder };
    let Ok(entries) = fs::read_dir(Path::new(listed)) else {
        return text.to_owned();
    };
    let names = entries.flatten().filter_map(|entry| {
        let name = entry.file_name().into_string().ok()?;
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
    fn a_path_completes_to_what_is_common() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["beam one.toml", "beam two.toml", "other.toml"] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        let path = |name: &str| format!("{}/{name}", folder.path().display());
        assert_eq!(complete(&path("b")), path("beam "));
        assert_eq!(complete(&path("o")), path("other.toml"));
        assert_eq!(complete(&path("x")), path("x"));
    }

    #[test]
    fn a_file_is_replaced_only_as_the_guard_allows() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("model.toml");
        let save = |guard: Guard| save(path.clone(), "new".to_owned(), &guard);
        fs::write(&path, "old").unwrap();
        assert!(matches!(save(Guard::Absent), Reply::Exists(_)));
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

//! Boxes in which a line is typed, and lists.

use std::path::PathBuf;

use crossterm::event::{Event as TerminalEvent, KeyEvent};
use tui_input::backend::crossterm::EventHandler;
use tui_input::{Input, InputRequest};

use super::edit::faults_in_words;
use super::{App, Asked, AskedKind, Effect, Guard, Next, Overlay, Prompt, Purpose};
use crate::model::entry;
use crate::model::path::{self, Value};
use crate::presets;
use crate::tui::keys::Command;
use crate::tui::tree::{self, Node};

impl App {
    /// A key without a meaning of its own is typed, where something is typed.
    pub(super) fn type_key(&mut self, key: &KeyEvent) -> Vec<Effect> {
        if let Some(Overlay::Prompt(prompt)) = &mut self.overlay {
            prompt.input.handle_event(&TerminalEvent::Key(*key));
        }
        Vec::new()
    }

    /// What is pasted is typed, where something is typed.
    pub(super) fn paste(&mut self, text: &str) -> Vec<Effect> {
        if let Some(Overlay::Prompt(prompt)) = &mut self.overlay {
            for c in text.chars().filter(|c| !c.is_control()) {
                prompt.input.handle(InputRequest::InsertChar(c));
            }
        }
        Vec::new()
    }

    pub(super) fn prompt_command(&mut self, command: Command) -> Vec<Effect> {
        let Some(Overlay::Prompt(prompt)) = &mut self.overlay else {
            return Vec::new();
        };
        match command {
            Command::Cancel => {
                self.overlay = None;
                self.after_save = None;
                Vec::new()
            }
            Command::Complete => match prompt.purpose {
                Purpose::Open | Purpose::SaveAs => {
                    vec![Effect::Complete(prompt.input.value().to_owned())]
                }
                Purpose::Value(_) => Vec::new(),
            },
            _ => self.accept(),
        }
    }

    fn accept(&mut self) -> Vec<Effect> {
        let Some(Overlay::Prompt(prompt)) = &self.overlay else {
            return Vec::new();
        };
        let text = prompt.input.value().trim().to_owned();
        match prompt.purpose.clone() {
            Purpose::Value(asked) => self.accept_value(&asked, &text),
            Purpose::Open | Purpose::SaveAs if text.is_empty() => {
                self.refuse_prompt("type a file's path");
            }
            Purpose::Open => return vec![Effect::Open(PathBuf::from(text))],
            Purpose::SaveAs => {
                let path = PathBuf::from(text);
                let guard = self.guard(&path);
                return vec![self.save_to(path, guard)];
            }
        }
        Vec::new()
    }

    fn accept_value(&mut self, asked: &Asked, text: &str) {
        let result = read(&asked.kind, text).and_then(|value| {
            self.set(&asked.subject, &asked.path, value, false)
                .map_err(|faults| faults_in_words(&faults, &asked.path, &asked.subject))
        });
        match result {
            Ok(()) => self.overlay = None,
            Err(refusal) => self.refuse_prompt(refusal),
        }
    }

    /// Keeps the box open and says in it what is wrong.
    pub(super) fn refuse_prompt(&mut self, refusal: impl Into<String>) {
        match &mut self.overlay {
            Some(Overlay::Prompt(prompt)) => prompt.refusal = Some(refusal.into()),
            _ => self.refuse(refusal),
        }
    }

    /// Puts a longer text into the box.
    pub(super) fn complete(&mut self, text: String) {
        if let Some(Overlay::Prompt(prompt)) = &mut self.overlay {
            prompt.input = Input::new(text);
        }
    }

    /// Asks for another name of the selected row.
    pub(super) fn ask_name(&mut self) {
        let node = tree::item(self.selection.node()).unwrap_or(self.selection.node());
        let named = tree::name_path(self.model(), node)
            .and_then(|path| path::parameter(self.model(), &path).ok());
        let Some(parameter) = named else {
            return self.refuse(match node {
                Node::Force(_) => "forces have numbers, not names",
                _ => "select a subsystem, response or study to rename it",
            });
        };
        let asked = Asked {
            node,
            subject: format!("{} name", tree::subject(self.model(), node)),
            path: parameter.path,
            range: parameter.range,
            kind: AskedKind::Text,
        };
        let name = match parameter.value {
            Value::Text(name) => name,
            _ => String::new(),
        };
        self.overlay = Some(Overlay::Prompt(Prompt::new(Purpose::Value(asked), name)));
    }

    pub(super) fn list_command(&mut self, command: Command) -> Vec<Effect> {
        let Some(Overlay::Presets(list) | Overlay::Help(list) | Overlay::Faults { list, .. }) =
            &mut self.overlay
        else {
            return Vec::new();
        };
        if list.obey(command) {
            return Vec::new();
        }
        let row = list.row;
        self.overlay = None;
        match command {
            Command::Accept => self.leave(Next::Preset(row)),
            _ => Vec::new(),
        }
    }

    /// The row of the preset that is open, in the list of presets.
    pub(super) fn preset_row(&self) -> usize {
        match self.document.source() {
            crate::tui::Source::Preset(name) => presets::ALL
                .iter()
                .position(|preset| preset.name == *name)
                .unwrap_or(0),
            _ => 0,
        }
    }

    /// What the file must be to be replaced without a question.
    pub(super) fn guard(&self, path: &std::path::Path) -> Guard {
        match self.document.source() {
            crate::tui::Source::File(own) if own == path => {
                Guard::Holds(self.document.saved_text().to_owned())
            }
            _ => Guard::Absent,
        }
    }
}

/// A typed value.
fn read(kind: &AskedKind, text: &str) -> Result<Value, String> {
    match kind {
        AskedKind::Number(old, unit) => entry::number(text, *old, unit).map(Value::Number),
        AskedKind::Text => Ok(Value::Text(text.to_owned())),
        AskedKind::Count(old) => entry::count(text, *old).map(Value::Count),
    }
}

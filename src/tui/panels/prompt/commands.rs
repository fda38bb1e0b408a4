//! Prompts for one line, and lists.

use crossterm::event::{Event as TerminalEvent, KeyEvent};
use tui_input::backend::crossterm::EventHandler;
use tui_input::{Input, InputRequest};

use crate::escape::path_of_text;
use crate::model::edit::Value;
use crate::model::{Group, Parameter};
use crate::presets;
use crate::tui::app::{
    App, Asked, AskedKind, Base, Effect, Guard, LastChange, Next, Overlay, Prompt, Purpose,
};
use crate::tui::keys::{Key, ModelCommand, PickerCommand, PromptCommand};
use crate::tui::tree::{self, Node};

/// The longest line that is typed or pasted, in bytes.
const MOST_TYPED: usize = 4_096;

impl App {
    /// Types a key that has no binding, if a prompt is open.
    pub(crate) fn type_key(&mut self, key: &KeyEvent) -> Vec<Effect> {
        let typed = Key::of(key).is_typed();
        let taken = self.type_into(typed, |input| {
            let room = !typed || input.value().len() < MOST_TYPED;
            if room {
                input.handle_event(&TerminalEvent::Key(*key));
            }
            room
        });
        if !taken {
            self.refuse_prompt(format!("the text is limited to {MOST_TYPED} bytes"));
        }
        Vec::new()
    }

    /// Pastes a text into the open prompt.
    pub(crate) fn paste(&mut self, text: &str) -> Vec<Effect> {
        if !self.scope().is_typing() {
            let edit = self.keys.key_of(ModelCommand::Edit);
            self.refuse(format!(
                "there is no prompt: {edit} opens a value to paste into"
            ));
            return Vec::new();
        }
        let letters = || text.chars().filter(|c| !c.is_control());
        let taken = self.type_into(letters().next().is_some(), |input| {
            let room = input.value().len() + text.len() <= MOST_TYPED;
            for c in letters().filter(|_| room) {
                input.handle(InputRequest::InsertChar(c));
            }
            room
        });
        if !taken {
            self.refuse_prompt(format!(
                "the pasted text exceeds {MOST_TYPED} bytes: nothing was pasted"
            ));
        }
        Vec::new()
    }

    /// Changes the typed line; returns whether there was room for it. Typed text replaces the initial text of a prompt.
    fn type_into(&mut self, typed: bool, change: impl FnOnce(&mut Input) -> bool) -> bool {
        let mut taken = true;
        match &mut self.overlay {
            Some(Overlay::Prompt(prompt)) => {
                prompt.refusal = None;
                let replaces = prompt.replaceable && typed;
                let mut input = if replaces {
                    Input::default()
                } else {
                    prompt.input.clone()
                };
                taken = change(&mut input);
                if taken {
                    (prompt.input, prompt.replaceable) = (input, false);
                }
            }
            Some(Overlay::Palette(palette)) => palette.type_into(|input| taken = change(input)),
            Some(_) => {}
            None => self.type_search(|input| taken = change(input)),
        }
        taken
    }

    pub(crate) fn prompt_command(&mut self, command: PromptCommand) -> Vec<Effect> {
        let Some(Overlay::Prompt(prompt)) = &mut self.overlay else {
            return Vec::new();
        };
        match command {
            PromptCommand::Cancel => {
                self.overlay = None;
                self.files.after_save = None;
                Vec::new()
            }
            PromptCommand::Complete => {
                let is_path = match &prompt.purpose {
                    Purpose::Open | Purpose::SaveAs => true,
                    Purpose::Ask(question) => question.is_path(),
                    Purpose::Value(_) => false,
                };
                let text = prompt.input.value().to_owned();
                is_path
                    .then_some(Effect::Complete(text))
                    .into_iter()
                    .collect()
            }
            PromptCommand::Accept => self.accept(),
        }
    }

    fn accept(&mut self) -> Vec<Effect> {
        let Some(Overlay::Prompt(prompt)) = &self.overlay else {
            return Vec::new();
        };
        let text = prompt.input.value().trim().to_owned();
        match prompt.purpose.clone() {
            Purpose::Value(asked) => self.accept_value(&asked, &text),
            Purpose::Ask(question) => return self.answer_question(&question, &text),
            Purpose::Open | Purpose::SaveAs if text.is_empty() => {
                self.refuse_prompt("type a file's path");
            }
            Purpose::Open => return vec![Effect::Open(path_of_text(&text))],
            Purpose::SaveAs => {
                let path = path_of_text(&text);
                let guard = self.guard(&path);
                return vec![self.save_to(path, guard)];
            }
        }
        Vec::new()
    }

    fn accept_value(&mut self, asked: &Asked, text: &str) {
        let result = asked
            .kind
            .read(text)
            .and_then(|value| self.give(asked, value));
        match result {
            Ok(()) => {
                self.overlay = None;
                self.repeat.last_change = Some(LastChange::Typed(text.to_owned()));
            }
            Err(refusal) => self.refuse_prompt(refusal),
        }
    }

    /// Keeps the prompt open and shows what is wrong.
    pub(crate) fn refuse_prompt(&mut self, refusal: impl Into<String>) {
        match &mut self.overlay {
            Some(Overlay::Prompt(prompt)) => prompt.refusal = Some(refusal.into()),
            _ => self.refuse(refusal),
        }
    }

    /// Puts a completed text into the prompt.
    pub(crate) fn complete(&mut self, text: String) {
        if let Some(Overlay::Prompt(prompt)) = &mut self.overlay {
            prompt.input = Input::new(text);
            prompt.replaceable = false;
        }
    }

    /// Prompts for another name of the selected row.
    pub(crate) fn ask_name(&mut self) {
        let selected = self.selection.node();
        let node = selected.item().map_or(selected, Node::Group);
        let named = node
            .name()
            .and_then(|id| Parameter::of(self.model(), id).ok());
        let Some(parameter) = named else {
            return self.refuse(match node {
                Node::Group(Group::Force(_)) => "forces have numbers, not names",
                _ => "select an inner support, subsystem, response or study to rename it",
            });
        };
        let asked = Asked {
            subject: format!("{} name", tree::subject(self.model(), node)),
            id: parameter.id,
            range: parameter.range,
            kind: AskedKind::Text,
        };
        let name = match parameter.value {
            Value::Text(name) => name,
            _ => String::new(),
        };
        self.overlay = Some(Overlay::Prompt(Prompt::new(Purpose::Value(asked), name)));
    }

    pub(crate) fn picker_command(&mut self, command: PickerCommand) -> Vec<Effect> {
        let presets = |overlay: &mut Overlay| matches!(overlay, Overlay::Presets(_));
        let Some(Overlay::Presets(list)) = self.overlay.take_if(presets) else {
            return Vec::new();
        };
        match command {
            PickerCommand::Accept => self.leave(Next::Preset(list.row)),
            PickerCommand::Cancel => Vec::new(),
        }
    }

    /// The row of the open preset in the list of presets.
    pub(crate) fn preset_row(&self) -> usize {
        match self.document.source() {
            crate::files::Source::Preset(name) => presets::ALL
                .iter()
                .position(|preset| preset.name == *name)
                .unwrap_or(0),
            _ => 0,
        }
    }

    /// The condition for replacing the file without confirmation.
    pub(crate) fn guard(&self, path: &std::path::Path) -> Guard {
        match self.document.source() {
            crate::files::Source::File(own)
                if own == path && self.document.base() != Base::Newer =>
            {
                Guard::Holds(self.document.saved_text().to_owned())
            }
            _ => Guard::Absent,
        }
    }
}

//! From a key to what it does.

use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};

use super::{App, Effect, List, Next, Overlay};
use crate::model::counted;
use crate::tui::keys::{Command, Key, Scope};
use crate::tui::tree;

/// The largest count before a command.
const MOST_TIMES: u32 = 9_999;

impl App {
    pub(super) fn key(&mut self, key: &KeyEvent) -> Vec<Effect> {
        let scope = self.scope();
        let command = self.keys.command(scope, key);
        self.message = None;
        match command {
            Some(command) => self.command(command),
            None if matches!(scope, Scope::Main | Scope::Table) => {
                self.count_up(Key::of(key));
                Vec::new()
            }
            None => self.type_key(key),
        }
    }

    /// A key on a screen that is too small to show anything: only what is the same everywhere. There is no room for a
    /// question, so the program is left with what is not saved kept.
    pub(super) fn key_unseen(&mut self, key: &KeyEvent) -> Vec<Effect> {
        match self.keys.command_in(Scope::Any, key) {
            Some(Command::Quit) => {
                self.keeps = true;
                vec![Effect::Quit(None)]
            }
            Some(command) => self.command(command),
            None => Vec::new(),
        }
    }

    /// A digit is typed before a command; other keys have no meaning.
    fn count_up(&mut self, key: Key) {
        let digit = match key.code {
            KeyCode::Char(c) if key.is_typed() => c.to_digit(10),
            _ => None,
        };
        match (digit, self.count) {
            (Some(digit @ 1..), None) => self.count = Some(digit),
            (Some(digit), Some(count)) => self.count = Some((count * 10 + digit).min(MOST_TIMES)),
            _ => {
                self.count = None;
                let help = self.keys.key_of(Command::Help);
                self.refuse(format!(
                    "{} has no meaning here: {help} shows every key",
                    key.name()
                ));
            }
        }
    }

    /// Does what a key asks for; what is to be done outside then.
    pub fn command(&mut self, command: Command) -> Vec<Effect> {
        let count = self.count.take();
        match command {
            Command::Redraw => return vec![Effect::Redraw],
            Command::Suspend => return vec![Effect::Suspend],
            Command::Quit => return self.leave(Next::Quit),
            Command::Cancel if count.is_some() => return Vec::new(),
            Command::Tune => self.limit_search(count),
            _ => {
                if let Some(count) = count.filter(|_| !command.counts()) {
                    let name = self.keys.name_of(command);
                    self.refuse(format!(
                        "{name} takes no count: nothing is done {}",
                        counted(count as usize, "time", "times")
                    ));
                    return Vec::new();
                }
            }
        }
        match self.scope() {
            Scope::Table if self.table_commands(command, count.unwrap_or(1)) => Vec::new(),
            Scope::Main | Scope::Any | Scope::Table => self.repeated(command, count.unwrap_or(1)),
            Scope::Prompt => self.prompt_command(command),
            Scope::Palette => self.palette_command(command),
            Scope::Search => self.search_command(command),
            Scope::Picker | Scope::Reader => self.list_command(command),
            Scope::Unsaved | Scope::Replace => self.answer_question(command),
            Scope::Recovery => self.recovery_command(command),
            Scope::Beside => self.beside_command(command),
        }
    }

    pub(super) fn main_command(&mut self, command: Command) -> Vec<Effect> {
        match command {
            Command::Save => return self.save(),
            Command::SaveAs => self.ask_save_path(),
            Command::Open => return self.leave(Next::AskPath),
            Command::Reload => return self.reload(),
            Command::Presets => self.overlay = Some(Overlay::presets(self.preset_row())),
            Command::Help => self.overlay = Some(Overlay::Help(List::default())),
            Command::Guide => self.open_chapters(),
            Command::Palette => self.open_palette(),
            Command::Search => self.start_search(),
            Command::CopyValue => return self.copy_value(),
            Command::CopyModel => return self.copy_model(),
            Command::Mouse => return self.toggle_mouse(),
            Command::Theme => self.next_theme(),
            _ if self.move_selection(command)
                || self.zoom_command(command)
                || self.display_command(command)
                || self.reading_command(command)
                || self.ask_command(command)
                || self.look_command(command)
                || self.tuning_command(command)
                || self.change_chart(command)
                || self.change_modes(command) => {}
            _ => self.change_model(command),
        }
        Vec::new()
    }

    /// Moves in the tree; false where the command is another one.
    fn move_selection(&mut self, command: Command) -> bool {
        let model = Arc::clone(self.document.model());
        let before = self.selection.state();
        let selection = &mut self.selection;
        match command {
            Command::Up => selection.step(-1),
            Command::Down => selection.step(1),
            Command::PageUp => selection.page(false),
            Command::PageDown => selection.page(true),
            Command::First => selection.first(),
            Command::Last => selection.last(),
            Command::Collapse => selection.collapse(&model),
            Command::Expand => selection.expand(&model),
            Command::ExpandAll => selection.expand_all(&model),
            Command::CollapseAll => selection.collapse_all(&model),
            Command::NextAlike => self.go_alike(true),
            Command::PreviousAlike => self.go_alike(false),
            _ => return false,
        }
        if self.selection.state() == before && self.message.is_none() {
            self.refuse(match command {
                Command::Up | Command::PageUp | Command::First => "this is the first row",
                Command::Down | Command::PageDown | Command::Last => "this is the last row",
                Command::Expand => "this row holds no others",
                Command::Collapse => "no group holds this row",
                Command::ExpandAll => "every group is open",
                _ => "every group is closed",
            });
        }
        true
    }

    /// Goes to the parameter so many further, as far as there are any.
    pub(super) fn seek_parameter(&mut self, forward: bool, times: u32) {
        let model = Arc::clone(self.document.model());
        let before = self.selection.state();
        self.selection
            .next_parameter(&model, forward, times as usize);
        if self.selection.state() == before {
            self.refuse(if forward {
                "there is no further parameter"
            } else {
                "there is no parameter before"
            });
        }
    }

    /// Changes the model, or takes a change back.
    fn change_model(&mut self, command: Command) {
        match command {
            Command::Undo => self.travel(true),
            Command::Redo => self.travel(false),
            Command::Edit => self.edit(),
            Command::Cycle => self.cycle_or_toggle(),
            Command::Repeat => self.repeat(),
            Command::Nudge(thousandths) => self.nudge(thousandths, 1),
            Command::Revert => self.revert(),
            Command::Add => self.add(),
            Command::Duplicate => self.duplicate(),
            Command::Rename => self.ask_name(),
            Command::Delete => self.delete(),
            Command::Enable => self.switch(),
            _ => {}
        }
    }

    /// Goes to the same row of the neighbouring subsystem, force, response or support.
    fn go_alike(&mut self, forward: bool) {
        if self.search.is_some() {
            return self.seek_found(forward);
        }
        let model = Arc::clone(self.document.model());
        match tree::alike(&model, self.selection.node(), forward) {
            Some(node) => self.selection.select(&model, node),
            None if forward => self.refuse("there is no further one like this"),
            None => self.refuse("there is none like this before"),
        }
    }

    /// Undoes or redoes a step.
    fn travel(&mut self, back: bool) {
        let before = Arc::clone(self.document.model());
        let step = if back {
            self.document.undo()
        } else {
            self.document.redo()
        };
        match (step, back) {
            (Some(name), true) => self.done(format!("undo: {name}")),
            (Some(name), false) => self.done(format!("redo: {name}")),
            (None, true) => self.refuse("nothing to undo"),
            (None, false) => self.refuse("nothing to redo"),
        }
        self.follow(&before);
    }
}

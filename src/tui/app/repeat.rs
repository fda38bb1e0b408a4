//! Counts before commands, and the repeat of the last change.

use super::{App, Effect, LastChange, Message};
use crate::tui::keys::Command;

impl App {
    /// Runs a command `count` times, until it is refused.
    pub(crate) fn repeated(&mut self, command: Command, times: u32) -> Vec<Effect> {
        let before = self.document.model().clone();
        let mut effects = Vec::new();
        if command.takes_count() {
            effects = self.dispatch(command, times);
        } else if command.counts() {
            for done in 0..times {
                let before = self.message.take();
                effects.extend(self.dispatch(command, 1));
                if self.is_refused() {
                    self.add_to(before, done);
                    break;
                }
            }
            self.add_times(command, times);
        } else {
            effects = self.dispatch(command, 1);
        }
        if command.repeats() && !std::sync::Arc::ptr_eq(&before, self.document.model()) {
            self.repeat.last_change = Some(LastChange::Command(command, times));
        }
        effects
    }

    /// Reports how often the command ran before it was refused.
    fn add_to(&mut self, before: Option<Message>, times: u32) {
        if let (Some(Message::Done(done)), Some(Message::Refused(refusal))) =
            (before, &self.message)
        {
            let last = last_of(done.clone(), times);
            self.message = Some(Message::Refused(format!("{refusal} ({last})")));
        }
    }

    /// Reports how many changes of the model were merged into the last one.
    fn add_times(&mut self, command: Command, times: u32) {
        if let (true, Some(Message::Done(done))) = (command.repeats(), &self.message) {
            self.message = Some(Message::Done(last_of(done.clone(), times)));
        }
    }

    /// Repeats the last change.
    pub(crate) fn repeat(&mut self) {
        match self.repeat.last_change.clone() {
            None => self.refuse("there is no change to repeat yet"),
            Some(LastChange::Command(command, times)) => drop(self.repeated(command, times)),
            Some(LastChange::Typed(text)) => self.type_again(&text),
        }
    }

    /// Sets the selected parameter to the text that was typed for another one.
    fn type_again(&mut self, text: &str) {
        let Some(asked) = self.asked() else {
            return self.refuse(format!(
                "`{text}` was typed; select a number or a text for it"
            ));
        };
        let result = asked
            .kind
            .read(text)
            .and_then(|value| self.give(&asked, value));
        if let Err(refusal) = result {
            self.refuse(refusal);
        }
    }

    /// Whether the last command was refused.
    pub(crate) fn is_refused(&self) -> bool {
        matches!(self.message, Some(Message::Refused(_)))
    }
}

/// How often a repeated command ran.
fn last_of(done: String, times: u32) -> String {
    if times > 1 {
        format!("{done}, the last of {times} times")
    } else {
        done
    }
}

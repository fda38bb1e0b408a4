//! Changes of values: type, nudge, cycle, revert.

use std::sync::Arc;

use super::document::Edit;
use super::{App, Asked, AskedKind, Overlay, Prompt, Purpose};
use crate::model::edit::{self, Value};
use crate::model::schema::Kind;
use crate::model::{Fault, Group, Model, Parameter, ParameterId, path};
use crate::tui::keys::{ModelCommand, TreeCommand};
use crate::tui::tree::{self, Node};

/// Significant digits of a nudged value.
const NUDGE_DIGITS: usize = 6;

impl App {
    /// Enter: types a value, cycles a choice, shows a study, or opens and closes a group.
    pub(crate) fn edit(&mut self) {
        let model = Arc::clone(self.document.model());
        let node = self.selection.node();
        if let Node::Group(Group::Study(i)) = node {
            let study = (self.curves.study != Some(i)).then_some(i);
            return self.show_study(study, &model);
        }
        if let Node::Group(Group::Variable(index)) = node {
            return self.ask_bounds_of(index);
        }
        match parameter(&model, node) {
            Some(Err(fault)) => self.refuse(faults_in_words(&[fault], "", "")),
            Some(Ok(parameter)) if parameter.choices.is_empty() => self.ask(node, parameter),
            Some(Ok(parameter)) => self.cycle(node, &parameter),
            None => self.toggle(),
        }
    }

    /// Space: cycles a choice or a place, or opens and closes a group.
    pub(crate) fn cycle_or_toggle(&mut self) {
        let model = Arc::clone(self.document.model());
        let node = self.selection.node();
        match parameter(&model, node) {
            Some(Ok(parameter)) if !parameter.choices.is_empty() => self.cycle(node, &parameter),
            Some(Ok(parameter)) if matches!(parameter.id.key().kind, Kind::Place | Kind::Over) => {
                let names = edit::names(&model, parameter.id);
                self.cycle_through(node, &parameter, &names);
            }
            Some(Ok(_)) => self.edit(),
            Some(Err(fault)) => self.refuse(faults_in_words(&[fault], "", "")),
            None => self.toggle(),
        }
    }

    fn toggle(&mut self) {
        let model = Arc::clone(self.document.model());
        if tree::children(&model, self.selection.node()).is_empty() {
            self.refuse("this row is changed in the file");
        } else {
            self.selection.toggle(&model);
        }
    }

    fn ask(&mut self, node: Node, parameter: Parameter) {
        let text = exact(&parameter);
        let asked = self.asked_of(node, parameter);
        self.overlay = Some(Overlay::Prompt(Prompt::new(Purpose::Value(asked), text)));
    }

    /// The selected value with all digits, if the row has one.
    pub(crate) fn exact_value(&self) -> Option<String> {
        let parameter = parameter(self.model(), self.selection.node())?.ok()?;
        Some(exact(&parameter))
    }

    /// The prompt for the selected row's value, if it is typed.
    pub(crate) fn asked(&self) -> Option<Asked> {
        let node = self.selection.node();
        let parameter = parameter(self.model(), node)?.ok()?;
        parameter
            .choices
            .is_empty()
            .then(|| self.asked_of(node, parameter))
    }

    fn asked_of(&self, node: Node, parameter: Parameter) -> Asked {
        let kind = match &parameter.value {
            Value::Number(old) => AskedKind::Number(*old, parameter.unit),
            Value::Count(old) => AskedKind::Count(*old),
            _ => AskedKind::Text,
        };
        Asked {
            subject: tree::subject(self.model(), node),
            id: parameter.id,
            range: parameter.range,
            kind,
        }
    }

    /// Sets a parameter to a typed value.
    ///
    /// # Errors
    /// Why it is refused, in one line.
    pub(crate) fn give(&mut self, asked: &Asked, value: Value) -> Result<(), String> {
        self.set(&asked.subject, asked.id, value, false)
            .map_err(|faults| self.in_words(&faults, asked.id, &asked.subject))
    }

    fn cycle(&mut self, node: Node, parameter: &Parameter) {
        let choices: Vec<Value> = parameter
            .choices
            .iter()
            .map(|word| Value::Choice(word))
            .collect();
        self.cycle_through(node, parameter, &choices);
    }

    /// Sets the next of several values that the model allows.
    fn cycle_through(&mut self, node: Node, parameter: &Parameter, values: &[Value]) {
        let subject = tree::subject(self.model(), node);
        let here = values.iter().position(|value| *value == parameter.value);
        let first = here.map_or(0, |here| here + 1);
        let mut refusal = None;
        for step in 0..values.len() {
            let value = values[(first + step) % values.len()].clone();
            if value == parameter.value {
                continue;
            }
            match self.set(&subject, parameter.id, value, false) {
                Ok(()) => return,
                Err(faults) => refusal = refusal.or(Some(faults)),
            }
        }
        match refusal {
            Some(faults) => self.refuse(self.in_words(&faults, parameter.id, &subject)),
            None => self.refuse(format!("{subject} has no other choice")),
        }
    }

    /// Changes a number by thousandths of itself, `count` times.
    pub(crate) fn nudge(&mut self, thousandths: i32, times: u32) {
        let model = Arc::clone(self.document.model());
        let node = self.selection.node();
        let parameter = match parameter(&model, node) {
            Some(Ok(parameter)) => parameter,
            Some(Err(fault)) => return self.refuse(faults_in_words(&[fault], "", "")),
            None => {
                let tab = self.keys.key_of(TreeCommand::NextParameter);
                return self.refuse(format!(
                    "a nudge changes a number: select one, {tab} goes to the next"
                ));
            }
        };
        let subject = tree::subject(&model, node);
        let factor = 1.0 + f64::from(thousandths) / 1000.0;
        let value = match parameter.value {
            Value::Number(0.0) => {
                let enter = self.keys.key_of(ModelCommand::Edit);
                return self.refuse(format!(
                    "{subject} is 0, and so is every percentage of it: {enter} types a value"
                ));
            }
            Value::Number(old) => {
                Value::Number((0..times).fold(old, |value, _| rounded(value * factor)))
            }
            Value::Count(old) => {
                Value::Count((0..times).fold(old, |count, _| nudged_count(count, factor)))
            }
            _ => {
                let enter = self.keys.key_of(ModelCommand::Edit);
                return self.refuse(format!("{subject} is not a number: {enter} changes it"));
            }
        };
        if let Err(faults) = self.set(&subject, parameter.id, value, true) {
            self.refuse(self.in_words(&faults, parameter.id, &subject));
        }
    }

    /// Restores the file's value.
    pub(crate) fn revert(&mut self) {
        let model = Arc::clone(self.document.model());
        let node = self.selection.node();
        let Some(id) = node.parameter() else {
            return self.refuse("select a single value to restore the file's");
        };
        let Some(saved) = self.saved_value(id) else {
            return self.refuse("the file has no value for this");
        };
        let subject = tree::subject(&model, node);
        if !tree::differs(&model, self.document.saved(), node) {
            return self.refuse(format!("{subject} is as in the file"));
        }
        if let Err(faults) = self.set(&subject, id, saved, false) {
            self.refuse(self.in_words(&faults, id, &subject));
        }
    }

    /// The value of a parameter when last opened or saved.
    pub fn saved_value(&self, id: ParameterId) -> Option<Value> {
        let saved = self.document.saved();
        edit::get(saved, id.counterpart(self.model(), saved)?).ok()
    }

    /// Why a value was refused, in one line.
    pub(crate) fn in_words(&self, faults: &[Fault], id: ParameterId, subject: &str) -> String {
        faults_in_words(faults, &path::text(self.model(), id), subject)
    }

    /// Sets a parameter and reports it; tree and chart follow.
    pub(crate) fn set(
        &mut self,
        subject: &str,
        id: ParameterId,
        value: Value,
        nudge: bool,
    ) -> Result<(), Vec<Fault>> {
        let before = Arc::clone(self.document.model());
        let is_number = matches!(value, Value::Number(_) | Value::Count(_));
        let step = self.document.set(&Edit {
            subject,
            id,
            value,
            nudge,
        })?;
        match step {
            Some(name) => self.done(name),
            None => self.done(format!("{subject} is unchanged")),
        }
        if is_number {
            self.follow_number(&before);
        } else {
            self.follow(&before);
        }
        Ok(())
    }
}

fn parameter(model: &Model, node: Node) -> Option<Result<Parameter, Fault>> {
    Some(path::described(model, node.parameter()?))
}

/// A value as text for editing, with all digits.
fn exact(parameter: &Parameter) -> String {
    match &parameter.value {
        Value::Number(value) => parameter.unit.format_exact(*value),
        Value::Count(count) => count.to_string(),
        other => tree::of_parameter(parameter, other),
    }
}

/// A number rounded to the digits of a nudge.
fn rounded(value: f64) -> f64 {
    format!("{value:.*e}", NUDGE_DIGITS - 1)
        .parse()
        .unwrap_or(value)
}

/// A count times a factor, changed by at least one.
fn nudged_count(old: usize, factor: f64) -> usize {
    let new = (old as f64 * factor).round() as usize;
    if factor > 1.0 {
        new.max(old.saturating_add(1))
    } else {
        new.min(old.saturating_sub(1))
    }
}

/// What is wrong, in one line: the first fault, and the number of others. `subject` replaces `path`.
pub(crate) fn faults_in_words(faults: &[Fault], path: &str, subject: &str) -> String {
    // The fault of the parameter itself is more useful than its consequences.
    let own = faults.iter().find(|fault| fault.path == path);
    let Some(first) = own.or(faults.first()) else {
        return "the model would be invalid".to_owned();
    };
    let place = if first.path == path {
        subject
    } else {
        &first.path
    };
    let words = format!("{place} {}", first.message);
    match faults.len() {
        0 | 1 => words,
        more => format!("{words} (and {} more)", more - 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nudge_keeps_six_digits() {
        assert_eq!(rounded(1.666_667e7 * 1.01), 1.683_33e7);
        assert_eq!(rounded(-0.1 * 1.1), -0.11);
    }

    #[test]
    fn a_count_moves_by_one_at_least() {
        assert_eq!(nudged_count(2000, 1.01), 2020);
        assert_eq!(nudged_count(3, 1.001), 4);
        assert_eq!(nudged_count(3, 0.999), 2);
    }
}

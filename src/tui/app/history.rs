//! Undo and redo, without limit.

use std::sync::Arc;

use crate::model::edit::{self, Value};
use crate::model::{Checked, ParameterId};

/// What a step changed.
#[derive(Debug, Clone)]
pub enum Change {
    /// One value: small, and reversible.
    Value {
        /// The parameter.
        id: ParameterId,
        /// Its value before the step.
        before: Value,
        /// Its value after the step.
        after: Value,
    },
    /// Anything else: the model before and after.
    Whole {
        /// The model before the step.
        before: Arc<Checked>,
        /// The model after the step.
        after: Arc<Checked>,
    },
}

impl Change {
    fn id(&self) -> Option<ParameterId> {
        match self {
            Self::Value { id, .. } => Some(*id),
            Self::Whole { .. } => None,
        }
    }

    fn apply(&self, model: &mut Arc<Checked>, forward: bool) {
        match self {
            Self::Value { id, before, after } => {
                let value = if forward { after } else { before };
                // Such a step is only stored if its values can be set in this model.
                *model = Arc::new(model.derived(|model| {
                    let result = edit::put(model, *id, value.clone());
                    debug_assert!(result.is_ok(), "{id:?}: {result:?}");
                }));
            }
            Self::Whole { before, after } => {
                *model = Arc::clone(if forward { after } else { before });
            }
        }
    }
}

/// A named step.
#[derive(Debug, Clone)]
pub struct Step {
    /// Its name: `S1 z_left stiffness 16.7 -> 40 MN/m`.
    pub name: String,
    /// What it changed.
    pub change: Change,
    /// Whether it is a nudge; the next nudge of the same parameter merges with it.
    pub nudge: bool,
}

/// The undo and redo stacks.
#[derive(Debug, Default)]
pub struct History {
    done: Vec<Step>,
    undone: Vec<Step>,
    /// Whether the next nudge starts a separate step.
    sealed: bool,
}

impl History {
    /// Adds a step and clears the redo stack.
    pub fn push(&mut self, step: Step) {
        self.undone.clear();
        self.done.push(step);
        self.sealed = false;
    }

    /// The last step, if a nudge of this parameter can merge with it.
    pub fn open_nudge(&mut self, id: ParameterId) -> Option<&mut Step> {
        if self.sealed || !self.undone.is_empty() {
            return None;
        }
        self.done
            .last_mut()
            .filter(|step| step.nudge && step.change.id() == Some(id))
    }

    /// Removes the last step: its nudges cancel out.
    pub fn drop_last(&mut self) {
        self.done.pop();
    }

    /// Makes the next nudge a separate step.
    pub fn seal(&mut self) {
        self.sealed = true;
    }

    /// Undoes the last step; returns its name, or `None` at the beginning.
    pub fn undo(&mut self, model: &mut Arc<Checked>) -> Option<&str> {
        let step = self.done.pop()?;
        step.change.apply(model, false);
        self.sealed = true;
        self.undone.push(step);
        self.undone.last().map(|step| step.name.as_str())
    }

    /// Redoes an undone step; returns its name, or `None` at the end.
    pub fn redo(&mut self, model: &mut Arc<Checked>) -> Option<&str> {
        let step = self.undone.pop()?;
        step.change.apply(model, true);
        self.sealed = true;
        self.done.push(step);
        self.done.last().map(|step| step.name.as_str())
    }
}

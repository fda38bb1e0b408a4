//! Undo and redo without limit.

use std::sync::Arc;

use crate::model::edit::{self, Value};
use crate::model::{Checked, ParameterId};

/// What a step changed.
#[derive(Debug, Clone)]
pub enum Change {
    /// One value: small, and enough to go both ways.
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
                // Such a step was kept because its values go in and out of this very model.
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
    /// What it did: `S1 z_left stiffness 16.7 -> 40 MN/m`.
    pub name: String,
    /// What it changed.
    pub change: Change,
    /// Whether it was a nudge, to which the next one of the same parameter is added.
    pub nudge: bool,
}

/// The steps taken, and those taken back.
#[derive(Debug, Default)]
pub struct History {
    done: Vec<Step>,
    undone: Vec<Step>,
    /// Set where the next nudge starts a step of its own.
    sealed: bool,
}

impl History {
    /// Adds a step; what was undone is gone.
    pub fn push(&mut self, step: Step) {
        self.undone.clear();
        self.done.push(step);
        self.sealed = false;
    }

    /// The last step, if it is a nudge of this parameter to which another can be added.
    pub fn open_nudge(&mut self, id: ParameterId) -> Option<&mut Step> {
        if self.sealed || !self.undone.is_empty() {
            return None;
        }
        self.done
            .last_mut()
            .filter(|step| step.nudge && step.change.id() == Some(id))
    }

    /// Drops the last step: nudges that added up to nothing.
    pub fn drop_last(&mut self) {
        self.done.pop();
    }

    /// Lets the next nudge start a step of its own.
    pub fn seal(&mut self) {
        self.sealed = true;
    }

    /// Takes the last step back; its name, or `None` at the beginning.
    pub fn undo(&mut self, model: &mut Arc<Checked>) -> Option<&str> {
        let step = self.done.pop()?;
        step.change.apply(model, false);
        self.sealed = true;
        self.undone.push(step);
        self.undone.last().map(|step| step.name.as_str())
    }

    /// Takes an undone step again; its name, or `None` at the end.
    pub fn redo(&mut self, model: &mut Arc<Checked>) -> Option<&str> {
        let step = self.undone.pop()?;
        step.change.apply(model, true);
        self.sealed = true;
        self.done.push(step);
        self.done.last().map(|step| step.name.as_str())
    }
}

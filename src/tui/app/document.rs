//! The edited model, its file, and its undo history.

use std::path::PathBuf;
use std::sync::Arc;

use super::history::{Change, History, Step};
use crate::files::{Opened, Source};
use crate::model::edit::{self, Value};
use crate::model::{self, Checked, Fault, Model, Parameter, ParameterId, path};
use crate::tui::tree;
use crate::tui::user::recovery::Kept;

/// A model with its source, its text as opened or saved, and its history.
#[derive(Debug)]
pub struct Document {
    model: Arc<Checked>,
    saved: Arc<Checked>,
    text: Arc<str>,
    source: Source,
    history: History,
    changed: bool,
    base: Base,
}

/// The base text to which the model is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Base {
    /// The source of the model.
    Own,
    /// A file that was changed after the recovered changes.
    Newer,
    /// No file: the file of the recovered changes does not exist.
    Missing,
}

/// A new value of a parameter.
#[derive(Debug)]
pub struct Edit<'a> {
    /// The parameter as text, for the name of the step.
    pub subject: &'a str,
    /// The parameter.
    pub id: ParameterId,
    /// Its new value.
    pub value: Value,
    /// Whether this is a nudge, which merges with a preceding nudge.
    pub nudge: bool,
}

impl Document {
    /// The document of an opened model. If the model differs from its text (values set on the command line), the
    /// difference is a first step.
    pub fn new(opened: Opened) -> Self {
        Self::differing(opened, "values from the command line")
    }

    /// The document of recovered changes. Without a base it counts as unsaved until it is saved; a newer base is not
    /// replaced without confirmation.
    pub fn recovered(opened: Opened, base: Base) -> Self {
        let mut document = Self::differing(opened, "recovered changes");
        document.base = base;
        document.compare();
        document
    }

    /// The base text to which the model is compared.
    pub fn base(&self) -> Base {
        self.base
    }

    fn differing(opened: Opened, step: &str) -> Self {
        let saved = model::read(&opened.text).unwrap_or_else(|_| opened.model.clone());
        let saved = Arc::new(saved);
        let mut document = Self {
            model: Arc::clone(&saved),
            saved,
            text: opened.text.into(),
            source: opened.source,
            history: History::default(),
            changed: false,
            base: Base::Own,
        };
        if opened.model != *document.saved {
            document.replace(step.to_owned(), opened.model);
        }
        document
    }

    /// The current model.
    pub fn model(&self) -> &Arc<Checked> {
        &self.model
    }

    /// The model as it was opened or saved last.
    pub fn saved(&self) -> &Model {
        &self.saved
    }

    /// The source of the model.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// Whether there are unsaved changes.
    pub fn is_changed(&self) -> bool {
        self.changed
    }

    /// The text as opened or saved last.
    pub fn saved_text(&self) -> &str {
        &self.text
    }

    /// The content of the recovery file, if there are unsaved changes.
    pub fn unsaved(&self) -> Option<Kept> {
        self.changed.then(|| Kept {
            source: self.source.clone(),
            model: Arc::clone(&self.model),
            saved: Arc::clone(&self.saved),
            base: Arc::clone(&self.text),
        })
    }

    /// The model as text, with the comments and the order of the opened text.
    pub fn text(&self) -> String {
        model::write(&self.model, &self.text)
    }

    /// Sets a parameter. Returns the name of the step; `None` if the value is unchanged.
    ///
    /// # Errors
    /// The faults of the resulting model; the model is unchanged then.
    pub fn set(&mut self, new: &Edit<'_>) -> Result<Option<String>, Vec<Fault>> {
        let parameter = path::described(&self.model, new.id).map_err(|fault| vec![fault])?;
        if parameter.value == new.value {
            return Ok(None);
        }
        let after = edit::changed(&self.model, new.id, new.value.clone())?;
        if after == *self.model {
            return Ok(None);
        }
        let after = Arc::new(after);
        let extended = if new.nudge {
            self.extend_nudge(new, &parameter)
        } else {
            None
        };
        let name = extended.unwrap_or_else(|| {
            let name = step_name(new.subject, &parameter, &parameter.value, &new.value);
            let change = self.change(new, parameter.value, &after);
            self.history.push(Step {
                name: name.clone(),
                change,
                nudge: new.nudge,
            });
            name
        });
        self.take(after);
        Ok(Some(name))
    }

    /// Replaces the model, as a step with this name.
    pub fn replace(&mut self, name: String, after: Checked) {
        let after = Arc::new(after);
        self.history.push(Step {
            name,
            change: Change::Whole {
                before: Arc::clone(&self.model),
                after: Arc::clone(&after),
            },
            nudge: false,
        });
        self.take(after);
    }

    /// Undoes the last step; returns its name.
    pub fn undo(&mut self) -> Option<String> {
        let name = self.history.undo(&mut self.model)?.to_owned();
        self.compare();
        Some(name)
    }

    /// Redoes an undone step; returns its name.
    pub fn redo(&mut self) -> Option<String> {
        let name = self.history.redo(&mut self.model)?.to_owned();
        self.compare();
        Some(name)
    }

    /// Makes the next nudge a separate step.
    pub fn seal(&mut self) {
        self.history.seal();
    }

    /// Records that the model was saved as this text in this file.
    pub fn mark_saved(&mut self, path: PathBuf, text: String) {
        self.saved = Arc::clone(&self.model);
        self.text = text.into();
        self.source = Source::File(path);
        self.base = Base::Own;
        self.changed = false;
        self.history.seal();
    }

    /// Loads the text that another program saved in the file, as a step that can be undone.
    pub fn reload(&mut self, model: Checked, text: String) {
        self.saved = Arc::new(model.clone());
        self.text = text.into();
        self.base = Base::Own;
        self.replace("reload the file".to_owned(), model);
    }

    fn take(&mut self, after: Arc<Checked>) {
        self.model = after;
        self.compare();
    }

    fn compare(&mut self) {
        self.changed = self.base == Base::Missing || *self.model != *self.saved;
    }

    /// Merges a nudge with a preceding one of the same parameter; returns the name of the merged step.
    fn extend_nudge(&mut self, new: &Edit<'_>, parameter: &Parameter) -> Option<String> {
        let step = self.history.open_nudge(new.id)?;
        let Change::Value { before, after, .. } = &mut step.change else {
            return None;
        };
        after.clone_from(&new.value);
        let name = step_name(new.subject, parameter, before, &new.value);
        step.name.clone_from(&name);
        if before == after {
            self.history.drop_last();
        }
        Some(name)
    }

    /// The smallest reversible change: one value, if restoring the old value restores the old model.
    fn change(&self, new: &Edit<'_>, before: Value, after: &Arc<Checked>) -> Change {
        let mut back = Model::clone(after);
        let put_back = edit::put(&mut back, new.id, before.clone());
        if put_back.is_ok() && back == **self.model {
            return Change::Value {
                id: new.id,
                before,
                after: new.value.clone(),
            };
        }
        Change::Whole {
            before: Arc::clone(&self.model),
            after: Arc::clone(after),
        }
    }
}

/// `S1 z_left stiffness 16.7 -> 40 MN/m`: the unit appears once if it is the same.
fn step_name(subject: &str, parameter: &Parameter, before: &Value, after: &Value) -> String {
    let (before, after) = (
        tree::of_parameter(parameter, before),
        tree::of_parameter(parameter, after),
    );
    format!(
        "{subject} {} -> {after}",
        tree::without_unit_of(&before, &after)
    )
}

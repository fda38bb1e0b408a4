//! Freezes, loads, lists and drops references.

use std::sync::Arc;

use super::Reference;
use crate::files::Opened;
use crate::model::Checked;
use crate::tui::app::{App, List, Overlay, Picture, Question, Shown};
use crate::tui::keys::{CompareCommand, ComparisonCommand, CurvesCommand};
use crate::worker::Subject;

/// The most references that can be distinguished on the chart.
const MOST_REFERENCES: usize = 8;

impl App {
    /// The model and the visible references, to be solved at the same frequencies.
    pub(crate) fn compared_subjects(&self) -> Vec<Subject> {
        let references = self.comparison.shown().map(|one| Subject {
            generation: one.id,
            model: Arc::clone(&one.model),
            study: one.study,
        });
        std::iter::once(self.subject()).chain(references).collect()
    }

    /// Freezes the curves as a reference.
    pub(crate) fn freeze(&mut self) {
        let picture = match (&self.curves.shown, self.curves.picture()) {
            (Shown::Picture(_), Some(picture)) => Arc::clone(picture),
            _ => return self.refuse("there are no curves to freeze yet"),
        };
        if self.curves.is_stale() {
            return self.refuse("the curves are being solved: freeze them afterwards");
        }
        let model = Arc::clone(self.document.model());
        if let Some(name) = self.add_reference("before", model, self.curves.study, Some(picture)) {
            self.document.seal();
            let key = self.keys.key_of(CurvesCommand::Unfreeze);
            let list = self.keys.key_of(CompareCommand::List);
            self.done(format!(
                "curves frozen as {name}; {key} removes it, {list} lists all"
            ));
        }
    }

    /// Adds a reference; returns its name, or none at the limit.
    pub(crate) fn add_reference(
        &mut self,
        name: &str,
        model: Arc<Checked>,
        study: Option<usize>,
        picture: Option<Arc<Picture>>,
    ) -> Option<String> {
        if self.comparison.references.len() == MOST_REFERENCES {
            let list = self.keys.key_of(CompareCommand::List);
            self.refuse(format!(
                "{MOST_REFERENCES} references are the most: {list} lists them, to remove some"
            ));
            return None;
        }
        let name = self.comparison.free_name(name);
        let id = self.requests.next_serial();
        self.comparison.references.push(Reference {
            id,
            name: name.clone(),
            model,
            study,
            picture,
            shown: true,
            failure: None,
            outdated: false,
        });
        Some(name)
    }

    /// Removes the newest reference.
    pub(crate) fn unfreeze(&mut self) {
        if let Some(dropped) = self.comparison.references.pop() {
            self.done(format!("reference {} removed", dropped.name));
        } else {
            let key = self.keys.key_of(CurvesCommand::Freeze);
            self.refuse(format!("no reference is frozen; {key} freezes one"));
        }
    }

    /// Adds an opened model as a reference.
    pub(crate) fn take_reference(&mut self, opened: Opened) {
        let name = opened.source.name();
        self.overlay = None;
        if let Some(name) = self.add_reference(&name, Arc::new(opened.model), None, None) {
            self.done(format!("{name} is a reference now"));
        }
    }

    /// Opens the list of references and measured curves.
    pub(crate) fn open_comparison(&mut self) {
        let rows = self.comparison.len();
        self.overlay = Some(Overlay::Comparison(List::new(rows, 0)));
    }

    /// Runs a command of the list.
    pub(crate) fn comparison_command(&mut self, command: ComparisonCommand) {
        let Some(Overlay::Comparison(list)) = &self.overlay else {
            return;
        };
        let row = list.row;
        let listed = row < self.comparison.len();
        match command {
            ComparisonCommand::Cancel => self.overlay = None,
            ComparisonCommand::AddReference => {
                self.ask_question(Question::ReferenceFile, String::new());
            }
            ComparisonCommand::AddMeasured => {
                self.ask_question(Question::MeasuredFile, String::new());
            }
            ComparisonCommand::Accept | ComparisonCommand::Rename | ComparisonCommand::Delete
                if !listed =>
            {
                self.refuse("the list is empty");
            }
            ComparisonCommand::Accept => {
                if let Some((_, shown)) = self.comparison.entry(row) {
                    *shown = !*shown;
                }
            }
            ComparisonCommand::Rename => {
                let entry = self.comparison.entry(row);
                let name = entry.map_or_else(String::new, |(name, _)| name.clone());
                self.ask_question(Question::Name(name.clone()), name);
            }
            ComparisonCommand::Delete => self.remove_entry(row),
        }
    }

    fn remove_entry(&mut self, row: usize) {
        match row.checked_sub(self.comparison.references.len()) {
            None => drop(self.comparison.references.remove(row)),
            Some(measured) => drop(self.comparison.measured.remove(measured)),
        }
        let rows = self.comparison.len();
        if let Some(Overlay::Comparison(list)) = &mut self.overlay {
            // The selection stays on its entry if another one is removed.
            list.row -= usize::from(row < list.row);
            list.set_rows(rows);
        }
    }

    /// Removes the reference with an id, if it exists.
    pub(crate) fn drop_reference(&mut self, id: u64) {
        let mut references = self.comparison.references.iter();
        if let Some(row) = references.position(|one| one.id == id) {
            self.remove_entry(row);
        }
    }
}

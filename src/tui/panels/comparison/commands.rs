//! Curves to compare with the model: frozen and loaded references, and measured curves.

use std::sync::Arc;

use crate::files::Opened;
use crate::model::Checked;
use crate::tui::app::request::LastRequest;
use crate::tui::app::{App, List, Overlay, Picture, Question, Shown, Stage};
use crate::tui::keys::{CompareCommand, ComparisonCommand, CurvesCommand};
use crate::tui::panels::measured::commands::{FitKey, Fitted, Measured, Sample, SampleKey};
use crate::worker::{ReferenceAnswer, Request, Subject};

/// The most references that can be distinguished on the chart.
const MOST_REFERENCES: usize = 8;

/// The curves of another state of the model, or of another model.
#[derive(Debug)]
pub struct Reference {
    /// A unique number.
    pub id: u64,
    /// Its name in the legend.
    pub name: String,
    /// The model.
    pub model: Arc<Checked>,
    /// The study that is shown, if any.
    pub study: Option<usize>,
    /// The curves; none until they are solved.
    pub picture: Option<Arc<Picture>>,
    /// Whether they are visible.
    pub shown: bool,
    /// Why solving failed.
    pub failure: Option<String>,
    /// Whether the curves belong to the previous model of this reference.
    outdated: bool,
}

impl Reference {
    /// Replaces the model, with a new id: the old curves stay visible until the new ones are solved.
    pub(crate) fn renew(&mut self, id: u64, model: Arc<Checked>) {
        (self.id, self.model, self.failure, self.outdated) = (id, model, None, true);
    }
}

/// References and measured curves.
#[derive(Debug, Default)]
pub struct Comparison {
    /// Older ones first.
    pub references: Vec<Reference>,
    /// Curves from files.
    pub measured: Vec<Measured>,
    /// The reference in work.
    asked: Option<u64>,
    pub(crate) measured_asked: LastRequest<SampleKey>,
    pub(crate) sample: Option<Sample>,
    /// How well the model fits the measured curves.
    pub fits: Vec<Fitted>,
    pub(crate) fit_key: Option<FitKey>,
}

impl Comparison {
    /// The visible references.
    pub fn shown(&self) -> impl Iterator<Item = &Reference> {
        self.references.iter().filter(|one| one.shown)
    }

    /// The first visible reference with curves: the differences are relative to it.
    pub fn first_shown(&self) -> Option<&Reference> {
        self.shown().find(|one| one.picture.is_some())
    }

    /// The ids of the visible references.
    pub(crate) fn shown_ids(&self) -> Vec<u64> {
        self.shown().map(|one| one.id).collect()
    }

    /// Stores the curves of a reference.
    pub(crate) fn take(&mut self, answer: ReferenceAnswer) {
        self.asked = None;
        let mut references = self.references.iter_mut();
        if let Some(one) = references.find(|one| one.id == answer.serial) {
            match answer.result {
                Ok(curves) => {
                    one.picture = Some(Arc::new(Picture::of_reference(curves)));
                    one.outdated = false;
                }
                Err(reason) => one.failure = Some(reason),
            }
        }
    }

    /// The first unused name of `name`, `name 2`, ...
    pub(crate) fn free_name(&self, name: &str) -> String {
        let taken = |name: &str| {
            self.references.iter().any(|one| one.name == name)
                || self.measured.iter().any(|one| one.name == name)
        };
        let numbered = (2..).map(|number| format!("{name} {number}"));
        let mut names = std::iter::once(name.to_owned()).chain(numbered);
        // The number of used names is finite.
        names
            .find(|name| !taken(name))
            .unwrap_or_else(|| name.to_owned())
    }
}

impl Comparison {
    /// The row of an entry by its unique name.
    pub(crate) fn row_of(&self, name: &str) -> Option<usize> {
        let references = self.references.iter().map(|one| &one.name);
        let measured = self.measured.iter().map(|one| &one.name);
        references.chain(measured).position(|known| known == name)
    }

    /// The name and the visibility of an entry.
    fn entry(&mut self, row: usize) -> Option<(&mut String, &mut bool)> {
        match row.checked_sub(self.references.len()) {
            None => self
                .references
                .get_mut(row)
                .map(|one| (&mut one.name, &mut one.shown)),
            Some(row) => self
                .measured
                .get_mut(row)
                .map(|one| (&mut one.name, &mut one.shown)),
        }
    }
}

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
            return self.refuse("the curves are being solved: freeze them then");
        }
        let model = Arc::clone(self.document.model());
        if let Some(name) = self.add_reference("before", model, self.curves.study, Some(picture)) {
            self.document.seal();
            let key = self.keys.key_of(CurvesCommand::Unfreeze);
            let list = self.keys.key_of(CompareCommand::List);
            self.done(format!(
                "curves frozen as {name}; {key} drops it, {list} lists all"
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
                "{MOST_REFERENCES} references are the most: {list} lists them, to drop some"
            ));
            return None;
        }
        let name = self.comparison.free_name(name);
        let id = self.next_serial();
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
            self.done(format!("reference {} dropped", dropped.name));
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

    /// Requests the curves of a reference that needs them, one at a time.
    pub(crate) fn want_reference(&mut self) -> Option<Request> {
        if self.comparison.asked.is_some() {
            return None;
        }
        let mut references = self.comparison.references.iter();
        // A reference that was frozen before its modes were counted needs the count, too.
        let lacks = |one: &&Reference| {
            let picture = one.picture.as_ref();
            let lacks = picture.is_none_or(|picture| picture.stage < Stage::Counted);
            (lacks || one.outdated) && one.failure.is_none()
        };
        let one = references.find(lacks)?;
        self.comparison.asked = Some(one.id);
        Some(Request::Reference(Subject {
            generation: one.id,
            model: Arc::clone(&one.model),
            study: one.study,
        }))
    }

    /// Opens the list of references and measured curves.
    pub(crate) fn open_comparison(&mut self) {
        let rows = self.comparison_rows();
        self.overlay = Some(Overlay::Comparison(List::new(rows, 0)));
    }

    /// The number of entries: references, then measured curves.
    pub(crate) fn comparison_rows(&self) -> usize {
        self.comparison.references.len() + self.comparison.measured.len()
    }

    /// Runs a command of the list.
    pub(crate) fn comparison_command(&mut self, command: ComparisonCommand) {
        let Some(Overlay::Comparison(list)) = &self.overlay else {
            return;
        };
        let row = list.row;
        let listed = row < self.comparison_rows();
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
                self.refuse("nothing is listed yet");
            }
            ComparisonCommand::Accept => self.toggle_entry(row),
            ComparisonCommand::Rename => {
                let name = self.entry_name(row).cloned().unwrap_or_default();
                self.ask_question(Question::Name(name.clone()), name);
            }
            ComparisonCommand::Delete => self.remove_entry(row),
        }
    }

    /// Shows or hides an entry of the list.
    fn toggle_entry(&mut self, row: usize) {
        let shown = self.comparison.entry(row).map(|(_, shown)| shown);
        if let Some(shown) = shown {
            *shown = !*shown;
        }
    }

    fn entry_name(&mut self, row: usize) -> Option<&String> {
        self.comparison.entry(row).map(|(name, _)| &*name)
    }

    fn remove_entry(&mut self, row: usize) {
        match row.checked_sub(self.comparison.references.len()) {
            None => drop(self.comparison.references.remove(row)),
            Some(measured) => drop(self.comparison.measured.remove(measured)),
        }
        let rows = self.comparison_rows();
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

    /// Renames an entry.
    ///
    /// # Errors
    /// Why the name is refused, in one line.
    pub(crate) fn rename_entry(&mut self, old: &str, name: &str) -> Result<(), String> {
        if name.is_empty() {
            return Err("type a name".to_owned());
        }
        if name != old && self.comparison.free_name(name) != name {
            return Err(format!("{name} is another one's name"));
        }
        let Some(row) = self.comparison.row_of(old) else {
            return Err(format!("{old} is no longer listed"));
        };
        if let Some((known, _)) = self.comparison.entry(row) {
            name.clone_into(known);
        }
        Ok(())
    }
}

//! The models of a request: the model alone, or the members of a study.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::job_thread::Unfinished;
use super::messages::Subject;
use crate::model::{Checked, edit};
use crate::solve::Cancelled;

/// A model to solve, and its label among the members of its study.
pub(super) type Labelled = (Option<String>, Arc<Checked>);

/// The models to solve, with their labels.
pub(super) fn members(subject: &Subject, cancel: &AtomicBool) -> Result<Vec<Labelled>, Unfinished> {
    let studies = &subject.model.studies;
    let Some(study) = subject.study.and_then(|index| studies.get(index)) else {
        return Ok(vec![(None, Arc::clone(&subject.model))]);
    };
    let mut members = Vec::new();
    for (index, label) in edit::family_labels(&study.family).into_iter().enumerate() {
        Cancelled::check(cancel)?;
        let model = edit::apply(&subject.model, &study.family, index).map_err(|faults| {
            let first = faults.first().map(ToString::to_string).unwrap_or_default();
            format!("{}, {label}: {first}", study.name)
        })?;
        members.push((Some(label), Arc::new(model)));
    }
    Ok(members)
}

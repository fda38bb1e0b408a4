//! The models behind a request: the model alone, or the members of a study.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::Subject;
use crate::model::{Model, edit};

/// A model to solve, and what tells it from the others of its study.
pub(super) type Labelled = (Option<String>, Arc<Model>);

/// The models to solve, with their labels; none where cancelled.
pub(super) fn members(
    subject: &Subject,
    cancel: &AtomicBool,
) -> Result<Option<Vec<Labelled>>, String> {
    let studies = &subject.model.studies;
    let Some(study) = subject.study.and_then(|index| studies.get(index)) else {
        return Ok(Some(vec![(None, Arc::clone(&subject.model))]));
    };
    let mut members = Vec::new();
    for (index, label) in edit::family_labels(&study.family).into_iter().enumerate() {
        if cancel.load(Ordering::Relaxed) {
            return Ok(None);
        }
        let model = edit::apply(&subject.model, &study.family, index).map_err(|faults| {
            let first = faults.first().map(ToString::to_string).unwrap_or_default();
            format!("{}, {label}: {first}", study.name)
        })?;
        members.push((Some(label), Arc::new(model)));
    }
    Ok(Some(members))
}

//! Which parameter matters, solved in the background.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::lane::guarded;
use crate::model::Checked;
use crate::solve::Cancelled;
use crate::solve::sensitivity::{Figure, Sensitivity, effects, unavailable};

/// What is to be differentiated of which model.
#[derive(Debug, Clone)]
pub struct SensitivityRequest {
    /// Comes back with the answer.
    pub serial: u64,
    /// A checked model.
    pub model: Arc<Checked>,
    /// What of it.
    pub figure: Figure,
}

/// How a figure moves with each parameter, or why that is not known.
#[derive(Debug, Clone)]
pub struct SensitivityAnswer {
    /// Of the request.
    pub serial: u64,
    /// For each parameter that is not 0, in the order of the model; or one line that says what went wrong.
    pub result: Result<Vec<Sensitivity>, String>,
    /// Why some of them are empty, where some are.
    pub lack: Option<String>,
}

/// How a figure moves with each parameter.
pub(super) fn answer(
    request: &SensitivityRequest,
    cancel: &AtomicBool,
) -> Result<SensitivityAnswer, Cancelled> {
    let result = guarded(|| Ok(effects(&request.model, &request.figure, cancel)?))?;
    let found = result.as_ref().ok();
    Ok(SensitivityAnswer {
        serial: request.serial,
        lack: found.and_then(|found| unavailable(&request.model, &request.figure, found)),
        result,
    })
}

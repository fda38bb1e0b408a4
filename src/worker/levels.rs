//! Levels of several models in a band.

use std::sync::atomic::AtomicBool;

use super::lane::{Unfinished, guarded};
use super::members::{Labelled, members};
use super::{LevelsAnswer, LevelsMember, LevelsRequest};
use crate::solve::Cancelled;
use crate::solve::band::levels;
use crate::solve::modes::{MOST_MODES, modes};

/// The levels of every subject's members.
pub(super) fn answer(
    request: &LevelsRequest,
    cancel: &AtomicBool,
) -> Result<LevelsAnswer, Cancelled> {
    let result = guarded(|| {
        let of_subject = |subject| {
            let members = members(subject, cancel)?.into_iter();
            members
                .map(|member| of_member(member, request.band, cancel))
                .collect()
        };
        request.subjects.iter().map(of_subject).collect()
    })?;
    Ok(LevelsAnswer {
        serial: request.serial,
        result,
    })
}

fn of_member(
    (label, model): Labelled,
    band: [f64; 2],
    cancel: &AtomicBool,
) -> Result<LevelsMember, Unfinished> {
    // A mode above the band has its half-power width in it.
    let modes = modes(&model, band[1].max(model.sweep.to), cancel)?;
    if modes.are_too_many() {
        return Err(format!("there are more than {MOST_MODES} modes").into());
    }
    Ok(LevelsMember {
        levels: levels(&model, &modes, band, cancel)?,
        label,
        model,
    })
}

//! Levels of several models in a band.

use std::sync::atomic::AtomicBool;

use super::lane::{guarded, unless_cancelled};
use super::members::{Labelled, members};
use super::{LevelsAnswer, LevelsMember, LevelsRequest};
use crate::solve::band::levels;
use crate::solve::modes::modes;

/// The levels of every subject's members; none where cancelled.
pub(super) fn answer(request: &LevelsRequest, cancel: &AtomicBool) -> Option<LevelsAnswer> {
    let result = guarded(|| {
        let mut all = Vec::new();
        for subject in &request.subjects {
            let Some(members) = members(subject, cancel)? else {
                return Ok(None);
            };
            let solved = members
                .into_iter()
                .map(|member| of_member(member, request.band, cancel));
            match solved.collect::<Result<Option<Vec<_>>, String>>()? {
                Some(solved) => all.push(solved),
                None => return Ok(None),
            }
        }
        Ok(Some(all))
    })?;
    Some(LevelsAnswer {
        serial: request.serial,
        result,
    })
}

fn of_member(
    (label, model): Labelled,
    band: [f64; 2],
    cancel: &AtomicBool,
) -> Result<Option<LevelsMember>, String> {
    // A mode above the band has its half-power width in it.
    let Some(modes) = modes(&model, band[1].max(model.sweep.to), cancel) else {
        return unless_cancelled(cancel);
    };
    let levels = levels(&model, &modes, band, cancel);
    Ok(levels.map(|levels| LevelsMember {
        label,
        model,
        levels,
    }))
}

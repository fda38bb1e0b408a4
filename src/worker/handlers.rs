//! The requests that one solve answers: shapes, levels, sensitivities and finite-element curves.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::job_thread::{Unfinished, guarded};
use super::members::{Labelled, members};
use super::messages::{
    Difference, LevelsAnswer, LevelsMember, LevelsRequest, OperatingAnswer, OperatingRequest,
    SHAPE_POINTS, SensitivityAnswer, SensitivityRequest, ShapeAnswer, ShapeRequest, Subject,
    WitnessAnswer, WitnessMember,
};
use crate::model::Checked;
use crate::solve::band::levels;
use crate::solve::compare::differences;
use crate::solve::fem::{FiniteElements, default_elements};
use crate::solve::modes::{MOST_MODES, modes, shape};
use crate::solve::operating::operating;
use crate::solve::sensitivity::{effects, unavailable};
use crate::solve::{Cancelled, Frf, frequencies, sweep};

/// The shape of a mode.
pub(super) fn shape_answer(
    request: &ShapeRequest,
    _: &AtomicBool,
) -> Result<ShapeAnswer, Cancelled> {
    let ShapeRequest {
        generation,
        model,
        modes,
        index,
    } = request;
    let result = guarded(|| Ok(shape(model, modes, *index, SHAPE_POINTS)))?;
    Ok(ShapeAnswer {
        generation: *generation,
        index: *index,
        result,
    })
}

/// The operating deflection shape at one frequency.
pub(super) fn operating_answer(
    request: &OperatingRequest,
    _: &AtomicBool,
) -> Result<OperatingAnswer, Cancelled> {
    let solve = || operating(&request.model, request.frequency, SHAPE_POINTS);
    Ok(OperatingAnswer {
        serial: request.serial,
        result: guarded(|| Ok(Arc::new(solve())))?,
    })
}

/// The levels of the members of every subject.
pub(super) fn levels_answer(
    request: &LevelsRequest,
    cancel: &AtomicBool,
) -> Result<LevelsAnswer, Cancelled> {
    let result = guarded(|| {
        let of_subject = |subject| {
            let members = members(subject, cancel)?.into_iter();
            members
                .map(|member| member_levels(member, request.band, cancel))
                .collect()
        };
        request.subjects.iter().map(of_subject).collect()
    })?;
    Ok(LevelsAnswer {
        serial: request.serial,
        result,
    })
}

fn member_levels(
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

/// How a figure changes with each parameter.
pub(super) fn sensitivity_answer(
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

/// The curves of a finite-element model of each member, compared with the exact ones.
pub(super) fn witness_answer(
    subject: &Subject,
    cancel: &AtomicBool,
) -> Result<WitnessAnswer, Cancelled> {
    let result = guarded(|| {
        let members = members(subject, cancel)?.into_iter();
        let solved = members.map(|(_, model)| {
            let frequencies = frequencies(&model.sweep);
            let mesh = FiniteElements::new(&model, default_elements(&model));
            let frf = mesh.sweep(&frequencies, cancel)?;
            let exact = sweep(&model, &frequencies, cancel)?;
            Ok(WitnessMember {
                elements: mesh.elements(),
                differences: largest_differences(&model, &exact, &frf),
                frf,
            })
        });
        solved.collect()
    })?;
    Ok(WitnessAnswer {
        generation: subject.generation,
        result,
    })
}

/// The largest difference of each response, dB.
fn largest_differences(model: &Checked, exact: &Frf, other: &Frf) -> Vec<Option<Difference>> {
    let columns = differences(model, exact, other).into_iter();
    columns
        .map(|column| {
            let places = exact.frequencies.iter().zip(column);
            let all = places.filter_map(|(&frequency, difference)| {
                Some(Difference {
                    decibels: difference?.decibels,
                    frequency,
                })
            });
            all.filter(|difference| difference.decibels.is_finite())
                .max_by(|a, b| a.decibels.total_cmp(&b.decibels))
        })
        .collect()
}

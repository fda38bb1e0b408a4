//! Several models at given frequencies: those of the cursors, of a zoomed band or of a measured curve; and the reference.

use std::sync::atomic::AtomicBool;
use std::sync::mpsc::channel;

use super::curve_cache::CurveCache;
use super::curves;
use super::job_thread::{Unfinished, guarded};
use super::members::members;
use super::messages::{
    Curves, Member, ReferenceAnswer, SampleAnswer, SampleRequest, Stage, Subject,
};
use super::resolve::{Resolver, Unresolved};
use crate::solve::{Cancelled, sweep};

/// The responses of every subject at every frequency.
pub(super) fn answer(
    request: &SampleRequest,
    cancel: &AtomicBool,
) -> Result<SampleAnswer, Cancelled> {
    let of = |subject| of_subject(subject, &request.frequencies, cancel);
    let result = guarded(|| request.subjects.iter().map(of).collect())?;
    Ok(SampleAnswer {
        serial: request.serial,
        sampling: request.sampling,
        frequencies: request.frequencies.clone(),
        result,
    })
}

fn of_subject(
    subject: &Subject,
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Result<Vec<Member>, Unfinished> {
    let members = members(subject, cancel)?.into_iter();
    let solved = members.map(|(label, model)| {
        Ok(Member {
            label,
            frf: sweep(&model, frequencies, cancel)?,
            model,
            peaks: Vec::new(),
            damping_ratios: Vec::new(),
        })
    });
    solved.collect()
}

/// The resolved curves of a reference model.
pub(super) fn reference(
    subject: &Subject,
    cancel: &AtomicBool,
) -> Result<ReferenceAnswer, Cancelled> {
    let serial = subject.generation;
    // The stages before the resolved curves are not shown.
    let result = match curves::answer(subject.clone(), &CurveCache::default(), cancel, &|_| {})? {
        Ok(unresolved) => counted(&unresolved, cancel)?,
        Err(reason) => Err(reason),
    };
    Ok(ReferenceAnswer { serial, result })
}

/// The resolved curves with a verified count of the modes.
fn counted(
    unresolved: &Unresolved,
    cancel: &AtomicBool,
) -> Result<Result<Curves, String>, Cancelled> {
    let (sender, answers) = channel();
    Resolver::default().answer(unresolved, cancel, &|answer| drop(sender.send(answer)));
    let mut answers = answers.try_iter();
    let last = answers.find(|one| one.stage == Stage::Counted || one.result.is_err());
    last.map(|answer| answer.result).ok_or(Cancelled)
}

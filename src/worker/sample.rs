//! Several models at a few frequencies: what is read at the cursor, and what shows of a zoomed band.

use std::sync::atomic::AtomicBool;
use std::sync::mpsc::channel;

use super::lane::{Unfinished, guarded};
use super::members::members;
use super::memory::Memory;
use super::resolve::{Resolver, Unresolved};
use super::{Curves, Member, ReferenceAnswer, SampleAnswer, SampleRequest, Stage, Subject, curves};
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

/// The resolved curves of a model to compare with.
pub(super) fn reference(
    subject: &Subject,
    cancel: &AtomicBool,
) -> Result<ReferenceAnswer, Cancelled> {
    let serial = subject.generation;
    // What comes before the resolved curves does not show.
    let result = match curves::answer(subject.clone(), &Memory::default(), cancel, &|_| {})? {
        Ok(unresolved) => counted(&unresolved, cancel)?,
        Err(reason) => Err(reason),
    };
    Ok(ReferenceAnswer { serial, result })
}

/// The resolved curves by modes that are counted.
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

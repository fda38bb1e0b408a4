//! Several models at a few frequencies: what is read at the cursor, and what shows of a zoomed band.

use std::sync::atomic::AtomicBool;
use std::sync::mpsc::channel;

use super::lane::{guarded, unless_cancelled};
use super::members::members;
use super::memory::Memory;
use super::resolve::{Resolver, Unresolved};
use super::{Curves, Member, ReferenceAnswer, SampleAnswer, SampleRequest, Stage, Subject, curves};
use crate::solve::sweep;

/// The responses of every subject at every frequency; none where cancelled.
pub(super) fn answer(request: &SampleRequest, cancel: &AtomicBool) -> Option<SampleAnswer> {
    let result = guarded(|| {
        let mut all = Vec::new();
        for subject in &request.subjects {
            match of_subject(subject, &request.frequencies, cancel)? {
                Some(solved) => all.push(solved),
                None => return Ok(None),
            }
        }
        Ok(Some(all))
    })?;
    Some(SampleAnswer {
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
) -> Result<Option<Vec<Member>>, String> {
    let Some(members) = members(subject, cancel)? else {
        return Ok(None);
    };
    let solved = members.into_iter().map(|(label, model)| {
        Some(Member {
            label,
            frf: sweep(&model, frequencies, cancel)?,
            model,
            peaks: Vec::new(),
            damping_ratios: Vec::new(),
        })
    });
    Ok(solved.collect())
}

/// The resolved curves of a model to compare with.
pub(super) fn reference(subject: &Subject, cancel: &AtomicBool) -> Option<ReferenceAnswer> {
    let serial = subject.generation;
    let (sender, failures) = channel();
    // What comes before the resolved curves does not show; a failure does.
    let notify = move |answer: super::CurvesAnswer| {
        if let (Stage::Full, Err(reason)) = (answer.stage, answer.result) {
            drop(sender.send(reason));
        }
    };
    let result: Result<Curves, String> =
        match curves::answer(subject.clone(), &Memory::default(), cancel, &notify) {
            Some(unresolved) => match counted(&unresolved, cancel) {
                Some(result) => result,
                None => unless_cancelled(cancel).transpose()?,
            },
            None => Err(failures.try_recv().ok()?),
        };
    Some(ReferenceAnswer { serial, result })
}

/// The resolved curves by modes that are counted. None where cancelled.
fn counted(unresolved: &Unresolved, cancel: &AtomicBool) -> Option<Result<Curves, String>> {
    let (sender, answers) = channel();
    Resolver::default().answer(unresolved, cancel, &|answer| drop(sender.send(answer)));
    let last = answers.try_iter().last()?;
    (last.stage == Stage::Counted || last.result.is_err()).then_some(last.result)
}

//! Resolving curves: the modes, the frequencies that they need, and the peaks.

use std::collections::HashMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use rayon::ThreadPool;
use rayon::prelude::*;

use super::background;
use super::lane::guarded;
use super::members::Labelled;
use super::memory::Memory;
use super::{Curves, CurvesAnswer, Member, ModalModel, Stage, Subject};
use crate::model::Model;
use crate::solve::modes::{Mode, Modes, follow, modes, shares};
use crate::solve::peaks::{peaks, resolved};

/// Curves of the whole sweep, whose peaks may lie between its frequencies.
#[derive(Debug)]
pub(super) struct Unresolved {
    /// What was asked for.
    pub(super) subject: Subject,
    /// Its models.
    pub(super) members: Vec<Labelled>,
    /// A curve for each of them.
    pub(super) curves: Curves,
    /// When the work on them began.
    pub(super) start: Instant,
}

/// Resolves curves, and keeps the modes that it found to follow them while a parameter is turned.
#[derive(Debug, Default)]
pub(super) struct Resolver {
    memory: Memory,
    /// Where the work is done, if not among that of the curves.
    pool: Option<ThreadPool>,
    /// By place: 0 is the model's own, then come the members'.
    known: HashMap<usize, (Arc<Model>, Arc<Modes>)>,
}

impl Resolver {
    /// One that tells where peaks were found.
    pub(super) fn new(memory: Memory) -> Self {
        Self {
            memory,
            pool: background::pool(),
            known: HashMap::new(),
        }
    }

    /// The curves with the points that the modes need, their peaks, and the modes; none where cancelled.
    pub(super) fn answer(
        &mut self,
        unresolved: Unresolved,
        cancel: &AtomicBool,
    ) -> Option<CurvesAnswer> {
        let (generation, start) = (unresolved.subject.generation, unresolved.start);
        let pool = self.pool.take();
        let resolve = || self.resolve(unresolved, cancel);
        let result = guarded(|| {
            Ok(match &pool {
                Some(pool) => pool.install(resolve),
                None => resolve(),
            })
        });
        self.pool = pool;
        let result = result?;
        Some(CurvesAnswer {
            generation,
            stage: Stage::Resolved,
            result,
            elapsed: start.elapsed(),
        })
    }

    fn resolve(&mut self, unresolved: Unresolved, cancel: &AtomicBool) -> Option<Curves> {
        let own_model = &unresolved.subject.model;
        let own = self.modes(0, own_model, cancel)?;
        let curves = unresolved.curves.members.into_iter();
        let mut members = Vec::new();
        for (place, (member, (_, model))) in (1..).zip(curves.zip(&unresolved.members)) {
            let modes = if model == own_model {
                Arc::clone(&own)
            } else {
                self.modes(place, model, cancel)?
            };
            let resolved = resolve_member(model, &modes, member, cancel)?;
            self.memory.learn(place - 1, model, &resolved.frf);
            members.push(resolved);
        }
        let shares = shares(own_model, &own, cancel)?;
        Some(Curves {
            members,
            modes: Some(ModalModel { modes: own, shares }),
        })
    }

    /// The modes of a model, followed from those that had its place before if they can be its own, moved.
    fn modes(
        &mut self,
        place: usize,
        model: &Arc<Model>,
        cancel: &AtomicBool,
    ) -> Option<Arc<Modes>> {
        let before = self.known.get(&place);
        if let Some((known, modes)) = before
            && known == model
        {
            return Some(Arc::clone(modes));
        }
        let found = match before {
            Some((known, before)) if is_alike(known, model) => follow(model, before, cancel),
            _ => modes(model, model.sweep.to, cancel),
        };
        let found = match found {
            Some(found) => Arc::new(found),
            None if cancel.load(Ordering::Relaxed) => return None,
            None => Arc::new(Modes::too_many(model.sweep.to)),
        };
        let entry = (Arc::clone(model), Arc::clone(&found));
        self.known.insert(place, entry);
        Some(found)
    }
}

/// Whether the modes of two models up to the end of their sweeps are as many, but for a few.
fn is_alike(one: &Model, other: &Model) -> bool {
    one.sweep.to == other.sweep.to && one.attached().count() == other.attached().count()
}

fn resolve_member(
    model: &Model,
    modes: &Modes,
    member: Member,
    cancel: &AtomicBool,
) -> Option<Member> {
    let frf = resolved(model, modes, member.frf, cancel)?;
    let peaks = frf
        .columns
        .par_iter()
        .map(|column| peaks(&frf.frequencies, column, modes))
        .collect();
    Some(Member {
        label: member.label,
        model: member.model,
        frf,
        peaks,
        damping_ratios: modes.modes.iter().map(Mode::damping_ratio).collect(),
    })
}

//! Resolving curves: the modes, the frequencies that they need, and the peaks.

use std::collections::HashMap;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use rayon::ThreadPool;
use rayon::prelude::*;

use super::background;
use super::curve_cache::CurveCache;
use super::job_thread::guarded;
use super::members::Labelled;
use super::messages::{Curves, CurvesAnswer, Member, ModalModel, Stage, Subject};
use crate::model::Checked;
use crate::solve::Cancelled;
use crate::solve::modes::{Completeness, Mode, Modes, certify, follow, shares, uncertified};
use crate::solve::peaks::{peaks, resolved};

/// Curves at the frequencies of the sweep, which may miss the peaks between them.
#[derive(Debug)]
pub(super) struct Unresolved {
    /// The request.
    pub(super) subject: Subject,
    /// Its models.
    pub(super) members: Vec<Labelled>,
    /// The curves of each of them.
    pub(super) curves: Curves,
    /// When the request started.
    pub(super) start: Instant,
}

/// Resolves curves, and caches the modes to follow them while a parameter changes.
#[derive(Debug, Default)]
pub(super) struct Resolver {
    cache: CurveCache,
    /// A pool of low priority; none: the common pool.
    pool: Option<ThreadPool>,
    /// The last model and its modes by slot: 0 for the model itself, then one per member.
    known: HashMap<usize, (Arc<Checked>, Arc<Modes>)>,
}

impl Resolver {
    /// A resolver that stores the peaks that it finds in `cache`.
    pub(super) fn new(cache: CurveCache) -> Self {
        Self {
            cache,
            pool: background::pool(),
            known: HashMap::new(),
        }
    }

    /// Sends the curves with the points that their modes need, their peaks and the modes; then the same with a verified count
    /// of the modes, if it was not verified. Sends nothing once cancelled.
    pub(super) fn answer(
        &mut self,
        unresolved: &Unresolved,
        cancel: &AtomicBool,
        send: &dyn Fn(CurvesAnswer),
    ) {
        let Ok(result) = self.in_pool(|resolver| resolver.resolve(unresolved, cancel)) else {
            return;
        };
        let elapsed = unresolved.start.elapsed();
        let answer = |stage, result| CurvesAnswer {
            generation: unresolved.subject.generation,
            stage,
            result,
            elapsed,
        };
        if self.is_counted(unresolved) {
            return send(answer(Stage::Counted, result));
        }
        send(answer(Stage::Resolved, result.clone()));
        let Ok(resolved) = result else { return };
        if let Ok(result) = self.in_pool(|resolver| resolver.count(unresolved, resolved, cancel)) {
            send(answer(Stage::Counted, result));
        }
    }

    /// Runs in the low-priority pool, so that the curves of the next edit are not delayed.
    fn in_pool(
        &mut self,
        work: impl FnOnce(&mut Self) -> Result<Curves, Cancelled> + Send,
    ) -> Result<Result<Curves, String>, Cancelled> {
        let pool = self.pool.take();
        let found = guarded(|| {
            let work = || work(self);
            Ok(match &pool {
                Some(pool) => pool.install(work),
                None => work(),
            }?)
        });
        self.pool = pool;
        found
    }

    fn resolve(
        &mut self,
        unresolved: &Unresolved,
        cancel: &AtomicBool,
    ) -> Result<Curves, Cancelled> {
        let own_model = &unresolved.subject.model;
        let own = self.modes(0, own_model, cancel)?;
        let mut members = Vec::new();
        for (index, (_, model)) in unresolved.members.iter().enumerate() {
            let modes = if model == own_model {
                Arc::clone(&own)
            } else {
                self.modes(index + 1, model, cancel)?
            };
            members.push(self.member(unresolved, index, &modes, cancel)?);
        }
        let shares = shares(own_model, &own, cancel)?;
        Ok(Curves {
            members,
            modes: Some(ModalModel { modes: own, shares }),
        })
    }

    /// Resolved curves with a verified count of the modes; what depends on changed modes is solved again.
    fn count(
        &mut self,
        unresolved: &Unresolved,
        mut resolved: Curves,
        cancel: &AtomicBool,
    ) -> Result<Curves, Cancelled> {
        let own_model = &unresolved.subject.model;
        let own = self.counted(0, own_model, cancel)?;
        for (index, (_, model)) in unresolved.members.iter().enumerate() {
            let counted = if model == own_model {
                own.clone()
            } else {
                self.counted(index + 1, model, cancel)?
            };
            if counted.changed {
                resolved.members[index] = self.member(unresolved, index, &counted.modes, cancel)?;
            }
        }
        let known = resolved.modes.filter(|_| !own.changed);
        let shares = match known {
            Some(known) => known.shares,
            None => shares(own_model, &own.modes, cancel)?,
        };
        resolved.modes = Some(ModalModel {
            modes: own.modes,
            shares,
        });
        Ok(resolved)
    }

    /// Resolves the curves of a member and stores its peaks.
    fn member(
        &self,
        unresolved: &Unresolved,
        index: usize,
        modes: &Modes,
        cancel: &AtomicBool,
    ) -> Result<Member, Cancelled> {
        let (_, model) = &unresolved.members[index];
        let member = unresolved.curves.members[index].clone();
        let resolved = resolve_member(model, modes, member, cancel)?;
        self.cache.store_peaks(index, model, &resolved.frf);
        Ok(resolved)
    }

    /// The modes of a model, followed from the previous ones of its slot if those are as many.
    fn modes(
        &mut self,
        place: usize,
        model: &Arc<Checked>,
        cancel: &AtomicBool,
    ) -> Result<Arc<Modes>, Cancelled> {
        let before = self.known.get(&place);
        if let Some((known, modes)) = before
            && known == model
        {
            return Ok(Arc::clone(modes));
        }
        let found = Arc::new(match before {
            Some((known, before)) if is_alike(known, model) => follow(model, before, cancel)?,
            _ => uncertified(model, model.sweep.to, cancel)?,
        });
        let entry = (Arc::clone(model), Arc::clone(&found));
        self.known.insert(place, entry);
        Ok(found)
    }

    /// The modes of a model with a verified count.
    fn counted(
        &mut self,
        place: usize,
        model: &Arc<Checked>,
        cancel: &AtomicBool,
    ) -> Result<Counted, Cancelled> {
        let before = self.modes(place, model, cancel)?;
        let modes = Arc::new(certify(model, &before, cancel)?);
        let changed = !modes.has_modes_of(&before);
        let entry = (Arc::clone(model), Arc::clone(&modes));
        self.known.insert(place, entry);
        Ok(Counted { modes, changed })
    }

    /// Whether the count of the modes of every model is verified.
    fn is_counted(&self, unresolved: &Unresolved) -> bool {
        let models = unresolved.members.iter().map(|(_, model)| model);
        let all = std::iter::once(&unresolved.subject.model).chain(models);
        let waits = |(place, model): (usize, &Arc<Checked>)| {
            self.known.get(&place).is_some_and(|(known, modes)| {
                known == model && modes.completeness == Completeness::Uncounted
            })
        };
        !all.enumerate().any(waits)
    }
}

/// Modes with a verified count.
#[derive(Debug, Clone)]
struct Counted {
    modes: Arc<Modes>,
    /// Whether the count changed them.
    changed: bool,
}

/// Whether two models have about as many modes up to the end of their sweeps.
fn is_alike(one: &Checked, other: &Checked) -> bool {
    one.sweep.to == other.sweep.to && one.attached().count() == other.attached().count()
}

fn resolve_member(
    model: &Checked,
    modes: &Modes,
    member: Member,
    cancel: &AtomicBool,
) -> Result<Member, Cancelled> {
    let frf = resolved(model, modes, member.frf, cancel)?;
    let peaks = frf
        .columns
        .par_iter()
        .map(|column| peaks(&frf.frequencies, column, modes))
        .collect();
    Ok(Member {
        label: member.label,
        model: member.model,
        frf,
        peaks,
        damping_ratios: modes.modes.iter().map(Mode::damping_ratio).collect(),
    })
}

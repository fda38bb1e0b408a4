//! What the solving of curves remembers from one edit to the next.

use std::collections::HashMap;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::ExpectRequest;
use super::curves::timed;
use super::members::Labelled;
use crate::model::{Model, Sweep};
use crate::solve::{Frf, Kept, frequencies, sweep};

/// Shared by the threads that solve curves, those that resolve them and those that prepare for an edit.
#[derive(Debug, Clone, Default)]
pub(super) struct Memory(Arc<Mutex<Known>>);

#[derive(Debug, Default)]
struct Known {
    /// By place: of each member of a study, or of the model itself.
    members: HashMap<usize, Member>,
    /// What a frequency took that was solved afresh, by the model's [`weight`]; s.
    pace: Option<f64>,
}

#[derive(Debug, Default)]
struct Member {
    /// What lies beside the edits, for the frequencies of the sweep and for those that peaks needed.
    kept: [Kept; 2],
    peaks: Option<Peaks>,
    /// Solved last, at all frequencies of its sweep.
    last: Option<Arc<Model>>,
}

/// The frequencies between those of the sweep at which the last resolved curves have a peak or an anti-resonance.
#[derive(Debug)]
struct Peaks {
    sweep: Sweep,
    /// Hz, rising.
    between: Vec<f64>,
}

impl Memory {
    /// The curves of a member at the frequencies of its sweep, and between them at those where the peaks were before the
    /// edit: they move little. None where cancelled.
    pub(super) fn sweep(
        &self,
        place: usize,
        model: &Arc<Model>,
        cancel: &AtomicBool,
    ) -> Option<(Frf, Option<Frf>)> {
        let all = frequencies(&model.sweep);
        let is_known = self.knows(place, model);
        let (base, took) = timed(|| self.solved(place, 0, model, &all, cancel));
        let base = base?;
        if !is_known {
            self.time(took / (all.len() as f64 * weight(model)));
        }
        let mut known = self.known();
        let member = known.members.entry(place).or_default();
        member.last = Some(Arc::clone(model));
        let Some(between) = member.between(model).map(<[f64]>::to_vec) else {
            return Some((base, None));
        };
        drop(known);
        let near = self.solved(place, 1, model, &between, cancel)?;
        let both = base.merged(&near);
        Some((base, Some(both)))
    }

    /// The curves of a member from what is kept of it, or afresh, which nobody waits for; none where cancelled.
    fn solved(
        &self,
        place: usize,
        which: usize,
        model: &Model,
        frequencies: &[f64],
        cancel: &AtomicBool,
    ) -> Option<Frf> {
        if let Some(member) = self.known().members.get_mut(&place)
            && member.kept[which].knows(model, frequencies)
        {
            return member.kept[which].sweep(model, frequencies, cancel);
        }
        sweep(model, frequencies, cancel)
    }

    /// Takes note of what a frequency took for a [`weight`] of 1, s; it may have been disturbed.
    fn time(&self, new: f64) {
        let pace = &mut self.known().pace;
        *pace = Some(pace.map_or(new, |old| 0.5 * (old + new)));
    }

    /// Where the peaks and anti-resonances of a member were before the edit, between the frequencies of its sweep; Hz.
    pub(super) fn between(&self, place: usize, model: &Model) -> Vec<f64> {
        let known = self.known();
        let member = known.members.get(&place);
        let between = member.and_then(|member| member.between(model));
        between.unwrap_or_default().to_vec()
    }

    /// How long a frequency of a model takes, s; none where nothing was timed yet.
    pub(super) fn pace(&self, model: &Model) -> Option<f64> {
        Some(self.known().pace? * weight(model))
    }

    /// Whether the curves of a member come at once, however many subsystems it has.
    pub(super) fn knows(&self, place: usize, model: &Model) -> bool {
        let known = self.known();
        let member = known.members.get(&place);
        member.is_some_and(|member| member.kept[0].knows(model, &frequencies(&model.sweep)))
    }

    /// The model of a member that was solved last.
    pub(super) fn last(&self, place: usize) -> Option<Arc<Model>> {
        self.known().members.get(&place)?.last.clone()
    }

    /// The edit that led from one model to the first of those that were solved now, where nothing was kept for it: another
    /// in the same place may follow.
    pub(super) fn missing(
        &self,
        before: Option<Arc<Model>>,
        solved: &[Labelled],
    ) -> Option<ExpectRequest> {
        let (_, edited) = solved.first()?;
        let model = before.filter(|_| !self.knows(0, edited))?;
        Some(ExpectRequest {
            model,
            edited: Arc::clone(edited),
        })
    }

    /// Remembers where the peaks and anti-resonances of a member are that fall between the frequencies of its sweep.
    pub(super) fn learn(&self, place: usize, model: &Model, resolved: &Frf) {
        let base = frequencies(&model.sweep);
        let is_new = |f: f64| base.binary_search_by(|known| known.total_cmp(&f)).is_err();
        let rows = resolved.frequencies.iter().enumerate();
        let between: Vec<f64> = rows
            .filter(|&(row, &f)| is_new(f) && is_extreme(resolved, row))
            .map(|(_, &f)| f)
            .collect();
        self.known().members.entry(place).or_default().peaks = Some(Peaks {
            sweep: model.sweep,
            between,
        });
    }

    /// Prepares for an edit of the first member, which makes it `edited`.
    ///
    /// Curves can be solved meanwhile: they do not wait for it.
    pub(super) fn expect(&self, model: &Model, edited: &Model, cancel: &AtomicBool) {
        let all = [frequencies(&model.sweep), self.between(0, model)];
        for (which, frequencies) in all.iter().enumerate() {
            let mut kept = Kept::default();
            if !kept.expect(model, edited, frequencies, cancel) {
                return;
            }
            let mut known = self.known();
            let member = known.members.entry(0).or_default();
            let is_new = !member.kept[which].knows(edited, frequencies);
            if is_new && kept.knows(edited, frequencies) {
                member.kept[which] = kept;
            }
        }
    }

    fn known(&self) -> MutexGuard<'_, Known> {
        // A panic inside a solve leaves what was kept before it.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Member {
    fn between(&self, model: &Model) -> Option<&[f64]> {
        let peaks = self.peaks.as_ref();
        let peaks = peaks.filter(|peaks| peaks.sweep == model.sweep)?;
        Some(&peaks.between)
    }
}

/// What a frequency of a model costs, in subsystems: the beam itself as much as a few.
pub(super) fn weight(model: &Model) -> f64 {
    const BEAM: usize = 6;
    (model.attached().count() + BEAM) as f64
}

/// Whether some response is larger in a row than in both rows beside it, or smaller.
fn is_extreme(frf: &Frf, row: usize) -> bool {
    frf.columns.iter().any(|column| {
        let around = row
            .checked_sub(1)
            .and_then(|first| column.values.get(first..first + 3));
        around.is_some_and(|values| {
            let [before, here, after] = [0, 1, 2].map(|index| values[index].norm_sqr());
            (here > before && here > after) || (here < before && here < after)
        })
    })
}

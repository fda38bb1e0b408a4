//! What the solving of curves remembers from one edit to the next.

use std::collections::HashMap;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::ExpectRequest;
use super::curves::{spread, timed};
use super::members::Labelled;
use crate::model::{Checked, Sweep};
use crate::solve::{Cancelled, Frf, SweepCache, frequencies, sweep};

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
    /// What lies beside the edits, for the frequencies of the sweep.
    kept: SweepCache,
    few: Option<Few>,
    peaks: Option<Peaks>,
    /// Solved last, at all frequencies of its sweep.
    last: Option<Arc<Checked>>,
    /// The edit that is prepared for just now.
    pending: Option<ExpectRequest>,
}

/// The same for the frequencies of a coarse curve: some of the sweep's, and those of the peaks known then.
#[derive(Debug)]
struct Few {
    sweep: Sweep,
    /// Hz, rising.
    frequencies: Vec<f64>,
    kept: SweepCache,
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
    /// edit: they move little.
    pub(super) fn sweep(
        &self,
        place: usize,
        model: &Arc<Checked>,
        cancel: &AtomicBool,
    ) -> Result<(Frf, Option<Frf>), Cancelled> {
        let all = frequencies(&model.sweep);
        let recalled = self.of(place, |member| member.kept.recalled(model, &all, cancel))?;
        let base = if let Some(base) = recalled {
            base
        } else {
            let (base, took) = timed(|| sweep(model, &all, cancel));
            let base = base?;
            self.time(took / (all.len() as f64 * weight(model)));
            base
        };
        self.of(place, |member| member.last = Some(Arc::clone(model)));
        let near = match self.few(place, model, cancel)? {
            Some(few) => few,
            None => match self.between(place, model) {
                between if between.is_empty() => return Ok((base, None)),
                between => sweep(model, &between, cancel)?,
            },
        };
        let both = base.merged(&near);
        Ok((base, Some(both)))
    }

    /// A coarse curve of a member with the peaks of before, from what is kept; none where that does not serve.
    pub(super) fn few(
        &self,
        place: usize,
        model: &Checked,
        cancel: &AtomicBool,
    ) -> Result<Option<Frf>, Cancelled> {
        self.of(place, |Member { few, .. }| match few {
            Some(few) if few.sweep == model.sweep => {
                few.kept.recalled(model, &few.frequencies, cancel)
            }
            _ => Ok(None),
        })
    }

    /// Takes note of what a frequency took for a [`weight`] of 1, s; it may have been disturbed.
    fn time(&self, new: f64) {
        let pace = &mut self.known().pace;
        *pace = Some(pace.map_or(new, |old| 0.5 * (old + new)));
    }

    /// Where the peaks and anti-resonances of a member were before the edit, between the frequencies of its sweep; Hz.
    pub(super) fn between(&self, place: usize, model: &Checked) -> Vec<f64> {
        let between = |peaks: &Peaks| (peaks.sweep == model.sweep).then(|| peaks.between.clone());
        self.of(place, |member| member.peaks.as_ref().and_then(between))
            .unwrap_or_default()
    }

    /// How long a frequency of a model takes, s; none where nothing was timed yet.
    pub(super) fn pace(&self, model: &Checked) -> Option<f64> {
        Some(self.known().pace? * weight(model))
    }

    /// Whether the curves of a member come at once, however many subsystems it has.
    pub(super) fn knows(&self, place: usize, model: &Checked) -> bool {
        let all = frequencies(&model.sweep);
        self.of(place, |member| member.kept.knows(model, &all))
    }

    /// The model of a member that was solved last.
    pub(super) fn last(&self, place: usize) -> Option<Arc<Checked>> {
        self.of(place, |member| member.last.clone())
    }

    /// The edit that led from one model to the first of those that were solved now, where nothing is kept for it, or
    /// other peaks are known by now: another in the same place may follow.
    pub(super) fn missing(
        &self,
        before: Option<Arc<Checked>>,
        solved: &[Labelled],
    ) -> Option<ExpectRequest> {
        let (_, edited) = solved.first()?;
        let pending = self.of(0, |member| member.pending.clone());
        let comes = |ExpectRequest { model, edited: one }: ExpectRequest| {
            SweepCache::would_serve(&model, &one, edited)
        };
        if pending.is_some_and(comes) {
            return None;
        }
        let is_there = self.knows(0, edited) && self.knows_few(edited, &self.few_of(edited));
        Some(ExpectRequest {
            model: before.filter(|_| !is_there)?,
            edited: Arc::clone(edited),
        })
    }

    /// Whether a coarse curve of the first member at these frequencies (Hz) comes at once.
    fn knows_few(&self, model: &Checked, frequencies: &[f64]) -> bool {
        self.of(0, |member| {
            let mut few = member.few.iter();
            few.any(|few| few.frequencies == frequencies && few.kept.knows(model, frequencies))
        })
    }

    /// The frequencies (Hz) of a coarse curve of the first member that is kept.
    fn few_of(&self, model: &Checked) -> Vec<f64> {
        /// More than a terminal has columns, and soon solved.
        const POINTS: usize = 200;
        spread(model, &self.between(0, model), POINTS)
    }

    /// Remembers where the peaks and anti-resonances of a member are that fall between the frequencies of its sweep.
    pub(super) fn learn(&self, place: usize, model: &Checked, resolved: &Frf) {
        let base = frequencies(&model.sweep);
        let is_new = |f: f64| base.binary_search_by(|known| known.total_cmp(&f)).is_err();
        let rows = resolved.frequencies.iter().enumerate();
        let between: Vec<f64> = rows
            .filter(|&(row, &f)| is_new(f) && is_extreme(resolved, row))
            .map(|(_, &f)| f)
            .collect();
        let peaks = Peaks {
            sweep: model.sweep,
            between,
        };
        self.of(place, |member| member.peaks = Some(peaks));
    }

    /// Prepares for an edit of the first member.
    ///
    /// Curves can be solved meanwhile: they do not wait for it.
    pub(super) fn expect(
        &self,
        edit: &ExpectRequest,
        cancel: &AtomicBool,
    ) -> Result<(), Cancelled> {
        self.of(0, |member| member.pending = Some(edit.clone()));
        let prepared = self.prepare(&edit.model, &edit.edited, cancel);
        self.of(0, |member| member.pending = None);
        prepared
    }

    fn prepare(
        &self,
        model: &Checked,
        edited: &Checked,
        cancel: &AtomicBool,
    ) -> Result<(), Cancelled> {
        let found = |frequencies: &[f64]| {
            let mut kept = SweepCache::default();
            kept.expect(model, edited, frequencies, cancel)?;
            Ok(kept.knows(edited, frequencies).then_some(kept))
        };
        if !self.knows(0, edited) {
            let Some(kept) = found(&frequencies(&model.sweep))? else {
                return Ok(());
            };
            self.of(0, |member| member.kept = kept);
        }
        let frequencies = self.few_of(model);
        if self.knows_few(edited, &frequencies) {
            return Ok(());
        }
        if let Some(kept) = found(&frequencies)? {
            let few = Few {
                sweep: model.sweep,
                frequencies,
                kept,
            };
            self.of(0, |member| member.few = Some(few));
        }
        Ok(())
    }

    /// What is known of a member is read or changed.
    fn of<T>(&self, place: usize, act: impl FnOnce(&mut Member) -> T) -> T {
        act(self.known().members.entry(place).or_default())
    }

    fn known(&self) -> MutexGuard<'_, Known> {
        // A panic inside a solve leaves what was kept before it.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// What a frequency of a model costs, in subsystems: the beam itself as much as a few.
pub(super) fn weight(model: &Checked) -> f64 {
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

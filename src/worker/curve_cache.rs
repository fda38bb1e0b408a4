//! The cache of intermediate results that makes curves fast from one edit to the next.

use std::collections::HashMap;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use super::members::Labelled;
use super::messages::ExpectRequest;
use crate::model::{Checked, Sweep};
use crate::solve::{Cancelled, Frf, SweepCache, frequencies, sweep};

/// Shared by the threads that solve curves, resolve them and prepare for an edit.
#[derive(Debug, Clone, Default)]
pub(super) struct CurveCache(Arc<Mutex<Contents>>);

#[derive(Debug, Default)]
struct Contents {
    /// By the index of a member of the study; 0 for the model alone.
    members: HashMap<usize, CachedMember>,
    /// Time of a frequency without the cache, divided by the model's [`weight`]; s.
    unit_time: Option<f64>,
}

#[derive(Debug, Default)]
struct CachedMember {
    /// What the next edit does not change, at the frequencies of the sweep.
    kept: SweepCache,
    few: Option<Few>,
    peaks: Option<Peaks>,
    /// The last model solved at all frequencies of its sweep.
    last: Option<Arc<Checked>>,
    /// The edit whose preparation is running.
    pending: Option<ExpectRequest>,
}

/// What the next edit does not change, at the frequencies of a coarse curve: some of the sweep, and the known peaks.
#[derive(Debug)]
struct Few {
    sweep: Sweep,
    /// Hz, ascending.
    frequencies: Vec<f64>,
    kept: SweepCache,
}

/// The peaks and anti-resonances of the last resolved curves that lie between the frequencies of the sweep.
#[derive(Debug)]
struct Peaks {
    sweep: Sweep,
    /// Hz, ascending.
    between: Vec<f64>,
}

impl CurveCache {
    /// The curves of a member at the frequencies of its sweep, and the same with the peaks of before the edit, which move
    /// little.
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
            self.add_time(took / (all.len() as f64 * weight(model)));
            base
        };
        self.of(place, |member| member.last = Some(Arc::clone(model)));
        let near = match self.few(place, model, cancel)? {
            Some(few) => few,
            None => match self.peaks_between(place, model) {
                between if between.is_empty() => return Ok((base, None)),
                between => sweep(model, &between, cancel)?,
            },
        };
        let both = base.merged(&near);
        Ok((base, Some(both)))
    }

    /// A coarse curve of a member from the cache, with the previous peaks; none if the cache does not hold it.
    pub(super) fn few(
        &self,
        place: usize,
        model: &Checked,
        cancel: &AtomicBool,
    ) -> Result<Option<Frf>, Cancelled> {
        self.of(place, |CachedMember { few, .. }| match few {
            Some(few) if few.sweep == model.sweep => {
                few.kept.recalled(model, &few.frequencies, cancel)
            }
            _ => Ok(None),
        })
    }

    /// Adds a measured time per frequency for a [`weight`] of 1, s, to the average: one measurement may be disturbed.
    fn add_time(&self, new: f64) {
        let average = &mut self.contents().unit_time;
        *average = Some(average.map_or(new, |old| 0.5 * (old + new)));
    }

    /// The previous peaks and anti-resonances of a member between the frequencies of its sweep, Hz.
    pub(super) fn peaks_between(&self, place: usize, model: &Checked) -> Vec<f64> {
        let between = |peaks: &Peaks| (peaks.sweep == model.sweep).then(|| peaks.between.clone());
        self.of(place, |member| member.peaks.as_ref().and_then(between))
            .unwrap_or_default()
    }

    /// The time per frequency of a model, s; none before the first measurement.
    pub(super) fn seconds_per_frequency(&self, model: &Checked) -> Option<f64> {
        Some(self.contents().unit_time? * weight(model))
    }

    /// Whether the cache holds the curves of a member.
    pub(super) fn has_curves(&self, place: usize, model: &Checked) -> bool {
        let all = frequencies(&model.sweep);
        self.of(place, |member| member.kept.knows(model, &all))
    }

    /// The last solved model of a member.
    pub(super) fn last(&self, place: usize) -> Option<Arc<Checked>> {
        self.of(place, |member| member.last.clone())
    }

    /// The edit to prepare for: the one from `before` to the first solved model, because more edits of the same parameter
    /// may follow. None if the cache already serves it, with the current peaks, or its preparation is running.
    pub(super) fn edit_to_prepare(
        &self,
        before: Option<Arc<Checked>>,
        solved: &[Labelled],
    ) -> Option<ExpectRequest> {
        let (_, edited) = solved.first()?;
        let pending = self.of(0, |member| member.pending.clone());
        let serves = |ExpectRequest { model, edited: one }: ExpectRequest| {
            SweepCache::would_serve(&model, &one, edited)
        };
        if pending.is_some_and(serves) {
            return None;
        }
        let is_cached =
            self.has_curves(0, edited) && self.has_few(edited, &self.few_frequencies(edited));
        Some(ExpectRequest {
            model: before.filter(|_| !is_cached)?,
            edited: Arc::clone(edited),
        })
    }

    /// Whether the cache holds a coarse curve of the first member at these frequencies (Hz).
    fn has_few(&self, model: &Checked, frequencies: &[f64]) -> bool {
        self.of(0, |member| {
            let mut few = member.few.iter();
            few.any(|few| few.frequencies == frequencies && few.kept.knows(model, frequencies))
        })
    }

    /// The frequencies (Hz) of the coarse curve of the first member to cache.
    fn few_frequencies(&self, model: &Checked) -> Vec<f64> {
        /// More than a terminal has columns, and fast to solve.
        const POINTS: usize = 200;
        spread(model, &self.peaks_between(0, model), POINTS)
    }

    /// Stores the peaks and anti-resonances of a member that lie between the frequencies of its sweep.
    pub(super) fn store_peaks(&self, place: usize, model: &Checked, resolved: &Frf) {
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
    /// Curves do not wait for it.
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
        if !self.has_curves(0, edited) {
            let Some(kept) = found(&frequencies(&model.sweep))? else {
                return Ok(());
            };
            self.of(0, |member| member.kept = kept);
        }
        let frequencies = self.few_frequencies(model);
        if self.has_few(edited, &frequencies) {
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

    /// Reads or changes the entry of a member.
    fn of<T>(&self, place: usize, act: impl FnOnce(&mut CachedMember) -> T) -> T {
        act(self.contents().members.entry(place).or_default())
    }

    fn contents(&self) -> MutexGuard<'_, Contents> {
        // A panic inside a solve leaves the earlier contents valid.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// About `points` frequencies of a model's sweep and at most as many of `others` (Hz, ascending), without duplicates.
pub(super) fn spread(model: &Checked, others: &[f64], points: usize) -> Vec<f64> {
    let all = frequencies(&model.sweep);
    let evenly = |list: &[f64]| -> Vec<f64> {
        let stride = list.len().div_ceil(points).max(1);
        list.iter().step_by(stride).copied().collect()
    };
    let mut some = [evenly(&all), evenly(others), vec![model.sweep.to]].concat();
    some.sort_by(f64::total_cmp);
    some.dedup();
    some
}

/// The result of a solve and its time, s.
pub(super) fn timed<T>(solve: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let solved = solve();
    (solved, start.elapsed().as_secs_f64())
}

/// The relative cost of a frequency of a model, in subsystems; the beam costs as much as a few.
fn weight(model: &Checked) -> f64 {
    const BEAM: usize = 6;
    (model.attached().count() + BEAM) as f64
}

/// Whether some response has a local maximum or minimum in a row.
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

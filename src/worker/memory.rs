//! What the solving of curves remembers from one edit to the next.

use std::collections::HashMap;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::model::{Model, Sweep};
use crate::solve::{Frf, Kept, frequencies};

/// Shared by the threads that solve curves, those that resolve them and those that prepare for an edit.
#[derive(Debug, Clone, Default)]
pub(super) struct Memory(Arc<Mutex<HashMap<usize, Member>>>);

/// Of one member of a study, or of the model itself.
#[derive(Debug, Default)]
struct Member {
    /// What lies beside the edits, for the frequencies of the sweep and for those that peaks needed.
    kept: [Kept; 2],
    peaks: Option<Peaks>,
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
        model: &Model,
        cancel: &AtomicBool,
    ) -> Option<(Frf, Option<Frf>)> {
        let mut members = self.members();
        let Member { kept, peaks } = members.entry(place).or_default();
        let [of_sweep, of_peaks] = kept;
        let base = of_sweep.sweep(model, &frequencies(&model.sweep), cancel)?;
        let between = peaks.as_ref().filter(|peaks| peaks.sweep == model.sweep);
        let Some(Peaks { between, .. }) = between else {
            return Some((base, None));
        };
        let near = of_peaks.sweep(model, between, cancel)?;
        let both = base.merged(&near);
        Some((base, Some(both)))
    }

    /// Whether the curves of a member come at once, however long its sweep takes.
    pub(super) fn knows(&self, place: usize, model: &Model) -> bool {
        let members = self.members();
        let known = members.get(&place);
        known.is_some_and(|member| member.kept[0].knows(model, &frequencies(&model.sweep)))
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
        self.members().entry(place).or_default().peaks = Some(Peaks {
            sweep: model.sweep,
            between,
        });
    }

    /// Prepares for an edit of the first member, which makes it `edited`.
    pub(super) fn expect(&self, model: &Model, edited: &Model, cancel: &AtomicBool) {
        let mut members = self.members();
        let Member { kept, peaks } = members.entry(0).or_default();
        let [of_sweep, of_peaks] = kept;
        let goes_on = of_sweep.expect(model, edited, &frequencies(&model.sweep), cancel);
        if let Some(peaks) = peaks
            && goes_on
        {
            of_peaks.expect(model, edited, &peaks.between, cancel);
        }
    }

    fn members(&self) -> MutexGuard<'_, HashMap<usize, Member>> {
        // A panic inside a solve leaves what was kept before it.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
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

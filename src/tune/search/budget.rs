//! The evaluations of a search: on all cores, with its budget and its best point.

use std::sync::atomic::Ordering::Relaxed;

use rayon::prelude::*;

use super::types::{Control, Evaluation, Landscape, Merit, Phase, Progress, Stop};
use crate::solve::Cancelled;

/// The budget and the progress of one search.
pub(super) struct Budget<'a> {
    landscape: &'a dyn Landscape,
    control: Control<'a>,
    best: Progress,
    /// Set when the search must end.
    ended: Option<Stop>,
}

impl<'a> Budget<'a> {
    /// No evaluations yet; the best point is the start.
    pub(super) fn new(landscape: &'a dyn Landscape, start: &[f64], control: Control<'a>) -> Self {
        Self {
            landscape,
            control,
            best: Progress {
                evaluations: 0,
                best: start.to_vec(),
                merit: Merit::WORST,
                phase: Phase::Start,
            },
            ended: None,
        }
    }

    /// The number of coordinates.
    pub(super) fn variables(&self) -> usize {
        self.landscape.variables()
    }

    /// Number of evaluations left.
    pub(super) fn left(&self) -> usize {
        self.control.budget - self.best.evaluations
    }

    /// The best point, and the number of evaluations.
    pub(super) fn best(&self) -> &Progress {
        &self.best
    }

    /// Why the search must end; `None` while it may continue.
    pub(super) fn ended(&self) -> Option<Stop> {
        self.ended
    }

    /// The merits of points, in their order. If the budget is too small, those of the first points; if cancelled, none.
    pub(super) fn merits(&mut self, points: &[Vec<f64>], phase: Phase) -> Vec<Merit> {
        self.batch(points, phase, |landscape, x| {
            landscape.merit(x).map(|merit| (merit, merit))
        })
    }

    /// The same with derivatives.
    pub(super) fn evaluations(&mut self, points: &[Vec<f64>], phase: Phase) -> Vec<Evaluation> {
        self.batch(points, phase, |landscape, x| {
            let evaluation = landscape.evaluate(x)?;
            Ok((evaluation.merit(), evaluation))
        })
    }

    /// Evaluates points on all cores and records them in their order, so that the number of threads does not change the
    /// result.
    fn batch<T: Send>(
        &mut self,
        points: &[Vec<f64>],
        phase: Phase,
        of: impl Fn(&dyn Landscape, &[f64]) -> Result<(Merit, T), Cancelled> + Sync,
    ) -> Vec<T> {
        /// Points per thread between two progress reports.
        const SHARE: usize = 4;
        let allowed = &points[..points.len().min(self.left())];
        let landscape = self.landscape;
        let mut results = Vec::with_capacity(allowed.len());
        for some in allowed.chunks(SHARE * rayon::current_num_threads()) {
            if self.control.cancel.load(Relaxed) {
                self.ended = Some(Stop::Cancelled);
                return Vec::new();
            }
            let values: Vec<_> = some.par_iter().map(|x| of(landscape, x)).collect();
            let before = results.len();
            for (x, (merit, value)) in some.iter().zip(values.into_iter().flatten()) {
                self.book(x, merit, phase);
                results.push(value);
            }
            if results.len() - before < some.len() {
                self.ended = Some(Stop::Cancelled);
                return Vec::new();
            }
            (self.control.tell)(&self.best);
        }
        if allowed.len() < points.len() || self.left() == 0 {
            self.ended = Some(Stop::Budget);
        }
        results
    }

    fn book(&mut self, x: &[f64], merit: Merit, phase: Phase) {
        self.best.evaluations += 1;
        self.best.phase = phase;
        if merit.is_better_than(&self.best.merit) {
            self.best.merit = merit;
            self.best.best = x.to_vec();
        }
    }
}

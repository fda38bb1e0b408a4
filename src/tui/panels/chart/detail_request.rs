//! Requests the visible band. References are solved at the same frequencies, so differences are exact.

use std::sync::Arc;
use std::time::Duration;

use super::Member;
use super::detail::{Detail, Key};
use crate::tui::app::{App, Stage};
use crate::tui::scene::ChartView;
use crate::worker::{Request, SampleRequest, Sampling};

/// Frequencies per column of the chart: one per dot, and one between dots.
const PER_COLUMN: usize = 4;
/// Columns before the first drawing.
const USUAL_COLUMNS: usize = 100;
/// The most points of the whole sweep that a band reuses; beyond, every second, third...
const MOST_TAKEN: usize = 20_000;
/// The most frequencies of a band; beyond, every second, third...
const MOST_SOLVED: usize = 60_000;
/// The longest wait for curves that are not resolved yet.
const WORTH_WAITING: Duration = Duration::from_millis(100);

impl App {
    /// Requests the visible band, if it adds detail to what is solved.
    pub(crate) fn want_detail(&mut self) -> Option<Request> {
        let view = self.display.view;
        let difference = view == ChartView::Difference;
        if self.curves.window.is_none() && !difference && view != ChartView::Nyquist {
            self.detail = Detail::default();
            return None;
        }
        let picture = Arc::clone(self.curves.picture()?);
        let slow = picture.elapsed > WORTH_WAITING;
        if self.curves.is_stale() || (picture.stage < Stage::Resolved && !slow) {
            return None;
        }
        let references = self.comparison.shown_ids();
        if difference && references.is_empty() {
            return None;
        }
        let columns = self
            .screen
            .plot
            .as_ref()
            .map_or(USUAL_COLUMNS, |plot| plot.frequencies.len());
        let key = Key {
            generation: picture.generation,
            // The count of the modes alone changes no curve.
            stage: picture.stage.min(Stage::Resolved),
            solved: picture
                .members
                .iter()
                .map(|member| member.frequencies.len())
                .sum(),
            window: self.shown_frequencies(),
            log: self.curves.log_frequency,
            references,
            points: PER_COLUMN * columns.max(1),
            loops: view == ChartView::Nyquist,
        };
        if self.detail.asked.is(|asked| *asked == key) {
            return None;
        }
        let serial = self.requests.next_serial();
        let request = SampleRequest {
            serial,
            sampling: Sampling::Detail,
            subjects: self.compared_subjects(),
            frequencies: self.detail_frequencies(&key, &picture.members),
        };
        self.detail.asked.sent(serial, key);
        Some(Request::Sample(request))
    }

    /// Even steps over the band, and every solved frequency in it.
    fn detail_frequencies(&self, key: &Key, members: &[Member]) -> Vec<f64> {
        let [low, high] = key.window;
        let last = key.points as f64;
        let mut all: Vec<f64> = (0..=key.points)
            .map(|index| {
                let share = index as f64 / last;
                if key.log {
                    low.powf(1.0 - share) * high.powf(share)
                } else {
                    low + share * (high - low)
                }
            })
            .map(|f| f.clamp(low, high))
            .collect();
        let references = self
            .comparison
            .shown()
            .filter_map(|one| one.picture.as_ref());
        let others = references.flat_map(|picture| &picture.members);
        for member in members.iter().chain(others) {
            let from = member.frequencies.partition_point(|f| *f < low);
            let to = member.frequencies.partition_point(|f| *f <= high);
            let inside = &member.frequencies[from..to.max(from)];
            let stride = inside.len().div_ceil(MOST_TAKEN).max(1);
            all.extend(inside.iter().step_by(stride));
        }
        if key.loops {
            let inside = |f: &f64| (low..=high).contains(f);
            all.extend(self.modes.loops().filter(inside));
        }
        all.sort_by(f64::total_cmp);
        all.dedup();
        let stride = all.len().div_ceil(MOST_SOLVED).max(1);
        all.into_iter().step_by(stride).collect()
    }
}

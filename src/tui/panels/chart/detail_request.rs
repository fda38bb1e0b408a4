//! The visible band, solved at the screen's resolution: zooming in keeps the detail. References are solved at the same
//! frequencies, so differences are exact.

use std::f64::consts::PI;
use std::sync::Arc;
use std::time::Duration;

use crate::tui::app::request::LastRequest;
use crate::tui::app::{App, Compared, Stage};
use crate::tui::panels::chart::curves::Member;
use crate::tui::scene::ChartView;
use crate::worker::{Request, SampleAnswer, SampleRequest, Sampling};

/// Frequencies per column of the chart: one per dot, and one between dots.
const PER_COLUMN: usize = 4;
/// Columns before the first drawing.
const USUAL_COLUMNS: usize = 100;
/// The most points of the whole sweep that a band reuses; beyond, every second, third...
const MOST_TAKEN: usize = 20_000;
/// Points of a modal circle in the complex plane.
const LOOP_POINTS: u32 = 72;
/// The most frequencies of a band; beyond, every second, third...
const MOST_SOLVED: usize = 60_000;
/// The longest wait for curves that are not resolved yet.
const WORTH_WAITING: Duration = Duration::from_millis(100);

/// The key of a request.
#[derive(Debug, Clone, PartialEq)]
struct Key {
    generation: u64,
    stage: Stage,
    /// The number of frequencies.
    solved: usize,
    window: [f64; 2],
    log: bool,
    references: Vec<u64>,
    points: usize,
    /// Whether every modal circle needs to be round (Nyquist).
    loops: bool,
}

/// Curves of a band.
#[derive(Debug)]
pub struct DetailPicture {
    /// The model's generation.
    pub generation: u64,
    /// Lower and upper end, Hz.
    pub window: [f64; 2],
    /// The curves of the model and of the references.
    pub curves: Compared,
}

/// The visible band.
#[derive(Debug, Default)]
pub struct Detail {
    asked: LastRequest<Key>,
    shown: Option<DetailPicture>,
}

impl Detail {
    /// The band, if it belongs to the model with this generation.
    pub fn of(&self, generation: u64, window: [f64; 2]) -> Option<&DetailPicture> {
        self.shown
            .as_ref()
            .filter(|shown| shown.generation == generation && shown.window == window)
    }

    /// Stores the answer to the last request.
    ///
    /// # Errors
    /// Why the band was not solved, in one line.
    pub(crate) fn take(&mut self, answer: SampleAnswer) -> Result<(), String> {
        let Some(key) = self.asked.answered(answer.serial) else {
            return Ok(());
        };
        self.shown = Some(DetailPicture {
            generation: key.generation,
            window: key.window,
            curves: Compared::new(answer.result?, &key.references),
        });
        Ok(())
    }
}

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
        let serial = self.next_serial();
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
            all.extend(self.loops().filter(inside));
        }
        all.sort_by(f64::total_cmp);
        all.dedup();
        let stride = all.len().div_ceil(MOST_SOLVED).max(1);
        all.into_iter().step_by(stride).collect()
    }

    /// Frequencies (Hz) in even steps around the circle of each mode in the complex plane: at f (1 + zeta tan a) the
    /// response of one mode has turned by 2 a.
    fn loops(&self) -> impl Iterator<Item = f64> {
        let list = self.modes.list.as_ref();
        let modes = list.map_or(&[][..], |list| &list.rows);
        modes.iter().flat_map(|mode| {
            (1..LOOP_POINTS).map(|step| {
                let angle = PI * (f64::from(step) / f64::from(LOOP_POINTS) - 0.5);
                mode.frequency * (1.0 + mode.damping_ratio * angle.tan())
            })
        })
    }
}

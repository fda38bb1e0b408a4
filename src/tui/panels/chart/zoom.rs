//! The visible frequencies.

use crate::model::Sweep;
use crate::tui::app::App;

/// The narrowest visible band, as a share of the sweep.
const NARROWEST: f64 = 1e-6;

/// A part of the frequency axis, in axis coordinates.
#[derive(Debug, Clone, Copy)]
struct Band {
    log: bool,
    low: f64,
    high: f64,
}

impl Band {
    fn new(log: bool, [low, high]: [f64; 2]) -> Self {
        let place = |frequency: f64| if log { frequency.ln() } else { frequency };
        Self {
            log,
            low: place(low),
            high: place(high),
        }
    }

    fn place(self, frequency: f64) -> f64 {
        if self.log { frequency.ln() } else { frequency }
    }

    fn frequency(self, place: f64) -> f64 {
        if self.log { place.exp() } else { place }
    }

    fn width(self) -> f64 {
        self.high - self.low
    }

    /// A band of this width, moved only as far as needed to lie within `whole`.
    fn within(self, whole: Self) -> Self {
        let width = self.width().min(whole.width());
        // Rounding may leave slightly less than the width at the upper end: no `clamp`.
        let low = self.low.min(whole.high - width).max(whole.low);
        Self {
            low,
            high: low + width,
            ..self
        }
    }
}

/// The visible part of the sweep: the window clipped to the sweep, or the whole sweep.
pub(crate) fn shown(window: Option<[f64; 2]>, sweep: &Sweep) -> [f64; 2] {
    let whole = [sweep.from, sweep.to];
    let Some([low, high]) = window else {
        return whole;
    };
    let (low, high) = (low.max(sweep.from), high.min(sweep.to));
    if high > low { [low, high] } else { whole }
}

impl App {
    /// The visible frequencies, Hz.
    pub fn shown_frequencies(&self) -> [f64; 2] {
        shown(self.curves.window, &self.model().sweep)
    }

    /// Shows the whole sweep with automatic levels.
    pub(crate) fn show_whole(&mut self) {
        let window = self.curves.window.take().is_some();
        let levels = self.display.levels.take().is_some();
        if !window && !levels {
            self.refuse("the whole sweep shows already");
        }
    }

    /// Scales the visible band by a factor; a frequency (Hz), else the middle, stays in place.
    pub(crate) fn zoom(&mut self, factor: f64, about: Option<f64>) {
        let (shown, whole) = self.bands();
        let about = about.map(|frequency| shown.place(frequency));
        let fixed = about
            .filter(|place| (shown.low..=shown.high).contains(place))
            .unwrap_or(f64::midpoint(shown.low, shown.high));
        let wanted = Band {
            low: fixed + (shown.low - fixed) * factor,
            high: fixed + (shown.high - fixed) * factor,
            ..shown
        };
        if factor > 1.0 && shown.width() >= whole.width() {
            self.refuse("the whole sweep shows already");
        } else if wanted.width() < NARROWEST * whole.width() * 2.0 {
            self.refuse("no narrower band shows");
        } else {
            self.show_band(wanted.within(whole), whole);
        }
    }

    pub(crate) fn pan(&mut self, quarters: f64) {
        let (shown, whole) = self.bands();
        let by = quarters * shown.width() / 4.0;
        let moved = Band {
            low: shown.low + by,
            high: shown.high + by,
            ..shown
        }
        .within(whole);
        if moved.low == shown.low {
            return self.refuse(if shown.width() >= whole.width() {
                "the whole sweep shows already"
            } else {
                "the sweep ends here"
            });
        }
        self.show_band(moved, whole);
    }

    /// Moves the visible band only as far as needed to show the cursor.
    pub(crate) fn reveal_cursor(&mut self) {
        let (shown, whole) = self.bands();
        let Some(cursor) = self.curves.cursor.map(|cursor| shown.place(cursor)) else {
            return;
        };
        if self.curves.window.is_none() || (shown.low..=shown.high).contains(&cursor) {
            return;
        }
        let low = if cursor < shown.low {
            cursor
        } else {
            cursor - shown.width()
        };
        let moved = Band {
            low,
            high: low + shown.width(),
            ..shown
        };
        self.show_band(moved.within(whole), whole);
    }

    /// Keeps the marks on the frequency axis within a changed sweep.
    pub(crate) fn keep_marks_in_sweep(&mut self) {
        let sweep = self.model().sweep;
        let inside = |f: &f64| (sweep.from..=sweep.to).contains(f);
        self.curves.cursor = self.curves.cursor.filter(inside);
        self.reading.second = self.reading.second.filter(inside);
        self.band.span = self.band.span.filter(|span| span.iter().all(inside));
    }

    fn bands(&self) -> (Band, Band) {
        let (log, sweep) = (self.curves.log_frequency, &self.model().sweep);
        let shown = Band::new(log, self.shown_frequencies());
        (shown, Band::new(log, [sweep.from, sweep.to]))
    }

    fn show_band(&mut self, band: Band, whole: Band) {
        let all = band.width() >= whole.width() * (1.0 - 1e-9);
        let sweep = self.model().sweep;
        // Use the exact ends of the sweep, without the rounding of a logarithm and back.
        let low = if band.low <= whole.low {
            sweep.from
        } else {
            band.frequency(band.low)
        };
        let high = if band.high >= whole.high {
            sweep.to
        } else {
            band.frequency(band.high)
        };
        self.curves.window = (!all).then_some([low, high]);
    }
}

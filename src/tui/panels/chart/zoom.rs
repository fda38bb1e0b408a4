//! The visible frequencies.

use super::Curves;
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

impl Curves {
    /// The visible part of a sweep, Hz: the window clipped to the sweep, or the whole sweep.
    pub fn shown_frequencies(&self, sweep: &Sweep) -> [f64; 2] {
        let whole = [sweep.from, sweep.to];
        let Some([low, high]) = self.window else {
            return whole;
        };
        let (low, high) = (low.max(sweep.from), high.min(sweep.to));
        if high > low { [low, high] } else { whole }
    }

    /// Scales the visible band by a factor; a frequency (Hz), else the middle, stays in place.
    ///
    /// # Errors
    /// Why the band stays as it is, in one line.
    fn zoom(&mut self, factor: f64, about: Option<f64>, sweep: &Sweep) -> Result<(), &'static str> {
        let (shown, whole) = self.bands(sweep);
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
            return Err("the whole sweep is already visible");
        }
        if wanted.width() < NARROWEST * whole.width() * 2.0 {
            return Err("this is the narrowest band");
        }
        self.show_band(wanted.within(whole), sweep);
        Ok(())
    }

    fn pan(&mut self, quarters: f64, sweep: &Sweep) -> Result<(), &'static str> {
        let (shown, whole) = self.bands(sweep);
        let by = quarters * shown.width() / 4.0;
        let moved = Band {
            low: shown.low + by,
            high: shown.high + by,
            ..shown
        }
        .within(whole);
        if moved.low == shown.low {
            return Err(if shown.width() >= whole.width() {
                "the whole sweep is already visible"
            } else {
                "the sweep ends here"
            });
        }
        self.show_band(moved, sweep);
        Ok(())
    }

    /// Moves the visible band only as far as needed to show the cursor.
    pub(crate) fn reveal_cursor(&mut self, sweep: &Sweep) {
        let (shown, whole) = self.bands(sweep);
        let Some(cursor) = self.cursor.map(|cursor| shown.place(cursor)) else {
            return;
        };
        if self.window.is_none() || (shown.low..=shown.high).contains(&cursor) {
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
        self.show_band(moved.within(whole), sweep);
    }

    /// The visible band and the whole sweep, on the axis.
    fn bands(&self, sweep: &Sweep) -> (Band, Band) {
        let band = |ends| Band::new(self.log_frequency, ends);
        let shown = self.shown_frequencies(sweep);
        (band(shown), band([sweep.from, sweep.to]))
    }

    fn show_band(&mut self, band: Band, sweep: &Sweep) {
        let (_, whole) = self.bands(sweep);
        let all = band.width() >= whole.width() * (1.0 - 1e-9);
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
        self.window = (!all).then_some([low, high]);
    }
}

impl App {
    /// The visible frequencies, Hz.
    pub fn shown_frequencies(&self) -> [f64; 2] {
        self.curves.shown_frequencies(&self.model().sweep)
    }

    /// Scales the visible band by a factor about a frequency, Hz.
    pub(crate) fn zoom(&mut self, factor: f64, about: Option<f64>) {
        let sweep = self.model().sweep;
        if let Err(reason) = self.curves.zoom(factor, about, &sweep) {
            self.refuse(reason);
        }
    }

    /// Moves the visible band by quarters of its width.
    pub(crate) fn pan(&mut self, quarters: f64) {
        let sweep = self.model().sweep;
        if let Err(reason) = self.curves.pan(quarters, &sweep) {
            self.refuse(reason);
        }
    }

    /// Shows the whole sweep with automatic levels.
    pub(crate) fn show_whole(&mut self) {
        let window = self.curves.window.take().is_some();
        let levels = self.display.levels.take().is_some();
        if !window && !levels {
            self.refuse("the whole sweep is already visible");
        }
    }

    /// Keeps the marks on the frequency axis within a changed sweep.
    pub(crate) fn keep_marks_in_sweep(&mut self) {
        let sweep = self.model().sweep;
        let inside = |f: &f64| (sweep.from..=sweep.to).contains(f);
        self.curves.cursor = self.curves.cursor.filter(inside);
        self.reading.second = self.reading.second.filter(inside);
        self.curves.band = self.curves.band.filter(|band| band.iter().all(inside));
    }
}

//! The peaks of a curve.

use num_complex::Complex64;

use super::fit::{Fit, Sample, samples, turns};
use super::{NEAREST, centre, half_width, is_pole};
use crate::solve::extrema::Turn;
use crate::solve::modes::{Mode, ModeKind, Modes};
use crate::solve::{Column, ColumnKind};

/// A local maximum of a response's modulus, or of an energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Hz; for a pole, the frequency of its mode.
    pub frequency: f64,
    /// |H|, in the column's unit; infinite for a pole.
    pub height: f64,
    /// Phase of the response there, degrees, above -180 and up to 180; `None` for an energy and for a pole.
    pub phase: Option<f64>,
    /// Damping ratio by the half-power band, `(f2 - f1) / 2 f`: at its ends |H| is the height over sqrt 2, an energy
    /// half of its height. `None` for a pole, and if the curve rises again or ends before it has fallen that far on
    /// both sides.
    pub half_power_damping: Option<f64>,
    /// Index into [`Modes::modes`] of the mode whose half-power band contains the peak; of several, the one nearest to
    /// the complex frequency of the fit. It depends on frequency and damping, not on the shape.
    pub mode: Option<usize>,
    /// True if the half-power band of another mode overlaps that of `mode`: then neither the height nor the half-power
    /// damping belongs to one mode.
    pub overlaps: bool,
    /// True if the mode has no damping: the true height is infinite.
    pub pole: bool,
}

/// The peaks of a column by ascending frequency, interpolated between the points by a fit.
///
/// `frequencies` (Hz, ascending) and `column` are those of a resolved response (see [`resolved`](super::resolved)),
/// `modes` those of the model; without modes the table has no poles. Maxima lower than 0.01 dB are left out: they are
/// rounding. Values that are not finite are skipped.
pub fn peaks(frequencies: &[f64], column: &Column, modes: &Modes) -> Vec<Peak> {
    let curve = Curve {
        kind: column.kind,
        samples: samples(frequencies, column),
    };
    let tops = turns(&curve.samples).filter(|&(_, turn)| turn == Turn::Maximum);
    tops.filter(|&(top, _)| curve.is_prominent(top))
        .filter_map(
            |(top, _)| match pole_at(&curve.samples[top - 1..=top + 1], modes) {
                Some(pole) => Some(pole),
                None => curve.peak(top, modes),
            },
        )
        .collect()
}

/// The pole between three samples.
fn pole_at(three: &[Sample], modes: &Modes) -> Option<Peak> {
    let [left, _, right] = three else { return None };
    let within = |mode: &Mode| {
        is_pole(mode) && left.frequency <= centre(mode) && centre(mode) <= right.frequency
    };
    let mode = modes.modes.iter().position(within)?;
    Some(Peak {
        frequency: centre(&modes.modes[mode]),
        height: f64::INFINITY,
        phase: None,
        half_power_damping: None,
        mode: Some(mode),
        overlaps: overlaps(mode, modes),
        pole: true,
    })
}

/// The half-power band of a mode that has one, as centre and half-width, Hz.
fn band(mode: &Mode) -> Option<(f64, f64)> {
    // A mode is not known more exactly than this, and rounding shifts it.
    let margin = NEAREST * centre(mode);
    (mode.kind == ModeKind::Oscillating).then(|| (centre(mode), half_width(mode) + margin))
}

/// True if another mode's half-power band overlaps that of the mode `mode`.
fn overlaps(index: usize, modes: &Modes) -> bool {
    let Some((f, width)) = band(&modes.modes[index]) else {
        return false;
    };
    let reaches = |mode: &Mode| band(mode).is_some_and(|(g, other)| (f - g).abs() <= width + other);
    let others = modes.modes.iter().enumerate().filter(|(i, _)| *i != index);
    others.into_iter().any(|(_, mode)| reaches(mode))
}

/// The mode whose band contains `frequency`, nearest to `root`; both Hz.
fn mode_at(frequency: f64, root: Complex64, modes: &Modes) -> Option<usize> {
    let inside = |mode: &Mode| band(mode).is_some_and(|(f, width)| (frequency - f).abs() <= width);
    let distance = |mode: &Mode| (Complex64::new(centre(mode), half_width(mode)) - root).norm();
    let all = modes.modes.iter().enumerate().filter(|(_, m)| inside(m));
    all.min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b)))
        .map(|(index, _)| index)
}

/// A response with finite values everywhere.
struct Curve {
    kind: ColumnKind,
    samples: Vec<Sample>,
}

impl Curve {
    /// The peak at a sample that is higher than its neighbours.
    fn peak(&self, top: usize, modes: &Modes) -> Option<Peak> {
        let fit = self.fit(top)?;
        let extremum = fit.extremum();
        let value = fit.value(extremum.centre);
        let mode = mode_at(extremum.centre, fit.root(extremum), modes);
        Some(Peak {
            frequency: extremum.centre,
            height: value.norm(),
            phase: (self.kind == ColumnKind::Complex).then(|| value.arg().to_degrees()),
            half_power_damping: self.half_power_damping(top, extremum.centre, value.norm()),
            mode,
            overlaps: mode.is_some_and(|mode| overlaps(mode, modes)),
            pole: false,
        })
    }

    /// The fit around a sample; `None` for the first and the last.
    fn fit(&self, middle: usize) -> Option<Fit> {
        let three = self.samples.get(middle.checked_sub(1)?..=middle + 1)?;
        Fit::new(self.kind, Turn::Maximum, three)
    }

    /// True if the curve falls by more than 0.01 dB on both sides of a peak before it rises again.
    fn is_prominent(&self, top: usize) -> bool {
        const LEAST: f64 = 1.0 - 1.15e-3;
        self.falls_below(LEAST * self.samples[top].size, top)
            .is_some()
    }

    /// `(f2 - f1) / 2 f` of a peak with a height at a frequency (Hz).
    fn half_power_damping(&self, top: usize, frequency: f64, height: f64) -> Option<f64> {
        let level = match self.kind {
            ColumnKind::Complex => height * std::f64::consts::FRAC_1_SQRT_2,
            ColumnKind::Energy => 0.5 * height,
        };
        let (before, after) = self.falls_below(level, top)?;
        let lower = self.crossing(level, before + 1, before)?;
        let upper = self.crossing(level, after - 1, after)?;
        Some(0.5 * (upper - lower) / frequency)
    }

    /// The frequency (Hz) at which the curve passes `level` between two neighbouring samples, `inside` above it.
    fn crossing(&self, level: f64, inside: usize, outside: usize) -> Option<f64> {
        let [from, to] = [inside, outside].map(|index| self.samples[index].frequency);
        Some(self.fit(inside)?.crossing(from, to, level.recip()))
    }

    /// The nearest samples below `level` before and after a peak; `None` if the curve rises or ends first.
    fn falls_below(&self, level: f64, top: usize) -> Option<(usize, usize)> {
        let before = self.samples[..top].iter().rev();
        let after = self.samples[top..].iter();
        Some((
            top - 1 - steps_down(level, before)?,
            top + steps_down(level, after)?,
        ))
    }
}

/// The number of samples before the first below `level`; `None` if they rise or end first.
fn steps_down<'a>(level: f64, samples: impl Iterator<Item = &'a Sample>) -> Option<usize> {
    /// A smaller rise is rounding.
    const RISE: f64 = 1.001;
    let mut lowest = f64::INFINITY;
    for (index, sample) in samples.enumerate() {
        if sample.size < level {
            return Some(index);
        }
        if sample.size > RISE * lowest {
            return None;
        }
        lowest = lowest.min(sample.size);
    }
    None
}

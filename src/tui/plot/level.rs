//! The quantity on the value axis, and automatic bounds for it.

use super::axis::{Axis, Notation, Scale};
use super::curve::Curve;
use super::ticks;

/// Most decades of automatic bounds below the largest magnitude.
const DEEPEST_DECADES: f64 = 12.0;
/// Parts of the horizontal axis; a dip narrower than one part may leave the plot at the bottom.
const PARTS: f64 = 100.0;
/// Automatic bounds in decibels are multiples of this.
const DECIBEL_STEP: f64 = 10.0;
/// Most steps between the bounds of a linear axis before rounding.
const STEPS: f64 = 8.0;
/// The same for the axes of a Nyquist plot, which share one scale.
pub(super) const FINE_STEPS: f64 = 20.0;
/// Half a turn, in degrees; a larger phase jump between two samples is a wrap.
pub(super) const HALF_TURN: f64 = 180.0;
/// Rounding tolerance of a wrapped phase, in degrees.
const ROUNDING: f64 = 1e-6;

/// The quantity on the value axis, computed from a curve's value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Level {
    /// The magnitude itself.
    Magnitude,
    /// `factor * log10(magnitude / reference)` in dB.
    Decibel {
        /// 20 for amplitudes, 10 for energies and powers.
        factor: f64,
        /// The magnitude of 0 dB, in the unit of the magnitudes.
        reference: f64,
    },
    /// The value itself, which may be negative, on a linear axis.
    Signed,
    /// A phase in degrees, on a linear axis: wrapped to -180..180, or not.
    Degrees,
}

impl Level {
    /// The value on the axis; not finite where it is undefined.
    pub fn value(self, magnitude: f64) -> f64 {
        match self {
            Self::Magnitude | Self::Signed | Self::Degrees => magnitude,
            Self::Decibel { factor, reference } => factor * (magnitude / reference).log10(),
        }
    }

    /// An automatic value axis for the part of `curves` within the bounds of `x`.
    ///
    /// Magnitudes have a logarithmic axis in whole decades, decibels a linear one in tens; both reach at most twelve
    /// decades below the largest value. Dips narrower than a hundredth of the horizontal axis do not count, because an
    /// undamped anti-resonance has no finite depth. Signed values have a linear axis with 0 and round bounds. A phase
    /// has -180 to 180 degrees, or multiples of 90 if it exceeds them. Samples next to a pole do not count.
    pub fn axis(self, curves: &[Curve<'_>], x: &Axis, unit: impl Into<String>) -> Axis {
        let extents = curves.iter().map(|curve| self.extent(curve, x));
        let [low, high] = extents.fold([f64::INFINITY, f64::NEG_INFINITY], |sum, extent| {
            [sum[0].min(extent.0), sum[1].max(extent.1)]
        });
        let deepest = high - self.depth();
        match self {
            Self::Magnitude => {
                let decades = stepped([low.max(deepest), high], 1.0);
                Axis::new(Scale::Log, decades.map(|bound| 10_f64.powf(bound)), unit)
                    .with_notation(Notation::Power)
            }
            Self::Decibel { .. } => {
                let bounds = stepped([low.max(deepest), high], DECIBEL_STEP);
                Axis::new(Scale::Linear, bounds, unit)
            }
            Self::Signed => signed_axis([low.min(0.0), high.max(0.0)], STEPS, unit),
            Self::Degrees => phase_axis([low, high], unit),
        }
    }

    /// Most distance of automatic bounds below the largest value, on the axis.
    fn depth(self) -> f64 {
        match self {
            Self::Magnitude => DEEPEST_DECADES,
            Self::Decibel { factor, .. } => factor.abs() * DEEPEST_DECADES,
            Self::Signed | Self::Degrees => f64::INFINITY,
        }
    }

    /// An axis of values of this level between given bounds.
    pub fn axis_between(self, bounds: [f64; 2], unit: impl Into<String>) -> Axis {
        match self {
            Self::Magnitude => Axis::new(Scale::Log, bounds, unit).with_notation(Notation::Power),
            Self::Decibel { .. } => Axis::new(Scale::Linear, bounds, unit),
            Self::Signed => linear(bounds, unit),
            Self::Degrees => {
                Axis::new(Scale::Linear, bounds, unit).with_notation(Notation::Degrees)
            }
        }
    }

    /// Whether narrow dips count for the bounds: a dip of a signed value or a phase is equivalent to a peak.
    const fn counts_dips(self) -> bool {
        matches!(self, Self::Signed | Self::Degrees)
    }

    /// Whether a curve rises to the top at a pole.
    pub(super) const fn rises_at_poles(self) -> bool {
        matches!(self, Self::Magnitude | Self::Decibel { .. })
    }

    /// The lowest and the highest axis value of a curve within the bounds of `x`; infinities if it has none.
    fn extent(self, curve: &Curve<'_>, x: &Axis) -> (f64, f64) {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        // The current part of the axis, and the curve's highest value in it.
        let mut part = (f64::NAN, f64::INFINITY);
        for (abscissa, magnitude) in curve.samples() {
            let height = self.height(magnitude);
            if !height.is_finite() || !x.contains(abscissa) || curve.is_at_pole(abscissa) {
                continue;
            }
            high = high.max(height);
            if self.counts_dips() {
                low = low.min(height);
                continue;
            }
            let number = (x.fraction(abscissa) * PARTS).floor();
            if number == part.0 {
                part.1 = part.1.max(height);
            } else {
                low = low.min(part.1);
                part = (number, height);
            }
        }
        (low.min(part.1), high)
    }

    /// A magnitude for comparison: its decimal logarithm, or its value on the axis.
    fn height(self, magnitude: f64) -> f64 {
        match self {
            Self::Magnitude => magnitude.log10(),
            Self::Decibel { .. } | Self::Signed | Self::Degrees => self.value(magnitude),
        }
    }
}

/// Bounds at multiples of `step` around a range; one step for an empty range.
fn stepped([low, high]: [f64; 2], step: f64) -> [f64; 2] {
    if low > high {
        [0.0, step]
    } else {
        outwards([low, high], step)
    }
}

/// A linear axis with round bounds around `low` and `high`, which are at most about `steps` steps apart.
pub(super) fn signed_axis([low, high]: [f64; 2], steps: f64, unit: impl Into<String>) -> Axis {
    if low >= high {
        return linear([-1.0, 1.0], unit);
    }
    let (mantissa, exponent) = ticks::round_step((high - low) / steps);
    let step = ticks::round(mantissa, exponent);
    // Integer step counts, so that the bounds are correctly rounded.
    let steps = outwards([low / step, high / step], 1.0);
    let bounds = steps.map(|count| ticks::round((count as i64).saturating_mul(mantissa), exponent));
    linear(bounds, unit)
}

/// A linear axis with the notation that its numbers need.
fn linear(bounds: [f64; 2], unit: impl Into<String>) -> Axis {
    let largest = bounds[0].abs().max(bounds[1].abs());
    let notation = if (1e-2..1e5).contains(&largest) {
        Notation::Plain
    } else {
        Notation::Power
    };
    Axis::new(Scale::Linear, bounds, unit).with_notation(notation)
}

/// A phase axis: one turn around 0, or whole quarters or halves of a turn.
fn phase_axis([low, high]: [f64; 2], unit: impl Into<String>) -> Axis {
    let wrapped = low >= -HALF_TURN - ROUNDING && high <= HALF_TURN + ROUNDING;
    let bounds = if wrapped || low > high {
        [-HALF_TURN, HALF_TURN]
    } else if high - low <= 4.0 * HALF_TURN {
        outwards([low, high], HALF_TURN / 2.0)
    } else {
        outwards([low, high], HALF_TURN)
    };
    Level::Degrees.axis_between(bounds, unit)
}

/// Bounds at whole steps outside `low` and `high`, at least one step apart on each side of a single value.
fn outwards([low, high]: [f64; 2], step: f64) -> [f64; 2] {
    // 1e-6 is meant to be a whole decade although its logarithm may be off by a rounding error.
    let bounds = [(low / step + 1e-9).floor(), (high / step - 1e-9).ceil()];
    let margin = if bounds[1] > bounds[0] { 0.0 } else { 1.0 };
    [(bounds[0] - margin) * step, (bounds[1] + margin) * step]
}

#[cfg(test)]
mod tests {
    use super::*;

    const DECIBEL: Level = Level::Decibel {
        factor: 20.0,
        reference: 1e-6,
    };

    fn bounds(level: Level, y: &[f64]) -> [f64; 2] {
        let x: Vec<f64> = (1..=y.len()).map(|k| 0.2 * k as f64).collect();
        let axis = Axis::new(Scale::Linear, [0.0, 2.0], "");
        level.axis(&[Curve::new(&x, y)], &axis, "").bounds()
    }

    fn assert_close(actual: [f64; 2], expected: [f64; 2]) {
        for (actual, expected) in actual.into_iter().zip(expected) {
            assert!(
                (actual - expected).abs() <= 1e-9 * expected.abs(),
                "{actual} {expected}"
            );
        }
    }

    #[test]
    fn magnitudes_are_bounded_by_decades() {
        assert_close(bounds(Level::Magnitude, &[2.81e-5, 3e-9]), [1e-9, 1e-4]);
        assert_close(bounds(Level::Magnitude, &[1e-6, 1e-3]), [1e-6, 1e-3]);
        assert_close(bounds(Level::Magnitude, &[1e-6, 1e-6]), [1e-7, 1e-5]);
        assert_close(bounds(Level::Magnitude, &[1.0, 1e-30]), [1e-12, 1.0]);
    }

    #[test]
    fn decibels_are_bounded_by_tens() {
        assert_close(bounds(DECIBEL, &[3e-6, 2e-9]), [-60.0, 10.0]);
        assert_close(bounds(DECIBEL, &[1e-6, 1e-6]), [-10.0, 10.0]);
        assert_close(bounds(DECIBEL, &[1.0, 1e-30]), [-120.0, 120.0]);
    }

    #[test]
    fn signed_values_are_bounded_by_round_numbers_and_zero() {
        // Bounds by hand: an eighth of the span, rounded up to 1, 2 or 5 times a power of ten, is the step.
        let signed = |y: &[f64]| bounds(Level::Signed, y);
        assert_eq!(signed(&[-3.1e-6, 7.4e-6]), [-4e-6, 8e-6]);
        assert_eq!(signed(&[0.3, 0.7]), [0.0, 0.7]);
        assert_eq!(signed(&[-20.0, -3.0]), [-20.0, 0.0]);
        assert_eq!(signed(&[3.2, 3.2, 3.2]), [0.0, 3.5]);
        assert_eq!(signed(&[0.0, 0.0]), [-1.0, 1.0]);
        assert_eq!(signed(&[f64::NAN, f64::INFINITY]), [-1.0, 1.0]);
        assert_eq!(signed(&[]), [-1.0, 1.0]);
    }

    #[test]
    fn a_narrow_dip_of_signed_values_keeps_its_depth() {
        let x: Vec<f64> = (0..2000).map(|k| 0.001 * f64::from(k)).collect();
        let mut y = vec![0.25; x.len()];
        (y[300], y[500]) = (7.0, -3.0);
        let axis = Axis::new(Scale::Linear, [0.0, 2.0], "");
        let curve = Curve::new(&x, &y);
        let bounds = |curve| Level::Signed.axis(&[curve], &axis, "").bounds();
        assert_eq!(bounds(curve.clone()), [-4.0, 8.0]);
        let pole = Curve {
            poles: vec![0.3, 0.5],
            ..curve
        };
        assert_eq!(bounds(pole), [0.0, 0.25]);
    }

    #[test]
    fn phases_are_bounded_by_a_turn_or_by_quarters() {
        let phases = |y: &[f64]| bounds(Level::Degrees, y);
        assert_eq!(phases(&[-3.0, 5.0]), [-180.0, 180.0]);
        assert_eq!(phases(&[-180.0, 180.0]), [-180.0, 180.0]);
        assert_eq!(phases(&[-200.0, 5.0]), [-270.0, 90.0]);
        assert_eq!(phases(&[270.0, 270.0]), [180.0, 360.0]);
        assert_eq!(phases(&[-1000.0, 5.0]), [-1080.0, 180.0]);
        assert_eq!(phases(&[f64::NAN]), [-180.0, 180.0]);
    }

    #[test]
    fn what_cannot_be_drawn_has_no_say() {
        let some = [f64::NAN, 0.0, f64::INFINITY, 2e-4, 4e-3];
        assert_close(bounds(Level::Magnitude, &some), [1e-4, 1e-2]);
        assert_close(bounds(Level::Magnitude, &[f64::NAN, 0.0]), [1.0, 10.0]);
        assert_close(bounds(DECIBEL, &[]), [0.0, 10.0]);
        let x = Axis::new(Scale::Linear, [0.0, 2.0], "");
        let zoomed = Level::Magnitude.axis(&[Curve::new(&[1.0, 3.0], &[2e-4, 5.0])], &x, "");
        assert_close(zoomed.bounds(), [1e-4, 1e-3]);
    }

    #[test]
    fn narrow_dips_and_poles_do_not_squeeze_the_rest() {
        let x: Vec<f64> = (0..2000).map(|k| 0.001 * f64::from(k)).collect();
        let mut y = vec![2e-5; x.len()];
        y[700..1000].fill(3e-7);
        // A peak of one sample keeps its height; a dip as narrow has none.
        (y[300], y[500]) = (4e-3, 1e-11);
        let axis = Axis::new(Scale::Linear, [0.0, 2.0], "");
        let curve = Curve::new(&x, &y);
        let bounds = |curve| Level::Magnitude.axis(&[curve], &axis, "").bounds();
        assert_close(bounds(curve.clone()), [1e-7, 1e-2]);
        let pole = Curve {
            poles: vec![0.3],
            ..curve
        };
        assert_close(bounds(pole), [1e-7, 1e-4]);
    }
}

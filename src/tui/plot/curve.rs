//! What is drawn: curves, and the levels their magnitudes are drawn at.

use ratatui::style::{Modifier, Style};

use super::axis::{Axis, Notation, Scale};

/// Decades below the largest magnitude that automatic bounds reach at most.
const DEEPEST_DECADES: f64 = 12.0;
/// Relative distance to a pole within which a curve's height is not the axis's concern.
const NEAR_POLE: f64 = 1e-3;
/// Parts of the horizontal axis; a dip that is narrower than one may leave the plot at the bottom.
const PARTS: f64 = 100.0;
/// Automatic bounds in decibels are multiples of this.
const DECIBEL_STEP: f64 = 10.0;

/// How a curve's line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LineStyle {
    /// Every dot.
    #[default]
    Solid,
    /// Strokes with gaps.
    Dashed,
    /// Single dots.
    Dotted,
    /// No line: the marker at every sample that is at least so many cells right of the last marked one.
    Points {
        /// Columns from one marker to the next; 0 marks every sample.
        apart: u16,
    },
}

impl LineStyle {
    /// Whether the dot after `passed` dots along the line is drawn.
    pub(super) fn draws(self, passed: usize) -> bool {
        match self {
            Self::Solid => true,
            Self::Dashed => passed % 9 < 5,
            Self::Dotted => passed.is_multiple_of(3),
            Self::Points { .. } => false,
        }
    }
}

/// One curve: magnitudes over ascending abscissae, and how they are told from other curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve<'a> {
    /// Abscissae in the unit of the horizontal axis, ascending.
    pub x: &'a [f64],
    /// Linear magnitudes at the abscissae; a non-finite one is a gap, on a logarithmic axis also a zero.
    pub y: &'a [f64],
    /// The name in the legend; without one the curve is not listed there.
    pub label: String,
    /// Colour and modifiers of the line, its markers and its line in the legend.
    pub style: Style,
    /// A character one column wide, drawn on the curve at a few places and in the legend.
    pub marker: Option<char>,
    /// How the line is drawn.
    pub line: LineStyle,
    /// Drawn dim and beneath the others: the curve is stale or only a reference.
    pub dim: bool,
    /// Abscissae at which the curve is infinite: a line goes up to the top there, with a mark.
    pub poles: Vec<f64>,
}

impl<'a> Curve<'a> {
    /// A solid curve without name, style and marker.
    pub fn new(x: &'a [f64], y: &'a [f64]) -> Self {
        Self {
            x,
            y,
            label: String::new(),
            style: Style::default(),
            marker: None,
            line: LineStyle::default(),
            dim: false,
            poles: Vec::new(),
        }
    }

    /// The style with the dimming applied.
    pub(super) fn ink(&self) -> Style {
        if self.dim {
            self.style.add_modifier(Modifier::DIM)
        } else {
            self.style
        }
    }

    /// Whether an abscissa is so near to a pole that the curve's height there says nothing but that.
    fn is_at_pole(&self, abscissa: f64) -> bool {
        let after = self.poles.partition_point(|pole| *pole < abscissa);
        let around = self.poles[after.saturating_sub(1)..].iter().take(2);
        around
            .into_iter()
            .any(|pole| (abscissa - pole).abs() < NEAR_POLE * pole)
    }

    /// The samples as pairs.
    pub(super) fn samples(&self) -> impl Iterator<Item = (f64, f64)> {
        self.x.iter().copied().zip(self.y.iter().copied())
    }
}

/// The quantity on the value axis, made from a linear magnitude.
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
}

impl Level {
    /// The value on the axis; not finite where there is none.
    pub fn value(self, magnitude: f64) -> f64 {
        match self {
            Self::Magnitude => magnitude,
            Self::Decibel { factor, reference } => factor * (magnitude / reference).log10(),
        }
    }

    /// A value axis around what `curves` show within the bounds of `x`.
    ///
    /// A logarithmic axis in whole decades for magnitudes, a linear one in tens of decibels else; both
    /// reach at most twelve decades below the largest value, and not down to the end of a dip that is narrower than a
    /// hundredth of the horizontal axis: an anti-resonance without damping has none. What is next to a pole does not
    /// count either.
    pub fn axis(self, curves: &[Curve<'_>], x: &Axis, unit: impl Into<String>) -> Axis {
        // Both are rounded in steps: decades as logarithms, decibels in tens.
        let (step, deepest) = match self {
            Self::Magnitude => (1.0, DEEPEST_DECADES),
            Self::Decibel { factor, .. } => (DECIBEL_STEP, factor.abs() * DEEPEST_DECADES),
        };
        let (low, high) = curves
            .iter()
            .map(|curve| self.extent(curve, x))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), extent| {
                (low.min(extent.0), high.max(extent.1))
            });
        let bounds = if low > high {
            [0.0, step]
        } else {
            outwards([low.max(high - deepest), high], step)
        };
        match self {
            Self::Magnitude => Axis::new(Scale::Log, bounds.map(|bound| 10_f64.powf(bound)), unit)
                .with_notation(Notation::Power),
            Self::Decibel { .. } => Axis::new(Scale::Linear, bounds, unit),
        }
    }

    /// The lowest and the highest place that a curve needs within the bounds of `x`; infinities where it has none.
    fn extent(self, curve: &Curve<'_>, x: &Axis) -> (f64, f64) {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        // The part of the axis one is in, and the curve's highest place in it.
        let mut part = (f64::NAN, f64::INFINITY);
        for (abscissa, magnitude) in curve.samples() {
            let height = self.height(magnitude);
            if !height.is_finite() || !x.contains(abscissa) || curve.is_at_pole(abscissa) {
                continue;
            }
            high = high.max(height);
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

    /// The place of a magnitude among others: its decimal logarithm, or its level in dB.
    fn height(self, magnitude: f64) -> f64 {
        match self {
            Self::Magnitude => magnitude.log10(),
            Self::Decibel { .. } => self.value(magnitude),
        }
    }
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

//! What is drawn: curves, and how their lines are drawn.

use ratatui::style::{Modifier, Style};

/// Relative distance to a pole within which a curve's height is not the axis's concern.
const NEAR_POLE: f64 = 1e-3;

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

/// One curve: values over abscissae, and how it is told from other curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve<'a> {
    /// Abscissae in the unit of the horizontal axis, ascending; in a [locus](super::Chart::locus) in any order.
    pub x: &'a [f64],
    /// Values at the abscissae, magnitudes linear; a non-finite one is a gap, on a logarithmic axis also a zero.
    pub y: &'a [f64],
    /// The name in the legend; without one the curve has no entry of its own there.
    pub label: String,
    /// Without a name, the marker stands in the entry of the curve before.
    pub shares_entry: bool,
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
            shares_entry: false,
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
    pub(super) fn is_at_pole(&self, abscissa: f64) -> bool {
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

//! Curves and their line styles.

use ratatui::style::{Modifier, Style};

/// Relative distance to a pole within which the automatic axis ignores a curve.
const NEAR_POLE: f64 = 1e-3;

/// How a curve's line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LineStyle {
    /// Every dot.
    #[default]
    Solid,
    /// Dashes with gaps.
    Dashed,
    /// Single dots.
    Dotted,
    /// No line: a marker at every sample that is at least `apart` columns right of the last marked one.
    Points {
        /// Columns from one marker to the next; 0 marks every sample.
        apart: u16,
    },
}

impl LineStyle {
    /// Whether the dot at `distance` dots along the line is drawn.
    pub(super) fn draws(self, distance: usize) -> bool {
        match self {
            Self::Solid => true,
            Self::Dashed => distance % 9 < 5,
            Self::Dotted => distance.is_multiple_of(3),
            Self::Points { .. } => false,
        }
    }
}

/// One curve: values over abscissae, and its name and style.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve<'a> {
    /// Abscissae in the unit of the horizontal axis, ascending; in any order in a
    /// [Nyquist plot](super::Chart::nyquist).
    pub x: &'a [f64],
    /// Values at the abscissae, magnitudes linear; a non-finite value is a gap, on a logarithmic axis also a zero.
    pub y: &'a [f64],
    /// The name in the legend; a curve without a name has no legend entry.
    pub label: String,
    /// Whether a curve without a name shows its marker in the legend entry of the previous curve.
    pub shares_entry: bool,
    /// Colour and modifiers of the line, of its markers and of its sample in the legend.
    pub style: Style,
    /// A character one column wide, drawn on the curve at a few points and in the legend.
    pub marker: Option<char>,
    /// How the line is drawn.
    pub line: LineStyle,
    /// Drawn dim and below the others: the curve is stale or a reference.
    pub dim: bool,
    /// Abscissae at which the curve is infinite: a line to the top with an arrow.
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

    /// The style, dim if the curve is.
    pub(super) fn dimmed_style(&self) -> Style {
        if self.dim {
            self.style.add_modifier(Modifier::DIM)
        } else {
            self.style
        }
    }

    /// Whether an abscissa is so near to a pole that the automatic axis ignores the curve there.
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

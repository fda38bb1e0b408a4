//! The contents of the chart, independent of the output: the widgets on the screen and the exported files draw the same
//! scene.

pub mod axes;
mod build;
#[cfg(test)]
pub(crate) mod sample;

use num_complex::Complex64;

pub use build::{ChartState, label, of};

use crate::tui::plot::{Level, LineStyle};
use crate::unit::FrequencyUnit;

/// What of the complex values is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ChartView {
    /// The magnitude.
    #[default]
    Magnitude,
    /// The magnitude, and below it the phase.
    MagnitudePhase,
    /// The real part, and below it the imaginary part.
    RealImaginary,
    /// The imaginary part over the real part.
    Nyquist,
    /// The level against the first frozen reference, dB.
    Difference,
}

/// The contents of the chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// What of the values is drawn.
    pub view: ChartView,
    /// What the curves are, in words: the response, the form, the study.
    pub title: String,
    /// The frequencies.
    pub frequency: FrequencyAxis,
    /// One panel of the chart, or two that share the frequencies; of a Nyquist plot the abscissa and the ordinate.
    pub panels: Vec<Panel>,
    /// The curves, those that are drawn first and beneath the others first.
    pub curves: Vec<SceneCurve>,
    /// Curves that are not drawn but count for the bounds of the value axes, so that the axes do not move while a
    /// parameter changes.
    pub spanning: Vec<SceneCurve>,
    /// The marks on the frequency axis.
    pub marks: Marked,
}

/// The frequency axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrequencyAxis {
    /// The unit of its labels.
    pub unit: FrequencyUnit,
    /// Whether it is logarithmic.
    pub log: bool,
    /// Its range, Hz.
    pub bounds: [f64; 2],
}

/// One value axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Its quantity: "|H|", "phase", "Re", "Im".
    pub name: &'static str,
    /// The unit on the axis, "dB re 1e-6 m/N".
    pub unit: String,
    /// Converts the value of a curve to the axis.
    pub level: Level,
    /// The fixed range, in axis values; none: automatic.
    pub bounds: Option<[f64; 2]>,
}

/// The units and levels of the visible responses on the chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// Converts a magnitude to the axis.
    pub level: Level,
    /// The unit of the axis.
    pub unit: String,
}

/// The kind of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CurveKind {
    /// A frozen reference.
    Reference,
    /// The model, or a member of its study.
    Model,
    /// Finite elements.
    Fem,
    /// A measurement.
    Measured,
}

/// One curve.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneCurve {
    /// The legend entry; empty if the title or another curve of its group has it.
    pub label: String,
    /// Its kind.
    pub kind: CurveKind,
    /// The index of its colour in the theme.
    pub colour: usize,
    /// The index of its marker in the theme, if any.
    pub marker: Option<usize>,
    /// Its line style.
    pub line: LineStyle,
    /// Whether it is dim: older than the model, or a reference.
    pub dim: bool,
    /// Hz, rising.
    pub frequencies: Vec<f64>,
    /// For each panel one value per frequency, in the panel's unit (magnitudes without decibels); not finite at a gap.
    pub values: Vec<Vec<f64>>,
    /// Frequencies (Hz) at which it is infinite.
    pub poles: Vec<f64>,
    /// For each panel the value solved at the cursor, if known; the phase wrapped. None for a difference.
    pub at_cursor: Option<Vec<f64>>,
}

/// The marks on the frequency axis, Hz.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Marked {
    /// The cursor.
    pub cursor: Option<f64>,
    /// The second cursor; differences are relative to it.
    pub second: Option<f64>,
    /// The cursor's harmonics: 2, 3, .. times its frequency.
    pub harmonics: Vec<f64>,
    /// The marked band.
    pub band: Option<[f64; 2]>,
    /// Where the theory of Euler and Bernoulli ends, if that is the theory of the model (not of the members of a study).
    pub validity: Option<f64>,
    /// The modes.
    pub modes: Vec<f64>,
    /// The index of the selected mode.
    pub mode: Option<usize>,
    /// Whether the modes belong to an older model.
    pub modes_dim: bool,
}

impl ChartView {
    /// Every view, in the order of the key.
    pub const ALL: [Self; 5] = [
        Self::Magnitude,
        Self::MagnitudePhase,
        Self::RealImaginary,
        Self::Nyquist,
        Self::Difference,
    ];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Magnitude => "magnitude",
            Self::MagnitudePhase => "magnitude and phase",
            Self::RealImaginary => "real and imaginary part",
            Self::Nyquist => "Nyquist",
            Self::Difference => "difference to the reference",
        }
    }

    /// How many panels the view has.
    pub const fn panels(self) -> usize {
        if self.has_two_panels() { 2 } else { 1 }
    }

    /// Whether the view has two panels.
    pub const fn has_two_panels(self) -> bool {
        matches!(
            self,
            Self::MagnitudePhase | Self::RealImaginary | Self::Nyquist
        )
    }
}

/// The value in each panel of a view; an energy is real and has no phase.
fn part(view: ChartView, value: Complex64, energy: bool) -> Vec<f64> {
    let magnitude = if energy { value.re } else { value.norm() };
    match view {
        ChartView::Magnitude | ChartView::Difference => vec![magnitude],
        ChartView::MagnitudePhase if energy || value == Complex64::ZERO => {
            vec![magnitude, f64::NAN]
        }
        ChartView::MagnitudePhase => vec![magnitude, value.arg().to_degrees()],
        ChartView::RealImaginary | ChartView::Nyquist => {
            vec![value.re, if energy { f64::NAN } else { value.im }]
        }
    }
}

/// A level relative to another one, dB: ten decibels per decade for an energy, else twenty.
pub fn difference(energy: bool, value: Complex64, against: Complex64) -> f64 {
    if energy {
        10.0 * (value.re / against.re).log10()
    } else {
        20.0 * (value.norm() / against.norm()).log10()
    }
}

/// Unwraps a phase (degrees); after a gap it starts again at the wrapped value.
fn unwrap(phase: &mut [f64]) {
    let mut last: Option<f64> = None;
    for value in phase.iter_mut().filter(|value| value.is_finite()) {
        if let Some(last) = last {
            *value -= 360.0 * ((*value - last) / 360.0).round();
        }
        last = Some(*value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_phase_runs_on_past_half_a_turn() {
        // A full turn downwards in steps of 60 degrees, wrapped, with a gap.
        let mut phase = [0.0, -60.0, -120.0, 180.0, f64::NAN, 120.0, 60.0, 0.0];
        unwrap(&mut phase);
        let finite: Vec<f64> = phase.into_iter().filter(|one| one.is_finite()).collect();
        assert_eq!(finite, [0.0, -60.0, -120.0, -180.0, -240.0, -300.0, -360.0]);
    }

    #[test]
    fn levels_are_compared_with_each_other() {
        // Closed form: a factor of 10 is 20 dB of an amplitude and 10 dB of an energy.
        let (one, ten) = (Complex64::new(0.0, 1.0), Complex64::from(10.0));
        assert!((difference(false, ten, one) - 20.0).abs() < 1e-12);
        assert!((difference(true, ten, Complex64::ONE) - 10.0).abs() < 1e-12);
    }
}

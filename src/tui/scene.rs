//! What stands on the chart, before anything draws it: the widgets on the screen and the exported files both do.

pub mod axes;
mod build;
#[cfg(test)]
pub(crate) mod sample;

use num_complex::Complex64;

pub use build::{Scale, label, of, scale};

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

/// All that stands on the chart.
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
    /// Curves that are not drawn but count for the bounds of the value axes, which stand still while a parameter is
    /// turned.
    pub spanning: Vec<SceneCurve>,
    /// What is marked on the frequency axis.
    pub marks: Marked,
}

/// The frequency axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrequencyAxis {
    /// The unit of its labels.
    pub unit: FrequencyUnit,
    /// Whether it is logarithmic.
    pub log: bool,
    /// What it spans, Hz.
    pub bounds: [f64; 2],
}

/// One value axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What it shows: "|H|", "phase", "Re", "Im".
    pub name: &'static str,
    /// The unit on the axis, "dB re 1e-6 m/N".
    pub unit: String,
    /// From a curve's value to the one on the axis.
    pub level: Level,
    /// What the axis spans, values on the axis; none where the curves decide.
    pub bounds: Option<[f64; 2]>,
}

/// What a curve is.
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
    /// The name; empty where the title says it, or another curve's for a group.
    pub label: String,
    /// What it is.
    pub kind: CurveKind,
    /// Which of the theme's colours it has.
    pub colour: usize,
    /// Which of the theme's markers it has, if any.
    pub marker: Option<usize>,
    /// How it is drawn.
    pub line: LineStyle,
    /// Older than the model, or only a reference.
    pub dim: bool,
    /// Hz, rising.
    pub frequencies: Vec<f64>,
    /// For each panel a value at each frequency, in the panel's unit (magnitudes without decibels); not finite at a gap.
    pub values: Vec<Vec<f64>>,
    /// Frequencies (Hz) at which it is infinite.
    pub poles: Vec<f64>,
    /// For each panel the value at the cursor, solved there, where it is known; the phase within half a turn. None of a
    /// difference.
    pub at_cursor: Option<Vec<f64>>,
}

/// What is marked on the frequency axis, Hz.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Marked {
    /// The cursor.
    pub cursor: Option<f64>,
    /// The second cursor, from which differences are counted.
    pub second: Option<f64>,
    /// The cursor's harmonics: 2, 3, .. times its frequency.
    pub harmonics: Vec<f64>,
    /// The band whose levels are told.
    pub band: Option<[f64; 2]>,
    /// The modes.
    pub modes: Vec<f64>,
    /// Which of the modes is selected.
    pub mode: Option<usize>,
    /// Whether the modes belong to an older model.
    pub modes_dim: bool,
}

impl ChartView {
    /// Every view, in the order in which a key goes through them.
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

    /// Whether a curve has two values at a frequency.
    pub const fn has_two_panels(self) -> bool {
        matches!(
            self,
            Self::MagnitudePhase | Self::RealImaginary | Self::Nyquist
        )
    }
}

/// What each panel of a view shows of a value; an energy is real and has no phase.
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

/// A level against another one, dB: ten decibels a decade of an energy, twenty else.
pub fn difference(energy: bool, value: Complex64, against: Complex64) -> f64 {
    if energy {
        10.0 * (value.re / against.re).log10()
    } else {
        20.0 * (value.norm() / against.norm()).log10()
    }
}

/// Lets a phase (degrees) run on past half a turn; it starts anew after a gap where it was.
fn unwrap(phase: &mut [f64]) {
    let mut last: Option<f64> = None;
    for value in phase.iter_mut().filter(|value| value.is_finite()) {
        if let Some(last) = last {
            *value -= 360.0 * ((*value - last) / 360.0).round();
        }
        last = Some(*value);
    }
}

/// A number as short as it can be: 1, 1e-12.
fn plain(value: f64) -> String {
    if (1e-3..1e4).contains(&value) {
        format!("{value}")
    } else {
        format!("{value:e}")
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
    fn levels_are_told_against_each_other() {
        // Closed form: a factor of 10 is 20 dB of an amplitude and 10 dB of an energy.
        let (one, ten) = (Complex64::new(0.0, 1.0), Complex64::from(10.0));
        assert!((difference(false, ten, one) - 20.0).abs() < 1e-12);
        assert!((difference(true, ten, Complex64::ONE) - 10.0).abs() < 1e-12);
    }
}

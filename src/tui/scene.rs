//! What stands on the chart, before anything draws it: the widgets on the screen and the exported files both do.

use crate::tui::plot::{Level, LineStyle};

/// The unit in which frequencies are shown and typed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FrequencyUnit {
    /// Hz.
    #[default]
    Hertz,
    /// rad/s.
    RadianPerSecond,
    /// Revolutions per minute.
    RevolutionPerMinute,
}

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
    Witness,
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
    /// For each panel the value at the cursor, solved there, where it is known.
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

impl FrequencyUnit {
    /// Every unit, in the order in which a key goes through them.
    pub const ALL: [Self; 3] = [
        Self::Hertz,
        Self::RadianPerSecond,
        Self::RevolutionPerMinute,
    ];

    /// As it is written.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Hertz => "Hz",
            Self::RadianPerSecond => "rad/s",
            Self::RevolutionPerMinute => "rpm",
        }
    }

    /// How many of it are 1 Hz.
    pub const fn per_hertz(self) -> f64 {
        match self {
            Self::Hertz => 1.0,
            Self::RadianPerSecond => std::f64::consts::TAU,
            Self::RevolutionPerMinute => 60.0,
        }
    }
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
}

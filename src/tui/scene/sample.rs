//! Sample scenes for tests.

use num_complex::Complex64;

use super::{ChartView, CurveKind, FrequencyAxis, Marked, Panel, Scene, SceneCurve};
use crate::tui::plot::{Level, LineStyle};
use crate::unit::FrequencyUnit;

/// A mass on a spring with a loss factor of 0.05 and its resonance at 30 Hz: 1 / (1 - (f / 30)^2 + 0.05 i), m/N.
pub fn receptance(frequency: f64) -> Complex64 {
    Complex64::new(1.0 - (frequency / 30.0).powi(2), 0.05).finv()
}

/// 0.1 to 100 Hz in even steps of 0.1 Hz.
pub fn frequencies() -> Vec<f64> {
    (1..=1000).map(|k| 0.1 * f64::from(k)).collect()
}

fn panel(name: &'static str, unit: &str, level: Level) -> Panel {
    Panel {
        name,
        unit: unit.to_owned(),
        level,
        bounds: None,
    }
}

/// The parts of a value in a view.
fn parts(view: ChartView, value: Complex64) -> Vec<f64> {
    match view {
        ChartView::Magnitude => vec![value.norm()],
        ChartView::MagnitudePhase => vec![value.norm(), value.arg().to_degrees()],
        ChartView::RealImaginary | ChartView::Nyquist => vec![value.re, value.im],
        ChartView::Difference => vec![20.0 * value.norm().log10()],
    }
}

/// A solid curve of the oscillator without a label.
pub fn curve(view: ChartView, kind: CurveKind, frequencies: Vec<f64>) -> SceneCurve {
    let shown: Vec<Vec<f64>> = frequencies
        .iter()
        .map(|f| parts(view, receptance(*f)))
        .collect();
    let panels = parts(view, Complex64::ONE).len();
    SceneCurve {
        label: String::new(),
        kind,
        colour: 0,
        marker: None,
        line: LineStyle::Solid,
        dim: false,
        values: (0..panels)
            .map(|panel| shown.iter().map(|values| values[panel]).collect())
            .collect(),
        frequencies,
        poles: Vec::new(),
        at_cursor: None,
    }
}

/// The oscillator alone, 1 to 100 Hz, with a cursor and a mode at its resonance.
pub fn scene(view: ChartView) -> Scene {
    let panels = match view {
        ChartView::Magnitude => vec![panel("|H|", "m/N", Level::Magnitude)],
        ChartView::MagnitudePhase => vec![
            panel("|H|", "m/N", Level::Magnitude),
            panel("phase", "deg", Level::Degrees),
        ],
        ChartView::RealImaginary | ChartView::Nyquist => vec![
            panel("Re", "m/N", Level::Signed),
            panel("Im", "m/N", Level::Signed),
        ],
        ChartView::Difference => vec![panel("level", "dB", Level::Signed)],
    };
    Scene {
        view,
        title: "w".to_owned(),
        frequency: FrequencyAxis {
            unit: FrequencyUnit::Hertz,
            log: false,
            bounds: [1.0, 100.0],
        },
        panels,
        curves: vec![curve(view, CurveKind::Model, frequencies())],
        spanning: Vec::new(),
        marks: Marked {
            cursor: Some(30.0),
            modes: vec![30.0],
            ..Marked::default()
        },
    }
}

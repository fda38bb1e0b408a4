//! The axes of a scene, and its curves in display units: common to the screen and exported drawings.

use std::borrow::Cow;

use super::{Panel, Scene, SceneCurve};
use crate::tui::panels::readings::nearest as place_of_nearest;
use crate::tui::plot::{self, Axis, Curve, Scale};

/// The relative distance to a pole within which a locus is not drawn: it tends to infinity there.
const NEAR_POLE: f64 = 1e-3;

/// The frequency axis, in its unit.
pub fn frequency_axis(scene: &Scene) -> Axis {
    let frequency = &scene.frequency;
    let scale = if frequency.log {
        Scale::Log
    } else {
        Scale::Linear
    };
    let bounds = frequency.bounds.map(|f| f * frequency.unit.per_hertz());
    Axis::new(scale, bounds, frequency.unit.symbol())
}

/// The label of a value axis: "phase, deg".
pub fn heading(panel: &Panel) -> String {
    let words = [panel.name, &panel.unit].into_iter();
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    words.join(", ")
}

/// The curves of a scene over frequencies in the displayed unit.
#[derive(Debug)]
pub struct Ruled<'s> {
    /// The scene.
    pub scene: &'s Scene,
    curves: Vec<Cow<'s, [f64]>>,
    spanning: Vec<Cow<'s, [f64]>>,
}

impl<'s> Ruled<'s> {
    /// Converts the frequencies of all curves to the displayed unit.
    pub fn new(scene: &'s Scene) -> Self {
        let per_hertz = scene.frequency.unit.per_hertz();
        let shown = |curve: &'s SceneCurve| {
            if per_hertz == 1.0 {
                Cow::Borrowed(curve.frequencies.as_slice())
            } else {
                curve.frequencies.iter().map(|f| f * per_hertz).collect()
            }
        };
        Self {
            scene,
            curves: scene.curves.iter().map(shown).collect(),
            spanning: scene.spanning.iter().map(shown).collect(),
        }
    }

    /// The curves that have values on a panel, each with its index in the scene.
    pub fn curves(&self, panel: usize) -> impl Iterator<Item = (usize, Curve<'_>)> {
        let each = self.scene.curves.iter().zip(&self.curves).enumerate();
        each.filter_map(move |(index, (curve, x))| Some((index, self.curve(curve, x, panel)?)))
    }

    /// The value axis of a panel: fixed, or automatic.
    pub fn value_axis(&self, panel: usize) -> Axis {
        let shown = &self.scene.panels[panel];
        if let Some(bounds) = shown.bounds {
            return shown.level.axis_between(bounds, heading(shown));
        }
        let each = self.scene.spanning.iter().zip(&self.spanning);
        let others = each.filter_map(|(curve, x)| self.curve(curve, x, panel));
        let drawn = self.curves(panel).map(|(_, curve)| curve);
        let all: Vec<Curve<'_>> = drawn.chain(others).collect();
        let x = frequency_axis(self.scene);
        shown.level.axis(&all, &x, heading(shown))
    }

    fn curve<'a>(&self, curve: &'a SceneCurve, x: &'a [f64], panel: usize) -> Option<Curve<'a>> {
        let per_hertz = self.scene.frequency.unit.per_hertz();
        Some(Curve {
            poles: curve.poles.iter().map(|f| f * per_hertz).collect(),
            ..Curve::new(x, curve.values.get(panel)?)
        })
    }
}

/// The curves of a scene with the values of the first panel as abscissae and of the second as ordinates.
#[derive(Debug)]
pub struct Loci {
    /// Abscissae and ordinates of each curve.
    pub points: Vec<[Vec<f64>; 2]>,
    /// The axes, horizontal and vertical, before they are made equal.
    pub axes: [Axis; 2],
}

impl Loci {
    /// The loci of a scene with two panels; none for another one.
    pub fn new(scene: &Scene) -> Option<Self> {
        let [across, up] = scene.panels.as_slice() else {
            return None;
        };
        let of = |curves: &[SceneCurve]| -> Vec<[Vec<f64>; 2]> {
            curves.iter().map(|curve| points(curve, scene)).collect()
        };
        let (points, spanning) = (of(&scene.curves), of(&scene.spanning));
        let all = points.iter().chain(&spanning);
        let all: Vec<Curve<'_>> = all.map(|[x, y]| Curve::new(x, y)).collect();
        let bounds = [across.bounds, up.bounds];
        let axes = plot::nyquist_axes(&all, bounds, [heading(across), heading(up)]);
        Some(Self { points, axes })
    }
}

/// The points of a locus within the frequency bounds; gaps at poles.
fn points(curve: &SceneCurve, scene: &Scene) -> [Vec<f64>; 2] {
    let [low, high] = scene.frequency.bounds;
    let [Some(across), Some(up)] = [0, 1].map(|panel| curve.values.get(panel)) else {
        return [Vec::new(), Vec::new()];
    };
    let at_pole = |f: f64| {
        let mut poles = curve.poles.iter();
        poles.any(|pole| (f - pole).abs() < NEAR_POLE * pole)
    };
    let samples = curve.frequencies.iter().zip(across.iter().zip(up));
    let inside = samples.filter(|(f, _)| (low..=high).contains(*f));
    let (x, y) = inside
        .map(|(f, (x, y))| {
            if at_pole(*f) {
                (f64::NAN, f64::NAN)
            } else {
                (*x, *y)
            }
        })
        .unzip();
    [x, y]
}

/// The point of a curve nearest to a frequency (Hz), if within the bounds.
pub fn nearest(curve: &SceneCurve, frequency: f64, scene: &Scene) -> Option<(f64, f64)> {
    let [low, high] = scene.frequency.bounds;
    if !(low..=high).contains(&frequency) {
        return None;
    }
    let index = place_of_nearest(&curve.frequencies, frequency)?;
    let value = |panel: usize| curve.values.get(panel)?.get(index).copied();
    value(0).zip(value(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::scene::ChartView;
    use crate::tui::scene::sample::scene;

    #[test]
    fn a_pole_is_a_gap_of_a_locus() {
        // An undamped oscillator with its resonance at 30 Hz: 1 / (1 - (f / 30)^2).
        let real = |f: f64| 1.0 / (1.0 - (f / 30.0).powi(2));
        let frequencies: Vec<f64> = (1..=1000).map(|k| 0.1 * f64::from(k) + 1e-6).collect();
        let mut scene = scene(ChartView::Nyquist);
        scene.frequency.bounds = [1.0, 50.0];
        let curve = &mut scene.curves[0];
        curve.values = vec![
            frequencies.iter().map(|f| real(*f)).collect(),
            vec![0.0; 1000],
        ];
        curve.frequencies = frequencies;
        curve.poles = vec![30.0];
        let loci = Loci::new(&scene).unwrap();
        let [x, y] = &loci.points[0];
        // From 1.000001 to 49.900001 Hz.
        assert_eq!((x.len(), y.len()), (490, 490));
        assert_eq!(x.iter().filter(|x| x.is_nan()).count(), 1);
        let finite = x.iter().filter(|x| x.is_finite());
        let furthest = finite.fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!((furthest - real(29.9 + 1e-6)).abs() < 1e-9, "{furthest}");
    }
}

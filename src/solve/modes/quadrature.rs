//! Integrals along the beam of products of modes: Gauss-Legendre between the stations, fine against every wave.

use num_complex::Complex64;

use crate::model::Model;
use crate::solve::waves::{BeamConstants, Waves};

/// A place and its weight.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// m from the left end.
    pub(super) position: f64,
    /// m.
    pub(super) weight: f64,
}

/// Nodes and weights of the rule with eight points on [-1, 1], its positive half.
const RULE: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_26),
];

/// Places and weights that integrate the product of two modes near `omega` (rad/s).
pub(super) fn samples(model: &Model, omega: Complex64) -> Vec<Sample> {
    let waves = Waves::new(&BeamConstants::new(&model.beam), omega);
    let finite = || waves.kappa.iter().filter(|kappa| kappa.is_finite());
    let shortest = Shortest {
        wave: finite().map(|kappa| kappa.norm()).fold(0.0, f64::max),
        travelling: finite().map(|kappa| kappa.im.abs()).fold(0.0, f64::max),
    };
    let mut places: Vec<f64> = model
        .attached()
        .map(|subsystem| subsystem.position)
        .chain([0.0, model.beam.length])
        .collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
        .windows(2)
        .flat_map(|pair| span(pair[0], pair[1], shortest))
        .collect()
}

/// The largest wave numbers, 1/m.
#[derive(Debug, Clone, Copy)]
struct Shortest {
    /// Of any wave.
    wave: f64,
    /// Of the waves that do not only decay.
    travelling: f64,
}

/// The samples of a span.
fn span(from: f64, to: f64, shortest: Shortest) -> Vec<Sample> {
    // In a panel this long against the shortest wave the rule is exact to rounding. The warping near an end may decay
    // faster than any panel; it then holds no energy.
    const PANEL: f64 = 1.5;
    const MOST_PANELS: f64 = 400.0;
    let panels = |wave_number: f64| ((to - from) * wave_number / PANEL).ceil();
    let panels = panels(shortest.wave)
        .min(MOST_PANELS)
        .max(panels(shortest.travelling))
        .max(1.0);
    let half = 0.5 * (to - from) / panels;
    let mut samples = Vec::new();
    for panel in 0..panels as usize {
        let middle = from + half * (2 * panel + 1) as f64;
        for (node, weight) in RULE {
            for side in [-1.0, 1.0] {
                samples.push(Sample {
                    position: middle + side * node * half,
                    weight: weight * half,
                });
            }
        }
    }
    samples
}

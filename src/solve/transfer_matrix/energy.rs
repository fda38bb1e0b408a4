//! The vibration energy by quadrature over the chain's own shape functions.

use super::{Chain, DISPLACEMENTS, Solution};

/// Nodes and weights of Gauss and Legendre's rule of eight points on [-1, 1], the positive half (Abramowitz & Stegun
/// 1964, Table 25.4); exact to the degree 15.
const RULE: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];
/// The most that beta x grows in a panel: the rule is then right to the last digits.
const PANEL: f64 = 1.0;

/// `E_V` = int rho A (|W|^2 + |V|^2) + rho `I_0` |Psi|^2 dx (Section 4.2), kg m2.
pub(super) fn of(chain: &Chain, solution: &Solution) -> f64 {
    let beam = &chain.layout.model.beam;
    let density = beam.material.density;
    let mass = density * beam.section.area;
    let inertias = [mass, density * beam.section.polar_moment, mass];
    let at = |segment: usize, x: f64| -> f64 {
        let state = solution.shapes.derivatives(x) * solution.constants[segment];
        let moved = DISPLACEMENTS.iter().zip(inertias);
        moved
            .map(|(&row, inertia)| inertia * state[row].norm_sqr())
            .sum()
    };
    let mut sum = 0.0;
    for (segment, &length) in chain.lengths.iter().enumerate() {
        let panels = (solution.shapes.largest() * length / PANEL).ceil().max(1.0) as usize;
        let half = 0.5 * length / panels as f64;
        for panel in 0..panels {
            let middle = (2 * panel + 1) as f64 * half;
            for (node, weight) in RULE {
                let pair = at(segment, middle - half * node) + at(segment, middle + half * node);
                sum += half * weight * pair;
            }
        }
    }
    sum
}

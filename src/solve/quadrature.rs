//! Quadrature along the beam: nodes and weights for integrals of the product of two solutions, exact to rounding.

use num_complex::Complex64;

/// The length of a panel relative to a wave: 16 points integrate the product of two such waves to 1e-15, according to
/// the error term of the rule for `exp(14 t)` over [0, 1].
const PANEL: f64 = 7.0;

/// A wave that has decayed by exp(-37) is negligible.
const GONE: f64 = 37.0;

/// Positive nodes on [-1, 1] and weights of the 16-point Gauss-Legendre rule.
///
/// Source: Abramowitz & Stegun, Handbook of Mathematical Functions (1964), Table 25.4.
const RULE: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];

/// A node and its weight.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// m from the left end.
    pub(super) x: f64,
    /// m.
    pub(super) weight: f64,
}

/// The nodes between stations on a beam, by ascending position; `stations` and the length in m, the stations ascending.
/// `kappa` are the wave numbers of all of its beams, 1/m.
pub(super) fn nodes(
    stations: impl IntoIterator<Item = f64>,
    kappa: &[Complex64],
    length: f64,
) -> Vec<Node> {
    let mut nodes = Vec::new();
    let mut from = 0.0;
    for to in stations.into_iter().chain([length]) {
        for panel in panels(to - from, kappa).windows(2) {
            let (middle, half) = (0.5 * (panel[0] + panel[1]), 0.5 * (panel[1] - panel[0]));
            let mirrored = RULE.iter().rev().map(|&(node, weight)| (-node, weight));
            nodes.extend(mirrored.chain(RULE).map(|(node, weight)| Node {
                x: from + middle + half * node,
                weight: weight * half,
            }));
        }
        from = to;
    }
    nodes
}

/// The ends of the panels of a span, m from its left end: short near the ends of the span, where evanescent waves are
/// large.
fn panels(length: f64, kappa: &[Complex64]) -> Vec<f64> {
    if length <= 0.0 {
        return Vec::new();
    }
    let longest = |x: f64| {
        let alive = kappa
            .iter()
            .filter(|kappa| kappa.is_finite() && kappa.re * x < GONE);
        PANEL / alive.map(|kappa| kappa.norm()).fold(0.0, f64::max)
    };
    if length <= longest(0.0) {
        return vec![0.0, length];
    }
    let (mut x, mut left) = (0.0, Vec::new());
    while x < 0.5 * length {
        left.push(x);
        x += longest(x);
    }
    let right: Vec<f64> = left.iter().rev().map(|x| length - x).collect();
    left.push(0.5 * length);
    left.into_iter().chain(right).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_is_exact_for_polynomials_of_its_degree() {
        // Closed form: int x^n over [-1, 1] is 2 / (n + 1) for even n, up to degree 31 of 16 points.
        for degree in (0..=30).step_by(2) {
            let sum: f64 = RULE
                .iter()
                .map(|(x, weight)| 2.0 * weight * x.powi(degree))
                .sum();
            assert!(
                (sum - 2.0 / f64::from(degree + 1)).abs() < 1e-15,
                "{degree}"
            );
        }
    }

    #[test]
    fn panels_integrate_what_decays_at_once_and_what_travels() {
        // Closed form: int (exp(-k x) + exp(-k (l - x)))^2 dx = (1 - exp(-2 k l)) / k + 2 l exp(-k l), k real or
        // imaginary.
        let length = 3.0;
        let waves = [Complex64::new(4e3, 0.0), Complex64::new(0.0, 30.0)];
        let mut kappa = [Complex64::new(0.0, 1.0); 6];
        kappa[..2].copy_from_slice(&waves);
        let ends = panels(length, &kappa);
        assert!(ends.is_sorted() && ends.len() < 60, "{}", ends.len());
        for k in waves {
            let mut sum = Complex64::ZERO;
            for panel in ends.windows(2) {
                let (middle, half) = (0.5 * (panel[0] + panel[1]), 0.5 * (panel[1] - panel[0]));
                for (node, weight) in RULE.into_iter().flat_map(|(x, w)| [(x, w), (-x, w)]) {
                    let x = middle + half * node;
                    let value = (-k * x).exp() + (-k * (length - x)).exp();
                    sum += weight * half * value * value;
                }
            }
            let exact = (1.0 - (-2.0 * k * length).exp()) / k + 2.0 * length * (-k * length).exp();
            assert!(
                (sum - exact).norm() < 5e-12 * exact.norm(),
                "{k}: {sum} {exact}"
            );
        }
    }
}

//! Den Hartog's damped absorber on an undamped mass: the lowest maximum of the peaks, in two variables.

use beamtune::solve::Cancelled;
use beamtune::tune::search::{Evaluation, Function, Landscape, Merit};

use super::{downhill, everywhere};

/// The mass of the absorber in masses of the main system.
const MU: f64 = 0.05;

/// Tuning ratio 0.5 to 1.5, damping c / (2 m omega) 0 to 0.6.
struct Absorber;

impl Absorber {
    fn real(x: &[f64]) -> [f64; 2] {
        [0.5 + x[0], 0.6 * x[1]]
    }

    /// |x1| / static deflection at a forcing ratio g, and its derivatives by f and zeta at that g (Den Hartog, Mechanical
    /// Vibrations, 4th ed., 1956, equation 3.24).
    fn magnification(g: f64, [f, zeta]: [f64; 2]) -> [f64; 3] {
        let damping = (2.0 * zeta * g).powi(2);
        let (a, b) = (g * g - f * f, g * g * (1.0 + MU) - 1.0);
        let c = MU * f * f * g * g - (g * g - 1.0) * a;
        let (above, below) = (damping + a * a, damping * b * b + c * c);
        let by_zeta = 8.0 * zeta * g * g;
        let c_by_f = 2.0 * f * (MU * g * g + g * g - 1.0);
        let value = (above / below).sqrt();
        let slope =
            |above_by: f64, below_by: f64| 0.5 * value * (above_by / above - below_by / below);
        [
            value,
            slope(-4.0 * f * a, 2.0 * c * c_by_f),
            slope(by_zeta, by_zeta * b * b),
        ]
    }

    /// Forcing ratios of the peaks: bracketed on a grid, found by golden section.
    fn peaks(at: [f64; 2]) -> Vec<f64> {
        let value = |g: f64| Self::magnification(g, at)[0];
        let grid: Vec<f64> = (0..600).map(|i| 0.4 + 0.0025 * f64::from(i)).collect();
        let turns = grid
            .windows(3)
            .filter(|g| value(g[0]) < value(g[1]) && value(g[1]) >= value(g[2]));
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        turns
            .map(|g| {
                let (mut left, mut right) = (g[0], g[2]);
                for _ in 0..60 {
                    let step = golden * (right - left);
                    if value(right - step) >= value(left + step) {
                        right = left + step;
                    } else {
                        left = right - step;
                    }
                }
                0.5 * (left + right)
            })
            .collect()
    }
}

impl Landscape for Absorber {
    fn variables(&self) -> usize {
        2
    }

    fn merit(&self, x: &[f64]) -> Result<Merit, Cancelled> {
        self.evaluate(x).map(|evaluation| evaluation.merit())
    }

    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, Cancelled> {
        let at = Self::real(x);
        let peaks = Self::peaks(at).into_iter().map(|g| {
            let [value, by_f, by_zeta] = Self::magnification(g, at);
            Function {
                value,
                gradient: vec![by_f, 0.6 * by_zeta],
            }
        });
        Ok(Evaluation {
            terms: vec![peaks.collect()],
            limits: Vec::new(),
        })
    }
}

/// The optimum of the closed form, computed once with independent arithmetic (60 digits): 0.95237, 0.12756 and 6.4079. Den
/// Hartog's formulas 1/(1 + mu), sqrt(3 mu / (8 (1 + mu)^3)) and sqrt(1 + 2/mu) are near it.
fn is_optimum(x: &[f64], goal: f64) {
    let [tuning, damping] = Absorber::real(x);
    assert!((tuning - 0.952_37).abs() < 1e-5, "{tuning}");
    assert!((damping - 0.127_56).abs() < 1e-5, "{damping}");
    assert!((goal - 6.407_9).abs() < 1e-4, "{goal}");
    assert!((tuning * (1.0 + MU) - 1.0).abs() < 1e-4);
    let formula = (3.0 * MU / (8.0 * (1.0 + MU).powi(3))).sqrt();
    assert!((damping / formula - 1.0).abs() < 3e-3);
    assert!((goal / (1.0 + 2.0 / MU).sqrt() - 1.0).abs() < 1e-3);
}

#[test]
fn the_absorber_is_found_downhill_from_anywhere_near() {
    for start in [[0.5, 0.1], [0.3, 0.3], [0.45, 0.9], [0.9, 0.2]] {
        let found = downhill(&Absorber, &start, 60);
        is_optimum(&found.x, found.merit.goal);
    }
}

#[test]
fn the_absorber_is_found_from_no_damping_and_wrong_tuning() {
    for seed in 1..=5 {
        let found = everywhere(&Absorber, &[0.0, 0.0], 400, seed);
        is_optimum(&found.x, found.merit.goal);
    }
}

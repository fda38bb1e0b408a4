//! Integrals over the beam of the product of two fields, in closed form.
//!
//! As in `energy`, but bilinear: no conjugate. With amplitudes a at a span's left end and b at its right end a field is
//! `Q (exp(-kappa x) a + exp(-kappa (l - x)) b)`, so that products are sums over pairs of waves; each integral
//! weighs them with its own shapes.

use num_complex::Complex64;

use crate::solve::energy::mean_decay;
use crate::solve::linear::{Matrix, ZERO, zeros};
use crate::solve::plan::Plan;
use crate::solve::solution::{Solution, SpanWaves};
use crate::solve::waves::Amplitudes;
use crate::solve::waves::{WARPING_WAVE, Waves};

/// The blocks of waves with common motions: those of w and psi, and those of v.
const BLOCKS: [std::ops::Range<usize>; 2] = [0..4, 4..6];

/// Integrals along the whole beam of products of two fields, each m times the unit of the product.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Overlap {
    /// w'' w''.
    pub(super) bending_w: Complex64,
    /// v'' v''.
    pub(super) bending_v: Complex64,
    /// psi'' psi''.
    pub(super) warping: Complex64,
    /// psi' psi'.
    pub(super) torsion: Complex64,
    /// w w + v v.
    pub(super) translation: Complex64,
    /// w psi + psi w.
    pub(super) coupling: Complex64,
    /// psi psi.
    pub(super) rotation: Complex64,
}

/// The integrals over a span of each pair of waves.
#[derive(Debug)]
struct Pairs {
    /// Waves that travel in the same direction.
    same: Matrix<6, 6>,
    /// Waves that travel in opposite directions.
    against: Matrix<6, 6>,
}

/// The integrals over each distinct span length of a plan, at one frequency.
#[derive(Debug)]
pub(super) struct Spans {
    pairs: Vec<Pairs>,
}

impl Spans {
    /// Those of a solution.
    pub(super) fn new(plan: &Plan, solution: &Solution) -> Self {
        let each = plan.lengths.iter().zip(&solution.decays);
        Self {
            pairs: each
                .map(|(&length, decay)| Pairs::new(&solution.waves, length, decay))
                .collect(),
        }
    }

    /// The integrals of the product of two fields of the plan.
    pub(super) fn overlap(
        &self,
        plan: &Plan,
        waves: &Waves,
        [one, other]: [&[SpanWaves]; 2],
    ) -> Overlap {
        let (mut same, mut against) = (zeros::<6, 6>(), zeros::<6, 6>());
        for ((one, other), &span) in one.iter().zip(other).zip(&plan.spans) {
            let pairs = &self.pairs[span];
            for block in BLOCKS {
                for i in block.clone() {
                    for j in block.clone() {
                        same[i][j] +=
                            pairs.same[i][j] * (one.a[i] * other.a[j] + one.b[i] * other.b[j]);
                        against[i][j] +=
                            pairs.against[i][j] * (one.a[i] * other.b[j] + one.b[i] * other.a[j]);
                    }
                }
            }
        }
        weighed(waves, &same, &against)
    }
}

impl Pairs {
    fn new(waves: &Waves, length: f64, decay: &Amplitudes) -> Self {
        let mut pairs = Self {
            same: zeros(),
            against: zeros(),
        };
        for block in BLOCKS {
            for i in block.clone() {
                for j in block.clone() {
                    // A wave that decays at once does not contribute to an integral.
                    if waves.without_warping() && (i == WARPING_WAVE || j == WARPING_WAVE) {
                        continue;
                    }
                    let kappa = [waves.kappa[i], waves.kappa[j]];
                    let decay = [decay[i], decay[j]];
                    pairs.same[i][j] = same(kappa, decay, length);
                    pairs.against[i][j] = against(kappa, decay, length);
                }
            }
        }
        pairs
    }
}

/// Below this |z| the closed form `(1 - exp(-z)) / z` cancels.
const CANCELS: f64 = 0.5;

/// int exp(-(k0 + k1) x) dx over a length.
fn same(kappa: [Complex64; 2], decay: [Complex64; 2], length: f64) -> Complex64 {
    let sum = kappa[0] + kappa[1];
    let z = sum * length;
    if z.norm_sqr() > CANCELS * CANCELS {
        (1.0 - decay[0] * decay[1]) / sum
    } else {
        length * mean_decay(z)
    }
}

/// int exp(-k0 x) exp(-k1 (l - x)) dx over a length.
fn against(kappa: [Complex64; 2], decay: [Complex64; 2], length: f64) -> Complex64 {
    let difference = kappa[0] - kappa[1];
    let z = difference * length;
    if z.norm_sqr() > CANCELS * CANCELS {
        (decay[1] - decay[0]) / difference
    } else {
        length * decay[1] * mean_decay(z)
    }
}

/// The integrals from the sums over the spans of each pair of waves.
fn weighed(waves: &Waves, same: &Matrix<6, 6>, against: &Matrix<6, 6>) -> Overlap {
    let [w, psi, v] = &waves.displacement;
    let kappa = finite(waves);
    let mut sums = Overlap::default();
    for block in BLOCKS {
        for i in block.clone() {
            for j in block.clone() {
                let (even, odd) = (same[i][j] + against[i][j], same[i][j] - against[i][j]);
                let rates = kappa[i] * kappa[j];
                let squares = rates * rates;
                sums.bending_w += squares * w[i] * w[j] * even;
                sums.bending_v += squares * v[i] * v[j] * even;
                sums.warping += squares * psi[i] * psi[j] * even;
                // The rate of twist of a left-going wave has the opposite sign.
                sums.torsion += rates * psi[i] * psi[j] * odd;
                sums.translation += (w[i] * w[j] + v[i] * v[j]) * even;
                sums.coupling += (w[i] * psi[j] + psi[i] * w[j]) * even;
                sums.rotation += psi[i] * psi[j] * even;
            }
        }
    }
    sums
}

/// The wave numbers, with 0 instead of an infinite one: its shape is also 0.
fn finite(waves: &Waves) -> Amplitudes {
    let mut kappa = waves.kappa;
    if waves.without_warping() {
        kappa[WARPING_WAVE] = ZERO;
    }
    kappa
}

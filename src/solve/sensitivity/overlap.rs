//! Integrals over the beam of the product of two fields, in closed form.
//!
//! As for the energies of the kernel, but bilinear: no conjugate. With amplitudes a at a span's left end and b at its right end a field is
//! `Q (exp(-kappa x) a + exp(-kappa (l - x)) b)`, so that products are sums over pairs of waves; each integral
//! weighs them with its own shapes.

use num_complex::Complex64;

use crate::solve::beam_matrices::BeamMatrices;
use crate::solve::linear::{Matrix, ZERO, zeros};
use crate::solve::plan::Plan;
use crate::solve::solution::{Solution, SpanWaves};
use crate::solve::waves::Amplitudes;
use crate::solve::waves::{WARPING_WAVE, Waves};

/// Integrals along a uniform part of the beam of the products of two fields, over (w, psi, v) of the one and of the other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Overlap {
    /// Index of the beam.
    pub(super) beam: usize,
    /// Of s', the derivatives of the rotations.
    curvature: [[Complex64; 3]; 3],
    /// Of q', the slopes of the axis.
    slope: [[Complex64; 3]; 3],
    /// Of s, the rotations of the section: the slopes without shear deformation.
    rotation: [[Complex64; 3]; 3],
    /// Of the shear forces; 0 without shear deformation.
    shear: [[Complex64; 3]; 3],
    /// Of the motions.
    motion: [[Complex64; 3]; 3],
}

impl Overlap {
    /// The change of the form of the beam with its matrices, with the rotations s and the shear forces g of both fields:
    ///
    /// ```text
    /// int s'^T dD s' + q'^T dC q' - g^T dF g - omega^2 (q^T dM q + s^T dR s) dx
    /// ```
    pub(super) fn form(&self, matrices: &BeamMatrices, omega: Complex64) -> Complex64 {
        let strain = matrices.bending.on(&self.curvature) + matrices.tension.on(&self.slope);
        strain - matrices.shear.on(&self.shear) - omega * omega * self.inertia(matrices)
    }

    /// `int lambda u dx` of w, psi and v.
    pub(super) fn motions(&self) -> [Complex64; 3] {
        [0, 1, 2].map(|row| self.motion[row][row])
    }

    /// `int lambda^T M u + lambda_s^T R u_s dx`.
    pub(super) fn inertia(&self, matrices: &BeamMatrices) -> Complex64 {
        matrices.mass.on(&self.motion) + matrices.rotary.on(&self.rotation)
    }
}

/// The integrals over a span of each pair of waves.
#[derive(Debug)]
struct Pairs {
    /// Waves that travel in the same direction.
    same: Matrix<6, 6>,
    /// Waves that travel in opposite directions.
    against: Matrix<6, 6>,
}

/// The integrals over each kind of span of a plan, at one frequency.
#[derive(Debug)]
pub(super) struct Spans {
    pairs: Vec<Pairs>,
}

impl Spans {
    /// Those of a solution.
    pub(super) fn new(plan: &Plan, solution: &Solution) -> Self {
        let each = plan.kinds.iter().zip(&solution.decays);
        let pairs =
            each.map(|(kind, decay)| Pairs::new(&solution.waves[kind.beam], kind.length, decay));
        Self {
            pairs: pairs.collect(),
        }
    }

    /// The integrals of the product of two fields of the plan over each of its uniform parts.
    pub(super) fn overlaps(
        &self,
        plan: &Plan,
        waves: &[Waves],
        [one, other]: [&[SpanWaves]; 2],
    ) -> Vec<Overlap> {
        let parts = plan.parts();
        let count = parts.last().map_or(0, |last| last + 1);
        let mut sums = vec![(zeros::<6, 6>(), zeros::<6, 6>()); count];
        let mut beams = vec![0; count];
        let fields = one.iter().zip(other).zip(&plan.spans);
        for (((one, other), &span), part) in fields.zip(parts) {
            beams[part] = plan.kinds[span].beam;
            let pairs = &self.pairs[span];
            let (same, against) = &mut sums[part];
            for i in 0..6 {
                for j in 0..6 {
                    same[i][j] +=
                        pairs.same[i][j] * (one.a[i] * other.a[j] + one.b[i] * other.b[j]);
                    against[i][j] +=
                        pairs.against[i][j] * (one.a[i] * other.b[j] + one.b[i] * other.a[j]);
                }
            }
        }
        let parts = sums.iter().zip(beams);
        let overlaps = parts.map(|((same, against), beam)| Overlap {
            beam,
            ..weighed(&waves[beam], &plan.beams[beam].matrices, same, against)
        });
        overlaps.collect()
    }
}

impl Pairs {
    fn new(waves: &Waves, length: f64, decay: &Amplitudes) -> Self {
        let mut pairs = Self {
            same: zeros(),
            against: zeros(),
        };
        for i in 0..6 {
            for j in 0..6 {
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
fn weighed(
    waves: &Waves,
    matrices: &BeamMatrices,
    same: &Matrix<6, 6>,
    against: &Matrix<6, 6>,
) -> Overlap {
    let kappa = finite(waves);
    let has_shear = matrices.has_shear();
    // q, s and g of each wave.
    let (q, s) = (&waves.displacement, &waves.slope);
    let pulled = kappa.iter().enumerate().map(|(wave, kappa)| {
        let shape = [q[0][wave], q[1][wave], q[2][wave]];
        matrices.tension.times(shape).map(|pull| kappa * pull)
    });
    let pulled: Vec<[Complex64; 3]> = pulled.collect();
    let g = |row: usize, wave: usize| waves.force[row][wave] + pulled[wave][row];
    let mut sums = Overlap {
        beam: 0,
        curvature: zeros(),
        slope: zeros(),
        rotation: zeros(),
        shear: zeros(),
        motion: zeros(),
    };
    for i in 0..6 {
        for j in 0..6 {
            // Slopes, rotations and forces of a left-going wave have the opposite sign.
            let (even, odd) = (same[i][j] + against[i][j], same[i][j] - against[i][j]);
            let rates = kappa[i] * kappa[j];
            for row in 0..3 {
                for column in 0..3 {
                    let moved = q[row][i] * q[column][j];
                    sums.motion[row][column] += even * moved;
                    sums.slope[row][column] += odd * rates * moved;
                    let turned = if has_shear {
                        let turned = s[row][i] * s[column][j];
                        sums.rotation[row][column] += odd * turned;
                        sums.shear[row][column] += odd * g(row, i) * g(column, j);
                        rates * turned
                    } else {
                        rates * rates * moved
                    };
                    sums.curvature[row][column] += even * turned;
                }
            }
        }
    }
    if !has_shear {
        sums.rotation = sums.slope;
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

/// (1 - exp(-z)) / z, also near z = 0.
fn mean_decay(z: Complex64) -> Complex64 {
    const SERIES_BELOW: f64 = 0.5;
    if z.norm() > SERIES_BELOW {
        return (1.0 - (-z).exp()) / z;
    }
    // 1 - z/2 (1 - z/3 (1 - ...)): after 16 terms the remainder is below 1e-18.
    (2..=17)
        .rev()
        .fold(Complex64::ONE, |sum, k| 1.0 - sum * z / f64::from(k))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_decay_agrees_on_both_sides_of_its_switch() {
        // Closed form: (1 - e^-z)/z at z = 0.5 and on the unit circle of radius 0.5.
        assert!((mean_decay(Complex64::new(0.5, 0.0)).re - 0.786_938_680_574_733_1).abs() < 1e-15);
        assert_eq!(mean_decay(ZERO), Complex64::ONE);
        for angle in 0..8 {
            let z = Complex64::from_polar(0.5, f64::from(angle));
            let direct = (1.0 - (-z).exp()) / z;
            assert!((mean_decay(z) - direct).norm() < 1e-15);
        }
    }
}

//! The vibration energy `E_V` and the strain energy in closed form: integrals of products of exponentials.

use num_complex::Complex64;

use super::linear::{Matrix, ZERO, zeros};
use super::plan::Plan;
use super::solution::{Solution, SpanWaves};
use super::waves::{Amplitudes, BeamConstants, Waves};

/// The energy forms of each kind of span at one frequency.
///
/// With amplitudes a at the span's left end and b at its right end the displacements are
/// `Q (exp(-kappa x) a + exp(-kappa (l - x)) b)`, so that the energy is the Hermitian form
/// `a* A a + b* A b + 2 Re(a* C b)` with the weighted shapes and the integrals over the span.
#[derive(Debug)]
pub(super) struct SpanEnergy {
    forms: Vec<Form>,
}

/// The Hermitian form of a span.
#[derive(Debug)]
struct Form {
    /// A: waves that travel in the same direction.
    same: Matrix<6, 6>,
    /// C: waves that travel in opposite directions.
    against: Matrix<6, 6>,
}

impl SpanEnergy {
    /// The forms of `E_V`, kg m2 (times the square of the loads' unit).
    pub(super) fn vibration(plan: &Plan, solution: &Solution) -> Self {
        Self::new(plan, solution, inertia_weights)
    }

    /// The forms of what the loss factor of the material dissipates in a radian, twice: `int s'^H Im(D) s' + Im(G J)
    /// |psi'|^2 - g^H Im(F) g dx` with the shear forces g.
    ///
    /// Source: the strain energy of Vlasov's beam, as Chen & Liu 2022, Section 2, derive their equations from; an axial
    /// force dissipates nothing.
    pub(super) fn dissipation(plan: &Plan, solution: &Solution) -> Self {
        Self::new(plan, solution, dissipation_weights)
    }

    /// The forms of `int c |q|^2 dx` of a motion: 0 of w, 1 of psi, 2 of v; with a factor c of each beam.
    pub(super) fn square(
        plan: &Plan,
        solution: &Solution,
        row: usize,
        factor: impl Fn(&BeamConstants) -> f64,
    ) -> Self {
        Self::new(plan, solution, |beam, waves| {
            let (q, factor) = (&waves.displacement[row], factor(beam));
            let mut same = zeros::<6, 6>();
            for i in 0..6 {
                for j in 0..6 {
                    same[i][j] = factor * q[i].conj() * q[j];
                }
            }
            let against = same;
            Weights { same, against }
        })
    }

    fn new(
        plan: &Plan,
        solution: &Solution,
        weights: impl Fn(&BeamConstants, &Waves) -> Weights,
    ) -> Self {
        let beams = plan.beams.iter().zip(&solution.waves);
        let weights: Vec<Weights> = beams.map(|(beam, waves)| weights(beam, waves)).collect();
        let kinds = plan.kinds.iter().zip(&solution.decays);
        let forms = kinds.map(|(kind, decay)| {
            let waves = &solution.waves[kind.beam];
            form(waves, &weights[kind.beam], kind.length, decay)
        });
        Self {
            forms: forms.collect(),
        }
    }

    /// The energy of all spans.
    pub(super) fn total(&self, plan: &Plan, spans: &[SpanWaves]) -> f64 {
        let mut sum = Sum::default();
        for (waves, &span) in spans.iter().zip(&plan.spans) {
            sum.add(self.of(span, &waves.a, &waves.b));
        }
        sum.resolved()
    }

    /// The energy of a span: a at its left end, b at its right end.
    fn of(&self, span: usize, a: &Amplitudes, b: &Amplitudes) -> Sum {
        let form = &self.forms[span];
        let mut sum = Sum::default();
        for i in 0..6 {
            for j in 0..6 {
                let same = a[i].conj() * a[j] + b[i].conj() * b[j];
                let against = 2.0 * a[i].conj() * b[j];
                for term in [form.same[i][j] * same, form.against[i][j] * against] {
                    sum.value += term.re;
                    sum.terms += term.re.abs();
                }
            }
        }
        sum
    }
}

/// The smallest accepted ratio of an energy to the sum of the magnitudes of its terms.
pub(super) const LEAST_SHARE: f64 = 1e-12;

/// A sum, and the sum of the magnitudes of its terms.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    value: f64,
    terms: f64,
}

impl Sum {
    /// Adds another sum.
    fn add(&mut self, other: Self) {
        self.value += other.value;
        self.terms += other.terms;
    }

    /// The sum; NaN if its terms cancel to their last digits, as on a beam that is very short compared with its waves.
    fn resolved(self) -> f64 {
        if self.value < LEAST_SHARE * self.terms {
            f64::NAN
        } else {
            self.value
        }
    }
}

/// The factors of the product of each pair of waves.
struct Weights {
    /// Waves that travel in the same direction.
    same: Matrix<6, 6>,
    /// Waves that travel in opposite directions.
    against: Matrix<6, 6>,
}

/// The form of `E_V` of each pair of waves.
fn inertia_weights(beam: &BeamConstants, waves: &Waves) -> Weights {
    let form = beam.vibration();
    let shapes: [[Complex64; 3]; 6] =
        std::array::from_fn(|wave| [0, 1, 2].map(|row| waves.displacement[row][wave]));
    let moved = shapes.map(|shape| form.times(shape));
    let mut same = zeros::<6, 6>();
    for i in 0..6 {
        for j in 0..6 {
            let products = shapes[i].iter().zip(moved[j]);
            same[i][j] = products.map(|(shape, moved)| shape.conj() * moved).sum();
        }
    }
    Weights {
        same,
        against: same,
    }
}

/// The dissipation in bending, warping, twist and shear of each pair of waves.
fn dissipation_weights(beam: &BeamConstants, waves: &Waves) -> Weights {
    let curvatures = [0, 1, 2].map(|row| curvature(waves, row));
    let matrices = &beam.matrices;
    let bending = matrices.bending.map(|entry| entry.im);
    let compliance = [matrices.shear.w, matrices.shear.psi, matrices.shear.v].map(|f| -f.im);
    // The shear forces g = f - C q'.
    let forces: [Amplitudes; 3] = std::array::from_fn(|row| {
        std::array::from_fn(|wave| {
            let shape = [0, 1, 2].map(|motion| waves.displacement[motion][wave]);
            waves.force[row][wave] + waves.kappa[wave] * matrices.tension.times(shape)[row]
        })
    });
    let rate = &waves.slope[1];
    let (mut same, mut against) = (zeros::<6, 6>(), zeros::<6, 6>());
    for i in 0..6 {
        for j in 0..6 {
            // A wave that decays at once stores no energy.
            if waves.kappa[i].re.is_infinite() || waves.kappa[j].re.is_infinite() {
                continue;
            }
            let moments = bending.times(curvatures.map(|curvature| curvature[j]));
            let products = curvatures.iter().zip(moments);
            let bending: Complex64 = products
                .map(|(curvature, moment)| curvature[i].conj() * moment)
                .sum();
            // The rate of twist and the shear of a left-going wave have the opposite sign.
            let twist = beam.torsion.im * rate[i].conj() * rate[j];
            let shear: Complex64 = (0..3)
                .filter(|&row| compliance[row] != 0.0)
                .map(|row| compliance[row] * forces[row][i].conj() * forces[row][j])
                .sum();
            let odd = twist + shear;
            same[i][j] = bending + odd;
            against[i][j] = bending - odd;
        }
    }
    Weights { same, against }
}

/// The second derivative kappa S of each wave in a row (w, psi, v).
fn curvature(waves: &Waves, row: usize) -> Amplitudes {
    std::array::from_fn(|wave| waves.kappa[wave] * waves.slope[row][wave])
}

fn form(waves: &Waves, weights: &Weights, length: f64, decay: &Amplitudes) -> Form {
    let mut form = Form {
        same: zeros(),
        against: zeros(),
    };
    for i in 0..6 {
        for j in 0..6 {
            // Also skips the wave without displacement and without finite wave number.
            if weights.same[i][j] == ZERO && weights.against[i][j] == ZERO {
                continue;
            }
            let (left, right) = (waves.kappa[i].conj(), waves.kappa[j]);
            form.same[i][j] = weights.same[i][j] * length * mean_decay((left + right) * length);
            // int exp(-left x) exp(-right (l - x)) dx, with the exponential of the slower one factored out.
            let against = if left.re >= right.re {
                decay[j] * mean_decay((left - right) * length)
            } else {
                decay[i].conj() * mean_decay((right - left) * length)
            };
            form.against[i][j] = weights.against[i][j] * length * against;
        }
    }
    form
}

/// (1 - exp(-z)) / z, also near z = 0.
pub(super) fn mean_decay(z: Complex64) -> Complex64 {
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

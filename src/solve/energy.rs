//! The vibration energy `E_V` in closed form: integrals of products of exponentials.

use num_complex::Complex64;

use super::linear::{Matrix, ZERO, zeros};
use super::plan::Plan;
use super::reflection::Amplitudes;
use super::waves::Waves;

/// What the energy of a span is made of, for each distinct span length at one frequency.
///
/// With amplitudes a at the span's left end and b at its right end the displacements are
/// `Q (exp(-kappa x) a + exp(-kappa (l - x)) b)`, so that the energy is the Hermitian form
/// `a* A a + b* A b + 2 Re(a* C b)` with the inertia-weighted shapes and the integrals over the span.
#[derive(Debug)]
pub(super) struct SpanEnergy {
    forms: Vec<Form>,
}

/// The Hermitian form of a span.
#[derive(Debug)]
struct Form {
    /// A: waves that travel the same way.
    same: Matrix<6, 6>,
    /// C: waves that travel against each other.
    against: Matrix<6, 6>,
}

impl SpanEnergy {
    /// The forms of all spans.
    pub(super) fn new(plan: &Plan, waves: &Waves, decays: &[Amplitudes]) -> Self {
        let weights = weights(plan, waves);
        let forms = plan
            .lengths
            .iter()
            .zip(decays)
            .map(|(&length, decay)| form(waves, &weights, length, decay));
        Self {
            forms: forms.collect(),
        }
    }

    /// `E_V` of a span, kg m2 (times the square of the loads' unit): a at its left end, b at its right end.
    pub(super) fn of(&self, span: usize, a: &Amplitudes, b: &Amplitudes) -> Sum {
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

/// A sum, and the size of what was summed.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sum {
    value: f64,
    terms: f64,
}

impl Sum {
    /// Adds another sum.
    pub(super) fn add(&mut self, other: Self) {
        self.value += other.value;
        self.terms += other.terms;
    }

    /// The sum; NaN where its terms cancel to their last digits, as on a beam that is very short against its waves.
    pub(super) fn resolved(self) -> f64 {
        const LEAST_SHARE: f64 = 1e-12;
        if self.value < LEAST_SHARE * self.terms {
            f64::NAN
        } else {
            self.value
        }
    }
}

/// rho A (W* W + V* V) + rho `I_0` Psi* Psi of each pair of waves.
fn weights(plan: &Plan, waves: &Waves) -> Matrix<6, 6> {
    let [w, psi, v] = &waves.displacement;
    let mut out = zeros::<6, 6>();
    for i in 0..6 {
        for j in 0..6 {
            out[i][j] = plan.beam.mass * (w[i].conj() * w[j] + v[i].conj() * v[j])
                + plan.beam.polar * psi[i].conj() * psi[j];
        }
    }
    out
}

fn form(waves: &Waves, weights: &Matrix<6, 6>, length: f64, decay: &Amplitudes) -> Form {
    let mut form = Form {
        same: zeros(),
        against: zeros(),
    };
    for i in 0..6 {
        for j in 0..6 {
            // Also passes over the wave without displacement and without finite wave number.
            if weights[i][j] == ZERO {
                continue;
            }
            let (left, right) = (waves.kappa[i].conj(), waves.kappa[j]);
            form.same[i][j] = weights[i][j] * length * mean_decay((left + right) * length);
            // int exp(-left x) exp(-right (l - x)) dx, drawn from the slower of the two.
            let against = if left.re >= right.re {
                decay[j] * mean_decay((left - right) * length)
            } else {
                decay[i].conj() * mean_decay((right - left) * length)
            };
            form.against[i][j] = weights[i][j] * length * against;
        }
    }
    form
}

/// (1 - exp(-z)) / z, also near z = 0.
fn mean_decay(z: Complex64) -> Complex64 {
    const SERIES_BELOW: f64 = 0.5;
    if z.norm() > SERIES_BELOW {
        return (1.0 - (-z).exp()) / z;
    }
    // 1 - z/2 (1 - z/3 (1 - ...)): 16 terms leave less than 1e-18.
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

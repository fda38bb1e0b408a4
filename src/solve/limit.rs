//! Responses exactly at a resonance that nothing excites: the equations say 0 / 0 there, the response is finite.
//!
//! A mode without damping whose shape no load works on, as where a force acts on its node or across its plane, leaves a
//! removable singularity. Its value follows from frequencies on both sides. Where the mode is excited the same
//! frequencies show its pole, and the value stays what it is: not finite.

use num_complex::Complex64;

use super::sweep::Frf;

/// The relative distance of the nearer frequencies on both sides: rounding is 1e-16 of this, the share of a resonance
/// farther away than a thousandth less than 1e-8 of the response.
const STEP: f64 = 1e-6;

/// In steps.
const BESIDE: [f64; 4] = [-2.0, -1.0, 1.0, 2.0];

/// More rows than these are no resonances: the numbers are beyond the range of the arithmetic.
const MOST_ROWS: usize = 64;

/// Puts the limit into every value that is not finite and has one; `solve` writes the columns' values at frequencies
/// (Hz).
pub(super) fn fill(frf: &mut Frf, solve: impl Fn(&[f64]) -> Frf) {
    let rows = frf.singular_rows();
    if rows.len() > MOST_ROWS {
        return;
    }
    for row in rows {
        let frequency = frf.frequencies[row];
        let beside = solve(&BESIDE.map(|steps| frequency * (1.0 + steps * STEP)));
        for (column, beside) in frf.columns.iter_mut().zip(&beside.columns) {
            let value = &mut column.values[row];
            if !value.is_finite()
                && let Some(limit) = between(&beside.values)
            {
                *value = limit;
            }
        }
    }
}

/// The value in the middle of four, at [`BESIDE`]; none where they show a pole between them.
fn between(values: &[Complex64]) -> Option<Complex64> {
    /// The share of a simple pole in the values that rounding makes.
    const NEGLIGIBLE: f64 = 1e-8;
    /// That of a double pole, which the curvature next to another resonance looks like.
    const NEGLIGIBLE_DOUBLE: f64 = 1e-5;
    let &[far_left, left, right, far_right] = values else {
        return None;
    };
    let size = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let [even, far_even] = [0.5 * (left + right), 0.5 * (far_left + far_right)];
    let [odd, far_odd] = [0.5 * (right - left), 0.5 * (far_right - far_left)];
    // A simple pole c / step, as of a motion: what is odd halves with twice the distance, instead of doubling.
    let simple = (2.0 * odd - far_odd).norm() / 1.5;
    // A double pole c / step^2, as of an energy.
    let double = (even - far_even).norm() / 0.75;
    let is_finite = values.iter().all(|value| value.is_finite());
    let is_smooth = simple <= NEGLIGIBLE * size && double <= NEGLIGIBLE_DOUBLE * size;
    (is_finite && is_smooth).then(|| (4.0 * even - far_even) / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at_steps(of: impl Fn(f64) -> Complex64) -> Vec<Complex64> {
        BESIDE.iter().map(|steps| of(steps * STEP)).collect()
    }

    #[test]
    fn a_smooth_function_has_its_own_value() {
        // Closed form: exp(i 3 x) / (x + 0.01) at x = 0 is 100.
        let values = at_steps(|x| Complex64::from_polar(1.0, 3.0 * x) / (x + 0.01));
        let limit = between(&values).unwrap();
        assert!((limit - 100.0).norm() < 1e-10, "{limit}");
    }

    #[test]
    fn a_pole_has_none() {
        // Closed form: c / x and c / x^2 beside 1, their shares at the nearest frequencies 1e-6 and more.
        for strength in [1e-12, 1e-3, 1e6] {
            let simple = at_steps(|x| Complex64::from(1.0 + strength / x));
            assert!(between(&simple).is_none(), "{strength}");
            let double = at_steps(|x| Complex64::from(1.0 + strength / (x * x)));
            assert!(between(&double).is_none(), "{strength}");
        }
    }
}

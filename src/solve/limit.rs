//! Responses exactly at a resonance that no load excites: the equations give 0 / 0, but the response is finite.
//!
//! If no load does work on the shape of an undamped mode, for example because the force acts at its node or
//! perpendicular to its plane, the response has a removable singularity. Its value is interpolated from frequencies on
//! both sides. If the mode is excited, the same frequencies show its pole, and the value stays not finite.

use num_complex::Complex64;

use super::sweep::Frf;

/// The relative distance of the nearer frequencies on both sides: rounding is 1e-16 of it, and a resonance farther away
/// than a thousandth contributes less than 1e-8 of the response.
const STEP: f64 = 1e-6;

/// The frequencies on both sides, in steps.
const SIDES: [f64; 4] = [-2.0, -1.0, 1.0, 2.0];

/// With more rows than this the cause is not a resonance: the numbers are outside the range of the arithmetic.
const MOST_ROWS: usize = 64;

/// Replaces every value that is not finite by its limit, if it has one; `solve` writes the columns' values at
/// frequencies (Hz).
pub(super) fn fill(frf: &mut Frf, solve: impl Fn(&[f64]) -> Frf) {
    let rows = frf.singular_rows();
    if rows.len() > MOST_ROWS {
        return;
    }
    for row in rows {
        let frequency = frf.frequencies[row];
        let nearby = solve(&SIDES.map(|steps| frequency * (1.0 + steps * STEP)));
        for (column, nearby) in frf.columns.iter_mut().zip(&nearby.columns) {
            let value = &mut column.values[row];
            if !value.is_finite()
                && let Some(limit) = between(&nearby.values)
            {
                *value = limit;
            }
        }
    }
}

/// The value in the middle of four, at [`SIDES`]; `None` if they show a pole between them.
fn between(values: &[Complex64]) -> Option<Complex64> {
    /// The fraction of a simple pole that rounding can produce.
    const NEGLIGIBLE: f64 = 1e-8;
    /// The same for a double pole, which the curvature next to another resonance resembles.
    const NEGLIGIBLE_DOUBLE: f64 = 1e-5;
    let &[far_left, left, right, far_right] = values else {
        return None;
    };
    let size = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let [even, far_even] = [0.5 * (left + right), 0.5 * (far_left + far_right)];
    let [odd, far_odd] = [0.5 * (right - left), 0.5 * (far_right - far_left)];
    // A simple pole c / step, as of a motion: the odd part halves at twice the distance, instead of doubling.
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
        SIDES.iter().map(|steps| of(steps * STEP)).collect()
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
        // Closed form: c / x and c / x^2 added to 1, with fractions of 1e-6 and more at the nearest frequencies.
        for strength in [1e-12, 1e-3, 1e6] {
            let simple = at_steps(|x| Complex64::from(1.0 + strength / x));
            assert!(between(&simple).is_none(), "{strength}");
            let double = at_steps(|x| Complex64::from(1.0 + strength / (x * x)));
            assert!(between(&double).is_none(), "{strength}");
        }
    }
}

//! Roots of a frequency equation, by a scan and bisection.

/// Steps of the scan, even in the square root of the frequency, over which roots of bending are evenly spread.
const STEPS: usize = 8_000;
/// The scan starts at this share of `to`: below it lie only rigid-body motions, where the equations cancel.
const START: f64 = 2e-4;

/// Every sign change of `equation` over the frequency in Hz, from just above zero to `to`, rising.
///
/// Two roots within a step would be missed together; the comparison of whole lists then fails, because two are missing.
pub fn roots(to: f64, equation: impl Fn(f64) -> f64) -> Vec<f64> {
    let at = |step: usize| {
        let share = step as f64 / STEPS as f64;
        to * (START.sqrt() + (1.0 - START.sqrt()) * share).powi(2)
    };
    (0..STEPS)
        .filter(|&step| (equation(at(step)) > 0.0) != (equation(at(step + 1)) > 0.0))
        .map(|step| bisect(at(step), at(step + 1), &equation))
        .collect()
}

/// The sign change between two arguments, to the last bit.
pub fn bisect(from: f64, to: f64, function: &impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (from, to);
    let rising = function(high) > 0.0;
    loop {
        let middle = f64::midpoint(low, high);
        if middle <= low.min(high) || middle >= low.max(high) {
            return middle;
        }
        if (function(middle) > 0.0) == rising {
            high = middle;
        } else {
            low = middle;
        }
    }
}

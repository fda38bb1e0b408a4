//! Which frequencies are low: the kernel solves them in numbers of twice the digits.

use crate::solve::plan::Plan;

/// The phase, rad, of a wave over the whole beam below which doubles lose too many digits: above it the responses of random
/// models keep 11 of 16 digits, nine of ten.
const LEAST_PHASE: f64 = 0.2;

/// The angular frequency, rad/s, from which on each travelling wave, of bending along both principal axes and of twist, has
/// the least phase over the length of the beam, in each of its parts.
///
/// Without coupling: `E I kappa^4 = omega^2 rho A` and `E G0 kappa^4 + G J kappa^2 = omega^2 rho I_0`.
pub(in crate::solve) fn low_limit(plan: &Plan) -> f64 {
    let lengths = plan.spans.iter().map(|&span| plan.kinds[span].length);
    let square = (LEAST_PHASE / lengths.sum::<f64>()).powi(2);
    let squares = plan.beams.iter().flat_map(|beam| {
        let bending = beam.own.principal_bending();
        let twist = (beam.torsion.re + beam.warping.re * square) * square / beam.polar;
        let [one, other] = bending.map(|bending| bending * square * square / beam.mass);
        [one, other, twist]
    });
    squares.fold(0.0, f64::max).sqrt()
}

//! Complex stiffnesses: of the four springs of a subsystem, with their stretches, and of a restraint.

use num_complex::Complex64;

use crate::model::{Elastic, Spring, Subsystem};

/// The four springs: y left, y right, z left, z right.
pub(super) fn springs(subsystem: &Subsystem) -> [Spring; 4] {
    [
        subsystem.y_left,
        subsystem.y_right,
        subsystem.z_left,
        subsystem.z_right,
    ]
}

/// k + i omega c, N/m.
pub(super) fn stiffness(omega: Complex64, spring: Spring) -> Complex64 {
    spring.stiffness + Complex64::I * omega * spring.damping
}

/// K + i omega C - omega^2 m, N/m or N m/rad.
pub(super) fn restraint_stiffness(elastic: Elastic, omega: Complex64) -> Complex64 {
    let damper = Complex64::I * omega * elastic.damping;
    elastic.stiffness + damper - omega * omega * elastic.inertia
}

/// The stretches of the four springs, m: how far the mass's end of each is ahead of the beam's.
///
/// Either from what moves (`moved`: the mass's y, z, theta and the beam's w, psi, v) or from what the springs carry: of
/// a stiff spring the first, of a soft one the second is a small difference of large numbers.
pub(super) fn stretches(
    omega: Complex64,
    subsystem: &Subsystem,
    moved: [[Complex64; 3]; 2],
    channels: [Complex64; 3],
) -> [Complex64; 4] {
    let (across, [left, right]) = terms(subsystem, moved);
    let [of_left, of_right, of_z_left, of_z_right] =
        springs(subsystem).map(|spring| stiffness(omega, spring));
    // What the beam does to the mass: the y springs, and the sum and the difference of the z springs.
    let [force, sum, difference] = channels;
    let y = better(&across, &[-force], of_left + of_right);
    [
        y,
        y,
        better(&left, &[-0.5 * sum, 0.5 * difference], of_z_left),
        better(&right, &[-0.5 * sum, -0.5 * difference], of_z_right),
    ]
}

/// The stretches of the four springs, m, from what moves alone.
pub(super) fn geometric_stretches(
    subsystem: &Subsystem,
    moved: [[Complex64; 3]; 2],
) -> [Complex64; 4] {
    let (across, [left, right]) = terms(subsystem, moved);
    let y = across.iter().sum();
    [y, y, left.iter().sum(), right.iter().sum()]
}

/// What adds up to the stretch of the y springs, and of the left and the right z spring, m.
fn terms(
    subsystem: &Subsystem,
    [[y, z, theta], [w, psi, v]]: [[Complex64; 3]; 2],
) -> ([Complex64; 3], [[Complex64; 4]; 2]) {
    let along_z = |arm: f64, mount: f64| [z, arm * theta, -v, -mount * psi];
    (
        [y, -w, -subsystem.mount_z * psi],
        [
            along_z(-subsystem.arm_left, -subsystem.mount_y),
            along_z(subsystem.arm_right, subsystem.mount_y),
        ],
    )
}

/// The sum of `lengths`, or that of `forces` over a stiffness: whichever sums smaller terms.
fn better(lengths: &[Complex64], forces: &[Complex64], stiffness: Complex64) -> Complex64 {
    let size = |terms: &[Complex64]| -> f64 { terms.iter().map(|term| term.norm()).sum() };
    if size(forces) < size(lengths) * stiffness.norm() {
        forces.iter().sum::<Complex64>() / stiffness
    } else {
        lengths.iter().sum()
    }
}

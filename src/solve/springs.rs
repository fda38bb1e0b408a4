//! Supports and springs as the beam sees them, for the solver, the mode count and the derivatives: their dynamic
//! stiffnesses, and the stretches of the springs of a subsystem.
//!
//! `kernel` has the same in its own arithmetic; the two reference methods have their own on purpose.

use num_complex::Complex64;

use super::linear::ZERO;
use crate::model::{
    BeamMotion, Elastic, Joint, Link, MaxwellBranch, Point, Restraint, Spring, Subsystem,
    UniformPart,
};

impl Point {
    /// The motions of the point, from those of the axis.
    pub(super) fn motions(self, axis: &[Complex64; 6]) -> [Complex64; 6] {
        let twist = axis[BeamMotion::Psi as usize];
        // A twist may be infinite.
        BeamMotion::ALL.map(|motion| match self.arm(motion) {
            Some(arm) if arm != 0.0 => axis[motion as usize] + arm * twist,
            _ => axis[motion as usize],
        })
    }

    /// The torque about the axis of the first and the third of six forces, along w and v, if they act at the point.
    pub(super) fn torque(self, forces: &[Complex64; 6]) -> Complex64 {
        self.z * forces[BeamMotion::W as usize] - self.y * forces[BeamMotion::V as usize]
    }

    /// The internal forces conjugate to the motions of the point, from those of the axis.
    pub(super) fn forces(self, axis: &[Complex64; 6]) -> [Complex64; 6] {
        let mut forces = *axis;
        forces[BeamMotion::Psi as usize] -= self.torque(axis);
        forces
    }
}

impl UniformPart {
    /// The motions of its shear centre, from those of the axis; the slopes likewise.
    pub(super) fn own_motions(&self, axis: &[Complex64; 6]) -> [Complex64; 6] {
        let [w, psi, v, w_slope, rate, v_slope] = *axis;
        let Point { y, z } = self.offset;
        [
            w + z * psi,
            psi,
            v - y * psi,
            w_slope + z * rate,
            rate,
            v_slope - y * rate,
        ]
    }
}

impl Joint {
    /// The spring and damper between both sides of each motion, all 0 where it is free; `None` where it is rigid.
    ///
    /// Without warping stiffness on both sides no bimoment is transmitted, and a link of the rate of twist has no effect.
    pub(super) fn springs(&self, without_warping: bool) -> [Option<Spring>; 6] {
        BeamMotion::ALL.map(|motion| match &self[motion] {
            _ if motion == BeamMotion::PsiSlope && without_warping => None,
            Link::Rigid => None,
            joined @ (Link::Free | Link::Elastic(_)) => Some(joined.spring().clone()),
        })
    }
}

impl Spring {
    /// k (1 + i eta), N/m.
    pub(super) fn complex_stiffness(&self) -> Complex64 {
        Complex64::new(self.stiffness, self.stiffness * self.loss_factor)
    }

    /// Two springs in parallel as one.
    pub(crate) fn in_parallel(&self, other: &Self) -> Self {
        let both = self.complex_stiffness() + other.complex_stiffness();
        Self {
            stiffness: both.re,
            damping: self.damping + other.damping,
            loss_factor: if both.im == 0.0 {
                0.0
            } else {
                both.im / both.re
            },
            maxwell: [&self.maxwell[..], &other.maxwell].concat(),
        }
    }

    /// Its Maxwell branches that transmit a force.
    fn acting_branches(&self) -> impl Iterator<Item = &MaxwellBranch> {
        self.maxwell.iter().filter(|branch| branch.acts())
    }

    /// The same, with those of one relaxation time, `c_b / k_b`, as one.
    pub(super) fn relaxations(&self) -> Vec<MaxwellBranch> {
        /// Relative: closer ones are one but for rounding.
        const EQUAL: f64 = 1e-12;
        let mut all: Vec<MaxwellBranch> = Vec::new();
        for branch in self.acting_branches() {
            let is_equal = |other: &&mut MaxwellBranch| {
                let [one, other] = [
                    branch.damping * other.stiffness,
                    other.damping * branch.stiffness,
                ];
                (one - other).abs() <= EQUAL * one
            };
            match all.iter_mut().find(is_equal) {
                Some(other) => {
                    other.stiffness += branch.stiffness;
                    other.damping += branch.damping;
                }
                None => all.push(*branch),
            }
        }
        all
    }

    /// Its dynamic stiffness, N/m.
    pub(super) fn dynamic_stiffness(&self, omega: Complex64) -> Complex64 {
        let rate = Complex64::I * omega;
        let branches = self.acting_branches().map(|of| {
            let damping = rate * of.damping;
            of.stiffness * damping / (of.stiffness + damping)
        });
        self.complex_stiffness() + rate * self.damping + branches.sum::<Complex64>()
    }

    /// The difference of its dynamic stiffness at two angular frequencies, over that of `i omega`, N s/m: the derivative if
    /// they are equal, and the damping if it has no Maxwell branches.
    pub(super) fn damping_between(&self, omegas: [Complex64; 2]) -> Complex64 {
        let branches = self.acting_branches().map(|of| {
            let share = |omega| of.stiffness / (of.stiffness + Complex64::I * omega * of.damping);
            of.damping * share(omegas[0]) * share(omegas[1])
        });
        self.damping + branches.sum::<Complex64>()
    }
}

/// The dynamic stiffness of the restraint of a motion, in the units of [`Spring`]; `None` if the motion is fixed.
pub(super) fn restraint_stiffness(omega: Complex64, restraint: &Restraint) -> Option<Complex64> {
    match restraint {
        Restraint::Fixed => None,
        Restraint::Free => Some(ZERO),
        Restraint::Elastic(Elastic { spring, inertia }) => {
            Some(spring.dynamic_stiffness(omega) - omega * omega * inertia)
        }
    }
}

/// A spring, and its stretch as a row over the motions: the displacement of the mass's end relative to the beam's.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    pub(super) spring: Spring,
    /// Of y, z and theta of the mass; m, m and m/rad.
    pub(super) mass: [f64; 3],
    /// Of w, psi and v of the beam.
    pub(super) beam: [f64; 3],
}

/// The two y springs, whose stretches are equal, as one; the left and the right z spring (Chen & Liu 2022, Appendix A).
pub(super) fn rows(subsystem: &Subsystem) -> [Stretch; 3] {
    let along_z = |spring: &Spring, arm: f64, mount: f64| Stretch {
        spring: spring.clone(),
        mass: [0.0, 1.0, arm],
        beam: [0.0, -mount, -1.0],
    };
    [
        Stretch {
            spring: subsystem.y_left.in_parallel(&subsystem.y_right),
            mass: [1.0, 0.0, 0.0],
            beam: [-1.0, -subsystem.mount_z, 0.0],
        },
        along_z(&subsystem.z_left, -subsystem.arm_left, -subsystem.mount_y),
        along_z(&subsystem.z_right, subsystem.arm_right, subsystem.mount_y),
    ]
}

/// For each of the four springs, of what is known for each row of [`rows`].
pub(super) fn of_each<T: Clone>([across, left, right]: [T; 3]) -> [T; 4] {
    [across.clone(), across, left, right]
}

impl Stretch {
    /// The terms of the stretch, m, for motions (y, z, theta) and (w, psi, v).
    fn terms(&self, [mass, [w, psi, v]]: [[Complex64; 3]; 2]) -> [Complex64; 6] {
        // A motion with the factor 0 may be infinite.
        let of = |share: f64, moved: Complex64| if share == 0.0 { ZERO } else { share * moved };
        let ([y, z, theta], [of_w, of_psi, of_v]) = (self.mass, self.beam);
        [
            of(y, mass[0]),
            of(z, mass[1]),
            of(theta, mass[2]),
            of(of_w, w),
            of(of_v, v),
            of(of_psi, psi),
        ]
    }

    /// The stretch, m, for motions (y, z, theta) and (w, psi, v).
    pub(super) fn of(&self, moved: [[Complex64; 3]; 2]) -> Complex64 {
        self.terms(moved).iter().sum()
    }
}

/// The stretches of the four springs, m.
///
/// Either from the motions (`moved`: the mass's y, z, theta and the beam's w, psi, v) or from the spring forces: for a
/// stiff spring the first, for a soft one the second is a small difference of large numbers.
pub(super) fn stretches(
    omega: Complex64,
    subsystem: &Subsystem,
    moved: [[Complex64; 3]; 2],
    channels: [Complex64; 3],
) -> [Complex64; 4] {
    let [across, left, right] = rows(subsystem).map(|row| row.terms(moved));
    let [of_left, of_right, of_z_left, of_z_right] = subsystem
        .springs()
        .map(|spring| spring.dynamic_stiffness(omega));
    // The forces of the beam on the mass: the y springs, and the sum and the difference of the z springs.
    let [force, sum, difference] = channels;
    of_each([
        better(&across, &[-force], of_left + of_right),
        better(&left, &[-0.5 * sum, 0.5 * difference], of_z_left),
        better(&right, &[-0.5 * sum, -0.5 * difference], of_z_right),
    ])
}

/// The stretches of the four springs, m, from the motions only.
pub(super) fn geometric_stretches(
    subsystem: &Subsystem,
    moved: [[Complex64; 3]; 2],
) -> [Complex64; 4] {
    of_each(rows(subsystem).map(|row| row.of(moved)))
}

/// The sum of `lengths`, or that of `forces` over a stiffness: the one with the smaller terms.
fn better(lengths: &[Complex64], forces: &[Complex64], stiffness: Complex64) -> Complex64 {
    let size = |terms: &[Complex64]| -> f64 { terms.iter().map(|term| term.norm()).sum() };
    if size(forces) < size(lengths) * stiffness.norm() {
        forces.iter().sum::<Complex64>() / stiffness
    } else {
        lengths.iter().sum()
    }
}

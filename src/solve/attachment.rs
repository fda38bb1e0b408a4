//! A subsystem seen from the beam: the forces of its springs as unknowns.
//!
//! The springs act through three channels: the two y springs together, and the sum and the difference of the z
//! springs. Their stretches are
//! `e_y = w + z_b psi - y`, `e_sum = v - z - h theta`, `e_difference = y_u psi - l theta`, with
//! h = (`l_R` - `l_L`)/2 and l = (`l_L` + `l_R`)/2. Keeping the spring forces (and theta) as unknowns, instead of
//! the condensed stiffness, loses nothing at the resonance of a mass on the blocked beam, where that stiffness is
//! infinite, nor at low frequencies, where it is a small difference of large numbers. It works for a mass without
//! inertia and for springs that are missing. Sum and difference keep symmetric arms exactly uncoupled.

use num_complex::Complex64;

use super::linear::ZERO;
use super::springs::rows;
use crate::model::{Spring, Subsystem};

/// Unknowns of an attachment: the forces of the three channels, and theta.
pub(super) const UNKNOWNS: usize = 4;

/// A subsystem: everything that does not depend on the frequency.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Attachment {
    pub(super) mass: f64,
    pub(super) inertia: f64,
    /// Both y springs as one.
    pub(super) spring_y: Spring,
    /// The left and the right one alone.
    pub(super) y: [Spring; 2],
    pub(super) z_left: Spring,
    pub(super) z_right: Spring,
    pub(super) mount_y: f64,
    pub(super) mount_z: f64,
    pub(super) arm_left: f64,
    pub(super) arm_right: f64,
    /// Whether theta has an equation; otherwise it is 0.
    pub(super) can_turn: bool,
    /// Whether a support fixes w, psi and v of the beam at its position.
    pub(super) held: [bool; 3],
    /// Loads on the mass along (y, z, theta), N and N m.
    pub(super) load: [Complex64; 3],
}

impl Attachment {
    /// The attachment of a subsystem, without loads.
    pub(super) fn new(subsystem: &Subsystem) -> Self {
        let [spring_y, z_left, z_right] = rows(subsystem).map(|row| row.spring);
        Self {
            mass: subsystem.mass,
            inertia: subsystem.inertia,
            spring_y,
            y: [subsystem.y_left.clone(), subsystem.y_right.clone()],
            z_left,
            z_right,
            mount_y: subsystem.mount_y,
            mount_z: subsystem.mount_z,
            arm_left: subsystem.arm_left,
            arm_right: subsystem.arm_right,
            can_turn: subsystem.can_turn(),
            held: [false; 3],
            load: [ZERO; 3],
        }
    }

    /// Its springs, those as one that stretch alike.
    pub(super) fn distinct_springs(&self) -> Vec<Spring> {
        let (across, left, right) = (&self.spring_y, &self.z_left, &self.z_right);
        let mut all = vec![across.clone()];
        if self.arm_right == -self.arm_left && self.mount_y == 0.0 {
            all.push(left.in_parallel(right));
        } else {
            all.extend([left.clone(), right.clone()]);
        }
        all
    }
}

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

use super::linear::{Matrix, ZERO, solve, zeros};
use super::reflection::Contact;
use super::springs::{rows, stiffness};
use crate::model::{Spring, Subsystem};

/// Unknowns of an attachment: the forces of the three channels, and theta.
pub(super) const UNKNOWNS: usize = 4;

/// A subsystem, with everything that does not depend on the frequency.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Attachment {
    pub(super) mass: f64,
    pub(super) inertia: f64,
    pub(super) spring_y: Spring,
    pub(super) z_left: Spring,
    pub(super) z_right: Spring,
    pub(super) mount_y: f64,
    pub(super) mount_z: f64,
    pub(super) arm_left: f64,
    pub(super) arm_right: f64,
    /// Whether a support holds w, psi and v of the beam at its place.
    pub(super) held: [bool; 3],
    /// Loads on the mass along (y, z, theta), N and N m.
    pub(super) load: [Complex64; 3],
}

/// The complex stiffnesses of an attachment at one frequency.
#[derive(Debug, Clone, Copy)]
struct Stiffness {
    y: Complex64,
    left: Complex64,
    right: Complex64,
}

impl Stiffness {
    /// The channel forces (y, sum, difference) of stretches.
    fn times(&self, stretch: [Complex64; 3]) -> [Complex64; 3] {
        let (sum, difference) = (self.left + self.right, self.right - self.left);
        [
            self.y * stretch[0],
            sum * stretch[1] + difference * stretch[2],
            difference * stretch[1] + sum * stretch[2],
        ]
    }
}

/// The unknowns as an affine function of the waves b that come from the right: `from_waves b + forced`.
#[derive(Debug, Clone)]
pub(super) struct Channels {
    /// 4x6.
    pub(super) from_waves: Matrix<UNKNOWNS, 6>,
    /// What loads add.
    pub(super) forced: [Complex64; UNKNOWNS],
}

impl Attachment {
    /// The attachment of a subsystem, without loads.
    pub(super) fn new(subsystem: &Subsystem) -> Self {
        let [spring_y, z_left, z_right] = rows(subsystem).map(|row| row.spring);
        Self {
            mass: subsystem.mass,
            inertia: subsystem.inertia,
            spring_y,
            z_left,
            z_right,
            mount_y: subsystem.mount_y,
            mount_z: subsystem.mount_z,
            arm_left: subsystem.arm_left,
            arm_right: subsystem.arm_right,
            held: [false; 3],
            load: [ZERO; 3],
        }
    }

    fn stiffness(&self, omega: Complex64) -> Stiffness {
        Stiffness {
            y: stiffness(omega, self.spring_y),
            left: stiffness(omega, self.z_left),
            right: stiffness(omega, self.z_right),
        }
    }

    /// h, m.
    pub(super) fn half_difference_of_arms(&self) -> f64 {
        0.5 * (self.arm_right - self.arm_left)
    }

    /// l, m.
    pub(super) fn half_sum_of_arms(&self) -> f64 {
        0.5 * (self.arm_right + self.arm_left)
    }

    /// C q: the beam's part of the stretches, from a vector or matrix row triple (w, psi, v).
    pub(super) fn stretches<const K: usize>(&self, q: &Matrix<3, K>) -> Matrix<3, K> {
        let q = self.unheld(q, &[ZERO; K]);
        let mut out = zeros::<3, K>();
        for k in 0..K {
            out[0][k] = q[0][k] + self.mount_z * q[1][k];
            out[1][k] = q[2][k];
            out[2][k] = self.mount_y * q[1][k];
        }
        out
    }

    /// The motions (w, psi, v) with `zero` for those that a support holds: what the waves say there is rounding, which
    /// the resonance of the mass would magnify.
    fn unheld<T: Copy>(&self, q: &[T; 3], zero: &T) -> [T; 3] {
        std::array::from_fn(|row| if self.held[row] { *zero } else { q[row] })
    }

    /// C^T g: the jump of the beam's internal forces (w, psi, v) that channel forces make.
    pub(super) fn jump(&self, g: &[Complex64; UNKNOWNS]) -> [Complex64; 3] {
        [g[0], self.mount_z * g[0] + self.mount_y * g[2], g[1]]
    }

    /// The unknowns as functions of what comes from the right.
    pub(super) fn channels(&self, omega: Complex64, contact: &Contact) -> Channels {
        let k = self.stiffness(omega);
        let driving = self.driving(omega, &contact.moved, &contact.still);
        let mut b = zeros::<UNKNOWNS, 7>();
        for column in 0..7 {
            let pulled = k.times(driving.map(|row| row[column]));
            for channel in 0..3 {
                b[channel][column] = pulled[channel];
            }
        }
        if !self.is_idle(&k) {
            b[3][6] = -self.load[2];
        }
        split(&solve(self.system(omega, &contact.receptance), b))
    }

    /// The matrix of the unknowns: each channel's force against its stretch, and the balance of theta.
    fn system(&self, omega: Complex64, receptance: &Matrix<3, 3>) -> Matrix<UNKNOWNS, UNKNOWNS> {
        let k = self.stiffness(omega);
        let flexibility = self.flexibility(omega, receptance);
        let mut a = zeros::<UNKNOWNS, UNKNOWNS>();
        for column in 0..UNKNOWNS {
            let pulled = k.times(flexibility.map(|row| row[column]));
            for channel in 0..3 {
                a[channel][column] = pulled[channel];
            }
        }
        for channel in 0..3 {
            a[channel][channel] += 1.0;
        }
        // omega^2 J theta + h g_sum + l g_difference = -load, or theta = 0 where nothing turns the mass.
        if self.is_idle(&k) {
            a[3][3] = Complex64::ONE;
        } else {
            a[3][1] = self.half_difference_of_arms().into();
            a[3][2] = self.half_sum_of_arms().into();
            a[3][3] = omega * omega * self.inertia;
        }
        a
    }

    /// Whether theta has neither inertia nor a spring or damper, at any frequency but 0.
    pub(super) fn is_never_turned(&self) -> bool {
        self.is_idle(&self.stiffness(Complex64::ONE))
    }

    /// Whether theta has neither inertia nor spring.
    fn is_idle(&self, k: &Stiffness) -> bool {
        let held =
            k.left * self.arm_left * self.arm_left + k.right * self.arm_right * self.arm_right;
        self.inertia == 0.0 && held == ZERO
    }

    /// The stretches that unknowns take away: by the mass moving, by the beam moving, by theta.
    fn flexibility(&self, omega: Complex64, receptance: &Matrix<3, 3>) -> Matrix<3, UNKNOWNS> {
        let mut by_jump = zeros::<3, 3>();
        for channel in 0..3 {
            let mut unit = [ZERO; UNKNOWNS];
            unit[channel] = Complex64::ONE;
            let jump = self.jump(&unit);
            for row in 0..3 {
                by_jump[row][channel] = receptance[row][0] * jump[0]
                    + receptance[row][1] * jump[1]
                    + receptance[row][2] * jump[2];
            }
        }
        let by_beam = self.stretches(&by_jump);
        let by_mass = 1.0 / (omega * omega * self.mass);
        let mut out = zeros::<3, UNKNOWNS>();
        for (row, beam) in by_beam.iter().enumerate() {
            for channel in 0..3 {
                out[row][channel] = -beam[channel];
            }
        }
        out[0][0] -= by_mass;
        out[1][1] -= by_mass;
        out[1][3] = self.half_difference_of_arms().into();
        out[2][3] = self.half_sum_of_arms().into();
        out
    }

    /// The stretches with all unknowns at zero: per wave from the right, and in the last column by loads.
    fn driving(
        &self,
        omega: Complex64,
        moved: &Matrix<3, 6>,
        still: &[Complex64; 3],
    ) -> Matrix<3, 7> {
        let mut q = zeros::<3, 7>();
        for row in 0..3 {
            q[row][..6].copy_from_slice(&moved[row]);
            q[row][6] = still[row];
        }
        let mut out = self.stretches(&q);
        let by_mass = 1.0 / (omega * omega * self.mass);
        out[0][6] += self.load[0] * by_mass;
        out[1][6] += self.load[1] * by_mass;
        out
    }

    /// The motion (y, z, theta) of the mass from the unknowns `g` and the beam's displacement `q` (w, psi, v).
    ///
    /// Below the resonance of a mass on its springs the motion follows from the stretch, above it from the inertia:
    /// either alone would be a small difference of large numbers on the other side.
    pub(super) fn motion(
        &self,
        omega: Complex64,
        g: &[Complex64; UNKNOWNS],
        q: &[Complex64; 3],
    ) -> [Complex64; 3] {
        let k = self.stiffness(omega);
        let q = self.unheld(q, &ZERO);
        let theta = g[3];
        let inertia = omega * omega * self.mass;
        let y = if k.y.norm() > inertia.norm() {
            q[0] + self.mount_z * q[1] - g[0] / k.y
        } else {
            -(g[0] + self.load[0]) / inertia
        };
        let z = if (k.left + k.right).norm() <= inertia.norm() {
            -(g[1] + self.load[1]) / inertia
        } else if k.right.norm() >= k.left.norm() {
            q[2] + self.mount_y * q[1] - 0.5 * (g[1] + g[2]) / k.right - self.arm_right * theta
        } else {
            q[2] - self.mount_y * q[1] - 0.5 * (g[1] - g[2]) / k.left + self.arm_left * theta
        };
        [y, z, theta]
    }
}

/// Splits the solution into its dependence on the waves and its forced part.
fn split(solution: &Matrix<UNKNOWNS, 7>) -> Channels {
    let mut channels = Channels {
        from_waves: zeros(),
        forced: [ZERO; UNKNOWNS],
    };
    for (row, x) in solution.iter().enumerate() {
        channels.from_waves[row].copy_from_slice(&x[..6]);
        channels.forced[row] = x[6];
    }
    channels
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: the rows of the springs, turned: y, and half the sum and half the difference of both z springs.
    #[test]
    fn the_channels_are_the_rows_of_the_springs() {
        let text = crate::presets::find("fig05a").unwrap().text;
        let mut subsystem = crate::model::read(text).unwrap().subsystems[0].clone();
        (subsystem.arm_left, subsystem.arm_right) = (0.25, 0.75);
        (subsystem.mount_y, subsystem.mount_z) = (0.125, 0.5);
        let [y, left, right] = rows(&subsystem);
        let half = |sign: f64, of: fn(&crate::solve::springs::Stretch) -> [f64; 3]| -> [f64; 3] {
            std::array::from_fn(|k| -0.5 * (of(&right)[k] + sign * of(&left)[k]))
        };
        let attachment = Attachment::new(&subsystem);
        let unit = std::array::from_fn(|row| {
            std::array::from_fn(|column| Complex64::from(f64::from(u8::from(row == column))))
        });
        let of_beam = attachment
            .stretches::<3>(&unit)
            .map(|row| row.map(|x| x.re));
        let expected = [
            y.beam.map(|x| -x),
            half(1.0, |row| row.beam),
            half(-1.0, |row| row.beam),
        ];
        assert_eq!(of_beam, expected);
        let theta = [
            attachment.half_difference_of_arms(),
            attachment.half_sum_of_arms(),
        ];
        let expected = [half(1.0, |row| row.mass)[2], half(-1.0, |row| row.mass)[2]];
        assert_eq!(theta.map(|x| -x), expected);
    }
}

//! Effective springs: a subsystem condensed to its effect on the beam (Chen & Liu 2022, Section 2.1 and Appendix A).

use num_complex::Complex64;

use crate::model::{MaxwellBranch, Spring, SpringName, Subsystem};

/// The eight effective springs of Eqs. (1) and (2), and the effect of a load on the mass, at one frequency.
///
/// Signs are the paper's: a spring's force acts on the beam, so a spring has a negative effective one at rest.
#[derive(Debug, Clone, Copy)]
pub(super) struct EffectiveSprings {
    y_left: Complex64,
    y_right: Complex64,
    /// `X_1` and `X_2` of Eq. (10): the complex stiffnesses of the z springs.
    x1: Complex64,
    x2: Complex64,
    /// The denominator of Eqs. (3) to (6).
    of_y: Complex64,
    /// `W_11`, `W_12` = `W_21` and `W_22` after Eq. (10): the inverse of the matrix of Eq. (A11).
    w: [Complex64; 3],
    arm_left: f64,
    arm_right: f64,
    mount_y: f64,
    mount_z: f64,
}

/// The forces of a subsystem's springs on the beam, over (w, psi, v): `F_y`, T and `F_z` of Eqs. (33) to (35).
pub(super) type Forces = [[Complex64; 3]; 3];

/// k (1 + i eta) + (rate) c, and the series of spring and damper of each Maxwell branch, N/m.
pub(super) fn complex(spring: &Spring, rate: Complex64) -> Complex64 {
    let loss = Complex64::new(1.0, spring.loss_factor);
    let series = |of: &MaxwellBranch| {
        let damper = rate * of.damping;
        damper * of.stiffness / (damper + of.stiffness)
    };
    let acting = spring.maxwell.iter().filter(|of| of.acts());
    rate * spring.damping + spring.stiffness * loss + acting.map(series).sum::<Complex64>()
}

impl EffectiveSprings {
    /// Condenses a subsystem at the angular frequency `omega`, rad/s.
    pub(super) fn new(s: &Subsystem, omega: f64) -> Self {
        // The paper's rate, with a bar: its square is -omega^2.
        let rate = Complex64::new(0.0, omega);
        let [y_left, y_right, x1, x2] = s.springs().map(|of| complex(of, rate));
        let (left, right) = (s.arm_left, s.arm_right);
        let along_z = s.mass * rate * rate + x1 + x2;
        let about_x = s.inertia * rate * rate + x1 * left * left + x2 * right * right;
        let mixed = x1 * left - x2 * right;
        // Delta, with k + (rate) c in its last entry, where the paper prints c twice.
        let delta = along_z * about_x - mixed * mixed;
        Self {
            y_left,
            y_right,
            x1,
            x2,
            of_y: s.mass * rate * rate + y_left + y_right,
            w: [about_x / delta, mixed / delta, along_z / delta],
            arm_left: left,
            arm_right: right,
            mount_y: s.mount_y,
            mount_z: s.mount_z,
        }
    }

    /// k + (rate) c of a spring, N/m.
    pub(super) const fn stiffness(&self, name: SpringName) -> Complex64 {
        match name {
            SpringName::YLeft => self.y_left,
            SpringName::YRight => self.y_right,
            SpringName::ZLeft => self.x1,
            SpringName::ZRight => self.x2,
        }
    }

    /// `k_e,y` 11, 12, 21 and 22 of Eqs. (3) to (6), N/m.
    pub(super) fn along_y(&self) -> [[Complex64; 2]; 2] {
        let (left, right) = (self.y_left, self.y_right);
        let inertia = self.of_y - left - right;
        let cross = left * right / self.of_y;
        [
            [(-inertia - right) * left / self.of_y, cross],
            [cross, (-inertia - left) * right / self.of_y],
        ]
    }

    /// `k_e,z` 11, 12, 21 and 22 of Eqs. (7) to (10), N/m.
    pub(super) fn along_z(&self) -> [[Complex64; 2]; 2] {
        let [w11, w12, w22] = self.w;
        let (x1, x2, left, right) = (self.x1, self.x2, self.arm_left, self.arm_right);
        let k11 = (w11 - w12 * (2.0 * left) + w22 * (left * left)) * x1 * x1 - x1;
        let cross = (w11 + w12 * (right - left) - w22 * (left * right)) * x1 * x2;
        let k22 = (w11 + w12 * (2.0 * right) + w22 * (right * right)) * x2 * x2 - x2;
        [[k11, cross], [cross, k22]]
    }

    /// `F_y`, T and `F_z` (rows) per w, psi and v (columns): Eqs. (33) to (35).
    pub(super) fn forces(&self) -> Forces {
        let [[y11, y12], [y21, y22]] = self.along_y();
        let [[z11, z12], [z21, z22]] = self.along_z();
        let (z_b, y_u) = (self.mount_z, self.mount_y);
        // K with a bar (y and z), a hat, a breve and a tilde.
        let bar_y = y11 + y12 + y21 + y22;
        let bar_z = z11 + z12 + z21 + z22;
        let hat_z = -z11 + z12 - z21 + z22;
        let breve_z = -z11 - z12 + z21 + z22;
        let tilde_z = z11 - z12 - z21 + z22;
        [
            [bar_y, bar_y * z_b, Complex64::ZERO],
            [
                bar_y * z_b,
                bar_y * (z_b * z_b) + tilde_z * (y_u * y_u),
                breve_z * y_u,
            ],
            [Complex64::ZERO, hat_z * y_u, bar_z],
        ]
    }

    /// The motion (y, z, theta) of the mass by Eqs. (A10) and (A11), from the beam's (w, psi, v) and the load on it.
    pub(super) fn motion(&self, q: &[Complex64; 3], load: &[Complex64; 3]) -> [Complex64; 3] {
        let [w11, w12, w22] = self.w;
        // Eq. (30).
        let of_y = q[0] + self.mount_z * q[1];
        let (of_left, of_right) = (q[2] - self.mount_y * q[1], q[2] + self.mount_y * q[1]);
        let along = self.x1 * of_left + self.x2 * of_right + load[1];
        let about =
            -self.arm_left * self.x1 * of_left + self.arm_right * self.x2 * of_right + load[2];
        [
            ((self.y_left + self.y_right) * of_y + load[0]) / self.of_y,
            w11 * along + w12 * about,
            w12 * along + w22 * about,
        ]
    }

    /// `F_e^w`, `T_e^psi` and `F_e^v` of Eqs. (67) to (69): the effect of a load on the mass on the beam through the
    /// springs while the beam is fixed, N and N m.
    pub(super) fn transmitted(&self, load: &[Complex64; 3]) -> [Complex64; 3] {
        let [y, z, theta] = self.motion(&[Complex64::ZERO; 3], load);
        // Eqs. (A1) and (A2).
        let along_y = (self.y_left + self.y_right) * y;
        let left = self.x1 * (z - self.arm_left * theta);
        let right = self.x2 * (z + self.arm_right * theta);
        let torque = along_y * self.mount_z - left * self.mount_y + right * self.mount_y;
        [along_y, torque, left + right]
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

    use super::*;

    fn subsystem() -> Subsystem {
        let model = crate::model::read(crate::presets::find("fig05a").unwrap().text)
            .unwrap()
            .into_inner();
        let mut s = model.subsystems[0].clone();
        s.y_left.stiffness *= 0.7;
        s.z_right.stiffness *= 1.6;
        s.z_left.damping *= 40.0;
        s
    }

    /// K + i omega C - omega^2 M over (y, z, theta | w, psi, v), from the stretches of the springs.
    fn whole(s: &Subsystem, omega: f64) -> Matrix6<Complex64> {
        let springs = [
            (&s.y_left, [-1.0, 0.0, 0.0, 1.0, s.mount_z, 0.0]),
            (&s.y_right, [-1.0, 0.0, 0.0, 1.0, s.mount_z, 0.0]),
            (&s.z_left, [0.0, -1.0, s.arm_left, 0.0, -s.mount_y, 1.0]),
            (&s.z_right, [0.0, -1.0, -s.arm_right, 0.0, s.mount_y, 1.0]),
        ];
        let mut k = Matrix6::zeros();
        for (spring, stretch) in springs {
            let stretch = Vector6::from(stretch).map(Complex64::from);
            let stiffness = Complex64::new(spring.stiffness, omega * spring.damping);
            k += stretch * stretch.transpose() * stiffness;
        }
        for (row, inertia) in [s.mass, s.mass, s.inertia].into_iter().enumerate() {
            k[(row, row)] -= Complex64::from(omega * omega * inertia);
        }
        k
    }

    /// Expected: the mass eliminated from its 6x6 dynamic stiffness, without any of the paper's formulas.
    #[test]
    fn effective_springs_are_the_condensed_stiffness() {
        let s = subsystem();
        for hertz in [1.0, 60.0, 101.0, 400.0] {
            let omega = std::f64::consts::TAU * hertz;
            let k = whole(&s, omega);
            let mm: Matrix3<Complex64> = k.fixed_view::<3, 3>(0, 0).into();
            let mb: Matrix3<Complex64> = k.fixed_view::<3, 3>(0, 3).into();
            let load = Vector3::new(1.0, -0.5, 0.3).map(Complex64::from);
            let moved = Vector3::new(0.2, 1.0, -0.4).map(Complex64::from);
            let inverse = mm.try_inverse().unwrap();
            let condensed = k.fixed_view::<3, 3>(3, 3) - mb.transpose() * inverse * mb;
            let springs = EffectiveSprings::new(&s, omega);
            let forces = springs.forces();
            for row in 0..3 {
                for column in 0..3 {
                    let expected = -condensed[(row, column)];
                    let error = (forces[row][column] - expected).norm();
                    assert!(error < 1e-9 * condensed.norm(), "{row} {column}: {error}");
                }
            }
            let arrays = (moved.into(), load.into());
            let motion = Vector3::from(springs.motion(&arrays.0, &arrays.1));
            let expected = inverse * (load - mb * moved);
            assert!((motion - expected).norm() < 1e-11 * expected.norm());
            let transmitted = Vector3::from(springs.transmitted(&arrays.1));
            let expected = -mb.transpose() * inverse * load;
            assert!((transmitted - expected).norm() < 1e-11 * expected.norm());
        }
    }
}

//! What a whole model does at one frequency: the motion of the beam, its ends and the masses.

use nalgebra::DVector;
use num_complex::Complex64;

use crate::model::Subsystem;

/// Everything that moves.
#[derive(Debug, Clone)]
pub(super) struct Motion {
    /// (w, psi, v) at the places to look at, then at those of the quadrature.
    pub(super) beam: Vec<[Complex64; 3]>,
    /// The six motions of the left and of the right end.
    pub(super) ends: [[Complex64; 6]; 2],
    /// (y, z, theta) of each enabled subsystem.
    pub(super) masses: Vec<[Complex64; 3]>,
    /// (w, psi, v) of the beam at each enabled subsystem.
    pub(super) mounts: Vec<[Complex64; 3]>,
}

/// The sum of motions, each times its share.
pub(super) fn combined(answers: &[&Motion], vector: &DVector<Complex64>) -> Motion {
    let mut sum = answers[0].times(vector[0]);
    for (answer, &share) in answers.iter().zip(vector.iter()).skip(1) {
        sum.add(answer, share);
    }
    sum
}

impl Motion {
    fn all_mut(&mut self) -> impl Iterator<Item = &mut Complex64> {
        let triples = self
            .beam
            .iter_mut()
            .chain(&mut self.masses)
            .chain(&mut self.mounts);
        triples.flatten().chain(self.ends.iter_mut().flatten())
    }

    /// Times a factor.
    pub(super) fn times(&self, factor: Complex64) -> Self {
        let mut out = self.clone();
        out.all_mut().for_each(|value| *value *= factor);
        out
    }

    /// Adds another times a factor.
    pub(super) fn add(&mut self, other: &Self, factor: Complex64) {
        let mut other = other.clone();
        for (value, other) in self.all_mut().zip(other.all_mut()) {
            *value += factor * *other;
        }
    }
}

/// Stretches of the four springs (y left, y right, z left, z right).
pub(super) fn stretches(
    subsystem: &Subsystem,
    mass: &[Complex64; 3],
    mount: &[Complex64; 3],
) -> [Complex64; 4] {
    let y = mass[0] - mount[0] - subsystem.mount_z * mount[1];
    let left = mass[1] - subsystem.arm_left * mass[2] - mount[2] + subsystem.mount_y * mount[1];
    let right = mass[1] + subsystem.arm_right * mass[2] - mount[2] - subsystem.mount_y * mount[1];
    [y, y, left, right]
}

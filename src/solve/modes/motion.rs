//! The motion of a whole model in a mode: the beam, its supports and joints, and the masses.

use num_complex::Complex64;

/// The motion at all positions.
#[derive(Debug, Clone)]
pub(super) struct Motion {
    /// (w, psi, v) and their slopes at the positions of the shape, then at those of the quadrature; the slopes are 0 if
    /// they have no inertia.
    pub(super) beam: Vec<[Complex64; 6]>,
    /// (w, psi, v) at the position of each enabled subsystem.
    pub(super) stations: Vec<[Complex64; 3]>,
    /// The six motions of the point of each support, the ends first.
    pub(super) supports: Vec<[Complex64; 6]>,
    /// The jumps of the six motions over each joint, right minus left.
    pub(super) joints: Vec<[Complex64; 6]>,
    /// (y, z, theta) of each enabled subsystem.
    pub(super) masses: Vec<[Complex64; 3]>,
}

impl Motion {
    /// The same times a factor.
    pub(super) fn times(&self, factor: Complex64) -> Self {
        let mut scaled = self.clone();
        scaled.values_mut().for_each(|value| *value *= factor);
        scaled
    }

    /// Adds a motion at the same positions.
    pub(super) fn add(&mut self, other: &Self) {
        let mut other = other.clone();
        for (own, other) in self.values_mut().zip(other.values_mut()) {
            *own += *other;
        }
    }

    /// Removes the imaginary parts, if they are only rounding.
    pub(super) fn make_real(&mut self) {
        self.values_mut().for_each(|value| value.im = 0.0);
    }

    fn values_mut(&mut self) -> impl Iterator<Item = &mut Complex64> {
        let triples = self.stations.iter_mut().chain(&mut self.masses).flatten();
        let all = self.beam.iter_mut().chain(&mut self.supports);
        triples.chain(all.chain(&mut self.joints).flatten())
    }
}

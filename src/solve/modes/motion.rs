//! What a whole model does in a mode: the motion of the beam, its ends and the masses.

use num_complex::Complex64;

/// Everything that moves.
#[derive(Debug, Clone)]
pub(super) struct Motion {
    /// (w, psi, v) at the places to look at, then at those of the quadrature.
    pub(super) beam: Vec<[Complex64; 3]>,
    /// The six motions of the left and of the right end.
    pub(super) ends: [[Complex64; 6]; 2],
    /// (y, z, theta) of each enabled subsystem.
    pub(super) masses: Vec<[Complex64; 3]>,
}

//! Motions and internal forces at a point of the beam, from the waves there.

use num_complex::Complex64;

use super::linear::ZERO;
use super::waves::{Amplitudes, Waves};
use crate::model::BeamMotion;

/// Motions and internal forces at a point.
#[derive(Debug, Clone)]
pub(super) struct BeamState {
    /// w, psi, v and their slopes.
    pub(super) motion: [Complex64; 6],
    /// `S_w`, T, `S_v`, `M_w`, B, `M_v`.
    pub(super) force: [Complex64; 6],
}

impl BeamState {
    /// Outside of the beam.
    pub(super) const ZERO: Self = Self {
        motion: [ZERO; 6],
        force: [ZERO; 6],
    };

    /// Multiplies it by a factor.
    pub(super) fn scale(&mut self, by: Complex64) {
        for value in self.motion.iter_mut().chain(&mut self.force) {
            *value *= by;
        }
    }

    /// `Q (a + b)`, `S (b - a)`, `P (a - b)` and `M (a + b)`; no bimoment if the section has no warping stiffness.
    pub(super) fn new(waves: &Waves, a: &Amplitudes, b: &Amplitudes) -> Self {
        let sum: Amplitudes = std::array::from_fn(|wave| a[wave] + b[wave]);
        let difference: Amplitudes = std::array::from_fn(|wave| a[wave] - b[wave]);
        let times = |rows: &[Amplitudes; 3], amplitudes: &Amplitudes, row: usize| -> Complex64 {
            let waves = waves.of_row(row);
            waves.map(|wave| rows[row][wave] * amplitudes[wave]).sum()
        };
        let mut local = Self::ZERO;
        for row in 0..3 {
            local.motion[row] = times(&waves.displacement, &sum, row);
            local.motion[row + 3] = -times(&waves.slope, &difference, row);
            local.force[row] = times(&waves.force, &difference, row);
            local.force[row + 3] = times(&waves.moment, &sum, row);
        }
        if waves.without_warping() {
            local.force[BeamMotion::PsiSlope as usize] = ZERO;
        }
        local
    }
}

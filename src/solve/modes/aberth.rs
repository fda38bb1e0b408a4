//! A root of the characteristic function during the iteration of Newton and Aberth.

use num_complex::Complex64;

use super::characteristic::inverse;

/// A root during the iteration.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tracker {
    pub(super) z: Complex64,
    /// How many equal or nearly equal roots move together.
    pub(super) count: usize,
    /// Whether it stays on the imaginary axis, where the function is real.
    on_axis: bool,
    /// Whether the mirror image at the imaginary axis is also a root.
    mirrored: bool,
    last_step: f64,
    pub(super) arrived: bool,
}

impl Tracker {
    /// For `count` roots near `z`.
    pub(super) fn new(z: Complex64, count: usize, hysteretic: bool) -> Self {
        Self {
            z,
            count,
            on_axis: z.re == 0.0 && !hysteretic,
            mirrored: !hysteretic,
            last_step: f64::INFINITY,
            arrived: false,
        }
    }

    /// One step of Aberth, count / (F'/F - push), with `newton` = F/F' at the current point.
    pub(super) fn step(&mut self, newton: Complex64, push: Complex64) {
        const ROUNDING: f64 = 1e-14;
        // A double root can only be computed to the square root of the rounding error.
        const STALLED: f64 = 1e-6;
        const LONGEST: f64 = 0.3;
        let size = self.z.norm();
        let alone = newton * self.count as f64;
        let step = if alone == Complex64::ZERO {
            alone
        } else {
            inverse(alone.inv() - push / self.count as f64)
        };
        let relative = step.norm() / size;
        if !relative.is_finite() {
            return;
        }
        // When F is dominated by rounding, the steps no longer shrink. A push can stop the iteration away from any
        // root.
        let stopped = relative < ROUNDING || relative > 0.5 * self.last_step;
        self.arrived = stopped && relative < STALLED && alone.norm() < STALLED * size;
        self.last_step = relative;
        if relative < ROUNDING || !self.arrived {
            self.z -= step * (LONGEST / relative).min(1.0);
        }
        if self.on_axis {
            self.z.re = 0.0;
        } else if self.mirrored {
            self.z.re = self.z.re.abs();
        }
    }
}

//! One root of the characteristic function on its way, by the steps of Newton and Aberth.

use num_complex::Complex64;

use super::characteristic::Characteristic;

/// A root on its way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tracker {
    pub(super) z: Complex64,
    /// How many roots move together as one, equal or nearly so.
    pub(super) count: usize,
    /// Whether it stays on the imaginary axis, where the function is real.
    on_axis: bool,
    /// Whether the other side of the imaginary axis is the mirror image.
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

    /// One step of Aberth: count / (F'/F - push).
    pub(super) fn step(&mut self, characteristic: &Characteristic, push: Complex64) {
        const ROUNDING: f64 = 1e-14;
        // Two roots in one place are seen to the root of the rounding only.
        const STALLED: f64 = 1e-6;
        const LONGEST: f64 = 0.3;
        let size = self.z.norm();
        let alone = newton(characteristic, self.z) * self.count as f64;
        let step = if alone == Complex64::ZERO {
            alone
        } else {
            inverse(alone.inv() - push / self.count as f64)
        };
        let relative = step.norm() / size;
        if !relative.is_finite() {
            return;
        }
        // Rounding of the function shows as steps that no longer shrink. A push can stop a tracker off any root.
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

/// F / F' at z; the derivative by a difference over so little that its error only slows the last steps.
pub(super) fn newton(characteristic: &Characteristic, z: Complex64) -> Complex64 {
    const DIFFERENCE: f64 = 1e-7;
    // Along the radius: on the imaginary axis the function is real.
    let step = DIFFERENCE * z;
    let here = characteristic.at(z);
    if here.log == f64::NEG_INFINITY {
        // On the root to the last digit.
        return Complex64::ZERO;
    }
    step * inverse(characteristic.at(z + step).ratio(&here) - 1.0)
}

/// 1/z, and 0 where z is 0: a tracker on top of another leaves by its own step.
pub(super) fn inverse(z: Complex64) -> Complex64 {
    if z.norm_sqr() == 0.0 {
        Complex64::ZERO
    } else {
        z.inv()
    }
}

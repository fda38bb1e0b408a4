//! Small matrices of complex numbers, and numbers of any size.

use num_complex::Complex64;

/// A matrix of `R` rows and `C` columns.
pub(super) type Matrix<const R: usize, const C: usize> = [[Complex64; C]; R];

/// Zero.
pub(super) const ZERO: Complex64 = Complex64::new(0.0, 0.0);

/// A matrix of zeros.
pub(super) const fn zeros<const R: usize, const C: usize>() -> Matrix<R, C> {
    [[ZERO; C]; R]
}

/// A size that is cheaper than the modulus and within a factor of sqrt 2 of it.
pub(super) fn size(z: Complex64) -> f64 {
    z.re.abs() + z.im.abs()
}

/// A number of any size: its natural logarithm's real part, and its direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Magnified {
    /// ln |z|.
    pub(super) log: f64,
    /// z / |z|.
    pub(super) direction: Complex64,
}

impl Magnified {
    /// One.
    pub(super) const ONE: Self = Self {
        log: 0.0,
        direction: Complex64::ONE,
    };

    /// Times a number.
    pub(super) fn times(&mut self, z: Complex64) {
        let norm = z.norm();
        self.log += norm.ln();
        self.direction *= z / norm;
    }

    /// This over another.
    pub(super) fn over(&self, other: &Self) -> Self {
        Self {
            log: self.log - other.log,
            direction: self.direction * other.direction.conj(),
        }
    }

    /// This over another, as a number.
    pub(super) fn ratio(&self, other: &Self) -> Complex64 {
        self.direction * other.direction.conj() * (self.log - other.log).exp()
    }
}

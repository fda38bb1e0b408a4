//! Small complex matrices, and complex numbers with a logarithmic magnitude.

use num_complex::Complex64;

/// A matrix of `R` rows and `C` columns.
pub(super) type Matrix<const R: usize, const C: usize> = [[Complex64; C]; R];

/// Zero.
pub(super) const ZERO: Complex64 = Complex64::new(0.0, 0.0);

/// A matrix of zeros.
pub(super) const fn zeros<const R: usize, const C: usize>() -> Matrix<R, C> {
    [[ZERO; C]; R]
}

/// A cheap magnitude within a factor of sqrt 2 of the modulus.
pub(super) fn size(z: Complex64) -> f64 {
    z.re.abs() + z.im.abs()
}

/// A complex number as the logarithm of its magnitude and its direction; it cannot overflow.
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

    /// The product.
    pub(super) fn by(&self, other: &Self) -> Self {
        Self {
            log: self.log + other.log,
            direction: self.direction * other.direction,
        }
    }

    /// The quotient.
    pub(super) fn over(&self, other: &Self) -> Self {
        Self {
            log: self.log - other.log,
            direction: self.direction * other.direction.conj(),
        }
    }

    /// The quotient as an ordinary number.
    pub(super) fn ratio(&self, other: &Self) -> Complex64 {
        self.direction * other.direction.conj() * (self.log - other.log).exp()
    }
}

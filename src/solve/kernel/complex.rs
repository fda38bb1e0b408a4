//! Complex numbers of several frequencies at once: separate vectors of real and of imaginary parts.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

use num_complex::Complex64;

use super::double_double::DoubleDouble;
use super::number::{Arithmetic, MOST_LANES, Real};
use crate::model::Spring;

/// A complex number at each frequency.
#[derive(Debug, Clone, Copy)]
pub(super) struct Complex<A> {
    pub(super) re: Real<A>,
    pub(super) im: Real<A>,
}

/// A matrix of `R` rows and `C` columns at each frequency.
pub(super) type Matrix<A, const R: usize, const C: usize> = [[Complex<A>; C]; R];

impl<A: Arithmetic> Complex<A> {
    pub(super) const ZERO: Self = Self {
        re: Real::ZERO,
        im: Real::ZERO,
    };
    pub(super) const ONE: Self = Self {
        re: Real::ONE,
        im: Real::ZERO,
    };

    /// The same number at all frequencies.
    #[inline(always)]
    pub(super) fn splat(value: Complex64) -> Self {
        Self {
            re: Real::splat(value.re),
            im: Real::splat(value.im),
        }
    }

    /// A number that is the same at all frequencies, rounded to this arithmetic.
    #[inline(always)]
    pub(super) fn of(value: Complex<DoubleDouble>) -> Self {
        Self {
            re: Real::of(value.re),
            im: Real::of(value.im),
        }
    }

    #[inline(always)]
    pub(super) fn from_real(re: Real<A>) -> Self {
        Self { re, im: Real::ZERO }
    }

    /// The number at one frequency.
    #[inline(always)]
    pub(super) fn lane(self, lane: usize) -> Complex64 {
        Complex64::new(self.re.lanes()[lane], self.im.lanes()[lane])
    }

    /// Sets the number at one frequency.
    #[inline(always)]
    pub(super) fn set_lane(&mut self, lane: usize, value: Complex64) {
        let (mut re, mut im) = (self.re.lanes(), self.im.lanes());
        (re[lane], im[lane]) = (value.re, value.im);
        *self = Self {
            re: Real::new(&re),
            im: Real::new(&im),
        };
    }

    /// The numbers at all frequencies.
    #[inline(always)]
    pub(super) fn new(values: &[Complex64; MOST_LANES]) -> Self {
        let (mut re, mut im) = ([0.0; MOST_LANES], [0.0; MOST_LANES]);
        for lane in 0..MOST_LANES {
            (re[lane], im[lane]) = (values[lane].re, values[lane].im);
        }
        Self {
            re: Real::new(&re),
            im: Real::new(&im),
        }
    }

    /// Writes the numbers at the first frequencies, as many as fit.
    #[inline(always)]
    pub(super) fn write(self, to: &mut [Complex64]) {
        let (re, im) = (self.re.lanes(), self.im.lanes());
        for (lane, to) in to.iter_mut().enumerate() {
            *to = Complex64::new(re[lane], im[lane]);
        }
    }

    /// self + a b.
    #[inline(always)]
    pub(super) fn plus_product(self, a: Self, b: Self) -> Self {
        Self {
            re: a
                .im
                .subtract_product(b.im, a.re.multiply_add(b.re, self.re)),
            im: a.im.multiply_add(b.re, a.re.multiply_add(b.im, self.im)),
        }
    }

    /// self - a b.
    #[inline(always)]
    pub(super) fn minus_product(self, a: Self, b: Self) -> Self {
        Self {
            re: a
                .im
                .multiply_add(b.im, a.re.subtract_product(b.re, self.re)),
            im: a
                .im
                .subtract_product(b.re, a.re.subtract_product(b.im, self.im)),
        }
    }

    /// Times a real number.
    #[inline(always)]
    pub(super) fn scaled(self, by: Real<A>) -> Self {
        Self {
            re: self.re * by,
            im: self.im * by,
        }
    }

    /// self + a times the real number `by`.
    #[inline(always)]
    pub(super) fn plus_scaled(self, by: Real<A>, a: Self) -> Self {
        Self {
            re: by.multiply_add(a.re, self.re),
            im: by.multiply_add(a.im, self.im),
        }
    }

    #[inline(always)]
    pub(super) fn conj(self) -> Self {
        Self {
            re: self.re,
            im: -self.im,
        }
    }

    /// z* b.
    #[inline(always)]
    pub(super) fn conj_times(self, b: Self) -> Self {
        Self {
            re: self.re.multiply_add(b.re, self.im * b.im),
            im: self.im.subtract_product(b.re, self.re * b.im),
        }
    }

    /// The dynamic stiffness of a spring; self is the angular frequency.
    #[inline(always)]
    pub(super) fn dynamic_stiffness(self, spring: &Spring) -> Self {
        let of_spring = spring.complex_stiffness();
        let damping = Real::splat(spring.damping);
        let mut sum = Self {
            re: self.im.subtract_product(damping, Real::splat(of_spring.re)),
            im: self.re.multiply_add(damping, Real::splat(of_spring.im)),
        };
        for index in 0..spring.maxwell.len() {
            let branch = spring.maxwell[index];
            if branch.acts() {
                let (k, c) = (Real::splat(branch.stiffness), Real::splat(branch.damping));
                let damper = Self {
                    re: -(self.im * c),
                    im: self.re * c,
                };
                let both = damper + Self::from_real(k);
                sum += damper.scaled(k) * both.inverse();
            }
        }
        sum
    }

    /// The number or its negative, whichever has Re >= 0.
    #[inline(always)]
    pub(super) fn in_right_half(self) -> Self {
        Self::where_less(self.re, Real::ZERO, -self, self)
    }

    /// |z|^2.
    #[inline(always)]
    pub(super) fn norm_sqr(self) -> Real<A> {
        self.re.multiply_add(self.re, self.im * self.im)
    }

    /// |Re z| + |Im z|: cheaper than the modulus and within a factor of sqrt 2 of it.
    #[inline(always)]
    pub(super) fn size(self) -> Real<A> {
        self.re.abs() + self.im.abs()
    }

    /// 1 / z.
    #[inline(always)]
    pub(super) fn inverse(self) -> Self {
        let inverse = Real::ONE / self.norm_sqr();
        Self {
            re: self.re * inverse,
            im: -(self.im * inverse),
        }
    }

    /// The root with Re > 0, or with Re = 0 and the sign of the imaginary part, + if that is zero.
    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        // The sign of a zero must not choose the branch.
        let im = self.im + Real::ZERO;
        let larger = ((self.norm_sqr().sqrt() + self.re.abs()) * Real::splat(0.5)).sqrt();
        // Zero has no direction.
        let divisor = Real::ZERO.where_less(larger, larger, Real::ONE);
        let smaller = im.abs() * Real::splat(0.5) / divisor;
        Self {
            re: self.re.where_less(Real::ZERO, smaller, larger),
            im: self
                .re
                .where_less(Real::ZERO, larger, smaller)
                .with_sign_of(im),
        }
    }

    /// The number or its negative, whichever makes the sum with another number larger.
    #[inline(always)]
    pub(super) fn along(self, other: Self) -> Self {
        let along = self.re.multiply_add(other.re, self.im * other.im);
        Self::where_less(along, Real::ZERO, -self, self)
    }

    /// `yes` where `a` is less than `b`, otherwise `no`.
    #[inline(always)]
    pub(super) fn where_less(a: Real<A>, b: Real<A>, yes: Self, no: Self) -> Self {
        Self {
            re: a.where_less(b, yes.re, no.re),
            im: a.where_less(b, yes.im, no.im),
        }
    }
}

impl<A: Arithmetic> Add for Complex<A> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            re: self.re + other.re,
            im: self.im + other.im,
        }
    }
}

impl<A: Arithmetic> AddAssign for Complex<A> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<A: Arithmetic> Sub for Complex<A> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            re: self.re - other.re,
            im: self.im - other.im,
        }
    }
}

impl<A: Arithmetic> Neg for Complex<A> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            re: -self.re,
            im: -self.im,
        }
    }
}

impl<A: Arithmetic> Mul for Complex<A> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            re: self.im.subtract_product(other.im, self.re * other.re),
            im: self.im.multiply_add(other.re, self.re * other.im),
        }
    }
}

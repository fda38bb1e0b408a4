//! The four roots h = kappa^2 of the state equation of the coupled waves, at several frequencies at once.
//!
//! They come in pairs, evanescent and travelling: `(h - h_w)(gamma h - tau) = coupling / D(h)` with
//! `D = (h + h_w)(slope h + offset)`. Sought is by how much the coupling shifts a root from where it is without, u:
//! `h - h_w` of bending's or `gamma h - tau` of torsion's. Of the quadratic in u with D held the root that does not
//! cancel is taken, and from there Newton's steps: so u has all its digits, and each step but one division. All four
//! roots step together, for the processor would wait for each alone.

use super::complex::Complex;
use super::number::{Arithmetic, Real, part};

/// Two roots of the state equation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair<A> {
    pub(super) h_w: Complex<A>,
    pub(super) tau: Complex<A>,
    pub(super) gamma: Complex<A>,
    pub(super) inverse_gamma: Complex<A>,
    pub(super) coupling: Complex<A>,
    pub(super) slope: Complex<A>,
    pub(super) offset: Complex<A>,
}

/// One of them, with its distances from the two uncoupled roots.
#[derive(Debug, Clone, Copy)]
pub(super) struct Root<A> {
    pub(super) value: Complex<A>,
    /// value - `h_w`.
    pub(super) from_bending: Complex<A>,
    /// gamma value - tau.
    pub(super) from_torsion: Complex<A>,
}

/// A root in the making: `u (p u + q) D(start + along u) = right`.
#[derive(Debug, Clone, Copy)]
struct Sought<A> {
    u: Complex<A>,
    /// The size of its last step, squared.
    last: Real<A>,
    p: Complex<A>,
    q: Complex<A>,
    start: Complex<A>,
    along: Complex<A>,
    right: Complex<A>,
}

/// Of the evanescent and the travelling pair the root that is torsion's without coupling, then bending's.
pub(super) fn roots<A: Arithmetic>(pairs: &[Pair<A>; 2]) -> [[Root<A>; 2]; 2] {
    A::outlined(Roots((pairs,)))
}

#[inline(always)]
fn roots_inlined<A: Arithmetic>((pairs,): (&[Pair<A>; 2],)) -> [[Root<A>; 2]; 2] {
    const MOST_STEPS: usize = 60;
    let mut sought = [
        [pairs[0].torsion(), pairs[0].bending()],
        [pairs[1].torsion(), pairs[1].bending()],
    ];
    for _ in 0..MOST_STEPS {
        let mut is_moving = false;
        for pair in 0..2 {
            for which in 0..2 {
                is_moving |= pairs[pair].step(&mut sought[pair][which]);
            }
        }
        if !is_moving {
            break;
        }
    }
    [
        [
            pairs[0].torsion_root(&sought[0][0]),
            pairs[0].bending_root(&sought[0][1]),
        ],
        [
            pairs[1].torsion_root(&sought[1][0]),
            pairs[1].bending_root(&sought[1][1]),
        ],
    ]
}

impl<A: Arithmetic> Pair<A> {
    /// tau - gamma `h_w`: how far the roots are apart without coupling.
    #[inline(always)]
    fn apart(&self) -> Complex<A> {
        self.tau.minus_product(self.gamma, self.h_w)
    }

    /// The root that is torsion's without coupling.
    #[inline(always)]
    fn torsion(&self) -> Sought<A> {
        let start = self.tau * self.inverse_gamma;
        let product = self.gamma * self.right_at(start);
        Sought {
            u: product * self.larger_sum(product).inverse(),
            last: Real::splat(f64::INFINITY),
            p: Complex::ONE,
            q: self.apart(),
            start,
            along: self.inverse_gamma,
            right: self.gamma * self.coupling,
        }
    }

    /// The root that is bending's without coupling.
    #[inline(always)]
    fn bending(&self) -> Sought<A> {
        let right = self.right_at(self.h_w);
        Sought {
            u: -(right * self.larger_sum(self.gamma * right).inverse()),
            last: Real::splat(f64::INFINITY),
            p: self.gamma,
            q: -self.apart(),
            start: self.h_w,
            along: Complex::ONE,
            right: self.coupling,
        }
    }

    /// The right-hand side of the state equation.
    #[inline(always)]
    fn right_at(&self, h: Complex<A>) -> Complex<A> {
        let divisor = (h + self.h_w) * self.offset.plus_product(self.slope, h);
        self.coupling * divisor.inverse()
    }

    /// Of `half + sqrt(half^2 + product)` and the difference the larger one, which never cancels.
    #[inline(always)]
    fn larger_sum(&self, product: Complex<A>) -> Complex<A> {
        let half = self.apart().scaled(Real::splat(0.5));
        let root = product.plus_product(half, half).sqrt();
        let along = half.re.multiply_add(root.re, half.im * root.im);
        let sum = Complex::where_less(along, Real::ZERO, half - root, half + root);
        present(sum)
    }

    /// A step of Newton's; whether one more is needed at some frequency.
    #[inline(always)]
    fn step(&self, sought: &mut Sought<A>) -> bool {
        /// The share of u below which a step is the last, squared: what is left is of the size of its square.
        const NEAR: f64 = 1e-18;
        let Sought { u, p, q, along, .. } = *sought;
        let h = sought.start.plus_product(along, u);
        let (bending, torsion) = (h + self.h_w, self.offset.plus_product(self.slope, h));
        let divisor = bending * torsion;
        let of_divisor = along * torsion.plus_product(self.slope, bending);
        let other = q.plus_product(p, u);
        let product = u * other;
        let of_product = other.plus_product(p, u);
        let residual = (-sought.right).plus_product(product, divisor);
        let change = (of_product * divisor).plus_product(product, of_divisor);
        let step = residual * change.inverse();
        // Where nothing changes the roots coincide, uncoupled.
        let step = Complex::where_less(Real::ZERO, change.norm_sqr(), step, Complex::ZERO);
        let (size, near) = (step.norm_sqr(), u.norm_sqr() * Real::splat(NEAR));
        // Each frequency stops by itself, so that none depends on its neighbours.
        sought.u = Complex::where_less(near, sought.last, u - step, u);
        sought.last = near.where_less(sought.last, size, sought.last);
        near.is_less_somewhere(sought.last)
    }

    #[inline(always)]
    fn torsion_root(&self, sought: &Sought<A>) -> Root<A> {
        Root {
            value: (self.tau + sought.u) * self.inverse_gamma,
            from_bending: present(sought.q + sought.u) * self.inverse_gamma,
            from_torsion: sought.u,
        }
    }

    #[inline(always)]
    fn bending_root(&self, sought: &Sought<A>) -> Root<A> {
        Root {
            value: self.h_w + sought.u,
            from_bending: sought.u,
            from_torsion: present(sought.q.plus_product(self.gamma, sought.u)),
        }
    }
}

/// A distance; 1 where it vanishes: two roots that meet without coupling are still bending's and torsion's.
#[inline(always)]
fn present<A: Arithmetic>(distance: Complex<A>) -> Complex<A> {
    Complex::where_less(Real::ZERO, distance.norm_sqr(), distance, Complex::ONE)
}

part!(
    Roots ['a, A: Arithmetic] ['a, A]
    (&'a [Pair<A>; 2],) -> [[Root<A>; 2]; 2],
    roots_inlined
);

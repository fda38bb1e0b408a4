//! The four roots h = kappa^2 of the state equation of the coupled waves, at several frequencies at once.
//!
//! They come in pairs, evanescent and travelling: `(h - h_w)(gamma h - tau) = coupling / D(h)` with `D = (h +
//! h_w)(slope h + offset)`. The unknown is u, the shift of a root by the coupling: `h - h_w` for the bending root or
//! `gamma h - tau` for the torsion root. The start is the root without cancellation of the quadratic in u with fixed D,
//! followed by Newton steps: so u has all its digits, and each step needs one division. All four roots step together to
//! use the processor's parallelism.

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

/// A root during the iteration: `u (p u + q) D(start + along u) = right`.
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

/// For each of two pairs the torsion root, then the bending root.
type Four<T> = [[T; 2]; 2];

/// For the evanescent and the travelling pair the root that becomes torsion without coupling, then the bending root; 1
/// where these are not four roots, otherwise 0.
pub(super) fn roots<A: Arithmetic>(pairs: &[Pair<A>; 2]) -> (Four<Root<A>>, Real<A>) {
    A::outlined(Roots((pairs,)))
}

#[inline(always)]
fn roots_inlined<A: Arithmetic>((pairs,): (&[Pair<A>; 2],)) -> (Four<Root<A>>, Real<A>) {
    const MOST_STEPS: usize = 60;
    let mut sought = [pairs[0].sought(), pairs[1].sought()];
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
    let roots = [pairs[0].roots(&sought[0]), pairs[1].roots(&sought[1])];
    (roots, astray(pairs, &sought))
}

/// 1 where two of the four roots coincide, or one is invalid: the sum of all shifts is zero, because the coefficient of
/// h^3 does not depend on the coupling. Happens with strong damping and coupling.
#[inline(always)]
fn astray<A: Arithmetic>(pairs: &[Pair<A>; 2], sought: &Four<Sought<A>>) -> Real<A> {
    const MOST: f64 = 1e-5;
    let shift = |pair: usize| {
        let [torsion, bending] = [sought[pair][0].u, sought[pair][1].u];
        (torsion * pairs[pair].inverse_gamma, bending)
    };
    let ((a, b), (c, d)) = (shift(0), shift(1));
    let sizes = a.size() + b.size() + c.size() + d.size();
    let sum = ((a + b) - (c + d)).size();
    (sizes * Real::splat(MOST)).where_less(sum, Real::ONE, Real::ZERO)
}

impl<A: Arithmetic> Pair<A> {
    /// tau - gamma `h_w`: the distance of the roots without coupling.
    #[inline(always)]
    fn apart(&self) -> Complex<A> {
        self.tau.minus_product(self.gamma, self.h_w)
    }

    /// The root that becomes torsion without coupling, and the bending root.
    #[inline(always)]
    fn sought(&self) -> [Sought<A>; 2] {
        let apart = self.apart();
        let half = apart.scaled(Real::splat(0.5));
        let start = self.tau * self.inverse_gamma;
        let (right, right_of_torsion) = (self.right_at(self.h_w), self.right_at(start));
        let root = (self.gamma * right).plus_product(half, half).sqrt();
        let root = root.along(half);
        // With the sign of the other root, so that both roots are found if neither is larger.
        let product = self.gamma * right_of_torsion;
        let root_of_torsion = product.plus_product(half, half).sqrt().along(root);
        let bending = Sought {
            u: -(right * present(half + root).inverse()),
            last: Real::splat(f64::INFINITY),
            p: self.gamma,
            q: -apart,
            start: self.h_w,
            along: Complex::ONE,
            right: self.coupling,
        };
        let torsion = Sought {
            u: product * present(half + root_of_torsion).inverse(),
            p: Complex::ONE,
            q: apart,
            start,
            along: self.inverse_gamma,
            right: self.gamma * self.coupling,
            ..bending
        };
        [torsion, bending]
    }

    /// The right-hand side of the state equation.
    #[inline(always)]
    fn right_at(&self, h: Complex<A>) -> Complex<A> {
        let divisor = (h + self.h_w) * self.offset.plus_product(self.slope, h);
        self.coupling * divisor.inverse()
    }

    /// A Newton step; returns whether any frequency needs another one.
    #[inline(always)]
    fn step(&self, sought: &mut Sought<A>) -> bool {
        // The remainder of a step is about its square, relative to u: this one is the last if that is less than rounding.
        let near = 0.01 * A::ROUNDING;
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
        // If nothing changes, the roots coincide without coupling.
        let step = Complex::where_less(Real::ZERO, change.norm_sqr(), step, Complex::ZERO);
        let (size, near) = (step.norm_sqr(), u.norm_sqr() * Real::splat(near));
        // Each frequency stops independently of its neighbours.
        sought.u = Complex::where_less(near, sought.last, u - step, u);
        sought.last = near.where_less(sought.last, size, sought.last);
        near.is_less_somewhere(sought.last)
    }

    /// The torsion root, then the bending root.
    #[inline(always)]
    fn roots(&self, sought: &[Sought<A>; 2]) -> [Root<A>; 2] {
        let [torsion, bending] = sought;
        [
            Root {
                value: (self.tau + torsion.u) * self.inverse_gamma,
                from_bending: present(torsion.q + torsion.u) * self.inverse_gamma,
                from_torsion: torsion.u,
            },
            Root {
                value: self.h_w + bending.u,
                from_bending: bending.u,
                from_torsion: present(bending.q.plus_product(self.gamma, bending.u)),
            },
        ]
    }
}

/// A distance; 1 if it vanishes: of two roots that meet without coupling the bending root is purely bending and the
/// torsion root purely torsion.
#[inline(always)]
fn present<A: Arithmetic>(distance: Complex<A>) -> Complex<A> {
    Complex::where_less(Real::ZERO, distance.norm_sqr(), distance, Complex::ONE)
}

part!(
    Roots ['a, A: Arithmetic] ['a, A]
    (&'a [Pair<A>; 2],) -> (Four<Root<A>>, Real<A>),
    roots_inlined
);

//! The energy of a side of a part of the beam, in combinations of the arrivals that preserve its digits.
//!
//! At low frequencies each wave of size 1 alone moves a side far, and most of that cancels between the waves and the
//! loads: a quadratic form of b' would lose up to twice as many digits as the motions. So the energy is computed twice.
//! Its form in b', `b'* G b' + 2 Re(b'* g) + c`, gives the Cholesky factor `G = U* U` and the waves `-G^-1 g` for which
//! the side moves least. Then these, with the loads, and the columns of `U^-1`, without them, propagate over the side
//! instead of single waves. In `u = U (b' + G^-1 g)` the form is close to |u|^2 and a constant, without cancellation;
//! rounding errors of U and of the waves no longer matter, because the second form is computed for them as they are.
//! (The same method orthogonalises columns as "`CholeskyQR2`": Yamamoto et al., Electronic Transactions on Numerical
//! Analysis 44 (2015), 306-326.)

use super::quadratic_form::{ARRIVALS, Carried, FORCED, QuadraticForm, arriving, upper};
use crate::solve::kernel::complex::Complex;
use crate::solve::kernel::energy::Sum;
use crate::solve::kernel::number::{Arithmetic, Real, part};
use crate::solve::kernel::reflection::{Amplitudes, ENTRIES};

/// Six combinations u of the arrivals at a side: `b' = still + U^-1 u`.
#[derive(Debug, Clone)]
struct Combinations<A> {
    /// The waves for which the side moves least.
    still: Amplitudes<A>,
    /// U: the rows of its upper triangle.
    rows: [Complex<A>; ENTRIES],
}

/// The energy of a side.
#[derive(Debug, Clone)]
pub(super) struct SideEnergy<A> {
    combinations: Combinations<A>,
    /// In terms of the combinations.
    by: QuadraticForm<A>,
}

impl<A: Arithmetic> SideEnergy<A> {
    /// From the energy in single waves; `carried` computes it for other arrivals.
    #[inline(always)]
    pub(super) fn new(
        by_waves: &QuadraticForm<A>,
        carried: impl FnOnce(Carried<A>) -> QuadraticForm<A>,
    ) -> Self {
        let (combinations, arrivals) = Combinations::of(by_waves);
        let by = carried(arrivals);
        Self { combinations, by }
    }

    /// Adds the energy for waves b' to a sum.
    #[inline(always)]
    pub(super) fn at(&self, waves: &Amplitudes<A>, sum: &mut Sum<A>) {
        self.by.at(&self.combinations.at(waves), sum);
    }
}

impl<A: Arithmetic> Combinations<A> {
    /// The combinations for an energy in single waves, and the waves of each of them alone; last those for which the
    /// side moves least.
    fn of(energy: &QuadraticForm<A>) -> (Self, Carried<A>) {
        A::outlined(Of((energy,)))
    }

    #[inline(always)]
    fn of_inlined((energy,): (&QuadraticForm<A>,)) -> (Self, Carried<A>) {
        let factors = factors(energy);
        let mut out = Self {
            still: [Complex::ZERO; 6],
            rows: [Complex::ZERO; ENTRIES],
        };
        for row in 0..6 {
            out.still[row] = -factors[row][FORCED];
            for column in row..6 {
                out.rows[upper::<6>(row, column)] = factors[row][column];
            }
        }
        out.still = out.waves(&out.still);
        let mut arrivals = arriving();
        for arrival in 0..FORCED {
            arrivals[arrival] = out.waves(&arrivals[arrival]);
        }
        arrivals[FORCED] = out.still;
        (out, arrivals)
    }

    /// U^-1 u.
    #[inline(always)]
    fn waves(&self, u: &Amplitudes<A>) -> Amplitudes<A> {
        let mut out = *u;
        for row in (0..6).rev() {
            for column in row + 1..6 {
                let entry = self.rows[upper::<6>(row, column)];
                out[row] = out[row].minus_product(entry, out[column]);
            }
            let diagonal = self.rows[upper::<6>(row, row)].re;
            out[row] = out[row].scaled(Real::ONE / diagonal);
        }
        out
    }

    /// U (b' - still).
    #[inline(always)]
    fn at(&self, waves: &Amplitudes<A>) -> Amplitudes<A> {
        let mut out = [Complex::ZERO; 6];
        for row in 0..6 {
            for column in row..6 {
                let moved = waves[column] - self.still[column];
                out[row] = out[row].plus_product(self.rows[upper::<6>(row, column)], moved);
            }
        }
        out
    }
}

/// The rows of Cholesky's factor U, and last in each `U^-* g`.
#[inline(always)]
fn factors<A: Arithmetic>(energy: &QuadraticForm<A>) -> [[Complex<A>; ARRIVALS]; 6] {
    /// The smallest accepted ratio of a pivot to the magnitudes of its terms, in roundings.
    const LEAST: f64 = 90.0;
    let mut rows = [[Complex::ZERO; ARRIVALS]; 6];
    for row in 0..6 {
        for column in row..ARRIVALS {
            let mut entry = energy.products[upper::<ARRIVALS>(row, column)];
            for k in 0..row {
                entry = entry.minus_product(rows[k][row].conj(), rows[k][column]);
            }
            rows[row][column] = entry;
        }
        let least = energy.apart[row] * Real::splat(LEAST * A::ROUNDING);
        let pivot = rows[row][row].re.max(least);
        // A wave may move nothing.
        let root = Real::ZERO.where_less(pivot, pivot, Real::ONE).sqrt();
        rows[row][row] = Complex::from_real(root);
        for column in row + 1..ARRIVALS {
            rows[row][column] = rows[row][column].scaled(Real::ONE / root);
        }
    }
    rows
}

part!(
    Of ['a, A: Arithmetic] ['a, A]
    (&'a QuadraticForm<A>,) -> (Combinations<A>, Carried<A>),
    Combinations::of_inlined
);

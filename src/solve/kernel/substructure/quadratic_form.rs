//! The energy of one side of a part of the beam as a function of the six waves that come from the part.
//!
//! The waves in a span of the side are affine in those six: `x = X y` with `y = (b', 1)`, where X has a column for each
//! of the six alone and one for the loads of the side alone. The energy of the span is a Hermitian form of x
//! ([`crate::solve::kernel::energy`]), so that of the side is `y* G y` with G the sum of `X* F X` over its spans: 7x7
//! and Hermitian, stored as its upper triangle. In a span the forms S of waves in the same direction and C of waves in
//! opposite directions are both Hermitian, so that sums and differences of the two directions do not mix, which halves
//! the work: `a* S a + b* S b + 2 Re(a* C b) = ((a + b)* (S + C) (a + b) + (a - b)* (S - C) (a - b)) / 2`.
//!
//! The squares alone measure the cancellation: `sum_k S_kk |x_k|^2` over the waves of a span and `sum_j |y_j|^2` times
//! that of each column over the arrivals. For a positive semidefinite form this is at least an 84th of the magnitudes
//! that a full solution sums (a twelfth for the overlapping waves, a seventh for the arrivals), and more if the arrivals
//! also cancel.

use crate::solve::kernel::complex::{Complex, Matrix};
use crate::solve::kernel::energy::{Form, Sum};
use crate::solve::kernel::number::{Arithmetic, Real, part};
use crate::solve::kernel::reflection::Amplitudes;

/// The arrivals at a side: six waves, and its loads.
pub(super) const ARRIVALS: usize = 7;

/// Index of the loads of the side, after the waves.
pub(super) const FORCED: usize = 6;

/// Entries of a Hermitian 7x7 matrix.
const ENTRIES: usize = ARRIVALS * (ARRIVALS + 1) / 2;

/// Pairs of the first four waves; those of the others follow them if not all are coupled.
const COUPLED: usize = 10;

/// Waves at a place for each of the arrivals alone.
pub(super) type Carried<A> = [Amplitudes<A>; ARRIVALS];

/// An energy that is quadratic in six waves b', kg m2 (times the square of the loads' unit).
#[derive(Debug, Clone)]
pub(super) struct QuadraticForm<A> {
    /// G: the rows of its upper triangle.
    pub(super) products: [Complex<A>; ENTRIES],
    /// The energy of each arrival alone, with each of the waves that it becomes in each span alone: the magnitudes that
    /// are summed before cancellation.
    pub(super) apart: [Real<A>; ARRIVALS],
}

/// Each of the six waves, of size 1 and alone; the last column is zero.
#[inline(always)]
pub(super) fn arriving<A: Arithmetic>() -> Carried<A> {
    let mut out = [[Complex::ZERO; 6]; ARRIVALS];
    for wave in 0..6 {
        out[wave][wave] = Complex::ONE;
    }
    out
}

/// Index of an entry of the upper triangle of an `N` x `N` matrix.
#[inline(always)]
pub(super) const fn upper<const N: usize>(row: usize, column: usize) -> usize {
    row * (2 * N - 1 - row) / 2 + column
}

impl<A: Arithmetic> QuadraticForm<A> {
    pub(super) const ZERO: Self = Self {
        products: [Complex::ZERO; ENTRIES],
        apart: [Real::ZERO; ARRIVALS],
    };

    /// Adds a span: the waves that start at one of its ends, and those that start at the other.
    pub(super) fn add(&mut self, form: &Form<A>, one: &Carried<A>, other: &Carried<A>) {
        A::outlined(Add((self, form, one, other)));
    }

    #[inline(always)]
    fn add_inlined((this, form, one, other): (&mut Self, &Form<A>, &Carried<A>, &Carried<A>)) {
        for arrival in 0..ARRIVALS {
            let apart = form.apart(&one[arrival], &other[arrival]);
            this.apart[arrival] = this.apart[arrival] + apart;
        }
        for is_sum in [true, false] {
            if form.all_coupled {
                this.add_block::<6>(form, (one, other), is_sum, 0);
            } else {
                this.add_block::<4>(form, (one, other), is_sum, 0);
                this.add_block::<2>(form, (one, other), is_sum, 4);
            }
        }
    }

    /// Adds the form of the sums, or of the differences, of the `N` waves from `first` on.
    #[inline(always)]
    fn add_block<const N: usize>(
        &mut self,
        form: &Form<A>,
        (one, other): (&Carried<A>, &Carried<A>),
        is_sum: bool,
        first: usize,
    ) {
        let start = if first == 0 { 0 } else { COUPLED };
        let mut whole: Matrix<A, N, N> = [[Complex::ZERO; N]; N];
        for row in 0..N {
            for column in row..N {
                let pair = start + upper::<N>(row, column);
                let (same, against) = (form.same[pair], form.against[pair]);
                let both = if is_sum {
                    same + against
                } else {
                    same - against
                };
                let half = both.scaled(Real::splat(0.5));
                whole[row][column] = half;
                whole[column][row] = half.conj();
            }
        }
        let mut waves: Matrix<A, ARRIVALS, N> = [[Complex::ZERO; N]; ARRIVALS];
        for arrival in 0..ARRIVALS {
            for wave in 0..N {
                let (one, other) = (one[arrival][first + wave], other[arrival][first + wave]);
                waves[arrival][wave] = if is_sum { one + other } else { one - other };
            }
        }
        for column in 0..ARRIVALS {
            let mut of_column = [Complex::ZERO; N];
            for row in 0..N {
                for wave in 0..N {
                    of_column[row] =
                        of_column[row].plus_product(whole[row][wave], waves[column][wave]);
                }
            }
            for row in 0..=column {
                let mut sum = self.products[upper::<ARRIVALS>(row, column)];
                for wave in 0..N {
                    sum = sum.plus_product(waves[row][wave].conj(), of_column[wave]);
                }
                self.products[upper::<ARRIVALS>(row, column)] = sum;
            }
        }
    }

    /// Adds the energy for waves b' to a sum.
    pub(super) fn at(&self, waves: &Amplitudes<A>, sum: &mut Sum<A>) {
        A::outlined(At((self, waves, sum)));
    }

    #[inline(always)]
    fn at_inlined((this, waves, sum): (&Self, &Amplitudes<A>, &mut Sum<A>)) {
        let mut arrivals = [Complex::ONE; ARRIVALS];
        arrivals[..6].copy_from_slice(waves);
        let (mut value, mut terms) = (Real::ZERO, Real::ZERO);
        for row in 0..ARRIVALS {
            let mut of_row = Complex::ZERO;
            for column in row + 1..ARRIVALS {
                let entry = this.products[upper::<ARRIVALS>(row, column)];
                of_row = of_row.plus_product(entry, arrivals[column]);
            }
            // An off-diagonal entry counts twice.
            let own = this.products[upper::<ARRIVALS>(row, row)].re;
            let of_row = (of_row + of_row).plus_scaled(own, arrivals[row]);
            value = value + arrivals[row].conj_times(of_row).re;
            terms = this.apart[row].multiply_add(arrivals[row].norm_sqr(), terms);
        }
        sum.add(value, terms);
    }
}

part!(
    Add ['a, A: Arithmetic] ['a, A]
    (&'a mut QuadraticForm<A>, &'a Form<A>, &'a Carried<A>, &'a Carried<A>) -> (),
    QuadraticForm::add_inlined
);

part!(
    At ['a, A: Arithmetic] ['a, A]
    (&'a QuadraticForm<A>, &'a Amplitudes<A>, &'a mut Sum<A>) -> (),
    QuadraticForm::at_inlined
);

//! Small dense systems at several frequencies at once: elimination with partial pivoting, independent for each
//! frequency.

use super::complex::{Complex, Matrix};
use super::number::{Arithmetic, Real, part};

/// Solves `a x = b` in place of `b`. The caller scales the rows so that they are comparable. A singular `a` gives
/// values that are not finite, except 0 for an unknown with a zero pivot and a zero right-hand side.
pub(super) fn solve<A: Arithmetic, const N: usize, const R: usize>(
    a: &mut Matrix<A, N, N>,
    b: &mut Matrix<A, N, R>,
) {
    A::outlined(Solve((a, b)));
}

#[inline(always)]
fn solve_inlined<A: Arithmetic, const N: usize, const R: usize>(
    (a, b): (&mut Matrix<A, N, N>, &mut Matrix<A, N, R>),
) {
    for column in 0..N {
        bring_up_pivot(a, b, column);
        eliminate(a, b, column);
    }
    back_substitute(a, b);
}

/// [`solve`], and the determinant of `a`.
pub(super) fn solve_with_determinant<A: Arithmetic, const N: usize, const R: usize>(
    a: &mut Matrix<A, N, N>,
    b: &mut Matrix<A, N, R>,
) -> Complex<A> {
    A::outlined(SolveWithDeterminant((a, b)))
}

#[inline(always)]
fn solve_with_determinant_inlined<A: Arithmetic, const N: usize, const R: usize>(
    (a, b): (&mut Matrix<A, N, N>, &mut Matrix<A, N, R>),
) -> Complex<A> {
    let mut determinant = Complex::ONE;
    for column in 0..N {
        let sign = bring_up_pivot(a, b, column);
        determinant = determinant * a[column][column].scaled(sign);
        eliminate(a, b, column);
    }
    back_substitute(a, b);
    determinant
}

/// [`solve`], and how far `a` is from singular: the smallest ratio of a pivot to `terms`, for each column the largest
/// magnitude among the summands of its entries.
pub(super) fn solve_with_margin<A: Arithmetic, const N: usize, const R: usize>(
    a: &mut Matrix<A, N, N>,
    b: &mut Matrix<A, N, R>,
    terms: &[Real<A>; N],
) -> Real<A> {
    A::outlined(SolveWithMargin((a, b, terms)))
}

#[inline(always)]
fn solve_with_margin_inlined<A: Arithmetic, const N: usize, const R: usize>(
    (a, b, terms): (&mut Matrix<A, N, N>, &mut Matrix<A, N, R>, &[Real<A>; N]),
) -> Real<A> {
    let mut margin = Real::splat(f64::INFINITY);
    for column in 0..N {
        bring_up_pivot(a, b, column);
        let share = a[column][column].size() / terms[column];
        margin = share.where_less(margin, share, margin);
        eliminate(a, b, column);
    }
    back_substitute(a, b);
    margin
}

/// Moves the row with the largest entry of a column to the diagonal, independently at each frequency; returns the sign
/// of this exchange for the determinant.
#[inline(always)]
fn bring_up_pivot<A: Arithmetic, const N: usize, const R: usize>(
    a: &mut Matrix<A, N, N>,
    b: &mut Matrix<A, N, R>,
    column: usize,
) -> Real<A> {
    let mut sign = Real::ONE;
    let mut largest = a[column][column].size();
    for row in column + 1..N {
        let size = a[row][column].size();
        // Rare: the order of the rows suits most systems.
        if largest.is_less_somewhere(size) {
            for k in column..N {
                exchange(largest, size, a, (column, row), k);
            }
            for k in 0..R {
                exchange(largest, size, b, (column, row), k);
            }
            sign = largest.where_less(size, -sign, sign);
            largest = largest.max(size);
        }
    }
    sign
}

/// Exchanges the entries of two rows in a column where `a` is less than `b`.
#[inline(always)]
fn exchange<A: Arithmetic, const N: usize, const C: usize>(
    a: Real<A>,
    b: Real<A>,
    matrix: &mut Matrix<A, N, C>,
    (one, other): (usize, usize),
    column: usize,
) {
    let (x, y) = (matrix[one][column], matrix[other][column]);
    matrix[one][column] = Complex::where_less(a, b, y, x);
    matrix[other][column] = Complex::where_less(a, b, x, y);
}

/// Subtracts the pivot row of a column from the rows below it; leaves the inverse of the pivot in its place.
#[inline(always)]
fn eliminate<A: Arithmetic, const N: usize, const R: usize>(
    a: &mut Matrix<A, N, N>,
    b: &mut Matrix<A, N, R>,
    column: usize,
) {
    let pivot = a[column][column];
    let mut inverse = pivot.inverse();
    if pivot.size().is_less_somewhere(least()) {
        // The column below it is also zero.
        inverse = Complex::where_less(pivot.size(), least(), Complex::ZERO, inverse);
    }
    a[column][column] = inverse;
    for row in column + 1..N {
        let factor = a[row][column] * inverse;
        for k in column + 1..N {
            a[row][k] = a[row][k].minus_product(factor, a[column][k]);
        }
        for k in 0..R {
            b[row][k] = b[row][k].minus_product(factor, b[column][k]);
        }
    }
}

/// Smaller than any pivot but zero.
#[inline(always)]
fn least<A: Arithmetic>() -> Real<A> {
    Real::splat(f64::MIN_POSITIVE)
}

/// An unknown from its right-hand side; a zero pivot has the `inverse` zero.
#[inline(always)]
fn over_zero<A: Arithmetic>(right: Complex<A>, inverse: Complex<A>) -> Complex<A> {
    let infinite = Complex::from_real(Real::splat(f64::INFINITY));
    let driven = Complex::where_less(right.size(), least(), Complex::ZERO, infinite);
    Complex::where_less(inverse.size(), least(), driven, right * inverse)
}

/// Solves the upper triangle of `a`, whose diagonal holds inverses, in place of `b`.
#[inline(always)]
fn back_substitute<A: Arithmetic, const N: usize, const R: usize>(
    a: &Matrix<A, N, N>,
    b: &mut Matrix<A, N, R>,
) {
    for row in (0..N).rev() {
        let inverse = a[row][row];
        let has_zero = inverse.size().is_less_somewhere(least());
        for k in 0..R {
            let mut sum = b[row][k];
            for column in row + 1..N {
                sum = sum.minus_product(a[row][column], b[column][k]);
            }
            b[row][k] = if has_zero {
                over_zero(sum, inverse)
            } else {
                sum * inverse
            };
        }
    }
}

part!(
    Solve ['a, A: Arithmetic, const N: usize, const R: usize] ['a, A, N, R]
    (&'a mut Matrix<A, N, N>, &'a mut Matrix<A, N, R>) -> (),
    solve_inlined
);

part!(
    SolveWithDeterminant ['a, A: Arithmetic, const N: usize, const R: usize] ['a, A, N, R]
    (&'a mut Matrix<A, N, N>, &'a mut Matrix<A, N, R>) -> Complex<A>,
    solve_with_determinant_inlined
);

part!(
    SolveWithMargin ['a, A: Arithmetic, const N: usize, const R: usize] ['a, A, N, R]
    (&'a mut Matrix<A, N, N>, &'a mut Matrix<A, N, R>, &'a [Real<A>; N]) -> Real<A>,
    solve_with_margin_inlined
);

//! Small dense complex systems, solved by elimination with row equilibration and partial pivoting.

use num_complex::Complex64;

/// A matrix of `R` rows and `C` columns.
pub(super) type Matrix<const R: usize, const C: usize> = [[Complex64; C]; R];

/// Zero.
pub(super) const ZERO: Complex64 = Complex64::new(0.0, 0.0);

/// A matrix of zeros.
pub(super) const fn zeros<const R: usize, const C: usize>() -> Matrix<R, C> {
    [[ZERO; C]; R]
}

/// The size that pivoting compares: cheaper than the modulus and within a factor of sqrt 2 of it.
pub(super) fn size(z: Complex64) -> f64 {
    z.re.abs() + z.im.abs()
}

/// Solves `a x = b` for `R` right-hand sides. A singular `a` gives values that are not finite, except 0 for an unknown
/// with a zero pivot and a zero right-hand side: what nothing drives does not move, however near its resonance is.
///
/// Blocks of exact zeros stay exact zeros: no operation mixes a decoupled unknown into the others.
pub(super) fn solve<const N: usize, const R: usize>(
    a: Matrix<N, N>,
    b: Matrix<N, R>,
) -> Matrix<N, R> {
    solve_with_margin(a, b, a.map(|row| row.map(size))).0
}

/// [`solve`], and how far `a` is from singular: the least share that a pivot is of the terms in its column.
///
/// `terms` holds the size of what was summed to each entry of `a`, so that a sum which cancels counts as small. Near
/// the rounding of the arithmetic, 1e-16, the solution has no correct digit.
pub(super) fn solve_with_margin<const N: usize, const R: usize>(
    mut a: Matrix<N, N>,
    mut b: Matrix<N, R>,
    mut terms: [[f64; N]; N],
) -> (Matrix<N, R>, f64) {
    equilibrate(&mut a, &mut b, &mut terms);
    let mut margin = f64::INFINITY;
    for column in 0..N {
        let pivot = pivot_row(&a, column);
        a.swap(column, pivot);
        b.swap(column, pivot);
        let largest = terms.iter().map(|row| row[column]).fold(0.0, f64::max);
        margin = margin.min(size(a[column][column]) / largest);
        eliminate(&mut a, &mut b, column);
    }
    back_substitute(&a, &mut b);
    (b, margin)
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

/// Subtracts the pivot row of a column from the rows below it.
fn eliminate<const N: usize, const R: usize>(
    a: &mut Matrix<N, N>,
    b: &mut Matrix<N, R>,
    column: usize,
) {
    let inverse = a[column][column].inv();
    let (pivot_a, pivot_b) = (a[column], b[column]);
    for row in column + 1..N {
        if a[row][column] == ZERO {
            continue;
        }
        let factor = a[row][column] * inverse;
        for k in column + 1..N {
            a[row][k] -= factor * pivot_a[k];
        }
        for k in 0..R {
            b[row][k] -= factor * pivot_b[k];
        }
    }
}

/// Scales every row by a power of two to terms near 1, so that pivots of rows in different units compare.
fn equilibrate<const N: usize, const R: usize>(
    a: &mut Matrix<N, N>,
    b: &mut Matrix<N, R>,
    terms: &mut [[f64; N]; N],
) {
    for ((row, right), terms) in a.iter_mut().zip(b).zip(terms) {
        let largest = terms.iter().copied().fold(0.0, f64::max);
        if largest > 0.0 && largest.is_finite() {
            let scale = (-largest.log2().floor()).exp2();
            row.iter_mut().chain(right).for_each(|z| *z *= scale);
            for term in terms {
                *term *= scale;
            }
        }
    }
}

/// The row at or below `column` with the largest entry in it; the first of equals.
fn pivot_row<const N: usize>(a: &Matrix<N, N>, column: usize) -> usize {
    let mut best = column;
    for row in column + 1..N {
        if size(a[row][column]) > size(a[best][column]) {
            best = row;
        }
    }
    best
}

/// Solves the upper triangle of `a` in place of `b`.
fn back_substitute<const N: usize, const R: usize>(a: &Matrix<N, N>, b: &mut Matrix<N, R>) {
    for row in (0..N).rev() {
        let pivot = a[row][row];
        let inverse = pivot.inv();
        for k in 0..R {
            let mut sum = b[row][k];
            for column in row + 1..N {
                sum -= a[row][column] * b[column][k];
            }
            let is_undriven = pivot == ZERO && sum == ZERO;
            b[row][k] = if is_undriven { ZERO } else { sum * inverse };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_badly_scaled_system_is_solved_to_rounding() {
        // Closed form: the right-hand side is the matrix times a known vector of small integers.
        let entries = [[1e-9, 2e-9, 0.5e-9], [3e6, -1e6, 4e6], [2.0, 7.0, -3.0]];
        let a = entries.map(|row: [f64; 3]| row.map(|x| Complex64::new(x, 0.5 * x)));
        let x = [
            Complex64::new(1.0, 2.0),
            Complex64::new(-3.0, 0.0),
            Complex64::new(2.0, -1.0),
        ];
        let b = a.map(|row| [row.iter().zip(&x).map(|(a, x)| a * x).sum()]);
        let solved = solve::<3, 1>(a, b);
        for (got, want) in solved.iter().zip(&x) {
            assert!((got[0] - want).norm() < 1e-14, "{got:?} {want}");
        }
    }

    #[test]
    fn a_singular_system_is_not_finite() {
        let one = Complex64::new(1.0, 0.0);
        let solved = solve::<2, 1>([[one, one], [one, one]], [[one], [-one]]);
        assert!(solved.iter().any(|x| !x[0].is_finite()));
    }

    #[test]
    fn what_nothing_drives_stays_at_zero_though_it_is_singular() {
        // Closed form: 2 x = 4 beside 0 y = 0, whose limit is 0 as the zero is approached.
        let [zero, two, four] = [0.0, 2.0, 4.0].map(|re| Complex64::new(re, 0.0));
        let solved = solve::<2, 1>([[two, zero], [zero, zero]], [[four], [zero]]);
        assert_eq!(solved, [[two], [zero]]);
    }
}

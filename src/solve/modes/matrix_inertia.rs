//! The inertia of a small symmetric matrix: the number of its negative eigenvalues.
//!
//! By Sylvester's law a congruence preserves it, so it follows from the 1x1 and 2x2 pivots of a symmetric elimination.
//! The pivots are those of Bunch & Parlett, SIAM J. Numer. Anal. 8 (1971) 639-655: the elimination is backward stable,
//! so the count is that of a matrix within rounding of the given one.

use nalgebra::SMatrix;

/// (1 + sqrt 17) / 8: the least growth of the entries (Bunch & Parlett 1971).
const ALPHA: f64 = 0.640_388_203_202_208;

/// The elimination of a symmetric matrix: its number of negative eigenvalues, and its inverse times `right`.
#[derive(Debug)]
pub(super) struct Eliminated<const N: usize, const R: usize> {
    /// The number of eigenvalues below 0.
    pub(super) negatives: usize,
    /// `a^-1 right`.
    pub(super) solution: SMatrix<f64, N, R>,
}

/// The number of negative eigenvalues of a symmetric matrix.
pub(super) fn negatives<const N: usize>(a: &SMatrix<f64, N, N>) -> usize {
    eliminate(a, &SMatrix::<f64, N, 0>::zeros()).negatives
}

/// Eliminates a symmetric `a` together with `right`. The pivots depend on the size of the entries: scale first.
pub(super) fn eliminate<const N: usize, const R: usize>(
    a: &SMatrix<f64, N, N>,
    right: &SMatrix<f64, N, R>,
) -> Eliminated<N, R> {
    let mut work = Work {
        a: *a,
        b: *right,
        order: std::array::from_fn(|index| index),
    };
    // The first index and the size of each pivot.
    let mut pivots = [(0, 0); N];
    let (mut count, mut first, mut negatives) = (0, 0, 0);
    while first < N {
        let size = work.choose(first);
        negatives += work.negatives(first, size);
        work.subtract(first, size);
        pivots[count] = (first, size);
        count += 1;
        first += size;
    }
    for &(first, size) in pivots[..count].iter().rev() {
        work.substitute(first, size);
    }
    let mut solution = SMatrix::<f64, N, R>::zeros();
    for (row, &original) in work.order.iter().enumerate() {
        solution.set_row(original, &work.b.row(row));
    }
    Eliminated {
        negatives,
        solution,
    }
}

struct Work<const N: usize, const R: usize> {
    a: SMatrix<f64, N, N>,
    b: SMatrix<f64, N, R>,
    order: [usize; N],
}

impl<const N: usize, const R: usize> Work<N, R> {
    /// Moves the pivot of the part from `first` on to its front; returns its size, 1 or 2.
    fn choose(&mut self, first: usize) -> usize {
        let (mut diagonal, mut other) = ((first, 0.0), (first, first, 0.0));
        for row in first..N {
            if self.a[(row, row)].abs() > diagonal.1 {
                diagonal = (row, self.a[(row, row)].abs());
            }
            for column in first..row {
                if self.a[(row, column)].abs() > other.2 {
                    other = (row, column, self.a[(row, column)].abs());
                }
            }
        }
        if diagonal.1 >= ALPHA * other.2 {
            self.swap(first, diagonal.0);
            if diagonal.1 == 0.0 {
                // Singular up to rounding: counts as slightly positive.
                self.a[(first, first)] = f64::EPSILON;
            }
            return 1;
        }
        self.swap(first, other.1);
        self.swap(first + 1, other.0);
        2
    }

    fn swap(&mut self, i: usize, j: usize) {
        if i != j {
            self.a.swap_rows(i, j);
            self.a.swap_columns(i, j);
            self.b.swap_rows(i, j);
            self.order.swap(i, j);
        }
    }

    /// A 2x2 pivot is chosen only if its determinant is negative: one eigenvalue of each sign.
    fn negatives(&self, first: usize, size: usize) -> usize {
        usize::from(size == 2 || self.a[(first, first)] < 0.0)
    }

    /// The inverse of the pivot times a column of two numbers (the second is 0 for a 1x1 pivot).
    fn inverse_times(&self, first: usize, size: usize, x: [f64; 2]) -> [f64; 2] {
        let p = self.a[(first, first)];
        if size == 1 {
            return [x[0] / p, 0.0];
        }
        let (q, r) = (self.a[(first + 1, first)], self.a[(first + 1, first + 1)]);
        // Divides by q first: its square may have a very different size than p r.
        let determinant = (p / q) * r - q;
        [
            ((r / q) * x[0] - x[1]) / determinant,
            ((p / q) * x[1] - x[0]) / determinant,
        ]
    }

    /// Eliminates the pivot's columns from all rows below.
    fn subtract(&mut self, first: usize, size: usize) {
        let last = first + size - 1;
        for row in last + 1..N {
            let entries = [self.a[(row, first)], self.a[(row, last)]];
            let [x, y] = self.inverse_times(first, size, entries);
            for column in last + 1..=row {
                let change = x * self.a[(column, first)] + y * self.a[(column, last)];
                self.a[(row, column)] -= change;
                self.a[(column, row)] = self.a[(row, column)];
            }
            for k in 0..R {
                self.b[(row, k)] -= x * self.b[(first, k)] + y * self.b[(last, k)];
            }
        }
    }

    /// Solves the pivot's unknowns from those below.
    fn substitute(&mut self, first: usize, size: usize) {
        let last = first + size - 1;
        for k in 0..R {
            let mut x = [self.b[(first, k)], self.b[(last, k)]];
            for row in last + 1..N {
                x[0] -= self.a[(row, first)] * self.b[(row, k)];
                x[1] -= self.a[(row, last)] * self.b[(row, k)];
            }
            let solved = self.inverse_times(first, size, x);
            self.b[(first, k)] = solved[0];
            if size == 2 {
                self.b[(last, k)] = solved[1];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix4, SymmetricEigen};
    use proptest::prelude::*;

    proptest! {
        /// Expected: the eigenvalues by another method (QR), and the product back to the right-hand side.
        #[test]
        fn counts_and_solves(entries in proptest::array::uniform10(-4.0..4.0_f64)) {
            let mut a = Matrix4::zeros();
            let mut next = entries.iter();
            for row in 0..4 {
                for column in 0..=row {
                    a[(row, column)] = next.next().unwrap().round();
                    a[(column, row)] = a[(row, column)];
                }
            }
            let eigenvalues = SymmetricEigen::new(a).eigenvalues;
            prop_assume!(eigenvalues.iter().all(|x| x.abs() > 1e-6));
            let eliminated = eliminate(&a, &Matrix4::identity());
            prop_assert_eq!(
                eliminated.negatives,
                eigenvalues.iter().filter(|&&x| x < 0.0).count()
            );
            prop_assert!((a * eliminated.solution - Matrix4::identity()).norm() < 1e-8);
        }
    }
}

//! A complex band matrix and its factors.
//!
//! Pivoting within the band follows Golub & Van Loan, *Matrix Computations*, Section 4.3.3: row exchanges widen the
//! upper band from b to at most 2b. The matrices are symmetric, but indefinite above the first resonance, so that a
//! symmetric elimination without pivoting could lose digits.

use num_complex::Complex64;

/// A square matrix whose entries lie within `half_width` of the diagonal; after [`factor`](Self::factor) its factors.
#[derive(Debug, Default)]
pub(super) struct Band {
    unknowns: usize,
    half_width: usize,
    /// Rows of `3 half_width + 1`, from the lowest possible column; the last `half_width` are for pivoting.
    entries: Vec<Complex64>,
    /// The row exchanged with each diagonal row.
    pivots: Vec<usize>,
    /// The last column that the exchanged rows so far may reach.
    reach: usize,
}

impl Band {
    /// Sets the size and makes all entries zero.
    pub(super) fn clear(&mut self, unknowns: usize, half_width: usize) {
        self.unknowns = unknowns;
        self.half_width = half_width;
        self.entries.clear();
        self.entries
            .resize(unknowns * (3 * half_width + 1), Complex64::ZERO);
    }

    /// Row `row` from the lowest column within the band, `2 half_width + 1` entries; those outside the matrix are
    /// ignored.
    pub(super) fn row_mut(&mut self, row: usize) -> &mut [Complex64] {
        let start = row * (3 * self.half_width + 1);
        &mut self.entries[start..=start + 2 * self.half_width]
    }

    /// Index of an entry; `column` within the band.
    fn at(&self, row: usize, column: usize) -> usize {
        row * (3 * self.half_width + 1) + column + self.half_width - row
    }

    /// The last row that reaches a column.
    fn last_row(&self, column: usize) -> usize {
        (column + self.half_width).min(self.unknowns - 1)
    }

    /// The last column that a row may reach after pivoting.
    fn last_column(&self, row: usize) -> usize {
        (row + 2 * self.half_width).min(self.unknowns - 1)
    }

    /// Replaces the matrix by its factors.
    ///
    /// Uncoupled blocks stay uncoupled: a factor of exactly zero adds nothing.
    pub(super) fn factor(&mut self) {
        self.pivots.clear();
        self.reach = 0;
        for pivot in 0..self.unknowns {
            self.bring_largest(pivot);
            self.eliminate(pivot);
        }
    }

    /// Exchanges rows so that the largest entry of the pivot's column is on the diagonal.
    fn bring_largest(&mut self, pivot: usize) {
        let mut best = pivot;
        let mut largest = -1.0;
        for row in pivot..=self.last_row(pivot) {
            let size = self.entries[self.at(row, pivot)].norm_sqr();
            if size > largest {
                (best, largest) = (row, size);
            }
        }
        if best != pivot {
            let (upper, lower) = (self.at(pivot, pivot), self.at(best, pivot));
            for offset in 0..=self.last_column(pivot) - pivot {
                self.entries.swap(upper + offset, lower + offset);
            }
        }
        self.reach = self.reach.max(self.last_row(best));
        self.pivots.push(best);
    }

    /// Subtracts the pivot's row from those below and stores the factors there.
    fn eliminate(&mut self, pivot: usize) {
        let width = self.reach - pivot;
        let diagonal = self.at(pivot, pivot);
        let inverse = 1.0 / self.entries[diagonal];
        for row in pivot + 1..=self.last_row(pivot) {
            let start = self.at(row, pivot);
            if self.entries[start] == Complex64::ZERO {
                continue;
            }
            let factor = self.entries[start] * inverse;
            let (above, below) = self.entries.split_at_mut(start);
            let source = &above[diagonal + 1..=diagonal + width];
            below[0] = factor;
            for (target, source) in below[1..=width].iter_mut().zip(source) {
                *target -= factor * source;
            }
        }
    }

    /// Solves for the right-hand side `x` in place, with the factors; a singular matrix gives values that are not
    /// finite.
    pub(super) fn solve(&self, x: &mut [Complex64]) {
        for pivot in 0..self.unknowns {
            x.swap(pivot, self.pivots[pivot]);
            let known = x[pivot];
            if known != Complex64::ZERO {
                for row in pivot + 1..=self.last_row(pivot) {
                    x[row] -= self.entries[self.at(row, pivot)] * known;
                }
            }
        }
        for row in (0..self.unknowns).rev() {
            let diagonal = self.at(row, row);
            let width = self.last_column(row) - row;
            let upper = &self.entries[diagonal + 1..=diagonal + width];
            let sum: Complex64 = upper.iter().zip(&x[row + 1..]).map(|(a, x)| a * x).sum();
            x[row] = (x[row] - sum) / self.entries[diagonal];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: the right-hand side is made from the solution 1, 2, 3, ...; the diagonal is too small to pivot on.
    #[test]
    fn a_band_system_is_solved_with_pivoting() {
        let (unknowns, half_width) = (9, 2);
        let entry = |row: usize, column: usize| {
            let far = row.abs_diff(column);
            let size = [1e-18, 1.0, 0.3][far];
            Complex64::new(size, 0.1 * (row + 2 * column) as f64 * size)
        };
        let mut band = Band::default();
        band.clear(unknowns, half_width);
        let mut x = vec![Complex64::ZERO; unknowns];
        for row in 0..unknowns {
            for column in row.saturating_sub(half_width)..(row + half_width + 1).min(unknowns) {
                band.row_mut(row)[column + half_width - row] = entry(row, column);
                x[row] += entry(row, column) * (column + 1) as f64;
            }
        }
        band.factor();
        band.solve(&mut x);
        for (index, x) in x.iter().enumerate() {
            assert!((x - (index + 1) as f64).norm() < 1e-13, "{index}: {x}");
        }
    }

    #[test]
    fn a_singular_matrix_gives_no_finite_value() {
        let mut band = Band::default();
        band.clear(2, 1);
        band.row_mut(0)[1] = Complex64::ONE;
        let mut x = [Complex64::ONE; 2];
        band.factor();
        band.solve(&mut x);
        assert!(!x[1].is_finite());
    }
}

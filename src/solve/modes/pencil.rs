//! Eigenvalues and vectors of a small pencil of complex symmetric matrices, equal and nearly equal ones included.
//!
//! `second y = t first y`, with vectors that are orthogonal under `first` (without conjugation), like the modes of a
//! damped system (Foss, J. Appl. Mech. 25 (1958) 361-364). The Schur form separates distinct eigenvalues; close ones
//! share one space, in which the pencil is formed again, centred on their mean and scaled to their spread.

use nalgebra::{DMatrix, DVector, Schur};
use num_complex::Complex64;

/// An eigenvalue, and its vector with `y^T first y = 1`.
#[derive(Debug, Clone)]
pub(super) struct Pair {
    pub(super) value: Complex64,
    pub(super) vector: DVector<Complex64>,
}

/// All pairs of a pencil with eigenvalues of about 1 or smaller; `None` if `first` is singular. Eigenvalues that differ
/// by less than `noise` count as equal, with any basis of their space: their computed vectors may be far from
/// orthogonal.
pub(super) fn pairs(
    first: &DMatrix<Complex64>,
    second: &DMatrix<Complex64>,
    noise: f64,
) -> Option<Vec<Pair>> {
    const LEAST: f64 = 1e-14;
    const DEEPEST: usize = 8;
    let noise = noise.max(LEAST);
    separated(&symmetric(first), &symmetric(second), noise, DEEPEST)
}

/// The eigenvalues of `second y = t first y` for each of some matrices `second`, of any size; `None` if `first` is
/// singular, and for a matrix that is not finite.
pub(in crate::solve) fn eigenvalues(
    first: &DMatrix<Complex64>,
    seconds: &[DMatrix<Complex64>],
) -> Option<Vec<Option<Vec<Complex64>>>> {
    let basis = orthonormal(&symmetric(first))?;
    let of = |second: &DMatrix<Complex64>| {
        if !second.iter().all(|value| value.is_finite()) {
            return None;
        }
        let (_, triangle) = schur(&symmetric(&(basis.transpose() * second * &basis)))?;
        Some(triangle.diagonal().iter().copied().collect())
    };
    Some(seconds.iter().map(of).collect())
}

fn symmetric(a: &DMatrix<Complex64>) -> DMatrix<Complex64> {
    (a + a.transpose()) * Complex64::from(0.5)
}

/// The pairs of a pencil; `depth` is how many more times a close group may be formed again.
fn separated(
    first: &DMatrix<Complex64>,
    second: &DMatrix<Complex64>,
    noise: f64,
    depth: usize,
) -> Option<Vec<Pair>> {
    const CLOSE: f64 = 0.01;
    let count = first.nrows();
    let basis = orthonormal(first)?;
    let mut matrix = symmetric(&(basis.transpose() * second * &basis));
    let mean = matrix.trace() / count as f64;
    for index in 0..count {
        matrix[(index, index)] -= mean;
    }
    let spread = matrix.norm();
    if count == 1 || spread < noise || depth == 0 {
        return Some(columns(&basis, mean));
    }
    matrix /= Complex64::from(spread);
    let (q, t) = schur(&matrix)?;
    let values: Vec<Complex64> = t.diagonal().iter().copied().collect();
    let mut groups = groups(&values, CLOSE);
    let apart = groups.len() > 1;
    if !apart {
        // No eigenvalue is separate, as near a defective one: the vectors stay as they are.
        groups = (0..count).map(|index| vec![index]).collect();
    }
    let mut pairs = Vec::new();
    for mut group in groups {
        group.sort_unstable();
        let space = &q * invariant(&t, &group);
        let inner_first = symmetric(&(space.transpose() * &space));
        let inner = if apart {
            let inner_second = symmetric(&(space.transpose() * &matrix * &space));
            separated(&inner_first, &inner_second, noise / spread, depth - 1)?
        } else {
            let norm = orthonormal(&inner_first)?;
            columns(&norm, values[group[0]])
        };
        for Pair { value, vector } in inner {
            pairs.push(Pair {
                value: mean + spread * value,
                vector: &basis * (&space * vector),
            });
        }
    }
    Some(pairs)
}

/// The unitary and the triangular factor; equal eigenvalues may need a tolerance above the rounding of one operation.
fn schur(matrix: &DMatrix<Complex64>) -> Option<(DMatrix<Complex64>, DMatrix<Complex64>)> {
    const TOLERANCES: [f64; 4] = [1.0, 8.0, 64.0, 4096.0];
    const MOST_STEPS: usize = 1000;
    let by = |units: f64| Schur::try_new(matrix.clone(), units * f64::EPSILON, MOST_STEPS);
    TOLERANCES.into_iter().find_map(by).map(Schur::unpack)
}

fn columns(basis: &DMatrix<Complex64>, value: Complex64) -> Vec<Pair> {
    let vectors = basis.column_iter().map(nalgebra::Matrix::into_owned);
    vectors.map(|vector| Pair { value, vector }).collect()
}

/// A matrix Z with `Z^T form Z = 1`; `None` if the form is singular.
///
/// A vector that is orthogonal to itself, like (1, i), has no norm: then the sum of two replaces it.
fn orthonormal(form: &DMatrix<Complex64>) -> Option<DMatrix<Complex64>> {
    const SINGULAR: f64 = 1e-15;
    let count = form.nrows();
    let scale = form.norm();
    let mut basis = DMatrix::<Complex64>::identity(count, count);
    // The form in the remaining vectors.
    let mut rest = form.clone();
    for index in 0..count {
        let (row, column) = largest(&rest, index);
        if rest[(row, column)].norm() <= SINGULAR * scale {
            return None;
        }
        basis.swap_columns(index, row);
        rest.swap_rows(index, row);
        rest.swap_columns(index, row);
        if row != column {
            // `column` is beyond `index`, so the swap did not move it.
            let other = basis.column(column).into_owned();
            let mut own = basis.column_mut(index);
            own += other;
            let added = rest.row(column).into_owned();
            let mut own = rest.row_mut(index);
            own += added;
            let added = rest.column(column).into_owned();
            let mut own = rest.column_mut(index);
            own += added;
        }
        let norm = rest[(index, index)].sqrt();
        let unit = basis.column(index) / norm;
        basis.set_column(index, &unit);
        let products: Vec<Complex64> = (0..count).map(|k| rest[(index, k)] / norm).collect();
        for other in index + 1..count {
            let share = products[other];
            let taken = basis.column(index) * share;
            let mut column = basis.column_mut(other);
            column -= taken;
            for k in index + 1..count {
                rest[(other, k)] -= share * products[k];
            }
        }
    }
    Some(basis)
}

/// The position of the largest entry of the form from `index` on: on its diagonal, unless another entry is much larger.
fn largest(form: &DMatrix<Complex64>, index: usize) -> (usize, usize) {
    const FAR: f64 = 4.0;
    let (mut best, mut other) = ((index, index), (index, index));
    let size = |(row, column): (usize, usize)| form[(row, column)].norm();
    for row in index..form.nrows() {
        if size((row, row)) > size(best) {
            best = (row, row);
        }
        for column in row + 1..form.nrows() {
            if size((row, column)) > size(other) || other.0 == other.1 {
                other = (row, column);
            }
        }
    }
    if other.0 != other.1 && size(other) > FAR * size(best) {
        other
    } else {
        best
    }
}

/// The indices of values within a chain of distances below `close`.
pub(super) fn groups(values: &[Complex64], close: f64) -> Vec<Vec<usize>> {
    let mut left: Vec<usize> = (0..values.len()).collect();
    let mut groups = Vec::new();
    while let Some(start) = left.pop() {
        let mut group = vec![start];
        let mut next = 0;
        while next < group.len() {
            let here = values[group[next]];
            let (near, far) = left
                .into_iter()
                .partition(|&index| (values[index] - here).norm() < close);
            let near: Vec<usize> = near;
            group.extend(near);
            left = far;
            next += 1;
        }
        groups.push(group);
    }
    groups
}

/// A basis of the invariant space of an upper triangle for some of its diagonal entries (ascending), each column with
/// one of these rows at 1 and the others at 0.
fn invariant(t: &DMatrix<Complex64>, group: &[usize]) -> DMatrix<Complex64> {
    let mut space = DMatrix::zeros(t.nrows(), group.len());
    let negligible = f64::EPSILON * t.norm();
    for (column, &index) in group.iter().enumerate() {
        space[(index, column)] = Complex64::ONE;
        for row in (0..index).rev().filter(|row| !group.contains(row)) {
            let above: Complex64 = (row + 1..=index)
                .map(|k| t[(row, k)] * space[(k, column)])
                .sum();
            let within = group[..column].iter().enumerate();
            let within: Complex64 = within
                .map(|(other, &g)| space[(row, other)] * t[(g, index)])
                .sum();
            let gap = t[(row, row)] - t[(index, index)];
            let gap = if gap.norm() > negligible {
                gap
            } else {
                negligible.into()
            };
            space[(row, column)] = (within - above) / gap;
        }
    }
    for mut column in space.column_iter_mut() {
        let norm = column.norm();
        column /= Complex64::from(norm);
    }
    space
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// Expected: by construction, `first = X X^T` and `second = X diag(t) X^T`: the values are t, and the vectors the
    /// columns of X^-T, orthogonal under `first`. Values are equal, differ by 1e-11, or are distinct.
    #[test]
    fn equal_and_nearly_equal_values_have_orthogonal_vectors() {
        let entry = |i: usize, j: usize| {
            let x = (12.3 * i as f64 + 4.7 * j as f64 + (i * j) as f64).sin();
            Complex64::new(x, (3.1 * x + i as f64).cos())
        };
        let known = [0.3, 0.3, 0.3, 0.3 + 1e-11, 0.7, -0.2, -0.2].map(Complex64::from);
        let x = DMatrix::from_fn(7, 7, entry);
        let t = DMatrix::from_diagonal(&DVector::from_column_slice(&known));
        let (first, second) = (&x * x.transpose(), &x * t * x.transpose());
        let found = pairs(&first, &second, 0.0).unwrap();
        let mut values: Vec<Complex64> = found.iter().map(|pair| pair.value).collect();
        values.sort_by(|a, b| a.re.total_cmp(&b.re));
        let mut known = known.to_vec();
        known.sort_by(|a, b| a.re.total_cmp(&b.re));
        for (value, known) in values.iter().zip(known) {
            assert!((value - known).norm() < 1e-12, "{value} {known}");
        }
        let y = DMatrix::from_columns(
            &found
                .iter()
                .map(|pair| pair.vector.clone())
                .collect::<Vec<_>>(),
        );
        let products = y.transpose() * &first * &y - DMatrix::identity(7, 7);
        assert!(products.norm() < 1e-10, "{products}");
    }

    /// Expected: closed form; (1, i) is orthogonal to itself under the identity.
    #[test]
    fn a_form_with_no_diagonal_has_a_basis() {
        let form = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 0.0].map(Complex64::from));
        let basis = orthonormal(&form).unwrap();
        let products = basis.transpose() * form * &basis - DMatrix::identity(2, 2);
        assert!(products.norm() < 1e-15);
    }
}

//! Transfer matrices over a short length by power series: one solution for each unit state at the start.
//!
//! With the rotations s of the section and the internal moments m and forces f the state of a beam without damping splits
//! into e = (q, m) and o = (s, f),
//!
//! ```text
//! q' = (1 + F C)^-1 (s + F f),  m' = C q' - omega^2 R s - f,   s' = D^-1 m,  f' = -omega^2 M q
//! ```
//!
//! so that its series has even and odd powers apart. Forces follow from the inertia forces along the length and not from
//! third derivatives: nothing cancels if the span moves as a rigid body.

use nalgebra::SMatrix;

use super::dynamic_stiffness::{Block, Transfer};

/// Terms of the power series: 1.5^30 / 30! is below 1e-26.
const TERMS: usize = 30;

/// The transfer matrix of `K` coupled motions over a length h; `N` is twice `K`. Degrees of freedom are the motions, then
/// their slopes.
pub(super) fn transfer<const K: usize, const N: usize>(block: &Block<K>, h: f64) -> Transfer<N> {
    let (to_even, to_odd) = derivatives::<K, N>(block);
    let even = sums(&to_even, &to_odd, h);
    let odd = sums(&to_odd, &to_even, h);
    // Motions and moments are in e, slopes and forces in o; with their indices there.
    let place = |is_force: bool, row: usize| match (is_force, row < K) {
        (false, true) | (true, false) => (true, row),
        (false, false) => (false, row - K),
        (true, true) => (false, K + row),
    };
    let part = |of: bool, by: bool| {
        SMatrix::<f64, N, N>::from_fn(|row, column| {
            let ((to_e, to), (from_e, from)) = (place(of, row), place(by, column));
            let start = if from_e { &even } else { &odd };
            let end = if to_e == from_e {
                &start.same
            } else {
                &start.other
            };
            end[(to, from)]
        })
    };
    Transfer {
        a: part(false, false),
        b: part(false, true),
        c: part(true, false),
        d: part(true, true),
    }
}

/// The matrices of e' from o and of o' from e.
///
/// Without warping stiffness the rate of twist is not a degree of freedom but follows from the torque; an independent
/// foundation replaces it and its moment, and adds no mode.
fn derivatives<const K: usize, const N: usize>(
    block: &Block<K>,
) -> (SMatrix<f64, N, N>, SMatrix<f64, N, N>) {
    let mut to_even = SMatrix::<f64, N, N>::zeros();
    let mut to_odd = SMatrix::<f64, N, N>::zeros();
    // q' as a function of o.
    let mut of_slopes = SMatrix::<f64, K, K>::identity() + block.shear * block.tension;
    let mut by_state = SMatrix::<f64, K, N>::zeros();
    for row in 0..K {
        by_state[(row, row)] = 1.0;
        by_state[(row, K + row)] = block.shear[(row, row)];
    }
    if let Some(twist) = block.without_warping {
        of_slopes.set_row(twist, &block.tension.row(twist));
        by_state[(twist, twist)] = 0.0;
        by_state[(twist, K + twist)] = 1.0;
    }
    let inverse = of_slopes.try_inverse().unwrap_or_else(SMatrix::zeros);
    let slopes = inverse * by_state;
    let tension = block.tension * slopes;
    for row in 0..K {
        for column in 0..N {
            to_even[(row, column)] = slopes[(row, column)];
            to_even[(K + row, column)] = tension[(row, column)];
        }
        to_even[(K + row, K + row)] -= 1.0;
        for column in 0..K {
            to_even[(K + row, column)] -= block.rotary[(row, column)];
            to_odd[(row, K + column)] = block.flexibility[(row, column)];
            to_odd[(K + row, column)] = -block.mass[(row, column)];
        }
        if block.without_warping == Some(row) {
            to_even.row_mut(K + row).fill(0.0);
            to_even[(K + row, row)] = 1.0;
            to_odd[(row, K + row)] = 1.0;
        }
    }
    (to_even, to_odd)
}

/// The series from unit states of one kind: the end states of the same and of the other kind.
struct Sums<const N: usize> {
    same: SMatrix<f64, N, N>,
    other: SMatrix<f64, N, N>,
}

/// `back` gives the derivatives of the same kind from the other one, `forth` the opposite.
fn sums<const N: usize>(back: &SMatrix<f64, N, N>, forth: &SMatrix<f64, N, N>, h: f64) -> Sums<N> {
    let mut term = SMatrix::<f64, N, N>::identity();
    let mut sums = Sums {
        same: term,
        other: SMatrix::zeros(),
    };
    for power in (1..TERMS).step_by(2) {
        let to_other = forth * term * (h / power as f64);
        sums.other += to_other;
        term = back * to_other * (h / (power + 1) as f64);
        sums.same += term;
    }
    sums
}

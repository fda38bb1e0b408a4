//! A span of the undamped beam at one frequency, in real numbers: transfer matrix, dynamic stiffness, clamped count.
//!
//! All numbers are dimensionless: lengths in units of a reference length, twist times a radius of gyration, stiffnesses
//! over `E Iy / length^3`, with the same three for all parts of the beam. Degrees of freedom are (w, psi, v, w', psi', v'), as in
//! [`BeamMotion`](crate::model::BeamMotion). The solutions are power series of the equations of motion (for the paper's
//! beam: Chen & Liu, Mathematics 2022, 10(16), 2849, Eqs. 11 to 13): they use no waves, so this count is independent of
//! the frequency responses. Motions without coupling are separate, each with its own step.

use nalgebra::{Matrix3, Matrix6, SMatrix};

use super::matrix_inertia::eliminate;
use super::series::transfer;

/// Index of psi among the motions (w, psi, v).
const PSI: usize = 1;

/// The dimensionless matrices of a part of the beam at one frequency, along its own shear centres: see
/// [`crate::solve::beam_matrices`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Field {
    /// D, over `E Iy`.
    pub(super) bending: Matrix3<f64>,
    /// C, times length^2.
    pub(super) tension: Matrix3<f64>,
    /// omega^2 R, times length^2.
    pub(super) rotary: Matrix3<f64>,
    /// F, over length^2: diagonal.
    pub(super) shear: Matrix3<f64>,
    /// omega^2 M, times length^4.
    pub(super) inertia: Matrix3<f64>,
    /// The foundation, times length^4.
    pub(super) foundation: Matrix3<f64>,
}

/// The same for some motions that are coupled to no others.
#[derive(Debug, Clone)]
pub(super) struct Block<const K: usize> {
    /// D^-1; 0 for twist without warping stiffness.
    pub(super) flexibility: SMatrix<f64, K, K>,
    pub(super) tension: SMatrix<f64, K, K>,
    pub(super) rotary: SMatrix<f64, K, K>,
    pub(super) shear: SMatrix<f64, K, K>,
    /// omega^2 M less the foundation.
    pub(super) mass: SMatrix<f64, K, K>,
    inertia: SMatrix<f64, K, K>,
    /// The index of the twist, if it has no warping stiffness.
    pub(super) without_warping: Option<usize>,
    /// For each motion a lower bound of D.
    bending: [f64; K],
    /// For each motion a lower bound of C.
    least_tension: [f64; K],
    /// The motions.
    motions: [usize; K],
}

/// q' = A q + B p and p' = C q + D p over a span, with p the internal forces conjugate to q.
#[derive(Debug, Clone)]
pub(super) struct Transfer<const N: usize> {
    pub(super) a: SMatrix<f64, N, N>,
    pub(super) b: SMatrix<f64, N, N>,
    pub(super) c: SMatrix<f64, N, N>,
    pub(super) d: SMatrix<f64, N, N>,
}

/// A span in terms of its two ends.
#[derive(Debug, Clone)]
pub(super) struct Span {
    /// Dynamic stiffness: left end on itself, left on right, right on itself.
    pub(super) ends: Ends<6>,
    /// If the span is short compared with every wave: its dynamic stiffness would lose digits where it is rigid.
    pub(super) transfer: Option<Transfer<6>>,
}

/// The dynamic stiffness over both ends, and the number of modes below the frequency with both clamped.
#[derive(Debug, Clone)]
pub(super) struct Ends<const N: usize> {
    pub(super) left: SMatrix<f64, N, N>,
    pub(super) across: SMatrix<f64, N, N>,
    pub(super) right: SMatrix<f64, N, N>,
    pub(super) clamped: usize,
}

/// k l of the first mode of a clamped beam.
const FIRST_CLAMPED: f64 = 4.730;

/// The longest k l for which the power series converge fast.
const CONVERGENT: f64 = 1.5;

/// Evaluates an expression for each block of coupled motions; `$n` is twice their number.
macro_rules! for_each_block {
    ($field:expr, |$block:ident, $n:ident| $do:expr) => {
        match $field.couplings() {
            [false, false, false] => {
                for_each_block!(@ $field, |$block, $n| $do, [0] 2, [PSI] 2, [2] 2);
            }
            [true, false, false] => {
                for_each_block!(@ $field, |$block, $n| $do, [0, PSI] 4, [2] 2);
            }
            [false, true, false] => {
                for_each_block!(@ $field, |$block, $n| $do, [PSI, 2] 4, [0] 2);
            }
            [false, false, true] => {
                for_each_block!(@ $field, |$block, $n| $do, [0, 2] 4, [PSI] 2);
            }
            _ => for_each_block!(@ $field, |$block, $n| $do, [0, PSI, 2] 6),
        }
    };
    (@ $field:expr, |$block:ident, $n:ident| $do:expr, $($motions:tt $twice:literal),*) => {
        $({
            const $n: usize = $twice;
            let $block = $field.block($motions);
            $do;
        })*
    };
}

impl Field {
    /// A span of a length.
    pub(super) fn span(&self, length: f64) -> Span {
        let mut span = Span {
            ends: Ends {
                left: Matrix6::zeros(),
                across: Matrix6::zeros(),
                right: Matrix6::zeros(),
                clamped: 0,
            },
            transfer: Some(Transfer::zeros()),
        };
        for_each_block!(self, |block, N| span.put::<_, N>(&block, length));
        span
    }

    /// The number of pieces of a span. If warping decays over much less than a bending wavelength, halves short enough
    /// for it would be so stiff in bending that rounding hides the inertia: then each piece is a transfer matrix.
    pub(super) fn pieces(&self, length: f64) -> usize {
        let mut pieces = 1;
        for_each_block!(self, |block, _N| pieces = pieces.max(block.pieces(length)));
        pieces
    }

    /// Whether w and psi, psi and v, and w and v are coupled.
    fn couplings(&self) -> [bool; 3] {
        let matrices = [
            &self.bending,
            &self.tension,
            &self.rotary,
            &self.inertia,
            &self.foundation,
        ];
        [(0, PSI), (PSI, 2), (0, 2)].map(|at| matrices.iter().any(|matrix| matrix[at] != 0.0))
    }

    fn block<const K: usize>(&self, motions: [usize; K]) -> Block<K> {
        let of = |matrix: &Matrix3<f64>| {
            SMatrix::<f64, K, K>::from_fn(|i, j| matrix[(motions[i], motions[j])])
        };
        let (bending, tension) = (of(&self.bending), of(&self.tension));
        let without_warping =
            (0..K).find(|&index| motions[index] == PSI && bending[(index, index)] == 0.0);
        let mut regular = bending;
        if let Some(twist) = without_warping {
            regular[(twist, twist)] = 1.0;
        }
        let mut flexibility = regular.try_inverse().unwrap_or_else(SMatrix::zeros);
        if let Some(twist) = without_warping {
            flexibility[(twist, twist)] = 0.0;
        }
        let psi = (0..K).find(|&index| motions[index] == PSI);
        Block {
            flexibility,
            mass: of(&(self.inertia - self.foundation)),
            inertia: of(&self.inertia),
            rotary: of(&self.rotary),
            shear: of(&self.shear),
            without_warping,
            bending: std::array::from_fn(|index| {
                let others = (0..K).filter(|&other| bending[(index, other)] != 0.0);
                least_eigenvalue(&bending, &others.collect::<Vec<_>>())
            }),
            least_tension: std::array::from_fn(|index| least_tension(&tension, index, psi)),
            tension,
            motions,
        }
    }
}

/// The least eigenvalue of a symmetric matrix over one or two of its rows; 0 for none.
fn least_eigenvalue<const K: usize>(matrix: &SMatrix<f64, K, K>, rows: &[usize]) -> f64 {
    match *rows {
        [] => 0.0,
        [row] => matrix[(row, row)],
        [one, other, ..] => {
            let (a, b, c) = (
                matrix[(one, one)],
                matrix[(other, other)],
                matrix[(one, other)],
            );
            // a b - c^2 over the larger one, without cancellation.
            let larger = 0.5 * (a + b) + (0.5 * (a - b)).hypot(c);
            (a * b - c * c) / larger
        }
    }
}

/// A coefficient c for each motion so that `q'^T T q' >= sum c q'^2` for the matrix T of C.
///
/// A product of twist and a slope is at least minus a quarter of the own term of twist and the rest of the slope's
/// (Young's inequality), or minus half of both their squares.
fn least_tension<const K: usize>(
    tension: &SMatrix<f64, K, K>,
    index: usize,
    twist: Option<usize>,
) -> f64 {
    let own = tension[(index, index)];
    let across = |other: usize| tension[(index, other)].abs();
    let others = (0..K).filter(|&other| other != index && across(other) != 0.0);
    match twist.filter(|&twist| tension[(twist, twist)] > 0.0) {
        Some(twist) if twist == index => own * (1.0 - 0.25 * others.count() as f64),
        Some(twist) => others.fold(own, |sum, other| {
            let less = if other == twist {
                4.0 * across(other).powi(2) / tension[(twist, twist)]
            } else {
                across(other)
            };
            sum - less
        }),
        None => others.fold(own, |sum, other| sum - across(other)),
    }
}

impl<const K: usize> Block<K> {
    /// The pieces of a span: more than one only if twist is coupled to displacements.
    fn pieces(&self, length: f64) -> usize {
        const MOST_HALVINGS: u32 = 12;
        const HARMLESS: u32 = 1;
        if K == 1 || !self.motions.contains(&PSI) {
            return 1;
        }
        let bends = (0..K).filter(|&index| self.motions[index] != PSI);
        let bending = halvings(length, |h| {
            bends.clone().all(|index| self.converges_in(index, h))
        });
        let all = halvings(length, |h| self.is_short(h));
        if all > bending + HARMLESS && all <= MOST_HALVINGS {
            1 << all
        } else {
            1
        }
    }

    /// Whether the motions, clamped, have no mode below the frequency over a length, and their series converge fast.
    ///
    /// The mass matrix is at most `K` times its diagonal, so each uncoupled clamped mode with `K` times its mass is a
    /// lower bound; a foundation only raises it. Compression (negative tension) and rotary inertia c take the fraction
    /// `c l^2 / (4 pi^2 D)` of the bending stiffness, by Euler's load of a clamped column. With shear deformation the clamped frequency is at least
    /// that of the parts in series (Dunkerley), and the slope q' is the sum of a rotation and a shear angle, so that
    /// `q'^2` is at most twice the sum of their squares.
    fn is_short(&self, length: f64) -> bool {
        let bends = (FIRST_CLAMPED / length).powi(4);
        let turns = (std::f64::consts::PI / length).powi(2);
        (0..K).all(|index| {
            let (bending, tension) = (self.bending[index], self.least_tension[index]);
            let compression = (-tension).max(0.0);
            let rotary: f64 = self.rotary.row(index).iter().map(|entry| entry.abs()).sum();
            let shear = self.shear[(index, index)];
            let (left, sheared) = if shear > 0.0 {
                let left = bending - (2.0 * compression + rotary) / turns;
                (left, shear / (turns * (1.0 - 2.0 * compression * shear)))
            } else {
                (bending - (compression + rotary) / (4.0 * turns), 0.0)
            };
            let bent = left * bends;
            let stiffness = bent / (1.0 + bent * sheared) + tension.max(0.0) * turns;
            let is_stable = left >= 0.0 && sheared >= 0.0;
            let no_mode = is_stable && K as f64 * self.inertia[(index, index)] < stiffness;
            no_mode && self.converges_in(index, length)
        })
    }

    /// Whether the series of a motion converge fast over a length: `k l` is small for the largest wave number k, by an
    /// upper bound: coupling changes a squared one by less than the larger.
    fn converges_in(&self, index: usize, length: f64) -> bool {
        let inertia = self.inertia[(index, index)];
        // A foundation makes waves as short as an inertia of its size.
        let mass = inertia.max(inertia - self.mass[(index, index)]);
        let bending = self.bending[index];
        let tension = self.tension[(index, index)].abs()
            + self.rotary[(index, index)]
            + bending * self.shear[(index, index)] * mass;
        let square = if bending == 0.0 {
            mass / tension
        } else {
            (tension + (tension * tension + 4.0 * mass * bending).sqrt()) / (2.0 * bending)
        };
        length * (square * (K as f64).sqrt()).sqrt() < CONVERGENT
    }
}

/// The number of halvings until a length is short.
fn halvings(length: f64, is_short: impl Fn(f64) -> bool) -> u32 {
    /// Beyond, no length is short: the beam is unstable however short it is.
    const MOST: u32 = 60;
    let mut halvings = 0;
    while halvings < MOST && !is_short(length / 2.0_f64.powi(halvings as i32)) {
        halvings += 1;
    }
    halvings
}

/// A span joined from two halves until these are short; the transfer matrix of a span that is short itself.
///
/// The count of the joints: Wittrick & Williams, Q. J. Mech. Appl. Math. 24 (1971) 263-284.
fn joined<const N: usize>(
    length: f64,
    transfer: impl Fn(f64) -> Transfer<N>,
    is_short: impl Fn(f64) -> bool,
) -> (Ends<N>, Option<Transfer<N>>) {
    let halvings = halvings(length, is_short);
    let transfer = transfer(length / 2.0_f64.powi(halvings as i32));
    let mut ends = transfer.stiffness();
    for _ in 0..halvings {
        ends = ends.doubled();
    }
    (ends, (halvings == 0).then_some(transfer))
}

impl Span {
    /// Solves a block and copies it into its rows; `N` is twice `K`.
    fn put<const K: usize, const N: usize>(&mut self, block: &Block<K>, length: f64) {
        let (ends, transfer) = joined(
            length,
            |h| transfer::<K, N>(block, h),
            |h| block.is_short(h),
        );
        let rows: [usize; N] =
            std::array::from_fn(|index| block.motions[index % K] + 3 * (index / K));
        self.ends.clamped = self.ends.clamped.saturating_add(ends.clamped);
        self.transfer = self.transfer.take().filter(|_| transfer.is_some());
        for (i, &row) in rows.iter().enumerate() {
            for (j, &column) in rows.iter().enumerate() {
                let at = (row, column);
                self.ends.left[at] = ends.left[(i, j)];
                self.ends.across[at] = ends.across[(i, j)];
                self.ends.right[at] = ends.right[(i, j)];
                if let (Some(whole), Some(part)) = (&mut self.transfer, &transfer) {
                    whole.a[at] = part.a[(i, j)];
                    whole.b[at] = part.b[(i, j)];
                    whole.c[at] = part.c[(i, j)];
                    whole.d[at] = part.d[(i, j)];
                }
            }
        }
    }

    /// The same over other motions of its left end, from which `own` gives its own. The forces there do the same work.
    pub(super) fn starting_with(&self, own: &Matrix6<f64>) -> Self {
        let ends = &self.ends;
        // It is the identity and a shear, whose square is 0.
        let of_forces = (Matrix6::identity() * 2.0 - own).transpose();
        Self {
            ends: Ends {
                left: own.transpose() * ends.left * own,
                across: own.transpose() * ends.across,
                ..*ends
            },
            transfer: self.transfer.as_ref().map(|transfer| Transfer {
                a: transfer.a * own,
                b: transfer.b * of_forces,
                c: transfer.c * own,
                d: transfer.d * of_forces,
            }),
        }
    }
}

impl<const N: usize> Transfer<N> {
    /// Nothing yet.
    pub(super) fn zeros() -> Self {
        let zeros = SMatrix::zeros();
        Self {
            a: zeros,
            b: zeros,
            c: zeros,
            d: zeros,
        }
    }

    /// The dynamic stiffness: `B^-1 A`, `-B^-1`, `D B^-1`. B is regular if no clamped mode is near.
    fn stiffness(&self) -> Ends<N> {
        let inverse = self.b.try_inverse().unwrap_or_else(SMatrix::zeros);
        Ends {
            left: symmetric(inverse * self.a),
            across: -inverse,
            right: symmetric(self.d * inverse),
            clamped: 0,
        }
    }
}

impl<const N: usize> Ends<N> {
    /// Two pieces, one after the other.
    fn doubled(&self) -> Self {
        let joint = eliminate(&(self.right + self.left), &SMatrix::<f64, N, N>::identity());
        let from_right = joint.solution * self.across;
        Self {
            left: symmetric(self.left - self.across * joint.solution * self.across.transpose()),
            across: -self.across * from_right,
            right: symmetric(self.right - self.across.transpose() * from_right),
            // A beam of astronomical length has more than a count can hold.
            clamped: self
                .clamped
                .saturating_mul(2)
                .saturating_add(joint.negatives),
        }
    }
}

/// The symmetric part: the rest is rounding.
pub(super) fn symmetric<const N: usize>(a: SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    0.5 * (a + a.transpose())
}

//! A span of the undamped beam at one frequency, in real numbers: transfer matrix, dynamic stiffness, clamped count.
//!
//! All numbers are dimensionless: lengths in units of a reference length, twist times the radius of gyration,
//! stiffnesses over `E Iy / length^3`. Degrees of freedom are (w, psi, v, w', psi', v'), as in
//! [`BeamMotion`](crate::model::BeamMotion). The solutions are power series of the equations of motion (Chen & Liu,
//! Mathematics 2022, 10(16), 2849, Eqs. 11 to 13): they use no waves, so this count is independent of the frequency
//! responses. Uncoupled motions are separate, each with its own step.

use nalgebra::{Matrix6, SMatrix};

use super::matrix_inertia::eliminate;
use super::series::{bending, coupled, twist};

/// The dimensionless coefficients of the equations of motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Field {
    /// `E Iz / E Iy`.
    pub(super) bending_v: f64,
    /// `E Gamma_0 / (E Iy r^2)`; 0 without warping stiffness.
    pub(super) warping: f64,
    /// `G J length^2 / (E Iy r^2)`.
    pub(super) torsion: f64,
    /// `omega^2 rho A length^4 / E Iy`.
    pub(super) mass: f64,
    /// `omega^2 rho I_0 length^4 / (E Iy r^2)`.
    pub(super) polar: f64,
    /// `omega^2 rho A z_c length^4 / (E Iy r)`.
    pub(super) coupling: f64,
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
        let v = |h: f64| bending(self.bending_v, self.mass, h);
        span.put(
            [2, 5],
            joined(length, v, |h| {
                is_short_in_bending(self.mass / self.bending_v, h)
            }),
        );
        if self.coupling == 0.0 {
            let w = |h: f64| bending(1.0, self.mass, h);
            span.put(
                [0, 3],
                joined(length, w, |h| is_short_in_bending(self.mass, h)),
            );
            span.put(
                [1, 4],
                joined(length, |h| twist(self, h), |h| self.is_short(h)),
            );
        } else {
            span.put(
                [0, 1, 3, 4],
                joined(length, |h| coupled(self, h), |h| self.is_short(h)),
            );
        }
        span
    }

    /// The number of pieces of a span. If warping decays over much less than a bending wavelength, halves short enough
    /// for it would be so stiff in bending that rounding hides the inertia: then each piece is a transfer matrix.
    pub(super) fn pieces(&self, length: f64) -> usize {
        const MOST_HALVINGS: u32 = 12;
        const HARMLESS: u32 = 1;
        if self.coupling == 0.0 {
            return 1;
        }
        let bending = halvings(length, |h| is_short_in_bending(self.mass, h));
        let both = halvings(length, |h| self.is_short(h));
        if both > bending + HARMLESS && both <= MOST_HALVINGS {
            1 << both
        } else {
            1
        }
    }

    /// Whether w and psi, clamped, have no mode below the frequency over a length, and their series converge fast.
    ///
    /// The mass matrix of the two is at most twice its diagonal, so each uncoupled clamped mode with twice its mass is
    /// a lower bound.
    fn is_short(&self, length: f64) -> bool {
        let k = (FIRST_CLAMPED / length).powi(4);
        let twisting = self.warping * k + self.torsion * (std::f64::consts::PI / length).powi(2);
        let no_mode = 2.0 * self.mass < k && 2.0 * self.polar < twisting;
        no_mode && length * self.largest_wave_number() < CONVERGENT
    }

    /// An upper bound of the wave numbers of w and psi: the coupling changes a squared one by less than the larger.
    fn largest_wave_number(&self) -> f64 {
        let root = (self.torsion * self.torsion + 4.0 * self.polar * self.warping).sqrt();
        let twisting = if self.warping == 0.0 {
            self.polar / self.torsion
        } else {
            (self.torsion + root) / (2.0 * self.warping)
        };
        (self.mass.sqrt().max(twisting) * 2.0_f64.sqrt()).sqrt()
    }
}

/// Bending with `k^4` = mass over stiffness: its first clamped mode is far above the range of fast convergence.
fn is_short_in_bending(k4: f64, length: f64) -> bool {
    length * k4.sqrt().sqrt() < CONVERGENT
}

/// The number of halvings until a length is short.
fn halvings(length: f64, is_short: impl Fn(f64) -> bool) -> u32 {
    let mut halvings = 0;
    while !is_short(length / 2.0_f64.powi(halvings as i32)) {
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
    /// Copies motions without coupling to the others into their rows.
    fn put<const N: usize>(
        &mut self,
        rows: [usize; N],
        (ends, transfer): (Ends<N>, Option<Transfer<N>>),
    ) {
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

//! The reflection at several frequencies at once, in its symmetric form.
//!
//! Looking from a point to one side, the waves from that side are `a = R b + s`. With `b' = N^-1 b` instead of b, where
//! N is the radiation of a jump ([`super::waves`]), the reflection `R N` is a symmetric matrix, by reciprocity: 21 of
//! its 36 entries are stored. A jump f of the internal forces adds `Q^T f` to b', with the transpose of the
//! displacement matrix. The same code looks left and right: only the jumps of moments change their sign.

use super::complex::Complex;
use super::number::{Arithmetic, part};
use super::waves::Waves;

/// Six wave amplitudes at each frequency.
pub(super) type Amplitudes<A> = [Complex<A>; 6];

/// Entries of a symmetric 6x6 matrix.
pub(super) const ENTRIES: usize = 21;

/// a = R N b' + s.
#[derive(Debug, Clone)]
pub(super) struct Reflection<A> {
    /// R N: the rows of its upper triangle.
    pub(super) r: [Complex<A>; ENTRIES],
    /// The forced part.
    pub(super) s: Amplitudes<A>,
}

/// Index of an entry of a symmetric matrix.
#[inline(always)]
pub(super) const fn entry(row: usize, column: usize) -> usize {
    let (low, high) = if row < column {
        (row, column)
    } else {
        (column, row)
    };
    low * (11 - low) / 2 + high
}

/// The direction in which a reflection looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

/// Columns of the waves that contribute to a row (w, psi, v) of Q, S, P or M; `ALL` if [all waves are
/// coupled](Waves::all_coupled).
#[inline(always)]
pub(super) const fn reach<const ALL: bool>(row: usize) -> (usize, usize) {
    if ALL {
        (0, 6)
    } else if row < 2 {
        (0, 4)
    } else {
        (4, 6)
    }
}

impl<A: Arithmetic> Reflection<A> {
    pub(super) const NONE: Self = Self {
        r: [Complex::ZERO; ENTRIES],
        s: [Complex::ZERO; 6],
    };

    /// The outgoing waves for given b'.
    #[inline(always)]
    pub(super) fn at(&self, b: &Amplitudes<A>) -> Amplitudes<A> {
        self.part(b, true)
    }

    /// The same with or without the forced part.
    pub(super) fn part(&self, b: &Amplitudes<A>, is_forced: bool) -> Amplitudes<A> {
        A::outlined(At((self, b, is_forced)))
    }

    #[inline(always)]
    fn part_inlined((this, b, is_forced): (&Self, &Amplitudes<A>, bool)) -> Amplitudes<A> {
        let mut a = if is_forced {
            this.s
        } else {
            [Complex::ZERO; 6]
        };
        for row in 0..6 {
            for column in 0..6 {
                a[row] = a[row].plus_product(this.r[entry(row, column)], b[column]);
            }
        }
        a
    }

    /// Over a span: R <- e R e, s <- e s.
    pub(super) fn propagate(&mut self, decay: &Amplitudes<A>) {
        A::outlined(Propagate((self, decay)));
    }

    #[inline(always)]
    fn propagate_inlined((this, decay): (&mut Self, &Amplitudes<A>)) {
        for row in 0..6 {
            for column in row..6 {
                let at = entry(row, column);
                this.r[at] = this.r[at] * (decay[row] * decay[column]);
            }
            this.s[row] = this.s[row] * decay[row];
        }
    }

    /// Over loads along the six motions, which make the internal forces jump by f and the moments by m: `s <- s + (1 +
    /// R) X f + (1 - R) Y m`, m with the other sign to the right.
    pub(super) fn load(&mut self, waves: &Waves<A>, jumps: &Jumps<A>, side: Side) {
        A::outlined(Load((self, waves, jumps, side)));
    }

    #[inline(always)]
    fn load_inlined((this, waves, jumps, side): (&mut Self, &Waves<A>, &Jumps<A>, Side)) {
        let there = jumps.sent(side);
        let back = jumps.sent(side.other());
        for row in 0..6 {
            let mut sum = this.s[row].plus_product(waves.radiation[row], there[row]);
            for column in 0..6 {
                sum = sum.plus_product(this.r[entry(row, column)], back[column]);
            }
            this.s[row] = sum;
        }
    }
}

impl Side {
    #[inline(always)]
    pub(super) const fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// The effect of jumps of the internal forces and moments, or of the motions, on the waves, before N.
#[derive(Debug, Clone)]
pub(super) struct Jumps<A> {
    /// Q^T f, or -M^T t.
    even: Amplitudes<A>,
    /// S^T m, or P^T u.
    odd: Amplitudes<A>,
}

impl<A: Arithmetic> Jumps<A> {
    /// The jumps of loads along the six motions: p(x+) = p(x-) - F.
    #[inline(always)]
    pub(super) fn of_load(waves: &Waves<A>, load: &[num_complex::Complex64; 6]) -> Self {
        Self::of_forces(waves, &load.map(Complex::splat))
    }

    /// The jumps of a gap.
    #[inline(always)]
    pub(super) fn of_gap(waves: &Waves<A>, gap: &[num_complex::Complex64; 6]) -> Self {
        Self::of_motions(waves, &gap.map(Complex::splat))
    }

    /// The jumps of forces that differ between the frequencies.
    pub(super) fn of_forces(waves: &Waves<A>, forces: &Amplitudes<A>) -> Self {
        if waves.all_coupled {
            A::outlined(OfForces::<A, true>((waves, forces)))
        } else {
            A::outlined(OfForces::<A, false>((waves, forces)))
        }
    }

    #[inline(always)]
    fn of_forces_inlined<const ALL: bool>((waves, forces): (&Waves<A>, &Amplitudes<A>)) -> Self {
        let mut jumps = Self {
            even: [Complex::ZERO; 6],
            odd: [Complex::ZERO; 6],
        };
        for row in 0..3 {
            let force = -forces[row];
            let moment = -forces[row + 3];
            let (from, to) = reach::<ALL>(row);
            for wave in from..to {
                jumps.even[wave] =
                    jumps.even[wave].plus_product(waves.displacement[row][wave], force);
                // A bimoment on a section without warping stiffness excites only the warping wave.
                if row == 1 && waves.without_warping && wave > 0 {
                    continue;
                }
                jumps.odd[wave] = jumps.odd[wave].plus_product(waves.slope[row][wave], moment);
            }
        }
        jumps
    }

    /// The effect of jumps of the six motions over a joint, right minus left: `P^T u` of the displacements is odd and `-M^T t`
    /// of the slopes even, by reciprocity with the jumps of forces and moments.
    pub(super) fn of_motions(waves: &Waves<A>, jumps: &Amplitudes<A>) -> Self {
        A::outlined(OfMotions((waves, jumps)))
    }

    #[inline(always)]
    fn of_motions_inlined((waves, of): (&Waves<A>, &Amplitudes<A>)) -> Self {
        let mut jumps = Self {
            even: [Complex::ZERO; 6],
            odd: [Complex::ZERO; 6],
        };
        for row in 0..3 {
            for wave in 0..6 {
                jumps.odd[wave] = jumps.odd[wave].plus_product(waves.force[row][wave], of[row]);
                jumps.even[wave] =
                    jumps.even[wave].minus_product(waves.moment[row][wave], of[row + 3]);
            }
        }
        jumps
    }

    /// What goes away from a reflection that looks to a side.
    #[inline(always)]
    pub(super) fn sent(&self, looking: Side) -> Amplitudes<A> {
        let mut out = [Complex::ZERO; 6];
        for wave in 0..6 {
            out[wave] = match looking {
                Side::Left => self.even[wave] + self.odd[wave],
                Side::Right => self.even[wave] - self.odd[wave],
            };
        }
        out
    }
}

part!(
    At ['a, A: Arithmetic] ['a, A]
    (&'a Reflection<A>, &'a Amplitudes<A>, bool) -> Amplitudes<A>,
    Reflection::part_inlined
);

part!(
    Propagate ['a, A: Arithmetic] ['a, A]
    (&'a mut Reflection<A>, &'a Amplitudes<A>) -> (),
    Reflection::propagate_inlined
);

part!(
    Load ['a, A: Arithmetic] ['a, A]
    (&'a mut Reflection<A>, &'a Waves<A>, &'a Jumps<A>, Side) -> (),
    Reflection::load_inlined
);

part!(
    OfForces ['a, A: Arithmetic, const ALL: bool] ['a, A, ALL]
    (&'a Waves<A>, &'a Amplitudes<A>) -> Jumps<A>,
    Jumps::of_forces_inlined::<ALL>
);

part!(
    OfMotions ['a, A: Arithmetic] ['a, A]
    (&'a Waves<A>, &'a Amplitudes<A>) -> Jumps<A>,
    Jumps::of_motions_inlined
);

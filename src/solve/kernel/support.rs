//! A support between the ends at several frequencies at once: its effect on a reflection.
//!
//! Unknown are its forces F on the beam along the six motions of its point, where loads act, too. With the motions q0
//! without them and the receptance H of the beam there, a free motion has `F = load`, an elastic one `F + k H F = load - k
//! q0` and a fixed one `H F = -q0`: no stiffness is too large or too small. A motion is a row of the displacements, even
//! in both directions, or of the slopes, odd; the forces radiate by the transpose of these rows.

use super::complex::{Complex, Matrix};
use super::ends::restraint;
use super::linear::{solve, solve_with_determinant};
use super::number::{Arithmetic, Real, part};
use super::product::ScaledProduct;
use super::reflection::{Amplitudes, Jumps, Reflection, Side, entry};
use super::waves::Waves;
use crate::model::{BeamMotion, Point, Restraint};
use crate::solve::plan::Held;

/// The motions.
const MOTIONS: usize = 6;

/// The forces along the motions of the point: `from_waves b' + forced` for the waves b' that come from the far side.
#[derive(Debug, Clone)]
pub(super) struct Reactions<A> {
    from_waves: Matrix<A, MOTIONS, 6>,
    forced: [Complex<A>; MOTIONS],
}

impl<A: Arithmetic> Reactions<A> {
    pub(super) const NONE: Self = Self {
        from_waves: [[Complex::ZERO; 6]; MOTIONS],
        forced: [Complex::ZERO; MOTIONS],
    };

    /// What the forces for waves b' from the far side, with or without loads, send out.
    #[inline(always)]
    pub(super) fn sent(
        &self,
        waves: &Waves<A>,
        point: Point,
        b: &Amplitudes<A>,
        is_forced: bool,
    ) -> Jumps<A> {
        let mut forces = if is_forced {
            self.forced
        } else {
            [Complex::ZERO; MOTIONS]
        };
        for motion in 0..MOTIONS {
            for wave in 0..6 {
                forces[motion] =
                    forces[motion].plus_product(self.from_waves[motion][wave], b[wave]);
            }
        }
        let [w, psi, v] = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V].map(|of| of as usize);
        forces[psi] = forces[psi]
            .plus_scaled(Real::splat(point.z), forces[w])
            .plus_scaled(Real::splat(-point.y), forces[v]);
        Jumps::of_forces(waves, &forces)
    }
}

/// The motions of a point by each wave; slopes for an observer who looks to a side.
#[inline(always)]
fn rows<A: Arithmetic>(waves: &Waves<A>, point: Point, side: Side) -> Matrix<A, MOTIONS, 6> {
    let mut rows = [[Complex::ZERO; 6]; MOTIONS];
    for row in 0..3 {
        for wave in 0..6 {
            rows[row][wave] = waves.at_point(point, row, wave).0;
            let slope = waves.slope[row][wave];
            rows[row + 3][wave] = match side {
                Side::Left => slope,
                Side::Right => -slope,
            };
        }
    }
    rows
}

/// The restraint of a motion: without warping stiffness none acts on the rate of twist.
#[inline(always)]
fn kind<A: Arithmetic>(waves: &Waves<A>, held: &Held, motion: BeamMotion) -> Restraint {
    if waves.without_warping && motion == BeamMotion::PsiSlope {
        Restraint::Free
    } else {
        held.support[motion]
    }
}

/// A support that a reflection passes, looking to a side.
#[derive(Debug)]
pub(super) struct Passed<'a, A> {
    pub(super) held: &'a Held,
    pub(super) side: Side,
    pub(super) reactions: &'a mut Reactions<A>,
    /// The product to be multiplied by the determinant of its equations.
    pub(super) determinant: Option<&'a mut ScaledProduct<A>>,
}

impl<A: Arithmetic> Reflection<A> {
    /// Over a support.
    pub(super) fn hold(&mut self, waves: &Waves<A>, passed: Passed<'_, A>) {
        A::outlined(Hold((self, waves, passed)));
    }

    #[inline(always)]
    fn hold_inlined((this, waves, passed): (&mut Self, &Waves<A>, Passed<'_, A>)) {
        let Passed {
            held,
            side,
            reactions,
            determinant,
        } = passed;
        let rows = rows(waves, held.support.point, side);
        // The motions per b', and without incoming waves.
        let mut moved = [[Complex::ZERO; 6]; MOTIONS];
        let mut still = [Complex::ZERO; MOTIONS];
        for motion in 0..MOTIONS {
            let is_slope = motion >= 3;
            let row = &rows[motion];
            for column in 0..6 {
                let mut back = Complex::ZERO;
                for wave in 0..6 {
                    back = back.plus_product(row[wave], this.r[entry(wave, column)]);
                }
                let arriving = row[column] * waves.radiation[column];
                moved[motion][column] = if is_slope {
                    arriving - back
                } else {
                    arriving + back
                };
            }
            for wave in 0..6 {
                still[motion] = if is_slope {
                    still[motion].minus_product(row[wave], this.s[wave])
                } else {
                    still[motion].plus_product(row[wave], this.s[wave])
                };
            }
        }
        let mut receptance = [[Complex::ZERO; MOTIONS]; MOTIONS];
        for motion in 0..MOTIONS {
            for force in 0..MOTIONS {
                let mut sum = Complex::ZERO;
                for wave in 0..6 {
                    sum = sum.plus_product(moved[motion][wave], rows[force][wave]);
                }
                receptance[motion][force] = if force >= 3 { sum } else { -sum };
            }
        }
        let mut of_forces = [[Complex::ZERO; MOTIONS]; MOTIONS];
        let mut right = [[Complex::ZERO; 7]; MOTIONS];
        let mut unscaled = Real::ONE;
        for motion in BeamMotion::ALL {
            let row = motion as usize;
            let (stiffness, _, load) = restraint(waves.omega, held, motion);
            let own = stiffness * receptance[row][row];
            let scale = match kind(waves, held, motion) {
                Restraint::Free => {
                    of_forces[row][row] = Complex::ONE;
                    right[row][6] = Complex::splat(load);
                    continue;
                }
                Restraint::Fixed => own.size().inverse_power_of_two(),
                Restraint::Elastic(_) => (Real::ONE + own.size()).inverse_power_of_two(),
            };
            let scaled = stiffness.scaled(scale);
            for force in 0..MOTIONS {
                of_forces[row][force] = scaled * receptance[row][force];
            }
            for column in 0..6 {
                right[row][column] = -(scaled * moved[row][column]);
            }
            right[row][6] = -(scaled * still[row]);
            if matches!(held.support[motion], Restraint::Elastic(_)) {
                of_forces[row][row].re = of_forces[row][row].re + scale;
                right[row][6] += Complex::splat(load).scaled(scale);
            }
            unscaled = unscaled / scale;
        }
        match determinant {
            Some(product) => {
                product.times(solve_with_determinant(&mut of_forces, &mut right));
                product.times(Complex::from_real(unscaled));
            }
            None => solve(&mut of_forces, &mut right),
        }
        for motion in 0..MOTIONS {
            reactions.from_waves[motion].copy_from_slice(&right[motion][..6]);
            reactions.forced[motion] = right[motion][6];
        }
        for row in 0..6 {
            for motion in 0..MOTIONS {
                let share = moved[motion][row];
                for column in row..6 {
                    let at = entry(row, column);
                    this.r[at] = this.r[at].minus_product(share, right[motion][column]);
                }
                this.s[row] = this.s[row].minus_product(share, right[motion][6]);
            }
        }
    }
}

part!(
    Hold ['a, A: Arithmetic] ['a, A]
    (&'a mut Reflection<A>, &'a Waves<A>, Passed<'a, A>) -> (),
    Reflection::hold_inlined
);

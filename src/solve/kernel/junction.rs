//! Where two parts of the beam with different waves meet, at several frequencies at once: its effect on a reflection.
//!
//! Motions and internal forces are continuous. With the sums `a + b` and differences `a - b` of the amplitudes on one side
//! the waves on the other one, marked here by ~, follow from the orthogonality of the waves ([`super::action`]):
//!
//! ```text
//! a~ + b~ = 2 N~ G (a + b)    G = P~^T Q + S~^T M
//! a~ - b~ = 2 N~ H (a - b)    H = Q~^T P + M~^T S
//! ```
//!
//! which holds in both directions, because a mirror changes only the sign of the differences. With `a = R N b' + s` of one
//! side, `b = N b'`, this is `b~' = Z b' + (G - H) s` with `Z = (G - H) R N + (G + H) N`, and so on for a~: one system of
//! six equations for b', without the inverse of any matrix of shapes.
//!
//! The wave that decays at once, of a part without warping stiffness, carries no bimoment and lets the rate of twist change
//! freely. So a part with warping stiffness ends free of bimoment there, and two parts without it only hand the wave on.

use super::action::Actions;
use super::complex::{Complex, Matrix};
use super::linear::{solve, solve_with_determinant};
use super::number::{Arithmetic, Real, part};
use super::product::ScaledProduct;
use super::reflection::{Reflection, entry, reach};
use super::waves::Waves;
use crate::solve::waves::WARPING_WAVE;

/// The waves on the side of the reflection, and beyond.
type Between<'a, A> = [&'a Waves<A>; 2];

/// Index of psi among the motions (w, psi, v).
const PSI: usize = 1;

impl<A: Arithmetic> Reflection<A> {
    /// Over a junction, from the waves of one side to those of the other one. Stores b' for the waves b~' that come from
    /// beyond; also multiplies a product by the determinant of Z.
    pub(super) fn cross(
        &mut self,
        between: Between<'_, A>,
        through: &mut Actions<A>,
        determinant: Option<&mut ScaledProduct<A>>,
    ) {
        if between[0].all_coupled {
            A::outlined(Cross::<A, true>((self, between, through, determinant)));
        } else {
            A::outlined(Cross::<A, false>((self, between, through, determinant)));
        }
    }

    #[inline(always)]
    fn cross_inlined<const ALL: bool>(
        (this, [here, beyond], through, determinant): (
            &mut Self,
            Between<'_, A>,
            &mut Actions<A>,
            Option<&mut ScaledProduct<A>>,
        ),
    ) {
        let even = mutual_work::<A, ALL>(beyond, here);
        let odd = mutual_work::<A, ALL>(here, beyond);
        // Over b': N~ b~' and a~. Their forced parts, the first with the other sign.
        let mut of_arriving = [[Complex::ZERO; 6]; 6];
        let mut of_leaving = [[Complex::ZERO; 6]; 6];
        let mut right = [[Complex::ZERO; 7]; 6];
        let mut forced = [Complex::ZERO; 6];
        for row in 0..6 {
            let radiation = beyond.radiation[row];
            // A subsystem may couple all waves in R, a junction only those that move the same.
            let (from, to) = reach::<ALL>(if row < 4 { 0 } else { 2 });
            for wave in from..to {
                let (g, h) = (even[row][wave], odd[wave][row]);
                let (less, more) = (radiation * (g - h), radiation * (g + h));
                right[row][6] = right[row][6].minus_product(less, this.s[wave]);
                forced[row] = forced[row].plus_product(more, this.s[wave]);
                for column in 0..6 {
                    let reflected = this.r[entry(wave, column)];
                    of_arriving[row][column] =
                        of_arriving[row][column].plus_product(less, reflected);
                    of_leaving[row][column] = of_leaving[row][column].plus_product(more, reflected);
                }
                let own = here.radiation[wave];
                of_arriving[row][wave] = of_arriving[row][wave].plus_product(more, own);
                of_leaving[row][wave] = of_leaving[row][wave].plus_product(less, own);
            }
            right[row][row] = radiation;
        }
        match determinant {
            Some(product) => {
                product.times(solve_with_determinant(&mut of_arriving, &mut right));
                for weight in beyond.weight {
                    product.times(weight);
                }
            }
            None => solve(&mut of_arriving, &mut right),
        }
        for row in 0..6 {
            this.s[row] = forced[row];
            for wave in 0..6 {
                this.s[row] = this.s[row].plus_product(of_leaving[row][wave], right[wave][6]);
            }
            for column in row..6 {
                let mut sum = Complex::ZERO;
                for wave in 0..6 {
                    sum = sum.plus_product(of_leaving[row][wave], right[wave][column]);
                }
                this.r[entry(row, column)] = sum;
            }
        }
        if here.without_warping {
            // It was the rate of twist beyond, and is not read.
            right[WARPING_WAVE] = [Complex::ZERO; 7];
        }
        *through = Actions::of_rows(&right);
    }
}

/// `P^T Q + S^T M` with P and S of each wave of one part, and Q and M of each wave of the other one.
#[inline(always)]
fn mutual_work<A: Arithmetic, const ALL: bool>(
    one: &Waves<A>,
    other: &Waves<A>,
) -> Matrix<A, 6, 6> {
    let mut sums = [[Complex::ZERO; 6]; 6];
    for row in 0..3 {
        let (from, to) = reach::<ALL>(row);
        for i in from..to {
            for j in from..to {
                let mut sum = sums[i][j];
                sum = sum.plus_product(one.force[row][i], other.displacement[row][j]);
                if row != PSI || !(one.without_warping || other.without_warping) {
                    sum = sum.plus_product(one.slope[row][i], other.moment[row][j]);
                }
                sums[i][j] = sum;
            }
        }
    }
    match (one.without_warping, other.without_warping) {
        (true, true) => {
            let half = Real::splat(0.5);
            sums[WARPING_WAVE][WARPING_WAVE] = one.weight[WARPING_WAVE].scaled(half);
        }
        (true, false) => sums[WARPING_WAVE] = other.moment[PSI],
        (false, true | false) => {}
    }
    sums
}

part!(
    Cross ['a, A: Arithmetic, const ALL: bool] ['a, A, ALL]
    (&'a mut Reflection<A>, Between<'a, A>, &'a mut Actions<A>, Option<&'a mut ScaledProduct<A>>) -> (),
    Reflection::cross_inlined::<ALL>
);

//! What acts on the beam between its ends, a support or a joint, at several frequencies at once: its effect on a
//! reflection.
//!
//! A support exerts six forces F along the motions of its point, where loads act, too; it observes these motions. A joint
//! makes the six motions jump by u, right minus left; it observes the internal forces p, which are continuous. The two are
//! dual: each has six actions x and observes six quantities `y = y0 + H x` with the receptance H of the beam there, and
//! each row is an equation of its own x and y. A support's motion is free with `F = load`, on a spring with `F + k y =
//! load` and fixed with `y = 0`; a joint's is rigid with `u = 0`, on a spring with `y - k u = 0` (the left part pulls the
//! right one back with p) and free with `y = 0`: no stiffness is too large or too small.
//!
//! Looking to a side with waves a from there and b towards there, an even row r observes `r (b + a)` and its action sends
//! `-r^T x` with b and a alike; an odd row observes `r (b - a)` and sends `+r^T x` with b and `-r^T x` with a, before N,
//! by reciprocity. A support has the displacements Q as even rows and the slopes S, in the sense of the observer, as odd
//! ones. A joint has the moments M as even rows and the forces as odd ones: `p = P (a - b)` looking left is the row -P, and
//! looking right, where a and b change places, +P. Its jumps u of displacements and t of slopes send `P^T u`, the same
//! amplitude in the sense of x, and `-M^T t`: both come from `Q N P^T = S N M^T = 1/2` and `Q N S^T = M N P^T = 0`, which
//! are the orthogonality of the waves ([`super::waves`]).

use super::complex::{Complex, Matrix};
use super::ends::restraint;
use super::linear::{solve, solve_with_determinant};
use super::number::{Arithmetic, Real, part};
use super::product::ScaledProduct;
use super::reflection::{Amplitudes, Jumps, Reflection, Side, entry};
use super::waves::Waves;
use crate::model::{BeamMotion, Restraint};
use crate::solve::plan::{Held, Joined};

/// The motions.
const MOTIONS: usize = 6;

/// What acts on the beam between its ends.
#[derive(Debug, Clone, Copy)]
pub(super) enum Acting<'a> {
    Support(&'a Held),
    Joint(&'a Joined),
}

/// The actions, forces along the motions of a point or jumps of the motions: `from_waves b' + forced` for the waves b' that
/// come from the far side. Of a junction b' on its other side.
#[derive(Debug, Clone)]
pub(super) struct Actions<A> {
    from_waves: Matrix<A, MOTIONS, 6>,
    forced: [Complex<A>; MOTIONS],
}

/// The waves at what acts, for an observer who looks to a side.
type Looking<'a, A> = (&'a Waves<A>, Acting<'a>, Side);

/// The actions to store, and a product to be multiplied by the determinant of their equations.
type Answer<'a, A> = (&'a mut Actions<A>, Option<&'a mut ScaledProduct<A>>);

/// The equation of an action x and what is observed, y, along a motion.
#[derive(Debug, Clone, Copy)]
enum Condition<A> {
    /// x is known.
    Known(Complex<A>),
    /// `action x + observed y = load`.
    Tied {
        action: Complex<A>,
        observed: Complex<A>,
        load: Complex<A>,
    },
}

impl<A: Arithmetic> Actions<A> {
    pub(super) const NONE: Self = Self {
        from_waves: [[Complex::ZERO; 6]; MOTIONS],
        forced: [Complex::ZERO; MOTIONS],
    };

    /// From the solved equations, with the forced part in the last column.
    #[inline(always)]
    pub(super) fn of_rows(rows: &Matrix<A, MOTIONS, 7>) -> Self {
        let mut out = Self::NONE;
        for motion in 0..MOTIONS {
            out.from_waves[motion].copy_from_slice(&rows[motion][..6]);
            out.forced[motion] = rows[motion][6];
        }
        out
    }

    /// The actions for waves b' from the far side, with or without loads.
    #[inline(always)]
    pub(super) fn part(&self, b: &Amplitudes<A>, is_forced: bool) -> [Complex<A>; MOTIONS] {
        let mut actions = if is_forced {
            self.forced
        } else {
            [Complex::ZERO; MOTIONS]
        };
        for motion in 0..MOTIONS {
            for wave in 0..6 {
                actions[motion] =
                    actions[motion].plus_product(self.from_waves[motion][wave], b[wave]);
            }
        }
        actions
    }
}

impl Acting<'_> {
    /// What actions send out.
    #[inline(always)]
    pub(super) fn sent<A: Arithmetic>(
        self,
        waves: &Waves<A>,
        mut actions: [Complex<A>; MOTIONS],
    ) -> Jumps<A> {
        match self {
            Self::Support(held) => {
                let point = held.support.point;
                let [w, psi, v] =
                    [BeamMotion::W, BeamMotion::Psi, BeamMotion::V].map(|of| of as usize);
                actions[psi] = actions[psi]
                    .plus_scaled(Real::splat(point.z), actions[w])
                    .plus_scaled(Real::splat(-point.y), actions[v]);
                Jumps::of_forces(waves, &actions)
            }
            Self::Joint(_) => Jumps::of_motions(waves, &actions),
        }
    }

    /// Whether what it observes along a motion is odd in both directions.
    #[inline(always)]
    const fn is_odd(self, motion: usize) -> bool {
        match self {
            Self::Support(_) => motion >= 3,
            Self::Joint(_) => motion < 3,
        }
    }

    /// What it observes by each wave, for an observer who looks to a side.
    #[inline(always)]
    fn rows<A: Arithmetic>(self, waves: &Waves<A>, side: Side) -> Matrix<A, MOTIONS, 6> {
        let mut rows = [[Complex::ZERO; 6]; MOTIONS];
        for row in 0..3 {
            for wave in 0..6 {
                let (moved, turned, to_left) = match self {
                    Self::Support(held) => {
                        let moved = waves.at_point(held.support.point, row, wave).0;
                        (moved, waves.slope[row][wave], 3)
                    }
                    Self::Joint(_) => (-waves.force[row][wave], waves.moment[row][wave], 0),
                };
                rows[row][wave] = moved;
                rows[row + 3][wave] = turned;
                if side == Side::Right {
                    rows[row + to_left][wave] = -rows[row + to_left][wave];
                }
            }
        }
        rows
    }

    #[inline(always)]
    fn condition<A: Arithmetic>(self, waves: &Waves<A>, motion: BeamMotion) -> Condition<A> {
        let tied = |action, observed, load| Condition::Tied {
            action,
            observed,
            load,
        };
        match self {
            Self::Support(held) => {
                let (stiffness, _, load) = restraint(waves.omega, held, motion);
                // Without warping stiffness none acts on the rate of twist.
                let idle = waves.without_warping && motion == BeamMotion::PsiSlope;
                match held.support[motion] {
                    Restraint::Fixed if !idle => tied(Complex::ZERO, stiffness, load),
                    Restraint::Elastic(_) if !idle => tied(Complex::ONE, stiffness, load),
                    Restraint::Free | Restraint::Fixed | Restraint::Elastic(_) => {
                        Condition::Known(load)
                    }
                }
            }
            Self::Joint(joined) => match joined.spring(motion) {
                None => Condition::Known(Complex::ZERO),
                Some(spring) => {
                    let stiffness = waves.omega.dynamic_stiffness(spring);
                    tied(-stiffness, Complex::ONE, Complex::ZERO)
                }
            },
        }
    }
}

impl<A: Arithmetic> Reflection<A> {
    /// Over a support or joint, looking to a side; also multiplies a product by the determinant of its equations.
    pub(super) fn act(
        &mut self,
        waves: &Waves<A>,
        (acting, side): (Acting<'_>, Side),
        actions: &mut Actions<A>,
        determinant: Option<&mut ScaledProduct<A>>,
    ) {
        A::outlined(Act((self, (waves, acting, side), (actions, determinant))));
    }

    #[inline(always)]
    fn act_inlined(
        (this, (waves, acting, side), (actions, determinant)): (
            &mut Self,
            Looking<'_, A>,
            Answer<'_, A>,
        ),
    ) {
        let rows = acting.rows(waves, side);
        // What is observed per b', and without incoming waves.
        let mut moved = [[Complex::ZERO; 6]; MOTIONS];
        let mut still = [Complex::ZERO; MOTIONS];
        for motion in 0..MOTIONS {
            let is_odd = acting.is_odd(motion);
            let row = &rows[motion];
            for column in 0..6 {
                let mut back = Complex::ZERO;
                for wave in 0..6 {
                    back = back.plus_product(row[wave], this.r[entry(wave, column)]);
                }
                let arriving = row[column] * waves.radiation[column];
                moved[motion][column] = if is_odd {
                    arriving - back
                } else {
                    arriving + back
                };
            }
            for wave in 0..6 {
                still[motion] = if is_odd {
                    still[motion].minus_product(row[wave], this.s[wave])
                } else {
                    still[motion].plus_product(row[wave], this.s[wave])
                };
            }
        }
        let mut receptance = [[Complex::ZERO; MOTIONS]; MOTIONS];
        for motion in 0..MOTIONS {
            for action in 0..MOTIONS {
                let mut sum = Complex::ZERO;
                for wave in 0..6 {
                    sum = sum.plus_product(moved[motion][wave], rows[action][wave]);
                }
                receptance[motion][action] = if acting.is_odd(action) { sum } else { -sum };
            }
        }
        let mut of_actions = [[Complex::ZERO; MOTIONS]; MOTIONS];
        let mut right = [[Complex::ZERO; 7]; MOTIONS];
        let mut unscaled = Real::ONE;
        for motion in BeamMotion::ALL {
            let row = motion as usize;
            match acting.condition(waves, motion) {
                Condition::Known(load) => {
                    of_actions[row][row] = Complex::ONE;
                    right[row][6] = load;
                }
                Condition::Tied {
                    action,
                    observed,
                    load,
                } => {
                    let own = observed * receptance[row][row];
                    let scale = (action.size() + own.size()).inverse_power_of_two();
                    let scaled = observed.scaled(scale);
                    for action in 0..MOTIONS {
                        of_actions[row][action] = scaled * receptance[row][action];
                    }
                    for column in 0..6 {
                        right[row][column] = -(scaled * moved[row][column]);
                    }
                    of_actions[row][row] += action.scaled(scale);
                    right[row][6] = load.scaled(scale) - scaled * still[row];
                    unscaled = unscaled / scale;
                }
            }
        }
        match determinant {
            Some(product) => {
                product.times(solve_with_determinant(&mut of_actions, &mut right));
                product.times(Complex::from_real(unscaled));
            }
            None => solve(&mut of_actions, &mut right),
        }
        *actions = Actions::of_rows(&right);
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
    Act ['a, A: Arithmetic] ['a, A]
    (&'a mut Reflection<A>, Looking<'a, A>, Answer<'a, A>) -> (),
    Reflection::act_inlined
);

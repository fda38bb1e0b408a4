//! The two ends of the beam at several frequencies at once: their supports and loads as equations of the waves.

use super::complex::{Complex, Matrix};
use super::linear::{solve, solve_with_determinant, solve_with_margin};
use super::number::{Arithmetic, Real, part};
use super::product::ScaledProduct;
use super::reflection::{Amplitudes, Reflection, Side, entry, reach};
use super::waves::Waves;
use crate::model::{BeamMotion, Point, Restraint};
use crate::solve::linear::ZERO;
use crate::solve::plan::Held;

/// Below a margin of the last system of this number of roundings its solution is only rounding: the model has no damping and is
/// at a resonance to the last digits of the frequency.
const RESONANT: f64 = 90.0;

/// The motions of an end: first w and psi, which may be coupled, then v.
const MOTIONS: [BeamMotion; 6] = [
    BeamMotion::W,
    BeamMotion::Psi,
    BeamMotion::WSlope,
    BeamMotion::PsiSlope,
    BeamMotion::V,
    BeamMotion::VSlope,
];

/// The equation of one motion of an end for the outgoing and the incoming waves: those that move it, from the first of
/// them on.
#[derive(Debug, Clone)]
struct EndRow<A> {
    of_leaving: [Complex<A>; 6],
    of_arriving: [Complex<A>; 6],
    load: Complex<A>,
    /// A power of two that scales the row.
    scale: Real<A>,
}

impl<A: Arithmetic> EndRow<A> {
    const NONE: Self = Self {
        of_leaving: [Complex::ZERO; 6],
        of_arriving: [Complex::ZERO; 6],
        load: Complex::ZERO,
        scale: Real::ONE,
    };

    /// Becomes K q - p = F at the left end. At the right end p has the other sign; there the outgoing waves go left, so
    /// forces and slopes also change sign, and the equation is the same except for the load of a slope.
    fn set<const ALL: bool>(
        &mut self,
        waves: &Waves<A>,
        end: &Held,
        motion: BeamMotion,
        side: Side,
    ) {
        A::outlined(SetRow::<A, ALL>((self, waves, end, motion, side)));
    }

    #[inline(always)]
    fn set_inlined<const ALL: bool>(
        (this, waves, end, motion, side): (&mut Self, &Waves<A>, &Held, BeamMotion, Side),
    ) {
        let row = motion as usize % 3;
        let is_slope = motion as usize >= 3;
        let (stiffness, acts, load) = restraint(waves.omega, end, motion);
        let (from, to) = reach::<ALL>(row);
        let is_on_axis = end.support.point == Point::AXIS;
        let mut largest = Real::ZERO;
        for wave in from..to {
            let (leaving, arriving) = if is_slope {
                let moved = stiffness * waves.slope[row][wave];
                let acted = waves.moment[row][wave].scaled(acts);
                (-(moved + acted), moved - acted)
            } else {
                let (moved, acted) = if is_on_axis {
                    (waves.displacement[row][wave], waves.force[row][wave])
                } else {
                    waves.at_point(end.support.point, row, wave)
                };
                let moved = stiffness * moved;
                let acted = acted.scaled(acts);
                (moved - acted, moved + acted)
            };
            this.of_leaving[wave - from] = leaving;
            this.of_arriving[wave - from] = arriving;
            largest = largest.max(leaving.size());
        }
        // Makes rows in different units comparable.
        let by = largest.inverse_power_of_two();
        for k in 0..to - from {
            this.of_leaving[k] = this.of_leaving[k].scaled(by);
            this.of_arriving[k] = this.of_arriving[k].scaled(by);
        }
        let is_turned = is_slope && side == Side::Right;
        this.load = if is_turned { -load } else { load }.scaled(by);
        this.scale = by;
    }
}

impl<A: Arithmetic> Waves<A> {
    /// A displacement (w, psi, v) of a wave at a point of the section, and the internal force conjugate to it.
    #[inline(always)]
    pub(super) fn at_point(
        &self,
        point: Point,
        row: usize,
        wave: usize,
    ) -> (Complex<A>, Complex<A>) {
        let (moved, acted) = (self.displacement[row][wave], self.force[row][wave]);
        let twist = self.displacement[PSI][wave];
        let [y, z] = [point.y, point.z].map(Real::splat);
        match row {
            0 => (moved.plus_scaled(z, twist), acted),
            PSI => {
                let torque = acted.plus_scaled(-z, self.force[0][wave]);
                (moved, torque.plus_scaled(y, self.force[2][wave]))
            }
            _ => (moved.plus_scaled(-y, twist), acted),
        }
    }
}

/// Index of psi among (w, psi, v).
const PSI: usize = BeamMotion::Psi as usize;

/// The dynamic stiffness of a motion of a support, the factor (1 or 0) of the internal force, and the load with the pull of
/// ground that moves; of a fixed motion that of the ground.
#[inline(always)]
pub(super) fn restraint<A: Arithmetic>(
    omega: Complex<A>,
    end: &Held,
    motion: BeamMotion,
) -> (Complex<A>, Real<A>, Complex<A>) {
    let load = Complex::splat(end.loads_at_point()[motion as usize]);
    let ground = end.ground[motion as usize];
    match &end.support[motion] {
        // A fixed motion is that of the ground under any load.
        Restraint::Fixed => (Complex::ONE, Real::ZERO, Complex::splat(ground)),
        Restraint::Free => (Complex::ZERO, Real::ONE, load),
        Restraint::Elastic(elastic) => {
            let inertia = (omega * omega).scaled(Real::splat(elastic.inertia));
            let spring = omega.dynamic_stiffness(&elastic.spring);
            let pull = if ground == ZERO {
                load
            } else {
                load.plus_product(spring, Complex::splat(ground))
            };
            (spring - inertia, Real::ONE, pull)
        }
    }
}

/// The reflection of an end, for an observer who looks at it.
pub(super) fn reflection<A: Arithmetic>(waves: &Waves<A>, end: &Held, side: Side) -> Reflection<A> {
    reflection_with(waves, end, side, None)
}

/// The same; also multiplies a product by the determinant of the equations for the outgoing waves.
pub(super) fn reflection_with<A: Arithmetic>(
    waves: &Waves<A>,
    end: &Held,
    side: Side,
    determinant: Option<&mut ScaledProduct<A>>,
) -> Reflection<A> {
    A::outlined(Reflect((waves, end, side, determinant)))
}

#[inline(always)]
fn reflection_inlined<A: Arithmetic>(
    (waves, end, side, mut determinant): (&Waves<A>, &Held, Side, Option<&mut ScaledProduct<A>>),
) -> Reflection<A> {
    let mut out = Reflection::NONE;
    let wanted = determinant.is_some();
    let determinants = if waves.all_coupled {
        let all = reflect::<A, 6, 7, true>(waves, (end, side), 0, wanted, &mut out);
        [all, Complex::ONE]
    } else {
        [
            reflect::<A, 4, 5, false>(waves, (end, side), 0, wanted, &mut out),
            reflect::<A, 2, 3, false>(waves, (end, side), 4, wanted, &mut out),
        ]
    };
    if let Some(product) = &mut determinant {
        product.times(determinants[0]);
        product.times(determinants[1]);
    }
    out
}

/// The block of `N` waves from `first` on, and its determinant if requested; `R` is `N` + 1.
#[inline(always)]
fn reflect<A: Arithmetic, const N: usize, const R: usize, const ALL: bool>(
    waves: &Waves<A>,
    (end, side): (&Held, Side),
    first: usize,
    wants_determinant: bool,
    out: &mut Reflection<A>,
) -> Complex<A> {
    let mut unscaled = Real::ONE;
    let mut of_leaving = [[Complex::ZERO; N]; N];
    let mut right = [[Complex::ZERO; R]; N];
    let mut equation = EndRow::NONE;
    for row in 0..N {
        equation.set::<ALL>(waves, end, MOTIONS[first + row], side);
        for column in 0..N {
            of_leaving[row][column] = equation.of_leaving[column];
            let radiation = waves.radiation[first + column];
            right[row][column] = -(equation.of_arriving[column] * radiation);
        }
        right[row][N] = equation.load;
        unscaled = unscaled / equation.scale;
    }
    let determinant = if wants_determinant {
        solve_with_determinant(&mut of_leaving, &mut right).scaled(unscaled)
    } else {
        solve(&mut of_leaving, &mut right);
        Complex::ZERO
    };
    for row in 0..N {
        for column in row..N {
            // Symmetric up to rounding; the mean halves the rounding error.
            let mean = (right[row][column] + right[column][row]).scaled(Real::splat(0.5));
            out.r[entry(first + row, first + column)] = mean;
        }
        out.s[first + row] = right[row][N];
    }
    determinant
}

/// b' at the right end, from the reflection on its left; not finite at an undamped resonance.
pub(super) fn right_end<A: Arithmetic>(
    waves: &Waves<A>,
    end: &Held,
    at: &Reflection<A>,
) -> Amplitudes<A> {
    A::outlined(RightEnd((waves, end, at)))
}

#[inline(always)]
fn right_end_inlined<A: Arithmetic>(
    (waves, end, at): (&Waves<A>, &Held, &Reflection<A>),
) -> Amplitudes<A> {
    let mut system = RightSystem::NONE;
    if waves.all_coupled {
        system.set::<true>(waves, end, at);
    } else {
        system.set::<false>(waves, end, at);
    }
    finite_where_resolved(&mut system.of_b, &mut system.right, &system.terms)
}

/// Multiplies a product by the determinant of the equations of the right end for b'.
pub(super) fn right_determinant<A: Arithmetic>(
    waves: &Waves<A>,
    end: &Held,
    at: &Reflection<A>,
    product: &mut ScaledProduct<A>,
) {
    A::outlined(RightDeterminant((waves, end, at, product)));
}

#[inline(always)]
fn right_determinant_inlined<A: Arithmetic>(
    (waves, end, at, product): (&Waves<A>, &Held, &Reflection<A>, &mut ScaledProduct<A>),
) {
    let mut system = RightSystem::NONE;
    if waves.all_coupled {
        system.set::<true>(waves, end, at);
    } else {
        system.set::<false>(waves, end, at);
    }
    product.times(solve_with_determinant(&mut system.of_b, &mut system.right));
    let mut unscaled = Real::ONE;
    for scale in system.scales {
        unscaled = unscaled / scale;
    }
    product.times(Complex::from_real(unscaled));
}

/// The six equations of the right end for b', with a = R N b' + s.
#[derive(Debug, Clone)]
struct RightSystem<A> {
    of_b: Matrix<A, 6, 6>,
    right: Matrix<A, 6, 1>,
    /// For each column the largest magnitude among the summands of its entries.
    terms: [Real<A>; 6],
    /// Powers of two by which the rows are scaled.
    scales: [Real<A>; 6],
}

impl<A: Arithmetic> RightSystem<A> {
    const NONE: Self = Self {
        of_b: [[Complex::ZERO; 6]; 6],
        right: [[Complex::ZERO; 1]; 6],
        terms: [Real::ZERO; 6],
        scales: [Real::ONE; 6],
    };

    #[inline(always)]
    fn set<const ALL: bool>(&mut self, waves: &Waves<A>, end: &Held, at: &Reflection<A>) {
        let mut sizes = [Real::ZERO; super::reflection::ENTRIES];
        for (size, r) in sizes.iter_mut().zip(&at.r) {
            *size = r.size();
        }
        let mut equation = EndRow::NONE;
        for row in 0..6 {
            equation.set::<ALL>(waves, end, MOTIONS[row], Side::Right);
            let (from, to) = reach::<ALL>(MOTIONS[row] as usize % 3);
            self.scales[row] = equation.scale;
            self.right[row][0] = equation.load;
            for wave in from..to {
                let arriving = equation.of_arriving[wave - from];
                self.right[row][0] = self.right[row][0].minus_product(arriving, at.s[wave]);
            }
            for column in 0..6 {
                let mut sum = if column >= from && column < to {
                    equation.of_leaving[column - from] * waves.radiation[column]
                } else {
                    Complex::ZERO
                };
                let mut size = sum.size();
                for wave in from..to {
                    let arriving = equation.of_arriving[wave - from];
                    sum = sum.plus_product(arriving, at.r[entry(wave, column)]);
                    size = arriving
                        .size()
                        .multiply_add(sizes[entry(wave, column)], size);
                }
                self.of_b[row][column] = sum;
                self.terms[column] = self.terms[column].max(size);
            }
        }
    }
}

/// b' where the reflections of both sides of a point meet; not finite at an undamped resonance.
pub(super) fn join<A: Arithmetic>(
    waves: &Waves<A>,
    left: &Reflection<A>,
    right: &Reflection<A>,
) -> Amplitudes<A> {
    A::outlined(Join((waves, left, right)))
}

#[inline(always)]
fn join_inlined<A: Arithmetic>(
    (waves, left, right): (&Waves<A>, &Reflection<A>, &Reflection<A>),
) -> Amplitudes<A> {
    let mut of_b = [[Complex::ZERO; 6]; 6];
    let mut load = [[Complex::ZERO; 1]; 6];
    let mut terms = [Real::ZERO; 6];
    for row in 0..6 {
        // R N N^-1: back to unscaled waves.
        let mut back = [Complex::ZERO; 6];
        load[row][0] = right.s[row];
        for wave in 0..6 {
            back[wave] = right.r[entry(row, wave)] * waves.weight[wave];
            load[row][0] = load[row][0].plus_product(back[wave], left.s[wave]);
        }
        for column in 0..6 {
            let mut sum = if row == column {
                waves.radiation[row]
            } else {
                Complex::ZERO
            };
            let mut size = sum.size();
            for wave in 0..6 {
                let other = left.r[entry(wave, column)];
                sum = sum.minus_product(back[wave], other);
                size = back[wave].size().multiply_add(other.size(), size);
            }
            of_b[row][column] = sum;
            terms[column] = terms[column].max(size);
        }
    }
    finite_where_resolved(&mut of_b, &mut load, &terms)
}

/// The solution; infinite if it would be only rounding.
#[inline(always)]
fn finite_where_resolved<A: Arithmetic>(
    of_b: &mut Matrix<A, 6, 6>,
    right: &mut Matrix<A, 6, 1>,
    terms: &[Real<A>; 6],
) -> Amplitudes<A> {
    let margin = solve_with_margin(of_b, right, terms);
    let resonant = Real::splat(RESONANT * A::ROUNDING);
    let infinite = Complex::from_real(Real::splat(f64::INFINITY));
    let mut out = [Complex::ZERO; 6];
    for wave in 0..6 {
        out[wave] = Complex::where_less(margin, resonant, infinite, right[wave][0]);
    }
    out
}

part!(
    Reflect ['a, A: Arithmetic] ['a, A]
    (&'a Waves<A>, &'a Held, Side, Option<&'a mut ScaledProduct<A>>) -> Reflection<A>,
    reflection_inlined
);

part!(
    SetRow ['a, A: Arithmetic, const ALL: bool] ['a, A, ALL]
    (&'a mut EndRow<A>, &'a Waves<A>, &'a Held, BeamMotion, Side) -> (),
    EndRow::set_inlined::<ALL>
);

part!(
    RightEnd ['a, A: Arithmetic] ['a, A]
    (&'a Waves<A>, &'a Held, &'a Reflection<A>) -> Amplitudes<A>,
    right_end_inlined
);

part!(
    Join ['a, A: Arithmetic] ['a, A]
    (&'a Waves<A>, &'a Reflection<A>, &'a Reflection<A>) -> Amplitudes<A>,
    join_inlined
);

part!(
    RightDeterminant ['a, A: Arithmetic] ['a, A]
    (&'a Waves<A>, &'a Held, &'a Reflection<A>, &'a mut ScaledProduct<A>) -> (),
    right_determinant_inlined
);

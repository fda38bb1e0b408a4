//! The six waves of any uniform beam: all of w, psi and v may be coupled.
//!
//! With the matrices of [`crate::solve::beam_matrices`] a wave `exp(-kappa x)` of the shape q has `T(h) q = 0`, h =
//! kappa^2 and, with `P = omega^2 M - K + h C` and the foundation K,
//!
//! ```text
//! T(h) = (h D + omega^2 R) (h + F P) - P
//! ```
//!
//! In the principal axes of bending D and R are diagonal. Motions without coupling have their own quadratic equation.
//! The roots of the others converge together (Aberth, Math. Comp. 27 (1973) 339-344) from those without coupling. The
//! shape of a wave is the largest column of the adjugate of T. Rotations of the section are `kappa r` with `r = q + F P q
//! / h`, internal moments `h D r`, internal forces `kappa ((h D + omega^2 R) r - C q)` or, where this cancels, the same
//! from the equation of motion, `(omega^2 M - K) q / kappa`.

use num_complex::Complex64;

use super::complex::{Complex, Matrix};
use super::double_double::DoubleDouble;
use super::number::{Arithmetic, Real, part};
use super::waves::Waves;
use crate::model::Point;
use crate::solve::beam_matrices::{BeamMatrices, Symmetric};
use crate::solve::linear::ZERO;
use crate::solve::waves::WARPING_WAVE;

/// Index of psi among the motions (w, psi, v).
const PSI: usize = 1;

/// The motions of the waves, two for each: the warping wave is the first.
const MOTION_OF_WAVE: [usize; 6] = [PSI, PSI, 0, 0, 2, 2];

/// The matrices in the principal axes of bending, and what is coupled in them.
#[derive(Debug, Clone)]
pub(super) struct GeneralConstants {
    /// The diagonals of D and R.
    bending: [Complex64; 3],
    rotary: [f64; 3],
    tension: [[Complex64; 3]; 3],
    shear: [[Complex64; 3]; 3],
    mass: [[f64; 3]; 3],
    /// The springs and the dampers of the foundation.
    foundation: [[Complex64; 3]; 3],
    foundation_damping: [[f64; 3]; 3],
    /// The beam lies on a foundation: waves may be neither evanescent nor travelling.
    is_bedded: bool,
    /// The motions that are coupled to another one.
    is_coupled: [bool; 3],
    /// Cosine and sine of the angle between the axes, whose squares add up to 1 with twice the digits.
    axes: [Real<DoubleDouble>; 2],
    /// Scales twist to displacement, m.
    radius: f64,
}

impl GeneralConstants {
    /// Of a beam whose shear centres lie at an offset from the axis, on which its foundation acts.
    pub(super) fn new(matrices: &BeamMatrices, offset: Point) -> Self {
        let BeamMatrices {
            bending,
            tension,
            shear,
            foundation,
            foundation_damping,
            mass,
            rotary,
        } = matrices;
        let to_centroid = [mass.w_psi, mass.psi_v].map(|coupling| coupling / mass.w);
        let axes = principal_axes(bending, to_centroid);
        let diagonal = |rows: [[Complex64; 3]; 3]| [rows[0][0], rows[1][1], rows[2][2]];
        let real = |of: &Symmetric<f64>| turned(&of.map(Complex64::from), axes);
        let (tension, shear) = (turned(tension, axes), turned(shear, axes));
        let mass = real(mass).map(|row| row.map(|entry| entry.re));
        let to_axis = Point {
            y: -offset.y,
            z: -offset.z,
        };
        let bedded = |of: [Complex64; 3]| turned(&Symmetric::diagonal(of).moved(to_axis), axes);
        let foundation = bedded(*foundation);
        let foundation_damping = bedded(foundation_damping.map(Into::into));
        let foundation_damping = foundation_damping.map(|row| row.map(|entry| entry.re));
        let couples = |i: usize, j: usize| {
            let springs = [tension[i][j], shear[i][j], foundation[i][j]];
            let is_coupled = springs.iter().any(|entry| *entry != ZERO);
            i != j && (is_coupled || mass[i][j] != 0.0 || foundation_damping[i][j] != 0.0)
        };
        Self {
            bending: diagonal(turned(bending, axes)),
            rotary: diagonal(real(rotary)).map(|entry| entry.re),
            is_coupled: [0, 1, 2].map(|i| (0..3).any(|j| couples(i, j))),
            tension,
            shear,
            mass,
            foundation,
            foundation_damping,
            is_bedded: matrices.has_foundation(),
            axes: normalised(axes),
            radius: (matrices.mass.psi / matrices.mass.w).sqrt(),
        }
    }
}

/// A direction of the length 1.
fn normalised(direction: [f64; 2]) -> [Real<DoubleDouble>; 2] {
    let [cosine, sine] = direction.map(Real::splat);
    let length = cosine.multiply_add(cosine, sine * sine).sqrt();
    [cosine / length, sine / length]
}

/// A matrix in the principal axes, exactly symmetric; an entry that is only the rounding of the rotation is 0.
fn turned(of: &Symmetric<Complex64>, [cosine, sine]: [f64; 2]) -> [[Complex64; 3]; 3] {
    const ROUNDING: f64 = 4.0 * f64::EPSILON;
    let rows = of.rows();
    let axes = [[cosine, 0.0, -sine], [0.0, 1.0, 0.0], [sine, 0.0, cosine]];
    let entry = |i: usize, j: usize| {
        let (mut sum, mut terms) = (ZERO, 0.0);
        for k in 0..3 {
            for l in 0..3 {
                let term = axes[k][i] * rows[k][l] * axes[l][j];
                sum += term;
                terms += term.norm();
            }
        }
        if sum.norm() <= ROUNDING * terms {
            ZERO
        } else {
            sum
        }
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i.min(j), i.max(j))))
}

/// Cosine and sine of the angle between y and the first principal axis; if all axes are principal, of the direction of
/// the centroid, in which w alone is coupled to psi.
fn principal_axes(bending: &Symmetric<Complex64>, [along_w, along_v]: [f64; 2]) -> [f64; 2] {
    let (w, v, both) = (bending.w.re, bending.v.re, bending.w_v.re);
    if both != 0.0 {
        let angle = 0.5 * (2.0 * both).atan2(w - v);
        [angle.cos(), angle.sin()]
    } else if w == v && along_v != 0.0 {
        let distance = along_w.hypot(along_v);
        [along_w / distance, along_v / distance]
    } else {
        [1.0, 0.0]
    }
}

/// T at some frequencies, and the matrices of which it is made.
struct Group<'a, A> {
    constants: &'a GeneralConstants,
    /// omega^2.
    square: Complex<A>,
    /// omega^2 M - K.
    inertia: Matrix<A, 3, 3>,
    /// `T = of[2] h^2 + of[1] h + of[0]`.
    of: [Matrix<A, 3, 3>; 3],
}

impl<'a, A: Arithmetic> Group<'a, A> {
    #[inline(always)]
    fn new(constants: &'a GeneralConstants, omega: Complex<A>) -> Self {
        let square = omega * omega;
        let turned = Complex {
            re: -omega.im,
            im: omega.re,
        };
        let mut inertia = [[Complex::ZERO; 3]; 3];
        for row in 0..3 {
            for column in 0..3 {
                inertia[row][column] = square.scaled(Real::splat(constants.mass[row][column]));
                if constants.is_bedded {
                    let damping = Real::splat(-constants.foundation_damping[row][column]);
                    let spring = Complex::splat(constants.foundation[row][column]);
                    inertia[row][column] =
                        (inertia[row][column] - spring).plus_scaled(damping, turned);
                }
            }
        }
        let mut of = [[[Complex::ZERO; 3]; 3]; 3];
        for row in 0..3 {
            let d = Complex::splat(constants.bending[row]);
            let r = square.scaled(Real::splat(constants.rotary[row]));
            for column in 0..3 {
                // Of 1 + F C, and of F (omega^2 M - K).
                let mut slope = if row == column {
                    Complex::ONE
                } else {
                    Complex::ZERO
                };
                let mut sheared = Complex::ZERO;
                for k in 0..3 {
                    let compliance = Complex::splat(constants.shear[row][k]);
                    let tension = Complex::splat(constants.tension[k][column]);
                    slope = slope.plus_product(compliance, tension);
                    sheared = sheared.plus_product(compliance, inertia[k][column]);
                }
                let tension = Complex::splat(constants.tension[row][column]);
                of[2][row][column] = d * slope;
                of[1][row][column] = (d * sheared).plus_product(r, slope) - tension;
                of[0][row][column] = (r * sheared) - inertia[row][column];
            }
        }
        Self {
            constants,
            square,
            inertia,
            of,
        }
    }

    /// The two roots of a motion without coupling, the larger one first; its value is meaningless if the coefficient of
    /// `h^2` is 0.
    #[inline(always)]
    fn roots(&self, motion: usize) -> [Complex<A>; 2] {
        let [c, b, a] = [0, 1, 2].map(|power| self.of[power][motion][motion]);
        let product = a * c;
        let discriminant = (b * b).minus_product(product, Complex::from_real(Real::splat(4.0)));
        let larger = (discriminant.sqrt().along(-b) - b).scaled(Real::splat(0.5));
        [larger * a.inverse(), c * larger.inverse()]
    }

    /// T of the coupled motions at h, 1 for the others, and its derivative by h.
    #[inline(always)]
    fn at(&self, h: Complex<A>) -> [Matrix<A, 3, 3>; 2] {
        let mut value = [[Complex::ZERO; 3]; 3];
        let mut slope = value;
        for row in 0..3 {
            for column in 0..3 {
                if self.constants.is_coupled[row] && self.constants.is_coupled[column] {
                    let [c, b, a] = [0, 1, 2].map(|power| self.of[power][row][column]);
                    let rising = a * h;
                    value[row][column] = c.plus_product(rising + b, h);
                    slope[row][column] = rising + rising + b;
                } else if row == column {
                    value[row][column] = Complex::ONE;
                }
            }
        }
        [value, slope]
    }

    /// det T, and its derivative by h: the trace of the adjugate of T times the derivative of T.
    #[inline(always)]
    fn characteristic(&self, h: Complex<A>) -> [Complex<A>; 2] {
        let [value, slope] = self.at(h);
        let adjugate = adjugate(&value);
        let mut determinant = Complex::ZERO;
        let mut change = Complex::ZERO;
        for row in 0..3 {
            determinant = determinant.plus_product(value[0][row], adjugate[row][0]);
            for column in 0..3 {
                change = change.plus_product(adjugate[row][column], slope[column][row]);
            }
        }
        [determinant, change]
    }

    /// The shape of a wave of the coupled motions: the largest column of the adjugate of T, twist times the radius of
    /// gyration.
    #[inline(always)]
    fn shape(&self, h: Complex<A>) -> [Complex<A>; 3] {
        let [value, _] = self.at(h);
        let adjugate = adjugate(&value);
        let weights = [1.0, self.constants.radius, 1.0].map(Real::splat);
        let mut largest = Real::splat(-1.0);
        let mut shape = [Complex::ZERO; 3];
        for column in 0..3 {
            if !self.constants.is_coupled[column] {
                continue;
            }
            let mut size = Real::ZERO;
            for row in 0..3 {
                size = size + adjugate[row][column].size() * weights[row];
            }
            let size = size * weights[column];
            for row in 0..3 {
                if self.constants.is_coupled[row] {
                    let other = adjugate[row][column];
                    shape[row] = Complex::where_less(largest, size, other, shape[row]);
                }
            }
            largest = largest.max(size);
        }
        shape
    }
}

/// The adjugate of a matrix.
#[inline(always)]
fn adjugate<A: Arithmetic>(of: &Matrix<A, 3, 3>) -> Matrix<A, 3, 3> {
    let mut adjugate = [[Complex::ZERO; 3]; 3];
    for row in 0..3 {
        for column in 0..3 {
            // The minor without the row and the column of the transpose.
            let [a, b] = [(column + 1) % 3, (column + 2) % 3];
            let [c, d] = [(row + 1) % 3, (row + 2) % 3];
            adjugate[row][column] = (of[a][c] * of[b][d]).minus_product(of[a][d], of[b][c]);
        }
    }
    adjugate
}

/// A root during the iteration.
#[derive(Debug, Clone, Copy)]
struct Moving<A> {
    h: Complex<A>,
    /// The size of its last step, squared.
    last: Real<A>,
}

/// Moves the roots of the coupled motions from those without coupling to their own; `first` is the first that exists.
#[inline(always)]
fn settle<A: Arithmetic>((group, roots, first): (&Group<'_, A>, &mut [Complex<A>; 6], usize)) {
    const MOST_STEPS: usize = 80;
    let mut moving = [Moving {
        h: Complex::ZERO,
        last: Real::splat(f64::INFINITY),
    }; 6];
    for wave in first..6 {
        // Equal starting values would stay equal.
        let apart = 1e-3 * wave as f64;
        // Real ones would also stay real, but on a foundation not all roots are.
        let aside = if group.constants.is_bedded {
            apart
        } else {
            0.0
        };
        let apart = Complex::splat(Complex64::new(1.0 + apart, aside));
        moving[wave].h = roots[wave] * apart;
    }
    for _ in 0..MOST_STEPS {
        let mut is_moving = false;
        for wave in first..6 {
            if group.constants.is_coupled[MOTION_OF_WAVE[wave]] {
                is_moving |= A::outlined(Step((group, &mut moving, (first, wave))));
            }
        }
        if !is_moving {
            break;
        }
    }
    for wave in first..6 {
        if group.constants.is_coupled[MOTION_OF_WAVE[wave]] {
            roots[wave] = moving[wave].h;
        }
    }
}

/// A step of one root; returns whether any frequency needs another one.
#[inline(always)]
fn step<A: Arithmetic>(
    (group, moving, (first, wave)): (&Group<'_, A>, &mut [Moving<A>; 6], (usize, usize)),
) -> bool {
    let Moving { h, last } = moving[wave];
    let [value, slope] = group.characteristic(h);
    let mut push = Complex::ZERO;
    for other in first..6 {
        if other != wave && group.constants.is_coupled[MOTION_OF_WAVE[other]] {
            push += (h - moving[other].h).inverse();
        }
    }
    let divisor = slope.minus_product(value, push);
    let step = value * divisor.inverse();
    let step = Complex::where_less(Real::ZERO, divisor.norm_sqr(), step, Complex::ZERO);
    // The remainder of a step is about its cube, relative to h: this one is the last if its square is only rounding.
    let (size, near) = (step.norm_sqr(), h.norm_sqr() * Real::splat(A::ROUNDING));
    // Each frequency stops independently of its neighbours.
    moving[wave].h = Complex::where_less(near, last, h - step, h);
    moving[wave].last = near.where_less(last, size, last);
    near.is_less_somewhere(moving[wave].last)
}

/// A wave in the principal axes.
struct Wave<A> {
    column: usize,
    h: Complex<A>,
    shape: [Complex<A>; 3],
}

impl<A: Arithmetic> Waves<A> {
    /// Becomes the six waves.
    #[inline(always)]
    pub(super) fn set_general(&mut self, constants: &GeneralConstants) {
        let group = Group::new(constants, self.omega);
        let first = if self.without_warping {
            WARPING_WAVE + 1
        } else {
            0
        };
        let mut roots = [Complex::ZERO; 6];
        for (motion, waves) in [(PSI, [0, 1]), (0, [2, 3]), (2, [4, 5])] {
            let [larger, smaller] = group.roots(motion);
            (roots[waves[0]], roots[waves[1]]) = (larger, smaller);
        }
        if constants.is_coupled.contains(&true) {
            A::outlined(Settle((&group, &mut roots, first)));
        }
        for column in first..6 {
            let motion = MOTION_OF_WAVE[column];
            let shape = if constants.is_coupled[motion] {
                group.shape(roots[column])
            } else {
                let mut alone = [Complex::ZERO; 3];
                alone[motion] = Complex::ONE;
                alone
            };
            let wave = Wave {
                column,
                h: roots[column],
                shape,
            };
            A::outlined(SetRows((self, &group, wave)));
        }
    }

    #[inline(always)]
    fn set_general_rows((this, group, wave): (&mut Self, &Group<'_, A>, Wave<A>)) {
        let Wave { column, h, shape } = wave;
        let constants = group.constants;
        let radius = Real::splat(constants.radius * constants.radius);
        let [w, psi, v] = shape;
        let size = psi
            .norm_sqr()
            .multiply_add(radius, w.norm_sqr() + v.norm_sqr());
        let scale = Real::ONE / size.sqrt();
        let q = [w.scaled(scale), psi.scaled(scale), v.scaled(scale)];
        let (kappa, inverse) = (h.sqrt(), h.inverse());
        // C q and (omega^2 M - K) q / h, with the sums of the sizes of their terms.
        let (mut pull, mut inertia) = ([Complex::ZERO; 3], [Complex::ZERO; 3]);
        let mut terms = [[Real::ZERO; 2]; 3];
        for row in 0..3 {
            for motion in 0..3 {
                let pulled = Complex::splat(constants.tension[row][motion]) * q[motion];
                let moved = group.inertia[row][motion] * q[motion] * inverse;
                pull[row] += pulled;
                inertia[row] += moved;
                terms[row] = [terms[row][0] + pulled.size(), terms[row][1] + moved.size()];
            }
        }
        let mut turn = q;
        let (mut slopes, mut moments, mut forces) = (q, q, q);
        for row in 0..3 {
            for motion in 0..3 {
                let sheared = pull[motion] + inertia[motion];
                let compliance = Complex::splat(constants.shear[row][motion]);
                turn[row] = turn[row].plus_product(compliance, sheared);
            }
            let d = Complex::splat(constants.bending[row]) * h;
            let r = group.square.scaled(Real::splat(constants.rotary[row]));
            slopes[row] = kappa * turn[row];
            moments[row] = d * turn[row];
            let bent = (d + r) * turn[row];
            let by_strain = bent - pull[row];
            let [pulled, moved] = terms[row];
            let strained = bent.size() + pulled;
            let force = Complex::where_less(strained, moved, by_strain, inertia[row]);
            forces[row] = kappa * force;
        }
        this.kappa[column] = kappa;
        for (rows, of) in [
            (&mut this.displacement, q),
            (&mut this.slope, slopes),
            (&mut this.force, forces),
            (&mut this.moment, moments),
        ] {
            let [cosine, sine] = constants.axes.map(Real::of);
            rows[0][column] = of[0].scaled(cosine).plus_scaled(-sine, of[2]);
            rows[1][column] = of[1];
            rows[2][column] = of[0].scaled(sine).plus_scaled(cosine, of[2]);
        }
        let mut norm = Complex::ZERO;
        for row in 0..3 {
            norm = norm
                .plus_product(forces[row], q[row])
                .plus_product(moments[row], slopes[row]);
        }
        this.set_weight(column, norm + norm);
    }
}

part!(
    Settle ['a, A: Arithmetic] ['a, A]
    (&'a Group<'a, A>, &'a mut [Complex<A>; 6], usize) -> (),
    settle
);

part!(
    Step ['a, A: Arithmetic] ['a, A]
    (&'a Group<'a, A>, &'a mut [Moving<A>; 6], (usize, usize)) -> bool,
    step
);

part!(
    SetRows ['a, A: Arithmetic] ['a, A]
    (&'a mut Waves<A>, &'a Group<'a, A>, Wave<A>) -> (),
    Waves::set_general_rows
);

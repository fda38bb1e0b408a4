//! Quadratic integrals along the beam, such as the vibration energy `E_V`, at several frequencies at once, in closed form.
//!
//! With amplitudes a at a span's left end and b at its right end the displacements are
//! `Q (exp(-kappa x) a + exp(-kappa (l - x)) b)`, so that an integral is the Hermitian form
//! `a* A a + b* A b + 2 Re(a* C b)` with the weighted shapes and the integrals of the exponentials over the span.
//!
//! Both forms of a span are Hermitian: 21 of their 36 entries are stored, 13 if shapes that move w and psi do not
//! overlap with those that move v. The exponentials are products of those of the span.

use super::complex::{Complex, Matrix};
use super::number::{Arithmetic, Real, part};
use super::reflection::Amplitudes;
use super::waves::Waves;
use crate::solve::beam_matrices::Symmetric;
use crate::solve::waves::{BeamConstants, WARPING_WAVE};

/// The most pairs of waves that overlap.
pub(super) const PAIRS: usize = 21;

/// The factor of the product of each pair of waves that overlap.
pub(super) type Weights<A> = [Complex<A>; PAIRS];

/// The first wave, and the one after the last, of each block of waves that overlap.
#[inline(always)]
const fn blocks<const ALL: bool>() -> &'static [(usize, usize)] {
    if ALL { &[(0, 6)] } else { &[(0, 4), (4, 6)] }
}

/// The energy forms of spans of one length.
#[derive(Debug, Clone)]
pub(super) struct Form<A> {
    /// Waves that travel in the same direction.
    pub(super) same: [Complex<A>; PAIRS],
    /// Waves that travel in opposite directions.
    pub(super) against: [Complex<A>; PAIRS],
    /// All waves overlap.
    pub(super) all_coupled: bool,
}

/// A sum, and the sum of the magnitudes of its terms.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sum<A> {
    value: Real<A>,
    terms: Real<A>,
}

/// The values of a form of the motions (w, psi, v), without an entry for w and v, for each pair of waves that overlap.
#[inline(always)]
pub(super) fn weights<A: Arithmetic>(waves: &Waves<A>, form: &Symmetric<f64>) -> Weights<A> {
    if waves.all_coupled {
        weights_of::<A, true>(waves, form)
    } else {
        weights_of::<A, false>(waves, form)
    }
}

#[inline(always)]
fn weights_of<A: Arithmetic, const ALL: bool>(
    waves: &Waves<A>,
    form: &Symmetric<f64>,
) -> Weights<A> {
    let [of_w, polar, of_v] = [form.w, form.psi, form.v].map(Real::splat);
    let [w_psi, psi_v] = [form.w_psi, form.psi_v].map(Real::splat);
    let has_offset = form.w_psi != 0.0 || form.psi_v != 0.0;
    let [w, psi, v] = &waves.displacement;
    let mut out = [Complex::ZERO; PAIRS];
    let mut pair = 0;
    for &(from, to) in blocks::<ALL>() {
        for i in from..to {
            for j in i..to {
                let mut weight = Complex::ZERO;
                if ALL || from == 0 {
                    weight = w[i]
                        .conj_times(w[j])
                        .scaled(of_w)
                        .plus_scaled(polar, psi[i].conj_times(psi[j]));
                }
                if ALL || from == 4 {
                    weight = weight.plus_scaled(of_v, v[i].conj_times(v[j]));
                }
                if has_offset {
                    let across = w[i].conj_times(psi[j]) + psi[i].conj_times(w[j]);
                    let along = v[i].conj_times(psi[j]) + psi[i].conj_times(v[j]);
                    weight = weight.plus_scaled(w_psi, across).plus_scaled(psi_v, along);
                }
                out[pair] = weight;
                pair += 1;
            }
        }
    }
    out
}

/// The form of what the loss factor of the material dissipates in a radian, twice: `int s'^H Im(D) s' + Im(G J) |psi'|^2 -
/// g^H Im(F) g dx` with the shear forces g; for waves in the same direction, and in opposite ones.
///
/// Source: the strain energy of Vlasov's beam, as Chen & Liu 2022, Section 2, derive their equations from; an axial force
/// dissipates nothing.
pub(super) fn dissipation<A: Arithmetic>(
    waves: &Waves<A>,
    beam: &BeamConstants,
) -> [Weights<A>; 2] {
    let matrices = &beam.matrices;
    let (bending, tension) = (matrices.bending.rows(), matrices.tension.rows());
    let compliance = [matrices.shear.w, matrices.shear.psi, matrices.shear.v];
    // The derivatives of the rotations, and the shear forces.
    let mut curvature: Matrix<A, 3, 6> = [[Complex::ZERO; 6]; 3];
    let mut shear = waves.force;
    for row in 0..3 {
        for wave in 0..6 {
            let kappa = waves.kappa[wave];
            curvature[row][wave] = kappa * waves.slope[row][wave];
            for motion in 0..3 {
                let pulled = Complex::splat(tension[row][motion]) * kappa;
                shear[row][wave] =
                    shear[row][wave].plus_product(pulled, waves.displacement[motion][wave]);
            }
        }
    }
    let blocks = if waves.all_coupled {
        blocks::<true>()
    } else {
        blocks::<false>()
    };
    let mut out = [[Complex::ZERO; PAIRS]; 2];
    let mut pair = 0;
    for &(from, to) in blocks {
        for i in from..to {
            for j in i..to {
                let twist = waves.slope[1][i].conj_times(waves.slope[1][j]);
                let mut odd = twist.scaled(Real::splat(beam.torsion.im));
                let mut even = Complex::ZERO;
                for row in 0..3 {
                    let sheared = shear[row][i].conj_times(shear[row][j]);
                    odd = odd.plus_scaled(Real::splat(-compliance[row].im), sheared);
                    for motion in 0..3 {
                        let bent = curvature[row][i].conj_times(curvature[motion][j]);
                        even = even.plus_scaled(Real::splat(bending[row][motion].im), bent);
                    }
                }
                // A wave that decays at once stores no energy.
                if !(waves.without_warping && i == WARPING_WAVE) {
                    // The rate of twist and the shear of a left-going wave have the opposite sign.
                    (out[0][pair], out[1][pair]) = (even + odd, even - odd);
                }
                pair += 1;
            }
        }
    }
    out
}

impl<A: Arithmetic> Form<A> {
    pub(super) const NONE: Self = Self {
        same: [Complex::ZERO; PAIRS],
        against: [Complex::ZERO; PAIRS],
        all_coupled: false,
    };

    /// The form of spans of a length, m, with the weights of waves in the same direction and in opposite ones.
    pub(super) fn new(
        waves: &Waves<A>,
        weights: [&Weights<A>; 2],
        length: f64,
        decay: &Amplitudes<A>,
    ) -> Self {
        if waves.all_coupled {
            A::outlined(NewForm::<A, true>((waves, weights, length, decay)))
        } else {
            A::outlined(NewForm::<A, false>((waves, weights, length, decay)))
        }
    }

    #[inline(always)]
    fn new_inlined<const ALL: bool>(
        (waves, [of_same, of_against], length, decay): (
            &Waves<A>,
            [&Weights<A>; 2],
            f64,
            &Amplitudes<A>,
        ),
    ) -> Self {
        let mut form = Self {
            all_coupled: ALL,
            ..Self::NONE
        };
        let mut pair = 0;
        for &(from, to) in blocks::<ALL>() {
            for i in from..to {
                for j in i..to {
                    let (left, right) = (waves.kappa[i].conj(), waves.kappa[j]);
                    let (at_left, at_right) = (decay[i].conj(), decay[j]);
                    let both = at_left * at_right;
                    form.same[pair] =
                        of_same[pair] * mean_difference(left + right, length, Complex::ONE, both);
                    form.against[pair] =
                        of_against[pair] * mean_difference(left - right, length, at_right, at_left);
                    pair += 1;
                }
            }
        }
        form
    }

    /// The energy of a span: a at its left end, b at its right end.
    pub(super) fn of(&self, a: &Amplitudes<A>, b: &Amplitudes<A>, sum: &mut Sum<A>) {
        if self.all_coupled {
            A::outlined(Of::<A, true>((self, a, b, sum)));
        } else {
            A::outlined(Of::<A, false>((self, a, b, sum)));
        }
    }

    #[inline(always)]
    fn of_inlined<const ALL: bool>(
        (this, a, b, sum): (&Self, &Amplitudes<A>, &Amplitudes<A>, &mut Sum<A>),
    ) {
        let mut pair = 0;
        for &(from, to) in blocks::<ALL>() {
            for i in from..to {
                for j in i..to {
                    let same = a[i].conj_times(a[j]) + b[i].conj_times(b[j]);
                    let against = a[i].conj_times(b[j]) + b[i].conj_times(a[j]);
                    // An off-diagonal entry counts twice.
                    let times = Real::splat(if i == j { 1.0 } else { 2.0 });
                    let same = (this.same[pair] * same).re * times;
                    let against = (this.against[pair] * against).re * times;
                    sum.value = sum.value + same + against;
                    sum.terms = sum.terms + same.abs() + against.abs();
                    pair += 1;
                }
            }
        }
    }
}

impl<A: Arithmetic> Form<A> {
    /// The energy of a span if each of its waves were alone, at least a twelfth of the magnitudes that `of` sums: a
    /// positive semidefinite form is at most its diagonal times the number of overlapping waves, which is eight or, if
    /// all are coupled, twelve.
    #[inline(always)]
    pub(super) fn apart(&self, a: &Amplitudes<A>, b: &Amplitudes<A>) -> Real<A> {
        /// Index of the pair of each wave with itself.
        const OWN: [[usize; 6]; 2] = [[0, 4, 7, 9, 10, 12], [0, 6, 11, 15, 18, 20]];
        let own = &OWN[usize::from(self.all_coupled)];
        let mut sum = Real::ZERO;
        for wave in 0..6 {
            let squares = a[wave].norm_sqr() + b[wave].norm_sqr();
            sum = self.same[own[wave]].re.multiply_add(squares, sum);
        }
        sum
    }
}

impl<A: Arithmetic> Sum<A> {
    pub(super) const ZERO: Self = Self {
        value: Real::ZERO,
        terms: Real::ZERO,
    };

    /// Adds another sum: its value, and the magnitudes of its terms.
    #[inline(always)]
    pub(super) fn add(&mut self, value: Real<A>, terms: Real<A>) {
        self.value = self.value + value;
        self.terms = self.terms + terms;
    }

    /// The sum; NaN if its terms cancel to their last digits.
    #[inline(always)]
    pub(super) fn resolved(self) -> Real<A> {
        /// The smallest accepted ratio to the magnitudes of the terms, in roundings.
        const LEAST: f64 = 1e4;
        let least = self.terms * Real::splat(LEAST * A::ROUNDING);
        self.value
            .where_less(least, Real::splat(f64::NAN), self.value)
    }
}

/// `(first - last) / z` with `last = first exp(-z l)`, also near z = 0.
fn mean_difference<A: Arithmetic>(
    z: Complex<A>,
    length: f64,
    first: Complex<A>,
    last: Complex<A>,
) -> Complex<A> {
    A::outlined(MeanDifference((z, length, first, last)))
}

#[inline(always)]
fn mean_difference_inlined<A: Arithmetic>(
    (z, length, first, last): (Complex<A>, f64, Complex<A>, Complex<A>),
) -> Complex<A> {
    const SERIES_BELOW: f64 = 0.5;
    let limit = Real::splat(SERIES_BELOW * SERIES_BELOW / (length * length));
    let size = z.norm_sqr();
    let direct = (first - last) * z.inverse();
    if !size.is_less_somewhere(limit) {
        return direct;
    }
    let along = z.scaled(Real::splat(length));
    // 1 - z/2 (1 - z/3 (1 - ...)).
    let mut sum = Complex::ONE;
    for k in (2..=A::TERMS).rev() {
        let part = along.scaled(Real::inverse_of(k));
        sum = Complex::ONE.minus_product(sum, part);
    }
    let series = first * sum.scaled(Real::splat(length));
    Complex::where_less(size, limit, series, direct)
}

part!(
    NewForm ['a, A: Arithmetic, const ALL: bool] ['a, A, ALL]
    (&'a Waves<A>, [&'a Weights<A>; 2], f64, &'a Amplitudes<A>) -> Form<A>,
    Form::new_inlined::<ALL>
);

part!(
    Of ['a, A: Arithmetic, const ALL: bool] ['a, A, ALL]
    (&'a Form<A>, &'a Amplitudes<A>, &'a Amplitudes<A>, &'a mut Sum<A>) -> (),
    Form::of_inlined::<ALL>
);

part!(
    MeanDifference [A: Arithmetic] [A]
    (Complex<A>, f64, Complex<A>, Complex<A>) -> Complex<A>,
    mean_difference_inlined
);

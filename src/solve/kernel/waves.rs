//! The six waves of the beam at several frequencies at once; the equations are those of [`crate::solve::waves`].
//!
//! The radiation of a point load follows from reciprocity, without a system to solve: a jump f of the internal forces
//! sends `X f` in both directions and a jump m of the internal moments `Y m` to the right and `-Y m` to the left with
//! `X = N Q^T`, `Y = N S^T`, where the diagonal N holds `1 / (2 kappa (2 E Iy h W^2 + (2 E G0 h - G J) Psi^2))` of the
//! coupled waves and `1 / (4 E Iz h kappa)` of the others, h = kappa^2. It is the same for Q, S, P, M of any scale.

use num_complex::Complex64;

use super::complex::{Complex, Matrix};
use super::double_double::DoubleDouble;
use super::general_waves::GeneralConstants;
use super::number::{Arithmetic, Real, part};
use super::roots::{Pair, Root, roots};
use crate::model::Point;
use crate::solve::waves::{BeamConstants, WARPING_WAVE, coupled_roots};

/// The frequency-independent constants of the waves of a beam.
///
/// What follows from other numbers has twice their digits: at low frequencies any difference between two roundings of one
/// quantity is amplified.
#[derive(Debug, Clone)]
pub(super) struct Constants {
    beam: BeamConstants,
    /// sqrt(rho A / E Iy), sqrt(rho A / E Iz).
    bending: [Complex<DoubleDouble>; 2],
    /// 1 / E `I_y`.
    inverse_bending: Complex<DoubleDouble>,
    /// 1 / (E `Gamma_0`); 0 if `Gamma_0` is 0.
    inverse_warping: Complex<DoubleDouble>,
    /// 1 / rho A, 1 / rho `I_0`.
    inverse_inertia: [Real<DoubleDouble>; 2],
    /// For a beam that is not the paper's.
    general: Option<Box<GeneralConstants>>,
}

impl Constants {
    pub(super) fn new(beam: &BeamConstants) -> Self {
        let inverse = |stiffness: Complex64| Complex::splat(stiffness).inverse();
        let mass = Real::splat(beam.mass);
        let bending = [beam.bending_w, beam.bending_v];
        Self {
            beam: beam.clone(),
            bending: bending.map(|stiffness| inverse(stiffness).scaled(mass).sqrt()),
            inverse_bending: inverse(beam.bending_w),
            inverse_warping: if beam.without_warping() {
                Complex::ZERO
            } else {
                inverse(beam.warping)
            },
            inverse_inertia: [beam.mass, beam.polar].map(|of| Real::ONE / Real::splat(of)),
            general: beam
                .is_general
                .then(|| Box::new(GeneralConstants::new(&beam.own, beam.offset))),
        }
    }
}

/// The waves at several frequencies.
#[derive(Debug, Clone)]
pub(super) struct Waves<A> {
    /// Angular frequency, rad/s.
    pub(super) omega: Complex<A>,
    /// Wave numbers, 1/m; that of the warping wave is meaningless if `without_warping`.
    pub(super) kappa: [Complex<A>; 6],
    /// Q.
    pub(super) displacement: Matrix<A, 3, 6>,
    /// S.
    pub(super) slope: Matrix<A, 3, 6>,
    /// P.
    pub(super) force: Matrix<A, 3, 6>,
    /// M.
    pub(super) moment: Matrix<A, 3, 6>,
    /// N: the amplitude of each wave per unit of its jump.
    pub(super) radiation: [Complex<A>; 6],
    /// N^-1.
    pub(super) weight: [Complex<A>; 6],
    /// The warping wave decays at once.
    pub(super) without_warping: bool,
    /// Each wave may move w, psi and v; otherwise the first four waves move w and psi, and the others v.
    pub(super) all_coupled: bool,
}

/// A beam and the angular frequencies, rad/s.
type At<'a, A> = (&'a Constants, Complex<A>);

/// A coupled wave: h = kappa^2 and its shape.
#[derive(Debug, Clone, Copy)]
struct CoupledWave<A> {
    h: Complex<A>,
    w: Complex<A>,
    psi: Complex<A>,
}

impl<A: Arithmetic> CoupledWave<A> {
    const NONE: Self = Self {
        h: Complex::ZERO,
        w: Complex::ZERO,
        psi: Complex::ZERO,
    };

    /// Becomes the wave of a root of a pair; the sign of a travelling wave's h is omitted.
    #[inline(always)]
    fn set_shape(
        (this, (constants, omega), pair, root): (&mut Self, At<'_, A>, &Pair<A>, &Root<A>),
    ) {
        let beam = &constants.beam;
        let other = pair.offset.plus_product(pair.slope, root.value);
        let bending = Complex::splat(beam.bending_w) * root.from_bending * (root.value + pair.h_w);
        let torsion = root.from_torsion * other;
        *this = Self::new((constants, omega), root.value, [bending, torsion]);
    }

    /// With the residuals of the two equations of motion, bending and torsion, without coupling.
    #[inline(always)]
    fn new(
        (constants, omega): At<'_, A>,
        h: Complex<A>,
        [bending, torsion]: [Complex<A>; 2],
    ) -> Self {
        let beam = &constants.beam;
        let inverse = (omega * omega).inverse();
        let [by_mass, by_polar] = constants.inverse_inertia.map(Real::of);
        let coupling = Real::splat(beam.coupling);
        let (w, psi) = shape(
            bending * inverse.scaled(by_mass),
            torsion * inverse.scaled(by_polar),
            coupling * by_mass,
            coupling * by_polar,
        );
        let radius = Real::splat(beam.radius * beam.radius);
        let scale = Real::ONE / psi.norm_sqr().multiply_add(radius, w.norm_sqr()).sqrt();
        Self {
            h,
            w: w.scaled(scale),
            psi: psi.scaled(scale),
        }
    }

    /// From a root that has the digits of a double, by Newton's steps on `(E Iy h^2 - a)(E G0 h^2 - G J h - b) = d^2`
    /// ([`coupled_roots`]), which double them.
    #[inline(always)]
    fn near(constants: &Constants, omega: Complex<A>, mut h: Complex<A>) -> Self {
        const STEPS: usize = 2;
        let beam = &constants.beam;
        let stiffnesses = [beam.bending_w, beam.warping, beam.torsion];
        let [of_w, warping, torsion] = stiffnesses.map(Complex::splat);
        let square = omega * omega;
        let inertias = [beam.mass, beam.polar, beam.coupling];
        let [a, b, d] = inertias.map(|inertia| square.scaled(Real::splat(inertia)));
        for _ in 0..STEPS {
            let (bent, warped) = (of_w * h, warping * h);
            let residuals = [bent * h - a, (warped - torsion) * h - b];
            let value = (residuals[0] * residuals[1]).minus_product(d, d);
            let slope = (bent + bent) * residuals[1];
            let slope = slope.plus_product(residuals[0], warped + warped - torsion);
            // Two roots may coincide.
            let step = value * slope.inverse();
            h = h - Complex::where_less(Real::ZERO, slope.norm_sqr(), step, Complex::ZERO);
        }
        let residuals = [of_w * h * h - a, (warping * h - torsion) * h - b];
        Self::new((constants, omega), h, residuals)
    }
}

/// Finds the coupled waves one frequency at a time if the solution for all lanes failed.
#[inline(always)]
fn recover<A: Arithmetic>(
    (waves, constants, omega, missed): (&mut [CoupledWave<A>; 4], &Constants, Complex<A>, Real<A>),
) {
    let lanes = missed.lanes();
    let mut roots = waves.map(|wave| wave.h);
    for lane in (0..A::LANES).filter(|&lane| lanes[lane] > 0.0) {
        let found = coupled_roots(&constants.beam, omega.lane(lane));
        for (root, found) in roots.iter_mut().zip(found) {
            root.set_lane(lane, found);
        }
    }
    for (wave, root) in waves.iter_mut().zip(roots) {
        let found = CoupledWave::near(constants, omega, root);
        *wave = CoupledWave {
            h: Complex::where_less(Real::ZERO, missed, found.h, wave.h),
            w: Complex::where_less(Real::ZERO, missed, found.w, wave.w),
            psi: Complex::where_less(Real::ZERO, missed, found.psi, wave.psi),
        };
    }
}

impl<A: Arithmetic> Waves<A> {
    /// No waves yet; entries that a row cannot reach stay zero.
    pub(super) const NONE: Self = Self {
        omega: Complex::ZERO,
        kappa: [Complex::ZERO; 6],
        displacement: [[Complex::ZERO; 6]; 3],
        slope: [[Complex::ZERO; 6]; 3],
        force: [[Complex::ZERO; 6]; 3],
        moment: [[Complex::ZERO; 6]; 3],
        radiation: [Complex::ZERO; 6],
        weight: [Complex::ZERO; 6],
        without_warping: false,
        all_coupled: false,
    };

    /// Becomes the waves at angular frequencies, rad/s.
    pub(super) fn set(&mut self, constants: &Constants, omega: Complex<A>) {
        A::outlined(Set((self, constants, omega)));
    }

    #[inline(always)]
    fn set_inlined((this, constants, omega): (&mut Self, &Constants, Complex<A>)) {
        this.omega = omega;
        this.without_warping = constants.beam.without_warping();
        this.all_coupled = constants.beam.all_coupled;
        if let Some(general) = &constants.general {
            this.set_general(general);
        } else {
            if this.all_coupled {
                this.clear();
            }
            this.set_coupled(constants);
            this.set_bending_v(constants);
        }
        if this.without_warping {
            this.set_warping_limit();
        }
        if constants.beam.offset != Point::AXIS {
            this.move_to_axis(constants.beam.offset);
        }
    }

    /// Without the shapes of the last frequencies.
    fn clear(&mut self) {
        let none = [[Complex::ZERO; 6]; 3];
        for rows in [
            &mut self.displacement,
            &mut self.slope,
            &mut self.force,
            &mut self.moment,
        ] {
            *rows = none;
        }
    }

    /// From the shear centres, which lie at an offset, to the axis: displacements of the axis, forces that do the same work.
    #[inline(always)]
    fn move_to_axis(&mut self, offset: Point) {
        let [y, z] = [offset.y, offset.z].map(Real::splat);
        for rows in [&mut self.displacement, &mut self.slope] {
            let [w, psi, v] = rows;
            for wave in 0..6 {
                w[wave] = w[wave].plus_scaled(-z, psi[wave]);
                v[wave] = v[wave].plus_scaled(y, psi[wave]);
            }
        }
        for rows in [&mut self.force, &mut self.moment] {
            let [w, psi, v] = rows;
            for wave in 0..6 {
                psi[wave] = psi[wave].plus_scaled(z, w[wave]).plus_scaled(-y, v[wave]);
            }
        }
    }

    /// The four coupled waves: two evanescent, two travelling.
    #[inline(always)]
    fn set_coupled(&mut self, constants: &Constants) {
        let beam = &constants.beam;
        let square = self.omega * self.omega;
        let (b, d) = (
            square.scaled(Real::splat(beam.polar)),
            square.scaled(Real::splat(beam.coupling)),
        );
        let h_w = (Complex::of(constants.bending[0]) * self.omega).in_right_half();
        let warping = Complex::splat(beam.warping);
        let torsion = Complex::splat(beam.torsion);
        let half = Real::splat(0.5);
        let discriminant = torsion * torsion + warping * b.scaled(Real::splat(4.0));
        let tau = (torsion + discriminant.sqrt()).scaled(half);
        let t = tau.inverse() * b;
        let coupling = Complex::of(constants.inverse_bending) * (d * d);
        let evanescent = Pair {
            h_w,
            tau,
            gamma: warping,
            inverse_gamma: Complex::of(constants.inverse_warping),
            coupling,
            slope: Complex::ONE,
            offset: t,
        };
        let travelling = Pair {
            tau: t,
            gamma: Complex::ONE,
            inverse_gamma: Complex::ONE,
            slope: warping,
            offset: tau,
            ..evanescent
        };
        let pairs = [evanescent, travelling];
        let (roots, missed) = roots(&pairs);
        let mut waves = [CoupledWave::NONE; 4];
        for (column, wave) in waves.iter_mut().enumerate() {
            let pair = column / 2;
            let root = &roots[pair][column % 2];
            A::outlined(SetShape((
                wave,
                (constants, self.omega),
                &pairs[pair],
                root,
            )));
            if pair == 1 {
                wave.h = -wave.h;
            }
        }
        if Real::ZERO.is_less_somewhere(missed) {
            A::outlined(Recover((&mut waves, constants, self.omega, missed)));
        }
        for (column, wave) in waves.iter().enumerate() {
            A::outlined(SetRows((self, beam, column, wave)));
        }
    }

    /// Sets the columns of the matrices of a coupled wave.
    #[inline(always)]
    fn set_rows((this, beam, column, wave): (&mut Self, &BeamConstants, usize, &CoupledWave<A>)) {
        let CoupledWave { h, w, psi } = *wave;
        let kappa = h.sqrt();
        let bending_moment = Complex::splat(beam.bending_w) * h * w;
        let warping = Complex::splat(beam.warping) * h;
        let bimoment = warping * psi;
        let torque_over_kappa = this.torque_over_kappa(beam, *wave, warping);
        this.kappa[column] = kappa;
        this.displacement[0][column] = w;
        this.displacement[1][column] = psi;
        this.slope[0][column] = kappa * w;
        this.slope[1][column] = kappa * psi;
        this.force[0][column] = kappa * bending_moment;
        this.force[1][column] = kappa * torque_over_kappa;
        this.moment[0][column] = bending_moment;
        this.moment[1][column] = bimoment;
        let norm = (this.force[0][column] * w)
            .plus_product(this.force[1][column], psi)
            .plus_product(bending_moment, this.slope[0][column])
            .plus_product(bimoment, this.slope[1][column]);
        this.set_weight(column, norm + norm);
    }

    /// (E `Gamma_0` h - G J) Psi, from the equation of motion if the difference would cancel.
    #[inline(always)]
    fn torque_over_kappa(
        &self,
        beam: &BeamConstants,
        wave: CoupledWave<A>,
        warping: Complex<A>,
    ) -> Complex<A> {
        let CoupledWave { h, w, psi } = wave;
        let difference = warping - Complex::splat(beam.torsion);
        let inertia = psi
            .scaled(Real::splat(beam.polar))
            .plus_scaled(Real::splat(beam.coupling), w);
        let by_motion = inertia * (self.omega * self.omega) * h.inverse();
        Complex::where_less(
            Real::splat(0.25 * beam.torsion.norm_sqr()),
            difference.norm_sqr(),
            difference * psi,
            by_motion,
        )
    }

    /// The limit `Gamma_0` -> 0: the warping wave changes the rate of twist by one unit within the length 0.
    #[inline(always)]
    fn set_warping_limit(&mut self) {
        for row in 0..3 {
            self.displacement[row][WARPING_WAVE] = Complex::ZERO;
            self.slope[row][WARPING_WAVE] = Complex::ZERO;
            self.force[row][WARPING_WAVE] = Complex::ZERO;
            self.moment[row][WARPING_WAVE] = Complex::ZERO;
        }
        self.kappa[WARPING_WAVE] = Complex::ZERO;
        self.slope[1][WARPING_WAVE] = Complex::ONE;
        self.moment[1] = [Complex::ZERO; 6];
        self.moment[1][WARPING_WAVE] = Complex::ONE;
        self.set_weight(WARPING_WAVE, Complex::from_real(Real::splat(2.0)));
    }

    #[inline(always)]
    fn set_bending_v(&mut self, constants: &Constants) {
        let h = (Complex::of(constants.bending[1]) * self.omega).in_right_half();
        let evanescent = h.sqrt();
        // The root of -h, decaying or right-going.
        let travelling = Complex {
            re: evanescent.im.abs(),
            im: Real::ZERO.where_less(evanescent.im, -evanescent.re, evanescent.re),
        };
        let moment = Complex::splat(constants.beam.bending_v) * h;
        for (column, kappa, moment) in [(4, evanescent, moment), (5, travelling, -moment)] {
            self.kappa[column] = kappa;
            self.displacement[2][column] = Complex::ONE;
            self.slope[2][column] = kappa;
            self.force[2][column] = kappa * moment;
            self.moment[2][column] = moment;
            self.set_weight(column, (kappa * moment).scaled(Real::splat(4.0)));
        }
    }

    #[inline(always)]
    pub(super) fn set_weight(&mut self, column: usize, weight: Complex<A>) {
        self.weight[column] = weight;
        self.radiation[column] = weight.inverse();
    }
}

/// The shape (W, Psi) from the row with the larger coefficient; see [`crate::solve::waves`].
#[inline(always)]
fn shape<A: Arithmetic>(
    bending: Complex<A>,
    torsion: Complex<A>,
    d_over_a: Real<A>,
    d_over_b: Real<A>,
) -> (Complex<A>, Complex<A>) {
    let (of_bending, of_torsion) = (bending.norm_sqr(), torsion.norm_sqr());
    let from_a = Complex::from_real(d_over_a);
    let from_b = Complex::from_real(d_over_b);
    (
        Complex::where_less(of_bending, of_torsion, torsion, from_a),
        Complex::where_less(of_bending, of_torsion, from_b, bending),
    )
}

part!(
    Set ['a, A: Arithmetic] ['a, A]
    (&'a mut Waves<A>, &'a Constants, Complex<A>) -> (),
    Waves::set_inlined
);

part!(
    SetShape ['a, A: Arithmetic] ['a, A]
    (&'a mut CoupledWave<A>, At<'a, A>, &'a Pair<A>, &'a Root<A>) -> (),
    CoupledWave::set_shape
);

part!(
    SetRows ['a, A: Arithmetic] ['a, A]
    (&'a mut Waves<A>, &'a BeamConstants, usize, &'a CoupledWave<A>) -> (),
    Waves::set_rows
);

part!(
    Recover ['a, A: Arithmetic] ['a, A]
    (&'a mut [CoupledWave<A>; 4], &'a Constants, Complex<A>, Real<A>) -> (),
    recover
);

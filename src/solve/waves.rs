//! The six waves of the beam at one frequency: wave numbers, shapes, internal forces, and what a point load radiates.
//!
//! A wave going right is `exp(-kappa x)` with Re kappa > 0, or Re kappa = 0 and Im kappa > 0. With amplitudes a
//! (right-going) and b (left-going) at a point, displacements are `Q (a + b)`, slopes `-S (a - b)`, internal forces
//! `P (a - b)` and internal moments `M (a + b)`; the rows of these 3x6 matrices are (w, psi, v).

use num_complex::Complex64;

use super::linear::{Matrix, ZERO, size, solve, zeros};
use crate::model::Beam;

/// Index of the wave that carries the warping of the section; with `Gamma_0` = 0 it decays over no length.
pub(super) const WARPING_WAVE: usize = 0;

/// The columns of the waves that carry w and psi; the other two carry v.
const COUPLED: usize = 4;

/// What the solver needs to know of a beam, as complex stiffnesses and masses per length.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BeamConstants {
    /// E `I_y` (1 + i eta), N m2.
    pub(super) bending_w: Complex64,
    /// E `I_z` (1 + i eta), N m2.
    pub(super) bending_v: Complex64,
    /// E `Gamma_0` (1 + i eta), N m4.
    pub(super) warping: Complex64,
    /// G J (1 + i eta), N m2.
    pub(super) torsion: Complex64,
    /// Mass per length rho A, kg/m.
    pub(super) mass: f64,
    /// Polar mass moment per length rho `I_0`, kg m.
    pub(super) polar: f64,
    /// rho A `z_c`, kg.
    pub(super) coupling: f64,
    /// Radius of gyration about the shear centre, m: weighs twist against displacement.
    pub(super) radius: f64,
}

impl BeamConstants {
    /// Stiffness times (1 + i eta), inertia per length.
    pub(super) fn new(beam: &Beam) -> Self {
        let (material, section) = (&beam.material, &beam.section);
        let loss = Complex64::new(1.0, material.loss_factor);
        let mass = material.density * section.area;
        Self {
            bending_w: loss * material.young_modulus * section.second_moment_y,
            bending_v: loss * material.young_modulus * section.second_moment_z,
            warping: loss * material.young_modulus * section.warping_constant,
            torsion: loss * material.shear_modulus * section.torsion_constant,
            mass,
            polar: material.density * section.polar_moment,
            coupling: mass * section.centroid_offset,
            radius: (section.polar_moment / section.area).sqrt(),
        }
    }

    /// True where `Gamma_0` = 0: the section resists no rate of twist.
    pub(super) fn without_warping(&self) -> bool {
        self.warping == ZERO
    }
}

/// The waves at one frequency.
#[derive(Debug, Clone)]
pub(super) struct Waves {
    /// Wave numbers, 1/m; the warping wave's real part is infinite where `Gamma_0` = 0.
    pub(super) kappa: [Complex64; 6],
    /// Q: displacements.
    pub(super) displacement: Matrix<3, 6>,
    /// S = Q diag(kappa): slopes, up to the sign.
    pub(super) slope: Matrix<3, 6>,
    /// P: internal forces (`S_w`, T, `S_v`).
    pub(super) force: Matrix<3, 6>,
    /// M: internal moments (`M_w`, B, `M_v`). Where `Gamma_0` = 0 the row of B is the warping wave alone.
    pub(super) moment: Matrix<3, 6>,
    /// X: amplitudes that a unit jump of each internal force sends both ways.
    pub(super) from_force: Matrix<6, 3>,
    /// Y: amplitudes that a unit jump of each internal moment sends right; left it sends -Y.
    pub(super) from_moment: Matrix<6, 3>,
}

/// One of the four coupled waves: h = kappa^2 and its shape.
#[derive(Debug, Clone, Copy)]
pub(super) struct CoupledWave {
    pub(super) h: Complex64,
    pub(super) w: Complex64,
    pub(super) psi: Complex64,
}

impl Waves {
    /// The waves at the angular frequency `omega`, rad/s: positive, or complex where a mode or a zero is sought.
    ///
    /// Source: Chen & Liu, Mathematics 2022, 10(16), 2849, Eqs. 19 to 24, with the shape taken from whichever row of
    /// the state equation does not divide by `z_c`.
    pub(super) fn new(beam: &BeamConstants, omega: Complex64) -> Self {
        let mut waves = Self {
            kappa: [ZERO; 6],
            displacement: zeros(),
            slope: zeros(),
            force: zeros(),
            moment: zeros(),
            from_force: zeros(),
            from_moment: zeros(),
        };
        for (column, wave) in coupled_waves(beam, omega).into_iter().enumerate() {
            waves.set_coupled(beam, omega, column, wave);
        }
        if beam.without_warping() {
            waves.set_warping_limit();
        }
        waves.set_bending_v(beam, omega);
        waves.set_radiation();
        waves
    }

    /// True where `Gamma_0` = 0: the warping wave decays over no length.
    pub(super) fn without_warping(&self) -> bool {
        self.kappa[WARPING_WAVE].re.is_infinite()
    }

    fn set_coupled(
        &mut self,
        beam: &BeamConstants,
        omega: Complex64,
        column: usize,
        wave: CoupledWave,
    ) {
        let CoupledWave { h, w, psi } = wave;
        let kappa = decaying_root(h);
        self.kappa[column] = kappa;
        self.displacement[0][column] = w;
        self.displacement[1][column] = psi;
        self.slope[0][column] = kappa * w;
        self.slope[1][column] = kappa * psi;
        self.force[0][column] = beam.bending_w * h * kappa * w;
        self.force[1][column] = kappa * torque_over_kappa(beam, omega, wave);
        self.moment[0][column] = beam.bending_w * h * w;
        self.moment[1][column] = beam.warping * h * psi;
    }

    /// The limit `Gamma_0` -> 0: the warping wave turns the rate of twist by one unit at no length, no force and no
    /// displacement; the bimoment vanishes like sqrt(E `Gamma_0` G J), so its row, scaled by that, is this wave alone.
    fn set_warping_limit(&mut self) {
        self.kappa[WARPING_WAVE] = Complex64::new(f64::INFINITY, 0.0);
        for row in 0..3 {
            self.displacement[row][WARPING_WAVE] = ZERO;
            self.slope[row][WARPING_WAVE] = ZERO;
            self.force[row][WARPING_WAVE] = ZERO;
            self.moment[row][WARPING_WAVE] = ZERO;
        }
        self.slope[1][WARPING_WAVE] = Complex64::ONE;
        self.moment[1] = [ZERO; 6];
        self.moment[1][WARPING_WAVE] = Complex64::ONE;
    }

    fn set_bending_v(&mut self, beam: &BeamConstants, omega: Complex64) {
        let h = (omega * omega * beam.mass / beam.bending_v).sqrt();
        for (column, h) in [(COUPLED, h), (COUPLED + 1, -h)] {
            let kappa = decaying_root(h);
            self.kappa[column] = kappa;
            self.displacement[2][column] = Complex64::ONE;
            self.slope[2][column] = kappa;
            self.force[2][column] = beam.bending_v * h * kappa;
            self.moment[2][column] = beam.bending_v * h;
        }
    }

    /// X = 1/2 [S; P]^-1 [0; I] and Y = 1/2 [Q; M]^-1 [0; I], in their blocks (w, psi) and v.
    fn set_radiation(&mut self) {
        self.from_force = radiation(&self.slope, &self.force);
        self.from_moment = radiation(&self.displacement, &self.moment);
    }
}

/// 1/2 [still; jump]^-1 [0; I]: what leaves a point where `still` stays and `jump` jumps.
fn radiation(still: &Matrix<3, 6>, jump: &Matrix<3, 6>) -> Matrix<6, 3> {
    let half = Complex64::new(0.5, 0.0);
    let mut coupled = zeros::<4, 4>();
    for (row, source) in [&still[0], &still[1], &jump[0], &jump[1]]
        .into_iter()
        .enumerate()
    {
        coupled[row].copy_from_slice(&source[..COUPLED]);
    }
    let load = [[ZERO, ZERO], [ZERO, ZERO], [half, ZERO], [ZERO, half]];
    let bending = [[still[2][4], still[2][5]], [jump[2][4], jump[2][5]]];
    let mut out = zeros::<6, 3>();
    for (row, x) in solve(coupled, load).into_iter().enumerate() {
        out[row][..2].copy_from_slice(&x);
    }
    for (row, x) in solve(bending, [[ZERO], [half]]).into_iter().enumerate() {
        out[COUPLED + row][2] = x[0];
    }
    out
}

/// The square root of h with Re > 0, or Re = 0 and Im > 0.
fn decaying_root(h: Complex64) -> Complex64 {
    if h.im == 0.0 {
        // A zero of either sign must not choose the branch.
        return if h.re >= 0.0 {
            Complex64::new(h.re.sqrt(), 0.0)
        } else {
            Complex64::new(0.0, (-h.re).sqrt())
        };
    }
    h.sqrt()
}

/// (E `Gamma_0` h - G J) Psi of a wave, by the equation of motion where the difference would cancel.
fn torque_over_kappa(beam: &BeamConstants, omega: Complex64, wave: CoupledWave) -> Complex64 {
    let warping = beam.warping * wave.h;
    let difference = warping - beam.torsion;
    if difference.norm_sqr() > 0.25 * beam.torsion.norm_sqr() {
        return difference * wave.psi;
    }
    (beam.polar * wave.psi + beam.coupling * wave.w) * (omega * omega) / wave.h
}

/// The four roots `h = kappa^2` of the state equation and their shapes: two evanescent, two travelling.
///
/// The equation is `(E Iy h^2 - a)(E G0 h^2 - G J h - b) = d^2` with `a = omega^2 rho A`, `b = omega^2 rho I_0` and
/// `d = omega^2 rho A z_c` (Chen & Liu 2022, Eq. 21, before it is multiplied out). With `h_w = sqrt(a / E Iy)` and
/// `E G0 h^2 - G J h - b = (E G0 h - tau)(h + t)` its roots come in two pairs near those of the uncoupled beam:
/// `(h - h_w)(E G0 h - tau) = d^2 / (E Iy (h + h_w)(h + t))`, and with `h = -x`
/// `(x - h_w)(x - t) = d^2 / (E Iy (x + h_w)(E G0 x + tau))`. Each right-hand side varies slowly: see [`pair`].
pub(super) fn coupled_waves(beam: &BeamConstants, omega: Complex64) -> [CoupledWave; 4] {
    let square = omega * omega;
    let (a, b, d) = (
        square * beam.mass,
        square * beam.polar,
        square * beam.coupling,
    );
    let h_w = (a / beam.bending_w).sqrt();
    let tau = 0.5 * (beam.torsion + (beam.torsion * beam.torsion + 4.0 * b * beam.warping).sqrt());
    let t = b / tau;
    let coupling = d * d / beam.bending_w;
    let evanescent = pair(h_w, tau, beam.warping, |h| coupling / ((h + h_w) * (h + t)));
    let travelling = pair(h_w, t, Complex64::ONE, |x| {
        coupling / ((x + h_w) * (beam.warping * x + tau))
    });
    let wave = |root: Root, sign: f64, other: Complex64| {
        let bending = beam.bending_w * root.from_bending * (root.value + h_w);
        let torsion = root.from_torsion * other;
        coupled_wave(beam, [a, b], sign * root.value, [bending, torsion])
    };
    let waves = [
        wave(evanescent[0], 1.0, evanescent[0].value + t),
        wave(evanescent[1], 1.0, evanescent[1].value + t),
        wave(
            travelling[0],
            -1.0,
            beam.warping * travelling[0].value + tau,
        ),
        wave(
            travelling[1],
            -1.0,
            beam.warping * travelling[1].value + tau,
        ),
    ];
    if beam.without_warping() || are_right(beam, [a, b, d], &waves) {
        waves
    } else {
        let starts = [tau / beam.warping, h_w, -t, -h_w];
        separated(beam, [a, b, d], starts)
    }
}

/// A wave with the residuals of its two equations of motion, bending and torsion, without coupling.
fn coupled_wave(
    beam: &BeamConstants,
    [a, b]: [Complex64; 2],
    h: Complex64,
    [bending, torsion]: [Complex64; 2],
) -> CoupledWave {
    let (w, psi) = shape(
        bending / a,
        torsion / b,
        beam.coupling / beam.mass,
        beam.coupling / beam.polar,
    );
    let norm = (w.norm_sqr() + beam.radius * beam.radius * psi.norm_sqr()).sqrt();
    CoupledWave {
        h,
        w: w / norm,
        psi: psi / norm,
    }
}

/// Whether four waves are four roots: at complex omega, where two roots of different pairs come close, both iterations
/// may end on one of them, or on none.
fn are_right(beam: &BeamConstants, [a, b, d]: [Complex64; 3], waves: &[CoupledWave; 4]) -> bool {
    const ROUNDING: f64 = 1e-13;
    const SAME: f64 = 1e-6;
    let is_root = |h: Complex64| {
        let (bending, warping, twist) = (
            beam.bending_w * h * h,
            beam.warping * h * h,
            beam.torsion * h,
        );
        let residual = (bending - a) * (warping - twist - b) - d * d;
        let terms = (size(bending) + size(a)) * (size(warping) + size(twist) + size(b));
        size(residual) <= ROUNDING * terms
    };
    (0..4).all(|index| {
        let h = waves[index].h;
        let mut others = waves[..index].iter();
        is_root(h) && others.all(|other| size(other.h - h) > SAME * size(h))
    })
}

/// All four waves at once by the simultaneous iteration of Aberth (Math. Comp. 27 (1973) 339-344) on the product form.
fn separated(
    beam: &BeamConstants,
    [a, b, d]: [Complex64; 3],
    starts: [Complex64; 4],
) -> [CoupledWave; 4] {
    const MOST_STEPS: usize = 60;
    let parts = |h: Complex64| {
        let bending = beam.bending_w * h * h - a;
        let torsion = (beam.warping * h - beam.torsion) * h - b;
        [bending, torsion]
    };
    // Starts that coincide would move together.
    let mut roots: [Complex64; 4] =
        std::array::from_fn(|index| starts[index] * Complex64::new(1.0, 1e-3 * index as f64));
    for _ in 0..MOST_STEPS {
        let mut largest = 0.0_f64;
        for index in 0..4 {
            let h = roots[index];
            let [bending, torsion] = parts(h);
            let slope = 2.0 * beam.bending_w * h * torsion
                + bending * (2.0 * beam.warping * h - beam.torsion);
            let others = (0..4).filter(|&other| other != index);
            let push: Complex64 = others.map(|other| (h - roots[other]).inv()).sum();
            let value = bending * torsion - d * d;
            let step = value / (slope - value * push);
            if step.is_finite() {
                roots[index] -= step;
                largest = largest.max(step.norm() / h.norm());
            }
        }
        if largest < 4.0 * f64::EPSILON {
            break;
        }
    }
    roots.map(|h| coupled_wave(beam, [a, b], h, parts(h)))
}

/// The shape (W, Psi) from bending W = d Psi or d W = torsion Psi, each row divided by its inertia term; the row
/// whose coefficient is larger. Without coupling the wave is bending or torsion alone.
fn shape(
    bending: Complex64,
    torsion: Complex64,
    d_over_a: f64,
    d_over_b: f64,
) -> (Complex64, Complex64) {
    if bending.norm_sqr() >= torsion.norm_sqr() {
        (d_over_a.into(), bending)
    } else {
        (torsion, d_over_b.into())
    }
}

/// A root of a pair, with its distances from the two uncoupled roots: these carry the shape without cancellation.
#[derive(Debug, Clone, Copy)]
struct Root {
    value: Complex64,
    /// value - `h_w`.
    from_bending: Complex64,
    /// gamma value - tau.
    from_torsion: Complex64,
}

/// Solves `(h - h_w)(gamma h - tau) = g(h)` for its two roots by secant steps on h -> root of the quadratic with g held:
/// the root that is torsion's without coupling first (infinite where gamma = 0), then the bending one.
fn pair(
    h_w: Complex64,
    tau: Complex64,
    gamma: Complex64,
    g: impl Fn(Complex64) -> Complex64,
) -> [Root; 2] {
    let half = 0.5 * (tau - gamma * h_w);
    let larger = |g: Complex64| larger_sum(half, gamma * g);
    let torsion = |h: Complex64| {
        let g = g(h);
        let from_bending = larger(g) / gamma;
        let from_torsion = g / from_bending;
        Root {
            value: (tau + from_torsion) / gamma,
            from_bending,
            from_torsion,
        }
    };
    let bending = |h: Complex64| {
        let g = g(h);
        let denominator = larger(g);
        let from_bending = -g / denominator;
        let from_torsion = -denominator;
        Root {
            value: h_w + from_bending,
            from_bending,
            from_torsion,
        }
    };
    let first = if gamma == ZERO {
        // The warping wave decays over no length; its shape is set by the limit.
        Root {
            value: Complex64::ONE,
            from_bending: Complex64::ONE,
            from_torsion: ZERO,
        }
    } else {
        settle(tau / gamma, torsion)
    };
    [first, settle(h_w, bending)]
}

/// Of `half + sqrt(half^2 + square)` and the difference the larger one, which never cancels. Where both vanish (equal
/// roots without coupling) any number does: it only tells the torsion wave from the bending wave.
fn larger_sum(half: Complex64, square: Complex64) -> Complex64 {
    let root = (half * half + square).sqrt();
    let sum = if (half.conj() * root).re >= 0.0 {
        half + root
    } else {
        half - root
    };
    if sum == ZERO { Complex64::ONE } else { sum }
}

/// The fixed point of `step` by secant iteration from `start`.
fn settle(start: Complex64, step: impl Fn(Complex64) -> Root) -> Root {
    const MOST_STEPS: usize = 60;
    let mut last = (start, step(start));
    let mut h = last.1.value;
    let mut root = step(h);
    for _ in 0..MOST_STEPS {
        let residual = root.value - h;
        if residual.norm() <= 2.0 * f64::EPSILON * h.norm() {
            break;
        }
        let change = residual - (last.1.value - last.0);
        let next = if change == ZERO {
            root.value
        } else {
            h - residual * (h - last.0) / change
        };
        last = (h, root);
        h = next;
        root = step(h);
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Material, Section};

    fn paper_beam(loss_factor: f64, warping_constant: f64, centroid_offset: f64) -> Beam {
        Beam {
            length: 3.2,
            material: Material {
                young_modulus: 2.1e11,
                shear_modulus: 8e10,
                density: 7850.0,
                loss_factor,
            },
            section: Section {
                area: 0.0116,
                second_moment_y: 1.6625e-4,
                second_moment_z: 1.3745e-4,
                torsion_constant: 4.7657e-7,
                warping_constant,
                polar_moment: 5.9992e-4,
                centroid_offset,
            },
        }
    }

    /// Expected: both equations of motion hold (closed form), relative to their terms.
    #[test]
    fn every_wave_satisfies_the_equations_of_motion() {
        for loss in [0.0, 0.02, 1.5] {
            for warping in [0.0, 1e-20, 2.2783e-8] {
                for offset in [0.0, 1e-9, 0.0619, -0.2] {
                    for hertz in [0.1, 10.0, 400.0, 2e4] {
                        let beam = BeamConstants::new(&paper_beam(loss, warping, offset));
                        assert_equations_hold(&beam, hertz);
                    }
                }
            }
        }
    }

    fn assert_equations_hold(beam: &BeamConstants, hertz: f64) {
        let omega = std::f64::consts::TAU * hertz;
        let square = omega * omega;
        let waves = coupled_waves(beam, omega.into());
        let first = usize::from(beam.without_warping());
        for CoupledWave { h, w, psi } in &waves[first..] {
            let terms_w = [
                beam.bending_w * h * h * w,
                -square * beam.mass * w,
                -square * beam.coupling * psi,
            ];
            let terms_psi = [
                beam.warping * h * h * psi,
                -beam.torsion * h * psi,
                -square * (beam.coupling * w),
                -square * (beam.polar * psi),
            ];
            for terms in [&terms_w[..], &terms_psi[..]] {
                let sum: Complex64 = terms.iter().sum();
                let scale: f64 = terms.iter().map(|z| z.norm()).sum();
                assert!(
                    sum.norm() <= 1e-13 * scale,
                    "{beam:?} {hertz} Hz: {sum} of {scale}, h {h} w {w} psi {psi}"
                );
            }
        }
    }

    #[test]
    fn waves_decay_or_travel_to_the_right() {
        for loss in [0.0, 0.02, 1.5] {
            let beam = BeamConstants::new(&paper_beam(loss, 2.2783e-8, 0.0619));
            for kappa in Waves::new(&beam, Complex64::from(600.0)).kappa {
                assert!(
                    kappa.re > 0.0 || (kappa.re == 0.0 && kappa.im > 0.0),
                    "{kappa}"
                );
            }
        }
    }
}

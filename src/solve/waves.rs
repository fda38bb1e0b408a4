//! The six waves of the beam at one frequency: wave numbers, shapes and internal forces.
//!
//! A wave going right is `exp(-kappa x)` with Re kappa > 0, or Re kappa = 0 and Im kappa > 0. With amplitudes a
//! (right-going) and b (left-going) at a point, displacements are `Q (a + b)`, slopes `-S (a - b)`, internal forces
//! `P (a - b)` and internal moments `M (a + b)`; the rows of these 3x6 matrices are (w, psi, v).

use num_complex::Complex64;

use super::beam_matrices::{BeamMatrices, Symmetric};
use super::linear::{Matrix, ZERO, size};
use crate::model::{Point, UniformPart};

/// Index of the warping wave; with `Gamma_0` = 0 it decays at once.
pub(super) const WARPING_WAVE: usize = 0;

/// The complex stiffnesses and masses per length of a part of the beam, along its own shear centres.
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
    /// Radius of gyration about the shear centre, m: scales twist to displacement.
    pub(super) radius: f64,
    /// All of it.
    pub(super) own: BeamMatrices,
    /// The same over the motions of the axis of the beam.
    pub(super) matrices: BeamMatrices,
    /// Where its shear centre lies, from the axis of the beam.
    pub(super) offset: Point,
    /// The numbers above are not all of it: v may be coupled, or there is rotary inertia or an axial force.
    pub(super) is_general: bool,
    /// Each wave may move w, psi and v: a part of the beam is general, or what holds it couples v with twist.
    pub(super) all_coupled: bool,
}

impl BeamConstants {
    /// Stiffness times (1 + i eta), inertia per length.
    pub(super) fn new(part: &UniformPart, all_coupled: bool) -> Self {
        let beam = &part.beam;
        let own = BeamMatrices::new(beam);
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
            is_general: !beam.is_of_one_offset(),
            all_coupled,
            matrices: own.moved(part.offset),
            own,
            offset: part.offset,
        }
    }

    /// The form of `E_V` over the motions of the axis: `rho A (W^2 + V^2) + rho I_0 Psi^2` of its own shear centre.
    pub(super) fn vibration(&self) -> Symmetric<f64> {
        let own = Symmetric {
            w: self.mass,
            psi: self.polar,
            v: self.mass,
            ..Symmetric::<f64>::ZERO
        };
        own.moved(self.offset)
    }

    /// True if `Gamma_0` = 0: the section has no warping stiffness.
    pub(super) fn without_warping(&self) -> bool {
        self.warping == ZERO
    }
}

/// The waves at one frequency.
#[derive(Debug, Clone)]
pub(super) struct Waves {
    /// Wave numbers, 1/m; the warping wave's real part is infinite if `Gamma_0` = 0.
    pub(super) kappa: [Complex64; 6],
    /// Q: displacements.
    pub(super) displacement: Matrix<3, 6>,
    /// S = Q diag(kappa): slopes, up to the sign.
    pub(super) slope: Matrix<3, 6>,
    /// P: internal forces (`S_w`, T, `S_v`).
    pub(super) force: Matrix<3, 6>,
    /// M: internal moments (`M_w`, B, `M_v`). If `Gamma_0` = 0 only the warping wave has an entry in the row of B.
    pub(super) moment: Matrix<3, 6>,
    /// Each wave may move w, psi and v; otherwise the first four move w and psi, and the others v.
    pub(super) all_coupled: bool,
}

/// Six wave amplitudes.
pub(super) type Amplitudes = [Complex64; 6];

impl Waves {
    /// True if `Gamma_0` = 0: the warping wave decays at once.
    pub(super) fn without_warping(&self) -> bool {
        self.kappa[WARPING_WAVE].re.is_infinite()
    }

    /// Columns of the waves that contribute to a row (w, psi, v) of Q, S, P or M.
    pub(super) fn of_row(&self, row: usize) -> std::ops::Range<usize> {
        match (self.all_coupled, row) {
            (true, _) => 0..6,
            (false, 2) => 4..6,
            (false, _) => 0..4,
        }
    }

    /// exp(-kappa l) over a length, m; 1 over the length 0, also for the wave that decays at once.
    pub(super) fn decay(&self, length: f64) -> Amplitudes {
        self.kappa.map(|kappa| {
            if length == 0.0 {
                Complex64::ONE
            } else if kappa.re.is_infinite() {
                ZERO
            } else {
                (-kappa * length).exp()
            }
        })
    }
}

/// The four roots `h = kappa^2` of the state equation: two evanescent, two travelling.
///
/// The equation is `(E Iy h^2 - a)(E G0 h^2 - G J h - b) = d^2` with `a = omega^2 rho A`, `b = omega^2 rho I_0` and
/// `d = omega^2 rho A z_c` (Chen & Liu 2022, Eq. 21, before it is multiplied out). With `h_w = sqrt(a / E Iy)` and
/// `E G0 h^2 - G J h - b = (E G0 h - tau)(h + t)` its roots come in two pairs near those of the uncoupled beam:
/// `(h - h_w)(E G0 h - tau) = d^2 / (E Iy (h + h_w)(h + t))`, and with `h = -x`
/// `(x - h_w)(x - t) = d^2 / (E Iy (x + h_w)(E G0 x + tau))`. Each right-hand side varies slowly: see [`pair`].
pub(super) fn coupled_roots(beam: &BeamConstants, omega: Complex64) -> [Complex64; 4] {
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
    let roots = [evanescent[0], evanescent[1], -travelling[0], -travelling[1]];
    if beam.without_warping() || are_right(beam, [a, b, d], &roots) {
        roots
    } else {
        let starts = [tau / beam.warping, h_w, -t, -h_w];
        separated(beam, [a, b, d], starts)
    }
}

/// Whether four numbers are four roots: at complex omega, where two roots of different pairs are close, both iterations
/// may converge to the same one, or to none.
fn are_right(beam: &BeamConstants, [a, b, d]: [Complex64; 3], roots: &[Complex64; 4]) -> bool {
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
        let h = roots[index];
        let mut others = roots[..index].iter();
        is_root(h) && others.all(|other| size(other - h) > SAME * size(h))
    })
}

/// All four roots together by the simultaneous iteration of Aberth (Math. Comp. 27 (1973) 339-344) on the product form.
fn separated(
    beam: &BeamConstants,
    [a, b, d]: [Complex64; 3],
    starts: [Complex64; 4],
) -> [Complex64; 4] {
    const MOST_STEPS: usize = 60;
    let parts = |h: Complex64| {
        let bending = beam.bending_w * h * h - a;
        let torsion = (beam.warping * h - beam.torsion) * h - b;
        [bending, torsion]
    };
    // Equal starting values would stay equal.
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
    roots
}

/// Solves `(h - h_w)(gamma h - tau) = g(h)` for its two roots by secant steps on h -> root of the quadratic with fixed
/// g: first the root that becomes torsion without coupling (infinite if gamma = 0), then the bending one.
fn pair(
    h_w: Complex64,
    tau: Complex64,
    gamma: Complex64,
    g: impl Fn(Complex64) -> Complex64,
) -> [Complex64; 2] {
    let half = 0.5 * (tau - gamma * h_w);
    let larger = |g: Complex64| larger_sum(half, gamma * g);
    let torsion = |h: Complex64| {
        let g = g(h);
        (tau + gamma * g / larger(g)) / gamma
    };
    let bending = |h: Complex64| {
        let g = g(h);
        h_w - g / larger(g)
    };
    let first = if gamma == ZERO {
        // The warping wave decays at once.
        Complex64::ONE
    } else {
        settle(tau / gamma, torsion)
    };
    [first, settle(h_w, bending)]
}

/// The larger one of `half + sqrt(half^2 + square)` and the difference, without cancellation. If both vanish (equal
/// roots without coupling) any number is valid: it only distinguishes the torsion wave from the bending wave.
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
fn settle(start: Complex64, step: impl Fn(Complex64) -> Complex64) -> Complex64 {
    const MOST_STEPS: usize = 60;
    let mut last = (start, step(start));
    let mut h = last.1;
    let mut root = step(h);
    for _ in 0..MOST_STEPS {
        let residual = root - h;
        if residual.norm() <= 2.0 * f64::EPSILON * h.norm() {
            break;
        }
        let change = residual - (last.1 - last.0);
        let next = if change == ZERO {
            root
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
    use crate::model::{Beam, Material, Section};

    fn constants(beam: Beam) -> BeamConstants {
        BeamConstants::new(&UniformPart::whole(beam), false)
    }

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
                ..Default::default()
            },
            ..Default::default()
        }
    }

    /// Expected: both equations of motion hold (closed form), relative to their terms.
    #[test]
    fn every_wave_satisfies_the_equations_of_motion() {
        for loss in [0.0, 0.02, 1.5] {
            for warping in [0.0, 1e-20, 2.2783e-8] {
                for offset in [0.0, 1e-9, 0.0619, -0.2] {
                    for hertz in [0.1, 10.0, 400.0, 2e4] {
                        let beam = constants(paper_beam(loss, warping, offset));
                        assert_equations_hold(&beam, hertz);
                    }
                }
            }
        }
    }

    fn assert_equations_hold(beam: &BeamConstants, hertz: f64) {
        let omega = std::f64::consts::TAU * hertz;
        let square = omega * omega;
        let waves = crate::solve::kernel::waves(beam, omega.into());
        for wave in usize::from(beam.without_warping())..4 {
            let h = waves.kappa[wave] * waves.kappa[wave];
            let [w, psi] = [0, 1].map(|row| waves.displacement[row][wave]);
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
            let beam = constants(paper_beam(loss, 2.2783e-8, 0.0619));
            for kappa in crate::solve::kernel::waves(&beam, Complex64::from(600.0)).kappa {
                assert!(
                    kappa.re > 0.0 || (kappa.re == 0.0 && kappa.im > 0.0),
                    "{kappa}"
                );
            }
        }
    }
}

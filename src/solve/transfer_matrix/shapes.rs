//! The exact shape functions of a uniform beam (Chen & Liu 2022, Eqs. 15 to 29).

use nalgebra::SMatrix;
use num_complex::Complex64;

use crate::model::Beam;

/// A 12x12 matrix over the integration constants of a segment, `c_1` to `c_12`.
pub(super) type Matrix = SMatrix<Complex64, 12, 12>;

/// A pair of shape functions: sinh and cosh of beta x if h of Eq. (21) is positive, sin and cos if it is negative (the
/// paper prints sinh and cosh for all four, but the roots 3 and 4 are imaginary).
#[derive(Debug, Clone, Copy)]
struct Pair {
    beta: Complex64,
    hyperbolic: bool,
}

impl Pair {
    /// The pair and its first three derivatives at x.
    fn at(&self, x: f64) -> [[Complex64; 2]; 4] {
        let b = self.beta;
        let z = b * x;
        let (s, c, sign) = if self.hyperbolic {
            (z.sinh(), z.cosh(), 1.0)
        } else {
            (z.sin(), z.cos(), -1.0)
        };
        [
            [s, c],
            [b * c, sign * b * s],
            [sign * b * b * s, sign * b * b * c],
            [sign * b * b * b * c, b * b * b * s],
        ]
    }
}

/// The shape functions at one frequency, and the stiffnesses that turn their derivatives into forces.
#[derive(Debug, Clone)]
pub(super) struct Shapes {
    /// Roots 1 to 4 of Eq. (21): w and psi together.
    coupled: [Pair; 4],
    /// `t_1` to `t_4`, psi per w, rad/m.
    t: [Complex64; 4],
    /// `beta_5`, rad/m: v alone.
    alone: Complex64,
    /// E `I_y`, N m2.
    pub(super) bending_y: Complex64,
    /// E `I_z`, N m2.
    pub(super) bending_z: Complex64,
    /// E `Gamma_0`, N m4.
    pub(super) warping: Complex64,
    /// G J, N m2.
    torsion: Complex64,
}

impl Shapes {
    /// The shape functions of a beam with warping stiffness and an offset of the centroid, at `omega` (rad/s).
    pub(super) fn new(beam: &Beam, omega: f64) -> Self {
        let (section, material) = (&beam.section, &beam.material);
        let loss = Complex64::new(1.0, material.loss_factor);
        let bending_y = loss * (material.young_modulus * section.second_moment_y);
        let bending_z = loss * (material.young_modulus * section.second_moment_z);
        let warping = loss * (material.young_modulus * section.warping_constant);
        let torsion = loss * (material.shear_modulus * section.torsion_constant);
        let square = omega * omega * material.density;
        // omega^2 times rho A, rho I_0 and rho A z_c.
        let (mass, polar) = (square * section.area, square * section.polar_moment);
        let coupling = mass * section.centroid_offset;
        // lambda_4 to lambda_0 of Eq. (19).
        let lambda = [
            warping * bending_y,
            -torsion * bending_y,
            -warping * mass - bending_y * polar,
            torsion * mass,
            Complex64::from(mass * polar - coupling * coupling),
        ];
        // The roots without coupling.
        let bend = (mass / bending_y).sqrt();
        let root = (torsion * torsion + 4.0 * warping * polar).sqrt();
        let twist = [
            (torsion + root) / (2.0 * warping),
            -2.0 * polar / (torsion + root),
        ];
        let mut h = quartic(&lambda, [twist[0], bend, -bend, twist[1]]);
        h.sort_by(|a, b| b.re.total_cmp(&a.re));
        Self {
            coupled: h.map(|h| {
                let hyperbolic = h.re > 0.0;
                let beta = if hyperbolic { h.sqrt() } else { (-h).sqrt() };
                Pair { beta, hyperbolic }
            }),
            // Eq. (25), with (rate)^2 = -omega^2.
            t: h.map(|h| (bending_y * h * h - mass) / coupling),
            alone: (mass / bending_z).powf(0.25),
            bending_y,
            bending_z,
            warping,
            torsion,
        }
    }

    /// W, W', W'', `S_w`, Psi, Psi', B, T, V, V', V'' and `S_v` at x in a segment (rows) per integration constant: the
    /// derivative matrices of Appendices B and D, with S = -E I W''' and T = G J Psi' - E `Gamma_0` Psi'''.
    pub(super) fn derivatives(&self, x: f64) -> Matrix {
        let mut out = Matrix::zeros();
        for (root, (pair, t)) in self.coupled.iter().zip(self.t).enumerate() {
            let d = pair.at(x);
            for side in 0..2 {
                let column = 2 * root + side;
                let [value, first, second, third] = d.map(|order| order[side]);
                let shear = -self.bending_y * third;
                let torque = (self.torsion * first - self.warping * third) * t;
                let bimoment = self.warping * second * t;
                let of = [
                    value,
                    first,
                    second,
                    shear,
                    t * value,
                    t * first,
                    bimoment,
                    torque,
                ];
                for (row, value) in of.into_iter().enumerate() {
                    out[(row, column)] = value;
                }
            }
        }
        for (hyperbolic, first_column) in [(false, 8), (true, 10)] {
            let pair = Pair {
                beta: self.alone,
                hyperbolic,
            };
            let d = pair.at(x);
            for side in 0..2 {
                for order in 0..3 {
                    out[(8 + order, first_column + side)] = d[order][side];
                }
                out[(11, first_column + side)] = -self.bending_z * d[3][side];
            }
        }
        out
    }

    /// The largest |beta|, rad/m.
    pub(super) fn largest(&self) -> f64 {
        let betas = self.coupled.iter().map(|pair| pair.beta.norm());
        betas.fold(self.alone.norm(), f64::max)
    }
}

/// The four roots of a quartic (coefficients by descending power) from starting values, by the simultaneous iteration
/// of Ehrlich (1967) and Aberth (1973).
fn quartic(coefficients: &[Complex64; 5], guesses: [Complex64; 4]) -> [Complex64; 4] {
    const MOST_STEPS: usize = 100;
    // Equal starting values would stay equal.
    let mut roots: [Complex64; 4] =
        std::array::from_fn(|i| guesses[i] * Complex64::from_polar(1.0, 0.01 * (i + 1) as f64));
    for _ in 0..MOST_STEPS {
        let mut change = 0.0_f64;
        for i in 0..4 {
            let (mut value, mut slope) = (Complex64::ZERO, Complex64::ZERO);
            for coefficient in coefficients {
                slope = slope * roots[i] + value;
                value = value * roots[i] + coefficient;
            }
            let others: Complex64 = (0..4)
                .filter(|&j| j != i)
                .map(|j| 1.0 / (roots[i] - roots[j]))
                .sum();
            let newton = value / slope;
            let step = newton / (1.0 - newton * others);
            if step.is_finite() {
                roots[i] -= step;
                change = change.max(step.norm() / roots[i].norm());
            }
        }
        if change < f64::EPSILON {
            break;
        }
    }
    roots
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: the coefficients are multiplied out from the roots, which are similar to those of a beam at a low
    /// frequency.
    #[test]
    fn roots_of_very_different_size_are_found() {
        let roots = [8.0, 0.03, -0.031, -2e-6];
        let mut coefficients = [
            Complex64::ONE,
            0.0.into(),
            0.0.into(),
            0.0.into(),
            0.0.into(),
        ];
        for root in roots {
            for power in (1..5).rev() {
                let lower = coefficients[power - 1];
                coefficients[power] -= lower * root;
            }
        }
        let guesses = [9.0, 0.031, -0.031, -1e-6].map(Complex64::from);
        for (found, root) in quartic(&coefficients, guesses).iter().zip(roots) {
            assert!((found - root).norm() < 1e-12 * root.abs(), "{found} {root}");
        }
    }

    /// Expected: the equations of motion themselves (Eqs. 15 to 17), with the fourth derivatives by beta^4.
    #[test]
    fn shape_functions_satisfy_the_equations_of_motion() {
        let model = crate::model::read(crate::presets::find("fig05a").unwrap().text)
            .unwrap()
            .into_inner();
        let omega = std::f64::consts::TAU * 120.0;
        let shapes = Shapes::new(&model.beam, omega);
        let section = &model.beam.section;
        let square = omega * omega * model.beam.material.density;
        let d = shapes.derivatives(0.7);
        for root in 0..4 {
            let beta = shapes.coupled[root].beta;
            let fourth = beta * beta * beta * beta;
            let column = 2 * root;
            let (w, psi) = (d[(0, column)], d[(4, column)]);
            let curvature = d[(6, column)] / shapes.warping;
            let inertia = square * section.area * (w + section.centroid_offset * psi);
            let bending = shapes.bending_y * fourth * w;
            assert!((bending - inertia).norm() < 1e-9 * (bending.norm() + inertia.norm()));
            let coupled = section.area * section.centroid_offset * w + section.polar_moment * psi;
            let warping = shapes.warping * fourth * psi;
            let torsion = shapes.torsion * curvature;
            let rest = (warping - torsion - square * coupled).norm();
            assert!(
                rest < 1e-9 * (warping.norm() + torsion.norm()),
                "{root}: {rest}"
            );
        }
    }
}

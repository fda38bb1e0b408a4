//! A judge of lists of damped modes that shares nothing with what finds them: the state equation of the beam by its
//! Taylor series over short lengths, six solutions kept orthonormal from the left end to the right (Godunov 1961; Conte,
//! SIAM Rev. 8 (1966) 309-321), and the argument principle on plain circles and on the whole region.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use beamtune::model::{BeamMotion, Model, Restraint, Spring, Subsystem, Support};
use num_complex::Complex64;

type State = [Complex64; 12];

/// The order of [`BeamMotion::ALL`]: w, psi, v and their slopes.
const MOTIONS: usize = 6;

/// A model laid out for the judge; everything in units near 1.
pub struct Judge<'a> {
    model: &'a Model,
    /// Sizes of a unit of each of the twelve: six motions, six forces.
    units: [f64; 12],
}

impl<'a> Judge<'a> {
    pub fn new(model: &'a Model) -> Self {
        let section = &model.beam.section;
        let turn = (section.area / section.polar_moment).sqrt();
        let length = 0.1 * model.beam.length;
        let force = model.beam.material.young_modulus * section.second_moment_y / length.powi(3);
        let q = [1.0, turn, 1.0, 1.0 / length, turn / length, 1.0 / length];
        let units = std::array::from_fn(|row| if row < 6 { q[row] } else { force / q[row - 6] });
        Self { model, units }
    }

    /// The direction of the characteristic determinant at omega, rad/s: an analytic function up to a positive factor,
    /// zero at the modes and nowhere else.
    fn direction(&self, omega: Complex64) -> Complex64 {
        let mut direction = Complex64::ONE;
        let mut basis = self.start(omega);
        let mut x = 0.0;
        let mut masses: Vec<&Subsystem> = self.model.attached().collect();
        masses.sort_by(|a, b| a.position.total_cmp(&b.position));
        for mass in masses {
            self.cross(mass.position - x, omega, &mut basis, &mut direction);
            x = mass.position;
            direction *= unit(self.attach(mass, omega, &mut basis));
        }
        self.cross(
            self.model.beam.length - x,
            omega,
            &mut basis,
            &mut direction,
        );
        let right = &self.model.supports.right;
        let rows: Vec<Vec<Complex64>> = (0..MOTIONS)
            .map(|row| {
                let (fixed, k) = restraint(right, row, omega);
                let of = |state: &State| {
                    let (q, p) = (
                        state[row] * self.units[row],
                        state[row + 6] * self.units[row + 6],
                    );
                    if fixed {
                        q / self.units[row]
                    } else {
                        (p + k * q) / self.units[row + 6]
                    }
                };
                basis.iter().map(of).collect()
            })
            .collect();
        direction * unit(determinant(rows))
    }

    /// Six independent states that the left support allows.
    fn start(&self, omega: Complex64) -> Vec<State> {
        (0..MOTIONS)
            .map(|row| {
                let mut state = [Complex64::ZERO; 12];
                let (fixed, k) = restraint(&self.model.supports.left, row, omega);
                if fixed {
                    state[row + 6] = Complex64::ONE;
                } else {
                    state[row] = Complex64::ONE;
                    state[row + 6] = k * self.units[row] / self.units[row + 6];
                }
                state
            })
            .collect()
    }

    /// d/dx of a state in SI.
    fn slope(&self, y: &State, omega: Complex64) -> State {
        let (material, section) = (&self.model.beam.material, &self.model.beam.section);
        let loss = Complex64::new(1.0, material.loss_factor);
        let (e, g) = (material.young_modulus * loss, material.shear_modulus * loss);
        let inertia = omega * omega * material.density;
        let [
            w,
            psi,
            v,
            w1,
            psi1,
            v1,
            s_w,
            torque,
            s_v,
            m_w,
            bimoment,
            m_v,
        ] = *y;
        let offset = section.centroid_offset;
        [
            w1,
            psi1,
            v1,
            m_w / (e * section.second_moment_y),
            bimoment / (e * section.warping_constant),
            m_v / (e * section.second_moment_z),
            -inertia * section.area * (w + offset * psi),
            -inertia * (section.area * offset * w + section.polar_moment * psi),
            -inertia * section.area * v,
            -s_w,
            g * section.torsion_constant * psi1 - torque,
            -s_v,
        ]
    }

    /// Carries the six states over a length in short steps, each followed by an orthonormalisation.
    fn cross(&self, length: f64, omega: Complex64, basis: &mut [State], direction: &mut Complex64) {
        const TERMS: usize = 24;
        let (material, section) = (&self.model.beam.material, &self.model.beam.section);
        let wave = |second: f64| {
            let mass = material.density * section.area;
            (omega.norm().powi(2) * mass / (material.young_modulus * second)).powf(0.25)
        };
        let twist = (material.shear_modulus * section.torsion_constant
            / (material.young_modulus * section.warping_constant))
            .sqrt();
        let twisting = (omega.norm().powi(2) * material.density * section.polar_moment
            / (material.young_modulus * section.warping_constant))
            .powf(0.25);
        let fastest = 1.5 * wave(section.second_moment_y).max(wave(section.second_moment_z))
            + twist
            + twisting;
        let steps = (length * fastest / 1.5).ceil();
        let h = length / steps;
        for _ in 0..steps as usize {
            for state in basis.iter_mut() {
                let mut term: State = std::array::from_fn(|row| state[row] * self.units[row]);
                let mut sum = term;
                for n in 1..TERMS {
                    term = self.slope(&term, omega).map(|z| z * (h / n as f64));
                    for (sum, term) in sum.iter_mut().zip(term) {
                        *sum += term;
                    }
                }
                *state = std::array::from_fn(|row| sum[row] / self.units[row]);
            }
            orthonormalise(basis);
        }
        *direction = unit(*direction);
    }

    /// Adds a mass on its springs; returns the determinant of the mass with the beam blocked.
    fn attach(&self, subsystem: &Subsystem, omega: Complex64, basis: &mut [State]) -> Complex64 {
        let k = |spring: Spring| spring.stiffness + Complex64::I * omega * spring.damping;
        let (arm_l, arm_r) = (subsystem.arm_left, subsystem.arm_right);
        let (y_u, z_b) = (subsystem.mount_y, subsystem.mount_z);
        let springs = [
            (
                k(subsystem.y_left) + k(subsystem.y_right),
                [1.0, 0.0, 0.0, -1.0, -z_b, 0.0],
            ),
            (k(subsystem.z_left), [0.0, 1.0, -arm_l, 0.0, y_u, -1.0]),
            (k(subsystem.z_right), [0.0, 1.0, arm_r, 0.0, -y_u, -1.0]),
        ];
        let mut full = [[Complex64::ZERO; 6]; 6];
        for (k, row) in springs {
            for i in 0..6 {
                for j in 0..6 {
                    full[i][j] += k * row[i] * row[j];
                }
            }
        }
        for (index, inertia) in [subsystem.mass, subsystem.mass, subsystem.inertia]
            .into_iter()
            .enumerate()
        {
            full[index][index] -= omega * omega * inertia;
        }
        let own = |i: usize, j: usize| full[i][j];
        let det = determinant(
            (0..3)
                .map(|i| (0..3).map(|j| own(i, j)).collect())
                .collect(),
        );
        for state in basis.iter_mut() {
            let q: [Complex64; 3] = std::array::from_fn(|row| state[row] * self.units[row]);
            let pull: Vec<Complex64> = (0..3)
                .map(|i| -(0..3).map(|j| full[i][3 + j] * q[j]).sum::<Complex64>())
                .collect();
            // Cramer's rule for how the mass moves.
            let moved: Vec<Complex64> = (0..3)
                .map(|column| {
                    let entry = |i: usize, j: usize| if j == column { pull[i] } else { own(i, j) };
                    determinant(
                        (0..3)
                            .map(|i| (0..3).map(|j| entry(i, j)).collect())
                            .collect(),
                    ) / det
                })
                .collect();
            for row in 0..3 {
                let force: Complex64 = (0..3)
                    .map(|j| full[3 + row][3 + j] * q[j] + full[3 + row][j] * moved[j])
                    .sum();
                state[6 + row] += force / self.units[6 + row];
            }
        }
        det
    }

    /// How often the determinant turns along a path of a parameter from 0 to 1; none where that is not certain.
    fn turns(&self, path: &dyn Fn(f64) -> Complex64, steps: usize) -> Option<f64> {
        let at = |t: f64| self.direction(path(t));
        let mut sum = 0.0;
        let mut pending: Vec<(f64, Complex64, f64, Complex64, usize)> = Vec::new();
        let places: Vec<f64> = (0..=steps).map(|k| k as f64 / steps as f64).collect();
        let values: Vec<Complex64> = places.iter().map(|&t| at(t)).collect();
        for k in 0..steps {
            pending.push((places[k], values[k], places[k + 1], values[k + 1], 0));
        }
        while let Some((from, a, to, b, depth)) = pending.pop() {
            let change = (b * a.conj()).arg();
            if change.abs() < 0.7 {
                sum += change;
                continue;
            }
            if depth > 24 {
                return None;
            }
            let middle = 0.5 * (from + to);
            let value = at(middle);
            pending.push((from, a, middle, value, depth + 1));
            pending.push((middle, value, to, b, depth + 1));
        }
        Some(sum / TAU)
    }

    /// Roots within a circle.
    pub fn in_circle(&self, centre: Complex64, radius: f64) -> Option<i64> {
        let path = |t: f64| centre + Complex64::from_polar(radius, TAU * t);
        self.turns(&path, 12).map(|turns| turns.round() as i64)
    }

    /// Roots between two radii with angles from below the real axis to `angle`.
    pub fn in_sector(&self, inner: f64, outer: f64, angle: f64, density: usize) -> Option<i64> {
        const BELOW: f64 = -0.2;
        let arc = |radius: f64, from: f64, to: f64| {
            let path = move |t: f64| Complex64::from_polar(radius, from + t * (to - from));
            self.turns(&path, 12 + density)
        };
        let ray = |angle: f64, from: f64, to: f64| {
            let path = move |t: f64| Complex64::from_polar(from * (to / from).powf(t), angle);
            self.turns(&path, 24 + 4 * density)
        };
        let sum = ray(BELOW, inner, outer)?
            + arc(outer, BELOW, angle)?
            + ray(angle, outer, inner)?
            + arc(inner, angle, BELOW)?;
        Some(sum.round() as i64)
    }

    /// Roots in the whole ring, for a model without loss factor: the left half mirrors the right one.
    pub fn in_ring(&self, inner: f64, outer: f64, density: usize) -> Option<i64> {
        let half = |radius: f64| {
            let path = move |t: f64| Complex64::from_polar(radius, PI * t - FRAC_PI_2);
            self.turns(&path, 24 + 2 * density)
        };
        Some((2.0 * (half(outer)? - half(inner)?)).round() as i64)
    }
}

fn unit(z: Complex64) -> Complex64 {
    z / z.norm()
}

/// Whether a motion is fixed, and else the stiffness against it.
fn restraint(support: &Support, row: usize, omega: Complex64) -> (bool, Complex64) {
    match support[BeamMotion::ALL[row]] {
        Restraint::Fixed => (true, Complex64::ZERO),
        Restraint::Free => (false, Complex64::ZERO),
        Restraint::Elastic(elastic) => {
            let damper = Complex64::I * omega * elastic.damping;
            (
                false,
                elastic.stiffness + damper - omega * omega * elastic.inertia,
            )
        }
    }
}

/// Gram and Schmidt, twice; the triangle that it takes out has positive numbers on its diagonal.
fn orthonormalise(basis: &mut [State]) {
    for _ in 0..2 {
        for index in 0..basis.len() {
            let (done, rest) = basis.split_at_mut(index);
            let own = &mut rest[0];
            for other in done.iter() {
                let share: Complex64 = other
                    .iter()
                    .zip(own.iter())
                    .map(|(a, b)| a.conj() * b)
                    .sum();
                for (own, other) in own.iter_mut().zip(other) {
                    *own -= share * other;
                }
            }
            let norm = own.iter().map(Complex64::norm_sqr).sum::<f64>().sqrt();
            for z in own.iter_mut() {
                *z /= norm;
            }
        }
    }
}

/// By elimination with partial pivoting.
fn determinant(mut a: Vec<Vec<Complex64>>) -> Complex64 {
    let count = a.len();
    let mut product = Complex64::ONE;
    for column in 0..count {
        let size = |row: &usize| a[*row][column].norm();
        let pivot = (column..count)
            .max_by(|i, j| size(i).total_cmp(&size(j)))
            .unwrap_or(column);
        if pivot != column {
            a.swap(pivot, column);
            product = -product;
        }
        let top = a[column].clone();
        product *= top[column];
        if product == Complex64::ZERO {
            return product;
        }
        for row in a.iter_mut().skip(column + 1) {
            let factor = row[column] / top[column];
            for k in column..count {
                row[k] -= factor * top[k];
            }
        }
    }
    product
}

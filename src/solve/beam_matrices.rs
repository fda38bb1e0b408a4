//! A beam theory as four symmetric matrices over (w, psi, v): all that the solver knows of material and section.
//!
//! With the motions q = (w, psi, v) of the shear-centre line, its slopes q' and the rotations s of the section (s = q'
//! without shear deformation)
//!
//! ```text
//! U = 1/2 int s'^T D s' + (q' - s)^T F^-1 (q' - s) + q'^T C q' + q^T K q dx,   T = 1/2 int q_t^T M q_t + s_t^T R s_t dx
//! ```
//!
//! D resists bending and warping, C resists twist and, under an axial force N along the centroids, the slopes; F is the
//! compliance in shear, K the foundation, M the mass, R the rotary inertia. A centroid at (`y_c`, `z_c`) from the shear
//! centre moves by `w + z_c psi` and `v - y_c psi`, so that M and N share one pattern. Source: Vlasov, Thin-Walled
//! Elastic Beams (1961), Chapter 5; for the paper's beam these are the energies of Chen & Liu, Mathematics 2022,
//! 10(16), 2849, Section 2.
//!
//! A span whose shear centre lies off the axis of the beam has them over the motions of the axis: its own motions are `L
//! q`, so that each matrix X becomes `L^T X L`, except F, which no offset changes, and K, which acts on the axis.

use num_complex::Complex64;

use super::linear::ZERO;
use crate::model::schema::{MaterialKey, SectionKey};
use crate::model::{Beam, Bedding, Point, Section, UniformPart};

/// A symmetric 3x3 matrix over (w, psi, v).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Symmetric<T> {
    pub(super) w: T,
    pub(super) psi: T,
    pub(super) v: T,
    pub(super) w_psi: T,
    pub(super) psi_v: T,
    pub(super) w_v: T,
}

/// The directions of an offset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Across {
    Y,
    Z,
}

/// The matrices of a beam, or their derivatives by a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BeamMatrices {
    /// D: N m2 for the slopes of w and v, N m4 for the rate of twist; with the loss factor.
    pub(super) bending: Symmetric<Complex64>,
    /// C: N for the slopes of w and v, N m2 for the rate of twist.
    pub(super) tension: Symmetric<Complex64>,
    /// F: 1/N, of w and v.
    pub(super) shear: Symmetric<Complex64>,
    /// K, per length: N/m2 for w and v, N for psi; with its loss factors.
    pub(super) foundation: [Complex64; 3],
    /// Its dampers: N s/m2, N s.
    pub(super) foundation_damping: [f64; 3],
    /// M, per length: kg/m for w and v, kg m for psi.
    pub(super) mass: Symmetric<f64>,
    /// R, per length: kg m for the slopes of w and v, kg m3 for the rate of twist.
    pub(super) rotary: Symmetric<f64>,
}

impl<T: Copy> Symmetric<T> {
    /// The rows.
    pub(super) fn rows(&self) -> [[T; 3]; 3] {
        [
            [self.w, self.w_psi, self.w_v],
            [self.w_psi, self.psi, self.psi_v],
            [self.w_v, self.psi_v, self.v],
        ]
    }

    /// The matrix of each entry's image.
    pub(super) fn map<U>(&self, of: impl Fn(T) -> U) -> Symmetric<U> {
        Symmetric {
            w: of(self.w),
            psi: of(self.psi),
            v: of(self.v),
            w_psi: of(self.w_psi),
            psi_v: of(self.psi_v),
            w_v: of(self.w_v),
        }
    }
}

impl<T: Copy + Into<Complex64>> Symmetric<T> {
    /// The product with three numbers.
    pub(super) fn times(&self, of: [Complex64; 3]) -> [Complex64; 3] {
        self.rows().map(|row| {
            let [a, b, c] = row.map(Into::into);
            a * of[0] + b * of[1] + c * of[2]
        })
    }

    /// The sum of the products of its entries and those of a matrix: `x^T (self) y` for the matrix `y x^T`.
    pub(super) fn on(&self, products: &[[Complex64; 3]; 3]) -> Complex64 {
        let rows = self.rows();
        let entry = |i: usize, j: usize| rows[i][j].into() * products[i][j];
        (0..9).map(|at| entry(at / 3, at % 3)).sum()
    }
}

impl Symmetric<Complex64> {
    const ZERO: Self = Self {
        w: ZERO,
        psi: ZERO,
        v: ZERO,
        w_psi: ZERO,
        psi_v: ZERO,
        w_v: ZERO,
    };

    /// A diagonal matrix.
    pub(super) fn diagonal([w, psi, v]: [Complex64; 3]) -> Self {
        Self {
            w,
            psi,
            v,
            ..Self::ZERO
        }
    }
}

impl<T> Symmetric<T>
where
    T: Copy + std::ops::Add<Output = T>,
    f64: std::ops::Mul<T, Output = T>,
{
    /// `L^T (self) L`: that over the motions of an axis from which the own one lies at an offset.
    pub(super) fn moved(&self, offset: Point) -> Self {
        let Point { y, z } = offset;
        if offset == Point::AXIS {
            return *self;
        }
        let w_psi = self.w_psi + z * self.w + (-y) * self.w_v;
        let psi_v = self.psi_v + z * self.w_v + (-y) * self.v;
        Self {
            psi: self.psi + z * (self.w_psi + w_psi) + (-y) * (self.psi_v + psi_v),
            w_psi,
            psi_v,
            ..*self
        }
    }

    /// The derivative of [`Self::moved`] by the offset, from the result.
    pub(super) fn by_offset(&self, along: Across) -> Self {
        let none = || 0.0 * self.w;
        let [w_psi, psi, psi_v] = match along {
            Across::Y => [-1.0 * self.w_v, -2.0 * self.psi_v, -1.0 * self.v],
            Across::Z => [1.0 * self.w, 2.0 * self.w_psi, 1.0 * self.w_v],
        };
        Self {
            w: none(),
            psi,
            v: none(),
            w_psi,
            psi_v,
            w_v: none(),
        }
    }
}

impl<T: Copy> Symmetric<T> {
    /// Times a number.
    fn scaled<U: Copy + std::ops::Mul<T>>(&self, by: U) -> Symmetric<U::Output> {
        self.map(|entry| by * entry)
    }
}

impl Symmetric<f64> {
    /// The sum of the products of all entries with those of another matrix.
    pub(super) fn paired(&self, other: &Self) -> f64 {
        let diagonal = self.w * other.w + self.psi * other.psi + self.v * other.v;
        let across = self.w_psi * other.w_psi + self.psi_v * other.psi_v + self.w_v * other.w_v;
        diagonal + 2.0 * across
    }

    /// The real part of `q q^H` for three motions: what a form of them adds up.
    pub(super) fn square([w, psi, v]: [Complex64; 3]) -> Self {
        let product = |one: Complex64, other: Complex64| (one * other.conj()).re;
        Self {
            w: w.norm_sqr(),
            psi: psi.norm_sqr(),
            v: v.norm_sqr(),
            w_psi: product(w, psi),
            psi_v: product(psi, v),
            w_v: product(w, v),
        }
    }

    /// The sum with another matrix times a factor.
    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            w: self.w + factor * other.w,
            psi: self.psi + factor * other.psi,
            v: self.v + factor * other.v,
            w_psi: self.w_psi + factor * other.w_psi,
            psi_v: self.psi_v + factor * other.psi_v,
            w_v: self.w_v + factor * other.w_v,
        }
    }

    pub(super) const ZERO: Self = Self {
        w: 0.0,
        psi: 0.0,
        v: 0.0,
        w_psi: 0.0,
        psi_v: 0.0,
        w_v: 0.0,
    };

    /// The form of motions of the centroid: `|w + z_c psi|^2 + |v - y_c psi|^2` and the rest of the polar moment.
    fn of_centroid(section: &Section) -> Self {
        Self {
            w: 1.0,
            psi: section.polar_moment / section.area,
            v: 1.0,
            w_psi: section.centroid_offset,
            psi_v: -section.centroid_offset_y,
            w_v: 0.0,
        }
    }

    /// The second moments of area, and the warping constant.
    fn of_second_moments(section: &Section) -> Self {
        Self {
            w: section.second_moment_y,
            psi: section.warping_constant,
            v: section.second_moment_z,
            w_v: section.product_moment,
            ..Self::ZERO
        }
    }
}

impl BeamMatrices {
    const ZERO: Self = Self {
        bending: Symmetric::<Complex64>::ZERO,
        tension: Symmetric::<Complex64>::ZERO,
        shear: Symmetric::<Complex64>::ZERO,
        foundation: [ZERO; 3],
        foundation_damping: [0.0; 3],
        mass: Symmetric::<f64>::ZERO,
        rotary: Symmetric::<f64>::ZERO,
    };

    /// Those of a part of a beam, over the motions of its axis.
    pub(super) fn of_part(part: &UniformPart) -> Self {
        Self::new(&part.beam).moved(part.offset)
    }

    /// Those over the motions of an axis from which the own one lies at an offset; the foundation is on that axis.
    pub(super) fn moved(&self, offset: Point) -> Self {
        Self {
            bending: self.bending.moved(offset),
            tension: self.tension.moved(offset),
            mass: self.mass.moved(offset),
            rotary: self.rotary.moved(offset),
            ..*self
        }
    }

    /// Those of a beam along its own shear centres.
    pub(super) fn new(beam: &Beam) -> Self {
        let (material, section) = (&beam.material, &beam.section);
        let loss = Complex64::new(1.0, material.loss_factor);
        let centroid = Symmetric::of_centroid(section);
        let moments = Symmetric::of_second_moments(section);
        let mut tension = centroid.scaled(Complex64::from(beam.axial_force));
        tension.psi += loss * material.shear_modulus * section.torsion_constant;
        Self {
            bending: moments.scaled(loss * material.young_modulus),
            tension,
            shear: shear(beam),
            foundation: beam.foundation.beddings().map(bedded),
            foundation_damping: beam.foundation.beddings().map(|bedding| bedding.damping),
            mass: centroid.scaled(material.density * section.area),
            rotary: rotary(beam, &moments).scaled(material.density),
        }
    }

    /// `D^-1 m`: the curvatures, 1/m and 1/m2, for internal moments; without warping stiffness that of twist is 0.
    pub(super) fn curvatures(&self, [w, psi, v]: [Complex64; 3]) -> [Complex64; 3] {
        let d = &self.bending;
        let determinant = d.w * d.v - d.w_v * d.w_v;
        let bent = |w: Complex64, v: Complex64| {
            [
                (d.v * w - d.w_v * v) / determinant,
                (d.w * v - d.w_v * w) / determinant,
            ]
        };
        let [along_w, along_v] = bent(w, v);
        if d.psi == ZERO {
            return [along_w, ZERO, along_v];
        }
        // Of twist alone, with the bending that it makes.
        let [by_w, by_v] = bent(d.w_psi, d.psi_v);
        let own = d.psi - d.w_psi * by_w - d.psi_v * by_v;
        let warping = (psi - d.w_psi * along_w - d.psi_v * along_v) / own;
        [along_w - by_w * warping, warping, along_v - by_v * warping]
    }

    /// The real parts of the principal values of the bending of w and v, N m2, in the order of w and v if they are not
    /// coupled.
    pub(super) fn principal_bending(&self) -> [f64; 2] {
        let (w, v, both) = (self.bending.w.re, self.bending.v.re, self.bending.w_v.re);
        if both == 0.0 {
            return [w, v];
        }
        let larger = 0.5 * (w + v) + (0.5 * (w - v)).hypot(both);
        // Without cancellation.
        [larger, (w * v - both * both) / larger]
    }

    /// `a^T M b + a'^T R b'` for the six motions of a point, kg/m times the units of both.
    pub(super) fn inertia(&self, a: &[Complex64; 6], b: &[Complex64; 6]) -> Complex64 {
        let form = |of: &Symmetric<f64>, first: usize| -> Complex64 {
            let moved = of.times([b[first], b[first + 1], b[first + 2]]);
            a[first..]
                .iter()
                .zip(moved)
                .map(|(a, moved)| a * moved)
                .sum()
        };
        form(&self.mass, 0) + form(&self.rotary, 3)
    }

    /// Whether the beam lies on something.
    pub(super) fn has_foundation(&self) -> bool {
        self.foundation != [ZERO; 3] || self.foundation_damping != [0.0; 3]
    }

    /// K + i omega c of the foundation.
    pub(super) fn foundation_at(&self, omega: Complex64) -> [Complex64; 3] {
        let damping = self.foundation_damping.map(|c| Complex64::I * omega * c);
        std::array::from_fn(|row| self.foundation[row] + damping[row])
    }

    /// Whether there is shear deformation.
    pub(super) fn has_shear(&self) -> bool {
        self.shear.w != ZERO || self.shear.v != ZERO
    }

    /// The shear forces g on a section, N, for internal forces and slopes q' of the axis.
    fn shear_forces(&self, forces: [Complex64; 3], slopes: [Complex64; 3]) -> [Complex64; 3] {
        let pulled = self.tension.times(slopes);
        std::array::from_fn(|row| forces[row] - pulled[row])
    }

    /// The slopes q' of the axis for rotations of the section and internal forces: `(1 + F C)^-1 (s + F f)`. Without
    /// warping stiffness the rate of twist follows from the torque.
    pub(super) fn slopes(
        &self,
        rotations: [Complex64; 3],
        forces: [Complex64; 3],
    ) -> [Complex64; 3] {
        let without_warping = self.bending.psi == ZERO;
        if !self.has_shear() && !without_warping {
            return rotations;
        }
        let (compliance, tension) = (self.shear.rows(), self.tension.rows());
        let sheared = self.shear.times(forces);
        let mut matrix = nalgebra::Matrix3::<Complex64>::identity();
        let mut right = nalgebra::Vector3::from(rotations);
        for row in 0..3 {
            if row == 1 && without_warping {
                matrix.set_row(row, &nalgebra::RowVector3::from(tension[row]));
                right[row] = forces[row];
                continue;
            }
            for column in 0..3 {
                for k in 0..3 {
                    matrix[(row, column)] += compliance[row][k] * tension[k][column];
                }
            }
            right[row] += sheared[row];
        }
        let slopes = matrix.lu().solve(&right).map(Into::into);
        slopes.unwrap_or([Complex64::new(f64::NAN, f64::NAN); 3])
    }

    /// The changes of the six internal forces along the beam, per m, for the motions and internal forces of a point: `f' = (K -
    /// omega^2 M) q` and `m' = -g - omega^2 R s`, the equations of motion.
    pub(super) fn changes(
        &self,
        omega: Complex64,
        motions: &[Complex64; 6],
        forces: &[Complex64; 6],
    ) -> [Complex64; 6] {
        let [w, psi, v, rotations @ ..] = *motions;
        let [first, second, third, ..] = *forces;
        let (q, f, square) = ([w, psi, v], [first, second, third], omega * omega);
        let g = self.shear_forces(f, self.slopes(rotations, f));
        let (bedding, inertia) = (self.foundation_at(omega), self.mass.times(q));
        let turned = self.rotary.times(rotations);
        std::array::from_fn(|row| match row {
            0..3 => bedding[row] * q[row] - square * inertia[row],
            _ => -g[row - 3] - square * turned[row - 3],
        })
    }

    /// The effect of one more metre of beam at a place with two states: `f q' + m s'` in both orders less the density of the
    /// form, which is their strain energy less their kinetic energy.
    ///
    /// `motions` are the six motions and `forces` the six internal forces of both states.
    pub(super) fn shifted(
        &self,
        omega: Complex64,
        motions: [&[Complex64; 6]; 2],
        forces: [&[Complex64; 6]; 2],
    ) -> Complex64 {
        let first = |of: &[Complex64; 6]| [of[0], of[1], of[2]];
        let last = |of: &[Complex64; 6]| [of[3], of[4], of[5]];
        let [q, other_q] = motions.map(first);
        let [s, other_s] = motions.map(last);
        let [f, other_f] = forces.map(first);
        let [m, other_m] = forces.map(last);
        let (slopes, other_slopes) = (self.slopes(s, f), self.slopes(other_s, other_f));
        let (g, other_g) = (
            self.shear_forces(f, slopes),
            self.shear_forces(other_f, other_slopes),
        );
        let bedded: Complex64 = (self.foundation_at(omega).iter().zip(q).zip(other_q))
            .map(|((k, q), other)| k * q * other)
            .sum();
        // m s' in both orders less m D^-1 m.
        dot(f, other_slopes) + dot(other_f, slopes) + dot(m, self.curvatures(other_m))
            - dot(slopes, self.tension.times(other_slopes))
            - dot(g, self.shear.times(other_g))
            - bedded
            + omega
                * omega
                * (dot(q, self.mass.times(other_q)) + dot(s, self.rotary.times(other_s)))
    }

    /// Their derivatives by the axial force.
    pub(super) fn by_axial_force(beam: &Beam) -> Self {
        Self {
            tension: Symmetric::of_centroid(&beam.section).scaled(Complex64::ONE),
            ..Self::ZERO
        }
    }

    /// Their derivatives by the offset along y or z, from them over the motions of the axis.
    pub(super) fn by_offset(&self, along: Across) -> Self {
        Self {
            bending: self.bending.by_offset(along),
            tension: self.tension.by_offset(along),
            mass: self.mass.by_offset(along),
            rotary: self.rotary.by_offset(along),
            ..Self::ZERO
        }
    }

    /// Their derivatives by a number of the material.
    pub(super) fn by_material(beam: &Beam, key: MaterialKey) -> Self {
        let (material, section) = (&beam.material, &beam.section);
        let loss = Complex64::new(1.0, material.loss_factor);
        let moments = Symmetric::of_second_moments(section);
        let twist = |by: Complex64| Symmetric {
            psi: by * section.torsion_constant,
            ..Symmetric::<Complex64>::ZERO
        };
        match key {
            MaterialKey::YoungModulus => Self {
                bending: moments.scaled(loss),
                ..Self::ZERO
            },
            MaterialKey::ShearModulus => Self {
                tension: twist(loss),
                shear: shear(beam).scaled(-1.0 / material.shear_modulus),
                ..Self::ZERO
            },
            MaterialKey::Density => Self {
                mass: Symmetric::of_centroid(section).scaled(section.area),
                rotary: rotary(beam, &moments),
                ..Self::ZERO
            },
            MaterialKey::LossFactor => Self {
                bending: moments.scaled(Complex64::I * material.young_modulus),
                tension: twist(Complex64::I * material.shear_modulus),
                shear: shear(beam).scaled(-Complex64::I / loss),
                ..Self::ZERO
            },
        }
    }

    /// Their derivatives by a number of the section.
    pub(super) fn by_section(beam: &Beam, key: SectionKey) -> Self {
        let (material, section) = (&beam.material, &beam.section);
        let loss = Complex64::new(1.0, material.loss_factor);
        let young = loss * material.young_modulus;
        let (density, force) = (material.density, beam.axial_force);
        let inertia = density * section.area;
        let of_moments = |moments: Symmetric<f64>| Self {
            bending: moments.scaled(young),
            rotary: rotary(beam, &moments).scaled(density),
            ..Self::ZERO
        };
        let of_centroid = |pattern: Symmetric<f64>| Self {
            mass: pattern.scaled(inertia),
            tension: pattern.scaled(Complex64::from(force)),
            ..Self::ZERO
        };
        let sheared = shear(beam);
        let by_shear = |shear: Symmetric<Complex64>| Self {
            shear,
            ..Self::ZERO
        };
        // An area that no theory uses may be 0.
        let by_area = |compliance: Complex64, area: f64| {
            if compliance == ZERO {
                ZERO
            } else {
                -compliance / area
            }
        };
        let zero = Symmetric::<f64>::ZERO;
        match key {
            SectionKey::Area => Self {
                mass: Symmetric {
                    psi: 0.0,
                    ..Symmetric::of_centroid(section).scaled(density)
                },
                tension: Symmetric {
                    psi: (-force * section.polar_moment / section.area.powi(2)).into(),
                    ..Symmetric::<Complex64>::ZERO
                },
                ..Self::ZERO
            },
            SectionKey::SecondMomentY => of_moments(Symmetric { w: 1.0, ..zero }),
            SectionKey::SecondMomentZ => of_moments(Symmetric { v: 1.0, ..zero }),
            SectionKey::ProductMoment => of_moments(Symmetric { w_v: 1.0, ..zero }),
            SectionKey::WarpingConstant => of_moments(Symmetric { psi: 1.0, ..zero }),
            SectionKey::TorsionConstant => Self {
                tension: Symmetric {
                    psi: loss * material.shear_modulus,
                    ..Symmetric::<Complex64>::ZERO
                },
                ..Self::ZERO
            },
            SectionKey::PolarMoment => of_centroid(Symmetric {
                psi: section.area.recip(),
                ..zero
            }),
            SectionKey::CentroidOffset => of_centroid(Symmetric { w_psi: 1.0, ..zero }),
            SectionKey::CentroidOffsetY => of_centroid(Symmetric {
                psi_v: -1.0,
                ..zero
            }),
            SectionKey::ShearAreaY => by_shear(Symmetric {
                w: by_area(sheared.w, section.shear_area_y),
                ..Symmetric::<Complex64>::ZERO
            }),
            SectionKey::ShearAreaZ => by_shear(Symmetric {
                v: by_area(sheared.v, section.shear_area_z),
                ..Symmetric::<Complex64>::ZERO
            }),
        }
    }
}

fn dot(one: [Complex64; 3], other: [Complex64; 3]) -> Complex64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// k (1 + i eta).
fn bedded(bedding: Bedding) -> Complex64 {
    bedding.stiffness * Complex64::new(1.0, bedding.loss_factor)
}

/// The compliance in shear.
fn shear(beam: &Beam) -> Symmetric<Complex64> {
    if !beam.theory.has_shear() {
        return Symmetric::<Complex64>::ZERO;
    }
    let modulus = Complex64::new(1.0, beam.material.loss_factor) * beam.material.shear_modulus;
    let areas = [beam.section.shear_area_y, beam.section.shear_area_z];
    let [w, v] = areas.map(|area| (modulus * area).inv());
    Symmetric::diagonal([w, ZERO, v])
}

/// The second moments that have rotary inertia.
fn rotary(beam: &Beam, moments: &Symmetric<f64>) -> Symmetric<f64> {
    let bends = if beam.theory.has_rotary_inertia() {
        *moments
    } else {
        Symmetric::<f64>::ZERO
    };
    Symmetric {
        psi: if beam.warping_inertia {
            moments.psi
        } else {
            0.0
        },
        ..bends
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Material, Theory};

    fn beam() -> Beam {
        Beam {
            length: 3.0,
            theory: Theory::Timoshenko,
            warping_inertia: true,
            axial_force: 2e4,
            foundation: crate::model::Foundation::default(),
            material: Material {
                young_modulus: 2e11,
                shear_modulus: 8e10,
                density: 7800.0,
                loss_factor: 0.03,
            },
            section: Section {
                area: 2e-3,
                second_moment_y: 3e-6,
                second_moment_z: 5e-6,
                torsion_constant: 2e-8,
                warping_constant: 1e-9,
                polar_moment: 1.2e-5,
                centroid_offset: 0.02,
                product_moment: 1e-6,
                centroid_offset_y: -0.03,
                shear_area_y: 1e-3,
                shear_area_z: 1.4e-3,
            },
        }
    }

    /// Closed form: every matrix is at most a quadratic function of each number but the areas, and there the curvature is
    /// 1e-8 of the difference.
    #[test]
    fn derivatives_are_those_of_the_matrices() {
        let beam = beam();
        let mut checked = 0;
        for (row, access) in crate::model::schema::SECTION.access.iter().enumerate() {
            let crate::model::schema::Access::Number(get, set) = access else {
                panic!("every row of a section is a number");
            };
            let value = get(&beam.section);
            let step = 1e-4 * value.abs();
            let at = |value: f64| {
                let mut moved = beam;
                set(&mut moved.section, value);
                BeamMatrices::new(&moved)
            };
            let (high, low) = (at(value + step), at(value - step));
            let exact = BeamMatrices::by_section(&beam, SectionKey::ALL[row]);
            let all = |of: &BeamMatrices| -> Vec<Complex64> {
                let entries = [
                    of.bending,
                    of.tension,
                    of.mass.map(Into::into),
                    of.rotary.map(Into::into),
                ];
                entries.iter().flat_map(Symmetric::rows).flatten().collect()
            };
            for ((high, low), exact) in all(&high).iter().zip(all(&low)).zip(all(&exact)) {
                let difference = (high - low) / (2.0 * step);
                let size = (high.norm() + low.norm()) / step;
                assert!(
                    (difference - exact).norm() <= 1e-7 * exact.norm() + 1e-14 * size,
                    "{row}: {difference} {exact}"
                );
                checked += usize::from(exact != ZERO);
            }
        }
        assert!(checked > 20, "{checked}");
    }
}

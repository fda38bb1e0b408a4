//! An element of the beam: its energies over the unknowns of its two nodes.
//!
//! The shapes are the exact static ones of an element without axial force and foundation: Hermite cubics for psi and,
//! without shear deformation, for w and v. With shear deformation the shear force is constant and the moment linear, so
//! that the rotations s of w and v have a quadratic part beta, `s = s_1 (1 - t) + s_2 t + 6 beta t (1 - t)`, and the shear
//! angle is `12 F D beta / h^2` (Friedman & Kosmatka, Computers & Structures 47 (1993) 473-481, for one plane): no element
//! locks. D and F are the 2x2 matrices of w and v.
//!
//! A part with an offset has the shapes for the motions of its own shear centres; then the unknowns are moved to the axis.

use nalgebra::Matrix2;

use super::hermite::{self, Cubic, SHAPES};
use crate::model::{Point, Spring, UniformPart};

/// The unknowns of an element: value and rotation at the left and the right end, of w, psi and v.
pub(super) const UNKNOWNS: usize = 12;

/// Factors of the unknowns.
pub(super) type Row = [f64; UNKNOWNS];

/// A square in the strain energy: `stiffness/2 (of . u)^2`.
#[derive(Debug, Clone, Copy)]
struct Square {
    stiffness: f64,
    of: Row,
}

/// The energies of an element of a length.
#[derive(Debug, Clone)]
pub(super) struct BeamElement {
    /// The strain energy of the material, the work of the axial force and the energy of the foundation as squares: factors
    /// of the unknowns, each with its complex stiffness.
    pub(super) stretches: Vec<(Spring, Row)>,
    /// The mass matrix.
    pub(super) inertia: [Row; UNKNOWNS],
    /// The matrix of `E_V`, the vibration energy without the coupling by an offset of the centroid.
    pub(super) vibration: [Row; UNKNOWNS],
}

/// A cubic of t = x / h for each unknown.
type Shape = [Cubic; UNKNOWNS];

/// The motions (w, psi, v) and the rotations of the section (of w and v, and the rate of twist).
struct Shapes {
    motion: [Shape; 3],
    rotation: [Shape; 3],
}

/// The two bendings, by their index among (w, psi, v).
const BENDINGS: [usize; 2] = [0, 2];

impl BeamElement {
    /// Of a part of a beam, for a length in m.
    pub(super) fn new(part: &UniformPart, h: f64) -> Self {
        let UniformPart { beam, offset, .. } = part;
        let (material, section) = (&beam.material, &beam.section);
        let (e, g, density) = (
            material.young_modulus,
            material.shear_modulus,
            material.density,
        );
        let bending = e * Matrix2::new(
            section.second_moment_y,
            section.product_moment,
            section.product_moment,
            section.second_moment_z,
        );
        let shear = if beam.theory.has_shear() {
            [section.shear_area_y, section.shear_area_z].map(|area| (g * area).recip())
        } else {
            [0.0; 2]
        };
        let compliance = Matrix2::new(shear[0], 0.0, 0.0, shear[1]);
        let shapes = Shapes::new(h, &bending, &compliance);
        let (y, z) = (section.centroid_offset_y, section.centroid_offset);
        let polar = section.polar_moment / section.area;
        let centroid = [[1.0, z, 0.0], [z, polar, -y], [0.0, -y, 1.0]];
        let own = [[1.0, 0.0, 0.0], [0.0, polar, 0.0], [0.0, 0.0, 1.0]];
        let mass = density * section.area;
        let bends = if beam.theory.has_rotary_inertia() {
            density
        } else {
            0.0
        };
        let warps = if beam.warping_inertia { density } else { 0.0 };
        let turning = [
            [
                bends * section.second_moment_y,
                0.0,
                bends * section.product_moment,
            ],
            [0.0, warps * section.warping_constant, 0.0],
            [
                bends * section.product_moment,
                0.0,
                bends * section.second_moment_z,
            ],
        ];
        let mut inertia = integral(&shapes.motion, &centroid, mass * h);
        for (row, more) in inertia
            .iter_mut()
            .zip(integral(&shapes.rotation, &turning, h))
        {
            for (entry, more) in row.iter_mut().zip(more) {
                *entry += more;
            }
        }
        let twist = [e * section.warping_constant, g * section.torsion_constant];
        let elastic = strains(h, &bending, &compliance, twist);
        let elastic = elastic.into_iter().map(|square| {
            let by = Spring {
                stiffness: square.stiffness,
                loss_factor: material.loss_factor,
                ..Spring::default()
            };
            (by, square.of)
        });
        let stretches = elastic
            .chain(axial(beam.axial_force, h, &shapes, [y, z, polar]))
            .chain(foundation(part, h, &shapes));
        Self {
            stretches: stretches.map(|(by, of)| (by, moved(of, *offset))).collect(),
            inertia: moved_matrix(&inertia, *offset),
            vibration: moved_matrix(&integral(&shapes.motion, &own, mass * h), *offset),
        }
    }
}

/// Factors of the unknowns of the axis, for factors of those of a shear centre at an offset from it, which moves by `w + z
/// psi` and `v - y psi`, and likewise turns.
fn moved(mut of: Row, offset: Point) -> Row {
    for unknown in 0..4 {
        of[4 + unknown] += offset.z * of[unknown] - offset.y * of[8 + unknown];
    }
    of
}

/// The same of both sides of a symmetric matrix.
fn moved_matrix(of: &[Row; UNKNOWNS], offset: Point) -> [Row; UNKNOWNS] {
    let columns = of.map(|row| moved(row, offset));
    let rows: [Row; UNKNOWNS] =
        std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row]));
    rows.map(|row| moved(row, offset))
}

impl Shapes {
    fn new(h: f64, bending: &Matrix2<f64>, compliance: &Matrix2<f64>) -> Self {
        let angle = compliance * bending * (12.0 / (h * h));
        let of_lag = (Matrix2::identity() + angle)
            .try_inverse()
            .unwrap_or_else(Matrix2::zeros);
        let angle = angle * of_lag;
        let mut shapes = Self {
            motion: [[[0.0; 4]; UNKNOWNS]; 3],
            rotation: [[[0.0; 4]; UNKNOWNS]; 3],
        };
        let unit = [1.0, h, 1.0, h];
        for (of, &motion) in BENDINGS.iter().enumerate() {
            let first = 4 * motion;
            // Without beta: q_1 + h (s_1 (t - t^2 / 2) + s_2 t^2 / 2), and s.
            shapes.motion[motion][first] = [1.0, 0.0, 0.0, 0.0];
            shapes.motion[motion][first + 1] = [0.0, h, -0.5 * h, 0.0];
            shapes.motion[motion][first + 3] = [0.0, 0.0, 0.5 * h, 0.0];
            shapes.rotation[motion][first + 1] = [1.0, -1.0, 0.0, 0.0];
            shapes.rotation[motion][first + 3] = [0.0, 1.0, 0.0, 0.0];
            // beta = -(1 + 12 F D / h^2)^-1 lag / h.
            for (by, &other) in BENDINGS.iter().enumerate() {
                for (unknown, lag) in LAG.iter().enumerate() {
                    let beta = -of_lag[(of, by)] * lag * unit[unknown];
                    let shear = -angle[(of, by)] * lag * unit[unknown];
                    let column = 4 * other + unknown;
                    let moved = &mut shapes.motion[motion][column];
                    moved[1] += shear;
                    moved[2] += 3.0 * beta;
                    moved[3] -= 2.0 * beta;
                    let turned = &mut shapes.rotation[motion][column];
                    turned[1] += 6.0 * beta / h;
                    turned[2] -= 6.0 * beta / h;
                }
            }
        }
        for unknown in 0..4 {
            let shape = SHAPES[unknown].map(|coefficient| coefficient * unit[unknown]);
            shapes.motion[1][4 + unknown] = shape;
            shapes.rotation[1][4 + unknown] =
                hermite::derivative(shape).map(|coefficient| coefficient / h);
        }
        shapes
    }
}

/// The lag of the rise behind the mean rotation, over (value, h rotation) at both ends.
const LAG: [f64; 4] = [1.0, 0.5, -1.0, 0.5];

/// The change of the rotation over (value, rotation) at both ends.
const TURN: [f64; 4] = [0.0, -1.0, 0.0, 1.0];

/// The strain energy as squares: of the constant and of the linear moment, with the shear that belongs to it, and of
/// twist.
fn strains(
    h: f64,
    bending: &Matrix2<f64>,
    compliance: &Matrix2<f64>,
    [warping, torsion]: [f64; 2],
) -> Vec<Square> {
    let unit = [1.0, h, 1.0, h];
    let lag: [f64; 4] = std::array::from_fn(|unknown| LAG[unknown] * unit[unknown]);
    // The moment 12 D beta / h^2 (t - 1/2) h and the shear force that makes it, per lag.
    let flexibility =
        bending.try_inverse().unwrap_or_else(Matrix2::zeros) * (h * h * h / 12.0) + compliance * h;
    let of_lag = flexibility.try_inverse().unwrap_or_else(Matrix2::zeros);
    let mut squares = Vec::new();
    for (matrix, of) in [(bending / h, TURN), (of_lag, lag)] {
        // a x^2 + 2 b x y + c y^2 = a (x + b y / a)^2 + (c - b^2 / a) y^2.
        let share = matrix[(0, 1)] / matrix[(0, 0)];
        let mut first = [0.0; UNKNOWNS];
        let mut second = [0.0; UNKNOWNS];
        for unknown in 0..4 {
            first[unknown] = of[unknown];
            first[8 + unknown] = share * of[unknown];
            second[8 + unknown] = of[unknown];
        }
        squares.push(Square {
            stiffness: matrix[(0, 0)],
            of: first,
        });
        squares.push(Square {
            stiffness: matrix[(1, 1)] - share * matrix[(0, 1)],
            of: second,
        });
    }
    for strain in hermite::strains(h, warping, torsion) {
        let mut of = [0.0; UNKNOWNS];
        of[4..8].copy_from_slice(&strain.of);
        squares.push(Square {
            stiffness: strain.stiffness,
            of,
        });
    }
    squares
}

/// The work of an axial force on the slopes of the centroids, `N/2 int (w' + z psi')^2 + (v' - y psi')^2 + r psi'^2 dx`, by
/// the three points of Gauss, which are exact for it.
fn axial(force: f64, h: f64, shapes: &Shapes, [y, z, polar]: [f64; 3]) -> Vec<(Spring, Row)> {
    /// Points on [-1, 1] and weights.
    const RULE: [(f64, f64); 3] = [
        (-0.774_596_669_241_483_4, 5.0 / 9.0),
        (0.0, 8.0 / 9.0),
        (0.774_596_669_241_483_4, 5.0 / 9.0),
    ];
    let mut squares = Vec::new();
    if force == 0.0 {
        return squares;
    }
    for (point, weight) in RULE {
        let t = 0.5 * (1.0 + point);
        let slope = |motion: usize, unknown: usize| {
            let [a, b, c, _] = hermite::derivative(shapes.motion[motion][unknown]);
            (a + t * (b + t * c)) / h
        };
        for (shares, share) in [
            ([1.0, z, 0.0], 1.0),
            ([0.0, -y, 1.0], 1.0),
            ([0.0, 1.0, 0.0], polar - y * y - z * z),
        ] {
            let by = Spring {
                stiffness: 0.5 * weight * h * force * share,
                ..Spring::default()
            };
            let of = std::array::from_fn(|unknown| {
                (0..3)
                    .map(|motion| shares[motion] * slope(motion, unknown))
                    .sum()
            });
            squares.push((by, of));
        }
    }
    squares
}

/// The squares of the motions of the axis, by the four points of Gauss, which are exact for cubics.
fn foundation(part: &UniformPart, h: f64, shapes: &Shapes) -> Vec<(Spring, Row)> {
    /// Points on [-1, 1] and weights.
    const RULE: [(f64, f64); 4] = [
        (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
        (-0.339_981_043_584_856_3, 0.652_145_154_862_546_2),
        (0.339_981_043_584_856_3, 0.652_145_154_862_546_2),
        (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    ];
    let mut squares = Vec::new();
    // The motions of the axis by those of the shear centre: its twist times an arm.
    let arms = [-part.offset.z, 0.0, part.offset.y];
    for (motion, bedding) in part.beam.foundation.beddings().into_iter().enumerate() {
        if [bedding.stiffness, bedding.damping] == [0.0; 2] {
            continue;
        }
        for (point, weight) in RULE {
            let t = 0.5 * (1.0 + point);
            let at = |[a, b, c, d]: Cubic| a + t * (b + t * (c + t * d));
            let share = 0.5 * weight * h;
            let by = Spring {
                stiffness: share * bedding.stiffness,
                damping: share * bedding.damping,
                loss_factor: bedding.loss_factor,
                ..Spring::default()
            };
            let of = std::array::from_fn(|unknown| {
                at(shapes.motion[motion][unknown]) + arms[motion] * at(shapes.motion[1][unknown])
            });
            squares.push((by, of));
        }
    }
    squares
}

/// `scale int shapes^T by shapes dt`.
fn integral(shapes: &[Shape; 3], by: &[[f64; 3]; 3], scale: f64) -> [Row; UNKNOWNS] {
    let mut out = [[0.0; UNKNOWNS]; UNKNOWNS];
    for (row, out) in out.iter_mut().enumerate() {
        for (column, out) in out.iter_mut().enumerate() {
            for i in 0..3 {
                for j in 0..3 {
                    if by[i][j] != 0.0 {
                        let of = hermite::integral(&shapes[i][row], &shapes[j][column]);
                        *out += scale * by[i][j] * of;
                    }
                }
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Closed form: the stiffness of Timoshenko's element in one plane, 12 E I / (h^3 (1 + phi)) and (4 + phi) E I / (h (1
    /// + phi)) with phi = 12 E I / (G A h^2) (Przemieniecki, Theory of Matrix Structural Analysis, 1968, Section 5.6).
    #[test]
    fn the_squares_are_timoshenkos_element() {
        let (h, stiffness, compliance) = (0.7, 3.0, 0.2);
        let squares = strains(
            h,
            &Matrix2::new(stiffness, 0.0, 0.0, 1.0),
            &Matrix2::new(compliance, 0.0, 0.0, 0.0),
            [1.0, 1.0],
        );
        let entry = |i: usize, j: usize| -> f64 {
            let terms = squares
                .iter()
                .map(|square| square.stiffness * square.of[i] * square.of[j]);
            terms.sum()
        };
        let phi = 12.0 * stiffness * compliance / (h * h);
        let unit = stiffness / (h * h * h * (1.0 + phi));
        for (i, j, expected) in [
            (0, 0, 12.0 * unit),
            (0, 2, -12.0 * unit),
            (0, 1, 6.0 * h * unit),
            (1, 1, (4.0 + phi) * h * h * unit),
            (1, 3, (2.0 - phi) * h * h * unit),
        ] {
            assert!((entry(i, j) - expected).abs() < 1e-12 * unit, "{i} {j}");
        }
    }

    /// Expected: at its ends an element moves and turns by its unknowns, whatever its shear.
    #[test]
    fn shapes_meet_their_unknowns() {
        let h = 0.4;
        let bending = Matrix2::new(2.0, 0.7, 0.7, 1.0);
        let shapes = Shapes::new(h, &bending, &Matrix2::new(0.3, 0.0, 0.0, 0.8));
        let at = |cubic: &Cubic, t: f64| cubic.iter().rev().fold(0.0, |sum, c| sum * t + c);
        for motion in 0..3 {
            for unknown in 0..UNKNOWNS {
                for (index, t) in [0.0, 1.0].into_iter().enumerate() {
                    let own = 4 * motion + 2 * index;
                    let moved = at(&shapes.motion[motion][unknown], t);
                    let turned = at(&shapes.rotation[motion][unknown], t);
                    assert!((moved - f64::from(u8::from(unknown == own))).abs() < 1e-14);
                    assert!((turned - f64::from(u8::from(unknown == own + 1))).abs() < 1e-13);
                }
            }
        }
    }

    /// Expected: without shear the consistent mass of the textbooks, 1/420 of 156, 22 h, 54, -13 h, 4 h^2, -3 h^2 (Archer
    /// 1963).
    #[test]
    fn the_mass_is_the_textbooks() {
        let h = 0.3;
        let shapes = Shapes::new(h, &Matrix2::new(2.0, 0.7, 0.7, 1.0), &Matrix2::zeros());
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mass = integral(&shapes.motion, &identity, h);
        let expected = [156.0, 22.0 * h, 54.0, -13.0 * h].map(|entry| entry * h / 420.0);
        for first in [0, 4, 8] {
            for (column, expected) in expected.iter().enumerate() {
                assert!((mass[first][first + column] - expected).abs() < 1e-14);
            }
            assert!((mass[first + 1][first + 1] - 4.0 * h.powi(3) / 420.0).abs() < 1e-14);
            assert!((mass[first + 3][first + 1] + 3.0 * h.powi(3) / 420.0).abs() < 1e-14);
        }
    }
}

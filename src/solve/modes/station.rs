//! The stations of the undamped beam: a support, a joint, the mass of a subsystem on its springs.

use nalgebra::{Matrix3, Matrix6, SymmetricEigen, Vector3, Vector6};

use super::dynamic_stiffness::symmetric;
use super::matrix_inertia::eliminate;
use super::rigid::RigidMotion;
use crate::model::{
    BeamMotion, Elastic, Joint, Model, Point, Restraint, Spring, Subsystem, Support, SupportId,
    UniformPart,
};
use crate::solve::springs::{Stretch, rows};

/// A stiffness below this fraction of the largest one is rounding.
const RESOLVED: f64 = 1e-12;

/// A support and its position.
#[derive(Debug, Clone)]
pub(super) struct Restrained {
    pub(super) position: f64,
    support: Support,
}

/// A joint: the spring between both sides of each motion that is not rigid.
#[derive(Debug, Clone)]
pub(super) struct Cut {
    pub(super) position: f64,
    springs: [Option<Spring>; 6],
}

/// The dimensionless springs between both sides of each motion that is not rigid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Links([Option<f64>; 6]);

/// The fixed motions at one position: those of the axis, but w and v at the point of the section that is held.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fixed {
    pub(super) motions: [bool; 6],
    pub(super) point: Point,
}

/// A subsystem's stiffness over (y, z, theta | w, psi, v), and its inertia.
#[derive(Debug, Clone)]
pub(super) struct Mass {
    pub(super) position: f64,
    pub(super) stiffness: Matrix6<f64>,
    pub(super) inertia: [f64; 3],
    /// The stiffness over psi while the mass follows, N m/rad.
    following: f64,
}

/// The units of the dimensionless numbers at one frequency.
#[derive(Debug, Clone, Copy)]
pub(super) struct Units {
    /// m.
    pub(super) length: f64,
    /// N/m.
    pub(super) stiffness: f64,
    /// Size of a unit of each of the six motions, in SI.
    pub(super) motion: [f64; 6],
}

impl Restrained {
    /// All supports of a model with these parts: those of the ends first.
    ///
    /// If the section there has no warping stiffness, the rate of twist is not a degree of freedom: at an end it is fixed
    /// without energy, and between them no support acts on it.
    pub(super) fn all(model: &Model, parts: &[UniformPart]) -> Vec<Self> {
        let restrained = |id: SupportId| {
            let mut support = id.support(model).clone();
            let position = id.position(model);
            if !UniformPart::at(parts, position).warps() {
                support[BeamMotion::PsiSlope] = match id {
                    SupportId::Left | SupportId::Right => Restraint::Fixed,
                    SupportId::Inner(_) => Restraint::Free,
                };
            }
            Self { position, support }
        };
        SupportId::all(model).map(restrained).collect()
    }

    pub(super) fn is_fixed(&self, motion: BeamMotion) -> bool {
        self.support[motion] == Restraint::Fixed
    }

    /// Each motion with its spring and inertia; the motions are those of the point, as combinations of those of the axis.
    pub(super) fn rows(&self) -> impl Iterator<Item = (BeamMotion, Vector6<f64>, &Elastic)> {
        BeamMotion::ALL.into_iter().map(|motion| {
            let mut row = Vector6::zeros();
            row[motion as usize] = 1.0;
            if let Some(arm) = self.support.point.arm(motion) {
                row[BeamMotion::Psi as usize] = arm;
            }
            (motion, row, self.support[motion].elastic())
        })
    }

    /// The dimensionless stiffness over the motions of the axis.
    pub(super) fn stiffness(&self, omega: f64, units: &Units) -> Matrix6<f64> {
        let scale = Vector6::from(units.motion);
        let mut sum = Matrix6::zeros();
        for (_, row, elastic) in self.rows() {
            let without_dampers = elastic.spring.stiffness - omega * omega * elastic.inertia;
            let row = row.component_mul(&scale);
            sum += without_dampers / units.stiffness * row * row.transpose();
        }
        sum
    }
}

impl Cut {
    /// All joints of a model with these parts.
    pub(super) fn all(model: &Model, parts: &[UniformPart]) -> Vec<Self> {
        let cut = |joint: &Joint| Self {
            position: joint.position,
            springs: joint.springs(!UniformPart::transmit_bimoment(parts, joint.position)),
        };
        model.joints.iter().map(cut).collect()
    }

    /// The motions that are not rigid, with their springs.
    pub(super) fn released(&self) -> impl Iterator<Item = (BeamMotion, &Spring)> {
        let motions = BeamMotion::ALL.into_iter().zip(&self.springs);
        motions.filter_map(|(motion, spring)| Some((motion, spring.as_ref()?)))
    }

    /// The dimensionless stiffnesses of the springs between both sides of each motion that is not rigid.
    pub(super) fn links(&self, units: &Units) -> Links {
        let mut links = [None; 6];
        for (motion, spring) in self.released() {
            let unit = units.motion[motion as usize];
            links[motion as usize] = Some(spring.stiffness * unit * unit / units.stiffness);
        }
        Links(links)
    }
}

impl Links {
    /// Only the rate of twist is released, without a spring.
    pub(super) fn without_bimoment() -> Self {
        let mut links = [None; 6];
        links[BeamMotion::PsiSlope as usize] = Some(0.0);
        Self(links)
    }

    /// The dimensionless stiffness K of the beam on one side, seen from the other one: in series with the links. Also the
    /// number of negative pivots of the motions that are eliminated.
    ///
    /// With the released motions J and their springs k, `X = (K_JJ + k)^-1 K_J`: the rows J become `k X` and the others
    /// `K_I - K_IJ X`, without a difference of large numbers for a soft or a stiff spring.
    pub(super) fn beyond(&self, stiffness: &Matrix6<f64>) -> (Matrix6<f64>, usize) {
        let Self(springs) = self;
        let is_released = |row: usize| springs[row].is_some();
        let own = Matrix6::from_fn(|i, j| match (springs[i], i == j) {
            (Some(spring), true) => stiffness[(i, i)] + spring,
            (Some(_), false) if is_released(j) => stiffness[(i, j)],
            (None, true) => 1.0,
            (Some(_) | None, false) => 0.0,
        });
        let mut pulled = *stiffness;
        for row in (0..6).filter(|row| !is_released(*row)) {
            pulled.row_mut(row).fill(0.0);
        }
        let eliminated = eliminate(&own, &pulled);
        let follows = &eliminated.solution;
        let mut beyond = *stiffness - pulled.transpose() * follows;
        for (row, spring) in springs.iter().enumerate() {
            if let Some(spring) = spring {
                for column in 0..6 {
                    let pull = spring * follows[(row, column)];
                    beyond[(row, column)] = pull;
                    beyond[(column, row)] = pull;
                }
            }
        }
        (symmetric(beyond), eliminated.negatives)
    }
}

impl Fixed {
    /// None of the motions.
    pub(super) const NONE: Self = Self {
        motions: [false; 6],
        point: Point::AXIS,
    };

    /// What some supports at one position fix together: w, or v, at two points is also the twist.
    pub(super) fn by(supports: &[Restrained]) -> Self {
        let mut all = Self::NONE;
        for restrained in supports {
            let point = restrained.support.point;
            for motion in BeamMotion::ALL
                .into_iter()
                .filter(|of| restrained.is_fixed(*of))
            {
                let is_known = all.motions[motion as usize];
                if is_known && all.point.arm(motion) != point.arm(motion) {
                    all.motions[BeamMotion::Psi as usize] = true;
                }
                all.motions[motion as usize] = true;
                match motion {
                    BeamMotion::W => all.point.z = point.z,
                    BeamMotion::V => all.point.y = point.y,
                    BeamMotion::Psi
                    | BeamMotion::WSlope
                    | BeamMotion::PsiSlope
                    | BeamMotion::VSlope => {}
                }
            }
        }
        if all.motions[BeamMotion::Psi as usize] {
            all.point = Point::AXIS;
        }
        all
    }

    /// The motions of the axis from those of the point, both dimensionless; none if the point is on the axis.
    pub(super) fn axis_of_point(&self, units: &Units) -> Option<Matrix6<f64>> {
        let Point { y, z } = self.point;
        units.of_point(Point { y: -y, z: -z })
    }
}

impl Units {
    /// The motions of a point of the section from those of the axis, both dimensionless; none if the point is on the axis.
    fn of_point(&self, point: Point) -> Option<Matrix6<f64>> {
        if point == Point::AXIS {
            return None;
        }
        let mut moved = Matrix6::identity();
        let psi = BeamMotion::Psi as usize;
        for motion in [BeamMotion::W, BeamMotion::V] {
            let arm = point.arm(motion).unwrap_or_default();
            moved[(motion as usize, psi)] = arm * self.motion[psi];
        }
        Some(moved)
    }

    /// The same for a line of points along the beam, whose slopes differ likewise.
    pub(super) fn of_line(&self, offset: Point) -> Option<Matrix6<f64>> {
        let mut moved = self.of_point(offset)?;
        let displaced = moved.fixed_view::<3, 3>(0, 0).into_owned();
        moved.fixed_view_mut::<3, 3>(3, 3).copy_from(&displaced);
        Some(moved)
    }
}

/// The stiffness over psi, N m/rad, while a mass follows at rest, in closed form.
///
/// It follows the y springs, and z and theta follow both z springs, unless these act at one point of the mass: then they
/// are in series between the two mounts.
fn following_stiffness(subsystem: &Subsystem) -> f64 {
    let (left, right) = (subsystem.z_left.stiffness, subsystem.z_right.stiffness);
    if subsystem.arm_left + subsystem.arm_right != 0.0 || left == 0.0 || right == 0.0 {
        return 0.0;
    }
    left * right / (left + right) * (2.0 * subsystem.mount_y).powi(2)
}

impl Mass {
    /// Chen & Liu 2022, Appendix A, without damping.
    pub(super) fn new(subsystem: &Subsystem) -> Self {
        let mut stiffness = Matrix6::zeros();
        for Stretch { spring, mass, beam } in rows(subsystem) {
            let row = Vector6::from_iterator(mass.into_iter().chain(beam));
            stiffness += spring.stiffness * row * row.transpose();
        }
        let mut inertia = [subsystem.mass, subsystem.mass, subsystem.inertia];
        if subsystem.inertia == 0.0 && stiffness[(2, 2)] == 0.0 {
            // Neither inertia nor stiffness: not a degree of freedom.
            stiffness[(2, 2)] = 1.0;
            inertia[2] = 0.0;
        }
        Self {
            position: subsystem.position,
            stiffness,
            inertia,
            following: following_stiffness(subsystem),
        }
    }

    /// The dimensionless stiffness over (w, psi, v) with the mass eliminated, and the count of the blocked mass.
    pub(super) fn condensed(&self, omega: f64, units: &Units) -> (Matrix3<f64>, usize) {
        let scale = |index: usize| match index {
            0 | 1 => 1.0,
            2 => units.motion[1],
            beam => units.motion[beam - 3],
        };
        let full = Matrix6::from_fn(|i, j| {
            let inertia = if i == j && i < 3 {
                omega * omega * self.inertia[i]
            } else {
                0.0
            };
            (self.stiffness[(i, j)] - inertia) * scale(i) * scale(j) / units.stiffness
        });
        let across = full.fixed_view::<3, 3>(0, 3).into_owned();
        let own = eliminate(&full.fixed_view::<3, 3>(0, 0).into_owned(), &across);
        let condensed = full.fixed_view::<3, 3>(3, 3) - across.transpose() * own.solution;
        (condensed, own.negatives)
    }

    /// The static stiffness over (w, psi, v) while the mass follows, and the number of its motions without a spring.
    pub(super) fn condensed_static(&self) -> (Matrix3<f64>, usize) {
        let mut condensed = Matrix3::zeros();
        condensed[(1, 1)] = self.following;
        let own = self.own_motions();
        let loose = own.iter().filter(|(value, _)| *value == 0.0);
        (condensed, loose.count())
    }

    /// The motion of the mass for a static motion (w, psi, v) of the beam.
    pub(super) fn following(&self, beam: &[f64; 3]) -> [f64; 3] {
        let across = self.stiffness.fixed_view::<3, 3>(0, 3);
        let pulled = across * Vector3::from(*beam);
        let mut moved = Vector3::zeros();
        for (value, vector) in self.own_motions() {
            if value > 0.0 {
                moved -= vector * (vector.dot(&pulled) / value);
            }
        }
        moved.into()
    }

    /// The motions of the mass that stretch no spring.
    pub(super) fn loose(&self) -> Vec<[f64; 3]> {
        let own = self.own_motions();
        let loose = own.into_iter().filter(|(value, _)| *value == 0.0);
        loose.map(|(_, vector)| vector.into()).collect()
    }

    /// (y, z, theta | w, psi, v) in a rigid motion; `index` is that of the mass.
    pub(super) fn stretched(&self, motion: &RigidMotion, index: usize) -> Vector6<f64> {
        let ([y, z, theta], [w, psi, v]) = (motion.masses[index], motion.at(self.position));
        Vector6::new(y, z, theta, w, psi, v)
    }

    /// The principal motions of the mass on its springs with the beam fixed, and their stiffness: 0 if it is rounding.
    fn own_motions(&self) -> [(f64, Vector3<f64>); 3] {
        let own = self.stiffness.fixed_view::<3, 3>(0, 0).into_owned();
        let eigen = SymmetricEigen::new(own);
        let least = RESOLVED * eigen.eigenvalues.amax();
        std::array::from_fn(|index| {
            let value = eigen.eigenvalues[index];
            let kept = if value > least { value } else { 0.0 };
            (kept, eigen.eigenvectors.column(index).into_owned())
        })
    }
}

//! The derivative of a response by every parameter, from two fields: `-lambda^T (dD/dp) u`.
//!
//! The beam, its supports and its subsystems are one system `D u = F`, complex and symmetric; a response is `e^T u` and
//! `lambda` the solution for `e` instead of the loads. So `dr/dp = lambda^T (dF/dp - (dD/dp) u)`. Every spring, damper
//! and mass is one term of D, and the beam is the bilinear form of its [matrices](crate::solve::beam_matrices),
//!
//! ```text
//! int s'^T D s' + g^T F g + q'^T C q' + q^T K q - omega^2 (q^T M q + s^T R s) dx
//! ```
//!
//! with the motions q, rotations s and shear forces g of lambda on the left and of u on the right.
//!
//! The adjoint: Lions, Optimal Control of Systems (1971); for vibration: Adelman & Haftka, AIAA J. 24 (1986) 823-832.

use num_complex::Complex64;

use super::field::{Field, JointField, MassField, Setting, SupportField};
use super::overlap::Overlap;
use crate::model::schema::{
    BeamKey, ElasticKey, FoundationKey, LinkKey, MaterialKey, SectionKey, SubsystemKey,
};
use crate::model::{BeamMotion, Bedding, Joint, Link, Restraint, Spring, Subsystem, SupportId};
use crate::solve::beam_matrices::BeamMatrices;
use crate::solve::beam_state::BeamState;
use crate::solve::linear::ZERO;
use crate::solve::springs::{rows, springs};

/// A field and its adjoint, with the integrals of their product.
pub(super) struct Product<'a> {
    pub(super) setting: Setting<'a>,
    pub(super) lambda: &'a Field,
    pub(super) u: &'a Field,
    pub(super) overlap: Overlap,
}

impl Product<'_> {
    /// `-lambda^T (dD/dp) u` for the parameters of the beam, the supports, the joints and the subsystems, in their order; `held`
    /// are the loads (of lambda and of u) whose position is constant while the right end moves.
    pub(super) fn by_parameter(&self, held: [&[Complex64; 6]; 2]) -> Vec<Complex64> {
        let beam = &self.setting.model.beam;
        let by = |matrices: &BeamMatrices| -self.overlap.form(matrices, self.setting.omega);
        let own = BeamKey::ALL.into_iter().filter_map(|key| match key {
            BeamKey::Length => Some(self.by_length(held)),
            key => BeamMatrices::by_beam(beam, key).as_ref().map(by),
        });
        let mut all: Vec<Complex64> = own.collect();
        all.extend(MaterialKey::ALL.map(|key| by(&BeamMatrices::by_material(beam, key))));
        all.extend(SectionKey::ALL.map(|key| match key {
            SectionKey::WarpingConstant if self.is_infinite_by_warping() => {
                Complex64::new(f64::INFINITY, f64::INFINITY)
            }
            key => by(&BeamMatrices::by_section(beam, key)),
        }));
        all.extend(self.by_foundation());
        for (id, fields) in self.supports() {
            self.by_support(id, fields, &mut all);
        }
        for (joint, fields) in self.joints() {
            self.by_joint(joint, fields, &mut all);
        }
        let masses = self.lambda.masses.iter().zip(&self.u.masses);
        for (subsystem, (lambda, u)) in self.setting.model.attached().zip(masses) {
            all.extend(self.by_subsystem(subsystem, lambda, u));
        }
        all
    }

    /// `-lambda^T (dD/d omega) u = lambda^T (2 omega M - i C) u`, per rad/s.
    pub(super) fn by_omega(&self) -> Complex64 {
        let matrices = &self.setting.plan.beam.matrices;
        let (mut mass, mut damping) = (self.overlap.inertia(matrices), ZERO);
        let bedded = self.overlap.motions().into_iter();
        for (product, c) in bedded.zip(matrices.foundation_damping) {
            damping += c * product;
        }
        for (id, fields) in self.supports() {
            for motion in BeamMotion::ALL {
                let product = self.at_support(fields, motion);
                let elastic = id.support(self.setting.model)[motion].elastic();
                mass += elastic.inertia * product;
                damping += elastic.damping * product;
            }
        }
        for (joint, [lambda, u]) in self.joints() {
            for (link, product) in joint.links.iter().zip(products(&lambda.jumps, &u.jumps)) {
                damping += link.spring().damping * product;
            }
        }
        let masses = self.lambda.masses.iter().zip(&self.u.masses);
        for (subsystem, (lambda, u)) in self.setting.model.attached().zip(masses) {
            let [y, z, theta] = products(&lambda.motion, &u.motion);
            mass += subsystem.mass * (y + z) + subsystem.inertia * theta;
            let springs = springs(subsystem);
            let stretches = products(&lambda.stretches, &u.stretches);
            for (spring, stretch) in springs.iter().zip(stretches) {
                damping += spring.damping * stretch;
            }
        }
        2.0 * self.setting.omega * mass - Complex64::I * damping
    }

    /// The Hamiltonian at the right end: the effect of one more metre of beam there.
    ///
    /// `-dD/dL` of the beam is minus the density of its form there, and the support and its loads move by the slopes,
    /// so `dr/dL = sum (p_u q'_lambda + p_lambda q'_u) - density` over displacements and slopes q with their internal
    /// forces p (Gelfand & Fomin, Calculus of Variations (1963), Section 13).
    fn by_length(&self, held: [&[Complex64; 6]; 2]) -> Complex64 {
        let beam = &self.setting.plan.beam;
        let [lambda, u] = [self.lambda, self.u];
        let edges = [(lambda, held[0]), (u, held[1])].map(|(field, held)| beyond(field, held));
        let [l, u] = &edges;
        let (motions, forces) = ([&l.motion, &u.motion], [&l.force, &u.force]);
        beam.matrices.shifted(self.setting.omega, motions, forces)
    }

    /// Whether the derivative by `Gamma_0`, which is 0 and can only increase, is infinite.
    ///
    /// Warping stiffness then makes boundary layers of the thickness sqrt(E `Gamma_0` / G J) at torques and at ends
    /// with a fixed rate of twist. They stiffen the beam in proportion to it, unless one of the two fields has no
    /// torque.
    fn is_infinite_by_warping(&self) -> bool {
        let [lambda, u] = [&self.lambda.kinks, &self.u.kinks];
        let sum = |one: &[Complex64], other: &[Complex64]| -> Complex64 {
            one.iter().zip(other).map(|(one, other)| one * other).sum()
        };
        0.5 * sum(&lambda.jumps, &u.jumps) + sum(&lambda.held, &u.held) != ZERO
    }

    /// By the stiffness, the damping and the loss factor on w, psi and v.
    fn by_foundation(&self) -> [Complex64; FoundationKey::ALL.len()] {
        let [w, psi, v] = self.overlap.motions();
        let foundation = &self.setting.model.beam.foundation;
        let stiffness = |bedding: Bedding, product: Complex64| {
            -Complex64::new(1.0, bedding.loss_factor) * product
        };
        let damping = |product: Complex64| -Complex64::I * self.setting.omega * product;
        let loss =
            |bedding: Bedding, product: Complex64| -Complex64::I * bedding.stiffness * product;
        FoundationKey::ALL.map(|key| match key {
            FoundationKey::WStiffness => stiffness(foundation.w, w),
            FoundationKey::WDamping => damping(w),
            FoundationKey::WLossFactor => loss(foundation.w, w),
            FoundationKey::PsiStiffness => stiffness(foundation.psi, psi),
            FoundationKey::PsiDamping => damping(psi),
            FoundationKey::PsiLossFactor => loss(foundation.psi, psi),
            FoundationKey::VStiffness => stiffness(foundation.v, v),
            FoundationKey::VDamping => damping(v),
            FoundationKey::VLossFactor => loss(foundation.v, v),
        })
    }

    /// The supports with both fields there.
    fn supports(&self) -> impl Iterator<Item = (SupportId, [&SupportField; 2])> {
        let fields = self.lambda.supports.iter().zip(&self.u.supports);
        SupportId::all(self.setting.model).zip(fields.map(|(lambda, u)| [lambda, u]))
    }

    /// In the order of the rows with numbers.
    fn by_support(&self, id: SupportId, fields: [&SupportField; 2], all: &mut Vec<Complex64>) {
        let [lambda, u] = fields;
        if let SupportId::Inner(_) = id {
            let rows = 0..lambda.forces.len();
            let work = rows
                .map(|row| lambda.forces[row] * u.along[row] + u.forces[row] * lambda.along[row]);
            all.push(work.sum());
        }
        let support = id.support(self.setting.model);
        for motion in BeamMotion::ALL {
            if let Restraint::Free | Restraint::Elastic(_) = support[motion] {
                let product = self.at_support(fields, motion);
                all.extend(self.dynamic(support[motion].elastic().into(), product));
            }
        }
        // The force along v moves by -psi with y, that along w by psi with z.
        let turned = |motion: BeamMotion| {
            let row = motion as usize;
            lambda.forces[row] * u.twist + u.forces[row] * lambda.twist
        };
        all.extend([-turned(BeamMotion::V), turned(BeamMotion::W)]);
    }

    /// The joints with both fields there.
    fn joints(&self) -> impl Iterator<Item = (&Joint, [&JointField; 2])> {
        let fields = self.lambda.joints.iter().zip(&self.u.joints);
        let joints = self.setting.model.joints.iter();
        joints.zip(fields.map(|(lambda, u)| [lambda, u]))
    }

    /// In the order of the rows with numbers.
    ///
    /// With H the effect of one more metre of beam at a place, a joint that moves gives H of its left side for that of its
    /// right one. H is a bilinear form of the motions and internal forces whose derivative by the motions is minus the change
    /// of the internal forces, so that the difference is the work of these changes on the jumps.
    fn by_joint(&self, joint: &Joint, fields: [&JointField; 2], all: &mut Vec<Complex64>) {
        let [lambda, u] = fields;
        let rows = 0..lambda.jumps.len();
        let work =
            rows.map(|row| lambda.jumps[row] * u.changes[row] + u.jumps[row] * lambda.changes[row]);
        all.push(work.sum());
        for (link, product) in joint.links.iter().zip(products(&lambda.jumps, &u.jumps)) {
            if let Link::Free | Link::Elastic(_) = link {
                let by = self.dynamic(link.spring(), product);
                all.extend(LinkKey::ALL.map(|key| match key {
                    LinkKey::Stiffness => by[ElasticKey::Stiffness as usize],
                    LinkKey::Damping => by[ElasticKey::Damping as usize],
                    LinkKey::LossFactor => by[ElasticKey::LossFactor as usize],
                }));
            }
        }
    }

    /// The product of the two fields' motions at a support.
    fn at_support(&self, [lambda, u]: [&SupportField; 2], motion: BeamMotion) -> Complex64 {
        // Without warping stiffness any restraint fixes the rate of twist; none has an effect of its own.
        if motion == BeamMotion::PsiSlope && self.setting.plan.beam.without_warping() {
            return ZERO;
        }
        lambda.motion[motion as usize] * u.motion[motion as usize]
    }

    /// Minus the product times the derivatives of `k (1 + i eta) + i omega c - omega^2 m`.
    fn dynamic(&self, spring: Spring, product: Complex64) -> [Complex64; ElasticKey::ALL.len()] {
        let omega = self.setting.omega;
        ElasticKey::ALL.map(|key| match key {
            ElasticKey::Stiffness => -Complex64::new(1.0, spring.loss_factor) * product,
            ElasticKey::Damping => -Complex64::I * omega * product,
            ElasticKey::LossFactor => -Complex64::I * spring.stiffness * product,
            ElasticKey::Inertia => omega * omega * product,
        })
    }

    /// In the order of the rows with numbers.
    fn by_subsystem(
        &self,
        subsystem: &Subsystem,
        lambda: &MassField,
        u: &MassField,
    ) -> impl Iterator<Item = Complex64> {
        let square = self.setting.omega * self.setting.omega;
        let [y, z, theta] = products(&lambda.motion, &u.motion);
        let stretches = products(&lambda.stretches, &u.stretches);
        let own = springs(subsystem);
        let [y_left, y_right, z_left, z_right] =
            std::array::from_fn(|spring| self.dynamic(own[spring], stretches[spring]));
        // The derivative by a position is the spring force times the change of its stretch, in both fields.
        let pulled = |force: fn(&MassField) -> Complex64, moved: fn(&MassField) -> Complex64| {
            force(lambda) * moved(u) + force(u) * moved(lambda)
        };
        let theta_of = |field: &MassField| field.motion[2];
        let twist_of = |field: &MassField| field.twist;
        let along = lambda.along(subsystem, u) + u.along(subsystem, lambda);
        let of = |spring: [Complex64; ElasticKey::ALL.len()], key| Some(spring[key as usize]);
        let by = move |key| match key {
            SubsystemKey::Name | SubsystemKey::Enabled => None,
            SubsystemKey::Position => Some(along),
            SubsystemKey::Mass => Some(square * (y + z)),
            SubsystemKey::Inertia => Some(square * theta),
            SubsystemKey::YLeftStiffness => of(y_left, ElasticKey::Stiffness),
            SubsystemKey::YLeftDamping => of(y_left, ElasticKey::Damping),
            SubsystemKey::YLeftLossFactor => of(y_left, ElasticKey::LossFactor),
            SubsystemKey::YRightStiffness => of(y_right, ElasticKey::Stiffness),
            SubsystemKey::YRightDamping => of(y_right, ElasticKey::Damping),
            SubsystemKey::YRightLossFactor => of(y_right, ElasticKey::LossFactor),
            SubsystemKey::ZLeftStiffness => of(z_left, ElasticKey::Stiffness),
            SubsystemKey::ZLeftDamping => of(z_left, ElasticKey::Damping),
            SubsystemKey::ZLeftLossFactor => of(z_left, ElasticKey::LossFactor),
            SubsystemKey::ZRightStiffness => of(z_right, ElasticKey::Stiffness),
            SubsystemKey::ZRightDamping => of(z_right, ElasticKey::Damping),
            SubsystemKey::ZRightLossFactor => of(z_right, ElasticKey::LossFactor),
            SubsystemKey::ArmLeft => Some(pulled(|field| field.forces[2], theta_of)),
            SubsystemKey::ArmRight => Some(-pulled(|field| field.forces[3], theta_of)),
            SubsystemKey::MountY => {
                Some(pulled(|field| field.forces[3] - field.forces[2], twist_of))
            }
            SubsystemKey::MountZ => {
                Some(pulled(|field| field.forces[0] + field.forces[1], twist_of))
            }
        };
        SubsystemKey::ALL.into_iter().filter_map(by)
    }
}

impl MassField {
    /// The work of this field's forces along the slopes of the other field.
    fn along(&self, subsystem: &Subsystem, other: &Self) -> Complex64 {
        let [across, left, right] = rows(subsystem).map(|row| row.of([[ZERO; 3], other.slope]));
        let [y_left, y_right, z_left, z_right] = self.forces;
        -((y_left + y_right) * across + z_left * left + z_right * right)
    }
}

/// The right end just beyond the loads whose position is constant.
fn beyond(field: &Field, held: &[Complex64; 6]) -> BeamState {
    let mut edge = field.edge.clone();
    for (force, held) in edge.force.iter_mut().zip(held) {
        *force -= held;
    }
    edge
}

fn products<const N: usize>(one: &[Complex64; N], other: &[Complex64; N]) -> [Complex64; N] {
    std::array::from_fn(|index| one[index] * other[index])
}

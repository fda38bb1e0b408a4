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
    BeamKey, BranchKey, ElasticKey, FoundationKey, LinkKey, SectionKey, SpanKey, SubsystemKey,
};
use crate::model::{
    Beam, BeamMotion, BeamNumber, Joint, Link, MaxwellBranch, ParameterId, Restraint, Spring,
    Subsystem, SupportId, UniformPart,
};
use crate::solve::beam_matrices::{Across, BeamMatrices};
use crate::solve::beam_state::BeamState;
use crate::solve::linear::ZERO;
use crate::solve::springs::rows;

/// A field and its adjoint, with the integrals of their product.
pub(super) struct Product<'a> {
    pub(super) setting: Setting<'a>,
    pub(super) lambda: &'a Field,
    pub(super) u: &'a Field,
    /// Of each uniform part.
    pub(super) overlaps: Vec<Overlap>,
}

impl Product<'_> {
    /// `-lambda^T (dD/dp) u` for the parameters `ids` of the beam, its spans, the supports, the joints and the subsystems, in
    /// their order; `held` are the jumps (of lambda and of u) between the right end and where the beam grows: those of loads whose
    /// position is constant while the end moves.
    pub(super) fn by_parameter(
        &self,
        ids: &[ParameterId],
        held: [&BeamState; 2],
    ) -> Vec<Complex64> {
        let parts = self.setting.model.uniform_parts();
        let of_beam = ids.iter().map_while(|id| id.of_beam());
        let of_beam = of_beam.filter_map(|number| self.by_beam(&parts, number, held));
        let mut all: Vec<Complex64> = of_beam.collect();
        for (id, fields) in self.supports() {
            self.by_support(id, fields, &mut all);
        }
        for (joint, fields) in self.joints() {
            self.by_joint(joint, fields, &mut all);
        }
        let masses = self.lambda.masses.iter().zip(&self.u.masses);
        for (subsystem, (lambda, u)) in self.setting.model.attached().zip(masses) {
            all.extend(self.by_subsystem(subsystem, lambda, u));
            let stretches = products(&lambda.stretches, &u.stretches);
            for (spring, product) in subsystem.springs().into_iter().zip(stretches) {
                all.extend(self.by_branches(spring, product));
            }
        }
        all
    }

    /// `-lambda^T (dD/d omega) u = lambda^T (2 omega M - i C) u`, per rad/s.
    pub(super) fn by_omega(&self) -> Complex64 {
        let (mut mass, mut damping) = (ZERO, ZERO);
        let here = [self.setting.omega; 2];
        for overlap in &self.overlaps {
            let matrices = &self.setting.plan.beams[overlap.beam].matrices;
            mass += overlap.inertia(matrices);
            let bedded = overlap.motions().into_iter();
            for (product, c) in bedded.zip(matrices.foundation_damping) {
                damping += c * product;
            }
        }
        for (id, fields) in self.supports() {
            for motion in BeamMotion::ALL {
                let [stretched, moved] = at_support(fields, motion);
                let elastic = id.support(self.setting.model)[motion].elastic();
                mass += elastic.inertia * moved;
                damping += elastic.spring.damping_between(here) * stretched;
            }
        }
        for (joint, [lambda, u]) in self.joints() {
            for (link, product) in joint.links.iter().zip(products(&lambda.jumps, &u.jumps)) {
                damping += link.spring().damping_between(here) * product;
            }
        }
        let masses = self.lambda.masses.iter().zip(&self.u.masses);
        for (subsystem, (lambda, u)) in self.setting.model.attached().zip(masses) {
            let [y, z, theta] = products(&lambda.motion, &u.motion);
            mass += subsystem.mass * (y + z) + subsystem.inertia * theta;
            let stretches = products(&lambda.stretches, &u.stretches);
            for (spring, stretch) in subsystem.springs().into_iter().zip(stretches) {
                damping += spring.damping_between(here) * stretch;
            }
        }
        2.0 * self.setting.omega * mass - Complex64::I * damping
    }

    /// By a number of the beam; `None` for what is no number.
    fn by_beam(
        &self,
        parts: &[UniformPart],
        number: BeamNumber,
        held: [&BeamState; 2],
    ) -> Option<Complex64> {
        let of = number.parts(self.setting.model);
        Some(match number {
            BeamNumber::Beam(BeamKey::Length) => self.by_length(0, held),
            BeamNumber::Span(index, SpanKey::Length) => self.by_length(index, held),
            BeamNumber::Span(index, SpanKey::OffsetY) => self.by_offset(index, Across::Y),
            BeamNumber::Span(index, SpanKey::OffsetZ) => self.by_offset(index, Across::Z),
            BeamNumber::Beam(BeamKey::AxialForce) | BeamNumber::Span(_, SpanKey::AxialForce) => {
                self.by_numbers(parts, of, BeamMatrices::by_axial_force)
            }
            BeamNumber::Beam(BeamKey::Theory | BeamKey::WarpingInertia)
            | BeamNumber::Span(_, SpanKey::Material | SpanKey::Section | SpanKey::Foundation) => {
                return None;
            }
            BeamNumber::Material(_, key) => {
                self.by_numbers(parts, of, |beam| BeamMatrices::by_material(beam, key))
            }
            BeamNumber::Section(_, SectionKey::WarpingConstant)
                if of.clone().any(|part| self.is_infinite_by_warping(part)) =>
            {
                Complex64::new(f64::INFINITY, f64::INFINITY)
            }
            BeamNumber::Section(_, key) => {
                self.by_numbers(parts, of, |beam| BeamMatrices::by_section(beam, key))
            }
            BeamNumber::Foundation(_, key) => self.by_foundation(parts, of, key),
        })
    }

    /// By a number of some of the uniform parts, from its derivatives along their own shear centres.
    fn by_numbers(
        &self,
        parts: &[UniformPart],
        of: impl Iterator<Item = usize>,
        derivative: impl Fn(&Beam) -> BeamMatrices,
    ) -> Complex64 {
        let by = of.map(|index| {
            let UniformPart { beam, offset, .. } = &parts[index];
            -self.overlaps[index].form(&derivative(beam).moved(*offset), self.setting.omega)
        });
        by.sum()
    }

    /// By the offset of the shear centre of a part. Without warping stiffness it can only be 0.
    fn by_offset(&self, part: usize, along: Across) -> Complex64 {
        let overlap = &self.overlaps[part];
        let beam = &self.setting.plan.beams[overlap.beam];
        if beam.without_warping() {
            return Complex64::new(f64::NAN, f64::NAN);
        }
        -overlap.form(&beam.matrices.by_offset(along), self.setting.omega)
    }

    /// The effect of one more metre of a part: the right end and the ends of the parts from there on move.
    ///
    /// At the right end it is the Hamiltonian: `-dD/dL` of the beam is minus the density of its form there, and the support and
    /// its loads move by the slopes, so `dr/dL = sum (p_u q'_lambda + p_lambda q'_u) - density` over displacements and slopes q
    /// with their internal forces p (Gelfand & Fomin, Calculus of Variations (1963), Section 13). Where two parts meet, the
    /// left one grows by what the right one loses.
    fn by_length(&self, part: usize, held: [&BeamState; 2]) -> Complex64 {
        let beam = |index: usize| {
            let overlap = &self.overlaps[index];
            &self.setting.plan.beams[overlap.beam].matrices
        };
        let shifted = |index: usize, [l, u]: [&BeamState; 2]| {
            let (motions, forces) = ([&l.motion, &u.motion], [&l.force, &u.force]);
            beam(index).shifted(self.setting.omega, motions, forces)
        };
        let [lambda, u] = [self.lambda, self.u];
        let edges = [(lambda, held[0]), (u, held[1])].map(|(field, held)| beyond(field, held));
        let last = self.overlaps.len() - 1;
        let mut sum = shifted(last, edges.each_ref());
        for index in part..last {
            let [[l, l_after], [u, u_after]] = [lambda, u].map(|field| &field.junctions[index]);
            sum += shifted(index, [l, u]) - shifted(index + 1, [l_after, u_after]);
        }
        sum
    }

    /// Whether the derivative by `Gamma_0` of a part, where it is 0 and can only increase, is infinite.
    ///
    /// Warping stiffness then makes boundary layers of the thickness sqrt(E `Gamma_0` / G J) at torques and at ends
    /// with a fixed rate of twist. They stiffen the beam in proportion to it, unless one of the two fields has no
    /// torque.
    fn is_infinite_by_warping(&self, part: usize) -> bool {
        let [lambda, u] = [&self.lambda.kinks, &self.u.kinks];
        let sum = |one: &[(usize, Complex64)], other: &[(usize, Complex64)]| -> Complex64 {
            let both = one.iter().zip(other).filter(|((own, _), _)| *own == part);
            both.map(|((_, one), (_, other))| one * other).sum()
        };
        0.5 * sum(&lambda.jumps, &u.jumps) + sum(&lambda.held, &u.held) != ZERO
    }

    /// By a number of the foundation of some parts.
    fn by_foundation(
        &self,
        parts: &[UniformPart],
        of: impl Iterator<Item = usize>,
        key: FoundationKey,
    ) -> Complex64 {
        let (row, number) = match key {
            FoundationKey::WStiffness => (0, ElasticKey::Stiffness),
            FoundationKey::WDamping => (0, ElasticKey::Damping),
            FoundationKey::WLossFactor => (0, ElasticKey::LossFactor),
            FoundationKey::PsiStiffness => (1, ElasticKey::Stiffness),
            FoundationKey::PsiDamping => (1, ElasticKey::Damping),
            FoundationKey::PsiLossFactor => (1, ElasticKey::LossFactor),
            FoundationKey::VStiffness => (2, ElasticKey::Stiffness),
            FoundationKey::VDamping => (2, ElasticKey::Damping),
            FoundationKey::VLossFactor => (2, ElasticKey::LossFactor),
        };
        let by = of.map(|part| {
            let bedding = parts[part].beam.foundation.beddings()[row];
            let spring = Spring {
                stiffness: bedding.stiffness,
                damping: bedding.damping,
                loss_factor: bedding.loss_factor,
                ..Spring::default()
            };
            self.dynamic(&spring, self.overlaps[part].motions()[row])[number as usize]
        });
        by.sum()
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
                let [stretched, moved] = at_support(fields, motion);
                let [spring @ .., _] = self.dynamic(&support[motion].elastic().spring, stretched);
                all.extend(spring);
                all.push(self.setting.omega * self.setting.omega * moved);
            }
        }
        // The force along v moves by -psi with y, that along w by psi with z.
        let turned = |motion: BeamMotion| {
            let row = motion as usize;
            lambda.forces[row] * u.twist + u.forces[row] * lambda.twist
        };
        all.extend([-turned(BeamMotion::V), turned(BeamMotion::W)]);
        for motion in BeamMotion::ALL {
            let [stretched, _] = at_support(fields, motion);
            all.extend(self.by_branches(&support[motion].elastic().spring, stretched));
        }
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
        for (link, product) in joint.links.iter().zip(products(&lambda.jumps, &u.jumps)) {
            all.extend(self.by_branches(link.spring(), product));
        }
    }

    /// Minus the product times the derivatives of `k (1 + i eta) + i omega c - omega^2 m`.
    fn dynamic(&self, spring: &Spring, product: Complex64) -> [Complex64; ElasticKey::ALL.len()] {
        let omega = self.setting.omega;
        ElasticKey::ALL.map(|key| match key {
            ElasticKey::Stiffness => -Complex64::new(1.0, spring.loss_factor) * product,
            ElasticKey::Damping => -Complex64::I * omega * product,
            ElasticKey::LossFactor => -Complex64::I * spring.stiffness * product,
            ElasticKey::Inertia => omega * omega * product,
        })
    }

    /// Minus the product times the derivatives of the Maxwell branches of a spring, by the rows of each.
    fn by_branches(&self, spring: &Spring, product: Complex64) -> Vec<Complex64> {
        let rate = Complex64::I * self.setting.omega;
        let by = |of: &MaxwellBranch| {
            let (k, c) = (of.stiffness, rate * of.damping);
            let shares = if of.acts() {
                [c / (k + c), k / (k + c)]
            } else if k != 0.0 {
                // Without a damper.
                [ZERO, Complex64::ONE]
            } else {
                [Complex64::from(f64::from(of.damping != 0.0)), ZERO]
            };
            BranchKey::ALL.map(|key| match key {
                BranchKey::Stiffness => -shares[0] * shares[0] * product,
                BranchKey::Damping => -rate * shares[1] * shares[1] * product,
            })
        };
        spring.maxwell.iter().flat_map(by).collect()
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
        let own = subsystem.springs();
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

/// The products of the two fields' motions at a support, relative to the ground and alone.
fn at_support([lambda, u]: [&SupportField; 2], motion: BeamMotion) -> [Complex64; 2] {
    // Without warping stiffness any restraint fixes the rate of twist; none has an effect of its own.
    if motion == BeamMotion::PsiSlope && lambda.without_warping {
        return [ZERO; 2];
    }
    let row = motion as usize;
    [
        lambda.stretch[row] * u.stretch[row],
        lambda.motion[row] * u.motion[row],
    ]
}

/// The state where the beam grows, beyond some jumps at the right end.
fn beyond(field: &Field, held: &BeamState) -> BeamState {
    let mut edge = field.edge.clone();
    let jumps = held.force.iter().chain(&held.motion);
    let values = edge.force.iter_mut().chain(&mut edge.motion);
    for (value, jump) in values.zip(jumps) {
        *value -= jump;
    }
    edge
}

fn products<const N: usize>(one: &[Complex64; N], other: &[Complex64; N]) -> [Complex64; N] {
    std::array::from_fn(|index| one[index] * other[index])
}

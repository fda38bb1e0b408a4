//! Rows at a station, and the responses that are made of them, at several frequencies at once.

use super::complex::Complex;
use super::number::{Arithmetic, Real, part};
use super::reflection::{Amplitudes, reach};
use super::station::CHANNELS;
use super::waves::Waves;
use crate::model::{
    BeamMotion, MassMotion, Measure, Point, Restraint, Spring, SpringMeasure, SpringName,
};
use crate::solve::attachment::Attachment;
use crate::solve::beam_state::BeamState;
use crate::solve::linear::ZERO;
use crate::solve::output::{Holds, Output, Row, Sum};
use crate::solve::plan::{Event, Held, Plan};

/// The requested part of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// All of it.
    Whole,
    /// The contribution of the incoming waves, without any load.
    FromWaves,
}

/// The solution at a station.
#[derive(Debug, Clone)]
pub(super) struct State<A> {
    /// Amplitudes just left of it.
    pub(super) a: Amplitudes<A>,
    pub(super) b: Amplitudes<A>,
    /// The forces of an attachment's channels, N, and the angle of its mass, rad.
    pub(super) forces: [Complex<A>; CHANNELS],
    pub(super) theta: Complex<A>,
    /// The actions of a support or joint.
    pub(super) actions: [Complex<A>; 6],
}

impl<A: Arithmetic> State<A> {
    pub(super) const NONE: Self = Self {
        a: [Complex::ZERO; 6],
        b: [Complex::ZERO; 6],
        forces: [Complex::ZERO; CHANNELS],
        theta: Complex::ZERO,
        actions: [Complex::ZERO; 6],
    };

    /// A row at a station.
    pub(super) fn row(
        &self,
        plan: &Plan,
        station: usize,
        waves: &Waves<A>,
        row: Row,
        part: Part,
    ) -> Complex<A> {
        A::outlined(RowOf((self, plan, station, waves, row, part)))
    }

    #[inline(always)]
    fn row_inlined(
        (this, plan, station, waves, row, part): (&Self, &Plan, usize, &Waves<A>, Row, Part),
    ) -> Complex<A> {
        let event = &plan.stations[station].event;
        match (row, event) {
            (Row::Motion(motion, arm), _) => this.moved(waves, motion, arm),
            (Row::Force(motion), _) => this.force(waves, motion, Point::AXIS),
            (Row::Reaction(Holds::Left, motion), _) => {
                let action = -this.force(waves, motion, plan.left.support.point);
                this.reaction(waves, (&plan.left, motion), action, part)
            }
            (Row::Reaction(Holds::Right, motion), _) => {
                let action = this.force(waves, motion, plan.right.support.point);
                this.reaction(waves, (&plan.right, motion), action, part)
            }
            (Row::Reaction(Holds::Station, motion), Event::Support(held)) => {
                let action = this.actions[motion as usize];
                this.reaction(waves, (held, motion), action, part)
            }
            (Row::Mass(motion), Event::Attachment(attachment)) => {
                this.mass(waves, attachment, motion, part)
            }
            (Row::Spring(spring, measure), Event::Attachment(attachment)) => {
                this.spring(waves, attachment, (spring, measure), part)
            }
            (Row::OnFixed(spring), Event::Attachment(attachment)) => {
                this.spring(waves, attachment, (spring, SpringMeasure::Force), part)
            }
            (
                Row::Reaction(Holds::Station, _) | Row::Mass(_) | Row::Spring(..) | Row::OnFixed(_),
                _,
            ) => Complex::ZERO,
        }
    }

    /// A motion of the beam, plus its twist times an arm, m.
    #[inline(always)]
    fn moved(&self, waves: &Waves<A>, motion: BeamMotion, arm: f64) -> Complex<A> {
        let moved = self.motion(waves, motion);
        if arm == 0.0 {
            return moved;
        }
        moved.plus_scaled(Real::splat(arm), self.motion(waves, BeamMotion::Psi))
    }

    /// An internal force conjugate to a motion of a point of the section: P (a - b), or M (a + b) of a slope; no bimoment
    /// without warping stiffness.
    #[inline(always)]
    fn force(&self, waves: &Waves<A>, motion: BeamMotion, point: Point) -> Complex<A> {
        let row = motion as usize;
        let mut sum = Complex::ZERO;
        if motion == BeamMotion::PsiSlope && waves.without_warping {
            return sum;
        }
        for wave in 0..6 {
            let (a, b) = (self.a[wave], self.b[wave]);
            sum = if row < 3 {
                sum.plus_product(waves.at_point(point, row, wave).1, a - b)
            } else {
                sum.plus_product(waves.moment[row - 3][wave], a + b)
            };
        }
        sum
    }

    /// What the springs and dampers of a support, or what holds a fixed motion, put on the ground, from the force of the support
    /// and the loads together on the beam.
    ///
    /// The force of a soft spring follows from its stretch, that of a stiff one from the balance at the support: either is a
    /// small difference of large numbers where the spring is much stiffer, or softer, than the waves.
    #[inline(always)]
    fn reaction(
        &self,
        waves: &Waves<A>,
        (held, motion): (&Held, BeamMotion),
        action: Complex<A>,
        part: Part,
    ) -> Complex<A> {
        let row = motion as usize;
        let (load, ground) = match part {
            Part::Whole => (held.loads_at_point()[row], held.ground[row]),
            Part::FromWaves => (ZERO, ZERO),
        };
        let balance = Complex::splat(load) - action;
        let Restraint::Elastic(elastic) = &held.support[motion] else {
            let is_fixed = held.support[motion] == Restraint::Fixed;
            return if is_fixed { balance } else { Complex::ZERO };
        };
        let spring = waves.omega.dynamic_stiffness(&elastic.spring);
        let point = held.support.point;
        let moved = self.moved(waves, motion, point.arm(motion).unwrap_or_default());
        let inertia = (waves.omega * waves.omega).scaled(Real::splat(elastic.inertia));
        let (mut of_motion, mut of_force) = (Real::ZERO, Real::ZERO);
        for wave in 0..6 {
            let (moves, acts) = if row < 3 {
                waves.at_point(point, row, wave)
            } else {
                (waves.slope[row - 3][wave], waves.moment[row - 3][wave])
            };
            of_motion = of_motion.max(moves.size());
            of_force = of_force.max(acts.size());
        }
        Complex::where_less(
            spring.size() * of_motion,
            of_force,
            spring * (moved - Complex::splat(ground)),
            balance.plus_product(inertia, moved),
        )
    }

    /// What a spring of a subsystem carries, or its stretch: the motion of the beam's end less that of the mass's.
    ///
    /// For a soft spring the stretch follows from the motions, for a stiff one from the force.
    #[inline(always)]
    fn spring(
        &self,
        waves: &Waves<A>,
        attachment: &Attachment,
        (spring, measure): (SpringName, SpringMeasure),
        part: Part,
    ) -> Complex<A> {
        let stiffness = |spring: &Spring| waves.omega.dynamic_stiffness(spring);
        let [force, sum, difference] = self.forces;
        let half = Real::splat(0.5);
        let psi = |arm: f64| {
            let psi = self.mount(waves, attachment, BeamMotion::Psi);
            psi.scaled(Real::splat(arm))
        };
        let across = |own: &Spring| {
            let moved = -self.mass(waves, attachment, MassMotion::Y, part);
            let w = self.mount(waves, attachment, BeamMotion::W);
            let lengths = [w, psi(attachment.mount_z), moved, Complex::ZERO];
            let both = stiffness(&attachment.spring_y);
            (
                better(lengths, [force, Complex::ZERO], both),
                stiffness(own),
            )
        };
        let along = |own: &Spring, side: f64, arm: f64| {
            let moved = -self.mass(waves, attachment, MassMotion::Z, part);
            let v = self.mount(waves, attachment, BeamMotion::V);
            let turned = self.theta.scaled(Real::splat(-side * arm));
            let lengths = [v, psi(side * attachment.mount_y), moved, turned];
            let side = Real::splat(0.5 * side);
            let forces = [sum.scaled(half), difference.scaled(side)];
            let own = stiffness(own);
            (better(lengths, forces, own), own)
        };
        let (stretch, own) = match spring {
            SpringName::YLeft => across(&attachment.y[0]),
            SpringName::YRight => across(&attachment.y[1]),
            SpringName::ZLeft => along(&attachment.z_left, -1.0, attachment.arm_left),
            SpringName::ZRight => along(&attachment.z_right, 1.0, attachment.arm_right),
        };
        match measure {
            SpringMeasure::Stretch => stretch,
            SpringMeasure::Force => own * stretch,
        }
    }

    /// A motion of the beam at a subsystem; one that a support fixes is from the waves only rounding.
    #[inline(always)]
    fn mount(&self, waves: &Waves<A>, attachment: &Attachment, motion: BeamMotion) -> Complex<A> {
        if attachment.held[motion as usize] {
            Complex::ZERO
        } else {
            self.motion(waves, motion)
        }
    }

    /// A motion of the beam: Q (a + b), or S (b - a) for a slope.
    #[inline(always)]
    fn motion(&self, waves: &Waves<A>, motion: BeamMotion) -> Complex<A> {
        let row = motion as usize;
        let (from, to) = if waves.all_coupled {
            reach::<true>(row % 3)
        } else {
            reach::<false>(row % 3)
        };
        let mut sum = Complex::ZERO;
        for wave in from..to {
            let (a, b) = (self.a[wave], self.b[wave]);
            sum = if row < 3 {
                sum.plus_product(waves.displacement[row][wave], a + b)
            } else {
                sum.plus_product(waves.slope[row - 3][wave], b - a)
            };
        }
        sum
    }

    /// Motions and internal forces of the beam at the first frequency; no bimoment if the section has no warping stiffness.
    pub(super) fn beam(&self, waves: &Waves<A>) -> BeamState {
        BeamState {
            motion: BeamMotion::ALL.map(|motion| self.motion(waves, motion).lane(0)),
            force: BeamMotion::ALL.map(|motion| self.force(waves, motion, Point::AXIS).lane(0)),
        }
    }

    /// The motion of the mass.
    ///
    /// Below the resonance of a mass on its springs the motion follows from the stretch, above it from the inertia: either
    /// alone would be a small difference of large numbers on the other side.
    #[inline(always)]
    pub(super) fn mass(
        &self,
        waves: &Waves<A>,
        attachment: &Attachment,
        motion: MassMotion,
        part: Part,
    ) -> Complex<A> {
        let [y, sum, difference] = self.forces;
        let inertia = (waves.omega * waves.omega).scaled(Real::splat(attachment.mass));
        let by_inertia = |force: Complex<A>, load| {
            let force = match part {
                Part::Whole => force + Complex::splat(load),
                Part::FromWaves => force,
            };
            -(force * inertia.inverse())
        };
        let psi = || self.mount(waves, attachment, BeamMotion::Psi);
        match motion {
            MassMotion::Theta => self.theta,
            MassMotion::Y => {
                let k = waves.omega.dynamic_stiffness(&attachment.spring_y);
                let mount = Real::splat(attachment.mount_z);
                let w = self.mount(waves, attachment, BeamMotion::W);
                let moved = w.plus_scaled(mount, psi());
                Complex::where_less(
                    inertia.norm_sqr(),
                    k.norm_sqr(),
                    moved - y * k.inverse(),
                    by_inertia(y, attachment.load[0]),
                )
            }
            MassMotion::Z => {
                let left = waves.omega.dynamic_stiffness(&attachment.z_left);
                let right = waves.omega.dynamic_stiffness(&attachment.z_right);
                let mount = psi().scaled(Real::splat(attachment.mount_y));
                let v = self.mount(waves, attachment, BeamMotion::V);
                let half = Real::splat(0.5);
                let by_right = v + mount
                    - (sum + difference).scaled(half) * right.inverse()
                    - self.theta.scaled(Real::splat(attachment.arm_right));
                let by_left = v - mount - (sum - difference).scaled(half) * left.inverse()
                    + self.theta.scaled(Real::splat(attachment.arm_left));
                let by_spring =
                    Complex::where_less(right.norm_sqr(), left.norm_sqr(), by_left, by_right);
                Complex::where_less(
                    inertia.norm_sqr(),
                    (left + right).norm_sqr(),
                    by_spring,
                    by_inertia(sum, attachment.load[1]),
                )
            }
        }
    }
}

/// The sum of lengths, or that of forces over a stiffness: the one with the smaller terms.
#[inline(always)]
fn better<A: Arithmetic>(
    lengths: [Complex<A>; 4],
    forces: [Complex<A>; 2],
    stiffness: Complex<A>,
) -> Complex<A> {
    let [mut by_motion, mut by_force] = [Complex::ZERO; 2];
    let [mut size_of_motion, mut size_of_force] = [Real::ZERO; 2];
    for length in lengths {
        by_motion += length;
        size_of_motion = size_of_motion + length.size();
    }
    for force in forces {
        by_force += force;
        size_of_force = size_of_force + force.size();
    }
    Complex::where_less(
        size_of_force,
        size_of_motion * stiffness.size(),
        by_force * stiffness.inverse(),
        by_motion,
    )
}

/// Writes every output of a plan at the angular frequencies `omega`, rad/s, from its reads and the energy.
#[inline(always)]
pub(super) fn write_outputs<A: Arithmetic>(
    plan: &Plan,
    omega: Complex<A>,
    reads: &[Complex<A>],
    energy: Real<A>,
    out: &mut [Complex<A>],
) {
    for (value, output) in out.iter_mut().zip(&plan.outputs) {
        *value = match output {
            Output::Sum(sum, None) => summed(sum, omega, reads),
            Output::Sum(sum, Some(over)) => {
                summed(sum, omega, reads) * summed(over, omega, reads).inverse()
            }
            Output::Energy => Complex::from_real(energy),
        };
    }
}

#[inline(always)]
fn summed<A: Arithmetic>(sum: &Sum, omega: Complex<A>, reads: &[Complex<A>]) -> Complex<A> {
    let mut displacement = Complex::ZERO;
    for (factor, read) in &sum.terms {
        displacement = displacement.plus_scaled(Real::splat(*factor), reads[*read]);
    }
    match sum.measure {
        Measure::Displacement => displacement,
        Measure::Velocity => {
            let turned = displacement * omega;
            Complex {
                re: -turned.im,
                im: turned.re,
            }
        }
        Measure::Acceleration => -(displacement * (omega * omega)),
    }
}

part!(
    RowOf ['a, A: Arithmetic] ['a, A]
    (&'a State<A>, &'a Plan, usize, &'a Waves<A>, Row, Part) -> Complex<A>,
    State::row_inlined
);

//! Responses at a station, at several frequencies at once.

use super::complex::Complex;
use super::number::{Arithmetic, Real, part};
use super::reflection::{Amplitudes, reach};
use super::station::CHANNELS;
use super::waves::Waves;
use crate::model::{BeamMotion, MassMotion, Measure};
use crate::solve::attachment::Attachment;
use crate::solve::beam_state::BeamState;
use crate::solve::linear::ZERO;
use crate::solve::plan::{Event, Output};

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
}

impl<A: Arithmetic> State<A> {
    pub(super) const NONE: Self = Self {
        a: [Complex::ZERO; 6],
        b: [Complex::ZERO; 6],
        forces: [Complex::ZERO; CHANNELS],
        theta: Complex::ZERO,
    };

    /// A response read at a station.
    pub(super) fn response(
        &self,
        event: &Event,
        waves: &Waves<A>,
        output: Output,
        part: Part,
    ) -> Complex<A> {
        A::outlined(Response((self, event, waves, output, part)))
    }

    #[inline(always)]
    fn response_inlined(
        (this, event, waves, output, part): (&Self, &Event, &Waves<A>, Output, Part),
    ) -> Complex<A> {
        match (output, event) {
            (
                Output::Beam {
                    motion,
                    arm,
                    measure,
                    ..
                },
                _,
            ) => {
                let mut moved = this.motion(waves, motion);
                if arm != 0.0 {
                    let twist = this.motion(waves, BeamMotion::Psi);
                    moved = moved.plus_scaled(Real::splat(arm), twist);
                }
                measured(waves.omega, moved, measure)
            }
            (
                Output::Mass {
                    motion, measure, ..
                },
                Event::Attachment(attachment),
            ) => {
                let moved = this.mass(waves, attachment, motion, part);
                measured(waves.omega, moved, measure)
            }
            _ => Complex::ZERO,
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

    /// An internal force: P (a - b), or M (a + b) for a moment.
    #[inline(always)]
    fn force(&self, waves: &Waves<A>, motion: BeamMotion) -> Complex<A> {
        let row = motion as usize;
        let mut sum = Complex::ZERO;
        for wave in 0..6 {
            let (a, b) = (self.a[wave], self.b[wave]);
            sum = if row < 3 {
                sum.plus_product(waves.force[row][wave], a - b)
            } else {
                sum.plus_product(waves.moment[row - 3][wave], a + b)
            };
        }
        sum
    }

    /// Motions and internal forces of the beam at the first frequency; no bimoment if the section has no warping stiffness.
    pub(super) fn beam(&self, waves: &Waves<A>) -> BeamState {
        BeamState {
            motion: BeamMotion::ALL.map(|motion| self.motion(waves, motion).lane(0)),
            force: BeamMotion::ALL.map(|motion| {
                if waves.without_warping && motion == BeamMotion::PsiSlope {
                    ZERO
                } else {
                    self.force(waves, motion).lane(0)
                }
            }),
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
        // A fixed motion from the waves is only rounding.
        let [w_held, psi_held, v_held] = attachment.held;
        let unheld = |is_held: bool, motion| {
            if is_held {
                Complex::ZERO
            } else {
                self.motion(waves, motion)
            }
        };
        let psi = || unheld(psi_held, BeamMotion::Psi);
        match motion {
            MassMotion::Theta => self.theta,
            MassMotion::Y => {
                let k = waves.omega.dynamic_stiffness(&attachment.spring_y);
                let mount = Real::splat(attachment.mount_z);
                let moved = unheld(w_held, BeamMotion::W).plus_scaled(mount, psi());
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
                let v = unheld(v_held, BeamMotion::V);
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

/// A displacement, its velocity or its acceleration.
#[inline(always)]
fn measured<A: Arithmetic>(
    omega: Complex<A>,
    displacement: Complex<A>,
    measure: Measure,
) -> Complex<A> {
    match measure {
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
    Response ['a, A: Arithmetic] ['a, A]
    (&'a State<A>, &'a Event, &'a Waves<A>, Output, Part) -> Complex<A>,
    State::response_inlined
);

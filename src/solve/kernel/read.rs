//! Rows at a station, and the responses that are made of them, at several frequencies at once.

use super::complex::Complex;
use super::number::{Arithmetic, Real, part};
use super::reflection::{Amplitudes, reach};
use super::station::CHANNELS;
use super::waves::Waves;
use crate::model::{BeamMotion, MassMotion, Measure};
use crate::solve::attachment::Attachment;
use crate::solve::output::{Output, Row, Sum};
use crate::solve::plan::{Event, Plan};

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

    /// A row at a station.
    pub(super) fn row(&self, event: &Event, waves: &Waves<A>, row: Row, part: Part) -> Complex<A> {
        A::outlined(RowOf((self, event, waves, row, part)))
    }

    #[inline(always)]
    fn row_inlined(
        (this, event, waves, row, part): (&Self, &Event, &Waves<A>, Row, Part),
    ) -> Complex<A> {
        match (row, event) {
            (Row::Motion(motion, arm), _) => {
                let moved = this.motion(waves, motion);
                if arm == 0.0 {
                    return moved;
                }
                let twist = this.motion(waves, BeamMotion::Psi);
                moved.plus_scaled(Real::splat(arm), twist)
            }
            (Row::Mass(motion), Event::Attachment(attachment)) => {
                this.mass(waves, attachment, motion, part)
            }
            (Row::Mass(_), _) => Complex::ZERO,
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
        let spring = |spring: &crate::model::Spring| {
            waves
                .omega
                .damped_stiffness(spring.complex_stiffness(), spring.damping)
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
                let k = spring(&attachment.spring_y);
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
                let (left, right) = (spring(&attachment.z_left), spring(&attachment.z_right));
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
            Output::Sum(sum) => summed(sum, omega, reads),
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
    (&'a State<A>, &'a Event, &'a Waves<A>, Row, Part) -> Complex<A>,
    State::row_inlined
);

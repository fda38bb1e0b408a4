//! A subsystem at several frequencies at once: its effect on a reflection.
//!
//! The unknowns and equations are those of [`crate::solve::attachment`]: the forces of the three channels, and theta.
//! Here they are solved only for the three stretches of the channels, and the shapes Q are those of the channels: the
//! radiation of a channel's force is the transpose of its stretch.

use super::complex::{Complex, Matrix};
use super::linear::{solve, solve_with_determinant};
use super::number::{Arithmetic, Real, part};
use super::product::ScaledProduct;
use super::reflection::{Amplitudes, Reflection, entry, reach};
use super::waves::Waves;
use crate::solve::attachment::{Attachment, UNKNOWNS};
use crate::solve::linear::ZERO;

/// Channels: the y springs, the sum and the difference of the z springs.
pub(super) const CHANNELS: usize = 3;

/// Index of the sum of the z springs.
const SUM: usize = 1;

/// Rows of w and v.
const W: usize = 0;
const V: usize = 2;

/// The forces of the channels: `from_waves b' + forced` for the waves b' that come from the far side.
#[derive(Debug, Clone)]
pub(super) struct Forces<A> {
    pub(super) from_waves: Matrix<A, CHANNELS, 6>,
    pub(super) forced: [Complex<A>; CHANNELS],
}

/// The same for theta.
#[derive(Debug, Clone)]
pub(super) struct Turn<A> {
    pub(super) from_waves: Amplitudes<A>,
    pub(super) forced: Complex<A>,
}

/// The stored unknowns of a subsystem.
#[derive(Debug)]
pub(super) struct Unknowns<'a, A> {
    pub(super) forces: &'a mut Forces<A>,
    pub(super) turn: Option<&'a mut Turn<A>>,
    /// The product to be multiplied by the determinant of their system, for a subsystem without loads.
    pub(super) determinant: Option<&'a mut ScaledProduct<A>>,
}

/// Stretches of the channels by each wave: w + `z_b` psi, v and `y_u` psi.
#[derive(Debug, Clone)]
pub(super) struct Stretches<A> {
    y: Amplitudes<A>,
    sum: Amplitudes<A>,
    difference: Amplitudes<A>,
    all_coupled: bool,
}

/// The stretches, without motions that a support fixes.
#[inline(always)]
pub(super) fn stretches<A: Arithmetic>(waves: &Waves<A>, attachment: &Attachment) -> Stretches<A> {
    stretches_without(waves, attachment, attachment.held)
}

/// The stretches, none of them by w, psi or v where these are left out.
#[inline(always)]
pub(super) fn stretches_without<A: Arithmetic>(
    waves: &Waves<A>,
    attachment: &Attachment,
    [w_held, psi_held, v_held]: [bool; 3],
) -> Stretches<A> {
    let mut out = Stretches {
        y: [Complex::ZERO; 6],
        sum: if v_held {
            [Complex::ZERO; 6]
        } else {
            waves.displacement[2]
        },
        difference: [Complex::ZERO; 6],
        all_coupled: waves.all_coupled,
    };
    let (z, y) = (
        Real::splat(attachment.mount_z),
        Real::splat(attachment.mount_y),
    );
    let moving = if waves.all_coupled { 6 } else { 4 };
    for wave in 0..moving {
        let (mut w, mut psi) = (waves.displacement[0][wave], waves.displacement[1][wave]);
        if w_held {
            w = Complex::ZERO;
        }
        if psi_held {
            psi = Complex::ZERO;
        }
        out.y[wave] = w.plus_scaled(z, psi);
        out.difference[wave] = psi.scaled(y);
    }
    out
}

/// The springs, the mass and the arms of a subsystem.
#[derive(Debug, Clone, Copy)]
struct Springs<A> {
    y: Complex<A>,
    sum: Complex<A>,
    difference: Complex<A>,
    /// 1 / (omega^2 m).
    by_mass: Complex<A>,
    /// h and l.
    arms: [Real<A>; 2],
    /// The size of the longer one.
    longest: Real<A>,
    /// omega^2 J.
    inertia: Complex<A>,
    /// The stiffness that scales theta to a force, N/rad.
    to_force: Real<A>,
    /// Nothing turns the mass.
    is_idle: bool,
}

impl<A: Arithmetic> Springs<A> {
    #[inline(always)]
    fn new(omega: Complex<A>, attachment: &Attachment) -> Self {
        let square = omega * omega;
        // Sum and difference in the kernel's numbers: rounded on their own, they would not belong to the same springs.
        let left = omega.dynamic_stiffness(&attachment.z_left);
        let right = omega.dynamic_stiffness(&attachment.z_right);
        let sum = left + right;
        let half_left = Real::splat(0.5 * attachment.arm_left);
        let half_right = Real::splat(0.5 * attachment.arm_right);
        let arms = [half_right - half_left, half_right + half_left];
        let longest = arms[0].abs().max(arms[1].abs());
        let torque = sum.size() * longest;
        Self {
            y: omega.dynamic_stiffness(&attachment.spring_y),
            sum,
            difference: right - left,
            by_mass: square.scaled(Real::splat(attachment.mass)).inverse(),
            arms,
            longest,
            inertia: square.scaled(Real::splat(attachment.inertia)),
            to_force: Real::ZERO.where_less(torque, torque, Real::ONE),
            is_idle: !attachment.can_turn,
        }
    }

    /// The forces of the channels for given stretches.
    #[inline(always)]
    fn times(&self, stretch: [Complex<A>; CHANNELS]) -> [Complex<A>; CHANNELS] {
        [
            self.y * stretch[0],
            (self.sum * stretch[1]).plus_product(self.difference, stretch[2]),
            (self.difference * stretch[1]).plus_product(self.sum, stretch[2]),
        ]
    }
}

/// Columns of the waves that stretch a channel.
#[inline(always)]
const fn waves_of<const ALL: bool>(channel: usize) -> (usize, usize) {
    reach::<ALL>(if channel == SUM { V } else { W })
}

/// sum + stretch a. Without coupling v of both its waves is 1, or 0 if it is fixed.
#[inline(always)]
fn stretched_by<A: Arithmetic, const ALL: bool>(
    sum: Complex<A>,
    channel: usize,
    stretch: Complex<A>,
    a: Complex<A>,
) -> Complex<A> {
    if !ALL && channel == SUM {
        sum.plus_scaled(stretch.re, a)
    } else {
        sum.plus_product(stretch, a)
    }
}

/// The beam where a subsystem is attached.
struct Contact<A> {
    /// Stretches per b'.
    moved: Matrix<A, CHANNELS, 6>,
    /// Stretches without incoming waves.
    still: [Complex<A>; CHANNELS],
    /// Stretches per force of the channels; symmetric.
    receptance: Matrix<A, CHANNELS, CHANNELS>,
}

impl<A: Arithmetic> Contact<A> {
    #[inline(always)]
    fn new<const ALL: bool>(waves: &Waves<A>, attachment: &Attachment, at: &Reflection<A>) -> Self {
        let stretches = stretches(waves, attachment);
        let mut contact = Self {
            moved: [[Complex::ZERO; 6]; CHANNELS],
            still: [Complex::ZERO; CHANNELS],
            receptance: [[Complex::ZERO; CHANNELS]; CHANNELS],
        };
        let by = [&stretches.y, &stretches.sum, &stretches.difference];
        for channel in 0..CHANNELS {
            let (from, to) = waves_of::<ALL>(channel);
            for column in 0..6 {
                let mut sum = Complex::ZERO;
                if column >= from && column < to {
                    sum = by[channel][column] * waves.radiation[column];
                }
                for wave in from..to {
                    let r = at.r[entry(wave, column)];
                    sum = stretched_by::<A, ALL>(sum, channel, by[channel][wave], r);
                }
                contact.moved[channel][column] = sum;
            }
            for wave in from..to {
                let still = contact.still[channel];
                contact.still[channel] =
                    stretched_by::<A, ALL>(still, channel, by[channel][wave], at.s[wave]);
            }
        }
        for one in 0..CHANNELS {
            for other in one..CHANNELS {
                // The channel with the fewest waves.
                let (moved, channel) = if other == 1 { (one, 1) } else { (other, one) };
                let (from, to) = waves_of::<ALL>(channel);
                let mut total = Complex::ZERO;
                for wave in from..to {
                    let of = contact.moved[moved][wave];
                    total = stretched_by::<A, ALL>(total, channel, by[channel][wave], of);
                }
                contact.receptance[one][other] = total;
                contact.receptance[other][one] = total;
            }
        }
        contact
    }

    /// An unknown as a function of b', from the stretches and the loads.
    #[inline(always)]
    fn unknown(
        &self,
        (by_stretch, by_load): (&[Complex<A>; CHANNELS], Complex<A>),
    ) -> (Amplitudes<A>, Complex<A>) {
        let mut from_waves = [Complex::ZERO; 6];
        let mut forced = by_load;
        for wave in 0..6 {
            let mut sum = by_stretch[0] * self.moved[0][wave];
            for channel in 1..CHANNELS {
                sum = sum.plus_product(by_stretch[channel], self.moved[channel][wave]);
            }
            from_waves[wave] = sum;
        }
        for channel in 0..CHANNELS {
            forced = forced.plus_product(by_stretch[channel], self.still[channel]);
        }
        (from_waves, forced)
    }
}

impl<A: Arithmetic> Reflection<A> {
    /// Over a subsystem.
    pub(super) fn attach(
        &mut self,
        waves: &Waves<A>,
        attachment: &Attachment,
        unknowns: Unknowns<A>,
    ) {
        if waves.all_coupled {
            A::outlined(Attach::<A, true>((self, waves, attachment, unknowns)));
        } else {
            A::outlined(Attach::<A, false>((self, waves, attachment, unknowns)));
        }
    }

    #[inline(always)]
    fn attach_inlined<const ALL: bool>(
        (this, waves, attachment, wanted): (&mut Self, &Waves<A>, &Attachment, Unknowns<A>),
    ) {
        let Unknowns {
            forces,
            turn,
            determinant,
        } = wanted;
        let contact = Contact::new::<ALL>(waves, attachment, this);
        let springs = Springs::new(waves.omega, attachment);
        let (by_stretch, by_load) =
            unknowns(&springs, attachment, &contact.receptance, determinant);
        for channel in 0..CHANNELS {
            let of = (&by_stretch[channel], by_load[channel]);
            (forces.from_waves[channel], forces.forced[channel]) = contact.unknown(of);
        }
        if let Some(turn) = turn {
            let of = (&by_stretch[CHANNELS], by_load[CHANNELS]);
            (turn.from_waves, turn.forced) = contact.unknown(of);
        }
        for row in 0..6 {
            for channel in 0..CHANNELS {
                let moved = contact.moved[channel][row];
                for column in row..6 {
                    let at = entry(row, column);
                    this.r[at] = this.r[at].plus_product(moved, forces.from_waves[channel][column]);
                }
                this.s[row] = this.s[row].plus_product(moved, forces.forced[channel]);
            }
        }
    }
}

/// The unknowns per stretch of the channels, and for the loads on the mass.
#[inline(always)]
fn unknowns<A: Arithmetic>(
    springs: &Springs<A>,
    attachment: &Attachment,
    receptance: &Matrix<A, CHANNELS, CHANNELS>,
    determinant: Option<&mut ScaledProduct<A>>,
) -> (Matrix<A, UNKNOWNS, CHANNELS>, [Complex<A>; UNKNOWNS]) {
    let mut out = [[Complex::ZERO; CHANNELS]; UNKNOWNS];
    let mut forced = [Complex::ZERO; UNKNOWNS];
    if attachment.load == [ZERO; 3] {
        let (mut a, scale) = system(springs, receptance);
        let mut b = stretched::<A, CHANNELS>(springs, &scale);
        match determinant {
            Some(product) => {
                let scaled = solve_with_determinant(&mut a, &mut b);
                multiply_unscaled(product, scaled, springs, &scale);
            }
            None => solve(&mut a, &mut b),
        }
        out = b;
    } else {
        const WITH_LOAD: usize = CHANNELS + 1;
        let (mut a, scale) = system(springs, receptance);
        let mut b = stretched::<A, WITH_LOAD>(springs, &scale);
        let by_load = |load| Complex::splat(load) * springs.by_mass;
        let pulled = springs.times([
            by_load(attachment.load[0]),
            by_load(attachment.load[1]),
            Complex::ZERO,
        ]);
        for channel in 0..CHANNELS {
            b[channel][CHANNELS] = pulled[channel].scaled(scale[channel]);
        }
        if !springs.is_idle {
            b[CHANNELS][CHANNELS] = -Complex::splat(attachment.load[2]).scaled(scale[CHANNELS]);
        }
        solve(&mut a, &mut b);
        for unknown in 0..UNKNOWNS {
            for channel in 0..CHANNELS {
                out[unknown][channel] = b[unknown][channel];
            }
            forced[unknown] = b[unknown][CHANNELS];
        }
    }
    // The last unknown is theta times a stiffness.
    let to_angle = Real::ONE / springs.to_force;
    for channel in 0..CHANNELS {
        out[CHANNELS][channel] = out[CHANNELS][channel].scaled(to_angle);
    }
    forced[CHANNELS] = forced[CHANNELS].scaled(to_angle);
    (out, forced)
}

/// The matrix of the unknowns: for each channel the force against its stretch, and the balance of theta; and the powers
/// of two that scale its rows to comparable size.
#[inline(always)]
fn system<A: Arithmetic>(
    springs: &Springs<A>,
    receptance: &Matrix<A, CHANNELS, CHANNELS>,
) -> (Matrix<A, UNKNOWNS, UNKNOWNS>, [Real<A>; UNKNOWNS]) {
    let mut flexibility = *receptance;
    flexibility[0][0] += springs.by_mass;
    flexibility[1][1] += springs.by_mass;
    let stiffest = [springs.y, springs.sum, springs.sum];
    let mut scale = [Real::ONE; UNKNOWNS];
    for channel in 0..CHANNELS {
        let own = flexibility[channel][channel].size();
        let size = stiffest[channel].size().multiply_add(own, Real::ONE);
        scale[channel] = size.inverse_power_of_two();
    }
    let mut a = [[Complex::ZERO; UNKNOWNS]; UNKNOWNS];
    for column in 0..CHANNELS {
        let pulled = springs.times([
            flexibility[0][column],
            flexibility[1][column],
            flexibility[2][column],
        ]);
        for channel in 0..CHANNELS {
            a[channel][column] = -pulled[channel].scaled(scale[channel]);
        }
        a[column][column].re = a[column][column].re + scale[column];
    }
    // omega^2 J theta + h g_sum + l g_difference = -load, or theta = 0 where nothing turns the mass.
    if springs.is_idle {
        a[CHANNELS][CHANNELS] = Complex::ONE;
        return (a, scale);
    }
    let arms = springs.arms;
    let (sum, difference) = (springs.sum, springs.difference);
    let to_angle = Real::ONE / springs.to_force;
    let pulled = [
        sum.scaled(arms[0]).plus_scaled(arms[1], difference),
        difference.scaled(arms[0]).plus_scaled(arms[1], sum),
    ];
    a[1][CHANNELS] = pulled[0].scaled(scale[1] * to_angle);
    a[2][CHANNELS] = pulled[1].scaled(scale[2] * to_angle);
    let inertia = springs.inertia.scaled(to_angle);
    scale[CHANNELS] = inertia.size().max(springs.longest).inverse_power_of_two();
    a[CHANNELS][1] = Complex::from_real(arms[0] * scale[CHANNELS]);
    a[CHANNELS][2] = Complex::from_real(arms[1] * scale[CHANNELS]);
    a[CHANNELS][CHANNELS] = inertia.scaled(scale[CHANNELS]);
    (a, scale)
}

/// Multiplies a product by the determinant of [`system`] without its scales.
#[inline(always)]
fn multiply_unscaled<A: Arithmetic>(
    product: &mut ScaledProduct<A>,
    determinant: Complex<A>,
    springs: &Springs<A>,
    scale: &[Real<A>; UNKNOWNS],
) {
    product.times(determinant);
    let mut unscaled = Real::ONE;
    for by in scale {
        unscaled = unscaled * *by;
    }
    let to_force = if springs.is_idle {
        Real::ONE
    } else {
        springs.to_force
    };
    product.times(Complex::from_real(to_force / unscaled));
}

/// The right-hand sides for unit stretches, in the first three columns.
#[inline(always)]
fn stretched<A: Arithmetic, const R: usize>(
    springs: &Springs<A>,
    scale: &[Real<A>; UNKNOWNS],
) -> Matrix<A, UNKNOWNS, R> {
    let mut b = [[Complex::ZERO; R]; UNKNOWNS];
    b[0][0] = springs.y.scaled(scale[0]);
    b[1][1] = springs.sum.scaled(scale[1]);
    b[1][2] = springs.difference.scaled(scale[1]);
    b[2][1] = springs.difference.scaled(scale[2]);
    b[2][2] = springs.sum.scaled(scale[2]);
    b
}

impl<A: Arithmetic> Forces<A> {
    pub(super) const NONE: Self = Self {
        from_waves: [[Complex::ZERO; 6]; CHANNELS],
        forced: [Complex::ZERO; CHANNELS],
    };

    /// The forces for waves b' from the far side, with or without loads.
    #[inline(always)]
    pub(super) fn part(&self, b: &Amplitudes<A>, is_forced: bool) -> [Complex<A>; CHANNELS] {
        let mut out = if is_forced {
            self.forced
        } else {
            [Complex::ZERO; CHANNELS]
        };
        for channel in 0..CHANNELS {
            for wave in 0..6 {
                out[channel] = out[channel].plus_product(self.from_waves[channel][wave], b[wave]);
            }
        }
        out
    }
}

impl<A: Arithmetic> Turn<A> {
    pub(super) const NONE: Self = Self {
        from_waves: [Complex::ZERO; 6],
        forced: Complex::ZERO,
    };

    /// Theta for waves b' from the far side, with or without loads.
    #[inline(always)]
    pub(super) fn part(&self, b: &Amplitudes<A>, is_forced: bool) -> Complex<A> {
        let mut out = if is_forced {
            self.forced
        } else {
            Complex::ZERO
        };
        for wave in 0..6 {
            out = out.plus_product(self.from_waves[wave], b[wave]);
        }
        out
    }
}

/// The radiation of the channel forces in both directions, before N.
#[inline(always)]
pub(super) fn sent<A: Arithmetic>(
    stretches: &Stretches<A>,
    forces: &[Complex<A>; CHANNELS],
) -> Amplitudes<A> {
    let mut out = [Complex::ZERO; 6];
    for wave in 0..6 {
        if stretches.all_coupled || wave < 4 {
            out[wave] =
                (stretches.y[wave] * forces[0]).plus_product(stretches.difference[wave], forces[2]);
        }
        if stretches.all_coupled {
            out[wave] = out[wave].plus_product(stretches.sum[wave], forces[SUM]);
        } else if wave >= 4 {
            out[wave] = forces[SUM].scaled(stretches.sum[wave].re);
        }
    }
    out
}

part!(
    Attach ['a, A: Arithmetic, const ALL: bool] ['a, A, ALL]
    (&'a mut Reflection<A>, &'a Waves<A>, &'a Attachment, Unknowns<'a, A>) -> (),
    Reflection::attach_inlined::<ALL>
);

//! The characteristic function of a model at several complex frequencies at once.
//!
//! The same entire function of omega as in [`crate::solve::modes`], which explains it, up to a constant factor: `F =
//! det(left) det(right) prod(det(support)) prod(det(joint)) prod(det Z)
//! prod(omega^4 det(station)) exp(sum kappa l)`, with Z of each junction. The determinant of the right end is that for b' =
//! N^-1 b, so it is already divided by `det[Q; M] det[S; P]`, the product of the entries of N^-1.

use super::action::{Acting, Actions};
use super::complex::Complex;
use super::elementary::decay;
use super::ends::{reflection_with, right_determinant};
use super::number::{Arithmetic, Real, part};
use super::product::ScaledProduct;
use super::recursion::{Prepared, Room};
use super::reflection::Side;
use super::station::{Forces, Unknowns};
use crate::solve::linear::Magnified;
use crate::solve::plan::{Event, SpanKind};

impl<A: Arithmetic> Room<A> {
    /// Writes F at the angular frequencies `omega`, rad/s; its logarithm is minus infinity if F is zero, and NaN if it cannot
    /// be computed.
    pub(super) fn characteristic(
        &mut self,
        prepared: &Prepared,
        omega: Complex<A>,
        out: &mut [Magnified],
    ) {
        A::outlined(Write((self, prepared, omega, out)));
    }

    #[inline(always)]
    fn characteristic_inlined(
        (this, prepared, omega, out): (&mut Self, &Prepared, Complex<A>, &mut [Magnified]),
    ) {
        let plan = &prepared.plan;
        let last = plan.stations.len();
        let mut all = std::mem::take(&mut this.waves);
        prepared.set_waves(&mut all, omega, 0..=last);
        this.prepare_spans(prepared, &all, 0..=last);
        let mut product = ScaledProduct::ONE;
        let square = omega * omega;
        let fourth = square * square;
        let mut forces = Forces::NONE;
        let mut actions = Actions::NONE;
        let first = prepared.waves_of(&all, 0);
        let mut at = reflection_with(first, &plan.left, Side::Left, Some(&mut product));
        for (index, station) in plan.stations.iter().enumerate() {
            let waves = prepared.waves_of(&all, index);
            at.propagate(&this.decays[plan.spans[index]]);
            match &station.event {
                Event::Attachment(attachment) => {
                    let unknowns = Unknowns {
                        forces: &mut forces,
                        turn: None,
                        determinant: Some(&mut product),
                    };
                    at.attach(waves, attachment, unknowns);
                    product.times(fourth);
                }
                Event::Support(held) => {
                    let acting = (Acting::Support(held), Side::Left);
                    at.act(waves, acting, &mut actions, Some(&mut product));
                }
                Event::Joint(joined) => {
                    let acting = (Acting::Joint(joined), Side::Left);
                    at.act(waves, acting, &mut actions, Some(&mut product));
                }
                Event::Junction(_) => {
                    let beyond = prepared.waves_of(&all, index + 1);
                    at.cross([waves, beyond], &mut actions, Some(&mut product));
                }
                Event::Load(_) | Event::Gap(_) | Event::Probe => {}
            }
        }
        at.propagate(&this.decays[plan.last_span()]);
        let waves = prepared.waves_of(&all, last);
        right_determinant(waves, &plan.right, &at, &mut product);
        let mut growth = Complex::ZERO;
        for &span in &plan.spans {
            let SpanKind { length, beam } = plan.kinds[span];
            let mut of_span = Complex::ZERO;
            for kappa in all[beam].kappa {
                of_span += kappa;
            }
            growth = growth.plus_scaled(Real::splat(length), of_span);
        }
        this.waves = all;
        product.times(decay(Real::ZERO, -growth.im));
        product.write(growth.re, out);
    }
}

part!(
    Write ['a, A: Arithmetic] ['a, A]
    (&'a mut Room<A>, &'a Prepared, Complex<A>, &'a mut [Magnified]) -> (),
    Room::characteristic_inlined
);

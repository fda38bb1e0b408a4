//! The characteristic function of a model at several complex frequencies at once.
//!
//! The same entire function of omega as in [`crate::solve::modes`], which explains it, up to a constant factor: `F =
//! det(left) det(right) prod(det(support)) prod(det(joint)) prod(omega^4 det(station)) exp(L sum kappa)`. The determinant of the right end is that for b' =
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
use super::waves::Waves;
use crate::solve::linear::Magnified;
use crate::solve::plan::Event;

impl<A: Arithmetic> Room<A> {
    /// Writes F for some waves; its logarithm is minus infinity if F is zero, and NaN if it cannot be computed.
    pub(super) fn characteristic(
        &mut self,
        prepared: &Prepared,
        waves: &Waves<A>,
        out: &mut [Magnified],
    ) {
        A::outlined(Write((self, prepared, waves, out)));
    }

    #[inline(always)]
    fn characteristic_inlined(
        (this, prepared, waves, out): (&mut Self, &Prepared, &Waves<A>, &mut [Magnified]),
    ) {
        let plan = &prepared.plan;
        this.prepare_spans(plan, waves);
        let mut product = ScaledProduct::ONE;
        let square = waves.omega * waves.omega;
        let fourth = square * square;
        let mut forces = Forces::NONE;
        let mut actions = Actions::NONE;
        let mut at = reflection_with(waves, &plan.left, Side::Left, Some(&mut product));
        for (station, &span) in plan.stations.iter().zip(&plan.spans) {
            at.propagate(&this.decays[span]);
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
                Event::Load(_) | Event::Probe => {}
            }
        }
        at.propagate(&this.decays[plan.last_span()]);
        right_determinant(waves, &plan.right, &at, &mut product);
        let mut growth = Complex::ZERO;
        for kappa in waves.kappa {
            growth += kappa;
        }
        let length = plan.spans.iter().map(|&span| plan.lengths[span]).sum();
        let growth = growth.scaled(Real::splat(length));
        product.times(decay(Real::ZERO, -growth.im));
        product.write(growth.re, out);
    }
}

part!(
    Write ['a, A: Arithmetic] ['a, A]
    (&'a mut Room<A>, &'a Prepared, &'a Waves<A>, &'a mut [Magnified]) -> (),
    Room::characteristic_inlined
);

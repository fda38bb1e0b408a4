//! What the supports exert on the beam.

use num_complex::Complex64;

use super::along::Along;
use crate::model::BeamMotion;
use crate::solve::linear::ZERO;
use crate::solve::local::Local;
use crate::solve::plan::End;
use crate::solve::springs::restraint_stiffness;

/// Of the left and of the right support, along the six motions.
pub(super) fn reactions(along: &Along<'_>) -> [[Complex64; 6]; 2] {
    let [left, right] = along.ends().map(|spot| along.at(spot));
    [
        reaction(along, &along.plan.left, &left, -1.0),
        reaction(along, &along.plan.right, &right, 1.0),
    ]
}

/// Of one support; `outward` is the sign with which the internal forces balance what acts on the end.
fn reaction(along: &Along<'_>, end: &End, local: &Local, outward: f64) -> [Complex64; 6] {
    BeamMotion::ALL.map(|motion| {
        let row = motion as usize;
        // Without warping stiffness no bimoment reaches a support.
        if motion == BeamMotion::PsiSlope && along.plan.beam.without_warping() {
            return ZERO;
        }
        match restraint_stiffness(along.omega.into(), end.support[motion]) {
            None => outward * local.force[row] - end.load[row],
            Some(k) if k == ZERO => ZERO,
            Some(k) => -k * local.motion[row],
        }
    })
}

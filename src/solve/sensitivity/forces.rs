//! The forces of a model: their positions, and their contributions to the derivatives of a response.

use num_complex::Complex64;

use super::field::{Field, Reader};
use crate::model::schema::ForceKey;
use crate::model::{BeamMotion, Model, Place, Target};
use crate::solve::linear::ZERO;
use crate::solve::plan::Plan;

/// An enabled force.
#[derive(Debug)]
pub(super) struct Force {
    site: Site,
    /// The arm, m, by which a force on the beam also turns it.
    arm: f64,
    amplitude: f64,
    /// Degrees.
    phase: f64,
}

/// The position of a force.
#[derive(Debug)]
enum Site {
    /// On an end of the beam: 0 left, 1 right; the right one moves with the length if the model says `right`.
    End {
        end: usize,
        motion: BeamMotion,
        stays: bool,
    },
    /// On the beam between its ends, m from the left end.
    Beam { x: f64, motion: BeamMotion },
    /// On the enabled subsystem with this index, along y, z or theta.
    Mass { index: usize, motion: usize },
    /// On a subsystem that is not attached.
    Nowhere,
}

impl Force {
    /// The enabled forces.
    pub(super) fn all(model: &Model) -> Vec<Self> {
        let names: std::collections::HashMap<&str, usize> = model
            .attached()
            .enumerate()
            .map(|(index, subsystem)| (&*subsystem.name, index))
            .collect();
        let enabled = model.forces.iter().filter(|force| force.enabled);
        let force = |force: &crate::model::Force| {
            let (site, arm) = match &force.target {
                Target::Mass(name, motion) => {
                    let found = names.get(name.as_str());
                    let site = found.map_or(Site::Nowhere, |&index| {
                        let motion = *motion as usize;
                        Site::Mass { index, motion }
                    });
                    (site, 0.0)
                }
                Target::Beam(place, motion) => (
                    on_beam(*place, *motion, model.length()),
                    force.point.arm(*motion).unwrap_or_default(),
                ),
            };
            Self {
                site,
                arm,
                amplitude: force.amplitude,
                phase: force.phase,
            }
        };
        enabled.map(force).collect()
    }

    /// Its complex amplitude.
    fn value(&self) -> Complex64 {
        Complex64::from_polar(self.amplitude, self.phase.to_radians())
    }

    /// `lambda^T dF/dp` for the point, if it has one, the amplitude, and the phase in degrees; `reader` reads lambda.
    pub(super) fn by_parameter(
        &self,
        plan: &Plan,
        lambda: &Field,
        reader: &Reader<'_>,
    ) -> impl Iterator<Item = Complex64> {
        let twist = BeamMotion::Psi as usize;
        let of_beam = |motions: [Complex64; 6], motion: BeamMotion| {
            let moved = motions[motion as usize] + self.arm * motions[twist];
            (moved, motions[twist])
        };
        let (moved, turned) = match self.site {
            Site::End { end, motion, .. } => of_beam(lambda.ends[end], motion),
            Site::Beam { x, motion } => of_beam(reader.end(plan.span_at(x)).motion, motion),
            Site::Mass { index, motion } => (lambda.masses[index].motion[motion], ZERO),
            Site::Nowhere => (ZERO, ZERO),
        };
        let unit = Complex64::from_polar(1.0, self.phase.to_radians());
        let a_degree = Complex64::I * 1.0_f64.to_radians();
        let turned = turned * self.value();
        // The arm along w is z, along v -y; no other load has a point.
        let (by_y, by_z) = match self.site {
            Site::End { motion, .. } | Site::Beam { motion, .. } => match motion {
                BeamMotion::W => (None, Some(turned)),
                BeamMotion::V => (Some(-turned), None),
                BeamMotion::Psi
                | BeamMotion::WSlope
                | BeamMotion::PsiSlope
                | BeamMotion::VSlope => (None, None),
            },
            Site::Mass { .. } | Site::Nowhere => (None, None),
        };
        let by = move |key| match key {
            ForceKey::Enabled | ForceKey::At | ForceKey::Direction => None,
            ForceKey::Y => by_y,
            ForceKey::Z => by_z,
            ForceKey::Amplitude => Some(moved * unit),
            ForceKey::Phase => Some(moved * unit * self.amplitude * a_degree),
        };
        ForceKey::ALL.into_iter().filter_map(by)
    }
}

/// The sum of the forces whose position is constant while the right end moves.
pub(super) fn held(forces: &[Force]) -> [Complex64; 6] {
    let mut sum = [ZERO; 6];
    for force in forces {
        if let Site::End {
            end: 1,
            motion,
            stays: true,
        } = force.site
        {
            sum[motion as usize] += force.value();
            sum[BeamMotion::Psi as usize] += force.arm * force.value();
        }
    }
    sum
}

fn on_beam(place: Place, motion: BeamMotion, length: f64) -> Site {
    let end = |end: usize, stays: bool| Site::End { end, motion, stays };
    match place {
        Place::Left | Place::Position(0.0) => end(0, false),
        Place::Right => end(1, false),
        Place::Position(x) if x == length => end(1, true),
        Place::Position(x) => Site::Beam { x, motion },
    }
}

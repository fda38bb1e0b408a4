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
        let site = |target: &Target| match target {
            Target::Mass(name, motion) => {
                names.get(name.as_str()).map_or(Site::Nowhere, |&index| {
                    let motion = *motion as usize;
                    Site::Mass { index, motion }
                })
            }
            Target::Beam(place, motion) => on_beam(*place, *motion, model.beam.length),
        };
        let enabled = model.forces.iter().filter(|force| force.enabled);
        enabled
            .map(|force| Self {
                site: site(&force.target),
                amplitude: force.amplitude,
                phase: force.phase,
            })
            .collect()
    }

    /// `lambda^T dF/dp` for the amplitude, and for the phase in degrees; `reader` reads lambda.
    pub(super) fn by_parameter(
        &self,
        plan: &Plan,
        lambda: &Field,
        reader: &Reader<'_>,
    ) -> impl Iterator<Item = Complex64> {
        let moved = match self.site {
            Site::End { end, motion, .. } => lambda.ends[end][motion as usize],
            Site::Beam { x, motion } => {
                let station = plan.stations.partition_point(|other| other.position < x);
                reader.end(station).motion[motion as usize]
            }
            Site::Mass { index, motion } => lambda.masses[index].motion[motion],
            Site::Nowhere => ZERO,
        };
        let unit = Complex64::from_polar(1.0, self.phase.to_radians());
        let a_degree = Complex64::I * 1.0_f64.to_radians();
        let by = move |key| match key {
            ForceKey::Enabled | ForceKey::At | ForceKey::Direction => None,
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
            sum[motion as usize] +=
                Complex64::from_polar(force.amplitude, force.phase.to_radians());
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

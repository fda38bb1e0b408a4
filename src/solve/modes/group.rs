//! Groups of modes with equal or nearly equal roots, which are computed together.

use num_complex::Complex64;

use super::eigenspace::{Circle, isolating_loads};
use super::is_hysteretic;
use super::loads::loads;
use super::neighbours::{neighbours, with_images};
use super::types::{Mode, ModeKind, Modes};
use crate::model::{Force, Model};

/// Modes closer than this (relative) are in one group.
const CLOSE: f64 = 1e-5;

/// A group of modes of a list.
#[derive(Debug, Clone)]
pub(in crate::solve) struct Group {
    /// The roots, rad/s. They may include mirror images and modes that are only near the members.
    pub(in crate::solve) roots: Vec<Complex64>,
    /// The modes of the group by their indices in the list, ascending, each with the index of its root. Each of them
    /// has this same group.
    pub(in crate::solve) members: Vec<(usize, usize)>,
    /// Distance of the mean of the roots to the next other root, rad/s.
    pub(in crate::solve) gap: f64,
}

impl Group {
    /// The group of the mode `index` of a list; not for a rigid-body mode.
    pub(in crate::solve) fn of(model: &Model, modes: &Modes, index: usize) -> Self {
        let rigid = rigid_modes(modes);
        let moving = &modes.modes[rigid..];
        let listed: Vec<Complex64> = moving
            .iter()
            .chain(&modes.beyond)
            .map(|mode| mode.omega)
            .collect();
        let all = with_images(&listed, is_hysteretic(model));
        let near = neighbours(&all, index - rigid, CLOSE);
        let own = near.close.iter().filter(|&&place| place < moving.len());
        Self {
            roots: near.members.iter().map(|&place| all[place]).collect(),
            members: own
                .map(|&place| {
                    (
                        place + rigid,
                        near.members.partition_point(|&of| of < place),
                    )
                })
                .collect(),
            gap: near.gap,
        }
    }

    /// A circle around its roots only.
    pub(super) fn circle(&self) -> Circle {
        Circle::around(&self.roots, self.gap)
    }

    /// For each root loads that excite its mode and no other one of the group; `None` if noise hides their differences.
    pub(in crate::solve) fn isolating_loads(&self, model: &Model) -> Option<Vec<Vec<Force>>> {
        if self.roots.len() == 1 {
            return Some(vec![loads(model, 0)]);
        }
        isolating_loads(model, self.circle(), &self.roots)
    }
}

/// The number of rigid-body modes of a list, which are its first.
pub(super) fn rigid_modes(modes: &Modes) -> usize {
    let is_rigid = |mode: &&Mode| mode.kind == ModeKind::RigidBody;
    modes.modes.iter().take_while(is_rigid).count()
}

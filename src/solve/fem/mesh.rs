//! Nodes and the numbers of their unknowns.

use crate::model::{BeamMotion, Subsystem};
use crate::solve::layout::Layout;

/// The number of an unknown; `None` if a support fixes the motion.
pub(super) type Unknown = Option<usize>;

/// A node: the numbers of (w, psi, v, w', psi', v') for the elements on its two sides.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) of_left_element: [Unknown; 6],
    /// Differs only in psi', and only without warping stiffness: a torque makes the rate of twist jump there.
    pub(super) of_right_element: [Unknown; 6],
}

/// The numbered mesh.
#[derive(Debug, Clone)]
pub(super) struct Mesh {
    pub(super) unknowns: usize,
    pub(super) nodes: Vec<Node>,
    /// The span of each element, by ascending x.
    pub(super) spans: Vec<usize>,
    /// The node of each position of the layout.
    pub(super) places: Vec<usize>,
    /// The numbers of (y, z, theta) of each subsystem of the layout.
    pub(super) masses: Vec<[Unknown; 3]>,
}

impl Mesh {
    /// Numbers the unknowns along x, those of each mass right after its node's, so that the matrix is a narrow band.
    pub(super) fn new(layout: &Layout, divisions: &[usize]) -> Self {
        let mut mesh = Self {
            unknowns: 0,
            nodes: Vec::new(),
            spans: Vec::new(),
            places: Vec::new(),
            masses: Vec::new(),
        };
        for place in 0..layout.positions.len() {
            mesh.places.push(mesh.nodes.len());
            mesh.add_place(layout, place);
            if let Some(&elements) = divisions.get(place) {
                mesh.spans.extend(std::iter::repeat_n(place, elements));
                for _ in 1..elements {
                    let numbers = BeamMotion::ALL.map(|_| Some(mesh.next()));
                    mesh.nodes.push(Node {
                        of_left_element: numbers,
                        of_right_element: numbers,
                    });
                }
            }
        }
        mesh
    }

    fn next(&mut self) -> usize {
        self.unknowns += 1;
        self.unknowns - 1
    }

    fn add_place(&mut self, layout: &Layout, place: usize) {
        let support = layout.support(place);
        let numbers = BeamMotion::ALL.map(|motion| {
            // A restraint of psi' of a section without warping stiffness acts over a length of 0 and does not affect
            // the twist next to it, so the cubic's slope stays free. (Fixing it would reduce the order of convergence.)
            let unknown_to_elements = motion == BeamMotion::PsiSlope && layout.without_warping();
            let held = support.is_some_and(|support| layout.holds(support, motion));
            (unknown_to_elements || !held).then(|| self.next())
        });
        let mut of_right_element = numbers;
        if layout.without_warping() && support.is_none() {
            of_right_element[BeamMotion::PsiSlope as usize] = Some(self.next());
        }
        self.nodes.push(Node {
            of_left_element: numbers,
            of_right_element,
        });
        for mass in layout.masses.iter().filter(|mass| mass.place == place) {
            let turns = can_turn(mass.subsystem);
            let numbers = [
                Some(self.next()),
                Some(self.next()),
                turns.then(|| self.next()),
            ];
            self.masses.push(numbers);
        }
    }
}

/// Whether the rotation of a mass has an inertia, or a z spring or damper on an arm. Otherwise theta has no equation,
/// and is 0.
fn can_turn(subsystem: &Subsystem) -> bool {
    let turned = |spring: crate::model::Spring, arm: f64| {
        arm != 0.0 && (spring.stiffness != 0.0 || spring.damping != 0.0)
    };
    subsystem.inertia != 0.0
        || turned(subsystem.z_left, subsystem.arm_left)
        || turned(subsystem.z_right, subsystem.arm_right)
}

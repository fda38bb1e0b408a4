//! Nodes and the numbers of their unknowns.

use crate::model::{BeamMotion, Restraint};
use crate::solve::layout::Layout;

/// A motion as an unknown times a factor; `None` if a support fixes it.
pub(super) type Unknown = Option<Dof>;

/// An unknown times a factor: 1, but where a support fixes w or v off the axis, which then follows the twist.
#[derive(Debug, Clone, Copy)]
pub(super) struct Dof {
    /// The number of the unknown.
    pub(super) number: usize,
    pub(super) factor: f64,
}

/// A node: the numbers of (w, psi, v, w', psi', v') for the elements on its two sides and for what acts on it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// Differs from the next only in the motions that a joint releases, and in psi' without warping stiffness left of it: a
    /// torque or the end of a part makes the rate of twist jump there.
    pub(super) of_left_element: [Unknown; 6],
    /// For supports, masses, loads and responses: right of a joint.
    pub(super) acted_on: [Unknown; 6],
    /// Differs from the one before only in psi', and only where a part with warping stiffness meets one without it.
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
                        acted_on: numbers,
                        of_right_element: numbers,
                    });
                }
            }
        }
        mesh
    }

    fn next(&mut self) -> Dof {
        self.unknowns += 1;
        Dof {
            number: self.unknowns - 1,
            factor: 1.0,
        }
    }

    fn add_place(&mut self, layout: &Layout, place: usize) {
        let fixed = |motion| {
            let supports = layout.supports_at(place);
            supports.filter(move |support| support[motion] == Restraint::Fixed)
        };
        // w or v fixed at two points of the section is also the twist.
        let turned_by = |motion| {
            let mut arms = fixed(motion).filter_map(move |support| support.point.arm(motion));
            let first = arms.next();
            (first, arms.any(|arm| Some(arm) != first))
        };
        let (arm_w, at_two_points) = turned_by(BeamMotion::W);
        let (arm_v, at_two_others) = turned_by(BeamMotion::V);
        let mut numbers = BeamMotion::ALL.map(|motion| {
            // A restraint of psi' of a section without warping stiffness acts over a length of 0 and does not affect
            // the twist next to it, so the cubic's slope stays free. (Fixing it would reduce the order of convergence.)
            let unknown_to_elements = motion == BeamMotion::PsiSlope && !layout.warps(place);
            let held = fixed(motion).next().is_some()
                || (motion == BeamMotion::Psi && (at_two_points || at_two_others));
            (unknown_to_elements || !held).then(|| self.next())
        });
        for (motion, arm) in [(BeamMotion::W, arm_w), (BeamMotion::V, arm_v)] {
            let follows = arm.filter(|arm| *arm != 0.0);
            let twist = numbers[BeamMotion::Psi as usize];
            if let (Some(arm), Some(twist)) = (follows, twist) {
                numbers[motion as usize] = Some(Dof {
                    factor: -arm,
                    ..twist
                });
            }
        }
        let (mut of_left_element, mut of_right_element) = (numbers, numbers);
        if layout.end(place).is_none() {
            let rate = BeamMotion::PsiSlope as usize;
            match layout.warping_around(place) {
                [true, true] => {}
                [true, false] => of_right_element[rate] = Some(self.next()),
                [false, true | false] => of_left_element[rate] = Some(self.next()),
            }
        }
        for (_, springs) in layout.joints.iter().filter(|(own, _)| *own == place) {
            for (row, spring) in springs.iter().enumerate() {
                if spring.is_some() {
                    of_left_element[row] = Some(self.next());
                }
            }
        }
        self.nodes.push(Node {
            of_left_element,
            acted_on: numbers,
            of_right_element,
        });
        for mass in layout.masses.iter().filter(|mass| mass.place == place) {
            let turns = mass.subsystem.can_turn();
            let numbers = [
                Some(self.next()),
                Some(self.next()),
                turns.then(|| self.next()),
            ];
            self.masses.push(numbers);
        }
    }
}

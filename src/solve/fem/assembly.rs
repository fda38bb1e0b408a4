//! The matrices K, C and M of the whole model, as one band, with its loads and outputs.

use num_complex::Complex64;

use super::beam_element::{BeamElement, Row, UNKNOWNS};
use super::mesh::{Dof, Mesh, Unknown};
use crate::model::{BeamMotion, MaxwellBranch, Measure, Restraint, Spring, Subsystem};
use crate::solve::layout::{Layout, Reading};

/// k (1 + i eta) + i omega c, N/m, and of each Maxwell branch the inverse of the sum of its compliances.
pub(super) fn dynamic_stiffness(spring: &Spring, omega: f64) -> Complex64 {
    let own = Complex64::new(
        spring.stiffness,
        spring.stiffness * spring.loss_factor + omega * spring.damping,
    );
    let branches = spring.maxwell.iter().filter(|of| of.acts());
    let compliance =
        |of: &MaxwellBranch| Complex64::new(1.0 / of.stiffness, -1.0 / (omega * of.damping));
    own + branches.map(|of| compliance(of).inv()).sum::<Complex64>()
}

/// A stretch, a sum of unknowns times `factors`, and what resists it: the material, the axial force, the
/// foundation or a spring.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    pub(super) unknowns: [usize; UNKNOWNS],
    pub(super) factors: [f64; UNKNOWNS],
    /// The number of used entries.
    pub(super) terms: usize,
    pub(super) by: Spring,
}

/// An inertia between two unknowns, kg or kg m2.
#[derive(Debug, Clone, Copy)]
pub(super) struct Inertia {
    pub(super) row: usize,
    pub(super) column: usize,
    pub(super) value: f64,
}

/// The output of a response in the solution.
#[derive(Debug, Clone)]
pub(super) enum Source {
    /// A sum of unknowns times factors: none for a fixed motion, the mean of two for a psi' that jumps.
    Motion(Vec<Dof>, Measure),
    Energy,
}

/// An element in the energy: the unknowns of (w, psi, v), and its span.
#[derive(Debug, Clone, Copy)]
pub(super) struct Element {
    pub(super) unknowns: [Unknown; UNKNOWNS],
    pub(super) span: usize,
}

/// A meshed model.
///
/// K is the sum of `factors^T k factors` over all stretches, never stored as a matrix: the entries of an assembled K
/// cancel against each other for a smooth shape, the stretches do not.
#[derive(Debug, Clone, Default)]
pub(super) struct System {
    pub(super) unknowns: usize,
    pub(super) half_width: usize,
    pub(super) stretches: Vec<Stretch>,
    pub(super) inertias: Vec<Inertia>,
    pub(super) loads: Vec<Complex64>,
    pub(super) sources: Vec<Source>,
    pub(super) elements: Vec<Element>,
    /// The matrix of `E_V` of the elements of each span.
    pub(super) vibration: Vec<[Row; UNKNOWNS]>,
}

impl System {
    /// Assembles a layout whose spans are divided into these numbers of elements.
    pub(super) fn new(layout: &Layout, divisions: &[usize]) -> Self {
        let mesh = Mesh::new(layout, divisions);
        let mut system = Self {
            unknowns: mesh.unknowns,
            loads: loads(layout, &mesh),
            sources: (layout.readings.iter())
                .map(|reading| source(layout, &mesh, *reading))
                .collect(),
            ..Self::default()
        };
        system.add_elements(layout, &mesh, divisions);
        system.add_supports(layout, &mesh);
        system.add_joints(layout, &mesh);
        system.add_subsystems(layout, &mesh);
        let among = |stretch: &Stretch| {
            let used = || stretch.pairs().map(|(unknown, _)| unknown);
            used().max().unwrap_or(0) - used().min().unwrap_or(0)
        };
        let stretched = system.stretches.iter().map(among);
        let coupled = system.inertias.iter().map(|i| i.row.abs_diff(i.column));
        system.half_width = stretched.chain(coupled).max().unwrap_or(0);
        system
    }

    /// The strain energy and the kinetic energy of every element.
    fn add_elements(&mut self, layout: &Layout, mesh: &Mesh, divisions: &[usize]) {
        let ends = layout.positions.windows(2);
        let lengths = ends
            .zip(divisions)
            .map(|(ends, &count)| (ends[1] - ends[0]) / count as f64);
        let of = |(part, h)| BeamElement::new(part, h);
        let elements: Vec<BeamElement> = layout.parts.iter().zip(lengths).map(of).collect();
        for (index, &span) in mesh.spans.iter().enumerate() {
            let unknowns = unknowns(mesh, index);
            let element = &elements[span];
            for (by, factors) in &element.stretches {
                self.add_stretch(&unknowns, factors, by);
            }
            for (row, inertias) in unknowns.iter().zip(&element.inertia) {
                for (column, inertia) in unknowns.iter().zip(inertias) {
                    self.add_inertia(*row, *column, *inertia);
                }
            }
            self.elements.push(Element { unknowns, span });
        }
        let vibration = elements.into_iter().map(|element| element.vibration);
        self.vibration = vibration.collect();
    }

    fn add_inertia(&mut self, row: Unknown, column: Unknown, value: f64) {
        if let (Some(row), Some(column)) = (row, column)
            && value != 0.0
        {
            self.inertias.push(Inertia {
                row: row.number,
                column: column.number,
                value: value * row.factor * column.factor,
            });
        }
    }

    /// Adds a stretch of at most twelve unknowns; fixed ones do not move.
    fn add_stretch(&mut self, unknowns: &[Unknown], factors: &[f64], by: &Spring) {
        if !by.acts() {
            return;
        }
        let mut stretch = Stretch {
            unknowns: [0; UNKNOWNS],
            factors: [0.0; UNKNOWNS],
            terms: 0,
            by: by.clone(),
        };
        for (unknown, factor) in unknowns.iter().zip(factors) {
            if let Some(unknown) = *unknown
                && *factor != 0.0
            {
                stretch.unknowns[stretch.terms] = unknown.number;
                stretch.factors[stretch.terms] = *factor * unknown.factor;
                stretch.terms += 1;
            }
        }
        self.stretches.push(stretch);
    }

    /// Springs, dampers and inertias of the supports, over a motion and the twist.
    fn add_supports(&mut self, layout: &Layout, mesh: &Mesh) {
        for (place, support) in &layout.supports {
            let node = mesh.places[*place];
            for motion in BeamMotion::ALL {
                if let Restraint::Elastic(elastic) = &support[motion] {
                    let numbers = &mesh.nodes[node].acted_on;
                    let moved = [numbers[motion as usize], numbers[BeamMotion::Psi as usize]];
                    let factors = [1.0, support.point.arm(motion).unwrap_or_default()];
                    self.add_stretch(&moved, &factors, &elastic.spring);
                    for (row, by_row) in moved.into_iter().zip(factors) {
                        for (column, by_column) in moved.into_iter().zip(factors) {
                            self.add_inertia(row, column, elastic.inertia * by_row * by_column);
                        }
                    }
                }
            }
        }
    }

    /// Springs and dampers of the joints, over a motion of both sides.
    fn add_joints(&mut self, layout: &Layout, mesh: &Mesh) {
        for (place, springs) in &layout.joints {
            let node = &mesh.nodes[mesh.places[*place]];
            for (row, spring) in springs.iter().enumerate() {
                if let Some(spring) = spring {
                    let sides = [node.of_left_element[row], node.acted_on[row]];
                    self.add_stretch(&sides, &[-1.0, 1.0], spring);
                }
            }
        }
    }

    /// The masses on their four springs, over (y, z, theta | w, psi, v) (Chen & Liu 2022, Appendix E).
    fn add_subsystems(&mut self, layout: &Layout, mesh: &Mesh) {
        for (mass, numbers) in layout.masses.iter().zip(&mesh.masses) {
            let node = &mesh.nodes[mesh.places[mass.place]].acted_on;
            let all = [
                numbers[0], numbers[1], numbers[2], node[0], node[1], node[2],
            ];
            let s = mass.subsystem;
            for (spring, stretch) in springs(s) {
                self.add_stretch(&all, &stretch, spring);
            }
            for (unknown, inertia) in numbers.iter().zip([s.mass, s.mass, s.inertia]) {
                self.add_inertia(*unknown, *unknown, inertia);
            }
        }
    }

    /// The entries of the undamped stiffness matrix, to be summed.
    pub(super) fn stiffness(&self, mut add: impl FnMut(usize, usize, f64)) {
        for stretch in &self.stretches {
            let k = stretch.by.stiffness;
            stretch.products(|row, column, product| add(row, column, k * product));
        }
    }

    /// The entries of the mass matrix, to be summed.
    pub(super) fn mass(&self, mut add: impl FnMut(usize, usize, f64)) {
        for inertia in &self.inertias {
            add(inertia.row, inertia.column, inertia.value);
        }
    }
}

impl Stretch {
    /// The unknowns and their factors.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let unknowns = self.unknowns.iter().zip(self.factors);
        unknowns
            .take(self.terms)
            .map(|(&unknown, factor)| (unknown, factor))
    }

    /// Passes on the products of the factors by pairs of unknowns.
    pub(super) fn products(&self, mut give: impl FnMut(usize, usize, f64)) {
        for (row, of_row) in self.pairs() {
            for (column, of_column) in self.pairs() {
                give(row, column, of_row * of_column);
            }
        }
    }
}

/// The unknowns of an element: (value, rotation) at the left and the right end, of w, psi and v.
fn unknowns(mesh: &Mesh, element: usize) -> [Unknown; UNKNOWNS] {
    let left = &mesh.nodes[element].of_right_element;
    let right = &mesh.nodes[element + 1].of_left_element;
    std::array::from_fn(|unknown| {
        let (motion, place) = (unknown / 4, unknown % 4);
        let node = if place < 2 { left } else { right };
        node[motion + 3 * (place % 2)]
    })
}

/// The springs of a subsystem and their stretches over (y, z, theta | w, psi, v) (Chen & Liu 2022, Eq. 30).
fn springs(s: &Subsystem) -> [(&Spring, [f64; 6]); 4] {
    [
        (&s.y_left, [1.0, 0.0, 0.0, -1.0, -s.mount_z, 0.0]),
        (&s.y_right, [1.0, 0.0, 0.0, -1.0, -s.mount_z, 0.0]),
        (&s.z_left, [0.0, 1.0, -s.arm_left, 0.0, s.mount_y, -1.0]),
        (&s.z_right, [0.0, 1.0, s.arm_right, 0.0, -s.mount_y, -1.0]),
    ]
}

/// Loads on the unknowns; those on fixed motions go into the ground.
fn loads(layout: &Layout, mesh: &Mesh) -> Vec<Complex64> {
    let mut out = vec![Complex64::ZERO; mesh.unknowns];
    let mut add = |unknowns: &[Unknown], loads: &[Complex64]| {
        for (unknown, load) in unknowns.iter().zip(loads) {
            if let Some(unknown) = unknown {
                out[unknown.number] += load * unknown.factor;
            }
        }
    };
    for (&node, load) in mesh.places.iter().zip(&layout.loads) {
        add(&mesh.nodes[node].acted_on, load);
    }
    for (mass, numbers) in layout.masses.iter().zip(&mesh.masses) {
        add(numbers, &mass.load);
    }
    out
}

fn source(layout: &Layout, mesh: &Mesh, reading: Reading) -> Source {
    let sum = |terms: &[(Unknown, f64)]| {
        let moving = terms.iter().filter_map(|(unknown, share)| {
            unknown.map(|of| Dof {
                factor: of.factor * share,
                ..of
            })
        });
        moving.collect()
    };
    match reading {
        Reading::Held => Source::Motion(Vec::new(), Measure::Displacement),
        Reading::Energy => Source::Energy,
        Reading::Beam(place, direction, arm, measure) => {
            let node = &mesh.nodes[mesh.places[place]];
            let row = direction as usize;
            let sides = if direction == BeamMotion::PsiSlope && !layout.warps(place) {
                [node.of_left_element, node.of_right_element]
            } else {
                [node.acted_on; 2]
            };
            let twist = node.acted_on[BeamMotion::Psi as usize];
            let terms = [(sides[0][row], 0.5), (sides[1][row], 0.5), (twist, arm)];
            Source::Motion(sum(&terms), measure)
        }
        Reading::Mass(mass, direction, measure) => {
            let unknown = mesh.masses[mass][direction as usize];
            Source::Motion(sum(&[(unknown, 1.0)]), measure)
        }
    }
}

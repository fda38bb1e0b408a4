//! The matrices K, C and M of the whole model, as one band, with its loads and outputs.

use num_complex::Complex64;

use super::beam_element::{BeamElement, Row, UNKNOWNS};
use super::mesh::{Dof, Mesh, Unknown};
use crate::model::{
    BeamMotion, MaxwellBranch, Measure, Restraint, Spring, SpringMeasure, Subsystem,
};
use crate::solve::layout::{Layout, Reading, Readings};

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
    /// The forces by which some stretches and inertias act along an unknown.
    Force(Force),
    Energy,
}

/// A sum of forces.
#[derive(Debug, Clone, Default)]
pub(super) struct Force {
    /// What resists stretches, with the factor of each.
    pub(super) stretches: Vec<(f64, Stretch)>,
    /// Inertias times factors with their unknowns.
    pub(super) inertias: Vec<Dof>,
    pub(super) load: Complex64,
}

impl Force {
    /// Adds a factor of the force of a stretch along one of its unknowns.
    fn pull(&mut self, factor: f64, unknowns: &[Unknown], factors: &[f64], by: &Spring) {
        if factor != 0.0 && by.acts() {
            self.stretches
                .push((factor, Stretch::new(unknowns, factors, by)));
        }
    }

    fn push(&mut self, factor: f64, unknown: Unknown) {
        self.inertias.extend(unknown.map(|of| Dof {
            factor: factor * of.factor,
            ..of
        }));
    }

    /// Adds a factor of the force of an element along one of its unknowns.
    fn of_element(
        &mut self,
        factor: f64,
        (element, unknowns): (&BeamElement, &[Unknown; UNKNOWNS]),
        along: usize,
    ) {
        for (by, factors) in &element.stretches {
            self.pull(factor * factors[along], unknowns, factors, by);
        }
        for (unknown, inertia) in unknowns.iter().zip(&element.inertia[along]) {
            self.push(factor * inertia, *unknown);
        }
    }
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
    pub(super) sources: Vec<Readings<Source>>,
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
            ..Self::default()
        };
        let elements = elements(layout, divisions);
        let meshed = Meshed {
            layout,
            mesh: &mesh,
            elements: &elements,
        };
        let readings = layout.readings.iter();
        let sources = readings.map(|all| all.map(|reading| meshed.source(*reading)));
        system.sources = sources.collect();
        system.add_elements(&mesh, &elements);
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
    fn add_elements(&mut self, mesh: &Mesh, elements: &[BeamElement]) {
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
        let vibration = elements.iter().map(|element| element.vibration);
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
        self.stretches.push(Stretch::new(unknowns, factors, by));
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

/// The element of each span.
fn elements(layout: &Layout, divisions: &[usize]) -> Vec<BeamElement> {
    let ends = layout.positions.windows(2);
    let lengths = ends
        .zip(divisions)
        .map(|(ends, &count)| (ends[1] - ends[0]) / count as f64);
    let of = |(part, h)| BeamElement::new(part, h);
    layout.parts.iter().zip(lengths).map(of).collect()
}

impl Stretch {
    /// A stretch of at most twelve unknowns; fixed ones do not move.
    fn new(unknowns: &[Unknown], factors: &[f64], by: &Spring) -> Self {
        let mut stretch = Self {
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
        stretch
    }

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

/// A layout with its mesh and the element of each span.
struct Meshed<'a> {
    layout: &'a Layout<'a>,
    mesh: &'a Mesh,
    elements: &'a [BeamElement],
}

impl Meshed<'_> {
    fn source(&self, reading: Reading) -> Source {
        let (layout, mesh) = (self.layout, self.mesh);
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
            Reading::Spring(mass, name, measure) => {
                let unknowns = self.unknowns_of(mass);
                let (spring, stretch) = springs(layout.masses[mass].subsystem)[name as usize];
                // The stretch of the elements is that of the mass's end less the beam's.
                match measure {
                    SpringMeasure::Stretch => {
                        let terms = std::array::from_fn::<_, 6, _>(|i| (unknowns[i], -stretch[i]));
                        Source::Motion(sum(&terms), Measure::Displacement)
                    }
                    SpringMeasure::Force => {
                        let mut force = Force::default();
                        force.pull(-1.0, &unknowns, &stretch, spring);
                        Source::Force(force)
                    }
                }
            }
            Reading::Force(place, motion) => Source::Force(self.internal_force(place, motion)),
            Reading::Reaction(index, motion) => Source::Force(self.reaction(index, motion)),
        }
    }

    /// The unknowns of a mass and of the beam at it: (y, z, theta | w, psi, v).
    fn unknowns_of(&self, mass: usize) -> [Unknown; 6] {
        let numbers = &self.mesh.masses[mass];
        let place = self.layout.masses[mass].place;
        let node = &self.mesh.nodes[self.mesh.places[place]].acted_on;
        [
            numbers[0], numbers[1], numbers[2], node[0], node[1], node[2],
        ]
    }

    /// Adds a factor of the force of an element along a motion of one of its ends, 0 left and 1 right.
    fn add_element(
        &self,
        force: &mut Force,
        factor: f64,
        index: usize,
        end: usize,
        of: BeamMotion,
    ) {
        let element = &self.elements[self.mesh.spans[index]];
        let row = of as usize;
        let along = 4 * (row % 3) + 2 * end + row / 3;
        force.of_element(factor, (element, &unknowns(self.mesh, index)), along);
    }

    /// By the element right of a position; at the right end by the one left of it.
    fn internal_force(&self, place: usize, motion: BeamMotion) -> Force {
        let mut force = Force::default();
        let last = self.mesh.spans.len();
        let node = self.mesh.places[place];
        let (index, end, sign) = if node == last {
            (last - 1, 1, 1.0)
        } else {
            (node, 0, -1.0)
        };
        let warps = self.layout.parts[self.mesh.spans[index]].warps();
        if warps || motion != BeamMotion::PsiSlope {
            self.add_element(&mut force, sign, index, end, motion);
        }
        force
    }

    /// By the spring and damper; of a fixed motion what all else puts on the node.
    fn reaction(&self, index: usize, motion: BeamMotion) -> Force {
        let mut force = Force::default();
        let (place, support) = &self.layout.supports[index];
        let arm = support.point.arm(motion).unwrap_or_default();
        match &support[motion] {
            Restraint::Free => {}
            Restraint::Elastic(elastic) => {
                let node = &self.mesh.nodes[self.mesh.places[*place]].acted_on;
                let moved = [node[motion as usize], node[BeamMotion::Psi as usize]];
                force.pull(1.0, &moved, &[1.0, arm], &elastic.spring);
            }
            Restraint::Fixed if motion == BeamMotion::PsiSlope && !self.layout.warps(*place) => {}
            Restraint::Fixed => {
                self.add_rest(&mut force, 1.0, index, motion);
                if motion == BeamMotion::Psi {
                    // About the point.
                    self.add_rest(&mut force, -support.point.z, index, BeamMotion::W);
                    self.add_rest(&mut force, support.point.y, index, BeamMotion::V);
                }
            }
        }
        force
    }

    /// Adds a factor of what everything at the place of a support but itself puts on the node along a motion of the axis.
    fn add_rest(&self, force: &mut Force, factor: f64, index: usize, motion: BeamMotion) {
        let layout = self.layout;
        let place = layout.supports[index].0;
        let node = self.mesh.places[place];
        force.load += factor * layout.loads[place][motion as usize];
        if node > 0 {
            self.add_element(force, -factor, node - 1, 1, motion);
        }
        if node < self.mesh.spans.len() {
            self.add_element(force, -factor, node, 0, motion);
        }
        let here = layout.masses.iter().enumerate();
        for (mass, of) in here.filter(|(_, of)| of.place == place && (motion as usize) < 3) {
            for (spring, stretch) in springs(of.subsystem) {
                let share = stretch[3 + motion as usize];
                force.pull(-factor * share, &self.unknowns_of(mass), &stretch, spring);
            }
        }
        let others = layout.supports.iter().enumerate();
        let others = others.filter(|(other, (own, _))| *own == place && *other != index);
        for (_, (_, support)) in others {
            for own in BeamMotion::ALL {
                let arm = support.point.arm(own).unwrap_or_default();
                let share = match motion {
                    _ if own == motion => 1.0,
                    BeamMotion::Psi => arm,
                    _ => 0.0,
                };
                let elastic = support[own].elastic();
                let unknowns = &self.mesh.nodes[node].acted_on;
                let moved = [unknowns[own as usize], unknowns[BeamMotion::Psi as usize]];
                force.pull(-factor * share, &moved, &[1.0, arm], &elastic.spring);
                let inertia = -factor * share * elastic.inertia;
                force.push(inertia, moved[0]);
                force.push(inertia * arm, moved[1]);
            }
        }
    }
}

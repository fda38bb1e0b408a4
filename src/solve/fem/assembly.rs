//! The matrices K, C and M of the whole model, as one band, with its loads and outputs.

use num_complex::Complex64;

use super::hermite;
use super::mesh::{Mesh, Unknown};
use crate::model::{BeamMotion, Measure, Restraint, Spring, Subsystem};
use crate::solve::layout::{Layout, Reading};

/// The resistance to a stretch: the terms of its complex stiffness.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Resistance {
    /// The beam's own stiffness, which the loss factor makes complex.
    pub(super) elastic: f64,
    /// A spring's.
    pub(super) stiffness: f64,
    /// A damper's.
    pub(super) damping: f64,
}

impl Resistance {
    /// (1 + i eta) `k_beam` + `k_spring` + i omega c.
    pub(super) fn at(&self, omega: f64, loss_factor: f64) -> Complex64 {
        Complex64::new(
            self.elastic + self.stiffness,
            loss_factor * self.elastic + omega * self.damping,
        )
    }
}

/// A stretch, a sum of unknowns times `factors`, and its resistance: an element's strain or a spring.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    pub(super) unknowns: [usize; 6],
    pub(super) factors: [f64; 6],
    /// The number of used entries, up to six.
    pub(super) terms: usize,
    pub(super) by: Resistance,
}

/// An inertia between two unknowns, kg or kg m2.
#[derive(Debug, Clone, Copy)]
pub(super) struct Inertia {
    pub(super) row: usize,
    pub(super) column: usize,
    pub(super) value: f64,
}

/// The output of a response in the solution.
#[derive(Debug, Clone, Copy)]
pub(super) enum Source {
    Held,
    /// The mean of two unknowns, which are equal except for a psi' that jumps.
    Motion([usize; 2], Measure),
    Energy,
}

/// An element in the energy: the unknowns of (w, psi, v), and its span.
#[derive(Debug, Clone, Copy)]
pub(super) struct Element {
    pub(super) fields: [[Unknown; 4]; 3],
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
    pub(super) loss_factor: f64,
    pub(super) sources: Vec<Source>,
    pub(super) elements: Vec<Element>,
    /// int `N_i N_j` dx of the elements of each span, m.
    pub(super) masses: Vec<[[f64; 4]; 4]>,
    /// rho A, rho `I_0`, rho A: the inertia per length of (w, psi, v), kg/m and kg m.
    pub(super) per_length: [f64; 3],
}

impl System {
    /// Assembles a layout whose spans are divided into so many elements each.
    pub(super) fn new(layout: &Layout, divisions: &[usize]) -> Self {
        let mesh = Mesh::new(layout, divisions);
        let (section, material) = (&layout.model.beam.section, &layout.model.beam.material);
        let areas = [section.area, section.polar_moment, section.area];
        let mut system = Self {
            unknowns: mesh.unknowns,
            loads: loads(layout, &mesh),
            loss_factor: material.loss_factor,
            sources: layout.readings.iter().map(|r| source(&mesh, *r)).collect(),
            per_length: areas.map(|area| material.density * area),
            ..Self::default()
        };
        system.add_elements(layout, &mesh, divisions);
        system.add_supports(layout, &mesh);
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

    /// The strain energy and the kinetic energy of every element (Chen & Liu 2022, Section 2.2).
    fn add_elements(&mut self, layout: &Layout, mesh: &Mesh, divisions: &[usize]) {
        let (section, material) = (&layout.model.beam.section, &layout.model.beam.material);
        let (e, g) = (material.young_modulus, material.shear_modulus);
        let stiffness = [
            (e * section.second_moment_y, 0.0),
            (e * section.warping_constant, g * section.torsion_constant),
            (e * section.second_moment_z, 0.0),
        ];
        let ends = layout.positions.windows(2);
        let lengths = ends
            .zip(divisions)
            .map(|(ends, &count)| (ends[1] - ends[0]) / count as f64);
        let lengths: Vec<f64> = lengths.collect();
        self.masses = lengths.iter().map(|&h| hermite::mass(h)).collect();
        for (index, &span) in mesh.spans.iter().enumerate() {
            let fields = fields(mesh, index);
            for (unknowns, (bending, torsion)) in fields.iter().zip(stiffness) {
                for strain in hermite::strains(lengths[span], bending, torsion) {
                    let by = Resistance {
                        elastic: strain.stiffness,
                        ..Resistance::default()
                    };
                    self.add_stretch(unknowns, &strain.of, by);
                }
            }
            self.add_mass(&fields, span, self.per_length[0] * section.centroid_offset);
            self.elements.push(Element { fields, span });
        }
    }

    /// The consistent mass of an element; `coupling` (kg) is that of w and psi, rho A `z_c`.
    fn add_mass(&mut self, fields: &[[Unknown; 4]; 3], span: usize, coupling: f64) {
        let shapes = self.masses[span];
        for i in 0..4 {
            for j in 0..4 {
                for (field, per_length) in fields.iter().zip(self.per_length) {
                    self.add_inertia(field[i], field[j], per_length * shapes[i][j]);
                }
                self.add_inertia(fields[0][i], fields[1][j], coupling * shapes[i][j]);
                self.add_inertia(fields[1][i], fields[0][j], coupling * shapes[i][j]);
            }
        }
    }

    fn add_inertia(&mut self, row: Unknown, column: Unknown, value: f64) {
        if let (Some(row), Some(column)) = (row, column)
            && value != 0.0
        {
            self.inertias.push(Inertia { row, column, value });
        }
    }

    /// Adds a stretch of at most six unknowns; fixed ones do not move.
    fn add_stretch(&mut self, unknowns: &[Unknown], factors: &[f64], by: Resistance) {
        if [by.elastic, by.stiffness, by.damping] == [0.0; 3] {
            return;
        }
        let mut stretch = Stretch {
            unknowns: [0; 6],
            factors: [0.0; 6],
            terms: 0,
            by,
        };
        for (unknown, factor) in unknowns.iter().zip(factors) {
            if let Some(unknown) = *unknown
                && *factor != 0.0
            {
                stretch.unknowns[stretch.terms] = unknown;
                stretch.factors[stretch.terms] = *factor;
                stretch.terms += 1;
            }
        }
        self.stretches.push(stretch);
    }

    /// Springs, dampers and inertias at the ends.
    fn add_supports(&mut self, layout: &Layout, mesh: &Mesh) {
        for (place, &node) in mesh.places.iter().enumerate() {
            let Some(support) = layout.support(place) else {
                continue;
            };
            for motion in BeamMotion::ALL
                .into_iter()
                .filter(|m| !layout.holds(support, *m))
            {
                if let Restraint::Elastic(elastic) = support[motion] {
                    let unknown = mesh.nodes[node].of_left_element[motion as usize];
                    let by = Resistance {
                        elastic: 0.0,
                        stiffness: elastic.stiffness,
                        damping: elastic.damping,
                    };
                    self.add_stretch(&[unknown], &[1.0], by);
                    self.add_inertia(unknown, unknown, elastic.inertia);
                }
            }
        }
    }

    /// The masses on their four springs, over (y, z, theta | w, psi, v) (Chen & Liu 2022, Appendix E).
    fn add_subsystems(&mut self, layout: &Layout, mesh: &Mesh) {
        for (mass, numbers) in layout.masses.iter().zip(&mesh.masses) {
            let node = &mesh.nodes[mesh.places[mass.place]].of_left_element;
            let all = [
                numbers[0], numbers[1], numbers[2], node[0], node[1], node[2],
            ];
            let s = mass.subsystem;
            for (spring, stretch) in springs(s) {
                let by = Resistance {
                    elastic: 0.0,
                    stiffness: spring.stiffness,
                    damping: spring.damping,
                };
                self.add_stretch(&all, &stretch, by);
            }
            for (unknown, inertia) in numbers.iter().zip([s.mass, s.mass, s.inertia]) {
                self.add_inertia(*unknown, *unknown, inertia);
            }
        }
    }

    /// The entries of the undamped stiffness matrix, to be summed.
    pub(super) fn stiffness(&self, mut add: impl FnMut(usize, usize, f64)) {
        for stretch in &self.stretches {
            let k = stretch.by.elastic + stretch.by.stiffness;
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

/// The unknowns of an element: (value, slope) at the left and the right end, of w, psi and v.
fn fields(mesh: &Mesh, element: usize) -> [[Unknown; 4]; 3] {
    let left = &mesh.nodes[element].of_right_element;
    let right = &mesh.nodes[element + 1].of_left_element;
    std::array::from_fn(|field| [left[field], left[field + 3], right[field], right[field + 3]])
}

/// The springs of a subsystem and their stretches over (y, z, theta | w, psi, v) (Chen & Liu 2022, Eq. 30).
fn springs(s: &Subsystem) -> [(Spring, [f64; 6]); 4] {
    [
        (s.y_left, [1.0, 0.0, 0.0, -1.0, -s.mount_z, 0.0]),
        (s.y_right, [1.0, 0.0, 0.0, -1.0, -s.mount_z, 0.0]),
        (s.z_left, [0.0, 1.0, -s.arm_left, 0.0, s.mount_y, -1.0]),
        (s.z_right, [0.0, 1.0, s.arm_right, 0.0, -s.mount_y, -1.0]),
    ]
}

/// Loads on the unknowns; those on fixed motions go into the ground.
fn loads(layout: &Layout, mesh: &Mesh) -> Vec<Complex64> {
    let mut out = vec![Complex64::ZERO; mesh.unknowns];
    let mut add = |unknowns: &[Unknown], loads: &[Complex64]| {
        for (unknown, load) in unknowns.iter().zip(loads) {
            if let Some(unknown) = unknown {
                out[*unknown] += load;
            }
        }
    };
    for (&node, load) in mesh.places.iter().zip(&layout.loads) {
        add(&mesh.nodes[node].of_left_element, load);
    }
    for (mass, numbers) in layout.masses.iter().zip(&mesh.masses) {
        add(numbers, &mass.load);
    }
    out
}

fn source(mesh: &Mesh, reading: Reading) -> Source {
    let motion = |a: Unknown, b: Unknown, measure: Measure| match (a, b) {
        (Some(a), Some(b)) => Source::Motion([a, b], measure),
        _ => Source::Held,
    };
    match reading {
        Reading::Held => Source::Held,
        Reading::Energy => Source::Energy,
        Reading::Beam(place, direction, measure) => {
            let node = &mesh.nodes[mesh.places[place]];
            let row = direction as usize;
            motion(
                node.of_left_element[row],
                node.of_right_element[row],
                measure,
            )
        }
        Reading::Mass(mass, direction, measure) => {
            let unknown = mesh.masses[mass][direction as usize];
            motion(unknown, unknown, measure)
        }
    }
}

//! The method of the paper: a product of 12x12 transfer matrices.
//!
//! Chen & Liu, *Mathematics* 2022, 10(16), 2849, Sections 2.1 and 2.2 with Appendices A to D, equation by equation;
//! misprints are corrected, supports may act on all six motions, several loads may act at once. `springs` condenses a
//! subsystem (Eqs. 1 to 10), `shapes` has the roots, ratios and shape functions (Eqs. 19 to 29), `boundary` the ends
//! (Appendix C), and here are the interfaces, the product and the closed form (Eqs. 36 to 75).
//!
//! **It loses digits on purpose.** The ratio of the growing and the decaying part of sinh and cosh is e^(2 beta l), and
//! double precision has sixteen digits: on the paper's beam eleven are right at 100 Hz, three at 350 Hz and none at 1
//! kHz. This module shows the paper's method unchanged, where it is accurate and where it is not. The program uses
//! [`solve::sweep`](super::sweep()) and never this method instead.

mod boundary;
mod shapes;
mod springs;

use std::sync::atomic::AtomicBool;

use nalgebra::{Const, LU, SMatrix, SVector};
use num_complex::Complex64;

use self::shapes::{Matrix, Shapes};
use self::springs::EffectiveSprings;
use super::Cancelled;
use super::layout::{Layout, Reading, derivative};
use super::sweep::{Frf, one_by_one};
use crate::model::{
    BeamMotion, Checked, Model, Point, Quantity, SpringMeasure, SpringName, SupportId,
};

/// Twelve integration constants, or twelve right-hand sides.
type Vector = SVector<Complex64, 12>;
/// The factors of a 12x12 matrix.
type Factors = LU<Complex64, Const<12>, Const<12>>;

/// The solution of 12x12 equations; not finite if they are singular.
fn solve<const K: usize>(
    factors: &Factors,
    right: SMatrix<Complex64, 12, K>,
) -> SMatrix<Complex64, 12, K> {
    let undefined = || SMatrix::repeat(Complex64::new(f64::NAN, f64::NAN));
    factors.solve(&right).unwrap_or_else(undefined)
}

/// Why the paper's formulas do not apply to a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NotApplicable {
    /// The centroid is at the shear centre: Eqs. (18) and (25) divide by `z_c`.
    NoOffset,
    /// The warping constant is 0: Eq. (19) is of the eighth order by E `Gamma_0`.
    NoWarping,
    /// v is coupled, or there is rotary inertia or an axial force: Eqs. (11) to (13) have none of them.
    OtherBeam,
    /// A support holds the beam between its ends, or off its axis: Appendix C has neither.
    OtherSupports,
    /// The beam has spans: Eqs. (36) to (47) join segments of one section.
    Spans,
    /// The beam has a joint: Eqs. (36) to (47) join all motions rigidly.
    Joints,
    /// A response is a reaction: Appendix C eliminates them.
    Reactions,
}

impl std::fmt::Display for NotApplicable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::NoOffset => "its ratios t divide by the centroid offset z_c, which is 0",
            Self::NoWarping => "its shape functions need a warping constant above 0",
            Self::OtherSupports => "it is derived for supports of the two ends, on the axis",
            Self::Spans => "it is derived for a uniform beam, without spans",
            Self::Joints => "it is derived for a beam without joints",
            Self::Reactions => "its boundary conditions eliminate the reactions of the supports",
            Self::OtherBeam => {
                "it is derived for a centroid offset along z alone, without product moment, axial force and rotary inertia"
            }
        })
    }
}

/// Solves a model at each frequency (Hz, > 0) by the paper's closed form, on all cores.
///
/// Values and units are those of [`solve::sweep`](super::sweep()), with the digits of this method: none at high
/// frequencies, where values may not even be finite.
///
/// # Errors
/// The paper's formulas divide by a zero of the model; inside, `cancel` became true before the end.
pub fn sweep(
    model: &Checked,
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Result<Result<Frf, Cancelled>, NotApplicable> {
    if !model.spans.is_empty() {
        return Err(NotApplicable::Spans);
    }
    if !model.beam.is_of_one_offset() {
        return Err(NotApplicable::OtherBeam);
    }
    let is_on_axis = |id: SupportId| id.support(model).point == Point::AXIS;
    if !model.supports.inner.is_empty() || !SupportId::ENDS.into_iter().all(is_on_axis) {
        return Err(NotApplicable::OtherSupports);
    }
    if !model.joints.is_empty() {
        return Err(NotApplicable::Joints);
    }
    if model.beam.section.centroid_offset == 0.0 {
        return Err(NotApplicable::NoOffset);
    }
    if model.beam.section.warping_constant == 0.0 {
        return Err(NotApplicable::NoWarping);
    }
    if model
        .computed()
        .any(|of| matches!(of.quantity, Quantity::Reaction(_)))
    {
        return Err(NotApplicable::Reactions);
    }
    let chain = Chain::new(model);
    Ok(one_by_one(
        model,
        frequencies,
        cancel,
        &|(): &mut (), frequency, row| chain.solve(frequency, row),
    ))
}

/// A beam divided into segments at its subsystems and loads.
#[derive(Debug)]
struct Chain<'a> {
    layout: Layout<'a>,
    /// The positions (of the layout) between segments.
    stations: Vec<usize>,
    /// Where each segment begins, m; one more than stations.
    starts: Vec<f64>,
    /// Length of each segment, m.
    lengths: Vec<f64>,
}

/// The solution at one frequency.
struct Solution {
    omega: f64,
    shapes: Shapes,
    /// The effective springs of each mass.
    springs: Vec<EffectiveSprings>,
    /// The integration constants of each segment.
    constants: Vec<Vector>,
}

/// The constants of a segment by those of the first, `C_n = of_first C_1 + forced`: the products of Eqs. (46), (56),
/// (60) and (72), for any number of loads.
struct Link {
    of_first: Matrix,
    forced: Vector,
}

impl<'a> Chain<'a> {
    fn new(model: &'a Model) -> Self {
        let layout = Layout::new(model, 0.0);
        let acts = |place: usize| {
            let loaded = layout.loads[place] != [Complex64::ZERO; 6];
            let inside = layout.end(place).is_none();
            (loaded && inside) || layout.masses.iter().any(|mass| mass.place == place)
        };
        let stations: Vec<usize> = (0..layout.positions.len()).filter(|&p| acts(p)).collect();
        let mut starts = vec![0.0];
        starts.extend(stations.iter().map(|&place| layout.positions[place]));
        let length = model.length();
        let ends = starts[1..].iter().chain([&length]);
        let lengths = ends.zip(&starts).map(|(end, start)| end - start).collect();
        Self {
            layout,
            stations,
            starts,
            lengths,
        }
    }

    /// Writes every response at `frequency`, Hz, to `out`.
    fn solve(&self, frequency: f64, out: &mut [Complex64]) {
        let omega = std::f64::consts::TAU * frequency;
        let shapes = Shapes::new(&self.layout.model.beam, omega);
        let masses = self.layout.masses.iter();
        let springs = masses
            .map(|mass| EffectiveSprings::new(mass.subsystem, omega))
            .collect();
        let mut solution = Solution {
            omega,
            shapes,
            springs,
            constants: Vec::new(),
        };
        let links = self.links(&solution);
        let first = boundary::first_constants(self, &solution, &links);
        let constants = links.iter().map(|link| link.of_first * first + link.forced);
        solution.constants = constants.collect();
        for (value, reading) in out.iter_mut().zip(&self.layout.readings) {
            *value = reading.value(|reading| self.read(&solution, *reading));
        }
    }

    /// The product of the interfaces' matrices, segment by segment.
    fn links(&self, solution: &Solution) -> Vec<Link> {
        let at_start = solution.shapes.derivatives(0.0).lu();
        let mut links = vec![Link {
            of_first: Matrix::identity(),
            forced: Vector::zeros(),
        }];
        for (segment, &place) in self.stations.iter().enumerate() {
            let (transfer, jump) = self.interface(solution, &at_start, segment, place);
            let before = &links[segment];
            links.push(Link {
                of_first: transfer * before.of_first,
                forced: transfer * before.forced + jump,
            });
        }
        links
    }

    /// `H_i` of Eq. (45) and `H_F F` of Eqs. (55) and (71) of the station at a segment's end: displacements, slopes and
    /// moments are continuous, forces jump by those of springs and loads (Eqs. 36 to 40, 51 to 53 and 67 to 69).
    fn interface(
        &self,
        solution: &Solution,
        at_start: &Factors,
        segment: usize,
        place: usize,
    ) -> (Matrix, Vector) {
        let mut left = solution.shapes.derivatives(self.lengths[segment]);
        let mut jump = Vector::zeros();
        for motion in BeamMotion::ALL {
            let load = self.inner_load(place)[motion as usize];
            let (row, unit) = conjugate(&solution.shapes, motion);
            jump[row] -= load / unit;
        }
        let displacements = DISPLACEMENTS.map(|row| left.row(row).into_owned());
        let masses = self.layout.masses.iter().zip(&solution.springs);
        for (mass, springs) in masses.filter(|(mass, _)| mass.place == place) {
            let transmitted = springs.transmitted(&mass.load);
            for (direction, forces) in springs.forces().into_iter().enumerate() {
                let row = FORCES[direction];
                for (force, displacement) in forces.into_iter().zip(&displacements) {
                    let mut target = left.row_mut(row);
                    target -= displacement * force;
                }
                jump[row] -= transmitted[direction];
            }
        }
        (solve(at_start, left), solve(at_start, jump))
    }

    /// The loads at a position; those at the ends belong to the boundary conditions.
    fn inner_load(&self, place: usize) -> [Complex64; 6] {
        match self.layout.end(place) {
            None => self.layout.loads[place],
            Some(_) => [Complex64::ZERO; 6],
        }
    }

    fn read(&self, solution: &Solution, reading: Reading) -> Complex64 {
        let omega = solution.omega;
        match reading {
            Reading::Energy => energy(self, solution).into(),
            Reading::Beam(place, motion, arm, measure) => {
                let state = self.state(solution, place);
                let moved = state[moved_row(motion)] + arm * state[moved_row(BeamMotion::Psi)];
                derivative(omega, measure) * moved
            }
            Reading::Mass(mass, motion, measure) => {
                derivative(omega, measure) * self.mass(solution, mass)[motion as usize]
            }
            Reading::Force(place, motion) => {
                let x = self.layout.positions[place];
                // At the right end left of a subsystem there.
                let segment = if self.layout.end(place).is_some() && place > 0 {
                    self.starts.partition_point(|&start| start < x) - 1
                } else {
                    self.starts.partition_point(|&start| start <= x) - 1
                };
                let (row, unit) = conjugate(&solution.shapes, motion);
                unit * self.state_in(solution, segment, x)[row]
            }
            Reading::Spring(mass, name, measure) => {
                let subsystem = self.layout.masses[mass].subsystem;
                let [y, z, theta] = self.mass(solution, mass);
                let state = self.state(solution, self.layout.masses[mass].place);
                let [w, psi, v] = DISPLACEMENTS.map(|row| state[row]);
                let (height, half) = (subsystem.mount_z, subsystem.mount_y);
                let stretch = match name {
                    SpringName::YLeft | SpringName::YRight => w + height * psi - y,
                    SpringName::ZLeft => v - half * psi - (z - subsystem.arm_left * theta),
                    SpringName::ZRight => v + half * psi - (z + subsystem.arm_right * theta),
                };
                match measure {
                    SpringMeasure::Stretch => stretch,
                    SpringMeasure::Force => solution.springs[mass].stiffness(name) * stretch,
                }
            }
            // Refused before.
            Reading::Reaction(..) => Complex64::new(f64::NAN, f64::NAN),
        }
    }

    /// The motions (y, z, theta) of a mass.
    fn mass(&self, solution: &Solution, mass: usize) -> [Complex64; 3] {
        let (springs, mass) = (&solution.springs[mass], &self.layout.masses[mass]);
        let state = self.state(solution, mass.place);
        springs.motion(&DISPLACEMENTS.map(|row| state[row]), &mass.load)
    }

    /// Displacements, slopes and forces at a position: Eq. (49).
    fn state(&self, solution: &Solution, place: usize) -> Vector {
        let x = self.layout.positions[place];
        let segment = self.starts.partition_point(|&start| start <= x) - 1;
        self.state_in(solution, segment, x)
    }

    /// The same in a segment.
    fn state_in(&self, solution: &Solution, segment: usize, x: f64) -> Vector {
        let shapes = &solution.shapes;
        shapes.derivatives(x - self.starts[segment]) * solution.constants[segment]
    }
}

/// The rows of W, Psi and V among the derivatives, and of the forces along them.
const DISPLACEMENTS: [usize; 3] = [0, 4, 8];
const FORCES: [usize; 3] = [3, 7, 11];

/// The row of a motion among the derivatives.
fn moved_row(motion: BeamMotion) -> usize {
    let motion = motion as usize;
    DISPLACEMENTS[motion % 3] + motion / 3
}

/// The row of the derivatives that corresponds to the force or moment along a motion, and the force per unit of it: the
/// rows of W'' and V'' are curvatures.
fn conjugate(shapes: &Shapes, motion: BeamMotion) -> (usize, Complex64) {
    match motion {
        BeamMotion::W | BeamMotion::Psi | BeamMotion::V => {
            (FORCES[motion as usize], Complex64::ONE)
        }
        BeamMotion::WSlope => (2, shapes.bending_y),
        BeamMotion::PsiSlope => (6, Complex64::ONE),
        BeamMotion::VSlope => (10, shapes.bending_z),
    }
}

/// Nodes and weights of the eight-point Gauss-Legendre rule on [-1, 1], the positive half (Abramowitz & Stegun 1964,
/// Table 25.4); exact to the degree 15.
const RULE: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];
/// The largest beta x of a panel: the rule is then accurate to the last digits.
const PANEL: f64 = 1.0;

/// `E_V` = int rho A (|W|^2 + |V|^2) + rho `I_0` |Psi|^2 dx (Section 4.2), kg m2.
fn energy(chain: &Chain, solution: &Solution) -> f64 {
    let beam = &chain.layout.model.beam;
    let density = beam.material.density;
    let mass = density * beam.section.area;
    let inertias = [mass, density * beam.section.polar_moment, mass];
    let at = |segment: usize, x: f64| -> f64 {
        let state = solution.shapes.derivatives(x) * solution.constants[segment];
        let moved = DISPLACEMENTS.iter().zip(inertias);
        moved
            .map(|(&row, inertia)| inertia * state[row].norm_sqr())
            .sum()
    };
    let mut sum = 0.0;
    for (segment, &length) in chain.lengths.iter().enumerate() {
        let panels = (solution.shapes.largest() * length / PANEL).ceil().max(1.0) as usize;
        let half = 0.5 * length / panels as f64;
        for panel in 0..panels {
            let middle = (2 * panel + 1) as f64 * half;
            for (node, weight) in RULE {
                let pair = at(segment, middle - half * node) + at(segment, middle + half * node);
                sum += half * weight * pair;
            }
        }
    }
    sum
}

//! The solution of a meshed model at one frequency, by factors of its band matrix and iterative refinement.

use num_complex::Complex64;

use super::assembly::{Force, Source, System, dynamic_stiffness};
use super::band::Band;
use super::mesh::Unknown;
use super::twofold::Twofold;
use crate::solve::layout::derivative;

/// Most corrections of a solution; two are enough except for the finest meshes next to an undamped resonance.
const MOST_CORRECTIONS: usize = 12;
/// A correction smaller than this fraction of the solution is the last.
const CORRECTED: f64 = 1e-11;
/// If the last correction is larger than this fraction, there is no solution.
const UNCERTAIN: f64 = 1e-6;

/// Workspace for one frequency at a time.
#[derive(Debug, Default)]
pub(super) struct Workspace {
    matrix: Band,
    scale: Vec<f64>,
    solution: Twofold,
    /// The residual, then the correction.
    correction: Vec<Complex64>,
    /// The previous correction.
    before: Vec<Complex64>,
}

impl Workspace {
    /// Solves with the factored matrix, and corrects the solution by its residual until it converges.
    ///
    /// Next to an undamped resonance the factors are wrong in one direction, that of the mode, and corrections shrink
    /// (or grow) by a constant ratio; therefore every other correction is multiplied by the sum of the geometric series
    /// (Aitken). A solution that does not converge is made not finite.
    fn solve(&mut self, system: &System, omega: f64) {
        self.solution.clear(system.unknowns);
        let mut share = f64::INFINITY;
        for step in 0..MOST_CORRECTIONS {
            if step == 0 {
                self.correction.clone_from(&system.loads);
            } else {
                system.residual(&self.solution, omega, &mut self.correction);
            }
            for (residual, scale) in self.correction.iter_mut().zip(&self.scale) {
                *residual *= scale;
            }
            self.matrix.solve(&mut self.correction);
            let series = if step % 2 == 1 {
                self.series()
            } else {
                Complex64::ONE
            };
            share = self.correct(series);
            if share <= CORRECTED {
                return;
            }
            std::mem::swap(&mut self.correction, &mut self.before);
        }
        if share > UNCERTAIN || share.is_nan() {
            self.solution.high.fill(Complex64::new(f64::NAN, f64::NAN));
        }
    }

    /// 1 / (1 - r), where r is the ratio of this correction to the one before.
    fn series(&self) -> Complex64 {
        let (mut product, mut square) = (Complex64::ZERO, 0.0);
        for (now, before) in self.correction.iter().zip(&self.before) {
            product += before.conj() * now;
            square += before.norm_sqr();
        }
        1.0 / (1.0 - product / square)
    }

    /// Adds the correction; returns its size relative to the solution.
    fn correct(&mut self, factor: Complex64) -> f64 {
        let (mut change, mut size) = (0.0_f64, 0.0_f64);
        for (index, correction) in self.correction.iter().enumerate() {
            let correction = correction * factor;
            self.solution.add(index, correction * self.scale[index]);
            change += correction.norm_sqr();
            size += (self.solution.high[index] / self.scale[index]).norm_sqr();
        }
        if change == 0.0 {
            return 0.0;
        }
        (change / size).sqrt()
    }
}

impl Twofold {
    /// A sum of forces.
    fn force(&self, force: &Force, omega: f64) -> Complex64 {
        let pulled = force.stretches.iter().map(|(factor, stretch)| {
            let terms = stretch.terms;
            let stretched = self.dot(&stretch.factors[..terms], &stretch.unknowns[..terms]);
            *factor * dynamic_stiffness(&stretch.by, omega) * stretched
        });
        let inertias = force.inertias.iter();
        let inertias = inertias.map(|of| self.high[of.number] * of.factor);
        let inertia = inertias.sum::<Complex64>() * (omega * omega);
        force.load + pulled.sum::<Complex64>() - inertia
    }
}

impl System {
    /// Writes every response at `frequency` (Hz, > 0) to `out`.
    pub(super) fn solve(&self, work: &mut Workspace, frequency: f64, out: &mut [Complex64]) {
        let omega = std::f64::consts::TAU * frequency;
        self.factor(work, omega);
        work.solve(self, omega);
        let x = &work.solution.high;
        for (value, source) in out.iter_mut().zip(&self.sources) {
            *value = source.value(|source| match source {
                Source::Motion(terms, measure) => {
                    let moved = terms.iter().map(|of| x[of.number] * of.factor);
                    derivative(omega, *measure) * moved.sum::<Complex64>()
                }
                Source::Force(force) => work.solution.force(force, omega),
                Source::Energy => self.energy(x).into(),
            });
        }
    }

    /// Factors the dynamic stiffness, scaled so that each diagonal entry's parts have size 1: so forces and moments,
    /// beam and subsystems are comparable in the choice of pivots.
    fn factor(&self, work: &mut Workspace, omega: f64) {
        work.scale.clear();
        work.scale.resize(self.unknowns, 0.0);
        let square = omega * omega;
        for stretch in &self.stretches {
            let k = dynamic_stiffness(&stretch.by, omega).norm();
            for (unknown, factor) in stretch.pairs() {
                work.scale[unknown] += factor * factor * k;
            }
        }
        for inertia in self.inertias.iter().filter(|i| i.row == i.column) {
            work.scale[inertia.row] += square * inertia.value;
        }
        for scale in &mut work.scale {
            *scale = 1.0 / scale.sqrt();
        }
        let half = self.half_width;
        work.matrix.clear(self.unknowns, half);
        let mut add = |row: usize, column: usize, value: Complex64| {
            let scale = work.scale[row] * work.scale[column];
            work.matrix.row_mut(row)[column + half - row] += value * scale;
        };
        for stretch in &self.stretches {
            let k = dynamic_stiffness(&stretch.by, omega);
            stretch.products(|row, column, product| add(row, column, k * product));
        }
        for inertia in &self.inertias {
            add(
                inertia.row,
                inertia.column,
                (-square * inertia.value).into(),
            );
        }
        work.matrix.factor();
    }

    /// The residual of the solution.
    ///
    /// The stretches use twofold precision, so the residual is accurate for a smooth solution: the error of an
    /// assembled stiffness matrix, which grows with the fourth power of the number of elements, does not occur.
    fn residual(&self, solution: &Twofold, omega: f64, out: &mut Vec<Complex64>) {
        out.clear();
        out.extend(&self.loads);
        for stretch in &self.stretches {
            let terms = stretch.terms;
            let stretched = solution.dot(&stretch.factors[..terms], &stretch.unknowns[..terms]);
            let force = dynamic_stiffness(&stretch.by, omega) * stretched;
            for (unknown, factor) in stretch.pairs() {
                out[unknown] -= force * factor;
            }
        }
        for inertia in &self.inertias {
            let value = omega * omega * inertia.value;
            out[inertia.row] += solution.high[inertia.column] * value;
        }
    }

    /// `E_V` = int rho A (|W|^2 + |V|^2) + rho `I_0` |Psi|^2 dx (Chen & Liu 2022, Section 4.2) from the elements'
    /// mass matrices, without the coupling term.
    fn energy(&self, x: &[Complex64]) -> f64 {
        let of = |unknown: Unknown| unknown.map_or(Complex64::ZERO, |of| x[of.number] * of.factor);
        let mut sum = 0.0;
        for element in &self.elements {
            let moved = element.unknowns.map(of);
            for (row, weights) in self.vibration[element.span].iter().enumerate() {
                for (column, weight) in weights.iter().enumerate() {
                    if *weight != 0.0 {
                        sum += weight * (moved[row].conj() * moved[column]).re;
                    }
                }
            }
        }
        sum
    }
}

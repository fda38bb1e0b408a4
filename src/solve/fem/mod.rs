//! Conventional finite elements, an independent reference for the exact solver.
//!
//! Bending of w and v and torsion with warping of psi: two nodes per element, six unknowns per node (w, psi, v and the
//! rotations, which are their slopes without shear deformation), consistent mass with the coupling by the offsets of the
//! centroid, three more unknowns for the mass of every subsystem (for the paper's beam: Chen & Liu, Mathematics 2022,
//! 10(16), 2849, Section 3 and Appendix E). The receptance follows from `((1 + i eta) K + K_N + K_s + i omega C - omega^2
//! M) x = F` at each frequency. The matrices come from the shape functions (`beam_element`) and the stretches of the
//! springs, without any formula of the exact solver.
//!
//! A natural frequency is too high by a fraction (k h)^4 / 1440, where k is the wave number of its mode and h the
//! length of an element, so every smooth measure of the error falls with the fourth power of h, until rounding (which
//! grows like h^-4 towards low frequencies) dominates. With shear deformation, whose force is constant along an element,
//! it falls with the second power.
//!
//! Without warping stiffness (`Gamma_0` = 0) the elements are the same without the term of psi''. A torque then makes
//! the rate of twist jump, so each position inside the beam has two unknowns psi', and a response reads their mean; a
//! restraint of psi' at an end does not affect the twist next to it. A joint has two unknowns for each motion that it
//! releases, with the stretch of its spring between them; everything else at its position is on the right one.
//!
//! The elements of a beam of several uniform parts have the matrices of their part, moved to the axis of the beam. All
//! motions are continuous where parts meet, except psi' at the end of one without warping stiffness: there it is free, and
//! supports and joints of psi' are those of the part with warping stiffness.

mod assembly;
mod band;
mod beam_element;
mod hermite;
mod mesh;
mod solution;
mod twofold;

use nalgebra::{Cholesky, DMatrix};
use std::sync::atomic::AtomicBool;

use self::assembly::System;
use self::solution::Workspace;
use super::Cancelled;
use super::layout::Layout;
use super::sweep::{Frf, one_by_one};
use crate::model::{Checked, Model, UniformPart};

/// Elements per wavelength 2 pi / kappa of the shortest wave, travelling or decaying, at the top of the sweep.
const ELEMENTS_A_WAVE: f64 = 60.0;
/// The fewest and the most elements that [`default_elements`] gives.
const BOUNDS: (f64, f64) = (16.0, 1000.0);
/// The fewest elements of a part of the beam.
const FEWEST_OF_PART: f64 = 4.0;
/// Positions closer than this fraction of the length are merged: an element so much shorter than the others would cost
/// more digits than it adds.
const MERGE: f64 = 1e-6;

/// A model with its mesh.
#[derive(Debug, Clone)]
pub struct FiniteElements<'a> {
    layout: Layout<'a>,
    /// Elements in each span between the positions of loads, subsystems and responses.
    divisions: Vec<usize>,
}

impl<'a> FiniteElements<'a> {
    /// Divides the beam of a checked model into about `elements` elements, of nearly equal length in each uniform part of
    /// it, and as many a wavelength in all of them at the top of the sweep; with a node at every subsystem, load and
    /// response: at least one element per span, so there may be more than requested.
    pub fn new(model: &'a Model, elements: usize) -> Self {
        let layout = Layout::new(model, MERGE * model.length());
        let waves_of = |part: &UniformPart| waves(part, model.sweep.to);
        let all: f64 = model.uniform_parts().iter().map(waves_of).sum();
        let ends = layout.positions.windows(2);
        let divisions = ends.zip(&layout.parts).map(|(ends, part)| {
            let of_part = (elements as f64 * (waves_of(part) / all)).max(FEWEST_OF_PART);
            let per_length = of_part / (part.end - part.start);
            ((ends[1] - ends[0]) * per_length).round().max(1.0) as usize
        });
        let divisions = divisions.collect();
        Self { layout, divisions }
    }

    /// The same with every element halved.
    #[must_use]
    pub fn halved(&self) -> Self {
        Self {
            layout: self.layout.clone(),
            divisions: self.divisions.iter().map(|count| 2 * count).collect(),
        }
    }

    /// The number of elements.
    pub fn elements(&self) -> usize {
        self.divisions.iter().sum()
    }

    /// Solves at each frequency (Hz, > 0), on all cores.
    ///
    /// Values and units are those of [`solve::sweep`](super::sweep()); exactly at an undamped resonance of the mesh
    /// they are not finite.
    ///
    /// # Errors
    /// `cancel` became true before the end.
    pub fn sweep(&self, frequencies: &[f64], cancel: &AtomicBool) -> Result<Frf, Cancelled> {
        let system = System::new(&self.layout, &self.divisions);
        one_by_one(
            self.layout.model,
            frequencies,
            cancel,
            &|work: &mut Workspace, frequency, row| system.solve(work, frequency, row),
        )
    }

    /// The lowest `count` undamped natural frequencies, Hz, ascending; rigid-body ones near 0.
    ///
    /// Dense: for some hundred elements. Ignores loss factor and dampers.
    pub fn natural_frequencies(&self, count: usize) -> Vec<f64> {
        let system = System::new(&self.layout, &self.divisions);
        lowest_frequencies(self.layout.model, &system, count)
    }
}

/// [`FiniteElements::sweep`] of a mesh of about `elements` elements.
///
/// # Errors
/// `cancel` became true before the end.
pub fn sweep(
    model: &Checked,
    elements: usize,
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Result<Frf, Cancelled> {
    FiniteElements::new(model, elements).sweep(frequencies, cancel)
}

/// [`FiniteElements::natural_frequencies`] of a mesh of about `elements` elements, Hz.
pub fn natural_frequencies(model: &Checked, elements: usize, count: usize) -> Vec<f64> {
    FiniteElements::new(model, elements).natural_frequencies(count)
}

/// Enough elements for the model's sweep: 60 (with shear deformation 180) per wavelength of the shortest wave of each part at
/// the highest frequency; at least 16, at most 1,000.
pub fn default_elements(model: &Checked) -> usize {
    let parts = model.uniform_parts();
    let lengths = parts.iter().map(|part| waves(part, model.sweep.to));
    // Shear deformation converges with the second power only.
    let finer = if model.beam.theory.has_shear() {
        3.0
    } else {
        1.0
    };
    (finer * ELEMENTS_A_WAVE * lengths.sum::<f64>())
        .clamp(BOUNDS.0, BOUNDS.1)
        .ceil() as usize
}

/// The length of a part of the beam in wavelengths of its shortest bending, torsion or warping wave at a frequency, Hz,
/// without the coupling of bending and torsion.
fn waves(part: &UniformPart, frequency: f64) -> f64 {
    let (section, material) = (&part.beam.section, &part.beam.material);
    let (e, g, density) = (
        material.young_modulus,
        material.shear_modulus,
        material.density,
    );
    let omega = std::f64::consts::TAU * frequency;
    let bending = e * section.second_moment_y.min(section.second_moment_z);
    let bending = (omega * omega * density * section.area / bending).powf(0.25);
    // E Gamma_0 k^4 -+ G J k^2 = omega^2 rho I_0: the upper sign travels, the lower decays, and faster.
    let torsion = g * section.torsion_constant;
    let inertia = omega * omega * density * section.polar_moment;
    let warping = e * section.warping_constant;
    let twist = if warping > 0.0 {
        let root = (torsion * torsion + 4.0 * warping * inertia).sqrt();
        ((torsion + root) / (2.0 * warping)).sqrt()
    } else {
        (inertia / torsion).sqrt()
    };
    (part.end - part.start) * bending.max(twist) / std::f64::consts::TAU
}

/// The lowest `count` undamped natural frequencies, Hz, ascending; rigid-body ones are near 0. At most as many as
/// unknowns, and none if the arithmetic fails.
///
/// K x = lambda M x is solved as the largest mu of `M x = mu (K + sigma M) x`, lambda = 1/mu - sigma: K may be singular
/// (rigid-body motions) and M too (a mass without moment of inertia), their sum is not.
fn lowest_frequencies(model: &Model, system: &System, count: usize) -> Vec<f64> {
    let shift = shift(model);
    let mut mass = DMatrix::<f64>::zeros(system.unknowns, system.unknowns);
    system.mass(|row, column, value| mass[(row, column)] += value);
    let mut sum = &mass * shift;
    system.stiffness(|row, column, value| sum[(row, column)] += value);
    let Some(lower) = Cholesky::new(sum).map(Cholesky::unpack) else {
        return Vec::new();
    };
    // L^-1 M L^-T has the same mu.
    let reduced = lower
        .solve_lower_triangular(&mass)
        .and_then(|half| lower.solve_lower_triangular(&half.transpose()));
    let Some(reduced) = reduced else {
        return Vec::new();
    };
    let symmetric = (&reduced + reduced.transpose()) * 0.5;
    let mut largest: Vec<f64> = symmetric.symmetric_eigenvalues().iter().copied().collect();
    largest.sort_by(|a, b| b.total_cmp(a));
    largest
        .iter()
        .take(count)
        .map(|mu| (1.0 / mu - shift).max(0.0).sqrt() / std::f64::consts::TAU)
        .collect()
}

/// sigma, 1/s2: about lambda of the free beam's first bending mode, (4.73 / L)^4 E I / rho A, with the least of all parts.
fn shift(model: &Model) -> f64 {
    let parts = model.uniform_parts();
    let rates = parts.iter().map(|part| {
        let (section, material) = (&part.beam.section, &part.beam.material);
        let moment = section.second_moment_y.min(section.second_moment_z);
        material.young_modulus * moment / (material.density * section.area)
    });
    (4.73 / model.length()).powi(4) * rates.fold(f64::INFINITY, f64::min)
}

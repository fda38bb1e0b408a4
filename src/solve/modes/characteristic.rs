//! The characteristic function of a model: zero at its natural frequencies and nowhere else.
//!
//! The state (q, p) propagates from the six solutions that the left support allows to the six equations of the right
//! one. The determinant of these equations times the determinants of the blocked masses is an entire function of omega
//! whose zeros are the natural frequencies with their multiplicity: real without damping, complex with it. The
//! recursion of reflections (see [`kernel`](super::super::kernel)) computes it as a product of small determinants,
//!
//! `F = det(left) det(right) prod(omega^4 m^2 det(station)) exp(sum kappa l) / (det[Q; M] det[S; P])`
//!
//! in which the choice of each wave's sign and scale cancels. A Maxwell branch gives it a pole, by which it is
//! multiplied. No factor contains a growing exponential. The kernel computes it at several frequencies at once.

use num_complex::Complex64;
use rayon::prelude::*;

use super::super::kernel::{MOST_LANES, Prepared, Solver, waves};
use super::super::linear::Magnified;
use super::super::plan::Plan;
use super::super::waves::BeamConstants;
use super::blocked::{distances, poles};
use crate::model::Model;

/// A model laid out for the search for its natural frequencies.
#[derive(Debug)]
pub(super) struct Characteristic {
    prepared: Prepared,
    /// Length of the beam, m.
    length: f64,
    /// Its poles, rad/s.
    poles: Vec<Complex64>,
}

impl Characteristic {
    /// Lays out a checked model without its loads and responses.
    pub(super) fn new(model: &Model) -> Self {
        let bare = Model {
            forces: Vec::new(),
            responses: Vec::new(),
            ..model.clone()
        };
        let plan = Plan::new(&bare);
        Self {
            poles: poles(&plan),
            prepared: Prepared::new(plan),
            length: model.length(),
        }
    }

    /// The largest rate of the phase of F with ln omega at `omega`, rad/s: the sum of kappa l over the waves of its spans.
    pub(super) fn turning(&self, omega: f64) -> f64 {
        let plan = &self.prepared.plan;
        let of_beam = |beam: &BeamConstants| -> f64 {
            let kappa = waves(beam, omega.into()).kappa.into_iter();
            let finite = kappa.filter(|kappa| kappa.re.is_finite());
            finite.map(Complex64::norm).sum()
        };
        let rates: Vec<f64> = plan.beams.iter().map(of_beam).collect();
        let spans = plan.spans.iter().map(|&span| &plan.kinds[span]);
        1.0 + 0.5 * spans.map(|of| of.length * rates[of.beam]).sum::<f64>()
    }

    /// An angular frequency, rad/s, at which the beam is short compared with its waves, so that F has lost some but not
    /// all digits.
    pub(super) fn slowest(&self) -> f64 {
        const SHORT: f64 = 0.1;
        let beams = self.prepared.plan.beams.iter();
        let speeds = beams.map(|beam| beam.bending_w.re.max(beam.bending_v.re) / beam.mass);
        (SHORT / self.length).powi(2) * speeds.fold(0.0, f64::max).sqrt()
    }

    /// F at each of some complex angular frequencies, rad/s.
    pub(super) fn at(&self, omegas: &[Complex64]) -> Vec<Magnified> {
        /// The smallest number of stations worth a thread.
        const WORTH: usize = 100;
        let mut values = vec![Magnified::ONE; omegas.len()];
        let stations = MOST_LANES * (2 + self.prepared.plan.stations.len());
        omegas
            .par_chunks(MOST_LANES)
            .zip(values.par_chunks_mut(MOST_LANES))
            .with_min_len(WORTH.div_ceil(stations))
            .for_each_init(Solver::default, |solver, (omegas, out)| {
                solver.characteristic(&self.prepared, omegas, out);
                if !self.poles.is_empty() {
                    for (value, &omega) in out.iter_mut().zip(omegas) {
                        *value = value.by(&distances(&self.poles, omega));
                    }
                }
            });
        values
    }

    /// F / F' at each of some points, rad/s; the derivative is a difference over a very small distance, so its error
    /// only slows down the last steps.
    pub(super) fn newton_steps(&self, places: &[Complex64]) -> Vec<Complex64> {
        const DIFFERENCE: f64 = 1e-7;
        // In the radial direction: on the imaginary axis the function is real.
        let moved = places.iter().map(|z| z + DIFFERENCE * z);
        let both: Vec<Complex64> = places.iter().copied().chain(moved).collect();
        let values = self.at(&both);
        let (here, there) = values.split_at(places.len());
        let step = |index: usize| {
            if here[index].log == f64::NEG_INFINITY {
                // Exactly on the root.
                return Complex64::ZERO;
            }
            let change = there[index].ratio(&here[index]) - 1.0;
            DIFFERENCE * places[index] * inverse(change)
        };
        (0..places.len()).map(step).collect()
    }
}

/// 1/z, and 0 if z is 0: of two coinciding roots each moves by its own step.
pub(super) fn inverse(z: Complex64) -> Complex64 {
    if z.norm_sqr() == 0.0 {
        Complex64::ZERO
    } else {
        z.inv()
    }
}

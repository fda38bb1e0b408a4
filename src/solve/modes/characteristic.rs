//! The characteristic function of a model: zero at its natural frequencies and nowhere else.
//!
//! With the state (q, p) carried from the six solutions that the left support allows to the six equations of the right
//! one, the determinant of these equations times the determinants of the blocked masses is an entire function of omega
//! whose zeros are the natural frequencies, as often as they occur: real without damping, complex with it. The
//! recursion of reflections (see [`kernel`](super::super::kernel)) gives it as a product of small determinants,
//!
//! `F = det(left) det(right) prod(omega^4 m^2 det(station)) exp(L sum kappa) / (det[Q; M] det[S; P])`
//!
//! in which the choice of each wave's sign and scale cancels. No growing exponential occurs in a factor. The kernel of
//! the sweeps computes it at several frequencies at once (see [`kernel`](super::super::kernel)).

use num_complex::Complex64;
use rayon::prelude::*;

use super::super::kernel::{MOST_LANES, Prepared, Solver, waves};
use super::super::linear::Magnified;
use super::super::plan::Plan;
use crate::model::Model;

/// A model laid out to find its natural frequencies.
#[derive(Debug)]
pub(super) struct Characteristic {
    prepared: Prepared,
    /// Length of the beam, m.
    length: f64,
}

impl Characteristic {
    /// Lays out a checked model without its loads and responses.
    pub(super) fn new(model: &Model) -> Self {
        let bare = Model {
            forces: Vec::new(),
            responses: Vec::new(),
            ..model.clone()
        };
        Self {
            prepared: Prepared::new(Plan::new(&bare)),
            length: model.beam.length,
        }
    }

    /// How fast F turns at most with ln omega at `omega`, rad/s: the sum of kappa L over its waves.
    pub(super) fn turning(&self, omega: f64) -> f64 {
        let waves = waves(&self.prepared.plan.beam, omega.into());
        let finite = waves.kappa.iter().filter(|kappa| kappa.re.is_finite());
        1.0 + 0.5 * self.length * finite.map(|kappa| kappa.norm()).sum::<f64>()
    }

    /// An angular frequency, rad/s, at which the beam is short against its waves, so that F has lost digits but not all.
    pub(super) fn slowest(&self) -> f64 {
        const SHORT: f64 = 0.1;
        let beam = &self.prepared.plan.beam;
        let stiffness = beam.bending_w.re.max(beam.bending_v.re);
        (SHORT / self.length).powi(2) * (stiffness / beam.mass).sqrt()
    }

    /// F at each of some complex angular frequencies, rad/s.
    pub(super) fn at(&self, omegas: &[Complex64]) -> Vec<Magnified> {
        /// Stations that are worth a thread of their own.
        const WORTH: usize = 100;
        let mut values = vec![Magnified::ONE; omegas.len()];
        let stations = MOST_LANES * (2 + self.prepared.plan.stations.len());
        omegas
            .par_chunks(MOST_LANES)
            .zip(values.par_chunks_mut(MOST_LANES))
            .with_min_len(WORTH.div_ceil(stations))
            .for_each_init(Solver::default, |solver, (omegas, out)| {
                solver.characteristic(&self.prepared, omegas, out);
            });
        values
    }

    /// F / F' at each of some places, rad/s; the derivative by a difference over so little that its error only slows the
    /// last steps.
    pub(super) fn newton_steps(&self, places: &[Complex64]) -> Vec<Complex64> {
        const DIFFERENCE: f64 = 1e-7;
        // Along the radius: on the imaginary axis the function is real.
        let moved = places.iter().map(|z| z + DIFFERENCE * z);
        let both: Vec<Complex64> = places.iter().copied().chain(moved).collect();
        let values = self.at(&both);
        let (here, there) = values.split_at(places.len());
        let step = |index: usize| {
            if here[index].log == f64::NEG_INFINITY {
                // On the root to the last digit.
                return Complex64::ZERO;
            }
            let change = there[index].ratio(&here[index]) - 1.0;
            DIFFERENCE * places[index] * inverse(change)
        };
        (0..places.len()).map(step).collect()
    }
}

/// 1/z, and 0 where z is 0: a root on top of another leaves by its own step.
pub(super) fn inverse(z: Complex64) -> Complex64 {
    if z.norm_sqr() == 0.0 {
        Complex64::ZERO
    } else {
        z.inv()
    }
}

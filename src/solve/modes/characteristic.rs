//! The characteristic function of a model: zero at its natural frequencies and nowhere else.
//!
//! With the state (q, p) carried from the six solutions that the left support allows to the six equations of the right
//! one, the determinant of these equations times the determinants of the blocked masses is an entire function of omega
//! whose zeros are the natural frequencies, as often as they occur: real without damping, complex with it. The
//! recursion of reflections (see [`recursion`](super::super::recursion)) gives it as a product of small determinants,
//!
//! `F = det(left) det(right) prod(omega^4 m^2 det(station)) exp(L sum kappa) / (det[Q; M] det[S; P])`
//!
//! in which the choice of each wave's sign and scale cancels. No growing exponential occurs in a factor.

use num_complex::Complex64;

use super::super::ends::{left_end, left_system, right_system};
use super::super::linear::{Magnified, Matrix, multiply_determinant};
use super::super::plan::{Event, Plan};
use super::super::reflection::decay;
use super::super::waves::Waves;
use crate::model::Model;

/// A model laid out to find its natural frequencies.
#[derive(Debug, Clone)]
pub(super) struct Characteristic {
    plan: Plan,
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
            plan: Plan::new(&bare),
            length: model.beam.length,
        }
    }

    /// How fast F turns at most with ln omega at `omega`, rad/s: the sum of kappa L over its waves.
    pub(super) fn turning(&self, omega: f64) -> f64 {
        let waves = Waves::new(&self.plan.beam, omega.into());
        let finite = waves.kappa.iter().filter(|kappa| kappa.re.is_finite());
        1.0 + 0.5 * self.length * finite.map(|kappa| kappa.norm()).sum::<f64>()
    }

    /// An angular frequency, rad/s, at which the beam is short against its waves, so that F has lost digits but not all.
    pub(super) fn slowest(&self) -> f64 {
        const SHORT: f64 = 0.1;
        let beam = &self.plan.beam;
        let stiffness = beam.bending_w.re.max(beam.bending_v.re);
        (SHORT / self.length).powi(2) * (stiffness / beam.mass).sqrt()
    }

    /// F at the complex angular frequency `omega`, rad/s.
    pub(super) fn at(&self, omega: Complex64) -> Magnified {
        let plan = &self.plan;
        let waves = Waves::new(&plan.beam, omega);
        let decays: Vec<_> = plan.lengths.iter().map(|&l| decay(&waves, l)).collect();
        let mut product = Magnified::ONE;
        multiply_determinant(&mut product, left_system(plan, &waves, omega).0);
        let mut at = left_end(plan, &waves, omega);
        for (station, &span) in plan.stations.iter().zip(&plan.spans) {
            at.propagate(&decays[span]);
            if let Event::Attachment(attachment) = &station.event {
                let contact = at.contact(&waves);
                let system = attachment.system(omega, &contact.receptance);
                multiply_determinant(&mut product, system);
                product.times(omega.powu(4));
                at.attach(&contact, omega, attachment);
            }
        }
        at.propagate(&decays[plan.last_span()]);
        let right = right_system(plan, &waves, omega, &at);
        multiply_determinant(&mut product, right.of_b);
        self.divide_by_waves(&mut product, &waves);
        product
    }

    /// Takes out the scale and the growth of the waves.
    fn divide_by_waves(&self, product: &mut Magnified, waves: &Waves) {
        let mut scale = Magnified::ONE;
        multiply_determinant(&mut scale, stacked(&waves.displacement, &waves.moment));
        multiply_determinant(&mut scale, stacked(&waves.slope, &waves.force));
        product.log -= scale.log;
        product.direction *= scale.direction.conj();
        for kappa in waves.kappa.iter().filter(|kappa| kappa.re.is_finite()) {
            let growth = kappa * self.length;
            product.log += growth.re;
            product.direction *= Complex64::from_polar(1.0, growth.im);
        }
    }
}

fn stacked(above: &Matrix<3, 6>, below: &Matrix<3, 6>) -> Matrix<6, 6> {
    std::array::from_fn(|row| if row < 3 { above[row] } else { below[row - 3] })
}

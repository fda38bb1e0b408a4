//! The shape of a mode, normalized for drawing.

use num_complex::Complex64;

use crate::solve::modes;

/// A quantity below this share of the others (1 m to 1 rad) is not magnified.
const NEGLIGIBLE: f64 = 1e-6;

/// Amplitudes above this share of the largest count as equally large.
const ABOUT: f64 = 0.9;

/// The motion of one mode, without its decay.
#[derive(Debug)]
pub struct Shape {
    /// The model's generation.
    pub generation: u64,
    /// The mode's index.
    pub mode: usize,
    /// Places along the beam, m.
    pub positions: Vec<f64>,
    /// w, v and psi along the beam. The largest translation, masses included, and the largest rotation are 1.
    pub beam: [Vec<Complex64>; 3],
    /// The positions of the masses, m, rising as in the model.
    pub places: Vec<f64>,
    /// y, z and theta of the masses, on the scales of w, v and psi.
    pub masses: [Vec<Complex64>; 3],
    /// The largest rotation for 1 m of the largest translation, rad; none without translation.
    pub rotation: Option<f64>,
}

impl Shape {
    /// Normalizes a solved shape, at the phase of its largest extent. `places` are those of the enabled subsystems.
    pub(crate) fn new(generation: u64, mode: usize, solved: modes::Shape, places: &[f64]) -> Self {
        let beam = [solved.w, solved.v, solved.psi];
        let mass = |motion: usize| solved.masses.iter().map(|m| m[motion]).collect();
        let masses: [Vec<Complex64>; 3] = [mass(0), mass(1), mass(2)];
        let largest = |motion: usize| {
            let all = beam[motion].iter().chain(&masses[motion]);
            all.map(|u| u.norm()).fold(0.0, f64::max)
        };
        let (translation, rotation) = (largest(0).max(largest(1)), largest(2));
        let scales = [
            translation.max(NEGLIGIBLE * rotation),
            rotation.max(NEGLIGIBLE * translation),
        ];
        let widest = if translation > NEGLIGIBLE * rotation {
            translation
        } else {
            rotation
        };
        let back = to_widest(beam.iter().chain(&masses).flatten(), widest);
        let scaled = |motion: usize, curve: Vec<Complex64>| -> Vec<Complex64> {
            let scale = scales[usize::from(motion == 2)];
            let factor = if scale > 0.0 { back / scale } else { back };
            curve.into_iter().map(|u| u * factor).collect()
        };
        let mut motions = 0..3;
        let beam = beam.map(|curve| scaled(motions.next().unwrap_or(0), curve));
        let mut motions = 0..3;
        let masses = masses.map(|curve| scaled(motions.next().unwrap_or(0), curve));
        Self {
            generation,
            mode,
            positions: solved.positions,
            beam,
            places: places.to_vec(),
            masses,
            rotation: (translation > NEGLIGIBLE * rotation).then(|| rotation / translation),
        }
    }

    /// A curve at a phase angle (rad).
    pub fn at(curve: &[Complex64], angle: f64) -> Vec<f64> {
        let turn = Complex64::from_polar(1.0, angle);
        curve.iter().map(|u| (u * turn).re).collect()
    }
}

/// The phase factor that makes most of a motion real, and positive at the first place that is about as large as
/// `widest`.
fn to_widest<'a>(motion: impl Iterator<Item = &'a Complex64> + Clone, widest: f64) -> Complex64 {
    // The phase of the sum of squares is twice the common phase.
    let square: Complex64 = motion.clone().map(|u| u * u).sum();
    let back = Complex64::from_polar(1.0, -0.5 * square.arg());
    let mut wide = motion.filter(|u| u.norm() > ABOUT * widest);
    match wide.next() {
        Some(first) if (first * back).re < 0.0 => -back,
        _ => back,
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::solve::modes::Shares;

    fn shape(w: Complex64, psi: Complex64) -> Shape {
        let solved = modes::Shape {
            positions: vec![0.0, 1.0],
            w: vec![w, -0.5 * w],
            psi: vec![psi, psi],
            v: vec![Complex64::ZERO; 2],
            masses: vec![[2.0 * w, Complex64::ZERO, Complex64::ZERO]],
            shares: Shares::default(),
        };
        Shape::new(1, 0, solved, &[0.5])
    }

    #[test]
    fn a_shape_is_turned_to_its_widest_and_brought_to_one() {
        // A standing wave is real for any phase; the mass moves most.
        let turned = shape(Complex64::from_polar(0.03, 1.1), Complex64::ZERO);
        let [w, ..] = &turned.beam;
        for (u, expected) in w.iter().zip([0.5, -0.25]) {
            assert!((u - expected).norm() < 1e-12);
        }
        assert!((turned.masses[0][0] - 1.0).norm() < 1e-12);
        assert_eq!(turned.rotation, Some(0.0));
    }

    #[test]
    fn rotations_have_a_scale_of_their_own_but_noise_none() {
        let mixed = shape(Complex64::new(0.1, 0.0), Complex64::new(0.05, 0.0));
        assert!((mixed.beam[2][0].re.abs() - 1.0).abs() < 1e-12);
        // 0.05 rad to the mass's 0.2 m.
        assert!((mixed.rotation.unwrap() - 0.25).abs() < 1e-12);
        let twist = shape(Complex64::new(1e-18, 0.0), Complex64::ONE);
        assert_eq!(twist.rotation, None);
        assert!(twist.beam[0][0].norm() < 1e-11);
    }

    #[test]
    fn half_a_period_later_all_is_on_the_other_side() {
        let curve = [Complex64::new(0.3, 0.0), Complex64::new(0.0, 0.4)];
        let (now, later) = (Shape::at(&curve, 0.7), Shape::at(&curve, 0.7 + TAU / 2.0));
        assert!(now.iter().zip(later).all(|(a, b)| (a + b).abs() < 1e-12));
    }
}

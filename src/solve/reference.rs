//! The reference force for normalised responses.

use num_complex::Complex64;

use crate::model::Checked;
use crate::unit::Load;

/// The only force of a model, by which its responses can be divided.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reference {
    /// Its kind.
    pub load: Load,
    /// Its complex amplitude, zero to peak, N, N m or N m2.
    pub amplitude: Complex64,
}

impl Reference {
    /// The only enabled force of a model; `None` if there are several, or if it is 0.
    pub fn of(model: &Checked) -> Option<Self> {
        let mut forces = model.forces.iter().filter(|force| force.enabled);
        let (force, None) = (forces.next()?, forces.next()) else {
            return None;
        };
        let amplitude = Complex64::from_polar(force.amplitude, force.phase.to_radians());
        (amplitude != Complex64::ZERO).then(|| Self {
            load: force.target.load(),
            amplitude,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::checked;

    #[test]
    fn only_one_force_makes_a_ratio() {
        let preset = |name| {
            crate::model::read(crate::presets::find(name).unwrap().text)
                .unwrap()
                .into_inner()
        };
        let mut one = preset("fig05a");
        one.forces.truncate(1);
        one.forces[0].amplitude = 2.0;
        one.forces[0].phase = 90.0;
        let reference = Reference::of(&checked(&one)).unwrap();
        assert_eq!(reference.load, Load::Force);
        assert!((reference.amplitude - Complex64::new(0.0, 2.0)).norm() < 1e-15);
        one.forces.push(one.forces[0].clone());
        assert_eq!(Reference::of(&checked(&one)), None);
        one.forces[1].enabled = false;
        assert!(Reference::of(&checked(&one)).is_some());
    }
}

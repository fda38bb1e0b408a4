//! Laws that derivatives obey by Euler's theorem on homogeneous functions (closed form): if a response is proportional
//! to a power of a factor that multiplies parameters, the sum of `power p dr/dp` over them is that power times the
//! response.

use crate::checked::checked;
use beamtune::model::{
    At, BeamMotion, Measure, Model, Place, Quantity, Reaction, SpringMeasure, Target,
};
use beamtune::solve::sensitivity::Differentiator;

use super::{preset, rich, supported, thousand, with_forces};

/// The exponents of a factor for a response and for the frequency.
struct Law {
    /// Of a parameter, by its path.
    of: fn(&str) -> f64,
    frequency: f64,
    /// Of a response.
    response: fn(&Quantity) -> f64,
}

/// The last word of a path.
fn key(path: &str) -> &str {
    path.rsplit('.').next().unwrap()
}

/// All stiffnesses, dampings and inertias times alpha: a motion is proportional to 1 / alpha; so is the energy, by
/// alpha / alpha^2. No force changes.
const STIFFER: Law = Law {
    of: |path| match key(path) {
        "young_modulus" | "shear_modulus" | "density" | "stiffness" | "damping" | "mass"
        | "inertia" => 1.0,
        _ => 0.0,
    },
    frequency: 0.0,
    response: |quantity| match quantity {
        Quantity::Motion(..)
        | Quantity::Energy
        | Quantity::Spring(_, _, SpringMeasure::Stretch) => -1.0,
        Quantity::Reaction(_) | Quantity::InternalForce(..) | Quantity::Spring(..) => 0.0,
    },
};

/// All loads times alpha.
const LOUDER: Law = Law {
    of: |path| f64::from(key(path) == "amplitude"),
    frequency: 0.0,
    response: |quantity| match quantity {
        Quantity::Energy => 2.0,
        _ => 1.0,
    },
};

/// The unit of time: stiffnesses are proportional to alpha^2, dampers and the frequency to alpha.
const FASTER: Law = Law {
    of: |path| match key(path) {
        "young_modulus" | "shear_modulus" | "stiffness" => 2.0,
        "damping" => 1.0,
        _ => 0.0,
    },
    frequency: 1.0,
    response: |quantity| match quantity {
        Quantity::Energy => -4.0,
        Quantity::Motion(_, measure) => match measure {
            Measure::Displacement => -2.0,
            Measure::Velocity => -1.0,
            Measure::Acceleration => 0.0,
        },
        Quantity::Spring(_, _, SpringMeasure::Stretch) => -2.0,
        Quantity::Reaction(_) | Quantity::InternalForce(..) | Quantity::Spring(..) => 0.0,
    },
};

/// The unit of length; that of force (kg m/s2) follows it.
const LONGER: Law = Law {
    of: |path| {
        let word = key(path);
        let turns = path.contains(".psi.") || path.contains("_slope.");
        let rotation = if path.contains(".psi_slope.") {
            4.0
        } else if turns {
            2.0
        } else {
            0.0
        };
        match word {
            "length" | "position" | "arm_left" | "arm_right" | "mount_y" | "mount_z"
            | "centroid_offset" | "y" | "z" => 1.0,
            "young_modulus" | "shear_modulus" => -1.0,
            "density" => -3.0,
            "area" => 2.0,
            "second_moment_y" | "second_moment_z" | "torsion_constant" | "polar_moment" => 4.0,
            "warping_constant" => 6.0,
            "inertia" if path.starts_with("subsystems") => 2.0,
            "stiffness" | "damping" | "mass" | "inertia" => rotation,
            _ => 0.0,
        }
    },
    frequency: 0.0,
    response: |quantity| match quantity {
        Quantity::Energy => 2.0,
        Quantity::Motion(Target::Beam(_, motion), _) => match motion {
            BeamMotion::W | BeamMotion::V => 1.0,
            BeamMotion::PsiSlope => -1.0,
            _ => 0.0,
        },
        Quantity::Motion(Target::Mass(_, motion), _) => {
            f64::from(!matches!(motion, beamtune::model::MassMotion::Theta))
        }
        Quantity::Reaction(Reaction::Support(_, motion)) | Quantity::InternalForce(_, motion) => {
            load_power(&Target::Beam(Place::Left, *motion))
        }
        Quantity::Reaction(Reaction::Ground(_)) | Quantity::Spring(..) => 1.0,
    },
};

/// The exponent of the unit of length in a load.
fn load_power(target: &Target) -> f64 {
    match target {
        Target::Beam(_, BeamMotion::W | BeamMotion::V) => 1.0,
        Target::Beam(_, BeamMotion::PsiSlope) => 3.0,
        Target::Mass(_, motion) if !matches!(motion, beamtune::model::MassMotion::Theta) => 1.0,
        _ => 2.0,
    }
}

/// The largest deviation from a law over all responses of a model, relative to the largest term of its sum.
fn deviation(model: &Model, law: &Law, loads: fn(&Target) -> f64, frequency: f64) -> f64 {
    let differentiator = Differentiator::new(&checked(model));
    let quantities = model.responses.iter().filter(|of| of.enabled);
    let mut worst = 0.0_f64;
    for (gradient, response) in differentiator.at(frequency.into()).iter().zip(quantities) {
        let mut terms = vec![law.frequency * frequency * gradient.by_frequency];
        let paths = beamtune::model::path::texts(model, differentiator.ids());
        let parameters = paths.iter().zip(differentiator.values());
        for ((path, value), by) in parameters.zip(&gradient.by_parameter) {
            let power = match path.strip_prefix("forces.") {
                Some(rest) if key(path) == "amplitude" => {
                    let number: usize = rest.split('.').next().unwrap().parse().unwrap();
                    (law.of)(path) + loads(&model.forces[number - 1].target)
                }
                _ => (law.of)(path),
            };
            if power != 0.0 && *value != 0.0 {
                terms.push(power * value * by);
            }
        }
        terms.push(-(law.response)(&response.quantity) * gradient.value);
        let largest = terms.iter().map(|term| term.norm()).fold(0.0, f64::max);
        if largest > 0.0 {
            let sum: num_complex::Complex64 = terms.iter().sum();
            worst = worst.max(sum.norm() / largest);
        }
    }
    worst
}

/// Without parts at a fixed distance from the left end: no parameter gives their position.
fn without_places(mut model: Model) -> Model {
    let is_place = |target: &Target| matches!(target, Target::Beam(Place::Position(_), _));
    model.forces.retain(|force| !is_place(&force.target));
    let lies = |of: &Quantity| matches!(of.at(), Some(At::Beam(Place::Position(_))));
    model.responses.retain(|response| !lies(&response.quantity));
    model
}

/// The largest deviation from each law.
fn deviations(model: &Model, frequency: f64) -> [f64; 4] {
    let none = |_: &Target| 0.0;
    let lengths = without_places(model.clone());
    [
        deviation(model, &STIFFER, none, frequency),
        deviation(model, &LOUDER, none, frequency),
        deviation(model, &FASTER, none, frequency),
        deviation(&lengths, &LONGER, load_power, frequency),
    ]
}

/// Expected: rounding errors. Forces depend little on a stiff spring, and are small where they are differences.
#[test]
fn every_scaling_law_holds_for_forces() {
    for mut model in [
        with_forces(rich(true)),
        with_forces(rich(false)),
        with_forces(supported(true)),
    ] {
        model.responses.retain(|response| response.over.is_none());
        for frequency in [37.0, 100.0, 333.3] {
            let found = deviations(&model, frequency);
            assert!(
                found.iter().all(|found| *found < 1e-9),
                "{} {frequency} Hz: {found:?}",
                model.title
            );
        }
    }
}

/// Expected: only rounding errors, which at 1 Hz are those of a beam with waves far longer than itself.
#[test]
fn every_scaling_law_holds() {
    let models = [
        "fig05a",
        "fig08",
        "cantilever",
        "symmetric_section",
        "fig06",
        "fig16",
    ];
    let models = models.map(preset).into_iter().chain([
        rich(true),
        rich(false),
        supported(true),
        thousand(),
    ]);
    for model in models {
        for (frequency, allowed) in [
            (1.0, 1e-10),
            (37.0, 1e-12),
            (100.0, 1e-12),
            (333.3, 1e-12),
            (5000.0, 1e-12),
        ] {
            let found = deviations(&model, frequency);
            assert!(
                found.iter().all(|found| *found < allowed),
                "{} {frequency} Hz: {found:?}",
                model.title
            );
        }
    }
}

//! Active limits at an optimum, with the optima of closed forms.

use crate::checked::checked;
use std::f64::consts::{PI, TAU};
use std::path::Path;

use beamtune::model::{
    BeamMotion, Hold, Limit, Measure, Model, Place, Quantity, Response, SpringMeasure, SpringName,
    Support, Target, Variable,
};
use beamtune::tune::{Problem, Tuned};

use crate::absorber::{self, ABSORBER, MASS, STIFFNESS, mean_square, receptance_on, tuned};

const BUDGET: Option<usize> = Some(400);
const PEAK: &str = r#"objective = { minimise = "peak", response = "w", from = 5.0, to = 60.0 }"#;
const SUPPORTS: [&str; 2] = ["supports.left.w.stiffness", "supports.right.w.stiffness"];

fn variable(paths: &[&str], min: f64, max: f64) -> Variable {
    Variable {
        paths: paths.iter().map(|path| (*path).into()).collect(),
        hold: Hold::Equal,
        min,
        max,
        scale: None,
        tolerance: 0.0,
    }
}

fn limited(tune: &str, more: Vec<Variable>, limits: Vec<Limit>) -> Model {
    let mut model = absorber::model(tune);
    let of = model.tune.as_mut().unwrap();
    of.variables.extend(more);
    of.limits = limits;
    model
}

/// The lower and upper undamped natural frequency (Hz) of two masses: the closed form of their quadratic.
fn natural_frequencies(mass: f64, spring: f64, stiffness: f64) -> [f64; 2] {
    let half = 0.5 * ((stiffness + spring) / MASS + spring / mass);
    let root = (half * half - stiffness * spring / (MASS * mass)).sqrt();
    [half - root, half + root].map(|square| square.sqrt() / TAU)
}

fn all_hold(found: &Tuned) {
    for kept in &found.limits {
        assert!(kept.holds, "{kept:?}");
    }
}

/// Closed form: a heavier absorber is always better, so the mass is the largest allowed. Literature: the peak is then
/// Den Hartog's sqrt(1 + 2/mu) static deflections, which is off by 0.07 % at mu = 0.05 and by less below.
#[test]
fn as_much_mass_as_allowed_is_added() {
    let at_most = 0.03 * MASS;
    let mass = variable(&["subsystems.S1.mass"], 0.5, 8.0);
    let limit = Limit::AddedMass { at_most };
    let found = tuned(&limited(PEAK, vec![mass], vec![limit]), BUDGET);
    all_hold(&found);
    let off = found.limits[0].value / at_most - 1.0;
    assert!(off.abs() < 1e-6, "{off:e}");
    assert_eq!(found.limits[0].value, found.variables[2].after);
    let peak = found.after[0].figure * STIFFNESS;
    let literature = (1.0 + 2.0 / 0.03_f64).sqrt();
    assert!((peak / literature - 1.0).abs() < 1e-3, "{peak}");
}

/// Closed form: if Den Hartog's absorber has its upper mode in the band, the best allowed one has it at the band's end,
/// w: its springs are m w^2 (K - M w^2) / (K - M w^2 - m w^2).
#[test]
fn no_mode_is_in_the_band() {
    let free = tuned(&absorber::model(PEAK), BUDGET);
    let [lower, upper] = natural_frequencies(ABSORBER, 2.0 * free.variables[0].after, STIFFNESS);
    let (from, to) = (0.5 * (lower + upper), 1.02 * upper);
    let found = tuned(
        &limited(PEAK, Vec::new(), vec![Limit::NoMode { from, to }]),
        BUDGET,
    );
    all_hold(&found);
    let spring = 2.0 * found.variables[0].after;
    let square = (TAU * to).powi(2);
    let beam = STIFFNESS - MASS * square;
    let expected = ABSORBER * square * beam / (beam - ABSORBER * square);
    assert!(
        (spring / expected - 1.0).abs() < 1e-6,
        "{spring} {expected}"
    );
    let value = found.limits[0].value;
    assert!((value / to - 1.0).abs() < 1e-6, "{value}");
    assert!(found.after[0].figure > free.after[0].figure);
}

/// Closed form: above its resonance, softer springs K reduce the beam's motion; the static deflection is 1/K. It is
/// extrapolated from low frequencies to 1e-5.
#[test]
fn springs_are_as_soft_as_the_deflection_allows() {
    const AT_MOST: f64 = 1.25e-6;
    let mut model = limited(
        r#"objective = { minimise = "mean_square", response = "w", from = 40.0, to = 60.0 }"#,
        vec![variable(&SUPPORTS, 1e5, 2e6)],
        vec![Limit::StaticDeflection {
            response: "w".to_owned(),
            at_most: AT_MOST,
        }],
    );
    model.tune.as_mut().unwrap().variables.drain(..2);
    let found = tuned(&model, BUDGET);
    all_hold(&found);
    let deflection = 0.5 / found.variables[0].after;
    assert!((deflection / AT_MOST - 1.0).abs() < 1e-5, "{deflection:e}");
    let value = found.limits[0].value;
    assert!((value / AT_MOST - 1.0).abs() < 1e-6, "{value:e}");
}

/// Expected: the best absorber without stops moves farther, so at the best one within them the limit is active. However stiff its
/// damper is, it moves by 2.1e-5 m, where the beam with the absorber locked to it is at resonance.
#[test]
fn an_absorber_stays_within_its_stops() {
    let stopped = |at_most: f64| {
        let limit = Limit::Peak {
            response: "stroke".to_owned(),
            at_most,
        };
        let mut model = limited(PEAK, Vec::new(), vec![limit]);
        let stroke = Response {
            name: "stroke".to_owned(),
            quantity: Quantity::Spring(
                model.subsystems[0].name.clone(),
                SpringName::YLeft,
                SpringMeasure::Stretch,
            ),
            ..model.responses[0].clone()
        };
        model.responses.push(stroke);
        tuned(&model, BUDGET)
    };
    let free = stopped(1.0);
    let at_most = 0.98 * free.limits[0].value;
    let found = stopped(at_most);
    all_hold(&found);
    let value = found.limits[0].value;
    assert!(
        (value / at_most - 1.0).abs() < 1e-6,
        "{value:e} {at_most:e}"
    );
    assert!(found.after[0].figure > free.after[0].figure);
}

/// Closed form: above its resonance the beam moves the less the softer its springs and the heavier its absorber are, and
/// the band without a mode keeps the absorber's at one of its ends from where it would do best. With all three at their bounds the springs
/// of the absorber follow, and the damping alone is left: the best of a scan.
#[test]
fn all_limits_hold_at_once() {
    let at_most = 0.04 * MASS;
    let deflection = 1.1e-6;
    let (from, to) = (45.0, 62.0);
    let objective =
        r#"objective = { minimise = "mean_square", response = "w", from = 40.0, to = 60.0 }"#;
    let model = limited(
        objective,
        vec![
            variable(&["subsystems.S1.mass"], 0.5, 8.0),
            variable(&SUPPORTS, 1e5, 2e6),
        ],
        vec![
            Limit::AddedMass { at_most },
            Limit::NoMode { from, to },
            Limit::StaticDeflection {
                response: "w".to_owned(),
                at_most: deflection,
            },
        ],
    );
    let found = tuned(&model, BUDGET);
    all_hold(&found);
    let [spring, damping, mass, support] = [0, 1, 2, 3].map(|index| found.variables[index].after);
    assert!((mass / at_most - 1.0).abs() < 1e-6, "{mass}");
    let at_rest = 0.5 / support;
    assert!((at_rest / deflection - 1.0).abs() < 1e-5, "{at_rest:e}");
    let [_, upper] = natural_frequencies(mass, 2.0 * spring, 2.0 * support);
    // The mean has a minimum on either side of the band, and the search may find either.
    let is_at = |end: f64| (upper / end - 1.0).abs() < 1e-6;
    assert!(is_at(from) || is_at(to), "{upper}");
    let mean = |damping| {
        mean_square([40.0, 60.0], |frequency| {
            receptance_on(2.0 * support, frequency, mass, [spring, damping])
        })
    };
    let scan = (-20..=20).map(|index| mean(damping * 1.05_f64.powi(index)));
    let least = scan.fold(f64::INFINITY, f64::min);
    let figure = found.after[0].figure;
    assert!(figure < least * (1.0 + 1e-6), "{figure:e} {least:e}");
}

/// A slender column with a force in the middle in both planes, its first mode at 10 Hz without an axial force: above it,
/// the motion is the less the lower the mode is, up to 40 Hz, where the third one of the plane is still far.
fn column() -> Model {
    let mut model = absorber::model(
        r#"objective = { minimise = "mean_square", response = "w", from = 20.0, to = 40.0 }"#,
    );
    model.subsystems.clear();
    (model.supports.left, model.supports.right) = (Support::PINNED, Support::PINNED);
    let mut force = model.forces[0].clone();
    force.target = Target::Beam(Place::Position(0.5), BeamMotion::V);
    model.forces.push(force);
    let mut response = model.responses[0].clone();
    "v".clone_into(&mut response.name);
    response.quantity = Quantity::Motion(
        Target::Beam(Place::Position(0.5), BeamMotion::V),
        Measure::Displacement,
    );
    model.responses.push(response);
    let objectives = &mut model.tune.as_mut().unwrap().objectives;
    let mut along_z = objectives[0].clone();
    along_z.response = Some("v".to_owned());
    objectives.push(along_z);
    let beam = &mut model.beam;
    let mass = beam.material.density * beam.section.area;
    let second = mass * (TAU * 10.0).powi(2) / PI.powi(4) / beam.material.young_modulus;
    (beam.section.second_moment_y, beam.section.second_moment_z) = (second, second);
    model
}

fn euler_load(model: &Model, second: f64) -> f64 {
    PI * PI * model.beam.material.young_modulus * second / model.beam.length.powi(2)
}

/// Closed form: compression lowers the first mode, as far as Euler's load over the factor.
#[test]
fn a_column_is_pressed_as_far_from_buckling_as_it_must_stay() {
    const AT_LEAST: f64 = 1.6;
    let mut model = column();
    let euler = euler_load(&model, model.beam.section.second_moment_y);
    model.beam.axial_force = 0.2 * euler;
    let tune = model.tune.as_mut().unwrap();
    tune.variables = vec![variable(&["beam.axial_force"], -0.9 * euler, 0.5 * euler)];
    let free = tuned(&model, BUDGET).variables[0].after;
    assert!(free < -0.8 * euler, "{free} {euler}");
    let tune = model.tune.as_mut().unwrap();
    tune.limits = vec![Limit::Buckling { at_least: AT_LEAST }];
    let found = tuned(&model, BUDGET);
    all_hold(&found);
    let force = found.variables[0].after;
    assert!((-force * AT_LEAST / euler - 1.0).abs() < 1e-6, "{force}");
    let factor = found.limits[0].value;
    assert!((factor / AT_LEAST - 1.0).abs() < 1e-6, "{factor}");
}

/// Closed form: both planes of a column are as soft as its compression allows, so that it buckles in both at once.
#[test]
fn both_planes_of_a_column_stop_at_the_same_load() {
    const AT_LEAST: f64 = 1.6;
    let mut model = column();
    let second = model.beam.section.second_moment_y;
    let compression = 0.3 * euler_load(&model, second);
    model.beam.axial_force = -compression;
    let moment = |key: &str| {
        variable(
            &[&format!("beam.section.{key}")],
            0.4 * second,
            3.0 * second,
        )
    };
    let tune = model.tune.as_mut().unwrap();
    tune.variables = vec![moment("second_moment_y"), moment("second_moment_z")];
    tune.limits = vec![Limit::Buckling { at_least: AT_LEAST }];
    let found = tuned(&model, BUDGET);
    all_hold(&found);
    for moved in &found.variables {
        let factor = euler_load(&model, moved.after) / compression;
        assert!((factor / AT_LEAST - 1.0).abs() < 1e-6, "{moved:?} {factor}");
    }
}

/// Expected: nothing presses a beam in tension, so its factor is infinite.
#[test]
fn a_beam_in_tension_keeps_any_factor() {
    let mut model = column();
    model.beam.axial_force = 1e3;
    let tune = model.tune.as_mut().unwrap();
    tune.variables = vec![variable(&["beam.material.density"], 7000.0, 8000.0)];
    tune.limits = vec![Limit::Buckling { at_least: 1e6 }];
    let found = tuned(&model, BUDGET);
    all_hold(&found);
    assert_eq!(found.limits[0].value, f64::INFINITY);
}

/// Expected: by its wave numbers the beam has more modes than are listed up to there.
#[test]
fn a_band_with_too_many_modes_is_no_limit() {
    let limit = Limit::NoMode {
        from: 1.0,
        to: 1e12,
    };
    let model = limited(PEAK, Vec::new(), vec![limit]);
    let faults = Problem::new(&checked(&model), Path::new(".")).unwrap_err();
    assert_eq!(faults[0].path, "tune.limits.1");
    assert!(faults[0].message.contains("10000"), "{}", faults[0].message);
}

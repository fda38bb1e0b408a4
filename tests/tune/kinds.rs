//! Each kind of objective on the beam with an absorber, which has the closed form of two masses.

use crate::checked::checked;
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use beamtune::model::{Combine, Model, edit};
use beamtune::solve::band::{Level, levels};
use beamtune::solve::modes::modes;
use beamtune::solve::sweep;
use beamtune::tune::{Options, Problem, Tuned, run};

use crate::absorber::{self, ABSORBER, MASS, STIFFNESS, mean_square, natural, receptance, tuned};

const BUDGET: Option<usize> = Some(400);

/// Sets the stiffness or damping of both springs of the absorber.
fn set(model: &mut Model, end: &str, value: f64) {
    for side in ["y_left", "y_right"] {
        let path = format!("subsystems.S1.{side}.{end}");
        edit::set_unchecked(model, &path, edit::Value::Number(value)).unwrap();
    }
}

/// Stiffness and damping of one spring of the tuned absorber.
fn values(found: &Tuned) -> [f64; 2] {
    [found.variables[0].after, found.variables[1].after]
}

/// The level of the response, by the quadrature of `solve::band`.
fn level(model: &Model, band: [f64; 2]) -> Level {
    let never = AtomicBool::new(false);
    let modes = modes(&checked(model), band[1], &never).unwrap();
    levels(&checked(model), &modes, band, &never).unwrap()[0]
}

/// The largest closed-form receptance in a band, at 2,000 places, m/N.
fn peak([from, to]: [f64; 2], values: [f64; 2]) -> f64 {
    let place = |index: i32| from + (to - from) * f64::from(index) / 2000.0;
    let all = (0..=2000).map(|index| receptance(place(index), ABSORBER, values));
    all.fold(0.0, f64::max)
}

/// The bounds of both variables.
const WHOLE: [[f64; 2]; 2] = [[1e3, 1e6], [0.1, 1e4]];

/// Bounds about Den Hartog's absorber.
const NEAR: [[f64; 2]; 2] = [[1e4, 3e4], [20.0, 200.0]];

/// The minimum of a figure over a logarithmic grid of 60 stiffnesses and 60 dampings between bounds.
fn least([stiffness, damping]: [[f64; 2]; 2], figure: impl Fn([f64; 2]) -> f64) -> f64 {
    let place = |index: i32, [from, to]: [f64; 2]| from * (to / from).powf(f64::from(index) / 59.0);
    let all = (0..3600).map(|index| [place(index / 60, stiffness), place(index % 60, damping)]);
    all.map(figure).fold(f64::INFINITY, f64::min)
}

/// Closed form: the beam is at rest where the undamped absorber alone resonates, 2 k = m (2 pi f)^2.
#[test]
fn an_anti_resonance_comes_to_where_it_is_wanted() {
    const AT: f64 = 15.0;
    let mut model = absorber::model(
        r#"objective = { place = "anti_resonance", response = "w", at = 15.0, from = 5.0, to = 60.0 }"#,
    );
    model.tune.as_mut().unwrap().variables.truncate(1);
    set(&mut model, "damping", 0.0);
    let found = tuned(&model, BUDGET);
    let expected = 0.5 * ABSORBER * (TAU * AT).powi(2);
    let off = found.variables[0].after / expected - 1.0;
    assert!(off.abs() < 1e-6, "{off:e}");
    assert!((found.after[0].places[0] - AT).abs() < 1e-6);
    // Closed form: without tuning it is at sqrt(2 k / m) / 2 pi.
    let start = (2.0 * 2e4 / ABSORBER).sqrt() / TAU;
    let before = found.before[0].figure;
    assert!((before - (start - AT)).abs() < 1e-6, "{before}");
    let still = sweep(&found.model, &[AT], &AtomicBool::new(false)).unwrap();
    let size = still.columns[0].values[0].norm() * STIFFNESS;
    assert!(size < 1e-6, "{size:e}");
}

/// Independent: the widest run below the level of the closed form on a grid of 2,000 places.
fn widest_left([from, to]: [f64; 2], below: f64, values: [f64; 2]) -> f64 {
    let step = (to - from) / 2000.0;
    let (mut run, mut widest) = (0.0, 0.0_f64);
    for index in 0..2000 {
        let middle = from + step * (f64::from(index) + 0.5);
        let is_below = receptance(middle, ABSORBER, values) < below;
        run = if is_below { run + step } else { 0.0 };
        widest = widest.max(run);
    }
    to - from - widest
}

/// Expected: never worse than the start, equal to a fine sweep of the closed form, and no worse than the best of a grid
/// over both variables.
#[test]
fn the_band_below_a_level_becomes_as_wide_as_it_can() {
    const BAND: [f64; 2] = [12.0, 30.0];
    const BELOW: f64 = 5e-6;
    let step = (BAND[1] - BAND[0]) / 2000.0;
    let model = absorber::model(
        r#"objective = { maximise = "width", response = "w", below = 5e-6, from = 12.0, to = 30.0 }"#,
    );
    let found = tuned(&model, BUDGET);
    let [before, after] = [&found.before[0], &found.after[0]].map(|one| one.figure);
    for (figure, values) in [(before, [2e4, 20.0]), (after, values(&found))] {
        let expected = widest_left(BAND, BELOW, values);
        assert!(
            (figure - expected).abs() < 2.0 * step,
            "{figure} {expected}"
        );
    }
    assert!(after < before, "{before} {after}");
    let best = least(WHOLE, |values| widest_left(BAND, BELOW, values));
    assert!(after < best + 2.0 * step, "{after} {best}");
    for place in &found.after[0].places {
        let size = receptance(*place, ABSORBER, values(&found));
        let is_edge = (size / BELOW - 1.0).abs() < 1e-6;
        assert!(is_edge || BAND.contains(place), "{place} {size}");
    }
}

/// Literature: for white noise the mean square is least at the tuning ratio sqrt(1 + mu/2) / (1 + mu) and the damping
/// ratio sqrt(mu (4 + 3 mu) / (8 (1 + mu) (2 + mu))) (Warburton, Earthquake Engineering and Structural Dynamics 1982, 10,
/// 381; exact for an undamped mass). Independent: its value by `solve::band::levels` and by Simpson's rule of the closed
/// form.
#[test]
fn the_mean_square_is_warburton_s() {
    const BAND: [f64; 2] = [0.1, 300.0];
    let mu = ABSORBER / MASS;
    let model = absorber::model(
        r#"objective = { minimise = "mean_square", response = "w", from = 0.1, to = 300.0 }"#,
    );
    let found = tuned(&model, BUDGET);
    let [stiffness, damping] = values(&found);
    let own = (2.0 * stiffness / ABSORBER).sqrt();
    let ratio = own / natural() / ((1.0 + 0.5 * mu).sqrt() / (1.0 + mu));
    let share = (mu * (4.0 + 3.0 * mu) / (8.0 * (1.0 + mu) * (2.0 + mu))).sqrt();
    let share = 2.0 * damping / (2.0 * ABSORBER * own) / share;
    assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
    assert!((share - 1.0).abs() < 1e-6, "{share}");
    let independent = level(&found.model, BAND).mean_square;
    let figure = found.after[0].figure;
    assert!((figure / independent - 1.0).abs() < 1e-7, "{figure:e}");
    let closed = mean_square(BAND, |frequency| {
        receptance(frequency, ABSORBER, [stiffness, damping])
    });
    assert!(
        (figure / closed - 1.0).abs() < 1e-7,
        "{figure:e} {closed:e}"
    );
    assert!(figure < found.before[0].figure);
    assert_eq!(found.after[0].unit, "m2");
}

/// Closed form: the rigid beam has one motion, so its energy is its mass times the mean square, and both are least at
/// the same absorber.
#[test]
fn the_energy_of_a_rigid_beam_is_its_mass_times_the_mean_square() {
    let energy = absorber::model(r#"objective = { minimise = "energy", from = 5.0, to = 60.0 }"#);
    let square = absorber::model(
        r#"objective = { minimise = "mean_square", response = "w", from = 5.0, to = 60.0 }"#,
    );
    let [energy, square] = [energy, square].map(|model| tuned(&model, Some(80)));
    let ratio = energy.after[0].figure / (MASS * square.after[0].figure);
    assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
    assert!(energy.after[0].figure < energy.before[0].figure);
    for (one, other) in values(&energy).into_iter().zip(values(&square)) {
        // A minimum is flat: 1e-8 of its height corresponds to 1e-4 of its position.
        assert!((one / other - 1.0).abs() < 1e-4, "{one} {other}");
    }
}

/// Two peaks with different weights as one objective, and the best combined figure that the search reported.
fn two_peaks(combine: Combine) -> (Tuned, f64) {
    let mut model = absorber::model(
        r#"
[[tune.objectives]]
minimise = "peak"
response = "w"
from = 5.0
to = 17.5
[[tune.objectives]]
minimise = "peak"
response = "w"
from = 17.5
to = 60.0
weight = 2.0
"#,
    );
    model.tune.as_mut().unwrap().combine = combine;
    let problem = Problem::new(&checked(&model), Path::new(".")).unwrap();
    let options = Options {
        seed: 1,
        budget: BUDGET,
    };
    let mut best = f64::NAN;
    let found = run(&problem, &options, &AtomicBool::new(false), &mut |status| {
        best = status.best;
    });
    (found.unwrap(), best)
}

/// Closed form: the weighted peaks of two masses in both bands, m/N.
fn weighted(values: [f64; 2]) -> [f64; 2] {
    [peak([5.0, 17.5], values), 2.0 * peak([17.5, 60.0], values)]
}

/// Expected: the sum of the weighted figures, no more than on a grid over both variables.
#[test]
fn several_objectives_are_summed_with_their_weights() {
    let (found, best) = two_peaks(Combine::Sum);
    let sum = found.after[0].figure + 2.0 * found.after[1].figure;
    assert!((best / sum - 1.0).abs() < 1e-9, "{best} {sum}");
    let closed: f64 = weighted(values(&found)).iter().sum();
    assert!((closed / sum - 1.0).abs() < 1e-4, "{closed} {sum}");
    let grid = least(NEAR, |values| weighted(values).iter().sum());
    assert!(sum < grid * (1.0 + 1e-4), "{sum} {grid}");
}

/// Expected: the larger of the weighted figures, no more than on a grid; both are equal, because each decreases only at
/// the other's cost.
#[test]
fn of_several_objectives_the_worst_counts() {
    let (found, best) = two_peaks(Combine::Worst);
    let both = [found.after[0].figure, 2.0 * found.after[1].figure];
    let worst = both[0].max(both[1]);
    assert!((best / worst - 1.0).abs() < 1e-9, "{best} {worst}");
    assert!((both[0] / both[1] - 1.0).abs() < 1e-5, "{both:?}");
    let closed = weighted(values(&found)).into_iter().fold(0.0, f64::max);
    assert!((closed / worst - 1.0).abs() < 1e-4, "{closed} {worst}");
    let grid = least(NEAR, |values| {
        weighted(values).into_iter().fold(0.0, f64::max)
    });
    assert!(worst < grid * (1.0 + 1e-4), "{worst} {grid}");
}

/// The peaks of a tuned model at the four corners of the tolerances (shares), by `solve::band::levels`.
fn corners(found: &Tuned, tolerances: [f64; 2]) -> f64 {
    let [stiffness, damping] = values(found);
    let mut worst = 0.0_f64;
    for [first, second] in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
        let mut model = found.model.clone().into_inner();
        set(
            &mut model,
            "stiffness",
            stiffness * (1.0 + first * tolerances[0]),
        );
        set(
            &mut model,
            "damping",
            damping * (1.0 + second * tolerances[1]),
        );
        worst = worst.max(level(&model, [5.0, 60.0]).maximum);
    }
    worst
}

/// Expected: over the same corners no worse than the optimum without tolerances; the worst case as computed by
/// `solve::band::levels` and by a grid of the closed form.
#[test]
fn with_tolerances_the_worst_case_is_least() {
    const TOLERANCES: [f64; 2] = [0.08, 0.3];
    let exact = absorber::model(
        r#"objective = { minimise = "peak", response = "w", from = 5.0, to = 60.0 }"#,
    );
    let mut loose = exact.clone();
    let variables = &mut loose.tune.as_mut().unwrap().variables;
    for (variable, tolerance) in variables.iter_mut().zip(TOLERANCES) {
        variable.tolerance = 100.0 * tolerance;
    }
    let [plain, robust] = [exact, loose].map(|model| tuned(&model, BUDGET));
    assert_eq!(plain.worst_case, None);
    let worst = robust.worst_case.unwrap();
    assert_eq!(worst.corners, 4);
    let [of_plain, of_robust] = [&plain, &robust].map(|found| corners(found, TOLERANCES));
    assert!(worst.after < 0.99 * of_plain, "{worst:?} {of_plain}");
    assert!(
        (worst.after / of_robust - 1.0).abs() < 1e-6,
        "{worst:?} {of_robust}"
    );
    assert!(worst.after <= worst.before);
    // The cost of the tolerances: the tuned model itself is worse than the optimum without them.
    assert!(robust.after[0].figure > plain.after[0].figure);
    let grid = least(NEAR, |[stiffness, damping]| {
        let corner = |first: f64, second: f64| {
            let values = [stiffness * (1.0 + first), damping * (1.0 + second)];
            peak([12.0, 24.0], values)
        };
        let [first, second] = TOLERANCES;
        let both = |first| corner(first, second).max(corner(first, -second));
        both(first).max(both(-first))
    });
    assert!(worst.after < grid * (1.0 + 1e-4), "{worst:?} {grid}");
}

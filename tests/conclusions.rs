//! The conclusions of Chen & Liu, Mathematics 2022, 10(16), 2849 as results of tuning: the direction of the best
//! parameter of each figure. The sentences are those of `tests/literature/chen_liu_2022.toml`; the paper gives no
//! numbers, so only directions are tested, within the range of each figure.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "common/checked.rs"]
mod checked;

use checked::checked;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use beamtune::model::{self, Aim, Combine, Hold, Model, Objective, Tune, Variable, path};
use beamtune::presets;
use beamtune::tune::{Options, Place, Problem, Tuned, run};

/// Number of evaluations for one variable.
const BUDGET: usize = 80;

fn preset(name: &str) -> Model {
    model::read(presets::find(name).unwrap().text)
        .unwrap()
        .into_inner()
}

/// The result if one variable varies from `times[0]` to `times[1]` times its value in the preset.
fn best(
    model: &Model,
    paths: &[&str],
    times: [f64; 2],
    (aim, response): (Aim, &str),
    band: [f64; 2],
) -> Tuned {
    let base = path::numbers(model, paths[0]).unwrap()[0].1;
    let mut model = model.clone();
    model.tune = Some(Tune {
        variables: vec![Variable {
            paths: paths.iter().map(|path| (*path).into()).collect(),
            hold: Hold::Ratio,
            min: base * times[0],
            max: base * times[1],
            scale: None,
            tolerance: 0.0,
        }],
        objectives: vec![Objective {
            response: (aim != Aim::Energy).then(|| response.to_owned()),
            aim,
            from: band[0],
            to: band[1],
            weight: 1.0,
        }],
        combine: Combine::Sum,
        limits: Vec::new(),
    });
    assert_eq!(model::check(&model), []);
    let problem = Problem::new(&checked(&model), Path::new("")).unwrap();
    let options = Options {
        seed: 1,
        budget: Some(BUDGET),
    };
    run(&problem, &options, &AtomicBool::new(false), &mut |_| {}).unwrap()
}

/// The variable's best value over the preset's.
fn factor(tuned: &Tuned) -> f64 {
    tuned.variables[0].after / tuned.variables[0].before
}

const SPRINGS: [&str; 4] = ["y_left", "y_right", "z_left", "z_right"];

/// A field of all springs of all subsystems.
fn springs(field: &str) -> Vec<String> {
    SPRINGS
        .map(|spring| format!("subsystems.*.{spring}.{field}"))
        .to_vec()
}

fn borrowed(paths: &[String]) -> Vec<&str> {
    paths.iter().map(String::as_str).collect()
}

/// The variable's best value for an anti-resonance of the right end's twist, the lowest one: for a lower and for a
/// higher frequency.
fn placed(name: &str, paths: &[&str], at: [f64; 2], band: [f64; 2]) -> [f64; 2] {
    let model = preset(name);
    at.map(|at| {
        let tuned = best(
            &model,
            paths,
            [0.5, 4.0],
            (Aim::AntiResonance { at }, "right psi"),
            band,
        );
        assert!(tuned.after[0].figure < 1e-3 * at, "{at}: {:?}", tuned.after);
        factor(&tuned)
    })
}

/// "The location of the anti-resonance bands moves to a higher frequency area with the increase of ks."
#[test]
fn fig08_a_higher_anti_resonance_wants_stiffer_springs() {
    let [lower, higher] = placed(
        "fig08",
        &borrowed(&springs("stiffness")),
        [11.0, 14.0],
        [9.0, 18.0],
    );
    assert!(higher > 1.1 * lower, "{lower} {higher}");
}

/// "cs can significantly decrease the peak values of FR."
#[test]
fn fig09_the_lowest_peak_wants_the_highest_damping() {
    let aim = (Aim::Peak, "right w");
    let tuned = best(
        &preset("fig09"),
        &borrowed(&springs("damping")),
        [0.5, 4.0],
        aim,
        [15.0, 250.0],
    );
    assert_eq!(tuned.variables[0].place, Place::AtMax);
    assert!(tuned.after[0].figure < 0.5 * tuned.before[0].figure);
}

/// "A higher m corresponds to a decrease in the frequency of the potential well in the psi direction."
#[test]
fn fig10_a_lower_anti_resonance_wants_a_larger_mass() {
    let [lower, higher] = placed("fig10", &["subsystems.*.mass"], [11.9, 12.2], [11.0, 13.0]);
    assert!(lower > 1.1 * higher, "{lower} {higher}");
}

/// "A higher J corresponds to a decrease in the frequency of the anti-resonance band in all three directions."
#[test]
fn fig11_a_lower_anti_resonance_wants_a_larger_inertia() {
    let [lower, higher] = placed(
        "fig11",
        &["subsystems.*.inertia"],
        [11.0, 12.5],
        [9.0, 18.0],
    );
    assert!(lower > 1.1 * higher, "{lower} {higher}");
}

/// "The high frequency magnitude of EV increases with the increase in ks."
#[test]
fn fig13_the_least_energy_at_high_frequencies_wants_the_softest_mounts() {
    let tuned = best(
        &preset("fig13"),
        &borrowed(&springs("stiffness")),
        [0.01, 10.0],
        (Aim::Energy, ""),
        [200.0, 400.0],
    );
    assert!(factor(&tuned) < 0.02, "{}", factor(&tuned));
}

/// "A suitable larger cs is helpful to suppress the resonance peaks, while the excessive damping will deteriorate the
/// isolation performance": the best value is above the paper's, and below the largest.
#[test]
fn fig14_the_best_damping_of_the_mounts_is_larger_but_not_the_largest() {
    let aim = (Aim::Peak, "E_V");
    let tuned = best(
        &preset("fig14"),
        &borrowed(&springs("damping")),
        [0.1, 1e5],
        aim,
        [30.0, 400.0],
    );
    assert_eq!(tuned.variables[0].place, Place::Inside);
    assert!((10.0..1e4).contains(&factor(&tuned)), "{}", factor(&tuned));
}

/// "The resonance peak values of EV decrease along with the increase of d", the distance from the middle.
#[test]
fn fig15_the_lowest_peak_wants_the_machine_off_the_middle() {
    let aim = (Aim::Peak, "E_V");
    // From the middle, 1.6 m, to 0.9 m away from it.
    let tuned = best(
        &preset("fig15"),
        &["subsystems.M.position"],
        [1.0, 2.5 / 1.6],
        aim,
        [1.0, 400.0],
    );
    assert!(factor(&tuned) > 2.2 / 1.6, "{}", factor(&tuned));
    assert!(tuned.after[0].figure < tuned.before[0].figure);
}

/// "The excessive stiffness will decrease the mode damping coefficient, resulting in a dramatic increase of the magnitude
/// of the resonance peak."
#[test]
fn fig16_the_lowest_peak_wants_softer_supports() {
    let aim = (Aim::Peak, "E_V");
    let paths = [
        "supports.*.w.stiffness",
        "supports.*.v.stiffness",
        "supports.*.psi.stiffness",
    ];
    let tuned = best(&preset("fig16"), &paths, [0.01, 10.0], aim, [1.0, 400.0]);
    assert!(factor(&tuned) < 0.1, "{}", factor(&tuned));
}

/// "The EV curves for a higher C have a smaller peak value."
#[test]
fn fig17_the_lowest_peak_wants_more_damping_at_the_ends() {
    let aim = (Aim::Peak, "E_V");
    let paths = [
        "supports.*.w.damping",
        "supports.*.v.damping",
        "supports.*.psi.damping",
    ];
    let tuned = best(&preset("fig17"), &paths, [0.1, 100.0], aim, [1.0, 400.0]);
    assert!(factor(&tuned) > 10.0, "{}", factor(&tuned));
}

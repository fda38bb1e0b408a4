//! Model updating: the parameters of a perturbed model are identified from its noisy response.

use crate::checked::checked;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use beamtune::model::{
    self, Aim, Combine, Compare, Fault, Hold, Model, Objective, Tune, Variable, edit, path,
};
use beamtune::presets;
use beamtune::solve::sweep;
use beamtune::tune::{Options, Problem, Tuned, run};
use fastrand::Rng;

const PATHS: [&str; 3] = [
    "beam.material.young_modulus",
    "subsystems.Damper.y_left.stiffness",
    "subsystems.Damper.mass",
];
/// The changes of the perturbed model.
const FACTORS: [f64; 3] = [1.03, 0.9, 1.08];
const BAND: [f64; 2] = [10.0, 80.0];

fn cantilever() -> Model {
    model::read(presets::find("cantilever").unwrap().text)
        .unwrap()
        .into_inner()
}

fn values(model: &Model) -> [f64; 3] {
    PATHS.map(|path| path::number(model, path).unwrap())
}

/// The response of the perturbed model with normal noise in its real and imaginary part: relative to each value, or, as
/// in a comparison of complex values, relative to their root mean square.
fn measure(folder: &Path, share: f64, compare: Compare, seed: u64) {
    let mut model = cantilever();
    for (path, factor) in PATHS.into_iter().zip(FACTORS) {
        let value = path::number(&model, path).unwrap() * factor;
        edit::set_unchecked(&mut model, path, edit::Value::Number(value)).unwrap();
    }
    let frequencies: Vec<f64> = (0..141).map(|i| BAND[0] + 0.5 * f64::from(i)).collect();
    let frf = sweep(&checked(&model), &frequencies, &AtomicBool::new(false)).unwrap();
    let mut random = Rng::with_seed(seed);
    // The sum of twelve uniform numbers minus six is approximately normal.
    let mut normal = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
    let mut text = "frequency_hz,tip w.re,tip w.im\n".to_owned();
    let values = &frf.columns[0].values;
    let mean = values
        .iter()
        .map(num_complex::Complex::norm_sqr)
        .sum::<f64>()
        / values.len() as f64;
    for (frequency, value) in frequencies.iter().zip(values) {
        let size = match compare {
            Compare::LogMagnitude => value.norm(),
            Compare::Complex => mean.sqrt(),
        };
        let noise = num_complex::Complex64::new(normal(), normal());
        let value = value + noise * share * size;
        let _ = writeln!(text, "{frequency},{:e},{:e}", value.re, value.im);
    }
    std::fs::write(folder.join("measured.csv"), text).unwrap();
}

fn updated(folder: &Path, compare: Compare) -> Tuned {
    updated_with(folder, compare, None)
}

/// The same with the meaning of the columns.
fn updated_with(folder: &Path, compare: Compare, columns: Option<&str>) -> Tuned {
    let mut model = cantilever();
    let variables = PATHS.into_iter().zip(values(&model));
    model.tune = Some(Tune {
        variables: variables
            .map(|(path, value)| Variable {
                paths: vec![path.into()],
                hold: Hold::Equal,
                min: 0.7 * value,
                max: 1.4 * value,
                scale: None,
                tolerance: 0.0,
            })
            .collect(),
        objectives: vec![Objective {
            response: Some("tip w".to_owned()),
            aim: Aim::Match {
                file: "measured.csv".to_owned(),
                curve: None,
                columns: columns.map(str::to_owned),
                compare,
            },
            from: BAND[0],
            to: BAND[1],
            weight: 1.0,
        }],
        combine: Combine::Sum,
        limits: Vec::new(),
    });
    let problem = Problem::new(&checked(&model), folder).unwrap();
    let options = Options {
        seed: 1,
        budget: Some(60),
    };
    run(&problem, &options, &AtomicBool::new(false), &mut |_| {}).unwrap()
}

/// Expected: the parameters of the measured model.
#[test]
fn without_noise_the_parameters_come_back() {
    let folder = tempfile::tempdir().unwrap();
    for compare in Compare::ALL {
        measure(folder.path(), 0.0, compare, 1);
        let tuned = updated(folder.path(), compare);
        for (found, factor) in tuned.variables.iter().zip(FACTORS) {
            let off = found.after / (factor * found.before) - 1.0;
            assert!(off.abs() < 1e-6, "{compare:?} {:?}: {off:e}", found.paths);
        }
    }
}

/// Expected: the same within three of their standard uncertainties. Over many seeds an error over its standard
/// uncertainty has a root mean square of 1; for 3 parameters and 10 seeds it is between 0.6 and 1.45 except in one of a
/// thousand cases (chi-square).
#[test]
fn with_noise_they_come_back_within_their_uncertainty() {
    let folder = tempfile::tempdir().unwrap();
    for compare in Compare::ALL {
        let mut squares = 0.0;
        for seed in 1..=10 {
            measure(folder.path(), 0.01, compare, seed);
            let tuned = updated(folder.path(), compare);
            for (found, factor) in tuned.variables.iter().zip(FACTORS) {
                let uncertainty = found.uncertainty.unwrap();
                let error = (found.after - factor * found.before) / uncertainty;
                assert!(
                    error.abs() < 3.0,
                    "{compare:?} {seed} {:?}: {error}",
                    found.paths
                );
                // 1 % of noise determines the parameters to about as much, or better.
                assert!(uncertainty < 0.02 * found.before);
                squares += error * error;
            }
        }
        let mean = (squares / 30.0).sqrt();
        assert!((0.6..1.45).contains(&mean), "{compare:?}: {mean}");
    }
}

/// Error cases of the folder in which the measured file is searched.
fn refused(folder: &Path, tune: Option<&Tune>) -> Vec<Fault> {
    let mut model = cantilever();
    model.tune = tune.cloned();
    Problem::new(&checked(&model), folder).unwrap_err()
}

/// Expected: the parameters of the measured model, from a table that needs an answer.
#[test]
fn an_answer_opens_a_table_that_does_not_say_what_it_is() {
    let folder = tempfile::tempdir().unwrap();
    measure(folder.path(), 0.0, Compare::Complex, 1);
    let file = folder.path().join("measured.csv");
    let text = std::fs::read_to_string(&file).unwrap();
    // A running number in front, kHz, and mm: the file states none of it.
    let rows = text.lines().skip(1).enumerate().map(|(index, row)| {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        format!(
            "{index} {} {:e} {:e}\n",
            cells[0] / 1e3,
            cells[1] * 1e3,
            cells[2] * 1e3
        )
    });
    std::fs::write(&file, rows.collect::<Vec<_>>().concat()).unwrap();
    let tune = updated_with(
        folder.path(),
        Compare::Complex,
        Some("khz 2; re 3; im 4; mm"),
    );
    for (found, factor) in tune.variables.iter().zip(FACTORS) {
        let off = found.after / (factor * found.before) - 1.0;
        assert!(off.abs() < 1e-6, "{:?}: {off:e}", found.paths);
    }
    let wrong = [
        (None, "It does not say"),
        (None, "hz 1; re 8; im 9"),
        (None, "0 | 0.01 | "),
        (Some("khz; re im; mm"), "as hz 1; re 2; im 3"),
        (Some("khz 2; re 3; im 5; mm"), "the table has 4 columns"),
        (Some("mhz; re im; m/N"), "hz, khz, rad/s or rpm"),
        (Some("khz 2; re 3; im 4; furlong"), "m/s2/N"),
    ];
    for (answer, part) in wrong {
        let mut asked = tune.model.tune.clone().unwrap();
        for objective in &mut asked.objectives {
            if let Aim::Match { columns, .. } = &mut objective.aim {
                *columns = answer.map(str::to_owned);
            }
        }
        let faults = refused(folder.path(), Some(&asked));
        assert!(faults[0].path.contains("measured.csv"), "{faults:?}");
        assert!(faults[0].message.contains(part), "{answer:?}: {faults:?}");
    }
    // A unit that is not stated is not assumed to be SI.
    std::fs::write(&file, "f [Hz],tip w re,tip w im\n20,1,2\n30,1,2\n").unwrap();
    let mut asked = tune.model.tune.clone().unwrap();
    if let Aim::Match { columns, .. } = &mut asked.objectives[0].aim {
        *columns = None;
    }
    let faults = refused(folder.path(), Some(&asked));
    assert!(
        faults[0].message.contains("what its values are"),
        "{faults:?}"
    );
}

/// Expected: one fault that names the file, and its curves if another one is requested.
#[test]
fn a_curve_that_cannot_be_read_is_named() {
    let folder = tempfile::tempdir().unwrap();
    measure(folder.path(), 0.0, Compare::Complex, 1);
    let mut tune = updated(folder.path(), Compare::Complex).model.tune.clone();
    let elsewhere = tempfile::tempdir().unwrap();
    let file = elsewhere.path().join("measured.csv");
    let contents = [
        None,
        Some(""),
        Some("no curve at all\n"),
        Some("frequency_hz,tip w.re,tip w.im\n10.0,1.0\n"),
        // Nothing in the band.
        Some("frequency_hz,tip w.re,tip w.im\n200.0,1.0,0.0\n201.0,1.0,0.0\n"),
    ];
    for text in contents {
        if let Some(text) = text {
            std::fs::write(&file, text).unwrap();
        }
        let faults = refused(elsewhere.path(), tune.as_ref());
        assert_eq!(faults.len(), 1, "{text:?}: {faults:?}");
        assert!(faults[0].path.contains("measured.csv"), "{faults:?}");
    }
    for objective in tune.iter_mut().flat_map(|tune| &mut tune.objectives) {
        if let Aim::Match { curve, .. } = &mut objective.aim {
            *curve = Some("root w".to_owned());
        }
    }
    let faults = refused(folder.path(), tune.as_ref());
    assert!(faults[0].path.contains("measured.csv"), "{faults:?}");
    assert!(faults[0].message.contains("tip w"), "{faults:?}");
}

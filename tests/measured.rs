//! Measured curves: tables and universal files as instruments and programs write them, and files with faults.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "common/checked.rs"]
mod checked;

use checked::checked;
use std::fmt::Write as _;
use std::path::Path;

use beamtune::measured::{
    self, Curve, Fault, Format, Hint, Layout, Question, Values, fit, inspect, read,
};
use beamtune::model::{Measure, Model};
use beamtune::unit::{Amount, Dimension, Kind, Load, Moves};
use num_complex::Complex64;

#[path = "measured/foreign.rs"]
mod foreign;
#[path = "measured/table.rs"]
mod table;
#[path = "measured/uff.rs"]
mod uff;
#[path = "measured/uff_of_others.rs"]
mod uff_of_others;

fn data(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/measured");
    measured::load(&folder.join(name)).unwrap()
}

fn hint(name: &str, layout: Option<&str>) -> Hint {
    Hint {
        name: name.to_owned(),
        layout: layout.map(|layout| Layout::parse(layout).unwrap()),
    }
}

fn curves(bytes: impl AsRef<[u8]>, layout: Option<&str>) -> Vec<Curve> {
    read(bytes.as_ref(), &hint("folder/run 7.csv", layout)).unwrap()
}

fn fault(bytes: impl AsRef<[u8]>) -> Fault {
    read(bytes.as_ref(), &hint("run 7.csv", None)).unwrap_err()
}

fn motion(moves: Moves, measure: Measure, per: Option<Load>) -> Kind {
    Kind::Amplitude(Dimension::of_motion(moves, measure, per))
}

#[track_caller]
fn near(found: Complex64, expected: Complex64, tolerance: f64) {
    let error = (found - expected).norm();
    assert!(error <= tolerance * expected.norm(), "{found} {expected}");
}

/// The program reads its own files, to the last bit.
#[test]
fn a_table_of_the_program_is_read_to_the_last_bit() {
    let mut model = beamtune::model::read(beamtune::presets::find("fig08").unwrap().text)
        .unwrap()
        .into_inner();
    model.sweep.points = 7;
    let frf = beamtune::solve::sweep(&checked(&model), &[1.0, 17.3, 80.0], &false.into()).unwrap();
    let mut text = "frequency_hz".to_owned();
    for column in &frf.columns {
        write!(text, ",{0}.re,{0}.im", column.name).unwrap();
    }
    for (index, frequency) in frf.frequencies.iter().enumerate() {
        write!(text, "\n{frequency:?}").unwrap();
        for column in &frf.columns {
            write!(
                text,
                ",{:?},{:?}",
                column.values[index].re, column.values[index].im
            )
            .unwrap();
        }
    }
    let found = curves(text, None);
    assert_eq!(found.len(), frf.columns.len());
    for (curve, column) in found.iter().zip(&frf.columns) {
        assert_eq!(curve.name, column.name);
        assert_eq!(curve.frequencies, frf.frequencies);
        assert_eq!(curve.values, column.values);
        assert!(curve.phase_known && curve.kind.is_none() && curve.notes.is_empty());
    }
}

/// Expected: golden with the unchanged model; 1 except for the noise with the model behind the example.
#[test]
fn the_example_is_read_and_compared_with_the_model() {
    let found = curves(data("example.csv"), None);
    let curve = &found[0];
    assert_eq!((found.len(), curve.name.as_str()), (1, "P1 w"));
    assert_eq!(
        curve.kind,
        Some(motion(Moves::Length, Measure::Displacement, None))
    );
    assert_eq!(curve.frequencies.len(), 799);
    // 0.025149 um at -1.66 degrees.
    near(
        curve.values[0],
        Complex64::from_polar(2.5149e-8, -1.66_f64.to_radians()),
        1e-12,
    );
    let preset = beamtune::presets::find("fig05a").unwrap();
    let mut model = beamtune::model::read(preset.text).unwrap().into_inner();
    let solved = |model: &Model| {
        beamtune::solve::sweep(&checked(model), &curve.frequencies, &false.into()).unwrap()
    };
    let frf = solved(&model);
    let whole = fit(curve, &frf.columns[0].values, None).unwrap();
    let low = fit(curve, &frf.columns[0].values, Some([1.0, 30.0])).unwrap();
    assert_eq!((whole.points, low.points), (799, 59));
    assert!(
        (whole.frac - 0.260).abs() < 5e-4 && (low.frac - 0.949).abs() < 5e-4,
        "{whole:?} {low:?}"
    );
    assert!(
        (low.mean_decibels - 0.056).abs() < 5e-4 && (low.rms_decibels - 1.011).abs() < 5e-4,
        "{low:?}"
    );
    // With the perturbation undone, only noise is left.
    model.beam.material.young_modulus *= 0.98;
    model.beam.material.loss_factor = 0.004;
    for subsystem in &mut model.subsystems {
        subsystem.mass *= 1.02;
        subsystem.y_left.stiffness *= 1.02;
        subsystem.y_right.stiffness *= 1.02;
    }
    let tuned = fit(curve, &solved(&model).columns[0].values, None).unwrap();
    assert!(
        tuned.frac > 0.999 && tuned.mean_decibels.abs() < 0.05,
        "{tuned:?}"
    );
}

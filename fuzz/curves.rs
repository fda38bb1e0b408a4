//! Properties of every file of measured curves. Shared by the fuzz targets and `tests/fuzz.rs`; a panic is a failure.

use std::fmt::Write as _;

use beamtune::measured::{Curve, Fault, Hint, Layout, Record, inspect, read, write_uff};
use beamtune::model::Measure;
use beamtune::unit::{Dimension, Kind, Load, Moves, ValueUnit};

/// Layouts as a user may give them; the first one is empty.
const LAYOUTS: [&str; 12] = [
    "",
    "hz; re im; m/N",
    "khz; mag deg; g/lbf",
    "rad/s; dB rad; kN/mm",
    "rpm; mag; mm/s",
    "hz; dB; kg m2",
    "hz; re im; ?",
    "hz; dB deg; 1e-6 rad/(N m)",
    "hz 1; re 2; im 3; m/N",
    "hz; re -im; m/N",
    "hz 2; re 3; im 3; ?",
    "khz 1; mag 3 2; -rad 2 4; mm/s",
];

/// Reading a file gives curves that survive writing and reading, or a fault with a location; returns whether it gave
/// curves.
pub fn file(bytes: &[u8], layout: usize, name: &str) -> bool {
    let hint = Hint {
        name: name.to_owned(),
        layout: Layout::parse(LAYOUTS[layout % LAYOUTS.len()]).ok(),
    };
    let seen = inspect(bytes, &hint);
    match read(bytes, &hint) {
        Ok(curves) => {
            let Ok(seen) = seen else {
                panic!("is read, but not looked at: {seen:?}");
            };
            assert!(
                !seen.missing.iter().any(|missing| missing.is_needed()),
                "{seen:?}"
            );
            let proposal = seen.proposal.to_string();
            assert_eq!(
                Layout::parse(&proposal).map(|layout| layout.to_string()),
                Ok(proposal)
            );
            accepted(&curves);
            true
        }
        Err(fault) => {
            has_a_place(&fault, bytes);
            false
        }
    }
}

/// A layout is one line that reads back, and its unit is that of its kind.
pub fn layout(text: &str) {
    if let Ok(layout) = Layout::parse(text) {
        assert_eq!(Layout::parse(&layout.to_string()), Ok(layout));
    }
    if let Ok(unit) = ValueUnit::parse(text) {
        let si = ValueUnit::parse(&unit.kind().unit());
        assert!(
            si.is_ok(),
            "{unit} is {:?}, whose unit is refused",
            unit.kind()
        );
    }
}

fn accepted(curves: &[Curve]) {
    assert!(!curves.is_empty(), "read, and nothing is there");
    for (index, curve) in curves.iter().enumerate() {
        let (frequencies, values) = (&curve.frequencies, &curve.values);
        assert!(!frequencies.is_empty() && frequencies.len() == values.len());
        assert!(frequencies[0] > 0.0 && frequencies.iter().all(|f| f.is_finite()));
        assert!(
            frequencies.windows(2).all(|pair| pair[0] < pair[1]),
            "not rising"
        );
        assert!(values.iter().all(|value| value.is_finite()));
        let magnitudes = values
            .iter()
            .all(|value| value.re >= 0.0 && value.im == 0.0);
        assert!(
            curve.phase_known || magnitudes,
            "no phase, and no magnitudes"
        );
        assert!(
            !curve.name.chars().any(char::is_control),
            "{:?} is no name",
            curve.name
        );
        let names = curves.iter().take(index).map(|other| &other.name);
        assert!(
            !names.into_iter().any(|name| *name == curve.name),
            "two are called {}",
            curve.name
        );
        as_a_table(curve);
    }
    as_universal_file(curves);
}

/// A table of the program reads back to the last bit.
fn as_a_table(curve: &Curve) {
    let mut text = "frequency_hz,H.re,H.im\n".to_owned();
    for (frequency, value) in curve.frequencies.iter().zip(&curve.values) {
        // A text can always be written to.
        let _ = writeln!(text, "{frequency:?},{:?},{:?}", value.re, value.im);
    }
    match read(text.as_bytes(), &Hint::default()) {
        Ok(found) => {
            assert_eq!(found.len(), 1);
            assert_eq!(found[0].frequencies, curve.frequencies);
            assert_eq!(found[0].values, curve.values);
        }
        Err(fault) => panic!("what was written is refused: {fault}\n{text}"),
    }
}

/// A universal file reads back to the digits of the format.
fn as_universal_file(curves: &[Curve]) {
    let unknown = Kind::Amplitude(Dimension::of_motion(
        Moves::Length,
        Measure::Displacement,
        Some(Load::Force),
    ));
    let records: Vec<Record> = curves
        .iter()
        .map(|curve| Record {
            name: &curve.name,
            title: "",
            // An energy has no phase.
            kind: curve
                .kind
                .filter(|kind| *kind != Kind::Energy || !curve.phase_known)
                .unwrap_or(unknown),
            response: None,
            reference: None,
            frequencies: &curve.frequencies,
            values: &curve.values,
        })
        .collect();
    let mut bytes = Vec::new();
    let Ok(written) = write_uff(&mut bytes, &records) else {
        panic!("memory cannot be written");
    };
    let found = match read(&bytes, &Hint::default()) {
        Ok(found) => found,
        Err(fault) => panic!(
            "what was written is refused: {fault}\n{}",
            String::from_utf8_lossy(&bytes)
        ),
    };
    assert_eq!(found.len(), curves.len());
    if written.frequency_error > 0.0 {
        return;
    }
    for (found, curve) in found.iter().zip(curves) {
        assert_eq!(found.frequencies.len(), curve.frequencies.len());
        for (found, value) in found.values.iter().zip(&curve.values) {
            let same = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-12 * b.abs();
            assert!(
                same(found.re, value.re) && same(found.im, value.im),
                "{found} {value}"
            );
        }
    }
}

fn has_a_place(fault: &Fault, bytes: &[u8]) {
    let is_line = !fault.message.is_empty() && !fault.message.chars().any(char::is_control);
    assert!(is_line, "says nothing: {fault:?}");
    let lines = bytes.split(|&byte| matches!(byte, b'\n' | b'\r')).count();
    let within = fault.line.is_some_and(|line| (1..=lines).contains(&line));
    assert!(
        within && fault.column.is_some_and(|column| column > 0),
        "outside of the file: {fault:?}"
    );
}

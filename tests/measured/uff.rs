//! Universal files.

use std::fmt::Write as _;

use beamtune::measured::{Node, Record, write_uff};

use super::*;

const UNEVEN: [f64; 7] = [1.0, 2.0, 5.0, 10.0, 20.25, 50.0, 100.0];

/// The contents of the files of `tests/data/measured`, m/N.
fn oscillator(f: f64) -> Complex64 {
    1e-3 / Complex64::new(100.0 - f * f, 0.1 * f)
}

fn even() -> Vec<f64> {
    (0..7).map(|index| 1.0 + 0.5 * f64::from(index)).collect()
}

fn ratio(of: Amount, per: Option<Amount>) -> Kind {
    Kind::Amplitude(Dimension { of, per })
}

fn receptance() -> Kind {
    motion(Moves::Length, Measure::Displacement, Some(Load::Force))
}

/// Expected: closed form, to the digits of the format (see the README next to the files).
#[test]
fn all_eight_data_forms_of_another_program_are_read() {
    for spacing in ["even", "uneven"] {
        for kind in [
            "real_single",
            "real_double",
            "complex_single",
            "complex_double",
        ] {
            for ending in [".uff", "_binary.uff", "_big_endian.uff"] {
                let stem = format!("{kind}_{spacing}");
                if ending == "_big_endian.uff" && stem != "complex_double_uneven" {
                    continue;
                }
                let found = curves(data(&format!("{stem}{ending}")), None);
                assert_eq!(found.len(), 1);
                let curve = &found[0];
                assert_eq!(
                    curve.name,
                    format!("SDOF {stem}{}", &ending[..ending.len() - 4])
                );
                let frequencies = if spacing == "even" {
                    even()
                } else {
                    UNEVEN.to_vec()
                };
                assert_eq!(curve.frequencies, frequencies);
                assert_eq!(curve.kind, Some(receptance()));
                assert_eq!(curve.phase_known, kind.starts_with("complex"));
                let digits = match (kind.ends_with("double"), ending) {
                    (_, "_binary.uff" | "_big_endian.uff") => 1e-14,
                    (true, _) => 5e-12,
                    (false, _) => 5e-6,
                };
                for (f, value) in frequencies.iter().zip(&curve.values) {
                    let expected = oscillator(*f);
                    let expected = if curve.phase_known {
                        expected
                    } else {
                        expected.norm().into()
                    };
                    assert!(
                        (value.re - expected.re).abs() <= digits * expected.re.abs(),
                        "{stem}{ending}"
                    );
                    assert!(
                        (value.im - expected.im).abs() <= digits * expected.im.abs(),
                        "{stem}{ending}"
                    );
                }
            }
        }
    }
}

/// Expected: the units of data set 164. Millimetres over millinewtons are SI; a moment in mN mm is 1e-6 N m.
#[test]
fn other_data_sets_are_passed_over_and_units_and_senses_turned() {
    let found = curves(data("several.uff"), None);
    let names: Vec<&str> = found.iter().map(|curve| curve.name.as_str()).collect();
    assert_eq!(
        names,
        ["run 1 3:+Z / 1:-Y", "run 1 3:-RX / 1:+RY", "run 1 3 / 1"]
    );
    let (force, moment) = (Some(Load::Force), Some(Load::Moment));
    assert_eq!(
        found[0].kind,
        Some(motion(Moves::Length, Measure::Acceleration, force))
    );
    assert_eq!(
        found[1].kind,
        Some(motion(Moves::Angle, Measure::Velocity, moment))
    );
    assert_eq!(found[2].kind, None);
    for (index, f) in even().into_iter().enumerate() {
        near(found[0].values[index], -oscillator(f), 1e-11);
        near(found[1].values[index], -1e6 * oscillator(f), 1e-11);
        near(found[2].values[index], oscillator(f), 1e-11);
    }
    let inverted = "the sign is inverted: 3:+Z / 1:-Y is opposite to its axis";
    assert_eq!(
        found[0].notes,
        [inverted, "1 function of type 6 (coherence) skipped"]
    );
    // If the file does not state it, the program asks.
    let seen = inspect(&data("several.uff"), &hint("", None)).unwrap();
    assert_eq!(
        (seen.format, seen.missing),
        (Format::Uff, vec![Question::Unit])
    );
    let read_with_hint = read(&data("several.uff"), &hint("", Some("hz; re im; g/N"))).unwrap();
    assert_eq!(
        read_with_hint[2].kind,
        Some(motion(Moves::Length, Measure::Acceleration, force))
    );
    near(
        read_with_hint[2].values[0],
        9.80665 * oscillator(1.0),
        1e-11,
    );
}

/// A function of data set 58 as text: records 6 to 11 as given, and the data.
fn function(record_6: &str, record_7: &str, axes: [&str; 3], data: &str) -> String {
    let mut text = format!("    -1\n    58\nname\n{}", "NONE\n".repeat(4));
    for line in [record_6, record_7, axes[0], axes[1], axes[2], "         0"] {
        text += line;
        text += "\n";
    }
    text + data + "    -1\n"
}

const FRF: &str =
    "    4         1    0         0       NONE         3   2       NONE         1   2";
const DISPLACEMENT: [&str; 3] = ["        18", "         8", "        13"];

/// Fields are adjacent without blanks, and exponents are Fortran's.
#[test]
fn fields_are_read_by_their_columns() {
    let data = "-1.25000E-101-2.50000E-100-1.00000D+00 1.00000+100\n";
    let form = "         5         2         1  1.00000D+01  5.00000D-01  0.00000D+00";
    let curve = &curves(function(FRF, form, DISPLACEMENT, data), None)[0];
    assert_eq!(curve.frequencies, [10.0, 10.5]);
    assert_eq!(
        curve.values,
        [
            Complex64::new(-1.25e-101, -2.5e-100),
            Complex64::new(-1.0, 1e100)
        ]
    );
    // Pairs of other widths: 13, 20, 13, 20 columns.
    let data = "  1.00000E+00-1.234567890123E-100  2.00000E+00-2.234567890123E-100\n  3.00000E+00  4.000000000000E+00\n";
    let form = "         4         3         0";
    let curve = &curves(function(FRF, form, DISPLACEMENT, data), None)[0];
    assert_eq!(curve.frequencies, [1.0, 2.0, 3.0]);
    assert_eq!(
        curve.values,
        [
            1.234_567_890_123e-100.into(),
            2.234_567_890_123e-100.into(),
            4.0.into()
        ]
    );
    // Windows line ends, and no end of the last data set.
    let text = function(FRF, form, DISPLACEMENT, data).replace('\n', "\r\n");
    assert_eq!(
        curves(text.trim_end().trim_end_matches("-1"), None)[0].frequencies,
        [1.0, 2.0, 3.0]
    );
}

#[test]
fn axes_say_what_the_values_are() {
    let form = "         5         1         1  1.00000E+01";
    let data = "  2.00000E+00  0.00000E+00\n";
    let of = |record_6: &str, axes: [&str; 3]| {
        curves(function(record_6, form, axes, data), None).remove(0)
    };
    let label =
        |kind: i32, unit: &str| format!("{kind:>10}    0    0    0 {:20} {unit:20}", "NONE");
    let moment = "    4         1    0         0       NONE         3  -5       NONE         1  -6";
    for (record_6, axes, kind, value) in [
        (
            FRF,
            ["        18", "        11", "        13"],
            Some(motion(Moves::Length, Measure::Velocity, Some(Load::Force))),
            2.0,
        ),
        (
            FRF,
            ["        18", "        12", "         9"],
            Some(motion(
                Moves::Length,
                Measure::Acceleration,
                Some(Load::Force),
            )),
            2.0,
        ),
        (
            FRF,
            ["        18", "        12", "         0"],
            Some(motion(Moves::Length, Measure::Acceleration, None)),
            2.0,
        ),
        (
            moment,
            DISPLACEMENT,
            Some(motion(
                Moves::Angle,
                Measure::Displacement,
                Some(Load::Moment),
            )),
            2.0,
        ),
        // A force over a motion is inverted.
        (
            FRF,
            ["        18", "        13", "        12"],
            Some(motion(
                Moves::Length,
                Measure::Acceleration,
                Some(Load::Force),
            )),
            0.5,
        ),
        (FRF, ["        18", "         0", "         0"], None, 2.0),
        (
            FRF,
            ["        18", &label(12, "g"), "        13"],
            Some(motion(
                Moves::Length,
                Measure::Acceleration,
                Some(Load::Force),
            )),
            2.0 * 9.80665,
        ),
        (
            FRF,
            ["        18", &label(12, "(m/s^2)/N"), "        13"],
            Some(motion(
                Moves::Length,
                Measure::Acceleration,
                Some(Load::Force),
            )),
            2.0,
        ),
        (
            FRF,
            ["        18", &label(8, "mm"), &label(13, "kN")],
            Some(motion(
                Moves::Length,
                Measure::Displacement,
                Some(Load::Force),
            )),
            2e-6,
        ),
        (
            FRF,
            ["        18", &label(1, "kg m2"), "         0"],
            Some(Kind::Energy),
            2.0,
        ),
    ] {
        let curve = of(record_6, axes);
        assert_eq!(curve.kind, kind, "{axes:?}");
        near(curve.values[0], value.into(), 1e-15);
    }
    // Angular frequency by its label.
    let curve = of(FRF, [&label(18, "rad/s"), "         8", "        13"]);
    assert!((curve.frequencies[0] - 10.0 / std::f64::consts::TAU).abs() < 1e-15);
    assert_eq!(curve.notes, ["frequencies are in rad/s"]);
}

/// Binary data exactly as in the standard, and with a line end after them.
#[test]
fn binary_data_are_read_in_either_byte_order_and_precision() {
    for little in [true, false] {
        for (kind, complex, double) in [
            (2, false, false),
            (4, false, true),
            (5, true, false),
            (6, true, true),
        ] {
            for even_spacing in [true, false] {
                let mut bytes = Vec::new();
                let mut push = |number: f64, double: bool| match (double, little) {
                    (true, true) => bytes.extend(number.to_le_bytes()),
                    (true, false) => bytes.extend(number.to_be_bytes()),
                    (false, true) => bytes.extend((number as f32).to_le_bytes()),
                    (false, false) => bytes.extend((number as f32).to_be_bytes()),
                };
                let frequencies = if even_spacing {
                    even()
                } else {
                    UNEVEN.to_vec()
                };
                for &f in &frequencies {
                    if !even_spacing {
                        push(f, false);
                    }
                    push(oscillator(f).re, double);
                    if complex {
                        push(oscillator(f).im, double);
                    }
                }
                let order = if little { 1 } else { 2 };
                let spacing = i32::from(even_spacing);
                let form = format!("{kind:>10}{:>10}{spacing:>10}  1.00000E+00  5.00000E-01", 7);
                let text = function(FRF, &form, DISPLACEMENT, "");
                let first = format!("    58b{order:>6}{:>6}{:>12}{:>12}", 2, 11, bytes.len());
                let text = text.replacen("    58", &first, 1);
                let head = text.strip_suffix("    -1\n").unwrap().as_bytes();
                for end in [&b"    -1\n"[..], b"\n    -1\n", b"\r\n    -1\r\n", b""] {
                    let curve = &curves([head, &bytes, end].concat(), None)[0];
                    assert_eq!(curve.frequencies, frequencies);
                    for (f, value) in frequencies.iter().zip(&curve.values) {
                        let expected = oscillator(*f);
                        let expected = if complex {
                            expected
                        } else {
                            expected.re.abs().into()
                        };
                        near(*value, expected, if double { 1e-15 } else { 1e-7 });
                    }
                }
                let cut = [head, &bytes[..bytes.len() - 1], b"    -1\n"].concat();
                assert_eq!(fault(cut).path, "data set 1, record 12");
            }
        }
    }
}

/// A whole file of one function, and a row of its data.
fn whole() -> (String, &'static str) {
    let form = "         6         2         1  1.00000E+00  5.00000E-01";
    let row = "  1.000000000000E+00  1.000000000000E+00";
    (
        function(FRF, form, DISPLACEMENT, &format!("{row}{row}\n")),
        row,
    )
}

#[track_caller]
fn is_refused(text: &str, path: &str, message: &str) {
    let found = fault(text);
    assert_eq!(found.path, path, "{found}\n{text}");
    assert!(found.message.contains(message), "{found}\n{text}");
    assert!(found.line.is_some() && found.column.is_some());
}

#[test]
fn what_is_wrong_with_a_universal_file_has_its_record() {
    let (whole, row) = whole();
    assert_eq!(curves(&whole, None).len(), 1);
    let data = format!("{row}{row}\n");
    let short = format!("{row}\n");
    for (from, to, record, message) in [
        (
            data.as_str(),
            short.as_str(),
            12,
            "ends after 1 of 2 values",
        ),
        (
            row,
            "  1.000000000000E+00  what               ",
            12,
            "\"what\" is not a number",
        ),
        (
            "         6         2",
            "         3         2",
            7,
            "ordinate data type",
        ),
        (
            "         6         2",
            "         6        -2",
            7,
            "0 or more",
        ),
        (
            "         6         2",
            "         6         x",
            7,
            "columns 11 to 20",
        ),
        (
            "         6         2",
            "         6   9000000",
            7,
            "more than 5000000 values",
        ),
        ("5.00000E-01", "0.00000E+00", 7, "step of 0"),
        (
            "         1  1.00000E+00",
            "         7  1.00000E+00",
            7,
            "abscissa spacing",
        ),
        ("         3   2", "         3   9", 6, "-6 to 6"),
        (
            "    58\n",
            "    58b     3     2          11          32\n",
            12,
            "byte order",
        ),
        (
            "    58\n",
            "    58b     1     1          11          32\n",
            12,
            "IEEE 754",
        ),
        (
            "    -1",
            "    -1\n   164\nx\n 0.0\n    -1\n    -1",
            2,
            "factor",
        ),
    ] {
        let text = whole.replacen(from, to, 1);
        is_refused(&text, &format!("data set 1, record {record}"), message);
    }
    let cut = whole.lines().take(6).collect::<Vec<_>>().join("\n");
    is_refused(&cut, "data set 1, record 5", "ends before record 5");
}

#[test]
fn a_file_without_frequency_responses_says_what_it_has() {
    let (whole, row) = whole();
    let data = format!("{row}{row}");
    let nan = "                 NaN".repeat(4);
    for (from, to, message) in [
        ("    58\n", "    55\n", "1 data set of another kind"),
        (
            "        18",
            "        17",
            "over something other than frequency",
        ),
        ("    4   ", "    6   ", "of type 6 (coherence)"),
        ("         8", "        15", "of data type 15"),
        (data.as_str(), nan.as_str(), "without a finite value"),
    ] {
        is_refused(&whole.replacen(from, to, 1), "", message);
    }
}

fn node(direction: i8) -> Node {
    Node {
        name: "left".to_owned(),
        number: 3,
        direction,
    }
}

fn written(records: &[Record]) -> (String, measured::Written) {
    let mut bytes = Vec::new();
    let written = write_uff(&mut bytes, records).unwrap();
    (String::from_utf8(bytes).unwrap(), written)
}

/// Values come back to 13 digits, frequencies to the six of the format.
#[test]
fn what_is_written_is_read() {
    use Measure::{Acceleration, Displacement, Velocity};
    let kinds = [
        receptance(),
        motion(Moves::Angle, Velocity, Some(Load::Moment)),
        motion(Moves::Angle, Acceleration, Some(Load::Force)),
        motion(Moves::Length, Acceleration, Some(Load::Bimoment)),
        motion(Moves::TwistRate, Velocity, Some(Load::Force)),
        motion(Moves::TwistRate, Displacement, Some(Load::Bimoment)),
        motion(Moves::Length, Velocity, None),
        ratio(Amount::Load(Load::Force), None),
        ratio(Amount::Load(Load::Moment), Some(Amount::Load(Load::Force))),
        ratio(
            Amount::Motion(Moves::Length, Acceleration),
            Some(Amount::Motion(Moves::Length, Acceleration)),
        ),
        Kind::Energy,
    ];
    for frequencies in [even(), UNEVEN.to_vec()] {
        for kind in kinds {
            let mut values: Vec<Complex64> = frequencies.iter().map(|&f| oscillator(f)).collect();
            if kind == Kind::Energy {
                for value in &mut values {
                    *value = value.norm().into();
                }
            }
            let (response, reference) = match kind {
                Kind::Amplitude(dimension) => (
                    Some(node(match dimension.of {
                        Amount::Motion(Moves::Length, _) | Amount::Load(Load::Force) => 2,
                        Amount::Motion(Moves::Angle, _) | Amount::Load(Load::Moment) => 4,
                        Amount::Motion(Moves::TwistRate, _) | Amount::Load(Load::Bimoment) => 0,
                    })),
                    dimension.per.map(|amount| {
                        node(match amount {
                            Amount::Motion(Moves::Length, _) | Amount::Load(Load::Force) => 3,
                            Amount::Motion(Moves::Angle, _) | Amount::Load(Load::Moment) => 6,
                            Amount::Motion(Moves::TwistRate, _) | Amount::Load(Load::Bimoment) => 0,
                        })
                    }),
                ),
                Kind::Energy => (None, None),
            };
            let record = Record {
                name: "P1 w, 0.5",
                title: "",
                kind,
                response,
                reference,
                frequencies: &frequencies,
                values: &values,
            };
            let (text, written) = written(&[record.clone(), record]);
            assert_eq!(written, measured::Written::default());
            let found = curves(&text, None);
            assert_eq!(found.len(), 2, "{text}");
            assert_eq!(found[0].kind, Some(kind), "{text}");
            assert_eq!(found[0].frequencies, frequencies);
            assert!(found[0].notes.is_empty(), "{:?}", found[0].notes);
            for (value, expected) in found[0].values.iter().zip(&values) {
                assert!((value.re - expected.re).abs() <= 1e-12 * expected.re.abs());
                assert!((value.im - expected.im).abs() <= 1e-12 * expected.im.abs());
            }
            assert!(text.lines().all(|line| line.len() <= 80), "{text}");
        }
    }
}

#[test]
fn losses_of_the_format_are_reported() {
    let frequencies = [1.234_567_89, 2.469_135_78, 3.5, 400.123_456];
    let values = [
        Complex64::ONE,
        Complex64::new(f64::NAN, 0.0),
        Complex64::I,
        Complex64::new(-1e-300, 1e300),
    ];
    let record = Record {
        name: "-1",
        title: "Größe\n    -1",
        kind: receptance(),
        response: None,
        reference: None,
        frequencies: &frequencies,
        values: &values,
    };
    let (text, written) = written(&[record]);
    // 400.123456 is 4.00123E+02, 0.000456 less.
    assert!(
        (written.frequency_error - 4.56e-4).abs() < 1e-9,
        "{written:?}"
    );
    assert_eq!((written.repeated, written.not_finite), (0, 1));
    assert!(!text.contains("NaN"), "{text}");
    let curve = &curves(&text, None)[0];
    assert_eq!(curve.frequencies, [1.23457, 3.5, 400.123]);
    assert_eq!(
        curve.values,
        [Complex64::ONE, Complex64::I, Complex64::new(-1e-300, 1e300)]
    );
    assert_eq!(curve.name, "\"-1\"");
    assert!(text.contains("Gr??e\\n    -1"), "{text}");
}

/// Expected: E13.5 rounds to six digits. 3.186087 to 3.186094 are all 3.18609, and 3.18609 itself is the nearest.
#[test]
fn what_is_one_frequency_in_six_digits_is_written_once() {
    let frequencies = [3.186_094, 3.186_087, 3.186_09, 5.0, 7.5, f64::INFINITY];
    let values: Vec<Complex64> = (0..6).map(|index| f64::from(index).into()).collect();
    let record = Record {
        name: "H",
        title: "",
        kind: receptance(),
        response: None,
        reference: None,
        frequencies: &frequencies,
        values: &values,
    };
    let nothing = Record {
        values: &[Complex64::new(f64::NAN, 1.0); 6],
        ..record.clone()
    };
    let (text, written) = written(&[record, nothing]);
    assert_eq!((written.repeated, written.not_finite), (2, 7));
    assert_eq!(written.frequency_error, 0.0);
    let found = curves(&text, None);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].frequencies, [3.186_09, 5.0, 7.5]);
    assert_eq!(found[0].values, [2.0.into(), 3.0.into(), 4.0.into()]);
    assert!(found[0].notes.is_empty(), "{:?}", found[0].notes);
}

/// Expected: 1999 steps of 399/1999 Hz = 0.19959980 Hz, which is 1.99600E-01 in the file, end at 400.0004 Hz.
#[test]
fn even_steps_lose_digits_too() {
    let frequencies: Vec<f64> = (0..2000)
        .map(|i| 1.0 + 399.0 / 1999.0 * f64::from(i))
        .collect();
    let record = Record {
        name: "H",
        title: "",
        kind: receptance(),
        response: None,
        reference: None,
        frequencies: &frequencies,
        values: &vec![Complex64::ONE; 2000],
    };
    let (text, written) = written(&[record]);
    assert!((written.frequency_error - 4e-4).abs() < 1e-9, "{written:?}");
    let found = &curves(&text, None)[0].frequencies;
    assert!((found[1999] - 400.0004).abs() < 1e-9 && found.len() == 2000);
}

/// Expected: golden, the layout of data set 58 (SDRC universal file format).
#[test]
fn the_layout_of_a_written_function_is_that_of_the_standard() {
    let record = Record {
        name: "P1 w",
        title: "a beam",
        kind: receptance(),
        response: Some(node(2)),
        reference: Some(node(-3)),
        frequencies: &[10.0, 10.5, 11.0],
        values: &[Complex64::new(1.0, -2.5e-7); 3],
    };
    let (text, _) = written(&[record]);
    let mut expected = String::new();
    for line in [
        "    -1",
        "    58                                                                          ",
        "P1 w                                                                            ",
        "a beam                                                                          ",
        "NONE                                                                            ",
        "NONE                                                                            ",
        "NONE                                                                            ",
        "    4         0    0         0 left               3   2 left               3  -3",
        "         6         3         1  1.00000E+01  5.00000E-01  0.00000E+00",
        "        18    0    0    0 Frequency            Hz                  ",
        "         8    0    0    0 Displacement         m                   ",
        "        13    0    0    0 Force                N                   ",
        "         0    0    0    0 NONE                 NONE                ",
        "  1.000000000000E+00 -2.500000000000E-07  1.000000000000E+00 -2.500000000000E-07",
        "  1.000000000000E+00 -2.500000000000E-07",
        "    -1",
    ] {
        writeln!(expected, "{line}").unwrap();
    }
    assert!(text.ends_with(&expected), "{text}");
    assert!(
        text.starts_with("    -1\n   164\n         1SI: metre, newton            2\n"),
        "{text}"
    );
}

//! Universal files as other programs write them: words for units, and deviations from the standard.

use std::fmt::Write as _;

use beamtune::unit::ValueUnit;

use super::*;

/// A file of `tests/data/measured/universal`.
fn file(name: &str) -> Vec<u8> {
    data(&format!("universal/{name}.uff"))
}

/// The receptance in the files, m/N, and -w^2 times it.
fn truth(frequency: f64, measure: Measure) -> Complex64 {
    let omega = std::f64::consts::TAU * frequency;
    let receptance = 1.0 / Complex64::new(160e3 - 4.0 * omega * omega, 40.0 * omega);
    match measure {
        Measure::Displacement => receptance,
        Measure::Velocity => receptance * Complex64::new(0.0, omega),
        Measure::Acceleration => receptance * -(omega * omega),
    }
}

/// Compares a curve of the files with the closed form, to the six digits of the files.
#[track_caller]
fn is_true(curve: &Curve, measure: Measure) {
    let per = Some(Load::Force);
    assert_eq!(curve.kind, Some(motion(Moves::Length, measure, per)));
    assert_eq!(curve.frequencies.len(), 39);
    assert!(curve.unknown.is_empty());
    for (index, (frequency, value)) in curve.frequencies.iter().zip(&curve.values).enumerate() {
        let exact = 10.0 + 5.0 * index as f64;
        assert!(
            (frequency / exact - 1.0).abs() < 2e-6,
            "{frequency} {exact}"
        );
        near(*value, truth(exact, measure), 1e-5);
    }
}

/// Expected: closed form; 1 g = 9.80665 m/s2, 1 lbf = 4.448222 N (NIST SP 811).
#[test]
fn words_for_units_are_known() {
    use Measure::{Acceleration, Displacement, Velocity};
    for (name, measure) in [
        ("capital_g", Acceleration),
        ("capital_lbf", Acceleration),
        ("mm_sec", Velocity),
        ("micron", Displacement),
        ("rad_sec", Acceleration),
        ("brackets_khz", Acceleration),
    ] {
        let found = curves(file(name), None);
        assert_eq!(found.len(), 1, "{name}");
        is_true(&found[0], measure);
    }
    let capital = curves(file("match_capital_g"), None);
    assert_eq!(capital, curves(file("match_g"), None));
}

/// A file as text with other words for a unit.
fn with_words(from: &str, to: &str) -> String {
    let text = String::from_utf8(file("capital_g")).unwrap();
    assert!(text.contains(from));
    text.replace(&format!("{from:<20}"), &format!("{to:<20}"))
}

/// Expected: closed form; the file's numbers are the accelerance in g/N, so in N/furlong they are those of the inverse.
#[test]
fn words_that_are_not_known_are_asked_for() {
    // Unknown, and known but not of an acceleration or a force.
    for (from, to) in [
        ("G ", "furlong/s2"),
        ("G ", "g rms"),
        ("G ", "mm/s"),
        ("G ", "V"),
        ("N ", "V"),
        ("N ", "mm"),
        ("N ", "mn"),
    ] {
        let text = with_words(from, to);
        let found = &curves(&text, None)[0];
        assert_eq!(found.kind, None, "{to}");
        assert_eq!(found.unknown, [(Question::Unit, to.to_owned())]);
        let note = format!("{to:?} is not a known unit");
        assert!(found.notes[0].contains(&note), "{:?}", found.notes);
        let seen = inspect(text.as_bytes(), &hint("", None)).unwrap();
        assert_eq!(seen.missing, [Question::Unit]);
        assert!(seen.recognised[0].contains(&note), "{:?}", seen.recognised);
        let answered = read(text.as_bytes(), &hint("", Some("hz; re im; g/N"))).unwrap();
        is_true(&answered[0], Measure::Acceleration);
        let seen = inspect(text.as_bytes(), &hint("", Some("hz; re im; g/N"))).unwrap();
        assert!(seen.missing.is_empty());
    }
    // A missing unit word, or an unknown one, means the unit of data set 164, or SI.
    for word in ["NONE", "", "-"] {
        let found = &curves(with_words("G ", word), None)[0];
        let unit = ValueUnit::parse("g/N").unwrap();
        let expected = truth(10.0, Measure::Acceleration) / unit.to_si(1.0.into());
        near(found.values[0], expected, 1e-5);
    }
}

#[test]
fn words_for_frequencies_that_are_not_known_are_asked_for() {
    let text = with_words("Hz ", "order");
    let refused = fault(&text);
    assert!(
        refused.message.contains("\"order\"") && refused.message.contains("rad/s"),
        "{refused}"
    );
    let seen = inspect(text.as_bytes(), &hint("", None)).unwrap();
    assert_eq!(
        (seen.missing, seen.curves.len()),
        (vec![Question::Frequency], 1)
    );
    let answered = read(text.as_bytes(), &hint("", Some("khz; re im; ?"))).unwrap();
    assert_eq!(answered[0].frequencies[0], 1e4);
    near(
        answered[0].values[0],
        truth(10.0, Measure::Acceleration),
        1e-5,
    );
    // A curve that is understood is read without the other one.
    let both = format!("{text}{}", with_words("G ", "gn"));
    let found = curves(both, None);
    assert_eq!(found.len(), 1);
    is_true(&found[0], Measure::Acceleration);
    assert!(
        found[0].notes[0].contains("\"order\" skipped"),
        "{:?}",
        found[0].notes
    );
}

/// Expected: closed form. The standard has E13.5,2E20.12; the file has three fields of 20 columns.
#[test]
fn fields_of_other_widths_are_read_where_blanks_part_them() {
    is_true(
        &curves(file("columns_of_20"), None)[0],
        Measure::Acceleration,
    );
    // Two values of 20 columns a line, where the standard has six of 13.
    let text = String::from_utf8(file("capital_g")).unwrap();
    let (head, numbers) = text.split_at(text.find(" -2.79072E-03").unwrap());
    let numbers: Vec<f64> = numbers
        .split_whitespace()
        .filter_map(|word| word.parse().ok())
        .collect();
    let mut wide = head.to_owned();
    for pair in numbers[..78].chunks(2) {
        writeln!(wide, "{:>20.12}{:>20.12}", pair[0], pair[1]).unwrap();
    }
    is_true(&curves(wide + "    -1\n", None)[0], Measure::Acceleration);
}

/// Expected: the nodes of the file; in the second name, which has 10 letters, they are in their columns.
#[test]
fn a_name_of_eleven_letters_moves_the_rest_of_its_record() {
    let text = String::from_utf8(file("name_of_11")).unwrap();
    is_true(&curves(&text, None)[0], Measure::Acceleration);
    let named = |name: &str| {
        let text = text.replace("PF-I-0301y+", name) + &text.replace("PF-I-0301y+", name);
        curves(text, None)[0].clone()
    };
    for name in [
        "PF-I-0301y+",
        "PF-I-03015",
        "PF-I-030155",
        "PF I 0301y+",
        "PF-I-0301",
    ] {
        let curve = named(name);
        assert_eq!(curve.name, "FRF at point 3 3:+Z / 1:+Z", "{name}");
    }
    // Two readings are possible: the program does not choose.
    let curve = named("PF-I-0301 3 3");
    assert_eq!(curve.name, "FRF at point 3");
    assert!(
        curve.notes[0].contains("not in their columns"),
        "{:?}",
        curve.notes
    );
}

/// Wherever a file is cut off, the complete curves are read, to the last bit, and the next one is reported.
#[test]
fn a_curve_that_is_cut_off_does_not_take_the_others_with_it() {
    let bytes = file("cut_off");
    let found = curves(&bytes, None);
    assert_eq!(found.len(), 2);
    is_true(&found[0], Measure::Acceleration);
    // The second one is twice the first.
    for (first, second) in found[0].values.iter().zip(&found[1].values) {
        near(*second, 2.0 * first, 1e-5);
    }
    assert_eq!(
        found[0].notes,
        ["data set 3 skipped: ends after 24 of 39 values"]
    );
    let sets: Vec<usize> = (0..bytes.len())
        .filter(|at| bytes[*at..].starts_with(b"    -1\n    58"))
        .collect();
    for cut in 10..bytes.len() {
        let whole = sets[1..].iter().filter(|start| cut + 8 > **start).count();
        match read(&bytes[..cut], &hint("", None)) {
            Ok(read) => {
                assert!(read.len() >= whole.min(2), "{cut}");
                for (curve, whole) in read.iter().zip(&found) {
                    assert_eq!(
                        (&curve.name, &curve.values),
                        (&whole.name, &whole.values),
                        "{cut}"
                    );
                }
            }
            Err(fault) => assert!(whole == 0, "{cut}: {fault}"),
        }
    }
    // One in the middle that is too short: its number of values is wrong.
    let text = String::from_utf8(bytes).unwrap();
    let short = text.replacen("        39", "        40", 1);
    let found = curves(short, None);
    assert_eq!(found.len(), 1);
    assert!(found[0].notes[0].starts_with("data set 1 skipped: ends after 39 of 40"));
}

/// The text around the numbers does not matter. Expected: the original file, which is compared with the closed form
/// above.
#[test]
fn line_ends_blanks_tabs_and_exponents_of_other_programs_are_read() {
    let text = String::from_utf8(file("capital_g")).unwrap();
    let expected = curves(&text, None);
    is_true(&curves(file("cr"), None)[0], Measure::Acceleration);
    let lines = |lines: Vec<String>| lines.join("\n") + "\n";
    let padded = lines(text.lines().map(|line| format!("{line:<100}")).collect());
    let numbers = lines(text.lines().skip(13).map(str::to_owned).collect());
    let head = text.strip_suffix(numbers.as_str()).unwrap();
    let with_tabs: String = text
        .lines()
        .enumerate()
        .map(|(index, line)| match index {
            7.. => line.split_whitespace().collect::<Vec<_>>().join("\t") + "\n",
            _ => format!("{line}\n"),
        })
        .collect();
    for (what, other) in [
        ("carriage returns", text.replace('\n', "\r")),
        ("Windows", text.replace('\n', "\r\n")),
        ("twice Windows", text.replace('\n', "\r\r\n")),
        ("byte order mark", format!("\u{feff}{text}")),
        (
            "byte order mark and CR",
            format!("\u{feff}{}", text.replace('\n', "\r")),
        ),
        ("padded", padded),
        ("tabs", with_tabs),
        (
            "small exponents",
            format!("{head}{}", numbers.replace('E', "e")),
        ),
        (
            "D exponents",
            format!("{head}{}", numbers.replace('E', "D")),
        ),
        (
            "small d exponents",
            format!("{head}{}", numbers.replace('E', "d")),
        ),
        ("no end", text.strip_suffix("    -1\n").unwrap().to_owned()),
        (
            "no end of the last line",
            text.strip_suffix("\n    -1\n").unwrap().to_owned(),
        ),
        ("-1 on the left", text.replace("    -1\n", "-1\n")),
        (
            "-1 in ten columns",
            text.replace("    -1\n", "        -1\n"),
        ),
        (
            "blank lines around",
            format!("\n\n{}\n\n", text.replace("-1\n", "-1\n\n")),
        ),
        (
            "blank lines within",
            format!("{head}{}", numbers.replace('\n', "\n\n")),
        ),
        ("other sets around", {
            let other = "    -1\n   151\nheader\n        -1\n    58\n    -1\n";
            format!("{other}{text}    -1\n  9999\n\u{e9}\n    -1\n")
        }),
    ] {
        for name in ["x.uff", "x", "x.txt"] {
            assert_eq!(Format::of(other.as_bytes(), name), Format::Uff, "{what}");
            let found = read(other.as_bytes(), &hint(name, None));
            assert_eq!(found.as_ref(), Ok(&expected), "{what}");
        }
    }
    // Several sets with one line end and with blank lines between them.
    let two = text.clone() + "\n \n" + &text;
    assert_eq!(curves(two.replace('\n', "\r"), None).len(), 2);
}

/// A value that is not a number is ignored and reported; one in the header is refused.
#[test]
fn what_is_not_finite_is_left_out_or_refused() {
    let text = String::from_utf8(file("capital_g")).unwrap();
    for nan in ["NaN", "nan", "Inf", "-Infinity"] {
        let found = &curves(text.replace(" -7.27044E-03", &format!("{nan:>13}")), None)[0];
        assert_eq!((found.frequencies[1], found.frequencies.len()), (20.0, 38));
        assert_eq!(found.notes, ["1 point without a finite number skipped"]);
        for field in ["  1.00000E+01", "  5.00000E+00"] {
            let refused = fault(text.replace(field, &format!("{nan:>13}")));
            assert_eq!(refused.path, "data set 1, record 7", "{refused}");
        }
    }
}

//! The text of `beamtune validate`.

use std::fmt::Write;

use super::{Arguments, Findings, Witness, largest};
use crate::cli::padded;
use crate::escape::escape;
use crate::model::Checked;
use crate::solve::Frf;
use crate::solve::compare::Difference;

/// Below this relative difference, rounding errors disturb the order of convergence.
const ROUNDING: f64 = 1e-9;
/// The decimal digits of a double.
const MOST_DIGITS: f64 = 16.0;

/// All sections, in the order of the model's responses.
pub(super) fn text(model: &Checked, findings: &Findings, arguments: &Arguments) -> String {
    let mut out = String::new();
    let frequencies = &findings.exact.frequencies;
    if !model.title.is_empty() {
        let _ = writeln!(out, "{}", escape(&model.title));
    }
    let _ = writeln!(out, "{}", among(frequencies));
    singular(&mut out, &findings.exact);
    let (elements, first) = &findings.meshes[0];
    let _ = writeln!(
        out,
        "\nFinite elements compared with the exact solution, {elements} elements"
    );
    out += &table(&response_rows(&findings.exact, first));
    // The shear force is constant along an element.
    let order = if model.beam.theory.has_shear() { 2 } else { 4 };
    let _ = writeln!(
        out,
        "\nConvergence of the finite elements (order expected: {order})"
    );
    out += &table(&convergence_rows(findings));
    out += "\nTransfer matrices of Chen & Liu 2022 compared with the exact solution (for information only): correct digits\n";
    match &findings.chain {
        Ok(chain) => out += &table(&digit_rows(frequencies, chain, !arguments.at.is_empty())),
        Err(reason) => {
            let _ = writeln!(out, "does not apply: {reason}");
        }
    }
    out += "\nTime\n";
    out += &table(&time_rows(findings));
    verdict(&mut out, first, arguments.tolerance);
    out
}

fn among(frequencies: &[f64]) -> String {
    if let [only] = frequencies {
        return format!("1 frequency, {} Hz", short(*only));
    }
    let from = frequencies.iter().copied().fold(f64::INFINITY, f64::min);
    let to = frequencies.iter().copied().fold(0.0, f64::max);
    format!(
        "{} frequencies from {} to {} Hz",
        frequencies.len(),
        short(from),
        short(to)
    )
}

fn singular(out: &mut String, exact: &Frf) {
    let singular = exact.singular();
    if let Some(first) = singular.first() {
        let _ = writeln!(
            out,
            "the exact response is not finite at {} of them, first at {first:?} Hz; these are left out",
            singular.len()
        );
    }
}

fn response_rows(exact: &Frf, witness: &Witness) -> Vec<Vec<String>> {
    let header = [
        "response",
        "largest relative difference",
        "at Hz",
        "largest difference in dB",
        "at Hz",
        "largest difference / peak",
    ];
    let mut rows = vec![header.map(String::from).to_vec()];
    for (column, differences) in exact.columns.iter().zip(&witness.differences) {
        let of = |figure: fn(&Difference) -> f64| match largest([differences], figure) {
            Some((value, row)) => (value, short(exact.frequencies[row])),
            None => (f64::NAN, "-".into()),
        };
        let (relative, relative_at) = of(|d| d.relative);
        let (decibels, decibels_at) = of(|d| d.decibels);
        let peak = column.values.iter().filter(|v| v.is_finite());
        let peak = peak.map(|v| v.norm()).fold(0.0, f64::max);
        let share = of(|d| d.absolute).0;
        rows.push(vec![
            escape(&column.name).into_owned(),
            figure(relative),
            relative_at,
            figure(decibels),
            decibels_at,
            figure(if share == 0.0 { 0.0 } else { share / peak }),
        ]);
    }
    rows
}

fn convergence_rows(findings: &Findings) -> Vec<Vec<String>> {
    let header = ["elements", "largest relative difference", "order observed"];
    let mut rows = vec![header.map(String::from).to_vec()];
    let mut before: Option<f64> = None;
    for (elements, witness) in &findings.meshes {
        let worst = largest(&witness.differences, |d| d.relative).map_or(f64::NAN, |(d, _)| d);
        let order = match before {
            None => String::new(),
            Some(before) if worst > ROUNDING && before.is_finite() => {
                format!("{:.2}", (before / worst).log2())
            }
            Some(_) if worst <= ROUNDING => "rounding".into(),
            Some(_) => "-".into(),
        };
        rows.push(vec![elements.to_string(), figure(worst), order]);
        before = Some(worst);
    }
    rows
}

/// The least and the median number of right digits, of all responses, by bands of 1, 2, 5, 10, ... Hz or by frequency.
fn digit_rows(frequencies: &[f64], chain: &Witness, each: bool) -> Vec<Vec<String>> {
    let header = ["Hz", "least of all responses", "median"];
    let mut rows = vec![header.map(String::from).to_vec()];
    let mut groups: Vec<(String, Vec<f64>)> = Vec::new();
    for (row, &frequency) in frequencies.iter().enumerate() {
        let label = if each {
            short(frequency)
        } else {
            band(frequency)
        };
        let found = chain.differences.iter().filter_map(|column| column[row]);
        let digits = found.map(|difference| digits(difference.relative));
        match groups.last_mut() {
            Some(group) if group.0 == label => group.1.extend(digits),
            _ => groups.push((label, digits.collect())),
        }
    }
    for (label, mut digits) in groups {
        digits.sort_by(f64::total_cmp);
        let at = |index: usize| digits.get(index).map_or("-".into(), |d| format!("{d:.1}"));
        rows.push(vec![label, at(0), at(digits.len() / 2)]);
    }
    rows
}

/// The number of correct decimal digits, 0 to 16.
fn digits(relative: f64) -> f64 {
    (-relative.log10()).clamp(0.0, MOST_DIGITS)
}

/// The band of a frequency: 1 to 2, 2 to 5 or 5 to 10 times a power of ten.
fn band(frequency: f64) -> String {
    let power = 10f64.powf(frequency.log10().floor());
    let (from, to) = match frequency / power {
        share if share < 2.0 => (1.0, 2.0),
        share if share < 5.0 => (2.0, 5.0),
        _ => (5.0, 10.0),
    };
    format!("{} to {}", short(from * power), short(to * power))
}

fn time_rows(findings: &Findings) -> Vec<Vec<String>> {
    let seconds = |time: std::time::Duration| format!("{:.4} s", time.as_secs_f64());
    let mut rows = vec![vec!["exact solution".into(), seconds(findings.exact_time)]];
    for (elements, witness) in &findings.meshes {
        rows.push(vec![
            format!("{elements} finite elements"),
            seconds(witness.time),
        ]);
    }
    if let Ok(chain) = &findings.chain {
        rows.push(vec!["transfer matrices".into(), seconds(chain.time)]);
    }
    rows
}

fn verdict(out: &mut String, first: &Witness, tolerance: f64) {
    if let Some((worst, _)) = largest(&first.differences, |d| d.relative) {
        let word = if worst <= tolerance {
            "within"
        } else {
            "beyond"
        };
        let _ = writeln!(
            out,
            "\nThe largest relative difference of the finite elements, {}, is {word} the tolerance of {}.",
            figure(worst),
            short(tolerance)
        );
    }
}

/// Two digits suffice for a difference.
fn figure(value: f64) -> String {
    if value == 0.0 {
        "0".into()
    } else if value.is_finite() {
        format!("{value:.1e}")
    } else if value.is_nan() {
        "-".into()
    } else {
        "infinite".into()
    }
}

/// A number to six digits.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if (1e-4..1e7).contains(&rounded) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// Columns two spaces apart, the first to the left, the others to the right.
fn table(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|column| {
            let cells = rows.iter().filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        })
        .collect();
    let mut out = String::new();
    for row in rows {
        let mut line = String::new();
        for (column, cell) in row.iter().enumerate() {
            let width = widths[column];
            match column {
                0 => line.push_str(&padded(cell, width)),
                // Trusted text: no escaping needed.
                _ => {
                    let _ = write!(line, "  {cell:>width$}");
                }
            }
        }
        out += line.trim_end();
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_go_by_one_two_and_five() {
        let bands = [0.3, 1.0, 1.999, 2.0, 49.0, 50.0, 999.9, 1000.0].map(band);
        let expected = [
            "0.2 to 0.5",
            "1 to 2",
            "1 to 2",
            "2 to 5",
            "20 to 50",
            "50 to 100",
            "500 to 1000",
            "1000 to 2000",
        ];
        assert_eq!(bands, expected);
    }

    #[test]
    fn digits_are_those_of_a_double() {
        assert_eq!(
            [0.0, 1e-3, 7.0, f64::INFINITY].map(digits),
            [16.0, 3.0, 0.0, 0.0]
        );
    }
}

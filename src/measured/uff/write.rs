//! Writes data set 58 in text format with double precision.

use std::io::{self, Write};

use num_complex::Complex64;

use crate::escape::escape;
use crate::unit::{Amount, Dimension, Kind, Load, Measure, Moves, Unit};

/// A response to write.
#[derive(Debug, Clone, PartialEq)]
pub struct Record<'a> {
    /// Its name: ID line 1, up to 80 characters of ASCII.
    pub name: &'a str,
    /// The model's title: ID line 2.
    pub title: &'a str,
    /// What the values are.
    pub kind: Kind,
    /// The point of the response; none for an energy.
    pub response: Option<Node>,
    /// The point of the single load by which the values are divided.
    pub reference: Option<Node>,
    /// Hz.
    pub frequencies: &'a [f64],
    /// One value per frequency, in the SI unit of `kind`; an energy has no imaginary part.
    pub values: &'a [Complex64],
}

/// A point and a direction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Node {
    /// Its name, up to ten characters of ASCII.
    pub name: String,
    /// Its number.
    pub number: u32,
    /// 1 to 3 translations along x, y, z; 4 to 6 rotations about them; 0 scalar.
    pub direction: i8,
}

/// Losses in writing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Written {
    /// Largest error of a frequency in the file, Hz.
    pub frequency_error: f64,
    /// Values skipped because their frequency equals that of a neighbour in six digits, over all responses.
    pub repeated: usize,
    /// Values skipped because they or their frequency are not finite, over all responses.
    pub not_finite: usize,
}

/// Writes data set 164 (SI) and a data set 58 for each response: complex double precision, an energy real.
///
/// Values have 13 digits. Frequencies are ascending; they are written as even if they are within 1e-9 of their step, else
/// as uneven. The format has six digits for each frequency, or for the first one and the step; the returned value gives
/// the losses. Of frequencies that are equal in six digits, only the nearest one is written. Non-finite values and
/// responses without a finite value are skipped. No date is written.
///
/// # Errors
/// Errors of the writer.
pub fn write_uff(out: &mut dyn Write, records: &[Record]) -> io::Result<Written> {
    writeln!(out, "{:>6}\n{:>6}", -1, 164)?;
    writeln!(out, "{:>10}{:<20}{:>10}", 1, "SI: metre, newton", 2)?;
    let one = "1.00000000000000000D+00";
    writeln!(
        out,
        "{one:>25}{one:>25}{one:>25}\n{:>25}",
        "2.73149999999999977D+02"
    )?;
    writeln!(out, "{:>6}", -1)?;
    let mut written = Written::default();
    for record in records {
        let mut points = finite(record);
        written.not_finite += record.values.len() - points.len();
        let grid = FrequencyGrid::of(&points);
        if !grid.even {
            let before = points.len();
            points = without_repeated(&points);
            written.repeated += before - points.len();
        }
        for (index, (frequency, _)) in points.iter().enumerate() {
            let error = (grid.as_written(index, *frequency) - frequency).abs();
            written.frequency_error = written.frequency_error.max(error);
        }
        if !points.is_empty() {
            write_record(out, record, &points, &grid)?;
        }
    }
    Ok(written)
}

/// A frequency, Hz, and the value there.
type FrequencyValue = (f64, Complex64);

/// The finite points of a record, sorted by frequency.
fn finite(record: &Record) -> Vec<FrequencyValue> {
    let points = record.frequencies.iter().zip(record.values);
    let points = points.map(|(frequency, value)| (*frequency, *value));
    let mut points: Vec<FrequencyValue> = points
        .filter(|(frequency, value)| frequency.is_finite() && value.is_finite())
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// Removes points with equal frequencies in the file, except the nearest one.
fn without_repeated(points: &[FrequencyValue]) -> Vec<FrequencyValue> {
    let same = points.chunk_by(|a, b| single(a.0) == single(b.0));
    let error = |point: &&FrequencyValue| (as_read(point.0) - point.0).abs();
    same.filter_map(|points| points.iter().min_by(|a, b| error(a).total_cmp(&error(b))))
        .copied()
        .collect()
}

/// Frequencies as written in the file.
struct FrequencyGrid {
    even: bool,
    /// First frequency and step, Hz; 0 if they are not even.
    first: f64,
    step: f64,
}

impl FrequencyGrid {
    fn of(points: &[FrequencyValue]) -> Self {
        let uneven = Self {
            even: false,
            first: 0.0,
            step: 0.0,
        };
        let [(first, _), .., (last, _)] = points else {
            return uneven;
        };
        let step = (last - first) / (points.len() - 1) as f64;
        let on_grid = |(index, (frequency, _)): (usize, &FrequencyValue)| {
            (frequency - (first + index as f64 * step)).abs() <= 1e-9 * step
        };
        if step > 0.0 && step.is_finite() && points.iter().enumerate().all(on_grid) {
            return Self {
                even: true,
                first: *first,
                step,
            };
        }
        uneven
    }

    /// A frequency as parsed from the file, Hz.
    fn as_written(&self, index: usize, frequency: f64) -> f64 {
        if self.even {
            as_read(self.first) + index as f64 * as_read(self.step)
        } else {
            as_read(frequency)
        }
    }
}

fn write_record(
    out: &mut dyn Write,
    record: &Record,
    points: &[FrequencyValue],
    grid: &FrequencyGrid,
) -> io::Result<()> {
    writeln!(out, "{:>6}\n{:>6}{:74}", -1, 58, "")?;
    for text in [record.name, record.title, "NONE", "NONE", "NONE"] {
        writeln!(out, "{:<80}", plain(text, 80))?;
    }
    let is_energy = record.kind == Kind::Energy;
    write!(
        out,
        "{:>5}{:>10}{:>5}{:>10}",
        if is_energy { 0 } else { 4 },
        0,
        0,
        0
    )?;
    for end in [&record.response, &record.reference] {
        match end {
            Some(node) => write!(
                out,
                " {:<10}{:>10}{:>4}",
                plain(&node.name, 10),
                node.number,
                node.direction
            )?,
            None => write!(out, " {:<10}{:>10}{:>4}", "NONE", 0, 0)?,
        }
    }
    let kind = if is_energy { 4 } else { 6 };
    let (first, step, z) = (single(grid.first), single(grid.step), single(0.0));
    let (count, even) = (points.len(), i32::from(grid.even));
    writeln!(
        out,
        "\n{kind:>10}{count:>10}{even:>10}{first:>13}{step:>13}{z:>13}"
    )?;
    write_axis(out, 18, [0, 0], "Frequency", Unit::HERTZ.symbol)?;
    write_ordinate(out, record.kind)?;
    write_axis(out, 0, [0, 0], "NONE", "NONE")?;
    write_data(out, points, is_energy, grid.even)?;
    writeln!(out, "{:>6}", -1)
}

/// Records 9 and 10.
fn write_ordinate(out: &mut dyn Write, kind: Kind) -> io::Result<()> {
    let Kind::Amplitude(dimension) = kind else {
        write_axis(out, 1, [1, 1], "Energy", &kind.unit())?;
        return write_axis(out, 0, [0, 0], "NONE", "NONE");
    };
    write_amount(out, dimension.of, 9)?;
    match dimension.per {
        Some(amount) => write_amount(out, amount, 13),
        None => write_axis(out, 0, [0, 0], "NONE", "NONE"),
    }
}

/// The axis of a motion, or of a force with its data type: 9 is a reaction force, 13 an excitation.
fn write_amount(out: &mut dyn Write, amount: Amount, force: i32) -> io::Result<()> {
    let dimension = Dimension {
        of: amount,
        per: None,
    };
    let unit = Kind::Amplitude(dimension).unit();
    let (code, exponents, label) = match amount {
        Amount::Motion(Moves::TwistRate, _) => (1, [-1, 0], "Rate of twist"),
        Amount::Motion(Moves::Length | Moves::Angle, measure) => match measure {
            Measure::Displacement => (8, [0, 0], "Displacement"),
            Measure::Velocity => (11, [0, 0], "Velocity"),
            Measure::Acceleration => (12, [0, 0], "Acceleration"),
        },
        Amount::Load(Load::Force) => (force, [0, 0], "Force"),
        Amount::Load(Load::Moment) => (force, [0, 0], "Moment"),
        Amount::Load(Load::Bimoment) => (1, [2, 1], "Bimoment"),
    };
    write_axis(out, code, exponents, label, &unit)
}

/// An axis: specific data type, exponents of length and force, label and unit.
fn write_axis(
    out: &mut dyn Write,
    code: i32,
    exponents: [i32; 2],
    label: &str,
    unit: &str,
) -> io::Result<()> {
    let [length, force] = exponents;
    writeln!(
        out,
        "{code:>10}{length:>5}{force:>5}{:>5} {label:<20} {unit:<20}",
        0
    )
}

fn write_data(
    out: &mut dyn Write,
    points: &[FrequencyValue],
    is_energy: bool,
    even: bool,
) -> io::Result<()> {
    // Values per line: 4E20.12, 2(E13.5,E20.12) or E13.5,2E20.12.
    let per_line = match (is_energy, even) {
        (true, true) => 4,
        (false, true) | (true, false) => 2,
        (false, false) => 1,
    };
    let last = points.len();
    for (index, (frequency, value)) in points.iter().enumerate() {
        if !even {
            write!(out, "{:>13}", single(*frequency))?;
        }
        write!(out, "{:>20}", exponential(value.re, 12))?;
        if !is_energy {
            write!(out, "{:>20}", exponential(value.im, 12))?;
        }
        if (index + 1) % per_line == 0 || index + 1 == last {
            writeln!(out)?;
        }
    }
    Ok(())
}

/// `E13.5`: six digits.
fn single(number: f64) -> String {
    exponential(number, 5)
}

/// A number as parsed from [`single`].
fn as_read(number: f64) -> f64 {
    single(number).parse().unwrap_or(number)
}

/// A finite number in the notation of Fortran and C, `-1.234568E+00`; the exponent has two digits, or three if needed.
fn exponential(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$E}");
    match text.split_once('E') {
        Some((mantissa, exponent)) => {
            let (sign, digits) = match exponent.strip_prefix('-') {
                Some(digits) => ('-', digits),
                None => ('+', exponent),
            };
            format!("{mantissa}E{sign}{digits:0>2}")
        }
        None => text,
    }
}

/// A text in ASCII of at most `length` characters, never empty or a delimiter; hidden characters are escaped.
fn plain(text: &str, length: usize) -> String {
    let text = escape(text.trim());
    let letters = text.chars().map(|letter| match letter {
        ' '..='~' => letter,
        _ => '?',
    });
    let plain: String = letters.take(length).collect();
    match plain.trim() {
        "" => "NONE".to_owned(),
        "-1" => "\"-1\"".to_owned(),
        _ => plain,
    }
}

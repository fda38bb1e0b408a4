//! Writes data set 58, in the double precision of its text form.

use std::io::{self, Write};

use num_complex::Complex64;

use crate::escape::escape;
use crate::measured::unit::Kind;
use crate::model::Measure;
use crate::solve::form::{Dimension, Load, Moves};

/// A response to write.
#[derive(Debug, Clone, PartialEq)]
pub struct Record<'a> {
    /// Its name: ID line 1, up to 80 characters of ASCII.
    pub name: &'a str,
    /// The model's title: ID line 2.
    pub title: &'a str,
    /// What the values are.
    pub kind: Kind,
    /// Where the response is; none for an energy.
    pub response: Option<Node>,
    /// Where the one load is by which the values are divided.
    pub reference: Option<Node>,
    /// Hz.
    pub frequencies: &'a [f64],
    /// As many, in the SI unit of `kind`; an energy has no imaginary part.
    pub values: &'a [Complex64],
}

/// A place and a direction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Node {
    /// Its name, up to ten characters of ASCII.
    pub name: String,
    /// Its number.
    pub number: u32,
    /// 1 to 3 translations along x, y, z; 4 to 6 rotations about them; 0 a scalar.
    pub direction: i8,
}

/// What was lost in writing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Written {
    /// Largest difference between a frequency and what the file says of it, Hz.
    pub frequency_error: f64,
    /// Whether some response has abscissae of its own, because they are not even.
    pub uneven: bool,
}

/// Writes data set 164 (SI) and a data set 58 for each response: complex double precision, an energy real.
///
/// Values have 13 digits. Frequencies are even where they are to 1e-9 of their step, else uneven; either way the format
/// gives them six digits, and what that loses is returned. No date is written. What is not finite is written as `NaN`.
///
/// # Errors
/// Those of the writer.
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
        let grid = Grid::of(record.frequencies);
        written.uneven |= !grid.even;
        for (index, &frequency) in record.frequencies.iter().enumerate() {
            let said = grid.said(index, frequency);
            written.frequency_error = written.frequency_error.max((said - frequency).abs());
        }
        write_record(out, record, &grid)?;
    }
    Ok(written)
}

/// Frequencies as the file says them.
struct Grid {
    even: bool,
    /// First frequency and step, Hz; 0 where they are not even.
    first: f64,
    step: f64,
}

impl Grid {
    fn of(frequencies: &[f64]) -> Self {
        let uneven = Self {
            even: false,
            first: 0.0,
            step: 0.0,
        };
        let [first, .., last] = frequencies else {
            return uneven;
        };
        let step = (last - first) / (frequencies.len() - 1) as f64;
        let on_grid = |(index, frequency): (usize, &f64)| {
            (frequency - (first + index as f64 * step)).abs() <= 1e-9 * step
        };
        if step > 0.0 && frequencies.iter().enumerate().all(on_grid) {
            return Self {
                even: true,
                first: *first,
                step,
            };
        }
        uneven
    }

    /// A frequency when it is read back, Hz.
    fn said(&self, index: usize, frequency: f64) -> f64 {
        let read = |number| single(number).parse().unwrap_or(number);
        if self.even {
            read(self.first) + index as f64 * read(self.step)
        } else {
            read(frequency)
        }
    }
}

fn write_record(out: &mut dyn Write, record: &Record, grid: &Grid) -> io::Result<()> {
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
    let (points, even) = (record.frequencies.len(), i32::from(grid.even));
    writeln!(
        out,
        "\n{kind:>10}{points:>10}{even:>10}{first:>13}{step:>13}{z:>13}"
    )?;
    write_axis(out, 18, [0, 0], "Frequency", "Hz")?;
    write_ordinate(out, record.kind)?;
    write_axis(out, 0, [0, 0], "NONE", "NONE")?;
    write_data(out, record, grid.even)?;
    writeln!(out, "{:>6}", -1)
}

/// Records 9 and 10.
fn write_ordinate(out: &mut dyn Write, kind: Kind) -> io::Result<()> {
    let Kind::Motion(dimension) = kind else {
        write_axis(out, 1, [1, 1], "Energy", &kind.unit())?;
        return write_axis(out, 0, [0, 0], "NONE", "NONE");
    };
    let above = Kind::Motion(Dimension {
        per: None,
        ..dimension
    })
    .unit();
    let (code, label) = match dimension.measure {
        Measure::Displacement => (8, "Displacement"),
        Measure::Velocity => (11, "Velocity"),
        Measure::Acceleration => (12, "Acceleration"),
    };
    match dimension.moves {
        Moves::Length | Moves::Angle => write_axis(out, code, [0, 0], label, &above)?,
        Moves::TwistRate => write_axis(out, 1, [-1, 0], "Rate of twist", &above)?,
    }
    match dimension.per {
        None => write_axis(out, 0, [0, 0], "NONE", "NONE"),
        Some(Load::Force) => write_axis(out, 13, [0, 0], "Force", "N"),
        Some(Load::Moment) => write_axis(out, 13, [0, 0], "Moment", "N m"),
        Some(Load::Bimoment) => write_axis(out, 1, [2, 1], "Bimoment", "N m2"),
    }
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

fn write_data(out: &mut dyn Write, record: &Record, even: bool) -> io::Result<()> {
    let is_energy = record.kind == Kind::Energy;
    // Values a line: 4E20.12, 2(E13.5,E20.12) or E13.5,2E20.12.
    let a_line = match (is_energy, even) {
        (true, true) => 4,
        (false, true) | (true, false) => 2,
        (false, false) => 1,
    };
    let last = record.values.len();
    for (index, (frequency, value)) in record.frequencies.iter().zip(record.values).enumerate() {
        if !even {
            write!(out, "{:>13}", single(*frequency))?;
        }
        write!(out, "{:>20}", exponential(value.re, 12))?;
        if !is_energy {
            write!(out, "{:>20}", exponential(value.im, 12))?;
        }
        if (index + 1) % a_line == 0 || index + 1 == last {
            writeln!(out)?;
        }
    }
    Ok(())
}

/// `E13.5`: six digits.
fn single(number: f64) -> String {
    exponential(number, 5)
}

/// A number as Fortran and C write it, `-1.234568E+00`; two digits in the exponent, or three where they are needed.
fn exponential(number: f64, decimals: usize) -> String {
    if !number.is_finite() {
        return "NaN".to_owned();
    }
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

/// A text as ASCII of some length that is never empty nor the end of a data set; hidden characters are escaped.
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

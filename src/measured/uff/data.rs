//! Record 12 of data set 58: the numbers, in text or binary format.

use super::header::{DataFormat, FunctionHeader};
use super::lines::{UffLines, starts_with_end};
use crate::measured::{Fault, number, text_of};

/// Field widths of a line: `6E13.5`, `4E20.12`, `2(E13.5,E20.12)` or `E13.5,2E20.12`.
const fn widths(format: DataFormat) -> &'static [usize] {
    match (format.double, format.even, format.complex) {
        (false, ..) => &[13; 6],
        (true, true, _) => &[20; 4],
        (true, false, false) => &[13, 20, 13, 20],
        (true, false, true) => &[13, 20, 20],
    }
}

/// The numbers of a function, in the order of the file.
#[derive(Debug)]
pub(super) enum Numbers {
    Complete(Vec<f64>),
    /// The data set ends before the last number.
    Truncated(Fault),
}

/// Reads the numbers of a text function; a number that does not fit its field is a fault.
pub(super) fn text(lines: &mut UffLines, header: &FunctionHeader) -> Result<Numbers, Fault> {
    let wanted = header.points * header.format.numbers();
    // A number has at least two bytes; the header may announce more numbers than there are.
    let mut numbers = Vec::with_capacity(wanted.min(lines.rest().len() / 2));
    let widths = widths(header.format);
    // Count of numbers and length of the previous line.
    let mut usual = (0, 0);
    while numbers.len() < wanted {
        let Some(line) = lines.record() else {
            break;
        };
        let line = line.trim_ascii_end();
        let found = of_line(line, widths, wanted - numbers.len());
        let count = found.as_ref().map_or(0, Vec::len);
        let end = match usual {
            (before, length) if before == count => length,
            (before, length) if length == end_of(widths, before) => end_of(widths, count),
            _ => 0,
        };
        usual = (count, line.len());
        // In a truncated file the last digits of the last number may be missing.
        let short = line.len() < end;
        match found {
            _ if lines.is_truncated() && (short || found.is_err()) => break,
            Ok(found) => numbers.extend(found),
            Err((column, message)) => {
                return Err(lines.fault(header.set, 12, column + 1, message));
            }
        }
    }
    let found = if numbers.len() == wanted {
        Numbers::Complete(numbers)
    } else {
        Numbers::Truncated(too_few(
            lines,
            header,
            numbers.len() / header.format.numbers(),
        ))
    };
    lines.end_set();
    Ok(found)
}

fn too_few(lines: &UffLines, header: &FunctionHeader, values: usize) -> Fault {
    let message = format!(
        "ends after {values} of {} values: all would be accepted, or their number in record 7",
        header.points
    );
    lines.fault(header.set, 12, 1, message)
}

/// The end column of `count` fields.
fn end_of(widths: &[usize], count: usize) -> usize {
    widths.iter().take(count).sum()
}

/// Up to `most` numbers of a line; else the column, from 0, of the invalid field and what is accepted.
///
/// If the line has as many numbers as fields, columns are ignored: some programs write abscissae in 20 columns. Else the
/// numbers are in the columns of the standard, or between blanks if these columns would split a number.
fn of_line(line: &[u8], widths: &[usize], most: usize) -> Result<Vec<f64>, (usize, String)> {
    let words = line.split(u8::is_ascii_whitespace);
    let words = words.filter(|word| !word.is_empty());
    let by_words: Option<Vec<f64>> = words.map(|word| number::parse(word, false)).collect();
    let by_words = by_words.filter(|found| found.len() <= most);
    let fields = widths.len().min(most);
    match by_words {
        Some(found) if found.len() == fields || splits_a_number(line, widths) => Ok(found),
        _ => by_columns(line, widths, most),
    }
}

/// Whether a field ends within a number: adjacent numbers without a blank start with a sign.
fn splits_a_number(line: &[u8], widths: &[usize]) -> bool {
    let mut end = 0;
    widths.iter().any(|width| {
        end += width;
        let [before, after] = [end - 1, end].map(|at| line.get(at).unwrap_or(&b' '));
        let is_blank = before.is_ascii_whitespace() || after.is_ascii_whitespace();
        !is_blank && !matches!(after, b'-' | b'+')
    })
}

/// The numbers in the columns of the standard.
fn by_columns(line: &[u8], widths: &[usize], most: usize) -> Result<Vec<f64>, (usize, String)> {
    let mut numbers = Vec::with_capacity(widths.len());
    let mut column = 0;
    for width in widths.iter().take(most) {
        if column >= line.len() {
            break;
        }
        let field = &line[column..line.len().min(column + width)];
        let Some(number) = number::parse(field, false) else {
            let found = text_of(field);
            let message = format!(
                "{:?} is not a number: one would be accepted in {width} columns",
                found.trim()
            );
            return Err((column, message));
        };
        numbers.push(number);
        column += width;
    }
    Ok(numbers)
}

/// The layout of the numbers in a binary data set.
#[derive(Debug, Clone, Copy)]
struct BinaryLayout {
    little: bool,
    /// Bytes of an abscissa, and of a real or imaginary part.
    sizes: (usize, usize),
    /// Total bytes.
    length: usize,
}

/// Reads the numbers of a binary function. `start` is the line with the number of the data set.
pub(super) fn binary(
    lines: &mut UffLines,
    header: &FunctionHeader,
    start: &[u8],
) -> Result<Numbers, Fault> {
    let BinaryLayout {
        little,
        sizes,
        length,
    } = match binary_layout(lines, header, start) {
        Ok(binary_layout) => binary_layout,
        Err(fault) if lines.rest().len() < header.format.least_bytes(header.points) => {
            lines.skip(lines.rest().len());
            return Ok(Numbers::Truncated(fault));
        }
        Err(fault) => return Err(fault),
    };
    let mut data = &lines.rest()[..length];
    let mut numbers = Vec::with_capacity(header.points * header.format.numbers());
    for _ in 0..header.points {
        if !header.format.even {
            numbers.extend(take(&mut data, sizes.0, little));
        }
        for _ in 0..=usize::from(header.format.complex) {
            numbers.extend(take(&mut data, sizes.1, little));
        }
    }
    lines.skip(length);
    lines.end_set();
    Ok(Numbers::Complete(numbers))
}

/// Skips the numbers of a function.
pub(super) fn skip(
    lines: &mut UffLines,
    header: &FunctionHeader,
    start: Option<&[u8]>,
) -> Result<(), Fault> {
    if let Some(start) = start {
        binary(lines, header, start)?;
    } else {
        lines.end_set();
    }
    Ok(())
}

/// The standard has abscissae in single precision and ordinates as in record 7. Some programs write all in double
/// precision and a wrong byte count in the first line, so the end of the data set decides.
fn binary_layout(
    lines: &UffLines,
    header: &FunctionHeader,
    start: &[u8],
) -> Result<BinaryLayout, Fault> {
    let field = |from: usize, to: usize| {
        let field = start.get(from..to.min(start.len())).unwrap_or_default();
        std::str::from_utf8(field.trim_ascii())
            .ok()?
            .parse::<usize>()
            .ok()
    };
    let fault = |message: String| Err(lines.fault(header.set, 12, 1, message));
    let little = match field(7, 13) {
        Some(1) => true,
        Some(2) => false,
        _ => {
            return fault(
                "no byte order: 1 (little endian) or 2 (big) would be accepted".to_owned(),
            );
        }
    };
    if field(13, 19) != Some(2) {
        return fault(
            "a floating-point format other than 2 (IEEE 754), which would be accepted".to_owned(),
        );
    }
    let sizes = if header.format.double {
        [(4, 8), (8, 8)]
    } else {
        [(4, 4), (8, 8)]
    };
    let length = |(at, value): (usize, usize)| {
        let abscissa = if header.format.even { 0 } else { at };
        header.points * (abscissa + value * (1 + usize::from(header.format.complex)))
    };
    let ends = |length: usize| lines.rest().get(length..).is_some_and(starts_with_end);
    let Some(sizes) = sizes.into_iter().find(|sizes| ends(length(*sizes))) else {
        let bytes = sizes.map(|sizes| length(sizes).to_string()).join(" or ");
        return fault(format!("does not end after {bytes} bytes of data"));
    };
    Ok(BinaryLayout {
        little,
        sizes,
        length: length(sizes),
    })
}

/// The next number of 4 or 8 bytes.
fn take(data: &mut &[u8], size: usize, little: bool) -> Option<f64> {
    if size == 4 {
        let (bytes, rest) = data.split_first_chunk()?;
        *data = rest;
        return Some(f64::from(if little {
            f32::from_le_bytes(*bytes)
        } else {
            f32::from_be_bytes(*bytes)
        }));
    }
    let (bytes, rest) = data.split_first_chunk()?;
    *data = rest;
    Some(if little {
        f64::from_le_bytes(*bytes)
    } else {
        f64::from_be_bytes(*bytes)
    })
}

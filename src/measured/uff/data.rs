//! Record 12 of data set 58: the numbers, as text or binary.

use super::head::{Form, Head};
use super::lines::{Lines, ends_here};
use crate::measured::{Fault, number, text_of};

/// Widths of the fields of a line: `6E13.5`, `4E20.12`, `2(E13.5,E20.12)` or `E13.5,2E20.12`.
const fn widths(form: Form) -> &'static [usize] {
    match (form.double, form.even, form.complex) {
        (false, ..) => &[13; 6],
        (true, true, _) => &[20; 4],
        (true, false, false) => &[13, 20, 13, 20],
        (true, false, true) => &[13, 20, 20],
    }
}

/// The numbers of a function, in the order of the file.
#[derive(Debug)]
pub(super) enum Numbers {
    All(Vec<f64>),
    /// The data set ends before the last of them.
    CutOff(Fault),
}

/// The numbers of a function that is text; what does not fit its field is a fault.
pub(super) fn text(lines: &mut Lines, head: &Head) -> Result<Numbers, Fault> {
    let wanted = head.points * head.form.numbers();
    // A number is two bytes at least; the head may promise more than there is.
    let mut numbers = Vec::with_capacity(wanted.min(lines.rest().len() / 2));
    let widths = widths(head.form);
    // Numbers and length of the line before.
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
        // Of the last number of a file that is cut off, the last digits may be missing.
        let short = line.len() < end;
        match found {
            _ if lines.is_cut() && (short || found.is_err()) => break,
            Ok(found) => numbers.extend(found),
            Err((column, message)) => {
                return Err(lines.fault(head.set, 12, column + 1, message));
            }
        }
    }
    let found = if numbers.len() == wanted {
        Numbers::All(numbers)
    } else {
        Numbers::CutOff(too_few(lines, head, numbers.len() / head.form.numbers()))
    };
    lines.end_set();
    Ok(found)
}

fn too_few(lines: &Lines, head: &Head, values: usize) -> Fault {
    let message = format!(
        "ends after {values} of {} values: all would be accepted, or their number in record 7",
        head.points
    );
    lines.fault(head.set, 12, 1, message)
}

/// The last column of this many fields.
fn end_of(widths: &[usize], count: usize) -> usize {
    widths.iter().take(count).sum()
}

/// Up to `most` numbers of a line, or the column from 0 of what is none and what would be accepted.
///
/// Where as many numbers stand as there are fields, they are those, in whatever columns: programs write abscissae in 20
/// columns, too. Else they are in the columns of the standard, and where these part a number, between blanks.
fn of_line(line: &[u8], widths: &[usize], most: usize) -> Result<Vec<f64>, (usize, String)> {
    let words = line.split(u8::is_ascii_whitespace);
    let words = words.filter(|word| !word.is_empty());
    let by_words: Option<Vec<f64>> = words.map(|word| number::parse(word, false)).collect();
    let by_words = by_words.filter(|found| found.len() <= most);
    let fields = widths.len().min(most);
    match by_words {
        Some(found) if found.len() == fields || parts_a_number(line, widths) => Ok(found),
        _ => by_columns(line, widths, most),
    }
}

/// Whether the end of a field lies within a number: only a sign stands there without a blank in front.
fn parts_a_number(line: &[u8], widths: &[usize]) -> bool {
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
                "{:?} is no number: one would be accepted in {width} columns",
                found.trim()
            );
            return Err((column, message));
        };
        numbers.push(number);
        column += width;
    }
    Ok(numbers)
}

/// How the numbers of a function lie in a binary data set.
#[derive(Debug, Clone, Copy)]
struct Packing {
    little: bool,
    /// Bytes of an abscissa, and of a part of a value.
    sizes: (usize, usize),
    /// Bytes of all.
    length: usize,
}

/// The numbers of a function that is binary. `start` is the line with the number of the data set.
pub(super) fn binary(lines: &mut Lines, head: &Head, start: &[u8]) -> Result<Numbers, Fault> {
    let Packing {
        little,
        sizes,
        length,
    } = match packing(lines, head, start) {
        Ok(packing) => packing,
        Err(fault) if lines.rest().len() < head.form.least_bytes(head.points) => {
            lines.pass(lines.rest().len());
            return Ok(Numbers::CutOff(fault));
        }
        Err(fault) => return Err(fault),
    };
    let mut data = &lines.rest()[..length];
    let mut numbers = Vec::with_capacity(head.points * head.form.numbers());
    for _ in 0..head.points {
        if !head.form.even {
            numbers.extend(take(&mut data, sizes.0, little));
        }
        for _ in 0..=usize::from(head.form.complex) {
            numbers.extend(take(&mut data, sizes.1, little));
        }
    }
    lines.pass(length);
    lines.end_set();
    Ok(Numbers::All(numbers))
}

/// Passes over the numbers of a function.
pub(super) fn pass(lines: &mut Lines, head: &Head, start: Option<&[u8]>) -> Result<(), Fault> {
    if let Some(start) = start {
        binary(lines, head, start)?;
    } else {
        lines.end_set();
    }
    Ok(())
}

/// By the standard abscissae are in single precision and the ordinates as record 7 says. Programs also write all in
/// double precision and give another number of bytes in the first line, so what counts is where the data set ends.
fn packing(lines: &Lines, head: &Head, start: &[u8]) -> Result<Packing, Fault> {
    let field = |from: usize, to: usize| {
        let field = start.get(from..to.min(start.len())).unwrap_or_default();
        std::str::from_utf8(field.trim_ascii())
            .ok()?
            .parse::<usize>()
            .ok()
    };
    let fault = |message: String| Err(lines.fault(head.set, 12, 1, message));
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
            "another floating-point format than 2, IEEE 754, which would be accepted".to_owned(),
        );
    }
    let sizes = if head.form.double {
        [(4, 8), (8, 8)]
    } else {
        [(4, 4), (8, 8)]
    };
    let length = |(at, value): (usize, usize)| {
        let abscissa = if head.form.even { 0 } else { at };
        head.points * (abscissa + value * (1 + usize::from(head.form.complex)))
    };
    let ends = |length: usize| lines.rest().get(length..).is_some_and(ends_here);
    let Some(sizes) = sizes.into_iter().find(|sizes| ends(length(*sizes))) else {
        let bytes = sizes.map(|sizes| length(sizes).to_string()).join(" or ");
        return fault(format!("does not end behind {bytes} bytes of data"));
    };
    Ok(Packing {
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

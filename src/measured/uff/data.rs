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

/// The numbers of a function that is text, in the order of the file; what does not fit its field is a fault.
pub(super) fn text(lines: &mut Lines, head: &Head) -> Result<Vec<f64>, Fault> {
    let wanted = head.points * head.form.numbers();
    // A field is ten bytes at least; the head may promise more than there is.
    let mut numbers = Vec::with_capacity(wanted.min(lines.rest().len() / 10));
    while numbers.len() < wanted {
        let Some(line) = lines.record() else {
            let (found, numbers) = (numbers.len(), head.form.numbers());
            let message = format!(
                "ends after {} of {} values: all would be accepted, or their number in record 7",
                found / numbers,
                head.points
            );
            return Err(lines.fault(head.set, 12, 1, message));
        };
        let line = line.trim_ascii_end();
        let mut column = 0;
        for width in widths(head.form) {
            if column >= line.len() || numbers.len() == wanted {
                break;
            }
            let field = &line[column..line.len().min(column + width)];
            let Some(number) = number::parse(field, false) else {
                let found = text_of(field);
                let message = format!(
                    "{:?} is no number: one would be accepted in {width} columns",
                    found.trim()
                );
                return Err(lines.fault(head.set, 12, column + 1, message));
            };
            numbers.push(number);
            column += width;
        }
    }
    lines.end_set();
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
pub(super) fn binary(lines: &mut Lines, head: &Head, start: &[u8]) -> Result<Vec<f64>, Fault> {
    let Packing {
        little,
        sizes,
        length,
    } = packing(lines, head, start)?;
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
    Ok(numbers)
}

/// Passes over the numbers of a function.
pub(super) fn pass(lines: &mut Lines, head: &Head, binary: Option<&[u8]>) -> Result<(), Fault> {
    if let Some(start) = binary {
        lines.pass(packing(lines, head, start)?.length);
    }
    lines.end_set();
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
        return fault(format!(
            "no end of the data set behind {bytes} bytes of data"
        ));
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

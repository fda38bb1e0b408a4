//! Measured curves from files: tables (CSV) and universal files (UFF, data set 58), and how well a model fits them.
//!
//! [`read()`] returns the curves of a file in SI. A [`Layout`] gives what a table does not specify; [`inspect()`] reports the
//! content of a file and the missing information, and [`open()`] reads it if nothing is missing. [`write_uff()`] writes data
//! set 58, [`fit()`] compares a model's values with a curve. Nothing here computes a response.
//!
//! # Example
//!
//! ```
//! use beamtune::measured::{Hint, fit, read};
//! use beamtune::{model, presets, solve};
//!
//! let text = "Frequency [Hz],Tip magnitude [um],Tip phase [deg]\n10,12.0,-1\n20,18.5,-3\n30,95.0,-80\n";
//! let curves = read(text.as_bytes(), &Hint::default()).expect("a table whose header says its units");
//! assert!((curves[0].values[0].norm() - 12.0e-6).abs() < 1e-18);
//!
//! let beam = model::read(presets::find("cantilever").expect("an embedded preset").text).expect("a possible model");
//! let frf = solve::sweep_alone(&beam, &curves[0].frequencies);
//! let fit = fit(&curves[0], &frf.columns[0].values, None).expect("points in common");
//! assert!((0.0..=1.0).contains(&fit.frac));
//! println!("FRAC {:.3}, mean difference {:+.1} dB", fit.frac, fit.mean_decibels);
//! ```

mod curve;
mod fit;
mod inspect;
mod layout;
mod number;
mod table;
mod uff;

use std::io::Read;
use std::path::Path;

pub use crate::model::Fault;
pub use curve::Curve;
pub use fit::{Fit, fit};
pub use inspect::{Inspection, Opened, inspect, open, open_in_si};
pub use layout::{Layout, Places, Question, Values};
pub use uff::write::{Node, Record, Written, write_uff};

/// Largest accepted file, bytes: 256 MiB.
pub const MOST_BYTES: usize = 256 << 20;

/// Most values of a file, over all its curves.
pub const MOST_VALUES: usize = 5_000_000;

/// The UTF-8 byte order mark that some programs write.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Information about a file in addition to its content.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Hint {
    /// The file's name, with or without folders and extension; the name of curves without a name.
    pub name: String,
    /// The user's description of a table, which overrides the file. For a universal file only its units are used, if the
    /// file gives none or gives unknown ones.
    pub layout: Option<Layout>,
}

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// A table of numbers as text.
    Csv,
    /// A universal file.
    Uff,
}

impl Format {
    /// The format by the content, else by the extension (`uff`, `unv`, `u58`, `bunv`).
    ///
    /// A universal file starts with a line `-1`.
    pub fn of(bytes: &[u8], name: &str) -> Self {
        let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        let mut lines = bytes
            .trim_ascii_start()
            .split(|&byte| matches!(byte, b'\n' | b'\r'));
        let delimiter = lines.next().is_some_and(|line| line.trim_ascii() == b"-1");
        let ending = Path::new(name)
            .extension()
            .and_then(|ending| ending.to_str());
        let named = ending.is_some_and(|ending| {
            let endings = ["uff", "unv", "u58", "bunv"];
            endings.iter().any(|one| one.eq_ignore_ascii_case(ending))
        });
        if delimiter || named {
            Self::Uff
        } else {
            Self::Csv
        }
    }
}

impl Hint {
    /// The file's name without folders and extension.
    fn stem(&self) -> String {
        let stem = Path::new(&self.name).file_stem();
        stem.map_or_else(
            || "measured".to_owned(),
            |stem| text_of(stem.as_encoded_bytes()),
        )
    }
}

/// Reads the content of a file.
///
/// # Errors
/// The file cannot be read, is not a regular file, or is larger than [`MOST_BYTES`].
pub fn load(path: &Path) -> Result<Vec<u8>, Fault> {
    let mut bytes = Vec::new();
    let read = crate::files::open(path)
        .and_then(|file| file.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes));
    match read {
        Ok(_) => of_possible_size(&bytes).map(|()| bytes),
        Err(error) => Err(Fault::new("", format!("cannot be read: {error}"))),
    }
}

/// The curves of a file, of either format, in the order of the file; names are unique.
///
/// Time and memory are linear in the size of the file.
///
/// # Errors
/// What is wrong and what is accepted, with line and column (in a table: line and cell number); the path is the data set
/// and record of a universal file. A table that needs a [`Layout`] and has none is also an error: [`inspect()`] reports
/// what is missing.
pub fn read(bytes: &[u8], hint: &Hint) -> Result<Vec<Curve>, Fault> {
    of_possible_size(bytes)?;
    let mut curves = match Format::of(bytes, &hint.name) {
        Format::Csv => table::read(bytes, hint),
        Format::Uff => uff::read(bytes, hint),
    }?;
    curve::distinguish(&mut curves);
    Ok(curves)
}

fn of_possible_size(bytes: &[u8]) -> Result<(), Fault> {
    if bytes.len() > MOST_BYTES {
        let most = MOST_BYTES >> 20;
        return Err(Fault::new("", format!("is larger than {most} MiB")));
    }
    Ok(())
}

/// Bytes as text in UTF-8, else Latin-1; control characters, which could control a terminal, become blanks.
fn text_of(bytes: &[u8]) -> String {
    let visible = |letter: char| if letter.is_control() { ' ' } else { letter };
    match std::str::from_utf8(bytes) {
        Ok(text) => text.chars().map(visible).collect(),
        Err(_) => bytes.iter().copied().map(char::from).map(visible).collect(),
    }
}

/// A fault at a position of a text, line and column from 1.
fn fault_at(path: &str, line: usize, column: usize, message: impl Into<String>) -> Fault {
    Fault {
        line: Some(line),
        column: Some(column),
        ..Fault::new(path, message)
    }
}

/// The message for too many values.
fn too_many() -> String {
    format!("more than {MOST_VALUES} values; fewer points or fewer curves would be accepted")
}

//! Measured curves from files: tables (CSV) and universal files (UFF, data set 58), and how well a model fits them.
//!
//! [`read()`] gives the curves of a file in SI. What a table does not say of itself, a [`Layout`] does; [`inspect()`] tells
//! what is in a file and what has to be asked, and [`open()`] reads it where nothing has to be. [`write_uff()`] writes data
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

/// Largest file that is read, bytes: 256 MiB.
pub const MOST_BYTES: usize = 256 << 20;

/// Most values that are read from a file, over all its curves.
pub const MOST_VALUES: usize = 5_000_000;

/// What stands in front of UTF-8 of some programs.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// What is known of a file besides its contents.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Hint {
    /// The file's name, with or without folders and ending; curves without a name are named after it.
    pub name: String,
    /// What a person says of a table. It holds over the words of the file. Of a universal file, only its units are used,
    /// where the file gives none or gives words that are not understood.
    pub layout: Option<Layout>,
}

/// What kind of file it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// A table of numbers as text.
    Csv,
    /// A universal file.
    Uff,
}

impl Format {
    /// The format by the contents; by the ending of the name (`uff`, `unv`, `u58`, `bunv`) where they do not tell.
    ///
    /// A universal file starts with a line that is `-1` alone.
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
    /// The file's name without folders and ending.
    fn stem(&self) -> String {
        let stem = Path::new(&self.name).file_stem();
        stem.map_or_else(
            || "measured".to_owned(),
            |stem| text_of(stem.as_encoded_bytes()),
        )
    }
}

/// The contents of a file.
///
/// # Errors
/// Says what is wrong: it cannot be read, is no regular file, or is larger than [`MOST_BYTES`].
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
/// What is wrong with it and what would be accepted, with line and column (of a table: line and number of the cell);
/// the path is the data set and record of a universal file. A table that needs a [`Layout`] to be understood, and is
/// given none, is a fault too: [`inspect()`] says what is missing.
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

/// Bytes as text, UTF-8 and Latin-1 where they are not, with blanks for what cannot be shown: a terminal would obey it.
fn text_of(bytes: &[u8]) -> String {
    let visible = |letter: char| if letter.is_control() { ' ' } else { letter };
    match std::str::from_utf8(bytes) {
        Ok(text) => text.chars().map(visible).collect(),
        Err(_) => bytes.iter().copied().map(char::from).map(visible).collect(),
    }
}

/// A fault at a place of a text, line and column from 1.
fn fault_at(path: &str, line: usize, column: usize, message: impl Into<String>) -> Fault {
    Fault {
        line: Some(line),
        column: Some(column),
        ..Fault::new(path, message)
    }
}

/// That a file holds more values than are read.
fn too_many() -> String {
    format!("more than {MOST_VALUES} values; fewer points or fewer curves would be accepted")
}

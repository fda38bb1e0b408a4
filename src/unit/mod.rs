//! Units: their symbols for people, and the spellings that are accepted.
//!
//! [`Unit`] is the unit of a parameter, whose typed text [`value_input`] parses. [`Dimension`] and [`Kind`] describe
//! the values of a response, [`ValueUnit`] parses their unit in a file, [`FrequencyUnit`] and [`PhaseUnit`] are the
//! units of frequencies and phases.

mod dimension;
mod frequency;
mod parameter;
mod response;
pub mod value_input;

pub use dimension::{Amount, Dimension, Form, Kind, Load, Measure, Moves};
pub use frequency::{FrequencyUnit, PhaseUnit};
pub use parameter::{Unit, counted, grouped};
pub use response::ValueUnit;
pub(crate) use response::load;

/// A letter of a unit in ASCII: a plain digit for a superscript, u for micro.
fn plain_letter(letter: char) -> char {
    match letter {
        '²' => '2',
        '³' => '3',
        'µ' | 'μ' => 'u',
        other => other,
    }
}

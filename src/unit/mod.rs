//! Units: what a number is of, how it is written for people, and which words of its unit are understood.
//!
//! [`Unit`] is that of a parameter, whose typed text [`value_input`] reads. [`Dimension`] and [`Kind`] say what the values of a
//! response are, [`ValueUnit`] reads the unit in which a file gives them, [`FrequencyUnit`] and [`PhaseUnit`] are those of
//! frequencies and phases.

mod dimension;
mod frequency;
mod parameter;
mod response;
pub mod value_input;

pub use dimension::{Dimension, Form, Kind, Load, Measure, Moves};
pub use frequency::{FrequencyUnit, PhaseUnit};
pub use parameter::{Unit, counted, grouped};
pub use response::ValueUnit;
pub(crate) use response::load;

/// A letter of a unit as every keyboard has it: a plain digit for a raised one, u for micro.
fn plain_letter(letter: char) -> char {
    match letter {
        '²' => '2',
        '³' => '3',
        'µ' | 'μ' => 'u',
        other => other,
    }
}

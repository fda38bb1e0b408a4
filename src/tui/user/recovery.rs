//! Edits that are not saved, kept so that a lost line or a killed program loses none of them.
//!
//! A running designer that has unsaved edits owns two files of the recovery folder: `NAME-RANDOM.toml`, to which its
//! [`Keeper`] adds every edit, and `NAME-RANDOM.lock`, which it holds locked. The system releases the lock however the
//! program ends; [`found`] then offers the file to the next one. The file is a model file below
//! three lines of comment that say what it is. Of a large model it is the text that was opened or saved last, above a
//! line of comment for each edit; at its end by a signal or a fault, the designer replaces that by the whole model.

mod found;
mod keeper;
mod slot;
mod text;

pub use found::{Found, found};
pub use keeper::{Keeper, Kept, Left, leave_elsewhere};

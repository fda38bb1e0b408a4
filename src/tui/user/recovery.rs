//! The recovery file: unsaved changes survive a broken connection or a killed program.
//!
//! A running designer with unsaved changes owns two files of the recovery folder: `NAME-RANDOM.toml`, to which its
//! [`Keeper`] appends every edit, and `NAME-RANDOM.lock`, which it holds locked. The system releases the lock however
//! the program ends; [`found`] then offers the file to the next program. The file is a model file below three lines of
//! comment that describe it. For a large model it is the text that was last opened or saved, followed by one line of
//! comment per edit; when a signal or an internal error ends the designer, it replaces that by the whole model.

mod found;
mod keeper;
mod slot;
mod text;

pub use found::{Found, found};
pub use keeper::{Keeper, Kept, Left, leave_elsewhere};

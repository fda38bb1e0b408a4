//! What the program keeps for its user, outside of any model file: options and keys ([`config`]), what was last looked
//! at ([`memory`]), edits that are not saved ([`recovery`]) and what went wrong ([`log`]), each in its place
//! ([`Folders`](crate::files::Folders)).
//!
//! Nothing here knows the designer's state. A folder is made when something is written to it, not before.

pub mod config;
pub mod log;
pub mod memory;
pub mod recovery;

//! The user's files, apart from models: options and keys ([`config`]), the last view of each model ([`memory`]),
//! unsaved changes ([`recovery`]) and errors ([`log`]), each in its folder ([`Folders`](crate::files::Folders)).
//!
//! This module does not know the designer's state. It creates a folder only when it writes to it.

pub mod config;
pub mod log;
pub mod memory;
pub mod recovery;

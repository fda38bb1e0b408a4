//! Files of models and of the user: opened without blocking, written without data loss, and their paths.
//!
//! [`open()`] and [`load`] read, [`save()`] replaces a file atomically and keeps its owner, mode and attributes,
//! [`Source`] is the origin of a model, and [`Folders`] are those of the user's own files.

mod folders;
mod open;
mod save;
mod source;

pub use folders::Folders;
pub(crate) use folders::make_private;
#[cfg(test)]
pub(crate) use folders::names;
pub(crate) use open::read_if_there;
pub use open::{load, open, open_with, text_of};
pub(crate) use save::error_text;
pub use save::{may_save, remove_temporaries, save, save_with};
pub use source::{Opened, Source};

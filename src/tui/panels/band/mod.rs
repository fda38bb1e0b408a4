//! The levels in a band of the frequency axis: maximum, mean square, and the reduction relative to a reference.

mod commands;
pub(crate) mod view;

pub use commands::{Band, MemberLevels, ResponseLevel};

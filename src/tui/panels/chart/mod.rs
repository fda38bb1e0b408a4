//! The chart: its curves, what part of them is visible, and how their values are shown.

mod commands;
mod curves;
mod detail;
mod detail_request;
mod display;
mod display_commands;
pub(crate) mod figure;
pub(crate) mod picture;
mod readout;
pub(crate) mod view;
mod zoom;

pub use curves::{Curves, Shown, Turn};
pub use detail::{Detail, DetailPicture};
pub use display::{Display, MOTION};
pub use picture::{Compared, Member, Picture, Trace};

#[cfg(test)]
mod tests;

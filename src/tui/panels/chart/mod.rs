//! The chart: its curves, what part of them is visible, and how their values are shown.

pub(crate) mod commands;
pub(crate) mod curves;
mod detail_request;
mod display_commands;
pub(crate) mod figure;
mod readout;
pub(crate) mod view;
mod zoom;

pub use curves::{Compared, Curves, Member, Picture, Shown, Trace};
pub use detail_request::{Detail, DetailPicture};
pub use display_commands::{Display, MOTION};

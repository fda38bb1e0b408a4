//! The chart: its curves, what part of them is visible, and how their values are shown.

pub(crate) mod commands;
pub(crate) mod curves;
mod detail;
mod detail_request;
mod display;
mod display_commands;
pub(crate) mod figure;
mod readout;
pub(crate) mod view;
mod zoom;

pub use curves::{Compared, Curves, Member, Picture, Shown, Trace};
pub use detail::{Detail, DetailPicture};
pub use display::{Display, MOTION};

//! The designer: a terminal program in which a parameter is turned and its curves follow.
//!
//! A key becomes a command by the one table of [`keys`], a command changes the state of [`app`], the state is drawn
//! by `view`. What is to be done outside of the state (solving, files) are effects, performed by `effects` here; the
//! program waits on one channel of [`event::Event`]s and draws when one has arrived and [`pace`] sees fit. What it
//! keeps for its user is in [`user`].

pub mod app;
mod ascii;
pub mod backend;
mod effects;
pub mod event;
mod export;
pub mod frame_scheduler;
mod fuzzy;
pub mod keys;
pub mod options;
pub mod plot;
mod run;
pub mod scene;
mod sketch;
pub mod terminal;
pub mod theme;
pub mod tree;
pub mod user;
pub mod view;
mod watch;

pub use run::{Ended, Setup, run};

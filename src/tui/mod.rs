//! The designer: a terminal program that shows frequency responses while the user changes a parameter.
//!
//! The table of [`keys`] maps a key to a command, a command changes the state of [`app`], and `view` draws the state.
//! What belongs to one feature (its state, its commands, its drawing) is a folder of [`panels`]. Input, output and
//! solving are effects, performed by `effects`. The program waits on one channel of [`event::Event`]s; after an event,
//! [`frame_scheduler`] decides when to draw. [`user`] stores the user's files.

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
pub mod panels;
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

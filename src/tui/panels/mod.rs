//! What the designer shows: one folder per feature.
//!
//! In a folder, `mod.rs` is the state and does not know [`App`](super::app::App), `commands.rs` is what the designer
//! does with it, and `view.rs` draws it. No other file uses `commands.rs`; the designer calls its methods.

pub mod band;
pub mod beam_view;
pub mod chart;
pub mod comparison;
pub mod dialogs;
pub mod fem_overlay;
pub mod measured;
pub mod modes;
pub mod palette;
pub mod peaks;
pub mod prompt;
pub mod readings;
pub mod search;
pub mod sensitivity;
pub mod status;
pub mod tables;
pub mod tree;
pub mod tuning;

//! The tables below the chart: which one is open, its selected row, and the cursor that follows it.

mod commands;
mod selected;

pub use commands::{Anchor, Table, Tables};

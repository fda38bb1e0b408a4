//! Frequency responses of a thin-walled beam (bending, torsion and warping coupled) that carries any number of
//! three-degree-of-freedom spring-damper-mass subsystems, and a terminal program to tune them.
//!
//! # The map
//!
//! | module | what is in it | may use |
//! | --- | --- | --- |
//! | [`model`] | what the engineer edits: plain types in SI, TOML in and out, rules, parameter paths | nothing |
//! | [`presets`] | the figures of the paper and more, embedded | `model` |
//! | [`solve`] | the exact solver: waves, subsystems, a recursion of reflections | `model` |
//!
//! # What always holds
//!
//! - `model` and `solve` know no terminal, no thread of their own and no clock; `solve` reads a checked model and
//!   nothing else.
//! - Numbers inside are SI. Prefixes exist only where a person reads or types.
//! - Every number of a model is one row of one table (key, symbol, unit, meaning, range); reading, writing, paths and
//!   the designer's tree go by it.
//! - The user-interface thread never solves. What is drawn carries the generation of its model; older curves are dim.
//! - No value that is not finite is drawn or written silently.

pub mod model;
pub mod presets;
pub mod solve;

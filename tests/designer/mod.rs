//! The designer as a user sees it, driven from inside, because its modules are private: keys in, screens out.
#![allow(clippy::expect_used)] // The driver's functions are not tests themselves.

mod analyser;
#[path = "../fuzz/dice.rs"]
#[allow(dead_code)]
mod dice;
pub(crate) mod driver;
#[cfg(unix)]
mod escape;
#[path = "../common/hidden.rs"]
mod hidden;
#[path = "../common/hostile.rs"]
mod hostile;
mod keyboard;
mod looking;
mod looks;
mod readme;
mod screens;
mod sensitivities_shown;
mod tuning_shown;

//! The real binary in a pseudo-terminal, as an engineer uses it, and under every fault that it must survive.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod analyser;
#[path = "../fuzz/dice.rs"]
#[allow(dead_code)]
mod dice;
mod editing;
mod escape;
mod files;
mod harness;
#[path = "../common/hidden.rs"]
mod hidden;
mod home;
mod input;
mod jobs;
mod keyboard;
mod line;
mod looking;
mod looks;
mod panics;
mod pty;
mod random;
mod recovery;
mod screen;
mod signals;
mod thrift;
mod tuning;
mod usage;

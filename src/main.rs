//! Arguments to a call, and its exit code.

use std::process::ExitCode;

fn main() -> ExitCode {
    beamtune::run()
}

//! Any file is a universal file with frequency responses or is refused with a reason.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../curves.rs"]
#[allow(dead_code)]
mod curves;

fuzz_target!(|data: &[u8]| {
    curves::file(data, 0, "run 7.uff");
});

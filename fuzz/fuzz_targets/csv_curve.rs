//! Any file is a table of measured curves or is refused with a reason. The first byte picks what a person says of it.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../curves.rs"]
#[allow(dead_code)]
mod curves;

fuzz_target!(|data: &[u8]| {
    let Some((layout, bytes)) = data.split_first() else {
        return;
    };
    curves::file(bytes, usize::from(*layout), "run 7.csv");
    if let Ok(text) = std::str::from_utf8(bytes) {
        curves::layout(text);
    }
});

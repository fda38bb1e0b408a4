//! Anything typed for a parameter, and any path, is taken or refused. The first nine bytes are a unit and the old
//! value, the rest is what is typed.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../properties.rs"]
#[allow(dead_code)]
mod properties;

fuzz_target!(|data: &[u8]| {
    let Some((unit, rest)) = data.split_first() else {
        return;
    };
    let Some((old, text)) = rest.split_first_chunk() else {
        return;
    };
    let text = String::from_utf8_lossy(text);
    properties::value(usize::from(*unit), f64::from_le_bytes(*old), &text);
});

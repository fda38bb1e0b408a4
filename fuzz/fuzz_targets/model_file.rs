//! Any text is a model file or is refused with reasons.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../properties.rs"]
#[allow(dead_code)]
mod properties;

fuzz_target!(|text: &str| {
    properties::model_file(text);
});

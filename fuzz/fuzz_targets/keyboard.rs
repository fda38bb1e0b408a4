//! Any bytes from a terminal leave it able to hear the next key. The first two bytes are the length of a read and the
//! pause after it, 4 ms each.
#![no_main]

use std::time::Duration;

use libfuzzer_sys::fuzz_target;

#[path = "../keyboard.rs"]
mod keyboard;

fuzz_target!(|data: &[u8]| {
    let Some(([length, pause], bytes)) = data.split_first_chunk() else {
        return;
    };
    let pause = Duration::from_millis(4 * u64::from(*pause));
    keyboard::input(bytes, usize::from(*length), pause);
});

//! Faults on purpose, to rehearse what the program does at one. There are none in a release build.

/// Panics in a debug build where the variable `BEAMTUNE_FAULT` of the environment names this place and the model bears
/// the title `panic now`: a test can thus choose the moment.
pub(crate) fn fault(place: &str, title: &str) {
    let asked = |named: std::ffi::OsString| named == place;
    if cfg!(debug_assertions)
        && title == "panic now"
        && std::env::var_os("BEAMTUNE_FAULT").is_some_and(asked)
    {
        panic!("a rehearsed fault: {place}");
    }
}

//! Fault injection for tests, in debug builds only.

/// Panics in a debug build if the environment variable `BEAMTUNE_FAULT` names this place and the model's title is
/// `panic now`: a test can thus choose the moment.
pub(crate) fn inject(place: &str, title: &str) {
    let is_named = |named: std::ffi::OsString| named == place;
    if cfg!(debug_assertions)
        && title == "panic now"
        && std::env::var_os("BEAMTUNE_FAULT").is_some_and(is_named)
    {
        panic!("injected fault: {place}");
    }
}

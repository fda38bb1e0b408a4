//! The search itself, which knows nothing of beams.

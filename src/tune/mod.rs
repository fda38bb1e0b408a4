//! Parameters sought for what a curve should be: what `[tune]` of a model file asks for, and the search for it.

pub mod search;

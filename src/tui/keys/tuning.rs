//! The rows of the key table for sensitivities and the search for better parameters.

use super::{Binding, Command, Hint, bind, control, key};

/// What matters, and what is sought.
pub(super) const TUNING: &[Binding] = &[
    bind(
        "sensitivities",
        &[key('~')],
        Command::Sensitivities,
        Hint::Table("sensitivities"),
        "which parameter matters: bars and a table for the cursor, then the peak, the mode, the band; again: without",
    ),
    bind(
        "tune-variable",
        &[key('$')],
        Command::TuneVariable,
        Hint::Never,
        "let a search move the selected parameter, within bounds that are typed; again: keep it",
    ),
    bind(
        "tune-objective",
        &[key('^')],
        Command::TuneObjective,
        Hint::Never,
        "say what is sought of the first curve in the marked band, or the one that shows",
    ),
    bind(
        "tune",
        &[control('g')],
        Command::Tune,
        Hint::Never,
        "search; again: pause, go on; a count before it is the most evaluations it may take",
    ),
    bind(
        "tune-accept",
        &[control('y')],
        Command::TuneAccept,
        Hint::Never,
        "put the best found so far into the model, as one step",
    ),
    bind(
        "tune-discard",
        &[control('x')],
        Command::TuneDiscard,
        Hint::Never,
        "drop the search and what it has found",
    ),
    bind(
        "tolerances",
        &[control('k')],
        Command::Tolerances,
        Hint::Never,
        "band in which nine of ten curves lie when the variables are off by their tolerances, or without",
    ),
];

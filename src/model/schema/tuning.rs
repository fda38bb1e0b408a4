//! The tables of a tuning, one row per key: variables, and the kinds of objectives and limits.

use super::{Access, Asked, BLANK, Choice, Key, Kind, Range, Rows, Wording};
use crate::model::tuning::{Aim, Compare, Hold, Limit, Objective, Variable};
use crate::unit::Unit;

rows! {
    /// A variable of a tuning.
    VARIABLE of Variable {
        own("path", Paths, "parameters to change; the bounds apply to the first"),
        word("hold", Hold, "how the others follow the first", hold),
        number("min", "", ONE, Any, "lower bound", min),
        number("max", "", ONE, Any, "upper bound", max),
        own("scale", Scale, "scale of the search"),
        number("tolerance", "", ONE, NonNegative or 0.0, "tolerance of the real value, percent", tolerance),
    }
}

rows! {
    /// The keys of every objective.
    OBJECTIVE of Objective {
        own("response", Response, "name of the response"),
        number("from", "", HERTZ, Positive, "band start", from),
        number("to", "", HERTZ, Positive, "band end", to),
        number("weight", "", ONE, Positive or 1.0, "weight of the figure", weight),
    }
}

rows! {
    NO_KEYS of Aim {}
}
rows! {
    WIDTH of Aim { number_of("below", ONE, Positive, "the level, in the response's unit", Aim::Width, below), }
}
rows! {
    ANTI_RESONANCE of Aim { number_of("at", HERTZ, Positive, "target frequency", Aim::AntiResonance, at), }
}
rows! {
    MATCH of Aim {
        text_of("match", Filled, "a file", Aim::Match, file),
        text_of("curve", Optional, "a curve", Aim::Match, curve),
        text_of("columns", Optional, "the columns, as \"hz; re im; m/N\"", Aim::Match, columns),
        word_of("compare", Compare, "what is compared", Aim::Match, compare),
    }
}

/// `Choice`s of one enum: `variant { its fields } key, word, response, rows, [label, value, whole, figure]`.
macro_rules! choices {
    ($(#[$doc:meta])* $name:ident of $of:ident { $($variant:ident { $($field:ident: $blank:expr),* } $key:literal, $word:literal, $response:ident, $rows:ident, [$label:literal, $value:literal, $whole:literal, $figure:literal];)* }) => {
        $(#[$doc])*
        pub const $name: &[Choice<$of>] = &[$(Choice {
            key: $key,
            word: $word,
            blank: || $of::$variant { $($field: $blank),* },
            response: Asked::$response,
            rows: $rows,
            wording: Wording { label: $label, value: $value, whole: $whole, figure: $figure },
        }),*];
    };
}

choices! {
    /// The aims of objectives.
    AIMS of Aim {
        Peak {} "minimise", "peak", Any, NO_KEYS,
            ["least peak", "{response} {band}", "the least highest peak of {response}, {band}", "highest peak of {response}, {band}"];
        MeanSquare {} "minimise", "mean_square", Any, NO_KEYS,
            ["least mean square", "{response} {band}", "the least mean square of {response}, {band}", "mean square of {response}, {band}"];
        Energy {} "minimise", "energy", Nothing, NO_KEYS,
            ["least energy", "{band}", "the least mean vibration energy of the beam, {band}", "mean vibration energy, {band}"];
        Width { below: f64::NAN } "maximise", "width", Motion, WIDTH,
            ["widest band", "{response} < {below}", "the widest band of {response} below {below}, in {band}", "widest band of {response} below {below}, {band}"];
        AntiResonance { at: f64::NAN } "place", "anti_resonance", Motion, ANTI_RESONANCE,
            ["anti-resonance", "{response} at {at}", "an anti-resonance of {response} at {at}, in {band}", "anti-resonance of {response}, off {at}"];
        Match { file: String::new(), curve: None, columns: None, compare: Compare::LogMagnitude } "match", "", Motion, MATCH,
            ["match", "{response} {match}", "{compare} of {response} as in {match}[ (columns {columns})][, curve {curve}], {band}", "{response} off {match}, {band}"];
    }
}

rows! {
    ADDED_MASS of Limit { number_of("at_most", KILOGRAM, Positive, "upper limit", Limit::AddedMass, at_most), }
}
rows! {
    NO_MODE of Limit {
        number_of("from", HERTZ, NonNegative, "band start", Limit::NoMode, from),
        number_of("to", HERTZ, Positive, "band end", Limit::NoMode, to),
    }
}
rows! {
    PEAK of Limit {
        text_of("response", Response, "name of the response", Limit::Peak, response),
        number_of("at_most", ONE, Positive, "upper limit, in the response's unit", Limit::Peak, at_most),
    }
}
rows! {
    STATIC_DEFLECTION of Limit {
        text_of("response", Response, "name of the response", Limit::StaticDeflection, response),
        number_of("at_most", ONE, Positive, "upper limit, in the response's unit", Limit::StaticDeflection, at_most),
    }
}
rows! {
    BUCKLING of Limit { number_of("at_least", ONE, Positive, "lower limit of the factor", Limit::Buckling, at_least), }
}

choices! {
    /// The limits.
    LIMITS of Limit {
        AddedMass { at_most: f64::NAN } "limit", "added_mass", Nothing, ADDED_MASS,
            ["added mass", "<= {at_most}", "the masses of all enabled subsystems together: at most {at_most}", ""];
        NoMode { from: f64::NAN, to: f64::NAN } "limit", "no_mode", Nothing, NO_MODE,
            ["no mode", "{band}", "no natural frequency, without damping, in {band}", ""];
        Peak { response: String::new(), at_most: f64::NAN } "limit", "peak", Any, PEAK,
            ["peak", "{response} <= {at_most}", "the highest peak of {response} in the sweep: at most {at_most}", ""];
        StaticDeflection { response: String::new(), at_most: f64::NAN } "limit", "static_deflection", Displacement, STATIC_DEFLECTION,
            ["static deflection", "{response} <= {at_most}", "{response} under the forces at rest: at most {at_most}", ""];
        Buckling { at_least: f64::NAN } "limit", "buckling", Nothing, BUCKLING,
            ["buckling", ">= {at_least} x force", "buckling not below {at_least} times the axial compression", ""];
    }
}

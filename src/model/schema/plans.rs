//! The tables of a tuning, a row a key: variables, and what an objective and a limit may be.

use super::{Access, BLANK, Choice, Key, Kind, Range, Rows};
use crate::model::tuning::{Aim, Compare, Hold, Limit, Objective, Variable};
use crate::unit::Unit;

rows! {
    /// A variable of a tuning.
    VARIABLE of Variable {
        own("path", Paths, "what moves; the bounds are of the first"),
        word("hold", Hold, "how the others follow the first", hold),
        number("min", "", ONE, Any, "lower bound", min),
        number("max", "", ONE, Any, "upper bound", max),
        own("scale", Scale, "how it is searched"),
        number("tolerance", "", ONE, NonNegative or 0.0, "how far it may come out off, percent", tolerance),
    }
}

rows! {
    /// What all objectives have.
    OBJECTIVE of Objective {
        number("from", "", HERTZ, Positive, "band start", from),
        number("to", "", HERTZ, Positive, "band end", to),
        number("weight", "", ONE, Positive or 1.0, "what the figure is multiplied by", weight),
    }
}

rows! {
    PEAK of Aim { text_of("response", Response, "of what", Aim::Peak, response), }
}
rows! {
    MEAN_SQUARE of Aim { text_of("response", Response, "of what", Aim::MeanSquare, response), }
}
rows! {
    ENERGY of Aim {}
}
rows! {
    WIDTH of Aim {
        text_of("response", Response, "of what", Aim::Width, response),
        number_of("below", Positive, "the level, in the response's unit", Aim::Width, below),
    }
}
rows! {
    ANTI_RESONANCE of Aim {
        text_of("response", Response, "of what", Aim::AntiResonance, response),
        number_of("at", Positive, "where it is wanted, Hz", Aim::AntiResonance, at),
    }
}
rows! {
    MATCH of Aim {
        text_of("response", Response, "of what", Aim::Match, response),
        text_of("match", Filled, "a file", Aim::Match, file),
        text_of("curve", Optional, "a curve", Aim::Match, curve),
        text_of("columns", Optional, "the columns, as \"hz; re im; m/N\"", Aim::Match, columns),
        word_of("compare", Compare, "what is compared", Aim::Match, compare),
    }
}

/// `Choice`s of one enum: `variant { its fields } key, word, rows`.
macro_rules! choices {
    ($(#[$doc:meta])* $name:ident of $of:ident { $($variant:ident { $($field:ident: $blank:expr),* } $key:literal, $word:literal, $rows:ident;)* }) => {
        $(#[$doc])*
        pub const $name: &[Choice<$of>] = &[$(Choice {
            key: $key,
            word: $word,
            blank: || $of::$variant { $($field: $blank),* },
            rows: $rows,
        }),*];
    };
}

choices! {
    /// What an objective may ask for.
    AIMS of Aim {
        Peak { response: String::new() } "minimise", "peak", PEAK;
        MeanSquare { response: String::new() } "minimise", "mean_square", MEAN_SQUARE;
        Energy {} "minimise", "energy", ENERGY;
        Width { response: String::new(), below: f64::NAN } "maximise", "width", WIDTH;
        AntiResonance { response: String::new(), at: f64::NAN } "place", "anti_resonance", ANTI_RESONANCE;
        Match { response: String::new(), file: String::new(), curve: None, columns: None, compare: Compare::LogMagnitude } "match", "", MATCH;
    }
}

rows! {
    ADDED_MASS of Limit { number_of("at_most", Positive, "kg", Limit::AddedMass, at_most), }
}
rows! {
    NO_MODE of Limit {
        number_of("from", NonNegative, "band start, Hz", Limit::NoMode, from),
        number_of("to", Positive, "band end, Hz", Limit::NoMode, to),
    }
}
rows! {
    STATIC_DEFLECTION of Limit {
        text_of("response", Response, "of what", Limit::StaticDeflection, response),
        number_of("at_most", Positive, "in the response's unit", Limit::StaticDeflection, at_most),
    }
}

choices! {
    /// What may be limited.
    LIMITS of Limit {
        AddedMass { at_most: f64::NAN } "limit", "added_mass", ADDED_MASS;
        NoMode { from: f64::NAN, to: f64::NAN } "limit", "no_mode", NO_MODE;
        StaticDeflection { response: String::new(), at_most: f64::NAN } "limit", "static_deflection", STATIC_DEFLECTION;
    }
}

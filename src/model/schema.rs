//! The schema of the model file: one row for every key, with its symbol, unit, meaning, kind and range.
//!
//! Reading, writing, checking, parameter paths and the designer's tree all go by these rows, so a key is described
//! once. A number that is added here is read, written, checked, described and shown.

use super::tuning::{Aim, Compare, Hold, Limit, Objective, Variable};
use super::types::{
    Beam, BeamMotion, Elastic, Force, Material, Model, Response, Section, Spacing, Study,
    Subsystem, Support, Sweep,
};
use super::unit::Unit;

/// The fewest frequencies of a sweep.
pub const FEWEST_POINTS: usize = 2;
/// The most frequencies of a sweep.
pub const MOST_POINTS: usize = 1_000_000;

/// A key of a table of the model file.
#[derive(Debug)]
pub struct Key {
    /// As it is in the file, below its table; a dot steps into an inner table (`y_left.stiffness`).
    pub key: &'static str,
    /// The symbol of the literature; empty where there is none.
    pub symbol: &'static str,
    /// Unit in which a number is held.
    pub unit: Unit,
    /// What it is, for people.
    pub meaning: &'static str,
    /// What it holds.
    pub kind: Kind,
    /// What a number may be.
    pub range: Range,
    /// A number's value where the file leaves it out; none where it must be given.
    pub default: Option<f64>,
    /// Whether it is a stiffness or damping, whose size matters by its logarithm.
    pub is_spring: bool,
    /// What may be chosen; the first is the default.
    pub words: &'static [&'static str],
}

/// What a key holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number,
    /// A whole number.
    Count,
    /// True or false; true where it is left out.
    Flag,
    /// One of some words.
    Word,
    /// One line of text.
    Line,
    /// Any text; empty where it is left out.
    Text,
    /// A name that is unique in its list.
    Name,
    /// Where a force acts or a response is taken.
    Place,
    /// Along which motion.
    Direction,
    /// Which time derivative of a motion, or the energy.
    Measure,
    /// One word for all motions of an end.
    Support,
    /// What one motion of an end meets.
    Restraint,
    /// The parameters that a variable moves: a path or several.
    Paths,
    /// How a variable is searched; none where it is left out.
    Scale,
    /// The name of a response.
    Response,
    /// A text that is not blank.
    Filled,
    /// The same; none where it is left out.
    Optional,
}

/// What a number may be, beyond being finite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// Any finite number.
    Any,
    /// 0 or more.
    NonNegative,
    /// More than 0.
    Positive,
}

impl Range {
    /// Whether a value lies in the range. NaN passes: a reader has reported it already.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Any => true,
            Self::NonNegative => value >= 0.0 || value.is_nan(),
            Self::Positive => value > 0.0 || value.is_nan(),
        }
    }

    /// The range in words: "any number", ">= 0", "> 0".
    pub const fn words(self) -> &'static str {
        match self {
            Self::Any => "any number",
            Self::NonNegative => ">= 0",
            Self::Positive => "> 0",
        }
    }
}

/// How the value of a key is read from and written to its owner, unchecked.
#[derive(Debug)]
pub enum Access<T> {
    /// A number.
    Number(fn(&T) -> f64, fn(&mut T, f64)),
    /// A whole number.
    Count(fn(&T) -> usize, fn(&mut T, usize)),
    /// A switch.
    Flag(fn(&T) -> bool, fn(&mut T, bool)),
    /// The index of a word.
    Word(fn(&T) -> usize, fn(&mut T, usize)),
    /// A text.
    Text(fn(&T) -> &String, fn(&mut T) -> &mut String),
    /// A text that is not always there.
    Optional(fn(&T) -> Option<&String>, fn(&mut T, Option<String>)),
    /// By rules of its own.
    Own,
}

/// What a table is, by one word, with the keys that go with it.
#[derive(Debug)]
pub struct Choice<T: 'static> {
    /// The key of the word.
    pub key: &'static str,
    /// The word; empty where any text may follow the key.
    pub word: &'static str,
    /// What it is before its keys are read.
    pub blank: fn() -> T,
    /// Its keys.
    pub rows: Rows<T>,
}

impl<T> Choice<T> {
    /// The one of some that a value is.
    pub fn of<'a>(all: &'a [Self], value: &T) -> Option<&'a Self> {
        let kind = std::mem::discriminant(value);
        all.iter()
            .find(|one| std::mem::discriminant(&(one.blank)()) == kind)
    }

    /// Whether a key goes with it.
    pub fn has(&self, key: &str) -> bool {
        self.rows.keys.iter().any(|own| own.key == key)
    }
}

/// The keys of a table of the file, with the access to them.
#[derive(Debug)]
pub struct Rows<T: 'static> {
    /// The keys, in the order of the file.
    pub keys: &'static [Key],
    /// The access to each of them.
    pub access: &'static [Access<T>],
}

impl<T> Rows<T> {
    /// Every key with its access.
    pub fn iter(&self) -> impl Iterator<Item = (&'static Key, &'static Access<T>)> + use<T> {
        self.keys.iter().zip(self.access)
    }

    /// The keys of numbers, with their values.
    pub fn numbers(&self, of: &T) -> impl Iterator<Item = (&'static Key, f64)> {
        self.iter().filter_map(move |(key, access)| match access {
            Access::Number(get, _) => Some((key, get(of))),
            _ => None,
        })
    }
}

/// A key of no kind in particular.
const BLANK: Key = Key {
    key: "",
    symbol: "",
    unit: Unit::ONE,
    meaning: "",
    kind: Kind::Text,
    range: Range::Any,
    default: None,
    is_spring: false,
    words: &[],
};

/// The description of a row of [`rows!`].
macro_rules! key {
    (number $key:literal, $symbol:literal, $unit:ident, $range:ident $(or $default:literal)?, $meaning:literal, $($place:ident).+) => {
        Key { key: $key, symbol: $symbol, unit: Unit::$unit, meaning: $meaning, kind: Kind::Number, range: Range::$range, default: [$(Some($default),)? None][0], ..BLANK }
    };
    (spring $key:literal, $symbol:literal, $unit:ident, $meaning:literal, $($place:ident).+) => {
        Key { is_spring: true, ..key!(number $key, $symbol, $unit, NonNegative or 0.0, $meaning, $($place).+) }
    };
    (number_of $key:literal, $range:ident, $meaning:literal, $of:path, $field:ident) => {
        Key { key: $key, meaning: $meaning, kind: Kind::Number, range: Range::$range, ..BLANK }
    };
    (word_of $key:literal, $words:ident, $meaning:literal, $of:path, $field:ident) => {
        key!(word $key, $words, $meaning, $field)
    };
    (text_of $key:literal, $kind:ident, $meaning:literal, $of:path, $field:ident) => {
        Key { key: $key, meaning: $meaning, kind: Kind::$kind, ..BLANK }
    };
    (word $key:literal, $words:ident, $meaning:literal, $place:ident) => {
        Key { key: $key, meaning: $meaning, kind: Kind::Word, words: $words::WORDS, ..BLANK }
    };
    ($access:ident $key:literal, $kind:ident, $meaning:expr $(, $place:ident)?) => {
        Key { key: $key, meaning: $meaning, kind: Kind::$kind, ..BLANK }
    };
}

/// The access of a row of [`rows!`].
macro_rules! access {
    (number $key:literal, $symbol:literal, $unit:ident, $range:ident $(or $default:literal)?, $meaning:literal, $($place:ident).+) => {
        Access::Number(|of| of.$($place).+, |of, value| of.$($place).+ = value)
    };
    (spring $key:literal, $symbol:literal, $unit:ident, $meaning:literal, $($place:ident).+) => {
        access!(number $key, $symbol, $unit, NonNegative or 0.0, $meaning, $($place).+)
    };
    (number_of $key:literal, $range:ident, $meaning:literal, $of:path, $field:ident) => {
        Access::Number(
            |of| if let $of { $field, .. } = of { *$field } else { f64::NAN },
            |of, value| if let $of { $field, .. } = of { *$field = value },
        )
    };
    (word_of $key:literal, $words:ident, $meaning:literal, $of:path, $field:ident) => {
        Access::Word(
            |of| if let $of { $field, .. } = of { *$field as usize } else { 0 },
            |of, index| if let $of { $field, .. } = of { *$field = $words::ALL[index] },
        )
    };
    (text_of $key:literal, Optional, $meaning:literal, $of:path, $field:ident) => {
        Access::Optional(
            |of| if let $of { $field, .. } = of { $field.as_ref() } else { None },
            |of, text| if let $of { $field, .. } = of { *$field = text },
        )
    };
    (text_of $key:literal, $kind:ident, $meaning:literal, $of:path, $field:ident) => {
        Access::Optional(
            |of| if let $of { $field, .. } = of { Some($field) } else { None },
            |of, text| if let $of { $field, .. } = of { *$field = text.unwrap_or_default() },
        )
    };
    (word $key:literal, $words:ident, $meaning:literal, $place:ident) => {
        Access::Word(|of| of.$place as usize, |of, index| of.$place = $words::ALL[index])
    };
    (count $key:literal, $kind:ident, $meaning:literal, $place:ident) => {
        Access::Count(|of| of.$place, |of, count| of.$place = count)
    };
    (flag $key:literal, $kind:ident, $meaning:literal, $place:ident) => {
        Access::Flag(|of| of.$place, |of, flag| of.$place = flag)
    };
    (text $key:literal, $kind:ident, $meaning:literal, $place:ident) => {
        Access::Text(|of| &of.$place, |of| &mut of.$place)
    };
    (own $key:literal, $kind:ident, $meaning:expr) => { Access::Own };
}

/// `TABLE of Struct { kind(key, ..), .. }`; with `as Enum` the rows have names: `Name = kind(key, ..)`.
///
/// - `number(key, symbol, unit, range [or default], meaning, place in the struct)`
/// - `spring(key, symbol, unit, meaning, place in the struct)`: a stiffness or damping, 0 or more, 0 where it is left out
/// - `word(key, type of the words, meaning, place)`
/// - `number_of(key, range, ..)`, `word_of(key, words, ..)`, `text_of(key, kind, ..)`: meaning, variant, field of an enum
/// - `count`, `flag` or `text(key, kind, meaning, place)`, `own(key, kind, meaning)`
macro_rules! rows {
    ($(#[$doc:meta])* $name:ident of $of:ty { $($kind:ident($($row:tt)*),)* }) => {
        $(#[$doc])*
        #[allow(missing_docs)]
        pub const $name: Rows<$of> = Rows { keys: &[$(key!($kind $($row)*)),*], access: &[$(access!($kind $($row)*)),*] };
    };
    ($(#[$doc:meta])* $name:ident of $of:ty as $names:ident { $($row_name:ident = $kind:ident($($row:tt)*),)* }) => {
        rows! { $(#[$doc])* $name of $of { $($kind($($row)*),)* } }
        #[doc = concat!("The names of the rows of [`", stringify!($name), "`].")]
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[allow(missing_docs)]
        pub enum $names { $($row_name),* }
        impl $names {
            /// All of them, in the order of the rows.
            pub const ALL: [Self; $name.keys.len()] = [$(Self::$row_name),*];
        }
    };
}

rows! {
    /// What stands above all tables.
    MODEL of Model {
        text("title", Line, "one line for people", title),
        text("notes", Text, "notes", notes),
    }
}

rows! {
    /// The beam itself.
    BEAM of Beam as BeamKey {
        Length = number("length", "L", METRE, Positive, "length of the beam", length),
    }
}

rows! {
    /// The material.
    MATERIAL of Material as MaterialKey {
        YoungModulus = number("young_modulus", "E", PASCAL, Positive, "Young's modulus", young_modulus),
        ShearModulus = number("shear_modulus", "G", PASCAL, Positive, "shear modulus", shear_modulus),
        Density = number("density", "rho", DENSITY, Positive, "density", density),
        LossFactor = number("loss_factor", "eta", ONE, NonNegative or 0.0, "hysteretic loss factor of E and G", loss_factor),
    }
}

rows! {
    /// The section.
    SECTION of Section as SectionKey {
        Area = number("area", "A", AREA, Positive, "area of the section", area),
        SecondMomentY = number("second_moment_y", "I_y", METRE_4, Positive, "second moment of area, bending of w (along y)", second_moment_y),
        SecondMomentZ = number("second_moment_z", "I_z", METRE_4, Positive, "second moment of area, bending of v (along z)", second_moment_z),
        TorsionConstant = number("torsion_constant", "J", METRE_4, NonNegative, "Saint-Venant torsion constant", torsion_constant),
        WarpingConstant = number("warping_constant", "Gamma_0", METRE_6, NonNegative, "warping constant; 0: no warping stiffness", warping_constant),
        PolarMoment = number("polar_moment", "I_0", METRE_4, Positive, "polar moment of area about the shear centre, > A z_c^2", polar_moment),
        CentroidOffset = number("centroid_offset", "z_c", METRE, Any, "offset of the centroid from the shear centre", centroid_offset),
    }
}

rows! {
    /// An end: one word for it, then its motions in the order of [`BeamMotion::ALL`].
    SUPPORT of Support {
        own("kind", Support, "what holds the end; elastic: see its motions"),
        own("w", Restraint, "what holds w, the displacement along y"),
        own("psi", Restraint, "what holds psi, the twist about x"),
        own("v", Restraint, "what holds v, the displacement along z"),
        own("w_slope", Restraint, "what holds the slope of w"),
        own("psi_slope", Restraint, "what holds the rate of twist; fixed: warping restrained"),
        own("v_slope", Restraint, "what holds the slope of v"),
    }
}

rows! {
    /// The elastic restraint of w or v.
    ELASTIC_TRANSLATION of Elastic as ElasticKey {
        Stiffness = spring("stiffness", "K", STIFFNESS, "spring to the ground", stiffness),
        Damping = spring("damping", "C", DAMPING, "damper to the ground", damping),
        Inertia = number("mass", "m", KILOGRAM, NonNegative or 0.0, "mass at the end", inertia),
    }
}

rows! {
    /// The elastic restraint of a motion about an axis: psi and the slopes of w and v.
    ELASTIC_ROTATION of Elastic {
        spring("stiffness", "K_T", ROTATIONAL_STIFFNESS, "rotational spring to the ground", stiffness),
        spring("damping", "C_T", ROTATIONAL_DAMPING, "rotational damper to the ground", damping),
        number("inertia", "I", INERTIA, NonNegative or 0.0, "moment of inertia at the end", inertia),
    }
}

rows! {
    /// The elastic restraint of the rate of twist, against warping.
    ELASTIC_WARPING of Elastic {
        spring("stiffness", "K_B", WARPING_STIFFNESS, "spring against warping", stiffness),
        spring("damping", "C_B", WARPING_DAMPING, "damper against warping", damping),
        number("inertia", "I_B", WARPING_INERTIA, NonNegative or 0.0, "inertia against warping", inertia),
    }
}

/// The elastic restraint of a motion.
pub const fn elastic(motion: BeamMotion) -> &'static Rows<Elastic> {
    match motion {
        BeamMotion::W | BeamMotion::V => &ELASTIC_TRANSLATION,
        BeamMotion::Psi | BeamMotion::WSlope | BeamMotion::VSlope => &ELASTIC_ROTATION,
        BeamMotion::PsiSlope => &ELASTIC_WARPING,
    }
}

rows! {
    /// A subsystem.
    SUBSYSTEM of Subsystem as SubsystemKey {
        Name = text("name", Name, "name of the subsystem", name),
        Enabled = flag("enabled", Flag, "whether it is attached", enabled),
        Position = number("position", "x", METRE, NonNegative, "distance from the left end, 0 to the beam's length", position),
        Mass = number("mass", "m", KILOGRAM, Positive, "mass", mass),
        Inertia = number("inertia", "J", INERTIA, NonNegative or 0.0, "moment of inertia about its own centre", inertia),
        YLeftStiffness = spring("y_left.stiffness", "k_yL", STIFFNESS, "left spring along y", y_left.stiffness),
        YLeftDamping = spring("y_left.damping", "c_yL", DAMPING, "left damper along y", y_left.damping),
        YRightStiffness = spring("y_right.stiffness", "k_yR", STIFFNESS, "right spring along y", y_right.stiffness),
        YRightDamping = spring("y_right.damping", "c_yR", DAMPING, "right damper along y", y_right.damping),
        ZLeftStiffness = spring("z_left.stiffness", "k_zL", STIFFNESS, "left spring along z", z_left.stiffness),
        ZLeftDamping = spring("z_left.damping", "c_zL", DAMPING, "left damper along z", z_left.damping),
        ZRightStiffness = spring("z_right.stiffness", "k_zR", STIFFNESS, "right spring along z", z_right.stiffness),
        ZRightDamping = spring("z_right.damping", "c_zR", DAMPING, "right damper along z", z_right.damping),
        ArmLeft = number("arm_left", "l_L", METRE, Any or 0.0, "arm of the left z spring at the mass", arm_left),
        ArmRight = number("arm_right", "l_R", METRE, Any or 0.0, "arm of the right z spring at the mass", arm_right),
        MountY = number("mount_y", "y_u", METRE, Any or 0.0, "half-spacing of the z springs at the beam", mount_y),
        MountZ = number("mount_z", "z_b", METRE, Any or 0.0, "height of the y springs at the beam, from the shear centre", mount_z),
    }
}

rows! {
    /// A force; the unit of the amplitude is that of a translation's load.
    FORCE of Force as ForceKey {
        Enabled = flag("enabled", Flag, "whether it acts", enabled),
        At = own("at", Place, "where on the beam, or which subsystem"),
        Direction = own("direction", Direction, "along what it acts"),
        Amplitude = number("amplitude", "F", FORCE, Any or 1.0, "amplitude, zero to peak", amplitude),
        Phase = number("phase", "phi", DEGREE, Any or 0.0, "phase", phase),
    }
}

rows! {
    /// A response.
    RESPONSE of Response {
        text("name", Name, "name of the response", name),
        flag("enabled", Flag, "whether it is computed", enabled),
        own("measure", Measure, "what is computed"),
        own("at", Place, "where on the beam, or which subsystem"),
        own("direction", Direction, "which motion"),
    }
}

rows! {
    /// The frequencies.
    SWEEP of Sweep {
        number("from", "f_1", HERTZ, Positive, "first frequency", from),
        number("to", "f_2", HERTZ, Positive, "last frequency", to),
        count("points", Count, "number of frequencies, both ends included", points),
        word("spacing", Spacing, "how the frequencies are spread", spacing),
    }
}

rows! {
    /// What all studies have.
    STUDY of Study {
        text("name", Name, "name of the study", name),
    }
}

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

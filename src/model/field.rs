//! The table of numbers: one row for every number of a model, with its key, symbol, unit, meaning and range.
//!
//! Reading, checking, writing, parameter paths and the designer's tree all go by these rows, so a number is
//! described once.

use super::types::{Beam, BeamMotion, Elastic, Force, Material, Section, Subsystem, Sweep};
use super::unit::Unit;

/// One number of a `T`.
#[derive(Debug)]
pub struct Field<T: 'static> {
    /// Key in the file below the table of `T`; a dot steps into an inner table (`y_left.stiffness`).
    pub key: &'static str,
    /// The symbol of the literature.
    pub symbol: &'static str,
    /// Unit in which the number is held.
    pub unit: Unit,
    /// What it is, for people.
    pub meaning: &'static str,
    /// What it may be.
    pub range: Range,
    /// Its value where the file leaves it out; none where it must be given.
    pub default: Option<f64>,
    /// Reads it.
    pub get: fn(&T) -> f64,
    /// Writes it, unchecked.
    pub set: fn(&mut T, f64),
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
    /// Whether a value lies in the range. NaN passes: a reader has spoken of it already.
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

/// A row: `field!(key, symbol, unit, range, default, meaning, place in the struct)`.
macro_rules! field {
    ($key:literal, $symbol:literal, $unit:ident, $range:ident, $default:expr, $meaning:literal, $($place:ident).+) => {
        Field {
            key: $key,
            symbol: $symbol,
            unit: Unit::$unit,
            meaning: $meaning,
            range: Range::$range,
            default: $default,
            get: |of| of.$($place).+,
            set: |of, value| of.$($place).+ = value,
        }
    };
}

/// The beam's own number.
pub const BEAM: &[Field<Beam>] = &[field!(
    "length",
    "L",
    METRE,
    Positive,
    None,
    "length of the beam",
    length
)];

/// The material's numbers.
pub const MATERIAL: &[Field<Material>] = &[
    field!(
        "young_modulus",
        "E",
        PASCAL,
        Positive,
        None,
        "Young's modulus",
        young_modulus
    ),
    field!(
        "shear_modulus",
        "G",
        PASCAL,
        Positive,
        None,
        "shear modulus",
        shear_modulus
    ),
    field!(
        "density", "rho", DENSITY, Positive, None, "density", density
    ),
    field!(
        "loss_factor",
        "eta",
        ONE,
        NonNegative,
        Some(0.0),
        "hysteretic loss factor of E and G",
        loss_factor
    ),
];

/// The section's numbers.
pub const SECTION: &[Field<Section>] = &[
    field!(
        "area",
        "A",
        AREA,
        Positive,
        None,
        "area of the section",
        area
    ),
    field!(
        "second_moment_y",
        "I_y",
        METRE_4,
        Positive,
        None,
        "second moment of area, bending of w (along y)",
        second_moment_y
    ),
    field!(
        "second_moment_z",
        "I_z",
        METRE_4,
        Positive,
        None,
        "second moment of area, bending of v (along z)",
        second_moment_z
    ),
    field!(
        "torsion_constant",
        "J",
        METRE_4,
        NonNegative,
        None,
        "Saint-Venant torsion constant",
        torsion_constant
    ),
    field!(
        "warping_constant",
        "Gamma_0",
        METRE_6,
        NonNegative,
        None,
        "warping constant; 0: no warping stiffness",
        warping_constant
    ),
    field!(
        "polar_moment",
        "I_0",
        METRE_4,
        Positive,
        None,
        "polar moment of area about the shear centre, > A z_c^2",
        polar_moment
    ),
    field!(
        "centroid_offset",
        "z_c",
        METRE,
        Any,
        None,
        "offset of the centroid from the shear centre",
        centroid_offset
    ),
];

/// The numbers of a subsystem.
pub const SUBSYSTEM: &[Field<Subsystem>] = &[
    field!(
        "position",
        "x",
        METRE,
        NonNegative,
        None,
        "distance from the left end, 0 to the beam's length",
        position
    ),
    field!("mass", "m", KILOGRAM, Positive, None, "mass", mass),
    field!(
        "inertia",
        "J",
        INERTIA,
        NonNegative,
        None,
        "moment of inertia about its own centre",
        inertia
    ),
    field!(
        "y_left.stiffness",
        "k_yL",
        STIFFNESS,
        NonNegative,
        Some(0.0),
        "left spring along y",
        y_left.stiffness
    ),
    field!(
        "y_left.damping",
        "c_yL",
        DAMPING,
        NonNegative,
        Some(0.0),
        "left damper along y",
        y_left.damping
    ),
    field!(
        "y_right.stiffness",
        "k_yR",
        STIFFNESS,
        NonNegative,
        Some(0.0),
        "right spring along y",
        y_right.stiffness
    ),
    field!(
        "y_right.damping",
        "c_yR",
        DAMPING,
        NonNegative,
        Some(0.0),
        "right damper along y",
        y_right.damping
    ),
    field!(
        "z_left.stiffness",
        "k_zL",
        STIFFNESS,
        NonNegative,
        Some(0.0),
        "left spring along z",
        z_left.stiffness
    ),
    field!(
        "z_left.damping",
        "c_zL",
        DAMPING,
        NonNegative,
        Some(0.0),
        "left damper along z",
        z_left.damping
    ),
    field!(
        "z_right.stiffness",
        "k_zR",
        STIFFNESS,
        NonNegative,
        Some(0.0),
        "right spring along z",
        z_right.stiffness
    ),
    field!(
        "z_right.damping",
        "c_zR",
        DAMPING,
        NonNegative,
        Some(0.0),
        "right damper along z",
        z_right.damping
    ),
    field!(
        "arm_left",
        "l_L",
        METRE,
        Any,
        None,
        "arm of the left z spring at the mass",
        arm_left
    ),
    field!(
        "arm_right",
        "l_R",
        METRE,
        Any,
        None,
        "arm of the right z spring at the mass",
        arm_right
    ),
    field!(
        "mount_y",
        "y_u",
        METRE,
        Any,
        None,
        "half-spacing of the z springs at the beam",
        mount_y
    ),
    field!(
        "mount_z",
        "z_b",
        METRE,
        Any,
        None,
        "height of the y springs at the beam, from the shear centre",
        mount_z
    ),
];

/// The numbers of an elastic restraint along w or v.
const ELASTIC_TRANSLATION: &[Field<Elastic>] = &[
    field!(
        "stiffness",
        "K",
        STIFFNESS,
        NonNegative,
        Some(0.0),
        "spring to the ground",
        stiffness
    ),
    field!(
        "damping",
        "C",
        DAMPING,
        NonNegative,
        Some(0.0),
        "damper to the ground",
        damping
    ),
    field!(
        "mass",
        "m",
        KILOGRAM,
        NonNegative,
        Some(0.0),
        "mass at the end",
        inertia
    ),
];

/// The numbers of an elastic restraint about an axis: psi and the slopes of w and v.
const ELASTIC_ROTATION: &[Field<Elastic>] = &[
    field!(
        "stiffness",
        "K_T",
        ROTATIONAL_STIFFNESS,
        NonNegative,
        Some(0.0),
        "rotational spring to the ground",
        stiffness
    ),
    field!(
        "damping",
        "C_T",
        ROTATIONAL_DAMPING,
        NonNegative,
        Some(0.0),
        "rotational damper to the ground",
        damping
    ),
    field!(
        "inertia",
        "I",
        INERTIA,
        NonNegative,
        Some(0.0),
        "moment of inertia at the end",
        inertia
    ),
];

/// The numbers of an elastic restraint on the rate of twist, against warping.
const ELASTIC_WARPING: &[Field<Elastic>] = &[
    field!(
        "stiffness",
        "K_B",
        WARPING_STIFFNESS,
        NonNegative,
        Some(0.0),
        "spring against warping",
        stiffness
    ),
    field!(
        "damping",
        "C_B",
        WARPING_DAMPING,
        NonNegative,
        Some(0.0),
        "damper against warping",
        damping
    ),
    field!(
        "inertia",
        "I_B",
        WARPING_INERTIA,
        NonNegative,
        Some(0.0),
        "inertia against warping",
        inertia
    ),
];

/// The numbers of the elastic restraint of a motion.
pub const fn elastic_fields(motion: BeamMotion) -> &'static [Field<Elastic>] {
    match motion {
        BeamMotion::W | BeamMotion::V => ELASTIC_TRANSLATION,
        BeamMotion::Psi | BeamMotion::WSlope | BeamMotion::VSlope => ELASTIC_ROTATION,
        BeamMotion::PsiSlope => ELASTIC_WARPING,
    }
}

/// The numbers of a force; the unit of the amplitude is that of a translation's load.
pub const FORCE: &[Field<Force>] = &[
    field!(
        "amplitude",
        "F",
        FORCE,
        Any,
        Some(1.0),
        "amplitude, zero to peak",
        amplitude
    ),
    field!("phase", "phi", DEGREE, Any, Some(0.0), "phase", phase),
];

/// The sweep's numbers; its point count is a whole number and stands apart.
pub const SWEEP: &[Field<Sweep>] = &[
    field!(
        "from",
        "f_1",
        HERTZ,
        Positive,
        None,
        "first frequency",
        from
    ),
    field!("to", "f_2", HERTZ, Positive, None, "last frequency", to),
];

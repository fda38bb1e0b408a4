//! Natural frequencies, damped modes and mode shapes as data.

use num_complex::Complex64;

/// The modes of a model up to a frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Modes {
    /// Upper end of the search, Hz: modes with |omega| up to 2 pi times it.
    pub to: f64,
    /// Number of undamped modes below `to`, rigid-body modes included (Wittrick & Williams 1971).
    pub undamped: usize,
    /// Number of buckled modes: they grow without oscillating, and are not in the list.
    pub unstable: usize,
    /// The modes with damping, by ascending |omega|.
    pub modes: Vec<Mode>,
    /// Some modes beyond `to`: a change of the model may move them into the range.
    pub beyond: Vec<Mode>,
    /// Whether the damped list is proven to be complete.
    pub completeness: Completeness,
}

/// A root of the damped system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    /// Complex angular frequency, rad/s: Re >= 0; Im > 0 decays.
    pub omega: Complex64,
    /// The kind of the motion.
    pub kind: ModeKind,
}

/// The kind of the motion of a mode.
///
/// Without a loss factor the roots omega are symmetric about the imaginary axis, and those on it creep. A loss factor
/// means a hysteretic stiffness `E (1 + i eta)` for Re omega > 0 and its conjugate for Re omega < 0: a mode is then a
/// root with Re omega >= 0, and an overdamped one is on the axis itself (if the beam does not move in it). A root that
/// the loss factor moves to the right of the axis is listed with a damping ratio near 1; one that it moves to the left
/// is not a root of that half-plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModeKind {
    /// No restoring force: 0 Hz.
    RigidBody,
    /// It oscillates, decaying or not.
    Oscillating,
    /// It creeps back without oscillating: damping ratio 1.
    Overdamped,
}

/// Whether a list of damped modes is proven to be complete.
#[derive(Debug, Clone, PartialEq)]
pub enum Completeness {
    /// Every mode of the list is proven, and the argument principle counts no other.
    Certain,
    /// Complete except in some ranges of frequency, by ascending frequency.
    Open(Vec<Gap>),
    /// Every mode of the list is proven, but not yet counted: some may be missing anywhere.
    Uncounted,
    /// No search: there are more than [`MOST_MODES`](super::MOST_MODES).
    TooMany,
}

impl Modes {
    /// The modes up to 0 Hz: an empty list.
    pub const fn none() -> Self {
        Self {
            to: 0.0,
            undamped: 0,
            unstable: 0,
            modes: Vec::new(),
            beyond: Vec::new(),
            completeness: Completeness::Uncounted,
        }
    }

    /// The modes of a model with more than [`MOST_MODES`](super::MOST_MODES) up to a frequency, Hz: an empty list.
    pub fn too_many(to: f64) -> Self {
        Self {
            to,
            undamped: usize::MAX,
            unstable: 0,
            modes: Vec::new(),
            beyond: Vec::new(),
            completeness: Completeness::TooMany,
        }
    }

    /// Whether the list is empty because there are too many.
    pub fn are_too_many(&self) -> bool {
        self.completeness == Completeness::TooMany
    }

    /// Whether two lists have the same modes to the last digit, for any completeness.
    pub fn has_modes_of(&self, other: &Self) -> bool {
        self.modes == other.modes && self.beyond == other.beyond
    }
}

/// A range of frequencies in which a list may be incomplete.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Hz, |omega| / 2 pi.
    pub from: f64,
    /// Hz.
    pub to: f64,
    /// Number of modes of the list in it.
    pub found: usize,
    /// Number of modes by the argument principle; `None` if rounding hides it, or the work limit is reached.
    pub counted: Option<usize>,
}

impl std::fmt::Display for Gap {
    /// "between 1590 and 1610 Hz: 3 counted, 2 found".
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            from,
            to,
            found,
            counted,
        } = self;
        write!(f, "between {} and {} Hz: ", digits(*from), digits(*to))?;
        match counted {
            Some(counted) => write!(f, "{counted} counted, {found} found"),
            None => write!(f, "not counted, {found} found"),
        }
    }
}

/// As many digits as needed to find the range.
fn digits(hertz: f64) -> f64 {
    const PLACES: i32 = 4;
    if hertz == 0.0 || !hertz.is_finite() {
        return hertz;
    }
    let unit = 10.0_f64.powi(PLACES - 1 - hertz.abs().log10().floor() as i32);
    (hertz * unit).round() / unit
}

impl Mode {
    /// |omega| / 2 pi, Hz.
    pub fn frequency(&self) -> f64 {
        self.omega.norm() / std::f64::consts::TAU
    }

    /// Im omega / |omega|; 0 for a rigid-body mode.
    pub fn damping_ratio(&self) -> f64 {
        match self.kind {
            ModeKind::RigidBody => 0.0,
            ModeKind::Oscillating => self.omega.im / self.omega.norm(),
            ModeKind::Overdamped => 1.0,
        }
    }
}

/// A mode shape.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Positions along the beam, m, ascending, from 0 to the length.
    pub positions: Vec<f64>,
    /// w at each position, m.
    pub w: Vec<Complex64>,
    /// psi at each position, rad.
    pub psi: Vec<Complex64>,
    /// v at each position, m.
    pub v: Vec<Complex64>,
    /// Motion (y, z, theta) of each enabled subsystem's mass, in the model's order, m and rad.
    pub masses: Vec<[Complex64; 3]>,
    /// The shares of the kinetic energy.
    pub shares: Shares,
}

/// Shares of a mode's kinetic energy, with the sum 1. The beam's consists of the translation of its centroid and the
/// rotation about it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shares {
    /// Bending along y: of the centroid, w + `z_c` psi.
    pub bending_y: f64,
    /// Bending along z (v).
    pub bending_z: f64,
    /// Twist: psi about the centroid.
    pub twist: f64,
    /// The masses of the subsystems.
    pub subsystems: f64,
    /// The masses and inertias of the supports.
    pub supports: f64,
}

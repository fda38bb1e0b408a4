//! The beam as plain data: its section, material and foundation, the spans of which it may consist, and how it moves.

use crate::unit::Load;
use crate::words::words;

/// The beam, or what its spans have in common.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Beam {
    /// Length L, m; 0 where there are spans, whose lengths add up: see [`Model::length`](super::Model::length).
    pub length: f64,
    /// Theory of bending.
    pub theory: Theory,
    /// Whether warping has inertia: rho `Gamma_0` on psi'.
    pub warping_inertia: bool,
    /// Axial force N along the centroids, N; tension > 0.
    pub axial_force: f64,
    /// Its material.
    pub material: Material,
    /// Its cross-section.
    pub section: Section,
    /// What it lies on, along its whole length.
    pub foundation: Foundation,
}

/// A uniform part of the beam with its own length. What it leaves out it has from the beam.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Span {
    /// m.
    pub length: f64,
    /// Where its shear centre lies, from the axis of the beam.
    pub offset: Point,
    /// N; tension > 0.
    pub axial_force: Option<f64>,
    /// In place of the beam's material.
    pub material: Option<Material>,
    /// In place of the beam's section.
    pub section: Option<Section>,
    /// In place of the beam's foundation.
    pub foundation: Option<Foundation>,
}

impl Span {
    /// The words for whose material, section or foundation it has: the beam's or its own.
    pub const OWNERS: [&'static str; 2] = ["beam", "own"];

    /// It as a uniform beam.
    pub(crate) fn beam(&self, whole: &Beam) -> Beam {
        Beam {
            length: self.length,
            axial_force: self.axial_force.unwrap_or(whole.axial_force),
            material: self.material.unwrap_or(whole.material),
            section: self.section.unwrap_or(whole.section),
            foundation: self.foundation.unwrap_or(whole.foundation),
            ..*whole
        }
    }
}

/// A uniform part of a beam, with all of its own numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct UniformPart {
    /// Distance of its ends from the left end of the beam, m.
    pub(crate) start: f64,
    pub(crate) end: f64,
    /// It, as a beam of its own.
    pub(crate) beam: Beam,
    /// Where its shear centre lies, from the axis of the beam.
    pub(crate) offset: Point,
}

impl UniformPart {
    /// All of a uniform beam.
    pub(crate) fn whole(beam: Beam) -> Self {
        Self {
            start: 0.0,
            end: beam.length,
            beam,
            offset: Point::AXIS,
        }
    }

    /// The part of a beam that holds what is at a distance from its left end, m.
    pub(crate) fn at(parts: &[Self], x: f64) -> &Self {
        &parts[Self::index_at(parts, x)]
    }

    /// The index of that part: where two meet that with warping stiffness, the left one if both have it.
    pub(crate) fn index_at(parts: &[Self], x: f64) -> usize {
        let last = parts.len() - 1;
        let part = parts[..last].partition_point(|part| part.end < x);
        let is_passed = part < last && parts[part].end == x && !parts[part].warps();
        part + usize::from(is_passed)
    }

    /// Whether a bimoment passes a distance from the left end, m: all parts there have warping stiffness.
    pub(crate) fn transmit_bimoment(parts: &[Self], x: f64) -> bool {
        let mut here = parts
            .iter()
            .filter(|part| (part.start..=part.end).contains(&x));
        here.all(Self::warps)
    }

    /// Whether it has warping stiffness.
    pub(crate) fn warps(&self) -> bool {
        self.beam.section.warping_constant != 0.0
    }

    /// Whether v is coupled with w or twist.
    pub(crate) fn couples_all(&self) -> bool {
        !self.beam.is_of_one_offset() || self.offset.y != 0.0
    }

    /// kg.
    pub(crate) fn mass(&self) -> f64 {
        let Beam {
            material, section, ..
        } = &self.beam;
        material.density * section.area * self.beam.length
    }
}

/// A foundation of springs and dampers along the beam, at its axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Foundation {
    /// On w, per length: N/m2, N s/m2.
    pub w: Bedding,
    /// On psi, per length: N, N s.
    pub psi: Bedding,
    /// On v, per length: N/m2, N s/m2.
    pub v: Bedding,
}

/// A spring and a damper per length, `k (1 + i eta) + i omega c`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Bedding {
    /// k.
    pub stiffness: f64,
    /// c.
    pub damping: f64,
    /// Loss factor eta of the stiffness.
    pub loss_factor: f64,
}

impl Foundation {
    /// Those of w, psi and v.
    pub(crate) fn beddings(&self) -> [Bedding; 3] {
        [self.w, self.psi, self.v]
    }
}

words! {
    /// Theories of bending.
    #[derive(Default)]
    pub enum Theory {
        /// Bernoulli and Euler: neither rotary inertia nor shear deformation.
        #[default]
        EulerBernoulli = "euler_bernoulli",
        /// Rayleigh: with the rotary inertia of the section.
        Rayleigh = "rayleigh",
        /// With shear deformation alone.
        Shear = "shear",
        /// Timoshenko: with both.
        Timoshenko = "timoshenko",
    }
}

impl Theory {
    /// Whether sections shear.
    pub const fn has_shear(self) -> bool {
        matches!(self, Self::Shear | Self::Timoshenko)
    }

    /// Whether the rotation of a section has inertia.
    pub const fn has_rotary_inertia(self) -> bool {
        matches!(self, Self::Rayleigh | Self::Timoshenko)
    }
}

/// An isotropic material with hysteretic damping.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Material {
    /// Young's modulus E, Pa.
    pub young_modulus: f64,
    /// Shear modulus G, Pa.
    pub shear_modulus: f64,
    /// Density rho, kg/m3.
    pub density: f64,
    /// Loss factor eta: E and G are multiplied by (1 + i eta).
    pub loss_factor: f64,
}

/// A thin-walled section, about its shear centre.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Section {
    /// Area A, m2.
    pub area: f64,
    /// Second moment of area `I_y` for bending of w (along y), m4.
    pub second_moment_y: f64,
    /// Second moment of area `I_z` for bending of v (along z), m4.
    pub second_moment_z: f64,
    /// Saint-Venant torsion constant J, m4.
    pub torsion_constant: f64,
    /// Warping constant `Gamma_0`, m6; 0: no warping stiffness.
    pub warping_constant: f64,
    /// Polar moment of area `I_0` about the shear centre, m4.
    pub polar_moment: f64,
    /// Offset `z_c` of the centroid from the shear centre along z, m; any sign.
    pub centroid_offset: f64,
    /// Product moment of area `I_yz` about the centroid, m4; any sign.
    pub product_moment: f64,
    /// Offset `y_c` of the centroid from the shear centre along y, m; any sign.
    pub centroid_offset_y: f64,
    /// Effective area `A_y` for shear along y, m2; 0 if not given.
    pub shear_area_y: f64,
    /// Effective area `A_z` for shear along z, m2; 0 if not given.
    pub shear_area_z: f64,
}

impl Beam {
    /// Whether the section has one offset at most, along z, and its principal axes along y and z, and the beam neither
    /// rotary inertia nor shear deformation, axial force or foundation: the beam of Chen & Liu, Mathematics 2022, 10(16), 2849, where v is on its own.
    pub(crate) fn is_of_one_offset(&self) -> bool {
        self.section.product_moment == 0.0
            && self.section.centroid_offset_y == 0.0
            && self.axial_force == 0.0
            && self.foundation == Foundation::default()
            && self.theory == Theory::EulerBernoulli
            && !self.warping_inertia
    }
}

impl Section {
    /// The polar moment, m4, that `I_0` must exceed, and its formula: `A (y_c^2 + z_c^2)`.
    pub(crate) fn least_polar_moment(&self) -> (f64, &'static str) {
        let (y, z) = (self.centroid_offset_y, self.centroid_offset);
        if y == 0.0 {
            (self.area * z * z, "A z_c^2")
        } else {
            (self.area * (y * y + z * z), "A (y_c^2 + z_c^2)")
        }
    }

    /// The product moment, m4, that `I_yz` must not reach in magnitude: `sqrt(I_y I_z)`.
    pub(crate) fn most_product_moment(&self) -> f64 {
        self.second_moment_y.sqrt() * self.second_moment_z.sqrt()
    }
}

words! {
    /// The six motions of a point of the shear-centre line of the beam.
    pub enum BeamMotion {
        /// Displacement w along y, m.
        W = "w",
        /// Twist psi about x, rad.
        Psi = "psi",
        /// Displacement v along z, m.
        V = "v",
        /// Slope w', rad.
        WSlope = "w_slope",
        /// Rate of twist psi', rad/m, which warps the section. At a torque that makes it discontinuous (only without
        /// warping stiffness) it is the mean of both sides.
        PsiSlope = "psi_slope",
        /// Slope v', rad.
        VSlope = "v_slope",
    }
}

impl BeamMotion {
    /// True for the two translations, whose inertia is a mass.
    pub const fn is_translation(self) -> bool {
        matches!(self, Self::W | Self::V)
    }

    /// The load that acts along it.
    pub const fn load(self) -> Load {
        match self {
            Self::W | Self::V => Load::Force,
            Self::PsiSlope => Load::Bimoment,
            Self::Psi | Self::WSlope | Self::VSlope => Load::Moment,
        }
    }
}

/// A point of the section, from the axis of the beam: it moves by `w + z psi` along y and `v - y psi` along z.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point {
    /// m.
    pub y: f64,
    /// m.
    pub z: f64,
}

impl Point {
    /// On the axis of the beam.
    pub const AXIS: Self = Self { y: 0.0, z: 0.0 };

    /// The arm, m, by which twist moves the point along a motion: `z` for w, `-y` for v; `None` if the motion is the
    /// same at every point.
    pub fn arm(self, motion: BeamMotion) -> Option<f64> {
        match motion {
            BeamMotion::W => Some(self.z),
            BeamMotion::V => Some(-self.y),
            BeamMotion::Psi | BeamMotion::WSlope | BeamMotion::PsiSlope | BeamMotion::VSlope => {
                None
            }
        }
    }
}

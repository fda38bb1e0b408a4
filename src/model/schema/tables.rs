//! The tables of the model file, one row per key.

use super::{Access, BLANK, Key, Kind, Range, Rows};
use crate::model::beam::{Beam, BeamMotion, Foundation, Material, Section, Span, Theory};
use crate::model::quantity::Response;
use crate::model::spring::{Elastic, MaxwellBranch, Spring};
use crate::model::types::{
    Force, InnerSupport, Joint, Model, Spacing, Study, Subsystem, Support, Sweep,
};
use crate::unit::Unit;

rows! {
    /// The keys above all tables.
    MODEL of Model {
        text("title", Line, "title, one line", title),
        text("notes", Text, "notes", notes),
    }
}

rows! {
    /// The beam itself.
    BEAM of Beam as BeamKey {
        Length = number("length", "L", METRE, Positive, "length of the beam", length),
        Theory = word("theory", Theory, "theory of bending; rayleigh: with rotary inertia, shear: with shear deformation, timoshenko: with both", theory),
        WarpingInertia = switch("warping_inertia", Flag, "whether warping has inertia, rho Gamma_0 on the rate of twist", warping_inertia),
        AxialForce = number("axial_force", "N", FORCE, Any or 0.0, "axial force along the centroids, tension > 0", axial_force),
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
        PolarMoment = number("polar_moment", "I_0", METRE_4, Positive, "polar moment of area about the shear centre, > A (y_c^2 + z_c^2)", polar_moment),
        CentroidOffset = number("centroid_offset", "z_c", METRE, Any, "offset of the centroid from the shear centre, along z", centroid_offset),
        ProductMoment = number("product_moment", "I_yz", METRE_4, Any or 0.0, "product moment of area about the centroid, int y z dA", product_moment),
        CentroidOffsetY = number("centroid_offset_y", "y_c", METRE, Any or 0.0, "offset of the centroid from the shear centre, along y", centroid_offset_y),
        ShearAreaY = number("shear_area_y", "A_y", AREA, NonNegative or 0.0, "effective area for shear along y; only the theories with shear use it", shear_area_y),
        ShearAreaZ = number("shear_area_z", "A_z", AREA, NonNegative or 0.0, "effective area for shear along z; only the theories with shear use it", shear_area_z),
    }
}

rows! {
    /// The foundation.
    FOUNDATION of Foundation as FoundationKey {
        WStiffness = spring("w.stiffness", "k_w", LINE_STIFFNESS, "stiffness of the foundation along y, per length", w.stiffness),
        WDamping = spring("w.damping", "c_w", LINE_DAMPING, "damping of the foundation along y, per length", w.damping),
        WLossFactor = number("w.loss_factor", "eta_w", ONE, NonNegative or 0.0, "loss factor of its stiffness along y", w.loss_factor),
        PsiStiffness = spring("psi.stiffness", "k_psi", FORCE, "stiffness of the foundation against twist, per length", psi.stiffness),
        PsiDamping = spring("psi.damping", "c_psi", TWIST_DAMPING, "damping of the foundation against twist, per length", psi.damping),
        PsiLossFactor = number("psi.loss_factor", "eta_psi", ONE, NonNegative or 0.0, "loss factor of its stiffness against twist", psi.loss_factor),
        VStiffness = spring("v.stiffness", "k_v", LINE_STIFFNESS, "stiffness of the foundation along z, per length", v.stiffness),
        VDamping = spring("v.damping", "c_v", LINE_DAMPING, "damping of the foundation along z, per length", v.damping),
        VLossFactor = number("v.loss_factor", "eta_v", ONE, NonNegative or 0.0, "loss factor of its stiffness along z", v.loss_factor),
    }
}

rows! {
    /// A span of the beam: its numbers, then whose tables it has.
    SPAN of Span as SpanKey {
        Length = number("length", "L", METRE, Positive, "length of the span", length),
        OffsetY = number("offset_y", "y_s", METRE, Any or 0.0, "offset of its shear centre from the axis of the beam, along y", offset.y),
        OffsetZ = number("offset_z", "z_s", METRE, Any or 0.0, "offset of its shear centre from the axis of the beam, along z", offset.z),
        AxialForce = optional_number("axial_force", "N", FORCE, Any, "axial force along its centroids, tension > 0; without it that of the beam", axial_force),
        Material = own("material", Table, "its own material, or that of the beam"),
        Section = own("section", Table, "its own section, or that of the beam"),
        Foundation = own("foundation", Table, "its own foundation, or that of the beam"),
    }
}

rows! {
    /// A support: the word for all motions, then each motion in the order of [`BeamMotion::ALL`].
    SUPPORT of Support {
        own("kind", Support, "the support as a whole; elastic: set for each motion"),
        own("w", Restraint, "restraint of w, the displacement along y"),
        own("psi", Restraint, "restraint of psi, the twist about x"),
        own("v", Restraint, "restraint of v, the displacement along z"),
        own("w_slope", Restraint, "restraint of the slope of w"),
        own("psi_slope", Restraint, "restraint of the rate of twist; fixed: warping restrained"),
        own("v_slope", Restraint, "restraint of the slope of v"),
        number("y", "y", METRE, Any or 0.0, "point of the section that v holds, from the axis along y", point.y),
        number("z", "z", METRE, Any or 0.0, "point of the section that w holds, from the axis along z", point.z),
    }
}

rows! {
    /// The keys of a support between the ends, before those of [`SUPPORT`].
    INNER_SUPPORT of InnerSupport as InnerSupportKey {
        Name = text("name", Name, "name of the support", name),
        Position = number("position", "x", METRE, NonNegative, "position, from the left end", position),
    }
}

/// All keys of a support between the ends.
pub const INNER_SUPPORT_KEYS: &[Key] = &{
    let mut all = [BLANK; INNER_SUPPORT.keys.len() + SUPPORT.keys.len()];
    let mut row = 0;
    while row < all.len() {
        all[row] = match row.checked_sub(INNER_SUPPORT.keys.len()) {
            Some(row) => SUPPORT.keys[row],
            None => INNER_SUPPORT.keys[row],
        };
        row += 1;
    }
    all
};

rows! {
    /// The elastic restraint of w or v.
    ELASTIC_TRANSLATION of Elastic as ElasticKey {
        Stiffness = spring("stiffness", "K", STIFFNESS, "spring to the ground", spring.stiffness),
        Damping = spring("damping", "C", DAMPING, "damper to the ground", spring.damping),
        LossFactor = number("loss_factor", "eta", ONE, NonNegative or 0.0, "loss factor of the spring", spring.loss_factor),
        Inertia = number("mass", "m", KILOGRAM, NonNegative or 0.0, "mass that moves with the beam there", inertia),
    }
}

rows! {
    /// The elastic restraint of a motion about an axis: psi and the slopes of w and v.
    ELASTIC_ROTATION of Elastic {
        spring("stiffness", "K_T", ROTATIONAL_STIFFNESS, "rotational spring to the ground", spring.stiffness),
        spring("damping", "C_T", ROTATIONAL_DAMPING, "rotational damper to the ground", spring.damping),
        number("loss_factor", "eta", ONE, NonNegative or 0.0, "loss factor of the spring", spring.loss_factor),
        number("inertia", "I", INERTIA, NonNegative or 0.0, "moment of inertia that turns with the beam there", inertia),
    }
}

rows! {
    /// The elastic restraint of the rate of twist, i.e. of warping.
    ELASTIC_WARPING of Elastic {
        spring("stiffness", "K_B", WARPING_STIFFNESS, "spring against warping", spring.stiffness),
        spring("damping", "C_B", WARPING_DAMPING, "damper against warping", spring.damping),
        number("loss_factor", "eta", ONE, NonNegative or 0.0, "loss factor of the spring", spring.loss_factor),
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
    /// A joint: its position, then each motion in the order of [`BeamMotion::ALL`].
    JOINT of Joint as JointKey {
        Position = number("position", "x", METRE, NonNegative, "position, from the left end", position),
        W = own("w", Link, "link of w, the displacement along y, of both sides"),
        Psi = own("psi", Link, "link of psi, the twist about x, of both sides"),
        V = own("v", Link, "link of v, the displacement along z, of both sides"),
        WSlope = own("w_slope", Link, "link of the slope of w of both sides; free: a hinge"),
        PsiSlope = own("psi_slope", Link, "link of the rate of twist of both sides; free: no bimoment"),
        VSlope = own("v_slope", Link, "link of the slope of v of both sides; free: a hinge"),
    }
}

rows! {
    /// The elastic link of w or v.
    LINK_TRANSLATION of Spring as LinkKey {
        Stiffness = spring("stiffness", "K", STIFFNESS, "spring between both sides", stiffness),
        Damping = spring("damping", "C", DAMPING, "damper between both sides", damping),
        LossFactor = number("loss_factor", "eta", ONE, NonNegative or 0.0, "loss factor of the spring", loss_factor),
    }
}

rows! {
    /// The elastic link of a motion about an axis: psi and the slopes of w and v.
    LINK_ROTATION of Spring {
        spring("stiffness", "K_T", ROTATIONAL_STIFFNESS, "rotational spring between both sides", stiffness),
        spring("damping", "C_T", ROTATIONAL_DAMPING, "rotational damper between both sides", damping),
        number("loss_factor", "eta", ONE, NonNegative or 0.0, "loss factor of the spring", loss_factor),
    }
}

rows! {
    /// The elastic link of the rate of twist, i.e. of warping.
    LINK_WARPING of Spring {
        spring("stiffness", "K_B", WARPING_STIFFNESS, "spring between the warping of both sides", stiffness),
        spring("damping", "C_B", WARPING_DAMPING, "damper between the warping of both sides", damping),
        number("loss_factor", "eta", ONE, NonNegative or 0.0, "loss factor of the spring", loss_factor),
    }
}

/// The elastic link of a motion.
pub const fn link(motion: BeamMotion) -> &'static Rows<Spring> {
    match motion {
        BeamMotion::W | BeamMotion::V => &LINK_TRANSLATION,
        BeamMotion::Psi | BeamMotion::WSlope | BeamMotion::VSlope => &LINK_ROTATION,
        BeamMotion::PsiSlope => &LINK_WARPING,
    }
}

rows! {
    /// A Maxwell branch of a spring along a direction.
    BRANCH_TRANSLATION of MaxwellBranch as BranchKey {
        Stiffness = required_spring("stiffness", "k_b", STIFFNESS, "spring of the branch, in series with its damper", stiffness),
        Damping = required_spring("damping", "c_b", DAMPING, "damper of the branch, in series with its spring", damping),
    }
}

rows! {
    /// A Maxwell branch of a spring about an axis.
    BRANCH_ROTATION of MaxwellBranch {
        required_spring("stiffness", "k_b", ROTATIONAL_STIFFNESS, "rotational spring of the branch, in series with its damper", stiffness),
        required_spring("damping", "c_b", ROTATIONAL_DAMPING, "rotational damper of the branch, in series with its spring", damping),
    }
}

rows! {
    /// A Maxwell branch of a spring on the rate of twist.
    BRANCH_WARPING of MaxwellBranch {
        required_spring("stiffness", "k_b", WARPING_STIFFNESS, "spring of the branch against warping, in series with its damper", stiffness),
        required_spring("damping", "c_b", WARPING_DAMPING, "damper of the branch against warping, in series with its spring", damping),
    }
}

/// A Maxwell branch of the spring of a motion.
pub const fn branch(motion: BeamMotion) -> &'static Rows<MaxwellBranch> {
    match motion {
        BeamMotion::W | BeamMotion::V => &BRANCH_TRANSLATION,
        BeamMotion::Psi | BeamMotion::WSlope | BeamMotion::VSlope => &BRANCH_ROTATION,
        BeamMotion::PsiSlope => &BRANCH_WARPING,
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
        YLeftLossFactor = number("y_left.loss_factor", "eta_yL", ONE, NonNegative or 0.0, "loss factor of the left spring along y", y_left.loss_factor),
        YRightStiffness = spring("y_right.stiffness", "k_yR", STIFFNESS, "right spring along y", y_right.stiffness),
        YRightDamping = spring("y_right.damping", "c_yR", DAMPING, "right damper along y", y_right.damping),
        YRightLossFactor = number("y_right.loss_factor", "eta_yR", ONE, NonNegative or 0.0, "loss factor of the right spring along y", y_right.loss_factor),
        ZLeftStiffness = spring("z_left.stiffness", "k_zL", STIFFNESS, "left spring along z", z_left.stiffness),
        ZLeftDamping = spring("z_left.damping", "c_zL", DAMPING, "left damper along z", z_left.damping),
        ZLeftLossFactor = number("z_left.loss_factor", "eta_zL", ONE, NonNegative or 0.0, "loss factor of the left spring along z", z_left.loss_factor),
        ZRightStiffness = spring("z_right.stiffness", "k_zR", STIFFNESS, "right spring along z", z_right.stiffness),
        ZRightDamping = spring("z_right.damping", "c_zR", DAMPING, "right damper along z", z_right.damping),
        ZRightLossFactor = number("z_right.loss_factor", "eta_zR", ONE, NonNegative or 0.0, "loss factor of the right spring along z", z_right.loss_factor),
        ArmLeft = number("arm_left", "l_L", METRE, Any or 0.0, "arm of the left z spring at the mass", arm_left),
        ArmRight = number("arm_right", "l_R", METRE, Any or 0.0, "arm of the right z spring at the mass", arm_right),
        MountY = number("mount_y", "y_u", METRE, Any or 0.0, "half-spacing of the z springs at the beam", mount_y),
        MountZ = number("mount_z", "z_b", METRE, Any or 0.0, "height of the y springs at the beam, from the shear centre", mount_z),
    }
}

rows! {
    /// A force; the unit of the amplitude is that of a load along a translation.
    FORCE of Force as ForceKey {
        Enabled = flag("enabled", Flag, "whether it acts", enabled),
        At = own("at", Place, "position on the beam, or a subsystem"),
        Direction = own("direction", Direction, "direction of the load"),
        Y = number("y", "y", METRE, Any or 0.0, "point of the section on which a force along v acts, from the axis along y", point.y),
        Z = number("z", "z", METRE, Any or 0.0, "point of the section on which a force along w acts, from the axis along z", point.z),
        Amplitude = number("amplitude", "F", FORCE, Any or 1.0, "amplitude, zero to peak", amplitude),
        Phase = number("phase", "phi", DEGREE, Any or 0.0, "phase", phase),
    }
}

rows! {
    /// A response.
    RESPONSE of Response as ResponseKey {
        Name = text("name", Name, "name of the response", name),
        Enabled = flag("enabled", Flag, "whether it is computed", enabled),
        Measure = own("measure", Measure, "what is computed"),
        At = own("at", Place, "where it is read"),
        Direction = own("direction", Direction, "direction of the motion or of the force, or a spring"),
        Y = number("y", "y", METRE, Any or 0.0, "point of the section that moves along v, from the axis along y", point.y),
        Z = number("z", "z", METRE, Any or 0.0, "point of the section that moves along w, from the axis along z", point.z),
        Over = optional_text("over", Over, "response that divides it", over),
    }
}

rows! {
    /// The frequencies.
    SWEEP of Sweep as SweepKey {
        From = number("from", "f_1", HERTZ, Positive, "first frequency", from),
        To = number("to", "f_2", HERTZ, Positive, "last frequency", to),
        Points = count("points", Count, "number of frequencies, both ends included", points),
        Spacing = word("spacing", Spacing, "spacing of the frequencies", spacing),
    }
}

rows! {
    /// The keys of every study.
    STUDY of Study {
        text("name", Name, "name of the study", name),
    }
}

//! The dimension of the values of a response, the six forms of a frequency response, and their SI units.
//!
//! A response to one force is a ratio: receptance, mobility and accelerance are displacement, velocity and acceleration
//! over force; dynamic stiffness, impedance and apparent mass are their inverses (Ewins, Modal Testing, 2nd ed. 2000,
//! section 2.1.2). An inverse here is that of one entry, not an entry of the inverse matrix. Under several forces that
//! act simultaneously there is no such ratio: then the first three are the motion itself, and the inverses are not
//! defined.

use num_complex::Complex64;

use super::Unit;
use crate::words::words;

words! {
    /// The time derivative of a motion.
    #[derive(Default)]
    pub enum Measure {
        /// Receptance.
        #[default]
        Displacement = "displacement",
        /// Mobility.
        Velocity = "velocity",
        /// Accelerance.
        Acceleration = "acceleration",
    }
}

/// The kind of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Moves {
    /// A translation, m.
    Length,
    /// A rotation, rad.
    Angle,
    /// A rate of twist, rad/m.
    TwistRate,
}

/// The kind of load that divides a response.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Load {
    /// N.
    Force,
    /// A moment or torque, N m.
    Moment,
    /// N m2.
    Bimoment,
}

/// The kind of the values of a motion's curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// The kind of motion.
    pub moves: Moves,
    /// The measure of the motion.
    pub measure: Measure,
    /// The load that divides it; none for the motion itself, zero to peak.
    pub per: Option<Load>,
}

/// The dimension of the values of a response.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A motion, or a motion over a load.
    Motion(Dimension),
    /// A vibration energy, kg m2, real.
    Energy,
}

/// A form of a frequency response.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Form {
    /// Displacement over force.
    Receptance,
    /// Velocity over force.
    Mobility,
    /// Acceleration over force.
    Accelerance,
    /// Force over displacement.
    DynamicStiffness,
    /// Force over velocity.
    Impedance,
    /// Force over acceleration.
    ApparentMass,
}

impl Form {
    /// All six.
    pub const ALL: [Self; 6] = [
        Self::Receptance,
        Self::Mobility,
        Self::Accelerance,
        Self::DynamicStiffness,
        Self::Impedance,
        Self::ApparentMass,
    ];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Receptance => "receptance",
            Self::Mobility => "mobility",
            Self::Accelerance => "accelerance",
            Self::DynamicStiffness => "dynamic stiffness",
            Self::Impedance => "impedance",
            Self::ApparentMass => "apparent mass",
        }
    }

    /// The measure of its motion.
    pub const fn measure(self) -> Measure {
        match self {
            Self::Receptance | Self::DynamicStiffness => Measure::Displacement,
            Self::Mobility | Self::Impedance => Measure::Velocity,
            Self::Accelerance | Self::ApparentMass => Measure::Acceleration,
        }
    }

    /// Whether the force is the numerator.
    pub const fn is_inverse(self) -> bool {
        matches!(
            self,
            Self::DynamicStiffness | Self::Impedance | Self::ApparentMass
        )
    }
}

impl Measure {
    /// The order of the time derivative of the displacement.
    pub const fn order(self) -> i32 {
        match self {
            Self::Displacement => 0,
            Self::Velocity => 1,
            Self::Acceleration => 2,
        }
    }
}

impl Moves {
    /// The kind of motion along which a load acts.
    pub const fn along(load: Load) -> Self {
        match load {
            Load::Force => Self::Length,
            Load::Moment => Self::Angle,
            Load::Bimoment => Self::TwistRate,
        }
    }
}

impl Load {
    /// All three.
    pub const ALL: [Self; 3] = [Self::Force, Self::Moment, Self::Bimoment];

    /// The unit of its amplitude.
    pub const fn unit(self) -> Unit {
        match self {
            Self::Force => Unit::FORCE,
            Self::Moment => Unit::TORQUE,
            Self::Bimoment => Unit::BIMOMENT,
        }
    }
}

impl Kind {
    /// Its SI unit: `m/(N s2)`, `rad`, `kg m2`.
    pub fn unit(self) -> String {
        match self {
            Self::Motion(dimension) => dimension.unit(dimension.form_of_measure()),
            Self::Energy => Unit::INERTIA.symbol.to_owned(),
        }
    }

    /// The dimension of a motion.
    pub const fn motion(self) -> Option<Dimension> {
        match self {
            Self::Motion(dimension) => Some(dimension),
            Self::Energy => None,
        }
    }
}

impl Dimension {
    /// The form of its measure, not an inverse one; for a motion that is not divided by a force, the one with the same
    /// measure.
    pub const fn form_of_measure(&self) -> Form {
        match self.measure {
            Measure::Displacement => Form::Receptance,
            Measure::Velocity => Form::Mobility,
            Measure::Acceleration => Form::Accelerance,
        }
    }

    /// Whether it can be converted to a form: an inverse needs a force.
    pub fn has(&self, form: Form) -> bool {
        !form.is_inverse() || self.per.is_some()
    }

    /// Converts a value at a frequency (Hz) to a form; the inverse of 0 is not finite.
    ///
    /// Displacement, velocity and acceleration differ by i omega.
    pub fn converted(&self, value: Complex64, frequency: f64, form: Form) -> Complex64 {
        let omega = std::f64::consts::TAU * frequency;
        let steps = form.measure().order() - self.measure.order();
        let motion = value * Complex64::new(0.0, omega).powi(steps);
        if form.is_inverse() {
            motion.finv()
        } else {
            motion
        }
    }

    /// The unit of its values in a form, SI.
    pub fn unit(&self, form: Form) -> String {
        let moved = match self.moves {
            Moves::Length => Unit::METRE.symbol,
            Moves::Angle => "rad",
            Moves::TwistRate => "rad/m",
        };
        let second = ["", "s", "s2"][form.measure().order().unsigned_abs() as usize];
        let load = self.per.map_or("", |load| load.unit().symbol);
        match (form, self.moves, self.per) {
            (Form::ApparentMass, Moves::Length, Some(Load::Force)) => {
                Unit::KILOGRAM.symbol.to_owned()
            }
            (form, Moves::TwistRate, _) if form.is_inverse() => {
                over(&format!("{load} m {second}"), "rad")
            }
            (form, ..) if form.is_inverse() => over(&format!("{load} {second}"), moved),
            (_, Moves::TwistRate, _) => over("rad", &format!("m {load} {second}")),
            _ => over(moved, &format!("{load} {second}")),
        }
    }
}

/// One unit over another: "m/(N s)".
fn over(above: &str, below: &str) -> String {
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let (above, below) = (words(above), words(below));
    match below.as_str() {
        "" => above,
        one if !one.contains(' ') => format!("{above}/{one}"),
        more => format!("{above}/({more})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dimension(moves: Moves, per: Option<Load>) -> Dimension {
        Dimension {
            moves,
            measure: Measure::Displacement,
            per,
        }
    }

    #[test]
    fn units_are_those_of_the_ratio() {
        let units = |moves, per| Form::ALL.map(|form| dimension(moves, per).unit(form));
        assert_eq!(
            units(Moves::Length, Some(Load::Force)),
            ["m/N", "m/(N s)", "m/(N s2)", "N/m", "N s/m", "kg"]
        );
        assert_eq!(
            units(Moves::Angle, Some(Load::Moment)),
            [
                "rad/(N m)",
                "rad/(N m s)",
                "rad/(N m s2)",
                "N m/rad",
                "N m s/rad",
                "N m s2/rad"
            ]
        );
        assert_eq!(units(Moves::Length, Some(Load::Moment))[0], "m/(N m)");
        assert_eq!(
            units(Moves::Angle, Some(Load::Force))[..2],
            ["rad/N", "rad/(N s)"]
        );
        assert_eq!(
            units(Moves::TwistRate, Some(Load::Bimoment))[0],
            "rad/(m N m2)"
        );
        assert_eq!(
            units(Moves::TwistRate, Some(Load::Bimoment))[3],
            "N m2 m/rad"
        );
        assert_eq!(units(Moves::TwistRate, None)[2], "rad/(m s2)");
        assert_eq!(units(Moves::Length, None)[..3], ["m", "m/s", "m/s2"]);
    }

    #[test]
    fn a_mass_and_a_spring_have_the_forms_of_the_books() {
        // Closed form: a free mass m has accelerance 1/m, apparent mass m, impedance i omega m, mobility 1/(i omega m).
        let (mass, frequency) = (2.5, 3.0);
        let omega = std::f64::consts::TAU * frequency;
        let receptance = Complex64::from(-1.0 / (omega * omega * mass));
        let of = |form| {
            dimension(Moves::Length, Some(Load::Force)).converted(receptance, frequency, form)
        };
        let near =
            |a: Complex64, b: Complex64| assert!((a - b).norm() < 1e-12 * b.norm(), "{a} {b}");
        near(of(Form::Receptance), receptance);
        near(of(Form::Accelerance), (1.0 / mass).into());
        near(of(Form::ApparentMass), mass.into());
        near(of(Form::Impedance), Complex64::new(0.0, omega * mass));
        near(
            of(Form::Mobility),
            Complex64::new(0.0, -1.0 / (omega * mass)),
        );
        near(of(Form::DynamicStiffness), (-omega * omega * mass).into());
    }
}

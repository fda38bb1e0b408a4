//! The dimension of the values of a response, the six forms of a frequency response, and their SI units.
//!
//! A motion under one force is a ratio: receptance, mobility and accelerance are displacement, velocity and acceleration
//! over force; dynamic stiffness, impedance and apparent mass are their inverses (Ewins, Modal Testing, 2nd ed. 2000,
//! section 2.1.2). An inverse here is that of one entry, not an entry of the inverse matrix. Under several forces that
//! act simultaneously there is no such ratio: then the first three are the motion itself, and the inverses are not
//! defined. A force, and a response over another one, have no such forms: they stay as they are.

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

/// What a complex amplitude is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Amount {
    /// A motion.
    Motion(Moves, Measure),
    /// A force inside the model, by the load that it balances.
    Load(Load),
}

/// The kind of the values of a complex curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// What it is of.
    pub of: Amount,
    /// What divides it: the only load, or another response; none for the amplitude itself, zero to peak.
    pub per: Option<Amount>,
}

/// The dimension of the values of a response.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A complex amplitude, or a ratio of two.
    Amplitude(Dimension),
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
    /// Its SI unit: `m/(N s2)`, `rad`, `N/N`, `kg m2`.
    pub fn unit(self) -> String {
        match self {
            Self::Amplitude(dimension) => dimension.unit(dimension.own_form()),
            Self::Energy => Unit::INERTIA.symbol.to_owned(),
        }
    }

    /// The dimension of a complex amplitude.
    pub const fn dimension(self) -> Option<Dimension> {
        match self {
            Self::Amplitude(dimension) => Some(dimension),
            Self::Energy => None,
        }
    }
}

impl Dimension {
    /// That of a motion, alone or over a load.
    pub const fn of_motion(moves: Moves, measure: Measure, per: Option<Load>) -> Self {
        Self {
            of: Amount::Motion(moves, measure),
            per: match per {
                Some(load) => Some(Amount::Load(load)),
                None => None,
            },
        }
    }

    /// The measure of a motion that is alone or over a load: of what has the six forms.
    const fn measure(self) -> Option<Measure> {
        match (self.of, self.per) {
            (Amount::Motion(_, measure), None | Some(Amount::Load(_))) => Some(measure),
            (Amount::Motion(..) | Amount::Load(_), _) => None,
        }
    }

    /// The form of its measure, not an inverse one; for a motion that is not divided by a force, the one with the same
    /// measure. What has no forms stays as it is in this one.
    pub const fn own_form(self) -> Form {
        match self.measure() {
            Some(Measure::Displacement) | None => Form::Receptance,
            Some(Measure::Velocity) => Form::Mobility,
            Some(Measure::Acceleration) => Form::Accelerance,
        }
    }

    /// Whether it can be converted to a form: only a motion, and to an inverse one only over a load.
    pub const fn has(self, form: Form) -> bool {
        self.measure().is_some() && (!form.is_inverse() || self.per.is_some())
    }

    /// The name of one of its forms; none for a motion under the loads, and for what has no forms.
    pub const fn name(self, form: Form) -> Option<&'static str> {
        match self.per {
            Some(_) if self.has(form) => Some(form.name()),
            Some(_) | None => None,
        }
    }

    /// What it is: `receptance`, `velocity`, `force`, `ratio`.
    pub const fn words(self) -> &'static str {
        match (self.of, self.per, self.name(self.own_form())) {
            (_, _, Some(form)) => form,
            (_, Some(_), None) => "ratio",
            (Amount::Motion(_, measure), None, None) => measure.key(),
            (Amount::Load(_), None, None) => "force",
        }
    }

    /// Whether both are the same but for the measure of the motion, and one can be converted to the other.
    pub fn is_alike(self, other: Self) -> bool {
        let plain = |of: Self| match of.of {
            Amount::Motion(moves, _) if of.measure().is_some() => Self {
                of: Amount::Motion(moves, Measure::Displacement),
                ..of
            },
            Amount::Motion(..) | Amount::Load(_) => of,
        };
        plain(self) == plain(other)
    }

    /// Whether both are of one motion or force, whatever divides them.
    pub fn of_same_motion(self, other: Self) -> bool {
        let undivided = |of: Self| Self { per: None, ..of };
        undivided(self).is_alike(undivided(other))
    }

    /// Converts a value at a frequency (Hz) to a form; the inverse of 0 is not finite.
    ///
    /// Displacement, velocity and acceleration differ by i omega.
    pub fn converted(self, value: Complex64, frequency: f64, form: Form) -> Complex64 {
        let Some(measure) = self.measure() else {
            return value;
        };
        let omega = std::f64::consts::TAU * frequency;
        let steps = form.measure().order() - measure.order();
        let motion = value * Complex64::new(0.0, omega).powi(steps);
        if form.is_inverse() {
            motion.finv()
        } else {
            motion
        }
    }

    /// The unit of its values in a form, SI.
    pub fn unit(self, form: Form) -> String {
        let accelerance = Self::of_motion(Moves::Length, form.measure(), Some(Load::Force));
        let (of, per) = (
            self.of.words(),
            self.per.map(Amount::words).unwrap_or_default(),
        );
        let (order, is_inverse) = match self.measure() {
            Some(_) => (form.measure().order(), form.is_inverse()),
            None => (self.of.order() - self.per.map_or(0, Amount::order), false),
        };
        if form == Form::ApparentMass && self.is_alike(accelerance) {
            return Unit::KILOGRAM.symbol.to_owned();
        }
        let second = |order: i32| ["", "s", "s2"][order.clamp(0, 2).unsigned_abs() as usize];
        let (later, sooner) = (second(order), second(-order));
        if is_inverse {
            return over(&[per.0, of.1, later], &[of.0]);
        }
        match (self.of, self.per) {
            (Amount::Motion(..), Some(Amount::Motion(..))) if of == per => {
                over(&["1", sooner], &[later])
            }
            _ => over(&[of.0, per.1, sooner], &[of.1, per.0, later]),
        }
    }
}

impl Amount {
    /// The order of its time derivative.
    const fn order(self) -> i32 {
        match self {
            Self::Motion(_, measure) => measure.order(),
            Self::Load(_) => 0,
        }
    }

    /// Its unit without seconds: numerator and denominator.
    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Motion(Moves::Length, _) => (Unit::METRE.symbol, ""),
            Self::Motion(Moves::Angle, _) => ("rad", ""),
            Self::Motion(Moves::TwistRate, _) => ("rad", "m"),
            Self::Load(load) => (load.unit().symbol, ""),
        }
    }
}

/// A product of units over another: "m/(N s)".
fn over(above: &[&str], below: &[&str]) -> String {
    let words = |parts: &[&str]| {
        let words = parts.iter().flat_map(|part| part.split_whitespace());
        words.collect::<Vec<_>>().join(" ")
    };
    let (above, below) = (words(above), words(below));
    let above = above.strip_prefix("1 ").unwrap_or(&above);
    match below.as_str() {
        "" => above.to_owned(),
        one if !one.contains(' ') => format!("{above}/{one}"),
        more => format!("{above}/({more})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dimension(moves: Moves, per: Option<Load>) -> Dimension {
        Dimension::of_motion(moves, Measure::Displacement, per)
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
    fn forces_and_ratios_have_the_unit_of_what_they_are() {
        let unit = |of, per| Kind::Amplitude(Dimension { of, per }).unit();
        let load = |load| Amount::Load(load);
        let (force, moment) = (load(Load::Force), load(Load::Moment));
        let motion = |moves, measure| Amount::Motion(moves, measure);
        let stretch = motion(Moves::Length, Measure::Displacement);
        let velocity = motion(Moves::Length, Measure::Velocity);
        let acceleration = motion(Moves::Length, Measure::Acceleration);
        assert_eq!(unit(force, None), "N");
        assert_eq!(unit(force, Some(force)), "N/N");
        assert_eq!(unit(moment, Some(force)), "N m/N");
        assert_eq!(unit(force, Some(stretch)), "N/m");
        assert_eq!(unit(force, Some(acceleration)), "N s2/m");
        assert_eq!(unit(stretch, Some(stretch)), "1");
        assert_eq!(unit(velocity, Some(velocity)), "1");
        assert_eq!(unit(velocity, Some(stretch)), "1/s");
        assert_eq!(unit(stretch, Some(acceleration)), "s2");
        assert_eq!(
            unit(motion(Moves::Angle, Measure::Displacement), Some(stretch)),
            "rad/m"
        );
        let twist = motion(Moves::TwistRate, Measure::Displacement);
        assert_eq!(unit(stretch, Some(twist)), "m m/rad");
        assert_eq!(unit(load(Load::Bimoment), Some(moment)), "N m2/(N m)");
    }

    #[test]
    fn what_is_no_motion_over_a_load_stays_as_it_is() {
        let value = Complex64::new(1.0, 2.0);
        let force = Dimension {
            of: Amount::Load(Load::Force),
            per: Some(Amount::Load(Load::Force)),
        };
        for form in Form::ALL {
            assert!(!force.has(form));
            assert_eq!(force.converted(value, 3.0, form), value);
            assert_eq!(force.unit(form), "N/N");
        }
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

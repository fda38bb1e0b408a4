//! Units of frequencies and phases.

use std::f64::consts::{PI, TAU};

use super::Unit;
use crate::words::words;

words! {
    /// The unit of frequencies; the words are those of the layout of a table.
    #[derive(Default)]
    pub enum FrequencyUnit {
        /// Hz.
        #[default]
        Hertz = "hz",
        /// kHz.
        Kilohertz = "khz",
        /// rad/s.
        RadianPerSecond = "rad/s",
        /// Revolutions per minute.
        RevolutionPerMinute = "rpm",
    }
}

words! {
    /// The unit of phases in a file; the words are those of the layout of a table.
    pub enum PhaseUnit {
        /// Degrees.
        Degree = "deg",
        /// rad.
        Radian = "rad",
    }
}

impl FrequencyUnit {
    /// The units in which frequencies are shown and typed, in the order in which a key cycles through them.
    pub const SHOWN: [Self; 3] = [
        Self::Hertz,
        Self::RadianPerSecond,
        Self::RevolutionPerMinute,
    ];

    /// [`Self::SHOWN`] for people.
    pub const SHOWN_WORDS: &str = "Hz, rad/s or rpm";

    /// The words of a layout for people.
    pub const ACCEPTED: &str = "hz, khz, rad/s or rpm";

    /// Its symbol.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Hertz => Unit::HERTZ.symbol,
            Self::Kilohertz => "kHz",
            Self::RadianPerSecond | Self::RevolutionPerMinute => self.key(),
        }
    }

    /// The name of the quantity.
    const fn quantity(self) -> &'static str {
        match self {
            Self::Hertz | Self::Kilohertz => "frequency",
            Self::RadianPerSecond => "angular frequency",
            Self::RevolutionPerMinute => "speed",
        }
    }

    /// The label of an axis: "frequency, Hz".
    pub fn heading(self) -> String {
        format!("{}, {}", self.quantity(), self.symbol())
    }

    /// The name of a column: `angular_frequency_rad_s`.
    pub fn column(self) -> String {
        let name = format!("{}_{}", self.quantity(), self.symbol());
        name.to_lowercase().replace([' ', '/'], "_")
    }

    /// 1 Hz in this unit.
    pub const fn per_hertz(self) -> f64 {
        match self {
            Self::Hertz => 1.0,
            Self::Kilohertz => 1e-3,
            Self::RadianPerSecond => TAU,
            Self::RevolutionPerMinute => 60.0,
        }
    }

    /// One of it in Hz.
    pub const fn hertz(self) -> f64 {
        1.0 / self.per_hertz()
    }

    /// Parses a unit as measuring programs write it, ignoring case, with or without brackets: `(kHz)`, `rad/sec`.
    pub fn from_word(word: &str) -> Option<Self> {
        let left_out = |letter: char| letter.is_whitespace() || "()[]^.".contains(letter);
        let plain = word.replace(left_out, "").to_lowercase();
        Some(match plain.as_str() {
            "hz" | "hertz" | "cps" | "c/s" | "cycle/s" | "cycles/s" | "cycles/sec" => Self::Hertz,
            "khz" | "kilohertz" => Self::Kilohertz,
            "rad/s" | "rads/s" | "rad/sec" | "rads/sec" | "rad/second" | "radian/s"
            | "radians/s" | "radian/sec" | "radians/sec" | "radian/second" | "radians/second"
            | "rads-1" => Self::RadianPerSecond,
            "rpm" | "r/min" | "rev/min" | "revs/min" | "1/min" | "min-1" | "cpm" | "cycles/min" => {
                Self::RevolutionPerMinute
            }
            _ => return None,
        })
    }
}

impl PhaseUnit {
    /// One of it in rad.
    pub const fn radians(self) -> f64 {
        match self {
            Self::Degree => PI / 180.0,
            Self::Radian => 1.0,
        }
    }

    /// Parses a unit, ignoring case.
    pub(crate) fn from_word(word: &str) -> Option<Self> {
        match word.trim().to_lowercase().as_str() {
            "deg" | "deg." | "degree" | "degrees" | "grad" | "degré" | "degrés" | "degre"
            | "degres" | "°" | "º" => Some(Self::Degree),
            "rad" | "rad." | "radian" | "radians" | "radiant" => Some(Self::Radian),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frequency_words_of_other_programs_are_known() {
        use FrequencyUnit::{Hertz, Kilohertz, RadianPerSecond, RevolutionPerMinute};
        for (unit, words) in [
            (
                Hertz,
                &["Hz", "HZ", "hertz", "(Hz)", "[Hz]", "cps", "cycles/sec"][..],
            ),
            (Kilohertz, &["kHz", "KHZ", "(kHz)", "[ kHz ]"]),
            (
                RadianPerSecond,
                &[
                    "rad/s",
                    "rad/sec",
                    "RAD/SEC",
                    "Radians/Second",
                    "rad s^-1",
                    "rad.s-1",
                ],
            ),
            (
                RevolutionPerMinute,
                &["rpm", "RPM", "(rpm)", "rev/min", "cpm", "1/min"],
            ),
        ] {
            for word in words {
                assert_eq!(FrequencyUnit::from_word(word), Some(unit), "{word}");
            }
        }
        // Ambiguous (millihertz or megahertz; 1/s of hertz or rad): rejected.
        for word in ["", "mHz", "MHz", "GHz", "1/s", "rad", "order", "s", "deg/s"] {
            assert_eq!(FrequencyUnit::from_word(word), None, "{word}");
        }
    }

    /// Expected: the names in all earlier exported files.
    #[test]
    fn an_axis_and_a_column_are_named_by_quantity_and_unit() {
        let names = FrequencyUnit::ALL.map(|unit| (unit.heading(), unit.column()));
        let expected = [
            ("frequency, Hz", "frequency_hz"),
            ("frequency, kHz", "frequency_khz"),
            ("angular frequency, rad/s", "angular_frequency_rad_s"),
            ("speed, rpm", "speed_rpm"),
        ];
        assert_eq!(
            names.map(|(heading, column)| [heading, column]),
            expected.map(|(heading, column)| [heading.to_owned(), column.to_owned()])
        );
    }

    /// Closed form: 1 kHz is 1000 Hz, 1 rad/s is 1/(2 pi) Hz, 1 rpm is 1/60 Hz.
    #[test]
    fn one_of_each_is_so_many_hertz() {
        let hertz = FrequencyUnit::ALL.map(FrequencyUnit::hertz);
        assert_eq!(hertz, [1.0, 1e3, 1.0 / TAU, 1.0 / 60.0]);
    }

    #[test]
    fn what_is_said_to_be_accepted_are_all() {
        let listed = |words: &[&str]| {
            let (last, most) = words.split_last().unwrap();
            format!("{} or {last}", most.join(", "))
        };
        assert_eq!(listed(FrequencyUnit::WORDS), FrequencyUnit::ACCEPTED);
        let shown = FrequencyUnit::SHOWN.map(FrequencyUnit::symbol);
        assert_eq!(listed(&shown), FrequencyUnit::SHOWN_WORDS);
    }
}

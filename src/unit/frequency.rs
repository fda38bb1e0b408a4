//! Units of frequencies and phases.

use std::f64::consts::{PI, TAU};

/// In what a file gives its frequencies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrequencyUnit {
    /// Hz.
    Hertz,
    /// kHz.
    Kilohertz,
    /// rad/s.
    RadianPerSecond,
    /// Revolutions a minute.
    RevolutionPerMinute,
}

/// In what a file gives phases.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PhaseUnit {
    /// Degrees.
    Degree,
    /// rad.
    Radian,
}

impl FrequencyUnit {
    /// All four.
    pub const ALL: [Self; 4] = [
        Self::Hertz,
        Self::Kilohertz,
        Self::RadianPerSecond,
        Self::RevolutionPerMinute,
    ];

    /// The word of a layout.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Hertz => "hz",
            Self::Kilohertz => "khz",
            Self::RadianPerSecond => "rad/s",
            Self::RevolutionPerMinute => "rpm",
        }
    }

    /// The unit of a word as measuring programs write it, in whatever case, with or without brackets: `(kHz)`, `rad/sec`.
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

    /// One of it in Hz.
    pub const fn hertz(self) -> f64 {
        match self {
            Self::Hertz => 1.0,
            Self::Kilohertz => 1e3,
            Self::RadianPerSecond => 1.0 / TAU,
            Self::RevolutionPerMinute => 1.0 / 60.0,
        }
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

    /// The word of a layout.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Degree => "deg",
            Self::Radian => "rad",
        }
    }

    /// The unit of a word, in whatever case.
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
        // Millihertz or megahertz, 1/s of what: no guess.
        for word in ["", "mHz", "MHz", "GHz", "1/s", "rad", "order", "s", "deg/s"] {
            assert_eq!(FrequencyUnit::from_word(word), None, "{word}");
        }
    }
}

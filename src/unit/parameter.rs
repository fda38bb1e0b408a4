//! Units of parameters: how numbers are written for people, and the accepted spellings.
//!
//! Every spelling of a unit is a power of ten of it, so a conversion changes only the decimal exponent of a number, and
//! text from [`Unit::format_exact`] reads back to the last bit.

use super::plain_letter;

/// The unit of a number of the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unit {
    /// Its SI symbol: "N/m", "kg m2"; empty for a pure number.
    pub symbol: &'static str,
    /// Other spellings; first those that are shown, in descending order.
    spellings: &'static [Spelling],
}

/// Another spelling of a unit: a power of ten of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Spelling {
    text: &'static str,
    power: i32,
    /// The least decimal exponent of values that are shown with it; none if it is only read.
    shown_from: Option<i32>,
}

/// A spelling that is read, and shown from a decimal exponent on.
const fn shown(text: &'static str, power: i32, from: i32) -> Spelling {
    Spelling {
        text,
        power,
        shown_from: Some(from),
    }
}

/// A spelling that is only read.
const fn read(text: &'static str, power: i32) -> Spelling {
    Spelling {
        text,
        power,
        shown_from: None,
    }
}

/// A unit that starts with newton, pascal or hertz: shown with k, M, G; read also with m and the given spellings.
macro_rules! prefixed {
    ($symbol:literal $(, $text:literal => $power:literal)*) => {
        Unit {
            symbol: $symbol,
            spellings: &[
                shown(concat!("G", $symbol), 9, 9),
                shown(concat!("M", $symbol), 6, 6),
                shown(concat!("k", $symbol), 3, 3),
                read(concat!("m", $symbol), -3),
                $(read($text, $power)),*
            ],
        }
    };
}

/// A unit that is always shown without a prefix.
macro_rules! plain {
    ($symbol:literal $(, $text:literal => $power:literal)*) => {
        Unit { symbol: $symbol, spellings: &[$(read($text, $power)),*] }
    };
}

impl Unit {
    /// Every unit of the model.
    pub const ALL: &[Self] = &[
        Self::ONE,
        Self::METRE,
        Self::AREA,
        Self::METRE_4,
        Self::METRE_6,
        Self::PASCAL,
        Self::DENSITY,
        Self::KILOGRAM,
        Self::INERTIA,
        Self::STIFFNESS,
        Self::DAMPING,
        Self::ROTATIONAL_STIFFNESS,
        Self::ROTATIONAL_DAMPING,
        Self::LINE_STIFFNESS,
        Self::LINE_DAMPING,
        Self::TWIST_DAMPING,
        Self::WARPING_STIFFNESS,
        Self::WARPING_DAMPING,
        Self::WARPING_INERTIA,
        Self::FORCE,
        Self::TORQUE,
        Self::BIMOMENT,
        Self::DEGREE,
        Self::HERTZ,
    ];
    /// A pure number.
    pub const ONE: Self = plain!("");
    /// Length, m.
    pub const METRE: Self = Self {
        symbol: "m",
        spellings: &[
            shown("m", 0, -2),
            shown("mm", -3, -5),
            read("cm", -2),
            read("um", -6),
            read("km", 3),
        ],
    };
    /// Area, m2.
    pub const AREA: Self = Self {
        symbol: "m2",
        spellings: &[
            shown("m2", 0, 0),
            shown("cm2", -4, -4),
            shown("mm2", -6, -8),
        ],
    };
    /// Second moment of area, m4.
    pub const METRE_4: Self = plain!("m4", "cm4" => -8, "mm4" => -12);
    /// Warping constant, m6.
    pub const METRE_6: Self = plain!("m6", "cm6" => -12, "mm6" => -18);
    /// Modulus, Pa.
    pub const PASCAL: Self = prefixed!("Pa", "N/m2" => 0, "N/mm2" => 6, "kN/mm2" => 9);
    /// Density, kg/m3.
    pub const DENSITY: Self = plain!("kg/m3", "t/m3" => 3, "g/cm3" => 3);
    /// Mass, kg.
    pub const KILOGRAM: Self = plain!("kg", "g" => -3, "t" => 3);
    /// Mass moment of inertia, kg m2.
    pub const INERTIA: Self = plain!("kg m2", "kg cm2" => -4, "kg mm2" => -6, "t m2" => 3);
    /// Stiffness of a spring, N/m.
    pub const STIFFNESS: Self = prefixed!("N/m", "N/mm" => 3, "kN/mm" => 6);
    /// Damping of a dashpot, N s/m.
    pub const DAMPING: Self = prefixed!("N s/m", "N s/mm" => 3, "kN s/mm" => 6, "kg/s" => 0);
    /// Stiffness about an axis, N m/rad.
    pub const ROTATIONAL_STIFFNESS: Self = prefixed!("N m/rad", "N mm/rad" => -3, "kN mm/rad" => 0);
    /// Damping about an axis, N m s/rad.
    pub const ROTATIONAL_DAMPING: Self = prefixed!("N m s/rad", "N mm s/rad" => -3);
    /// Stiffness of a foundation: force per length and displacement, N/m2.
    pub const LINE_STIFFNESS: Self = prefixed!("N/m2", "N/mm2" => 6);
    /// Damping of a foundation, N s/m2.
    pub const LINE_DAMPING: Self = prefixed!("N s/m2");
    /// Damping of a foundation against twist, N s.
    pub const TWIST_DAMPING: Self = prefixed!("N s");
    /// Stiffness against warping: bimoment over rate of twist, N m3/rad.
    pub const WARPING_STIFFNESS: Self = prefixed!("N m3/rad");
    /// Damping against warping, N m3 s/rad.
    pub const WARPING_DAMPING: Self = prefixed!("N m3 s/rad");
    /// Inertia against warping, kg m4.
    pub const WARPING_INERTIA: Self = plain!("kg m4");
    /// Force, N.
    pub const FORCE: Self = prefixed!("N");
    /// Torque or moment, N m.
    pub const TORQUE: Self = prefixed!("N m", "N mm" => -3, "kN mm" => 0);
    /// Bimoment, N m2.
    pub const BIMOMENT: Self = prefixed!("N m2");
    /// Angle, degrees.
    pub const DEGREE: Self = plain!("deg", "°" => 0);
    /// Frequency, Hz.
    pub const HERTZ: Self = prefixed!("Hz");

    /// A value for reading: five significant digits and the unit with a suitable prefix, "40 MN/m".
    pub fn format(&self, value: f64) -> String {
        self.write(value, &format!("{value:.4e}"))
    }

    /// A value for editing: the shortest text with unit that reads back to the same bits, "16.66667 MN/m".
    pub fn format_exact(&self, value: f64) -> String {
        self.write(value, &format!("{value:e}"))
    }

    /// The accepted units after a number, for people: "N/m, GN/m, MN/m, kN/m, mN/m, N/mm, kN/mm".
    pub fn accepted(&self) -> String {
        let others = self
            .spellings
            .iter()
            .map(|spelling| spelling.text)
            .filter(|text| *text != self.symbol);
        std::iter::once(self.symbol)
            .chain(others)
            .collect::<Vec<_>>()
            .join(", ")
    }

    /// The power of ten of a spelling; none if it is not a spelling of this unit.
    ///
    /// Ignores spaces, `*`, `·` and `^`; superscripts are digits, and `/rad` is optional.
    pub(super) fn power_of(&self, text: &str) -> Option<i32> {
        let text = bare(text);
        if text.is_empty() {
            return None;
        }
        if text == bare(self.symbol) {
            return Some(0);
        }
        self.spellings
            .iter()
            .find(|spelling| bare(spelling.text) == text)
            .map(|spelling| spelling.power)
    }

    fn write(&self, value: f64, scientific: &str) -> String {
        let Some(mut decimal) = Decimal::read(scientific) else {
            return format!("{value} {}", self.symbol).trim_end().to_owned();
        };
        let fits = |spelling: &&Spelling| {
            spelling
                .shown_from
                .is_some_and(|from| decimal.exponent >= from)
        };
        let found = self.spellings.iter().find(fits).filter(|_| value != 0.0);
        let (text, power) =
            found.map_or((self.symbol, 0), |spelling| (spelling.text, spelling.power));
        decimal.exponent -= power;
        format!("{} {text}", decimal.text()).trim_end().to_owned()
    }
}

/// Removes separators between the factors of a unit, for comparison.
fn bare(text: &str) -> String {
    let text: String = text
        .chars()
        .filter_map(|letter| match letter {
            ' ' | '*' | '^' | '·' | '⋅' => None,
            '⁴' => Some('4'),
            '⁶' => Some('6'),
            other => Some(plain_letter(other)),
        })
        .collect();
    text.strip_suffix("/rad")
        .map_or(text.clone(), str::to_owned)
}

/// A number by its decimal digits: d.ddd times ten to the exponent.
struct Decimal {
    negative: bool,
    /// At least one digit; no trailing zeros.
    digits: String,
    exponent: i32,
}

impl Decimal {
    /// Parses the format `{:e}`; none if that is not a number.
    fn read(scientific: &str) -> Option<Self> {
        let (mantissa, exponent) = scientific.split_once('e')?;
        let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
        let trimmed = digits.trim_end_matches('0');
        let digits = if trimmed.is_empty() { "0" } else { trimmed };
        Some(Self {
            negative: mantissa.starts_with('-'),
            digits: digits.to_owned(),
            exponent: exponent.parse().ok()?,
        })
    }

    /// Without an exponent from 0.001 to below a million, else with one.
    fn text(&self) -> String {
        let sign = if self.negative { "-" } else { "" };
        let digits = &self.digits;
        let body = match self.exponent {
            -3..0 => format!(
                "0.{}{digits}",
                "0".repeat(self.exponent.unsigned_abs() as usize - 1)
            ),
            0..6 => {
                let whole = self.exponent as usize + 1;
                if digits.len() > whole {
                    format!("{}.{}", &digits[..whole], &digits[whole..])
                } else {
                    format!("{digits:0<whole$}")
                }
            }
            exponent if digits.len() == 1 => format!("{digits}e{exponent}"),
            exponent => format!("{}.{}e{exponent}", &digits[..1], &digits[1..]),
        };
        format!("{sign}{body}")
    }
}

/// A count with commas as thousands separators.
pub fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A count and its noun, singular for one: `1 row`, `2,000 rows`.
pub fn counted(count: usize, one: &str, more: &str) -> String {
    format!("{} {}", grouped(count), if count == 1 { one } else { more })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_value_is_shown_with_five_digits_and_a_fitting_prefix() {
        let cases: &[(Unit, f64, &str)] = &[
            (Unit::STIFFNESS, 4.0e7, "40 MN/m"),
            (Unit::STIFFNESS, 1.666_667e7, "16.667 MN/m"),
            (Unit::STIFFNESS, 0.0, "0 N/m"),
            (Unit::STIFFNESS, 999_999.0, "1 MN/m"),
            (Unit::STIFFNESS, 0.5, "0.5 N/m"),
            (Unit::STIFFNESS, 1e30, "1e21 GN/m"),
            (Unit::DAMPING, 66.67, "66.67 N s/m"),
            (Unit::DAMPING, 1200.0, "1.2 kN s/m"),
            (Unit::INERTIA, 53.33, "53.33 kg m2"),
            (Unit::PASCAL, 2.1e11, "210 GPa"),
            (Unit::METRE, 0.8, "0.8 m"),
            (Unit::METRE, -0.055, "-0.055 m"),
            (Unit::METRE, 0.0015, "1.5 mm"),
            (Unit::METRE, 1e-9, "1e-9 m"),
            (Unit::METRE, 1234.0, "1234 m"),
            (Unit::AREA, 0.0116, "116 cm2"),
            (Unit::AREA, 2.5, "2.5 m2"),
            (Unit::METRE_4, 1.6625e-4, "1.6625e-4 m4"),
            (Unit::METRE_6, 2.2783e-8, "2.2783e-8 m6"),
            (Unit::KILOGRAM, 100_000.0, "100000 kg"),
            (Unit::KILOGRAM, 1_000_000.0, "1e6 kg"),
            (Unit::ONE, 0.02, "0.02"),
            (Unit::DEGREE, -90.0, "-90 deg"),
            (Unit::HERTZ, 2200.0, "2.2 kHz"),
            (Unit::HERTZ, f64::NAN, "NaN Hz"),
        ];
        for (unit, value, text) in cases {
            assert_eq!(unit.format(*value), *text);
        }
    }

    #[test]
    fn an_exact_text_has_all_digits() {
        assert_eq!(Unit::STIFFNESS.format_exact(1.666_667e7), "16.66667 MN/m");
        assert_eq!(Unit::METRE.format_exact(-0.0), "-0 m");
        assert_eq!(Unit::ONE.format_exact(0.1 + 0.2), "0.30000000000000004");
    }

    #[test]
    fn a_unit_is_known_by_many_spellings() {
        let cases: &[(Unit, &str, Option<i32>)] = &[
            (Unit::STIFFNESS, "N / m", Some(0)),
            (Unit::STIFFNESS, "MN/m", Some(6)),
            (Unit::STIFFNESS, "N/mm", Some(3)),
            (Unit::STIFFNESS, "N", None),
            (Unit::DAMPING, "N·s/m", Some(0)),
            (Unit::DAMPING, "N*s/m", Some(0)),
            (Unit::ROTATIONAL_STIFFNESS, "MNm/rad", Some(6)),
            (Unit::ROTATIONAL_STIFFNESS, "kN m", Some(3)),
            (Unit::INERTIA, "kg m²", Some(0)),
            (Unit::INERTIA, "kg*m^2", Some(0)),
            (Unit::METRE, "m", Some(0)),
            (Unit::METRE, "µm", Some(-6)),
            (Unit::METRE_4, "cm⁴", Some(-8)),
            (Unit::DEGREE, "°", Some(0)),
            (Unit::ONE, "", None),
            (Unit::ONE, "m", None),
        ];
        for (unit, text, power) in cases {
            assert_eq!(unit.power_of(text), *power, "{text} as {}", unit.symbol);
        }
    }

    #[test]
    fn what_is_accepted_starts_with_the_unit_itself() {
        assert_eq!(Unit::METRE.accepted(), "m, mm, cm, um, km");
        assert_eq!(
            Unit::STIFFNESS.accepted(),
            "N/m, GN/m, MN/m, kN/m, mN/m, N/mm, kN/mm"
        );
    }

    proptest! {
        #[test]
        fn a_shown_value_is_right_to_five_digits(mantissa in 1.0..10.0_f64, exponent in -12..12_i32) {
            let value = mantissa * 10_f64.powi(exponent);
            for unit in [Unit::STIFFNESS, Unit::METRE, Unit::AREA, Unit::KILOGRAM] {
                let text = unit.format(value);
                let (number, symbol) = text.split_once(' ').unwrap();
                let shown = number.parse::<f64>().unwrap() * 10_f64.powi(unit.power_of(symbol).unwrap());
                prop_assert!((shown / value - 1.0).abs() < 5.1e-5, "{} as {}", value, text);
            }
        }
    }

    #[test]
    fn thousands_have_commas() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(2_000), "2,000");
        assert_eq!(grouped(1_000_000), "1,000,000");
    }

    #[test]
    fn one_is_singular() {
        let rows = |count| counted(count, "row", "rows");
        assert_eq!([0, 1, 2].map(rows), ["0 rows", "1 row", "2 rows"]);
    }
}

//! Units of measured values: what a text such as `mm/s2/N` says of what moves, how, and per what load.

use std::fmt;

use num_complex::Complex64;

use crate::model::Measure;
use crate::solve::form::{Dimension, Form, Load, Moves};

/// What the values of a curve are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A motion, or a motion over a load.
    Motion(Dimension),
    /// A vibration energy, kg m2, real.
    Energy,
}

/// The unit in which a file gives values, and what they are because of it.
///
/// Its text is a motion (`m`, `mm/s`, `g`, `rad/s2`), a motion over a load (`m/s2/N`, `g/lbf`, `rad/(N m)`), a load over
/// a motion (`N/m`, `N s/m`, `kg`), or `kg m2` for an energy; a number may stand in front (`1e-6 m/N`). `g` is standard
/// gravity, 9.80665 m/s2, and not a gram.
#[derive(Debug, Clone, PartialEq)]
pub struct ValueUnit {
    text: String,
    kind: Kind,
    /// One of it in SI.
    scale: f64,
    /// Whether the load stands above the motion.
    inverse: bool,
}

/// What is accepted where a unit is wanted.
pub(super) const ACCEPTED: &str = "accepted is a motion (m, mm, um, in, rad, deg; m/s, mm/s; m/s2, g) alone or over a \
    load (m/s2/N, g/lbf, rad/(N m)), the inverse (N/m, N s/m, kg), or kg m2 for an energy; a number may stand in front \
    (1e-6 m/N)";

/// Longest text of a unit, bytes.
const LONGEST: usize = 60;

/// Powers of metre, kilogram, second and radian.
type Powers = [i32; 4];

const FORCE: Powers = [1, 1, -2, 0];

/// A symbol, one of it in SI, and its powers. Inch, foot and pound-force: NIST Special Publication 811 (2008).
const SYMBOLS: &[(&str, f64, Powers)] = &[
    ("m", 1.0, [1, 0, 0, 0]),
    ("cm", 1e-2, [1, 0, 0, 0]),
    ("mm", 1e-3, [1, 0, 0, 0]),
    ("um", 1e-6, [1, 0, 0, 0]),
    ("nm", 1e-9, [1, 0, 0, 0]),
    ("in", 0.0254, [1, 0, 0, 0]),
    ("ft", 0.3048, [1, 0, 0, 0]),
    ("s", 1.0, [0, 0, 1, 0]),
    ("g", 9.806_65, [1, 0, -2, 0]),
    ("kg", 1.0, [0, 1, 0, 0]),
    ("N", 1.0, FORCE),
    ("mN", 1e-3, FORCE),
    ("kN", 1e3, FORCE),
    ("MN", 1e6, FORCE),
    ("lbf", 4.448_221_615_260_5, FORCE),
    ("Nm", 1.0, [2, 1, -2, 0]),
    ("rad", 1.0, [0, 0, 0, 1]),
    ("mrad", 1e-3, [0, 0, 0, 1]),
    ("urad", 1e-6, [0, 0, 0, 1]),
    ("deg", std::f64::consts::PI / 180.0, [0, 0, 0, 1]),
    ("°", std::f64::consts::PI / 180.0, [0, 0, 0, 1]),
];

impl Kind {
    /// Its SI unit: `m/(N s2)`, `rad`, `kg m2`.
    pub fn unit(&self) -> String {
        match self {
            Self::Motion(dimension) => dimension.unit(dimension.form_of_measure()),
            Self::Energy => "kg m2".to_owned(),
        }
    }
}

impl ValueUnit {
    /// Reads a unit.
    ///
    /// # Errors
    /// Says what is wrong and what is accepted.
    pub fn parse(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let wrong = || format!("{text:?} is no unit of a response: {ACCEPTED}");
        let (factor, symbols) = factor(text);
        let (scale, powers) = product(symbols).ok_or_else(wrong)?;
        let scale = factor * scale;
        if !(scale.is_normal() && scale > 0.0) {
            return Err(wrong());
        }
        let (kind, inverse) = kind_of(symbols, powers).ok_or_else(wrong)?;
        Ok(Self {
            text: text.to_owned(),
            kind,
            scale,
            inverse,
        })
    }

    /// The SI unit of a kind.
    pub fn si(kind: Kind) -> Self {
        Self {
            text: kind.unit(),
            kind,
            scale: 1.0,
            inverse: false,
        }
    }

    /// A unit that is so many SI units of a kind, or so many of their inverse.
    pub(super) fn scaled(kind: Kind, scale: f64, inverse: bool) -> Self {
        Self {
            text: kind.unit(),
            kind,
            scale,
            inverse,
        }
    }

    /// What values in it are; a load over a motion becomes the motion over the load.
    pub const fn kind(&self) -> Kind {
        self.kind
    }

    /// A value in it, in the SI unit of its kind; not finite where the inverse of 0 is wanted.
    pub fn to_si(&self, value: Complex64) -> Complex64 {
        if self.inverse {
            (value * self.scale).finv()
        } else {
            value * self.scale
        }
    }

    /// How many of another unit of the same quantity it is; none for another quantity.
    pub fn in_units_of(&self, other: &Self) -> Option<f64> {
        let same = (self.kind, self.inverse) == (other.kind, other.inverse);
        same.then_some(self.scale / other.scale)
    }

    /// One of it in SI, and whether the load stands above the motion.
    pub(super) const fn ratio(&self) -> (f64, bool) {
        (self.scale, self.inverse)
    }
}

/// The text it was read from.
impl fmt::Display for ValueUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// A load's unit (`N`, `kN`, `lbf`, `N m`, `N m2`) and one of it in SI.
pub(super) fn load(text: &str) -> Option<(Load, f64)> {
    let (scale, powers) = product(text)?;
    let loads = [Load::Force, Load::Moment, Load::Bimoment];
    let load = loads
        .into_iter()
        .find(|load| powers_of_load(Some(*load)) == powers)?;
    Some((load, scale))
}

/// The number in front and the rest.
fn factor(text: &str) -> (f64, &str) {
    let split = text.split_once(char::is_whitespace);
    match split.and_then(|(first, rest)| Some((first.parse().ok()?, rest.trim()))) {
        Some(parts) => parts,
        None => (1.0, text),
    }
}

/// The value in SI and the powers of a product of symbols with `/` and brackets. A `/` holds for the next factor alone.
fn product(text: &str) -> Option<(f64, Powers)> {
    if text.is_empty() || text.len() > LONGEST {
        return None;
    }
    let plain = plain(text);
    let mut rest = plain.as_str();
    let (mut scale, mut powers) = (1.0, [0; 4]);
    let mut signs = vec![1];
    let mut next = 1;
    while let Some(letter) = rest.chars().next() {
        let outer = *signs.last()?;
        match letter {
            ' ' => rest = &rest[1..],
            '/' if next == 1 => (next, rest) = (-1, &rest[1..]),
            '(' => {
                signs.push(outer * next);
                (next, rest) = (1, &rest[1..]);
            }
            ')' if signs.len() > 1 && next == 1 => {
                signs.pop();
                rest = &rest[1..];
            }
            _ => {
                let (one, of, power, after) = symbol(rest)?;
                let power = power * outer * next;
                scale *= one.powi(power);
                for (sum, part) in powers.iter_mut().zip(of) {
                    *sum += part * power;
                }
                (next, rest) = (1, after);
            }
        }
    }
    (signs.len() == 1 && next == 1).then_some((scale, powers))
}

/// The text with plain letters for superscripts, dots and hats.
fn plain(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '²' => plain.push('2'),
            '³' => plain.push('3'),
            '⁻' | '−' => plain.push('-'),
            'µ' | 'μ' => plain.push('u'),
            '·' | '⋅' | '*' | '\t' => plain.push(' '),
            '^' => {}
            other => plain.push(other),
        }
    }
    plain
}

/// The symbol at the start of a text: one of it in SI, its powers, its exponent, and what follows.
fn symbol(text: &str) -> Option<(f64, Powers, i32, &str)> {
    // The number 1 has no powers: 1/kg.
    if let Some(rest) = text.strip_prefix('1') {
        return (!rest.starts_with(|next: char| next.is_alphanumeric() || next == '.'))
            .then_some((1.0, [0; 4], 1, rest));
    }
    let letters = |letter: char| letter.is_alphabetic() || letter == '°';
    let end = text.find(|letter| !letters(letter)).unwrap_or(text.len());
    let (name, rest) = text.split_at(end);
    let (_, one, powers) = SYMBOLS.iter().find(|(symbol, ..)| *symbol == name)?;
    let (sign, digits) = match rest.strip_prefix('-') {
        Some(rest) => (-1, rest),
        None => (1, rest),
    };
    match digits.chars().next().and_then(|digit| digit.to_digit(10)) {
        Some(exponent) => Some((*one, *powers, sign * exponent as i32, &digits[1..])),
        None if sign == 1 => Some((*one, *powers, 1, rest)),
        None => None,
    }
}

/// What has these powers. Of some that share them, the first whose SI unit is the text; else a rate of twist where
/// `rad/m` stands first, and a rotation where it does not.
fn kind_of(text: &str, powers: Powers) -> Option<(Kind, bool)> {
    let found: Vec<(Dimension, Form)> = candidates()
        .filter(|(dimension, form)| powers_of(*dimension, *form) == powers)
        .collect();
    let exact = found
        .iter()
        .find(|(dimension, form)| dimension.unit(*form) == text);
    let twist = ["rad/m", "rad/(m"].iter().any(|start| {
        text.strip_prefix(start)
            .is_some_and(|rest| !rest.starts_with(char::is_alphabetic))
    });
    let alike = |(dimension, form): &&(Dimension, Form)| {
        // A moment over a length is a force: nobody means that by it.
        let shrinks = dimension.moves == Moves::Length && dimension.per != Some(Load::Force);
        (dimension.moves == Moves::TwistRate) == twist && !(form.is_inverse() && shrinks)
    };
    if exact.is_none() && powers == [2, 1, 0, 0] {
        return Some((Kind::Energy, false));
    }
    let (dimension, form) = exact.or_else(|| found.iter().find(alike))?;
    Some((Kind::Motion(*dimension), form.is_inverse()))
}

/// Every motion over every load, and every load over every motion, the usual first.
fn candidates() -> impl Iterator<Item = (Dimension, Form)> {
    let moves = [Moves::Length, Moves::Angle, Moves::TwistRate];
    let loads = [
        None,
        Some(Load::Force),
        Some(Load::Moment),
        Some(Load::Bimoment),
    ];
    moves.into_iter().flat_map(move |moves| {
        loads.into_iter().flat_map(move |per| {
            let of = move |form: Form| {
                let measure = form.measure();
                let dimension = Dimension {
                    moves,
                    measure,
                    per,
                };
                (dimension, form)
            };
            let all = Form::ALL.into_iter().map(of);
            all.filter(|(dimension, form)| dimension.has(*form))
        })
    })
}

fn powers_of(dimension: Dimension, form: Form) -> Powers {
    let mut powers = match dimension.moves {
        Moves::Length => [1, 0, 0, 0],
        Moves::Angle => [0, 0, 0, 1],
        Moves::TwistRate => [-1, 0, 0, 1],
    };
    powers[2] -= match form.measure() {
        Measure::Displacement => 0,
        Measure::Velocity => 1,
        Measure::Acceleration => 2,
    };
    for (sum, part) in powers.iter_mut().zip(powers_of_load(dimension.per)) {
        *sum -= part;
    }
    if form.is_inverse() {
        powers = powers.map(|power| -power);
    }
    powers
}

fn powers_of_load(load: Option<Load>) -> Powers {
    match load {
        None => [0; 4],
        Some(Load::Force) => FORCE,
        Some(Load::Moment) => [2, 1, -2, 0],
        Some(Load::Bimoment) => [3, 1, -2, 0],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion(moves: Moves, measure: Measure, per: Option<Load>) -> Kind {
        Kind::Motion(Dimension {
            moves,
            measure,
            per,
        })
    }

    /// Expected: the SI brochure (9th ed. 2019) for prefixes and g, NIST SP 811 for the rest.
    #[test]
    fn units_say_what_moves_and_how_much() {
        use Measure::{Acceleration, Displacement, Velocity};
        use Moves::{Angle, Length, TwistRate};
        let (force, moment) = (Some(Load::Force), Some(Load::Moment));
        for (text, kind, value) in [
            ("m", motion(Length, Displacement, None), 1.0),
            ("mm/s", motion(Length, Velocity, None), 1e-3),
            ("g", motion(Length, Acceleration, None), 9.80665),
            ("m/s2/N", motion(Length, Acceleration, force), 1.0),
            ("(m/s^2)/N", motion(Length, Acceleration, force), 1.0),
            ("m/(N s2)", motion(Length, Acceleration, force), 1.0),
            ("m s-2 N-1", motion(Length, Acceleration, force), 1.0),
            ("1/kg", motion(Length, Acceleration, force), 1.0),
            (
                "g/lbf",
                motion(Length, Acceleration, force),
                9.80665 / 4.448_221_615_260_5,
            ),
            ("µm/kN", motion(Length, Displacement, force), 1e-9),
            (
                "in/lbf",
                motion(Length, Displacement, force),
                0.0254 / 4.448_221_615_260_5,
            ),
            ("rad/(N·m)", motion(Angle, Displacement, moment), 1.0),
            ("rad/Nm", motion(Angle, Displacement, moment), 1.0),
            (
                "deg/s/N",
                motion(Angle, Velocity, force),
                std::f64::consts::PI / 180.0,
            ),
            ("m/(N m)", motion(Length, Displacement, moment), 1.0),
            ("rad/m/N", motion(TwistRate, Displacement, force), 1.0),
            ("1e-6 m/N", motion(Length, Displacement, force), 1e-6),
            ("kg m2", Kind::Energy, 1.0),
        ] {
            let unit = ValueUnit::parse(text).unwrap();
            let one = unit.to_si(1.0.into());
            assert_eq!(unit.kind(), kind, "{text}");
            assert!(
                (one.re / value - 1.0).abs() < 1e-15 && one.im == 0.0,
                "{text}: {one}"
            );
            assert_eq!(unit.to_string(), text);
        }
    }

    #[test]
    fn a_load_over_a_motion_is_turned() {
        let unit = ValueUnit::parse("kN/mm").unwrap();
        let receptance = motion(Moves::Length, Measure::Displacement, Some(Load::Force));
        assert_eq!(unit.kind(), receptance);
        let half = unit.to_si(Complex64::new(0.0, 2.0));
        assert!((half - Complex64::new(0.0, -5e-7)).norm() < 1e-21, "{half}");
        assert!(!unit.to_si(0.0.into()).is_finite());
        let mass = ValueUnit::parse("kg").unwrap();
        assert_eq!(
            mass.kind(),
            motion(Moves::Length, Measure::Acceleration, Some(Load::Force))
        );
    }

    #[test]
    fn the_si_unit_of_every_kind_is_read_as_that_kind() {
        for (dimension, form) in candidates() {
            let unit = dimension.unit(form);
            let read = ValueUnit::parse(&unit).unwrap();
            // These are rotations over moments by the same text.
            if dimension.moves == Moves::TwistRate && form.is_inverse() {
                continue;
            }
            assert_eq!(read.kind(), Kind::Motion(dimension), "{unit}");
            assert_eq!(read.ratio(), (1.0, form.is_inverse()), "{unit}");
        }
    }

    #[test]
    fn what_is_no_unit_is_refused_with_what_is() {
        for text in [
            "", "N m", "x", "m/", "/", "m//s", "(m", "m)", "m/s-", "s", "N", "0 m", "-1 m",
            "1e400 m", "nan m", "m44", "10/kg", "1.5/kg", "grams/N", "m/s2/N/N", "((((", "😀",
        ] {
            let message = ValueUnit::parse(text).unwrap_err();
            assert!(message.contains("accepted is"), "{message}");
        }
        assert!(ValueUnit::parse(&"m ".repeat(100)).is_err());
    }
}

//! Units of measured values: parses a text such as `mm/s2/N` to a motion, its measure and a load.

mod product;
mod symbols;

use std::fmt;

use num_complex::Complex64;
use product::{is_twist, plain, product};

use super::{Amount, Dimension, Form, Kind, Load, Moves};

/// The unit of values in a file, and the dimension that it implies.
///
/// Its text is a motion (`m`, `mm/s`, `g`, `rad/s2`), a motion over a load (`m/s2/N`, `g/lbf`, `rad/(N m)`), a load
/// over a motion (`N/m`, `N s/m`, `kg`), or `kg m2` for an energy; a number may precede it (`1e-6 m/N`). `g` is
/// standard gravity, 9.80665 m/s2, not a gram. Spellings of measuring programs are also accepted: `Gs/N`, `mm/sec`,
/// `microns/LBF`, `rad/lbf-in`.
#[derive(Debug, Clone, PartialEq)]
pub struct ValueUnit {
    text: String,
    kind: Kind,
    /// Its SI factor.
    scale: f64,
    /// Whether the load is the numerator.
    inverse: bool,
}

/// The accepted units, for messages.
const ACCEPTED: &str = "accepted is a motion (m, mm, um, in, rad, deg; m/s, mm/s; m/s2, g) alone or over a \
    load (m/s2/N, g/lbf, rad/(N m)), the inverse (N/m, N s/m, kg), or kg m2 for an energy; a number may stand in front \
    (1e-6 m/N)";

/// Powers of metre, kilogram, second and radian.
type Powers = [i32; 4];

const FORCE: Powers = [1, 1, -2, 0];

impl ValueUnit {
    /// Reads a unit.
    ///
    /// # Errors
    /// The error and what is accepted.
    pub fn parse(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let wrong = || format!("{text:?} is not a unit of a response: {ACCEPTED}");
        let (factor, symbols) = factor(text);
        let (scale, powers) = product(symbols).ok_or_else(wrong)?;
        let scale = factor * scale;
        if !(scale.is_normal() && scale > 0.0) {
            return Err(wrong());
        }
        let (kind, inverse) = kind_of(&plain(symbols), powers).ok_or_else(wrong)?;
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

    /// A unit of a kind with a factor to SI, or of its inverse.
    pub(crate) fn scaled(kind: Kind, scale: f64, inverse: bool) -> Self {
        Self {
            text: kind.unit(),
            kind,
            scale,
            inverse,
        }
    }

    /// The kind of values in it; a load over a motion becomes the motion over the load.
    pub const fn kind(&self) -> Kind {
        self.kind
    }

    /// Converts a value to the SI unit of its kind; the inverse of 0 is not finite.
    pub fn to_si(&self, value: Complex64) -> Complex64 {
        if self.inverse {
            (value * self.scale).finv()
        } else {
            value * self.scale
        }
    }

    /// The factor to another unit of the same quantity; none for another quantity.
    pub fn in_units_of(&self, other: &Self) -> Option<f64> {
        let same = (self.kind, self.inverse) == (other.kind, other.inverse);
        same.then_some(self.scale / other.scale)
    }

    /// Its SI factor, and whether the load is the numerator.
    pub(crate) const fn ratio(&self) -> (f64, bool) {
        (self.scale, self.inverse)
    }
}

/// Its original text.
impl fmt::Display for ValueUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Parses the unit of a load (`N`, `kN`, `lbf`, `N m`, `N m2`), with its SI factor.
pub(crate) fn load(text: &str) -> Option<(Load, f64)> {
    let (scale, powers) = product(text)?;
    let load = Load::ALL
        .into_iter()
        .find(|load| powers_of_amount(Amount::Load(*load)) == powers)?;
    Some((load, scale))
}

/// The leading number and the rest.
fn factor(text: &str) -> (f64, &str) {
    let split = text.split_once(char::is_whitespace);
    match split.and_then(|(first, rest)| Some((first.parse().ok()?, rest.trim()))) {
        Some(parts) => parts,
        None => (1.0, text),
    }
}

/// The kind with these powers. If several have them, the first whose SI unit is the text; else a rate of twist if the
/// text starts with an angle over a length (`rad/m`), and a rotation otherwise.
fn kind_of(text: &str, powers: Powers) -> Option<(Kind, bool)> {
    let found: Vec<(Dimension, Form)> = candidates()
        .filter(|(dimension, form)| powers_of(*dimension, *form) == powers)
        .collect();
    let exact = found
        .iter()
        .find(|(dimension, form)| dimension.unit(*form) == text);
    let alike = |(dimension, form): &&(Dimension, Form)| {
        // A moment over a length is a force, but is never used for one.
        let moves = |own: Moves| matches!(dimension.of, Amount::Motion(moves, _) if moves == own);
        let shrinks = moves(Moves::Length) && dimension.per != Some(Amount::Load(Load::Force));
        moves(Moves::TwistRate) == is_twist(text) && !(form.is_inverse() && shrinks)
    };
    if exact.is_none() && powers == [2, 1, 0, 0] {
        return Some((Kind::Energy, false));
    }
    let (dimension, form) = exact.or_else(|| found.iter().find(alike))?;
    Some((Kind::Amplitude(*dimension), form.is_inverse()))
}

/// Every motion over every load, and every load over every motion, the usual first.
fn candidates() -> impl Iterator<Item = (Dimension, Form)> {
    let moves = [Moves::Length, Moves::Angle, Moves::TwistRate];
    let loads = [None].into_iter().chain(Load::ALL.map(Some));
    moves.into_iter().flat_map(move |moves| {
        loads.clone().flat_map(move |per| {
            let of = move |form: Form| (Dimension::of_motion(moves, form.measure(), per), form);
            let all = Form::ALL.into_iter().map(of);
            all.filter(|(dimension, form)| dimension.has(*form))
        })
    })
}

fn powers_of(dimension: Dimension, form: Form) -> Powers {
    let mut powers = powers_of_amount(dimension.of);
    for (sum, part) in powers
        .iter_mut()
        .zip(dimension.per.map_or([0; 4], powers_of_amount))
    {
        *sum -= part;
    }
    if form.is_inverse() {
        powers = powers.map(|power| -power);
    }
    powers
}

fn powers_of_amount(amount: Amount) -> Powers {
    match amount {
        Amount::Motion(moves, measure) => {
            let mut powers = match moves {
                Moves::Length => [1, 0, 0, 0],
                Moves::Angle => [0, 0, 0, 1],
                Moves::TwistRate => [-1, 0, 0, 1],
            };
            powers[2] -= measure.order();
            powers
        }
        Amount::Load(Load::Force) => FORCE,
        Amount::Load(Load::Moment) => [2, 1, -2, 0],
        Amount::Load(Load::Bimoment) => [3, 1, -2, 0],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::Measure;

    fn motion(moves: Moves, measure: Measure, per: Option<Load>) -> Kind {
        Kind::Amplitude(Dimension::of_motion(moves, measure, per))
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
            ("mrad/m/N", motion(TwistRate, Displacement, force), 1e-3),
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

    /// Expected: NIST SP 811, appendix B.8: 1 lbf = 4.448222 N, 1 kgf = 9.80665 N, 1 dyn = 1e-5 N, 1 ozf = 0.2780139 N,
    /// 1 poundal = 0.138255 N, 1 lbf in = 0.1129848 N m, 1 lbf ft = 1.355818 N m, 1 slug = 14.59390 kg, 1 mil = 2.54e-5
    /// m, 1 mi/h = 0.44704 m/s, 1 Gal = 0.01 m/s2.
    fn are_known(words: &[(&[&str], Kind, f64)]) {
        for (texts, kind, value) in words {
            for text in *texts {
                let unit = ValueUnit::parse(text).unwrap();
                let one = unit.to_si(1.0.into()).re;
                assert_eq!(unit.kind(), *kind, "{text}");
                assert!((one / value - 1.0).abs() < 3e-6, "{text}: {one}");
            }
        }
    }

    #[test]
    fn the_words_of_other_programs_for_motions_are_known() {
        use Measure::{Acceleration, Displacement, Velocity};
        use Moves::{Angle, Length};
        are_known(&[
            (
                &["G", "Gs", "gs", "g's", "G’s", "gn", "[g]", "(G)"][..],
                motion(Length, Acceleration, None),
                9.80665,
            ),
            (&["mg"], motion(Length, Acceleration, None), 9.80665e-3),
            (
                &["Gal", "cm/sec/sec"],
                motion(Length, Acceleration, None),
                1e-2,
            ),
            (
                &[
                    "m/sec^2",
                    "m/sec**2",
                    "M/SEC^2",
                    "m/s/s",
                    "m.s-2",
                    "m/(s.s)",
                    "meter/second^2",
                ],
                motion(Length, Acceleration, None),
                1.0,
            ),
            (
                &["in/s-s", "in./sec.^2"],
                motion(Length, Acceleration, None),
                0.0254,
            ),
            (&["mm/sec", "MM/S"], motion(Length, Velocity, None), 1e-3),
            (
                &["ips", "IPS", "inch/sec"],
                motion(Length, Velocity, None),
                0.0254,
            ),
            (&["mph"], motion(Length, Velocity, None), 0.44704),
            (&["km/h", "kph"], motion(Length, Velocity, None), 1.0 / 3.6),
            (
                &["micron", "microns", "Microns", "UM"],
                motion(Length, Displacement, None),
                1e-6,
            ),
            (
                &["mil", "mils", "MILS"],
                motion(Length, Displacement, None),
                2.54e-5,
            ),
            (
                &["IN", "inch", "inches"],
                motion(Length, Displacement, None),
                0.0254,
            ),
            (
                &["ft", "FEET", "foot"],
                motion(Length, Displacement, None),
                0.3048,
            ),
            (
                &["DEG", "degrees"],
                motion(Angle, Displacement, None),
                std::f64::consts::PI / 180.0,
            ),
            (
                &["rpm", "rev/min"],
                motion(Angle, Velocity, None),
                std::f64::consts::PI / 30.0,
            ),
        ]);
    }

    #[test]
    fn the_words_of_other_programs_for_motions_per_load_are_known() {
        use Measure::{Acceleration, Displacement, Velocity};
        use Moves::{Angle, Length};
        let (force, moment) = (Some(Load::Force), Some(Load::Moment));
        are_known(&[
            (
                &["Gs/N", "G/N"][..],
                motion(Length, Acceleration, force),
                9.80665,
            ),
            (
                &["g/LBF", "G/lbf", "g/lb", "Gs/lbs"],
                motion(Length, Acceleration, force),
                9.80665 / 4.448_222,
            ),
            (&["g/kgf", "G/kp"], motion(Length, Acceleration, force), 1.0),
            (&["m/dyn"], motion(Length, Displacement, force), 1e5),
            (
                &["m/ozf"],
                motion(Length, Displacement, force),
                1.0 / 0.278_013_9,
            ),
            (
                &["m/pdl"],
                motion(Length, Displacement, force),
                1.0 / 0.138_255,
            ),
            (
                &["rad/lbf-in", "rad/(lbf.in)", "RAD/IN-LBF"],
                motion(Angle, Displacement, moment),
                1.0 / 0.112_984_8,
            ),
            (
                &["rad/ft-lbf"],
                motion(Angle, Displacement, moment),
                1.0 / 1.355_818,
            ),
            (
                &["rad/N.m", "rad/N-m", "rad/N·m"],
                motion(Angle, Displacement, moment),
                1.0,
            ),
            (&["m/N-s", "m/N·s"], motion(Length, Velocity, force), 1.0),
            (
                &["1/slug", "ft/lbf/sec^2"],
                motion(Length, Acceleration, force),
                1.0 / 14.5939,
            ),
            (&["1/KG", "1/Kg"], motion(Length, Acceleration, force), 1.0),
        ]);
    }

    /// If the case of a letter matters, the other case is rejected.
    #[test]
    fn prefixes_keep_their_case() {
        let scale = |text: &str| ValueUnit::parse(text).map(|unit| unit.ratio().0);
        for (text, value) in [
            ("m/mN", 1e3),
            ("m/MN", 1e-6),
            ("m/GN", 1e-9),
            ("rad/mNm", 1e3),
            ("rad/MNm", 1e-6),
            ("nm/N", 1e-9),
            ("rad/Nm", 1.0),
            ("mg/N", 9.80665e-3),
        ] {
            assert!((scale(text).unwrap() / value - 1.0).abs() < 1e-14, "{text}");
        }
        for text in [
            "m/mn", "m/Mn", "Mm/N", "NM/N", "rad/NM", "m/kn", "MG", "MRAD", "MPa", "mPa",
        ] {
            assert!(ValueUnit::parse(text).is_err(), "{text}");
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
            let is_rate = matches!(dimension.of, Amount::Motion(Moves::TwistRate, _));
            if is_rate && form.is_inverse() {
                continue;
            }
            assert_eq!(read.kind(), Kind::Amplitude(dimension), "{unit}");
            assert_eq!(read.ratio(), (1.0, form.is_inverse()), "{unit}");
        }
    }

    #[test]
    fn what_is_no_unit_is_refused_with_what_is() {
        for text in [
            "", "N m", "x", "m/", "/", "m//s", "(m", "m)", "m/s-", "s", "N", "0 m", "-1 m",
            "1e400 m", "nan m", "m44", "10/kg", "1.5/kg", "grams/N", "m/s2/N/N", "((((", "😀",
            "g rms", "mm pk-pk", "-m", "m-", ".m", "m'", "/-m", "m/·N", "g0", "V/N", "EU",
        ] {
            let message = ValueUnit::parse(text).unwrap_err();
            assert!(message.contains("accepted is"), "{message}");
        }
        assert!(ValueUnit::parse(&"m ".repeat(100)).is_err());
    }
}

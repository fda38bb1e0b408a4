//! The symbols and words of units in files, with their SI factors.
//!
//! Sources: SI units and prefixes, tonne, degree, minute and hour: SI brochure, 9th edition (2019). The factors of all
//! others: NIST Special Publication 811 (2008), appendix B.8. Other spellings of a symbol (`sec`, `Gs`, `LBF`) are
//! those of measuring programs.

use std::f64::consts::{PI, TAU};

use super::{FORCE, Powers};

const LENGTH: Powers = [1, 0, 0, 0];
const MASS: Powers = [0, 1, 0, 0];
const TIME: Powers = [0, 0, 1, 0];
const ANGLE: Powers = [0, 0, 0, 1];
const SPEED: Powers = [1, 0, -1, 0];
const ACCELERATION: Powers = [1, 0, -2, 0];
const MOMENT: Powers = [2, 1, -2, 0];

/// Standard gravity, m/s2.
const GRAVITY: f64 = 9.806_65;
const POUND: f64 = 0.453_592_37;
const POUND_FORCE: f64 = POUND * GRAVITY;
const FOOT: f64 = 0.3048;
const INCH: f64 = 0.0254;

/// Spellings, SI factor and powers.
type Row = (&'static [&'static str], f64, Powers);

/// Spellings whose case matters: prefixes differ by it (mN, MN), and so do units (nm, Nm). All-capital spellings are
/// included only if unambiguous: neither `NM` (N m or nm) nor `MRAD` (mrad or Mrad).
const SYMBOLS: &[Row] = &[
    (&["m", "M"], 1.0, LENGTH),
    (&["km", "KM"], 1e3, LENGTH),
    (&["dm"], 1e-1, LENGTH),
    (&["cm", "CM"], 1e-2, LENGTH),
    (&["mm", "MM"], 1e-3, LENGTH),
    (&["um", "UM"], 1e-6, LENGTH),
    (&["nm"], 1e-9, LENGTH),
    (&["s", "S"], 1.0, TIME),
    (&["ms"], 1e-3, TIME),
    (&["us"], 1e-6, TIME),
    (&["h"], 3600.0, TIME),
    (&["g", "G", "gn", "gₙ"], GRAVITY, ACCELERATION),
    (&["mg"], 1e-3 * GRAVITY, ACCELERATION),
    (&["ug"], 1e-6 * GRAVITY, ACCELERATION),
    (&["Gal"], 1e-2, ACCELERATION),
    (&["mGal"], 1e-5, ACCELERATION),
    (&["kg", "Kg", "KG"], 1.0, MASS),
    (&["t"], 1e3, MASS),
    (&["N"], 1.0, FORCE),
    (&["uN"], 1e-6, FORCE),
    (&["mN"], 1e-3, FORCE),
    (&["cN"], 1e-2, FORCE),
    (&["daN"], 10.0, FORCE),
    (&["kN", "KN"], 1e3, FORCE),
    (&["MN"], 1e6, FORCE),
    (&["GN"], 1e9, FORCE),
    (&["gf"], 1e-3 * GRAVITY, FORCE),
    (&["Nm"], 1.0, MOMENT),
    (&["Nmm", "mNm"], 1e-3, MOMENT),
    (&["Ncm"], 1e-2, MOMENT),
    (&["kNm"], 1e3, MOMENT),
    (&["MNm"], 1e6, MOMENT),
    (&["mrad"], 1e-3, ANGLE),
    (&["urad"], 1e-6, ANGLE),
    (&["°"], PI / 180.0, ANGLE),
];

/// Words whose case does not matter. A pound alone is a force, because a mass is never the denominator of a response.
const WORDS: &[Row] = &[
    (&["metre", "metres", "meter", "meters"], 1.0, LENGTH),
    (
        &["millimetre", "millimetres", "millimeter", "millimeters"],
        1e-3,
        LENGTH,
    ),
    (
        &[
            "micron",
            "microns",
            "micrometre",
            "micrometres",
            "micrometer",
            "micrometers",
        ],
        1e-6,
        LENGTH,
    ),
    (&["in", "inch", "inches"], INCH, LENGTH),
    (&["mil", "mils", "thou"], 1e-3 * INCH, LENGTH),
    (&["uin", "microinch", "microinches"], 1e-6 * INCH, LENGTH),
    (&["ft", "foot", "feet"], FOOT, LENGTH),
    (&["yd", "yard", "yards"], 3.0 * FOOT, LENGTH),
    (&["sec", "secs", "second", "seconds"], 1.0, TIME),
    (&["msec"], 1e-3, TIME),
    (&["min", "minute", "minutes"], 60.0, TIME),
    (&["hr", "hour", "hours"], 3600.0, TIME),
    (&["ips"], INCH, SPEED),
    (&["fps"], FOOT, SPEED),
    (&["mph"], 5280.0 * FOOT / 3600.0, SPEED),
    (&["kph", "kmh"], 1.0 / 3.6, SPEED),
    (&["knot", "knots"], 1852.0 / 3600.0, SPEED),
    (&["gs", "grav", "gravity"], GRAVITY, ACCELERATION),
    (&["kilogram", "kilograms"], 1.0, MASS),
    (&["tonne", "tonnes"], 1e3, MASS),
    (&["lbm"], POUND, MASS),
    (&["slug", "slugs"], POUND_FORCE / FOOT, MASS),
    (&["slinch", "slinches", "blob"], POUND_FORCE / INCH, MASS),
    (&["newton", "newtons"], 1.0, FORCE),
    (&["kilonewton", "kilonewtons"], 1e3, FORCE),
    (&["lbf", "lb", "lbs", "pound", "pounds"], POUND_FORCE, FORCE),
    (&["kip", "kips", "klbf"], 1e3 * POUND_FORCE, FORCE),
    (&["ozf"], POUND_FORCE / 16.0, FORCE),
    (&["pdl", "poundal", "poundals"], POUND * FOOT, FORCE),
    (&["kgf", "kp", "kilopond", "kiloponds"], GRAVITY, FORCE),
    (&["dyn", "dyne", "dynes"], 1e-5, FORCE),
    (&["rad", "rads", "radian", "radians"], 1.0, ANGLE),
    (&["deg", "degs", "degree", "degrees"], PI / 180.0, ANGLE),
    (&["gon"], PI / 200.0, ANGLE),
    (&["rev", "revs", "revolution", "revolutions"], TAU, ANGLE),
    (&["rpm"], TAU / 60.0, [0, 0, -1, 1]),
];

/// The SI factor and the powers of a unit, by its symbol or word.
pub(super) fn find(name: &str) -> Option<(f64, Powers)> {
    let is = |row: &&Row| row.0.contains(&name);
    let is_word = |row: &&Row| row.0.iter().any(|word| word.eq_ignore_ascii_case(name));
    let found = SYMBOLS.iter().find(is);
    let (_, one, powers) = found.or_else(|| WORDS.iter().find(is_word))?;
    Some((*one, *powers))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A word must not hide a symbol in any case, nor one row another.
    #[test]
    fn each_spelling_stands_in_one_row() {
        let mut exact = std::collections::HashSet::new();
        let mut words = std::collections::HashSet::new();
        for (spellings, one, _) in SYMBOLS {
            assert!(*one > 0.0);
            assert!(
                spellings.iter().all(|word| exact.insert(*word)),
                "{spellings:?}"
            );
        }
        for (spellings, one, _) in WORDS {
            assert!(*one > 0.0);
            for word in *spellings {
                assert_eq!(word.to_ascii_lowercase(), *word);
                assert!(words.insert(*word), "{word}");
                let hidden = exact
                    .iter()
                    .find(|symbol| symbol.eq_ignore_ascii_case(word));
                assert_eq!(hidden, None, "{word}");
            }
        }
    }
}

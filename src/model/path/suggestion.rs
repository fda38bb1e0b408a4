//! The message for a path that matches nothing: the nearest path that matches, or the valid words.

use super::find::{Finder, in_list_below};
use super::pattern::{Part, join};
use super::text::BRANCHES;
use crate::model::spelling::{nearest, segment};

/// The most known words that a fault lists.
const MOST_LISTED: usize = 8;

/// The first part of a path that matches nothing.
pub(super) struct Mismatch {
    /// Index of the wrong part; the number of parts if one more is needed.
    pub(super) at: usize,
    /// The valid words there; empty if the path should end before.
    pub(super) known: Vec<String>,
}

/// The message for a path that matches nothing.
pub(super) fn explain(finder: &Finder<'_>, mut parts: Vec<Part>, mismatch: Mismatch) -> String {
    let are_names = mismatch.at == place_of_element(&parts) && !is_numbered(&parts);
    let listed = listed(&mismatch.known, are_names);
    if mismatch.known.is_empty() && mismatch.at == place_of_element(&parts) {
        let list = match parts[0].word() {
            "beam" => "spans",
            "supports" => "inner supports",
            list => list,
        };
        return format!("matches nothing; the model has no {list}");
    }
    let Some(wrong) = parts.get(mismatch.at).map(|part| part.word().to_owned()) else {
        return format!("is a table, not a parameter; must continue with {listed}");
    };
    if mismatch.known.is_empty() && wrong == BRANCHES {
        return "matches nothing; no spring there has Maxwell branches".to_owned();
    }
    if mismatch.known.is_empty() {
        return format!("matches nothing; must end before `{wrong}`");
    }
    let place = if mismatch.at == 0 {
        String::new()
    } else {
        format!(" in `{}`", join(&parts[..mismatch.at]))
    };
    match nearest_path(finder, &mut parts, mismatch) {
        Some(path) => format!("matches nothing; did you mean `{path}`?"),
        None => format!("matches nothing; there is no `{wrong}`{place}, must be {listed}"),
    }
}

/// The nearest path that matches, by the nearest known word at every wrong part.
fn nearest_path(finder: &Finder<'_>, parts: &mut [Part], mut mismatch: Mismatch) -> Option<String> {
    for _ in 0..parts.len() {
        let element = mismatch.at == place_of_element(parts);
        // All numbers are equally near.
        let list = mismatch.at.checked_sub(1).map(|list| parts[list].word());
        let is_branch = list == Some(BRANCHES);
        if element && is_numbered(parts) || is_branch {
            return None;
        }
        let word = nearest(
            parts.get(mismatch.at)?.word(),
            mismatch.known.iter().map(|known| &**known),
        )?
        .to_owned();
        parts[mismatch.at] = if element {
            Part::Quoted(word)
        } else {
            Part::Word(word)
        };
        match finder.resolve(parts) {
            Ok(_) => return Some(join(parts)),
            Err(next) => mismatch = next,
        }
    }
    None
}

/// Whether the elements of the list that a path leads into have numbers instead of names.
fn is_numbered(parts: &[Part]) -> bool {
    match parts[0].word() {
        "joints" | "forces" => true,
        list => list == "beam" && in_list_below(parts),
    }
}

/// The index of the part that names the element of a list; 0 if a path leads into no list.
fn place_of_element(parts: &[Part]) -> usize {
    match parts[0].word() {
        "joints" | "subsystems" | "forces" | "responses" | "studies" => 1,
        _ if in_list_below(parts) => 2,
        _ => 0,
    }
}

/// A list of words, shortened if long; names have quotes where a path needs them.
fn listed(words: &[String], names: bool) -> String {
    let text = |word: &String| if names { segment(word) } else { word.clone() };
    let shown: Vec<String> = words.iter().take(MOST_LISTED).map(text).collect();
    let rest = if words.len() > MOST_LISTED {
        ", ..."
    } else {
        ""
    };
    format!("{}{rest}", shown.join(", "))
}

#[cfg(test)]
mod tests {
    use crate::model::path::{expand, sample};

    #[test]
    fn a_slip_is_answered_by_the_nearest_path() {
        let model = sample::model(&["S1", "a.b"]);
        let cases = [
            ("beam.material.densty", "`beam.material.density`"),
            ("bem.lenght", "`beam.length`"),
            ("subsystem.S1.mass", "`subsystems.S1.mass`"),
            (
                "subsystems.s1.y_left.stifness",
                "`subsystems.S1.y_left.stiffness`",
            ),
            ("subsystems.'a,b'.mass", r#"`subsystems."a.b".mass`"#),
            ("subsystems.*.mas", "`subsystems.*.mass`"),
            ("supports.lft.w.stiffness", "`supports.left.w.stiffness`"),
            (
                "supports.left.w.inertias",
                "must be stiffness, damping, loss_factor, mass",
            ),
            (
                "supports.left.w_slope.mass",
                "must be stiffness, damping, loss_factor, inertia",
            ),
            ("supports.inner.B2.mass", "must be B1"),
            (
                "supports.inner.B1.possition",
                "`supports.inner.B1.position`",
            ),
            (
                "supports.inner.B1.w.stifness",
                "`supports.inner.B1.w.stiffness`",
            ),
            ("subsystems.absorber.mass", r#"must be S1, "a.b""#),
            ("subsystems.3.mass", r#"must be S1, "a.b""#),
            ("subsystems.0.mass", "there is no `0` in `subsystems`"),
            ("forces.5.amplitude", "must be 1, 2, 3, 4"),
            ("beam.material", "must continue with young_modulus"),
            ("subsystems", r#"must continue with S1, "a.b""#),
            (
                "subsystems.S1",
                "must continue with name, enabled, position",
            ),
            ("beam.length.x", "must end before `x`"),
            ("nothing.like.it", "must be title, notes, beam"),
            ("*", "must be title"),
            ("", "empty part"),
            ("a..b", "empty part"),
        ];
        for (path, part) in cases {
            let fault = expand(&model, path).unwrap_err();
            assert_eq!(fault.path, path);
            assert!(fault.message.contains(part), "{path}: {}", fault.message);
        }
        let mut empty = sample::model(&[]);
        empty.supports.inner.clear();
        let fault = expand(&empty, "supports.inner.B1.w").unwrap_err();
        assert!(
            fault.message.contains("the model has no inner supports"),
            "{fault}"
        );
        for path in ["subsystems.*.mass", "subsystems.S1.mass", "subsystems"] {
            let fault = expand(&empty, path).unwrap_err();
            assert!(
                fault.message.contains("the model has no subsystems"),
                "{fault}"
            );
        }
    }
}

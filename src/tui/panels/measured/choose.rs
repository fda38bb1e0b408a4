//! Selection of curves from a file with many: the user types numbers, names, or parts of names.

use super::MOST_CURVES;
use crate::measured::Curve;

/// The number of names listed in the dialog.
const MOST_LISTED: usize = 60;

/// The accepted input, with numbers and names of the curves.
pub(crate) fn allowed(curves: &[Curve]) -> String {
    let names = curves.iter().take(MOST_LISTED).enumerate();
    let mut names: Vec<String> = names
        .map(|(i, curve)| format!("{} {}", i + 1, curve.name))
        .collect();
    if curves.len() > MOST_LISTED {
        names.push(format!("to {}", curves.len()));
    }
    format!(
        "numbers, names or parts of names with commas between, as 1-6, 13; at most {MOST_CURVES} on the chart. {}",
        names.join(", ")
    )
}

/// The indices of the curves that a text chooses, each once, in the order of the text.
///
/// # Errors
/// Names the part that matches no curve.
pub(super) fn chosen(text: &str, names: &[&str]) -> Result<Vec<usize>, String> {
    let mut found: Vec<usize> = Vec::new();
    for part in text.split([',', ';']).map(str::trim) {
        if part.is_empty() {
            continue;
        }
        let of_part = part_of(part, names).ok_or_else(|| {
            format!(
                "no curve has `{part}` in its name, and no number from 1 to {} is in it",
                names.len()
            )
        })?;
        for place in of_part {
            if !found.contains(&place) {
                found.push(place);
            }
        }
    }
    if found.is_empty() {
        return Err("type the number or the name of at least one curve".to_owned());
    }
    Ok(found)
}

/// A name, a number, a range of numbers, a part of a name, or several of these separated by blanks.
fn part_of(part: &str, names: &[&str]) -> Option<Vec<usize>> {
    if let Some(place) = names.iter().position(|name| *name == part) {
        return Some(vec![place]);
    }
    let number = |text: &str| {
        let number: usize = text.trim().parse().ok()?;
        (1..=names.len()).contains(&number).then_some(number)
    };
    if let Some(number) = number(part) {
        return Some(vec![number - 1]);
    }
    let range = part
        .split_once('-')
        .or_else(|| part.split_once(".."))
        .and_then(|(from, to)| Some((number(from)?, number(to)?)));
    if let Some((from, to)) = range.filter(|(from, to)| from <= to) {
        return Some((from - 1..to).collect());
    }
    let wanted = part.to_lowercase();
    let holds = |place: &usize| names[*place].to_lowercase().contains(&wanted);
    let holding: Vec<usize> = (0..names.len()).filter(holds).collect();
    if !holding.is_empty() {
        return Some(holding);
    }
    let words: Vec<&str> = part.split_whitespace().collect();
    if words.len() < 2 {
        return None;
    }
    let each: Option<Vec<Vec<usize>>> = words.iter().map(|word| part_of(word, names)).collect();
    each.map(|each| each.concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_are_chosen_by_numbers_names_and_parts_of_names() {
        let names = ["P1 w", "P2 w", "P3 v", "12", "P30 v"];
        let find = |text: &str| chosen(text, &names);
        assert_eq!(find("1-3"), Ok(vec![0, 1, 2]));
        assert_eq!(find("5, 1..2"), Ok(vec![4, 0, 1]));
        assert_eq!(
            find("P3 v"),
            Ok(vec![2]),
            "a whole name is that curve alone"
        );
        assert_eq!(find("p3"), Ok(vec![2, 4]));
        assert_eq!(find(" v; 1"), Ok(vec![2, 4, 0]));
        assert_eq!(find("12"), Ok(vec![3]), "a name that is a number");
        assert_eq!(find("1 3 5"), Ok(vec![0, 2, 4]));
        for wrong in ["", ",", "6", "3-1", "2-9", "Q"] {
            assert!(find(wrong).is_err(), "{wrong:?}");
        }
    }
}

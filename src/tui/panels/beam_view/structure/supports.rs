//! The supports of the ends: a wall, a hinge, springs, dampers and masses along w as signs, and all of it as text.

use super::{Focus, Picture, spring_of, spring_sign};
use crate::model::{BeamMotion, End, Restraint, Support};
use crate::tui::sketch::{Board, POINTER, POINTER_BACK};

/// The column of an end, and the step from there into the beam.
fn side(picture: &Picture<'_>, end: End) -> (i32, i32) {
    match end {
        End::Left => (picture.ends[0], 1),
        End::Right => (picture.ends[1], -1),
    }
}

pub(super) fn draw(picture: &Picture<'_>, board: &mut Board<'_>) {
    for end in End::ALL {
        let support = end.support(picture.model);
        match support[BeamMotion::W] {
            Restraint::Free => {}
            Restraint::Fixed if support[BeamMotion::WSlope] == Restraint::Fixed => {
                draw_wall(picture, board, end);
            }
            Restraint::Fixed => draw_hinge(picture, board, end),
            Restraint::Elastic(_) => draw_springs(picture, board, end),
        }
        if picture.focus == Focus::Support(end) {
            let (column, inward) = side(picture, end);
            // At the edge of the screen, only the end itself has room.
            let outside = (column - inward).clamp(0, board.columns() - 1);
            let sign = if inward > 0 { POINTER } else { POINTER_BACK };
            let style = picture.style(true, true);
            board.sign([outside, picture.rows.beam], sign, style);
        }
    }
}

/// Displacement and slope are fixed.
fn draw_wall(picture: &Picture<'_>, board: &mut Board<'_>, end: End) {
    let (column, inward) = side(picture, end);
    let style = picture.style(true, picture.focus == Focus::Support(end));
    for row in picture.rows.beam - 1..=picture.rows.beam + 1 {
        board.sign([column - inward, row], picture.signs.wall, style);
    }
}

/// The displacement is fixed, the slope is free.
fn draw_hinge(picture: &Picture<'_>, board: &mut Board<'_>, end: End) {
    let (column, _) = side(picture, end);
    let style = picture.style(true, picture.focus == Focus::Support(end));
    let row = picture.rows.beam + 1;
    board.sign([column, row], picture.signs.pin, style);
    draw_ground(picture, board, [column - 1, column + 1], row + 1);
}

/// Spring and damper down to the ground, and the mass at the end.
fn draw_springs(picture: &Picture<'_>, board: &mut Board<'_>, end: End) {
    let (column, inward) = side(picture, end);
    let style = picture.style(true, picture.focus == Focus::Support(end));
    let elastic = end.support(picture.model)[BeamMotion::W].elastic();
    let both = spring_of(elastic);
    let first = picture.rows.beam + 1;
    let parallel = elastic.stiffness > 0.0 && elastic.damping > 0.0;
    let damper = crate::model::Spring {
        stiffness: 0.0,
        damping: elastic.damping,
    };
    for row in 0..picture.rows.springs {
        if let Some(sign) = spring_sign(picture.signs, both, row) {
            board.sign([column, first + row], sign, style);
        }
        if let Some(sign) = spring_sign(picture.signs, damper, row).filter(|_| parallel) {
            board.sign([column + inward, first + row], sign, style);
        }
    }
    if elastic.stiffness > 0.0 || elastic.damping > 0.0 {
        let columns = [column - 1, column + 1];
        draw_ground(picture, board, columns, picture.rows.below_springs());
    }
    if elastic.inertia > 0.0 && picture.rows.springs > 0 {
        board.sign([column - inward, first], picture.signs.mass, style);
    }
}

fn draw_ground(picture: &Picture<'_>, board: &mut Board<'_>, columns: [i32; 2], row: i32) {
    if row < picture.rows.below_boxes() {
        for column in columns[0]..=columns[1] {
            board.sign([column, row], picture.signs.ground, picture.theme.dim());
        }
    }
}

/// Describes the support at each end, if there is room.
pub(super) fn draw_words(picture: &Picture<'_>, board: &mut Board<'_>) {
    for end in End::ALL {
        let style = if picture.focus == Focus::Support(end) {
            picture.theme.accent()
        } else {
            picture.theme.dim()
        };
        let rows = picture.rows.below_springs()..picture.rows.below_boxes();
        let mut words = words(end.support(picture.model)).into_iter().peekable();
        for row in rows {
            let Some(word) = words.peek() else {
                break;
            };
            let columns = crate::tui::sketch::width(word);
            let column = match end {
                End::Left => (picture.ends[0] - 1).max(0),
                End::Right => (picture.ends[1] + 2).min(board.columns()) - columns,
            };
            if board.is_free([column - 1, row], columns + 2)
                && board.word([column, row], word, style)
            {
                words.next();
            }
        }
    }
}

/// The motions that a support restrains, one line each: a word for all of them, or the fixed ones and those on springs.
pub(super) fn words(support: &Support) -> Vec<String> {
    if support.kind() != "elastic" {
        return vec![support.kind().to_owned()];
    }
    let those = |wanted: fn(Restraint) -> bool, what: &str| {
        let motions = BeamMotion::ALL.into_iter();
        let keys: Vec<&str> = motions
            .filter(|motion| wanted(support[*motion]))
            .map(BeamMotion::key)
            .collect();
        (!keys.is_empty()).then(|| format!("{} {what}", keys.join(" ")))
    };
    let held = those(|restraint| restraint == Restraint::Fixed, "held");
    let sprung = those(
        |restraint| matches!(restraint, Restraint::Elastic(_)),
        "sprung",
    );
    held.into_iter().chain(sprung).collect()
}

/// The signs of the supports that are in the picture, and their meanings.
pub(super) fn keys(picture: &Picture<'_>) -> Vec<String> {
    let ends = End::ALL.map(|end| end.support(picture.model)[BeamMotion::W].elastic());
    let with = |sign: char, word: &str, some: bool| some.then(|| format!("{sign} {word}"));
    let [spring, damper, mass] = [
        ends.iter().any(|end| end.stiffness > 0.0),
        ends.iter().any(|end| end.damping > 0.0),
        ends.iter().any(|end| end.inertia > 0.0),
    ];
    let keys = [
        with(picture.signs.zigzag[0], "spring", spring),
        with(picture.signs.damper, "damper", damper),
        with(picture.signs.mass, "mass at an end", mass),
    ];
    keys.into_iter().flatten().collect()
}

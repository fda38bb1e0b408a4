//! The supports: a wall, a hinge, springs, dampers and masses along w as signs, and all of it as text.

use super::{Focus, Picture, damper_sign, named_motions, spring_sign};
use crate::model::{BeamMotion, Restraint, Support, SupportId};
use crate::tui::sketch::Signs;
use crate::tui::sketch::{Board, POINTER, POINTER_BACK};

/// The column of a support, and the step from there into the beam; to the right between the ends.
fn side(picture: &Picture<'_>, id: SupportId) -> (i32, i32) {
    match id {
        SupportId::Left => (picture.ends[0], 1),
        SupportId::Right => (picture.ends[1], -1),
        SupportId::Inner(_) => (picture.column(id.position(picture.model)), 1),
    }
}

pub(super) fn draw(picture: &Picture<'_>, board: &mut Board<'_>) {
    for id in SupportId::all(picture.model) {
        let support = id.support(picture.model);
        match support[BeamMotion::W] {
            Restraint::Free => {}
            Restraint::Fixed if support[BeamMotion::WSlope] == Restraint::Fixed => {
                draw_wall(picture, board, id);
            }
            Restraint::Fixed => draw_hinge(picture, board, id),
            Restraint::Elastic(_) => draw_springs(picture, board, id),
        }
        if picture.focus == Focus::Support(id) {
            let (column, inward) = side(picture, id);
            // At the edge of the screen, only the end itself has room.
            let outside = (column - inward).clamp(0, board.columns() - 1);
            let sign = if inward > 0 { POINTER } else { POINTER_BACK };
            let style = picture.style(true, true);
            board.sign([outside, picture.rows.beam], sign, style);
        }
    }
}

/// Displacement and slope are fixed: at an end outside of it, between the ends above and below the beam.
fn draw_wall(picture: &Picture<'_>, board: &mut Board<'_>, id: SupportId) {
    let (column, inward) = side(picture, id);
    let style = picture.style(true, picture.focus == Focus::Support(id));
    let [top, bottom] = picture.beam_at(column);
    let outside = match id {
        SupportId::Left | SupportId::Right => column - inward,
        SupportId::Inner(_) => column,
    };
    for row in top - 1..=bottom + 1 {
        if outside != column || !(top..=bottom).contains(&row) {
            board.sign([outside, row], picture.signs.wall, style);
        }
    }
}

/// The displacement is fixed, the slope is free.
fn draw_hinge(picture: &Picture<'_>, board: &mut Board<'_>, id: SupportId) {
    let (column, _) = side(picture, id);
    let style = picture.style(true, picture.focus == Focus::Support(id));
    let row = picture.springs(column).start;
    board.sign([column, row], picture.signs.pin, style);
    draw_ground(picture, board, [column - 1, column + 1], row + 1);
}

/// Spring and damper down to the ground, and the mass there.
fn draw_springs(picture: &Picture<'_>, board: &mut Board<'_>, id: SupportId) {
    let (column, inward) = side(picture, id);
    let style = picture.style(true, picture.focus == Focus::Support(id));
    let elastic = id.support(picture.model)[BeamMotion::W].elastic();
    let (has_spring, has_damper) = (elastic.spring.has_spring(), elastic.spring.has_damper());
    let beside = if has_spring { inward } else { 0 };
    let mut draw = |column, sign: fn(&Signs, i32) -> char| {
        let rows = picture.springs(column);
        for row in rows.clone() {
            board.sign([column, row], sign(picture.signs, row - rows.start), style);
        }
    };
    if has_spring {
        draw(column, spring_sign);
    }
    if has_damper {
        draw(column + beside, damper_sign);
    }
    if elastic.spring.acts() {
        let columns = [column - 1, column + 1];
        draw_ground(picture, board, columns, picture.rows.below_springs());
    }
    if elastic.inertia > 0.0 && picture.rows.springs > 0 {
        let beside = column - inward;
        let row = picture.springs(beside).start;
        board.sign([beside, row], picture.signs.mass, style);
    }
}

fn draw_ground(picture: &Picture<'_>, board: &mut Board<'_>, columns: [i32; 2], row: i32) {
    if row < picture.rows.below_boxes() {
        for column in columns[0]..=columns[1] {
            board.sign_if_free([column, row], picture.signs.ground, picture.theme.dim());
        }
    }
}

/// Describes each support, if there is room: one between the ends by its name first.
pub(super) fn draw_words(picture: &Picture<'_>, board: &mut Board<'_>) {
    for id in SupportId::all(picture.model) {
        let style = if picture.focus == Focus::Support(id) {
            picture.theme.accent()
        } else {
            picture.theme.dim()
        };
        let rows = picture.rows.below_springs()..picture.rows.below_boxes();
        let name = match id {
            SupportId::Left | SupportId::Right => None,
            SupportId::Inner(_) => Some(id.name(picture.model).to_owned()),
        };
        let words = words(id.support(picture.model)).into_iter();
        let mut words = name.into_iter().chain(words).peekable();
        for row in rows {
            let Some(word) = words.peek() else {
                break;
            };
            let columns = crate::tui::sketch::width(word);
            let column = match id {
                SupportId::Left => (picture.ends[0] - 1).max(0),
                SupportId::Right => (picture.ends[1] + 2).min(board.columns()) - columns,
                SupportId::Inner(_) => side(picture, id).0 - (columns - 1) / 2,
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
    let held = named_motions(|motion| support[motion] == Restraint::Fixed, "held");
    let sprung = named_motions(
        |motion| matches!(support[motion], Restraint::Elastic(_)),
        "sprung",
    );
    held.into_iter().chain(sprung).collect()
}

/// The signs of the supports that are in the picture, and their meanings.
pub(super) fn keys(picture: &Picture<'_>) -> Vec<String> {
    let along_w = |id: SupportId| id.support(picture.model)[BeamMotion::W].elastic();
    let all: Vec<_> = SupportId::all(picture.model).map(along_w).collect();
    let with = |sign: char, word: &str, some: bool| some.then(|| format!("{sign} {word}"));
    let [spring, damper, mass] = [
        all.iter().any(|of| of.spring.has_spring()),
        all.iter().any(|of| of.spring.has_damper()),
        all.iter().any(|of| of.inertia > 0.0),
    ];
    let at = if picture.model.supports.inner.is_empty() {
        "mass at an end"
    } else {
        "mass of a support"
    };
    let keys = [
        with(picture.signs.zigzag[0], "spring", spring),
        with(picture.signs.damper, "damper", damper),
        with(picture.signs.mass, at, mass),
    ];
    keys.into_iter().flatten().collect()
}

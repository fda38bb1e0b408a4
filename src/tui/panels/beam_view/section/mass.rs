//! A subsystem's mounts, its springs, and its mass as a bar below the section.

use ratatui::style::Style;

use super::plane::{Extent, Reserve};
use super::{Picture, millimetres};
use crate::model::{Spring, Subsystem};
use crate::tui::sketch::{Board, Cell, way};

/// One side of a subsystem.
struct Side<'a> {
    name: char,
    /// The position at which its springs meet the beam, y in m.
    mount: f64,
    /// The position at which its z spring meets the mass, y in m.
    arm: f64,
    y: &'a Spring,
    z: &'a Spring,
    /// The direction away from the axis, in columns: y grows to the left.
    outward: i32,
}

impl Side<'_> {
    fn has_springs(&self) -> bool {
        self.y.acts() || self.z.acts()
    }
}

fn sides(subsystem: &Subsystem) -> [Side<'_>; 2] {
    let outward = if subsystem.mount_y < 0.0 { 1 } else { -1 };
    [
        Side {
            name: 'L',
            mount: subsystem.mount_y,
            arm: subsystem.arm_left,
            y: &subsystem.y_left,
            z: &subsystem.z_left,
            outward,
        },
        Side {
            name: 'R',
            mount: -subsystem.mount_y,
            arm: -subsystem.arm_right,
            y: &subsystem.y_right,
            z: &subsystem.z_right,
            outward: -outward,
        },
    ]
}

/// The parts of a subsystem that must be in the picture.
pub(super) fn take(subsystem: &Subsystem, extent: &mut Extent) {
    for side in sides(subsystem) {
        extent.take(side.mount, subsystem.mount_z);
        extent.take(side.arm, subsystem.mount_z);
    }
}

/// The cells that a subsystem needs around the part drawn to scale.
pub(super) fn reserve(subsystem: &Subsystem, [columns, rows]: [u16; 2]) -> Reserve {
    let springs = sides(subsystem).iter().any(|side| side.y.acts());
    let sides = match columns {
        _ if !springs => 1,
        0..=29 => 3,
        _ => 6,
    };
    let below = match rows {
        0..=3 => 1,
        4..=7 => 2,
        8..=15 => 3,
        // A row of text below the bar.
        _ => 5,
    };
    Reserve {
        sides,
        below,
        head: 0,
    }
}

pub(super) fn draw(picture: &Picture<'_>, board: &mut Board<'_>, subsystem: &Subsystem) {
    let style = if subsystem.enabled {
        Style::new()
    } else {
        picture.theme.dim()
    };
    let words = board.rows() >= 16;
    let distance = if words { 4 } else { 3 };
    let bar = picture.plane.below(distance);
    let sides = sides(subsystem);
    let reach = i32::from(sides.iter().any(|side| side.y.acts()))
        * if board.columns() < 30 { 3 } else { 5 };
    for side in &sides {
        let mount = picture.plane.cell(side.mount, subsystem.mount_z);
        let arm = [picture.plane.cell(side.arm, 0.0)[0], bar];
        if side.has_springs() {
            board.sign_if_free(mount, picture.signs.mount, style);
        }
        if side.z.acts() {
            draw_spring(picture, board, [mount, arm], side.z, style);
        }
        if side.y.acts() {
            let outer = [mount[0] * side.outward, arm[0] * side.outward];
            let column = outer[0].max(outer[1]) * side.outward + reach * side.outward;
            let upright = [column, mount[1]];
            draw_spring(picture, board, [upright, mount], side.y, style);
            draw_upright(picture, board, upright, arm, style);
        }
    }
    draw_bar(picture, board, &sides, bar, style);
    if words {
        for side in &sides {
            let column = picture.plane.cell(side.arm, 0.0)[0];
            let word = format!("{} {} mm", side.name, millimetres(side.arm.abs()));
            board.word_by([column, bar + 1], &word, picture.theme.dim());
        }
    }
}

/// A spring between two cells, both excluded.
fn draw_spring(
    picture: &Picture<'_>,
    board: &mut Board<'_>,
    [from, to]: [Cell; 2],
    spring: &Spring,
    style: Style,
) {
    let cells = way(from, to);
    let inner = cells.get(1..cells.len() - 1).unwrap_or_default();
    for (number, cell) in inner.iter().enumerate() {
        let sign = if spring.has_spring() {
            picture.signs.zigzag[number % 2]
        } else if number == inner.len() / 2 {
            picture.signs.damper
        } else if from[1] == to[1] {
            picture.signs.bar[1]
        } else {
            picture.signs.rod
        };
        board.sign_if_free(*cell, sign, style);
    }
}

/// The bracket of a y spring on the mass: up from the bar to the height of the mounts.
fn draw_upright(
    picture: &Picture<'_>,
    board: &mut Board<'_>,
    [column, top]: Cell,
    [arm, bar]: Cell,
    style: Style,
) {
    for row in top..bar {
        board.sign_if_free([column, row], picture.signs.rod, style);
    }
    let [_, _, left, right] = picture.signs.frame.corners;
    let corner = if column < arm { left } else { right };
    board.sign_if_free([column, bar], corner, style);
    for between in column.min(arm) + 1..column.max(arm) {
        board.sign_if_free([between, bar], picture.signs.bar[1], style);
    }
}

/// The mass: its centre, its arms with their letters, and the bar between them.
fn draw_bar(
    picture: &Picture<'_>,
    board: &mut Board<'_>,
    sides: &[Side<'_>; 2],
    bar: i32,
    style: Style,
) {
    let centre = picture.plane.cell(0.0, 0.0)[0];
    board.sign([centre, bar], picture.signs.mass, style);
    let mut ends = [centre; 2];
    for side in sides {
        let arm = picture.plane.cell(side.arm, 0.0)[0];
        ends = [ends[0].min(arm), ends[1].max(arm)];
        // The letter of an arm without length is next to the centre.
        let column = if arm == centre {
            arm + side.outward
        } else {
            arm
        };
        board.sign([column, bar], side.name, picture.theme.accent());
    }
    for column in ends[0]..=ends[1] {
        board.sign_if_free([column, bar], picture.signs.bar[0], style);
    }
}

//! The subsystems below the beam: one box each on its springs; ticks if they are too close for boxes.

use ratatui::style::Style;

use super::ticks::{self, Tick};
use super::{Focus, Picture, damper_sign, loads, spring_sign};
use crate::model::{Spring, Subsystem, Unit};
use crate::tui::sketch::{Board, Frame, POINTER, width};
use crate::tui::view::text::cut;

/// Columns of the narrowest box.
const NARROWEST: i32 = 5;

/// Subsystems in one column.
struct Spot {
    column: i32,
    members: Vec<usize>,
}

pub(super) fn draw(picture: &Picture<'_>, board: &mut Board<'_>) {
    if picture.rows.springs == 0 {
        return;
    }
    let spots = spots(picture);
    let groups: Vec<&[Spot]> = spots
        .chunk_by(|left, right| right.column - left.column <= NARROWEST)
        .collect();
    let selected = |spot: &Spot| spot.members.iter().any(|i| is_selected(picture, *i));
    // The selected one has room before all others.
    let chosen = groups
        .iter()
        .flat_map(|group| group.iter().map(move |spot| (group, spot)));
    for (group, spot) in chosen.filter(|(_, spot)| selected(spot)) {
        if group.len() > 1 {
            // Among ticks, a tick is also the spring.
            draw_box(picture, board, spot, board.columns());
        } else {
            draw_hung(picture, board, &spots, spot);
        }
    }
    for group in groups {
        match group {
            [spot] if selected(spot) => {}
            [spot] => draw_hung(picture, board, &spots, spot),
            _ => {
                let ticks = group.iter().map(|spot| tick(picture, spot));
                ticks::draw(picture, board, &ticks.collect::<Vec<_>>());
            }
        }
    }
}

/// Whether a subsystem is selected, or a force or response on its mass.
fn is_selected(picture: &Picture<'_>, i: usize) -> bool {
    picture.focus == Focus::Subsystem(i)
        || loads::selected_mass(picture) == Some(picture.model.subsystems[i].name.as_str())
}

/// The subsystems by column, from left to right.
fn spots(picture: &Picture<'_>) -> Vec<Spot> {
    let subsystems = picture.model.subsystems.iter().enumerate();
    let mut columns: Vec<(i32, usize)> = subsystems
        .map(|(i, subsystem)| (picture.column(subsystem.position), i))
        .collect();
    columns.sort_unstable();
    columns
        .chunk_by(|left, right| left.0 == right.0)
        .map(|chunk| Spot {
            column: chunk[0].0,
            members: chunk.iter().map(|(_, i)| *i).collect(),
        })
        .collect()
}

/// The columns that a box may take between its neighbours.
fn most_columns(picture: &Picture<'_>, spots: &[Spot], spot: &Spot) -> i32 {
    let gaps = spots.iter().map(|other| (other.column - spot.column).abs());
    let nearest = gaps.filter(|gap| *gap > 0).min();
    let all = picture.ends[1] - picture.ends[0] + 1;
    nearest.map_or(all, |gap| gap - 1).max(NARROWEST)
}

/// The subsystem that represents all of a spot: the selected one, otherwise an enabled one, otherwise the first.
fn leader<'a>(picture: &'a Picture<'_>, spot: &Spot) -> (usize, &'a Subsystem) {
    let found = spot.members.iter().copied();
    let by = |wanted: &dyn Fn(usize) -> bool| found.clone().find(|i| wanted(*i));
    let i = by(&|i| is_selected(picture, i))
        .or_else(|| by(&|i| picture.model.subsystems[i].enabled))
        .unwrap_or(spot.members[0]);
    (i, &picture.model.subsystems[i])
}

fn tick<'a>(picture: &'a Picture<'_>, spot: &Spot) -> Tick<'a> {
    let (i, subsystem) = leader(picture, spot);
    Tick {
        column: spot.column,
        count: spot.members.len(),
        subsystem,
        selected: is_selected(picture, i),
    }
}

/// A box on its springs, as wide as its neighbours allow.
fn draw_hung(picture: &Picture<'_>, board: &mut Board<'_>, spots: &[Spot], spot: &Spot) {
    let (i, subsystem) = leader(picture, spot);
    draw_springs(
        picture,
        board,
        spot.column,
        subsystem,
        is_selected(picture, i),
    );
    draw_box(picture, board, spot, most_columns(picture, spots, spot));
}

fn draw_box(picture: &Picture<'_>, board: &mut Board<'_>, spot: &Spot, most: i32) {
    let (i, subsystem) = leader(picture, spot);
    let selected = is_selected(picture, i);
    let rows = picture.rows.boxes;
    let bordered = rows > 2;
    let mass = Unit::KILOGRAM.format(subsystem.mass);
    // With an even number of rows, the mass takes the last text row.
    let mass = (rows % 2 == 0 && width(&mass) <= most - 2).then_some(mass);
    let label = label(picture, spot, i, (most.min(board.columns()) - 2).max(0));
    let inner = width(&label).max(mass.as_deref().map_or(0, width));
    let columns = (inner + 2).max(NARROWEST).min(board.columns());
    let Some(left) = seat(picture, board, spot.column, columns, selected) else {
        return;
    };
    let top = picture.rows.below_springs();
    let frame = match (selected, subsystem.enabled) {
        (true, _) => &picture.signs.double,
        (_, true) => &picture.signs.frame,
        _ => &picture.signs.dashed,
    };
    let style = picture.style(subsystem.enabled, selected);
    let first = if bordered {
        draw_frame(board, [left, top], [columns, rows], frame, style);
        centred(board, [left, top + 1], columns, &label, style);
        top + 1
    } else {
        let [before, behind] = frame.ends;
        let text = format!("{before}{label}{behind}");
        centred(board, [left, top], columns, &text, style);
        top
    };
    if let Some(mass) = mass {
        let style = picture.style(subsystem.enabled, false);
        centred(board, [left, first + 1], columns, &mass, style);
    }
}

/// A name with the signs of the forces and responses of the mass, in this number of columns.
fn label(picture: &Picture<'_>, spot: &Spot, i: usize, columns: i32) -> String {
    let name = &picture.model.subsystems[i].name;
    let pointer = match picture.focus {
        Focus::Subsystem(focus) if focus == i => POINTER.to_string(),
        _ => String::new(),
    };
    let others = match spot.members.len() {
        1 => String::new(),
        count => format!(" +{}", count - 1),
    };
    let loads = loads::on_mass(picture, name);
    let bare = format!("{pointer}{name}{others}");
    let room = columns - width(&loads);
    if room < 2 {
        return cut(&bare, columns as usize);
    }
    format!("{}{loads}", cut(&bare, room as usize))
}

/// The first column of a box: centred below its position, or moved until there is room.
fn seat(
    picture: &Picture<'_>,
    board: &Board<'_>,
    column: i32,
    columns: i32,
    over: bool,
) -> Option<i32> {
    let top = picture.rows.below_springs();
    let last = board.columns() - columns;
    let middle = (column - (columns - 1) / 2).min(last).max(0);
    if over {
        return Some(middle);
    }
    let free =
        |left: &i32| (0..picture.rows.boxes).all(|row| board.is_free([*left, top + row], columns));
    let aside = (0..=columns / 2).flat_map(|step| [middle + step, middle - step]);
    aside.filter(|left| (0..=last).contains(left)).find(free)
}

/// Writes a centred text in this number of columns.
fn centred(board: &mut Board<'_>, [left, row]: [i32; 2], columns: i32, text: &str, style: Style) {
    board.over([left + (columns - width(text)) / 2, row], text, style);
}

fn draw_frame(
    board: &mut Board<'_>,
    [left, top]: [i32; 2],
    [columns, rows]: [i32; 2],
    frame: &Frame,
    style: Style,
) {
    let (right, bottom) = (left + columns - 1, top + rows - 1);
    for row in top..=bottom {
        for column in left..=right {
            let sign = match (
                column == left || column == right,
                row == top || row == bottom,
            ) {
                (true, true) => {
                    let corner = usize::from(column == right) + 2 * usize::from(row == bottom);
                    frame.corners[corner]
                }
                (true, false) => frame.down,
                (false, true) => frame.along,
                (false, false) => ' ',
            };
            board.sign([column, row], sign, style);
        }
    }
}

/// The springs along y and along z side by side, with their names if there is room.
fn draw_springs(
    picture: &Picture<'_>,
    board: &mut Board<'_>,
    column: i32,
    subsystem: &Subsystem,
    selected: bool,
) {
    let along = [
        ('y', subsystem.y_left.in_parallel(&subsystem.y_right)),
        ('z', subsystem.z_left.in_parallel(&subsystem.z_right)),
    ];
    let there: Vec<(char, Spring)> = along
        .into_iter()
        .filter(|(_, spring)| spring.acts())
        .collect();
    let style = picture.style(subsystem.enabled, selected);
    for (number, (letter, spring)) in there.iter().enumerate() {
        // Two of them are at either side of the position.
        let outward = if *letter == 'y' { -1 } else { 1 };
        let place = if there.len() == 1 {
            column
        } else {
            column + outward
        };
        let rows = picture.springs(place);
        for row in rows.clone() {
            let at = row - rows.start + number as i32;
            let sign = match (subsystem.enabled, spring.has_spring()) {
                (true, true) => spring_sign(picture.signs, at),
                (true, false) => damper_sign(picture.signs, at),
                (false, _) => picture.signs.ticks[1],
            };
            board.sign_if_free([place, row], sign, style);
        }
        if picture.rows.springs > 1 {
            let last = rows.end - 1;
            board.sign_if_free([place + outward, last], *letter, picture.theme.dim());
        }
    }
}

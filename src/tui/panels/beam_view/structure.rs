//! Side view of the structure, to scale along x: the beam with its supports, joints, subsystems, forces and responses.
//! The depths and offsets of spans are to scale among each other.
//!
//! Upward is y, so w is up and down; z is out of the picture. Every subsystem is drawn below the beam, in whichever
//! direction its springs act: the picture shows that the springs exist, and their directions.

mod beam;
mod joints;
mod loads;
mod masses;
mod rows;
mod supports;
mod ticks;

use std::ops::Range;

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::Line;

use self::beam::{Body, Profile};
use self::rows::Rows;
use crate::model::{BeamMotion, Group, Model, Place, SupportId, Unit, counted};
use crate::tui::app::App;
use crate::tui::plot::{Axis, CellRuler, Scale};
use crate::tui::sketch::{Board, POINTER, POINTER_BACK, Signs, width};
use crate::tui::theme::Theme;
use crate::tui::tree::{self, Node};
use crate::tui::view::frame;
use crate::tui::view::text::cut;

/// Columns left and right of the beam, for walls and text at its ends; fewer if there are few columns.
const MARGIN: u16 = 3;

/// What the selected row refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Focus {
    Beam,
    Span(usize),
    Support(SupportId),
    Joint(usize),
    Subsystem(usize),
    Force(usize),
    Response(usize),
    Nothing,
}

impl Focus {
    fn of(group: Group) -> Self {
        match group {
            Group::Beam => Self::Beam,
            Group::Span(i) => Self::Span(i),
            Group::Support(support) => Self::Support(support),
            Group::Joint(i) => Self::Joint(i),
            Group::Subsystem(i) => Self::Subsystem(i),
            Group::Force(i) => Self::Force(i),
            Group::Response(i) => Self::Response(i),
            other => other.parent().map_or(Self::Nothing, Self::of),
        }
    }
}

/// What all parts of the picture need to be drawn.
struct Picture<'a> {
    model: &'a Model,
    focus: Focus,
    theme: Theme,
    signs: &'static Signs,
    rows: Rows,
    ruler: CellRuler,
    /// The columns of the beam's ends.
    ends: [i32; 2],
    bodies: Vec<Body>,
}

impl<'a> Picture<'a> {
    fn new(model: &'a Model, node: Node, theme: Theme, [columns, rows]: [u16; 2]) -> Self {
        // If there are few columns, the beam takes all of them.
        let margin = MARGIN.min(columns.saturating_sub(8) / 4);
        let length = columns.saturating_sub(2 * margin).max(1);
        let axis = Axis::new(Scale::Linear, [0.0, model.length()], Unit::METRE.symbol);
        let first = i32::from(margin);
        let parts = model.uniform_parts();
        let profile = Profile::of(&parts);
        let mut picture = Self {
            model,
            focus: Focus::of(node.group()),
            theme,
            signs: Signs::of(theme),
            rows: Rows::of(i32::from(rows), &profile),
            ruler: CellRuler::across(axis, length),
            ends: [first, first + i32::from(length) - 1],
            bodies: Vec::new(),
        };
        picture.bodies = beam::bodies(&picture, &parts, &profile);
        picture
    }

    /// The column of a distance from the left end, m.
    fn column(&self, x: f64) -> i32 {
        let cell = self.ruler.cell(x.clamp(0.0, self.model.length()));
        self.ends[0] + cell.map_or(0, i32::from)
    }

    fn place(&self, place: Place) -> i32 {
        match place {
            Place::Left => self.ends[0],
            Place::Right => self.ends[1],
            Place::Position(x) => self.column(x),
        }
    }

    /// The first and the last row of the beam and its axis in a column; outside of the beam those at its end.
    fn beam_at(&self, column: i32) -> [i32; 2] {
        let column = column.clamp(self.ends[0], self.ends[1]);
        let there = self.bodies.iter();
        let there = there.filter(|body| (body.columns[0]..=body.columns[1]).contains(&column));
        there.fold([self.rows.beam; 2], |[top, bottom], body| {
            [top.min(body.rows[0]), bottom.max(body.rows[1])]
        })
    }

    /// The row above the beam in a column.
    fn above(&self, column: i32) -> i32 {
        self.beam_at(column)[0] - 1
    }

    /// The rows of springs below the beam in a column.
    fn springs(&self, column: i32) -> Range<i32> {
        self.beam_at(column)[1] + 1..self.rows.below_springs()
    }

    /// The style of a part, from whether it is enabled and whether it is selected.
    fn style(&self, counts: bool, selected: bool) -> Style {
        if selected {
            self.theme.accent().patch(self.theme.selection())
        } else if counts {
            Style::new()
        } else {
            self.theme.dim()
        }
    }

    /// Marks the selection without colour: a pointer left of it, otherwise right of it.
    fn point(&self, board: &mut Board<'_>, [column, row]: [i32; 2], columns: i32) {
        let style = self.style(true, true);
        if board.sign_if_free([column - 1, row], POINTER, style)
            || board.sign_if_free([column + columns, row], POINTER_BACK, style)
        {
            return;
        }
        let (at, sign) = if column > 0 {
            (column - 1, POINTER)
        } else {
            (column + columns, POINTER_BACK)
        };
        board.sign([at, row], sign, style);
    }
}

pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    let model = app.model();
    let node = app.selection.node();
    let title = frame::rule("Structure", theme);
    let room = usize::from(area.width).saturating_sub(title.width() + 3);
    let note = cut(&note(model, Focus::of(node.group())), room);
    let note = Line::styled(format!(" {note} "), theme.dim());
    let block = frame::panel(title, note, area.width).border_style(theme.dim());
    let inside = block.inner(area);
    frame.render_widget(block, area);
    if inside.is_empty() {
        return;
    }
    let picture = Picture::new(model, node, theme, [inside.width, inside.height]);
    let mut board = Board::new(frame.buffer_mut(), inside);
    beam::draw(&picture, &mut board);
    supports::draw(&picture, &mut board);
    joints::draw(&picture, &mut board);
    masses::draw(&picture, &mut board);
    loads::draw(&picture, &mut board);
    supports::draw_words(&picture, &mut board);
    draw_ruler(&picture, &mut board);
    draw_key(&picture, &mut board);
}

/// Round values of x below the picture, and their unit.
fn draw_ruler(picture: &Picture<'_>, board: &mut Board<'_>) {
    let dim = picture.theme.dim();
    let [line, major, minor] = picture.signs.ruler;
    let ticks = picture.ruler.ticks();
    if let Some(row) = picture.rows.ruler {
        for column in picture.ends[0]..=picture.ends[1] {
            board.sign([column, row], line, dim);
        }
        for tick in &ticks {
            let sign = if tick.label.is_some() { major } else { minor };
            board.sign([picture.ends[0] + i32::from(tick.cell), row], sign, dim);
        }
    }
    let Some(row) = picture.rows.numbers else {
        return;
    };
    // Numbers are shown only with their unit.
    board.word([board.columns() - 1, row], "m", Style::new());
    for tick in &ticks {
        let Some(label) = &tick.label else {
            continue;
        };
        let columns = width(label);
        let middle = picture.ends[0] + i32::from(tick.cell) - (columns - 1) / 2;
        let column = middle.min(board.columns() - columns).max(0);
        if board.is_free([column - 1, row], columns + 2) {
            board.word([column, row], label, Style::new());
        }
    }
}

/// The meanings of the signs in the picture, as many as fit.
fn draw_key(picture: &Picture<'_>, board: &mut Board<'_>) {
    let Some(row) = picture.rows.key else {
        return;
    };
    let [mut column, room] = [1, board.columns() - 1];
    let keys = loads::keys(picture)
        .into_iter()
        .chain(supports::keys(picture))
        .chain(joints::keys(picture))
        .chain(beam::keys(picture));
    for key in keys {
        let columns = width(&key);
        if column + columns > room {
            break;
        }
        board.word([column, row], &key, picture.theme.dim());
        column += columns + 3;
    }
}

/// The selection as text.
fn note(model: &Model, focus: Focus) -> String {
    match focus {
        Focus::Subsystem(i) => {
            let subsystem = &model.subsystems[i];
            let off = if subsystem.enabled { "" } else { ", off" };
            let position = Unit::METRE.format(subsystem.position);
            let mass = Unit::KILOGRAM.format(subsystem.mass);
            format!("{} at {position}, {mass}{off}", subsystem.name)
        }
        Focus::Support(id) => {
            let words = supports::words(id.support(model)).join(", ");
            match id {
                SupportId::Left | SupportId::Right => format!("{} end: {words}", id.name(model)),
                SupportId::Inner(_) => {
                    let position = Unit::METRE.format(id.position(model));
                    format!("{} at {position}: {words}", id.name(model))
                }
            }
        }
        Focus::Joint(i) => {
            let position = Unit::METRE.format(model.joints[i].position);
            let words = joints::words(&model.joints[i]).join(", ");
            format!("joint {} at {position}: {words}", i + 1)
        }
        Focus::Force(i) => {
            let what = tree::value(model, Node::Group(Group::Force(i)));
            let amplitude = loads::amplitude(model, i);
            format!("force {}: {what}, {amplitude}", i + 1)
        }
        Focus::Response(i) => {
            let what = tree::value(model, Node::Group(Group::Response(i)));
            format!("{}: {what}", model.responses[i].name)
        }
        Focus::Span(i) => {
            let length = Unit::METRE.format(model.spans[i].length);
            format!("span {}, {length}", i + 1)
        }
        Focus::Beam | Focus::Nothing => {
            let counts = [
                (model.spans.len(), "span", "spans"),
                (model.subsystems.len(), "subsystem", "subsystems"),
            ];
            let there = counts.into_iter().filter(|(count, ..)| *count > 0);
            let there = there.map(|(count, one, more)| counted(count, one, more));
            let length = Unit::METRE.format(model.length());
            let all: Vec<String> = std::iter::once(length).chain(there).collect();
            all.join(", ")
        }
    }
}

/// The names of some motions and what they have in common, if there are any.
fn named_motions(wanted: impl Fn(BeamMotion) -> bool, what: &str) -> Option<String> {
    let motions = BeamMotion::ALL.into_iter();
    let keys: Vec<&str> = motions
        .filter(|motion| wanted(*motion))
        .map(BeamMotion::key)
        .collect();
    (!keys.is_empty()).then(|| format!("{} {what}", keys.join(" ")))
}

/// The sign of a spring: it zigzags.
const fn spring_sign(signs: &Signs, row: i32) -> char {
    signs.zigzag[(row % 2) as usize]
}

/// The sign of a damper.
const fn damper_sign(signs: &Signs, row: i32) -> char {
    if row == 0 { signs.damper } else { signs.rod }
}

#[cfg(test)]
mod tests;

//! The symbols of mechanics.

use crate::tui::plot::Glyphs;
use crate::tui::theme::Theme;

/// The lines of a box: corners upper left, upper right, lower left, lower right; then horizontal and vertical lines.
#[derive(Debug, PartialEq, Eq)]
pub(in crate::tui) struct Frame {
    pub(in crate::tui) corners: [char; 4],
    pub(in crate::tui) along: char,
    pub(in crate::tui) down: char,
    /// Before and after the name in a box of one row.
    pub(in crate::tui) ends: [char; 2],
}

/// The symbols of a picture of a structure.
#[derive(Debug, PartialEq, Eq)]
pub(in crate::tui) struct Signs {
    pub(in crate::tui) beam: char,
    /// A computed response, and one that is switched off.
    pub(in crate::tui) probe: [char; 2],
    /// A spring, cell by cell.
    pub(in crate::tui) zigzag: [char; 2],
    pub(in crate::tui) damper: char,
    /// A rigid connection without a spring.
    pub(in crate::tui) rod: char,
    /// A clamped end.
    pub(in crate::tui) wall: char,
    /// A support that pins.
    pub(in crate::tui) pin: char,
    /// A joint of the beam: with free motions alone, and with a spring.
    pub(in crate::tui) joint: [char; 2],
    pub(in crate::tui) ground: char,
    /// A tip mass, or a centre of mass.
    pub(in crate::tui) mass: char,
    /// Forces up, down, out of the picture and into it.
    pub(in crate::tui) up: char,
    pub(in crate::tui) down: char,
    pub(in crate::tui) out: char,
    pub(in crate::tui) into: char,
    /// A moment about a transverse axis.
    pub(in crate::tui) moment: char,
    /// Subsystems without room for boxes: attached, and detached.
    pub(in crate::tui) ticks: [char; 2],
    /// The selected one of these.
    pub(in crate::tui) selected_tick: char,
    pub(in crate::tui) frame: Frame,
    /// The box of a detached subsystem.
    pub(in crate::tui) dashed: Frame,
    /// The box of the selection.
    pub(in crate::tui) double: Frame,
    /// Lines that meet in a cell, by the sum of 1 for that from above, 2 from below, 4 from the left and 8 from the right.
    junctions: [char; 16],
    /// A ruler: its line, labelled and minor ticks.
    pub(in crate::tui) ruler: [char; 3],
    /// A vertical ruler.
    pub(in crate::tui) upright: [char; 3],
    pub(in crate::tui) corner: char,
    /// A rigid bar between its arms, and beyond them.
    pub(in crate::tui) bar: [char; 2],
    /// The point where a spring meets the beam.
    pub(in crate::tui) mount: char,
    /// The axis of the beam, seen along it.
    pub(in crate::tui) axis: char,
    pub(in crate::tui) shear_centre: char,
    pub(in crate::tui) centroid: char,
    pub(in crate::tui) plus_minus: &'static str,
    pub(in crate::tui) left_arrow: &'static str,
}

/// A torque about the beam's axis.
pub(in crate::tui) const TORQUE: char = 'T';
/// A bimoment.
pub(in crate::tui) const BIMOMENT: char = 'B';
/// Before the selection.
pub(in crate::tui) const POINTER: char = '>';
/// After the selection, without room before it.
pub(in crate::tui) const POINTER_BACK: char = '<';

const UNICODE: Signs = Signs {
    beam: '═',
    probe: ['◆', '◇'],
    zigzag: ['╱', '╲'],
    damper: '╫',
    rod: '│',
    wall: '▒',
    pin: '▲',
    joint: ['○', '◎'],
    ground: '▔',
    mass: '■',
    up: '↑',
    down: '↓',
    out: '⊙',
    into: '⊗',
    moment: '↺',
    ticks: ['╷', '╎'],
    selected_tick: '┃',
    frame: Frame {
        corners: ['┌', '┐', '└', '┘'],
        along: '─',
        down: '│',
        ends: ['[', ']'],
    },
    dashed: Frame {
        corners: ['┌', '┐', '└', '┘'],
        along: '╌',
        down: '╎',
        ends: ['(', ')'],
    },
    double: Frame {
        corners: ['╔', '╗', '╚', '╝'],
        along: '═',
        down: '║',
        ends: ['[', ']'],
    },
    junctions: [
        ' ', '╵', '╷', '│', '╴', '┘', '┐', '┤', '╶', '└', '┌', '├', '─', '┴', '┬', '┼',
    ],
    ruler: ['─', '┬', '┴'],
    upright: ['│', '┤', '├'],
    corner: '└',
    bar: ['━', '─'],
    mount: '○',
    axis: '┼',
    shear_centre: '+',
    centroid: '×',
    plus_minus: "±",
    left_arrow: "←",
};

const ASCII: Signs = Signs {
    beam: '=',
    probe: ['*', 'o'],
    zigzag: ['/', '\\'],
    damper: 'H',
    rod: '|',
    wall: '#',
    pin: '^',
    joint: ['O', '@'],
    ground: '-',
    mass: '#',
    up: '^',
    down: 'v',
    out: 'o',
    into: 'x',
    moment: 'M',
    ticks: ['|', ':'],
    selected_tick: '#',
    frame: Frame {
        corners: ['+'; 4],
        along: '-',
        down: '|',
        ends: ['[', ']'],
    },
    dashed: Frame {
        corners: ['.'; 4],
        along: '.',
        down: ':',
        ends: ['(', ')'],
    },
    double: Frame {
        corners: ['#'; 4],
        along: '=',
        down: '#',
        ends: ['[', ']'],
    },
    junctions: [
        ' ', '|', '|', '|', '-', '+', '+', '+', '-', '+', '+', '+', '-', '+', '+', '+',
    ],
    ruler: ['-', '+', '|'],
    upright: ['|', '+', '-'],
    corner: '+',
    bar: ['=', '-'],
    mount: 'o',
    axis: '*',
    shear_centre: '+',
    centroid: 'x',
    plus_minus: "+-",
    left_arrow: "<-",
};

impl Signs {
    /// Lines that meet in a cell: whether there is one from above, from below, from the left and from the right.
    pub(in crate::tui) fn junction(&self, lines: [bool; 4]) -> char {
        let lines = lines.into_iter().rev();
        self.junctions[lines.fold(0, |sum, line| 2 * sum + usize::from(line))]
    }

    /// The symbols that a theme can show.
    pub(in crate::tui) fn of(theme: Theme) -> &'static Self {
        if theme.is_ascii() || theme.glyphs() == Glyphs::Ascii {
            &ASCII
        } else {
            &UNICODE
        }
    }
}

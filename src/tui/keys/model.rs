//! The rows of the key table for the model.

use crossterm::event::KeyCode;

use super::table::{DOWN, ENTER, FIRST, LAST, PAGE_DOWN, PAGE_UP, UP};
use super::{Binding, Command, Hint, bind, control, key, special};

/// Moving in the tree.
pub(super) const MOVE: &[Binding] = &[
    bind("up", UP, Command::Up, Hint::Never, "row above"),
    bind("down", DOWN, Command::Down, Hint::Never, "row below"),
    bind(
        "page-up",
        PAGE_UP,
        Command::PageUp,
        Hint::Never,
        "one screen up",
    ),
    bind(
        "page-down",
        PAGE_DOWN,
        Command::PageDown,
        Hint::Never,
        "one screen down",
    ),
    bind("first", FIRST, Command::First, Hint::Never, "first row"),
    bind("last", LAST, Command::Last, Hint::Never, "last row"),
    bind(
        "expand",
        &[special(KeyCode::Right), key('l')],
        Command::Expand,
        Hint::Group("open"),
        "open the group, or go into it",
    ),
    bind(
        "collapse",
        &[special(KeyCode::Left), key('h')],
        Command::Collapse,
        Hint::Never,
        "close the group, or go to the one that holds the row",
    ),
    bind(
        "expand-all",
        &[key('E')],
        Command::ExpandAll,
        Hint::Never,
        "open every group, but for the springs of free motions",
    ),
    bind(
        "collapse-all",
        &[key('C')],
        Command::CollapseAll,
        Hint::Never,
        "close every group",
    ),
    bind(
        "next-parameter",
        &[special(KeyCode::Tab)],
        Command::NextParameter,
        Hint::Group("next value"),
        "next parameter, opening the group that holds it",
    ),
    bind(
        "previous-parameter",
        &[special(KeyCode::BackTab)],
        Command::PreviousParameter,
        Hint::Never,
        "parameter before",
    ),
    bind(
        "next-alike",
        &[key('n')],
        Command::NextAlike,
        Hint::Never,
        "same parameter of the next subsystem, support, force or response; after a search its next row",
    ),
    bind(
        "previous-alike",
        &[key('N')],
        Command::PreviousAlike,
        Hint::Never,
        "same parameter of the one before; after a search the row before",
    ),
    bind(
        "search",
        &[key('/')],
        Command::Search,
        Hint::Group("search"),
        "search the tree",
    ),
];

/// Changing the model.
pub(super) const CHANGE: &[Binding] = &[
    bind(
        "edit",
        ENTER,
        Command::Edit,
        Hint::Value("edit"),
        "type a value (4e7, 40M, 40 MN/m, *1.1, /2, +5%), next choice, or open and close",
    ),
    bind(
        "nudge-up",
        &[key('+'), key('=')],
        Command::Nudge(10),
        Hint::Number("1 % more"),
        "1 % more",
    ),
    bind(
        "nudge-down",
        &[key('-')],
        Command::Nudge(-10),
        Hint::Number("less"),
        "1 % less",
    ),
    bind(
        "nudge-up-coarse",
        &[key('>')],
        Command::Nudge(100),
        Hint::Number("10 % more"),
        "10 % more",
    ),
    bind(
        "nudge-down-coarse",
        &[key('<')],
        Command::Nudge(-100),
        Hint::Number("less"),
        "10 % less",
    ),
    bind(
        "nudge-up-fine",
        &[key('.')],
        Command::Nudge(1),
        Hint::Never,
        "0.1 % more",
    ),
    bind(
        "nudge-down-fine",
        &[key(',')],
        Command::Nudge(-1),
        Hint::Never,
        "0.1 % less",
    ),
    bind(
        "cycle",
        &[key(' ')],
        Command::Cycle,
        Hint::Choice("next choice"),
        "next choice (support, spacing, measure, direction, place), or open and close",
    ),
    bind(
        "repeat",
        &[key(';')],
        Command::Repeat,
        Hint::Never,
        "the last change again (a typed one too), on the selected row",
    ),
    bind(
        "revert",
        &[special(KeyCode::Backspace)],
        Command::Revert,
        Hint::Never,
        "put the file's value back",
    ),
    bind(
        "add",
        &[key('a')],
        Command::Add,
        Hint::List("add"),
        "add a subsystem, force or response",
    ),
    bind(
        "duplicate",
        &[key('D')],
        Command::Duplicate,
        Hint::Item("duplicate"),
        "duplicate the subsystem, force or response",
    ),
    bind(
        "rename",
        &[key('r')],
        Command::Rename,
        Hint::Item("rename"),
        "rename the subsystem, response or study",
    ),
    bind(
        "enable",
        &[key('e')],
        Command::Enable,
        Hint::Item("on/off"),
        "enable or disable the subsystem, force or response",
    ),
    bind(
        "delete",
        &[key('x'), special(KeyCode::Delete)],
        Command::Delete,
        Hint::Item("delete"),
        "delete the subsystem, force, response or study",
    ),
    bind(
        "undo",
        &[key('u')],
        Command::Undo,
        Hint::Always("undo"),
        "undo",
    ),
    bind(
        "redo",
        &[key('U'), control('r')],
        Command::Redo,
        Hint::Never,
        "redo",
    ),
];

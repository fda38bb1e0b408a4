use std::num::NonZeroU16;

use ratatui::Terminal;
use ratatui::style::{Color, Modifier, Style};

use super::*;

const COLUMNS: u16 = 20;
const ROWS: u16 = 6;

#[allow(clippy::unnecessary_wraps)] // The signature of the system's size function.
fn size() -> io::Result<Size> {
    Ok(Size::new(COLUMNS, ROWS))
}

fn terminal() -> Terminal<CompactBackend<Vec<u8>>> {
    Terminal::new(CompactBackend::new(Vec::new(), size)).unwrap()
}

/// Draws texts at positions; returns the written bytes.
fn draw(
    terminal: &mut Terminal<CompactBackend<Vec<u8>>>,
    text: &[(u16, u16, &str, Style)],
) -> String {
    terminal
        .draw(|frame| {
            for (x, y, text, style) in text {
                frame.buffer_mut().set_string(*x, *y, text, *style);
            }
        })
        .unwrap();
    let bytes = std::mem::take(terminal.backend_mut().writer_mut());
    String::from_utf8(bytes).unwrap()
}

#[test]
fn an_unchanged_frame_writes_nothing() {
    let mut terminal = terminal();
    let text = [(3, 2, "beam", Style::new())];
    let first = draw(&mut terminal, &text);
    assert_eq!(first, "\x1b[?2026h\x1b[3;4Hbeam\x1b[?25l\x1b[?2026l");
    assert_eq!(draw(&mut terminal, &text), "");
}

#[test]
fn a_steep_line_is_followed_downwards() {
    let cyan = Style::new().fg(Color::Cyan);
    let line: Vec<_> = (0..4).map(|y| (9, y, "⢸", cyan)).collect();
    let written = draw(&mut terminal(), &line);
    let expected = "\x1b[;10H\x1b[36m⢸\n\x08⢸\n\x08⢸\n\x08⢸\x1b[m";
    assert!(written.contains(expected), "{written:?}");
}

#[test]
fn after_the_last_column_and_wide_letters_the_cursor_position_is_unknown() {
    let plain = Style::new();
    let written = draw(
        &mut terminal(),
        &[(COLUMNS - 1, 0, "a", plain), (0, 1, "b", plain)],
    );
    assert!(written.contains("a\x1b[2Hb"), "{written:?}");
    let written = draw(&mut terminal(), &[(0, 0, "梁c", plain)]);
    assert!(written.contains("梁\x1b[;3Hc"), "{written:?}");
}

#[test]
fn the_cursor_is_shown_at_the_requested_position() {
    let mut terminal = terminal();
    let mut at = |position: Option<(u16, u16)>| {
        terminal
            .draw(|frame| {
                if let Some(position) = position {
                    frame.set_cursor_position(position);
                }
            })
            .unwrap();
        let bytes = std::mem::take(terminal.backend_mut().writer_mut());
        String::from_utf8(bytes).unwrap()
    };
    assert_eq!(at(None), "\x1b[?2026h\x1b[?25l\x1b[?2026l");
    let shown = at(Some((4, 1)));
    assert_eq!(shown, "\x1b[?2026h\x1b[?25h\x1b[2;5H\x1b[?2026l");
    assert_eq!(at(None), "\x1b[?2026h\x1b[?25l\x1b[?2026l");
}

type Drawn = (u16, u16, &'static str, Style);

/// A number below a limit, by Knuth's linear congruence (The Art of Computer Programming 2, 3.3.4).
fn below(random: &mut u64, limit: u64) -> usize {
    *random = random
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    ((*random >> 33) % limit) as usize
}

/// Random styled letters on `quarters` quarters of the screen.
fn scattered(random: &mut u64, quarters: usize) -> Vec<Drawn> {
    let mut cells = Vec::new();
    for (x, y) in (0..ROWS).flat_map(|y| (0..COLUMNS).map(move |x| (x, y))) {
        let symbol = [" ", " ", "a", "⢸", "─", "é"][below(random, 6)];
        let colour = [Color::Reset, Color::Red, Color::Indexed(99)][below(random, 3)];
        let modifier = [Modifier::empty(), Modifier::BOLD, Modifier::REVERSED][below(random, 3)];
        if below(random, 4) < quarters {
            cells.push((x, y, symbol, Style::new().fg(colour).add_modifier(modifier)));
        }
    }
    cells
}

/// A terminal (the vt100 crate) shows any sequence of frames correctly.
#[test]
fn a_terminal_shows_what_was_drawn() {
    let nonzero = |count| NonZeroU16::new(count).unwrap();
    let mut terminal = terminal();
    let mut screen = vt100::Parser::new(nonzero(ROWS), nonzero(COLUMNS), 0);
    let mut random = 1;
    for round in 0..300 {
        let cells = scattered(&mut random, 1 + round % 4);
        screen.process(draw(&mut terminal, &cells).as_bytes());
        for (x, y) in (0..ROWS).flat_map(|y| (0..COLUMNS).map(move |x| (x, y))) {
            let drawn = cells.iter().find(|cell| (cell.0, cell.1) == (x, y));
            let (symbol, style) = drawn.map_or((" ", Style::new()), |cell| (cell.2, cell.3));
            assert_shown(screen.screen().cell(y, x).unwrap(), symbol, style);
        }
    }
}

#[track_caller]
fn assert_shown(shown: &vt100::Cell, symbol: &str, style: Style) {
    let contents = if shown.has_contents() {
        shown.contents()
    } else {
        " "
    };
    assert_eq!(contents, symbol);
    let reversed = style.add_modifier.contains(Modifier::REVERSED);
    assert_eq!(shown.inverse(), reversed);
    // Other styles are invisible on a blank that is not reversed.
    if symbol == " " && !reversed {
        return;
    }
    assert_eq!(shown.bold(), style.add_modifier.contains(Modifier::BOLD));
    let colour = match style.fg {
        Some(Color::Red) => vt100::Color::Idx(1),
        Some(Color::Indexed(index)) => vt100::Color::Idx(index),
        _ => vt100::Color::Default,
    };
    assert_eq!(shown.fgcolor(), colour);
}

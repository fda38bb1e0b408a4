//! Tests of the whole chart in a buffer.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::braille::BRAILLE;
use ratatui::widgets::Widget;

use super::glyphs::rulers;
use super::*;

mod views;

const DECIBEL: Level = Level::Decibel {
    factor: 20.0,
    reference: 1e-6,
};

fn render(chart: &Chart<'_>, width: u16, height: u16) -> Buffer {
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    chart.render(area, &mut buffer);
    buffer
}

fn lines(buffer: &Buffer) -> Vec<String> {
    let row = |y| {
        (0..buffer.area.width)
            .map(|x| buffer[(x, y)].symbol().to_owned())
            .collect()
    };
    (0..buffer.area.height).map(row).collect()
}

/// The dots drawn in the plot, as columns and rows from its top left.
fn dots(chart: &Chart<'_>, buffer: &Buffer) -> Vec<(u16, u16)> {
    let plot = chart.plot_area(buffer.area);
    let mut dots = Vec::new();
    for position in plot.positions() {
        let symbol = buffer[position].symbol().chars().next().unwrap();
        let bits = BRAILLE
            .iter()
            .position(|braille| *braille == symbol)
            .unwrap_or(0);
        for bit in (0..8_u16).filter(|bit| bits >> bit & 1 == 1) {
            dots.push((
                2 * (position.x - plot.x) + bit % 2,
                4 * (position.y - plot.y) + bit / 2,
            ));
        }
    }
    dots
}

/// A chart over 0..10 and 1e-4..1 with curves only.
fn plain<'a>(curves: &'a [Curve<'a>]) -> Chart<'a> {
    let x = Axis::new(Scale::Linear, [0.0, 10.0], "");
    let y = Axis::new(Scale::Log, [1e-4, 1.0], "").with_notation(Notation::Power);
    Chart {
        legend: Legend::Hidden,
        ..Chart::new(x, y, Level::Magnitude, curves)
    }
}

/// Magnitudes of an oscillator with resonances at 7.4, 31, 71, 128 and 201 Hz.
fn response(x: &[f64], loss: f64) -> Vec<f64> {
    let mode = |frequency: f64, resonance: f64| {
        let stiffness = resonance * resonance;
        1e-3 / (stiffness - frequency * frequency).hypot(loss * stiffness)
    };
    let modes = [7.4, 31.0, 71.0, 128.0, 201.0];
    x.iter()
        .map(|f| modes.map(|resonance| mode(*f, resonance)).iter().sum())
        .collect()
}

struct Family {
    x: Vec<f64>,
    y: [Vec<f64>; 3],
}

impl Family {
    fn new() -> Self {
        let x: Vec<f64> = (1..=1000).map(|k| f64::from(k) * 0.4).collect();
        let y = [(0.002, 1.0), (0.02, 3.0), (0.1, 0.1)]
            .map(|(loss, gain)| response(&x, loss).iter().map(|y| gain * y).collect());
        Self { x, y }
    }

    fn curves(&self) -> Vec<Curve<'_>> {
        let looks = [
            ("loss 0.002", Some('○'), LineStyle::Solid),
            ("loss 0.02", Some('b'), LineStyle::Dashed),
            ("before", None, LineStyle::Dotted),
        ];
        self.y
            .iter()
            .zip(looks)
            .map(|(y, (label, marker, line))| Curve {
                label: label.to_owned(),
                marker,
                line,
                dim: marker.is_none(),
                ..Curve::new(&self.x, y)
            })
            .collect()
    }
}

fn full<'a>(curves: &'a [Curve<'a>], glyphs: Glyphs) -> Chart<'a> {
    let x = Axis::new(Scale::Log, [1.0, 400.0], "Hz");
    let y = Level::Magnitude.axis(curves, &x, "m/N");
    Chart {
        title: "w at right |H|, 0-peak".to_owned(),
        cursor: Some(50.0),
        grid: true,
        glyphs,
        ..Chart::new(x, y, Level::Magnitude, curves)
    }
}

#[test]
fn a_peak_of_one_sample_keeps_its_height() {
    let count = 20_000;
    let x: Vec<f64> = (0..count)
        .map(|k| 10.0 * f64::from(k) / f64::from(count - 1))
        .collect();
    for peak in [1, 777, 9_999, 15_432, 19_998] {
        for height in [0.9, 0.02, 3e-3] {
            let mut y = vec![1e-3; x.len()];
            y[peak] = height;
            let curves = [Curve::new(&x, &y)];
            let chart = plain(&curves);
            let buffer = render(&chart, 20, 12);
            let plot = chart.plot_area(buffer.area);
            let row = (-height.log10() / 4.0 * f64::from(4 * plot.height - 1)).round() as u16;
            let column = (x[peak] / 10.0 * f64::from(2 * plot.width - 1)).round() as u16;
            let dots = dots(&chart, &buffer);
            assert_eq!(dots.iter().map(|dot| dot.1).min(), Some(row));
            assert!(dots.contains(&(column, row)), "{peak} {height}");
        }
    }
}

#[test]
fn a_value_that_cannot_be_drawn_is_a_gap() {
    let x: Vec<f64> = (0..=10).map(f64::from).collect();
    for hole in [f64::NAN, 0.0, f64::INFINITY, f64::NEG_INFINITY, -1.0] {
        let mut y = vec![1e-2; 11];
        y[5] = hole;
        let curves = [Curve::new(&x, &y)];
        let chart = plain(&curves);
        let buffer = render(&chart, 46, 12);
        let last = f64::from(2 * chart.plot_area(buffer.area).width - 1);
        let rows: Vec<u16> = dots(&chart, &buffer).iter().map(|dot| dot.1).collect();
        assert!(
            rows.windows(2).all(|pair| pair[0] == pair[1]),
            "{hole} left the level"
        );
        let mut columns: Vec<u16> = dots(&chart, &buffer).iter().map(|dot| dot.0).collect();
        columns.sort_unstable();
        let (before, after) = ((0.4 * last).round() as u16, (0.6 * last).round() as u16);
        let expected: Vec<u16> = (0..=before).chain(after..=last as u16).collect();
        assert_eq!(columns, expected, "{hole}");
    }
}

#[test]
fn a_steep_line_is_connected_and_one_dot_thin() {
    let curves = [Curve::new(&[0.0, 5.0, 10.0], &[1e-4, 1.0, 1e-4])];
    let chart = plain(&curves);
    let buffer = render(&chart, 16, 30);
    let dots = dots(&chart, &buffer);
    let plot = chart.plot_area(buffer.area);
    for row in 0..4 * plot.height {
        let count = dots.iter().filter(|dot| dot.1 == row).count();
        assert!((1..=2).contains(&count) || row < 4, "row {row}: {count}");
    }
}

#[test]
fn curves_are_clipped_at_the_bounds() {
    // The curve enters at 1e-2 on the left, leaves at x = 2.5 and returns at x = 7.5.
    let curves = [Curve::new(&[-10.0, 5.0, 20.0], &[1e-10, 1e2, 1e-10])];
    let chart = plain(&curves);
    let buffer = render(&chart, 40, 12);
    let dots = dots(&chart, &buffer);
    let last = 2 * chart.plot_area(buffer.area).width - 1;
    for (column, _) in &dots {
        let from_side = *column.min(&(last - column));
        assert!(
            f64::from(from_side) <= 0.25 * f64::from(last) + 1.0,
            "{column}"
        );
    }
    for column in [0, last / 4, last - last / 4, last] {
        assert!(dots.iter().any(|dot| dot.0 == column), "{column}");
    }
    assert!(dots.iter().any(|dot| dot.1 == 0));
    let outside = [Curve::new(&[1.0, 2.0], &[1e5, 1e6])];
    assert!(
        lines(&render(&plain(&outside), 40, 12))
            .join("")
            .contains("no value within the axes")
    );
}

#[test]
fn sparse_points_are_joined_by_straight_lines() {
    let curves = [Curve::new(&[0.0, 10.0], &[1e-4, 1.0])];
    let chart = plain(&curves);
    let buffer = render(&chart, 60, 12);
    let plot = chart.plot_area(buffer.area);
    let [columns, rows] = [2 * plot.width - 1, 4 * plot.height - 1].map(f64::from);
    for (column, row) in dots(&chart, &buffer) {
        let expected = rows - f64::from(column) / columns * rows;
        assert!((f64::from(row) - expected).abs() <= 1.0);
    }
}

#[test]
fn labels_are_below_their_ticks() {
    let family = Family::new();
    let curves = family.curves();
    let log = Axis::new(Scale::Log, [1.0, 400.0], "Hz");
    // Too wide for decades, too narrow for 1, 2 and 5: some labels are left out.
    let awkward = Axis::new(Scale::Log, [0.02, 0.8], "Hz");
    for (x, widths) in [(log, 12..160), (awkward, 12..40)] {
        let chart = Chart {
            x,
            ..full(&curves, Glyphs::Braille)
        };
        for width in widths {
            let buffer = render(&chart, width, 16);
            let lines = lines(&buffer);
            for label in lines[15].split_whitespace().filter(|label| *label != "Hz") {
                let value: f64 = label.parse().unwrap();
                let tick = usize::from(chart.column(buffer.area, value).unwrap());
                let mark = lines[14].chars().nth(tick);
                assert!(matches!(mark, Some('┬' | '▲')), "{width}: {mark:?}");
                let near =
                    tick.saturating_sub(label.len())..(tick + label.len()).min(lines[15].len());
                let below = lines[15][near].contains(label);
                assert!(
                    below && lines[15].as_bytes()[tick] != b' ',
                    "{width}: {}",
                    lines[15]
                );
            }
        }
    }
}

#[test]
fn no_size_is_too_small() {
    let family = Family::new();
    let curves: Vec<Curve<'_>> = family.curves();
    for glyphs in [Glyphs::Braille, Glyphs::Ascii] {
        for legend in [Legend::Hidden, Legend::Inside, Legend::Line] {
            let chart = Chart {
                legend,
                ..full(&curves, glyphs)
            };
            for width in 0..40 {
                for height in 0..20 {
                    render(&chart, width, height);
                }
            }
        }
    }
    let mut buffer = Buffer::empty(Rect::new(0, 0, 10, 10));
    full(&curves, Glyphs::Braille).render(Rect::new(5, 5, 30, 30), &mut buffer);
    full(&curves, Glyphs::Braille).render(Rect::new(50, 50, 30, 30), &mut buffer);
}

#[test]
fn odd_curves_do_not_panic() {
    let odd = [
        Curve::new(&[], &[]),
        Curve::new(&[1.0, 2.0, 3.0], &[0.1]),
        Curve::new(&[3.0, 2.0, 1.0], &[0.1, 0.2, 0.3]),
        Curve::new(&[f64::NAN, f64::INFINITY, 1e300], &[1e300, 0.1, 1e-300]),
        Curve::new(&[-1e300, 1e300], &[f64::MIN_POSITIVE, f64::MAX]),
    ];
    for x in [
        Axis::new(Scale::Linear, [0.0, 1e-300], ""),
        Axis::new(Scale::Log, [1e-300, 1e300], ""),
    ] {
        for level in [Level::Magnitude, DECIBEL, Level::Signed, Level::Degrees] {
            let y = level.axis(&odd, &x, "");
            render(&Chart::new(x.clone(), y, level, &odd), 60, 20);
        }
    }
    let axes = nyquist_axes(&odd, [None; 2], [String::new(), String::new()]);
    let area = Rect::new(0, 0, 60, 20);
    render(&Chart::nyquist(axes, &odd).equalised(area), 60, 20);
}

#[test]
fn without_a_finite_value_the_plot_says_so() {
    let nothing = [Curve::new(&[1.0, 2.0], &[f64::NAN, 0.0])];
    for curves in [&nothing[..], &[]] {
        let buffer = render(&plain(curves), 40, 12);
        assert!(lines(&buffer).join("").contains("no finite value to draw"));
    }
}

#[test]
fn line_styles_differ() {
    let family = Family::new();
    let drawn = [LineStyle::Solid, LineStyle::Dashed, LineStyle::Dotted].map(|line| {
        let curves = [Curve {
            line,
            ..Curve::new(&family.x, &family.y[0])
        }];
        let chart = full(&curves, Glyphs::Braille);
        let buffer = render(&chart, 60, 20);
        dots(&chart, &buffer)
    });
    assert!(drawn[0].len() > drawn[1].len() && drawn[1].len() > drawn[2].len());
    assert!(
        drawn[1]
            .iter()
            .chain(&drawn[2])
            .all(|dot| drawn[0].contains(dot))
    );
}

#[test]
fn ascii_is_ascii() {
    let family = Family::new();
    let curves = family.curves();
    for (width, height) in [(80, 24), (30, 10), (24, 7)] {
        let lines = lines(&render(&full(&curves, Glyphs::Ascii), width, height));
        assert!(lines.iter().all(|line| line.is_ascii()), "{lines:#?}");
    }
}

#[test]
fn each_curve_carries_its_marker_and_style() {
    let family = Family::new();
    let mut curves = family.curves();
    curves[1].style = Style::new().fg(Color::Red);
    let chart = full(&curves, Glyphs::Braille);
    let buffer = render(&chart, 70, 20);
    let text = lines(&buffer).join("");
    assert!(text.matches('○').count() >= 3, "two markers and the legend");
    assert!(text.contains("╌b╌ loss 0.02"));
    let red = buffer.content().iter().filter(|cell| cell.fg == Color::Red);
    assert!(red.count() > 20);
    let dim = buffer
        .content()
        .iter()
        .filter(|cell| cell.modifier.contains(Modifier::DIM));
    assert!(dim.count() > 5);
}

#[test]
fn the_legend_stays_within_its_share() {
    let family = Family::new();
    let mut curves = family.curves();
    curves[2].label = "a label much longer than anything that fits next to a curve".to_owned();
    for width in 10..120 {
        for height in 5..30 {
            let chart = full(&curves, Glyphs::Braille);
            let buffer = render(&chart, width, height);
            let plot = chart.plot_area(buffer.area);
            let lines = lines(&buffer);
            let inside = |y: u16| {
                (plot.y..plot.bottom()).contains(&y) && lines[usize::from(y)].contains("╌b╌")
            };
            if (0..height).any(inside) {
                let columns = lines[usize::from(plot.y)]
                    .split(" ─○─")
                    .nth(1)
                    .unwrap()
                    .chars()
                    .count()
                    + 4;
                assert!(columns * 3 * 100 <= usize::from(plot.width * plot.height) * 40);
            }
        }
    }
    let wide = lines(&render(&full(&curves, Glyphs::Braille), 60, 20)).join("\n");
    assert!(wide.contains("┈┈┈ a label much longer t…"), "{wide}");
    let line = Chart {
        legend: Legend::Line,
        ..full(&curves, Glyphs::Braille)
    };
    let line = lines(&render(&line, 60, 20)).join("\n");
    assert!(
        line.contains("─○─ loss 0.002  ╌b╌ loss 0.02  ┈┈┈ a label much longer than…"),
        "{line}"
    );
}

#[test]
fn the_cursor_is_at_its_frequency() {
    let curves = [Curve::new(&[0.0, 10.0], &[1e-3, 1e-3])];
    let chart = Chart {
        cursor: Some(2.5),
        ..plain(&curves)
    };
    let buffer = render(&chart, 48, 12);
    let column = chart.column(buffer.area, 2.5).unwrap();
    let plot = chart.plot_area(buffer.area);
    let line = (plot.top()..plot.bottom()).filter(|y| buffer[(column, *y)].symbol() == "│");
    assert_eq!(
        line.count(),
        usize::from(plot.height) - 1,
        "all but the curve's cell"
    );
    assert_eq!(buffer[(column, plot.bottom())].symbol(), "▲");
    let away = Chart {
        cursor: Some(11.0),
        ..chart
    };
    assert_eq!(away.column(buffer.area, 11.0), None);
    assert!(!lines(&render(&away, 48, 12)).join("").contains('▲'));
}

#[test]
fn the_unit_is_written_once() {
    let family = Family::new();
    let curves = family.curves();
    for width in 20..120 {
        let text = lines(&render(&full(&curves, Glyphs::Braille), width, 20)).join("\n");
        assert_eq!(text.matches("Hz").count(), 1, "{text}");
        assert_eq!(text.matches("m/N").count(), 1, "{text}");
    }
}

fn picture(chart: &Chart<'_>) -> String {
    let lines = lines(&render(chart, 58, 20));
    lines
        .iter()
        .map(|line| line.trim_end().to_owned() + "\n")
        .collect()
}

#[test]
fn pictures() {
    let family = Family::new();
    let curves = family.curves();
    insta::assert_snapshot!(picture(&full(&curves, Glyphs::Braille)), @r"
    m/N  w at right |H|, 0-peak
    1e-3┤┈┈┈┈┈┈┼┈┈┈┈┈┈┈┼┈┈⡎┈┈┼┈┈┈┈┈┼┈┈┈┈┈┈┈│┈┈┈ ─○─ loss 0.002
        │      ┊       ┊  ⡕⣇ ┊     ┊       │    ╌b╌ loss 0.02
    1e-4┤┈┈┈┈┈┈┼┈┈┈┈┈┈⢀⣀⠔⢀⠇⡏┈┼┈┈┈┈┈┼┈┈┈⡄┈┈┈│┈┈┈ ┈┈┈ before
        │⠤⠤⠄ ⠠⠒⠒  ⠒⠒⠂b ┊⡠⠚ ⠸⡀⠢⣄    ┊  ⢀⡇   │     ┊     ┊
        │⣀⣀⣀⣀○⣀⣀⣀⡠⠤⠤⠤⠒⠒⠉    ⠈⢆  ⠠⣀ ┊  ⡀⣿⡀  │  ⢸  ┊ ⢰   ┊
    1e-5┤┈┈┈┈┈┈┼┈┈┈┈┈┈┈┼┈┈⠂⠂┈┼⠑⠦⣀┈⠉┼⠐⠋⢰⢹⠁⡀┈│┈┈⣸┈┈┼┈⢸┈┈┈⢀┈┈┈┈┈┈
        │      ┊       ┊⠄⠈ ⠈⡀┊  ⠈⠙⠒⠤⠤⠴⠃ ○⠈⠓│⢠⠴⣿⣇ ┊ ⢸   ⢸
        │⠄⠠ ⠄⠠ ⠄⠠ ⠄⠐ ⠂⠈┊     ⠠     ┊     ⠓⢤⣀ ⣠⠏⡆⠠b⡀⢾⣇  ⣸
    1e-6┤┈┈┈┈┈┈┼┈┈┈┈┈┈┈┼┈┈┈┈┈┼┈⠡⢀┈┈┼┈┈┈⢂┈┈┈⠈⠉⠁┈⠹⣄⡀⢀⡏⡇⠠⠤⢹⠁┈┈┈┈┈
        │      ┊       ┊     ┊   ⠈⠐┊⠂⠈⠁ ⠠  │     ⠉⠉ ⠹⣄⢀⡟⡖⢦
        │      ┊       ┊     ┊     ┊     ⠁⠂⡀⢀⢀⠄⠂ ┊   ⠈⠉┊⠳⡄ ⠦⡄
    1e-7┤┈┈┈┈┈┈┼┈┈┈┈┈┈┈┼┈┈┈┈┈┼┈┈┈┈┈┼┈┈┈┈┈┈┈│┈┈┈⠈⠄⡀⢀⠐⡀┈┈┼┈⠙⠲⣄┈⠐
        │      ┊       ┊     ┊     ┊       │     ┊  ⠐⠠⢀⠠   ⠈⠙⠦
        │      ┊       ┊     ┊     ┊       │     ┊     ┊⠡⢀
    1e-8┤┈┈┈┈┈┈┼┈┈┈┈┈┈┈┼┈┈┈┈┈┼┈┈┈┈┈┼┈┈┈┈┈┈┈│┈┈┈┈┈┼┈┈┈┈┈┼┈┈⠂⠄⡀┈
        │      ┊       ┊     ┊     ┊       │     ┊     ┊     ⠁
    1e-9┤┈┈┈┈┈┈┼┈┈┈┈┈┈┈┼┈┈┈┈┈┼┈┈┈┈┈┼┈┈┈┈┈┈┈│┈┈┈┈┈┼┈┈┈┈┈┼┈┈┈┈┈┈
        └┬─────┬──┴──┴─┬┴─┴┴┴┬─────┬───┴─┴─▲─┴┴┴┴┬─────┬───┴─┴
         1     2       5     10    20      50   100   200   Hz
    ");
    insta::assert_snapshot!(picture(&full(&curves, Glyphs::Ascii)), @r"
    m/N  w at right |H|, 0-peak
    1e-3+      +       +   b +     +       |    aaa loss 0.002
        |                 bb               |    bbb loss 0.02
        |                 abb          b   |    ... before
    1e-4+bbbbb +  bbbbb+ a a +     +   b   |     +     +
        |     aaaaaaaaaaa   aa bbb     bb  |  b    a
    1e-5+aaaaa +       +  .  aaaabb+  ba   |  b  + b   a
        |                   .   aaaaaaaaa  bbba    b   b
        |.  .  .  .  . .      .         aaaa aaa bbb   b
    1e-6+      +       +     +  .  +   .   aaa aaaaaa  bb
        |                         .  .     |     aa aaaab
        |                                . |.  .        aa  bb
    1e-7+      +       +     +     +       |     .  .  + aaaab
        |                                  |          .     aa
    1e-8+      +       +     +     +       |     +     +.
        |                                  |              .  .
        |                                  |
    1e-9+      +       +     +     +       |     +     +
        ++-----+---|-|-+-||||+-----+---|-|-^-||||+-----+---|-|
         1     2       5     10    20      50   100   200   Hz
    ");
}

#[test]
fn marks_are_at_their_values_below_the_labels() {
    let (x, y) = ([0.0, 10.0], [1e-2, 1e-1]);
    let curves = [Curve::new(&x, &y)];
    let mut chart = plain(&curves);
    chart.marks = Marks {
        name: "modes",
        // Two in one column, three in another, one outside the axis.
        values: vec![0.0, 2.0, 2.001, 7.0, 7.001, 7.002, 12.0],
        selected: Some(1),
    };
    chart.styles.selected_mark = Style::new().add_modifier(Modifier::REVERSED);
    let buffer = render(&chart, 60, 12);
    let marks = &lines(&buffer)[11];
    let column = |value| usize::from(chart.column(buffer.area, value).unwrap());
    for (value, mark) in [(0.0, '╵'), (2.0, '╹'), (7.0, '┃')] {
        assert_eq!(marks.chars().nth(column(value)), Some(mark), "{marks}");
    }
    assert_eq!(
        marks.chars().filter(|c| *c != ' ').count(),
        3 + "modes".len()
    );
    let selected = &buffer[(column(2.0) as u16, 11)];
    assert!(selected.modifier.contains(Modifier::REVERSED));
    // In a low area the plot takes their row.
    assert!(!lines(&render(&chart, 60, 5))[4].contains('╵'));
}

#[test]
fn a_pole_reaches_the_top_with_a_mark() {
    let (x, y) = ([0.0, 10.0], [1e-3, 1e-3]);
    let curves = [Curve {
        poles: vec![4.0, 40.0],
        ..Curve::new(&x, &y)
    }];
    let chart = plain(&curves);
    let buffer = render(&chart, 40, 12);
    let plot = chart.plot_area(buffer.area);
    let column = chart.column(buffer.area, 4.0).unwrap();
    assert_eq!(buffer[(column, plot.y)].symbol(), "↑");
    // The curve is three quarters down.
    for y in plot.y + 1..plot.y + 3 * plot.height / 4 {
        assert_ne!(buffer[(column, y)].symbol(), " ", "row {y}");
    }
    assert_eq!(lines(&buffer)[usize::from(plot.y)].matches('↑').count(), 1);
}

#[test]
fn points_are_marked_some_cells_apart() {
    let x: Vec<f64> = (0..=1000).map(|k| 0.01 * f64::from(k)).collect();
    let y = vec![1e-2; x.len()];
    let marked = |apart| {
        let curves = [Curve {
            marker: Some('o'),
            line: LineStyle::Points { apart },
            ..Curve::new(&x, &y)
        }];
        let chart = plain(&curves);
        let buffer = render(&chart, 50, 12);
        let columns = usize::from(chart.plot_area(buffer.area).width);
        (lines(&buffer).concat().matches('o').count(), columns)
    };
    let (every, columns) = marked(0);
    assert_eq!(every, columns);
    assert_eq!(marked(4).0, columns.div_ceil(4));
}

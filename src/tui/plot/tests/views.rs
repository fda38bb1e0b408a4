//! Tests of signed values, phases, stacked charts, Nyquist plots and marks.

use super::*;

/// A mass on a spring with a loss factor of 0.1, its resonance at 10: real and imaginary part and phase (degrees) of
/// 1 / (1 - (f / 10)^2 + 0.1 i).
struct Oscillator {
    x: Vec<f64>,
    real: Vec<f64>,
    imaginary: Vec<f64>,
    magnitude: Vec<f64>,
    phase: Vec<f64>,
}

impl Oscillator {
    fn new() -> Self {
        let x: Vec<f64> = (0..=2000).map(|k| 0.01 * f64::from(k)).collect();
        let parts = |f: &f64| {
            let (a, b) = (1.0 - f * f / 100.0, 0.1);
            let square = a * a + b * b;
            (a / square, -b / square)
        };
        let (real, imaginary): (Vec<f64>, Vec<f64>) = x.iter().map(parts).unzip();
        let both = || real.iter().zip(&imaginary);
        Self {
            magnitude: both().map(|(a, b)| a.hypot(*b)).collect(),
            phase: both().map(|(a, b)| b.atan2(*a).to_degrees()).collect(),
            x,
            real,
            imaginary,
        }
    }
}

fn chart<'a>(level: Level, curves: &'a [Curve<'a>], unit: &str) -> Chart<'a> {
    let x = Axis::new(Scale::Linear, [0.0, 20.0], "Hz");
    let y = level.axis(curves, &x, unit);
    Chart::new(x, y, level, curves)
}

fn text(widget: impl Widget, [width, height]: [u16; 2]) -> Vec<String> {
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    widget.render(area, &mut buffer);
    lines(&buffer)
}

#[test]
fn signed_values_are_at_their_heights_around_zero() {
    let x: Vec<f64> = (0..=20).map(f64::from).collect();
    let y: Vec<f64> = x.iter().map(|x| 2.0 - 0.3 * x).collect();
    let curves = [Curve::new(&x, &y)];
    let chart = chart(Level::Signed, &curves, "");
    // -4..2 is 6; an eighth of it is 0.75, so the step is 1.
    assert_eq!(chart.y.bounds(), [-4.0, 2.0]);
    let buffer = render(&chart, 60, 24);
    let plot = chart.plot_area(buffer.area);
    let [columns, rows] = [2 * plot.width - 1, 4 * plot.height - 1].map(f64::from);
    let dots = dots(&chart, &buffer);
    assert!(dots.len() >= usize::from(2 * plot.width));
    for (column, row) in dots {
        let value = 2.0 - 6.0 * f64::from(column) / columns;
        let expected = (2.0 - value) / 6.0 * rows;
        assert!((f64::from(row) - expected).abs() <= 1.0, "{column} {row}");
    }
    let zero = plot.y + ((2.0 / 6.0 * rows).round() as u16) / 4;
    assert_eq!(buffer[(plot.right() - 1, zero)].symbol(), "┈");
    assert_eq!(buffer[(plot.right() - 1, zero + 1)].symbol(), " ");
}

#[test]
fn the_wrapping_of_a_phase_is_no_line() {
    let x: Vec<f64> = (0..=20).map(f64::from).collect();
    // Falls by 40 degrees a sample from 170: wraps between 8 and 9, and between 17 and 18.
    let wrapped: Vec<f64> = x
        .iter()
        .map(|x| (170.0 - 40.0 * x + 180.0).rem_euclid(360.0) - 180.0)
        .collect();
    let curves = [Curve::new(&x, &wrapped)];
    let chart = chart(Level::Degrees, &curves, "deg");
    assert_eq!(chart.y.bounds(), [-180.0, 180.0]);
    let buffer = render(&chart, 100, 24);
    let plot = chart.plot_area(buffer.area);
    let last = f64::from(2 * plot.width - 1);
    let columns: Vec<u16> = dots(&chart, &buffer).iter().map(|dot| dot.0).collect();
    for (before, after) in [(8.0, 9.0), (17.0, 18.0)] {
        let gap = (before / 20.0 * last).round() as u16 + 1..(after / 20.0 * last).round() as u16;
        assert!(gap.len() > 5);
        assert!(gap.into_iter().all(|column| !columns.contains(&column)));
    }
    // A fall of 100 degrees is none.
    let fall = [80.0, -20.0];
    let curves = [Curve::new(&[0.0, 20.0], &fall)];
    let chart = self::chart(Level::Degrees, &curves, "deg");
    let buffer = render(&chart, 100, 24);
    let mut columns: Vec<u16> = dots(&chart, &buffer).iter().map(|dot| dot.0).collect();
    columns.sort_unstable();
    columns.dedup();
    assert_eq!(columns.len(), usize::from(2 * plot.width));
}

fn pair<'a>(upper: &'a [Curve<'a>], lower: &'a [Curve<'a>], glyphs: Glyphs) -> StackedCharts<'a> {
    let upper = Chart {
        cursor: Some(10.0),
        glyphs,
        marks: Marks {
            name: "modes",
            values: vec![10.0],
            selected: None,
        },
        ..chart(Level::Magnitude, upper, "m/N, 0-peak")
    };
    StackedCharts::new(upper, chart(Level::Degrees, lower, "phase, deg"))
}

#[test]
fn stacked_charts_share_the_horizontal_axis() {
    let oscillator = Oscillator::new();
    let upper = [Curve::new(&oscillator.x, &oscillator.magnitude)];
    let lower = [Curve::new(&oscillator.x, &oscillator.phase)];
    for glyphs in [Glyphs::Braille, Glyphs::Block, Glyphs::Ascii] {
        let pair = pair(&upper, &lower, glyphs);
        for (width, height) in [(44, 21), (44, 12), (78, 35), (23, 12)] {
            let area = Rect::new(0, 0, width, height);
            let [top, bottom] = pair.plot_areas(area);
            assert_eq!((top.x, top.width), (bottom.x, bottom.width));
            assert!(top.height >= 3 && bottom.height >= 3, "{top} {bottom}");
            let lines = text(&pair, [width, height]);
            let at = |x: u16, y: u16| lines[usize::from(y)].chars().nth(usize::from(x));
            let cursor = top.x + pair.upper.cell(top, 10.0).unwrap();
            let (line, foot) = if glyphs == Glyphs::Ascii {
                (Some('|'), Some('^'))
            } else {
                (Some('│'), Some('▲'))
            };
            for plot in [top, bottom] {
                let rows = (plot.y..plot.bottom()).filter(|y| at(cursor, *y) == line);
                assert!(rows.count() >= 1, "{lines:#?}");
            }
            assert_eq!(at(cursor, bottom.bottom()), foot);
            // The frequency labels are below the lower plot only.
            let all = lines.join("\n");
            assert_eq!(all.matches("Hz").count(), 1, "{all}");
            assert!(lines[usize::from(bottom.bottom()) + 1].contains("Hz"));
            assert_eq!(all.matches("deg").count(), 1);
            assert_eq!(bottom.bottom() + 3, height);
        }
    }
}

#[test]
fn a_plot_without_a_phase_says_so_and_keeps_the_cursor() {
    let oscillator = Oscillator::new();
    let upper = [Curve::new(&oscillator.x, &oscillator.magnitude)];
    let gaps = vec![f64::NAN; oscillator.x.len()];
    let lower = [Curve::new(&oscillator.x, &gaps)];
    let pair = pair(&upper, &lower, Glyphs::Braille);
    let [_, plot] = pair.plot_areas(Rect::new(0, 0, 44, 21));
    let cursor = usize::from(plot.x + pair.lower.cell(plot, 10.0).unwrap());
    let lines = text(&pair, [44, 21]);
    let lower = &lines[usize::from(plot.y)..usize::from(plot.bottom())];
    assert!(lower.concat().contains("no phase to draw"));
    let crossed = lower
        .iter()
        .filter(|line| line.chars().nth(cursor) == Some('│'));
    // All rows except that of the message.
    assert_eq!(crossed.count(), lower.len() - 1);
}

#[test]
fn a_low_area_shows_the_upper_chart_only() {
    let oscillator = Oscillator::new();
    let upper = [Curve::new(&oscillator.x, &oscillator.magnitude)];
    let lower = [Curve::new(&oscillator.x, &oscillator.phase)];
    let pair = pair(&upper, &lower, Glyphs::Braille);
    let alone = text(&pair, [44, 11]);
    assert_eq!(alone, text(&pair.upper, [44, 11]));
    let [top, bottom] = pair.plot_areas(Rect::new(0, 0, 44, 11));
    assert!(bottom.is_empty() && top.height == 7);
}

/// A Nyquist plot of all of the curves.
fn locus<'a>(curves: &'a [Curve<'a>]) -> Chart<'a> {
    let units = ["Re, m/N", "Im, m/N"].map(str::to_owned);
    Chart::nyquist(nyquist_axes(curves, [None; 2], units), curves)
}

#[test]
fn nyquist_axes_have_equal_scales() {
    let oscillator = Oscillator::new();
    let curves = [Curve::new(&oscillator.real, &oscillator.imaginary)];
    // The sides of a dot, in widths of a cell.
    for (glyphs, wide, high) in [
        (Glyphs::Braille, 0.5, 0.5),
        (Glyphs::Block, 0.5, 1.0),
        (Glyphs::Dot, 1.0, 2.0),
        (Glyphs::Ascii, 1.0, 2.0),
    ] {
        for (width, height) in [(44, 21), (78, 24), (20, 40), (12, 4)] {
            let area = Rect::new(0, 0, width, height);
            let mut chart = locus(&curves);
            chart.glyphs = glyphs;
            let wanted = [chart.x.bounds(), chart.y.bounds()];
            let chart = chart.equalised(area);
            let plot = chart.plot_area(area);
            let [across, down] = rulers(plot.width, plot.height, glyphs);
            let span = |axis: &Axis| axis.bounds()[1] - axis.bounds()[0];
            let x = span(&chart.x) / (f64::from(across.dots() - 1) * wide);
            let y = span(&chart.y) / (f64::from(down.dots() - 1) * high);
            assert!((x / y - 1.0).abs() < 1e-9, "{width} {height}: {x} {y}");
            for (axis, wanted) in [&chart.x, &chart.y].into_iter().zip(wanted) {
                let bounds = axis.bounds();
                assert!(bounds[0] <= wanted[0] + 1e-9 && bounds[1] >= wanted[1] - 1e-9);
            }
        }
    }
}

#[test]
fn a_circle_is_round() {
    let points = 720;
    let angle = |k: i32| f64::from(k) * std::f64::consts::TAU / f64::from(points);
    let x: Vec<f64> = (0..=points).map(|k| 3.0 + 5.0 * angle(k).cos()).collect();
    let y: Vec<f64> = (0..=points).map(|k| 5.0 * angle(k).sin()).collect();
    let curves = [Curve::new(&x, &y)];
    let area = Rect::new(0, 0, 60, 24);
    let chart = locus(&curves).equalised(area);
    let buffer = render(&chart, area.width, area.height);
    let plot = chart.plot_area(area);
    let [across, down] = rulers(plot.width, plot.height, Glyphs::Braille);
    let centre = [
        across.dot(chart.x.fraction(3.0)),
        down.dot(chart.y.fraction(0.0)),
    ];
    let radius = across.dot(chart.x.fraction(8.0)) - centre[0];
    let dots = dots(&chart, &buffer);
    assert!(dots.len() as f64 > 4.0 * radius, "{}", dots.len());
    for (column, row) in &dots {
        let distance = (f64::from(*column) - centre[0]).hypot(f64::from(*row) - centre[1]);
        assert!((distance - radius).abs() < 0.8, "{column} {row}");
    }
    // The zero lines cross at 0.
    let zero = (
        plot.x + across.cell(chart.x.fraction(0.0)).unwrap(),
        plot.y + down.cell(chart.y.fraction(0.0)).unwrap(),
    );
    assert_eq!(buffer[zero].symbol(), "┼");
}

#[test]
fn a_nyquist_curve_is_clipped_has_gaps_and_is_joined_in_its_order() {
    // Left along y = 1 from 9 to 1, a gap, then down along x = 0 from far above to far below.
    let x = [9.0, 1.0, f64::NAN, 0.0, 0.0];
    let y = [1.0, 1.0, 1.0, 1e6, -1e6];
    let curves = [Curve::new(&x, &y)];
    let bounds = [Some([-10.0, 10.0]), Some([-4.0, 4.0])];
    let axes = nyquist_axes(&curves, bounds, [String::new(), String::new()]);
    let chart = Chart::nyquist(axes, &curves);
    let buffer = render(&chart, 50, 20);
    let plot = chart.plot_area(buffer.area);
    let [across, down] = rulers(plot.width, plot.height, Glyphs::Braille);
    let column = |x: f64| across.dot(chart.x.fraction(x)).round() as u16;
    let row = down.dot(chart.y.fraction(1.0)).round() as u16;
    let mut expected: Vec<(u16, u16)> = (column(1.0)..=column(9.0)).map(|c| (c, row)).collect();
    expected.extend((0..down.dots()).map(|row| (column(0.0), row)));
    expected.sort_unstable();
    let mut dots = dots(&chart, &buffer);
    dots.sort_unstable();
    assert_eq!(dots, expected);
}

#[test]
fn a_spot_is_at_its_point_over_the_curve() {
    let oscillator = Oscillator::new();
    let curves = [Curve::new(&oscillator.real, &oscillator.imaginary)];
    let area = Rect::new(0, 0, 60, 24);
    let mut chart = locus(&curves).equalised(area);
    let style = Style::new().add_modifier(Modifier::BOLD);
    // At the resonance the receptance is -10 i; the other spot is outside the plot.
    let spot = |x, y| Spot {
        x,
        y,
        sign: '◆',
        style,
    };
    chart.spots = vec![spot(0.0, -10.0), spot(0.0, 1e3)];
    let buffer = render(&chart, area.width, area.height);
    let plot = chart.plot_area(area);
    let [across, down] = rulers(plot.width, plot.height, Glyphs::Braille);
    let place = (
        plot.x + across.cell(chart.x.fraction(0.0)).unwrap(),
        plot.y + down.cell(chart.y.fraction(-10.0)).unwrap(),
    );
    assert_eq!(buffer[place].symbol(), "◆");
    assert!(buffer[place].modifier.contains(Modifier::BOLD));
    assert_eq!(lines(&buffer).concat().matches('◆').count(), 1);
}

#[test]
fn cursors_harmonics_and_band_are_at_their_frequencies() {
    let y = [0.5; 2];
    let curves = [Curve::new(&[0.0, 20.0], &y)];
    for (glyphs, signs) in [
        (Glyphs::Braille, ["│", "┆", "┊", "╎", "╎", "━", "△"]),
        (Glyphs::Ascii, ["|", ":", "'", "[", "]", "=", "A"]),
    ] {
        let chart = Chart {
            cursor: Some(4.0),
            second: Some(6.5),
            harmonics: vec![8.0, 12.0, 16.0, 20.0],
            band: Some([9.0, 14.0]),
            glyphs,
            y: Axis::new(Scale::Linear, [0.0, 1.0], ""),
            ..chart(Level::Signed, &curves, "")
        };
        let buffer = render(&chart, 70, 14);
        let plot = chart.plot_area(buffer.area);
        let column = |value| plot.x + chart.cell(plot, value).unwrap();
        let [cursor, second, harmonic, low, high, heavy, foot] = signs;
        for (value, sign) in [
            (4.0, cursor),
            (6.5, second),
            (8.0, harmonic),
            (9.0, low),
            (14.0, high),
        ] {
            let rows = plot.y + 1..plot.bottom();
            let line = rows.filter(|y| buffer[(column(value), *y)].symbol() == sign);
            assert!(
                line.count() + 2 >= usize::from(plot.height),
                "{value} {sign}"
            );
        }
        for (value, number) in [(8.0, "2"), (12.0, "3"), (16.0, "4")] {
            assert_eq!(buffer[(column(value), plot.y)].symbol(), number);
        }
        // The axis and its ticks are heavy within the band and thin outside it.
        let axis = |value| buffer[(column(value), plot.bottom())].symbol();
        assert_eq!(axis(9.3), heavy);
        assert_eq!(axis(13.7), heavy);
        assert_ne!(axis(8.4), heavy);
        assert_ne!(axis(14.6), heavy);
        assert_eq!(axis(6.5), foot);
        let ascii = lines(&buffer).concat().is_ascii();
        assert_eq!(ascii, glyphs == Glyphs::Ascii);
    }
}

#[test]
fn a_band_beyond_the_axis_is_cut_off() {
    let y = [0.5; 2];
    let curves = [Curve::new(&[0.0, 20.0], &y)];
    let heavy = |band| {
        let chart = Chart {
            band: Some(band),
            ..chart(Level::Signed, &curves, "")
        };
        let buffer = render(&chart, 70, 14);
        let plot = chart.plot_area(buffer.area);
        let row = (plot.x..plot.right()).map(|x| buffer[(x, plot.bottom())].symbol().to_owned());
        let count = row.filter(|sign| "━┯┷".contains(sign.as_str())).count();
        (count, usize::from(plot.width))
    };
    let (all, width) = heavy([-5.0, 50.0]);
    assert_eq!(all, width);
    assert_eq!(heavy([25.0, 30.0]).0, 0);
    assert_eq!(heavy([-9.0, -5.0]).0, 0);
    let (half, width) = heavy([10.0, 50.0]);
    assert_eq!(half, width - width / 2);
}

/// Expected: on the axis from 0 to 20 a value is at its column, and its label is below it where the numbers leave room.
#[test]
fn a_mark_on_the_axis_is_at_its_value_with_the_label_that_fits() {
    let y = [0.5; 2];
    let curves = [Curve::new(&[0.0, 20.0], &y)];
    let drawn = |value, width, glyphs| {
        let chart = Chart {
            cursor: Some(4.0),
            band: Some([6.0, 12.0]),
            axis_mark: Some(AxisMark {
                value,
                labels: &["limit", "L"],
            }),
            glyphs,
            ..chart(Level::Signed, &curves, "")
        };
        let buffer = render(&chart, width, 14);
        let plot = chart.plot_area(buffer.area);
        let column = chart.cell(plot, value).map(|cell| plot.x + cell);
        let mut rows = lines(&buffer);
        let labels = rows.remove(usize::from(plot.bottom()) + 1);
        let axis = rows.remove(usize::from(plot.bottom()));
        (column.map(usize::from), axis, labels)
    };
    for (glyphs, sign) in [(Glyphs::Braille, '╫'), (Glyphs::Ascii, '!')] {
        // On the band, on a tick with a number, and next to the right end.
        for value in [7.5, 10.0, 19.5] {
            for (width, label) in [(200, "limit"), (110, "L")] {
                let (column, axis, labels) = drawn(value, width, glyphs);
                let column = column.unwrap();
                assert_eq!(axis.chars().position(|c| c == sign), Some(column));
                let at = labels.find(label);
                if value == 7.5 {
                    let at = at.unwrap_or_else(|| panic!("{labels}"));
                    assert!((at..at + label.len()).contains(&column), "{labels}");
                    // A blank on both sides.
                    assert!(labels.contains(&format!(" {label} ")), "{labels}");
                } else {
                    assert_eq!(at, None, "{labels}");
                }
            }
        }
        for value in [-1.0, 20.5, f64::INFINITY, f64::NAN] {
            let (column, axis, labels) = drawn(value, 110, glyphs);
            assert_eq!(column, None);
            assert!(
                !axis.contains(sign) && !labels.contains(['l', 'L']),
                "{axis}"
            );
        }
        // The cursor is over it.
        assert!(!drawn(4.0, 110, glyphs).1.contains(sign));
    }
}

#[test]
fn no_size_is_too_small_for_a_view() {
    let oscillator = Oscillator::new();
    let upper = [Curve {
        marker: Some('o'),
        label: "w".to_owned(),
        ..Curve::new(&oscillator.x, &oscillator.magnitude)
    }];
    let lower = [Curve::new(&oscillator.x, &oscillator.phase)];
    let locus = [Curve {
        marker: Some('o'),
        ..Curve::new(&oscillator.real, &oscillator.imaginary)
    }];
    for glyphs in [Glyphs::Braille, Glyphs::Ascii] {
        let mut pair = pair(&upper, &lower, glyphs);
        pair.upper.harmonics = vec![2.0, 19.9, 20.0];
        (pair.upper.band, pair.lower.band) = (Some([1.0, 2.0]), Some([1.0, 2.0]));
        (pair.upper.second, pair.lower.second) = (Some(3.0), Some(3.0));
        let mark = Some(AxisMark {
            value: 15.0,
            labels: &["limit", "L"],
        });
        (pair.upper.axis_mark, pair.lower.axis_mark) = (mark, mark);
        for width in 0..40 {
            for height in 0..24 {
                let area = Rect::new(0, 0, width, height);
                let mut buffer = Buffer::empty(area);
                pair.render(area, &mut buffer);
                let mut chart = self::locus(&locus);
                chart.glyphs = glyphs;
                chart.equalised(area).render(area, &mut buffer);
            }
        }
    }
}

#[test]
fn pictures_of_views() {
    let oscillator = Oscillator::new();
    let curve = |x, y| Curve {
        label: "w".to_owned(),
        ..Curve::new(x, y)
    };
    let upper = [curve(&oscillator.x, &oscillator.magnitude)];
    let lower = [curve(&oscillator.x, &oscillator.phase)];
    let picture = |lines: Vec<String>| -> String {
        let trimmed = lines.iter().map(|line| line.trim_end().to_owned() + "\n");
        trimmed.collect()
    };
    let pair = pair(&upper, &lower, Glyphs::Braille);
    // Golden.
    insta::assert_snapshot!(picture(text(&pair, [44, 21])), @r"
    m/N, 0-peak
     1e1┤                  ⣰⠛⣆             ─── w
        │                ⢀⡼⠁│⠘⣆
        │              ⢀⡴⠋  │ ⠈⢣⡀
        │         ⢀⣀⡤⠴⠚⠉    │   ⠙⠦⣄
     1e0┤⠤⠴⠒⠒⠒⠒⠒⠋⠉⠉         │     ⠈⠙⠦⣄⡀
        │                   │         ⠉⠙⠲⠤⣄⣀
        │                   │              ⠈⠉⠓⠒⠦
        │                   │
    1e-1┤                   │
        └┬────────┬─────────┼─────────┬────────┬
    phase, deg
     180┤                   │
        │                   │
        │                   │
       0┤⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠙⠒⠲⢤│
        │                  ⠈⢳⡀
    -180┤                   │⠙⠲⠤⠤⠤⢤⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀
        └┬────────┬─────────▲─────────┬────────┬
         0        5         10        15  Hz  20
    modes                   ╵
    ");
    let locus = [curve(&oscillator.real, &oscillator.imaginary)];
    let area = Rect::new(0, 0, 44, 21);
    let chart = self::locus(&locus);
    insta::assert_snapshot!(picture(text(&chart.equalised(area), [44, 21])), @r"
    Im, m/N
       │                    ┊              ─── w
      0┤┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈⣀⣀⡤⠤⠄┼┈⢀⣀⣀┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈
       │           ⣀⡴⠚⠉⠁    ┊   ⠈⠉⠓⢦⣀
       │         ⣠⠞⠁        ┊       ⠈⠳⣄
     -2┤       ⢠⠞⠁          ┊         ⠈⠳⡄
       │      ⢠⠃            ┊           ⠙⡄
       │     ⢠⠇             ┊            ⠸⡄
     -4┤     ⡜              ┊             ⢣
       │     ⡇              ┊             ⢸
       │     ⡇              ┊             ⢸
     -6┤     ⢳              ┊             ⡜
       │     ⠈⡆             ┊            ⢰⠃
       │      ⠙⣄            ┊           ⢠⠋
     -8┤       ⠈⢆⡀          ┊          ⡔⠃
       │         ⠑⢢         ┊       ⢀⠤⠋
       │           ⠉⠒⠤⣀⡀    ┊   ⢀⣀⠤⠒⠉
    -10┤               ⠉⠉⠓⠒⠒⠒⠒⠒⠉⠉
       │                    ┊
       └──┬──┴──┬──┴──┬──┴──┬─┴──┬──┴──┬──┴──┬──
          -6    -4    -2    0    2     4 Re, m/N
    ");
}

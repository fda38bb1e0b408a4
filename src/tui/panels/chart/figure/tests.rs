//! Tests of scenes as drawn in a buffer.

use ratatui::style::Modifier;

use super::*;
use crate::tui::options::{Environment, Options};
use crate::tui::scene::Marked;
use crate::tui::scene::axes::heading;
use crate::tui::scene::sample::{curve, frequencies, receptance, scene};
use crate::unit::FrequencyUnit;

fn ascii() -> Theme {
    let environment = Environment::default();
    let options = Options {
        ascii: Some(true),
        ..Options::default()
    };
    Theme::resolve(options, &environment)
}

fn drawn(scene: &Scene, theme: Theme, [width, height]: [u16; 2]) -> (Drawn, Buffer) {
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    let drawn = draw(scene, theme, area, &mut buffer);
    (drawn, buffer)
}

fn lines(buffer: &Buffer) -> Vec<String> {
    let row = |y| {
        let row = (0..buffer.area.width).map(|x| buffer[(x, y)].symbol());
        row.collect::<String>()
    };
    (0..buffer.area.height).map(row).collect()
}

fn text(scene: &Scene, theme: Theme, size: [u16; 2]) -> String {
    let lines = lines(&drawn(scene, theme, size).1);
    let trimmed = lines.iter().map(|line| line.trim_end().to_owned() + "\n");
    trimmed.collect()
}

#[test]
fn every_view_names_its_axes_once() {
    for view in ChartView::ALL {
        let scene = scene(view);
        for theme in [Theme::new(false), ascii()] {
            let text = text(&scene, theme, [44, 21]);
            for panel in &scene.panels {
                assert_eq!(text.matches(&heading(panel)).count(), 1, "{view:?}\n{text}");
            }
            let hertz = usize::from(view != ChartView::Nyquist);
            assert_eq!(text.matches("Hz").count(), hertz, "{view:?}\n{text}");
            assert_eq!(text.is_ascii(), theme == ascii());
        }
    }
}

#[test]
fn frequencies_are_shown_in_their_unit_and_returned_in_hertz() {
    for unit in FrequencyUnit::SHOWN {
        for view in [ChartView::Magnitude, ChartView::MagnitudePhase] {
            let mut scene = scene(view);
            scene.frequency.unit = unit;
            let (drawn, buffer) = drawn(&scene, Theme::new(false), [60, 21]);
            let plot = drawn.plot.unwrap();
            assert_eq!(plot.frequencies.len(), usize::from(plot.area.width));
            // The outermost dots are at 1 and 100 Hz, which gives the width of a column in hertz.
            let wide = 2.0 * 99.0 / f64::from(2 * plot.area.width - 1);
            for (column, frequency) in (0_u16..).zip(&plot.frequencies) {
                let expected = (1.0 + wide * (f64::from(column) + 0.25)).min(100.0);
                assert!(
                    (frequency - expected).abs() < 1e-9,
                    "{frequency} {expected}"
                );
            }
            // The cursor is at 30 Hz.
            let lines = lines(&buffer);
            let foot = lines
                .iter()
                .find_map(|line| line.chars().position(|c| c == '▲'));
            let column = foot.unwrap() - usize::from(plot.area.x);
            assert!((plot.frequencies[column] - 30.0).abs() <= wide / 2.0 + 1e-9);
            assert!(lines.concat().contains(unit.symbol()));
        }
    }
}

#[test]
fn the_levels_are_those_of_the_upper_axis() {
    // The highest value is 20, the lowest 1 / (1 - 100 / 9) or about 0.1: whole decades are 0.01 to 100.
    let (magnitude, _) = drawn(
        &scene(ChartView::MagnitudePhase),
        Theme::new(false),
        [44, 21],
    );
    let levels = magnitude.levels.unwrap();
    assert!(levels.log);
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
    near(levels.bounds[0], 0.01);
    near(levels.bounds[1], 100.0);
    let mut fixed = scene(ChartView::RealImaginary);
    fixed.panels[0].bounds = Some([-7.0, 7.5]);
    let levels = drawn(&fixed, Theme::new(false), [44, 21]).0.levels.unwrap();
    assert_eq!((levels.bounds, levels.log), ([-7.0, 7.5], false));
    let (nyquist, _) = drawn(&scene(ChartView::Nyquist), Theme::new(false), [44, 21]);
    assert_eq!(nyquist, Drawn::default());
}

#[test]
fn curves_that_are_not_drawn_count_for_the_bounds() {
    let mut scene = scene(ChartView::RealImaginary);
    let bounds = |scene: &Scene| {
        let (drawn, _) = drawn(scene, Theme::new(false), [44, 21]);
        drawn.levels.unwrap().bounds
    };
    // The real part is 10 at most and -10 at least, where the frequency is off by half the bandwidth.
    assert_eq!(bounds(&scene), [-10.0, 10.0]);
    let mut higher = scene.curves[0].clone();
    higher.values[0].fill(33.0);
    scene.spanning.push(higher);
    assert_eq!(bounds(&scene), [-10.0, 40.0]);
}

#[test]
fn two_panels_are_one_plot_for_the_mouse() {
    let (drawn, buffer) = drawn(
        &scene(ChartView::MagnitudePhase),
        Theme::new(false),
        [44, 21],
    );
    let plot = drawn.plot.unwrap();
    let lines = lines(&buffer);
    let labelled = |label: &str| lines.iter().position(|line| line.contains(label)).unwrap();
    // From the upper plot's first row to the row above the axis of the lower one.
    assert_eq!(usize::from(plot.area.y), labelled("|H|, m/N") + 1);
    assert_eq!(usize::from(plot.area.bottom()), labelled("▲"));
}

#[test]
fn measured_points_differ_from_the_model_without_colour() {
    let mut scene = scene(ChartView::Magnitude);
    scene.marks = Marked::default();
    let sparse: Vec<f64> = (1..=19).map(|k| 5.0 * f64::from(k)).collect();
    scene
        .curves
        .push(curve(ChartView::Magnitude, CurveKind::Measured, sparse));
    for (theme, sign) in [(Theme::new(false), '◇'), (ascii(), 'M')] {
        let text = text(&scene, theme, [60, 20]);
        assert_eq!(text.matches(sign).count(), 19, "{text}");
    }
    // With as many points as columns, the curve is a line with a few markers.
    scene.curves[1] = curve(ChartView::Magnitude, CurveKind::Measured, frequencies());
    let text = text(&scene, Theme::new(false), [60, 20]);
    let signs = text.matches('◇').count();
    assert!((1..=4).contains(&signs), "{text}");
}

#[test]
fn a_reference_is_dotted_and_dim() {
    let mut scene = scene(ChartView::Magnitude);
    scene.curves.insert(
        0,
        SceneCurve {
            label: "before".to_owned(),
            line: LineStyle::Dotted,
            dim: true,
            ..curve(ChartView::Magnitude, CurveKind::Reference, frequencies())
        },
    );
    for values in &mut scene.curves[0].values {
        for value in values {
            *value *= 0.5;
        }
    }
    let (_, buffer) = drawn(&scene, Theme::new(false), [60, 20]);
    let text = lines(&buffer).concat();
    assert!(text.contains("┈┈┈ before"), "{text}");
    let is_dots = |cell: &&ratatui::buffer::Cell| {
        ('⠁'..='⣿').contains(&cell.symbol().chars().next().unwrap())
    };
    let curves: Vec<_> = buffer.content().iter().filter(is_dots).collect();
    let dim = curves
        .iter()
        .filter(|cell| cell.modifier.contains(Modifier::DIM));
    let count = dim.count();
    assert!(count > 20 && count < curves.len() - 20, "{count}");
}

#[test]
fn a_nyquist_plot_shows_the_band_the_modes_and_the_cursor() {
    let mut scene = scene(ChartView::Nyquist);
    let at = |frequency: f64| {
        let value = receptance(frequency);
        (value.re, value.im)
    };
    scene.curves[0].at_cursor = Some(vec![at(29.0).0, at(29.0).1]);
    scene.marks.modes = vec![30.0, 400.0];
    let size = [60, 24];
    let (_, buffer) = drawn(&scene, Theme::new(false), size);
    let text = lines(&buffer).concat();
    assert_eq!(text.matches('◆').count(), 1, "{text}");
    // At the resonance the value is -20 i: the lowest point, with the mode's number.
    let rows = lines(&buffer);
    let low = rows
        .iter()
        .rposition(|row| row.contains(['⠤', '⠒', '⠉', '⣀']))
        .unwrap();
    assert!(rows[low].contains('1'), "{}", rows.join("\n"));
    // A band without the resonance has a smaller circle.
    scene.frequency.bounds = [1.0, 20.0];
    scene.curves[0].at_cursor = None;
    let text = self::text(&scene, Theme::new(false), size);
    assert!(!text.contains("-20"), "{text}");
}

#[test]
fn no_size_and_no_scene_is_too_small() {
    for view in ChartView::ALL {
        let full = scene(view);
        let mut bare = full.clone();
        bare.curves[0].frequencies.clear();
        let mut short = full.clone();
        short.curves[0].values.clear();
        let mut panels = full.clone();
        panels.panels.clear();
        for scene in [full, bare, short, panels] {
            for width in (0..50).step_by(3) {
                for height in 0..26 {
                    drawn(&scene, Theme::new(true), [width, height]);
                }
            }
        }
    }
}

#[test]
fn pictures() {
    let mut marked = scene(ChartView::RealImaginary);
    marked.frequency.log = true;
    marked.marks = Marked {
        cursor: Some(20.0),
        second: Some(30.0),
        harmonics: vec![40.0, 60.0, 80.0, 100.0],
        band: Some([10.0, 50.0]),
        modes: vec![30.0],
        ..Marked::default()
    };
    // Golden.
    insta::assert_snapshot!(text(&marked, Theme::new(false), [44, 21]), @r"
    Re, m/N
     10┤                    ╎    │  ⢀⡇ 2 ╎ 3 4 5
       │                    ╎    │  ⢸⡇ ┊ ╎ ┊ ┊ ┊
       ├                    ╎    │ ⣠⠏⡇ ┊ ╎ ┊ ┊ ┊
       │⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠤⠖⠒⠒⠋⠁ ⡇ ┊ ╎ ┊ ┊ ┊
      0┤┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈╎┈┈┈┈│┈┈┈⡇⢀⡴⠒⠋⠉⠉⠉⠉⠉⠉
       ├                    ╎    │   ⡇⡞┊ ╎ ┊ ┊ ┊
       │                    ╎    │   ⢱⠃┊ ╎ ┊ ┊ ┊
    -10┤                    ╎    │   ⢸ ┊ ╎ ┊ ┊ ┊
       └┬─────┬──┴──┴─┬┴┴─┴┴┯━━━━┼━━━┼━┷━┯─┴┴┴┴┬
    Im, m/N
      0┤⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠑⢦⢀⡞⠉⠉⠉⠉⠉⠉⠉⠉⠉
       │                    ╎    │  ⠸⣼ ┊ ╎ ┊ ┊ ┊
       │                    ╎    │   ⣿ ┊ ╎ ┊ ┊ ┊
    -10┤                    ╎    │   ⣿ ┊ ╎ ┊ ┊ ┊
       │                    ╎    │   ⣿ ┊ ╎ ┊ ┊ ┊
       │                    ╎    │   ⣿ ┊ ╎ ┊ ┊ ┊
    -20┤                    ╎    │   ⡇ ┊ ╎ ┊ ┊ ┊
       └┬─────┬──┴──┴─┬┴┴─┴┴┯━━━━▲━━━△━┷━┯─┴┴┴┴┬
        1     2       5     10   20      50   Hz
                                     ╵
    ");
    insta::assert_snapshot!(text(&marked, ascii(), [44, 21]), @r"
    Re, m/N
     10+                    [    |  ** 2 ] 3 4 5
       |                    [    |  ** ' ] ' ' '
       -                    [    | *** ' ] ' ' '
       |**************************** * ' ] ' ' '
      0+- - - - - - - - - - [ - -|- -***********
       -                    [    |   **' ] ' ' '
       |                    [    |   * ' ] ' ' '
    -10+                    [    |   * ' ] ' ' '
       ++-----+--|--|-+||-||#====|===:===#-||||+
    Im, m/N
      0+****************************************
       |                    [    |  ** ' ] ' ' '
       |                    [    |  ** ' ] ' ' '
    -10+                    [    |   * ' ] ' ' '
       |                    [    |   * ' ] ' ' '
       |                    [    |   * ' ] ' ' '
    -20+                    [    |   * ' ] ' ' '
       ++-----+--|--|-+||-||#====^===A===#-||||+
        1     2       5     10   20      50   Hz
                                     '
    ");
    let mut circle = scene(ChartView::Nyquist);
    let value = receptance(28.0);
    circle.curves[0].at_cursor = Some(vec![value.re, value.im]);
    insta::assert_snapshot!(text(&circle, Theme::new(false), [44, 21]), @r"
    Im, m/N
       │                    ┊
      0┤┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈⣀⣀⡤⠤⠤┼⠤⢤⣀⣀┈┈┈┈┈┈┈┈┈┈┈┈┈┈┈
       │           ⢀⠤⠒⠉⠁    ┊   ⠈⠉⠒⢤⡀
       │         ⡠⠚⠁        ┊       ⠈◆⢄
       │       ⢀⠞⠁          ┊          ⠳⡄
     -5┤      ⢠⠃            ┊           ⠙⡄
       │     ⢀⠇             ┊            ⠸⡀
       │     ⡜              ┊             ⢇
       │     ⡇              ┊             ⢸
    -10┤     ⡇              ┊             ⢸
       │     ⢣              ┊             ⡞
       │     ⠘⡄             ┊            ⢰⠁
    -15┤      ⠘⡄            ┊           ⡠⠃
       │       ⠈⠦⡀          ┊         ⢀⠔⠁
       │         ⠑⠤⡀        ┊       ⢀⠤⠊
       │           ⠈⠑⠦⣀⡀    ┊   ⢀⡠⠤⠊⠁
    -20┤               ⠈⠉⠉⠒⠒1⠒⠉⠉⠁
       │                    ┊
       └─────┬──────┬───────┬──────┬──────┬─────
            -10     -5      0      5     Re, m/N
    ");
}

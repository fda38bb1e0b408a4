use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;

use super::plane::Reserve;
use super::*;
use crate::model::{Span, Spring, Target};
use crate::presets;
use crate::tui::ascii;
use crate::tui::options::{Marker, Options};
use crate::tui::panels::beam_view::animated::stage::{at, preset, theme};

fn plain_ascii() -> Theme {
    theme(Options {
        ascii: Some(true),
        ..Options::default()
    })
}

fn buffer(app: &App, theme: Theme, width: u16, height: u16) -> Buffer {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
    terminal
        .draw(|frame| draw(frame, app, theme, frame.area()))
        .unwrap();
    terminal.backend().buffer().clone()
}

fn lines(buffer: &Buffer) -> Vec<String> {
    let rows = buffer.content.chunks(usize::from(buffer.area.width));
    rows.map(|row| row.iter().map(ratatui::buffer::Cell::symbol).collect())
        .collect()
}

fn screen(model: Model, node: Node, [width, height]: [u16; 2]) -> String {
    lines(&buffer(&at(model, node), Theme::new(false), width, height)).join("\n")
}

/// The position of a sign: column and row.
fn find(screen: &str, sign: char) -> Vec<(usize, usize)> {
    let rows = screen.lines().enumerate().skip(1);
    rows.flat_map(|(row, line)| {
        let signs = line.chars().enumerate().filter(move |(_, c)| *c == sign);
        signs.map(move |(column, _)| (column, row))
    })
    .collect()
}

/// Golden: the picture was checked by eye.
#[test]
fn a_wide_panel() {
    let expected = "\
─ Section at S2 ───────────────────── z_c 61.9 mm, mounts y ±130 mm, z -55 mm 
↑z mm                   dots: radii of gyration 120 mm along y, 109 mm along z
    │                                      ⡀⠄⠄⠄⠄⡀                             
 100┤                                    ⡐⠁      ⠢                            
    │                                    ⡂   ×C  ⠨                            
   0┤                                    ⠐⠄  +S ⡀⠌                            
    │                      │╱╲╱╲╱╲╱╲╱╲╱╱○  ⠁⠂⠂⠂⠁  ○╲╱╲╱│                      
-100┤                      │         ╱╲          ╱     │                      
    │                      │      ╲╱╲            ╲     │                      
-200┤                      └────L╱━━━━━━━━━━━■━━R──────┘                      
    └─┴───┬──┴───┬──┴───┬──┴───┬──┴───┬───┴──┬───┴──┬───┴──┬───┴──┬───┴──┬───┴
         1000   800    600    400    200     0     -200   -400   -600    ←y mm";
    assert_eq!(
        screen(preset("fig05a"), Node::Group(Group::Subsystem(1)), [78, 12]),
        expected
    );
}

/// Golden: the picture was checked by eye.
#[test]
fn a_narrow_panel_in_ascii() {
    let app = at(
        preset("fig05a"),
        Node::Group(Group::Support(crate::model::SupportId::Left)),
    );
    let mut buffer = buffer(&app, plain_ascii(), 44, 10);
    ascii::flatten(&mut buffer);
    let expected = "\
- Section at S1 --------------- z_c 61.9 mm 
    |^z mm         .....     dots: sqrt(I/A)
    -             .  xC .                   
   0+             .  +S .                   
    |       |/\\/\\o .....o/\\/\\/\\/\\/\\/|       
    -       |     /       \\/        |       
-200+       |     \\         \\/      |       
    |       +------L=#========\\R----+       
    +---+-|--|--|-|--+--|-|--|--|-+--|--|-|-
       500           0           -500 <-y mm";
    assert_eq!(lines(&buffer).join("\n"), expected);
}

/// Without axes and surroundings: 21 x 11 cells hold +-0.1 m each way, so a column is 0.2 m / 20 and a row twice that.
#[test]
fn a_row_is_worth_two_columns() {
    let mut extent = Extent::default();
    extent.take(-0.1, -0.1);
    extent.take(0.1, 0.1);
    extent.take(f64::NAN, f64::INFINITY);
    let plane = Plane::new(&extent, Reserve::default(), [21, 11]);
    assert!((plane.metres_per_column() - 0.01).abs() < 1e-15);
    assert_eq!(plane.cell(0.0, 0.0), [10, 5]);
    // y to the left, z upward.
    assert_eq!(plane.cell(0.1, 0.0), [0, 5]);
    assert_eq!(plane.cell(-0.1, 0.1), [20, 0]);
    assert_eq!(plane.cell(0.04, -0.04), [6, 7]);
    // Wider than high: the width decides; the rest of the height, 9 - 5 rows, is shared by top and bottom.
    extent.take(0.3, 0.0);
    let plane = Plane::new(&extent, Reserve::default(), [21, 10]);
    assert!((plane.metres_per_column() - 0.02).abs() < 1e-15);
    assert_eq!(plane.cell(0.3, 0.1), [0, 2]);
    assert_eq!(plane.cell(0.0, -0.1), [15, 7]);
}

/// Moments of area are A r^2: an area of 1 m2 with `I_y` = 0.09 m4 and `I_z` = 0.0025 m4 has 0.3 m along y, the
/// direction of w that `I_y` resists, and 0.05 m along z.
#[test]
fn the_radii_are_those_of_bending_along_their_axes() {
    let section = Section {
        area: 1.0,
        second_moment_y: 0.09,
        second_moment_z: 0.0025,
        torsion_constant: 1e-4,
        polar_moment: 0.2,
        ..Section::default()
    };
    let [y, z] = radii(&section);
    assert!((y - 0.3).abs() < 1e-15 && (z - 0.05).abs() < 1e-15);
    let mut model = preset("semicircular_cantilever");
    model.beam.section = Section {
        centroid_offset: 0.1,
        ..section
    };
    // 73 columns next to the axis: 72 steps for 0.6 m; a row is twice as much.
    let screen = screen(model, Node::Group(Group::Sweep), [78, 24]);
    let dots: Vec<(usize, usize)> = ('\u{2801}'..='\u{28ff}')
        .flat_map(|dot| find(&screen, dot))
        .collect();
    let columns = dots.iter().map(|(column, _)| *column);
    let rows = dots.iter().map(|(_, row)| *row);
    let wide = columns.clone().max().unwrap() - columns.min().unwrap();
    let high = rows.clone().max().unwrap() - rows.min().unwrap();
    let scale = 0.6 / 72.0;
    assert!((wide as f64 - 0.6 / scale).abs() <= 1.0, "{wide}\n{screen}");
    assert!(
        (high as f64 - 0.1 / scale / 2.0).abs() <= 1.0,
        "{high}\n{screen}"
    );
}

/// S at the origin, C above it by `z_c`, mounts at either side in one row: differences of rows and columns by the
/// scale, each rounded to a cell.
#[test]
fn points_are_to_scale() {
    let model = preset("fig05a");
    let app = at(model, Node::Group(Group::Subsystem(0)));
    let parts = app.model().uniform_parts();
    let picture = Picture::new(
        &parts[0],
        app.model().subsystems.first(),
        Theme::new(false),
        Rect::new(0, 0, 78, 23),
    );
    let scale = picture.plane.metres_per_column();
    let screen = lines(&buffer(&app, Theme::new(false), 78, 24)).join("\n");
    let one = |sign| {
        let [one] = find(&screen, sign)[..] else {
            panic!("{sign} in\n{screen}");
        };
        one
    };
    let (shear, centroid) = (one('+'), one('×'));
    assert_eq!(shear.0, centroid.0);
    let rows = |z: f64| z / scale / 2.0;
    let columns = |y: f64| y / scale;
    let near = |cells: usize, exact: f64| (cells as f64 - exact).abs() <= 1.0;
    assert!(near(shear.1 - centroid.1, rows(0.0619)), "{screen}");
    let mounts = find(&screen, '○');
    let [left, right] = mounts[..] else {
        panic!("{mounts:?} in\n{screen}");
    };
    assert!(
        left.1 == right.1 && near(left.1 - shear.1, rows(0.055)),
        "{screen}"
    );
    assert!(near(right.0 - left.0, columns(0.26)), "{screen}");
    assert!(near(shear.0 - left.0, columns(0.13)), "{screen}");
    // The left arm is 80 mm to the left, the right one 360 mm to the right, in the bar's row.
    let letters = |sign, row| find(&screen, sign).into_iter().find(|at| at.1 == row);
    let mass = one('■');
    let (l, r) = (letters('L', mass.1).unwrap(), letters('R', mass.1).unwrap());
    assert_eq!(mass.0, shear.0);
    assert!(
        near(mass.0 - l.0, columns(0.08)) && near(r.0 - mass.0, columns(0.36)),
        "{screen}"
    );
    assert!(
        screen.contains("L 80 mm") && screen.contains("R 360 mm"),
        "{screen}"
    );
}

#[test]
fn labels_of_the_axes_stand_at_their_values() {
    let app = at(preset("fig05a"), Node::Group(Group::Subsystem(0)));
    let screen = lines(&buffer(&app, Theme::new(false), 78, 24)).join("\n");
    let rows: Vec<&str> = screen.lines().collect();
    let [shear] = find(&screen, '+')[..] else {
        panic!("{screen}");
    };
    // z = 0 in the row of S, y = 0 in its column.
    assert!(rows[shear.1].starts_with("   0┤"), "{screen}");
    let zero: Vec<char> = rows[23].chars().collect();
    assert_eq!(zero[shear.0 - 1..=shear.0 + 1], [' ', '0', ' '], "{screen}");
    assert_eq!(rows[22].chars().nth(shear.0), Some('┬'), "{screen}");
    assert!(rows[23].ends_with("←y mm") && rows[1].starts_with("↑z mm"));
}

#[test]
fn only_springs_that_are_there_are_drawn() {
    let mut model = preset("fig05a");
    let one = &mut model.subsystems[0];
    (one.y_left, one.y_right) = (Spring::default(), Spring::default());
    (one.z_left, one.z_right) = (Spring::default(), Spring::default());
    let count = |model: &Model| {
        let screen = screen(model.clone(), Node::Group(Group::Subsystem(0)), [78, 24]);
        let signs = |signs: [char; 2]| signs.map(|sign| find(&screen, sign).len()).iter().sum();
        let springs: usize = signs(['╱', '╲']);
        (
            springs > 0,
            find(&screen, '╫').len(),
            find(&screen, '○').len(),
        )
    };
    assert_eq!(count(&model), (false, 0, 0));
    model.subsystems[0].z_left.damping = 1.0;
    assert_eq!(count(&model), (false, 1, 1));
    model.subsystems[0].y_right.stiffness = 1.0;
    assert_eq!(count(&model), (true, 1, 2));
}

#[test]
fn nothing_degenerates() {
    let mut model = preset("fig05a");
    model.beam.section.centroid_offset = 0.0;
    let symmetric = screen(model.clone(), Node::Group(Group::Subsystem(0)), [44, 20]);
    assert!(symmetric.contains("+SC"), "{symmetric}");
    let one = &mut model.subsystems[0];
    (one.mount_y, one.mount_z, one.arm_left, one.arm_right) = (0.0, 0.0, 0.0, 0.0);
    let folded = screen(model.clone(), Node::Group(Group::Subsystem(0)), [44, 20]);
    assert!(folded.contains("+SC") && folded.contains("L■R"), "{folded}");
    assert!(folded.contains("z_c 0 mm"), "{folded}");
    // Mounts and arms may cross the axis.
    let one = &mut model.subsystems[0];
    (one.mount_y, one.arm_left, one.arm_right) = (-0.13, -0.2, -0.1);
    let crossed = screen(model.clone(), Node::Group(Group::Subsystem(0)), [44, 20]);
    let letters = ['R', '■', 'L'].map(|letter| find(&crossed, letter)[0].0);
    assert!(letters.is_sorted(), "{crossed}");
    // Sections of any possible size.
    for factor in [1e-56, 1e-9, 1e9, 1e56] {
        let mut model = model.clone();
        model.beam.section.second_moment_y *= factor;
        let screen = screen(model, Node::Group(Group::Subsystem(0)), [44, 20]);
        assert!(screen.contains('S'), "{factor}\n{screen}");
    }
}

#[test]
fn the_selected_subsystem_is_shown_else_the_first_one_attached() {
    let mut model = preset("fig05a");
    model.subsystems[0].enabled = false;
    let heading = |model: &Model, node| {
        let screen = screen(model.clone(), node, [78, 12]);
        screen.lines().next().unwrap().to_owned()
    };
    assert!(heading(&model, Node::Group(Group::Sweep)).contains("Section at S2 "));
    assert!(heading(&model, Node::Group(Group::Subsystem(0))).contains("Section at S1, off "));
    assert!(
        heading(&model, Node::Parameter(Group::Subsystem(2).parameter(3)))
            .contains("Section at S3 ")
    );
    model.forces[0].target = Target::Mass("S3".to_owned(), crate::model::MassMotion::Y);
    assert!(
        heading(&model, Node::Parameter(Group::Force(0).parameter(1))).contains("Section at S3 ")
    );
    model.subsystems.clear();
    model.forces.truncate(0);
    assert!(heading(&model, Node::Group(Group::Sweep)).contains("─ Section ─"));
}

/// The section is that of the span at the subsystem; its shear centre is off the axis by the offset, to scale.
#[test]
fn a_span_has_its_section_and_offset() {
    let mut model = preset("fig05a");
    let (y, z) = (0.1, -0.05);
    let span = |offset| Span {
        length: 1.6,
        offset,
        ..Span::default()
    };
    model.spans = vec![span(Point::AXIS), span(Point { y, z })];
    let parts = model.uniform_parts();
    let picture = Picture::new(
        &parts[1],
        Some(&model.subsystems[2]),
        Theme::new(false),
        Rect::new(0, 0, 78, 23),
    );
    let scale = picture.plane.metres_per_column();
    let drawn = screen(model.clone(), Node::Group(Group::Subsystem(2)), [78, 24]);
    assert!(drawn.contains("Section of span 2 at S3 "), "{drawn}");
    assert!(
        drawn.contains(" offset y 100, z -50 mm, z_c 61.9 mm "),
        "{drawn}"
    );
    assert!(drawn.contains("┼O") && drawn.contains("+S"), "{drawn}");
    let [axis, shear] = ['┼', '+'].map(|sign| find(&drawn, sign)[0]);
    let near = |from: usize, to: usize, cells: f64| (to as f64 - from as f64 - cells).abs() <= 1.0;
    assert!(near(shear.0, axis.0, y / scale), "{drawn}");
    assert!(near(axis.1, shear.1, -z / scale / 2.0), "{drawn}");
    // Without an offset, the shear centre is on the axis.
    let first = screen(model.clone(), Node::Group(Group::Subsystem(0)), [78, 24]);
    assert!(first.contains("Section of span 1 at S1 "), "{first}");
    assert!(!first.contains(['┼', 'O']), "{first}");
    let ascii = buffer(
        &at(model, Node::Group(Group::Subsystem(2))),
        plain_ascii(),
        78,
        24,
    );
    assert!(lines(&ascii).join("\n").contains("*O"));
}

#[test]
fn millimetres_have_three_digits() {
    let cases = [
        (0.0619, "61.9"),
        (-0.055, "-55"),
        (0.13, "130"),
        (0.0, "0"),
        (1.234_56, "1230"),
        (1e-9, "1e-6"),
        (1e9, "1e12"),
    ];
    for (metres, text) in cases {
        assert_eq!(millimetres(metres), text);
    }
}

#[test]
fn every_panel_can_be_drawn() {
    let marked = |marker| {
        theme(Options {
            marker: Some(marker),
            ..Options::default()
        })
    };
    let themes = [
        marked(Marker::Braille),
        marked(Marker::Block),
        marked(Marker::Dot),
        marked(Marker::Ascii),
        plain_ascii(),
    ];
    let sizes = || (1..=40).flat_map(|width| (1..=14).map(move |height| (width, height)));
    let larger = [(44, 10), (44, 20), (78, 12), (78, 24), (200, 60), (300, 3)];
    for embedded in presets::ALL {
        let app = at(preset(embedded.name), Node::Group(Group::Beam));
        for theme in themes {
            for (width, height) in sizes().chain(larger) {
                let mut drawn = buffer(&app, theme, width, height);
                let rows = lines(&drawn);
                if theme.is_ascii() {
                    assert!(rows[1..].iter().all(|row| row.is_ascii()), "{rows:#?}");
                    ascii::flatten(&mut drawn);
                    assert!(!lines(&drawn)[0].contains('?'), "{rows:#?}");
                }
                if width >= 20 && height >= 4 {
                    assert!(rows.join("").contains('S'), "{rows:#?}");
                }
            }
        }
    }
}

use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use ratatui::style::Modifier;

use super::*;
use crate::designer::driver::thousand;
use crate::model::{
    BeamMotion, Elastic, Force, Joint, Link, MassMotion, Point, Quantity, Restraint, Section, Span,
    Spring, Support, Target,
};
use crate::presets;
use crate::tui::ascii;
use crate::tui::options::{Marker, Options};
use crate::tui::panels::beam_view::animated::stage::{app, at, preset, theme};

fn themes() -> [Theme; 5] {
    let marked = |marker| {
        theme(Options {
            marker: Some(marker),
            ..Options::default()
        })
    };
    [
        marked(Marker::Braille),
        marked(Marker::Block),
        marked(Marker::Dot),
        marked(Marker::Ascii),
        plain_ascii(),
    ]
}

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

fn screen(app: &App, width: u16, height: u16) -> String {
    lines(&buffer(app, Theme::new(false), width, height)).join("\n")
}

/// The columns of a sign in a row of the screen.
fn columns(buffer: &Buffer, row: u16, sign: &str) -> Vec<u16> {
    (0..buffer.area.width)
        .filter(|column| buffer[(*column, row)].symbol() == sign)
        .collect()
}

fn reversed(buffer: &Buffer) -> String {
    let cells = buffer.content.iter();
    cells
        .filter(|cell| cell.modifier.contains(Modifier::REVERSED))
        .map(ratatui::buffer::Cell::symbol)
        .collect()
}

/// Golden: the picture was checked by eye.
#[test]
fn a_narrow_panel() {
    let app = at(preset("fig05a"), Node::Group(Group::Subsystem(1)));
    let expected = "\
─ Structure ─────────── S2 at 1.6 m, 100 kg 
   w 1 N, psi 1 N m, v 1 N                  
   ↑T⊙        w psi v  w psi v       w psi v
   ◆═════════════◆════════◆═════════════◆   
   ╱╫      ╱ ╲       ╱ ╲      ╱ ╲      ╫╱   
   ╲│     y╲ ╱z     y╲ ╱z    y╲ ╱z     │╲   
  ▔▔▔      [S1]     [>S2]     [S3]     ▔▔▔  
          100 kg    100 kg   100 kg         
   ┬─────┬─────┬────┬─────┬─────┬─────┬──   
   0    0.5    1   1.5    2    2.5    3    m";
    assert_eq!(screen(&app, 44, 10), expected);
}

/// Golden: the picture was checked by eye.
#[test]
fn a_wide_panel() {
    let app = at(preset("fig05a"), Node::Group(Group::Force(1)));
    let expected = "\
─ Structure ───────────────────────────────────── force 2: psi at left, 1 N m 
   psi 1 N m                                                                  
  >T↑⊙                                                                        
   ◆══════════════════════════◆════════════════◆══════════════════════════◆   
   ╱╫ w psi v       ╱ ╲    w psi v    ╱ ╲   w psi v    ╱ ╲       w psi v ╫╱   
   ╲│              y╲ ╱z             y╲ ╱z            y╲ ╱z              │╲   
  ▔▔▔             ┌──────┐          ┌──────┐         ┌──────┐            ▔▔▔  
  w v sprung      │  S1  │          │  S2  │         │  S3  │     w v sprung  
                  │100 kg│          │100 kg│         │100 kg│                 
                  └──────┘          └──────┘         └──────┘                 
   ┬─┴─┴──┴─┴─┬─┴──┴─┴─┴─┬─┴──┴─┴─┴─┬──┴─┴─┴─┴─┬──┴─┴─┴─┴─┬──┴─┴─┴─┴──┬─┴─┴   
   0         0.5         1         1.5         2         2.5          3      m";
    assert_eq!(screen(&app, 78, 12), expected);
}

/// The columns of positions and of round values: 3 columns of margin, then 72 of the beam, so x is at 3 + round(71 x /
/// 3.2 m).
#[test]
fn signs_are_to_scale() {
    let buffer = buffer(&app(preset("fig05a")), Theme::new(false), 78, 12);
    let column = |x: f64| 3 + (71.0 * x / 3.2).round() as u16;
    assert_eq!(columns(&buffer, 3, "◆"), [0.0, 1.2, 2.0, 3.2].map(column));
    // The y springs are left of a subsystem's position, the z springs right of it; the supports' at the ends.
    let zigzag = [columns(&buffer, 4, "╱"), columns(&buffer, 4, "╲")];
    let [s1, s2, s3] = [0.8, 1.6, 2.4].map(column);
    assert_eq!(
        zigzag[0],
        [column(0.0), s1 - 1, s2 - 1, s3 - 1, column(3.2)]
    );
    assert_eq!(zigzag[1], [s1 + 1, s2 + 1, s3 + 1]);
    let ticks = [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0].map(column);
    assert_eq!(columns(&buffer, 10, "┬"), ticks);
}

/// A beam of three spans: half of the depth of the second one, all of it, and half of it on one level with its upper
/// surface. The depth of a rectangle is sqrt(12 I/A): 0.1 m and 0.2 m.
fn stepped() -> Model {
    let mut model = preset("fig05a");
    let section = |depth: f64| Section {
        area: 0.01,
        second_moment_y: 0.01 * depth * depth / 12.0,
        ..model.beam.section
    };
    let span = |length, depth, y| Span {
        length,
        offset: Point { y, z: 0.0 },
        section: Some(section(depth)),
        ..Span::default()
    };
    model.spans = vec![
        span(1.2, 0.1, 0.0),
        span(1.2, 0.2, 0.0),
        span(0.8, 0.1, 0.05),
    ];
    model
}

/// Golden: the pictures were checked by eye.
#[test]
fn spans_have_their_depths_and_offsets() {
    let app = at(stepped(), Node::Group(Group::Subsystem(1)));
    let rows = |theme, [width, height]: [u16; 2], rows: Range<usize>| {
        lines(&buffer(&app, theme, width, height))[rows].join("\n")
    };
    let narrow = "   ↑T⊙           ┌─────────────┬────────┐   \n   \
        ◆═════════════◆╌╌╌╌╌╌╌╌◆╌╌╌╌├────────◆   \n   \
        ╱╫      ╱ ╲   └─────────────┘╲      ╫╱   ";
    assert_eq!(rows(Theme::new(false), [44, 11], 3..6), narrow);
    let ascii = "   ^To           +-------------+--------+   \n   \
        *=============*........*....+--------*   \n   \
        /H      / \\   +-------------+\\      H/   ";
    assert_eq!(rows(plain_ascii(), [44, 11], 3..6), ascii);
    let wide = "   ↑T⊙                        ┌───────────────────────────┬─────────────────┐   
   ┌──────────────────────────┤                           │                 │   
   ◆╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌◆╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌╌◆╌╌╌╌╌╌╌╌├─────────────────◆   
   └──────────────────────────┤                           │╲       w psi v ╫╱   
   ╱╫ w psi v       ╱ ╲       └───────────────────────────┘╱               │╲   ";
    assert_eq!(rows(Theme::new(false), [80, 19], 3..8), wide);
    // Without room for its depth it is one line, with a sign where two spans meet.
    let low = rows(Theme::new(false), [44, 6], 2..3);
    assert_eq!(low, "   ◆═════════════◆════════◆════┼════════◆   ");
}

#[test]
fn spans_of_one_depth_are_one_line() {
    let mut model = stepped();
    for span in &mut model.spans {
        (span.section, span.offset) = (None, Point::AXIS);
    }
    let picture = screen(&at(model, Node::Group(Group::Beam)), 80, 19);
    assert!(
        picture.contains("◆══════════════════◆════════┼═════════════════◆"),
        "{picture}"
    );
    assert!(
        picture.contains("3.2 m, 3 spans, 3 subsystems"),
        "{picture}"
    );
    assert!(!picture.contains("axis"), "{picture}");
}

/// The axis, and with it all that is on it, may lie outside of a span.
#[test]
fn a_span_far_off_the_axis_is_joined_to_it() {
    let mut model = stepped();
    model.spans[2].offset.y = 0.5;
    model.supports.right = Support::PINNED;
    let picture = screen(&at(model, Node::Group(Group::Sweep)), 80, 19);
    let rows: Vec<Vec<char>> = picture.lines().map(|row| row.chars().collect()).collect();
    let end = 76;
    let column: String = rows.iter().map(|row| row[end]).collect();
    assert!(column.contains("┐││◆▲▔"), "{picture}");
}

fn elastic(stiffness: f64, damping: f64, inertia: f64) -> Restraint {
    Restraint::Elastic(Elastic {
        spring: Spring {
            stiffness,
            damping,
            ..Spring::default()
        },
        inertia,
    })
}

/// The left end on a panel of 78 x 12: from the row above the beam to the first one of the words.
fn left_end(support: Support) -> Vec<String> {
    let mut model = preset("symmetric_section");
    model.supports.left = support;
    let app = at(model, Node::Group(Group::Sweep));
    let buffer = buffer(&app, Theme::new(false), 78, 12);
    let lines = lines(&buffer);
    let rows = lines[2..8].iter();
    rows.map(|row| {
        row.chars()
            .take(12)
            .collect::<String>()
            .trim_end()
            .to_owned()
    })
    .collect()
}

#[test]
fn an_end_shows_what_holds_it() {
    let (clamped, pinned) = (left_end(Support::CLAMPED), left_end(Support::PINNED));
    assert_eq!(clamped, ["  ▒", "  ▒═════════", "  ▒", "", "  clamped", ""]);
    assert_eq!(
        pinned,
        ["", "   ═════════", "   ▲", "  ▔▔▔", "  pinned", ""]
    );
    let free = left_end(Support::FREE);
    assert_eq!(free, ["", "   ═════════", "", "", "  free", ""]);

    let mut support = Support::FREE;
    support[BeamMotion::Psi] = Restraint::Fixed;
    // Without w there is no sign, but the text names the support.
    let held = left_end(support.clone());
    assert_eq!(held, ["", "   ═════════", "", "", "  psi held", ""]);
    support[BeamMotion::W] = elastic(1e6, 0.0, 0.0);
    let sprung = left_end(support.clone());
    assert_eq!(sprung[2..], ["   ╱", "   ╲", "  ▔▔▔", "  psi held"]);
    support[BeamMotion::W] = elastic(1e6, 2.0, 3.0);
    let damped = left_end(support.clone());
    assert_eq!(damped[2..], ["  ■╱╫", "   ╲│", "  ▔▔▔", "  psi held"]);
    support[BeamMotion::W] = elastic(0.0, 2.0, 0.0);
    let damper = left_end(support.clone());
    assert_eq!(damper[2..], ["   ╫", "   │", "  ▔▔▔", "  psi held"]);
    // A mass alone is not connected to the ground.
    support[BeamMotion::W] = elastic(0.0, 0.0, 3.0);
    let mass = left_end(support.clone());
    assert_eq!(mass[2..], ["  ■", "", "  psi held", "  w sprung"]);
}

#[test]
fn forces_have_their_signs() {
    let mut model = preset("symmetric_section");
    model.responses.clear();
    let force = |motion, amplitude, phase| Force {
        enabled: true,
        target: Target::Beam(Place::Position(0.0), motion),
        amplitude,
        phase,
        point: crate::model::Point::AXIS,
    };
    let cases = [
        (BeamMotion::W, 1.0, 0.0, "↑", "^", "1 N"),
        (BeamMotion::W, -1.0, 0.0, "↓", "v", "-1 N"),
        (BeamMotion::W, 1.0, 180.0, "↓", "v", "1 N"),
        (BeamMotion::W, 1.0, 90.0, "↑", "^", "1 N"),
        (BeamMotion::V, 1.0, 0.0, "⊙", "o", "1 N"),
        (BeamMotion::V, 1.0, 180.0, "⊗", "x", "1 N"),
        (BeamMotion::Psi, 2.0, 0.0, "T", "T", "2 N m"),
        (BeamMotion::WSlope, 2.0, 0.0, "↺", "M", "2 N m"),
        (BeamMotion::PsiSlope, 2.0, 0.0, "B", "B", "2 N m2"),
    ];
    for (motion, amplitude, phase, sign, ascii_sign, words) in cases {
        model.forces = vec![force(motion, amplitude, phase)];
        let app = at(model.clone(), Node::Group(Group::Sweep));
        let unicode = buffer(&app, Theme::new(false), 78, 12);
        assert_eq!(
            unicode[(3, 2)].symbol(),
            sign,
            "{motion:?} {amplitude} {phase}"
        );
        assert_eq!(lines(&unicode)[1].trim(), words);
        let ascii = buffer(&app, plain_ascii(), 78, 12);
        assert_eq!(ascii[(3, 2)].symbol(), ascii_sign);
    }
    // A disabled one is labelled and dim.
    model.forces = vec![Force {
        enabled: false,
        ..force(BeamMotion::W, 1.0, 0.0)
    }];
    let buffer = buffer(
        &at(model, Node::Group(Group::Sweep)),
        Theme::new(false),
        78,
        12,
    );
    assert_eq!(lines(&buffer)[1].trim(), "off");
    assert!(buffer[(3, 2)].modifier.contains(Modifier::DIM));
}

/// Forces and responses of a mass are in its box, and the selected one is marked there.
#[test]
fn a_mass_shows_what_acts_on_it() {
    let mut model = preset("fig05a");
    let of_s2 = |motion| Target::Mass("S2".to_owned(), motion);
    model.forces[0].target = of_s2(MassMotion::Y);
    model.forces[1].target = of_s2(MassMotion::Theta);
    let selected = |node| screen(&at(model.clone(), node), 78, 12);
    assert!(
        selected(Node::Group(Group::Sweep)).contains("│S2 ↑T"),
        "{}",
        selected(Node::Group(Group::Sweep))
    );
    let marked = selected(Node::Group(Group::Force(1)));
    assert!(marked.contains("║S2 ↑>T"), "{marked}");
    assert!(marked.contains("force 2: theta of S2, 1 N m"), "{marked}");
}

#[test]
fn what_is_not_attached_is_outlined() {
    let mut model = preset("fig05a");
    model.subsystems[0].enabled = false;
    let app = at(model, Node::Group(Group::Sweep));
    let wide = buffer(&app, Theme::new(false), 78, 12);
    assert!(lines(&wide)[6].contains("┌╌╌╌╌╌╌┐          ┌──────┐"));
    let [corner] = columns(&wide, 7, "╎")[..1] else {
        panic!("no dashed box");
    };
    assert!(wide[(corner, 7)].modifier.contains(Modifier::DIM));
    assert!(screen(&app, 44, 10).contains("(S1)      [S2]"));
}

#[test]
fn a_joint_is_a_sign_on_the_beam() {
    let mut model = preset("fig05a");
    let joint = |position, link| {
        let mut joint = Joint {
            position,
            ..Joint::default()
        };
        joint[BeamMotion::WSlope] = link;
        joint
    };
    let coupling = Link::Elastic(Spring {
        stiffness: 1e5,
        ..Spring::default()
    });
    model.joints = vec![joint(0.4, Link::Free), joint(2.8, coupling)];
    let app = at(model, Node::Group(Group::Joint(0)));
    let picture = screen(&app, 78, 24);
    assert!(picture.contains(">○") && picture.contains('◎'), "{picture}");
    assert!(
        picture.contains("joint 1 at 0.4 m: w_slope free"),
        "{picture}"
    );
    assert!(picture.contains("○ hinge") && picture.contains("◎ coupling"));
}

/// Without colour the selection is reversed and has a pointer; without modifiers only the pointer.
#[test]
fn what_is_selected_stands_out() {
    let chosen = [
        (Node::Group(Group::Beam), "><", "3.2 m, 3 subsystems"),
        (
            Node::Group(Group::Support(SupportId::Left)),
            ">╱╫╲│",
            "left end: w v sprung",
        ),
        (
            Node::Group(Group::Support(SupportId::Right)),
            "<╫╱│╲",
            "right end: w v sprung",
        ),
        (
            Node::Group(Group::Subsystem(0)),
            "╱╲",
            "S1 at 0.8 m, 100 kg",
        ),
        (
            Node::Group(Group::Force(0)),
            ">↑",
            "force 1: w at left, 1 N",
        ),
        (Node::Group(Group::Response(3)), ">◆", "P2 w: w at 1.2 m"),
    ];
    let nothing = screen(&at(preset("fig05a"), Node::Group(Group::Sweep)), 78, 12);
    assert!(!nothing.contains(['>', '<']), "{nothing}");
    for (node, signs, note) in chosen {
        for (width, height) in [(44, 10), (78, 12), (78, 24)] {
            let app = at(preset("fig05a"), node);
            let buffer = buffer(&app, Theme::new(false), width, height);
            let screen = lines(&buffer).join("\n");
            assert!(screen.contains(['>', '<']), "{node:?}\n{screen}");
            assert!(screen.contains(note), "{node:?}\n{screen}");
            if (width, height) == (78, 12) {
                let reversed = reversed(&buffer);
                assert!(reversed.starts_with(signs), "{node:?} {reversed}");
            }
        }
    }
}

#[test]
fn rows_below_a_group_belong_to_it() {
    let mut model = preset("fig05a");
    let path = crate::model::path::parameter(&model, "subsystems.S2.mass");
    assert!(path.is_ok());
    let app = at(
        model.clone(),
        Node::Parameter(Group::Subsystem(1).parameter(3)),
    );
    assert!(screen(&app, 78, 12).contains("║ >S2  ║"));
    // A response of the whole beam has no position.
    model.responses[0].quantity = Quantity::Energy;
    let energy = screen(&at(model, Node::Group(Group::Response(0))), 78, 12);
    assert!(energy.contains("P1 w: energy") && !energy.contains(['>', '<']));
}

#[test]
fn a_thousand_subsystems_become_ticks() {
    let many = buffer(
        &at(thousand(), Node::Group(Group::Sweep)),
        Theme::new(false),
        78,
        12,
    );
    // 72 columns of the beam less two at either end, which the supports take.
    assert_eq!(columns(&many, 4, "╷").len(), 72 - 4);
    let screen = lines(&many).join("\n");
    assert!(screen.contains("─ 1,000 masses ─"), "{screen}");
    let chosen = buffer(
        &at(thousand(), Node::Group(Group::Subsystem(500))),
        Theme::new(false),
        78,
        12,
    );
    // 3.2 m x 500 / 999, on the scale above.
    let column = 3 + (71.0_f64 * 500.0 / 999.0).round() as u16;
    assert_eq!(columns(&chosen, 4, "┃"), [column]);
    let screen = lines(&chosen).join("\n");
    // 999 steps over 71 columns: 14 or 15 in each.
    assert!(screen.contains("║>S501 +13║"), "{screen}");
    assert!(screen.contains("S501 at 1.6016 m, 100 kg"), "{screen}");
    assert!(reversed(&chosen).contains("┃┃╔"));
}

#[test]
fn subsystems_that_are_too_close_share_a_bracket() {
    let mut model = preset("fig05a");
    model.subsystems[1].position = 0.9;
    let screen =
        |model: &Model, width| screen(&at(model.clone(), Node::Group(Group::Sweep)), width, 12);
    // 21 and 23: names have no room.
    let bracket = screen(&model, 78);
    assert!(bracket.contains(" 2 masses "), "{bracket}");
    model.subsystems[1].position = 1.0;
    // 21 and 25: ticks with their names.
    let named = screen(&model, 78);
    assert!(named.contains("S1  S2"), "{named}");
    // In one column they share one box.
    model.subsystems[1].position = 0.8;
    let one = screen(&model, 78);
    assert!(one.contains("S1 +1"), "{one}");
}

#[test]
fn every_panel_can_be_drawn() {
    let nodes = [
        Node::Group(Group::Beam),
        Node::Group(Group::Sweep),
        Node::Group(Group::Support(SupportId::Right)),
        Node::Group(Group::Subsystem(0)),
        Node::Group(Group::Force(0)),
        Node::Group(Group::Response(0)),
    ];
    let sizes = || (1..=24).flat_map(|width| (1..=14).map(move |height| (width, height)));
    let larger = [(44, 10), (44, 20), (78, 12), (78, 24), (200, 60), (300, 3)];
    for embedded in presets::ALL {
        for (number, theme) in themes().into_iter().enumerate() {
            let model = preset(embedded.name);
            let node = nodes[number];
            let there = crate::tui::tree::all_rows(&model)
                .iter()
                .any(|row| row.node == node);
            let app = at(
                model,
                if there {
                    node
                } else {
                    Node::Group(Group::Beam)
                },
            );
            for (width, height) in sizes().chain(larger) {
                let drawn = buffer(&app, theme, width, height);
                inside_is_ascii(&drawn, theme);
            }
        }
    }
    let spans = at(stepped(), Node::Group(Group::Beam));
    for (width, height) in sizes().chain(larger) {
        inside_is_ascii(&buffer(&spans, plain_ascii(), width, height), plain_ascii());
        buffer(
            &at(thousand(), Node::Group(Group::Subsystem(999))),
            plain_ascii(),
            width,
            height,
        );
    }
}

/// Below the rule, nothing needs to be replaced for an ASCII terminal.
fn inside_is_ascii(drawn: &Buffer, theme: Theme) {
    if !theme.is_ascii() {
        return;
    }
    let rows = lines(drawn);
    // The ellipsis of a cut text is replaced.
    let strange = rows[1..].iter().flat_map(|row| row.chars());
    let strange: Vec<char> = strange.filter(|c| !c.is_ascii() && *c != '…').collect();
    assert!(strange.is_empty(), "{strange:?} in {rows:#?}");
    let mut flat = drawn.clone();
    ascii::flatten(&mut flat);
    let rule = &lines(&flat)[0];
    assert!(rule.is_ascii() && !rule.contains('?'), "{rule}");
}

#[test]
fn rows_are_shared_by_what_matters() {
    let [flat, deep] = [preset("fig05a"), stepped()].map(|model| {
        let parts = model.uniform_parts();
        Profile::of(&parts)
    });
    for (height, profile) in (1..60).flat_map(|height| [(height, &flat), (height, &deep)]) {
        let rows = Rows::of(height, profile);
        let last = [Some(rows.depth[1]), rows.ruler, rows.numbers, rows.key];
        let last = last.into_iter().flatten().max().unwrap();
        assert!(last < height, "{rows:?}");
        assert!(rows.below_boxes() <= height, "{rows:?}");
        assert_eq!(rows.springs > 0, height > 1);
    }
    for profile in [flat, deep] {
        let rows = Rows::of(3, &profile);
        assert_eq!(rows.depth, [0, 0]);
        assert_eq!(
            (rows.beam, rows.springs, rows.boxes, rows.forces),
            (0, 1, 1, false)
        );
    }
}

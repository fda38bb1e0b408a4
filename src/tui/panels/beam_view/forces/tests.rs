use super::*;
use crate::tui::panels::beam_view::animated::stage::{self, looking, pinned, preset, screen};

/// The row of the plot that has a mark in a column.
fn row_at(lines: &[String], column: usize) -> Vec<usize> {
    let drawn = |line: &String| {
        line.chars()
            .nth(column)
            .is_some_and(|c| ('⠁'..='⣿').contains(&c))
    };
    (2..lines.len()).filter(|row| drawn(&lines[*row])).collect()
}

#[test]
fn a_slow_force_has_the_moments_and_shears_of_a_still_one() {
    // Closed form: M = F L / 4 = 0.8 N m in the middle, negative for a bulge to +y; S = F / 2 left of it, -F / 2 right.
    let app = looking(pinned(0.0), 0.01, BeamView::Moments);
    let lines = screen(&app, Theme::new(false), draw, [80, 16]);
    assert!(
        lines[0].contains("Bending moments at 0.01 Hz, phase 0 deg"),
        "{lines:#?}"
    );
    assert!(
        lines[0].ends_with("|M_w| to 0.800 N m at 1.60 m"),
        "{lines:#?}"
    );
    assert_eq!(lines[1].trim(), "N m");
    let app = looking(pinned(0.0), 0.01, BeamView::Shear);
    let lines = screen(&app, Theme::new(false), draw, [80, 16]);
    assert!(lines[0].contains("|S_w| to 0.500 N at"), "{lines:#?}");
    assert_eq!(lines[1].trim(), "N");
}

#[test]
fn the_forces_at_the_moment_of_the_widest_deflection() {
    let app = looking(pinned(0.0), 0.01, BeamView::Shear);
    let seen = Seen {
        model: app.model(),
        operating: app.beam_view.operating().unwrap(),
        at: "",
        angle: 0.0,
        stale: false,
        theme: Theme::new(false),
    };
    // Closed form, as above.
    let shear = Member::new(seen, "S_w", 0);
    assert!((shear.now[1] - 0.5).abs() < 1e-6, "{}", shear.now[1]);
    assert!((shear.now[shear.now.len() - 2] + 0.5).abs() < 1e-6);
    assert!((shear.bounds[0][1] - 0.5).abs() < 1e-6 && (shear.bounds[1][1] + 0.5).abs() < 1e-6);
    let lines = screen(&app, Theme::new(false), draw, [80, 16]);
    // It falls from one to the other in the middle column: 9 rows from 0.5 to -0.5.
    assert!(row_at(&lines, 42).len() >= 9, "{lines:#?}");
    assert!(!lines[2].contains("S_v"), "{lines:#?}");
}

#[test]
fn each_look_has_its_forces_and_unit() {
    for (look, unit, names) in [
        (BeamView::Moments, "N m", "M_w M_v"),
        (BeamView::Shear, "N", "S_w S_v"),
        (BeamView::Torque, "N m", "T"),
        (BeamView::Bimoment, "N m2", "B"),
    ] {
        let app = looking(preset("fig05b"), 35.0, look);
        let lines = screen(&app, Theme::new(false), draw, [60, 12]);
        assert_eq!(lines[1].trim(), unit);
        for name in names.split(' ') {
            assert!(lines[2].contains(name), "{lines:#?}");
        }
        stage::draws_at_any_size(draw, look);
    }
}
